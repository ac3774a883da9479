#!/usr/bin/env python3
"""CPU time of an S-lay of 3 km in a JONSWAP sea, and its roller peaks compared with a finer run.

    tests/bench/long_lay.py HAWSER [--duration 100] [--finer] [--keep FOLDER]

A 16 in pipe in 300 m of water over 15 roller boxes, four on the ramp of a barge and eleven on a stinger of 150 m radius;
elements of 0.5 m on the overbend, 4 m in the span and on the bed. The barge moves by responses of the size of a pipe
layer's, assumed, and the stinger with it. Prints the CPU seconds of statics (with the search for the length that gives
the tension) and of the motion, writing included, and the largest force of each box. --finer: runs it again with half the
elements and half the longest step, and prints by how much each box's peak differs.
"""
import argparse
import re
import resource
import subprocess
import tempfile
from pathlib import Path

import h5py
import numpy as np

# Period, direction, then amplitude and lag of surge, sway, heave, roll, pitch, yaw.
RAO = """5 180 0.01 90 0 0 0.02 0 0 0 0.05 90 0 0
7 180 0.06 90 0 0 0.08 0 0 0 0.25 90 0 0
9 180 0.18 90 0 0 0.25 0 0 0 0.45 90 0 0
11 180 0.33 90 0 0 0.45 0 0 0 0.55 90 0 0
14 180 0.55 90 0 0 0.70 0 0 0 0.50 90 0 0
20 180 0.85 90 0 0 0.92 0 0 0 0.30 90 0 0
"""
CASE = """hawser: 1
title: S-lay of 3 km in 300 m of water
environment:
  water: {{density: 1025}}
  waves: {{jonswap: {{hs: 2, tp: 9, gamma: 2, direction_deg: 180, seed: 1}}, ramp: 10}}
  seabed: {{depth: 300, normal_stiffness: {{per_area: 100 kN/m3}}, friction: 0.5}}
line_types:
  pipe:
    pipe: {{outer_diameter: 0.4064, wall_thickness: 0.0206, grade: X65}}
    Cd_normal: 1.2
    Ca_normal: 1
bodies:
  barge: {{position: [0, 0, 0], motion: {{rao: {{file: barge.rao}}}}}}
supports:
  stinger:
    body: barge
    path: {{from: [0, 0, 9], direction: [-1, 0, 0], segments: [{{length: 22}}, {{length: 100, radius: 150}}]}}
    boxes: [{{at: [4, 10, 16, 22, 31, 40, 49, 58, 67, 76, 85, 94, 103, 112, 121], above_path: 1, type: U,
             roller_diameter: 0.5, roller_length: 2, side_height: 1, normal_stiffness: 2.0e7}}]
lines:
  pipe:
    sections:
      - {{type: pipe, length: 150, element_length: {short}}}
      - {{type: pipe, length: 1050, element_length: {long}}}
      - {{type: pipe, length: 250, element_length: {middle}}}
      - {{type: pipe, length: 1550, element_length: {long}}}
    end_a: {{body: barge, at: [0, 0, 10.4532], direction: [-1, 0, 0], clamped: true}}
    end_b: {{anchor: [-2915, 0, -299.797]}}
    target: {{tension: 1400 kN, at: end_a, section: 4}}
contact: {{between_lines: false}}
dynamics: {{duration: {duration}{step}}}
output: {{every: 5, clashes: false}}
"""


def cpu_seconds(command, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(done.stdout + done.stderr)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before, done


def run(hawser, folder, name, options, refined):
    (folder / "barge.rao").write_text(RAO)
    step = f", max_step: {options.step / 2:.6g}" if refined and options.step else ""
    sizes = {key: size / (2 if refined else 1) for key, size in (("short", 0.5), ("middle", 2), ("long", 4))}
    (folder / f"{name}.yaml").write_text(CASE.format(duration=options.duration, step=step, **sizes))
    still, _ = cpu_seconds([hawser, "run", f"{name}.yaml", "--stop-at", "0.001", "-o", "still.h5"], folder)
    used, done = cpu_seconds([hawser, "run", f"{name}.yaml"], folder)
    used -= still
    output = re.search(r"energy:.*", done.stdout)
    with h5py.File(folder / f"{name}.h5") as f:
        rows = int(f["written"]["steps"][0])
        steps = f["series/solver"][:rows]
        peaks = {k: np.linalg.norm(f[f"series/stinger_{k}"][:rows, :3], axis=1).max() for k in range(1, 16)}
        nodes = len(f["nodes/arc_length"])
    options.step = steps[:, 0].max()
    print(f"{name}: {nodes} nodes, {rows} steps of up to {options.step:.4g} s, {steps[:, 1].mean():.2f} Newton iterations each; "
          f"statics {still:.1f} CPU s; {used:.1f} CPU s for {options.duration:g} s of motion, {options.duration / used:.1f} times "
          "faster than real time")
    print(f"  {output[0] if output else ''}")
    return peaks


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("hawser", type=Path)
    options.add_argument("--duration", type=float, default=100)
    options.add_argument("--finer", action="store_true")
    options.add_argument("--keep", type=Path, help="folder for the cases and their results")
    given = options.parse_args()
    given.step = None
    with tempfile.TemporaryDirectory() as scratch:
        folder = given.keep or Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        peaks = run(given.hawser.resolve(), folder, "long-lay", given, False)
        finer = run(given.hawser.resolve(), folder, "long-lay-finer", given, True) if given.finer else {}
    for k, peak in peaks.items():
        other = finer.get(k, 0)
        print(f"  box {k:2d}: {peak / 1e3:7.2f} kN" + (f", finer {other / 1e3:7.2f} ({100 * (peak / other - 1):+.1f} %)" if other else ""))


if __name__ == "__main__":
    main()
