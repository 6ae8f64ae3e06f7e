#!/usr/bin/env python3
"""Makes a library of a lab for each of its mutants, in BUILD/mistakes/labN/, for students' own tests to find
(framework/autograder/grader). The libraries are numbered, so that no name tells what is wrong."""

import argparse
import json
import random
import shutil
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from run_mutants import Reference, Unusable, make_library, mutated_sources


def build(reference, mutant, library):
    folder = library.with_suffix(".build")
    folder.mkdir()
    shutil.copy(make_library(reference, mutated_sources(mutant), folder), library)
    shutil.rmtree(folder)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=Path, required=True, help="a configured build folder")
    parser.add_argument("--lab", type=int, required=True)
    options = parser.parse_args()
    reference = Reference(options.build.resolve(), options.lab)
    mutants = json.loads((Path(__file__).parent / f"lab{options.lab}.json").read_text())["mutants"]
    random.shuffle(mutants)
    folder = options.build.resolve() / f"mistakes/lab{options.lab}"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    with ThreadPoolExecutor(max_workers=2) as pool:
        list(pool.map(lambda item: build(reference, item[1], folder / f"{item[0]:03}.so"), enumerate(mutants)))
    (folder / "made").touch()


if __name__ == "__main__":
    try:
        sys.exit(main())
    except Unusable as error:
        sys.exit(str(error))
