"""Cases of platforms: messages without the third-party coefficients and, if these are available, equilibria, natural
frequencies and decays against references, and short runs."""
import os
import re
import shutil
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
from support import ROOT, run

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
DATA = ROOT.parent / "shared/data"
# Coefficient files of each case, and their names beside the case.
FILES = {
    "volturnus": ("umaine-semi", {"IEA-15-240-RWT-UMaineSemi": "IEA-15-240-RWT-UMaineSemi"}),
    "oc4": ("platforms/oc4-semi", {"marin_semi": "marin_semi", "oc4_excitation_raft_grid": "marin_semi"}),
    "fpso": ("platforms/mss-tanker", {"tanker": "tanker"}),
    "side-by-side": ("platforms/fpso-psv", {"conjunto_10": "conjunto_10"}),
}
NO_WAVES = ("--set", "environment.waves=null")
AT_REST = ("--set", "dynamics=null", *NO_WAVES)


class Cases(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / "farm").symlink_to(ROOT / "cases/farm")

    def case(self, name, data=True):
        """A copy of a case with its coefficients."""
        folder = self.folder / name
        shutil.copytree(ROOT / "cases" / name, folder, ignore=shutil.ignore_patterns("*.h5*", "*.xdmf*", "*.png"))
        if not data or name not in FILES:
            return folder / f"{name}.yaml"
        where, names = FILES[name]
        if not (DATA / where).is_dir():
            self.skipTest(f"{DATA / where} is not there")
        for file in (DATA / where).iterdir():
            stem = file.name.split(".", 1)[0]
            if stem in names and not (folder / file.name.replace(stem, names[stem])).exists():
                shutil.copy(file, folder / file.name.replace(stem, names[stem]))
        return folder / f"{name}.yaml"

    def run_case(self, path, *words):
        done = run(HAWSER, "run", path, "-q", "-o", path.with_suffix(".h5"), *words)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return h5py.File(path.with_suffix(".h5"))

    def series(self, file, name):
        data = file["series"][name]
        return file["series/time"][:], {column.decode(): data[:, k] for k, column in enumerate(data.attrs["columns"])}

    def test_sentence_without_the_files(self):
        for name in FILES:
            with self.subTest(name=name):
                path = self.case(name, data=False)
                done = run(HAWSER, "check", path)
                self.assertEqual(done.returncode, 2)
                self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
                self.assertRegex(done.stderr, rf"{name}\.yaml:\d+: bodies\.\w+\.floating\.hydrodynamics\.wamit: ")
                missing = re.search(r"(\S+)/([^/\s]+): there is no such file", done.stderr)
                self.assertIsNotNone(missing, done.stderr)
                # The README names each file by its full name or extension.
                page = (ROOT / "cases" / name / "README.md").read_text(encoding="utf-8")
                self.assertIn(missing.group(2), page)

    def test_volturnus_at_rest(self):
        """Equilibrium against a separate solution of elastic catenaries and six equations of the body:
        offsets to 0.5 % + 0.01 m, tension to 0.3 %."""
        path = self.case("volturnus")
        for force, height, x, z, pitch, tension in ((0, 0, 0, -0.01907, 0, 2434977.1), (1.5e6, 150, 15.7391, -0.05812, 0.0690004, 3598669.97),
                                                    (-2.0e6, 0, -30.31951, -0.1252, 0.010454, 1606454.71)):
            file = self.run_case(path, *AT_REST, "--set", f"bodies.semi.floating.loads=[{{force: [{force}, 0, 0], at: [0, 0, {height}]}}]")
            _, found = self.series(file, "semi")
            pull = np.linalg.norm(file["ends/force"][0, 1])
            print(f"VolturnUS-S, {force:g} N: x {found['position_x'][0]:.3f} ({x:.3f}) m, pitch {found['rotation_vector_y'][0]:.5f} ({pitch:.5f}), "
                  f"tension {pull / tension - 1:+.2e}")
            self.assertAlmostEqual(found["position_x"][0], x, delta=0.005 * abs(x) + 0.01)
            self.assertAlmostEqual(found["position_z"][0], z, delta=0.01)
            self.assertAlmostEqual(found["rotation_vector_y"][0], pitch, delta=0.005 * abs(pitch) + 1e-5)
            self.assertAlmostEqual(pull / tension, 1, delta=3e-3)

    def test_volturnus_small_decays(self):
        """Without drag, released at 0.1 m, 0.1 or 0.2 deg from rest, the platform has the periods of the
        linearised system, to 0.5 %."""
        path = self.case("volturnus")
        no_drag = [*NO_WAVES]
        for key in ("bodies.semi.floating.loads", "bodies.semi.floating.hydrodynamics.quadratic_damping",
                    "bodies.semi.floating.hydrodynamics.second_order", "volumes", "contact.volumes"):
            no_drag += ["--set", f"{key}=null"]
        no_drag += ["--set", "line_types.chain.Cd_normal=0", "--set", "line_types.chain.Cd_axial=0"]
        done = run(HAWSER, "modes", path, *no_drag, "-n", "12", "-o", path.with_name("modes.h5"))
        self.assertEqual(done.returncode, 0, done.stderr)
        modes = {name: float(period) for period, name in re.findall(r"^ *\d+ +(\S+) .*: (surge|heave|pitch)$", done.stdout, re.M)}
        modes["yaw"] = float(re.search(r"^ *\d+ +(\S+) .*: yaw$", done.stdout, re.M)[1])
        rest = self.run_case(path, *no_drag, "--set", "dynamics=null")
        _, found = self.series(rest, "semi")
        rest.close()
        place = [found[f"position_{axis}"][0] for axis in "xyz"]
        for freedom, away, turn, duration, column in (
                ("surge", [0.1, 0, 0], [0, 0, 0], 560, "position_x"), ("heave", [0, 0, 0.1], [0, 0, 0], 130, "position_z"),
                ("pitch", [0, 0, 0], [0, 0.1, 0], 200, "rotation_vector_y"), ("yaw", [0, 0, 0], [0, 0, 0.2], 380, "rotation_vector_z")):
            start = [float(a + b) for a, b in zip(place, away)]
            file = self.run_case(path, *no_drag, "--set", "statics=false", "--set", f"bodies.semi.position={start}", "--set",
                                 f"bodies.semi.rotation_deg={turn}", "--set", "bodies.semi.floating.hydrodynamics.place=[0, 0, 0]", "--set",
                                 f"dynamics={{duration: {duration}, step: 0.2, rho_infinity: 1}}", "--set",
                                 "output={every: 1000, histories: [{body: semi}]}")
            time, found = self.series(file, "semi")
            x = found[column] - np.mean(found[column][time > 0.1 * duration])
            periods = []
            for rises in ((x[:-1] < 0) & (x[1:] >= 0), (x[:-1] > 0) & (x[1:] <= 0)):
                at = time[:-1][rises] - x[:-1][rises] * np.diff(time)[rises] / np.diff(x)[rises]
                periods.append((at[-1] - at[0]) / (len(at) - 1))
            print(f"VolturnUS-S, {freedom}: {np.mean(periods):.3f} s, {modes[freedom]:.3f} s by modes")
            self.assertAlmostEqual(np.mean(periods) / modes[freedom], 1, delta=5e-3)
            file.close()

    def test_volturnus_in_the_storm(self):
        file = self.run_case(self.case("volturnus"), "--set", "dynamics.duration=60")
        _, found = self.series(file, "semi")
        self.assertGreater(np.ptp(found["position_z"]), 0.1)
        self.assertGreater(found["drift_force_x"][0], 1e5)  # the mean drift force, present in statics

    def test_volturnus_mean_in_the_storm(self):
        """In an hour of the storm without slow drift, the mean position equals the equilibrium of statics, to
        0.5 % of offset and of pitch."""
        path = self.case("volturnus")
        no_drift = ("--set", "bodies.semi.floating.hydrodynamics.second_order=null")
        file = self.run_case(path, *AT_REST, *no_drift)
        _, rest = self.series(file, "semi")
        file.close()
        file = self.run_case(path, *no_drift)
        time, found = self.series(file, "semi")
        for column in ("position_x", "rotation_vector_y"):
            mean = found[column][time > 600].mean()
            print(f"VolturnUS-S in an hour of storm, {column}: mean {mean:.5g}, at rest {rest[column][0]:.5g}, off by {mean / rest[column][0] - 1:+.2e}")
            self.assertAlmostEqual(mean / rest[column][0], 1, delta=5e-3)

    def test_oc4_frequencies(self):
        """Frequencies in surge, heave and pitch by modes and by decays equal the published 0.0093, 0.0578 and
        0.0373 Hz, within 7 %."""
        path = self.case("oc4")
        done = run(HAWSER, "modes", path, *NO_WAVES, "-n", "12", "-o", path.with_name("modes.h5"))
        self.assertEqual(done.returncode, 0, done.stderr)
        file = h5py.File(path.with_name("modes.h5"))
        body = [name.decode() for name in file["bodies/name"]].index("semi")
        move = np.abs(file["bodies/position"][1:, body] - file["bodies/position"][0, body])
        turn = np.abs(file["bodies/rotation"][1:, body])  # w, x, y, z
        frequency = np.array([float(v) for v in re.findall(r"^ *\d+ +[\d.e+-]+ +([\d.e+-]+) ", done.stdout, re.M)])
        by_modes = {"surge": frequency[move[:, 0].argmax()], "heave": frequency[move[:, 2].argmax()],
                    "pitch": frequency[turn[:, 2].argmax()]}
        starts = {"surge": ("position=[8, 0, 0]", "position_x", 300), "heave": ("position=[0, 0, 2]", "position_z", 80),
                  "pitch": ("rotation_deg=[0, 4, 0]", "rotation_vector_y", 110)}
        for freedom, published in (("surge", 0.0093), ("heave", 0.0578), ("pitch", 0.0373)):
            start, column, duration = starts[freedom]
            file = self.run_case(path, *NO_WAVES, "--set", "statics=false", "--set", f"bodies.semi.{start}", "--set",
                                 "bodies.semi.floating.hydrodynamics.place=[0, 0, 0]", "--set", f"dynamics={{duration: {duration}, step: 0.2}}")
            time, found = self.series(file, "semi")
            x = found[column] - np.mean(found[column][time > 0.1 * duration])
            up = np.flatnonzero((x[:-1] < 0) & (x[1:] >= 0))
            at = time[up] - x[up] * np.diff(time)[up] / (x[up + 1] - x[up])
            by_decay = (len(at) - 1) / (at[-1] - at[0])
            print(f"OC4 {freedom}: {by_modes[freedom]:.4f} Hz by modes, {by_decay:.4f} by a decay, {published} published")
            self.assertAlmostEqual(by_modes[freedom] / published, 1, delta=0.07)
            self.assertAlmostEqual(by_decay / published, 1, delta=0.07)

    def test_fpso(self):
        """The ship's heading is between the directions of waves, wind and current, and the storm starts from there."""
        path = self.case("fpso")
        file = self.run_case(path, "--set", "dynamics.duration=20")
        time, found = self.series(file, "fpso")
        self.assertTrue(-30 < np.degrees(found["rotation_vector_z"][0]) < 0)
        for what in ("wind", "current", "drift", "other"):
            self.assertGreater(np.hypot(found[f"{what}_force_x"][0], found[f"{what}_force_y"][0]), 1e4, what)
        self.assertLess(np.abs(found["position_x"] - found["position_x"][0]).max(), 5)
        # A run that is stopped half way and continued has the same motion, forces and tension.
        for words in (("--stop-at", "10", "-o", path.with_name("part.h5")),
                      ("--restart", path.with_name("part.h5"), "-o", path.with_name("rest.h5"))):
            done = run(HAWSER, "run", path, "-q", "--set", "dynamics.duration=20", *words)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        rest = h5py.File(path.with_name("rest.h5"))
        later = time > 10.1
        np.testing.assert_allclose(rest["series/time"][:], time[later], atol=1e-9)
        for name in ("fpso", "mooring_1", "riser_1"):
            whole, part = file["series"][name][:][later], rest["series"][name][:]
            np.testing.assert_allclose(part, whole, rtol=1e-10, atol=1e-10 * np.abs(whole).max())

    def test_ships_touch_and_rub(self):
        """Hulls that are pushed together without fenders stop each other, and friction slows the vessel."""
        path, after = self.case("side-by-side"), {}
        for friction in (0.4, 0.001):
            file = self.run_case(path, *NO_WAVES, "--set", "statics=false", "--set", "volumes.fender 1=null", "--set", "volumes.fender 2=null",
                                 "--set", "bodies.vessel.position=[0, -5.6, 0]", "--set", "bodies.vessel.floating.hydrodynamics.place=[0, -15, 0]",
                                 "--set", "bodies.vessel.floating.velocity=[0.4, 0.3, 0]", "--set", "bodies.fpso.rotation_deg=[0, 0, 0]",
                                 "--set", f"volumes.vessel hull.friction={friction}", "--set", "lines.breast 1=null", "--set", "lines.breast 2=null",
                                 "--set", "lines.spring 1=null", "--set", "lines.spring 2=null", "--set", "output.histories=[{body: fpso}, {body: vessel}]",
                                 "--set", "dynamics={duration: 12, step: 0.05}")
            _, vessel = self.series(file, "vessel")
            _, fpso = self.series(file, "fpso")
            gap = fpso["position_y"] - 27.25 - vessel["position_y"] - 10
            self.assertLess(gap.min(), 0.01)  # they met
            self.assertGreater(gap.min(), -0.3)
            after[friction] = vessel["velocity_x"][-1]
        print(f"surge of the vessel after the touch: {after[0.4]:.3f} m/s, without friction {after[0.001]:.3f} m/s")
        self.assertLess(after[0.4], after[0.001] - 0.02)

    def test_side_by_side(self):
        file = self.run_case(self.case("side-by-side"), "--set", "dynamics.duration=5")
        _, vessel = self.series(file, "vessel")
        _, fpso = self.series(file, "fpso")
        self.assertGreater((fpso["position_y"] - vessel["position_y"]).min(), 46)  # on the fenders; contact at 47.15 m

    def test_tanker_is_stopped(self):
        """Started at 0.3 m/s near the hawser, the tanker is slowed down by it, and no node penetrates its hull."""
        path = self.case("kvlcc2-adrift")
        file = self.run_case(path, "--set", "bodies.tanker.position=[0, 24, 0]", "--set", "bodies.tanker.floating.velocity=[0, 0.3, 0]",
                             "--set", "dynamics={duration: 150, step: 0.2}", "--set", "environment.wind.speed=0.1")
        _, ship = self.series(file, "tanker")
        _, stern = self.series(file, "at_the_stern")
        print(f"tanker: from 0.3 to {ship['velocity_y'][-1]:.3f} m/s, hawser {stern['effective_tension'][0] / 1e3:.0f} to "
              f"{stern['effective_tension'].max() / 1e3:.0f} kN")
        self.assertLess(ship["velocity_y"][-1], 0.15)
        self.assertGreater(stern["effective_tension"].max(), 1.5 * stern["effective_tension"][0])
        self.assertLess(file["fields/penetration"][:].max(), 0.1)  # its radius


if __name__ == "__main__":
    unittest.main()
