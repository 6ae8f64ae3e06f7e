#!/bin/bash
# rough_test.sh ROOT SCRATCH [KILLS [SEED]]
# A students' copy where everything goes wrong that may go wrong: commands killed at random moments, two at
# once, no HOME, decimal commas, no colour, a small terminal, odd paths, a full disk, a read-only project, a
# clock that jumps. Takes about a quarter of an hour on an idle machine with two processors.
#
# A killed command must leave every student's file as it was, and must work when it is run again.
set -eu
root=$1 scratch=$2 kills=${3:-200} seed=${4:-550}
RANDOM=$seed
echo "seed $seed, $kills kills"
unset CS550_ROOT CS550_BUILD_DIR  # the copy builds in its own folder
rm -rf "$scratch"
mkdir -p "$scratch"
copy="$scratch/a student's (own) cöpy"
log=$scratch/log

wrong() { echo "WRONG: $1" >&2; tail -n 20 "$log" >&2; exit 1; }
must() { "$@" >"$log" 2>&1 </dev/null || wrong "exit code $? of: $*"; }
prints() { grep -q -- "$1" "$log" || wrong "expected in the output: $1"; }
skip() { echo "SKIPPED: $1"; }
report() { echo "$1 (${SECONDS} s since the start)"; }

must "$root/cs550" starter "$copy"
cd "$copy"
lab=$(echo labs/lab3_*)
cp "$root"/solutions/lab3_*/*.cpp "$lab"
cp -r labs "$scratch/labs"
must ./cs550 lab 3
must ./cs550 submit 3 --out "$scratch/lab3.zip"
report "a copy with lab 3 written: its tests pass"

# --- killed ---------------------------------------------------------------------------------------------------

lab() { ./cs550 lab 3; }
submit() { ./cs550 submit 3 --out "$scratch/lab3.zip"; }
progress() { ./cs550 progress; }
update() { "$root/cs550" starter --update "$copy"; }
table() { "$root/cs550" demo stack10 --no-picture --csv "$scratch/table.csv"; }
# Without live figures, which take minutes to compile.
book() { CS550_LIVE_FIGURES=off "$root/cs550" docs; }

# Makes the copy older than the repository in a lab that the student has not begun.
age() { for file in labs/$aged .starters/$aged; do echo '// an older starter' >>"$file"; done; }
aged=lab4_separating_axis/separating_axis.cpp

# Gives lab 3 something to compile.
edit() { echo "static_assert($RANDOM >= 0);" >>"$lab/hill_climbing.cpp"; cp "$lab"/*.cpp "$scratch/$lab"; }

whole() {
  diff -r -x "${aged##*/}*" "$scratch/labs" labs >"$log" 2>&1 || wrong "a student's file changed when '$1' was killed"
  [ ! -e "$scratch/lab3.zip" ] || must python3 -m zipfile -t "$scratch/lab3.zip"
  [ ! -e "$scratch/table.csv" ] || [ "$(wc -l <"$scratch/table.csv")" = "$rows" ] || wrong "half a table"
}

export root copy lab scratch
export -f lab submit progress update table book

# seconds COMMAND: what a whole run takes
seconds() {
  local start
  edit
  start=$(date +%s.%N)
  must bash -c "$1"
  awk "BEGIN { print $(date +%s.%N) - $start }"
}

# kill_at_random COMMAND SECONDS: kills it and its children, at a moment before its end
kill_at_random() {
  edit
  setsid bash -c "$1" >/dev/null 2>&1 </dev/null &
  local leader=$!
  sleep "$(awk "BEGIN { print $2 * $RANDOM / 32768 }")"
  builtin kill -KILL -- -"$leader" 2>/dev/null || true
  wait "$leader" 2>/dev/null || true
}

must table  # the first time, it is also built
rows=$(wc -l <"$scratch/table.csv")
must progress
book_kills=$((kills / 25))
for command in lab submit progress update table; do
  duration=$(seconds "$command")
  for ((kill = 0; kill < (kills - book_kills) / 5; kill++)); do
    rm -f "$scratch/lab3.zip" "$scratch/table.csv"
    [ "$command" != update ] || age
    kill_at_random "$command" "$duration"
    whole "$command"
    must bash -c "$command"
    whole "$command"
    diff -r "$scratch/labs/${aged%/*}" "labs/${aged%/*}" >"$log" || wrong "$command left a starter that is old"
  done
  report "$command: killed at $kill moments of $duration s, works again after each"
done
# An update that was killed and then repeated leaves what a fresh copy has, but for what was built.
must update
must "$root/cs550" starter "$scratch/fresh"
diff -r -x build -x compile_commands.json -x labs -x .git "$scratch/fresh" . >"$log" || wrong "an updated copy differs from a fresh one"

# The book takes a minute or more: each run begins with what the killed ones left, and the last one ends.
if [ "$book_kills" -gt 0 ]; then
  changes() { git -C "$root" status --porcelain; }
  before=$(changes)
  must "$root/cs550" build release book_figures cs550_viewer
  duration=$(seconds book)
  for ((kill = 0; kill < book_kills; kill++)); do kill_at_random book "$duration"; done
  must book
  [ "$(changes)" = "$before" ] || wrong "docs changed files of the repository: $(changes)"
  [ -s "$root/build/docs/html/index.html" ] || wrong "no book"
  report "docs: killed at $kill moments of $duration s, then the book is built"
fi

# --- two at once ----------------------------------------------------------------------------------------------

# both COMMAND COMMAND
both() {
  bash -c "$1" >"$scratch/first" 2>&1 </dev/null &
  local first=$!
  must bash -c "$2"
  wait $first || wrong "beside '$2', '$1' failed: $(tail -n 20 "$scratch/first")"
}
for ((round = 0; round < 5; round++)); do
  edit
  both './cs550 lab 3' './cs550 lab 3'
done
edit
both "./cs550 view --lab 3 --student --size 160x120 --snapshot '$scratch/lab3.png'" './cs550 progress'
[ -s "$scratch/lab3.png" ] || wrong "no picture"
report "two at once: both work"

# --- surroundings ---------------------------------------------------------------------------------------------

must env -u HOME ./cs550 lab 3
must env HOME=/nonexistent ./cs550 progress
must env COLUMNS=80 LINES=24 TERM=dumb NO_COLOR=1 ./cs550 lab 3
! grep -q "$(printf '\033')" "$log" || wrong "colours in spite of NO_COLOR"
# A path cannot be broken into lines.
! awk 'length > 80 && !/\//' "$log" | grep . || wrong "lines of more than 80 columns"
report "no HOME, no colour, 80 columns: fine"

mkdir "$scratch/locales"
if localedef -f UTF-8 -i de_DE "$scratch/locales/de_DE.UTF-8" >"$log" 2>&1; then
  commas() { env LOCPATH="$scratch/locales" LC_ALL=de_DE.UTF-8 "$@"; }
  [ "$(commas bash -c 'printf %.1f 1,5' 2>&1)" = 1,5 ] || wrong "the locale has no decimal commas"
  must commas ./cs550 lab 3
  must commas "$root/cs550" demo stack10 --no-picture --csv "$scratch/comma.csv"
  must table
  cmp "$scratch/comma.csv" "$scratch/table.csv" || wrong "another table with decimal commas"
  report "decimal commas: the same table"
else
  skip "decimal commas: localedef cannot make a locale"
fi

# --- a clock that jumps ---------------------------------------------------------------------------------------

if command -v faketime >/dev/null; then
  for jump in '-1000 days' '+1000 days'; do
    edit
    must faketime "$jump" ./cs550 lab 3
    must faketime "$jump" ./cs550 submit 3 --out "$scratch/jump.zip"
    must ./cs550 lab 3
  done
else
  skip "a program's own clock: faketime is not installed"
fi
# What was built tomorrow must not hide what is edited now, and an edit from long ago must count.
find build/student -type f -exec touch -d '+2 days' {} +
edit
must ./cs550 lab 3
echo 'static_assert(false, "an edit from the past");' >>"$lab/hill_climbing.cpp"
touch -d 2001-01-01 "$lab/hill_climbing.cpp"
! ./cs550 lab 3 >"$log" 2>&1 </dev/null || wrong "an edit with an old time was not compiled"
prints 'an edit from the past'
cp "$scratch/$lab/hill_climbing.cpp" "$lab"
touch -d 2000-01-01 "$lab/hill_climbing.cpp"
must ./cs550 lab 3
report "a clock that jumps: every edit counts"

# --- odd paths, and a project that is read only ---------------------------------------------------------------

export XDG_CACHE_HOME=$scratch/cache
odd="$scratch/\"quotes\", \$, ;
and a ⏎ in Übung 3"
must cp -r "$scratch/fresh" "$odd"
cp "$lab"/*.cpp "$odd/$lab"
must "$odd/cs550" lab 3
must "$odd/cs550" submit 3 --out "$odd/my \"lab\" 3.zip"
prints 'CMake cannot build in a path with'
must python3 -m zipfile -t "$odd/my \"lab\" 3.zip"
[ ! -e "$odd/build/student" ] || wrong "it built in the odd path"
report "quotes, dollar, line break and Unicode in the path: fine"

if unshare --mount true 2>/dev/null; then
  rm -rf "$odd" "$XDG_CACHE_HOME"
  must unshare --mount sh -c 'mount --bind "$1" "$1" && mount -o remount,bind,ro "$1" && cd "$1" && ./cs550 lab 3' \
    sh "$copy"
  prints 'cannot be written to. Building in'
  report "read-only: builds in the cache folder"
else
  skip "read-only projects: mounting is not allowed"
fi

# --- a full disk, and an interruption -------------------------------------------------------------------------

must "$root/cs550" view wall --size 160x120 --snapshot "$scratch/wall.png"  # builds the viewer
export CS550_ROOT=$root
frames() { exec "$root/build/release/bin/cs550_viewer" wall --size 640x480 --frames "$1"; }
export -f frames

# Every picture in folder $1 is complete.
complete() {
  python3 - "$1" <<'PYTHON'
import pathlib, sys
files = sorted(pathlib.Path(sys.argv[1]).iterdir())
assert files and all(f.suffix == ".png" and f.read_bytes().endswith(b"IEND\xaeB`\x82") for f in files), files
PYTHON
}
if unshare --mount true 2>/dev/null; then
  mkdir "$scratch/small" "$scratch/kept"
  must unshare --mount bash -c 'mount -t tmpfs -o size=512k none "$1" || exit 1
    code=0; (frames "$1/f") || code=$?
    cp "$1"/f/* "$2"
    [ "$code" = 1 ]' sh "$scratch/small" "$scratch/kept"
  prints 'No space left on device'
  complete "$scratch/kept" || wrong "half a picture"
  report "a full disk: $(find "$scratch/kept" -type f | wc -l) frames, all complete, then exit code 1"
else
  skip "a full disk: mounting is not allowed"
fi
for signal in TERM INT KILL; do
  rm -rf "$scratch/frames"
  # A shell's background commands ignore INT without job control.
  (set -m; bash -c 'frames "$1"' sh "$scratch/frames" >/dev/null 2>&1 </dev/null & echo $! >"$scratch/pid"; wait) &
  waiting=$!
  until [ -e "$scratch/frames/0001.png" ]; do
    builtin kill -0 $waiting 2>/dev/null || wrong "the viewer wrote no frames"
    sleep 0.05
  done
  builtin kill -"$signal" "$(cat "$scratch/pid")"
  wait $waiting || true
  complete "$scratch/frames" || wrong "half a picture"
done
report "TERM, INT and KILL: no half-written frame"
rm -rf "$scratch"
