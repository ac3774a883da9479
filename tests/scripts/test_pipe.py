"""hawser pipe: reading of the program's checks, and a typical lay."""
import csv
import os
import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

from support import ROOT, run
from synthetic import results_file

sys.path.insert(0, str(ROOT / "scripts"))
from hawser_post import lay, lay_rig, lay_search, laying, pipe_checks, pipe_tables, stations  # noqa: E402
from hawser_post.results import Results  # noqa: E402

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))


class Parts(unittest.TestCase):
    """Lines without supports, and results without a state at rest."""
    case = """hawser: 1
environment: {seabed: {depth: 50}}
line_types:
  steel: {pipe: {outer_diameter: 0.3, wall_thickness: 0.02, grade: X65}%s}
lines:
  riser: {sections: [{type: steel, length: 100, elements: 10}]}
%s"""

    def results(self, upper="a", kind="", more="", time=(0.0, 1.0), name="riser.h5", moment=1e5,
                codes=("dnv_local_buckling", "api_bending_pressure", "api_tension_pressure")):
        """A line with its last 20 m on the bed."""
        folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        way = np.linspace(0, 100, 11) if upper == "a" else np.linspace(100, 0, 11)
        x = np.zeros((len(time), 11, 3))
        x[:, :, 0], x[:, :, 2] = way, np.maximum(-50.0, -way * 50 / 80)
        columns = [f"end_{k}_{what}" for k in "ab" for what in ("arc_length", "position_x", "position_y", "position_z")]
        down = [80.0 if upper == "a" else 20.0, 80.0, 0.0, -50.0]
        other = [100.0, 100.0, 0.0, -50.0] if upper == "a" else [0.0, 100.0, 0.0, -50.0]
        row = down + other if upper == "a" else other + down
        size = len(time)
        fields = {"position": ("m", x), "effective_tension": ("N", np.full((size, 11), 1e5)),
                  "curvature": ("1/m", np.full((size, 11), 1e-3))}
        for k, value in (("bending_moment", moment), ("bending_moment_2", moment), ("bending_moment_3", 0.0),
                         ("torsion_moment", 0.0)):
            fields[k] = ("N m", np.full((size, 11), value))
        for k, code in enumerate(codes):
            fields[code] = ("1", np.full((size, 11), 0.8 + 0.2 * (k > 0)))
        return Results(results_file(folder / name, time=time, lines={"riser": np.linspace(0, 100, 11)}, fields=fields,
                                    series=(np.array(time), {"touchdown": (columns, ["m"] * 8, np.array([[row]] * size))}),
                                    case=self.case % (kind, more)))

    def test_no_overbend_without_supports(self):
        for upper in "ab":
            results = self.results(upper)
            checked = pipe_checks.of_case(results, results.lines[0])
            expected = np.array([1] * 9 + [2] * 2)
            np.testing.assert_array_equal(checked.part, [expected if upper == "a" else expected[::-1]] * 2)

    def test_what_is_at_rest(self):
        for results, still in ((self.results(), 1e5), (self.results(time=(30.0, 31.0)), ""),
                               (self.results(more="statics: false\n", codes=("api_bending_pressure", "api_tension_pressure")), "")):
            checked = pipe_checks.of_case(results, results.lines[0])
            _, rows = pipe_tables.checks(checked, 0.0)
            moment = next(row for row in rows if row[1] == "bending moment [N m]")
            self.assertEqual(moment[2:4], [still, 1e5])
            done = run(HAWSER, "pipe", results.path)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual("no check by DNV-ST-F101" in done.stdout, not results.has("dnv_local_buckling"))

    def test_checks_are_those_of_the_program(self):
        results = self.results()
        done = run(HAWSER, "pipe", results.path)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"sagbend\s+local buckling, DNV-ST-F101\s+0.8\s+0.8 ")
        self.assertRegex(done.stdout, r"seabed\s+bending and pressure, API RP 1111\s+1\s+1 ")
        without = self.results(codes=())
        done = run(HAWSER, "pipe", without.path)
        self.assertEqual(done.returncode, 2)
        self.assertIn("does not give the steel of 'riser': give its pipe a 'grade', and run it", done.stderr)

    def test_what_they_are_by(self):
        results = self.results()
        conditions = pipe_checks.of_case(results, results.lines[0]).description()[1]
        self.assertIn("safety class low, alpha_U 0.96, gamma_C of functional loads: supports 1, span 1, seabed 1.", conditions)
        results.keys["environment"]["seabed"] = {"grid": {"file": "bed.txt"}}
        results.keys["line_types"]["steel"]["pipe"].update(safety_class="high", condition_factor={"supports": 0.8})
        conditions = pipe_checks.of_case(results, results.lines[0]).description()[1]
        self.assertIn("safety class high, alpha_U 0.96, gamma_C of functional loads: supports 0.8, span 1, seabed 1.07; uneven seabed",
                      conditions)

    def test_stress_beyond_yield_gives_a_warning(self):
        def warnings(**more):
            results = self.results(**more)
            return pipe_checks.warnings(pipe_checks.of_case(results, results.lines[0]))
        self.assertEqual(warnings(), [])
        self.assertIn("above the yield stress of 450 MPa, but the pipe is elastic", warnings(moment=1e6)[0])
        self.assertIn("has 'plasticity': its von Mises stress is that of an elastic section",
                      warnings(kind=", plasticity: {ramberg_osgood: {yield_moment: 5e5, A: 0.4, B: 12}}")[0])


class Departing(unittest.TestCase):
    def lay(self, forwards, case="hawser: 1\n", stock=0):
        """Supports at 10 and 20 m of a line that descends from there to the bed; the second carries it at the first
        output. Arc lengths begin at the stock if end A is fed."""
        arc = np.linspace(0, 100, 101)
        x = np.zeros((2, 101, 3))
        way = np.maximum(arc - stock, 0) if forwards else arc[::-1]
        x[:, :, 0] = way
        x[:, :, 2] = np.where(way < 50, -way**2 / 100, -25 - np.sqrt(np.maximum(way - 50, 0)) * 2)
        columns = ["force_x", "force_y", "force_z", "below_force_x", "below_force_y", "below_force_z", "height", "offset",
                   "arc_length"]
        rows = {f"ramp {k + 1}": (columns, ["N"] * 6 + ["m"] * 3,
                                  np.array([[0, 0, f, 0, 0, f, h, 0, s + stock if forwards else 100 - s] for f, h in loads]))
                for k, (s, loads) in enumerate(((10, ((1e3, 0), (2e3, 0))), (20, ((5e2, -0.01), (0, 0.3)))))}
        folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        return Results(results_file(folder / "lay.h5", time=(0.0, 1.0), lines={"pipe": arc}, fields={"position": ("m", x)},
                                    series=(np.array([0.0, 1.0]), rows), case=case))

    def test_lift_off(self):
        for forwards in (True, False):
            results = self.lay(forwards)
            left = laying.departure(results, results.lines[0])
            self.assertEqual((left.forwards, left.support, left.tip), (forwards, ["ramp 2", "ramp 1"], "ramp 2"))
            np.testing.assert_allclose(left.arc, [20, 10] if forwards else [80, 90])
            np.testing.assert_allclose(left.angle, np.degrees(np.arctan([0.4, 0.2])), atol=0.7)
            np.testing.assert_allclose(left.tip_clearance, [-0.01, 0.3])
            # The steepest point is just beyond 50 m.
            bend = laying.inflection(results, results.lines[0], left, None)
            np.testing.assert_allclose(bend, 50.5 if forwards else 49.5)

    def test_a_fed_line_leaves_from_its_feeder(self):
        # 45 of its 100 m are in the stock, and the supports are nearer to its other end.
        case = "hawser: 1\nlines: {pipe: {end_a: {anchor: [0, 0, 0], feed: {stock: 45, speed: 1}}}}\n"
        results = self.lay(True, case, stock=45)
        left = laying.departure(results, results.lines[0])
        self.assertEqual((left.forwards, left.support, left.tip), (True, ["ramp 2", "ramp 1"], "ramp 2"))
        np.testing.assert_allclose(left.angle, np.degrees(np.arctan([0.4, 0.2])), atol=0.7)

    def test_no_supports(self):
        folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        results = Results(results_file(folder / "none.h5"))
        self.assertIsNone(laying.departure(results, results.lines[0]))


class Stations(unittest.TestCase):
    def results(self, end, ended=True):
        """A line of 0, 4 and 10 m whose last station from the feeder was never reached."""
        def of(values):
            table = np.array([[v - 1, 1.0, v, 2.0, v - 0.5, 0.1] for v in values])
            return table if end == "end_a" else table[::-1]
        none = float("nan")
        folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        case = f"hawser: 1\nlines: {{line: {{{end}: {{anchor: [0, 0, 0], feed: {{stock: 5, speed: 1}}}}}}}}\n"
        return Results(results_file(
            folder / "fed.h5", lines={"line": np.array([0.0, 4.0, 10.0])}, case=case, ended=ended,
            statistics={"bending_moment_at_stations": ("N m", of([3e3, 9e3, none])),
                        "curvature_at_stations": ("1/m", of([0.01, 0.02, none]))}))

    def test_they_count_from_the_feeder(self):
        for end, places in (("end_a", [0, 4]), ("end_b", [0, 6])):
            results = self.results(end)
            distance, found = stations.of_line(results, results.lines[0])
            np.testing.assert_allclose(distance, places)
            np.testing.assert_allclose(found["bending_moment"][:, 2], [3e3, 9e3])
            _, rows = stations.table(results, results.lines[0], 0.2)
            self.assertEqual(rows[0], ["bending moment [kN m]", 2.999, 9.0, 2.0, float(places[1])])
            self.assertAlmostEqual(rows[1][2], 0.2)  # % of strain: 100 · 0.02 · 0.2 / 2
            head, lines = stations.columns(results, results.lines[0], 0.2)
            self.assertEqual(head[:2], ["distance_from_feeder [m]", "least bending moment [N m]"])
            self.assertEqual(len(lines), 2)

    def test_where_there_are_none(self):
        results = self.results("end_a", ended=False)
        self.assertIsNone(stations.of_line(results, results.lines[0]))
        results = self.results("end_c")
        self.assertIsNone(stations.table(results, results.lines[0], 0.2))


class Searching(unittest.TestCase):
    asked = lay_search.Asked(0.3, 0.8)

    def search(self, lay_at):
        """Result of a search that starts with 10 kN at the bottom, where the tension is 40 kN less than at
        the top; and the tensions tried."""
        tried = []

        def trial(bottom):
            tried.append(bottom)
            return lay_at(bottom)
        return (*lay_search.smallest(trial, self.asked, 1e4, 4e4), tried)

    def test_between_one_that_keeps_and_one_that_does_not(self):
        for edge in (317e3, 4e3, 10.01e3):  # above, below and beside the start of the search
            keeps, fails, _ = self.search(lambda t: lay_search.Lay(t + 4e4, [], 0.3 + (t - edge) * 1e-6, 0.1))
            self.assertLess(fails[0], edge)
            self.assertGreaterEqual(keeps[0], edge)
            self.assertLessEqual(keeps[0] - fails[0], 0.005 * (keeps[0] + 4e4))

    def test_what_is_not_computed_is_not_kept_to(self):
        def lay_at(t):
            if t < 15e3:
                return None
            return lay_search.Lay(t, [], 1.0, np.nan if t < 25e3 else 0.1)
        keeps, fails, tried = self.search(lay_at)
        self.assertAlmostEqual(keeps[0], 25e3, delta=0.005 * 65e3)
        self.assertGreaterEqual(keeps[0], 25e3)
        self.assertIn(10e3, tried)
        self.assertEqual(self.asked.missed(lay_search.Lay(1.0, [], np.nan, np.nan)), "clearance at the tip too small, no sagbend to check")
        self.assertEqual(self.asked.missed(None), "no equilibrium")

    def test_neither(self):
        keeps, fails, tried = self.search(lambda t: lay_search.Lay(t, [], 0.0, 0.1))
        self.assertIsNone(keeps)
        self.assertAlmostEqual(max(tried), 1024e4)
        keeps, fails, tried = self.search(lambda t: lay_search.Lay(t, [], 1.0, 0.1))
        self.assertIsNone(fails)
        self.assertAlmostEqual(min(tried), 1e4 / 1024)


class Lay(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        shutil.copy(ROOT / "cases/s-lay/simple.yaml", cls.folder)
        cls.case = cls.folder / "simple.yaml"
        made = run(HAWSER, "run", cls.case, "-q", "--set", "dynamics.duration=1")
        assert made.returncode == 0, made.stderr
        cls.path = cls.folder / "simple.h5"

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def pipe(self, *words):
        done = run(HAWSER, "pipe", self.path, *words)
        return done.returncode, done.stdout, done.stderr

    def test_at_rest(self):
        code, out, err = self.pipe()
        self.assertEqual((code, err), (0, ""))
        def static(words):
            return float(re.search(rf"{re.escape(words)}\s+(\S+)", out).group(1))
        results = Results(self.path)
        line = results.lines[0]
        moment = results.field("bending_moment", line, 0)
        # The row of equal rollers on a stinger of 151.325 m: cases/s-lay/README.md.
        self.assertAlmostEqual(static("overbend  bending moment [kN m]"), moment.max() / 1e3, delta=0.1)
        self.assertAlmostEqual(static("overbend  bending strain [%]"),
                               100 * moment.max() / 16272.6e3 * 0.125, delta=1e-3 * 0.114)
        # By hand at the node of largest bending: f_y 432 MPa, M_p 357.9 kN m, alpha_c 1.0909, S_p 4784 kN,
        # combination a.
        node = int(np.argmax(moment))
        tension = results.field("effective_tension", line, 0)[node]
        share = 1.196 * 1.2 / 1.0909 * np.array([moment[node] / 357.9e3, tension / 4784.0e3])
        self.assertAlmostEqual(static("overbend  local buckling, DNV-ST-F101"), (share[0] + share[1] ** 2) ** 2, delta=2e-3)
        self.assertAlmostEqual(static("overbend  overbend strain at rest, DNV simplified I"),
                               moment.max() / 16272.6e3 * 0.125 / 0.0025, delta=2e-3)
        # Lift-off: the last of eleven boxes, where the line slope slightly exceeds that of the stinger.
        self.assertAlmostEqual(static("arc length of lift-off [m]"), 104.7, delta=0.3)
        self.assertAlmostEqual(static("departure angle below the horizontal [deg]"), np.degrees(84 / 150), delta=0.6)
        self.assertAlmostEqual(static("top tension [kN]"), 151.85, delta=0.1)
        touch = results.series("pipe touchdown").column("end_a_arc_length")[0]
        self.assertAlmostEqual(static("arc length of touchdown [m]"), touch, delta=0.1)
        with open(self.folder / "simple-pipe.csv", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), len(line.arc))
        largest = max(float(row["bending moment [N m]"]) for row in rows)
        self.assertAlmostEqual(largest, results.field("bending_moment", line).max(), delta=1e-6 * largest)

    def test_stronger_steel_and_higher_class(self):
        def worst(*pipe):
            path = self.folder / "judged.h5"
            made = run(HAWSER, "run", self.case, "-q", "-o", path, "--set", "dynamics=null",
                       *(word for key in pipe for word in ("--set", f"line_types.pipe.pipe.{key}")))
            self.assertEqual(made.returncode, 0, made.stderr)
            results = Results(path)
            checked = pipe_checks.of_case(results, results.lines[0])
            # Utilisations at rest of the parts, and the largest at nodes well between the first and last box.
            boxes = [results.series(f"stinger {k}").column("arc_length")[0] for k in (1, 11)]
            line = results.lines[0]
            inside = (line.arc > min(boxes) + 5) & (line.arc < max(boxes) - 5)
            return [*(checked.static(pipe_checks.BUCKLING, k) for k in range(3)),
                    np.nanmax(results.field("dnv_local_buckling", line, 0)[inside])]
        usual = worst()
        self.assertLess(worst("grade=X70")[0], usual[0])
        self.assertGreater(worst("safety_class=high")[0], usual[0])
        # gamma_C on the stinger alone changes the moment's part by its square, and hardly the tension's part.
        stinger = worst("condition_factor={supports: 0.8}")
        self.assertAlmostEqual(stinger[3] / usual[3], 0.64, delta=0.01)
        self.assertAlmostEqual(stinger[1], usual[1], delta=1e-6)

    def test_every_step(self):
        code, out, err = self.pipe()
        self.assertEqual((code, err), (0, ""))
        steps = float(re.search(r"every step +largest.*\n +local buckling, DNV-ST-F101 +(\S+)", out).group(1))
        results = Results(self.path)
        outputs = np.nanmax(results.field("dnv_local_buckling", results.lines[0]))
        self.assertGreaterEqual(steps, outputs * (1 - 1e-3))
        self.assertLess(steps, 1.5 * outputs)

    def test_in_the_report(self):
        done = run(HAWSER, "report", self.path)
        self.assertEqual(done.returncode, 0, done.stderr)
        text = (self.folder / "simple.html").read_text("utf-8")
        self.assertIn("Strength of pipe", text)
        self.assertIn("local buckling, DNV-ST-F101", text)

    @unittest.skipUnless(os.environ.get("HAWSER_FULL"), "takes half a minute; set HAWSER_FULL to run it")
    def test_a_lay_table(self):
        table = self.folder / "table.csv"
        done = run(HAWSER, "lay", self.case, "--depths", "90", "--clearance", "0.2", "-o", table)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(table, encoding="utf-8") as file:
            row = {key: float(value) for key, value in next(csv.DictReader(file)).items()}
        self.assertTrue(table.with_suffix(".png").is_file())
        # The tension is the smallest: the pipe clears the tip by little more than required.
        self.assertGreaterEqual(row["tip clearance [m]"], 0.2)
        self.assertLess(row["tip clearance [m]"], 0.23)
        # The tension decreases by the weight over the descent, in air and under water.
        self.assertAlmostEqual(row["tension [N]"] - row["tension at touchdown [N]"], 359.09 * (90 - 0.125) + 852.5 * 10.325,
                               delta=200)
        # A case with that tension as its target has the same lay.
        anchor = -549.9 - (row["layback [m]"] - 329.7)
        again = self.folder / "again.h5"
        made = run(HAWSER, "run", self.case, "-q", "-o", again, "--set", "dynamics=null", "--set", "environment.seabed.depth=90",
                   "--set", f"lines.pipe.end_b.anchor=[{anchor}, 0, -89.875]", "--set", "lines.pipe.sections[1].length=260", "--set",
                   f"lines.pipe.target={{tension: {row['tension [N]']:.9g}, at: end_a, section: 2, between: [50, 800]}}")
        self.assertEqual(made.returncode, 0, made.stderr)
        results = Results(again)
        self.assertAlmostEqual(float(results.series("stinger 11").column("height")[0]), row["tip clearance [m]"], delta=0.01)

    @unittest.skipUnless(os.environ.get("HAWSER_FULL"), "takes half a minute; set HAWSER_FULL to run it")
    def test_radii_of_the_stinger(self):
        table = self.folder / "radii.csv"
        done = run(HAWSER, "lay", self.case, "--depths", "90", "--radii", "100,60", "-o", table, "--set",
                   "lines.pipe.sections[0].element_length=1")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(table, encoding="utf-8") as file:
            rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
        self.assertEqual([row["stinger radius [m]"] for row in rows], [60, 100])
        for row in rows:
            # The mean overbend curvature is that of the stinger, 1.325 m above its path, where X65 allows
            # 0.25 %.
            self.assertGreater(row["overbend strain [%]"], 100 * 0.125 / (row["stinger radius [m]"] + 1.325))
            self.assertLess(row["overbend strain [%]"], 1.4 * 100 * 0.125 / (row["stinger radius [m]"] + 1.325))
            self.assertAlmostEqual(row["overbend strain, DNV simplified I [-]"], row["overbend strain [%]"] / 0.25, delta=1e-6)
        # It clears the last box by 0.3 m and rests on the last but one, 72 m along the arc.
        self.assertAlmostEqual(rows[1]["departure angle [deg]"], np.degrees(72 / 100), delta=1)
        self.assertGreater(rows[0]["overbend local buckling [-]"], 1)
        self.assertIn(f"In 90 m of water 100 m is the smallest of these radii with an overbend utilisation of at most 1 ("
                      f"{rows[1]['overbend strain, DNV simplified I [-]']:.3g}), with {rows[1]['tension [N]'] / 1e3:.4g} kN.",
                      done.stdout)

    def test_the_smallest_radius_that_spares_the_overbend(self):
        def laid(tension, overbend):
            return lay_search.Lay(tension, [], 0.3, 0.1, overbend)
        found = [(50, 80, laid(1e5, 0.9)), (50, 100, laid(2e5, 0.6)), (50, 120, laid(3e5, 0.5)), (70, 80, None),
                 (70, 100, laid(3e5, np.nan))]
        output = list(lay.chosen(found, 0.7))
        self.assertEqual(output[0], "In 50 m of water 100 m is the smallest of these radii with an overbend utilisation of at most 0.7 (0.6), "
                                  "with 200 kN.")
        self.assertIn("In 70 m of water no lay of these radii", output[1])

    def test_elements_keep_their_length(self):
        with tempfile.TemporaryDirectory() as folder:
            rig = lay_rig.Rig(self.case, ["lines.pipe.sections[1].element_length=null", "lines.pipe.sections[1].elements=41"], folder)
        changed = dict(change.rsplit("=", 1) for change in rig.changes_at(200, 3e5))
        length, count = (float(changed[f"lines.pipe.sections[1].{key}"]) for key in ("length", "elements"))
        self.assertGreater(length, 400)
        self.assertLessEqual(length / count, 5)
        self.assertGreater(length / (count - 1), 5)

    def test_lays_that_cannot_be(self):
        slope = run(HAWSER, "lay", self.case, "--depths=90", "--set", "environment.seabed.slope_deg=0.02")
        self.assertEqual(slope.returncode, 2, slope.stderr)
        self.assertIn("lays at several depths need a level seabed: 'slope_deg' of this one is 0.02", slope.stderr)
        for words, part in ((["--depths", "50;60"], "--depths '50;60' is not a list of numbers separated by commas"),
                            (["--depths", "-5"], "depths must be above 0, in m"),
                            (["--depths", "90", "--utilisation", "2"], "--utilisation 2 is not above 0 and up to 1"),
                            (["--depths", "90", "--radii", "0,80"], "--radii '0,80': radii must be above 0, in m"),
                            (["--depths", "90", "--radii", "80", "--set", "supports.stinger.path.segments=[{length: 20}, "
                              "{length: 60, radius: 150}, {length: 40, radius: 150}]"],
                             "--radii needs supports with one curved length in their path, fixed to a body or in space; "
                             "this case has 2: change them by --set")):
            done = run(HAWSER, "lay", self.case, f"{words[0]}={words[1]}", *words[2:])
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(part, done.stderr)
        moored = run(HAWSER, "lay", ROOT / "cases/mooring-line/mooring-line.yaml", "--depths=50")
        self.assertEqual(moored.returncode, 2, moored.stderr)
        self.assertIn("no line has a type with 'pipe'", moored.stderr)

    def test_refusals(self):
        plain = results_file(self.folder / "plain.h5")
        code, out, err = self.pipe("--line", "hose")
        self.assertEqual((code, out), (2, ""), err)
        self.assertIn("there is no line 'hose' (there are: pipe)", err)
        self.assertEqual(len(err.splitlines()), 1)
        done = run(HAWSER, "pipe", plain)
        self.assertEqual(done.returncode, 2)
        self.assertIn("no line has a type with 'pipe', whose wall could be checked", done.stderr)


if __name__ == "__main__":
    unittest.main()
