#!/usr/bin/env python3
"""Checks the order in which a lab's functions can be written.

"order" in labN.json lists a lab's steps so that each can be finished before the next is begun: with
the reference's functions up to a step and unwritten ones after it, the tests of that step pass. A test
that needs a later step is listed under "blocked", with the step that it waits for.
"""

import argparse
import json
import sys
from pathlib import Path

from run_mutants import ROOT, Reference, Unusable, run_edited, sources_with_bodies


def unwritten(step):
    return step.get("unwritten", f'throw NotImplemented("{step["step"]}");')


def problems(step, rows):
    """The differences from the order in labN.json."""
    blocked = step.get("blocked", {})
    for row in rows:
        name = row["test"].split(".")[-1]
        waits_for = blocked.get(name)
        if waits_for is None and row["status"] != "passed":
            yield f"{row['test']} does not pass: {row['message']}"
        elif waits_for is not None and waits_for not in row["message"]:
            yield f"{row['test']} is listed as blocked by {waits_for}, but: {row['message'] or 'passes'}"


def check_lab(build, file):
    """Prints a line per step. Returns the number of steps and of those with problems."""
    lab = int(file.stem.removeprefix("lab"))
    steps = json.loads(file.read_text())["order"]
    reference = Reference(build, lab)
    faulty = 0
    for place, step in enumerate(steps):
        later = [(after["function"], unwritten(after)) for after in steps[place + 1:]]
        try:
            rows = run_edited(reference, f"order_{step['step']}",
                              sources_with_bodies(reference, later), step["step"])
            found = list(problems(step, rows))
        except Unusable as error:
            found = [f"ERROR {error}"]
        faulty += bool(found)
        print(f"{step['step']:6}", "\n       ".join(found) or "can be finished here", flush=True)
    return len(steps), faulty


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=Path, default=ROOT / "build/test",
                        help="a configured build folder (default: build/test)")
    parser.add_argument("--lab", type=int, help="only this lab")
    options = parser.parse_args()
    count = faulty = 0
    for file in sorted(Path(__file__).parent.glob(f"lab{options.lab or '*'}.json")):
        of_lab = check_lab(options.build.resolve(), file)
        count, faulty = count + of_lab[0], faulty + of_lab[1]
    print(f"{count - faulty} of {count} steps can be finished in this order")
    return 1 if faulty or not count else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except Unusable as error:
        sys.exit(f"the reference itself cannot be built: {error}")
