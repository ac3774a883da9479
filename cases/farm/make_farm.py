#!/usr/bin/env python3
"""Writes farm.yaml: ten floats in two rows across the wind, each held by ten chains, in a sea of Hs 9 m.

    cases/farm/make_farm.py [OUTPUT.yaml]

x points east, y north, z up. The wind comes from the west and has pushed the floats OFFSET to the east.
"""
import math
import sys
from pathlib import Path

DEPTH = 120.0  # m
SPACING = 1500.0  # m, between the floats of a row and between the rows; the second row stands in the gaps of the first
FLOATS = [(0.0, SPACING * i) for i in range(5)] + [(SPACING, SPACING * (i + 0.5)) for i in range(5)]
OFFSET = 8.0  # m
COLUMN_RADIUS, COLUMN_DIAMETER, FAIRLEAD = 51.75, 12.5, -14.0  # m, where the columns stand; z of the fairleads
LENGTH, ELEMENTS, DISTANCE = 550.0, 50, 520.0  # m, of a chain; from fairlead to anchor, seen from above, without wind
# Clusters: name, where its column stands, and how far off that direction each of its chains goes, deg.
CLUSTERS = [("west", 180.0, [-7.5, -2.5, 2.5, 7.5]), ("north", 60.0, [-5.0, 0.0, 5.0]), ("south", -60.0, [-5.0, 0.0, 5.0])]
AROUND = 3.0  # deg around the column from a fairlead to the next, for each degree between their chains

HEAD = f"""\
# A wind farm: ten floats, each held by ten chains, in irregular waves. Written by make_farm.py; sources, choices and
# expectations: README.md. x points east, y north, z up; the wind comes from the west.
hawser: 1
title: Wind farm of ten floats and a hundred mooring lines

environment:
  water: {{density: 1025, depth: {DEPTH:g}}}
  waves: {{jonswap: {{hs: 9, tp: 13, direction_deg: 20, seed: 1}}}}
  seabed:
    depth: {DEPTH:g}
    normal_stiffness: {{per_area: 100 kN/m3}}
    friction: {{axial: 0.6, lateral: 0.6, mobilisation_length: 0.05}}

line_types:
  chain: {{library: chain-studless, diameter: 100 mm, grade: R4}}
"""
TAIL = """\
contact: {volumes: []}                  # the floats are there to be seen

dynamics: {duration: 60, step: 0.2}

output:
  every: 1
  histories:
"""


def chains():
    """(name, number of the float from 0, fairlead in the float's frame, anchor in space) of every chain."""
    for i, (x, y) in enumerate(FLOATS):
        for cluster, angle, spread in CLUSTERS:
            column = math.radians(angle)
            for k, off in enumerate(spread):
                place, way = math.radians(angle + AROUND * off), math.radians(angle + off)
                fairlead = (COLUMN_RADIUS * math.cos(column) + COLUMN_DIAMETER / 2 * math.cos(place),
                            COLUMN_RADIUS * math.sin(column) + COLUMN_DIAMETER / 2 * math.sin(place), FAIRLEAD)
                anchor = (x + fairlead[0] + DISTANCE * math.cos(way), y + fairlead[1] + DISTANCE * math.sin(way), -DEPTH)
                yield f"{i + 1} {cluster} {k + 1}", i, fairlead, anchor


def case():
    out = [HEAD, "bodies:"]
    for i, (x, y) in enumerate(FLOATS):
        out.append(f"  float {i + 1}: {{position: [{x:g}, {y:g}, 0], motion: {{rao: {{file: float.rao, symmetry: "
                   f"port_starboard}}, drift: {{offset: [{OFFSET:g}, 0, 0]}}}}}}")
    out.append("\nvolumes:")
    out += [f"  float {i + 1}: {{mesh: float.obj, body: float {i + 1}}}" for i in range(len(FLOATS))]
    out.append("\nlines:")
    for name, i, fairlead, anchor in chains():
        at, to = (", ".join(f"{v:g}" if v == round(v) else f"{v:.3f}" for v in place) for place in (fairlead, anchor))
        out.append(f"  {name}: {{sections: [{{type: chain, length: {LENGTH:g}, elements: {ELEMENTS}}}], end_a: "
                   f"{{anchor: [{to}]}}, end_b: {{body: float {i + 1}, at: [{at}]}}}}")
    histories = []
    for name, *_ in chains():
        cluster, number = name.split()[1:]
        if number == "2":  # one in the middle of each cluster
            histories.append(f"    - {{line: {name}, at: end_b, name: {name}}}")
    return "\n".join(out) + "\n\n" + TAIL + "\n".join(histories) + "\n"


if __name__ == "__main__":
    path = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent / "farm.yaml"
    path.write_text(case(), encoding="utf-8")
    print(f"{path.name}: {len(FLOATS)} floats, {sum(1 for _ in chains())} chains of {ELEMENTS} elements")
