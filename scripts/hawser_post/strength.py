"""Breaking loads and areas for fatigue curves at the nodes of a line, from the line types of the case and the
library of chains and ropes."""
import re

import numpy as np

from .results import Refusal, dictionary
from .sections import at_nodes, sections_of, types_of

FORCES = {"N": 1.0, "kN": 1e3, "MN": 1e6, "GN": 1e9, "tf": 9806.65}
AREAS = {"m2": 1.0, "m²": 1.0, "m^2": 1.0, "mm2": 1e-6, "mm²": 1e-6, "mm^2": 1e-6, "cm2": 1e-4, "cm²": 1e-4, "cm^2": 1e-4}
STRONGEST = 1e8  # N; a chain of 220 mm of grade R5 has 41 MN
LARGEST, SMALLEST = 1.0, 1e-6  # m²; both bars of a chain of 0.8 m; a wire of 1 mm


def option(text, units, name):
    """A number with or without unit, in SI: '5.9e6', '5866 kN', '0.011', '11084 mm2'."""
    found = re.fullmatch(r"\s*(\d*\.?\d+(?:[eE][-+]?\d+)?|\d+\.)\s*([A-Za-z][A-Za-z0-9²^]*)?\s*", text)
    value = float(found.group(1)) * units.get(found.group(2) or next(iter(units)), np.nan) if found else np.nan
    if not value > 0:
        raise Refusal(f"{name} {text}: is not a number above 0, without unit or with one of the units {', '.join(units)}")
    return value


def breaking_load(text):
    value = option(text, FORCES, "--breaking-load")
    if value > STRONGEST:
        raise Refusal(f"--breaking-load {text}: {value / 1e6:g} MN exceeds the breaking load of any line; bare numbers are in N")
    return value


def area(text):
    value = option(text, AREAS, "--area")
    if not SMALLEST <= value <= LARGEST:
        hint = f"; in mm² it is --area {text.strip()}mm2" if SMALLEST <= 1e-6 * value <= LARGEST else ""
        raise Refusal(f"--area {text}: {value:g} m² is not the area of a chain or rope{hint}")
    return value


def orq(diameter):
    """Breaking load [N] of oil rig quality chain with this bar diameter [m], API Spec 2F: 21.1 d² (44 - 0.08 d), d
    in mm."""
    d = 1000 * diameter
    return 21.1 * d**2 * (44 - 0.08 * d)


def library_diameter(values, chain):
    """Nominal diameter [m] of a library line type that is chain (else wire rope); NaN for other types."""
    kind = "chain" if chain else "wire"
    return float(values["diameter"]) if str(values.get("library", "")).startswith(kind) else np.nan


def reference_load(values, used, chain):
    """Reference load [N] of tension ranges: for chain that of ORQ chain of the same size for any grade (API RP 2SK
    for R3 to R4S), for ropes their own. NaN: unknown, or of the other kind. values: line type in the case; used: its
    properties as computed with."""
    if chain:
        return orq(library_diameter(values, True))
    if str(values.get("library", "")).startswith("chain"):
        return np.nan
    return used.get("breaking_load") or values.get("breaking_load") or np.nan


def nominal_area(values, used, chain):
    """Nominal area [m²] by DNV-OS-E301: both bars of a chain, circumscribed circle of a rope. NaN: unknown, or of
    the other kind."""
    return (2 if chain else 1) * np.pi / 4 * library_diameter(values, chain) ** 2


def along(results, line, of_type):
    """of_type(line type in the case, its properties as computed with) at the nodes of a line; the smaller value
    between two types."""
    used = dictionary(results.as_read.get("line_types"))
    pairs = zip(types_of(results, line), sections_of(results, line.name))
    values = np.array([of_type(t, dictionary(used.get(s["type"]))) for t, s in pairs], float)
    nodes = at_nodes(results, line)
    if nodes.size == 0:
        return np.full(len(line.arc), np.nan)
    return np.fmin(*values[nodes])
