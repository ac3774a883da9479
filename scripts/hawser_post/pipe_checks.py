"""Strain, stress and the checks of codes of a pipe, by part: on its supports, in its sagbend and on the seabed."""
import numpy as np

from . import laying, pipe_codes, stress
from .results import Refusal, pascals
from .sections import types_of

PARTS = ("overbend", "sagbend", "seabed")


def grade_of(results, line):
    """The grade of steel that the case gives the line's pipe; None."""
    found = {t["pipe"].get("grade") for t in types_of(results, line) if isinstance(t, dict) and isinstance(t.get("pipe"), dict)}
    return found.pop() if len(found) == 1 else None


def steel_of(results, line, grade, **judged):
    """Of a grade, with the stiffness of the case's material."""
    steel = pipe_codes.Steel(*pipe_codes.GRADES[grade], **judged)
    for t in types_of(results, line):
        material = t["pipe"].get("material") if isinstance(t, dict) and isinstance(t.get("pipe"), dict) else None
        if isinstance(material, dict):
            steel.modulus = pascals(material.get("E"), steel.modulus)
            steel.poisson = stress.number(material.get("poisson"), steel.poisson)
    return steel


def of_case(results, line):
    """The checks by the defaults; None where the case does not say of which steel the pipe is."""
    grade = grade_of(results, line)
    return None if grade not in pipe_codes.GRADES else Checked(results, line, grade, steel_of(results, line, grade))


def local_buckling(results, line, steel, sides):
    """Unity check, outputs x nodes: the larger of combinations a and b. Functional loads are those of the first output,
    environmental what later ones differ by, component by component of the moment."""
    components = np.stack([results.field(f"bending_moment_{k}", line) for k in (2, 3)], axis=-1)
    tension, worst = results.field("effective_tension", line), 0.0
    for functional, environmental in pipe_codes.COMBINATIONS.values():
        def design(x):
            return functional * steel.condition * x[0] + environmental * (x - x[0])
        moment = np.linalg.norm(design(components), axis=-1)
        for wall, _, outside, inside in sides:
            check = pipe_codes.local_buckling(steel, one_size(wall.outer), one_size((wall.outer - wall.inner) / 2), moment,
                                              design(tension), outside, inside)
            worst = np.fmax(worst, np.where(np.isnan(wall.outer), np.nan, check))
    return worst


def one_size(values):
    """Of a line all whose pipe has one wall."""
    found = np.unique(np.round(values[~np.isnan(values)], 9))
    if len(found) != 1:
        raise Refusal("the checks are for a line whose pipe has one diameter and one wall thickness")
    return float(found[0])


class Checked:
    """A pipe's checks, each outputs x nodes; NaN where the line is no pipe."""

    def __init__(self, results, line, grade, steel):
        sides = stress.walls_along(results, line)
        wall = sides[0][0] if not np.isnan(sides[0][0].outer).all() else sides[1][0]
        outer, thick = one_size(wall.outer), one_size((wall.outer - wall.inner) / 2)
        self.outer, self.wall, self.steel, self.grade = outer, thick, steel, grade
        is_pipe = ~np.isnan(wall.outer)
        moment, tension = results.field("bending_moment", line), results.field("effective_tension", line)
        outside, inside = sides[0][2], sides[0][3]
        strain = results.field("curvature", line) * outer / 2
        equivalent = stress.along(results, line)
        self.values = {"bending moment [N m]": moment, "bending strain [%]": 100 * strain,
                       "von Mises stress [Pa]": equivalent,
                       "local buckling, DNV-ST-F101 [-]": local_buckling(results, line, steel, sides),
                       "bending and pressure, API RP 1111 [-]":
                           pipe_codes.api_bending_and_pressure(steel, outer, thick, strain, outside, inside),
                       "tension and pressure, API RP 1111 [-]":
                           pipe_codes.api_tension_and_pressure(steel, outer, thick, tension, outside, inside)}
        for name in self.values:
            self.values[name] = np.where(is_pipe, self.values[name], np.nan)
        self.slender = outer / thick
        axial, _ = pipe_codes.plastic(steel, outer, thick)
        self.pulled = float(np.nanmax(np.abs(tension)) / axial)
        self.left = laying.departure(results, line)
        forwards = self.left.forwards if self.left else True
        self.down = laying.touchdown(results, line, forwards)
        # Which part of the line each node is in, at each output: the overbend ends where the line is steepest.
        bends = laying.inflection(results, line, self.left, self.down)
        down = self.down[0] if self.down else np.full(results.outputs, np.nan)
        way = line.arc if forwards else line.length - line.arc
        bends, down = (x if forwards else line.length - x for x in (bends, down))
        self.part = (way > bends[:, None]).astype(int) + (way > np.nan_to_num(down, nan=np.inf)[:, None])

    def told(self):
        return (f"{self.outer * 1e3:.4g} mm x {self.wall * 1e3:.4g} mm, {self.grade}, safety class {self.steel.safety_class}, "
                f"{self.steel.fabrication}, ovality {100 * self.steel.ovality:g} %.")

    def criteria(self, part, keep):
        """Rows (check, value, limit) of the simplified criteria for laying."""
        strain, equivalent = self.values["bending strain [%]"] / 100, self.values["von Mises stress [Pa]"]
        inside = self.part == PARTS.index(part)
        rows = []
        if part == "overbend" and self.grade in pipe_codes.OVERBEND_STRAIN:
            still, moving = pipe_codes.OVERBEND_STRAIN[self.grade]
            rows.append(("overbend strain, static, DNV simplified I", largest(strain[:1], inside[:1])[0] / still))
            rows.append(("overbend strain, in motion, DNV simplified II", largest(strain[keep], inside[keep])[0] / moving))
        if part == "sagbend":
            limit = pipe_codes.SAGBEND_STRESS * self.steel.yields
            rows.append(("sagbend stress, DNV simplified", largest(equivalent[keep], inside[keep])[0] / limit))
        return rows


def largest(values, where):
    """The largest of outputs x nodes, with its output and node."""
    masked = np.where(where, values, -np.inf)
    masked[np.isnan(masked)] = -np.inf
    place = np.unravel_index(np.argmax(masked), masked.shape)
    return (float(masked[place]) if np.isfinite(masked[place]) else np.nan, *place)


def checks(results, line, checked, since):
    """A table: part of the line, quantity, static value, largest, its time and arc length."""
    head = ["part", "quantity", "static", "largest", "at [s]", "at [m]"]
    keep = np.flatnonzero(results.since(since))
    rows = []
    for k, part in enumerate(PARTS):
        inside = checked.part == k
        for name, values in checked.values.items():
            most, output, node = largest(values[keep], inside[keep])
            if np.isnan(most):
                continue
            rows.append([part, name, largest(values[:1], inside[:1])[0], most, float(results.time[keep][output]),
                         float(line.arc[node])])
        for name, value in checked.criteria(part, keep):
            rows.append([part, name + " [-]", "", value, "", ""])
    return head, rows


def geometry(results, line, checked, since):
    """A table of what is watched while a pipe is laid: static value, least and largest over the outputs."""
    keep, rows = results.since(since), []

    def row(name, values, static=None, chosen=None):
        chosen = values[keep] if chosen is None else chosen
        if not np.isnan(chosen).all():
            rows.append([name, float(values[0]) if static is None else static, float(np.nanmin(chosen)), float(np.nanmax(chosen))])
    tension = results.field("effective_tension", line)
    forwards = checked.left.forwards if checked.left else True
    row("top tension [kN]", tension[:, 0 if forwards else -1] / 1e3)
    if checked.left:
        left = checked.left
        row("departure angle below the horizontal [deg]", left.angle)
        row("arc length of lift-off [m]", left.arc)
        row(f"clearance at the tip, {left.tip} [m]", left.tip_clearance,
            chosen=left.tip_clearance[results.step_time >= since])
    if checked.down is not None:
        arc, place = checked.down
        row("arc length of touchdown [m]", arc)
        top = results.field("position", line)[:, 0 if forwards else -1]
        row("layback, from the end to touchdown [m]", np.hypot(*(place - top)[:, :2].T))
        on_bed = [np.nan if np.isnan(s) else np.interp(s, line.arc, t) for s, t in zip(arc, tension)]
        row("tension at touchdown [kN]", np.array(on_bed) / 1e3)
    return ["quantity", "static", "least", "largest"], rows


def doubts(checked):
    out = []
    if checked.slender > pipe_codes.MOST_SLENDER:
        out.append(f"D/t is {checked.slender:.3g}: DNV-ST-F101's formulas for combined loads hold to {pipe_codes.MOST_SLENDER}; "
                   "choose a thicker wall")
    if checked.pulled > pipe_codes.MOST_PULLED:
        out.append(f"the tension is {checked.pulled:.2g} of that at yield: DNV-ST-F101's formulas for combined loads hold to "
                   f"{pipe_codes.MOST_PULLED:g}")
    return out


def for_reading(head, rows):
    """Moments in kN m and stresses in MPa, the unit in the name of the quantity."""
    out = []
    for row in rows:
        name, factor = row[1], 1.0
        for unit, shown, size in (("[N m]", "[kN m]", 1e3), ("[Pa]", "[MPa]", 1e6)):
            if name.endswith(unit):
                name, factor = name.replace(unit, shown), size
        out.append([row[0], name.replace(" [-]", "")] + [v / factor if isinstance(v, float) else v for v in row[2:4]] + row[4:])
    return head, out
