#!/usr/bin/env python3
"""In an instructor's copy ctest's verdicts on the student's code are those of the judge: points are in each test's
output, and nothing of an earlier run is left when a file does not compile."""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from run_attacks import ROOT, lab_folder

LAB = 3
TESTS = rf"^student\.Lab{LAB}\."


def verdicts(build, submission):
    """By test: whether ctest calls it passed, and its line of points."""
    junit = submission.parent / "junit.xml"
    junit.unlink(missing_ok=True)
    # From a folder of its own: in the build folder the log of an outer ctest would be overwritten.
    (submission.parent / "CTestTestfile.cmake").write_text(f'subdirs("{build}")')
    subprocess.run(["ctest", "--test-dir", submission.parent, "-R", TESTS, "--output-junit", junit],
                   env={**os.environ, "CS550_SUBMISSION": os.path.relpath(submission, ROOT)}, stdout=subprocess.DEVNULL)
    found = {}
    for case in ElementTree.parse(junit).getroot().iter("testcase"):
        if re.match(TESTS, case.get("name")):
            points = re.search(r"points \d+, earned (\d+)", case.findtext("system-out"))
            found[case.get("name")] = (case.get("status") == "run", points and int(points[1]))
    return found


def message_beside(lab):
    """What is printed about a submission if the folder of the lab has these files."""
    script = ROOT / "framework/autograder/grader/ctest/judge_lab.cmake"
    run = subprocess.run(["cmake", f"-DLAB={LAB}", f"-DFILES={lab}", f"-DRECORD={lab}.json", "-DBUILD=absent",
                          "-P", script], env={**os.environ, "CS550_SUBMISSION": "absent"}, stdout=subprocess.DEVNULL,
                         stderr=subprocess.PIPE, text=True)
    assert run.returncode != 0, "there is no build folder"
    return " ".join(run.stderr.split())


def check_starters(project):
    """A submission is refused beside a lab that is not the starter, of which it would get what it lacks."""
    lab = project / "labs/lab3_hill_climbing"
    lab.mkdir(parents=True)
    (lab / "a.cpp").write_text("// the starter")
    git = ["git", "-C", project, "-c", "user.name=a", "-c", "user.email=a@example.org"]
    for arguments in (["init", "--quiet"], ["add", "--all"], ["commit", "--quiet", "--message", "a"]):
        subprocess.run([*git, *arguments], check=True)
    (lab / "my_tests.cpp").write_text("// no code of the lab")
    assert "starter" not in message_beside(lab)
    if os.geteuid() == 0:
        subprocess.run(["chown", "--recursive", "65534", project], check=True)
    for name in ("b.cpp", "a.cpp"):
        (lab / name).write_text("// the solution")
        message = message_beside(lab)
        assert "differs from the starter" in message and f"{name} ./cs550 lab {LAB} --reset" in message, message
        (lab / name).unlink()
    (project / ".git/HEAD").unlink()
    message = message_beside(lab)
    assert "Cannot check that labs/ has the starters: git failed: fatal" in message, message
    shutil.rmtree(project / ".git")
    assert "starter" not in message_beside(lab)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=Path, default=ROOT / "build/test")
    build = parser.parse_args().build.resolve()
    with tempfile.TemporaryDirectory() as scratch:
        check_starters(Path(scratch) / "project")
        submission = Path(scratch) / "submission"
        submission.mkdir()
        for source in lab_folder(ROOT / "solutions", LAB).glob("*.cpp"):
            (submission / source.name).write_text(source.read_text())
        right = verdicts(build, submission)
        for source in submission.glob("*.cpp"):
            source.write_text(source.read_text() + "this is no C++\n")
        broken = verdicts(build, submission)
        for source in submission.glob("*.cpp"):
            source.unlink()
        absent = verdicts(build, submission)
    assert right and all(passed for passed, _ in right.values()), right
    assert sum(points for _, points in right.values()) == 60, right
    for verdict in (broken, absent):
        assert verdict.keys() == right.keys(), verdict
        assert set(verdict.values()) == {(False, 0)}, verdict


if __name__ == "__main__":
    sys.exit(main())
