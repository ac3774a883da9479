"""The pull of the winch beside that of a rope without stiffness, and the pull at the head.

    /usr/bin/python3 cases/jtube/figures.py [cases/jtube/jtube.h5]

Along the path of the cable, s from the free end, with its weight w in water or in air, the angle a to the horizontal,
the bend's radius r (of the inner side of the bore, where a tight cable lies) and Coulomb friction:

    dT/ds = mu w                              on the bed and in the level part
    dT/ds = w sin a + mu |T/r - w cos a|      in the bend
    dT/ds = w                                 upright
"""
import sys
from math import cos, pi, sin

import h5py

G, RHO = 9.80665, 1025
WIRE, CABLE = (7, 0.04), (45, 0.16)  # mass per length, diameter
BED, TUBE, BEND, BORE, LOWER_END, TOP = 0.4, 0.25, 5.0, 0.25, 11.0, 12.0
LENGTH, START, FLOOR = 60.0, 9.0, -24.6  # of the cable; x of the head; axis of the level part


def weight(line, z):
    mass, diameter = line
    return G * (mass - (RHO * pi / 4 * diameter**2 if z < 0 else 0))


def pulls(hauled, step=0.005):
    """Tension at the head and at the winch when `hauled` metres have come in."""
    head = LENGTH
    s = 0.0
    tension, at_head = 0.0, None
    x, angle = START + LENGTH - hauled, 0.0  # of the free end, along the level path
    z = FLOOR - BORE
    while z < TOP:
        line = CABLE if s < head else WIRE
        if s >= head and at_head is None:
            at_head = tension
        r = BEND - BORE + line[1] / 2
        w = weight(line, z)
        if x > BEND:
            tension += step * (BED if x > LOWER_END else TUBE) * w
            x -= step
        elif angle < pi / 2:
            tension += step * (w * sin(angle) + TUBE * abs(tension / r - w * cos(angle)))
            z += step * sin(angle)
            angle += step / r
        else:
            tension += step * w
            z += step
        s += step
    return at_head, tension


def main(file):
    with h5py.File(file) as results:
        series = results["series"]
        column = lambda name: series[name][:, [c.decode() for c in series[name].attrs["columns"]].index("effective_tension")]
        time, winch, head = series["time"][:], column("winch"), column("head")
    print("hauled in [m]   pull at the winch [kN]   rope [kN]   difference     at the head [kN]   rope [kN]   difference")
    for at in (15, 30, 45, 60, 75, 90, 99):
        k = min(range(len(time)), key=lambda i: abs(time[i] - at))
        hauled = 0.4 * (at - 5)
        rope_head, rope = pulls(hauled)
        print(f"{hauled:13.1f} {winch[k] / 1e3:24.2f} {rope / 1e3:11.2f} {100 * (winch[k] / rope - 1):+10.1f} % "
              f"{head[k] / 1e3:18.2f} {rope_head / 1e3:11.2f} {100 * (head[k] / rope_head - 1):+10.1f} %")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "cases/jtube/jtube.h5")
