"""Random but realistic cases of lines at sea, reproducible by seed: moorings, risers and pipes laid from a vessel.
Numbers are derived from water depth, weight and stiffness."""
import math
import random


def catenary_arc(H, w, h):
    """Length and horizontal extent of a line of weight w [N/m] that leaves a level bed with horizontal tension H [N]
    and rises by h [m]."""
    s = math.sqrt(h * h + 2 * h * H / w)
    return s, H / w * math.asinh(w * s / H)


def text(values):
    """Flow-style YAML of dictionaries, lists, numbers and words."""
    if isinstance(values, dict):
        return "{" + ", ".join(f"{k}: {text(v)}" for k, v in values.items()) + "}"
    if isinstance(values, (list, tuple)):
        return "[" + ", ".join(text(v) for v in values) + "]"
    if isinstance(values, bool):
        return "true" if values else "false"
    return f"{values:.6g}" if isinstance(values, float) else str(values)


def case(title, depth, slope, types, vessel, line, more=None):
    seabed = {"depth": depth, "friction": 0.5, "damping": 5000.0}
    if slope:
        seabed["slope_deg"], seabed["slope_direction_deg"] = slope
    parts = {"environment": {"water": {"depth": depth}, "seabed": seabed}, "line_types": types,
             "bodies": {"vessel": vessel}, "lines": {"line": line}, **(more or {})}
    return f"hawser: 1\ntitle: {title}\n" + "".join(f"{k}: {text(v)}\n" for k, v in parts.items())


def vessel(r, heave):
    """Stationary, or heaving like a ship of the line's size in a sea."""
    if not heave:
        return {}
    return {"motion": {"harmonic": {"amplitude": [0.0, 0.0, r.uniform(0.3, 2.5)], "period": r.uniform(7, 16)}, "ramp": 10}}


def bed_height(depth, slope, x):
    return -depth + (math.tan(math.radians(slope[0])) * -x * math.cos(math.radians(slope[1])) if slope else 0.0)


def chain(r):
    d = r.uniform(0.06, 0.15)
    return {"outer_diameter": 1.8 * d, "mass_per_length": 19900 * d * d, "EA": 0.854e11 * d * d, "bending": False}


def rope(r):
    d = r.uniform(0.08, 0.22)
    if r.random() < 0.5:  # steel wire or polyester
        return {"outer_diameter": 0.5 * d, "mass_per_length": 0.25 * 3610 * d * d, "EA": 0.25 * 4e10 * d * d, "bending": False}
    return {"outer_diameter": 0.8 * d, "mass_per_length": 800 * d * d, "EA": 1.1e9 * d * d, "bending": False}


def water_weight(t):
    return 9.80665 * (t["mass_per_length"] - 1025 * math.pi / 4 * t["outer_diameter"] ** 2)


def mooring(r, heave):
    depth = r.uniform(40, 400)
    slope = (r.uniform(0.5, 6), r.choice([0, 180, 90])) if r.random() < 0.4 else None
    top = -r.uniform(2, 15)
    types = {"chain": chain(r)}
    lengths = r.randint(1, 3)
    w = water_weight(types["chain"])
    # Horizontal tension with which the line lifts off some depths away from the fairlead.
    H = w * depth * r.uniform(0.2, 3)
    reach = r.uniform(1.05, 2.5)
    s, x = catenary_arc(H, w, depth + top)
    s, x = reach * s, x + (reach - 1) * s
    sections = [("chain", s)]
    if lengths > 1:
        types["rope"] = rope(r)
        share = r.uniform(0.2, 0.5)
        sections = [("chain", s * (1 - share)), ("rope", s * share)]
    if lengths > 2:
        types["top"] = dict(types["chain"])
        sections.append(("top", r.uniform(10, 40)))
    length = sum(l for _, l in sections)
    # The bed at the anchor may be higher or deeper; the excess length over the span is kept.
    anchor_z = bed_height(depth, slope, -x)
    span = math.hypot(x, depth + top)
    slack = length / span
    x = math.sqrt(max((length / max(slack, 1.002)) ** 2 - (top - anchor_z) ** 2, (0.2 * length) ** 2))
    anchor_z = bed_height(depth, slope, -x)
    line = {"sections": [{"type": t, "length": l, "element_length": max(1.0, length / 120)} for t, l in sections],
            "end_a": {"anchor": [-x, 0.0, anchor_z]}, "end_b": {"body": "vessel", "at": [0.0, 0.0, top]}}
    masses = []
    for _ in range(r.choice([0, 0, 1, 2])):
        at = length * r.uniform(0.3, 0.9)
        if r.random() < 0.5:  # a clump weight or a buoy with the weight of some metres of chain
            masses.append({"at": at, "mass": w * r.uniform(5, 40) / 9.8, "volume": w * r.uniform(0.2, 4) / 9.8 / 7850})
        else:
            m = w * r.uniform(2, 15) / 9.8
            masses.append({"at": at, "mass": m, "volume": m * r.uniform(1.5, 4) / 1025, "Ca": 0.5, "drag_area": 1.0})
    if masses:
        line["masses"] = masses
    return case("mooring", depth, slope, types, vessel(r, heave), line)


def pipe(r, least=0.15, most=0.4):
    """A steel pipe, empty or full."""
    d = r.uniform(least, most)
    wall = d * r.uniform(0.04, 0.08)
    inner = d - 2 * wall
    area, second = math.pi / 4 * (d * d - inner * inner), math.pi / 64 * (d**4 - inner**4)
    mass = 7850 * area + 800 * math.pi / 4 * inner * inner
    return {"outer_diameter": d, "mass_per_length": mass, "EA": 2.07e11 * area, "EI": 2.07e11 * second,
            "GJ": 0.8e11 * 2 * second, "stiffness_damping": 0.005}


def riser(r, heave):
    depth = r.uniform(100, 600)
    slope = (r.uniform(0.5, 4), r.choice([0, 180])) if r.random() < 0.3 else None
    top = -r.uniform(2, 20)
    flexible = r.random() < 0.5
    types = {"pipe": pipe(r)}
    if flexible:
        t = types["pipe"]
        t["EI"], t["GJ"], t["EA"] = 2e5 * t["outer_diameter"] ** 3 * 50, 1e6 * t["outer_diameter"] ** 2, t["EA"] / 10
        t["mass_per_length"] = 1025 * math.pi / 4 * t["outer_diameter"] ** 2 * r.uniform(1.3, 2.5)
    w = water_weight(types["pipe"])
    H = w * depth * r.uniform(0.1, 0.6)
    s, x = catenary_arc(H, w, depth + top)
    bed = r.uniform(0.2, 1.0) * depth
    sections = [("pipe", s + bed)]
    if r.random() < 0.5:  # a lazy wave: buoyancy modules with twice the pipe's weight
        t = dict(types["pipe"])
        t["outer_diameter"] = math.sqrt(t["outer_diameter"] ** 2 + 4 / math.pi * w * r.uniform(1.5, 2.5) / 9.80665 / 1025)
        types["modules"] = t
        lift = s * r.uniform(0.15, 0.3)
        first = s * r.uniform(0.4, 0.6)
        sections = [("pipe", first), ("modules", lift), ("pipe", 1.1 * s - first - 0.3 * lift + bed)]
    length = sum(l for _, l in sections)
    x += bed
    line = {"sections": [{"type": t, "length": l, "element_length": max(2.0, length / 150)} for t, l in sections],
            "end_a": {"body": "vessel", "at": [0.0, 0.0, top]},
            "end_b": {"anchor": [x, 0.0, bed_height(depth, slope, x)]}}
    if r.random() < 0.4:
        angle = math.atan(w * s / H)
        line["end_a"].update({"direction": [math.cos(angle), 0.0, -math.sin(angle)], "rotational_stiffness": 1e4})
    out = case("riser", depth, slope, types, vessel(r, heave), line)
    if r.random() < 0.4:
        current = text({"speed": r.uniform(0.1, 1), "exponent": 0.143, "direction_deg": r.choice([0, 90, 180])})
        out = out.replace("water: {depth", f"current: {current}, water: {{depth")
    return out


def lay(r, heave):
    """A pipe from the tensioner over a stinger of rollers to the bed on which it was laid."""
    depth = r.uniform(30, 150)
    types = {"pipe": pipe(r, 0.2, 0.5)}
    w = abs(water_weight(types["pipe"])) + 100.0
    types["pipe"]["mass_per_length"] = w / 9.80665 + 1025 * math.pi / 4 * types["pipe"]["outer_diameter"] ** 2
    d = types["pipe"]["outer_diameter"]
    radius = max(250 * d, 70.0) * r.uniform(1, 1.5)
    H = w * depth * r.uniform(1.0, 3)
    # The stinger turns the pipe from level to the slope of the catenary at its end, some metres above the
    # water.
    deck = r.uniform(4, 9)
    angle = 0.1
    for _ in range(60):
        drop = radius * (1 - math.cos(angle))
        h = depth + deck - drop
        s, _ = catenary_arc(H, w, h)
        angle = 0.5 * (angle + math.atan(w * s / H))
    s, x = catenary_arc(H, w, h)
    arc = radius * angle
    rollers = max(4, int(arc / 8))
    bed = r.uniform(0.5, 2) * depth
    tensioner = 15.0
    length = tensioner + arc + s + bed
    points = [[0.0, 0.0, deck], [tensioner, 0.0, deck]]
    for i in range(1, 9):
        a = angle * i / 8
        points.append([tensioner + radius * math.sin(a), 0.0, deck - radius * (1 - math.cos(a))])
    x0, z0 = points[-1][0], points[-1][2]
    low = -depth + 0.5 * d
    for i in range(1, 13):  # down along the catenary from the stinger
        left = s * (1 - i / 12)
        z = H / w * (math.sqrt(1 + (w * left / H) ** 2) - 1)
        points.append([x0 + x - H / w * math.asinh(w * left / H), 0.0, max(low, low + (z0 - low) * z / max(h, 1e-9))])
    points.append([points[-1][0] + bed, 0.0, -depth])
    volumes = {}
    for i in range(rollers):
        a = angle * i / (rollers - 1)
        big = radius - 0.5 * d - 0.2
        c = [tensioner + big * math.sin(a), 0.0, deck - radius + big * math.cos(a)]
        volumes[f"roller {i + 1}"] = {"shape": {"cylinder": {"from": [c[0], -1.5, c[2]], "to": [c[0], 1.5, c[2]], "radius": 0.2}},
                                      "body": "vessel", "normal_stiffness": "auto"}
    line = {"sections": [{"type": "pipe", "length": length, "element_length": max(1.0, length / 250)}],
            "end_a": {"body": "vessel", "at": [0.0, 0.0, deck]},
            "end_b": {"anchor": [points[-1][0], 0.0, -depth]}, "start": {"points": points}}
    return case("lay", depth, None, types, vessel(r, heave), line, {"volumes": volumes})


KINDS = [mooring, riser, lay]


def random_case(seed, heave=False):
    r = random.Random(seed)
    out = KINDS[seed % 3](r, heave)
    if heave:
        out += "dynamics: {duration: 30, step: auto}\n"
    return out
