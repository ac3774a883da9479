"""Differences of two results as tables: their inputs and their outcomes."""
import numpy as np

from . import charts, tables
from .inputs import rows_of
from .results import dictionary

MOST_ROWS = 80


def inputs(a, b):
    """Keys of the cases whose values differ."""
    one, other = (dict(rows_of(results.given)) for results in (a, b))
    keys = list(dict.fromkeys([*one, *other]))
    rows = [[key, one.get(key, "(not given)"), other.get(key, "(not given)")] for key in keys if one.get(key) != other.get(key)]
    return ["key", "A", "B"], rows


def changed(a, b):
    """Absolute difference, and percentage of A, empty if A is 0."""
    return b - a, (b - a) / abs(a) * 100 if a else float("nan")


def row(words, unit, a, b):
    shown, factor = charts.shown(unit)
    difference, share = changed(a / factor, b / factor)
    name = f"{words} [{shown}]" if shown not in ("", "1") else words
    return [name, a / factor, b / factor, difference, "" if np.isnan(share) else f"{share:+.2f}"]


HEAD = ["quantity", "A", "B", "B - A", "%"]


def extremes(a, b):
    """Extremes that both summaries have."""
    other = {(quantity, line): value for quantity, line, value, *_ in b.summary()}
    rows = [[line, *row(quantity, unit, value, other[quantity, line])] for quantity, line, value, unit, *_ in a.summary()
            if (quantity, line) in other]
    return ["line", *HEAD], rows


def ends(a, b, output, when):
    """Tension at the ends of the lines of both, at one output."""
    rows = []
    if not (a.has("effective_tension") and b.has("effective_tension")):
        return ["line", *HEAD], rows
    for line in common(a, b):
        one, other = (results.field("effective_tension", results.line(line), output) for results in (a, b))
        for end, k in (("A", 0), ("B", -1)):
            rows.append([line, *row(f"tension at end {end}, {when}", "N", float(one[k]), float(other[k]))])
    return ["line", *HEAD], rows


def histories(a, b):
    """Least, mean and largest value of the columns of histories of both."""
    rows = []
    for name in common_histories(a, b):
        one, other = a.series(name), b.series(name)
        for column in (c for c in one.columns if c in other.columns and not c.startswith(("velocity", "acceleration"))):
            x, y = one.column(column), other.column(column)
            if not np.isfinite(x).any() or not np.isfinite(y).any():
                continue
            scale = max(np.nanmax(np.abs(x)), np.nanmax(np.abs(y)))
            for words, of in (("least", np.nanmin), ("mean", np.nanmean), ("largest", np.nanmax)):
                if abs(of(y) - of(x)) > 1e-6 * scale:
                    rows.append([name, *row(f"{words} {charts.words(column)}", one.unit(column), float(of(x)), float(of(y)))])
    return ["history", *HEAD], rows


def places(a, b):
    """Distances of nodes with the same arc lengths, at the first and last output of both."""
    rows = []
    for name in common(a, b):
        one, other = a.line(name), b.line(name)
        cells = [name]
        for output in (0, -1):
            x, y = a.field("position", one, output), b.field("position", other, output)
            at = np.stack([np.interp(one.arc, other.arc, y[:, k]) for k in range(3)], axis=1)
            apart = np.linalg.norm(at - x, axis=1)
            cells += [float(apart.max()), float(one.arc[int(apart.argmax())])]
        rows.append(cells)
    return ["line", "largest distance at the first output [m]", "at arc length [m]", "at the last output [m]", "at arc length [m] "], rows


def common(a, b):
    """Names of lines in both."""
    there = {line.name for line in b.lines}
    return [line.name for line in a.lines if line.name in there]


def common_histories(a, b):
    there = {b.series_name(key) for key in b.histories}
    return [a.series_name(key) for key in a.histories if a.series_name(key) in there and not tables.is_support(a.series_at(key))]


def only(a, b):
    """Sentences about lines that only one of them has."""
    one, other = ({line.name for line in results.lines} for results in (a, b))
    found = []
    for name, lines in (("A", one - other), ("B", other - one)):
        if lines:
            found.append(f"Only {name} has the line{'s' if len(lines) > 1 else ''} {', '.join(sorted(lines)[:10])}.")
    if dictionary(a.keys).get("title") != dictionary(b.keys).get("title"):
        found.append("The cases have different titles.")
    return found
