"""Drawing libraries for the browser: three.js and Dygraphs, from Debian or from a folder named by HAWSER_JAVASCRIPT."""
import os
import re
from pathlib import Path

PLACES = "/usr/share/javascript"
PACKAGES = "libjs-three libjs-dygraphs"
THREE, CONTROLS = "three/three.min.js", "three/examples/js/controls/OrbitControls.js"
GRAPHS, GRAPHS_STYLE = "dygraphs/dygraph.min.js", "dygraphs/dygraph.css"
NOTICES = (("three.js", "libjs-three"), ("Dygraphs", "libjs-dygraphs"))
PAGE = Path(__file__).parent / "page"
# In the order of loading.
OWN = ("blocks", "source", "colours", "camera", "lines", "bodies", "sea", "marks", "overlay", "scene", "cuts", "graphs", "curves", "player",
       "controls", "figures", "follow", "start")


def folder():
    return Path(os.environ.get("HAWSER_JAVASCRIPT") or PLACES)


def missing():
    """Reason why nothing can be drawn in a browser; "" if all libraries are available."""
    absent = [name for name in (THREE, CONTROLS, GRAPHS, GRAPHS_STYLE) if not (folder() / name).is_file()]
    if not absent:
        return ""
    return (f"The model is not shown in three dimensions, since {folder() / absent[0]} is not installed: install {PACKAGES} "
            "(scripts/install-deps does).")


def text(name):
    return (folder() / name).read_text(encoding="utf-8")


def scripts():
    """Name and text of each library."""
    return [(name, text(name)) for name in (THREE, CONTROLS, GRAPHS)]


def own():
    """The scripts of the viewer as one text."""
    parts = "\n".join((PAGE / f"{name}.js").read_text(encoding="utf-8") for name in OWN)
    return f'(function () {{\n"use strict";\nconst hawser = {{}};\n{parts}\n}})();\n'


def styles():
    return text(GRAPHS_STYLE) + (PAGE / "view.css").read_text(encoding="utf-8")


def notices():
    """Licences of the libraries from Debian's packages."""
    found = []
    for name, package in NOTICES:
        file = Path("/usr/share/doc") / package / "copyright"
        if file.is_file():
            found.append(f"{name}\n\n{file.read_text(encoding='utf-8', errors='replace')}")
        else:
            found.append(f"{name}: see its licence (MIT) on its web site.")
    return re.sub("--+>?", "-", "\n\n".join(found))
