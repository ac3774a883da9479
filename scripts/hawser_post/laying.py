"""A line that leaves its supports for the seabed: lift-off point and angle, clearance at the last support, and
touchdown."""
from dataclasses import dataclass

import numpy as np

from . import stations, tables
from .results import dictionary
from .sections import part


@dataclass
class Departure:
    """Departure at each output."""
    forwards: bool  # the line leaves its supports towards end B
    support: list  # name of the last support that carries the line, "" where none does
    arc: np.ndarray  # m, of lift-off; NaN
    angle: np.ndarray  # deg below the horizontal at lift-off
    tip: str  # name of the last support
    tip_clearance: np.ndarray  # m, at every step


def of_line(results, line):
    """Series of the supports of a line and their arc lengths, in order along the line."""
    found = []
    for name in results.histories:
        series = results.series_at(name)
        if tables.is_support(series) and "arc_length" in series.columns and support_line(results, series.name) == line.name:
            arc = series.column("arc_length")
            if not np.isnan(arc).all():
                found.append((float(np.nanmedian(arc)), series))
    return [series for _, series in sorted(found, key=lambda f: f[0])]


def support_line(results, name):
    """Line of a support: that of its group in the case, or the only one."""
    groups = part(results, "supports")
    named = dictionary(groups.get(name.rsplit(" ", 1)[0], groups.get(name))).get("line")
    return named if named is not None else results.lines[0].name


def step_of(results):
    """Step nearest to each output."""
    return np.array([np.argmin(np.abs(results.step_time - t)) for t in results.time])


def departure(results, line):
    """Departure of a line; None without supports."""
    boxes = of_line(results, line)
    if not boxes:
        return None
    arcs = np.array([b.column("arc_length") for b in boxes])
    forces = np.array([np.linalg.norm([b.column(f"force_{k}") for k in "xyz"], axis=0) for b in boxes])
    # Away from the feeder, else towards the farther end.
    fed = stations.end_of(results, line)
    forwards = fed == "end_a" if fed else bool(np.nanmean(arcs[:, 0]) < line.length / 2)
    if not forwards:
        boxes, arcs, forces = boxes[::-1], arcs[::-1], forces[::-1]
    steps = step_of(results)
    names, arc, angle = [], np.full(results.outputs, np.nan), np.full(results.outputs, np.nan)
    positions = results.field("position", line)
    for k, step in enumerate(steps):
        loaded = np.flatnonzero(forces[:, step] > 0)
        names.append(boxes[loaded[-1]].name if len(loaded) else "")
        if not len(loaded):
            continue
        arc[k] = arcs[loaded[-1], step]
        angle[k] = slope(line, positions[k], arc[k], forwards)
    return Departure(forwards, names, arc, angle, boxes[-1].name, boxes[-1].column("height"))


def slope(line, x, arc, forwards):
    """Slope [deg below the horizontal] of a line with nodes x at an arc length, towards the seabed."""
    if np.isnan(arc):
        return np.nan
    node = int(np.clip(np.searchsorted(line.arc, arc), 1, len(line.arc) - 1))
    along = x[node] - x[node - 1] if forwards else x[node - 1] - x[node]
    return float(np.degrees(np.arctan2(-along[2], np.hypot(*along[:2]))))


def touchdown(results, line, forwards=True):
    """Arc length and position [m] at each output of the first touchdown point after the supports; None if the
    results have none."""
    name = f"{line.name} touchdown"
    if results.steps == 0 or not results.has_series(name):
        return None
    series, steps, end = results.series(name), step_of(results), "end_a" if forwards else "end_b"
    place = np.array([series.column(f"{end}_position_{k}")[steps] for k in "xyz"]).T
    return series.column(f"{end}_arc_length")[steps], place


def from_end_a(results, line, left):
    """True if the path to the seabed is from end A to end B: as the line leaves its supports, else from its higher
    end."""
    if left is not None:
        return left.forwards
    height = results.field("position", line, 0)[:, 2]
    return bool(height[0] >= height[-1])


def inflection(results, line, left, down):
    """Arc length [m] at each output of the steepest point between lift-off and touchdown, the inflection between
    overbend and sagbend; if no support carries the line, between its end on the barge and touchdown. NaN without
    supports, since there is no overbend."""
    if left is None:
        return np.full(results.outputs, np.nan)
    forwards = left.forwards
    start = 0.0 if forwards else line.length
    x, middle = results.field("position", line), (line.arc[1:] + line.arc[:-1]) / 2
    along = np.diff(x, axis=1) * (1 if forwards else -1)
    dive = np.arctan2(-along[:, :, 2], np.hypot(along[:, :, 0], along[:, :, 1]))
    end = np.full(results.outputs, np.nan) if down is None else down[0]
    out = np.full(results.outputs, start)
    for k in range(results.outputs):
        first = start if np.isnan(left.arc[k]) else left.arc[k]
        last = end[k] if not np.isnan(end[k]) else (line.length if forwards else 0.0)
        between = np.flatnonzero((middle > min(first, last)) & (middle < max(first, last)))
        out[k] = middle[between[np.argmax(dive[k, between])]] if len(between) else first
    return out
