"""Impacts of cables with edges: lines over edges and around corners of moving decks, a rope under a hull, and nets
under a falling crate, from random_scenes.py at default settings. Steps create and lose little of the energy brought
in, stored or released. Statics of ropes over an edge and of a load in smooth slings."""
import os
import re
import tempfile
import unittest
from pathlib import Path

from random_scenes import scene
from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
MOST = 1.0  # % of the work done
# Scenes of random_scenes.py, and duration [s]; the longer ones with HAWSER_FULL in the environment.
FULL = bool(os.environ.get("HAWSER_FULL"))
SCENES = {scene: 10 if FULL else 4 for scene in (13, 26, 79, 151, 170, 183, 196)} | {43: 2}

OBLIQUE = """hawser: 1
environment: {{gravity: 0}}
line_types: {{rope: {{outer_diameter: 0.02, mass_per_length: 1, EA: 1 MN, stiffness_damping: 0.005, EI: 5, GJ: 5}}}}
volumes: {{box: {{shape: {{box: {{centre: [-5, 0, -5], size: [10, 20, 10]}}}}}}}}
lines:
  rope:
    sections: [{{type: rope, length: 3.8784207298622757, elements: {elements}}}]
    end_a: {{anchor: [-2, -1, 0.01]}}
    end_b: {{anchor: [0.01, 1.5, -1]}}
    start: {{points: [[-2, -1, 0.01], [0, 0.3, 0.01], [0.01, 0.3, 0], [0.01, 1.5, -1]]}}
statics: true
output: {{every: 1}}
"""


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

    def test_statics_obliquely_over_an_edge(self):
        """A rope that bends obliquely over the edge of a box. The automatic stiffness increases by a factor of 10⁵
        in statics. One search needs 543 iterations. The strain of the shortest path over the edge is 1 %,
        EA = 1 MN; bending adds to it."""
        for elements, ranks in ((60, 1), (120, 1), (60, 2)):
            with self.subTest(elements=elements, ranks=ranks), tempfile.TemporaryDirectory() as folder:
                write(Path(folder), "case.yaml", OBLIQUE.format(elements=elements))
                launch = ("mpirun", "-n", str(ranks)) if ranks > 1 else ()
                result = run(*launch, HAWSER, "run", "case.yaml", "-o", "case.h5", cwd=folder)
                self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
                tension = float(re.search(r"max effective tension +rope +(\S+) N", result.stdout)[1])
                self.assertGreater(tension, 10000)
                self.assertLess(tension, 11000)

    def test_descent_over_an_edge_that_takes_long(self):
        """400 elements as short as the radius over an edge, a turn of 15 degrees, without friction: after the contact stiffness has been
        raised, Newton's method hardly moves the line for many iterations, and converges. At rest the tension is the load at both ends."""
        with tempfile.TemporaryDirectory() as folder:
            write(Path(folder), "edge.yaml", """\
hawser: 1
environment: {gravity: 0}
line_types: {rope: {outer_diameter: 0.02, mass_per_length: 1, EA: 2 MN, bending: false}}
volumes: {box: {shape: {box: {centre: [-2, 0, -2], size: [4, 4, 4]}}}}
lines:
  rope:
    sections: [{type: rope, length: 4.00261716, element_length: 0.01}]
    end_a: {anchor: [-2, 0, 0.01]}
    end_b: free
    start: {points: [[-2, 0, 0.01], [0, 0, 0.01], [0.000871557427, 0, 0.00996194698], [0.00173648178, 0, 0.00984807753],
                     [0.00258819045, 0, 0.00965925826], [1.93443984, 0, -0.507978832]]}
    loads: [{at: end_b, force: [965.925826, 0, -258.819045]}]
""")
            for n in (1, 2):
                output = run("mpirun", "-n", n, HAWSER, "run", "edge.yaml", "-o", "edge.h5", cwd=folder, timeout=300)
                self.assertEqual(output.returncode, 0, output.stdout + output.stderr)
                for which in ("max", "min"):
                    tension = float(re.search(which + r" effective tension +rope +(\S+) N", output.stdout)[1])
                    self.assertAlmostEqual(tension, 1000, delta=8)

    def test_a_body_that_falls_in_statics(self):
        """A smooth cylinder in two smooth slings slides out of them: its equilibrium is unstable."""
        sling = ("  s{name}: {{sections: [{{type: rope, length: 5.88, elements: 20}}], end_a: {{anchor: [{x}, -1.2, 2]}}, "
                 "end_b: {{anchor: [{x}, 1.2, 2]}},\n    start: {{points: [[{x}, -1.2, 2], [{x}, -0.51, 0], [{x}, -0.36, -0.36], "
                 "[{x}, 0, -0.51], [{x}, 0.36, -0.36], [{x}, 0.51, 0], [{x}, 1.2, 2]]}}}}\n")
        with tempfile.TemporaryDirectory() as folder:
            write(Path(folder), "slings.yaml", """\
hawser: 1
environment: {}
line_types: {rope: {outer_diameter: 0.02, mass_per_length: 1, EA: 1 MN, bending: false}}
bodies: {load: {position: [0, 0, 0], floating: {mass: 2000, inertia: [250, 800, 800], weight: true}}}
volumes: {load: {shape: {capsule: {from: [-2, 0, 0], to: [2, 0, 0], radius: 0.5}}, body: load}}
contact: {between_lines: false}
statics: {max_iterations: 30}
lines:
""" + sling.format(name=0, x=-1) + sling.format(name=1, x=1))
            output = run(HAWSER, "run", "slings.yaml", cwd=folder)
        self.assertEqual(output.returncode, 3, output.stdout + output.stderr)
        self.assertRegex(output.stderr, r"body load has moved by \S+ m and does not come to rest: its lines, springs, supports")


if __name__ == "__main__":
    unittest.main()
