"""tune, as its users meet it: points that plan and simulate confirm, limits that are kept, machine files that keep their comments."""

import unittest

from command_line import BAD_INPUT, BAD_USAGE, FINE, LIMIT_BROKEN, CommandLineTest

NC = "G21 G90 G94 F6000\nG1 X4\nG1 X5 Y2\nG1 X1 Y3\nG2 X3 Y5 I2 J0\nG1 X20 Y0\nM2\n"
MACHINE = """# the mill in the corner
[path]
max_speed_mm_s = 100.0
max_acceleration_mm_s2 = 3000.0   # as its maker says
max_deceleration_mm_s2 = 2000.0
max_jerk_mm_s3 = 1e6
[law]
kind = "five-phase-time"          # as ever
tacc_ms = 30
"""


class Tune(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.file("a.ngc", NC)
        self.file("m.toml", MACHINE)

    def tune(self, *arguments):
        run = self.run_toolpace("tune", "a.ngc", "--machine", "m.toml", *arguments, "--json")
        self.assertEqual(run.code, FINE, run.err)
        return run.json()

    def confirm(self, point, machine="m.toml"):
        flags = [word for flag, value in point["settings"].items() for word in (flag, value)]
        plan = self.run_toolpace("plan", "a.ngc", "--machine", machine, *flags, "--json").json()
        simulated = self.run_toolpace("simulate", "a.ngc", "--machine", machine, *flags, "--json").json()
        self.assertEqual(plan["cycle_time_s"], point["cycle_time_s"], flags)
        self.assertEqual(simulated["cycle_time_s"], point["cycle_time_s"], flags)
        self.assertEqual(simulated["servo"]["max_contour_error_mm"] / 1e-3, point["contour_um"], flags)

    def test_each_point_is_what_plan_and_simulate_print_with_its_flags(self):
        told = self.tune("--plans", 40, "--override-percent", 90, "--dm", 1500)
        self.assertEqual(told["plans_evaluated"], 40)
        self.assertGreater(len(told["front"]), 3)
        for point in told["front"] + [told["present"], told["knee"], told["best"]]:
            self.confirm(point)
            self.assertEqual(point["settings"]["--override-percent"], 90)
            self.assertIsNone(point["vibration_um"])
        for a in told["front"]:
            for b in told["front"]:
                if a is not b:
                    self.assertFalse(a["cycle_time_s"] <= b["cycle_time_s"] and a["contour_um"] <= b["contour_um"], (a, b))

    def test_vibration_counts_where_an_axis_has_a_resonance(self):
        self.file("m.toml", MACHINE + "[servo.X]\nresonance_hz = 28.0\nresonance_damping = 0.03\n")
        present = self.tune("--plans", 1)["present"]
        told = self.tune("--plans", 48, "--vibration-um", present["vibration_um"] / 4, "--contour-um", 2 * present["contour_um"])
        self.assertLessEqual(told["best"]["vibration_um"], told["vibration_limit_um"])
        self.assertEqual(told["vibration_limit_um"], present["vibration_um"] / 4)
        for point in told["front"] + [told["present"], told["best"]]:
            flags = [word for flag, value in point["settings"].items() for word in (flag, value)]
            plan = self.run_toolpace("plan", "a.ngc", "--machine", "m.toml", *flags, "--json").json()
            self.assertEqual(plan["vibration"]["X"]["residual_um"], point["vibration_um"], flags)
            self.confirm(point)
        for a in told["front"]:
            for b in told["front"]:
                if a is not b:
                    self.assertFalse(all(a[k] <= b[k] for k in ("cycle_time_s", "contour_um", "vibration_um")), (a, b))

    def test_a_limit_on_vibration_needs_a_resonance(self):
        run = self.run_toolpace("tune", "a.ngc", "--machine", "m.toml", "--vibration-um", 5)
        self.assertEqual(run.code, BAD_USAGE)
        self.assertIn("no axis of the machine has a resonance", run.err)

    def test_the_best_keeps_the_limit_and_goes_into_the_machine_file(self):
        limit = self.tune("--plans", 1)["present"]["contour_um"] / 2
        told = self.tune("--plans", 40, "--contour-um", limit, "-o", "best.toml")
        self.assertLessEqual(told["best"]["contour_um"], limit)
        self.assertEqual(told["contour_limit_um"], limit)
        text = (self.folder / "best.toml").read_text()
        for comment in ("# the mill in the corner", "# as its maker says", "# as ever"):
            self.assertIn(comment, text)
        self.confirm({**told["best"], "settings": {}}, "best.toml")

    def test_what_nothing_keeps_is_told_and_writes_nothing(self):
        self.file("best.toml", "old")
        run = self.run_toolpace("tune", "a.ngc", "--machine", "m.toml", "--plans", 3, "--contour-um", 1e-6, "-o", "best.toml", "--json")
        self.assertEqual((run.code, run.json()["best"]), (LIMIT_BROKEN, None), run.err)
        self.assertEqual((self.folder / "best.toml").read_text(), "old")

    def test_only_what_is_to_be_varied_is(self):
        told = self.tune("--plans", 16, "--vary", "am,jm")
        self.assertGreater(len(told["front"]), 1)
        for point in told["front"]:
            self.assertLessEqual(set(point["settings"]), {"--am", "--dm", "--jm", "--jd"})
            self.assertLessEqual(point["settings"].get("--am", 0), 3000)
            self.assertLessEqual(point["settings"].get("--dm", 0), 2000)

    def test_the_same_arguments_give_the_same_bytes(self):
        arguments = ["tune", "a.ngc", "--machine", "m.toml", "--plans", 24, "--json"]
        self.assertEqual(self.run_toolpace(*arguments).out, self.run_toolpace(*arguments).out)

    def test_seconds_end_it(self):
        self.assertLess(self.tune("--seconds", 0.2)["plans_evaluated"], 100000)

    def test_people_are_told_the_flags(self):
        run = self.run_toolpace("tune", "a.ngc", "--plans", 12)
        self.assertEqual(run.code, FINE, run.err)
        self.assertRegex(run.out.decode(), r"now +\S+ s +\S+ µm  as it is\n  front .* --.*\n(.*\n)+  knee .*\n  best .*\n")

    def test_what_makes_no_sense_is_refused(self):
        for flag, value, said in (("--vary", "am,feed", "feed"), ("--vary", "am,,jm", "--vary"), ("--contour-um", 0, "--contour-um"),
                                  ("--seconds", -1, "--seconds"), ("--plans", 10000000, "--plans")):
            self.expect_failure(self.run_toolpace("tune", "a.ngc", flag, value, "--json"), BAD_USAGE, said)
        self.file("bad.ngc", "G1 X\n")
        self.expect_failure(self.run_toolpace("tune", "bad.ngc", "--plans", 2), BAD_INPUT, "bad.ngc")

    ALLOWED = "".join(f"[axes.{a}]\nmax_speed_mm_s = 60\nmax_acceleration_mm_s2 = {n}\n" for a, n in
                      (("X", 800), ("Y", 600), ("Z", 100))) + "[lookahead]\ntolerance_mm = 0.04\njunction_deviation_mm = 0.03\n"

    def tuned_settings(self, name, text, lines_are_shared=False):
        """What tune --settings says of a controller's settings with a machine and without, all of it confirmed by predict."""
        self.file(name, text)
        self.file("mill.toml", self.ALLOWED)
        run = self.run_toolpace("tune", "a.ngc", "--settings", name, "--machine", "mill.toml", "-o", "better", "--json")
        self.assertEqual(run.code, FINE, run.err)
        told = run.json()
        better = (self.folder / "better").read_text()
        self.assertLess(told["cycle_time_after_s"], told["cycle_time_before_s"])
        self.assertEqual(set(told["lines"]), set(better.splitlines()) - set(text.splitlines()))
        if not lines_are_shared:
            self.assertEqual(len(told["lines"]), len(told["changes"]), "each change is a line")
        for file, key in ((name, "cycle_time_before_s"), ("better", "cycle_time_after_s")):
            predicted = self.run_toolpace("predict", "a.ngc", "--settings", file, "--no-what-if", "--json").json()
            self.assertEqual(predicted["cycle_time_s"], told[key])
        kept = self.run_toolpace("tune", "a.ngc", "--settings", name, "--json").json()
        limits = {c["setting"] for c in told["changes"]} - {"[printer] minimum_cruise_ratio"}
        self.assertFalse({c["setting"] for c in kept["changes"]} & limits, "without a machine no limit is raised")
        again = self.run_toolpace("tune", "a.ngc", "--settings", "better", "--machine", "mill.toml", "--json").json()
        self.assertGreater(again["cycle_time_after_s"], 0.999 * told["cycle_time_after_s"], "the best of the best is the same")
        return told, {c["setting"]: c["to"] for c in told["changes"]}

    def test_settings_of_grbl_come_back_as_its_own_lines(self):
        dump = "$0=10\n$11=0.010\n$100=250\n$101=250\n$102=250\n$110=3000\n$111=3000\n$112=1500\n$120=200\n$121=200\n$122=50\n"
        told, values = self.tuned_settings("grbl.txt", dump)
        self.assertEqual((values["$120"], values["$121"], values["$11"]), (800, 600, 0.03))
        self.assertNotIn("$122", values)  # Z does not move: it helps nothing
        self.assertIn("$120=800", told["lines"])
        tune = ("tune", "a.ngc", "--settings", "grbl.txt")
        self.assertIn(b"$120=800", self.run_toolpace(*tune, "--machine", "mill.toml").out)
        one = self.run_toolpace(*tune, "--machine", "mill.toml", "--vary", "$120,$11", "--json").json()
        self.assertEqual({c["setting"] for c in one["changes"]}, {"$120", "$11"})
        self.expect_failure(self.run_toolpace(*tune, "--vary", "am"), BAD_USAGE, "--vary", "$120")
        self.expect_failure(self.run_toolpace(*tune, "--contour-um", 5), BAD_USAGE, "--settings")

    def test_settings_of_klipper_come_back_as_its_own_lines(self):
        text = ("# ours\n[printer]\nkinematics: cartesian\nmax_velocity: 50\nmax_accel: 200   # careful\nmax_z_velocity: 5\nmax_z_accel: 50\n"
                "square_corner_velocity: 1.0\n[gcode_arcs]\nresolution: 0.1\n")
        self.ALLOWED = "[path]\nmax_acceleration_mm_s2 = 700\n" + self.ALLOWED
        told, values = self.tuned_settings("printer.cfg", text)
        self.assertEqual(values["[printer] max_accel"], 600)  # all that Y may do: Klipper knows none of its axes
        self.assertNotIn("[printer] max_z_accel", values)
        self.assertIn("max_accel: 600   # careful", told["lines"])
        one = self.run_toolpace("tune", "a.ngc", "--settings", "printer.cfg", "--machine", "mill.toml", "--vary", "max_accel", "--json").json()
        self.assertEqual([c["setting"] for c in one["changes"]], ["[printer] max_accel"])
        corner = values["[printer] square_corner_velocity"]  # v² (√2 - 1) / a is the junction deviation
        self.assertLessEqual(corner ** 2 * (2 ** 0.5 - 1) / 600, 0.03 * 1.000001)

    def test_settings_of_marlin_come_back_as_its_own_lines(self):
        text = ("echo:  G21    ; Units in mm (mm)\necho:; Steps per unit:\necho: M92 X80.00 Y80.00 Z400.00\necho:; Maximum feedrates (units/s):\n"
                "echo:  M203 X50.00 Y50.00 Z5.00\necho:; Maximum Acceleration (units/s2):\necho:  M201 X200.00 Y150.00 Z50.00\n"
                "echo:; Acceleration (units/s2):\necho:  M204 P180.00 R180.00 T180.00\necho:; Advanced:\n"
                "echo:  M205 B20000.00 S0.00 T0.00 J0.01\n")
        self.ALLOWED = "[path]\nmax_acceleration_mm_s2 = 700\n" + self.ALLOWED
        told, values = self.tuned_settings("marlin.txt", text, lines_are_shared=True)
        self.assertEqual((values["M201 X"], values["M201 Y"], values["M204 T"], values["M205 J"]), (700, 600, 700, 0.03))
        self.assertFalse({"M201 Z", "M204 P"} & set(values), "nothing moves Z, nothing is printed")
        self.assertIn("echo:  M201 X700.00 Y600.00 Z50.00", told["lines"])
        self.assertIn("echo:  M205 B20000.00 S0.00 T0.00 J0.03", told["lines"])

    INI = ("[EMC]\nMACHINE = lathe of yore\n[TRAJ]\nCOORDINATES = XYZ\nLINEAR_UNITS = mm\nMAX_LINEAR_VELOCITY = 50\n[KINS]\n"
           "KINEMATICS = trivkins coordinates=xyz\n[RS274NGC]\nRS274NGC_STARTUP_CODE = G21 G90 G64 P0.002 (as ever)\n" +
           "".join(f"[AXIS_{a}]\nMAX_VELOCITY = 40\nMAX_ACCELERATION = 200.0\n" for a in "XYZ"))

    def test_settings_of_linuxcnc_come_back_with_the_tolerance_of_g64(self):
        told, values = self.tuned_settings("mill.ini", self.INI)
        self.assertEqual((values["[AXIS_X] MAX_ACCELERATION"], values["[AXIS_Y] MAX_ACCELERATION"]), (800, 600))
        self.assertLessEqual(max(value for key, value in values.items() if key.endswith("VELOCITY")), 105, "no more than all axes can do")
        self.assertEqual(values["G64 P"], 0.04)
        self.assertIn("RS274NGC_STARTUP_CODE = G21 G90 G64 P0.040 (as ever)", told["lines"])

    def test_a_program_that_tells_its_own_tolerance_leaves_that_of_the_settings(self):
        self.file("a.ngc", NC.replace("F6000", "F6000 G64 P0.01"))
        self.assertNotIn("G64 P", self.tuned_settings("mill.ini", self.INI)[1])

    def test_a_page_shows_before_and_after(self):
        told = self.tune("--plans", 12, "--report", "page.html")
        page = (self.folder / "page.html").read_text()
        for text in (f'{told["present"]["cycle_time_s"]:.4f} s', f'{told["best"]["cycle_time_s"]:.4f} s', "What was changed", "<svg"):
            self.assertIn(text, page)
        for flag in told["best"]["settings"]:
            self.assertIn(flag[2:], page)


if __name__ == "__main__":
    unittest.main()
