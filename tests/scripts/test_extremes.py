"""hawser extremes: against scipy, against closed forms, and messages about insufficient data."""
import contextlib
import csv
import io
import json
import os
import shutil
import sys
import tempfile
import types
import unittest
from pathlib import Path

import numpy as np
from scipy import optimize, stats

from support import ROOT, run
from synthetic import results_file

sys.path.insert(0, str(ROOT / "scripts"))
from hawser_post import __main__ as post  # noqa: E402
from hawser_post import extremes  # noqa: E402
from hawser_post.given import seconds, time_words  # noqa: E402

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))


def cycles(amplitudes, period=8.0, mean=50e3, steps=40):
    """A sine whose amplitude changes between cycles where it passes its mean."""
    t = np.arange(len(amplitudes) * steps + 1) * period / steps
    phase = np.arange(len(t)) / steps
    return t, mean + np.append(amplitudes, 0)[phase.astype(int)] * np.sin(2 * np.pi * phase)


def rayleigh(n, sigma, seed=3):
    """Amplitudes at the quantiles of a Rayleigh distribution, in random order."""
    values = sigma * np.sqrt(-2 * np.log(1 - (np.arange(n) + 0.5) / n))
    return np.random.default_rng(seed).permutation(values)


def signal_file(path, t, x, unit="N", column="effective_tension"):
    return results_file(path, series=(t, {"top": ([column], [unit], x[:, None])}))


class Numbers(unittest.TestCase):
    def sample(self):
        return extremes.Sample("blocks", 1e6 * (3 + np.random.default_rng(7).gumbel(0, 0.4, 60)), 100.0)

    def test_gumbel_against_scipy(self):
        sample = self.sample()
        fit = extremes.gumbel(sample)
        location, scale = stats.gumbel_r.fit(sample.values, scale=sample.values.std())
        np.testing.assert_allclose([fit.location, fit.scale], [location, scale], rtol=1e-8)
        # 1 h is 36 blocks: F^36 is the same distribution, shifted.
        law = stats.gumbel_r(location + scale * np.log(36), scale)
        np.testing.assert_allclose(fit.quantile(0.9, 3600), law.ppf(0.9), rtol=1e-8)
        mode = optimize.minimize_scalar(lambda x: -law.logpdf(x), bracket=(law.mean(), law.median()), tol=1e-12).x
        np.testing.assert_allclose(fit.most_probable(3600), mode, rtol=1e-6)
        np.testing.assert_allclose(fit.most_probable(3600), location + scale * np.log(36), rtol=1e-8)

    def test_weibull_against_scipy(self):
        rng = np.random.default_rng(11)
        sample = extremes.Sample("peaks", 5e4 + 2e4 * rng.weibull(1.7, 400), 9.0)
        fit = extremes.weibull(sample, 5e4)
        self.assertEqual(fit.location, 5e4)

        def tight(function, start, args=(), disp=0):
            return optimize.fmin(function, start, args=args, disp=disp, xtol=1e-10, ftol=1e-14, maxiter=4000)

        # scipy maximizes the likelihood, which is flat at its maximum; therefore its slope is checked as
        # well.
        y = (sample.values - 5e4) / 2e4
        shape, _, scale = stats.weibull_min.fit(y, floc=0, optimizer=tight)
        np.testing.assert_allclose([fit.shape, fit.scale], [shape, 2e4 * scale], rtol=1e-6)

        def slope(p):
            c, s = p
            z = np.log(y / s)
            return [np.sum(1 / c + z - (y / s) ** c * z), np.sum((y / s) ** c - 1)]

        exact = optimize.fsolve(slope, (1.5, 1.2), xtol=1e-11)
        np.testing.assert_allclose([fit.shape, fit.scale], [exact[0], 2e4 * exact[1]], rtol=1e-8)
        law = stats.weibull_min(fit.shape, 5e4, fit.scale)
        np.testing.assert_allclose(law.cdf(fit.quantile(0.9, 900)) ** 100, 0.9, rtol=1e-8)
        np.testing.assert_allclose(law.cdf(fit.most_probable(900)) ** 100, np.exp(-1), rtol=1e-8)

    def test_narrow_band_process(self):
        # Rayleigh peaks of sigma: sigma sqrt(2 ln N) is the most probable of N (Longuet-Higgins 1952).
        sigma, n, period = 4e3, 2000, 8.0
        t, x = cycles(rayleigh(n, sigma), period)
        record = [extremes.Record(t, x)]
        mean, deviation = extremes.mean_and_deviation(record)
        self.assertAlmostEqual(deviation / sigma, 1, places=2)
        sample = extremes.peaks(record, mean)
        self.assertEqual(len(sample.values), n - 1)
        self.assertAlmostEqual(sample.length, period, places=3)
        fit = extremes.weibull(sample, mean)
        self.assertAlmostEqual(fit.shape, 2, delta=0.01)
        self.assertAlmostEqual(fit.scale / (sigma * np.sqrt(2)), 1, delta=0.005)
        for duration in (3600, 3 * 3600, 24 * 3600):
            exact = 50e3 + sigma * np.sqrt(2 * np.log(duration / period))
            self.assertAlmostEqual(fit.most_probable(duration) / exact, 1, delta=2e-3)
        # With the exact distribution 1/e instead of the mode makes no significant difference.
        law = extremes.Fit(sample, "Weibull", 0.0, sigma * np.sqrt(2), 2.0)
        self.assertAlmostEqual(law.most_probable(period * 1000) / (sigma * np.sqrt(2 * np.log(1000))), 1, delta=5e-5)

    def test_blocks_and_minima(self):
        t, x = cycles(rayleigh(600, 2.0), mean=0.0)
        blocks = extremes.blocks([extremes.Record(t, x)], 80.0)
        by_hand = [x[k * 400 : (k + 1) * 400].max() for k in range(60)]
        np.testing.assert_allclose(blocks.values, by_hand, rtol=0, atol=0)
        two = extremes.blocks([extremes.Record(t, x), extremes.Record(t, 2 * x)], None)
        np.testing.assert_allclose(two.values, [x.max(), 2 * x.max()])
        self.assertAlmostEqual(two.length, t[-1])

    def test_durations(self):
        self.assertEqual([seconds(v) for v in ("3h", "90 min", "600", "1e3s", "1.5 d")], [10800, 5400, 600, 1000, 129600])
        self.assertEqual([time_words(v) for v in (10800, 5400, 61.25)], ["3 h", "90 min", "61.25 s"])


class Command(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.t, cls.x = cycles(rayleigh(500, 4e3), mean=50e3)
        signal_file(cls.folder / "one.h5", cls.t, cls.x)

    def extremes(self, *arguments):
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            code = post.main(["extremes", *(str(self.folder / a) if a.endswith((".h5", ".json", ".csv")) else a
                                            for a in arguments)])
        return types.SimpleNamespace(returncode=code, stdout=out.getvalue(), stderr=err.getvalue())

    def test_table(self):
        result = self.extremes("one.h5", "--duration", "3h", "-o", "one.json")
        self.assertEqual(result.returncode, 0, result.stderr)
        found = json.loads((self.folder / "one.json").read_text())
        self.assertEqual((found["unit"], found["duration"], found["of"]), ("N", 10800, "maxima"))
        by = {(f["sample"], f["distribution"]): f for f in found["fits"]}
        self.assertEqual(len(by), 4)
        self.assertEqual(by["peaks", "Weibull"]["size"], 499)
        self.assertEqual(by["blocks", "Gumbel"]["size"], 50)
        exact = 50e3 + 4e3 * np.sqrt(2 * np.log(10800 / 8))
        self.assertAlmostEqual(by["peaks", "Weibull"]["most_probable"] / exact, 1, delta=5e-3)
        # Maxima of ten Rayleigh peaks each converge to Gumbel's law slowly, from above.
        self.assertAlmostEqual(by["blocks", "Gumbel"]["most_probable"] / exact, 1, delta=0.06)
        for part in ("[kN]", "maxima in 3 h", "499", f"{by['peaks', 'Weibull']['most_probable'] / 1e3:.5g}", "90 % not exceeded"):
            self.assertIn(part, result.stdout)
        self.extremes("one.h5", "-o", "one.csv")
        with (self.folder / "one.csv").open(encoding="utf-8") as file:
            rows = list(csv.reader(file))
        self.assertEqual(rows[0][7], "most_probable [N]")
        np.testing.assert_allclose([float(r[7]) for r in rows[1:]], [f["most_probable"] for f in found["fits"]], rtol=1e-8)

    def test_minima_mirror_maxima(self):
        signal_file(self.folder / "mirrored.h5", self.t, -self.x)
        self.extremes("one.h5", "-o", "one.json")
        result = self.extremes("mirrored.h5", "--minima", "-o", "mirrored.json")
        one, mirrored = (json.loads((self.folder / name).read_text()) for name in ("one.json", "mirrored.json"))
        self.assertEqual([f["most_probable"] for f in one["fits"]], [-f["most_probable"] for f in mirrored["fits"]])
        self.assertEqual(one["extreme"], -mirrored["extreme"])
        self.assertIn("90 % not below", result.stdout)

    def test_several_runs(self):
        names = []
        for k in range(12):
            t, x = cycles(rayleigh(40, 4e3, seed=k)[:30])
            names.append(signal_file(self.folder / f"seed{k}.h5", t, x).name)
        result = self.extremes(*names, "--block", "run", "-o", "all.json")
        self.assertEqual(result.returncode, 0, result.stderr)
        sizes = {f["sample"]: f["size"] for f in json.loads((self.folder / "all.json").read_text())["fits"]}
        self.assertEqual(sizes, {"peaks": 12 * 29, "blocks": 12})
        self.assertIn("of 12 runs", result.stdout)

    def test_refusals(self):
        t, x = cycles(rayleigh(12, 4e3))
        signal_file(self.folder / "short.h5", t, x)
        t, x = cycles(np.full(60, 4e3))
        signal_file(self.folder / "regular.h5", t, x)
        results_file(self.folder / "none.h5")
        for arguments, part in ((["short.h5"], "has 11 maxima between upcrossings of its mean: a fit needs 20"),
                                (["regular.h5"], "as in a regular wave: no extrapolation is possible"),
                                (["none.h5"], "has no history"),
                                (["one.h5", "--duration", "soon"], "'soon' is not a time"),
                                (["one.h5", "--duration", "5"], "shorter than the time that one value of the sample represents"),
                                (["one.h5", "--quantile", "1"], "is not a probability"),
                                (["one.h5", "--block", "1000"], "there are 4 blocks of 1000 s, and a fit needs 10"),
                                (["one.h5", "--block", "4"], "shorter than the mean period"),
                                (["one.h5", "--column", "x"], "has no column 'x'"),
                                (["one.h5", "--since", "3999.9"], "fewer than two steps"), (["one.h5", "--since", "1e6"], "it has no output from"),
                                (["one.h5", "-o", "x.txt"], "is a .json or .csv file")):
            result = self.extremes(*arguments)
            with self.subTest(arguments=arguments):
                self.assertEqual((result.returncode, result.stdout), (2, ""))
                self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
                self.assertIn(part, result.stderr)

    def test_through_the_program(self):
        result = run(HAWSER, "extremes", self.folder / "one.h5", "--duration", "1h")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("maxima in 1 h", result.stdout)
        self.assertIn("extremes", run(HAWSER, "--help").stdout)


if __name__ == "__main__":
    unittest.main()
