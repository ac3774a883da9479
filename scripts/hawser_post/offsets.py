"""hawser plot TABLE offsets: force and tensions over the offsets of a table of hawser stiffness."""
import csv
from pathlib import Path

import numpy as np

from .charts import COLOURS, colour, legend, sheet
from .results import Refusal

FIRST = "x offset [m]"


def read(path):
    """Columns of a stiffness table by name."""
    try:
        with open(path, newline="") as file:
            rows = list(csv.reader(file))
        if not rows or rows[0][0] != FIRST:
            raise ValueError
        return {name: np.array([float(row[k]) for row in rows[1:]]) for k, name in enumerate(rows[0])}
    except OSError as e:
        raise Refusal(f"{path}: cannot be read ({e.strerror})") from None
    except (ValueError, IndexError, UnicodeDecodeError):
        raise Refusal(f"{path}: the figure 'offsets' needs a table of hawser stiffness; this is not one") from None


def forces(path):
    """Head and rows of offsets, forces of the lines and their largest tensions."""
    found = read(path)
    names = [n for n in found if n in (FIRST, "y offset [m]", "Fx [N]", "Fy [N]", "Fz [N]") or n.startswith("tension of ")]
    return names, [list(row) for row in np.column_stack([found[n] for n in names])]


def stiffness(path):
    """Head and rows of the 6 x 6 stiffness at the smallest offset, in SI units."""
    found = read(path)
    rest = int(np.argmin(np.hypot(found[FIRST], found["y offset [m]"])))
    names = {name.split(" ")[0]: name for name in found}
    rows = [[force, *(float(found[names[f"K{i}{j}"]][rest]) for j in range(1, 7))]
            for i, force in enumerate(("Fx [N]", "Fy [N]", "Fz [N]", "Mx [N m]", "My [N m]", "Mz [N m]"), 1)]
    return ["", "x [1/m]", "y [1/m]", "z [1/m]", "rx [1/rad]", "ry [1/rad]", "rz [1/rad]"], rows


def figure_of(path):
    """Figure of restoring force and line tensions over the horizontal offset; rows are those of one direction."""
    path = Path(path)
    table = read(path)
    x, y = table[FIRST], table["y offset [m]"]
    way = np.hypot(x, y)
    if not (way > 0).any():
        raise Refusal(f"{path}: it has the stiffness at equilibrium only, without offsets; make offsets with: hawser stiffness CASE --to 20")
    far = np.argmax(way)
    along = np.array([x[far], y[far]]) / way[far]
    if np.abs(x * along[1] - y * along[0]).max() > 1e-6 * way[far]:
        raise Refusal(f"{path}: its offsets have several directions, but a figure shows one direction")
    place = x * along[0] + y * along[1]
    order = np.argsort(place)
    figure, axes = sheet(3.2)
    rest = int(np.argmin(way))
    force = (table["Fx [N]"] - table["Fx [N]"][rest]) * along[0] + (table["Fy [N]"] - table["Fy [N]"][rest]) * along[1]
    axes.plot(place[order], -force[order] / 1e3, COLOURS[0], marker=".", lw=2, label="restoring force [kN]")
    lines = [name for name in table if name.startswith("tension of ")]
    right = axes.twinx()
    right.grid(False)
    for k, name in enumerate(lines):
        shade = colour(k + 1, len(lines) + 1)
        right.plot(place[order], table[name][order] / 1e3, shade, ls="--")
        if len(lines) <= 12:
            axes.plot([], [], shade, ls="--", label=name.removesuffix(" [N]"))
    angle = np.degrees(np.arctan2(along[1], along[0]))
    axes.set(xlabel=f"offset [m] to {angle:.4g}°", ylabel="restoring force [kN]")
    right.set(ylabel="largest tension of a line [kN]", ylim=(0, None))
    legend(axes, 4)
    return figure
