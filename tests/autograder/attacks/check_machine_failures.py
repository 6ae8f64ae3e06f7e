#!/usr/bin/env python3
"""A failure of the machine is no mark: with a full temporary folder, or a judge that fails by itself, grade_lab writes
no results. A submission that fills the disk or ends its own process only fails."""

import argparse
import json
import os
import resource
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from run_attacks import ROOT, make_submission

MB = 1 << 20
AS_IT_IS = ["bwrap", "--dev-bind", "/", "/"]  # a view of the whole machine
CANNOT_START_WORKER = 71  # framework/autograder/grader/order.hpp
REFERENCE = {"name": "the reference", "lab": 3, "base": "reference"}
NUMBERS = ", ".join(map(str, range(10 ** 5, 2 * 10 ** 5)))
HAS_A_TABLE = {**REFERENCE, "files": {
    "table.cpp": f"extern const int table[];\nconst int table[] = {{{NUMBERS}}};\n"}}
FILLS_THE_DISK = {"name": "fills the disk", "lab": 3, "files": {
    f"part{part}.cpp": 'asm(".fill 60000000");\n' for part in range(3)}}


def grade(program, attack, scratch, wrapper=(), isolation="auto"):
    """What grade_lab prints, and its record, if it writes one."""
    make_submission(attack, scratch / "submission")
    results = scratch / "results.json"
    done = subprocess.run(
        [*wrapper, program, "3", "--submission", scratch / "submission", "--work", scratch / "work",
         "--results", results, "--isolation", isolation],
        text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    record = json.loads(results.read_text()) if results.exists() else None
    assert done.returncode == (0 if record else 1), f"exit code {done.returncode}: {done.stdout}"
    return done.stdout, record


def on_disk_of(megabytes, program, attack, scratch):
    """Grades where the folder for temporary files has its own file system."""
    disk = scratch / "disk"
    disk.mkdir()
    wrapper = [*AS_IT_IS, "--size", str(int(megabytes * MB)), "--tmpfs", disk, "--setenv", "TMPDIR", disk]
    return grade(program, attack, scratch, wrapper, "bubblewrap")


def full_disk(build, scratch):
    for megabytes, step in ((1.7, "compiler"), (2.5, "assembler"), (2.9, "linker")):
        folder = scratch / step
        folder.mkdir()
        printed, record = on_disk_of(megabytes, build / "bin/grade_lab", HAS_A_TABLE, folder)
        assert record is None, f"{step}: {record['compile']}"
        assert "and less is free" in printed, f"{step}: {printed[-500:]}"
    printed, record = on_disk_of(4, build / "bin/grade_lab", HAS_A_TABLE, scratch)
    assert record and record["earned"] == 60, f"it was to fit: {printed}"


def full_by_the_submission(build, scratch):
    printed, record = on_disk_of(100, build / "bin/grade_lab", FILLS_THE_DISK, scratch)
    assert record, f"it is not graded: {printed}"
    assert record["tests"][0]["status"] == "not_compiled", record["tests"][0]


def judge_that_fails(build, scratch):
    programs = scratch / "bin"
    programs.mkdir()
    shutil.copy(build / "bin/grade_lab", programs)
    begun = json.dumps({"tests": [{"test": "Lab3.FirstOfEqualVerticesWins", "status": "running"}]})
    for code in (2, 127, CANNOT_START_WORKER):
        (programs / "lab3_judge").write_text(
            f"#!/bin/sh\necho '{begun}' >\"$2\"\necho it cannot judge\nexit {code}\n")
        (programs / "lab3_judge").chmod(0o755)
        folder = scratch / str(code)
        folder.mkdir()
        printed, record = grade(programs / "grade_lab", REFERENCE, folder)
        assert record is None, f"exit code {code}: {record['tests'][0]}"
        assert f"ended with exit code {code}: it cannot judge" in printed, printed


def judge_without_descriptors(build, scratch):
    order = {"lab": 3, "submission": [str(scratch / "lab3.so")], "bubblewrap": False, "cpu": 10, "memory": 1 << 30,
             "processes": 256, "wall": 10, "deadline": 1 << 62}
    most = 4  # one file, but no pair of sockets
    done = subprocess.run(
        [build / "bin/lab3_judge", "--results", scratch / "judge.json"],
        env={**os.environ, "CS550_JUDGE": json.dumps(order)},
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (most, most)),
        text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert done.returncode == CANNOT_START_WORKER, f"exit code {done.returncode}: {done.stdout[-500:]}"
    assert "a worker cannot be started: socketpair: Too many open files" in done.stdout, done.stdout[-500:]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=Path, default=ROOT / "build/test")
    build = parser.parse_args().build.resolve()
    checks = [judge_that_fails, judge_without_descriptors]
    if shutil.which("bwrap") and subprocess.run([*AS_IT_IS, "true"], stderr=subprocess.DEVNULL).returncode == 0:
        checks += [full_disk, full_by_the_submission]
    faulty = 0
    for check in checks:
        with tempfile.TemporaryDirectory() as scratch:
            try:
                check(build, Path(scratch))
                print(f"{check.__name__}: good")
            except AssertionError as error:
                faulty += 1
                print(f"{check.__name__}: {error}")
    return 1 if faulty else 0


if __name__ == "__main__":
    sys.exit(main())
