"""What a headless Chromium draws of results: places, colours and orientations are those of the file; controls have names and can be
used by keys; unusual results are shown."""
import contextlib
import io
import os
import subprocess
import sys
import tempfile
import threading
import unittest
from pathlib import Path

import h5py
import matplotlib.pyplot as plt
import numpy as np

import browser
from support import ROOT
from synthetic import results_file

sys.path.insert(0, str(ROOT / "scripts"))
from hawser_post import __main__ as post  # noqa: E402
from hawser_post.page import Page  # noqa: E402
from hawser_post.results import Results  # noqa: E402
from hawser_post.viewer import libraries, served  # noqa: E402
from hawser_post.viewer.server import Server  # noqa: E402

FULL = bool(os.environ.get("HAWSER_FULL"))
CASE = """\
hawser: 1
title: A hose on a drum
environment: {water: {depth: 30}, seabed: {depth: 30}}
line_types: {hose: {outer_diameter: 0.4}}
lines: {hose: {sections: [{type: hose, length: 60}]}, rope: {sections: [{type: hose, length: 60}]}}
"""
PARTS = CASE.replace("lines: {hose: {sections", "lines: {hose: {masses: [{at: 30, mass: 100, volume: 8}, {at: end_b, mass: 100}], end_b: {joint: yoke}, sections") + """\
joints: {yoke: {start: [400060, 0, -17]}}
links: {tugger: {end_a: {anchor: [400000, 0, 0]}, end_b: {body: drum, at: [2, 1, 1]}}, tie: {end_a: {line: rope, at: 30}, end_b: {line: hose, at: end_a}}}
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
    """Two lines that swing beside a turning drum, with a field, contact forces and a history."""
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
    force = np.zeros_like(x)
    force[:, 10:14] = [0, 1e3, 2e3]
    fields = {"position": ("m", x), "effective_tension": ("N", tension), "contact_force": ("N", force)}
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
    return path


@unittest.skipIf(libraries.missing(), libraries.missing())
@unittest.skipUnless(browser.CHROMIUM, browser.ABSENT)
class Drawn(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.browser = browser.Browser()
        cls.addClassCleanup(cls.browser.close)

    def show(self, path, name="page"):
        """Opens a page with the model alone."""
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

    def test_places_orientations_and_colours_are_those_of_the_file(self):
        results = self.show(model(self.folder.name))
        value = self.browser.value
        for output in (0, 5, 11):
            value(f"hawserView.player.show({output})")
            drawn = np.array(value("""(() => {const {scene, model} = hawserView, at = new THREE.Vector3(), c = model.header.centre;
                return Array.from({length: model.header.nodes}, (_, i) => scene.lines.position(i, at).toArray().map((v, k) => v + c[k]))})()"""))
            self.assertLessEqual(np.abs(drawn - results.file["fields/position"][output]).max(), 1e-3)
            pose = value("(() => {const g = hawserView.scene.bodies.groups[0]; return [g.quaternion.w, g.quaternion.x, g.quaternion.y, "
                         "g.quaternion.z, ...g.position.toArray().map((v, k) => v + hawserView.model.header.centre[k])]})()")
            np.testing.assert_allclose(pose[:4], results.file["bodies/rotation"][output, 0], atol=1e-12)
            np.testing.assert_allclose(pose[4:], results.file["bodies/position"][output, 0], atol=1e-6)
            # A corner of the drum where the matrices of the picture put it.
            corner = value("hawserView.scene.bodies.volumes[0].mesh.localToWorld(new THREE.Vector3(2, 1, 1)).toArray()"
                           ".map((v, k) => v + hawserView.model.header.centre[k])")
            exact = results.rotation(0, output) @ [2, 1, 1] + results.file["bodies/position"][output, 0]
            np.testing.assert_allclose(corner, exact, atol=1e-4)
        value(PIXELS)
        tones = value("[-1, 0, 1, 5].map((body) => hawserView.scene.bodies.paint(body, true).uniforms.colour.value.getHex())")
        self.assertEqual((len(set(tones)), tones[2]), (3, tones[3]))  # bodies that stand beside each other differ
        self.assertEqual(value("hawserView.scene.bodies.volumes[0].mesh.material.uniforms.colour.value.getHex()"), tones[1])
        value("hawserView.scene.shown.forces = hawserView.scene.shown.volumes = false; hawserView.scene.lines.uniforms.enlarged.value = 3;0")
        value("hawserView.look('y')")
        nodes = list(range(3, 59, 6))
        tension = results.file["fields/effective_tension"][11][nodes]
        low, high = (f(results.file["fields/effective_tension"][:]) for f in (np.min, np.max))
        shares = list((tension - low) / (high - low))
        np.testing.assert_allclose(value(f"window.pixels({nodes})"), value(f"window.legend({shares})"), atol=6)
        self.no_complaints()

    def test_before_the_first_picture_its_ground_and_what_is_waited_for_are_shown(self):
        server = Server(served.Shown(model(self.folder.name, name="waits.h5")))
        self.addCleanup(server.server_close)
        self.addCleanup(server.shutdown)
        go, block = threading.Event(), server.shown.block
        server.shown.block = lambda name: (go.wait(60) if name.startswith("position/") else True) and block(name)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        self.browser.open(server.address)
        value = self.browser.value
        value("window.drawnWords = []; const fill = CanvasRenderingContext2D.prototype.fillText;"
              "CanvasRenderingContext2D.prototype.fillText = function (w, ...a) { drawnWords.push(w); return fill.call(this, w, ...a); };0")
        self.browser.wait("drawnWords.includes('Reading the first picture ...')")
        clip = value("(() => {const b = document.querySelector('.picture').getBoundingClientRect(); return {x: b.left, y: b.top, width: b.width, height: b.height}})()")
        shot = Path(self.folder.name) / "waits.png"
        self.browser.picture(shot, clip)
        pixels = np.rint(255 * plt.imread(shot)[5:-5, 5:-5, :3]).reshape(-1, 3)
        self.assertGreater(np.mean(np.all(pixels == [0xf7, 0xf9, 0xfb], axis=1)), 0.95)
        self.assertLess(pixels.min(), 60)  # the words
        go.set()
        self.browser.wait("window.hawserView && hawserView.scene.drawn > 0")
        self.no_complaints_of(server)

    def test_sea_and_bed_have_one_border(self):
        self.show(model(self.folder.name))
        sides = ("(() => {const box = (g) => {g.computeBoundingBox(); const b = g.boundingBox; return [b.min.x, b.min.y, b.max.x, b.max.y]};"
                 "const {sea} = hawserView.scene; return [box(sea.bed.geometry), box(sea.surface.geometry)]})()")
        bed, sea = self.browser.value(sides)
        np.testing.assert_allclose(sea, bed, rtol=1e-6)
        self.assertGreater(bed[2] - bed[0], 60)

    def test_colours_of_the_extremes_of_the_run(self):
        path = model(self.folder.name, name="peak.h5")
        with h5py.File(path, "r+") as file:
            table = file["statistics/effective_tension"]
            table[35:46, 2] = 9e5  # a peak between two outputs
        results = self.show(path)
        value, wait = self.browser.value, self.browser.wait
        value(PIXELS)
        value("window.words = () => hawserView.scene.legendWords();0")
        self.assertEqual(value("window.words()[1]"), "over every step")
        self.assertEqual(value("window.words()[0]").split(" to ")[1], "900")
        self.assertIn("to 900 kN", value("hawserView.controls.status.textContent"))
        value("hawserView.scene.shown.forces = hawserView.scene.shown.volumes = hawserView.scene.shown.sea = hawserView.scene.shown.touchdowns = false;"
              "hawserView.scene.lines.uniforms.enlarged.value = 3; hawserView.look('y')")
        before = value("window.pixels([40])[0]")
        value("(() => {const s = hawserView.controls.values; s.value = 'largest of the run'; s.dispatchEvent(new Event('change'))})()")
        wait("hawserView.scene.ofRun")
        np.testing.assert_allclose(value("window.pixels([40])[0]"), value("hawserView.scene.colours.at(1)"), atol=6)
        self.assertGreater(np.abs(np.subtract(value("window.pixels([40])[0]"), before)).max(), 60)
        self.assertIn("(largest of the run)", value("hawserView.controls.status.textContent"))
        value("hawserView.player.show(3)")
        np.testing.assert_allclose(value("hawserView.scene.lines.values[2 * hawserView.scene.lines.placeOf[40]]"), 9e5)
        value("hawserView.values('')")
        np.testing.assert_allclose(value("hawserView.scene.lines.values[2 * hawserView.scene.lines.placeOf[40]]"),
                                   results.file["fields/effective_tension"][3, 40], rtol=1e-4)
        self.no_complaints()

    def test_the_second_of_two_models_is_visible_on_the_first(self):
        path = model(self.folder.name)
        page = Page("two")
        page.model(Results(path), Results(path))
        file = Path(self.folder.name) / "two.html"
        page.write(file)
        self.browser.open(file)
        self.browser.wait("window.hawserView || window.hawserFailed", 120)
        value = self.browser.value
        value(PIXELS)
        value("hawserView.scene.shown.forces = hawserView.scene.shown.volumes = hawserView.scene.shown.sea = false;"
              "for (const l of [hawserView.scene.lines, ...hawserView.scene.others]) l.uniforms.enlarged.value = 3; hawserView.look('y')")
        nodes = list(range(2, 60))
        drawn = np.array(value(f"window.pixels({nodes})"))
        orange = np.abs(drawn - [0xb3, 0x47, 0x0f]).max(axis=1) < 12
        a = np.abs(drawn - np.array(value(f"nodes = {nodes}, (nodes.map((n) => hawserView.scene.colours.of(hawserView.scene.lines.values[2 * hawserView.scene.lines.placeOf[n]])))"))).max(axis=1) < 12
        self.assertTrue(np.all(orange | a), drawn)
        self.assertTrue(0.3 < orange.mean() < 0.9, orange)
        self.no_complaints()

    def test_controls_have_names_and_can_be_used_by_keys(self):
        self.show(model(self.folder.name))
        tree = self.browser.send("Accessibility.getFullAXTree")["nodes"]
        found = [(node["role"]["value"], node.get("name", {}).get("value", "")) for node in tree if not node.get("ignored")]
        controls = [(role, name) for role, name in found if role in ("button", "slider", "checkbox", "combobox", "spinbutton", "application")]
        self.assertGreater(len(controls), 20)
        self.assertEqual([role for role, name in controls if not name.strip()], [])
        for wanted in (("button", "Play"), ("slider", "Time"), ("combobox", "Colour by"), ("combobox", "Line"), ("checkbox", "Contact forces")):
            self.assertIn(wanted, controls)
        value, key = self.browser.value, self.browser.key
        # The Tab key comes to every control.
        reached = set()
        value("document.body.focus(), document.activeElement.blur()")
        for _ in range(60):
            key("Tab")
            reached.add(value("(() => {const e = document.activeElement; e.n ||= (window.n = (window.n || 0) + 1); return e.n + e.tagName})()"))
        shown = value("[...document.querySelectorAll('.hawser-view button, .hawser-view select, .hawser-view input, .hawser-view canvas[tabindex]')]"
                      ".filter((e) => !e.disabled && e.offsetParent).every((e) => e.n)")
        self.assertTrue(shown, reached)
        value("hawserView.scene.canvas.focus()")
        before = value("hawserView.scene.camera.camera.position.toArray()")
        key("ArrowLeft")
        self.assertNotEqual(value("hawserView.scene.camera.camera.position.toArray()"), before)
        key(" ")
        self.browser.wait("hawserView.player.playing")
        key(" ")
        self.browser.wait("!hawserView.player.playing")
        value("hawserView.controls.slider.focus()")
        value("hawserView.player.show(0)")
        key("ArrowRight")
        self.browser.wait("hawserView.scene.output === 1")
        self.assertEqual(value("hawserView.controls.slider.getAttribute('aria-valuetext')"), "t = 0.50 s")
        self.no_complaints()

    def test_contrast_is_that_of_wcag_aa(self):
        self.show(model(self.folder.name))
        self.browser.wait("[...document.querySelectorAll('.legend span')].some((b) => b.textContent.includes('mean'))")
        low = self.browser.value("""(() => {
          const light = (c) => c.map((v) => (v /= 255) <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)
            .reduce((sum, v, k) => sum + v * [0.2126, 0.7152, 0.0722][k], 0);
          const of = (text) => text.match(/[\\d.]+/g).map(Number);
          const ground = (e) => { for (; e; e = e.parentElement) { const c = of(getComputedStyle(e).backgroundColor);
            if (c.length < 4 || c[3] > 0) return c.slice(0, 3); } return [255, 255, 255]; };
          return [...document.querySelectorAll('.hawser-view *')].filter((e) => [...e.childNodes].some((n) => n.nodeType === 3 && n.data.trim()))
            .filter((e) => e.offsetParent && !e.disabled)
            .map((e) => { const [a, b] = [light(of(getComputedStyle(e).color).slice(0, 3)), light(ground(e))];
              return [(Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05), e.textContent.slice(0, 30)]; })
            .filter(([ratio]) => ratio < 4.5); })()""")
        self.assertEqual(low, [])

    def test_a_click_chooses_a_line_and_its_graphs(self):
        self.show(model(self.folder.name))
        value = self.browser.value
        value("hawserView.scene.shown.volumes = false; hawserView.look('plan')")
        value("document.querySelector('.picture').scrollIntoView()")
        at = value("(() => {const s = hawserView.scene, b = s.canvas.getBoundingClientRect(), p = s.pixelOf(s.lines.position(61 + 15, new THREE.Vector3())); "
                   "return [b.left + p.x, b.top + p.y]})()")
        self.browser.click(*at)
        self.browser.wait("hawserView.chosen === 1")
        self.browser.wait("hawserView.curves.ends.graph && hawserView.curves.range.graph")
        self.assertEqual(value("hawserView.curves.range.title.textContent"), "rope, t = 0.00 s")
        ends = value("[0, 5].map((k) => [hawserView.curves.ends.graph.getValue(k, 1), hawserView.curves.ends.graph.getValue(k, 2)])")
        np.testing.assert_allclose(ends, [[10, 40], [12.5, 42.5]], atol=1e-3)
        np.testing.assert_allclose(value("[hawserView.curves.range.graph.getValue(30, 0), hawserView.curves.range.graph.getValue(30, 1)]"), [30, 25], atol=1e-3)
        self.no_complaints()

    def test_the_wheel_zooms_to_what_is_under_the_pointer(self):
        self.show(model(self.folder.name))
        value = self.browser.value
        value("document.querySelector('.picture').scrollIntoView()")
        node = 61 + 15
        pixel = (f"(() => {{const s = hawserView.scene, b = s.canvas.getBoundingClientRect(), p = s.pixelOf(s.lines.position({node}, new THREE.Vector3())); "
                 "return [b.left + p.x, b.top + p.y, s.camera.pixelAt(s.lines.position(76, new THREE.Vector3()))]})()")
        for view in ("space", "plan", "y"):
            value(f"hawserView.look('{view}')")
            value("hawserView.scene.canvas.focus()")
            x, y, large = value(pixel)
            for _ in range(10):
                self.browser.send("Input.dispatchMouseEvent", type="mouseWheel", x=x, y=y, deltaX=0, deltaY=-100)
            after = value(pixel)
            np.testing.assert_allclose(after[:2], [x, y], atol=3, err_msg=view)
            self.assertLess(after[2], 0.3 * large, view)
        self.no_complaints()

    def test_a_part_fills_the_picture(self):
        self.show(model(self.folder.name))
        value = self.browser.value
        names = value("[...hawserView.controls.part.options].map((o) => o.textContent)")
        self.assertEqual(names, ["a part", "drum", "hose, end A", "hose, end B", "rope, end A", "rope, end B"])
        value("hawserView.controls.part.value = '0'; hawserView.controls.part.dispatchEvent(new Event('change'));0")
        middle, pixel = value("(() => {const s = hawserView.scene, p = s.pixelOf(s.bodies.groups[0].getWorldPosition(new THREE.Vector3())); "
                              "return [[p.x / s.overlay.width, p.y / s.overlay.height], s.camera.pixelAtTarget() * s.overlay.height]})()")
        np.testing.assert_allclose(middle, [0.5, 0.5], atol=0.02)
        self.assertTrue(4 < pixel < 12, pixel)  # m over the height of the picture; the drum measures 4 by 2 by 2 m
        # Of a round shape, which has no edges, too.
        value("(() => {const v = hawserView.scene.bodies.volumes[0]; v.mesh.children[0].geometry = "
              "new THREE.EdgesGeometry(new THREE.SphereGeometry(1, 40, 40), 25)})()")
        box = value("(() => {const b = hawserView.scene.boxOf({body: 0}); return [...b.min.toArray(), ...b.max.toArray()]})()")
        self.assertTrue(all(isinstance(x, (int, float)) for x in box), box)
        value("hawserView.controls.part.value = '4'; hawserView.controls.part.dispatchEvent(new Event('change'));0")
        self.assertLess(value("hawserView.scene.camera.now.controls.target.distanceTo(hawserView.scene.lines.position(121, new THREE.Vector3()))"), 0.1)
        self.no_complaints()

    def test_the_bar_of_lengths_is_round_and_fits(self):
        self.show(model(self.folder.name))
        for pixel in (0.0313, 0.0499, 0.05, 1.0, 6.6, 1e-5):
            drawn = self.browser.value(f"""(() => {{ const words = [], o = hawserView.scene.overlay, text = o.text;
                o.text = (w) => words.push(w); o.scale({pixel}); o.text = text; return words[0]; }})()""")
            length = float(drawn.removesuffix(" m"))
            self.assertTrue(50 * pixel < length <= 150 * pixel * (1 + 1e-12), drawn)
            self.assertIn(f"{length:.0e}"[0], "125")

    def test_cuts_stills_and_notes(self):
        self.show(model(self.folder.name))
        value = self.browser.value
        value("hawserView.cut('plan', 0.5)")
        self.assertIn("cut at z =", value("hawserView.controls.status.textContent"))
        self.assertEqual(value("hawserView.scene.renderer.clippingPlanes.length"), 1)
        value("hawserView.cut('none', 0.5)")
        size = value("hawserView.scene.still().then((png) => createImageBitmap(png)).then((b) => [b.width, b.height])")
        self.assertEqual(size, value("[hawserView.scene.canvas.width, hawserView.scene.canvas.height]"))
        self.assertEqual(value("hawserView.model.header.notes.map((n) => [n.node, n.body, n.volume])"), [[91, None, None], [None, None, 0]])
        self.assertEqual(value("document.querySelectorAll('ol.notes button').length"), 2)
        self.no_complaints()

    def test_unusual_results_are_shown(self):
        plain = "hawser: 1\n"
        meshless = results_file(Path(self.folder.name) / "plain.h5", [0.0], {"line": np.linspace(0, 10, 3)}, case=plain)
        many = results_file(Path(self.folder.name) / "many.h5", [0.0, 1.0], {f"line {k}": np.linspace(0, 9, 50 if FULL else 5) + k for k in range(2000)},
                            case=plain)
        cases = [("nan", model(self.folder.name, name="nan.h5", hole=True)), ("one", model(self.folder.name, 1, name="one.h5")),
                 ("plain", meshless), ("many", many), ("late", model(self.folder.name, name="late.h5", start=7.0))]
        for name, path in cases:
            with self.subTest(name=name):
                results = self.show(path, name)
                self.browser.wait("hawserView.scene.drawn > 0")
                self.assertEqual(self.browser.value("hawserView.model.header.lines.length"), len(results.lines))
                self.no_complaints()
        self.show(cases[0][1], "nan")
        self.browser.value(PIXELS)
        self.browser.value("hawserView.scene.shown.forces = hawserView.scene.shown.volumes = hawserView.scene.shown.sea = false;"
                           "hawserView.scene.lines.uniforms.enlarged.value = 3; hawserView.look('y')")
        np.testing.assert_allclose(self.browser.value("window.pixels([30])[0]"), [150, 150, 150], atol=6)

    def test_links_masses_joints_and_forces_of_the_bed_are_drawn_at_their_places(self):
        path = model(self.folder.name, name="parts.h5", case=PARTS)
        with h5py.File(path, "r+") as file:
            force = np.zeros_like(file["fields/position"][:])
            force[:, 20:24] = [0, 0, 700.0]
            file["fields/seabed_force"] = force
            file["fields/seabed_force"].attrs["unit"] = b"N"
        results = self.show(path)
        value = self.browser.value
        value("hawserView.player.show(5)")
        value("hawserView.scene.draw()")  # what has been asked for is drawn with the next frame only
        centre = np.array(value("hawserView.model.header.centre"))
        x = results.file["fields/position"][5]
        drum = results.rotation(0, 5) @ [2, 1, 1] + results.file["bodies/position"][5, 0]
        ends = np.array(value("hawserView.scene.springs().map(({a, b}) => [[a.x, a.y], [b.x, b.y]])"))
        for link, places in enumerate(([[400000, 0, 0], drum], [x[61 + 30], x[0]])):
            for end, place in zip(ends[link], places):
                pixel = value(f"(() => {{const p = hawserView.scene.pixelOf(new THREE.Vector3(...{list(place - centre)})); return [p.x, p.y]}})()")
                np.testing.assert_allclose(end, pixel, atol=0.1)
        balls = value("hawserView.scene.marks.balls.map((b) => [b.kind, b.name, b.mesh.visible, ...b.mesh.position.toArray(), b.mesh.scale.x])")
        self.assertEqual([ball[:3] for ball in balls], [["buoy", "", True], ["weight", "", True], ["joint", "yoke", True]])
        np.testing.assert_allclose([ball[3:6] for ball in balls], [x[30] - centre, x[60] - centre, x[60] - centre], atol=1e-3)
        self.assertAlmostEqual(balls[0][6], (6 / np.pi) ** (1 / 3), delta=1e-6)
        # Forces of the bed are shown when they are asked for.
        arrows = "hawserView.scene.marks.arrows.map((a) => [a.kind, a.largest, a.meshes[0].visible, a.meshes[0].count])"
        self.assertEqual(value(arrows)[1][:3], ["bedForces", 700, False])
        value("[...document.querySelectorAll('.hawser-view label')].find((l) => l.textContent.includes('Bed forces')).querySelector('input').click()")
        self.browser.wait("hawserView.scene.marks.arrows[1].meshes[0].visible && hawserView.scene.marks.arrows[1].meshes[0].count")
        self.assertEqual(value(arrows)[1], ["bedForces", 700, True, 4])
        value("hawserView.scene.shown.parts = false; hawserView.scene.draw()")
        self.assertFalse(any(value("hawserView.scene.marks.balls.map((b) => b.mesh.visible)")))
        self.no_complaints()

    def test_elements_of_less_than_a_pixel_are_joined_and_drawn_singly_from_near(self):
        results = self.show(model(self.folder.name, 2, 3002, "fine.h5"))
        value = self.browser.value
        value(PIXELS)
        value("hawserView.scene.shown.forces = hawserView.scene.shown.volumes = false; hawserView.scene.lines.uniforms.enlarged.value = 3; hawserView.look('y')")
        nodes = list(range(100, 3000, 400))
        tension = results.file["fields/effective_tension"][0][nodes]
        low, high = (f(results.file["fields/effective_tension"][:]) for f in (np.min, np.max))
        np.testing.assert_allclose(value(f"window.pixels({nodes})"), value(f"window.legend({list((tension - low) / (high - low))})"), atol=6)
        stretches = "hawserView.scene.lines.mesh.geometry.drawRange.count / 6"
        self.assertLess(value(stretches), 2 * 3001 / 3)
        last = value("(() => {const {lines} = hawserView.scene, {count} = lines.mesh.geometry.drawRange; "
                     "return [lines.faces.array[count - 1], 2 * (lines.placeOf[6003] - 1)]})()")
        self.assertEqual(last[0], last[1])  # the end of the line
        value("hawserView.scene.camera.zoom(200); hawserView.scene.draw()")
        self.assertEqual(value(stretches), 2 * 3001)
        edges = "hawserView.scene.draw(), hawserView.scene.bodies.volumes[0].mesh.children[0].visible"
        value("hawserView.scene.shown.volumes = true;0")
        self.assertTrue(value(edges))
        value("hawserView.scene.camera.zoom(0.001)")
        self.assertFalse(value(edges))
        self.no_complaints()

    def test_without_webgl_there_is_a_sentence(self):
        page = Page("none")
        page.model(Results(model(self.folder.name)))
        file = Path(self.folder.name) / "none.html"
        page.write(file)
        file.write_text(file.read_text(encoding="utf-8").replace("<body>", "<body><script>HTMLCanvasElement.prototype.getContext = () => null</script>"),
                        encoding="utf-8")
        self.browser.open(file)
        self.browser.wait("window.hawserFailed")
        self.assertIn("no WebGL", self.browser.value("document.querySelector('.hawser-view').textContent"))

    def test_a_run_is_followed_and_a_server_that_ends_is_reported(self):
        path = model(self.folder.name, 100, name="runs.h5", case=CASE + "dynamics: {duration: 49.5 s}\n")
        def written(count):  # as the program would: in a process of its own
            subprocess.run([sys.executable, "-c", "import h5py, os, sys, time; file = h5py.File(sys.argv[1], 'r+', locking=False); "
                            "file['written'][0] = (int(sys.argv[2]), 0); file.pop('summary', None); file.close(); "
                            "os.utime(sys.argv[1], (time.time() + int(sys.argv[2]),) * 2)", str(path), str(count)], check=True)
        written(20)
        server = Server(served.Shown(path))
        self.addCleanup(server.server_close)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        self.browser.open(server.address)
        value, wait = self.browser.value, self.browser.wait
        wait("window.hawserView && !document.querySelector('.hawser-view progress').parentNode.hidden")
        self.assertEqual(value("[document.title, hawserView.scene.output, hawserView.player.speed]"), ["A hose on a drum - hawser view", 19, 1])
        written(100)
        wait("hawserView.scene.output === 99")
        self.assertEqual(value("[hawserView.controls.slider.max, hawserView.player.speed]"), ["99", 2])
        self.assertIn("49.5 s of 49.5 s", value("document.querySelector('.hawser-view progress').parentNode.textContent"))
        # A speed that was chosen stays; a run may be taken back, by a restart.
        value("(() => {const s = hawserView.controls.speed; s.value = '5'; s.dispatchEvent(new Event('change'))})()")
        written(60)
        wait("hawserView.scene.output === 59")
        self.assertEqual(value("[hawserView.player.speed, hawserView.controls.clock.textContent]"), [5, "t = 29.50 s"])
        self.no_complaints_of(server)
        server.shutdown()
        server.server_close()
        wait("document.querySelector('.hawser-view .bar [role=status]').textContent === 'the server has ended'")

    def no_complaints_of(self, server):
        self.assertEqual(self.browser.complaints, [])
        self.assertEqual([url for url in self.browser.requests if not url.startswith((server.address, "data:", "blob:"))], [])

    def test_figures_of_a_report_can_be_read_off_and_print_as_pictures(self):
        t = np.linspace(0, 20, 400)
        series = (t, {"fairlead": (["effective_tension"], ["N"], 1e4 * np.sin(t)[:, None])})
        path = results_file(Path(self.folder.name) / "figures.h5", np.linspace(0, 20, 5), series=series, case="hawser: 1\n")
        with contextlib.redirect_stdout(io.StringIO()):
            post.main(["report", str(path)])
        self.browser.open(path.with_suffix(".html"))
        self.browser.wait("window.hawserView")
        value = self.browser.value
        value("document.querySelector('figure[data-curves]').scrollIntoView()")
        self.browser.wait("document.querySelector('figure[data-curves]').querySelector('.graph canvas')")
        shown = value("(() => {const f = document.querySelector('figure[data-curves]'); return [getComputedStyle(f.querySelector('img')).display, "
                      "f.querySelector('.graph').offsetHeight > 100]})()")
        self.assertEqual(shown, ["none", True])
        self.browser.send("Emulation.setEmulatedMedia", media="print")
        printed = value("(() => {const f = document.querySelector('figure[data-curves]'); return [getComputedStyle(f.querySelector('img')).display, "
                        "getComputedStyle(f.querySelector('.graph')).display, getComputedStyle(document.querySelector('.hawser-view')).display]})()")
        self.browser.send("Emulation.setEmulatedMedia", media="")
        self.assertEqual(printed, ["block", "none", "none"])
        self.no_complaints()


if __name__ == "__main__":
    unittest.main()
