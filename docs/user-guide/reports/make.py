#!/usr/bin/env python3
"""Makes the pictures of this page: runs cases, makes their reports, and takes pictures of them in a browser.

    docs/user-guide/reports/make.py [CASE ...]      (default: all of the page)

Needs the program (build/hawser, or HAWSER), Chromium and python3-pil: apt-get install chromium python3-pil.
"""
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent.parent
HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
CASES = {"hanging-line": [], "mooring-line": ["--modes"], "lazy-wave": [], "jumper": [], "crossing-lines": [], "roller": [],
         "lifted-load": [], "barge-hawser": [], "fenders": []}
WIDE, HIGH, COLUMNS, SCALE = 900, 2000, 3, 0.55  # pixels of a column as on a screen; how much smaller the picture is
# As the report is on a screen, in columns beside each other.
STYLE = f"""<style>body {{ max-width: none; margin: 20px; width: {COLUMNS * (WIDE + 40) - 40}px; height: {HIGH}px; columns: {COLUMNS};
column-gap: 40px; column-fill: auto }} html {{ overflow: hidden }} .wide {{ overflow: hidden }} h2 {{ break-after: avoid }}</style>"""
BROWSER = ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
           "--disable-component-update", "--disable-sync", "--hide-scrollbars"]


def picture(report, path):
    from PIL import Image

    with tempfile.TemporaryDirectory() as folder:
        page, shot = Path(folder) / "page.html", Path(folder) / "shot.png"
        page.write_text(report.read_text(encoding="utf-8").replace("</head>", STYLE + "</head>"), encoding="utf-8")
        subprocess.run(["chromium", *BROWSER, f"--user-data-dir={folder}/profile", f"--screenshot={shot}",
                        f"--window-size={COLUMNS * (WIDE + 40)},{HIGH + 40}", page.as_uri()], check=True, capture_output=True)
        with Image.open(shot) as image:
            small = image.convert("RGB").resize([round(SCALE * n) for n in image.size], Image.LANCZOS)
            small.quantize(200, kmeans=2, dither=Image.Dither.NONE).save(path, optimize=True)


def main(names):
    for name in names:
        if name not in CASES:
            sys.exit(f"make.py: no such case: {name} (there are: {', '.join(CASES)})")
    for name in names or CASES:
        with tempfile.TemporaryDirectory() as folder:
            case = Path(shutil.copytree(ROOT / "cases" / name, Path(folder) / name)) / f"{name}.yaml"
            report = Path(folder) / "report.html"
            subprocess.run([HAWSER, "report", case, "-o", report, *CASES[name]], check=True, stdout=subprocess.DEVNULL)
            picture(report, HERE / f"{name}.png")
            print(f"{name}.png: {(HERE / f'{name}.png').stat().st_size // 1000} kB")


if __name__ == "__main__":
    main(sys.argv[1:])
