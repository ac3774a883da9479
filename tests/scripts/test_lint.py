"""scripts/lint finds a dangling reference and passes a correct file. Only with HAWSER_FULL, because clang-tidy is
slow."""
import os
import shutil
import tempfile
import unittest
from pathlib import Path

from support import run

SOUND = "#include <utility>\nint first(int a, int b) { return std::pair<int, int>(a, b).first; }\n"
FAULTS = {
    "a reference to a local": "const int& gone() {\n  int x = 1;\n  return x;\n}\n",
    "used after it was moved": (
        "#include <string>\n#include <utility>\nstd::size_t moved(std::string a) {\n"
        "  std::string b = std::move(a);\n  return a.size() + b.size();\n}\n"
    ),
    "a null pointer": "int null(bool b) {\n  int x = 1, *p = b ? &x : nullptr;\n  if (!b) return *p;\n  return x;\n}\n",
}


@unittest.skipUnless(os.environ.get("HAWSER_FULL") and shutil.which("clang-tidy"), "takes a minute")
class Lint(unittest.TestCase):
    def test_faults_are_found(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "file.cpp"
            file.write_text(SOUND)
            result = run("scripts/lint", file)
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
            for name, text in FAULTS.items():
                with self.subTest(fault=name):
                    file.write_text(text)
                    result = run("scripts/lint", file)
                    self.assertNotEqual(result.returncode, 0, result.stdout + result.stderr)


if __name__ == "__main__":
    unittest.main()
