"""Bodies that fall on or run against others with damping: energy balance and rebound. A bar at rest in slings."""
import os
import re
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
from support import ROOT, run

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
BALL = """hawser: 1
bodies: {ball: {position: [0, 0, 1.5], floating: {mass: 100, inertia: [10, 10, 10], weight: true}}}
volumes:
  deck: {shape: {plane: {point: [0, 0, 0], normal: [0, 0, 1]}}}
  ball: {shape: {sphere: {centre: [0, 0, 0], radius: 0.5}}, body: ball, relative_damping: ZETA, normal_stiffness: {per_point: 10 MN/m}}
statics: false
dynamics: {duration: 0.8}
output: {every: 0.005}
"""
REBOUND = 0.3197  # m, of the lowest point, with a relative damping of 0.2 in steps of 20 us
SHIPS = """hawser: 1
bodies:
  a: {position: [0, 0, 0], floating: {mass: 2e6, inertia: [1e8, 1e8, 1e8], velocity: [0.5, 0, 0]}}
  b: {position: [14, 0, 0], floating: {mass: 5e6, inertia: [1e8, 1e8, 1e8]}}
volumes:
  a: {shape: {box: {centre: [0, 0, 0], size: [10, 10, 5]}}, body: a, normal_stiffness: {per_length: 1e8}}
  b: {shape: {box: {centre: [0, 0, 0], size: [10, 10, 5]}}, body: b, normal_stiffness: {per_length: 1e8}}
  fender: {shape: {sphere: {centre: [5.5, 0, 0], radius: 1}}, body: a, normal_stiffness: {per_point: 2e6}, relative_damping: 0.3}
statics: false
dynamics: {duration: 20}
output: {every: 0.5}
"""
MASS, RADIUS, HEIGHT, GRAVITY = 2000, 0.3, 5, 9.80665  # of the bar in slings; the ends of these are 5 m above its axis


def slings(friction):
    """Two slings of 0.63 m width around a bar, whose ends lie straight above its sides."""
    lines = []
    for name, x in (("s0", -2), ("s1", 2)):
        turn = np.pi + np.pi * np.arange(11) / 10
        arc = [[x, 0.31815 * np.cos(a), 0.31815 * np.sin(a)] for a in turn]
        points = [[x, -0.315, HEIGHT], *arc, [x, 0.315, HEIGHT]]
        lines.append(f"  {name}: {{sections: [{{type: r, length: 10.995394485550793, element_length: 0.1}}], "
                     f"end_a: {{anchor: {points[0]}}}, end_b: {{anchor: {points[-1]}}}, start: {{points: {[list(map(float, p)) for p in points]}}}}}")
    return f"""hawser: 1
line_types: {{r: {{EA: 20 MN, bending: false, mass_per_length: 1, outer_diameter: 0.03}}}}
bodies: {{p: {{position: [0, 0, 0], floating: {{mass: {MASS}, inertia: [3000, 3000, 3000], weight: true}}}}}}
volumes: {{p: {{body: p, shape: {{capsule: {{from: [-3, 0, 0], to: [3, 0, 0], radius: {RADIUS}}}}}, friction: {friction}}}}}
lines:
""" + "\n".join(lines) + f"\nstatics: {{contact_friction: {str(friction > 0).lower()}}}\n"


class BodyImpacts(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_case(self, text, ranks=1):
        """What a run prints; its results are in results.h5."""
        case = self.folder / "case.yaml"
        case.write_text(text, "utf-8")
        launch = ["mpirun", "--oversubscribe", "-n", str(ranks)] if ranks > 1 else []
        done = run(*launch, HAWSER, "run", case, "-o", self.folder / "results.h5")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def energy_error(self, printed):
        """In per cent of the work done."""
        return float(re.search(r"balance error .* \(([-\d.e]+) %", printed)[1])

    def test_ball_on_a_deck(self):
        for zeta, ranks in ((0.1, 1), (0.2, 1), (0.2, 2)):
            with self.subTest("damping, ranks", at=(zeta, ranks)):
                printed = self.run_case(BALL.replace("ZETA", str(zeta)), ranks)
                self.assertLess(abs(self.energy_error(printed)), 1)
                self.assertNotIn("warning", printed)
        with h5py.File(self.folder / "results.h5", "r") as file:
            z = file["bodies/position"][:, 0, 2]
        self.assertAlmostEqual((z[100:].max() - 0.5) / REBOUND, 1, delta=0.03)

    def test_ships_with_a_fender(self):
        self.assertLess(abs(self.energy_error(self.run_case(SHIPS))), 0.2)

    def test_bar_in_slings(self):
        """Friction holds a bar that would slide out of its slings; each leg carries a quarter of the weight. The search passes
        states in which the bar is far from the lines."""
        printed = self.run_case(slings(0.3))
        self.assertNotIn("warning", printed)
        with h5py.File(self.folder / "results.h5", "r") as file:
            self.assertLess(np.abs(file["bodies/position"][0, 0]).max(), 1e-3)
            force = file["ends/force"][0]
        legs = np.linalg.norm(force.reshape(-1, 3), axis=1)
        np.testing.assert_allclose(legs, 0.25 * MASS * GRAVITY + 0.5 * 10.995 * GRAVITY, rtol=2e-3)



if __name__ == "__main__":
    unittest.main()
