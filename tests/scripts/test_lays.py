"""Typical lays over supports: yielding pipes, and messages about implausible cases."""
import os
import re
import shutil
import tempfile
import time
import unittest
from pathlib import Path

import h5py
import numpy as np
from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
BOXES = "      - {at: [10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120], above_path: 0.5, type: flat, roller_diameter: 0.5, " \
        "roller_length: 3}"
# A concrete-coated pipe of 16 in that is laid in 60 m of water over a ramp and a stinger of two arcs.
CASE = """\
hawser: 1
environment:
  water: {density: 1025}
  seabed: {depth: 60, normal_stiffness: {per_area: 200 kN/m3}}
line_types:
  pipe:
    pipe: {outer_diameter: 16 in, wall_thickness: 19.1 mm, grade: X60, coatings: [{thickness: 40 mm, density: 3040}]}
bodies:
  barge: {position: [0, 0, 0]}
supports:
  stinger:
    body: barge
    path:
      from: [0, 0, 7]
      direction: [-1, 0, 0]
      segments: [{length: 30}, {length: 60, radius: 200}, {length: 50, radius: 150}]
    boxes:
""" + BOXES + """
lines:
  pipe:
    sections:
      - {type: pipe, length: 150, element_length: 0.5}
      - {type: pipe, length: 365, element_length: 2}
    end_a: {body: barge, at: [0, 0, 7.9932], direction: [-1, 0, 0], clamped: true}
    end_b: {anchor: [-500, 0, -59.7568], direction: [-1, 0, 0], clamped: true}
    target: {tension: 400 kN, at: end_a}
contact: {between_lines: false}
"""


def box(place, above):
    """The case with the support this much higher or lower than the path."""
    others = BOXES.replace(f"{place}, ", "")
    one = others.replace(re.search(r"\[.*?\]", others)[0], f"[{place}]").replace("above_path: 0.5", f"above_path: {above}")
    return {BOXES: f"{one}\n{others}"}


class Lays(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def hawser(self, command, changes, *words, ranks=0, limit=600):
        text = CASE
        for old, new in changes.items():
            self.assertIn(old, text)
            text = text.replace(old, new)
        write(self.folder, "lay.yaml", text)
        launch = ["mpirun", "-q", "-n", ranks, HAWSER] if ranks else [HAWSER]
        return run(*launch, command, self.folder / "lay.yaml", *words, timeout=limit)

    def moments(self, name, *changes, ranks=0):
        words = [word for change in changes for word in ("--set", change)]
        done = self.hawser("run", {}, "-o", self.folder / f"{name}.h5", "--set", "lines.pipe.target=null", *words, ranks=ranks)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with h5py.File(self.folder / f"{name}.h5") as file:
            return file["fields/bending_moment"][0]


class PipesThatYield(Lays):
    def test_statics_goes_over_the_elastic_rest(self):
        elastic = self.moments("elastic")
        for kilo in (900, 700):  # slight and moderate yielding
            yields = f"line_types.pipe.plasticity={{ramberg_osgood: {{yield_moment: {kilo} kN m, A: 0.4, B: 12}}}}"
            moment = self.moments("yields", yields)
            self.assertLess(moment.max(), (0.999 if kilo == 900 else 0.98) * elastic.max())
            # The equilibrium equals that found manually from the elastic one.
            by_hand = self.moments("by_hand", yields, "lines.pipe.start={from: elastic.h5}")
            np.testing.assert_allclose(moment, by_hand, rtol=0, atol=1e-5 * elastic.max())
        shared = self.moments("shared", yields, ranks=2)
        np.testing.assert_allclose(shared, moment, rtol=0, atol=1e-5 * elastic.max())

    def test_that_of_the_case_of_a_lay(self):
        case = ROOT / "cases/s-lay/simple.yaml"
        done = run(HAWSER, "run", case, "-q", "-o", self.folder / "simple.h5", "--set", "dynamics=null", "--set",
                   "line_types.pipe.plasticity={ramberg_osgood: {yield_moment: 250 kN m, A: 0.4, B: 12}}", timeout=600)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with h5py.File(self.folder / "simple.h5") as file:
            self.assertAlmostEqual(file["fields/bending_moment"][0].max() / 148e3, 1, delta=0.03)


class ThatCannotBeMeant(Lays):
    """Messages about implausible cases, and how early they appear."""

    def refused(self, changes, *parts, command="run"):
        done = self.hawser(command, changes)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        for part in parts:
            self.assertIn(part, done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        return done.stderr

    def test_the_trial_of_a_check_bounds_the_search(self):
        begun = time.process_time(), os.times().children_user
        done = self.hawser("check", {"length: 365,": "length: 450,"})
        spent = os.times().children_user - begun[1]
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("in 4 CPU s the search has not found line lengths", done.stdout)
        self.assertLess(spent, 20)

    def test_a_support_out_of_line_is_named(self):
        for above, place, what in ((-4, 60, "below"), (6, 60, "above")):
            output = self.refused(box(place, above), "supports.stinger.boxes[0]: support 'stinger 6' is ",
                                f"{what} the path over its neighbours, so that line pipe starts on the wrong side of support",
                                "move it into line with them")
            self.assertIn("lay.yaml:18: supports", output)
            off = float(re.search(r"is ([0-9.]+) m", output)[1])
            self.assertAlmostEqual(off, 4.5 if above < 0 else 5.5, delta=0.1)
            self.assertNotIn("target", output)
        # All supports are too low, or the end of the line is too high.
        output = self.refused({"above_path: 0.5": "above_path: -8"}, "lay.yaml:18: supports.stinger.boxes[0]: the path over the supports begins 8.5", "m below the end from which line pipe goes overboard")
        self.assertNotIn("target", output)

    def test_a_target_is_searched_for_beyond_a_line_that_is_too_short(self):
        done = self.hawser("run", {"[-500, 0, -59.7568]": "[-500, 200, -59.7568]", "400 kN": "300 kN"}, "-o",
                           self.folder / "lay.h5")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("so that the tension at end A is 300000 N", done.stdout)

    def test_rollers_that_overlap(self):
        self.refused({"roller_diameter: 0.5": "roller_diameter: 500"}, "lay.yaml:18: supports.stinger.boxes[0]: its rollers of "
                     "500 m in diameter and those of support 'stinger 1', 500 m, overlap: the supports are",
                     "is 'roller_diameter' in m?", command="check")

    def test_a_line_below_a_mesh_of_its_own_barge(self):
        text = CASE.replace(CASE[CASE.index("supports:"):CASE.index("lines:")], "volumes:\n  ramp: {body: barge, mesh: ramp.obj}\n")
        text = re.sub(r"    target: .*\n", "", text)
        corners = [(x, y, z) for z in (6.0, 7.5) for x, y in ((-60, -2), (-5, -2), (-5, 2), (-60, 2))]
        faces = ["4 3 2 1", "5 6 7 8", "1 2 6 5", "2 3 7 6", "3 4 8 7", "4 1 5 8"]
        write(self.folder, "ramp.obj", "".join(f"v {x} {y} {z}\n" for x, y, z in corners) + "".join(f"f {f}\n" for f in faces))
        write(self.folder, "mesh.yaml", text)
        done = run(HAWSER, "check", "--quick", self.folder / "mesh.yaml")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("warning: lines.pipe: its start shape passes under volume ramp, ", done.stdout)
        self.assertIn("while its end A is above it; if that is intended, confirm it with 'start: {points: ", done.stdout)
        # There is no warning if the end is below the volume.
        low = text.replace("at: [0, 0, 7.9932]", "at: [0, 0, 5]")
        write(self.folder, "low.yaml", low)
        done = run(HAWSER, "check", "--quick", self.folder / "low.yaml")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertNotIn("passes under volume", done.stdout)

    def test_what_is_so_at_rest_has_no_time(self):
        done = self.hawser("run", {"at: [0, 0, 7.9932]": "at: [0, 0, 6]", "contact:": "dynamics: {duration: 1}\ncontact:"}, "-o", self.folder / "lay.h5")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("at arc length 0 m, at rest, ", done.stdout)
        self.assertIn("is loaded above the limit of DNV-ST-F101 at arc length 0 m, at rest: ", done.stdout)

    def test_an_event_that_has_happened_before(self):
        write(self.folder, "wire.yaml", """\
hawser: 1
line_types:
  wire: {outer_diameter: 0.05, mass_per_length: 10, EA: 50 MN, bending: false, stiffness_damping: 0.01}
lines:
  w:
    sections: [{type: wire, length: 100, element_length: 5}]
    end_a: {anchor: [0, 0, 0], feed: {stock: 80, speed: 0.5}}
    end_b: free
    masses: [{at: end_b, mass: 2000}]
dynamics: {duration: 20}
events:
  - {feed: {line: w, end: end_a, speed: 0}, when: {tension: {line: w, at: end_a, above: 1 kN}}}
""")
        done = run(HAWSER, "run", self.folder / "wire.yaml", "-o", self.folder / "wire.h5")
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertIn("wire.yaml:12: events[0]: the feeder at end A of line w would be set to 0 m/s at once",
                      done.stderr)

    def test_tables_of_lays(self):
        for words, part in ((["--depths=5"], "lay.yaml: a depth of 5 m is too small for this stinger"),
                            (["--depths=50", "--clearance=-1"], "--clearance -1 is below 0 m")):
            done = self.hawser("lay", {}, *words)
            self.assertEqual((done.returncode, len(done.stderr.splitlines())), (2, 1), done.stderr)
            self.assertIn(part, done.stderr)
            self.assertNotRegex(done.stderr, r"\bnan\b")
        write(self.folder, "wire.yaml", CASE.replace("pipe: {outer_diameter: 16 in, wall_thickness: 19.1 mm, grade: X60, coatings: "
                                                     "[{thickness: 40 mm, density: 3040}]}",
                                                     "outer_diameter: 0.5\n    mass_per_length: 400\n    EA: 1 GN\n    EI: 100 MN m2\n    GJ: 80 MN m2"))
        done = run(HAWSER, "lay", self.folder / "wire.yaml", "--depths=50")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn(f"{self.folder / 'wire.yaml'}: no line has a type with 'pipe'", done.stderr)


if __name__ == "__main__":
    unittest.main()
