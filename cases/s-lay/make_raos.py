#!/usr/bin/env python3
"""Writes barge.rao and tug.rao: responses to waves of a lay barge, taken as a box of 120 m by 30 m by 5 m in the water, and
of a tug of 60 m by 15 m by 5 m.

Heave and pitch by the closed forms of Jensen, Mansour & Olsen (2004), "Estimation of ship motions using closed-form
expressions", Ocean Engineering 31, for zero speed. Surge and sway are those of the water, averaged over the hull (Froude and
Krylov, without diffraction); roll is that of an oscillator under the slope of the waves averaged in the same way, of metacentric
height, inertia and damping chosen here. Yaw is excluded. Time goes by exp(i w t), the crest is at midships at t = 0; waves go
to `direction` as seen from the bow, roll and pitch are right-handed about x (ahead) and y (to port)."""
import cmath
import math
from dataclasses import dataclass
from pathlib import Path

GRAVITY = 9.80665


@dataclass
class Hull:
    name: str
    words: str
    length: float  # m
    breadth: float
    draught: float
    block: float  # coefficient
    metacentric_height: float
    roll_radius: float  # m, with added mass
    roll_damping: float  # of critical


HULLS = [Hull("barge", "a box-shaped lay barge", 120, 30, 5, 1, 9.5, 12, 0.1),
         Hull("tug", "an anchor handling tug", 60, 15, 5, 0.7, 1.5, 5.5, 0.1)]


def mean(x):
    """Of a wave over a length of 2x in phase."""
    return math.sin(x) / x if abs(x) > 1e-6 else 1.0


def responses(hull, period, direction):
    w = 2 * math.pi / period
    k = w * w / GRAVITY
    along, across = math.cos(math.radians(direction)), math.sin(math.radians(direction))
    breadth = hull.breadth * hull.block  # of the box of the same volume
    x, y = 0.5 * k * hull.length * along, 0.5 * k * breadth * across
    # Heave and pitch: one damped equation with two excitations.
    radiated = 2 * math.sin(0.5 * k * breadth) * math.exp(-k * hull.draught)
    damping = radiated**2 / (k * breadth)
    smith = math.exp(-abs(k * along) * hull.draught)
    excitation = smith * math.hypot(1 - k * hull.draught, damping)
    answer = excitation / complex(1 - 2 * k * hull.draught, damping)
    lever = 3 * (math.sin(x) - x * math.cos(x)) / x**3 if abs(x) > 1e-3 else 1.0  # of the slope k cos(direction), averaged
    heave, pitch = answer * mean(x), 1j * answer * k * along * lever
    water = math.exp(-0.5 * k * hull.draught) * mean(x) * mean(y)
    ratio = w * hull.roll_radius / math.sqrt(GRAVITY * hull.metacentric_height)
    roll = -1j * k * across * water / complex(1 - ratio**2, 2 * hull.roll_damping * ratio)
    degrees = math.degrees(1)
    return -1j * along * water, -1j * across * water, heave, roll * degrees, pitch * degrees, 0j


def main():
    for hull in HULLS:
        rows = [f"# Responses of {hull.words}, written by make_raos.py: period [s], direction [deg], then amplitude",
                "# and lag [deg] of surge, sway, heave [m/m], roll, pitch, yaw [deg/m]."]
        for direction in range(0, 181, 15):
            for period in (0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4, 4.5, 5, 5.5, 6, 6.5, 7, 7.5, 8, 8.5, 9, 10, 11, 12, 14, 16, 20, 25):
                columns = (f"{abs(r):.4g} {0.0 if abs(r) < 1e-9 else -math.degrees(cmath.phase(r)):.1f}"
                           for r in responses(hull, period, direction))
                rows.append(f"{period:g} {direction} " + " ".join(columns))
        (Path(__file__).parent / f"{hull.name}.rao").write_text("\n".join(rows) + "\n", "utf-8")


if __name__ == "__main__":
    main()
