"""Restarts that are refused: other masses, stiffnesses, positions and hydrodynamic files, another version, and an end at or before the checkpoint."""
import os
import shutil
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
CASE = """\
hawser: 1
environment: {gravity: 9.81, water: {density: 1000, depth: 100}}
line_types: {rope: {outer_diameter: 0.05, mass_per_length: 5, EA: 1e6, bending: false, Cd_normal: 1.2}}
bodies:
  float:
    floating:
      mass: 261800
      centre_of_mass: [0, 0, -1]
      inertia: [2.6e6, 2.6e6, 2.6e6]
      stiffness: [1e4, 1e4, 0]
      turning_stiffness: [0, 0, 1e6]
      hydrodynamics: {wamit: float, length_scale: 5, displaced_volume: 261.8}
lines:
  rope: {sections: [{type: rope, length: 40, elements: 4}], end_a: {anchor: [50, 0, -10]}, end_b: {body: float, at: [5, 0, 0]}}
contact: {between_lines: false}
dynamics: {duration: 0.4, step: 0.1}
output: {every: 0.2}
"""


class RestartMessages(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        for ending in ("1", "hst"):
            shutil.copy(ROOT / f"tests/data/hemisphere.{ending}", self.folder / f"float.{ending}")
            shutil.copy(ROOT / f"tests/data/hemisphere.{ending}", self.folder / f"other.{ending}")
        write(self.folder, "case.yaml", CASE)
        self.succeed("--stop-at", "0.2", "-o", "half.h5")

    def run_case(self, *words, ranks=0):
        launch = ("mpirun", "--allow-run-as-root", "--oversubscribe", "-n", str(ranks)) if ranks else ()
        return run(*launch, HAWSER, "run", "case.yaml", "-q", *words, cwd=self.folder)

    def succeed(self, *words, ranks=0):
        done = self.run_case(*words, ranks=ranks)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def refused(self, part, *words, ranks=0):
        before = {path: path.stat().st_mtime_ns for path in self.folder.iterdir()}
        done = self.run_case(*words, ranks=ranks)
        sentences = [line for line in done.stderr.splitlines() if line.startswith("hawser: ")]
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertEqual(len(sentences), 1, done.stderr)
        self.assertIn(part, sentences[0])
        self.assertEqual({path: path.stat().st_mtime_ns for path in self.folder.iterdir()}, before)

    def test_keys_of_the_state(self):
        body, files, rope = "bodies.float.floating.", "bodies.float.floating.hydrodynamics.", "line_types.rope."
        for key, value in ((body + "mass", "271800"), (body + "inertia[1]", "2.7e6"), (body + "centre_of_mass[2]", "-1.1"),
                           (files + "length_scale", "5.1"), (files + "displaced_volume", "262"), (rope + "EA", "2e6"),
                           (rope + "mass_per_length", "6"), (rope + "outer_diameter", "0.06")):
            with self.subTest(key=key):
                name = key.split("[")[0]
                self.refused(f"it holds another case: {name} differs from the checkpoint", "--restart", "half.h5", "-o", "rest.h5", "--set", f"{key}={value}")
        # Keys of the later part of the run.
        self.succeed("--restart", "half.h5", "-o", "rest.h5", "--set", rope + "Cd_normal=1.4", "--set", body + "damping=[1e3, 1e3, 0]",
                     "--set", "dynamics.duration=0.6", "--set", body + "loads=[{table: {rows: [[0.2, 0, 0, 0], [1, 10, 0, 0]]}}]")

    def test_positions(self):
        body = "bodies.float."
        for key, value, name in (("position", "[1, 0, 0]", "position"), ("rotation_deg", "[0, 0, 5]", "rotation_deg"),
                                 ("floating.hydrodynamics.place", "[1, 0, 0]", "floating.hydrodynamics.place"),
                                 ("floating.hydrodynamics.heading_deg", "5", "floating.hydrodynamics.heading_deg")):
            with self.subTest(key=key):
                self.refused(f"it holds another case: {body}{name} ", "--restart", "half.h5", "-o", "rest.h5", "--set", f"{body}{key}={value}")
        for ranks in (0, 2):
            with self.subTest(ranks=ranks):
                self.refused("end A of line rope is at [50, 0, -10] m in the file, and this case holds it at [51, 0, -10] m", "--restart", "half.h5",
                             "-o", "rest.h5", "--set", "lines.rope.end_a.anchor[0]=51", ranks=ranks)
                self.refused("it holds another case: end B of line rope is at [", "--restart", "half.h5", "-o", "rest.h5",
                             "--set", "lines.rope.end_b.at[0]=5.1", ranks=ranks)

    def test_positions_in_a_checkpoint_of_the_start(self):
        failed = self.run_case("-o", "start.h5", "--set", "bodies.float.floating.loads=[{table: {rows: [[0, 0, 0, 0], [0.001, 1e30, 0, 0]]}}]")
        self.assertIn("stopped at t = 0 s", failed.stderr)
        self.refused("end A of line rope is at [50, 0, -10] m in the file, and this case holds it at [51, 0, -10] m", "--restart", "start.h5",
                     "-o", "rest.h5", "--set", "lines.rope.end_a.anchor[0]=51")
        self.succeed("--restart", "start.h5", "-o", "rest.h5")

    def test_a_released_end_is_where_it_is(self):
        write(self.folder, "case.yaml", CASE + "events: [{release: {line: rope, end: end_a}, time: 0.1}]\n")
        self.succeed("--stop-at", "0.2", "-o", "released.h5")
        self.succeed("--restart", "released.h5", "-o", "rest.h5")

    def test_another_version(self):
        with h5py.File(self.folder / "half.h5", "r+") as file:
            version = file.attrs["version"].decode()
            del file.attrs["version"]
            file.attrs["version"] = np.bytes_("0.0.9+1a2b3c4d")
        change = ("--set", "bodies.float.floating.hydrodynamics.origin_in_file=[0, 0, 0]")
        for ranks in (0, 2):
            self.refused(f"origin_in_file is not in it; another version of hawser (0.0.9+1a2b3c4d; this is {version}) wrote it: if the case is the same, "
                         "continue with that version, start from its last shape by 'start: {from: half.h5}', or repeat the run",
                         "--restart", "half.h5", "-o", "rest.h5", *change, ranks=ranks)
        self.succeed("--restart", "half.h5", "-o", "rest.h5")
        with h5py.File(self.folder / "half.h5", "r+") as file:
            del file.attrs["version"]
        self.refused("origin_in_file is not in it (the case", "--restart", "half.h5", "-o", "rest.h5", *change)

    def test_end_at_or_before_the_checkpoint(self):
        shutil.copy(self.folder / "half.h5", self.folder / "there.h5")
        for ranks in (0, 2):
            for end in (("--stop-at", "0.1"), ("--set", "dynamics.duration=0.1")):
                with self.subTest(end=end, ranks=ranks):
                    self.refused("its checkpoint is at t = 0.2 s and the run ends at 0.1 s", "--restart", "half.h5", "-o", "new.h5", *end, ranks=ranks)
            self.refused("and the run ends at 0.2 s", "--restart", "half.h5", "-o", "there.h5", "--stop-at", "0.2", ranks=ranks)
        # The same file keeps its rows, and a new one has the last state.
        self.succeed("--restart", "half.h5", "-o", "half.h5", "--stop-at", "0.2")
        self.succeed("--restart", "half.h5", "--stop-at", "0.2", "-o", "new.h5")


if __name__ == "__main__":
    unittest.main()
