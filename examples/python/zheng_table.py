"""Two moves of Zheng et al. 2014, table 2: the five-phase law with ramps of constant time.

The paper prints fmax = 91.1893 for the second move; its own formula (2L − fs·Tacc − fe·Tdec)/(Tacc + Tdec) gives 92.6667.
"""

import toolpace

MOVES = [dict(length=4000, feed=100, start=10, end=20, tacc=35, tdec=20), dict(length=4000, feed=100, start=10, end=20, tacc=45, tdec=30)]

print(f"{'L':>6} {'fmax':>9} {'reached':>8} {'sa':>9} {'sb':>9} {'T':>9}")
for move in MOVES:
    m = toolpace.move(law="five-phase-time", **move)
    print(f"{move['length']:6} {m.fmax:9.4f} {str(m.reaches_feed):>8} {m.sa:9.3f} {m.sb:9.3f} {m.t_total:9.4f}")
