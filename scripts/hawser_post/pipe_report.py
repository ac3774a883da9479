"""hawser pipe: strain, stress and code checks of a pipe on its supports, in its sagbend and on the seabed."""
import numpy as np

from . import export, pipe_checks, pipe_tables, stations, stress
from .arguments import place_for
from .given import refuse_since, results_of
from .results import Refusal


def pipe_of(results, name):
    if not results.as_read:
        raise Refusal(f"{results.path}: was written by hawser {results.attribute('version')}, which did not store the case as read: "
                      "run the case again")
    pipes = [line for line in results.lines if stress.is_pipe(results, line)]
    if name:
        line = results.line(name)
        if line not in pipes:
            raise Refusal(f"{results.path}: line '{name}' has no type with 'pipe', so there is no wall to check")
        return line
    if not pipes:
        raise Refusal(f"{results.path}: no line has a type with 'pipe', whose wall could be checked")
    return pipes[0]


def make(options):
    results = results_of(options.results, options.changes)
    refuse_since(results, options.since)
    if results.modes:
        raise Refusal(f"{results.path} contains natural modes, whose amplitude is arbitrary")
    since, line = options.since or 0.0, pipe_of(results, options.line)
    path = place_for(options.output or results.path.with_name(f"{results.path.stem}-pipe.csv"), [results], (".csv",), "a table")
    beside = place_for(path.with_name(f"{path.stem}-stations.csv"), [results])
    checked = pipe_checks.of_case(results, line)
    if checked is None:
        raise Refusal(f"{results.path}: the case does not give the steel of '{line.name}': give its pipe a 'grade', and run it")
    pipe, judged = checked.description()
    print(f"{line.name}: {pipe} {np.count_nonzero(results.since(since))} outputs to t = {results.time[-1]:g} s.\n  {judged} "
          "A check is met if its value is at most 1.")
    if not checked.results.has("dnv_local_buckling"):
        print("  There is no check by DNV-ST-F101, since it needs the functional loads of statics, which the case does not have.")
    print_table(*pipe_tables.geometry(checked, since))
    print_table(*pipe_tables.for_reading(*pipe_tables.checks(checked, since)))
    if every := pipe_tables.every_step(checked):
        print_table(*every)
    at_stations = stations.table(results, line, checked.outer)
    if at_stations:
        print_table(*at_stations)
    for warning in pipe_checks.warnings(checked):
        print(f"warning: {warning}")
    keep = np.flatnonzero(results.since(since))
    columns = [np.nanmax(np.where(np.isnan(v[keep]), -np.inf, v[keep]), axis=0) for v in checked.values.values()]
    export.write(path, ["arc_length [m]", *checked.values], [row for row in zip(line.arc, *columns) if np.isfinite(row[1])])
    print(f"largest values along the line: {path}")
    if at_stations:
        export.write(beside, *stations.columns(results, line, checked.outer))
        print(f"smallest and largest values at stations, which are fixed relative to the feeder: {beside}")


def print_table(head, rows):
    """Prints a table with text left-aligned and numbers right-aligned."""
    text = [[f"{v:.4g}" if isinstance(v, float) else str(v) for v in row] for row in rows]
    widths = [max(len(row[k]) for row in [head, *text]) for k in range(len(head))]
    numbers = [any(isinstance(row[k], float) for row in rows) for k in range(len(head))]
    for row in [head, *text]:
        cells = [word.rjust(w) if number else word.ljust(w) for word, w, number in zip(row, widths, numbers)]
        print("  " + "  ".join(cells).rstrip())
    print()
