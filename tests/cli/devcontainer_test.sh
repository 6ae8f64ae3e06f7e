#!/bin/sh
# devcontainer_test.sh ROOT
# The image of .devcontainer gets the packages of groups that exist, and every one that a verb needs.
set -eu
cd "$1"
wrong() { echo "WRONG: $1" >&2; exit 1; }
groups=$(sed -n 's/.*\/^(\([a-z|]*\)) \/.*/\1/p' .devcontainer/Dockerfile | tr '|' ' ')
[ -n "$groups" ] || wrong ".devcontainer/Dockerfile names no package groups"
for group in $groups; do
  grep -q "^$group " framework/cli/packages.txt || wrong "there is no package group '$group'"
done
needed=$(sed -n 's/^CS550_[A-Z]* *([a-z]*, *"[a-z]*", *"\([^"]*\)".*/\1/p' framework/cli/verbs.def | tr -d '?')
[ -n "$needed" ] || wrong "no verb needs a package"
for group in $needed debug; do
  case " $groups " in *" $group "*) ;; *) wrong "group '$group', which a verb needs, is missing" ;; esac
done
if grep -q '"cppdbg"' .vscode/launch.json && ! grep -q ms-vscode.cpptools .devcontainer/devcontainer.json; then
  wrong "devcontainer.json lacks ms-vscode.cpptools, whose debugger .vscode/launch.json starts"
fi
