"""Points of contact with their forces, as arrows of a model: of each output the largest forces."""
import numpy as np

from . import blocks

MOST = 300  # of an output
SMALLEST = 0.02  # of the largest force of the run: smaller ones are not shown
PARTS = 10_000  # of the largest force, to which components are kept
ROWS = 1_000_000  # read at once


class Contacts:
    """`rows`: the outputs that are shown, by their rows in the file."""

    def __init__(self, file, rows):
        self.file = file
        ends = file["outputs/contact_points"][: rows[-1] + 1]
        self.starts = dict(zip(rows, np.concatenate([[0], ends])[rows].tolist()))
        self.ends = dict(zip(rows, ends[rows].tolist()))
        self.largest = self.largest_force(int(ends[-1]))

    @staticmethod
    def of(file, rows):
        """None where the file has none."""
        return Contacts(file, rows) if "outputs/contact_points" in file else None

    def largest_force(self, points):
        """N, of all outputs up to the last one that is shown."""
        force = self.file["contact_points/force"]
        parts = (np.linalg.norm(force[k : min(k + ROWS, points)], axis=1) for k in range(0, points, ROWS))
        return max((float(np.max(part, where=np.isfinite(part), initial=0)) for part in parts), default=0.0)

    def at(self, row):
        """Places and forces of the largest of an output, in the order of the file."""
        part = slice(self.starts[row], self.ends[row])
        place, force = self.file["contact_points/position"][part], self.file["contact_points/force"][part]
        size = np.linalg.norm(force, axis=1)
        kept = np.flatnonzero(size > SMALLEST * self.largest)
        kept = np.sort(kept[np.argsort(-size[kept], kind="stable")[:MOST]])
        return place[kept].astype(float), force[kept].astype(float)

    def tables(self, rows, centre):
        """Places from the centre and forces of outputs: rows x 3 columns of each (all x, all y, all z); NaN after the last point of an output."""
        found = [self.at(row) for row in rows]
        most = max((len(place) for place, _ in found), default=0)
        out = np.full((2, len(rows), 3, most), np.nan)
        for k, (place, force) in enumerate(found):
            out[0, k, :, : len(place)] = (place - centre).T
            out[1, k, :, : len(force)] = force.T
        return out.reshape(2, len(rows), -1)

    def block(self, what, rows, centre, step):
        """`what`: place or force."""
        place, force = self.tables(rows, centre)
        return blocks.steps(place, step) if what == "place" else blocks.steps(force, self.largest / PARTS)
