#!/usr/bin/env python3
"""A lab's reference and its starter get the same marks from the judge as from the program that runs them
in its own process, test by test."""

import argparse
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]


def in_process(program, scratch):
    results = scratch / "results.json"
    subprocess.run([program, "--results", results], cwd=ROOT, stdout=subprocess.DEVNULL)
    return {row["test"]: (row["status"], row["earned"])
            for row in json.loads(results.read_text())["tests"]}


def by_judge(build, lab, submission, isolation, scratch):
    results = scratch / "record.json"
    subprocess.run([build / "bin/grade_lab", str(lab), "--submission", submission, "--work", scratch / "work",
                    "--results", results, "--isolation", isolation], check=True)
    return {test["name"]: (test["status"], test["earned"])
            for test in json.loads(results.read_text())["tests"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=Path, default=ROOT / "build/test")
    parser.add_argument("--lab", type=int, required=True)
    parser.add_argument("--isolation", default="auto", choices=["auto", "bubblewrap", "plain"])
    options = parser.parse_args()
    different = 0
    for variant, folder, expected in (("reference", "solutions", 60), ("stub", "labs", 0)):
        sources, = (ROOT / folder).glob(f"lab{options.lab}_*")
        with tempfile.TemporaryDirectory() as scratch:
            submission = Path(scratch) / "submission"
            submission.mkdir()
            for file in sources.glob("*.[ch]pp"):  # without fast/
                shutil.copy(file, submission)
            program = options.build / "bin" / f"lab{options.lab}_{variant}"
            here = in_process(program, Path(scratch))
            there = by_judge(options.build, options.lab, submission, options.isolation, Path(scratch))
        for name in sorted(here.keys() | there.keys()):
            if here.get(name) != there.get(name):
                different += 1
                print(f"{variant} {name}: {here.get(name)} in process, {there.get(name)} by the judge")
        points = sum(earned for _, earned in there.values())
        print(f"{variant}: {points} points, {len(there)} tests")
        different += points != expected
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
