"""hawser check --radiation and its figure: for a spar, and for the VolturnUS-S if its files are available."""
import csv
import os
import shutil
import tempfile
import unittest
from pathlib import Path

import numpy as np
from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
DATA = ROOT.parent / "shared/data/umaine-semi"
CASE = """\
hawser: 1
environment: {water: {density: 1025, depth: 200}}
bodies:
BODIES
statics: false
dynamics: {duration: 1}
output: {histories: [{body: a}]}
"""
BODY = ("  NAME: {position: [X, 0, 0], floating: {mass: 2.01e7, centre_of_mass: [0, 0, -2.32], inertia: [4.25e10, 4.25e10, 2.37e10], "
        "hydrodynamics: {wamit: FILES}}}\n")


def body(name, files, x=0):
    return BODY.replace("NAME", name).replace("FILES", files).replace("X", str(x))


def table(path):
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    names = rows[0][2:]
    return names, {q: np.array([[float(x) for x in r[1:]] for r in rows[1:] if r[0] == q]) for q in {r[0] for r in rows[1:]}}


class Radiation(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        for ending in (".1", ".hst"):
            for copy in ("spar", "other"):
                shutil.copy(ROOT / f"docs/tutorial/spar{ending}", self.folder / f"{copy}{ending}")

    def hawser(self, *words):
        return run(HAWSER, *words, cwd=self.folder)

    def check(self, bodies, *words):
        write(self.folder, "case.yaml", CASE.replace("BODIES\n", bodies))
        return self.hawser("check", "case.yaml", "--quick", "--radiation", *words)

    def test_table_and_figure(self):
        done = self.check(body("a", "spar"), "r.csv")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"radiation table: .*/r.csv\n")
        self.assertRegex(done.stdout, r"added mass by the damping \(Ogilvie's relation\): within [\d.]+ % of what that of the files varies by")
        names, found = table(self.folder / "r.csv")
        self.assertIn("surge-surge", names)
        self.assertEqual(len(found["damping"]), len(found["added mass"]))
        self.assertEqual(len(found["damping"]), len(found["added mass by damping"]) + 1)
        # K(0) = (2/pi) int B, by linear interpolation.
        omega, B = found["damping"][:, 0], found["damping"][:, 1:]
        whole = np.trapezoid(np.vstack([0 * B[:1], B]), np.append(0, omega), axis=0) if hasattr(np, "trapezoid") else np.trapz(
            np.vstack([0 * B[:1], B]), np.append(0, omega), axis=0)
        np.testing.assert_allclose(found["retardation"][0, 1:], 2 / np.pi * whole, rtol=1e-8)
        made = self.hawser("plot", "r.csv", "radiation")
        self.assertEqual(made.returncode, 0, made.stderr)
        self.assertGreater((self.folder / "r-radiation.png").stat().st_size, 10000)

    def test_several_groups(self):
        done = self.check(body("a", "spar") + body("b", "other", 500), "r.csv")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertTrue((self.folder / "r-a.csv").exists() and (self.folder / "r-b.csv").exists())

    def test_sentences(self):
        write(self.folder, "mine.csv", "a,b\n1,2\n")
        for words, part in ((["r.txt"], "give its name the ending .csv"), (["mine.csv"], "the file there is not a table of radiation"),
                            (["r.csv", "--json"], "json")):
            done = self.check(body("a", "spar"), *words)
            self.assertEqual(done.returncode, 2, words)
            self.assertIn(part, done.stderr)
        done = self.check("  a: {floating: {mass: 1, inertia: [1, 1, 1]}}\n", "r.csv")
        self.assertEqual(done.returncode, 2)
        self.assertIn("no body has 'hydrodynamics'", done.stderr)
        self.assertIn("needs a table of hawser check --radiation", self.hawser("plot", "mine.csv", "radiation").stderr)

    def damping_of(self, path):
        """Frequencies, damping matrices and largest added masses of a file."""
        tables, largest = {}, np.zeros(6)
        for line in path.read_text().splitlines():
            r = [float(v) for v in line.split()]
            i, j = int(r[1]) - 1, int(r[2]) - 1
            if i == j:
                largest[i] = max(largest[i], 1025 * abs(r[3]))
            if r[0] > 0:
                tables.setdefault(2 * np.pi / r[0], np.zeros((6, 6)))[i, j] = 1025 * 2 * np.pi / r[0] * r[4]
        omegas = sorted(tables)
        return np.array(omegas), np.array([0.5 * (tables[w] + tables[w].T) for w in omegas]), largest

    def test_volturnus(self):
        """K(0) against an exact integral of the file's damping: 1e-6 without its negative eigenvalues, 0.2 %
        with them (at 1.44 s one has 24 % of the largest eigenvalue). A - A(inf) against a principal value:
        0.1 % of its largest value."""
        if not DATA.is_dir():
            self.skipTest(f"{DATA} is not there")
        for ending in (".1", ".hst"):
            shutil.copy(DATA / f"IEA-15-240-RWT-UMaineSemi{ending}", self.folder / f"semi{ending}")
        done = self.check(body("a", "semi"), "r.csv")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        names, found = table(self.folder / "r.csv")
        time = found["retardation"][:, 0]
        omegas, damping, largest = self.damping_of(DATA / "IEA-15-240-RWT-UMaineSemi.1")
        scale = np.sqrt(np.outer(largest, largest))
        values, vectors = np.linalg.eigh(damping / scale)
        passive = scale * np.einsum("kim,km,kjm->kij", vectors, np.maximum(values, 0), vectors)
        steps = np.diff(omegas, prepend=0)[:, None, None]
        passive_start = (2 / np.pi * steps * 0.5 * (passive + np.concatenate([0 * passive[:1], passive[:-1]]))).sum(axis=0)
        for entry, place, start in (("surge-surge", (0, 0), 4366937), ("heave-heave", (2, 2), 1283124.19), ("pitch-pitch", (4, 4), 5.787088e8),
                                    ("surge-pitch", (0, 4), -1.608762e7)):
            of_run = found["retardation"][0, 1 + names.index(entry)]
            print(f"VolturnUS-S, K(0) of {entry}: off by {of_run / passive_start[place] - 1:+.1e}, of the file as it is by {of_run / start - 1:+.1e}")
            self.assertAlmostEqual(of_run / passive_start[place], 1, delta=1e-6)
            self.assertAlmostEqual(of_run / start, 1, delta=2e-3)
        omega, by_damping = found["added mass by damping"][:, 0], found["added mass by damping"][:, 1:]
        for entry, infinite, known in (("surge-surge", 9642417, ((0.25, 3399477), (0.6, 3494120), (1.5, -1614010))),
                                       ("heave-heave", 2.482172e7, ((0.1, 2286556.27), (0.5, 4753393.36), (2.0, -414328.073)))):
            for w, exact in known:
                at = np.argmin(np.abs(omega - w))
                self.assertAlmostEqual(by_damping[at, names.index(entry)] - infinite, exact, delta=1e-3 * 4.8e6)
        print(next(line for line in done.stdout.splitlines() if "Ogilvie" in line), f"; memory of {time[-1]:.0f} s")


if __name__ == "__main__":
    unittest.main()
