"""Text of a case file from a few answers: one line from an anchor on the bed to a vessel or a fixed point."""
import math
from dataclasses import dataclass

KINDS = {  # kinds of lines: name in the list, and library type, or "" for a pipe
    "chain": ("studless chain", "chain-studless"), "studlink": ("studlink chain", "chain-studlink"),
    "wire": ("wire rope with a wire core", "wire-six-strand"), "fibre-core": ("wire rope with a fibre core", "wire-six-strand-fibre-core"),
    "polyester": ("polyester rope", "polyester"), "plaited": ("plaited polyester rope", "polyester-plaited"),
    "nylon": ("nylon rope", "nylon"), "pipe": ("steel pipe", "")}
TAUT = ("polyester", "plaited", "nylon")
USUAL_DIAMETER = {"chain": 0.084, "studlink": 0.084, "wire": 0.09, "fibre-core": 0.09, "polyester": 0.16, "plaited": 0.16, "nylon": 0.16,
                  "pipe": 0.273}  # m
GRADES = ("R3", "R3S", "R4", "R4S", "R5")
DEEP = 300.0  # m, water depth from which chains and wires hang steeply under their own weight
WALL = 0.02  # m, of the default pipe


@dataclass
class Answers:
    title: str
    depth: float  # m
    kind: str
    diameter: float  # m
    grade: str = ""  # for chain
    wall: float = 0.0  # for a pipe, m
    top: float = 10.0  # m, upper end below the surface
    distance: float = 0.0  # m, horizontal distance of the anchor
    length: float = 0.0  # m
    moves: bool = False  # the upper end moves with a vessel
    height: float = 0.0  # m, wave height; 0: still water
    period: float = 0.0  # s
    direction: float = 180.0  # deg, direction of propagation


def rise(depth, top):
    return depth - top


def thickest(kind, depth):
    """m, diameter of a line: a pipe of more than a hundredth of the depth is too stiff to hang to the bed, and is pressed together there."""
    return min(5.0, max(depth / 100, 0.01)) if kind == "pipe" else 5.0


def usual_diameter(kind, depth):
    """m"""
    return float(f"{min(USUAL_DIAMETER[kind], 0.9 * thickest(kind, depth)):.3g}")


def usual_distance(kind, depth, top, diameter):
    """Horizontal distance [m] of the anchor from the upper end; for a pipe large enough for its bending."""
    deep = rise(depth, top) > DEEP
    found = rise(depth, top) * (1.6 if kind == "pipe" else 1.5 if kind in TAUT else 2.0 if deep else 5.0)
    return float(f"{max(found, 400 * diameter if kind == 'pipe' else 0.0):.2g}")


def usual_length(kind, depth, top, distance):
    """Length [m] of a line that lies on the bed at its anchor, or of a taut rope."""
    straight = math.hypot(rise(depth, top), distance)
    steep = distance < 2.5 * rise(depth, top)
    slack = 0.995 if kind in TAUT else 1.025 if not steep else 1.13 if kind == "pipe" else 1.1
    return float(f"{straight * slack:.4g}")


def highest_wave(depth):
    """m: higher ones break (McCowan, 1894: 0.78 of the depth)."""
    return min(40.0, 0.78 * depth)


def usual_height(depth):
    """m, of the wave, with half of which the vessel moves: in shallow water a tenth of it."""
    return min(4.0, depth / 10)


def element_length(a):
    """Element length [m]: a fraction of the line; for a pipe at most a few diameters; in waves a twelfth of the wave
    length."""
    limits = [a.length / 160, 15 * a.diameter] if a.kind == "pipe" else [a.length / 100]
    if a.height:
        limits.append(1.56 * a.period**2 / 12)  # deep-water wave length g T² / 2 pi
    return max(0.5, float(f"{min(limits):.2g}"))


def line_type(a):
    if a.kind == "pipe":
        return (f"  line:\n    pipe: {{outer_diameter: {a.diameter:g}, wall_thickness: {a.wall:g}}}   # m, of steel\n"
                "    stiffness_damping: 0.02   # s")
    grade = f", grade: {a.grade}" if a.grade else ""
    return f"  line: {{library: {KINDS[a.kind][1]}, diameter: {a.diameter:g}{grade}}}   # m; `hawser library` prints the library"


def text(a):
    """Text of the case file with comments."""
    element = element_length(a)
    upper = f"{{body: vessel, at: [0, 0, {-a.top:g}]}}" if a.moves else f"{{anchor: [0, 0, {-a.top:g}]}}"
    parts = [f"# Written by hawser new. Units are SI unless given, angles in degrees; z is up, from still water.\nhawser: 1\ntitle: {quoted(a.title)}"]
    waves = f"\n  waves: {{regular: {{height: {a.height:g}, period: {a.period:g}, direction_deg: {a.direction:g}}}}}   # direction of travel" if a.height else ""
    parts.append(f"environment:\n  water: {{depth: {a.depth:g}}}\n  seabed: {{depth: {a.depth:g}, friction: 0.5}}{waves}")
    parts.append(f"# Properties of the line.\nline_types:\n{line_type(a)}")
    if a.moves:
        period = a.period or 10.0
        amplitude = a.height / 4 or 1.0
        parts.append("# The vessel heaves and surges by half of the wave's amplitude; better, give its own response amplitude operators\n"
                     "# (docs/how-to/vessel.md).\nbodies:\n  vessel:\n"
                     f"    motion: {{harmonic: {{amplitude: [{amplitude:g}, 0, {amplitude:g}], period: {period:g}}}, ramp: {period:g}}}")
    parts.append("# From the upper end, A, to the anchor, B.\nlines:\n  line:\n"
                 f"    sections: [{{type: line, length: {a.length:g}, element_length: {element:g}}}]\n"
                 f"    end_a: {upper}\n    end_b: {{anchor: [{a.distance:g}, 0, {-a.depth:g}]}}")
    if a.moves or a.height:
        period = a.period or 10.0
        parts.append(f"# Statics comes first. The steps are automatic; `step: 0.05` would fix them.\ndynamics: {{duration: {6 * period:g}}}   # s")
        parts.append(f"output:\n  every: {period / 20:g}   # s, interval of pictures and range graphs\n"
                     "  histories: [{line: line, at: end_a, name: upper end}]")
    return "\n\n".join(parts) + "\n"


def quoted(title):
    """A title quoted for YAML."""
    return '"' + title.replace("\\", "\\\\").replace('"', '\\"') + '"'
