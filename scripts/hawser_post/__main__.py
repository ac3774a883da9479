"""Commands written in Python: hawser report, plot, export, rao, extremes, fatigue, pipe, lay, compare, view and new."""
import errno
import os
import sys
import traceback
import warnings
from pathlib import Path

if __name__ == "__main__" and sys.argv[1:2] == ["view"] and sys.argv[2:] and not {"-h", "--help"} & set(sys.argv):
    print("view: reading the model ...", flush=True)  # before the imports below, which can take seconds

try:
    from . import export, extremes_report, fatigue, fatigue_report, lay, pipe_report, plot, report, responses_report, scene
    from .arguments import Parser, add_set, place_for, port_from, time_from
    from .given import modes_of, refuse_since, results_of
    from .results import Refusal
except ModuleNotFoundError as missing:
    sys.exit(f"hawser: this command needs the Python module '{missing.name}': install python3-h5py python3-matplotlib "
             "python3-scipy (scripts/install-deps does)")


# Errors of writing that have no name of a file.
NO_ROOM = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EROFS)


def make_report(options):
    results = results_of(options.results, options.changes)
    refuse_since(results, options.since)
    results.add_points(options.point)
    modes = modes_of(options.results, options.changes) if options.modes else None
    path = place_for(options.output or results.path.with_suffix(".html"), filter(None, (results, modes)), (".html", ".htm"), "a report")
    report.make(results, path, options.since or 0.0, modes, options.offsets)
    print(f"report: {path}")


def make_export(options):
    results = results_of(options.results, options.changes)
    folder = Path(options.output) if options.output else results.path.with_suffix("")
    refuse_since(results, options.since)
    results.add_points(options.point)
    for path in export.everything(results, folder, options.since or 0.0):
        print(path)


def make_view(options):
    from .viewer import view  # includes a server, which the other commands do not need
    view.make(options)


def make_new(options):
    from . import new
    new.make(options)


def make_compare(options):
    from . import compare
    compare.make(options)


def commands():
    parser = Parser(prog="hawser", description="Reports, figures and tables of results.")
    sub = parser.add_subparsers(dest="command", required=True)
    of = "results file (.h5) or case file, which is run first if its results are missing or older"
    point = {"action": "append", "default": [], "metavar": "NAME@X,Y,Z",
             "help": "also the motion and air gap of this point of the body of a history, m in its frame; repeatable"}
    since = {"type": time_from, "default": None, "metavar": "T", "help": "exclude data before t = T [s]"}

    p = sub.add_parser("report", help="one HTML file with pictures, tables and figures of a run")
    p.add_argument("results", help=of)
    p.add_argument("-o", "--output", help="HTML file (default: beside the results)")
    p.add_argument("--since", **since)
    p.add_argument("--point", **point)
    p.add_argument("--offsets", metavar="TABLE", help="add stiffness and offset curves from this table of hawser stiffness (.csv)")
    p.add_argument("--modes", action="store_true", help="add natural periods and mode shapes (hawser modes); needs a case file")
    add_set(p)
    p.set_defaults(do=make_report)

    p = sub.add_parser("plot", help="one figure, as PNG, SVG or PDF")
    p.add_argument("results", help=of)
    p.add_argument("what", choices=("range", "stress", "history", "spectrum", "phase", "offsets", "radiation", *scene.VIEWS))
    p.add_argument("-o", "--output", help="file (default: <results>-<what>.png)")
    p.add_argument("--line", help="line of a range or stress graph (default: the line with the largest tension)")
    p.add_argument("--outer-diameter", type=float, metavar="D", help="outer diameter of the pipe for stress, m (default: that of the case)")
    p.add_argument("--wall", type=float, metavar="W", help="wall thickness of the pipe for stress, m (default: that of the case)")
    p.add_argument("--field", help="field of a range graph (default: effective_tension)")
    p.add_argument("--name", help="name of a history, as in output.histories, or a point of its body, NAME@X,Y,Z (default: the first by name)")
    p.add_argument("--column", help="column of a history (default: effective_tension, or the first)")
    p.add_argument("--over", help="column on the horizontal axis of a phase diagram (default: position_z)")
    p.add_argument("--time", type=float, help="time of a picture [s]; the nearest output is drawn (default: the last)")
    p.add_argument("--since", **since)
    add_set(p)
    p.set_defaults(do=plot.make)

    p = sub.add_parser("export", help="CSV files of the tables, histories and range graphs")
    p.add_argument("results", help=of)
    p.add_argument("-o", "--output", help="folder (default: named like the results)")
    p.add_argument("--since", **since)
    p.add_argument("--point", **point)
    add_set(p)
    p.set_defaults(do=make_export)

    p = sub.add_parser("rao", help="response amplitudes and phase lags of a body in the waves of a run against the period, as table and figure")
    p.add_argument("results", nargs="+", metavar="RESULTS", help=of + "; several files, such as runs in waves of different periods, are combined; or tables (.csv) to draw or convert")
    p.add_argument("--name", help="history of the body, as in output.histories (default: the first of a body)")
    p.add_argument("--at", type=responses_report.point_from, default=[0.0, 0.0, 0.0], metavar="X,Y,Z",
                   help="point of the body whose motion is used, m in its frame (default: its origin)")
    p.add_argument("--segment", metavar="T", help="length of the segments of the spectra of an irregular sea (default: an eighth of the time)")
    p.add_argument("--since", **since)
    p.add_argument("-o", "--output", help=".csv, or .rao for `motion.rao` of a case (default: <results>-rao.csv); a figure goes beside it")
    add_set(p)
    p.set_defaults(do=responses_report.make)

    p = sub.add_parser("extremes", help="most probable maximum and quantile of a history in a duration, by fitted distributions")
    p.add_argument("results", nargs="+", metavar="RESULTS", help=of + "; several runs of one sea state are combined")
    p.add_argument("--name", help="history, as in output.histories, or a point of its body, NAME@X,Y,Z (default: the first by name)")
    p.add_argument("--column", help="column of the history (default: effective_tension, or the first)")
    p.add_argument("--duration", default="3h", metavar="T", help="duration for the extremes: 3h, '90 min', 600 (default: 3h)")
    p.add_argument("--quantile", type=float, default=0.9, metavar="P", help="probability that the quantile is not exceeded (default: 0.9)")
    p.add_argument("--minima", action="store_true", help="minima in place of maxima")
    p.add_argument("--block", metavar="T", help="length of a block, or 'run' for one block per run (default: ten mean periods)")
    p.add_argument("--since", **since)
    p.add_argument("-o", "--output", help="also write the numbers, as .json or .csv")
    add_set(p)
    p.set_defaults(do=extremes_report.make)

    p = sub.add_parser("fatigue", help="damage along a line by rainflow cycles and a published S-N or T-N curve")
    p.add_argument("results", nargs="+", metavar="RESULTS[=SHARE]", help=of + "; several files with their fractions of the time")
    p.add_argument("--curve", required=True, choices=sorted(fatigue.CURVES))
    p.add_argument("--line", help="default: the line with the largest tension")
    p.add_argument("--breaking-load", metavar="N", help="N, or with its unit ('5866 kN'); for chain the breaking load of ORQ chain of the same "
                   "size; for API curves (default: that of the case)")
    p.add_argument("--area", metavar="A", help="m², or with its unit ('11084 mm2'), of both bars of a chain or of a rope; for curves "
                   "of DNV-OS-E301 (default: by the library)")
    p.add_argument("--outer-diameter", type=float, metavar="D", help="outer diameter, m; for curves of DNV-RP-C203 (default: that of the case)")
    p.add_argument("--wall", type=float, metavar="W", help="wall thickness, m; for curves of DNV-RP-C203 (default: that of the case)")
    p.add_argument("--factor", type=float, default=1.0, help="stress concentration factor (default: 1)")
    p.add_argument("--since", **since)
    p.add_argument("-o", "--output", help="CSV file (default: <results>-fatigue.csv)")
    add_set(p)
    p.set_defaults(do=fatigue_report.make)

    p = sub.add_parser("pipe", help="strain, stress and code checks of a steel pipe on its supports and in its sagbend")
    p.add_argument("results", help=of)
    p.add_argument("--line", help="default: the first line with a pipe")
    p.add_argument("--since", **since)
    p.add_argument("-o", "--output", help="CSV file (default: <results>-pipe.csv)")
    add_set(p)
    p.set_defaults(do=pipe_report.make)

    p = sub.add_parser("lay", help="the smallest lay tension of a pipe in each of a list of water depths")
    p.add_argument("case", help="case file of a pipe lay over supports")
    p.add_argument("--depths", required=True, metavar="D,D,...", help="m")
    p.add_argument("--radii", metavar="R,R,...", help="stinger radii, m: computes a lay for each depth and radius, and the smallest "
                   "radius with an overbend utilisation of at most --utilisation (default: the radius of the case)")
    p.add_argument("--clearance", type=float, default=0.3, metavar="C", help="clearance of the pipe over the last support, m (default: 0.3)")
    p.add_argument("--utilisation", type=float, default=1.0, metavar="U",
                   help="largest utilisation in local buckling by DNV-ST-F101, in the sagbend and with --radii also in the overbend (default: 1)")
    p.add_argument("-o", "--output", help="CSV file, with a figure beside it (default: <case>-lay.csv)")
    add_set(p)
    p.set_defaults(do=lay.make)

    p = sub.add_parser("compare", help="one HTML file that compares two results: model, tables of differences, graphs")
    p.add_argument("a", metavar="A", help=of)
    p.add_argument("b", metavar="B", help="likewise")
    p.add_argument("-o", "--output", help="HTML file (default: <A>-<B>.html in the current folder)")
    add_set(p)
    p.set_defaults(do=make_compare)

    p = sub.add_parser("new", help="asks a few questions, writes a case file with one line, and shows it")
    p.add_argument("file", nargs="?", help="case file to write (.yaml)")
    p.set_defaults(do=make_new)

    p = sub.add_parser("view", help="show the model in three dimensions in a browser on this machine: results, a run in progress, or a start shape")
    p.add_argument("results", help="results file (.h5), or case file: its results if it has been run, otherwise its start shape")
    p.add_argument("--port", type=port_from, default=0, metavar="N", help="port on this machine (default: a free one)")
    p.add_argument("--no-browser", action="store_true", help="print the address without opening a browser")
    add_set(p)
    p.set_defaults(do=make_view)
    return parser


def main(arguments=None):
    options = commands().parse_args(arguments)
    if not sys.warnoptions:
        warnings.simplefilter("ignore")  # of NumPy and Matplotlib, not for users
    try:
        options.do(options)
        sys.stdout.flush()
    except Refusal as refusal:
        return failed(refusal, 2)
    except BrokenPipeError:  # the reader of the output has closed it
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except OSError as error:
        if error.filename:
            return failed(f"{error.filename}: cannot be written ({error.strerror})", 1)
        if error.errno in NO_ROOM:
            return failed(f"the output cannot be written ({os.strerror(error.errno).lower()})", 1)
        return failed(f"a results file is damaged and cannot be read ({first_line(error)})", 2)
    except Exception as error:  # internal error
        place = traceback.extract_tb(error.__traceback__)[-1]
        return failed(f"internal error: {type(error).__name__}: {first_line(error)} ({Path(place.filename).name}:{place.lineno})", 1)
    return 0


def first_line(error):
    return (str(error).splitlines() or [""])[0]


def failed(why, code):
    print(f"hawser: {why}", file=sys.stderr)
    return code


if __name__ == "__main__":
    sys.exit(main())
