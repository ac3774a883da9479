"""Lines that differ only in name and position are reported together, with ranges; the length on the bed is the same
in the check, the log of a run, and the tables of its results."""
import csv
import math
import os
import re
import shutil
import tempfile
import unittest
from pathlib import Path

from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
HEAD = """\
hawser: 1
environment: {water: {depth: 80}, seabed: {depth: 80, friction: 0.7}}
line_types: {chain: {library: chain-studless, diameter: 100 mm, grade: R4}}
lines:
"""
LEG = """\
  {name}:
    sections: [{{type: chain, length: {length}, elements: {elements}}}]
    end_a: {{anchor: [{x:.6g}, {y:.6g}, -80]}}
    end_b: {{anchor: [0, 0, {top}]}}
"""


def legs(lengths, tops):
    """Legs around a point, each with a length and the height of its upper end."""
    out = HEAD
    for k, (length, top) in enumerate(zip(lengths, tops)):
        angle = 2 * math.pi * k / len(lengths)
        out += LEG.format(name=f"m{k + 1}", length=length, elements=length // 4, x=370 * math.cos(angle), y=370 * math.sin(angle), top=top)
    return out


class LikeLines(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def hawser(self, *arguments, ranks=1):
        result = run(*(["mpirun", "-n", ranks] if ranks > 1 else []), HAWSER, *arguments, cwd=self.folder, timeout=300)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return result.stdout

    def test_check_reports_like_lines_together(self):
        write(self.folder, "six.yaml", legs([400] * 5 + [404], [-3, -3, -3, -3, -5, -3]))
        checks = [self.hawser("check", "six.yaml", ranks=ranks) for ranks in (1, 2)]
        for out in checks:
            self.assertIn("  m1 ... m5 (5 in all), each: 400 m, 100 elements, 101 nodes,", out)
            self.assertIn("end B anchored at (0, 0, -5 to -3); start", out)
            self.assertIn("  m6: 404 m, 101 elements", out)
            self.assertEqual(len(re.findall(r"(?m)^  m\d", out)), 2)
        on_bed = [re.findall(r"(?m)^lines.*on the seabed.*$", out) for out in checks]
        self.assertEqual(on_bed[0], on_bed[1])
        self.assertEqual([line.split(":")[0] for line in on_bed[0]], ["lines m1 ... m5 (5 in all)", "lines.m6"])
        self.assertRegex(on_bed[0][0], r": [\d.]+ to [\d.]+ m on the seabed, where friction takes [\d.]+ to [\d.]+ kN")

    def test_what_lies_on_the_bed_has_one_length(self):
        write(self.folder, "two.yaml", legs([400, 404], [-3, -3]))
        lies = [float(x) for x in re.findall(r"lines\.m\d: ([\d.]+) m on the seabed", self.hawser("check", "two.yaml"))]
        self.hawser("run", "two.yaml", "-q")
        self.hawser("export", "two.h5")
        with (self.folder / "two/lines.csv").open(encoding="utf-8") as file:
            table = [float(row["on the seabed at the start [m]"]) for row in csv.DictReader(file)]
        self.assertEqual(len(lies), 2)
        for one, other in zip(lies, table):
            self.assertAlmostEqual(one, other, delta=0.051)  # the output has four digits

    def test_chains_have_no_row_of_curvature(self):
        text = legs([400], [-3]).replace("lines:", "  hose: {outer_diameter: 0.5, mass_per_length: 250, EA: 1e8, EI: 2e5, GJ: 1e5}\nlines:")
        text = text.replace("line_types: {chain: ", "line_types:\n  chain: ").replace("R4}}", "R4}") + LEG.format(name="hose", length=120, elements=60, x=90, y=20, top=-3).replace("chain", "hose")
        write(self.folder, "hose.yaml", text)
        self.hawser("run", "hose.yaml", "-q")
        self.hawser("export", "hose.h5")
        with (self.folder / "hose/extremes.csv").open(encoding="utf-8") as file:
            rows = [(row["quantity"], row["line"]) for row in csv.DictReader(file)]
        self.assertEqual([line for quantity, line in rows if quantity in ("max curvature", "max bending moment")], ["hose", "hose"])
        self.assertIn(("max effective tension", "m1"), rows)


if __name__ == "__main__":
    unittest.main()
