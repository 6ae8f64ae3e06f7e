#!/usr/bin/env python3
"""Students' own tests earn points for known mistakes that they find, and nothing if they ever fail on the reference,
guess, leave early, or look for something that tells the mistakes from the reference. Everything is tried on lab 3; of
the other labs a good file (tests/autograder/own_tests/), and the same with a test that is wrong or leaves."""

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

from run_attacks import HERE, ROOT, become_subreaper, children

START = '#include <gtest/gtest.h>\n#include "cs550/hill_climbing.hpp"\n#include "cs550/primitives.hpp"\n'
BOX = """using namespace cs550;
const std::vector<Vec3> points{{-3, 0, 0}, {1, 2, 0}, {1, 2, 0}, {0, 0, -1}, {2, -1, 5}};
"""

# Of lab 3: the source, and what it must earn: "some", "none", or "refused" where the reference fails.
CASES = {
    "finds what is farthest": (BOX + """
TEST(Mine, FindsTheFarthest) {
  EXPECT_EQ(support_brute_force(points, {1, 1, 0}).vertex, 1);
  EXPECT_EQ(support_brute_force(points, {-1, 0, 0}).vertex, 0);
  EXPECT_EQ(support_brute_force(points, {1, 0, 0}).visited, 5);
}
""", "some"),
    "tests nothing": ("", "none"),
    "always passes": ("TEST(Mine, Passes) {}", "none"),
    "always fails": ("TEST(Mine, Fails) { FAIL() << \"\\033[31mwrong\"; }", "refused"),
    "expects what is wrong": (BOX + "TEST(Mine, Wrong) { EXPECT_EQ(support_brute_force(points, {1, 0, 0}).vertex, 0); }",
                              "refused"),
    "fails at random": ("#include <random>\nTEST(Mine, Guesses) { EXPECT_NE(std::random_device{}() % 2, 0); }", "refused"),
    "leaves at once": ("#include <unistd.h>\nconst bool gone = (_exit(0), true);", "none"),
    "leaves with a failure": ("#include <unistd.h>\nconst bool gone = (_exit(1), true);", "refused"),
    "never ends on the reference": ("TEST(Mine, Loops) { for (volatile int i = 0;; i = i + 1) {} }", "refused"),
    "does not compile": ("this is no C++", "none"),
    "keeps the compiler busy": ((HERE / "sources/constexpr_bombs.cpp").read_text(), "none"),
    "includes the reference": (f'#include "{ROOT}/solutions/lab3_hill_climbing/hill_climbing.cpp"\n', "none"),
    "loads the reference": ("""#include <dlfcn.h>
TEST(Mine, Compares) {
  const bool found = dlopen("@BUILD@/labs/liblab3_reference.so", RTLD_NOW) != nullptr ||
                     dlopen("liblab3_reference.so", RTLD_NOW) != nullptr;
  EXPECT_FALSE(found);
}
""", "none"),
    "reads the mistakes": ("""#include <filesystem>
#include <fstream>
TEST(Mine, Reads) {
  EXPECT_FALSE(std::filesystem::exists("@BUILD@/mistakes"));
  EXPECT_FALSE(std::ifstream("@ROOT@/tests/mutants/lab3.json").good());
  EXPECT_FALSE(std::ifstream("@ROOT@/solutions/lab3_hill_climbing/hill_climbing.cpp").good());
}
""", "none"),
    "keeps notes": ("""#include <fstream>
TEST(Mine, Remembers) {
  std::ofstream("/tmp/note") << "run";
  std::ofstream("note") << "run";
  EXPECT_FALSE(std::ifstream("note").good());
}
""", "none"),
    "starts a process": ("#include <unistd.h>\nTEST(Mine, Forks) { EXPECT_EQ(fork(), -1); }", "none"),
    "answers for the worker": ("#include <unistd.h>\nTEST(Mine, Speaks) { (void)!write(3, \"xxxxxxxx\", 8); }", "none"),
}


# What is added to a good file of another lab, and what the whole must earn.
ADDITIONS = {
    "is good": ("", "some"),
    "has a wrong test": ("TEST(Mine, IsWrong) { EXPECT_EQ(1, 2); }\n", "refused"),
    "leaves at once": ("#include <unistd.h>\nconst bool gone = (_exit(0), true);\n", "none"),
}


def cases(build):
    """Lab, name, source and what it must earn."""
    for name, (source, expected) in CASES.items():
        yield 3, name, START + source.replace("@ROOT@", str(ROOT)).replace("@BUILD@", str(build)), expected
    for file in sorted((ROOT / "tests/autograder/own_tests").glob("lab*.cpp")):
        for name, (addition, expected) in ADDITIONS.items():
            yield int(file.stem.removeprefix("lab")), name, file.read_text() + addition, expected


def grade(build, lab, source, isolation, scratch):
    submission = scratch / "submission"
    submission.mkdir()
    (submission / "lab.cpp").write_text("#error the lab's own file is not compiled\n")
    (submission / "my_tests.cpp").write_text(source)
    results = scratch / "results.json"
    subprocess.run([build / "bin/grade_lab", str(lab), "--own-tests", "--submission", submission, "--work",
                    scratch / "work", "--results", results, "--isolation", isolation], check=True)
    return json.loads(results.read_text())


def fault(record, expected):
    if expected == "some":
        fine = 0 < record["caught"] < record["mistakes"] and not record["reference_failures"]
    elif expected == "none":
        fine = record["caught"] == 0 and not record["reference_failures"]
    else:
        fine = record["caught"] == 0 and record["reference_failures"] > 0
    if not fine:
        return f"expected {expected}: {record}"
    if any(ord(letter) < 32 and letter != "\n" for letter in record["message"]):
        return "its message has control characters"
    return f"processes are left: {children()}" if children() else None


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=Path, default=ROOT / "build/test")
    parser.add_argument("--isolation", default="auto", choices=["auto", "bubblewrap", "plain"])
    parser.add_argument("--lab", type=int, help="only this lab")
    options = parser.parse_args()
    build = options.build.resolve()
    become_subreaper()
    faulty = 0
    for lab, name, source, expected in cases(build):
        if options.lab not in (None, lab):
            continue
        with tempfile.TemporaryDirectory() as scratch:
            record = grade(build, lab, source, options.isolation, Path(scratch))
        wrong = fault(record, expected)
        faulty += bool(wrong)
        print(f"lab {lab} {name:30} {record['caught']:3} of {record['mistakes']}  {wrong or 'good'}", flush=True)
    return 1 if faulty else 0


if __name__ == "__main__":
    sys.exit(main())
