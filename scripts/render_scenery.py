"""Parts of a picture in addition to lines and volumes, from the .h5 beside the .xdmf: the sea surface with its
waves, the seabed, buoys and clump weights, joints, bodies without a volume, names, and the thickness of lines."""
import math
import os
import sys

from paraview import simple as pv
from paraview import vtk
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkPolyDataNormals
from vtkmodules.vtkFiltersSources import vtkSphereSource

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import numpy as np  # noqa: E402

from hawser_post.results import Refusal, Results, dictionary  # noqa: E402
from hawser_post.sea import Sea  # noqa: E402
from hawser_post.stress import of_type  # noqa: E402

SEA, BED, BUOY, JOINT, BODY = [0.35, 0.60, 0.85], [0.80, 0.72, 0.56], [0.93, 0.60, 0.15], [0.25, 0.25, 0.28], [0.45, 0.48, 0.55]
PLACES = 120  # along a side of the surface of the sea and of the seabed
MOST_NAMES = 24


def results_beside(xdmf):
    """The results of a run, or None if the .xdmf has no results beside it."""
    try:
        return Results(os.path.splitext(xdmf)[0] + ".h5")
    except (Refusal, KeyError):
        return None


def sections_of(results):
    """For each line, by number, (end of a part by arc length, m, and its outer diameter, m); diameters
    missing from the case are NaN."""
    types, lines = dictionary(results.keys.get("line_types")), dictionary(results.keys.get("lines"))
    out = []
    for line in results.lines:
        sections = dictionary(lines.get(line.name)).get("sections") or []
        ends = np.cumsum([s["length"] for s in sections])
        widths = [of_type(dictionary(types.get(s["type"])))[0] for s in sections]
        if len(ends) == 0:
            ends, widths = [line.length], [math.nan]
        out.append([(float(e), float(w)) for e, w in zip(ends, widths)])
    return out


class Shape:
    """A surface that is computed again for every time."""

    def __init__(self, view, colour, opacity=1.0, specular=0.0):
        self.source = pv.TrivialProducer()
        self.source.GetClientSideObject().SetOutput(vtk.vtkPolyData())
        self.shown = pv.Show(self.source, view)
        self.shown.DiffuseColor = self.shown.AmbientColor = colour
        self.shown.Ambient, self.shown.Diffuse, self.shown.Opacity, self.shown.Specular = 0.45, 0.55, opacity, specular

    def set(self, surface):
        self.source.GetClientSideObject().SetOutput(surface)
        self.source.MarkModified(None)
        self.source.UpdatePipeline()


def sheet(x, y, z):
    """A surface over a grid, without the places where z is NaN."""
    points, cells = vtk.vtkPoints(), vtk.vtkCellArray()
    points.SetData(numpy_to_vtk(np.stack([x, y, np.nan_to_num(z)], axis=-1).reshape(-1, 3), deep=True))
    rows, columns = z.shape
    there = np.isfinite(z)
    for i in range(rows - 1):
        for j in range(columns - 1):
            if there[i : i + 2, j : j + 2].all():
                cells.InsertNextCell(4)
                for k in (i * columns + j, i * columns + j + 1, (i + 1) * columns + j + 1, (i + 1) * columns + j):
                    cells.InsertCellPoint(k)
    surface = vtk.vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(cells)
    normals = vtkPolyDataNormals()
    normals.SetInputData(surface)
    normals.Update()
    return normals.GetOutput()


def balls(places):
    """One surface of spheres: (centre, radius)."""
    joined = vtkAppendPolyData()
    joined.AddInputData(vtk.vtkPolyData())
    for centre, radius in places:
        ball = vtkSphereSource()
        ball.SetCenter(*centre)
        ball.SetRadius(radius)
        ball.SetThetaResolution(24)
        ball.SetPhiResolution(16)
        ball.Update()
        joined.AddInputData(ball.GetOutput())
    joined.Update()
    return joined.GetOutput()


class Scenery:
    """`lower`, `upper`: corners of the model, m. `size`: of a mark without a physical size, m; `thick`: largest radius of
    a line as it is drawn, m."""

    def __init__(self, view, results, lower, upper, size, thick, sea=True, names=True):
        self.results, self.size, self.view = results, size, view
        self.joint = max(0.6 * size, 1.2 * thick)
        lower, upper = np.array(lower), np.array(upper)
        wide = 0.12 * max((upper - lower)[:2].max(), 0.5 * (upper - lower)[2])
        x, y = (np.linspace(lower[k] - wide, upper[k] + wide, PLACES) for k in (0, 1))
        self.x, self.y = np.meshgrid(x, y, indexing="ij")
        self.sea = Sea(results)
        self.water = Shape(view, SEA, 0.35, 0.3) if sea and self.sea.level is not None else None
        if sea and self.sea.bed:
            Shape(view, BED).set(sheet(self.x, self.y, self.sea.seabed(self.x, self.y)))
        self.buoys, self.joints, self.bodies = (Shape(view, c, 1.0, 0.2) for c in (BUOY, JOINT, BODY))
        self.case = [dictionary(dictionary(results.keys.get("lines")).get(line.name)) for line in results.lines]
        with_mesh = {int(v.attrs.get("body", -1)) for v in results.file.get("volumes", {}).values()}
        self.bare = [b for b in range(len(results.bodies)) if b not in with_mesh]
        self.tops = self.tops_of_bodies()
        self.names = [self.label(name) for name, _ in self.named(0)] if names else []

    def at_time(self, time):
        output = int(abs(self.results.time - time).argmin())
        if self.water:
            t = 0.0 if self.results.modes else float(self.results.time[output])
            self.water.set(sheet(self.x, self.y, self.sea.surface(self.x, self.y, t)))
        self.buoys.set(balls(self.masses(output)))
        self.joints.set(balls((x, self.joint) for _, x in self.joined(output)))
        self.bodies.set(balls((self.body(b, output), self.size) for b in self.bare))
        for shown, (_, place) in zip(self.names, self.named(output)):
            shown.BillboardPosition = [float(v) for v in place + np.array([0, 0, 1.2 * self.size])]

    def tops_of_bodies(self):
        """m, height of the volumes of each body above its origin at the start, for the position of its name."""
        tops = {}
        for volume in self.results.file.get("volumes", {}).values():
            b = int(volume.attrs.get("body", -1))
            if b >= 0 and len(volume["vertices"]):
                z = (volume["vertices"][:] @ self.results.rotation(b, 0).T)[:, 2].max()
                tops[b] = max(tops.get(b, 0.0), float(z))
        return tops

    def body(self, b, output):
        return self.results.file["bodies/position"][self.results.rows[output], b]

    def masses(self, output):
        """Buoys and clump weights as balls of their volume, others as marks."""
        for line, keys in zip(self.results.lines, self.case):
            masses = keys.get("masses")
            if not masses:
                continue
            x = self.results.field("position", line, output)
            for mass in masses:
                at = {"end_a": 0.0, "end_b": line.length}.get(mass["at"], mass["at"])
                centre = [np.interp(at, line.arc, x[:, k]) for k in range(3)]
                yield centre, max((0.75 * mass["volume"] / math.pi) ** (1 / 3), 0.5 * self.size)

    def joined(self, output):
        """Name and position of each joint, from the end of the first line attached to it."""
        found = {}
        for line, keys in zip(self.results.lines, self.case):
            for k, key in enumerate(("end_a", "end_b")):
                name = dictionary(keys.get(key)).get("joint")
                if name and name not in found:
                    found[name] = self.results.field("position", line, output)[-k]
        return list(found.items())

    def named(self, output):
        """Names and their positions: lines, joints, bodies, and fixed volumes."""
        out = [(line.name, self.results.field("position", line, output)[len(line.arc) // 2]) for line in self.results.lines]
        out += self.joined(output)
        out += [(name, self.body(b, output) + [0, 0, self.tops.get(b, 0.0)]) for b, name in enumerate(self.results.bodies)]
        for name, volume in self.results.file.get("volumes", {}).items():
            if int(volume.attrs.get("body", -1)) < 0 and len(volume["vertices"]):
                x = volume["vertices"][:]
                name = volume.attrs.get("name", name)
                out.append((name.decode() if isinstance(name, bytes) else name, np.append((x.min(axis=0) + x.max(axis=0))[:2] / 2, x[:, 2].max())))
        return out if len(out) <= MOST_NAMES else []

    def label(self, name):
        text = pv.Text(registrationName=f"name {name}", Text=f"  {name}")  # beside the line, not on it
        shown = pv.Show(text, self.view)
        shown.TextPropMode = "Billboard 3D Text"
        shown.Color, shown.FontSize, shown.Bold = [0.1, 0.12, 0.15], 15, 0
        return shown
