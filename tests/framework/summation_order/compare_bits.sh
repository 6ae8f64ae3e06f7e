#!/bin/sh
# Two programs must print the same line, which is not empty.
set -eu
first=$("$1")
second=$("$2")
echo "with vector code $first, without $second"
[ -n "$first" ] && [ "$first" = "$second" ]
