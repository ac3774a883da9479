"""Warnings of lines that are deep inside a volume: each volume has its own acceptable depth."""
import os
import tempfile
import unittest
from pathlib import Path

from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
# A wire under tension over a stiff roller and a soft roller.
CASE = """\
hawser: 1
line_types:
  wire: {outer_diameter: 0.1, mass_per_length: 20, EA: 2.0e7, bending: false}
volumes:
  first: {shape: {cylinder: {from: [10, -2, 0], to: [10, 2, 0], radius: 0.3}}, FIRST}
  second: {shape: {cylinder: {from: [20, -2, 0], to: [20, 2, 0], radius: 0.3}}, SECOND}
lines:
  wire:
    sections: [{type: wire, length: 30, elements: 120}]
    end_a: {anchor: [0, 0, 0]}
    end_b: {anchor: [30, 0, 0]}
    start: {points: [[0, 0, 0], [10, 0, 0.36], [20, 0, 0.36], [30, 0, 0]]}
dynamics: {duration: 0.02, step: 0.01}
output: {every: 0.01}
"""
DEEP = "normal_stiffness: {per_length: 6.0e5}"  # N/m²: about 2 cm of penetration, where 5 mm, a tenth of the radius, is acceptable
STIFF = "normal_stiffness: {per_length: 1.0e8}"
SOFT = "normal_stiffness: {allowed_penetration: 0.04}"
DROP = """\
hawser: 1
line_types: {p: {pipe: {outer_diameter: 0.18126428, wall_thickness: 0.0084157822}}}
volumes: {deck: {shape: {plane: {point: [0, 0, 0], normal: [0, 0, 1]}}}}
lines:
  p:
    sections: [{type: p, length: 3.1751046, elements: 17}]
    end_a: free
    end_b: free
    start: {points: [[-0.89166576, -1.31333, 0.099052084], [0.89166576, 1.31333, 0.13998116]]}
statics: false
dynamics: {duration: 0.5}
"""


class DeepContacts(unittest.TestCase):
    def warnings(self, first, second, *launch):
        with tempfile.TemporaryDirectory() as folder:
            write(Path(folder), "wire.yaml", CASE.replace("FIRST", first).replace("SECOND", second))
            done = run(*launch, HAWSER, "run", "wire.yaml", "-o", "wire.h5", cwd=folder)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            return [text for text in (done.stdout + done.stderr).splitlines() if "m inside volume" in text]

    def test_penetration_in_an_impact(self):
        """A pipe that falls onto a deck on an automatic stiffness penetrates by an eighth of its radius."""
        with tempfile.TemporaryDirectory() as folder:
            write(Path(folder), "drop.yaml", DROP)
            done = run(HAWSER, "run", "drop.yaml", cwd=folder)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        depth = next(float(line.split()[3]) for line in done.stdout.splitlines() if line.startswith("max penetration"))
        self.assertGreater(depth, 0.1 * 0.0906)
        self.assertNotIn("inside volume deck", done.stdout)

    def test_the_deep_volume_is_named(self):
        for launch in ((), ("mpirun", "-n", 2)):
            found = self.warnings(DEEP, STIFF, *launch)
            self.assertEqual(len(found), 1, found)
            self.assertIn("inside volume first ", found[0])

    def test_a_soft_volume_hides_no_other(self):
        self.assertEqual(self.warnings(SOFT, STIFF), [])
        found = self.warnings(SOFT, DEEP)
        self.assertEqual(len(found), 1, found)
        self.assertIn("inside volume second ", found[0])

    def test_a_restart_remembers_the_deepest(self):
        # The wire is deep at rest only: an event switches its contact off before the end of the first run.
        event = "events: [{contact: {volume: first, enabled: false}, time: 0.01}]\n"
        with tempfile.TemporaryDirectory() as folder:
            case = CASE.replace("FIRST", DEEP).replace("SECOND", STIFF) + event
            write(Path(folder), "wire.yaml", case.replace("every: 0.01", "every: 0.01, checkpoint_every: 0.01"))
            first = run(HAWSER, "run", "wire.yaml", "--stop-at", "0.02", "--set", "dynamics.duration=0.03", "-o", "a.h5", cwd=folder)
            self.assertEqual(first.returncode, 0, first.stdout + first.stderr)
            for launch in ((), ("mpirun", "-n", 2)):
                end = run(*launch, HAWSER, "run", "wire.yaml", "--restart", "a.h5", "--set", "dynamics.duration=0.03", "-o", "b.h5", cwd=folder)
                self.assertEqual(end.returncode, 0, end.stdout + end.stderr)
                self.assertIn("inside volume first ", end.stdout + end.stderr)


if __name__ == "__main__":
    unittest.main()
