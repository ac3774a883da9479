"""The Python tools under adverse conditions: names with a meaning in YAML 1.1, outputs that are inputs, damaged
results, Ctrl-C."""
import contextlib
import errno
import io
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path
from unittest import mock

from support import ROOT, run, write

sys.path.insert(0, str(ROOT / "scripts"))
import h5py  # noqa: E402
import numpy as np  # noqa: E402

from hawser_post import __main__ as post  # noqa: E402
from hawser_post import export  # noqa: E402
from hawser_post.results import Refusal, Results  # noqa: E402

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
# Names that are true, false, a date, 16 and 8 in YAML 1.1, and two that differ in characters not allowed in
# file names.
CASE = """\
hawser: 1
title: names
environment:
  water: {density: 1025, depth: 30}
  seabed: {depth: 30}
  waves: {jonswap: {hs: 1, tp: 5, components: 20}}
line_types:
  no: {library: chain-studless, diameter: 0.05, grade: R3}
  on: {pipe: {outer_diameter: 0.2, wall_thickness: 10 mm, grade: X65}}
bodies:
  yes: {position: [0, 0, 0], motion: {table: {file: lines.csv}}}
  clump: {on: {line: 2024-01-01, at: 6}}
volumes:
  deck: {mesh: deck.obj, body: yes}
lines:
  a b: {sections: [{type: no, length: 50, elements: 10}], end_a: {anchor: [-35, 0, -30]}, end_b: {body: yes, at: [0, 0, 0]}}
  a_b: {sections: [{type: no, length: 50, elements: 10}], end_a: {anchor: [-35, 9, -30]}, end_b: {body: yes, at: [0, 9, 0]}}
  2024-01-01:
    sections: [{type: on, length: 12, elements: 6}]
    end_a: {anchor: [0, 20, -5], direction: [1, 0, 0], rotational_stiffness: 20 kNm/rad}
    end_b: {anchor: [11, 20, -5]}
    bend_stiffeners: [{at: end_a, EI: [[0, 1e6], [1, 1e5]]}]
dynamics: {duration: 2, step: 0.05}
output:
  every: 0.1
  histories:
    - {line: a_b, at: end_b, name: energy2}
    - {line: a_b, at: 3, name: a b}
    - {line: a_b, at: 40, name: a_b}
    - {line: a_b, at: 5, name: 010}
  clearances: [{line: a_b, other_line: 2024-01-01}]
"""
DECK = "".join(f"v {x} {y} {z}\n" for z in (2, 3) for y in (-2, 2) for x in (-2, 2)) + "".join(
    f"f {a} {b} {c}\n" for a, b, c in ((1, 3, 4), (1, 4, 2), (5, 6, 8), (5, 8, 7), (1, 2, 6), (1, 6, 5), (3, 7, 8), (3, 8, 4), (1, 5, 7),
                                       (1, 7, 3), (2, 4, 8), (2, 8, 6)))  # fmt: skip


def tool(*arguments):
    """Exit code, output and errors of a tool, in this process."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            code = post.main([str(a) for a in arguments])
        except SystemExit as stop:  # of the parser
            code = stop.code
    return code, out.getvalue(), err.getvalue()


class Attack(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.sound = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.sound)
        write(cls.sound, "run.yaml", CASE)
        write(cls.sound, "deck.obj", DECK)
        write(cls.sound, "lines.csv", "0, 0, 0, 0\n1, 0.1, 0, 0\n2, 0, 0, 0\n")
        made = run(HAWSER, "run", "run.yaml", "-q", cwd=cls.sound, timeout=600)
        assert made.returncode in (0, 4), made.stderr
        os.environ["HAWSER"] = HAWSER

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        for file in self.sound.iterdir():
            shutil.copy2(file, self.folder)
        self.path = self.folder / "run.h5"


class Names(Attack):
    def test_the_case_is_read_once(self):
        results = Results(self.path)
        self.assertEqual(list(results.keys["line_types"]), ["no", "on"])
        self.assertEqual(results.keys["bodies"]["clump"]["on"], {"line": "2024-01-01", "at": 6})
        self.assertEqual(results.keys["line_types"]["on"]["pipe"]["wall_thickness"], 0.01)
        self.assertEqual(results.given["line_types"]["on"]["pipe"]["wall_thickness"], "10 mm")
        self.assertEqual(results.keys["environment"]["waves"]["jonswap"]["gamma"], 3.3)
        self.assertEqual({Path(file).name for file in results.as_read["inputs"]}, {"run.yaml", "deck.obj", "lines.csv"})
        printed = run(HAWSER, "check", "run.yaml", "--json", "--set", "output.file=other.h5", cwd=self.folder)
        found = json.loads(printed.stdout)
        self.assertEqual(found["results"], str(self.folder / "other.h5"))
        self.assertEqual(found["read"]["lines"], results.keys["lines"])
        # Breaking load of a studless chain R3: 0.0223 d² (44 - 80 d) MN with d in m, d in mm 22.3 d² (44 - 0.08 d) N.
        self.assertAlmostEqual(found["line_types"]["no"]["breaking_load"] / (22.3 * 50**2 * (44 - 0.08 * 50)), 1, places=3)

    def test_tools_know_the_names(self):
        code, out, err = tool("pipe", self.path)
        self.assertEqual(code, 0, err)
        self.assertIn("2024-01-01: 200 mm x 10 mm, X65", out)
        code, _, err = tool("report", self.path)
        self.assertEqual(code, 0, err)
        page = (self.folder / "run.html").read_text(encoding="utf-8")
        for part in ("clump.on.line</td><td class=\"text\">2024-01-01", "waves.jonswap.gamma</td><td class=\"text\">3.3 (default)",
                     "end_a.rotational_stiffness</td><td class=\"text\">20 kNm/rad", "bend_stiffeners[0]</td><td class=\"text\">at end_a, EI",
                     "<td class=\"text\">Cd_normal</td><td>2.400</td>"):
            self.assertIn(part, page)
        text = re.sub(r'base64,[^"]*', "", page.split("Case file</h2>")[0].split("<body>")[1])  # pictures hold any letters
        self.assertNotIn("True", text)

    def test_each_line_has_its_file(self):
        code, out, err = tool("export", self.path)
        self.assertEqual(code, 0, err)
        written = out.splitlines()
        self.assertEqual(len(written), len(set(written)))
        names = {Path(file).name for file in written}
        self.assertLessEqual({"range_a_b.csv", "range_a_b_2.csv", "history_a_b.csv", "history_a_b_2.csv", "history_energy2.csv"}, names)
        results = Results(self.path)
        for line, file in (("a_b", "range_a_b.csv"), ("a b", "range_a_b_2.csv")):
            rows = np.loadtxt(self.folder / "run" / file, delimiter=",", skiprows=1, ndmin=2)
            head = (self.folder / "run" / file).read_text().splitlines()[0].split(",")
            found = rows[:, head.index("effective_tension_max [N]")]
            np.testing.assert_allclose(found, results.statistics("effective_tension", results.line(line))[:, 2], rtol=1e-8)
        heights = [results.series(name).column("position_z")[0] for name in ("a b", "a_b")]
        self.assertNotAlmostEqual(*heights, places=1)
        self.assertEqual(export.file_names(["A", "a", "a b", "a_b", "a_b_2"]), {"A": "A", "a": "a_2", "a_b": "a_b", "a_b_2": "a_b_2", "a b": "a_b_3"})

    def test_fatigue_takes_the_chain_of_the_case(self):
        for curve, option in (("api-studless-chain", ["--breaking-load", 21.1 * 50**2 * (44 - 0.08 * 50)]),
                              ("dnv-studless-chain", ["--area", np.pi / 2 * 0.05**2])):
            (code, own, err), (_, given, _) = (tool("fatigue", self.path, "--curve", curve, "--line", "a_b", "-o", self.folder / "f.csv", *o)
                                               for o in ([], option))
            self.assertEqual(code, 0, err)
            damage = [float(out.split("largest damage ")[1].split()[0]) for out in (own, given)]
            self.assertGreater(damage[0], 0)
            self.assertAlmostEqual(damage[0] / damage[1], 1, places=2)
        code, _, err = tool("fatigue", self.path, "--curve", "dnv-studless-chain", "--area", 3927)  # mm²
        self.assertEqual((code, "in mm² it is" in err), (2, True))
        code, _, err = tool("fatigue", self.path, "--curve", "dnv-spiral-rope", "--line", "a_b")
        self.assertEqual((code, "needs --area" in err), (2, True))


class Overwriting(Attack):
    def refused(self, *arguments, code=2):
        before = {file.name: file.read_bytes() for file in self.folder.iterdir()}
        found, out, err = tool(*arguments) if arguments[0] not in ("run", "modes") else self.program(*arguments)
        self.assertEqual(found, code, out + err)
        self.assertRegex(err, r"\Ahawser: [^\n]+\n\Z")
        self.assertEqual({file.name: file.read_bytes() for file in self.folder.iterdir()}, before)
        return err

    def program(self, *arguments):
        done = run(HAWSER, *arguments, timeout=300)
        return done.returncode, done.stdout, done.stderr

    def test_no_tool_writes_over_what_was_read(self):
        commands = {".html": ["report"], ".csv": ["pipe"], ".png": ["plot", "range"], ".json": ["extremes", "--duration", "3h"]}
        for ending, (command, *more) in commands.items():
            self.refused(command, self.path, *more, "-o", self.path)
            self.refused(command, self.path, *more, "-o", self.folder / "run.yaml")
            # Other names of the same files, with the extension that the tool requires.
            for file, link in (("run.h5", os.link), ("run.yaml", os.symlink), ("lines.csv", os.link), ("deck.obj", os.symlink)):
                other = self.folder / f"other{ending}"
                link(self.folder / file, other)
                self.assertIn("has read it", self.refused(command, self.path, *more, "-o", other))
                other.unlink()
        self.refused("fatigue", self.path, "--curve", "api-studless-chain", "-o", self.folder / "lines.csv")
        self.refused("lay", self.folder / "run.yaml", "--depths", "30", "-o", self.folder / "lines.csv")
        before = os.getcwd()
        try:
            os.chdir(self.folder)
            self.refused("fatigue", "run.h5", "--curve", "api-studless-chain", "-o", "../" + self.folder.name + "/lines.csv")
        finally:
            os.chdir(before)

    def test_export_beside_a_table_of_the_case(self):
        self.assertIn("lines.csv: cannot be written", self.refused("export", self.path, "-o", self.folder))

    def test_no_room_for_the_output(self):
        """Errors of writing, which have no name of a file; one of HDF5 without a number is of reading."""
        for number, part in ((errno.ENOSPC, "the output cannot be written (no space left on device)"),
                             (errno.EDQUOT, "the output cannot be written (disk quota exceeded)")):
            with mock.patch.object(post, "make_export", side_effect=OSError(number, os.strerror(number))):
                self.assertIn(part, self.refused("export", self.path, code=1))
        with mock.patch.object(post, "make_export", side_effect=OSError("Can't read data (wrong checksum)")):
            self.assertIn("a results file is damaged and cannot be read (Can't read data", self.refused("export", self.path))

    def test_the_program(self):
        case = self.folder / "run.yaml"
        shutil.move(self.path, self.folder / "left.h5")
        started = CASE.replace("dynamics:", "start: {from: left.h5}\ndynamics:")
        write(self.folder, "run.yaml", started)
        (self.folder / "run.xdmf").unlink(missing_ok=True)
        for command in ("run", "modes"):
            self.assertIn("is a file that this run reads", self.refused(command, case, "-o", self.folder / "left.h5"))
            os.link(self.folder / "left.h5", self.folder / "hard.h5")
            self.assertIn("is a file that this run reads", self.refused(command, case, "-o", self.folder / "hard.h5"))
            (self.folder / "hard.h5").unlink()
            for name in ("out.h5.new", "out.xdmf.new", "out.h5.lock", "out.h5~"):
                os.rename(case, self.folder / name)
                self.assertIn("is a file that this run reads", self.refused(command, self.folder / name, "-o", self.folder / "out.h5"))
                os.rename(self.folder / name, case)


class Damaged(Attack):
    """Each data set of a results file missing, or with other shapes, types and values: each tool ends with 0, or
    with 2 and a sentence."""
    TOOLS = (["report"], ["export"], ["pipe"], ["fatigue", "--curve", "api-studless-chain", "--line", "a_b"], ["plot", "range"],
             ["plot", "stress", "--line", "2024-01-01"], ["plot", "history", "--name", "a b"], ["plot", "elevation"], ["plot", "space"],
             ["extremes", "--name", "a b"])  # fmt: skip

    def judge(self, what, tools=TOOLS):
        for command, *more in tools:
            output = [] if command == "export" else ["-o", self.folder / {"report": "x.html", "plot": "x.png"}.get(command, "x.csv")]
            code, out, err = tool(command, self.path, *more, *output)
            with self.subTest(what=what, tool=command + " " + " ".join(more)):
                self.assertIn(code, (0, 2), err)
                self.assertRegex(err, r"\A\Z" if code == 0 else r"\Ahawser: [^\n]+\n\Z")
                self.assertNotIn("internal error", err)

    @staticmethod
    def harms(data):
        """Changed values of a data set: missing, other shape or type, NaN, far too large."""
        yield "gone", None
        if data.shape is None:
            return
        values = data[()]
        yield "empty", np.zeros((0,) * max(data.ndim, 1), data.dtype)
        if data.ndim:
            yield "short", values[: len(values) // 2]
            yield "flat", values.reshape(-1)[: max(1, values.size // 2)]
            yield "deep", values[..., None]
        yield "text", np.array(b"text")
        if data.dtype.kind == "f":
            yield "nan", np.full_like(values, np.nan)
            yield "inf", np.full_like(values, 1e300)
            yield "complex", values.astype(complex)
        if data.dtype.kind in "iu":
            yield "minus", np.full_like(values, -1)
            yield "large", np.full_like(values, 2**30)
        if data.dtype.kind in "SO":
            yield "numbers", np.arange(data.size or 1)

    def test_data_sets(self):
        sound, names = self.path.read_bytes(), []
        with h5py.File(self.path) as file:
            file.visititems(lambda name, found: names.append(name) if isinstance(found, h5py.Dataset) else None)
        names = [name for name in names if not name.startswith(("checkpoint", "checkpoints"))]
        self.assertGreater(len(names), 40)
        few = not os.environ.get("HAWSER_FULL")
        turn = refused = 0
        for name in names[:: 3 if few else 1]:
            with h5py.File(self.path) as file:
                harms = [(what, harm) for what, harm in self.harms(file[name])]
            for what, harm in harms:
                with h5py.File(self.path, "a") as file:
                    attributes = dict(file[name].attrs)
                    del file[name]
                    if harm is not None:
                        file[name] = harm
                        file[name].attrs.update(attributes)
                # All tools open a file in the same way. By default a third of the data sets is damaged, and every
                # twentieth damaged file is opened by one of them in turn.
                try:
                    Results(self.path)
                    turn += 1
                    if not few:
                        self.judge(f"{name} {what}")
                    elif turn % 20 == 0:
                        self.judge(f"{name} {what}", [self.TOOLS[turn // 20 % len(self.TOOLS)]])
                except Refusal as refusal:
                    refused += 1
                    self.assertNotIn("\n", str(refusal))
                self.path.write_bytes(sound)
        self.assertGreater(refused, 50 if few else 150)

    def test_files(self):
        sound = self.path.read_bytes()
        for what, data in (("empty", b""), ("text", b"hawser: 1\n"), ("half", sound[: len(sound) // 2]), ("short", sound[:-100]),
                           ("long", sound + b"more"), ("zeros", sound[:2048] + bytes(len(sound) - 2048))):
            self.path.write_bytes(data)
            self.judge(what, self.TOOLS[:3])
        self.path.write_bytes(sound)
        with h5py.File(self.path, "w") as file:
            file.attrs["hawser_results"] = "1"
        self.judge("nothing in it", self.TOOLS[:3])


class Interrupted(Attack):
    def test_ctrl_c(self):
        for words, waits in ((["export", "run.h5"], (0.0, 0.05, 0.2, 0.5)), (["report", "run.h5"], (0.3, 1.0)), (["pipe", "run.h5"], (0.1,))):
            for wait in waits:
                with self.subTest(words=words, wait=wait):
                    process = subprocess.Popen([HAWSER, *words], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                               start_new_session=True)
                    time.sleep(wait)
                    os.killpg(process.pid, signal.SIGINT)
                    _, err = process.communicate(timeout=120)
                    # Before Python starts, the signal ends the program; at the end of the run, it comes too
                    # late.
                    self.assertIn(process.returncode, (130, -signal.SIGINT, 0))
                    self.assertEqual(err, "hawser: stopped by Ctrl-C\n" if process.returncode == 130 else "")

    def test_ctrl_c_within_a_finalizer(self):
        """Python ignores exceptions in finalizers; the command still ends."""
        write(self.folder, "sitecustomize.py", """
import signal, sys
class Interrupt:
    def __del__(self):
        signal.raise_signal(signal.SIGINT)
class Finder:
    def find_spec(self, name, *_):
        if name == "hawser_post.results":
            Interrupt()
sys.meta_path.insert(0, Finder())
""")
        done = subprocess.run([HAWSER, "report", "run.h5"], cwd=self.folder, capture_output=True, text=True, timeout=120,
                              env={**os.environ, "PYTHONPATH": str(self.folder)})
        self.assertEqual((done.returncode, done.stderr), (130, "hawser: stopped by Ctrl-C\n"))

    def test_ctrl_c_while_a_case_runs(self):
        """The run ends with its results so far, which are shown."""
        write(self.folder, "long.yaml", CASE.replace("duration: 2, step: 0.05", "duration: 5000, step: 0.005")
              .replace("table: {file: lines.csv}", "velocity: [0, 0, 0]"))
        process = subprocess.Popen([HAWSER, "export", "long.yaml"], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                   start_new_session=True)
        table = self.folder / "long.xdmf"
        until = time.monotonic() + 120
        while (not table.exists() or table.read_text().count("<Time") < 3) and time.monotonic() < until:
            time.sleep(0.05)
        os.killpg(process.pid, signal.SIGINT)
        out, err = process.communicate(timeout=120)
        self.assertEqual((process.returncode, err), (0, ""))
        self.assertIn("stopped by a signal", out)
        self.assertIn("long/lines.csv", out)


if __name__ == "__main__":
    unittest.main()
