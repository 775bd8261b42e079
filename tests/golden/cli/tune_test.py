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


    def test_settings_of_a_controller_come_back_as_its_own_lines(self):
        dump = "$0=10\n$11=0.010\n$100=250\n$101=250\n$102=250\n$110=3000\n$111=3000\n$112=1500\n$120=200\n$121=200\n$122=50\n"
        self.file("grbl.txt", dump)
        self.file("mill.toml", "".join(f"[axes.{a}]\nmax_speed_mm_s = 60\nmax_acceleration_mm_s2 = {n}\n" for a, n in
                                       (("X", 800), ("Y", 600), ("Z", 100))))
        tune = ("tune", "a.ngc", "--settings", "grbl.txt")
        run = self.run_toolpace(*tune, "--machine", "mill.toml", "-o", "better.txt", "--json")
        self.assertEqual(run.code, FINE, run.err)
        told = run.json()
        self.assertLess(told["cycle_time_after_s"], told["cycle_time_before_s"])
        self.assertEqual(set(told["lines"]), set((self.folder / "better.txt").read_text().splitlines()) - set(dump.splitlines()))
        values = {c["setting"]: c["to"] for c in told["changes"]}
        self.assertEqual(values["$120"], 800)
        self.assertEqual(values["$121"], 600)
        self.assertNotIn("$122", values)  # Z does not move: it helps nothing
        for file, key in (("grbl.txt", "cycle_time_before_s"), ("better.txt", "cycle_time_after_s")):
            predicted = self.run_toolpace("predict", "a.ngc", "--settings", file, "--no-what-if", "--json").json()
            self.assertEqual(predicted["cycle_time_s"], told[key])
        kept = self.run_toolpace(*tune, "--json").json()  # without a machine nothing goes beyond what it has
        self.assertFalse([c for c in kept["changes"] if c["setting"].startswith("$1") and c["to"] > c["from"]])
        self.assertIn(b"$120=800", self.run_toolpace(*tune, "--machine", "mill.toml").out)
        self.expect_failure(self.run_toolpace(*tune, "--vary", "am"), BAD_USAGE, "--settings")

    def test_a_page_shows_before_and_after(self):
        told = self.tune("--plans", 12, "--report", "page.html")
        page = (self.folder / "page.html").read_text()
        for text in (f'{told["present"]["cycle_time_s"]:.4f} s', f'{told["best"]["cycle_time_s"]:.4f} s', "What was changed", "<svg"):
            self.assertIn(text, page)
        for flag in told["best"]["settings"]:
            self.assertIn(flag[2:], page)


if __name__ == "__main__":
    unittest.main()
