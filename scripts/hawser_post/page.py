"""HTML of a report: a single self-contained file for screen and paper."""
import base64
import html
import io
import re

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.transforms import Bbox

from .viewer import embedded, libraries

STYLE = """
body { font: 15px/1.45 system-ui, "DejaVu Sans", sans-serif; color: #1c2733; max-width: 980px; margin: 2em auto; padding: 0 1em }
h1 { font-size: 1.7em; margin-bottom: 0.1em } h2 { font-size: 1.25em; border-bottom: 1px solid #c9d3dc; margin-top: 2em }
nav a { margin-right: 1em } a { color: #1f5a92; text-decoration: none }
table { border-collapse: collapse; font-size: 0.85em; margin: 0.8em 0; font-variant-numeric: tabular-nums }
th, td { padding: 0.2em 0.7em; text-align: right; border-bottom: 1px solid #e3e8ed } th { background: #eef2f5; vertical-align: bottom }
th.text, td.text { text-align: left } .wide { overflow-x: auto } tr { break-inside: avoid }
img { width: 100%; height: auto; display: block; margin: 0.6em 0 }
pre { background: #f5f7f9; padding: 1em; overflow-x: auto; font-size: 0.8em }
.warning { background: #fdecea; border-left: 4px solid #c0392b; padding: 0.4em 0.8em; margin: 0.4em 0 }
.note { background: #eef4fa; border-left: 4px solid #1f5a92; padding: 0.4em 0.8em; margin: 0.4em 0 }
figure { margin: 0; break-inside: avoid } figcaption { color: #54616d; font-size: 0.85em }
@media screen { figure, .wide, pre { content-visibility: auto; contain-intrinsic-size: auto 18em } }
@page { size: A4; margin: 15mm 14mm }
@media print {
  body { max-width: none; margin: 0; padding: 0; font-size: 10.5pt } nav { display: none }
  h2, h2 + p { break-after: avoid } h2 { margin-top: 1.4em } p { orphans: 3; widows: 3 }
  table { font-size: 7.5pt } th, td { padding: 0.15em 0.45em } thead { display: table-header-group } .wide { overflow: visible }
  img { max-width: 158mm; max-height: 120mm; margin: 0.2em 0 } pre { white-space: pre-wrap; overflow-wrap: anywhere; font-size: 7.5pt }
  .warning, .note { break-inside: avoid } * { print-color-adjust: exact; -webkit-print-color-adjust: exact }
}
"""


def number(value):
    """Number with about four significant digits."""
    if isinstance(value, str):
        return value
    if isinstance(value, int):
        return str(value)
    size = abs(value)
    if value == 0 or size < 1e-12:
        return "0"
    if 1e-3 <= size < 1e5:
        return f"{value:.{max(0, 4 - len(str(int(size))))}f}" if size >= 1 else f"{value:.4g}"
    return f"{value:.4g}"


def from_place_to_place(path):
    """SVG path with straight segments as differences in tenths of a point, without accumulated rounding. Other paths
    are unchanged."""
    if not re.fullmatch(rb"[-\d.\sMLz]*", path):
        return path.replace(b"\n", b"")
    out, at, start, command, numbers = [b""], [0, 0], [0, 0], b"", []
    for part in re.findall(rb"[MLz]|[-\d.]+", path):
        if part in (b"M", b"L", b"z"):
            if part != b"L" or command != b"L":
                out.append(part.lower())
            command, at = part, list(start) if part == b"z" else at
            continue
        numbers.append(round(10 * float(part)))
        if len(numbers) == 2:
            for k in range(2):
                out.append(tenths(numbers[k] - at[k], out[-1]))
            start = numbers if command == b"M" else start
            at, numbers = numbers, []
    return b"".join(out)


def tenths(count, before):
    """Number of tenths in the shortest form that may follow the text `before`."""
    text = re.sub(r"^(-?)0(?=\.)", r"\1", f"{count / 10:g}").encode()
    apart = not before.isalpha() and not text.startswith(b"-") and not (text.startswith(b".") and b"." in before)
    return b" " + text if apart else text


def shortened(svg):
    """SVG with coordinates rounded to a tenth of a point and written as differences, without metadata: smaller, with
    the same appearance."""
    svg = re.sub(rb"<metadata>.*?</metadata>", b"", svg, flags=re.DOTALL)
    svg = re.sub(rb'(?<= d=")[^"]*', lambda d: from_place_to_place(d[0]), svg)
    svg = re.sub(rb"(?<=DejaVu Sans')[^;\"]*(?=, sans-serif)", b"", svg)
    svg = re.sub(rb'(?<= [xy]=")(-?\d+\.\d\d)\d+', rb"\1", svg)
    svg = re.sub(rb' transform="rotate\(-0 [^"]*"| clip-path="[^"]*"(?=[^>]*#b0b0b0)', b"", svg)
    svg = re.sub(rb'^.*?(?=<svg)', b"", svg, count=1, flags=re.DOTALL)  # what only files need
    svg = re.sub(rb' id="[a-zA-Z.0-9]*_\d+"', b"", svg)  # of groups, to which nothing refers
    return re.sub(rb"\n *", b"\n", svg)


def whole(figure):
    """Bounding box of the figure with protruding parts such as axis labels in space; None if nothing protrudes."""
    if not any(hasattr(axes, "zaxis") for axes in figure.axes):
        return None
    figure.canvas.draw()
    return Bbox.union([figure.bbox_inches, figure.get_tightbbox(figure.canvas.get_renderer())])


class Page:
    def __init__(self, title):
        self.title, self.parts, self.sections = title, [], []
        self.has_model = False
        self.figures = 0
        self.drawn = not libraries.missing()  # the browser can draw models and graphs

    def section(self, name):
        key = f"s{len(self.sections)}"
        self.sections.append((key, name))
        self.parts.append(f'<h2 id="{key}">{html.escape(name)}</h2>')

    def text(self, words, kind="p"):
        tag = f'<div class="{kind}">{{}}</div>' if kind in ("note", "warning") else f"<{kind}>{{}}</{kind}>"
        self.parts.append(tag.format(html.escape(words)))

    def table(self, head, rows):
        if not rows:
            return
        rows = [list(row) for row in rows]
        for k in range(len(head)):  # values negligible in their column
            sizes = [abs(row[k]) for row in rows if isinstance(row[k], float) and np.isfinite(row[k])]
            for row in rows:
                if isinstance(row[k], float) and abs(row[k]) < 1e-9 * max(sizes, default=0):
                    row[k] = 0.0
        left = [any(isinstance(row[k], str) and row[k] != "" for row in rows) for k in range(len(head))]
        marks = [' class="text"' if is_text else "" for is_text in left]
        titles = "".join(f"<th{m}>{html.escape(h)}</th>" for h, m in zip(head, marks))
        lines = []
        for row in rows:
            lines.append("<tr>" + "".join(f"<td{m}>{html.escape(number(v))}</td>" for v, m in zip(row, marks)) + "</tr>")
        self.parts.append(f'<div class="wide"><table><thead><tr>{titles}</tr></thead><tbody>' + "\n".join(lines)
                          + "</tbody></table></div>")

    def figure(self, figure, caption, form="svg"):
        """Adds a figure. form: svg, or png for very many strokes."""
        self.figures += 1
        curves = embedded.curves_of(figure) if self.drawn and form == "svg" else None
        data = io.BytesIO()
        with plt.rc_context({"svg.fonttype": "none"}):  # fonts of the reader; outlines take two thirds of a small drawing
            figure.savefig(data, format=form, dpi=130, metadata={"Date": None} if form == "svg" else None, bbox_inches=whole(figure))
        plt.close(figure)
        kind = "svg+xml" if form == "svg" else form
        text = base64.b64encode(shortened(data.getvalue()) if form == "svg" else data.getvalue()).decode()
        attribute, script = "", ""
        if curves:
            attribute = f' data-curves="{html.escape(curves[0])}"'
            script = f'<script type="text/plain">{curves[1]}</script>'
        self.parts.append(f'<figure{attribute}><img alt="{html.escape(caption)}" src="data:image/{kind};base64,{text}">'
                          f"<figcaption>{html.escape(caption)}</figcaption>{script}</figure>")

    def within(self, things, most, rest):
        """Yields `things` until `most` figures were added; then reports the number of the others with the text
        `rest`."""
        before = self.figures
        for place, thing in enumerate(things):
            if self.figures - before >= most:
                self.text(f"Figures show the first {place} of {len(things)} {rest}")
                return
            yield thing

    def model(self, results, other=None):
        """Adds the three-dimensional model, with another one in it if given, or the reason why it cannot be shown."""
        if self.drawn:
            # The model precedes the rest of the page so that it is available first.
            scenes = [embedded.scene(results)] if other is None else embedded.two_scenes(results, other)
            self.parts += [*scenes, embedded.libraries_of_page()]
            self.has_model = True
        else:
            self.text(libraries.missing(), "note")

    def end(self):
        """Adds the scripts of graphs in a page without a model, and the licences of the page's contents."""
        if not self.drawn:
            return ""
        return ("" if self.has_model else embedded.libraries_of_page()) + embedded.licences()

    def write(self, path):
        links = "".join(f'<a href="#{key}">{html.escape(name)}</a>' for key, name in self.sections)
        path.write_text(
            f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{html.escape(self.title)}</title>'
            f'<link rel="icon" href="data:,"><style>{STYLE}</style></head>\n<body><h1>{html.escape(self.title)}</h1>\n'
            f"<nav>{links}</nav>\n" + "\n".join(self.parts) + self.end() + "\n</body></html>\n", encoding="utf-8")
