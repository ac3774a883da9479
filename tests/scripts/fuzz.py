#!/usr/bin/env python3
"""Runs the program with mutants of a case, its meshes, its seabeds and its tables.

    tests/scripts/fuzz.py [--program FILE | --checker FILE] [--from N] [--mutants N] [--jobs N] [--keep FOLDER]

Mutant i is always the same. Each mutant is checked, and it is run if it is valid and only a file beside the case was
changed. Required: no crash; no report of a sanitizer; at most 20 s (300 s under sanitizers); exit code 0 or 2, for a
run also 3 or 4; and for an error one sentence on stderr that names the case or a file of it. Prints the number of each
mutant that fails this; --keep writes the files of these mutants to a folder. With --checker (tests/check_many of a
build) many mutants are checked in one process, and no mutant is run."""
import argparse
import os
import queue
import random
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent

CASE = """hawser: 1
title: all kinds of files
environment:
  water: {depth: 60, density: 1025}
  current: {profile: [{depth: 0, speed: 0.8, direction_deg: 60}, {depth: 60, speed: 0.3, direction_deg: 60}]}
  waves: {regular: {height: 2, period: 8, direction_deg: 180}}
  seabed: {BED, normal_stiffness: {per_length: 1e4}, friction: 0.5}
line_types:
  hose: {outer_diameter: 0.2, mass_per_length: 50, EA: 1e6, EI: 1e4, GJ: 1e4, Cd_normal: 1.2, Ca_normal: 1}
  chain: {outer_diameter: 0.1, mass_per_length: 100, EA: 1e6, bending: false}
bodies:
  barge: {motion: {table: {file: motion.txt}}}
  ship: {position: [200, 0, 0], motion: {rao: {file: ship.rao}}}
volumes:
  deck: {mesh: MESH, body: barge, normal_stiffness: {per_length: 1e5}}
  post: {shape: {cylinder: {from: [30, 5, -20], to: [30, 5, 5], radius: 1}}}
lines:
  riser:
    sections:
      - {type: hose, length: 60, elements: 12}
      - {type: chain, length: 40, elements: 8}
    end_a: {body: barge, at: [3, 0, -3]}
    end_b: {anchor: [70, 0, -50]}
  tie:
    sections: [{type: hose, length: 90, elements: 9}]
    end_a: {body: ship, at: [-100, 0, -5]}
    end_b: {anchor: [20, 30, -48]}
contact: {between_lines: {friction: 0.3, exclude: [[riser, tie]]}}
statics: false
dynamics: {duration: 0.02, step: 0.01}
output: {histories: [{line: riser, at: end_a}], format: [hdf5]}
"""
BEDS = ("depth: 50", "grid: {file: bed.xyz}", "mesh: {file: bed.obj}")
MESHES = ("box.obj", "box.stl", "box_binary.stl", "box.ply")

CORNERS = [(x, y, z) for z in (-2, 1) for y in (-2, 2) for x in (-2, 2)]
FACETS = [
    (0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5)
]  # fmt: skip


def seeds():
    """{name: bytes} of the valid files beside the case."""
    lines = lambda rows: ("\n".join(" ".join(map(str, r)) for r in rows) + "\n").encode()
    stl = b"solid box\n"
    binary = b" " * 80 + struct.pack("<I", len(FACETS))
    for f in FACETS:
        corners = [CORNERS[i] for i in f]
        stl += b"facet normal 0 0 0\nouter loop\n" + lines(("vertex", *c) for c in corners) + b"endloop\nendfacet\n"
        binary += struct.pack("<12fH", 0, 0, 0, *(x for c in corners for x in c), 0)
    ply = [
        "ply", "format ascii 1.0", "element vertex 8", "property float x", "property float y", "property float z",
        "element face 12", "property list uchar int vertex_indices", "end_header",
    ]  # fmt: skip
    places = [(x, y) for y in (-150, 0, 150) for x in (-100, 100, 300)]
    sheet = [(1, 2, 5), (1, 5, 4), (2, 3, 6), (2, 6, 5), (4, 5, 8), (4, 8, 7), (5, 6, 9), (5, 9, 8)]
    height = lambda x, y: -55 + 0.01 * x - 1e-4 * y * y
    return {
        "bed.xyz": lines((x, y, height(x, y)) for x, y in places),
        "bed.obj": lines([("v", x, y, height(x, y)) for x, y in places] + [("f", *t) for t in sheet]),
        "motion.txt": lines((t, 0.1 * t, 0, 0.2 * t * (10 - t), 0, t, 0) for t in range(11)),
        "ship.rao": b"# period, direction, six amplitudes with their lags\n"
        + lines((p, d, 0.3, 90, 0, 0, p / 20, 10, 0, 0, 0.2, 270, 0, 0) for d in (90, 180, 270) for p in (4, 6, 8, 12)),
        "box.obj": lines([("v", *c) for c in CORNERS] + [("f", *(i + 1 for i in f)) for f in FACETS]),
        "box.stl": stl + b"endsolid box\n",
        "box_binary.stl": binary,
        "box.ply": ("\n".join(ply) + "\n").encode() + lines(CORNERS) + lines((3, *f) for f in FACETS),
    }


NUMBERS = (
    b"0 -0 1 -1 2 3 1e-300 1e-30 1e-9 1e9 1e20 -1e20 1e38 1e39 1e160 -1e300 1e308 1e999 nan inf -inf 2147483647 "
    b"2147483648 -2147483649 4294967296 99999999999999999999 0x10 1.5 1. .5 1e 1,5 - + '' true ~ [] {} [1,2] 5m"
).split()
SPECIAL = b":{}[],-&*!|>'\"%@`#?\n\r\t \\.~<=0e+/\0\xff\x80"
# Keys that make a valid case expensive.
COSTLY = re.compile(rb"elements|duration|step|every")


def mutant(data, random, text):
    """Bytes with one to four changes."""
    data = bytearray(data)
    for _ in range(random.choice((1, 1, 1, 2, 2, 3, 4))):
        if not data:
            break
        at, way = random.randrange(len(data)), random.randrange(11 if text else 5)
        size = random.choice((1, 1, 2, 4, 20, 200))
        if way == 0:
            data[at] = random.randrange(256)
        elif way == 1:
            data[at] ^= 1 << random.randrange(8)
        elif way == 2:
            del data[at : at + size]
        elif way == 3:
            data[at:at] = data[random.randrange(len(data)) :][:size] * random.choice((1, 1, 1, 50))
        elif way == 4:
            del data[at if random.random() < 0.3 else len(data) - 1 - size :]
        elif way == 5:
            data[at : at + 1] = bytes([random.choice(SPECIAL)])
        elif way in (6, 7, 8):
            found = [m for m in re.finditer(rb"(?<![\w.])[-+]?\d[\d.eE+-]*", data)]
            if found:
                m = random.choice(found)
                line = data[data.rfind(b"\n", 0, m.start()) + 1 : m.start()]
                if COSTLY.search(line):
                    continue
                if way == 6:
                    data[m.start() : m.end()] = random.choice(NUMBERS)
                else:  # a digit of the text
                    digit = random.choice([i for i in range(m.start(), m.end()) if data[i : i + 1].isdigit()])
                    data[digit : digit + 1] = b"%d" % random.randrange(10)
        else:
            lines = data.splitlines(keepends=True)
            i, j = random.randrange(len(lines)), random.randrange(len(lines))
            if way == 9:
                lines[i], lines[j] = lines[j], lines[i]
            else:
                lines[i:i] = lines[j : j + random.choice((0, 1, 3))] or []
            data = bytearray(b"".join(lines))
    return bytes(data)


def make(number, folder):
    """Writes mutant `number`; True if the case file itself is unchanged."""
    pick = random.Random(f"hawser {number}")
    files = seeds()
    bed, mesh = pick.choice(BEDS), pick.choice(MESHES)
    case = CASE.replace("BED", bed).replace("MESH", mesh).encode()
    used = [mesh, "motion.txt", "ship.rao"] + [f for f in ("bed.xyz", "bed.obj") if f in bed]
    chosen = pick.choice(["case.yaml", "case.yaml"] + used)
    if chosen == "case.yaml":
        case = mutant(case, pick, True)
    else:
        files[chosen] = mutant(files[chosen], pick, chosen != "box_binary.stl")
    for name, data in files.items():
        (folder / name).write_bytes(data)
    (folder / "case.yaml").write_bytes(case)
    return chosen != "case.yaml"


SENTENCE = re.compile(r"\Ahawser: [^\n]*(case\.yaml|box\.|box_binary|bed\.|motion\.txt|ship\.rao|\blines? )[^\n]*\n\Z")


def wrong(program, command, folder, allowed, patience):
    """(exit code, complaint) of one start of the program; an empty complaint means success."""
    try:
        done = subprocess.run(
            [program, *command.split(), "case.yaml"], cwd=folder, capture_output=True, timeout=patience, check=False, stdin=subprocess.DEVNULL
        )
    except subprocess.TimeoutExpired:
        return None, f"{command} takes over {patience} s"
    stderr = done.stderr.decode("utf-8", "backslashreplace")
    if done.returncode not in allowed or "Sanitizer" in stderr or "runtime error" in stderr:
        return done.returncode, f"{command}: exit code {done.returncode}: {stderr[:1500]}"
    if done.returncode in (2, 3) and not SENTENCE.match(stderr):
        return done.returncode, f"{command}: not one sentence with the file: {stderr[:500]!r}"
    if done.returncode == 0 and stderr:
        return 0, f"{command}: exit code 0, but on stderr {stderr[:500]!r}"
    return done.returncode, ""


class Checker:
    """One process that checks mutants in sequence; restarted after a crash."""

    def __init__(self, program):
        self.program, self.process, self.stderr = program, None, None

    def wrong(self, folder, patience):
        """The same as the function `wrong`."""
        if not self.process:
            self.stderr = tempfile.TemporaryFile()
            self.process = subprocess.Popen([self.program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self.stderr)
        self.process.stdin.write(f"{folder}\n".encode())
        self.process.stdin.flush()
        alarm = threading.Timer(patience, self.process.kill)
        alarm.start()
        answer = self.process.stdout.readline().decode("utf-8", "backslashreplace")
        alarm.cancel()
        code, _, sentence = answer.partition(" ")
        code = int(code) if answer else self.process.wait()
        self.stderr.seek(0)
        stderr = self.stderr.read().decode("utf-8", "backslashreplace")
        if not answer or stderr:
            self.end()
            return code, f"check: exit code {code}: {stderr[:1500]}"
        if code not in (0, 2) or code == 2 and not SENTENCE.match(f"hawser: {sentence}"):
            return code, f"check: exit code {code}: {sentence[:500]!r}"
        return code, ""

    def end(self):
        if self.process:
            self.process.stdin.close(), self.process.stdout.close(), self.stderr.close()
            self.process.wait()
            self.process = None


def fuzz(program, first=0, mutants=200, jobs=2, keep=None, many=False):
    """Complaints about the mutants first ... first + mutants - 1, and the number of mutants by exit code of
    the check.

    many: `program` checks many mutants in one process, and no mutant is run."""
    program = str(Path(program).resolve())
    patience = 300 if "ASAN_OPTIONS" in os.environ else 120
    checkers = queue.SimpleQueue()
    for _ in range(jobs):
        checkers.put(Checker(program))

    def check(folder):
        if not many:
            return wrong(program, "check --quick", folder, (0, 2), patience)
        checker = checkers.get()
        try:
            return checker.wrong(folder, patience)
        finally:
            checkers.put(checker)

    def one(number):
        with tempfile.TemporaryDirectory(prefix="hawser-fuzz-") as name:
            folder = Path(name)
            run_too = make(number, folder)
            code, complaint = check(folder)
            if code == 0 and run_too and not complaint and not many:
                complaint = wrong(program, "run", folder, (0, 2, 3, 4), patience)[1]
            if complaint and keep:
                shutil.copytree(folder, Path(keep) / str(number), dirs_exist_ok=True)
            return code, complaint and f"mutant {number}: {complaint}"

    with ThreadPoolExecutor(jobs) as pool:
        results = list(pool.map(one, range(first, first + mutants)))
    for _ in range(jobs):
        checkers.get().end()
    codes = [code for code, _ in results]
    return [c for _, c in results if c], {code: codes.count(code) for code in set(codes)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=os.environ.get("HAWSER", str(ROOT / "build/hawser")))
    parser.add_argument("--checker")
    parser.add_argument("--from", dest="first", type=int, default=0)
    parser.add_argument("--mutants", type=int, default=200)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--keep")
    given = parser.parse_args()
    complaints, codes = fuzz(
        given.checker or given.program, given.first, given.mutants, given.jobs, given.keep, many=bool(given.checker)
    )
    print(*complaints, sep="\n")
    print(f"{given.mutants} mutants, exit codes {codes}, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
