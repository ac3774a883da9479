"""Parts of random scenes: a case under construction, line types from the library and by size, motions of bodies."""
import math
import random

import scene_meshes as meshes
from random_lines import text


class Scene:
    """A case under construction. `finer` multiplies the elements of all lines, `shorter` divides the longest step."""

    def __init__(self, seed, title, finer=1, shorter=1):
        self.r = random.Random(seed)
        self.title, self.finer, self.shorter = title, finer, shorter
        self.parts = {k: {} for k in ("environment", "line_types", "bodies", "volumes", "joints", "lines", "contact")}
        self.files, self.statics = {}, None
        self.longest = 0.05  # s, of shortened steps

    def mesh(self, name, mesh):
        self.files[name + ".obj"] = meshes.obj(mesh)
        return {"mesh": name + ".obj"}

    def volume(self, name, shape, **keys):
        self.parts["volumes"][name] = {**shape, **keys}

    def body(self, name, **keys):
        self.parts["bodies"][name] = keys

    def line(self, name, kind, points, elements, slack=1.0, ends=(None, None), **keys):
        """A line along points; its ends are held there unless given."""
        length = sum(math.dist(p, q) for p, q in zip(points, points[1:])) * slack
        hold = lambda end, p: {"anchor": list(p)} if end is None else end
        self.parts["lines"][name] = {
            "sections": [{"type": kind, "length": length, "elements": self.finer * elements}],
            "end_a": hold(ends[0], points[0]), "end_b": hold(ends[1], points[-1]),
            "start": {"points": [list(p) for p in points]}, **keys}
        return length

    def text(self):
        out = f"hawser: 1\ntitle: {self.title}\n"
        for key, value in self.parts.items():
            if value:
                out += f"{key}:\n" + "".join(f"  {k}: {text(v)}\n" for k, v in value.items())
        if self.statics is not None:
            out += f"statics: {text(self.statics)}\n"
        step = f", step: auto, max_step: {text(self.longest / self.shorter)}" if self.shorter > 1 else ""
        return out + f"dynamics: {{duration: 10{step}}}\noutput: {{every: 1}}\n"


def wire(r, least=0.02, most=0.06):
    return {"library": "wire-six-strand", "diameter": r.uniform(least, most), "stiffness_damping": 0.005}


def fibre(r, least=0.03, most=0.1):
    return {"library": r.choice(["nylon", "polyester-plaited", "polyester"]), "diameter": r.uniform(least, most),
            "stiffness_damping": 0.01}


def chain(r):
    return {"library": "chain-studless", "diameter": r.uniform(0.02, 0.08), "grade": "R3", "stiffness_damping": 0.005}


def cable(r):
    return r.choice([wire, fibre, fibre, chain])(r)


def hose(r, least=0.08, most=0.4):
    d = r.uniform(least, most)
    return {"outer_diameter": d, "mass_per_length": 1100 * d * d, "EA": 2e8 * d * d, "EI": 3e6 * d**4 + 50 * d,
            "GJ": 3e6 * d**4 + 50 * d, "stiffness_damping": 0.02}


def steel_pipe(r, least=0.08, most=0.3):
    d = r.uniform(least, most)
    return {"pipe": {"outer_diameter": d, "wall_thickness": d * r.uniform(0.04, 0.08)}, "stiffness_damping": 0.005}


def ship_motion(r, large=1.0):
    return {"motion": {"harmonic": {"amplitude": [0.0, large * r.uniform(0, 0.4), large * r.uniform(0.1, 1.0)],
                                    "rotation_amplitude_deg": [large * r.uniform(0, 5), large * r.uniform(0, 2.5), 0.0],
                                    "period": r.uniform(5, 12)}, "ramp": 5}}


def travel(r, by, start=1.0, end=8.0):
    """A body that moves by a vector between two times and rests before and after."""
    rows = [[t, *(s * c for c in by)] for t, s in ((0, 0.0), (start, 0.0), (0.5 * (start + end), 0.5), (end, 1.0), (12, 1.0))]
    return {"motion": {"table": {"interpolation": "monotone", "rows": rows}}}


def diameter(kind):
    if "pipe" in kind:
        return kind["pipe"]["outer_diameter"]
    if "library" in kind:
        return kind["diameter"] * (3.35 if kind["library"].startswith("chain") else 1)
    return kind["outer_diameter"]


def weight(kind):
    """Approximate weight in air, N/m."""
    d = diameter(kind)
    if "pipe" in kind:
        w = kind["pipe"]["wall_thickness"]
        return 7850 * math.pi * w * (d - w) * 9.8
    if "library" in kind:
        mass = {"chain": 19900, "wire": 3990}.get(kind["library"][:kind["library"].find("-")], 650)
        return 9.8 * mass * kind["diameter"] ** 2
    return 9.8 * kind["mass_per_length"]


def box_inertia(mass, size):
    square = [x * x for x in size]
    return [mass * (sum(square) - x) / 12 for x in square]


def deck_or_box(s, as_mesh, length, width):
    """A deck with bulwarks as a mesh, or a box, with its top at z = 0."""
    if as_mesh:
        return s.mesh("deck", meshes.deck(length, width, 0.8, 0.5))
    return {"shape": {"box": {"centre": [0, 0, -0.5], "size": [length, width, 1]}}}


def held_by(body, points, ends=(0, -1)):
    """Both ends of a line held by a body at the origin."""
    return tuple({"body": body, "at": list(points[i])} for i in ends)
