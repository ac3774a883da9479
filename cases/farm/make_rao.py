#!/usr/bin/env python3
"""Writes float.rao, how the float of a 15 MW wind turbine moves in waves: an estimate by Morison's equation.

    cases/farm/make_rao.py [OUTPUT.rao]

The hull is that of VolturnUS-S: a column of 10 m in the middle, three of 12.5 m at 51.75 m from it, all with a draught of
20 m, and three pontoons, 12.5 m wide and 7 m high, from the middle column to the others along the keel. Mass, inertia and
hydrostatic stiffness are those of the WAMIT input and output that its authors and NREL publish with it.

Of every metre of a member the wave's acceleration, that of the undisturbed wave at its axis, makes the force

    rho (A + added) a,

with the added mass across a column that of a circle (Ca = 1) and of a pontoon that of a rectangle (DNV-RP-C205, table D-1);
where the waterplane is cut out, rho g times the elevation acts upwards besides. The mass, what the members carry along, the
hydrostatic stiffness and the damping of heave, roll and pitch (chosen) make the motion. The moorings do not matter at the
periods of waves. Water depth 120 m, linear waves.

Body axes: x leeward, y to port, z up from the still water; the columns stand at 180, 60 and -60 deg from x.
"""
import cmath
import math
import sys
from pathlib import Path

GRAVITY, DENSITY, DEPTH = 9.80665, 1025.0, 120.0
COLUMNS = [180.0, 60.0, -60.0]  # deg, where the outer columns stand
RADIUS, OUTER, INNER, DRAUGHT = 51.75, 12.5, 10.0, 20.0  # m, of the circle they stand on; their diameters
WIDTH, HEIGHT = 12.5, 7.0  # m, of the pontoons
ADDED_UP = 1.38 * math.pi / 4 * WIDTH**2  # m², of a rectangle of 12.5 x 7 m, upwards
ADDED_ACROSS = 1.66 * math.pi / 4 * HEIGHT**2  # m², the same, sideways
MASS, CENTRE, PITCH_INERTIA, YAW_INERTIA = 2.01e7, -2.32, 4.26e10, 2.37e10  # kg, m (z), kg m² about the origin
HEAVE_STIFFNESS = 443.05 * DENSITY * GRAVITY  # N/m
PITCH_STIFFNESS = 263.7e3 * DENSITY * GRAVITY  # N m/rad, with the weight's part
DAMPING = 0.08  # of critical, in heave, roll and pitch; chosen
PERIODS = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 22, 25, 28, 32, 40]  # s
DIRECTIONS = range(0, 181, 15)  # deg, where the wave goes to; the other side is its mirror


def members():
    """(place, volume, added volume along x, y, z as a 3x3 matrix) of every piece of the hull."""
    pieces = []
    spots = [(0.0, 0.0, INNER)] + [
        (RADIUS * math.cos(math.radians(a)), RADIUS * math.sin(math.radians(a)), OUTER) for a in COLUMNS]
    for x, y, diameter in spots:
        volume = math.pi / 4 * diameter**2 * DRAUGHT / 20
        for k in range(20):
            pieces.append(((x, y, -DRAUGHT * (k + 0.5) / 20), volume, [[volume, 0, 0], [0, volume, 0], [0, 0, 0]]))
    step = RADIUS / 50
    for angle in COLUMNS:
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        for k in range(50):
            r = step * (k + 0.5)
            inside = r < INNER / 2 or r > RADIUS - OUTER / 2  # in a column, which has this volume; the water under it counts
            side = 0 if inside else ADDED_ACROSS * step
            added = [[side * s * s, -side * s * c, 0], [-side * s * c, side * c * c, 0], [0, 0, ADDED_UP * step]]
            pieces.append(((r * c, r * s, -DRAUGHT + HEIGHT / 2), 0 if inside else WIDTH * HEIGHT * step, added))
    return pieces, spots


def cross_rows(place, force):
    """Force and moment about the origin."""
    x, y, z = place
    a, b, c = force
    return [a, b, c, y * c - z * b, z * a - x * c, x * b - y * a]


def motion_of(place, k):
    """What a unit of the motion k (surge to yaw) moves a point by."""
    unit = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    if k < 3:
        return unit[k]
    x, y, z = place
    return [[0, -z, y], [z, 0, -x], [-y, x, 0]][k - 3]


def times(matrix, vector):
    return [sum(a * b for a, b in zip(row, vector)) for row in matrix]


def solve(matrix, right):
    """Gauss' elimination with pivots."""
    rows = [list(row) + [r] for row, r in zip(matrix, right)]
    for i in range(len(rows)):
        best = max(range(i, len(rows)), key=lambda r: abs(rows[r][i]))
        rows[i], rows[best] = rows[best], rows[i]
        for r in range(len(rows)):
            if r != i:
                factor = rows[r][i] / rows[i][i]
                rows[r] = [a - factor * b for a, b in zip(rows[r], rows[i])]
    return [row[-1] / row[i] for i, row in enumerate(rows)]


def total_mass(pieces):
    mass = [[0.0] * 6 for _ in range(6)]
    for i in range(3):
        mass[i][i] = MASS
    mass[3][3] = mass[4][4] = PITCH_INERTIA
    mass[5][5] = YAW_INERTIA
    mass[0][4] = mass[4][0] = MASS * CENTRE
    mass[1][3] = mass[3][1] = -MASS * CENTRE
    for place, _, added in pieces:
        for k in range(6):
            column = cross_rows(place, [DENSITY * a for a in times(added, motion_of(place, k))])
            for i in range(6):
                mass[i][k] += column[i]
    return mass


def wave_number(omega):
    k = omega**2 / GRAVITY
    for _ in range(100):
        k -= (GRAVITY * k * math.tanh(k * DEPTH) - omega**2) / (
            GRAVITY * (math.tanh(k * DEPTH) + k * DEPTH / math.cosh(min(k * DEPTH, 300)) ** 2))
    return k


def excitation(pieces, spots, omega, direction):
    """Forces and moments of a wave of 1 m whose crest is at the origin at t = 0, as complex numbers of exp(i omega t)."""
    k = wave_number(omega)
    c, s = math.cos(math.radians(direction)), math.sin(math.radians(direction))
    total = [0j] * 6
    for place, volume, added in pieces:
        x, y, z = place
        late = cmath.exp(-1j * k * (c * x + s * y))
        # cosh and sinh of k (z + depth) over sinh of k depth, without overflow.
        down, up = math.exp(k * z), math.exp(-k * (z + 2 * DEPTH))
        bottom = 1 - math.exp(-2 * k * DEPTH)
        along = 1j * omega**2 * (down + up) / bottom * late
        water = [along * c, along * s, -(omega**2) * (down - up) / bottom * late]
        force = [DENSITY * (volume * w + a) for w, a in zip(water, times(added, water))]
        total = [t + f for t, f in zip(total, cross_rows(place, force))]
    for x, y, diameter in spots:
        lift = DENSITY * GRAVITY * math.pi / 4 * diameter**2 * cmath.exp(-1j * k * (c * x + s * y))
        total = [t + f for t, f in zip(total, cross_rows((x, y, 0), [0, 0, lift]))]
    return total


def responses(hull, mass, period, direction):
    """Surge, sway, heave [m/m], roll, pitch, yaw [deg/m] as complex numbers R: motion = Re(R exp(i omega t))."""
    omega = 2 * math.pi / period
    left = [[-(omega**2) * m for m in row] for row in mass]
    for i, stiffness in [(2, HEAVE_STIFFNESS), (3, PITCH_STIFFNESS), (4, PITCH_STIFFNESS)]:
        left[i][i] += stiffness + 1j * omega * 2 * DAMPING * math.sqrt(stiffness * mass[i][i])
    motion = solve(left, excitation(*hull, omega, direction))
    return motion[:3] + [math.degrees(1) * m for m in motion[3:]]


def main():
    path = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent / "float.rao"
    hull = members()
    mass = total_mass(hull[0])
    with open(path, "w") as file:
        file.write("# VolturnUS-S with the IEA 15 MW turbine, estimated by make_rao.py; phases are lags behind the crest\n")
        file.write("# period s, direction deg; surge, sway, heave m/m, roll, pitch, yaw deg/m, each with its lag in deg\n")
        for direction in DIRECTIONS:
            for period in PERIODS:
                row = []
                for r in responses(hull, mass, period, direction):
                    small = abs(r) < 5e-6
                    row += [0 if small else abs(r), 0 if small else -math.degrees(cmath.phase(r)) % 360]
                file.write(f"{period:g} {direction} " +
                           " ".join(f"{x:.5g}" if i % 2 == 0 else f"{x:.1f}" for i, x in enumerate(row)) + "\n")
    heave = 2 * math.pi * math.sqrt(mass[2][2] / HEAVE_STIFFNESS)
    pitch = 2 * math.pi * math.sqrt(mass[4][4] / PITCH_STIFFNESS)
    print(f"{path.name}: {len(PERIODS)} periods, {len(DIRECTIONS)} directions; displaces "
          f"{sum(p[1] for p in hull[0]):.0f} m³, natural periods {heave:.1f} s of heave and {pitch:.1f} s of pitch")


if __name__ == "__main__":
    main()
