"""Gridded and meshed beds are drawn from their files in every supported format."""
import struct
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

from support import ROOT
from synthetic import results_file

sys.path.insert(0, str(ROOT / "scripts"))
from hawser_post.results import Results  # noqa: E402
from hawser_post.sea import Sea  # noqa: E402
from hawser_post.viewer.model import Model  # noqa: E402

N = 5  # points along a side, 10 m apart


def height(x, y):
    return -50 - 0.1 * x + 0.2 * y  # a plane, reproduced by any interpolation


X, Y = (v.ravel() for v in np.meshgrid(10.0 * np.arange(N), 10.0 * np.arange(N)))
VERTICES = np.stack([X, Y, height(X, Y)], axis=1)
K = (np.arange(N - 1)[:, None] * N + np.arange(N - 1)).ravel()
TRIANGLES = np.concatenate([np.stack([K, K + 1, K + N], 1), np.stack([K + 1, K + N + 1, K + N], 1)])


def rows(values):
    return "\n".join(" ".join(f"{v:.9g}" for v in row) for row in values)


def binary_stl():
    facets = b"".join(struct.pack("<12fH", 0, 0, 1, *VERTICES[t].ravel(), 0) for t in TRIANGLES)
    return b"solid or not".ljust(80) + struct.pack("<I", len(TRIANGLES)) + facets


def text_stl():
    facets = ["facet normal 0 0 1\n outer loop\n" + "\n".join(f"  vertex {rows([v])}" for v in VERTICES[t]) + "\n endloop\nendfacet" for t in TRIANGLES]
    return ("solid bed\n" + "\n".join(facets) + "\nendsolid").encode()


def ply(form):
    head = (f"ply\nformat {form} 1.0\ncomment x\nelement vertex {len(VERTICES)}\nproperty uchar mark\nproperty double x\nproperty double y\n"
            f"property float z\nelement face {len(TRIANGLES)}\nproperty list uchar int vertex_indices\nend_header\n").encode()
    if form == "ascii":
        return head + "\n".join(["7 " + rows([v]) for v in VERTICES] + [f"3 {a} {b} {c}" for a, b, c in TRIANGLES]).encode()
    order = "<" if "little" in form else ">"
    return head + b"".join(struct.pack(order + "Bddf", 7, *v) for v in VERTICES) + b"".join(struct.pack(order + "B3i", 3, *t) for t in TRIANGLES)


def obj():
    return ("# v 1 2 3\n" + "\n".join(f"v {rows([v])}" for v in VERTICES) + "\nvn 0 0 1\n" +
            "\n".join(f"f {a + 1} {b + 1} {c + 1}" for a, b, c in TRIANGLES)).encode()


FILES = {"bed.stl": binary_stl(), "text.stl": text_stl(), "bed.obj": obj(), "bed.ply": ply("ascii"), "little.ply": ply("binary_little_endian"),
         "big.ply": ply("binary_big_endian")}


class Beds(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def results(self, keys):
        self.count = getattr(self, "count", 0) + 1
        case = f"hawser: 1\nenvironment: {{seabed: {keys}}}\n"
        return Results(results_file(self.folder / f"run {self.count}.h5", lines={"line": np.linspace(0, 40, 5)}, case=case))

    def check_heights(self, keys, at=1.0):
        x, y = np.array([3.0, 22.0, 39.0]), np.array([31.0, 4.0, 38.0])
        np.testing.assert_allclose(Sea(self.results(keys)).seabed(at * x, at * y), at * height(x, y), atol=1e-4, err_msg=keys)

    def test_meshes_of_every_format(self):
        for name, data in FILES.items():
            (self.folder / name).write_bytes(data)
            self.check_heights(f"{{mesh: {{file: {name}}}}}")
        self.check_heights("{mesh: {file: bed.stl, scale: 0.5}}", 0.5)

    def test_grids_with_commas_comments_and_depths(self):
        (self.folder / "bed.txt").write_text("# x, y, depth\n" + rows(VERTICES * [1, 1, -1]).replace(" ", ", "), encoding="utf-8")
        self.check_heights("{grid: {file: bed.txt, depths: true}}")

    def test_the_model_has_the_bed_and_nothing_beyond_its_edge(self):
        (self.folder / "bed.obj").write_bytes(FILES["bed.obj"])
        model = Model(self.results("{mesh: {file: bed.obj}}"))
        x, y, z = model.bed
        self.assertTrue(model.header()["bed"])
        there = np.isfinite(z)
        x, y = np.meshgrid(x, y)
        self.assertTrue(there.any())
        self.assertFalse(there[(x > 40.1) | (y < -0.1)].any())

    def test_what_is_no_bed_is_reported(self):
        bad = {"short.stl": FILES["bed.stl"][:200], "words.obj": b"v a b c", "head.ply": FILES["little.ply"][:150], "none.ply": b"ply\n", "one.obj": b"v 1 2 3",
               "short.ply": FILES["little.ply"][:400], "rest.stl": b"\0" * 84}
        for name, data in bad.items():
            (self.folder / name).write_bytes(data)
        (self.folder / "folder").mkdir()
        for name in (*bad, "missing.stl", "/dev/zero", "folder"):
            results = self.results(f"{{mesh: {{file: '{name}'}}}}")
            self.assertFalse(Sea(results).bed, name)
            self.assertIn("The seabed is not drawn", Model(results).header()["missing"][0])
            self.assertFalse(Sea(self.results(f"{{grid: {{file: '{name}'}}}}")).bed, name)


if __name__ == "__main__":
    unittest.main()
