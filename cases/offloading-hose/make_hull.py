#!/usr/bin/env python3
"""Writes hull.obj, a VLCC of 320 x 55 x 27 m at 21 m draught: bow, parallel middle body, stern with overhang.

    cases/offloading-hose/make_hull.py [OUTPUT.obj]

Body axes: x forward from midships, y to port, z up from the still water, so the keel is at z = -21 and the deck at z = 6.
One closed, manifold surface, its triangles anticlockwise seen from outside, in two groups: `active`, the stern and the
sides near the water, which a hose can meet, and `rest`.

Every section is a superellipse (y/b)^n + ((zd - z)/(zd - zk))^n = 1 between the keel zk(x) and the deck zd = 6 m; the
half breadth b(x), the keel and the exponent n(x) make the ship: b is that of a blunt bow of 70 m, 27.5 m amidships and
20 m at the transom, whose corners are round with 8 m; the keel rises over the last 55 m aft to the transom's lower
edge, 4 m under water; n goes from 5 aft and 3 at the bow to 12 amidships, a box with round bilges.
"""
import math
import sys
from collections import Counter
from pathlib import Path

LENGTH, BEAM, DEPTH, DRAUGHT = 320.0, 55.0, 27.0, 21.0  # m
DECK, KEEL = DEPTH - DRAUGHT, -DRAUGHT
AFT, FORE = -LENGTH / 2, LENGTH / 2
TRANSOM_BREADTH, TRANSOM_EDGE = 40.0, -4.0  # m; z of its lower edge
CORNER = 8.0  # m, radius of the transom's corners in plan
RUN, RISE, ENTRANCE, FOREFOOT = 85.0, 55.0, 70.0, 6.0  # m, how far the shape of stern and bow reaches
UPPER = 10  # rows from -12 m to the deck, on each side
LOWER = 7  # rows below
ACTIVE_FROM, ACTIVE_TO = AFT, 70.0  # m, x of the active part
ACTIVE_BELOW = -13.0  # m, its lower edge


def smooth(t):
    """0 to 1 with level ends."""
    t = min(1.0, max(0.0, t))
    return t * t * (3 - 2 * t)


def half_breadth(x):
    """m, of the deck."""
    if x > FORE - ENTRANCE:
        return BEAM / 2 * (1 - ((x - FORE + ENTRANCE) / ENTRANCE) ** 2.5) ** 0.5 if x < FORE else 0.0
    corner = max(0.0, 1 - (x - AFT) / CORNER)
    breadth = TRANSOM_BREADTH / 2 + (BEAM - TRANSOM_BREADTH) / 2 * smooth((x - AFT) / RUN) ** 0.7
    return breadth - CORNER * (1 - math.sqrt(1 - corner**2))


def keel(x):
    """m, z of the lowest point."""
    if x < AFT + RISE:
        return KEEL + (TRANSOM_EDGE - KEEL) * (1 - math.sin(math.pi / 2 * (x - AFT) / RISE))
    if x > FORE - FOREFOOT:
        return KEEL + FOREFOOT * (1 - math.sqrt(max(0.0, 1 - ((x - FORE + FOREFOOT) / FOREFOOT) ** 2)))
    return KEEL


def exponent(x):
    aft = 5 + 7 * smooth((x - AFT) / (1.2 * RUN))
    return min(aft, 3 + 9 * smooth((FORE - x) / (1.2 * ENTRANCE)))


def section(x):
    """(y, z) from the keel (y = 0) to the deck's edge."""
    b, zk, n = half_breadth(x), keel(x), exponent(x)
    height = DECK - zk
    fine = []
    for i in range(4001):
        angle = math.pi / 2 * i / 4000
        fine.append((b * math.sin(angle) ** (2 / n), DECK - height * math.cos(angle) ** (2 / n)))
    fine[0], fine[-1] = (0.0, zk), (b, DECK)
    upper = max(-12.0, zk + 0.45 * height)
    below = [p for p in fine if p[1] <= upper]
    arc = [0.0]
    for p, q in zip(below, below[1:]):
        arc.append(arc[-1] + math.dist(p, q))
    points, k = [], 0
    for i in range(LOWER):
        while arc[k] < arc[-1] * i / LOWER:
            k += 1
        points.append(below[k])
    for i in range(UPPER + 1):
        z = upper + (DECK - upper) * i / UPPER
        points.append((b * (1 - ((DECK - z) / height) ** n) ** (1 / n) if z < DECK else b, z))
    return points


def stations():
    """x from the transom forward: close where the shape changes."""
    corner = [AFT + CORNER * (1 - math.cos(math.pi / 2 * i / 8)) for i in range(8)]
    aft = corner + [AFT + CORNER + (RUN - CORNER) * i / 22 for i in range(22)]
    middle = [AFT + RUN + (LENGTH - RUN - ENTRANCE) * i / 18 for i in range(18)]
    fore = [FORE - ENTRANCE * math.cos(math.pi / 2 * i / 16) for i in range(17)]
    return aft + middle + fore[:-1] + [FORE]


def hull():
    """Vertices, and triangles as triples of their indices."""
    vertices, index = [], {}

    def vertex(x, y, z):
        key = (round(x, 3) + 0.0, round(y, 3) + 0.0, round(z, 3) + 0.0)
        if key not in index:
            index[key] = len(vertices)
            vertices.append(key)
        return index[key]

    triangles = []

    def triangle(*corners):
        if len(set(corners)) == 3:
            triangles.append(corners)

    rows = []
    for x in stations():
        half = section(x)
        rows.append(([vertex(x, y, z) for y, z in half], [vertex(x, -y, z) for y, z in half]))
    for i, ((port, starboard), (port2, starboard2)) in enumerate(zip(rows, rows[1:])):
        for j in range(len(port) - 1):
            # The diagonal changes side, so that the mesh favours neither; beside the keel it leaves the middle.
            if (i + j) % 2 and j > 0:
                triangle(port[j], port2[j + 1], port2[j])
                triangle(port[j], port[j + 1], port2[j + 1])
                triangle(starboard[j], starboard2[j], starboard2[j + 1])
                triangle(starboard[j], starboard2[j + 1], starboard[j + 1])
            else:
                triangle(port[j], port[j + 1], port2[j])
                triangle(port2[j], port[j + 1], port2[j + 1])
                triangle(starboard[j], starboard2[j], starboard[j + 1])
                triangle(starboard2[j], starboard2[j + 1], starboard[j + 1])
        triangle(port[-1], starboard2[-1], port2[-1])
        triangle(port[-1], starboard[-1], starboard2[-1])
    port, starboard = rows[0]
    middle = vertex(AFT, 0, 0)
    for j in range(len(port) - 1):
        triangle(middle, port[j + 1], port[j])
        triangle(middle, starboard[j], starboard[j + 1])
    triangle(middle, starboard[-1], port[-1])
    return vertices, triangles


def minus(a, b):
    return tuple(p - q for p, q in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def volume(vertices, triangles):
    """Enclosed volume by the divergence theorem, m³: positive when the triangles face outward."""
    return sum(dot(vertices[a], cross(vertices[b], vertices[c])) for a, b, c in triangles) / 6


def displaced(vertices, triangles):
    """Volume below z = 0, m³: of the prisms between the waterplane and what of each triangle lies below it."""
    total = 0.0
    for corners in triangles:
        polygon, points = [], [vertices[i] for i in corners]
        for p, q in zip(points, points[1:] + points[:1]):
            if p[2] <= 0:
                polygon.append(p)
            if (p[2] < 0) != (q[2] < 0) and p[2] != 0 and q[2] != 0:
                t = p[2] / (p[2] - q[2])
                polygon.append((p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), 0.0))
        for b, c in zip(polygon[1:], polygon[2:]):
            a = polygon[0]
            area = 0.5 * cross(minus(b, a), minus(c, a))[2]
            total += area * (a[2] + b[2] + c[2]) / 3
    return total


def faults(vertices, triangles):
    """Sentences on what keeps the triangles from being a closed, manifold, outward surface; empty when nothing does."""
    found = []
    edges = Counter()
    for t in triangles:
        normal = cross(minus(vertices[t[1]], vertices[t[0]]), minus(vertices[t[2]], vertices[t[0]]))
        if dot(normal, normal) == 0:
            found.append(f"degenerate triangle {t}")
        for i in range(3):
            edges[t[i], t[(i + 1) % 3]] += 1
    if any(count > 1 for count in edges.values()):
        found.append("directed edges used more than once: not manifold, or not of one orientation")
    if any((b, a) not in edges for a, b in edges):
        found.append("edges with one triangle only: not closed, or not of one orientation")
    used = {i for t in triangles for i in t}
    euler = len(used) - len(edges) // 2 + len(triangles)
    if euler != 2:
        found.append(f"Euler characteristic {euler}, not the 2 of a surface without handles")
    if len(used) != len(vertices):
        found.append("vertices that no triangle uses")
    if volume(vertices, triangles) <= 0:
        found.append("turned inside out")
    for axis, (low, high) in enumerate([(AFT, FORE), (-BEAM / 2, BEAM / 2), (KEEL, DECK)]):
        reach = [v[axis] for v in vertices]
        if abs(min(reach) - low) > 1e-3 or abs(max(reach) - high) > 1e-3:
            found.append(f"axis {axis}: from {min(reach)} to {max(reach)} m, not {low} to {high} m")
    return found


def active(vertices, triangle):
    corners = [vertices[i] for i in triangle]
    on_deck = all(c[2] > DECK - 1e-6 for c in corners)
    return not on_deck and all(c[2] > ACTIVE_BELOW and ACTIVE_FROM - 1e-6 <= c[0] <= ACTIVE_TO for c in corners)


def write_obj(path, vertices, triangles):
    parts = {"active": [], "rest": []}
    for t in triangles:
        parts["active" if active(vertices, t) else "rest"].append(t)
    with open(path, "w") as file:
        file.write("# VLCC of the offloading hose: metres, x forward, y to port, z up from the still water\n")
        for v in vertices:
            file.write("v " + " ".join(f"{c:.3f}".rstrip("0").rstrip(".") for c in v) + "\n")
        for name, part in parts.items():
            file.write(f"g {name}\n")
            for t in part:
                file.write("f " + " ".join(str(i + 1) for i in t) + "\n")
    return {name: len(part) for name, part in parts.items()}


def main():
    path = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent / "hull.obj"
    vertices, triangles = hull()
    found = faults(vertices, triangles)
    if found:
        sys.exit("make_hull: " + "; ".join(found))
    parts = write_obj(path, vertices, triangles)
    water = displaced(vertices, triangles)
    print(f"{path.name}: {len(triangles)} triangles ({parts['active']} active), closed; displaces {water:.0f} m³, "
          f"block coefficient {water / (LENGTH * BEAM * DRAUGHT):.3f}")


if __name__ == "__main__":
    main()
