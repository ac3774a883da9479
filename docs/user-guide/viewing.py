#!/usr/bin/env python3
"""Draws the pictures of viewing.md with Chromium: viewing.py FOLDER [NAME ...]

FOLDER keeps the results of the cases, about 200 MB; those that are there are taken as they are. NAME: of a picture, for all of them."""
import os
import shutil
import subprocess
import sys
import threading
import time
from pathlib import Path

from PIL import Image

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path += [str(ROOT / "scripts"), str(ROOT / "tests/scripts")]
import browser  # noqa: E402
from hawser_post.viewer import served, server  # noqa: E402

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))

# Of each picture: the case, its window, whether the whole page or the model alone, and what is done before it is taken.
AT = "const {model, player} = hawserView; await player.show(model.header.times.findIndex((t) => t >= %g));"
PICTURES = {
    "view": ("cases/offloading-hose/offloading-hose.yaml", (1280, 820), True, AT % 300 + "await hawserView.paint('curvature');"),
    "spool": ("cases/spool/spool.yaml", (980, 613), False, AT % 480 + """
        await hawserView.paint('contact_normal_force');
        const box = hawserView.scene.boxOf({body: 0}); hawserView.fitNow(box); hawserView.scene.camera.zoom(1.15);"""),
    "parts": ("docs/user-guide/viewing/parts.yaml", (820, 550), False, AT % 30 + """
        hawserView.scene.shown.bedForces = true; hawserView.scene.forget = true; await player.show(player.output);
        hawserView.scene.camera.zoom(1.35);"""),
    "farm": ("cases/farm/farm.yaml", (820, 550), False, AT % 30 + "hawserView.scene.camera.zoom(1.35);"),
    "elevation": ("cases/s-lay/startup.yaml", (1280, 820), True, AT % 160 + "hawserView.look('x'); hawserView.fitNow();"),
}


def results_of(case, folder):
    """The results of a case, run where there are none."""
    case = ROOT / case
    place = folder / case.parent.name
    if not place.exists():
        shutil.copytree(case.parent, place)
    results = place / f"{case.stem}.h5"
    if not results.exists():
        subprocess.run([HAWSER, "run", "-q", place / case.name], check=True)
    return results


def picture(name, folder):
    case, (width, height), whole, actions = PICTURES[name]
    results = results_of(case, folder)
    shows = server.Server(served.Shown(results))
    threading.Thread(target=shows.serve_forever, daemon=True).start()
    chromium = browser.Browser(width, height)
    try:
        chromium.open(shows.address)
        chromium.wait("window.hawserView || window.hawserFailed", 120)
        if not whole:
            chromium.value("document.querySelector('.controls').hidden = document.querySelector('.side').hidden = true;"
                           "document.body.style.padding = 0; Object.assign(document.querySelector('.hawser-view').style, {display: 'block', minHeight: 0});"
                           f"Object.assign(document.querySelector('.picture').style, {{height: '{height}px', maxHeight: 'none'}});hawserView.scene.resize();hawserView.scene.camera.fit()")
        chromium.value(f"(async () => {{ {actions} hawserView.scene.redraw(); }})()")
        time.sleep(2)
        shot = folder / f"{name}.png"
        chromium.picture(shot)
        if chromium.complaints:
            raise SystemExit(f"{name}: {chromium.complaints}")
    finally:
        chromium.close()
        shows.shutdown()
    target = HERE / "viewing" / f"{name}.png"
    Image.open(shot).convert("RGB").save(target, optimize=True)
    print(f"{target}: {target.stat().st_size / 1e3:.0f} kB")


if __name__ == "__main__":
    if len(sys.argv) < 2 or set(sys.argv[2:]) - set(PICTURES):
        raise SystemExit(__doc__)
    for one in sys.argv[2:] or PICTURES:
        picture(one, Path(sys.argv[1]))
