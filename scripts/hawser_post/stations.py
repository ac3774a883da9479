"""Range graphs of lines that are fed over stations, which stay with the feeder while the line runs through them: over every
step of the run (the statistics whose names end with _at_stations)."""
import numpy as np

FIELDS = ("effective_tension", "bending_moment", "curvature", "utilisation", "bend_utilisation", "dnv_local_buckling", "api_bending_pressure",
          "api_tension_pressure")

CODES = (("local buckling, DNV-ST-F101 [-]", "dnv_local_buckling", 1),
         ("bending and pressure, API RP 1111 [-]", "api_bending_pressure", 1),
         ("tension and pressure, API RP 1111 [-]", "api_tension_pressure", 1))


def end_of(results, line):
    """The end of a line, "end_a" or "end_b", whose feeder its stations belong to; None where it is not fed."""
    case = results.keys.get("lines")
    ends = case.get(line.name) if isinstance(case, dict) else None
    return next((name for name in ("end_a", "end_b")
                 if isinstance(ends, dict) and isinstance(ends.get(name), dict) and "feed" in ends[name]), None)


def of_line(results, line):
    """Distance of each station from the feeder [m of unstretched line], and by field stations x 6 as Results.statistics has
    them; stations that the line never came to are left out. None where the line is not fed, or the run has not ended."""
    end = end_of(results, line)
    found = {f: results.statistics(f"{f}_at_stations", line) for f in FIELDS} if end and results.ended else {}
    found = {f: values for f, values in found.items() if values is not None}
    if not found:
        return None
    distance = line.arc if end == "end_a" else line.length - line.arc
    order = np.argsort(distance)
    known = order[~np.isnan(next(iter(found.values()))[order, 0])]
    return distance[known], {f: values[known] for f, values in found.items()}


def table(results, line, outer):
    """Rows (quantity, least, largest, its time, its distance from the feeder) of a pipe with this outer diameter [m]."""
    stations, rows = of_line(results, line), []
    if stations is None:
        return None
    distance, found = stations
    for name, field, factor in (("effective tension [kN]", "effective_tension", 1e-3),
                                ("bending moment [kN m]", "bending_moment", 1e-3),
                                ("bending strain [%]", "curvature", 50 * outer), ("utilisation of the breaking load", "utilisation", 1),
                                ("utilisation of the bend radius", "bend_utilisation", 1), *CODES):
        if field in found:
            most = int(np.argmax(found[field][:, 2]))
            rows.append([name, factor * float(found[field][:, 0].min()), factor * float(found[field][most, 2]),
                         float(found[field][most, 3]), float(distance[most])])
    return ["at stations, every step", "least", "largest", "at [s]", "from the feeder [m]"], rows


def columns(results, line, outer):
    """Head and rows of a CSV file: each station's distance, and least, largest and mean of each quantity there."""
    distance, found = of_line(results, line)
    head, values = ["distance_from_feeder [m]"], [distance]
    for name, field, factor in (("effective tension [N]", "effective_tension", 1), ("bending moment [N m]", "bending_moment", 1),
                                ("bending strain [%]", "curvature", 50 * outer), ("utilisation [-]", "utilisation", 1),
                                ("bend utilisation [-]", "bend_utilisation", 1), *CODES):
        for what, column in (("least", 0), ("largest", 2), ("mean", 4)):
            if field in found:
                head.append(f"{what} {name}"), values.append(factor * found[field][:, column])
    return head, list(zip(*values))
