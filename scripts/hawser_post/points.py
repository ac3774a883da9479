"""Motion of points of a body, from the history of the body, and their height above the sea (air gap)."""
import re

import numpy as np
from scipy.spatial.transform import Rotation

from .layout import Refusal
from .sea import Sea


def split(name):
    """(history, point [m, body frame]) of a name HISTORY@X,Y,Z; None: no such name."""
    found = re.fullmatch(r"(.+)@([^@,]+),([^@,]+),([^@,]+)", name)
    if not found:
        return None
    try:
        point = [float(x) for x in found.groups()[1:]]
    except ValueError:
        return None
    return (found.group(1), np.array(point)) if np.all(np.isfinite(point)) else None


def motion(results, body, point):
    """Columns, units and values (steps x columns) of a point of the body of a history, in space axes:

        x = x_O + R y,   v = v_O + omega x (R y),   a = a_O + alpha x (R y) + omega x (omega x (R y))

    and with water the height above the undisturbed waves there. Results without accelerations of bodies have none."""
    def vectors(what):
        return np.column_stack([body.column(f"{what}_{k}") for k in "xyz"])

    if "rotation_vector_x" not in body.columns:
        raise Refusal(f"'{body.name}' is no history of a body, of which there are points: ask for one by output.histories, "
                      "'- {body: NAME}'")
    arm = Rotation.from_rotvec(vectors("rotation_vector")).apply(point)
    omega = vectors("angular_velocity")
    place = vectors("position") + arm
    found = [("position", "m", place), ("velocity", "m/s", vectors("velocity") + np.cross(omega, arm))]
    if "acceleration_x" in body.columns:
        turning = np.cross(vectors("angular_acceleration"), arm) + np.cross(omega, np.cross(omega, arm))
        found.append(("acceleration", "m/s2", vectors("acceleration") + turning))
    columns = [f"{name}_{k}" for name, _, _ in found for k in "xyz"]
    units = [unit for _, unit, _ in found for _ in "xyz"]
    values = [x for _, _, x in found]
    sea = Sea(results)
    if sea.level is not None:
        columns.append("air_gap")
        units.append("m")
        values.append((place[:, 2] - sea.surface(place[:, 0], place[:, 1], results.step_time))[:, None])
    return columns, units, np.hstack(values)
