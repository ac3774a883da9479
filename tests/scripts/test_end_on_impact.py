"""A rope that is lowered onto a deck with its end first: the automatic stiffness stays at that of the rope itself."""
import os
import re
import tempfile
import unittest
from pathlib import Path

from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
DIAMETER, EA = 0.118, 1.53e7
CASE = f"""\
hawser: 1
line_types:
  rope: {{outer_diameter: {DIAMETER}, mass_per_length: 10.5, EA: {EA}, EI: 583, GJ: 583}}
bodies:
  hoist: {{position: [0, 0, 15.3], motion: {{velocity: [0, 0, -0.9], ramp: 1}}}}
volumes:
  deck: {{shape: {{plane: {{point: [0, 0, 0], normal: [0, 0, 1]}}}}, friction: 0.4}}
lines:
  rope:
    sections: [{{type: rope, length: 14.9, elements: 25}}]
    end_a: {{body: hoist, at: [0, 0, 0]}}
    end_b: free
dynamics: {{duration: 1.2}}
"""


class EndOnImpact(unittest.TestCase):
    def test_stiffness_and_energy(self):
        with tempfile.TemporaryDirectory() as folder:
            write(Path(folder), "rope.yaml", CASE)
            done = run(HAWSER, "run", "rope.yaml", cwd=folder, timeout=300)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)  # 4: energy of more than 5 % of the work created
        stiffness = re.search(r"volume deck: normal stiffness raised from \S+ to (\S+) N/m per m", done.stdout)
        self.assertIsNotNone(stiffness, done.stdout)
        self.assertLessEqual(float(stiffness[1]), 1.01 * EA / DIAMETER**2)  # printed with three digits


if __name__ == "__main__":
    unittest.main()
