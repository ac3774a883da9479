"""Pictures of results in a headless Chromium: positions, colours and orientations are those of the file, overlays
are in place, and nothing is black before the first picture."""
import threading
import unittest
from pathlib import Path

import h5py
import matplotlib.pyplot as plt
import numpy as np

from drawn import CASE, PIXELS, Drawing, model

from hawser_post.page import Page
from hawser_post.results import Results
from hawser_post.viewer import served
from hawser_post.viewer.server import Server

PARTS = CASE.replace("lines: {hose: {sections", "lines: {hose: {masses: [{at: 30, mass: 100, volume: 8}, {at: end_b, mass: 100}], end_b: {joint: yoke}, sections") + """\
joints: {yoke: {start: [400060, 0, -17]}}
links: {tugger: {end_a: {anchor: [400000, 0, 0]}, end_b: {body: drum, at: [2, 1, 1]}}, tie: {end_a: {line: rope, at: 30}, end_b: {line: hose, at: end_a}}}
"""


class Drawn(Drawing):
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
            # A corner of the drum at the position of the picture's matrices.
            corner = value("hawserView.scene.bodies.volumes[0].mesh.localToWorld(new THREE.Vector3(2, 1, 1)).toArray()"
                           ".map((v, k) => v + hawserView.model.header.centre[k])")
            exact = results.rotation(0, output) @ [2, 1, 1] + results.file["bodies/position"][output, 0]
            np.testing.assert_allclose(corner, exact, atol=1e-4)
        value(PIXELS)
        tones = value("[-1, 0, 1, 5].map((body) => hawserView.scene.bodies.paint(body, true).uniforms.colour.value.getHex())")
        self.assertEqual((len(set(tones)), tones[2]), (3, tones[3]))  # neighbouring bodies differ
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
        self.assertEqual(value("window.words()[0]").split(" to ")[1], "900 kN")
        self.assertIn("to 900 kN", value("hawserView.controls.status.textContent"))
        value("hawserView.scene.shown.forces = hawserView.scene.shown.volumes = hawserView.scene.shown.sea = hawserView.scene.shown.touchdowns = false;"
              "hawserView.scene.lines.uniforms.enlarged.value = 3; hawserView.look('y')")
        before = value("window.pixels([40])[0]")
        value("(() => {const s = hawserView.controls.values; s.value = 'maximum of the run'; s.dispatchEvent(new Event('change'))})()")
        wait("hawserView.scene.ofRun")
        np.testing.assert_allclose(value("window.pixels([40])[0]"), value("hawserView.scene.colours.at(1)"), atol=6)
        self.assertGreater(np.abs(np.subtract(value("window.pixels([40])[0]"), before)).max(), 60)
        self.assertIn("(maximum of the run)", value("hawserView.controls.status.textContent"))
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

    def test_a_name_gives_way_along_its_line(self):
        self.show(model(self.folder.name))
        value = self.browser.value
        value("hawserView.look('y'); hawserView.scene.shown.volumes = false; hawserView.scene.draw()")
        self.assertEqual(value("hawserView.scene.written"), ["drum", "hose", "rope"])  # of two lines at one place
        at, other, badge = "{x: 100, y: 100}", "{x: 100, y: 200}", "[{x: 195, y: 195, w: 18, h: 18}]"
        names = f"[{{words: 'a', places: [{at}]}}, {{words: 'b', places: [{at}]}}, {{words: 'c', places: [{at}, {other}]}}, " \
                "{words: 'd', places: [{x: 190, y: 200}]}, {words: 'e', places: []}]"
        self.assertEqual(value(f"hawserView.scene.overlay.names({names}, {badge})"), ["a", "c"])

    def test_the_bar_of_lengths_is_round_and_fits(self):
        self.show(model(self.folder.name))
        for pixel in (0.0313, 0.0499, 0.05, 1.0, 6.6, 1e-5):
            drawn = self.browser.value(f"""(() => {{ const words = [], o = hawserView.scene.overlay, text = o.text;
                o.text = (w) => words.push(w); o.scale({pixel}); o.text = text; return words[0]; }})()""")
            length = float(drawn.removesuffix(" m"))
            self.assertTrue(50 * pixel < length <= 150 * pixel * (1 + 1e-12), drawn)
            self.assertIn(f"{length:.0e}"[0], "125")

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
        value("hawserView.scene.draw()")  # changes are drawn with the next frame only
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
        arrows = "hawserView.scene.marks.arrows.map((a) => [a.kind, hawserView.model.largestForce(a.kind), a.meshes[0].visible, a.meshes[0].count])"
        self.assertEqual(value(arrows)[1][:3], ["bedForces", 700, False])
        value("[...document.querySelectorAll('.hawser-view label')].find((l) => l.textContent.includes('Bed forces')).querySelector('input').click()")
        self.browser.wait("hawserView.scene.marks.arrows[1].meshes[0].visible && hawserView.scene.marks.arrows[1].meshes[0].count")
        self.assertEqual(value(arrows)[1], ["bedForces", 700, True, 4])
        value("hawserView.scene.shown.parts = false; hawserView.scene.draw()")
        self.assertFalse(any(value("hawserView.scene.marks.balls.map((b) => b.mesh.visible)")))
        self.no_complaints()

    def test_arrows_stand_at_points_of_contact(self):
        results = self.show(model(self.folder.name, name="contacts.h5"))
        value = self.browser.value
        centre = np.array(value("hawserView.model.header.centre"))
        ends = results.file["outputs/contact_points"][:]
        largest = np.linalg.norm(results.file["contact_points/force"][:], axis=1).max()
        self.assertAlmostEqual(value("hawserView.model.largestForce('forces')"), largest, delta=1e-3)
        for output, shown in ((0, 4), (3, 1), (7, 0)):
            value(f"hawserView.player.show({output})")
            value("hawserView.scene.draw()")
            found = value("""(() => {
                const {marks} = hawserView.scene, [shaft] = marks.arrows[0].meshes, m = new THREE.Matrix4(), at = new THREE.Vector3(), turn = new THREE.Quaternion(), scale = new THREE.Vector3();
                return Array.from({length: shaft.count}, (_, k) => {
                  shaft.getMatrixAt(k, m);
                  m.decompose(at, turn, scale);
                  return [...at.toArray(), ...new THREE.Vector3(0, 1, 0).applyQuaternion(turn).toArray(), scale.y / hawserView.scene.camera.pixelAtTarget()];
                });
            })()""")
            part = slice(ends[output] - max(0, 5 - output), ends[output])
            place, force = results.file["contact_points/position"][part][1:], results.file["contact_points/force"][part][1:]
            self.assertEqual(len(found), shown)
            for row, at, f in zip(found, place[::-1], force[::-1]):  # the largest first
                np.testing.assert_allclose(np.array(row[:3]) + centre, at, atol=0.04)  # places near x = 400 km in single precision
                np.testing.assert_allclose(row[3:6], f / np.linalg.norm(f), atol=1e-3)
                self.assertAlmostEqual(row[6], 80 * np.linalg.norm(f) / largest, delta=0.1)
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


if __name__ == "__main__":
    unittest.main()
