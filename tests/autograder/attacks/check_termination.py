#!/usr/bin/env python3
"""SIGTERM ends grade_lab at once, with its compiler, judge and worker, and leaves nothing behind. It ends a run of
./cs550 grade, too, which stops the grade_lab of each lab."""

import argparse
import itertools
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from run_attacks import HERE, ROOT, become_subreaper, children, lab_folder, make_submission

SECONDS_TO_END = 2
BUSY_IN_COMPILER = "preprocessor_bomb"
BUSY_IN_WORKER = "never_returns"


def text_of(file):
    """Nothing, if the process of the file has ended meanwhile."""
    try:
        return file.read_text()
    except OSError:
        return ""


def descendants():
    """The names of all processes below this one."""
    names, parents = [], [os.getpid()]
    while parents:
        below = Path(f"/proc/{parents.pop()}/task").glob("*/children")
        for process in "".join(text_of(file) for file in below).split():
            names.append(text_of(Path(f"/proc/{process}/comm")).strip())
            parents.append(process)
    return names


def all_have_ended():
    """Whether no process is left, once those that lost their parent to us have been waited for."""
    try:
        while os.waitpid(-1, os.WNOHANG) != (0, 0):
            pass
    except ChildProcessError:
        pass
    return not children()


def wait_until(condition, seconds):
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            return False
        time.sleep(0.05)
    return True


def of_one_lab(build, attack, isolation, scratch):
    """The command that grades a submission."""
    make_submission(attack, scratch / "submission")
    return [build / "bin/grade_lab", str(attack["lab"]), "--submission", scratch / "submission", "--work",
            scratch / "work", "--results", scratch / "results.json", "--isolation", isolation]


def of_a_class(build, attack, isolation, scratch):
    """The same for a class of one student."""
    folder = scratch / "class" / "s0101" / "labs" / lab_folder(ROOT / "labs", attack["lab"]).name
    folder.parent.mkdir(parents=True)
    make_submission(attack, folder)
    return [build / "bin/cs550_grade", scratch / "class", "--out", scratch / "graded", "--labs", str(attack["lab"]),
            "--judge", build / "bin/grade_lab", "--isolation", isolation]


def faults(command, busy, scratch, to_all):
    """What is wrong after SIGTERM in the middle of a program whose name begins with `busy`, to the grader or to all its processes."""
    # Its own, since other graders may run at the same time.
    temporary = scratch / "temporary"
    temporary.mkdir()
    temporary.chmod(0o1777)
    # Without Git, `grade` also runs where somebody works on the labs.
    environment = {**os.environ, "TMPDIR": str(temporary), "CS550_ROOT": str(ROOT), "GIT_DIR": str(scratch / "no_git")}
    grader = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=environment,
                              start_new_session=True)
    if not wait_until(lambda: any(name.startswith(busy) for name in descendants()), 60):
        yield f"{busy} was never started"
    time.sleep(0.3)
    (os.killpg if to_all else os.kill)(grader.pid, signal.SIGTERM)
    try:
        if grader.wait(SECONDS_TO_END) != 1:
            yield f"exit code {grader.returncode}, not 1"
    except subprocess.TimeoutExpired:
        yield f"it still runs after {SECONDS_TO_END} s"
        grader.kill()
        grader.wait()
    if not wait_until(all_have_ended, 1):
        yield f"these processes are left: {descendants()}"
    if (scratch / "results.json").exists():
        yield "it wrote results"
    if left := sorted(file.name for file in temporary.iterdir()):
        yield f"these are left in its temporary folder: {', '.join(left)}"


def compiler_process(build):
    """How the name of the process that compiles begins. That of g++ is a program of its own."""
    cache = (build / "CMakeCache.txt").read_text()
    compiler = Path(re.search(r"^CMAKE_CXX_COMPILER:\w+=(.*)$", cache, re.M)[1]).resolve()
    return "clang" if "clang" in compiler.name else "cc1plus"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=Path, default=ROOT / "build/test")
    parser.add_argument("--isolation", default="auto", choices=["auto", "bubblewrap", "plain"])
    options = parser.parse_args()
    build = options.build.resolve()
    commands = [of_one_lab, of_a_class] if (build / "bin/cs550_grade").exists() else [of_one_lab]
    become_subreaper()
    attacks = {attack["name"]: attack for attack in json.loads((HERE / "attacks.json").read_text())["attacks"]}
    faulty = 0
    programs = ((BUSY_IN_COMPILER, compiler_process(build)), (BUSY_IN_WORKER, "lab_worker"))
    for command, (name, busy), to_all in itertools.product(commands, programs, (False, True)):
        with tempfile.TemporaryDirectory() as folder:
            scratch = Path(folder)
            found = list(faults(command(build, attacks[name], options.isolation, scratch), busy, scratch, to_all))
        faulty += bool(found)
        print(f"SIGTERM {'to all ' if to_all else ''}in {busy} {command.__name__}: {'; '.join(found) or 'good'}")
    return 1 if faulty else 0


if __name__ == "__main__":
    sys.exit(main())
