"""Commands of the tutorial and the how-to pages print what the pages show.

A block ```console of a page holds commands (`$ `, continued by `> `) and their output. Lines and the ends of lines (`
...`) may be omitted; the rest must occur in this order. Words must be equal, numbers agree to 1 %. All commands of a
page are run in one copy of docs/tutorial.
"""
import os
import re
import shutil
import tempfile
import unittest
from pathlib import Path

from support import ROOT, run

HAWSER = Path(os.environ.get("HAWSER", ROOT / "build/hawser"))
LONG = set() if os.environ.get("HAWSER_FULL") else {"responses.md"}  # runs of half an hour of motion
PAGES = [page for folder in ("tutorial", "how-to") for page in sorted((ROOT / "docs" / folder).glob("*.md")) if page.name not in LONG]
BLOCK = re.compile(r"^```console\n(.*?)^```$", re.M | re.S)
TOLERANCE = 0.01


def steps(text):
    """(command, expected lines) of every block of a page, in order."""
    for block in BLOCK.findall(text):
        command, expected = None, []
        for line in block.splitlines():
            if line.startswith("$ "):
                if command:
                    yield command, expected
                command, expected = line[2:], []
            elif line.startswith("> ") or line == ">":
                command += "\n" + line[2:]
            elif line.strip() not in ("", "..."):
                expected.append(line)
        if command:
            yield command, expected


def number(word):
    try:
        return float(word)
    except ValueError:
        return None


def agree(expected, printed):
    """True if two lines have the same words, and numbers that agree."""
    expected, printed = (re.split(r"[\s,;:()]+", line.strip()) for line in (expected, printed))
    if expected[-1] == "...":
        expected, printed = expected[:-1], printed[:len(expected) - 1]
    if len(expected) != len(printed):
        return False
    for a, b in zip(expected, printed):
        x, y = number(a), number(b)
        if x is None or y is None:
            if a != b:
                return False
        elif abs(x - y) > TOLERANCE * max(abs(x), abs(y)) and abs(x - y) > 1e-9:
            return False
    return True


def first_missing(expected, printed):
    """First of the expected lines that does not follow its predecessor in the output, or None."""
    printed = iter(printed)
    for line in expected:
        if not any(agree(line, other) for other in printed):
            return line
    return None


class Tutorial(unittest.TestCase):
    def test_pages(self):
        environment = dict(os.environ, PATH=f"{HAWSER.parent}:{os.environ['PATH']}", HAWSER=str(HAWSER))
        count = 0
        for page in PAGES:
            with tempfile.TemporaryDirectory() as root:
                here = Path(root) / "docs/tutorial"
                here.mkdir(parents=True)
                for file in [*(ROOT / "docs/tutorial").glob("*.yaml"), *(ROOT / "docs/tutorial").glob("spar.*")]:
                    shutil.copy(file, here)
                (Path(root) / "cases").symlink_to(ROOT / "cases")
                for command, expected in steps(page.read_text(encoding="utf-8")):
                    count += 1
                    with self.subTest(page=page.name, command=command):
                        result = run("bash", "-c", command, cwd=here, env=environment, timeout=600)
                        printed = (result.stdout + result.stderr).splitlines()
                        missing = first_missing(expected, printed)
                        self.assertIsNone(missing, "the page shows a line that is not printed:\n" +
                                          f"{missing}\nprinted:\n" + "\n".join(printed))
                        if "$?" not in command and not any(line.startswith("hawser: ") for line in expected):
                            self.assertEqual(result.returncode, 0, result.stderr)
        self.assertGreater(count, 20)

    def test_excerpts(self):
        """Every line of a ```yaml block of the tutorial is in one of its case files."""
        bare = lambda line: " ".join(line.split("#")[0].split())
        cases = {bare(line) for case in (ROOT / "docs/tutorial").glob("*.yaml")
                 for line in case.read_text(encoding="utf-8").splitlines()}
        for page in sorted((ROOT / "docs/tutorial").glob("*.md")):
            for block in re.findall(r"^```yaml\n(.*?)^```$", page.read_text(encoding="utf-8"), re.M | re.S):
                for line in block.splitlines():
                    if line != "...":
                        self.assertIn(bare(line), cases | {""}, f"{page.name}: in no case file of the tutorial")

    def test_numbers_and_words_that_differ_are_found(self):
        printed = ["max effective tension    mooring    541573 N   0.000  0.000", "lines: 1 (100 elements)"]
        self.assertIsNone(first_missing(["max effective tension mooring 541000 N 0.000 0.000"], printed))
        self.assertIsNone(first_missing(["max effective tension mooring 541000 N ..."], printed))
        for wrong in ("max effective tension mooring 530000 N ...",
                      "max effective tension mooring 530000 N 0.000 0.000", "max wall tension mooring 541573 N 0 0",
                      "max effective tension mooring 541573 N 0.000", "lines: 2 (100 elements)"):
            self.assertEqual(first_missing([wrong], printed), wrong)
        self.assertIsNotNone(first_missing(list(reversed(printed)), printed))  # in another order


if __name__ == "__main__":
    unittest.main()
