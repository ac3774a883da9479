"""Accounts of floating bodies that no line holds, by the program: the work of thrusters over an event of something else, and
the forces by origin, which leave nothing for what is not there."""
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
# A body that thrusters hold moves, and a rope that has nothing to do with it is released.
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
SPAR = """\
hawser: 1
environment:
  water: {density: 1025, depth: 200}
  waves: {components: [{height: 3, period: 10, phase_deg: 40}], ramp: 0}
bodies:
  sphere:
    position: [3, 0, 0.5]
    floating:
      mass: 28981 t
      centre_of_mass: [0, 0, -54]
      inertia: [4.5e10, 4.5e10, 1.5e9]
      velocity: [0.5, 0, 0.1]
      hydrodynamics: {wamit: STEM, displaced_volume: 28274, place: [0, 0, 0], quadratic_damping: [1e6, 1e6, 3e5, 1.5e11, 1.5e11, 0]}
      positioning: {place: [0, 0, 0], proportional: [2e5, 2e5, 1e8], derivative: [4e6, 4e6, 1e9]}
statics: false
dynamics: {duration: 2, step: 0.1, rho_infinity: 1}
output: {every: 1, file: run.h5, histories: [{body: sphere}]}
"""
HULL = """\
hawser: 1
environment:
  water: {density: 1025, depth: 100}
  current: {speed: 0.5, direction_deg: 0}
  waves: {regular: {height: 1, period: 6}, ramp: 0}
bodies:
  sphere:
    position: [0, 0, 0.3]
    floating:
      mass: 60 t
      centre_of_mass: [0, 0, -6]
      inertia: [1e6, 1e6, 1e5]
      hull: {volumes: [spar]}
      members: [{from: [0, 0, -9.8], to: [0, 0, 0], diameter: 2.8, Cd: 0.8, Ca: 1, axial_Cd: 1, axial_Ca: 1}]
volumes:
  spar: {shape: {cylinder: {from: [0, 0, -10], to: [0, 0, 3], radius: 1.4}}, body: sphere}
statics: false
dynamics: {duration: 1, step: 0.05, rho_infinity: 1}
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

    def history(self, text):
        write(self.folder, "case.yaml", text)
        done = run(HAWSER, "run", "-q", self.folder / "case.yaml", "-o", self.folder / "run.h5")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return Results(self.folder / "run.h5").series("sphere")

    def test_nothing_is_left_of_the_forces(self):
        """In the first row, too: of a sphere let go, and of a spar in waves without a ramp with thrusters."""
        history = self.history(SPHERE.replace("STEM", str(ROOT / "tests/data/hemisphere")))
        other, restoring = history.column("other_force_z"), history.column("hydrostatic_force_z")
        self.assertLess(abs(other).max(), 1e-6 * abs(restoring).max())
        self.assertGreater(abs(history.column("radiation_force_z")[0]), 0.1 * abs(restoring[0]))
        history = self.history(SPAR.replace("STEM", str(ROOT / "docs/tutorial/spar")))
        for direction in ("force_x", "force_z", "moment_y"):
            parts = {origin: abs(history.column(f"{origin}_{direction}")) for origin in ("hydrostatic", "radiation", "added", "wave", "thrusters")}
            left = abs(history.column(f"other_{direction}"))
            # Later rows: waves meet the slow place of the end of the step, and not where that was expected.
            self.assertLess(left.max(), 1e-4 * max(part.max() for part in parts.values()), direction)
            self.assertLess(left[0], 1e-8 * max(part[0] for part in parts.values()), direction)
            self.assertGreater(parts["radiation"][0], 1e3 * left[0], direction)
            self.assertGreater(parts["wave"][0], 1e3 * left[0], direction)

    def test_nothing_is_left_of_the_forces_on_a_hull(self):
        """Its pressure, and drag and added mass of its members, in waves and a current: all that acts."""
        history = self.history(HULL)
        for direction in ("force_x", "force_z", "moment_y"):
            parts = [history.column(f"{origin}_{direction}") for origin in ("buoyancy", "froude_krylov", "morison")]
            left = abs(history.column(f"other_{direction}"))
            self.assertLess(left.max(), 1e-5 * max(abs(part).max() for part in parts), direction)
            for part in parts[1:]:
                self.assertGreater(abs(part).max(), 1e3 * left.max(), direction)


if __name__ == "__main__":
    unittest.main()
