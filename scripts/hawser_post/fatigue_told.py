"""hawser fatigue: the damage of sea states along a line, as a sentence and as CSV."""
from pathlib import Path

import numpy as np

from . import export, fatigue, report
from .given import refuse_since, results_of
from .results import Refusal


def sea_states(given, changes):
    """Results files and the share of the time of each: 'FILE=SHARE', or FILE for equal shares."""
    out = []
    for text in given:
        path, _, share = text.rpartition("=") if "=" in text else (text, "", "")
        try:
            out.append((results_of(path, changes), float(share) if share else 1 / len(given)))
        except ValueError:
            raise Refusal(f"'{text}': the share of the time after '=' is no number") from None
    if sum(share for _, share in out) > 1 + 1e-9 or min(share for _, share in out) < 0:
        raise Refusal("the shares of the sea states are more than all of the time, or below zero")
    return out


def make(options):
    curve = fatigue.CURVES[options.curve]
    needs = {"tension": ["breaking_load"], "area": ["area"], "pipe": ["outer_diameter", "wall"]}[curve.of]
    given = [name for name in ("breaking_load", "area", "outer_diameter", "wall") if getattr(options, name) is not None]
    for name in given:
        if name not in needs:
            raise Refusal(f"the curve {options.curve} takes no --{name.replace('_', '-')}, but "
                          + " and ".join(f"--{need.replace('_', '-')}" for need in needs))
    for name in needs if curve.of != "pipe" or given else []:  # those of a pipe may be in the case
        if not (getattr(options, name) or 0) > 0:
            raise Refusal(f"the curve {options.curve} needs --{name.replace('_', '-')}, above 0")
    if given and curve.of == "pipe" and options.wall > options.outer_diameter / 2:
        raise Refusal("--wall is more than half of --outer-diameter")
    if not options.factor > 0:
        raise Refusal(f"--factor {options.factor:g} is not above 0")
    states = sea_states(options.results, options.changes)
    line = states[0][0].line(options.line) if options.line else report.by_tension(states[0][0])[0]
    total, since = 0, options.since or 0.0
    for results, share in states:
        own = results.line(line.name)
        refuse_since(results, options.since)
        if len(own.arc) != len(line.arc):
            raise Refusal(f"{results.path}: line '{line.name}' has other nodes than in {states[0][0].path}")
        total = total + share * fatigue.YEAR * fatigue.along(
            results, own, curve, since, options.breaking_load, options.area, options.outer_diameter, options.wall,
            options.factor)
        if (outputs := fatigue.outputs_a_period(results, own, since)) < 10:
            print(f"warning: {results.path} has {outputs:.2g} outputs in a mean period of the tension: cycles are cut short; "
                  "set output.every to a tenth of it or less")
    total = total.max(axis=1)
    worst = int(np.nanargmax(total))
    print(f"{line.name}, {curve.source}, {options.curve}: largest damage {total[worst]:.4g} a year at arc length "
          f"{line.arc[worst]:.6g} m" + (f", life {1 / total[worst]:.4g} years" if total[worst] > 0 else ""))
    path = Path(options.output) if options.output else states[0][0].path.with_name(f"{states[0][0].path.stem}-fatigue.csv")
    export.write(path, ["arc_length [m]", "damage [1/year]"], [(s, v) for s, v in zip(line.arc, total) if not np.isnan(v)])
    print(f"damage along the line: {path}")
