"""Restarts of bodies with radiation memory at times that are no multiple of the step, so that the memory does not
take all of its integrals from the table of multiples of the step."""
import json
import os
import shutil
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
START = 5.0  # m of surge


class Restarts(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        shutil.copy(ROOT / "tests/data/f3of.1", self.folder)
        write(self.folder, "f3of.hst", "3 3 100\n9 9 10\n15 15 10\n")

    def case(self, duration, output):
        """Three bodies that radiate on each other, joined by stiff links, in steps of 0.2 s."""
        text = "hawser: 1\nenvironment: {gravity: 9.81, water: {density: 1000}}\nbodies:\n"
        for number, (name, mass, x, spring) in enumerate((("base", 1089825, 0, 1e5), ("one", 179250, -12.5, 0), ("two", 179250, 12.5, 0))):
            held = np.diag([spring, 1e11, 1e11, 1e13, 1e13, 1e13]).tolist()
            text += (f"  {name}: {{position: [{x + START}, 0, -9], floating: {{mass: {mass}, inertia: [1e8, 1e8, 1e8], hydrodynamics: {{wamit: f3of, "
                     f"body: {number + 1}, place: [{x}, 0, -9], heading_deg: 0, stiffness: {json.dumps(held)}}}}}}}\n")
        write(self.folder, "case.yaml", text + "links:\n"
              "  first: {end_a: {body: base, at: [0, 0, 0]}, end_b: {body: one, at: [0, 0, 0]}, stiffness: 5e10}\n"
              "  second: {end_a: {body: base, at: [0, 0, 0]}, end_b: {body: two, at: [0, 0, 0]}, stiffness: 5e10}\n"
              f"statics: false\ndynamics: {{duration: {duration}, step: 0.2, rho_infinity: 1}}\n"
              f"output: {{{output}, histories: [{{body: base}}, {{body: one}}, {{body: two}}]}}\n")

    def run_case(self, ranks, *words):
        launch = ("mpirun", "--allow-run-as-root", "--oversubscribe", "-n", str(ranks)) if ranks > 1 else ()
        done = run(*launch, HAWSER, "run", "case.yaml", "-q", *words, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def difference(self, one, other, after):
        """Largest difference of positions and rotations at the times of both files after a time, relative to
        the start, and the number of these times."""
        with h5py.File(self.folder / one) as a, h5py.File(self.folder / other) as b:
            at, then = (file["series/time"][:] for file in (a, b))
            pairs = [(i, j) for i, t in enumerate(at) if t > after + 1e-6 for j in [int(np.argmin(np.abs(then - t)))] if abs(then[j] - t) < 1e-6]
            rows = np.array(pairs, int).reshape(-1, 2).T
            return max(np.abs(a["series"][name][:][rows[0], :6] - b["series"][name][:][rows[1], :6]).max(initial=0)
                       for name in ("base", "one", "two")) / START, len(pairs)

    def test_checkpoint_between_multiples_of_the_step(self):
        """The unbroken run ends a step at the stop too, because of a checkpoint: the restarted run is equal."""
        self.case(24, "every: 8, checkpoint_every: 9.37")
        for ranks, others in ((1, 1), (2, 2), (1, 2)):  # the last with the whole run of the second
            if ranks == others:
                self.run_case(others, "-o", "whole.h5")
            self.run_case(ranks, "--stop-at", "9.37", "-o", "part.h5")
            self.run_case(others, "--restart", "part.h5", "-o", "rest.h5")
            off, count = self.difference("rest.h5", "whole.h5", 9.37)
            print(f"restart at 9.37 s, {ranks} and {others} ranks: off by {off:.1e} at {count} times")
            self.assertGreater(count, 70)
            self.assertLess(off, 1e-12 if ranks == others else 1e-10)

    def test_restart_after_a_stop_between_multiples_of_the_step(self):
        """From the stop at 4.13 s to the end in steps of 0.2 s, with and without another restart: equal. The
        history has the table's lags back to the first stop and others before it. A run without stops has
        other steps: equal to their error, 1e-5."""
        self.case(16.13, "every: 1000")
        for ranks in (1, 2):
            self.run_case(ranks, "--stop-at", "4.13", "-o", "part.h5")
            self.run_case(ranks, "--restart", "part.h5", "-o", "whole.h5")
            self.run_case(ranks, "--restart", "part.h5", "--stop-at", "8.13", "-o", "more.h5")
            self.run_case(ranks, "--restart", "more.h5", "-o", "rest.h5")
            self.run_case(ranks, "-o", "unbroken.h5")
            off, count = self.difference("rest.h5", "whole.h5", 8.13)
            others, _ = self.difference("rest.h5", "unbroken.h5", 16)
            print(f"restart at 8.13 s after one at 4.13 s, {ranks} ranks: off by {off:.1e} at {count} times; from a run without stops by {others:.1e}")
            self.assertEqual(count, 40)
            self.assertLess(off, 1e-12)
            self.assertLess(others, 1e-5)

    def turning_case(self, follow):
        """The three bodies in a wave, each with another yaw, by 10 to 20 deg, that their slow headings follow. Forces of the waves
        differ by 30 deg of direction."""
        periods = sorted({float(line.split()[0]) for line in (self.folder / "f3of.1").read_text().splitlines()[1:]} - {0.0, -1.0})
        rows = []
        for period in periods:
            number = (2 * np.pi / period) ** 2 / 9.81
            for direction in range(0, 360, 30):
                c, s = np.cos(np.radians(direction)), np.sin(np.radians(direction))
                for body, size in enumerate((2000.0, 300.0, 300.0)):
                    for mode, X in ((1, 1j * number * size * c), (2, 1j * number * size * s), (3, 100.0 if body == 0 else 10.0), (6, 1j * number * size * s)):
                        rows.append(f"{period:.9g} {direction} {6 * body + mode} {abs(X):.9g} {np.degrees(np.angle(X)):.6g} {np.real(X):.9g} {np.imag(X):.9g}")
        write(self.folder, "f3of.3", "\n".join(rows) + "\n")
        text = ("hawser: 1\nenvironment: {gravity: 9.81, water: {density: 1000}, waves: {regular: {height: 0.5, period: 9, direction_deg: 40}, ramp: 5}}\n"
                "bodies:\n")
        for number, (name, mass, x, rate) in enumerate((("base", 1089825, 0, 0.02), ("one", 179250, -12.5, -0.03), ("two", 179250, 12.5, 0.04))):
            held = np.diag([1e5, 1e5, 1e6, 1e9, 1e9, 1e6]).tolist()
            text += (f"  {name}: {{position: [{x}, 0, -9], floating: {{mass: {mass}, inertia: [1e8, 1e8, 1e8], angular_velocity: [0, 0, {rate}], hydrodynamics: "
                     f"{{wamit: f3of, body: {number + 1}, follow_period: {follow}, stiffness: {json.dumps(held)}}}}}}}\n")
        write(self.folder, "case.yaml", text + "statics: false\ndynamics: {duration: 16, step: 0.1}\n"
              "output: {every: 8, checkpoint_every: 6.35, histories: [{body: base}, {body: one}, {body: two}]}\n")

    def test_slow_headings(self):
        """A group with slow headings on 1, 2 and 3 ranks, and restarts on another number of ranks. Followed headings change the
        motion by more than a hundredth of its size."""
        self.turning_case(0)
        self.run_case(1, "-o", "fixed.h5")
        self.turning_case(15)
        for ranks in (1, 2, 3):
            self.run_case(ranks, "-o", f"whole{ranks}.h5")
        followed, _ = self.difference("whole1.h5", "fixed.h5", 10)
        self.assertGreater(followed * START, 5e-3)
        for ranks in (2, 3):
            off, count = self.difference(f"whole{ranks}.h5", "whole1.h5", 0)
            print(f"slow headings, {ranks} ranks and 1: off by {off:.1e} at {count} times, of {followed:.1e} by the headings")
            self.assertGreater(count, 150)
            self.assertLess(off, 1e-10)
        for ranks, others in ((1, 2), (2, 1), (2, 3), (3, 1)):
            self.run_case(ranks, "--stop-at", "6.35", "-o", "part.h5")
            self.run_case(others, "--restart", "part.h5", "-o", "rest.h5")
            off, count = self.difference("rest.h5", "whole1.h5", 6.35)
            print(f"slow headings, restart of {ranks} on {others} ranks: off by {off:.1e} at {count} times")
            self.assertGreater(count, 90)
            self.assertLess(off, 1e-10)


if __name__ == "__main__":
    unittest.main()
