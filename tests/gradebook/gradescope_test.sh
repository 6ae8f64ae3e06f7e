#!/bin/sh
# gradescope_test.sh CS550_GRADE ROOT SCRATCH LAUNCHER: makes the autograder of lab 3 and runs it as Gradescope does,
# in a folder laid out like its image.
set -eu
program=$1 root=$2 autograder=$3/autograder
rm -rf "$3"
mkdir -p "$autograder/source" "$autograder/submission" "$autograder/results"
printf 'secret = "of this test"\n[visibility]\nhidden_tests = "hidden"\n[lab.3]\nown_tests = 5\n' >"$3/course.toml"
CS550_ROOT=$root "$program" --gradescope-zip "$3/lab3.zip" --labs 3 --course "$3/course.toml"
(cd "$autograder/source" && cmake -E tar xf "$3/lab3.zip")
wrong() { echo "gradescope_test: $1"; exit 1; }
[ -x "$autograder/source/run_autograder" ] || wrong 'run_autograder is not executable'
[ ! -e "$autograder/source/.git" ] || wrong 'the zip has the history'

export CS550_AUTOGRADER="$autograder" CMAKE_CXX_COMPILER_LAUNCHER="$4"
"$autograder/source/setup.sh"
cd "$autograder/source"
for path in solutions tests/mutants tests/lab3_hill_climbing/hidden reference; do
  [ ! -e "$path" ] || wrong "$path is left on the image"
done
[ "$(stat -c %a .)" = 700 ] || wrong 'another user can enter the folder of the autograder'

score() { sed -n 's/^ "score": \([0-9.]*\),$/\1/p' "$autograder/results/results.json"; }
cp "$root"/solutions/lab3_hill_climbing/*.cpp "$autograder/submission"
echo '{"created_at": "2026-10-12T14:22:32.365935-07:00"}' >"$autograder/submission_metadata.json"
./run_autograder
[ "$(score)" = 60.0 ] || wrong "the reference earns $(score) points"
folder=$autograder/submission/labs/lab3_hill_climbing
mkdir -p "$folder"
mv "$autograder/submission/hill_climbing.cpp" "$folder"
cat >"$folder/my_tests.cpp" <<END
#include <gtest/gtest.h>
#include "cs550/hill_climbing.hpp"
TEST(Mine, VisitsAll) { EXPECT_EQ(cs550::support_brute_force(std::vector<cs550::Vec3>(3), {1, 0, 0}).visited, 3); }
END
./run_autograder
case $(score) in 60.[1-9]*) ;; *) wrong "the reference with tests of its own earns $(score) points" ;; esac
rm -r "$autograder/submission/labs"
echo 'this is no C++' >"$autograder/submission/hill_climbing.cpp"
./run_autograder
[ "$(score)" = 0.0 ] || wrong "a file that does not compile earns $(score) points"
grep -q 'does not compile' "$autograder/results/results.json" || wrong 'the compiler is not quoted'
rm "$autograder/submission/hill_climbing.cpp"
./run_autograder
[ "$(score)" = 0.0 ] || wrong "an empty submission earns $(score) points"
