"""The folder of `cmake --install` works after being moved: program, Python tools and cases; manual page and
completion are at the standard places. Program, CMake and Debian's changelog have the same version."""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import urllib.request
from pathlib import Path

from support import ROOT, run

sys.path.insert(0, str(ROOT / "scripts"))
from hawser_post.viewer import libraries  # noqa: E402

HAWSER = Path(os.environ.get("HAWSER", ROOT / "build/hawser"))
BUILD = HAWSER.parent


@unittest.skipUnless((BUILD / "cmake_install.cmake").is_file(), "the program is in no folder of a build")
class Install(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        first, cls.prefix = Path(cls.folder.name) / "first", Path(cls.folder.name) / "second place"
        done = run(shutil.which("cmake"), "--install", BUILD, "--prefix", first)
        if done.returncode != 0:
            raise AssertionError(done.stdout + done.stderr)
        first.rename(cls.prefix)

    def hawser(self, *words):
        # Neither the sources nor the environment are available.
        env = {k: v for k, v in os.environ.items() if not k.startswith(("HAWSER", "PYTHON"))}
        done = run(self.prefix / "bin/hawser", *words, cwd=self.folder.name, env=env)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def test_files_are_at_the_standard_places(self):
        for path in ("bin/hawser", "share/man/man1/hawser.1.gz", "share/bash-completion/completions/hawser",
                     "share/doc/hawser/README.md", "share/doc/hawser/LICENSE", "share/doc/hawser/docs/case.schema.json",
                     "share/hawser/line-types.yaml", "share/hawser/cases/reel/reel.yaml",
                     "share/hawser/python/hawser_post"):
            self.assertTrue((self.prefix / path).exists(), path)
        stray = [p for p in self.prefix.rglob("*") if p.suffix in (".h5", ".xdmf", ".pyc") or p.is_symlink()]
        self.assertEqual(stray, [])

    def test_a_case_runs_and_is_evaluated_where_it_was_moved_to(self):
        case = Path(self.folder.name) / "hanging-line"
        shutil.copytree(self.prefix / "share/hawser/cases/hanging-line", case)
        self.hawser("run", case / "hanging-line.yaml", "-q")
        self.hawser("plot", case / "hanging-line.h5", "range", "-o", case / "range.svg")
        self.assertIn("<svg", (case / "range.svg").read_text(encoding="utf-8"))
        tables = self.hawser("export", case / "hanging-line.h5").split()
        self.assertTrue(any(Path(t).is_file() for t in tables), tables)

    @unittest.skipIf(libraries.missing(), libraries.missing())
    def test_its_model_is_shown_to_a_browser(self):
        env = {k: v for k, v in os.environ.items() if not k.startswith(("HAWSER", "PYTHON"))}
        case = self.prefix / "share/hawser/cases/hanging-line/hanging-line.yaml"
        with subprocess.Popen([self.prefix / "bin/hawser", "view", case, "--no-browser"], env={**env, "PYTHONUNBUFFERED": "1"},
                              cwd=self.folder.name, stdout=subprocess.PIPE, text=True) as process:
            self.addCleanup(process.kill)
            self.assertIn("reading the model", process.stdout.readline())
            self.assertIn("the start shape of", process.stdout.readline())
            address = process.stdout.readline().strip()
            with urllib.request.urlopen(address + "header", timeout=60) as answer:
                self.assertEqual([line["name"] for line in json.load(answer)["lines"]], ["chain"])
            for name in ("", "viewer.js", "view.css", "three.js", "block/position/0"):
                with urllib.request.urlopen(address + name, timeout=60) as answer:
                    self.assertGreater(len(answer.read()), 100, name)
            process.kill()

    def test_without_the_python_tools_the_message_has_the_searched_folders(self):
        alone = Path(self.folder.name) / "alone/bin/hawser"
        alone.parent.mkdir(parents=True)
        shutil.copy2(self.prefix / "bin/hawser", alone)
        done = run(alone, "report", "x.h5")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"hawser_post is neither in .*/alone/bin/share/hawser/python "
                                      r"nor in .*/alone/share/hawser/python\n$")

    def test_no_path_of_the_sources_is_needed(self):
        self.assertNotIn(str(ROOT / "scripts").encode(), (self.prefix / "bin/hawser").read_bytes())

    def test_one_version_everywhere(self):
        output = self.hawser("--version").split()[1]
        lists = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
        project = re.search(r"project\(hawser VERSION ([\d.]+)", lists)[1]
        self.assertEqual(output.split("+")[0], project)
        commit = subprocess.run(["git", "-C", ROOT, "rev-parse", "HEAD"], capture_output=True, text=True, check=False).stdout
        if commit and (ROOT / ".git").exists():
            self.assertIn(f"+{commit[:8]}", output)
        changelog = BUILD / "debian/changelog"
        if changelog.exists():
            text = changelog.read_text(encoding="utf-8")
            self.assertTrue(text.startswith(f"hawser ({project}) "), text)
            read = run("dpkg-parsechangelog", "-l", changelog, "-S", "Version")
            self.assertEqual((read.stdout.strip(), read.stderr), (project, ""))


class Presets(unittest.TestCase):
    def test_scripts_name_presets_that_exist(self):
        known = set(re.findall(r"^ +\"(\w+)\"", run(shutil.which("cmake"), "--list-presets", cwd=ROOT).stdout, re.M))
        self.assertTrue({"native", "release", "package", "debug", "asan"} <= known, known)
        for name in ("run", "test", "lint", "package"):
            text = (ROOT / "scripts" / name).read_text(encoding="utf-8")
            for preset in re.findall(r"--preset (\w+)|\bpreset=(\w+)", text):
                self.assertIn("".join(preset), known, name)


if __name__ == "__main__":
    unittest.main()
