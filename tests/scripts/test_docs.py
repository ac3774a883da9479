"""Links in the documentation lead somewhere, and scripts/check-docs finds those that do not."""
import unittest

from support import check_trees, run

SOUND = {
    "README.md": "# Top\n[docs](docs/README.md) [out](https://example.org/x) `[code](nowhere)`\n",
    "docs/README.md": "# Index\nCode: `io/a.cpp`.\n[a](a.md#two-words) [more](more)\n```\n[code](nowhere.md)\n```\n",
    "docs/a.md": "# A\n## Two words\n![p](p.png)\n",
    "docs/p.png": "",
    "docs/more/c.md": "# C\n",
    "src/io/a.cpp": "// Layout: docs/a.md; written by io/a.cpp.\n",
}
WRONG = [
    ("README.md", "[gone](docs/gone.md)\n", "README.md:1: docs/gone.md: no such file"),
    ("README.md", "\n![gone](p.png)\n", "README.md:2: p.png: no such file"),
    ("docs/a.md", "[b](README.md#nothing)\n![p](p.png)\n", "README.md#nothing: no such heading"),
    ("src/io/b.cpp", "\n// See docs/theory/beam.md\n", "src/io/b.cpp:2: docs/theory/beam.md: no such page"),
    ("docs/a.md", "Code: `io/b.cpp`, `a.hpp`\n", "docs/a.md:1: a.hpp: no such file"),
    ("src/io/b.cpp", "int b();  // as in io/c.cpp\n", "src/io/b.cpp:1: io/c.cpp: no such file"),
    ("docs/b.md", "# lonely\n", "docs/b.md: not reachable"),
]


class Docs(unittest.TestCase):
    def test_tree(self):
        result = run("scripts/check-docs")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_wrong_files_are_found(self):
        check_trees(self, "scripts/check-docs", SOUND, WRONG)


if __name__ == "__main__":
    unittest.main()
