"""Range of a field along a line: over every step of the run if the results have `statistics`, else over the outputs."""
from dataclasses import dataclass

import numpy as np

from .sections import sections_of
from .statistics import mean_of


@dataclass
class Envelope:
    least: np.ndarray  # at each node
    least_time: np.ndarray  # s
    most: np.ndarray
    most_time: np.ndarray
    mean: np.ndarray
    every_step: bool


def only_one(values):
    """Envelope of a single output."""
    return Envelope(values, 0 * values, values, 0 * values, values, False)


def of_every_step(results, field, since):
    """True if the envelope of a field from `since` on is available over every step: the file has statistics from
    exactly this time."""
    if not results.ended:  # statistics are as old as the last checkpoint
        return False
    data = results.file.get(f"statistics/{field}")
    # Statistics of a vector are those of its components, not of its magnitude.
    return data is not None and data.ndim == 2 and since in (0.0, results.statistics_from)


def begin(results, since):
    """Default start of envelopes: that of the statistics, also for envelopes over outputs."""
    return results.statistics_from if since == 0.0 and results.ended and "statistics" in results.file else since


def envelope(results, line, field, since=0.0):
    """None with a single output."""
    if results.outputs < 2:
        return None
    since = begin(results, since)
    if of_every_step(results, field, since):
        least, least_time, most, most_time, mean, _ = results.statistics(field, line).T
        return Envelope(least, least_time, most, most_time, mean, True)
    keep = results.since(since)
    values, time = results.magnitude(field, line)[keep], results.time[keep]
    return Envelope(values.min(axis=0), time[values.argmin(axis=0)], values.max(axis=0), time[values.argmax(axis=0)],
                    mean_of(time, values), False)


NOISE = 1e-9  # relative size of rounding errors


def above_noise(results, line, fields, since=0.0):
    """Those of these fields that exceed rounding errors somewhere along a line: relative to the largest value of the
    unit, and for a moment also to tension times diameter, as the stress of bending is 8 M/(T D) times that of
    tension in a round bar."""
    sizes = {}
    for field in results.reported("graph", "table"):
        found = envelope(results, line, field, since)
        values = [results.magnitude(field, line, 0)] + ([found.least, found.most] if found else [])
        sizes[field] = max((float(np.nanmax(np.abs(v))) for v in values if not np.all(np.isnan(v))), default=0.0)
    scales = {}
    for field, size in sizes.items():
        scales[results.unit(field)] = max(size, scales.get(results.unit(field), 0.0))
    widths = [results.as_read.get("line_types", {}).get(s["type"], {}).get("outer_diameter", 0.0) for s in sections_of(results, line.name)]
    scales["N m"] = max(scales.get("N m", 0.0), sizes.get("effective_tension", 0.0) * max(widths, default=0.0))
    return [field for field in fields if field not in sizes or sizes[field] > NOISE * scales[results.unit(field)]]


def description(results, fields, since):
    """Sentence on the basis of the envelopes of these fields."""
    since = begin(results, since)
    every = [of_every_step(results, field, since) for field in fields]
    outputs = f"the {np.count_nonzero(results.since(since))} outputs from t = {since:g} s on, so a peak may lie between two of them"
    start = f" from t = {since:g} s on" if since > 0 else ""
    if all(every):
        return f"Over every step{start}."
    if any(every):
        others = ", ".join(results.label(field) for field, own in zip(fields, every) if not own)
        return f"Over every step{start}; {others}: over {outputs}."
    why = ("the results have no statistics of every step" if "statistics" not in results.file
           else "the run has not ended" if not results.ended else f"the statistics of every step begin at another time, t = {results.statistics_from:g} s")
    return f"Over {outputs} ({why})."
