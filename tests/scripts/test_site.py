"""scripts/site: Sphinx warns of a deliberately broken link and nothing else."""
import importlib.util
import subprocess
import tempfile
import unittest
from importlib.machinery import SourceFileLoader
from pathlib import Path

from support import ROOT, run

loader = SourceFileLoader("site_script", str(ROOT / "scripts/site"))
site = importlib.util.module_from_spec(importlib.util.spec_from_loader("site_script", loader))
loader.exec_module(site)


def missing():
    """Missing packages of the site."""
    return [p for p in site.PACKAGES if subprocess.run(["dpkg-query", "-W", p], capture_output=True).returncode != 0]


class Site(unittest.TestCase):
    @unittest.skipIf(missing(), "scripts/site has not installed Sphinx here: " + " ".join(missing()))
    def test_only_the_broken_link(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = Path(folder)
            (folder / "source").mkdir()
            site.stage(folder / "source")
            page = folder / "source/docs/performance.md"
            page.write_text(page.read_text(encoding="utf-8") + "\n[gone](gone.md)\n", encoding="utf-8")
            result = site.build(folder / "source", folder / "html", folder / "trees")
            complaints = [line for line in result.stderr.splitlines() if "WARNING" in line or "ERROR" in line]
            self.assertEqual(result.returncode, 1, result.stderr)
            self.assertEqual(len(complaints), 1, result.stderr)
            self.assertIn("performance.md", complaints[0])
            self.assertIn("gone.md", complaints[0])
            self.assertIn("touchdown", (folder / "html/searchindex.js").read_text(encoding="utf-8"))
            beam = (folder / "html/docs/theory/beam.html").read_text(encoding="utf-8")
            self.assertNotIn('src="http', beam)  # no resource is loaded from a network
            self.assertIn("katex.min.js", beam)

    def test_a_folder_with_other_things_stays(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "thesis.txt").write_text("mine", encoding="utf-8")
            result = run("scripts/site", folder)
            self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
            self.assertIn("is not empty", result.stderr)
            self.assertEqual([p.name for p in Path(folder).iterdir()], ["thesis.txt"])


if __name__ == "__main__":
    unittest.main()
