"""Meshes of random scenes: (vertices, facets from 0, outward) of typical bodies, and their OBJ text."""
import math


def obj(mesh):
    vertices, facets = mesh
    return ("".join(f"v {x:.9g} {y:.9g} {z:.9g}\n" for x, y, z in vertices) +
            "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in facets))


def joined(*meshes):
    vertices, facets = [], []
    for v, f in meshes:
        facets += [tuple(i + len(vertices) for i in facet) for facet in f]
        vertices += v
    return vertices, facets


def moved(mesh, by):
    vertices, facets = mesh
    return [tuple(x + d for x, d in zip(v, by)) for v in vertices], facets


def box(size, divisions=(1, 1, 1)):
    """A box about the origin with divided edges, so that vertices lie on its edges."""
    vertices, index, facets = [], {}, []

    def corner(i):
        if i not in index:
            index[i] = len(vertices)
            vertices.append(tuple(s * (k / n - 0.5) for s, k, n in zip(size, i, divisions)))
        return index[i]

    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for side in (0, divisions[axis]):
            for i in range(divisions[u]):
                for j in range(divisions[v]):
                    quad = []
                    for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        at = [0, 0, 0]
                        at[axis], at[u], at[v] = side, i + di, j + dj
                        quad.append(corner(tuple(at)))
                    if side == 0:
                        quad.reverse()
                    facets += [(quad[0], quad[1], quad[2]), (quad[0], quad[2], quad[3])]
    return vertices, facets


def frames(path):
    """Two axes across each point of a path in the plane y = 0, and at its ends."""
    out = []
    for i in range(len(path)):
        a, b = path[max(i - 1, 0)], path[min(i + 1, len(path) - 1)]
        t = [q - p for p, q in zip(a, b)]
        size = math.hypot(*t)
        t = [c / size for c in t]
        out.append(((0.0, 1.0, 0.0), (-t[2], 0.0, t[0])))  # y, and t x y... across the plane and in it
    return out


def ring(centre, axes, radius, sides, turn=0.0):
    (u, v), points = axes, []
    for k in range(sides):
        a = 2 * math.pi * (k + turn) / sides
        points.append(tuple(c + radius * (math.cos(a) * p + math.sin(a) * q) for c, p, q in zip(centre, u, v)))
    return points


def bands(rows, sides, closed):
    """Facets between rings of `sides` vertices, outward if the rings are anticlockwise about the direction of the
    rows."""
    facets = []
    for i in range(rows if closed else rows - 1):
        j = (i + 1) % rows
        for k in range(sides):
            m = (k + 1) % sides
            a, b, c, d = i * sides + k, i * sides + m, j * sides + m, j * sides + k
            facets += [(a, b, c), (a, c, d)]
    return facets


def outward(mesh):
    """The mesh with the orientation that encloses a positive volume."""
    vertices, facets = mesh
    volume = 0.0
    for a, b, c in facets:
        p, q, r = vertices[a], vertices[b], vertices[c]
        volume += (p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
                   p[2] * (q[0] * r[1] - q[1] * r[0]))
    return (vertices, facets) if volume > 0 else (vertices, [(a, c, b) for a, b, c in facets])


def drum(radius, half, sides):
    """A drum about y with flat ends."""
    rows = [(0.0, y, 0.0) for y in (-half, half)]
    axes = ((0.0, 0.0, 1.0), (1.0, 0.0, 0.0))
    vertices = [p for c in rows for p in ring(c, axes, radius, sides)] + rows
    facets = bands(2, sides, False)
    for k in range(sides):
        m = (k + 1) % sides
        facets += [(2 * sides, m, k), (2 * sides + 1, sides + k, sides + m)]
    return outward((vertices, facets))


def tube(path, inner, outer, sides):
    """A tube with a bore along a path in the plane y = 0."""
    vertices, n = [], len(path)
    for radius in (outer, inner):
        for c, axes in zip(path, frames(path)):
            vertices += ring(c, axes, radius, sides)
    facets = bands(n, sides, False)
    facets += [(n * sides + a, n * sides + c, n * sides + b) for a, b, c in bands(n, sides, False)]
    for k in range(sides):
        m = (k + 1) % sides
        for row, turn in ((0, True), (n - 1, False)):
            a, b = row * sides + k, row * sides + m
            c, d = n * sides + b, n * sides + a
            facets += [(a, c, b), (a, d, c)] if turn else [(a, b, c), (a, c, d)]
    return outward((vertices, facets))


def torus(radius, tube_radius, around, sides):
    """A ring about x of circular section."""
    vertices = []
    for i in range(around):
        a = 2 * math.pi * i / around
        d = (0.0, math.cos(a), math.sin(a))
        vertices += ring(tuple(radius * c for c in d), (d, (1.0, 0.0, 0.0)), tube_radius, sides)
    return outward((vertices, bands(around, sides, True)))


def sheave(radius, groove, half, sides):
    """A sheave about y whose rim is `groove` higher at both sides than in the middle."""
    rows = [(-half, radius + groove), (-0.4 * half, radius), (0.4 * half, radius), (half, radius + groove)]
    axes = ((0.0, 0.0, 1.0), (1.0, 0.0, 0.0))
    vertices = [p for y, rad in rows for p in ring((0.0, y, 0.0), axes, rad, sides)]
    vertices += [(0.0, -half, 0.0), (0.0, half, 0.0)]
    facets, n = bands(4, sides, False), 4 * sides
    for k in range(sides):
        m = (k + 1) % sides
        facets += [(n, m, k), (n + 1, 3 * sides + k, 3 * sides + m)]
    return outward((vertices, facets))


def rock(r, size):
    """A boulder: an ellipsoid with waves on it."""
    rows, sides = 7, 12
    waves = [(r.uniform(0.02, 0.08), r.randint(1, 3), r.randint(1, 3), r.uniform(0, 6.3)) for _ in range(4)]

    def point(theta, phi):
        f = 1 + sum(a * math.sin(m * theta + n * phi + c) for a, m, n, c in waves)
        return tuple(0.5 * s * f * c for s, c in zip(size, (math.sin(theta) * math.cos(phi),
                                                              math.sin(theta) * math.sin(phi), math.cos(theta))))

    vertices = [point(math.pi * (i + 1) / (rows + 1), 2 * math.pi * k / sides) for i in range(rows) for k in range(sides)]
    vertices += [point(0, 0), point(math.pi, 0)]
    facets, n = bands(rows, sides, False), rows * sides
    for k in range(sides):
        m = (k + 1) % sides
        facets += [(n, m, k), (n + 1, (rows - 1) * sides + k, (rows - 1) * sides + m)]
    return outward((vertices, facets))


def hull_width(length, x):
    """Width of the ship of hull() at x, as a fraction of its beam."""
    s = x / length + 0.5
    return 1.0 if s < 0.7 else max(0.03, max(0.0, math.cos(0.5 * math.pi * (s - 0.7) / 0.3)) ** 0.7)


def hull(length, beam, depth, bilge, stations=24):
    """A ship about the origin, its deck at z = 0: full amidships, pointed at the bow (+x), with round bilges."""
    half = []
    for k in range(5):
        a = 0.5 * math.pi * k / 4
        half.append((0.5 * beam - bilge + bilge * math.cos(a), -depth + bilge - bilge * math.sin(a)))
    section = [(0.5 * beam, 0.0)] + half
    section += [(-y, z) for y, z in reversed(section)]
    sides, vertices = len(section), []
    for i in range(stations + 1):
        x = length * (i / stations - 0.5)
        full = hull_width(length, x)
        vertices += [(x, y * full, z) for y, z in section]
    facets = bands(stations + 1, sides, False)
    for row in (0, stations):
        first = row * sides
        for k in range(1, sides - 1):
            facet = (first, first + k, first + k + 1)
            facets.append(facet if row else facet[::-1])
    return outward((vertices, facets))


def deck(length, width, bulwark, thick):
    """A deck with its top at z = 0 between two bulwarks along x, of constant section."""
    w, b = 0.5 * width, 0.15
    section = [(-w - b, -thick), (w + b, -thick), (w + b, bulwark), (w, bulwark), (w, 0), (-w, 0), (-w, bulwark), (-w - b, bulwark)]
    n = len(section)
    vertices = [(x, y, z) for x in (-0.5 * length, 0.5 * length) for y, z in section]
    facets = bands(2, n, False)
    for a, c, d in ((0, 4, 5), (0, 1, 4), (1, 2, 3), (1, 3, 4), (0, 5, 6), (0, 6, 7)):  # triangles of the section
        facets += [(a, d, c), (n + a, n + c, n + d)]
    return outward((vertices, facets))


def bowl(radius, depth, rim, sides=32, rows=8):
    """A round bowl with its bottom at z = 0, in a block with its top at z = depth."""
    vertices = [(0.0, 0.0, 0.0)]
    for i in range(1, rows + 1):
        s = i / rows
        vertices += [(radius * s * math.cos(2 * math.pi * k / sides), radius * s * math.sin(2 * math.pi * k / sides),
                      depth * s * s) for k in range(sides)]
    for rad, z in ((radius + rim, depth), (radius + rim, -rim)):
        vertices += [(rad * math.cos(2 * math.pi * k / sides), rad * math.sin(2 * math.pi * k / sides), z) for k in range(sides)]
    vertices.append((0.0, 0.0, -rim))
    facets = [(0, 1 + k, 1 + (k + 1) % sides) for k in range(sides)]
    facets += [tuple(1 + i for i in f) for f in [(a, c, b) for a, b, c in bands(rows + 2, sides, False)]]
    last, base = len(vertices) - 1, 1 + (rows + 1) * sides
    facets += [(last, base + (k + 1) % sides, base + k) for k in range(sides)]
    return outward((vertices, facets))
