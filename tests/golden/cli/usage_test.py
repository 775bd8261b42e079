"""Flags and limits that make no sense end with exit code 2 and say so; help and version end with 0."""

import unittest

from command_line import BAD_USAGE, FINE, CommandLineTest

LINE = "G21 G90 G94\nG1 X10 F3000\nM2\n"


class Usage(CommandLineTest):
    def test_help_and_version_go_to_standard_output(self):
        for flag in ("--help", "--version"):
            run = self.run_toolpace(flag)
            self.assertEqual((run.code, run.err), (FINE, ""))
            self.assertIn(b"toolpace", run.out)

    def test_no_command_an_unknown_command_and_an_unknown_flag_are_refused(self):
        for arguments in ((), ("plam", "a.ngc"), ("plan", self.file("a.ngc", LINE), "--look-ahead", "3")):
            run = self.run_toolpace(*arguments)
            self.assertEqual(run.code, BAD_USAGE, arguments)
            self.assertEqual(run.out, b"")
            self.assertNotEqual(run.err, "")

    def test_the_nearest_flag_and_command_are_named(self):
        program = self.file("a.ngc", LINE)
        for arguments, nearest in ((("plam", program), "plan"), (("plan", program, "--look-ahead", "3"), "--lookahead"),
                                   (("plan", "--setpoint=a.csv", program), "--setpoints"), (("blocks", program, "--jsn"), "--json")):
            with self.subTest(arguments=arguments):
                self.expect_failure(self.run_toolpace(*arguments), BAD_USAGE, f"did you mean {nearest}?")
        self.expect_failure(self.run_toolpace("plan", program, program), BAD_USAGE, "one argument too many")

    def test_numbers_that_count_are_not_negative(self):
        program = self.file("a.ngc", LINE)
        for flag in ("--max-blocks", "--max-lines", "--max-loop-turns", "--max-call-depth"):
            self.expect_failure(self.run_toolpace("blocks", program, flag, "-1"), BAD_USAGE, flag)
        self.expect_failure(self.run_toolpace("steps", "--steps", "-1", "--speed", "100", "--tacc-ms", "1", "--tdec-ms", "1",
                                              "--timer-hz", "1e6"), BAD_USAGE, "--steps")
        for flag, value in (("--max-blocks", "99999999999999999999"), ("--max-lines", "1e6"), ("--max-call-depth", "1.5")):
            self.expect_failure(self.run_toolpace("blocks", program, flag, value), BAD_USAGE, flag, value)

    def test_a_flag_given_twice_or_without_its_value_is_refused(self):
        program = self.file("a.ngc", LINE)
        self.expect_failure(self.run_toolpace("plan", program, "--am", "1", "--am", "2"), BAD_USAGE, "--am", "more than once")
        self.expect_failure(self.run_toolpace("plan", program, "--am"), BAD_USAGE, "--am needs a value")

    def test_an_empty_name_is_no_name(self):
        program = self.file("a.ngc", LINE)
        for flag in ("--machine", "--setpoints", "--law", "--corner", "--ramps", "--lookahead", "--dialect", "--tools"):
            self.expect_failure(self.run_toolpace("plan", program, flag, ""), BAD_USAGE, flag)

    def test_only_what_is_near_is_suggested(self):
        program = self.file("a.ngc", LINE)
        for arguments in (("xyzzy",), ("plan", program, "--frobnicate")):
            run = self.run_toolpace(*arguments)
            self.expect_failure(run, BAD_USAGE, "--help")
            self.assertNotIn("did you mean", run.err)

    def test_a_number_is_read_to_its_last_letter(self):
        program = self.file("a.ngc", LINE)
        for value in ("3e3x", "0x10", "1,5", "1 2", "--", "1e999"):
            self.expect_failure(self.run_toolpace("plan", program, "--am=" + value), BAD_USAGE, "--am", value)
        self.assertEqual(self.run_toolpace("plan", program, "--am=+3e3").code, FINE)

    def test_a_period_that_no_disk_could_hold_is_refused(self):
        self.expect_failure(self.run_toolpace("plan", self.file("a.ngc", LINE), "--period-ms", "1e-9"), BAD_USAGE, "period")

    def test_limits_that_make_no_sense_are_refused(self):
        program = self.file("a.ngc", LINE)
        for flag in ("--vmax", "--am", "--dm", "--jm", "--jd", "--period-ms"):
            for value in ("0", "-1", "nan", "ten", ""):
                with self.subTest(flag=flag, value=value):
                    run = self.run_toolpace("plan", program, f"{flag}={value}", "--setpoints", "out.csv")
                    self.expect_failure(run, BAD_USAGE, flag)
                    self.assertFalse((self.folder / "out.csv").exists())

    def test_drives_and_traces_that_make_no_sense_are_refused(self):
        program = self.file("a.ngc", LINE)
        for flag, value in (("--kv-1-s", "0"), ("--velocity-feed-forward", "1.5"), ("--acceleration-feed-forward", "-0.1"),
                            ("--trace", "trace.npy")):
            self.expect_failure(self.run_toolpace("simulate", program, flag, value), BAD_USAGE)
        self.assertEqual([path.name for path in self.folder.iterdir()], [program])

    def test_senseless_ramp_times_are_named_with_their_flag(self):
        self.expect_failure(self.run_toolpace("steps", "--steps", "5", "--speed", "100", "--tacc-ms", "-1", "--tdec-ms", "1",
                                              "--timer-hz", "1e6"), BAD_USAGE, "--tacc-ms -1")

    def test_options_out_of_range_are_refused(self):
        program = self.file("a.ngc", LINE)
        for flag, value in (("--lookahead", "0"), ("--lookahead", "-3"), ("--lookahead", "some"), ("--law", "sine"),
                            ("--ramps", "none"), ("--corner", "sharp"), ("--tacc-ms", "-1"), ("--tolerance-mm", "-0.01"),
                            ("--override-percent", "-5"), ("--junction-deviation-mm", "nan")):
            with self.subTest(flag=flag, value=value):
                self.expect_failure(self.run_toolpace("plan", program, f"{flag}={value}"), BAD_USAGE, flag)


if __name__ == "__main__":
    unittest.main()
