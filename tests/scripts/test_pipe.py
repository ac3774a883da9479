"""hawser pipe: formulas of codes against what others publish and against their definitions, and a lay as a user checks it."""
import csv
import os
import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
from scipy import optimize

from support import ROOT, run
from synthetic import results_file

sys.path.insert(0, str(ROOT / "scripts"))
from hawser_post import lay, lay_rig, lay_search, laying, pipe_checks, pipe_codes, pipe_tables, stations  # noqa: E402
from hawser_post.results import Refusal, Results  # noqa: E402

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))


class Codes(unittest.TestCase):
    """A 16 in pipe of X65, wall 21 mm."""
    outer, wall = 0.4064, 0.021

    def steel(self, **more):
        return pipe_codes.Steel(*pipe_codes.GRADES["X65"], **{"material_factor": 1.0, **more})

    def test_moment_capacity(self):
        # alpha_c M_p / (1.15 · 1.0 · 1.2 · 0.8) = 1379.9 kN m: an engineer's sheet for this pipe (DNV-ST-F101, 5.21 and
        # 5.22), seamless, on a stinger (gamma_SC,LB 1, gamma_C 0.8).
        steel = self.steel()
        _, bending = pipe_codes.plastic(steel, self.outer, self.wall)
        capacity = pipe_codes.flow_stress_factor(steel, self.outer / self.wall) * bending
        self.assertAlmostEqual(capacity / (1.15 * 1.2 * 0.8) / 1e3, 1379.9, delta=0.05)
        # What uses it up alone: the check is the square of the moment's share.
        moment = capacity / (1.15 * 1.04)
        self.assertAlmostEqual(float(pipe_codes.local_buckling(steel, self.outer, self.wall, moment, 0.0, 0.0, 0.0)), 1, 12)
        self.assertAlmostEqual(
            float(pipe_codes.local_buckling(steel, self.outer, self.wall, moment / 2, 0.0, 0.0, 0.0)), 0.25, 12)

    def test_collapse_pressure(self):
        for outer, wall in ((0.4064, 0.021), (0.9144, 0.02), (0.1524, 0.015)):
            for kind, share in (("seamless", 1.0), ("UOE", 0.85)):
                steel = self.steel(fabrication=kind, ovality=0.01)
                elastic = 2 * 207e9 * (wall / outer) ** 3 / (1 - 0.09)
                yields = 450e6 * share * 2 * wall / outer

                def equation(p):
                    return (p - elastic) * (p * p - yields * yields) - p * elastic * yields * 0.01 * outer / wall
                expected = optimize.brentq(equation, 0, min(elastic, yields))
                self.assertAlmostEqual(pipe_codes.collapse_pressure(steel, outer, wall) / expected, 1, 9)

    def test_pressures_alone(self):
        steel = self.steel()
        collapse, burst = (f(steel, self.outer, self.wall) for f in (pipe_codes.collapse_pressure, pipe_codes.burst_pressure))
        check = pipe_codes.local_buckling(steel, self.outer, self.wall, 0.0, 0.0, collapse / (1.15 * 1.04), 0.0)
        self.assertAlmostEqual(float(check), 1, 12)
        # 2 t / (D - t) min(f_y, f_u / 1.15) 2 / sqrt 3 = 0.042 / 0.3854 · 450 · 1.1547 MPa.
        self.assertAlmostEqual(burst / 1e6, 56.627, delta=0.01)
        slender = self.outer / self.wall
        beta = (60 - slender) / 90
        capacity = 1 - beta + beta * 535 / 450
        for share, weaker in ((0.5, 1 - beta), (0.8, 1 - 3 * beta * 0.2)):
            inside = pipe_codes.local_buckling(steel, self.outer, self.wall, 0.0, 0.0, 0.0, share * burst)
            self.assertAlmostEqual(float(inside), (weaker * share / capacity) ** 2, 12)

    def test_tension_alone(self):
        steel = self.steel(safety_class="high")
        axial, _ = pipe_codes.plastic(steel, self.outer, self.wall)
        capacity = pipe_codes.flow_stress_factor(steel, self.outer / self.wall)
        check = pipe_codes.local_buckling(steel, self.outer, self.wall, 0.0, 0.3 * axial, 0.0, 0.0)
        self.assertAlmostEqual(float(check), (1.15 * 1.26 * 0.3 / capacity) ** 4, 12)
        # API: 0.6 of the yield tension is all.
        pulled = 450e6 * np.pi / 4 * (self.outer**2 - (self.outer - 2 * self.wall) ** 2)
        api = pipe_codes.api_tension_and_pressure(steel, self.outer, self.wall, 0.6 * pulled, 0.0, 0.0)
        self.assertAlmostEqual(float(api), 1, 12)

    def test_api_bending(self):
        steel = self.steel(ovality=0.01)
        strain = self.wall / (2 * self.outer) / 3.33 / 1.1  # 1 / (1 + 20 · 0.005)
        api = pipe_codes.api_bending_and_pressure(steel, self.outer, self.wall, strain, 0.0, 0.0)
        self.assertAlmostEqual(float(api), 1, 12)
        # Without bending it is the check of external pressure alone (4.3.2.1), whatever the ovality.
        elastic, yields = 2 * 207e9 * (self.wall / self.outer) ** 3 / 0.91, 2 * 450e6 * self.wall / self.outer
        for kind, share in (("UOE", 0.6), ("seamless", 0.7)):
            alone = share * yields * elastic / np.hypot(yields, elastic)
            for oval in (0.005, 0.03):
                pressed = pipe_codes.api_bending_and_pressure(self.steel(ovality=oval, fabrication=kind), self.outer, self.wall,
                                                              0.0, alone, 0.0)
                self.assertAlmostEqual(float(pressed), 1, 12)

    def test_functional_loads_that_relieve(self):
        # At rest 100 one way, and then 100 the other: by b 1.3 · 200 - 100 / 1.1, and not 1.3 · 200 - 1.1 · 100.
        b = pipe_codes.COMBINATIONS["b"]
        still, change = np.array([100.0, 0.0]), np.array([-200.0, 0.0])
        self.assertAlmostEqual(float(pipe_codes.design_load(b, still, change, 1.0)), 260 - 100 / 1.1, 9)
        self.assertAlmostEqual(float(pipe_codes.design_load(b, still, -change, 1.0)), 260 + 110, 9)
        # gamma_C is of functional loads only; at right angles nothing relieves.
        self.assertAlmostEqual(float(pipe_codes.design_load(b, still, change, 0.8)), 260 - 80 / 1.1, 9)
        self.assertAlmostEqual(float(pipe_codes.design_load(b, still, change[::-1], 1.0)), np.hypot(110, 260), 9)


class Parts(unittest.TestCase):
    """Lines without supports, and results of which none is at rest."""
    case = """hawser: 1
environment: {seabed: {depth: 50}}
line_types:
  steel: {pipe: {outer_diameter: 0.3, wall_thickness: 0.02, grade: X65}%s}
lines:
  riser: {sections: [{type: steel, length: 100, elements: 10}]}
%s"""

    def results(self, upper="a", kind="", more="", time=(0.0, 1.0), name="riser.h5", moment=1e5):
        """A line down to the bed, on which its last 20 m lie."""
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
        return Results(results_file(folder / name, time=time, lines={"riser": np.linspace(0, 100, 11)}, fields=fields,
                                    series=(np.array(time), {"riser touchdown": (columns, ["m"] * 8, np.array([row] * size))}),
                                    case=self.case % (kind, more)))

    def test_no_overbend_without_supports(self):
        for upper in "ab":
            results = self.results(upper)
            checked = pipe_checks.of_case(results, results.lines[0])
            expected = np.array([1] * 9 + [2] * 2)
            np.testing.assert_array_equal(checked.part, [expected if upper == "a" else expected[::-1]] * 2)

    def test_nothing_at_rest(self):
        still = self.results()
        for late in (self.results(time=(30.0, 31.0)), self.results(more="statics: false\n"),
                     self.results(more="statics: {enabled: false}\n")):
            with self.assertRaisesRegex(Refusal, "no output is at rest .*give --static RESULTS"):
                pipe_checks.of_case(late, late.lines[0])
        late, steel = self.results(time=(30.0, 31.0), moment=3e5), pipe_codes.Steel(*pipe_codes.GRADES["X65"])
        checked = pipe_checks.Checked(late, late.lines[0], "X65", steel, static=still)
        # Combination b: 1.1 of 100 kN m at rest and 1.3 of what is above it; a hundredth as much by the tension.
        _, bending = pipe_codes.plastic(steel, 0.3, 0.02)
        by_hand = (1.15 * 1.04 * (1.1 * 1e5 + 1.3 * 2e5) / (pipe_codes.flow_stress_factor(steel, 15) * bending)) ** 2
        self.assertAlmostEqual(checked.values[pipe_checks.BUCKLING][0, 0] / by_hand, 1, 2)
        head, rows = pipe_tables.checks(checked, 0.0)
        moment = next(row for row in rows if row[1] == "bending moment [N m]")
        self.assertEqual(moment[2:4], [1e5, 3e5])
        done = run(HAWSER, "pipe", late.path)
        self.assertEqual(done.returncode, 2)
        self.assertIn("the first is at t = 30 s, after a restart", done.stderr)
        done = run(HAWSER, "pipe", late.path, "--static", still.path)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"sagbend\s+bending moment \[kN m\]\s+100\s+300")

    def test_condition_factors(self):
        results = self.results()
        for words, expected in (((), "overbend 1, sagbend 1, seabed 1 "), (("0.9",), "overbend 0.9, sagbend 0.9, seabed 0.9 "),
                                (("overbend=0.82,seabed=1.07",), "overbend 0.82, sagbend 1, seabed 1.07 ")):
            done = run(HAWSER, "pipe", results.path, *(f"--condition-factor={word}" for word in words))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(f"gamma_C of functional loads: {expected}(", done.stdout)
        for word, part in (("stinger=0.8", "is neither a number nor a list such as"), ("overbend=", "is neither"), ("9", "9 is no")):
            done = run(HAWSER, "pipe", results.path, f"--condition-factor={word}")
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn(part, done.stderr)

    def test_a_measured_seabed_is_uneven(self):
        results, steel = self.results(), pipe_codes.Steel(*pipe_codes.GRADES["X65"])
        flat = pipe_checks.Checked(results, results.lines[0], "X65", steel).values[pipe_checks.BUCKLING][0]
        results.keys["environment"]["seabed"] = {"grid": {"file": "bed.txt"}}
        checked = pipe_checks.Checked(results, results.lines[0], "X65", steel)
        share = np.sqrt(checked.values[pipe_checks.BUCKLING][0] / flat)
        np.testing.assert_allclose(share, np.where(checked.part[0] == 2, share[-1], 1))
        self.assertAlmostEqual(share[-1], 1.07, delta=0.01)
        self.assertIn("seabed 1.07 (--condition-factor; uneven seabed)", checked.told()[1])

    def test_stress_beyond_yield_is_told(self):
        def told(**more):
            results = self.results(**more)
            return pipe_checks.doubts(pipe_checks.of_case(results, results.lines[0]))
        self.assertEqual(told(), [])
        self.assertIn("above the yield stress of 450 MPa, but the pipe is elastic", told(moment=1e6)[0])
        self.assertIn("has 'plasticity': its von Mises stress is that of an elastic section",
                      told(kind=", plasticity: {ramberg_osgood: {yield_moment: 5e5, A: 0.4, B: 12}}")[0])


class Departing(unittest.TestCase):
    def lay(self, forwards, case="hawser: 1\n", stock=0):
        """Supports at 10 and 20 m of a line that dives from there to the bed; the second carries it at the first output.
        Arc lengths begin at the stock, of an end A that is fed."""
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
            # It is steepest just behind 50 m.
            bend = laying.inflection(results, results.lines[0], left, None)
            np.testing.assert_allclose(bend, 50.5 if forwards else 49.5)

    def test_a_fed_line_leaves_from_its_feeder(self):
        # Of its 100 m 45 are in the stock, and the supports are nearer to its other end.
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
        """A line of 0, 4 and 10 m of which the last station from the feeder was never reached."""
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
        """With 10 kN at the bottom to begin with, 40 kN less than at the top; and the tensions that were tried."""
        tried = []

        def trial(bottom):
            tried.append(bottom)
            return lay_at(bottom)
        return (*lay_search.smallest(trial, self.asked, 1e4, 4e4), tried)

    def test_between_one_that_keeps_and_one_that_does_not(self):
        for edge in (317e3, 4e3, 10.01e3):  # above, below and beside where the search begins
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
        self.assertEqual(self.asked.missed(lay_search.Lay(1.0, [], np.nan, np.nan)), "too near the tip, no sagbend to be checked")
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
        # By hand at the most bent node: f_y 432 MPa, M_p 357.9 kN m, alpha_c 1.0909, S_p 4784 kN, combination a.
        node = int(np.argmax(moment))
        tension = results.field("effective_tension", line, 0)[node]
        share = 1.196 * 1.2 / 1.0909 * np.array([moment[node] / 357.9e3, tension / 4784.0e3])
        self.assertAlmostEqual(static("overbend  local buckling, DNV-ST-F101"), (share[0] + share[1] ** 2) ** 2, delta=2e-3)
        self.assertAlmostEqual(static("overbend  overbend strain at rest, DNV simplified I"),
                               moment.max() / 16272.6e3 * 0.125 / 0.0025, delta=2e-3)
        # Lift-off: the last of eleven boxes, where the line dives by the angle of the stinger there and a little more.
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
        def worst(*words):
            return float(re.search(r"overbend  local buckling, DNV-ST-F101\s+\S+\s+(\S+)", self.pipe(*words)[1]).group(1))
        self.assertLess(worst("--grade", "X70"), worst())
        self.assertGreater(worst("--safety-class", "high"), worst())
        self.assertLess(worst("--condition-factor", "0.8"), worst())

    def test_in_the_report(self):
        done = run(HAWSER, "report", self.path)
        self.assertEqual(done.returncode, 0, done.stderr)
        text = (self.folder / "simple.html").read_text("utf-8")
        self.assertIn("Strength of pipe", text)
        self.assertIn("local buckling, DNV-ST-F101", text)

    def test_a_lay_table(self):
        table = self.folder / "table.csv"
        done = run(HAWSER, "lay", self.case, "--depths", "90", "--clearance", "0.2", "-o", table)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(table, encoding="utf-8") as file:
            row = {key: float(value) for key, value in next(csv.DictReader(file)).items()}
        self.assertTrue(table.with_suffix(".png").is_file())
        # The smallest: the pipe clears the tip by what was asked, and hardly more.
        self.assertGreaterEqual(row["tip clearance [m]"], 0.2)
        self.assertLess(row["tip clearance [m]"], 0.23)
        # The tension falls by the weight of the height that the pipe comes down, in air and under water.
        self.assertAlmostEqual(row["tension [N]"] - row["tension at touchdown [N]"], 359.09 * (90 - 0.125) + 852.5 * 10.325,
                               delta=200)
        # The same lay, with that tension as a target of the case's own.
        anchor = -549.9 - (row["layback [m]"] - 329.7)
        again = self.folder / "again.h5"
        made = run(HAWSER, "run", self.case, "-q", "-o", again, "--set", "dynamics=null", "--set", "environment.seabed.depth=90",
                   "--set", f"lines.pipe.end_b.anchor=[{anchor}, 0, -89.875]", "--set", "lines.pipe.sections[1].length=260", "--set",
                   f"lines.pipe.target={{tension: {row['tension [N]']:.9g}, at: end_a, section: 2, between: [50, 800]}}")
        self.assertEqual(made.returncode, 0, made.stderr)
        results = Results(again)
        self.assertAlmostEqual(float(results.series("stinger 11").column("height")[0]), row["tip clearance [m]"], delta=0.01)

    def test_radii_of_the_stinger(self):
        table = self.folder / "radii.csv"
        done = run(HAWSER, "lay", self.case, "--depths", "90", "--radii", "100,60", "-o", table, "--set",
                   "lines.pipe.sections[0].element_length=1")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(table, encoding="utf-8") as file:
            rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
        self.assertEqual([row["stinger radius [m]"] for row in rows], [60, 100])
        for row in rows:
            # The mean of the overbend is bent as the stinger, 1.325 m above its path, by which 0.25 % are allowed to X65.
            self.assertGreater(row["overbend strain [%]"], 100 * 0.125 / (row["stinger radius [m]"] + 1.325))
            self.assertLess(row["overbend strain [%]"], 1.4 * 100 * 0.125 / (row["stinger radius [m]"] + 1.325))
            self.assertAlmostEqual(row["overbend strain, DNV simplified I [-]"], row["overbend strain [%]"] / 0.25, delta=1e-6)
        # It clears the last box by 0.3 m and lies on the last but one, 72 m along the arc.
        self.assertAlmostEqual(rows[1]["departure angle [deg]"], np.degrees(72 / 100), delta=1)
        self.assertGreater(rows[0]["overbend local buckling [-]"], 1)
        self.assertIn(f"In 90 m of water 100 m is the smallest of these radii whose overbend is used up to 1 ("
                      f"{rows[1]['overbend strain, DNV simplified I [-]']:.3g}), with {rows[1]['tension [N]'] / 1e3:.4g} kN.",
                      done.stdout)

    def test_the_smallest_radius_that_spares_the_overbend(self):
        def laid(tension, overbend):
            return lay_search.Lay(tension, [], 0.3, 0.1, overbend)
        found = [(50, 80, laid(1e5, 0.9)), (50, 100, laid(2e5, 0.6)), (50, 120, laid(3e5, 0.5)), (70, 80, None),
                 (70, 100, laid(3e5, np.nan))]
        said = list(lay.chosen(found, 0.7))
        self.assertEqual(said[0], "In 50 m of water 100 m is the smallest of these radii whose overbend is used up to 0.7 (0.6), "
                                  "with 200 kN.")
        self.assertIn("In 70 m of water no lay of these radii", said[1])

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
        self.assertIn("a lay over depths is for a level seabed: 'slope_deg' of this one is 0.02", slope.stderr)
        for words, part in ((["--depths", "50;60"], "--depths '50;60' are no numbers with commas between them"),
                            (["--depths", "-5"], "depths are above 0, in m"),
                            (["--depths", "90", "--utilisation", "2"], "--utilisation 2 is not above 0 and up to 1"),
                            (["--depths", "90", "--radii", "0,80"], "--radii '0,80': radii are above 0, in m"),
                            (["--depths", "90", "--radii", "80", "--set", "supports.stinger.path.segments=[{length: 20}, "
                              "{length: 60, radius: 150}, {length: 40, radius: 150}]"],
                             "--radii is for supports with one curved length in their path, fixed to a body or in space, and "
                             "this has 2: change them by --set")):
            done = run(HAWSER, "lay", self.case, f"{words[0]}={words[1]}", *words[2:])
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(part, done.stderr)
        moored = run(HAWSER, "lay", ROOT / "cases/mooring-line/mooring-line.yaml", "--depths=50")
        self.assertEqual(moored.returncode, 2, moored.stderr)
        self.assertIn("no line has a type with 'pipe'", moored.stderr)

    def test_refusals(self):
        plain = results_file(self.folder / "plain.h5")
        for words, part in ((["--grade", "X6"], "--grade cannot be 'X6'; did you mean 'X65'?"),
                            (["--ovality", "0.2"], "--ovality 0.2 is none that DNV-ST-F101 is for, 0.005 to 0.03"),
                            (["--material-factor", "0"], "--material-factor 0 is no factor of DNV-ST-F101"),
                            (["--line", "hose"], "there is no line 'hose' (there are: pipe)")):
            code, out, err = self.pipe(*words)
            self.assertEqual((code, out), (2, ""), err)
            self.assertIn(part, err)
            self.assertEqual(len(err.splitlines()), 1)
        done = run(HAWSER, "pipe", plain)
        self.assertEqual(done.returncode, 2)
        self.assertIn("no line has a type with 'pipe', whose wall could be checked", done.stderr)

    def test_slender_pipes_are_told(self):
        results = Results(self.path)
        line = results.lines[0]
        checked = pipe_checks.of_case(results, line)
        self.assertEqual(pipe_checks.doubts(checked), [])
        checked.slender, checked.pulled = 51.0, 0.5
        told = pipe_checks.doubts(checked)
        self.assertIn("D/t is 51: DNV-ST-F101's formulas for combined loads hold to 45", told[0])
        self.assertIn("D/t is 51: API RP 1111's formula for bending with pressure holds to 50", told[1])
        self.assertIn("0.5 of that at yield", told[2])
        checked.slender, checked.pulled = 12.0, 0.1
        self.assertIn("D/t is 12: DNV-ST-F101's formulas for combined loads are for 15 to 45", pipe_checks.doubts(checked)[0])


if __name__ == "__main__":
    unittest.main()
