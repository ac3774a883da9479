#!/usr/bin/env python3
"""Writes spar.obj: the hull of the OC3-Hywind spar, as a surface of revolution about z.

The radius of the corners is such that each ring has the area of its circle.
"""

import math
import sys

AROUND = 24
PROFILE = [(0, -120), (4.7, -120), (4.7, -90), (4.7, -60), (4.7, -30), (4.7, -12), (3.25, -4), (3.25, 4), (3.25, 10), (0, 10)]


def main(path):
    step = 2 * math.pi / AROUND
    wider = math.sqrt(step / math.sin(step))
    vertices, rings, faces = [], [], []
    for radius, z in PROFILE:
        ring = []
        for i in range(AROUND if radius > 0 else 1):
            vertices.append((wider * radius * math.cos(i * step), wider * radius * math.sin(i * step), z))
            ring.append(len(vertices))
        rings.append(ring)
    for low, high in zip(rings, rings[1:]):
        for i in range(AROUND):
            a, b = low[i % len(low)], low[(i + 1) % len(low)]
            c, d = high[(i + 1) % len(high)], high[i % len(high)]
            if a != b:
                faces.append((a, b, c))
            if c != d:
                faces.append((a, c, d))
    with open(path, "w", encoding="ascii") as out:
        out.write("# Hull of the OC3-Hywind spar, m; made by make_spar.py\n")
        for v in vertices:
            out.write("v {:.6f} {:.6f} {:.6f}\n".format(*v))
        for f in faces:
            out.write("f {} {} {}\n".format(*f))


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "spar.obj")
