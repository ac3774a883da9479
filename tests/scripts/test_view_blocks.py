"""Data of a results file for the browser: blocks of numbers, header, and their size."""
import json
import os
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

from support import ROOT
from synthetic import add_contacts, results_file

sys.path.insert(0, str(ROOT / "scripts"))
from hawser_post.results import Results  # noqa: E402
from hawser_post.viewer import blocks, embedded, libraries, notes  # noqa: E402
from hawser_post.viewer.contacts import MOST, SMALLEST, Contacts  # noqa: E402
from hawser_post.viewer.model import Model  # noqa: E402


def header_of(block):
    return json.loads(block[8 : 8 + int.from_bytes(block[4:8], "little")])


class Blocks(unittest.TestCase):
    def test_steps_come_back_to_half_a_step(self):
        random = np.random.default_rng(3)
        for values in (np.cumsum(random.normal(size=(50, 40)), axis=0), random.normal(size=(1, 7)) * 1e5, np.zeros((3, 2)),
                       np.full((2, 2), 5.5), random.normal(size=(400, 1)), np.empty((0, 3))):
            for step in (1e-3, 0.25):
                back = blocks.unpacked(blocks.steps(values, step))
                self.assertEqual(back.shape, values.shape)
                self.assertLessEqual(np.abs(back - values).max(initial=0), 0.5000001 * step)

    def test_what_is_no_number_stays_none(self):
        values = np.array([[1.0, np.nan, 3.0], [np.inf, 2.0, -np.inf]])
        back = blocks.unpacked(blocks.steps(values, 0.01))
        np.testing.assert_array_equal(np.isnan(back), ~np.isfinite(values))
        self.assertAlmostEqual(back[1, 1], 2.0, delta=0.005)
        self.assertTrue(np.isnan(blocks.unpacked(blocks.shares(np.full((2, 3), np.nan)))).all())

    def test_a_range_beyond_32_bits_gets_wider_steps(self):
        values = np.array([[-1e60, 0.0, 1e60]])
        np.testing.assert_allclose(blocks.unpacked(blocks.steps(values, 1e-3)), values, atol=2e60 / blocks.MOST_STEPS)

    def test_plain_values_are_exact(self):
        values = np.random.default_rng(1).normal(size=(9, 5))
        np.testing.assert_array_equal(blocks.unpacked(blocks.plain(values, "float64")), values)
        np.testing.assert_array_equal(blocks.unpacked(blocks.plain([1, 2, 2**31], "uint32")), [[1, 2, 2**31]])

    def test_only_what_gets_half_as_large_is_compressed(self):
        smooth, noise = np.zeros((100, 100)), np.random.default_rng(2).normal(size=(100, 100))
        self.assertTrue(header_of(blocks.plain(smooth, "float32"))["deflated"])
        self.assertFalse(header_of(blocks.plain(noise, "float32"))["deflated"])

    def test_a_swinging_line_takes_two_bytes_a_coordinate(self):
        t, s = np.meshgrid(np.linspace(0, 60, 300), np.linspace(0, 1, 100), indexing="ij")
        x = 50 * s + 3 * np.sin(0.6 * t - 4 * s)
        self.assertLess(len(blocks.steps(x, 1e-3)), 2 * x.size)


def large(folder, outputs=200, nodes=120, name="run.h5"):
    """A line that swings, with fields, one of them with NaN, another with only NaN."""
    t = np.linspace(0, 100, outputs)
    s = np.linspace(0, 150, nodes)
    x = np.zeros((outputs, nodes, 3))
    x[:, :, 0] = 4000.123 + s
    x[:, :, 2] = -80 + 3 * np.sin(0.5 * t[:, None] - 0.05 * s) - 0.2 * s
    tension = 1e5 + 500 * s + 2e4 * np.sin(0.5 * t[:, None])
    hole = tension.copy()
    hole[:, 1] = np.nan
    fields = {"position": ("m", x), "effective_tension": ("N", tension), "with_hole": ("N", hole),
              "nothing": ("m", np.full_like(tension, np.nan)), "velocity": ("m/s", 0.1 * x)}
    path = results_file(Path(folder) / name, t, {"riser": s}, fields)
    add_contacts(path, [([(0, -1, 0, -1)] * 2, x[k, -2:], [[0, 0, 2e3], [0, 10.0 * k, 1e3]]) for k in range(outputs)])
    return path


class Models(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.results = Results(large(cls.folder.name))
        cls.model = Model(cls.results)
        cls.header = cls.model.header()

    def test_positions_are_those_of_the_file(self):
        back = blocks.unpacked(self.model.block("position/0")).reshape(len(self.model.rows), 3, -1).transpose(0, 2, 1)
        off = np.abs(back + self.model.centre - self.results.file["fields/position"][:]).max()
        self.assertLessEqual(off, 1e-3)
        self.assertGreater(off, 0)  # error of quantised values

    def test_ranges_and_units_are_those_of_the_field(self):
        tension = next(f for f in self.header["fields"] if f["name"] == "effective_tension")
        self.assertEqual((tension["unit"], tension["factor"]), ("kN", 1e3))
        values = self.results.file["fields/effective_tension"][:]
        self.assertEqual((tension["low"], tension["high"]), (values.min(), values.max()))
        back = blocks.unpacked(self.model.block("field/effective_tension/0"))
        np.testing.assert_allclose(back, values, atol=np.ptp(values) / 1e5)

    def test_a_field_without_numbers_is_named(self):
        self.assertNotIn("nothing", [f["name"] for f in self.header["fields"]])
        self.assertTrue(any("'nothing'" in words for words in self.header["missing"]))
        self.assertTrue(np.isnan(blocks.unpacked(self.model.block("field/with_hole/0"))[:, 1]).all())

    def test_names_and_no_others_are_blocks(self):
        for name in self.model.names():
            self.assertIsNotNone(self.model.block(name), name)
        for name in ("", "position", "position/7", "position/-1", "field//0", "field/position/0", "../case", "series/energy", "volume/x/vertices",
                     "statistics/nothing", "position/²"):
            self.assertIsNone(self.model.block(name), name)

    def test_parts_make_the_whole(self):
        whole = blocks.unpacked(self.model.block("position/0"))
        parts = Model(self.results, per_block=64)
        found = [blocks.unpacked(parts.block(f"position/{k}")) for k in range(4)]
        self.assertEqual([len(part) for part in found], [64, 64, 64, 8])
        np.testing.assert_allclose(np.concatenate(found), whole, atol=1e-3)

    def test_a_long_run_is_thinned_with_a_note(self):
        results = Results(large(self.folder.name, 900, 300, "long.h5"))
        header, found = embedded.packed_model(results, 60_000)
        self.assertLessEqual(sum(map(len, found.values())) * 4 / 3, 60_000)
        self.assertEqual(header["times"][-1], results.time[-1])
        self.assertTrue(any("one in " in words for words in header["missing"]), header["missing"])

    def test_contact_points_stay_in_a_page_that_has_not_all_fields(self):
        # No figure shows `velocity` (three components), so it is the first field to be excluded.
        results = Results(large(self.folder.name, 60, 300, "some.h5"))
        whole = sum(map(len, embedded.packed_model(results, 1e9)[1].values())) * 4 / 3
        names = set(embedded.packed_model(results, whole - 1)[1])
        self.assertEqual({"contact/place/0", "contact/force/0", "field/velocity/0"} & names, {"contact/place/0", "contact/force/0"})

    def test_contact_points_are_those_of_the_file(self):
        for part, rows in enumerate((range(64), range(64, 128))):
            model = Model(self.results, per_block=64)
            place, force = (blocks.unpacked(model.block(f"contact/{what}/{part}")).reshape(64, 3, 2).transpose(0, 2, 1) for what in ("place", "force"))
            for k, row in enumerate(rows):
                first = 2 * row
                np.testing.assert_allclose(place[k] + model.centre, self.results.file["contact_points/position"][first : first + 2], atol=1e-3)
                np.testing.assert_allclose(force[k], self.results.file["contact_points/force"][first : first + 2], atol=2500 / 9999)
        self.assertAlmostEqual(self.header["contacts"]["largest"], np.hypot(10 * 199, 1e3), delta=1e-2)

    def test_of_very_many_contact_points_the_largest_forces_are_kept(self):
        path = large(self.folder.name, 3, 5, "many.h5")
        random = np.random.default_rng(4)
        outputs = [(np.zeros((n, 4)), random.normal(size=(n, 3)), random.normal(size=(n, 3)) * np.logspace(0, 4, n)[:, None]) for n in (2000, 0, 40)]
        with h5py.File(path, "r+") as file:
            del file["contact_points"], file["outputs/contact_points"]
        add_contacts(path, outputs)
        results = Results(path)
        contacts = Contacts(results.file, [0, 1, 2])
        sizes = [np.linalg.norm(force, axis=1) for _, _, force in outputs]
        self.assertAlmostEqual(contacts.largest, sizes[0].max(), delta=1e-3)
        found = [np.linalg.norm(contacts.at(row)[1], axis=1) for row in range(3)]
        np.testing.assert_allclose(np.sort(found[0]), np.sort(sizes[0])[-MOST:], rtol=1e-6)
        self.assertEqual([len(sizes) for sizes in found], [MOST, 0, np.sum(sizes[2] > SMALLEST * contacts.largest)])
        table = blocks.unpacked(Model(results).block("contact/force/0"))
        self.assertEqual(list(np.isfinite(table).sum(axis=1) // 3), [len(sizes) for sizes in found])

    def test_results_without_contact_points(self):
        path = large(self.folder.name, 3, 5, "none.h5")
        with h5py.File(path, "r+") as file:
            del file["contact_points"], file["outputs/contact_points"]
        model = Model(Results(path))
        self.assertIsNone(model.header()["contacts"])
        self.assertFalse(any(name.startswith("contact/") for name in model.names()))
        self.assertIsNone(model.block("contact/place/0"))

    def test_a_body_below_the_lines_is_in_the_picture(self):
        path = large(self.folder.name, 3, 5, "load.h5")
        with h5py.File(path, "r+") as file:
            file["bodies/name"] = [b"load"]
            file["bodies/position"] = np.tile([4000.0, 7, -150], (3, 1, 1))
            file["bodies/rotation"] = np.tile([1.0, 0, 0, 0], (3, 1, 1))
        low, high = Model(Results(path)).extent
        self.assertEqual((low[2], high[1]), (-150, 7))

    def test_a_model_without_lines_is_as_large_as_its_bodies_and_volumes(self):
        path = large(self.folder.name, 3, 5, "bodies.h5")
        with h5py.File(path, "r+") as file:
            for name, shape in (("lines/name", (0,)), ("lines/first_node", (0,)), ("lines/nodes", (0,)), ("nodes/arc_length", (0,)), ("fields/position", (3, 0, 3))):
                kind = file[name].dtype
                del file[name]
                file[name] = np.zeros(shape, kind)
            file["bodies/name"] = [b"ship"]
            file["bodies/position"] = [[[10.0, 20, 30]], [[40.0, 20, 30]], [[70.0, 20, 30]]]
            file["bodies/rotation"] = np.tile([1.0, 0, 0, 0], (3, 1, 1))
        model = Model(Results(path))
        np.testing.assert_array_equal(model.extent, [[10, 20, 30], [70, 20, 30]])
        np.testing.assert_array_equal(model.centre, [40, 20, 30])

    def test_what_stands_in_a_page_cannot_end_its_script(self):
        embedded_text = embedded.json_of({"title": "</script><!-- x", "low": float("nan"), "n": np.int64(3)})
        self.assertNotIn("</", embedded_text)
        self.assertNotIn("<!--", embedded_text)
        self.assertEqual(json.loads(embedded_text), {"title": "</script><!-- x", "low": None, "n": 3})

    def test_notes_find_their_places(self):
        at = notes.placed(self.results, ["warning: line riser turns at arc length 75 m, t = 3 s", "note: end_b of riser", "note: of nothing here"])
        self.assertAlmostEqual(self.results.lines[0].arc[at[0]["node"]], 75, delta=1)
        self.assertEqual((at[0]["kind"], at[1]["node"], set(at[2])), ("warning", 119, {"text", "kind"}))

    def test_a_large_mesh_keeps_its_corners(self):
        path = large(self.folder.name, 2, 3, "mesh.h5")
        n = 256
        x, y = np.meshgrid(np.arange(n), np.arange(n))
        vertices = np.stack([x, y, np.sin(x)], axis=-1).reshape(-1, 3).astype(float)
        k = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).ravel()
        triangles = np.concatenate([np.stack([k, k + 1, k + n], 1), np.stack([k + 1, k + n + 1, k + n], 1)])
        with h5py.File(path, "r+") as file:
            file["volumes/hull/vertices"], file["volumes/hull/triangles"] = vertices, triangles
        model = Model(Results(path))
        np.testing.assert_array_equal(blocks.unpacked(model.block("volume/hull/triangles")), triangles)
        back = blocks.unpacked(model.block("volume/hull/vertices")) + model.centre
        np.testing.assert_allclose(back, vertices, atol=1e-3)


class Libraries(unittest.TestCase):
    def test_reports_what_is_not_installed(self):
        before = os.environ.get("HAWSER_JAVASCRIPT")
        os.environ["HAWSER_JAVASCRIPT"] = "/nowhere"
        try:
            self.assertIn("/nowhere/three/three.min.js is not installed", libraries.missing())
        finally:
            os.environ.pop("HAWSER_JAVASCRIPT")
            if before:
                os.environ["HAWSER_JAVASCRIPT"] = before

    def test_every_script_of_the_viewer_is_used(self):
        there = {path.stem for path in libraries.PAGE.glob("*.js")} - {"boot"}
        self.assertEqual(there, set(libraries.OWN))


if __name__ == "__main__":
    unittest.main()
