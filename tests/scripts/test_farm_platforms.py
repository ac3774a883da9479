"""A farm of floating platforms: a rank has data of the platforms that it owns only, and the collective calls of a restart do not
increase with their number."""
import os
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
from support import ROOT, run

sys.path.insert(0, str(ROOT / "tests/bench"))
import farm  # noqa: E402

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
COUNTER = os.environ.get("HAWSER_MPI_COUNTER", str(ROOT / "build/tests/libmpi_counts.so"))
FEW, MANY = 8, 56  # platforms
# Largest memory of a platform on every rank, bytes: its bodies, its three lines, names. The radiation memory of one spar alone
# takes several hundred kilobytes.
MOST_OF_PLATFORM = 6_000
CASE = """hawser: 1
environment: {{water: {{density: 1025, depth: 200}}, seabed: {{depth: 200, friction: 0}}, waves: {{regular: {{height: 2, period: 10, direction_deg: 0}}, ramp: 5}}}}
farm:
  - {{of: platform.yaml, at: {{{places}}}}}
contact: {{between_lines: false}}
statics: false
dynamics: {{duration: 0.2, step: 0.1}}
output: {{every: 0.1}}
"""


@unittest.skipIf("ASAN_OPTIONS" in os.environ, "the sanitizers must be loaded first")
class FarmOfPlatforms(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.place.name)
        shutil.copy(ROOT / "docs/tutorial/make_spar.py", cls.folder)
        subprocess.run([sys.executable, "make_spar.py"], cwd=cls.folder, check=True)
        platform = (ROOT / "docs/tutorial/platform-1.yaml").read_text("utf-8").replace("elements: 64", "elements: 3")
        (cls.folder / "platform.yaml").write_text(re.sub(r"^output:.*", "", platform, flags=re.M | re.S), "utf-8")

    @classmethod
    def tearDownClass(cls):
        cls.place.cleanup()

    def case(self, platforms):
        path = self.folder / f"farm{platforms}.yaml"
        places = ", ".join(f"P{i}: [{2000 * (i % 8)}, {2000 * (i // 8)}]" for i in range(platforms))
        path.write_text(CASE.format(places=places), "utf-8")
        return path

    def test_memory(self):
        """The memory of a rank for each platform is r + s/ranks; four and eight ranks separate r from s."""
        peaks = {}
        for platforms in (FEW, MANY):
            for ranks in (4, 8):
                counts = farm.counted_by_rank(HAWSER, COUNTER, ranks, self.case(platforms), self.folder)
                # The first rank writes descriptions, too.
                peaks[platforms, ranks] = statistics.median(c["Allocated"][1] for c in counts[1:])
        growth = {ranks: (peaks[MANY, ranks] - peaks[FEW, ranks]) / (MANY - FEW) for ranks in (4, 8)}
        on_all = 2 * growth[8] - growth[4]
        print(f"every rank has {on_all / 1000:.0f} kB of a platform of others")
        self.assertLess(on_all, MOST_OF_PLATFORM)

    def test_a_restart(self):
        calls = {}
        for platforms in (FEW, MANY):
            case = self.case(platforms)
            farm.run(HAWSER, 2, case)
            (self.folder / "again.h5").unlink(missing_ok=True)  # a run without steps replaces no results
            again = ["--restart", str(case.with_suffix(".h5")), "-o", str(self.folder / "again.h5")]
            calls[platforms] = farm.collectives(farm.counted_by_rank(HAWSER, COUNTER, 2, case, self.folder, again)[0])[0]
        self.assertLessEqual(calls[MANY], calls[FEW] + 10)

    def test_difference_forces_by_heading(self):
        """Places with different headings have the forces of the direction nearest to the sea's as seen from their bows, from one
        reading of the files."""
        shutil.copytree(self.folder, self.folder / "headings", ignore=shutil.ignore_patterns("farm*", "headings"))
        folder = self.folder / "headings"
        pairs = ((8, 8), (8, 12), (12, 12))
        rows = [f"{a} {b} {at} {at} {mode} {force} 0 {force} 0\n" for at, mode, force in ((0, 1, 0.2), (90, 2, 0.3)) for a, b in pairs]
        (folder / "spar.12d").write_text("".join(rows), "ascii")
        platform = (folder / "platform.yaml").read_text("utf-8").replace("wamit: spar ", "second_order: full\n        wamit: spar ")
        (folder / "platform.yaml").write_text(platform, "utf-8")
        case = CASE.format(places="ahead: [0, 0], abeam: [2000, 0, -90]").replace("{every: 0.1}", "{histories: [{body: ahead/spar}, {body: abeam/spar}]}")
        (folder / "farm.yaml").write_text(case, "utf-8")
        done = run(HAWSER, "run", folder / "farm.yaml", "-q")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        series = h5py.File(folder / "farm.h5")["series"]
        weight = 1025 * 9.80665
        for place, force in (("ahead", 0.2), ("abeam", 0.3)):
            of = series[f"{place}_spar"]
            column = [name.decode() for name in of.attrs["columns"]].index("drift_force_x")
            self.assertAlmostEqual(of[0, column] / (force * weight), 1, delta=1e-6)
        self.assertIn("forces at 90 deg as seen from the bow", run(HAWSER, "check", folder / "farm.yaml").stdout)


if __name__ == "__main__":
    unittest.main()
