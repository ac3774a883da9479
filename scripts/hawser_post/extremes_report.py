"""hawser extremes: extremes of a history in a given duration, as text, JSON or CSV."""
import json
import numpy as np

from . import charts, export, extremes
from .arguments import place_for
from .given import history_of, refuse_since, results_of, seconds, time_words
from .results import Refusal


def records_of(runs, options):
    """Records of all results, and the names of history, column and unit."""
    records, names = [], None
    for results in runs:
        refuse_since(results, options.since)
        series, column = history_of(results, options.name if names is None else names[0], options.column)
        time, values = results.step_time, series.column(column)
        names = names or (series.name, column, series.unit(column))
        keep = time >= (options.since or 0.0)
        if np.count_nonzero(keep) < 2:
            raise Refusal(f"{results.path}: it has fewer than two steps from t = {options.since or 0:g} s on")
        if not np.all(np.isfinite(values[keep])):
            raise Refusal(f"{results.path}: '{series.name}' has no {charts.words(column)} at some steps")
        records.append(extremes.Record(time[keep], -values[keep] if options.minima else values[keep]))
    return records, names


def samples_of(options, records, mean, what):
    """Samples that are large enough, and messages about others."""
    own = extremes.peaks(records, mean)
    if len(own.values) < extremes.LEAST_PEAKS:
        raise Refusal(f"{what} has {len(own.values)} {'minima' if options.minima else 'maxima'} between upcrossings of its "
                      f"mean: a fit needs {extremes.LEAST_PEAKS}; run longer, or give results of several runs")
    if options.block == "run":
        length = None
    else:
        length = seconds(options.block) if options.block else extremes.PERIODS * own.length
    if length is not None and length < own.length:
        raise Refusal(f"blocks of {length:.4g} s are shorter than the mean period of {what}, {own.length:.4g} s")
    blocks = extremes.blocks(records, length)
    if len(blocks.values) >= extremes.LEAST_BLOCKS:
        return [own, blocks], ""
    shortage = f"there are {len(blocks.values)} blocks of {time_words(blocks.length)}, and a fit needs {extremes.LEAST_BLOCKS}"
    if options.block:
        raise Refusal(f"{what}: {shortage}; give shorter ones, or results of more runs")
    return [own], f"no fit to blocks: {shortage}"


def report_values(options, sign, names, records, mean, deviation, found, duration):
    """Values for output to a file, in SI units."""
    top = max(records, key=lambda r: r.values.max())
    return {
        "history": names[0], "quantity": names[1], "unit": names[2], "of": "minima" if options.minima else "maxima",
        "runs": len(records), "time": sum(r.length for r in records), "mean": sign * mean, "standard_deviation": deviation,
        "extreme": sign * top.values.max(), "at": top.time[top.values.argmax()],
        "duration": duration, "probability": options.quantile,
        "fits": [{"sample": fit.sample.kind, "size": len(fit.sample.values), "seconds_each": fit.sample.length,
                  "distribution": fit.name, "location": sign * fit.location, "scale": fit.scale,
                  "shape": None if np.isnan(fit.shape) else fit.shape,
                  "most_probable": sign * fit.most_probable(duration),
                  "quantile": sign * fit.quantile(options.quantile, duration)} for fit in found]}


def show(values, note):
    unit, factor = charts.shown(values["unit"])
    of = values["of"]
    runs = "" if values["runs"] == 1 else f" of {values['runs']} runs"
    print(f"{charts.words(values['quantity'])} of {values['history']} [{unit}], {of} in {time_words(values['duration'])} "
          f"from {values['time']:.6g} s{runs}")
    print(f"mean {values['mean'] / factor:.5g}, standard deviation {values['standard_deviation'] / factor:.5g}, "
          f"{'smallest' if of == 'minima' else 'largest'} {values['extreme'] / factor:.5g} at t = {values['at']:.6g} s\n")
    head = f"{100 * values['probability']:g} % not {'below' if of == 'minima' else 'exceeded'}"
    print(f"{'sample':<38} {'size':>5}  {'fit':<8} {'location':>10} {'scale':>10} {'shape':>7} {'most probable':>14} {head:>16}")
    for fit in values["fits"]:
        each = (f"between upcrossings, {fit['seconds_each']:.4g} s each" if fit["sample"] == "peaks"
                else f"blocks of {fit['seconds_each']:.4g} s")
        shape = "" if fit["shape"] is None else f"{fit['shape']:.4g}"
        print(f"{each:<38} {fit['size']:>5}  {fit['distribution']:<8} {fit['location'] / factor:>10.5g} "
              f"{fit['scale'] / factor:>10.4g} {shape:>7} {fit['most_probable'] / factor:>14.5g} "
              f"{fit['quantile'] / factor:>16.5g}")
    if note:
        print(f"note: {note}")


def make(options):
    if not 0 < options.quantile < 1:
        raise Refusal(f"--quantile {options.quantile:g} is not a probability between 0 and 1")
    duration = seconds(options.duration)
    found = [results_of(given, options.changes) for given in options.results]
    path = place_for(options.output, found, (".json", ".csv"), "a table of extremes") if options.output else None
    records, names = records_of(found, options)
    what = f"{charts.words(names[1])} of '{names[0]}'"
    mean, deviation = extremes.mean_and_deviation(records)
    samples, note = samples_of(options, records, mean, what)
    try:
        found = [fit for sample in samples for fit in extremes.fits(sample, mean, deviation)]
    except Refusal as refusal:
        raise Refusal(f"{what}: {refusal}") from None
    if duration < max(sample.length for sample in samples):
        raise Refusal(f"--duration {options.duration}: shorter than the time that one value of the sample represents "
                      f"({max(sample.length for sample in samples):.4g} s)")
    values = report_values(options, -1.0 if options.minima else 1.0, names, records, mean, deviation, found, duration)
    show(values, note)
    if path:
        if path.suffix == ".json":
            path.write_text(json.dumps(values, indent=2) + "\n", encoding="utf-8")
        else:
            head = [f"{key} [{names[2]}]" if key in ("location", "scale", "most_probable", "quantile") else key
                    for key in values["fits"][0]]
            export.write(path, head, [["" if v is None else v for v in fit.values()] for fit in values["fits"]])
        print(f"table: {path}")
