#!/usr/bin/env python3
"""A lab's reference, its starter and, with --mutants, every known mistake get the same marks from the judge as
from the program that runs them in its own process, test by test."""

import argparse
import fnmatch
import json
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests/mutants"))
import run_mutants  # noqa: E402

SECONDS_PER_TEST = 600  # far more than any test takes: a mistake may make a call endless, but that ends by itself
SECONDS_PER_LAB = 3600


def sources_of(folder, lab):
    """The texts of the files in a lab's folder, without fast/."""
    found, = (ROOT / folder).glob(f"lab{lab}_*")
    return {file.name: file.read_text() for file in sorted(found.glob("*.[ch]pp"))}


def in_process(program):
    with tempfile.TemporaryDirectory() as scratch:
        results = Path(scratch) / "results.json"
        subprocess.run([program, "--results", results], cwd=ROOT, stdout=subprocess.DEVNULL)
        return {row["test"]: row["earned"] for row in json.loads(results.read_text())["tests"]}


def mutant_in_process(reference, mutant):
    rows = run_mutants.run_edited(reference, "same_" + mutant["name"], run_mutants.mutated_sources(mutant))
    return {row["test"]: row["earned"] if row["status"] == "passed" else 0 for row in rows}


def by_judge(options, sources):
    with tempfile.TemporaryDirectory() as scratch:
        submission, results = Path(scratch) / "submission", Path(scratch) / "record.json"
        submission.mkdir()
        for name, text in sources.items():
            (submission / name).write_text(text)
        subprocess.run([options.build / "bin/grade_lab", str(options.lab), "--submission", submission,
                        "--work", Path(scratch) / "work", "--results", results, "--wall", str(SECONDS_PER_TEST),
                        "--lab-time", str(SECONDS_PER_LAB), "--isolation", options.isolation], check=True)
        tests = json.loads(results.read_text())["tests"]
        pictures = [test["name"] for test in tests if ".svg" in test["message"]]
        assert not pictures, f"messages name files of pictures, which are not in the record: {pictures}"
        return tests


def points_of(tests):
    return {test["name"]: test["earned"] for test in tests}


def differences(name, here, there):
    for test in sorted(here.keys() | there.keys()):
        if here.get(test) != there.get(test):
            yield f"{name} {test}: {here.get(test)} in process, {there.get(test)} by the judge"


def compare_given_code(options):
    """The reference and the starter, which earn everything and nothing."""
    for name, folder, expected in (("reference", "solutions", 60), ("stub", "labs", 0)):
        here = in_process(options.build / "bin" / f"lab{options.lab}_{name}")
        tests = by_judge(options, sources_of(folder, options.lab))
        there = points_of(tests)
        points = sum(there.values())
        print(f"{name}: {points} points, {len(there)} tests", flush=True)
        yield from differences(name, here, there)
        if points != expected:
            yield f"{name} earns {points} points, not {expected}"
        for test in tests:
            if expected == 0 and "not implemented" not in test["message"]:
                yield f"{name} {test['name']} does not say that a step is not written: {test['message']}"


def compare_mutants(options):
    reference = run_mutants.Reference(options.build, options.lab)
    mutants = json.loads((ROOT / f"tests/mutants/lab{options.lab}.json").read_text())["mutants"]
    for mutant in mutants:
        if not fnmatch.fnmatch(mutant["name"], options.mutants):
            continue
        sources = sources_of("solutions", options.lab)
        for path, text in run_mutants.mutated_sources(mutant).items():
            sources[path.name] = '#include "cs550/not_implemented.hpp"\n' + text
        there = points_of(by_judge(options, sources))
        print(f"{mutant['name']}: {sum(there.values())} points", flush=True)
        yield from differences(mutant["name"], mutant_in_process(reference, mutant), there)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=Path, default=ROOT / "build/test")
    parser.add_argument("--lab", type=int, required=True)
    parser.add_argument("--isolation", default="auto", choices=["auto", "bubblewrap", "plain"])
    parser.add_argument("--mutants", metavar="PATTERN", help="compare known mistakes of such names instead")
    options = parser.parse_args()
    options.build = options.build.resolve()
    different = list(compare_mutants(options) if options.mutants else compare_given_code(options))
    print("\n".join(different) or "the same marks")
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
