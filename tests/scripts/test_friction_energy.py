"""A wire with one and a half turns around a drum of facets is drawn at one end while the drum holds it by friction (scene 71 of
random_scenes.py): friction takes energy at all times, and the wire does not vibrate. With springs of friction that
follow the normal force, 90 J of their energy become vibrations of the wire by 4.7 s. On two ranks only with HAWSER_FULL in
the environment.
"""
import os
import tempfile
import unittest
from pathlib import Path

import h5py
from random_scenes import scene
from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))


class FrictionEnergy(unittest.TestCase):
    def energies(self, folder, *ranks):
        place = Path(folder) / ("serial" if not ranks else "ranks")
        s = scene(71)
        for name, text in s.files.items():
            write(place, name, text)
        write(place, "case.yaml", s.text())
        result = run(*ranks, HAWSER, "run", "case.yaml", "-o", "case.h5", "--stop-at", "4.7", cwd=place)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        with h5py.File(place / "case.h5", "r") as file:
            energy = file["series/energy"]
            columns = [c.decode() for c in energy.attrs["columns"]]
            return {name: energy[:, columns.index(name)] for name in ("kinetic", "friction")}

    def check(self, energies):
        largest = lost = 0.0
        for work in energies["friction"]:
            largest = max(largest, work)
            lost = max(lost, largest - work)
        self.assertGreater(largest, 50)
        self.assertLess(lost, 0.05 * largest)
        self.assertLess(energies["kinetic"].max(), 5)

    def test_friction_takes_energy(self):
        with tempfile.TemporaryDirectory() as folder:
            self.check(self.energies(folder))

    @unittest.skipUnless(os.environ.get("HAWSER_FULL"), "long")
    def test_on_two_ranks(self):
        with tempfile.TemporaryDirectory() as folder:
            self.check(self.energies(folder, "mpirun", "-n", "2"))


if __name__ == "__main__":
    unittest.main()
