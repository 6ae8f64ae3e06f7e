#!/usr/bin/python3
"""grade_test.py PROGRAM ROOT SCRATCH: ./cs550 grade from submissions to marks, on fake_grade_lab.sh.

Each function whose name begins with test_ is one test, in a folder of its own.
"""
import csv
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
import traceback
import zipfile
from pathlib import Path

PROGRAM, ROOT, SCRATCH = (Path(argument).resolve() for argument in sys.argv[1:4])
FAKE = Path(__file__).parent / "fake_grade_lab.sh"
HILL = "labs/lab3_hill_climbing/hill_climbing.cpp"
CLIP = "labs/lab5_clipping/clipping.cpp"


def command(*arguments):
    return [str(a) for a in (PROGRAM, "--judge", FAKE, *arguments)]


def grade(*arguments, code=0, root=ROOT, **options):
    """Runs the verb and checks its exit code. Returns what it printed, in one line: long lines are broken where
    the path of this folder decides."""
    run = subprocess.run(command(*arguments), capture_output=True, text=True, timeout=120, check=False,
                         env={**os.environ, "CS550_ROOT": str(root)}, **options)
    printed = run.stdout + run.stderr
    assert run.returncode == code, f"{arguments}: exit code {run.returncode}, expected {code}\n{printed}"
    return " ".join(printed.split())


def pack(file, files):
    file.parent.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(file, "w") as archive:
        for name, text in files.items():
            archive.writestr(name, text)


def record(out, name):
    return json.loads((out / "records" / f"{name}.json").read_text())


def lab(out, name, number):
    return next(lab for lab in record(out, name)["labs"] if lab["lab"] == number)


def marks(out):
    """The marks of every submission, without times."""
    text = {}
    for file in sorted((out / "records").glob("*.json")):
        content = json.loads(file.read_text())
        text[file.name] = [(lab["lab"], lab["earned"], [(t["name"], t["status"]) for t in lab["tests"]])
                           for lab in content["labs"]]
    return text


def grades(out):
    with open(out / "grades.csv", newline="") as file:
        return {row["id"]: row for row in csv.DictReader(file)}


def no_work_is_left(out):
    assert not (out / "work").exists(), "the work folder was not removed"
    left = [str(f) for f in out.rglob("*.draft*")]
    assert not left, f"half-written files: {left}"


def small_class(folder):
    pack(folder / "ada.zip", {HILL: "// all right", CLIP: "// all right"})
    pack(folder / "bob.zip", {HILL: "// fake: fails FirstOfEqualVerticesWins"})
    pack(folder / "eve.zip", {HILL: "// fake: no compile", "framework/include/cs550/math.hpp": "#error"})
    (folder / "zoe").mkdir()


def test_a_class_is_graded(folder):
    small_class(folder / "class")
    (folder / "roster.csv").write_text("id,name\nada,Ada\nbob,Bob\neve,Eve\nzoe,Zoe\nmax,Max\n")
    out = folder / "out"
    printed = grade(folder / "class", "--out", out, "--labs", "3,5", "--roster", folder / "roster.csv")
    assert "4 submissions" in printed, printed
    assert "unreadable: zoe" in printed, printed
    assert lab(out, "ada", 3)["earned"] == 60 and lab(out, "ada", 5)["earned"] == 60
    assert lab(out, "bob", 3)["earned"] == 58 and not lab(out, "bob", 5)["submitted"]
    assert lab(out, "eve", 3)["compile"] == {"ok": False, "seconds": 1.5, "errors": "a.cpp:1: error: expected <;>"}
    assert record(out, "eve")["ignored"] == [{"path": "framework/", "reason": "not in a lab's folder", "files": 1}]
    rows = grades(out)
    assert (rows["ada"]["percent"], rows["bob"]["percent"], rows["eve"]["percent"]) == ("100.00", "48.33", "0.00")
    assert (rows["max"]["status"], rows["zoe"]["status"]) == ("missing", "unreadable"), rows
    assert rows["bob"]["lab5"] == "" and rows["eve"]["lab3"] == "0"
    no_work_is_left(out)


def test_the_isolation_in_force_is_reported(folder):
    small_class(folder / "class")
    assert "Isolation of submissions: fake." in grade(folder / "class", "--out", folder / "out", "--labs", "3")
    assert "Isolation of submissions: fake." in (folder / "out/class.html").read_text()
    os.environ["FAKE_UNPROTECTED"] = "1"
    try:
        printed = grade(folder / "class", "--out", folder / "unprotected", "--labs", "3", code=1)
    finally:
        del os.environ["FAKE_UNPROTECTED"]
    assert "no isolation works" in printed and not (folder / "unprotected").exists(), printed


def test_equal_files_are_graded_once(folder):
    for student in ("ada", "bob", "eve"):
        pack(folder / "class" / f"{student}.zip", {HILL: "// the same", "notes.txt": student})
    log = folder / "log"
    os.environ["FAKE_LOG"] = str(log)
    try:
        grade(folder / "class", "--out", folder / "out")
    finally:
        del os.environ["FAKE_LOG"]
    assert log.read_text() == "lab 3\n", log.read_text()
    assert lab(folder / "out", "eve", 3)["earned"] == 60
    assert [lab(folder / "out", name, 3).get("same_as") for name in ("ada", "bob", "eve")] == [None, "ada", "ada"]


def test_the_first_labs_together_run_the_milestones(folder):
    def source(lab, text):
        folder, = (ROOT / "labs").glob(f"lab{lab}_*")
        return {f"labs/{folder.name}/{file.name}": text for file in folder.glob("*.cpp")}

    pack(folder / "class/ada.zip", {**source(1, "// 1"), **source(2, "// 2"), **source(3, "// 3")})
    pack(folder / "class/bob.zip", {**source(1, "// b"), **source(3, "// fake: misses lab3_ghosts")})
    pack(folder / "class/eve.zip", source(3, "// only this"))
    (folder / "course.toml").write_text("[milestones]\nweight = 3\n")
    out, log = folder / "out", folder / "log"
    os.environ["FAKE_LOG"] = str(log)
    try:
        grade(folder / "class", "--out", out, "--labs", "1-3", "--course", folder / "course.toml")
    finally:
        del os.environ["FAKE_LOG"]
    runs = sorted(line for line in log.read_text().splitlines() if line.startswith("milestones"))
    assert runs == ["milestones lab1_integration ", "milestones lab1_integration lab2_half_edge_mesh lab3_hill_climbing "]
    assert [test["status"] for test in record(out, "ada")["engine"]["tests"]] == ["passed"] * 3
    assert [test["status"] for test in record(out, "bob")["engine"]["tests"]] == ["passed"] + ["not_submitted"] * 2
    rows = grades(out)
    assert [rows[name]["milestones"] for name in ("ada", "bob", "eve")] == ["3", "1", "0"], rows
    # Three labs of weight 1 and the milestones of weight 3. Bob: two labs of three, a milestone of three.
    assert [rows[name]["percent"] for name in ("ada", "bob", "eve")] == ["100.00", "50.00", "16.67"], rows
    assert "Engine: 1 of 3 milestones reached" in (out / "feedback/bob.md").read_text()
    assert "Engine: 1 of 3 milestones reached" in (out / "feedback/bob.html").read_text()
    assert "Milestone.lab3_ghosts</td><td class=\"number\">1 of 3</td>" in (out / "class.html").read_text()
    assert "Engine" not in (out / "feedback/eve.md").read_text(), "no milestone can be run without lab 1"
    for name, options in (("one_lab", ["--labs", "3"]), ("no_weight", ["--labs", "1-3"])):
        grade(folder / "class", "--out", folder / name, *options)
        assert "engine" not in record(folder / name, "ada")
    grade(folder / "class", "--out", folder / "asked_for", "--labs", "1-3", "--milestones")
    assert "engine" in record(folder / "asked_for", "ada")


def test_own_tests_are_a_bonus(folder):
    tests = "labs/lab3_hill_climbing/my_tests.cpp"
    pack(folder / "class/ada.zip", {HILL: "// a", tests: "// fake: catches 8"})
    pack(folder / "class/bob.zip", {HILL: "// b", tests: "// fails <b>the reference</b>"})
    pack(folder / "class/eve.zip", {HILL: "// e"})
    course = folder / "course.toml"
    course.write_text("[lab.3]\npoints = 100\nown_tests = 5\n")
    log, out = folder / "log", folder / "out"
    os.environ["FAKE_LOG"] = str(log)
    try:
        grade(folder / "class", "--out", out, "--labs", "3", "--course", course)
        assert sorted(log.read_text().splitlines()) == ["lab 3"] * 3 + ["own tests 3"] * 2
        grade(folder / "class", "--out", folder / "without", "--labs", "3")
        assert log.read_text().count("own tests") == 2, "without points they are not run"
    finally:
        del os.environ["FAKE_LOG"]
    assert lab(out, "ada", 3)["own_tests"]["caught"] == 8
    assert "own_tests" not in lab(out, "eve", 3)
    assert [grades(out)[name]["lab3"] for name in ("ada", "bob", "eve")] == ["102", "100", "100"]
    feedback = (out / "feedback/ada.md").read_text() + (out / "feedback/bob.md").read_text()
    assert "finds 8 of 20 known mistakes" in feedback and "fails on the reference" in feedback, feedback
    grade("--report", out)
    assert grades(out)["ada"]["lab3"] == "102"


def test_challenges_are_counted_for_the_leaderboard_only(folder):
    pack(folder / "class/ada.zip", {HILL: "// a"})
    course = folder / "course.toml"
    course.write_text('leaderboard = ["challenge"]\n')
    grade(folder / "class", "--out", folder / "out", "--labs", "3", "--course", course)
    assert lab(folder / "out", "ada", 3)["challenge"] == [{"what": "things", "better": "fewer", "count": 42}]
    grade(folder / "class", "--out", folder / "without", "--labs", "3")
    assert "challenge" not in lab(folder / "without", "ada", 3)


def test_gradescope_names_the_time_of_submission(folder):
    (folder / "submission").mkdir()
    (folder / "submission/hill_climbing.cpp").write_text("// all right")
    (folder / "course.toml").write_text("[lab.3]\ndue = 2026-10-12T23:59:00+02:00\n"
                                        "[late]\nclock = 'file'\npercent_per_day = 10\n")
    metadata = folder / "submission_metadata.json"

    def graded(out, *more, code=0):
        return grade(folder / "submission", "--out", folder / out, "--labs", "3", "--course", folder / "course.toml",
                     *more, code=code)

    graded("unknown")
    assert grades(folder / "unknown")["submission"]["lab3"] == "60"
    assert "time of submission unknown" in (folder / "unknown/grades.csv").read_text()
    metadata.write_text('{"id": 1, "created_at": "2026-10-13T14:22:32.365935-07:00"}')
    graded("late", "--gradescope-metadata", metadata)
    assert grades(folder / "late")["submission"]["lab3"] == "54", "a day begun"
    metadata.write_text('{"id": 1}')
    assert "created_at" in graded("damaged", "--gradescope-metadata", metadata, code=1)


def test_gradescope_names_the_student(folder):
    (folder / "submission").mkdir()
    (folder / "submission/hill_climbing.cpp").write_text("// fake: fails FirstOfEqualVerticesWins")
    metadata = folder / "submission_metadata.json"
    metadata.write_text('{"created_at": "2026-10-14T14:22:32-07:00",'
                        ' "users": [{"email": "ada@example.org", "id": 7, "name": "Ada Lovelace"}]}')
    (folder / "roster.csv").write_text("id,email\ns0101,Ada@example.org\n")

    def score(student, *more, upload="submission"):
        (folder / "course.toml").write_text(
            "[lab.3]\ndue = 2026-10-12T23:59:00+02:00\n[late]\nclock = 'file'\npercent_per_day = 10\n"
            f"[[extension]]\nstudent = '{student}'\nlab = 3\ndue = 2026-10-19T23:59:00+02:00\nreason = 'illness'\n"
            f"[[adjustment]]\nstudent = '{student}'\nlab = 3\npoints = -5\nreason = 'r'\n"
            f"[[regrade]]\nstudent = '{student}'\nlab = 3\ntest = 'Lab3.FirstOfEqualVerticesWins'\n"
            "status = 'granted'\n")
        shutil.rmtree(folder / "out", ignore_errors=True)
        grade(folder / upload, "--out", folder / "out", "--labs", "3", "--course", folder / "course.toml",
              "--gradescope-metadata", metadata, *more)
        result, = (folder / "out/gradescope").glob("*.json")
        return json.loads(result.read_text())["score"]

    assert score("ada@example.org") == 55, "of 60, with the regrade and the adjustment, and not late"
    assert score("s0101", "--roster", folder / "roster.csv") == 55
    assert score("s0101") == 46.4, "of 58, two days late"
    files = {HILL: "// fake: fails FirstOfEqualVerticesWins"}
    pack(folder / "by_name/s0101-lab3.zip", files)
    pack(folder / "by_claim/lab3.zip", {**files, "manifest.json": '{"student": "s0101"}'})
    metadata.write_text(metadata.read_text().replace("ada@example.org", "eve@example.org"))
    for upload in ("by_name", "by_claim"):
        assert score("s0101", "--roster", folder / "roster.csv", upload=upload) == 46.4, upload
    assert score("eve@example.org", "--roster", folder / "roster.csv", upload="by_name") == 55


def test_an_upload_to_gradescope_is_one_submission(folder):
    upload = folder / "submission"
    for copy in ("mine", "theirs"):
        (upload / copy / "labs/lab3_hill_climbing").mkdir(parents=True)
        (upload / copy / HILL).write_text(f"// {copy}")
    (upload / "__MACOSX").mkdir()
    metadata = folder / "submission_metadata.json"
    metadata.write_text('{"created_at": "2026-10-13T14:22:32-07:00"}')

    def graded(out):
        grade(upload, "--out", folder / out, "--labs", "3", "--gradescope-metadata", metadata)
        result, = (folder / out / "gradescope").glob("*.json")
        return json.loads(result.read_text())

    result = graded("several")
    assert result["score"] == 0 and "2 submissions, and none was graded: mine, theirs" in result["output"], result
    shutil.rmtree(upload / "theirs")
    assert graded("one")["score"] == 60, "the folders of an operating system do not count"


def test_gradescope_has_a_result_where_the_grader_fails(folder):
    source = folder / "source"
    (source / "build/test/bin").mkdir(parents=True)
    for name in ("labs", "tests", "framework"):
        (source / name).symlink_to(ROOT / name)
    (source / "build/test/bin/cs550_grade").symlink_to(PROGRAM)
    (source / "build/test/bin/grade_lab").write_text(f'#!/bin/sh\nexec "{FAKE}" "$@"\n')
    (source / "build/test/bin/grade_lab").chmod(0o755)
    (source / "labs.txt").write_text("3\n")
    (source / "course.toml").write_text("[lab.3]\nown_tests = 5\n")

    def results(files, code=0):
        for name, text in files.items():
            (folder / "submission" / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / "submission" / name).write_text(text)
        (folder / "results.json").unlink(missing_ok=True)
        run = subprocess.run([ROOT / "framework/gradebook/gradescope/grade.sh", folder / "submission",
                              folder / "results.json"], cwd=source, capture_output=True, text=True, check=False)
        assert (run.returncode == 0) == (code == 0) == (folder / "results.json").exists(), run.stdout + run.stderr
        return json.loads((folder / "results.json").read_text()) if code == 0 else None

    results({}, code=1)
    result = results({HILL: "// fake: breaks"})
    assert result["score"] == 0 and "NOT GRADED" in result["output"], result
    result = results({HILL: "// right", "labs/lab3_hill_climbing/my_tests.cpp": "// fake: own tests break"})
    assert result["score"] == 60 and "my_tests.cpp NOT GRADED" in result["output"], result


def test_entries_without_effect_on_gradescope_are_printed(folder):
    course = folder / "course.toml"
    course.write_text("".join(f"[[adjustment]]\nstudent = '{student}'\nlab = 3\npoints = 1\nreason = 'r'\n"
                              for student in ("s0101", "ada@example.org")))
    (folder / "roster.csv").write_text("id,email\ns0101,ada@example.org\n")
    zip_file = ("--gradescope-zip", folder / "lab3.zip", "--labs", "3", "--course", course)
    printed = grade(*zip_file)
    assert "[[adjustment]] of lab 3 for s0101 has no effect" in printed and "ada@" not in printed, printed
    assert "no effect" not in grade(*zip_file, "--roster", folder / "roster.csv")
    (folder / "no_address.csv").write_text("id,email\ns0101,\n")
    assert "for s0101 has no effect" in grade(*zip_file, "--roster", folder / "no_address.csv")
    names = zipfile.ZipFile(folder / "lab3.zip").namelist()
    assert any(name.endswith("roster.csv") for name in names), "the autograder has the roster"


def test_a_gradescope_zip_is_replaced_as_a_whole(folder):
    out = folder / "lab3.zip"
    out.write_text("the old one")
    cmake = folder / "bin/cmake"
    cmake.parent.mkdir()
    cmake.write_text('#!/bin/sh\necho half >"$4"\nexit 1\n')  # cmake -E tar cf FILE ...
    cmake.chmod(0o755)
    path = os.environ["PATH"]
    os.environ["PATH"] = f"{cmake.parent}:{path}"
    try:
        grade("--gradescope-zip", out, "--labs", "3", code=1)
    finally:
        os.environ["PATH"] = path
    assert out.read_text() == "the old one"
    grade("--gradescope-zip", out, "--labs", "3")
    assert zipfile.is_zipfile(out)


def test_a_missing_file_is_the_starter(folder):
    pack(folder / "class/ada.zip", {"merging.cpp": "// mine"})
    pack(folder / "class/bob.zip", {"labs/lab2_half_edge_mesh/merging.cpp": "// both in one file"})
    grade(folder / "class", "--out", folder / "out")
    assert lab(folder / "out", "ada", 2)["supplied"] == ["half_edge_mesh.cpp"]
    assert lab(folder / "out", "ada", 2)["files"] == ["merging.cpp", "half_edge_mesh.cpp"]
    assert lab(folder / "out", "bob", 2)["supplied"] == [], "a lab's own folder is complete"


def test_a_judge_that_fails_gives_no_mark(folder):
    pack(folder / "class/ada.zip", {HILL: "// fake: breaks", CLIP: "// fine"})
    out = folder / "out"
    printed = grade(folder / "class", "--out", out, code=1)
    assert "NOT GRADED: ada, lab 3" in printed and "told to break" in printed, printed
    row = grades(out)["ada"]
    assert (row["status"], row["percent"], row["lab3"], row["lab5"]) == ("NOT GRADED", "", "", "60"), row
    for kind in ("md", "html"):
        feedback = (out / f"feedback/ada.{kind}").read_text()
        assert "Lab 3: not graded" in feedback and "Lab 5: 60 of 60 points" in feedback, feedback
        assert "Lab 3: 0 of" not in feedback, feedback


def test_a_student_without_a_lab_that_is_graded_is_printed(folder):
    pack(folder / "class/ada.zip", {CLIP: "// another lab"})
    pack(folder / "class/bob-lab3.zip", {HILL: "// right"})
    pack(folder / "class/bob-lab5.zip", {CLIP: "// another lab, beside the one"})
    printed = grade(folder / "class", "--out", folder / "out", "--labs", "3")
    assert "no graded lab: ada" in printed and "no graded lab: bob" not in printed, printed
    assert [grades(folder / "out")[name]["status"] for name in ("ada", "bob")] == ["no graded lab", "graded"]


def test_resume_removes_no_marks(folder):
    small_class(folder / "class")
    grade(folder / "class", "--out", folder / "out", "--labs", "3")
    before = (folder / "out/grades.csv").read_text()
    printed = grade(folder / "class", "--out", folder / "out", "--labs", "1", "--resume", code=2)
    assert "marks of lab 3, which --labs leaves out" in printed, printed
    assert (folder / "out/grades.csv").read_text() == before
    grade(folder / "class", "--out", folder / "out", "--labs", "1,3", "--resume")


def test_resume_keeps_the_records_of_other_submissions(folder):
    roster = folder / "roster.csv"
    roster.write_text("id,name\ns0101,Ada\n")
    out = folder / "out"

    def resumed(*submissions):
        return grade(*submissions, "--out", out, "--labs", "3,5", "--roster", roster, "--resume")

    pack(folder / "week1/s0101.zip", {HILL: "// fake: fails FirstOfEqualVerticesWins"})
    pack(folder / "week2/s0101.zip", {CLIP: "// right"})
    resumed(folder / "week1")
    resumed(folder / "week2")
    assert sorted(marks(out)) == ["s0101-2.json", "s0101.json"], "another folder has another submission"
    assert (grades(out)["s0101"]["lab3"], grades(out)["s0101"]["lab5"]) == ("58", "60"), grades(out)
    before = marks(out)
    resumed(folder / "week2")
    resumed(folder / "week2", folder / "week1")
    assert marks(out) == before, "a submission keeps the name of its record"
    pack(folder / "week1/s0101.zip", {HILL: "// mended"})
    resumed(folder / "week1")
    assert sorted(marks(out)) == sorted(before) and grades(out)["s0101"]["lab3"] == "60", "the file was replaced"
    shutil.move(folder / "week2", folder / "moved")
    resumed(folder / "moved")
    assert sorted(marks(out)) == sorted(before), "a folder that was moved has the same submissions"


def in_time_and_late(folder):
    """The names of two folders with equal submissions."""
    (folder / "course.toml").write_text("[lab.3]\ndue = 2026-10-12T23:59:00+02:00\n"
                                        "[late]\nclock = 'file'\npercent_per_day = 10\n")
    for submission, days_late in (("round1", -1), ("round2", 1)):
        zip_file = folder / submission / "s0101.zip"
        pack(zip_file, {HILL: "// the same"})
        os.utime(zip_file, (1791842340 + 86400 * days_late,) * 2)
    return "round1", "round2"


def test_resume_keeps_an_attempt_in_time_beside_an_equal_late_one(folder):
    for first_is_gone in (False, True):
        out = folder / f"out{first_is_gone:d}"
        for submission in in_time_and_late(folder):
            grade(folder / submission, "--out", out, "--labs", "3", "--resume", "--course", folder / "course.toml")
            if first_is_gone:
                shutil.rmtree(folder / submission)
        assert sorted(marks(out)) == ["s0101-2.json", "s0101.json"], first_is_gone
        assert grades(out)["s0101"]["lab3"] == "60"


def test_a_report_keeps_an_attempt_in_time_from_an_equal_late_one(folder):
    for submission, out in zip(in_time_and_late(folder), ("graded", "other")):
        grade(folder / submission, "--out", folder / out, "--labs", "3", "--course", folder / "course.toml")
    printed = grade("--report", folder / "other", "--out", folder / "graded", code=2)
    assert f"This one lacks the submission {folder}/round1/s0101.zip." in printed, printed
    assert grades(folder / "graded")["s0101"]["lab3"] == "60"
    grade("--report", folder / "graded", folder / "other", "--out", folder / "both")
    assert sorted(marks(folder / "both")) == ["s0101-2.json", "s0101.json"]
    printed = grade("--report", folder / "other", folder / "graded", "--out", folder / "graded", code=2)
    assert f"The record s0101 of {folder}/round1/s0101.zip would be replaced" in printed, printed
    assert f"Name {folder}/graded first" in printed, printed
    assert grades(folder / "graded")["s0101"]["lab3"] == "60"
    grade("--report", folder / "graded", folder / "other", "--out", folder / "graded")


def test_resume_keeps_records_whose_names_are_equal_in_ascii(folder):
    for student, text in (("李明", "// fake: fails FirstOfEqualVerticesWins"), ("王芳", "// right")):
        pack(folder / student / f"{student}.zip", {HILL: text})
        grade(folder / student, "--out", folder / "out", "--labs", "3", "--resume")
    assert [grades(folder / "out")[student]["lab3"] for student in ("李明", "王芳")] == ["58", "60"]


def test_records_are_not_overwritten_without_resume(folder):
    small_class(folder / "class")
    grade(folder / "class", "--out", folder / "out", "--labs", "3")
    assert "--resume" in grade(folder / "class", "--out", folder / "out", "--labs", "3", code=1)
    grade(folder / "class", "--out", folder / "out", "--labs", "3", "--resume")


def test_results_of_other_programs_are_not_reused(folder):
    small_class(folder / "class")
    judge = folder / "judge.sh"

    def reused(text):
        judge.write_text(f'#!/bin/sh\n{text}exec "{FAKE}" "$@"\n')
        judge.chmod(0o755)
        run = subprocess.run([PROGRAM, "--judge", judge, folder / "class", "--out", folder / "out", "--labs", "3",
                              "--resume"], capture_output=True, text=True, check=True,
                             env={**os.environ, "CS550_ROOT": str(ROOT)})
        return re.search(r"(\d+) results? reused", run.stdout)[1]

    assert [reused(""), reused(""), reused("# changed\n")] == ["0", "3", "0"]


def test_a_judge_that_was_rebuilt_meanwhile_gives_no_mark(folder):
    pack(folder / "class/ada.zip", {HILL: "// a"})
    judge = folder / "judge.sh"
    program = f'#!/bin/sh\nexec "{FAKE}" "$@"\n'
    # Replaced by another one while it grades, as a linker does it.
    judge.write_text(program.replace("exec", f'[ "$1" = --probe ] || mv "{folder}/new" "$0"\nexec'))
    (folder / "new").write_text(program)
    for file in (judge, folder / "new"):
        file.chmod(0o755)

    def graded(*more):
        run = subprocess.run([PROGRAM, "--judge", judge, folder / "class", "--out", folder / "out", "--labs", "3", *more],
                             capture_output=True, text=True, check=False, env={**os.environ, "CS550_ROOT": str(ROOT)})
        return run.returncode, " ".join(run.stdout.split()), lab(folder / "out", "ada", 3)["earned"]

    code, printed, _ = graded()
    assert code == 1 and "NOT GRADED: ada, lab 3" in printed and "changed during the run" in printed, printed
    code, printed, earned = graded("--resume")
    assert (code, earned) == (0, 60) and "0 results reused" in printed, printed


def test_results_of_other_mistakes_and_scenes_are_not_reused(folder):
    pack(folder / "class/ada.zip", {HILL: "// a", "labs/lab3_hill_climbing/my_tests.cpp": "// fake: catches 8"})
    pack(folder / "class/bob.zip", {HILL: "// b"})
    root, build = folder / "root", folder / "root/build/test"
    shutil.copytree(ROOT / "framework/assets", root / "framework/assets")
    for name in ("labs", "tests"):
        (root / name).symlink_to(ROOT / name)
    (build / "bin").mkdir(parents=True)
    judge = build / "bin/grade_lab"
    judge.write_text(f'#!/bin/sh\nexec "{FAKE}" "$@"\n')
    judge.chmod(0o755)
    (folder / "course.toml").write_text("[lab.3]\nown_tests = 5\n")

    def reused():
        run = subprocess.run([PROGRAM, "--judge", judge, folder / "class", "--out", folder / "out", "--labs", "3",
                              "--course", folder / "course.toml", "--resume"], capture_output=True, text=True,
                             check=True, env={**os.environ, "CS550_ROOT": str(root)})
        return re.search(r"(\d+) results? reused", run.stdout)[1]

    def change(file, text):
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    mistakes = build / "mistakes/lab3"
    change(mistakes / "a.so", "one")
    assert [reused(), reused()] == ["0", "2"]
    change(mistakes / "b.so", "two")
    assert reused() == "1", "of the student without tests"
    for i in range(9):  # the order of a folder is not that of its names
        change(mistakes / f"{i}.so", str(i))
    assert [reused(), reused()] == ["1", "2"]
    change(build / "mistakes/lab4/a.so", "of another lab")
    assert reused() == "2"
    for kind in ("trajectories/lab3_ghosts.csv", "scenes/ghosts.json", "meshes/hull16.json"):
        change(root / "framework/assets" / kind, "another")
        assert [reused(), reused()] == ["0", "2"], kind


def test_a_project_behind_links_has_its_version(folder):
    if not (ROOT / ".git").exists():
        print("  (no history: skipped)")
        return
    pack(folder / "ada.zip", {HILL: "// a"})
    project, links = folder / "project", folder / "links"
    subprocess.run(["git", "clone", "--quiet", ROOT, project], check=True)
    links.mkdir()
    for file in project.iterdir():  # as the launcher makes them for CS550_BUILD_DIR
        (links / file.name).symlink_to(file)
    commit = subprocess.run(["git", "-C", project, "rev-parse", "HEAD"], capture_output=True, text=True,
                            check=True).stdout.strip()

    def version(out):
        grade(folder / "ada.zip", "--out", folder / out, "--labs", "3", root=links)
        return record(folder / out, "ada")["project"]

    assert version("clean") == commit
    (project / "README.md").write_text("changed")
    assert version("changed") == commit + "+changes"


def test_a_changed_starter_is_refused(folder):
    if not (ROOT / ".git").exists():
        print("  (no history: skipped)")
        return
    pack(folder / "ada.zip", {"hill_climbing.cpp": "// a"})
    project, zip_file = folder / "project", folder / "lab3.zip"
    subprocess.run(["git", "clone", "--quiet", ROOT, project], check=True)
    lab3 = project / "labs/lab3_hill_climbing"

    def graded(code):
        shutil.rmtree(folder / "out", ignore_errors=True)
        zip_file.unlink(missing_ok=True)
        printed = grade(folder / "ada.zip", "--out", folder / "out", "--labs", "3", root=project, code=code)
        also = grade("--gradescope-zip", zip_file, "--labs", "3", root=project, code=code)
        assert zip_file.exists() == (folder / "out").exists() == (code == 0)
        return printed if printed == also else printed + also

    starter = (lab3 / "hill_climbing.cpp").read_text()
    (project / "labs/lab5_clipping/clipping.cpp").write_text("// of a lab that is not graded")
    for name in ("my_tests.cpp", "hill_climbing.cpp.bak-1", "README.md"):
        (lab3 / name).write_text("// no code of the lab")
    graded(0)
    assert lab(folder / "out", "ada", 3)["supplied"] == []
    for name in ("hill_climbing.cpp", "mine.cpp"):
        (lab3 / name).write_text("// my own")
        printed = graded(1)
        assert f"labs/lab3_hill_climbing differs from the starter: {name}" in printed, printed
        assert "./cs550 lab 3 --reset restores" in printed and "subfolder" not in printed, printed
        (lab3 / "hill_climbing.cpp").write_text(starter)
    (lab3 / "mine.cpp").unlink()
    (lab3 / "more").mkdir()
    (lab3 / "more/part.cpp").write_text("// in a folder that --reset leaves as it is")
    printed = graded(1)
    assert "more/part.cpp" in printed and "elsewhere" in printed and "--reset restores" not in printed, printed
    shutil.rmtree(lab3 / "more")
    (lab3 / "hill_climbing.cpp").write_text("// in Git's index, but not in the folder")
    subprocess.run(["git", "-C", project, "add", "--all"], check=True)
    (lab3 / "hill_climbing.cpp").write_text(starter)
    (lab3 / "hill_climbing.cpp").chmod(0o755)
    regrade = (folder / "ada.zip", "--out", folder / "out", "--labs", "3", "--resume")
    grade(*regrade, root=project)
    zip_of_lab3 = ("--gradescope-zip", zip_file, "--labs", "3")
    printed = grade(*zip_of_lab3, root=project, code=1)
    assert "Git's index does not have the starter of lab 3" in printed and not zip_file.exists(), printed
    unstage = re.search(r"git restore --staged \S+", printed)[0]
    subprocess.run(unstage.split(), check=True, cwd=project)
    grade(*zip_of_lab3, root=project)
    subprocess.run(["git", "-C", project, "rm", "--quiet", "--cached", lab3 / "hill_climbing.cpp"], check=True)
    (lab3 / "hill_climbing.cpp").write_text("// my own")
    printed = grade(*regrade, root=project, code=1)
    assert printed.count("hill_climbing.cpp") == 1, printed

    subprocess.run(["git", "-C", project, "reset", "--quiet"], check=True)
    (folder / "config/git").mkdir(parents=True)
    (folder / "config/git/ignore").symlink_to("ignore")  # Git prints a warning that it cannot read this
    (lab3 / "hill_climbing.cpp").write_text(starter)
    os.environ["XDG_CONFIG_HOME"] = str(folder / "config")
    try:
        grade(*regrade, root=project)
    finally:
        del os.environ["XDG_CONFIG_HOME"]
    (lab3 / "hill_climbing.cpp").write_text("// my own")
    if os.geteuid() == 0:
        subprocess.run(["chown", "--recursive", "65534", project], check=True)
        assert "differs from the starter" in grade(*regrade, root=project, code=1)
    (project / ".git/HEAD").unlink()
    assert "cannot check that labs/ has the starters: git failed: fatal" in grade(*regrade, root=project)
    shutil.rmtree(project / ".git")
    assert "cannot check" not in grade(*regrade, root=project)


def test_sources_are_not_compared_with_a_changed_starter(folder):
    if not (ROOT / ".git").exists():
        print("  (no history: skipped)")
        return
    pack(folder / "ada.zip", {HILL: "// a"})
    project = folder / "project"
    subprocess.run(["git", "clone", "--quiet", ROOT, project], check=True)
    for name in (HILL, CLIP):
        (project / name).write_text("// the solution")
    export = (folder / "ada.zip", "--export-jplag", folder / "sources")
    assert "labs/lab3_hill_climbing differs from the starter" in grade(*export, root=project, code=1)
    assert not (folder / "sources").exists()
    subprocess.run(["git", "-C", project, "checkout", "--quiet", HILL], check=True)
    grade(*export, root=project)


def test_the_judge_learns_how_many_run_at_a_time(folder):
    small_class(folder / "class")
    judge = folder / "judge.sh"
    judge.write_text(f'#!/bin/sh\necho "$*" >>{folder}/log\nexec "{FAKE}" "$@"\n')
    judge.chmod(0o755)
    subprocess.run([PROGRAM, "--judge", judge, folder / "class", "--out", folder / "out", "--labs", "3", "--jobs", "2"],
                   capture_output=True, check=True, env={**os.environ, "CS550_ROOT": str(ROOT)})
    runs = [line for line in (folder / "log").read_text().splitlines() if "--submission" in line]
    assert len(runs) == 3 and all("--jobs 2" in line for line in runs), runs


def test_a_timeout_is_graded_again(folder):
    pack(folder / "class/ada.zip", {HILL: "// fake: times out FirstOfEqualVerticesWins"})
    pack(folder / "class/bob.zip", {HILL: "// all right"})
    for known in ("0 results reused", "1 result reused"):
        printed = grade(folder / "class", "--out", folder / "out", "--labs", "3", "--resume")
        assert known in printed and "timeout: ada" in printed, printed


def test_a_compiler_that_was_stopped_is_a_timeout(folder):
    pack(folder / "class/ada.zip", {HILL: "// fake: compiler stopped"})
    out = folder / "out"
    for _ in range(2):
        printed = grade(folder / "class", "--out", out, "--labs", "3", "--resume")
        assert "0 results reused" in printed and "timeout: ada, lab 3" in printed, printed
    notes = grades(out)["ada"]["notes"]
    assert "ended at the limit of time" in notes and "does not compile" not in notes, notes
    for report in ("feedback/ada.md", "feedback/ada.html", "gradescope/ada.json"):
        text = (out / report).read_text()
        assert "was not compiled" in text and "does not compile" not in text, report


def test_own_tests_whose_compiler_was_stopped_are_graded_again(folder):
    pack(folder / "class/ada.zip",
         {HILL: "// a", "labs/lab3_hill_climbing/my_tests.cpp": "// fake: own compiler stopped"})
    (folder / "course.toml").write_text("[lab.3]\nown_tests = 5\n")
    for _ in range(2):
        printed = grade(folder / "class", "--out", folder / "out", "--labs", "3", "--course", folder / "course.toml",
                        "--resume")
        assert "0 results reused" in printed, printed
        assert "timeout: ada, lab 3: the compiler of my_tests.cpp was stopped" in printed, printed
    row = grades(folder / "out")["ada"]
    assert row["lab3"] == "60", "no bonus"
    assert "my_tests.cpp was stopped: grade again" in row["notes"], row
    pack(folder / "class/ada.zip", {HILL: "// a", "labs/lab3_hill_climbing/my_tests.cpp": "// fake: catches 8"})
    grade(folder / "class", "--out", folder / "new", "--labs", "3", "--course", folder / "course.toml")
    compared = grade("--compare", folder / "out", folder / "new")
    assert "my_tests.cpp: not compiled -> 8 of 20 known mistakes" in compared, compared
    for text in (row["notes"], (folder / "out/feedback/ada.md").read_text()):
        assert "was not compiled" in text and "does not compile" not in text, text


def test_own_tests_that_ran_out_of_time_are_graded_again(folder):
    pack(folder / "class/ada.zip",
         {HILL: "// a", "labs/lab3_hill_climbing/my_tests.cpp": "// fake: own tests time out"})
    (folder / "course.toml").write_text("[lab.3]\nown_tests = 5\n")
    for _ in range(2):
        printed = grade(folder / "class", "--out", folder / "out", "--labs", "3", "--course", folder / "course.toml",
                        "--resume")
        assert "0 results reused" in printed, printed
        assert "timeout: ada, lab 3: my_tests.cpp was stopped" in printed, printed


def test_own_tests_that_cannot_be_graded_cost_nothing_else(folder):
    pack(folder / "class/ada.zip", {HILL: "// a", "labs/lab3_hill_climbing/my_tests.cpp": "// fake: own tests break"})
    course = folder / "course.toml"
    course.write_text("[lab.3]\nown_tests = 5\n")
    out = folder / "out"
    printed = grade(folder / "class", "--out", out, "--labs", "3", "--course", course, code=1)
    assert "my_tests.cpp NOT GRADED: ada, lab 3" in printed and "no mistakes" in printed, printed
    row = grades(out)["ada"]
    assert (row["status"], row["lab3"]) == ("graded", "60") and "NOT GRADED" in row["notes"], row
    assert "0 results reused" in grade(folder / "class", "--out", out, "--labs", "3", "--resume", code=1)


def test_grading_twice_gives_the_same_marks(folder):
    small_class(folder / "class")
    for out in ("one", "two"):
        grade(folder / "class", "--out", folder / out, "--jobs", "3" if out == "two" else "1")
    assert marks(folder / "one") == marks(folder / "two")
    assert (folder / "one/grades.csv").read_text() == (folder / "two/grades.csv").read_text()


def test_an_interrupted_run_continues(folder):
    for i in range(12):
        pack(folder / "class" / f"s{i:02}.zip", {HILL: f"// {i} fake: sleeps 0.1", CLIP: f"// {i}"})
    whole, out = folder / "whole", folder / "out"
    grade(folder / "class", "--out", whole)
    environment = {**os.environ, "CS550_ROOT": str(ROOT)}
    for number, pause in enumerate((0.15, 0.4, 0.7)):
        run = subprocess.Popen(command(folder / "class", "--out", out, "--jobs", 2, "--resume"), env=environment,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
        time.sleep(pause)
        # Ctrl-C, another signal, and a crash that nothing can be done about
        os.killpg(run.pid, (signal.SIGINT, signal.SIGTERM, signal.SIGKILL)[number])
        run.wait()
        for file in (out / "records").glob("*.json"):
            json.loads(file.read_text())
    grade(folder / "class", "--out", out, "--resume")
    assert marks(out) == marks(whole)
    assert not (out / "work").exists()


def test_a_report_of_an_interrupted_run_says_so(folder):
    for i in range(12):
        pack(folder / "class" / f"s{i:02}.zip", {HILL: f"// {i} fake: sleeps 0.1"})
    out = folder / "out"
    run = subprocess.Popen(command(folder / "class", "--out", out, "--labs", "3", "--jobs", 1), start_new_session=True,
                           env={**os.environ, "CS550_ROOT": str(ROOT)}, stdout=subprocess.DEVNULL)
    while not list((out / "records").glob("*.json")):
        time.sleep(0.02)
    os.killpg(run.pid, signal.SIGINT)
    run.wait()
    assert "this run was interrupted" in grade("--report", out)
    grade(folder / "class", "--out", out, "--labs", "3", "--resume")
    assert "this run was interrupted" not in grade("--report", out)


def test_a_second_grader_is_refused(folder):
    pack(folder / "ada.zip", {HILL: "// fake: sleeps 3"})
    out = folder / "out"
    first = subprocess.Popen(command(folder / "ada.zip", "--out", out), env={**os.environ, "CS550_ROOT": str(ROOT)},
                             stdout=subprocess.DEVNULL)
    while not (out / "work").exists():
        time.sleep(0.02)
    printed = grade(folder / "ada.zip", "--out", out, "--resume", code=1)
    assert "another grader is at work" in printed, printed
    assert first.wait() == 0


def test_a_file_system_without_locks_is_no_other_grader(folder):
    small_class(folder / "class")
    (folder / "flock.c").write_text("#include <errno.h>\nint flock(int f, int how) { errno = ENOLCK; return -1; }\n")
    no_locks = folder / "flock.so"
    compiler = next(filter(None, map(shutil.which, ("cc", "gcc", "clang"))))
    subprocess.run([compiler, "-shared", "-fPIC", "-w", folder / "flock.c", "-o", no_locks], check=True)
    run = subprocess.run(command(folder / "class", "--out", folder / "out", "--labs", "3"), capture_output=True,
                         text=True, check=False, timeout=120,
                         env={**os.environ, "CS550_ROOT": str(ROOT), "LD_PRELOAD": str(no_locks)})
    assert run.returncode == 0, run.stderr
    warning = " ".join(run.stderr.split())
    assert warning.count("Cannot lock") == 1 and "do not run another ./cs550 grade" in warning, run.stderr
    assert len(grades(folder / "out")) == 4


def test_a_full_disk_leaves_no_half_record(folder):
    small_class(folder / "class")
    out = folder / "out"
    # The result of the fake has 3 kB, what is stored of it has 5 kB.
    printed = grade(folder / "class", "--out", out, "--labs", "3", code=1,
                    preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4000, 4000)))
    assert "cannot write" in printed or "NOT GRADED" in printed, printed
    for file in (out / "records").glob("*.json"):
        json.loads(file.read_text())
    shutil.rmtree(out)
    grade(folder / "class", "--out", out, "--labs", "3")


def test_a_full_file_system_is_reported(folder):
    out = folder / "out"
    out.mkdir()
    small_class(folder / "class")
    if os.geteuid() != 0 or subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "none", str(out)],
                                           capture_output=True, check=False).returncode:
        print("  (not allowed to mount: skipped)")
        return
    try:
        (out / "filler").write_bytes(b"x" * 60000)
        printed = grade(folder / "class", "--out", out, code=1)
        assert "cannot write" in printed or "NOT GRADED" in printed, printed
        (out / "filler").unlink()
    finally:
        subprocess.run(["umount", str(out)], check=True)


def test_reports_are_made_again_from_records(folder):
    small_class(folder / "class")
    out = folder / "out"
    grade(folder / "class", "--out", out, "--labs", "3,5")
    reports = {f.relative_to(out): f.read_bytes() for f in out.rglob("*.*") if f.parent.name in (
        "feedback", "gradescope", "junit", "classroom") or f.name in ("grades.csv", "class.html")}
    assert len(reports) == 2 + 5 * 4, sorted(reports)
    for file in reports:
        (out / file).unlink()
    grade("--report", out)
    assert reports == {file: (out / file).read_bytes() for file in reports}
    assert "Not in this submission: lab 5." in reports[Path("feedback/bob.md")].decode()
    assert "FirstOfEqualVerticesWins" in reports[Path("feedback/bob.html")].decode()
    (folder / "course.toml").write_text("secret = 'x'\n[lab.3]\npoints = 120\n")
    grade("--report", out, "--course", folder / "course.toml")
    assert grades(out)["ada"]["lab3"] == "120"
    grade("--report", out)
    assert grades(out)["ada"]["lab3"] == "120", "the course file is remembered"
    grade("--report", out, "--out", folder / "shared", "--pseudonyms")
    for file in (folder / "shared").rglob("*.*"):
        assert not re.search(rb"\b(ada|bob|eve)\b", file.read_bytes()), f"{file} has a name"
    grade("--report", out, "--out", folder / "again", "--pseudonyms")
    grade("--report", out, "--out", folder / "again", "--pseudonyms")
    grade("--report", out, "--out", folder / "named")
    for kept in ("records", "course.toml", "roster.csv"):
        for other in {"records", "course.toml", "roster.csv"} - {kept}:
            old = folder / "named" / other
            shutil.rmtree(old) if old.is_dir() else old.unlink(missing_ok=True)
        if kept == "roster.csv":
            (folder / "named/roster.csv").write_text("id\nada\n")
        before = sorted((folder / "named").rglob("*"))
        printed = grade("--report", out, "--out", folder / "named", "--pseudonyms", code=2)
        assert f"has {kept} of an earlier report" in printed and "another --out" in printed, printed
        assert sorted((folder / "named").rglob("*")) == before
        grade("--report", out, "--out", folder / "named")
    assert (out / "course.toml").stat().st_mode & 0o077 == 0
    assert out.stat().st_mode & 0o077 == 0, "records are for the instructor alone"


def test_a_secret_salts_the_seeds(folder):
    small_class(folder / "class")
    course = folder / "course.toml"

    def seed_with(secret, out):
        course.write_text(f"secret = '{secret}'\n")
        grade(folder / "class", "--out", folder / out, "--labs", "3", "--course", course)
        return lab(folder / out, "ada", 3)["seed"]

    assert 1 <= int(seed_with("x", "first").removeprefix("salt ")) <= 2 ** 28
    assert lab(folder / "first", "ada", 3)["seed"] == seed_with("x", "again") != seed_with("y", "other")
    grade(folder / "class", "--out", folder / "published", "--labs", "3")
    assert lab(folder / "published", "ada", 3)["seed"] == "published"


def test_a_secret_with_which_the_reference_fails_is_refused(folder):
    small_class(folder / "class")
    root = folder / "root"
    shutil.copytree(ROOT / "solutions", root / "solutions")
    for name in ("labs", "tests"):
        (root / name).symlink_to(ROOT / name)
    (root / "solutions/lab3_hill_climbing/hill_climbing.cpp").write_text("// fake: fails FirstOfEqualVerticesWins")
    (folder / "course.toml").write_text("secret = 'x'\n")
    grading = [folder / "class", "--out", folder / "out", "--labs", "3,5"]
    grade(*grading, root=root)
    shutil.rmtree(folder / "out")
    printed = grade(*grading, "--course", folder / "course.toml", code=1, root=root)
    assert "Lab3.FirstOfEqualVerticesWins" in printed and "another secret" in printed, printed
    assert not list((folder / "out").glob("records/*")), "nobody was graded"
    no_work_is_left(folder / "out")


def test_folders_are_merged(folder):
    small_class(folder / "class")
    grade(folder / "class", "--out", folder / "whole", "--labs", "3,5")
    grade(folder / "class", "--out", folder / "a", "--labs", "3")
    grade(folder / "class/ada.zip", "--out", folder / "b", "--labs", "5")
    assert "--out" in grade("--report", folder / "a", folder / "b", code=2)
    grade("--report", folder / "a", folder / "b", "--out", folder / "both")
    assert marks(folder / "both")["ada.json"] == marks(folder / "whole")["ada.json"]
    assert len(marks(folder / "both")) == 4


def test_a_report_leaves_no_records_of_an_earlier_one(folder):
    for name in ("ada", "bob"):
        pack(folder / f"{name}.zip", {HILL: f"// {name}"})
        grade(folder / f"{name}.zip", "--out", folder / name, "--labs", "3")
    both = ("--report", folder / "ada", folder / "bob", "--out", folder / "both")
    grade(*both)
    grade(*both)
    printed = grade("--report", folder / "ada", "--out", folder / "both", code=2)
    assert f"This one lacks the submission {folder}/bob.zip." in printed and "another --out" in printed, printed
    assert grades(folder / "both").keys() == {"ada", "bob"}


def test_a_report_replaces_no_record_of_another_submission(folder):
    pack(folder / "week3/s0101.zip", {HILL: "// lab 3"})
    pack(folder / "week4/s0101.zip", {CLIP: "// another lab"})
    grade(folder / "week3", "--out", folder / "graded", "--labs", "3")
    before = (folder / "graded/records/s0101.json").read_text()

    def refused(out, lacks=f"the submission {folder}/week3/s0101.zip"):
        printed = grade("--report", folder / out, "--out", folder / "graded", code=2)
        assert f"This one lacks {lacks}. Choose another --out" in printed, printed
        assert "--report OLD NEW --out MERGED" in printed, printed
        assert (folder / "graded/records/s0101.json").read_text() == before

    grade(folder / "week4", "--out", folder / "other", "--labs", "5")
    refused("other")
    grade(folder / "week4", "--out", folder / "both_labs", "--labs", "3,5")
    refused("both_labs")
    grade(folder / "week3", "--out", folder / "same", "--labs", "5")
    refused("same", lacks="results for lab 3 of s0101")
    shutil.copytree(folder / "week3", folder / "moved")
    grade(folder / "moved", "--out", folder / "again", "--labs", "3,5")
    grade("--report", folder / "again", "--out", folder / "graded")
    assert [lab[:2] for lab in marks(folder / "graded")["s0101.json"]] == [(3, 60), (5, 0)]


def test_a_report_removes_no_milestones(folder):
    topic, = (ROOT / "labs").glob("lab1_*")
    pack(folder / "ada.zip", {f"labs/{topic.name}/{file.name}": "// right" for file in topic.glob("*.cpp")})
    grade(folder / "ada.zip", "--out", folder / "with", "--labs", "1", "--milestones")
    grade(folder / "ada.zip", "--out", folder / "without", "--labs", "1")
    printed = grade("--report", folder / "without", "--out", folder / "with", code=2)
    assert "This one lacks milestones of ada." in printed, printed
    assert "engine" in record(folder / "with", "ada")
    grade("--report", folder / "with", folder / "without", "--out", folder / "both")
    assert "engine" in record(folder / "both", "ada")
    grade(folder / "ada.zip", "--out", folder / "more", "--labs", "1-2", "--milestones")
    before = record(folder / "more", "ada")["engine"]
    assert "This one lacks results for lab 2" in grade("--report", folder / "with", "--out", folder / "more", code=2)
    grade("--report", folder / "with", folder / "more", "--out", folder / "more")
    assert record(folder / "more", "ada")["engine"] == before, "those of lab 2 stay"


def test_a_report_removes_no_results_where_the_grader_fails(folder):
    topic, = (ROOT / "labs").glob("lab1_*")
    source = f"labs/{topic.name}/integration.cpp"
    tests = f"labs/{topic.name}/my_tests.cpp"
    (folder / "course.toml").write_text("[lab.1]\nown_tests = 5\n[milestones]\nweight = 1\n")
    faults = {"nothing": (), "own": (tests, "// fake: own tests break"), "all": (source, "// fake: breaks")}
    for fault, change in faults.items():
        files = {source: "// right", tests: "// fake: catches 8"}
        pack(folder / "ada.zip", {**files, **dict([change] if change else [])})
        grade(folder / "ada.zip", "--out", folder / fault, "--labs", "1", "--course", folder / "course.toml",
              code=1 if change else 0)
    for new, out in (("own", "nothing"), ("all", "nothing"), ("all", "own")):
        printed = grade("--report", folder / new, "--out", folder / out, code=2)
        assert "This one lacks results for lab 1 of ada." in printed, printed
        assert lab(folder / out, "ada", 1)["earned"] == 60
    grade("--report", folder / "nothing", "--out", folder / "all")
    assert lab(folder / "all", "ada", 1)["earned"] == 60


def test_a_pseudonymous_report_replaces_its_own_earlier_one(folder):
    late = "secret = 'x'\n[late]\nclock = 'file'\npercent_per_day = 10\n[lab.3]\ndue = 2026-10-{}T23:59:00+02:00\n"
    zip_file = folder / "class/s0101.zip"
    pack(zip_file, {HILL: "// right"})
    os.utime(zip_file, (1791842340,) * 2)
    out, shared = folder / "graded", folder / "shared"

    def report():
        grade("--report", out, "--out", shared, "--pseudonyms", "--course", folder / "course.toml")
        return len(list((shared / "records").iterdir()))

    (folder / "course.toml").write_text(late.format(12))
    grade(folder / "class", "--out", out, "--labs", "3", "--course", folder / "course.toml")
    assert report() == 1
    (folder / "course.toml").write_text(late.format(19))
    assert report() == 1, "another date"
    pack(folder / "class/s0101-lab3.zip", {HILL: "// later"})
    grade(folder / "class", "--out", out, "--labs", "3", "--resume", "--course", folder / "course.toml")
    assert report() == 2, "a later attempt"
    pack(folder / "other/s0101.zip", {HILL: "// another one"})
    grade(folder / "other", "--out", folder / "part", "--labs", "3", "--course", folder / "course.toml")
    printed = grade("--report", folder / "part", "--out", shared, "--pseudonyms", code=2)
    assert "lacks the submission student-" in printed and "merge" not in printed, printed


def test_pseudonyms_need_a_secret(folder):
    pack(folder / "ada.zip", {HILL: "// right"})
    grade(folder / "ada.zip", "--out", folder / "out", "--labs", "3")
    assert "needs a secret" in grade("--report", folder / "out", "--out", folder / "shared", "--pseudonyms", code=2)
    assert not (folder / "shared").exists()


def test_a_regrade_is_compared(folder):
    pack(folder / "ada.zip", {HILL: "// fake: fails FirstOfEqualVerticesWins"})
    grade(folder / "ada.zip", "--out", folder / "old", "--labs", "3")
    pack(folder / "ada.zip", {HILL: "// mended"})
    grade(folder / "ada.zip", "--out", folder / "new", "--labs", "3")
    printed = grade("--compare", folder / "old", folder / "new")
    assert "ada, lab 3: 58 of 60 -> 60 of 60 (other files)" in printed, printed
    assert "Lab3.FirstOfEqualVerticesWins: failed -> passed (+2 points)" in printed, printed


def test_judges_are_built_after_the_arguments_are_checked(folder):
    pack(folder / "ada.zip", {HILL: "// good"})
    root = folder / "project"
    (root / "build/test/bin").mkdir(parents=True)
    for name in ("labs", "tests", "framework", "CMakeLists.txt"):
        (root / name).symlink_to(ROOT / name)
    for name, script in {"build/test/bin/grade_lab": f'exec {FAKE} "$@"',
                         "cs550": f'echo "$*" >>{folder}/built\n[ ! -e {folder}/broken ]'}.items():
        (root / name).write_text(f"#!/bin/sh\n{script}\n")
        (root / name).chmod(0o755)

    def grade_with_own_judges(*arguments, code=0):
        run = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=120,
                             check=False, env={**os.environ, "CS550_ROOT": str(root)})
        assert run.returncode == code, f"{arguments}: exit code {run.returncode}\n{run.stdout}{run.stderr}"
        return run.stderr

    out = folder / "out"
    grade_with_own_judges(folder / "nobody.zip", "--out", out, code=1)
    grade_with_own_judges(folder / "ada.zip", "--out", out, "--labs", "9", code=2)
    grade_with_own_judges(folder / "ada.zip", code=2)
    assert not (folder / "built").exists(), "judges were built for arguments that make no sense"
    (folder / "broken").touch()
    assert "could not be built" in grade_with_own_judges(folder / "ada.zip", "--out", out, code=1)
    (folder / "broken").unlink()
    grade_with_own_judges(folder / "ada.zip", "--out", out, "--labs", "3")
    assert (folder / "built").read_text() == "build test judges\n" * 2
    grade_with_own_judges("--report", out)
    assert (folder / "built").read_text().count("\n") == 2, "reports need no judge"


def test_arguments_that_cannot_be_meant_are_refused(folder):
    pack(folder / "ada.zip", {HILL: "// good"})
    out = folder / "out"
    assert "lab 1" in grade(folder / "ada.zip", "--out", out, "--labs", "3", "--milestones", code=2)
    assert "empty list" in grade(folder / "ada.zip", "--out", out, "--labs", "", code=2)
    grade(folder / "ada.zip", "--out", out, "--labs", "3")
    assert "take no submissions" in grade(folder / "ada.zip", "--report", out, code=2)
    assert "has no records" in grade("--compare", out, folder, code=1)
    assert "there is no folder" in grade("--gradescope-zip", folder / "none/a.zip", "--labs", "3", code=1)


def test_a_run_is_resumed_with_its_own_secret(folder):
    pack(folder / "ada.zip", {HILL: "// good"})
    for name, secret in (("a.toml", "one"), ("b.toml", "two")):
        (folder / name).write_text(f"secret = '{secret}'\n")
    out = folder / "out"
    grade(folder / "ada.zip", "--out", out, "--labs", "3", "--course", folder / "a.toml")
    printed = grade(folder / "ada.zip", "--out", out, "--labs", "3", "--resume", "--course", folder / "b.toml", code=2)
    assert "another secret" in printed, printed
    assert "one" in (out / "course.toml").read_text(), "the settings of the run were replaced"
    grade(folder / "ada.zip", "--out", out, "--labs", "3", "--resume", "--course", folder / "a.toml")
    out = folder / "published"
    grade(folder / "ada.zip", "--out", out, "--labs", "3")
    grade("--report", out, "--course", folder / "a.toml")
    printed = grade(folder / "ada.zip", "--out", out, "--labs", "3,5", "--resume", code=2)
    assert "another secret" in printed, "the secret of a report is not that of the run"
    (folder / "none.toml").write_text("")
    grade(folder / "ada.zip", "--out", out, "--labs", "3,5", "--resume", "--course", folder / "none.toml")


def test_a_lab_that_no_run_graded_is_named(folder):
    small_class(folder / "class")
    grade(folder / "class", "--out", folder / "out", "--labs", "3")
    printed = grade(folder / "class/ada.zip", "--out", folder / "out", "--labs", "3,5", "--resume")
    assert "bob, lab 5: counts as 0, but no run graded it" in printed, printed
    assert "ada, lab 5" not in printed, printed


def test_sources_are_exported_for_copy_detectors(folder):
    small_class(folder / "class")
    printed = grade(folder / "class", "--export-jplag", folder / "sources")
    assert "jplag -l cpp -bc" in printed and "moss -l cc -d" in printed, printed
    files = sorted(str(f.relative_to(folder / "sources")) for f in (folder / "sources").rglob("*.cpp"))
    assert files == ["lab3/base/hill_climbing.cpp", *(f"lab3/submissions/{s}/hill_climbing.cpp" for s in (
        "ada", "bob", "eve")), "lab5/base/clipping.cpp", "lab5/submissions/ada/clipping.cpp"], files
    assert "not empty" in grade(folder / "class", "--export-jplag", folder / "sources", code=1)


def test_an_export_lists_what_it_leaves_out(folder):
    pack(folder / "class/ada.zip", {HILL: "// a"})
    (folder / "class/bob.zip").symlink_to("ada.zip")
    printed = grade(folder / "class", "--export-jplag", folder / "sources")
    assert f"skipped: {folder}/class/bob.zip: a symbolic link, which is not followed" in printed, printed


def test_the_commands_of_an_export_work_with_any_path(folder):
    small_class(folder / "class")
    place = folder / "what's copied"
    exported = subprocess.run(command(folder / "class", "--export-jplag", place), capture_output=True, text=True,
                              timeout=120, check=True, env={**os.environ, "CS550_ROOT": str(ROOT)}).stdout
    (folder / "bin").mkdir()
    for detector in ("jplag", "moss"):
        program = folder / "bin" / detector
        program.write_text('#!/bin/sh\nfor word; do case $word in /*|base*|sub*) ls -d "$word" || exit 1; esac; done\n')
        program.chmod(0o755)
    commands = "".join(line + "\n" for line in exported.splitlines() if "jplag" in line or "moss" in line)
    found = subprocess.run(["sh", "-ec", commands], capture_output=True, text=True, timeout=60, check=False,
                           env={**os.environ, "PATH": f"{folder}/bin:{os.environ['PATH']}"})
    assert found.returncode == 0, f"{commands}{found.stderr}"
    for file in (f"{place}/lab3/base", f"{place}/lab5/submissions", "base/hill_climbing.cpp",
                 "submissions/eve/hill_climbing.cpp"):
        assert file in found.stdout.splitlines(), f"{file}:\n{commands}{found.stdout}"


def test_the_documented_commands_work(folder):
    section = (ROOT / "docs/instructors.md").read_text().split("## Grading a class")[1].split("\n## ")[0]
    for name, kind in (("roster.csv", "csv"), ("course.toml", "toml")):
        (folder / name).write_text(re.search(rf"```{kind}\n(.*?)```", section, re.DOTALL)[1])
    small_class(folder / "class")
    (folder / "class/zoe").rmdir()
    for part in ("part1", "part2"):
        grade(folder / "class", "--out", folder / part, "--labs", part[-1])
    front_door = folder / "cs550"
    front_door.write_text(f'#!/bin/sh\nshift\nexec "{PROGRAM}" --judge "{FAKE}" "$@"\n')
    front_door.chmod(0o755)
    commands = [line for block in re.findall(r"```sh\n(.*?)```", section, re.DOTALL)
                for line in block.replace("\\\n", " ").splitlines()]
    assert len(commands) >= 8, commands
    for line in commands:
        if line.startswith("sbatch") or "ctest" in line:
            continue  # slurm_test.sh, check_ctest_verdicts.py
        if line.startswith("./cs550 build"):
            continue
        if "classroom-clones/" in line:
            shutil.copytree(folder / "class", folder / "classroom-clones")
            shutil.rmtree(folder / "graded")
        if line.startswith("parallel") and not shutil.which("parallel"):
            line = "for s in class/*; do ./cs550 grade $s --out parts/$(basename $s .zip) --course course.toml; done"
        run = subprocess.run(["sh", "-c", line], cwd=folder, capture_output=True, text=True, check=False,
                             env={**os.environ, "CS550_ROOT": str(ROOT)})
        assert run.returncode == 0, f"{line}\n{run.stdout}{run.stderr}"


def test_settings_are_named_or_those_of_the_run(folder):
    pack(folder / "class/ada.zip", {HILL: "// right"})
    (folder / "course.toml").write_text("[lab.3]\npoints = 100\n")
    (folder / "roster.csv").write_text("id\nbob\n")
    grade(folder / "class", "--out", folder / "out", "--labs", "3", cwd=folder)
    assert grades(folder / "out").keys() == {"ada"} and grades(folder / "out")["ada"]["lab3"] == "60"
    grade(folder / "class", "--out", folder / "named", "--labs", "3", "--course", "course.toml", cwd=folder)
    grade(folder / "class", "--out", folder / "named", "--labs", "3", "--resume")
    assert grades(folder / "named")["ada"]["lab3"] == "100", "a resumed run keeps its settings"


def test_entries_about_nobody_are_printed(folder):
    small_class(folder / "class")
    (folder / "course.toml").write_text("[[adjustment]]\nstudent = 'ade'\nlab = 3\npoints = 1\nreason = 'x'\n")
    course = ("--course", folder / "course.toml")
    message = "no such student: [[adjustment]] of lab 3 for ade"
    assert message in grade(folder / "class", "--out", folder / "out", "--labs", "3", *course)
    assert message in grade("--report", folder / "out", *course)
    assert message not in grade(folder / "class/ada.zip", "--out", folder / "part", "--labs", "3", *course)


def test_two_extensions_of_one_student_are_refused(folder):
    pack(folder / "s0101.zip", {HILL: "// right"})
    (folder / "course.toml").write_text("".join(
        f"[[extension]]\nstudent = '{student}'\nlab = {lab}\ndue = 2026-10-19T23:59:00+02:00\nreason = 'r'\n"
        for student, lab in (("S0101", 3), ("ada@example.org", 5), ("ada@example.org", 3))))
    (folder / "roster.csv").write_text("id,email\ns0102,b@example.org\ns0101,Ada@example.org\n")
    options = (folder / "s0101.zip", "--labs", "3", "--course", folder / "course.toml")
    printed = grade(*options, "--out", folder / "out", "--roster", folder / "roster.csv", code=1)
    assert "of lab 3 for S0101 and for ada@example.org are about one student" in printed, printed
    assert not (folder / "out").exists()
    grade(*options, "--out", folder / "unknown")


def test_wrong_usage(folder):
    pack(folder / "ada.zip", {HILL: ""})
    (folder / "bad.toml").write_text("[late]\nclock = 'sun'\n")
    (folder / "notes.txt").write_text("")
    for arguments, code, message in (
            ((), 2, "at least one submission"),
            ((folder / "ada.zip",), 2, "--out"),
            ((folder / "ada.zip", "--out", folder / "o", "--labs", "8-99"), 2, "there is no lab"),
            ((folder / "ada.zip", "--out", folder / "o", "--labs", "all"), 2, "1-7"),
            ((folder / "ada.zip", "--out", folder / "o", "--labs", "3-1"), 2, "1-3; found 3-1"),
            ((folder / "ada.zip", "--out", folder / "o", "--labs", "2,5-3"), 2, "3-5; found 2,5-3"),
            ((folder / "ada.zip", "--out", folder / "o", "--jobs", "0"), 2, "--jobs"),
            ((folder / "absent.zip", "--out", folder / "o"), 1, "there is no submission"),
            ((folder / "notes.txt", "--out", folder / "o"), 1, "is no submission"),
            ((folder / "ada.zip", "--out", folder / "o", "--course", folder / "bad.toml"), 1, "bad.toml:2:"),
            ((folder / "ada.zip", "--out", folder / "ada.zip"), 1, "cannot write"),
            ((folder / "ada.zip", "--out", "/dev/full"), 1, "cannot write")):
        printed = grade(*arguments, code=code)
        assert message in printed, f"{arguments}: {printed}"
        assert not (folder / "o").exists(), f"{arguments} left a folder"


def test_a_roster_with_an_open_quote_is_refused(folder):
    pack(folder / "ada.zip", {HILL: "// right"})
    (folder / "roster.csv").write_text('id,name\nada,Ada\nbob,"Bob\neve,Eve\n')
    printed = grade(folder / "ada.zip", "--out", folder / "out", "--labs", "3", "--roster", folder / "roster.csv", code=1)
    assert "roster.csv:3: a quote is opened and not closed" in printed, printed
    assert not (folder / "out").exists()


def test_an_output_folder_in_the_class_is_refused(folder):
    pack(folder / "class/ada.zip", {HILL: "// right"})
    for out in ("class", "class/out", "class/../class/a/out"):
        printed = grade(folder / "class/", "--out", folder / out, "--labs", "3", code=2)
        assert "in the folder of submissions" in printed, printed
    assert [file.name for file in (folder / "class").iterdir()] == ["ada.zip"]
    assert "in the folder of submissions" in grade(".", "--out", "out", "--labs", "3", code=2, cwd=folder / "class")
    grade(folder / "class", "--out", folder / "class2", "--labs", "3")


def test_a_damaged_archive_is_in_the_notes(folder):
    pack(folder / "class/ada-lab3.zip", {HILL: "// right"})
    (folder / "class/ada-lab5.zip").write_bytes(b"PK damaged")
    grade(folder / "class", "--out", folder / "out", "--labs", "3,5")
    row = grades(folder / "out")["ada"]
    assert row["status"] == "graded" and "damaged: ada-lab5.zip" in row["notes"], row


def test_labs_in_several_submissions_have_no_milestones(folder):
    def source(lab):
        topic, = (ROOT / "labs").glob(f"lab{lab}_*")
        return {f"labs/{topic.name}/{file.name}": f"// {lab}" for file in topic.glob("*.cpp")}

    for number in (1, 2):
        pack(folder / f"class/ada-lab{number}.zip", source(number))
    pack(folder / "class/bob.zip", {**source(1), **source(2)})
    pack(folder / "class/bob-lab1.zip", source(1))
    pack(folder / "class/eve.zip", source(1))
    (folder / "course.toml").write_text("[milestones]\nweight = 1\n")
    out = folder / "out"
    printed = grade(folder / "class", "--out", out, "--labs", "1-2", "--course", folder / "course.toml")
    reason = "milestones need all labs in one submission: ./cs550 submit without a number packs them"
    assert f"ada: {reason}" in printed and printed.count(reason) == 1, printed
    assert [reason in grades(out)[name]["notes"] for name in ("ada", "bob", "eve")] == [True, False, False]
    for file in ("ada-lab1.md", "ada-lab2.md", "ada-lab2.html"):
        assert reason in (out / "feedback" / file).read_text(), file
    assert reason not in (out / "feedback/bob.md").read_text()


def test_submissions_of_nobody_are_printed(folder):
    for name in ("s1", "Ada Lovelace_123", "mallory"):
        pack(folder / f"class/{name}.zip", {HILL: "// right"})
    roster = folder / "roster.csv"
    roster.write_text("id,name\ns1,Ada Lovelace\ns2,Ada Lovelace\n")
    printed = grade(folder / "class", "--out", folder / "out", "--labs", "3", "--roster", roster)
    for message in (f"not on the roster: {folder}/class/mallory.zip",
                    f"not on the roster: {folder}/class/Ada Lovelace_123.zip: the name fits s1 and s2. Put the id"):
        assert message in printed and message in grade("--report", folder / "out"), printed
    assert "not on the roster: s1" not in printed


def test_a_folder_of_a_section_is_no_student(folder):
    for student in ("s0101", "s0102", "Ada Lovelace_123", "mallory"):
        pack(folder / f"class/section A/{student}/lab3.zip",
             {HILL: f"// {student}", "manifest.json": '{"student": "s0103", "date": ""}'})
    roster = folder / "roster.csv"
    roster.write_text("id,name\ns0101,\ns0102,\ns0103,\ns0104,Ada Lovelace\n")
    options = ("--labs", "3", "--roster", roster)
    printed = grade(folder / "class", "--out", folder / "out", *options)
    claimed = grades(folder / "out")
    assert [row["status"] for row in claimed.values()] == ["graded"] * 4, "the claim of mallory counts last"
    assert "not on the roster" not in printed
    roster.write_text("id,name\ns0101,\ns0102,\ns0104,Ada Lovelace\n")
    printed = grade("--report", folder / "out", "--roster", roster)
    assert f"not on the roster: {folder}/class/section A/mallory/lab3.zip" in printed, printed
    assert printed.count("not on the roster") == 1, printed
    (folder / "course.toml").write_text("secret = 'x'\n")
    grade("--report", folder / "out", "--out", folder / "shared", "--pseudonyms", "--course", folder / "course.toml")
    for file in (folder / "shared/records").glob("*.json"):
        assert "section" not in file.read_text(), file


def test_a_file_that_the_machine_cannot_read_has_no_mark(folder):
    pack(folder / "class/ada.zip", {HILL: "// right"})
    os.mkfifo(folder / "class/bob.zip")
    out = folder / "out"
    printed = grade(folder / "class", "--out", out, "--labs", "3")
    assert "unreadable: bob: not a file" in printed, printed
    assert grades(out)["bob"]["status"] == "unreadable"


def test_three_hundred_submissions(folder):
    for i in range(300):
        pack(folder / "class" / f"student{i:03}.zip", {HILL: f"// fake: fails FirstOfEqualVerticesWins\n// {i}",
                                                       CLIP: f"// {i % 50}"})
    start = time.monotonic()
    printed = grade(folder / "class", "--out", folder / "out")
    assert "300 submissions, 350 labs graded" in printed, printed
    assert len(grades(folder / "out")) == 300
    print(f"  300 submissions in {time.monotonic() - start:.1f} s")


def main():
    shutil.rmtree(SCRATCH, ignore_errors=True)
    wanted = sys.argv[4:]
    tests = [(name, run) for name, run in globals().items()
             if name.startswith("test_") and (not wanted or name in wanted)]
    failed = 0
    for name, run in tests:
        folder = SCRATCH / name
        folder.mkdir(parents=True)
        try:
            run(folder)
            print(f"passed {name}", flush=True)
        except AssertionError as error:
            failed += 1
            line = traceback.extract_tb(error.__traceback__)[-1]
            print(f"FAILED {name}, line {line.lineno}: {error or line.line}", flush=True)
    shutil.rmtree(SCRATCH, ignore_errors=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
