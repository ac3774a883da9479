"""Command lines: error messages with the nearest valid word, and --set of a case."""
import argparse
import difflib
import json
import math
import os
import re
import signal
import subprocess
import sys
from pathlib import Path

from .results import Refusal


class Parser(argparse.ArgumentParser):
    """Reports errors in one sentence, as the program's own commands do; exit code 2."""

    def error(self, message):
        unknown = re.match(r"unrecognized arguments: (\S+)", message)
        choice = re.match(r"argument (.+): invalid choice: '(.*)' \(choose from (.*)\)", message, re.DOTALL)
        if unknown:
            word = unknown.group(1).split("=")[0]
            options = [name for action in self._actions for name in action.option_strings]
            options += [name for sub in self._subparsers._group_actions for p in sub.choices.values() if p.prog == self.current
                        for action in p._actions for name in action.option_strings] if self._subparsers else []
            message = (f"there is no option '{word}'" + near(word, options)) if word.startswith("-") else \
                f"'{word}' is an unexpected argument"
        elif choice:
            words = re.findall(r"'([^']*)'", choice.group(3))
            message = f"{choice.group(1)} cannot be '{choice.group(2)}'{near(choice.group(2), words)} (allowed: {', '.join(words)})"
        else:
            message = re.sub(r"the following arguments are required: ", "missing arguments: ", message)
            message = re.sub(r"argument (\S+): expected one argument", r"a value is missing after \1", message)
            message = re.sub(r"argument (\S+): invalid float value: (.*)", r"\1: \2 is not a number", message)
            message = re.sub(r"^argument (\S+): ", r"\1: ", message)
        print(f"hawser: {message} (see {self.current or self.prog} --help)", file=sys.stderr)
        sys.exit(2)

    current = ""

    def parse_args(self, args=None, namespace=None):
        words = list(sys.argv[1:] if args is None else args)
        if words and self._subparsers:
            self.current = f"{self.prog} {words[0]}"
        return super().parse_args(args, namespace)


def near(word, known):
    found = difflib.get_close_matches(word, known, 1, 0.6)
    return f"; did you mean '{found[0]}'?" if found else ""


def time_from(text):
    """Time of --since, s."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0 <= value < math.inf:
        raise argparse.ArgumentTypeError(f"'{text}' is not a time of 0 s or more")
    return value


def port_from(text):
    """Port of --port."""
    if not text.isascii() or not text.isdigit() or not int(text) < 65536:
        raise argparse.ArgumentTypeError(f"'{text}' is not a port from 0 to 65535")
    return int(text)


def add_set(parser):
    """Adds --set KEY=VALUE, as for hawser run."""
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", dest="changes",
                        help="change a key of the case before it is run (see hawser run --help); repeatable")


def refuse_changes(path, changes):
    """Refuses changes of results; only a case can be changed."""
    if changes:
        raise Refusal(f"{path}: --set changes a case file that is run first; this is not a case file")


def unwind_at_interrupts():
    """Makes Ctrl-C raise KeyboardInterrupt instead of ending the process, so that commands can remove their
    temporary folders."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


def run_case(command, path, changes, *more):
    """Exit code of a command of the program with a case and its changes. The program handles Ctrl-C and ends a run
    with its results so far; if there are none, it is handled here."""
    before = signal.signal(signal.SIGINT, lambda *_: None)  # a handler is not inherited by the program, unlike SIG_IGN
    try:
        code = subprocess.run(words_of(command, path, changes, *more)).returncode
    finally:
        signal.signal(signal.SIGINT, before)
    if code == -signal.SIGINT:
        raise KeyboardInterrupt
    return code


def read_case(path, changes=()):
    """A case as read by the program (`hawser check --json`)."""
    done = subprocess.run(words_of("check", path, changes, "--json"), stdout=subprocess.PIPE)
    if done.returncode != 0:  # the program has printed the reason
        sys.exit(done.returncode)
    return json.loads(done.stdout.decode("utf-8", "surrogateescape"))


def words_of(command, path, changes, *more):
    given = [word for change in changes for word in ("--set", change)]
    return [os.environ.get("HAWSER", "hawser"), command, str(path), *more, *given]


def place_for(path, results, endings=(), what="", more=()):
    """`path` of an output file, refused unless it ends in one of `endings`, or if one of these results, their runs'
    input files or `more` would be overwritten."""
    path = Path(path)
    if endings and path.suffix not in endings:
        raise Refusal(f"{path}: {what} is a {' or '.join(filter(None, (', '.join(endings[:-1]), endings[-1])))} file")
    for known in [*more, *(file for one in results for file in one.inputs)]:
        if path.exists() and Path(known).exists() and path.samefile(known):
            raise Refusal(f"{path}: cannot be written, as this command or its run has read it ({known}); give another file with -o")
    return path
