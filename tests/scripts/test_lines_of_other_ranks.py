"""Ranks forget lines of other ranks after the start shape. Events, links, histories and clearances that name lines of any
rank, lines that touch on two ranks, feeders, and warnings about lines are the same on 1 and 3 ranks."""
import os
import re
import tempfile
import unittest
from pathlib import Path

from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
MPI = ("mpirun", "--oversubscribe", "--allow-run-as-root", "-n", "3")
GROUPS = 3  # of lines, 400 m from each other
LEAST = 12  # warnings: each group has two lines above their breaking load, one in compression and one bent too far
HEAD = """hawser: 1
environment:
  water: {density: 1025, depth: 50}
  current: {speed: 0.5}
  seabed: {depth: 50, friction: 0.5}
line_types:
  chain: {outer_diameter: 0.2, mass_per_length: 200, EA: 1e9, bending: false, breaking_load: 100 kN}
  rope: {outer_diameter: 0.1, mass_per_length: 10, EA: 1e7, bending: false, breaking_load: 1 kN}
  hose: {outer_diameter: 0.3, mass_per_length: 80, EA: 5e7, EI: 2e4, GJ: 2e4, minimum_bend_radius: 20}
statics: true
dynamics: {duration: 0.3}
"""


def case():
    bodies, lines, events, histories = [], [], [], []
    for g in range(GROUPS):
        x = 400 * g
        bodies += [
            f"  float{g}: {{position: [{x}, 0, 0], motion: {{harmonic: {{amplitude: [2, 0, 3], period: 4}}, ramp: 1}}}}",
            f"  boat{g}: {{position: [{x}, 60, 0]}}",
            f"  arm{g}: {{position: [{x}, 30, 1.2], motion: {{harmonic: {{amplitude: [0, 0, -0.5], period: 3}}, ramp: 0.5}}}}",
        ]
        boat = f"body: boat{g}, at"
        lines += [
            f"  chain{g}: {{sections: [{{type: chain, length: 150, elements: 15}}], end_a: {{anchor: [{x + 130}, 0, -50]}}, "
            f"end_b: {{body: float{g}, at: [0, 0, 0]}}}}",
            f"  rope{g}: {{sections: [{{type: rope, length: 60.5, elements: 8}}], end_a: {{body: float{g}, at: [0, 1, 0]}}, "
            f"end_b: {{{boat}: [0, -1, 0]}}}}",
            f"  hose{g}: {{sections: [{{type: hose, length: 30, elements: 12}}], end_a: {{{boat}: [2, 0, 0]}}, end_b: free}}",
            f"  wire{g}: {{sections: [{{type: rope, length: 20.1, elements: 10}}], end_a: {{anchor: [{x - 10}, 30, 1]}}, "
            f"end_b: {{anchor: [{x + 10}, 30, 1]}}}}",
            f"  cross{g}: {{sections: [{{type: rope, length: 14.1, elements: 12}}], end_a: {{body: arm{g}, at: [0.5, -7, 0]}}, "
            f"end_b: {{body: arm{g}, at: [0.5, 7, 0]}}}}",
            f"  fed{g}: {{sections: [{{type: hose, length: 40, elements: 20}}], end_b: free, "
            f"end_a: {{{boat}: [-3, 0, 0], clamped: true, direction: [0, 0, -1], feed: {{speed: 0.3, stock: 25}}}}}}",
        ]
        events.append(f"  - {{release: {{line: chain{g}, end: end_a}}, time: {0.1 + 0.05 * g:g}}}")
        histories.append(f"    - {{line: rope{g}, at: 20}}")
    events += ["  - {cut: {line: rope1, at: 30}, time: 0.2}", "  - {attach: {line: hose0, end: end_b}, time: 0.25}"]
    return HEAD + "\n".join(
        ["bodies:", *bodies, "lines:", *lines, "events:", *events, "links:",
         "  spring: {end_a: {line: rope0, at: 30}, end_b: {line: hose2, at: 10}, stiffness: 100}", "output:",
         "  clearances: [{line: wire0, other_line: cross0}, {line: chain2, other_line: chain0}]", "  histories:", *histories, ""]
    )


class LinesOfOtherRanks(unittest.TestCase):
    def test_messages(self):
        found = []
        with tempfile.TemporaryDirectory() as folder:
            write(Path(folder), "case.yaml", case())
            for command, results in (((), "1.h5"), (MPI, "3.h5")):
                done = run(*command, HAWSER, "run", "case.yaml", "-o", results, cwd=folder, timeout=600)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                messages = [t for t in done.stdout.splitlines() if re.match("warning: |event: |m(ax|in) |note: ", t)]
                # Without numbers, and without how many lines have the same error.
                found.append(sorted(re.sub(r"(?<=\s)\(?[-+]?\d\S*|\s+|: use elements.*", " ", t) for t in messages))
        self.assertGreaterEqual(sum(t.startswith("warning") for t in found[0]), LEAST)
        self.assertEqual(found[0], found[1])


if __name__ == "__main__":
    unittest.main()
