"""Strain, stress and the checks of codes of a pipe, by part: on its supports, in its sagbend and on the seabed."""
import numpy as np

from . import laying, pipe_codes, stations, stress
from .results import Refusal, pascals
from .sections import part as part_of_case
from .sections import types_of

PARTS = ("overbend", "sagbend", "seabed")
BUCKLING, STRESS, STRAIN = "local buckling, DNV-ST-F101 [-]", "von Mises stress [Pa]", "bending strain [%]"


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


def is_uneven(results):
    """Whether the seabed is measured: a grid or a mesh."""
    seabed = part_of_case(results, "environment").get("seabed")
    return isinstance(seabed, dict) and bool({"grid", "mesh"} & set(seabed))


def conditions_of(results, given):
    """gamma_C by part, of which `given` has some."""
    usual = dict.fromkeys(PARTS, 1.0)
    if is_uneven(results):
        usual["seabed"] = pipe_codes.UNEVEN_SEABED
    return {**usual, **(given or {})}


def refuse_in_motion(results):
    """Functional loads are those at rest, which only the first output of a run with statics has."""
    statics = results.keys.get("statics")
    skipped = statics is False or isinstance(statics, dict) and statics.get("enabled") is False
    if skipped or results.time[0] > 0:
        why = "the case has no statics" if skipped else f"the first is at t = {results.time[0]:g} s, after a restart"
        raise Refusal(f"{results.path}: no output is at rest ({why}), from which the functional loads of DNV-ST-F101 would be: "
                      "give --static RESULTS, a run of the same lines whose first output is")


def one_size(values):
    """Of a line all whose pipe has one wall."""
    found = np.unique(np.round(values[~np.isnan(values)], 9))
    if len(found) != 1:
        raise Refusal("the checks are for a line whose pipe has one diameter and one wall thickness")
    return float(found[0])


def moments(results, line):
    return np.stack([results.field(f"bending_moment_{k}", line) for k in (2, 3)], axis=-1)


class Checked:
    """A pipe's checks, each outputs x nodes; NaN where the line is no pipe. `static` holds results whose first output is at
    rest, where these have none; `conditions` gamma_C by part where it is not the usual."""

    def __init__(self, results, line, grade, steel, conditions=None, static=None):
        refuse_in_motion(static or results)
        if static:
            same = next((other for other in static.lines if other.name == line.name), None)
            if same is None or not np.array_equal(same.arc, line.arc):
                raise Refusal(f"{static.path}: has no line '{line.name}' with the nodes of that in {results.path}")
        self.results, self.line = results, line
        self.rest = Checked(static, same, grade, steel, conditions) if static else self
        sides = stress.walls_along(results, line)
        wall = sides[0][0] if not np.isnan(sides[0][0].outer).all() else sides[1][0]
        self.outer, self.wall = one_size(wall.outer), one_size((wall.outer - wall.inner) / 2)
        self.steel, self.grade, self.slender = steel, grade, round(self.outer / self.wall, 6)
        self.conditions = conditions_of(results, conditions)
        self.yields = any(isinstance(t, dict) and "plasticity" in t for t in types_of(results, line))
        self.find_parts(results, line)
        self.moments, self.tension = moments(results, line), results.field("effective_tension", line)
        outside, inside = sides[0][2], sides[0][3]
        strain = results.field("curvature", line) * self.outer / 2
        self.values = {"bending moment [N m]": results.field("bending_moment", line), STRAIN: 100 * strain,
                       STRESS: stress.along(results, line), BUCKLING: self.local_buckling(sides),
                       "bending and pressure, API RP 1111 [-]":
                           pipe_codes.api_bending_and_pressure(steel, self.outer, self.wall, strain, outside, inside),
                       "tension and pressure, API RP 1111 [-]":
                           pipe_codes.api_tension_and_pressure(steel, self.outer, self.wall, self.tension, outside, inside)}
        for name in self.values:
            self.values[name] = np.where(np.isnan(wall.outer), np.nan, self.values[name])

    def find_parts(self, results, line):
        """Which part of the line each node is in, at each output: the overbend ends where the line is steepest."""
        self.left = laying.departure(results, line)
        self.forwards = laying.from_end_a(results, line, self.left)
        self.down = laying.touchdown(results, line, self.forwards)
        bends = laying.inflection(results, line, self.left, self.down)
        down = self.down[0] if self.down else np.full(results.outputs, np.nan)
        way, bends, down = (x if self.forwards else line.length - x for x in (line.arc, bends, down))
        self.part = ((way > np.nan_to_num(bends, nan=-np.inf)[:, None]).astype(int) +
                     (way > np.nan_to_num(down, nan=np.inf)[:, None]))

    def local_buckling(self, sides):
        """Unity check: the larger of combinations a and b. Functional loads are those at rest, environmental what others
        differ by; moments by components."""
        condition = np.array([self.conditions[name] for name in PARTS])[self.part][:, :, None]
        worst, self.pulled = 0.0, 0.0  # the largest tension over S_p
        axial, _ = pipe_codes.plastic(self.steel, self.outer, self.wall)
        for combination in pipe_codes.COMBINATIONS.values():
            moment, tension = (pipe_codes.design_load(combination, still, now - still, condition) for now, still in (
                (self.moments, self.rest.moments[0]), (self.tension[:, :, None], self.rest.tension[0, :, None])))
            self.pulled = max(self.pulled, float(np.nanmax(tension)) / axial)
            for wall, _, outside, inside in sides:
                check = pipe_codes.local_buckling(self.steel, self.outer, self.wall, moment, tension, outside, inside)
                worst = np.fmax(worst, np.where(np.isnan(wall.outer), np.nan, check))
        return worst

    def told(self):
        """What the checks are by, in sentences."""
        parts = ", ".join(f"{name} {value:g}" for name, value in self.conditions.items())
        why = "; uneven seabed" if is_uneven(self.results) and self.conditions["seabed"] == pipe_codes.UNEVEN_SEABED else ""
        fed = (" Loads of what was in the stock at rest count as environmental altogether, which is on the safe side."
               if stations.end_of(self.results, self.line) else "")
        return [f"{self.outer * 1e3:.4g} mm x {self.wall * 1e3:.4g} mm, {self.grade}, {self.steel.fabrication}, ovality "
                f"{100 * self.steel.ovality:g} %.",
                f"DNV-ST-F101: safety class {self.steel.safety_class}, alpha_U {self.steel.material_factor:g}, gamma_C of "
                f"functional loads: {parts} (--condition-factor{why}).{fed}"]

    def criteria(self, part, keep):
        """Rows (check, value at rest, largest, its output and node) of the simplified criteria for laying."""
        k, rows = PARTS.index(part), []

        def row(name, quantity, limit, still, moving):
            most, *place = largest(self.values[quantity][keep], self.part[keep] == k) if moving else (np.nan, None, None)
            rest = largest(self.rest.values[quantity][:1], self.rest.part[:1] == k)[0] if still else np.nan
            rows.append((name, rest / limit, most / limit, *place))
        if part == "overbend" and self.grade in pipe_codes.OVERBEND_STRAIN:
            still, moving = pipe_codes.OVERBEND_STRAIN[self.grade]
            row("overbend strain at rest, DNV simplified I", STRAIN, 100 * still, True, False)
            row("overbend strain in motion, DNV simplified II", STRAIN, 100 * moving, False, True)
        if part == "sagbend":
            row("sagbend stress, DNV simplified", STRESS, pipe_codes.SAGBEND_STRESS * self.steel.yields, True, True)
        return rows


def largest(values, where):
    """The largest of outputs x nodes, with its output and node; NaN where there is none."""
    masked = np.where(where, values, -np.inf)
    masked[np.isnan(masked)] = -np.inf
    place = np.unravel_index(np.argmax(masked), masked.shape)
    return (float(masked[place]) if np.isfinite(masked[place]) else np.nan, *place)


def doubts(checked):
    """What the formulas are not for, a sentence each."""
    low, high = pipe_codes.SLENDER
    out, slender = [], f"D/t is {checked.slender:.3g}"
    if checked.slender > high:
        out.append(f"{slender}: DNV-ST-F101's formulas for combined loads hold to {high}; choose a thicker wall")
    if checked.slender < low:
        out.append(f"{slender}: DNV-ST-F101's formulas for combined loads are for {low} to {high}; so thick a wall is outside "
                   "of what they were fitted to")
    if checked.slender > pipe_codes.API_MOST_SLENDER:
        out.append(f"{slender}: API RP 1111's formula for bending with pressure holds to {pipe_codes.API_MOST_SLENDER}")
    if checked.pulled > pipe_codes.MOST_PULLED:
        out.append(f"the design tension is {checked.pulled:.2g} of that at yield: DNV-ST-F101's formulas for combined loads hold "
                   f"to {pipe_codes.MOST_PULLED:g}")
    return out + stress_doubts(checked)


def stress_doubts(checked):
    """Where the von Mises stress, which is that of an elastic section, is none of the pipe's."""
    most = np.nanmax(checked.values[STRESS])
    if checked.yields:
        return ["the pipe has 'plasticity': its von Mises stress is that of an elastic section with the same moment, and knows "
                "nothing of what earlier bends left; judge it by strain where it has yielded"]
    if most > checked.steel.smys:
        return [f"the von Mises stress is {most / 1e6:.4g} MPa, above the yield stress of {checked.steel.smys / 1e6:g} MPa, but "
                "the pipe is elastic: moments there are too large and strains too small; give it 'plasticity'"]
    return []
