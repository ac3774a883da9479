"""Content of the server: results, which may grow, or the start shape of a case before its first run."""
import hashlib
import os
import shlex
import tempfile
import threading
import time
from pathlib import Path

import numpy as np

from ..arguments import read_case, refuse_changes
from ..results import Refusal, Results
from . import blocks, notes, start_shape
from .model import Model

BLOCK_VALUES = 1_000_000  # positions per part
MOST_OUTPUTS = 512  # per part
SAMPLE = 40  # number of outputs sampled for the range of a field
OFTEN = 0.7  # s between checks of the files


class ServedModel(Model):
    """Model in parts, as a page requests it; ranges are from statistics over all steps and a sample of the outputs."""

    def __init__(self, results, fields=None):
        nodes = max(1, len(results.file["nodes/arc_length"]))
        super().__init__(results, per_block=int(np.clip(BLOCK_VALUES // (3 * nodes), 1, MOST_OUTPUTS)), fields=fields)

    def range_of(self, name):
        every_step = self.with_statistics(name) and not self.results.statistics_from  # may exclude the start
        places = np.unique(np.linspace(0, len(self.rows) - 1, 2 if every_step else SAMPLE).astype(int))
        return self.range_over(name, ([self.rows[k]] for k in places))

    def block(self, name):
        what, _, rest = name.partition("/")
        if what != "ends":
            return super().block(name)
        field, _, line = rest.rpartition("/")
        if field not in self.shown or not line.isascii() or not line.isdigit() or int(line) >= len(self.results.lines):
            return None
        nodes = self.results.lines[int(line)].nodes
        rows = slice(self.rows[0], self.rows[-1] + 1)
        found = [self.file["fields"][field][rows, node] for node in (nodes.start, nodes.stop - 1)]
        return blocks.plain([np.linalg.norm(x, axis=-1) if x.ndim == 2 else x for x in found], "float32")


class Shown:
    """Thread-safe: one request at a time reads files."""

    def __init__(self, given, changes=()):
        self.lock, self.model, self.words, self.checked_at, self.read_state = threading.Lock(), None, "", 0.0, None
        self.changes, self.folder = changes, None
        path = Path(given)
        self.case = path if path.suffix in (".yaml", ".yml") else None
        self.path = path
        if not self.case:
            refuse_changes(path, changes)
        else:
            case = read_case(path, changes)
            self.path = Path(case["results"] if path.is_absolute() else os.path.relpath(case["results"]))
            self.inputs = [Path(file) for file in case["inputs"]]
        self.look()

    # Files on the disk.

    def stamp_of(self, path):
        try:
            found = path.stat()
            return found.st_ino, found.st_mtime_ns, found.st_size
        except OSError:
            return None

    def newest_input(self):
        return max((file.stat().st_mtime for file in self.inputs if file.exists()), default=0.0)

    def run_is_current(self):
        return self.path.is_file() and (not self.case or self.path.stat().st_mtime >= self.newest_input())

    def look(self):
        """Opens the content, again if it has changed."""
        if time.monotonic() - self.checked_at < OFTEN and self.model:
            return
        current = self.run_is_current() or not self.case
        now = self.stamp_of(self.path) if current else ("start", *(self.stamp_of(file) for file in self.inputs))
        if now == self.read_state and self.model:
            self.checked_at = time.monotonic()
            return
        if self.model is not None:  # HDF5 would return cached data of the old file
            self.model.results.file.close()
        try:
            self.show(ServedModel(Results(self.path)) if current else self.start(), "run" if current else "start")
            self.read_state = now
        except (Refusal, OSError, KeyError, ValueError, RuntimeError) as error:
            # Before the first output of a run shows the start shape; otherwise the next check may find a
            # readable file.
            if current and self.case and (self.model is None or self.kind == "start"):
                self.show(self.start(), "start")
            elif self.model is None:
                raise
            self.words, self.read_state = str(error).splitlines()[0], None
        self.checked_at = time.monotonic()

    def show(self, model, kind):
        self.model, self.kind, self.words = model, kind, ""
        if kind == "run":  # the same during a run, although its file may be rebuilt at its end
            results = model.results
            key = f"{results.attribute('date')} {results.changes} {[(line.name, line.nodes) for line in results.lines]} {results.case}"
        else:
            key = f"start {time.time_ns()}"
        self.stamp = hashlib.sha256(key.encode()).hexdigest()[:16]

    def start(self):
        messages = start_shape.notes_of(self.case, self.changes)
        if self.folder is None:
            self.folder = tempfile.TemporaryDirectory(prefix="hawser-view-")
        folder = tempfile.mkdtemp(dir=self.folder.name)
        results = start_shape.start_of(self.case, self.changes, folder)
        model = ServedModel(results, fields=())  # without fields, since no force is known before statics
        model.check_notes = messages
        return model

    # Requests.

    def header(self):
        with self.lock:
            self.look()
            found = self.model.header()
            messages = getattr(self.model, "check_notes", None)
            if messages is not None:
                found["notes"] = notes.placed(self.model.results, messages)
                command = shlex.join(["hawser", "run", str(self.case), *(word for change in self.changes for word in ("--set", change))])
                found["missing"] = [*found["missing"], "This is the start shape, before statics. The results appear here when the case is run in "
                                    f"another terminal: {command}"]
            return {**found, "served": True, "stamp": self.stamp, "storedHistories": self.kind == "run"}

    def status(self):
        with self.lock:
            self.look()
            results = self.model.results
            return {"stamp": self.stamp, "kind": self.kind, "outputs": len(self.model.rows), "time": float(results.time[-1]),
                    "duration": results.duration, "ended": results.ended, "words": self.words}

    def block(self, name):
        with self.lock:
            return self.model.block(name)

    def close(self):
        if self.folder:
            self.folder.cleanup()
