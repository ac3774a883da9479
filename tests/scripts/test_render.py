"""scripts/render.py draws a short run: the right pictures, of the right size, showing motion."""
import os
import shutil
import struct
import tempfile
import unittest
import zlib
from pathlib import Path

from support import ROOT, run, write

STEP = """<Grid Name="step" GridType="Collection" CollectionType="Spatial"><Time Value="{time}"/>
<Grid Name="line"><Topology TopologyType="Polyline" NodesPerElement="3" NumberOfElements="1">
<DataItem Dimensions="1 3" Format="XML">0 1 2</DataItem></Topology>
<Geometry GeometryType="XYZ"><DataItem Dimensions="3 3" Format="XML">0 0 {z} 1 0 {z} 2 0 {z}</DataItem></Geometry>
<Attribute Name="effective_tension" Center="Node"><DataItem Dimensions="3" Format="XML">0 1000 2000</DataItem>
</Attribute></Grid>
<Grid Name="volume"><Topology TopologyType="Triangle" NumberOfElements="1">
<DataItem Dimensions="1 3" Format="XML">0 1 2</DataItem></Topology>
<Geometry GeometryType="XYZ"><DataItem Dimensions="3 3" Format="XML">0 1 0 2 1 0 1 1 2</DataItem></Geometry></Grid>
</Grid>"""


def xdmf(times):
    steps = "".join(STEP.format(time=t, z=t) for t in times)
    return ('<?xml version="1.0" ?><Xdmf Version="3.0"><Domain><Grid GridType="Collection" CollectionType="Temporal">'
            f"{steps}</Grid></Domain></Xdmf>")


def read_png(path):
    """Width, height and rows of (r, g, b) bytes of an 8-bit RGB PNG."""
    data, at, body = Path(path).read_bytes(), 8, b""
    width, height = struct.unpack_from(">II", data, 16)
    while at < len(data):
        size, kind = struct.unpack_from(">I4s", data, at)
        if kind == b"IDAT":
            body += data[at + 8 : at + 8 + size]
        at += size + 12
    raw, stride, rows = zlib.decompress(body), 3 * width + 1, []
    previous = bytearray(3 * width)
    for y in range(height):
        kind, row = raw[y * stride], bytearray(raw[y * stride + 1 : (y + 1) * stride])
        for i in range(len(row)):
            a, b, c = (row[i - 3] if i >= 3 else 0), previous[i], (previous[i - 3] if i >= 3 else 0)
            nearest = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
            row[i] = (row[i] + [0, a, b, (a + b) // 2, nearest][kind]) & 255
        rows.append(row)
        previous = row
    return width, height, rows


def coloured(rows):
    """(row, column) of pixels that are neither grey nor white: the lines; the colour bar is on the right."""
    return [(y, x // 3) for y, row in enumerate(rows) for x in range(0, len(row), 3)
            if max(row[x : x + 3]) - min(row[x : x + 3]) > 60]


@unittest.skipUnless(shutil.which("pvpython") and shutil.which("Xvfb"), "scripts/install-deps --view")
class Render(unittest.TestCase):
    def render(self, folder, *options):
        write(folder, "small.xdmf", xdmf([0, 1, 2]))
        result = run("scripts/with-display", "pvpython", ROOT / "scripts" / "render.py",
                     Path(folder) / "small.xdmf", Path(folder) / "out", "--size", "200", "160", "--direction=0,1,0", "--focus", "0.5,0,1",
                     "--height", "4", "--diameter", "0.4", *options, timeout=300)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return sorted(p.name for p in (Path(folder) / "out").iterdir())

    def test_pictures(self):
        with tempfile.TemporaryDirectory() as folder:
            names = self.render(folder, "--pictures", "2")
            self.assertEqual(names, ["small.png", "small_0000.png", "small_0001.png"])
            first, last, both = (read_png(Path(folder) / "out" / name) for name in
                                 ("small_0000.png", "small_0001.png", "small.png"))
            self.assertEqual(first[:2], (200, 160))
            self.assertEqual(both[:2], (400, 160))
            # 4 m high, 160 pixels: the line of x = 0 ... 1 m left of the colour bar is at z = 0, then at 2 m.
            for picture, z in ((first, 0), (last, 2)):
                found = [y for y, x in coloured(picture[2]) if 80 < x < 120]
                self.assertGreater(len(found), 200)
                self.assertAlmostEqual(sum(found) / len(found), 80 - 40 * (z - 1), delta=4)

    def test_tube_of_the_filters_own_radius(self):
        # ParaView's tube filter drew nothing at a radius of exactly 1.
        with tempfile.TemporaryDirectory() as folder:
            self.render(folder, "--at", "1", "--diameter", "2")
            _, _, rows = read_png(Path(folder) / "out" / "small_0000.png")
            self.assertGreater(len([y for y, x in coloured(rows) if 80 < x < 120]), 1000)

    def test_wanted_time_and_absent_field(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(self.render(folder, "--at", "1", "--field", "nothing"), ["small.png", "small_0000.png"])


CASE = """\
hawser: 1
environment:
  water: {depth: 20}
  waves: {regular: {height: 2, period: 6}}
  seabed: {depth: 20}
line_types:
  thick: {outer_diameter: 1.0, mass_per_length: 900, EA: 1e8, bending: false}
  thin: {outer_diameter: 0.4, mass_per_length: 200, EA: 1e8, bending: false}
joints: {yoke: {start: [0, 0, -10]}}
lines:
  left:
    sections: [{type: thick, length: 17, elements: 8}]
    end_a: {anchor: [-14, 0, -4]}
    end_b: {joint: yoke}
    masses: [{at: 8, mass: 500, volume: 2}]
  right: {sections: [{type: thin, length: 17, elements: 8}], end_a: {joint: yoke}, end_b: {anchor: [14, 0, -4]}}
dynamics: {duration: 1, step: 0.1}
output: {every: 0.25}
"""
HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))


@unittest.skipUnless(shutil.which("pvpython") and shutil.which("Xvfb") and Path(HAWSER).exists(), "scripts/install-deps --view")
class Scenery(unittest.TestCase):
    def render(self, folder, *options, path=None):
        if not (Path(folder) / "sea.h5").exists():
            write(folder, "sea.yaml", CASE)
            result = run(HAWSER, "run", "-q", "sea.yaml", cwd=folder)
            self.assertEqual(result.returncode, 0, result.stderr)
        return run("scripts/with-display", "pvpython", ROOT / "scripts/render.py", Path(folder) / "sea.xdmf",
                   Path(folder) / "out", "--size", "240", "160", "--direction=0,1,-0.2", "--focus", "0,0,-10", "--height", "32",
                   "--pictures", "1", *options, timeout=300, env={**os.environ, **({"PATH": path} if path else {})})

    def picture(self, folder, *options):
        result = self.render(folder, *options)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return read_png(Path(folder) / "out/sea.png")[2]

    @staticmethod
    def count(rows, test):
        return sum(bool(test(*row[x : x + 3])) for row in rows for x in range(0, len(row), 3))

    def test_sea_buoys_names_diameters_and_film(self):
        def orange(r, g, b):
            return r > 130 and r > g + 40 > b + 60

        def dark(r, g, b):
            return max(r, g, b) < 90 and max(r, g, b) - min(r, g, b) < 12

        with tempfile.TemporaryDirectory() as folder:
            film = ["--film", str(Path(folder) / "run.mp4")] if shutil.which("ffmpeg") else []
            everything = self.picture(folder, *film)
            bare = self.picture(folder, "--no-names", "--no-sea")
            # Almost from the side, 5 pixels per metre: water in the upper half, the bed in the lower one.
            self.assertGreater(self.count(everything[5:70], lambda r, g, b: b > r + 25 > 175), 300)
            self.assertLess(self.count(bare[5:70], lambda r, g, b: b > r + 25 > 175), 100)
            self.assertGreater(self.count(everything[90:], lambda r, g, b: 230 > r > g > b + 15 > 80), 300)
            self.assertGreater(self.count(bare, orange), 20)  # the buoy, a ball of 0.78 m radius
            self.assertGreater(self.count(everything, dark), self.count(bare, dark) + 30)  # names
            # True diameters: the left line is 2.5 times as thick as the right one; a factor applies to both.
            thick = self.picture(folder, "--no-names", "--no-sea", "--factor", "3")

            def across(rows, columns):
                return sum(max(row[3 * x : 3 * x + 3]) - min(row[3 * x : 3 * x + 3]) > 30
                           for row in rows[:100] for x in columns) / len(columns)

            left, right = range(55, 76), range(131, 139)  # where each is almost level, and away from the colour bar
            self.assertAlmostEqual(across(thick, left) / across(thick, right), 2.5, delta=0.4)
            self.assertGreater(across(thick, right), 2 * across(bare, right))
            if film:
                self.assertEqual((Path(folder) / "run.mp4").read_bytes()[4:8], b"ftyp")
                shown = run("ffprobe", "-v", "error", "-count_frames", "-show_entries",
                            "stream=nb_read_frames,width,height", "-of", "csv=p=0", Path(folder) / "run.mp4")
                self.assertEqual(shown.stdout.split(), ["240,160,5"])  # as many as outputs

    def test_film_needs_ffmpeg(self):
        with tempfile.TemporaryDirectory() as folder:
            bare = Path(folder) / "bin"
            bare.mkdir()
            for tool in ("bash", "pvpython", "Xvfb", "mktemp", "rm", "sleep", "env", "xkbcomp"):
                (bare / tool).symlink_to(shutil.which(tool) or "/bin/true")
            (bare / "ssh").symlink_to("/bin/true")  # Open MPI, which ParaView starts, looks for it
            result = self.render(folder, "--film", "run.mp4", path=str(bare))
            self.assertNotEqual(result.returncode, 0)
            self.assertIn("a film needs ffmpeg", result.stdout + result.stderr)


if __name__ == "__main__":
    unittest.main()
