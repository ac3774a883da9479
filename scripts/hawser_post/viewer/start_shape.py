"""A case before its run: the start shape from `hawser check`, and the notes of the check."""
import os
import re
import subprocess
from pathlib import Path

from ..arguments import words_of
from ..results import Refusal, Results

MOMENT = 0.001  # s, duration of the run that writes the start shape
PATIENCE = 300  # s
# Trials in order: the start shape as given, or at rest if the case requires it.
TRIALS = (("statics=false", f"dynamics.duration={MOMENT}", f"dynamics.step={MOMENT}"), (f"dynamics.duration={MOMENT}",), ())


def program(command, path, changes, *more):
    try:
        return subprocess.run(words_of(command, path, changes, *more), capture_output=True, text=True, errors="replace", timeout=PATIENCE,
                              env={**os.environ, "COLUMNS": "10000"})
    except subprocess.TimeoutExpired:
        raise Refusal(f"{path}: hawser {command} has taken more than {PATIENCE} s") from None


def notes_of(path, changes=()):
    """Notes and warnings of the check; a refused case raises Refusal with its message."""
    done = program("check", path, changes, "--quick")
    if done.returncode != 0:
        raise Refusal(error_text(done))
    return [line.strip() for line in done.stdout.splitlines() if re.match(r"\s*(note|warning): ", line)]


def error_text(done):
    """Error message of a failed program."""
    lines = [line for line in done.stderr.splitlines() if line.strip()]
    return lines[-1].removeprefix("hawser: ") if lines else f"the program has ended with code {done.returncode}"


def start_of(path, changes, folder):
    """Results with the start shape as their only output, in a file in `folder`."""
    target, why = Path(folder) / "start.h5", ""
    for sets in TRIALS:
        more = ["-o", str(target), "-q", *(["--stop-at", str(MOMENT)] if any("duration" in s for s in sets) else [])]
        done = program("run", path, [*changes, *sets], *more)
        if target.is_file():
            try:
                return Results(target, 0)
            except Refusal as refusal:
                why = str(refusal)
        why = why or error_text(done)
        target.unlink(missing_ok=True)
    raise Refusal(f"{path}: its start shape cannot be shown: {why}")
