#!/bin/sh
# course_update_test.sh PROGRAM ROOT SCRATCH
# A published copy is updated, and a student with work in a clone of it pulls: files that were corrected are
# replaced, those that are gone are removed, all others and the student's work stay.
set -eu
program=$1 root=$2 scratch=$3
rm -rf "$scratch"
mkdir -p "$scratch"
export CS550_ROOT="$root" GIT_AUTHOR_NAME=a GIT_AUTHOR_EMAIL=a@b GIT_COMMITTER_NAME=a GIT_COMMITTER_EMAIL=a@b
copy=$scratch/copy student=$scratch/student printed=$scratch/printed
handout=labs/lab3_hill_climbing/README.md work=labs/lab3_hill_climbing/hill_climbing.cpp

wrong() { echo "WRONG: $1" >&2; exit 1; }
# Warnings are about the project, also where it is used through links, as with CS550_BUILD_DIR.
git clone --quiet "$root" "$scratch/project"
mkdir "$scratch/links"
for file in "$scratch/project"/* "$scratch/project"/.[!.]*; do ln -s "$file" "$scratch/links"; done
CS550_ROOT=$scratch/links "$program" starter "$scratch/linked" >/dev/null 2>"$printed"
! grep -qF Warning "$printed" || wrong "it warns of changes in a project that has none"
echo changed >>"$scratch/project/README.md"
CS550_ROOT=$scratch/links "$program" starter "$scratch/changed" >/dev/null 2>"$printed"
grep -qF "Warning: uncommitted changes" "$printed" || wrong "it must warn of a change"

"$program" starter "$copy" >"$printed" 2>/dev/null
grep -qxF "It has no solutions." "$printed" || wrong "it must report that it released nothing"
! grep -qF figures "$printed" || grep -qF "./cs550 starter --update '$copy'" "$printed" ||
  wrong "the command that adds figures must name the folder"
"$program" starter --update "$copy" >"$printed" 2>/dev/null
[ -z "$(git -C "$copy" status --porcelain)" ] || wrong "an update to the same version changes the copy"
grep -qF "0 files added, 0 replaced, 0 removed" "$printed" || wrong "it must replace nothing"

# Where the book is not built, an update keeps the figures that a copy has.
mkdir "$scratch/linked/docs/chapters/figures"
echo drawn >"$scratch/linked/docs/chapters/figures/a.svg"
echo docs/chapters/figures/a.svg >>"$scratch/linked/.starters/files.txt"
for i in 1 2; do
  CS550_ROOT=$scratch/links "$program" starter --update "$scratch/linked" >"$printed" 2>/dev/null
  [ -e "$scratch/linked/docs/chapters/figures/a.svg" ] || wrong "update $i removes a figure"
  grep -qF "keeps the figures" "$printed" || wrong "it must report that the figures are old"
done

# As if the copy were an older version.
echo 'an old handout' >"$copy/$handout"
echo 'an old page' >"$copy/docs/old_page.md"
echo docs/old_page.md >>"$copy/.starters/files.txt"
rm "$copy/LICENSE"
git -C "$copy" add --all
git -C "$copy" commit --quiet --message 'As published'
git clone --quiet "$copy" "$student"
echo '// my work' >>"$student/$work"
git -C "$student" commit --quiet --all --message 'My work'

"$program" starter --update "$copy" >"$printed" 2>/dev/null
grep -qxF "added: LICENSE" "$printed" || wrong "it must list what it adds"
grep -qxF "replaced: $handout" "$printed" || wrong "it must list what it replaces"
grep -qxF "removed: docs/old_page.md" "$printed" || wrong "it must list what it removes"
git -C "$copy" add --all
git -C "$copy" commit --quiet --message 'A corrected handout'
git -C "$student" pull --quiet --no-rebase --no-edit
git -C "$student" diff --quiet HEAD || wrong "the pull leaves changes"
cmp "$student/$handout" "$root/$handout" || [ -n "$(git -C "$root" status --porcelain "$handout")" ] ||
  wrong "the student has not received the handout"
[ ! -e "$student/docs/old_page.md" ] || wrong "the student still has the page"
tail -n 1 "$student/$work" | grep -qxF '// my work' || wrong "the student's work is lost"
[ "$(git -C "$student" ls-files | wc -l)" = "$(git -C "$copy" ls-files | wc -l)" ] || wrong "files are missing"

# An update that ended after it had replaced a lab file, and before its starter, goes on where it ended.
axis=lab4_separating_axis/separating_axis.cpp
echo '// an older starter' >>"$copy/.starters/$axis"
"$program" starter --update "$copy" >"$printed" 2>/dev/null || wrong "a new lab file is no conflict"
! grep -qF conflict "$printed" || wrong "it reports a conflict with a file that nobody changed"
grep -qF "0 changed lab files kept" "$printed" || wrong "it counts a new lab file as changed"
cmp "$copy/.starters/$axis" "$copy/labs/$axis" || wrong "the starter is old"

# A file that cannot be replaced leaves no draft.
rm "$copy/$handout"
mkdir "$copy/$handout"
touch "$copy/$handout/file"
! "$program" starter --update "$copy" >"$printed" 2>&1 || wrong "it replaced a folder by a file"
[ ! -e "$copy/$handout.new" ] || wrong "it left a draft"

# Ctrl-C removes the draft of a copy.
"$program" starter "$scratch/interrupted" >"$printed" 2>&1 &
until ls -d "$scratch"/interrupted.partial-* >/dev/null 2>&1; do sleep 0.02; done
kill -INT $!
code=0
wait $! || code=$?
[ $code = 1 ] || wrong "after Ctrl-C the exit code is $code, expected 1"
grep -qF "interrupted: what was unfinished is removed" "$printed" || wrong "it printed $(cat "$printed")"
[ -z "$(ls -d "$scratch"/interrupted* 2>/dev/null)" ] || wrong "it left $(ls -d "$scratch"/interrupted*)"

# What SIGKILL leaves, the next run removes.
"$program" starter "$scratch/killed" >"$printed" 2>&1 &
until ls -d "$scratch"/killed.partial-* >/dev/null 2>&1; do sleep 0.02; done
kill -KILL $!
wait $! || true
draft=$(ls -d "$scratch"/killed.partial-*)
"$program" starter "$scratch/killed" >/dev/null 2>"$printed" || wrong "it does not start again after SIGKILL"
grep -qxF "Removed $draft, which a killed run had left." "$printed" || wrong "it must report what it removed"
[ "$(echo "$scratch"/killed*)" = "$scratch/killed" ] || wrong "there is $(echo "$scratch"/killed*)"

# The scripts that compute stages again from the book belong to the last solution.
"$program" starter --release-solutions 6 "$scratch/six" >"$printed" 2>/dev/null
grep -qxF "It has the solutions of labs 1 to 6." "$printed" || wrong "it must report what it released"
[ ! -e "$scratch/six/docs/rebuild" ] || wrong "docs/rebuild is released before lab 7"
"$program" starter --release-solutions 7 "$scratch/seven" >/dev/null 2>&1
[ -s "$scratch/seven/docs/rebuild/stack.py" ] || wrong "docs/rebuild is not released with lab 7"
[ -d "$(echo "$scratch"/seven/solutions/lab7_*)" ] || wrong "the solution of lab 7 is not released"

# An update keeps the solutions that are released, unless it is told another number.
"$program" starter --update "$scratch/six" >"$printed" 2>/dev/null
[ -z "$(git -C "$scratch/six" status --porcelain)" ] || wrong "an update takes released solutions back"
grep -qxF "It has the solutions of labs 1 to 6." "$printed" || wrong "it must report which solutions it keeps"
"$program" starter --update --release-solutions 1 "$scratch/six" >"$printed" 2>/dev/null
grep -qxF "It has the solution of lab 1." "$printed" || wrong "it must report the only solution"
[ -z "$(ls -A "$(echo "$scratch"/six/solutions/lab6_*)" 2>/dev/null)" ] || wrong "the solution of lab 6 is still there"
"$program" starter --update --release-solutions 0 "$scratch/six" >"$printed" 2>/dev/null
grep -qxF "It has no solutions." "$printed" || wrong "no solution is left"
rm -rf "$scratch"
