#!/usr/bin/env python3
"""Writes drum.stl, the reel of the Marlim Sul case: a spool turning about the y axis.

    cases/reel/make_drum.py [OUTPUT.stl]

A barrel of 7.2 m diameter, 5.5 m long between two flanges of 12.8 m diameter: one closed, manifold surface,
non-convex, its triangles anticlockwise seen from outside. The barrel's *vertices* lie on the radius exactly; between
them a flat facet runs up to R (1 - cos(pi/96)) = 1.9 mm inside it, 0.64 mm on average. The hose leans on the
barrel and on the inner faces of the flanges; the rims and outer faces are there for the picture and to close the
surface, so they are coarser.
"""
import math
import struct
import sys
from collections import Counter
from pathlib import Path

BARREL_RADIUS = 3.6  # m
FLANGE_RADIUS = 6.4  # m
HALF_LENGTH = 2.75  # m, from the middle to the inner face of a flange
FLANGE_THICKNESS = 0.15  # m
FACETS = 96  # around: 0.236 m on the barrel
BARREL_ROWS = 12  # along the barrel: 0.458 m, so no triangle is longer than twice its width
INNER_RINGS = 6  # on the inner face of a flange, 0.467 m each
OUTER_RADII = [6.4, 4.4, 2.4, 0.8]  # on the outer face, closed by a fan in the middle


def profile():
    """Half of the section through the axis, as (radius, y) from the middle of one outer face to the other."""
    outer = HALF_LENGTH + FLANGE_THICKNESS
    rings = [BARREL_RADIUS + (FLANGE_RADIUS - BARREL_RADIUS) * i / INNER_RINGS for i in range(INNER_RINGS + 1)]
    rows = [-HALF_LENGTH + 2 * HALF_LENGTH * i / BARREL_ROWS for i in range(BARREL_ROWS + 1)]
    points = [(r, -outer) for r in reversed(OUTER_RADII)]
    points += [(r, -HALF_LENGTH) for r in reversed(rings)]
    points += [(BARREL_RADIUS, y) for y in rows[1:]]
    points += [(r, HALF_LENGTH) for r in rings[1:]]
    points += [(r, outer) for r in OUTER_RADII]
    return points


def single(value):
    """The value as the file will hold it, so that equal vertices stay equal and the check sees what is written."""
    return struct.unpack("<f", struct.pack("<f", value))[0]


def spool():
    """Triangles of the spool, each a triple of vertices; the profile is turned about the y axis."""
    rings = []
    for radius, y in profile():
        ring = []
        for i in range(FACETS):
            angle = 2 * math.pi * i / FACETS
            ring.append((single(radius * math.cos(angle)), single(y), single(radius * math.sin(angle))))
        rings.append(ring)

    triangles = []
    for one, two in zip(rings, rings[1:]):
        for i in range(FACETS):
            j = (i + 1) % FACETS
            # The diagonal changes side from facet to facet, so that the mesh favours no way of winding.
            if i % 2:
                triangles += [(one[i], two[i], one[j]), (one[j], two[i], two[j])]
            else:
                triangles += [(one[i], two[i], two[j]), (one[i], two[j], one[j])]
    first, last = (0.0, rings[0][0][1], 0.0), (0.0, rings[-1][0][1], 0.0)
    for i in range(FACETS):
        j = (i + 1) % FACETS
        triangles.append((first, rings[0][i], rings[0][j]))
        triangles.append((last, rings[-1][j], rings[-1][i]))
    return triangles


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def volume(triangles):
    """Enclosed volume by the divergence theorem, m³: positive when the triangles face outward."""
    return sum(dot(a, cross(b, c)) for a, b, c in triangles) / 6


def exact_volume():
    """The volume of the faceted spool from its profile: prisms over regular 96-gons, m³."""
    polygon = FACETS / 2 * math.sin(2 * math.pi / FACETS)
    flanges = 2 * FLANGE_THICKNESS * FLANGE_RADIUS**2
    return polygon * (2 * HALF_LENGTH * BARREL_RADIUS**2 + flanges)


def faults(triangles):
    """Sentences on what keeps the triangles from being a closed, manifold, outward surface; empty when nothing does."""
    found = []
    edges = Counter()
    for triangle in triangles:
        normal = cross(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0]))
        if dot(normal, normal) == 0:
            found.append(f"degenerate triangle {triangle}")
        for i in range(3):
            edges[triangle[i], triangle[(i + 1) % 3]] += 1
    doubled = sum(1 for count in edges.values() if count > 1)
    unmatched = sum(1 for a, b in edges if (b, a) not in edges)
    if doubled:
        found.append(f"{doubled} directed edges used more than once: not manifold, or not of one orientation")
    if unmatched:
        found.append(f"{unmatched} edges with one triangle only: not closed, or not of one orientation")
    vertices = {vertex for triangle in triangles for vertex in triangle}
    euler = len(vertices) - len(edges) // 2 + len(triangles)
    if euler != 2:
        found.append(f"Euler characteristic {euler}, not the 2 of a surface without handles")
    if volume(triangles) <= 0:
        found.append("turned inside out")
    if abs(volume(triangles) / exact_volume() - 1) > 1e-6:
        found.append(f"volume {volume(triangles):.6f} m³, not {exact_volume():.6f} m³")
    return found


def write_stl(path, triangles):
    """Binary STL: an 80-byte title, the count, and 50 bytes a triangle (normal, three vertices, two unused bytes)."""
    with open(path, "wb") as file:
        file.write(b"hawser: reel of the Marlim Sul case, metres, axis y".ljust(80))
        file.write(struct.pack("<I", len(triangles)))
        for a, b, c in triangles:
            normal = cross(minus(b, a), minus(c, a))
            length = math.sqrt(dot(normal, normal))
            file.write(struct.pack("<12fH", *[x / length + 0.0 for x in normal], *a, *b, *c, 0))


def main():
    path = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent / "drum.stl"
    triangles = spool()
    found = faults(triangles)
    if found:
        sys.exit("make_drum: " + "; ".join(found))
    write_stl(path, triangles)
    print(f"{path.name}: {len(triangles)} triangles, closed, {volume(triangles):.3f} m³")


if __name__ == "__main__":
    main()
