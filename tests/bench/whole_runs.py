#!/usr/bin/env python3
"""CPU time of whole runs: a mooring chain in calm water, with many outputs, and in irregular seas.

tests/bench/whole_runs.py [HAWSER]: runs each case five times in turn and prints the median of the CPU seconds."""
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
  chain:
    sections: [{{type: chain, length: 760, elements: 100}}]
    end_a: {{anchor: [700, 0, -200]}}
    end_b: {{body: vessel, at: [0, 0, 0]}}
contact: {{between_lines: false}}
dynamics: {{duration: {seconds}}}
output: {{every: {every}}}
"""
SEA = "\n  waves: {{jonswap: {{hs: 3, tp: 9, direction_deg: 0, components: {}}}}}"
RUNS = {
    "one output": CASE.format(sea="", seconds=SECONDS, every=SECONDS),
    "outputs every 0.1 s": CASE.format(sea="", seconds=SECONDS, every=0.1),
    "200 components": CASE.format(sea=SEA.format(200), seconds=SECONDS, every=SECONDS),
    "400 components": CASE.format(sea=SEA.format(400), seconds=SECONDS, every=SECONDS),
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
        for _ in range(5):
            for name, text in RUNS.items():
                case = Path(folder) / "case.yaml"
                case.write_text(text, "utf-8")
                taken[name].append(cpu_seconds(hawser, case))
    for name, seconds in taken.items():
        median = statistics.median(seconds)
        print(f"{name:20} {median:6.2f} CPU s, {1e3 * median / SECONDS:5.2f} ms a simulated second")


if __name__ == "__main__":
    main()
