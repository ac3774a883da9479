"""ParaView opens the program's files: times, the hose and its fields, and a rotating drum."""
import json
import math
import os
import shutil
import tempfile
import unittest
from pathlib import Path

from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
# Prints the content at the first and the last time: nodes of the line, one field of it, vertices of the drum.
LOOK = """
import json, sys
sys.path.insert(0, sys.argv[2])  # the tree's scripts
from render import leaves
from paraview import servermanager
from paraview.simple import OpenDataFile

reader = OpenDataFile(sys.argv[1])
reader.UpdatePipelineInformation()
read = {"times": list(reader.TimestepValues), "looks": []}
for time in (read["times"][0], read["times"][-1]):
    reader.UpdatePipeline(time)
    look = {}
    for leaf in leaves(servermanager.Fetch(reader)):
        points = [leaf.GetPoint(i) for i in range(leaf.GetNumberOfPoints())]
        if leaf.GetNumberOfCells() and leaf.GetCell(0).GetNumberOfPoints() == 3 and leaf.GetCell(0).GetCellDimension() == 2:
            look["drum"], look["triangles"] = points, leaf.GetNumberOfCells()
        elif leaf.GetPointData().GetArray("effective_tension"):
            tension = leaf.GetPointData().GetArray("effective_tension")
            look["line"], look["tension"] = points, [tension.GetValue(i) for i in range(len(points))]
    read["looks"].append(look)
print("READ " + json.dumps(read))
"""


@unittest.skipUnless(shutil.which("pvpython") and shutil.which("Xvfb"),
                     "no ParaView here: scripts/install-deps --view")
class Xdmf(unittest.TestCase):
    def test_reel(self):
        folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        case = (ROOT / "cases/reel/reel.yaml").read_text("utf-8")
        for old, new in [("length: 250, elements: 250", "length: 60, elements: 40"), ("every: 1.0", "every: 2.0")]:
            self.assertIn(old, case)
            case = case.replace(old, new)
        write(folder, "reel.yaml", case)
        shutil.copy(ROOT / "cases/reel/drum.stl", folder)
        write(folder, "look.py", LOOK)
        result = run(HAWSER, "run", "reel.yaml", "-q", "--stop-at", "12", cwd=folder, timeout=300)
        self.assertEqual(result.returncode, 0, result.stderr)
        result = run("scripts/with-display", "pvpython", folder / "look.py", folder / "reel.xdmf", ROOT / "scripts",
                     timeout=300)
        lines = [line for line in result.stdout.splitlines() if line.startswith("READ ")]
        self.assertEqual((result.returncode, len(lines)), (0, 1), result.stdout + result.stderr)
        read = json.loads(lines[0][5:])
        self.assertEqual([round(t, 9) for t in read["times"]], [0, 2, 4, 6, 8, 10, 12])
        first, last = read["looks"]
        for look in read["looks"]:
            self.assertEqual(len(look["line"]), 41)
            self.assertEqual(len(look["drum"]), len(first["drum"]))
            self.assertGreater(look["triangles"], 100)
            # The hose is 60 m long, 273.4 kg/m: the tension is its whole weight at the top and almost zero at
            # the free end.
            self.assertAlmostEqual(max(look["tension"]) / (60 * 273.4 * 9.80665), 1, delta=0.1)
        # Each vertex of the drum has rotated about -y by 0.7 rad: at 0.1 rad/s, after a start of 10 s of half
        # the angle.
        turned = []
        for a, b in zip(first["drum"], last["drum"]):
            self.assertAlmostEqual(a[1], b[1], delta=1e-5)
            self.assertAlmostEqual(math.hypot(a[0], a[2]), math.hypot(b[0], b[2]), delta=1e-5)
            if math.hypot(a[0], a[2]) > 1:
                turned.append(math.remainder(math.atan2(b[2], b[0]) - math.atan2(a[2], a[0]), 2 * math.pi))
        self.assertGreater(len(turned), 100)
        self.assertAlmostEqual(min(turned), 0.7, delta=1e-3)
        self.assertAlmostEqual(max(turned), 0.7, delta=1e-3)
        # The hose is pulled up by the corresponding length.
        self.assertAlmostEqual(min(p[2] for p in last["line"]) - min(p[2] for p in first["line"]), 0.7 * 4.025, delta=0.3)


if __name__ == "__main__":
    unittest.main()
