"""hawser modes against an eigenproblem assembled here from the equilibrium alone."""
import os
import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
from scipy.linalg import eigh

from support import ROOT, run, write

sys.path.insert(0, str(ROOT / "scripts"))
from hawser_post.results import Results  # noqa: E402

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
# Chains of the UMaine VolturnUS-S (Allen et al. 2020, NREL/TP-5000-76773): 850 m of studless chain, 685 kg/m,
# EA 3270 MN, volume-equivalent diameter 0.333 m, fairleads at 58 m and anchors at 837.6 m, 200 m of water.
EA, MASS, DIAMETER, DENSITY, BED, SMOOTHING = 3.27e9, 685.0, 0.333, 1025.0, 30e3, 0.02
CHAIN = """\
hawser: 1
environment:
  water: {depth: 200, density: 1025}
  seabed: {depth: 200, normal_stiffness: {per_length: 30 kN/m2}, smoothing: 20 mm, friction: 0}
line_types:
  chain: {outer_diameter: 0.333, mass_per_length: 685, EA: 3.27e9, bending: false, Ca_normal: 0.82, Ca_axial: 0.27}
bodies:
  platform: {}
lines:
LINES
contact: {between_lines: false}
"""
STRING = """\
hawser: 1
environment: {water: {depth: 500, density: 1000}, gravity: 0}
line_types:
  wire: {outer_diameter: 0.1, mass_per_length: 20, EA: 1e9, bending: false, Ca_normal: 1.5}
lines:
  wire:
    sections: [{type: wire, length: 100, elements: 50}]
    end_a: {anchor: [0, 0, -200]}
    end_b: {anchor: [100.1, 0, -200]}
"""


def chains(count):
    lines = []
    for i in range(count):
        way = np.array([np.cos(2 * np.pi * i / 3), np.sin(2 * np.pi * i / 3)])
        anchor, fairlead = 837.6 * way, 58 * way
        lines.append(f"  line{i}:\n    sections: [{{type: chain, length: 850, elements: 170}}]\n"
                     f"    end_a: {{anchor: [{anchor[0]:.10g}, {anchor[1]:.10g}, -200]}}\n"
                     f"    end_b: {{body: platform, at: [{fairlead[0]:.10g}, {fairlead[1]:.10g}, -14]}}")
    return CHAIN.replace("LINES", "\n".join(lines))


def frequencies_of(results, line):
    """Frequencies [Hz] of a cable with consistent mass and added mass, from its node positions and element strains."""
    x = results.field("position", line, 0)
    n = len(x)
    K, M = np.zeros((3 * n, 3 * n)), np.zeros((3 * n, 3 * n))
    area = np.pi / 4 * DIAMETER**2
    for e in range(n - 1):
        rest = line.arc[e + 1] - line.arc[e]
        d = x[e + 1] - x[e]
        length = np.linalg.norm(d)
        t = np.outer(d, d) / length**2
        tension = EA * (length / rest - 1)
        k = EA / rest * t + tension / length * (np.eye(3) - t)
        m = rest * (MASS * np.eye(3) + DENSITY * area * (0.82 * (np.eye(3) - t) + 0.27 * t))
        i, j = slice(3 * e, 3 * e + 3), slice(3 * e + 3, 3 * e + 6)
        for a, b, share in ((i, i, 1), (j, j, 1), (i, j, -1), (j, i, -1)):
            K[a, b] += share * k
            M[a, b] += m / (3 if share > 0 else 6)
    # The bed: springs under the nodes and mid-elements, with the weights of Simpson's rule, which start over
    # twice
    # the smoothing.
    z = x[:, 2]

    def spring(height):
        return BED * np.clip((SMOOTHING - (height + 200 - DIAMETER / 2)) / (2 * SMOOTHING), 0, 1)

    for e in range(n - 1):
        rest = line.arc[e + 1] - line.arc[e]
        i, j = 3 * e + 2, 3 * e + 5
        K[i, i] += rest / 6 * spring(z[e])
        K[j, j] += rest / 6 * spring(z[e + 1])
        K[np.ix_([i, j], [i, j])] += rest * 2 / 3 * spring((z[e] + z[e + 1]) / 2) / 4
    free = slice(3, 3 * n - 3)
    return np.sqrt(np.abs(eigh(K[free, free], M[free, free], eigvals_only=True, subset_by_index=(0, 11)))) / (2 * np.pi)


# A buoy on three chains: one mode is its own, with the chain ends.
BUOY = """\
hawser: 1
environment: {water: {depth: 100}, seabed: {depth: 100}}
line_types: {c: {library: chain-studless, diameter: 60 mm, grade: R3}}
bodies:
  buoy:
    floating: {mass: 60000, inertia: [2.0e5, 2.0e5, 2.0e5], weight: true, in_water: {volume: 200, height: 6}}
lines:
  a: {sections: [{type: c, length: 260, elements: 26}], end_a: {anchor: [220, 0, -100]}, end_b: {body: buoy, at: [3, 0, -2]}}
  b: {sections: [{type: c, length: 260, elements: 26}], end_a: {anchor: [-110, 190, -100]}, end_b: {body: buoy, at: [-1.5, 2.6, -2]}}
  d: {sections: [{type: c, length: 260, elements: 26}], end_a: {anchor: [-110, -190, -100]}, end_b: {body: buoy, at: [-1.5, -2.6, -2]}}
contact: {between_lines: false}
"""


class Modes(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def modes(self, text, *arguments, ranks=1):
        """Frequencies [Hz] as printed, and the results file."""
        write(self.folder, "case.yaml", text)
        launch = [] if ranks == 1 else ["mpirun", "-n", str(ranks)]
        result = run(*launch, HAWSER, "modes", "case.yaml", *arguments, cwd=self.folder, timeout=600)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        printed = [float(v) for v in re.findall(r"^ *\d+ +[\d.e+-]+ +([\d.e+-]+) ", result.stdout, re.M)]
        return np.array(printed), Results(self.folder / "case-modes.h5")

    def test_names_the_bodies_that_move(self):
        write(self.folder, "buoy.yaml", BUOY)
        output = run(HAWSER, "modes", self.folder / "buoy.yaml", "-n", "12").stdout
        rows = [line for line in output.splitlines() if re.match(r"\s+\d+\s", line)]
        self.assertEqual(len(rows), 12, output)
        # Surge and sway of the chains move the buoy; their high modes do not.
        self.assertTrue(any("body buoy" in row for row in rows[:2]), output)
        self.assertTrue(any("body buoy" not in row for row in rows), output)

    def test_names_the_freedoms_of_bodies(self):
        # Springs of increasing stiffness: sway, heave, surge, yaw, roll, pitch. The body is rotated by 90
        # degrees, so that it surges along y.
        write(self.folder, "body.yaml", """\
hawser: 1
environment: {gravity: 0}
bodies:
  block:
    position: [0, 0, 0]
    rotation_deg: [0, 0, 90]
    floating: {mass: 1000, inertia: [1000, 1000, 1000], stiffness: [1e3, 9e3, 4e3], turning_stiffness: [2.5e4, 3.6e4, 1.6e4]}
""")
        for ranks in (1, 2):
            launch = [] if ranks == 1 else ["mpirun", "-n", str(ranks)]
            output = run(*launch, HAWSER, "modes", self.folder / "body.yaml", "-n", "6").stdout
            found = re.findall(r"body block: ([a-z]+)", output)
            self.assertEqual(found, ["sway", "heave", "surge", "yaw", "roll", "pitch"], output)
            self.assertEqual(output.count(", rotation without displacement"), 3, output)

    def test_freedoms_are_those_of_the_centre_of_mass(self):
        # A spring along x at the origin, 5 m above the centre of mass, couples surge (omega² near 2) and pitch (near 35) weakly:
        # by M = diag(1000, 2000), K = [[2200, 6000], [6000, 70000]] the other freedom has at most 2 % of the energy of a mode.
        write(self.folder, "body.yaml", """\
hawser: 1
environment: {gravity: 0}
bodies:
  block:
    floating: {mass: 1000, centre_of_mass: [0, 0, -5], inertia: [2000, 2000, 2000], stiffness: [1e3, 1e6, 1e6],
               turning_stiffness: [1e6, 4e4, 1e6]}
links:
  spring: {end_a: {body: block, at: [0, 0, 0]}, end_b: {anchor: [10, 0, 0]}, stiffness: 1200, rest_length: 10}
""")
        output = run(HAWSER, "modes", self.folder / "body.yaml", "-n", "2").stdout
        self.assertEqual(re.findall(r"body block: ([a-z, ]+)", output), ["surge", "pitch"], output)

    def test_a_body_that_turns_about_its_centre_of_mass_is_named_by_its_rotations(self):
        write(self.folder, "body.yaml", """\
hawser: 1
environment: {gravity: 0}
bodies:
  block:
    position: [0, 0, 0]
    floating: {mass: 1000, centre_of_mass: [0, 0, -5], inertia: [1000, 2000, 3000], stiffness: [1e9, 1e9, 1e9],
               turning_stiffness: [3e5, 4e5, 1e5]}
""")
        output = run(HAWSER, "modes", self.folder / "body.yaml", "-n", "6").stdout
        turns = [line for line in output.splitlines() if ", rotation without displacement" in line]
        self.assertEqual(len(turns), 3, output)
        for row in turns:
            self.assertRegex(row, "body block: (roll|pitch|yaw), rotation without displacement")

    def test_volturnus(self):
        one, _ = self.modes(chains(1), "-n", "12")
        run(HAWSER, "run", "case.yaml", cwd=self.folder, timeout=600)
        statics = Results(self.folder / "case.h5")
        line = statics.line("line0")
        # Table of the reference case: 2435.56 kN at the fairlead.
        self.assertAlmostEqual(statics.field("effective_tension", line, 0)[-1] / 2435.56e3, 1, delta=2e-3)
        own = frequencies_of(statics, line)
        np.testing.assert_allclose(one[:8], own[:8], rtol=1e-3)
        # Three chains on a fixed platform: each mode three times.
        three, results = self.modes(chains(3), "-n", "12", ranks=2)
        np.testing.assert_allclose(three, np.repeat(one[:4], 3), rtol=1e-3)
        self.assertEqual(len(results.lines), 3)

    def test_added_mass(self):
        # sqrt(T/m)/(2 L), n times; the added mass is 1.5 times the displaced mass.
        T, displaced = 1e9 * 1e-3, 1000 * np.pi / 4 * 0.01
        for arguments, mass in (([], 20 + 1.5 * displaced), (["--without-added-mass"], 20)):
            found, results = self.modes(STRING, "-n", "6", *arguments)
            exact = np.repeat([1, 2, 3], 2) * np.sqrt(T / mass) / (2 * 100.1)
            # Elements of a fiftieth of the length: (n pi/50)²/24 for the third mode; stretched, 0.05 %.
            np.testing.assert_allclose(found, exact, rtol=2.5e-3)
            shape = np.linalg.norm(results.field("mode_shape", results.line("wire")), axis=2)
            np.testing.assert_allclose(shape.max(axis=1), [0] + 6 * [1], atol=1e-9)
            np.testing.assert_allclose(shape[1], np.sin(np.pi * np.linspace(0, 1, 51)), atol=1e-3)
            modes = results.series("modes")
            np.testing.assert_allclose(modes.column("frequency"), found, rtol=1e-4)

    def test_bodies_move(self):
        """A load on slings: pictures show it displaced by the mode, on any number of ranks; bodies rotate by at most
        0.3 rad."""
        case, poses = str(ROOT / "cases/lifted-load/lifted-load.yaml"), []
        for ranks in (1, 2):
            result = run(*(["mpirun", "-n", "2"] if ranks == 2 else []), HAWSER, "modes", case, "-n", "6", "-o", "modes.h5", cwd=self.folder)
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
            results = Results(self.folder / "modes.h5")
            poses.append(np.concatenate([results.file["bodies/position"][:], results.file["bodies/rotation"][:]], axis=2))
        # One of the two free modes rotates the hook; 3 and 4 are the pendulum along x and y, 5 % of the
        # longest line, 20 m.
        hook, module = poses[0][:, 1], poses[0][:, 2]
        self.assertAlmostEqual(2 * np.arccos(hook[1:3, 3].min()), 0.3, delta=1e-6)
        np.testing.assert_allclose(np.abs(module[3:5, :3] - module[0, :3]).max(axis=1), 0.05 * 20, rtol=0.05)
        self.assertLess(np.abs(poses[0][3:5] - poses[1][3:5]).max(), 1e-6)
        rest, third = (x.mean(axis=0) for mode in (0, 3) for name, x, _ in results.volumes(mode) if name == "module_walls")
        np.testing.assert_allclose(third - rest, poses[1][3, 2, :3] - poses[1][0, 2, :3], atol=0.05)

    def test_refusals(self):
        write(self.folder, "case.yaml", STRING + "statics: false\ndynamics: {duration: 1}\n")
        result = run(HAWSER, "modes", "case.yaml", cwd=self.folder)
        self.assertEqual(result.returncode, 2)
        self.assertIn("modes need the static equilibrium", result.stderr)
        self.assertEqual(run(HAWSER, "modes", "case.yaml", "-n", "0", cwd=self.folder).returncode, 2)


if __name__ == "__main__":
    unittest.main()
