"""Links and names in the documentation are valid, and scripts/check-docs finds invalid ones."""
import importlib.util
import re
import unittest
from importlib.machinery import SourceFileLoader

from support import ROOT, check_trees, run

SOUND = {
    "README.md": "# Top\n[docs](docs/README.md) [out](https://example.org/x) `[code](nowhere)`\n",
    "docs/README.md": "# Index\nCode: `io/a.cpp`.\n[a](a.md#two-words) [more](more) [b](architecture.md)\n```\n[code](nowhere.md)\n```\n",
    "docs/a.md": "# A\n## Two words\n![p](p.png)\n",
    "docs/p.png": "",
    "docs/more/c.md": "# C\n[d](../how-to/d.md)\n",
    "docs/architecture.md": "# B\n`File::write`, `open_file()` in `src/io/a.cpp`, `src/io/*.cpp`, `src/io`.\n",
    "docs/how-to/d.md": "# D\n```cpp\nvoid File::write() {\n  open_file();\n```\n",
    "src/io/a.cpp": "// Layout: docs/a.md; written by io/a.cpp.\n  void File::write() {\n    open_file();\n  }\n",
}
WRONG = [
    ("README.md", "[gone](docs/gone.md)\n", "README.md:1: docs/gone.md: no such file"),
    ("README.md", "\n![gone](p.png)\n", "README.md:2: p.png: no such file"),
    ("docs/a.md", "[b](README.md#nothing)\n![p](p.png)\n", "README.md#nothing: no such heading"),
    ("src/io/b.cpp", "\n// See docs/theory/beam.md\n", "src/io/b.cpp:2: docs/theory/beam.md: no such page"),
    ("docs/a.md", "Code: `io/b.cpp`, `a.hpp`\n", "docs/a.md:1: a.hpp: no such file"),
    ("src/io/b.cpp", "int b();  // as in io/c.cpp\n", "src/io/b.cpp:1: io/c.cpp: no such file"),
    ("docs/b.md", "# lonely\n", "docs/b.md: not reachable"),
    ("docs/a.md", "Files: `src/io/b*.cpp`\n", "docs/a.md:1: src/io/b*.cpp: no such path"),
    ("docs/architecture.md", "# B\n`File::read`\n", "docs/architecture.md:2: File::read: no such name in the code"),
    ("docs/how-to/d.md", "```cpp\nvoid File::read() {\n```\n", "docs/how-to/d.md: void File::read() {: no source file"),
]


def module(path):
    """A script of the tree as a module."""
    loader = SourceFileLoader("script", str(ROOT / path))
    loaded = importlib.util.module_from_spec(importlib.util.spec_from_loader("script", loader))
    loader.exec_module(loaded)
    return loaded


class Docs(unittest.TestCase):
    def test_tree(self):
        result = run("scripts/check-docs")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_wrong_files_are_found(self):
        check_trees(self, "scripts/check-docs", SOUND, WRONG)

    def test_the_architecture_has_every_module(self):
        modules = module("scripts/check-includes").MODULES
        page = (ROOT / "docs/architecture.md").read_text(encoding="utf-8")
        table = page.partition("## Modules")[2].partition("\n## ")[0]
        self.assertEqual(re.findall(r"^\| (\w+) \|", table, re.M)[1:], modules)
        picture = module("docs/architecture/architecture.py")
        self.assertEqual(sorted(picture.MODULES), sorted(modules))
        self.assertIn(", ".join(modules), (ROOT / "docs/architecture/architecture.py").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
