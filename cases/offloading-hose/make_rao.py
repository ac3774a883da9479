#!/usr/bin/env python3
"""Writes vlcc.rao, how the ship of make_hull.py moves in waves, estimated by closed forms. Not a computation by panels.

    cases/offloading-hose/make_rao.py [OUTPUT.rao]

Heave and pitch: Jensen, Mansour & Olsen (2004), "Estimation of ship motions using closed-form expressions", Ocean
Engineering 31, for a box of the ship's length, beam and draught without speed:

    2 (kT/w²) z'' + A²/(kB w) z' + z = a F cos(w t),    the same for pitch with a G sin(w t),
    F = K f sin(q)/q,  G = K f (6/L) (sin q - q cos q)/q²,  q = k_e L/2,  k_e = |k cos b|,
    K = exp(-k_e T),  f² = (1 - kT)² + (A²/kB)²,  A = 2 sin(kB/2) exp(-kT).

Surge and sway: the Froude-Krylov force on that box over its mass, which is the mean motion of the water in its place,
exp(kz) averaged over the draught. Roll and yaw are left at nothing; the case's wave comes from astern. Deep water.
"""
import cmath
import math
import sys
from pathlib import Path

LENGTH, BEAM, DRAUGHT, GRAVITY = 320.0, 55.0, 21.0, 9.80665  # m, m/s²
PERIODS = [5, 6, 7, 8, 9, 9.5, 10, 10.5, 11, 12, 13, 14, 15, 16, 18, 20, 25, 30]  # s
DIRECTIONS = range(0, 360, 45)  # deg, where the wave goes to, seen from the bow


def sinc(x):
    return math.sin(x) / x if abs(x) > 1e-8 else 1.0


def responses(period, direction):
    """Surge, sway, heave [m/m], roll, pitch, yaw [deg/m] as complex numbers R: motion = Re(R exp(i w t)), the crest
    being at the ship's middle at t = 0."""
    omega = 2 * math.pi / period
    k = omega**2 / GRAVITY
    along, across = k * math.cos(math.radians(direction)), k * math.sin(math.radians(direction))
    effective = abs(along)
    q = max(0.5 * effective * LENGTH, 1e-6)
    made = 2 * math.sin(0.5 * k * BEAM) * math.exp(-k * DRAUGHT)
    damping = made**2 / (k * BEAM)
    reduction = math.exp(-effective * DRAUGHT) * math.hypot(1 - k * DRAUGHT, damping)
    resistance = 1 - 2 * k * DRAUGHT + 1j * damping
    heave = reduction * math.sin(q) / q / resistance
    slope = reduction * 6 / LENGTH * (math.sin(q) - q * math.cos(q)) / q**2 / resistance
    # Where the crest comes from astern the bow rises as sin(w t), and positive pitch puts it down.
    pitch = 1j * slope * math.copysign(1, along) if effective > 1e-9 else 0
    # Water at the crest moves with the wave; its displacement is a sin(w t).
    mean = (1 - math.exp(-k * DRAUGHT)) / (k * DRAUGHT) * sinc(0.5 * along * LENGTH) * sinc(0.5 * across * BEAM)
    surge, sway = -1j * mean * along / k, -1j * mean * across / k
    return [surge, sway, heave, 0, pitch * 180 / math.pi, 0]


def main():
    path = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent / "vlcc.rao"
    with open(path, "w") as file:
        file.write("# VLCC 320 x 55 x 21 m, closed-form estimate by make_rao.py; phases are lags behind the crest\n")
        file.write("# period s, direction deg; surge, sway, heave m/m, roll, pitch, yaw deg/m, each with its lag in deg\n")
        for direction in DIRECTIONS:
            for period in PERIODS:
                row = []
                for r in responses(period, direction):
                    small = abs(r) < 5e-6
                    row += [0 if small else abs(r), 0 if small else -math.degrees(cmath.phase(r)) % 360]
                file.write(f"{period:g} {direction} " +
                           " ".join(f"{x:.5g}" if i % 2 == 0 else f"{x:.1f}" for i, x in enumerate(row)) + "\n")
    print(f"{path.name}: {len(PERIODS)} periods, {len(DIRECTIONS)} directions; "
          f"heave {abs(responses(10, 0)[2]):.4f} m/m and pitch {abs(responses(10, 0)[4]):.4f} deg/m at 10 s from astern")


if __name__ == "__main__":
    main()
