"""The number of MPI calls of a run does not increase with the lines of a farm or the ranks; each rank reads
and stores only its share of restarts and results."""
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
FULL = bool(os.environ.get("HAWSER_FULL"))
FEW, MANY, RANKS = (100, 1000, (2, 4, 8)) if FULL else (100, 400, (2, 8))
STEPS = 5  # additional steps in the second run of each farm and number of ranks, and in the third, with an output each
MOST_OF_STEP, MOST_BYTES = 10, 1000  # collective calls in a step, and the bytes in them
FEW_ROPES, FEW_FALLING = 25, 10
MOST_BYTES_ON_VOLUMES = 1100  # in the collective calls of a step
MOST_OF_OUTPUT = 60  # collective calls
MOST_OF_RUN = 900  # collective calls of the start, statics, and one step and output
REST_OF_FILE = 100000  # bytes that a rank may read of a results file besides its share: names, headers, the counter of an output
ELEMENT = 208  # bytes of an element that ranks exchange
FINE = 600 if FULL else 200  # elements of the lines of which the memory for a node is measured
FARM = 2000 if FULL else 800  # lines of other ranks of which the memory for a line is measured
MOST_OF_LINE, MOST_OF_NODE = 150, 20  # allocations on every rank for a line and for a node of the model, bytes


@unittest.skipIf("ASAN_OPTIONS" in os.environ, "the sanitizers must be loaded first")
class Counts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """MPI calls of runs with one step, with more, and with more and as many outputs: {(lines, ranks): [counts]}."""
        cls.found, cls.index = {}, {}
        with tempfile.TemporaryDirectory() as folder:
            case = Path(folder) / "case.yaml"
            for lines in (FEW, MANY):
                for steps, every in ((1, 1), (1 + STEPS, 1 + STEPS), (1 + STEPS, 1)):
                    case.write_text(farm.farm(lines, 3, 0.1 * steps, 0.1, 0.1 * every), "utf-8")
                    for ranks in RANKS:
                        counts = farm.counted(HAWSER, COUNTER, ranks, case, folder)
                        cls.index.setdefault(lines, []).append(cls.size(Path(folder) / "case.h5", "/checkpoint/0/index"))
                        cls.found.setdefault((lines, ranks), []).append(counts)

    def test_memory(self):
        """A rank stores little of lines and nodes of other ranks."""
        with tempfile.TemporaryDirectory() as folder:
            def of_others(lines, elements):
                """Peak on 8 ranks without that on 4 with half of the lines, where a rank has as many."""
                case, peaks = Path(folder) / "case.yaml", []
                for ranks in (8, 4):
                    case.write_text(farm.farm(lines * ranks // 8, elements, 0.1, 0.1, 0.1), "utf-8")
                    peaks.append(farm.peak_memory(HAWSER, COUNTER, ranks, case, folder, "Allocated"))
                return peaks[0] - peaks[1]

            few, many, fine = of_others(2 * FEW, 3), of_others(2 * FARM, 3), of_others(2 * FEW, FINE)
        node = (fine - few) / (FEW * (FINE - 3))
        line = (many - few) / (FARM - FEW) - 4 * node
        print(f"every rank has {line:.0f} B of a line and {node:.0f} B of a node of others")
        self.assertLess(line, MOST_OF_LINE)
        self.assertLess(node, MOST_OF_NODE)

    def test_a_restart(self):
        """A rank reads its own data, the same amount again for the checksum, and receives none from other
        ranks."""
        with tempfile.TemporaryDirectory() as folder:
            case, rest = Path(folder) / "case.yaml", Path(folder) / "rest.h5"
            case.write_text(farm.farm(MANY, 3, 0.1, 0.1, 0.1), "utf-8")
            farm.run(HAWSER, 1, case)
            results = Path(folder) / "case.h5"
            whole = 8 * max(self.checkpoint_numbers(results, slot) for slot in (0, 1))
            for ranks in RANKS:
                # The restart begins at the end, so nothing is left to compute, and no results are replaced.
                rest.unlink(missing_ok=True)
                counts = farm.counted_by_rank(HAWSER, COUNTER, ranks, case, folder, ["--restart", str(results), "-o", str(rest)])
                for rank, each in enumerate(counts):
                    with self.subTest("ranks, rank", at=(ranks, rank)):
                        copied = rest.stat().st_size if rank == 0 else 0  # bytes of the new file, which is trimmed
                        self.assertLess(each["pread"][1] - copied, 2.02 * whole / ranks + REST_OF_FILE)
                        self.assertLess(each["Bcast"][1], REST_OF_FILE)

    def test_going_on_in_the_same_file(self):
        """A run that continues in the same file reads the checkpoint no more often than one that continues in
        another file."""
        ranks = 2
        with tempfile.TemporaryDirectory() as folder:
            case, results = Path(folder) / "case.yaml", Path(folder) / "case.h5"
            case.write_text(farm.farm(MANY, 3, 0.2, 0.1, 0.1), "utf-8")
            farm.run(HAWSER, ranks, case, options=["--stop-at", "0.1"])
            whole = 8 * max(self.checkpoint_numbers(results, slot) for slot in (0, 1))
            counts = farm.counted_by_rank(HAWSER, COUNTER, ranks, case, folder, ["--restart", str(results)])
            self.assertGreater(counts[1]["pread"][1], 1.9 * whole / ranks)
            self.assertLess(counts[1]["pread"][1], 2.02 * whole / ranks + REST_OF_FILE)

    @staticmethod
    def checkpoint_numbers(results, slot):
        """Length of the array of a checkpoint."""
        listed = run("h5ls", "-d", f"{results}/checkpoint/{slot}/header").stdout
        return int(listed.split("Data:")[1].replace(",", " ").split()[1])

    @staticmethod
    def size(results, name):
        """Numbers in a data set."""
        listed = run("h5ls", f"{results}{name}").stdout
        return int(re.search(r"Dataset {(\d+)}", listed)[1])

    def test_a_run(self):
        for at, runs in self.found.items():
            with self.subTest("lines, ranks", at=at):
                self.assertLessEqual(farm.collectives(runs[0])[0], MOST_OF_RUN)

    def test_a_step(self):
        for at, (short, long, _) in self.found.items():
            with self.subTest("lines, ranks", at=at):
                calls, size = (b - a for a, b in zip(farm.collectives(short), farm.collectives(long)))
                self.assertLessEqual(calls / STEPS, MOST_OF_STEP)
                self.assertLessEqual(size / STEPS, MOST_BYTES)

    def test_an_output(self):
        for at, (_, long, outputs) in self.found.items():
            with self.subTest("lines, ranks", at=at):
                calls = farm.collectives(outputs)[0] - farm.collectives(long)[0]
                self.assertLessEqual(calls / STEPS, MOST_OF_OUTPUT)

    def test_checkpoints_name_no_lines(self):
        """Names in a checkpoint, which every rank stores, do not include lines."""
        few, many = max(self.index[FEW]), max(self.index[MANY])
        self.assertLess(many, 1.1 * few)

    def test_separate_lines_are_not_exchanged(self):
        for (lines, ranks), runs in self.found.items():
            with self.subTest("lines, ranks", at=(lines, ranks)):
                sent = max(sum(counts.get(name, (0, 0))[1] for name in ("Send", "Isend")) for counts in runs)
                self.assertLess(sent, 0.02 * 3 * lines * ELEMENT)


@unittest.skipIf("ASAN_OPTIONS" in os.environ, "the sanitizers must be loaded first")
class LinesOnVolumes(unittest.TestCase):
    def test_a_step(self):
        """Collective calls of steps in which one line needs a warning of its edge, and the bytes in them, do not increase with
        the lines on volumes or the ranks; on one rank there are none."""
        with tempfile.TemporaryDirectory() as folder:
            case, found = Path(folder) / "case.yaml", {}
            for ropes in (FEW_ROPES, 4 * FEW_ROPES):
                for ranks in (1, 2, 4):
                    runs = []
                    for steps in (1, 1 + STEPS):
                        case.write_text(farm.edges(ropes, 0.05 * steps, 0.05, 0.05 * steps), "utf-8")
                        runs.append(farm.collectives(farm.counted(HAWSER, COUNTER, ranks, case, folder)))
                    found[ropes, ranks] = [(b - a) / STEPS for a, b in zip(*runs)]
        print("lines on volumes, ranks: collective calls and bytes of a step", found)
        for ropes, ranks in found:
            calls, size = found[ropes, ranks]
            with self.subTest("ropes, ranks", at=(ropes, ranks)):
                self.assertLessEqual(calls, 1.2 * found[FEW_ROPES, 2][0] if ranks > 1 else 0)
                self.assertLessEqual(size, 1.2 * found[FEW_ROPES, 2][1] if ranks > 1 else 0)
                self.assertLessEqual(size, MOST_BYTES_ON_VOLUMES)

    def test_steps_with_impacts(self):
        """Ranks do not exchange data of each line that has an impact on a volume."""
        with tempfile.TemporaryDirectory() as folder:
            case, sent = Path(folder) / "case.yaml", []
            for ropes in (FEW_FALLING, 4 * FEW_FALLING):
                case.write_text(farm.edges(ropes, 0.02, 0, 0.02, falling=True), "utf-8")
                sent.append(farm.counted(HAWSER, COUNTER, 2, case, folder)["Allreduce"][1])
            print("bytes in the reductions of steps with impacts", sent)
            self.assertLess(sent[1], 1.2 * sent[0])


if __name__ == "__main__":
    unittest.main()
