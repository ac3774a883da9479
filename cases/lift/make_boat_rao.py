#!/usr/bin/env python3
"""Writes boat.rao: a box of 14 m breadth and 4 m draught in beam seas, by the pressure of the undisturbed wave.

    python3 cases/lift/make_boat_rao.py

Heave exp(-k T) sin(k B/2)/(k B/2), roll with 0.6 of the slope of the wave, times the same; no resonance, no sway.
"""
import math
from pathlib import Path

B, T, G, SHARE = 14.0, 4.0, 9.80665, 0.6


def main():
    rows = ["# A supply boat in beam seas, estimated by make_boat_rao.py; phases are lags behind the crest",
            "# period s, direction deg; surge, sway, heave m/m, roll, pitch, yaw deg/m, each with its lag in deg"]
    for period in range(3, 19):
        k = (2 * math.pi / period) ** 2 / G
        mean = math.exp(-k * T) * math.sin(k * B / 2) / (k * B / 2)
        rows.append(f"{period} 90 0 0 0 0 {mean:.5g} 0 {math.degrees(SHARE * k) * mean:.5g} 90 0 0 0 0")
    Path(__file__).with_name("boat.rao").write_text("\n".join(rows) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
