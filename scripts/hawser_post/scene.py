"""Pictures of the model from above, from the side and in space, with sea, seabed and volumes."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.ticker import MaxNLocator
from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

from .charts import colour, legend
from .sea import Sea

VIEWS = ("plan", "elevation", "space")
SEA, BED, HULL, FACE = "#4d8fbf", "#9c7a4d", "#7a858f", "#e4e8ec"
MOST_EDGES, MOST_FACES = 6000, 30000
MOST_WAVES = 60  # points along a side of the sea surface in a picture in space
TICKS = 8  # along the longest axis of a picture in space


def edges(x, triangles):
    """Edges of a mesh to be drawn, sharp ones first, at most MOST_EDGES."""
    corners = x[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    all_edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    of = np.tile(np.arange(len(triangles)), 3)
    order = np.lexsort((all_edges[:, 1], all_edges[:, 0]))
    all_edges, of = all_edges[order], of[order]
    twin = np.flatnonzero((all_edges[1:] == all_edges[:-1]).all(axis=1))
    bend = 1 - (normals[of[twin]] * normals[of[twin + 1]]).sum(axis=1)
    kept = twin[bend > 0.03]  # beyond 14 degrees
    if len(kept) < 12:  # a round mesh
        kept = twin
    kept = kept[np.argsort(-bend[np.searchsorted(twin, kept)], kind="stable")[:MOST_EDGES]]
    return x[all_edges[kept]]


def across(results):
    """Horizontal unit vector in which the lines extend most, the abscissa of a view from the side."""
    if not results.lines:
        return np.array([1.0, 0.0])
    x = np.concatenate([results.field("position", line, 0)[:, :2] for line in results.lines])
    _, _, axes = np.linalg.svd(x - x.mean(axis=0), full_matrices=False)
    along = axes[0]
    if abs(along[0]) > 0.95:
        along = np.array([1.0, 0.0])
    elif abs(along[1]) > 0.95:
        along = np.array([0.0, 1.0])
    return along * (np.sign(along[np.argmax(np.abs(along))]) or 1)


def picture(results, view, output=-1, high=4.2, name=None):
    if view == "space":
        return in_space(results, output)
    figure, axes = plt.subplots(figsize=(7.2, high), layout="constrained")
    along = across(results)

    def flat(x):
        return (x[..., 0], x[..., 1]) if view == "plan" else (x[..., :2] @ along, x[..., 2])

    for _, x, triangles in results.volumes(output):
        if len(triangles) <= MOST_FACES:
            axes.add_collection(PolyCollection(np.stack(flat(x[triangles]), axis=-1), facecolors=FACE, edgecolors=FACE,
                                               lw=0.3, zorder=0))
        axes.add_collection(LineCollection(np.stack(flat(edges(x, triangles)), axis=-1), colors=HULL, lw=0.5, zorder=1))
    axes.autoscale_view()
    shown = list(dict.fromkeys([0, range(results.outputs)[output]]))
    for line in results.lines:
        for output_shown in shown:
            last = output_shown == shown[-1]
            axes.plot(*flat(results.field("position", line, output_shown)), color=colour(line.number, len(results.lines)),
                      lw=1.4 if last else 0.8, ls="-" if last else "--", zorder=3,
                      label=line.name if last and len(results.lines) <= 12 else None)
    for b, body in enumerate(results.bodies):
        x = results.file["bodies/position"][results.rows[output], b]
        axes.plot(*flat(x), "k+", ms=8, zorder=4)
        # Names of two close bodies are placed on different sides.
        axes.annotate(body, flat(x), xytext=(4, 4 if b % 2 == 0 else -9), textcoords="offset points", fontsize=8)
    if view == "elevation":
        water_and_bed(axes, results, along, output)
    axes.set_aspect("equal", adjustable="datalim")
    names = ("x [m]", "y [m]") if view == "plan" else (axis_name(along), "z [m]")
    axes.set(xlabel=names[0], ylabel=names[1], title=name or title(results, view, shown))
    if 0 < len(results.lines) <= 12:
        legend(axes, 4)
    return figure


def water_and_bed(axes, results, along, output):
    """Draws surface and seabed in a view from the side, in the plane through the middle of the lines."""
    sea = Sea(results)
    time = 0.0 if results.modes else results.time[output]
    x = [results.field("position", line, output)[:, :2] for line in results.lines]
    middle = np.concatenate(x).mean(axis=0) if x else np.zeros(2)
    middle -= (middle @ along) * along
    low, high = axes.get_xlim()
    axes.set_autoscalex_on(False)
    span = max(high - low, np.ptp(axes.get_ylim()))  # equal scales may widen the view by this much at most
    s = np.linspace(low - span, high + span, 1200)
    place = middle[:, None] + along[:, None] * s
    if sea.level is not None:
        if sea.still or results.modes:
            axes.axhline(sea.level, color=SEA, lw=1.2)
        else:
            axes.plot(s, sea.surface(*place, time), color=SEA, lw=1.2)
    if sea.bed:
        if sea.measured is None and not any(sea.plane[1:]):
            axes.axhline(-sea.plane[0], color=BED, lw=1.6)
        else:
            axes.plot(s, sea.seabed(*place), color=BED, lw=1.6)


def axis_name(along):
    if along[0] == 1:
        return "x [m]"
    return "y [m]" if along[1] == 1 else f"along ({along[0]:.2f}, {along[1]:.2f}) [m]"


def title(results, view, shown):
    if results.modes:
        at = f"mode {shown[-1]}" + (" (dashed: at rest)" if view != "space" else "")
    else:
        at = f"t = {results.time[shown[-1]]:g} s"
        if len(shown) > 1:
            at += f" (dashed: t = {results.time[0]:g} s)"
    return {"plan": "from above", "elevation": "from the side", "space": "in space"}[view] + ", " + at


def widened(low, high):
    """Limits with no side shorter than 0.15 times the longest."""
    size = np.maximum(high - low, 0.15 * (high - low).max())
    return (low + high - size) / 2, (low + high + size) / 2


def draw_sea(axes, sea, low, high, time):
    """Draws surface and seabed over the range shown, which is extended vertically to contain them."""
    x, y = np.meshgrid(*(np.linspace(low[k], high[k], MOST_WAVES) for k in (0, 1)))
    surfaces = []
    if sea.bed:
        surfaces.append((sea.seabed(x, y), BED, 0.25))
    if sea.level is not None:
        surfaces.append((sea.surface(x, y, time), SEA, 0.15 if sea.still else 0.3))
    for z, paint, alpha in surfaces:
        if np.isnan(z).all():
            continue
        # A plane needs only one face.
        step = MOST_WAVES - 1 if np.nanmax(np.abs(z - z[0, 0])) < 1e-9 else 1
        axes.plot_surface(x[::step, ::step], y[::step, ::step], z[::step, ::step], color=paint, alpha=alpha, zorder=1,
                          rcount=MOST_WAVES, ccount=MOST_WAVES, shade=False, lw=0)
        low[2], high[2] = min(low[2], np.nanmin(z)), max(high[2], np.nanmax(z))


def in_space(results, output):
    figure = plt.figure(figsize=(7.2, 5.0), layout="constrained")
    axes = figure.add_subplot(projection="3d", computed_zorder=False)
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    for line in results.lines:
        x = results.field("position", line, output)
        axes.plot(x[:, 0], x[:, 1], x[:, 2], color=colour(line.number, len(results.lines)), lw=1.4, zorder=3)
        low, high = np.minimum(low, x.min(axis=0)), np.maximum(high, x.max(axis=0))
    for _, x, triangles in results.volumes(output):
        if len(triangles) <= MOST_FACES:
            axes.add_collection3d(Poly3DCollection(x[triangles], facecolors=FACE, alpha=0.6, zorder=1))
        axes.add_collection3d(Line3DCollection(edges(x, triangles), colors=HULL, linewidths=0.4, zorder=2))
        if not results.lines:
            low, high = np.minimum(low, x.min(axis=0)), np.maximum(high, x.max(axis=0))
            continue
        # A volume far larger than the objects on it must not shrink them.
        reach = 1.5 * (high - low).max()
        low, high = np.minimum(low, np.maximum(x.min(axis=0), low - reach)), np.maximum(high, np.minimum(x.max(axis=0), high + reach))
    if not np.all(np.isfinite(low)):
        low, high = np.full(3, -1.0), np.full(3, 1.0)
    low, high = widened(low, high)
    draw_sea(axes, Sea(results), low, high, 0.0 if results.modes else results.time[output])
    low, high = widened(low, high)
    size, middle = high - low, (low + high) / 2
    for axis, set_limits, m, s in zip((axes.xaxis, axes.yaxis, axes.zaxis), (axes.set_xlim, axes.set_ylim, axes.set_zlim),
                                      middle, size):
        set_limits(m - s / 2, m + s / 2)
        axis.set_major_locator(MaxNLocator(max(1, round(TICKS * s / size.max()))))
    axes.set_box_aspect(size, zoom=1.02 if size[2] < size[:2].max() else 0.8)
    axes.set(xlabel="x [m]", ylabel="y [m]", zlabel="z [m]", title=title(results, "space", [range(results.outputs)[output]]))
    return figure
