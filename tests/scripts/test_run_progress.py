"""Progress of a run: one rewritten line on a terminal, plain lines otherwise."""
import fcntl
import os
import pty
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import termios
import time
import unittest
from pathlib import Path

from support import ROOT, run, write
from test_run_messages import CASE, HAWSER

sys.path.insert(0, str(ROOT / "scripts"))
from hawser_post.results import Results  # noqa: E402

LINE = r"t = \d+\.\d{3} of 20 s \([ \d]{3} %\), step \S+ s, \d+ iterations?, \d+:\d\d left"


def on_terminal(*command, columns=100, **options):
    """Output of a command on a terminal of that width."""
    reader, writer = pty.openpty()
    fcntl.ioctl(writer, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    process = subprocess.Popen([*map(str, command)], stdin=subprocess.DEVNULL, stdout=writer, stderr=writer, **options)
    os.close(writer)
    text = b""
    while True:
        try:
            piece = os.read(reader, 65536)
        except OSError:  # the other side is closed
            piece = b""
        if not piece:
            break
        text += piece
    os.close(reader)
    return process.wait(), text.decode()


class Progress(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        write(self.folder, "rod.yaml", CASE.replace("duration: 0.2, step: 0.05", "duration: 20, step: 0.002"))

    def test_plain_lines(self):
        for launch in ([HAWSER], ["mpirun", "-n", 1, HAWSER]):
            result = run(*launch, "run", "rod.yaml", cwd=self.folder, timeout=300)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertNotIn("\r", result.stdout)
            self.assertNotIn("\033", result.stdout)
            lines = re.findall(f"^{LINE}$", result.stdout, re.M)
            self.assertEqual([line[line.index("(") + 1:].split()[0] for line in lines],
                             [str(10 * k) for k in range(1, 11)])
            for part in ["max effective tension", "energy: input", "results: ", "view them: hawser view ", "in ParaView: paraview "]:
                self.assertIn(part, result.stdout)
        self.assertEqual(run(HAWSER, "run", "rod.yaml", "-q", cwd=self.folder).stdout, "")

    def test_title_comes_first(self):
        """The title is printed before a mesh is read that takes long; without a terminal the mesh is named
        only if it is large."""
        box = (ROOT / "tests/data/bad/box.obj").read_text("utf-8")
        write(self.folder, "box.obj", box)
        write(self.folder, "large.obj", box + "# nothing but this comment, again and again, as long as a row of numbers\n" * 600_000)
        case = CASE.replace("lines:\n", "volumes:\n  deck: {mesh: MESH}\nlines:\n", 1).replace("[0, 0, 0], dir", "[0, 0, 200], dir")
        for mesh, expected in [("box.obj", False), ("large.obj", True)]:
            write(self.folder, "deck.yaml", case.replace("MESH", mesh))
            for command in ("check", "run"):
                lines = run(HAWSER, command, "deck.yaml", cwd=self.folder).stdout.splitlines()
                self.assertEqual(lines[0], "a cantilever")
                self.assertEqual(lines[1] == "reading the mesh large.obj (44 MB)", expected, lines[:3])
                self.assertEqual("preparing the mesh large.obj" in lines, expected, lines[:3])
                self.assertEqual(lines.count("a cantilever"), 1)
        _, text = on_terminal(HAWSER, "run", "deck.yaml", cwd=self.folder)
        self.assertTrue(text.startswith("a cantilever\r\n\r\033[Kreading the mesh large.obj (44 MB)\r\033[K"), text[:200])
        # A refused mesh: the title is printed nevertheless, and the message begins on a new line.
        write(self.folder, "box.obj", "v 0 0 0\n")
        write(self.folder, "deck.yaml", case.replace("MESH", "box.obj"))
        code, text = on_terminal(HAWSER, "run", "deck.yaml", cwd=self.folder)
        self.assertEqual(code, 2)
        self.assertRegex(text, r"\Aa cantilever\r\n\r\033\[Kreading the mesh box.obj \([^)]*\)\r\033\[Khawser: deck.yaml:")

    def test_statics(self):
        """On a terminal a line is rewritten, and removed when statics is done."""
        # Long enough on any machine for a line rewritten every 0.2 s: ten rods side by side.
        case = CASE.replace("elements: 8", "elements: 400").replace("duration: 0.2", "duration: 0.1")
        rod = case[case.index("  rod:\n    sections"):case.index("dynamics:")]
        for i in range(9):
            case = case.replace("dynamics:", rod.replace("rod:", f"rod{i}:").replace("[0, 0, 0], dir", f"[0, {i + 1}, 0], dir") + "dynamics:")
        write(self.folder, "slow.yaml", case + "statics: {dynamic_relaxation: always}\n")
        line = r"\r\033\[Kstatics: \d+ iterations?(, \d+ steps of dynamic relaxation)?, relative residual \d\.\de[-+]\d\d"
        code, text = on_terminal(HAWSER, "run", "slow.yaml", columns=120, cwd=self.folder)
        self.assertEqual(code, 0, text)
        self.assertRegex(text, f"{line}\r\033\\[K")
        self.assertRegex(text, "steps of dynamic relaxation, relative residual")
        self.assertNotRegex(text, "so far\r\n")
        self.assertNotIn("so far", run(HAWSER, "run", "slow.yaml", cwd=self.folder).stdout)

    def test_terminal(self):
        code, text = on_terminal(HAWSER, "run", "rod.yaml", cwd=self.folder)
        self.assertEqual(code, 0, text)
        rewritten = text[text.index("\r\033[K"):text.index("100 %")]
        self.assertNotIn("\n", rewritten)
        self.assertRegex(text, f"\r\033\\[K{LINE}\r\n")
        self.assertIn("results: ", text)

    def test_narrow_terminal(self):
        _, text = on_terminal(HAWSER, "run", "rod.yaml", columns=40, cwd=self.folder)
        for line in text.split("\r\033[K")[1:]:
            self.assertLess(len(line.splitlines()[0]), 40)

    def test_stopped_by_the_user(self):
        # Ctrl-C and SIGTERM: the run ends, everything on disk, and can be continued.
        for sign in (signal.SIGINT, signal.SIGTERM):
            process = subprocess.Popen([HAWSER, "run", "rod.yaml"], cwd=self.folder, stdout=subprocess.PIPE, text=True)
            for line in process.stdout:
                if line.startswith("t = "):
                    break
            process.send_signal(sign)
            rest = process.stdout.read()
            process.stdout.close()
            self.assertEqual(process.wait(), 130)
            self.assertIn("results: ", rest)
            self.assertNotIn("(100 %)", rest)
            time.sleep(0.01)
            result = run(HAWSER, "run", "rod.yaml", "--restart", "rod.h5", cwd=self.folder)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertRegex(result.stdout, r"continuing from t = \d")
            self.assertNotIn("( 10 %)", result.stdout)
            self.assertIn("(100 %)", result.stdout)

    def test_stopped_between_outputs(self):
        # The next output is the last one: the run ends long before it, and continues like an unbroken run.
        write(self.folder, "rod.yaml", (self.folder / "rod.yaml").read_text("utf-8").replace("every: 0.1", "every: 20"))
        result = run(HAWSER, "run", "rod.yaml", "-o", "whole.h5", cwd=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        with subprocess.Popen([HAWSER, "run", "rod.yaml"], cwd=self.folder, stdout=subprocess.PIPE, text=True) as process:
            next(line for line in process.stdout if line.startswith("t = "))
            process.send_signal(signal.SIGINT)
            rest = process.stdout.read()
        self.assertEqual(process.returncode, 130)
        self.assertLess(float(re.search(r"stopped by a signal at t = (\S+) of 20 s", rest)[1]), 19)
        result = run(HAWSER, "run", "rod.yaml", "--restart", "rod.h5", cwd=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        whole, continued = Results(self.folder / "whole.h5"), Results(self.folder / "rod.h5")
        self.assertEqual(list(whole.time), list(continued.time))
        self.assertTrue((whole.field("position", whole.lines[0]) == continued.field("position", continued.lines[0])).all())

    def test_notes_of_the_start_are_in_the_file_of_a_run_that_is_killed(self):
        write(self.folder, "rod.yaml", (self.folder / "rod.yaml").read_text("utf-8").replace("EA: 2.0e7", "EA: 2.0e4"))
        process = subprocess.Popen([HAWSER, "run", "rod.yaml"], cwd=self.folder, stdout=subprocess.PIPE, text=True)
        printed = []
        for line in process.stdout:
            if line.startswith("t = "):
                break
            printed += [line.strip()] if line.startswith(("note: ", "warning: ")) else []
        process.kill()
        process.stdout.close()
        process.wait()
        self.assertTrue(printed)
        results = Results(self.folder / "rod.h5")
        self.assertEqual([message.split("\n")[0] for message in results.messages()], printed)


if __name__ == "__main__":
    unittest.main()
