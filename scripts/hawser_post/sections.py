"""The sections of a line as it was run: the length of each, with the one that a target has found, and its line type."""
import numpy as np

from .results import dictionary


def part(results, key):
    """A map of the case, empty where there is none."""
    return dictionary(results.keys.get(key))


def sections_of(results, name):
    """The sections of a line as the case has them; none of what is beyond a cut, which the case does not name."""
    return dictionary(part(results, "lines").get(name)).get("sections") or []


def length_key(results, name):
    """Which section has the length that the line's target has found, from 0; None without a target."""
    target, sections = dictionary(part(results, "lines").get(name)).get("target"), sections_of(results, name)
    if not target or not sections:
        return None
    if "section" in target:
        return int(target["section"]) - 1
    return int(np.argmax([s["length"] for s in sections]))


def lengths(results, line):
    """m, unstretched, of each section."""
    found = [float(s["length"]) for s in sections_of(results, line.name)]
    k = length_key(results, line.name)
    if k is not None and k < len(found):  # the others are as given
        found[k] = line.length - sum(found[:k] + found[k + 1:])
    return np.array(found)


def at_nodes(results, line):
    """The number of the section, from 0, at each node of a line on the side of end A and on that of end B: 2 x nodes; nothing where
    the case does not name the line."""
    ends = np.cumsum(lengths(results, line))
    if len(ends) == 0:
        return np.empty((2, 0), int)
    close = 1e-9 * max(ends[-1], 1.0)
    return np.array([np.clip(np.searchsorted(ends, line.arc + shift), 0, len(ends) - 1) for shift in (-close, close)])


def types_of(results, line):
    """The line type of each section as the case has it."""
    types = part(results, "line_types")
    return [dictionary(types.get(s["type"])) for s in sections_of(results, line.name)]
