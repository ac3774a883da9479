"""The wind farm of cases/farm: one and two ranks agree, and every chain at rest is an elastic catenary."""
import array
import math
import os
import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

from support import ROOT, run

sys.path.insert(0, str(ROOT / "tests/bench"))
import farm  # noqa: E402

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
FOLDER = ROOT / "cases" / "farm"
CASE, FLOAT = ((FOLDER / name).read_text("utf-8") for name in ("farm.yaml", "float.yaml"))
# A chain of 100 mm (docs/user-guide/line-types.md) and the bed of the case.
WEIGHT = (19900 * 0.1**2 - 1025 * math.pi / 4 * (1.8 * 0.1) ** 2) * 9.80665  # N/m, in water
EA, RADIUS = 8.54e10 * 0.1**2, 3.35 * 0.1 / 2  # N; m, of contact
STIFFNESS, FRICTION, MOBILISATION = 100e3 * 2 * RADIUS, 0.6, 0.05  # N/m per m; coefficient; m


def root(f, low, high):
    """Zero of an increasing function."""
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if f(middle) < 0 else (low, middle)
    return low


def lying(tension, length):
    """Stretch, and tension at the anchor, of the part on the bed with this tension at its other end.

    Friction is FRICTION times WEIGHT min(1, u/MOBILISATION), u being the displacement relative to the anchor: EA u''
    = friction, so u = a sinh(k s) up to u = MOBILISATION, and the tension increases linearly beyond."""
    most = FRICTION * WEIGHT
    k = math.sqrt(most / (EA * MOBILISATION))

    def end(a):
        yields = min(length, math.asinh(MOBILISATION / a) / k)
        there, rest = EA * k * a * math.cosh(k * yields), length - yields
        return there + most * rest, a * math.sinh(k * yields) + (there + 0.5 * most * rest) * rest / EA

    a = root(lambda a: end(a)[0] - tension, 1e-12, tension / (EA * k))
    return end(a)[1], EA * k * a


def catenary(span, height, length):
    """Tension at the fairlead and at the anchor of a chain that lies in part.

    On its elastic bed it penetrates by d = WEIGHT/STIFFNESS, with the slope (d/l) exp(x/l) before liftoff, l =
    sqrt(H/STIFFNESS); a parabola with the same height and slope there has its lowest point d/2 above the lying part."""
    rise = height - RADIUS + 0.5 * WEIGHT / STIFFNESS

    def shape(h):
        hangs = root(lambda s: h / WEIGHT * (math.hypot(1, WEIGHT * s / h) - 1) + 0.5 * WEIGHT * s * s / EA - rise, 0, length)
        stretch, anchor = lying(h, length - hangs)
        return h / WEIGHT * math.asinh(WEIGHT * hangs / h) + h * hangs / EA + length - hangs + stretch, hangs, anchor

    h = root(lambda h: shape(h)[0] - span, 1e4, 1e7)
    return math.hypot(h, WEIGHT * shape(h)[1]), shape(h)[2]


def numbers(pattern, text):
    return [[float(x) for x in found.split(",")] for found in re.findall(pattern, text)]


class Farm(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def read(self, results, name, kind="d"):
        """All numbers of a data set."""
        target = self.folder / "numbers"
        result = run("h5dump", "-d", name, "-b", "LE", "-o", target, results)
        self.assertEqual(result.returncode, 0, result.stderr)
        return array.array(kind, target.read_bytes())

    def tension(self, results, name):
        """Tension of a history at every step."""
        head = run("h5dump", "-a", f"/series/{name}/columns", results).stdout.replace("\\000", "")
        columns = re.findall(r'"(\w+)"', head[head.index("DATA {"):])
        return self.read(results, f"/series/{name}")[columns.index("effective_tension")::len(columns)]

    def test_files_are_what_the_scripts_make(self):
        for script, name in [("make_rao", "float.rao"), ("make_float", "float.obj")]:
            result = run(FOLDER / f"{script}.py", self.folder / name, env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})
            self.assertEqual(result.returncode, 0, result.stderr)
            pairs = list(zip((self.folder / name).read_text("utf-8").split(), (FOLDER / name).read_text("utf-8").split(),
                             strict=True))
            self.assertGreater(len(pairs), 1000)
            for made, kept in pairs:
                if made != kept:  # only the last digit may differ, with another mathematical library
                    made, kept = float(made.strip("[],")), float(kept.strip("[],"))
                    self.assertAlmostEqual(made, kept, delta=0.002 + 1e-4 * abs(kept), msg=name)

    def test_ranks_and_statics(self):
        for ranks in (1, 2):
            result = run("mpirun", "-n", ranks, HAWSER, "run", FOLDER / "farm.yaml", "-q", "--stop-at", "5",
                         "-o", self.folder / f"{ranks}.h5", timeout=900)
            self.assertEqual(result.returncode, 0, result.stderr)
        one, two = self.folder / "1.h5", self.folder / "2.h5"
        self.assertEqual(self.read(one, "/series/time"), self.read(two, "/series/time"))
        # Chain nodes in file order: each process has one consecutive run.
        shares = [list(self.read(results, "/nodes/rank", "i")) for results in (one, two)]
        self.assertEqual(set(shares[0]), {0})
        self.assertEqual(shares[1], sorted(shares[1]))
        self.assertEqual([shares[1].count(rank) for rank in (0, 1)], [len(shares[0]) // 2] * 2)
        histories = re.findall(r"at: end_b, name: (.+)}", CASE)
        self.assertEqual(len(histories), 30)
        moved = 0
        for name in histories:
            a, b = (self.tension(results, name.replace(" ", "_")) for results in (one, two))
            self.assertEqual((len(a), len(b)), (26, 26), name)
            self.assertLess(max(abs(x - y) for x, y in zip(a, b)), 1e-6 * max(a), name)
            moved = max(moved, max(a) - min(a))
        self.assertGreater(moved, 10e3)  # N
        # Chords of 11 m where the bed lifts the chain over sqrt(T/STIFFNESS), 3 to 5 m: the position of nodes
        # matters.
        self.check_at_rest(one, 1e-3)

    def test_extremes_through_a_restart_on_other_ranks(self):
        """Seven chains, one of them cut between two ranks; the smallest tensions are those of the start."""
        case = self.folder / "chains.yaml"
        case.write_text(farm.farm(7, duration=1) + "contact: {between_lines: false}\n", "utf-8")
        tables = []
        for ranks, words in ((2, ("-o", "whole.h5")), (2, ("-o", "part.h5", "--stop-at", "0.5")),
                             (3, ("-o", "rest.h5", "--restart", "part.h5"))):
            result = run("mpirun", "-n", ranks, HAWSER, "run", case, "-q", *words, cwd=self.folder)
            self.assertEqual(result.returncode, 0, result.stderr)
            tables.append(run("h5dump", "-d", "/summary", self.folder / words[1]).stdout.split("\n", 1)[1])
        self.assertEqual(tables[0].count('"min effective tension"'), 7)
        self.assertEqual(tables[0], tables[2])
        self.assertNotEqual(tables[0], tables[1])

    def test_statics_of_fine_elements(self):
        fine = FLOAT.replace("elements: 50", "elements: 200").replace("file: float.rao", f"file: {FOLDER}/float.rao")
        (self.folder / "float.yaml").write_text(re.sub(r"(?m)^(volumes|contact|  float: .*mesh).*$", "", fine), "utf-8")
        (self.folder / "fine.yaml").write_text(re.sub(r"(?m)^(dynamics|contact).*$", "", CASE), "utf-8")
        result = run(HAWSER, "run", self.folder / "fine.yaml", "-q", timeout=900)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.check_at_rest(self.folder / "fine.h5", 5e-5)

    def check_at_rest(self, results, tolerance):
        """Tensions at both ends of every chain, and positions of anchors, fairleads and floats displaced by the
        wind."""
        # Chains are equal relative to their float and consecutive float by float.
        (drift,) = numbers(r"offset: \[([^]]*)\]", FLOAT)
        anchors, fairleads = numbers(r"anchor: \[([^]]*)\]", FLOAT), numbers(r" at: \[([^]]*)\]", FLOAT)
        (length,) = set(re.findall(r"type: chain, length: (\d+)", FLOAT))
        self.assertEqual((len(anchors), len(fairleads)), (10, 10))
        force = self.read(results, "/ends/force")[:600]
        for line, (anchor, fairlead) in enumerate(zip(10 * anchors, 10 * fairleads)):
            x, y, z = (d + f - a for d, f, a in zip(drift, fairlead, anchor))
            upper, lower = catenary(math.hypot(x, y), z, float(length))
            self.assertAlmostEqual(math.hypot(*force[6 * line + 3:6 * line + 6]) / upper, 1, delta=tolerance, msg=line)
            # The anchor holds the end of the chain slightly above its rest position, so the first metres have
            # no friction.
            self.assertAlmostEqual(math.hypot(*force[6 * line:6 * line + 2]) / lower, 1, delta=5e-3, msg=line)


if __name__ == "__main__":
    unittest.main()
