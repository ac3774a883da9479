#!/usr/bin/env python3
"""Writes guide.txt: where the spooling device stands across the drum at every time.

    python3 cases/spool/make_guide.py

It follows the drum's angle: 0.9 m a turn, a little more than the hose's diameter, from one flange to the other; there
it waits for 0.35 turns while the hose climbs onto the first layer, and comes back. Corners are rounded over 8 s.
"""
import math
from pathlib import Path

RATE, RAMP = 0.1, 10.0  # rad/s, s: of the drum, as in spool.yaml
START, END = -2.3, 2.3  # m: of the hose beside a flange
PITCH, REST, WAIT = 0.9, 0.25, 0.35  # m a turn; turns before it sets off; turns at the far flange
ROUNDED, EVERY, UNTIL = 8.0, 4.0, 660.0  # s


def place(turns):
    if turns < REST:
        return START
    turns -= REST
    there = (END - START) / PITCH
    if turns < there:
        return START + PITCH * turns
    if turns < there + WAIT:
        return END
    return max(END - PITCH * (turns - there - WAIT), START)


def mean(time, pieces=40):
    moments = [time + ROUNDED * (i / pieces - 0.5) for i in range(pieces + 1)]
    return sum(place(max(RATE * (t - RAMP / 2), 0) / (2 * math.pi)) for t in moments) / (pieces + 1)


lines = ["# t [s], x, y, z [m]: written by make_guide.py"]
time = 0.0
while time <= UNTIL:
    lines.append(f"{time:g} 0 {mean(time) - START:.6f} 0")
    time += EVERY
Path(__file__).with_name("guide.txt").write_text("\n".join(lines) + "\n")
