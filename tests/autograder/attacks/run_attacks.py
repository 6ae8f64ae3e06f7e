#!/usr/bin/env python3
"""Grades the submissions of attacks.json. Each must earn exactly what its honest part earns, leave no
process behind, and end in time."""

import argparse
import ctypes
import fnmatch
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
PR_SET_CHILD_SUBREAPER = 36
SECONDS_PER_TEST = 6
SECONDS_OF_PROCESSOR = 20
SECONDS_PER_COMPILATION = 60
SECONDS_PER_LAB = 600
SECONDS_TO_END = 5  # once the time for the lab is over


def lab_folder(root, lab):
    folder, = root.glob(f"lab{lab}_*")
    return folder


def write_file(path, content):
    path.parent.mkdir(parents=True, exist_ok=True)
    if content.startswith("link:"):
        path.symlink_to(content.removeprefix("link:"))
    elif content.startswith("size:"):
        path.write_text("//" + "x" * int(content.removeprefix("size:")))
    else:
        path.write_text(content)


def make_submission(attack, folder):
    folder.mkdir()
    base = {"reference": "solutions", "starter": "labs"}.get(attack.get("base"))
    if base:
        for file in lab_folder(ROOT / base, attack["lab"]).glob("*.[ch]pp"):
            shutil.copy(file, folder)
    if "edit" in attack:
        file = folder / attack["edit"]["file"]
        before, found, after = file.read_text().partition(attack["edit"]["find"])
        assert found, f"{file} has no {attack['edit']['find']}"
        file.write_text(before + attack["edit"]["replace"] + after)
    for name, content in attack.get("files", {}).items():
        write_file(folder / name, content.replace("@ROOT@", str(ROOT)))
    source = HERE / "sources" / f"{attack['name']}.cpp"
    if source.exists():
        for header in source.parent.glob("*.hpp"):
            shutil.copy(header, folder)
        write_file(folder / source.name, source.read_text().replace("@ROOT@", str(ROOT)))


def become_subreaper():
    ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1)


def children():
    """Processes that are left: whoever loses its parent becomes our child."""
    return Path(f"/proc/self/task/{os.getpid()}/children").read_text().split()


def faults(attack, record):
    earned = attack["earned"]
    if earned == "some" and record["earned"] == 0:
        yield "earned nothing"
    elif earned != "some" and record["earned"] != earned:
        passed = [test["name"] for test in record["tests"] if test["earned"]]
        yield f"earned {record['earned']}, not {earned}: {passed}"
    broken = [test["name"] for test in record["tests"] if test["message"] == "the judge ended during this test"]
    if broken:
        yield f"the judge ended in {broken}"
    status = record["tests"][0]["status"]
    if attack.get("status", status) != status:
        yield f"its first test is {status}: {record['tests'][0]['message'][:200]}"
    text = record["compile"]["errors"] + "".join(test["message"] for test in record["tests"])
    if any(ord(letter) < 32 and letter != "\n" or 127 <= ord(letter) < 160 or letter == "\u202e"
           for letter in text):
        yield "the report holds control characters"
    if attack.get("says", "") not in text:
        yield f"the report does not quote {attack['says']}"
    if "hides" in attack and attack["hides"] in text:
        yield f"the report quotes {attack['hides']}"
    if max(len(test["message"].encode()) for test in record["tests"]) > 4096:
        yield "a message is longer than 4 kB"


def judge(attack, options, scratch):
    """Returns seconds, the points earned, and what is wrong."""
    submission = scratch / "submission"
    make_submission(attack, submission)
    results = scratch / "results.json"
    start = time.monotonic()
    done = subprocess.run(
        [options.build / "bin/grade_lab", str(attack["lab"]), "--submission", submission,
         "--work", scratch / "work", "--results", results, "--wall", str(SECONDS_PER_TEST),
         "--cpu", str(attack.get("cpu", SECONDS_OF_PROCESSOR)), "--memory", "1024", "--isolation", options.isolation,
         "--lab-time", str(attack.get("lab_time", SECONDS_PER_LAB))],
        text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    seconds = time.monotonic() - start
    left = children()
    if not results.exists():
        return seconds, "-", [f"grade_lab wrote nothing: {done.stdout[-500:]}"]
    record = json.loads(results.read_text())
    found = list(faults(attack, record))
    if left:
        found.append(f"{len(left)} processes are left")
    if list(scratch.glob("**/pwned*")) or (ROOT / "cs550_attack").exists():
        found.append("it left a file")
    limit = SECONDS_PER_COMPILATION + 10 + len(record["tests"]) * SECONDS_PER_TEST
    if "lab_time" in attack:
        limit = attack["lab_time"] + SECONDS_TO_END
    if seconds > limit:
        found.append(f"it took longer than {limit} s")
    return seconds, record["earned"], found


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=Path, default=ROOT / "build/test")
    parser.add_argument("--only", default="*", metavar="PATTERN", help="only attacks of such names")
    parser.add_argument("--short", action="store_true", help="only those of the default tests")
    parser.add_argument("--isolation", default="auto", choices=["auto", "bubblewrap", "plain"])
    options = parser.parse_args()
    options.build = options.build.resolve()
    become_subreaper()

    attacks = [attack for attack in json.loads((HERE / "attacks.json").read_text())["attacks"]
               if fnmatch.fnmatch(attack["name"], options.only)
               and (attack.get("short") or not options.short)]
    faulty = 0
    for attack in attacks:
        with tempfile.TemporaryDirectory() as scratch:
            seconds, earned, found = judge(attack, options, Path(scratch))
        faulty += bool(found)
        print(f"{attack['name']:34}{earned:>4}{seconds:7.1f} s  {'; '.join(found) or 'good'}", flush=True)
    print(f"{len(attacks) - faulty} of {len(attacks)} submissions earn what they should")
    return 1 if faulty or not attacks else 0


if __name__ == "__main__":
    sys.exit(main())
