#!/usr/bin/env python3
"""Statics of random S-lays: how many converge without changes, and the messages of the others.

    tests/bench/random_s_lays.py HAWSER [--count 200] [--first 0] [--keep FOLDER]

Water of 20 to 2000 m, steel pipes of 6 to 36 in that sink, a stinger that bends them to 0.1 to 0.25 % of strain with
rollers as flat, V, U or box 3 to 15 m apart, tensions so that the pipe leaves at 15 to 75 degrees, on the stinger or off
its end, and a length that is up to 0.2 % of the hanging part off. Prints a line for each that fails, and the shares.
"""
import argparse
import math
import random
import re
import subprocess
import tempfile
import time
from pathlib import Path

STEEL, WATER, G = 7850, 1025, 9.80665


def s_lay(seed):
    rng = random.Random(seed)
    depth = 20 * 100 ** rng.random()
    outer = rng.uniform(6, 36) * 0.0254
    wall = outer * rng.uniform(0.04, 0.07)
    area = math.pi * wall * (outer - wall)
    submerged = G * (STEEL * area - WATER * math.pi / 4 * outer**2)
    radius = outer / (2 * rng.uniform(0.001, 0.0025))
    spacing = rng.uniform(3, 15)
    top = rng.uniform(4, 12)
    # Lift-off angle: at most a third of the way down, and such that the sagbend does not buckle.
    leaves = math.radians(rng.uniform(15, 75))
    while leaves > math.radians(12) and radius * (1 - math.cos(leaves)) > 0.35 * (depth + top):
        leaves *= 0.9
    z = top - radius * (1 - math.cos(leaves))
    deep = z + depth
    scale = deep / (1 / math.cos(leaves) - 1)
    scale = max(scale, 1.2 * radius)  # the sagbend has at most the curvature of the overbend
    leaves = math.acos(1 / (1 + deep / scale))
    hanging = scale * math.tan(leaves)
    ramp = rng.uniform(5, 60)
    arc = radius * leaves
    laid = max(100.0, 0.3 * hanging)
    stinger = arc * rng.choice([rng.uniform(0.7, 1), rng.uniform(1, 1.4)])
    stinger = min(stinger, math.radians(85) * radius)
    end_x = ramp + radius * math.sin(leaves) + scale * math.asinh(math.tan(leaves)) + laid
    over = ramp + max(arc, stinger) + 2 * spacing
    length = ramp + arc + hanging * (1 + rng.uniform(-0.002, 0.002)) + laid
    kind = rng.choice(["flat", "V", "U", "box"])
    more = {"flat": "", "V": f", angle_deg: {rng.uniform(10, 45):.3f}", "U": f", side_height: {2 * outer:.4f}",
            "box": f", side_height: {2 * outer:.4f}"}[kind]
    roller = rng.uniform(0.2, 0.6)
    stations = []
    s = rng.uniform(0.3, 1) * spacing
    while s <= ramp + stinger:
        stations.append(f"{s:.4f}")
        s += spacing
    rise = 0.5 * roller + 0.5 * outer
    if kind == "V":
        rise /= math.cos(math.radians(float(re.search(r"[\d.]+", more.split(":")[1])[0])))
    stiffness = rng.choice(["", f", normal_stiffness: {10 ** rng.uniform(7, 8.5):.4g}"])
    return f"""hawser: 1
environment:
  water: {{density: {WATER}}}
  seabed: {{depth: {depth:.4f}, friction: {rng.choice([0, 0.5])}}}
line_types:
  pipe: {{pipe: {{outer_diameter: {outer:.5f}, wall_thickness: {wall:.5f}}}}}
supports:
  stinger:
    path:
      from: [0, 0, {top - rise:.5f}]
      direction: [1, 0, 0]
      segments: [{{length: {ramp:.4f}}}, {{length: {stinger + 1:.4f}, radius: {radius - rise:.4f}}}]
    boxes: [{{at: [{', '.join(stations)}], type: {kind}, roller_diameter: {roller:.3f}, roller_length: {4 * outer:.3f}{more}{stiffness}}}]
lines:
  pipe:
    sections:
      - {{type: pipe, length: {over:.4f}, element_length: {spacing / 6:.4f}}}
      - {{type: pipe, length: {length - over - 0.8 * laid:.4f}, element_length: {max(1.0, hanging / 150):.4f}}}
      - {{type: pipe, length: {0.8 * laid:.4f}, element_length: {0.8 * laid / 20:.4f}}}
    end_a: {{anchor: [0, 0, {top:.5f}], direction: [1, 0, 0], clamped: true}}
    end_b: {{anchor: [{end_x:.4f}, 0, {-depth + 0.5 * outer:.5f}]}}
contact: {{between_lines: false}}
output: {{format: [hdf5]}}
"""


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("hawser")
    options.add_argument("--count", type=int, default=200)
    options.add_argument("--first", type=int, default=0)
    options.add_argument("--keep", help="folder for the cases")
    given = options.parse_args()
    failed, iterations, relaxed, seconds = 0, [], 0, []
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(given.keep or scratch)
        folder.mkdir(parents=True, exist_ok=True)
        for seed in range(given.first, given.first + given.count):
            path = folder / f"s-lay-{seed}.yaml"
            path.write_text(s_lay(seed))
            start = time.monotonic()
            done = subprocess.run([given.hawser, "run", str(path)], capture_output=True, text=True, timeout=900)
            seconds.append(time.monotonic() - start)
            output = done.stdout + done.stderr
            found = re.search(r"statics: (\d+) iterations(, \d+ steps of dynamic)?", output)
            if done.returncode or not found:
                failed += 1
                why = [line for line in output.splitlines() if "error" in line or "statics" in line]
                print(f"{seed}: {why[-1] if why else output[-300:]}", flush=True)
                continue
            iterations.append(int(found[1]))
            if found[2]:
                relaxed += 1
                print(f"{seed}: with dynamic relaxation, {seconds[-1]:.1f} s", flush=True)
            for line in output.splitlines():
                if "warning" in line:
                    print(f"{seed}: {line}", flush=True)
    iterations.sort()
    print(f"{given.count - failed} of {given.count} converged ({relaxed} of them with dynamic relaxation); iterations: "
          f"median {iterations[len(iterations) // 2]}, most {iterations[-1]}; seconds: most {max(seconds):.1f}, sum "
          f"{sum(seconds):.0f}")


if __name__ == "__main__":
    main()
