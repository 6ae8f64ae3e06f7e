#!/usr/bin/env python3
"""Records which earlier labs each visible graded test calls, in tests/labN_topic/earlier_labs.json.

A students' copy has no reference: a mistake in an earlier lab fails tests of a later one. ./cs550 lab warns of
the earlier labs that a failing test calls. A test calls lab K if it is blocked when lab K is unwritten.
Without --record, the files are compared.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from run_mutants import ROOT, Unusable, run


def blocked_tests(program, stub):
    """The visible tests of a program that are blocked while a lab is unwritten."""
    with tempfile.TemporaryDirectory() as folder:
        results = Path(folder) / "results.json"
        subprocess.run([program, "--results", results], cwd=ROOT, env={**os.environ, "LD_PRELOAD": str(stub)},
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        return [row["test"].split(".")[-1] for row in json.loads(results.read_text())["tests"]
                if row["status"] == "blocked" and not row["hidden"]]


def earlier_labs(build, lab):
    """The earlier labs of each test that calls any."""
    targets = [f"lab{lab}_reference", *(f"lab{earlier}_stub_code" for earlier in range(1, lab))]
    run(["cmake", "--build", build, "--target", *targets], cwd=ROOT)
    called = {}
    for earlier in range(1, lab):
        stub = build / "labs" / f"liblab{earlier}_stub.so"
        for test in blocked_tests(build / "bin" / f"lab{lab}_reference", stub):
            called.setdefault(test, []).append(earlier)
    return called


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=Path, default=ROOT / "build/test",
                        help="a configured build folder (default: build/test)")
    parser.add_argument("--lab", type=int, help="only this lab")
    parser.add_argument("--record", action="store_true", help="write the files")
    options = parser.parse_args()
    outdated = 0
    for folder in sorted((ROOT / "tests").glob(f"lab{options.lab or '[0-9]'}_*")):
        called = earlier_labs(options.build.resolve(), int(folder.name[3:].split("_")[0]))
        lines = [f"  {json.dumps(test)}: {json.dumps(labs)}" for test, labs in sorted(called.items())]
        text = "{\n" + ",\n".join(lines) + "\n}\n" if lines else "{}\n"
        file = folder / "earlier_labs.json"
        if options.record:
            file.write_text(text)
        elif not file.exists() or file.read_text() != text:
            print(f"{file.relative_to(ROOT)} is out of date: tests/mutants/record_earlier_labs.py --record")
            outdated += 1
    return 1 if outdated else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except Unusable as error:
        sys.exit(f"a lab cannot be built: {error}")
