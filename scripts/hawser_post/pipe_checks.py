"""Strain, stress and code checks of a pipe by part: on its supports, in its sagbend and on the seabed."""
import numpy as np

from . import laying, pipe_codes, stations, stress
from .results import Refusal, dictionary
from .sections import part as part_of_case
from .sections import types_of

PARTS = ("overbend", "sagbend", "seabed")
BUCKLING, STRESS, STRAIN = "local buckling, DNV-ST-F101 [-]", "von Mises stress [Pa]", "bending strain [%]"


FIELDS = {BUCKLING: "dnv_local_buckling", "bending and pressure, API RP 1111 [-]": "api_bending_pressure",
          "tension and pressure, API RP 1111 [-]": "api_tension_pressure"}
UNEVEN_SEABED = 1.07


def judged_pipe(results, line):
    """Keys of the line's pipe with the defaults of the checks; None without a grade or with several."""
    found = [t["pipe"] for t in types_of(results, line) if "pipe" in t]
    if len({pipe.get("grade") for pipe in found}) != 1 or found[0].get("grade") not in pipe_codes.YIELD:
        return None
    usual = {"safety_class": "low", "fabrication": "UOE", "ovality": 0.015, "material_factor": 0.96, "condition_factor": {}}
    return {**usual, **found[0]}


def of_case(results, line):
    """Checks of a pipe; None if the case gives no steel grade or the program did not check the pipe."""
    pipe = judged_pipe(results, line)
    return None if pipe is None or not results.has("api_bending_pressure") else Checked(results, line, pipe)


def is_uneven(results):
    """True if the seabed is a grid or a mesh."""
    return bool({"grid", "mesh"} & set(dictionary(part_of_case(results, "environment").get("seabed"))))


def one_size(values):
    """The wall of a line with a single one."""
    found = np.unique(np.round(values[~np.isnan(values)], 9))
    if len(found) != 1:
        raise Refusal("the checks need a line whose pipe has one diameter and one wall thickness")
    return float(found[0])


class Checked:
    """Checks of a pipe at the outputs, each outputs x nodes; NaN where the line is no pipe. Code checks are fields
    of the results."""

    def __init__(self, results, line, pipe):
        self.results, self.line, self.pipe, self.grade = results, line, pipe, pipe["grade"]
        sides = stress.walls_along(results, line)
        wall = sides[0][0] if not np.isnan(sides[0][0].outer).all() else sides[1][0]
        self.outer, self.wall = one_size(wall.outer), one_size((wall.outer - wall.inner) / 2)
        self.yields_at = pipe_codes.YIELD[self.grade]
        self.yields = any("plasticity" in t for t in types_of(results, line))
        # Only a run that began with statics and has its first output has a state at rest.
        self.at_rest = results.has("dnv_local_buckling") and not results.time[0] > 0
        self.find_parts(results, line)
        self.tension = results.field("effective_tension", line)
        self.values = {"bending moment [N m]": results.field("bending_moment", line),
                       STRAIN: 50 * self.outer * results.field("curvature", line), STRESS: stress.along(results, line)}
        for name in self.values:
            self.values[name] = np.where(np.isnan(wall.outer), np.nan, self.values[name])
        self.values.update({name: results.field(field, line) for name, field in FIELDS.items() if results.has(field)})

    def find_parts(self, results, line):
        """Part of the line at each node and output: the overbend ends at the steepest point."""
        self.left = laying.departure(results, line)
        self.forwards = laying.from_end_a(results, line, self.left)
        self.down = laying.touchdown(results, line, self.forwards)
        bends = laying.inflection(results, line, self.left, self.down)
        down = self.down[0] if self.down else np.full(results.outputs, np.nan)
        way, bends, down = (x if self.forwards else line.length - x for x in (line.arc, bends, down))
        self.part = ((way > np.nan_to_num(bends, nan=-np.inf)[:, None]).astype(int) +
                     (way > np.nan_to_num(down, nan=np.inf)[:, None]))

    def description(self):
        """Sentences on the basis of the checks."""
        given = self.pipe["condition_factor"]
        uneven = is_uneven(self.results)
        usual = {"supports": 1.0, "span": 1.0, "seabed": UNEVEN_SEABED if uneven else 1.0}
        parts = ", ".join(f"{name} {given.get(name, value):g}" for name, value in usual.items())
        why = "; uneven seabed" if uneven and "seabed" not in given else ""
        fed = (" For pipe that was inside the feeder at rest all loads count as environmental, which is conservative."
               if stations.end_of(self.results, self.line) else "")
        return [f"{self.outer * 1e3:.4g} mm x {self.wall * 1e3:.4g} mm, {self.grade}, {self.pipe['fabrication']}, ovality "
                f"{100 * self.pipe['ovality']:g} %.",
                f"DNV-ST-F101: safety class {self.pipe['safety_class']}, alpha_U {self.pipe['material_factor']:g}, "
                f"gamma_C of functional loads: {parts}{why}.{fed}"]

    def static(self, quantity, part):
        """Largest value in a part at rest; NaN if no output is at rest."""
        return largest(self.values[quantity][:1], self.part[:1] == part)[0] if self.at_rest else np.nan

    def criteria(self, part, keep):
        """Rows (check, value at rest, largest, its output and node) of the simplified laying criteria."""
        k, rows = PARTS.index(part), []

        def row(name, quantity, limit, still, moving):
            most, *place = largest(self.values[quantity][keep], self.part[keep] == k) if moving else (np.nan, None, None)
            rest = self.static(quantity, k) if still else np.nan
            rows.append((name, rest / limit, most / limit, *place))
        if part == "overbend" and self.grade in pipe_codes.OVERBEND_STRAIN:
            still, moving = pipe_codes.OVERBEND_STRAIN[self.grade]
            row("overbend strain at rest, DNV simplified I", STRAIN, 100 * still, True, False)
            row("overbend strain in motion, DNV simplified II", STRAIN, 100 * moving, False, True)
        if part == "sagbend":
            row("sagbend stress, DNV simplified", STRESS, pipe_codes.SAGBEND_STRESS * self.pipe["material_factor"] *
                self.yields_at, True, True)
        return rows


def largest(values, where):
    """Largest value of outputs x nodes with its output and node; NaN if there is none."""
    masked = np.where(where, values, -np.inf)
    masked[np.isnan(masked)] = -np.inf
    place = np.unravel_index(np.argmax(masked), masked.shape)
    return (float(masked[place]) if np.isfinite(masked[place]) else np.nan, *place)


def warnings(checked):
    """Warnings if the von Mises stress, which assumes an elastic section, is not valid for the pipe."""
    most = np.nanmax(checked.values[STRESS])
    if checked.yields:
        return ["the pipe has 'plasticity': its von Mises stress is that of an elastic section with the same moment, and does "
                "not include residual stress of earlier bending; assess it by strain where it has yielded"]
    if most > checked.yields_at:
        return [f"the von Mises stress is {most / 1e6:.4g} MPa, above the yield stress of {checked.yields_at / 1e6:g} MPa, but "
                "the pipe is elastic: moments there are too large and strains too small; give it 'plasticity'"]
    return []
