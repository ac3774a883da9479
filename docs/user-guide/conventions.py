#!/usr/bin/env python3
"""Draws the pictures of conventions.md beside itself: conventions.py, without arguments."""
from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

HERE = Path(__file__).resolve().parent
LINE, BODY, SEA = "#d95f02", "#555555", "#1f78b4"
plt.rcParams.update({"font.size": 10, "figure.dpi": 110})


def arrow(ax, start, end, colour="black", label="", offset=(0, 0), **style):
    ax.annotate("", end, start, arrowprops={"arrowstyle": "-|>", "color": colour, "lw": 1.6, **style})
    if label:
        ax.text(end[0] + offset[0], end[1] + offset[1], label, color=colour, ha="center", va="center")


def arc(ax, centre, radius, start, end, colour, label="", at=1.25):
    """An arc with an arrow at its end, angles in degrees anticlockwise from the right."""
    angle = np.radians(np.linspace(start, end, 60))
    x, y = centre[0] + radius * np.cos(angle), centre[1] + radius * np.sin(angle)
    ax.plot(x[:-4], y[:-4], color=colour, lw=1.3)
    ax.annotate("", (x[-1], y[-1]), (x[-6], y[-6]), arrowprops={"arrowstyle": "-|>", "color": colour, "lw": 1.3})
    middle = np.radians((start + end) / 2)
    ax.text(centre[0] + at * radius * np.cos(middle), centre[1] + at * radius * np.sin(middle), label,
            color=colour, ha="center", va="center")


def ship(ax, centre, heading, length=4.0, breadth=1.2):
    """A ship from above, its bow at the heading (degrees)."""
    half, side = length / 2, breadth / 2
    outline = np.array([[-half, side], [half * 0.5, side], [half, 0], [half * 0.5, -side], [-half, -side]])
    c, s = np.cos(np.radians(heading)), np.sin(np.radians(heading))
    outline = outline @ np.array([[c, s], [-s, c]]) + centre
    ax.fill(*outline.T, facecolor="#dddddd", edgecolor=BODY, lw=1.5)


def page(width, height, columns=1):
    figure, axes = plt.subplots(1, columns, figsize=(width, height), squeeze=False)
    for ax in axes.flat:
        ax.set_aspect("equal")
        ax.axis("off")
    return figure, axes[0][0] if columns == 1 else axes[0]


def save(figure, name):
    figure.tight_layout()
    figure.savefig(HERE / f"conventions-{name}.png", bbox_inches="tight")
    plt.close(figure)


def axes_and_ends():
    figure, ax = page(8, 3.9)
    ax.fill_between([-1, 12], -4.35, -4, color="#e6d8b8")
    ax.plot([-1, 12], [-4, -4], color="#8c6d31")
    ax.plot([-1, 12], [0, 0], color=SEA, lw=1, ls="--")
    ax.text(10.4, 0.22, "still water, z = 0", color=SEA, ha="center")
    ax.text(8.4, -4.2, "seabed at z = −depth", color="#8c6d31", ha="center", va="center", fontsize=9)
    s = np.linspace(0, 1, 200)
    x = 1.2 + 6.8 * s
    z = -0.4 - 3.6 * (1 - (1 - np.clip(s / 0.72, 0, 1)) ** 2.2)
    ax.plot(x, z, color=LINE, lw=2.5)
    ax.plot(x[[0, -1]], z[[0, -1]], "o", color=LINE)
    ax.text(0.95, -0.9, "end A, s = 0", color=LINE, ha="right")
    ax.text(8.15, -3.75, "end B, s = L", color=LINE, ha="left")
    arrow(ax, (x[50], z[50]), (x[85], z[85]), LINE, "direction of the line,\nfrom A to B", (1.35, 0.75))
    ax.add_patch(plt.Rectangle((-0.6, -0.4), 1.8, 0.9, facecolor="#dddddd", edgecolor=BODY))
    origin = (4.6, 0.5)
    arrow(ax, origin, (6.1, 0.5), label="x", offset=(0.2, 0))
    arrow(ax, origin, (4.6, 2.0), label="z (up)", offset=(0.45, 0))
    ax.plot(*origin, "o", ms=11, mfc="white", mec="black")
    ax.plot(*origin, "x", ms=6, color="black")
    ax.text(4.3, 0.78, "y\n(into the\npage)", ha="right", va="center", fontsize=9)
    ax.set(xlim=(-1.6, 12), ylim=(-4.4, 2.2))
    save(figure, "axes")


def directions():
    figure, (left, right) = page(9, 4.3, 2)
    arrow(left, (0, 0), (2.6, 0), label="x", offset=(0.2, 0))
    arrow(left, (0, 0), (0, 2.6), label="y", offset=(0, 0.2))
    for angle in (0, 30, 90, 180, 270):
        unit = np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
        arrow(left, 0.45 * unit, 1.7 * unit, SEA, lw=2.5)
        aside = np.array([0.35, 0.25]) if angle % 180 else np.array([0, 0.3])
        left.text(*(1.75 * unit + aside), f"{angle}°", color=SEA, ha="center", va="center")
    arc(left, (0, 0), 1.0, 0, 30, "black")
    left.set_title("direction_deg of waves and currents:\nwhere they go to, anticlockwise from +x", fontsize=10)
    left.set(xlim=(-3, 3), ylim=(-3, 3))
    ship(right, (0, 0), 0, 3.4, 1.1)
    arrow(right, (0, 0), (2.5, 0), BODY, "body x", (0.0, -0.3))
    arrow(right, (0, 0), (0, 1.25), BODY, "body y", (0.6, 0.05))
    for angle, name in ((0, "0°: from astern"), (45, "45°"), (90, "90°: from starboard"), (180, "180°: from ahead"),
                        (270, "270°: from port")):
        unit = np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
        far, near = (4.2, 2.8) if angle in (0, 180) else (2.5, 1.2)
        if angle == 45:
            far, near = 3.2, 1.9
        if angle == 270:
            arrow(right, (-0.6, far), (-0.6, near), SEA)
            right.text(-0.9, far + 0.25, name, color=SEA, ha="center", va="center")
            continue
        arrow(right, -far * unit, -near * unit, SEA)
        aside = {90: (0, -0.28), 0: (0.2, 0.35), 180: (-0.2, 0.35)}.get(angle, (0.1, 0.35))
        right.text(*(-far * unit + np.array(aside)), name, color=SEA, ha="center",
                   va="center")
    right.set_title("direction in a table of responses:\nas seen from the bow", fontsize=10)
    right.set(xlim=(-5.4, 5.4), ylim=(-3.4, 3.4))
    save(figure, "directions")


def phases():
    figure, ax = plt.subplots(figsize=(7.5, 3))
    t = np.linspace(0, 20, 500)
    period, lag = 10, 60
    ax.plot(t, np.cos(2 * np.pi * t / period), color=SEA, label="surface at the body's origin")
    ax.plot(t, 0.7 * np.cos(2 * np.pi * t / period - np.radians(lag)), color=LINE,
            label="heave, response 0.7 m/m, phase 60° (lag)")
    late = period * lag / 360
    for x, top, colour in ((10, 1, SEA), (10 + late, 0.7, LINE)):
        ax.plot([x, x], [-1.1, top], color=colour, lw=0.8, ls=":")
    ax.annotate("", (10 + late, -0.95), (10, -0.95), arrowprops={"arrowstyle": "<->"})
    ax.text(10 + late + 0.2, -0.95, "60/360 of the period later", va="center")
    ax.set(xlim=(0, 20), ylim=(-1.2, 1.7), xlabel="time, s", ylabel="m")
    ax.legend(loc="upper left", ncol=2, fontsize=9, frameon=False)
    save(figure, "phases")


def angles():
    figure, (left, right) = page(9, 3.6, 2)
    left.plot([0, 0], [0, 2], color="black", lw=0.8, ls="--")
    left.text(0, 2.15, "upward vertical", ha="center")
    down = np.radians(-50)
    s = np.linspace(0, 1, 50)
    left.plot(3.6 * s, -3.6 * s * np.tan(-down) + 2.0 * s ** 2, color=LINE, lw=2.5)
    left.plot(0, 0, "o", color=LINE)
    left.text(-0.2, -0.2, "end A", color=LINE, ha="right")
    arrow(left, (0, 0), (1.5 * np.cos(down), 1.5 * np.sin(down)), "black")
    arc(left, (0, 0), 1.1, 90, -50, "black", "declination 140°", 2.0)
    left.plot(3.6, -3.6 * np.tan(-down) + 2.0, "o", color=LINE)
    left.text(3.75, -2.2, "end B: 85°", color=LINE, ha="left")
    left.plot([3.6, 3.6], [-2.29, -1.2], color="black", lw=0.8, ls="--")
    left.set_title("declination, seen from the side:\nfrom the end into the line", fontsize=10)
    left.set(xlim=(-1.2, 5.4), ylim=(-2.9, 2.4))
    arrow(right, (0, 0), (2.6, 0), label="x", offset=(0.2, 0))
    arrow(right, (0, 0), (0, 2.0), label="y", offset=(0, 0.2))
    end = np.array([np.cos(np.radians(130)), np.sin(np.radians(130))]) * 2.6
    right.plot([0, end[0]], [0, end[1]], color=LINE, lw=2.5)
    right.plot([0, end[0]], [0, end[1]], "o", color=LINE)
    arc(right, (0, 0), 1.0, 0, 130, "black", "azimuth\n130°", 1.7)
    right.text(-0.2, -0.3, "end A", color=LINE, ha="right")
    right.text(end[0] - 0.2, end[1] + 0.15, "end B: −50°", color=LINE, ha="right")
    right.set_title("azimuth, seen from above:\nanticlockwise from +x", fontsize=10)
    right.set(xlim=(-3.4, 3.2), ylim=(-0.9, 2.6))
    save(figure, "angles")


def bodies():
    figure, (left, middle, right) = page(9, 3.4, 3)
    left.fill([-1.2, 1.2, 1.0, -1.0], [0.4, 0.4, -0.7, -0.7], facecolor="#dddddd", edgecolor=BODY)
    arrow(left, (0, 0), (-1.9, 0), BODY, "y (port)", (0, 0.25))
    arrow(left, (0, 0), (0, 1.6), BODY, "z", (0.2, 0))
    arc(left, (0, 0), 1.35, 170, 110, LINE)
    left.set_title("roll > 0: port side up\n(seen from astern)", fontsize=10)
    middle.fill([-1.8, 1.8, 1.3, -1.6], [0.4, 0.4, -0.5, -0.5], facecolor="#dddddd", edgecolor=BODY)
    arrow(middle, (0, 0), (2.3, 0), BODY, "x (bow)", (0, 0.25))
    arrow(middle, (0, 0), (0, 1.6), BODY, "z", (-0.2, 0))
    arc(middle, (0, 0), 1.35, 70, 10, LINE)
    middle.set_title("pitch > 0: bow down\n(seen from starboard)", fontsize=10)
    ship(right, (0, 0), 0, 3.4, 1.1)
    arrow(right, (0, 0), (2.3, 0), BODY, "x (bow)", (0, -0.3))
    arrow(right, (0, 0), (0, 1.6), BODY, "y (port)", (-0.65, 0))
    arc(right, (0, 0), 1.35, 10, 70, LINE)
    right.set_title("yaw > 0: bow to port\n(seen from above)", fontsize=10)
    for ax in (left, middle, right):
        ax.set(xlim=(-2.6, 2.6), ylim=(-1.3, 2.0))
    save(figure, "bodies")


def sections():
    figure, ax = page(8, 3.2)
    angle = np.linspace(-0.55, 0.55, 100)
    x, y = 6 * np.sin(angle), 6 - 6 * np.cos(angle)
    ax.plot(x, y, color=LINE, lw=7, alpha=0.35, solid_capstyle="butt")
    ax.plot(x, y, color=LINE, lw=1)
    ax.text(x[0] - 0.15, y[0], "to end A", ha="right", color=LINE)
    ax.text(x[-1] + 0.15, y[-1], "to end B", ha="left", color=LINE)
    arrow(ax, (0, 0), (1.7, 0), label="1, along the line", offset=(0.3, -0.25))
    arrow(ax, (0, 0), (0, 1.3), label="2", offset=(0.18, 0))
    ax.plot(0, 0, "o", ms=11, mfc="white", mec="black")
    ax.plot(0, 0, "o", ms=3, color="black")
    ax.text(-0.2, -0.32, "3 (out of the page)", ha="center", fontsize=9)
    ax.text(0, 1.75, "bending moment 3 > 0 bends the line towards axis 2,\n"
            "bending moment 2 > 0 away from axis 3", ha="center")
    ax.set(xlim=(-4.6, 4.6), ylim=(-0.6, 2.2))
    save(figure, "sections")


if __name__ == "__main__":
    for draw in (axes_and_ends, directions, phases, angles, bodies, sections):
        draw()
