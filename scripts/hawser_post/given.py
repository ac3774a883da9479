"""Arguments of command lines: results of files and cases, histories, durations."""
import os
import re
import sys
from pathlib import Path

from .arguments import read_case, refuse_changes, run_case
from .results import Refusal, Results

SECONDS = {"s": 1.0, "min": 60.0, "h": 3600.0, "d": 86400.0}


def results_of(given, changes=()):
    """A results file, or the results of a case, which is run if it or an input file is newer or there are no
    results."""
    path = Path(given)
    if path.suffix not in (".yaml", ".yml") or not path.is_file():
        refuse_changes(path, changes)
        return Results(path)
    case = read_case(path, changes)
    results = Path(case["results"] if path.is_absolute() else os.path.relpath(case["results"]))
    newest = max(Path(file).stat().st_mtime for file in case["inputs"] if Path(file).exists())
    old = not results.is_file() or results.stat().st_mtime < newest
    if old or (changes and Results(results).changes != list(changes)):
        code = run_case("run", path, changes)
        # After a solver failure, a signal or an energy error the results are still valid up to that point.
        if code not in (0, 3, 4, 130) or not results.is_file() or results.stat().st_mtime < path.stat().st_mtime:
            sys.exit(code)
    return Results(results)


def modes_of(given, changes=()):
    """Results of `hawser modes` of a case file, which is run if it is newer or there are none."""
    path = Path(given)
    if path.suffix not in (".yaml", ".yml"):
        raise Refusal(f"{path}: --modes requires a case file")
    results = path.with_name(f"{path.stem}-modes.h5")
    if not results.is_file() or results.stat().st_mtime < path.stat().st_mtime or changes:
        code = run_case("modes", path, changes, "-o", str(results))
        if code != 0:
            sys.exit(code)
    return Results(results)


def refuse_since(results, since):
    """Refuses a --since [s] that excludes all or nothing of the results."""
    if since is None:
        return
    if results.modes:
        raise Refusal(f"{results.path} contains natural modes, to which --since does not apply")
    if since > max(results.time[-1], results.step_time[-1] if results.steps else 0.0):
        raise Refusal(f"{results.path}: it has no output from t = {since:g} s on (the last one is at {results.time[-1]:g} s)")


def history_of(results, name, column):
    """A history and one of its columns; by default the first history and its tension or first column."""
    if name is None and not results.histories:
        raise Refusal(f"{results.path} has no history: request one by output.histories in the case")
    series = results.series(name) if name else results.series_at(results.histories[0])
    return series, column or ("effective_tension" if "effective_tension" in series.columns else series.columns[0])


def seconds(text):
    """A time with its unit, such as 3h, '90 min' or 600."""
    found = re.fullmatch(r"\s*([\d.]+(?:[eE][-+]?\d+)?)\s*(s|min|h|d)?\s*", text)
    try:
        value = float(found.group(1)) * SECONDS[found.group(2) or "s"]
    except (AttributeError, ValueError):
        raise Refusal(f"'{text}' is not a time: give a number with s, min, h or d, such as 3h") from None
    if not 0 < value < float("inf"):
        raise Refusal(f"'{text}' is not a time above 0")
    return value


def time_words(value):
    """The same as text: 3 h."""
    for name in ("d", "h", "min"):
        if value >= SECONDS[name] and abs(value / SECONDS[name] - round(value / SECONDS[name])) < 1e-9:
            return f"{value / SECONDS[name]:g} {name}"
    return f"{value:.4g} s"
