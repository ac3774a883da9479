"""A browser with a model: controls have names and respond to keys, clicks and the wheel; unusual results are shown;
a run is followed; figures of a report are graphs."""
import contextlib
import io
import os
import subprocess
import sys
import threading
import unittest
from pathlib import Path

import h5py
import matplotlib.pyplot as plt
import numpy as np

from drawn import CASE, PIXELS, Drawing, model
from synthetic import results_file

from hawser_post import __main__ as post
from hawser_post.page import Page
from hawser_post.results import Results
from hawser_post.viewer import served
from hawser_post.viewer.server import Server

FULL = bool(os.environ.get("HAWSER_FULL"))


class Used(Drawing):
    def test_controls_have_names_and_can_be_used_by_keys(self):
        self.show(model(self.folder.name))
        tree = self.browser.send("Accessibility.getFullAXTree")["nodes"]
        found = [(node["role"]["value"], node.get("name", {}).get("value", "")) for node in tree if not node.get("ignored")]
        controls = [(role, name) for role, name in found if role in ("button", "slider", "checkbox", "combobox", "spinbutton", "application")]
        self.assertGreater(len(controls), 20)
        self.assertEqual([role for role, name in controls if not name.strip()], [])
        for expected in (("button", "Play"), ("slider", "Time"), ("combobox", "Colour by"), ("combobox", "Line"), ("checkbox", "Contact forces")):
            self.assertIn(expected, controls)
        value, key = self.browser.value, self.browser.key
        # The Tab key reaches every control.
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

    def test_graphs_zoom_read_off_and_keep_curves(self):
        self.show(model(self.folder.name))
        value, wait = self.browser.value, self.browser.wait
        wait("hawserView.curves.range.graph && hawserView.curves.ends.graph")
        graph = "hawserView.curves.ends.graph"
        value("hawserView.curves.ends.element.scrollIntoView()")
        left, top, width, high = value(f"(() => {{const a = {graph}.getArea(), b = hawserView.curves.ends.plot.getBoundingClientRect(); "
                                       "return [b.left + a.x, b.top + a.y, a.w, a.h]})()")
        for kind, share in (("mousePressed", 0.25), ("mouseMoved", 0.5), ("mouseReleased", 0.5)):
            self.browser.send("Input.dispatchMouseEvent", type=kind, x=left + share * width, y=top + 0.5 * high, button="left", clickCount=1)
        low, high = value(f"{graph}.xAxisRange()")
        np.testing.assert_allclose([low, high], [0.25 * 5.5, 0.5 * 5.5], atol=0.15)
        value("hawserView.curves.ends.whole.click()")
        self.assertLess(value(f"{graph}.xAxisRange()[0]"), 0.1)
        value("hawserView.curves.ends.plot.focus()")
        for _ in range(3):
            self.browser.key("ArrowRight")
        self.assertIn("end A: 11", value("hawserView.curves.ends.legend.textContent").replace("\xa0", " "))
        value("hawserView.curves.keep.click()")
        value("hawserView.player.show(6)")
        wait("hawserView.curves.range.names.length === 6")
        self.assertEqual(value("hawserView.curves.range.names.slice(1, 3)"), ["t = 3.00 s", "t = 0.00 s"])
        np.testing.assert_allclose(value("[1, 2].map((k) => hawserView.curves.range.graph.getValue(0, k))"), [13, 10], atol=1e-3)
        value("hawserView.curves.drop.click()")
        self.assertEqual(value("hawserView.curves.range.names.slice(1, 3)"), ["t = 3.00 s", "minimum of the run"])
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
        # Including a round shape, which has no edges.
        value("(() => {const v = hawserView.scene.bodies.volumes[0]; v.mesh.children[0].geometry = "
              "new THREE.EdgesGeometry(new THREE.SphereGeometry(1, 40, 40), 25)})()")
        box = value("(() => {const b = hawserView.scene.boxOf({body: 0}); return [...b.min.toArray(), ...b.max.toArray()]})()")
        self.assertTrue(all(isinstance(x, (int, float)) for x in box), box)
        value("hawserView.controls.part.value = '4'; hawserView.controls.part.dispatchEvent(new Event('change'));0")
        self.assertLess(value("hawserView.scene.camera.now.controls.target.distanceTo(hawserView.scene.lines.position(121, new THREE.Vector3()))"), 0.1)
        self.no_complaints()

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
        mesh = results_file(Path(self.folder.name) / "mesh.h5", [0.0, 1.0], {"line": np.linspace(0, 10, 3)}, case=plain + "statics: false\n")
        with h5py.File(mesh, "r+") as file:
            x, y = np.meshgrid(np.linspace(-20, 20, 256), np.linspace(-20, 20, 256))
            k = (np.arange(255)[:, None] * 256 + np.arange(255)).ravel()
            file["volumes/hill/vertices"] = np.stack([x, y, -3 + np.sin(x / 3)], axis=-1).reshape(-1, 3)
            file["volumes/hill/triangles"] = np.concatenate([np.stack([k, k + 1, k + 256], 1), np.stack([k + 1, k + 257, k + 256], 1)])
        cases = [("mesh", mesh), ("nan", model(self.folder.name, name="nan.h5", hole=True)), ("one", model(self.folder.name, 1, name="one.h5")),
                 ("plain", meshless), ("many", many), ("late", model(self.folder.name, name="late.h5", start=7.0))]
        for name, path in cases:
            with self.subTest(name=name):
                results = self.show(path, name)
                self.browser.wait("hawserView.scene.drawn > 0")
                self.assertEqual(self.browser.value("hawserView.model.header.lines.length"), len(results.lines))
                self.no_complaints()
        self.show(mesh, "mesh")
        self.assertEqual(self.browser.value("hawserView.scene.bodies.volumes[0].mesh.geometry.getAttribute('position').count"), 65536)
        self.browser.value("hawserView.look('plan')")
        clip = self.browser.value("(() => {const b = document.querySelector('.picture').getBoundingClientRect(); "
                                  "return {x: b.left + 0.6 * b.width, y: b.top + 0.3 * b.height, width: 150, height: 150}})()")
        tones = {}
        for shown in ("true", "false"):  # slopes of the hill have different tones
            self.browser.value(f"hawserView.scene.shown.volumes = {shown}; hawserView.scene.draw()")
            shot = Path(self.folder.name) / f"mesh-{shown}.png"
            self.browser.picture(shot, clip)
            tones[shown] = len(np.unique(np.rint(255 * plt.imread(shot)[:, :, :3]).reshape(-1, 3), axis=0))
        self.assertTrue(tones["true"] > 8 and tones["false"] < 5, tones)
        self.show(cases[1][1], "nan")
        self.browser.value(PIXELS)
        self.browser.value("hawserView.scene.shown.forces = hawserView.scene.shown.volumes = hawserView.scene.shown.sea = false;"
                           "hawserView.scene.lines.uniforms.enlarged.value = 3; hawserView.look('y')")
        np.testing.assert_allclose(self.browser.value("window.pixels([30])[0]"), [150, 150, 150], atol=6)

    def test_without_webgl_there_is_a_sentence(self):
        page = Page("none")
        page.model(Results(model(self.folder.name)))
        file = Path(self.folder.name) / "none.html"
        page.write(file)
        file.write_text(file.read_text(encoding="utf-8").replace("<body>", "<body><script>HTMLCanvasElement.prototype.getContext = () => null</script>"),
                        encoding="utf-8")
        self.browser.open(file)
        self.browser.wait("window.hawserFailed")
        self.assertIn("needs WebGL", self.browser.value("document.querySelector('.hawser-view').textContent"))

    def test_a_run_is_followed_and_a_server_that_ends_is_reported(self):
        path = model(self.folder.name, 100, name="runs.h5", case=CASE + "dynamics: {duration: 49.5 s}\n")
        def written(count):  # as by the program, in a separate process
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
        # The chosen speed is kept when a restart shortens the run.
        value("(() => {const s = hawserView.controls.speed; s.value = '5'; s.dispatchEvent(new Event('change'))})()")
        written(60)
        wait("hawserView.scene.output === 59")
        self.assertEqual(value("[hawserView.player.speed, hawserView.controls.clock.textContent]"), [5, "t = 29.50 s"])
        self.no_complaints_of(server)
        server.shutdown()
        server.server_close()
        wait("document.querySelector('.hawser-view .bar [role=status]').textContent === 'the server has ended'")

    def test_histories_have_their_labels_and_units_and_fit_beside_the_picture(self):
        t = np.linspace(0, 20, 400)
        name = "hose at its upper end, which has a long name for a history"
        series = (t, {name: (["effective_tension", "bending_moment_3"], ["N", "N m"], 1e4 * np.stack([np.sin(t), np.cos(t)], axis=1))})
        path = results_file(Path(self.folder.name) / "names.h5", np.linspace(0, 20, 5), series=series, case="hawser: 1\n")
        server = Server(served.Shown(path))
        self.addCleanup(server.server_close)
        self.addCleanup(server.shutdown)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        self.browser.open(server.address)
        self.browser.wait("window.hawserView")
        value = self.browser.value
        options = value("[...document.querySelectorAll('.graphs select option')].map((o) => o.textContent)")
        self.assertEqual(options, ["none", f"{name}: effective tension [kN]", f"{name}: bending moment 3 [kN m]"])
        value("(() => {const s = document.querySelector('.graphs select'); s.value = '0 1'; s.dispatchEvent(new Event('change'))})()")
        self.browser.wait("hawserView.curves.stored.graph")
        np.testing.assert_allclose(value("[0, 1].map((c) => hawserView.curves.stored.graph.getValue(0, c))"), [0, 10], atol=1e-4)
        self.assertEqual(value("document.querySelector('.side').scrollWidth - document.querySelector('.side').clientWidth"), 0)
        self.no_complaints_of(server)

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
