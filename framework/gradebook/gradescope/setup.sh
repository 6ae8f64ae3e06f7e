#!/bin/sh
# Gradescope runs this once, as root, when it builds the image of the autograder. It builds the judges, grades the
# reference, which must earn every point, and then removes what no submission may see.
set -eu
autograder=${CS550_AUTOGRADER:-/autograder}
cd "$autograder/source"
chmod 700 .  # submissions run as another user

./cs550 doctor --install build
./cs550 doctor --install grade
# shellcheck disable=SC2046  # several words
./cs550 build test $(cat targets.txt)

mkdir -p reference/labs
cp -R solutions/* reference/labs
find reference -type d -name fast -prune -exec rm -r {} +
./grade.sh reference reference.json
field() { sed -n "s/^ \"$1\": \([0-9.]*\),\$/\1/p" reference.json; }
if [ "$(field score)" != "$(field max_score)" ]; then
  echo "setup.sh: the reference earns $(field score) of $(field max_score) points on this image:" >&2
  cat reference.json >&2
  exit 1
fi
rm -r solutions reference reference.json tests/mutants tests/*/hidden
