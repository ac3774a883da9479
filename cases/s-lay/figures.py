#!/usr/bin/env python3
"""The figures of README.md: python3 cases/s-lay/figures.py [RESULTS, default simple.h5 beside this file]."""
import math
import sys
from pathlib import Path

import h5py
import numpy as np

EI = 212e9 * math.pi / 64 * (0.25**4 - 0.22**4)
R, S = 150 + 1 + 0.2 + 0.125, 12 * (150 + 1 + 0.2 + 0.125) / 150  # m, of the pipe's axis over the stinger
STEEL = 9.80665 * 7850 * math.pi / 4 * (0.25**2 - 0.22**2)
WATER = 9.80665 * 1025 * math.pi / 4 * 0.25**2


def main():
    path = sys.argv[1] if len(sys.argv) > 1 else Path(__file__).with_name("simple.h5")
    with h5py.File(path) as f:
        arc, x = f["nodes/arc_length"][:], f["fields/position"][0]
        moment, tension = f["fields/bending_moment"][0], f["fields/effective_tension"][0]
        print(f"EI {EI / 1e3:.1f} kN m2, submerged weight {STEEL - WATER:.2f} N/m, radius of the axis {R:.3f} m")
        # The stinger turns the pipe by one angle between two rollers: the mean of its curvature there.
        where = [np.argmin(np.hypot(x[:, 0] - bx, x[:, 2] - bz)) for bx, bz in boxes()]
        first, last = where[5], where[8]
        span = slice(first, last + 1)
        mean = np.trapz(moment[span], arc[span]) / (arc[last] - arc[first])
        print(f"mean moment, rollers 6 to 9: {mean / 1e3:.2f} kN m; EI/R {EI / R / 1e3:.2f} kN m "
              f"({100 * (mean * R / EI - 1):+.2f} %)")
        ends = f["series/tensioner"]
        print(f"tension: tensioner {tension[0] / 1e3:.2f} kN, end on the bed {tension[-1] / 1e3:.2f} kN")
        print("roller  force [kN]  closed form        moment [kN m]  closed form        reactions in the sea [kN]")
        steps = int(f["written"]["steps"][0])
        for k, n in enumerate(where, 1):
            force = np.linalg.norm(f[f"series/stinger_{k}"][:steps, :3], axis=1)
            peak = moment[max(n - 1, 0):n + 2].max()
            text = f"{k:6d}  {force[0] / 1e3:10.2f}"
            if k in (7, 8):  # of an endless row of rollers above the water
                w = STEEL * math.cos(12 * (k - 4) / 150)
                beta = S / 2 * math.sqrt(tension[n] / EI)
                expected = EI * ((1 / R + w / tension[n]) * beta / math.tanh(beta) - w / tension[n])
                row = (tension[n] / R + w) * S
                text += f"  {row / 1e3:6.2f} ({100 * (force[0] / row - 1):+.1f} %)"
                text += f"  {peak / 1e3:14.2f}  {expected / 1e3:6.2f} ({100 * (peak / expected - 1):+.1f} %)"
            else:
                text += f"{'':17s}  {peak / 1e3:14.2f}{'':18s}"
            print(text + f"  {force.min() / 1e3:8.2f} to {force.max() / 1e3:.2f}")


def boxes():
    """Where the axis of a pipe that touches each roller is, in space (the barge is at x = 50)."""
    for s in [5, 10, 15, 20, 32, 44, 56, 68, 80, 92, 104]:
        a = max(s - 20, 0) / 150
        yield (20 - min(s, 20) - R * math.sin(a), 10.325 - R * (1 - math.cos(a)))


if __name__ == "__main__":
    main()
