"""hawser pipe: strain, stress and the checks of codes of a pipe on its supports, in its sagbend and on the seabed."""
from pathlib import Path

import numpy as np

from . import export, pipe_checks, pipe_tables, stations, stress
from .given import refuse_since, results_of
from .results import Refusal, Results


def pipe_of(results, name):
    pipes = [line for line in results.lines if stress.is_pipe(results, line)]
    if name:
        line = results.line(name)
        if line not in pipes:
            raise Refusal(f"{results.path}: line '{name}' has no type with 'pipe', whose wall could be checked")
        return line
    if not pipes:
        raise Refusal(f"{results.path}: no line has a type with 'pipe', whose wall could be checked")
    return pipes[0]


def conditions_of(text):
    """gamma_C by part of the line, as --condition-factor has it: 0.82, or overbend=0.82,seabed=1.07."""
    found = {}
    for word in text.split(",") if text else []:
        name, _, value = word.rpartition("=")
        names = [name.strip()] if name else pipe_checks.PARTS
        try:
            factor = float(value)
        except ValueError:
            factor = np.nan
        if not set(names) <= set(pipe_checks.PARTS) or np.isnan(factor):
            raise Refusal(f"--condition-factor '{text}' is neither a number nor a list such as overbend=0.82,seabed=1.07 of "
                          f"{', '.join(pipe_checks.PARTS)}")
        if not 0.5 <= factor <= 2:
            raise Refusal(f"--condition-factor {factor:g} is no factor of DNV-ST-F101, which are near 1")
        found.update(dict.fromkeys(names, factor))
    return found


def make(options):
    results = results_of(options.results, options.changes)
    refuse_since(results, options.since)
    if results.modes:
        raise Refusal(f"{results.path} holds natural modes, and their size means nothing")
    since, line = options.since or 0.0, pipe_of(results, options.line)
    grade = options.grade or pipe_checks.grade_of(results, line)
    if grade is None:
        raise Refusal(f"{results.path}: the case does not say of which steel '{line.name}' is: give --grade, or "
                      "'grade' with the pipe of its line type")
    if not 0.005 <= options.ovality <= 0.03:
        raise Refusal(f"--ovality {options.ovality:g} is none that DNV-ST-F101 is for, 0.005 to 0.03")
    if not 0.5 <= options.material_factor <= 2:
        raise Refusal(f"--material-factor {options.material_factor:g} is no factor of DNV-ST-F101, which are near 1")
    checked = pipe_checks.Checked(results, line, grade, pipe_checks.steel_of(
        results, line, grade, safety_class=options.safety_class, fabrication=options.fabrication, ovality=options.ovality,
        material_factor=options.material_factor), conditions_of(options.condition_factor),
        Results(options.static) if options.static else None)
    pipe, judged = checked.told()
    print(f"{line.name}: {pipe} {np.count_nonzero(results.since(since))} outputs to t = {results.time[-1]:g} s.\n  {judged} "
          "A check is met up to 1.")
    if options.static:
        print(f"  Functional loads and static values are those of {options.static}.")
    print_table(*pipe_tables.geometry(checked, since))
    print_table(*pipe_tables.for_reading(*pipe_tables.checks(checked, since)))
    at_stations = stations.table(results, line, checked.outer)
    if at_stations:
        print_table(*at_stations)
    for doubt in pipe_checks.doubts(checked):
        print(f"warning: {doubt}")
    path = Path(options.output) if options.output else results.path.with_name(f"{results.path.stem}-pipe.csv")
    keep = np.flatnonzero(results.since(since))
    columns = [np.nanmax(np.where(np.isnan(v[keep]), -np.inf, v[keep]), axis=0) for v in checked.values.values()]
    export.write(path, ["arc_length [m]", *checked.values], [row for row in zip(line.arc, *columns) if np.isfinite(row[1])])
    print(f"largest values along the line: {path}")
    if at_stations:
        beside = path.with_name(f"{path.stem}-stations{path.suffix}")
        export.write(beside, *stations.columns(results, line, checked.outer))
        print(f"least and largest values at stations, which stay with the feeder: {beside}")


def print_table(head, rows):
    """Columns of words to the left, those with numbers to the right."""
    text = [[f"{v:.4g}" if isinstance(v, float) else str(v) for v in row] for row in rows]
    widths = [max(len(row[k]) for row in [head, *text]) for k in range(len(head))]
    numbers = [any(isinstance(row[k], float) for row in rows) for k in range(len(head))]
    for row in [head, *text]:
        cells = [word.rjust(w) if number else word.ljust(w) for word, w, number in zip(row, widths, numbers)]
        print("  " + "  ".join(cells).rstrip())
    print()
