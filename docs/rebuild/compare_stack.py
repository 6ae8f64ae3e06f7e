#!/usr/bin/env python3
"""Steps the tower of tower.json by stack.py and by the engine, and compares the positions after each step.

    docs/rebuild/compare_stack.py build/test/bin/cs550_demo
"""
import csv
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from stack import DENSITY, Body, step

# The engine computes in single precision, whose neighbouring numbers at a height of 4.5 m are 0.0005 mm apart. Later the
# tower rocks on its corners, and rounding decides in which substep a corner lifts: positions that are moved by
# 0.0001 mm at first differ by 0.12 mm then. Corners in another order, which is as right an answer, make 0.08 mm in the
# first step and 4 mm later; passes without over-relaxation 0.014 mm and 1.2 mm.
STEADY_STEPS, STEADY_TOLERANCE, TOLERANCE = 15, 2e-6, 3e-4  # the tolerances in m
LEAST_SLIDE = 0.02  # m: the top box really slides


def engine_positions(program, scene):
    """Of the boxes after each step, as the engine computes them: steps × boxes × 3."""
    with tempfile.TemporaryDirectory() as folder:
        table = Path(folder) / "tower.csv"
        subprocess.run([program, scene, "--csv", table, "--no-picture"], check=True, stdout=subprocess.DEVNULL)
        rows = [[float(row[k]) for k in ("step", "x_m", "y_m", "z_m")] for row in csv.DictReader(table.open())]
    steps = [row[0] for row in rows]
    return np.array([row[1:] for row in rows]).reshape(len(set(steps)), -1, 3)[1:]


def main():
    scene = Path(__file__).with_name("tower.json")
    bodies = [Body(np.array(body["shape"]["half_extents"]), np.array(body["position"], float),
                   np.array(body.get("linear_velocity", (0, 0, 0))), density=DENSITY if i else 0)
              for i, body in enumerate(json.loads(scene.read_text())["bodies"])]
    top, contacts, differences = bodies[-1], None, []
    expected = engine_positions(sys.argv[1], scene)
    for number, positions in enumerate(expected):
        contacts = step(bodies, contacts, number)
        differences.append(max(np.linalg.norm(body.x - x) for body, x in zip(bodies[1:], positions)))
    steady, worst = max(differences[:STEADY_STEPS]), max(differences)
    print(f"{len(expected)} steps: the top box slid {1000 * top.x[0]:.3f} mm, the engine's"
          f" {1000 * expected[-1, -1, 0]:.3f} mm; positions differ by at most {1000 * steady:.4f} mm"
          f" in the first {STEADY_STEPS} steps, {1000 * worst:.4f} mm in all")
    return 0 if steady < STEADY_TOLERANCE and worst < TOLERANCE and top.x[0] > LEAST_SLIDE else 1


if __name__ == "__main__":
    sys.exit(main())
