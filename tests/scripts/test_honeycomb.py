"""The farm of cases/honeycomb: one and two ranks agree, its chains at rest equal those of a single turbine, anchors
are shared, and cables without current are carried by their ends and the bed."""
import math
import os
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
from support import ROOT, run

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
FOLDER = ROOT / "cases" / "honeycomb"
# Of honeycomb.yaml: N/m in water of the cable and of its part with modules, m of each.
BARE, MODULES = ((mass - 1025 * math.pi / 4 * d**2) * 9.80665 for mass, d in ((48.292, 0.2), (64.279, 0.3)))
BARE_LENGTH, MODULES_LENGTH = 1428.0, 280.0


class Honeycomb(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.results = {}
        current = "environment.current={profile: [{depth: 0, speed: 0.5, direction_deg: 60}, {depth: 200, speed: 0.2, direction_deg: 60}]}"
        rest = ("--set", "dynamics=null", "--set", "environment.waves=null")
        for name, case, ranks, words in (
                ("one", "honeycomb", 1, ("--stop-at", 2)), ("two", "honeycomb", 2, ("--stop-at", 2)),
                ("still", "honeycomb", 1, (*rest, "--set", "farm.of.bodies.float.motion.rao=null", "--set", "environment.current=null")),
                ("alone", "turbine", 1, (*rest, "--set", "bodies.float.motion.rao=null", "--set", current))):
            path = Path(folder.name) / f"{name}.h5"
            done = run("mpirun", "-n", ranks, HAWSER, "run", FOLDER / f"{case}.yaml", "-q", "-o", path, *words, timeout=900)
            if done.returncode:
                raise AssertionError(done.stdout + done.stderr)
            cls.results[name] = h5py.File(path)
        cls.names = [name.decode() for name in cls.results["one"]["lines/name"][:]]

    def ends(self, name):
        """Forces on the ends of every line at rest: lines, ends, x y z."""
        return self.results[name]["ends/force"][0].reshape(-1, 2, 3)

    def test_ranks(self):
        one, two = (self.results[name] for name in ("one", "two"))
        self.assertEqual(len(one["outputs/time"]), 3)
        for field, size in (("position", 1e-6), ("effective_tension", 1.0)):
            self.assertLess(np.abs(one["fields"][field][:] - two["fields"][field][:]).max(), size, field)

    def test_chains_are_those_of_one_turbine(self):
        alone = {name.decode(): force for name, force in zip(self.results["alone"]["lines/name"][:], self.ends("alone"))}
        self.assertEqual(set(alone), {"east", "west", "south"})
        farm = dict(zip(self.names, self.ends("one")))
        placed = [name for name in farm if "/" in name]
        self.assertEqual(len(placed), 18)
        for name in placed:
            np.testing.assert_allclose(farm[name], alone[name.split("/")[1]], atol=1e-4 * np.abs(alone["west"]).max(), err_msg=name)

    def test_anchors_are_shared(self):
        file = self.results["one"]
        first, places = file["lines/first_node"][:], {}
        for k, name in enumerate(self.names):
            if "/" in name:
                places.setdefault(tuple(np.round(file["fields/position"][0][int(first[k])], 1)), []).append(name)
        self.assertEqual(sorted(map(len, places.values())), [1, 1, 1, 1, 1, 1, 2, 2, 2, 3, 3])

    def test_weight_of_the_cables(self):
        file = self.results["still"]
        first, nodes = file["lines/first_node"][:], file["lines/nodes"][:]
        weight = BARE * BARE_LENGTH + MODULES * MODULES_LENGTH
        for k, name in enumerate(self.names):
            if not name.startswith("cable"):
                continue
            bed = file["fields/seabed_force"][0][int(first[k]):int(first[k] + nodes[k]), 2].sum()
            held = -self.ends("still")[k, :, 2].sum()
            self.assertAlmostEqual((bed + held) / weight, 1, delta=1e-6, msg=name)
            self.assertTrue(0.15 < held / weight < 0.35, (name, held / weight))


if __name__ == "__main__":
    unittest.main()
