"""A farm that is repeatedly stopped, killed and continued on other numbers of ranks ends like an uninterrupted run,
and a long run needs no more memory at its end than in its middle. Only with HAWSER_FULL in the environment;
HAWSER_SOAK_SECONDS is the approximate duration (300), HAWSER_SOAK_SEED reproduces the interruptions."""
import os
import random
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import h5py
import numpy as np
from support import ROOT

sys.path.insert(0, str(ROOT / "tests/bench"))
import farm  # noqa: E402

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
SECONDS = float(os.environ.get("HAWSER_SOAK_SECONDS", "300"))
SEED = int(os.environ.get("HAWSER_SOAK_SEED") or random.SystemRandom().randrange(10**6))
LINES, ELEMENTS, STEP, EVERY = 7, 10, 0.1, 2.0  # number of lines not divisible by any number of ranks; s
SAME = 1e-7  # fraction of the range of a field: effect of Newton's tolerance (docs/decisions/005-several-ranks.md)
MORE = 1.0  # MB by which a rank may grow


def descendants(process):
    """Process ids of all direct and indirect children."""
    parents = {}
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            state = (folder / "stat").read_text("utf-8").rsplit(")", 1)[1].split()
            if state[0] != "Z":
                parents.setdefault(int(state[1]), []).append(int(folder.name))
        except OSError:  # it has ended
            pass
    found, to_see = [], [process]
    while to_see:
        children = parents.get(to_see.pop(), [])
        found += children
        to_see += children
    return found


def resident(process):
    """Memory of each rank [MB] by process id."""
    found = {}
    for child in descendants(process):
        try:
            if (Path("/proc") / str(child) / "comm").read_text("utf-8").strip() == "hawser":
                found[child] = int((Path("/proc") / str(child) / "statm").read_text("utf-8").split()[1]) / 256
        except OSError:
            pass
    return found


def outputs_in(results):
    """Number of valid outputs in a file."""
    try:
        with h5py.File(results, "r", locking=False) as file:
            return int(np.ravel(file["written"][()].item())[0])
    except OSError:  # no file yet
        return 0


class Soak(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.random = random.Random(SEED)

    def start(self, ranks, results, restart):
        words = [HAWSER, "run", str(self.folder / "farm.yaml"), "-q", "-o", str(results)]
        if restart:
            words += ["--restart", str(results)]
        if ranks > 1:
            words = ["mpirun", "--oversubscribe", "-n", str(ranks), *words]
        with open(self.folder / "printed.txt", "w", encoding="utf-8") as printed:
            return subprocess.Popen(words, stdout=printed, stderr=printed)

    def interrupt(self, process):
        """Interrupts as a user, a batch system or a power failure would."""
        if self.random.random() < 0.5:
            process.send_signal(signal.SIGINT)
            process.wait(120)
            return
        all_of_it = [*descendants(process.pid), process.pid]
        for each in all_of_it:
            try:
                os.kill(each, signal.SIGKILL)
            except ProcessLookupError:
                pass
        process.wait(60)
        while any((Path("/proc") / str(each)).exists() for each in all_of_it):
            time.sleep(0.1)  # its lock on the file is released with it

    def until_done(self, results, outputs):
        """A run interrupted at random moments after up to a tenth of its `outputs`; number of interruptions."""
        restarts = 0
        while True:
            before, more = outputs_in(results), self.random.randint(0, outputs // 10)
            process = self.start(self.random.choice((1, 2, 3)), results, results.exists())
            while process.poll() is None and outputs_in(results) <= before + more:
                time.sleep(0.05)
            time.sleep(self.random.uniform(0, 0.3))
            if process.poll() is None:
                self.interrupt(process)
                restarts += 1
                self.assertLess(restarts, 1000, "the run does not get on")
                continue
            self.assertEqual(process.returncode, 0, (self.folder / "printed.txt").read_text("utf-8"))
            return restarts

    def write_case(self, duration):
        case = farm.farm(LINES, ELEMENTS, duration, STEP, EVERY)
        (self.folder / "farm.yaml").write_text(case.replace("output: {", "output: {checkpoint_every: 2, "), "utf-8")

    @unittest.skipUnless(os.environ.get("HAWSER_FULL"), "long")
    def test_interrupted_like_unbroken(self):
        straight, broken = self.folder / "straight.h5", self.folder / "broken.h5"
        durations = []
        for duration in (20.0, 220.0):  # durations that include the start
            self.write_case(duration)
            begun = time.monotonic()
            self.assertEqual(self.start(2, straight, False).wait(600), 0, (self.folder / "printed.txt").read_text("utf-8"))
            durations.append(time.monotonic() - begun)
            straight.unlink()
        # Time for each of the two runs; the second one restarts often.
        spent = 0.3 * SECONDS
        pace = max(durations[1] - durations[0], 0.1) / 200
        duration = EVERY * max(50, round(spent / pace / EVERY))
        self.write_case(duration)

        process, memory = self.start(2, straight, False), {}
        while process.poll() is None:
            for rank, size in resident(process.pid).items():
                memory.setdefault(rank, []).append(size)
            time.sleep(0.2)
        self.assertEqual(process.returncode, 0, (self.folder / "printed.txt").read_text("utf-8"))
        self.assertEqual(len(memory), 2)
        for sizes in memory.values():
            quarter = len(sizes) // 4
            self.assertGreater(quarter, 4)
            middle, end = statistics.median(sizes[quarter:2 * quarter]), statistics.median(sizes[-quarter:])
            self.assertLess(end - middle, MORE, sizes)

        restarts = self.until_done(broken, round(duration / EVERY))
        self.assertGreater(restarts, 4, f"HAWSER_SOAK_SEED={SEED}")
        with h5py.File(straight, "r") as one, h5py.File(broken, "r") as other:
            self.assertEqual(set(one["fields"]), set(other["fields"]))
            for name in one["fields"]:
                a, b = one["fields"][name][:], other["fields"][name][:]
                self.assertEqual(a.shape, b.shape, name)
                self.assertTrue(np.array_equal(np.isnan(a), np.isnan(b)), name)
                worst = np.nanmax(np.abs(a - b))
                self.assertLessEqual(worst, SAME * (np.nanmax(a) - np.nanmin(a)), f"{name}, HAWSER_SOAK_SEED={SEED}")
        print(f"{restarts} interruptions in {duration:g} s of motion, HAWSER_SOAK_SEED={SEED}")


if __name__ == "__main__":
    unittest.main()
