"""The viewer in a single self-contained page."""
import base64
import html
import json
import zlib

import numpy as np

from . import blocks, libraries
from .model import Model

# Size of a model's blocks in bytes: minimum, increment per output, maximum.
SMALL, EACH_OUTPUT, LARGE = 1_600_000, 2_500, 13_000_000
MOST_VALUES = 60_000_000  # packed at most
MOST_POINTS = 4000  # per curve


def text_of(data):
    return base64.b64encode(data).decode()


def json_of(value):
    """JSON for a script in a page; NaN and infinity become null."""
    def finite(v):
        if isinstance(v, dict):
            return {key: finite(inner) for key, inner in v.items()}
        if isinstance(v, (list, tuple)):
            return [finite(inner) for inner in v]
        if isinstance(v, (float, np.floating)):
            return float(v) if np.isfinite(v) else None
        return int(v) if isinstance(v, np.integer) else v
    return json.dumps(finite(value), separators=(",", ":")).replace("</", "<\\/").replace("<!--", "<\\u0021--")


def limit(results):
    """Largest size of the model of these results, bytes."""
    return min(LARGE, max(SMALL, EACH_OUTPUT * results.outputs))


def packed_model(results, most=None):
    """The model with as many outputs and fields as the limit allows: header and blocks."""
    most = most or limit(results)
    named = {*results.reported("graph", "table")}
    fields, every = None, 1
    values = results.outputs * len(results.file["nodes/arc_length"]) * (3 + len(results.fields))
    if values > MOST_VALUES:
        fields = named
        values = results.outputs * len(results.file["nodes/arc_length"]) * (6 + len(fields))
        every = max(1, -(-values // MOST_VALUES))
    while True:
        model = Model(results, every, fields=fields)
        header = model.header()
        found = {name: model.block(name) for name in model.names()}
        size = sum(len(block) for block in found.values() if block) * 4 / 3
        if size <= most or (fields is not None and every >= results.outputs):
            break
        if fields is None:
            fields = named
        else:
            every = max(every + 1, int(np.ceil(every * size / most)))
    if fields is not None:
        model.missing.append("It contains the fields that have a figure or a table in the report.")
    return header, {name: block for name, block in found.items() if block}


def data(results, name, most=None, **more):
    """HTML of the data of a model."""
    header, found = packed_model(results, most)
    header.update(more)
    parts = [f'<script type="application/json" id="{name}-header">{json_of(header)}</script>']
    parts += [f'<script type="text/plain" data-of="{name}" data-block="{html.escape(key)}">{text_of(block)}</script>'
              for key, block in found.items()]
    return "\n".join(parts)


def place(name, others=""):
    """HTML element of a viewer."""
    more = f' data-others="{others}"' if others else ""
    return (f'<div class="hawser-view" id="{name}"{more}>The model in three dimensions appears here when the page is loaded, '
            "in a browser with JavaScript.</div>")


def scene(results):
    return f"{place('model')}\n{data(results, 'model')}"


def two_scenes(a, b):
    """One viewer with two models, B drawn over A."""
    return [place("model", "other"), data(a, "model", label="A"), data(b, "other", label="B")]


def curves_of(figure):
    """Curves of a Matplotlib figure as JSON and a block with a resolution relative to their ranges; None without
    curves."""
    axes = figure.axes[0] if len(figure.axes) == 1 else None
    lines = [line for line in axes.get_lines() if len(line.get_xdata()) > 1] if axes is not None and not hasattr(axes, "zaxis") else []
    if not lines:
        return None
    legend = axes.get_legend()
    title = axes.get_title("left") or (legend.get_title().get_text() if legend else "")
    curves, rows = [], []
    points = min(MOST_POINTS, max(len(line.get_xdata()) for line in lines))
    for line in lines:
        label = line.get_label()
        curve = {"label": axes.get_ylabel() if label.startswith("_") else label, "dashed": line.get_linestyle() == "--",
                 "colour": colour_of(line)}
        for what, values, parts in (("x", line.get_xdata(), 1e6), ("y", line.get_ydata(), 65000)):
            values = np.asarray(values, float)[:points]
            finite = values[np.isfinite(values)]
            low, span = (float(finite.min()), float(np.ptp(finite))) if finite.size else (0.0, 0.0)
            curve[what] = [low, span / parts]
            k = np.rint((values - low) / span * parts) if span > 0 else np.where(np.isfinite(values), 0.0, np.nan)
            rows.append(np.pad(k, (0, points - len(k)), constant_values=k[-1]))
            curve["points"] = len(values)
        curves.append(curve)
    graph = {"title": title, "x": axes.get_xlabel(), "y": axes.get_ylabel(), "curves": curves}
    return json_of(graph), text_of(blocks.steps(np.array(rows), 1.0))


def colour_of(line):
    from matplotlib.colors import to_hex
    return to_hex(line.get_color())


def libraries_of_page():
    """HTML of styles, libraries and viewer, for the end of a page."""
    packed = [(name, text) for name, text in libraries.scripts()] + [("viewer", libraries.own())]
    parts = [f"<style>{libraries.styles()}</style>"]
    parts += [f'<script type="text/plain" data-packed="{html.escape(name)}">{text_of(zlib.compress(text.encode(), 9))}</script>'
              for name, text in packed]
    parts.append(f"<script>{(libraries.PAGE / 'boot.js').read_text(encoding='utf-8')}</script>")
    return "\n".join(parts)


def licences():
    return ('<details class="licences on-screen"><summary>Libraries in this page and their licences</summary>'
            f"<pre>{html.escape(libraries.notices())}</pre></details>")
