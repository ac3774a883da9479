"""Default automatic steps in ten kinds of motion, against runs with a fifth of their longest step: largest tension,
standard deviation, and no tension that alternates between steps (saw teeth).

The reference is the same program with shorter steps, so only the step length is tested. The last case takes long and
runs only with HAWSER_FULL in the environment."""
import bisect
import math
import os
import re
import shutil
import tempfile
import unittest
from pathlib import Path

from support import ROOT, run, write
from test_cables import CASES, Results, extremes

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
APART = 0.005  # of the largest tension and of the deviation
SAW = 0.02  # fraction of the deviation: root mean square of second differences, beyond 1.2 times that of the reference at the same times


def rows(every, duration, of_time):
    """Rows of a table."""
    return "[" + ", ".join("[" + ", ".join(f"{x:.6g}" for x in (i * every, *of_time(i * every))) + "]"
                           for i in range(int(duration / every) + 1)) + "]"


def wave(amplitude, period, phase=0.0):
    return lambda t: amplitude * math.sin(2 * math.pi * t / period + phase)


SLOW, FAST = wave(2, 40), wave(0.8, 9)
# A taut chain whose lower end lies on the bed; with its anchor half a diameter lower the tension would snap
# in the sea of `test_responses_in_a_sea`.
CHAIN = """\
hawser: 1
environment:
  water: {depth: 50}
  seabed: {depth: 50, friction: 0.5}
ENVIRONMENT
line_types:
  chain: {outer_diameter: 0.252, mass_per_length: 390, EA: 1.674 GN, bending: false, Cd_normal: 1.37}
bodies:
  vessel: {MOTION}
lines:
  chain:
    sections: [{type: chain, length: 130.72, elements: 24}]
    end_a: {anchor: [120, 0, -49.874]}
    end_b: {body: vessel, at: [AT]}
contact: {between_lines: false}
dynamics: {duration: DURATION}
output: {every: 1, histories: [{line: chain, at: end_b, name: top}]}
"""
# Bare pipe, a buoyant part and bare pipe, from a vessel to a point at mid-depth.
LAZY_WAVE = """\
hawser: 1
environment: {water: {depth: 100}}
line_types:
  bare: {outer_diameter: 0.16, mass_per_length: 36.7, EA: 469 MN, EI: 19.9 kN m2, GJ: 19.9 kN m2, Cd_axial: 0.1}
  buoyant: {outer_diameter: 0.3, mass_per_length: 60.85, EA: 469 MN, EI: 19.9 kN m2, GJ: 19.9 kN m2, Cd_axial: 0.1}
bodies:
  vessel: {MOTION}
lines:
  riser:
    sections: [{type: bare, length: 60, elements: 20}, {type: buoyant, length: 24, elements: 12}, {type: bare, length: 16, elements: 8}]
    end_a: {body: vessel, at: [0, 0, 0]}
    end_b: {anchor: [45, 0, -70]}
contact: {between_lines: false}
dynamics: {duration: DURATION}
output: {every: 1, histories: [{line: riser, at: end_a, name: top}]}
"""
# The rope is hauled in and paid out at a tabulated speed; the tension is that at the lower end.
WINCH = """\
hawser: 1
environment: {water: {depth: 100}}
line_types: {wire: {outer_diameter: 0.05, mass_per_length: 9, EA: 20 MN, bending: false, stiffness_damping: 0.05}}
bodies: {vessel: {position: [0, 0, 6]}}
lines:
  wire:
    sections: [{type: wire, length: 120, elements: 40}]
    end_a: {body: vessel, at: [0, 0, 0], feed: {stock: 60, speed_table: SPEED}}
    end_b: free
    masses: [{at: end_b, mass: 5000, volume: 0.7, drag_area: 1.5, Ca: 0.5}]
contact: {between_lines: false}
dynamics: {duration: DURATION}
output: {every: 1, histories: [{line: wire, at: end_a, name: top}]}
"""


def chain(motion, at="0, 0, 0", duration=40, environment=""):
    text = CHAIN.replace("ENVIRONMENT\n", environment + "\n" if environment else "")
    return text.replace("MOTION", motion).replace("[AT]", f"[{at}]").replace("DURATION", str(duration))


def lazy_wave(motion, duration):
    return LAZY_WAVE.replace("MOTION", motion).replace("DURATION", str(duration))


def moved(every, duration, of_time, more=""):
    return f"motion: {{table: {{rows: {rows(every, duration, of_time)}{more}}}, ramp: 8}}"


def second_differences(times, values, at):
    """Root mean square of f(t - h) - 2 f(t) + f(t + h) of linearly interpolated values at equidistant triples around
    `at`."""
    def value(t):
        i = min(max(bisect.bisect_left(times, t), 1), len(times) - 1)
        return values[i - 1] + (t - times[i - 1]) / (times[i] - times[i - 1]) * (values[i] - values[i - 1])
    squares = [(value(r) - 2 * value(s) + value(t)) ** 2 for r, s, t in zip(at, at[1:], at[2:])
               if abs(t - 2 * s + r) < 0.05 * (t - s)]
    return math.sqrt(sum(squares) / len(squares))


class AutomaticSteps(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def tension(self, name, text):
        write(self.folder, f"{name}.yaml", text)
        result = run(HAWSER, "run", self.folder / f"{name}.yaml", "-q", "-o", self.folder / f"{name}.h5", timeout=600)
        self.assertEqual(result.returncode, 0, result.stderr)
        times, values = Results(self.folder / f"{name}.h5").tension(self.start)
        mean, least, largest = extremes(times, values)
        deviation = math.sqrt(extremes(times, [(v - mean) ** 2 for v in values])[0])
        return largest, least, deviation, times, values

    def compare(self, name, text, start=10):
        self.start = start
        write(self.folder, "case.yaml", text)
        output = run(HAWSER, "check", self.folder / "case.yaml").stdout
        found = re.search(r"automatic steps of at most ([0-9.e-]+) s \((.*)\)", output)
        self.assertIsNotNone(found, output)
        fine = re.sub(r"dynamics: \{", f"dynamics: {{max_step: {float(found[1]) / 5:.6g}, ", text)
        a, b = self.tension(name, text), self.tension(name + "-fine", fine)
        saw, smooth = (second_differences(times, values, a[3]) / b[2] for times, values in (a[3:], b[3:]))
        print(f"  {name:22} {found[1]:>8} s {len(a[3]):6} steps  largest {100 * (a[0] / b[0] - 1):+6.3f} %  least "
              f"{100 * (a[1] - b[1]) / b[0]:+6.3f} %  deviation {100 * (a[2] / b[2] - 1):+6.3f} %  second differences "
              f"{saw:.3g} {smooth:.3g}  ({found[2]})")
        with self.subTest(case=name):
            self.assertLess(abs(a[0] / b[0] - 1), APART)
            self.assertLess(abs(a[2] / b[2] - 1), APART)
            self.assertLess(saw, 1.2 * smooth + SAW)

    def test_table_with_long_rows(self):
        self.compare("rows of 1 s", chain(moved(1, 60, lambda t: (SLOW(t), 0, FAST(t)))))

    def test_tables_between_rows(self):
        self.compare("monotone", chain(moved(0.5, 60, lambda t: (SLOW(t), 0, FAST(t)), ", interpolation: monotone")))

    def test_slow_drift_beside_waves(self):
        drift = rows(2, 100, lambda t: (6 * math.sin(2 * math.pi * t / 60), 0, 0))
        self.compare("drift and waves", chain(
            f"motion: {{table: {{rows: {rows(0.5, 100, lambda t: (0, 0, FAST(t)))}}}, drift: {{table: {{rows: {drift}}}}}, ramp: 8}}",
            duration=60))

    def test_one_table_of_slow_and_fast(self):
        self.compare("slow and fast", chain(moved(0.5, 100, lambda t: (wave(6, 60)(t) + wave(0.5, 9)(t), 0, wave(0.6, 9, 1)(t))),
                                            duration=60))

    def test_table_of_pitch(self):
        pitch = rows(0.5, 60, lambda t: (0, 0, 0, 0, wave(1.2, 8)(t), 0))
        self.compare("pitch", chain(f"motion: {{table: {{rows: {pitch}}}, ramp: 8}}", at="40, 0, 0").replace(
            "anchor: [120, 0, -50]", "anchor: [160, 0, -50]"))

    def test_lazy_wave_by_a_table(self):
        self.compare("lazy wave", lazy_wave(moved(1, 60, lambda t: (0, 0, wave(1.5, 12)(t))), 40), start=14)

    def test_harmonic(self):
        self.compare("harmonic", chain("motion: {harmonic: {amplitude: [0.5, 0, 0.7], period: 9}, ramp: 9}"))

    def test_waves(self):
        self.compare("regular wave", chain("position: [0, 0, -2]",
                                           environment="  waves: {regular: {height: 4, period: 9}, ramp: 9}", duration=40))

    def test_responses_in_a_sea(self):
        rao = ", ".join(f"[{period}, 0, {surge}, 90, 0, 0, {heave}, {lag}, 0, 0, 0.5, 90, 0, 0]"
                        for period, surge, heave, lag in ((4, 0.1, 0.1, 150), (7, 0.3, 0.4, 60), (10, 0.6, 0.8, 10), (16, 0.9, 1, 0)))
        self.compare("sea", chain(f"motion: {{rao: {{rows: [{rao}]}}, ramp: 9}}", at="0, 0, -2",
                                  environment="  waves: {jonswap: {hs: 2, tp: 9, seed: 3, components: 40}}", duration=60))

    def test_feeder(self):
        speed = rows(0.5, 40, lambda t: (wave(0.5, 10)(t) * min(t / 5, 1),))
        self.compare("feeder", WINCH.replace("SPEED", speed).replace("DURATION", "40"))

    @unittest.skipUnless(os.environ.get("HAWSER_FULL"), "long")
    def test_lazy_wave_under_a_floater(self):
        shutil.copy(CASES / "L4-1c-200.txt", self.folder / "L4-1c-200.txt")
        text = (CASES / "L4-1c-200.yaml").read_text("utf-8").replace(", step: 0.1", "")
        self.compare("L4-1c-200", text, start=100)


if __name__ == "__main__":
    unittest.main()
