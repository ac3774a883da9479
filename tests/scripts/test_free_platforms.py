"""Energy, forces and momentum of floating bodies: the work of thrusters is continuous over an unrelated
event; the recorded components account for the whole force and are zero for absent effects; momenta of bodies
and a rope are conserved when the rope is cut, released or attached."""
import os
import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
from support import ROOT, run, write
from test_rigid_bodies import rotation

sys.path.insert(0, str(ROOT / "scripts"))
from hawser_post.results import Results  # noqa: E402

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
# A body held by thrusters moves, and an unrelated rope is released.
POSITIONED = """\
hawser: 1
line_types:
  rope: {outer_diameter: 0.1, mass_per_length: 1, EA: 1 MN, bending: false}
bodies:
  ship:
    position: [0, 0, 0]
    floating:
      mass: 1e6
      inertia: [1e8, 3e8, 4e8]
      stiffness: [0, 0, 1e6]
      turning_stiffness: [1e8, 1e8, 0]
      velocity: [1, 0, 0]
      positioning: {proportional: [2e4, 2e4, 1e6], derivative: [2e5, 2e5, 1e8], integral: [100, 100, 1e4], filter_period: 20}
lines:
  rope: {sections: [{type: rope, length: 20, elements: 4}], end_a: {anchor: [100, 0, 0]}, end_b: {anchor: [119, 0, 0]}}
events:
  - {release: {line: rope, end: end_b}, time: 12}
contact: {between_lines: false}
dynamics: {duration: 20, step: 0.2, rho_infinity: 1}
output: {every: 20, file: run.h5}
"""
SPHERE = """\
hawser: 1
environment: {gravity: 9.81, water: {density: 1000}}
bodies:
  sphere:
    position: [0, 0, 1]
    floating: {mass: 261800, inertia: [2.6e6, 2.6e6, 2.6e6], hydrodynamics: {wamit: STEM, length_scale: 5}}
statics: false
dynamics: {duration: 3, step: 0.2, rho_infinity: 1}
output: {every: 1, file: run.h5, histories: [{body: sphere}]}
"""
SPAR = """\
hawser: 1
environment:
  water: {density: 1025, depth: 200}
  waves: {components: [{height: 3, period: 10, phase_deg: 40}], ramp: 0}
bodies:
  sphere:
    position: [3, 0, 0.5]
    floating:
      mass: 28981 t
      centre_of_mass: [0, 0, -54]
      inertia: [4.5e10, 4.5e10, 1.5e9]
      velocity: [0.5, 0, 0.1]
      hydrodynamics: {wamit: STEM, displaced_volume: 28274, place: [0, 0, 0], quadratic_damping: [1e6, 1e6, 3e5, 1.5e11, 1.5e11, 0]}
      positioning: {place: [0, 0, 0], proportional: [2e5, 2e5, 1e8], derivative: [4e6, 4e6, 1e9]}
statics: false
dynamics: {duration: 2, step: 0.1, rho_infinity: 1}
output: {every: 1, file: run.h5, histories: [{body: sphere}]}
"""
HULL = """\
hawser: 1
environment:
  water: {density: 1025, depth: 100}
  current: {speed: 0.5, direction_deg: 0}
  waves: {regular: {height: 1, period: 6}, ramp: 0}
bodies:
  sphere:
    position: [0, 0, 0.3]
    floating:
      mass: 60 t
      centre_of_mass: [0, 0, -6]
      inertia: [1e6, 1e6, 1e5]
      hull: {volumes: [spar]}
      members: [{from: [0, 0, -9.8], to: [0, 0, 0], diameter: 2.8, Cd: 0.8, Ca: 1, axial_Cd: 1, axial_Ca: 1}]
volumes:
  spar: {shape: {cylinder: {from: [0, 0, -10], to: [0, 0, 3], radius: 1.4}}, body: sphere}
statics: false
dynamics: {duration: 1, step: 0.05, rho_infinity: 1}
output: {every: 1, file: run.h5, histories: [{body: sphere}]}
"""
# Two crates in space that meet with friction; the fender of one penetrates the side of the other from the
# start.
FENDERED = """\
hawser: 1
environment: {gravity: 0}
bodies:
  sphere: {position: [0, 0, 0], floating: {mass: 2e4, inertia: [3e4, 5e4, 6e4], velocity: [0.5, 0.1, 0], angular_velocity: [0, 0.1, 0.2]}}
  other: {position: [4.95, 0.3, 0], floating: {mass: 1e4, inertia: [2e4, 3e4, 3e4]}}
volumes:
  fender: {shape: {sphere: {centre: [2, 0, 0], radius: 1}}, body: sphere, normal_stiffness: {per_point: 1e6}, friction: 0.3, relative_damping: 0.1}
  side: {shape: {box: {centre: [0, 0, 0], size: [4, 4, 4]}}, body: other, friction: 0.3, normal_stiffness: {per_area: 1e7}}
statics: false
dynamics: {duration: 0.5, step: 0.005, rho_infinity: 1}
output: {every: 1, file: run.h5, histories: [{body: sphere}, {body: other}]}
"""
# Two rotating bodies in space that move apart, joined by a rope.
ROPED = """\
hawser: 1
environment: {gravity: 0}
line_types:
  rope: {outer_diameter: 0.1, mass_per_length: 20, EA: 4e5, bending: false, stiffness_damping: 0.1}
bodies:
  one:
    position: [0, 0, 0]
    floating: {mass: 2e4, inertia: [3e4, 5e4, 6e4], products_of_inertia: [2e3, -1e3, 3e3], centre_of_mass: [0.2, 0, 0.3],
               velocity: [-0.4, 0.05, 0.1], angular_velocity: [0.3, 0.2, -0.5]}
  two:
    position: [22, 1, 0]
    floating: {mass: 1e4, inertia: [4e4, 8e4, 1e5], velocity: [0.6, 0, 0], angular_velocity: [-0.3, -0.2, 0.1]}
lines:
  rope: {sections: [{type: rope, length: 18, elements: 6}], end_a: {body: one, at: [2, 1, 0]}, end_b: END}
events:
  - {EVENT, time: 0.53}
contact: {lines: [], between_lines: false}
statics: false
dynamics: {duration: 1, step: STEP, tolerance: 1e-11}
output: {every: STEP, file: run.h5, histories: [{body: one}, {body: two}]}
"""
BODIES = {"one": (2e4, np.array([[3e4, 2e3, 3e3], [2e3, 5e4, -1e3], [3e3, -1e3, 6e4]]), np.array([0.2, 0, 0.3])),
          "two": (1e4, np.diag([4e4, 8e4, 1e5]), np.zeros(3))}


class FreePlatforms(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_thrusters_over_an_event(self):
        write(self.folder, "case.yaml", POSITIONED)
        done = run(HAWSER, "run", self.folder / "case.yaml", "-o", self.folder / "run.h5")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        error = float(re.search(r"balance error (\S+) J", done.stdout)[1])
        brought_in = float(re.search(r"input (\S+) J", done.stdout)[1])
        self.assertLess(abs(error), 1e-3 * abs(brought_in), done.stdout)

    def history(self, text):
        write(self.folder, "case.yaml", text)
        done = run(HAWSER, "run", "-q", self.folder / "case.yaml", "-o", self.folder / "run.h5")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return Results(self.folder / "run.h5").series("sphere")

    def test_nothing_is_left_of_the_forces(self):
        """The remainder of the force components is zero, also in the first row: for a released sphere, and
        for a spar with thrusters in waves without a ramp."""
        history = self.history(SPHERE.replace("STEM", str(ROOT / "tests/data/hemisphere")))
        other, restoring = history.column("other_force_z"), history.column("hydrostatic_force_z")
        self.assertLess(abs(other).max(), 1e-6 * abs(restoring).max())
        self.assertGreater(abs(history.column("radiation_force_z")[0]), 0.1 * abs(restoring[0]))
        history = self.history(SPAR.replace("STEM", str(ROOT / "docs/tutorial/spar")))
        for direction in ("force_x", "force_z", "moment_y"):
            parts = {component: abs(history.column(f"{component}_{direction}")) for component in ("hydrostatic", "radiation", "added", "wave", "thrusters")}
            left = abs(history.column(f"other_{direction}"))
            # Later rows: waves act at the filtered position at the end of the step, not at the one predicted at its start.
            self.assertLess(left.max(), 1e-4 * max(part.max() for part in parts.values()), direction)
            self.assertLess(left[0], 1e-8 * max(part[0] for part in parts.values()), direction)
            self.assertGreater(parts["radiation"][0], 1e3 * left[0], direction)
            self.assertGreater(parts["wave"][0], 1e3 * left[0], direction)

    def test_nothing_is_left_of_the_forces_on_a_hull(self):
        """For a hull in waves and a current, hull pressure, and drag and added mass of members, account for
        the whole force."""
        history = self.history(HULL)
        for direction in ("force_x", "force_z", "moment_y"):
            parts = [history.column(f"{component}_{direction}") for component in ("buoyancy", "froude_krylov", "morison")]
            left = abs(history.column(f"other_{direction}"))
            self.assertLess(left.max(), 1e-5 * max(abs(part).max() for part in parts), direction)
            for part in parts[1:]:
                self.assertGreater(abs(part).max(), 1e3 * left.max(), direction)

    def test_contact_is_all_that_acts(self):
        """A crate on a fender, from the first row on, on one and two ranks: contact forces are equal and
        opposite, without a remainder."""
        for words in ([HAWSER], ["mpirun", "-n", "2", HAWSER]):
            write(self.folder, "case.yaml", FENDERED)
            done = run(*words, "run", "-q", self.folder / "case.yaml", "-o", self.folder / "run.h5")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            one, two = (Results(self.folder / "run.h5").series(name) for name in ("sphere", "other"))
            most = abs(one.column("contact_force_x")).max()
            self.assertLess(one.column("contact_force_x")[0], -4e4)  # 5 cm, 1 MN/m
            with h5py.File(self.folder / "run.h5") as file:  # outputs at 0 and 0.5 s, with and without contact
                ends = file["outputs/contact_points"][:]
                first = file["contact_points/force"][: ends[0]].sum(axis=0)
                self.assertEqual(ends[-1] - ends[0] > 0, abs(one.column("contact_force_x")[-1]) > 0)
            self.assertAlmostEqual(abs(first[0]) / abs(one.column("contact_force_x")[0]), 1, delta=1e-6)
            self.assertGreater(abs(one.column("contact_force_y")).max(), 0.1 * most)  # friction
            for axis in "xyz":
                self.assertLess(abs(one.column(f"contact_force_{axis}") + two.column(f"contact_force_{axis}")).max(), 1e-9 * most)
                for history in (one, two):
                    self.assertLess(abs(history.column(f"other_force_{axis}")).max(), 1e-6 * most)

    def test_periods_afloat(self):
        """Periods printed by hawser check equal those of hawser modes without lines in all digits; roll and
        pitch are coupled with sway and surge, by less than a fifth of the energy at the centre of mass."""
        case = SPAR.replace("STEM", str(ROOT / "docs/tutorial/spar")).replace("statics: false\n", "")
        for part in (r", *waves: [^\n]*", r"\n  waves: [^\n]*", r"\n      positioning: [^\n]*", r"\n      velocity: [^\n]*"):
            case = re.sub(part, "", case)
        write(self.folder, "case.yaml", case)
        reported = run(HAWSER, "check", self.folder / "case.yaml").stdout
        heave, roll, pitch = (float(v) for v in re.search(r"periods afloat without lines: heave (\S+) s, roll (\S+) s, pitch (\S+) s", reported).groups())
        modes = run(HAWSER, "modes", self.folder / "case.yaml", "-n", "6").stdout
        self.assertAlmostEqual(float(re.search(r"^ *\d+ +(\S+) .*: heave", modes, re.M)[1]) / heave, 1, delta=5e-4)
        tilts = [float(v) for v in re.findall(r"^ *\d+ +(\S+) .*: (?:roll|pitch)$", modes, re.M)]
        self.assertEqual(len(tilts), 2, modes)
        for tilt in tilts:
            self.assertAlmostEqual(tilt / roll, 1, delta=5e-4)
            self.assertAlmostEqual(tilt / pitch, 1, delta=5e-4)

    def test_periods_on_lines(self):
        """Periods of a spar on three chains printed by hawser check equal those of hawser modes, which has the mass of the chains as
        well: 1 %."""
        for name in ("spar.1", "spar.3", "spar.hst", "platform-1.yaml"):
            shutil.copy(ROOT / "docs/tutorial" / name, self.folder)
        reported = run(HAWSER, "check", self.folder / "platform-1.yaml").stdout
        found = re.search(r"^body spar on its lines, without their mass: periods (.*)", reported, re.M)
        self.assertTrue(found, reported)
        periods = {name: float(value) for name, value in re.findall(r"(\w+) (\S+) s", found[1])}
        self.assertEqual(set(periods), {"surge", "sway", "heave", "roll", "pitch", "yaw"})
        modes = run(HAWSER, "modes", self.folder / "platform-1.yaml", "-n", "10").stdout
        rows = re.findall(r"^ *\d+ +(\S+) .*body spar[^:]*: (?:surge, |sway, )?(\w+)$", modes, re.M)
        self.assertEqual({name for _, name in rows}, set(periods), modes)
        for period, name in rows:
            print(f"spar on its lines, {name}: {periods[name] / float(period) - 1:+.2%}")
            self.assertAlmostEqual(periods[name] / float(period), 1, delta=0.01)

    def test_periods_of_a_turned_platform(self):
        """The same of a spar turned by 40 deg with its chains, of different inertia in roll and pitch, held in surge by a strut: 1.1 %."""
        for name in ("spar.1", "spar.3", "spar.hst"):
            shutil.copy(ROOT / "docs/tutorial" / name, self.folder)
        case = (ROOT / "docs/tutorial/platform-1.yaml").read_text("utf-8")
        for text, other in (("inertia: [4.5e10, 4.5e10, 1.5e9]", "inertia: [4.5e10, 3e10, 1.5e9]"),
                            ("  spar:\n", "  spar:\n    rotation_deg: [0, 0, 40]\n"),
                            ("lines:\n", "links: {strut: {end_a: {anchor: [-459.63, -385.67, -20]}, end_b: {body: spar, at: [-10, 0, -20]}, "
                                         "stiffness: 2e6, rest_length: 590}}\nlines:\n"),
                            ("length: 640, elements: 64", "length: 638, elements: 64"),
                            ("anchor: [-600, 0, -200]", "anchor: [-459.63, -385.67, -200]"),
                            ("anchor: [300, 519.6, -200]", "anchor: [-104.18, 590.87, -200]"),
                            ("anchor: [300, -519.6, -200]", "anchor: [563.8, -205.2, -200]")):
            self.assertIn(text, case)
            case = case.replace(text, other, 1)
        write(self.folder, "case.yaml", case)
        reported = run(HAWSER, "check", self.folder / "case.yaml").stdout
        found = re.search(r"^body spar on its lines, without their mass: periods (.*)", reported, re.M)
        self.assertTrue(found, reported)
        periods = [float(value) for value in re.findall(r"([\d.]+) s\b", found[1])]
        self.assertEqual(len(periods), 6, reported)
        modes = run(HAWSER, "modes", self.folder / "case.yaml", "-n", "10").stdout
        exact = [float(value) for value in re.findall(r"^ *\d+ +(\S+) .*body spar", modes, re.M)]
        self.assertGreater(len(exact), 4, modes)
        for period in exact:
            self.assertLess(min(abs(p / period - 1) for p in periods), 0.011, f"{period} {periods}")

    def momenta(self):
        """Momentum, and angular momentum about the origin, of bodies and rope: one row for each output."""
        with h5py.File(self.folder / "run.h5") as file:
            rows = [int(np.argmin(abs(file["series/time"][:] - t))) for t in file["outputs/time"][:]]
            x, v = file["fields/position"][:], file["fields/velocity"][:]
            P, L = np.zeros((len(rows), 3)), np.zeros((len(rows), 3))
            for name, (mass, inertia, centre) in BODIES.items():
                data = file["series"][name]
                columns = {c.decode(): data[:, k][rows] for k, c in enumerate(data.attrs["columns"])}
                place, turn, velocity, rate = (np.array([columns[f"{what}_{axis}"] for axis in "xyz"]).T
                                               for what in ("position", "rotation_vector", "velocity", "angular_velocity"))
                for k in range(len(rows)):
                    R = rotation(turn[k])
                    p = mass * (velocity[k] + np.cross(rate[k], R @ centre))
                    P[k] += p
                    L[k] += np.cross(place[k] + R @ centre, p) + R @ inertia @ R.T @ rate[k]
            arc = file["nodes/arc_length"][:]
            for first, nodes in zip(file["lines/first_node"][:], file["lines/nodes"][:]):
                for i in range(first, first + nodes - 1):
                    # The mass matrix of a cable is the mean of a linear element's and one of masses at its ends.
                    mass = 20 * (arc[i + 1] - arc[i])
                    P += mass / 2 * (v[:, i] + v[:, i + 1])
                    L += 5 * mass / 12 * (np.cross(x[:, i], v[:, i]) + np.cross(x[:, i + 1], v[:, i + 1]))
                    L += mass / 12 * (np.cross(x[:, i], v[:, i + 1]) + np.cross(x[:, i + 1], v[:, i]))
        return P, L

    def test_momenta_over_an_event(self):
        """Momentum is conserved to rounding. The error of angular momentum over the event is within the bound
        and of second order in the step."""
        tied, free = "{body: two, at: [-2, 0, 1]}", "free"
        for event, end, bound in (("cut: {line: rope, at: 9}", tied, 5e-6), ("release: {line: rope, end: end_b}", tied, 5e-6),
                                  ("attach: {line: rope, end: end_b, body: two}", free, 2e-4)):  # attaching causes an impact
            off = []
            for step in (0.01, 0.005):
                write(self.folder, "case.yaml", ROPED.replace("EVENT", event).replace("END", end).replace("STEP", str(step)))
                done = run(HAWSER, "run", "-q", self.folder / "case.yaml", "-o", self.folder / "run.h5")
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                P, L = self.momenta()
                self.assertLess(np.abs(P - P[0]).max(), 1e-11 * np.linalg.norm(P[0]), event)
                off.append(np.abs(L - L[0]).max() / np.linalg.norm(L[0]))
            print(f"{event}: momentum kept to {np.abs(P - P[0]).max() / np.linalg.norm(P[0]):.1e}, angular momentum to {off[0]:.1e}, {off[1]:.1e}")
            self.assertLess(off[1], bound, event)
            self.assertLess(off[1], 0.35 * off[0], event)


if __name__ == "__main__":
    unittest.main()
