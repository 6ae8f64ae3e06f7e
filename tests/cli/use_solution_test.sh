#!/bin/sh
# use_solution_test.sh PROGRAM ROOT SCRATCH
# `lab N --use-solution` copies a released solution in, keeps the student's files, and leaves them alone where
# the solution is not released.
set -eu
program=$1 root=$2 copy=$3
rm -rf "$copy"
mkdir -p "$copy/solutions" "$copy/.starters" "$copy/tests"
cp -r "$root/labs" "$copy"
cp -r "$root"/labs/lab* "$copy/.starters"
cp -r "$root"/solutions/lab5_clipping "$copy/solutions"
for lab in "$root"/tests/lab*; do mkdir "$copy/tests/${lab##*/}"; done
export CS550_ROOT="$copy"

wrong() { echo "WRONG: $1" >&2; exit 1; }
lab5=$copy/labs/lab5_clipping
echo '// mine' >>"$lab5/clipping.cpp"
cp "$lab5/clipping.cpp" "$copy/mine.cpp"

"$program" lab 5 --use-solution | grep -qF labs/lab5_clipping/clipping.cpp.bak-1 || wrong "it must name the backup"
cmp "$lab5/clipping.cpp.bak-1" "$copy/mine.cpp" || wrong "the backup is not the student's file"
for file in "$root"/solutions/lab5_clipping/*.?pp; do cmp "$file" "$lab5/${file##*/}"; done
"$program" lab 5 --use-solution | grep -qF "nothing was changed" || wrong "a second call must change nothing"
"$program" lab 5 --reset >/dev/null
for file in "$lab5"/*.?pp; do cmp "$file" "$copy/.starters/lab5_clipping/${file##*/}"; done

! "$program" lab 4 --use-solution 2>"$copy/printed" || wrong "lab 4 has no solution here"
grep -qF "solutions/lab4_separating_axis is missing" "$copy/printed" || wrong "it must name the missing folder"
cmp "$root"/labs/lab4_*/separating_axis.cpp "$copy"/labs/lab4_*/separating_axis.cpp
rm -rf "$copy"
