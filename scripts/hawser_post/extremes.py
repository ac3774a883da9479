"""Extreme values of a signal: samples of its maxima, fitted distributions, and extremes in a given duration.

Samples: the largest value between successive upcrossings of the mean ("peaks"), or the largest of each block of time
("blocks"). Distributions by maximum likelihood: Gumbel, and Weibull above the mean of the signal (two parameters). The
largest of m sample values in a duration has the distribution F(x)^m (Gumbel 1958, Statistics of Extremes, 3.1). The
most probable maximum is its quantile 1/e: exactly the mode of a Gumbel distribution, and for others the limit of the
mode for large m (the level exceeded once on average), sigma sqrt(2 ln N) for N Rayleigh peaks.
"""
from dataclasses import dataclass

import numpy as np
from scipy import optimize, stats

from .results import Refusal
from .statistics import integral, upcrossings

LEAST_PEAKS, LEAST_BLOCKS = 20, 10
PERIODS = 10  # periods per block, unless its length is given


@dataclass
class Record:
    """A signal with nonuniform steps, from one run."""
    time: np.ndarray
    values: np.ndarray

    @property
    def length(self):
        return float(self.time[-1] - self.time[0])


@dataclass
class Sample:
    kind: str  # peaks or blocks
    values: np.ndarray
    length: float  # s per value


@dataclass
class Fit:
    sample: Sample
    name: str  # Gumbel or Weibull
    location: float
    scale: float
    shape: float  # NaN: none

    @property
    def distribution(self):
        if self.name == "Gumbel":
            return stats.gumbel_r(self.location, self.scale)
        return stats.weibull_min(self.shape, self.location, self.scale)

    def quantile(self, probability, duration):
        """Level not exceeded in a duration [s] with this probability."""
        of_one = np.log(probability) * self.sample.length / duration  # log F of a single value
        return float(self.distribution.isf(-np.expm1(of_one)))

    def most_probable(self, duration):
        return self.quantile(np.exp(-1.0), duration)


def mean_and_deviation(records):
    """Mean and standard deviation over the time of all records."""
    length = sum(r.length for r in records)
    mean = sum(integral(r.time, r.values) for r in records) / length
    return mean, np.sqrt(sum(integral(r.time, (r.values - mean) ** 2) for r in records) / length)


def peaks(records, mean):
    """Largest values between successive upcrossings of the mean; each represents the mean time between them."""
    found, seconds = [], 0.0
    for r in records:
        up = upcrossings(r.time, r.values, mean)
        if len(up) < 2:
            continue
        seconds += up[-1] - up[0]
        cuts = np.searchsorted(r.time, up)
        found += [r.values[a:b].max() for a, b in zip(cuts, cuts[1:])]
    return Sample("peaks", np.array(found), seconds / max(len(found), 1))


def blocks(records, length):
    """Largest value in each block of `length` [s]; a shorter remainder is excluded. None: each record is one block,
    and all must have nearly the same length."""
    if length is None:
        lengths = [r.length for r in records]
        if max(lengths) > 1.01 * min(lengths):
            raise Refusal(f"records of {min(lengths):.6g} to {max(lengths):.6g} s cannot be blocks of one length: give --block")
        return Sample("blocks", np.array([r.values.max() for r in records]), float(np.mean(lengths)))
    found = []
    for r in records:
        cuts = np.searchsorted(r.time, r.time[0] + length * np.arange(int(r.length / length * (1 + 1e-9)) + 1))
        found += [r.values[a:b].max() for a, b in zip(cuts, cuts[1:]) if b > a]
    return Sample("blocks", np.array(found), length)


def gumbel(sample):
    middle, spread = sample.values.mean(), sample.values.std()  # numbers near one give the best accuracy
    location, scale = stats.gumbel_r.fit((sample.values - middle) / spread)
    return Fit(sample, "Gumbel", float(middle + spread * location), float(spread * scale), np.nan)


def weibull(sample, mean):
    """Weibull fit above `mean`. Maximum of the likelihood: sum(y^c ln y)/sum(y^c) - 1/c = mean(ln y), y above the
    mean (Johnson, Kotz and Balakrishnan 1994, Continuous Univariate Distributions 1, chapter 21); the left side
    increases with c."""
    y = (sample.values - mean) / (sample.values - mean).max()  # scaled so that powers stay below one
    logs = np.log(y)

    def equation(c):
        powers = y**c
        return (powers * logs).sum() / powers.sum() - 1 / c - logs.mean()

    high = 1.0
    while equation(high) < 0:
        high *= 2
    shape = optimize.brentq(equation, 1e-3, high, xtol=1e-13, rtol=1e-14)
    scale = np.mean(y**shape) ** (1 / shape) * (sample.values - mean).max()
    return Fit(sample, "Weibull", float(mean), float(scale), float(shape))


def fits(sample, mean, deviation):
    """Both distributions; Weibull only if all values are above the mean."""
    if np.std(sample.values) < 1e-4 * deviation:
        raise Refusal(f"the maxima are all {sample.values.max():.6g}, as in a regular wave: no extrapolation is possible")
    found = [gumbel(sample)]
    return found + [weibull(sample, mean)] if sample.values.min() > mean else found
