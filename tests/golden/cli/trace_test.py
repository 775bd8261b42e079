"""compare and its traces, as their users meet them."""

import csv
import math
import random
import unittest

from command_line import BAD_INPUT, BAD_USAGE, FILE_TROUBLE, FINE, CommandLineTest

PROGRAM = "G21 G90 G17 G94\nG1 X30 F3000\nY20\nG2 X50 Y40 I20 J0\nG1 X10 Y5\nX0 Y0\nM2\n"
MACHINE = """[path]
max_speed_mm_s = 100
max_acceleration_mm_s2 = 3000
max_jerk_mm_s3 = 1e6

[servo]   # of all axes
kv_1_s = 63
velocity_feed_forward = 0.5
"""

PATH = "[path]\nmax_speed_mm_s = 100\nmax_acceleration_mm_s2 = 2000\nmax_jerk_mm_s3 = 1e5\n"


class Trace(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.file("a.ngc", PROGRAM)
        self.file("m.toml", MACHINE)
        self.simulated = self.run_toolpace("simulate", "a.ngc", "--machine", "m.toml", "--trace", "t.csv", "--json").json()["servo"]
        self.run_toolpace("plan", "a.ngc", "--machine", "m.toml", "--setpoints", "a.csv")

    def write(self, name, header, row, separator=",", rows=None):
        """A trace of the columns of t.csv that `row` picks from a dictionary of numbers."""
        with open(self.folder / "t.csv") as file:
            table = [{k: float(v) for k, v in r.items()} for r in csv.DictReader(file)][:rows]
        lines = [separator.join(header)] + [separator.join(repr(v) for v in row(r)) for r in table]
        return self.file(name, "\n".join(lines) + "\n")

    def test_the_trace_of_simulate_is_told_as_simulate_tells_it(self):
        told = self.run_toolpace("compare", "a.csv", "t.csv", "--json").json()
        for key in ("max_contour_error_mm", "rms_contour_error_mm", "worst_t_s"):
            self.assertAlmostEqual(told[key], self.simulated[key], places=6, msg=key)
        self.assertEqual(told["worst_line"], self.simulated["worst_line"])
        self.assertAlmostEqual(told["max_following_error_mm"], self.simulated["max_lag_mm"], places=6)
        self.assertAlmostEqual(told["alignment"]["offset_s"], 0, places=7)
        self.assertEqual(told["alignment"]["by"], "commanded")
        self.assertEqual([line["line"] for line in told["lines"]], [2, 3, 4, 5, 6])
        # Half of the speed is passed on, so the lag is half of 1/Kv.
        self.assertAlmostEqual(told["axes"]["X"]["lag_ms"], 0.5 / 63 * 1e3, delta=0.3)
        of_program = self.run_toolpace("compare", "a.ngc", "t.csv", "--machine", "m.toml", "--json").json()
        self.assertAlmostEqual(of_program["max_contour_error_mm"], told["max_contour_error_mm"], places=9)

    def test_a_trace_of_another_clock_is_laid_in_time(self):
        late = self.write("late.csv", ["time [ms]", "x", "x cmd", "y", "y cmd"],
                          lambda r: (r["t_s"] * 1e3 + 1234.5, r["actual_x_mm"], r["x_mm"], r["actual_y_mm"], r["y_mm"]))
        told = self.run_toolpace("compare", "a.csv", late, "--json").json()
        self.assertAlmostEqual(told["alignment"]["offset_s"], 1.2345, places=6)
        self.assertEqual([c["taken_for"] for c in told["columns"]], ["time", "actual X", "commanded X", "actual Y", "commanded Y"])
        self.assertAlmostEqual(told["max_contour_error_mm"], self.simulated["max_contour_error_mm"], places=6)

    def test_people_are_told_the_same(self):
        run = self.run_toolpace("compare", "a.csv", "t.csv")
        self.assertEqual(run.code, FINE, run.err)
        for word in (b"correlation 1.0000", b"axis X", b"axis Y", b"worst        line 3"):
            self.assertIn(word, run.out)

    def test_columns_may_be_told(self):
        inches = self.write("i.csv", ["u", "v", "w"], lambda r: (r["t_s"], r["actual_x_mm"] / 25.4, r["actual_y_mm"]))
        run = self.run_toolpace("compare", "a.csv", inches, "--columns", "t=u,x=v[in],y=3", "--json")
        self.assertEqual(run.code, FINE, run.err)
        run = self.run_toolpace("compare", "a.csv", inches, "--columns", "t=u,x=v,y=3", "--json")
        self.expect_failure(run, BAD_INPUT, "trace-unit", "inches")
        self.expect_failure(self.run_toolpace("compare", "a.csv", inches), BAD_INPUT, "trace-columns", "'v'")
        self.expect_failure(self.run_toolpace("compare", "a.csv", inches, "--columns", "x:v"), BAD_USAGE, "--columns")
        self.expect_failure(self.run_toolpace("compare", "a.csv", "t.csv", "--trace-period-ms", "0"), BAD_USAGE, "--trace-period-ms")

    def test_bad_traces_are_refused_with_a_clear_word(self):
        self.file("o.ngc", "G21 G90 G94\nG1 X3 Y5 F400\nX2 Y60\nX20\nX0 Y0 F2000\nM2\n")
        self.expect_failure(self.run_toolpace("compare", "o.ngc", "t.csv", "--json"), BAD_INPUT, "not of this program")
        short = self.write("short.csv", ["t_s", "x_mm"], lambda r: (r["t_s"], r["actual_x_mm"]), rows=20)
        self.expect_failure(self.run_toolpace("compare", "a.csv", short), BAD_INPUT, "short.csv:22", "20 rows")
        flat = self.write("flat.csv", ["t_s", "x_mm", "y_mm"], lambda r: (r["t_s"], min(40.0, r["actual_x_mm"]), r["actual_y_mm"]))
        self.expect_failure(self.run_toolpace("compare", "a.csv", flat), BAD_INPUT, "trace-saturated", "axis X")
        self.expect_failure(self.run_toolpace("compare", "a.csv", "none.csv"), FILE_TROUBLE, "none.csv")
        self.expect_failure(self.run_toolpace("compare", "none.csv", "t.csv"), FILE_TROUBLE, "none.csv")

    def test_identify_finds_the_drives_and_writes_them_into_the_machine_file(self):
        noise = random.Random(7)
        noisy = self.write("n.csv", ["t_s", "x_mm", "y_mm"],
                           lambda r: (r["t_s"], r["actual_x_mm"] + noise.gauss(0, 5e-4), r["actual_y_mm"] + noise.gauss(0, 5e-4)))
        run = self.run_toolpace("identify", "a.csv", noisy, "--machine", "m.toml", "-o", "servo.toml", "--json")
        self.assertEqual(run.code, FINE, run.err)
        told = run.json()
        for axis in "XY":
            gain = told["axes"][axis]["position_gain"]
            self.assertLess(abs(gain["value"] - 63), 3 * gain["standard_error"], axis)
            self.assertFalse(told["axes"][axis]["resonance"]["told"])
            self.assertIn("no resonance", told["axes"][axis]["resonance"]["verdict"])
        written = (self.folder / "servo.toml").read_text()
        self.assertIn("[servo]   # of all axes\nkv_1_s = 63\n", written)
        self.assertIn(f"[servo.X]\nkv_1_s = {told['axes']['X']['position_gain']['value']:.6g}\n", written)
        self.assertTrue(written.startswith("[path]\nmax_speed_mm_s = 100\n"))
        # It is a machine file, whose drives do what the trace shows.
        self.run_toolpace("simulate", "a.ngc", "--machine", "servo.toml", "--trace", "again.csv")
        lag = self.run_toolpace("simulate", "a.ngc", "--machine", "servo.toml", "--json").json()["servo"]["max_lag_mm"]
        self.assertAlmostEqual(lag, self.simulated["max_lag_mm"], places=3)
        # Once more: into the same file.
        again = self.run_toolpace("identify", "a.csv", noisy, "-o", "servo.toml")
        self.assertEqual(again.code, FINE, again.err)
        self.assertEqual((self.folder / "servo.toml").read_text(), written)

    def test_identify_writes_over_nothing_that_it_reads(self):
        for flags in (("-o", "t.csv"), ("-o", "a.csv"), ("--machine", "m.toml", "-o", "m.toml")):
            self.expect_failure(self.run_toolpace("identify", "a.csv", "t.csv", *flags), BAD_USAGE, "output-is-input")
        self.file("bad.toml", "[servo\n")
        self.expect_failure(self.run_toolpace("identify", "a.csv", "t.csv", "-o", "bad.toml"), BAD_USAGE, "bad.toml")

    def test_a_plan_tells_how_axes_with_a_resonance_vibrate(self):
        self.file("one.ngc", "G21 G90 G94\nG1 X30 F3000\nM2\n")
        self.file("r.toml", MACHINE.replace("kv_1_s", "resonance_damping = 0.001\n[servo.X]\nresonance_hz = 40\nkv_1_s"))
        plan = ("plan", "one.ngc", "--machine", "r.toml", "--law", "five-phase-time", "--json")
        calm = self.run_toolpace(*plan, "--tacc-ms", 50, "--tdec-ms", 50).json()["vibration"]  # two periods
        hard = self.run_toolpace(*plan, "--tacc-ms", 25, "--tdec-ms", 25).json()["vibration"]
        self.assertEqual(list(calm), ["X"])
        self.assertEqual(calm["X"]["resonance_hz"], 40)
        self.assertLess(calm["X"]["residual_um"], 0.02 * hard["X"]["residual_um"])
        self.assertGreater(calm["X"]["peak_um"], 1)
        self.assertEqual(self.run_toolpace("plan", "one.ngc", "--json").json()["vibration"], {})

    def accelerometer(self, name, felt, rows=6000, rate=2000, most=1e9):
        noise = random.Random(3)
        lines = [f"{7 + i / rate:.6f},{min(most, felt(i / rate) + noise.gauss(0, 5)):.4f},{noise.gauss(0, 5):.4f},9806.6" for i in range(rows)]
        return self.file(name, "#time,accel_x,accel_y,accel_z\n" + "\n".join(lines) + "\n")

    def test_an_accelerometer_tells_the_modes_of_an_axis(self):
        tap = lambda t: 2000 * math.exp(-0.02 * 2 * math.pi * 40 * t) * math.cos(2 * math.pi * 40 * t)
        tapped = self.accelerometer("raw.csv", tap)
        self.file("mill.toml", "# ours\n[servo.X]\nkv_1_s = 60\n\n[[servo.X.modes]]\nfrequency_hz = 38 # old\n")
        run = self.run_toolpace("identify", "--accelerometer", tapped, "-o", "mill.toml", "--json")
        self.assertEqual(run.code, FINE, run.err)
        (mode,) = run.json()["axes"]["X"]["modes"]
        self.assertAlmostEqual(mode["frequency_hz"], 40, delta=0.2)
        self.assertAlmostEqual(mode["damping"], 0.02, delta=0.002)
        self.assertEqual(run.json()["axes"]["Y"]["modes"], [])
        text = (self.folder / "mill.toml").read_text()
        self.assertIn("# ours", text)
        self.assertRegex(text, r"frequency_hz = (39\.\d+|40\.\d+|40) # old\ndamping = 0\.0\d+")
        said = self.run_toolpace("identify", "--accelerometer", tapped)
        self.assertIn(b"Hz, damping 0.0", said.out)

    def test_bad_recordings_are_refused_with_a_clear_word(self):
        for felt, most, word in ((lambda t: 0, 1e9, "accelerometer-no-peak"), (lambda t: 4000 * math.sin(200 * t), 900, "accelerometer-saturated")):
            recording = self.accelerometer("r.csv", felt, most=most)
            self.expect_failure(self.run_toolpace("identify", "--accelerometer", recording), BAD_INPUT, word)
        self.expect_failure(self.run_toolpace("identify", "--accelerometer", self.accelerometer("r.csv", lambda t: 0, rows=300)),
                            BAD_INPUT, "r.csv:30", "accelerometer-short")
        self.expect_failure(self.run_toolpace("identify"), BAD_USAGE, "--accelerometer")
        self.expect_failure(self.run_toolpace("identify", "a.csv", "t.csv", "--accelerometer", "r.csv"), BAD_USAGE, "either")

    def test_advice_is_what_planning_with_it_gives(self):
        self.file("one.ngc", "G21 G90 G94\nG1 X30 F6000\nG4 P0.2\nG1 X2\nM2\n")
        self.file("r.toml", PATH + "[[servo.X.modes]]\nfrequency_hz = 23\ndamping = 0.02\n")
        run = self.run_toolpace("simulate", "one.ngc", "--machine", "r.toml", "--advice", "--vibration-um", "2", "--json")
        self.assertEqual(run.code, FINE, run.err)
        advice = run.json()["advice"]
        self.assertGreater(advice["present"]["residual_um"], 2)
        self.assertTrue(advice["best"]["keeps"])
        self.assertEqual({c["by"] for c in advice["choices"]},
                         {"five-phase ramps", "seven-phase ramps", "quintic ramps"} | {f"shaper {k}" for k in ("zv", "zvd", "mzv", "ei", "2hump")})
        for choice in advice["choices"]:
            flags = [str(word) for pair in choice["settings"].items() for word in pair]
            again = self.run_toolpace("plan", "one.ngc", "--machine", "r.toml", *flags, "--json").json()
            self.assertEqual(again["cycle_time_s"], choice["cycle_time_s"], choice["by"])
            self.assertEqual(again["vibration"]["X"]["residual_um"], choice["residual_um"], choice["by"])
        bands = {c["by"]: c["band_5_percent"] for c in advice["choices"]}
        self.assertIsNone(bands["quintic ramps"])
        self.assertLess(bands["shaper zvd"][0], bands["shaper zv"][0])
        self.assertLess(bands["shaper zv"][1], bands["shaper zvd"][1])
        curves = {c["by"]: c["robustness"] for c in advice["choices"]}
        self.assertIsNone(curves["quintic ramps"])
        for by in ("shaper zv", "shaper zvd", "shaper mzv", "shaper ei", "shaper 2hump"):
            curve = dict(map(tuple, curves[by]))
            self.assertEqual(len(curve), 21)
            low, high = bands[by]
            for share, left in curve.items():
                if low < share < high:
                    self.assertLessEqual(left, 0.05 * (1 + 1e-6), (by, share))
            self.assertGreater(curve[0.5], 0.2, by)
        self.assertLess(dict(map(tuple, curves["shaper zvd"]))[1.1], dict(map(tuple, curves["shaper zv"]))[1.1])
        self.assertIn(b"* ", self.run_toolpace("simulate", "one.ngc", "--machine", "r.toml", "--advice").out)
        self.expect_failure(self.run_toolpace("simulate", "one.ngc", "--vibration-um", "2"), BAD_USAGE, "--advice")
        self.expect_failure(self.run_toolpace("simulate", "one.ngc", "--advice"), BAD_USAGE, "no axis of the machine has a resonance")

    def test_every_mode_of_an_axis_counts_and_is_shaped_for(self):
        self.file("one.ngc", "G21 G90 G94\nG1 X30 F3000\nM2\n")
        modes = "[[servo.X.modes]]\nfrequency_hz = 31\ndamping = 0.02\n[[servo.X.modes]]\nfrequency_hz = 47\nshare = 0.5\n"
        self.file("r.toml", PATH + "[lookahead]\nshaper = \"zv\"\n" + modes)
        plan = ("plan", "one.ngc", "--machine", "r.toml", "--json")
        hard, calm = (self.run_toolpace(*plan, *flags).json() for flags in (("--shaper", "none"), ()))
        x = hard["vibration"]["X"]
        self.assertEqual([(m["frequency_hz"], m["damping"], m["share"]) for m in x["modes"]], [(31, 0.02, 1), (47, 0.05, 0.5)])
        self.assertEqual((x["resonance_hz"], x["damping"]), (31, 0.02))
        self.assertAlmostEqual(x["residual_um"], sum(m["residual_um"] for m in x["modes"]), places=9)
        self.assertLess(calm["vibration"]["X"]["residual_um"], 1e-6 * x["residual_um"])
        self.assertEqual(calm["shaper"]["modes"], [{"frequency_hz": 31, "damping": 0.02}, {"frequency_hz": 47, "damping": 0.05}])
        drives = self.run_toolpace("simulate", "one.ngc", "--machine", "r.toml", "--json").json()["servo"]["drives"]
        self.assertEqual(drives["X"]["modes"][1], {"frequency_hz": 47, "damping": 0.05, "share": 0.5})
        tuned = self.run_toolpace("tune", "one.ngc", "--machine", "r.toml", "--plans", 3, "--json").json()
        self.assertAlmostEqual(tuned["present"]["vibration_um"], calm["vibration"]["X"]["residual_um"], places=9)

    def test_a_shaper_takes_the_vibration_out_and_keeps_every_limit(self):
        self.file("two.ngc", "G21 G90 G94\nG1 X30 Y5 F3000\nG2 X40 Y5 I5 J0\nG4 P0.2\nG1 X2\nM2\n")
        self.file("r.toml", PATH + "[servo.Y]\nresonance_hz = 30\nresonance_damping = 0.01\n")
        plan = ("plan", "two.ngc", "--machine", "r.toml", "--corner", "stop", "--tolerance-mm", 0.5, "--setpoints", "s.csv", "--verify", "--json")
        hard = self.run_toolpace(*plan).json()
        for kind in ("zv", "zvd", "mzv", "ei", "2hump"):
            run = self.run_toolpace(*plan, "--shaper", kind)
            self.assertEqual(run.code, FINE, run.err)
            told = run.json()
            self.assertEqual(told["violations"], 0)
            self.assertLess(told["vibration"]["Y"]["residual_um"], 0.06 * hard["vibration"]["Y"]["residual_um"], kind)
            self.assertEqual(told["shaper"]["kind"], kind)
            self.assertGreater(told["shaper"]["max_offset_mm"], 0.001)
            self.assertLess(told["max_path_deviation_mm"], told["shaper"]["max_offset_mm"] + 0.001)
            self.assertAlmostEqual(told["cycle_time_s"], hard["cycle_time_s"] + told["shaper"]["time_s"], places=12)
            self.assertAlmostEqual(sum(told["time_by_limit_s"].values()), told["cycle_time_s"], places=6)
            self.assertEqual(told["setpoints"], len((self.folder / "s.csv").read_text().splitlines()) - 1)
        self.run_toolpace(*plan[:-3], "s.npz", "--shaper", "zv")
        told = {}
        for file in ("s.npz", "s.csv"):
            told[file] = self.run_toolpace("verify", file, "--machine", "r.toml", "--json").json()["shaper"]
        self.assertEqual(told, {"s.npz": "zv", "s.csv": None})
        shaped = self.run_toolpace("simulate", "two.ngc", "--machine", "r.toml", "--corner", "stop", "--shaper", "zv", "--json").json()
        still = self.run_toolpace("simulate", "two.ngc", "--machine", "r.toml", "--corner", "stop", "--json").json()
        self.assertLess(shaped["servo"]["settling_time_s"], still["servo"]["settling_time_s"])

    def test_a_shaper_stops_where_corners_would_be_steps_and_says_what_it_cannot_do(self):
        self.file("r.toml", PATH + "[servo.Y]\nresonance_hz = 30\n")
        run = self.run_toolpace("plan", "a.ngc", "--machine", "r.toml", "--shaper", "zv", "--json")
        self.assertIn("shaper-stops", run.err)
        self.assertEqual(run.json()["ran"]["corner"], "stop")
        self.expect_failure(self.run_toolpace("plan", "a.ngc", "--shaper", "zv"), BAD_USAGE, "no axis of the machine has a resonance")
        self.expect_failure(self.run_toolpace("plan", "a.ngc", "--machine", "r.toml", "--shaper", "zw"), BAD_USAGE, "2hump")
        self.expect_failure(self.run_toolpace("plan", "a.ngc", "--machine", "r.toml", "--shaper", "zv", "--timer-hz", "1e6",
                                              "--setpoints", "s.pulses.csv"), BAD_USAGE, "step pulses")


if __name__ == "__main__":
    unittest.main()
