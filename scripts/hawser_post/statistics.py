"""Statistics and spectrum of signals with nonuniform steps."""
from dataclasses import dataclass

import numpy as np
from scipy.signal import welch


@dataclass
class Statistics:
    least: float
    least_time: float
    most: float
    most_time: float
    mean: float
    deviation: float  # standard deviation
    period: float  # s, mean time between upcrossings of the mean; NaN with fewer than two


def integral(t, x):
    return np.trapz(x, t, axis=0)


def mean_of(t, x):
    """Mean over time by the trapezoidal rule, column by column."""
    return integral(t, x) / (t[-1] - t[0]) if len(t) > 1 and t[-1] > t[0] else x[-1]


def upcrossings(t, x, level=None):
    """Times at which x rises through a level (default: its mean), by linear interpolation."""
    y = np.asarray(x) - (mean_of(t, x) if level is None else level)
    i = np.flatnonzero((y[:-1] < 0) & (y[1:] >= 0))
    return t[i] - y[i] * (t[i + 1] - t[i]) / (y[i + 1] - y[i])


def statistics(t, x):
    t, x = np.asarray(t, float), np.asarray(x, float)
    mean = float(mean_of(t, x))
    up = upcrossings(t, x)
    period = (up[-1] - up[0]) / (len(up) - 1) if len(up) > 1 else np.nan
    low, high = int(np.argmin(x)), int(np.argmax(x))
    return Statistics(float(x[low]), float(t[low]), float(x[high]), float(t[high]), mean,
                      float(np.sqrt(mean_of(t, (x - mean) ** 2))), float(period))


def spectrum(t, x):
    """One-sided power spectral density by Welch's method (Welch 1967): frequencies [Hz] and unit²/Hz. Hann windows
    overlapping by half, with the length of a quarter of a signal of 40 mean periods or more, half of one of 20, else
    all of it. The signal is first resampled to the same number of equal steps."""
    t, x = np.asarray(t, float), np.asarray(x, float)
    even = np.linspace(t[0], t[-1], len(t))
    periods = len(upcrossings(t, x))
    parts = 4 if periods >= 40 else 2 if periods >= 20 else 1
    f, density = welch(np.interp(even, t, x), fs=1 / (even[1] - even[0]), nperseg=len(even) // parts,
                       detrend="constant")
    return f, density
