#!/bin/sh
# output_test.sh PROGRAM ROOT SCRATCH
# What cannot be written is an error, leaves nothing half-written, and replaces ordinary files only.
set -eu
program=$1 scratch=$3
export CS550_ROOT=$2
rm -rf "$scratch"
mkdir -p "$scratch/out"
cd "$scratch/out"

wrong() { echo "WRONG: $1" >&2; cat "$scratch/printed" >&2; exit 1; }
demo() { "$program" stack10 --steps 3 --no-picture "$@" 2>"$scratch/printed"; }
fails_with() {
  message=$1
  shift
  code=0
  demo "$@" >"$scratch/summary" || code=$?
  [ $code = 1 ] || wrong "demo $* exited with code $code, expected 1"
  # The length of the path decides where a message is broken into lines.
  tr '\n' ' ' <"$scratch/printed" | grep -qF "$message" || wrong "expected in the message: $message"
}

code=0
demo >/dev/full || code=$?
[ $code = 1 ] || wrong "with a full standard output the exit code is $code, expected 1"
grep -qF "cannot write to standard output: No space left on device" "$scratch/printed" || wrong "no reason"

echo before >table.csv
# The limit stops the second write of a table that is larger than a block of 512 bytes.
(trap '' XFSZ; ulimit -f 1; fails_with "cannot write table.csv: File too large" --csv table.csv)
[ "$(cat table.csv)" = before ] || wrong "a table that could not be written replaced the one before"
[ "$(ls -A)" = table.csv ] || wrong "unfinished files: $(ls -A)"

demo --csv table.csv >/dev/null || wrong "no table"
[ "$(wc -l <table.csv)" = 41 ] || wrong "the table has $(wc -l <table.csv) lines, expected a header and 4 × 10"

fails_with "cannot write /dev/full: No space left on device" --csv /dev/full
[ -c /dev/full ] || wrong "/dev/full was replaced"
mkdir folder.csv
fails_with "cannot write folder.csv: Is a directory" --csv folder.csv
ln -s table.csv link.csv
cp table.csv expected.csv
: >table.csv
demo --csv link.csv >/dev/null || wrong "no table behind the link"
[ -L link.csv ] || wrong "a symbolic link was replaced"
cmp table.csv expected.csv || wrong "the target of the link was not written"
(trap '' XFSZ; ulimit -f 1; fails_with "File too large" --csv link.csv)
cmp table.csv expected.csv || wrong "a table that could not be written replaced the one behind the link"

# The standard output may be a file. It is not replaced, so that the summary follows in it.
demo --csv /dev/stdout >>all.txt || wrong "no table on the standard output"
[ "$(grep -c '^state hash' all.txt)" = 1 ] || wrong "the standard output was replaced"
rm all.txt

# Ctrl-C removes what is unfinished.
for signal in INT TERM; do
  "$program" stack10 --steps 1000000 --no-picture --csv interrupted.csv >/dev/null 2>"$scratch/printed" &
  sleep 1
  kill -$signal $!
  code=0
  wait $! || code=$?
  [ $code = 1 ] || wrong "after $signal the exit code is $code, expected 1"
  grep -qF "interrupted: what was unfinished is removed" "$scratch/printed" || wrong "it did not mention the signal"
  [ -z "$(find . -name 'interrupted*')" ] || wrong "it left $(ls -A)"
done

# After nohup it runs on when the terminal is closed.
(trap '' HUP; exec "$program" stack10 --steps 1000000 --no-picture >/dev/null 2>"$scratch/printed") &
sleep 1
kill -HUP $!
sleep 0.5
kill -INT $! || wrong "it ended at a signal that it was to ignore"
! wait $! || wrong "an interrupted run exited with code 0"
