"""Messages and exit codes of the program for impossible cases and solver failures."""
import os
import shutil
import tempfile
import unittest
from pathlib import Path

from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
CASE = """\
hawser: 1
title: a cantilever
line_types:
  rod: {outer_diameter: 0.1, mass_per_length: 20, EA: 2.0e7, EI: 3.0e4, GJ: 3.0e4}
lines:
  rod:
    sections: [{type: rod, length: 12, elements: 8}]
    end_a: {anchor: [0, 0, 0], direction: [1, 0, 0], clamped: true}
    end_b: free
    start: straight
dynamics: {duration: 0.2, step: 0.05}
output: {every: 0.1}
"""
# Cases that the solver cannot solve: replaced parts of the case, exit code, parts of the message.
SECTION, STEP = "elements: 8}]", "step: 0.05"
UNSOLVABLE = [
    ({SECTION: SECTION + "\n    loads: [{per_length: [0, 0, 1.0e9]}]"}, "statics: {max_iterations: 3, relaxation_steps: 50}",
     ["statics", "line rod, arc length", "out of balance by"]),
    ({SECTION: SECTION + "\n    loads: [{at: 6, force: [0, 1.0e8, 0], ramp: 0.1}]", STEP: STEP + ", min_step: 0.05"}, "",
     ["stopped at t = ", "the shortest step", "Newton's iteration does not converge", "line rod, arc length"]),
    ({SECTION: SECTION + "\n    loads: [{at: 6, force: [0, 1.0e12, 0], ramp: 0.1}]"}, "",
     ["at t = ", "line rod, arc length", "is stretched by", "'ramp'?"]),
]


PIPE = """\
hawser: 1
environment: {gravity: 9.80665}
line_types:
  pipe: {pipe: {outer_diameter: 0.25, wall_thickness: 0.015, material: {E: 212 GPa, density: 7850, poisson: 0.293}}}
supports:
  ramp:
    path: {from: [0, 0, 9], direction: [-1, 0, 0], segments: [{length: 20}]}
    boxes:
      - {at: [5, 10, 15], type: flat, roller_diameter: 0.4, roller_length: 2, normal_stiffness: 1.0e7}
lines:
  pipe:
    sections: [{type: pipe, length: 22, element_length: 0.5}]
    end_a: {anchor: [0, 0, 9.325], direction: [-1, 0, 0], clamped: true}
    end_b: {anchor: [-22, 0, 9.325], direction: [-1, 0, 0], clamped: true}
contact: {between_lines: false}
"""


class Messages(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        write(self.folder, "rod.yaml", CASE)

    def hawser(self, *arguments, ranks=0):
        launch = ["mpirun", "-n", ranks, HAWSER] if ranks else [HAWSER]
        return run(*launch, *arguments, cwd=self.folder, timeout=300, env={**os.environ, "OMPI_MCA_odls_base_sigkill_timeout": "0"})

    def test_end_clamped_against_its_line(self):
        hang = CASE.replace("    start: straight\n", "")
        turned = "end_b: {anchor: [9, 0, 0], direction: [-1, 0, 1], clamped: true}"
        for direction, found in (("[-1, 0, 1]", 0), ("[1, 0, 1]", 0), ("[0, 0, -1]", 1)):
            end = turned.replace("[-1, 0, 1]", direction)
            write(self.folder, "rod.yaml", hang.replace("end_b: free", end).replace("dynamics: {duration: 0.2, step: 0.05}\n", ""))
            output = self.hawser("run", "rod.yaml").stdout
            with self.subTest(direction=direction):
                self.assertEqual(output.count("lines.rod.end_b.direction: the line would have to turn by "), found, output)
        self.assertIn("degrees to have this direction at end B: at both ends the direction is the tangent from end A to end B; is [0, 0, 1] meant?", output)

    def test_beam_that_folds(self):
        whip = """\
hawser: 1
environment: {gravity: 0}
line_types:
  whip: {outer_diameter: 0.05, mass_per_length: 5, EA: 100 MN, EI: 2 kN m2, GJ: 1.5 kN m2}
bodies:
  hub: {motion: {rotation: {axis: [0, 0, 1], rate: 6}, ramp: 5}}
statics: false
lines:
  whip:
    sections: [{type: whip, length: 20, elements: 20}]
    end_a: {body: hub, at: [0, 0, 0], clamped: true, direction: [1, 0, 0]}
    end_b: free
    start: {points: [[0, 0, 0], [20, 0, 0]]}
contact: {between_lines: false}
dynamics: {duration: 12, step: 0.05, min_step: 0.05}
"""
        write(self.folder, "rod.yaml", whip)
        result = self.hawser("run", "rod.yaml")
        self.assertEqual(result.returncode, 3, result.stdout + result.stderr)
        self.assertRegex(result.stderr, r"stopped at t = .*; line whip, arc length \d+ m, is bent by \d+ degrees within an element "
                         r"of 1 m: elements of 0\.\d+ m would resolve that; if it should not fold, a slower motion, 'EI' or "
                         r"'stiffness_damping' prevents it")

    def test_beam_that_is_rolled_up(self):
        """The ends of the beam rotate against each other by more than half a turn, which an element
        interprets as a smaller rotation in the other direction."""
        wheel = "bodies:\n  wheel: {position: [12, 0, 0], motion: {rotation: {axis: [0, 1, 0], rate: 1}, ramp: 1}}\nlines:"
        roll = CASE.replace("lines:", wheel).replace("elements: 8", "elements: 1").replace("duration: 0.2", "duration: 6")
        roll = roll.replace("end_b: free", "end_b: {body: wheel, at: [0, 0, 0], direction: [1, 0, 0], clamped: true}")
        write(self.folder, "rod.yaml", roll)
        result = self.hawser("run", "rod.yaml")
        self.assertEqual(result.returncode, 3, result.stdout + result.stderr)
        self.assertRegex(result.stderr, r"stopped at t = 3\.\d+ s: .*line rod, arc length 0 m, a beam element folds: its ends turn "
                         r"against each other by more than half a turn; line rod, arc length 0 m, is bent by 1\d\d degrees")

    @unittest.skipUnless(os.environ.get("HAWSER_FULL"), "takes half a minute; set HAWSER_FULL to run it")
    def test_statics_that_goes_on(self):
        """A slack chain over a cliff, which folds onto itself."""
        (self.folder / "cliff.xyz").write_text("".join(
            f"{x} {y} {-100 if x < 0 else -90}\n" for x in range(-200, 201, 10) for y in (-50, 50)))
        write(self.folder, "rod.yaml", """\
hawser: 1
environment: {water: {depth: 100}, seabed: {grid: {file: cliff.xyz}, friction: 0.5, normal_stiffness: {per_area: 1 MN/m3}}}
line_types:
  chain: {outer_diameter: 0.2, mass_per_length: 200, EA: 500 MN, bending: false}
lines:
  chain:
    sections: [{type: chain, length: 344, elements: 43}]
    end_a: free
    end_b: {anchor: [160, 0, -90]}
    start: {points: [[-170, 0, -99.5], [-10.5, 0, -98.8], [0, 0, -88.8], [160, 0, -89.8]]}
""")
        messages = "note: statics has not come to rest in 500 steps of dynamic relaxation; if folds of slack lines touch one " \
               "another, 'contact: {between_lines: false}' excludes that contact and may help\n"
        self.assertEqual(self.hawser("run", "rod.yaml").stdout.count(messages), 1)
        alone = self.hawser("run", "rod.yaml", "--set", "contact.between_lines=false")
        self.assertEqual(alone.returncode, 0, alone.stderr)
        self.assertNotIn("has not come to rest", alone.stdout)

    def test_no_impact_without_tension(self):
        write(self.folder, "rod.yaml", """\
hawser: 1
environment: {water: {depth: 1000}}
line_types:
  wire: {outer_diameter: 0.05, mass_per_length: 8, EA: 100 MN, bending: false}
lines:
  wire:
    sections: [{type: wire, length: 60, elements: 30}]
    end_a: free
    end_b: free
    start: {points: [[0, 0, -100], [60, 0, -100]]}
statics: false
dynamics: {duration: 20}
""")
        result = self.hawser("run", "rod.yaml")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertNotIn("warning", result.stdout)

    def test_elements_that_miss_the_current(self):
        text = """\
hawser: 1
environment:
  water: {depth: 100}
  current: {profile: [{depth: 0, speed: 0.2}, {depth: 44, speed: 0.2}, {depth: 46, speed: 1}, {depth: 48, speed: 0.2}]}
line_types: {cable: {outer_diameter: 0.3, mass_per_length: 200, EA: 100 MN, bending: false}}
lines:
  cable: {sections: [{type: cable, length: 99.8, elements: 10}], end_a: {anchor: [0, 0, -100]}, end_b: {anchor: [0, 0, 0]}}
"""
        messages = "warning: line cable has elements of 9.98 m at arc length 54.89 m"
        write(self.folder, "coarse.yaml", text)
        write(self.folder, "fine.yaml", text.replace("elements: 10", "elements: 400"))
        for command in "run", "check":
            coarse, fine = (run(HAWSER, command, self.folder / f"{name}.yaml") for name in ("coarse", "fine"))
            self.assertEqual((coarse.returncode, fine.returncode), (0, 0), coarse.stderr + fine.stderr)
            self.assertIn(messages, coarse.stdout)
            self.assertNotIn("warning", fine.stdout)

    def test_lines_that_start_in_one_another(self):
        line = """  {}:
    sections: [{{type: wire, length: 20, elements: 20}}]
    end_a: {{anchor: [0, 0, 0]}}
    end_b: {{anchor: [18, 0, 0]}}
"""
        write(self.folder, "rod.yaml", "hawser: 1\nline_types:\n  wire: {outer_diameter: 0.04, mass_per_length: 1, EA: 10 MN, "
              "bending: false}\nlines:\n" + line.format("one") + line.format("other"))
        result = self.hawser("run", "rod.yaml")
        self.assertEqual(result.returncode, 2, result.stdout)
        self.assertIn("lines.other: it has the same ends and length as line 'one', so they would start in the same place",
                      result.stderr)
        result = self.hawser("run", "rod.yaml", "--set", "contact.between_lines.exclude=[[one, other]]")
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_supports_that_carry_nothing(self):
        roller = "type: flat, roller_diameter: 0.4, roller_length: 2, normal_stiffness: 1.0e7}"
        low = PIPE.replace("at: [5, 10, 15], " + roller, "at: [5, 15], " + roller + "\n      - {at: [10], above_path: -3, " + roller)
        for name, text, expected in (
                ("well", PIPE, []),
                ("low", low, ["warning: support ramp 2 never carries line pipe, which passes 3 m above it and lies on supports further on: raise it by 'above_path', or remove it"]),
                ("below", PIPE.replace("from: [0, 0, 9]", "from: [0, 0, 5]"),
                 ["warning: none of its supports ever carries line pipe: are they too low, or beside the line?"])):
            write(self.folder, f"{name}.yaml", text)
            result = self.hawser("run", f"{name}.yaml")
            with self.subTest(case=name):
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertEqual([line for line in result.stdout.splitlines() if line.startswith("warning")], expected)

    def test_failing_statics_reports_what_may_help(self):
        write(self.folder, "slack.yaml", """\
hawser: 1
environment: {water: {depth: 100}, seabed: {depth: 100}, current: {speed: 1}}
line_types: {c: {library: chain-studless, diameter: 60 mm, grade: R3}}
lines:
  a: {sections: [{type: c, length: 260, elements: 52}], end_a: {anchor: [220, 0, -100]}, end_b: {anchor: [0, 0, 0]}}
statics: {max_iterations: 1, dynamic_relaxation: never}
dynamics: {duration: 1}
""")
        output = self.hawser("run", "slack.yaml")
        self.assertEqual(output.returncode, 3, output.stdout + output.stderr)
        self.assertIn("note: statics has failed; what may help: without 'dynamic_relaxation: never'; a 'ramp' of the current",
                      output.stdout)

    def test_check_of_a_body_that_floats(self):
        write(self.folder, "body.yaml", """\
hawser: 1
environment: {water: {depth: 100}}
bodies:
  buoy: {floating: {mass: 60000, inertia: [2.0e5, 2.0e5, 2.0e5], weight: true, in_water: {volume: 200, height: 6}}}
  held: {floating: {mass: 6000, inertia: [2.0e4, 2.0e4, 2.0e4], stiffness: [1.0e4, 1.0e4, 1.0e4]}, motion: {velocity: [1, 0, 0]}}
  fixed: {}
dynamics: {duration: 1}
""")
        output = self.hawser("check", "--quick", "body.yaml").stdout
        for part in ("buoy: at (0, 0, 0), moves by its mass of 60000 kg, in water with a volume of 200 m³\n",
                     "held: at (0, 0, 0), moves by its mass of 6000 kg, without weight, held by springs towards a place that "
                     "moves at (1, 0, 0) m/s\n", "fixed: at (0, 0, 0), stands still\n"):
            self.assertIn(part, output)

    def refused(self, arguments, *parts, ranks=0, code=2):
        """One sentence on stderr with these parts, the exit code, and no new file."""
        before = sorted(self.folder.rglob("*"))
        result = self.hawser(*arguments, ranks=ranks)
        output = [line for line in result.stderr.splitlines() if line.startswith("hawser: ")]
        with self.subTest(arguments=arguments, ranks=ranks):
            self.assertEqual(result.returncode, code, result.stderr)
            self.assertEqual(len(output), 1, result.stderr)
            for part in parts:
                self.assertIn(part, output[0])
            if not ranks:  # mpirun adds its own message after an error
                self.assertEqual(result.stderr, output[0] + "\n")
            self.assertNotRegex(result.stderr, "PETSC|MPI_ABORT|HDF5-DIAG|terminate called|internal error")
            if code == 2:
                self.assertEqual(sorted(self.folder.rglob("*")), before, "something was written")
        return result

    def test_longest_step_comes_from_what_moves(self):
        write(self.folder, "ship.yaml", """\
hawser: 1
line_types:
  chain: {outer_diameter: 0.252, mass_per_length: 390, EA: 1.674 GN, bending: false}
bodies:
  ship: {motion: {harmonic: {amplitude: [0, 0, 2], period: 10}, ramp: 10}}
lines:
  mooring:
    sections: [{type: chain, length: 120, elements: 24}]
    end_a: {anchor: [0, 0, -90]}
    end_b: {body: ship, at: [60, 0, 0]}
dynamics: {duration: 3 h}
""")
        output = self.hawser("check", "ship.yaml").stdout
        self.assertIn("automatic steps of at most 0.1 s (a hundredth of the period of body ship)", output)

    def test_check_refuses_what_run_refuses_at_the_start(self):
        write(self.folder, "met.yaml", CASE + "events: [{cut: {line: rod, at: 6}, when: {position: {line: rod, at: 12, axis: z, above: -100}}}]\n")
        messages = {}
        for command in ("check", "run"):
            result = self.hawser(command, "met.yaml")
            self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
            messages[command] = [line for line in result.stderr.splitlines() if "at the start is already" in line]
            self.assertEqual(len(messages[command]), 1, result.stderr)
        self.assertIn("met.yaml:13: events[0]", messages["run"][0])
        self.assertEqual(messages["check"][0], messages["run"][0])

    def test_statics_that_snaps_reports_it(self):
        write(self.folder, "strut.yaml", """\
hawser: 1
environment: {gravity: 0}
line_types:
  rod: {outer_diameter: 0.1, mass_per_length: 20, EA: 2.0e7, EI: 3.0e4, GJ: 3.0e4}
lines:
  rod:
    sections: [{type: rod, length: 12, elements: 8}]
    end_a: {anchor: [0, 0, 0]}
    end_b: {anchor: [11.9, 0, 0]}
    start: straight
""")
        result = self.hawser("run", "strut.yaml")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("note: the search passed through 1 unstable equilibrium", result.stdout)

    def test_wrong_energy_is_not_accepted(self):
        # A pendulum in steps of a sixth of its period, with maximum damping.
        write(self.folder, "pendulum.yaml", """\
hawser: 1
line_types:
  rope: {outer_diameter: 0.1, mass_per_length: 20, EA: 2.0e6, bending: false}
lines:
  rope:
    sections: [{type: rope, length: 3, elements: 6}]
    end_a: {anchor: [0, 0, 0]}
    end_b: free
    start: {points: [[0, 0, 0], [3, 0, 0]]}
statics: false
dynamics: {duration: 20, step: 0.5, rho_infinity: 0, resolve_impacts: false}
output: {every: 5}
""")
        result = self.hawser("run", "pendulum.yaml")
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertRegex(result.stdout, r"warning: the steps lost \d+ J by t = [\d.]+ s, \d+\.?\d* % of the work done: they are too long for the motion; give dynamics.step: 0.12 s. Do not use the results")

    def test_impact_at_the_start(self):
        for ranks in (0, 2):
            result = self.hawser("run", ROOT / "docs/tutorial/riser-3.yaml", "-o", f"impact{ranks}.h5", "--set", "dynamics.duration=0.3",
                                 "--set", "bodies.vessel.motion.ramp=0", ranks=ranks)
            self.assertEqual(result.returncode, 4, result.stderr)
            self.assertRegex(result.stdout, r"warning: the steps created .*: bodies.vessel.motion begins with a non-zero velocity, "
                                            r"which is an impact on the lines at rest; add a 'ramp' to it \(a shorter step does not help\)")

    def test_help(self):
        for arguments, words in [(["--help"], ["run", "check", "schema", "Exit codes", "mpirun"]),
                                 (["run", "--help"], ["--restart", "--output", "--stop-at", "PETSc options", "--quiet"]),
                                 (["check", "--help"], ["--ranks"]),
                                 (["schema", "--help"], ["--json", "--markdown"])]:
            result = self.hawser(*arguments)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            for word in words:
                self.assertIn(word, result.stdout)
        version = self.hawser("--version", ranks=2)
        self.assertEqual(version.returncode, 0)
        self.assertRegex(version.stdout, r"\Ahawser \d+\.\d+\.\d+(\+[0-9a-f]{8,}(-modified)?)?\n\Z")

    def test_command_line(self):
        self.refused([], "it needs a command")
        self.refused(["walk", "rod.yaml"], "there is no command 'walk'")
        self.refused(["run"], "a case file is missing: hawser run case.yaml")
        self.refused(["chek", "rod.yaml"], "there is no command 'chek'; did you mean 'check'? (see hawser --help)")
        self.refused(["rod.yaml"], "to run this case: hawser run rod.yaml")
        self.refused(["--hlp"], "there is no option '--hlp'; did you mean '--help'?")
        self.refused(["run", "rod.yaml", "rod.yaml"], "'rod.yaml' is an unexpected argument (see hawser run --help)")
        self.refused(["run", "rod.yaml", "--fast"], "there is no option '--fast', but there are --help,")
        self.refused(["check", "rod.yaml", "--quik=1"], "there is no option '--quik'; did you mean '--quick'?")
        self.refused(["run", "rod.yaml", "-log_view"], "there is no option '-log_view'; options of PETSc follow a lone --: -- -log_view")
        for arguments in (["run", "-set", "dynamics.step=0.1", "rod.yaml"], ["run", "rod.yaml", "-set", "dynamics.step=0.1"]):
            self.refused(arguments, "there is no option '-set'; did you mean '--set'? (see hawser run --help)")
        for arguments in (["run", "-n", "3", "rod.yaml"], ["run", "rod.yaml", "-np", "3"], ["run", "rod.yaml", "--ranks=3"],
                          ["run", "-n3", "rod.yaml"], ["-n", "3", "rod.yaml"]):
            self.refused(arguments, "the number of ranks is an option of mpirun: mpirun -n 3 hawser run rod.yaml (see")
        self.refused(["run", "rod.yaml", "--restart"], "a value is missing after --restart")
        self.refused(["modes", "rod.yaml", "-n", "two"], "--number: 'two' is not a whole number from 1 to 10000")
        self.refused(["report", "rod.h5", "--sinse", "3"], "there is no option '--sinse'; did you mean '--since'?")
        self.refused(["report", "rod.h5", "more.h5"], "'more.h5' is an unexpected argument (see hawser report --help)")
        self.refused(["plot", "rod.h5", "rang"], "what cannot be 'rang'; did you mean 'range'?")
        self.refused(["fatigue", "rod.h5", "--curve"], "a value is missing after --curve")
        self.refused(["run", "rod.yaml", "--stop-at", "-1"], "--stop-at: '-1' is no time above 0")
        self.refused(["run", "rod.yaml", "--stop-at", "soon"], "--stop-at")
        self.refused(["check", "rod.yaml", "-n", "0"], "--ranks")
        self.refused(["walk"], "there is no command 'walk'", ranks=2)

    def test_files_that_are_not_there(self):
        self.refused(["run", "none.yaml"], "none.yaml: there is no such case file")
        self.refused(["check", "none.yaml"], "none.yaml: there is no such case file")
        self.refused(["run", "none.yaml"], "none.yaml: there is no such case file", ranks=2)

    def test_places_that_cannot_be_written(self):
        for output, why in [("no/x.h5", "there is no folder"), ("x.txt", "must end in .h5"),
                            ("rod.yaml/x.h5", "rod.yaml is not a folder")]:
            self.refused(["run", "rod.yaml", "-o", output], "cannot write the results to", why)
        (self.folder / "d.h5").mkdir()
        self.refused(["run", "rod.yaml", "-o", "d.h5"], "d.h5 is a folder")
        self.refused(["run", "rod.yaml", "-o", "no/x.h5"], "there is no folder", ranks=2)

    def test_options_that_nothing_uses(self):
        used = ["-log_view", ":log.txt", "-dynamics_snes_rtol", "1e-9", "-dynamics_snes_converged_reason"]
        result = self.hawser("run", "rod.yaml", "--", *used, "-dynamics_snes_rtoll", "1", "-walk")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn("\nwarning: this run did not use the PETSc options -dynamics_snes_rtoll, -walk\n", result.stdout)
        stages = [line for line in (self.folder / "log.txt").read_text("utf-8").splitlines() if "Event Stage" in line]
        self.assertTrue(stages)
        self.assertNotRegex("".join(stages), "Unknown")
        result = self.hawser("run", "rod.yaml", "--", *used, ranks=2)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertNotIn("warning", result.stdout)
        result = self.hawser("run", "rod.yaml", "--", "-walk", ranks=2)
        self.assertEqual(result.stdout.count("the PETSc option -walk\n"), 1)
        self.assertEqual(self.hawser("run", "rod.yaml", "-q", "--", "-walk").stdout, "")

    def test_full_disk(self):
        """A separate file system is too small for the file, or for the data written during the run."""
        case = CASE.replace("elements: 8", "elements: 200").replace("duration: 0.2", "duration: 5")
        write(self.folder, "rod.yaml", case.replace("every: 0.1", "every: 0.05"))
        (self.folder / "disk").mkdir()
        mount = 'mount -t tmpfs -o size="$1" none disk || exit 99; cp rod.yaml disk; '
        alone = ["unshare", "--map-root-user", "--mount", "sh", "-c"]
        if not shutil.which("unshare") or run(*alone, mount, "sh", "300k", cwd=self.folder).returncode:
            self.skipTest("no file system of one's own may be made here")
        for size in ["300k", "2000k"]:
            for ranks in ([], ["mpirun", "-q", "-n", "2"]):
                result = run(*alone, mount + 'shift; "$@"; code=$?; ls disk; exit $code', "sh", size, *ranks, HAWSER, "run",
                             "disk/rod.yaml", "-q", cwd=self.folder, timeout=300)
                with self.subTest(size=size, ranks=ranks):
                    self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
                    output = [line for line in result.stderr.splitlines() if line.startswith("hawser: ")]
                    self.assertEqual(len(output), 1, result.stderr)
                    self.assertRegex(output[0], r"\Ahawser: cannot write \S*rod\.(h5|xdmf): no space left on the disk\Z")
                    self.assertEqual(result.stdout.split(), ["rod.h5", "rod.xdmf", "rod.yaml"])

    def test_restarts_that_do_not_fit(self):
        def restart(file, *parts, case="rod.yaml", ranks=0):
            self.refused(["run", case, "-o", "new.h5", "--restart", file], f"cannot continue from {file}: ", *parts, ranks=ranks)

        restart("none.h5", "there is no such file")
        restart("rod.yaml", "it is not an HDF5 file")
        restart("none.h5", "there is no such file", ranks=2)
        self.assertEqual(self.hawser("run", "rod.yaml", "-q").returncode, 0)
        for name, old, new, why in [("finer", "elements: 8", "elements: 9", "line rod has 9 nodes in the file, 10 in this case"),
                                    ("longer", "length: 12", "length: 13", "a node of line rod is at"),
                                    ("other", "  rod:\n    sections", "  mast:\n    sections", "its line 1 is rod, not mast"),
                                    ("cable", ", EI: 3.0e4, GJ: 3.0e4", ", bending: false", "other nodes are of beams")]:
            text = CASE.replace(old, new).replace(", clamped: true", "" if name == "cable" else ", clamped: true")
            self.assertNotEqual(text, CASE)
            write(self.folder, f"{name}.yaml", text)
            restart("rod.h5", "it holds another case", why, case=f"{name}.yaml")
        on_drum = CASE.replace("lines:", "volumes:\n  drum: {shape: {cylinder: {from: [5, -1, -2], to: [5, 1, -2], radius: 0.5}},"
                                         " normal_stiffness: {per_length: 1.0e6}, friction: 0.2}\nlines:", 1)
        write(self.folder, "drum.yaml", on_drum)
        self.assertEqual(self.hawser("run", "drum.yaml", "-q").returncode, 0)
        for name, old, new, why in [("larger", "radius: 0.5", "radius: 0.6", "volumes.drum.shape differs from the checkpoint"),
                                    ("lower", "to: [5, 1, -2]", "to: [5, 1, -2.1]", "volumes.drum.shape differs from the checkpoint"),
                                    ("harder", "1.0e6", "2.0e6", "volumes.drum.normal_stiffness differs from the checkpoint")]:
            write(self.folder, f"{name}.yaml", on_drum.replace(old, new))
            restart("drum.h5", "it holds another case", why, case=f"{name}.yaml")
        yielding = CASE.replace("GJ: 3.0e4", "GJ: 3.0e4, plasticity: {ramberg_osgood: {yield_moment: 6000, A: 0.4, B: 12}}")
        write(self.folder, "yielding.yaml", yielding)
        self.assertEqual(self.hawser("run", "yielding.yaml", "-q").returncode, 0)
        write(self.folder, "softer.yaml", yielding.replace("A: 0.4", "A: 0.5"))
        restart("yielding.h5", "it holds another case", "line_types.rod.plasticity differs from the checkpoint", case="softer.yaml")
        restart("yielding.h5", "it holds another case", "it has line_types.rod.plasticity", case="rod.yaml")
        write(self.folder, "rough.yaml", on_drum.replace("friction: 0.2", "friction: 0.3"))
        self.assertEqual(self.hawser("run", "rough.yaml", "-q", "-o", "new.h5", "--restart", "drum.h5").returncode, 0)
        write(self.folder, "rest.yaml", CASE.replace("dynamics: {duration: 0.2, step: 0.05}", ""))
        self.refused(["run", "rest.yaml", "--restart", "rod.h5"], "only a run with 'dynamics' can continue from a checkpoint")
        self.assertEqual(self.hawser("run", "rest.yaml", "-q").returncode, 0)
        self.refused(["run", "rod.yaml", "--restart", "rest.h5"], "rest.h5 holds no complete checkpoint")
        (self.folder / "cut.h5").write_bytes((self.folder / "rod.h5").read_bytes()[:3000])
        restart("cut.h5", "it is not a results file of hawser, or it is damaged")

    def test_solver_fails(self):
        for number, (edits, more, parts) in enumerate(UNSOLVABLE):
            case = CASE
            for old, new in edits.items():
                case = case.replace(old, new)
            write(self.folder, f"{number}.yaml", case + more)
            for ranks in (0, 2):
                self.refused(["run", f"{number}.yaml", "-q"], *parts, code=3, ranks=ranks)
        # The results up to the failure exist: dynamics failed, so at least the start was written.
        self.assertTrue((self.folder / "1.h5").exists())
        self.assertFalse((self.folder / "0.h5").exists())

    def test_check_writes_nothing(self):
        write(self.folder, "cut.yaml", CASE + "contact: {between_lines: false}\n")  # lines with self-contact are not cut
        before = sorted(self.folder.rglob("*"))
        result = self.hawser("check", "cut.yaml", "-n", "3")
        self.assertEqual(result.returncode, 0, result.stderr)
        for part in ["a cantilever", "rod: 12 m, 8 elements, 9 nodes, 54 unknowns", "partition: 3 ranks, 3 + 3 + 3 nodes",
                     "on one of them 1.00 times the mean work; 1 cut line, 2 cut elements", "expected cost",
                     "expected memory: about 0.0", "GB on each rank", "the case is valid"]:
            self.assertIn(part, result.stdout)
        self.assertNotIn("expected cost", self.hawser("check", "--quick", "cut.yaml").stdout)
        write(self.folder, "cut.yaml", CASE + "statics: {max_iterations: 1, dynamic_relaxation: never}\n")
        result = self.hawser("check", "cut.yaml")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("the case is valid\na trial run stops: statics: ", result.stdout)
        self.assertEqual(sorted(self.folder.rglob("*")), before)


if __name__ == "__main__":
    unittest.main()
