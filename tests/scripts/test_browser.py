"""A report in a browser: all pictures are shown, nothing is fetched, there are no errors, and it prints on A4."""
import html
import json
import os
import re
import shutil
import tempfile
import unittest
from pathlib import Path

from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
BROWSER = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
CASE = """\
hawser: 1
title: A short report
environment:
  water: {depth: 40}
  waves: {regular: {height: 2, period: 6}}
  seabed: {depth: 40}
line_types:
  hose: {outer_diameter: 0.2, mass_per_length: 60, EA: 1e8, EI: 1e4, GJ: 1e4, Cd_normal: 1, breaking_load: 1 MN}
volumes:
  buoy: {shape: {sphere: {centre: [20, 8, -10], radius: 2}}}
lines:
  hose:
    sections: [{type: hose, length: 60, elements: 30}]
    end_a: {anchor: [0, 0, -5]}
    end_b: {anchor: [40, 0, -5]}
dynamics: {duration: 8, step: 0.1}
output: {every: 0.5, histories: [{line: hose, at: end_a}], clearances: [{line: hose, volume: buoy}]}
"""
# The browser's network log records the origin of each request: this number marks requests of a page, not of
# the browser itself (test_sees_what_is_wrong fails if it changes).
OF_PAGES = r'"traffic_annotation":101845102'
# Report of the loaded page: pictures and their state, loaded resources, width.
ASKED = """<script>addEventListener('load', () => {
  const pictures = [...document.images];
  document.body.setAttribute('data-result', JSON.stringify({
    pictures: pictures.length, shown: pictures.filter(p => p.complete && p.naturalWidth > 100).length,
    loaded: performance.getEntriesByType('resource').map(e => e.name.slice(0, 40)).filter(n => !n.startsWith('data:')),
    wide: document.documentElement.scrollWidth, window: innerWidth}));
})</script>"""


@unittest.skipUnless(BROWSER, "no report is opened in a browser: chromium is not installed (scripts/install-deps --browser)")
class Browser(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        write(cls.folder, "short.yaml", CASE)
        result = run(HAWSER, "report", "short.yaml", cwd=cls.folder, timeout=600)
        if result.returncode:
            raise AssertionError(result.stdout + result.stderr)
        cls.report = cls.folder / "short.html"

    def browse(self, page, *options):
        with tempfile.TemporaryDirectory() as profile:
            browser_run = run(BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
                       "--disable-component-update", "--disable-sync", f"--user-data-dir={profile}", "--host-resolver-rules=MAP * ~NOTFOUND", "--enable-logging=stderr",
                       "--window-size=1000,800", *options, Path(page).as_uri(), timeout=300)
        self.assertEqual(browser_run.returncode, 0, browser_run.stderr)
        return browser_run

    def state(self, text):
        write(self.folder, "asked.html", text.replace("</head>", ASKED + "</head>"))
        net = self.folder / "net.json"
        browser_run = self.browse(self.folder / "asked.html", "--dump-dom", "--virtual-time-budget=10000", f"--log-net-log={net}")
        output = json.loads(html.unescape(re.search(r'data-result="([^"]*)"', browser_run.stdout).group(1)))
        # Without a graphics card the browser warns of slow software rendering.
        output["console"] = [line for line in re.findall(r"CONSOLE.*", browser_run.stderr) if not re.search("software WebGL|GL Driver Message", line)]
        output["requests"] = sorted(set(re.findall(OF_PAGES + r',"url":"(\w+://[^"]*)"', net.read_text(encoding="utf-8"))
                                      ) - {(self.folder / "asked.html").as_uri()})
        return output

    def test_opens_by_itself(self):
        text = self.report.read_text(encoding="utf-8")
        self.assertLess(len(text.encode()), 5e6)
        output = self.state(text)
        self.assertGreater(output["pictures"], 8)
        self.assertEqual((output["shown"], output["loaded"], output["console"], output["requests"]), (output["pictures"], [], [], []))
        self.assertLessEqual(output["wide"], output["window"])

    def test_sees_what_is_wrong(self):
        # The same checks on a page with an external picture, a broken one, and an error.
        bad = ('<html><head></head><body><img src="http://picture.invalid/a.png"><img src="data:image/png;base64,AAAA">'
               '<script>console.error("oh")</script><div style="width: 3000px">x</div></body></html>')
        output = self.state(bad)
        self.assertEqual((output["pictures"], output["shown"]), (2, 0))
        self.assertTrue(any("oh" in line for line in output["console"]), output)
        self.assertIn("http://picture.invalid/a.png", output["requests"])
        self.assertGreater(output["wide"], output["window"])

    def test_prints_on_a4(self):
        paper = self.folder / "short.pdf"
        self.browse(self.report, "--no-pdf-header-footer", f"--print-to-pdf={paper}")
        boxes = re.findall(rb"/MediaBox \[([\d. ]+)\]", paper.read_bytes())
        self.assertGreater(len(boxes), 2)
        for box in boxes:  # points of 1/72 inch: 210 x 297 mm
            width, height = (float(v) for v in box.split()[2:])
            self.assertAlmostEqual(width, 595.3, delta=1.5)
            self.assertAlmostEqual(height, 841.9, delta=1.5)


if __name__ == "__main__":
    unittest.main()
