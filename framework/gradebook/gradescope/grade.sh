#!/bin/sh
# grade.sh SUBMISSION RESULTS [METADATA]: grades one submission and writes the results as Gradescope reads them.
# METADATA is Gradescope's submission_metadata.json, which has the time of submission and the student.
set -eu
graded=$(mktemp -d)
trap 'rm -rf "$graded"' EXIT
# Gradescope adds up points of labs; milestones have none.
submission=$1 results=$2 metadata=${3-}
set -- --judge build/test/bin/grade_lab --out "$graded/out" --labs "$(cat labs.txt)" --no-milestones
[ ! -e course.toml ] || set -- "$@" --course course.toml
[ ! -e roster.csv ] || set -- "$@" --roster roster.csv
[ ! -e "$metadata" ] || set -- "$@" --gradescope-metadata "$metadata"
# 1: the grader failed on something. Its result says so, unless there is none.
CS550_ROOT=$PWD build/test/bin/cs550_grade "$submission" "$@" || [ $? = 1 ]
set -- "$graded"/out/gradescope/*.json
[ $# = 1 ] || { echo "grade.sh: $submission has $# submissions, and only one can be graded" >&2; exit 1; }
cp "$1" "$results"
