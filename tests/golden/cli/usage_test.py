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

    def test_limits_that_make_no_sense_are_refused(self):
        program = self.file("a.ngc", LINE)
        for flag in ("--vmax", "--am", "--dm", "--jm", "--jd", "--period-ms"):
            for value in ("0", "-1", "nan", "ten", ""):
                with self.subTest(flag=flag, value=value):
                    run = self.run_toolpace("plan", program, f"{flag}={value}", "--setpoints", "out.csv")
                    self.expect_failure(run, BAD_USAGE, flag)
                    self.assertFalse((self.folder / "out.csv").exists())

    def test_options_out_of_range_are_refused(self):
        program = self.file("a.ngc", LINE)
        for flag, value in (("--lookahead", "0"), ("--lookahead", "-3"), ("--lookahead", "some"), ("--law", "sine"),
                            ("--ramps", "none"), ("--corner", "sharp"), ("--tacc-ms", "-1"), ("--tolerance-mm", "-0.01"),
                            ("--override-percent", "-5"), ("--junction-deviation-mm", "nan")):
            with self.subTest(flag=flag, value=value):
                self.expect_failure(self.run_toolpace("plan", program, f"{flag}={value}"), BAD_USAGE, flag)


if __name__ == "__main__":
    unittest.main()
