#!/usr/bin/env python3
"""result.py N RESULTS MANIFEST: prints the results of a lab as GitHub Classroom's reporter reads them. Every test of
the manifest is in it; one without a result, because the lab does not compile, is an error."""

import json
import sys
from pathlib import Path


def verdict(test, row, otherwise):
    status = {"passed": "pass", "failed": "fail"}.get(row.get("status"), "error")
    message = row.get("message") or ("" if status == "pass" else otherwise)
    return {"name": f"{test['step']} {test['name']}", "status": status,
            "score": test["points"] if status == "pass" else 0, "message": message, "test_code": test["step"],
            "filename": "", "line_no": 0, "execution_time": f"{row.get('seconds', 0)}s"}


def main():
    lab, results, manifest = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    result = json.loads(results.read_text()) if results.exists() else {"tests": []}
    rows = {row["test"].removeprefix(f"Lab{lab}."): row for row in result["tests"]}
    otherwise = result.get("compile_error") or "no result: the log of this step shows why"
    tests = json.loads(manifest.read_text())["tests"]
    verdicts = [verdict(test, rows.get(test["name"], {}), otherwise) for test in tests]
    passed = all(test["status"] == "pass" for test in verdicts)
    print(json.dumps({"version": 1, "status": "pass" if passed else "fail",
                      "max_score": sum(test["points"] for test in tests), "tests": verdicts}))


if __name__ == "__main__":
    main()
