"""Curves as SVG, without a library."""

import math

COLOURS = ["#4477aa", "#ee6677", "#228833", "#ccbb44", "#66ccee", "#aa3377"]
WIDTH, MARGIN = 760, 64


def nice_ticks(low, high, count=5):
    """Multiples of 1, 2 or 5 times a power of ten, about `count` of them."""
    rough = (high - low) / count
    power = 10.0 ** math.floor(math.log10(rough))
    step = next(power * m for m in (1, 2, 5, 10) if power * m >= rough)
    return [round(k * step, 12) for k in range(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1)]


def panel(title, curves, top, height, equal=False):
    """One diagram of [(name, xs, ys)], `top` pixels down. equal: the same scale in x and y."""
    xs, ys = [x for _, c, _ in curves for x in c], [y for _, _, c in curves for y in c]
    left, right, low, high = min(xs), max(xs), min(ys), max(ys)
    if high == low:
        high = low + 1
    x_scale, y_scale = (WIDTH - 2 * MARGIN) / (right - left), (height - 60) / (high - low)
    if equal:
        x_scale = y_scale = min(x_scale, y_scale)

    def place(x, y):
        return MARGIN + (x - left) * x_scale, top + height - 30 - (y - low) * y_scale

    parts = [f'<text x="{MARGIN}" y="{top + 16}">{title}</text>']
    for y in nice_ticks(low, high):
        at = place(left, y)[1]
        parts.append(f'<path d="M{MARGIN} {at:.1f}H{WIDTH - MARGIN}" stroke="#ddd"/>'
                     f'<text x="{MARGIN - 6}" y="{at + 4:.1f}" text-anchor="end">{y:g}</text>')
    for x in nice_ticks(left, right, 6):
        at = place(x, low)[0]
        if at <= WIDTH - MARGIN + 1:
            parts.append(f'<text x="{at:.1f}" y="{top + height - 12}" text-anchor="middle">{x:g}</text>')
    for k, (_, xs, ys) in enumerate(curves):
        points = " ".join("{:.1f},{:.1f}".format(*place(x, y)) for x, y in zip(xs, ys))
        parts.append(f'<polyline points="{points}" fill="none" stroke="{COLOURS[k % len(COLOURS)]}" stroke-width="1.6"/>')
    return parts


def legend(names, top):
    parts, x = [], MARGIN
    for k, name in enumerate(names):
        parts.append(f'<path d="M{x} {top}h18" stroke="{COLOURS[k % len(COLOURS)]}" stroke-width="3"/><text x="{x + 23}" y="{top + 4}">{name}</text>')
        x += 36 + 7 * len(name)
    return parts


def picture(panels, heights, equal=False):
    """SVG of [(title, [(name, xs, ys)])], one below the other, with one legend."""
    height = sum(heights) + 34
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" font-family="sans-serif" font-size="12">',
             f'<rect width="{WIDTH}" height="{height}" fill="white"/>', *legend([name for name, _, _ in panels[0][1]], 16)]
    top = 30
    for (title, curves), tall in zip(panels, heights):
        parts += panel(title, curves, top, tall, equal)
        top += tall
    return "\n".join([*parts, "</svg>\n"])
