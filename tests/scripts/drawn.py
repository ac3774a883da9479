"""A model of two lines and a drum in a headless Chromium, for tests of drawing."""
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

import browser
from support import ROOT
from synthetic import add_contacts, results_file

sys.path.insert(0, str(ROOT / "scripts"))
from hawser_post.page import Page  # noqa: E402
from hawser_post.results import Results  # noqa: E402
from hawser_post.viewer import libraries  # noqa: E402

CASE = """\
hawser: 1
title: A hose on a drum
environment: {water: {depth: 30}, seabed: {depth: 30}}
line_types: {hose: {outer_diameter: 0.4}}
lines: {hose: {sections: [{type: hose, length: 60}]}, rope: {sections: [{type: hose, length: 60}]}}
"""
PIXELS = """
window.pixels = (nodes) => {
  const view = window.hawserView, {scene} = view, gl = scene.renderer.getContext();
  scene.draw();
  const ratio = scene.renderer.getPixelRatio();
  return nodes.map((node) => {
    const at = scene.pixelOf(scene.lines.position(node, new THREE.Vector3()));
    const bytes = new Uint8Array(4);
    gl.readPixels(Math.round(at.x * ratio - 0.5), scene.canvas.height - 1 - Math.round(at.y * ratio - 0.5), 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return Array.from(bytes.slice(0, 3));
  });
};
window.legend = (shares) => {  // colours of the bar at shares of its height
  const {overlay} = window.hawserView.scene;
  const high = Math.min(220, overlay.height - 110);
  const data = overlay.canvas.getContext("2d").getImageData(20, 34, 1, high).data;
  return shares.map((share) => Array.from(data.slice(4 * Math.round((1 - share) * (high - 1))).slice(0, 3)));
};0
"""


def quaternion(axis, angle):
    axis = np.asarray(axis) / np.linalg.norm(axis)
    return np.concatenate([[np.cos(angle / 2)], np.sin(angle / 2) * axis])


def model(folder, outputs=12, nodes=61, name="model.h5", case=CASE, hole=False, lines=("hose", "rope"), start=0.0):
    """Two lines that swing beside a turning drum, with a field, contacts and a history."""
    t = start + np.arange(outputs) * 0.5
    s = np.linspace(0, 60, nodes)
    x = np.zeros((outputs, nodes * len(lines), 3))
    for k in range(len(lines)):
        part = slice(k * nodes, (k + 1) * nodes)
        x[:, part, 0] = s + 400000.0
        x[:, part, 1] = 8.0 * k
        x[:, part, 2] = -5 - 0.2 * s + np.sin(t[:, None] + 0.1 * s)
    tension = 1e4 + 500 * np.tile(s, len(lines)) + 1e3 * t[:, None]
    if hole:
        tension[:, 20:40] = np.nan
        x[:, 50] = x[:, 49]
    fields = {"position": ("m", x), "effective_tension": ("N", tension)}
    statistics = {"effective_tension": ("N", np.tile(np.mean(tension, axis=0)[:, None], 6))} if outputs > 1 else None
    path = results_file(Path(folder) / name, t, {line: s for line in lines}, fields, case=case, statistics=statistics)
    with h5py.File(path, "r+") as file:
        file["bodies/name"] = [b"drum"]
        file["bodies/position"] = np.tile([400030.0, 4, -12], (outputs, 1, 1)) + t[:, None, None] * 0.1
        file["bodies/rotation"] = np.array([[quaternion([1, 2, 3], 0.3 + 0.21 * k)] for k in range(outputs)])
        corners = np.array([[x, y, z] for x in (-2, 2) for y in (-1, 1) for z in (-1, 1)], float)
        file["volumes/drum/vertices"] = corners
        file["volumes/drum/triangles"] = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6]]
        file["volumes/drum"].attrs.update({"name": b"drum", "body": 0})
        file["messages"] = [b"warning: line rope turns sharply at arc length 30 m", b"note: the drum turns"]
    add_contacts(path, [contacts_of(x, k) for k in range(outputs)])
    return path


def contacts_of(x, k):
    """Contact points of output k: below some nodes, fewer with time, none at the last output but one; one
    force is too small to be shown."""
    nodes = np.arange(10, 10 + max(0, 5 - k))
    force = np.array([[0, 1e3, 2e3 + node] for node in nodes]).reshape(-1, 3)
    force[:1] *= 0.01
    return [(0, -1, 0, -1)] * len(nodes), x[k, nodes] - [0, 0, 0.2], force


@unittest.skipIf(libraries.missing(), libraries.missing())
@unittest.skipUnless(browser.CHROMIUM, browser.ABSENT)
class Drawing(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.browser = browser.Browser()
        cls.addClassCleanup(cls.browser.close)

    def show(self, path, name="page"):
        """Opens a page with only the model."""
        page = Page(name)
        results = Results(path)
        page.model(results)
        file = Path(self.folder.name) / f"{name}.html"
        page.write(file)
        self.browser.open(file)
        self.browser.wait("window.hawserView || window.hawserFailed", 120)
        self.assertIsNone(self.browser.value("window.hawserFailed"))
        return results

    def no_complaints(self):
        self.assertEqual(self.browser.complaints, [])
        self.assertEqual([url for url in self.browser.requests if not url.startswith(("file:", "data:", "blob:"))], [])

    def no_complaints_of(self, server):
        self.assertEqual(self.browser.complaints, [])
        self.assertEqual([url for url in self.browser.requests if not url.startswith((server.address, "data:", "blob:"))], [])
