"""Data sets of a results file and their shapes (docs/user-guide/results.md). Damaged files and files of other
programs are refused with a sentence when opened."""
import h5py
import numpy as np


class Refusal(Exception):
    """The user's request is impossible; the text is one sentence."""


def text_of(value):
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


LARGEST = 1e60  # larger than any number accepted from a case
NUMBERS, INTEGERS, TEXTS, RECORDS = "numbers", "whole numbers", "texts", "records"
KINDS = {NUMBERS: "fiu", INTEGERS: "iu", TEXTS: "SOU", RECORDS: "V"}


class AtLeast(int):
    """A minimum number of rows: a run in progress has more than have been written."""


class Layout:
    def __init__(self, file, path):
        self.file, self.path = file, path

    def bad(self, name, why):
        raise Refusal(f"{self.path}: is damaged or of another version: '{name}' {why}")

    def data(self, name, kind, *shape, needed=True):
        """Data set, or None if absent. shape: extent of each dimension, None for any."""
        try:
            found = self.file.get(name)
        except (KeyError, OSError, RuntimeError, ValueError) as error:  # a dangling link or unreadable header
            self.bad(name, f"cannot be read ({str(error).splitlines()[0]})")
        if found is None:
            return self.bad(name, "is missing") if needed else None
        if not isinstance(found, h5py.Dataset) or found.shape is None:
            self.bad(name, "is not a data set with values")
        if found.dtype.kind not in KINDS[kind]:
            self.bad(name, f"does not contain {kind}")
        fits = len(found.shape) == len(shape) and all(
            n is None or (have >= n if isinstance(n, AtLeast) else have == n) for have, n in zip(found.shape, shape))
        if not fits:
            expected = " x ".join("any" if n is None else f"{int(n)} or more" if isinstance(n, AtLeast) else str(n) for n in shape)
            self.bad(name, f"is {' x '.join(map(str, found.shape)) or 'one value'}, not {expected or 'one value'}")
        return found

    def group(self, name):
        """Names in a group, empty if it is absent."""
        found = self.file.get(name)
        if found is not None and not isinstance(found, h5py.Group):
            self.bad(name, "is not a group of data sets")
        return [] if found is None else list(found)

    def finite(self, name, values, growing=False):
        if not np.all(np.abs(values) <= LARGEST) or growing and np.any(np.diff(values) < 0):  # NaN fails as well
            self.bad(name, "does not contain increasing numbers" if growing else "contains values that are not valid numbers of this kind")

    def records(self, name, *columns, shape=(None,), needed=True):
        found = self.data(name, RECORDS, *shape, needed=needed)
        for column in columns if found is not None else ():
            if column not in found.dtype.names:
                self.bad(name, f"has no column '{column}'")
        return found

    def check(self):
        written = self.records("written", shape=(AtLeast(1),))
        first = written[0].item()
        if len(first) != 2 or not all(isinstance(n, int) and n >= 0 for n in first):
            self.bad("written", "does not contain the numbers of outputs and steps")
        self.outputs, self.steps = first
        self.finite("outputs/time", self.data("outputs/time", NUMBERS, AtLeast(self.outputs))[: self.outputs], growing=True)
        for name in ("case", "set", "case_read"):
            self.data(name, TEXTS, needed=name == "case")
        for name in ("stages", "messages"):
            self.data(name, TEXTS, None, needed=False)
        self.records("summary", "quantity", "line", "value", "unit", "time", "arc_length", needed=False)
        self.check_lines()
        self.check_fields()
        self.check_series()
        self.check_bodies()
        self.check_clashes()
        for name, shape in (("components", (None, 6)), ("level", (1,)), ("ramp", (1,))):
            if "waves" in self.file:
                self.finite(f"waves/{name}", self.data(f"waves/{name}", NUMBERS, *shape)[:])

    def check_lines(self):
        arc = self.data("nodes/arc_length", NUMBERS, None)
        self.lines, self.nodes = len(self.data("lines/name", TEXTS, None)), len(arc)
        first, nodes = (self.data(f"lines/{name}", INTEGERS, self.lines)[:].astype(int) for name in ("first_node", "nodes"))
        if np.any(first < 0) or np.any(nodes < 2) or np.any(first + nodes > self.nodes):
            self.bad("lines/nodes", f"refers to nodes beyond the {self.nodes} in the file")
        for begin, count in zip(first, nodes):
            self.finite("nodes/arc_length", arc[begin : begin + count], growing=True)

    def check_fields(self):
        for name in self.group("fields"):
            components = (3,) if len(getattr(self.file[f"fields/{name}"], "shape", ())) == 3 else ()
            found = self.data(f"fields/{name}", NUMBERS, AtLeast(self.outputs), AtLeast(self.nodes), *components)
            if not np.issubdtype(np.asarray(found.attrs.get("order", 0)).dtype, np.number):
                self.bad(f"fields/{name}", "has an 'order' that is not a number")
        for name in ("position", "mode_shape"):
            self.data(f"fields/{name}", NUMBERS, AtLeast(self.outputs), AtLeast(self.nodes), 3, needed=name == "position")
        for name in self.group("statistics"):
            components = (3,) if len(getattr(self.file[f"statistics/{name}"], "shape", ())) == 3 else ()
            self.data(f"statistics/{name}", NUMBERS, AtLeast(self.nodes), *components, 6)
        for name in self.group("ends"):
            self.data(f"ends/{name}", NUMBERS, AtLeast(self.outputs), 2 * self.lines, 3)

    def check_series(self):
        names = self.group("series")
        if not names and self.steps == 0:
            return
        self.finite("series/time", self.data("series/time", NUMBERS, AtLeast(self.steps))[: self.steps], growing=True)
        places = [(f"series/{name}", ()) for name in names if name != "time"]
        places += [(f"line_series/{name}", (self.lines,)) for name in self.group("line_series")]
        for place, lines in places:
            found = self.data(place, NUMBERS, AtLeast(self.steps), *lines, None)
            for of in ("columns", "units"):
                if np.shape(found.attrs.get(of)) != found.shape[-1:]:
                    self.bad(place, f"has {found.shape[-1]} columns and another number of '{of}'")

    def check_bodies(self):
        names = self.data("bodies/name", TEXTS, None, needed=False)
        self.bodies = 0 if names is None else len(names)
        for name, size in (("position", 3), ("rotation", 4)):
            if self.bodies:
                found = self.data(f"bodies/{name}", NUMBERS, AtLeast(self.outputs), self.bodies, size)
                self.finite(f"bodies/{name}", found[: self.outputs])
        for name in self.group("volumes"):
            if {"vertices", "triangles"} <= set(self.group(f"volumes/{name}")):
                place = f"volumes/{name}"
                vertices = self.data(f"{place}/vertices", NUMBERS, None, 3)
                self.finite(f"{place}/vertices", vertices[:])
                corners = self.data(f"{place}/triangles", INTEGERS, None, 3)[:].astype(int)
                if np.any(corners < 0) or np.any(corners >= len(vertices)):
                    self.bad(f"{place}/triangles", f"refers to vertices beyond the {len(vertices)} in the file")
                body = self.file[place].attrs.get("body", -1)
                if np.asarray(body).dtype.kind not in "iu" or np.ndim(body) != 0 or not -1 <= body < self.bodies:
                    self.bad(place, f"refers to a 'body' beyond the {self.bodies} in the file")

    def check_clashes(self):
        if "clashes" not in self.file or self.outputs == 0:
            return
        counts = self.data("outputs/clashes", INTEGERS, AtLeast(self.outputs), 2)[self.outputs - 1]
        ended = self.records("clashes/ended")
        still = self.records("clashes/open", *ended.dtype.names, shape=(2, None))
        volumes = len(self.data("clashes/volume_name", TEXTS, None))
        if not 0 <= counts[0] <= len(ended) or not 0 <= counts[1] <= still.shape[1]:
            self.bad("outputs/clashes", "gives more clashes than the file contains")
        if np.shape(ended.attrs.get("units")) != (len(ended.dtype.names),):
            self.bad("clashes/ended", "has a different number of columns and 'units'")
        for place, rows in (("clashes/ended", ended[: counts[0]]), ("clashes/open", still[(self.outputs - 1) % 2, : counts[1]])):
            for column in ended.dtype.names:
                most = self.lines if column.endswith("line") else volumes if column.endswith("volume") else None
                if rows.dtype[column].kind not in ("fiu" if most is None else "iu"):
                    self.bad(place, f"has a column '{column}' that does not contain numbers")
                if most is not None and np.any((rows[column] < -1) | (rows[column] >= most)):
                    self.bad(place, f"refers in column '{column}' to items that are not in the file")


def dictionary(value):
    return value if isinstance(value, dict) else {}


def check_layout(file, path):
    """Refuses a results file with missing data sets or with wrong types or shapes."""
    Layout(file, path).check()
