"""The butterfly under each corner rule: what a corner costs, and what the jerk along the path comes to.

stop halts at every node; servo and junction pass with a step of the velocity; blend and smooth leave the path within 5 µm.
"""

import pathlib

import numpy
import toolpace

BUTTERFLY = pathlib.Path(__file__).parents[1] / "nc" / "butterfly.ngc"

first = toolpace.plan(BUTTERFLY, law="seven-phase", ramps="span", am=294.2, jm=3e4, vmax=50, tolerance_mm=0.005)
print(f"{'corner':>9} {'feed':>9} {'mean speed':>12} {'largest step':>13} {'off the path':>13}")
for rule in ("stop", "servo", "junction", "blend"):
    plan = toolpace.replan(first, corner=rule)
    t, x, y = (plan.column(name) for name in ("t_s", "x_mm", "y_mm"))
    velocity = numpy.column_stack([numpy.diff(x), numpy.diff(y)]) / numpy.diff(t)[:, None]
    step = numpy.linalg.norm(numpy.diff(velocity, axis=0), axis=1).max()
    print(f"{rule:>9} {plan.feed_time_s:7.3f} s {plan.path_length_mm / plan.cycle_time_s:7.2f} mm/s {step:8.3f} mm/s "
          f"{1000 * plan.corners['max_deviation_mm']:10.2f} µm")
