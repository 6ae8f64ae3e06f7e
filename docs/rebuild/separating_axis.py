#!/usr/bin/env python3
"""The separating axis of two boxes, rebuilt from the book alone: chapters "Gauss map and Minkowski difference"
and "Separating axis". Nothing of the engine is used but its answers, to compare with.

    docs/rebuild/separating_axis.py build/docs/data/rebuild_boxes.dat

The table is written by book_figures: a pair of boxes per line, and what the engine answers. Exit code 77:
there is no table yet.
"""
import itertools
import sys
from pathlib import Path

import numpy as np

TIE_TOLERANCE = 1e-4  # of the radius of the smaller body
PARALLEL_SINE = 1e-3
FACE_A, FACE_B, EDGES = 1, 2, 3

# The engine computes in single precision: six operations on coordinates below 4 m leave errors of about
# 6 · 4 · 6e-8 m in a separation. Ties are decided within 1e-4 of the radius, by which two answers may differ.
ROUNDING = 2e-6  # m
ANGLE = 1e-4  # rad; near-parallel edges divide the rounding by the sine of their angle, here above 0.02


def rotation(q):
    """The matrix of a unit quaternion (w, x, y, z)."""
    w, x, y, z = q
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


class Box:
    """Vertices, face normals and offsets in the world, and edges: (half of it, its middle, the two normals beside it)."""

    def __init__(self, half, position, quaternion):
        axes = rotation(quaternion).T  # row k: the box's axis k in the world
        signs = np.array(list(itertools.product((-1, 1), repeat=3)))
        self.radius = np.linalg.norm(half)
        self.vertices = position + (signs * half) @ axes
        self.normals = np.concatenate([axes, -axes])
        self.offsets = self.normals @ position + np.concatenate([half, half])
        self.edges = []
        for along in range(3):
            u, v = [k for k in range(3) if k != along]
            for su, sv in itertools.product((-1, 1), repeat=2):
                middle = position + su * half[u] * axes[u] + sv * half[v] * axes[v]
                self.edges.append((half[along] * axes[along], middle, su * axes[u], sv * axes[v]))


def query_faces(a, b):
    """The largest s_f = n_f · v_f − o_f over the faces of A; the support along −n_f is the deepest vertex of B."""
    separations = (a.normals @ b.vertices.T).min(axis=1) - a.offsets
    best = separations.argmax()
    return separations[best], a.normals[best]


def arcs_cross(a, b, c, d):
    """Whether the arc ab crosses the arc cd, where c and d are the negated normals beside B's edge."""
    j, k = np.cross(b, a), np.cross(d, c)
    return (c @ j) * (d @ j) < 0 and (a @ k) * (b @ k) < 0 and (c @ j) * (b @ k) > 0


def query_edges(a, b):
    """The largest s = n · (p_B − p_A) over the pairs of edges whose arcs cross, its axis and its pair."""
    best, axis, pair = -np.inf, None, None
    for edge_a, edge_b in itertools.product(a.edges, b.edges):
        (e_a, p_a, f_a, g_a), (e_b, p_b, f_b, g_b) = edge_a, edge_b
        n = np.cross(e_a, e_b)
        parallel = np.linalg.norm(n) < PARALLEL_SINE * np.linalg.norm(e_a) * np.linalg.norm(e_b)
        if parallel or not arcs_cross(f_a, g_a, -f_b, -g_b):
            continue
        n /= np.linalg.norm(n)
        if n @ (f_a + g_a) < 0:
            n = -n
        if n @ (p_b - p_a) > best:
            best, axis, pair = n @ (p_b - p_a), n, (edge_a, edge_b)
    return best, axis, pair


def find_separating_axis(a, b):
    """Kind, axis from A to B, separation: of the kinds within the tolerance of the best, the first."""
    s_a, n_a = query_faces(a, b)
    s_b, n_b = query_faces(b, a)
    s_e, n_e, _ = query_edges(a, b)
    tolerance = TIE_TOLERANCE * min(a.radius, b.radius)
    best = max(s_a, s_b, s_e)
    for kind, axis, separation in ((FACE_A, n_a, s_a), (FACE_B, -n_b, s_b), (EDGES, n_e, s_e)):
        if separation >= best - tolerance:
            return kind, axis, separation


def is_tie(a, b):
    """Whether rounding decides the kind: two kinds differ by the tolerance, up to rounding."""
    values = sorted(s for s in (query_faces(a, b)[0], query_faces(b, a)[0], query_edges(a, b)[0]))
    tolerance = TIE_TOLERANCE * min(a.radius, b.radius)
    return any(abs(values[-1] - other - tolerance) < 2 * ROUNDING for other in values[:-1])


def differences(row):
    """What differs from the engine's answer, in words."""
    a, b = Box(row[0:3], row[3:6], row[6:10]), Box(row[10:13], row[13:16], row[16:20])
    kind, axis, separation = find_separating_axis(a, b)
    if is_tie(a, b):
        return
    if kind != row[20]:
        yield f"kind {kind}, the engine has {row[20]:.0f}"
        return
    if abs(separation - row[24]) > ROUNDING:
        yield f"separation {separation:.7f} m, the engine has {row[24]:.7f} m"
    if np.linalg.norm(np.cross(axis, row[21:24])) > ANGLE or axis @ row[21:24] < 0:
        yield f"axis {axis}, the engine has {row[21:24]}"


def main():
    table = Path(sys.argv[1])
    if not table.exists():
        print(f"{table} does not exist yet: ./cs550 docs")
        return 77
    rows = np.loadtxt(table)
    faults = [f"line {i}: {fault}" for i, row in enumerate(rows, 1) for fault in differences(row)]
    print("\n".join(faults))
    kinds = [np.count_nonzero(rows[:, 20] == kind) for kind in (FACE_A, FACE_B, EDGES)]
    print(f"{len(rows)} pairs ({kinds[0]} faces of A, {kinds[1]} of B, {kinds[2]} edges;"
          f" {np.count_nonzero(rows[:, 24] > 0)} apart), {len(faults)} differ")
    return 1 if faults or min(kinds) < 20 else 0


if __name__ == "__main__":
    sys.exit(main())
