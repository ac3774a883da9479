"""The commands that look at results: hawser report, plot, export, extremes and fatigue."""
import sys
from pathlib import Path

try:
    import numpy as np

    from . import charts, export, extremes_told, fatigue, report, scene, stress
    from .arguments import Parser, add_set
    from .given import history_of, modes_of, results_of
    from .page import whole
    from .results import Refusal
except ModuleNotFoundError as missing:
    sys.exit(f"hawser: this needs the Python module '{missing.name}': install python3-h5py python3-matplotlib "
             "python3-scipy python3-yaml (scripts/install-deps does)")


def make_report(options):
    results = results_of(options.results, options.changes)
    path = Path(options.output) if options.output else results.path.with_suffix(".html")
    report.make(results, path, options.since, modes_of(options.results, options.changes) if options.modes else None)
    print(f"report: {path}")


def make_export(options):
    results = results_of(options.results, options.changes)
    folder = Path(options.output) if options.output else results.path.with_suffix("")
    for path in export.everything(results, folder):
        print(path)


def default_line(results, options):
    if not results.lines:
        raise Refusal(f"{results.path}: there are no lines")
    return results.line(options.line) if options.line else report.by_tension(results)[0]


def make_plot(options):
    results = results_of(options.results, options.changes)
    if results.modes and options.what not in scene.VIEWS:
        raise Refusal(f"{results.path} holds natural modes: of those there are plan, elevation and space, with --time K for mode K")
    if options.what in scene.VIEWS:
        output = -1 if options.time is None else int(abs(results.time - options.time).argmin())
        figure = scene.picture(results, options.what, output)
    elif options.what == "range":
        figure = charts.range_graph(results, default_line(results, options), options.field, options.since)
    elif options.what == "stress":
        line = default_line(results, options)
        largest = stress.along(results, line, options.outer_diameter, options.wall)
        figure = charts.stress_graph(results, line, largest, options.since)
        print(stress.told(results, line, largest, options.since))
    else:
        series, column = history_of(results, options.name, options.column)
        keep = results.step_time >= options.since
        time = results.step_time[keep]
        values, unit = series.column(column)[keep], series.unit(column)
        if len(time) < 16:
            raise Refusal(f"'{series.name}' has {len(time)} steps from t = {options.since:g} s on: too few for a figure")
        if options.what == "history":
            figure = charts.history(time, [(column, values)], unit, column, series.name)
        elif options.what == "spectrum":
            figure = charts.density(time, values, unit, column, series.name)
        else:
            other = options.over or "position_z"
            figure = charts.one_over_another(series.column(other)[keep], values,
                                             (charts.label(other, series.unit(other)), charts.label(column, unit)), series.name)
    # Another field or history does not take the place of the first figure.
    words = {"range": [options.line, options.field if options.field != "effective_tension" else None], "stress": [options.line]}
    more = [word.replace(" ", "_").replace("/", "_") for word in words.get(options.what, [options.name, options.column]) if word]
    path = Path(options.output) if options.output else results.path.with_name("-".join([results.path.stem, options.what, *more]) + ".png")
    if path.suffix not in (".png", ".svg", ".pdf"):
        raise Refusal(f"{path}: a figure is a .png, .svg or .pdf file")
    figure.savefig(path, dpi=150, bbox_inches=whole(figure))
    print(f"figure: {path}")


def sea_states(given, changes):
    """Results files and the share of the time of each: 'FILE=SHARE', or FILE for equal shares."""
    out = []
    for text in given:
        path, _, share = text.rpartition("=") if "=" in text else (text, "", "")
        try:
            out.append((results_of(path, changes), float(share) if share else 1 / len(given)))
        except ValueError:
            raise Refusal(f"'{text}': the share of the time after '=' is no number") from None
    if sum(share for _, share in out) > 1 + 1e-9 or min(share for _, share in out) < 0:
        raise Refusal("the shares of the sea states are more than all of the time, or below zero")
    return out


def make_fatigue(options):
    curve = fatigue.CURVES[options.curve]
    needs = {"tension": ["breaking_load"], "area": ["area"], "pipe": ["outer_diameter", "wall"]}[curve.of]
    given = [name for name in ("breaking_load", "area", "outer_diameter", "wall") if getattr(options, name) is not None]
    for name in given:
        if name not in needs:
            raise Refusal(f"the curve {options.curve} takes no --{name.replace('_', '-')}, but "
                          + " and ".join(f"--{need.replace('_', '-')}" for need in needs))
    for name in needs if curve.of != "pipe" or given else []:  # those of a pipe may be in the case
        if not (getattr(options, name) or 0) > 0:
            raise Refusal(f"the curve {options.curve} needs --{name.replace('_', '-')}, above 0")
    if given and curve.of == "pipe" and options.wall > options.outer_diameter / 2:
        raise Refusal("--wall is more than half of --outer-diameter")
    if not options.factor > 0:
        raise Refusal(f"--factor {options.factor:g} is not above 0")
    states = sea_states(options.results, options.changes)
    line = states[0][0].line(options.line) if options.line else report.by_tension(states[0][0])[0]
    total = 0
    for results, share in states:
        own = results.line(line.name)
        if len(own.arc) != len(line.arc):
            raise Refusal(f"{results.path}: line '{line.name}' has other nodes than in {states[0][0].path}")
        total = total + share * fatigue.YEAR * fatigue.along(
            results, own, curve, options.since, options.breaking_load, options.area, options.outer_diameter, options.wall,
            options.factor)
        if (outputs := fatigue.outputs_a_period(results, own, options.since)) < 10:
            print(f"warning: {results.path} has {outputs:.2g} outputs in a mean period of the tension: cycles are cut short; "
                  "set output.every to a tenth of it or less")
    total = total.max(axis=1)
    worst = int(np.nanargmax(total))
    print(f"{line.name}, {curve.source}, {options.curve}: largest damage {total[worst]:.4g} a year at arc length "
          f"{line.arc[worst]:.6g} m" + (f", life {1 / total[worst]:.4g} years" if total[worst] > 0 else ""))
    path = Path(options.output) if options.output else states[0][0].path.with_name(f"{states[0][0].path.stem}-fatigue.csv")
    export.write(path, ["arc_length [m]", "damage [1/year]"], [(s, v) for s, v in zip(line.arc, total) if not np.isnan(v)])
    print(f"damage along the line: {path}")


def commands():
    parser = Parser(prog="hawser", description="Reports, figures and tables of results.")
    sub = parser.add_subparsers(dest="command", required=True)
    of = "results file (.h5) or case file, which is run first if its results are missing or older"
    since = {"type": float, "default": 0.0, "metavar": "T", "help": "leave out what is before t = T [s]"}

    p = sub.add_parser("report", help="one HTML file with pictures, tables and figures of a run")
    p.add_argument("results", help=of)
    p.add_argument("-o", "--output", help="HTML file (default: beside the results)")
    p.add_argument("--since", **since)
    p.add_argument("--modes", action="store_true", help="of a case file: also natural periods and mode shapes (hawser modes)")
    add_set(p)
    p.set_defaults(do=make_report)

    p = sub.add_parser("plot", help="one figure, as PNG, SVG or PDF")
    p.add_argument("results", help=of)
    p.add_argument("what", choices=("range", "stress", "history", "spectrum", "phase", *scene.VIEWS))
    p.add_argument("-o", "--output", help="file (default: <results>-<what>.png)")
    p.add_argument("--line", help="of a range or stress graph (default: that with the largest tension)")
    p.add_argument("--outer-diameter", type=float, metavar="D", help="m, of a pipe: stress (default: the case's)")
    p.add_argument("--wall", type=float, metavar="W", help="m, thickness of its wall: stress (default: the case's)")
    p.add_argument("--field", default="effective_tension", help="of a range graph (default: effective_tension)")
    p.add_argument("--name", help="of a history, as in output.histories (default: the first by name)")
    p.add_argument("--column", help="of a history (default: effective_tension, or the first)")
    p.add_argument("--over", help="phase: column on the horizontal axis (default: position_z)")
    p.add_argument("--time", type=float, help="of a picture: the output nearest to it [s] (default: the last)")
    p.add_argument("--since", **since)
    add_set(p)
    p.set_defaults(do=make_plot)

    p = sub.add_parser("export", help="CSV files of the tables, histories and range graphs")
    p.add_argument("results", help=of)
    p.add_argument("-o", "--output", help="folder (default: named like the results)")
    add_set(p)
    p.set_defaults(do=make_export)

    p = sub.add_parser("extremes", help="most probable maximum and quantile of a history in a duration, by fitted distributions")
    p.add_argument("results", nargs="+", metavar="RESULTS", help=of + "; of several runs of one sea state, all count")
    p.add_argument("--name", help="history, as in output.histories (default: the first by name)")
    p.add_argument("--column", help="its column (default: effective_tension, or the first)")
    p.add_argument("--duration", default="3h", metavar="T", help="for which extremes are told: 3h, '90 min', 600 (default: 3h)")
    p.add_argument("--quantile", type=float, default=0.9, metavar="P", help="not exceeded with this probability (default: 0.9)")
    p.add_argument("--minima", action="store_true", help="smallest values instead of largest")
    p.add_argument("--block", metavar="T", help="length of a block, or 'run' where each run is one (default: ten mean periods)")
    p.add_argument("--since", **since)
    p.add_argument("-o", "--output", help="also write the numbers, as .json or .csv")
    add_set(p)
    p.set_defaults(do=extremes_told.make)

    p = sub.add_parser("fatigue", help="damage along a line by rainflow cycles and a published S-N or T-N curve")
    p.add_argument("results", nargs="+", metavar="RESULTS[=SHARE]", help=of + "; of several, with their shares of the time")
    p.add_argument("--curve", required=True, choices=sorted(fatigue.CURVES))
    p.add_argument("--line", help="default: that with the largest tension")
    p.add_argument("--breaking-load", type=float, metavar="N", help="N; API curves")
    p.add_argument("--area", type=float, metavar="A", help="m², of both bars of a chain or of a rope; curves of DNV-OS-E301")
    p.add_argument("--outer-diameter", type=float, metavar="D", help="m; curves of DNV-RP-C203 (default: the case's)")
    p.add_argument("--wall", type=float, metavar="W", help="m, thickness; curves of DNV-RP-C203 (default: the case's)")
    p.add_argument("--factor", type=float, default=1.0, help="stress concentration factor (default: 1)")
    p.add_argument("--since", **since)
    p.add_argument("-o", "--output", help="CSV file (default: <results>-fatigue.csv)")
    add_set(p)
    p.set_defaults(do=make_fatigue)
    return parser


def main(arguments=None):
    options = commands().parse_args(arguments)
    try:
        options.do(options)
    except Refusal as refusal:
        print(f"hawser: {refusal}", file=sys.stderr)
        return 2
    except OSError as error:
        what = f"{error.filename}: cannot be written ({error.strerror})" if error.filename else str(error)
        print(f"hawser: {what}", file=sys.stderr)
        return 1
    except KeyError as missing:
        print(f"hawser: the results file is damaged or of another version: {missing.args[0]}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
