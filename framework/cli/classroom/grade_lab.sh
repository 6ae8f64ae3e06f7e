#!/bin/sh
# grade_lab.sh N: a step of the workflow for GitHub Classroom. Grades lab N and passes the result on to the step that
# reports points: as JSON, in base64, in the file that the runner names. A lab that fails does not fail the step.
set -eu
lab=$1
cd "$(dirname "$0")/../../.."
rm -f "build/results/lab$lab.json"
./cs550 lab "$lab" || echo "Lab $lab is not finished."
python3 framework/cli/classroom/result.py "$lab" "build/results/lab$lab.json" tests/lab"$lab"_*/manifest.json |
  base64 -w 0 | sed 's/^/result=/' >>"$GITHUB_OUTPUT"
echo >>"$GITHUB_OUTPUT"
