#!/bin/sh
# launcher_test.sh ROOT SCRATCH
# The launcher builds one thing at a time in a folder, and builds elsewhere if the project cannot be written
# to. A project of three files and a cmake that only records where it ran make this quick.
set -eu
root=$1 scratch=$2
rm -rf "$scratch"
project="$scratch/a project's (unusual) földer"
mkdir -p "$project/framework/cli" "$scratch/bin"
cp "$root/cs550" "$root/CMakePresets.json" "$project"
cp "$root/framework/cli/verbs.def" "$root/framework/cli/first_errors.awk" "$root/framework/cli/configure.sh" \
  "$project/framework/cli"
: >"$project/framework/cli/packages.txt"  # a test installs nothing
cat >"$scratch/bin/cmake" <<'FAKE'
#!/bin/sh
case $1 in
  --version) echo "cmake version ${CMAKE_VERSION-3.25.1}"; exit ;;
  --build) echo "built in $(pwd -P)"; echo "messages in ${LC_ALL-}"; echo "jobs: ${CMAKE_BUILD_PARALLEL_LEVEL-}" ;;
  --preset)
    echo "$*" >>"$CONFIGURED"
    [ ! -e unconfigurable ] || exit 1
    echo "CMAKE_HOME_DIRECTORY:INTERNAL=$(pwd -P)" >"build/$2/CMakeCache.txt"
    : >"build/$2/build.ninja" ;;
esac
[ ! -e broken ] || { echo '-- GLOB mismatch!'; echo "In file included from $(pwd -P)/labs/a.hpp:1,"; cat broken; exit 1; }
FAKE
chmod +x "$scratch/bin/cmake"
export CONFIGURED="$scratch/configured" PATH="$scratch/bin:$PATH" XDG_CACHE_HOME="$scratch/cache"
# ./cs550 test sets CS550_ROOT, and a launcher that a program of the project calls prints less. The user may have set
# CS550_BUILD_DIR.
unset CS550_ROOT CS550_BUILD_DIR CS550_WERROR CXX CMAKE_CXX_COMPILER_LAUNCHER CMAKE_BUILD_PARALLEL_LEVEL

wrong() { echo "WRONG: $1" >&2; cat "$scratch/printed" >&2; exit 1; }
prints() { tr '\n' ' ' <"$scratch/printed" | grep -qF "$1" || wrong "expected in the output: $1"; }
builds_in() {
  "$project/cs550" build test >"$scratch/printed" 2>&1 || wrong "the build failed"
  grep -qFx "built in $1" "$1/build/test.log" || wrong "it did not build in $1"
}

builds_in "$project"

# Messages of the compiler are in the language that the command line reads.
LC_ALL=de_DE.UTF-8 builds_in "$project"
grep -qx "messages in C.UTF-8" "$project/build/test.log" || wrong "messages are in the user's language"

# With too little memory for ninja's jobs, there are fewer. The user's number counts.
if [ -e /proc/meminfo ]; then
  jobs() {
    printf '#!/bin/sh\necho %s\n' "$1" >"$scratch/bin/getconf"
    chmod +x "$scratch/bin/getconf"
    builds_in "$project"
    sed -n 's/^jobs: //p' "$project/build/test.log"
  }
  [ -z "$(jobs 1)" ] || wrong "with one processor, there are $(jobs 1) jobs"
  [ "$(jobs 100000)" -lt 100000 ] || wrong "with 100000 processors, there are $(jobs 100000) jobs"
  export CMAKE_BUILD_PARALLEL_LEVEL=100000
  [ "$(jobs 100000)" = 100000 ] || wrong "instead of the user's 100000 jobs, there are $(jobs 100000)"
  unset CMAKE_BUILD_PARALLEL_LEVEL
  rm "$scratch/bin/getconf"
fi

# A lab that does not compile counts as empty, but not one whose compiler was stopped: it is compiled again.
cat >"$scratch/bin/compiler" <<'FAKE'
#!/bin/sh
[ "$MESSAGE" != "killed without a message" ] || kill -9 $$
echo "$MESSAGE" >&2
exit 1
FAKE
chmod +x "$scratch/bin/compiler"
export MESSAGE
tolerate() { sh "$root/framework/cmake/empty_object_on_error.sh" "$@"; }
compile() { tolerate compiler -o "$scratch/lab.o" -c lab.cpp >/dev/null 2>&1; }
for MESSAGE in "lab.cpp:1:1: error: expected ';'" "lab.cpp:1:1: error: expected ';'    1 | int x // out of memory"; do
  compile || wrong "a lab that does not compile stops the build: $MESSAGE"
  [ -s "$scratch/lab.o" ] || wrong "no empty object"
  rm "$scratch/lab.o"
done
for MESSAGE in "c++: fatal error: Killed signal terminated program cc1plus" "cc1plus: out of memory allocating 9 bytes" \
  "lab.cpp:60:1: fatal error: error writing to /tmp/a.s: No space left on device" "killed without a message"; do
  if compile; then wrong "it counts as a mistake of the lab: $MESSAGE"; fi
  [ ! -e "$scratch/lab.o" ] || wrong "an object is left after: $MESSAGE"
done
LC_ALL=de_DE.UTF-8 tolerate sh -c 'echo "$LC_ALL"' >"$scratch/printed"
prints "C.UTF-8"

# What is built again. The tests run twice: in the project, and in a folder of links to it.
# build_state FOLDER: where it builds
build_state() {
  built=$1/build
  # The command line is built when its files have changed, and only then.
  mkdir -p "$built/student/bin"
  printf '#!/bin/sh\necho "$*"\n' >"$built/student/bin/cs550"
  chmod +x "$built/student/bin/cs550"
  touch "$project/framework/cli/verbs.def"
  runs_after_build yes
  runs_after_build no
  touch -d '+1 minute' "$project/framework/cli/verbs.def"
  runs_after_build yes
  touch "$project/framework/cli/verbs.def"

  # It is configured when the presets have changed, and only then.
  "$project/cs550" build test
  : >"$scratch/configured"
  "$project/cs550" build test
  "$project/cs550" build test
  [ ! -s "$scratch/configured" ] || wrong "without a change, it was configured again in $1"
  echo >>"$project/CMakePresets.json"
  "$project/cs550" build test
  [ -s "$scratch/configured" ] || wrong "after a change of the presets, it was not configured again in $1"

  # An edit counts by its bytes. A file from a backup has its old time, and so has one after the clock was set back.
  for lab in 3 4; do
    mkdir -p "$project/labs/lab${lab}_topic" "$built/test/lab${lab}_student_code.dir/labs" \
      "$built/test/lab${lab}_my_tests.dir/labs"
    echo written >"$project/labs/lab${lab}_topic/topic.cpp"
  done
  "$project/cs550" build test
  compiled
  "$project/cs550" build test
  [ "$(objects)" = "3_my_tests 3_student_code 4_my_tests 4_student_code" ] ||
    wrong "without an edit, the objects in $1 are: $(objects)"
  echo restored >"$project/labs/lab3_topic/topic.cpp"
  touch -d 2001-01-01 "$project/labs/lab3_topic/topic.cpp"
  "$project/cs550" build test
  [ "$(objects)" = "4_my_tests 4_student_code" ] ||
    wrong "after an edit of lab 3 with an old time, the objects in $1 are: $(objects)"
}
runs_after_build() {
  rm -f "$built/student.log"
  [ "$("$project/cs550" progress --list)" = 'progress --list' ] || wrong "the program did not run"
  [ "$1" = "$([ -e "$built/student.log" ] && echo yes || echo no)" ] || wrong "built in $built before it ran: not '$1'"
}
compiled() { for folder in "$built"/test/lab[34]_*.dir; do : >"$folder/labs/topic.cpp.o"; done; }
objects() { (cd "$built/test" && echo lab*.dir/labs/*.o) | sed 's/lab\([^.]*\)[^ ]*/\1/g'; }

mkdir -p "$project/framework/cmake" "$project/framework/files" "$project/framework/include/cs550" "$project/labs"
: >"$project/framework/include/cs550/excerpt.hpp"
: >"$project/framework/include/cs550/nearest_word.hpp"
: >"$project/CMakeLists.txt"
build_state "$project"
CS550_BUILD_DIR=$scratch/linked
export CS550_BUILD_DIR
"$project/cs550" help >/dev/null
build_state "$(echo "$CS550_BUILD_DIR"/cs550-*)"
unset CS550_BUILD_DIR

# The launcher knows the headers that the command line includes from elsewhere. The demo is another program.
sources=$(sed -n "/^cli_sources='/,/'\$/p" "$root/cs550")
for header in $(cd "$root/framework" && find cli files -path cli/demo -prune -o -type f -exec \
  sed -n 's|^#include "\(cs550/.*\)"|\1|p' {} + | sort -u); do
  case $sources in
    *" framework/include/$header"*) ;;
    *) wrong "cli_sources lacks framework/include/$header" ;;
  esac
done

# A build is configured again after what CMake does not notice. From nothing, which deletes all objects, only if it must be.
# configures HOW WHAT [NAME=VALUE]...: "not", "again" or "afresh"
configures() {
  how=$1 what=$2
  shift 2
  : >"$scratch/configured"
  env "$@" "$project/cs550" build test >"$scratch/printed" 2>&1 || wrong "the build failed: $what"
  case $(cat "$scratch/configured") in
    '') done=not ;;
    *--fresh*) done=afresh ;;
    *) done=again ;;
  esac
  [ "$done" = "$how" ] || wrong "configured '$done' instead of '$how': $what"
}
rm -rf "$project/build/test"
configures afresh "the first time"
configures not "nothing has changed"
configures again "CS550_WERROR" CS550_WERROR=ON
configures not "CS550_WERROR again" CS550_WERROR=ON
configures again "no CS550_WERROR"
configures again "a compiler launcher" CMAKE_CXX_COMPILER_LAUNCHER=cache
grep -q -e '-DCMAKE_CXX_COMPILER_LAUNCHER=cache$' "$scratch/configured" || wrong "CMake got no compiler launcher"
configures again "no compiler launcher"
configures afresh "another compiler" CXX=g++-12
configures afresh "the usual compiler"
sed -i 's/"CS550_LTO": "ON"/"CS550_LTO": "OFF"/' "$project/CMakePresets.json"
configures again "another value in the presets"
sed -i '/"CS550_LTO"/d' "$project/CMakePresets.json"
configures afresh "a variable less in the presets, which CMake would keep"
printf 'debug | gdb | gdb | gdb | sh | debugger\n' >"$project/framework/cli/packages.txt"
configures not "a package that is installed"
printf 'bench | libwhat | - | - | %s | timing\n' "$scratch/missing" >"$project/framework/cli/packages.txt"
configures afresh "a package that is no longer there"
: >"$scratch/missing"
configures again "a package that was installed by hand"
rm "$project/build/test/.configured"
configures again "configured by CMake alone"
: >"$project/unconfigurable"
! CS550_WERROR=ON "$project/cs550" build test >"$scratch/printed" 2>&1 || wrong "it built what cannot be configured"
rm "$project/unconfigurable"
configures again "it failed to be configured again" CS550_WERROR=ON
rm "$project/build/test/build.ninja"
configures afresh "it failed to be configured the first time"
echo "CMAKE_HOME_DIRECTORY:INTERNAL=/elsewhere" >"$project/build/test/CMakeCache.txt"
rm "$project/build/test/.configured"
configures afresh "a copy of another folder"
cp "$root/CMakePresets.json" "$project"
: >"$project/framework/cli/packages.txt"
rm "$scratch/missing"

# Tools that are too old are named before CMake fails in its own words. A build that is configured asks nobody.
refuses() {
  rm -f "$project/build/test/build.ninja"
  ! env "$2" "$project/cs550" build test >"$scratch/printed" 2>&1 || wrong "it configured with $2"
  prints "$1"
  prints "Debian 12, Debian 13 and Ubuntu 24.04"
}
for compiler in g++ clang++; do
  printf '#!/bin/sh\n[ "$1" = -dumpversion ] && echo "$VERSION" || echo "%s $VERSION"\n' "${compiler%++}" \
    >"$scratch/bin/fake_$compiler"
  chmod +x "$scratch/bin/fake_$compiler"
done
refuses "cmake 3.22.1: 3.25 or later" CMAKE_VERSION=3.22.1
export VERSION=11
refuses "fake_g++ 11: g++ 12 or later" CXX=fake_g++
VERSION=9.0.1
refuses "fake_clang++ 9.0.1: clang++ 14 or later" CXX=fake_clang++
CMAKE_VERSION=3.22.1 CXX=fake_clang++ "$project/cs550" doctor >"$scratch/printed" 2>&1 || wrong "doctor failed"
prints "fake_clang++ 9.0.1: clang++ 14 or later"
prints "cmake 3.22.1: 3.25 or later"
for VERSION in 14 14.0.6 100.1; do
  configures afresh "clang++ $VERSION" CXX=fake_clang++
  rm "$project/build/test/build.ninja"
done
configures afresh "cmake 4.0" CMAKE_VERSION=4.0
configures not "cmake is older now" CMAKE_VERSION=3.22.1

# Neither the mark of a copied build nor a program that does not start hides that it must be built.
built=$project/build
"$project/cs550" progress --list >/dev/null
runs_after_build no
sed -i "1s|.*|root /elsewhere|" "$project/build/student/.configured"
runs_after_build yes
runs_after_build no
printf '#!/nowhere/sh\n' >"$built/student/bin/cs550"
: >"$scratch/configured"
! "$project/cs550" progress --list >"$scratch/printed" 2>&1 || wrong "a program ran that cannot"
grep -q -e '--fresh' "$scratch/configured" || wrong "a program that does not start was not built again"

# Errors name files relative to the project, and CMake's messages are left out.
: >"$project/broken"
! "$project/cs550" build test >"$scratch/printed" 2>&1 || wrong "a build that fails exited with code 0"
grep -qFx "In file included from labs/a.hpp:1," "$scratch/printed" || wrong "expected a relative path"
! grep -q GLOB "$scratch/printed" || wrong "it printed what CMake checks"
# The first error that stopped the build begins the excerpt, however many follow and whatever came before.
{
  echo "../../labs/lab4.cpp:1:1: error: of a lab that counts as empty"
  printf 'FAILED: lab5.o\nc++ -c lab5.cpp\n'
  echo "../../labs/lab5.cpp: In function 'void f()':"
  echo "../../labs/lab5.cpp:9:3: error: the first"
  seq -f "../../labs/lab5.cpp:%g:1: error: a later one" 10 99
} >"$project/broken"
! "$project/cs550" build test >"$scratch/printed" 2>&1 || wrong "a failed build counted as good"
[ "$(sed -n 1p "$scratch/printed")" = "labs/lab5.cpp: In function 'void f()':" ] || wrong "another first line"
prints "labs/lab5.cpp:9:3: error: the first labs/lab5.cpp:10:1: error: a later one"
prints "... and 52 more lines"
# What ran out of memory needs fewer jobs.
printf 'FAILED: a.o\nc++ -c a.cpp\nc++: fatal error: Killed signal terminated program cc1plus\n' >"$project/broken"
! "$project/cs550" build test >"$scratch/printed" 2>&1 || wrong "a failed build counted as good"
prints "CMAKE_BUILD_PARALLEL_LEVEL=1 ./cs550"
# It ends where the failed step does: other steps that are running then print their own.
{
  printf 'FAILED: lab3.o\nc++ -c lab3.cpp\n'
  echo "cc1plus: out of memory allocating 65536 bytes"
  echo "after a total of 0 bytes"
  echo "[7/9] Building CXX object lab4.o"
  echo "../../labs/lab4.cpp:3:1: error: of a lab that counts as empty"
  echo "ninja: build stopped: subcommand failed."
} >"$project/broken"
! "$project/cs550" build test >"$scratch/printed" 2>&1 || wrong "a failed build counted as good"
[ "$(sed -n 1p "$scratch/printed")" = "cc1plus: out of memory allocating 65536 bytes" ] || wrong "another first line"
! grep -qF lab4 "$scratch/printed" || wrong "it printed the error of another step"
rm "$project/broken"

# A second build waits for the first, and then succeeds.
mkfifo "$scratch/pipe"
exec 8>"$project/build/test/.lock"
flock 8
(code=0; "$project/cs550" build test 8>&- 2>&1 || code=$?; echo "exit $code") >"$scratch/pipe" &
exec 7<"$scratch/pipe"
read -r first <&7
case $first in
  'Waiting for another ./cs550, which is building in '*) ;;
  *) echo "WRONG: a second build printed '$first'" >&2; exit 1 ;;
esac
flock -u 8
read -r built <&7
[ "$built" = "Built everything (test)." ] || { echo "WRONG: the build that waited printed '$built'" >&2; exit 1; }
read -r last <&7
[ "$last" = "exit 0" ] || { echo "WRONG: the build that waited printed '$last'" >&2; exit 1; }

# It prints what was built, and how a program is run from the current folder. For a program that builds it prints nothing.
mkdir -p "$project/build/student/bin"
printf '#!/bin/sh\necho "own tests"\n' >"$project/build/student/bin/own_tests"
chmod +x "$project/build/student/bin/own_tests"
(cd "$project/labs" && ../cs550 build student own_tests lab3_student) >"$scratch/printed" 2>&1 || wrong "the build failed"
prints "Built own_tests lab3_student (student). To run own_tests:   '$scratch/a project"
# The printed command runs, also in a path with spaces, and in the program's own folder.
for folder in labs build/student/bin; do
  (cd "$project/$folder" && "$project/cs550" build student own_tests) >"$scratch/printed" 2>&1 || wrong "the build failed"
  command=$(tail -n 1 "$scratch/printed")
  [ "$(cd "$project/$folder" && eval "$command")" = "own tests" ] || wrong "in $folder the command does not run: $command"
done
(cd "$project" && ./cs550 build student own_tests) >"$scratch/printed" 2>&1 || wrong "the build failed"
grep -qFx "  build/student/bin/own_tests" "$scratch/printed" || wrong "the path is not relative"
CS550_ROOT=$project "$project/cs550" build student own_tests >"$scratch/printed" 2>&1 || wrong "the build failed"
! grep -q Built "$scratch/printed" || wrong "it printed what a program built"

# --help builds nothing. Before the first build it prints the arguments; then the program with the options prints them.
rm -rf "$project/build/release" "$project/build/student/bin/cs550"
for verb in lab view; do
  "$project/cs550" $verb --help >"$scratch/printed" 2>&1 || wrong "$verb --help failed"
  prints "Usage: ./cs550 $verb "
  prints "Once ./cs550 $verb has run, --help explains each option."
  ! grep -qE '^.{81}' "$scratch/printed" || wrong "a line of $verb --help has more than 80 columns"
done
mkdir -p "$project/build/release/bin"
printf '#!/bin/sh\necho "the viewer: $*"\n' >"$project/build/release/bin/cs550_viewer"
chmod +x "$project/build/release/bin/cs550_viewer"
"$project/cs550" view --help >"$scratch/printed" 2>&1 || wrong "view --help failed"
[ "$(cat "$scratch/printed")" = "the viewer: --help" ] || wrong "the viewer's help comes from elsewhere"

# The book is built by one at a time, too.
mkdir -p "$project/docs" "$project/build/release/bin"
printf '#!/bin/sh\necho "the book"\n' >"$project/docs/build_book.sh"
chmod +x "$project/docs/build_book.sh"
exec 8>"$project/build/.lock"
flock 8
"$project/cs550" docs 8>&- >"$scratch/printed" 2>&1 &
waiting=$!
until grep -qF "Waiting for another ./cs550, which is building in $project/build." "$scratch/printed"; do
  kill -0 $waiting 2>/dev/null || wrong "docs did not wait for another"
  sleep 0.05
done
! grep -qF "the book" "$scratch/printed" || wrong "two built the book at once"
flock -u 8
wait $waiting || wrong "docs failed after it had waited"
prints "the book"

# Without locks it builds, and says so: it does not wait for nobody.
cat >"$scratch/bin/flock" <<'FAKE'
#!/bin/sh
echo "flock: 9: No locks available" >&2
exit 71
FAKE
chmod +x "$scratch/bin/flock"
builds_in "$project"
prints "Cannot lock $project/build/test with flock"
! grep -qF Waiting "$scratch/printed" || wrong "it waited without a lock"
rm "$scratch/bin/flock"

# CS550_BUILD_DIR gets a subfolder of links to the project. What else is in the folder stays as it is.
CS550_BUILD_DIR=$scratch/elsewhere
export CS550_BUILD_DIR
mkdir "$CS550_BUILD_DIR"
for name in README.md .gitignore cs550; do echo "the user's" >"$CS550_BUILD_DIR/$name"; done
"$project/cs550" help >/dev/null
"$project/cs550" build test >"$scratch/printed" 2>&1 || wrong "the build failed"
links=$(echo "$CS550_BUILD_DIR"/cs550-*)
builds_in "$links"
for name in README.md .gitignore cs550; do
  [ ! -L "$CS550_BUILD_DIR/$name" ] && [ "$(cat "$CS550_BUILD_DIR/$name")" = "the user's" ] ||
    wrong "it replaced the user's file $name"
done
[ -e "$links/framework/cli/verbs.def" ] || wrong "the folder has no links to the project"
rm "$links/CMakeLists.txt"
echo "the user's" >"$links/CMakeLists.txt"
! "$project/cs550" help >"$scratch/printed" 2>&1 || wrong "it accepted a file in the place of a link"
prints "$links/CMakeLists.txt is not a link to $project/CMakeLists.txt"
[ "$(cat "$links/CMakeLists.txt")" = "the user's" ] || wrong "it replaced a file in its own folder"
rm "$links/CMakeLists.txt"

# The name for submissions is only used from the project itself.
echo Ada >"$project/.student"
echo Grace >"$links/.student"
builds_in "$links"
rm "$project/.student"

# A folder of the project, and one in which CMake cannot build, are refused.
for refused in "$project" "$project/framework" "$scratch/glob*"; do
  code=0
  CS550_BUILD_DIR=$refused "$project/cs550" help >"$scratch/printed" 2>&1 || code=$?
  [ "$code" = 2 ] || wrong "exit code $code for CS550_BUILD_DIR=$refused"
  prints "CS550_BUILD_DIR names a folder in"
  prints "$refused"
  [ -z "$(find "$project" "$refused" -type l)" ] || wrong "it made links in $refused"
done
(cd "$project" && ! CS550_BUILD_DIR=. ./cs550 help >"$scratch/printed" 2>&1) || wrong "it accepted CS550_BUILD_DIR=."
unset CS550_BUILD_DIR

# What another user built cannot be built on: that happens after sudo ./cs550.
rm "$project/build/test/.lock"
mkdir "$project/build/test/.lock"  # not even root can write to it
! "$project/cs550" build test >"$scratch/printed" 2>&1 || wrong "it built without a lock"
prints "cannot write $project/build/test/.lock"
! grep -qF sudo "$scratch/printed" || wrong "it advised to change the owner of the user's own file"
if chown 12345 "$project/build/test/.lock" 2>/dev/null; then
  ! "$project/cs550" build test >"$scratch/printed" 2>&1 || wrong "it built without a lock"
  prints "It belongs to another user. To make it yours: sudo chown -R $(id -un) '$scratch/a project"
fi
rm -r "$project/build/test/.lock"

# The user root may write to folders that forbid it, but not make a folder of a file.
rm -r "$project/build"
: >"$project/build"
"$project/cs550" build test >"$scratch/printed" 2>&1 || wrong "the build failed"
prints "The project cannot be written to. Building in $scratch/cache/cs550/"
grep -qF "built in $scratch/cache/cs550/" "$scratch"/cache/cs550/*/build/test.log || wrong "it built elsewhere"

# A program that runs the launcher again has the folder of links as its root: the line is not printed twice.
links=$(echo "$scratch"/cache/cs550/*)
CS550_ROOT=$links "$links/cs550" build test >"$scratch/printed" 2>&1 || wrong "the build failed"
! grep -qF "cannot be written to" "$scratch/printed" || wrong "it repeated why it builds elsewhere"

# It builds elsewhere in a path that CMake cannot handle, too.
for odd in 'semi;colon' 'quo"te' 'dol$lar' 'hash#' 'back\slash' 'brack[et' 'brack]et' 'aster*isk' 'question?' 'com,ma' 'co:lon' 'line
break'; do
  cp -r "$project" "$scratch/$odd"
  rm "$scratch/$odd/build"
  "$scratch/$odd/cs550" build test >"$scratch/printed" 2>&1 || wrong "the build failed in $odd"
  prints "CMake cannot build in a path with"
done

# builds_below FOLDER [NAME=VALUE]...: where the project is built with other caches.
builds_below() {
  folder=$1
  shift
  (cd "$scratch" && env "$@" "$project/cs550" build test >"$scratch/printed" 2>&1) || wrong "the build failed with $*"
  prints "Building in $folder/"
}
builds_below "$scratch/home/.cache/cs550" XDG_CACHE_HOME=relative HOME="$scratch/home"
builds_below "$scratch/home/.cache/cs550" XDG_CACHE_HOME="$scratch/semi;colon" HOME="$scratch/home"
own=cs550-$(id -u)
mkdir "$scratch/temporary"
builds_below "$scratch/temporary/$own" -u XDG_CACHE_HOME -u HOME TMPDIR="$scratch/temporary"
[ "$(stat -c %a "$scratch/temporary/$own")" = 700 ] || wrong "others may write to the folder for temporary files"
[ ! -e "$scratch/relative" ] || wrong "it used a relative XDG_CACHE_HOME"
if chown 12345 "$scratch/temporary/$own" 2>/dev/null; then
  ! env -u XDG_CACHE_HOME -u HOME TMPDIR="$scratch/temporary" "$project/cs550" build test >"$scratch/printed" 2>&1 ||
    wrong "it built in a folder of another user"
  prints "cannot create $scratch/temporary/$own as a folder of your own"
fi

# Without a terminal, packages are installed only by a sudo that asks for no password, as on build services.
mkdir "$scratch/service"
cat >"$scratch/service/id" <<'FAKE'
#!/bin/sh
echo 1000
FAKE
cat >"$scratch/service/sudo" <<'FAKE'
#!/bin/sh
[ "$1" != -n ] || exit "$ASKS"
touch "$INSTALLED"
FAKE
printf '#!/bin/sh\n' >"$scratch/service/apt-get"
chmod +x "$scratch/service/"*
installs() {
  printf 'build | libwhat-dev | what | what | %s | for the test\n' "$scratch/installed" >"$project/framework/cli/packages.txt"
  env ASKS="$1" INSTALLED="$scratch/installed" PATH="$scratch/service:$PATH" "$project/cs550" doctor --install build \
    >"$scratch/printed" 2>&1 </dev/null
}
! installs 1 || wrong "it installed packages with a sudo that asks for a password"
prints "there is no terminal to ask"
installs 0 || wrong "it did not install packages with a sudo that asks for no password"
[ -e "$scratch/installed" ] || wrong "it did not call sudo"

# The book is built without its PDF if Chromium cannot be installed.
printf '#!/bin/sh\necho "Package: chromium"\n' >"$scratch/service/apt-cache"
chmod +x "$scratch/service/apt-cache"
printf 'pdf | chromium | - | - | %s | the PDF\n' "$scratch/absent" >"$project/framework/cli/packages.txt"
env ASKS=1 PATH="$scratch/service:$PATH" "$project/cs550" docs >"$scratch/printed" 2>&1 </dev/null ||
  wrong "without Chromium, docs failed"
prints "Continuing without the PDF."
prints "the book"
: >"$project/framework/cli/packages.txt"

XDG_CACHE_HOME=$project/cs550
! "$project/cs550" build test >"$scratch/printed" 2>&1 || wrong "it built without a folder to write to"
prints "cannot create $project/cs550/cs550/"
prints "CS550_BUILD_DIR=FOLDER"
