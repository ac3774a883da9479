"""Tables of reports and CSV files: lines at rest, extremes, statistics, clashes, energy. In SI units; `for_reading`
converts them to those of a page."""
import re

import numpy as np

from .charts import shown
from .envelopes import above_noise, begin, envelope, of_every_step
from .results import dictionary
from .statistics import statistics

VERTICAL = np.array([0.0, 0.0, 1.0])


def for_reading(head, rows):
    """A table with forces in kN, moments in kN m and so on. The unit is in the heading of a column, as [N], or in
    the column `unit` of a row, for the columns around it without units."""
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
    """Rows of each end at an output: line, end, position, force of the line on its support, its angles."""
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
                        azimuth(outwards)]
            rows.append(row + [""] * (len(head) - len(row)))
    return head, rows


def azimuth(direction):
    """Azimuth of a unit vector, deg in (-180, 180]; rounding errors count as 0."""
    x, y, _ = np.round(direction, 12) + 0.0  # avoids -0, which would turn 180 into -180
    return float(np.degrees(np.arctan2(y, x)))


def laid(results, line, output):
    """Length [m] of the line on the seabed at the first (0) or last (-1) output: between its touchdown points if
    available, else between the nodes that press on the seabed; "" if unknown."""
    name = f"{line.name} touchdown"
    if results.steps > 0 and results.has_series(name):
        series = results.series(name)
        if "laid_length" in series.columns:
            return float(series.column("laid_length")[output])
    if not results.has("seabed_force"):
        return ""
    down = np.linalg.norm(results.field("seabed_force", line, output), axis=1) > 0
    change = np.flatnonzero(np.diff(np.concatenate([[0], down.astype(int), [0]])))
    return float(sum(line.arc[b - 1] - line.arc[a] for a, b in zip(change[::2], change[1::2])))


def of_lines(results):
    head = ["line", "length [m]", "nodes", "distance of the ends [m]", "on the seabed at the start [m]", "at the end [m]"]
    rows = []
    for line in results.lines:
        x = results.field("position", line, 0)
        rows.append([line.name, line.length, len(line.arc), float(np.linalg.norm(x[-1] - x[0])),
                     laid(results, line, 0), laid(results, line, -1)])
    return head, rows


def extremes(results):
    head = ["quantity", "line", "value", "unit", "time [s]", "arc length [m]"]
    return head, [list(row) for row in results.summary()]


def of_fields(results, fields, since=0.0, lines=None):
    """Least and largest value of each field along each line (or `lines`), with time and place."""
    head = ["line", "quantity", "unit", "minimum", "at [s]", "at [m]", "maximum", "at [s]", "at [m]"]
    rows = []
    for line in results.lines if lines is None else lines:
        for field in above_noise(results, line, fields, since):
            found = envelope(results, line, field, since) if results.has(field) else None
            if found is None or not np.any(np.abs([found.least, found.most]) > 0):  # NaN: unknown
                continue
            low, high = int(np.nanargmin(found.least)), int(np.nanargmax(found.most))
            rows.append([line.name, results.label(field), results.unit(field), found.least[low], found.least_time[low],
                         line.arc[low], found.most[high], found.most_time[high], line.arc[high]])
    return head, rows


def utilisation(results, since=0.0):
    """Largest value of each utilisation of each line."""
    head, rows = of_fields(results, results.utilisations, since)
    return [*head[:2], "largest", *head[7:]], [[*row[:2], *row[6:]] for row in rows]


def clearances(results):
    """Smallest value of each clearance of `output.clearances` over every step."""
    head, rows = ["clearance", "smallest [m]", "at [s]", "on the line at [m]"], []
    for name in results.histories:
        series = results.series_at(name)
        if series.columns[:1] != ["clearance"]:
            continue
        x = series.column("clearance")
        if np.all(np.isnan(x)):
            rows.append([series.name, "never close", "", ""])
            continue
        k = int(np.nanargmin(x))
        rows.append([series.name, float(x[k]), float(results.step_time[k]), float(series.column("arc_length")[k])])
    return head, rows


def is_support(series):
    return series.columns[:3] == ["force_x", "force_y", "force_z"] and "height" in series.columns


def supports(results):
    """Reactions of the boxes of `supports`: at the start, and least and largest over every step."""
    head = ["support", "at the start [N]", "least [N]", "at [s]", "largest [N]", "at [s]", "largest on one roller [N]",
            "that is", "highest above it [m]"]
    rows = []
    for name in results.histories:
        series = results.series_at(name)
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


def place_of(results, name):
    """Line and node of a point history; None for other histories or points between two nodes."""
    points, written = (dictionary(keys.get("output")).get("histories") or [] for keys in (results.keys, results.given))
    for point, as_written in zip(points, written):
        if "line" not in point or point.get("name", f"{point['line']}@{as_written['at']}") != name:
            continue
        for line in results.lines:
            if line.name == point["line"]:
                at = {"end_a": 0.0, "end_b": line.length}.get(point["at"], point["at"])
                node = int(np.argmin(np.abs(line.arc - at)))
                return (line, node) if abs(line.arc[node] - at) < 1e-6 * line.length else None
    return None


def statistics_of(results, since=0.0):
    """One row per column of each nonzero history, over the steps from `since` on, by default from the start of the
    results' own statistics. Those are preferred if they are at the same place and start at the same time, because
    histories may have fewer rows than steps."""
    head = ["history", "quantity", "unit", "minimum", "at [s]", "maximum", "at [s]", "mean", "standard deviation",
            "mean period [s]", "from [s]"]
    rows = []
    time, since = results.step_time, begin(results, since)
    keep = time >= since
    if np.count_nonzero(keep) < 2:
        return head, rows
    for name in results.histories:
        series = results.series_at(name)
        place = place_of(results, series.name)
        for column in series.columns:
            x = series.column(column)[keep]
            if not np.all(np.isfinite(x)) or not np.any(x):
                continue
            s = statistics(time[keep], x)
            numbers = [s.least, s.least_time, s.most, s.most_time, s.mean, s.deviation]
            if place is not None and of_every_step(results, column, since):
                numbers = [float(v) for v in results.statistics(column, place[0])[place[1]]]
            rows.append([series.name, results.label(column), series.unit(column), *numbers,
                         "" if np.isnan(s.period) else s.period, float(since)])
    return head, rows


def clashes(results):
    names, units, rows = results.clashes()
    return [f"{n.replace('_', ' ')} [{u}]" if u else n.replace("_", " ") for n, u in zip(names, units)], rows


def energy(results):
    """Energy audit at the end of the run."""
    if "energy" not in results.series_names or results.steps == 0:
        return [], []
    series = results.series("energy")
    return ["energy", "at the end [J]"], [[n.replace("_", " "), float(series.values[-1, i])] for i, n in enumerate(series.columns)]
