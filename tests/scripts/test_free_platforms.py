"""Energy accounts of floating bodies without lines: work of thrusters across an unrelated event, and forces by
origin, which sum to the total."""
import os
import re
import sys
import tempfile
import unittest
from pathlib import Path

from support import ROOT, run, write

sys.path.insert(0, str(ROOT / "scripts"))
from hawser_post.results import Results  # noqa: E402

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
# A body held by thrusters moves, and an unrelated rope is released.
POSITIONED = """\
hawser: 1
line_types:
  rope: {outer_diameter: 0.1, mass_per_length: 1, EA: 1 MN, bending: false}
bodies:
  ship:
    position: [0, 0, 0]
    floating:
      mass: 1e6
      inertia: [1e8, 3e8, 4e8]
      stiffness: [0, 0, 1e6]
      turning_stiffness: [1e8, 1e8, 0]
      velocity: [1, 0, 0]
      positioning: {proportional: [2e4, 2e4, 1e6], derivative: [2e5, 2e5, 1e8], integral: [100, 100, 1e4], filter_period: 20}
lines:
  rope: {sections: [{type: rope, length: 20, elements: 4}], end_a: {anchor: [100, 0, 0]}, end_b: {anchor: [119, 0, 0]}}
events:
  - {release: {line: rope, end: end_b}, time: 12}
contact: {between_lines: false}
dynamics: {duration: 20, step: 0.2, rho_infinity: 1}
output: {every: 20, file: run.h5}
"""
SPHERE = """\
hawser: 1
environment: {gravity: 9.81, water: {density: 1000}}
bodies:
  sphere:
    position: [0, 0, 1]
    floating: {mass: 261800, inertia: [2.6e6, 2.6e6, 2.6e6], hydrodynamics: {wamit: STEM, length_scale: 5}}
statics: false
dynamics: {duration: 3, step: 0.2, rho_infinity: 1}
output: {every: 1, file: run.h5, histories: [{body: sphere}]}
"""


class FreePlatforms(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_thrusters_over_an_event(self):
        write(self.folder, "case.yaml", POSITIONED)
        done = run(HAWSER, "run", self.folder / "case.yaml", "-o", self.folder / "run.h5")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        error = float(re.search(r"not accounted for (\S+) J", done.stdout)[1])
        brought_in = float(re.search(r"brought in (\S+) J", done.stdout)[1])
        self.assertLess(abs(error), 1e-3 * abs(brought_in), done.stdout)

    def test_nothing_is_left_of_the_forces(self):
        write(self.folder, "case.yaml", SPHERE.replace("STEM", str(ROOT / "tests/data/hemisphere")))
        done = run(HAWSER, "run", "-q", self.folder / "case.yaml", "-o", self.folder / "run.h5")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        history = Results(self.folder / "run.h5").series("sphere")
        other, restoring = history.column("other_force_z")[1:], history.column("hydrostatic_force_z")[1:]
        self.assertLess(abs(other).max(), 1e-6 * abs(restoring).max())


if __name__ == "__main__":
    unittest.main()
