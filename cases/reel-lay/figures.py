#!/usr/bin/env python3
"""The figures and the picture of README.md: python3 cases/reel-lay/figures.py [RESULTS]."""
import math
import sys
from pathlib import Path

import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

HERE = Path(__file__).resolve().parent
RADIUS = 8 + 0.2191 / 2  # m, of the pipe's axis on the drum
SHEAVE = 90  # m, of the carriage from the drum
EI = 207e9 * math.pi / 64 * (0.2191**4 - 0.1937**4)
YIELD, A, B, FRICTION, REST = 180e3, 0.4, 12, 0.3, 300e3


def curve(curvature):
    """Moment of the first bend, Ramberg and Osgood."""
    low, high = 0.0, 2.0
    while high - low > 1e-12:
        m = (low + high) / 2
        low, high = (m, high) if YIELD / EI * (m + A * m**B) < curvature else (low, m)
    return low * YIELD


def column(file, series, name, steps):
    data = file[f"series/{series}"]
    names = [n.decode() if isinstance(n, bytes) else n for n in data.attrs["columns"]]
    return data[:steps, names.index(name)]


def main():
    path = Path(sys.argv[1]) if len(sys.argv) > 1 else HERE / "reel-lay.h5"
    with h5py.File(path) as f:
        steps = int(f["written"][()].item()[1]) if f["written"].dtype.names else int(f["written"][1])
        time = f["series/time"][:steps]
        paid, winch = (column(f, "wire_end_b_feed", name, steps) for name in ("paid_out", "tension"))
        damping = column(f, "energy", "damping", steps)
        pipe = f["nodes/line"][:] == 0
        arc, outputs = f["nodes/arc_length"][pipe], f["outputs/time"][:]
        field = {name: f[f"fields/{name}"][:, pipe] for name in
                 ("position", "curvature", "bending_moment", "residual_curvature", "effective_tension", "contact_normal_force")}

    def at(name, when):
        return field[name][int(np.argmin(np.abs(outputs - when)))]

    def step(when):
        return int(np.searchsorted(time, when))

    wound = (arc > 8) & (arc < 44)
    once = curve(1 / RADIUS)
    print(f"wound on at 90 s: {paid[step(90)]:.3f} m, by hand {2 * math.pi * RADIUS:.3f} m; back at 200 s: {paid[-1]:+.3f} m")
    pitch = 0.4 / (2 * math.pi * RADIUS)
    print(f"44 m from end A lie {np.interp(44, arc, at('position', 90)[:, 1]):.4f} m along the drum, by hand "
          f"{pitch * (44 - SHEAVE * (1 - math.exp(-44 / SHEAVE))):.4f} m")
    print(f"curvature on the drum: {np.median(at('curvature', 90)[wound]):.5f} 1/m, by hand {1 / RADIUS:.5f} 1/m")
    print(f"largest moment where it comes on, at 40 s: {at('bending_moment', 40)[arc > 20].max() / 1e3:.1f} kN m, by hand {once / 1e3:.1f} kN m")
    moment, rest = np.median(at("bending_moment", 90)[wound]), np.median(at("residual_curvature", 90)[wound])
    print(f"moment on the drum: {moment / 1e3:.1f} kN m, residual curvature {rest:.5f} 1/m, by hand k - M/EI = {1 / RADIUS - moment / EI:.5f}")
    straight, kept = np.median(at("bending_moment", 200)[wound]), np.median(at("residual_curvature", 200)[wound])
    print(f"paid off: moment {straight / 1e3:.1f} kN m, residual curvature {kept:.5f} 1/m, radius {1 / kept:.0f} m")
    lost = np.diff(damping[[step(12), step(68)]])[0] / np.diff(paid[[step(12), step(68)]])[0]
    m = np.linspace(0, once / YIELD, 20001)
    bent = YIELD / EI * (m + A * m**B)
    below = float(np.sum(YIELD * (m[1:] + m[:-1]) / 2 * np.diff(bent)))  # the area below the curve
    by_hand = 2 * below - once / RADIUS
    print(f"plastic work on the way on: {lost / 1e3:.2f} kJ/m, by hand {by_hand / 1e3:.2f} kJ/m")
    tension = at("effective_tension", 98)
    away = arc[np.nonzero(at("contact_normal_force", 98) > 0)[0][-1]]
    for turn in (0.25, 0.5, 0.75):
        place = away - turn * RADIUS
        print(f"tension {turn} rad behind where it leaves the drum, at rest: {np.interp(place, arc, tension) / 1e3:.1f} kN, "
              f"capstan {REST * math.exp(FRICTION * turn) / 1e3:.1f} kN")

    figure, axes = plt.subplots(2, 2, figsize=(11, 7), layout="constrained")
    shape = axes[0, 0]
    angle = np.linspace(0, 2 * math.pi, 200)
    shape.fill(8 * np.cos(angle), 8 * np.sin(angle), color="0.85")
    for when in (0, 40, 90, 140):
        x = at("position", when)
        shape.plot(x[:, 0], x[:, 2], label=f"{when} s", linewidth=1.5)
    shape.set(xlim=(-10, 30), ylim=(-10, 12), xlabel="x [m]", ylabel="z [m]", aspect="equal")
    shape.legend(loc="lower right")
    axes[0, 1].plot(time, winch / 1e3)
    axes[0, 1].set(xlabel="time [s]", ylabel="tension of the winch [kN]")
    for when, axis in ((90, axes[1, 0]), (200, axes[1, 1])):
        axis.plot(arc, at("curvature", when), label="curvature")
        axis.plot(arc, at("residual_curvature", when), label="residual curvature")
        axis.set(xlabel=f"arc length of the pipe [m], {when} s", ylabel="1/m", ylim=(0, 0.16))
        axis.legend()
    for axis in axes.flat[1:]:
        axis.grid(alpha=0.3)
    figure.savefig(HERE / "reel-lay.png", dpi=100)


if __name__ == "__main__":
    main()
