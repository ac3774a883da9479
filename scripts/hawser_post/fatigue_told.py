"""hawser fatigue: the damage of sea states along a line, as a sentence and as CSV."""
import numpy as np

from . import export, fatigue, report
from .arguments import place_for
from .given import refuse_since, results_of
from .results import Refusal, dictionary
from .sections import at_nodes, sections_of, types_of

LARGEST_AREA = 1.0  # m²


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


def size_of(results, line, options, curve, name):
    """The breaking load [N] or the area [m²] that a curve is about, of the option, or by node as the case has it: NaN where the line
    is of another kind. None: the curve is about something else."""
    if curve.of != {"breaking_load": "tension", "area": "area"}[name]:
        return None
    if getattr(options, name):
        return np.full(len(line.arc), getattr(options, name))
    used, values = dictionary(results.as_read.get("line_types")), []
    for section, keys in zip(sections_of(results, line.name), types_of(results, line)):
        chain, rope = (keys.get("library", "").startswith(kind) for kind in ("chain", "wire"))
        of_kind = chain if "chain" in options.curve else rope
        if name == "breaking_load":
            size = used.get(section["type"], {}).get("breaking_load", 0.0) if of_kind or "library" not in keys else 0.0
        else:  # nominal, of both bars of a link, of the circle around a rope (DNV-OS-E301)
            size = (2 if chain else 1) * np.pi / 4 * keys["diameter"] ** 2 if of_kind else 0.0
        values.append(size or np.nan)
    nodes = at_nodes(results, line)
    if nodes.size == 0 or np.all(np.isnan(values)):
        raise Refusal(f"the curve {options.curve} needs --{name.replace('_', '-')}, above 0: the line types of '{line.name}' do not say it")
    return np.nanmin(np.array(values)[nodes], axis=0)


def make(options):
    curve = fatigue.CURVES[options.curve]
    needs = {"tension": ["breaking_load"], "area": ["area"], "pipe": ["outer_diameter", "wall"]}[curve.of]
    given = [name for name in ("breaking_load", "area", "outer_diameter", "wall") if getattr(options, name) is not None]
    for name in given:
        if name not in needs:
            raise Refusal(f"the curve {options.curve} takes no --{name.replace('_', '-')}, but "
                          + " and ".join(f"--{need.replace('_', '-')}" for need in needs))
    for name in needs if given else []:  # else those of the case
        if not (getattr(options, name) or 0) > 0:
            raise Refusal(f"the curve {options.curve} needs --{name.replace('_', '-')}, above 0")
    if options.area and options.area > LARGEST_AREA:
        raise Refusal(f"--area {options.area:g} is in m²: no chain or rope has as much steel")
    if given and curve.of == "pipe" and options.wall > options.outer_diameter / 2:
        raise Refusal("--wall is more than half of --outer-diameter")
    if not options.factor > 0:
        raise Refusal(f"--factor {options.factor:g} is not above 0")
    states = sea_states(options.results, options.changes)
    line = states[0][0].line(options.line) if options.line else report.by_tension(states[0][0])[0]
    first = states[0][0].path
    path = place_for(options.output or first.with_name(f"{first.stem}-fatigue.csv"), [of for of, _ in states], (".csv",), "a table")
    total, since = 0, options.since or 0.0
    for results, share in states:
        own = results.line(line.name)
        refuse_since(results, options.since)
        if len(own.arc) != len(line.arc):
            raise Refusal(f"{results.path}: line '{line.name}' has other nodes than in {states[0][0].path}")
        breaking_load, area = (size_of(results, own, options, curve, name) for name in ("breaking_load", "area"))
        largest = results.field("effective_tension", own)
        if breaking_load is not None and np.any(largest > breaking_load):
            print(f"warning: {results.path}: tensions up to {largest.max() / 1e3:.4g} kN are above the breaking load of "
                  f"{np.nanmin(breaking_load) / 1e3:.4g} kN: is that in N?")
        total = total + share * fatigue.YEAR * fatigue.along(
            results, own, curve, since, breaking_load, area, options.outer_diameter, options.wall, options.factor)
        if (outputs := fatigue.outputs_a_period(results, own, since)) < 10:
            print(f"warning: {results.path} has {outputs:.2g} outputs in a mean period of the tension: cycles are cut short; "
                  "set output.every to a tenth of it or less")
    total = total.max(axis=1)
    if np.isnan(total).all():
        raise Refusal(f"{first}: line '{line.name}' has nowhere what the curve {options.curve} is about")
    worst = int(np.nanargmax(total))
    print(f"{line.name}, {curve.source}, {options.curve}: largest damage {total[worst]:.4g} a year at arc length "
          f"{line.arc[worst]:.6g} m" + (f", life {1 / total[worst]:.4g} years" if total[worst] > 0 else ""))
    export.write(path, ["arc_length [m]", "damage [1/year]"], [(s, v) for s, v in zip(line.arc, total) if not np.isnan(v)])
    print(f"damage along the line: {path}")
