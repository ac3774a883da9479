"""The VolturnUS-S with third-party coefficients (skipped if missing) against computations from its files by other
means: decay of yaw, periods and damping ratios, retardation functions and a public state-space fit of these."""
import csv
import re
import unittest

import numpy as np
import scipy.linalg
from support import run
from test_platform_references import DAMPING, HAWSER, MOORING, MOTION, NONE, UMAINE, PlatformRuns, added, volturnus
from test_rao import text_of

DENSITY, GRAVITY = 1025, 9.80665
MASS, CENTRE = 2.01e7, -2.32
STATES = "platforms/volturnus-wamit/IEA-15-240-RWT-UMaineSemi.ss"
# Period 2 pi/Im lambda and -Re lambda/|lambda| of the modes by the largest freedom, free and moored with damping: the complex
# eigenvalues of lambda² (M + A) + lambda (B + D) + C with A and B at |Im lambda|, as computed from the files without this program.
FREE = {3: (20.5522723, 1.68116818e-4), 4: (28.4315405, 1.28590545e-5), 5: (28.4326431, 1.28530284e-5)}
MOORED = {1: (135.04524, 0.0532156229), 2: (135.045379, 0.0532155206), 3: (20.4423728, 0.0500483889), 4: (27.104697, 0.0503334978),
          5: (27.1056352, 0.0503358892), 6: (88.1476114, 1.29369509e-9)}
# Of the public fit: R2 of K over 60 s, K(0) relative to that of the files.
FIT = {(1, 1): (0.9823238, 0.9835365), (2, 2): (0.982325, 0.9834971), (3, 3): (0.9915477, 1.107571), (4, 4): (0.9799997, 1.247933),
       (5, 5): (0.9799994, 1.247904), (6, 6): (0.9888797, 0.9678338), (1, 5): (0.9771256, 1.215339), (2, 4): (0.977159, 1.215115)}


class Coefficients:
    """Matrices of the files about the origin, symmetric and linear in omega between the rows."""

    def __init__(self, stem):
        rows = [[float(v) for v in line.split()] for line in text_of(stem, ".1")]
        self.omega = np.array([0.0] + sorted({2 * np.pi / r[0] for r in rows if r[0] > 0}))
        self.A, self.B, self.infinite = np.zeros((len(self.omega), 6, 6)), np.zeros((len(self.omega), 6, 6)), np.zeros((6, 6))
        for r in rows:
            i, j = int(r[1]) - 1, int(r[2]) - 1
            if r[0] == 0:
                self.infinite[i, j] = DENSITY * r[3]
                continue
            n = np.argmin(np.abs(self.omega - (2 * np.pi / r[0] if r[0] > 0 else 0)))
            self.A[n, i, j] = DENSITY * r[3]
            self.B[n, i, j] = DENSITY * self.omega[n] * r[4] if r[0] > 0 else 0
        self.A, self.B = (0.5 * (of + of.transpose(0, 2, 1)) for of in (self.A, self.B))
        self.infinite = 0.5 * (self.infinite + self.infinite.T)
        self.M = np.diag([MASS, MASS, MASS, 4.26e10, 4.26e10, 2.37e10])
        self.M[0, 4] = self.M[4, 0] = -4.66e7
        self.M[1, 3] = self.M[3, 1] = 4.66e7
        self.C = np.zeros((6, 6))
        for line in text_of(stem, ".hst"):
            i, j, value = line.split()
            if {int(i), int(j)} not in ({4, 6}, {5, 6}):
                self.C[int(i) - 1, int(j) - 1] += DENSITY * GRAVITY * float(value)
        self.C = 0.5 * (self.C + self.C.T)
        self.C[3, 3] -= MASS * GRAVITY * CENTRE
        self.C[4, 4] -= MASS * GRAVITY * CENTRE

    def at(self, omega):
        n = np.clip(np.searchsorted(self.omega, omega), 1, len(self.omega) - 1)
        s = (omega - self.omega[n - 1]) / (self.omega[n] - self.omega[n - 1])
        return [(1 - s) * of[n - 1] + s * of[n] for of in (self.A, self.B)]

    def modes(self, stiffness, damping):
        """lambda of [lambda² (M + A) + lambda (B + damping) + C] v = 0 by the largest freedom from 1, with A
        and B at Im lambda."""
        found = {}
        for freedom in range(6):
            omega = 0.2
            for _ in range(100):
                A, B = self.at(omega)
                M = self.M + A
                first = np.block([[np.zeros((6, 6)), np.eye(6)], [-np.linalg.solve(M, self.C + stiffness), -np.linalg.solve(M, B + damping)]])
                values, vectors = np.linalg.eig(first)
                # Translations and rotations in one measure: the kinetic energy of each freedom.
                energy = np.abs(vectors[:6]) ** 2 * np.diag(M)[:, None]
                share = np.where(values.imag > 1e-6, energy[freedom] / energy.sum(axis=0), 0)
                if not share.max() > 0.3:
                    break
                root = values[np.argmax(share)]
                if abs(root.imag - omega) < 1e-13:
                    found[freedom + 1] = root
                    break
                omega = root.imag
        return found

    def memory(self, s):
        """Laplace transform of K: (2/pi) int B(u) s/(s² + u²) du, at several s [1/s]."""
        sum_ = np.zeros((len(s), 6, 6), complex)
        for k in range(len(self.omega) - 1):
            a, b = self.omega[k], self.omega[k + 1]
            slope = (self.B[k + 1] - self.B[k]) / (b - a)
            base = self.B[k] - slope * a
            angle = np.arctan(b / s) - np.arctan(a / s)
            logs = 0.5 * s * (np.log(s**2 + b**2) - np.log(s**2 + a**2))
            sum_ += angle[:, None, None] * base + logs[:, None, None] * slope
        return 2 / np.pi * sum_

    def decay(self, start, stiffness, damping, time, period=1500.0, highest=40.0):
        """Free motion from rest at `start`: Fourier series of the Laplace transform on a line to the right of
        the imaginary axis, without the step start/s."""
        shift = 14 / period  # aliases are below exp(-28)
        s = shift + 1j * np.pi / period * np.arange(int(highest * period / np.pi))
        memory, M = self.memory(s), self.M + self.infinite
        column = s[:, None, None]
        resistance = column * M + memory + damping
        moved = np.linalg.solve(column * resistance + self.C + stiffness, resistance @ np.asarray(start, float)[:, None])[:, :, 0]
        moved -= np.asarray(start) / s[:, None]
        moved[0] *= 0.5
        waves = np.exp(1j * np.outer(np.asarray(time), s.imag))
        return np.asarray(start) + (np.exp(shift * np.asarray(time)) / period)[:, None] * (waves @ moved).real

    def retardation(self, time):
        """K = (2/pi) int B cos(omega t) domega."""
        K = np.zeros((len(time), 6, 6))
        a, b = self.omega[:-1], self.omega[1:]
        slope = np.diff(self.B, axis=0) / (b - a)[:, None, None]
        last, end = self.B[-1], self.omega[-1]
        for n, t in enumerate(time):
            if t == 0:
                K[n] = (0.5 * (self.B[1:] + self.B[:-1]) * (b - a)[:, None, None]).sum(axis=0)
            else:
                K[n] = last * np.sin(end * t) / t + (slope * ((np.cos(b * t) - np.cos(a * t)) / t**2)[:, None, None]).sum(axis=0)
        return 2 / np.pi * K


class VolturnUS(PlatformRuns):
    def setUp(self):
        super().setUp()
        self.umaine()
        self.of_files = Coefficients(self.folder / UMAINE)

    def test_decay_of_yaw(self):
        """Moored yaw from 3 deg over 600 s, seven periods: 1e-3 of the start. The same inverse transform
        yields known values of the moored decay of pitch."""
        pitch = self.of_files.decay([0, 0, 0, 0, 0.0523598776, 0], MOORING, DAMPING, (5, 25, 105))
        np.testing.assert_allclose(pitch[:, 4], (0.0220758586, 0.03352881, 0.01020582), atol=1e-6 * 0.05)
        start = np.radians(3)
        time = np.arange(0, 601, 2.5)
        exact = self.of_files.decay([0, 0, 0, 0, 0, start], MOORING, DAMPING, time)[:, 5]
        for step in (0.05, 0.2):
            at, found = self.run_case(volturnus(added(DAMPING, MOORING), turn=(0, 0, start)), 600, step)
            self.decay(f"moored yaw of the VolturnUS-S, steps of {step} s", list(zip(time, exact)), start, at, found["semi"]["rotation_vector_z"], 1e-3)
            others = max(np.abs(found["semi"][column]).max() for column in MOTION[:5])
            self.assertLess(others, 1e-3 * start)

    def test_modes(self):
        """`hawser modes` has the undamped period T sqrt(1 - zeta²): 0.05 %. Its damping ratio is that of the
        undamped shape: 0.5 % and 1e-5, of modes with a coupled damping."""
        for what, bodies, stiffness, damping, known in (("free", volturnus(""), NONE, NONE, FREE),
                                                        ("moored", volturnus(added(DAMPING, MOORING)), MOORING, DAMPING, MOORED)):
            roots = self.of_files.modes(stiffness, damping)
            self.assertEqual(sorted(roots), sorted(known))
            for freedom, (period, zeta) in known.items():
                root = roots[freedom]
                self.assertAlmostEqual(2 * np.pi / root.imag / period, 1, delta=1e-7)
                self.assertAlmostEqual(-root.real / abs(root), zeta, delta=1e-6 * zeta + 1e-9)
            self.case(bodies)
            done = run(HAWSER, "modes", "case.yaml", "-n", "6", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            found = sorted(tuple(map(float, row)) for row in re.findall(r"^ *\d+ +([\d.]+) +\S+ +([\d.e+-]+) ", done.stdout, re.M))
            exact = sorted((2 * np.pi / abs(root), -root.real / abs(root)) for root in roots.values())
            self.assertEqual(len(found), len(exact), done.stdout)
            periods = [a / b - 1 for (a, _), (b, _) in zip(found, exact)]
            ratios = [(a - b) / (b + 1e-9) for (_, a), (_, b) in zip(found, exact)]
            print(f"{what} VolturnUS-S: periods off by {np.abs(periods).max():.1e}; damping ratios by", ", ".join(f"{r:+.1e}" for r in ratios))
            for (a, found_ratio), (b, exact_ratio) in zip(found, exact):
                self.assertAlmostEqual(a / b, 1, delta=5e-4)
                self.assertAlmostEqual(found_ratio, exact_ratio, delta=5e-3 * exact_ratio + 1e-5)

    def test_memory(self):
        """Retardation functions of `hawser check --radiation` against exact integrals over the files: R2 above
        0.9995 for each entry above 1 % of its diagonal ones, and their integral, which is B(0), below 0.1 % of
        the largest B. A public state-space fit has the known R2 and K(0) against them, to 0.002 and 0.5 %."""
        self.case(volturnus(""))
        done = run(HAWSER, "check", "case.yaml", "--quick", "--radiation", "r.csv", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with open(self.folder / "r.csv", newline="") as file:
            rows = list(csv.reader(file))
        names = rows[0][2:]
        table = np.array([[float(x) for x in r[1:]] for r in rows[1:] if r[0] == "retardation"])
        freedoms = ("surge", "sway", "heave", "roll", "pitch", "yaw")
        time = np.arange(0, 60.05, 0.2)
        exact, largest = self.of_files.retardation(time), np.abs(self.of_files.B).max(axis=0)
        found, worst, at_rest = {}, 1, 0
        for i in range(6):
            for j in range(i, 6):
                if largest[i, j] < 0.01 * np.sqrt(largest[i, i] * largest[j, j]):
                    continue
                K = table[:, 1 + names.index(f"{freedoms[i]}-{freedoms[j]}")]
                found[i + 1, j + 1] = np.interp(time, table[:, 0], K)
                off = 1 - ((found[i + 1, j + 1] - exact[:, i, j]) ** 2).sum() / (exact[:, i, j] ** 2).sum()
                worst = min(worst, off)
                at_rest = max(at_rest, abs(np.sum(0.5 * (K[1:] + K[:-1]) * np.diff(table[:, 0]))) / largest[i, j])
        print(f"VolturnUS-S: {len(found)} retardation functions, R2 at least {worst:.6f}; B(0) at most {at_rest:.1e} of the largest B")
        self.assertGreater(worst, 0.9995)
        self.assertLess(at_rest, 0.001)
        self.files({"fit.ss": STATES})
        numbers = [[float(v) for v in line.split()] for line in (self.folder / "fit.ss").read_text().splitlines()[4:] if line.strip()]
        A, B, C = (np.array(numbers[a:b]) for a, b in ((0, 60), (60, 120), (120, 126)))
        advance, state, fit = scipy.linalg.expm(0.2 * A), B, []
        for _ in time:
            fit.append(-C @ state)  # the fit has the opposite sign
            state = advance @ state
        for (i, j), (quality, start) in FIT.items():
            K, of_fit = found[i, j], np.array([f[i - 1, j - 1] for f in fit])
            R2 = 1 - ((of_fit - K) ** 2).sum() / ((K - K.mean()) ** 2).sum()
            print(f"public fit of K{i}{j}: R2 {R2:.6f} ({quality}), K(0) {of_fit[0] / K[0]:.5f} ({start})")
            self.assertAlmostEqual(R2, quality, delta=2e-3)
            self.assertAlmostEqual(of_fit[0] / K[0], start, delta=5e-3 * start)


if __name__ == "__main__":
    unittest.main()
