"""What a run asks of MPI does not grow with the lines of a farm, nor with the ranks."""
import os
import sys
import tempfile
import unittest
from pathlib import Path

from support import ROOT

sys.path.insert(0, str(ROOT / "tests/bench"))
import farm  # noqa: E402

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
COUNTER = os.environ.get("HAWSER_MPI_COUNTER", str(ROOT / "build/tests/libmpi_counts.so"))
FEW, MANY, RANKS = 100, 1000, (2, 4, 8)
STEPS = 5  # between the two runs that are compared
MOST_OF_STEP = 30, 1500  # collective calls and their bytes


@unittest.skipIf("ASAN_OPTIONS" in os.environ, "the sanitizers must be loaded first")
class Counts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """Of each number of lines and ranks what the parts of a run ask for: the steps, outputs, and all else."""
        cls.found = {}
        with tempfile.TemporaryDirectory() as folder:
            for lines in (FEW, MANY):
                for ranks in RANKS:
                    cls.found[lines, ranks] = [
                        farm.counted(HAWSER, COUNTER, ranks, cls.case(Path(folder), lines, steps, outputs), folder)
                        for steps, outputs in ((1, 1), (1 + STEPS, 1), (1 + STEPS, 1 + STEPS))
                    ]

    @staticmethod
    def case(folder, lines, steps, outputs):
        path = folder / "case.yaml"
        path.write_text(farm.farm(lines, 3, 0.1 * steps, 0.1, 0.1 * steps / outputs), "utf-8")
        return path

    def calls(self, lines, ranks):
        return [farm.collectives(counts)[0] for counts in self.found[lines, ranks]]

    def test_collectives_do_not_grow(self):
        reference = self.calls(FEW, RANKS[0])
        for lines, ranks in self.found:
            for found, expected in zip(self.calls(lines, ranks), reference):
                self.assertLessEqual(abs(found - expected), 2, f"{lines} lines on {ranks} ranks")

    def test_a_step(self):
        for lines, ranks in self.found:
            (few, small), (many, large) = (farm.collectives(counts) for counts in self.found[lines, ranks][:2])
            self.assertLessEqual((many - few) / STEPS, MOST_OF_STEP[0], f"{lines} lines on {ranks} ranks")
            self.assertLessEqual((large - small) / STEPS, MOST_OF_STEP[1], f"{lines} lines on {ranks} ranks")

    def test_separate_lines_send_nothing(self):
        for (lines, ranks), runs in self.found.items():
            sizes = [size for counts in runs for name, (_, size) in counts.items() if name in ("Send", "Isend")]
            self.assertEqual(sum(sizes), 0, f"{lines} lines on {ranks} ranks")


if __name__ == "__main__":
    unittest.main()
