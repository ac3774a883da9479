"""200 random scenes of contact (random_scenes.py) at default settings: statics, then 10 s of motion. A scene passes if it ends with
exit code 0, and its energy closes to 1 % or it warns. At least the share LEAST must pass; a failure lists kinds and causes. It takes
an hour, and runs only with HAWSER_FULL in the environment.

`test_scenes.py halves [SEED...]` runs scenes again with half as long elements and steps, and prints those whose largest tension
changes by more than 5 % without a warning.
"""
import collections
import math
import os
import re
import resource
import shutil
import sys
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from random_scenes import scene
from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
LIMIT = 120      # s of CPU time
LEAST = 0.94     # share of all scenes that must pass
SCENES = 200


class Run:
    """Outcome of a scene: exit code, energy error [%], number of warnings, largest tension [N] and output."""

    def __init__(self, folder, seed, finer=1, shorter=1):
        s = scene(seed, finer, shorter)
        self.title = s.title
        place = folder / f"{seed}-{finer}"
        for name, text in s.files.items():
            write(place, name, text)
        write(place, "case.yaml", s.text())
        limit = lambda: resource.setrlimit(resource.RLIMIT_CPU, (LIMIT * finer * shorter, LIMIT * finer * shorter + 1))
        result = run(HAWSER, "run", "case.yaml", "-o", "case.h5", cwd=place, preexec_fn=limit)
        shutil.rmtree(place)
        self.exit, self.text = result.returncode, result.stdout + result.stderr
        share = re.search(r"balance error \S+ J \((\S+) % of the work done", self.text)
        self.error = abs(float(share[1])) if share else 0.0 if self.exit else math.inf
        self.warnings = self.text.count("warning: ")
        self.tension = max((float(t) for t in re.findall(r"max effective tension +.+? +(\S+) N ", self.text)), default=0.0)

    def fault(self):
        """Short reason why the scene does not pass; empty if it does."""
        if self.exit in (-24, -9):
            return f"more than {LIMIT} s of CPU time"
        if self.exit == 4:
            return "exit 4, energy made"
        if self.exit:
            return f"exit {self.exit}: " + re.sub(r"[\d.e+-]+", "#", (self.text.strip().splitlines() or [""])[-1][:70])
        return "energy error without a warning" if self.error > 1 and not self.warnings else ""


@unittest.skipUnless(os.environ.get("HAWSER_FULL"), "takes an hour; set HAWSER_FULL to run it")
class Scenes(unittest.TestCase):
    def test_scenes(self):
        seeds = range(SCENES)
        folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        with ThreadPoolExecutor(2) as pool:
            runs = list(pool.map(lambda seed: Run(folder, seed), seeds))
        failed = [(seed, r) for seed, r in zip(seeds, runs) if r.fault()]
        counts = collections.Counter((r.title.split()[0], r.fault()) for _, r in failed)
        report = "\n".join(f"{n} {kind}: {fault}" for (kind, fault), n in counts.most_common())
        report += "\n" + "\n".join(f"{r.title}: {r.text[-400:]}" for _, r in failed)
        self.assertLessEqual(len(failed), (1 - LEAST) * SCENES, report)


def halves(seeds):
    folder = Path(tempfile.mkdtemp())
    for seed in seeds:
        one = Run(folder, seed)
        if one.fault():
            continue
        two = Run(folder, seed, 2, 2)
        change = abs(two.tension / one.tension - 1) if one.tension else 0.0
        reported = one.warnings > 0 or two.warnings > 0
        print(f"{one.title}: exit {two.exit}, tension {one.tension:.4g} and {two.tension:.4g} N, {100 * change:.1f} %" +
              ("" if change <= 0.05 or reported else ", without a warning"), flush=True)
    shutil.rmtree(folder)


if __name__ == "__main__":
    if sys.argv[1:2] == ["halves"]:
        halves([int(s) for s in sys.argv[2:]] or range(SCENES))
    else:
        unittest.main()
