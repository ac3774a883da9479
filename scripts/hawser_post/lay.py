"""hawser lay: the smallest tension with which a pipe is laid in each of a list of depths, so that it clears the tip of its
stinger and is not used up in the sagbend."""
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy import optimize

from . import export, pipe_checks, tables
from .arguments import run_case
from .charts import legend, sheet
from .pipe_told import pipe_of, print_table
from .results import Refusal, Results, metres
from .sections import part, sections_of

CLOSE = 0.005  # of the tension
MOST_STRAINED = 0.004  # bending strain of a catenary with the least tension that is tried
MOST_DOUBLINGS = 8
HEAD = ["depth [m]", "tension [N]", "tip clearance [m]", "departure angle [deg]", "layback [m]", "tension at touchdown [N]",
        "overbend strain [%]", "overbend local buckling [-]", "sagbend strain [%]", "sagbend local buckling [-]",
        "largest reaction [N]"]


@dataclass
class Lay:
    """What comes out of one tension."""
    tension: float  # N, at the upper end
    row: list  # as HEAD, without the depth
    clearance: float  # m
    sagbend: float  # local buckling


class Rig:
    """A lay as the case has it, and how its line changes with depth and tension."""

    def __init__(self, case, changes, folder):
        self.case, self.changes, self.folder = Path(case), list(changes), Path(folder)
        results = self.run([])
        self.name = pipe_of(results, None).name
        line = results.line(self.name)
        if pipe_checks.grade_of(results, line) is None:
            raise Refusal(f"{case}: the case does not say of which steel '{line.name}' is: 'grade' with the pipe of its line type")
        checked = pipe_checks.of_case(results, line)
        if checked.left is None or checked.down is None:
            raise Refusal(f"{case}: a lay needs 'supports' that the pipe leaves, and a seabed on which it comes down")
        self.forwards = checked.left.forwards
        far = "end_b" if self.forwards else "end_a"
        self.far = f"lines.{self.name}.{far}.anchor"
        keys = part(results, "lines")[self.name]
        anchor = (keys.get(far) or {}).get("anchor") if isinstance(keys.get(far), dict) else None
        seabed = (results.keys.get("environment") or {}).get("seabed")
        if not isinstance(anchor, list) or not isinstance(seabed, dict) or "depth" not in seabed:
            raise Refusal(f"{case}: a lay over depths needs a far end with 'anchor' and a seabed with 'depth'")
        self.anchor, self.depth = np.array([metres(x, np.nan) for x in anchor]), metres(seabed["depth"], np.nan)
        x, (arc, place) = results.field("position", line, 0), checked.down
        self.top = x[0 if self.forwards else -1]
        lift = np.array([np.interp(checked.left.arc[0], line.arc, x[:, k]) for k in range(3)])
        self.rise = lift[2] - place[0][2]  # m, of the free span, and its length
        self.span = abs(arc[0] - checked.left.arc[0])
        self.drop = self.top[2] - place[0][2]
        tension = np.interp(arc[0], line.arc, results.field("effective_tension", line, 0))
        # N/m: of the catenary of this height and length with this tension at touchdown.
        self.weight = tension * 2 * self.rise / (self.span**2 - self.rise**2)
        self.reach = self.width(tension, self.rise)
        self.outer = checked.outer
        ends = np.cumsum([metres(s.get("length"), np.nan) for s in sections_of(results, self.name)])
        self.section = int(np.searchsorted(ends, (arc[0] + checked.left.arc[0]) / 2))
        self.length = float(np.diff(np.concatenate([[0], ends]))[self.section])

    def width(self, tension, rise):
        """m, of a catenary from its lowest point, with this tension there."""
        scale = tension / self.weight
        return scale * np.arccosh(1 + rise / scale)

    def run(self, more):
        """The static equilibrium of the case with changes; None where there is none."""
        path = self.folder / "lay.h5"
        path.unlink(missing_ok=True)
        code = run_case("run", self.case, [*self.changes, *more, "dynamics=null"], "-q", "-o", str(path))
        if code not in (0, 3, 4):
            raise Refusal(f"{self.case}: the equilibrium of a lay could not be computed" if not more else
                          f"{self.case}: the lay with {', '.join(more)} could not be computed")
        return Results(path) if code == 0 and path.is_file() else None

    def least_tension(self, depth):
        bottom = self.weight * self.outer / 2 / MOST_STRAINED
        return bottom + self.weight * (self.drop + depth - self.depth)

    def at(self, depth, tension):
        """The lay at a depth, its line as long as that of a catenary with this tension at the upper end is longer than the
        case's: the tension is about that. None where statics finds none."""
        bottom, rise = tension - self.weight * (self.drop + depth - self.depth), self.rise + depth - self.depth
        span = np.sqrt(rise * (rise + 2 * bottom / self.weight))
        length = max(self.length + span - self.span, 0.2 * self.length)
        way = (self.anchor - self.top)[:2]
        anchor = self.anchor.copy()
        anchor[:2] += way / np.linalg.norm(way) * (self.width(bottom, rise) - self.reach)
        anchor[2] -= depth - self.depth
        results = self.run([f"environment.seabed.depth={depth:.9g}",
                            f"lines.{self.name}.sections[{self.section}].length={length:.9g}",
                            f"{self.far}=[{', '.join(f'{v:.9g}' for v in anchor)}]"])
        return None if results is None else self.read(results)

    def read(self, results):
        line = results.line(self.name)
        checked = pipe_checks.of_case(results, line)
        part_of = {name: checked.part == k for k, name in enumerate(pipe_checks.PARTS)}

        def most(quantity, where):
            return pipe_checks.largest(checked.values[quantity][:1], part_of[where][:1])[0]
        strain, buckling = "bending strain [%]", "local buckling, DNV-ST-F101 [-]"
        geometry = {row[0]: row[1] for row in pipe_checks.geometry(results, line, checked, 0.0)[1]}
        clearance = float(checked.left.tip_clearance[0])
        reactions = [row[1] for row in tables.supports(results)[1]]
        tension = 1e3 * geometry["top tension [kN]"]
        row = [tension, clearance, float(checked.left.angle[0]), geometry.get("layback, from the end to touchdown [m]", np.nan),
               1e3 * geometry.get("tension at touchdown [kN]", np.nan), most(strain, "overbend"), most(buckling, "overbend"),
               most(strain, "sagbend"), most(buckling, "sagbend"), max(reactions)]
        return Lay(tension, row, clearance, most(buckling, "sagbend"))


def smallest_tension(rig, depth, clearance, utilisation, told):
    """The lay with the smallest tension that clears the tip by `clearance` [m] and uses up `utilisation` of the sagbend."""
    known = {}

    def spare(tension):
        """Of what is asked, how much is left: rises with the tension of the catenary."""
        if tension not in known:
            known[tension] = rig.at(depth, tension)
            told(depth, known[tension])
        lay = known[tension]
        return -1.0 if lay is None or np.isnan(lay.clearance) else min(lay.clearance - clearance, utilisation - lay.sagbend)
    low = rig.least_tension(depth)
    if spare(low) >= 0:
        return known[low]
    high = low
    for _ in range(MOST_DOUBLINGS):
        low, high = high, 1.5 * high
        if spare(high) >= 0:
            break
    else:
        raise Refusal(f"{rig.case}: in {depth:g} m of water no tension up to {high / 1e3:.4g} kN clears the tip by {clearance:g} m "
                      f"with a sagbend used up to {utilisation:g}; a longer or more curved stinger would")
    optimize.brentq(spare, low, high, xtol=CLOSE * low, rtol=1e-3)
    return min((lay for tension, lay in known.items() if lay and spare(tension) >= 0), key=lambda lay: lay.tension)


def depths_of(text):
    try:
        found = [float(word) for word in text.split(",")]
    except ValueError:
        raise Refusal(f"--depths '{text}' are no numbers with commas between them, such as 50,100,150") from None
    if not all(0 < depth < 1e4 for depth in found):
        raise Refusal(f"--depths '{text}': depths are above 0, in m")
    return found


def draw(rows, path):
    depth = [row[0] for row in rows]
    figure, axes = sheet(3.2)
    axes.plot(depth, [row[1] / 1e3 for row in rows], marker="o", label="tension [kN]")
    axes.set(xlabel="depth [m]", ylabel="tension [kN]")
    right = axes.twinx()
    right.grid(False)
    for name, colour in (("overbend", "C1"), ("sagbend", "C2")):
        right.plot(depth, [row[HEAD.index(f"{name} local buckling [-]")] for row in rows], colour, ls="--", marker=".")
        axes.plot([], [], colour, ls="--", label=f"{name}: local buckling")
    right.set(ylabel="DNV-ST-F101 [-]", ylim=(0, None))
    axes.set_ylim(bottom=0)
    legend(axes)
    figure.savefig(path, dpi=150)


def make(options):
    depths = depths_of(options.depths)
    if not 0 < options.utilisation <= 1:
        raise Refusal(f"--utilisation {options.utilisation:g} is not above 0 and up to 1")
    path = Path(options.case)
    if path.suffix not in (".yaml", ".yml"):
        raise Refusal(f"{path}: a lay is that of a case file (.yaml)")

    def told(depth, lay):
        print(f"  depth {depth:g} m: " + ("no equilibrium" if lay is None else f"tension {lay.tension / 1e3:.4g} kN, "
              f"clearance {lay.clearance:.3f} m, sagbend {lay.sagbend:.3f}"), flush=True)
    with tempfile.TemporaryDirectory() as folder:
        rig = Rig(path, options.changes, folder)
        rows = []
        for depth in depths:
            rows.append([depth, *smallest_tension(rig, depth, options.clearance, options.utilisation, told).row])
    table = path.with_name(f"{path.stem}-lay.csv") if not options.output else Path(options.output)
    export.write(table, HEAD, rows)
    picture = table.with_suffix(".png")
    draw(rows, picture)
    shown = [[row[0], row[1] / 1e3, *row[2:5], row[5] / 1e3, *row[6:10], row[10] / 1e3] for row in rows]
    print_table([h.replace("[N]", "[kN]").replace(" [-]", "") for h in HEAD], shown)
    print(f"lay table: {table}\nfigure: {picture}")
