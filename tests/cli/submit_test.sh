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
cat >"$project/cs550" <<LAUNCHER
#!/bin/sh
[ -e "$scratch/compiles" ] || { cp "$scratch/log" "$project/build/student.log"; exit 1; }
LAUNCHER
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
echo "old" >"$lab/hill_climbing.cpp~"
echo "old" >"$lab/#hill_climbing.cpp#"
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
! grep -qE 'README|svg|~|#' "$scratch/printed" || wrong "the handout, its figures and backups need not be packed"
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

# Where the name cannot be written, it is used all the same, and one line says why it is not remembered. Not even
# root can replace a file of the kernel.
mv "$project/.student" kept_name
ln -s /proc/sys/kernel/ostype "$project/.student"
submit --out stored.zip
! grep -q "remembered" printed || wrong "it wrote a name that was known"
submit --out unstored.zip --student "Ada Lovelace"
prints "Warning: the name is not remembered: cannot write $project/.student"
[ "$(grep -c 'cannot write' printed)" = 1 ] || wrong "the reason is printed twice"
(mkdir unstored && cd unstored && cmake -E tar xf ../unstored.zip)
grep -q '"student": "Ada Lovelace"' unstored/manifest.json || wrong "the student is missing"
rm "$project/.student"
mv kept_name "$project/.student"

rm compiles
error="labs/lab3_hill_climbing/hill_climbing.cpp:1:1: error: expected ';'"
printf '[1/2] Building\nFAILED: lab3.o\nc++ -c lab3.cpp\n%s\nninja: build stopped: subcommand failed.\n' "$error" >log
submit --out broken.zip
prints "Warning: lab 3 does not compile"
[ -s broken.zip ] || wrong "a lab that does not compile was not packed"
# The compiler was stopped, or the disk is full: the lab may be right.
printf '[1/2] Building\nFAILED: lab3.o\nc++ -c lab3.cpp\nc++: fatal error: Killed signal terminated program cc1plus\n' >log
submit --out unbuilt.zip
prints "Warning: lab 3 was not built, so it is not known whether it compiles."
! grep -q "does not compile" printed || wrong "the student is blamed for the machine"
[ -s unbuilt.zip ] || wrong "a lab that was not built was not packed"
# The folder of links in which a project is built that cannot be written to.
mkdir links
ln -s ../project/labs ../project/tests ../project/.starters ../project/cs550 links
mv "$project/.student" kept_name
CS550_ROOT="$scratch/links" "$program" submit 3 --out linked.zip --student Ada >printed 2>&1 || wrong "submit failed"
[ "$(cat "$project/.student")" = Ada ] || wrong "the name is not in the project"
[ ! -e links/.student ] || wrong "the name is in the folder of links"
# If it cannot be written there, it is.
rm "$project/.student"
mkdir "$project/.student"
CS550_ROOT="$scratch/links" "$program" submit 3 --out linked.zip --student Grace >printed 2>&1 || wrong "submit failed"
[ "$(cat links/.student)" = Grace ] || wrong "the name is not in the folder of links"
CS550_ROOT="$scratch/links" "$program" submit 3 --out linked.zip >printed 2>&1 </dev/null || wrong "submit failed"
! grep -q "no name\|Warning: the name" printed || wrong "the name in the folder of links was forgotten"
rm -r links/.student "$project/.student"
mv kept_name "$project/.student"
for time in first second; do
  CS550_ROOT="$scratch/links" "$program" submit 3 --out linked.zip >printed 2>&1 || wrong "the $time submission failed"
done
rm -r unpacked
mkdir unpacked
(cd unpacked && cmake -E tar xf ../linked.zip)
cmp "$lab/util/more.hpp" unpacked/labs/lab3_hill_climbing/util/more.hpp || wrong "paths through links are wrong"

# Tests that a student has written are handed in with an untouched lab too.
cp "$project/.starters/lab3_hill_climbing/hill_climbing.cpp" "$lab"
rm -r "$lab/util" "$lab/util.h" "$lab/my util.h" "$lab/table.txt"
code=0
"$program" submit 3 >printed 2>&1 || code=$?
[ $code = 1 ] || wrong "the starter was packed, with exit code $code"
prints "still the unchanged starter"
echo "int my_test;" >"$lab/my_tests.cpp"
submit --out tests.zip
"$program" submit --out all.zip >printed 2>&1 || wrong "a lab with tests of one's own is not packed"
prints "my_tests.cpp"

# A zip file without code would only look like a submission.
find "$lab" -name '*.cpp' ! -name my_tests.cpp -delete
for arguments in "submit 3 --out empty.zip" "submit --force --out empty.zip"; do
  code=0
  "$program" $arguments >printed 2>&1 || code=$?
  [ $code = 1 ] || wrong "'$arguments' without code exited with code $code, expected 1"
  prints "labs/lab3_hill_climbing has no .cpp file. ./cs550 lab 3 --reset"
  [ ! -e empty.zip ] || wrong "a lab without code was packed"
done
echo "int mine;" >"$lab/hill climbing.cpp"
mkdir "$lab/old"
echo "int old;" >"$lab/old/hill_climbing.cpp"  # compiled nowhere
code=0
"$program" submit 3 --out empty.zip >printed 2>&1 || code=$?
[ $code = 1 ] || wrong "a lab whose only file cannot be packed was packed"
prints "Rename it to"
prints "labs/lab3_hill_climbing has no .cpp file that can be packed."
if grep -q -e --reset printed; then wrong "--reset would move the student's code away"; fi
rm -r "$lab/hill climbing.cpp" "$lab/old"
echo "int mine;" >"$lab/hill_climbing.cpp"

code=0
"$program" submit 3 --out "$lab/hill_climbing.cpp" >printed 2>&1 || code=$?
[ $code = 2 ] || wrong "a zip replaced the code, with exit code $code"
prints "must end in .zip"
echo "submissions are complete"
rm -rf "$scratch"
