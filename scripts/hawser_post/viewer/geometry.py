"""Geometry of the three-dimensional model in addition to the results: radii of lines, extent, heights of the bed."""
import re

import numpy as np

from ..results import dictionary
from ..sections import at_nodes, sections_of

BED_PLACES = 81  # points along a side of a non-planar bed
BEYOND = 0.15  # margin of sea and bed beyond the model, as a fraction of its size
USUAL_RADIUS = 0.1  # m, for unknown line types


def radius_of_type(results, name):
    """Radius of a line type, m; None if the results do not have it."""
    found = dictionary(dictionary(results.as_read.get("line_types")).get(name)).get("outer_diameter")
    return found / 2 if isinstance(found, (int, float)) and found > 0 else None


def radii(results):
    """Radius of each node, m; the larger of both sides."""
    out = np.full(len(results.file["nodes/arc_length"]), USUAL_RADIUS)
    for line in results.lines:
        sections = sections_of(results, line.name)
        if sections:
            of = np.array([radius_of_type(results, s.get("type")) or USUAL_RADIUS for s in sections])
            out[line.nodes] = of[at_nodes(results, line)].max(axis=0)
            continue
        # Parts beyond a cut have the type of the corresponding end of the uncut line.
        sections = sections_of(results, re.sub(r" part \d+$", "", line.name))
        if sections:
            out[line.nodes] = radius_of_type(results, sections[-1].get("type")) or USUAL_RADIUS
    return out


def extent(results, rows, most=40):
    """Smallest and largest coordinates of the lines at up to `most` of these outputs, and of volumes and bodies near
    them; of all volumes and bodies if there are no lines."""
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    rows = list(rows)
    sample = {rows[int(k)] for k in np.linspace(0, len(rows) - 1, min(most, len(rows)))}
    for row in sample:
        x = results.file["fields/position"][row]
        x = x[np.isfinite(x).all(axis=-1)]
        if len(x):
            low, high = np.minimum(low, x.min(axis=0)), np.maximum(high, x.max(axis=0))
    lines = low, high
    near = 0.75 * (high - low).max() if np.all(np.isfinite(low)) else None
    others = [x for _, x, _ in results.volumes(0)] + [results.file["bodies/position"][row] for row in sample if results.bodies]
    for x in others:
        x = x[np.isfinite(x).all(axis=-1)]
        if len(x):
            first, last = x.min(axis=0), x.max(axis=0)
            if near is not None:
                first, last = np.maximum(first, lines[0] - near), np.minimum(last, lines[1] + near)
            low, high = np.minimum(low, first), np.maximum(high, last)
    if not np.all(np.isfinite(low)):
        low, high = np.full(3, -1.0), np.full(3, 1.0)
    return low, high


def border(low, high):
    """Smallest and largest x and y of sea and bed."""
    beyond = BEYOND * max(*(high - low), 1e-3)
    return low[:2] - beyond, high[:2] + beyond


def bed(sea, low, high):
    """Coordinates x and y and heights over them; None without a known bed."""
    if not sea.bed:
        return None
    count = 2 if sea.measured is None else BED_PLACES
    x, y = np.linspace(*border(low, high), count).T
    z = sea.seabed(*np.meshgrid(x, y))
    return (x, y, z) if np.isfinite(z).any() else None
