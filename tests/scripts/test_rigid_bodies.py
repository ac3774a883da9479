"""Rigid bodies without water: a bifilar pendulum, a heavy top, a freely rotating body, points of a rotated body, a
crate that starts inside a deck, and a body on elastic cables at rest, swinging and thrown. References: quadratures, elliptic integrals and Runge-Kutta
solutions to 1e-12."""
import os
import re
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
GRAVITY = 9.80665
BAR = """\
  bar: {position: PLACE, rotation_deg: [0, 0, TURN], floating: {mass: 120, inertia: [15, 40, 50], weight: true}}
links:
  left: {end_a: {anchor: [-0.5, 0, 0]}, end_b: {body: bar, at: [-0.5, 0, 0.3]}, stiffness: 1e7, rest_length: 2}
  right: {end_a: {anchor: [0.5, 0, 0]}, end_b: {body: bar, at: [0.5, 0, 0.3]}, stiffness: 1e7, rest_length: 2}
"""
STRETCH = 120 * GRAVITY / 2 / 1e7
LOAD = """\
  load: {position: PLACE, rotation_deg: TURN, floating: {mass: 1500, inertia: [900, 1400, 1100], products_of_inertia: [30, 45, -60],
         weight: true MOTION}}
links:
  c0: {end_a: {anchor: [2.5, 0, 8]}, end_b: {body: load, at: [1, 0.1, 0.5]}, stiffness: 80000, rest_length: 5, tension_only: true}
  c1: {end_a: {anchor: [-1.5, 2, 8]}, end_b: {body: load, at: [-0.8, 0.9, 0.5]}, stiffness: 76923.0769230769, rest_length: 5.2, tension_only: true}
  c2: {end_a: {anchor: [-1.2, -2.2, 7.5]}, end_b: {body: load, at: [-0.7, -1, 0.4]}, stiffness: 65217.3913043478, rest_length: 4.6,
       tension_only: true}
"""
# Load on three cables at rest: position, rotation vector, tensions, angular frequencies.
REST = np.array([0.2981895, -0.189305, 2.561149])
TURNED = np.array([-0.06025498, -0.008185496, -0.02822125])
TENSIONS = (6558.542, 4023.814, 4694.573)
FREQUENCIES = (1.70601, 1.725096, 2.797192, 9.477497, 10.75963, 12.11362)


def rotation(vector):
    """The matrix of a rotation vector (Rodrigues)."""
    angle = np.linalg.norm(vector)
    if angle == 0:
        return np.eye(3)
    x, y, z = vector / angle
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def period(time, x):
    """Mean time between upward zero crossings."""
    up = np.flatnonzero((x[:-1] < 0) & (x[1:] >= 0))
    at = time[up] - x[up] * np.diff(time)[up] / (x[up + 1] - x[up])
    return (at[-1] - at[0]) / (len(at) - 1)


class RigidBodies(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def motion(self, text, duration=0.0, step=0.0, more=""):
        """Time, motion of the first body by column, and the file of a run, or of statics without a duration."""
        name = re.search(r"\w+", text).group(0)
        end = f"statics: false\ndynamics: {{duration: {duration}, step: {step}, rho_infinity: 1}}\n" if duration else ""
        write(self.folder, "case.yaml", f"hawser: 1\nenvironment: {{gravity: {GRAVITY}}}\nbodies:\n{text}{end}"
              f"output: {{every: 1000, histories: [{{body: {name}}}{more}]}}\n")
        done = run(HAWSER, "run", "case.yaml", "-q", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        file = h5py.File(self.folder / "case.h5")
        data = file["series"][name]
        return file["series/time"][:], {c.decode(): data[:, k] for k, c in enumerate(data.attrs["columns"])}, file

    def of(self, found, what):
        return np.array([found[f"{what}_{axis}"] for axis in "xyz"]).T

    def test_roll_pitch_yaw(self):
        """A ball with a trim of 5 deg and a list of -8 deg turns about the vertical from a heading of 170 or -170 deg
        through 180 deg: its yaw and the components of its rotation vector are continuous."""
        for heading, rate in ((170, 0.5), (-170, -0.5)):
            roll, pitch, yaw = np.radians([-8, 5, heading])
            turn = rotation([0, 0, yaw]) @ rotation([0, pitch, 0]) @ rotation([roll, 0, 0])
            angle = np.arccos((np.trace(turn) - 1) / 2)
            axis = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]) / (2 * np.sin(angle))
            spin = rate * turn[2]  # axes of the body
            time, found, _ = self.motion(f"  ball: {{rotation_deg: {np.degrees(angle * axis).tolist()}, floating: {{mass: 100, inertia: [10, 10, 10], "
                                         f"angular_velocity: {spin.tolist()}}}}}\n", 1, 0.05)
            np.testing.assert_allclose(found["roll"], roll, atol=1e-9)
            np.testing.assert_allclose(found["pitch"], pitch, atol=1e-9)
            np.testing.assert_allclose(found["yaw"], yaw + rate * time, atol=1e-9)
            vectors = self.of(found, "rotation_vector")
            self.assertLess(np.abs(np.diff(vectors, axis=0)).max(), 0.1)
            for vector, t in zip(vectors, time):
                np.testing.assert_allclose(rotation(vector), rotation([0, 0, rate * t]) @ turn, atol=1e-9)

    def frequencies(self):
        done = run(HAWSER, "modes", "case.yaml", "-n", "6", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return 2 * np.pi * np.array([float(v) for v in re.findall(r"^ *\d+ +[\d.e+-]+ +([\d.e+-]+) ", done.stdout, re.M)])

    def test_bifilar_pendulum(self):
        """T = 4 int sqrt((J + m h'^2)/(2 m g (h(A) - h))) dtheta, h = L - sqrt(L^2 - 2 b^2 (1 - cos theta)),
        and the same for swings along the bar: 0.1 %. For small swings, all four periods."""
        for turn, exact in ((1, 3.663253), (30, 3.724187), (90, 4.27224)):
            height = np.sqrt((2 + STRETCH) ** 2 - 0.5 * (1 - np.cos(np.radians(turn))))
            time, found, _ = self.motion(BAR.replace("PLACE", f"[0, 0, {-height - 0.3:.15g}]").replace("TURN", str(turn)), 22, 0.005)
            turns = period(time, found["rotation_vector_z"])
            print(f"bifilar pendulum, {turn} deg: {turns:.6f} s, off by {turns / exact - 1:+.1e}, rises by {np.ptp(found['position_z']):.5f} m")
            self.assertAlmostEqual(turns / exact, 1, delta=1e-3)
        for angle, exact in ((20, 2.859252), (45, 2.950915)):
            a = np.radians(angle)
            length = 2 + STRETCH * np.cos(a)
            place = f"[{length * np.sin(a):.15g}, 0, {-length * np.cos(a) - 0.3:.15g}]"
            time, found, _ = self.motion(BAR.replace("PLACE", place).replace("TURN", "0"), 30, 0.005)
            self.assertAlmostEqual(period(time, found["position_x"]) / exact, 1, delta=1e-3)
        self.motion(BAR.replace("PLACE", "[0, 0, -2.3]").replace("TURN", "0"))
        np.testing.assert_allclose(2 * np.pi / self.frequencies()[:4], [3.663185, 3.085036, 2.837491, 1.19121], rtol=1e-3)

    def test_heavy_top(self):
        """Cuspidal nutation of a top of 60 rad/s that is held at a point, over 4 s in steps of 1 ms (0.06 rad
        of its spin): inclination and precession to 1e-3 rad, nutation period to 1e-3."""
        tilt = 0.5235988
        text = (f"  top: {{position: [0, {-0.3 * np.sin(tilt):.15g}, {0.3 * np.cos(tilt):.15g}], rotation_deg: [{np.degrees(tilt):.15g}, 0, 0],\n"
                "        floating: {mass: 2, inertia: [0.07, 0.07, 0.06], weight: true, angular_velocity: [0, 0, 60]}}\n"
                "links:\n  pin: {end_a: {anchor: [0, 0, 0]}, end_b: {body: top, at: [0, 0, -0.3]}, stiffness: 1e7, rest_length: 0}\n")
        time, found, _ = self.motion(text, 4, 1e-3)
        place = self.of(found, "position")
        lean = np.arccos(place[:, 2] / 0.3)
        turned = np.unwrap(np.arctan2(place[:, 0], -place[:, 1]))
        for t, theta, phi in ((0.6, 0.53974, 0.99831), (1.5, 0.60987, 2.8567), (3, 0.68304, 5.4274), (3.9, 0.55382, 6.952), (4, 0.6403679, 7.126256)):
            at = np.argmin(np.abs(time - t))
            print(f"top at {t} s: off by {lean[at] - theta:+.1e}, {turned[at] - phi:+.1e} rad")
            self.assertAlmostEqual(lean[at], theta, delta=1e-3)
            self.assertAlmostEqual(turned[at], phi, delta=1e-3)
        self.assertAlmostEqual(lean.max(), 0.6831895, delta=1e-3)
        tops = np.flatnonzero((lean[:-2] < lean[1:-1]) & (lean[1:-1] >= lean[2:])) + 1
        before, top, after = (lean[tops + k] for k in (-1, 0, 1))
        at = time[tops] + 0.5 * 1e-3 * (before - after) / (before - 2 * top + after)  # maxima of parabolas
        nutation = (at[-1] - at[0]) / (len(at) - 1)
        print(f"top: nutation in {nutation:.6f} s, off by {nutation / 0.54646 - 1:+.1e}")
        self.assertAlmostEqual(nutation / 0.54646, 1, delta=1e-3)

    def test_intermediate_axis(self):
        """The rates of a body that rotates about its intermediate axis equal those of elliptic functions when
        it flips; energy and angular momentum are constant in both step lengths."""
        inertia = np.array([1.0, 2.0, 3.0])
        for step in (0.02, 0.01):
            time, found, file = self.motion("  top: {floating: {mass: 1, inertia: [1, 2, 3], angular_velocity: [0.01, 1, 0.01]}}\n", 20, step)
            turns = [rotation(v) for v in self.of(found, "rotation_vector")]
            rate = np.array([R.T @ w for R, w in zip(turns, self.of(found, "angular_velocity"))])
            for t, exact in ((9, [-0.59603, 0.80302, 0.34422]), (12, [-0.83196, -0.55492, 0.4804]), (18, [-0.031985, -0.99954, 0.020191])):
                np.testing.assert_allclose(rate[np.argmin(np.abs(time - t))], exact, atol=1e-3 if step > 0.01 else 1e-4)
            momentum = np.array([R @ (inertia * w) for R, w in zip(turns, rate)])
            energy = np.ptp(file["series/energy"][:, 0])
            off = np.abs(momentum - [0.01, 2, 0.03]).max()
            print(f"middle axis, steps of {step} s: momentum off by {off:.1e}, energy by {energy:.1e}")
            self.assertLess(energy, 1e-9)
            self.assertLess(off, 1e-9)

    def test_points_of_a_turned_body(self):
        """Position of an end at (58, 0, -14) of a body with the rotation vectors of (10, 20, 30) degrees, and
        of roll 10, pitch 20, yaw 30 about axes of the body, yaw first and roll first. If a body at pitch 20
        yaws, the velocity of the end is w x r."""
        def end(turn, rate=(0, 0, 0)):
            line = ("line_types: {rope: {outer_diameter: 0.01, mass_per_length: 0.1, EA: 1e4, bending: false}}\nlines:\n  rope: {sections: "
                    "[{type: rope, length: 60, elements: 20}], end_a: {anchor: [90, 20, -33]}, end_b: {body: hull, at: [58, 0, -14]}}\n")
            _, _, file = self.motion(f"  hull: {{rotation_deg: {list(turn)}, floating: {{mass: 1e9, inertia: [1e12, 1e12, 1e12], "
                                     f"angular_velocity: {list(rate)}}}}}\n" + line, 0.01, 0.01, ", {line: rope, at: end_b}")
            return file["series/rope@end_b"][0, :6]

        for turn, place in (((10, 20, 30), (41.75411, 30.99952, -29.25105)),
                            ((4.44187, 22.05037, 27.87321), (41.90095, 26.99869, -32.79300)),
                            ((14.91182, 16.92048, 31.36260), (42.41198, 33.82708, -24.83853))):
            np.testing.assert_allclose(end(turn)[:3], place, atol=1e-5)
        pitch = np.radians(20)
        found = end((0, 20, 0), (-0.1 * np.sin(pitch), 0, 0.1 * np.cos(pitch)))
        np.testing.assert_allclose(found[3:], np.cross([0, 0, 0.1], found[:3]), atol=1e-6)

    def test_crate_that_starts_inside_a_deck(self):
        """The motion does not allow the penetration of 3 cm from which friction brought the crate to rest in statics:
        the checkpoint has none, at rest it is m g/4k = 1.5 mm."""
        write(self.folder, "crate.yaml", """\
hawser: 1
bodies: {crate: {position: [0, 0, 0.07], floating: {mass: 600, inertia: [20, 52, 68], weight: true}}}
volumes:
  deck: {shape: {box: {centre: [0, 0, -0.5], size: [4, 4, 1]}}, friction: 1}
  crate: {shape: {box: {centre: [0, 0, 0], size: [1, 0.6, 0.2]}}, body: crate, normal_stiffness: {per_point: 1e6}, smoothing: 0, friction: 0.4}
statics: {contact_friction: true, relaxation_steps: 300}
dynamics: {duration: 0.001}
""")
        result = run(HAWSER, "run", self.folder / "crate.yaml", "-o", self.folder / "crate.h5")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        with h5py.File(self.folder / "crate.h5") as file:
            kept = np.concatenate([slot["values"][:] for slot in file["checkpoint"].values()])
        self.assertLess(np.abs(kept - 600 * GRAVITY / 4e6).min(), 1e-6)
        self.assertGreater(np.abs(kept - 0.03).min(), 1e-3)

    def test_load_on_one_cable(self):
        """In equilibrium the centre of mass is below the anchor, and the vertical, in body axes, passes
        through the attachment: 1e-4 m, 1e-4 rad. Frequencies of small swings: 0.1 %; the rotation about the
        vertical is free."""
        text = ("  load: {position: [0.05, -0.03, 5.1], rotation_deg: [-18, -34, 3], floating: {mass: 400, inertia: [180, 240, 150], "
                "products_of_inertia: [-12, -8, 25], weight: true}}\nlinks:\n  c0: {end_a: {anchor: [0, 0, 10]}, "
                "end_b: {body: load, at: [0.4, -0.25, 0.6]}, stiffness: 50000, rest_length: 4, tension_only: true}\n")
        _, found, file = self.motion(text)
        np.testing.assert_allclose(self.of(found, "position")[-1], [0, 0, 5.15832992], atol=1e-4)
        np.testing.assert_allclose(rotation(self.of(found, "rotation_vector")[-1])[2], [0.5240974, -0.3275609, 0.7861461], atol=1e-4)
        self.assertAlmostEqual(file["series/c0_link"][-1, 0] / 3922.66, 1, delta=1e-4)
        np.testing.assert_allclose(self.frequencies(), [1.404361, 1.411421, 4.055317, 5.003916, 11.18034], rtol=1e-3)  # the sixth mode is free

    def test_load_on_three_cables(self):
        """Equilibrium from a nearby start: 1e-4. Frequencies of small swings: 0.1 %. Motion of the thrown
        load over 5 s: 2 mm, 2e-3 rad, energy 1e-6."""
        away = REST + [0.05, -0.03, -0.02]
        turned = np.degrees(TURNED) + [3, -2, 4]
        _, found, file = self.motion(LOAD.replace("PLACE", str(list(away))).replace("TURN", str(list(turned))).replace(" MOTION", ""))
        np.testing.assert_allclose(self.of(found, "position")[-1], REST, atol=1e-4)
        np.testing.assert_allclose(self.of(found, "rotation_vector")[-1], TURNED, atol=1e-4)
        np.testing.assert_allclose([file[f"series/c{i}_link"][-1, 0] for i in range(3)], TENSIONS, rtol=1e-4)
        np.testing.assert_allclose(self.frequencies(), FREQUENCIES, rtol=1e-3)

        rate = rotation(TURNED).T @ [0.3, 0.2, 0.8]
        motion = f", velocity: [0.6, -0.4, 0.2], angular_velocity: {rate.tolist()}"
        text = LOAD.replace("PLACE", str(REST.tolist())).replace("TURN", str(np.degrees(TURNED).tolist())).replace(" MOTION", motion)
        time, found, file = self.motion(text, 5, 1e-3)
        for t, place, turn in ((1.6, [0.43825, -0.2795, 2.5949], [-0.033754, 0.032411, -0.29315]),
                               (3.2, [0.050256, -0.0087794, 2.5917], [-0.067635, -0.095094, 0.15186]),
                               (4.8, [0.62767, -0.42265, 2.5999], [0.001006, 0.090525, 0.12016])):
            at = np.argmin(np.abs(time - t))
            moved = self.of(found, "position")[at] - place
            spun = self.of(found, "rotation_vector")[at] - turn
            print(f"thrown load at {t} s: off by {np.abs(moved).max():.1e} m, {np.abs(spun).max():.1e} rad")
            self.assertLess(np.linalg.norm(moved), 2e-3)
            self.assertLess(np.linalg.norm(spun), 2e-3)
        energy = file["series/energy"][:]
        self.assertLess(np.abs(energy[:, 6]).max(), 1e-6 * 39048)


if __name__ == "__main__":
    unittest.main()
