#!/usr/bin/env python3
"""Plan views of both runs, with and without contact: offloading-hose.png and no-contact.png.

    cases/offloading-hose/plot.py [FOLDER OF THE RESULTS]        (needs h5py and matplotlib)

The ship's waterline (grey), and the hose coloured by effective tension at some times; north is up.
"""
import sys
from pathlib import Path

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.collections import LineCollection  # noqa: E402

HERE = Path(__file__).resolve().parent
TIMES = [0, 60, 100, 140, 200, 400]  # s


def waterline():
    """Segments of the hull's cut with z = 0, in space: the ship heads north."""
    vertices, segments = [], []
    for line in open(HERE / "hull.obj"):
        words = line.split()
        if words and words[0] == "v":
            x, y, z = map(float, words[1:])
            vertices.append((-y, x, z + 1e-4))
        elif words and words[0] == "f":
            corners = [vertices[int(w) - 1] for w in words[1:]]
            cut = []
            for a, b in zip(corners, corners[1:] + corners[:1]):
                if (a[2] < 0) != (b[2] < 0):
                    t = a[2] / (a[2] - b[2])
                    cut.append((a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])))
            if len(cut) == 2:
                segments.append(cut)
    return segments


def draw(results, target):
    ship = waterline()
    with h5py.File(results) as file:
        rows = int(file["written"][0][0])
        time = file["outputs/time"][:rows]
        chosen = [int(np.argmin(abs(time - t))) for t in TIMES]
        shapes = [file["fields/position"][i] for i in chosen]
        tensions = [file["fields/effective_tension"][i] / 1e3 for i in chosen]
    limits = plt.Normalize(-5, 15)
    figure, frames = plt.subplots(2, 3, figsize=(12, 8.6), sharex=True, sharey=True, layout="constrained")
    for frame, i, x, tension in zip(frames.flat, chosen, shapes, tensions):
        frame.add_collection(LineCollection(ship, colors="0.35", linewidths=1.5))
        pieces = np.stack([x[:-1, :2], x[1:, :2]], axis=1)
        hose = LineCollection(pieces, array=0.5 * (tension[1:] + tension[:-1]), norm=limits, linewidths=2.5)
        frame.add_collection(hose)
        frame.set(xlim=(-130, 110), ylim=(-215, -15), aspect="equal", title=f"t = {time[i]:.0f} s")
    for frame in frames[1]:
        frame.set_xlabel("east, m")
    for frame in frames[:, 0]:
        frame.set_ylabel("north, m")
    figure.colorbar(hose, ax=frames, label="effective tension, kN", extend="both", shrink=0.6)
    figure.savefig(target, dpi=80)
    print(target)


if __name__ == "__main__":
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else HERE
    draw(folder / "offloading-hose.h5", HERE / "offloading-hose.png")
    draw(folder / "offloading-hose-no-contact.h5", HERE / "no-contact.png")
