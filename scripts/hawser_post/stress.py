"""Von Mises stress of pipes from wall tension, bending, torsion and internal and external pressure, after Lamé."""
from dataclasses import dataclass

import numpy as np

from .results import Refusal, dictionary
from .sections import at_nodes, part, types_of

THICKEST = 5.0  # m
GRAVITY, SEAWATER = 9.80665, 1025.0  # m/s², kg/m³, defaults of the case


@dataclass
class Wall:
    """Section of a pipe: numbers, or arrays with one value per node, NaN where the line is no pipe."""
    outer: np.ndarray  # m, diameter
    inner: np.ndarray

    @property
    def area(self):
        return np.pi / 4 * (self.outer**2 - self.inner**2)

    @property
    def inertia(self):  # second moment of area, m^4
        return np.pi / 64 * (self.outer**4 - self.inner**4)


def von_mises(wall, wall_tension, moment, torsion, outside, inside):
    """Largest stress [Pa] of the inner and outer fibre on both sides of the bending plane. Forces in N, moments in N
    m, pressures in Pa. Hoop and radial stress are Lamé's (Timoshenko and Goodier 1970, Theory of Elasticity, article
    28); shear stress, which is zero at the extreme fibres, is excluded."""
    outer, inner = wall.outer / 2, wall.inner / 2
    ring = outer**2 - inner**2
    largest = 0.0
    for r in (inner, outer):
        uniform = (inside * inner**2 - outside * outer**2) / ring
        ringed = (inside - outside) * inner**2 * outer**2 / (r**2 * ring)
        hoop, radial, shear = uniform + ringed, uniform - ringed, torsion * r / (2 * wall.inertia)
        for side in (1, -1):
            axial = wall_tension / wall.area + side * moment * r / wall.inertia
            squares = (axial - hoop) ** 2 + (hoop - radial) ** 2 + (radial - axial) ** 2
            largest = np.maximum(largest, np.sqrt(squares / 2 + 3 * shear**2))
    return largest


def of_type(values):
    """Outer and inner diameter of the wall, and bore, of a line type of the case, m; NaN: not given."""
    pipe, contents = dictionary(values.get("pipe")), dictionary(values.get("contents"))
    outer = pipe.get("outer_diameter", values.get("outer_diameter", np.nan))
    inner = contents.get("inner_diameter", outer - 2 * pipe.get("wall_thickness", np.nan))
    bore = inner if contents else np.nan
    return outer, inner if 0 <= inner < outer else np.nan, bore


def types_along(results, line):
    """`of_type` at the nodes of a line towards end A and towards end B: 2 x 3 x nodes."""
    sections = at_nodes(results, line)
    if sections.size == 0:
        return np.full((2, 3, len(line.arc)), np.nan)
    sizes = np.array([of_type(t) for t in types_of(results, line)])
    return np.array([sizes[side].T for side in sections])


def is_pipe(results, line):
    """True if a part of the line is a pipe with a wall."""
    return results.has("bending_moment") and any("pipe" in t for t in types_of(results, line))


def outside_pressure(results, line):
    """Hydrostatic pressure [Pa] of the still water, outputs x nodes."""
    environment = part(results, "environment")
    position = results.field("position", line)
    if "water" not in environment:
        return np.zeros(position.shape[:2])
    water = environment["water"]
    density, level = water.get("density", SEAWATER), water.get("surface", 0.0)
    return density * environment.get("gravity", GRAVITY) * np.maximum(level - position[:, :, 2], 0)


def walls_along(results, line, outer=None, thickness=None):
    """Wall [m] as given or from the case, towards end A and end B of each node, with its axial force [N] and the
    external and internal pressures [Pa], outputs x nodes; NaN where the line is no pipe. The internal pressure is
    that of the results, whose wall tension is effective tension + p_i A_i - p_e A_e of the wall below all coatings
    (docs/theory/water.md); coatings transmit the external pressure and carry no tension."""
    if (outer is None) != (thickness is None) or outer is not None and not (outer > 0 and 0 < thickness <= outer / 2):
        raise Refusal("the stress of a pipe needs --outer-diameter and --wall, above 0, the wall at most half of the diameter")
    if outer is not None and outer > THICKEST:
        raise Refusal(f"--outer-diameter {outer:g} is too large for a pipe; the unit is m")
    effective, outside = results.field("effective_tension", line), outside_pressure(results, line)
    sides = []
    for own_outer, own_inner, bore in types_along(results, line):
        wall = Wall(np.where(np.isnan(own_inner), np.nan, own_outer), own_inner) if outer is None else Wall(outer, outer - 2 * thickness)
        inside = np.zeros(effective.shape)
        if results.has("wall_tension"):
            by_contents = results.field("wall_tension", line) - effective + outside * np.pi / 4 * own_outer**2
            inside = np.where(np.isnan(bore), 0.0, by_contents / (np.pi / 4 * bore**2))  # no contents
        sides.append((wall, effective + np.pi / 4 * (inside * wall.inner**2 - outside * wall.outer**2), outside, inside))
    if all(np.isnan(tension).all() for _, tension, _, _ in sides):
        raise Refusal(f"{results.path}: the case does not give the pipe wall of line '{line.name}': give --outer-diameter and --wall")
    return sides


def along(results, line, outer=None, thickness=None):
    """Von Mises stress [Pa], outputs x nodes; NaN where the line is no pipe. The wall is as given [m], else that of
    the case."""
    if not results.has("bending_moment"):
        raise Refusal(f"{results.path}: there is no bending moment, as all lines are cables")
    moment, torsion = (results.field(f"{name}_moment", line) for name in ("bending", "torsion"))
    largest = np.full(moment.shape, np.nan)
    for wall, tension, outside, inside in walls_along(results, line, outer, thickness):
        largest = np.fmax(largest, von_mises(wall, tension, moment, torsion, outside, inside))
    if np.isnan(largest).all():
        raise Refusal(f"{results.path}: the stress of line '{line.name}' is unknown everywhere, since its tension or its moments are not numbers")
    return largest


def description(results, line, largest, since=0.0):
    """Sentence with the largest of these stresses, its time and place."""
    keep = np.flatnonzero(results.since(since))
    output, node = np.unravel_index(np.nanargmax(largest[keep]), largest[keep].shape)
    return (f"largest von Mises stress of {line.name} at the outputs: {largest[keep][output, node] / 1e6:.4g} MPa at arc length "
            f"{line.arc[node]:.6g} m, t = {results.time[keep][output]:.6g} s")
