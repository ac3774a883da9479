"""Warning of a pipe whose reactions on rollers change by the penetration of contact."""
import os
import re
import tempfile
import unittest
from pathlib import Path

from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
SPAN = 6  # m
# A steel pipe on five level rollers, 0.1 m longer than the spans at both ends.
CASE = """\
hawser: 1
line_types:
  p: {{pipe: {{outer_diameter: 0.2731, wall_thickness: 0.0127}}}}
volumes:
{rollers}lines:
  p:
    sections: [{{type: p, length: 24.2, element_length: 0.75}}]
    end_a: free
    end_b: free
    start: {{points: [[-0.1, 0, 0], [24.1, 0, 0]]}}
statics: {{contact_friction: true}}
{dynamics}"""
ROLLER = "  r{k}: {{shape: {{cylinder: {{from: [{x}, -1, -0.33655], to: [{x}, 1, -0.33655], radius: 0.2}}}}, friction: 0.1{more}}}\n"
# Reactions of a continuous beam on five supports over w L (Roark, Formulas for Stress and Strain); at the ends with
# 0.1 m of pipe beyond the roller, whose moment changes them by less than 0.1 %.
REACTIONS = (0.3929 + 0.1 / SPAN, 1.1429, 0.9286, 1.1429, 0.3929 + 0.1 / SPAN)


class SupportSettlement(unittest.TestCase):
    def outcome(self, more="", dynamics="", launch=()):
        """(warnings, reaction of each roller [N])"""
        with tempfile.TemporaryDirectory() as folder:
            rollers = "".join(ROLLER.format(k=k, x=SPAN * k, more=more) for k in range(5))
            write(Path(folder), "pipe.yaml", CASE.format(rollers=rollers, dynamics=dynamics))
            done = run(*launch, HAWSER, "run", "pipe.yaml", "-o", "pipe.h5", cwd=folder)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            text = done.stdout + done.stderr
            rows = dict(re.findall(r"^p / r(\d) +\S+ +ongoing +\S+ +(\S+)", text, re.M))
            return re.findall(r"^warning: .*settles.*$", text, re.M), [float(rows[str(k)]) for k in range(5)]

    def test_an_automatic_stiffness_is_too_soft(self):
        warnings, reactions = self.outcome()
        self.assertEqual(len(warnings), 1, warnings)
        found = re.search(r"volume r[13] at arc length (\S+) m .* reaction there by (\S+) % and the bending moment by (\S+) % of the "
                          r"largest; give volumes.r[13] and the volumes beside it 'normal_stiffness: {allowed_penetration: (\S+)}'",
                          warnings[0])
        self.assertIsNotNone(found, warnings)
        arc, reaction, moment, _ = map(float, found.groups())
        self.assertAlmostEqual(min(abs(arc - 6.1), abs(arc - 18.1)), 0, delta=0.01)
        total = sum(reactions)
        self.assertAlmostEqual(reaction, 100 * abs(reactions[1] / total - 1.1429 * SPAN / 24.2) / (reactions[1] / total), delta=0.3)
        # The moment at the second roller is 0.1071 w L²; the ends, which settle by 0.3 mm more, add L times the change of
        # their reactions.
        change = SPAN * (REACTIONS[0] * SPAN / 24.2 * total - reactions[0])
        self.assertAlmostEqual(moment, 100 * change / (0.1071 * total / 24.2 * SPAN**2 + change), delta=0.7)

    def test_the_recommended_penetration_is_small_enough(self):
        for penetration in ("1e-5", "3e-5"):
            warnings, reactions = self.outcome(", normal_stiffness: {allowed_penetration: %s}" % penetration)
            self.assertEqual(warnings, [])
            for found, exact in zip(reactions, REACTIONS):
                self.assertAlmostEqual(found / sum(reactions), exact * SPAN / 24.2, delta=0.005 * exact * SPAN / 24.2)

    def test_it_is_printed_once_on_any_number_of_ranks(self):
        for launch in ((), ("mpirun", "-n", 2)):
            warnings, _ = self.outcome(dynamics="dynamics: {duration: 0.02, step: 0.01}\n", launch=launch)
            self.assertEqual(len(warnings), 1, warnings)

    def test_a_given_stiffness_is_that_of_the_support(self):
        self.assertEqual(self.outcome(", normal_stiffness: {per_length: 1.0e8}")[0], [])


if __name__ == "__main__":
    unittest.main()
