"""hawser compare reports the differences of two results; hawser new writes valid case files."""
import contextlib
import io
import os
import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

from support import ROOT, run
from synthetic import results_file

sys.path.insert(0, str(ROOT / "scripts"))
from hawser_post import __main__ as post  # noqa: E402
from hawser_post import compare_tables, new, new_case  # noqa: E402
from hawser_post.results import Results  # noqa: E402

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))


def two(folder):
    """B's line is 2 m farther at its end B, has 10 % more tension, and its case another length; A has an additional
    line."""
    t, s = np.linspace(0, 10, 6), np.linspace(0, 20, 5)
    made = []
    for name, more, lines in (("a", 0.0, {"mooring": s, "spare": s}), ("b", 0.1, {"mooring": s})):
        nodes = 5 * len(lines)
        x = np.zeros((6, nodes, 3))
        x[:, :, 0] = np.tile(s, len(lines))
        x[:, 4, 2] = 20 * more
        tension = np.full((6, nodes), 1000.0) * (1 + more) + t[:, None]
        series = (np.linspace(0, 10, 30), {"fairlead": (["effective_tension"], ["N"], (1 + more) * np.sin(np.linspace(0, 10, 30))[:, None])})
        path = results_file(Path(folder) / f"{name}.h5", t, lines, {"position": ("m", x), "effective_tension": ("N", tension)}, series,
                            case=f"hawser: 1\ntitle: two\nlines: {{mooring: {{length: '{100 + 10 * more:g}'}}}}\n")
        made.append(Results(path))
    return made


class Compare(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.a, self.b = two(self.folder)

    def test_tables_have_the_differences(self):
        self.assertEqual(compare_tables.inputs(self.a, self.b)[1], [["lines.mooring.length", "100", "101"]])
        row = compare_tables.ends(self.a, self.b, 0, "start")[1][0]
        self.assertEqual((row[0], row[1]), ("mooring", "tension at end A, start [kN]"))
        np.testing.assert_allclose(row[2:5], [1.0, 1.1, 0.1])
        self.assertEqual(row[5], "+10.00")
        self.assertEqual(compare_tables.places(self.a, self.b)[1], [["mooring", 2.0, 20.0, 2.0, 20.0]])
        self.assertEqual([row[1] for row in compare_tables.histories(self.a, self.b)[1]],
                         [f"{word} effective tension [kN]" for word in ("least", "mean", "largest")])
        self.assertEqual(compare_tables.only(self.a, self.b), ["Only A has the line spare."])

    def test_nothing_differs_from_itself(self):
        self.assertEqual(compare_tables.inputs(self.a, self.a)[1], [])
        self.assertEqual(compare_tables.histories(self.a, self.a)[1], [])
        self.assertTrue(all(row[4] == 0 for row in compare_tables.extremes(self.a, self.a)[1]))

    def test_the_page_has_both_models_and_does_not_overwrite_what_it_read(self):
        out = io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
            self.assertEqual(post.main(["compare", str(self.a.path), str(self.b.path), "-o", str(self.folder / "c.html")]) or 0, 0, out.getvalue())
            for target, words in ((self.a.path, "is a .html or .htm file"), (self.folder / "c.txt", "is a .html or .htm file")):
                self.assertEqual(post.main(["compare", str(self.a.path), str(self.b.path), "-o", str(target)]), 2)
                self.assertIn(words, out.getvalue())
        with mock.patch.object(Results, "messages", lambda self: ["warning: too short", "note: no matter"]), contextlib.redirect_stdout(out):
            post.main(["compare", str(self.a.path), str(self.b.path), "-o", str(self.folder / "warned.html")])
        warned = (self.folder / "warned.html").read_text(encoding="utf-8")
        for words in ("A: warning: too short", "B: warning: too short"):
            self.assertIn(words, warned)
        self.assertNotIn("B: note", warned)
        page = (self.folder / "c.html").read_text(encoding="utf-8")
        for words in ("lines.mooring.length", "Only A has the line spare.", "A, largest", 'data-others="other"', 'data-of="other"'):
            self.assertIn(words, page)


class New(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        for name, value in (("HAWSER", HAWSER),):
            before = os.environ.get(name)
            os.environ[name] = value
            self.addCleanup(lambda n=name, b=before: os.environ.pop(n) if b is None else os.environ.update({n: b}))

    def talk(self, *answers, file=None):
        """Exit code and output."""
        out = io.StringIO()
        with mock.patch.object(sys, "stdin", io.StringIO("".join(f"{a}\n" for a in answers))), contextlib.redirect_stdout(out), \
                contextlib.redirect_stderr(out):
            code = post.main(["new", *([str(file)] if file else [])]) or 0
        return code, out.getvalue()

    def test_usual_answers_of_every_kind_make_a_case_that_runs_without_notes(self):
        for depth in (5, 30, 100, 1500) if os.environ.get("HAWSER_FULL") else (30,):
            for kind in new_case.KINDS:
                with self.subTest(kind=kind, depth=depth):
                    file = self.folder / f"{kind}-{depth}.yaml"
                    code, output = self.talk(depth, kind, *[""] * 12, file=file)
                    self.assertEqual(code, 0, output)
                    self.assertIn(f"case: {file}", output)
                    ran = run(HAWSER, "run", file, cwd=self.folder)
                    self.assertEqual(ran.returncode, 0, ran.stderr)
                    self.assertIsNone(re.search("warning|note", ran.stdout + ran.stderr), ran.stdout)

    def test_the_kinds_are_those_of_the_library(self):
        library = run(HAWSER, "library").stdout
        self.assertEqual({kind for _, kind in new_case.KINDS.values()} - {""}, set(re.findall(r"(?m)^\| `([\w-]+)` \|", library)) - {"library"})

    def test_still_water_a_fixed_end_and_a_title_with_quotes(self):
        file = self.folder / "still"
        code, output = self.talk(1200, "polyester", "200 mm", 30, "", "", 0, "no", 'a "taut" leg: 1', "no", file=file)
        self.assertEqual(code, 0, output)
        text = file.with_suffix(".yaml").read_text(encoding="utf-8")
        self.assertIn("water: {depth: 1200}", text)
        self.assertIn("diameter: 0.2}", text)
        self.assertNotIn("dynamics", text)
        self.assertNotIn("waves", text)
        run_of = run(HAWSER, "run", "-q", file.with_suffix(".yaml"), cwd=self.folder)
        self.assertEqual(run_of.returncode, 0, run_of.stderr)
        self.assertEqual(Results(self.folder / "still.h5").as_read["given"]["title"], 'a "taut" leg: 1')

    def test_wrong_answers_are_asked_again_with_the_reason(self):
        file = self.folder / "again.yaml"
        code, output = self.talk("deep", "-5", "100", "chian", "chain", "84 furlongs", "84 mm", "R9", "R4", "", "1 m", "", "", 0, "perhaps", "no", "", "no",
                               file=file)
        self.assertEqual(code, 0, output)
        for words in ("'deep' is not a number", "-5 m is not between 5 and 12000 m", "did you mean 'chain'?", "'84 furlongs' is not a number",
                      "'R9' is none of", "1 m is not between", "'perhaps' is neither yes nor no"):
            self.assertIn(words, output)

    def test_what_shallow_water_allows(self):
        code, output = self.talk(3, 8, "pipe", "273 mm", "70 mm", "", "", "", "", 7, *[""] * 7, file=self.folder / "shallow.yaml")
        self.assertEqual(code, 0, output)
        for words in ("3 m is not between 5 and 12000 m", "up to 80 mm in this water", "0.273 m is not between 0.005 and 0.08 m", "7 m is not between 0 and 6.24 m"):
            self.assertIn(words, output)

    def test_no_file_is_written_over_nor_half_a_one(self):
        file = self.folder / "there.yaml"
        file.write_text("mine", encoding="utf-8")
        code, output = self.talk(file=file)
        self.assertEqual((code, file.read_text(encoding="utf-8")), (2, "mine"))
        self.assertIn("exists already", output)
        code, output = self.talk("", "pipe", file=self.folder / "half.yaml")
        self.assertEqual((code, (self.folder / "half.yaml").exists()), (2, False))
        self.assertIn("the dialogue has ended before its last question", output)

    def test_numbers_with_units(self):
        read = new.number(0, 1e6)
        np.testing.assert_allclose([read(text) for text in ("120", "84 mm", "1.5km", "12 in", "1e2")], [120, 0.084, 1500, 0.3048, 100])
        for text in ("", "m", "12 parsec", "1..2"):
            with self.assertRaises(ValueError):
                read(text)


if __name__ == "__main__":
    unittest.main()
