#!/usr/bin/env python3
"""Writes a case to FOLDER: 400 lines of 250 elements (10^5 nodes) fall onto a floor of 10^6 triangles.

    tests/bench/contact_share.py FOLDER [--cables] [--flat]
    OMP_NUM_THREADS=1 build/hawser run FOLDER/share.yaml -- -log_view

The floor is a closed block of 200 m each way with hills of 0.2 m, its top of triangles of 0.28 m. The lines lie
0.5 m apart, 5 mm above it in the mean, and sink into the hills' tops under their weight.
"""
import argparse
import math
import pathlib
import struct

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("folder", type=pathlib.Path)
parser.add_argument("--cables", action="store_true", help="lines without bending stiffness")
parser.add_argument("--flat", action="store_true", help="facets stay flat")
parser.add_argument("--cells", type=int, default=707, help="squares along a side; two triangles each")
parser.add_argument("--lines", type=int, default=400)
parser.add_argument("--steps", type=int, default=20)
options = parser.parse_args()
options.folder.mkdir(parents=True, exist_ok=True)

SIDE, DEPTH, HILL, WAVE = 200.0, 5.0, 0.1, 20.0
n = options.cells


def height(x, y):
    return HILL * math.sin(2 * math.pi * x / WAVE) * math.sin(2 * math.pi * y / WAVE)


xs = [SIDE * i / n for i in range(n + 1)]
top = [[(x, y, height(x, y)) for y in xs] for x in xs]
triangles = []
for i in range(n):
    for j in range(n):
        a, b, c, d = top[i][j], top[i + 1][j], top[i + 1][j + 1], top[i][j + 1]
        triangles += [(a, b, c), (a, c, d)]


def wall(edge):
    """From an edge of the top, its solid on the left as seen from above outside, down to the bottom."""
    for p, q in zip(edge, edge[1:]):
        p0, q0 = (p[0], p[1], -DEPTH), (q[0], q[1], -DEPTH)
        triangles.extend([(p, p0, q0), (p, q0, q)])


wall([top[i][0] for i in range(n + 1)])
wall([top[n][j] for j in range(n + 1)])
wall([top[i][n] for i in range(n, -1, -1)])
wall([top[0][j] for j in range(n, -1, -1)])
rim = [(x, 0.0) for x in xs] + [(SIDE, y) for y in xs[1:]]
rim += [(x, SIDE) for x in xs[-2::-1]] + [(0.0, y) for y in xs[-2:0:-1]]
middle = (SIDE / 2, SIDE / 2, -DEPTH)
for p, q in zip(rim, rim[1:] + rim[:1]):
    triangles.append((middle, (q[0], q[1], -DEPTH), (p[0], p[1], -DEPTH)))

with open(options.folder / "floor.stl", "wb") as f:
    f.write(b" " * 80 + struct.pack("<I", len(triangles)))
    for a, b, c in triangles:
        f.write(struct.pack("<12fH", 0, 0, 0, *a, *b, *c, 0))

text = ["hawser: 1", "title: Many lines on a floor of many triangles", "", "line_types:", "  line:"]
text += ["    outer_diameter: 0.2", "    mass_per_length: 50", "    EA: 10 MN"]
text += ["    bending: false"] if options.cables else ["    EI: 10 kN m2", "    GJ: 10 kN m2"]
text += ["volumes:", "  floor:", "    mesh: floor.stl", "    friction: 0.3"]
text += ["    smooth: false"] if options.flat else []
text += ["contact: {between_lines: false}", "lines:"]
spacing = (SIDE - 20) / options.lines
for k in range(options.lines):
    y = 10 + spacing * (k + 0.5)
    text += [f"  line{k}:", "    sections: [{type: line, length: 180, elements: 250}]",
             f"    end_a: {{anchor: [10, {y:.4f}, {0.1 + HILL + 0.005}]}}", "    end_b: free",
             f"    start: {{points: [[10, {y:.4f}, {0.1 + HILL + 0.005}], [190, {y:.4f}, {0.1 + HILL + 0.005}]]}}"]
text += ["statics: false", f"dynamics: {{duration: {0.02 * options.steps}, step: 0.02}}"]
text += [f"output: {{every: {0.02 * options.steps}, format: [hdf5]}}"]
(options.folder / "share.yaml").write_text("\n".join(text) + "\n")
print(f"{len(triangles)} triangles, {options.lines * 251} nodes: {options.folder / 'share.yaml'}")
