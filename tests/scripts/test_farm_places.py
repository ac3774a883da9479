"""Places of a farm: wrong files and lists of places are refused in one sentence, likely mistakes are noted, placed copies equal the
platform alone, and `hawser check -n` predicts the memory of a rank."""
import os
import re
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

from support import ROOT, run

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
SEA = """environment:
  water: {density: 1025, depth: 100}
  seabed: {depth: 100, normal_stiffness: {per_area: 100 kN/m3}, friction: 0.6}
contact: {between_lines: false}
dynamics: {duration: 1, step: 0.1}
"""
PLATFORM = "hawser: 1\n" + SEA + """line_types:
  chain: {outer_diameter: 0.18, mass_per_length: 200, EA: 800 MN, bending: false, Cd_normal: 1.3}
bodies:
  float: {position: [0, 0, 0], motion: {harmonic: {amplitude: [0.3, 0.1, 0.2], phase_deg: [90, 90, 90], period: 8}}}
lines:
"""
LINE = ("  {0}: {{sections: [{{type: chain, length: 270, elements: {2}}}], end_a: {{anchor: [-245, {1}, -100]}}, "
        "end_b: {{body: float, at: [-8, {1}, -5]}}}}\n")
# A winch that keeps a tension, so that statics finds its stock at each place.
WINCH = """  wire:
    sections: [{type: chain, length: 300, elements: 60}]
    end_a: {body: float, at: [0, 5, 0], feed: {stock: 30, tension: 500 kN, speed_per_tension: 1e-6}}
    end_b: {anchor: [200, 5, -100]}
"""
# A file of each process: mpirun may lose or mix what the processes print as they end.
MEMORY = ("import os, resource, subprocess, sys; r = subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL).returncode; "
          "open(f'{os.getpid()}.peak', 'w').write(str(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)); sys.exit(r)")


class Places(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = Path(place.name)
        self.write("platform.yaml", PLATFORM + LINE.format("west", 0, 8))

    def write(self, name, text):
        (self.folder / name).write_text(text, "utf-8")

    def hawser(self, farm, *words, command="check", more="", ranks=1):
        self.write("farm.yaml", f"hawser: 1\nfarm: {farm}\n" + SEA + more)
        ahead = ("mpirun", "-q", "-n", ranks) if ranks > 1 else ()
        return run(*ahead, HAWSER, command, "farm.yaml", *words, cwd=self.folder, timeout=600)

    def refused(self, reason, farm, *words, more=""):
        for ranks in (1, 2):
            result = self.hawser(farm, *words, more=more, ranks=ranks)
            self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
            self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
            self.assertIn(reason, result.stderr)

    def test_wrong_files_of_places(self):
        for text, reason in (
                ("x,y,heading\n0,0,0\n", "places.csv:1: 'x' is no finite number; begin a line of titles with '#'"),
                ("0;0;0\n", "places.csv:1: '0;0;0' is no finite number; separate numbers by blanks or commas"),
                ("0,0\n600,6OO\n", "places.csv:2: '6OO' is no finite number\n"),
                ("0,0\n600,,30\n", "places.csv:2: a number is missing before a comma"),
                (",0,30\n", "places.csv:1: a number is missing before a comma"),
                ("0,0\n600\n", "places.csv:2: a row of places has 2 numbers, x and y, or 3, and the heading, but this one has 1"),
                ("", "places.csv: the file has no rows"),
                ("0,0\n600,0\n0.0004,0.0004\n", "places.csv:3: T3 is at the place of T1, (0.0004, 0.0004)")):
            self.write("places.csv", text)
            self.refused(reason, "{of: platform.yaml, file: places.csv}")

    def test_files_of_spreadsheets(self):
        """A byte order mark, lines that end as on Windows, commas at the end of rows, titles and blank lines."""
        (self.folder / "places.csv").write_bytes(b"\xef\xbb\xbf# x,y,heading\r\n0, 0,,\r\n600,100,30,\r\n,,\r\n\r\n")
        result = self.hawser("{of: platform.yaml, file: places.csv}")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("T1: (0, 0) m, heading 0 deg", result.stdout)
        self.assertIn("T2: (600, 100) m, heading 30 deg", result.stdout)
        self.assertNotIn("T3", result.stdout)

    def test_parts_of_one_place(self):
        at = "{of: platform.yaml, at: [[0, 0], [600, 0]]}"
        self.refused("there is no 'T1/west'; a part of a farm's platform changes at all its places, by 'farm.of.' before its key, or 'farm[1].of.' for",
                     at, "--set", "lines.T1/west.sections[0].length=280")
        self.refused("--set farm[1].of.title=x: there is one platform, farm[0]", at, "--set", "farm[1].of.title=x")
        self.refused("farm.yaml:8: lines: 'T1/west' is not a valid name; a name begins with a letter or digit and has up to 100 "
                     "letters, digits, '_', '-', '+' and inner blanks; parts at the places of a farm are described in the file of "
                     "their platform", at, more="lines: {T1/west: {sections: [{type: chain, length: 280, elements: 8}]}}\n")

    def test_headings_in_radians(self):
        note = "headings of places are in degrees, and all of these are small, the first is 1.5708 deg; if radians are meant, write 90\n"
        self.write("places.csv", "0,0\n600,0,1.5708\n1200,0,3.1416\n")
        self.assertIn("farm.yaml:2: farm.file: " + note, self.hawser("{of: platform.yaml, file: places.csv}").stdout)
        self.assertIn("farm.yaml:2: farm.at: " + note, self.hawser("{of: platform.yaml, at: [[0, 0, 1.5708], [600, 0]]}").stdout)
        for headings in (("1.5708", "30"), ("3", "2"), ("0", "0")):
            result = self.hawser("{{of: platform.yaml, at: [[0, 0, {}], [600, 0, {}]]}}".format(*headings))
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertNotIn("radians", result.stdout)

    def test_two_platforms_in_one_place(self):
        farm = "[{{of: platform.yaml, at: [[0, 0], [600, 0]]}}, {{of: platform.yaml, name: U, at: [[{}, 0]]}}]"
        self.assertIn("note: farm.yaml: farm: U1 is at the place of T2, (600, 0); is it meant?\n",
                      self.hawser(farm.format(600)).stdout)
        self.assertNotIn("is it meant", self.hawser(farm.format(900)).stdout)

    def test_platforms_that_overlap(self):
        """The line of the platform ends 8 m from its origin."""
        note = "note: farm.yaml:2: farm: bodies T1/float and T2/float are 6 m apart, and lines end up to 8 m from the origin of such a body: "
        result = self.hawser("{of: platform.yaml, at: [[600, 0], [600, 6, 90], [600, 900]]}", "--quick")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout.count(note), 1, result.stdout)
        self.assertNotIn("overlap", self.hawser("{of: platform.yaml, at: [[600, 0], [600, 9]]}", "--quick").stdout)

    def test_winches(self):
        """Each place has the winch and the chain of the platform alone; their notes are joined."""
        self.write("platform.yaml", PLATFORM + LINE.format("west", 0, 8) + WINCH)
        alone = run(HAWSER, "run", "platform.yaml", "-q", "-o", "alone.h5", cwd=self.folder)
        self.assertEqual(alone.returncode, 0, alone.stderr)
        places = {"A": (0, 0, 0), "B": (700, 100, 75), "C": (0, 900, -170)}
        at = ", ".join(f"{name}: {list(place)}" for name, place in places.items())
        for ranks in (1, 2):
            result = self.hawser(f"{{of: platform.yaml, at: {{{at}}}}}", "-o", f"{ranks}.h5", command="run", ranks=ranks)
            self.assertEqual(result.returncode, 0, result.stderr)
            notes = [line for line in result.stdout.splitlines() if line.startswith("note: line") and "inside the feeder" in line]
            self.assertEqual(len(notes), 1, notes)
            self.assertIn("(and so at 2 more places, B to C)", notes[0])
            with h5py.File(self.folder / "alone.h5") as one, h5py.File(self.folder / f"{ranks}.h5") as farm:
                names = [name.decode() for name in farm["lines/name"][:]]
                self.assertEqual(names, [f"{place}/{line}" for place in places for line in ("west", "wire")])
                nodes = sum(one["lines/nodes"][:])
                for k, (name, (x, y, heading)) in enumerate(places.items()):
                    a = np.radians(heading)
                    turn = np.array([[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]])
                    expected = one["fields/position"][:] @ turn.T + [x, y, 0]
                    found = farm["fields/position"][:, k * nodes:(k + 1) * nodes]
                    self.assertLess(abs(found - expected).max(), 1e-6, name)
                    expected = one["series/wire_end_a_feed"][:]
                    found = farm[f"series/{name}_wire_end_a_feed"][:]
                    self.assertLess(abs(found - expected).max(), 1e-6 * abs(expected).max(), name)

    def test_warnings_of_equal_places(self):
        """A warning that is the same at several places but for the name is printed once, in the log and in the results."""
        for ranks in (1, 2):
            result = self.hawser("{of: platform.yaml, at: [[0, 0], [600, 0], [1200, 0]]}", command="run", ranks=ranks)
            self.assertEqual(result.returncode, 0, result.stderr)
            warnings = [line for line in result.stdout.splitlines() if "leaves the bed steeply" in line]
            self.assertEqual(len(warnings), 1, warnings)
            self.assertTrue(warnings[0].startswith("warning: line T1/west leaves"), warnings)
            self.assertTrue(warnings[0].endswith("(and so at 2 more places, T2 to T3)"), warnings)
            with h5py.File(self.folder / "farm.h5") as results:
                self.assertIn(warnings[0].encode(), [text.rstrip(b"\0") for text in results["messages"][:]])

    @unittest.skipIf("ASAN_OPTIONS" in os.environ, "the sanitizers take memory of their own")
    def test_memory_of_a_rank(self):
        """The expected memory is at most 6 % below the largest of any rank, and at most 16 % above it: the trial of `hawser check` has
        arrays of results in statics, a run on one rank has them afterwards. 200 lines need little more memory than the program; of
        400 lines with 40 elements the model is half. With HAWSER_FULL each on 1, 2 and 4 ranks."""
        full = (1, 2, 4) if os.environ.get("HAWSER_FULL") else ()
        for lines, elements, counts in ((20, 10, full or (1,)), (40, 40, full or (4,))):
            self.write("platform.yaml", PLATFORM + "".join(LINE.format(f"m{i}", 20 * i, elements) for i in range(lines)))
            farm = "{of: platform.yaml, rows: {rows: 2, columns: 5, spacing: [600, 2600]}}"
            for ranks in counts:
                checked = self.hawser(farm, "-n", ranks)
                self.assertEqual(checked.returncode, 0, checked.stderr)
                expected = 1e3 * float(re.search(r"expected memory: about ([\d.]+) GB", checked.stdout)[1])
                ahead = ("mpirun", "-q", "-n", ranks) if ranks > 1 else ()
                ran = run(*ahead, sys.executable, "-c", MEMORY, HAWSER, "run", "farm.yaml", "-q", "-o", "farm.h5", cwd=self.folder,
                          timeout=600)
                self.assertEqual(ran.returncode, 0, ran.stderr)
                files = list(self.folder.glob("*.peak"))
                peaks = [1024e-6 * int(file.read_text("utf-8")) for file in files]
                for file in files:
                    file.unlink()
                self.assertEqual(len(peaks), ranks)
                print(f"{lines * 10} lines of {elements} elements, {ranks} ranks: expected {expected:.0f} MB, largest {max(peaks):.1f} MB")
                self.assertGreater(expected / max(peaks), 0.94)
                self.assertLess(expected / max(peaks), 1.16)


if __name__ == "__main__":
    unittest.main()
