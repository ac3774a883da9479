"""Tables of a report and of the CSV files: what lines are like at rest, extremes, statistics, clashes, energy."""
import numpy as np

from .statistics import statistics

VERTICAL = np.array([0.0, 0.0, 1.0])


def at_ends(results, output=0):
    """Rows of each end at an output: line, end, place, force of the line on what holds it, its angles."""
    head = ["line", "end", "x [m]", "y [m]", "z [m]", "tension [N]", "horizontal force [N]", "vertical force [N]",
            "declination [deg]", "azimuth [deg]"]
    forces, directions = results.ends("force"), results.ends("direction")
    rows = []
    for line in results.lines:
        x = results.field("position", line, output)
        tension = results.field("effective_tension", line, output) if results.has("effective_tension") else None
        for k, name in enumerate("AB"):
            row = [line.name, name, *x[-k]] + ["" if tension is None else tension[-k]]
            if forces is not None and directions is not None:
                force, along = forces[output, 2 * line.number + k], directions[output, 2 * line.number + k]
                # Angles of the direction out of the support into the line.
                outwards = along if k == 0 else -along
                row += [np.hypot(*force[:2]), force[2], np.degrees(np.arccos(np.clip(outwards @ VERTICAL, -1, 1))),
                        np.degrees(np.arctan2(outwards[1], outwards[0]))]
            rows.append(row + [""] * (len(head) - len(row)))
    return head, rows


def lying(results, line, output=0):
    """Stretches of the line that press on the seabed: (from, to) in m of arc length."""
    if not results.has("seabed_force"):
        return []
    down = np.linalg.norm(results.field("seabed_force", line, output), axis=1) > 0
    change = np.flatnonzero(np.diff(np.concatenate([[0], down.astype(int), [0]])))
    return [(float(line.arc[a]), float(line.arc[b - 1])) for a, b in zip(change[::2], change[1::2])]


def of_lines(results):
    head = ["line", "length [m]", "nodes", "distance of the ends [m]", "on the seabed at the start [m]"]
    rows = []
    for line in results.lines:
        x = results.field("position", line, 0)
        rows.append([line.name, line.length, len(line.arc), float(np.linalg.norm(x[-1] - x[0])),
                     "; ".join(f"{a:.4g} to {b:.4g}" for a, b in lying(results, line))])
    return head, rows


def extremes(results):
    head = ["quantity", "line", "value", "unit", "time [s]", "arc length [m]"]
    return head, [list(row) for row in results.summary()]


def statistics_of(results, since=0.0):
    """A row for each column of each history, over the steps from `since` on."""
    head = ["history", "quantity", "unit", "minimum", "at [s]", "maximum", "at [s]", "mean", "standard deviation",
            "mean period [s]"]
    rows = []
    time = results.step_time
    keep = time >= since
    if np.count_nonzero(keep) < 2:
        return head, rows
    for name in results.histories:
        series = results.series(name)
        for column in series.columns:
            x = series.column(column)[keep]
            if not np.all(np.isfinite(x)):
                continue
            s = statistics(time[keep], x)
            rows.append([series.name, column.replace("_", " "), series.unit(column), s.least, s.least_time, s.most,
                         s.most_time, s.mean, s.deviation, "" if np.isnan(s.period) else s.period])
    return head, rows


def clashes(results):
    names, units, rows = results.clashes()
    return [f"{n.replace('_', ' ')} [{u}]" if u else n.replace("_", " ") for n, u in zip(names, units)], rows


def energy(results):
    """The audit at the end of the run."""
    if "energy" not in results.series_names or results.steps == 0:
        return [], []
    series = results.series("energy")
    return ["energy", "J"], [[n.replace("_", " "), float(series.values[-1, i])] for i, n in enumerate(series.columns)]
