"""Parts of a report on synthetic results files: units, statistics of every step, stress of pipes, clearances, sea
and seabed."""
import contextlib
import csv
import io
import json
import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

from support import ROOT, write
from synthetic import results_file

sys.path.insert(0, str(ROOT / "scripts"))
from hawser_post import __main__ as post  # noqa: E402
from hawser_post import charts, envelopes, export, fatigue, inputs, stress, tables  # noqa: E402
from hawser_post.results import Refusal, Results  # noqa: E402
from hawser_post.sea import Sea  # noqa: E402

CASE = """\
hawser: 1
title: Synthetic
environment: {water: {depth: 50, density: 1000}, seabed: {depth: 50}, gravity: 10}
line_types:
  wall: {pipe: {outer_diameter: 300 mm, wall_thickness: 0.02}, contents: {density: 800, pressure: 10 MPa}}
  bar: {outer_diameter: 0.1, mass_per_length: 10, EA: 1e8, EI: 1, GJ: 1}
lines:
  riser: {sections: [{type: wall, length: 60}, {type: bar, length: 40}], end_a: {anchor: [0, 0, -10]}, end_b: free}
output: {statistics_from: 4 s}
"""
TIME, ARC = np.arange(0, 20, 0.5), np.linspace(0, 100, 51)


class Parts(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def file(self, statistics=True, name="run.h5", case=CASE, **more):
        n, o = len(ARC), len(TIME)
        x = np.zeros((o, n, 3))
        x[:, :, 0], x[:, :, 2] = ARC, -10 - ARC / 5
        self.tension = 1e5 * (2 + np.sin(TIME)[:, None] * np.sin(ARC / 20))
        self.moment = 2e4 * np.abs(np.sin(TIME / 2)[:, None] * np.cos(ARC / 10))
        outside, inside = 1e4 * -x[:, :, 2], 10e6 + 8e3 * -x[:, :, 2]
        wall = self.tension + inside * np.pi / 4 * 0.26**2 - outside * np.pi / 4 * 0.3**2
        fields = {"position": ("m", x), "effective_tension": ("N", self.tension), "wall_tension": ("N", wall),
                  "bending_moment": ("N m", self.moment), "torsion_moment": ("N m", 0 * self.moment)}
        every = {}
        if statistics:
            for k, field in enumerate(f for f in fields if f != "position"):
                v = fields[field][1]
                every[field] = (fields[field][0], np.stack([v.min(axis=0) - 3e3, 0 * ARC + 7.25, v.max(axis=0) + 5e3,
                                                            0 * ARC + 8.5 + k, v.mean(axis=0), v.std(axis=0)], axis=-1))
        return results_file(self.folder / name, TIME, {"riser": ARC}, fields, statistics=every, case=case, **more)

    def run_(self, *arguments):
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            try:
                code = post.main([str(a) for a in arguments])
            except SystemExit as stop:  # of the parser
                code = stop.code
        return code, out.getvalue(), err.getvalue()

    def words(self, *arguments):
        code, _, err = self.run_("report", *arguments, "-o", self.folder / "page.html")
        self.assertEqual(code, 0, err)
        text = (self.folder / "page.html").read_text(encoding="utf-8")
        return re.sub(r"\s+", " ", re.sub(r"<[^>]*>", " ", re.sub(r'src="data:[^"]*"', "", text)))

    def test_statistics_of_every_step_come_first(self):
        results = Results(self.file())
        line = results.line("riser")
        found = envelopes.envelope(results, line, "effective_tension")
        np.testing.assert_allclose(found.most, self.tension.max(axis=0) + 5e3)
        np.testing.assert_allclose(found.least_time, 7.25)
        self.assertTrue(found.every_step)
        # From another time on only outputs are available.
        later = envelopes.envelope(results, line, "effective_tension", 10.0)
        np.testing.assert_allclose(later.most, self.tension[TIME >= 10].max(axis=0))
        self.assertFalse(later.every_step)
        self.assertTrue(envelopes.envelope(results, line, "effective_tension", 4.0).every_step)
        words = self.words(results.path)
        self.assertIn("Over every step from t = 4 s on.", words)
        peak = self.tension.max() + 5e3
        self.assertIn("riser effective tension kN", words)
        self.assertIn(f" {peak / 1e3:.1f} 8.500 ", words)
        self.assertIn("Over the 20 outputs from t = 10 s on", envelopes.description(results, ["effective_tension"], 10.0))
        without = self.words(self.file(statistics=False, name="bare.h5"))
        self.assertIn("Over the 40 outputs from t = 0 s on, so a peak may lie between two of them", without)
        going = Results(self.file(name="going.h5", ended=False))  # a run in progress: statistics are older than outputs
        self.assertFalse(envelopes.envelope(going, going.lines[0], "effective_tension").every_step)
        self.assertIn("the run has not ended", envelopes.description(going, ["effective_tension"], 0.0))
        # CSV files are in SI units.
        head, rows = export.ranges(results, line)
        np.testing.assert_allclose(rows[:, head.index("effective_tension_max [N]")], found.most)

    def test_statistics_of_vectors(self):
        path = self.file()
        with h5py.File(path, "a") as file:
            file["statistics/position"] = np.zeros((len(ARC), 3, 6))
        results = Results(path)
        self.assertEqual(results.statistics("position", results.line("riser")).shape, (51, 3, 6))
        self.assertFalse(envelopes.of_every_step(results, "position", 0.0))

    def test_units_of_pages(self):
        head, rows = tables.for_reading(["line", "tension [N]", "x [m]"], [["a", 2500.0, 3.0]])
        self.assertEqual((head, rows), (["line", "tension [kN]", "x [m]"], [["a", 2.5, 3.0]]))
        head, rows = tables.for_reading(["value", "unit", "time [s]"], [[2500.0, "N m", 7.0], [0.5, "1", 8.0]])
        self.assertEqual(rows, [[2.5, "kN m", 7.0], [0.5, "", 8.0]])
        results = Results(self.file())
        axes = charts.range_graph(results, results.line("riser"), "bending_moment").axes[0]
        self.assertEqual(axes.get_ylabel(), "bending moment [kN m]")

    def test_legends_cover_no_curve(self):
        results = Results(self.file())
        figure = charts.range_graph(results, results.line("riser"), "effective_tension")
        figure.canvas.draw()
        axes = figure.axes[0]
        legend, frame = axes.get_legend().get_window_extent(), axes.get_window_extent()
        self.assertGreaterEqual(legend.y0, frame.y1)
        self.assertLessEqual(legend.y1, figure.bbox.y1 + 1)

    def test_stress_of_a_closed_cylinder(self):
        # Pressure alone with closed ends: sqrt(3) p b²/(b² - a²) at the inner fibre; tension and bending
        # alone: My/I + N/A.
        wall, a, b, p = stress.Wall(0.3, 0.26), 0.13, 0.15, 20e6
        found = stress.von_mises(wall, p * np.pi * a**2, 0.0, 0.0, 0.0, p)
        self.assertAlmostEqual(found / (np.sqrt(3) * p * b**2 / (b**2 - a**2)), 1, places=12)
        # Equal internal and external pressure with closed ends: hydrostatic, without shear.
        even = stress.von_mises(wall, p * np.pi * (a**2 - b**2), 0.0, 0.0, p, p)
        self.assertLess(even, 1e-6 * p)
        area, inertia = np.pi * (b**2 - a**2), np.pi / 4 * (b**4 - a**4)
        self.assertAlmostEqual(stress.von_mises(wall, 3e5, 4e4, 0.0, 0.0, 0.0) / (3e5 / area + 4e4 * b / inertia), 1, places=12)
        twist = stress.von_mises(wall, 0.0, 0.0, 5e4, 0.0, 0.0)
        self.assertAlmostEqual(twist / (np.sqrt(3) * 5e4 * b / (2 * inertia)), 1, places=12)

    def test_coatings_hand_the_pressure_on(self):
        plain = Results(self.file())
        case = CASE.replace("wall_thickness: 0.02}", "wall_thickness: 0.02, coatings: [{thickness: 50 mm, density: 750}]}")
        self.assertNotEqual(case, CASE)
        coated = Results(self.file(name="coated.h5", case=case))
        one, other = (stress.along(results, results.line("riser"))[:, ARC <= 60] for results in (plain, coated))
        np.testing.assert_allclose(one, other, rtol=1e-9)
        output = stress.description(plain, plain.line("riser"), stress.along(plain, plain.line("riser")))
        self.assertIn(f"{one.max() / 1e6:.4g} MPa at arc length", output)

    def test_stress_along_a_line(self):
        results = Results(self.file())
        line = results.line("riser")
        found = stress.along(results, line)
        self.assertTrue(np.isnan(found[:, ARC > 60]).all())
        self.assertTrue(np.isfinite(found[:, ARC <= 60]).all())
        # The internal pressure is recovered from the wall tension.
        depth, k = 10 + ARC[5] / 5, 7
        wall = stress.Wall(0.3, 0.26)
        inside, outside = 10e6 + 8e3 * depth, 1e4 * depth
        tension = self.tension[k, 5] + inside * np.pi / 4 * 0.26**2 - outside * np.pi / 4 * 0.3**2
        by_hand = stress.von_mises(wall, tension, self.moment[k, 5], 0.0, outside, inside)
        self.assertAlmostEqual(found[k, 5] / by_hand, 1, places=9)
        code, _, err = self.run_("plot", results.path, "stress", "-o", self.folder / "s.svg")
        self.assertEqual(code, 0, err)
        self.assertIn("von Mises stress [MPa]", (self.folder / "s.svg").read_text())
        self.assertIn("Stress of pipes", self.words(results.path))
        code, _, err = self.run_("plot", results.path, "stress", "--wall", "0.2", "-o", self.folder / "s.svg")
        self.assertEqual(code, 2)
        self.assertIn("--outer-diameter and --wall", err)
        cables = Results(results_file(self.folder / "cables.h5"))
        with self.assertRaisesRegex(Refusal, "all lines are cables"):
            stress.along(cables, cables.lines[0])

    def test_fatigue_takes_the_wall_of_the_case(self):
        path = self.file()
        with h5py.File(path, "a") as file:
            file["fields/bending_moment_2"], file["fields/bending_moment_3"] = 0.6 * self.moment, 0.8 * self.moment
        damages = []
        for options in ([], ["--outer-diameter", "300e-3", "--wall", "0.02"]):
            code, output, err = self.run_("fatigue", path, "--curve", "dnv-d-air", *options, "-o", self.folder / "damage.csv")
            self.assertEqual(code, 0, err)
            damages.append(np.loadtxt(self.folder / "damage.csv", delimiter=",", skiprows=1))
        self.assertEqual(len(damages[1]), len(ARC))
        pipe = ARC <= 60  # the bar has no wall
        np.testing.assert_allclose(damages[0][:, 0], ARC[pipe])
        self.assertGreater(damages[0][:, 1].min(), 0)
        np.testing.assert_allclose(damages[0][:, 1], damages[1][pipe, 1], rtol=1e-6)
        # The axial force is that of the wall: the same sum by hand, from effective tension and pressures.
        k, depth = 5, 10 + ARC[5] / 5
        tension = self.tension[:, k] + (10e6 + 8e3 * depth) * np.pi / 4 * 0.26**2 - 1e4 * depth * np.pi / 4 * 0.3**2
        around = fatigue.wall_stress(tension[:, None], 0.6 * self.moment[:, [k]], 0.8 * self.moment[:, [k]], stress.Wall(0.3, 0.26))
        by_hand = max(fatigue.damage(around[:, 0, p], fatigue.CURVES["dnv-d-air"]) for p in range(fatigue.PLACES))
        self.assertAlmostEqual(damages[0][k, 1] / by_hand * (TIME[-1] - TIME[0]) / fatigue.YEAR, 1, places=6)

    def chains(self, grade="R4"):
        case = ("hawser: 1\nline_types:\n  chain: {library: chain-studless, diameter: 84 mm, grade: " + grade + "}\n"
                "  rope: {library: wire-six-strand, diameter: 0.1}\n"
                "lines: {riser: {sections: [{type: chain, length: 60}, {type: rope, length: 40}]}}\n")
        path = self.file(name=f"{grade}.h5", case=case)
        with h5py.File(path, "r+") as file:  # as computed by the program
            read = json.loads(file["case_read"][()])
            read["line_types"]["rope"] = {"breaking_load": 6333580.0}
            del file["case_read"]
            file["case_read"] = json.dumps(read).encode()
        return path

    def damages(self, *arguments):
        code, output, err = self.run_("fatigue", *arguments, "-o", self.folder / "damage.csv")
        self.assertEqual(code, 0, err)
        return np.loadtxt(self.folder / "damage.csv", delimiter=",", skiprows=1), output

    def test_fatigue_of_chain_goes_by_the_strength_of_orq(self):
        # API Spec 2F: ORQ chain of 84 mm breaks at 21.1 84² (44 - 0.08 84) N = 5550 kN, R4 at 27.4/21.1 of that (IACS UR
        # W22). API's T-N curves take ORQ's for higher grades (de Laval 2005, OMAE2005, "API recommends the use of its TxN
        # curve considering the MBL of an ORQ chain even if the chain has a higher grade").
        own, output = self.damages(self.chains(), "--curve", "api-studless-chain")
        self.assertNotIn("warning: API", output)
        np.testing.assert_allclose(own[:, 0], ARC[ARC <= 60])  # the rope is no chain
        for text in ("5550306", "5550.306 kN", "5.550306MN"):
            given, output = self.damages(self.chains(), "--curve", "api-studless-chain", "--breaking-load", text)
            np.testing.assert_allclose(given[ARC <= 60, 1], own[:, 1], rtol=1e-5)
            self.assertNotIn("too small", output)
        given, output = self.damages(self.chains(), "--curve", "api-studless-chain", "--breaking-load", "7207.6 kN")
        np.testing.assert_allclose(given[ARC <= 60, 1], own[:, 1] / (27.4 / 21.1) ** 3, rtol=1e-4)
        self.assertIn("5550 kN here", output)
        self.assertIn("the damage is 2.2 times too small", output)
        np.testing.assert_allclose(self.damages(self.chains("R3"), "--curve", "api-studless-chain")[0], own)
        _, output = self.damages(self.file(), "--curve", "api-studless-chain", "--breaking-load", "3 MN")
        self.assertIn("of ORQ chain of the same size", output)

    def test_fatigue_takes_strength_and_area_of_the_case(self):
        rope = ARC >= 60
        own, _ = self.damages(self.chains(), "--curve", "api-strand-rope")
        given, _ = self.damages(self.chains(), "--curve", "api-strand-rope", "--breaking-load", "6333.58 kN")  # of its d²
        np.testing.assert_allclose(own, given[rope], rtol=1e-5)
        own, _ = self.damages(self.chains(), "--curve", "dnv-studless-chain")
        given, _ = self.damages(self.chains(), "--curve", "dnv-studless-chain", "--area", "11083.5389 mm2")  # 2 pi d²/4
        np.testing.assert_allclose(own, given[ARC <= 60], rtol=1e-5)
        own, _ = self.damages(self.chains(), "--curve", "dnv-strand-rope")
        given, _ = self.damages(self.chains(), "--curve", "dnv-strand-rope", "--area", "0.00785398163")
        np.testing.assert_allclose(own, given[rope], rtol=1e-5)
        bar = CASE.replace("EA: 1e8", "breaking_load: 900 kN, EA: 1e8")
        own, _ = self.damages(self.file(name="bar.h5", case=bar), "--curve", "api-spiral-rope")
        np.testing.assert_allclose(own[:, 0], ARC[rope])

    def test_fatigue_refuses_other_units(self):
        path = self.chains()
        for arguments, part in ((["dnv-studless-chain", "--area", "11084"], "in mm² it is --area 11084mm2"),
                                (["dnv-studless-chain", "--area", "1 acre"], "with one of the units m2"),
                                (["api-studless-chain", "--breaking-load", "5550"], "bare numbers are in N"),
                                (["api-studless-chain", "--breaking-load", "5550000 kN"], "exceeds the breaking load of any line"),
                                (["api-studless-chain", "--breaking-load", "0"], "is not a number above 0"),
                                (["dnv-d-air", "--breaking-load", "5e6"], "does not use --breaking-load")):
            with self.subTest(arguments=arguments):
                code, _, err = self.run_("fatigue", path, "--curve", *arguments)
                self.assertEqual(code, 2, err)
                self.assertIn(part, err)
        code, _, err = self.run_("fatigue", self.file(), "--curve", "dnv-studless-chain")
        self.assertEqual(code, 2)
        self.assertIn("needs --area: line 'riser' has no chain of the library", err)

    def test_walls_end_where_the_target_has_put_them(self):
        # The wall is 40 m long in the file, and a target has made it 60 m of the 100 m in the results.
        found = Results(self.file(name="found.h5", case=CASE.replace("length: 60}", "length: 40}").replace(
            "end_b: free}", "end_b: free, target: {tension: 1e5, at: end_a, section: 1}}")))
        given = Results(self.file())
        np.testing.assert_allclose(stress.along(found, found.lines[0]), stress.along(given, given.lines[0]))

    def test_utilisation(self):
        share = np.outer(0.5 + 0.1 * np.sin(TIME), 1 - ARC / 200)
        path = results_file(self.folder / "u.h5", TIME, {"riser": ARC}, {
            "utilisation": ("1", share), "bend_utilisation": ("1", np.where(ARC < 50, np.nan, 2 * share))},
            declared={"utilisation": {"order": 1, "utilisation": "tension over the breaking load"},
                      "bend_utilisation": {"order": 2, "utilisation": "bend radius over that of the bend"}})
        head, rows = tables.utilisation(Results(path))
        self.assertEqual(head, ["line", "quantity", "largest", "at [s]", "at [m]"])
        k = int(np.argmax(share[:, 0]))
        self.assertEqual(rows[0], ["riser", "utilisation", share[k, 0], TIME[k], 0.0])
        self.assertEqual(rows[1], ["riser", "bend utilisation", 2 * share[k, 25], TIME[k], 50.0])

    def test_a_field_is_shown_as_the_file_declares_it(self):
        # Fields unknown to the tools: in a graph, in the table alone, at a feeder's stations, nowhere.
        n = len(ARC)
        values = {name: ("N", np.outer(np.sin(TIME), k + ARC)) for k, name in enumerate(("one", "two", "three"))}
        share = ("1", np.outer(0.5 + 0.1 * np.sin(TIME), 1 - ARC / 200))
        stations = {"one_at_stations": ("N", np.tile([1e3, 1.0, 5e3, 2.0, 3e3, 0.1], (n, 1)))}
        case = "hawser: 1\nlines: {riser: {end_a: {anchor: [0, 0, 0], feed: {stock: 5, speed: 1}}}}\n"
        path = results_file(self.folder / "shown.h5", TIME, {"riser": ARC}, {**values, "four": share}, statistics=stations, case=case, declared={
            "one": {"label": "pull of the one", "report": "graph", "order": 2}, "two": {"report": "table", "order": 1},
            "three": {"report": "no"}, "four": {"report": "no", "utilisation": "a half over the whole"}})
        words = self.words(path)
        self.assertIn("Pull of the one along riser", words)
        self.assertIn("Pull of the one of riser at stations", words)
        self.assertIn("riser pull of the one kN", words)
        self.assertIn("riser two kN", words)
        self.assertLess(words.index("riser two kN"), words.index("riser pull of the one kN"))
        self.assertNotIn("Two along riser", words)
        self.assertNotIn("three", words.split("Case file")[0].lower())
        self.assertIn("Largest a half over the whole", words)

    def test_stages_of_statics(self):
        pull = np.outer([1e3, 2e3, 3e3, 4e3], np.ones(len(ARC)))
        path = results_file(self.folder / "stages.h5", (-2.0, -1.0, 0.0, 5.0), {"riser": ARC}, {"effective_tension": ("N", pull)},
                            stages=("hanging", "lowered", "in the current"))
        results = Results(path)
        np.testing.assert_array_equal(results.time, [0, 5])
        np.testing.assert_array_equal(results.field("effective_tension", results.lines[0]), pull[2:])
        self.assertEqual(results.field("effective_tension", results.lines[0], 0)[0], 3e3)
        self.assertEqual(Results(path, 1).field("effective_tension", results.lines[0]).tolist(), pull[1:2].tolist())
        words = self.words(path)
        self.assertIn("Stages of statics", words)
        for k, name in enumerate(results.stages):
            self.assertIn(f"Stage {name}, from the side", words)
            self.assertIn(f"riser A {0:g} {0:g} {0:g} {k + 1:g}", words)
        # A run whose second stage found no equilibrium: existing data are shown.
        stopped = results_file(self.folder / "stopped.h5", (-2.0,), {"riser": ARC}, {"effective_tension": ("N", pull[:1])},
                               stages=results.stages)
        np.testing.assert_array_equal(Results(stopped).time, [-2])

    def test_clearances_and_input(self):
        gap = np.stack([1 + np.cos(TIME), TIME, 0 * TIME], axis=1)
        path = self.file(series=(TIME, {"to the hull": (["clearance", "arc_length", "other_arc_length"], ["m"] * 3, gap)}))
        words = self.words(path)
        k = int(np.argmin(gap[:, 0]))
        self.assertIn(f"to the hull {gap[k, 0]:.4g} {TIME[k]:.3f} {TIME[k]:.3f}", words)
        self.assertIn("environment value water.depth 50", words)
        self.assertIn("riser 1 60 m wall anchored at [0, 0, -10] free 2 40 m bar", words)

    def test_input_spells_out_pipes_and_found_lengths(self):
        case = CASE.replace("wall_thickness: 0.02}", "wall_thickness: 0.02, coatings: [{thickness: 3 mm, density: 900}, "
                            "{thickness: 40 mm, density: 700}]}")
        case = case.replace("length: 60}", "length: 45}").replace("end_b: free}", "end_b: free, target: {tension: 1e5, at: end_a}}")
        results = Results(self.file(case=case))
        head, rows = inputs.line_types(results)
        self.assertEqual(head, ["key", "wall", "bar"])
        table = {row[0]: row[1:] for row in rows}
        self.assertEqual(table["pipe.outer_diameter"], ["300 mm", ""])
        self.assertEqual(table["pipe.wall_thickness"], ["0.02", ""])
        self.assertEqual(table["pipe.coatings"], ["thickness 3 mm, density 900; thickness 40 mm, density 700", ""])
        self.assertEqual(table["contents.pressure"], ["10 MPa", ""])
        self.assertEqual(table["EA"][0], "")
        self.assertNotIn("table", str(rows))
        _, rows = inputs.sections(results)
        self.assertEqual([row[2] for row in rows], ["60 m found by the target (given: 45 m)", "40 m"])
        self.assertIn("60 m found by the target", self.words(results.path))

    def test_laid_lengths(self):
        values = np.stack([TIME, 12.34 + TIME], axis=1)[:, None]
        touchdown = {"touchdown": (["end_a_arc_length", "laid_length"], ["m", "m"], values)}
        force = np.zeros((len(TIME), len(ARC), 3))
        force[:, 3:8, 2] = 1  # nodes every 2 m
        path = self.file(series=(TIME, touchdown))
        with h5py.File(path, "a") as file:
            file["fields/seabed_force"] = force
        head, rows = tables.of_lines(Results(path))
        self.assertEqual(dict(zip(head, rows[0]))["on the seabed at the start [m]"], 12.34)
        self.assertEqual(dict(zip(head, rows[0]))["at the end [m]"], 12.34 + TIME[-1])
        with h5py.File(path, "a") as file:
            del file["line_series/touchdown"]
        self.assertAlmostEqual(tables.of_lines(Results(path))[1][0][4], 8.0)

    def test_statistics_state_from_when(self):
        # A history at a node with every fourth step: the statistics over every step are used.
        case = CASE + "  histories: [{line: riser, at: 20, name: here}, {line: riser, at: 21, name: between}]\n"
        case = case.replace("output: {statistics_from: 4 s}", "output:\n  statistics_from: 4 s")
        few = TIME[::4]
        columns = ["effective_tension", "position_z"]
        values = np.stack([1e5 * (2 + np.sin(few)), np.cos(few)], axis=1)
        path = self.file(case=case, series=(few, {name: (columns, ["N", "m"], values) for name in ("here", "between")}))
        code, _, err = self.run_("export", path, "-o", self.folder / "csv")
        self.assertEqual(code, 0, err)

        def rows(folder):
            with (self.folder / folder / "statistics.csv").open() as file:
                return {(r["history"], r["quantity"]): r for r in csv.DictReader(file)}

        found = rows("csv")
        self.assertEqual({r["from [s]"] for r in found.values()}, {"4"})
        self.assertEqual(float(found["here", "effective tension"]["maximum"]), float(f"{self.tension[:, 10].max() + 5e3:.9g}"))
        self.assertEqual(float(found["here", "effective tension"]["mean"]), float(f"{self.tension[:, 10].mean():.9g}"))
        late = few >= 4
        for key, column in ((("between", "effective tension"), 0), (("here", "position z"), 1)):
            self.assertAlmostEqual(float(found[key]["maximum"]) / values[late, column].max(), 1, places=7)
        code, _, err = self.run_("export", path, "-o", self.folder / "later", "--since", "9")
        self.assertEqual(code, 0, err)
        found = rows("later")
        self.assertEqual({r["from [s]"] for r in found.values()}, {"9"})
        self.assertAlmostEqual(float(found["here", "effective tension"]["maximum"]) / values[few >= 9, 0].max(), 1, places=7)
        with (self.folder / "later/range_riser.csv").open() as file:
            most = [float(r["effective_tension_max [N]"]) for r in csv.DictReader(file)]
        np.testing.assert_allclose(most, self.tension[TIME >= 9].max(axis=0), rtol=1e-8)

    def test_figures_of_many_histories_are_limited(self):
        columns = [f"quantity_{k}" for k in range(20)]
        values = np.sin(TIME)[:, None] * np.arange(1, 21)
        path = self.file(series=(TIME, {f"place {k:02d}": (columns, ["N"] * 20, values) for k in range(9)}))
        code, _, err = self.run_("report", path, "-o", self.folder / "many.html")
        self.assertEqual(code, 0, err)
        page = (self.folder / "many.html").read_text()
        self.assertIn("Figures show the first 3 of 9 histories by name", page)
        self.assertEqual(page.count(", every step.</figcaption>"), 60)

    def test_options_that_would_be_ignored(self):
        path = self.file(series=(TIME, {"here": (["effective_tension"], ["N"], TIME[:, None])}))
        for arguments, part in ((["plot", path, "stress", "--time", "3"], "the figure 'stress' does not use --time (it uses --line, "
                                 "--outer-diameter, --since, --wall)"),
                                (["plot", path, "plan", "--since", "3"], "the figure 'plan' does not use --since (it uses --time)"),
                                (["plot", path, "history", "--over", "x"], "does not use --over"),
                                (["plot", path, "range", "--name", "here"], "does not use --name"),
                                (["plot", path, "plan", "--time", "99"], "there is no output at --time 99 (they are from 0 to 19.5)"),
                                (["plot", path, "range", "--since", "-5"], "--since: '-5' is not a time of 0 s or more (see hawser plot"),
                                (["report", path, "--since", "-5"], "--since: '-5' is not a time of 0 s or more"),
                                (["report", path, "--since", "nan"], "--since: 'nan' is not a time of 0 s or more"),
                                (["report", path, "--since", "50"], "it has no output from t = 50 s on (the last one is at 19.5 s)"),
                                (["export", path, "--since", "50"], "it has no output from t = 50 s on"),
                                (["extremes", path, "--since", "50"], "it has no output from t = 50 s on"),
                                (["fatigue", path, "--curve", "dnv-d-air", "--since", "50"], "it has no output from t = 50 s on")):
            with self.subTest(arguments=arguments[0::2]):
                output = self.folder / ("none.csv" if arguments[0] in ("extremes", "fatigue") else "none.svg")
                code, out, err = self.run_(*arguments, "-o", output)
                self.assertEqual((code, out), (2, ""))
                self.assertEqual(len(err.splitlines()), 1, err)
                self.assertIn(part, err)
                self.assertFalse(output.exists())

    def test_reactions_of_supports(self):
        push = 1000 + 100 * np.sin(TIME)
        columns = ["force_x", "force_y", "force_z"] + [f"{r}_force_{k}" for r in ("below", "left") for k in "xyz"] + ["height",
                                                                                                                   "offset"]
        rows = np.zeros((len(TIME), len(columns)))
        rows[:, 2], rows[:, 5], rows[:, 6] = 0.8 * push, 0.8 * push, 0.6 * push
        rows[:, 0], rows[:, 9] = 0.6 * push, -0.001 * push
        units = ["N"] * 9 + ["m"] * 2
        path = self.file(series=(TIME, {"ramp 10": (columns, units, rows), "ramp 9": (columns, units, 2 * rows)}))
        head, table = tables.supports(Results(path))
        self.assertEqual([row[0] for row in table], ["ramp 9", "ramp 10"])
        low, high = int(np.argmin(push)), int(np.argmax(push))
        for row, factor in zip(table, (2, 1)):
            expected = [factor * push[0], factor * push[low], TIME[low], factor * push[high], TIME[high],
                        0.8 * factor * push[high]]
            np.testing.assert_allclose(row[1:7], expected)
            self.assertEqual(row[7], "below")
            self.assertAlmostEqual(row[8], -0.001 * factor * push[low])
        self.assertIn("Reactions of roller boxes on the line", self.words(path))

    def test_modes_need_a_case(self):
        code, _, err = self.run_("report", self.file(), "--modes")
        self.assertEqual(code, 2)
        self.assertIn("--modes requires a case file", err)


class Seas(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def sea(self, case, waves=None):
        path = results_file(self.folder / "sea.h5", case=case)
        if waves is not None:
            with h5py.File(path, "a") as file:
                file["waves/components"], file["waves/level"], file["waves/ramp"] = waves, [0.5], [10.0]
        return Sea(Results(path))

    def test_waves(self):
        sea = self.sea("environment: {water: {depth: 50}}", [[2, 0.5, 0.03, 0, 1, 0.3], [1, 0.8, 0.06, 1, 0, 0]])
        exact = 0.5 + 2 * np.cos(0.03 * 7 - 0.5 * 20 + 0.3) + np.cos(0.06 * 4 - 0.8 * 20)
        self.assertAlmostEqual(float(sea.surface(4.0, 7.0, 20.0)), exact, places=12)
        self.assertAlmostEqual(float(sea.surface(4.0, 7.0, 0.0)), 0.5)
        self.assertFalse(sea.still)

    def test_beds(self):
        flat = self.sea("environment: {water: {depth: 30 m}, seabed: {friction: 0.5}}")
        self.assertEqual((flat.level, float(flat.seabed(3.0, 4.0)), flat.still), (0.0, -30.0, True))
        slope = self.sea("environment: {seabed: {depth: 30, slope_deg: 5, slope_direction_deg: 90}}")
        self.assertIsNone(slope.level)
        self.assertAlmostEqual(float(slope.seabed(3.0, 10.0)), -30 - 10 * np.tan(np.radians(5)))
        write(self.folder, "bed.xyz", "# x y z\n0 0 -10\n10 0 -12\n0 10 -14\n10 10 -16\n")
        grid = self.sea("environment: {seabed: {grid: {file: bed.xyz}}}")
        self.assertAlmostEqual(float(grid.seabed(5.0, 5.0)), -13)
        self.assertTrue(np.isnan(grid.seabed(50.0, 5.0)))
        self.assertFalse(self.sea("environment: {seabed: {grid: {file: none.xyz}}}").bed)


if __name__ == "__main__":
    unittest.main()
