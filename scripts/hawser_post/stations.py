"""Range graphs of fed lines over stations, which are fixed relative to the feeder while the line moves through them:
statistics over every step (names ending with _at_stations)."""
import numpy as np

from .charts import label, shown
from .results import dictionary, text_of
from .sections import part

END = "_at_stations"


def fields(results):
    """Names of the fields kept at stations."""
    return results.ordered(name[: -len(END)] for name in results.file.get("statistics", {}) if name.endswith(END))


def end_of(results, line):
    """The end of a line, "end_a" or "end_b", whose feeder its stations belong to; None if it is not fed."""
    ends = dictionary(part(results, "lines").get(line.name))
    return next((name for name in ("end_a", "end_b") if "feed" in dictionary(ends.get(name))), None)


def of_line(results, line):
    """Distance of each station from the feeder [m of unstretched line], and by field stations x 6 as in
    Results.statistics, without stations that the line never reached. None if the line is not fed or the run has not
    ended."""
    end = end_of(results, line)
    found = {f: results.statistics(f + END, line) for f in fields(results)} if end and results.ended else {}
    if not found:
        return None
    distance = line.arc if end == "end_a" else line.length - line.arc
    order = np.argsort(distance)
    known = order[~np.isnan(next(iter(found.values()))[order, 0])]
    return distance[known], {f: values[known] for f, values in found.items()}


def as_of_a_pipe(results, field, name, outer):
    """Name, unit and factor of a field of a pipe with this outer diameter [m]: curvature is shown as strain of the
    outer fibre."""
    unit = text_of(results.file[f"statistics/{field}{END}"].attrs.get("unit", ""))
    return (name.replace("curvature", "bending strain"), "%", 50 * outer) if unit == "1/m" else (name, unit, 1)


def table(results, line, outer):
    """Rows (quantity, least, largest, its time, its distance from the feeder) of a pipe with this outer diameter
    [m]."""
    stations, rows = of_line(results, line), []
    if stations is None:
        return None
    distance, found = stations
    for field, values in found.items():
        name, unit, factor = as_of_a_pipe(results, field, results.label(field), outer)
        unit, size = shown(unit)
        most = int(np.argmax(values[:, 2]))
        rows.append([label(name, unit), factor / size * float(values[:, 0].min()), factor / size * float(values[most, 2]),
                     float(values[most, 3]), float(distance[most])])
    return ["at stations, every step", "least", "largest", "at [s]", "from the feeder [m]"], rows


def columns(results, line, outer):
    """Head and rows of a CSV file: distance of each station, and least, largest and mean of each quantity."""
    distance, found = of_line(results, line)
    head, values = ["distance_from_feeder [m]"], [distance]
    for field, of_field in found.items():
        name, unit, factor = as_of_a_pipe(results, field, field.replace("_", " "), outer)
        for what, column in (("least", 0), ("largest", 2), ("mean", 4)):
            head.append(f"{what} {name} [{'-' if unit == '1' else unit}]"), values.append(factor * of_field[:, column])
    return head, list(zip(*values))
