#!/usr/bin/env python3
"""Writes barge.obj, the hull of a pontoon: 60 m long, 16 m wide, 6 m deep, its upright corners rounded to 2 m."""
import math
from pathlib import Path

LENGTH, WIDTH, DEPTH, CORNER, PIECES, BAYS = 60.0, 16.0, 6.0, 2.0, 8, 12


def outline():
    """Points of the waterline, counterclockwise, the long sides in bays."""
    points = []
    for quarter in range(4):
        sx, sy = [(1, 1), (-1, 1), (-1, -1), (1, -1)][quarter]
        centre = sx * (LENGTH / 2 - CORNER), sy * (WIDTH / 2 - CORNER)
        for i in range(PIECES + 1):
            angle = math.radians(90 * (quarter + i / PIECES))
            points.append((centre[0] + CORNER * math.cos(angle), centre[1] + CORNER * math.sin(angle)))
        if quarter in (0, 2):  # along a side
            for i in range(1, BAYS):
                x = sx * (LENGTH / 2 - CORNER) * (1 - 2 * i / BAYS)
                points.append((x, sy * WIDTH / 2))
    return points


def main():
    ring = outline()
    n = len(ring)
    lines = ["# pontoon; z = 0 is half its depth"]
    for z in (-DEPTH / 2, DEPTH / 2):
        lines += [f"v {x:.6f} {y:.6f} {z:.6f}" for x, y in ring]
    lines += [f"v 0 0 {-DEPTH / 2:.6f}", f"v 0 0 {DEPTH / 2:.6f}"]
    for i in range(n):
        a, b = i + 1, (i + 1) % n + 1
        lines += [f"f {a} {b} {b + n}", f"f {a} {b + n} {a + n}", f"f {b} {a} {2 * n + 1}", f"f {a + n} {b + n} {2 * n + 2}"]
    Path(__file__).with_name("barge.obj").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
