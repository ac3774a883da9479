#!/usr/bin/env python3
"""A farm of chains from anchors to floats with a prescribed motion, three to a float: its case, CPU time, calls of MPI.

    tests/bench/farm.py case LINES OUTPUT.yaml
    tests/bench/farm.py cost HAWSER --lines 1000 10000 --ranks 1 2
    tests/bench/farm.py cost HAWSER --lines 1000 10000 --ranks 1 2 --placed
    tests/bench/farm.py counts HAWSER --counter build/tests/libmpi_counts.so --lines 100 1000 --ranks 2 4 8
    tests/bench/farm.py memory HAWSER --counter build/tests/libmpi_counts.so --lines 4000 8000 --ranks 4 8
    tests/bench/farm.py scaling HAWSER --counter build/tests/libmpi_counts.so --lines 1000 4000 --ranks 2 4 8 16 --of 10000
"""
import argparse
import math
import os
import resource
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

DEPTH, LENGTH, DISTANCE, RADIUS, SPACING = 200.0, 760.0, 700.0, 40.0, 1600.0  # m
CHAINS = 3  # of a float
HEAD = f"""hawser: 1
title: Farm of {{lines}} chains
environment:
  water: {{{{density: 1025, depth: {DEPTH:g}}}}}
  seabed: {{{{depth: {DEPTH:g}, friction: {{{{axial: 0.5, lateral: 0.5}}}}}}}}
line_types:
  chain: {{{{outer_diameter: 0.2, mass_per_length: 390, EA: 1.674 GN, bending: false, Cd_normal: 1.37, Cd_axial: 0.2}}}}
bodies:
{{bodies}}
lines:
{{chains}}
statics: {{{{enabled: {{statics}}}}}}
dynamics: {{{{duration: {{duration}}, step: {{step}}}}}}
output: {{{{every: {{every}}}}}}
"""
ALONE = {"Send", "Isend", "Startall", "pread", "Memory", "Allocated"}  # counted on one rank without the others
MOTION = "motion: {harmonic: {amplitude: [1, 0, 2], period: 10}, ramp: 10}"


def positions(lines):
    """Of the floats, on a square grid, so far apart that their chains do not touch, m."""
    floats = -(-lines // CHAINS)
    columns = math.ceil(math.sqrt(floats))
    return [(SPACING * (i % columns), SPACING * (i // columns)) for i in range(floats)]


def farm(lines, elements=10, duration=2.0, step=0.1, every=1.0, statics=True):
    """The text of the case file, with every body and line."""
    bodies, chains, places = [], [], positions(lines)
    for i, (x, y) in enumerate(places):
        bodies.append(f"  float {i + 1}: {{position: [{x:g}, {y:g}, 0], {MOTION}}}")
    for k in range(lines):
        i, way = k // CHAINS, 2 * math.pi * (k % CHAINS) / CHAINS + 0.1
        x, y = places[i]
        c, s = math.cos(way), math.sin(way)
        chains.append(
            f"  chain {k + 1}: {{sections: [{{type: chain, length: {LENGTH:g}, elements: {elements}}}], "
            f"end_a: {{anchor: [{x + (RADIUS + DISTANCE) * c:.6g}, {y + (RADIUS + DISTANCE) * s:.6g}, -{DEPTH:g}]}}, "
            f"end_b: {{body: float {i + 1}, at: [{RADIUS * c:.6g}, {RADIUS * s:.6g}, 0]}}}}"
        )
    return HEAD.format(
        lines=lines, bodies="\n".join(bodies), chains="\n".join(chains), duration=duration, step=step, every=every,
        statics=str(statics).lower()
    )


def placed(lines, platform, **settings):
    """The text of the case file of the same farm by the key `farm`; writes the file of its platform, of three lines."""
    platform.write_text(farm(CHAINS, **settings), "utf-8")
    lines_of_file = farm(CHAINS, **settings).splitlines(keepends=True)
    head = [line for line in lines_of_file if not line.startswith(("bodies:", "lines:", "line_types:", "  float ", "  chain"))]
    places = ", ".join(f"[{x:g}, {y:g}]" for x, y in positions(lines))
    return "".join(head) + f"farm: {{of: {platform.name}, at: [{places}]}}\n"


def edges(ropes, duration, step, every, falling=False):
    """The text of the case file of ropes beside each other over the edge of one box, under 1 kN. The end of the first one
    is pulled, and the error of its tension on the edge grows from step to step, none of which is divided. Contacts are not reported one by one. falling: all ropes fall on the box, without statics."""
    winch, held = (1.085, -0.1812), (-0.99, 0.01)  # x and z of the ends, m
    lines = []
    for k in range(ropes):
        y, pulled = 0.5 * k, k == 0
        corner = f"[0, {y:g}, 0.01], [0.001736, {y:g}, 0.009848]"
        lines.append(
            f"  rope {k + 1}:\n    sections: [{{type: rope, length: {2.091 if pulled else 2.02}, elements: 10}}]\n"
            f"    end_a: {{anchor: [{held[0]}, {y:g}, {held[1]}]}}\n    end_b: {'{body: winch, at: [0, 0, 0]}' if pulled else 'free'}\n"
            f"    start: {{points: [[{held[0]}, {y:g}, {held[1]}], {corner}, [{winch[0]}, {y:g}, {winch[1]}]]}}"
            + ("" if pulled else "\n    loads: [{at: end_b, force: [984.808, 0, -173.648]}]")
        )
    width = 0.5 * ropes
    return f"""hawser: 1
environment: {{gravity: {9.81 if falling else 0}}}
line_types: {{rope: {{outer_diameter: 0.02, mass_per_length: 1, EA: 2 MN, stiffness_damping: 0.01, bending: false}}}}
bodies:
  winch: {{position: [{winch[0]}, 0, {winch[1]}], motion: {{harmonic: {{amplitude: [0.02, 0, -0.003], period: 1}}, ramp: 0.5}}}}
volumes: {{box: {{shape: {{box: {{centre: [-1.5, {0.5 * width:g}, -1.5], size: [3, {width + 2:g}, 3]}}}}}}}}
lines:
""" + "\n".join(lines) + f"""
statics: {str(not falling).lower()}
dynamics: {{duration: {duration:g}{'' if falling else f', step: {step:g}, resolve_impacts: false'}}}
output: {{every: {every:g}, clashes: false}}
"""


def run(hawser, ranks, case, environment=None, options=()):
    """CPU seconds of all ranks together. Ranks that share cores must not spin while they wait."""
    words = [hawser, "run", str(case), "-q", *options]
    if ranks > 1:
        words = ["mpirun", "--oversubscribe", "-n", str(ranks), *words]
    settings = {"OMPI_MCA_mpi_yield_when_idle": "1", "OMPI_MCA_hwloc_base_binding_policy": "none", **(environment or {})}
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(words, env={**os.environ, **settings}, capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"{' '.join(words)}\n{done.stderr}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def counted_by_rank(hawser, counter, ranks, case, folder, options=()):
    """What each rank of a run asks of MPI, and reads: [{function: (calls, bytes)}]."""
    path = Path(folder) / "counts"
    run(hawser, ranks, case, {"LD_PRELOAD": counter, "HAWSER_MPI_COUNTS": str(path)}, options)
    files = [Path(f"{path}.{rank}").read_text("utf-8").splitlines() for rank in range(ranks)]
    return [{name: (int(calls), float(size)) for name, calls, size in map(str.split, rows)} for rows in files]


def counted(hawser, counter, ranks, case, folder):
    """What the first rank of a run asks of MPI: {function: (calls, bytes)}."""
    return counted_by_rank(hawser, counter, ranks, case, folder)[0]


def collectives(counts):
    """Calls and bytes of all collective functions but those of files, which call such functions themselves."""
    found = [count for name, count in counts.items() if name not in ALONE and not name.startswith("File")]
    return sum(calls for calls, _ in found), sum(size for _, size in found)


def on_every_rank(growth):
    """A rank's memory for a line is r + s/ranks; its values for two numbers of ranks separate r from s. Returns r."""
    (few, at_few), (many, at_many) = sorted(growth.items())
    return (many * at_many - few * at_few) / (many - few)


def peak_memory(hawser, counter, ranks, case, folder, measure="Memory"):
    """Bytes of a rank, resident or, for the measure `Allocated`, allocated; the first rank writes descriptions, too."""
    counts = counted_by_rank(hawser, counter, ranks, case, folder)
    return statistics.median(each[measure][1] for each in counts[1:])


def cost(given, folder, lines, ranks):
    """CPU seconds of a rank around the steps, of statics and of a step: by runs of 1 and of 11 steps without statics, and of
    10 and of 60 steps with statics, with as many outputs; each the least of `given.repeat` runs. Without statics the lines
    are not at rest, and a step takes more iterations."""
    used = {}
    for steps, statics in ((1, False), (11, False), (10, True), (60, True)):
        case = Path(folder) / "case.yaml"
        settings = {"elements": given.elements, "duration": 0.1 * steps, "step": 0.1, "every": 0.1 * steps, "statics": statics}
        if given.placed:
            case.write_text(placed(lines, Path(folder) / "platform.yaml", **settings), "utf-8")
        else:
            case.write_text(farm(lines, **settings), "utf-8")
        used[steps] = min(run(given.hawser, ranks, case) for _ in range(given.repeat)) / ranks
    step = (used[60] - used[10]) / 50
    around = used[1] - (used[11] - used[1]) / 10
    return around, used[10] - 10 * step - around, step


def print_cost(given, folder):
    print("lines  ranks  CPU s of a rank: around the steps, statics, a step")
    for lines in given.lines:
        for ranks in given.ranks:
            around, statics, step = cost(given, folder, lines, ranks)
            print(f"{lines:5}  {ranks:5}  {around:.2f}  {statics:.2f}  {step:.4f}")


def counts_of_run(given, folder, lines, ranks):
    """Collective calls and their bytes: of a step; of a run of 10 steps."""
    found = {}
    for duration in (1, 2):
        case = Path(folder) / "case.yaml"
        case.write_text(farm(lines, given.elements, duration, 0.1, duration), "utf-8")
        found[duration] = counted(given.hawser, given.counter, ranks, case, folder)
    (calls, size), longer = collectives(found[1]), collectives(found[2])
    return ((longer[0] - calls) / 10, (longer[1] - size) / 10), (calls, size)


def print_counts(given, folder):
    print("lines  ranks  collective calls (bytes): a step; a run of 10 steps")
    for lines in given.lines:
        for ranks in given.ranks:
            step, whole = counts_of_run(given, folder, lines, ranks)
            print(f"{lines:5}  {ranks:5}  {step[0]:.1f} ({step[1]:.0f})  {whole[0]} ({whole[1]:.0f})")


def memory(given, folder, ranks):
    """Peaks of a rank for the smaller and larger number of lines, from runs of two steps, bytes."""
    peaks = []
    for lines in given.lines:
        case = Path(folder) / "case.yaml"
        case.write_text(farm(lines, given.elements, 0.2, 0.1, 0.2), "utf-8")
        peaks.append(peak_memory(given.hawser, given.counter, ranks, case, folder))
    return peaks


def print_memory(given, folder):
    few, many = given.lines
    growth = {}
    for ranks in given.ranks:
        peaks = memory(given, folder, ranks)
        growth[ranks] = (peaks[1] - peaks[0]) / (many - few)
        print(f"{ranks} ranks: {growth[ranks]:.0f} B a line on each, peaks {peaks[0] / 1e6:.0f} and {peaks[1] / 1e6:.0f} MB")
    print(f"of a line of other ranks: {on_every_rank(growth):.0f} B")


def print_scaling(given, folder):
    """Extrapolates to more ranks. A rank needs of each of the N lines r + s/P (CPU time, memory) on P ranks, with r and s
    from two numbers of ranks and N from two numbers of lines. A collective call takes `latency` for each doubling of the
    ranks, as in a binary tree. Peaks on 8 ranks give the memory that does not depend on lines; CPU time that does not,
    about 0.1 s, is excluded."""
    few, many = given.lines
    growth = {}
    for ranks in (1, 2):
        small, large = cost(given, folder, few, ranks), cost(given, folder, many, ranks)
        growth[ranks] = [(b - a) / (many - few) for a, b in zip(small, large)]
    by_line = [(2 * two - one, 2 * (one - two)) for one, two in zip(growth[1], growth[2])]
    calls = {ranks: counts_of_run(given, folder, few, ranks)[0][0] for ranks in given.ranks}
    print("collective calls of a step: " + ", ".join(f"{n:.1f} on {ranks} ranks" for ranks, n in calls.items()))
    of_ranks = {}
    for ranks in (4, 8):
        peaks = memory(given, folder, ranks)
        of_ranks[ranks] = (peaks[1] - peaks[0]) / (many - few)
    replicated = on_every_rank(of_ranks)
    own = 8 * (of_ranks[8] - replicated)
    rest = peaks[0] - few * of_ranks[8]
    print(f"{given.of} lines of {given.elements} elements; {1e6 * given.latency:g} us for each doubling of the ranks")
    print("ranks  lines of a rank  CPU s around the steps  statics  ms a step: CPU, calls  MB of a rank")
    for ranks in (1, 16, 256, 1000):
        share = math.ceil(given.of / ranks)
        around, statics, step = (max(r, 0) * given.of + s * share for r, s in by_line)
        waiting = max(calls.values()) * given.latency * math.log2(ranks)
        size = rest + given.of * replicated + share * own
        print(f"{ranks:5}  {share:5}  {around:.2f}  {statics:.3f}  {1e3 * step:.2f}, {1e3 * waiting:.2f}  {size / 1e6:.0f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    what = parser.add_subparsers(dest="what", required=True)
    case = what.add_parser("case", help="write the case")
    case.add_argument("lines", type=int)
    case.add_argument("output", type=Path)
    for name, text in (("cost", "measure CPU time"), ("counts", "count calls of MPI"),
                       ("memory", "measure the memory of a rank for lines of other ranks"),
                       ("scaling", "extrapolate CPU time, calls and memory to 16, 256 and 1000 ranks")):
        measure = what.add_parser(name, help=text)
        measure.add_argument("hawser")
        measure.add_argument("--lines", type=int, nargs="+", default=[100, 1000])
        measure.add_argument("--ranks", type=int, nargs="+", default=[1, 2])
        if name != "cost":
            measure.add_argument("--counter", required=True, help="libmpi_counts.so of the build")
    scaling = what.choices["scaling"]
    scaling.add_argument("--of", type=int, default=10000, help="lines of the farm in the table")
    scaling.add_argument("--latency", type=float, default=2e-6, help="of a collective call for each doubling of the ranks, s")
    for each in what.choices.values():
        each.add_argument("--repeat", type=int, default=3, help="runs of which the least CPU time counts")
        each.add_argument("--elements", type=int, default=10)
        each.add_argument("--placed", action="store_true", help="the farm as places of one platform file; for CPU time")
    given = parser.parse_args()
    if given.what == "case":
        given.output.write_text(farm(given.lines, given.elements), "utf-8")
        return
    with tempfile.TemporaryDirectory() as folder:
        {"cost": print_cost, "counts": print_counts, "memory": print_memory, "scaling": print_scaling}[given.what](given, folder)


if __name__ == "__main__":
    main()
