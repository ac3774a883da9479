"""Bodies that lie on others by their edges: long steps at rest, friction that holds exactly and slides as it must, and a
note if the contact at the start drives bodies apart."""
import os
import re
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
from support import ROOT, run

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
MASS, GRAVITY, FRICTION = 4000, 9.80665, 0.4
CRATE = f"""hawser: 1
bodies:
  crate: {{position: [0, 0, 0.5], floating: {{mass: {MASS}, inertia: [2000, 2000, 2000], weight: true, loads: [{{force: [PULL, 0, 0], at: [0, 0, -0.5]}}]}}}}
volumes:
  deck: {{shape: {{plane: {{point: [0, 0, 0], normal: [0, 0, 1]}}}}, friction: {FRICTION}}}
  crate:
    {{shape: {{box: {{centre: [0, 0, 0], size: [2, 2, 1]}}}}, body: crate, friction: {FRICTION}, relative_damping: 0.3,
     normal_stiffness: {{per_length: 1e7}}}}
statics: false
dynamics: {{duration: 6}}
output: {{every: 0.5}}
"""
SHIP = """hawser: 1
bodies:
  ship:
    position: [0, Y, 0]
    floating: {mass: 2e6, inertia: [8e7, 8e7, 1.5e8], stiffness: [0, 0, 2e6], loads: [{force: [0, -1e5, 0], at: [0, 0, 0]}]}
volumes:
  quay: {shape: {box: {centre: [0, -10, 0], size: [200, 20, 20]}}}
  ship: {shape: {box: {centre: [0, 0, 0], size: [60, 10, 6]}}, body: ship, normal_stiffness: {per_length: 1e7}, relative_damping: 0.5}
statics: false
dynamics: {duration: 0.1}
output: {every: 0.1}
"""
# A crate under water that sinks 6 m to the bed.
SINKING = """hawser: 1
environment: {water: {density: 1025, depth: 50}, seabed: {depth: 50}}
bodies:
  crate: {position: [0, 0, -44], floating: {mass: 10000, inertia: [5000, 5000, 5000], weight: true, in_water: {volume: 4, height: 2, drag_area: [3, 3, 3]}}}
volumes:
  crate: {shape: {box: {centre: [0, 0, 0], size: [2, 2, 2]}}, body: crate, normal_stiffness: {per_point: 1e7}, relative_damping: 0.3}
FLOOR
statics: false
dynamics: {duration: 6}
output: {every: 0.5}
"""
# A barge over a post that is small beside it. Their volumes have the penetration 0.05 m over the post.
BARGE = """hawser: 1
bodies:
  barge: {position: [0, 0, 0], floating: {mass: 1e6, inertia: [1e8, 1e8, 1e8]}}
volumes:
  post: {shape: {box: {centre: [X, Y, -11.45], size: [1, 1, 20]}}}
  barge: {shape: {box: {centre: [0, 0, 0], size: [40, 10, 3]}}, body: barge, normal_stiffness: {per_area: 1e6}}
statics: false
dynamics: {duration: 1e-4}
output: {every: 1e-4, histories: [{body: barge, name: barge}]}
"""


class BodiesAtRest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_case(self, text):
        """What a run prints, times of its steps, and output times and positions of the body."""
        case = self.folder / "case.yaml"
        case.write_text(text, "utf-8")
        done = run(HAWSER, "run", case, "-o", self.folder / "results.h5")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with h5py.File(self.folder / "results.h5", "r") as file:
            return done.stdout + done.stderr, file["series/time"][:], file["outputs/time"][:], file["bodies/position"][:, 0]

    def test_post_that_is_small_beside_a_barge(self):
        """Points of the barge's faces are close enough for the post: 0.4 m, a force within a fifth of k A p."""
        for x, y in ((0.3, 0.2), (-4.68, 0.83), (4.53, -3.48)):
            self.run_case(BARGE.replace("X", str(x)).replace("Y", str(y)))
            with h5py.File(self.folder / "results.h5", "r") as file:
                series = file["series/barge"]
                speed = series[-1, list(series.attrs["columns"]).index(b"velocity_z")]
            force = 1e6 * speed / 1e-4  # N, mass times acceleration
            self.assertLess(abs(force / 5e4 - 1), 0.2, (x, y))

    def test_crate_that_friction_holds(self):
        """Half of the friction holds it. The contact has a period of 45 ms, of which steps are a twentieth while it vibrates."""
        printed, steps, time, x = self.run_case(CRATE.replace("PULL", str(0.5 * FRICTION * MASS * GRAVITY)))
        self.assertLess(np.count_nonzero(steps > 3), 3 / 0.025)
        self.assertLess(abs(float(re.search(r"balance error .* \(([-\d.e]+) %", printed)[1])), 1)
        self.assertLess(np.abs(x[time > 3] - x[-1]).max(), 1e-8)
        self.assertNotIn("drives them apart", printed)

    def test_crate_that_slides(self):
        """A pull of 1.1 times the friction accelerates it, in steps that do not resolve its vibration."""
        _, steps, time, x = self.run_case(CRATE.replace("PULL", str(1.1 * FRICTION * MASS * GRAVITY)))
        self.assertLess(np.count_nonzero(steps > 3), 3 / 0.025)
        second = np.diff(x[time > 2, 0], 2) / 0.5**2
        np.testing.assert_allclose(second, 0.1 * FRICTION * GRAVITY, rtol=1e-3)

    def test_start_in_the_onset_of_contact(self):
        """Flush sides touch by the smooth onset of the force, 1 cm wide: 15 times the load."""
        for y, apart in ((5, True), (5.01, False)):
            with self.subTest(y=y):
                printed = self.run_case(SHIP.replace("Y,", f"{y},"))[0]
                self.assertEqual(apart, "volumes ship and quay start in contact with" in printed, printed)
                if apart:
                    self.assertIn("which drives them apart; give bodies.ship.position 0.01 m further away", printed)

    def test_crate_that_sinks_to_the_bed(self):
        """The bed carries lines only."""
        for floor, ranks in (("", 1), ("", 2), ("  floor: {shape: {plane: {point: [0, 0, -50], normal: [0, 0, 1]}}}", 1)):
            with self.subTest(floor=floor, ranks=ranks):
                (self.folder / "sinking.yaml").write_text(SINKING.replace("FLOOR", floor), "utf-8")
                done = run("mpirun", "--allow-run-as-root", "--oversubscribe", "-n", str(ranks), HAWSER, "run", self.folder / "sinking.yaml")
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                warned = re.findall(r"warning: body crate sank to [\d.]+ m below the seabed, which carries lines only: add a volume", done.stdout)
                self.assertEqual(len(warned), 0 if floor else 1, done.stdout)


if __name__ == "__main__":
    unittest.main()
