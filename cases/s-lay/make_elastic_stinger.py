#!/usr/bin/env python3
"""Writes elastic-stinger.yaml: the lay of simple.yaml on a stinger that is a frame of beams, hinged to the barge.

    python3 cases/s-lay/make_elastic_stinger.py [--stiffer FACTOR]

--stiffer multiplies Young's modulus of the frame and the stiffness of its hangers.
"""
import argparse
import math
from pathlib import Path

HERE = Path(__file__).resolve().parent
HINGE = 24.0  # m along the path
STATIONS = [32, 44, 56, 68, 80, 92, 104]  # of the boxes
HUNG = [56, 80]  # stations of the hangers
HALF = 2.0  # m, from the middle to either girder


def on_path(s):
    """x, z in the barge's frame: 20 m straight, then an arc of 150 m radius."""
    a = max(0.0, s - 20) / 150
    return -30 - min(s, 20) - 150 * math.sin(a), 9 - 150 * (1 - math.cos(a))


def length(a, b):
    return f"{math.dist(a, b):.12g}"


def member(name, kind, a, b, end_a, end_b, elements):
    return (f"  {name}: {{sections: [{{type: {kind}, length: {length(a, b)}, elements: {elements}}}], "
            f"end_a: {end_a}, end_b: {end_b}}}")


def frame(barge_x):
    joints, lines = [], []
    for side, y in (("left", -HALF), ("right", HALF)):
        x, z = on_path(HINGE)
        before, tied = (x, y, z), f"{{body: barge, at: [{x:.12g}, {y:g}, {z:.12g}]}}"
        for k, s in enumerate(STATIONS, 1):
            x, z = on_path(s)
            here, name = (x, y, z), f"{side} {k}"
            joints.append(f"  {name}: {{start: [{x + barge_x:.12g}, {y:g}, {z:.12g}], rigid: true}}")
            lines.append(member(f"girder {name}", "girder", before, here, tied, f"{{joint: {name}}}", 2))
            if s in HUNG:
                at = (-50.0, y, 28.0)
                lines.append(member(f"hanger {name}", "hanger", at, here, f"{{body: barge, at: [-50, {y:g}, 28]}}",
                                    f"{{joint: {name}}}", 1))
            before, tied = here, f"{{joint: {name}}}"
    x, z = on_path(HINGE)
    ends = [((x, -HALF, z), f"{{body: barge, at: [{x:.12g}, {-HALF:g}, {z:.12g}]}}")]  # of the next brace
    for k, s in enumerate(STATIONS, 1):
        x, z = on_path(s)
        name, y = ("left", -HALF) if len(ends) % 2 == 0 else ("right", HALF)
        ends.append(((x, y, z), f"{{joint: {name} {k}}}"))
        lines.append(member(f"brace {k}", "cross", ends[-2][0], ends[-1][0], ends[-2][1], ends[-1][1], 2))
        lines.append(member(f"cross {k}", "cross", (x, -HALF, z), (x, HALF, z), f"{{joint: left {k}}}",
                            f"{{joint: right {k}}}", 2))
    return joints, lines


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--stiffer", type=float, default=1.0)
    parser.add_argument("-o", "--output", default=HERE / "elastic-stinger.yaml")
    options = parser.parse_args()
    text = (HERE / "simple.yaml").read_text(encoding="utf-8")
    joints, lines = frame(50.0)
    text = text.replace(text[:text.index("hawser: 1")],
                        "# The lay of simple.yaml on a stinger that is a frame of beams: two girders with cross beams, hinged to the\n"
                        "# barge and hung from it, roller boxes on the cross beams. Made by make_elastic_stinger.py. All units SI.\n")
    text = text.replace("title: S-lay in 100 m of water", "title: S-lay over an elastic stinger")
    types = f"""  girder:
    pipe: {{outer_diameter: 0.8, wall_thickness: 0.04, material: {{E: {212 * options.stiffer:g} GPa, density: 7850}}}}
    Cd_normal: 0.8
    Ca_normal: 1
  cross:
    pipe: {{outer_diameter: 0.6, wall_thickness: 0.02, material: {{E: {212 * options.stiffer:g} GPa, density: 7850}}}}
    Cd_normal: 0.8
    Ca_normal: 1
  hanger:                          # a bar with two hinges
    bending: false
    outer_diameter: 0.1
    mass_per_length: 40
    EA: {600 * options.stiffer:g} MN

bodies:"""
    text = text.replace("\nbodies:", types, 1)
    stinger = text.index("supports:")
    end = text.index("\nlines:")
    old = text[stinger:end]
    box = old[old.index("        above_path"):]
    path = old[old.index("    path:"):old.index("    boxes:")]
    groups = "supports:\n"
    for name, stations, on in (("ramp", [5, 10, 15, 20], ""),
                               ("stinger", STATIONS, f"    on: [{', '.join(f'cross {k}' for k in range(1, len(STATIONS) + 1))}]\n")):
        groups += f"  {name}:\n    body: barge\n    line: pipe\n{on}{path}    boxes:\n      - at: {stations}\n{box}"
    text = text[:stinger] + groups + "\njoints:                            # of girders and cross beams\n" + "\n".join(joints) + "\n" + text[end:]
    text = text.replace("\ncontact: {between_lines: false}", "\n".join(lines) + "\n\ncontact: {between_lines: false, lines: [pipe]}", 1)
    Path(options.output).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
