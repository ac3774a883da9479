"""The report of a run: what an engineer looks at before signing."""
from pathlib import Path

import numpy as np

from . import charts, scene, tables
from .page import Page

MOST_LINES = 8  # with figures of their own
MOST_MODES = 12
MOST_HISTORIES = 16
FIELDS = ("effective_tension", "utilisation", "bending_moment", "curvature", "shear_force", "torsion_moment", "contact_normal_force",
          "line_contact_normal_force")


def title_of(results):
    return str(results.keys.get("title") or results.path.stem)


def by_tension(results):
    """The lines, the one with the largest tension first, and how many of them are shown."""
    if not results.has("effective_tension"):
        return results.lines
    return sorted(results.lines, key=lambda line: -results.field("effective_tension", line).max())


def moves(results):
    return results.outputs > 1


def pictures(page, results):
    page.section("Model")
    for view, caption in (("elevation", "From the side."), ("plan", "From above."), ("space", "In space.")):
        figure = scene.picture(results, view)
        page.figure(figure, caption, "png")
    page.table(*tables.of_lines(results))


def start(page, results):
    page.section("Start")
    page.text(f"State of the first output, t = {results.time[0]:g} s: the static equilibrium where the case has statics, "
              "moving as the motions of the case begin (damping of the material then adds to its forces). "
              "Forces are those of the line on what holds its end; the declination is the angle between the upward "
              "vertical and the direction into the line.")
    page.table(*tables.at_ends(results, 0))


def ranges(page, results, lines, since):
    page.section("Range graphs")
    if moves(results):
        page.text(f"Over the {np.count_nonzero(results.since(since))} outputs from t = {since:g} s on. Peaks between "
                  "two outputs are in the table of extremes, not here.")
    for line in lines:
        for field in FIELDS:
            if not results.has(field):
                continue
            values = results.magnitude(field, line)
            if np.any(np.abs(values) > 0):
                page.figure(charts.range_graph(results, line, field, since),
                            f"{charts.words(field).capitalize()} along {line.name}.")


def histories(page, results, lines, since):
    page.section("Time histories")
    time = results.step_time
    if len(results.histories) > MOST_HISTORIES:
        page.text(f"Figures are of the first {MOST_HISTORIES} of {len(results.histories)} histories by name; hawser plot "
                  "draws the others, and the table has the statistics of all.")
    for name in results.histories[:MOST_HISTORIES]:
        series = results.series(name)
        for group in groups(series):
            curves = [(charts.words(c), series.column(c)) for c in group]
            if all(np.ptp(v) == 0 for _, v in curves):
                continue
            what = charts.words(group[0]) if len(group) == 1 else charts.words(group[0].rsplit("_", 1)[0])
            page.figure(charts.history(time, curves, series.unit(group[0]), what, series.name),
                        f"{what.capitalize()} of {series.name}, every step.")
            if group[0] == "effective_tension" and np.count_nonzero(time >= since) > 64:
                keep = time >= since
                page.figure(charts.density(time[keep], series.column(group[0])[keep], series.unit(group[0]), what,
                                           series.name), f"Spectrum of the {what} of {series.name} (Welch).")
    if results.has("effective_tension"):
        for line in lines:
            values = results.field("effective_tension", line)
            page.figure(charts.history(results.time, [("end A", values[:, 0]), ("end B", values[:, -1])],
                                       results.unit("effective_tension"), "effective tension", line.name),
                        f"Tension at the ends of {line.name}, every output.")
    page.table(*tables.statistics_of(results, since))


def groups(series):
    """Columns that stand in one figure: the components of a vector, else each by itself."""
    out = {}
    for c in series.columns:
        stem = c[:-2] if c.endswith(("_x", "_y", "_z")) else c
        if stem not in ("velocity", "effective_tension_before", "effective_tension_after", "end_direction"):
            out.setdefault(stem, []).append(c)
    return list(out.values())


def energy(page, results):
    head, rows = tables.energy(results)
    if not rows:
        return
    page.section("Energy")
    page.text("What was brought in since the start, where it is and what is not accounted for ('error').")
    page.table(head, rows)
    series = results.series("energy")
    page.figure(charts.history(results.step_time, [(charts.words(c), series.column(c)) for c in series.columns], "J",
                               "energy"), "The energy audit, every step.")


def modes(page, results):
    """A file of `hawser modes`: output k is mode k, drawn with 5 % of the longest line as its largest displacement."""
    page.section("Natural modes")
    series = results.series("modes")
    page.table(["mode", "period [s]", "frequency [Hz]"],
               [[k + 1, float(series.column("period")[k]), float(series.column("frequency")[k])] for k in range(results.steps)])
    page.section("Shapes")
    page.text("Dashed: the equilibrium. The largest displacement is drawn as 5 % of the longest line.")
    for k in range(1, min(results.outputs, MOST_MODES + 1)):
        x = np.concatenate([np.abs(results.field("mode_shape", line, k)) for line in results.lines])
        view = "plan" if x[:, :2].max() > x[:, 2].max() and x[:, 1].max() > x[:, 0].max() else "elevation"
        figure = scene.picture(results, view, k, 3.2)
        period = series.column("period")[k - 1]
        figure.axes[0].set_title(f"mode {k}, {period:.4g} s, " + ("from above" if view == "plan" else "from the side"))
        page.figure(figure, f"Mode {k}: {period:.4g} s.", "png")


def count(n, what):
    return f"{n} {what}" + ("" if n == 1 else "s")


def run_of(results):
    """Who has computed what, and when."""
    ranks = results.attribute("ranks")
    return (f"{Path(results.attribute('case_path')).name}: hawser {results.attribute('version')}, "
            f"{results.attribute('date')}, {ranks} rank{'' if ranks == '1' else 's'}.")


def make(results, path, since):
    page = Page(title_of(results))
    if results.modes:
        page.text(run_of(results))
        for m in results.messages():
            page.text(m, "warning" if m.startswith("warning") else "note")
        modes(page, results)
        page.section("Case file")
        page.text(results.case, "pre")
        return page.write(path)
    steps = max(results.steps - 1, 0)
    page.text(f"{run_of(results)} {count(len(results.lines), 'line')}, {count(results.outputs, 'output')}, "
              f"{count(steps, 'step')} to t = {results.time[-1]:g} s.")
    if results.time[-1] < results.duration * (1 - 1e-6):
        page.text(f"The run has reached t = {results.time[-1]:g} s of the {results.duration:g} s of its case.", "warning")
    messages = results.messages()
    if messages:
        page.section("Notes and warnings")
        for m in messages:
            page.text(m, "warning" if m.startswith("warning") else "note")
    pictures(page, results)
    start(page, results)
    page.section("Extremes")
    head, rows = tables.extremes(results)
    if rows:
        page.text("Over every step and every node.")
        page.table(head, rows)
    else:
        page.text("They are written at the end of a run, which this one has not reached.")
    lines = by_tension(results)[:MOST_LINES]
    if len(lines) < len(results.lines):
        page.text(f"Figures below are of the {MOST_LINES} lines with the largest tensions of {len(results.lines)}.")
    ranges(page, results, lines, since)
    if moves(results) and results.steps > 0:
        histories(page, results, lines, since)
    head, rows = tables.clashes(results)
    if rows:
        page.section("Clashes")
        page.table(head, rows)
    energy(page, results)
    page.section("Case file")
    page.text(results.case, "pre")
    page.write(path)
