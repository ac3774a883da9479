#!/usr/bin/env python3
"""CPU time of whole runs: a mooring chain in calm water, with many outputs, with few elements, and in irregular seas.

tests/bench/whole_runs.py [HAWSER]: runs each case five times in turn and prints the median of the CPU seconds.
tests/bench/whole_runs.py HAWSER --lines N: N such chains in one run, from 5 to 15 s, once."""
import resource
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

SECONDS = 600
CASE = """hawser: 1
environment:
  water: {{density: 1025, depth: 200}}
  seabed: {{depth: 200}}{sea}
line_types:
  chain: {{outer_diameter: 0.2, mass_per_length: 390, EA: 1.674 GN, bending: false, Cd_normal: 1.37, Cd_axial: 0.2}}
bodies:
  vessel: {{position: [0, 0, 0], motion: {{harmonic: {{amplitude: [0, 0, 2], period: 10}}, ramp: 10}}}}
lines:
{lines}
contact: {{between_lines: false}}
dynamics: {{duration: {seconds}{steps}}}
output: {{every: {every}}}
"""
LINE = """  chain {y}:
    sections: [{{type: chain, length: 760, elements: {elements}}}]
    end_a: {{anchor: [700, {y}, -200]}}
    end_b: {{body: vessel, at: [0, {y}, 0]}}"""
SEA = "\n  waves: {{jonswap: {{hs: 3, tp: 9, direction_deg: 0, components: {}}}}}"


def case_of(sea="", seconds=SECONDS, every=None, elements=100, lines=1, steps=""):
    chains = "\n".join(LINE.format(y=10 * i, elements=elements) for i in range(lines))
    return CASE.format(sea=sea, seconds=seconds, every=every or seconds, lines=chains, steps=steps)


RUNS = {
    "one output": case_of(),
    "outputs every 0.1 s": case_of(every=0.1),
    "20 elements": case_of(elements=20),
    "50 elements": case_of(elements=50),
    "200 components": case_of(sea=SEA.format(200)),
    "400 components": case_of(sea=SEA.format(400)),
    "400, steps of 0.15 s": case_of(sea=SEA.format(400), steps=", max_step: 0.15"),
}


def cpu_seconds(hawser, case):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([hawser, "run", case, "-q"], check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    hawser = Path(sys.argv[1] if len(sys.argv) > 1 else "build/hawser").resolve()
    taken = {name: [] for name in RUNS}
    with tempfile.TemporaryDirectory() as folder:
        case = Path(folder) / "case.yaml"

        def timed(text):
            case.write_text(text, "utf-8")
            return cpu_seconds(hawser, case)

        if sys.argv[2:3] == ["--lines"]:
            lines = int(sys.argv[3])
            used = timed(case_of(seconds=15, lines=lines)) - timed(case_of(seconds=5, lines=lines))
            a_node = 1e6 * used / (10 * 100 * lines)
            print(f"{lines} lines: {used:.2f} CPU s from 5 to 15 s, {a_node:.1f} µs a node and simulated second")
            return
        for _ in range(5):
            for name, text in RUNS.items():
                taken[name].append(timed(text))
    for name, seconds in taken.items():
        median = statistics.median(seconds)
        print(f"{name:20} {median:6.2f} CPU s, {1e3 * median / SECONDS:5.2f} ms a simulated second")


if __name__ == "__main__":
    main()
