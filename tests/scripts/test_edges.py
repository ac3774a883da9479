"""Impacts of cables with edges: lines over edges and around corners of moving decks, a rope under a hull, and nets
under a falling crate, from random_scenes.py at default settings. Steps create and lose little of the energy brought
in, stored or released."""
import os
import re
import tempfile
import unittest
from pathlib import Path

from random_scenes import scene
from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
MOST = 1.0  # % of the work done
SCENES = {13: 10, 26: 10, 79: 10, 151: 10, 170: 10, 183: 10, 196: 10, 43: 2}  # scenes of random_scenes.py, and duration [s]


class Edges(unittest.TestCase):
    def test_energy(self):
        for seed, duration in SCENES.items():
            with self.subTest(scene=seed), tempfile.TemporaryDirectory() as folder:
                s = scene(seed)
                for name, text in s.files.items():
                    write(Path(folder), name, text)
                write(Path(folder), "case.yaml", s.text().replace("duration: 10", f"duration: {duration}"))
                result = run(HAWSER, "run", "case.yaml", "-o", "case.h5", cwd=folder)
                self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
                error = re.search(r"balance error \S+ J \((\S+) % of the work done", result.stdout)
                self.assertIsNotNone(error, result.stdout)
                self.assertLess(abs(float(error[1])), MOST)


if __name__ == "__main__":
    unittest.main()
