"""Content of the three-dimensional view of a results file: a header (JSON), and blocks of numbers."""
import itertools
from functools import cached_property

import numpy as np

from .. import charts
from ..layout import text_of
from ..results import dictionary
from ..sea import Sea
from . import blocks, colours, geometry, notes, parts
from .contacts import Contacts

# Positions are stored to half a millimetre; for models below 100 m to half of 10^-5 of their size, above 1000 m to half
# of 10^-6.
FINEST, SMALL_SHARE, LARGE_SHARE = 1e-3, 1e-5, 1e-6
ARROWS = ("seabed_force",)  # whose components are kept, for arrows at nodes
NOT_SHOWN = ("position", "axis_1", "axis_2", "mode_shape")
MOST_WAVES = 200  # components of the surface
MANY_POSES = 200_000  # numbers from which poses have single precision


class Model:
    """`every`: interval of the outputs shown, besides the last; `per_block`: outputs per block; `fields`: names of
    fields, None for all."""

    def __init__(self, results, every=1, per_block=None, fields=None):
        self.results, self.file = results, results.file
        self.rows = list(results.rows[::every])
        if self.rows[-1] != results.rows[-1]:
            self.rows.append(results.rows[-1])
        self.per_block = per_block or len(self.rows)
        self.missing = [] if every == 1 else [f"In three dimensions one in {every} of the {results.outputs} outputs is shown, and the last one."]
        self.shown = [name for name in results.ordered(results.fields) if name not in NOT_SHOWN and (fields is None or name in fields)]
        self.sea = Sea(results)
        self.contacts = Contacts.of(self.file, self.rows) if fields != () else None

    @cached_property
    def extent(self):
        return geometry.extent(self.results, self.rows)

    @cached_property
    def centre(self):
        """Origin of stored positions, near the middle of the model."""
        return np.round((self.extent[0] + self.extent[1]) / 2)

    @property
    def step(self):
        """Resolution of positions, m."""
        size = max(float((self.extent[1] - self.extent[0]).max()), 1e-3)
        return max(min(FINEST, SMALL_SHARE * size), LARGE_SHARE * size)

    @cached_property
    def bed(self):
        return geometry.bed(self.sea, *self.extent)

    def vector(self, name):
        return self.file["fields"][name].ndim == 3

    def part(self, k):
        """Rows of the file for part k of the outputs."""
        return self.rows[k * self.per_block : (k + 1) * self.per_block]

    def values(self, name, rows):
        """Values of a field at these rows of the file: rows x nodes, for vectors rows x 3 nodes (all x, all y, all
        z)."""
        data = self.file["fields"][name]
        slow = np.diff(rows).max(initial=1) > 1
        found = np.stack([data[row] for row in rows]) if slow else data[rows[0] : rows[-1] + 1]
        return found.transpose(0, 2, 1).reshape(len(rows), -1) if found.ndim == 3 else found

    def sizes(self, name, rows):
        """As `values`, with vectors replaced by their magnitude."""
        found = self.values(name, rows)
        return np.linalg.norm(found.reshape(len(rows), 3, -1), axis=1) if self.vector(name) else found

    def range_of(self, name):
        """Least and largest value over all outputs shown and all steps with statistics; None without values."""
        return self.range_over(name, (self.rows[k : k + 64] for k in range(0, len(self.rows), 64)))

    def range_over(self, name, parts):
        """The same over parts of the rows of the file, and over all steps if the file has statistics."""
        low, high = np.inf, -np.inf
        tables = (self.sizes(name, rows) for rows in parts)
        if self.with_statistics(name):
            tables = itertools.chain(tables, [self.file[f"statistics/{name}"][:][:, [0, 2]]])
        for x in tables:
            low, high = (float(f(x, where=np.isfinite(x), initial=i)) for f, i in ((np.min, low), (np.max, high)))
        return (low, high) if low <= high else None

    def field_headers(self):
        for name in self.shown if self.results.lines else ():
            found = self.range_of(name)
            if found is None:
                self.missing.append(f"The field '{self.results.label(name)}' contains no valid numbers and is not shown.")
                continue
            unit, factor = charts.shown(self.results.unit(name))
            yield {"name": name, "label": self.results.label(name), "unit": unit, "factor": factor, "low": found[0], "high": found[1],
                   "vector": name in ARROWS and self.vector(name), "statistics": self.with_statistics(name)}

    def with_statistics(self, name):
        """True if the results have statistics of the field over all steps."""
        data = self.file.get(f"statistics/{name}")
        return data is not None and data.ndim == 2 and not self.results.modes

    def volume_headers(self):
        """Volumes kept as meshes are referred to by their number in the file."""
        for key, volume in self.file.get("volumes", {}).items():
            if "vertices" in volume and "triangles" in volume and len(volume["triangles"]):
                yield {"key": key, "name": text_of(volume.attrs.get("name", key)), "body": int(volume.attrs.get("body", -1))}

    def touchdowns(self):
        """Table of touchdown points, steps x lines x columns; None if the file has none."""
        return self.file.get("line_series/touchdown")

    def header(self):
        results = self.results
        if "outputs/contact_points" not in self.file and any(f"fields/{name}" in self.file for name in ("contact_force", "line_contact_force")):
            self.missing.append("Contact forces are not shown: the results have no points of contact; run the case again to add them.")
        self.missing += [] if not self.unknown_bed() else ["The seabed is not drawn, since its file was not found beside the case or could not be read."]
        found = {
            "title": str(results.keys.get("title") or results.path.stem), "modes": results.modes,
            "times": [float(t) for t in self.file["outputs/time"][: self.rows[-1] + 1][self.rows]],
            "perBlock": self.per_block, "nodes": int(len(self.file["nodes/arc_length"])),
            "duration": results.duration, "ended": results.ended,
            "lines": [{"name": line.name, "first": line.nodes.start, "nodes": line.nodes.stop - line.nodes.start} for line in results.lines],
            "fields": list(self.field_headers()), "bodies": results.bodies, "volumes": list(self.volume_headers()),
            "touchdowns": [line.number for line in results.lines] if self.touchdowns() is not None else [],
            "low": list(self.extent[0] - self.centre), "high": list(self.extent[1] - self.centre), "centre": list(self.centre),
            "border": [list(place - self.centre[:2]) for place in geometry.border(*self.extent)],
            "sea": None if self.sea.level is None else
            {"level": self.sea.level - self.centre[2], "ramp": self.sea.ramp, "waves": not self.sea.still},
            "links": parts.links(results, self.centre), "points": parts.points(results),
            "contacts": None if self.contacts is None else {"largest": self.contacts.largest},
            "bed": self.bed is not None, "notes": notes.placed(results), "maps": colours.maps(),
            "histories": [{"name": results.series_name(key), "key": key, **self.columns(key)} for key in results.histories],
            "arcLength": "arc length from end A [m]", "missing": self.missing,
        }
        if not found["lines"]:
            found["missing"].append("This model has no lines.")
        return found

    def columns(self, key):
        columns, units = self.results.series_columns(key)
        shown = [charts.shown(unit) for unit in units]
        return {"columns": columns, "labels": [self.results.label(name) for name in columns], "units": [u for u, _ in shown], "factors": [f for _, f in shown]}

    def unknown_bed(self):
        return "seabed" in dictionary(self.results.keys.get("environment")) and self.bed is None

    def names(self):
        """Names of all blocks."""
        parts = range(-(-len(self.rows) // self.per_block))
        found = ["arc", "radius"] + ["bed"] * (self.bed is not None) + ["waves"] * (not self.sea.still)
        found += [f"statistics/{name}" for name in self.shown if self.with_statistics(name)]
        found += [f"volume/{v['key']}/{what}" for v in self.volume_headers() for what in ("vertices", "triangles")]
        moving = ["position"] + [f"field/{name}" for name in self.shown]
        moving += ["pose"] * bool(self.results.bodies) + ["touchdown"] * (self.touchdowns() is not None)
        moving += ["contact/place", "contact/force"] * bool(self.contacts and self.contacts.largest)
        return found + [f"{name}/{k}" for name in moving for k in parts]

    def block(self, name):
        """Bytes of a block; None for an unknown name."""
        what, _, rest = name.partition("/")
        if what == "arc":
            return blocks.plain(self.file["nodes/arc_length"][:], "float32")
        if what == "radius":
            return blocks.plain(geometry.radii(self.results), "float32")
        if what == "bed" and self.bed is not None:
            x, y, z = (values - self.centre[k] for k, values in enumerate(self.bed))
            return blocks.plain(np.concatenate([[len(x), len(y)], x, y, z.ravel()]), "float32")
        if what == "waves" and not self.sea.still:
            return self.waves()
        if what == "volume":
            return self.volume(rest)
        if what == "series":
            return self.series(rest)
        if what == "statistics" and rest in self.shown and self.with_statistics(rest):
            return blocks.plain(self.file[f"statistics/{rest}"][:][:, [0, 4, 2]].T, "float32")
        field, _, part = rest.rpartition("/")
        if not part.isascii() or not part.isdigit() or not self.part(int(part)):
            return None
        return self.moving(what, field, self.part(int(part)))

    def moving(self, what, field, rows):
        """A time-dependent block."""
        if what == "position":
            x = self.values("position", rows).reshape(len(rows), 3, -1) - self.centre[:, None]
            return blocks.steps(x.reshape(len(rows), -1), self.step)
        if what == "field" and field in self.shown:
            # Nodal forces have components, for arrows; other vectors their magnitude.
            return blocks.shares(self.values(field, rows) if field in ARROWS else self.sizes(field, rows))
        if what == "pose" and self.results.bodies:
            pose = [np.concatenate([self.file["bodies/position"][r] - self.centre, self.file["bodies/rotation"][r]], axis=1) for r in rows]
            pose = np.reshape(pose, (len(rows), -1))
            return blocks.plain(pose, "float32" if pose.size > MANY_POSES else "float64")
        if what == "contact" and self.contacts and field in ("place", "force"):
            return self.contacts.block(field, rows, self.centre, self.step)
        if what == "touchdown":
            return self.touchdown(rows)
        return None

    def touchdown(self, rows):
        """Touchdown points from both ends of each line, at the steps nearest to the outputs."""
        time, table = self.results.step_time, self.touchdowns()
        if not len(time) or table is None:
            return None
        at = np.abs(time[None, :] - self.file["outputs/time"][: rows[-1] + 1][rows][:, None]).argmin(axis=1) if len(time) < 2000 else \
            np.clip(np.searchsorted(time, self.file["outputs/time"][: rows[-1] + 1][rows] - 1e-9), 0, len(time) - 1)
        names = [text_of(column) for column in table.attrs["columns"]]
        columns = [names.index(f"end_{end}_position_{axis}") for end in "ab" for axis in "xyz"]
        found = np.stack([table[k][:, columns] for k in at]) - np.tile(self.centre, 2)
        return blocks.steps(found.reshape(len(at), -1), self.step)

    def waves(self):
        components = self.sea.components
        kept = components[np.argsort(-np.abs(components[:, 0]))[:MOST_WAVES]]
        # Phases relative to the centre, the origin of positions.
        phase = kept[:, 5] + kept[:, 2] * (kept[:, 3] * self.centre[0] + kept[:, 4] * self.centre[1])
        return blocks.plain(np.column_stack([kept[:, :5], np.mod(phase, 2 * np.pi)]), "float64")

    def volume(self, rest):
        key, _, what = rest.rpartition("/")
        if key not in {v["key"] for v in self.volume_headers()} or what not in ("vertices", "triangles"):
            return None
        volume = self.file["volumes"][key]
        if what == "triangles":
            return blocks.steps(volume["triangles"][:], 1.0)
        x = volume["vertices"][:] - (self.centre if int(volume.attrs.get("body", -1)) < 0 else 0.0)
        return blocks.steps(x, min(self.step, 1e-4 * max(float(np.ptp(x, axis=0).max()), 1e-6)))

    def series(self, key):
        """Times and columns of a history, thinned if there are very many steps."""
        if key not in self.results.histories:
            return None
        series, time = self.results.series_at(key), self.results.step_time
        thin = slice(None, None, max(1, len(time) // 20000))
        return blocks.plain(np.vstack([time[thin], series.values[thin].T]), "float32")
