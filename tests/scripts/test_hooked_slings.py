"""Two slings that hang in each other: without friction they slide over each other's nodes, and statics finds no rest."""
import os
import re
import tempfile
import unittest
from pathlib import Path

from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
FRICTION = "contact: {between_lines: {friction: 0.15}}\n"


# A bight of the line `up`, held at both ends, and one of the line `lo`, which carries a load, in planes at right angles.
CASE = """\
hawser: 1
line_types:
  a: {outer_diameter: 0.16937815, mass_per_length: 25.820061, EA: 15778926.0, EI: 4938.3373, GJ: 4115.2811}
  b: {outer_diameter: 0.32336796, mass_per_length: 418.26736, EA: 4182673600.0, bending: false}
contact: {between_lines: {friction: 0.15}}
lines:
  up:
    sections:
    - {type: a, length: 11.554833, elements: 40}
    end_a:
      anchor: [-0.53887842, -0.57527157, 5.2549546]
    end_b:
      anchor: [0.53887842, 0.57527157, 5.2549546]
    start:
      points:
      - [-0.53887842, -0.57527157, 5.2549546]
      - [-0.21896118, -0.23374872, 3.9223596e-17]
      - [-0.21150026, -0.22578393, -0.08289585]
      - [-0.18962594, -0.20243233, -0.16014249]
      - [-0.15482894, -0.16528531, -0.22647568]
      - [-0.10948059, -0.11687436, -0.27737492]
      - [-0.056671324, -0.060498621, -0.30937153]
      - [-4.0222516e-17, -4.2938943e-17, -0.32028497]
      - [0.056671324, 0.060498621, -0.30937153]
      - [0.10948059, 0.11687436, -0.27737492]
      - [0.15482894, 0.16528531, -0.22647568]
      - [0.18962594, 0.20243233, -0.16014249]
      - [0.21150026, 0.22578393, -0.08289585]
      - [0.21896118, 0.23374872, -7.8447193e-17]
      - [0.53887842, 0.57527157, 5.2549546]
  lo:
    sections:
    - {type: b, length: 10.807356, elements: 49}
    end_a:
      body: load
      at: [0.38351438, -0.35925228, 0.0]
    end_b:
      body: load
      at: [-0.38351438, 0.35925228, 0.0]
    start:
      points:
      - [0.38351438, -0.35925228, -5.2549546]
      - [0.23374872, -0.21896118, -0.35724093]
      - [0.22578393, -0.21150026, -0.27434508]
      - [0.20243233, -0.18962594, -0.19709844]
      - [0.16528531, -0.15482894, -0.13076525]
      - [0.11687436, -0.10948059, -0.079866008]
      - [0.060498621, -0.056671324, -0.047869404]
      - [-1.4312981e-17, 1.3407505e-17, -0.036955958]
      - [-0.060498621, 0.056671324, -0.047869404]
      - [-0.11687436, 0.10948059, -0.079866008]
      - [-0.16528531, 0.15482894, -0.13076525]
      - [-0.20243233, 0.18962594, -0.19709844]
      - [-0.22578393, 0.21150026, -0.27434508]
      - [-0.23374872, 0.21896118, -0.35724093]
      - [-0.38351438, 0.35925228, -5.2549546]
bodies:
  load:
    position: [0.0, 0.0, -5.2549546]
    floating:
      mass: 321.80053
      inertia: [88.863763, 88.863763, 88.863763]
      weight: true
statics: STATICS
"""


class HookedSlings(unittest.TestCase):
    def run_case(self, statics, text=CASE, *options):
        with tempfile.TemporaryDirectory() as folder:
            write(Path(folder), "slings.yaml", text.replace("STATICS", statics))
            return run(HAWSER, "run", "slings.yaml", *options, cwd=folder, timeout=300)

    def test_friction_brings_them_to_rest(self):
        """The search without friction ends after 150 steps of relaxation."""
        done = self.run_case("true", CASE, "--", "-statics_snes_converged_reason")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("note: statics found no equilibrium without friction of contact", done.stdout)
        with_friction = int(re.search(r"^statics: \d+ iterations, (\d+) steps of dynamic relaxation$", done.stdout, re.M)[1])
        # Besides the steps, searches by Newton's method.
        self.assertLessEqual(done.stdout.count("Nonlinear statics_ solve"), 150 + with_friction + 100)

    def test_slow_relaxation_is_noted(self):
        done = self.run_case("{contact_friction: false, relaxation_steps: 900}")
        self.assertEqual(done.returncode, 3, done.stdout + done.stderr)
        # The bight of `up` is at 11.555 m / 2, that of `lo` at 10.807 m / 2.
        note = re.search(r"note: statics has not come to rest in 500 steps of dynamic relaxation; line (\S+) at arc length (\S+) m and line "
                         r"(\S+) at (\S+) m hold each other and slide without friction: 'statics: {contact_friction: true}' lets them come "
                         r"to rest\n", done.stdout)
        self.assertIsNotNone(note, done.stdout)
        arcs = {note[1]: float(note[2]), note[3]: float(note[4])}
        self.assertAlmostEqual(arcs["up"], 5.78, delta=0.5)
        self.assertAlmostEqual(arcs["lo"], 5.40, delta=0.5)

    def test_all_steps_are_bounded(self):
        """Steps of relaxation that are used up end the search without friction, whose failure names the remedy."""
        failed = self.run_case("{contact_friction: false, dynamic_relaxation: always, relaxation_steps: 200}", CASE, "--",
                               "-statics_snes_converged_reason")
        self.assertEqual(failed.returncode, 3, failed.stdout + failed.stderr)
        self.assertLessEqual(failed.stdout.count("Nonlinear statics_ solve"), 250)
        self.assertRegex(failed.stdout, r"note: statics has failed: line (up|lo) at .* hold each other and slide without friction; "
                                        r"'statics: {contact_friction: true}' lets them come to rest; see docs/how-to/failing-runs.md")
        without = self.run_case("{dynamic_relaxation: always, relaxation_steps: 200}", CASE.replace(FRICTION, ""))
        self.assertEqual(without.returncode, 3, without.stdout + without.stderr)
        self.assertIn("'friction' in 'contact: {between_lines: ...}' with 'statics: {contact_friction: true}' lets them", without.stdout)
        self.assertNotIn("between_lines: false", failed.stdout + without.stdout)


if __name__ == "__main__":
    unittest.main()
