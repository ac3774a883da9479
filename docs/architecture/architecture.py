#!/usr/bin/env python3
"""Draws architecture.png beside itself: architecture.py [FILE], without arguments to that place.

The modules of the program and the path of the data through them. MODULES has every module of scripts/check-includes.
"""
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.patches import FancyBboxPatch  # noqa: E402

HERE = Path(__file__).resolve().parent
FILE, MODULE, BASE, EDGE, FLOW = "#fdf3dc", "#dcebf7", "#ececec", "#555555", "#d95f02"
# Name: (left, bottom, width, height, what it holds).
MODULES = {
    "run": (2.1, 6.35, 9.8, 0.62, "command line; order of a whole run; events; restart"),
    "io": (2.1, 3.1, 1.6, 2.75, "reads\ncase, meshes,\nWAMIT files;\n\nwrites HDF5,\nXDMF,\ncheckpoints"),
    "model": (4.1, 4.6, 1.55, 1.25, "what a case is:\nkeys, checks"),
    "advice": (4.1, 3.1, 1.55, 1.0, "notes and\nwarnings"),
    "mesh": (5.95, 4.6, 1.6, 1.25, "nodes, elements,\nshare of each rank"),
    "state": (5.95, 3.1, 1.6, 1.0, "positions, rotations,\ntheir rates"),
    "terms": (8.0, 4.6, 1.6, 1.25, "one class for each\nphysical effect"),
    "system": (8.0, 3.1, 1.6, 1.0, "residual and tangent\nfrom all terms"),
    "solve": (10.5, 3.1, 1.4, 2.75, "statics:\nSNES\n\ntime steps:\nTS, SNES\n\nlinear solver:\nKSP, LU"),
    "record": (2.1, 1.85, 9.8, 0.62, "fields, histories, extremes, energy, warnings of a run"),
    "kernels": (2.1, 0.95, 2.9, 0.62, "formulas: forces, tangents"),
    "geometry": (5.2, 0.95, 2.3, 0.62, "distances"),
    "math": (7.7, 0.95, 1.8, 0.62, "rotations"),
    "base": (9.7, 0.95, 2.2, 0.62, "MPI, PETSc"),
}
LOW = ("kernels", "geometry", "math", "base")  # every other module may use these
BARS = (*LOW, "run", "record")
FILES = {  # text, left, bottom, width, height
    "case file\nmeshes\ntables\nWAMIT files": (0.1, 4.6, 1.45, 1.25),
    "results\nHDF5, XDMF": (0.1, 3.1, 1.45, 0.75),
    "report, view,\nplot, export;\nParaView": (0.1, 1.85, 1.45, 0.9),
}


def box(ax, left, bottom, width, height, colour):
    ax.add_patch(FancyBboxPatch((left, bottom), width, height, boxstyle="round,pad=0,rounding_size=0.08",
                                facecolor=colour, edgecolor=EDGE, lw=1))


def arrow(ax, start, end, text="", at=None, **style):
    ax.annotate("", end, start, arrowprops={"arrowstyle": "-|>", "color": FLOW, "lw": 1.8, "shrinkA": 0,
                                            "shrinkB": 0, "mutation_scale": 13, **style})
    if text:
        ax.text(*at, text, color=FLOW, fontsize=8.5, ha="center", va="center")


def modules(ax):
    for name, (left, bottom, width, height, text) in MODULES.items():
        box(ax, left, bottom, width, height, BASE if name in LOW else MODULE)
        if name in BARS:
            ax.text(left + 0.12, bottom + height / 2, name, fontsize=11, fontweight="bold", va="center")
            ax.text(left + width - 0.12, bottom + height / 2, text, fontsize=9, ha="right", va="center")
            continue
        ax.text(left + width / 2, bottom + height - 0.2, name, fontsize=11, fontweight="bold", ha="center",
                va="center")
        ax.text(left + width / 2, bottom + (height - 0.32) / 2, text, fontsize=8.5, ha="center", va="center")


def draw(file):
    fig, ax = plt.subplots(figsize=(11, 6.4), dpi=110)
    ax.set_xlim(0, 12), ax.set_ylim(0.1, 7.1)
    ax.axis("off")
    modules(ax)
    for text, (left, bottom, width, height) in FILES.items():
        box(ax, left, bottom, width, height, FILE)
        ax.text(left + width / 2, bottom + height / 2, text, fontsize=9, ha="center", va="center")
    arrow(ax, (1.55, 5.2), (2.1, 5.2))
    arrow(ax, (3.7, 5.2), (4.1, 5.2), "Case", (3.9, 5.36))
    arrow(ax, (5.65, 5.2), (5.95, 5.2))
    arrow(ax, (4.88, 4.6), (4.88, 4.1))
    arrow(ax, (7.55, 5.2), (8.0, 5.2), "Mesh", (7.77, 5.36))
    arrow(ax, (7.55, 3.6), (8.0, 3.6))
    arrow(ax, (8.8, 4.6), (8.8, 4.1), "forces, derivatives", (9.5, 4.35))
    arrow(ax, (9.6, 3.75), (10.5, 3.75), "residual,\ntangent", (10.03, 3.98))
    arrow(ax, (10.5, 3.35), (9.6, 3.35), "increment", (10.03, 3.2))
    arrow(ax, (11.2, 3.1), (11.2, 2.47), "accepted step", (10.5, 2.78))
    arrow(ax, (2.9, 2.47), (2.9, 3.1), "rows of output", (3.6, 2.78))
    arrow(ax, (2.1, 3.48), (1.55, 3.48))
    arrow(ax, (0.82, 3.1), (0.82, 2.75))
    ax.text(7, 0.48, "A module uses only modules before it in this list (scripts/check-includes):\n" +
            "base, math, geometry, kernels, model, advice, mesh, state, system, terms, solve, io, record, run",
            fontsize=9, ha="center", va="center")
    ax.text(0.82, 6.66, "hawser", fontsize=15, fontweight="bold", ha="center", va="center")
    fig.subplots_adjust(0.01, 0.01, 0.99, 0.99)
    fig.savefig(file)


if __name__ == "__main__":
    draw(sys.argv[1] if len(sys.argv) > 1 else HERE / "architecture.png")
