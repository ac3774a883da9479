#!/usr/bin/env python3
"""Writes spar.1, spar.3 and spar.hst: the results of a diffraction program for an upright cylinder, in WAMIT's form.

Linear waves about a cylinder of radius a and draught d that stands upright in water of depth h, by matched eigenfunctions
(Garrett 1971, J. Fluid Mech. 46, waves on a cylinder that is held; Yeung 1981, Appl. Ocean Res. 3, waves by its motion). With z
from the bed, b = h - d the gap below it and all of it times exp(i omega t) and cos(m theta):

    below the cylinder   phi = phi_p + sum_n p_n R_n(r) cos(n pi z/b),   R_0 = (r/a)^m, R_n = I_m(n pi r/b)/I_m(n pi a/b)
    around it            phi = phi_I + sum_j q_j S_j(r) Z_j(z),          S_0 = H2_m(k r)/H2_m(k a), S_j = K_m(k_j r)/K_m(k_j a)

Z_0 = cosh(k z) and Z_j = cos(k_j z), each over the root of its mean square; k tanh(k h) = omega²/g = -k_j tan(k_j h). phi_p has
the velocity of the bottom; phi_I = i g/omega cosh(k z)/cosh(k h) exp(-i k x) is the wave. Equal potentials on r = a below the
cylinder, times cos(n pi z/b), and equal velocities over the whole depth, times Z_j, are the equations of p and q. Moments are
about the middle of the waterplane. At infinite frequency phi is zero on the surface: k_j h = (j - 1/2) pi, no wave.
"""
import math
from pathlib import Path

import numpy as np
from scipy import optimize, special

RADIUS, DRAUGHT, DEPTH, GRAVITY = 10.0, 90.0, 200.0, 9.80665  # m, m/s²
OMEGAS = [0.05 * i for i in range(1, 41)] + [2.1 + 0.1 * i for i in range(10)]  # rad/s
HEADINGS = range(0, 360, 30)  # deg
MODES = 160  # of each sum; twice as many change the added mass of heave by 0.3 %, all else by less than 0.1 %


class Cylinder:
    """The functions of z and r at one frequency; omega None: infinite."""

    def __init__(self, m, omega):
        a, h = RADIUS, DEPTH
        self.m, self.b = m, DEPTH - DRAUGHT
        if omega is None:
            self.k, kj = None, (np.arange(MODES) + 0.5) * math.pi / h
        else:
            nu = omega**2 / GRAVITY
            self.k = optimize.brentq(lambda k: k * math.tanh(k * h) - nu, nu * (1 - 1e-12), nu + 2 * math.sqrt(nu / h))
            kj = np.array([optimize.brentq(lambda x: nu * math.cos(x * h) + x * math.sin(x * h), (j - 0.5) * math.pi / h,
                                           j * math.pi / h) for j in range(1, MODES)])
        self.kj = kj
        n = np.arange(MODES)
        self.lam = n * math.pi / self.b
        # z-derivatives and integrals of Z_j over an interval.
        self.norm = np.sqrt(0.5 * (1 + np.sin(2 * kj * h) / (2 * kj * h)))
        x = kj * a
        self.slope = kj * special.kvp(m, x) / special.kv(m, x)  # S_j'(a)
        y = self.lam[1:] * a
        self.R = np.concatenate([[m / a], self.lam[1:] * special.ivp(m, y) / special.iv(m, y)])  # R_n'(a)
        self.L = self.over_gap()
        if self.k is not None:
            x = self.k * a
            outgoing = self.k * special.h2vp(m, x) / special.hankel2(m, x)
            self.slope = np.concatenate([[outgoing], self.slope])

    def sums(self, of_cosh, of_cos):
        """An integral over Z for all j: of cosh(k z) and of cos(k_j z), each over the norm. cosh is taken over cosh(k h)."""
        out = of_cos(self.kj) / self.norm
        if self.k is None:
            return out
        kh = self.k * DEPTH
        mean_square = 0.5 * (1 / math.cosh(kh) ** 2 + math.tanh(kh) / kh)  # of cosh(k z)/cosh(k h)
        return np.concatenate([[of_cosh(self.k) / math.sqrt(mean_square)], out])

    def over_gap(self):
        """L_nj = int_0^b cos(n pi z/b) Z_j dz."""
        b, lam, sign = self.b, self.lam, (-1.0) ** np.arange(MODES)

        def cos_part(k):
            k = k[None, :]
            top = k * np.sin(k * b)
            return sign[:, None] * top / (k**2 - lam[:, None] ** 2)

        rows = cos_part(self.kj) / self.norm[None, :]
        if self.k is None:
            return rows
        k, kh = self.k, self.k * DEPTH
        top = k * hyperbolic(k, b)[1] * sign / (k**2 + lam**2)
        mean_square = 0.5 * (1 / math.cosh(kh) ** 2 + math.tanh(kh) / kh)
        return np.column_stack([top / math.sqrt(mean_square), rows])

    def powers(self, low, high):
        """int Z_j dz and int z Z_j dz from low to high."""
        def at(z):
            flat = self.sums(lambda k: hyperbolic(k, z)[1] / k, lambda k: np.sin(k * z) / k)
            first = self.sums(lambda k: z * hyperbolic(k, z)[1] / k - hyperbolic(k, z)[0] / k**2,
                              lambda k: z * np.sin(k * z) / k + np.cos(k * z) / k**2)
            return flat, first
        (f1, g1), (f0, g0) = at(high), at(low)
        return f1 - f0, g1 - g0

    def squares(self):
        """int_0^b z² Z_j dz."""
        b = self.b
        return self.sums(
            lambda k: (b**2 / k + 2 / k**3) * hyperbolic(k, b)[1] - 2 * b / k**2 * hyperbolic(k, b)[0],
            lambda k: (b**2 / k - 2 / k**3) * np.sin(k * b) + 2 * b / k**2 * np.cos(k * b))

    def solve(self, potential, velocity, wall):
        """p, q from what phi_p (less phi_I) has on r = a: int over the gap of it times cos(n pi z/b), and the known velocities
        int dphi_p/dr Z_j over the gap less int dphi_I/dr Z_j over the depth; `wall` int V Z_j above the gap."""
        eps = np.where(np.arange(MODES) == 0, 1.0, 2.0) / self.b
        carried = (eps * self.R)[:, None] * self.L  # sum_n over it with L^T
        left = np.diag(DEPTH * self.slope) - self.L.T @ carried
        right = velocity + wall - self.L.T @ (eps * self.R * potential)
        q = np.linalg.solve(left, right)
        return eps * (self.L @ q - potential), q

    def below(self, p):
        """int phi r^(m+1) dr under the bottom, without phi_p."""
        a, m, y = RADIUS, self.m, self.lam[1:] * RADIUS
        parts = np.concatenate([[a ** (m + 2) / (2 * m + 2)], a ** (m + 1) / self.lam[1:] * special.iv(m + 1, y) / special.iv(m, y)])
        return np.sum(p * parts * (-1.0) ** np.arange(MODES))


def hyperbolic(k, z):
    """cosh(k z)/cosh(k h), sinh(k z)/cosh(k h), without overflow."""
    up, down, whole = math.exp(k * (z - DEPTH)), math.exp(-k * (z + DEPTH)), 1 + math.exp(-2 * k * DEPTH)
    return (up + down) / whole, (up - down) / whole


def heave(omega):
    """(radiation integral int phi n dS, excitation likewise), about the waterplane's middle; the latter None at infinity."""
    c, a, b = Cylinder(0, omega), RADIUS, DEPTH - DRAUGHT
    n, zero = np.arange(MODES), np.zeros(len(Cylinder(0, omega).slope))
    # phi_p = (z² - r²/2)/(2 b)
    with np.errstate(divide="ignore", invalid="ignore"):
        z2 = np.where(n == 0, b**3 / 3, 2 * b * (-1.0) ** n / c.lam**2)
    one = np.where(n == 0, b, 0.0)
    p, _ = c.solve((z2 - a**2 / 2 * one) / (2 * b), -a / (2 * b) * c.powers(0, b)[0], zero)
    radiation = -2 * math.pi * (c.below(p) + (b**2 * a**2 / 2 - a**4 / 8) / (2 * b))
    return radiation, None if omega is None else -2 * math.pi * c.below(scattered(c, omega)[0])


def scattered(c, omega):
    """p, q of the wave at the cylinder that is held, and phi_I of Z_0 on r = a."""
    factor = (1 if c.m == 0 else 2) * (-1j) ** c.m * 1j * GRAVITY / omega
    x, kh = c.k * RADIUS, c.k * DEPTH
    mean_square = 0.5 * (1 / math.cosh(kh) ** 2 + math.tanh(kh) / kh)
    along = math.sqrt(mean_square) * factor  # phi_I = along J_m(k r) Z_0(z)
    potential = -along * special.jv(c.m, x) * c.L[:, 0]
    velocity = np.zeros(len(c.slope), complex)
    velocity[0] = -along * c.k * special.jvp(c.m, x) * DEPTH
    p, q = c.solve(potential, velocity, np.zeros(len(c.slope)))
    q = q.copy()
    q[0] += along * special.jv(c.m, x)
    return p, q


def across(omega):
    """Radiation integrals of surge and pitch, 2 x 2, and the excitation of both."""
    c, a, b, h = Cylinder(1, omega), RADIUS, DEPTH - DRAUGHT, DEPTH
    n, zero = np.arange(MODES), np.zeros(len(Cylinder(1, omega).slope))
    flat, first = c.powers(b, h)
    arm = first - h * flat  # int (z - h) Z_j over the wall
    with np.errstate(divide="ignore", invalid="ignore"):
        z2 = np.where(n == 0, b**3 / 3, 2 * b * (-1.0) ** n / c.lam**2)
    one = np.where(n == 0, b, 0.0)
    # Pitch: phi_p = -(z² r - r³/4)/(2 b)
    potential = -(z2 * a - a**3 / 4 * one) / (2 * b)
    slope = -(c.squares() - 3 * a**2 / 4 * c.powers(0, b)[0]) / (2 * b)
    own = -(b**2 * a**4 / 4 - a**6 / 24) / (2 * b)
    solutions = [(*c.solve(np.zeros(MODES), zero, flat), 0.0), (*c.solve(potential, slope, arm), own)]
    if omega is not None:
        solutions.append((*scattered(c, omega), 0.0))

    def integrals(p, q, extra):
        return math.pi * np.array([a * flat @ q, a * arm @ q + c.below(p) + extra])
    columns = [integrals(*s) for s in solutions]
    return np.array(columns[:2]).T, None if omega is None else columns[2]


def coefficients(omega):
    """A/rho, B/(rho omega) and X/(rho g), surge, heave, pitch; at infinite frequency A/rho alone."""
    I, X = np.zeros((3, 3), complex), np.zeros(3, complex)
    I[1, 1], heaving = heave(omega)
    sides, pushed = across(omega)
    I[np.ix_([0, 2], [0, 2])] = sides
    if omega is None:
        return -I.real, None, None
    X[1] = 1j * omega / GRAVITY * heaving
    X[[0, 2]] = 1j * omega / GRAVITY * pushed
    return -I.real, I.imag, X


def main():
    folder, surge, heave_, pitch = Path(__file__).resolve().parent, 0, 1, 2
    # Sway and roll are surge and pitch from the side: the moment of a push to y is about -x.
    places = [(1, 1, surge, surge, 1), (2, 2, surge, surge, 1), (3, 3, heave_, heave_, 1), (4, 4, pitch, pitch, 1), (5, 5, pitch, pitch, 1),
              (1, 5, surge, pitch, 1), (5, 1, surge, pitch, 1), (2, 4, surge, pitch, -1), (4, 2, surge, pitch, -1)]
    radiation, waves = [], []
    A = coefficients(None)[0]
    radiation += [f"0 {i} {j} {s * A[p, q]:.6e}" for i, j, p, q, s in places]
    for omega in OMEGAS:
        A, B, X = coefficients(omega)
        period = 2 * math.pi / omega
        radiation += [f"{period:.9g} {i} {j} {s * A[p, q]:.6e} {s * B[p, q]:.6e}" for i, j, p, q, s in places]
        for heading in HEADINGS:
            c, n = math.cos(math.radians(heading)), math.sin(math.radians(heading))
            for mode, value in ((1, c * X[0]), (2, n * X[0]), (3, X[1]), (4, -n * X[2]), (5, c * X[2])):
                if abs(value) > 1e-9 * max(abs(X)):
                    phase = math.degrees(math.atan2(value.imag, value.real))
                    waves.append(f"{period:.9g} {heading} {mode} {abs(value):.4e} {phase:.1f} {value.real:.5e} {value.imag:.5e}")
    volume = math.pi * RADIUS**2 * DRAUGHT
    turning = math.pi * RADIUS**4 / 4 - volume * DRAUGHT / 2  # without the weight
    stiffness = [f"3 3 {math.pi * RADIUS**2:.9g}", f"4 4 {turning:.9g}", f"5 5 {turning:.9g}"]
    for ending, lines in ((".1", radiation), (".3", waves), (".hst", stiffness)):
        (folder / f"spar{ending}").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
