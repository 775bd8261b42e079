"""rewrite, as its users meet it: the program again, shorter, proven; never slower on the controller that it is for."""

import math
import unittest

from command_line import BAD_INPUT, BAD_USAGE, FILE_TROUBLE, FINE, SOURCE_DIR, CommandLineTest

SETTINGS = SOURCE_DIR / "tests" / "data" / "controllers" / "settings"
PEERS = SOURCE_DIR.parent / "shared" / "peer-programs"
HEAD = "(a part)\nG21 G90 G94\nG0 X20 Y0\nM3 S8000\nG1 F1200\n"
TAIL = "M5 (rest)\nG0 Z5\nM2\n"


def chords(count=400, radius=20.0):
    return "".join(f"X{radius * math.cos(a):.4f} Y{radius * math.sin(a):.4f}\n"
                   for a in (2 * math.pi * k / count for k in range(1, count + 1)))


class Rewrite(CommandLineTest):
    def rewrite(self, program, *arguments):
        run = self.run_toolpace("rewrite", program, "-o", "out.ngc", *arguments, "--json")
        self.assertEqual(run.code, FINE, run.err)
        return run.json(), (self.folder / "out.ngc").read_text()

    def test_a_circle_of_chords_becomes_an_arc(self):
        told, text = self.rewrite(self.file("a.ngc", HEAD + chords() + TAIL))
        # Chords of 0.314 mm lie inside by 0.314²/(8·20) = 0.0006 mm; the centre may even that out.
        self.assertEqual(text.splitlines()[-4][:12], "G3 X20 Y0 I-")
        self.assertEqual((text[:len(HEAD)], text[-len(TAIL):]), (HEAD, TAIL))
        self.assertEqual((told["blocks_in"], told["blocks_out"]), (403, 4))
        self.assertEqual((told["bytes_in"], told["bytes_out"]), (len(HEAD + chords() + TAIL), len(text)))
        self.assertLess(told["max_deviation_mm"], 0.001)
        self.assertLess(told["cycle_time_out_s"], told["cycle_time_in_s"] * 1.001)

    def test_what_was_written_is_planned_and_written_again_unchanged(self):
        _, text = self.rewrite(self.file("a.ngc", HEAD + chords() + TAIL))
        self.assertEqual(self.run_toolpace("plan", "out.ngc").code, FINE)
        (self.folder / "once.ngc").write_text(text)
        self.assertEqual(self.rewrite("once.ngc")[1], text)

    def test_lines_are_within_the_tolerance_too(self):
        told, text = self.rewrite(self.file("a.ngc", HEAD + chords() + TAIL), "--fit", "lines", "--tolerance-mm", "0.02")
        self.assertNotIn("G3", text)
        self.assertLess(told["blocks_out"], 90)
        self.assertLessEqual(told["max_deviation_mm"], 0.02)

    def test_the_controller_is_never_slower(self):
        program = self.file("a.ngc", HEAD + chords(150, 3.0) + TAIL)
        for settings in ("grbl_g1.txt", "grblhal_g3.txt", "klipper_k1.cfg", "linuxcnc_L3.ini"):
            told, text = self.rewrite(program, "--settings", SETTINGS / settings)
            self.assertLessEqual(told["cycle_time_out_s"], told["cycle_time_in_s"] * (1 + 1e-9), settings)
            for name, key in ((program, "cycle_time_in_s"), ("out.ngc", "cycle_time_out_s")):
                run = self.run_toolpace("predict", name, "--settings", SETTINGS / settings, "--no-what-if", "--json")
                self.assertAlmostEqual(run.json()["cycle_time_s"], told[key], places=9, msg=settings)

    def test_clouds_of_chords_lose_most_of_their_blocks(self):
        if not PEERS.is_dir():
            self.skipTest(f"no programs of other planners in {PEERS}")
        for name, most in (("circle_chords", 5), ("cam_noise", 355), ("micro_spiral", 1600), ("lissajous3d", 1200)):
            told, _ = self.rewrite(PEERS / f"{name}.ngc")
            self.assertLessEqual(told["blocks_out"], most, name)
            self.assertLessEqual(told["max_deviation_mm"], 0.01, name)

    def test_planned_feeds_keep_the_axes_within_their_limits(self):
        # 10 mm/s² on a radius of 20 mm allow √(10·20) = 14.1 mm/s; the program wants F1200 = 20 mm/s.
        program = self.file("a.ngc", HEAD + chords() + TAIL)
        machine = self.file("m.toml", "[path]\nmax_speed_mm_s = 100\nmax_acceleration_mm_s2 = 100\nmax_jerk_mm_s3 = 1e6\n" +
                            "".join(f"[axes.{axis}]\nmax_acceleration_mm_s2 = 10\n" for axis in "XYZ"))
        told, text = self.rewrite(program, "--machine", machine, "--feeds", "planned")
        self.assertEqual(told["feeds"], "planned")
        feeds = [float(word[1:]) for line in text.splitlines() for word in line.split() if word[0] == "F"]
        self.assertEqual(max(feeds), 1200)
        self.assertLess(min(feeds), 60 * math.sqrt(10 * 20.01))
        self.assertGreater(min(feeds), 60 * math.sqrt(10 * 20) * 0.98)
        self.assertEqual(text[-len(TAIL):], TAIL)

    def test_the_summary_is_for_people(self):
        run = self.run_toolpace("rewrite", self.file("a.ngc", HEAD + chords() + TAIL), "-o", "out.ngc")
        self.assertEqual(run.code, FINE, run.err)
        for words in ("blocks       403 -> 4", "deviation", "cycle time", "by the plan"):
            self.assertIn(words, run.out.decode())

    def test_standard_output_is_the_program_alone(self):
        run = self.run_toolpace("rewrite", "-", "-o", "-", stdin=(HEAD + chords() + TAIL).encode())
        self.assertEqual(run.code, FINE, run.err)
        self.assertTrue(run.out.decode().startswith(HEAD) and run.out.decode().endswith(TAIL))

    def test_what_cannot_be_done_is_said(self):
        program = self.file("a.ngc", HEAD + chords() + TAIL)
        for arguments, words in ((["--fit", "curves"], "arcs, lines"), (["--feeds", "slow"], "keep, planned"), (["--tolerance-mm", "0"], "--tolerance-mm"),
                                 (["--controller", "grbl"], "--settings"), (["--baud", "9600"], "--settings")):
            run = self.run_toolpace("rewrite", program, "-o", "out.ngc", *arguments)
            self.expect_failure(run, BAD_USAGE, words)
        self.expect_failure(self.run_toolpace("rewrite", program), BAD_USAGE, "-o")
        self.expect_failure(self.run_toolpace("rewrite", program, "-o", program), BAD_USAGE, "output-is-input")
        self.expect_failure(self.run_toolpace("rewrite", "none.ngc", "-o", "out.ngc"), FILE_TROUBLE, "none.ngc")
        self.expect_failure(self.run_toolpace("rewrite", self.file("bad.ngc", "G1 X1\n"), "-o", "out.ngc"), BAD_INPUT)
        self.assertFalse((self.folder / "out.ngc").exists())


if __name__ == "__main__":
    unittest.main()
