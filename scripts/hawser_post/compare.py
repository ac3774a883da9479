"""hawser compare: two results together in three dimensions, in tables of differences and in graphs."""
from pathlib import Path

import numpy as np

from . import charts, compare_tables, envelopes
from .arguments import place_for
from .given import results_of
from .page import Page
from .report import MOST_HISTORY_FIGURES, MOST_LINES, by_tension, groups, run_of, title_of
from .results import Refusal

COLOURS = ("#1f5a92", "#b3470f")  # of A and of B


def make(options):
    a, b = results_of(options.a, options.changes), results_of(options.b, options.changes)
    if a.modes != b.modes:
        raise Refusal(f"{b.path if b.modes else a.path} contains natural modes, and the other file a run: they cannot be compared")
    name = f"{a.path.stem}-{b.path.stem}.html" if a.path.stem != b.path.stem else f"{a.path.stem}-compared.html"
    path = place_for(options.output or Path(name), (a, b), (".html", ".htm"), "a comparison")
    page_of(a, b, path)
    print(f"comparison: {path}")


def page_of(a, b, path):
    page = Page(f"{title_of(a)}: two results")
    page.text(f"A is {a.path}: {run_of(a)}")
    page.text(f"B is {b.path}: {run_of(b)}")
    for words in compare_tables.only(a, b):
        page.text(words, "note")
    for letter, results in (("A", a), ("B", b)):
        for words in results.messages():
            if words.startswith("warning"):
                page.text(f"{letter}: {words}", "note")
    page.section("Models")
    page.text("A is coloured by a field; B is drawn over it with dashed orange lines with white edges, at its output nearest in time. The notes beside the model are those of A.")
    page.model(a, b)
    page.section("Differences")
    differences(page, a, b)
    graphs(page, a, b)
    page.write(path)


def differences(page, a, b):
    found = False
    for words, (head, rows) in (("Different keys of the cases:", compare_tables.inputs(a, b)),
                                ("Extremes over every step:", compare_tables.extremes(a, b)),
                                ("Start:", compare_tables.ends(a, b, 0, "start")),
                                ("Histories with differences:", compare_tables.histories(a, b)),
                                ("Positions of the lines:", compare_tables.places(a, b))):
        if not rows:
            continue
        found = True
        page.text(words)
        page.table(head, rows[:compare_tables.MOST_ROWS])
        if len(rows) > compare_tables.MOST_ROWS:
            page.text(f"{len(rows) - compare_tables.MOST_ROWS} more rows are not shown.")
    if not found:
        page.text("The two results have nothing in common.")


def graphs(page, a, b):
    names = set(compare_tables.common(a, b))
    lines = [line for line in by_tension(a) if line.name in names][:MOST_LINES]
    fields = [name for name in a.reported("graph") if b.has(name)]
    if lines and fields:
        page.section("Range graphs")
    for line in lines:
        for field in envelopes.above_noise(a, line, fields, 0.0):
            page.figure(range_graph(a, b, line.name, field), f"{a.label(field).capitalize()} along {line.name}: least, largest and start of A and B.")
    shown = compare_tables.common_histories(a, b)
    if shown:
        page.section("Time histories")
    for name in page.within(shown, MOST_HISTORY_FIGURES, "histories by name; hawser plot draws the other ones."):
        one, other = a.series(name), b.series(name)
        for column in (c for group in groups(one) for c in group if c in other.columns):
            if max(np.ptp(one.column(column)), np.ptp(other.column(column))) > 0:
                page.figure(history(a, b, one, other, column), f"{charts.words(column).capitalize()} of {name}.")


def range_graph(a, b, name, field):
    unit, factor = charts.shown(a.unit(field))
    figure, axes = charts.sheet()
    for results, colour, letter in ((a, COLOURS[0], "A"), (b, COLOURS[1], "B")):
        line = results.line(name)
        found = envelopes.envelope(results, line, field, 0.0)
        if found is not None:
            axes.plot(line.arc, found.most / factor, color=colour, label=f"{letter}, largest")
            axes.plot(line.arc, found.least / factor, color=colour, lw=0.8, label=f"{letter}, least")
        axes.plot(line.arc, results.magnitude(field, line, 0) / factor, color=colour, ls="--", lw=0.9, label=f"{letter}, start")
    axes.set(xlabel="arc length from end A [m]", ylabel=charts.label(a.label(field), unit), title=name)
    charts.legend(axes, 6)
    return figure


def history(a, b, one, other, column):
    unit, factor = charts.shown(one.unit(column))
    figure, axes = charts.sheet(2.6)
    for results, series, colour, letter in ((a, one, COLOURS[0], "A"), (b, other, COLOURS[1], "B")):
        axes.plot(*charts.thinned(results.step_time, series.column(column) / factor), lw=0.9, color=colour, label=letter)
    axes.set(xlabel="time [s]", ylabel=charts.label(charts.words(column), unit), title=one.name)
    charts.legend(axes)
    return figure
