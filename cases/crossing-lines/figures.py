"""The force on the wire from the hose that is drawn over it.

    python3 cases/crossing-lines/figures.py [cases/crossing-lines/crossing-lines.h5]

Sums over the wire's nodes at every output: the force across (-z), along the way of the hose (y), their ratio, and where
the middle of the wire is. Reads the results with h5dump, so it needs nothing but Python's own library.
"""
import os
import re
import subprocess
import sys


def read(path, name):
    text = subprocess.run(["h5dump", "-y", "-w", "0", "-m", "%.9g", "-d", name, path], capture_output=True, text=True,
                          check=True).stdout
    text = text[text.index("DATA {") + 6:]
    return [float(x) for x in re.findall(r"-?\d[\d.]*(?:e[-+]?\d+)?", text[:text.index("}")])]


def main():
    path = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                                              "crossing-lines.h5")
    times = read(path, "/outputs/time")
    line = read(path, "/nodes/line")
    wire = [i for i, l in enumerate(line) if l == 0]
    force = read(path, "/fields/line_contact_force")
    position = read(path, "/fields/position")
    depth = read(path, "/fields/line_penetration")
    nodes = len(line)
    print("   time   down N   along N  along/down  wire y m  wire z m  pressed mm")
    for k, t in enumerate(times):
        at = [3 * (k * nodes + i) for i in wire]
        down = -sum(force[i + 2] for i in at)
        along = sum(force[i + 1] for i in at)
        middle = at[len(at) // 2]
        if round(2 * t) % 4 and t < 13 or abs(down) < 1:
            continue
        print(f"{t:7.2f} {down:8.0f} {along:9.0f} {along / down:11.4f} {position[middle + 1]:9.4f} "
              f"{position[middle + 2]:9.4f} {1e3 * max(depth[k * nodes:(k + 1) * nodes]):9.2f}")


if __name__ == "__main__":
    main()
