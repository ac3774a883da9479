"""A lay of a case, and its equilibrium at other depths, tensions and stinger radii."""
from pathlib import Path

import numpy as np

from . import pipe_checks, pipe_tables, tables
from .arguments import run_case
from .lay_search import Lay
from .pipe_report import pipe_of
from .results import Refusal, Results, dictionary
from .sections import lengths, part, sections_of

MOST_STRAINED = 0.004  # bending strain of the catenary of the first trial


def bends_of(results, line):
    """Curved lengths of the paths of a line's supports: radius [m] by key. A path of boxes on beams is adjusted to
    these."""
    found = {}
    for group, keys in part(results, "supports").items():
        if "path" not in keys or keys.get("on") or keys.get("line", line) != line:
            continue
        for k, segment in enumerate(keys["path"].get("segments", [])):
            if "radius" in segment:
                found[f"supports.{group}.path.segments[{k}].radius"] = segment["radius"]
    return found


class Rig:
    """A lay of a case, and the dependence of its line on depth and tension."""

    def __init__(self, case, changes, folder):
        self.case, self.changes, self.folder = Path(case), list(changes), Path(folder)
        results = self.run([])
        if results is None:
            raise Refusal(f"{case}: {self.description()} has no equilibrium from which to begin: run it with 'hawser run' for the reason")
        try:
            self.name = pipe_of(results, None).name
        except Refusal as why:  # concerning results in the temporary folder
            raise Refusal(str(why).replace(str(results.path), str(case))) from None
        line = results.line(self.name)
        if pipe_checks.judged_pipe(results, line) is None:
            raise Refusal(f"{case}: the case does not give the steel of '{line.name}': add 'grade' to the pipe of its line type")
        checked = pipe_checks.of_case(results, line)
        if checked.left is None or checked.down is None:
            raise Refusal(f"{case}: a pipe lay needs 'supports' that the pipe leaves, and a seabed on which it touches down")
        self.forwards = checked.left.forwards
        far = "end_b" if self.forwards else "end_a"
        self.far = f"lines.{self.name}.{far}.anchor"
        keys = part(results, "lines")[self.name]
        anchor = dictionary(keys.get(far)).get("anchor")
        seabed = dictionary(part(results, "environment").get("seabed"))
        if anchor is None or "depth" not in seabed:
            raise Refusal(f"{case}: lays at several depths need a far end with 'anchor' and a seabed with 'depth'")
        if seabed.get("slope_deg", 0) != 0:
            raise Refusal(f"{case}: lays at several depths need a level seabed: 'slope_deg' of this one is "
                          f"{seabed['slope_deg']}; remove it by --set environment.seabed.slope_deg=0")
        self.anchor, self.depth = np.array(anchor, float), seabed["depth"]
        x, (arc, place) = results.field("position", line, 0), checked.down
        self.top = x[0 if self.forwards else -1]
        lift = np.array([np.interp(checked.left.arc[0], line.arc, x[:, k]) for k in range(3)])
        self.rise = lift[2] - place[0][2]  # m, height of the free span, and its length
        self.span = abs(arc[0] - checked.left.arc[0])
        self.drop = self.top[2] - place[0][2]
        tension = np.interp(arc[0], line.arc, results.field("effective_tension", line, 0))
        # Weight [N/m] of the catenary with this height and length and this tension at touchdown.
        self.weight = tension * 2 * self.rise / (self.span**2 - self.rise**2)
        self.reach = self.width(tension, self.rise)
        self.outer, self.warnings = checked.outer, pipe_checks.warnings(checked)
        found = lengths(results, line)  # a length found by a target is kept, without the target
        self.section = int(np.searchsorted(np.cumsum(found), (arc[0] + checked.left.arc[0]) / 2))
        self.length, self.elements = float(found[self.section]), sections_of(results, self.name)[self.section].get("elements")
        self.kept = [f"lines.{self.name}.target=null"] if keys.get("target") else []
        self.bends = bends_of(results, self.name)

    def description(self):
        return "the case" + (f" with {', '.join(self.changes)}" if self.changes else "")

    def radius(self):
        """Radius of the supports, m; NaN without a curved length, or with several."""
        return list(self.bends.values())[0] if len(self.bends) == 1 else np.nan

    def with_radius(self, radius):
        """The same lay with another stinger radius."""
        if len(self.bends) != 1:
            raise Refusal(f"{self.case}: --radii needs supports with one curved length in their path, fixed to a body or in "
                          f"space; this case has {len(self.bends) or 'none'}: change them by --set")
        return Rig(self.case, [*self.changes, f"{list(self.bends)[0]}={radius:.9g}"], self.folder)

    def width(self, tension, rise):
        """Horizontal extent [m] of a catenary from its lowest point, with this tension there."""
        scale = tension / self.weight
        return scale * np.arccosh(1 + rise / scale)

    def run(self, more):
        """Static equilibrium of the case with changes; None if there is none."""
        path = self.folder / "lay.h5"
        path.unlink(missing_ok=True)
        code = run_case("run", self.case, [*self.changes, *more, "dynamics=null"], "-q", "-o", str(path))
        if code == 130:
            raise KeyboardInterrupt
        if code not in (0, 3, 4):
            raise Refusal(f"{self.case}: the equilibrium of a lay could not be computed" if not more else
                          f"{self.case}: the lay with {', '.join(more)} could not be computed")
        return Results(path) if code == 0 and path.is_file() else None

    def rise_of_tension(self, depth):
        """Increase of tension [N] of a catenary from its lowest point to the upper end."""
        return self.weight * (self.drop + depth - self.depth)

    def first_tension(self):
        """Tension [N] at the lowest point of a catenary with the bending strain MOST_STRAINED."""
        return self.weight * self.outer / 2 / MOST_STRAINED

    def changes_at(self, depth, bottom):
        """Changes of the case for a depth and a tension at the lowest point: the line length changes by that of the
        catenary, with the same element lengths."""
        rise = self.rise + depth - self.depth
        if not rise > 0:
            raise Refusal(f"{self.case}: a depth of {depth:g} m is too small for this stinger: in the lay of the case, in "
                          f"{self.depth:g} m, the pipe leaves it {self.rise:.4g} m above the bed, which would then be "
                          f"{-rise:.4g} m above that point; shorten the stinger, or raise it")
        span = np.sqrt(rise * (rise + 2 * bottom / self.weight))
        length = max(self.length + span - self.span, 0.2 * self.length)
        way = (self.anchor - self.top)[:2]
        anchor = self.anchor.copy()
        anchor[:2] += way / np.linalg.norm(way) * (self.width(bottom, rise) - self.reach)
        anchor[2] -= depth - self.depth
        section = f"lines.{self.name}.sections[{self.section}]"
        count = [] if self.elements is None else [f"{section}.elements={int(np.ceil(self.elements * length / self.length))}"]
        return [*self.kept, f"environment.seabed.depth={depth:.9g}", f"{section}.length={length:.9g}", *count,
                f"{self.far}=[{', '.join(f'{v:.9g}' for v in anchor)}]"]

    def at(self, depth, bottom):
        """The lay; None if statics finds no equilibrium."""
        results = self.run(self.changes_at(depth, bottom))
        return None if results is None else self.read(results)

    def read(self, results):
        line = results.line(self.name)
        checked = pipe_checks.of_case(results, line)
        part_of = {name: checked.part == k for k, name in enumerate(pipe_checks.PARTS)}

        def most(quantity, where):
            return pipe_checks.largest(checked.values[quantity][:1], part_of[where][:1])[0]
        strain, buckling = pipe_checks.STRAIN, pipe_checks.BUCKLING
        simple = next((at_rest for name, at_rest, *_ in checked.criteria("overbend", [0]) if "at rest" in name), np.nan)
        geometry = {row[0]: row[1] for row in pipe_tables.geometry(checked, 0.0)[1]}
        clearance = float(checked.left.tip_clearance[0])
        reactions = [row[1] for row in tables.supports(results)[1]]
        tension = 1e3 * geometry["top tension [kN]"]
        row = [tension, clearance, float(checked.left.angle[0]), geometry.get("layback, from the end to touchdown [m]", np.nan),
               1e3 * geometry.get("tension at touchdown [kN]", np.nan), most(strain, "overbend"), simple, most(buckling, "overbend"),
               most(strain, "sagbend"), most(buckling, "sagbend"), max(reactions)]
        return Lay(tension, row, clearance, most(buckling, "sagbend"), float(np.fmax(simple, most(buckling, "overbend"))))
