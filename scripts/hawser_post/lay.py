"""hawser lay: smallest lay tension of a pipe in each of a list of depths that clears the stinger tip and satisfies
the sagbend check; with a list of stinger radii, also the smallest radius that satisfies the overbend check."""
import tempfile
from pathlib import Path

import numpy as np

from . import export
from .arguments import place_for, read_case, unwind_at_interrupts
from .charts import COLOURS, legend, sheet
from .charts import colour as colour_of
from .lay_rig import Rig
from .lay_search import CLOSE, Asked, smallest
from .pipe_report import print_table
from .results import Refusal

HEAD = ["depth [m]", "stinger radius [m]", "tension [N]", "tip clearance [m]", "departure angle [deg]", "layback [m]",
        "tension at touchdown [N]", "overbend strain [%]", "overbend strain, DNV simplified I [-]", "overbend local buckling [-]",
        "sagbend strain [%]", "sagbend local buckling [-]", "largest reaction [N]"]


def smallest_tension(rig, depth, asked):
    """The lay at a depth with the smallest tension that meets the requirements, or None and the reason; prints each
    trial."""
    def lay_at(bottom):
        lay = rig.at(depth, bottom)
        print(f"  depth {depth:g} m: " + ("" if lay is None else f"tension {lay.tension / 1e3:.4g} kN, clearance "
              f"{lay.clearance:.3f} m, sagbend {lay.sagbend:.3f}: ") + (asked.missed(lay) or "met"), flush=True)
        return lay
    height = rig.rise_of_tension(depth)
    keeps, fails = smallest(lay_at, asked, rig.first_tension(), height)
    criteria = f"the tip by {asked.clearance:g} m with a sagbend utilisation of at most {asked.utilisation:g}"
    if keeps is None:
        return None, (f"in {depth:g} m of water no tension up to {(fails[0] + height) / 1e3:.4g} kN clears {criteria}; "
                      "use a longer or more curved stinger")
    if fails is None:
        return None, (f"in {depth:g} m of water every tension down to {(keeps[0] + height) / 1e3:.4g} kN clears "
                      f"{criteria}, so there is no smallest one; require a larger clearance or a smaller utilisation")
    return keeps[1], ""


def numbers_of(option, text, what, example):
    try:
        found = [float(word) for word in text.split(",")]
    except ValueError:
        raise Refusal(f"{option} '{text}' is not a list of numbers separated by commas, such as {example}") from None
    if not all(0 < number < 1e4 for number in found):
        raise Refusal(f"{option} '{text}': {what} must be above 0, in m")
    return found


def lays(case, options, depths, radii):
    """(depth, radius, lay or None) for each depth and radius, and warnings."""
    found, warnings = [], []
    asked = Asked(options.clearance, options.utilisation)
    unwind_at_interrupts()
    with tempfile.TemporaryDirectory() as folder:
        rig = Rig(case, options.changes, folder)
        for radius in radii or [None]:
            other = rig.with_radius(radius) if radii else rig
            if radii:
                print(f"stinger radius {radius:g} m")
            for depth in depths:
                lay, why = smallest_tension(other, depth, asked)
                if lay is None and not radii:
                    raise Refusal(f"{case}: {why}")
                if lay is None:
                    warnings.append(f"with a stinger radius of {radius:g} m: {why}")
                found.append((depth, other.radius(), lay))
        warnings += rig.warnings
    return sorted(found, key=lambda f: f[:2]) if radii else found, warnings


def draw(rows, path):
    """Figure of tension and local buckling over depth, one colour per radius."""
    figure, axes = sheet(3.2)
    axes.set(xlabel="depth [m]", ylabel="tension [kN]")
    right = axes.twinx()
    right.grid(False)
    radii = sorted({row[1] for row in rows}) if not np.isnan([row[1] for row in rows]).any() else [np.nan]
    for k, radius in enumerate(radii):
        own = [row for row in rows if len(radii) == 1 or row[1] == radius]
        depth, colour = [row[0] for row in own], colour_of(k, len(radii))
        name = f"tension, R {radius:g} m" if len(radii) > 1 else "tension [kN]"
        axes.plot(depth, [row[HEAD.index("tension [N]")] / 1e3 for row in own], colour, marker="o", label=name)
        for part, dashes in (("overbend", "--"), ("sagbend", ":")):
            shade = colour if len(radii) > 1 else {"overbend": COLOURS[1], "sagbend": COLOURS[2]}[part]
            right.plot(depth, [row[HEAD.index(f"{part} local buckling [-]")] for row in own], shade, ls=dashes, marker=".")
            if k == 0:
                axes.plot([], [], "0.3" if len(radii) > 1 else shade, ls=dashes, label=f"{part}: local buckling")
    right.set(ylabel="DNV-ST-F101 [-]", ylim=(0, None))
    axes.set_ylim(bottom=0)
    legend(axes, 3)
    figure.savefig(path, dpi=150)


def make(options):
    depths = numbers_of("--depths", options.depths, "depths", "50,100,150")
    radii = numbers_of("--radii", options.radii, "radii", "80,100,120") if options.radii is not None else None
    if not options.clearance >= 0:
        raise Refusal(f"--clearance {options.clearance:g} is below 0 m: the pipe would lie on the last support")
    if not 0 < options.utilisation <= 1:
        raise Refusal(f"--utilisation {options.utilisation:g} is not above 0 and up to 1")
    path = Path(options.case)
    if path.suffix not in (".yaml", ".yml"):
        raise Refusal(f"{path}: hawser lay needs a case file (.yaml)")

    known = read_case(path, options.changes)["inputs"]
    table = place_for(options.output or path.with_name(f"{path.stem}-lay.csv"), [], (".csv",), "a table", known)
    picture = place_for(table.with_suffix(".png"), [], more=known)
    found, warnings = lays(path, options, depths, radii)
    rows = [[depth, radius, *(lay.row if lay else [np.nan] * (len(HEAD) - 2))] for depth, radius, lay in found]
    export.write(table, HEAD, rows)
    draw(rows, picture)
    show(rows)
    for line in chosen(found, options.utilisation) if radii else []:
        print(line)
    for warning in [*([] if radii else row_warnings(rows)), *warnings]:
        print(f"warning: {warning}")
    print(f"lay table: {table}\nfigure: {picture}")


def show(rows):
    """Prints the quantities as rows, lays as columns."""
    print()
    shown = [[name.replace("[N]", "[kN]").replace(" [-]", ""), *(v / 1e3 if name.endswith("[N]") else float(v) for v in values)]
             for name, values in zip(HEAD, zip(*rows))]
    shown = [row for row in shown if not np.isnan(row[1:]).all()]  # excludes undefined radii and checks that do not apply to the steel
    print_table([shown[0][0], *(f"{v:g}" for v in shown[0][1:])], shown[1:])
    print(f"Smallest tensions, found to {100 * CLOSE:g} %, at rest; a check is met if its value is at most 1.")


def chosen(found, utilisation):
    """For each depth a sentence with the smallest radius that satisfies the overbend check."""
    for depth in dict.fromkeys(depth for depth, *_ in found):
        kept = [(radius, lay) for d, radius, lay in found if d == depth and lay and lay.overbend <= utilisation]
        if kept:
            radius, lay = min(kept, key=lambda k: k[0])
            yield (f"In {depth:g} m of water {radius:g} m is the smallest of these radii with an overbend utilisation of at most "
                   f"{utilisation:g} ({lay.overbend:.3g}), with {lay.tension / 1e3:.4g} kN.")
        else:
            yield (f"In {depth:g} m of water no lay of these radii has an overbend utilisation of at most {utilisation:g}; "
                   "try larger radii on a stinger that is longer in proportion, so that the pipe leaves it at the same angle")


def row_warnings(rows):
    over = [f"{row[0]:g} m" for row in rows if row[HEAD.index("overbend local buckling [-]")] > 1]
    return [f"the overbend utilisation exceeds 1 in {', '.join(over)} of water; the search does not limit it, since larger tensions "
            "bend the pipe more; a longer or less curved stinger bends it less (--radii)"] if over else []
