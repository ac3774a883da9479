"""Sections of a line as run: their lengths, including one found by a target, and their line types."""
import numpy as np

from .results import dictionary


def part(results, key):
    """A map of the case, or an empty one."""
    return dictionary(results.keys.get(key))


def sections_of(results, name):
    """Sections of a line in the case; empty for parts beyond a cut, which the case does not name."""
    return dictionary(part(results, "lines").get(name)).get("sections") or []


def length_key(results, name):
    """Index of the section whose length the line's target determines; None without a target."""
    target, sections = dictionary(part(results, "lines").get(name)).get("target"), sections_of(results, name)
    if not target or not sections:
        return None
    if "section" in target:
        return int(target["section"]) - 1
    return int(np.argmax([s["length"] for s in sections]))


def lengths(results, line):
    """Unstretched length of each section, m."""
    found = [float(s["length"]) for s in sections_of(results, line.name)]
    k = length_key(results, line.name)
    if k is not None and k < len(found):  # the others are as given
        found[k] = line.length - sum(found[:k] + found[k + 1:])
    return np.array(found)


def at_nodes(results, line):
    """Index of the section at each node of a line towards end A and towards end B: 2 x nodes; empty if the case does
    not name the line."""
    ends = np.cumsum(lengths(results, line))
    if len(ends) == 0:
        return np.empty((2, 0), int)
    close = 1e-9 * max(ends[-1], 1.0)
    return np.array([np.clip(np.searchsorted(ends, line.arc + shift), 0, len(ends) - 1) for shift in (-close, close)])


def types_of(results, line):
    """Line type of each section in the case."""
    types = part(results, "line_types")
    return [dictionary(types.get(s["type"])) for s in sections_of(results, line.name)]
