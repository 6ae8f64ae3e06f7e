#!/usr/bin/python3
"""classroom_test.py CS550 ROOT SCRATCH [LAUNCHER]: runs the steps of the students' workflow for GitHub Classroom as its
runner does: in a clone of the students' repository, with bash -e, and a file for the outputs of each step."""
import base64
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

PROGRAM, ROOT, SCRATCH = (Path(argument).resolve() for argument in sys.argv[1:4])
GRADED = ("lab3", "lab6")  # two labs represent all; one is right, the other does not compile


def steps_of(workflow):
    """Each step as a dictionary of its keys. The file is YAML of the simplest kind."""
    steps = []
    for line in workflow.split("    steps:\n")[1].splitlines():
        start = re.match(r"      - (\w+): (.*)", line)
        if start:
            steps.append({start[1]: start[2]})
        elif key := re.match(r"        (\w+): (.+)", line):
            steps[-1][key[1]] = key[2]
    return steps


def run(command, **options):
    subprocess.run([str(word) for word in command], check=True, **options)


def run_step(step, checkout):
    """What the step passes on."""
    outputs = SCRATCH / "output"
    outputs.write_text("")
    # The runner offers nothing of the instructor's: no root of the project and no build folder.
    environment = {name: value for name, value in os.environ.items() if not name.startswith("CS550_")}
    run(["bash", "-e", "-c", step["run"]], cwd=checkout, stdout=sys.stderr,
        env={**environment, "CI": "true", "GITHUB_OUTPUT": str(outputs), "GITHUB_WORKSPACE": str(checkout)})
    return dict(line.split("=", 1) for line in outputs.read_text().splitlines() if line)


def check_own_tests(checkout):
    """my_tests.cpp is no part of the lab, and is built on the student's code as the handout describes."""
    (checkout / "labs/lab3_hill_climbing/my_tests.cpp").write_text("""#include <gtest/gtest.h>
#include "cs550/hill_climbing.hpp"
TEST(Mine, FindsTheFarthest) {
  const std::vector<cs550::Vec3> points{{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(cs550::support_brute_force(points, {1, 0, 0}).vertex, 1);
}
""")
    handout = (checkout / "labs/lab3_hill_climbing/README.md").read_text()
    build = re.search(r"`\./cs550 (build student lab3_my_tests)`", handout)[1]
    program = re.search(r"`(build/student/bin/lab3_my_tests)`", handout)[1]
    run([checkout / "cs550", *build.split()], stdout=sys.stderr)
    run([checkout / program], stdout=sys.stderr)
    run([checkout / "cs550", "lab", "3"], stdout=sys.stderr)


def main():
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    repository, checkout = SCRATCH / "repository", SCRATCH / "checkout"
    run([PROGRAM, "starter", repository], env={**os.environ, "CS550_ROOT": str(ROOT)})
    for source in (ROOT / "solutions/lab3_hill_climbing").glob("*.cpp"):
        shutil.copy(source, repository / "labs/lab3_hill_climbing")
    (repository / "labs/lab6_naive_solver/naive_solver.cpp").write_text("this is no C++\n")
    git = ["git", "-C", repository, "-c", "user.name=Ada", "-c", "user.email=ada@localhost"]
    run([*git, "commit", "-qam", "Lab 3"])
    run(["git", "clone", "-q", repository, checkout])

    steps = steps_of((checkout / ".github/workflows/labs.yml").read_text())
    labs = {step["id"]: step for step in steps if "id" in step}
    folders = sorted(folder.name.split("_")[0] for folder in (checkout / "labs").glob("lab*"))
    assert sorted(labs) == folders, f"{sorted(labs)}: the steps are not those of the labs"
    reporter = steps[-1]
    assert reporter["uses"].startswith("classroom-resources/autograding-grading-reporter@"), reporter
    workflow = (checkout / ".github/workflows/labs.yml").read_text()
    assert f"runners: {','.join(folders)}\n" in workflow
    for lab in folders:
        assert f"{lab.upper()}_RESULTS: ${{{{ steps.{lab}.outputs.result }}}}" in workflow, lab

    assert run_step(next(step for step in steps if step.get("name") == "Packages"), checkout) == {}
    results = {lab: json.loads(base64.b64decode(run_step(labs[lab], checkout)["result"])) for lab in GRADED}
    right, broken = (results[lab] for lab in GRADED)
    assert right["max_score"] == broken["max_score"] == 48, "visible tests only"
    assert right["status"] == "pass" and {test["status"] for test in right["tests"]} == {"pass"}, right
    assert sum(test["score"] for test in right["tests"]) == 48
    assert broken["status"] == "fail" and {test["status"] for test in broken["tests"]} == {"fail"}, broken
    assert "naive_solver.cpp:1" in broken["tests"][0]["message"], broken["tests"][0]
    check_own_tests(checkout)
    shutil.rmtree(SCRATCH)


if __name__ == "__main__":
    main()
