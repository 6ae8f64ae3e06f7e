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

# The engine computes in single precision. For the first 25 steps its positions differ by less than 0.002 mm. Later
# the tower rocks on its corners, and rounding decides in which substep a corner lifts: 0.04 mm. Corners in another
# order, which is as right an answer, make 0.5 mm.
TOLERANCE = 1e-4  # m
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
    top, worst, contacts = bodies[-1], 0, None
    expected = engine_positions(sys.argv[1], scene)
    for number, positions in enumerate(expected):
        contacts = step(bodies, contacts, number)
        worst = max(worst, *(np.linalg.norm(body.x - x) for body, x in zip(bodies[1:], positions)))
    print(f"{len(expected)} steps: the top box slid {1000 * top.x[0]:.3f} mm, the engine's"
          f" {1000 * expected[-1, -1, 0]:.3f} mm; positions differ by at most {1000 * worst:.4f} mm")
    return 0 if worst < TOLERANCE and top.x[0] > LEAST_SLIDE else 1


if __name__ == "__main__":
    sys.exit(main())
