#!/usr/bin/env python3
"""The contact manifold of two boxes, rebuilt from the book alone: chapter "Contact generation". Nothing of the engine is
used but its answers, to compare with.

    docs/rebuild/contact_manifold.py build/docs/data/rebuild_boxes.dat

The table is that of separating_axis.py, which finds the axis. Exit code 77: there is no table yet.
"""
import sys
from pathlib import Path

import numpy as np

from separating_axis import EDGES, FACE_A, FACE_B, ROUNDING, TIE_TOLERANCE, Box, query_edges, query_faces

MARGIN = 0.05  # m, of the table
SIDE_PLANE_TOLERANCE, EDGE_PREFERENCE = 1e-4, 5e-3  # of the radius of the smaller body
GAP_PENALTY = 5
KINDS = ["", "vertex", "crossing", "corner", "vertex", "crossing", "corner", "edges"]
DISTANCE = 1e-5  # m: intersections divide the rounding by the slope of an edge against a plane


def face_corners(box, face):
    """Counter-clockwise seen from outside."""
    normal = box.normals[face]
    corners = box.vertices[np.argsort(box.vertices @ normal)[4:]]
    arms = corners - corners.mean(axis=0)
    return corners[np.argsort(np.arctan2(np.cross(normal, arms[0]) @ arms.T, arms @ arms[0]))]


def incident_face(box, normal):
    """Of the faces at the vertex that is deepest along the reference normal, the most anti-parallel one."""
    deepest = box.vertices[(box.vertices @ normal).argmin()]
    touches = box.normals @ deepest > box.offsets - 1e-5 * box.radius  # turned axes are rounded
    return np.where(touches, box.normals @ normal, np.inf).argmin()


def clip(polygon, normal, offset):
    """Sutherland and Hodgman: the part of the polygon with distance ≤ 0. A corner is (point, edge in, edge out)."""
    kept = []
    for (a, came, leaves), (b, _, _) in zip(polygon, polygon[1:] + polygon[:1]):
        d_a, d_b = normal @ a - offset, normal @ b - offset
        if d_a <= 0:
            kept.append((a, came, leaves))
        if d_a * d_b < 0:
            p = a + d_a / (d_a - d_b) * (b - a)
            kept.append((p, leaves, "side") if d_a < 0 else (p, "side", leaves))
    return kept


def doubled_area(p, q, r, n):
    return n @ np.cross(q - p, r - p)


class Tie(Exception):
    """Rounding decides which of two points is kept."""


def largest(points, measure):
    first, second = sorted(map(measure, points), reverse=True)[:2]
    if first - second < DISTANCE:
        raise Tie
    return max(points, key=measure)


def reduce(points, n, margin):
    """At most four: the deepest, the farthest from it, the largest triangle, the largest addition.

    A point across a gap counts less."""
    if len(points) <= 4:
        return points
    position = lambda point: point[0]
    weight = lambda point: 1 / (1 + GAP_PENALTY * max(0, point[2]) / margin)
    kept = [largest(points, lambda p: -p[2])]
    deepest = position(kept[0])
    kept.append(largest(points, lambda p: weight(p) * np.linalg.norm(np.cross(n, position(p) - deepest))))
    farthest = position(kept[1])
    kept.append(largest(points, lambda p: weight(p) * abs(doubled_area(deepest, farthest, position(p), n))))
    triangle = [deepest, farthest, position(kept[2])]
    if doubled_area(*triangle, n) < 0:
        triangle.reverse()
    added = lambda p: max(doubled_area(triangle[k - 2], triangle[k - 1], p, -n) for k in range(3))
    kept.append(largest(points, lambda p: weight(p) * added(position(p))))
    return kept


def face_points(reference, incident, face, radius, margin):
    """Of the clipped incident face: (point on the reference face, point on the incident body, separation, kind)."""
    normal, offset = reference.normals[face], reference.offsets[face]
    polygon = [(p, "incident", "incident") for p in face_corners(incident, incident_face(incident, normal))]
    corners = face_corners(reference, face)
    for a, b in zip(corners, np.roll(corners, -1, axis=0)):
        side = np.cross(b - a, normal) / np.linalg.norm(b - a)
        polygon = clip(polygon, side, side @ a + SIDE_PLANE_TOLERANCE * radius)
    kinds = {0: "vertex", 1: "crossing", 2: "corner"}
    return [(p - d * normal, p, d, kinds[(came == "side") + (leaves == "side")])
            for p, came, leaves in polygon if (d := normal @ p - offset) <= margin]


def edge_points(edge_a, edge_b, axis):
    """The closest points of two segments, each given by its half and its middle: −1 ≤ s, t ≤ 1."""
    (u, a, *_), (w, b, *_) = edge_a, edge_b
    c = np.cross(u, w)
    s = np.clip(np.cross(b - a, w) @ c / (c @ c), -1, 1)
    t = np.clip((a + s * u - b) @ w / (w @ w), -1, 1)
    s = np.clip((b + t * w - a) @ u / (u @ u), -1, 1)
    return [(a + s * u, b + t * w, axis @ (b + t * w - a - s * u), "edges")]


def build_manifold(a, b, margin):
    """Kind, normal from A to B, points: (on A, on B, separation, kind)."""
    radius = min(a.radius, b.radius)
    (s_a, n_a), (s_b, n_b), (s_e, n_e, pair) = query_faces(a, b), query_faces(b, a), query_edges(a, b)
    if max(s_a, s_b, s_e) > margin:
        return 0, np.zeros(3), []
    on_a = s_a >= s_b - TIE_TOLERANCE * radius
    reference, incident, s_f, n_f = (a, b, s_a, n_a) if on_a else (b, a, s_b, n_b)
    preference = EDGE_PREFERENCE * radius
    if s_e > s_f + preference:
        return EDGES, n_e, edge_points(*pair, n_e)
    face = (reference.normals @ n_f).argmax()
    points = face_points(reference, incident, face, radius, margin)
    normal = n_f if on_a else -n_f
    if min((p[2] for p in points), default=np.inf) > s_f + preference:
        if s_e >= s_f:
            return EDGES, n_e, edge_points(*pair, n_e)
        if max(s_a, s_b, s_e) <= 0 or not points:
            vertex = incident.vertices[(incident.vertices @ n_f).argmin()]
            points = [(vertex - s_f * n_f, vertex, s_f, "vertex")]
    if not on_a:
        points = [(p, q, d, kind) for q, p, d, kind in points]
    return (FACE_A if on_a else FACE_B), normal, reduce(points, normal, margin)


def differences(row):
    """What differs from the engine's manifold, in words."""
    a, b = Box(row[0:3], row[3:6], row[6:10]), Box(row[10:13], row[13:16], row[16:20])
    try:
        kind, normal, points = build_manifold(a, b, MARGIN)
    except Tie:
        return
    theirs = row[30:].reshape(4, 7)[:int(row[29])]
    if kind != row[25] or len(points) != len(theirs):
        yield f"kind {kind} with {len(points)} points, the engine has {row[25]:.0f} with {len(theirs)}"
        return
    if points and np.linalg.norm(normal - row[26:29]) > 1e-4:
        yield f"normal {normal}, the engine has {row[26:29]}"
    for on_a, on_b, separation, name in points:
        point = np.concatenate([on_a, on_b])
        nearest = min(theirs, key=lambda other: np.linalg.norm(other[:6] - point))
        if np.linalg.norm(nearest[:6] - point) > DISTANCE or KINDS[int(nearest[6])] != name:
            yield f"point {point} ({name}), the engine has {nearest}"


def main():
    table = Path(sys.argv[1])
    if not table.exists():
        print(f"{table} does not exist yet: ./cs550 docs")
        return 77
    rows = np.loadtxt(table)
    faults = [f"line {i}: {fault}" for i, row in enumerate(rows, 1) for fault in differences(row)]
    print("\n".join(faults))
    counts = np.bincount(rows[:, 29].astype(int), minlength=5)
    print(f"{len(rows)} pairs ({', '.join(f'{count} with {k} points' for k, count in enumerate(counts))}),"
          f" {len(faults)} differ")
    return 1 if faults or min(counts) < 5 else 0


if __name__ == "__main__":
    sys.exit(main())
