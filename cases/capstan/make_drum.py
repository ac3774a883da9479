#!/usr/bin/env python3
"""Writes drum.stl: a plain drum of 2 m diameter, 0.6 m long, its axis along y.

    cases/capstan/make_drum.py [OUTPUT.stl]

Closed, its triangles anticlockwise seen from outside, with 96 flat facets around. The vertices lie on the radius
exactly; the middle of a facet lies R (1 - cos(pi/96)) = 0.54 mm inside it.
"""
import math
import struct
import sys
from pathlib import Path

RADIUS, HALF_LENGTH = 1.0, 0.3  # m
FACETS, ROWS = 96, 4


def drum():
    rings = []
    for row in range(ROWS + 1):
        y = HALF_LENGTH * (2 * row / ROWS - 1)
        angles = [2 * math.pi * i / FACETS for i in range(FACETS)]
        rings.append([(RADIUS * math.cos(a), y, RADIUS * math.sin(a)) for a in angles])
    triangles = []
    for one, two in zip(rings, rings[1:]):
        for i in range(FACETS):
            j = (i + 1) % FACETS
            triangles += [(one[i], two[i], two[j]), (one[i], two[j], one[j])]
    for i in range(FACETS):
        j = (i + 1) % FACETS
        triangles.append(((0.0, -HALF_LENGTH, 0.0), rings[0][i], rings[0][j]))
        triangles.append(((0.0, HALF_LENGTH, 0.0), rings[-1][j], rings[-1][i]))
    return triangles


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def normal(a, b, c):
    n = cross([b[k] - a[k] for k in range(3)], [c[k] - a[k] for k in range(3)])
    length = math.sqrt(sum(x * x for x in n))
    return [x / length + 0.0 for x in n]


def volume(triangles):
    """By the divergence theorem, m³: positive when the triangles face outward."""
    return sum(sum(x * y for x, y in zip(a, cross(b, c))) for a, b, c in triangles) / 6


def write_stl(path, triangles):
    """Binary STL: an 80-byte title, the count, and 50 bytes a triangle (normal, three vertices, two unused bytes)."""
    with open(path, "wb") as file:
        file.write(b"hawser: drum of the capstan case, metres, axis y".ljust(80))
        file.write(struct.pack("<I", len(triangles)))
        for t in triangles:
            file.write(struct.pack("<12fH", *normal(*t), *t[0], *t[1], *t[2], 0))


def main():
    path = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent / "drum.stl"
    triangles = drum()
    polygon = FACETS / 2 * math.sin(2 * math.pi / FACETS) * RADIUS**2
    if abs(volume(triangles) / (polygon * 2 * HALF_LENGTH) - 1) > 1e-12:
        sys.exit("make_drum: the triangles don't enclose the drum")
    write_stl(path, triangles)
    print(f"{path.name}: {len(triangles)} triangles, closed, {volume(triangles):.4f} m³")


if __name__ == "__main__":
    main()
