#!/usr/bin/env python3
"""Writes float.obj, the float and the turbine that the pictures show; nothing is in contact with them.

    cases/farm/make_float.py [OUTPUT.obj]

The hull is that of make_rao.py, VolturnUS-S with a freeboard of 15 m; tower, nacelle and rotor have the main dimensions of
the IEA 15 MW turbine: hub at 150 m, diameter 240 m. Nacelle and blades are boxes, for the eye.
Body axes: x leeward, y to port, z up from the still water. Every part is closed, its triangles anticlockwise seen from
outside, and parts that stand on each other are GAP apart.
"""
import math
import sys
from pathlib import Path

from make_rao import COLUMNS, DRAUGHT, HEIGHT, INNER, OUTER, RADIUS, WIDTH

FREEBOARD, HUB, OVERHANG, TIP, ROOT, GAP = 15.0, 150.0, 11.0, 120.0, 3.0, 0.05  # m
SIDES = 24  # of a round part


def loft(rings):
    """A closed part through rings of as many points each, anticlockwise seen from where the last one is."""
    n, last = len(rings[0]), len(rings) - 1
    points = [p for ring in rings for p in ring]
    points += [tuple(sum(c) / n for c in zip(*ring)) for ring in (rings[0], rings[-1])]
    faces = []
    for i in range(n):
        j = (i + 1) % n
        faces += [(len(points) - 2, j, i), (len(points) - 1, last * n + i, last * n + j)]
        for k in range(0, last * n, n):
            faces += [(k + i, k + j, k + j + n), (k + i, k + j + n, k + i + n)]
    return points, faces


def circle(x, y, z, diameter):
    turns = [2 * math.pi * i / SIDES for i in range(SIDES)]
    return [(x + diameter / 2 * math.cos(a), y + diameter / 2 * math.sin(a), z) for a in turns]


def pontoons(z):
    """Outline of the three, whose ends are round below the columns."""
    ring = []
    for angle in sorted(a % 360 for a in COLUMNS):
        out = math.radians(angle)
        x, y = RADIUS * math.cos(out), RADIUS * math.sin(out)
        for i in range(SIDES // 2 + 1):
            a = out + math.pi * (i / (SIDES // 2) - 0.5)
            ring.append((x + WIDTH / 2 * math.cos(a), y + WIDTH / 2 * math.sin(a), z))
        corner = WIDTH / 2 / math.sin(math.radians(60))
        ring.append((corner * math.cos(out + math.radians(60)), corner * math.sin(out + math.radians(60)), z))
    return ring


def strut(angle):
    """From the middle column to another, under the deck."""
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    corners = [(-0.5, FREEBOARD - 1.5), (0.5, FREEBOARD - 1.5), (0.5, FREEBOARD - 0.5), (-0.5, FREEBOARD - 0.5)]
    return loft([[(r * c - v * s, r * s + v * c, z) for v, z in corners]
                 for r in (INNER / 2 + GAP, RADIUS - OUTER / 2 - GAP)])


def across(x, corners):
    """A ring of (y, z) from the hub, in a plane across the wind."""
    return [(x, y, HUB + z) for y, z in corners]


def blade(angle):
    """Tapered, upwind of the tower; `angle` from upright, deg."""
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    rings = []
    for r, chord, thickness in [(ROOT, 5.0, 3.0), (25.0, 5.8, 1.6), (80.0, 3.4, 0.6), (TIP, 0.8, 0.2)]:
        corners = [(-thickness, -chord), (thickness, -chord), (thickness, chord), (-thickness, chord)]
        rings.append([(-OVERHANG + u / 2, v / 2 * c + r * s, HUB - v / 2 * s + r * c) for u, v in corners])
    return loft(rings)


def parts():
    yield loft([pontoons(-DRAUGHT), pontoons(-DRAUGHT + HEIGHT)])
    top = -DRAUGHT + HEIGHT + GAP
    yield loft([circle(0, 0, top, INNER), circle(0, 0, FREEBOARD, INNER)])
    for angle in COLUMNS:
        x, y = RADIUS * math.cos(math.radians(angle)), RADIUS * math.sin(math.radians(angle))
        yield loft([circle(x, y, top, OUTER), circle(x, y, FREEBOARD, OUTER)])
        yield strut(angle)
    yield loft([circle(0, 0, FREEBOARD + GAP, 10.0), circle(0, 0, HUB - 4.5, 6.5)])
    box = [(-4, -4.5 + GAP), (4, -4.5 + GAP), (4, 4.5), (-4, 4.5)]
    yield loft([across(-OVERHANG + 2 + GAP, box), across(9, box)])
    round_hub = [(2.8 * math.cos(2 * math.pi * i / 12), 2.8 * math.sin(2 * math.pi * i / 12)) for i in range(12)]
    yield loft([across(-OVERHANG - 2, round_hub), across(-OVERHANG + 2, round_hub)])
    for angle in (0, 120, -120):
        yield blade(angle)


def main():
    path = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent / "float.obj"
    count = 0
    with open(path, "w") as file:
        file.write("# The float and the turbine of make_float.py\n")
        for points, faces in parts():
            file.writelines(f"v {x:.3f} {y:.3f} {z:.3f}\n" for x, y, z in points)
            file.writelines(f"f {a + count + 1} {b + count + 1} {c + count + 1}\n" for a, b, c in faces)
            count += len(points)
    print(f"{path.name}: {count} vertices")


if __name__ == "__main__":
    main()
