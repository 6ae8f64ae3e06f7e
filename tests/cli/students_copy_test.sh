#!/bin/sh
# students_copy_test.sh PROGRAM ROOT COPY [COMPILER-LAUNCHER]
# Makes the students' copy of ROOT in COPY and checks that it contains no line and no renamed algorithm of a
# reference, that its tests are the visible ones, that it has its own history, and that a broken lab does
# not stop the others.
set -eu
program=$1 root=$2 copy=$3 launcher=${4-}
list=$copy.lines
rm -rf "$copy" "$list"
mkdir -p "$list"
CS550_ROOT=$root "$program" starter "$copy"

wrong() { echo "WRONG: $1" >&2; shift; for line; do echo "  $line" >&2; done; exit 1; }
# Lines of code that are too long to be equal by chance.
long_lines() { sed 's/^[[:space:]]*//; s/[[:space:]]*$//' | grep -aE '^.{30,}$' | sort -u; }
committed() { git -C "$root" grep -hI '' HEAD -- "$@"; }

echo "No line of a reference:"
committed solutions | long_lines >"$list/reference"
# A line that given code, starters or tests contain too (a loop over all faces) is no secret.
committed labs framework tests ':!tests/mutants' | long_lines >"$list/given"
comm -23 "$list/reference" "$list/given" >"$list/secret"
find "$copy" -name .git -prune -o -type f -print0 | sort -z | xargs -0 cat | long_lines >"$list/copy"
long_lines <"$(echo "$copy"/tests/lab7_*/manifest.json)" | comm -23 - "$list/copy" >"$list/unread"
[ ! -s "$list/unread" ] || wrong "the copy was not read to its end"
comm -12 "$list/secret" "$list/copy" >"$list/leaked"
secrets=$(wc -l <"$list/secret")
[ "$secrets" -gt 100 ] || wrong "only $secrets lines of the reference were looked for"
[ ! -s "$list/leaked" ] || wrong "lines of the reference are in the copy:" "$(cat "$list/leaked")"
echo "  none of $secrets"

echo "No algorithm of a reference under other names:"
looks_alike() {
  python3 "$root/tests/cli/structure_leaks.py" "$root/solutions" "$1" "$copy/framework/include" "$copy/labs"
}
mkdir -p "$list/renamed/framework"
sed 's/\bpolygon\b/outline/g; s/\bedge\b/side/g; s/\bplane\b/cut/g' "$root"/solutions/lab5_*/contact_manifold.cpp \
  >"$list/renamed/framework/page.cpp"
! looks_alike "$list/renamed" >/dev/null 2>&1 || wrong "a reference with renamed variables was not recognised"
looks_alike "$copy" || wrong "given code repeats a reference; see above"
echo "  none"

echo "Pristine starters, and nothing of the instructor's:"
for lab in "$copy"/labs/lab*; do
  for file in "$lab"/*.cpp; do cmp "$file" "$copy/.starters/${lab##*/}/${file##*/}"; done
done
found=$(cd "$copy" && find solutions tests -name hidden -o -name mutants -o -path 'solutions/*') 2>/dev/null || true
[ -z "$found" ] || wrong "the copy has" "$found"
for path in solutions .ci CONTRIBUTING.md docs/instructors.md docs/chapters/answers.md docs/rebuild framework/gradebook \
  tests/cli; do
  [ ! -e "$copy/$path" ] || wrong "the copy has $path"
done
! grep -q export-ignore "$copy/.gitattributes" || wrong "its .gitattributes names what it leaves out"
version=$(cat "$copy/.starters/version")
[ "${version#* }" = "$(git -C "$root" rev-parse --short=12 HEAD)" ] || wrong "its version is $version"
! "$copy/cs550" help | grep -qE '^ *(starter|grade|bench) ' || wrong "its help lists a verb for instructors"

echo "The book's figures, those that were built:"
if [ -d "$root/build/docs/figures" ]; then
  for chapter in "$copy"/docs/chapters/*.md; do
    grep -o '(figures/[a-z_0-9]*\.[a-z]*' "$chapter" | while read -r figure; do
      [ ! -s "$root/build/docs/${figure#(}" ] || [ -s "$copy/docs/chapters/${figure#(}" ] ||
        wrong "${chapter##*/} has no ${figure#(}"
    done
  done
else
  [ ! -e "$copy/docs/chapters/figures" ] || wrong "the copy has figures from elsewhere"
fi

echo "A history of its own:"
history=$(git -C "$copy" log --all --format='%an %ae %s')
[ "$history" = "CS550 cs550@localhost The seven labs" ] || wrong "the history is" "$history"
[ -z "$(git -C "$copy" remote)" ] || wrong "it has a remote"
git clone -q -c core.autocrlf=true "$copy" "$list/clone"
[ -z "$(grep -rlI "$(printf '\r')" "$list/clone" --exclude-dir=.git)" ] || wrong "a clone under Windows has other line ends"
rm -rf "$list/clone"
! CS550_ROOT=$root "$program" starter "$copy" 2>/dev/null || wrong "a folder in use was taken"

echo "Its tests are the visible ones, and a broken lab stops no other:"
echo 'int broken = ;' >>"$(echo "$copy"/labs/lab2_*/merging.cpp)"
cmake -S "$copy" -B "$copy/build" -G Ninja -DCMAKE_CXX_COMPILER_LAUNCHER="$launcher" >"$list/configure.log"
ctest --test-dir "$copy/build" -N -L '^student$' | sed -n 's/.*: student\.//p' | sort >"$list/tests"
for manifest in "$root"/tests/lab*/manifest.json; do
  awk -F'"' '/"lab":/ { split($0, lab, /[:,]/); gsub(/ /, "", lab[2]) } /"name":/ { name = $4 }
             /"hidden": false/ { print "Lab" lab[2] "." name }' "$manifest"
done | sort >"$list/visible"
cmp "$list/tests" "$list/visible" || wrong "the tests are not the visible ones:" \
  "$(diff "$list/tests" "$list/visible")"
# Builds a lab's library for the engine; the function $2 of it must be $3: in it, or missing from it.
check_assembled() {
  cmake --build "$copy/build" --target "$1_assembled_code" >"$list/build.log" || { cat "$list/build.log"; exit 1; }
  if nm -D --defined-only "$copy/build/labs/lib$1_assembled.so" | grep -q " T _ZN5cs550[0-9]*$2E"; then found=in
  else found=missing; fi
  [ "$found" = "$3" ] || wrong "$2 should be $3" "$(cat "$list/build.log")"
}
check_assembled lab1 apply_impulse in
check_assembled lab2 build_half_edge_mesh in
check_assembled lab2 merge_coplanar_faces missing
check_assembled lab3 hill_climb in
sed -i '1i #include "later.hpp"' "$(echo "$copy"/labs/lab1_*/integration.cpp)"
check_assembled lab1 apply_impulse missing
: >"$(echo "$copy"/labs/lab1_*)/later.hpp"
check_assembled lab1 apply_impulse in
cp "$copy"/labs/lab3_*/hill_climbing.cpp "$(echo "$copy"/labs/lab3_*)/again.cpp"
! cmake --build "$copy/build" --target lab3_student_code >"$list/build.log" 2>&1 ||
  wrong "two files of a lab may not define the same function"
grep -qE "(duplicate symbol|multiple definition).*hill_climb" "$list/build.log" ||
  wrong "it should say which functions are defined twice" "$(cat "$list/build.log")"
check_assembled lab3 hill_climb in
echo "  $(wc -l <"$list/tests") tests; the labs build"
rm -rf "$copy" "$list"
