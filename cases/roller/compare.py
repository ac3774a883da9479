"""The pull of the tug with contact along the line and at the nodes, drawn as an SVG.

    sed 's/method: line/method: nodes/' cases/roller/roller.yaml > cases/roller/nodes.yaml
    scripts/run cases/roller/roller.yaml && scripts/run cases/roller/nodes.yaml
    python3 cases/roller/compare.py cases/roller/roller.h5 cases/roller/nodes.h5 methods.svg
"""
import sys

from figures import column, expected, numbers

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 900, 380, 62, 16, 34, 44
FROM, TO, MOST = 30.0, 60.0, 50.0  # s, s, kN


def place(t, kn):
    return (LEFT + (t - FROM) / (TO - FROM) * (WIDTH - LEFT - RIGHT),
            HEIGHT - BOTTOM - kn / MOST * (HEIGHT - TOP - BOTTOM))


def curve(file, colour):
    times, pull = numbers(file, "/series/time"), column(file, "/series/tug", "effective_tension")
    points = " ".join("%.1f,%.1f" % place(t, min(max(v / 1e3, 0.0), MOST)) for t, v in zip(times, pull)
                      if FROM <= t <= TO)
    return f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="1.6"/>'


def text(x, y, words, colour="#333", anchor="middle"):
    return f'<text x="{x:.0f}" y="{y:.0f}" fill="{colour}" text-anchor="{anchor}">{words}</text>'


def main(line, nodes, out):
    exact = expected()[0] / 1e3
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" '
             f'viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="14">',
             f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>']
    for kn in range(0, int(MOST) + 1, 10):
        (x0, y), (x1, _) = place(FROM, kn), place(TO, kn)
        parts.append(f'<line x1="{x0}" y1="{y:.1f}" x2="{x1}" y2="{y:.1f}" stroke="#ddd"/>')
        parts.append(text(x0 - 8, y + 5, kn, anchor="end"))
    for t in range(int(FROM), int(TO) + 1, 5):
        x, y = place(t, 0)
        parts.append(text(x, y + 18, t))
    parts.append(text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 8, "time, s"))
    parts.append(text(LEFT, 20, "pull of the tug, kN", anchor="start"))
    parts.append(text(WIDTH - 330, 20, "at the nodes", "#c0392b"))
    parts.append(text(WIDTH - 215, 20, "along the line", "#1f5fa8"))
    parts.append(text(WIDTH - 85, 20, f"exact: {exact:.1f} kN"))
    parts += [curve(nodes, "#c0392b"), curve(line, "#1f5fa8"), "</svg>"]
    with open(out, "w", encoding="utf-8") as f:
        f.write("\n".join(parts) + "\n")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
