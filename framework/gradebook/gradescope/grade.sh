#!/bin/sh
# grade.sh SUBMISSION RESULTS: grades one submission and writes the results as Gradescope reads them.
set -eu
graded=$(mktemp -d)
trap 'rm -rf "$graded"' EXIT
# Gradescope adds up points of labs; milestones have none.
set -- "$1" "$2" --out "$graded/out" --labs "$(cat labs.txt)" --no-milestones
[ ! -e course.toml ] || set -- "$@" --course course.toml
submission=$1 results=$2
shift 2
CS550_ROOT=$PWD build/test/bin/cs550_grade "$submission" "$@"
set -- "$graded"/out/gradescope/*.json
cp "$1" "$results"
