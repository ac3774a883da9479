"""Names, comments, messages and pages use the terms of the field: scripts/check-words finds the words of the table
"Words"."""
import tempfile
import unittest

from support import check_trees, run, write

TABLE = """# Contributing
## Words
| not used | used | where | stays in |
|---|---|---|---|
| mouth, mouths | feed point | everywhere | `mouth_length` |
| left out | excluded | everywhere | |
| anew | again | in names | |
| gives | derivative | as a name | |
## Tests
"""
SOUND = {
    "CONTRIBUTING.md": TABLE,
    "src/io/a.cpp": '// Left, out: made anew; gives a length.\nconst char* name = "mouth_length";\nint gives_length = 0;\n',
    "docs/a.md": "What is left is out. A page gives `mouth_length` anew.\n",
    "scripts/a.py": '"""It gives what is made anew."""\n',
}
WRONG = [
    ("docs/a.md", "\nThe Mouth of a feeder.\n", "docs/a.md:2: 'mouth': feed point"),
    ("src/io/a.cpp", "int at_mouth = 0;\n", "src/io/a.cpp:1: 'mouth': feed point"),
    ("src/io/a.cpp", "struct AtMouths {};\n", "src/io/a.cpp:1: 'mouths': feed point"),
    ("src/io/a.cpp", 'const char* text = "at its mouth";\n', "src/io/a.cpp:1: 'mouth': feed point"),
    ("src/io/a.cpp", "// What is left\n// out.\n", "src/io/a.cpp:1: 'left out': excluded"),
    ("src/io/a.cpp", "bool left_out = false;\n", "src/io/a.cpp:1: 'left out': excluded"),
    ("src/io/a.cpp", "void make_anew();\n", "src/io/a.cpp:1: 'anew': again"),
    ("src/io/a.cpp", "double gives = 0;\n", "src/io/a.cpp:1: 'gives': derivative"),
    ("scripts/a.py", "def begin_anew():\n    pass\n", "scripts/a.py:1: 'anew': again"),
    ("cases/a/a.yaml", "lines:  # at the mouth\n", "cases/a/a.yaml:1: 'mouth': feed point"),
    ("src/io/mouth.cpp", "int b = 0;\n", "src/io/mouth.cpp: 'mouth' in the file's name: feed point"),
    ("README.md", "# It was left out\n", "README.md:1: 'left out': excluded"),
    ("CONTRIBUTING.md", TABLE + "What the mouth is.\n", "CONTRIBUTING.md:10: 'mouth': feed point"),
]


class Words(unittest.TestCase):
    def test_tree(self):
        result = run("scripts/check-words")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_wrong_words_are_found(self):
        check_trees(self, "scripts/check-words", SOUND, WRONG)

    def test_folders_and_tables(self):
        with tempfile.TemporaryDirectory() as root:
            write(root, "CONTRIBUTING.md", TABLE)
            write(root, "docs/a.md", "At the mouth.\n")
            self.assertEqual(run("scripts/check-words", root).returncode, 1)
            self.assertEqual(run("scripts/check-words", "--without", "docs", root).returncode, 0)
            for text, fault in (("# Contributing\n", "has no section 'Words'"), ("## Words\n", "is empty"),
                                ("## Words\n| a | b | nowhere | |\n", "CONTRIBUTING.md:2: 'nowhere' is none of")):
                write(root, "CONTRIBUTING.md", text)
                result = run("scripts/check-words", root)
                self.assertEqual(result.returncode, 1)
                self.assertIn(fault, result.stderr)


if __name__ == "__main__":
    unittest.main()
