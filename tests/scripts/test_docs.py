"""Links in the documentation lead somewhere, and scripts/check-docs finds those that do not."""
import tempfile
import unittest

from support import run, write

SOUND = {
    "README.md": "# Top\n[docs](docs/README.md) [out](https://example.org/x) `[code](nowhere)`\n",
    "docs/README.md": "# Index\n[a](a.md#two-words) [more](more)\n```\n[code](nowhere.md)\n```\n",
    "docs/a.md": "# A\n## Two words\n![p](p.png)\n",
    "docs/p.png": "",
    "docs/more/c.md": "# C\n",
    "src/io/a.cpp": "// Layout: docs/a.md.\n",
}
WRONG = [
    ("README.md", "[gone](docs/gone.md)\n", "README.md:1: docs/gone.md: no such file"),
    ("README.md", "\n![gone](p.png)\n", "README.md:2: p.png: no such file"),
    ("docs/a.md", "[b](README.md#nothing)\n![p](p.png)\n", "README.md#nothing: no such heading"),
    ("src/io/b.cpp", "\n// See docs/theory/beam.md\n", "src/io/b.cpp:2: docs/theory/beam.md: no such page"),
    ("docs/b.md", "# lonely\n", "docs/b.md: not reachable"),
]


class Docs(unittest.TestCase):
    def test_tree(self):
        result = run("scripts/check-docs")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_sound_tree_passes(self):
        with tempfile.TemporaryDirectory() as root:
            for path, text in SOUND.items():
                write(root, path, text)
            result = run("scripts/check-docs", root)
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_wrong_trees_fail(self):
        for path, text, complaint in WRONG:
            with self.subTest(path=path, text=text), tempfile.TemporaryDirectory() as root:
                for sound, content in SOUND.items():
                    write(root, sound, content)
                write(root, path, text)
                result = run("scripts/check-docs", root)
                self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
                self.assertIn(complaint, result.stdout)


if __name__ == "__main__":
    unittest.main()
