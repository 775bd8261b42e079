"""Flags and limits that make no sense end with exit code 2 and say so; help and version end with 0."""

import re
import unittest

from command_line import BAD_INPUT, BAD_USAGE, FINE, SOURCE_DIR, CommandLineTest

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
        self.expect_failure(self.run_toolpace("blocks", program, program), BAD_USAGE, "one argument too many")

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

    def test_a_flag_with_nothing_behind_its_equals_sign_does_not_take_the_next_word(self):
        program = self.file("a.ngc", LINE)
        for words in (("--am=", "5"), ("--am=", program), ("--am=", "--jm=5"), ("--am=",), ("--law=", "quintic"), ("--json=", program),
                      ("--sub-path=", ".")):
            with self.subTest(words=words):
                run = self.run_toolpace("plan", program, *words)
                self.expect_failure(run, BAD_USAGE, words[0][:-1] + " is empty", "right behind the =")

    def test_behind_two_dashes_there_are_no_flags(self):
        program = self.file("a.ngc", LINE)
        for word in ("--csv=", "--csv", "--strict"):
            self.expect_failure(self.run_toolpace("blocks", program, "--", word), BAD_USAGE, f"'{word}' is one argument too many")

    def test_the_fuzzer_of_command_lines_knows_every_command_and_flag(self):
        known = re.findall(r'^"(.*)"$', (SOURCE_DIR / "tests" / "fuzz" / "command_line.dict").read_text(), re.MULTILINE)
        commands = re.findall(r"^  (\w+) ", self.run_toolpace("--help").out.decode().split("ommands:\n")[1], re.MULTILINE)
        self.assertIn("plan", commands)
        for command in commands:
            flags = re.findall(r"^  (?:-\w,)?(--[\w-]+)", self.run_toolpace(command, "--help").out.decode(), re.MULTILINE)
            self.assertGreater(len(flags), 3, command)
            self.assertEqual(set(flags) - set(known), set())
        self.assertEqual(set(commands) - set(known), set())

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

    def test_numbers_at_the_ends_of_what_numbers_hold_are_done_or_refused_with_their_bounds(self):
        # Besides the flags of machines and plans, whose bounds are those of the machine file's keys.
        commands = {"steps": {"--steps": "1000", "--speed": "2000", "--tacc-ms": "100", "--tdec-ms": "100", "--timer-hz": "1e6"},
                    "move": {"--law": "quintic", "--length": "10", "--feed": "100", "--start": "0", "--end": "0", "--am": "3000",
                             "--dm": "3000", "--jm": "1e6", "--jd": "1e6"}}
        for command, flags in commands.items():
            for flag in flags:
                if flag == "--law":
                    continue
                for value in ("0", "-1", "1e-310", "5e-324", "1e-30", "1e15", "1e30", "1e300", "nan", "-inf", "inf", "word", "1e999"):
                    with self.subTest(command=command, flag=flag, value=value):
                        given = {**flags, flag: value}
                        run = self.run_toolpace(command, *(f"{name}={number}" for name, number in given.items()))
                        self.assertIn(run.code, (FINE, BAD_USAGE, BAD_INPUT), run.err)
                        self.assertNotIn("internal", run.err)
                        self.assertNotIn(b"nan", run.out)
                        if run.code == BAD_USAGE and "[timer-too-" not in run.err:  # those are of several flags together
                            self.assertIn(flag, run.err)
                        if run.code != FINE:
                            self.assertRegex(run.err, r"between .* and|from 0 to|at least|above the feed|slower|faster")

    def test_counts_are_bounded(self):
        program = self.file("a.ngc", LINE)
        most = "1000000000000000"
        self.assertEqual(self.run_toolpace("plan", program, "--max-blocks", most, "--max-lines", most).code, FINE)
        self.expect_failure(self.run_toolpace("plan", program, "--max-blocks", most + "0"), BAD_USAGE, "--max-blocks", most)

    def test_the_clock_of_pulses_is_asked_for_before_anything_is_planned(self):
        program = self.file("a.ngc", "this is no program\n")
        for clock in ([], ["--timer-hz", "0"], ["--timer-hz", "1e300"], ["--timer-hz", "1e-310"]):
            run = self.run_toolpace("plan", program, "--setpoints", "a.pulses.csv", *clock)
            self.expect_failure(run, BAD_USAGE, "between 1 Hz and 1e12 Hz")

    def test_options_out_of_range_are_refused(self):
        program = self.file("a.ngc", LINE)
        for flag, value in (("--lookahead", "0"), ("--lookahead", "-3"), ("--lookahead", "some"), ("--law", "sine"),
                            ("--ramps", "none"), ("--corner", "sharp"), ("--tacc-ms", "-1"), ("--tolerance-mm", "-0.01"),
                            ("--override-percent", "-5"), ("--junction-deviation-mm", "nan")):
            with self.subTest(flag=flag, value=value):
                self.expect_failure(self.run_toolpace("plan", program, f"{flag}={value}"), BAD_USAGE, flag)

    def test_a_refused_value_is_told_with_its_flag_whatever_it_clashes_with(self):
        program = self.file("a.ngc", LINE.replace("M2", "G0 Y5\nM2"))  # a rapid has no feed to bound it
        machine = self.file("steps.toml", "[path]\nmax_speed_mm_s = 100\nmax_acceleration_mm_s2 = 1000\nmax_jerk_mm_s3 = 1e5\n"
                            "[axes.X]\nsteps_per_mm = 100\n")
        steps = {"--steps": "1000", "--speed": "1000", "--tacc-ms": "100", "--tdec-ms": "100", "--timer-hz": "1e6"}
        pulses = ["plan", program, "--machine", machine, "--setpoints", "a.pulses.csv"]
        clashes = [(["plan", program], flag, "inf", BAD_USAGE) for flag in ("--vmax", "--am", "--dm", "--jm", "--jd")]
        clashes += [(["plan", program], "--hold-at-s", "12345", BAD_INPUT),
                    (["plan", program, "--corner", "smooth"], "--hold-at-s", "12345", BAD_INPUT),
                    (pulses, "--timer-hz", "10", BAD_USAGE), (pulses, "--timer-hz", "0", BAD_USAGE)]
        clashes += [(["steps"], flag, value, BAD_USAGE) for flag, value in
                    (("--timer-hz", "10"), ("--timer-hz", "1e+17"), ("--speed", "1e-07"), ("--tacc-ms", "1e+20"), ("--tdec-ms", "1e+20"))]
        clashes += [(["verify", "a.csv", "--machine", machine], "--tolerance-mm", value, BAD_USAGE) for value in ("-1", "nan", "-inf")]
        for command, flag, value, code in clashes:
            given = {**steps, flag: value} if command == ["steps"] else {flag: value}
            with self.subTest(command=command[:1], flag=flag, value=value):
                run = self.run_toolpace(*command, *(f"{f}={v}" for f, v in given.items()))
                self.expect_failure(run, code, flag, value)


if __name__ == "__main__":
    unittest.main()
