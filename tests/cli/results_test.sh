#!/bin/sh
# results_test.sh PROGRAM ROOT SCRATCH
# Results of labs in a students' copy: an earlier lab that fails by itself is named first, no result is older
# than what it was made from, a lab that does not compile has 0 points, and --run has exit codes. Nothing is
# compiled: fake_copy.py stands in for the build and for all programs.
set -eu
program=$1 root=$2 copy=$3
rm -rf "$copy"
mkdir -p "$copy/framework/assets" "$copy/.starters" "$copy/build/results" "$copy/bin"
cp -r "$root/labs" "$copy"
cp -r "$root"/labs/lab* "$copy/.starters"
cp -r "$root/framework/assets/trajectories" "$copy/framework/assets"
for lab in "$root"/tests/lab*; do
  mkdir -p "$copy/tests/${lab##*/}"
  cp "$lab"/*.json "$copy/tests/${lab##*/}"
done
cp "$root/tests/cli/fake_copy.py" "$copy/cs550"
ln -s ../cs550 "$copy/bin/gdb"
printf '#!/bin/sh\necho another program\n' >"$copy/bin/rsvg-convert"
chmod +x "$copy/cs550" "$copy/bin/rsvg-convert"
export CS550_ROOT="$copy" PATH="$copy/bin:$PATH"

wrong() { echo "WRONG: $1" >&2; cat "$copy/printed" >&2; exit 1; }
# runs CODE VERB...: the exit code must be CODE.
runs() {
  expected=$1 code=0
  shift
  "$program" "$@" >"$copy/printed" 2>&1 </dev/null || code=$?
  [ $code = "$expected" ] || wrong "'$*' exited with code $code, expected $expected"
}
prints() { grep -qF -- "$1" "$copy/printed" || wrong "expected: $1"; }
prints_not() { ! grep -qF -- "$1" "$copy/printed" || wrong "not expected: $1"; }
points() { prints "$(printf '%-27s' "$1")"; grep -F "$1" "$copy/printed" | grep -qF " $2  " || wrong "expected: $1 $2"; }
remembers() { grep -qF -- "$2" "$copy/build/results/lab$1.json" || { cat "$copy/build/results/lab$1.json"; wrong "lab$1.json: $2"; }; }
lab3=$copy/labs/lab3_hill_climbing/hill_climbing.cpp
for lab in 1_integration 2_half_edge_mesh 3_hill_climbing 4_separating_axis; do
  for file in "$copy/labs/lab$lab"/*.cpp; do echo "// mine" >"$file"; done
done

echo "An earlier lab that fails by itself comes first:"
runs 0 lab 4
prints "48 of 48 points"
prints_not "itself"
echo "// WRONG" >"$lab3"
runs 1 lab 4
prints "Lab 3 itself fails L3.1: fix that first. (./cs550 lab 3)"
prints "Fix L3.1 first. Other reports"
prints_not "Fix L4"
runs 0 lab 4 --hint
prints "Lab 3 itself fails L3.1"
prints "L3.1 "
prints_not "L4"
runs 1 lab 4 --step L4.2
prints "Lab 3 itself fails L3.1"
for step in L4.1 l4.1 4.1; do
  runs 0 lab 4 --step $step
  prints "L4.1 "
  prints_not "itself"
done

echo "Mending it mends the results of the labs that call it:"
runs 0 progress
points "Lab 3: hill climbing" "0/48"
points "Lab 4: separating axis" "18/48"
prints "Next: L3.1"
echo "// mended" >"$lab3"
runs 0 progress
points "Lab 3: hill climbing" "48/48"
points "Lab 4: separating axis" "48/48"
mkdir "${lab3%/*}/parts"
for header in "${lab3%/*}/helper.h" "${lab3%/*}/parts/helper.hpp"; do
  echo "// WRONG" >"$header"
  runs 0 progress
  points "Lab 3: hill climbing" "0/48"
  points "Lab 4: separating axis" "18/48"
  rm "$header"
  runs 0 progress
  points "Lab 4: separating axis" "48/48"
done

echo "A lab that does not compile has 0 points, with the reason:"
echo "// NO_CODE" >"$lab3"
for verb in "progress" "lab 3"; do
  code=1
  [ "$verb" = "lab 3" ] || code=0
  rm -f "$copy/build/results/lab3.json"
  runs $code $verb
  remembers 3 '"earned": 0'
  remembers 3 "labs/lab.cpp:7:1: error: expected ';'"
done
runs 0 progress
points "Lab 3: hill climbing" "0/48"
prints "does not compile"
prints "error: expected ';'"
runs 1 lab 3 --hint
prints "error: expected ';'"
runs 1 lab 4
prints "Lab 3 itself does not compile: fix that first."
prints "blocked by lab 3, which does not compile"
prints_not "blocked by L3"
prints "Fix lab 3 first."
runs 1 lab 4 --hint
prints "Lab 3 itself does not compile"
echo "// mended" >"$lab3"
runs 0 lab 3
remembers 3 '"compile_error": ""'
remembers 3 '"earned": 48'

echo "A lab without a .cpp file has 0 points, too:"
mv "$lab3" "$copy/kept"
for verb in "progress" "lab 3" "lab 3 --asan" "lab 3 --run"; do
  code=1
  [ "$verb" = "progress" ] && code=0
  runs $code $verb
  prints "labs/lab3_hill_climbing has no .cpp file. ./cs550 lab 3 --reset"
  remembers 3 "has no .cpp file"
done
runs 0 progress
points "Your engine, assembled" "2/7"
prints "Next: Lab 3: hill climbing has no code"
prints_not "does not compile"
runs 1 lab 3 --hint
prints "Lab 3: hill climbing has no code:"
mv "$copy/kept" "$lab3"
runs 0 lab 3

echo "The counts of a challenge are kept as long as they are of the same code:"
runs 0 lab 3 --challenge
prints "yours 42"
remembers 3 '"count": 42'
runs 0 lab 3
remembers 3 '"count": 42'
for backup in "$lab3~" "${lab3%/*}/#hill_climbing.cpp#"; do
  echo "// what an editor keeps" >"$backup"
  runs 0 lab 3
  remembers 3 '"count": 42'
  rm "$backup"
done
echo "// mended again" >"$lab3"
runs 0 lab 3
remembers 3 '"challenge": []'
echo "// PRINTS" >"$lab3"
runs 1 lab 3 --challenge
prints "your code prints while it is counted; remove its output:"

echo "A file that is saved while its lab is built is graded again:"
for verb in "progress" "lab 3"; do
  echo "// SAVED_MEANWHILE" >"$lab3"
  runs 0 $verb
  prints "48"
  runs 0 progress
  points "Lab 3: hill climbing" "0/48"
done

echo "A build that takes long shows its progress, and its warnings are printed once:"
echo "// LONG_CODE" >"$lab3"
rm "$copy/build/results/lab3.json"
runs 0 progress
prints "Building lab3_student [1/2]"
runs 0 lab 3
prints "labs/lab.cpp:0:1: warning: unused 'x'"
prints "labs/lab.cpp:2:1: warning"
prints "and 2 more; build/student.log has all of them"
prints_not "$copy/labs"
prints_not "labs/lab.cpp:3:1: warning"
echo "// mended" >"$lab3"
runs 0 lab 3
prints_not warning

echo "A picture is of the last failure:"
name=Lab3.BruteForceFindsTheMostExtremeVertex
picture=$copy/build/results/pictures/$name.svg
rm -f "$copy/build/results/advised_png"
echo "// WRONG" >"$lab3"
runs 1 lab 3
prints "./cs550 view --failure $name"
prints "./cs550 doctor --install picture also saves pictures as PNG."
[ -s "$picture" ] || wrong "there is no picture"
echo "// CRASH" >"$lab3"
runs 1 lab 3
prints_not "view --failure"
[ ! -e "$picture" ] || wrong "the picture of an earlier failure is left"
echo "// WRONG" >"$lab3"
runs 1 lab 3
prints_not "also saves pictures as PNG"
echo "// mended" >"$lab3"
runs 0 lab 3
[ -z "$(ls "${picture%/*}")" ] || wrong "pictures are left: $(ls "${picture%/*}")"

echo "A list of pictures fits on a screen:"
for number in $(seq 10 39); do : >"${picture%/*}/Lab3.Test$number.svg"; done
for arguments in "--failure" "--failure Lab3.Absent"; do
  runs 2 view $arguments
  prints "Lab3.Test29"
  prints "and 10 more"
  [ "$(wc -l <"$copy/printed")" -le 24 ] || wrong "the list is longer than a screen"
done
rm "${picture%/*}"/Lab3.Test*.svg
runs 2 view --failure
prints "./cs550 lab N draws one where a picture helps"

echo "--debug opens the failure of the last run without repeating it:"
echo "// WRONG" >"$lab3"
runs 1 lab 3
runs 1 lab 3 --debug
prints "GDB lab3_debugged"
prints "Ctrl-C shows where it"
prints_not "of 48 points"
echo "// WRONG in another way" >"$lab3"
runs 1 lab 3 --debug
prints "0 of 48 points"
prints "GDB lab3_debugged"
echo "// mended" >"$lab3"
runs 0 lab 3

echo "A full disk is no fault of the engine, nor of a lab:"
: >"$copy/disk_is_full"
runs 0 progress
prints "Your engine, assembled     not known, because it was not built:"
prints "No space left on device"
echo "// edited" >"$lab3"
runs 0 progress
points "Lab 3: hill climbing" "0/48"
prints "Next: Lab 3: hill climbing was not built"
prints_not "does not compile"
runs 1 lab 3 --hint
prints "Lab 3: hill climbing was not built:"
prints "No space left on device"
rm "$copy/disk_is_full"
runs 0 progress
points "Your engine, assembled" "4/7"

echo "progress limits the output of the engine, too:"
runs 0 progress
points "Your engine, assembled" "4/7"
echo "// FLOOD" >"$lab3"
runs 0 progress
points "Your engine, assembled" "2/7"
echo "// mended" >"$lab3"
runs 0 lab 3

echo "--run has the exit code of the engine:"
for option in "" --asan --debug; do
  runs 0 lab 3 --run $option
  prints_not GDB
done
prints "There is nothing to debug."
echo "// WRONG" >"$lab3"
for option in "" --asan; do
  runs 1 lab 3 --run $option
  prints_not GDB
done
runs 1 lab 3 --run --debug
prints "GDB milestones_debugged"
runs 0 lab 2 --run
prints "Your own engine, labs 1 to 2"
! grep -qE '^.{81}' "$copy/printed" || wrong "a line has more than 80 columns"
runs 0 lab 1 --run
prints "Your own engine, lab 1"
echo "// CRASH" >"$lab3"
runs 1 lab 3 --run
prints "a scene"
prints "not reached: crashed: Aborted"
prints "try  ./cs550 lab 3 --run --asan"
echo "// ENDLESS" >"$lab3"
for option in "" --debug; do
  CS550_ENGINE_SECONDS=24 runs 1 lab 3 --run $option
  prints "not reached: stopped: it made no step for 2 s"
  prints "try  ./cs550 lab 3 --run --asan  which prints the line"
done
prints GDB
echo "// SLOW" >"$lab3"
CS550_ENGINE_SECONDS=360 runs 0 lab 3 --run
(code=0; "$program" lab 3 --run >"$copy/first" 2>&1 </dev/null || code=$?; echo "exit $code" >>"$copy/first") &
until ls "$copy"/build/results/draft.engine_pulse.* >/dev/null 2>&1; do sleep 0.05; done
echo "// mended" >"$lab3"
runs 0 lab 3 --run
wait
grep -qF "exit 0" "$copy/first" || wrong "a second run broke the first one: $(cat "$copy/first")"
[ -z "$(find "$copy/build/results" -name 'draft.*')" ] || wrong "it left drafts"
echo "// SLOW" >"$lab3"
CS550_ENGINE_SECONDS=2 runs 1 lab 3 --run
prints "not reached: stopped: it"
rm -rf "$copy"
