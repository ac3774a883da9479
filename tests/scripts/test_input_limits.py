"""Endless or oversized input is refused before it is read: one sentence with the file, exit code 2, in little memory
and time."""
import os
import resource
import subprocess
import tempfile
import unittest
from pathlib import Path

from support import ROOT

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
CASE = """hawser: 1
environment: {seabed: {grid: {file: BED}}}
line_types: {rope: {outer_diameter: 0.2, mass_per_length: 50, EA: 1e8, EI: 1e4, GJ: 1e4}}
bodies: {barge: {motion: {table: {file: MOTION}}}}
volumes: {deck: {mesh: MESH, body: barge}}
lines:
  rope:
    sections: [{type: rope, length: 100, elements: 10}]
    end_a: {body: barge, at: [0, 0, 0]}
    end_b: {anchor: [60, 0, -60]}
dynamics: {duration: 10}
"""
MOST = 1_500_000_000  # bytes of memory; the program maps a third of it


def limited():
    if "ASAN_OPTIONS" not in os.environ:  # the sanitizer maps all memory
        resource.setrlimit(resource.RLIMIT_AS, (MOST, MOST))


class Limits(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        os.mkfifo(self.folder / "pipe")
        for name in ("sparse.stl", "sparse.obj", "sparse.ply", "sparse.txt", "sparse.yaml"):
            os.truncate(os.open(self.folder / name, os.O_CREAT | os.O_WRONLY), 50_000_000_000)

    def refused(self, file, output):
        result = subprocess.run(
            [HAWSER, "check", str(file)], capture_output=True, text=True, check=False, timeout=300, cwd=self.folder, preexec_fn=limited
        )
        self.assertEqual(result.returncode, 2, result.stderr[-500:])
        self.assertRegex(result.stderr, r"\Ahawser: [^\n]+\n\Z")
        self.assertIn(output, result.stderr)

    def test_cases(self):
        for file, output in (
            ("/dev/zero", "/dev/zero: is a device or a pipe, not a case file"),
            ("pipe", "pipe: is a device or a pipe, not a case file"),
            ("sparse.yaml", "sparse.yaml: has 5e+04 MB, and a case file has 16 MB at most"),
        ):
            with self.subTest(file=file):
                self.refused(file, output)

    def test_files_of_a_case(self):
        table = "and a table file has 500 MB at most"
        sound = {"BED": "bed.xyz", "MOTION": "motion.txt", "MESH": "box.obj"}
        (self.folder / "bed.xyz").write_text("-99 -99 -99\n99 -99 -99\n-99 99 -99\n99 99 -99\n")
        (self.folder / "motion.txt").write_text("0 0 0 0\n5 0 0 0\n10 0 0 0\n")
        for word, file, output in (
            ("BED", "/dev/zero", "environment.seabed.grid.file: /dev/zero: is a device or a pipe, not a table file"),
            ("BED", "sparse.txt", table),
            ("MOTION", "pipe", "is a device or a pipe, not a table file"),
            ("MOTION", "sparse.txt", table),
            ("MESH", "/dev/zero", "volumes.deck.mesh: /dev/zero: is a device or a pipe, not a mesh file"),
            ("MESH", "sparse.stl", "sparse.stl: has 5e+04 MB, and a mesh file has 1000 MB at most"),
            ("MESH", "sparse.obj", "sparse.obj: has 5e+04 MB"),
            ("MESH", "sparse.ply", "sparse.ply: has 5e+04 MB"),
        ):
            with self.subTest(word=word, file=file):
                text = CASE
                for name, path in {**sound, word: file}.items():
                    text = text.replace(name, path)
                (self.folder / "case.yaml").write_text(text)
                self.refused("case.yaml", output)

    def test_yaml_that_swells(self):
        anchors = "".join(f"&a{i} [" for i in range(35))
        for name, text, output in (
            ("brackets", "hawser: 1\ntitle: " + "[" * 3_900_000, "is nested too deeply"),
            ("anchors", f"title: {anchors}{'a,' * 900_000}{']' * 35}\n", "has too many entries"),
            ("aliases", f"a: &a [{'x,' * 1000}]\nb: [{'*a ,' * 900_000}]\n", "has too many entries"),
        ):
            with self.subTest(text=name):
                (self.folder / "case.yaml").write_text(text)
                self.refused("case.yaml", output)


if __name__ == "__main__":
    unittest.main()
