#!/usr/bin/env python3
"""Checks that the graded tests detect wrong solutions.

A mutant in labN.json is one mistake: an edit of the reference. The edited reference must compile,
lose points in the step that the mistake breaks, keep those of every step that it does not touch, and
a test that fails for it must name the cause.

A vacuous answer replaces a function of the reference by one that does nothing, or nearly nothing: it
returns a constant, or what it was given. It must not earn a single point in its step. The first such answers of all
steps together must not earn a single point of the lab.

An endless mutant is a mutant for which a test of its step never ends. It names a cause of its own: ./cs550 lab
lists such causes only if a test was stopped. Students' own tests do not have to find it (build_libraries.py).

tests/labN_topic/causes.json records which visible tests fail for a named cause: those of its step, so that
./cs550 lab leaves out causes that a passing test excludes, and those elsewhere, so that it lists the most
likely cause first. Tests of the step that may never end for it are listed again. --record-causes writes it,
every other run checks the tests of the step.
"""

import argparse
import fnmatch
import json
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SECONDS_PER_TEST = 60  # as in `./cs550 lab N`: a long test that takes longer is an endless loop
SECONDS_PER_ENDLESS_TEST = 10  # of an endless mutant: many of its tests do not end
SECONDS_PER_MUTANT = 240


class Unusable(Exception):
    """The mutant cannot be run: its text does not occur exactly once, or it does not compile."""


class Reference:
    """A lab's graded tests on its reference, and the commands that build the reference's library."""

    def __init__(self, build, lab):
        target = f"lab{lab}_reference"
        run(["cmake", "--build", build, "--target", target], cwd=ROOT)
        self.lab = lab
        self.build = build
        self.program = build / "bin" / target
        self.tests = json.loads(run([self.program, "--manifest"]))["tests"]
        self.causes = Causes(lab)
        self.compile = {}
        for entry in json.loads((build / "compile_commands.json").read_text()):
            if f"CMakeFiles/{target}_code.dir/" in entry["command"]:
                self.compile[Path(entry["file"])] = shlex.split(entry["command"])
        commands = run(["ninja", "-C", build, "--quiet", "-t", "commands", f"{target}_code"])
        self.link = [word for word in shlex.split(commands.splitlines()[-1])
                     if word not in (":", "&&")]

    def compile_edited(self, original, edited):
        """Returns the name of the original's object and the new object."""
        command = list(self.compile[original])
        place = command.index("-o") + 1
        old, command[place] = command[place], edited.with_suffix(".o")
        command[command.index("-c") + 1] = edited
        # A mistake may leave a variable unused. That warning is not an error here.
        run([*command, "-w", "-iquote", original.parent], cwd=self.build)
        return old, edited.with_suffix(".o")

    def link_edited(self, objects, library):
        command = [objects.get(word, word) for word in self.link]
        command[command.index("-o") + 1] = library
        run(command, cwd=self.build)


def run(command, cwd=None):
    done = subprocess.run([str(word) for word in command], cwd=cwd, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    if done.returncode != 0:
        raise Unusable(f"{command[0]} fails: {(done.stderr or done.stdout)[-2000:]}")
    return done.stdout


def mutated_sources(mutant):
    """The source that a mutant edits, with its new text."""
    source = ROOT / mutant["file"]
    text = source.read_text()
    count = text.count(mutant["find"])
    if count != 1:
        raise Unusable(f"{mutant['file']}: this text occurs {count} times, not once:\n{mutant['find']}")
    return {source: text.replace(mutant["find"], mutant["replace"])}


def with_body(text, function, body):
    """A source with another body of a function, or None if the source does not define it."""
    start = re.search(r"^ *" + re.escape(function), text, re.MULTILINE)
    if not start:
        return None
    begin = text.index("{", text.index(")", start.end())) + 1
    end, depth = begin, 1
    while depth:
        depth += {"{": 1, "}": -1}.get(text[end], 0)
        end += 1
    return f"{text[:begin]}\n  {body}\n{text[end - 1:]}"


def sources_with_bodies(reference, bodies):
    """The sources that define some functions, with other bodies, given as pairs of "Real height(" and a body."""
    sources = {}
    for function, body in bodies:
        for source in reference.compile:
            text = with_body(sources.get(source, source.read_text()), function, body)
            if text:
                sources[source] = text
                break
        else:
            raise Unusable(f"no file of lab {reference.lab}'s reference defines {function}…)")
    return sources


def make_library(reference, sources, folder):
    objects = {}
    for original, text in sources.items():
        edited = folder / original.name
        edited.write_text('#include "cs550/not_implemented.hpp"\n' + text)
        old, new = reference.compile_edited(original, edited)
        objects[old] = new
    reference.link_edited(objects, folder / "reference.so")
    return folder / "reference.so"


def run_tests(reference, library, names, folder, seconds):
    """One row per test. ctest ends a test that takes too long, and runs the others after a crash."""
    lines = []
    for name in names:
        lines.append(f'add_test({name} "{reference.program}" "--gtest_filter={name}"'
                     f' --results "{folder / name}.json")')
        lines.append(f'set_tests_properties({name} PROPERTIES WORKING_DIRECTORY "{ROOT}"'
                     f' ENVIRONMENT "LD_PRELOAD={library}" TIMEOUT {seconds})')
    (folder / "CTestTestfile.cmake").write_text("\n".join(lines))
    ctest = subprocess.Popen(["ctest", "--test-dir", folder, "-j1"], text=True, stdout=subprocess.PIPE,
                             stderr=subprocess.DEVNULL, start_new_session=True)
    try:
        printed, _ = ctest.communicate(timeout=SECONDS_PER_MUTANT)
    except subprocess.TimeoutExpired:
        os.killpg(ctest.pid, signal.SIGKILL)  # with the test that does not end
        ctest.wait()
        raise Unusable(f"its tests take more than {SECONDS_PER_MUTANT} s") from None
    stopped = set(re.findall(r": (\S+) \.*\*\*\*Timeout", printed))
    return [row_of(folder / f"{name}.json") | {"stopped": name in stopped} for name in names]


def row_of(results):
    if not results.exists():
        raise Unusable("the program ends before its test")
    row, = json.loads(results.read_text())["tests"]
    if row["status"] == "running":  # the program has described the case beside its results
        case = results.with_name(results.name + ".case")
        described = case.read_text(errors="replace").split("\0")[0] if case.exists() else ""
        row.update(status="failed", message=f"crashed or did not end in this case:\n{described}")
    return row


def faults(mutant, failed):
    """The errors in the graded tests or in the description of the mutant."""
    step, may_also_fail = mutant["step"], mutant["may_also_fail"]
    own = [row for row in failed if row["step"] == step]
    if not own:
        yield f"survives: no test of {step} fails"
    elif not any(mutant["names_cause"] in row["message"] for row in own):
        yield f"no failing test of {step} says “{mutant['names_cause']}”"
    if mutant["is_endless"] and not any(row["stopped"] for row in own):
        yield f"every test of {step} ends"
    for row in failed:
        if row["step"] not in (step, *may_also_fail):
            yield f"{row['test']} of {row['step']} fails too"


def run_edited(reference, name, sources, step=None, seconds=SECONDS_PER_TEST):
    """Runs the tests of the lab, or those of one step, on the reference with some sources edited."""
    folder = reference.build / "mutants" / f"lab{reference.lab}" / name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    names = [f"Lab{reference.lab}.{test['name']}" for test in reference.tests
             if step in (None, test["step"])]
    try:
        return run_tests(reference, make_library(reference, sources, folder), names, folder, seconds)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


class Causes:
    """For each cause the visible tests, of its step and elsewhere, that fail for all mutants that name it, and
    those of its step that never end for one of them."""

    def __init__(self, lab):
        folder, = (ROOT / "tests").glob(f"lab{lab}_*")
        self.file = folder / "causes.json"
        self.recorded = json.loads(self.file.read_text()) if self.file.exists() else {}
        self.seen = {}

    def see(self, mutant, failed):
        """Notes the tests that fail for a mutant. Returns those recorded for its cause that do not."""
        visible = [row for row in failed if not row["hidden"]]
        is_own = {row["test"].split(".")[-1]: row["step"] == mutant["step"] for row in visible}
        tests = {"step": [test for test in is_own if is_own[test]],
                 "elsewhere": [test for test in is_own if not is_own[test]]}
        endless = [row["test"].split(".")[-1] for row in visible if row["stopped"]]
        cause = mutant["names_cause"]
        known = self.seen.get(cause, tests)
        merged = {where: [test for test in known[where] if test in tests[where]] for where in tests}
        merged["endless"] = sorted({*known.get("endless", []), *(set(endless) & set(tests["step"]))})
        self.seen[cause] = merged
        recorded = self.recorded.get(cause, {"step": []})["step"]
        return [test for test in recorded if test not in tests["step"]]

    def record(self):
        lines = []
        for cause, tests in sorted(self.seen.items()):
            if not tests["endless"]:
                del tests["endless"]  # as for nearly all
            if tests["step"]:
                lines.append(f"  {json.dumps(cause, ensure_ascii=False)}: {json.dumps(tests)}")
        self.file.write_text("{\n" + ",\n".join(lines) + "\n}\n")


def judge_mutant(reference, mutant):
    """Returns the points lost in the mutant's step, those lost elsewhere, and the faults."""
    seconds = SECONDS_PER_ENDLESS_TEST if mutant["is_endless"] else SECONDS_PER_TEST
    rows = run_edited(reference, mutant["name"], mutated_sources(mutant), seconds=seconds)
    failed = [row for row in rows if row["status"] == "failed"]
    own = sum(row["points"] for row in failed if row["step"] == mutant["step"])
    found = list(faults(mutant, failed))
    found += [f"causes.json lists {test}, which passes" for test in reference.causes.see(mutant, failed)]
    return own, sum(row["points"] for row in failed) - own, found


def vacuous_answers(listed):
    """The vacuous answers of a lab, and then the first of every step, all together."""
    answers = [answer | {"bodies": [(answer["function"], answer["body"])]} for answer in listed]
    first = {answer["step"]: answer["bodies"][0] for answer in reversed(answers)}
    return [*answers, {"step": None, "answer": "nothing", "bodies": first.values()}]


def judge_vacuous(reference, answer):
    """Returns the points lost in the answer's step, 0, and the tests that it passes."""
    sources = sources_with_bodies(reference, answer["bodies"])
    rows = run_edited(reference, name_of(answer), sources, answer["step"])
    lost = sum(row["points"] for row in rows if row["status"] == "failed")
    return lost, 0, [f"{row['test']} passes: {row['points']} points for nothing"
                     for row in rows if row["status"] != "failed"]


def judge(reference, wrong):
    try:
        return judge_mutant(reference, wrong) if "name" in wrong else judge_vacuous(reference, wrong)
    except Unusable as error:
        return 0, 0, [f"ERROR {error}"]


def name_of(wrong):
    """A mutant's name, or "L3.2_nothing" or "all_nothing" for vacuous answers."""
    return wrong["name"] if "name" in wrong else f"{wrong['step'] or 'all'}_{wrong['answer']}"


def prove_lab(build, file, only, jobs, record_causes):
    """Prints a line per wrong solution. Returns the number of solutions and of those with errors."""
    lab = int(file.stem.removeprefix("lab"))
    listed = json.loads(file.read_text())
    mutants = [mutant | {"is_endless": name == "endless"}
               for name in ("mutants", "endless") for mutant in listed.get(name, [])]
    answers = [wrong for wrong in mutants + vacuous_answers(listed["vacuous"])
               if fnmatch.fnmatch(name_of(wrong), only)]
    if not answers:
        return 0, 0
    reference = Reference(build, lab)
    faulty = 0
    with ThreadPoolExecutor(max_workers=jobs) as pool:
        verdicts = pool.map(lambda wrong: judge(reference, wrong), answers)
        for wrong, (own, elsewhere, found) in zip(answers, verdicts):
            faulty += bool(found)
            verdict = "\n      ".join(found) or "caught"
            print(f"{lab:3}  {name_of(wrong):44} {wrong['step'] or '':5}{own:5}{elsewhere:10}  {verdict}",
                  flush=True)
    if record_causes:
        reference.causes.record()
    return len(answers), faulty


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=Path, default=ROOT / "build/test",
                        help="a configured build folder (default: build/test)")
    parser.add_argument("--lab", type=int, help="only this lab")
    parser.add_argument("--only", metavar="PATTERN", default="*",
                        help="only mutants of such names, or vacuous answers: 'L3.2_*'")
    parser.add_argument("--record-causes", action="store_true", help="write causes.json of the labs")
    parser.add_argument("--jobs", type=int, default=2, help="how many at once (default: 2)")
    options = parser.parse_args()
    if options.record_causes and options.only != "*":
        parser.error("--record-causes needs all mutants of a lab, not --only some")

    files = sorted(Path(__file__).parent.glob(f"lab{options.lab or '*'}.json"))
    print(f"{'lab':3}  {'mutant':44} {'step':5}{'lost':>5}{'elsewhere':>10}  verdict")
    count = faulty = 0
    for file in files:
        of_lab = prove_lab(options.build.resolve(), file, options.only, options.jobs,
                           options.record_causes)
        count, faulty = count + of_lab[0], faulty + of_lab[1]
    if count == 0:
        print("no such mutant or vacuous answer", file=sys.stderr)
        return 2
    print(f"{count - faulty} of {count} wrong answers are caught where they should be")
    return 1 if faulty else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except Unusable as error:
        sys.exit(f"the reference itself cannot be built: {error}")
