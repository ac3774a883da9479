"""Pictures and films of a run: lines as tubes coloured by a field, the volumes they touch as surfaces, sea and seabed.

    scripts/render RESULTS.xdmf OUT_FOLDER [options]                            (starts the two programs below)
    scripts/with-display pvpython scripts/render.py RESULTS.xdmf OUT_FOLDER [options]

Writes OUT_FOLDER/NAME_0000.png and so on, one for each time, and NAME.png with all of them side by side. The shape of a cell
determines how it is drawn (polylines as lines, triangles as volumes), so any such XDMF file is accepted; with the
.h5 of a run beside it there are also sea, seabed, buoys, joints, bodies, names and the lines' own diameters.
"""
import argparse
import inspect
import math
import os
import shutil
import subprocess
import sys
import tempfile

from paraview import servermanager
from paraview import simple as pv

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from render_scenery import Scenery, results_beside, sections_of  # noqa: E402

# Numbers in these units are shown in others: factor and name.
UNITS = {"N": (1e-3, "kN"), "N m": (1e-3, "kN m"), "m": (1e3, "mm")}


def leaves(data):
    """The data sets of a tree, or the single data set."""
    if not data.IsA("vtkCompositeDataSet"):
        return [data]
    found, walk = [], data.NewIterator()
    while not walk.IsDoneWithTraversal():
        found.append(walk.GetCurrentDataObject())
        walk.GoToNextItem()
    return found


# Runs inside ParaView's pipeline: one poly-line for each line of the input, its field under the name "shown".
LINES = inspect.getsource(leaves) + """
from paraview import vtk
import math

points, cells, shown, radius = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkDoubleArray(), vtk.vtkDoubleArray()
points.SetDataTypeToDouble()
shown.SetName("shown")
radius.SetName("radius")
sections = {sections!r}  # of each line: (arc length to which, radius)
for leaf in leaves(self.GetInputDataObject(0, 0)):
    if leaf.GetNumberOfPoints() == 0:
        continue  # cells without points crash; the reader makes them if it cannot read the .h5
    values = leaf.GetPointData().GetArray({field!r})
    number, arc = leaf.GetPointData().GetArray("line"), leaf.GetPointData().GetArray("arc_length")
    for c in range(leaf.GetNumberOfCells()):
        if leaf.GetCellType(c) not in (vtk.VTK_LINE, vtk.VTK_POLY_LINE):
            continue
        ids, own, last = leaf.GetCell(c).GetPointIds(), [], None
        for i in range(ids.GetNumberOfIds()):
            p = leaf.GetPoint(ids.GetId(i))
            if last is not None and math.dist(p, last) < 1e-9:
                continue  # a tube has no direction between two points that coincide
            last = p
            own.append(points.InsertNextPoint(p))
            value = 0.0
            if values:
                n = values.GetNumberOfComponents()
                value = math.hypot(*[values.GetComponent(ids.GetId(i), k) for k in range(n)]) if n > 1 \\
                    else values.GetComponent(ids.GetId(i), 0)
            shown.InsertNextValue({factor!r} * value)
            wide = {radius!r}
            if sections and number and arc:
                along = sections[int(number.GetComponent(ids.GetId(i), 0))]
                at = arc.GetComponent(ids.GetId(i), 0) - 1e-9 * along[-1][0]
                wide = next((r for to, r in along if at <= to), along[-1][1])
            radius.InsertNextValue(wide)
        cells.InsertNextCell(len(own), own)
output = self.GetPolyDataOutput()
output.SetPoints(points)
output.SetLines(cells)
output.GetPointData().AddArray(shown)
output.GetPointData().AddArray(radius)
output.GetPointData().SetActiveScalars("shown")
"""

# Likewise one surface of all faces, without the cell fields of the input (such as `active`).
FACES = inspect.getsource(leaves) + """
from paraview import vtk

points, cells = vtk.vtkPoints(), vtk.vtkCellArray()
points.SetDataTypeToDouble()
for leaf in leaves(self.GetInputDataObject(0, 0)):
    if leaf.GetNumberOfPoints() == 0:
        continue
    known = {{}}
    for c in range(leaf.GetNumberOfCells()):
        if leaf.GetCellType(c) not in (vtk.VTK_TRIANGLE, vtk.VTK_QUAD):
            continue
        ids, own = leaf.GetCell(c).GetPointIds(), []
        for i in range(ids.GetNumberOfIds()):
            j = ids.GetId(i)
            if j not in known:
                known[j] = points.InsertNextPoint(leaf.GetPoint(j))
            own.append(known[j])
        cells.InsertNextCell(len(own), own)
output = self.GetPolyDataOutput()
output.SetPoints(points)
output.SetPolys(cells)
"""


def vector(text):
    values = [float(word) for word in text.split(",")]
    if len(values) != 3:
        raise argparse.ArgumentTypeError("three numbers separated by commas")
    return values


def arguments(argv, **defaults):
    parser = argparse.ArgumentParser(prog="render", description=__doc__.split("\n\n")[0])
    parser.add_argument("results", help="the .xdmf of a run")
    parser.add_argument("out", help="folder for the pictures, created if missing")
    parser.add_argument("--field", default="effective_tension", help="node field that colours the lines")
    parser.add_argument("--range", type=float, nargs=2, help="range of the colours in the displayed unit (default: all values)")
    parser.add_argument("--diameter", type=float, help="diameter of all tubes, m (default: those of the lines times --factor)")
    parser.add_argument("--factor", type=float, help="factor on the thickness of lines (default: 1, "
                        "or larger so that the thickest line is a 300th of the picture)")
    parser.add_argument("--film", metavar="FILE.mp4", help="also a film of all outputs; needs ffmpeg")
    parser.add_argument("--rate", type=float, default=25, help="pictures a second in the film")
    parser.add_argument("--no-sea", action="store_true", help="do not draw the surface of the sea and the seabed")
    parser.add_argument("--no-names", action="store_true", help="do not draw the names of lines, joints, bodies and volumes")
    parser.add_argument("--pictures", type=int, default=4, help="number of pictures, evenly spaced over the run")
    parser.add_argument("--at", type=float, nargs="+", help="times of the pictures, s, in place of --pictures")
    parser.add_argument("--direction", type=vector, default=[-1, 1.5, -0.6], help="direction of view: x,y,z")
    parser.add_argument("--focus", type=vector, help="point at the centre of the picture, m (default: the centre of the model)")
    parser.add_argument("--height", type=float, help="height of the picture, m (default: the whole model)")
    parser.add_argument("--size", type=int, nargs=2, default=[900, 900], help="size of one picture, pixels")
    parser.add_argument("--columns", type=int, help="columns of the joint picture (default: one row)")
    parser.add_argument("--opacity", type=float, default=1.0, help="opacity of volumes, 0 to 1; below 1 lines inside are visible (default: 1)")
    parser.add_argument("--edges", action="store_true", help="draw the edges of the triangles")
    parser.set_defaults(**{"scenery": None, **defaults})
    return parser.parse_args(argv)


def derived(source, script, **values):
    """A polygonal data set that a Python script makes from `source`."""
    made = pv.ProgrammableFilter(Input=source)
    made.OutputDataSetType = "vtkPolyData"
    made.Script = script.format(**values)
    return made


def chosen_times(available, options):
    if options.at:
        return [min(available, key=lambda t: abs(t - time)) for time in options.at]
    count = max(1, min(options.pictures, len(available)))
    if count == 1:
        return [available[-1]]
    return [available[round(i * (len(available) - 1) / (count - 1))] for i in range(count)]


def extent(source, times):
    """Bounds over the given times: lower and upper corner."""
    lower, upper = [math.inf] * 3, [-math.inf] * 3
    for time in times:
        source.UpdatePipeline(time)
        bounds = source.GetDataInformation().GetBounds()
        if bounds[0] <= bounds[1]:
            lower = [min(a, b) for a, b in zip(lower, bounds[0::2])]
            upper = [max(a, b) for a, b in zip(upper, bounds[1::2])]
    return lower, upper


def value_range(source, times):
    low, high = math.inf, -math.inf
    for time in times:
        source.UpdatePipeline(time)
        shown = source.GetDataInformation().GetPointDataInformation().GetArrayInformation("shown")
        if shown:
            a, b = shown.GetComponentRange(0)
            low, high = min(low, a), max(high, b)
    if low > high:
        return 0.0, 1.0
    return (low, high) if high > low else (low - 0.5, high + 0.5)


def has_field(source, name):
    return source.GetDataInformation().GetPointDataInformation().GetArrayInformation(name) is not None


def aim(view, direction, focus, height, distance):
    norm = math.sqrt(sum(x * x for x in direction))
    towards = [x / norm for x in direction]
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = focus
    view.CameraPosition = [f - distance * x for f, x in zip(focus, towards)]
    # z is up in the picture, unless the camera looks straight up or down.
    view.CameraViewUp = [0, 1, 0] if abs(towards[2]) > 0.999 else [0, 0, 1]
    view.CameraParallelScale = height / 2


def join(files, columns, target):
    """One picture of several of the same size, in rows."""
    from vtkmodules.vtkFiltersCore import vtkImageAppend
    from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

    def joined(ports, axis):
        append = vtkImageAppend()
        append.SetAppendAxis(axis)
        for port in ports:
            append.AddInputConnection(port)
        return append

    readers = []
    for file in files:
        reader = vtkPNGReader()
        reader.SetFileName(file)
        readers.append(reader)
    rows = [joined([r.GetOutputPort() for r in readers[i : i + columns]], 0) for i in range(0, len(readers), columns)]
    # The y axis of a PNG points up, so the first row is added last.
    stack = joined([row.GetOutputPort() for row in reversed(rows)], 1)
    writer = vtkPNGWriter()
    writer.SetFileName(target)
    writer.SetInputConnection(stack.GetOutputPort())
    writer.Write()


def colour_lines(view, tubes, options, limits, unit):
    hose = pv.Show(tubes, view)
    hose.Ambient, hose.Diffuse = 0.3, 0.75
    pv.ColorBy(hose, ("POINTS", "shown"))
    colours = pv.GetColorTransferFunction("shown")
    colours.ApplyPreset("Viridis (matplotlib)", True)
    colours.RescaleTransferFunction(*limits)
    bar = pv.GetScalarBar(colours, view)
    bar.Title = options.field.replace("_", " ") + (f" [{unit}]" if unit else "")
    bar.ComponentTitle = ""
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.TitleFontSize, bar.LabelFontSize = 18, 16
    bar.ScalarBarLength = 0.4
    bar.AutomaticLabelFormat = 0
    bar.LabelFormat = bar.RangeLabelFormat = "%.4g"
    bar.WindowLocation = "Lower Right Corner"
    hose.SetScalarBarVisibility(view, True)


def render(options):
    if options.film and not options.film.endswith(".mp4"):
        raise SystemExit(f"render: {options.film}: a film is an .mp4 file")
    if options.film and not shutil.which("ffmpeg"):
        raise SystemExit("render: a film needs ffmpeg, which is not installed (Debian: apt-get install ffmpeg)")
    os.makedirs(options.out, exist_ok=True)
    pv._DisableFirstRenderCameraReset()
    source = pv.OpenDataFile(os.path.abspath(options.results))  # the reader needs a folder before the name
    if source is None:
        raise SystemExit(f"render: ParaView cannot open {options.results}")
    source.UpdatePipelineInformation()
    written = source.TimestepValues  # a number, not a list, when there is one time only
    written = (list(written) if hasattr(written, "__iter__") else [written]) or [0.0]
    times = chosen_times(written, options)
    source.UpdatePipeline(times[-1])
    if not has_field(source, options.field) and options.field != "effective_tension":
        print(f"render: no node field '{options.field}' in {options.results}; the lines have one colour")

    results = results_beside(options.results)
    lower, upper = extent(source, times)
    if lower[0] > upper[0]:
        raise SystemExit(f"render: {options.results} has no points; is its .h5 file beside it?")
    diagonal = math.dist(lower, upper) or 1.0
    sections, radius = thickness(results, options, options.height or diagonal)
    # Without results beside it the file has no units; the default field is in N.
    unit = (results.unit(options.field) if results and results.has(options.field) else
            "N" if options.field == "effective_tension" else "")
    factor, unit = UNITS.get(unit, (1, "" if unit == "1" else unit))
    lines = derived(source, LINES, field=options.field, factor=factor, sections=sections, radius=radius)
    faces = derived(source, FACES)
    # The given radius is the factor on the radii of the points if these vary.
    tubes = pv.Tube(Input=lines, Radius=1.0, NumberofSides=24, Capping=1, VaryRadius="By Absolute Scalar")
    tubes.Scalars = ["POINTS", "radius"]

    view = pv.CreateRenderView(ViewSize=options.size)
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesLabelColor = [0, 0, 0]
    surface = pv.Show(faces, view)
    surface.DiffuseColor = surface.AmbientColor = [0.80, 0.82, 0.85]
    surface.Specular = 0.2
    surface.Opacity = options.opacity
    if options.edges:
        surface.Representation = "Surface With Edges"
        surface.EdgeColor = [0.6, 0.62, 0.66]
    surface.Ambient, surface.Diffuse = 0.3, 0.75
    lines.UpdatePipeline(times[-1])
    if has_field(lines, "shown"):
        colour_lines(view, tubes, options, options.range or value_range(lines, times), unit)
    clock = pv.Text(registrationName="clock")
    label = pv.Show(clock, view)
    label.Color = [0, 0, 0]
    label.FontSize = 24
    label.WindowLocation = "Upper Left Corner"

    around = None
    if options.scenery:
        options.scenery(view)
    elif results:
        thick = max([radius] + [r for line in sections or [] for _, r in line])
        around = Scenery(view, results, lower, upper, (options.height or diagonal) / 120, thick, not options.no_sea,
                         not options.no_names)
    middle = [(a + b) / 2 for a, b in zip(lower, upper)]
    aim(view, options.direction, options.focus or middle, options.height or 1.05 * diagonal, 2 * diagonal)
    name = os.path.splitext(os.path.basename(options.results))[0]

    def picture(time, path):
        view.ViewTime = time
        clock.Text = f"t = {time:.4g} s"
        if around:
            around.at_time(time)
        pv.Render(view)
        pv.SaveScreenshot(path, view, ImageResolution=options.size)

    files = []
    for i, time in enumerate(times):
        files.append(os.path.join(options.out, f"{name}_{i:04d}.png"))
        picture(time, files[-1])
    join(files, options.columns or len(files), os.path.join(options.out, f"{name}.png"))
    print("\n".join(files + [os.path.join(options.out, f"{name}.png")]))
    if options.film:
        film(options, written, picture)


def film(options, times, picture):
    """An MP4 of the pictures at all times that every player can show: H.264 with even width and height in pixels."""
    with tempfile.TemporaryDirectory() as folder:
        for i, time in enumerate(times):
            picture(time, os.path.join(folder, f"{i:06d}.png"))
        made = subprocess.run(["ffmpeg", "-y", "-loglevel", "error", "-framerate", str(options.rate), "-i",
                               os.path.join(folder, "%06d.png"), "-vf", "crop=trunc(iw/2)*2:trunc(ih/2)*2", "-c:v", "libx264",
                               "-pix_fmt", "yuv420p", "-movflags", "+faststart", options.film],
                              capture_output=True, text=True, check=False)
    if made.returncode != 0:
        raise SystemExit(f"render: ffmpeg could not make {options.film}: {made.stderr.strip().splitlines()[-1:]}")
    print(options.film)


def thickness(results, options, height):
    """For each line (end of a part by arc length, its radius), and the radius where it is unknown, m."""
    thinnest = height / 600
    if options.diameter:
        return None, options.diameter / 2
    sections = sections_of(results) if results else []
    widths = [w for line in sections for _, w in line if w == w]
    if not widths:
        return None, thinnest
    factor = options.factor or max(1.0, 2 * thinnest / max(widths))
    if factor != 1:
        print(f"render: lines are drawn {factor:.3g} times their thickness")
    return [[(to, factor * w / 2 if w == w else thinnest) for to, w in line] for line in sections], thinnest


def main(argv=None, **defaults):
    """Draws as requested on the command line; `defaults` are the choices of a case, which the command line overrides. `scenery` is a
    function of the view that adds what is not in the results, such as the surface of the sea."""
    render(arguments(argv, **defaults))


def below_each_other(argv, common, views):
    """Draws several views of a case, {their own choices}, below each other into OUT/NAME.png for `RESULTS OUT [OPTIONS]`, NAME that of the
    results; `common`: choices of all. Returns the path."""
    results, out, options = argv[0], argv[1], argv[2:]
    picture = os.path.splitext(os.path.basename(results))[0] + ".png"
    files = []
    for number, view in enumerate(views):
        folder = os.path.join(out, f"view {number + 1}")
        main([results, folder, *options], **common, **view)
        for source in list(pv.GetSources().values()):
            pv.Delete(source)
        pv.Delete(pv.GetActiveView())
        files.append(os.path.join(folder, picture))
    target = os.path.join(out, picture)
    join(files, 1, target)
    return target


if __name__ == "__main__":
    # As a module, not as the main program: ParaView runs the pieces of Python above in the main program's names,
    # where they would replace min, max and other functions.
    import render as module

    module.main()
