#!/bin/sh
# Compiler launcher: runs the compiler. If it fails, writes an empty object file and succeeds, so that
# one lab that does not compile cannot block the others.
"$@" && exit 0

while [ $# -gt 1 ]; do
  [ "$1" != -o ] || exec as /dev/null -o "$2"
  shift
done
exit 1
