#!/bin/bash
# figure_test.sh PROGRAM SCRATCH: draws one figure for a slide, as docs/instructors.md types it. Exit code 77 if the
# program is not built, or was built before its source changed.
set -eu
program=$1 scratch=$2
[ "$program" -nt "$(dirname "$0")/../../docs/figures/main.cpp" ] || exit 77
wrong() { echo "WRONG: $1" >&2; exit 1; }
rm -rf "$scratch"
mkdir -p "$scratch"
cd "$scratch"
"$program" --figures slides --only gauss_map
[ "$(ls slides)" = gauss_map.svg ] || wrong "expected gauss_map.svg alone, found: $(ls slides)"
! "$program" --figures slides --only gaus_map 2>message || wrong "a figure that does not exist was drawn"
grep -q "no figure or table has the name 'gaus_map'" message || wrong "the figure is not named: $(cat message)"
# In a students' copy: the reason in place of a plot whose table could not be measured.
"$program" --unwritten "not implemented: L7.4" --output slides/plot.svg
grep -q "not implemented: L7.4" slides/plot.svg || wrong "the figure does not show why it is not drawn"
