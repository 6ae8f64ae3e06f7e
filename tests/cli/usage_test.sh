#!/bin/sh
# usage_test.sh PROGRAM ROOT SCRATCH
# A wrong command line exits with code 2, prints a message of at most 80 columns, and leaves no file. The
# folder's long name makes a message too long if it holds the whole path instead of what was typed.
set -eu
program=$1 root=$2 scratch=$3
unset CS550_BUILD_DIR  # in which the launcher would make links to the project
rm -rf "$scratch"
folder=$scratch/a_folder_with_a_name_that_alone_fills_most_of_a_line/out
mkdir -p "$folder"
cd "$folder"

wrong() { echo "WRONG: $1" >&2; cat "$scratch/printed" >&2; exit 1; }
refuses() {
  code=0
  CS550_ROOT=$root "$program" "$@" >"$scratch/printed" 2>&1 </dev/null || code=$?
  [ $code = 2 ] || wrong "'$*' exited with code $code, expected 2"
  [ -s "$scratch/printed" ] || wrong "'$*' printed nothing"
  # A path that alone is longer than a line stands on a line of its own.
  ! grep -E '^.{81}' "$scratch/printed" | grep -q ' ' || wrong "'$*' printed a line of more than 80 columns"
  [ -z "$(ls -A .)" ] || wrong "'$*' left $(ls -A .)"
}
# The length of the path decides where a message is broken into lines.
prints() { tr '\n' ' ' <"$scratch/printed" | grep -qF -- "$1" || wrong "expected in the message: $1"; }

refuses lab
prints "N is missing: number of the lab (3, lab3 or L3) Usage: ./cs550 lab [OPTIONS] N"
refuses lab three
prints "there is no lab three"
prints "Lab 1: integration"
refuses lab 99
prints "cs550: there is no lab 99. The labs:"
prints "Lab 1: integration"
# Other spellings of a lab's number: the message is that of lab 3.
for lab in 3 03 lab3 Lab3 LAB3 L3 l3; do
  refuses lab "$lab" --step L4.1
  prints "cs550: lab 3 has no step L4.1"
  refuses submit "$lab" --out .
  prints ". is a folder"
done
for lab in L lab 3x L3.1 0 L0 -3 +3 lab-3 00000000000000000003; do
  refuses lab "$lab"
  prints "cs550: there is no lab $lab. The labs:"
done
refuses lab 3 --stpe L3.1
prints "there is no option --stpe. Did you mean --step?"
refuses lab --stpe=L3.1 3
prints "there is no option --stpe. Did you mean --step?"
refuses lab --stpe L3.1 3  # in which L3.1 is taken for the lab
prints "there is no option --stpe. Did you mean --step?"
refuses lab 3 --use
prints "Did you mean --use-solution?"
# A guess must not lead to the loss of the student's files.
for typed in --test --solution --list; do
  refuses lab 5 $typed NAME
  ! grep -q "mean" "$scratch/printed" || wrong "no option is like $typed"
done
refuses lab 5 --rseet
prints "Did you mean --reset?"
refuses lab 3 --fast
prints "there is no option --fast. Usage: ./cs550 lab [OPTIONS] N"
refuses lab 3 L3.1 more
prints "these arguments are not expected: L3.1 more Usage: ./cs550 lab [OPTIONS] N"
refuses lab 3 -- x y
prints "these arguments are not expected: x y Usage: ./cs550 lab [OPTIONS] N"
refuses lab 3 L3.1 -- x
prints "these arguments are not expected: L3.1 x Usage"
refuses lab 3 -- --hint
prints "this argument is not expected: --hint"
refuses lab 3 --step
prints "--step needs a value: --step STEP"
refuses lab 3 --step --hint
prints "--step needs a value: --step STEP"
refuses submit 3 --out --force
prints "--out needs a value: --out FILE"
refuses lab 3 --step L3.1 --step L3.2
prints "--step can be given only once"
refuses lab 3 --step l3.9
prints "lab 3 has no step L3.9"
refuses lab 3 --step L4.1
prints "L3.1"
refuses lab 3 --hint 9
prints "--hint needs a whole number from 1 to 3, found 9"
refuses lab 3 --reset --run
prints "--reset and --run cannot be used together"
refuses lab 3 --asan --debug
refuses lab 3 --run --step L3.1
refuses lab 3 --use-solution --run
refuses lab 3 --challenge --step L3.1
refuses submit three
prints "Lab 1: integration"
refuses submit 0
prints "Lab 1: integration"
refuses submit 3 --out .
prints "is a folder"
refuses submit 3 --out absent/lab3.zip
prints "there is no folder"
long=$(printf 'x%.0s' $(seq 300))
for path in "" "$long" "$long/a"; do
  refuses submit 3 --out "$path"
  prints "--out: expected "
  refuses starter "$path"
  prints "DIR: expected "
done
prints "302 letters"
# What the viewer would refuse is refused before it is built.
for arguments in "--camera=bad" "--camera 1,2,3,4" "--snapshot x.jpg" "--gif x.png" "wlal" "--lab 3 --size 90x90 wlal"; do
  refuses view $arguments
  ! grep -q "Building" "$scratch/printed" || wrong "'view $arguments' built first"
done
prints 'there is no scene "wlal"'
refuses view --lab L3 wlal
prints 'there is no scene "wlal"'
# An option that the viewer does not have comes first: its value is not taken for a scene.
refuses view --stduent --lab 3
prints "there is no option --stduent. Did you mean --student?"
prints "./cs550 view --help explains the options."
refuses view -lab 3
prints "there is no option -lab. Did you mean --lab?"
refuses view --lba 5
prints "there is no option --lba. Did you mean --lab?"
refuses view --ha
! grep -q "mean" "$scratch/printed" || wrong "--ha may be anything"
refuses view wall -- x
prints "this argument is not expected: x"
refuses view --student=no
prints "--student takes no value"
refuses view --steps= wall
prints "--steps needs a value: --steps N"
refuses view wall --szie=90x90 --lab 99
prints "there is no option --szie. Did you mean --size?"
refuses view --lab 3 --snapshot --list
prints "--snapshot needs a value: --snapshot FILE"
refuses view --lab 3 --steps
prints "--steps needs a value: --steps N"
! grep -q "Building" "$scratch/printed" || wrong "the viewer was built first"
# The ending counts, however long the name is.
for option in "--snapshot $(printf 'a%.0s' $(seq 70)).png" "--gif $(printf 'a%.0s' $(seq 70)).gif"; do
  refuses view $option wlal
  prints 'there is no scene "wlal"'
done

# A link to itself, and a folder in a device.
ln -s loop "$scratch/loop"
for path in "$scratch/loop" "$scratch/loop/part"; do
  refuses submit 3 --out "$path"
  prints "Too many levels of symbolic links"
  refuses starter "$path"
  prints "Too many levels of symbolic links"
  refuses starter --update "$path"
  ! grep -qF "filesystem error" "$scratch/printed" || wrong "the library's words"
done
refuses starter /dev/null/copy
prints "/dev/null is not a folder"
for verb in "lab 3" progress "submit 3" "view --lab 3"; do
  code=0
  CS550_ROOT=/nonexistent "$program" $verb >"$scratch/printed" 2>&1 </dev/null || code=$?
  [ $code = 1 ] || wrong "'$verb' without a project exited with code $code, expected 1"
  prints "/nonexistent/tests: No such file or directory. CS550_ROOT must be"
done

refuses starter
prints "DIR is missing: "
refuses starter --release-solutions many copy
prints "--release-solutions needs a whole number from 0 to 7, found many"
refuses starter --release-solutions 2.5 copy
prints "--release-solutions needs a whole number from 0 to 7, found 2.5"
refuses starter --release-solutions 9 copy
prints "found 9"
refuses starter --release-solutions -1 copy
refuses progress --lsit
refuses view --lab 99
refuses view --failure Lab3.NoSuchTest
prints "there is no picture of a failing test Lab3.NoSuchTest"

# Five thousand letters are not repeated in full.
long=$(printf '%5000s' '' | tr ' ' a)
for arguments in "lab $long" "lab 3 --step $long" "submit $long" "view --lab $long" "view --failure $long" "progress $long"; do
  code=0
  CS550_ROOT=$root "$program" $arguments >"$scratch/printed" 2>&1 </dev/null || code=$?
  [ $code = 2 ] || wrong "a word of 5000 letters: exit code $code, expected 2"
  if grep -q 'a\{1000\}' "$scratch/printed"; then wrong "a word of 5000 letters was repeated in full"; fi
done

# The launcher.
cd "$root"
misuses() {
  code=0
  ./cs550 "$@" >"$scratch/printed" 2>&1 </dev/null || code=$?
  [ $code = 2 ] || wrong "./cs550 $* exited with code $code, expected 2"
}
misuses
misuses prgress
prints "there is no verb 'prgress'. Did you mean progress?"
misuses sub
prints "there is no verb 'sub'. Did you mean submit?"
misuses lba
prints "there is no verb 'lba'. Did you mean lab?"
for verb in list next reset; do
  misuses $verb
  ! grep -q "mean" "$scratch/printed" || wrong "no verb is like $verb"
done
misuses do
grep -qxF "cs550: there is no verb 'do'." "$scratch/printed" || wrong "two verbs begin with do"
prints "progress  print your points"
for odd in '.*' 'd*' 'demo|release' "$long"; do
  misuses "$odd"
  prints "there is no verb '"
  [ "$(grep 'no verb' "$scratch/printed" | wc -c)" -lt 400 ] || wrong "the verb was repeated in full"
done
misuses build quick
prints "release student test"
! grep -q "mean" "$scratch/printed" || wrong "no preset is like quick"
misuses build studnet
prints "there is no preset 'studnet'. Did you mean student?"
if grep -E '^.{81}' "$scratch/printed"; then wrong "a line has more than 80 columns"; fi
misuses doctor --install editor
prints "viewer"
code=0
./cs550 build student lab3_my_tests >"$scratch/printed" 2>&1 </dev/null || code=$?
[ $code = 1 ] || wrong "./cs550 build student lab3_my_tests exited with code $code, expected 1"
prints "there is no file labs/lab3_hill_climbing/my_tests.cpp"
prints '#include "cs550/hill_climbing.hpp"'
misuses test -R Lab3
prints "test -- -R Lab3"
echo "every wrong command line is refused"
rm -rf "$scratch"
