"""Positions in the model of notes and warnings of a run or a check, from the names and arc lengths in their text."""
import re

import numpy as np

from ..layout import text_of
from ..results import dictionary

LONGEST = 400  # characters


def node_at(results, line, arc):
    return line.nodes.start + int(np.abs(line.arc - arc).argmin())


def named(names, text):
    """Longest of the names that is a whole word of the text."""
    found = [name for name in names if re.search(rf"(?<![\w-]){re.escape(name)}(?![\w-])", text)]
    return max(found, key=len, default=None)


def place(results, text, volumes):
    """{'node'}, {'volume'} or {'body'}; empty if the text names no part of the model."""
    arc = re.search(r"(?:arc length|at) (-?[\d.]+(?:e[-+]?\d+)?) ?m\b(?!/)", text)
    name = named([line.name for line in results.lines], text)
    if name is None and arc and len(results.lines) == 1:
        name = results.lines[0].name
    if name is not None:
        line = results.line(name)
        end = re.search(r"\bend[_ ]([abAB])\b", text)
        at = float(arc[1]) if arc else (0.0 if end and end[1] in "aA" else line.length if end else line.length / 2)
        mass = re.search(r"masses\[(\d+)\]", text)
        masses = dictionary(dictionary(results.keys.get("lines")).get(name)).get("masses") or ()
        if mass and int(mass[1]) < len(masses):
            at = {"end_a": 0.0, "end_b": line.length}.get(masses[int(mass[1])].get("at"), masses[int(mass[1])].get("at"))
        return {"node": node_at(results, line, at)}
    volume = named(volumes, text)
    if volume is not None:
        return {"volume": volumes.index(volume)}
    body = named(results.bodies, text)
    return {} if body is None else {"body": results.bodies.index(body)}


def placed(results, texts=None):
    """[{text, kind, and a position}]"""
    volumes = [text_of(v.attrs.get("name", key)) for key, v in results.file.get("volumes", {}).items()
               if "vertices" in v and "triangles" in v and len(v["triangles"])]
    found = []
    for text in texts if texts is not None else results.messages():
        kind = "warning" if text.startswith("warning") else "note"
        short = text if len(text) <= LONGEST else text[: LONGEST - 3] + "..."
        found.append({"text": short, "kind": kind, **place(results, text, volumes)})
    return found
