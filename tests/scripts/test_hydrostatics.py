"""Hydrostatics from the mesh of a hull: natural periods of a box, a pile and a hemisphere against closed
forms, and a ship's displacement (skipped without its mesh). Radiation of a hemisphere by coefficients: decays
in steps of 5 to 200 ms against an inverse Laplace transform, and no energy from the memory."""
import gzip
import os
import re
import shutil
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
SHIP = ROOT.parent / "shared/data/hulls/kvlcc2.obj.gz"
SEMI = ROOT.parent / "shared/data/umaine-semi/IEA-15-240-RWT-UMaineSemi.hst"
BALL = """\
hawser: 1
environment: {{gravity: 9.81, water: {{density: 1000}}}}
bodies:
  ball: {{position: [0, 0, {place}], floating: {{mass: 261799.3878, inertia: [2.6e6, 2.6e6, 2.6e6], hydrodynamics: {{wamit: hemisphere,
         length_scale: 5}} {more}}}}}
statics: false
dynamics: {{duration: 12, {steps}}}
output: {{every: 100, histories: [{{body: ball}}]}}
"""


class Hydrostatics(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def periods(self, floating, volume):
        """Periods of `hawser modes` by the names of their freedoms."""
        write(self.folder, "case.yaml", "hawser: 1\nenvironment: {gravity: 9.81, water: {density: 1000}}\nbodies:\n"
              f"  body: {{floating: {{{floating}, hull: {{volumes: [shape]}}}}}}\nvolumes: {{shape: {{{volume}, body: body}}}}\n")
        done = run(HAWSER, "modes", "case.yaml", "-n", "6", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return {name: float(period) for period, name in re.findall(r"^ *\d+ +([\d.]+) .*body body: (\w+)", done.stdout, re.M)}

    def test_periods_of_shapes(self):
        """Heave 2 pi sqrt(m/(rho g A)), roll 2 pi sqrt(J/(rho g (I + V (z_B - z_G)))). Tolerance 1e-4 for
        flat and cylindrical sides, 2e-3 for a sphere, whose triangles have its volume and 0.23 % more
        waterplane area."""
        weight = 1000 * 9.81
        for what, floating, shape, area, moments, volume, arm, inertia, tolerance in (
                ("box", "mass: 576000, centre_of_mass: [0, 0, -0.6], inertia: [4e6, 2.2e7, 2.4e7]", "box: {centre: [0, 0, 0], size: [20, 8, 7.2]}",
                 160, {"roll": 20 * 8**3 / 12, "pitch": 8 * 20**3 / 12}, 576, -1.2, {"roll": 4e6, "pitch": 2.2e7}, 1e-4),
                ("pile", f"mass: {40 * np.pi * 36e3:.17g}, centre_of_mass: [0, 0, -26], inertia: [9e8, 9e8, 8e7]",
                 "cylinder: {from: [0, 0, -40], to: [0, 0, 10], radius: 6}", 36 * np.pi, {"roll": np.pi * 6**4 / 4, "pitch": np.pi * 6**4 / 4},
                 1440 * np.pi, 6, {"roll": 9e8, "pitch": 9e8}, 1e-4),
                ("hemisphere", f"mass: {250e3 / 3 * np.pi:.17g}, inertia: [2.6e6, 2.6e6, 2.6e6]", "sphere: {centre: [0, 0, 0], radius: 5}",
                 25 * np.pi, {}, 250 / 3 * np.pi, -15 / 8, {}, 2e-3)):
            found = self.periods(floating, f"shape: {{{shape}}}")
            exact = {"heave": 2 * np.pi * np.sqrt(1000 * volume / (weight * area))}
            for freedom, moment in moments.items():
                exact[freedom] = 2 * np.pi * np.sqrt(inertia[freedom] / (weight * (moment + volume * arm)))
            # Roll and pitch of the pile are two modes of one frequency about any horizontal axes, which may have one name.
            self.assertLessEqual(len(exact.keys() - found.keys()), what == "pile", found)
            off = {freedom: found[freedom] / period - 1 for freedom, period in exact.items() if freedom in found}
            print(f"{what}: " + ", ".join(f"{freedom} {found[freedom]:.5g} s, {error:+.1e}" for freedom, error in off.items()))
            self.assertLess(max(map(abs, off.values())), tolerance)

    def test_heights_beside_the_waterplane(self):
        """A float of 40 x 20 m with a draught of 2 m over a box of 20 x 20 x 4 m below one of its ends. The metacentric heights
        I/V + z_B - z_G have I about the centre of the waterplane, 5 m aft of the centres of mass and buoyancy."""
        write(self.folder, "case.yaml", """\
hawser: 1
environment: {water: {density: 1000}}
bodies: {body: {floating: {mass: 3.2e6, centre_of_mass: [5, 0, 0], inertia: [1e8, 4e8, 4e8], hull: {volumes: [above, below]}}}}
volumes:
  above: {shape: {box: {centre: [0, 0, 0], size: [40, 20, 4]}}, body: body}
  below: {shape: {box: {centre: [10, 0, -4.5], size: [20, 20, 4]}}, body: body}
""")
        done = run(HAWSER, "check", "case.yaml", "--quick", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        found = [float(x) for x in re.search(r"metacentric heights (\S+) m \(roll\), (\S+) m", done.stdout).groups()]
        buoyancy = -0.5 * 1 - 0.5 * 4.5
        np.testing.assert_allclose(found, [40 * 20**3 / 12 / 3200 + buoyancy, 20 * 40**3 / 12 / 3200 + buoyancy], rtol=2e-4)

    def test_box_that_turns_over(self):
        """A box of 40 x 20 x 8 m with a draught of 4 m and a metacentric height of -1.67 m, pushed over by a small moment. With 5.33 m
        it heels by sin(heel) (GM + BM/2 tan² heel) = moment/weight."""
        def rest(height, ranks=(), moment=3e6):
            write(self.folder, "case.yaml", f"""\
hawser: 1
environment: {{gravity: 9.81, water: {{density: 1000}}}}
bodies: {{box: {{floating: {{mass: 3.2e6, centre_of_mass: [0, 0, {height}], inertia: [1.5e8, 4.5e8, 5e8], hull: {{volumes: [hull]}}, turning_stiffness: [0, 0, 1e8],
                           loads: [{{force: [0, 0, 0], moment: [{moment}, 0, 0]}}]}}}}}}
volumes: {{hull: {{shape: {{box: {{centre: [0, 0, 0], size: [40, 20, 8]}}}}, body: box}}}}
output: {{histories: [{{body: box}}]}}
""")
            done = run(*ranks, HAWSER, "run", "case.yaml", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            with h5py.File(self.folder / "case.h5") as file:
                return float(file["series/box"][-1, 3]), done.stdout + done.stderr

        heel, text = rest(1)
        self.assertNotIn("warning:", text)
        self.assertAlmostEqual(np.sin(heel) * (16 / 3 + 25 / 6 * np.tan(heel) ** 2), 3e6 / (3.2e6 * 9.81), places=8)
        for ranks in ((), ("mpirun", "--allow-run-as-root", "--oversubscribe", "-n", "2")):
            heel, text = rest(8, ranks)
            self.assertGreater(abs(heel), np.pi / 2)
            self.assertEqual(text.count("warning: body box comes to rest turned over, 180 deg"), 1, text)
            # Upright without a moment: an unstable equilibrium that is left.
            heel, text = rest(8, ranks, moment=0)
            self.assertAlmostEqual(abs(heel), np.pi, places=5)
            self.assertIn("note: the search passed through 1 unstable equilibrium", text)
            self.assertNotIn("warning: the static equilibrium is unstable", text)
            heel, text = rest(6.5, ranks, moment=0)
            self.assertAlmostEqual(heel, np.arctan(0.2), places=6)
            self.assertNotIn("warning", text)

    def sphere(self, around):
        """Writes a mesh of a sphere of 5 m with as many facets around its axis and half as many from pole to
        pole, and its exact volume."""
        polar, azimuth = np.linspace(0, np.pi, around // 2 + 1)[1:-1], 2 * np.pi / around * np.arange(around)
        rings = np.stack([np.outer(np.sin(polar), np.cos(azimuth)), np.outer(np.sin(polar), np.sin(azimuth)),
                          np.outer(np.cos(polar), np.ones(around))], axis=-1)
        points = np.vstack([[[0, 0, 1]], rings.reshape(-1, 3), [[0, 0, -1]]])
        number = 1 + np.arange(len(polar) * around).reshape(-1, around)
        faces = []
        for k in range(around):
            other = (k + 1) % around
            faces += [(0, number[0, k], number[0, other]), (number[-1, k], len(points) - 1, number[-1, other])]
            for upper, lower in zip(number[:-1], number[1:]):
                faces += [(upper[k], lower[k], lower[other]), (upper[k], lower[other], upper[other])]
        a, b, c = (points[[face[corner] for face in faces]] for corner in range(3))
        points *= (500 / 3 * np.pi / (np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)) ** (1 / 3)
        write(self.folder, "sphere.obj", "".join(f"v {x:.12g} {y:.12g} {z:.12g}\n" for x, y, z in points) +
              "".join(f"f {i + 1} {j + 1} {k + 1}\n" for i, j, k in faces))

    def test_hemisphere_by_a_mesh(self):
        """The error of heave decreases with the square of the facets around: 2.2e-3 with 32, 1e-4 with 180
        (32 000 triangles). The triangles of a `sphere` are 64 around and 48 from pole to pole and back."""
        exact, found = 2 * np.pi * np.sqrt(2 / 3 * 5 / 9.81), {}
        for around in (32, 180):
            self.sphere(around)
            period = self.periods(f"mass: {250e3 / 3 * np.pi:.17g}, inertia: [2.6e6, 2.6e6, 2.6e6]", "mesh: sphere.obj")["heave"]
            found[around] = period / exact - 1
            print(f"hemisphere of {around} facets around: heave {found[around]:+.1e}")
        self.assertAlmostEqual(found[32], -2.15e-3, delta=1e-4)
        self.assertLess(abs(found[180]), 1e-4)

    def test_displacement_of_a_tanker(self):
        """KVLCC2 at 20.8 m draught (SIMMAN 2008): displacement 312 622 m3 and KM 24.29 m (KG 18.6 m and GM
        5.71 m), both to 0.3 %. The mesh is open at the transom and the rudder."""
        if not SHIP.exists():
            self.skipTest(f"{SHIP} is not there")
        (self.folder / "kvlcc2.obj").write_bytes(gzip.decompress(SHIP.read_bytes()))
        write(self.folder, "case.yaml", "hawser: 1\nenvironment: {gravity: 9.81, water: {density: 1000}}\nbodies:\n  ship: {floating: {mass: 312622e3, "
              "inertia: [1e11, 2e12, 2e12], hull: {volumes: [ship]}}}\nvolumes: {ship: {mesh: kvlcc2.obj, scale: 58, body: ship}}\n")
        done = run(HAWSER, "check", "case.yaml", "--quick", cwd=self.folder)
        volume = float(re.search(r"displaces (\d+) m³", done.stdout)[1])
        height = float(re.search(r"metacentric heights ([\d.]+) m \(roll\)", done.stdout)[1]) + 20.8
        print(f"KVLCC2: {volume:.0f} m3, {volume / 312622 - 1:+.2%}; KM {height:.3f} m, {height / 24.29 - 1:+.2%}")
        self.assertAlmostEqual(volume / 312622, 1, delta=3e-3)
        self.assertAlmostEqual(height / 24.29, 1, delta=3e-3)

    def test_volturnus_by_a_mesh(self):
        """Volume, waterplane and stiffness of roll and pitch of the VolturnUS-S by a mesh of its pontoons, 12.5 m wide and 7 m high in a
        depth of 20 m, and four columns, against the .hst of WAMIT and the volume in its output: 1 %, and 2 % of the stiffness, a
        difference of two terms three times as large. The panels there have 0.8 % less waterplane than the circles."""
        if not SEMI.exists():
            self.skipTest(f"{SEMI} is not there")
        weight = {tuple(map(int, row[:2])): float(row[2]) for row in map(str.split, SEMI.read_text("ascii").splitlines())}
        outline, half, arm = [], 6.25, 51.75
        for k in range(3):
            ahead = np.array([-np.cos(2 * np.pi * k / 3), -np.sin(2 * np.pi * k / 3)])
            aside = np.array([-ahead[1], ahead[0]])
            outline += [arm * ahead + half * (np.cos(a) * ahead + np.sin(a) * aside) for a in np.linspace(-np.pi / 2, np.pi / 2, 41)]
            outline.append(half / np.sin(np.pi / 3) * (np.cos(np.pi / 3) * ahead + np.sin(np.pi / 3) * aside))
        n = len(outline)
        corners = [(*point, z) for z in (-20, -13) for point in outline] + [(0, 0, -20), (0, 0, -13)]
        faces = [face for i in range(n) for j in ((i + 1) % n,) for face in
                 ((i, j, n + j), (i, n + j, n + i), (2 * n, j, i), (2 * n + 1, n + i, n + j))]
        write(self.folder, "pontoons.obj", "".join(f"v {x:.9f} {y:.9f} {z}\n" for x, y, z in corners)
              + "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in faces))
        columns = [(0, 0, 5)] + [(-arm * np.cos(2 * np.pi * k / 3), -arm * np.sin(2 * np.pi * k / 3), half) for k in range(3)]
        shapes = "".join(f"  column {k}: {{shape: {{cylinder: {{from: [{x:.9f}, {y:.9f}, -13], to: [{x:.9f}, {y:.9f}, 15], radius: {r}}}}}, body: semi}}\n"
                         for k, (x, y, r) in enumerate(columns))
        write(self.folder, "case.yaml", "hawser: 1\nenvironment: {gravity: 9.80665, water: {density: 1025}}\nbodies:\n  semi: {floating: {mass: 20206.3 t, "
              "inertia: [4e10, 4e10, 2e10], hull: {volumes: [pontoons, column 0, column 1, column 2, column 3]}}}\nvolumes:\n"
              f"  pontoons: {{mesh: pontoons.obj, body: semi}}\n{shapes}")
        done = run(HAWSER, "check", "case.yaml", "--quick", cwd=self.folder)
        volume, plane, roll, pitch = (float(re.search(text, done.stdout)[1]) for text in (
            r"displaces (\d+) m³", r"waterplane ([\d.]+) m²", r"metacentric heights ([\d.]+) m \(roll\)", r"([\d.]+) m \(pitch\)"))
        for what, found, known, tolerance in (("volume", volume, 20206.35, 0.01), ("waterplane", plane, weight[3, 3], 0.01),
                                              ("roll", volume * roll, weight[4, 4], 0.02), ("pitch", volume * pitch, weight[5, 5], 0.02)):
            print(f"VolturnUS-S by a mesh, {what}: {found / known - 1:+.2%}")
            self.assertAlmostEqual(found / known, 1, delta=tolerance)

    def ball(self, steps, place=1, more=""):
        """Time, heave, velocity and radiation force of a hemisphere."""
        for ending in (".1", ".hst"):
            shutil.copy(ROOT / f"tests/data/hemisphere{ending}", self.folder)
        write(self.folder, "case.yaml", BALL.format(place=place, steps=steps, more=more))
        done = run(HAWSER, "run", "case.yaml", "-q", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with h5py.File(self.folder / "case.h5") as file:
            data = file["series/ball"]
            columns = [c.decode() for c in data.attrs["columns"]]
            return [file["series/time"][:]] + [data[:, columns.index(c)] for c in ("position_z", "velocity_z", "radiation_force_z")]

    def test_steps_of_a_decay(self):
        """Decay of heave from 1 m, against the inverse Laplace transform with the exact coefficients (Hulme
        1982): 0.2 % of the start in steps of 5 to 100 ms and in steps of 5 to 200 ms set by the local error;
        1 % in steps of 0.2 s, a 22nd of the period, with the second-order scheme."""
        known = ((0.5, 0.765791737), (2.5, -0.798213175), (5, 0.43444015), (7.5, -0.144894465), (10, -0.0327708241))
        for steps, tolerance in (("step: 0.005, rho_infinity: 1", 2e-3), ("step: 0.05, rho_infinity: 1", 2e-3),
                                 ("max_step: 0.2, min_step: 0.005, error_tolerance: 1e-4", 2e-3), ("step: 0.1, rho_infinity: 1", 2e-3),
                                 ("step: 0.2, rho_infinity: 1", 1e-2)):
            time, z, _, _ = self.ball(steps)
            error = max(abs(np.interp(t, time, z) - exact) for t, exact in known)
            print(f"hemisphere, {steps}: {len(time) - 1} steps, off by {error:.1e} of the start")
            self.assertLess(error, tolerance)

    def test_memory_takes_energy_out(self):
        """The energy that the memory of a hemisphere has absorbed is positive at all times; irregular forces
        push the hemisphere from rest."""
        rng = np.random.default_rng(45)
        rows = ", ".join(f"[{0.25 * k}, 0, 0, {push:.1f}]" for k, push in enumerate(np.append(0, 4e5 * rng.standard_normal(48))))
        for step in (0.005, 0.02, 0.2):
            time, _, v, force = self.ball(f"step: {step}, rho_infinity: 1", 0, f", loads: [{{table: {{rows: [{rows}]}}}}]")
            added = 0.5 * 261799.3878  # added mass at infinite frequency: half of the displaced mass
            # The recorded radiation force includes that of the added mass, whose work is kinetic energy.
            work = -np.cumsum(0.5 * (force[1:] + force[:-1]) * 0.5 * (v[1:] + v[:-1]) * np.diff(time))
            taken = work - 0.5 * added * v[1:] ** 2
            print(f"steps of {step} s: the memory takes {taken.min():.3g} to {taken.max():.3g} J")
            self.assertGreater(taken.max(), 1e5)
            self.assertGreater(taken.min(), -2e-4 * taken.max())  # error of the trapezoidal rule


if __name__ == "__main__":
    unittest.main()
