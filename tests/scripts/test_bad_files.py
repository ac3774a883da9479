"""Invalid case files through the whole program: one sentence on stderr, exit code 2, no output files.

tests/unit/case_bad_files.cpp tests the sentences without the program. This test uses every sixth file; all of them with
HAWSER_FULL in the environment.
"""
import os
import shutil
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from support import ROOT, run

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
BAD = ROOT / "tests/data/bad"


class BadFiles(unittest.TestCase):
    def test_one_sentence_and_nothing_written(self):
        folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        shutil.copytree(BAD, folder / "bad")
        for file in BAD.parent.glob("hemisphere.*"):
            shutil.copy(file, folder)
        files = sorted((folder / "bad").glob("*.yaml"))
        self.assertGreaterEqual(len(files), 100)
        files = files[:: 1 if os.environ.get("HAWSER_FULL") else 6]
        before = sorted(folder.rglob("*"))
        with ThreadPoolExecutor(2) as pool:
            results = list(pool.map(lambda file: run(HAWSER, "run", file, cwd=folder, timeout=300), files))
        for file, result in zip(files, results):
            with self.subTest(file=file.name):
                self.assertEqual(result.returncode, 2, result.stderr)
                self.assertRegex(result.stderr, r"\Ahawser: [^\n]*\b" + file.name.replace(".", r"\.") + r":\d+: [^\n]+\n\Z")
                # Readable cases have printed their title or name before.
                self.assertRegex(result.stdout, r"\A([^\n]+\n)?\Z")
                expected = file.read_text("utf-8").splitlines()[0].removeprefix("# expect: ")
                self.assertIn(expected, result.stderr.replace(f"{folder / 'bad'}/", ""))
        self.assertEqual(sorted(folder.rglob("*")), before, "something was written")

    def test_meshes_on_several_ranks(self):
        """One rank reads them, and all get the error."""
        for name in ("mesh_absent", "mesh_open", "sign_open", "part_unknown", "bed_no_sheet", "bed_huge"):
            with self.subTest(file=name):
                file = BAD / f"{name}.yaml"
                result = run("mpirun", "-q", "-n", 2, HAWSER, "run", file, timeout=300)
                self.assertEqual(result.returncode, 2, result.stderr)
                sentences = [line for line in result.stderr.splitlines() if line.startswith("hawser: ")]
                self.assertEqual(len(sentences), 1, result.stderr)
                expected = file.read_text("utf-8").splitlines()[0].removeprefix("# expect: ")
                self.assertIn(expected, sentences[0].replace(f"{BAD}/", ""))


if __name__ == "__main__":
    unittest.main()
