"""Reports stay small enough to be sent: below 5 MB for results of the size of the shipped cases, and, with HAWSER_FULL, the shipped
cases themselves; below 20 MB for an hour of a riser, also with HAWSER_FULL."""
import os
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

from support import ROOT, run
from synthetic import add_contacts, results_file

sys.path.insert(0, str(ROOT / "scripts"))
from hawser_post import __main__ as post  # noqa: E402
from hawser_post.viewer import libraries  # noqa: E402

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
SHIPPED, HOUR = 5e6, 20e6  # bytes
# Fields as the program has them: name, components, how the report shows it.
CABLE = [("effective_tension", 1, "graph"), ("wall_tension", 1, "table"), ("utilisation", 1, "graph"), ("declination", 1, "no"), ("velocity", 3, "no"),
         ("effective_tension_before", 1, "no"), ("effective_tension_after", 1, "no"), ("seabed_force", 3, "no"), ("seabed_friction", 3, "no")]
BEAM = [*CABLE, ("axis_1", 3, "no"), ("axis_2", 3, "no"), ("bending_moment", 1, "graph"), ("bending_moment_2", 1, "no"), ("bending_moment_3", 1, "no"),
        ("curvature", 1, "graph"), ("shear_force", 1, "graph"), ("torsion_moment", 1, "graph")]
TOUCHING = [("contact_force", 3, "no"), ("contact_normal_force", 1, "graph"), ("friction_force", 3, "no"), ("penetration", 1, "table")]


def of_size(path, outputs, lines, nodes, fields, histories=5, contacts=0, every=0.5):
    """Lines in waves whose numbers change at every output: irregular enough to compress no better than real results."""
    random = np.random.default_rng(7)
    t, s = np.arange(outputs) * every, np.linspace(0, 10.0 * nodes, nodes)

    def rough(low, span):
        wave = np.sin(0.6 * t[:, None] - 0.1 * np.tile(s, lines) + np.repeat(np.arange(lines), nodes))
        return low + span * (wave + 0.01 * random.normal(size=wave.shape))

    x = np.stack([np.tile(s, lines) + rough(0, 2), np.repeat(50.0 * np.arange(lines), nodes) + rough(0, 2), rough(-60, 3)], axis=2)
    values = {name: rough(1e5, 3e4) if count == 1 else np.stack([rough(0, 5e3) for _ in range(count)], axis=2) for name, count, _ in fields}
    units = {name: ("N", value) for name, value in values.items()}
    extremes = {name: ("N", np.tile(value.mean(axis=0)[:, None], 6)) for name, value in values.items() if value.ndim == 2}
    steps = np.arange(5 * outputs) * every / 5
    columns = ["effective_tension", "bending_moment", "curvature"]
    series = {f"end_{k}": (columns, ["N", "N m", "1/m"], random.normal(size=(len(steps), 3))) for k in range(histories)}
    names = {f"line {k + 1}": s for k in range(lines)}
    text = "hawser: 1\ntitle: A size\nline_types: {hose: {outer_diameter: 0.3}}\nlines:\n" + "".join(
        f"  {name}: {{sections: [{{type: hose, length: {s[-1]}}}]}}\n" for name in names)
    results_file(path, t, names, {"position": ("m", x), **units}, (steps, series), extremes, case=text,
                 declared={name: {"report": report.encode()} for name, _, report in fields})
    if contacts:
        nodes_of = random.integers(0, x.shape[1], size=(outputs, contacts))
        add_contacts(path, [(np.zeros((contacts, 4)), x[k, nodes_of[k]], random.normal(size=(contacts, 3))) for k in range(outputs)])


@unittest.skipIf(libraries.missing(), libraries.missing())
class ReportSize(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def check(self, results, most):
        page = self.folder / "page.html"
        self.assertFalse(post.main(["report", str(results), "-o", str(page)]))
        size = page.stat().st_size
        print(f"{results.stem}: {size / 1e6:.2f} MB of at most {most / 1e6:g}")
        self.assertLess(size, most)

    def check_size(self, most, **size):
        path = self.folder / "results.h5"
        of_size(path, **size)
        self.check(path, most)

    def test_a_hundred_lines(self):
        self.check_size(SHIPPED, outputs=61, lines=100, nodes=51, fields=CABLE + TOUCHING, histories=33, contacts=400)

    def test_a_hose_in_contact_all_along(self):
        self.check_size(SHIPPED, outputs=281, lines=1, nodes=251, fields=BEAM + TOUCHING, contacts=600)

    @unittest.skipUnless(os.environ.get("HAWSER_FULL"), "long; set HAWSER_FULL")
    def test_an_hour_of_a_riser(self):
        self.check_size(HOUR, outputs=3601, lines=1, nodes=80, fields=BEAM, every=1.0)

    @unittest.skipUnless(os.environ.get("HAWSER_FULL"), "long; set HAWSER_FULL")
    def test_shipped_cases(self):
        cases = [case for case in sorted((ROOT / "cases").glob("*/*.yaml")) if "\nlines:" in case.read_text() or "\nfarm:" in case.read_text()]
        done = 0
        for case in cases:
            with self.subTest(case=case.name):
                path = self.folder / f"{case.stem}.h5"
                ran = run(HAWSER, "run", case, "-q", "-o", path, timeout=3600)
                if ran.returncode == 2:  # needs files that are not part of hawser
                    self.assertIn("there is no such file", ran.stderr)
                    continue
                self.assertEqual(ran.returncode, 0, ran.stderr)
                self.check(path, SHIPPED)
                path.unlink()
                done += 1
        self.assertGreater(done, 20)


if __name__ == "__main__":
    unittest.main()
