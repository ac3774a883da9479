"""Two platforms with a shared line, cases/shared-line: at rest against separately solved catenaries, natural periods
against an independent linearisation: bars and lumped masses, hydrostatics and added mass read from the files,
numpy's eigenvalues."""
import os
import re
import shutil
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
from support import ROOT, run

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
FOLDER, DATA, STEM = ROOT / "cases/shared-line", ROOT.parent / "shared/data/umaine-semi", "IEA-15-240-RWT-UMaineSemi"
NO_WAVES = ("--set", "environment.waves=null")
G, RHO = 9.80665, 1025.0
# As in platform.yaml.
MASS, CENTRE, INERTIA, VOLUME = 2.01e7, np.array([0, 0, -2.32]), np.diag([4.25e10, 4.25e10, 2.37e10]), 20206.3
PER_LENGTH, DIAMETER, EA, CLUMP = 15.28, 0.1187, 9.702e7, 1e5
WATER = RHO * np.pi / 4 * DIAMETER**2  # kg/m
FAIRLEADS = {"port": [-29, 50.229, -14], "starboard": [-29, -50.229, -14], "shared": [58, 0, -14]}
PLACES = {"one": ([0, 0, 0], 0.0), "two": ([1600, 0, 0], np.pi)}


def hat(a):
    return np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])


def turn(angle):
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def turned(matrix, angle):
    """A matrix of forces and moments in axes rotated about z."""
    R = np.kron(np.eye(2), turn(angle))
    return R @ matrix @ R.T


def hydrostatic():
    """Stiffness with the contribution of weight (WAMIT manual 7, section 4.2), N/m ... N m/rad."""
    C = np.zeros((6, 6))
    for line in (DATA / f"{STEM}.hst").read_text("ascii").split("\n"):
        if line.strip():
            i, j, value = line.split()
            C[int(i) - 1, int(j) - 1] = RHO * G * float(value)
    C[3, 3] -= MASS * G * CENTRE[2]
    C[4, 4] -= MASS * G * CENTRE[2]
    return C


def added_mass(omega):
    """Added mass, kg, kg m, kg m²; linear between the frequencies of the file."""
    rows = {}
    for line in (DATA / f"{STEM}.1").read_text("ascii").split("\n"):
        words = line.split()
        if words and float(words[0]) > 0:
            rows.setdefault(2 * np.pi / float(words[0]), np.zeros((6, 6)))[int(words[1]) - 1, int(words[2]) - 1] = RHO * float(words[3])
        elif words and float(words[0]) < 0:  # frequency 0
            rows.setdefault(0.0, np.zeros((6, 6)))[int(words[1]) - 1, int(words[2]) - 1] = RHO * float(words[3])
    known = np.array(sorted(rows))
    return np.array([[np.interp(omega, known, [rows[w][i, j] for w in known]) for j in range(6)] for i in range(6)])


def body_mass():
    S = MASS * hat(CENTRE)
    return np.block([[MASS * np.eye(3), -S], [S, INERTIA - MASS * hat(CENTRE) @ hat(CENTRE)]])


class Model:
    """Freedoms: 6 per platform, position and rotation vector of its origin, then 3 of each free node of the ropes."""

    def __init__(self, file):
        """Nodes and initial positions from a results file; nothing else."""
        self.ropes, self.start, count = [], [np.zeros(12)], 12
        arc, place = file["nodes/arc_length"][:], file["fields/position"][0]
        for k, name in enumerate(file["lines/name"][:]):
            first, nodes = int(file["lines/first_node"][k]), int(file["lines/nodes"][k])
            name, s, x = name.decode(), arc[first:first + nodes], place[first:first + nodes]
            ends = [("one", "shared"), ("two", "shared")] if name == "shared" else [x[0], tuple(name.split("/"))]
            self.ropes.append((s, ends, count))
            self.start.append(x[1:-1].ravel())
            count += 3 * (nodes - 2)
        self.start, self.count = np.concatenate(self.start), count

    def end(self, q, end):
        """Position of an end, its freedoms, their effect on it, and its arm from the platform's origin."""
        if not isinstance(end, tuple):
            return np.array(end), [], np.zeros((3, 0)), None
        body, fairlead = end
        b = list(PLACES).index(body)
        place, heading = PLACES[body]
        u = q[6 * b:6 * b + 6]
        W = hat(u[3:])
        arm = (np.eye(3) + W + W @ W / 2) @ turn(heading) @ FAIRLEADS[fairlead]  # second order: rotations are below 0.01
        return np.array(place) + u[:3] + arm, list(range(6 * b, 6 * b + 6)), np.hstack([np.eye(3), -hat(arm)]), arm

    def assemble(self, q, push):
        """Unbalanced forces, their stiffness, and the mass of the ropes with added mass."""
        f, K, M = np.zeros(self.count), np.zeros((self.count, self.count)), np.zeros((self.count, self.count))
        C = hydrostatic()
        for b, (_, heading) in enumerate(PLACES.values()):
            own, at = turned(C, heading), slice(6 * b, 6 * b + 6)
            f[at] -= own @ q[at]
            f[6 * b + 2] += (RHO * VOLUME - MASS) * G
            f[6 * b] += push[b]
            K[at, at] += own
        for s, ends, first in self.ropes:
            nodes = [self.end(q, ends[0])]
            nodes += [(q[i:i + 3], list(range(i, i + 3)), np.eye(3), None) for i in range(first, first + 3 * (len(s) - 2), 3)]
            nodes.append(self.end(q, ends[1]))
            lengths = np.diff(s)
            pull = np.zeros((len(nodes), 3))
            for e, L in enumerate(lengths):
                (xa, da, Ja, _), (xb, db, Jb, _) = nodes[e], nodes[e + 1]
                d = xb - xa
                length = np.linalg.norm(d)
                t, T = d / length, EA * (length / L - 1)
                k = EA / L * np.outer(t, t) + T / length * (np.eye(3) - np.outer(t, t))
                for (i, J, sign), (j, H, other) in ((u, v) for u in ((da, Ja, 1), (db, Jb, -1)) for v in ((da, Ja, 1), (db, Jb, -1))):
                    K[np.ix_(i, j)] += sign * other * J.T @ k @ H
                pull[e] += T * t
                pull[e + 1] -= T * t
                m = PER_LENGTH * np.eye(3) + WATER * (np.eye(3) - np.outer(t, t))
                for x, i, J, _ in (nodes[e], nodes[e + 1]):
                    M[np.ix_(i, i)] += L / 2 * J.T @ m @ J
                pull[e:e + 2, 2] -= (PER_LENGTH - WATER) * G * L / 2
            for n, arc in enumerate(s):
                if ends[1] == ("two", "shared") and min(abs(arc - 150), abs(arc - 1318)) < 1e-6:
                    pull[n, 2] -= CLUMP * G
                    M[np.ix_(nodes[n][1], nodes[n][1])] += CLUMP * np.eye(3)
            for force, (_, i, J, arm) in zip(pull, nodes):
                f[i] += J.T @ force
                if arm is not None:  # the arm rotates, the force does not
                    K[np.ix_(i[3:], i[3:])] -= hat(force) @ hat(arm)
        return f, K, M

    def at_rest(self, push=(0, 0)):
        q = self.start.copy()
        for _ in range(30):
            f, K, _ = self.assemble(q, push)
            step = np.linalg.solve(K, f)
            q += step
            if np.abs(step).max() < 1e-9:
                return q
        raise AssertionError("no equilibrium")


class SharedLine(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if not DATA.is_dir():
            raise unittest.SkipTest(f"{DATA} is not there")
        cls.root = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.root)
        (cls.root / "farm").symlink_to(ROOT / "cases/farm")
        cls.folder = cls.root / "shared-line"
        shutil.copytree(FOLDER, cls.folder, ignore=shutil.ignore_patterns("*.h5*", "*.xdmf*", "*.png"))
        for file in DATA.iterdir():
            shutil.copy(file, cls.folder)

    def rest(self, name, *words, ranks=1):
        done = run("mpirun", "-n", ranks, HAWSER, "run", self.folder / "shared-line.yaml", "-q", "-o", self.folder / name, *NO_WAVES,
                   "--set", "dynamics=null", *words)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return h5py.File(self.folder / name)

    def check(self, file, one, two, weight, pull):
        for name, origin, exact in (("one", 0, one), ("two", 1600, two), ("weight", 0, weight)):
            data = file["series"][name]
            found = dict(zip((column.decode() for column in data.attrs["columns"]), data[0]))
            moved = [found["position_x"] - origin, found["position_z"]]
            np.testing.assert_allclose(moved, exact, atol=0.02)
        np.testing.assert_allclose(np.linalg.norm(file["ends/force"][0], axis=1)[::2], pull, rtol=3e-3)

    def test_at_rest(self):
        """Elastic catenaries and Newton's iteration on 18 unknowns."""
        for ranks in (1, 2):
            self.check(self.rest(f"free{ranks}.h5", ranks=ranks), [-0.4306561, 0.6778088], [0.4306423, 0.6778079], [200.81, -70.43327],
                       [2718964, 1995602, 1995602, 1995602, 1995602])
        push = ("--set", "farm[0].of.bodies.semi.floating.loads=[{force: [1e6, 0, 0]}]")
        self.check(self.rest("push.h5", *push), [11.04619, 0.5562556], [4.12983, 0.7168588], [209.8613, -75.44105],
                   [2497733, 2576463, 2576463, 1810302, 1810302])

    def test_coupled_modes(self):
        done = run(HAWSER, "modes", self.folder / "shared-line.yaml", "-n", 12, "-o", self.folder / "modes.h5", *NO_WAVES)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        found = [float(period) for period in re.findall(r"(?m)^ +\d+ +([\d.]+) +0\.", done.stdout)]
        self.assertEqual(len(found), 12)
        with self.rest("rest.h5") as file:
            model = Model(file)
        q = model.at_rest()
        print("platforms at rest:", q[[0, 2, 4, 6, 8, 10]])
        np.testing.assert_allclose(q[[0, 2, 6, 8]], [-0.4306561, 0.6778088, 0.4306423, 0.6778079], atol=0.02)
        _, K, ropes = model.assemble(q, (0, 0))
        for number, period in enumerate(found):
            M = ropes.copy()
            for b, (_, heading) in enumerate(PLACES.values()):
                at = slice(6 * b, 6 * b + 6)
                M[at, at] += turned(body_mass() + added_mass(2 * np.pi / period), heading)
            squares = np.linalg.eigvals(np.linalg.solve(M, K))
            self.assertLess(np.abs(squares.imag).max(), 1e-6 * np.abs(squares).max())
            own = 2 * np.pi / np.sqrt(np.sort(squares.real))[number]
            print(f"mode {number + 1}: {period:.3f} s, linearised {own:.3f} s")
            self.assertAlmostEqual(period / own, 1, delta=0.01)


if __name__ == "__main__":
    unittest.main()
