"""hawser report, plot and export: for a run, and messages if there is nothing to show."""
import contextlib
import csv
import io
import os
import re
import shutil
import sys
import tempfile
import types
import unittest
from html.parser import HTMLParser
from pathlib import Path

from support import ROOT, run, write

sys.path.insert(0, str(ROOT / "scripts"))
import numpy as np  # noqa: E402

from hawser_post import __main__ as post, tables  # noqa: E402
from hawser_post.fatigue import CURVES, damage, rainflow, wall_stress  # noqa: E402
from hawser_post.page import from_place_to_place  # noqa: E402
from hawser_post.results import Results  # noqa: E402
from hawser_post.sea import Sea  # noqa: E402
from hawser_post.stress import Wall  # noqa: E402
from hawser_post.statistics import spectrum, statistics  # noqa: E402

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
CASE = """\
hawser: 1
title: A riser & its <barge>
environment:
  water: {depth: 60 m}
  seabed: {depth: 60 m, friction: 0.5}
line_types:
  riser: {outer_diameter: 0.25, mass_per_length: 90, EA: 6e8, EI: 2e4, GJ: 2e4, Cd_normal: 1}
  chain: {outer_diameter: 0.1, mass_per_length: 40, EA: 2e8, bending: false, breaking_load: 2 MN}
bodies:
  barge: {motion: {harmonic: {amplitude: [0, 0, 1], period: 8}, ramp: 8}}
volumes:
  barge: {shape: {box: {centre: [-6, 0, 1], size: [10, 8, 3]}}, body: barge}
lines:
  riser:
    sections: [{type: riser, length: 100, elements: 40}]
    end_a: {body: barge, at: [0, 0, -2]}
    end_b: {anchor: [70, 0, -60]}
  mooring:
    sections: [{type: chain, length: 110, elements: 30}]
    end_a: {body: barge, at: [-11, 0, 0]}
    end_b: {anchor: [-90, 10, -60]}
dynamics: {duration: 24}
output: {every: 0.5, histories: [{line: riser, at: end_a, name: hang-off}]}
"""


class Balanced(HTMLParser):
    """Checks that tags are balanced and nothing is fetched; collects the displayed words."""
    VOID = {"meta", "link", "img", "br"}

    def __init__(self):
        super().__init__()
        self.open, self.words, self.pictures, self.foreign = [], [], 0, []

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("src", "href") and not value.startswith(("data:", "#")):
                self.foreign.append(value)
        self.pictures += tag == "img"
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open and self.open[-1] == tag, (tag, self.open)
        self.open.pop()

    def handle_data(self, data):
        self.words.append(data)


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        write(cls.folder, "riser.yaml", CASE)
        cls.first = cls.hawser("report", "riser.yaml")  # runs the case
        cls.results = Results(cls.folder / "riser.h5")

    @classmethod
    def hawser(cls, *arguments):
        return run(HAWSER, *arguments, cwd=cls.folder, timeout=600)

    @classmethod
    def python(cls, *arguments):
        """The same without starting the program and Python again."""
        out, err = io.StringIO(), io.StringIO()
        before = os.getcwd()
        try:
            os.chdir(cls.folder)
            with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
                code = post.main(list(arguments))
        finally:
            os.chdir(before)
        return types.SimpleNamespace(returncode=code, stdout=out.getvalue(), stderr=err.getvalue())

    def test_report_of_a_case(self):
        self.assertEqual(self.first.returncode, 0, self.first.stderr)
        text = (self.folder / "riser.html").read_text(encoding="utf-8")
        self.assertLess(len(text), 5e6)
        page = Balanced()
        page.feed(text)
        self.assertEqual(page.open, [])
        self.assertEqual(page.foreign, [])
        self.assertGreater(page.pictures, 12)
        words = " ".join(page.words)
        for part in ("A riser & its <barge>", "Notes and warnings", "hang-off", "Range graphs", "Energy", "sections:",
                     f"{self.results.outputs} outputs"):
            self.assertIn(part, words)
        extremes = {(quantity, line): value for quantity, line, value, *_ in self.results.summary()}
        for quantity, _ in extremes:
            self.assertIn(quantity, words)
        self.assertAlmostEqual(extremes["max utilisation", "mooring"], extremes["max effective tension", "mooring"] / 2e6)
        self.assertNotIn(("max utilisation", "riser"), extremes)
        self.assertTrue(any(m.startswith("note: ") for m in self.results.messages()))
        for message in self.results.messages():
            self.assertIn(message, words)
        # Results newer than the case are not computed again.
        again = self.hawser("report", "riser.yaml", "-o", "again.html", "--since", "8")
        self.assertEqual((again.returncode, again.stdout), (0, "report: again.html\n"), again.stderr)

    def test_modes_in_the_report(self):
        result = self.hawser("report", "riser.yaml", "--modes", "-o", "modes.html")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        page = Balanced()
        page.feed((self.folder / "modes.html").read_text(encoding="utf-8"))
        words = " ".join(page.words)
        self.assertIn("Natural modes", words)
        periods = Results(self.folder / "riser-modes.h5").series("modes").column("period")
        self.assertIn(f"Mode 1: {periods[0]:.4g} s.", words)
        self.assertEqual(self.python("report", "riser.h5", "--modes").returncode, 2)

    def test_sea_of_the_results(self):
        write(self.folder, "sea.yaml", CASE.replace("water: {depth: 60 m}", "water: {depth: 60 m, surface: 0.5}\n  waves: {WAVES}")
              .replace("duration: 24", "duration: 1"))
        text = (self.folder / "sea.yaml").read_text()
        for waves in ("regular: {height: 3, period: 8, direction_deg: 90}, ramp: 4", "jonswap: {hs: 2.5, tp: 8, components: 40}"):
            write(self.folder, "sea.yaml", text.replace("WAVES", waves))
            result = self.hawser("run", "-q", "sea.yaml")
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
            sea = Sea(Results(self.folder / "sea.h5"))
            amplitude, omega, number = sea.components.T[:3]
            np.testing.assert_allclose(omega**2, 9.80665 * number * np.tanh(number * 60.5), rtol=2e-2)
            if waves.startswith("regular"):
                self.assertAlmostEqual(float(sea.surface(5.0, 20.0, 6.0)),
                                       0.5 + 1.5 * np.cos(number[0] * 20 - 2 * np.pi / 8 * 6), places=6)
                self.assertEqual(sea.ramp, 4)
            else:
                self.assertAlmostEqual(4 * np.sqrt((amplitude**2).sum() / 2) / 2.5, 1, delta=0.02)

    def test_figures(self):
        for what in ("range", "history", "spectrum", "phase", "plan", "elevation", "space"):
            made = self.python("plot", "riser.h5", what)
            self.assertEqual(made.returncode, 0, made.stderr)
            self.assertGreater((self.folder / f"riser-{what}.png").stat().st_size, 8000)
        made = self.hawser("plot", "riser.h5", "range", "--field", "bending_moment", "--line", "riser", "-o", "m.svg")
        self.assertIn("bending moment", (self.folder / "m.svg").read_text(), made.stderr)

    def test_tables(self):
        made = self.hawser("export", "riser.h5", "-o", "csv")
        self.assertEqual(made.returncode, 0, made.stderr)

        def table(name):
            with (self.folder / "csv" / name).open(encoding="utf-8") as file:
                rows = list(csv.reader(file))
            return rows[0], rows[1:]

        head, rows = table("range_riser.csv")
        line = self.results.line("riser")
        tension = self.results.file["statistics/effective_tension"][line.nodes]
        most = np.array([float(r[head.index("effective_tension_max [N]")]) for r in rows])
        np.testing.assert_allclose(most, tension[:, 2], rtol=1e-8)
        head, rows = table("history_hang-off.csv")
        self.assertEqual(len(rows), self.results.steps)
        self.assertEqual(head[:2], ["time [s]", "position_x [m]"])
        np.testing.assert_allclose([float(r[3]) for r in rows], self.results.series("hang-off").column("position_z"),
                                   rtol=1e-8, atol=1e-8)
        head, rows = table("ends.csv")
        # At rest the ends carry the submerged weight of the line except for the part on the bed.
        forces = [float(r[head.index("vertical force [N]")]) for r in rows if r[0] == "riser"]
        self.assertLess(forces[0], 0)
        self.assertEqual(table("extremes.csv")[1][0][0], self.results.summary()[0][0])

    def test_refusals(self):
        for arguments, part in ((["report", "none.h5"], "none.h5: there is no such file"),
                                (["report", "riser.yaml.txt"], "there is no such file"),
                                (["plot", "riser.h5", "range", "--line", "rizer"], "there is no line 'rizer' (there are: riser, mooring)"),
                                (["plot", "riser.h5", "range", "--field", "mass"], "there is no field 'mass'"),
                                (["plot", "riser.h5", "history", "--name", "x"], "there is no history 'x'"),
                                (["plot", "riser.h5", "history", "--column", "x"], "has no column 'x'"),
                                (["plot", "riser.h5", "plan", "-o", "plan.xyz"], "is a .png, .svg or .pdf file"),
                                (["export", "riser.yaml", "-o", "/proc/none"], "cannot be written")):
            result = self.python(*arguments)
            with self.subTest(arguments=arguments):
                self.assertIn(result.returncode, (1, 2))
                self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
                self.assertTrue(result.stderr.startswith("hawser: "), result.stderr)
                self.assertIn(part, result.stderr)
        write(self.folder, "no.h5", "text")
        self.assertIn("is not a readable HDF5 file", self.python("plot", "no.h5", "plan").stderr)

    def test_fatigue(self):
        result = self.hawser("fatigue", "riser.h5=0.25", "riser.h5=0.75", "--curve", "api-studless-chain", "--breaking-load",
                           "3e6", "--line", "mooring", "--since", "8")
        self.assertEqual(result.returncode, 0, result.stderr)
        line, t = self.results.line("mooring"), self.results.time
        tension = self.results.field("effective_tension", line)[t >= 8]
        exact = [damage(tension[:, n] / 3e6, CURVES["api-studless-chain"]) / (t[-1] - t[t >= 8][0]) * 365.25 * 86400
                 for n in range(tension.shape[1])]
        self.assertIn(f"{max(exact):.4g} a year", result.stdout)
        with (self.folder / "riser-fatigue.csv").open() as file:
            rows = list(csv.reader(file))[1:]
        np.testing.assert_allclose([float(r[1]) for r in rows], exact, rtol=1e-6)
        pipe = ["--curve", "dnv-d-air", "--outer-diameter", "0.25", "--wall", "0.02", "--line", "riser"]
        self.assertIn("largest damage", self.python("fatigue", "riser.h5", *pipe).stdout)
        for arguments, part in ((["riser.h5=0.7", "riser.h5=0.7", *pipe], "or their sum exceeds 1"),
                                (["riser.h5=x", *pipe], "is not a number"),
                                (["riser.h5", "--curve", "dnv-d-air"], "the case does not give the pipe wall of line"),
                                (["riser.h5", "--curve", "dnv-d-air", "--wall", "0.02"], "needs --outer-diameter"),
                                (["riser.h5", *pipe, "--area", "0.1"], "does not use --area, but --outer-diameter and --wall"),
                                (["riser.h5", *pipe, "--factor", "0"], "--factor 0 is not above 0"),
                                (["riser.h5", *pipe, "--since", "23"], "are too few to count cycles")):
            refused = self.python("fatigue", *arguments)
            self.assertEqual(refused.returncode, 2)
            self.assertIn(part, refused.stderr)

    def test_listed_with_the_commands(self):
        output = self.hawser("--help").stdout
        for command in ("report", "plot", "export"):
            self.assertIn(command, output)
        self.assertIn("--since", self.hawser("report", "--help").stdout)


class Numbers(unittest.TestCase):
    def test_statistics_of_a_sine_with_uneven_steps(self):
        t = np.cumsum(np.random.default_rng(1).uniform(0.002, 0.02, 9000))
        t = (t - t[0]) * 80 / (t[-1] - t[0])
        s = statistics(t, 3 + 2 * np.sin(2 * np.pi * t / 4))
        self.assertAlmostEqual(s.mean, 3, places=4)
        self.assertAlmostEqual(s.deviation, np.sqrt(2), places=4)
        self.assertAlmostEqual(s.period, 4, places=4)
        self.assertAlmostEqual(s.most, 5, places=4)
        self.assertAlmostEqual(s.least_time % 4, 3, delta=0.05)

    def test_spectrum_holds_the_variance_at_its_frequency(self):
        t = np.linspace(0, 400, 8001)
        f, density = spectrum(t, 2 * np.sin(2 * np.pi * t / 5))
        self.assertAlmostEqual(f[np.argmax(density)], 0.2, delta=0.01)
        self.assertAlmostEqual(np.trapz(density, f), 2, delta=0.02)

    def test_rainflow_of_the_standard(self):
        # ASTM E1049-85, figure 6 and table 6: ranges 3, 4, 6, 8, 9.
        ranges, means, counts = rainflow([-2, 1, -3, 5, -1, 3, -4, 4, -2])
        found = {float(r): float(counts[ranges == r].sum()) for r in np.unique(ranges)}
        self.assertEqual(found, {3: 0.5, 4: 1.5, 6: 0.5, 8: 1.0, 9: 0.5})
        self.assertEqual(float(means[ranges == 3][0]), -0.5)
        # Independent of values between the turning points.
        fine = np.interp(np.linspace(0, 8, 801), range(9), [-2, 1, -3, 5, -1, 3, -4, 4, -2])
        self.assertAlmostEqual(float((rainflow(fine)[0] ** 3 * rainflow(fine)[2]).sum()), float((ranges**3 * counts).sum()))
        self.assertEqual(rainflow([5, 5, 5]).size, 0)

    def test_damage_of_a_sine(self):
        x = 3e6 + 1e6 * np.cos(np.linspace(0, 2 * np.pi * 50, 50 * 40 + 1))
        # N = 316 R^-3 with R = 2/10; K = 10^(3.20 - 2.79 L) R^-4.09 with L = 3/10 (API RP 2SK).
        self.assertAlmostEqual(damage(x / 1e7, CURVES["api-studless-chain"]), 50 * 0.2**3 / 316, places=6)
        self.assertAlmostEqual(damage(x / 1e7, CURVES["api-strand-rope"]) / (50 * 0.2**4.09 / 10 ** (3.20 - 2.79 * 0.3)), 1,
                               places=3)
        # DNV-RP-C203, curve D in air: 1e7 cycles at 52.63 MPa; log N = 15.606 - 5 log s below.
        stress = 0.5 * np.cos(np.linspace(0, 2 * np.pi * 50, 50 * 40 + 1))
        self.assertAlmostEqual(damage(52.63 * stress, CURVES["dnv-d-air"]) * 1e7 / 50, 1, places=2)
        self.assertAlmostEqual(damage(30 * stress, CURVES["dnv-d-air"]) * 10**15.606 / 30**5 / 50, 1, places=6)
        self.assertAlmostEqual(damage(100 * stress, CURVES["dnv-d-air"]) * 10**12.164 / 100**3 / 50, 1, places=6)

    def test_stress_of_a_pipe(self):
        outer, wall, moment = 0.5, 0.02, 2e5
        inner = outer - 2 * wall
        stress = wall_stress(np.array([[1e6]]), np.array([[0.6 * moment]]), np.array([[0.8 * moment]]), Wall(outer, inner))
        area, inertia = np.pi / 4 * (outer**2 - inner**2), np.pi / 64 * (outer**4 - inner**4)
        self.assertAlmostEqual(stress.mean(), 1.0 / area, places=9)
        bending = 1e-6 * moment * outer / 2 / inertia
        # One of sixteen places is within 11.25 degrees of the plane of bending.
        self.assertLessEqual(stress.max() - stress.mean(), bending)
        self.assertGreater(stress.max() - stress.mean(), bending * np.cos(np.pi / 16))


class Small(unittest.TestCase):
    def test_paths_of_drawings_keep_their_places(self):
        random = np.random.default_rng(5)
        x = np.stack([np.linspace(40, 500, 900), 100 + 60 * random.normal(size=900)], axis=1)
        x[::7, 1] = x[1::7, 1][: len(x[::7])]  # strokes without rise
        text = " ".join(f"{'M' if k in (0, 500) else 'L'} {a:.6f} {b:.6f} " for k, (a, b) in enumerate(x)) + "z "
        short = from_place_to_place(text.encode())
        self.assertLess(len(short), 0.45 * len(text))
        at, start, found, command = np.zeros(2), np.zeros(2), [], ""
        for command, numbers in re.findall(r"([mlz])([^mlz]*)", short.decode()):
            steps = np.array(re.findall(r"-?(?:\d+\.?\d*|\.\d+)", numbers), float).reshape(-1, 2)
            for k, step in enumerate(steps):
                at = at + step
                start = at if command == "m" and k == 0 else start
                found.append(at)
        self.assertLessEqual(np.abs(found - x).max(), 0.0501)
        self.assertEqual(command, "z")
        np.testing.assert_allclose(start, x[500], atol=0.051)
        self.assertEqual(from_place_to_place(b"M 0 0 C 1 2 3 4 5 6"), b"M 0 0 C 1 2 3 4 5 6")
        self.assertEqual(from_place_to_place(b"M 1 1 L 2 1 L 2 2 z M 1 1 L 0.5 1"), b"m1 1l1 0 0 1zm0 0l-.5 0")

    def test_azimuths_are_not_of_rounding(self):
        for direction, exact in (((1, 1e-40, 0), 0), ((-1, -1e-40, 0), 180), ((-1, 0, 0), 180), ((1e-17, 1e-18, 1), 0), ((0, -0.5, 0.1), -90),
                                 ((0.6, 0.6, 0), 45)):
            self.assertAlmostEqual(tables.azimuth(np.array(direction, float)), exact, places=9)


if __name__ == "__main__":
    unittest.main()
