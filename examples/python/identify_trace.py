"""From a trace of a machine to the figures of its drives.

The trace is made here, by a drive that is known, so that one sees what is found again; yours comes from a scope (columns t_s,
x_mm, …, actual_x_mm, …, see docs/FORMATS.md).
"""

import pathlib
import tempfile

import toolpace

NC = pathlib.Path(__file__).parents[1] / "nc"
PROGRAM = NC / "butterfly.ngc"

with tempfile.TemporaryDirectory() as folder:
    trace = pathlib.Path(folder) / "trace.csv"
    made = toolpace.simulate(PROGRAM, kv_1_s=60, trace=trace)
    seen = toolpace.compare(PROGRAM, trace)
    found = toolpace.identify(PROGRAM, trace)

print(f"made with a position gain of 60 1/s: contour error {1000 * made.servo['max_contour_error_mm']:.3f} µm at most")
for axis, told in seen.axes.items():
    print(f"{axis} lags {told['lag_ms']:.3f} ms, follows within {told['max_following_error_mm']:.4f} mm")
for axis, figures in found.axes.items():
    for name, figure in figures.items():
        if isinstance(figure, dict) and figure.get("value") is not None:
            print(f"{axis} {name:<26} {figure['value']:10.4g} ± {figure['standard_error']:.1g} {figure['unit']}")
