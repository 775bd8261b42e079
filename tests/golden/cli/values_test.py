"""Every value of a machine, given by file or by flag, is planned with or refused with its bounds; nothing between."""

import itertools
import json
import re
import unittest

from command_line import BAD_INPUT, BAD_USAGE, FINE, CommandLineTest

PROGRAM = "G21 G90 G94\nG1 X10 F3000\nG3 X15 Y5 J5\nG4 P0.5\nG1 A90 F3600\nG0 Z5\nM6 T1\nM2\n"
SECTIONS = {
    "machine": ["name", "period_ms", "tool_change_s"],
    "path": ["max_speed_mm_s", "max_acceleration_mm_s2", "max_deceleration_mm_s2", "max_jerk_mm_s3", "max_jerk_deceleration_mm_s3",
             "fine_acceleration_mm_s2"],
    "axes.X": ["max_speed_mm_s", "max_acceleration_mm_s2", "max_jerk_mm_s3", "travel_mm", "steps_per_mm"],
    "axes.A": ["max_speed_deg_s", "max_acceleration_deg_s2", "max_jerk_deg_s3", "travel_deg", "steps_per_deg"],
    "law": ["kind", "tacc_ms", "tdec_ms"],
    "lookahead": ["blocks", "ramps", "corner", "tolerance_mm", "junction_deviation_mm"],
    "servo": ["kv_1_s", "velocity_feed_forward", "acceleration_feed_forward", "bandwidth_hz", "damping", "backlash_mm",
              "resonance_hz", "resonance_damping"],
    "servo.A": ["backlash_deg"],
}
VALUES = ["0", "-1", "1e-310", "1e-320", "1e300", "nan", "inf", "-inf", "true", '"text"', "[1]", "[2, 1]", "{}", "1979-05-27",
          "9223372036854775807", "1e-7", "1e9"]
FLAGS = ["--vmax", "--am", "--dm", "--jm", "--jd", "--tacc-ms", "--tdec-ms", "--corner-step-mm-s", "--tolerance-mm",
         "--junction-deviation-mm", "--override-percent", "--rapid-percent", "--period-ms", "--hold-at-s", "--lookahead"]
NUMBER = r"-?\d[\d.]*(e-?\d+)?"
BOUNDS = re.compile(rf"must be ({NUMBER} to {NUMBER}|\[min, max\] with min < max, each {NUMBER} to {NUMBER}|a text|a whole number from)")


class Values(CommandLineTest):
    def plan(self, *arguments):
        run = self.run_toolpace("plan", "a.ngc", "--json", *arguments)
        if run.code == FINE:
            self.assertNotIn("NaN", run.out.decode(), arguments)
            plan = json.loads(run.out)
            self.assertGreater(plan["cycle_time_s"], 0, arguments)
            self.assertLess(plan["cycle_time_s"], 1e11, arguments)
        return run

    def setUp(self):
        super().setUp()
        self.file("a.ngc", PROGRAM)

    def judge(self, run, what):
        """Fine, or refused in a sentence that tells the bounds; slow and long jobs are refused as such."""
        if run.code == FINE:
            return
        error = run.json()["error"]
        self.assertNotIn("internal", error["code"], what)
        self.assertNotIn("nan days", run.err, what)
        if error["code"] in ("machine-value", "bad-limit"):
            self.assertEqual(run.code, BAD_USAGE, what)
            known_words = error["message"].startswith("'") or "no law" in error["message"]
            self.assertTrue(known_words or BOUNDS.search(error["message"]), f"{what}: {error['message']}")
        else:
            self.assertIn(error["code"], ("motion-too-long", "bad-flag", "usage", "no-speed-limit", "no-acceleration-limit",
                                          "limits-unbounded", "hold-after-end", "servo-unstable", "machine-syntax"), f"{what}: {run.err}")

    def test_every_key_takes_or_refuses_every_kind_of_value(self):
        keys = [(section, key) for section, keys in SECTIONS.items() for key in keys]
        for (k, (section, key)), (v, value) in itertools.product(enumerate(keys), enumerate(VALUES)):
            if (k + v) % 2 == 0:  # half of all pairs: each key meets half of the values, its neighbour the others
                with self.subTest(section=section, key=key, value=value):
                    text = f"[{section}]\n{key} = {value}\n"
                    self.judge(self.plan("--machine", self.file("m.toml", text), "--vmax", "100", "--am", "1000", "--jm", "1e5"),
                               text)

    def test_every_flag_takes_or_refuses_every_kind_of_number(self):
        for flag, value in itertools.product(FLAGS, ["0", "-1", "5e-324", "1e-310", "1e-320", "1e300", "nan", "inf", "true", "1e-7", "1e9", "1e18"]):
            with self.subTest(flag=flag, value=value):
                self.judge(self.plan(f"{flag}={value}"), (flag, value))

    def test_limits_at_both_ends_of_their_ranges_make_plans(self):
        self.file("a.ngc", "G21 G90 G94\nG1 X0.01 F3000\nG3 X0.03 Y0.02 J0.02\nM2\n")
        ends = {"--vmax": ("1e-6", "1e9"), "--am": ("1e-6", "1e12"), "--jm": ("1e-6", "1e15")}
        for speed, acceleration, jerk in itertools.product(*ends.values()):
            for law in ("trapezoid", "five-phase-time", "five-phase-jerk", "seven-phase", "quintic", "time-optimal"):
                with self.subTest(vmax=speed, am=acceleration, jm=jerk, law=law):
                    run = self.plan("--vmax", speed, "--am", acceleration, "--jm", jerk, "--law", law, "--period-ms", "10000")
                    self.judge(run, run.err)

    def test_drives_that_no_simulation_is_true_for_are_refused(self):
        for text, said in (("bandwidth_hz = 1e18", "0.01 to 1e5 Hz"), ("kv_1_s = 1e-320", "0.001 to 1e5 1/s"),
                           ("damping = inf", "0.001 to 100"), ("resonance_hz = 1e-3", "0.01 to 1e5 Hz, or 0 for none")):
            run = self.run_toolpace("simulate", "a.ngc", "--machine", self.file("m.toml", f"[servo]\n{text}\n"), "--vmax", "100",
                                    "--am", "1000", "--jm", "1e5")
            self.expect_failure(run, BAD_USAGE, "m.toml:2:", said)
        self.expect_failure(self.run_toolpace("simulate", "a.ngc", "--kv-1-s", "1e300"), BAD_USAGE, "--kv-1-s is 1e+300", "1/s")

    def test_dwells_tell_their_bounds(self):
        for text in ("G4 P1e12", "G4 P-1", "G82 X1 Z-1 R1 P99999999999 F100"):
            self.file("dwell.ngc", f"G21 G90 G94\n{text.replace('1e12', '1000000000000')}\nM2\n")
            self.expect_failure(self.run_toolpace("plan", "dwell.ngc"), BAD_INPUT, "0 to 1e9 s")

    def test_machines_of_other_controllers_are_read_wherever_machine_files_are(self):
        ini = self.file("mill.INI", "[TRAJ]\nMAX_LINEAR_VELOCITY = 50\nMAX_LINEAR_ACCELERATION = 500\n")
        dump = self.file("settings.txt", "".join(f"$11{k}=3000\n$12{k}=500\n" for k in range(3)) + "ok\n")
        for machine in (ini, dump):
            run = self.plan("--machine", machine, "--setpoints", "a.csv", "--vmax", "50", "--am", "500")
            self.assertEqual(run.code, FINE, run.err)
            self.assertEqual(run.json()["law"], "trapezoid")
            verified = self.run_toolpace("verify", "a.csv", "--machine", machine)
            self.assertEqual(verified.code, FINE, verified.err)

    def test_settings_that_make_no_sense_are_refused_with_their_line(self):
        self.file("odd.ini", "[AXIS_X]\nMIN_LIMIT = 100\nMAX_LIMIT = -100\n")
        self.expect_failure(self.run_toolpace("plan", "a.ngc", "--machine", "odd.ini"), BAD_USAGE, "odd.ini:3:", "min < max", "mm")


if __name__ == "__main__":
    unittest.main()
