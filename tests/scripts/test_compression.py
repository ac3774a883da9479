"""Warnings of lines under compression: risers with a compressed foot, and lines between supports."""
import os
import tempfile
import unittest
from pathlib import Path

from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
RISER = """\
hawser: 1
environment: {water: {depth: 300}, seabed: {depth: 300}}
line_types: {r: {pipe: {outer_diameter: 0.35, wall_thickness: 0.025}}}
lines:
  r: {sections: [{type: r, length: LENGTH, elements: 145}], end_a: {anchor: [0, 0, -10]}, end_b: {anchor: [0, 0, -299.8]}}
contact: {between_lines: false}
"""
STRUT = """\
hawser: 1
line_types: {rod: {outer_diameter: 0.1, mass_per_length: 20, EA: 2.0e7, EI: 3.0e4, GJ: 3.0e4}}
lines:
  rod:
    sections: [{type: rod, length: 12, elements: 8}]
    end_a: {anchor: [0, 0, 0], direction: [1, 0, 0], clamped: true}
    end_b: {anchor: [12, 0, 0]}
    start: straight
    loads: [{at: 6, force: [2.0e4, 0, 0]}]
environment: {gravity: 0}
dynamics: {duration: 0.2, step: 0.05}
output: {every: 0.1}
"""


class Compression(unittest.TestCase):
    def printed(self, text):
        with tempfile.TemporaryDirectory() as folder:
            write(Path(folder), "case.yaml", text)
            return run(HAWSER, "run", "case.yaml", cwd=folder, timeout=300).stdout

    def test_a_riser_with_a_compressed_foot(self):
        """290 m of pipe between points 289.9 m apart, of which its own stretch takes 3 cm: 0.08 MN compression at its foot.

        EI = 72 MN m², w = 1 kN/m: a pinned foot buckles at 1.02 (EI w²)^(1/3) = 42 kN.
        """
        for length, pressed in (("290", True), ("289.7", False)):
            output = self.printed(RISER.replace("LENGTH", length))
            self.assertEqual("under an effective compression" in output, pressed, output)

    def test_a_line_without_an_upper_end(self):
        """A rod of 12 m between anchors at one height, buckled under 9.58 kN, with EI = 3e4 N m²: pi sqrt(EI/9.58 kN) = 5.6 m."""
        output = self.printed(STRUT)
        self.assertIn("it may buckle between supports that are more than 5.6 m apart, which elements of 1.4 m or less represent", output)
        self.assertNotIn("upper end", output)
        self.assertNotIn("compression", self.printed(STRUT.replace("elements: 8", "elements: 10")))


if __name__ == "__main__":
    unittest.main()
