"""Results files under adverse conditions: concurrent runs, third-party files, full disks and unusual names."""
import math
import os
import re
import shutil
import signal
import struct
import subprocess
import tempfile
import time
import unittest
from pathlib import Path
from xml.etree import ElementTree

from support import ROOT, run, write
from test_run_messages import CASE, HAWSER

LONG = CASE.replace("duration: 0.2, step: 0.05", "duration: 4000, step: 0.002").replace("every: 0.1", "every: 0.5")
ALONE = ["unshare", "--map-root-user", "--mount", "sh", "-c"]  # a separate file system


class Attack(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        write(self.folder, "rod.yaml", CASE)
        write(self.folder, "long.yaml", LONG)

    def hawser(self, *arguments, ranks=0, **options):
        launch = ["mpirun", "-q", "-n", ranks, HAWSER] if ranks else [HAWSER]
        environment = {**os.environ, "OMPI_MCA_odls_base_sigkill_timeout": "0"}
        return run(*launch, "run", *arguments, cwd=self.folder, timeout=300, env=environment, **options)

    def succeed(self, *arguments, **options):
        result = self.hawser(*arguments, **options)
        self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)
        return result

    def refused(self, arguments, *parts, code=2, **options):
        """One sentence with these parts, and all files unchanged."""
        def state():
            return {p: p.is_file() and not p.is_symlink() and p.read_bytes() for p in self.folder.rglob("*")}
        before = state()
        result = self.hawser(*arguments, **options)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertRegex(result.stderr, r"\Ahawser: [^\n]+\n\Z")
        for part in parts:
            self.assertIn(part, result.stderr)
        self.assertEqual(state(), before)
        return result

    def running(self, *arguments, ranks=0):
        """A run in progress."""
        launch = ["mpirun", "-q", "-n", str(ranks), HAWSER] if ranks else [HAWSER]
        return self.launched([*launch, "run", *arguments])

    def launched(self, command, **options):
        process = subprocess.Popen(command, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        table = self.folder / "long.xdmf"
        while not table.exists() or table.read_text().count("<Time") < 3:
            self.assertIsNone(process.poll())
            time.sleep(0.05)
        return process


class TwoRuns(Attack):
    def test_one_file_is_one_run_s(self):
        (self.folder / "link.h5").symlink_to("long.h5")
        for ranks in (0, 2):
            with self.subTest(ranks=ranks):
                first = self.running("long.yaml", ranks=ranks)
                lock = self.folder / "long.h5.lock"
                who = lock.read_text().strip()
                self.assertRegex(who, rf"\Aprocess \d+ on {re.escape(os.uname().nodename)}\Z")
                if not ranks:
                    self.assertEqual(who.split()[1], str(first.pid))
                for arguments in (["long.yaml"], ["rod.yaml", "-o", "link.h5"], ["long.yaml", "--restart", "long.h5"]):
                    result = self.hawser(*arguments, ranks=2 - ranks)
                    self.assertEqual(result.returncode, 2, result.stderr)
                    self.assertRegex(result.stderr, r"\Ahawser: cannot write the results to \S+/long.h5: another run is writing "
                                                    rf"them \({who}\); wait for its end, or give this one another file with -o\n\Z")
                # Only reading is allowed.
                result = self.hawser("long.yaml", "-q", "--restart", "long.h5", "-o", "other.h5", "--stop-at", "0.001")
                self.assertIn("and the run ends at 0.001 s", result.stderr)
                os.kill(int(who.split()[1]), signal.SIGTERM)
                first.wait()
                self.assertFalse(lock.exists())
                for name in ("long.h5", "long.xdmf"):
                    (self.folder / name).unlink()

    def test_a_lock_of_the_dead_is_none(self):
        first = self.running("long.yaml")
        first.kill()
        first.wait()
        self.assertTrue((self.folder / "long.h5.lock").exists())
        self.succeed("long.yaml", "-q", "--restart", "long.h5", "--stop-at", "1")
        self.assertFalse((self.folder / "long.h5.lock").exists())

    def test_a_lock_is_no_link_to_something_else(self):
        (self.folder / "rod.h5.lock").symlink_to("rod.yaml")
        self.refused(["rod.yaml"], "rod.h5.lock), and would be replaced")


class OldFiles(Attack):
    def names(self):
        return sorted(p.name for p in self.folder.iterdir() if p.name.startswith("rod") and p.suffix != ".yaml")

    def test_old_results_are_kept(self):
        for ranks in (0, 2):
            self.succeed("rod.yaml", "-q")
            first, table = [(self.folder / name).read_bytes() for name in ("rod.h5", "rod.xdmf")]
            write(self.folder, "shorter.yaml", CASE.replace("duration: 0.2", "duration: 0.1"))
            result = self.succeed("shorter.yaml", "-o", "rod.h5", ranks=ranks)
            self.assertRegex(result.stdout, r"note: the results that are at \S+/rod.h5 will be kept as \S+/rod.h5~")
            self.assertEqual(self.names(), ["rod.h5", "rod.h5~", "rod.xdmf", "rod.xdmf~"])
            self.assertEqual((self.folder / "rod.h5~").read_bytes(), first)
            self.assertEqual((self.folder / "rod.xdmf~").read_bytes(), table)
            self.assertNotEqual((self.folder / "rod.h5").read_bytes(), first)
            # Continuing in the same file replaces nothing.
            self.succeed("rod.yaml", "-q", "--restart", "rod.h5")
            self.assertEqual((self.folder / "rod.h5~").read_bytes(), first)

    def test_a_run_that_fails_leaves_them(self):
        self.succeed("rod.yaml", "-q")
        before = (self.folder / "rod.h5").read_bytes()
        write(self.folder, "rod.yaml", CASE.replace("elements: 8}]", "elements: 8}]\n    loads: [{per_length: [0, 0, 1.0e9]}]")
              + "statics: {max_iterations: 3}\n")
        self.assertEqual(self.hawser("rod.yaml").returncode, 3)
        self.assertEqual(self.names(), ["rod.h5", "rod.xdmf"])
        self.assertEqual((self.folder / "rod.h5").read_bytes(), before)

    def test_files_of_others_stay(self):
        for name in ("rod.h5", "rod.xdmf", "rod.h5~", "rod.xdmf~"):
            for content in ("somebody's work", ""):
                write(self.folder, name, content)
                self.refused(["rod.yaml"], f"/{name} was not written by hawser and is not replaced")
            self.refused(["rod.yaml", "-q"], f"/{name} was not written by hawser", ranks=2)
            (self.folder / name).unlink()
        os.mkfifo(self.folder / "rod.h5")
        self.refused(["rod.yaml"], "was not written by hawser")

    def test_what_is_gone_on_from_stays(self):
        self.succeed("rod.yaml", "-q")
        self.succeed("rod.yaml", "-q")
        self.refused(["rod.yaml", "--restart", "rod.h5~"], "rod.h5~ is a file that this run reads", "and would be replaced")

    def test_links_are_followed(self):
        (self.folder / "far").mkdir()
        (self.folder / "rod.h5").symlink_to("link.h5")
        (self.folder / "link.h5").symlink_to("far/data.h5")
        for _ in range(2):
            self.succeed("rod.yaml", "-q")
            self.assertTrue((self.folder / "rod.h5").is_symlink())
            self.assertTrue((self.folder / "far/data.xdmf").exists())
        self.assertTrue((self.folder / "far/data.h5~").exists())
        self.succeed("rod.yaml", "-q", "--restart", "rod.h5")
        (self.folder / "loop.h5").symlink_to("loop.h5")
        self.refused(["rod.yaml", "-o", "loop.h5"], "loop.h5")


class Places(Attack):
    def test_found_before_statics(self):
        for name in ("rod.xdmf", "rod.h5.new", "rod.xdmf.new", "rod.h5~", "rod.xdmf~"):
            (self.folder / name).mkdir()
            result = self.refused(["rod.yaml"], f"/{name} is a folder")
            self.assertNotIn("statics", result.stdout)
            (self.folder / name).rmdir()
        result = self.refused(["rod.yaml", "-o", "/proc/x.h5"], "/proc/x.h5")
        self.assertNotIn("statics", result.stdout)

    def test_long_names(self):
        for length, fits in ((249, True), (250, False)):
            name = "x" * (length - 3) + ".h5"
            for ranks in (0, 2):
                if fits:
                    self.succeed("rod.yaml", "-q", "-o", name, ranks=ranks)
                else:
                    self.refused(["rod.yaml", "-q", "-o", name], "the name is too long", ranks=ranks)
        deep = self.folder
        while len(str(deep)) < 3000:
            deep = deep / ("d" * 200)
        deep.mkdir(parents=True)
        for ranks in (0, 2):
            self.succeed("rod.yaml", "-q", "-o", deep / "x.h5", ranks=ranks)

    def test_full_disk_from_the_beginning(self):
        (self.folder / "disk").mkdir()
        mount = 'mount -t tmpfs -o size=64k none disk || exit 99; cp rod.yaml disk; '
        if not shutil.which("unshare") or run(*ALONE, mount, cwd=self.folder).returncode:
            self.skipTest("no file system of one's own may be made here")
        for fill in ("", "head -c 100000 /dev/zero >disk/more 2>&-;"):
            for ranks in ([], ["mpirun", "-q", "-n", "2"]):
                result = run(*ALONE, mount + fill + '"$@"; code=$?; ls disk; exit $code', "sh", *ranks, HAWSER, "run", "disk/rod.yaml",
                             "-q", cwd=self.folder, timeout=300)
                self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
                self.assertRegex(result.stderr, r"\Ahawser: cannot write \S*rod\.h5: no space left on the disk\n\Z")
                self.assertEqual(result.stdout.split(), (["more"] if fill else []) + ["rod.yaml"])

    def test_a_limit_of_the_shell(self):
        # The limit is 5 or 10 MB, depending on the unit of the shell, because Open MPI needs files of its
        # own; the results would have 50 MB.
        write(self.folder, "rod.yaml", CASE.replace("elements: 8", "elements: 400").replace("duration: 0.2", "duration: 50"))
        for ranks in ([], ["mpirun", "-q", "-n", "2"]):
            result = run("sh", "-c", 'ulimit -f 10000; exec "$@"', "sh", *ranks, HAWSER, "run", "rod.yaml", "-q", cwd=self.folder, timeout=300)
            self.assertEqual(result.returncode, 1, result.stderr)
            self.assertRegex(result.stderr, r"\Ahawser: cannot write \S+: File too large\n\Z")


class Corrupted(Attack):
    def test_counters(self):
        write(self.folder, "rod.yaml", CASE.replace("duration: 0.2", "duration: 0.6"))
        self.succeed("rod.yaml", "-q")
        file = self.folder / "rod.h5"
        whole = file.read_bytes()
        counter, row = struct.pack("<qq", 7, 13), struct.pack("<d", 0.1)
        self.assertEqual(whole.count(counter), 1)
        first = struct.pack("<ddd", 0, 0.1, 0.2)  # times of the outputs
        outputs = [m.start() + 8 for m in re.finditer(re.escape(first), whole)]
        self.assertEqual(len(outputs), 1)

        def corrupt(at, piece, *parts):
            file.write_bytes(whole[:at] + piece + whole[at + len(piece):])
            for ranks in (0, 2):
                self.refused(["rod.yaml", "--restart", "rod.h5"], "rod.h5 is damaged and cannot be continued: ", *parts,
                             "go on in another file with -o", ranks=ranks)
        for numbers, reported in [((-1, 13), "it counts -1 rows of outputs/time, which has 7"),
                              ((7, -5), "it counts -5 rows of series/time, which has 13"),
                              ((10**15, 13), "it counts 1000000000000000 rows of outputs/time")]:
            corrupt(whole.index(counter), struct.pack("<qq", *numbers), reported)
        corrupt(outputs[0], struct.pack("<d", math.nan), "row 2 of outputs/time is nan, after 0 and before 0.2 s")
        corrupt(outputs[0], struct.pack("<d", 1e30), "row 2 of outputs/time is 1e+30")
        self.succeed("rod.yaml", "-q", "--restart", "rod.h5", "-o", "other.h5")


    def test_checkpoints(self):
        """NaN under a valid checksum (src/io/checkpoint.cpp)."""
        def mix(h):
            h ^= h >> 33
            h = h * 0xff51afd7ed558ccd % 2**64
            h ^= h >> 33
            h = h * 0xc4ceb9fe1a85ec53 % 2**64
            return h ^ h >> 33

        def checksum(number, text, values):
            total = (mix(3 * number + 1) + mix(5 * (len(values) // 8) + 2)) % 2**64
            for c in text:
                total = mix(total ^ c)
            words = struct.unpack(f"<{len(values) // 8}Q", values)
            return (total + sum(mix(mix(i + 1) ^ w) for i, w in enumerate(words))) % 2**64

        self.succeed("rod.yaml", "-q")
        file = self.folder / "rod.h5"
        whole = file.read_bytes()
        texts = [m.start() for m in re.finditer(b"mesh 9\nscalar ", whole)]
        last = struct.unpack("<3d", whole[(at := whole.index(struct.pack("<2d", 0, 0.1))):at + 24])[2]
        starts = [m.start() for m in re.finditer(re.escape(struct.pack("<d", last)), whole)]
        found = []
        for header in range(0, len(whole) - 32, 8):
            number, size, length, total = struct.unpack_from("<4Q", whole, header)
            if 0 < number < 100 and 100 < size < 10000 and 100 < length < 10000:
                found += [(number, header, text, length, values, size) for text in texts for values in starts
                          if values + 8 * size <= len(whole)
                          and checksum(number, whole[text:text + length], whole[values:values + 8 * size]) == total]
        self.assertTrue(found)
        number, header, text, length, values, size = max(found)
        names = [line.split(" ", 1) for line in whole[text:text + length].decode().splitlines()[1:]]
        scalars = [name for kind, name in names if kind == "scalar"]
        for name, place in [("the time", 0), ("step.wait", 1 + scalars.index("step.wait")),
                            ("step.proposal", 1 + scalars.index("step.proposal")), ("acceleration", 1 + len(scalars))]:
            for wrong in (math.nan, *([-5.0, 1e300] if place and name != "acceleration" else [])):
                corrupted = bytearray(whole)
                struct.pack_into("<d", corrupted, values + 8 * place, wrong)
                struct.pack_into("<Q", corrupted, header + 24,
                                 checksum(number, whole[text:text + length], corrupted[values:values + 8 * size]))
                file.write_bytes(corrupted)
                self.refused(["rod.yaml", "--restart", "rod.h5"], f"its checkpoint is damaged: {name} is {wrong:g}")
        self.refused(["rod.yaml", "-q", "--restart", "rod.h5"], "its checkpoint is damaged: acceleration is nan", ranks=2)

    def test_no_history_is_dropped(self):
        def write_case(histories):
            write(self.folder, "rod.yaml", CASE.replace("every: 0.1", "every: 0.1, histories: [" + ", ".join(
                f"{{line: rod, at: {at}, name: {name}}}" for at, name in histories) + "]"))
        write_case([(12, "tip"), (6, "half")])
        self.succeed("rod.yaml", "-q", "--stop-at", "0.1")
        write_case([(12, "tip")])
        for ranks in (0, 2):
            self.refused(["rod.yaml", "-q", "--restart", "rod.h5"],
                         "rod.h5 cannot be continued: the case no longer has its history or clearance half, which would be lost; "
                         "keep it, or go on in another file with -o", ranks=ranks)
        self.succeed("rod.yaml", "-q", "--restart", "rod.h5", "-o", "other.h5")
        write_case([(6, "half"), (12, "tip")])
        self.succeed("rod.yaml", "-q", "--restart", "rod.h5")


class Names(Attack):
    def test_xdmf_is_xml_whatever_the_path(self):
        folder = os.fsencode(self.folder) + b"/a&b<c>\"d'\xff\xc3\x01"
        os.mkdir(folder)
        shutil.copy(self.folder / "rod.yaml", folder + b"/rod.yaml")
        for name, reported in ((b"x&<>\"'.h5", False), ("Trosse → 🚢.h5".encode(), False), (b"bad\xff\xe2\x82.h5", True)):
            result = subprocess.run([HAWSER, "run", folder + b"/rod.yaml", "-o", folder + b"/" + name], capture_output=True, check=False)
            self.assertEqual((result.returncode, result.stderr), (0, b""))
            self.assertEqual(b"is not UTF-8" in result.stdout, reported)
            root = ElementTree.parse((folder + b"/" + name).replace(b".h5", b".xdmf")).getroot()
            items = [item.text for item in root.iter("DataItem")]
            self.assertTrue(items)
            if not reported:
                self.assertEqual({item.split(":/")[0] for item in items}, {name.decode()})


class Signals(Attack):
    def test_a_run_that_is_stopped_reports_it(self):
        for ranks, sign in ((0, signal.SIGTERM), (0, signal.SIGINT), (0, signal.SIGUSR1), (2, signal.SIGUSR1)):
            with self.subTest(ranks=ranks, sign=sign):
                process = self.running("long.yaml", ranks=ranks)
                process.send_signal(sign)
                out, _ = process.communicate()
                self.assertEqual(process.returncode, 130)
                stop_time = re.search(r"^stopped by a signal at t = (\S+) of 4000 s: the histories end at that time; --restart \S+/long.h5 continues$",
                                      out, re.M)[1]
                self.assertIn("\nresults: ", out)
                self.assertFalse((self.folder / "long.h5.lock").exists())
                result = self.succeed("long.yaml", "--restart", "long.h5", "--stop-at", str(float(stop_time) + 1))
                self.assertIn(f"continuing from t = {stop_time} s", result.stdout)
                self.assertNotIn("stopped", result.stdout)
                for name in ("long.h5", "long.xdmf"):
                    (self.folder / name).unlink()

    @unittest.skipUnless(Path(HAWSER).resolve() == ROOT / "build/hawser", "scripts/run runs another build")
    def test_the_script_turns_control_c_into_a_stop(self):
        (self.folder / "bin").mkdir()
        cmake = self.folder / "bin/cmake"  # the program exists
        cmake.write_text("#!/bin/sh\n")
        cmake.chmod(0o755)
        process = self.launched([ROOT / "scripts/run", "long.yaml", "-n", "2"], start_new_session=True,
                                env={**os.environ, "PATH": f"{cmake.parent}:{os.environ['PATH']}"})
        os.killpg(process.pid, signal.SIGINT)  # as a terminal does
        out, _ = process.communicate()
        self.assertEqual(process.returncode, 130)
        self.assertIn("\nstopped by a signal at t = ", out)
        self.assertIn("  numbers   long.h5", out)

    def test_mpirun_on_its_own_terms(self):
        # The program cannot change what mpirun does at these signals; the accepted outputs must be in the
        # file.
        for sign in (signal.SIGTERM, signal.SIGINT):
            process = self.running("long.yaml", ranks=2)
            process.send_signal(sign)
            process.communicate()
            self.assertEqual(process.returncode, 1)
            self.succeed("long.yaml", "-q", "--restart", "long.h5", "--stop-at", "1")
            for name in ("long.h5", "long.xdmf"):
                (self.folder / name).unlink()


if __name__ == "__main__":
    unittest.main()
