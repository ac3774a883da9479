"""hawser rao: responses of a body to the waves of one or several runs, as text, table and figure; figure and vessel file
of such a table."""
import argparse
import csv
from pathlib import Path

import numpy as np

from . import export, responses
from .arguments import place_for
from .charts import COLOURS, WIDE, legend, plt
from .given import refuse_since, results_of, seconds
from .responses import FREEDOMS
from .results import Refusal

SHOWN_ROWS = 16  # rows of a sea printed in the terminal
STEADY = 0.01  # largest change between the halves of the record of a steady response
COHERENT = 0.95  # least coherence of a response to a single wave
SMALL = 1e-4  # noise relative to the largest of its kind, m/m or rad/m


def point_from(text):
    """Parses a point of --at."""
    try:
        numbers = [float(word) for word in text.split(",")]
    except ValueError:
        numbers = []
    if len(numbers) != 3 or not np.all(np.isfinite(numbers)):
        raise argparse.ArgumentTypeError(f"'{text}' is not a point X,Y,Z of the body, in m")
    return numbers


def of_run(results, options):
    """(responses, steps used, sea is irregular, change of the response over time) of one run."""
    refuse_since(results, options.since)
    name = options.name or next((key for key in results.histories if "rotation_vector_x" in results.series_columns(key)[0]), None)
    if name is None:
        raise Refusal(f"{results.path} has no history of a body: request one by output.histories, '- {{body: NAME}}'")
    motion, waves = responses.Motion(results, results.series(name), options.at), responses.Waves(results)
    last = motion.time[-1]
    since = options.since if options.since is not None else max(waves.ramp, 0.5 * last) if waves.regular else waves.ramp
    keep = motion.time >= since - 1e-9 * last  # tolerance: times are sums of steps
    if np.count_nonzero(keep) < 32:
        raise Refusal(f"{results.path}: from t = {since:g} s on there are {np.count_nonzero(keep)} steps, but a response needs 32")
    if waves.regular:
        if options.segment:
            raise Refusal(f"{results.path}: has a regular wave, but --segment is for irregular seas")
        return [responses.to_regular_wave(motion, waves, keep)], motion, keep, None, responses.steadiness(motion, waves, keep)
    segment = seconds(options.segment) if options.segment else None
    found = responses.to_irregular_sea(motion, waves, keep, segment)
    return found, motion, keep, segment or (last - motion.time[keep][0]) / responses.SEGMENTS, None


def degrees(response):
    """Six amplitudes, m/m and deg/m."""
    return np.abs(response.value) * np.repeat([1.0, 180 / np.pi], 3)


def lags(response):
    """Phase lags, deg from 0 to 360; zero for noise."""
    size = np.abs(response.value)
    most = np.repeat([max(size[:3].max(), 1e-300), max(size[3:].max(), 1e-300)], 3)
    return np.where(size < SMALL * most, 0.0, np.degrees(-np.angle(response.value)) % 360)


def table_of(found):
    head = ["period [s]", "direction [deg]", *(f"{name} {what}" for name, unit in zip(FREEDOMS, 3 * ["[m/m]"] + 3 * ["[deg/m]"])
                                               for what in (unit, "lag [deg]")),
            *(f"explained fraction of {name} [-]" for name in FREEDOMS)]
    rows = [[2 * np.pi / r.omega, r.direction, *np.column_stack([degrees(r), lags(r)]).ravel(), *r.explained] for r in found]
    return head, rows


def read(path):
    """Responses in a table of this command or of `hawser responses`."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            head, *rows = csv.reader(file)
        values = np.array(rows, float)
        if head != table_of([])[0] or not rows:
            raise ValueError
    except OSError as fault:
        raise Refusal(f"{path}: cannot be read: {fault.strerror}") from None
    except ValueError:
        raise Refusal(f"{path} is not a table of responses") from None
    motion = values[:, 2:14:2] * np.repeat([1.0, np.pi / 180], 3) * np.exp(-1j * np.radians(values[:, 3:14:2]))
    return [responses.Response(2 * np.pi / row[0], row[1], value, 1.0, row[14:]) for row, value in zip(values, motion)]


def write(path, found):
    """Writes a table of responses: .csv with headings, or .rao for `motion.rao` of a body."""
    head, rows = table_of(found)
    if path.suffix == ".csv":
        export.write(path, head, rows)
        return
    lines = ["# period [s], direction [deg] from the bow, then surge, sway, heave [m/m], roll, pitch, yaw [deg/m], each with its lag [deg]"]
    lines += [" ".join(f"{v:.7g}" for v in row[:14]) for row in rows]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def show(found, irregular):
    print(f"{'period [s]':>10} {'to [deg]':>8}" + "".join(f" {name:>8} {'lag':>5}" for name in FREEDOMS))
    step = max(1, -(-len(found) // SHOWN_ROWS))
    for r in found[::step]:
        pairs = "".join(f" {a:>8.4g} {lag:>5.0f}" for a, lag in zip(degrees(r), lags(r)))
        print(f"{2 * np.pi / r.omega:>10.4g} {r.direction:>8.4g}{pairs}")
        if irregular:
            size = np.abs(r.value)
            most = np.repeat([max(size[:3].max(), 1e-300), max(size[3:].max(), 1e-300)], 3)
            print(f"{'coherence':>19}" + "".join(" " * 15 if s < SMALL * m else f" {c:>8.3f}      " for s, m, c in zip(size, most, r.explained)))
    if step > 1:
        print(f"every {step} of {len(found)} frequencies is shown; the table has all of them")


def draw(found, path):
    """Figure of amplitudes over the period with lags below; translations on the left, open circles at low coherence. Of several
    directions those nearest to the bow, to port, to the stern and to starboard, with a kind of line and marker each."""
    figure, axes = plt.subplots(2, 2, figsize=(WIDE, 4.6), sharex=True, layout="constrained", height_ratios=(2, 1))
    most = np.max([degrees(r) for r in found], axis=0)
    shown = [k for k in range(6) if most[k] > 1e-3 * most[k // 3 * 3:k // 3 * 3 + 3].max()]
    every = sorted({r.direction for r in found})
    directions = sorted({min(every, key=lambda d: abs((d - side + 180) % 360 - 180)) for side in (0, 90, 180, 270)})
    named = set()
    for direction, line, marker in zip(directions, ("-", "--", ":", "-."), (".", "x", "+", "1")):
        rows = sorted((r for r in found if r.direction == direction), key=lambda r: -r.omega)
        period = np.array([2 * np.pi / r.omega for r in rows])
        amplitude, lag, explained = (np.array([of(r) for r in rows]) for of in (degrees, lags, lambda r: r.explained))
        for k in shown:
            if len(directions) > 1 and amplitude[:, k].max() < 1e-3 * most[k // 3 * 3:k // 3 * 3 + 3].max():
                continue
            sure = explained[:, k] >= COHERENT
            first = k not in named
            named.add(k)
            for row, values in ((0, amplitude[:, k]), (1, lag[:, k])):
                own = axes[row, k // 3]
                own.plot(period, np.where(sure, values, np.nan), marker=marker, ms=3, ls=line if row == 0 else "", lw=1, color=COLOURS[k % 3],
                         label=FREEDOMS[k] if row == 0 and first else None)
                own.plot(period, np.where(sure, np.nan, values), "o", ms=3, mfc="none", mew=0.6, color=COLOURS[k % 3])
    for column, unit in ((0, "m/m"), (1, "deg/m")):
        axes[0, column].set(ylabel=unit, ylim=(0, None))
        axes[1, column].set(xlabel="period [s]", ylabel="lag [deg]", ylim=(0, 360), yticks=(0, 90, 180, 270, 360))
        legend(axes[0, column])
    if len(directions) > 1:
        kinds = zip(directions, ("full lines and dots", "dashed and ×", "dotted and +", "dash-dotted and ⅄"))
        figure.supxlabel("waves to " + ", ".join(f"{direction:g}° ({kind})" for direction, kind in kinds), fontsize=7)
    figure.savefig(path, dpi=150)
    plt.close(figure)


def convert(paths, options):
    """Figure of tables, or vessel file."""
    if options.since is not None or options.segment or options.name or any(options.at):
        raise Refusal(f"{paths[0]} is a table: --name, --at, --segment and --since are for results of runs")
    found = sorted((r for path in paths for r in read(path)), key=lambda r: (r.direction, -r.omega))
    for one, other in zip(found, found[1:]):
        if (one.direction, one.omega) == (other.direction, other.omega):
            raise Refusal(f"{' and '.join(map(str, paths))}: the period {2 * np.pi / one.omega:.6g} s in the direction {one.direction:g} deg is "
                          "there twice: give tables of one body, with other periods or directions")
    target = place_for(options.output or Path(paths[0]).with_suffix(".png"), [], (".png", ".rao"), "a figure, or a table for motion.rao,", paths)
    if target.suffix == ".rao":
        write(target, found)
        print(f"responses: {target}")
        return
    draw(found, target)
    print(f"figure: {target}")


def make(options):
    if all(given.endswith(".csv") for given in options.results):
        convert(options.results, options)
        return
    if tables := [given for given in options.results if given.endswith(".csv")]:
        raise Refusal(f"{tables[0]} is a table, and others are results of runs: give files of one kind")
    runs = [results_of(given, options.changes) for given in options.results]
    first = runs[0].path
    table = place_for(options.output or first.with_name(f"{first.stem}-rao.csv"), runs, (".csv", ".rao"), "a table of responses")
    picture = place_for(table.with_suffix(".png"), runs)
    found, warnings = [], []
    for results in runs:
        own, motion, keep, segment, change = of_run(results, options)
        time = motion.time[keep]
        x, y, z = options.at
        sea = f"regular wave of {own[0].amplitude:.4g} m amplitude" if segment is None else f"sea, segments of {segment:.4g} s"
        print(f"{results.path}: {motion.body} at ({x:g}, {y:g}, {z:g}) in its frame, from t = {time[0]:.6g} to {time[-1]:.6g} s; {sea}")
        found += own
        if change is not None and change > STEADY:
            warnings.append(f"{results.path}: the response still changes, by {100 * change:.2g} % from the first to the second half of "
                            "the time: run longer, or exclude more of the start by --since")
        warnings += incoherent(results, own) if segment is not None else []
    found.sort(key=lambda r: (r.direction, -r.omega))
    print("amplitudes in m/m and deg/m, lags in deg behind the crest at the body's origin")
    show(found, any(r.explained.min() < 1 for r in found) and len(found) > len(runs))
    for warning in warnings:
        print(f"warning: {warning}")
    write(Path(table), found)
    print(f"responses: {table}")
    if len({r.omega for r in found}) > 1:
        draw(found, picture)
        print(f"figure: {picture}")


def incoherent(results, found):
    """Sentence on motion in a sea that is not a response to its waves."""
    out = []
    for k, name in enumerate(FREEDOMS):
        size = np.array([abs(r.value[k]) for r in found])
        kind = max(np.abs(r.value[3 * (k // 3):3 * (k // 3) + 3]).max() for r in found)
        poor = [2 * np.pi / r.omega for r, s in zip(found, size) if s > 0.01 * kind and r.explained[k] < COHERENT]
        if poor:
            where = f"{min(poor):.3g} s" if len(poor) == 1 else f"{min(poor):.3g} to {max(poor):.3g} s"
            out.append(f"{results.path}: {name} has a coherence below {COHERENT:g} at {len(poor)} of {len(found)} frequencies, {where}: "
                       "possible reasons: a resonance too narrow for the segments, slow drift, drag, or little wave energy there; run longer")
    return out
