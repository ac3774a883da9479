"""A results file of hawser: lines, outputs, histories and extremes as arrays, in SI units."""
import json
import os
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import h5py
import numpy as np

from . import points
from .layout import LARGEST, Refusal, check_layout, dictionary, text_of


@dataclass
class Line:
    name: str
    number: int
    nodes: slice  # slice of the node fields
    arc: np.ndarray  # m from end A, unstretched

    @property
    def length(self):
        return float(self.arc[-1])


@dataclass
class Series:
    """A table with one row per step: a history, a clearance, the energy audit or the solver."""
    name: str
    columns: list
    units: list
    values: np.ndarray  # steps x columns

    def column(self, name):
        if name not in self.columns:
            raise Refusal(f"'{self.name}' has no column '{name}' (there are: {', '.join(self.columns)})")
        return self.values[:, self.columns.index(name)]

    def unit(self, name):
        return self.units[self.columns.index(name)]


PLACED = ("bodies", "volumes", "supports", "joints", "lines", "links")


def with_platforms(as_read, of):
    """Keys `of` a case ("read" or "given"), including placed objects of a farm, "T12/mooring", from the platform
    files."""
    keys = dictionary(as_read.get(of))
    platforms = as_read.get("platforms")
    for platform in platforms if isinstance(platforms, list) else []:
        own, places = (dictionary(dictionary(platform).get(key)) for key in (of, "places"))
        types = {"line_types": {**dictionary(own.get("line_types")), **dictionary(keys.get("line_types"))}}
        things = {kind: {**dictionary(keys.get(kind)),
                         **{f"{place}/{name}": thing for place in places for name, thing in dictionary(own.get(kind)).items()}}
                  for kind in PLACED if dictionary(own.get(kind))}
        keys = {**keys, **types, **things}
    return keys


class Results:
    def __init__(self, path, stage=None):
        """stage: index of a stage of statics whose equilibrium becomes the only output."""
        self.path = Path(path)
        self.points = []  # points of bodies that are histories too
        if not self.path.is_file():
            raise Refusal(f"{path}: there is no such file")
        try:
            self.file = h5py.File(self.path, "r", locking=False)
        except OSError as error:
            raise Refusal(f"{path}: is not a readable HDF5 file ({str(error).splitlines()[0]})") from error
        if "hawser_results" not in self.file.attrs:
            raise Refusal(f"{path}: is an HDF5 file that hawser did not write")
        check_layout(self.file, path)
        # A run in progress may have more rows than these, which are not yet valid.
        self.outputs, self.steps = (int(n) for n in self.file["written"][0])
        if self.outputs == 0:
            raise Refusal(f"{path}: contains no output yet")
        # Stages of statics, which are not part of the run, have negative times.
        written = self.file["outputs/time"][: self.outputs]
        first = min(int(np.count_nonzero(written < 0)), self.outputs - 1)
        names = [text_of(name) for name in self.file["stages"][:]] if "stages" in self.file else []
        self.stages = names[: first + 1] if first > 0 else []  # stages with an output
        self.rows = range(first, self.outputs) if stage is None else range(stage, stage + 1)
        self.outputs, self.time = len(self.rows), written[self.rows.start : self.rows.stop]
        arc = self.file["nodes/arc_length"][:]
        self.lines = []
        for i, name in enumerate(self.file["lines/name"][:]):
            first, count = int(self.file["lines/first_node"][i]), int(self.file["lines/nodes"][i])
            self.lines.append(Line(text_of(name), i, slice(first, first + count), arc[first : first + count]))
        self.case = text_of(self.file["case"][()])
        self.changes = text_of(self.file["set"][()]).splitlines() if "set" in self.file else []  # KEY=VALUE of --set

    @cached_property
    def as_read(self):
        """The case as read by the program: output of `hawser check --json`. Empty for older versions."""
        if "case_read" not in self.file:
            return {}
        try:
            found = json.loads(text_of(self.file["case_read"][()]))
        except ValueError:
            found = None
        if not isinstance(found, dict) or not all(isinstance(found.get(key, {}), dict) for key in ("read", "given", "line_types")):
            raise Refusal(f"{self.path}: is damaged: its 'case_read' is not a case in JSON")
        return found

    @cached_property
    def keys(self):
        """All keys of the case with defaults, as changed by --set: numbers in SI units (angles in deg)."""
        return with_platforms(self.as_read, "read")

    @cached_property
    def given(self):
        """Keys given in the case and by --set, as written."""
        return with_platforms(self.as_read, "given")

    @property
    def inputs(self):
        """Files that must not be overwritten: these results and the input files of their run, at their original
        paths and, since results are moved together with their case, relative to these results."""
        case = self.attribute("case_path")
        read = [*([case] if case else []), *map(str, self.as_read.get("inputs", []))]
        beside = [self.path.parent / os.path.relpath(file, os.path.dirname(case)) for file in read] if case else []
        return [self.path, *read, *beside]

    def attribute(self, name):
        return text_of(self.file.attrs.get(name, ""))

    def line(self, name):
        for line in self.lines:
            if line.name == name:
                return line
        raise Refusal(f"there is no line '{name}' (there are: {', '.join(line.name for line in self.lines)})")

    @property
    def fields(self):
        """Names of the node fields."""
        return sorted(self.file["fields"])

    def has(self, field):
        return field in self.file["fields"]

    def unit(self, field):
        return text_of(self.file["fields"][field].attrs.get("unit", ""))

    def declared(self, field, what, fallback):
        """A declared property of a field; `fallback` for fields without it and files of older versions."""
        data = self.file["fields"].get(field)
        return fallback if data is None else data.attrs.get(what, fallback)

    def label(self, name):
        """Readable name of a field or a column of a history."""
        return text_of(self.declared(name, "label", name.replace("_", " ")))

    def ordered(self, fields):
        """Fields in the order of tables and reports."""
        return sorted(fields, key=lambda name: (int(self.declared(name, "order", 100)), name))

    def reported(self, *ways):
        """Fields with a range graph in reports ("graph"), or only a row in the table of extremes ("table")."""
        scalars = [name for name in self.fields if self.file["fields"][name].ndim == 2]
        return self.ordered(name for name in scalars if text_of(self.declared(name, "report", "graph")) in ways)

    @property
    def utilisations(self):
        """Quantity of each field that is a utilisation."""
        found = {name: text_of(self.declared(name, "utilisation", "")) for name in self.ordered(self.fields)}
        return {name: meaning for name, meaning in found.items() if meaning}

    def field(self, name, line, output=None):
        """Values at the nodes of a line: outputs x nodes (x 3), or nodes (x 3) of one output."""
        if not self.has(name):
            raise Refusal(f"there is no field '{name}' (there are: {', '.join(self.fields)})")
        rows = slice(self.rows.start, self.rows.stop) if output is None else self.rows[output]
        values = self.file["fields"][name][rows, line.nodes]
        if name == "position" and not np.all(np.abs(values) <= LARGEST):  # NaN fails as well
            raise Refusal(f"{self.path}: is damaged: line '{line.name}' has nodes whose position is not a number")
        return values

    def magnitude(self, name, line, output=None):
        """As `field`, with vectors replaced by their magnitude: outputs x nodes, or nodes of one output."""
        values = self.field(name, line, output)
        vectors = values.ndim == (3 if output is None else 2)
        return np.linalg.norm(values, axis=-1) if vectors else values

    def statistics(self, name, line):
        """Statistics of a field over all accepted steps at the nodes of a line: nodes (x 3) x 6, the last axis
        minimum, its time, maximum, its time, mean, standard deviation. None if the file has none."""
        data = self.file.get(f"statistics/{name}")
        return None if data is None else data[line.nodes]

    @property
    def ended(self):
        """True if the run has ended, regularly or by a signal."""
        return "summary" in self.file

    @property
    def statistics_from(self):
        """Start time of `statistics`, s."""
        return float(dictionary(self.keys.get("output")).get("statistics_from") or 0)

    @cached_property
    def line_series(self):
        """Place of a line's row in series with one row per line: (name of the table, number of the line)."""
        return {f"{line.name} {name}": (name, line.number) for name in self.file.get("line_series", {}) for line in self.lines}

    @cached_property
    def series_names(self):
        return ([n for n in self.file["series"] if n != "time"] if "series" in self.file else []) + list(self.line_series)

    @property
    def modes(self):
        """True if output k is a natural mode instead of a state at a time."""
        return self.has("mode_shape")

    @property
    def duration(self):
        """Duration in the case, s; 0: unknown."""
        return float(dictionary(self.keys.get("dynamics")).get("duration") or 0)

    def since(self, t):
        """Outputs at t [s] or later; at least two if there are several outputs."""
        keep = self.time >= t
        if self.outputs > 1 and np.count_nonzero(keep) < 2:
            raise Refusal(f"{self.path}: it has fewer than two outputs from t = {t:g} s on (the last one is at {self.time[-1]:g} s)")
        return keep

    @property
    def histories(self):
        """Places in the file of the series of `output.histories` and `output.clearances`."""
        return [n for n in self.series_names if n not in ("energy", "solver")] + self.points

    def series_name(self, key):
        """Name in the case of the series at this place in the file."""
        return key if key in self.line_series or key in self.points else text_of(self.file["series"][key].attrs.get("name", key))

    @cached_property
    def series_keys(self):
        """Places in the file by the names of series in the case."""
        return {self.series_name(key): key for key in self.series_names}

    def has_series(self, name):
        return name in self.series_keys

    def series_columns(self, key):
        """Columns and units of the series at this place in the file."""
        if key in self.points:
            series = self.point(key)
            return series.columns, series.units
        attributes = self.series_data(key).attrs
        return [text_of(c) for c in attributes["columns"]], [text_of(u) for u in attributes["units"]]

    def series_data(self, key):
        return self.file["line_series"][self.line_series[key][0]] if key in self.line_series else self.file["series"][key]

    def series_at(self, key):
        """Series at this place in the file, as of `series_names` and `histories`."""
        if key in self.points:
            return self.point(key)
        data, (_, line) = self.series_data(key), self.line_series.get(key, ("", None))
        return Series(self.series_name(key), *self.series_columns(key), data[: self.steps] if line is None else data[: self.steps, line])

    def series(self, name):
        """Series by its name in the case, else by its place in the file, which may be the name of another, else of a
        point of a body, HISTORY@X,Y,Z."""
        if name in self.series_keys or name in self.series_names:
            return self.series_at(self.series_keys.get(name, name))
        if points.split(name):
            return self.point(name)
        raise Refusal(f"there is no history '{name}' (there are: {', '.join(self.series_keys) or 'none'})")

    def point(self, name):
        """Motion of a point of a body, HISTORY@X,Y,Z [m, body frame]."""
        of, place = points.split(name) or (None, None)
        if of is None:
            raise Refusal(f"'{name}' is no point of a body: it is HISTORY@X,Y,Z, the name of its history and m in its frame")
        return Series(name, *points.motion(self, self.series(of), place))

    def add_points(self, names):
        """Adds points of bodies to the histories."""
        for name in names:
            self.point(name)
            if name not in self.points:
                self.points.append(name)

    @property
    def step_time(self):
        return self.file["series/time"][: self.steps] if "series" in self.file else np.zeros(0)

    def summary(self):
        """Rows (quantity, line, value, unit, time, arc length) over all steps; empty before the end of a run."""
        rows = self.file["summary"][:] if "summary" in self.file else []
        return [(text_of(r["quantity"]), text_of(r["line"]), float(r["value"]), text_of(r["unit"]),
                 float(r["time"]), float(r["arc_length"])) for r in rows]

    def ends(self, what):
        """'force', 'moment' or 'direction': outputs x ends x 3; empty if the file has none."""
        return self.file[f"ends/{what}"][self.rows.start : self.rows.stop] if f"ends/{what}" in self.file else None

    def clashes(self):
        """Names and units of columns, and rows of ended and ongoing clashes."""
        if "clashes" not in self.file or self.outputs == 0:
            return [], [], []
        ended, still = (int(n) for n in self.file["outputs/clashes"][self.rows[-1]])
        table = self.file["clashes/ended"]
        names = [n for n in table.dtype.names]
        units = [text_of(u) for u in table.attrs["units"]]
        rows = list(table[:ended]) + list(self.file["clashes/open"][self.rows[-1] % 2, :still])
        volumes = [text_of(v) for v in self.file["clashes/volume_name"][:]]

        def value(row, name):
            v = row[name]
            if name.endswith("line"):
                return self.lines[v].name if v >= 0 else ""
            if name.endswith("volume"):
                return volumes[v] if v >= 0 else ""
            return float(v)

        return names, units, [[value(r, n) for n in names] for r in rows]

    def messages(self):
        """Notes and warnings of the run."""
        return [text_of(m) for m in self.file["messages"][:]] if "messages" in self.file else []

    @property
    def bodies(self):
        return [text_of(n) for n in self.file["bodies/name"][:]] if "bodies/name" in self.file else []

    def volumes(self, output):
        """Name, vertices in space and triangles of each volume kept as a mesh."""
        for name, volume in self.file.get("volumes", {}).items():
            if "vertices" not in volume or "triangles" not in volume:
                continue
            x, body = volume["vertices"][:], int(volume.attrs.get("body", -1))
            if body >= 0:
                x = x @ self.rotation(body, output).T + self.file["bodies/position"][self.rows[output], body]
            yield text_of(volume.attrs.get("name", name)), x, volume["triangles"][:].reshape(-1, 3)

    def rotation(self, body, output):
        w, x, y, z = self.file["bodies/rotation"][self.rows[output], body]
        return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                         [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                         [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])
