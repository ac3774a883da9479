"""The manual page and the bash completion have every command and option of the program."""
import gzip
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from support import ROOT, run

sys.path.insert(0, str(ROOT / "scripts"))
import manual  # noqa: E402

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))

# The two forms of help with difficult parts: long terms, continued lines, dots and dashes at the start.
CLI11 = """Run a case: statics, then dynamics.
Usage: /some/where/hawser run [OPTIONS] case

Positionals:
  case TEXT REQUIRED          Case file

Options:
  -h,--help                   Print this help message and exit
  --a-very-long-option-indeed TEXT
                              What stands
                              in two lines

Options of PETSc follow a lone --:
  hawser run case.yaml -- -log_view
"""
ARGPARSE = """usage: hawser plot [-h] [-o OUTPUT] [--curve {A,B1}] results {range,history}

positional arguments:
  results               results file
  {range,history}

options:
  -h, --help            show this help message and exit
  -o OUTPUT, --output OUTPUT
                        .png, .svg or .pdf
  --curve {A,B1}
"""


class Parsing(unittest.TestCase):
    def test_both_forms_of_help(self):
        one, two = manual.parse(CLI11), manual.parse(ARGPARSE)
        self.assertEqual(one.about, ["Run a case: statics, then dynamics."])
        self.assertEqual(two.entries(False), [("results", "results file"), ("{range,history}", "")])
        self.assertEqual(one.entries(False), [("case TEXT REQUIRED", "Case file")])
        self.assertEqual(one.entries(True)[1], ("--a-very-long-option-indeed TEXT", "What stands in two lines"))
        self.assertEqual(one.notes, ["Options of PETSc follow a lone --:", "  hawser run case.yaml -- -log_view"])
        self.assertEqual(manual.options_of(one), ["-h", "--help", "--a-very-long-option-indeed"])
        self.assertEqual(two.entries(True)[1], ("-o OUTPUT, --output OUTPUT", ".png, .svg or .pdf"))
        self.assertEqual(manual.options_of(two), ["-h", "--help", "-o", "--output", "--curve"])
        self.assertEqual(manual.choices_of(two), {"--curve": "A B1", "": "range history"})

    def test_nothing_of_the_text_is_taken_for_a_request(self):
        self.assertEqual(manual.roff(".png and -o\\n"), "\\&.png and \\-o\\en")
        self.assertEqual(manual.roff("{a,b}, c"), "{a,\\:b}, c")


class Made(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.page, cls.completion = (Path(cls.folder.name) / name for name in ("hawser.1.gz", "completion"))
        cls.helps = {word: helps for word, _, helps in manual.make(HAWSER, cls.page, cls.completion)[1]}
        cls.commands = set(cls.helps)

    def words(self, *line):
        """Completions of bash for the last word."""
        script = (f". '{self.completion}'; COMP_WORDS=(hawser {' '.join(map(repr, line))}); COMP_CWORD={len(line)}; "
                  "_hawser; printf '%s\\n' \"${COMPREPLY[@]}\"")
        return run("bash", "-c", script, cwd=self.folder.name).stdout.split()

    def test_the_page_has_all(self):
        text = gzip.decompress(self.page.read_bytes()).decode()
        self.assertEqual(self.page.read_bytes()[4:8], b"\0\0\0\0", "a time in it would make each build another")
        self.assertIn(".SH NAME\nhawser \\- ", text)
        self.assertTrue({"run", "check", "report", "plot"} <= self.commands)
        for command, helps in self.helps.items():
            self.assertIn(f".SS hawser {command}\n", text)
            for option in manual.options_of(helps):
                self.assertIn(manual.roff(option), text, command)
        self.assertEqual(text.count("Exit codes"), 1)
        self.assertNotIn(str(Path(HAWSER).parent), text)
        if shutil.which("man"):
            shown = subprocess.run(["man", "--warnings", "-P", "cat", "-l", self.page], capture_output=True, text=True,
                                   check=True, env={**os.environ, "MANWIDTH": "80", "LC_ALL": "C.UTF-8"})
            self.assertEqual(shown.stderr, "")
            self.assertIn("mpirun", shown.stdout)

    def test_completion(self):
        (Path(self.folder.name) / "a.yaml").touch()
        (Path(self.folder.name) / "a.txt").touch()
        self.assertTrue(self.commands <= set(self.words("")))
        self.assertEqual(self.words("mo"), ["modes"])
        self.assertEqual(self.words("run", "a"), ["a.yaml"])
        self.assertEqual(self.words("run", "a.yaml", "--rest"), ["--restart"])
        self.assertEqual(self.words("plot", "a.h5", "ran"), ["range"])
        self.assertEqual(self.words("fatigue", "a.h5", "--curve", "no-such-curve"), [])
        self.assertGreater(len(self.words("fatigue", "a.h5", "--curve", "")), 1)
        self.assertEqual(self.words("no-such-command", ""), [])


if __name__ == "__main__":
    unittest.main()
