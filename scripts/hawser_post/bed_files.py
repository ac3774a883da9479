"""Heights of a gridded or meshed bed from a file beside the case, for pictures: a function of x and y, NaN without a
bed."""
import re
from pathlib import Path

import numpy as np
from scipy.interpolate import LinearNDInterpolator, RegularGridInterpolator
from scipy.spatial import QhullError

LARGEST = 200_000_000  # bytes, largest file that is read
MOST_VERTICES = 100_000  # vertices used of a mesh; larger ones are sampled
PLY_TYPES = {"char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "short": "i2", "int16": "i2", "ushort": "u2", "uint16": "u2",
             "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4", "float": "f4", "float32": "f4", "double": "f8", "float64": "f8"}


def surface_of(results, bed):
    """Surface for the keys of a seabed; None if its file is missing or holds no such surface."""
    kind = "grid" if "grid" in bed else "mesh"
    keys = bed[kind] if isinstance(bed[kind], dict) else {}
    name = Path(str(keys.get("file", "")))
    for folder in (Path(results.attribute("case_path")).parent, results.path.parent):
        path = folder / name
        try:
            if not path.is_file() or path.stat().st_size > LARGEST:
                continue
            return grid(path, bool(keys.get("depths"))) if kind == "grid" else sheet(path, float(keys.get("scale") or 1.0))
        except (OSError, ValueError, IndexError, KeyError, TypeError, QhullError):
            continue
    return None


def grid(path, depths):
    """Interpolates between the heights of rows x, y, z, one for every x and every y."""
    lines = path.read_text(encoding="utf-8", errors="replace").replace(",", " ").splitlines()
    rows = np.loadtxt(lines, ndmin=2)[:, :3]
    xs, ys = np.unique(rows[:, 0]), np.unique(rows[:, 1])
    if len(xs) < 2 or len(ys) < 2 or len(xs) * len(ys) != len(rows):
        raise ValueError("no grid")
    z = np.empty((len(xs), len(ys)))
    z[np.searchsorted(xs, rows[:, 0]), np.searchsorted(ys, rows[:, 1])] = rows[:, 2] * (-1 if depths else 1)
    return RegularGridInterpolator((xs, ys), z, bounds_error=False)


def sheet(path, scale):
    """Interpolates between the vertices of a mesh with one height at each place, ignoring its triangles."""
    x = np.unique(scale * vertices(path.read_bytes()), axis=0)
    x = x[:: -(-len(x) // MOST_VERTICES)]
    return LinearNDInterpolator(x[:, :2], x[:, 2])


def vertices(data):
    """Vertices (n x 3) from the bytes of an STL, OBJ or PLY file."""
    number = rb"([-+.\deE]+)"
    if data.startswith(b"ply"):
        return ply_vertices(data)
    count = int.from_bytes(data[80:84], "little")
    if len(data) == 84 + 50 * count and count:  # a binary STL
        facets = np.frombuffer(data, np.dtype([("normal", "<f4", 3), ("x", "<f4", (3, 3)), ("more", "<u2")]), count, 84)
        return facets["x"].reshape(-1, 3).astype(float)
    word = rb"vertex" if data.lstrip().startswith(b"solid") else rb"v"
    found = re.findall(rb"^\s*" + word + rb"\s+" + rb"\s+".join([number] * 3), data, re.MULTILINE)
    return np.array(found, float).reshape(-1, 3)


def ply_vertices(data):
    head, mark, body = data.partition(b"end_header")
    body = body[body.index(b"\n") + 1 :]
    words = [line.split() for line in head.decode("ascii", "replace").splitlines()]
    form = [w[1] for w in words if w[:1] == ["format"]][0]
    first = [k for k, w in enumerate(words) if w[:1] == ["element"]][0]
    if words[first][1] != "vertex":
        raise ValueError("vertices are not first")
    names = []
    for w in words[first + 1 :]:
        if w[:1] == ["element"]:
            break
        if w[:1] == ["property"]:
            names.append((w[2], PLY_TYPES[w[1]]))
    count = int(words[first][2])
    if form == "ascii":
        rows = np.array([line.split()[: len(names)] for line in body.splitlines()[:count]], float)
        at = [name for name, _ in names]
        return rows[:, [at.index(axis) for axis in "xyz"]]
    order = "<" if form == "binary_little_endian" else ">"
    found = np.frombuffer(body, np.dtype([(name, order + kind) for name, kind in names]), count)
    return np.stack([found[axis].astype(float) for axis in "xyz"], axis=1)
