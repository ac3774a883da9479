"""Source files have at most 500 lines."""
import tempfile
import unittest
from pathlib import Path

from support import ROOT, write

LIMIT = 500


def too_long(root):
    """(path, lines) of every C++ file over the limit, and the number of files read."""
    found, count = [], 0
    for top in ("include", "src", "tests"):
        for path in sorted((Path(root) / top).rglob("*")):
            if path.suffix in (".hpp", ".cpp", ".py"):
                count += 1
                lines = len(path.read_text(encoding="utf-8").splitlines())
                if lines > LIMIT:
                    found.append((str(path.relative_to(root)), lines))
    return found, count


class FileLength(unittest.TestCase):
    def test_tree(self):
        found, count = too_long(ROOT)
        self.assertGreater(count, 10)
        self.assertEqual(found, [])

    def test_finds_a_long_file(self):
        with tempfile.TemporaryDirectory() as root:
            write(root, "src/io/short.cpp", "\n" * LIMIT)
            write(root, "src/io/long.cpp", "\n" * (LIMIT + 1))
            self.assertEqual(too_long(root), ([("src/io/long.cpp", LIMIT + 1)], 2))


if __name__ == "__main__":
    unittest.main()
