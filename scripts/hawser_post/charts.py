"""Charts: range graphs, histories, spectra and one quantity over another."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

from .envelopes import envelope  # noqa: E402
from .statistics import mean_of, spectrum  # noqa: E402

WIDE, HIGH = 7.2, 2.7  # inches
MOST_POINTS = 2000  # per curve; more are invisible
# Displayed units of SI quantities in figures and pages: factor and name.
SHOWN = {"N": (1e3, "kN"), "N m": (1e3, "kN m"), "N s": (1e3, "kN s"), "J": (1e3, "kJ"), "Pa": (1e6, "MPa")}
COLOURS = ["#1f5a92", "#c8651b", "#3c8d5a", "#8b4a8b", "#a03030", "#5b6770", "#b59a1f", "#2a9aa8"]
plt.rcParams.update({"font.size": 9, "axes.grid": True, "grid.alpha": 0.3, "axes.spines.top": False,
                     "axes.spines.right": False, "svg.hashsalt": "hawser", "legend.frameon": False, "axes.titlesize": 10.5, "axes.titlelocation": "left",
                     "axes.prop_cycle": matplotlib.cycler(color=COLOURS)})


def shown(unit):
    """Displayed unit of a quantity, and its size in the results' unit."""
    factor, name = SHOWN.get(unit, (1.0, unit))
    return name, factor


def colour(k, n):
    """Distinct colour of the k-th of n curves in one figure."""
    return COLOURS[k] if n <= len(COLOURS) else matplotlib.colors.to_hex(matplotlib.colormaps["turbo"](0.05 + 0.9 * k / (n - 1)))


def words(name):
    return name.replace("_", " ")


def label(name, unit):
    return f"{words(name)} [{unit}]" if unit not in ("", "1") else words(name)


def thinned(t, x):
    """A curve of the same appearance with fewer points: the least and largest of each piece."""
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


def legend(axes, most=5):
    """Adds a legend above the axes in rows of up to `most`."""
    names = axes.get_legend_handles_labels()[1]
    if not names:
        return
    title = axes.get_title("left")
    axes.set_title("")
    axes.legend(loc="lower left", bbox_to_anchor=(0, 1), borderaxespad=0.2, ncols=min(most, len(names)), fontsize=8,
                title=title, title_fontproperties={"size": 10.5}, alignment="left")


def range_graph(results, line, field, since=0.0):
    """Range graph: envelope from `since` on (over every step if the results have statistics, else over the outputs),
    mean, and first output (static, if the case has statics)."""
    start = results.magnitude(field, line, 0)
    unit, factor = shown(results.unit(field))
    figure, axes = sheet()
    found = envelope(results, line, field, since)
    if found is not None:
        axes.fill_between(line.arc, found.least / factor, found.most / factor, alpha=0.2, lw=0)
        for values, name in ((found.most, "maximum"), (found.mean, "mean"), (found.least, "minimum")):
            axes.plot(line.arc, values / factor, label=name)
    axes.plot(line.arc, start / factor, "k-" if found is None else "k--", lw=0.9, label=f"t = {results.time[0]:g} s")
    axes.set(xlabel="arc length from end A [m]", ylabel=label(results.label(field), unit), title=line.name)
    legend(axes)
    return figure


def station_graph(results, line, field, distance, found):
    """Envelope and mean of a field at the stations of a fed line (stations.of_line)."""
    unit, factor = shown(results.unit(field))
    figure, axes = sheet()
    least, most, mean = (found[field][:, k] / factor for k in (0, 2, 4))
    axes.fill_between(distance, least, most, alpha=0.2, lw=0)
    for values, name in ((most, "maximum"), (mean, "mean"), (least, "minimum")):
        axes.plot(distance, values, label=name)
    axes.set(xlabel="unstretched line from the feeder [m]", ylabel=label(results.label(field), unit), title=f"{line.name}, at stations")
    legend(axes)
    return figure


def stress_graph(results, line, stress, since=0.0):
    """Von Mises stress [Pa], outputs x nodes, along a line: envelope from `since` on and first output."""
    keep = results.since(since)
    figure, axes = sheet()
    if np.count_nonzero(keep) > 1:
        least, most = stress[keep].min(axis=0) / 1e6, stress[keep].max(axis=0) / 1e6
        axes.fill_between(line.arc, least, most, alpha=0.2, lw=0)
        for values, name in ((most, "maximum"), (mean_of(results.time[keep], stress[keep]) / 1e6, "mean"), (least, "minimum")):
            axes.plot(line.arc, values, label=name)
    axes.plot(line.arc, stress[0] / 1e6, "k--", lw=0.9, label=f"t = {results.time[0]:g} s")
    axes.set(xlabel="arc length from end A [m]", ylabel="von Mises stress [MPa]", title=line.name)
    legend(axes)
    return figure


def history(time, curves, unit, name, title=""):
    """Histories; curves: (label, values) at the times."""
    unit, factor = shown(unit)
    figure, axes = sheet(2.6)
    for k, (label_of, values) in enumerate(curves):
        axes.plot(*thinned(time, values / factor), lw=0.9, color=colour(k, len(curves)), label=label_of)
    axes.set(xlabel="time [s]", ylabel=label(name, unit), title=title)
    if len(curves) > 1:
        legend(axes, 6)
    return figure


def power(unit):
    """Square of a unit."""
    return f"({unit})²" if any(c in unit for c in " /") else f"{unit}²"


def density(time, values, unit, name, title=""):
    unit, factor = shown(unit)
    f, s = spectrum(time, values / factor)
    figure, axes = sheet(2.6)
    # Up to 99.9 % of the variance.
    total = np.cumsum(s)
    last = max(np.searchsorted(total, 0.999 * total[-1]) + 2, 3)
    axes.plot(f[:last], s[:last], lw=1.0, marker=".", ms=4)
    axes.set_xlim(left=0)
    axes.ticklabel_format(axis="y", style="plain")
    axes.set(xlabel=f"frequency [Hz], resolved to {f[1]:.2g} Hz", ylabel=f"{words(name)} [{power(unit)}/Hz]", title=title)
    return figure


def one_over_another(x, y, labels, title=""):
    figure, axes = sheet(4.0)
    axes.plot(x, y, lw=0.7)
    axes.set(xlabel=labels[0], ylabel=labels[1], title=title)
    return figure
