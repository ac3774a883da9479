"""Changes of a case on the command line: --set KEY=VALUE of run, check, modes and report."""
import os
import shutil
import tempfile
import unittest
from pathlib import Path

import h5py
from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
CASE = """\
hawser: 1
title: two lines
environment:
  water: {depth: 100}
  waves: {jonswap: {hs: 2, tp: 9}}
line_types:
  rope: {outer_diameter: 0.1, mass_per_length: 20, EA: 2.0e7, bending: false}
lines:
  long rope:
    sections: [{type: rope, length: 100, elements: 10}, {type: rope, length: 20, elements: 2}]
    end_a: {anchor: [0, 0, -60]}
    end_b: {anchor: [80, 0, -10]}
  other:
    sections: [{type: rope, length: 60, elements: 6}]
    end_a: {anchor: [0, 50, -40]}
    end_b: {anchor: [40, 50, -10]}
statics: {tolerance: 1.0e-8}
dynamics: {duration: 1, step: 0.1}
"""


class Set(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        write(self.folder, "two.yaml", CASE)

    def hawser(self, *arguments, ranks=0):
        launch = ["mpirun", "-n", ranks, HAWSER] if ranks else [HAWSER]
        return run(*launch, *arguments, cwd=self.folder, timeout=300)

    def changed(self, *changes):
        return [word for change in changes for word in ("--set", change)]

    def test_a_run_is_that_of_the_changed_file(self):
        changes = ["lines.long rope.sections[1].length=25", "lines[1].end_b.anchor[0]=42", "dynamics.duration=0.5",
                   "environment.waves={regular: {height: 1, period: 8}}", "output.every=0.25", "statics=null"]
        text = CASE.replace("length: 20, el", "length: 25, el").replace("[40, 50", "[42, 50").replace("duration: 1,", "duration: 0.5,")
        text = text.replace("jonswap: {hs: 2, tp: 9}", "regular: {height: 1, period: 8}").replace("statics: {tolerance: 1.0e-8}\n", "")
        write(self.folder, "by_hand.yaml", text + "output: {every: 0.25}\n")
        done = self.hawser("run", "two.yaml", *self.changed(*changes))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("note: --set lines.long rope.sections[1].length=25 (in the file 20)", done.stdout)
        self.assertIn("note: --set lines.other.end_b.anchor[0]=42 (in the file 40)", done.stdout)
        self.assertIn("note: --set output.every=0.25 (not in the file)", done.stdout)
        self.assertIn("note: --set environment.waves={regular: {height: 1, period: 8}} (given in line 5 of the file)", done.stdout)
        self.assertEqual(self.hawser("run", "by_hand.yaml").returncode, 0)
        with h5py.File(self.folder / "two.h5") as one, h5py.File(self.folder / "by_hand.h5") as other:
            self.assertEqual(one["set"][()].decode().splitlines(), changes)
            self.assertEqual(other["set"][()], b"")
            self.assertEqual(one["case"][()].decode(), CASE)
            self.assertEqual(one["outputs/time"].shape, (3,))
            for name in ("position", "effective_tension"):
                self.assertTrue((one[f"fields/{name}"][:] == other[f"fields/{name}"][:]).all(), name)
        two = self.hawser("run", "two.yaml", "-o", "ranks.h5", *self.changed(*changes), ranks=2)
        self.assertEqual(two.returncode, 0, two.stderr)
        with h5py.File(self.folder / "two.h5") as one, h5py.File(self.folder / "ranks.h5") as other:
            self.assertEqual(one["set"][()], other["set"][()])
            self.assertLess(abs(one["fields/position"][:] - other["fields/position"][:]).max(), 1e-6)

    def test_modes_and_check(self):
        done = self.hawser("modes", "two.yaml", "-n", "1", *self.changed("lines.other=null"))
        self.assertEqual(done.returncode, 0, done.stderr)
        with h5py.File(self.folder / "two-modes.h5") as file:
            self.assertEqual(list(file["lines/name"]), [b"long rope"])
            self.assertEqual(file["set"][()], b"lines.other=null")
        output = self.hawser("check", "--quick", "two.yaml", *self.changed("title=a new one", "lines[0].sections[0].elements=17"))
        self.assertEqual(output.returncode, 0, output.stderr)
        self.assertIn("a new one\n", output.stdout)
        self.assertIn("17 elements", output.stdout)

    def refused(self, changes, *parts, ranks=0, command=("check", "--quick", "two.yaml")):
        before = sorted(self.folder.rglob("*"))
        result = self.hawser(*command, *self.changed(*changes), ranks=ranks)
        output = [line for line in result.stderr.splitlines() if line.startswith("hawser: ")]
        with self.subTest(changes=changes, ranks=ranks):
            self.assertEqual(result.returncode, 2, result.stderr + result.stdout)
            self.assertEqual(len(output), 1, result.stderr)
            for part in parts:
                self.assertIn(part, output[0])
            self.assertEqual(sorted(self.folder.rglob("*")), before)

    def test_bad_changes(self):
        self.refused(["dynamics.duratoin=1"], "did you mean 'duration'?", ranks=2)
        self.refused(["a=1"], "unknown key 'a'", command=("run", "two.yaml"), ranks=2)
        result = self.hawser("run", "two.yaml", "--set")
        self.assertEqual((result.returncode, result.stderr), (2, "hawser: a value is missing after --set (see hawser run --help)\n"))

    def test_going_on(self):
        self.assertEqual(self.hawser("run", "two.yaml", "--set", "dynamics.duration=0.4").returncode, 0)
        self.refused(["lines.other.sections[0].elements=7"], "line other has 7 nodes in the file, 8 in this case",
                     "but not other lines, lengths, elements, links or volumes", command=("run", "two.yaml", "--restart", "two.h5"))
        for changes, output in [(["dynamics.duration=0.8"], "was made with --set dynamics.duration=0.4, and continues with --set dynamics.duration=0.8"),
                              ([], "was made with --set dynamics.duration=0.8, and continues without --set")]:
            result = self.hawser("run", "two.yaml", "--restart", "two.h5", *self.changed(*changes))
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn(f"note: the run of two.h5 {output}\n", result.stdout)
        with h5py.File(self.folder / "two.h5") as file:
            self.assertEqual(file["outputs/time"][-1], 1)

    def test_reports_run_the_changed_case(self):
        for change, ran in [("dynamics.duration=0.5", True), ("dynamics.duration=0.5", False), ("dynamics.duration=0.6", True)]:
            result = self.hawser("export", "two.yaml", "--set", change)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual("statics:" in result.stdout, ran, change)
        result = self.hawser("report", "two.yaml")  # existing results
        self.assertEqual(result.returncode, 0, result.stderr)
        page = (self.folder / "two.html").read_text("utf-8")
        self.assertIn("two.yaml --set dynamics.duration=0.6", page)
        self.assertNotIn("The run has reached", page)
        result = self.hawser("report", "two.h5", "--set", "dynamics.duration=1")
        self.assertEqual(result.returncode, 2)
        self.assertIn("hawser: two.h5: --set changes a case file", result.stderr)


if __name__ == "__main__":
    unittest.main()
