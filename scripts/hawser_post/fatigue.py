"""Fatigue of lines: cycles of tension or stress by the rainflow method, and damage by published curves."""
from dataclasses import dataclass

import numpy as np

from . import stress
from .results import Refusal
from .statistics import upcrossings

YEAR = 365.25 * 24 * 3600.0  # s
PLACES = 16  # around the circumference of a pipe


def turning_points(x):
    """Turning points of a signal, including its ends."""
    x = np.asarray(x, float)
    x = x[np.concatenate([[True], np.diff(x) != 0])]
    if len(x) < 3:
        return x
    turns = np.flatnonzero((np.diff(x)[:-1] > 0) != (np.diff(x)[1:] > 0)) + 1
    return x[np.concatenate([[0], turns, [len(x) - 1]])]


def rainflow(x):
    """Cycles of a signal: ranges, means and counts (1 or 1/2), by ASTM E1049-85 (2017), section 5.4.4."""
    cycles, points = [], []
    for value in turning_points(x):
        points.append(value)
        while len(points) >= 3:
            last, before = abs(points[-1] - points[-2]), abs(points[-2] - points[-3])
            if last < before:
                break
            if len(points) == 3:  # includes the start of the history: half a cycle
                cycles.append((before, (points[0] + points[1]) / 2, 0.5))
                points.pop(0)
            else:
                cycles.append((before, (points[-2] + points[-3]) / 2, 1.0))
                del points[-3:-1]
    cycles += [(abs(b - a), (a + b) / 2, 0.5) for a, b in zip(points, points[1:])]
    return np.array(cycles).reshape(-1, 3).T


@dataclass(frozen=True)
class Curve:
    """Fatigue curve: N cycles to failure at range s, N = a s^-m, with another a and m beyond `knee` cycles."""
    source: str
    of: str  # tension: range over breaking load, of chain that of ORQ chain (strength.py); area: nominal stress [MPa] of the rope or chain; pipe: of the wall
    log_a: float
    m: float
    log_a2: float = 0.0
    m2: float = 0.0
    knee: float = np.inf
    by_mean: float = 0.0  # decrease of log_a per mean tension over breaking load

    def cycles(self, ranges, mean=0.0):
        with np.errstate(divide="ignore"):
            first = 10 ** (self.log_a - self.by_mean * mean) * np.power(ranges, -self.m)
            if self.m2 == 0:
                return first
            return np.where(first <= self.knee, first, 10**self.log_a2 * np.power(ranges, -self.m2))


API, E301, C203 = "API RP 2SK (2005), T-N curves", "DNV-OS-E301 (2018), S-N curves", "DNV-RP-C203 (2016), S-N curves"
CURVES = {
    "api-studlink-chain": Curve(API, "tension", 3.0, 3.0),
    "api-studless-chain": Curve(API, "tension", np.log10(316), 3.0),
    "api-strand-rope": Curve(API, "tension", 3.20, 4.09, by_mean=2.79),
    "api-spiral-rope": Curve(API, "tension", 3.25, 5.05, by_mean=3.43),
    "dnv-stud-chain": Curve(E301, "area", np.log10(1.2e11), 3.0),
    "dnv-studless-chain": Curve(E301, "area", np.log10(6.0e10), 3.0),
    "dnv-strand-rope": Curve(E301, "area", np.log10(3.4e14), 4.0),
    "dnv-spiral-rope": Curve(E301, "area", np.log10(1.7e17), 4.8),
    "dnv-d-air": Curve(C203 + " in air", "pipe", 12.164, 3.0, 15.606, 5.0, 1e7),
    "dnv-f1-air": Curve(C203 + " in air", "pipe", 11.699, 3.0, 14.832, 5.0, 1e7),
    "dnv-f3-air": Curve(C203 + " in air", "pipe", 11.546, 3.0, 14.576, 5.0, 1e7),
    "dnv-d-seawater-cp": Curve(C203 + " in seawater with cathodic protection", "pipe", 11.764, 3.0, 15.606, 5.0, 1e6),
    "dnv-f1-seawater-cp": Curve(C203 + " in seawater with cathodic protection", "pipe", 11.299, 3.0, 14.832, 5.0, 1e6),
    "dnv-f3-seawater-cp": Curve(C203 + " in seawater with cathodic protection", "pipe", 11.146, 3.0, 14.576, 5.0, 1e6),
}


def damage(signal, curve):
    """Miner's sum over the cycles of a signal in the unit of the curve: tension over breaking load, or MPa."""
    ranges, _, counts = rainflow(signal)
    keep = ranges > 0
    return float(np.sum(counts[keep] / curve.cycles(ranges[keep], np.mean(signal))))


def wall_stress(tension, moment_2, moment_3, wall):
    """Stress [MPa] in the outer fibre of a pipe (stress.Wall) at PLACES angles from axis 2: times x nodes -> times x
    nodes x places."""
    angle = np.arange(PLACES) * 2 * np.pi / PLACES
    # The outer fibre is at y2 = r cos, y3 = r sin; N/A + (M2 y3 - M3 y2)/I.
    moment = moment_2[..., None] * np.sin(angle) - moment_3[..., None] * np.cos(angle)
    return 1e-6 * ((tension / wall.area)[..., None] + moment * np.atleast_1d(wall.outer / (2 * wall.inertia))[:, None])


def along(results, line, curve, since, breaking_load=None, area=None, outer=None, wall=None, factor=1.0):
    """Damage per second at each node of a line (rows; NaN where a pipe curve meets no pipe) and place around it
    (columns; one except for pipes), over the outputs from `since` on. Damage of several sea states adds place by
    place. breaking_load [N], area [m²]: at each node, NaN where the curve is for another kind of line; outer, wall:
    of a pipe [m], None: from the case, with the larger damage between two pipes."""
    keep = results.time >= since
    if np.count_nonzero(keep) < 16:
        raise Refusal(f"{results.path}: {np.count_nonzero(keep)} outputs from t = {since:g} s on are too few to count cycles")
    seconds = results.time[keep][-1] - results.time[keep][0]
    if curve.of == "pipe":
        if not results.has("bending_moment_2"):
            raise Refusal(f"{results.path}: there is no bending moment, as all lines are cables")
        moments = [results.field(f"bending_moment_{k}", line)[keep] for k in (2, 3)]
        sums = np.full((len(line.arc), PLACES), np.nan)
        known = []  # both sides of a node are usually equal
        for own, tension, _, _ in stress.walls_along(results, line, outer, wall):
            around = factor * wall_stress(tension[keep], *moments, own)
            for n in range(len(line.arc)):
                if np.isfinite(around[:, n]).all() and not any(np.array_equal(around[:, n], k[:, n]) for k in known):
                    sums[n] = np.fmax(sums[n], [damage(around[:, n, p], curve) for p in range(PLACES)])
            known.append(around)
        return sums / seconds
    tension = results.field("effective_tension", line)[keep] * factor
    if curve.of == "area":
        tension = 1e-6 * tension / area
    else:
        tension = tension / breaking_load
    return np.array([[damage(x, curve)] if np.isfinite(x).all() else [np.nan] for x in tension.T]) / seconds


def outputs_a_period(results, line, since):
    """Outputs per mean period of tension at the end with the larger one; with fewer than ten, cycles are truncated."""
    keep = results.time >= since
    tension = results.field("effective_tension", line)[keep]
    up = upcrossings(results.time[keep], tension[:, 0 if tension[:, 0].max() > tension[:, -1].max() else -1])
    if len(up) < 2:
        return np.inf
    return (up[-1] - up[0]) / (len(up) - 1) / np.median(np.diff(results.time[keep]))
