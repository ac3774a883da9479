"""A synthetic results file with the data needed by tests of the Python tools."""
import json
import re

import h5py
import numpy as np
import yaml

UNITS = {"": 1.0, "m": 1.0, "mm": 1e-3, "s": 1.0, "MPa": 1e6, "kN": 1e3}


def as_read(value):
    """The program's conversion of texts of a case, as far as needed by the tests."""
    if isinstance(value, dict):
        return {key: as_read(inner) for key, inner in value.items()}
    if isinstance(value, list):
        return [as_read(inner) for inner in value]
    found = re.fullmatch(r"([-+]?[\d.]+(?:e[-+]?\d+)?) ?(\w*)", value)
    if found and found[2] in UNITS:
        return float(found[1]) * UNITS[found[2]]
    return {"true": True, "false": False}.get(value, value)


def add_contacts(path, outputs):
    """Points of contact; of each output (pairs, places, forces)."""
    with h5py.File(path, "r+") as file:
        file["outputs/contact_points"] = np.cumsum([len(places) for _, places, _ in outputs])
        for k, (name, kind, columns) in enumerate((("pair", "i4", 4), ("position", "f4", 3), ("force", "f4", 3))):
            file[f"contact_points/{name}"] = np.concatenate([np.reshape(output[k], (-1, columns)) for output in outputs]).astype(kind)


def results_file(path, time=(0.0,), lines=None, fields=None, series=None, statistics=None, case="hawser: 1\n",
                 attributes=None, ended=True, declared=None, stages=()):
    """Writes the file. lines: {name: arc lengths of its nodes}; fields: {name: (unit, outputs x all nodes (x 3))};
    statistics: {field: (unit, all nodes (x 3) x 6)}; series: (times, {name: ([columns], [units], steps (x lines) x
    columns)}); declared: {field: display attributes}. Without the field `position` nodes are along x."""
    lines = lines or {"line": np.linspace(0, 10, 3)}
    fields = dict(fields or {})
    arc = np.concatenate(list(lines.values()))
    if "position" not in fields:
        x = np.zeros((len(time), len(arc), 3))
        x[:, :, 0] = arc
        fields["position"] = ("m", x)
    step_time, tables = series or (np.zeros(0), {})
    with h5py.File(path, "w") as file:
        file.attrs.update({"hawser_results": 1, "version": "0", "case_path": "case.yaml", "date": "today", "ranks": 1,
                           **(attributes or {})})
        file["written"] = np.array([(len(time), len(step_time))], dtype=[("outputs", "i8"), ("steps", "i8")])
        file["outputs/time"] = np.asarray(time, float)
        file["nodes/arc_length"] = arc
        file["lines/name"] = [name.encode() for name in lines]
        counts = [len(v) for v in lines.values()]
        file["lines/first_node"] = np.concatenate([[0], np.cumsum(counts)[:-1]])
        file["lines/nodes"] = counts
        file["case"] = case.encode()
        given = yaml.load(case, yaml.BaseLoader)  # all texts
        file["case_read"] = json.dumps({"given": given, "read": as_read(given), "line_types": {}, "inputs": []}).encode()
        if stages:
            file["stages"] = [name.encode() for name in stages]
        if ended:
            kind = [("quantity", "S40"), ("line", "S40"), ("value", "f8"), ("unit", "S8"), ("time", "f8"), ("arc_length", "f8")]
            file["summary"] = np.array([(b"max effective tension", b"line", 5.0, b"N", 1.0, 2.0)], dtype=kind)
        for group, found in (("fields", fields), ("statistics", statistics or {})):
            for name, (unit, values) in found.items():
                file[f"{group}/{name}"] = values
                file[f"{group}/{name}"].attrs["unit"] = unit.encode()
        for name, attributes in (declared or {}).items():
            file[f"fields/{name}"].attrs.update(attributes)
        if len(step_time):
            file["series/time"] = step_time
        for name, (columns, units, values) in tables.items():
            place = f"line_series/{name}" if np.ndim(values) == 3 else f"series/{name}"
            file[place] = values
            file[place].attrs.update({"name": name.encode(), "columns": [c.encode() for c in columns],
                                      "units": [u.encode() for u in units]})
    return path
