"""Tables of pipe checks: by part of the line, and quantities monitored during laying."""
import numpy as np

from .pipe_checks import FIELDS, PARTS, largest


def checks(checked, since):
    """Table with part of the line, quantity, value at rest, largest value, its time and arc length."""
    head = ["part", "quantity", "static", "largest", "at [s]", "at [m]"]
    results, rows = checked.results, []
    keep = np.flatnonzero(results.since(since))

    def row(part, name, still, most, output, node):
        where = ["", "", ""] if np.isnan(most) else [most, float(results.time[keep][output]), float(checked.line.arc[node])]
        rows.append([part, name, "" if np.isnan(still) else still, *where])
    for k, part in enumerate(PARTS):
        for name, values in checked.values.items():
            most, output, node = largest(values[keep], checked.part[keep] == k)
            if not np.isnan(most):
                row(part, name, checked.static(name, k), most, output, node)
        for name, still, most, *place in checked.criteria(part, keep):
            if not np.isnan([still, most]).all():
                row(part, name + " [-]", still, most, *place)
    return head, rows


def every_step(checked):
    """Table of the code checks over every step and node: largest value, its time and arc length. None before the end
    of a run."""
    results, line, rows = checked.results, checked.line, []
    for name, field in FIELDS.items():
        found = results.statistics(field, line) if results.ended else None
        if found is None or np.isnan(found[:, 2]).all():
            continue
        node = int(np.nanargmax(found[:, 2]))
        rows.append([name.replace(" [-]", ""), float(found[node, 2]), float(found[node, 3]), float(line.arc[node])])
    return (["every step", "largest", "at [s]", "at [m]"], rows) if rows else None


def watched(checked):
    """Quantities monitored during laying: at each output, and the height over the last support at each step."""
    results, line, left, out = checked.results, checked.line, checked.left, {}
    tension, top = checked.tension, 0 if checked.forwards else -1
    out["top tension [kN]"] = tension[:, top] / 1e3
    if left:
        out["departure angle below the horizontal [deg]"] = left.angle
        out["arc length of lift-off [m]"] = left.arc
        out[f"clearance at the tip, {left.tip} [m]"] = left.tip_clearance
    if checked.down is not None:
        arc, place = checked.down
        out["arc length of touchdown [m]"] = arc
        out["layback, from the end to touchdown [m]"] = np.hypot(
            *(place - results.field("position", line)[:, top])[:, :2].T)
        out["tension at touchdown [kN]"] = np.array(
            [np.nan if np.isnan(s) else np.interp(s, line.arc, t) for s, t in zip(arc, tension)]) / 1e3
    return out


def geometry(checked, since):
    """Table of the monitored quantities: value at rest, least and largest since."""
    results, rows = checked.results, []
    for name, values in watched(checked).items():
        keep = (results.step_time >= since) if name.startswith("clearance at the tip") else results.since(since)
        if not np.isnan(values[keep]).all():
            rest = float(values[0]) if checked.at_rest else np.nan
            rows.append([name, "" if np.isnan(rest) else rest, float(np.nanmin(values[keep])), float(np.nanmax(values[keep]))])
    return ["quantity", "static", "least", "largest"], rows


def for_reading(head, rows):
    """Moments in kN m and stresses in MPa, with the unit in the name of the quantity."""
    out = []
    for row in rows:
        name, factor = row[1], 1.0
        for unit, shown, size in (("[N m]", "[kN m]", 1e3), ("[Pa]", "[MPa]", 1e6)):
            if name.endswith(unit):
                name, factor = name.replace(unit, shown), size
        out.append([row[0], name.replace(" [-]", "")] + [v / factor if isinstance(v, float) else v for v in row[2:4]] + row[4:])
    return head, out
