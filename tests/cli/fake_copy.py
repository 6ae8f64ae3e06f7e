#!/usr/bin/env python3
"""Stands in for everything that ./cs550 lab and progress build and run in a students' copy, so that tests of
them compile nothing. It is called by several names:

  cs550 build PRESET TARGET   "builds" TARGET: a link to this file. Fails if a file of its lab has NO_CODE in it.
                              Takes 3 s for LONG_CODE, with five warnings of the compiler. Fails if the project has a
                              file disk_is_full. For SAVED_MEANWHILE the lab is saved with WRONG in it, which is too
                              late for the program.
  labN_student ...            the graded tests of lab N. All fail if a file of the lab, or of an earlier lab that
                              the test calls, has WRONG in it, with a picture, or if the lab is a starter. With
                              CRASH the program crashes. They are blocked if the earlier lab has NO_CODE in it.
  labN_student --challenge    a count of 42, and a line before it if the lab has PRINTS in it
  milestones_... --lab N      the student's engine: fails if a file of labs 1 to N has WRONG in it, crashes for CRASH,
                              makes no step for ENDLESS, and a step in 0.2 s for 4 s for SLOW. Prints more than the
                              64 MB that it may for FLOOD.
  gdb ...                     prints GDB and the name of the program that it is to run.
"""

import json
import os
import re
import sys
import time
from pathlib import Path

ROOT = Path(os.environ["CS550_ROOT"])
TOO_LATE = ROOT / "saved_too_late"  # exists if the program that was built last is older than its lab


def folder(lab):
    found, = (ROOT / "tests").glob(f"lab{lab}_*")
    return found


def has(word, lab):
    files = (ROOT / "labs" / folder(lab).name).rglob("*")
    return any(word in file.read_text() for file in files if file.suffix in (".cpp", ".hpp", ".h"))


def log(text):
    (ROOT / "build/student.log").write_text(text)


def save_meanwhile(lab):
    TOO_LATE.unlink(missing_ok=True)
    if lab and has("SAVED_MEANWHILE", lab):
        for file in (ROOT / "labs" / folder(lab).name).glob("*.cpp"):
            file.write_text("// WRONG\n")
        TOO_LATE.touch()


def build(target):
    lab = re.match(r"lab(\d)_", target)
    save_meanwhile(lab and lab[1])
    if lab and has("NO_CODE", lab[1]):
        log("[1/2] Building\nFAILED: lab.o\nc++ -c\n../../labs/lab.cpp:7:1: error: expected ';'\n")
        return 1
    if (ROOT / "disk_is_full").exists():
        log("[1/2] Building\nFAILED: a.o\nc++ -c\n../../labs/lab.cpp:60:1: fatal error: error writing to a.s: "
            "No space left on device\n")
        return 1
    log("ninja: no work to do.\n")
    if lab and has("LONG_CODE", lab[1]):
        warnings = [f"{ROOT}/labs/lab.cpp:{line}:1: warning: unused 'x'\n" for line in range(5)]
        log("[0/2] Checking\n[1/2] Building\n" + "".join(warnings))
        time.sleep(3)
    program = ROOT / "build/student/bin" / target
    program.parent.mkdir(parents=True, exist_ok=True)
    if not program.exists():
        program.symlink_to(ROOT / "cs550")
    return 0


def first_step(lab):
    return json.loads((folder(lab) / "manifest.json").read_text())["tests"][0]["step"]


def outcome(lab, name, called):
    if not TOO_LATE.exists() and (has("WRONG", lab) or any(has("WRONG", earlier) for earlier in called)):
        picture = ROOT / f"build/results/pictures/Lab{lab}.{name}.svg"
        picture.parent.mkdir(parents=True, exist_ok=True)
        picture.write_text('<svg xmlns="http://www.w3.org/2000/svg"/>')
        return {"status": "failed", "message": f"{name} is wrong"}
    if has("NotImplemented", lab):
        return {"status": "failed", "message": "not implemented: " + first_step(lab)}
    for earlier in called:
        if has("NO_CODE", earlier):
            step = first_step(earlier)
            return {"status": "blocked", "message": f"blocked by {step}", "blocked_by": step}
    return {"status": "passed", "message": ""}


def grade(lab, names, results):
    calls = json.loads((folder(lab) / "earlier_labs.json").read_text())
    rows = []
    for name in names:
        row = {"test": f"Lab{lab}.{name}", "status": "running", "message": "", "seconds": 0}
        rows.append(row)
        results.write_text(json.dumps({"tests": rows}))
        if has("CRASH", lab):
            os.abort()
        row.update(outcome(lab, name, calls.get(name, [])))
        results.write_text(json.dumps({"tests": rows}))
    return 0


def main():
    called_as, arguments = Path(sys.argv[0]).name, sys.argv[1:]
    if called_as == "cs550":
        return build(arguments[2]) if arguments[0] == "build" else 0
    if called_as == "gdb":
        print("GDB", Path(arguments[arguments.index("--args") + 1]).name)
        return 0
    if called_as.startswith("milestones_"):
        print("a scene" + " and many more words in its title" * 4, flush=True)
        labs = range(1, int(arguments[1]) + 1)
        if any(has("CRASH", lab) for lab in labs):
            os.abort()
        if any(has("ENDLESS", lab) for lab in labs):
            time.sleep(600)
        if any(has("FLOOD", lab) for lab in labs):
            print("x" * (65 << 20), flush=True)
        for _ in range(20 if any(has("SLOW", lab) for lab in labs) else 0):
            Path(arguments[arguments.index("--pulse") + 1]).write_text(".")
            time.sleep(0.2)
        return int(any(has("WRONG", lab) for lab in labs))
    if arguments[0] == "--challenge":
        if has("PRINTS", called_as[3]):
            print("climb")
        print(json.dumps([{"what": "things counted", "better": "fewer", "count": 42}]))
        return 0
    names = re.findall(r"Lab\d\.(\w+)", arguments[0])
    return grade(int(called_as[3]), names, Path(arguments[2]))


if __name__ == "__main__":
    sys.exit(main())
