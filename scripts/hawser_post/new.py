"""hawser new: a short dialogue in the terminal that writes and shows a case file with one line."""
import re
import subprocess
import sys
from pathlib import Path

from . import new_case
from .arguments import near, words_of
from .results import Refusal
from .viewer import view

UNITS = {"m": 1.0, "mm": 1e-3, "cm": 1e-2, "km": 1e3, "in": 0.0254, "ft": 0.3048, "s": 1.0, "deg": 1.0, "": 1.0}


class Ended(Refusal):
    """There are no more answers."""


def ask(question, usual, read):
    """The answer converted by `read`; repeated with the reason until it is valid. An empty answer is the default."""
    while True:
        print(f"{question} [{usual}]: ", end="", flush=True)
        line = sys.stdin.readline()
        if not line:
            raise Ended("the dialogue has ended before its last question; no file was written")
        try:
            return read(line.strip() or str(usual))
        except ValueError as error:
            print(f"  {error}")


def number(low, high, unit="m"):
    """Reader of a number with or without unit, between two limits."""
    def read(text):
        found = re.fullmatch(r"([-+]?[\d.]+(?:[eE][-+]?\d+)?)\s*([a-z]*)", text)
        try:
            value = float(found[1]) * UNITS[found[2]]
        except (TypeError, ValueError, KeyError):
            raise ValueError(f"'{text}' is not a number such as 120 or 84 mm") from None
        if not low <= value <= high:
            raise ValueError(f"{value:g} {unit} is not between {low:g} and {high:g} {unit}")
        return value
    return read


def one_of(words):
    """Reader of one of several words, or its number in the list."""
    words = list(words)

    def read(text):
        if text.isascii() and text.isdigit() and 1 <= int(text) <= len(words):
            return words[int(text) - 1]
        by_case = {word.lower(): word for word in words}
        if text.lower() not in by_case:
            raise ValueError(f"'{text}' is none of {', '.join(words)}{near(text, words)}")
        return by_case[text.lower()]
    return read


def yes(text):
    if text.lower() in ("y", "yes"):
        return True
    if text.lower() in ("n", "no"):
        return False
    raise ValueError(f"'{text}' is neither yes nor no")


def target_of(text):
    path = Path(text)
    path = path if path.suffix in (".yaml", ".yml") else path.with_name(path.name + ".yaml")
    if path.exists():
        raise ValueError(f"{path} exists already; give another name")
    if not path.parent.is_dir():
        raise ValueError(f"there is no folder {path.parent}")
    return path


def dialogue():
    """The answers to the questions."""
    depth = ask("Water depth, m (from 5)", 100, number(5, 12000))
    print("Type of line")
    for k, (name, (words, _)) in enumerate(new_case.KINDS.items(), 1):
        print(f"  {k}  {name}: {words}")
    kind = ask("Which", "chain", one_of(new_case.KINDS))
    thickest = new_case.thickest(kind, depth)
    question = f"Outer diameter of the pipe, up to {thickest * 1000:g} mm in this water" if kind == "pipe" else "Diameter"
    diameter = ask(question, f"{new_case.usual_diameter(kind, depth) * 1000:g} mm", number(0.005, thickest))
    a = new_case.Answers("", depth, kind, diameter)
    if kind == "pipe":
        a.wall = ask("Wall thickness", f"{min(new_case.WALL, diameter / 10) * 1000:g} mm", number(1e-4, 0.499 * diameter))
    elif kind in ("chain", "studlink"):
        a.grade = ask(f"Grade ({', '.join(new_case.GRADES)})", "R3", one_of(new_case.GRADES))
    a.top = ask("Upper end below the surface, m", f"{min(10.0, depth / 10):g}", number(0, 0.95 * depth))
    a.distance = ask("Horizontal distance of the anchor from the upper end, m", f"{new_case.usual_distance(kind, depth, a.top, diameter):g}", number(0.1 * (depth - a.top), 1e5))
    straight = (a.distance**2 + new_case.rise(depth, a.top) ** 2) ** 0.5
    a.length = ask("Length of the line, m", f"{new_case.usual_length(kind, depth, a.top, a.distance):g}",
                   number(0.97 * straight, a.distance + new_case.rise(depth, a.top)))
    a.height = ask("Height of a regular wave, m (0: still water)", f"{new_case.usual_height(depth):g}", number(0, new_case.highest_wave(depth)))
    if a.height:
        a.period = ask("Period of the wave, s", 10, number(2, 40, "s"))
        a.direction = ask("Direction in which it travels, deg from x (180: from the anchor to the vessel)", 180, number(-360, 360, "deg"))
    a.moves = ask("Is the upper end on a vessel that moves (yes or no)", "yes" if a.height else "no", yes)
    a.title = ask("Title", f"A line of {new_case.KINDS[kind][0]}", str)
    return a


def make(options):
    path = None
    if options.file:
        try:
            path = target_of(options.file)
        except ValueError as error:
            raise Refusal(str(error)) from None
    print("A case with one line from a vessel or a fixed point to an anchor on the bed. Enter accepts the value in brackets.")
    a = dialogue()
    path = path or ask("File", "line.yaml", target_of)
    with path.open("x", encoding="utf-8") as file:
        file.write(new_case.text(a))
    print(f"case: {path}")
    code = subprocess.run(words_of("check", path, (), "--quick")).returncode
    if code != 0:
        sys.exit(code)
    print(f"run it: hawser run {path}\nview it: hawser view {path}")
    if ask("Show its start shape in the browser now (yes or no)", "yes" if sys.stdin.isatty() else "no", yes):
        print("view: reading the model ...", flush=True)
        view.show(str(path))
