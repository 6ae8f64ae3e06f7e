#!/bin/sh
# verb_test.sh PROGRAM ROOT SCRATCH
# ./cs550 bench refuses what it cannot do with exit code 2 and writes what it measured. No time is checked.
set -eu
program=$1 scratch=$3
export CS550_ROOT=$2
rm -rf "$scratch"
mkdir -p "$scratch/out"
cd "$scratch/out"

wrong() { echo "WRONG: $1" >&2; cat "$scratch/printed" >&2; exit 1; }
runs() {
  "$program" "$@" >"$scratch/printed" 2>&1 </dev/null || wrong "bench $* failed"
  ! sed 's/µ/u/g' "$scratch/printed" | grep -qE '^.{81}' || wrong "bench $* printed a line of more than 80 columns"
}
refuses() {
  code=0
  "$program" "$@" >"$scratch/printed" 2>&1 </dev/null || code=$?
  [ $code = 2 ] || wrong "bench $* exited with code $code, expected 2"
  ! grep -qE '^.{81}' "$scratch/printed" || wrong "bench $* printed a line of more than 80 columns"
  [ -z "$(ls -A .)" ] || wrong "bench $* left $(ls -A .)"
}
prints() { grep -qF -e "$1" "$scratch/printed" || wrong "expected in the output: $1"; }

refuses --filter nothing_has_this_name
prints "--filter 'nothing_has_this_name' matches no benchmark"
prints "./cs550 bench --list"
refuses --filter '('
prints "'(' is not a regular expression"
refuses --json . --filter memory
prints "--json FILE needs a file that can be written"
refuses --json /proc/absent/out.json --filter memory
prints "/proc/absent"
prints "--json FILE needs a file that can be written"
refuses --rounds 0
refuses --threads 1
refuses --threads two
prints "--threads"
refuses --threads 2 --filter memory
prints "./cs550 bench --threads 2 --filter scene"
refuses --pears
prints "./cs550 bench --help"

runs --help
for option in --peers --filter --json --plot --threads; do prints "$option"; done
runs --list --plot
for name in support/climb/8192 gauss_map/arcs manifold/moved/cubes pass/at_once/2048 scene/S5b frontier/S1 step/cubes \
  memory; do
  prints "$name"
done

runs --brief --filter 'integration|support/.*/(8|16)$|^scene/S[12]$|memory' --json bench.json
prints "support/climb"
prints "p = "
prints "S1: pyramid of 20 rows"
prints "this engine"
prints "allocations in a steady step"
grep -q '"processor"' bench.json || wrong "bench.json names no processor"

runs --brief --filter '^scene/S[12]$|step/hulls$' --threads 2 --json threads.json
prints "One thread and 2, time by the clock"
for name in "S2  " "128 hulls"; do
  grep -q "^  $name  *this engine, game  *[0-9.]* *[0-9.]* *[0-9.]* *[0-9.]*\$" "$scratch/printed" ||
    wrong "no gain of $name"
done
grep -q '"seconds_shared"' threads.json || wrong "threads.json has no time of two threads"
grep -q '"seconds_copies"' threads.json || wrong "threads.json has no time of two copies"

# A signal ends it at the next figure, without a file.
rm -f ./*
: >"$scratch/printed" # what the run before printed says nothing about this one
"$program" --filter 'scene' --json interrupted.json >"$scratch/printed" 2>&1 &
until grep -q '^S1' "$scratch/printed"; do sleep 0.02; done
kill -TERM $!
code=0
wait $! || code=$?
[ $code = 1 ] || wrong "after SIGTERM the exit code is $code, expected 1"
prints "interrupted: what was unfinished is removed"
[ -z "$(ls -A .)" ] || wrong "after SIGTERM it left $(ls -A .)"

# The engines of the package group `peers`, or how to install them.
if "$program" --brief --peers --filter '^scene/S1$' >"$scratch/printed" 2>&1; then
  prints "Bullet, 10"
else
  prints "./cs550 doctor --install peers"
fi
echo "bench refuses what it cannot do and writes what it measured"
cd /
rm -rf "$scratch"
