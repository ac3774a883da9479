"""Points of bodies of `hawser export`, `plot` and `report`: a point of a platform against the end of a line there, and the
air gap against the waves of the case."""
import csv
import os
import shutil
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
from support import ROOT, run

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
FAIRLEAD = "spar@-10,0,-20"  # end B of line bow


def table(path):
    with path.open(encoding="utf-8") as file:
        rows = list(csv.reader(file))
    return {name.split(" [")[0]: np.array([float(row[i]) for row in rows[1:]]) for i, name in enumerate(rows[0])}


class BodyPoints(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        for name in ("platform-2.yaml", "spar.1", "spar.3", "spar.hst"):
            shutil.copy(ROOT / "docs/tutorial" / name, cls.folder / name)
        cls.made = {}
        for ranks in (1, 2):
            words = [HAWSER, "run", "platform-2.yaml", "--set", "dynamics={duration: 30, step: 0.2}", "--set", "environment.waves.ramp=20",
                     "-o", f"spar{ranks}.h5"]
            first = ["mpirun", "--oversubscribe", "--allow-run-as-root", "-n", "2"] if ranks == 2 else []
            done = run(*first, *words, cwd=cls.folder)
            assert done.returncode == 0, done.stderr
            cls.made[ranks] = cls.folder / f"spar{ranks}.h5"

    def exported(self, ranks, *points):
        folder = self.folder / f"csv{ranks}"
        words = [word for point in points for word in ("--point", point)]
        done = run(HAWSER, "export", self.made[ranks], "-o", folder, *words, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return folder

    def test_point_moves_as_the_end_of_a_line_there(self):
        for ranks in (1, 2):
            folder = self.exported(ranks, FAIRLEAD)
            point, end = table(folder / "history_spar@-10_0_-20.csv"), table(folder / "history_bow.csv")
            # The accelerations of a tied end are those of the axes of its body in the time integration.
            for name, unit in (("position", 1e-9), ("velocity", 1e-9), ("acceleration", 1e-4)):
                for k in "xyz":
                    column = f"{name}_{k}"
                    with self.subTest(ranks=ranks, column=column):
                        size = max(np.abs(end[column]).max(), 1.0)
                        self.assertLess(np.abs(point[column] - end[column])[1:].max(), unit * size)
            self.assertGreater(np.ptp(point["acceleration_x"]), 0.01)

    def test_air_gap(self):
        folder = self.exported(1, "spar@9,3,15")
        point = table(folder / "history_spar@9_3_15.csv")
        with h5py.File(self.made[1]) as file:
            waves, ramp, level = file["waves/components"][:], file["waves/ramp"][0], file["waves/level"][0]
        time = point["time"]
        z = np.clip(time / ramp, 0, 1)
        sea = np.full(len(time), level, float)
        for amplitude, omega, k, x, y, phase in waves:
            sea += (z**3 * (10 + z * (6 * z - 15)) * amplitude
                    * np.cos(k * (x * point["position_x"] + y * point["position_y"]) - omega * time + phase))
        self.assertLess(np.abs(point["air_gap"] - (point["position_z"] - sea)).max(), 1e-6)
        self.assertGreater(np.ptp(point["air_gap"]), 0.5)
        with (folder / "statistics.csv").open(encoding="utf-8") as file:
            self.assertIn(["spar@9,3,15", "air gap"], [row[:2] for row in csv.reader(file)])

    def test_figures_and_report(self):
        done = run(HAWSER, "plot", self.made[1], "spectrum", "--name", "spar@9,3,15", "--column", "air_gap", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(list(self.folder.glob("spar1-spectrum*.png")))
        done = run(HAWSER, "report", self.made[1], "--point", "spar@9,3,15", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("spar@9,3,15", (self.folder / "spar1.html").read_text(encoding="utf-8"))

    def test_sentences(self):
        for words, sentence in ((("export", "--point", "spar@9,3"), "is no point of a body: it is HISTORY@X,Y,Z"),
                                (("export", "--point", "spar@9,3,nan"), "is no point of a body: it is HISTORY@X,Y,Z"),
                                (("export", "--point", "bow@9,3,1"), "'bow' is no history of a body"),
                                (("report", "--point", "hull@9,3,1"), "there is no history 'hull'")):
            done = run(HAWSER, words[0], self.made[1], *words[1:], cwd=self.folder)
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn(sentence, done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1)


if __name__ == "__main__":
    unittest.main()
