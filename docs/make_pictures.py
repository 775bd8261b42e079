"""make_pictures.py FOLDER: draws the pictures of the handbook, each from plans that the program makes."""

import pathlib
import sys
import tempfile

import toolpace
from plot import picture

NC = pathlib.Path(__file__).parents[1] / "examples" / "nc"
LAWS = ["trapezoid", "five-phase-time", "five-phase-jerk", "seven-phase", "quintic"]


def program(folder, text):
    file = pathlib.Path(folder) / "program.ngc"
    file.write_text(f"G21 G90 G94\n{text}M2\n")
    return file


def laws(folder):
    line = program(folder, "G1 X12 F6000\n")
    plans = {law: toolpace.plan(line, law=law, am=2000, jm=8e4, tacc_ms=120, tdec_ms=120, period_ms=0.5) for law in LAWS}
    panels = []
    for column, title, scale in (("v_mm_s", "speed, mm/s", 1), ("a_mm_s2", "acceleration, mm/s²", 1), ("j_mm_s3", "jerk, 1000 mm/s³", 1e-3)):
        panels.append((title + " over time, ms", [(law, 1000 * o.column("t_s"), scale * o.column(column)) for law, o in plans.items()]))
    return picture(panels, [170, 170, 170])


def lookahead(_):
    first = toolpace.plan(NC / "blocks20.ngc", law="seven-phase", am=3000, jm=1e6)
    plans = {f"N = {n}": toolpace.replan(first, lookahead=n) for n in (1, 2, 4, "all")}
    return picture([("speed, mm/s over the path, mm", [(name, o.column("x_mm"), o.column("v_mm_s")) for name, o in plans.items()])], [300])


def corner(folder):
    bend = program(folder, "G1 X5 F3000\nG1 Y5\n")
    first = toolpace.plan(bend, law="seven-phase", ramps="span", am=3000, jm=1e5, tolerance_mm=0.05, period_ms=0.1)
    curves = []
    for rule in ("servo", "blend"):
        o = toolpace.replan(first, corner=rule)
        near = (o.column("x_mm") > 4.5) & (o.column("y_mm") < 0.5)
        curves.append((rule, o.column("x_mm")[near], o.column("y_mm")[near]))
    return picture([("y, mm over x, mm", curves)], [420], equal=True)


if __name__ == "__main__":
    out = pathlib.Path(sys.argv[1])
    out.mkdir(parents=True, exist_ok=True)
    for draw in (laws, lookahead, corner):
        with tempfile.TemporaryDirectory() as scratch:
            (out / f"{draw.__name__}.svg").write_text(draw(scratch))
