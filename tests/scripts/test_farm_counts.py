"""What a run asks of MPI does not grow with the lines of a farm, nor with the ranks."""
import os
import re
import sys
import tempfile
import unittest
from pathlib import Path

from support import ROOT, run

sys.path.insert(0, str(ROOT / "tests/bench"))
import farm  # noqa: E402

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
COUNTER = os.environ.get("HAWSER_MPI_COUNTER", str(ROOT / "build/tests/libmpi_counts.so"))
FEW, MANY, RANKS = 100, 1000, (2, 4, 8)
STEPS = 5  # more in the second run of each farm and number of ranks
MOST_OF_WRITE = 5  # collective calls for a data set in the file; how often outputs are written depends on the time that it takes
MOST_OF_RUN, MOST_OF_STEP = 400, 30  # collective calls without those
MOST_BYTES = 1000  # a step
ELEMENT = 208  # bytes of an element that ranks exchange


@unittest.skipIf("ASAN_OPTIONS" in os.environ, "the sanitizers must be loaded first")
class Counts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """What MPI is asked for by a run of one step and by one of more steps: {(lines, ranks): [counts, counts]}."""
        cls.found, cls.index = {}, {}
        with tempfile.TemporaryDirectory() as folder:
            case = Path(folder) / "case.yaml"
            for lines in (FEW, MANY):
                for steps in (1, 1 + STEPS):
                    case.write_text(farm.farm(lines, 3, 0.1 * steps, 0.1, 0.1 * steps), "utf-8")
                    for ranks in RANKS:
                        counts = farm.counted(HAWSER, COUNTER, ranks, case, folder)
                        cls.index.setdefault(lines, []).append(cls.size(Path(folder) / "case.h5", "/checkpoint/0/index"))
                        cls.found.setdefault((lines, ranks), []).append(counts)

    @staticmethod
    def size(results, name):
        """Numbers in a data set."""
        listed = run("h5ls", f"{results}{name}").stdout
        return int(re.search(r"Dataset {(\d+)}", listed)[1])

    @staticmethod
    def calls(counts):
        """Collective calls without those for data sets, and the number of these."""
        writes = counts["File_write_at_all"][0]
        return farm.collectives(counts)[0] - MOST_OF_WRITE * writes, writes

    def test_a_run(self):
        few = self.calls(self.found[FEW, RANKS[0]][0])
        for at, runs in self.found.items():
            calls, writes = self.calls(runs[0])
            with self.subTest("lines, ranks", at=at):
                self.assertLessEqual(calls, min(few[0] + 4, MOST_OF_RUN))
                self.assertLessEqual(writes, 400)

    def test_a_step(self):
        for at, (short, long) in self.found.items():
            with self.subTest("lines, ranks", at=at):
                self.assertLessEqual((self.calls(long)[0] - self.calls(short)[0]) / STEPS, MOST_OF_STEP)
                size = farm.collectives(long)[1] - farm.collectives(short)[1]
                self.assertLessEqual(size / STEPS, MOST_BYTES)

    def test_checkpoints_name_no_lines(self):
        """Every rank has the names of what is in a checkpoint."""
        few, many = max(self.index[FEW]), max(self.index[MANY])
        self.assertLess(many, 1.1 * few)

    def test_separate_lines_are_not_exchanged(self):
        for (lines, ranks), runs in self.found.items():
            with self.subTest("lines, ranks", at=(lines, ranks)):
                sent = max(sum(counts.get(name, (0, 0))[1] for name in ("Send", "Isend")) for counts in runs)
                self.assertLess(sent, 0.02 * 3 * lines * ELEMENT)


if __name__ == "__main__":
    unittest.main()
