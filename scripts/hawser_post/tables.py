"""Tables of a report and of the CSV files: what lines are like at rest, extremes, statistics, clashes, energy. In SI
units; `for_reading` brings them to those of a page."""
import re

import numpy as np

from .charts import shown
from .envelopes import envelope
from .statistics import statistics

UTILISATIONS = ("utilisation", "bend_utilisation")
VERTICAL = np.array([0.0, 0.0, 1.0])


def for_reading(head, rows):
    """A table with forces in kN, moments in kN m and so on. The unit of a column stands in its head, as [N]; that of a row
    in the column `unit`, for the columns before and behind it that have no unit of their own."""
    factors, names = [], []
    for title in head:
        unit = re.search(r"\[(.+)\]$", title)
        name, factor = shown(unit.group(1)) if unit else ("", None)
        factors.append(factor)
        names.append(title[: unit.start()] + f"[{name}]" if unit else title)
    column = head.index("unit") if "unit" in head else None
    out = []
    for row in rows:
        name, own = shown(row[column]) if column is not None else ("", 1.0)
        numbers = [v / (own if f is None else f) if isinstance(v, (float, np.floating)) else v for v, f in zip(row, factors)]
        if column is not None:
            numbers[column] = "" if name == "1" else name
        out.append(numbers)
    return names, out


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


def of_fields(results, fields, since=0.0, lines=None):
    """The least and the largest value of each field along each line (or these), with time and place."""
    head = ["line", "quantity", "unit", "minimum", "at [s]", "at [m]", "maximum", "at [s]", "at [m]"]
    rows = []
    for line in results.lines if lines is None else lines:
        for field in fields:
            found = envelope(results, line, field, since) if results.has(field) else None
            if found is None or not np.any(np.abs([found.least, found.most]) > 0):  # NaN: not known
                continue
            low, high = int(np.nanargmin(found.least)), int(np.nanargmax(found.most))
            rows.append([line.name, field.replace("_", " "), results.unit(field), found.least[low], found.least_time[low],
                         line.arc[low], found.most[high], found.most_time[high], line.arc[high]])
    return head, rows


def utilisation(results, since=0.0):
    """The largest utilisation of each line that has one: of its breaking load, and of its least bend radius."""
    head, rows = of_fields(results, UTILISATIONS, since)
    return [*head[:2], "largest", *head[7:]], [[*row[:2], *row[6:]] for row in rows]


def clearances(results):
    """The smallest of each clearance of `output.clearances`, over every step."""
    head, rows = ["clearance", "smallest [m]", "at [s]", "on the line at [m]"], []
    for name in results.histories:
        series = results.series(name)
        if series.columns[:1] != ["clearance"]:
            continue
        x = series.column("clearance")
        if np.all(np.isnan(x)):
            rows.append([series.name, "never near", "", ""])
            continue
        k = int(np.nanargmin(x))
        rows.append([series.name, float(x[k]), float(results.step_time[k]), float(series.column("arc_length")[k])])
    return head, rows


def is_support(series):
    return series.columns[:3] == ["force_x", "force_y", "force_z"] and "height" in series.columns


def supports(results):
    """The reactions of the boxes of `supports`: at the start, and the least and the largest over every step."""
    head = ["support", "at the start [N]", "least [N]", "at [s]", "largest [N]", "at [s]", "largest of one roller [N]",
            "that is", "highest above it [m]"]
    rows = []
    for name in results.histories:
        series = results.series(name)
        if not is_support(series):
            continue
        def size(stem):
            return np.linalg.norm([series.column(f"{stem}force_{k}") for k in "xyz"], axis=0)
        force, height = size(""), series.column("height")
        rollers = {c[:-8]: size(c[:-7]).max() for c in series.columns if c.endswith("_force_x")}
        most = max(rollers, key=rollers.get)
        low, high = int(np.argmin(force)), int(np.argmax(force))
        rows.append([series.name, float(force[0]), float(force[low]), float(results.step_time[low]), float(force[high]),
                     float(results.step_time[high]), float(rollers[most]), most if rollers[most] > 0 else "none",
                     "" if np.all(np.isnan(height)) else float(np.nanmax(height))])
    def order(row):
        return [int(part) if part.isdigit() else part for part in row[0].rsplit(" ", 1)]
    return head, sorted(rows, key=order)


def line_types(results):
    """The line types as the case file has them: a row for each key."""
    types = results.keys.get("line_types")
    types = {k: v for k, v in types.items() if isinstance(v, dict)} if isinstance(types, dict) else {}
    keys = list(dict.fromkeys(key for values in types.values() for key in values))
    def text(value):
        if isinstance(value, bool):
            return str(value).lower()
        return "" if value is None else "table" if isinstance(value, (dict, list)) else str(value)
    return ["key", *map(str, types)], [[str(key), *(text(values.get(key)) for values in types.values())] for key in keys]


def sections(results):
    """The lines as the case file has them: sections and ends."""
    head, rows = ["line", "section", "length", "type", "end A", "end B"], []
    lines = results.keys.get("lines")
    for name, line in (lines.items() if isinstance(lines, dict) else ()):
        if not isinstance(line, dict):
            continue
        ends = [end_words(line.get(key)) for key in ("end_a", "end_b")]
        for k, section in enumerate(line.get("sections") or [], 1):
            if isinstance(section, dict):
                rows.append([str(name) if k == 1 else "", str(k), length_words(section.get("length", "")),
                             str(section.get("type", "")), *(ends if k == 1 else ["", ""])])
    return head, rows


def length_words(value):
    return f"{value} m" if isinstance(value, (int, float)) else str(value)


def end_words(end):
    """An end of a line in a few words."""
    if not isinstance(end, dict):
        return str(end or "")
    clamped = ", clamped" if end.get("clamped") else ""
    for key, before in (("anchor", "anchored at "), ("body", "on "), ("joint", "joint ")):
        if key in end:
            at = f" at {end['at']}" if "at" in end else ""
            return f"{before}{end[key]}{at}{clamped}"
    return ", ".join(map(str, end))


def echo(results, part):
    """A part of the case file, such as its environment: a row for each key, with its path."""
    rows = []

    def walk(value, path):
        if isinstance(value, dict) and value:
            for key, inner in value.items():
                walk(inner, [*path, str(key)])
        else:
            text = "" if value is None or value == {} else str(value).lower() if isinstance(value, bool) else str(value).replace("'", "")
            rows.append([".".join(path), text if len(text) <= 80 else text[:77] + "..."])

    walk(results.keys.get(part) or {}, [])
    return [part, "value"], [row for row in rows if row[0]]


def statistics_of(results, since=0.0):
    """A row for each column of each history that is not zero throughout, over the steps from `since` on."""
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
            if not np.all(np.isfinite(x)) or not np.any(x):
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
    return ["energy", "at the end [J]"], [[n.replace("_", " "), float(series.values[-1, i])] for i, n in enumerate(series.columns)]
