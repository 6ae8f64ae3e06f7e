#!/bin/sh
# submit_test.sh PROGRAM SCRATCH
# submit packs all code of a lab, and names the student and the starter. A project of a few files, whose launcher
# only pretends to build, makes this quick.
set -eu
program=$1 scratch=$2
rm -rf "$scratch"
project=$scratch/project
lab=$project/labs/lab3_hill_climbing
mkdir -p "$lab/util/.cache" "$project/tests/lab3_hill_climbing" "$project/.starters/lab3_hill_climbing"
printf '#!/bin/sh\n[ -e "%s/compiles" ]\n' "$scratch" >"$project/cs550"
chmod +x "$project/cs550"
echo "1.0 0123456789ab" >"$project/.starters/version"
echo "int starter;" >"$project/.starters/lab3_hill_climbing/hill_climbing.cpp"
echo "int mine;" >"$lab/hill_climbing.cpp"
echo "int helper;" >"$lab/util.h"
echo "int deeper;" >"$lab/util/more.hpp"
echo "int template_code;" >"$lab/util/more.tpp"
echo "int odd;" >"$lab/my util.h"
echo "1, 2" >"$lab/table.txt"
echo "int hidden;" >"$lab/util/.cache/a.hpp"
echo "old" >"$lab/hill_climbing.cpp.bak-1"
echo "words" >"$lab/README.md"
echo "<svg/>" >"$lab/figure.svg"
cd "$scratch"
export CS550_ROOT="$project"

wrong() { echo "WRONG: $1" >&2; cat "$scratch/printed" >&2; exit 1; }
submit() { "$program" submit 3 "$@" >"$scratch/printed" 2>&1 </dev/null || wrong "submit $* failed"; }
prints() { tr '\n' ' ' <"$scratch/printed" | grep -qF "$1" || wrong "expected in the message: $1"; }

touch compiles
submit --out first.zip
prints "no name"
prints "Not packed: labs/lab3_hill_climbing/my util.h"
prints "Rename it to labs/lab3_hill_climbing/my_util.h"
prints "Not packed: labs/lab3_hill_climbing/table.txt"
! grep -qE 'README|svg' "$scratch/printed" || wrong "the handout and its figures need not be packed"
submit --out named.zip --student "Ada Lovelace"
submit --out again.zip
! grep -q "no name" printed || wrong "the name was forgotten"

mkdir unpacked
(cd unpacked && cmake -E tar xf ../again.zip)
(cd unpacked && find . -type f | sort) >found
printf './%s\n' labs/lab3_hill_climbing/hill_climbing.cpp labs/lab3_hill_climbing/util.h \
  labs/lab3_hill_climbing/util/more.hpp labs/lab3_hill_climbing/util/more.tpp manifest.json >expected
cmp expected found || wrong "the zip contains $(cat found)"
for file in hill_climbing.cpp util.h util/more.hpp; do
  cmp "$lab/$file" "unpacked/labs/lab3_hill_climbing/$file" || wrong "$file was changed"
done
grep -q '"student": "Ada Lovelace"' unpacked/manifest.json || wrong "the student is missing"
grep -q '"starter": "1.0 0123456789ab"' unpacked/manifest.json || wrong "the starter's commit is missing"

rm compiles
submit --out broken.zip
prints "Warning: lab 3 does not compile"
[ -s broken.zip ] || wrong "a lab that does not compile was not packed"
echo "submissions are complete"
rm -rf "$scratch"
