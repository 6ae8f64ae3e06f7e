#!/bin/bash
# rough_test.sh ROOT SCRATCH [KILLS [SEED]]
# A students' copy where everything goes wrong that may go wrong: commands killed at random moments, two at
# once, no HOME, decimal commas, no colour, a small terminal, a read-only project, a clock that jumped.
# A killed command must leave every student's file as it was, and must work when it is run again.
set -eu
root=$1 scratch=$2 kills=${3:-200} seed=${4:-550}
RANDOM=$seed
echo "seed $seed, $kills kills"
rm -rf "$scratch"
mkdir -p "$scratch"
copy="$scratch/a student's (own) cöpy"
log=$scratch/log

wrong() { echo "WRONG: $1" >&2; tail -n 20 "$log" >&2; exit 1; }
must() { "$@" >"$log" 2>&1 </dev/null || wrong "exit code $? of: $*"; }

must "$root/cs550" starter "$copy"
cd "$copy"
lab=$(echo labs/lab3_*)
cp "$root"/solutions/lab3_*/*.cpp "$lab"
cp -r labs "$scratch/labs"
must ./cs550 lab 3
cd "$root" && must ./cs550 build test cs550_cli && cd "$copy"

# --- killed ---------------------------------------------------------------------------------------------------

# The commands take about a second; lab 3 has something to compile each time.
lab() { echo "static_assert($RANDOM >= 0);" >>"$lab/hill_climbing.cpp"; cp "$lab"/*.cpp "$scratch/$lab"; ./cs550 lab 3; }
submit() { ./cs550 submit 3 --out "$scratch/lab3.zip"; }
progress() { ./cs550 progress; }
update() { "$root/cs550" starter --update "$copy"; }
table() { "$root/cs550" demo stack10 --no-picture --csv "$scratch/table.csv"; }
commands=(lab submit progress update table)

whole() {
  diff -r "$scratch/labs" labs >"$log" 2>&1 || wrong "a student's file changed when '$1' was killed"
  [ ! -e "$scratch/lab3.zip" ] || must python3 -m zipfile -t "$scratch/lab3.zip"
  [ ! -e "$scratch/table.csv" ] || [ "$(wc -l <"$scratch/table.csv")" = "$rows" ] || wrong "half a table"
}

export root copy lab scratch
export -f "${commands[@]}"
must table
rows=$(wc -l <"$scratch/table.csv")
for ((kill = 0; kill < kills; kill++)); do
  command=${commands[kill % ${#commands[@]}]}
  rm -f "$scratch/lab3.zip" "$scratch/table.csv"
  setsid bash -c "$command" >/dev/null 2>&1 </dev/null &
  leader=$!
  sleep "$(awk "BEGIN { print 1.5 * $RANDOM / 32768 }")"  # the random moment
  builtin kill -KILL -- -"$leader" 2>/dev/null || true
  wait "$leader" 2>/dev/null || true
  whole "$command"
  must bash -c "$command"
  whole "$command"
done
echo "killed at $kills moments: every student's file is whole, and every command works again"

# --- two at once ----------------------------------------------------------------------------------------------

for ((round = 0; round < 5; round++)); do
  echo "static_assert($round >= 0);" >>"$lab/hill_climbing.cpp"
  ./cs550 lab 3 >"$scratch/first" 2>&1 &
  first=$!
  must ./cs550 lab 3
  wait $first || wrong "one of two './cs550 lab 3' at once failed: $(cat "$scratch/first")"
done
echo "two at once: both pass"

# --- surroundings ---------------------------------------------------------------------------------------------

must env -u HOME ./cs550 lab 3
must env HOME=/nonexistent ./cs550 progress
must env COLUMNS=80 LINES=24 TERM=dumb NO_COLOR=1 ./cs550 lab 3
! grep -q "$(printf '\033')" "$log" || wrong "colours in spite of NO_COLOR"
comma=$(locale -a 2>/dev/null | grep -iE '^(de|fr|es|it|pl)_.*utf' | head -n 1) || true
if [ -n "$comma" ]; then
  LC_ALL=$comma must ./cs550 lab 3
  LC_ALL=$comma must "$root/cs550" demo stack10 --no-picture --csv "$scratch/comma.csv"
  cmp "$scratch/comma.csv" "$scratch/table.csv" || wrong "another table in the locale $comma"
else
  echo "no locale with decimal commas is installed: skipped"
fi
touch -d '+2 days' "$lab/hill_climbing.cpp"
must ./cs550 lab 3
touch -d '2001-01-01' "$lab/hill_climbing.cpp"
must ./cs550 lab 3
echo "no HOME, no colour, decimal commas, files from the future and the past: fine"

# --- a project that is read only ------------------------------------------------------------------------------

if unshare --mount true 2>/dev/null; then
  export XDG_CACHE_HOME=$scratch/cache
  must unshare --mount sh -c 'mount --bind "$1" "$1" && mount -o remount,bind,ro "$1" && cd "$1" && ./cs550 lab 3' \
    sh "$copy"
  grep -q 'cannot be written to. Building in' "$log" || wrong "it does not report where it builds"
  echo "read-only: builds in the cache folder"
else
  echo "mounting is not allowed: read-only projects skipped"
fi
rm -rf "$scratch"
