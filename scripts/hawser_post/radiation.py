"""hawser plot TABLE radiation: retardation functions from a table of hawser check --radiation, and their check by
Ogilvie's relation."""
import csv
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from .charts import WIDE, colour, legend
from .results import Refusal

FIRST = ["quantity", "t [s] or omega [rad/s]"]
QUANTITIES = ("retardation", "damping", "added mass", "added mass by damping")


def read(path):
    """Names of the entries, and times or frequencies and rows by quantity."""
    try:
        with open(path, newline="") as file:
            rows = list(csv.reader(file))
        if not rows or rows[0][:2] != FIRST:
            raise ValueError
        found = {name: np.array([[float(x) for x in row[1:]] for row in rows[1:] if row[0] == name]) for name in QUANTITIES}
        if any(values.ndim != 2 for values in found.values()):
            raise ValueError
        return rows[0][2:], {name: (values[:, 0], values[:, 1:]) for name, values in found.items()}
    except OSError as e:
        raise Refusal(f"{path}: cannot be read ({e.strerror})") from None
    except (ValueError, UnicodeDecodeError):
        raise Refusal(f"{path}: the figure 'radiation' needs a table of hawser check --radiation; this is not one") from None


def figure_of(path):
    """Figure of K(t)/K(0) for the diagonal entries, and of their added mass by frequency, from the files as dots and
    from the damping as a line, relative to the largest of each."""
    names, found = read(Path(path))
    own = [k for k, name in enumerate(names) if len(set(name.split("-"))) == 1]
    figure, (left, right) = plt.subplots(1, 2, figsize=(WIDE, 3.4), layout="constrained")
    time, K = found["retardation"]
    omega, A = found["added mass"]
    by_omega, by_damping = found["added mass by damping"]
    # K is small at the end of most of the memory: the figure shows the part above one percent of the start.
    visible = np.flatnonzero((np.abs(K[:, own]) > 0.01 * np.abs(K[0, own])).any(axis=1))
    for n, k in enumerate(own):
        shade = colour(n, len(own))
        left.plot(time, K[:, k] / K[0, k], color=shade, label=names[k].split("-")[0])
        right.plot(omega, A[:, k] / np.abs(A[:, k]).max(), ".", color=shade, ms=3)
        right.plot(by_omega, by_damping[:, k] / np.abs(A[:, k]).max(), color=shade, lw=1)
    left.set(xlabel="t [s]", ylabel="K(t)/K(0)", xlim=(0, time[visible[-1]] if len(visible) else None))
    right.set(xlabel="ω [rad/s]", ylabel="added mass over its largest value: files •, from damping –")
    legend(left, 3)
    return figure
