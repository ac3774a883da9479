"""tests/bench/beside_moordyn.py: a short run, with MoorDyn if HAWSER_MOORDYN names its library; files of all cases."""
import os
import sys
import tempfile
import unittest
from pathlib import Path

from support import ROOT, run

sys.path.insert(0, str(ROOT / "tests" / "bench"))
from moorings import cases  # noqa: E402

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))


class BesideMoorDyn(unittest.TestCase):
    def test_quick(self):
        library = os.environ.get("HAWSER_MOORDYN")
        result = run("tests/bench/beside_moordyn.py", HAWSER, "--quick", *(("--moordyn", library) if library else ()))
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        lines = result.stdout.splitlines()
        self.assertEqual({line.count("|") for line in lines}, {lines[0].count("|")})
        rows = [line.strip("| ").split(" | ") for line in lines[2:]]
        self.assertEqual([row[2] for row in rows], ["hawser", "MoorDyn"] if library else ["hawser"])
        deviation, peak, _ = rows[0][5].split(" / ")
        self.assertLess(max(abs(float(deviation)), abs(float(peak))), 3)
        self.assertGreater(float(rows[0][7]), 0)

    def test_cases(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, c in cases.CASES.items():
                with self.subTest(case=name):
                    file = Path(folder) / "case.yaml"
                    file.write_text(cases.hawser_file(c, c.lines, c.meshes[0], c.steps[-1], c.seconds), "utf-8")
                    result = run(HAWSER, "check", "--quick", file)
                    self.assertEqual(result.returncode, 0, result.stderr)
                    deck = cases.moordyn_file(c, c.lines, c.meshes[0], 0.01).splitlines()
                    self.assertEqual(sum(row.endswith(" -") for row in deck), sum(len(line[2]) for line in c.lines))

    def test_driver(self):
        result = run(os.environ.get("CXX", "c++"), "-std=c++20", "-Wall", "-Wextra", "-Werror", "-fsyntax-only",
                     "tests/bench/moorings/moordyn_driver.cpp", cwd=ROOT)
        self.assertEqual((result.returncode, result.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
