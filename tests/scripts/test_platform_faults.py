"""Faults of hydrodynamic files that single rows do not show: heave with conjugated phases, damping with another power
of the frequency, a body far from the height of its files. Each has a sentence of `hawser check`, for the spar of the
tutorial and for public files (skipped if missing), which have no such sentence as they are."""
import gzip
import os
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
from support import ROOT, run, write

sys.path.insert(0, str(ROOT / "scripts"))
from hawser_post.results import Results  # noqa: E402

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
DATA = ROOT.parent / "shared/data"
PLATFORMS = DATA / "platforms"
CONJUGATED = "the heave force lags the crest, but the damping of"
MULTIPLIED, DIVIDED = "with the damping multiplied by the angular frequency", "with the damping divided by the angular frequency"
FAR = "which is more than its size"
WEIGHT = ", gravity_in_stiffness: true"
# Files without endings, water, gravity, mass and more keys of each body, more keys of hydrodynamics.
SPAR = (ROOT / "docs/tutorial/spar", "density: 1025, depth: 200", 9.80665, ["mass: 2.8981e7, centre_of_mass: [0, 0, -50], inertia: [2e10, 2e10, 1e9]"], "")
SETS = {
    "VolturnUS-S": (DATA / "umaine-semi/IEA-15-240-RWT-UMaineSemi", "density: 1025, depth: 200", 9.80665,
                    ["mass: 2.01e7, centre_of_mass: [0, 0, -2.32], inertia: [4.25e10, 4.25e10, 2.37e10]"], ", displaced_volume: 20206.35"),
    "OC4": (PLATFORMS / "oc4-semi/marin_semi", "density: 1025, depth: 200", 9.80665,
            ["mass: 1.407265e7, centre_of_mass: [0, 0, -9.89], inertia: [1.13e10, 1.13e10, 1.2288e10]"], ", displaced_volume: 13917"),
    "TLP": (PLATFORMS / "tlp-mit/tlpmit", "density: 1025, depth: 200", 9.80665,
            ["mass: 8.6e6, centre_of_mass: [0, 0, -40.61], inertia: [5.7e8, 5.7e8, 3.6e8]"], ", displaced_volume: 12179.6"),
    "tanker": (PLATFORMS / "mss-tanker/tanker", "density: 1025", 9.81, ["mass: 94620210, centre_of_mass: [3.93, 0, 2.5], inertia: [2.7e10, 3.85e11, 4.11e11]"],
               ", symmetry: port_starboard" + WEIGHT),
    "drilling semi": (PLATFORMS / "mss-semisub/semisub", "density: 1025", 9.81, ["mass: 51979800, centre_of_mass: [0, 0, -0.5], inertia: [5.66e10, 6.0e10, 7.3e10]"],
                      ", symmetry: port_starboard" + WEIGHT),
    "OES sphere": (PLATFORMS / "oes-sphere/sphere", "density: 1000, depth: 200", 9.81, ["mass: 261800, inertia: [1.7e6, 1.7e6, 1.7e6]"],
                   ", origin_in_file: [0, 0, -2]" + WEIGHT),
    "drift sphere": (PLATFORMS / "drift-sphere/sphere", "density: 1000", 9.80665, ["mass: 2094.395, inertia: [800, 800, 800]"], ""),
    "RM3": (PLATFORMS / "rm3/rm3", "density: 1000", 9.81, ["mass: 725834, inertia: [2.1e7, 2.1e7, 3.7e7]", "mass: 886691, inertia: [9.4e7, 9.4e7, 2.9e7]"], WEIGHT),
    "two ships": (PLATFORMS / "fpso-psv/conjunto_10", "density: 1025, depth: 1000", 9.8,
                  ["mass: 3.1862e8, inertia: [1.2e11, 1.7557e12, 1.8e12]", "mass: 8.17e6, inertia: [3.62e8, 4.04e9, 4.04e9]"], WEIGHT),
    "hemisphere": (PLATFORMS / "hemisphere/hemisphere_ulen5", "density: 1000", 9.81, ["mass: 261800, inertia: [2.6e6, 2.6e6, 2.6e6]"], ", length_scale: 5"),
}
# Names of files that are not those of their set.
OTHERS = {"oc4-semi/marin_semi.3": PLATFORMS / "oc4-semi/oc4_excitation_raft_grid.3", "fpso-psv/conjunto_10.hst": ROOT / "cases/side-by-side/conjunto_10.hst"}


def changed(text, columns, change, digits=10):
    """Rows of numbers with at least so many columns, changed."""
    out = []
    for line in text.splitlines():
        try:
            row = [float(word) for word in line.split()]
        except ValueError:
            out.append(line)
            continue
        if len(row) >= columns:
            change(row)
        out.append(" ".join(f"{x:.{digits}g}" for x in row))
    return "\n".join(out) + "\n"


def conjugate_heave(text):
    def change(row):
        if (row[2] - 1) % 6 == 2:
            row[4], row[6] = -row[4], -row[6]

    return changed(text, 7, change)


def every_60_degrees(text):
    return "".join(line + "\n" for line in text.splitlines() if float(line.split()[1]) % 60 == 0)


def scaled_damping(power):
    def change(row):
        if row[0] > 0:
            row[4] *= (2 * np.pi / row[0]) ** power

    return lambda text: changed(text, 5, change)


def from_another_origin(x, y, headings):
    """Changes of .1, .3 and .hst of the spar, which is round, to those about an origin at (-x, -y) from its axis and for other
    headings. About the origin O' of a body with its old origin at r = (x, y, 0) from it A' = T^T A T, with T = [[1, -r^], [0, 1]];
    X leads by the phase of the wave at r less."""
    T = np.eye(6)
    T[0, 5], T[1, 5], T[2, 3], T[2, 4] = -y, x, y, -x

    def matrices(text, first, values):
        found = {}
        for row in ([float(word) for word in line.split()] for line in text.splitlines()):
            i, j = int(row[first]) - 1, int(row[first + 1]) - 1
            for k in range(min(values, len(row) - first - 2)):
                found.setdefault((*row[:first],), np.zeros((values, 6, 6)))[k, i, j] = row[first + 2 + k]
        out = ""
        for at, blocks in found.items():
            moved = [T.T @ block @ T for block in blocks]
            count = values if not at or at[0] > 0 else 1
            out += "".join(" ".join(f"{v:.9g}" for v in (*at, i + 1, j + 1, *(m[i, j] for m in moved[:count]))) + "\n"
                           for i in range(6) for j in range(6) if any(m[i, j] for m in moved[:count]))
        return out

    def stiffness(text):
        """With the buoyancy beside the origin: C46 = -rho g V x, C56 = -rho g V y."""
        buoyancy = "".join(f"{i} 6 {-28274.3 * arm:.9g}\n" for i, arm in ((4, x), (5, y)) if arm)
        return matrices(text, 0, 1) + buoyancy

    def forces(text):
        rows = [[float(word) for word in line.split()] for line in text.splitlines()]
        along = {}
        for row in rows:
            if row[1] == 0:
                along.setdefault(row[0], np.zeros(6, complex))[int(row[2]) - 1] = complex(row[5], row[6])
        out = ""
        for period, X in along.items():
            omega = 2 * np.pi / period
            number = omega**2 / 9.80665
            for _ in range(100):  # k tanh(k d) = omega²/g, by the mean of k and of what follows from it
                number = 0.5 * (number + omega**2 / 9.80665 / np.tanh(number * 200))
            for heading in headings:
                c, s = np.cos(np.radians(heading)), np.sin(np.radians(heading))
                turned = np.array([X[0] * c, X[0] * s, X[2], -X[4] * s, X[4] * c, 0])
                moved = T.T @ turned * np.exp(-1j * number * (x * c + y * s))
                out += "".join(f"{period} {heading} {i + 1} {abs(v):.6g} {np.degrees(np.angle(v)):.2f} {v.real:.6g} {v.imag:.6g}\n"
                               for i, v in enumerate(moved) if abs(v) > 0)
        return out

    return {".1": lambda text: matrices(text, 1, 2), ".3": forces, ".hst": stiffness}


class Faults(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def text(self, stem, ending):
        """Text of a file, which may be compressed; none if it is not there."""
        path = OTHERS.get(f"{stem.parent.name}/{stem.name}{ending}", Path(f"{stem}{ending}"))
        zipped = path.with_name(path.name + ".gz")
        return path.read_text() if path.exists() else gzip.decompress(zipped.read_bytes()).decode() if zipped.exists() else None

    def check(self, of, change=None, z=None, ending=".1", changes=None):
        """Output of `hawser check`, with one file changed or, by `changes`, several."""
        stem, water, gravity, masses, keys = of
        for old in self.folder.iterdir():
            old.unlink()
        for suffix in (".1", ".3", ".hst"):
            text = self.text(stem, suffix)
            if text is None and suffix != ".3":
                self.skipTest(f"{stem}{suffix} is not there")
            if text is not None:
                text = changes[suffix](text) if changes else text
                write(self.folder, f"files{suffix}", change(text) if change and suffix == ending else text)
        height = z if z is not None else -2 if "origin_in_file" in keys else 0
        bodies = "".join(f"  body{n}: {{position: [0, 0, {height}], floating: {{{mass}, hydrodynamics: {{wamit: files, body: {n}{keys}}}}}}}\n"
                         for n, mass in enumerate(masses, 1))
        write(self.folder, "case.yaml", f"hawser: 1\nenvironment: {{gravity: {gravity}, water: {{{water}}}}}\nbodies:\n{bodies}"
              "statics: false\ndynamics: {duration: 1, step: 0.1}\n")
        done = run(HAWSER, "check", "case.yaml", "--quick", cwd=self.folder)
        return done.stdout + done.stderr

    def assert_only(self, sentence, text):
        for one in (CONJUGATED, MULTIPLIED, DIVIDED, FAR):
            self.assertEqual(text.count(one), 1 if one == sentence else 0, text)

    def test_spar(self):
        self.assert_only(None, self.check(SPAR))
        self.assert_only(CONJUGATED, self.check(SPAR, conjugate_heave, ending=".3"))
        self.assert_only(CONJUGATED, self.check(SPAR, lambda text: conjugate_heave(every_60_degrees(text)), ending=".3"))
        self.assert_only(DIVIDED, self.check(SPAR, scaled_damping(1)))
        self.assert_only(MULTIPLIED, self.check(SPAR, scaled_damping(-1)))

    def test_origin_beside_the_axis(self):
        """Phases are those at the origin; 60 m beside the axis the heave force of a wave of 150 m has one of up to 144 deg. Directions
        of unequal gaps, whose mean has odd harmonics unless they are weighted; all in one quarter; all round. Heights and periods are
        those of the spar about its axis."""
        for x, y in ((60, 0), (-25, 55)):
            mass = SPAR[3][0].replace("[0, 0, -50]", f"[{x}, {y}, -50]")
            of = (*SPAR[:3], [mass], SPAR[4])
            for headings in (range(0, 360, 55), (0, 60, 120, 180, 240, 300, 330), (0, 30, 60), range(0, 360, 30)):
                with self.subTest(x=x, y=y, headings=headings):
                    changes = from_another_origin(x, y, headings)
                    text = self.check(of, changes=changes)
                    self.assert_only(None, text)
                    self.assertNotIn("note:", text)
                    self.assertIn("metacentric heights 5.277 m (roll), 5.277 m (pitch)", text)
                    self.assertIn("heave 19.69 s, roll 30.62 s, pitch 30.62 s", text)
            self.assert_only(CONJUGATED, self.check(of, conjugate_heave, ending=".3", changes=changes))

    def test_height_of_the_files(self):
        """A cube of the spar's volume has sides of 30.5 m."""
        text = self.check(SPAR)
        self.assertNotIn("the height of its files", text)
        for z, where in ((-20, "20 m below"), (1, "1 m above")):
            text = self.check(SPAR, z=z)
            self.assert_only(None, text)
            self.assertIn(f"starts {where} the height of its files", text)
        text = self.check(SPAR, z=-31)
        self.assert_only(FAR, text)
        self.assertIn("bodies.body1.position: z is -31 m, 31 m below the height of its files, 0 m, which is more than its size (30.5 m", text)

    def test_directions_between_those_of_files(self):
        """Files about an origin 60 m from the axis with directions 30 deg apart: in a wave of 8 s to 50 deg the force is that of
        files about its axis; linear interpolation with the phases at that origin loses a third of it."""
        forces = []
        for x in (0, 60):
            wave = "}, waves: {regular: {height: 1, period: 8, direction_deg: 50}, ramp: 10"
            mass = SPAR[3][0].replace("[0, 0, -50]", f"[{x}, 0, -50]")
            of = (SPAR[0], SPAR[1] + wave, SPAR[2], [mass], "")
            self.check(of, changes=from_another_origin(x, 0, range(0, 360, 30)))
            case = (self.folder / "case.yaml").read_text()
            case = case.replace("position: [0, 0, 0]", f"position: [{-x}, 0, 0]").replace("duration: 1,", "duration: 30,")
            case += f"output: {{histories: [{{body: body1}}]}}\n"
            write(self.folder, "case.yaml", case)
            done = run(HAWSER, "run", "case.yaml", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            series = Results(self.folder / "case.h5").series("body1")
            forces.append(np.column_stack([series.column(f"wave_force_{axis}") for axis in "xyz"]))
        self.assertGreater(np.abs(forces[0]).max(), 1e6)
        self.assertLess(np.abs(forces[1] - forces[0]).max(), 3e-4 * np.abs(forces[0]).max())

    def test_origin_moved(self):
        """Phases about an origin at (x, y) from that of the files and `origin_in_file` there mean the same motion, to 1e-8: in waves at a
        row of the files, and between periods and directions."""
        def moved(x, y):
            def change(row):
                omega, toward = 2 * np.pi / row[0], np.radians(row[1])
                number = omega**2 / 9.80665
                for _ in range(200):
                    number = 0.5 * (number + omega**2 / 9.80665 / np.tanh(number * 200))
                X = complex(row[5], row[6]) * np.exp(-1j * number * (x * np.cos(toward) + y * np.sin(toward)))
                row[3:] = [abs(X), np.degrees(np.angle(X)), X.real, X.imag]

            return lambda text: changed(text, 7, change, 17)

        for wave in ("period: 12.5663706, direction_deg: 60", "period: 11.9, direction_deg: 47"):
            motions = []
            for x, y in ((0, 0), (60, 0), (-250, 550)):
                sea = f"}}, waves: {{regular: {{height: 2, {wave}}}, ramp: 10"
                self.check((SPAR[0], SPAR[1] + sea, *SPAR[2:4], f", origin_in_file: [{x}, {y}, 0]"), moved(x, y), z=0, ending=".3")
                case = (self.folder / "case.yaml").read_text().replace("duration: 1,", "duration: 30,")
                write(self.folder, "case.yaml", case + "output: {histories: [{body: body1}]}\n")
                done = run(HAWSER, "run", "case.yaml", cwd=self.folder)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                series = Results(self.folder / "case.h5").series("body1")
                motions.append(np.column_stack([series.column(f"{what}_{axis}") for what, axes in (("position", "xyz"), ("rotation_vector", "xy")) for axis in axes]))
            largest = np.abs(motions[0]).max(axis=0)
            self.assertGreater(largest.min(), 1e-3)
            for motion in motions[1:]:
                self.assertLess((np.abs(motion - motions[0]) / largest).max(), 1e-8)

    def test_a_moment_that_nothing_balances(self):
        """The righting moment of the spar reaches 460 MN m, with linear hydrostatics; there is no line that remedies could be about."""
        self.check(SPAR[:3] + ([SPAR[3][0] + ", loads: [{moment: [0, 8e8, 0]}]"], ""))
        case = (self.folder / "case.yaml").read_text().replace("statics: false\n", "")
        write(self.folder, "case.yaml", case)
        done = run(HAWSER, "run", "case.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 3, done.stdout + done.stderr)
        self.assertIn("stiffness, hydrostatics, lines or thrusters that can balance the loads of each floating body", done.stdout)
        self.assertNotIn("between_lines", done.stdout)

    def test_damping_that_drives(self):
        """Negative damping of one degree of freedom is too small a part of all to be refused."""
        def negative(row):
            if row[0] > 0 and row[1] == row[2] == 3:
                row[4] = -row[4]

        sentence = "the radiation damping of heave is negative at most frequencies"
        text = self.check(SPAR, lambda text: changed(text, 5, negative))
        self.assertEqual(text.count(sentence), 1, text)
        self.assertNotIn("Haskind", text)
        self.assertNotIn(sentence, self.check(SPAR))

    def test_other_directions(self):
        """Directions that waves come from, and in radians."""
        def opposite(row):
            row[1] = (row[1] + 180) % 360

        def radians(row):
            row[1] = np.radians(row[1])

        self.assertIn("or its directions are those that waves come from", self.check(SPAR, lambda text: changed(text, 7, opposite), ending=".3"))
        text = self.check(SPAR, lambda text: changed(text, 7, radians), ending=".3")
        self.assertIn("files.3: its directions, up to ", text)
        self.assertIn(", are multiples of 5 deg in radians: give them in degrees", text)

    def test_files_of_one_side(self):
        """Waves from the side without rows: symmetry helps if the rows of the other side cover their mirror image."""
        def up_to(last):
            return lambda text: "".join(line + "\n" for line in text.splitlines() if float(line.split()[1]) <= last)

        def in_waves_to(direction, last, keys=""):
            water = f"{SPAR[1]}}}, waves: {{regular: {{height: 2, period: 12, direction_deg: {direction}}}, ramp: 10"
            return self.check((SPAR[0], water, *SPAR[2:4], keys), up_to(last), ending=".3")

        missing = "where 100 % of the sea's energy goes: add these directions to the files"
        symmetry = ", or give 'symmetry: port_starboard' if the sides of the body are mirror images"
        self.assertIn(missing + symmetry, in_waves_to(240, 180))
        text = in_waves_to(150, 60)
        self.assertIn(missing, text)
        self.assertNotIn("symmetry", text)
        self.assertNotIn(missing, in_waves_to(240, 180, ", symmetry: port_starboard"))

    def test_public_files(self):
        for name, of in SETS.items():
            with self.subTest(name=name):
                self.assert_only(None, self.check(of))
                if len(of[3]) == 1 and name != "hemisphere":
                    self.assert_only(CONJUGATED, self.check(of, conjugate_heave, ending=".3"))
                self.assert_only(DIVIDED, self.check(of, scaled_damping(1)))
                text = self.check(of, scaled_damping(-1))
                # Without a row of infinite frequency its estimate is impossible, which has another sentence.
                if "is negative" not in text:
                    self.assert_only(MULTIPLIED, text)


if __name__ == "__main__":
    unittest.main()
