"""The sections of a line as it was run: the length of each, with the one that a target has found, and its line type."""
import numpy as np

from .results import metres


def part(results, key):
    """A map of the case file, empty where it is none."""
    found = results.keys.get(key)
    return found if isinstance(found, dict) else {}


def sections_of(results, name):
    """The sections of a line as the case file has them."""
    line = part(results, "lines").get(name)
    found = line.get("sections") if isinstance(line, dict) else None
    return [s for s in found if isinstance(s, dict)] if isinstance(found, list) else []


def sought(results, name):
    """Which section has the length that the line's target has found, from 0; None without a target."""
    line, sections = part(results, "lines").get(name), sections_of(results, name)
    target = line.get("target") if isinstance(line, dict) else None
    if not isinstance(target, dict) or not sections:
        return None
    if target.get("section") is not None:
        return int(target["section"]) - 1
    return int(np.argmax([metres(s.get("length"), 0.0) for s in sections]))


def lengths(results, line):
    """m, unstretched, of each section; NaN where the case file has no number."""
    found = [metres(s.get("length"), np.nan) for s in sections_of(results, line.name)]
    k = sought(results, line.name)
    if k is not None and k < len(found):  # the others are as given
        found[k] = line.length - sum(found[:k] + found[k + 1:])
    return np.array(found)


def types_of(results, line):
    """The line type of each section as the case file has it."""
    types = part(results, "line_types")
    return [types.get(s.get("type")) for s in sections_of(results, line.name)]
