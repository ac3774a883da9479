"""hawser plot: one figure of a range, a stress, a history or the model."""
from pathlib import Path

from . import charts, export, offsets, radiation, report, scene, stress
from .arguments import place_for
from .given import history_of, refuse_since, results_of
from .page import whole
from .results import Refusal

HISTORY = {"name", "column", "since"}
# Options of each figure besides a file and --set.
TAKES = {"range": {"line", "field", "since"}, "stress": {"line", "outer_diameter", "wall", "since"},
         "offsets": set(), "radiation": set(), "history": HISTORY, "spectrum": HISTORY, "phase": HISTORY | {"over"}, **{view: {"time"} for view in scene.VIEWS}}


def refuse_what_is_not_taken(options):
    for name in sorted(set().union(*TAKES.values()) - TAKES[options.what]):
        if getattr(options, name) is not None:
            takes = ", ".join(f"--{other.replace('_', '-')}" for other in sorted(TAKES[options.what]))
            raise Refusal(f"the figure '{options.what}' does not use --{name.replace('_', '-')} (it uses {takes})")


def output_at(results, time):
    """Output nearest to a time [s]; None: the last."""
    if time is None:
        return -1
    first, last = results.time[0], results.time[-1]
    if not first - 1e-6 <= time <= last + 1e-6 * max(last, 1.0):
        raise Refusal(f"{results.path}: there is no {'mode' if results.modes else 'output'} at --time {time:g} (they are from "
                      f"{first:g} to {last:g})")
    return int(abs(results.time - time).argmin())


def default_line(results, options):
    if not results.lines:
        raise Refusal(f"{results.path}: there are no lines")
    return results.line(options.line) if options.line else report.by_tension(results)[0]


def make_of_table(options):
    figure = {"offsets": offsets, "radiation": radiation}[options.what].figure_of(options.results)
    if options.changes:
        raise Refusal(f"{options.results}: --set changes a case file, but this is a table")
    path = Path(options.results)
    output = place_for(options.output or path.with_name(f"{path.stem}-{options.what}.png"), [], (".png", ".svg", ".pdf"), "a figure", [path])
    figure.savefig(output, dpi=150)
    print(f"figure: {output}")


def make(options):
    refuse_what_is_not_taken(options)
    if options.what in ("offsets", "radiation"):
        return make_of_table(options)
    results = results_of(options.results, options.changes)
    refuse_since(results, options.since)
    since, field = options.since or 0.0, options.field or "effective_tension"
    if results.modes and options.what not in scene.VIEWS:
        raise Refusal(f"{results.path} contains natural modes: figures of them are plan, elevation and space, with --time K for mode K")
    if options.what in scene.VIEWS:
        figure = scene.picture(results, options.what, output_at(results, options.time))
    elif options.what == "range":
        figure = charts.range_graph(results, default_line(results, options), field, since)
    elif options.what == "stress":
        line = default_line(results, options)
        largest = stress.along(results, line, options.outer_diameter, options.wall)
        figure = charts.stress_graph(results, line, largest, since)
        print(stress.description(results, line, largest, since))
    else:
        series, column = history_of(results, options.name, options.column)
        keep = results.step_time >= since
        time = results.step_time[keep]
        values, unit = series.column(column)[keep], series.unit(column)
        if len(time) < 16:
            raise Refusal(f"'{series.name}' has {len(time)} steps from t = {since:g} s on: too few for a figure")
        if options.what == "history":
            figure = charts.history(time, [(column, values)], unit, column, series.name)
        elif options.what == "spectrum":
            figure = charts.density(time, values, unit, column, series.name)
        else:
            other = options.over or "position_z"
            figure = charts.one_over_another(series.column(other)[keep], values,
                                             (charts.label(other, series.unit(other)), charts.label(column, unit)), series.name)
    # File names of other fields or histories differ from that of the first figure.
    lines = export.file_names([line.name for line in results.lines])
    histories = export.file_names([results.series_name(key) for key in results.series_names])
    words = {"range": [lines.get(options.line), field if field != "effective_tension" else None], "stress": [lines.get(options.line)]}
    named = histories.get(options.name, options.name and export.file_name(options.name))
    more = [word for word in words.get(options.what, [named, options.column]) if word]
    path = place_for(options.output or results.path.with_name("-".join([results.path.stem, options.what, *more]) + ".png"),
                     [results], (".png", ".svg", ".pdf"), "a figure")
    figure.savefig(path, dpi=150, bbox_inches=whole(figure))
    print(f"figure: {path}")


