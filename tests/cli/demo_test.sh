#!/bin/sh
# demo_test.sh PROGRAM ROOT SCRATCH
# The options of demo that change the settings of a scene.
set -eu
program=$1 scratch=$3
export CS550_ROOT=$2
rm -rf "$scratch"
mkdir -p "$scratch"
cd "$scratch"

wrong() { echo "WRONG: $1" >&2; cat printed >&2; exit 1; }
cat >scene.json <<'END'
{ "schema": 1, "title": "A cube at rest", "steps": 60,
  "bodies": [
    { "name": "floor", "kind": "static", "position": [0, 0, -0.5],
      "shape": { "kind": "box", "half_extents": [4, 4, 0.5] } },
    { "name": "cube", "position": [0, 0, 0.5],
      "shape": { "kind": "box", "half_extents": [0.5, 0.5, 0.5] } } ] }
END
demo() { "$program" scene.json --no-picture "$@" >printed 2>&1; }

for switch in "" "--sleeping on"; do
  demo $switch || wrong "demo $switch failed"
  grep -q "^asleep *1 at the end" printed || wrong "demo $switch: the cube should sleep"
done
demo --sleeping off || wrong "demo --sleeping off failed"
if grep -q "^asleep" printed; then wrong "nothing sleeps with --sleeping off"; fi

demo --help || wrong "demo --help failed"
if grep -E '^.{81}' printed; then wrong "--help prints lines of more than 80 columns"; fi

# --quality determines the settings as "quality" in the scene does.
hash_of() { demo --sleeping off "$@" || wrong "demo $* failed"; sed -n 's/^state hash  *//p' printed; }
own=$(hash_of)
game=$(hash_of --quality game)
[ -n "$own" ] || wrong "expected a state hash"
[ "$(hash_of --quality accurate)" = "$own" ] || wrong "accurate is the default"
[ "$game" != "$own" ] || wrong "--quality game changed nothing"
sed -i 's/"steps": 60,/"steps": 60, "world": { "quality": "game" },/' scene.json
[ "$(hash_of)" = "$game" ] || wrong "a scene of quality game and --quality game should do the same"
[ "$(hash_of --quality accurate)" = "$own" ] || wrong "--quality should win over the scene's"
[ "$(hash_of --threads 2)" = "$(hash_of)" ] || wrong "two threads leave another state than one"

# A scene states the bound on penetration for its own settings.
sed 's/"steps": 60,/"steps": 60, "max_penetration": 1e-9,/' scene.json >strict.json
strict() {
  code=0
  "$program" strict.json --no-picture "$@" >printed 2>&1 || code=$?
}
strict
[ $code = 1 ] || wrong "a cube deeper than the scene's bound: exit code $code, expected 1"
grep -q "exceeds the scene's bound" printed || wrong "expected that the bound was exceeded"
strict --quality game
[ $code = 1 ] || wrong "--quality game is the scene's own: exit code $code, expected 1"
strict --quality accurate
[ $code = 0 ] || wrong "the bound holds for the scene's own quality: exit code $code, expected 0"
if grep -q "bound" printed; then wrong "no bound is stated for another quality"; fi

# The first line of a body has the velocities that the scene gives it. They are computed from momenta in float: numbers
# up to 4 are off by rounding, less than 1e-5.
cat >thrown.json <<'END'
{ "schema": 1, "title": "A box is thrown", "steps": 1,
  "bodies": [
    { "name": "box", "position": [0, 0, 2], "orientation": { "axis": [1, 2, 3], "degrees": 40 },
      "linear_velocity": [1, -2, 0.5], "angular_velocity": [0.25, 3, -4],
      "shape": { "kind": "box", "half_extents": [0.5, 0.3, 0.2] } } ] }
END
"$program" thrown.json --no-picture --csv thrown.csv >printed 2>&1 || wrong "demo --csv failed"
sed -n 2p thrown.csv >printed
awk -F , '{ split("1 -2 0.5 0.25 3 -4", v, " ")
            for (i = 1; i <= 6; ++i) { d = $(11 + i) - v[i]; if (d * d > 1e-10) exit 1 } }' printed ||
  wrong "expected the velocities of the scene in the line of step 0"

# An absent scene, and a title that is longer than a line.
code=0
"$program" stack11 >printed 2>&1 || code=$?
[ $code = 2 ] || wrong "an absent scene: exit code $code, expected 2"
grep -q 'there is no scene "stack11" (did you mean "stack10"?)' printed || wrong "expected the nearest name"
if grep -E '^.{81}' printed; then wrong "an absent scene prints lines of more than 80 columns"; fi
sed "s/A cube at rest/$(printf 'a cube %.0s' $(seq 30))/" scene.json >long.json
"$program" long.json --no-picture >printed 2>&1 || wrong "a scene with a long title failed"
if grep -E '^.{81}' printed; then wrong "demo prints lines of more than 80 columns"; fi

misused() {
  code=0
  demo "$1" "$2" || code=$?
  [ $code = 2 ] || wrong "demo $1 $2 exited with code $code, expected 2"
  tr '\n' ' ' <printed | grep -qF -- "$3" || wrong "expected in the message: $3"
}
misused --sleeping maybe "'maybe' is neither on nor off"
misused --quality best "'best' is neither accurate nor game"
misused --csv "" "--csv: expected the path of a file or folder, found an empty text"
misused --csv "$(printf 'x%.0s' $(seq 300))" "found 300 letters"
misused --threads=2 --no-picture=5 "--no-picture takes no value"
misused --threads 0 "--threads needs a whole number from 1 to 16, found 0"

# The picture is of the run: a project whose viewer prints its arguments and fails. Without a viewer there is none.
mkdir -p project/build/release/bin
printf '#!/bin/sh\n' >project/cs550
printf '#!/bin/sh\necho "$@"\nexit 1\n' >project/build/release/bin/cs550_viewer
chmod +x project/cs550 project/build/release/bin/cs550_viewer
pictured() {
  CS550_ROOT=$scratch/project "$program" scene.json "$@" >printed 2>&1 || wrong "demo $* failed"
  if grep -q "^For a picture" printed; then return; fi
  cp project/build/results/scene.png.txt printed
  for word in $words; do grep -q -- "$word" printed || wrong "demo $*: expected $word for the viewer"; done
}
words="sleeping=on" pictured
words="sleeping=off quality=game" pictured --quality game --sleeping off
words="quality=accurate" pictured --quality accurate
