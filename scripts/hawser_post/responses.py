"""Response amplitude operators of a body from its motion in a run and the waves.

Motions are those of a point of the body in axes with its mean heading, x forward and y to port: translations of the
point, and the rotation vector. The elevation is that of the case's waves at the low-frequency position of the body's
origin, as for its wave forces: eta = Re sum a exp(i (omega t - k x - phase)). A response H is motion over elevation,
both as Re(... exp(i omega t)); its lag is minus its phase.
"""
from dataclasses import dataclass

import numpy as np
from scipy import interpolate, signal
from scipy.spatial.transform import Rotation

from .results import Refusal, dictionary

FREEDOMS = ("surge", "sway", "heave", "roll", "pitch", "yaw")


@dataclass
class Response:
    """Response at one frequency; rotations in rad/m."""
    omega: float  # rad/s
    direction: float  # deg, wave propagation direction relative to the bow: 0 from astern
    value: np.ndarray  # six complex numbers
    amplitude: float  # m for a regular wave; m²/Hz, spectral density of an irregular sea
    # Irregular sea: coherence of each motion with the wave. Regular wave: fraction of the variance that the
    # response and its trend explain.
    explained: np.ndarray


class Motion:
    """Motion of a body in a run at the times `time` [s]; values: times x 6, m and rad."""

    def __init__(self, results, series, point):
        self.results, self.name = results, series.name
        self.body = body_of(results, series)
        x, turn = (np.column_stack([series.column(f"{what}_{k}") for k in "xyz"]) for what in ("position", "rotation_vector"))
        self.time = results.step_time
        if not (np.all(np.isfinite(x)) and np.all(np.isfinite(turn))):
            raise Refusal(f"{results.path}: '{series.name}' has no motion at some steps")
        turns = Rotation.from_rotvec(turn)
        self.origin = x
        self.point = x + turns.apply(np.asarray(point, float))
        self.bow = turns.apply([1.0, 0.0, 0.0])
        self.turns = turns

    def in_mean_axes(self, keep):
        """(heading [rad], motions: times x 6) in axes with the mean heading of the steps `keep`."""
        heading = np.arctan2(*np.mean(self.bow[keep, :2], axis=0)[::-1])
        back = Rotation.from_rotvec([0.0, 0.0, -heading])
        return heading, np.column_stack([back.apply(self.point), (back * self.turns).as_rotvec()])

    def slow_origin(self, keep):
        """x and y of the origin at all steps without wave-frequency motion, by the filter of a platform's wave
        forces, c⁴ (5 s + c)/(s + c)⁵ with c = 2 pi / `follow_period`; for other bodies the mean over `keep`."""
        floating = dictionary(dictionary(dictionary(self.results.keys.get("bodies")).get(self.body)).get("floating"))
        water = dictionary(floating.get("hydrodynamics"))
        period = water.get("follow_period", 0.0)
        if not period > 0:
            place = water.get("place") or [float(v) for v in np.mean(self.origin[keep], axis=0)]
            return np.broadcast_to(np.asarray(place[:2]), (len(self.time), 2))
        c = 2 * np.pi / period
        even = np.linspace(self.time[0], self.time[-1], len(self.time))
        still = self.origin[0, :2]
        out = []
        for k in (0, 1):
            moved = np.interp(even, self.time, self.origin[:, k] - still[k])
            filtered = signal.lsim(([5 * c**4, c**5], np.poly([-c] * 5)), moved, even)[1]
            out.append(still[k] + np.interp(self.time, even, filtered))
        return np.column_stack(out)


def body_of(results, series):
    """Body of a history."""
    points = dictionary(results.keys.get("output")).get("histories") or []
    names = [p["body"] for p in points if isinstance(p, dict) and "body" in p and p.get("name", p["body"]) == series.name]
    if "rotation_vector_x" not in series.columns or not names:
        raise Refusal(f"'{series.name}' is not a history of a body: request one by output.histories, '- {{body: NAME}}'")
    return names[0]


class Waves:
    """Wave components of a run: amplitude [m], omega [rad/s], k [1/m], direction [rad], phase [rad]."""

    def __init__(self, results):
        if "waves/components" not in results.file:
            raise Refusal(f"{results.path}: there are no waves, which responses need")
        rows = results.file["waves/components"][:]
        rows = rows[rows[:, 0] > 1e-9 * rows[:, 0].max()]
        self.amplitude, self.omega, self.k, x, y, self.phase = rows.T
        self.direction = np.arctan2(y, x)
        self.ramp = float(results.file["waves/ramp"][0])
        if np.ptp(np.unwrap(np.sort(self.direction))) > np.radians(0.5):
            raise Refusal(f"{results.path}: the waves have several directions, but a response belongs to one direction: give waves "
                          "of one direction, without 'spreading' and without a 'sum' of other directions")
        self.along = np.array([np.mean(x), np.mean(y)])

    @property
    def regular(self):
        return len(self.omega) == 1

    def elevation(self, time, place, omega=None):
        """Elevation [m] at places (times x 2)."""
        way = place @ self.along
        out = np.zeros(len(time))
        for a, w, k, phase in zip(self.amplitude, self.omega, self.k, self.phase):
            out += a * np.cos(w * time - k * way - phase)
        return out


def weights(time):
    """Hann window on nonuniform steps, times the step weights; suppresses slow motion such as the end of a free
    decay."""
    window = np.sin(np.pi * (time - time[0]) / (time[-1] - time[0])) ** 2
    return window * np.gradient(time)


def harmonic(time, values, omega):
    """Complex amplitudes c of Re(c exp(i omega t)) per column, by least squares together with a parabola in time and
    the second harmonic, and the explained fraction of each variance."""
    middle, half = 0.5 * (time[0] + time[-1]), 0.5 * (time[-1] - time[0])
    s = (time - middle) / half
    basis = np.column_stack([np.cos(omega * time), -np.sin(omega * time), np.cos(2 * omega * time), np.sin(2 * omega * time),
                             np.ones_like(s), s, s**2])
    root = np.sqrt(weights(time))[:, None]
    found = np.linalg.lstsq(root * basis, root * values, rcond=None)[0]
    left = root * (values - basis @ found)
    trend = root * (values - basis[:, 4:] @ found[4:])
    total = np.sum(trend**2, axis=0)
    explained = np.where(total > 0, 1 - np.sum(left**2, axis=0) / np.where(total > 0, total, 1), 1.0)
    return found[0] + 1j * found[1], explained


def to_regular_wave(motion, waves, keep):
    """Response to the run's single wave over the steps `keep`."""
    time = motion.time[keep]
    omega = float(waves.omega[0])
    if (time[-1] - time[0]) * omega < 2 * np.pi * 3:
        raise Refusal(f"{motion.results.path}: from t = {time[0]:g} s on there are fewer than three periods of the wave: run longer")
    heading, values = motion.in_mean_axes(keep)
    found, explained = harmonic(time, values[keep], omega)
    at = motion.slow_origin(keep)[keep]
    wave, _ = harmonic(time, waves.elevation(time, at)[:, None], omega)
    return Response(omega, bow_direction(waves, heading), found / wave[0], float(waves.amplitude[0]), explained)


def steadiness(motion, waves, keep):
    """Difference of the responses in both halves of the record, relative to the largest of their kind (translations,
    rotations)."""
    time = motion.time[keep]
    middle = 0.5 * (time[0] + time[-1])
    halves = []
    for part in (keep & (motion.time <= middle), keep & (motion.time >= middle)):
        _, values = motion.in_mean_axes(keep)
        halves.append(harmonic(motion.time[part], values[part], float(waves.omega[0]))[0])
    size = np.repeat([max(np.abs(halves[1][:3]).max(), 1e-300), max(np.abs(halves[1][3:]).max(), 1e-300)], 3)
    return float(np.max(np.abs(halves[1] - halves[0]) / size))


def bow_direction(waves, heading):
    """Direction of the waves relative to the bow, deg from -180 to 180, rounded to remove noise of the mean heading."""
    turn = np.degrees(np.arctan2(waves.along[1], waves.along[0]) - heading)
    turn = (turn + 180) % 360 - 180
    return round(float(turn), 6) + 0.0


SEGMENTS = 8  # number of segments of a record, excluding the overlapping ones
LEAST_WAVE = 0.01  # fraction of the sea's peak density below which no response is computed


def to_irregular_sea(motion, waves, keep, segment=None):
    """Responses by H1 = S(eta, x)/S(eta, eta) (Bendat and Piersol 2010, Random Data, 6.1.4) with Welch's segments of
    `segment` s and Hann windows overlapping by half; coherence |S(eta, x)|²/(S(eta, eta) S(x, x))."""
    time = motion.time[keep]
    length = time[-1] - time[0]
    segment = segment or length / SEGMENTS
    if segment > length / 2:
        raise Refusal(f"{motion.results.path}: its {length:.4g} s are shorter than two segments of {segment:.4g} s")
    even = np.linspace(time[0], time[-1], len(time))
    step = even[1] - even[0]
    count = int(round(segment / step))
    if count < 16:
        raise Refusal(f"{motion.results.path}: a segment of {segment:.4g} s has {count} steps, but needs 16")
    heading, values = motion.in_mean_axes(keep)
    slow = motion.slow_origin(keep)[keep]
    values = interpolate.CubicSpline(time, values[keep])(even)
    eta = waves.elevation(even, np.column_stack([np.interp(even, time, slow[:, k]) for k in (0, 1)]))
    how = {"fs": 1 / step, "nperseg": count, "detrend": "linear"}
    f, wave = signal.welch(eta, **how)
    cross = np.array([signal.csd(eta, values[:, k], **how)[1] for k in range(6)])
    own = np.array([signal.welch(values[:, k], **how)[1] for k in range(6)])
    shared = np.abs(cross) ** 2 / np.maximum(wave * own, 1e-300)
    out = []
    for i in np.flatnonzero(wave > LEAST_WAVE * wave.max()):
        if f[i] >= 1.5 / segment:  # below this the mean leaks through a Hann window
            out.append(Response(2 * np.pi * f[i], bow_direction(waves, heading), cross[:, i] / wave[i], float(wave[i]), shared[:, i]))
    if not out:
        raise Refusal(f"{motion.results.path}: segments of {segment:.4g} s are too short for the periods of these waves: run longer")
    return out
