"""hawser responses: linear responses against six and twelve complex equations, of a spar on linear springs and, if their
files are available, of four platforms with third-party coefficients; of a spar on chains against a run in a low wave."""
import json
import shutil
import unittest

import numpy as np
import test_coupled_bodies as ships
from support import ROOT, run, write
from test_platform_references import DAMPING, HAWSER, MOORING, NONE, UMAINE, PlatformRuns, added
from test_rao import DAMPING as SPAR_DAMPING
from test_rao import STIFFNESS as SPAR_STIFFNESS
from test_rao import Reference, off, table, text_of

RANKS = ("mpirun", "--allow-run-as-root", "--oversubscribe", "-n")
# Solutions of the six equations with the coefficients of the files, computed without this program: period (for OC4 of a table of
# wave forces, between rows of the added mass), direction, amplitudes [m/m, rad/m] and phases by which the motion leads the crest [deg].
VOLTURNUS = (
    (25.13274, 0, [1.14918951, 0, 1.05890059, 0, 0.0215540267, 0], [-85.0656003, 0, -13.4961105, 0, -39.0023645, 0]),
    (17.95196, 0, [0.842597248, 0, 0.467564267, 0, 0.00266370994, 0], [-90.8387494, 0, 23.5072537, 0, -27.1169553, 0]),
    (13.96263, 0, [0.654567471, 0, 0.59190651, 0, 0.00259890428, 0], [-94.3511628, 0, 8.40534263, 0, 49.6518109, 0]),
    (10.47197, 0, [0.366944698, 0, 0.425241814, 0, 0.00458827328, 0], [-113.403179, 0, 1.03654235, 0, 80.0472799, 0]),
    (6.981316, 0, [0.225206185, 0, 0.0803854344, 0, 0.00192145319, 0], [166.901331, 0, -43.0180867, 0, 81.7742689, 0]),
    (25.13274, 30, [1.00215717, 0.600493426, 1.05888515, 0.0113759161, 0.0181559785, 0.000375451852],
     [-85.1550368, -85.9459259, -13.2252426, 98.9513933, -45.4200346, -89.9972891]),
    (17.95196, 30, [0.730124756, 0.424067896, 0.46674056, 0.00196738441, 0.00171563021, 0.000934729858],
     [-89.847879, -86.4685508, 20.4870716, 28.7450328, -41.5553216, -89.997504]),
    (13.96263, 30, [0.566368589, 0.332725707, 0.589692855, 0.00182823346, 0.00187842324, 0.00212497172],
     [-91.128072, -83.2563887, 6.37102147, -27.733157, 64.2037895, -89.9976363]),
    (10.47197, 30, [0.299079465, 0.194238853, 0.411015848, 0.00264103544, 0.00404246992, 0.00483479398],
     [-96.744255, -77.3501114, -0.359887165, -71.8685221, 84.3122297, -89.9806764]),
    (6.981316, 30, [0.0332711938, 0.0517303203, 0.0451185204, 0.00189316767, 0.00158206444, 0.00583022342],
     [-96.8641224, -37.7502903, -3.18006022, -162.250334, 97.1799197, -90.6263914]))
OC4 = (
    (25.0, 0, [2.17768271, 0, 1.0860154, 0, 0.0962296622, 0], [-87.6649527, 0, -0.0225966179, 0, -85.1771318, 0]),
    (16.6666667, 0, [0.824778812, 0, 1.80908865, 0, 0.00151156418, 0], [-90.3718209, 0, -178.986065, 0, 82.7629274, 0]),
    (12.5, 0, [0.610537235, 0, 0.266622665, 0, 0.00513633862, 0], [-92.5529331, 0, -0.431009439, 0, 96.3409026, 0]),
    (10.0, 0, [0.394288031, 0, 0.215734404, 0, 0.0063343269, 0], [-99.9164741, 0, -6.22413153, 0, 103.359708, 0]),
    (7.14285714, 0, [0.159135207, 0, 0.0535838082, 0, 0.00368392394, 0], [-177.412684, 0, -97.047846, 0, 128.03922, 0]),
    (25.0, 40, [1.66698126, 1.39052056, 1.08600419, 0.0611790214, 0.0734747902, 0.00017451804],
     [-89.4332937, -93.4666982, 0.00531496301, 82.7406364, -88.8660762, -90.0047675]),
    (16.6666667, 40, [0.631850726, 0.530345352, 1.80856989, 0.000979591487, 0.00114908776, 0.000546531496],
     [-89.9361749, -89.5052761, -178.777404, -79.1903674, 88.6137767, -89.9900194]),
    (12.5, 40, [0.467971685, 0.394610452, 0.265553334, 0.0033362049, 0.00391507904, 0.00142828435],
     [-89.752302, -86.9160786, 0.952936831, -99.8811199, 91.9297039, -89.9547065]),
    (10.0, 40, [0.30281233, 0.267297768, 0.206273283, 0.00429174739, 0.00474890225, 0.00280067663],
     [-88.7092243, -80.2951458, 0.429199572, -110.311818, 94.5198165, -89.861793]),
    (7.14285714, 40, [0.0414075576, 0.0520115096, 0.0368208082, 0.00331142703, 0.0023482888, 0.00569327245],
     [-26.4088136, -40.6900143, 90.3504346, -133.823185, 113.320641, -90.7384472]))
TANKER = (
    (7.86, 180, [0.0386013405, 0, 0.0760712913, 0, 0.00143206232, 0], [82.3765164, 0, -125.755903, 0, 66.3659361, 0]),
    (7.86, 120, [0.029690305, 0.0285713269, 0.0605936685, 0.00356925568, 0.00327488433, 0.00196265235],
     [-71.9062154, 139.93946, 85.0769816, -78.6112862, -143.336489, 42.0965755]),
    (10.44, 180, [0.0606382029, 0, 0.264350778, 0, 0.00346926068, 0], [-98.2906748, 0, 129.248647, 0, -53.3833138, 0]),
    (10.44, 120, [0.194893895, 0.225590525, 0.61210729, 0.00857545028, 0.0127572617, 0.00584451219],
     [89.7582738, -75.8919987, -2.9494964, 84.2283512, -107.920532, 6.25476299]),
    (13.91, 180, [0.3529407, 0, 0.326828623, 0, 0.0114427501, 0], [95.2376387, 0, 19.4528622, 0, -98.0228088, 0]),
    (13.91, 120, [0.372586346, 0.676605716, 0.82960492, 0.0392739853, 0.00943495697, 0.00589318707],
     [91.9182012, -95.6576665, 1.52338558, -120.626152, -96.1907452, 1.98112949]))
# Of two ships: period, direction, the FPSO's and the vessel's six.
PAIR = (
    (8, 90, [0.0172187082, 0.262481168, 0.129081421, 0.0033806152, 0.00135742698, 0.000175786772,
             0.059760213, 0.819718587, 1.42049599, 0.224681899, 0.00869916521, 0.00802848388],
     [-106.085707, -174.970947, 166.535547, 8.37947457, 170.036499, 117.70665, -113.704137, -4.53449028, 3.79984723, -151.706881, 150.234915, 4.3370986]),
    (10, 90, [0.0526080147, 0.448331772, 0.490065636, 0.00832321285, 0.00534665944, 0.000213443855,
              0.114814597, 0.516231234, 1.99622629, 0.0491361792, 0.00667839281, 0.000937039298],
     [-16.2010841, -150.832848, -159.861698, 36.34925, -109.842017, -173.476529, -112.403327, 8.62654923, 15.0871888, -3.98203633, 98.8998041, 6.4075231]),
    (12, 90, [0.0515301829, 0.562082789, 1.54867881, 0.0179697283, 0.00693798044, 0.000313865615,
              0.162359009, 0.666174364, 2.0773125, 0.0344521064, 0.00718171273, 0.00197454287],
     [97.8098342, -134.50412, -115.9267, 57.558603, 17.3350794, -142.354475, 100.010211, -127.840067, 55.4080946, -129.536482, -97.0705476, 169.06955]),
    (15, 180, [0.185637947, 0.000189520775, 0.333897334, 1.49109349e-05, 0.00829559261, 8.1090528e-07,
               0.831663629, 0.0630537171, 0.950697366, 0.00193257553, 0.0166784108, 0.000727261538],
     [98.0053959, 139.016913, 28.2257098, 58.4862669, -109.145057, 128.742859, 87.8219722, 137.005971, 5.51362213, 136.71163, -99.113581, -30.1464286]))


def spar(place="[0, 0, 0]", heading=0.0):
    return (f"  spar: {{position: {place}, rotation_deg: [0, 0, {heading}], floating: {{mass: 2.8e7, centre_of_mass: [0, 0, -54], "
            f"inertia: [4.5e10, 4.5e10, 1.5e9],\n    hydrodynamics: {{wamit: spar, displaced_volume: 27317.07317, follow_period: 0"
            f"{added(SPAR_DAMPING, SPAR_STIFFNESS)}}}}}}}\n")


def semi(stem, mass, centre, coupling, inertia, damping, stiffness):
    """A body with its mass matrix about the origin, where `coupling` is that of surge and pitch."""
    M = np.diag([mass, mass, mass, *inertia])
    M[0, 4] = M[4, 0] = coupling
    M[1, 3] = M[3, 1] = -coupling
    return (f"  semi: {{position: [0, 0, 0], floating: {{mass: {mass}, centre_of_mass: [0, 0, {centre}], mass_matrix: {{rows: {json.dumps(M.tolist())}}},\n"
            f"         hydrodynamics: {{wamit: {stem}, place: [0, 0, 0], heading_deg: 0, follow_period: 0{added(damping, stiffness)}}}}}}}\n")


def solve(M, A, B, C, extra_damping, period, force):
    """Responses with the coefficients of a file at a period, and with those that the program makes of them: symmetric, and B
    without negative eigenvalues in the metric of the largest added mass."""
    scale = np.sqrt(np.max([np.abs(np.diag(of)) for of in A.values()], axis=0))
    values, vectors = np.linalg.eigh(0.5 * (B[period] + B[period].T) / np.outer(scale, scale))
    passive = np.outer(scale, scale) * ((vectors * np.maximum(values, 0)) @ vectors.T)
    omega = 2 * np.pi / period
    return [np.linalg.solve(-omega**2 * (M + added_mass) + 1j * omega * (damping + extra_damping) + C, force)
            for added_mass, damping in ((A[period], B[period]), (0.5 * (A[period] + A[period].T), passive))]


class Responses(PlatformRuns):
    def responses(self, bodies=None, *words, ranks=1, file="case-responses.csv", **how):
        """Complex responses by (period, direction) in the table of a case."""
        if bodies:
            self.case(bodies, **how)
        done = run(*((*RANKS, str(ranks)) if ranks > 1 else ()), HAWSER, "responses", "case.yaml", *words, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.printed = done.stdout
        omega, direction, values, explained = table(self.folder / file)
        np.testing.assert_array_equal(explained, 1)
        return {(float(f"{2 * np.pi / w:.8g}"), d): x for w, d, x in zip(omega, direction, values)}

    def agree(self, what, found, known, tolerance):
        worst = max(off(found[period, direction], size * np.exp(1j * np.radians(lead))) for period, direction, size, lead in known)
        print(f"{what}: off by {worst:.1e} of the largest of its kind")
        self.assertLess(worst, tolerance)

    def spar_files(self):
        for ending in (".1", ".3", ".hst"):
            shutil.copy(ROOT / f"docs/tutorial/spar{ending}", self.folder)
        return Reference(self.folder / "spar", 2.8e7, -54.0, [4.5e10, 4.5e10, 1.5e9], SPAR_DAMPING, SPAR_STIFFNESS)

    def test_spar(self):
        """All periods and directions of the files, for a spar that is displaced and rotated, on 1 and 2 ranks: 1e-6. A point
        moves by the rotations about the origin."""
        exact = self.spar_files()
        found = self.responses(spar("[300, -200, 0]", 50))
        self.assertEqual(len(found), 50 * 12)
        self.assertIn("these are 16 of the 600 rows of the table", self.printed)
        worst = max(off(x, exact.at(2 * np.pi / period, direction % 360)) for (period, direction), x in found.items())
        print(f"spar on springs: off by {worst:.1e}")
        self.assertLess(worst, 1e-6)
        again = self.responses(None, "--periods", "12.5663706,9", "--directions", "110,-10", ranks=2)
        self.assertEqual(sorted(again), [(9, -60), (9, 60), (12.566371, -60), (12.566371, 60)])
        np.testing.assert_allclose(again[12.566371, 60], found[12.566371, 60], rtol=1e-8)
        self.assertLess(off(again[9, -60], exact.at(2 * np.pi / 9, 300)), 1e-6)
        r = np.array([3.0, 20.0, -54.0])
        moved = self.responses(None, "--periods", "9", "--directions", "110", "--at", "3,20,-54", "-o", "point.csv", file="point.csv")[9, 60]
        expected = again[9, 60].copy()
        expected[:3] += np.cross(expected[3:], r)
        self.assertLess(off(moved, expected), 1e-8)

    def test_farm(self):
        """Two spars at different places with different headings: each responds as if alone, relative to its own bow and to
        the crest at its origin, on 1, 2 and 3 ranks."""
        exact = self.spar_files()
        water = "hawser: 1\nenvironment: {water: {density: 1025, depth: 200}}\n"
        write(self.folder, "platform.yaml", f"{water}bodies:\n{spar()}")
        write(self.folder, "case.yaml", f"{water}farm: {{of: platform.yaml, at: {{one: [0, 0, 30], two: [1000, 700, -60]}}}}\n")
        for ranks in (1, 2, 3):
            for body, direction in (("one", 30), ("two", 120)):
                found = self.responses(None, "--periods", "12", "--directions", "60", ranks=ranks, file=f"case-responses-{body}-spar.csv")
                self.assertLess(off(found[12, direction], exact.at(2 * np.pi / 12, direction)), 1e-6)
        found = self.responses(None, "--periods", "12", "--directions", "60", "--body", "two/spar", "-o", "two.csv", file="two.csv")
        self.assertEqual(list(found), [(12, 120)])
        with open(self.folder / "case.yaml", "a", encoding="utf-8") as file:
            file.write("bodies:\n" + spar("[0, 3000, 0]").replace("  spar:", "  one-spar:"))
        done = run(HAWSER, "responses", "case.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("two bodies would have the same table", done.stderr)

    def test_spar_on_chains(self):
        """The moored spar of the tutorial without quadratic damping, with chains of its mass, in a wave of 5 cm: amplitudes
        and phases of its run within 0.5 % of the largest of their kind."""
        self.spar_files()
        shutil.copy(ROOT / "docs/tutorial/platform-1.yaml", self.folder / "case.yaml")
        damping = "bodies.spar.floating.hydrodynamics.quadratic_damping=[0,0,0,0,0,0]"
        linear = f"bodies.spar.floating.hydrodynamics.damping={json.dumps(SPAR_DAMPING.tolist())}"
        found = self.responses(None, "--periods", "12", "--directions", "0", "--set", damping, "--set", linear)[12, 0]
        done = run(HAWSER, "run", "case.yaml", "--set", damping, "--set", linear, "--set",
                   "environment.waves={regular: {height: 0.1, period: 12}, ramp: 60}", "--set",
                   "dynamics={duration: 600, step: 0.1, rho_infinity: 1}", "-q", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        done = run(HAWSER, "rao", "case.h5", "--since", "300", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        _, _, of_run, _ = table(self.folder / "case-rao.csv")
        print(f"spar on chains: off by {off(found, of_run[0]):.1e} of its run")
        self.assertLess(off(found, of_run[0]), 5e-3)

    def test_table_for_other_commands(self):
        """`hawser rao` draws the table and writes it in the form for `motion.rao`."""
        self.spar_files()
        found = self.responses(spar())
        write(self.folder, "spar.png", "of the user")
        for words in ((), ("-o", "spar.rao")):
            done = run(HAWSER, "rao", "case-responses.csv", *words, cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertGreater((self.folder / "case-responses.png").stat().st_size, 10000)
        self.assertEqual((self.folder / "spar.png").read_text(), "of the user")
        done = run(HAWSER, "rao", "case-responses.csv", "case-responses.csv", cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("is there twice", done.stderr)
        rows = np.loadtxt(self.folder / "spar.rao")
        self.assertEqual(rows.shape, (600, 14))
        for row in rows[::50]:
            value = row[2::2] * np.repeat([1, np.pi / 180], 3) * np.exp(-1j * np.radians(row[3::2]))
            nearest = min(found, key=lambda key: abs(key[0] / row[0] - 1) + abs(key[1] - row[1]))
            self.assertLess(off(value, found[nearest]), 1e-5)
        write(self.folder, "other.csv", "a,b\n1,2\n")
        done = run(HAWSER, "rao", "other.csv", cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("is not a table of responses", done.stderr)

    def test_volturnus(self):
        """Moored VolturnUS-S with external damping: 1e-6."""
        self.umaine()
        found = self.responses(semi(UMAINE, 2.01e7, -2.32, -4.66e7, [4.26e10, 4.26e10, 2.37e10], DAMPING, MOORING))
        self.agree("VolturnUS-S", found, VOLTURNUS, 1e-6)

    def test_oc4(self):
        """Moored OC4 DeepCwind, whose wave forces have other periods than its added mass: 1e-6. These periods are those of
        multiples of 0.005 Hz, rounded in the file, as which the reference uses them."""
        self.oc4_files()
        rows = [line.split(maxsplit=1) for line in text_of(self.folder / "oc4", ".3")]
        (self.folder / "oc4.3.gz").unlink()
        write(self.folder, "oc4.3", "".join(f"{200 / round(200 / float(period)):.15g} {rest}\n" for period, rest in rows))
        periods = ",".join(f"{200 / round(200 / row[0]):.15g}" for row in OC4[:5])
        mooring = np.diag([70836.0451, 70836.0451, 19140.4695, 87240749.8, 87240749.8, 116970167.0])
        mooring[0, 4] = mooring[4, 0] = -107232.04
        mooring[1, 3] = mooring[3, 1] = 107232.04
        mass, coupling = 14072645.6, -139177890.0
        body = semi("oc4", mass, coupling / mass, coupling, [12700184000.0, 12690971000.0, 12288048500.0], NONE, mooring)
        found = self.responses(body, "--periods", periods, "--directions", "0,40")
        known = [(min(found, key=lambda key: abs(key[0] - row[0]))[0], *row[1:]) for row in OC4]
        self.agree("OC4", found, known, 1e-6)

    def test_tanker(self):
        """Tanker with the mass matrix of its .frc: 1e-6 with symmetric coefficients. Those of the file differ from their
        transposes, which changes roll by 1.4e-3. The moment of the weight about the centre of buoyancy, which C46 of the
        file has, is balanced."""
        mass, damping = self.tanker()
        ship = ("  semi: {position: [0, 0, 0], floating: {mass: 94620210, centre_of_mass: [3.93, 0, 2.5], "
                f"mass_matrix: {{rows: {json.dumps(mass.tolist())}}}, loads: [{{moment: [0, {-374.607 * 1025 * 9.81}, 0]}}],\n"
                "         hydrodynamics: {wamit: tanker, follow_period: 0, place: [0, 0, 0], heading_deg: 0, symmetry: port_starboard, "
                f"gravity_in_stiffness: true{added(damping, NONE)}}}}}}}\n")
        found = self.responses(ship, gravity=9.81, water="density: 1025")
        C = np.zeros((6, 6))
        for line in text_of(self.folder / "tanker", ".hst"):
            i, j, value = line.split()
            C[int(i) - 1, int(j) - 1] = 1025 * 9.81 * float(value)
        A, B = {}, {}
        for line in text_of(self.folder / "tanker", ".1"):
            r = [float(v) for v in line.split()]
            for of, value in ((A, r[3]), (B, r[-1] * 2 * np.pi / max(r[0], 1e-9))):
                of.setdefault(r[0], np.zeros((6, 6)))[int(r[1]) - 1, int(r[2]) - 1] = 1025 * value
        X = {}
        for line in text_of(self.folder / "tanker", ".3"):
            r = [float(v) for v in line.split()]
            X.setdefault((r[0], r[1]), np.zeros(6, complex))[int(r[2]) - 1] = 1025 * 9.81 * complex(r[5], r[6])
        for period, direction, size, lead in TANKER:
            of_file, symmetric = solve(mass, A, B, C, damping, period, X[period, direction])
            own, known = found[period, direction], size * np.exp(1j * np.radians(lead))
            print(f"tanker, {period} s to {direction} deg: off by {off(own, symmetric):.1e}, with the file's own coefficients {off(own, known):.1e}")
            self.assertLess(off(of_file, known), 1e-6)
            self.assertLess(off(own, symmetric), 1e-6)
            self.assertLess(off(own, known), 2e-3)

    def test_two_ships(self):
        """FPSO and supply vessel side by side, twelve equations. With symmetric coefficients, which the program makes them,
        1e-6; the files' own differ from their transposes, and so do the responses."""
        A, B, X, C = ships.CoupledBodies.ships(self)
        C[3, 5], C[9, 11] = (c * ships.DENSITY * ships.GRAVITY for c in (-105370, 228.09))
        with open(self.folder / "pair.hst", "a", encoding="utf-8") as file:
            file.write("4 6 -105370\n10 12 228.09\n")
        text = ships.CoupledBodies.case_of_ships(self, "", 1).replace(", waves: ", "").replace("statics: false\n", "")
        for number, row, column in ((1, 3, 5), (2, 9, 11)):  # the weight is not above the centre of buoyancy
            text = text.replace(f"hydrodynamics: {{wamit: pair, body: {number},",
                                f"loads: [{{moment: [0, {-C[row, column]}, 0]}}],\n    hydrodynamics: {{wamit: pair, body: {number},")
        write(self.folder, "case.yaml", text)
        found = [self.responses(file=f"case-responses-{body}.csv") for body in ("fpso", "vessel")]
        M, damping = np.diag(sum(ships.MASSES, [])), np.diag([0, 0, 0, ships.ROLL[0], 0, 0, 0, 0, 0, ships.ROLL[1], 0, 0])

        def off_both(one, two):
            return max(off(one[:6], two[:6]), off(one[6:], two[6:]))

        for period, direction, size, lead in PAIR:
            known = size * np.exp(1j * np.radians(lead))
            own = np.concatenate([of_body[period, direction] for of_body in found])
            of_file, symmetric = solve(M, A, B, C, damping, period, X[period, direction])
            print(f"two ships, {period} s to {direction} deg: off by {off_both(own, symmetric):.1e}, with the files' own coefficients {off_both(own, known):.1e}")
            self.assertLess(off_both(of_file, known), 1e-6)
            self.assertLess(off_both(own, symmetric), 1e-6)
            self.assertLess(off_both(own, known), 1e-2)

    def test_sentences(self):
        self.spar_files()
        buoy = "  buoy: {position: [100, 0, 0], floating: {mass: 1000, inertia: [1000, 1000, 1000], stiffness: [1e4, 1e4, 1e4], turning_stiffness: [1e4, 1e4, 1e4]}}\n"
        for bodies, end, words, complaint in (
                (spar(), "statics: false\ndynamics: {duration: 1, step: 0.1}", (), "responses need the static equilibrium"),
                (buoy, "", (), "no body has wave forces by coefficients"),
                (spar().replace("wamit: spar", "wamit: spar, excitation: false"), "", (), "no body has wave forces by coefficients"),
                (spar(), "", ("--body", "ship"), "there is no floating body 'ship', but spar"),
                (spar(), "", ("--periods", "1.5"), "--periods: the coefficients are those of 2.094 to 125.7 s, not of 1.5 s"),
                (spar(), "", ("--periods", "a"), "--periods 'a': give numbers separated by commas"),
                (spar(), "", ("--periods", "0"), "--periods 0: give periods above 0"),
                (spar(), "", ("--periods", ""), "--periods '': give numbers separated by commas"),
                (spar(), "", ("--directions", "400"), "--directions 400: give directions from -360 to 360"),
                (spar(), "", ("-o", "none/table.csv"), "there is no folder"),
                (spar().replace("floating: {mass", "floating: {positioning: {place: [0, 0, 0], heading_deg: 0, proportional: [4e5, 4e5, 2e9], derivative: [1e7, 1e7, 8e10], filter_period: 50}, mass"), "", (),
                 "bodies.spar.floating.positioning: responses do not include the filter of thrusters"),
                (spar(), "", ("--directions", "0,,3"), "give numbers separated by commas"),
                (spar(), "", ("--at", "1,2"), "give three numbers separated by commas"),
                (spar(), "", ("-o", "table.txt"), "a table of responses is a CSV file"),
                (spar(), "", ("-o", "table.rao"), "'hawser rao' makes a table for motion.rao of it"),
                (spar(), "", ("-o", "old.csv"), "the file there is not a table of responses")):
            with self.subTest(complaint=complaint):
                write(self.folder, "old.csv", "something else\n")
                self.case(bodies, end=end)
                done = run(HAWSER, "responses", "case.yaml", *words, cwd=self.folder)
                self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
                self.assertIn(complaint, done.stderr)
                self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        again = self.responses(spar(), "--periods", "12,12", "--directions", "0,90,360,-270")
        self.assertEqual(list(again), [(12, 0), (12, 90)])
        self.responses(spar().replace("wamit: spar", "wamit: spar, quadratic_damping: [0, 0, 1e6, 0, 0, 0]"), "--periods", "9")
        self.assertIn("note: responses are those to low waves, without the quadratic damping and drag of body spar: near", self.printed)
        members = "floating: {members: [{from: [0, 0, -100], to: [0, 0, -10], diameter: 1, Ca: 0}], mass"
        self.responses(spar().replace("floating: {mass", members), "--periods", "9")
        self.assertIn("note: responses have the wave forces of coefficients only, not those on members, hulls and lines: spar", self.printed)
        lines = [line for line in (ROOT / "docs/tutorial/spar.3").read_text().splitlines() if line.split()[1] in ("0", "30")]
        write(self.folder, "spar.3", "\n".join(lines) + "\n")
        self.case(spar())
        done = run(HAWSER, "responses", "case.yaml", "--directions", "90", cwd=self.folder)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertIn("the files of body spar have no wave forces near 90 deg as seen from its bow", done.stderr)


if __name__ == "__main__":
    unittest.main()
