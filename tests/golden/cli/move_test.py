"""toolpace move and toolpace steps: the figures of the sources, and moves that cannot be made."""

import math
import re
import unittest

from command_line import BAD_INPUT, BAD_USAGE, FINE, CommandLineTest


class Move(CommandLineTest):
    def move(self, **flags):
        arguments = [text for name, value in flags.items() for text in ("--" + name, value)]
        return self.run_toolpace("move", *arguments, "--json")

    def test_the_first_move_of_zheng_reaches_its_feed(self):
        run = self.move(law="five-phase-time", length=4000, feed=100, start=10, end=20, tacc=35, tdec=20)
        self.assertEqual(run.code, FINE, run.err)
        move = run.json()
        self.assertTrue(move["reaches_feed"])
        expected = {"fmax": 100, "sa": 1925, "sb": 1200, "t_acc": 35, "t_cruise": 8.75, "t_dec": 20, "t_total": 63.75,
                    "j_acc": 0.293878, "j_dec": 0.8, "a_peak": 5.142857, "d_peak": 8.0}
        for key, value in expected.items():
            self.assertAlmostEqual(move[key], value, delta=5e-7, msg=key)

    def test_the_second_move_of_zheng_peaks_where_its_own_jerk_says(self):
        # The paper prints fmax = 91.1893, against its own table: (2·4000 − 10·45 − 20·30)/75 = 92.666667.
        move = self.move(law="five-phase-time", length=4000, feed=100, start=10, end=20, tacc=45, tdec=30).json()
        self.assertFalse(move["reaches_feed"])
        expected = {"fmax": 6950 / 75, "sa": 2310, "sb": 1690, "t_cruise": 0, "t_total": 75, "j_acc": 0.163292,
                    "j_dec": 0.322963, "a_peak": 3.674074, "d_peak": 4.844444}
        for key, value in expected.items():
            self.assertAlmostEqual(move[key], value, delta=5e-7, msg=key)

    def test_a_quintic_ramp_keeps_acceleration_and_jerk(self):
        # 0 -> 10 at A = 3000, J = 1e6: jerk decides, T = sqrt(10·10/(sqrt(3)·1e6)).
        move = self.move(law="quintic", length=100, feed=10, start=0, end=0, am=3000, jm=1e6).json()
        self.assertAlmostEqual(move["t_acc"], math.sqrt(100 / (math.sqrt(3) * 1e6)), delta=1e-12)
        self.assertAlmostEqual(move["j_acc"], 1e6, delta=1e-3)

    def test_unbounded_jerk_is_null(self):
        move = self.move(law="trapezoid", length=100, feed=10, start=0, end=0, am=100, jm=1e6).json()
        self.assertIsNone(move["j_acc"])

    def test_an_end_speed_out_of_reach_is_told_with_what_would_do(self):
        run = self.move(law="quintic", length=1, feed=100, start=0, end=100, am=3000, jm=1e6)
        self.expect_failure(run, BAD_INPUT, "mm" if " mm" in run.err else "length")

    def test_a_senseless_number_is_bad_usage_under_a_law_that_does_not_use_it_too(self):
        for law, *more in (("quintic", "--am", "3000", "--jm", "1e6", "--tacc", "nan"), ("quintic", "--am", "3000", "--jm", "1e6", "--tdec", "-1"),
                           ("trapezoid", "--am", "3000", "--jm", "nan"), ("five-phase-time", "--tacc", "35", "--am", "1e40")):
            run = self.run_toolpace("move", "--law", law, "--length", "10", "--feed", "100", *more)
            self.expect_failure(run, BAD_USAGE, "number-out-of-range")
            self.assertIn(more[-2], run.err)

    def test_speeds_above_the_feed_and_senseless_numbers_are_bad_usage(self):
        good = dict(law="quintic", length=10, feed=50, start=0, end=0, am=3000, jm=1e6)
        self.assertEqual(self.move(**good).code, FINE)
        for name, value in (("start", 60), ("end", 60), ("start", -1), ("feed", 0), ("feed", -5), ("length", -1), ("am", 0),
                            ("jm", -1), ("am", "nan"), ("length", "inf"), ("law", "sine")):
            with self.subTest(**{name: value}):
                self.expect_failure(self.move(**{**good, name: value}), BAD_USAGE)
        del good["jm"]
        self.expect_failure(self.move(**good), BAD_USAGE)


class Steps(CommandLineTest):
    def steps(self, *more, steps=1000, speed=2000):
        return self.run_toolpace("steps", "--steps", steps, "--speed", speed, "--tacc-ms", 100, "--tdec-ms", 100,
                                 "--timer-hz", 1e6, *more)

    def test_every_pulse_has_its_ticks(self):
        run = self.steps()
        self.assertEqual(run.code, FINE, run.err)
        header, *rows = run.out.decode().splitlines()
        self.assertEqual(header, "pulse,ticks")
        self.assertEqual([int(row.split(",")[0]) for row in rows], list(range(1, 1001)))
        # 1000 steps at 2000/s with two ramps of 0.1 s, each at half the speed in the mean: 0.5 + 0.1 s.
        self.assertAlmostEqual(sum(int(row.split(",")[1]) for row in rows), 600000, delta=1)

    def test_the_c_table_holds_the_same_intervals(self):
        csv = [row.split(",")[1] for row in self.steps().out.decode().splitlines()[1:]]
        c = self.steps("--format", "c").out.decode()
        self.assertTrue(re.findall(r"(\d+)U,", c) == csv, "the tables differ")
        self.assertIn("#define PULSE_COUNT 1000UL", c)

    def test_senseless_numbers_are_bad_usage(self):
        for steps, speed in ((0, 100), (-5, 100), (10, 0), (10, -3), ("many", 100), (10, "nan")):
            with self.subTest(steps=steps, speed=speed):
                self.expect_failure(self.steps(steps=steps, speed=speed), BAD_USAGE)


if __name__ == "__main__":
    unittest.main()
