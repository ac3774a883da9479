"""hawser fatigue: damage by sea states along a line, as a sentence and as CSV."""
import numpy as np

from . import export, fatigue, report, strength
from .arguments import place_for
from .given import refuse_since, results_of
from .results import Refusal


def sea_states(given, changes):
    """Results files and the fraction of time of each: 'FILE=SHARE', or FILE for equal fractions."""
    out = []
    for text in given:
        path, _, share = text.rpartition("=") if "=" in text else (text, "", "")
        try:
            out.append((results_of(path, changes), float(share) if share else 1 / len(given)))
        except ValueError:
            raise Refusal(f"'{text}': the fraction of the time after '=' is not a number") from None
    if sum(share for _, share in out) > 1 + 1e-9 or min(share for _, share in out) < 0:
        raise Refusal("the fractions of the time of the sea states are negative, or their sum exceeds 1")
    return out


def divisor(results, line, options, curve):
    """Divisor of the tension at the nodes of a line: breaking load [N] or area [m²], as given or from the line types
    of the case; NaN for line types of another kind. Also returns messages."""
    chain, by_load = options.curve.endswith("chain"), curve.of == "tension"
    name = "--breaking-load" if by_load else "--area"
    known = strength.along(results, line, lambda t, used: (strength.reference_load if by_load else strength.nominal_area)(t, used, chain))
    text = options.breaking_load if by_load else options.area
    if text is None:
        if np.isnan(known).all():
            what = "chain" if chain else "rope"
            raise Refusal(f"the curve {options.curve} needs {name}: line '{line.name}' has no {what} of the library"
                          + ("" if chain or not by_load else " and no breaking_load"))
        return known, []
    value = strength.breaking_load(text) if by_load else strength.area(text)
    notes = []
    if by_load and chain:
        notes = orq_words(value, known, curve)
    return np.full(len(line.arc), value), notes


def orq_words(given, known, curve):
    if np.isnan(known).all():
        return ["note: API RP 2SK divides the tension range of chain by the breaking load of ORQ chain of the same size, "
                "21.1 d² (44 - 0.08 d) N with d in mm, also for R3 to R4S: give that as --breaking-load"]
    least = np.nanmin(known)
    off = (given / least)**curve.m
    if abs(given / least - 1) < 0.02:
        return []
    return [f"warning: API RP 2SK divides by the breaking load of ORQ chain of the same size, {least / 1e3:.4g} kN here, also "
            f"for R3 to R4S: by {given / 1e3:.4g} kN the damage is {max(off, 1 / off):.2g} times too {'small' if off > 1 else 'large'}"]


def check_load(results, line, divided, curve):
    """Refuses a breaking load or area that is implausible for the tensions of the run."""
    largest = results.field("effective_tension", line).max(axis=0)
    known = ~np.isnan(divided)
    if curve.of == "tension" and (share := (largest / divided)[known].max()) > 2:
        raise Refusal(f"{results.path}: the largest tension of line '{line.name}' is {share:.3g} times the breaking load of "
                      f"{np.nanmin(divided):.4g} N: bare numbers are in N")
    if curve.of == "area" and not 0.01 < (stress := (1e-6 * largest / divided)[known].max()) < 5000:
        raise Refusal(f"{results.path}: the largest stress of line '{line.name}' over an area of {np.nanmin(divided):.4g} m² "
                      f"is {stress:.3g} MPa: bare numbers are in m²")


def make(options):
    curve = fatigue.CURVES[options.curve]
    needs = {"tension": ["breaking_load"], "area": ["area"], "pipe": ["outer_diameter", "wall"]}[curve.of]
    given = [name for name in ("breaking_load", "area", "outer_diameter", "wall") if getattr(options, name) is not None]
    for name in given:
        if name not in needs:
            raise Refusal(f"the curve {options.curve} does not use --{name.replace('_', '-')}, but "
                          + " and ".join(f"--{need.replace('_', '-')}" for need in needs))
    for name in needs if curve.of == "pipe" and given else []:
        if not (getattr(options, name) or 0) > 0:
            raise Refusal(f"the curve {options.curve} needs --{name.replace('_', '-')}, above 0")
    if given and curve.of == "pipe" and options.wall > options.outer_diameter / 2:
        raise Refusal("--wall is more than half of --outer-diameter")
    if not options.factor > 0:
        raise Refusal(f"--factor {options.factor:g} is not above 0")
    states = sea_states(options.results, options.changes)
    line = states[0][0].line(options.line) if options.line else report.by_tension(states[0][0])[0]
    first = states[0][0].path
    path = place_for(options.output or first.with_name(f"{first.stem}-fatigue.csv"), [of for of, _ in states], (".csv",), "a table")
    total, since, messages = 0, options.since or 0.0, []
    for results, share in states:
        own = results.line(line.name)
        refuse_since(results, options.since)
        if len(own.arc) != len(line.arc):
            raise Refusal(f"{results.path}: line '{line.name}' does not have the same nodes as in {states[0][0].path}")
        load = area = None
        if curve.of != "pipe":
            divided, messages = divisor(results, own, options, curve)
            check_load(results, own, divided, curve)
            load, area = (divided, None) if curve.of == "tension" else (None, divided)
        total = total + share * fatigue.YEAR * fatigue.along(
            results, own, curve, since, load, area, options.outer_diameter, options.wall, options.factor)
        if (outputs := fatigue.outputs_a_period(results, own, since)) < 10:
            print(f"warning: {results.path} has {outputs:.2g} outputs in a mean period of the tension: cycles are truncated; "
                  "set output.every to a tenth of it or less")
    for message in messages:
        print(message)
    total = total.max(axis=1)
    if np.isnan(total).all():
        raise Refusal(f"{first}: line '{line.name}' has no part to which the curve {options.curve} applies")
    worst = int(np.nanargmax(total))
    print(f"{line.name}, {curve.source}, {options.curve}: largest damage {total[worst]:.4g} a year at arc length "
          f"{line.arc[worst]:.6g} m" + (f", life {1 / total[worst]:.4g} years" if total[worst] > 0 else ""))
    export.write(path, ["arc_length [m]", "damage [1/year]"], [(s, v) for s, v in zip(line.arc, total) if not np.isnan(v)])
    print(f"damage along the line: {path}")
