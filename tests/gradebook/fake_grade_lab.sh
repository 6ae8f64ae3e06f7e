#!/bin/sh
# fake_grade_lab.sh N --submission FOLDER --work FOLDER --results FILE ...
# fake_grade_lab.sh --probe KIND
# Takes the place of grade_lab: writes a result of the same form, without compiling anything. Comments in the
# submission decide it:
#   // fake: fails NAME      the test LabN.NAME fails
#   // fake: no compile      every test is not_compiled
#   // fake: compiler stopped      every test is a timeout
#   // fake: breaks          the grader itself fails
#   // fake: sleeps SECONDS
#   // fake: catches NUMBER           with --own-tests, of 20 mistakes; without it, the reference fails
#   // fake: own compiler stopped     with --own-tests, the compiler was stopped
#   // fake: own tests time out       with --own-tests, a run on the reference was stopped
#   // fake: times out NAME            the test LabN.NAME has status timeout
#   // fake: own tests break          with --own-tests, the grader itself fails
#   // fake: misses lab3_ghosts      with --milestones, that milestone is not reached
if [ "$1" = --probe ]; then
  [ -z "${FAKE_UNPROTECTED-}" ] || { echo "no isolation works" >&2; exit 1; }
  echo fake
  exit
fi
lab=$1
shift
while [ $# -gt 0 ]; do
  case $1 in
    --milestones) milestones=yes; shift; continue ;;
    --own-tests) own_tests=yes; shift; continue ;;
    --challenge) challenge=yes; shift; continue ;;
    --submission) submission=$2 ;;
    --results) results=$2 ;;
    --work) work=$2 ;;
    --salt) salt=$2 ;;
  esac
  shift 2
done
root=$(dirname "$0")/../..
told=$(find "$submission" -type f -exec sed -n 's/.*fake: //p' {} +)
case $told in
  *'own tests break'*) [ -z "${own_tests-}" ] || { echo "the fake has no mistakes" >&2; exit 1; } ;;
  *breaks*) echo "the fake was told to break" >&2; exit 1 ;;
  *sleeps*) sleep "${told##*sleeps }" ;;
esac
: >"$work/touched"
if [ -n "${own_tests-}" ]; then
  [ -z "${FAKE_LOG-}" ] || echo "own tests $lab" >>"$FAKE_LOG"
  caught=${told##*catches } failures=0 compiled=true stopped=false
  case $told in
    *'own compiler stopped'*) caught=0 compiled=false stopped=true ;;
    *'own tests time out'*) caught=0 failures=1 stopped=true ;;
    *catches*) ;;
    *) caught=0 failures=1 ;;
  esac
  printf '{"lab":%d,"isolation":"fake","compiled":%s,"stopped":%s,"message":"it fails on the reference: %s",
    "mistakes":20,"caught":%d,"reference_runs":10,"reference_failures":%d}\n' \
    "$lab" "$compiled" "$stopped" "$told" "$caught" "$failures" >"$results"
  exit
fi
if [ -n "${milestones-}" ]; then
  [ -z "${FAKE_LOG-}" ] || echo "milestones $(ls "$submission" | tr '\n' ' ')" >>"$FAKE_LOG"
  tests=
  for record in "$root"/framework/assets/trajectories/lab[1-"$lab"]_*; do
    name=$(basename "$record" .csv)
    status=passed
    case $told in *"misses $name"*) status=failed ;; esac
    tests="$tests${tests:+,}{\"name\":\"Milestone.$name\",\"step\":\"L\",\"points\":0,\"earned\":0,
      \"status\":\"$status\",\"hidden\":false,\"seconds\":0.25,\"message\":\"\"}"
  done
  printf '{"lab":0,"isolation":"fake","compiler":"fake 1.0","seed":"published",
    "compile":{"ok":true,"seconds":1.5,"errors":""},"tests":[%s]}\n' "$tests" >"$results"
  exit
fi
[ -z "${FAKE_LOG-}" ] || echo "lab $lab" >>"$FAKE_LOG"
printf '%s\n' "$told" | awk -v lab="$lab" -v seed="${salt:+salt }${salt:-published}" -v challenge="${challenge-}" '
  FILENAME == "-" { if ($1 == "fails") fails[$2] = 1; if ($1 == "times") late[$3] = 1; if ($0 == "no compile") broken = 1; if ($1 == "compiler") stopped = 1; next }
  /"name":/ { split($0, part, "\""); name = part[4] }
  /"points": [0-9]/ { gsub(/[^0-9]/, ""); points = $0 }
  /"step":/ { split($0, part, "\""); step = part[4] }
  /"hidden": (true|false)/ {
    hidden = /true/ ? "true" : "false"
    status = broken ? "not_compiled" : stopped ? "timeout" : (name in fails) ? "failed" : (name in late) ? "timeout" : "passed"
    tests = tests (tests ? ",\n" : "") sprintf("{\"name\":\"Lab%d.%s\",\"step\":\"%s\",\"points\":%d,\"earned\":%d," \
      "\"status\":\"%s\",\"hidden\":%s,\"seconds\":0.25,\"message\":\"%s\"}", lab, name, step, points,
      status == "passed" ? points : 0, status, hidden, status == "failed" ? "expected 1 m, got <b>2</b> m" : "")
  }
  END {
    printf "{\"lab\":%d,\"isolation\":\"fake\",\"compiler\":\"fake 1.0\",\"seed\":\"%s\",", lab, seed
    printf "\"compile\":{\"ok\":%s,\"seconds\":1.5,\"errors\":\"%s\"},\n", broken || stopped ? "false" : "true",
      broken ? "a.cpp:1: error: expected <;>" : stopped ? "the compiler was stopped" : ""
    if (challenge) printf "\"challenge\":[{\"what\":\"things\",\"better\":\"fewer\",\"count\":42}],\n"
    printf "\"tests\":[%s]}\n", tests
  }' - "$root"/tests/lab"$lab"_*/manifest.json >"$results"
