"""Results as CSV files, one table each, with the units in the first row."""
import csv
import re

import numpy as np

from . import tables
from .envelopes import envelope, only_one


def write(path, head, rows):
    with path.open("w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(head)
        table.writerows([v if isinstance(v, str) else f"{v:.9g}" for v in row] for row in rows)
    return path


def file_name(name):
    return re.sub(r"[^\w.@+-]+", "_", name)


def series(results, name):
    s = results.series(name)
    head = ["time [s]"] + [f"{c} [{u}]" if u not in ("", "1") else c for c, u in zip(s.columns, s.units)]
    return head, np.column_stack([results.step_time, s.values])


def ranges(results, line, since=0.0):
    """Of each field along a line: least, mean and largest from `since` on, over every step where the results have that,
    else over the outputs."""
    head, columns = ["arc_length [m]"], [line.arc]
    for field in results.fields:
        if field in ("position", "velocity", "axis_1", "axis_2"):
            continue
        unit, found = results.unit(field), envelope(results, line, field, since)
        if found is None:
            found = only_one(results.magnitude(field, line, 0))
        for what, column in (("min", found.least), ("mean", found.mean), ("max", found.most)):
            head.append(f"{field}_{what} [{unit}]")
            columns.append(column)
    return head, np.column_stack(columns)


def shapes(results, line):
    """The translations of each mode along a line."""
    head, columns = ["arc_length [m]"], [line.arc]
    for k in range(1, results.outputs):
        head += [f"mode_{k}_{c}" for c in "xyz"]
        columns += list(results.field("mode_shape", line, k).T)
    return head, np.column_stack(columns)


def modes(results, folder):
    series = results.series("modes")
    rows = np.column_stack([np.arange(1, results.steps + 1), series.values])
    done = [write(folder / "modes.csv", ["mode", "period [s]", "frequency [Hz]"], rows)]
    return done + [write(folder / f"shape_{file_name(line.name)}.csv", *shapes(results, line)) for line in results.lines]


def everything(results, folder, since=0.0):
    """`since`: s, from when on statistics and ranges count."""
    folder.mkdir(parents=True, exist_ok=True)
    if results.modes:
        return modes(results, folder)
    done = [write(folder / "lines.csv", *tables.of_lines(results)), write(folder / "ends.csv", *tables.at_ends(results))]
    for name, (head, rows) in (("extremes", tables.extremes(results)), ("statistics", tables.statistics_of(results, since)),
                               ("clashes", tables.clashes(results))):
        if rows:
            done.append(write(folder / f"{name}.csv", head, rows))
    for name in results.series_names:
        kind = "history_" if name in results.histories else ""
        done.append(write(folder / f"{kind}{file_name(name)}.csv", *series(results, name)))
    for line in results.lines:
        done.append(write(folder / f"range_{file_name(line.name)}.csv", *ranges(results, line, since)))
    return done
