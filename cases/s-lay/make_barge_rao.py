#!/usr/bin/env python3
"""Writes barge.rao: responses of a box-shaped lay barge of 120 m by 30 m, 5 m deep in the water, to waves.

Heave and pitch by the closed forms of Jensen, Mansour & Olsen (2004), "Estimation of ship motions using closed-form
expressions", Ocean Engineering 31, for zero speed. Surge and sway are those of the water, averaged over the hull (Froude and
Krylov, without diffraction); roll is that of an oscillator under the slope of the waves averaged in the same way, of metacentric
height, inertia and damping chosen here. Yaw is left out. Time goes by exp(i w t), the crest is at midships at t = 0; waves go
to `direction` as seen from the bow, roll and pitch are right-handed about x (ahead) and y (to port)."""
import cmath
import math
from pathlib import Path

GRAVITY = 9.80665
LENGTH, BREADTH, DRAUGHT = 120.0, 30.0, 5.0  # m
METACENTRIC_HEIGHT, ROLL_RADIUS, ROLL_DAMPING = 9.5, 12.0, 0.1  # m; m, with added mass; of critical


def mean(x):
    """Of a wave over a length of 2x in phase."""
    return math.sin(x) / x if abs(x) > 1e-6 else 1.0


def responses(period, direction):
    w = 2 * math.pi / period
    k = w * w / GRAVITY
    along, across = math.cos(math.radians(direction)), math.sin(math.radians(direction))
    x, y = 0.5 * k * LENGTH * along, 0.5 * k * BREADTH * across
    # Heave and pitch: one damped equation with two excitations.
    radiated = 2 * math.sin(0.5 * k * BREADTH) * math.exp(-k * DRAUGHT)
    damping = radiated**2 / (k * BREADTH)
    smith = math.exp(-abs(k * along) * DRAUGHT)
    excitation = smith * math.hypot(1 - k * DRAUGHT, damping)
    answer = excitation / complex(1 - 2 * k * DRAUGHT, damping)
    lever = 3 * (math.sin(x) - x * math.cos(x)) / x**3 if abs(x) > 1e-3 else 1.0  # of the slope k cos(direction), averaged
    heave, pitch = answer * mean(x), 1j * answer * k * along * lever
    water = math.exp(-0.5 * k * DRAUGHT) * mean(x) * mean(y)
    ratio = w * ROLL_RADIUS / math.sqrt(GRAVITY * METACENTRIC_HEIGHT)
    roll = -1j * k * across * water / complex(1 - ratio**2, 2 * ROLL_DAMPING * ratio)
    degrees = math.degrees(1)
    return -1j * along * water, -1j * across * water, heave, roll * degrees, pitch * degrees, 0j


def main():
    rows = ["# Responses of a box-shaped lay barge, written by make_barge_rao.py: period [s], direction [deg], then amplitude",
            "# and lag [deg] of surge, sway, heave [m/m], roll, pitch, yaw [deg/m]."]
    for direction in range(0, 181, 15):
        for period in (0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4, 4.5, 5, 5.5, 6, 6.5, 7, 7.5, 8, 8.5, 9, 10, 11, 12, 14, 16, 20, 25):
            columns = (f"{abs(r):.4g} {0.0 if abs(r) < 1e-9 else -math.degrees(cmath.phase(r)):.1f}" for r in responses(period, direction))
            rows.append(f"{period:g} {direction} " + " ".join(columns))
    (Path(__file__).parent / "barge.rao").write_text("\n".join(rows) + "\n", "utf-8")


if __name__ == "__main__":
    main()
