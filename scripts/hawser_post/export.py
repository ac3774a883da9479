"""Results as CSV files, one table each, with units in the first row."""
import csv
import re

import numpy as np

from . import tables
from .arguments import place_for
from .envelopes import envelope, only_one


def write(path, head, rows):
    with path.open("w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(head)
        table.writerows([v if isinstance(v, str) else f"{v:.9g}" for v in row] for row in rows)
    return path


def file_name(name):
    return re.sub(r"[^\w.@+-]+", "_", name)


def file_names(names):
    """Unique file names, ignoring letter case: `a_b` keeps its name, then `a b` becomes `a_b_2`."""
    found, taken = {}, set()
    for name in sorted(names, key=lambda name: file_name(name) != name):
        plain, k = file_name(name), 1
        while (file := plain if k == 1 else f"{plain}_{k}").lower() in taken:
            k += 1
        taken.add(file.lower())
        found[name] = file
    return found


def series(results, name):
    s = results.series_at(name)
    head = ["time [s]"] + [f"{c} [{u}]" if u not in ("", "1") else c for c, u in zip(s.columns, s.units)]
    return head, np.column_stack([results.step_time, s.values])


def ranges(results, line, since=0.0):
    """Least, mean and largest value of each field along a line from `since` on, over every step if the results have
    statistics, else over the outputs."""
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
    """Translations of each mode along a line."""
    head, columns = ["arc_length [m]"], [line.arc]
    for k in range(1, results.outputs):
        head += [f"mode_{k}_{c}" for c in "xyz"]
        columns += list(results.field("mode_shape", line, k).T)
    return head, np.column_stack(columns)


def modes(results):
    series = results.series("modes")
    return ["mode", "period [s]", "frequency [Hz]"], np.column_stack([np.arange(1, results.steps + 1), series.values])


def everything(results, folder, since=0.0):
    """Writes all tables. since: s, start of statistics and ranges. Returns the paths of the files; input files are
    never overwritten."""
    lines, series_of = (file_names(names) for names in ([line.name for line in results.lines], results.series_names + results.points))
    if results.modes:
        files = [("modes", lambda: modes(results))]
        files += [(f"shape_{lines[line.name]}", lambda line=line: shapes(results, line)) for line in results.lines]
    else:
        files = [("lines", lambda: tables.of_lines(results)), ("ends", lambda: tables.at_ends(results)),
                 ("extremes", lambda: tables.extremes(results)), ("statistics", lambda: tables.statistics_of(results, since)),
                 ("clashes", lambda: tables.clashes(results))]
        files += [(("history_" if name in results.histories else "") + series_of[name], lambda name=name: series(results, name))
                  for name in results.series_names + results.points]
        files += [(f"range_{lines[line.name]}", lambda line=line: ranges(results, line, since)) for line in results.lines]
    places = [place_for(folder / f"{name}.csv", [results]) for name, _ in files]
    folder.mkdir(parents=True, exist_ok=True)
    done = []
    for path, (name, table) in zip(places, files):
        head, rows = table()
        if len(rows) > 0 or name in ("lines", "ends"):
            done.append(write(path, head, rows))
    return done
