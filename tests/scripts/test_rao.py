"""hawser rao: responses of a spar on linear springs against its frequency-domain equations, in a regular wave and in
white noise, and those of the VolturnUS-S if its files are available."""
import csv
import gzip
import json
import os
import shutil
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
DATA = ROOT.parent / "shared/data"
DENSITY, GRAVITY = 1025.0, 9.80665
SPAR = """\
hawser: 1
environment:
  water: {density: 1025, depth: 200}
  waves: WAVES
bodies:
  spar:
    position: PLACE
    rotation_deg: [0, 0, HEADING]
    floating:
      mass: 2.8e7
      centre_of_mass: [0, 0, -54]
      inertia: [4.5e10, 4.5e10, 1.5e9]
      hydrodynamics: {wamit: spar, displaced_volume: 27317.07317, damping: DAMPING, stiffness: STIFFNESS, follow_period: FOLLOW}
dynamics: {duration: DURATION, step: STEP, rho_infinity: 1}
output: {every: 1000, histories: [{body: spar, name: the spar}]}
"""
STIFFNESS = np.diag([7.5e4, 7.5e4, 3.4e4, 1e8, 1e8, 3.4e7])
STIFFNESS[0, 4] = STIFFNESS[4, 0] = -1.2e6
STIFFNESS[1, 3] = STIFFNESS[3, 1] = 1.2e6
DAMPING = np.diag([4e5, 4e5, 2e6, 3e9, 3e9, 1e7])


def rows_of(matrix):
    return json.dumps(matrix.tolist())


def text_of(stem, ending):
    """Lines of a file that may be compressed."""
    path = Path(f"{stem}{ending}")
    return (path.read_text() if path.exists() else gzip.decompress(Path(f"{path}.gz").read_bytes()).decode()).splitlines()


class Reference:
    """[-w² (M + A) + i w (B + B_added) + C] xi = X of WAMIT's files, ULEN 1, about the body's origin."""

    def __init__(self, stem, mass, centre, inertia, added_damping, stiffness):
        radiation = [line.split() for line in text_of(stem, ".1")]
        self.omegas = sorted({2 * np.pi / float(r[0]) for r in radiation if float(r[0]) > 0})
        self.A, self.B, self.X = {}, {}, {}
        for r in radiation:
            if float(r[0]) > 0:
                omega = min(self.omegas, key=lambda w: abs(w - 2 * np.pi / float(r[0])))
                i, j = int(r[1]) - 1, int(r[2]) - 1
                self.A.setdefault(omega, np.zeros((6, 6)))[i, j] = DENSITY * float(r[3])
                self.B.setdefault(omega, np.zeros((6, 6)))[i, j] = DENSITY * omega * float(r[4])
        for line in text_of(stem, ".3"):
            r = [float(word) for word in line.split()]
            omega = min(self.omegas, key=lambda w: abs(w - 2 * np.pi / r[0]))
            self.X.setdefault((omega, r[1]), np.zeros(6, complex))[int(r[2]) - 1] = DENSITY * GRAVITY * complex(r[5], r[6])
        z = centre
        self.M = np.diag([mass, mass, mass, inertia[0] + mass * z**2, inertia[1] + mass * z**2, inertia[2]])
        self.M[0, 4] = self.M[4, 0] = mass * z
        self.M[1, 3] = self.M[3, 1] = -mass * z
        self.C = stiffness.copy()
        for line in text_of(stem, ".hst"):
            i, j, value = line.split()
            if {int(i), int(j)} not in ({4, 6}, {5, 6}):
                self.C[int(i) - 1, int(j) - 1] += DENSITY * GRAVITY * float(value)
        self.C[3, 3] -= mass * GRAVITY * z
        self.C[4, 4] -= mass * GRAVITY * z
        self.damping = added_damping

    def at(self, omega, direction):
        """Linear interpolation between the frequencies of the files."""
        n = np.clip(np.searchsorted(self.omegas, omega), 1, len(self.omegas) - 1)
        low, high = self.omegas[n - 1], self.omegas[n]
        s = (omega - low) / (high - low)
        A, B = ((1 - s) * of[low] + s * of[high] for of in (self.A, self.B))
        X = (1 - s) * self.X[low, direction] + s * self.X[high, direction]
        return np.linalg.solve(-omega**2 * (self.M + 0.5 * (A + A.T)) + 1j * omega * (0.5 * (B + B.T) + self.damping) + self.C, X)


def table(path):
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    values = np.array([[float(x) for x in row] for row in rows[1:]])
    amplitude = values[:, 2:14:2] * np.repeat([1, np.pi / 180], 3)
    return 2 * np.pi / values[:, 0], values[:, 1], amplitude * np.exp(-1j * np.radians(values[:, 3:14:2])), values[:, 14:20]


def off(found, exact):
    """Largest difference, relative to the largest value of its kind."""
    size = np.repeat([np.abs(exact[:3]).max(), np.abs(exact[3:]).max()], 3)
    return float(np.max(np.abs(found - exact) / size))


class Responses(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        for ending in (".1", ".3", ".hst"):
            shutil.copy(ROOT / f"docs/tutorial/spar{ending}", self.folder)
        self.spar = Reference(self.folder / "spar", 2.8e7, -54.0, [4.5e10, 4.5e10, 1.5e9], DAMPING, STIFFNESS)

    def motion(self, name, waves, duration, place="[0, 0, 0]", heading=0, follow=100, step=0.1):
        text = SPAR if waves else SPAR.replace("  waves: WAVES\n", "")
        for key, value in (("WAVES", waves), ("PLACE", place), ("HEADING", heading), ("FOLLOW", follow), ("DURATION", duration), ("STEP", step),
                           ("DAMPING", rows_of(DAMPING)), ("STIFFNESS", rows_of(STIFFNESS))):
            text = text.replace(key, str(value))
        write(self.folder, f"{name}.yaml", text)
        done = run(HAWSER, "run", f"{name}.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return f"{name}.h5"

    def rao(self, *words):
        done = run(HAWSER, "rao", *words, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_regular_waves(self):
        """Waves of three periods at a displaced spar with a heading, for its origin and for another point."""
        results, omegas = [], (1.0, 0.6, 0.35)
        for k, omega in enumerate(omegas):
            waves = f"{{regular: {{height: 0.2, period: {2 * np.pi / omega:.15g}, direction_deg: 110, phase_deg: 25}}, ramp: 60}}"
            results.append(self.motion(f"wave{k}", waves, 600, "[300, -200, 0]", 50, 0))
        printed = self.rao(*results)
        self.assertIn("wave0.h5: spar at (0, 0, 0) in its frame, from t = 300 to 600 s; regular wave of 0.1 m amplitude", printed)
        omega, direction, found, explained = table(self.folder / "wave0-rao.csv")
        np.testing.assert_allclose(omega, omegas, rtol=1e-8)
        np.testing.assert_allclose(direction, 60, atol=1e-6)
        for k, w in enumerate(omegas):
            exact = self.spar.at(w, 60)
            print(f"regular wave at {w} rad/s: off by {off(found[k], exact):.1e}")
            self.assertLess(off(found[k], exact), 5e-3)
            self.assertGreater(explained[k, [0, 2, 4]].min(), 0.999)
        self.assertGreater((self.folder / "wave0-rao.png").stat().st_size, 10000)
        # A point: xi + theta x r.
        r = np.array([3.0, 20.0, -54.0])
        self.rao(*results, "--at", "3,20,-54", "-o", "point.csv")
        _, _, moved, _ = table(self.folder / "point.csv")
        for k in range(3):
            exact = found[k].copy()
            exact[:3] += np.cross(exact[3:], r)
            self.assertLess(off(moved[k], exact), 2e-4)

    def test_quadratic_damping_by_a_matrix(self):
        """A diagonal matrix damps like six numbers. If heave acts on surge, the spar moves along -x, with the
        sign of its velocity."""
        found = {}
        mixed = np.diag([1e6, 1e6, 1e7, 1e10, 1e10, 1e8])
        mixed[0, 2] = 5e6
        for name, damping in (("numbers", [1e6, 1e6, 1e7, 1e10, 1e10, 1e8]), ("rows", np.diag([1e6, 1e6, 1e7, 1e10, 1e10, 1e8]).tolist()),
                              ("mixed", mixed.tolist())):
            text = SPAR.replace("  waves: WAVES\n", "").replace("\ndynamics:", "\nstatics: false\ndynamics:").replace(
                "      hydrodynamics: {", f"      velocity: [0, 0, 1]\n      hydrodynamics: {{quadratic_damping: {damping}, ")
            for key, value in (("PLACE", "[0, 0, 0]"), ("HEADING", 0), ("FOLLOW", 0), ("DURATION", 4), ("STEP", 0.1),
                               ("DAMPING", rows_of(0 * DAMPING)), ("STIFFNESS", rows_of(STIFFNESS))):
                text = text.replace(key, str(value))
            write(self.folder, f"{name}.yaml", text)
            done = run(HAWSER, "run", f"{name}.yaml", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            with h5py.File(self.folder / f"{name}.h5") as file:
                found[name] = file["series/the_spar"][:, :6]
        np.testing.assert_array_equal(found["numbers"], found["rows"])
        self.assertLess(np.abs(found["rows"][:, 0]).max(), 1e-6)
        self.assertLess(found["mixed"][-1, 0], -0.05)

    def test_table_for_a_vessel_that_moves_by_it(self):
        """A body moved by the .rao file, with the convention of `motion.rao`, has the motion of the spar."""
        wave = "{regular: {height: 0.2, period: 12, direction_deg: 30, phase_deg: 40}, ramp: 60}"
        results = self.motion("wave", wave, 600)
        self.rao(results, "-o", "spar.rao")
        write(self.folder, "follows.yaml", f"""\
hawser: 1
environment: {{water: {{density: 1025, depth: 200}}, waves: {wave}}}
bodies: {{spar: {{motion: {{rao: {{file: spar.rao}}}}}}}}
line_types: {{rope: {{outer_diameter: 0.1, mass_per_length: 8, EA: 1e6, bending: false}}}}
lines: {{rope: {{sections: [{{type: rope, length: 60, elements: 6}}], end_a: {{body: spar, at: [0, 0, 0]}}, end_b: {{anchor: [50, 0, 0]}}}}}}
dynamics: {{duration: 600, step: 0.1}}
output: {{every: 1000, histories: [{{body: spar}}]}}
""")
        done = run(HAWSER, "run", "follows.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.rao("follows.h5", "-o", "again.csv")
        self.rao(results, "-o", "first.csv")
        _, _, again, _ = table(self.folder / "again.csv")
        _, _, first, _ = table(self.folder / "first.csv")
        self.assertLess(off(again[0], first[0]), 1e-4)

    def test_white_noise(self):
        """H1 is within 0.2 % of the largest response at half of the frequencies and within 1 % at nine of
        ten, away from the resonances of pitch (0.19 rad/s) and heave (0.32 rad/s), which the segments do not
        resolve: 15 % there."""
        rows = "[[0.02, 0], [0.025, 0.01], [0.2, 0.01], [0.205, 0]]"
        results = self.motion("noise", f"{{spectrum: {{rows: {rows}, seed: 3, components: 500}}, ramp: 100}}", 4600, step=0.2)
        printed = self.rao(results, "--since", "1000", "--segment", "450")
        self.assertIn("sea, segments of 450 s", printed)
        omega, direction, found, coherence = table(self.folder / "noise-rao.csv")
        self.assertGreater(len(omega), 70)
        np.testing.assert_array_equal(direction, 0)
        for k, resonance in ((0, 0.19), (2, 0.32), (4, 0.19)):
            exact = np.array([self.spar.at(w, 0)[k] for w in omega])
            error = np.abs(found[:, k] - exact) / np.abs(exact).max()
            away = (omega > 0.16) & (np.abs(omega - resonance) > 0.04) & (coherence[:, k] > 0.98)
            print(f"white noise, freedom {k}: half within {np.median(error):.1e}, nine of ten of {np.count_nonzero(away)} off the resonance "
                  f"within {np.quantile(error[away], 0.9):.1e}, all {error[away].max():.1e} at {omega[away][error[away].argmax()]:.3f} rad/s")
            self.assertGreater(np.count_nonzero(away), len(omega) // 4)
            self.assertLess(np.median(error), 2e-3)
            self.assertLess(np.quantile(error[away], 0.9), 0.01)
            self.assertLess(error[away].max(), 0.05)
            self.assertLess(error[np.abs(omega - resonance) < 0.04].max(), 0.15)

    def test_volturnus(self):
        """Published coefficients of the UMaine VolturnUS-S, a regular wave of 0.1 m at 0 and 30 deg, against
        a separate solution in the frequency domain with the mass, mooring and damping of its WAMIT run."""
        folder = DATA / "umaine-semi"
        if not folder.is_dir():
            self.skipTest(f"{folder} is not there")
        stem = "IEA-15-240-RWT-UMaineSemi"
        for file in folder.iterdir():
            shutil.copy(file, self.folder)
        stiffness = np.diag([7.192e4, 7.192e4, 6.076e4, 2.587e8, 2.587e8, 2.524e8])
        stiffness[0, 4] = stiffness[4, 0] = 1.145e6
        stiffness[1, 3] = stiffness[3, 1] = -1.145e6
        damping = np.diag([1.6299e5, 1.6299e5, 1.4632e6, 1.2627e9, 1.2627e9, 0])
        exact = Reference(self.folder / stem, 2.01e7, -2.32, [4.25e10, 4.25e10, 2.37e10], damping, stiffness)
        # For 1 m, by an independent solution of the same equations: surge, sway, heave [m], pitch [rad].
        waves = [(0.45, 30, [0.566368, 0.332726, 0.589693, 1.87842e-3])]
        if os.environ.get("HAWSER_FULL"):
            waves.append((0.6, 0, [0.366945, 0, 0.425242, 4.58827e-3]))
        for omega, direction, known in waves:
            write(self.folder, "semi.yaml", f"""\
hawser: 1
environment:
  water: {{density: 1025, depth: 200}}
  waves: {{regular: {{height: 0.2, period: {2 * np.pi / omega:.15g}, direction_deg: {direction}}}, ramp: 60}}
bodies:
  semi:
    floating:
      mass: 2.01e7
      centre_of_mass: [0, 0, -2.32]
      inertia: [4.25e10, 4.25e10, 2.37e10]
      hydrodynamics: {{wamit: {stem}, damping: {rows_of(damping)}, stiffness: {rows_of(stiffness)}, follow_period: 0}}
dynamics: {{duration: 900, step: 0.1, rho_infinity: 1}}
output: {{every: 1000, histories: [{{body: semi}}]}}
""")
            done = run(HAWSER, "run", "semi.yaml", "-o", f"semi{direction}.h5", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.rao(f"semi{direction}.h5", "--since", "450")
            _, _, found, _ = table(self.folder / f"semi{direction}-rao.csv")
            own = exact.at(omega, direction)
            np.testing.assert_allclose(np.abs(own[[0, 1, 2, 4]]), known, rtol=2e-3, atol=1e-6)
            print(f"VolturnUS-S at {omega} rad/s, {direction} deg: off by {off(found[0], own):.1e}")
            self.assertLess(off(found[0], own), 5e-3)

    def test_sentences(self):
        wave = self.motion("wave", "{regular: {height: 0.2, period: 12}}", 100)
        still = self.motion("still", None, 40)
        spread = self.motion("spread", "{jonswap: {hs: 1, tp: 10, seed: 1, spreading: 4}}", 200)
        sea = self.motion("sea", "{jonswap: {hs: 1, tp: 10, seed: 1}}", 200)
        shutil.copy(ROOT / "docs/tutorial/mooring-2.yaml", self.folder)
        line = run(HAWSER, "run", "mooring-2.yaml", "--set", "dynamics.duration=10", cwd=self.folder)
        self.assertEqual(line.returncode, 0, line.stderr)
        for words, complaint in [
            ((still,), "there are no waves"),
            ((spread,), "the waves have several directions"),
            ((wave, "--name", "ship"), "there is no history 'ship'"),
            ((wave, "--name", "energy"), "is not a history of a body"),
            (("mooring-2.h5",), "has no history of a body"),
            ((wave, "--since", "80"), "fewer than three periods"),
            ((wave, "--since", "99"), "a response needs 32"),
            ((wave, "--segment", "20"), "--segment is for irregular seas"),
            ((sea, "--segment", "150"), "are shorter than two segments of 150 s"),
            ((sea, "--segment", "1"), "has 10 steps, but needs 16"),
            ((wave, "--at", "1,2"), "is not a point X,Y,Z"),
            ((wave, "-o", "table.txt"), "a table of responses is a .csv or .rao file"),
        ]:
            with self.subTest(words=words):
                done = run(HAWSER, "rao", *words, cwd=self.folder)
                self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
                self.assertIn(complaint, done.stderr)
                self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)


if __name__ == "__main__":
    unittest.main()
