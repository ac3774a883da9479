"""Common parts of the tests of scripts: location of the tree, and execution of its scripts."""
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent


def run(*command, **options):
    """Completed process of a command with captured text output; scripts of the tree are named by their relative
    path."""
    first = ROOT / command[0]
    words = [str(first) if first.exists() else command[0], *map(str, command[1:])]
    return subprocess.run(words, capture_output=True, text=True, check=False, **options)


def write(root, path, text):
    """Writes a file of an artificial tree."""
    file = Path(root) / path
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8")


def check_trees(test, script, sound, wrong):
    """Checks that `script` passes the tree `sound` {path: text} and complains of each file of `wrong` [(path, text,
    complaint)] added to it."""
    with tempfile.TemporaryDirectory() as root:
        for path, text in sound.items():
            write(root, path, text)
        result = run(script, root)
        test.assertEqual(result.returncode, 0, result.stdout + result.stderr)
    for path, text, complaint in wrong:
        with test.subTest(path=path, text=text), tempfile.TemporaryDirectory() as root:
            for name, content in sound.items():
                write(root, name, content)
            write(root, path, text)
            result = run(script, root)
            test.assertEqual(result.returncode, 1, result.stdout + result.stderr)
            test.assertIn(complaint, result.stdout)


if __name__ == "__main__":
    sys.exit("not a test")
