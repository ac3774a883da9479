#!/usr/bin/env python3
"""Writes fpso.yaml, a turret-moored FPSO on 8 mooring lines with 12 risers, and hull.obj, her hull for pictures."""
import math
from pathlib import Path

DEPTH, TURRET, KEEL = 400.0, 85.0, -10.0  # m; the turret lies ahead of midships
MOORINGS, CHAIN, WIRE, ANCHORS = 8, 900.0, 700.0, 1500.0  # m; lengths and the radius of the anchors
RISERS = [90 * quarter + 22.5 + turn for quarter in range(4) for turn in (-6, 0, 6)]  # deg
RISER = (("riser", 210.0), ("buoyant riser", 150.0), ("riser", 330.0))  # m from the turret
RISER_ANCHORS = 500.0  # m from the turret
LENGTH, BEAM, DEPTH_OF_HULL = 246.0, 46.0, 22.0  # m

HEAD = """\
# A turret-moored FPSO on 8 mooring lines with 12 risers in wind, current, waves and slow drift. Beside this file it needs the output
# of WAMIT that README.md names. Written by make_fpso.py; sources, choices and expectations: README.md. The ship lies with her bow
# to the east (+x), wind and waves come from there.
hawser: 1
title: Turret-moored FPSO in a storm

environment:
  gravity: 9.81
  water: {density: 1025, depth: 400}
  waves: {jonswap: {hs: 5.5, tp: 11.5, direction_deg: 180, seed: 1}, ramp: 100}
  current: {profile: [{depth: 0, speed: 0.9, direction_deg: 150}, {depth: 400, speed: 0.2, direction_deg: 150}]}
  wind: {speed: 20, direction_deg: 165, gusts: {spectrum: iso, seed: 2}}
  seabed: {depth: 400, normal_stiffness: {per_area: 100 kN/m3}, friction: 0}

line_types:
  chain: {library: chain-studless, diameter: 100 mm, grade: R4}
  wire: {library: wire-six-strand, diameter: 120 mm}
  riser: {outer_diameter: 0.4, mass_per_length: 200, EA: 500 MN, bending: false, Cd_normal: 1.0, Ca_normal: 1.0}
  buoyant riser: {outer_diameter: 0.8, mass_per_length: 420, EA: 500 MN, bending: false, Cd_normal: 1.0, Ca_normal: 1.0}

bodies:
  fpso:
    floating:
      mass: 94620210
      centre_of_mass: [3.93, 0, 2.5]
      inertia: [2.681824e10, 3.850273e11, 4.11e11]
      hydrodynamics:
        wamit: tanker                        # .1, .3, .9, .hst
        gravity_in_stiffness: true
        symmetry: port_starboard             # the files have waves of 0 to 180 deg
        second_order: newman
        damping: [[4.1e5, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 1.56e9, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0]]
      # C_x, C_y and C_n of smooth ships, chosen: 0.8 cos a, 0.9 sin a, 0.1 sin 2a; 0.05 cos a, 0.7 sin a, 0.06 sin 2a.
      wind:
        frontal_area: 1300
        lateral_area: 4200
        length: 246
        at: [0, 0, 10]
        rows: WIND
      current:
        draught: 10
        length: 246
        at: [0, 0, -5]
        rows: CURRENT

volumes:
  hull: {mesh: hull.obj, body: fpso}         # to be seen: nothing touches it

lines:
"""
TAIL = """
contact: {volumes: [], between_lines: false}

dynamics: {duration: 3600, step: 0.2}

output:
  every: 10
  history_every: 0.4
  histories:
    - {body: fpso}
    - {line: mooring 1, at: end_b, name: mooring 1}
    - {line: mooring 8, at: end_b, name: mooring 8}
    - {line: riser 1, at: end_b, name: riser 1}
"""


def coefficients(ahead, aside, turning):
    rows = [(a, ahead * math.cos(math.radians(a)), aside * math.sin(math.radians(a)), turning * math.sin(math.radians(2 * a)))
            for a in range(0, 181, 15)]
    return "[" + ", ".join(f"[{a}, {x:.4f}, {y:.4f}, {n:.4f}]" for a, x, y, n in rows) + "]"


def place(radius, bearing):
    return f"[{TURRET + radius * math.cos(math.radians(bearing)):.3f}, {radius * math.sin(math.radians(bearing)):.3f}, {-DEPTH:g}]"


def lines():
    turret = f"{{body: fpso, at: [{TURRET:g}, 0, {KEEL:g}]}}"
    for k in range(MOORINGS):
        yield (f"  mooring {k + 1}: {{sections: [{{type: chain, length: {CHAIN:g}, elements: 45}}, {{type: wire, length: {WIRE:g}, elements: 20}}], "
               f"end_a: {{anchor: {place(ANCHORS, 360 / MOORINGS * k)}}}, end_b: {turret}}}")
    for k, bearing in enumerate(RISERS):
        sections = ", ".join(f"{{type: {kind}, length: {length:g}, element_length: 10}}" for kind, length in RISER[::-1])
        yield f"  riser {k + 1}: {{sections: [{sections}], end_a: {{anchor: {place(RISER_ANCHORS, bearing)}}}, end_b: {turret}}}"


def hull():
    """A waterline with a round bow and a transom, from keel to deck."""
    half, side = LENGTH / 2, BEAM / 2
    ring = [(-half, -0.8 * side), (-half + 30, -side)]
    ring += [(half - side * 1.5 + 1.5 * side * math.sin(math.radians(t)), -side * math.cos(math.radians(t))) for t in range(0, 181, 10)]
    ring += [(-half + 30, side), (-half, 0.8 * side)]
    n, text = len(ring), ["# hull of an FPSO; z = 0 is her waterline"]
    for z in (KEEL, KEEL + DEPTH_OF_HULL):
        text += [f"v {x:.3f} {y:.3f} {z:.3f}" for x, y in ring]
    text += [f"v 0 0 {KEEL:.3f}", f"v 0 0 {KEEL + DEPTH_OF_HULL:.3f}"]
    for i in range(n):
        a, b = i + 1, (i + 1) % n + 1
        text += [f"f {a} {b} {b + n}", f"f {a} {b + n} {a + n}", f"f {b} {a} {2 * n + 1}", f"f {a + n} {b + n} {2 * n + 2}"]
    return "\n".join(text) + "\n"


def main():
    folder = Path(__file__).resolve().parent
    head = HEAD.replace("WIND", coefficients(0.8, 0.9, 0.1)).replace("CURRENT", coefficients(0.05, 0.7, 0.06))
    (folder / "fpso.yaml").write_text(head + "\n".join(lines()) + "\n" + TAIL)
    (folder / "hull.obj").write_text(hull())


if __name__ == "__main__":
    main()
