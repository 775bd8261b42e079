"""Bad input: a clear message with its place, the exit code of the contract, and nothing written."""

import unittest

from command_line import BAD_INPUT, BAD_USAGE, FILE_TROUBLE, CommandLineTest


class BadInput(CommandLineTest):
    def refuse(self, name, code, *said):
        """No command that reads programs accepts the file `name`; a plan leaves the output as it was."""
        self.file("out.csv", "as it was\n")
        before = sorted(self.folder.iterdir())
        run = self.run_toolpace("plan", name, "--setpoints", "out.csv")
        self.expect_failure(run, code, *said)
        self.assertEqual((self.folder / "out.csv").read_text(), "as it was\n")
        self.assertEqual(sorted(self.folder.iterdir()), before)
        run = self.run_toolpace("blocks", name)
        self.assertEqual(run.code, code, run.err)
        for text in said:
            self.assertIn(text, run.err)

    def test_a_missing_file(self):
        self.refuse("nowhere.ngc", FILE_TROUBLE, "nowhere.ngc")

    def test_a_folder(self):
        (self.folder / "folder.ngc").mkdir()
        self.refuse("folder.ngc", FILE_TROUBLE, "folder.ngc")

    def test_an_unreadable_place(self):
        self.refuse("/proc/self/mem", FILE_TROUBLE, "/proc/self/mem")

    def test_a_binary_file(self):
        self.refuse(self.file("binary.ngc", bytes(range(256)) * 64), BAD_INPUT, "binary.ngc")
        self.refuse(self.file("binary.csv", bytes(range(256)) * 64), BAD_INPUT, "binary.csv")

    def test_an_empty_file(self):
        self.refuse(self.file("empty.ngc", ""), BAD_INPUT, "empty.ngc")
        self.refuse(self.file("empty.csv", ""), BAD_INPUT, "empty.csv")

    def test_a_polyline_without_points(self):
        self.refuse(self.file("header.csv", "x_mm,y_mm,z_mm,feed_mm_min\n"), BAD_INPUT, "header.csv")

    def test_numbers_that_are_none(self):
        for number in ("nan", "inf", "1e400", "1.2.3", "0x10", "1,5"):
            with self.subTest(number=number):
                self.refuse(self.file("bad.ngc", f"G21 G90 G94\nG1 X{number} F600\nM2\n"), BAD_INPUT, "bad.ngc:2:")
        for number in ("nan", "inf", "1e400", "-1e999", "abc", ""):
            with self.subTest(number=number):
                self.refuse(self.file("bad.csv", f"x_mm,y_mm,z_mm,feed_mm_min\n0,0,0,600\n1,{number},0,600\n"), BAD_INPUT,
                            "bad.csv:3:")

    def test_a_line_of_ten_megabytes(self):
        self.refuse(self.file("long.ngc", "G21 G90\nG1 " + "X1 " * 3_500_000 + "F100\nM2\n"), BAD_INPUT, "long.ngc:2:")
        self.refuse(self.file("long.csv", "x_mm,y_mm\n0,0\n" + "1," * 5_000_000 + "\n"), BAD_INPUT, "long.csv:3:")

    def test_a_feed_move_without_feed(self):
        self.refuse(self.file("nofeed.ngc", "G21 G90 G94\nG1 X10\nM2\n"), BAD_INPUT, "nofeed.ngc:2:")

    def test_a_motion_that_would_take_years(self):
        for name, text in (("dwell.ngc", "G4 P999999999\nM2\n"), ("slow.ngc", "G21 G90 F0.00001\nG1 X100\nM2\n")):
            self.file("out.csv", "as it was\n")
            run = self.run_toolpace("plan", self.file(name, text), "--setpoints", "out.csv")
            self.expect_failure(run, BAD_INPUT, "motion-too-long", "days")
            self.assertEqual((self.folder / "out.csv").read_text(), "as it was\n")

    def test_a_radius_that_is_too_small(self):
        self.refuse(self.file("radius.ngc", "G21 G90 G94 F600\nG0 X0 Y0\nG2 X20 Y0 R5\nM2\n"), BAD_INPUT, "radius.ngc:3:")

    def test_a_program_with_a_negative_or_zero_feed(self):
        for feed in ("0", "-100"):
            with self.subTest(feed=feed):
                self.refuse(self.file("feed.ngc", f"G21 G90 G94\nG1 X10 F{feed}\nM2\n"), BAD_INPUT, "feed.ngc:2:")
                self.refuse(self.file("feed.csv", f"x_mm,y_mm,feed_mm_min\n0,0,600\n10,0,{feed}\n"), BAD_INPUT, "feed.csv:3:")

    def test_every_problem_of_a_program_is_told(self):
        name = self.file("many.ngc", "G21 G90 G94 F600\nG1 X10 Q\nG1 X[1 F2\nG999\nM2\n")
        run = self.run_toolpace("plan", name)
        self.expect_failure(run, BAD_INPUT, "many.ngc:2:", "many.ngc:3:", "many.ngc:4:")

    def test_json_tells_every_problem_of_a_program(self):
        name = self.file("many.ngc", "G21 G90 G94 F600\nG1 X10 Q\nG1 X[1 F2\nG999\nM2\n")
        for command in ("plan", "simulate"):
            run = self.run_toolpace(command, name, "--json")
            self.expect_failure(run, BAD_INPUT, "many.ngc:2:")
            self.assertEqual([d["line"] for d in run.json()["diagnostics"]], [2, 3, 4])
            self.assertEqual(run.json()["error"]["code"], "program-refused")

    def test_json_is_printed_for_files_and_flags_that_are_wrong_too(self):
        name = self.file("a.ngc", "G21 G90 G94\nG1 X10 F3000\nM2\n")
        run = self.run_toolpace("plan", "nowhere.ngc", "--json")
        self.expect_failure(run, FILE_TROUBLE, "nowhere.ngc")
        self.assertEqual(run.json()["error"]["file"], "nowhere.ngc")
        self.expect_failure(self.run_toolpace("plan", name, "--jm", "x", "--json"), BAD_USAGE, "--jm")
        self.expect_failure(self.run_toolpace("plan", name, "--json", "--setpoints", "-"), BAD_USAGE, "--setpoints")

    def test_files_beside_a_program_that_are_not_there(self):
        name = self.file("a.ngc", "G21 G90 G94\nG1 X10 F3000\nM2\n")
        for flag in ("--tools", "--parameters", "--sub-path", "--machine"):
            self.expect_failure(self.run_toolpace("plan", name, flag, "nowhere"), FILE_TROUBLE, "nowhere")

    def test_a_message_says_what_to_do(self):
        run = self.run_toolpace("plan", self.file("nofeed.ngc", "G21 G90 G94\nG1 X10\nM2\n"))
        self.expect_failure(run, BAD_INPUT, "error:")
        self.assertGreaterEqual(len(run.err.strip().splitlines()), 2, "message and remedy: " + run.err)


class BadMachine(CommandLineTest):
    def refuse(self, toml, *said):
        machine = self.file("machine.toml", toml)
        program = self.file("a.ngc", "G21 G90 G94\nG1 X10 F3000\nM2\n")
        run = self.run_toolpace("plan", program, "--machine", machine, "--setpoints", "out.csv")
        self.assertIn(run.code, (BAD_USAGE, BAD_INPUT), run.err)
        for text in said:
            self.assertIn(text, run.err)
        self.assertEqual(run.out, b"")
        self.assertFalse((self.folder / "out.csv").exists())

    def test_a_missing_machine(self):
        run = self.run_toolpace("plan", self.file("a.ngc", "G1 X1 F100\nM2\n"), "--machine", "nowhere.toml")
        self.expect_failure(run, FILE_TROUBLE, "nowhere.toml")

    def test_a_file_that_is_no_toml(self):
        self.refuse("[path\nmax_speed_mm_s = 1\n", "machine.toml:")

    def test_an_unknown_key_names_the_nearest_known_one(self):
        self.refuse("[path]\nmax_sped_mm_s = 100.0\n", "max_sped_mm_s", "max_speed_mm_s", "machine.toml:2")

    def test_a_key_outside_of_its_section_is_sent_there(self):
        self.refuse("max_speed_mm_s = 100.0\n", "max_speed_mm_s", "[path]", "machine.toml:1")

    def test_a_file_without_end(self):
        self.refuse("# " + "x" * (1 << 20) + "\n", "1 MiB")

    def test_a_machine_comes_from_standard_input_too(self):
        program = self.file("a.ngc", "G21 G90 G94\nG1 X10 F3000\nM2\n")
        toml = b"[path]\nmax_speed_mm_s = 10.0\nmax_acceleration_mm_s2 = 1000.0\nmax_jerk_mm_s3 = 1e5\n"
        run = self.run_toolpace("plan", program, "--machine", "-", "--json", stdin=toml)
        self.assertEqual((run.code, run.json()["max_speed_mm_s"]), (0, 10.0), run.err)

    def test_limits_that_make_no_sense(self):
        for value in ("0", "-5.0", "nan", '"fast"', "true"):
            with self.subTest(value=value):
                self.refuse(f"[path]\nmax_speed_mm_s = {value}\nmax_acceleration_mm_s2 = 100.0\n", "max_speed_mm_s")
        self.refuse("[machine]\nperiod_ms = 0\n[path]\nmax_speed_mm_s = 1.0\nmax_acceleration_mm_s2 = 9.0\n", "period_ms")

    def test_a_travel_that_is_turned_round(self):
        self.refuse("[axes.X]\ntravel_mm = [10.0, -10.0]\n", "travel_mm")

    def test_no_speed_or_acceleration_limit_anywhere(self):
        machine = self.file("free.toml", '[machine]\nname = "free"\n')
        program = self.file("a.csv", "x_mm\n0\n10\n")
        self.expect_failure(self.run_toolpace("plan", program, "--machine", machine), BAD_USAGE)


if __name__ == "__main__":
    unittest.main()
