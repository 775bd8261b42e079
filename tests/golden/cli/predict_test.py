"""predict, as its users meet it: times, limits, what-if, settings that are not what they should be."""

import unittest

from command_line import BAD_INPUT, BAD_USAGE, FILE_TROUBLE, FINE, SOURCE_DIR, CommandLineTest

DATA = SOURCE_DIR / "tests" / "data" / "controllers"
GRBL, KLIPPER = DATA / "settings" / "grbl_g1.txt", DATA / "settings" / "klipper_k1.cfg"
SQUARE = DATA / "programs" / "peer_square.ngc"


class Predict(CommandLineTest):
    def predict(self, *arguments):
        run = self.run_toolpace("predict", *arguments, "--json")
        self.assertEqual(run.code, FINE, run.err)
        return run.json()

    def test_a_prediction_is_one_object_whose_times_add_up(self):
        told = self.predict(SQUARE, "--settings", GRBL)
        for key in ("controller", "cycle_time_s", "feed_time_s", "rapid_time_s", "dwell_time_s", "blocks", "starved_s",
                    "time_by_limit_s", "what_if", "warnings", "settings"):
            self.assertIn(key, told)
        self.assertEqual(told["controller"], "grbl")
        self.assertAlmostEqual(told["cycle_time_s"], 11.231347, delta=0.0112)  # measured on grbl itself
        self.assertAlmostEqual(sum(told["time_by_limit_s"].values()), told["cycle_time_s"], places=9)
        self.assertEqual(told["starved_s"], 0)

    def test_what_if_is_ranked_and_ends_with_our_own_setpoints(self):
        rows = self.predict(SQUARE, "--settings", GRBL)["what_if"]
        times = [row["cycle_time_s"] for row in rows[:-1]]
        self.assertEqual(times, sorted(times))
        tried = {(row["setting"], row["to"]) for row in rows}
        for setting, value in (("$120", 330), ("$120", 270), ("$120", 400), ("$110", 5500), ("$11", 0.012), ("$1", 255)):
            self.assertTrue(any(s == setting and v is not None and abs(v - value) < 1e-9 for s, v in tried), setting)
        self.assertEqual((rows[-1]["setting"], rows[-1]["from"], rows[-1]["to"]),
                         ("Toolpace's setpoints on the same limits", None, None))
        # A row is what a file with that value gives.
        best = rows[0]
        text = GRBL.read_text().replace(f"{best['setting']}={best['from']:.3f}", f"{best['setting']}={best['to']}")
        self.assertNotEqual(text, GRBL.read_text())
        again = self.predict(SQUARE, "--settings", self.file("better.txt", text), "--no-what-if")
        self.assertAlmostEqual(again["cycle_time_s"], best["cycle_time_s"], places=9)

    def test_the_controller_may_be_named_where_the_settings_leave_it_open(self):
        self.assertEqual(self.predict(SQUARE, "--settings", GRBL, "--controller", "grblhal")["controller"], "grblhal")
        run = self.run_toolpace("predict", SQUARE, "--settings", KLIPPER, "--controller", "grbl", "--json")
        self.expect_failure(run, BAD_USAGE, "settings of Klipper, not of grbl", "settings-foreign")
        run = self.run_toolpace("predict", SQUARE, "--settings", GRBL, "--controller", "mach4", "--json")
        self.expect_failure(run, BAD_USAGE, "mach4", "grblhal")

    def test_a_slow_link_starves(self):
        told = self.predict(DATA / "programs" / "own_micro_002.ngc", "--settings", GRBL, "--baud", "19200", "--no-what-if")
        self.assertGreater(told["starved_s"], 5)
        self.assertGreater(told["time_by_limit_s"]["link"], 5)
        for value in ("0", "-1", "inf"):
            run = self.run_toolpace("predict", SQUARE, "--settings", GRBL, "--baud", value)
            self.expect_failure(run, BAD_USAGE, "--baud")

    def test_a_default_may_be_given_as_a_flag(self):
        told = self.predict(SQUARE, "--settings", GRBL, "--block-time-ms", "0", "--no-what-if")
        self.assertEqual(told["cycle_time_s"], self.predict(SQUARE, "--settings", GRBL, "--no-what-if")["cycle_time_s"])
        run = self.run_toolpace("predict", SQUARE, "--settings", GRBL, "--block-time-ms", "-1")
        self.expect_failure(run, BAD_USAGE, "--block-time-ms is -1, but it must be at least 0")

    def test_what_the_controller_drives_too_fast_is_told_with_its_line(self):
        program = self.file("arc.nc", "G21 G90 G17 G0 X0 Y0\nG1 X30 F6000\nG3 X30 Y0 I0 J2\nM2\n")
        told = self.predict(program, "--settings", GRBL)["over_limits"]
        self.assertEqual({(row["axis"], row["quantity"], row["line"]) for row in told},
                         {("X", "acceleration", 3), ("Y", "acceleration", 3)})
        for row in told:
            self.assertGreater(row["value"], 2 * row["limit"])
        run = self.run_toolpace("predict", program, "--settings", GRBL)
        self.assertIn(b"times its limit, at line 3", run.out)
        self.assertIsNone(self.predict(program, "--settings", GRBL, "--no-what-if")["over_limits"])

    def test_people_are_told_the_same(self):
        run = self.run_toolpace("predict", SQUARE, "--settings", GRBL)
        self.assertEqual(run.code, FINE, run.err)
        for word in (b"grbl", b"cycle time   11.23", b"corner", b"what if", b"as setpoints"):
            self.assertIn(word, run.out)

    def test_a_program_comes_by_standard_input_too(self):
        run = self.run_toolpace("predict", "-", "--settings", GRBL, "--no-what-if", "--json", stdin=SQUARE.read_bytes())
        self.assertEqual(run.code, FINE, run.err)
        self.assertEqual(run.json()["blocks"], 24)

    def test_a_program_with_errors_is_predicted_up_to_the_first(self):
        program = self.file("bad.nc", "G21 G90\nG1 X10 F600\nG2 X20 Y20 R1\nG1 X30\n")
        run = self.run_toolpace("predict", program, "--settings", GRBL, "--json", "--no-what-if")
        self.assertEqual(run.code, BAD_INPUT, run.err)
        told = run.json()
        self.assertTrue(told["refused"])
        self.assertEqual(told["blocks"], 1)
        self.assertEqual(told["warnings"][0]["line"], 3)

    def test_what_grbl_refuses_is_told_by_its_numbers(self):
        program = self.file("odd.nc", "G21 G90\nG1 X5 F600\nM77\nG1 X6 Q4\nG81 X1 Z-1 R1\nG1 G2 X7\n")
        run = self.run_toolpace("predict", program, "--settings", GRBL, "--json", "--no-what-if")
        self.assertEqual(run.code, BAD_INPUT, run.err)
        self.assertEqual([(r["line"], r["code"]) for r in run.json()["refusals"]],
                         [(3, "error:20"), (4, "error:36"), (5, "error:20"), (6, "error:21")])
        run = self.run_toolpace("predict", program, "--settings", GRBL, "--no-what-if")
        self.assertIn(b"line 6: error:21 (more than one g-code command", run.out)
        clean = self.predict(SQUARE, "--settings", GRBL, "--no-what-if")
        self.assertEqual(clean["refusals"], [])

    def test_files_that_are_not_there_or_no_settings(self):
        self.expect_failure(self.run_toolpace("predict", SQUARE, "--settings", "none.txt"), FILE_TROUBLE, "none.txt")
        self.expect_failure(self.run_toolpace("predict", "none.ngc", "--settings", GRBL), FILE_TROUBLE, "none.ngc")
        note = self.file("note.txt", "buy milk\n")
        self.expect_failure(self.run_toolpace("predict", SQUARE, "--settings", note), BAD_USAGE, "settings-unknown")
        self.expect_failure(self.run_toolpace("predict", SQUARE), BAD_USAGE, "--settings")


if __name__ == "__main__":
    unittest.main()
