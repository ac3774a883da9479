"""Surface of the sea and the seabed of a run as heights over x and y, for pictures."""
import numpy as np

from .bed_files import surface_of
from .layout import dictionary


def ramp_at(t, ramp):
    """Factor of a smooth start at time t, the quintic of the solver."""
    z = np.clip(t / ramp, 0, 1) if ramp > 0 else 1.0
    return z**3 * (10 + z * (6 * z - 15))


class Sea:
    """Sea of a run. `level`: still water level [m], None without water; `bed`: the seabed is known."""

    def __init__(self, results):
        environment = dictionary(results.keys.get("environment"))
        water = dictionary(environment.get("water"))
        self.level = water.get("surface", 0.0) if "water" in environment else None
        self.components, self.ramp = None, 0.0
        if "waves/components" in results.file:
            self.components = results.file["waves/components"][:]
            self.level, self.ramp = float(results.file["waves/level"][0]), float(results.file["waves/ramp"][0])
        self.plane = self.measured = None
        if "seabed" in environment:
            bed = dictionary(environment["seabed"])
            if "grid" in bed or "mesh" in bed:
                self.measured = surface_of(results, bed)
            else:
                depth = bed.get("depth", water.get("depth"))  # below z = 0, as in the solver
                slope, way = (np.radians(bed.get(k, 0.0)) for k in ("slope_deg", "slope_direction_deg"))
                self.plane = None if depth is None else (depth, np.tan(slope) * np.cos(way), np.tan(slope) * np.sin(way))

    @property
    def bed(self):
        return self.plane is not None or self.measured is not None

    @property
    def still(self):
        return self.components is None

    def surface(self, x, y, t):
        """Height z [m] of the water at places (x, y) at a time [s]."""
        x, y = np.broadcast_arrays(np.asarray(x, float), y)
        z = np.full(x.shape, self.level)
        if self.components is None:
            return z
        raised = np.zeros(x.shape)
        for amplitude, omega, k, dx, dy, phase in self.components:
            raised += amplitude * np.cos(k * (dx * x + dy * y) - omega * t + phase)
        return z + ramp_at(t, self.ramp) * raised

    def seabed(self, x, y):
        """Height z [m] of the seabed; NaN outside a measured bed."""
        x, y = np.broadcast_arrays(np.asarray(x, float), y)
        if self.measured is not None:
            return self.measured(np.stack([x, y], axis=-1))
        depth, down_x, down_y = self.plane
        return -depth - down_x * x - down_y * y
