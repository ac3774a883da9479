"""Parts of a case drawn in addition to lines and volumes: links, point masses and joints."""
import math

import numpy as np

from ..results import dictionary

WATER = 1025.0  # kg/m³, default of the case


def node_at(line, at):
    """Node of a line at an arc length, `end_a` or `end_b`."""
    arc = {"end_a": 0.0, "end_b": line.length}.get(at, at)
    return line.nodes.start + int(np.abs(line.arc - arc).argmin())


def end_of(results, keys, centre):
    """Position of an end of a link: {'node'}, {'body', 'at'} or {'place'}; None if its line or body is not in the
    results."""
    lines = {line.name: line for line in results.lines}
    if "anchor" in keys:
        return {"place": list(np.asarray(keys["anchor"], float) - centre)}
    if keys.get("line") in lines:
        return {"node": node_at(lines[keys["line"]], keys.get("at", 0.0))}
    if keys.get("body") in results.bodies:
        return {"body": results.bodies.index(keys["body"]), "at": list(keys.get("at") or (0, 0, 0))}
    return None


def links(results, centre):
    """[{name, ends: [a, b]}]"""
    found = []
    for name, keys in dictionary(results.keys.get("links")).items():
        ends = [end_of(results, dictionary(keys.get(key)), centre) for key in ("end_a", "end_b")]
        if all(ends):
            found.append({"name": name, "ends": ends})
    return found


def points(results):
    """[{kind, node, radius (m), name}] of buoys and weights, distinguished by buoyancy, and of joints, each once."""
    density = dictionary(dictionary(results.keys.get("environment")).get("water")).get("density") or WATER
    found, joints = [], set()
    for line in results.lines:
        keys = dictionary(dictionary(results.keys.get("lines")).get(line.name))
        for mass in keys.get("masses") or ():
            volume = mass.get("volume") or 0.0
            kind = "buoy" if density * volume > mass["mass"] else "weight"
            found.append({"kind": kind, "node": node_at(line, mass["at"]), "radius": (0.75 * volume / math.pi) ** (1 / 3), "name": ""})
        for key in ("end_a", "end_b"):
            name = dictionary(keys.get(key)).get("joint")
            if name and name not in joints:
                joints.add(name)
                found.append({"kind": "joint", "node": node_at(line, key), "radius": 0.0, "name": name})
    return found
