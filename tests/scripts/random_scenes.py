"""Random contact scenes, reproducible by seed: lines and bodies on meshes and shapes, over edges and corners, in
tubes, heaps and nets, on moving decks. Sizes are realistic. Optional keys keep their defaults, except friction and
the damping recommended for bouncing contact."""
import math

import scene_meshes as meshes
from scene_parts import (Scene, box_inertia, cable, chain, deck_or_box, diameter, fibre, held_by, hose, ship_motion, steel_pipe,
                         travel, weight, wire)


def edge(s):
    """A line over the edge of a deck: from a bitt to the quay, to the bed, or down to a load."""
    r = s.r
    kind = s.parts["line_types"]["line"] = cable(r) if r.random() < 0.8 else hose(r, 0.08, 0.2)
    a = 0.5 * diameter(kind)
    size = (r.uniform(10, 30), r.uniform(6, 12), r.uniform(3, 6))
    if r.random() < 0.4:
        shape = {"shape": {"box": {"centre": [-0.5 * size[0], 0, -0.5 * size[2]], "size": list(size)}}}
    else:
        n = r.randint(1, 4), r.randint(1, 3), r.randint(1, 2)
        shape = s.mesh("ship", meshes.moved(meshes.box(size, n), (-0.5 * size[0], 0, -0.5 * size[2])))
    s.body("ship", **ship_motion(r, 0.5))
    s.volume("ship", shape, body="ship", **({"friction": r.choice([0.1, 0.2, 0.3])} if r.random() < 0.6 else {}))
    y = r.choice([0.0, r.uniform(-1, 1)])
    back, down = r.uniform(2, 6), r.uniform(4, 10)
    way = r.choice(["load", "quay", "bed"])
    points = [(-back, y, a + r.choice([0.0, 0.5])), (0.0, y, a), (a, y, 0.0)]
    if way == "load":
        points.append((a, y, -down))
        s.line("line", "line", points, 40, ends=({"body": "ship", "at": list(points[0])}, "free"),
               masses=[{"at": "end_b", "mass": weight(kind) * down / 9.8 * r.uniform(2, 20)}])
    else:
        points.append((r.uniform(10, 40), y + r.choice([0, r.uniform(-5, 5)]),
                       -down if way == "bed" else -r.uniform(0.5, 2.5)))
        s.line("line", "line", points, 60, r.uniform(1.0005, 1.01), ends=({"body": "ship", "at": list(points[0])}, None))


def corner(s):
    """A line around the corner of a deck, over its edge and the vertical one, pulled by a boat or held at a quay."""
    r = s.r
    kind = s.parts["line_types"]["line"] = cable(r)
    a = 0.5 * diameter(kind)
    if r.random() < 0.5:
        shape = {"shape": {"box": {"centre": [-10, -5, -2], "size": [20, 10, 4]}}}
    else:
        shape = s.mesh("barge", meshes.moved(meshes.box((20, 10, 4), (r.randint(1, 5), r.randint(1, 3), 1)), (-10, -5, -2)))
    s.body("barge", **ship_motion(r, 0.4))
    s.volume("barge", shape, body="barge", friction=r.choice([0.1, 0.2, 0.3]))
    x, drop = -r.uniform(0.5, 3), r.uniform(0.2, 1.5)
    points = [(x - r.uniform(0, 2), -r.uniform(1, 4), a + 0.3), (x, 0, a), (x, a, 0), (a, a, -drop),
              (r.uniform(3, 10), -r.uniform(2, 8), -drop - r.uniform(0, 1))]
    end = None
    if r.random() < 0.5:
        s.body("boat", position=list(points[-1]), **travel(r, (r.uniform(-0.5, 0.5), r.uniform(-2, 0.5), 0.0)))
        end = {"body": "boat", "at": [0, 0, 0]}
    s.line("line", "line", points, 60, r.uniform(1.001, 1.03), ends=({"body": "barge", "at": list(points[0])}, end))


def j_path(r, top, bend, out):
    n = r.randint(6, 10)
    path = [(0.0, 0.0, top), (0.0, 0.0, 0.5 * top), (0.0, 0.0, 0.0)]
    angles = [0.5 * math.pi * i / n for i in range(1, n + 1)]
    path += [(bend * (1 - math.cos(t)), 0.0, -bend * math.sin(t)) for t in angles]
    return path + [(bend + 0.5 * out, 0.0, -bend), (bend + out, 0.0, -bend)]


def tube(s):
    """A cable or wire in a J-tube, pulled at its top."""
    r = s.r
    kind = s.parts["line_types"]["line"] = hose(r, 0.06, 0.15) if r.random() < 0.6 else wire(r)
    d = diameter(kind)
    bore = max(d * r.uniform(1.6, 3), 0.15)
    top, bend, out = r.uniform(3, 8), r.uniform(2.5, 5), r.uniform(2, 5)
    path = j_path(r, top, bend, out)
    s.volume("tube", s.mesh("tube", meshes.tube(path, bore, bore + 0.04, r.choice([16, 20, 24]))),
             friction=r.choice([0.1, 0.2, 0.3]))
    s.volume("floor", {"shape": {"plane": {"point": [0, 0, -bend - bore - r.uniform(0.1, 0.6)], "normal": [0, 0, 1]}}},
             friction=0.3)
    s.body("winch", position=[0, 0, top + 2], **travel(r, (0, 0, r.uniform(0.2, 1.2))))
    points = [(0.0, 0.0, top + 2)] + path + [(bend + out + 5, 0, -bend - 0.5 * bore)]
    tail = None if r.random() < 0.3 else "free"
    s.line("line", "line", points, 70, 1.02 if tail is None else 1.0, ends=({"body": "winch", "at": [0, 0, 0]}, tail),
           **({} if tail is None else {"masses": [{"at": "end_b", "mass": weight(kind) * r.uniform(3, 15) / 9.8}]}))
    if tail is None:  # a loop of slack outside for the winch to take
        s.parts["lines"]["line"]["sections"][0]["length"] += 1.5


def heap(s):
    """A line lowered into a heap on the bed or a deck, or slack in loops from the start."""
    r = s.r
    kind = s.parts["line_types"]["line"] = r.choice([chain, chain, fibre, hose])(r)
    d, height = diameter(kind), r.uniform(4, 10)
    if r.random() < 0.5:
        s.parts["environment"].update({"water": {"depth": 20.0},
                                       "seabed": {"depth": 20.0, "friction": 0.5, "damping": 5000.0}})
        floor = -20.0
    else:
        floor = 0.0
        s.volume("deck", s.mesh("deck", meshes.moved(meshes.box((20, 20, 1), (4, 4, 1)), (0, 0, -0.5))), friction=0.4,
                 relative_damping=0.2)
    if r.random() < 0.5:
        s.parts["contact"]["between_lines"] = {"friction": 0.3, "relative_damping": 0.1}
    else:
        s.parts["contact"]["between_lines"] = {"relative_damping": 0.1}
    lay = height * r.uniform(0.3, 0.8)
    top = floor + height
    s.body("hook", position=[0, 0, top], **travel(r, (r.uniform(-0.3, 0.3), 0, -r.uniform(0.5, 1.0) * min(height - 2, 6))))
    points = [(0, 0, top), (0, 0, floor + 0.6 * d + 0.3), (0.3, 0, floor + 0.6 * d),
              (0.3 + lay, r.uniform(-1, 1), floor + 0.5 * d)]
    length = height + lay
    s.line("line", "line", points, max(20, min(80, int(length / max(1.5 * d, 0.15)))), 1.0,
           ends=({"body": "hook", "at": [0, 0, 0]}, "free"))


def net(s):
    """A net between four posts with a ball or box at rest in it or dropped on it."""
    r = s.r
    kind = s.parts["line_types"]["rope"] = fibre(r, 0.01, 0.03)
    n, mesh = r.randint(3, 4), r.uniform(0.5, 1.0)
    high = r.uniform(2, 4)
    at = lambda i, j: ((i - 0.5 * (n + 1)) * mesh, (j - 0.5 * (n + 1)) * mesh, high)
    for i in range(1, n + 1):
        for j in range(1, n + 1):
            s.parts["joints"][f"k{i}{j}"] = {"start": list(at(i, j))}
    inner = lambda i, j: 1 <= i <= n and 1 <= j <= n
    end = lambda i, j: {"joint": f"k{i}{j}"} if inner(i, j) else None
    for i in range(n + 2):
        for j in range(n + 2):
            for name, k, m in (("x", i + 1, j), ("y", i, j + 1)):
                if max(k, m) <= n + 1 and (inner(i, j) or inner(k, m)) and (inner(i, j) or end(i, j) is None):
                    s.line(f"{name}{i}{j}", "rope", [at(i, j), at(k, m)], 4, 1.02, ends=(end(i, j), end(k, m)))
                    del s.parts["lines"][f"{name}{i}{j}"]["start"]
    size = r.uniform(0.8, 1.5) * mesh
    mass = 7.0 * weight(kind) * n * n * mesh / 9.8 * r.uniform(1, 10)
    if r.random() < 0.7:
        shape, low = {"shape": {"sphere": {"centre": [0, 0, 0], "radius": 0.5 * size * 1.3}}}, 0.65 * size
    else:
        shape, low = s.mesh("crate", meshes.box((1.4 * size, 1.2 * size, 0.8 * size))), 0.4 * size
    fall = r.choice([0.0, 0.0, r.uniform(0.1, 1)])
    s.body("load", position=[r.uniform(-0.1, 0.1), r.uniform(-0.1, 0.1), high + low + 0.02 + fall],
           floating={"mass": mass, "inertia": [mass * size**2 / 8] * 3, "weight": True})
    s.volume("load", shape, body="load", friction=0.3, relative_damping=0.3)
    if fall or r.random() < 0.7:
        s.statics = False


def deck(s):
    """Pipes, hoses and ropes on a deck between bulwarks of a ship in a sea."""
    r = s.r
    kind = s.parts["line_types"]["line"] = r.choice([steel_pipe, steel_pipe, hose, fibre])(r)
    a = 0.5 * diameter(kind)
    ship = r.random()
    s.body("ship", **ship_motion(r))
    shape = deck_or_box(s, ship < 0.7, 24, 6)
    damp = {"relative_damping": 0.2} if r.random() < 0.5 else {}
    s.volume("deck", shape, body="ship", friction=r.choice([0.2, 0.3, 0.4]), **damp)
    lashed = r.random() < 0.5 or not ("pipe" in kind or "EI" in kind) or ship >= 0.7
    for i in range(r.randint(1, 3)):
        y = -1.5 + 1.5 * i
        if lashed:
            points = [(-8, y, 0.4), (-6, y + 0.2, a), (6, y - 0.2, a), (8, y, 0.4)]
            s.line(f"line {i + 1}", "line", points, 50, r.uniform(1.0, 1.01),
                   ends=held_by("ship", points))
        else:
            s.line(f"line {i + 1}", "line", [(-4, y, a), (r.uniform(2, 6), y, a)], r.randint(8, 24), ends=("free", "free"))
    if not lashed:
        s.statics = False


def drum(s):
    """A rope with turns around a drum: pulled over a stationary one, or hauled off a rotating one that lifts a load."""
    r = s.r
    kind = s.parts["line_types"]["line"] = r.choice([fibre, wire, hose])(r)
    d = diameter(kind)
    a, radius = 0.5 * d, r.uniform(8, 25) * d
    half = max(4 * d, 0.3 * radius)
    if r.random() < 0.6:
        shape = s.mesh("drum", meshes.drum(radius, half, r.choice([24, 36, 48])))
    else:
        shape = {"shape": {"cylinder": {"from": [0, -half, 0], "to": [0, half, 0], "radius": radius}}}
    turn = r.random() < 0.5
    rate = r.uniform(0.05, 0.3) if turn else 0.0
    s.body("drum", **({"motion": {"rotation": {"axis": [0, 1, 0], "rate": rate}, "ramp": 2}} if turn else {}))
    s.volume("drum", shape, body="drum", friction=r.choice([0.1, 0.2, 0.3]))
    turns = r.choice([0.5, 0.5, 1.5, 2.5])
    n = int(24 * turns)
    ring, pitch = radius + 1.02 * a, 1.3 * d
    points = [(-ring, -0.5 * pitch * turns, -r.uniform(3, 8) * radius)]
    points += [(-ring * math.cos(2 * math.pi * turns * i / n), pitch * (turns * i / n - 0.5 * turns),
                ring * math.sin(2 * math.pi * turns * i / n)) for i in range(n + 1)]
    points.append((ring, 0.5 * pitch * turns, -r.uniform(3, 8) * radius))
    if turn:  # the rope is hauled off as fast as the drum turns
        s.body("hook", position=list(points[-1]), **travel(r, (0, 0, -9 * rate * radius), 1.0, 10.0))
    else:
        s.body("hook", position=list(points[-1]), **travel(r, (0, 0, -10 * r.uniform(0.002, 0.02) * radius)))
    s.line("line", "line", points, int(30 + 40 * turns), r.uniform(1.001, 1.01),
           ends=(None, {"body": "hook", "at": [0, 0, 0]}))
    if r.random() < 0.5 or turn:
        line = s.parts["lines"]["line"]
        line["end_a"] = "free"
        line["masses"] = [{"at": "end_a", "mass": weight(kind) * radius * r.uniform(5, 40) / 9.8}]
        s.statics = {"contact_friction": True} if r.random() < 0.3 else None


def lines(s):
    """Crossing lines, one of them pulled over the others."""
    r = s.r
    s.parts["line_types"]["line"] = r.choice([cable, hose, steel_pipe])(r)
    other = s.parts["line_types"]["other"] = r.choice([cable, hose])(r)
    s.parts["contact"]["between_lines"] = {"friction": r.choice([0.0, 0.2, 0.3])}
    gap = 0.5 * (diameter(s.parts["line_types"]["line"]) + diameter(other))
    span = r.uniform(6, 12)
    for i in range(r.randint(1, 2)):
        y = 1.2 * i
        s.line(f"low {i + 1}", "line", [(-span, y, 0.0), (0.0, y, -0.02), (span, y, 0.0)], 40, r.uniform(1.0, 1.01))
        del s.parts["lines"][f"low {i + 1}"]["start"]
    up = r.uniform(0.5, 2)
    angle = r.uniform(0.3, 1.5)
    c, w = math.cos(angle), math.sin(angle)
    reach = r.uniform(5, 8)
    s.body("frame", **travel(r, (r.uniform(-1, 1), r.uniform(-0.5, 0.5), -up - r.uniform(0.1, 0.6))))
    points = [(-reach * c, -reach * w, gap + up), (0.0, 0.0, gap + 0.05), (reach * c, reach * w, gap + up)]
    s.line("high", "other", points, 50, r.uniform(1.0, 1.02),
           ends=({"body": "frame", "at": list(points[0])}, {"body": "frame", "at": list(points[-1])}))


def along_side(length, beam, gap, end):
    """Taut points beside the hull, from a point on its straight side at z = -1.5 around the bow to `end`."""
    start = 0.1 * length
    stations = [start + 0.02 * i * length for i in range(21)]
    side = [(x, 0.5 * beam * meshes.hull_width(length, x) + gap) for x in stations]
    taut = []
    for p in side + [end[:2]]:  # the outer side of the convex hull in plan
        while len(taut) > 1 and ((taut[-1][0] - taut[-2][0]) * (p[1] - taut[-2][1])
                                 >= (taut[-1][1] - taut[-2][1]) * (p[0] - taut[-2][0])):
            taut.pop()
        taut.append(p)
    return [(x, y, -1.5 + (end[2] + 1.5) * (x - start) / (end[0] - start)) for x, y in taut]


def hull(s):
    """A hawser or hose along a ship's hull that yaws and sways."""
    r = s.r
    kind = s.parts["line_types"]["line"] = r.choice([wire(r, 0.03, 0.08), fibre(r, 0.05, 0.12), hose(r, 0.2, 0.5)])
    a = 0.5 * diameter(kind)
    length, beam = r.uniform(40, 80), r.uniform(10, 16)
    s.body("ship",
           motion={"harmonic": {"amplitude": [0.0, r.uniform(0, 1), r.uniform(0, 0.8)],
                                "rotation_amplitude_deg": [r.uniform(0, 4), 0.0, r.uniform(0, 5)],
                                "period": r.uniform(8, 16)}, "ramp": 5})
    s.volume("hull", s.mesh("hull", meshes.hull(length, beam, r.uniform(5, 8), r.uniform(1, 2.5))), body="ship",
             friction=r.choice([0.1, 0.25]), **({"relative_damping": 0.3} if r.random() < 0.5 else {}))
    y = 0.5 * beam
    under = r.random() < 0.4
    if under:  # below the bottom, from side to side
        x = r.uniform(-0.3, 0.1) * length
        points = [(x, -y - 3, 2), (x, -y - 1.5 * a, -1), (x, -y - 0.5, -9), (x, y + 0.5, -9), (x, y + 1.5 * a, -1),
                  (x, y + 3, 2)]
        s.line("line", "line", points, 80, r.uniform(0.93, 1.0))
    else:
        end = (r.uniform(0.5, 0.8) * length, r.uniform(0, 8), r.uniform(-3, 3))
        points = [(-0.3 * length, y + 0.3, -1.5)] + along_side(length, beam, 1.2 * a + 0.1, end)
        s.line("line", "line", points, 80, r.uniform(1.0005, 1.01), ends=({"body": "ship", "at": list(points[0])}, None))


def bodies(s):
    """Crates and balls on a moving deck, on a floor, or in a bowl."""
    r = s.r
    hard = {"per_point": 1e7}
    where = r.choice(["deck", "deck", "bowl", "floor"])
    if where == "bowl":
        s.volume("bowl", s.mesh("bowl", meshes.bowl(4, r.uniform(0.8, 1.6), 1)), normal_stiffness=hard, relative_damping=0.3,
                 friction=0.3)
    else:
        if where == "deck":
            s.body("ship", **ship_motion(r, 0.7))
        shape = deck_or_box(s, r.random() < 0.6, 20, 8)
        s.volume("deck", shape, normal_stiffness=hard, relative_damping=0.3, friction=0.4,
                 **({"body": "ship"} if where == "deck" else {}))
    for i in range(r.randint(1, 3)):
        size = [r.uniform(0.6, 1.6) for _ in range(3)]
        ball = where == "bowl" or r.random() < 0.3
        mass = 1000 * size[0] * size[1] * size[2] * r.uniform(0.3, 3)
        if ball:
            shape, half = {"shape": {"sphere": {"centre": [0, 0, 0], "radius": 0.5 * size[0]}}}, 0.5 * size[0]
            inertia = [0.1 * mass * size[0] ** 2] * 3
        else:
            shape = {"shape": {"box": {"centre": [0, 0, 0], "size": size}}} if r.random() < 0.5 else s.mesh(f"crate{i}",
                                                                                                            meshes.box(size))
            half = 0.5 * size[2]
            inertia = box_inertia(mass, size)
        x, z = -3 + 2.5 * i, half + 0.001
        if where == "bowl":
            x, z = -2 + 2 * i, half + 1.0
        s.body(f"b{i + 1}", position=[x, r.uniform(-0.2, 0.2), z],
               floating={"mass": mass, "inertia": inertia, "weight": True})
        s.volume(f"b{i + 1}", shape, body=f"b{i + 1}", normal_stiffness=hard, relative_damping=0.3, friction=0.4)
    s.statics = False


def rocks(s):
    """A pipe or cable on the bed over boulders, with an onset of current or tension."""
    r = s.r
    kind = s.parts["line_types"]["line"] = r.choice([steel_pipe(r, 0.1, 0.3), hose(r), wire(r), chain(r)])
    a = 0.5 * diameter(kind)
    s.parts["environment"].update({"water": {"depth": 50.0}, "seabed": {"depth": 50.0, "friction": 0.5, "damping": 5000.0},
                                   "current": {"speed": r.uniform(0.3, 1.5), "direction_deg": 90, "ramp": 5}})
    high = -50.0
    for i in range(r.randint(1, 3)):
        size = (r.uniform(1, 2.5), r.uniform(1, 2.5), r.uniform(0.6, 1.6))
        x = -6 + 6 * i + r.uniform(-1, 1)
        s.volume(f"rock {i + 1}",
                 s.mesh(f"rock{i}", meshes.moved(meshes.rock(r, size), (x, r.uniform(-0.4, 0.4), -50 + 0.2 * size[2]))),
                 friction=r.choice([0.3, 0.5]))
        high = max(high, -50 + 0.75 * size[2])
    z = high + 1.5 * a
    points = [(-30.0, 0.0, -50 + a), (-14.0, 0.0, z), (14.0, 0.0, z), (30.0, 0.0, -50 + a)]
    s.body("pull", position=list(points[-1]), **travel(r, (r.uniform(0, 0.1), r.uniform(-0.5, 0.5), 0.0)))
    s.line("line", "line", points, 80, r.uniform(1.0, 1.005), ends=(None, {"body": "pull", "at": [0, 0, 0]}))


def sheaves(s):
    """A rope through a ring or over sheaves and rollers, with loads at its ends or an end pulled."""
    r = s.r
    kind = s.parts["line_types"]["line"] = r.choice([fibre(r), wire(r), hose(r, 0.05, 0.15)])
    d = diameter(kind)
    a = 0.5 * d
    way = r.choice(["ring", "sheave", "rollers"])
    if way == "ring":
        bore = a + r.uniform(1, 5) * d
        thick = r.uniform(0.6, 3) * d
        radius = bore + thick
        if r.random() < 0.6:
            shape = s.mesh("ring", meshes.torus(radius, thick, r.choice([32, 48]), r.choice([8, 12, 16])))
        else:
            shape = {"shape": {"torus": {"centre": [0, 0, 0], "axis": [1, 0, 0], "radius": radius, "tube_radius": thick}}}
        s.volume("ring", shape, **({"friction": 0.2} if r.random() < 0.5 else {}))
        side = r.uniform(0.3, 1.0)
        points = [(-5.0, 0.0, -bore + a * 1.1 - 5 * side * r.uniform(0.2, 1)), (0.0, 0.0, -bore + 1.05 * a),
                  (5.0, r.uniform(-1, 1), -bore + a * 1.1 - 5 * side)]
        if r.random() < 0.5:
            points = [(x, y, -z) for x, y, z in points]
            points = [points[0], (0.0, 0.0, -bore + 1.05 * a), points[2]]
    elif way == "sheave":
        radius = r.uniform(6, 15) * d
        s.volume("sheave", s.mesh("sheave", meshes.sheave(radius, 1.5 * d, 2.5 * d, r.choice([24, 36]))),
                 **({"friction": 0.1} if r.random() < 0.5 else {}))
        ring = radius + 1.03 * a
        left, right = r.uniform(0.8, 1.57), r.uniform(0.6, 1.57)
        arc = [(-ring * math.sin(left) * 1.0, 0.0, ring * math.cos(left))] if left < 0 else []
        arc += [(ring * math.sin(t), 0.0, ring * math.cos(t)) for t in [-left + (left + right) * i / 12 for i in range(13)]]
        leg = r.uniform(2, 6)
        points = [(arc[0][0] - leg * math.cos(left), 0.0, arc[0][2] - leg * math.sin(left))] + arc
        points.append((arc[-1][0] + leg * math.cos(right), 0.0, arc[-1][2] - leg * math.sin(right)))
    else:
        n, pitch, radius = r.randint(2, 4), r.uniform(1, 2), r.uniform(0.1, 0.3)
        tops = []
        for i in range(n):
            x, z = pitch * (i - 0.5 * (n - 1)), -0.1 * (i - 0.5 * (n - 1)) ** 2
            kind_of = r.choice(["cylinder", "capsule"])
            s.volume(f"roller {i + 1}", {"shape": {kind_of: {"from": [x, -1, z], "to": [x, 1, z], "radius": radius}}})
            tops.append((x, 0.0, z + radius + 1.02 * a))
        points = [(tops[0][0] - 6, 0.0, tops[0][2] - r.uniform(0.5, 4))] + tops + [(tops[-1][0] + 6, r.uniform(-1, 1),
                                                                                    tops[-1][2] - r.uniform(0.5, 4))]
    pull = [q - p for p, q in zip(points[-2], points[-1])]
    size = math.hypot(*pull)
    by = r.uniform(0.0, 0.3)
    s.body("winch", position=list(points[-1]), **travel(r, [by * c / size for c in pull]))
    if r.random() < 0.4 and way != "rollers":
        s.line("line", "line", points, 60, 1.0, ends=("free", {"body": "winch", "at": [0, 0, 0]}),
               masses=[{"at": "end_a", "mass": weight(kind) * 5 * r.uniform(2, 20) / 9.8}])
    else:
        s.line("line", "line", points, 60, r.uniform(1.0, 1.01) + by / 12, ends=(None, {"body": "winch", "at": [0, 0, 0]}))


def lift(s):
    """A load on slings from a hook that is lowered onto a deck, or lifted off it."""
    r = s.r
    s.parts["line_types"]["sling"] = wire(r, 0.02, 0.04)
    s.parts["line_types"]["hoist"] = wire(r, 0.04, 0.06)
    size = [r.uniform(2, 5), r.uniform(2, 4), r.uniform(1, 3)]
    mass = 300 * size[0] * size[1] * size[2] * r.uniform(0.5, 2)
    high = r.choice([0.5 * size[2] + r.uniform(0.2, 1), 0.5 * size[2] + 0.01])
    if r.random() < 0.6:
        s.body("ship", **ship_motion(r, 0.4))
        keys = {"body": "ship"}
    else:
        keys = {}
    shape = deck_or_box(s, r.random() < 0.5, 20, 8)
    s.volume("deck", shape, normal_stiffness={"per_point": 5e6}, relative_damping=0.3, friction=0.3, **keys)
    s.body("load", position=[0, 0, high], floating={
        "mass": mass, "inertia": box_inertia(mass, size), "weight": True})
    s.volume("load", {"shape": {"box": {"centre": [0, 0, 0], "size": size}}}, body="load",
             normal_stiffness={"per_point": 5e6}, relative_damping=0.3, friction=0.3)
    hook, top = high + 0.5 * size[2] + r.uniform(2, 4), high + 0.5 * size[2]
    s.body("hook", position=[0, 0, hook], floating={"mass": 300, "inertia": [40, 40, 40], "weight": True})
    s.body("crane", position=[0, 0, hook + 8], **travel(r, (0, 0, r.choice([-1, 1]) * r.uniform(0.3, 1.2))))
    s.line("hoist", "hoist", [(0, 0, hook + 8), (0, 0, hook)], 12, 1.0,
           ends=({"body": "crane", "at": [0, 0, 0]}, {"body": "hook", "at": [0, 0, 0]}))
    for i, (x, y) in enumerate(((1, 1), (1, -1), (-1, 1), (-1, -1))):
        at = (0.45 * x * size[0], 0.45 * y * size[1], top)
        s.line(f"sling {i + 1}", "sling", [(0, 0, hook), at], 6, 1.001,
               ends=({"body": "hook", "at": [0, 0, 0]}, {"body": "load", "at": [at[0], at[1], 0.5 * size[2]]}))
    for line in s.parts["lines"].values():
        del line["start"]


KINDS = [edge, corner, tube, heap, net, deck, drum, lines, hull, bodies, rocks, sheaves, lift]


def scene(seed, finer=1, shorter=1):
    kind = KINDS[seed % len(KINDS)]
    out = Scene(seed, f"{kind.__name__} {seed}", finer, shorter)
    kind(out)
    return out
