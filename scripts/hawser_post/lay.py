"""hawser lay: the smallest tension with which a pipe is laid in each of a list of depths, so that it clears the tip of its
stinger and is not used up in the sagbend."""
import tempfile
from pathlib import Path

import numpy as np

from . import export, pipe_checks, pipe_tables, stress, tables
from .arguments import run_case
from .charts import legend, sheet
from .lay_search import CLOSE, Asked, Lay, smallest
from .pipe_told import pipe_of, print_table
from .results import Refusal, Results, metres
from .sections import lengths, part, sections_of

MOST_STRAINED = 0.004  # bending strain of a catenary with the tension that is tried first
HEAD = ["depth [m]", "tension [N]", "tip clearance [m]", "departure angle [deg]", "layback [m]", "tension at touchdown [N]",
        "overbend strain [%]", "overbend local buckling [-]", "sagbend strain [%]", "sagbend local buckling [-]",
        "largest reaction [N]"]


class Rig:
    """A lay as the case has it, and how its line changes with depth and tension."""

    def __init__(self, case, changes, folder):
        self.case, self.changes, self.folder = Path(case), list(changes), Path(folder)
        results = self.run([])
        self.name = pipe_of(results, None).name
        line = results.line(self.name)
        if pipe_checks.judged_pipe(results, line) is None:
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
        if stress.number(seabed.get("slope_deg"), 0.0) != 0:
            raise Refusal(f"{case}: a lay over depths is for a level seabed: 'slope_deg' of this one is "
                          f"{seabed['slope_deg']}; leave it out by --set environment.seabed.slope_deg=0")
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
        self.outer, self.doubts = checked.outer, pipe_checks.doubts(checked)
        found = lengths(results, line)  # a length that a target has found is kept, and the target left out
        self.section = int(np.searchsorted(np.cumsum(found), (arc[0] + checked.left.arc[0]) / 2))
        self.length, self.elements = float(found[self.section]), sections_of(results, self.name)[self.section].get("elements")
        self.kept = [f"lines.{self.name}.target=null"] if keys.get("target") else []

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

    def rise_of_tension(self, depth):
        """N, of a catenary from its lowest point to the upper end."""
        return self.weight * (self.drop + depth - self.depth)

    def first_tension(self):
        """N, at the lowest point of a catenary that is bent as much there as none is laid."""
        return self.weight * self.outer / 2 / MOST_STRAINED

    def changes_at(self, depth, bottom):
        """The case at a depth, its line as long as that of a catenary with this tension at its lowest point is longer than
        the case's, in elements as long as those of the case."""
        rise = self.rise + depth - self.depth
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
        """The lay; None where statics finds none."""
        results = self.run(self.changes_at(depth, bottom))
        return None if results is None else self.read(results)

    def read(self, results):
        line = results.line(self.name)
        checked = pipe_checks.of_case(results, line)
        part_of = {name: checked.part == k for k, name in enumerate(pipe_checks.PARTS)}

        def most(quantity, where):
            return pipe_checks.largest(checked.values[quantity][:1], part_of[where][:1])[0]
        strain, buckling = pipe_checks.STRAIN, pipe_checks.BUCKLING
        geometry = {row[0]: row[1] for row in pipe_tables.geometry(checked, 0.0)[1]}
        clearance = float(checked.left.tip_clearance[0])
        reactions = [row[1] for row in tables.supports(results)[1]]
        tension = 1e3 * geometry["top tension [kN]"]
        row = [tension, clearance, float(checked.left.angle[0]), geometry.get("layback, from the end to touchdown [m]", np.nan),
               1e3 * geometry.get("tension at touchdown [kN]", np.nan), most(strain, "overbend"), most(buckling, "overbend"),
               most(strain, "sagbend"), most(buckling, "sagbend"), max(reactions)]
        return Lay(tension, row, clearance, most(buckling, "sagbend"))


def smallest_tension(rig, depth, asked):
    """The lay at a depth with the smallest tension that keeps to what is asked; tells what is tried."""
    def lay_at(bottom):
        lay = rig.at(depth, bottom)
        print(f"  depth {depth:g} m: " + ("" if lay is None else f"tension {lay.tension / 1e3:.4g} kN, clearance "
              f"{lay.clearance:.3f} m, sagbend {lay.sagbend:.3f}: ") + (asked.missed(lay) or "met"), flush=True)
        return lay
    height = rig.rise_of_tension(depth)
    keeps, fails = smallest(lay_at, asked, rig.first_tension(), height)
    wanted = f"the tip by {asked.clearance:g} m with a sagbend used up to {asked.utilisation:g}"
    if keeps is None:
        raise Refusal(f"{rig.case}: in {depth:g} m of water no tension up to {(fails[0] + height) / 1e3:.4g} kN clears {wanted}; "
                      "a longer or more curved stinger would")
    if fails is None:
        raise Refusal(f"{rig.case}: in {depth:g} m of water every tension down to {(keeps[0] + height) / 1e3:.4g} kN clears "
                      f"{wanted}, so that none is the smallest; ask for more")
    return keeps[1]


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

    with tempfile.TemporaryDirectory() as folder:
        rig = Rig(path, options.changes, folder)
        asked = Asked(options.clearance, options.utilisation)
        rows = [[depth, *smallest_tension(rig, depth, asked).row] for depth in depths]
    table = path.with_name(f"{path.stem}-lay.csv") if not options.output else Path(options.output)
    export.write(table, HEAD, rows)
    picture = table.with_suffix(".png")
    draw(rows, picture)
    show(rows)
    for doubt in [*doubts(rows), *rig.doubts]:
        print(f"warning: {doubt}")
    print(f"lay table: {table}\nfigure: {picture}")


def show(rows):
    """Quantities below each other, depths side by side."""
    print()
    shown = [[name.replace("[N]", "[kN]").replace(" [-]", ""), *(v / 1e3 if name.endswith("[N]") else float(v) for v in values)]
             for name, values in zip(HEAD, zip(*rows))]
    print_table([shown[0][0], *(f"{v:g}" for v in shown[0][1:])], shown[1:])
    print(f"Smallest tensions, found to {100 * CLOSE:g} %, at rest; a check is met up to 1.")


def doubts(rows):
    over = [f"{row[0]:g} m" for row in rows if row[HEAD.index("overbend local buckling [-]")] > 1]
    return [f"the overbend is used up by more than 1 in {', '.join(over)} of water, of which no tension is asked: larger tensions "
            "bend it more; a longer or less curved stinger bends it less"] if over else []
