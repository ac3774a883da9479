"""hawser stiffness and its figure: one chain on a vessel, on one and two ranks."""
import csv
import os
import shutil
import tempfile
import unittest
from pathlib import Path

import numpy as np
from support import ROOT, run

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
OPTIONS = ("--direction", "180", "--to", "6", "--steps", "3", "--at", "40,0,-10")


def table(path):
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    return rows[0], np.array([[float(x) for x in row] for row in rows[1:]])


class Stiffness(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.case = self.folder / "mooring-2.yaml"
        shutil.copy(ROOT / "docs/tutorial/mooring-2.yaml", self.case)

    def test_curves_in_the_report(self):
        done = run(HAWSER, "stiffness", self.case, *OPTIONS)
        self.assertEqual(done.returncode, 0, done.stderr)
        curves, results = self.folder / "mooring-2-stiffness.csv", self.folder / "rest.h5"
        done = run(HAWSER, "run", self.case, "--set", "dynamics=null", "-o", results)
        self.assertEqual(done.returncode, 0, done.stderr)
        done = run(HAWSER, "report", results, "--offsets", curves)
        self.assertEqual(done.returncode, 0, done.stderr)
        page = (self.folder / "rest.html").read_text(encoding="utf-8")
        self.assertIn("Mooring over offsets", page)
        self.assertIn("tension of mooring", page)
        done = run(HAWSER, "report", results, "--offsets", self.case)
        self.assertEqual(done.returncode, 2)
        self.assertIn("needs a table of hawser stiffness; this is not one", done.stderr)

    def test_table_on_ranks_and_figure(self):
        done = run(HAWSER, "stiffness", self.case, *OPTIONS)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("body vessel at rest: point (40.0000, 0.0000, -10.0000) m", done.stdout)
        head, values = table(self.folder / "mooring-2-stiffness.csv")
        self.assertEqual(head[:3], ["x offset [m]", "y offset [m]", "z offset [m]"])
        self.assertEqual(head[12], "K11 [N/m]")
        self.assertEqual(head[-1], "tension of mooring [N]")
        self.assertTrue(np.allclose(values[:, 0], [0, -2, -4, -6]))
        # At the fairlead itself the line has almost no moment, and a force equal to its tension.
        force, tension = values[:, 6:9], values[:, -1]
        self.assertTrue(np.allclose(np.linalg.norm(force, axis=1), tension, rtol=5e-3))
        self.assertLess(np.abs(values[:, 9:12]).max(), 1e-6 * tension.max())
        self.assertTrue((np.diff(tension) > 0).all())
        # The stiffness is the slope of the force: its mean over two steps by Simpson's rule from three
        # values. At the touchdown it varies by one per cent as elements of 5 m leave the bed.
        K11 = values[:, 12]
        by_force = (force[2, 0] - force[0, 0]) / 4
        self.assertAlmostEqual(by_force / ((K11[0] + 4 * K11[1] + K11[2]) / 6), 1, delta=1e-2)
        done = run("mpirun", "--allow-run-as-root", "--oversubscribe", "-n", "2", HAWSER, "stiffness", self.case, *OPTIONS,
                   "-o", self.folder / "two.csv")
        self.assertEqual(done.returncode, 0, done.stderr)
        other = table(self.folder / "two.csv")[1]
        self.assertLess(np.abs(other - values).max() / np.abs(values).max(), 1e-6)
        done = run(HAWSER, "plot", self.folder / "mooring-2-stiffness.csv", "offsets")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((self.folder / "mooring-2-stiffness-offsets.png").stat().st_size > 10000)

    def test_of_the_lines_alone(self):
        """Hull pressure and the drag of members are no part of the mooring: the table is the same with and
        without them."""
        case = """hawser: 1
environment: {water: {depth: 50}, seabed: {depth: 50}}
line_types: {chain: {outer_diameter: 0.1, mass_per_length: 100, EA: 400 MN, bending: false}}
volumes: {box: {body: barge, shape: {box: {centre: [0, 0, 0], size: [40, 20, 6]}}}}
bodies:
  barge:
    position: [0, 0, 0.5]
    floating: {mass: 2.05e6, centre_of_mass: [0, 0, 1], inertia: [1e8, 3e8, 3.5e8],
      stiffness: [1e12, 1e12, 1e12], turning_stiffness: [1e14, 1e14, 1e14]%s}
lines:
  west: {sections: [{type: chain, length: 150, elements: 30}], end_a: {anchor: [-150, 0, -50]}, end_b: {body: barge, at: [-20, 0, 0]}}
  east: {sections: [{type: chain, length: 150, elements: 30}], end_a: {anchor: [150, 10, -50]}, end_b: {body: barge, at: [20, 0, 0]}}
"""
        tables = []
        for name, water in [("lines", ""),
                            ("hull", ", hull: {volumes: [box]}, members: [{from: [-20, 0, -2], to: [20, 0, -2], diameter: 4, Cd: 1, Ca: 1}]")]:
            (self.folder / f"{name}.yaml").write_text(case % water)
            done = run(HAWSER, "stiffness", self.folder / f"{name}.yaml", "--body", "barge", "--at", "0,0,0")
            self.assertEqual(done.returncode, 0, done.stderr)
            tables.append(table(self.folder / f"{name}-stiffness.csv")[1])
        # The forces of two chains are tens of kN. The buoyancy of the box is 20 MN.
        self.assertLess(np.abs(tables[0][0, 6:9]).max(), 1e6)
        self.assertTrue(np.allclose(tables[0], tables[1], rtol=1e-6, atol=1e-6 * np.abs(tables[0][0]).max()))

    def test_contact_of_the_body_stays(self):
        """A crate held by four ropes against a fender of 1 MN/m: the stiffness includes the fender, and the
        forces are in balance."""
        (self.folder / "fender.yaml").write_text("""hawser: 1
environment: {gravity: 0}
line_types: {rope: {outer_diameter: 0.05, mass_per_length: 2, EA: 1e6, bending: false}}
bodies:
  crate: {position: [0, 0, 0], floating: {mass: 1e4, inertia: [2e4, 3e4, 3e4]}}
volumes:
  fender: {shape: {sphere: {centre: [2, 0, 0], radius: 1}}, body: crate, normal_stiffness: {per_point: 1e6}}
  wall: {shape: {box: {centre: [5, 0, 0], size: [4, 8, 8]}}}
lines:
  east: {sections: [{type: rope, length: 48, elements: 4}], end_a: {anchor: [52, 0, 30]}, end_b: {body: crate, at: [2, 0, 1]}}
  north: {sections: [{type: rope, length: 47, elements: 4}], end_a: {anchor: [0, 50, 3]}, end_b: {body: crate, at: [0, 2, 0.5]}}
  south: {sections: [{type: rope, length: 47, elements: 4}], end_a: {anchor: [0, -50, 3]}, end_b: {body: crate, at: [0, -2, 0.5]}}
  down: {sections: [{type: rope, length: 47, elements: 4}], end_a: {anchor: [0, 1, -50]}, end_b: {body: crate, at: [0, 0, -2]}}
contact: {between_lines: false}
""")
        done = run(HAWSER, "stiffness", self.folder / "fender.yaml", "--body", "crate")
        self.assertEqual(done.returncode, 0, done.stderr)
        values = table(self.folder / "fender-stiffness.csv")[1][0]
        self.assertAlmostEqual(values[12] / 1.0195e6, 1, delta=1e-3)  # 1 MN/m of the fender and 19.5 kN/m of the ropes
        self.assertLess(np.abs(values[6:9]).max(), 10)  # N, compared with 150 kN in the fender

    def test_sentences(self):
        foreign = self.folder / "wind.csv"
        foreign.write_text("0,1,0,0\n180,-1,0,0\n")
        for words, complaint in [
            (("stiffness", self.case, "--body", "ship"), "no line is attached to a body 'ship'; lines are attached to vessel"),
            (("stiffness", self.case, "--offset", "1,2"), "--offset '1,2': give three or six numbers separated by commas"),
            (("stiffness", self.case, "--to", "-3"), "'-3' is no offset above 0, in m"),
            (("stiffness", self.case, "-o", "x.txt"), "give its name the ending .csv"),
            (("stiffness", ROOT / "docs/tutorial/mooring-1.yaml"), "no line is attached to a body"),
            (("stiffness", self.case, "-o", foreign), "the file there is not a table of stiffnesses"),
            (("stiffness", self.case, "--steps", "3"), "--to"),
            (("plot", self.case, "offsets"), "needs a table of hawser stiffness"),
        ]:
            with self.subTest(words=words):
                done = run(HAWSER, *words)
                self.assertNotEqual(done.returncode, 0)
                self.assertIn(complaint, done.stderr)
                self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        self.assertEqual(foreign.read_text(), "0,1,0,0\n180,-1,0,0\n")


if __name__ == "__main__":
    unittest.main()
