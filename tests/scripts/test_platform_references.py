"""Platforms with third-party coefficients (skipped if missing): decays, natural periods, responses and slow drift
against frequency-domain solutions (inverse Laplace transforms, eigenvalues, complex equations, double sums)."""
import csv
import json
import os
import re
import shutil
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
from support import ROOT, run, write
from test_rao import Reference, off, text_of

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
DATA = ROOT.parent / "shared/data"
UMAINE = "IEA-15-240-RWT-UMaineSemi"
MOTION = ("position_x", "position_y", "position_z", "rotation_vector_x", "rotation_vector_y", "rotation_vector_z")
# Mooring stiffness of the VolturnUS-S in its WAMIT run.
MOORING = np.diag([7.192e4, 7.192e4, 6.076e4, 2.587e8, 2.587e8, 2.524e8])
MOORING[0, 4] = MOORING[4, 0] = 1.145e6
MOORING[1, 3] = MOORING[3, 1] = -1.145e6
DAMPING = np.diag([1.6299e5, 1.6299e5, 1.4632e6, 1.2627e9, 1.2627e9, 0])
UMAINE_INERTIA = [4.26e10 - 2.01e7 * 2.32**2] * 2 + [2.37e10]
# Three chains on the OC4 DeepCwind (exact catenaries); mass and inertia of platform, tower and turbine.
OC4_MOORING = np.diag([70836.05, 70836.05, 19140.47, 8.724075e7, 8.724075e7, 1.169702e8])
OC4_MOORING[0, 4] = OC4_MOORING[4, 0] = -107232
OC4_MOORING[1, 3] = OC4_MOORING[3, 1] = 107232
OC4_MASS, OC4_CENTRE = 1.407265e7, -1.391779e8 / 1.407265e7
OC4_INERTIA = [1.270018e10 - OC4_MASS * OC4_CENTRE**2, 1.269097e10 - OC4_MASS * OC4_CENTRE**2, 1.228805e10]
NONE = np.zeros((6, 6))
WHOLE = bool(os.environ.get("HAWSER_FULL"))  # all waves of a test, not a selection


def sea(omegas, amplitudes, direction, leads, ramp):
    waves = ", ".join(f"{{height: {2 * a:.15g}, period: {2 * np.pi / w:.17g}, direction_deg: {direction}, phase_deg: {-np.degrees(p):.15g}}}"
                      for w, a, p in zip(omegas, amplitudes, leads))
    return f"waves: {{components: [{waves}], ramp: {ramp}}}"


def floater(stem, mass, centre, inertia, more, place=(0, 0, 0), turn=(0, 0, 0)):
    return (f"  semi: {{position: {list(place)}, rotation_deg: {np.degrees(turn).tolist()}, floating: {{mass: {mass}, centre_of_mass: [0, 0, {centre}], "
            f"inertia: {inertia},\n         hydrodynamics: {{wamit: {stem}, place: [0, 0, 0], heading_deg: 0, follow_period: 0 {more}}}}}}}\n")


def added(damping, stiffness):
    return f", damping: {json.dumps(damping.tolist())}, stiffness: {json.dumps(stiffness.tolist())}"


def volturnus(more, **where):
    return floater(UMAINE, 2.01e7, -2.32, UMAINE_INERTIA, more, **where)


def oc4(more=""):
    return floater("oc4", OC4_MASS, OC4_CENTRE, OC4_INERTIA, added(NONE, OC4_MOORING) + more)


class PlatformRuns(unittest.TestCase):
    """Files, cases and runs of the tests of platforms."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def files(self, names):
        """Copies third-party files by their names here, or skips the test."""
        for name, path in names.items():
            if not (DATA / path).exists():
                self.skipTest(f"{DATA / path} is not there")
            shutil.copy(DATA / path, self.folder / name)

    def umaine(self):
        self.files({f"{UMAINE}{e}": f"umaine-semi/{UMAINE}{e}" for e in (".1", ".3.gz", ".12d.gz", ".hst")})

    def oc4_files(self):
        folder = "platforms/oc4-semi/"
        self.files({"oc4.1.gz": f"{folder}marin_semi.1.gz", "oc4.hst": f"{folder}marin_semi.hst", "oc4.3.gz": f"{folder}oc4_excitation_raft_grid.3.gz"})

    def tanker(self):
        """Copies the files of a tanker; its mass and damping by its .frc."""
        self.files({f"tanker{e}": f"platforms/mss-tanker/tanker{e}" for e in (".1", ".3.gz", ".hst")})
        mass = np.diag([94620210, 94620210, 94620210, 27409620280.88, 387080076077.14, 417428070207.44])
        mass[0, 4] = mass[4, 0] = 236550525
        mass[1, 3] = mass[3, 1] = -236550525
        mass[2, 4] = mass[4, 2] = -371857425.3
        damping = np.diag([4.1e5, 0, 0, 1.56e9, 0, 0])
        return mass, damping

    def case(self, bodies, water="density: 1025, depth: 200", gravity=9.80665, waves="", end=""):
        names = re.findall(r"^  (\w+): {position", bodies, re.M)
        histories = ", ".join(f"{{body: {name}}}" for name in names)
        output = "" if "output:" in end else f"output: {{every: 10000, histories: [{histories}]}}\n"
        write(self.folder, "case.yaml", f"hawser: 1\nenvironment: {{gravity: {gravity}, water: {{{water}}}{', ' + waves if waves else ''}}}\n"
              f"bodies:\n{bodies}{end}\n{output}")

    def run_case(self, bodies, duration=0.0, step=0.0, end="", **how):
        """Histories of a run, or statics without a duration: time, and columns by body."""
        if duration:
            end += f"statics: false\ndynamics: {{duration: {duration}, step: {step}, rho_infinity: 1}}"
        self.case(bodies, end=end, **how)
        done = run(HAWSER, "run", "case.yaml", "-q", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        found = {}
        with h5py.File(self.folder / "case.h5") as file:
            for name, data in file["series"].items():
                if "position_x" in [c.decode() for c in data.attrs.get("columns", [])]:
                    found[name] = {c.decode(): data[:, k] for k, c in enumerate(data.attrs["columns"])}
            return file["series/time"][:], found

    def decay(self, what, known, size, time, x, tolerance):
        error = max(abs(np.interp(t, time, x) - value) for t, value in known) / size
        print(f"{what}: off by {error:.1e} of the start")
        self.assertLess(error, tolerance)


class Platforms(PlatformRuns):
    def test_decays_of_volturnus(self):
        """Decays with linear mooring and damping: 1e-3 of the initial displacement in steps of 0.05 s (surge:
        0.2 s). Nearly undamped free heave in steps of 0.1 and 0.2 s, and in steps up to 0.2 s set by the
        local error: 2e-3."""
        self.umaine()
        time, found = self.run_case(volturnus("", place=(0, 0, 1)), 110, 0.05)
        known = ((5, 0.0282245), (25, 0.20732), (45, 0.365117), (65, 0.512062), (85, 0.643978), (105, 0.757109))
        self.decay("heave of the VolturnUS-S", known, 1, time, found["semi"]["position_z"], 1e-3)
        known += ((100, 0.6396321), (110, -0.5750812), (120, 0.5061448))
        for steps in ("step: 0.1, rho_infinity: 1", "step: 0.2, rho_infinity: 1", "step: 0.2", "max_step: 0.2, error_tolerance: 1e-5"):
            time, found = self.run_case(volturnus("", place=(0, 0, 1)),
                                        end=f"statics: false\ndynamics: {{duration: 121, {steps}}}\noutput: {{every: 5, histories: [{{body: semi}}]}}")
            self.decay(f"heave, {steps}", known, 1, time, found["semi"]["position_z"], 2e-3)
        moored = added(DAMPING, MOORING)
        time, found = self.run_case(volturnus(moored, turn=(0, 0.05235988, 0)), 110, 0.05)
        known = ((5, 0.0220759), (25, 0.0335288), (45, -0.0178864), (65, -0.0189744), (85, 0.0133501), (105, 0.0102058))
        self.decay("its moored pitch", known, 0.05236, time, found["semi"]["rotation_vector_y"], 1e-3)
        time, found = self.run_case(volturnus(moored, place=(5, 0, 0)), 440, 0.2)
        known = ((20, 3.03514), (100, -0.44702), (180, -1.433483), (260, 2.264645), (340, -2.146396), (420, 1.421772))
        self.decay("its moored surge", known, 5, time, found["semi"]["position_x"], 1e-3)

    def test_decay_of_a_sphere(self):
        """Decay of a hemisphere over 40 s, from a file with moments about a point below the water line: 0.5
        mm of 1 m."""
        folder = "platforms/oes-sphere/"
        self.files({"ball.1.gz": f"{folder}sphere.1.gz", "ball.hst": f"{folder}sphere.hst"})
        ball = "  ball: {position: [0, 0, 1], floating: {mass: 261800, inertia: [2.6e6, 2.6e6, 2.6e6], hydrodynamics: {wamit: ball, place: [0, 0, 0]}}}\n"
        time, found = self.run_case(ball, 40, 0.02, water="density: 1000", gravity=9.81)
        known = ((4, 0.5185204), (8, 0.1373355), (14, 0.0656044), (22, 0.0566944), (30, 0.0129212), (38, -0.0017839))
        self.decay("heave of a sphere", known, 1, time, found["ball"]["position_z"], 5e-4)

    def test_decay_of_two_bodies(self):
        """Decays of RM3, a float around a spar with a plate: separate, coupled by a damper, and joined: 1e-3
        of the initial displacement, 2e-3 when joined by a spring of 5e10 N/m."""
        self.files({"rm3.1.gz": "platforms/rm3/rm3.1.gz", "rm3.hst": "platforms/rm3/rm3.hst"})

        def pair(z1, z2):
            return (f"  float: {{position: [0, 0, {z1}], floating: {{mass: 725834, inertia: [2.1e7, 2.1e7, 3.7e7], "
                    "hydrodynamics: {wamit: rm3, body: 1, place: [0, 0, 0]}}}\n"
                    f"  spar: {{position: [0, 0, {z2}], floating: {{mass: 886691, inertia: [9.4e7, 9.4e7, 2.9e7], "
                    "hydrodynamics: {wamit: rm3, body: 2, place: [0, 0, 0]}}}\n")

        between = "links: {between: {end_a: {body: float, at: [0, 0, -1]}, end_b: {body: spar, at: [0, 0, -100]}, LAW}}\n"
        alone = ((5, 0.0448, -0.0044953), (10, 0.0159039, 0.0004921), (20, 0.0020387, 0.0039209), (40, 0.000041, -0.003676))
        damped = ((5, -0.0085451, -0.4481928), (10, 0.0209808, -0.2726351), (20, 0.0074511, 0.0902856), (40, -0.0019419, -0.0268269))
        joined = ((6, -0.4879072, -0.4879072), (20, -0.3033145, -0.3033145), (38, 0.3266836, 0.3266836))
        for what, z1, z2, link, known, tolerance in (("alone", 0.1, 0, "", alone, 1e-3),
                                                     ("damped", 0.5, -0.3, between.replace("LAW", "damping: 1.2e6"), damped, 1e-3),
                                                     ("joined", 0.5, 0.5, between.replace("LAW", "stiffness: 5e10"), joined, 2e-3)):
            time, found = self.run_case(pair(z1, z2), 42, 0.02, end=link, water="density: 1000", gravity=9.81)
            self.decay(f"RM3 {what}, float", [(t, a) for t, a, _ in known], z1, time, found["float"]["position_z"], tolerance)
            self.decay(f"RM3 {what}, spar", [(t, b) for t, _, b in known], z1, time, found["spar"]["position_z"], tolerance)

    def test_decay_about_a_hinge(self):
        """Decay of a flap on a ball joint, with coefficients about the joint: 1e-3 of 1 deg, against linear
        equations."""
        self.files({"flap.csv": "platforms/oswec/flap_pitch_about_hinge.csv"})
        with open(self.folder / "flap.csv", newline="") as file:
            table = [[float(x) for x in row] for row in csv.reader(line for line in file if line[0] != "#")]
        rows = ["0 5 5 18085.45"] + [f"{2 * np.pi / w:.17g} 5 5 {A / 1000:.15g} {B / 1000 / w:.15g}" for w, A, B in table]
        write(self.folder, "flap.1", "\n".join(rows) + "\n")
        write(self.folder, "flap.hst", f"5 5 {297.377 * (8.9 - 4.5915) + 8.378e4 / 9810:.15g}\n")
        flap = ("  flap: {position: [0, 0, -8.9], rotation_deg: [0, 1, 0], floating: {mass: 127000, centre_of_mass: [0, 0, 5],\n"
                "         inertia: [1.85e6, 1.85e6, 1.85e6], hydrodynamics: {wamit: flap, place: [0, 0, -8.9], heading_deg: 0, follow_period: 0,\n"
                "         displaced_volume: 297.377}}}\n")
        hinge = "links: {hinge: {end_a: {anchor: [0, 0, -8.9]}, end_b: {body: flap, at: [0, 0, 0]}, stiffness: 1e10, rest_length: 0}}\n"
        time, found = self.run_case(flap, 92, 0.02, end=hinge, water="density: 1000", gravity=9.81)
        known = [(t, 0.1 * x) for t, x in ((10, -0.1531029), (20, 0.1422034), (40, 0.1191562), (60, 0.0959212), (90, -0.0628001))]
        self.decay("flap on a hinge", known, 0.01745329, time, found["flap"]["rotation_vector_y"], 1e-3)

    def test_natural_periods(self):
        """Undamped natural periods: 0.05 %. The references are 2 pi/Im lambda = T/sqrt(1 - zeta^2)."""
        self.umaine()
        self.oc4_files()
        zeta = np.array([0.0532156, 0.0532156, 0, 0.0503335, 0.0503359, 0.0500484])
        damped = np.array([135.04524, 135.045379, 88.1476114, 27.104697, 27.1056352, 20.4423728])
        for what, bodies, exact in (("VolturnUS-S", volturnus(""), [28.4326431, 28.4315405, 20.5522723]),
                                    ("moored VolturnUS-S", volturnus(added(DAMPING, MOORING)), damped * np.sqrt(1 - zeta**2)),
                                    ("OC4 DeepCwind", oc4(), [113.122261, 113.121849, 79.4996069, 25.4449864, 25.4380356, 17.2778431])):
            self.case(bodies)
            done = run(HAWSER, "modes", "case.yaml", "-n", "6", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            found = np.array(sorted((float(v) for v in re.findall(r"^ *\d+ +([\d.]+) ", done.stdout, re.M)), reverse=True))
            exact = np.array(sorted(exact, reverse=True))
            print(f"{what}: periods off by {np.abs(found / exact - 1).max():.1e}")
            np.testing.assert_allclose(found, exact, rtol=5e-4)

    def response(self, bodies, omega, direction, natural, step, duration=800, **how):
        """Response to a wave of 2 cm at its frequency, separated from the nearly undamped free motion."""
        time, found = self.run_case(bodies, duration, step, waves=sea([omega], [0.02], direction, [0], 150), **how)
        use = time > 160
        columns = [np.ones(np.count_nonzero(use)), time[use]]
        for rate in (1j * omega, *natural):
            wave = np.exp(rate * time[use])
            columns += [wave.real, -wave.imag]
        motion = np.array([found["semi"][c][use] for c in MOTION]).T
        part = np.linalg.lstsq(np.array(columns).T, motion, rcond=None)[0]
        return (part[2] + 1j * part[3]) / 0.02

    def test_responses_of_oc4(self):
        """Responses to waves along 0 and 40 deg, against six complex equations: 0.5 % of the largest response
        of its kind."""
        self.oc4_files()
        natural = 2 * np.pi / np.array([113.122, 79.4996, 25.438, 25.445, 17.2778]) * (1j - np.array([1.2e-5, 0, 6e-6, 6e-6, 5.627e-4]))
        for period, direction, size, lead in (
                (16.6666667, 0, [0.8247788, 0, 1.809089, 0, 0.001511564, 0], [-90.372, 0, -178.986, 0, 82.763, 0]),
                (10, 0, [0.394288, 0, 0.2157344, 0, 0.006334327, 0], [-99.916, 0, -6.224, 0, 103.36, 0]),
                (25, 0, [2.177683, 0, 1.086015, 0, 0.09622966, 0], [-87.665, 0, -0.023, 0, -85.177, 0]),
                (25, 40, [1.666981, 1.390521, 1.086004, 0.06117902, 0.07347479, 0.000174518], [-89.433, -93.467, 0.005, 82.741, -88.866, -90.005]),
                (12.5, 40, [0.4679717, 0.3946105, 0.2655533, 0.003336205, 0.003915079, 0.001428284], [-89.752, -86.916, 0.953, -99.881, 91.93, -89.955]),
                (7.14285714, 40, [0.04140756, 0.05201151, 0.03682081, 0.003311427, 0.002348289, 0.005693272],
                 [-26.409, -40.69, 90.35, -133.823, 113.321, -90.738])):
            if not WHOLE and (period, direction) not in ((16.6666667, 0), (25, 40), (7.14285714, 40)):
                continue
            exact = size * np.exp(1j * np.radians(lead))
            found = self.response(oc4(), 2 * np.pi / period, direction, natural, 0.2 if period > 15 else 0.1)
            print(f"OC4 in a wave of {period:.4g} s to {direction} deg: off by {off(found, exact):.1e}")
            self.assertLess(off(found, exact), 5e-3)

    def test_full_matrix_of_mass(self):
        """Responses of a tanker with the mass matrix of its .frc, which couples pitch and heave but not yaw
        and sway, so that it is not that of a rigid body: 0.3 % of the largest response of its kind, if the
        reference has the added mass that belongs to the damping. The added mass of the file, which has
        irregular frequencies with negative damping, differs: 1.5 %."""
        mass, damping = self.tanker()
        ship = ("  semi: {position: [0, 0, 0], floating: {mass: 94620210, centre_of_mass: [3.93, 0, 2.5], "
                f"mass_matrix: {{rows: {json.dumps(mass.tolist())}}},\n         hydrodynamics: {{wamit: tanker, follow_period: 0, place: [0, 0, 0], "
                "heading_deg: 0, symmetry: port_starboard, gravity_in_stiffness: true, "
                f"damping: {json.dumps(damping.tolist())}}}}}}}\n")
        for period, direction, size, lead in (
                (7.86, 180, [0.03860134, 0, 0.07607129, 0, 0.001432062, 0], [82.377, 0, -125.756, 0, 66.366, 0]),
                (10.44, 120, [0.1948939, 0.2255905, 0.6121073, 0.00857545, 0.01275726, 0.005844512], [89.758, -75.892, -2.949, 84.228, -107.921, 6.255]),
                (13.91, 120, [0.372586, 0.676606, 0.829605, 0.039274, 0.00943496, 0.00589319], [91.918, -95.658, 1.523, -120.626, -96.191, 1.981])):
            if not WHOLE and period == 13.91:
                continue
            exact = size * np.exp(1j * np.radians(lead))
            omega = 2 * np.pi / period
            found = self.response(ship, omega, direction, [], 0.1, 900, gravity=9.81, water="density: 1025")
            with_memory = self.with_memory(omega, direction, mass, damping)
            print(f"tanker in a wave of {period} s to {direction} deg: off by {off(found, exact):.1e}, with the added mass of the damping "
                  f"{off(found, with_memory):.1e}, the two by {off(with_memory, exact):.1e}")
            self.assertLess(off(found, with_memory), 3e-3)
            self.assertLess(off(found, exact), 1.5e-2)

    def with_memory(self, omega, direction, mass, added_damping):
        """Response of the tanker at a frequency of its files. Its added mass is not that of the file but that
        of an exact convolution: it is computed from the damping, without negative eigenvalues, by the
        relation of Kramers and Kronig."""
        infinite, tables, wave = np.zeros((6, 6)), {}, np.zeros(6, complex)
        C, most = np.zeros((6, 6)), np.zeros(6)
        for line in text_of(self.folder / "tanker", ".1"):
            r = [float(v) for v in line.split()]
            i, j = int(r[1]) - 1, int(r[2]) - 1
            if i == j:
                most[i] = max(most[i], abs(1025 * r[3]))
            if r[0] == 0:
                infinite[i, j] = 1025 * r[3]
            elif r[0] > 0:
                tables.setdefault(2 * np.pi / r[0], np.zeros((6, 6)))[i, j] = 1025 * 2 * np.pi / r[0] * r[4]
        for line in text_of(self.folder / "tanker", ".3"):
            r = [float(v) for v in line.split()]
            if abs(2 * np.pi / r[0] - omega) < 1e-6 * omega and r[1] == direction:
                wave[int(r[2]) - 1] = 1025 * 9.81 * complex(r[5], r[6])
        for line in text_of(self.folder / "tanker", ".hst"):
            i, j, value = line.split()
            C[int(i) - 1, int(j) - 1] = 1025 * 9.81 * float(value)
        omegas = np.array(sorted(tables))
        scale = np.sqrt(np.outer(most, most))
        values, vectors = np.linalg.eigh([0.5 * (tables[w] + tables[w].T) / scale for w in omegas])
        B = scale * np.einsum("kim,km,kjm->kij", vectors, np.maximum(values, 0), vectors)
        at = np.argmin(np.abs(omegas - omega))
        A = 0.5 * (infinite + infinite.T)
        low, before = 0.0, np.zeros((6, 6))
        for w, now in zip(omegas, B):  # B = c + s u between two frequencies
            s = (now - before) / (w - low)
            c = before - s * low
            logs = [np.log(abs(u - omega)) if abs(u - omega) > 1e-9 else 0.0 for u in (low, w)]
            A = A + ((c + s * omega) * (logs[1] - logs[0]) - (c - s * omega) * np.log((w + omega) / (low + omega))) / (np.pi * omega)
            low, before = w, now
        return np.linalg.solve(-(omega**2) * (mass + A) + 1j * omega * (B[at] + added_damping) + C, wave)

    def test_sea(self):
        """The VolturnUS-S in a sea of 46 waves with given phases (JONSWAP of 6 m and 12 s), scaled to a
        fiftieth for a linear response: standard deviations and time series to 1 % of each standard deviation,
        against the sum of the responses to each wave."""
        self.umaine()
        exact = Reference(self.folder / UMAINE, 2.01e7, -2.32, UMAINE_INERTIA, DAMPING, MOORING)
        omegas = 0.25 + 0.05 * np.arange(46)
        peak = 2 * np.pi / 12
        spectrum = omegas**-5 * np.exp(-1.25 * (peak / omegas) ** 4) * 2 ** np.exp(-0.5 * ((omegas / peak - 1) / np.where(omegas > peak, 0.09, 0.07)) ** 2)
        amplitudes = np.sqrt(2 * spectrum / spectrum.sum() * 36 / 16) / 50
        leads = 2 * np.pi * ((np.arange(1, 47) ** 2 * 0.6180339887498949) % 1)
        known = {0: (0.6687388, 0, 0.6517911, 0, 0.005596578, 0), 30: (0.5543132, 0.336473, 0.6407156, 0.003461006, 0.004748015, 0.006616721)}
        for direction, deviations in known.items():
            if not WHOLE and direction == 0:
                continue
            time, found = self.run_case(volturnus(added(DAMPING, MOORING)), 1000, 0.1, waves=sea(omegas, amplitudes, direction, leads, 150))
            use = time > 1000 - 2 * np.pi / 0.05
            for k, column in enumerate(MOTION):
                if not deviations[k]:
                    continue
                answers = [exact.at(w, direction)[k] for w in omegas]
                series = sum((a * X * np.exp(1j * (w * time[use] + p))).real for a, X, w, p in zip(amplitudes, answers, omegas, leads))
                x = found["semi"][column][use]
                worst = np.abs(x - x.mean() - series).max() / series.std()
                print(f"VolturnUS-S in a sea to {direction} deg, {column}: deviation off by {50 * x.std() / deviations[k] - 1:+.1e}, series by {worst:.1e} of it")
                self.assertAlmostEqual(50 * x.std() / deviations[k], 1, delta=0.01)
                self.assertLess(worst, 0.01)

    def difference_forces(self):
        """F_ij of the .12d, N/m² and so on, at the frequencies of the file: F_ji = conj F_ij."""
        rows = [[float(v) for v in line.split()] for line in text_of(self.folder / UMAINE, ".12d")]
        omegas = np.array(sorted({2 * np.pi / r[0] for r in rows}))
        F = np.zeros((len(omegas), len(omegas), 6), complex)
        place = {w: n for n, w in enumerate(omegas)}
        for r in rows:
            i, j, k = place[2 * np.pi / r[0]], place[2 * np.pi / r[1]], int(r[4]) - 1
            F[i, j, k] = 1025 * 9.80665 * complex(r[7], r[8])
            F[j, i, k] = np.conj(F[i, j, k])
        return omegas, F

    def test_slow_drift(self):
        """Mean and slow drift forces of the .12d on the VolturnUS-S, with all pairs and with Newman's roots,
        at the frequencies of the file: 1e-6 of a double sum. The mean force in regular waves equals the
        file's values."""
        self.umaine()
        omegas, F = self.difference_forces()
        for omega, surge, heave in ((0.5, 3411.948, 18955.01), (0.75, 24313.03, 77841.87), (1.6, 128553.7, 4351.441)):
            w = omegas[np.argmin(np.abs(omegas - omega))]
            _, found = self.run_case(volturnus(added(NONE, MOORING) + ", second_order: mean"), waves=sea([w], [1], 0, [0], 10))
            self.assertAlmostEqual(found["semi"]["drift_force_x"][0] / surge, 1, delta=1e-6)
            self.assertAlmostEqual(found["semi"]["drift_force_z"][0] / heave, 1, delta=1e-6)
        use = np.arange(2, 26, 3)
        amplitudes, leads = 1 / (1 + np.arange(len(use))), 2 * np.pi * ((np.arange(len(use)) ** 2 * 0.6180339887) % 1)
        A = amplitudes * np.exp(1j * leads)
        diagonal = np.array([F[n, n].real for n in use])
        roots = np.sqrt(np.abs(diagonal[:, None] * diagonal)) * np.sign(diagonal) * (diagonal[:, None] * diagonal > 0)
        for order, pairs in (("full", F[np.ix_(use, use)]), ("newman", roots)):
            time, found = self.run_case(volturnus(added(NONE, MOORING) + f", second_order: {order}"), 60, 1,
                                        waves=sea(omegas[use], amplitudes, 0, leads, 0))
            turn = A[:, None] * np.exp(1j * np.outer(omegas[use], time))
            exact = np.einsum("it,jt,ijk->tk", turn, turn.conj(), pairs).real
            for k, column in ((0, "drift_force_x"), (2, "drift_force_z")):
                error = np.abs(found["semi"][column] - exact[:, k])[1:].max() / exact[:, k].std()  # the first is static
                print(f"slow drift, {order}, {column}: off by {error:.1e} of its deviation")
                self.assertLess(error, 1e-6)

    def test_drift_of_a_tanker(self):
        """Mean drift forces from pressures (.9), for waves in three directions (1e-6) and in a sea against
        the sum for 2 int S D domega (1 %)."""
        folder = "platforms/mss-tanker/"
        self.files({f"tanker{e}": f"{folder}tanker{e}" for e in (".1", ".3.gz", ".9.gz", ".hst")})
        held = added(NONE, np.diag([1e8, 1e8, 0, 0, 0, 1e12])) + ", symmetry: port_starboard, gravity_in_stiffness: true, second_order: mean"
        ship = ("  semi: {position: [0, 0, 0], floating: {mass: 94620210, centre_of_mass: [3.93, 0, 2.5], inertia: [2.7e10, 3.85e11, 4.16e11], "
                f"hydrodynamics: {{wamit: tanker, follow_period: 0, place: [0, 0, 0], heading_deg: 0 {held}}}}}}}\n")
        how = {"gravity": 9.81, "water": "density: 1025"}
        for period, direction, surge, sway in ((7.86, 120, -129983.312, 773281.907), (9.49, 180, -170439.202, 0.18461), (9.49, 90, -23993.2443, 1333414.64)):
            _, found = self.run_case(ship, waves=sea([2 * np.pi / period], [1], direction, [0], 10), **how)
            for column, exact in (("drift_force_x", surge), ("drift_force_y", sway)):
                self.assertAlmostEqual(found["semi"][column][0], exact, delta=1e-6 * max(abs(surge), abs(sway)))
        # JONSWAP of 3 m and 9 s, for periods from the longest of the file to 4.16 s.
        omega = np.linspace(2 * np.pi / 40.79, 2 * np.pi / 4.16, 400)
        peak = 2 * np.pi / 9
        shape = omega**-5 * np.exp(-1.25 * (peak / omega) ** 4) * 3.3 ** np.exp(-0.5 * ((omega / peak - 1) / np.where(omega > peak, 0.09, 0.07)) ** 2)
        fine = np.linspace(0.1, 30, 200000)
        whole = fine**-5 * np.exp(-1.25 * (peak / fine) ** 4) * 3.3 ** np.exp(-0.5 * ((fine / peak - 1) / np.where(fine > peak, 0.09, 0.07)) ** 2)
        amplitudes = np.sqrt(2 * shape / (whole.sum() * (fine[1] - fine[0])) * 9 / 16 * (omega[1] - omega[0]))
        omega, amplitudes = omega[amplitudes > 1e-9], amplitudes[amplitudes > 1e-9]
        for direction, surge, sway in ((180, -162639.2, 0.0), (150, -170876.5, 290858.8)):
            _, found = self.run_case(ship, waves=sea(omega, amplitudes, direction, 0 * omega, 10), **how)
            print(f"tanker in a sea to {direction} deg: drift off by {found['semi']['drift_force_x'][0] / surge - 1:+.1e}")
            self.assertAlmostEqual(found["semi"]["drift_force_x"][0], surge, delta=0.01 * abs(surge))
            self.assertAlmostEqual(found["semi"]["drift_force_y"][0], sway, delta=0.01 * max(abs(sway), abs(surge)))

    def test_drift_of_a_sphere(self):
        """Mean drift forces from momentum (.8) and over a control surface (.7) equal the files, which begin
        with a line of text."""
        folder = "platforms/drift-sphere/"
        for ending, rows in ((".8", ((2.51328, 0.008229728), (1.848, 0.8765597), (1.0472, 0.6073183))),
                             (".7.gz", ((2.51328, 0.008109339), (1.848, 0.87851), (1.0472, 0.5754058)))):
            stem = f"ball{ending[1]}"
            self.files({f"{stem}{e}": f"{folder}sphere{e}" for e in (".1", ".3", ".hst", ending)})
            ball = ("  ball: {position: [0, 0, 0], floating: {mass: 2094.395, inertia: [1e3, 1e3, 1e3], hydrodynamics: "
                    f"{{wamit: {stem}, second_order: mean {added(NONE, np.diag([1e4, 1e4, 0, 1e4, 1e4, 1e4]))}}}}}}}\n")
            for period, known in rows:
                _, found = self.run_case(ball, water="density: 1000", waves=sea([2 * np.pi / period], [0.2], 0, [0], 10))
                self.assertAlmostEqual(found["ball"]["drift_force_x"][0] / (1000 * 9.80665 * 0.04 * known), 1, delta=1e-6)


if __name__ == "__main__":
    unittest.main()
