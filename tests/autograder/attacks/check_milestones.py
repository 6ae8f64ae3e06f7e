#!/usr/bin/env python3
"""A submission's labs run the milestones together, each call answered by the sandbox: the reference reaches all of
them, a lab that does not compile costs those that need it, and the starters reach none."""

import argparse
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from run_attacks import ROOT, lab_folder

LABS = range(1, 8)


def engine(folder, scratch, labs=LABS):
    """A submission with the given labs of a folder of the project."""
    for lab in labs:
        source = lab_folder(ROOT / folder, lab)
        (scratch / source.name).mkdir(parents=True)
        for file in source.glob("*.[ch]pp"):
            shutil.copy(file, scratch / source.name)
    return scratch


def record_of(build, submission, last, *options):
    """The record of grade_lab --milestones."""
    with tempfile.TemporaryDirectory() as scratch:
        results = Path(scratch) / "results.json"
        subprocess.run([build / "bin/grade_lab", str(last), "--milestones", "--submission", submission,
                        "--work", Path(scratch) / "work", "--results", results, *options], check=True)
        return json.loads(results.read_text())


def reached(build, submission, last):
    """By milestone: whether it is reached, and the message if it is not."""
    record = record_of(build, submission, last)
    seconds = sum(test["seconds"] for test in record["tests"])
    print(f"{submission.name}: {record['compile']['seconds']:.1f} s of compilation, {seconds:.1f} s of milestones")
    return {test["name"]: test["status"] == "passed" or test["message"] for test in record["tests"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=Path, default=ROOT / "build/test")
    build = parser.parse_args().build.resolve()
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder)
        right = reached(build, engine("solutions", scratch / "reference"), 7)
        assert len(right) == len(list((ROOT / "framework/assets/trajectories").glob("*.csv"))), right
        assert set(right.values()) == {True}, right

        broken = engine("solutions", scratch / "broken", range(1, 4))
        for source in lab_folder(broken, 3).glob("*.cpp"):
            source.write_text("this is no C++\n")
        verdicts = reached(build, broken, 3)
        assert verdicts.pop("Milestone.lab1_free_spin") is True, verdicts
        assert verdicts.pop("Milestone.lab2_thrown_shapes") is True, verdicts
        assert "not implemented: L3" in verdicts.pop("Milestone.lab3_ghosts"), verdicts
        assert not verdicts, "later labs were not asked for"

        late = record_of(build, scratch / "reference", 7, "--lab-time", "1")
        assert {test["status"] for test in late["tests"]} == {"timeout"}, late["tests"]
        assert "does not compile" not in late["compile"]["errors"], late["compile"]["errors"]
        assert "time for the whole lab is over" in late["compile"]["errors"], late["compile"]["errors"]

        unwritten = reached(build, engine("labs", scratch / "starters"), 7)
        assert len(unwritten) == len(right) and True not in unwritten.values(), unwritten


if __name__ == "__main__":
    sys.exit(main())
