"""Report of a run for engineering review."""
from pathlib import Path

import numpy as np

from . import charts, envelopes, inputs, offsets, pipe_checks, pipe_tables, scene, stations, stress, tables
from .page import Page
from .results import Refusal, Results

MOST_LINES = 8  # lines with their own figures
MOST_MODES = 12
MOST_HISTORY_FIGURES = 48
MOST_ROWS = 60  # rows in a table of the input
OTHER_PARTS = ("bodies", "joints", "links", "volumes", "supports", "contact", "statics", "stages", "dynamics", "events")


def title_of(results):
    return str(results.keys.get("title") or results.path.stem)


def by_tension(results):
    """The lines by decreasing largest tension, and the number of lines shown."""
    if not results.has("effective_tension"):
        return results.lines
    return sorted(results.lines, key=lambda line: -results.field("effective_tension", line).max())


def moves(results):
    return results.outputs > 1


def table(page, head, rows):
    page.table(*tables.for_reading(head, rows))


def pictures(page, results):
    page.section("Model")
    page.model(results)
    for view, caption in (("elevation", "From the side."), ("plan", "From above."), ("space", "In space.")):
        figure = scene.picture(results, view)
        page.figure(figure, caption, "png")
    table(page, *tables.of_lines(results))


def given(page, results):
    page.section("Input")
    if not results.as_read:
        page.text(f"These results were written by hawser {results.attribute('version')}, which did not store the case as read: run it "
                  "again for tables of its input. The case file is at the end.", "warning")
        return
    page.text("As in the case file, with its units (numbers without one are SI, angles in degrees), and with defaults for keys that are "
              "not given; the complete file is at the end.")
    for head, rows in (inputs.echo(results, "environment"), inputs.line_types(results),
                       inputs.properties(results), inputs.sections(results), inputs.on_lines(results),
                       *(inputs.echo(results, name) for name in OTHER_PARTS)):
        page.table(head, rows[:MOST_ROWS])
        if len(rows) > MOST_ROWS:
            page.text(f"{len(rows) - MOST_ROWS} more rows are in the case file.")


def start(page, results):
    if not results.lines:
        return
    page.section("Start")
    page.text(f"State of the first output, t = {results.time[0]:g} s: the static equilibrium if the case has statics. "
              "Forces are those of the line on its support; the declination is the angle between the upward "
              "vertical and the direction into the line.")
    table(page, *tables.at_ends(results, 0))


def stages(page, results):
    """Equilibria of the stages of statics, in order."""
    if not results.stages:
        return
    page.section("Stages of statics")
    for place, name in enumerate(results.stages):
        rest = Results(results.path, place)
        page.figure(scene.picture(rest, "elevation", high=3.2, name=f"stage {name}"), f"Stage {name}, from the side.", "png")
        table(page, *tables.at_ends(rest, 0))


def extremes(page, results, since):
    if not results.lines:
        return
    page.section("Extremes")
    head, rows = tables.extremes(results)
    if results.ended:
        page.text("Over every step and every node, as in the summary of the run.")
        table(page, head, rows)
    else:
        page.text("The extremes of the summary are written at the end of a run; this run has not ended.")
    fields = results.reported("graph", "table")
    many = len(results.lines) * len(fields) > 2 * MOST_ROWS
    shown = by_tension(results)[:MOST_LINES] if many else results.lines
    head, rows = tables.of_fields(results, fields, since, shown)
    if rows:
        page.text(f"Extremes along {f'the {len(shown)} lines with the largest tensions' if many else 'each line'}. " + envelopes.description(results, fields, since))
        table(page, head, rows)
    head, rows = tables.utilisation(results, since)
    if rows:
        page.section("Utilisation")
        page.text(f"Largest {', and '.join(results.utilisations.values())}. " + envelopes.description(results, list(results.utilisations), since))
        page.table(head, rows)


def ranges(page, results, lines, since):
    if not lines:
        return
    page.section("Range graphs")
    if moves(results):
        page.text(envelopes.description(results, results.reported("graph"), since))
    for line in lines:
        for field in envelopes.above_noise(results, line, results.reported("graph"), since):
            page.figure(charts.range_graph(results, line, field, since), f"{results.label(field).capitalize()} along {line.name}.")
        fed = stations.of_line(results, line)
        for field in fed[1] if fed else ():
            page.figure(charts.station_graph(results, line, field, *fed),
                        f"{results.label(field).capitalize()} of {line.name} at stations, which are fixed relative to its feeder while it moves "
                        "through them; every step.")


def stresses(page, results, lines, since):
    pipes = [line for line in lines if stress.is_pipe(results, line)]
    if not pipes:
        return
    page.section("Stress of pipes")
    page.text("Von Mises stress of the wall by wall tension, bending, torsion and pressures; the larger value of the inner and "
              "the outer fibre, at the outputs.")
    for line in pipes:
        largest = stress.along(results, line)
        page.figure(charts.stress_graph(results, line, largest, since), stress.description(results, line, largest, since) + ".")


def strength(page, results, lines, since):
    """Code checks of pipes whose case gives the steel."""
    for line in lines:
        try:
            found = pipe_checks.of_case(results, line) if stress.is_pipe(results, line) else None
        except Refusal as refusal:  # checks that do not apply, in a sentence
            page.section(f"Strength of {line.name}")
            page.text(f"Not checked by hawser pipe: {refusal}.", "warning")
            continue
        if found is None:
            continue
        page.section(f"Strength of {line.name}")
        page.text(f"{' '.join(found.description())} Local buckling is that of DNV-ST-F101 (2021), combined loads, load controlled, the larger value of "
                  "the load combinations a and b. A check is met if its value is at most 1.")
        if every := pipe_tables.every_step(found):
            page.table(*every)
        for head, rows in (pipe_tables.geometry(found, since), pipe_tables.for_reading(*pipe_tables.checks(found, since))):
            page.table(head, rows)
        for warning in pipe_checks.warnings(found):
            page.text(warning, "warning")


def histories(page, results, lines, since):
    page.section("Time histories")
    shown = [name for name in results.histories if not tables.is_support(results.series_at(name))]
    rest = "histories by name; hawser plot draws the other ones, and the table has the statistics of all."
    for name in page.within(shown, MOST_HISTORY_FIGURES, rest):
        history_figures(page, results, results.series_at(name), since)
    if results.has("effective_tension"):
        for line in lines:
            values = results.field("effective_tension", line)
            page.figure(charts.history(results.time, [("end A", values[:, 0]), ("end B", values[:, -1])],
                                       results.unit("effective_tension"), "effective tension", line.name),
                        f"Tension at the ends of {line.name}, every output.")
    table(page, *tables.statistics_of(results, since))


def history_figures(page, results, series, since):
    time = results.step_time
    scales = {unit: max((np.nanmax(np.abs(series.column(c)), initial=0.0) for c in series.columns if series.unit(c) == unit))
              for unit in series.units}
    for group in groups(series):
        curves = [(charts.words(c), series.column(c)) for c in group]
        if all(np.ptp(v) <= envelopes.NOISE * scales[series.unit(group[0])] for _, v in curves):
            continue
        what = results.label(group[0] if len(group) == 1 else group[0].rsplit("_", 1)[0])
        page.figure(charts.history(time, curves, series.unit(group[0]), what, series.name), f"{what.capitalize()} of {series.name}, every step.")
        if group[0] == "effective_tension" and np.count_nonzero(time >= since) > 64:
            keep = time >= since
            page.figure(charts.density(time[keep], series.column(group[0])[keep], series.unit(group[0]), what, series.name),
                        f"Spectrum of the {what} of {series.name} (Welch).")


def groups(series):
    """Columns grouped by figure: components of a vector together, others alone. Of bodies without accelerations."""
    out = {}
    without = {"velocity", "effective_tension_before", "effective_tension_after", "end_direction"}
    if "angular_acceleration_x" in series.columns:
        without |= {"acceleration", "angular_acceleration"}
    for c in series.columns:
        stem = c[:-2] if c.endswith(("_x", "_y", "_z")) else c
        if stem not in without:
            out.setdefault(stem, []).append(c)
    return list(out.values())


def supports(page, results):
    head, rows = tables.supports(results)
    if not rows:
        return
    page.section("Supports")
    page.text("Reactions of roller boxes on the line, over every step; the height is that of the line's axis above where it "
              "just touches the roller below, negative where it is pressed in. hawser plot draws their histories.")
    page.table(head, rows)


def meetings(page, results):
    clashes, clearances = tables.clashes(results), tables.clearances(results)
    if not clashes[1] and not clearances[1]:
        return
    page.section("Clashes and clearances")
    if "clashes" in results.file:
        shown = clashes[1]
        column = next((k for k, h in enumerate(clashes[0]) if h.startswith("peak force")), None)
        if len(shown) > MOST_ROWS and column is not None:
            shown = sorted(shown, key=lambda row: -row[column])[:MOST_ROWS]
            page.text(f"The {MOST_ROWS} of {len(clashes[1])} clashes with the largest forces; hawser export writes all.")
        if not shown:
            page.text("There was no contact.")
        table(page, *without_empty(clashes[0], shown))
    if clearances[1]:
        page.text("Smallest distances between surfaces over every step; negative values are overlaps.")
        page.table(*clearances)


def without_empty(head, rows):
    """Table without empty columns; of columns of places and other lines also without those that are all zero."""
    keep = []
    for k, title in enumerate(head):
        nothing = ("", 0.0) if title.startswith("other ") or "arc" in title else ("",)
        if any(row[k] not in nothing and not (isinstance(row[k], float) and np.isnan(row[k])) for row in rows):
            keep.append(k)
    return [head[k] for k in keep], [[row[k] for k in keep] for row in rows]


def energy(page, results):
    head, rows = tables.energy(results)
    if not rows:
        return
    page.section("Energy")
    page.text("Energy input since the start, its distribution, and the balance error ('error').")
    table(page, head, rows)
    series = results.series("energy")
    if results.steps > 1:
        curves = [(charts.words(c), series.column(c) - series.column(c)[0]) for c in series.columns]
        page.figure(charts.history(results.step_time, curves, "J", "change of energy"),
                    "The energy audit, every step: change since the start.")


def modes(page, results):
    """Section for a file of `hawser modes`: output k is mode k, drawn with a largest displacement of 5 % of the
    longest line."""
    page.section("Natural modes")
    series = results.series("modes")
    page.text("Small vibrations about the static equilibrium.")
    page.table(["mode", "period [s]", "frequency [Hz]"],
               [[k + 1, float(series.column("period")[k]), float(series.column("frequency")[k])] for k in range(results.steps)])
    page.text("Dashed: the equilibrium. The largest displacement is drawn as 5 % of the longest line, "
              "or smaller if a body would rotate by more than 0.3 rad.")
    for k in range(1, min(results.outputs, MOST_MODES + 1)):
        x = np.concatenate([np.abs(results.field("mode_shape", line, k)) for line in results.lines])
        view = "plan" if x[:, :2].max() > x[:, 2].max() and x[:, 1].max() > x[:, 0].max() else "elevation"
        period = series.column("period")[k - 1]
        name = f"mode {k}, {period:.4g} s, " + ("from above" if view == "plan" else "from the side")
        figure = scene.picture(results, view, k, 3.2, name)
        page.figure(figure, f"Mode {k}: {period:.4g} s.", "png")


def count(n, what):
    return f"{n} {what}" + ("" if n == 1 else "s")


def run_of(results):
    """Program, user and time of the run."""
    ranks = results.attribute("ranks")
    changes = "".join(f" --set {change}" for change in results.changes)
    return (f"{Path(results.attribute('case_path')).name}{changes}: hawser {results.attribute('version')}, "
            f"{results.attribute('date')}, {ranks} rank{'' if ranks == '1' else 's'}.")


def add_messages(page, results):
    for m in results.messages():
        page.text(m, "warning" if m.startswith("warning") else "note")


def of_modes(results, path):
    page = Page(title_of(results))
    page.text(run_of(results))
    add_messages(page, results)
    modes(page, results)
    page.section("Case file")
    page.text(results.case, "pre")
    page.write(path)


def mooring(page, table_path):
    """Stiffness at rest, and forces and tensions over the offsets, of a table of `hawser stiffness`."""
    page.section("Mooring over offsets")
    page.figure(offsets.figure_of(table_path), "Force that pulls the body back and the largest tension of each line.")
    table(page, *offsets.forces(table_path))
    page.text("Stiffness of the lines at rest: rows are forces and moments, columns displacements and small rotations.")
    table(page, *offsets.stiffness(table_path))


def make(results, path, since, vibrations=None, of_mooring=None):
    """Writes the report. vibrations: results of `hawser modes` of the same case, for a section of their own; of_mooring:
    table of `hawser stiffness`, likewise."""
    if results.modes:
        return of_modes(results, path)
    page = Page(title_of(results))
    steps = max(results.steps - 1, 0)
    page.text(f"{run_of(results)} {count(len(results.lines), 'line')}, {count(results.outputs, 'output')}, "
              f"{count(steps, 'step')} to t = {results.time[-1]:g} s.")
    if results.time[-1] < results.duration * (1 - 1e-6):
        page.text(f"The run has reached t = {results.time[-1]:g} s of {results.duration:g} s.", "warning")
    if results.messages():
        page.section("Notes and warnings")
        add_messages(page, results)
    pictures(page, results)
    given(page, results)
    stages(page, results)
    start(page, results)
    if vibrations:
        modes(page, vibrations)
    if of_mooring:
        mooring(page, of_mooring)
    extremes(page, results, since)
    lines = by_tension(results)[:MOST_LINES]
    if len(lines) < len(results.lines):
        page.text(f"The figures below show the {MOST_LINES} lines with the largest tensions of {len(results.lines)}.")
    ranges(page, results, lines, since)
    stresses(page, results, lines, since)
    strength(page, results, lines, since)
    if moves(results) and results.steps > 0:
        histories(page, results, lines, since)
    supports(page, results)
    meetings(page, results)
    energy(page, results)
    page.section("Case file")
    page.text(results.case, "pre")
    page.write(path)
