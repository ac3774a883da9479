"""What the pipe on the roller should do, in closed form, beside what the run found.

    python3 cases/roller/figures.py [cases/roller/roller.h5]

Elastica: where a leg leaves the roller at the angle a to its own far straight part, M = 2 sqrt(EI T) sin(a / 2).
The two moments are the same, and the forces at the roller are N across the pipe and mu N along it:

    T1 cos a1 = T2 cos a2 + mu N,    N = T1 sin a1 + T2 sin a2,    a1 + a2 = 0.5 rad

Reads the results with h5dump, so it needs nothing but Python's own library.
"""
import math
import os
import re
import subprocess
import sys

EI, T2, THETA, MU = 2.0e5, 20.0e3, 0.5, 0.3


def expected():
    def at(a1):
        a2 = THETA - a1
        pull = T2 * (math.cos(a2) + MU * math.sin(a2)) / (math.cos(a1) - MU * math.sin(a1))
        normal = pull * math.sin(a1) + T2 * math.sin(a2)
        first, second = (2 * math.sqrt(EI * t) * math.sin(a / 2) for t, a in ((pull, a1), (T2, a2)))
        return first - second, pull, normal, first

    low, high = 0.0, THETA
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (low, middle) if at(middle)[0] > 0 else (middle, high)
    return at(low)[1:]


def numbers(file, dataset):
    """All numbers of a dataset, row after row."""
    text = subprocess.run(["h5dump", "-y", "-w", "1", "-m", "%.12g", "-d", dataset, file],
                          check=True, capture_output=True, text=True).stdout
    data = text[text.index("DATA {"):text.index("ATTRIBUTE") if "ATTRIBUTE" in text else None]
    return [float(word) for word in re.findall(r"^\s*([-+0-9.e]+|nan|inf),?$", data, re.M)]


def column(file, dataset, name):
    head = subprocess.run(["h5dump", "-A", "-d", dataset, file], check=True, capture_output=True, text=True).stdout
    head = head.replace("\\000", "")
    names = re.findall(r'"([^"]*)"', head[head.index('ATTRIBUTE "columns"') + len('ATTRIBUTE "columns"'):])
    count = int(re.search(r"SIMPLE { \( \d+, (\d+) \)", head).group(1))
    values = numbers(file, dataset)
    return values[names.index(name)::count]


def show(what, unit, value, found):
    mean = sum(found) / len(found)
    scatter = math.sqrt(sum((v - mean) ** 2 for v in found) / len(found))
    print(f"{what:28} {value:10.2f} {mean:10.2f} {unit:4} {100 * (mean / value - 1):+7.3f} %   "
          f"{100 * scatter / mean:6.3f} %   {100 * (max(found) - min(found)) / mean:6.3f} %")


def main(file, start=35.0):
    pull, normal, moment = expected()
    print("what                           expected      found      difference   scatter, rms   largest - least")
    times = numbers(file, "/series/time")
    tension = column(file, "/series/tug", "effective_tension")
    show("pull of the tug", "N", pull, [v for t, v in zip(times, tension) if t >= start])
    outputs = numbers(file, "/outputs/time")
    nodes = len(numbers(file, "/nodes/arc_length"))
    late = [i for i, t in enumerate(outputs) if t >= start]

    def total(dataset, length):
        values = numbers(file, dataset)
        return [math.sqrt(sum(sum(values[(i * nodes + n) * length + c] for n in range(nodes)) ** 2
                              for c in range(length))) for i in late]

    show("normal force of the roller", "N", normal, total("/fields/contact_normal_force", 1))
    show("friction of the roller", "N", MU * normal, total("/fields/friction_force", 3))
    bending = numbers(file, "/fields/bending_moment")
    show("largest bending moment", "N m", moment, [max(bending[i * nodes:(i + 1) * nodes]) for i in late])


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), "roller.h5"))
