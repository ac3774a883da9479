"""Lines in and over tubes as exact shapes, on one rank and two: the tension of a wire in a J-tube at rest
without friction and in motion, ropes pulled through a bend and over its outside with friction, and a rope
that slides into the sag of a bent tube."""
import os
import tempfile
import unittest
from math import acos, atan2, cos, exp, hypot, pi, sin, sqrt
from pathlib import Path

import h5py
from support import ROOT, run, write
from test_tubes import J_TUBE

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
MPI = ("mpirun", "--oversubscribe", "--allow-run-as-root", "-n", "2")
TENSION = 12 * 98.0665 + 21.225 * (98.0665 - 1025 * 9.80665 * 0.25 * pi * 0.05**2)  # N, see test_j_tube
TUBE = "{shape: {tube: {path: [[0, 0, 8], [0, 0, -21], [46, 0, -21]], bend_radius: 6, inner_radius: 0.25, wall_thickness: 0.03}}"


def points(places):
    return "[" + ", ".join("[" + ", ".join(f"{x:.6f}" for x in p) + "]" for p in places) + "]"


class ExactTubes(unittest.TestCase):
    def results(self, case, command=()):
        """Output, and (times, steps, tensions by history) of a run."""
        with tempfile.TemporaryDirectory() as folder:
            write(Path(folder), "case.yaml", case)
            done = run(*command, HAWSER, "run", "case.yaml", cwd=folder)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            with h5py.File(Path(folder) / "case.h5") as file:
                series = file["series"]
                columns = lambda d: [c.decode() for c in d.attrs["columns"]]
                tensions = {name: d[:, columns(d).index("effective_tension")] for name, d in series.items()
                            if "columns" in d.attrs and "effective_tension" in columns(d)}
                steps = series["solver"][:, columns(series["solver"]).index("step")] if "solver" in series else []
                return done.stdout, series["time"][:], steps, tensions

    def test_j_tube(self):
        """Without friction the tension decreases with height, dT = w dz, from 12 m above the sea to zero at
        the clump in the level part, whose axis is 25 mm above the floor of the bore. In dynamics the tension
        remains constant, and the steps are long."""
        case = J_TUBE.replace("{mesh: tube.obj", TUBE).replace("statics: {contact_friction: true}\n", "")
        self.assertNotIn("statics", case)
        case += "output: {every: 0.1, histories: [{line: wire, at: end_a, name: top}]}\n"
        for command in ((), MPI):
            out, _, steps, tensions = self.results(case, command)
            self.assertIn("without friction of contact", out)
            for tension in tensions["top"]:
                self.assertAlmostEqual(tension / TENSION, 1, delta=1e-3)
            self.assertLess(len(steps), 100)
            self.assertGreaterEqual(min(steps[1:-1]), 2e-3)

    def test_on_a_body(self):
        """The tension is the same for the tube in the frame of a body that is rotated by 180 degrees."""
        turned = TUBE.replace("[[0, 0, 8], [0, 0, -21], [46, 0, -21]]", "[[46, 0, 29], [46, 0, 0], [0, 0, 0]]")
        case = J_TUBE.replace("{mesh: tube.obj", turned + ", body: tower").replace("statics: {contact_friction: true}\ndynamics: {duration: 1}\n", "")
        self.assertNotIn("dynamics", case)
        case += "bodies: {tower: {position: [46, 0, -21], rotation_deg: [0, 0, 180]}}\noutput: {histories: [{line: wire, at: end_a, name: top}]}\n"
        _, _, _, tensions = self.results(case)
        self.assertAlmostEqual(tensions["top"][0] / TENSION, 1, delta=1e-3)

    def pulled(self, inside, command=()):
        """Ratio of pull to load of a rope that is pulled through a bend of 90 degrees or over its outside,
        mean of the second half of the run."""
        bend, bore, wall, line, legs, load, friction = 6, 0.25, 0.03, 0.05, 3, 10e3, 0.2
        r = bend - (bore - line / 2) if inside else bend + bore + wall + line / 2
        places = [(bend - r, 0, -legs - 1.5)]
        places += [(bend - r * cos(0.5 * pi * i / 60), 0, r * sin(0.5 * pi * i / 60)) for i in range(61)]
        places += [(bend + legs + 1, 0, r)]
        length = 2.5 + 2 * legs + 0.5 * pi * r
        path = points([(0, 0, -legs), (0, 0, bend), (bend + legs, 0, bend)])
        # On the outside only friction keeps the rope from slipping off to the side.
        statics = "" if inside else "statics: {contact_friction: true}\n"
        case = f"""hawser: 1
environment: {{gravity: 0}}
line_types:
  rope: {{outer_diameter: {line}, mass_per_length: 10, EA: 100 MN, bending: false, stiffness_damping: 0.01}}
bodies:
  winch: {{position: [{bend + legs + 1}, 0, {r}], motion: {{velocity: [0.05, 0, 0], ramp: 2}}}}
volumes:
  tube: {{shape: {{tube: {{path: {path}, bend_radius: {bend}, inner_radius: {bore}, wall_thickness: {wall}}}}}, friction: {friction}, relative_damping: 0.1}}
lines:
  rope:
    sections: [{{type: rope, length: {length / (1 + load * 1.15 / 1e8)}, element_length: 0.25}}]
    end_a: free
    end_b: {{body: winch, at: [0, 0, 0]}}
    loads: [{{at: end_a, force: [0, 0, {-load}]}}]
    start: {{points: {points(places)}}}
contact: {{between_lines: false}}
{statics}dynamics: {{duration: 12}}
output: {{every: 1, histories: [{{line: rope, at: end_a, name: load}}, {{line: rope, at: end_b, name: pull}}]}}
"""
        _, time, steps, tensions = self.results(case, command)
        self.assertLess(len(steps), 300)
        late = time > 6
        self.assertAlmostEqual(tensions["load"][late].mean() / load, 1, delta=1e-4)
        pull = tensions["pull"][late] / load
        exact = exp(friction * 0.5 * pi)
        self.assertAlmostEqual(pull.mean() / exact, 1, delta=1e-3)
        self.assertLess(pull.std() / exact, 1e-3)

    def test_pulled_through(self):
        self.pulled(True)

    def test_pulled_over_the_outside(self):
        self.pulled(False)

    def test_ranks(self):
        self.pulled(True, MPI)

    def test_sag(self):
        """A rope across a bent tube that sags: without friction it slides 0.4 m down to the lowest place,
        where it lies on a circle. Both legs have the tension T = EA (l - l0)/l0."""
        bend, outer, line, EA, across, below, tension = 4, 0.3, 0.04, 1e6, 3.0, 2.0, 5e3
        r, middle = outer + line / 2, bend * (sqrt(2) - 1)  # radius of the rope about the axis of the tube; lowest place of this axis
        away = hypot(across, below)
        turn = pi - atan2(across, below) - acos(r / away)  # angle from the top to the point where a leg leaves the circle
        length = 2 * (sqrt(away**2 - r**2) + r * turn)
        aside = 0.4
        up = bend * sqrt(2) - sqrt(bend**2 - aside**2)
        places = [(0, -across, middle - below)]
        places += [(aside, 1.001 * r * sin(turn * i / 10), up + 1.001 * r * cos(turn * i / 10)) for i in range(-10, 11)]
        places += [(0, across, middle - below)]
        out, _, _, tensions = self.results(f"""hawser: 1
environment: {{gravity: 0}}
line_types: {{rope: {{outer_diameter: {line}, mass_per_length: 1, EA: {EA}, bending: false}}}}
volumes:
  bend: {{shape: {{tube: {{path: [[-6, 0, 6], [0, 0, 0], [6, 0, 6]], bend_radius: {bend}, inner_radius: 0.25, wall_thickness: {outer - 0.25}}}}}}}
lines:
  rope:
    sections: [{{type: rope, length: {length / (1 + tension / EA)}, element_length: 0.02}}]
    end_a: {{anchor: [0, {-across}, {middle - below}]}}
    end_b: {{anchor: [0, {across}, {middle - below}]}}
    start: {{points: {points(places)}}}
output: {{histories: [{{line: rope, at: end_a, name: a}}, {{line: rope, at: end_b, name: b}}]}}
""")
        for name in ("a", "b"):
            self.assertAlmostEqual(tensions[name][0] / tension, 1, delta=5e-3, msg=out)


if __name__ == "__main__":
    unittest.main()
