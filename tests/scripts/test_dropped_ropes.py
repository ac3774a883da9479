"""Two ropes dropped flat on a floor, one rotated by 10 degrees, and a hanging rope, with and without damping."""
import os
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
ROPE = "outer_diameter: 0.01, mass_per_length: 0.1, EA: 1e4, EI: 0.0625, GJ: 0.05"
TURN = np.radians(10)


class DroppedRopes(unittest.TestCase):
    def series(self, text):
        """Columns by history, and of the energy."""
        with tempfile.TemporaryDirectory() as folder:
            write(Path(folder), "case.yaml", f"hawser: 1\nenvironment: {{gravity: 9.80665}}\n{text}")
            done = run(HAWSER, "run", "case.yaml", "-q", cwd=folder)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            with h5py.File(Path(folder) / "case.h5") as file:
                return {name: {c.decode(): data[:, k] for k, c in enumerate(data.attrs["columns"])}
                        for name, data in file["series"].items() if "columns" in data.attrs}

    def test_turned_rope_lies_as_the_other(self):
        """Two ropes of 0.5 m and 0.05 kg fall from 0.1 m, friction 0.5, 10 s: after rotation their motions
        are equal, without lateral drift; both come to rest with their weight on the floor; the energy never
        exceeds its initial value."""
        lines = ""
        for name, angle, middle in (("even", 0, np.zeros(2)), ("turned", TURN, np.array([-np.sin(TURN), np.cos(TURN)]))):
            along = 0.25 * np.array([np.cos(angle), np.sin(angle)])
            points = [[*(middle - along).tolist(), 0.105], [*(middle + along).tolist(), 0.105]]
            lines += (f"  {name}: {{sections: [{{type: rope, length: 0.5, elements: 20}}], end_a: free, end_b: free, "
                      f"start: {{points: {points}}}}}\n")
        ends = [f"{name}@end_{e}" for name in ("even", "turned") for e in "ab"]
        histories = ", ".join(f"{{line: {e.split('@')[0]}, at: {e.split('@')[1]}}}" for e in ends)
        found = self.series(f"line_types: {{rope: {{{ROPE}}}}}\nvolumes: {{floor: {{shape: {{plane: {{point: [0, 0, 0], normal: [0, 0, 1]}}}}, "
                            f"friction: 0.5, relative_damping: 1}}}}\nlines:\n{lines}statics: false\ndynamics: {{duration: 10, max_step: 0.005}}\n"
                            f"output: {{every: 5, histories: [{histories}, {{volume: floor}}]}}\n")
        back = np.array([[np.cos(TURN), np.sin(TURN), 0], [-np.sin(TURN), np.cos(TURN), 0], [0, 0, 1]])
        place = {e: np.array([found[e][f"position_{a}"] for a in "xyz"]) for e in ends}
        for e in "ab":
            turned = back @ place[f"turned@end_{e}"] - np.array([[0], [1], [0]])
            self.assertLess(np.abs(turned - place[f"even@end_{e}"]).max(), 1e-9)
            self.assertLess(np.abs(turned[1]).max(), 1e-9)
        for e in ends:
            self.assertLess(max(abs(found[e][f"velocity_{a}"][-1]) for a in "xyz"), 1e-9)
            self.assertAlmostEqual(np.linalg.norm(place[e][:2, 0] - place[e][:2, -1]), 0, delta=1e-9)
        self.assertAlmostEqual(found["floor"]["force_z"][-1] / 2, 0.4903325, delta=1e-6)
        energy = sum(found["energy"][part] for part in ("kinetic", "strain", "potential"))
        self.assertLess((energy - energy[0]).max(), 1e-12)
        self.assertLess(energy[-1] - energy[0], -0.09)

    def test_damping_does_not_change_rest(self):
        """A rope of 4.8 m between points 4 m apart, with `stiffness_damping` of 0 and 1 s: the equilibrium is
        the same, and the rope does not move afterwards."""
        places = []
        for damping in (0, 1):
            found = self.series(f"line_types: {{rope: {{{ROPE}, stiffness_damping: {damping}}}}}\nlines:\n  rope: {{sections: [{{type: rope, "
                                "length: 4.8, elements: 40}], end_a: {anchor: [0, 0, 0]}, end_b: {anchor: [4, 0, 0]}}\n"
                                "dynamics: {duration: 2, step: 0.01}\noutput: {every: 1, histories: [{line: rope, at: 1.2}]}\n")
            of_rope = next(columns for name, columns in found.items() if name.startswith("rope"))
            place = np.array([of_rope[f"position_{a}"] for a in "xyz"])
            self.assertLess(np.abs(place - place[:, :1]).max(), 1e-9)
            places.append(place[:, 0])
        np.testing.assert_allclose(places[0], places[1], rtol=0, atol=1e-9)


if __name__ == "__main__":
    unittest.main()
