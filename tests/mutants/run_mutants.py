#!/usr/bin/env python3
"""Proves the graded tests with wrong solutions.

Each entry of labN.json is one mistake: an edit of the reference. The edited reference must compile,
lose points in the step that the mistake breaks, keep those of every step that it does not touch, and
a test that fails for it must name the cause.
"""

import argparse
import json
import shlex
import shutil
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SECONDS_PER_TEST = 60  # as in `./cs550 lab N`: a long test that takes longer is an endless loop
SECONDS_PER_MUTANT = 240


class Unusable(Exception):
    """The mutant cannot be judged: its text does not occur once, or it does not compile."""


class Reference:
    """How the build compiles a lab's reference and links it with the lab's graded tests."""

    def __init__(self, build, lab):
        target = f"lab{lab}_reference"
        run(["cmake", "--build", build, "--target", target], cwd=ROOT)
        self.lab = lab
        self.build = build
        self.program = build / "bin" / target
        self.compile = {}
        for entry in json.loads((build / "compile_commands.json").read_text()):
            if f"CMakeFiles/{target}_code.dir/" in entry["command"]:
                self.compile[Path(entry["file"])] = shlex.split(entry["command"])
        self.objects = {source: command[command.index("-o") + 1]
                        for source, command in self.compile.items()}
        commands = run(["ninja", "-C", build, "--quiet", "-t", "commands", target]).splitlines()
        own_objects = {f"labs/{target}.o", *self.objects.values()}
        self.link = [word for word in shlex.split(commands[-1])
                     if word not in own_objects and word not in (":", "&&")]

    def compile_edited(self, original, edited, output):
        command = list(self.compile[original])
        command[command.index("-o") + 1] = output
        command[command.index("-c") + 1] = edited
        # A mistake may leave a variable unused: no reason to refuse it.
        run([*command, "-w", "-iquote", original.parent], cwd=self.build)

    def link_edited(self, original, edited_object, output):
        command = list(self.link)
        command[command.index("-o") + 1] = output
        others = [name for source, name in self.objects.items() if source != original]
        run([command[0], edited_object, *others, *command[1:]], cwd=self.build)


def run(command, cwd=None):
    done = subprocess.run([str(word) for word in command], cwd=cwd, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    if done.returncode != 0:
        raise Unusable(f"{command[0]} fails: {(done.stderr or done.stdout)[-2000:]}")
    return done.stdout


def edited_text(mutant):
    text = (ROOT / mutant["file"]).read_text()
    count = text.count(mutant["find"])
    if count != 1:
        raise Unusable(f"{mutant['file']}: this text occurs {count} times, not once:\n{mutant['find']}")
    return text.replace(mutant["find"], mutant["replace"])


def make_program(reference, mutant, folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    original = ROOT / mutant["file"]
    edited = folder / original.name
    edited.write_text(edited_text(mutant))
    reference.compile_edited(original, edited, folder / "edited.o")
    reference.link_edited(original, folder / "edited.o", folder / "program")
    return folder / "program"


def read_results(file):
    return json.loads(file.read_text())["tests"] if file.exists() else []


def run_until_it_stops(program, names, results, deadline):
    """Runs the tests; ends the program when one takes too long. Returns what was written."""
    process = subprocess.Popen([program, "--gtest_filter=" + ":".join(names), "--results", results],
                               cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    written, since = None, time.monotonic()
    while process.poll() is None:
        time.sleep(0.02)
        now = time.monotonic()
        stamp = results.stat().st_mtime_ns if results.exists() else None
        if stamp != written:
            written, since = stamp, now
        if now - since > SECONDS_PER_TEST or now > deadline:
            process.kill()
            process.wait()
    return read_results(results)


def run_tests(program, names):
    """One row per test. A test that crashes or does not end has failed; the others still run."""
    deadline = time.monotonic() + SECONDS_PER_MUTANT
    results = program.with_name("results.json")
    rows, waiting = [], list(names)
    while waiting:
        results.unlink(missing_ok=True)
        new_rows = run_until_it_stops(program, waiting, results, deadline)
        if not new_rows:
            raise Unusable("the program ends before its first test")
        for row in new_rows:
            if row["status"] == "running":
                row.update(status="failed", message="crashed or did not end")
        rows += new_rows
        reached = {row["test"] for row in new_rows}
        waiting = [name for name in waiting if name not in reached]
        if waiting and time.monotonic() > deadline:
            raise Unusable(f"its tests take more than {SECONDS_PER_MUTANT} s")
    return rows


def faults(mutant, failed):
    """What is wrong with the graded tests, or with what the mutant says of itself."""
    step, may_also_fail = mutant["step"], mutant["may_also_fail"]
    own = [row for row in failed if row["step"] == step]
    if not own:
        yield f"survives: no test of {step} fails"
    elif not any(mutant["names_cause"] in row["message"] for row in own):
        yield f"no failing test of {step} says “{mutant['names_cause']}”"
    for row in failed:
        if row["step"] not in (step, *may_also_fail):
            yield f"{row['test']} of {row['step']} fails too"


def judge(reference, names, mutant):
    """Returns the points lost in the mutant's step, those lost elsewhere, and the faults."""
    folder = reference.build / "mutants" / f"lab{reference.lab}" / mutant["name"]
    try:
        rows = run_tests(make_program(reference, mutant, folder), names)
    except Unusable as error:
        return 0, 0, [f"ERROR {error}"]
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    failed = [row for row in rows if row["status"] == "failed"]
    own = sum(row["points"] for row in failed if row["step"] == mutant["step"])
    return own, sum(row["points"] for row in failed) - own, list(faults(mutant, failed))


def prove_lab(build, file, only):
    """Prints a line per mutant. Returns how many there were and how many have faults."""
    lab = int(file.stem.removeprefix("lab"))
    mutants = [mutant for mutant in json.loads(file.read_text())["mutants"]
               if only in (None, mutant["name"])]
    if not mutants:
        return 0, 0
    reference = Reference(build, lab)
    manifest = json.loads(run([reference.program, "--manifest"]))
    names = [f"Lab{lab}.{test['name']}" for test in manifest["tests"]]
    faulty = 0
    with ThreadPoolExecutor(max_workers=2) as pool:
        verdicts = pool.map(lambda mutant: judge(reference, names, mutant), mutants)
        for mutant, (own, elsewhere, found) in zip(mutants, verdicts):
            faulty += bool(found)
            verdict = "\n      ".join(found) or "caught"
            print(f"{lab:3}  {mutant['name']:44} {mutant['step']:5}{own:5}{elsewhere:10}  {verdict}",
                  flush=True)
    return len(mutants), faulty


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=Path, default=ROOT / "build/test",
                        help="a configured build folder (default: build/test)")
    parser.add_argument("--lab", type=int, help="only this lab")
    parser.add_argument("--only", metavar="NAME", help="only the mutant of this name")
    options = parser.parse_args()

    files = sorted(Path(__file__).parent.glob(f"lab{options.lab or '*'}.json"))
    print(f"{'lab':3}  {'mutant':44} {'step':5}{'lost':>5}{'elsewhere':>10}  verdict")
    count = faulty = 0
    for file in files:
        of_lab = prove_lab(options.build.resolve(), file, options.only)
        count, faulty = count + of_lab[0], faulty + of_lab[1]
    if count == 0:
        print("no such mutant", file=sys.stderr)
        return 2
    print(f"{count - faulty} of {count} mutants are caught where they should be")
    return 1 if faulty else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except Unusable as error:
        sys.exit(f"the reference itself cannot be built: {error}")
