"""verify, simulate, report and pulse tables, as their users meet them; setpoints also before an outside judge."""

import csv
import html.parser
import json
import subprocess
import sys
import unittest

from command_line import (BAD_INPUT, BAD_USAGE, EXAMPLES, FILE_TROUBLE, FINE, LIMIT_BROKEN, MACHINES, PATIENCE_S, SOURCE_DIR,
                          CommandLineTest)

MILL = MACHINES / "mill-3axis.toml"
CHECKER = SOURCE_DIR.parent / "shared" / "oracle" / "check_setpoints.py"
SQUARE = "G21 G90 G94\nG1 X20 F3000\nY20\nX0\nY0\nM2\n"
STRICT = """[path]
max_speed_mm_s = 100
max_acceleration_mm_s2 = 2000
max_jerk_mm_s3 = 5e4
""" + "".join(f"[axes.{axis}]\nmax_speed_mm_s = 100\nmax_acceleration_mm_s2 = 2000\nmax_jerk_mm_s3 = 5e4\n" for axis in "XYZ")


class Verify(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.file("square.ngc", SQUARE)
        self.file("strict.toml", STRICT)

    def plan(self, out, *more):
        run = self.run_toolpace("plan", "square.ngc", "--machine", "strict.toml", "--setpoints", out, *more)
        self.assertEqual(run.code, FINE, run.err)

    def test_every_format_of_a_good_plan_passes(self):
        for out in ("a.csv", "a.npy", "a.npz", "a.halstream", "a.semicolon.csv"):
            self.plan(out, "--decimal-comma")
            run = self.run_toolpace("verify", out, "--machine", "strict.toml", "--program", "square.ngc", "--tolerance-mm", "1e-5")
            self.assertEqual(run.code, FINE, f"{out}\n{run.out.decode()}{run.err}")

    def test_a_broken_limit_is_named_with_its_place_and_exit_code_1(self):
        self.plan("a.csv")
        self.file("weak.toml", STRICT.replace("[axes.Y]\nmax_speed_mm_s = 100", "[axes.Y]\nmax_speed_mm_s = 40"))
        run = self.run_toolpace("verify", "a.csv", "--machine", "weak.toml", "--json")
        self.assertEqual(run.code, LIMIT_BROKEN)
        broken = [check for check in run.json()["checks"] if check["broken"]]
        self.assertEqual([(c["check"], c["axis"]) for c in broken], [("axis-speed", "Y")])
        self.assertAlmostEqual(broken[0]["value_mm_s"], 50, places=6)
        self.assertIn(broken[0]["line"], (3, 5))

    def test_a_program_that_lowers_limits_is_planned_and_judged_by_them(self):
        self.plan("a.csv")
        self.file("slow.gcode", SQUARE.replace("G21 G90 G94", "M203 X40 Y30"))
        judged = self.run_toolpace("verify", "a.csv", "--machine", "strict.toml", "--program", "slow.gcode", "--json")
        self.assertEqual(judged.code, LIMIT_BROKEN)
        broken = [check for check in judged.json()["checks"] if check["broken"]]
        self.assertEqual([(c["check"], c["axis"], c["limit_mm_s"]) for c in broken], [("axis-speed", "X", 40), ("axis-speed", "Y", 30)])
        self.assertIn("limits that the program sets", judged.json()["notes"][0])
        slow = ("plan", "slow.gcode", "--machine", "strict.toml", "--setpoints", "b.csv", "--verify", "--json")
        run = self.run_toolpace(*slow)
        self.assertEqual(run.code, FINE, run.err)
        self.assertGreater(run.json()["time_by_limit_s"]["program_limit"], 2)  # 40 mm at 40 mm/s and 40 mm at 30 mm/s

    def test_plan_verify_reads_the_file_back(self):
        run = self.run_toolpace("plan", "square.ngc", "--machine", "strict.toml", "--setpoints", "a.npz", "--verify", "--json")
        self.assertEqual(run.code, FINE, run.err)
        self.assertEqual(run.json()["violations"], 0)
        self.assertLess(run.json()["max_path_deviation_mm"], 1e-6)

    def test_a_law_without_a_jerk_limit_is_told_by_the_file_or_by_a_flag(self):
        for out in ("a.csv", "a.npz"):
            self.plan(out, "--law", "trapezoid")
        for code, *more in ((LIMIT_BROKEN, "a.csv"), (FINE, "a.csv", "--law", "trapezoid"), (FINE, "a.csv", "--no-jerk-limit"), (FINE, "a.npz"),
                            (LIMIT_BROKEN, "a.npz", "--law", "quintic")):
            run = self.run_toolpace("verify", *more, "--machine", "strict.toml")
            self.assertEqual(run.code, code, f"{more}\n{run.out.decode()}{run.err}")

    def test_a_reversal_at_speed_is_no_corner(self):
        ramp = list(range(0, 61)) + [60] * 20
        speeds = ramp + [-v for v in reversed(ramp)]
        x, rows = 0.0, ["t_s,x_mm"]
        for k, v in enumerate(speeds):
            rows.append(f"{k / 1000},{x!r}")
            x += v * 0.001
        self.file("back.csv", "\n".join(rows) + "\n")
        self.file("soft.toml", "[path]\nmax_speed_mm_s = 100\nmax_acceleration_mm_s2 = 2000\n")
        for more, code in (([], LIMIT_BROKEN), (["--corner-step-mm-s", "120"], FINE), (["--corner-step-mm-s", "100"], LIMIT_BROKEN)):
            run = self.run_toolpace("verify", "back.csv", "--machine", "soft.toml", "--json", *more)
            self.assertEqual(run.code, code, f"{more}\n{run.out.decode()}{run.err}")
        self.assertEqual({c["check"] for c in run.json()["checks"] if c["broken"]}, {"path-deceleration"})

    def test_standard_input_is_a_setpoint_file_too(self):
        self.plan("a.csv")
        run = self.run_toolpace("verify", "-", "--machine", "strict.toml", stdin=(self.folder / "a.csv").read_bytes())
        self.assertEqual(run.code, FINE, run.err)

    def test_trouble_has_its_exit_code_and_its_place(self):
        self.plan("a.csv")
        self.expect_failure(self.run_toolpace("verify", "none.csv", "--machine", "strict.toml"), FILE_TROUBLE, "none.csv")
        self.expect_failure(self.run_toolpace("verify", "a.csv", "--machine", "none.toml"), FILE_TROUBLE, "none.toml")
        self.expect_failure(self.run_toolpace("verify", "a.csv"), BAD_USAGE, "--machine")
        self.file("bad.csv", "t_s,x_mm\n0,0\n0.001,zero\n")
        self.expect_failure(self.run_toolpace("verify", "bad.csv", "--machine", "strict.toml"), BAD_INPUT, "bad.csv:3:7")
        self.expect_failure(self.run_toolpace("verify", "a.csv", "--machine", "strict.toml", "--program", "square.ngc",
                                              "--tolerance-mm", "-1"), BAD_USAGE, "tolerance")

    def test_setpoints_that_no_file_keeps_are_proven_too(self):
        self.file("line.ngc", "G21 G90 G94\nG1 X10 F3000\nM2\n")
        for target in ([], ["--setpoints", "/dev/null"]):
            run = self.run_toolpace("plan", "line.ngc", "--verify", "--json", *target)
            self.assertEqual((run.code, run.json()["violations"]), (FINE, 0), run.err)

    @unittest.skipUnless(CHECKER.exists(), f"needs {CHECKER}, which is no part of the project")
    def test_an_outside_judge_agrees(self):
        self.plan("a.csv", "--corner", "stop")
        corners = [(0, 0), (20, 0), (20, 20), (0, 20), (0, 0)]
        self.file("path.csv", "x_mm,y_mm,z_mm\n" + "".join(f"{x},{y},0\n" for x, y in corners))
        judge = [sys.executable, CHECKER, "a.csv", "--v", "100", "--a", "2000", "--j", "50000", "--poly", "path.csv", "--tol",
                 "1e-6", "--on", "1e-6", "--end", "0", "0", "0"]
        done = subprocess.run(judge, cwd=self.folder, capture_output=True, timeout=PATIENCE_S)
        self.assertEqual(done.returncode, 0, done.stdout.decode() + done.stderr.decode())
        theirs = json.loads(done.stdout)
        run = self.run_toolpace("verify", "a.csv", "--machine", "strict.toml", "--program", "square.ngc", "--json")
        self.assertEqual(run.code, FINE)
        ours = {(c["check"], c["axis"]): c for c in run.json()["checks"]}
        for axis, index in (("X", 0), ("Y", 1)):
            for kind, key, unit in (("speed", "max_axis_v", "mm_s"), ("acceleration", "max_axis_a", "mm_s2"), ("jerk", "max_axis_j", "mm_s3")):
                value = ours[f"axis-{kind}", axis][f"value_{unit}"]
                self.assertAlmostEqual(value, theirs[key][index], delta=1e-6 * value)


class Simulate(CommandLineTest):
    def test_a_line_lags_by_speed_over_gain_and_has_no_contour_error(self):
        self.file("line.ngc", "G21 G90 G94\nG1 X60 Y80 F3000\nM2\n")
        run = self.run_toolpace("simulate", "line.ngc", "--kv-1-s", "25", "--trace", "trace.csv", "--json")
        self.assertEqual(run.code, FINE, run.err)
        servo = run.json()["servo"]
        self.assertAlmostEqual(servo["max_lag_mm"], 50 / 25, places=6)
        self.assertLess(servo["max_contour_error_mm"], 1e-9)
        with open(self.folder / "trace.csv") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), servo["rows"])
        self.assertEqual(float(rows[-1]["x_mm"]), 60)
        self.assertAlmostEqual(max(float(row["lag_mm"]) for row in rows), servo["max_lag_mm"], places=12)

    def test_the_drives_are_those_of_the_machine_file_over_the_defaults(self):
        self.file("m.toml", "[path]\nmax_speed_mm_s = 100\nmax_acceleration_mm_s2 = 1000\nmax_jerk_mm_s3 = 1e5\n"
                  "[servo]\nkv_1_s = 40\n[servo.Y]\nkv_1_s = 30\nbacklash_mm = 0.02\n")
        self.file("line.ngc", "G21 G90 G94\nG1 X3 Y4 F600\nM2\n")
        runs = [self.run_toolpace(*command, "line.ngc", "--machine", "m.toml", "--json") for command in (("plan", "--servo"), ("simulate",))]
        for run in runs:
            self.assertEqual(run.code, FINE, run.err)
            drives = run.json()["servo"]["drives"]
            self.assertEqual(drives["X"], {"kv_1_s": 40, "velocity_feed_forward": 0, "acceleration_feed_forward": 0, "bandwidth_hz": 100,
                                           "damping": 0.7, "backlash_mm": 0, "resonance_hz": 0, "resonance_damping": 0.05, "modes": []})
            self.assertEqual((drives["Y"]["kv_1_s"], drives["Y"]["backlash_mm"]), (30, 0.02))
            self.assertEqual(drives["C"]["kv_1_s"], 40)

    def test_plan_has_the_same_object_where_it_is_asked_for(self):
        self.assertIsNone(self.run_toolpace("plan", EXAMPLES / "butterfly.ngc", "--machine", MILL, "--json").json()["servo"])
        plan = self.run_toolpace("plan", EXAMPLES / "butterfly.ngc", "--machine", MILL, "--json", "--servo").json()
        simulate = self.run_toolpace("simulate", EXAMPLES / "butterfly.ngc", "--machine", MILL, "--json").json()
        self.assertEqual(plan["servo"], simulate["servo"])

    def test_a_gain_that_swings_up_is_refused(self):
        self.expect_failure(self.run_toolpace("simulate", EXAMPLES / "butterfly.ngc", "--kv-1-s", "5000"), BAD_USAGE, "servo-unstable")


class SelfContained(html.parser.HTMLParser):
    """Fails on anything that a page would fetch, and on tags that are not closed."""

    VOID = {"meta", "br", "hr", "line", "path", "i"}

    def __init__(self):
        super().__init__()
        self.open, self.svgs = [], 0

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            assert name not in ("src", "href"), f"{tag} refers to {value}"
        self.svgs += tag == "svg"
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if tag not in self.VOID:
            assert self.open.pop() == tag


class Report(CommandLineTest):
    def test_the_page_stands_alone_and_says_what_it_must(self):
        run = self.run_toolpace("report", EXAMPLES / "pocket.ngc", "--machine", MILL, "-o", "page.html")
        self.assertEqual(run.code, FINE, run.err)
        text = (self.folder / "page.html").read_text(encoding="utf-8")
        page = SelfContained()
        page.feed(text)
        self.assertEqual(page.open, [])
        self.assertGreaterEqual(page.svgs, 5)
        for words in ("pocket.ngc", "Mill, 3 axes", "cycle time", "X jerk", "every limit holds", "Contour error"):
            self.assertIn(words, text)

    def test_names_with_markup_stay_names(self):
        self.file("a<b>&.ngc", SQUARE)
        self.assertEqual(self.run_toolpace("report", "a<b>&.ngc", "-o", "page.html").code, FINE)
        text = (self.folder / "page.html").read_text(encoding="utf-8")
        self.assertIn("a&lt;b&gt;&amp;.ngc", text)
        self.assertNotIn("<b>", text)


class Pulses(CommandLineTest):
    def test_a_program_becomes_a_table_of_pulses(self):
        self.file("square.ngc", SQUARE)
        run = self.run_toolpace("plan", "square.ngc", "--machine", MACHINES / "stepper-router.toml", "--setpoints", "a.pulses.csv",
                                "--timer-hz", "1e6")
        self.assertEqual(run.code, FINE, run.err)
        header, *rows = (self.folder / "a.pulses.csv").read_text().splitlines()
        self.assertEqual(header, "t_ticks,axis,direction")
        pulses = [row.split(",") for row in rows]
        for axis in "XY":  # 20 mm there and back at 400 steps a mm
            steps = [int(direction) for _, name, direction in pulses if name == axis]
            self.assertEqual((len(steps), sum(steps)), (16000, 0))
        ticks = [int(t) for t, _, _ in pulses]
        self.assertEqual(ticks, sorted(ticks))

    def test_it_needs_a_clock_and_steps(self):
        self.file("square.ngc", SQUARE)
        table = ("--setpoints", "a.pulses.csv")
        self.expect_failure(self.run_toolpace("plan", "square.ngc", "--machine", MACHINES / "stepper-router.toml", *table), BAD_USAGE, "--timer-hz")
        self.expect_failure(self.run_toolpace("plan", "square.ngc", *table, "--timer-hz", "1e6"), BAD_USAGE, "steps_per_mm")
        self.assertFalse((self.folder / "a.pulses.csv").exists())


if __name__ == "__main__":
    unittest.main()
