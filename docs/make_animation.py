"""make_animation.py FILE.svg: the README's moving picture. Two tools run along the butterfly under the same limits, as they are
planned: red passes corners as a servo wants them, blue rounds them by 5 µm. Below, their speeds."""

import pathlib
import sys

import numpy
import toolpace

NC = pathlib.Path(__file__).parents[1] / "examples" / "nc"
WIDTH, CONTOUR, CURVES, MARGIN = 640, 300, 110, 36
PLAYED = 2.0  # times as fast as it is
FRAMES_S = 12


def sampled(plan, duration):
    """Time since the contour began, x, y and speed at the frames; the tool waits where it ended."""
    t = numpy.linspace(0, duration, int(duration / PLAYED * FRAMES_S) + 1)
    since = plan.column("t_s") - plan.rapid_time_s
    return t, *(numpy.interp(t, since, plan.column(name)) for name in ("x_mm", "y_mm", "v_mm_s"))


def values(numbers):
    return ";".join(f"{number:.1f}".rstrip("0").rstrip(".") for number in numbers)


def animated(radius, colour, seconds, **tracks):
    shape = f'<circle r="{radius}" fill="{colour}" ' + " ".join(f'{name}="{track[0]:.1f}"' for name, track in tracks.items()) + ">"
    moves = "".join(f'<animate attributeName="{name}" values="{values(track)}" dur="{seconds:.2f}s" repeatCount="indefinite"/>'
                    for name, track in tracks.items())
    return f"{shape}{moves}</circle>"


def main(out):
    servo = toolpace.plan(NC / "butterfly.ngc", law="seven-phase", ramps="span", am=294.2, jm=3e4, vmax=50)
    blend = toolpace.replan(servo, corner="blend", tolerance_mm=0.005)
    duration = servo.feed_time_s
    seconds = duration / PLAYED
    rows = servo.column("t_s") > servo.rapid_time_s  # the contour, without the way to it
    x, y = servo.column("x_mm")[rows][::40], servo.column("y_mm")[rows][::40]
    scale = (CONTOUR - 30) / (y.max() - y.min())
    middle = WIDTH / 2 - scale * (x.max() + x.min()) / 2

    def place(px, py):
        return middle + scale * px, 15 + scale * (y.max() - py)

    points = " ".join("{:.1f},{:.1f}".format(*place(px, py)) for px, py in zip(x, y))
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {CONTOUR + CURVES + 40}" font-family="sans-serif" font-size="12">',
             f'<rect width="{WIDTH}" height="{CONTOUR + CURVES + 40}" fill="white"/>',
             f'<polyline points="{points}" fill="none" stroke="#bbb" stroke-width="1.5"/>']
    bottom, across = CONTOUR + CURVES + 10, (WIDTH - 2 * MARGIN) / duration
    for name, colour, plan in (("servo corners", "#cc3311", servo), ("rounded by 5 µm", "#0077bb", blend)):
        t, px, py, v = sampled(plan, duration)
        shown = slice(int(1000 * plan.rapid_time_s), None, 25)
        curve = zip(plan.column("t_s")[shown] - plan.rapid_time_s, plan.column("v_mm_s")[shown])
        speed = " ".join(f"{MARGIN + across * a:.1f},{bottom - CURVES * b / 50:.0f}" for a, b in curve)
        label = f"{name}: {plan.feed_time_s:.2f} s"
        parts.append(f'<polyline points="{speed}" fill="none" stroke="{colour}"/>')
        parts.append(f'<text x="{MARGIN if plan is blend else WIDTH - MARGIN}" y="{CONTOUR - 8}" fill="{colour}" '
                     f'text-anchor="{"start" if plan is blend else "end"}">{label}</text>')
        cx, cy = place(px, py)
        parts.append(animated(5, colour, seconds, cx=cx, cy=cy))
        parts.append(animated(3, colour, seconds, cx=MARGIN + across * t, cy=bottom - CURVES * v / 50))
    parts.append(f'<path d="M{MARGIN} {bottom}H{WIDTH - MARGIN}" stroke="#888"/>'
                 f'<text x="{MARGIN}" y="{bottom + 18}">speed over time; played {PLAYED:g} times as fast</text></svg>\n')
    pathlib.Path(out).write_text("\n".join(parts))


if __name__ == "__main__":
    main(*sys.argv[1:])
