"""Figures of numbers: range graphs, histories, spectra and one quantity over another."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

from .statistics import mean_of, spectrum  # noqa: E402

WIDE, HIGH = 7.2, 3.0  # inches
MOST_POINTS = 2000  # of a curve, more are not seen
PREFIXES = {"N": [(1e6, "MN"), (1e3, "kN")], "N m": [(1e6, "MN m"), (1e3, "kN m")], "J": [(1e6, "MJ"), (1e3, "kJ")]}
COLOURS = ["#1f5a92", "#c8651b", "#3c8d5a", "#8b4a8b", "#a03030", "#5b6770"]
plt.rcParams.update({"font.size": 9, "axes.grid": True, "grid.alpha": 0.3, "axes.spines.top": False,
                     "axes.spines.right": False, "svg.hashsalt": "hawser", "legend.frameon": False,
                     "axes.prop_cycle": matplotlib.cycler(color=COLOURS)})


def scaled(unit, values):
    """A unit in which the values are read easily, and how many of the given one it is."""
    largest = max((float(np.nanmax(np.abs(v))) for v in values if np.size(v)), default=0)
    for factor, name in PREFIXES.get(unit, []):
        if largest >= 10 * factor or (largest >= factor and factor > 1e3):
            return name, factor
    return unit, 1.0


def words(name):
    return name.replace("_", " ")


def label(name, unit):
    return f"{words(name)} [{unit}]" if unit not in ("", "1") else words(name)


def thinned(t, x):
    """A curve that looks the same with fewer points: of each piece its least and its largest."""
    if len(t) <= MOST_POINTS:
        return t, x
    keep = [0, len(t) - 1]
    for piece in np.array_split(np.arange(len(t)), MOST_POINTS // 2):
        keep += [piece[np.argmin(x[piece])], piece[np.argmax(x[piece])]]
    keep = np.unique(keep)
    return t[keep], x[keep]


def sheet(high=HIGH):
    figure, axes = plt.subplots(figsize=(WIDE, high), layout="constrained")
    return figure, axes


def range_graph(results, line, field, since=0.0):
    """The envelope over the outputs from `since` on, the mean, and the first output (static, if the case has it)."""
    values = results.magnitude(field, line)
    keep = results.since(since)
    from_there = values[keep]
    unit, factor = scaled(results.unit(field), [values])
    figure, axes = sheet()
    if len(from_there) > 1:
        axes.fill_between(line.arc, from_there.min(axis=0) / factor, from_there.max(axis=0) / factor, alpha=0.2, lw=0)
        axes.plot(line.arc, from_there.max(axis=0) / factor, label="maximum")
        axes.plot(line.arc, mean_of(results.time[keep], from_there) / factor, label="mean")
        axes.plot(line.arc, from_there.min(axis=0) / factor, label="minimum")
    axes.plot(line.arc, values[0] / factor, "k--", lw=0.9, label=f"t = {results.time[0]:g} s")
    axes.set(xlabel="arc length from end A [m]", ylabel=label(field, unit), title=line.name)
    axes.legend(ncols=4, fontsize=8)
    return figure


def history(time, curves, unit, name, title=""):
    """curves: (label, values) at the times."""
    unit, factor = scaled(unit, [v for _, v in curves])
    figure, axes = sheet(2.6)
    for label_of, values in curves:
        axes.plot(*thinned(time, values / factor), lw=0.9, label=label_of)
    axes.set(xlabel="time [s]", ylabel=label(name, unit), title=title)
    if len(curves) > 1:
        axes.legend(ncols=4, fontsize=8)
    return figure


def density(time, values, unit, name, title=""):
    f, s = spectrum(time, values)
    figure, axes = sheet(2.6)
    # Up to where 99.9 % of the variance is.
    total = np.cumsum(s)
    shown = max(np.searchsorted(total, 0.999 * total[-1]) + 2, 3)
    axes.plot(f[:shown], s[:shown], lw=1.0, marker=".", ms=4)
    axes.set_xlim(left=0)
    axes.set(xlabel=f"frequency [Hz], resolved to {f[1]:.2g} Hz", ylabel=f"{words(name)} [{unit}²/Hz]", title=title)
    return figure


def one_over_another(x, y, labels, title=""):
    figure, axes = sheet(4.0)
    axes.plot(x, y, lw=0.7)
    axes.set(xlabel=labels[0], ylabel=labels[1], title=title)
    return figure
