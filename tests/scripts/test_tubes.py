"""Lines in smooth tubes of a mesh, whose facets meet in small kinks: the wire in a J-tube comes to rest with friction, and stays there in
motion, soon with steps of 10 ms, on one rank and two and with either diagonal of the quadrilaterals of the mesh."""
import os
import re
import statistics
import tempfile
import unittest
from math import cos, exp, pi, sin
from pathlib import Path

import scene_meshes as meshes
from random_scenes import scene
from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
EXACT = 2840  # N, top tension without friction, as in test_exact_tubes.py
FRICTION = 0.2

WITH_FRICTION = "statics: {contact_friction: true}"
J_TUBE = """hawser: 1
environment: {water: {depth: 21.28}, seabed: {depth: 21.28, friction: 0.4}}
line_types:
  wire: {outer_diameter: 0.05, mass_per_length: 10, EA: 100 MN, bending: false, stiffness_damping: 0.01}
volumes: {tube: {mesh: tube.obj, friction: 0.2}}
lines:
  wire:
    sections: [{type: wire, length: 42.3, element_length: 0.5}]
    end_a: {anchor: [0, 0, 12]}
    end_b: free
    masses: [{at: end_b, mass: 500}]
    start: {points: [[0, 0, 12], [0, 0, -15], [0.457, 0, -17.3], [1.757, 0, -19.243], [3.704, 0, -20.543], [6, 0, -21], [12, 0, -21.2]]}
contact: {between_lines: false}
statics: {contact_friction: true}
dynamics: {duration: 1}
"""


def j_tube(other_diagonals=False):
    """A bore of 0.5 m in a wall of 30 mm: 8 m above the sea to 15 m below it, a bend of 6 m, 40 m level; coordinates with six decimals."""
    path = [(0.0, 0.0, 8 - 0.5 * i) for i in range(47)]
    path += [(6 - 6 * cos(t), 0.0, -15 - 6 * sin(t)) for t in (0.5 * pi * i / 30 for i in range(1, 31))]
    path += [(7.0 + i, 0.0, -21.0) for i in range(40)]
    n, sides = len(path), 32
    vertices = []
    for radius in (0.25, 0.28):
        for c, (y, across) in zip(path, meshes.frames(path)):
            for k in range(sides):
                a = 2 * pi * k / sides
                vertices.append(tuple(c[i] + radius * (sin(a) * y[i] - cos(a) * across[i]) for i in range(3)))
    bore = lambda i, j: i * sides + j % sides
    wall = lambda i, j: (n + i) * sides + j % sides
    facets = []

    def quadrilateral(a, b, c, d):
        facets.extend([(a, b, c), (a, c, d)] if other_diagonals else [(a, b, d), (b, c, d)])

    for i in range(n - 1):
        for j in range(sides):
            quadrilateral(bore(i, j), bore(i + 1, j), bore(i + 1, j + 1), bore(i, j + 1))
            quadrilateral(wall(i, j), wall(i, j + 1), wall(i + 1, j + 1), wall(i + 1, j))
    for j in range(sides):
        quadrilateral(bore(0, j), bore(0, j + 1), wall(0, j + 1), wall(0, j))
        quadrilateral(bore(n - 1, j), wall(n - 1, j), wall(n - 1, j + 1), bore(n - 1, j + 1))
    return ("".join("v %.6f %.6f %.6f\n" % v for v in vertices) +
            "".join("f %d %d %d\n" % tuple(k + 1 for k in f) for f in facets))


class Tubes(unittest.TestCase):
    def tensions(self, mesh, command, statics):
        with tempfile.TemporaryDirectory() as folder:
            write(Path(folder), "tube.obj", mesh)
            write(Path(folder), "case.yaml", J_TUBE.replace(WITH_FRICTION, statics))
            result = run(*command, HAWSER, "run", "case.yaml", "-o", "case.h5", cwd=folder)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertNotIn("warning", result.stdout)
        steps = [float(h) for h in re.findall(r"step (\S+) s", result.stdout)]
        self.assertTrue(steps, result.stdout)
        self.assertGreater(min(steps), 2e-3)
        self.assertGreaterEqual(statistics.median(steps), 0.01)
        most, when = re.search(r"max effective tension +\S+ +(\S+) N +(\S+)", result.stdout).groups()
        return float(most), float(when)

    def check(self, mesh, command=(), statics=WITH_FRICTION):
        most, when = self.tensions(mesh, command, statics)
        # Friction along the bend, in either direction (Euler and Eytelwein).
        band = exp(0.5 * pi * FRICTION)
        self.assertLess(most, EXACT * band)
        self.assertGreater(most, EXACT / band)
        return most

    def test_statics_names_the_exact_shape(self):
        case = J_TUBE.replace(WITH_FRICTION, "statics: {max_iterations: 2, relaxation_steps: 2}")
        with tempfile.TemporaryDirectory() as folder:
            write(Path(folder), "tube.obj", j_tube())
            write(Path(folder), "case.yaml", case)
            result = run(HAWSER, "run", "case.yaml", cwd=folder)
        self.assertEqual(result.returncode, 3, result.stdout + result.stderr)
        self.assertIn("what may help: 'shape: {tube: ...}' for a mesh that is a tube", result.stdout)

    def test_rest_and_motion(self):
        """Without the key, statics comes to the same rest after a search without friction, which is short here. The search
        with HAWSER_FULL in the environment."""
        most = self.check(j_tube())
        if not os.environ.get("HAWSER_FULL"):
            return
        short = "statics: {max_iterations: 30, relaxation_steps: 200}"
        self.assertAlmostEqual(self.check(j_tube(), statics=short), most, delta=1e-4 * most)

    def rests_on_kinks(self, seed, elements, most):
        """A random scene comes to rest between kinks, where a residual of at most this fraction of its tension remains."""
        pull = scene(seed)
        pull.parts["lines"]["line"]["sections"][0]["elements"] = elements
        pull.statics = {"contact_friction": True}
        case = pull.text().replace("duration: 10", "duration: 0.001")
        for ranks in (1, 2) if os.environ.get("HAWSER_FULL") else (1,):
            with tempfile.TemporaryDirectory() as folder:
                for name, content in pull.files.items():
                    write(Path(folder), name, content)
                write(Path(folder), "case.yaml", case)
                result = run("mpirun", "--oversubscribe", "--allow-run-as-root", "-n", ranks, HAWSER, "run", "case.yaml", cwd=folder)
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
            residual, tension = re.search(r"warning: statics ends where no line moves any more, but line line, arc length \S+ m, "
                                          r"is out of balance by (\S+) N \(forces of size (\S+) N\)", result.stdout).groups()
            self.assertLess(float(residual), most * float(tension))

    def test_hose_rests_on_kinks(self):
        self.rests_on_kinks(28, 30, 5e-3)

    def test_wire_rests_on_kinks(self):
        self.rests_on_kinks(54, 40, 1e-3)

    def test_other_diagonals(self):
        self.check(j_tube(True))

    def test_ranks(self):
        self.check(j_tube(), ("mpirun", "--oversubscribe", "--allow-run-as-root", "-n", "2"))


if __name__ == "__main__":
    unittest.main()
