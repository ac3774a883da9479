"""What the words of a command line stand for: results of files and cases, histories, durations."""
import os
import re
import sys
from pathlib import Path

from .arguments import read_case, refuse_changes, run_case
from .results import Refusal, Results

SECONDS = {"s": 1.0, "min": 60.0, "h": 3600.0, "d": 86400.0}


def results_of(given, changes=()):
    """A results file, or that of a case, which is run if there is none yet or if the case, or a file that it reads, is newer."""
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
        # Where the solver failed, a signal came or the energy does not add up, the results say so.
        if code not in (0, 3, 4, 130) or not results.is_file() or results.stat().st_mtime < path.stat().st_mtime:
            sys.exit(code)
    return Results(results)


def modes_of(given, changes=()):
    """Results of `hawser modes` of a case file, which runs if there are none yet or if the case is newer."""
    path = Path(given)
    if path.suffix not in (".yaml", ".yml"):
        raise Refusal(f"{path}: modes are those of a case: give the case file with --modes")
    results = path.with_name(f"{path.stem}-modes.h5")
    if not results.is_file() or results.stat().st_mtime < path.stat().st_mtime or changes:
        code = run_case("modes", path, changes, "-o", str(results))
        if code != 0:
            sys.exit(code)
    return Results(results)


def refuse_since(results, since):
    """What --since [s] leaves nothing of, or has nothing to exclude."""
    if since is None:
        return
    if results.modes:
        raise Refusal(f"{results.path} holds natural modes, of which --since excludes nothing")
    if since > max(results.time[-1], results.step_time[-1] if results.steps else 0.0):
        raise Refusal(f"{results.path}: there is nothing from t = {since:g} s on (the last output is at {results.time[-1]:g} s)")


def history_of(results, name, column):
    """A history and the name of one of its columns: without names the first history, its tension or its first column."""
    if name is None and not results.histories:
        raise Refusal(f"{results.path} has no history: the case asks for them by output.histories")
    series = results.series(name) if name else results.series_at(results.histories[0])
    return series, column or ("effective_tension" if "effective_tension" in series.columns else series.columns[0])


def seconds(text):
    """A time with its unit, as 3h, '90 min' or 600."""
    found = re.fullmatch(r"\s*([\d.]+(?:[eE][-+]?\d+)?)\s*(s|min|h|d)?\s*", text)
    try:
        value = float(found.group(1)) * SECONDS[found.group(2) or "s"]
    except (AttributeError, ValueError):
        raise Refusal(f"'{text}' is no time: a number with s, min, h or d, such as 3h") from None
    if not 0 < value < float("inf"):
        raise Refusal(f"'{text}' is no time above 0")
    return value


def time_words(value):
    """The same, as it is said: 3 h."""
    for name in ("d", "h", "min"):
        if value >= SECONDS[name] and abs(value / SECONDS[name] - round(value / SECONDS[name])) < 1e-9:
            return f"{value / SECONDS[name]:g} {name}"
    return f"{value:.4g} s"
