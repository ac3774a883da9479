#!/usr/bin/env python3
"""The figures and the picture of README.md: python3 cases/heave-compensator/figures.py [RESULTS]."""
import math
import sys
from pathlib import Path

import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

HERE = Path(__file__).resolve().parent
MASS, STIFFNESS, DAMPING, HEAVE, OMEGA = 60e3, 6e3, 6e3, 1.5, 2 * math.pi / 8


def column(file, series, name):
    data = file[f"series/{series}"]
    names = [n.decode() if isinstance(n, bytes) else n for n in data.attrs["columns"]]
    return data[:, names.index(name)]


def main():
    path = Path(sys.argv[1]) if len(sys.argv) > 1 else HERE / "heave-compensator.h5"
    with h5py.File(path) as f:
        steps = int(f["written"][()].item()[1]) if f["written"].dtype.names else int(f["written"][1])
        time = f["series/time"][:steps]
        load, hook, tip, length = (column(f, s, c)[:steps] for s, c in (
            ("load", "position_z"), ("hook", "position_z"), ("tip", "effective_tension"), ("compensator_link", "length")))
    last = (time >= 208 - 1e-9) & (time < 240 - 1e-9)  # four periods

    def amplitude(values):
        return 2 * np.hypot(np.mean(values[last] * np.sin(OMEGA * time[last])), np.mean(values[last] * np.cos(OMEGA * time[last])))

    below = math.hypot(STIFFNESS - MASS * OMEGA**2, DAMPING * OMEGA)
    for what, found, hand in (("heave of the load", amplitude(load), HEAVE * math.hypot(STIFFNESS, DAMPING * OMEGA) / below),
                              ("stroke", amplitude(length), HEAVE * MASS * OMEGA**2 / below)):
        print(f"{what}: {found:.5f} m, by hand {hand:.5f} m ({100 * (found / hand - 1):+.3f} %)")
    print(f"heave of the hook: {amplitude(hook):.5f} m, tension at the tip: +- {amplitude(tip):.0f} N")
    figure, (above, under) = plt.subplots(2, 1, figsize=(9, 5), sharex=True, layout="constrained")
    early = time <= 80
    above.plot(time[early], hook[early] - hook[0], label="hook")
    above.plot(time[early], load[early] - load[0], label="load")
    above.set_ylabel("heave [m]")
    above.legend(loc="lower right")
    under.plot(time[early], tip[early] / 1e3, color="tab:red")
    under.set_ylabel("tension at the tip [kN]")
    under.set_xlabel("time [s]")
    for axes in (above, under):
        axes.grid(alpha=0.3)
    figure.savefig(HERE / "heave-compensator.png", dpi=110)


if __name__ == "__main__":
    main()
