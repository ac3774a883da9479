"""A hose over a smooth arch: the part in the water pulls all slack out of the part on the bed, so that no equilibrium near the start
exists without friction. Statics then brings it to rest with the friction of the arch; on one rank and two. A wire on rocks whose facets
it does not come to rest on."""
import os
import re
import tempfile
import unittest
from pathlib import Path

from random_scenes import scene
from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
ARCH = """\
hawser: 1
environment: {water: {depth: 200}, seabed: {depth: 200}}
line_types: {hose: {outer_diameter: 0.3, mass_per_length: 120, EA: 400 MN, bending: false}}
volumes: {arch: {shape: {cylinder: {from: [0, -2, -100], to: [0, 2, -100], radius: 4}}, friction: 0.3}}
lines:
  hose:
    sections: [{type: hose, length: 370, element_length: 5}]
    end_a: {anchor: [120, 0, -2]}
    end_b: {anchor: [-90, 0, -200]}
    start: {points: [[120, 0, -2], [45, 0, -120], [8, 0, -100], [0, 0, -95.8], [-8, 0, -100], [-20, 0, -190], [-90, 0, -199.85]]}
"""


class SmoothArch(unittest.TestCase):
    def test_rest_by_friction(self):
        """The equilibrium is that of 'contact_friction: true', whose path begins at the same start."""
        most = lambda result: float(re.search(r"max effective tension +hose +(\S+) N", result.stdout)[1])
        note = "note: statics found no equilibrium without friction of contact"
        few = "max_iterations: 20, relaxation_steps: 400"
        with tempfile.TemporaryDirectory() as folder:
            write(Path(folder), "held.yaml", ARCH + "statics: {contact_friction: true}\n")
            held = run(HAWSER, "run", "held.yaml", cwd=folder)
            self.assertEqual(held.returncode, 0, held.stdout + held.stderr)
            self.assertNotIn(note, held.stdout)
            write(Path(folder), "arch.yaml", ARCH + f"statics: {{{few}}}\n")
            for launch in ((), ("mpirun", "-n", 2)):
                rests = run(*launch, HAWSER, "run", "arch.yaml", "-o", "arch.h5", cwd=folder)
                self.assertEqual(rests.returncode, 0, rests.stdout + rests.stderr)
                self.assertIn(note, rests.stdout)
                self.assertAlmostEqual(most(rests), most(held), delta=1e-5 * most(held))
            write(Path(folder), "smooth.yaml", ARCH + f"statics: {{{few}, contact_friction: false}}\n")
            smooth = run(HAWSER, "run", "smooth.yaml", cwd=folder)
            self.assertEqual(smooth.returncode, 3, smooth.stdout + smooth.stderr)
            self.assertIn("note: statics has failed; what may help: where a line slides along a volume or finds no rest on its facets, "
                          "its friction, without 'contact_friction: false'; ", smooth.stdout)

    def test_stagnating_descent(self):
        """A wire on the facets of a tube: Newton's method ends when it hardly moves the line, and its message says so. Without relaxation
        to follow it continues. A wire on rocks, where it continues after a raise of the contact stiffness, comes to rest by friction."""
        settings = lambda **keys: [a for key, value in keys.items() for a in ("--set", f"statics.{key}={value}")]
        with tempfile.TemporaryDirectory() as folder:
            for seed in (353, 153):
                for name, text in scene(seed).files.items():
                    write(Path(folder), name, text)
                write(Path(folder), f"{seed}.yaml", scene(seed).text())
            for n in (1, 2) if os.environ.get("HAWSER_FULL") else (2,):
                r = run("mpirun", "-n", n, HAWSER, "run", "353.yaml", "-q", "-o", "case.h5", *settings(contact_friction="false", relaxation_steps=3),
                        cwd=folder, timeout=300)
                self.assertEqual(r.returncode, 3, r.stderr)
                self.assertIn("hawser: statics: Newton's method hardly moves the lines and does not reduce the residual: line line",
                              r.stdout + r.stderr)
            r = run(HAWSER, "run", "353.yaml", "-q", "-o", "case.h5", *settings(dynamic_relaxation="never", max_iterations=250), cwd=folder,
                    timeout=300)
            self.assertIn("Newton's method does not converge within 250 iterations", r.stdout + r.stderr)
            r = run(HAWSER, "run", "153.yaml", "-o", "case.h5", "--set", "dynamics=null", cwd=folder, timeout=300)
            self.assertEqual(r.returncode, 0, r.stdout + r.stderr)
            self.assertIn("note: statics found no equilibrium without friction of contact", r.stdout)


if __name__ == "__main__":
    unittest.main()
