"""Peak reaction of the falling pipe against the step, on supports of three stiffnesses: a table, and a figure as SVG.

    python3 cases/impact/figures.py build/hawser [cases/impact/impact.svg]

Runs cases/impact/impact.yaml with other steps and stiffnesses in a scratch folder; reads the results with h5dump.
"""
import math
import os
import re
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
STEPS = [8e-3, 4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4, 1.25e-4, 6.25e-5]
STIFFNESSES = [(1e6, "#2e8b57"), (1e7, "#0b6e99"), (1e8, "#c0392b")]  # N/m, colour


def dump(*arguments):
    return subprocess.run(["h5dump", *arguments], check=True, capture_output=True, text=True).stdout


def column(file, dataset, name):
    head = dump("-A", "-d", dataset, file).replace("\\000", "")
    names = re.findall(r'"([^"]*)"', head[head.index('ATTRIBUTE "columns"') + len('ATTRIBUTE "columns"'):])
    text = dump("-y", "-w", "1", "-m", "%.12g", "-d", dataset, file)
    end = text.index("ATTRIBUTE") if "ATTRIBUTE" in text else None
    values = [float(w) for w in re.findall(r"^\s*([-+0-9.e]+|nan|inf),?$", text[text.index("DATA {"):end], re.M)]
    return values[names.index(name)::int(re.search(r"SIMPLE { \( \d+, (\d+) \)", head).group(1))]


def peak(program, folder, stiffness, step):
    with open(os.path.join(HERE, "impact.yaml")) as f:
        case = f.read()
    case = case.replace("per_point: 1.0e7", f"per_point: {stiffness:.1e}").replace("step: 0.0005", f"step: {step:g}")
    path = os.path.join(folder, "impact.yaml")
    with open(path, "w") as f:
        f.write(case)
    subprocess.run([program, "run", path], check=True, capture_output=True)
    return max(column(os.path.join(folder, "impact.h5"), "/series/middle", "contact_normal_force"))


def svg(rows):
    left, bottom, width, height = 70, 330, 470, 290
    x0, x1, y0, y1 = math.log10(5e-5), math.log10(1e-2), 1.6, 2.7  # s; kN

    def x(step):
        return left + width * (math.log10(step) - x0) / (x1 - x0)

    def y(force):
        return bottom - height * (math.log10(force / 1e3) - y0) / (y1 - y0)

    out = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 600 400" font-family="sans-serif" font-size="13">',
           '<rect width="600" height="400" fill="white"/>']
    for ms in (0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10):
        out.append(f'<path d="M{x(ms / 1e3):.1f} {bottom}v-{height}" stroke="#ddd"/>'
                   f'<text x="{x(ms / 1e3):.1f}" y="{bottom + 18}" text-anchor="middle">{ms:g}</text>')
    for kn in (50, 100, 200, 300, 400):
        out.append(f'<path d="M{left} {y(1e3 * kn):.1f}h{width}" stroke="#ddd"/>'
                   f'<text x="{left - 8}" y="{y(1e3 * kn) + 4:.1f}" text-anchor="end">{kn}</text>')
    for stiffness, colour in STIFFNESSES:
        points = [(x(s), y(p)) for k, s, p in rows if k == stiffness]
        line = " ".join(f"{a:.1f},{b:.1f}" for a, b in points)
        out.append(f'<polyline points="{line}" fill="none" stroke="{colour}" stroke-width="2"/>')
        out += [f'<circle cx="{a:.1f}" cy="{b:.1f}" r="3.5" fill="{colour}"/>' for a, b in points]
        a, b = points[len(points) // 2]
        out.append(f'<text x="{a + 8:.1f}" y="{b - 10:.1f}" fill="{colour}">{stiffness:.0e} N/m</text>')
    out.append(f'<text x="{left + width / 2}" y="{bottom + 44}" text-anchor="middle">time step [ms]</text>'
               f'<text x="18" y="{bottom - height / 2}" text-anchor="middle" '
               f'transform="rotate(-90 18 {bottom - height / 2})">peak reaction [kN]</text></svg>')
    return "\n".join(out) + "\n"


def main(program, figure=None):
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for stiffness, _ in STIFFNESSES:
            for step in STEPS:
                rows.append((stiffness, step, peak(os.path.abspath(program), folder, stiffness, step)))
                print(f"{stiffness:.0e} N/m {1e3 * step:6.2f} ms  {rows[-1][2] / 1e3:9.2f} kN", flush=True)
    if figure:
        os.makedirs(os.path.dirname(os.path.abspath(figure)), exist_ok=True)
        with open(figure, "w") as f:
            f.write(svg(rows))


if __name__ == "__main__":
    main(*sys.argv[1:])
