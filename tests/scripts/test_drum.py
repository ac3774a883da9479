"""The reel's drum: closed, of the right size, equal to the one in the case's folder; the script's own check can
fail."""
import importlib.util
import math
import struct
import tempfile
import unittest
from pathlib import Path

from support import ROOT

FOLDER = ROOT / "cases" / "reel"


def load():
    spec = importlib.util.spec_from_file_location("make_drum", FOLDER / "make_drum.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def read_stl(path):
    """(normal, three vertices) of every triangle of a binary STL."""
    data = Path(path).read_bytes()
    (count,) = struct.unpack_from("<I", data, 80)
    assert len(data) == 84 + 50 * count
    for i in range(count):
        numbers = struct.unpack_from("<12f", data, 84 + 50 * i)
        yield numbers[:3], (numbers[3:6], numbers[6:9], numbers[9:12])


class Drum(unittest.TestCase):
    def setUp(self):
        self.drum = load()

    def test_committed_file_is_what_the_script_makes(self):
        with tempfile.TemporaryDirectory() as folder:
            self.drum.write_stl(Path(folder) / "drum.stl", self.drum.spool())
            made = list(read_stl(Path(folder) / "drum.stl"))
        kept = list(read_stl(FOLDER / "drum.stl"))
        self.assertEqual(len(made), len(kept))
        for (_, one), (_, two) in zip(made, kept):
            for a, b in zip(one, two):
                # Half a micrometre: single precision of a coordinate of 6 m.
                self.assertLess(math.dist(a, b), 1e-6)

    def test_is_closed_and_measures_what_the_case_has(self):
        triangles = [t for _, t in read_stl(FOLDER / "drum.stl")]
        self.assertEqual(self.drum.faults(triangles), [])
        barrel = [v for t in triangles for v in t if math.hypot(v[0], v[2]) < 3.7 and abs(v[1]) < 2.7]
        self.assertGreater(len(barrel), 96 * 11)
        for x, _, z in barrel:
            # Marlim Sul: drum diameter 7.200 m.
            self.assertAlmostEqual(math.hypot(x, z), 3.6, delta=1e-6)
        self.assertAlmostEqual(max(math.hypot(v[0], v[2]) for t in triangles for v in t), 6.4, delta=1e-6)

    def test_normals_face_out_of_the_spool(self):
        for normal, vertices in read_stl(FOLDER / "drum.stl"):
            x, y, z = (sum(c) / 3 for c in zip(*vertices))
            radius = math.hypot(x, z)
            if radius < 3.61 and abs(y) < 2.74:
                self.assertGreater((normal[0] * x + normal[2] * z) / radius, 0.999)
            elif 3.61 < radius < 6.39 and abs(y) < 2.76:
                # An inner face of a flange faces the middle.
                self.assertLess(normal[1] * y / abs(y), -0.999)

    def test_check_notices(self):
        sound = self.drum.spool()
        a, b, c = sound[500]
        for broken, word in [
            (sound[:500] + sound[501:], "not closed"),
            (sound[:500] + [(a, c, b)] + sound[501:], "not of one orientation"),
            (sound + [sound[500]], "more than once"),
            ([(p, r, q) for p, q, r in sound], "inside out"),
            (sound[:500] + [(a, b, b)] + sound[501:], "degenerate"),
            ([tuple((x, 1.01 * y, z) for x, y, z in t) for t in sound], "volume"),
        ]:
            with self.subTest(word=word):
                self.assertIn(word, "; ".join(self.drum.faults(broken)))


if __name__ == "__main__":
    unittest.main()
