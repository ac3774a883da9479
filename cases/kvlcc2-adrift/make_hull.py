#!/usr/bin/env python3
"""Writes hull.obj, a tanker of the main dimensions of the KVLCC2 with parabolic waterlines: 320 m between perpendiculars, 58 m
beam, 20.8 m draught, 30 m depth; z = 0 is the waterline.

The half breadth at x from midships and z is y = b (1 - s²), s the share of the way from the end of the parallel middle body to
the stem (to the transom astern), b half of the beam and at the bilge less: b = B/2 - r + sqrt(r² - (r - h)²) at a height h < r
above the keel. The ends of the waterlines draw in towards the keel astern as the hull rises there."""
import math
from pathlib import Path

LENGTH, BEAM, DRAUGHT, DEPTH, BILGE = 320.0, 58.0, 20.8, 30.0, 5.0
FORE, AFT = 100.0, 90.0  # m from midships, where the parallel middle body ends
HEIGHTS = [0.0, 0.4, 1.5, 3.0, 5.0, 9.0, 14.0, 18.0, 20.8, 24.0, 27.0, 30.0]  # m above the keel
STATIONS = 14  # in each end, denser where the waterline turns


def stem(height):
    return LENGTH / 2 - 4 + 4 * min(1, height / DRAUGHT)


def transom(height):
    """Where the hull ends astern: it rises from the keel 60 m ahead of the transom."""
    return -LENGTH / 2 + 60 * max(0.0, 1 - height / 12.0) ** 1.5


def half_breadth(x, height):
    b = BEAM / 2 if height >= BILGE else BEAM / 2 - BILGE + math.sqrt(BILGE**2 - (BILGE - height) ** 2)
    if x > FORE:
        return b * (1 - ((x - FORE) / (stem(height) - FORE)) ** 2)
    aft = min(AFT, -transom(height) - 1)
    if x < -aft:
        return b * (1 - 0.55 * ((-aft - x) / (-aft - transom(height))) ** 2)
    return b


def waterline(height):
    """Points along the port side, from the transom to the stem, the same number at each height."""
    low, high, aft = transom(height), stem(height), min(AFT, -transom(height) - 1)
    bow = [FORE + (high - FORE) * math.sin(math.pi / 2 * i / STATIONS) for i in range(1, STATIONS + 1)]
    stern = [-aft - (-aft - low) * math.sin(math.pi / 2 * i / STATIONS) for i in range(STATIONS, 0, -1)]
    middle = [-aft + (FORE + aft) * i / 8 for i in range(9)]
    return [(x, half_breadth(x, height)) for x in stern + middle + bow]


def main():
    points, faces, rings = [], [], []
    for height in HEIGHTS:
        port = waterline(height)
        ring = port + [(x, -y) for x, y in reversed(port[:-1])]  # the stem is one point of both sides
        rings.append([len(points) + i for i in range(len(ring))])
        points += [(x, y, height - DRAUGHT) for x, y in ring]
    n = len(rings[0])
    for low, high in zip(rings, rings[1:]):
        for i in range(n):
            a, b = i, (i + 1) % n
            faces += [(low[b], low[a], high[a]), (low[b], high[a], high[b])]
    half = n // 2  # number of the stem in its ring
    for ring, up in ((rings[0], False), (rings[-1], True)):  # keel and deck: strips from side to side
        for i in range(half):
            p, q, r, s = ring[i], ring[i + 1], ring[n - 1 - i], ring[(n - 2 - i) % n]
            strip = [(p, r, s), (p, s, q)] if i < half - 1 else [(p, r, q)]
            faces += strip if up else [tuple(reversed(f)) for f in strip]
    text = ["# tanker of the main dimensions of the KVLCC2, parabolic waterlines"]
    text += [f"v {x:.4f} {y:.4f} {z:.4f}" for x, y, z in points]
    text += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in faces]
    Path(__file__).with_name("hull.obj").write_text("\n".join(text) + "\n")


if __name__ == "__main__":
    main()
