#!/usr/bin/env python3
"""hawser and MoorDyn side by side: error and CPU time of the same cases, as one table in Markdown.

tests/bench/beside_moordyn.py [HAWSER] [--moordyn LIBMOORDYN.so] [--cases NAME ...] [--quick]

MoorDyn 2 is not part of hawser: --moordyn names the shared library of an installation, and moorings/moordyn_driver.cpp is
compiled against it. Without it the table has the rows of hawser and the published figures. Cases: moorings/cases.py.

Errors are those of standard deviation and peak of the tension at the first fairlead, and of the largest curvature
where a case has bending: against published figures of OrcaFlex where a case has them, otherwise against the converged
run of the same program. For each target the mesh and step of least CPU time are selected whose errors, and those of
all finer meshes, are within the target; MoorDyn's steps are those with which the first line is stable. The choices
are timed in turn, five times (once where a run takes more than 20 s): CPU seconds (user and system) of the whole
process, and those of a simulated second by the difference from a run of a quarter of the duration. MoorDyn's tension
is its force on the fairlead or, "FairTen", that of the last segment, which is what its output has. --quick: one case
on coarse meshes, for the test of this script."""
import argparse
import array
import math
import os
import resource
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path
from types import SimpleNamespace

from moorings.cases import CASES, QUICK, hawser_file, moordyn_file

HERE = Path(__file__).resolve().parent
DRIVER = HERE / "moorings" / "moordyn_driver.cpp"
LONG = 20  # s: a run that is timed once
HEAD = ("case", "within", "program", "elements", "step, ms", "error of deviation / peak / curvature, %", "simulated s", "CPU s",
        "ms per simulated s", "MoorDyn/hawser: whole; per s", "published, s")


def read(file, name):
    """A data set of numbers of a results file."""
    raw = file.with_suffix(".raw")
    subprocess.run(["h5dump", "-d", name, "-b", "LE", "-o", raw, file], check=True, capture_output=True)
    return array.array("d", raw.read_bytes())


def errors(deviations, exact):
    """In per cent, of deviation, peak and curvature."""
    return [100 * (a / b - 1) if a and b else None for a, b in zip(deviations, exact)]


class Bench:
    def __init__(self, hawser, driver, folder):
        self.hawser, self.driver, self.folder = hawser, driver, Path(folder)

    def cpu(self, *command):
        """CPU seconds of a process, and the process."""
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, check=False,
                              env=os.environ | {"OMP_NUM_THREADS": "1"})
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, done

    def run_hawser(self, c, lines, mesh, step, seconds):
        """CPU seconds, {program: (deviation, peak, curvature)}; (seconds, None) where hawser reports that the step is too long."""
        (self.folder / "case.yaml").write_text(hawser_file(c, lines, mesh, step, seconds), "utf-8")
        used, done = self.cpu(self.hawser, "run", "case.yaml", "-q")
        if done.returncode in (3, 4):
            return used, None
        if done.returncode:
            sys.exit(f"hawser: {done.stderr}")
        tension = read(self.folder / "case.h5", "/statistics/effective_tension")
        bend = max(read(self.folder / "case.h5", "/statistics/curvature")[2::6]) if c.bends else None
        return used, {"hawser": (tension[5], tension[2], bend)}

    def run_moordyn(self, c, lines, mesh, step, seconds):
        """The same; (seconds, None) where it is not stable."""
        (self.folder / "deck.txt").write_text(moordyn_file(c, lines, mesh, step), "utf-8")
        (self.folder / "wave_frequencies.txt").write_text(
            "".join(f"{w} {a * math.cos(p)} {a * math.sin(p)}\n" for a, w, p in [(0, 0, 0), *c.sea]), "utf-8")
        used, done = self.cpu(self.driver, "deck.txt", str(seconds), str(step), str(c.ramp), "rows.txt",
                              *(str(x) for m in c.motion for x in m))
        if done.returncode == 3:
            return used, None
        if done.returncode:
            sys.exit(f"MoorDyn: {done.stdout}{done.stderr}")
        rows = [[float(x) for x in row.split()] for row in (self.folder / "rows.txt").read_text().splitlines()]
        columns = list(zip(*(row for row in rows if row[0] > min(c.since, seconds / 2))))
        bend = max(columns[3]) if c.bends else None
        return used, {name: (statistics.pstdev(columns[i]), max(columns[i]), bend) for name, i in c.columns.items()}

    def stable(self, c, mesh):
        """The largest step of MoorDyn, a part of 0.1 s, with which a mesh is stable, and the run with it."""
        m, EA, EI = max(c.types.values(), key=lambda t: t[2] / t[1])[1:4]
        l = sum(length for _, length in c.lines[0][2]) / mesh
        rate = 2 * math.sqrt(EA / m) / l, 4 * math.sqrt(EI / m) / l**2
        decay = 4 * (l * math.sqrt(EA * m) if c.damping is None else c.damping) / m / l**2
        n = max(1, int(0.025 * max(*rate, decay)))  # step of 4 over the fastest rate; decreases from there
        while True:
            used, deviations = self.run_moordyn(c, c.lines[:1], mesh, 0.1 / n, c.window)
            if deviations:
                return 0.1 / n, used, deviations
            n = math.ceil(1.15 * n)

    def candidates(self, c):
        """{program: [(mesh, step, CPU seconds, errors)]}; no errors where only a part of the case is run."""
        found = {"hawser": []}
        exact = {} if c.reference else self.run_hawser(c, c.lines[:1], *c.finest[:2], c.seconds)[1]
        for step in c.steps:
            rows = [(mesh, step, *self.run_hawser(c, c.lines, mesh, step, c.seconds)) for mesh in c.meshes]
            found["hawser"] += [row for row in rows if row[3]]
        if self.driver:
            if not c.reference and c.window == c.seconds:
                exact |= self.stable(c, c.finest[2])[2]
            for mesh in c.moordyn_meshes:
                step, used, deviations = self.stable(c, mesh)
                for name in deviations:
                    found.setdefault(name, []).append((mesh, step, used, deviations))
        return {name: [(mesh, step, used, errors(deviations[name], c.reference or exact.get(name, ())) if name == "hawser"
                        or c.window == c.seconds else []) for mesh, step, used, deviations in rows] for name, rows in found.items()}

    def choose(self, c, program, rows, goal):
        """The cheapest of the candidates that is within a goal with all that are finer; the finest where none is."""
        def finer(a, b):
            return b[0] >= a[0] and (program != "hawser" or b[1] == a[1])
        def within(row):
            return all(e is None or abs(e) <= goal for e in row[3])
        admissible = [row for row in rows if all(within(other) for other in rows if finer(row, other))]
        mesh, step, _, deviations = min(admissible, key=lambda row: row[2]) if admissible else rows[-1]
        first = program == "hawser"
        return SimpleNamespace(program=program, mesh=mesh, step=step, errors=deviations, run=self.run_hawser if first else
                               self.run_moordyn, seconds=c.timed if first or c.window == c.seconds else c.window)

    def time(self, c, choices):
        """Adds to each choice the CPU seconds of the whole process and those of a simulated second; in turn."""
        taken = [[] for _ in choices]
        for _ in range(5):
            for o, rows in zip(choices, taken):
                if not rows or rows[0][0] < LONG:
                    runs = [o.run(c, c.lines, o.mesh, o.step, seconds) for seconds in (o.seconds, o.seconds / 4)]
                    if not all(deviations for _, deviations in runs):
                        sys.exit(f"{o.program}: a step of {o.step} s is too long with {o.mesh} elements of all lines")
                    rows.append([used for used, _ in runs])
        for o, rows in zip(choices, taken):
            o.whole = statistics.median(whole for whole, _ in rows)
            o.second = statistics.median(whole - part for whole, part in rows) / (0.75 * o.seconds)

    def rows(self, name, c):
        """Prints the rows of a case."""
        found, published = self.candidates(c), c.published
        for goal in c.goals:
            choices = [self.choose(c, program, rows, goal) for program, rows in found.items()]
            self.time(c, choices)
            first = choices[0]
            for o in choices:
                step = o.step if o.step == "auto" else f"{1e3 * o.step:.3g}"
                error = " / ".join("–" if e is None else f"{e:+.2f}" for e in o.errors) or "–"
                whole = f"{o.whole / first.whole:.1f}" if o.seconds == first.seconds else "–"
                ratio = "" if o is first else f"{whole}; {o.second / first.second:.1f}"
                print(f"| {name} | {goal} % | {o.program} | {o.mesh} | {step} | {error} | {o.seconds} | {o.whole:.2f} "
                      f"| {1e3 * o.second:.2f} | {ratio} | {published} |", flush=True)
                published = ""


def compiled(library, folder):
    """The driver of MoorDyn, or None."""
    if not library:
        return None
    library, driver = Path(library).resolve(strict=True), Path(folder) / "driver"
    subprocess.run([os.environ.get("CXX", "c++"), "-std=c++20", "-O3", "-march=native", DRIVER, library,
                    f"-Wl,-rpath,{library.parent}", "-o", driver], check=True)
    return driver


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("hawser", nargs="?", default=HERE.parent.parent / "build" / "hawser", type=Path)
    parser.add_argument("--moordyn", metavar="LIBRARY")
    parser.add_argument("--cases", nargs="+", choices=CASES, default=list(CASES))
    parser.add_argument("--quick", action="store_true")
    options = parser.parse_args()
    print("| " + " | ".join(HEAD) + " |\n" + len(HEAD) * "|---" + "|", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(options.hawser.resolve(), compiled(options.moordyn, folder), folder)
        for name, c in (QUICK if options.quick else {name: CASES[name] for name in options.cases}).items():
            bench.rows(name, c)


if __name__ == "__main__":
    main()
