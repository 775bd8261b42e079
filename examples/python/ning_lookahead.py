"""How far must a controller look ahead? The 20 blocks of Ning et al. 2014 at growing depth, under two laws.

The program is read once; replan() takes over what a new depth leaves as it was.
"""

import pathlib

import toolpace

BLOCKS = pathlib.Path(__file__).parents[1] / "nc" / "blocks20.ngc"

plans = {law: toolpace.plan(BLOCKS, law=law, am=3000, jm=1e6) for law in ("quintic", "seven-phase")}
print(f"{'N':>5} " + " ".join(f"{law:>14}" for law in plans))
for depth in (1, 2, 3, 4, 6, 8, "all"):
    times = [toolpace.replan(plan, lookahead=depth).cycle_time_s for plan in plans.values()]
    print(f"{depth:>5} " + " ".join(f"{1000 * time:11.3f} ms" for time in times))
