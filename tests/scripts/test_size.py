"""The results size expected by `hawser check` is that of the file of a run."""
import os
import re
import shutil
import tempfile
import unittest
from pathlib import Path

import h5py

from support import ROOT, run

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
UNITS = {"kB": 1e3, "MB": 1e6, "GB": 1e9, "TB": 1e12}


class Size(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def expected(self, case, *options):
        result = run(HAWSER, "check", ROOT / "cases" / case, *options, timeout=300)
        self.assertEqual(result.returncode, 0, result.stderr)
        found = re.search(r"^expected results: about ([\d.]+) (\w+) \(fields ", result.stdout, re.MULTILINE)
        self.assertTrue(found, result.stdout)
        return float(found.group(1)) * UNITS[found.group(2)], result.stdout

    def check_checkpoints(self, file, output):
        """Without a trial the numbers per node are known, but not those of cables and friction."""
        found = re.search(r"checkpoints ([\d.]+) (\w+)", output)
        sizes = []
        with h5py.File(file) as results:
            results["checkpoint"].visititems(lambda _, item: sizes.append(item.id.get_storage_size() if isinstance(item, h5py.Dataset) else 0))
        self.assertLess(abs(float(found.group(1)) * UNITS[found.group(2)] / sum(sizes) - 1), 0.4, output)

    def check_size(self, case, *options):
        file = self.folder / "results.h5"
        done = run(HAWSER, "run", ROOT / "cases" / case, "-q", "-o", file, *options, timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr)
        size = file.stat().st_size
        for quick in ([], ["--quick"]):
            estimate, output = self.expected(case, *options, *quick)
            with self.subTest(case=case, quick=quick, size=size):
                if quick and "checkpoints" in output:
                    self.check_checkpoints(file, output)
                # Without a trial the number of steps is a guess.
                self.assertLess(abs(estimate / size - 1), 0.15 if not quick else 0.5, f"{estimate:g} is expected, {size} are there")

    def test_of_a_line_with_fixed_steps(self):
        self.check_size("mooring-line/mooring-line.yaml", "--set", "dynamics.duration=20", "--set", "output.every=0.2")

    def test_of_bodies_and_meshes_in_automatic_steps(self):
        # The run is as long as the trial, because later steps differ.
        self.check_size("barge-hawser/barge-hawser.yaml", "--set", "dynamics.duration=10", "--set", "output.every=0.1")

    def test_of_statics(self):
        self.check_size("hanging-line/hanging-line.yaml")

    def test_what_is_much_is_noted(self):
        case = ("mooring-line/mooring-line.yaml", "--quick", "--set", "dynamics.duration=10800", "--set", "output.every=0.1")
        estimate, output = self.expected(*case)
        self.assertGreater(estimate, 2e9)
        self.assertRegex(output, "\nnote: (fields are most of the file|the disk of .* has .* free)")
        _, output = self.expected(*case, "--set", "output.every=0.00002")
        self.assertIn("free, and a run needs up to twice the size of its results", output)


if __name__ == "__main__":
    unittest.main()
