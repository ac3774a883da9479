"""Reference cases of cables and mooring lines (tests/data/cables) against OrcaFlex and closed forms.

References and acceptance limits are those of the validation record of CableDyn 0.1.1 (SMI-Lab-Inha/CableDyn,
Apache-2.0, VALIDATION.md), with its names of the cases; docs/verification-cables.md explains them and the
differences."""
import array
import math
import os
import re
import shutil
import tempfile
import unittest
from pathlib import Path

from support import ROOT, run

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
CASES = ROOT / "tests" / "data" / "cables"

# Reference and relative acceptance limit. Tensions [N] at the upper end unless stated otherwise; curvatures
# [1/m].
HEAVE = ("static curvature", "curvature", "amplification", "mean", "least", "largest")
REFERENCES = {
    "L3-2": {"mean": (998148.769, 0.02), "swing": (7881.653, 0.15)},
    # Acceptance: the difference of CableDyn.
    "L3-4": {"lower end": (11772.68, 0.0322), "upper end": (21794.491, 0.0167), "curvature": (0.017511018, 0.0086)},
    # Acceptance: not given; that of the same cable in L3-6d is used.
    "L3-5-80": {"tension": (9320, 0.02), "curvature": (0.0968, 0.03)},
    "L3-6-80": dict(zip(HEAVE, zip((0.09643, 0.10279, 1.0659, 9321.0, 5634.2, 13080.6),
                                   (0.02, 0.015, 0.015, 0.01, 0.015, 0.01)))),
    "L3-6-800": dict(zip(HEAVE, zip((0.02639, 0.03881, 1.4707, 57787.6, 33241.3, 82963.2),
                                    (0.03, 0.015, 0.015, 0.01, 0.015, 0.01)))),
    "L3-6a": {"mean": (9468.01785888602, 0.001), "least": (8299.565718788563, 0.001),
              "largest": (10636.46999898334, 0.001), "swing": (2336.904280194778, 0.001)},
    "L3-6c": dict(zip(HEAVE, zip((0.09643, 0.10254, 0.10254 / 0.09643, 9307.2, 9225.3, 9387.6),
                                 (0.02, 0.02, 0.02, 0.01, 0.01, 0.01))),
                  **{"rise of curvature": (0.10254 - 0.09643, 0.15), "range": (9387.6 - 9225.3, 0.1)}),
    "L3-6d": dict(zip(HEAVE, zip((0.09676, 0.10321, 0.10321 / 0.09676, 9332.1, 5651.3, 13087.6),
                                 (0.03, 0.03, 0.03, 0.02, 0.03, 0.02))),
                  **{"curvature at touchdown": (0.08451, 0.05)}),
    # Acceptance: not given.
    "L3-7": {"static": (2427011, 0.01), "mean": (2439385, 0.01), "deviation": (206079, 0.01), "least": (2057857, 0.01),
             "largest": (2850911, 0.01), "90 s": (228569, 0.01), "12 s": (178796, 0.01)},
    "L4-1c-200": dict(zip(HEAVE, zip((0.0831, 0.08789, 1.0577, 25134.1, 23698.7, 26267.3),
                                     (0.02, 0.02, 0.02, 0.015, 0.015, 0.015)))),
    # F = M cos a/r - EI cos²a sin a/r², K = EI cos³a/r + M sin a. Acceptance: not given.
    "T-7": {"axial force": (0.0580127019, 0.01), "axial couple": (0.8995190528, 0.001)},
}

# Turns: torque, N m; largest curvature; lateral deflection, m; tension. Acceptance: not given.
TWISTED = {0: (0, 0.09684767, 0, 9317.6156), 1: (1765.406, 0.09721875, 1.671157, 9326.347),
           2: (3536.056, 0.09849395, 3.222998, 9351.198), 3: (5313.974, 0.1013181, 4.591115, 9389.006),
           4: (7097.222, 0.10703801, 5.77093, 9436.854), 5: (8879.083, 0.11963718, 6.788001, 9493.106)}
TWISTED_ACCEPTANCES = (0.01, 0.01, 0.02, 0.01)


class Results:
    """A results file read by h5dump. Times in s, arc lengths in m from end A, the upper end in every case."""

    def __init__(self, path):
        self.path = path
        self.time = self.read("/outputs/time")
        self.arc = self.read("/nodes/arc_length")

    def read(self, name):
        """A data set of numbers in double precision."""
        raw = self.path.with_suffix(".raw")
        result = run("h5dump", "-d", name, "-b", "LE", "-o", raw, self.path)
        if result.returncode:
            raise RuntimeError(result.stdout + result.stderr)
        return array.array("d", raw.read_bytes())

    def tension(self, start=0.0):
        """Times and effective tensions of the history "top" at every step from a time on."""
        head = run("h5dump", "-a", "/series/top/columns", self.path).stdout.replace("\\000", "")
        columns = re.findall(r'"(\w+)"', head[head.index("DATA {"):])
        values = self.read("/series/top")[columns.index("effective_tension")::len(columns)]
        return zip(*((t, v) for t, v in zip(self.read("/series/time"), values) if t > start - 1e-6))

    def rows(self, name, components=1):
        """(time, field by nodes) of every output."""
        values, width = self.read(f"/fields/{name}"), len(self.arc) * components
        return [(t, values[i * width:(i + 1) * width]) for i, t in enumerate(self.time)]

    def bend(self, start=0.0, stop=math.inf, low=0.0, high=math.inf):
        """Largest curvature in a range of times and arc lengths."""
        return max(k for t, row in self.rows("curvature") if start - 1e-6 < t < stop + 1e-6
                   for s, k in zip(self.arc, row) if low <= s <= high)

    def touchdown(self, z):
        """Arc length at which the axis is within half a diameter and 2 cm of the bed, for the cable in 80 m."""
        level = -80 + 0.08 + 0.02
        i = next(i for i, s in enumerate(self.arc) if s > 118.114 and z[i] < level)
        return self.arc[i] - (self.arc[i] - self.arc[i - 1]) * (level - z[i]) / (z[i - 1] - z[i])

    def end_force(self, end):
        """Magnitude of the static force at end 0 (A) or 1 (B)."""
        return math.hypot(*self.read("/ends/force")[3 * end:3 * end + 3])


def extremes(times, values):
    """Mean over time by the trapezoidal rule, least and largest."""
    area = sum((b - a) * (u + v) / 2 for a, b, u, v in zip(times, times[1:], values, values[1:]))
    return area / (times[-1] - times[0]), min(values), max(values)


def amplitude(times, values, period, start):
    """Amplitude of the Fourier component over whole periods from a time on; equal steps."""
    rows = [(2 * math.pi * t / period, v) for t, v in zip(times, values) if t > start + 1e-6]
    return 2 / len(rows) * math.hypot(*(sum(v * f(phase) for phase, v in rows) for f in (math.cos, math.sin)))


class Cables(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def solve(self, name):
        """Results of a case."""
        target = self.folder / f"{name}.h5"
        result = run(HAWSER, "run", CASES / f"{name}.yaml", "-q", "-o", target, timeout=300)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return Results(target)

    def near(self, name, key, measured, reference, acceptance):
        difference = measured / reference - 1
        print(f"  {name:10} {key:24} {reference:13.7g} {measured:13.7g} {100 * difference:+8.3f} % of {100 * acceptance:.3g} %")
        with self.subTest(case=name, quantity=key):
            self.assertLess(abs(difference), acceptance)

    def compare(self, name, **measured):
        references = REFERENCES[name]
        measured = {key.replace("_", " "): value for key, value in measured.items()}
        self.assertEqual(set(measured), set(references))
        for key, (reference, acceptance) in references.items():
            self.near(name, key, measured[key], reference, acceptance)

    def compare_moved(self, name, start, stop, **more):
        """Lazy-wave cable excited by its upper end or the sea."""
        results = more.pop("results", None) or self.solve(name)
        static, moved = results.bend(stop=0), results.bend(start, stop)
        mean, least, largest = extremes(*results.tension(start))
        self.compare(name, static_curvature=static, curvature=moved, amplification=moved / static, mean=mean, least=least,
                     largest=largest, **more)

    def test_chain_in_a_wave(self):
        mean, least, largest = extremes(*self.solve("L3-2").tension(56))
        self.compare("L3-2", mean=mean, swing=largest - least)

    def test_stiff_line_touching_down(self):
        results = self.solve("L3-4")
        # Beyond 105 m it bends down to its lower end, half a diameter below the rest position.
        self.compare("L3-4", upper_end=results.end_force(0), lower_end=results.end_force(1), curvature=results.bend(high=105))

    def test_lazy_wave_at_rest(self):
        results = self.solve("L3-5-80")
        length = results.arc[-1]
        self.compare("L3-5-80", tension=results.end_force(0), curvature=results.bend(low=0.03 * length, high=0.97 * length))

    def test_lazy_wave_in_heave(self):
        self.compare_moved("L3-6-80", 24, 60)

    def test_long_lazy_wave_in_heave(self):
        self.compare_moved("L3-6-800", 24, 60)

    def test_axial_drag(self):
        mean, least, largest = extremes(*self.solve("L3-6a").tension(24))
        self.compare("L3-6a", mean=mean, least=least, largest=largest, swing=largest - least)

    def test_lazy_wave_in_a_sea(self):
        results = self.solve("L3-6c")
        _, least, largest = extremes(*results.tension(24))
        self.compare_moved("L3-6c", 24, 144, results=results, range=largest - least,
                           rise_of_curvature=results.bend(24, 144) - results.bend(stop=0))

    def test_moving_touchdown(self):
        results = self.solve("L3-6d")
        self.compare_moved("L3-6d", 24, 60, results=results,
                           curvature_at_touchdown=results.bend(24, 60, low=135.48 - 25, high=135.48 + 25))
        down = [(t, results.touchdown(row[2::3])) for t, row in results.rows("position", 3)]
        moved = [s for t, s in down if t > 24 - 1e-6]
        for key, reference, measured in [("at rest", 135.48, down[0][1]), ("least", 134.48, min(moved)),
                                         ("largest", 137.48, max(moved))]:
            print(f"  L3-6d      touchdown {key:14} {reference:13.7g} {measured:13.7g} m")
            self.assertAlmostEqual(measured, reference, delta=1.5, msg=key)

    def test_an_hour_of_a_mooring_line(self):
        results = self.solve("L3-7")
        times, values = results.tension(200)
        mean, least, largest = extremes(times, values)
        deviation = math.sqrt(extremes(times, [(v - mean) ** 2 for v in values])[0])
        self.compare("L3-7", static=results.end_force(0), mean=mean, deviation=deviation, least=least, largest=largest,
                     **{"90_s": amplitude(times, values, 90, 270), "12_s": amplitude(times, values, 12, 204)})

    def test_lazy_wave_under_a_floater(self):
        """The motion table is the sum of the harmonics in its header."""
        lines = (CASES / "L4-1c-200.txt").read_text("utf-8").splitlines()
        numbers = [[float(x) for x in line.strip("# ").split()] for line in lines if re.match(r"[# ]*\d", line)]
        harmonics, rows = [n for n in numbers if len(n) == 5], [n for n in numbers if len(n) == 4]
        self.assertEqual((len(harmonics), len(rows)), (16, 401))
        for t, x, y, z in rows:
            surge, heave = (sum(h[k] * math.cos(2 * math.pi * t / h[0] + math.radians(h[k + 1])) for h in harmonics)
                            for k in (1, 3))
            self.assertLess(max(abs(x - surge), abs(y), abs(z - heave)), 2e-6, t)
        self.compare_moved("L4-1c-200", 100, 200)

    def test_twisted_lazy_wave(self):
        results = self.solve("T-6")
        twist, bend, tension = (results.rows(name) for name in ("torsion_moment", "curvature", "effective_tension"))
        places = results.rows("position", 3)
        for turns, references in TWISTED.items():
            i = 2 + 3 * turns  # an output every 100 s: one with a turn, then two without
            self.assertAlmostEqual(results.time[i], 200 + 300 * turns)
            measured = abs(twist[i][1][0]), max(bend[i][1]), max(map(abs, places[i][1][1::3])), tension[i][1][0]
            for key, value, reference, acceptance in zip(("torque", "curvature", "sideways", "tension"), measured, references,
                                                         TWISTED_ACCEPTANCES):
                if reference > 0:
                    self.near("T-6", f"{key}, {turns} turns", value, reference, acceptance)
                else:
                    self.assertLess(value, 1e-3, (turns, key))

    def test_helix(self):
        results = self.solve("T-7")
        places = results.rows("position", 3)[-1][1]
        for x, y in zip(places[0::3], places[1::3]):
            self.assertAlmostEqual(math.hypot(x, y), 1, delta=1e-3)
        force, moment, (x, y, _) = results.read("/ends/force")[-3:], results.read("/ends/moment")[-3:], places[-3:]
        self.compare("T-7", axial_force=-force[2], axial_couple=-(moment[2] + x * force[1] - y * force[0]))


if __name__ == "__main__":
    unittest.main()
