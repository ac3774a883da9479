"""Breaking loads and areas that fatigue curves refer to: of the line types of the case and of the library of chains and
ropes, at the nodes of a line."""
import re
from functools import cache
from pathlib import Path

import numpy as np
import yaml

from .results import Refusal, metres, quantity
from .sections import lengths, types_of

FORCES = {"N": 1.0, "kN": 1e3, "MN": 1e6, "GN": 1e9, "tf": 9806.65}
AREAS = {"m2": 1.0, "m²": 1.0, "m^2": 1.0, "mm2": 1e-6, "mm²": 1e-6, "mm^2": 1e-6, "cm2": 1e-4, "cm²": 1e-4, "cm^2": 1e-4}
STRONGEST = 1e8  # N: a chain of 220 mm of grade R5 breaks at 41 MN
LARGEST, SMALLEST = 1.0, 1e-6  # m²: both bars of a chain of 0.8 m; a wire of 1 mm


def option(text, units, name):
    """A number with or without its unit, in SI: '5.9e6', '5866 kN', '0.011', '11084 mm2'."""
    found = re.fullmatch(r"\s*(\d*\.?\d+(?:[eE][-+]?\d+)?|\d+\.)\s*([A-Za-z][A-Za-z0-9²^]*)?\s*", text)
    value = float(found.group(1)) * units.get(found.group(2) or next(iter(units)), np.nan) if found else np.nan
    if not value > 0:
        raise Refusal(f"{name} {text}: is no number above 0 with one of the units {', '.join(units)} or none")
    return value


def breaking_load(text):
    value = option(text, FORCES, "--breaking-load")
    if value > STRONGEST:
        raise Refusal(f"--breaking-load {text}: {value / 1e6:g} MN is more than any line bears; bare numbers are in N")
    return value


def area(text):
    value = option(text, AREAS, "--area")
    if not SMALLEST <= value <= LARGEST:
        hint = f"; in mm² it is --area {text.strip()}mm2" if SMALLEST <= 1e-6 * value <= LARGEST else ""
        raise Refusal(f"--area {text}: {value:g} m² is the area of no chain or rope{hint}")
    return value


@cache
def library():
    here = Path(__file__).resolve().parents[2]
    for path in (here / "line-types.yaml", here / "data" / "line-types.yaml"):
        if path.is_file():
            return yaml.safe_load(path.read_text(encoding="utf-8"))
    return {}


def orq(diameter):
    """N, breaking load of oil rig quality chain of this bar diameter [m], API Spec 2F: 21.1 d² (44 - 0.08 d), d in mm."""
    d = 1000 * diameter
    return 21.1 * d**2 * (44 - 0.08 * d)


def of_library(values):
    """Its entry, name and nominal diameter [m] of a line type that is taken from the library; None: it is not."""
    name = values.get("library") if isinstance(values, dict) else None
    diameter = metres(values.get("diameter"), np.nan) if name else np.nan
    return (library()[name], name, diameter) if name in library() and diameter > 0 else None


def is_chain(values):
    found = of_library(values)
    return found is not None and found[1].startswith("chain")


def reference_load(values, chain):
    """N, that a tension range is divided by: of chain that of ORQ chain of the same size whatever its grade (API RP 2SK
    for R3 to R4S), of ropes their own. NaN: not known, or a type of the other kind."""
    found = of_library(values)
    if chain:
        return orq(found[2]) if is_chain(values) else np.nan
    if is_chain(values) or not isinstance(values, dict):
        return np.nan
    if "breaking_load" in values:
        return quantity(values["breaking_load"], FORCES, np.nan)
    if found is None:
        return np.nan
    powers = found[0].get("breaking_load") or {}
    return sum(float(powers.get(key, 0)) * found[2]**k for key, k in (("d", 1), ("d2", 2), ("d3", 3))) or np.nan


def nominal_area(values, chain):
    """m², by DNV-OS-E301: both bars of a chain, the circle about a rope. NaN: not known, or a type of the other kind."""
    found = of_library(values)
    if found is None or is_chain(values) != chain:
        return np.nan
    return (2 if chain else 1) * np.pi / 4 * found[2]**2


def along(results, line, of_type):
    """of_type(values of a line type) at the nodes of a line; where two types meet the smaller one."""
    sizes = lengths(results, line)
    if len(sizes) == 0 or np.isnan(sizes).any():
        return np.full(len(line.arc), np.nan)
    ends, values = np.cumsum(sizes), np.array([of_type(t) for t in types_of(results, line)], float)
    close = 1e-9 * max(ends[-1], 1.0)
    sides = [values[np.clip(np.searchsorted(ends, line.arc + shift), 0, len(ends) - 1)] for shift in (-close, close)]
    return np.fmin(*sides)
