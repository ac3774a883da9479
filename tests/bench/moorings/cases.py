"""The cases of beside_moordyn.py, and the input files of both programs for them. Published figures: the validation record of
CableDyn 0.1.1 (SMI-Lab-Inha/CableDyn, Apache-2.0); its wall times are those of one thread of an i9-13900K."""
import math
import random
from types import SimpleNamespace

GRAVITY, DENSITY = 9.80665, 1025
BED_DAMPING = 1e4  # N s/m³ on the diameter
STEPS = ("auto", 0.4, 0.2, 0.1, 0.05)


def case(**data):
    """types: name: (diameter, mass per length, EA, EI, Cd across, Cd along on the skin); lines: (fairlead, anchor, [(type,
    length)], [places of the joints between them at rest]); motion: (amplitudes of x, y, z, period), two at most; sea:
    (amplitude, angular frequency, phase); bed: N/m³ on the diameter; damping: axial, N s, None: ratio 1 a segment.
    Errors are those of `seconds`, from `since` on; goals in %; meshes and steps to choose from, coarse to fine.
    finest: the converged runs, elements and step of hawser and segments of MoorDyn; reference: published (deviation,
    peak, curvature) instead of them. timed: the duration that is timed; window: that of MoorDyn, if only a part is run."""
    usual = dict(goals=(1, 2), bed=0, damping=None, sea=[], published="", reference=None, window=data["seconds"],
                 timed=data["seconds"], moordyn_meshes=data["meshes"], columns={"MoorDyn": 1}, bends=False, finest=None)
    c = SimpleNamespace(**(usual | data))
    c.finest = c.finest or (2 * c.meshes[-1], c.steps[-1] / 2, c.meshes[-1])
    return c


def chain(fairlead, anchor, length):
    return fairlead, anchor, [("chain", length)], []


def spread(angle):
    """A line of the platform VolturnUS-S."""
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    return chain((58 * c, 58 * s, -14), (837.6 * c, 837.6 * s, -200), 850)


def cable(fairlead, anchor, outer, mass, lengths, joints):
    """Types and line of a lazy wave: buoyant between two bare parts."""
    types = {"bare": (0.16, 36.7, 469e6, 19.9e3, 1.2, 0.1), "buoyant": (outer, mass, 469e6, 19.9e3, 1.2, 0.1)}
    return dict(types=types, lines=[(fairlead, anchor, list(zip(("bare", "buoyant", "bare"), lengths)), joints)], bends=True,
                motion=[(0, 0, 3, 12)], ramp=12, since=24)


def jonswap(hs, tp, n):
    """n equally spaced frequencies with phases by chance."""
    chance, gap, peak = random.Random(1), 1.55 / n, 2 * math.pi / tp
    frequencies = [0.25 + (i + 0.5) * gap for i in range(n)]

    def density(w):
        bell = math.exp(-((w / peak - 1) / (0.07 if w < peak else 0.09))**2 / 2)
        return w**-5 * math.exp(-1.25 * (peak / w)**4) * 3.3**bell
    whole = sum(density(w) for w in frequencies)
    return [(hs / 4 * math.sqrt(2 * density(w) / whole), w, chance.uniform(0, 2 * math.pi)) for w in frequencies]


WD = dict(types={"chain": (0.252, 390, 1.674e9, 0, 1.37, 0.64)}, bed=1e5)
SURGE = WD | dict(motion=[(2, 0, 0, 10)], seconds=100, since=20, ramp=10, depth=200, finest=(400, 0.0125, 400),
                  lines=[chain((0, 0, 0), (700, 0, -200), 760)])
VOLTURNUS = dict(types={"chain": (0.333, 685, 3.27e9, 0, 1.37, 0.64)}, depth=200, bed=3e6)
SPAN = dict(seconds=60, damping=0, goals=(2,), steps=STEPS, window=6)
A = VOLTURNUS | dict(lines=[spread(a) for a in (0, 120, 240)], motion=[(4, 0, 0, 60), (1.5, 0, 1.5, 12)], seconds=300, since=60,
                     ramp=12, damping=2.5e7, meshes=(15, 20, 30, 40, 50, 70, 100, 140), steps=STEPS, finest=(280, 0.025, 280),
                     moordyn_meshes=(20, 30, 40, 50, 70, 100, 140, 200), columns={"MoorDyn": 1, "MoorDyn, FairTen": 2})
CASES = {
    "chain": case(**SURGE | dict(seconds=300), timed=1000, goals=(0.5, 0.3, 0.1), meshes=(20, 30, 40, 50, 70, 100, 140, 200),
                  steps=("auto", 0.4, 0.25, 0.2, 0.1, 0.05, 0.025)),
    "farm": case(**SURGE | dict(lines=[chain((0, y, 0), (700, y, -200), 760) for y in range(0, 5000, 50)]), goals=(1,),
                 meshes=(50,), steps=("auto", 0.4, 0.2)),
    "L5-wc": case(**WD, lines=[chain((0, 0, 0), (400, 0, -50), 410)], depth=50, motion=[(0, 0, 2, 10)], seconds=80, since=60,
                  ramp=10, goals=(10,), meshes=(41,), steps=(0.05,), finest=(164, 0.0125, 164),
                  published="CableDyn 0.97, MoorDyn-C 0.54"),
    "L5-V": case(**VOLTURNUS, lines=[chain((0, 0, -14), (779.6, 0, -200), 850)], motion=[(5, 0, 0, 90), (0, 0, 2, 12)],
                 seconds=3600, since=200, ramp=100, goals=(1.5,), meshes=(50,), steps=(0.1,),
                 reference=(206.079e3, 2850.911e3, None), published="CableDyn 18.1 to 32, OrcaFlex 14.5"),
    "L5-DPC 80": case(**SPAN, **cable((0, 0, -14), (83.875401, 0, -80), 0.29, 59.53, (68.114, 50, 15.99328),
                                      [(31.6, 0, -60.2), (71.8, 0, -70.1)]), depth=280, meshes=(68, 100, 134, 180, 240),
                      moordyn_meshes=(208,), reference=(None, 13080.6, 0.10279),
                      published="CableDyn 1.55, OrcaFlex 2.29, MoorDyn-F 249"),
    "L5-DPC 200": case(**SPAN, **cable((0, 0, -14), (108.96953, 0, -199.999951), 0.3, 60.85, (171.978, 60, 30.52968),
                                       [(47.8, 0, -156.7), (89.8, 0, -178.1)]), depth=400, meshes=(130, 180, 262, 350, 480),
                       moordyn_meshes=(224,), published="CableDyn 4.64, OrcaFlex 4.56, MoorDyn-F 145"),
    "L5-DPC 800": case(**SPAN, **cable((0, 0, -14), (349.884466, 0, -799.999769), 0.29, 59.17, (372.449, 400, 147.98487),
                                       [(119.7, 0, -341.7), (304.6, 0, -660)]), depth=1000, meshes=(230, 307, 460, 614, 920),
                       moordyn_meshes=(232,), reference=(None, 82963.2, 0.03881),
                       published="CableDyn 7.38, OrcaFlex 23.2, MoorDyn-F 243"),
    "A1": case(**A, published="at 1 %: CableDyn 2.17, MoorDyn-C 93.2 (200 segments); at 2 %: 0.94, 1.33"),
    "A2": case(**A | dict(meshes=(30, 40, 50, 70, 100), steps=("auto", 0.4, 0.2, 0.1), finest=(200, 0.05, None), goals=(1,),
                          moordyn_meshes=(50,), columns={"MoorDyn": 1}), sea=jonswap(6, 12, 80), window=30,
               published="at 1 %: CableDyn 1.64, MoorDyn-C 605; at 2 %: 1.64, 4.08"),
    "B": case(**cable((5, 0, -14), (125, 0, -80), 0.29, 59.53, (68.114, 50, 52.101), [(36.5, 0, -60.4), (76.6, 0, -70.5)]),
              depth=80, seconds=96, bed=1e5, damping=2e5, meshes=(20, 28, 40, 56, 80, 113, 160), steps=STEPS,
              finest=(480, 0.025, 240), columns={"MoorDyn": 1, "MoorDyn, FairTen": 2},
              published="at 1 %: CableDyn 0.31 (48), MoorDyn-C 6.86 (68); at 2 %: 0.24, 1.77"),
}
QUICK = {"chain": case(**SURGE | dict(seconds=40, finest=(40, 0.2, 40)), goals=(3,), meshes=(10, 20), steps=(0.4,))}


def split(line, mesh):
    """(type, length, elements) of the sections of a line."""
    total = sum(length for _, length in line[2])
    return [(name, length, max(1, round(mesh * length / total))) for name, length in line[2]]


def hawser_file(c, lines, mesh, step, seconds):
    """Lines touch the bed with their axis, as in MoorDyn."""
    diameter = next(iter(c.types.values()))[0]
    element = sum(length for _, length in lines[0][2]) / mesh
    text = ["hawser: 1", "environment:", f"  water: {{density: {DENSITY}, depth: {c.depth}}}"]
    if c.bed:
        text.append(f"  seabed: {{depth: {c.depth}, normal_stiffness: {{per_length: {c.bed * diameter}}}, "
                    f"damping: {BED_DAMPING * diameter}}}")
    if c.sea:  # elevation = height/2 cos(k x - omega t + phase); MoorDyn's: amplitude sin(omega t - k x + phase)
        text.append("  waves: {components: [" + ", ".join(
            f"{{height: {2 * a}, period: {2 * math.pi / w}, phase_deg: {90 - math.degrees(p)}}}" for a, w, p in c.sea) + "]}")
    text.append("line_types:")
    for name, (d, m, EA, EI, across, along) in c.types.items():
        beta = element * math.sqrt(m / EA) if c.damping is None else c.damping / EA
        bends = f"EI: {EI}, GJ: {EI}" if EI else "bending: false"
        text.append(f"  {name}: {{outer_diameter: {d}, contact_diameter: 1.0e-6, mass_per_length: {m}, EA: {EA}, {bends}, "
                    f"Cd_normal: {across}, Cd_axial: {along}, Ca_normal: 1, stiffness_damping: {beta}}}")
    *slow, quick = [f"harmonic: {{amplitude: {list(m[:3])}, period: {m[3]}}}, ramp: {c.ramp}" for m in c.motion]
    text += ["bodies:", f"  vessel: {{motion: {{{f'drift: {{{slow[0]}}}, ' if slow else ''}{quick}}}}}", "lines:"]
    for i, line in enumerate(lines):
        parts = ", ".join(f"{{type: {name}, length: {length}, elements: {n}}}" for name, length, n in split(line, mesh))
        text.append(f"  line {i}: {{sections: [{parts}], end_a: {{body: vessel, at: {list(line[0])}}}, "
                    f"end_b: {{anchor: {list(line[1])}}}}}")
    histories = ", ".join(f"{{line: line {i}, at: end_a, name: top {i}}}" for i in range(len(lines)))
    return "\n".join([*text, "contact: {between_lines: false}", f"dynamics: {{duration: {seconds}, step: {step}}}",
                      f"output: {{statistics_from: {min(c.since, seconds / 2)}, history_every: 0.1, histories: [{histories}]}}", ""])


def moordyn_file(c, lines, mesh, step):
    """The anchor is end A, the fairlead end B."""
    points, rows = [], []
    for line in lines:
        for i, (name, length, segments) in enumerate(reversed(split(line, mesh)), len(points) + 1):
            rows.append(f"{len(rows) + 1} {name} {i} {i + 1} {length} {segments} -")
        points += [("Fixed", line[1]), *(("Free", joint) for joint in reversed(line[3])), ("Vessel", line[0])]
    types = [f"{name} {d} {m} {EA} {-1 if c.damping is None else c.damping} {EI} {across} 1.0 {along} 0.0"
             for name, (d, m, EA, EI, across, along) in c.types.items()]
    places = [f"{i} {kind} {x} {y} {z} 0 0 0 0" for i, (kind, (x, y, z)) in enumerate(points, 1)]
    options = {"g": GRAVITY, "WtrDnsty": DENSITY, "WtrDpth": c.depth, "kBot": c.bed, "cBot": BED_DAMPING, "tScheme": "rk2",
               "dtM": step, "dtIC": 1, "TmaxIC": 20, "threshIC": 1e-4, "disableOutput": 1, "WaveKin": 7 if c.sea else 0,
               "dtWave": 0.1}
    text = ["MoorDyn"]
    for title, part in (("LINE TYPES", types), ("POINTS", places), ("LINES", rows)):
        text += [f"--- {title} ---", "names", "units", *part]
    return "\n".join([*text, "--- OPTIONS ---", *(f"{value} {name}" for name, value in options.items()), "--- END ---", ""])
