"""Cycle time over acceleration and jerk, as a table and as a picture (sweep.svg, or the name that is given).

    sweep.py [OUT.svg]
"""

import pathlib
import sys

import toolpace

POCKET = pathlib.Path(__file__).parents[1] / "nc" / "pocket.ngc"
ACCELERATIONS = [500, 1000, 2000, 4000, 8000]  # mm/s²
JERKS = [1e4, 3e4, 1e5, 3e5, 1e6]              # mm/s³
COLOURS = ["#4477aa", "#66ccee", "#228833", "#ccbb44", "#ee6677"]


def svg(curves, width=640, height=400, margin=60):
    """Curves of (x, y) over a logarithmic x, without a library."""
    from math import log
    xs, ys = [x for _, c in curves for x, _ in c], [y for _, c in curves for _, y in c]
    def place(x, y):
        return (margin + (width - 2 * margin) * log(x / min(xs)) / log(max(xs) / min(xs)),
                height - margin - (height - 2 * margin) * y / max(ys))
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" font-family="sans-serif" font-size="12">',
             f'<rect width="{width}" height="{height}" fill="white"/>',
             f'<text x="{width / 2}" y="{height - 12}" text-anchor="middle">acceleration, mm/s²</text>',
             f'<text x="14" y="{margin - 24}">cycle time, s</text>']
    for x in sorted(set(xs)):
        parts.append(f'<text x="{place(x, 0)[0]:.1f}" y="{height - margin + 18}" text-anchor="middle">{x:g}</text>')
    for fraction in (0, 0.25, 0.5, 0.75, 1):
        y = fraction * max(ys)
        parts.append(f'<path d="M{margin} {place(min(xs), y)[1]:.1f}H{width - margin}" stroke="#ddd"/>'
                     f'<text x="{margin - 6}" y="{place(min(xs), y)[1] + 4:.1f}" text-anchor="end">{y:.1f}</text>')
    for k, (name, curve) in enumerate(curves):
        points = " ".join(f"{px:.1f},{py:.1f}" for px, py in (place(x, y) for x, y in curve))
        parts.append(f'<polyline points="{points}" fill="none" stroke="{COLOURS[k]}" stroke-width="2"/>'
                     f'<text x="{width - margin - 110}" y="{margin + 16 * k - 20}" fill="{COLOURS[k]}">jerk {name} mm/s³</text>')
    return "\n".join(parts + ["</svg>\n"])


first = toolpace.plan(POCKET, law="seven-phase")
print("am \\ jm " + " ".join(f"{j:>9g}" for j in JERKS))
times = {}
for a in ACCELERATIONS:
    for j in JERKS:
        times[a, j] = toolpace.replan(first, am=a, jm=j).cycle_time_s
    print(f"{a:>7} " + " ".join(f"{times[a, j]:7.3f} s" for j in JERKS))
out = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "sweep.svg")
out.write_text(svg([(f"{j:g}", [(a, times[a, j]) for a in ACCELERATIONS]) for j in JERKS]))
print(out)
