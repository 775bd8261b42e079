"""What is written: whole or not at all, the same bytes every time, and to pipes and devices too."""

import os
import pathlib
import resource
import subprocess
import unittest

from command_line import BAD_INPUT, BAD_USAGE, EXAMPLES, FILE_TROUBLE, FINE, PATIENCE_S, PROGRAM, CommandLineTest

LINE = "G21 G90 G94\nG1 X10 F3000\nM2\n"


class Output(CommandLineTest):
    def test_the_same_job_writes_the_same_bytes(self):
        for name in ("butterfly.ngc", "pocket.ngc", "helix.ngc"):
            for ending in ("csv", "npy", "npz", "halstream"):
                files = [self.folder / f"{turn}.{ending}" for turn in "ab"]
                runs = [self.run_toolpace("plan", EXAMPLES / name, "--setpoints", file) for file in files]
                self.assertEqual([run.code for run in runs], [FINE, FINE], runs[0].err)
                self.assertEqual(files[0].read_bytes(), files[1].read_bytes(), f"{name} as {ending}")

    def test_json_is_one_object_and_the_same_but_for_the_wall_clock(self):
        runs = [self.run_toolpace("plan", EXAMPLES / "butterfly.ngc", "--json").json() for _ in range(2)]
        for run in runs:
            self.assertGreaterEqual(run.pop("plan_wall_s"), 0)
        self.assertEqual(*runs)

    def test_a_dash_reads_standard_input_and_writes_standard_output(self):
        self.file("line.ngc", LINE)
        named = self.run_toolpace("plan", "line.ngc", "--setpoints", "line.csv")
        self.assertEqual(named.code, FINE, named.err)
        piped = self.run_toolpace("plan", "-", "--setpoints", "-", stdin=LINE.encode())
        self.assertEqual(piped.code, FINE, piped.err)
        self.assertEqual(piped.out, (self.folder / "line.csv").read_bytes())

    def test_rows_stand_on_the_period_and_the_ends_are_exact(self):
        self.file("line.ngc", "G21 G90 G94\nG1 X10 Y-7.3 F3000\nM2\n")
        self.run_toolpace("plan", "line.ngc", "--setpoints", "line.csv", "--period-ms", "2")
        header, *rows = (self.folder / "line.csv").read_text().splitlines()
        self.assertEqual(header, "t_s,x_mm,y_mm,z_mm,v_mm_s,a_mm_s2,j_mm_s3,line")
        cells = [row.split(",") for row in rows]
        for k, row in enumerate(cells):
            self.assertAlmostEqual(float(row[0]), 0.002 * k, delta=1e-12)
        self.assertEqual(cells[0][1:4], ["0", "0", "0"])
        self.assertEqual(cells[-1][1:5], ["10", "-7.3", "0", "0"])

    def test_the_tip_stands_beside_the_axes(self):
        self.file("tilt.ngc", "G21 G90 G94\nG1 X10 B90 F3000\nM2\n")
        machine = EXAMPLES.parent.parent / "resources" / "machines" / "five-axis.toml"
        run = self.run_toolpace("plan", "tilt.ngc", "--machine", machine, "--setpoints", "tilt.csv", "--tip", "--verify")
        self.assertEqual(run.code, FINE, run.err)
        header, *rows = (self.folder / "tilt.csv").read_text().splitlines()
        tip = [float(cell) for cell in rows[-1].split(",")[10:13]]
        self.assertEqual(header.split(",")[10:13], ["tip_x_mm", "tip_y_mm", "tip_z_mm"])
        for value, expected in zip(tip, (10 - 150, 0, 150)):  # a tool of 150 mm, laid down
            self.assertAlmostEqual(value, expected, delta=1e-9)
        for flags in (["--setpoints", "tilt.csv"], ["--machine", machine, "--setpoints", "tilt.npz"]):
            refused = self.run_toolpace("plan", "tilt.ngc", "--tip", *flags)
            self.assertEqual(refused.code, BAD_USAGE, refused.err)

    def test_the_tip_is_that_of_the_tool_that_the_program_tells(self):
        machine = (EXAMPLES.parent.parent / "resources" / "machines" / "head-bc.toml").read_text()
        self.file("head.toml", "".join(line for line in machine.splitlines(True) if not line.startswith("tool_mm")))
        self.file("tools.tbl", "T1 P1 Z100\nT2 P2 Z40\n")
        told = ["plan", "tools.nc", "--dialect", "fanuc", "--tools", "tools.tbl", "--machine", "head.toml", "--tip"]
        self.file("tools.nc", "G21 G90 G94\nG43.4 H1\nG1 X5 B20 C30 F3000\nX10 B30\nG49\nG0 B0 C0\nG43.4 H2\nG1 X3 Y4 Z5 B40\nM30\n")
        run = self.run_toolpace(*told, "--setpoints", "tip.csv", "--verify")
        self.assertEqual(run.code, FINE, run.err)
        rows = [row.split(",") for row in (self.folder / "tip.csv").read_text().splitlines()[1:]]
        for line, tip in (("4", (10, 0, 0)), ("8", (3, 4, 5))):
            last = [row for row in rows if row[-1] == line][-1]
            for value, expected in zip(last[10:13], tip):
                self.assertAlmostEqual(float(value), expected, delta=0.01)
        self.file("tools.nc", "G21 G90 G94\nG1 X5 B20 F3000\nM30\n")
        refused = self.run_toolpace(*told, "--setpoints", "none.csv")
        self.assertEqual(refused.code, BAD_USAGE, refused.err)
        self.assertFalse((self.folder / "none.csv").exists())

    def test_an_hour_of_setpoints_fits_into_less_memory_than_its_rows(self):
        # 36 moves of 100 mm at 60 mm/min: 3.6 million rows of eight numbers are 230 MB.
        moves = [f"G1 X{100 * (i % 2)} Y{i % 7}" for i in range(1, 37)]
        self.file("long.ngc", "\n".join(["G21 G90 G94 F60", *moves, "M2", ""]))
        bound = 100 << 20
        for ending in ("npy", "npz", "csv", "halstream"):
            link = self.folder / f"nowhere.{ending}"
            link.symlink_to("/dev/null")
            run = self.run_toolpace("plan", "long.ngc", "--setpoints", link,
                                    preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_DATA, (bound, bound)))
            self.assertEqual(run.code, FINE, f"{ending}: {run.err}")

    def test_a_full_disk_is_told(self):
        for ending in ("csv", "npy", "npz", "halstream"):
            link = self.folder / f"full.{ending}"
            link.symlink_to("/dev/full")
            run = self.run_toolpace("plan", EXAMPLES / "butterfly.ngc", "--setpoints", link)
            self.expect_failure(run, FILE_TROUBLE, link.name)

    def test_standard_output_that_is_full_is_told(self):
        for arguments in (["plan", EXAMPLES / "butterfly.ngc", "--setpoints", "-"],
                          ["plan", EXAMPLES / "butterfly.ngc", "--json"],
                          ["blocks", EXAMPLES / "butterfly.ngc", "--csv", "-"]):
            with open("/dev/full", "wb") as full:
                done = subprocess.run([PROGRAM, *map(str, arguments)], stdout=full, stderr=subprocess.PIPE, timeout=PATIENCE_S)
            self.assertEqual(done.returncode, FILE_TROUBLE, arguments)
            self.assertNotEqual(done.stderr, b"")

    def test_a_closed_pipe_is_told(self):
        for arguments in (["plan", EXAMPLES / "rosette.ngc", "--setpoints", "-"], ["blocks", EXAMPLES / "rosette.ngc", "--csv", "-"]):
            reading, writing = os.pipe()
            os.close(reading)
            with os.fdopen(writing, "wb") as closed:
                done = subprocess.run([PROGRAM, *map(str, arguments)], stdout=closed, stderr=subprocess.PIPE, timeout=PATIENCE_S)
            self.assertEqual(done.returncode, FILE_TROUBLE, (arguments, done.stderr))

    def test_a_folder_that_is_not_there_or_is_the_target_is_told(self):
        self.file("line.ngc", LINE)
        (self.folder / "taken.csv").mkdir()
        for target in ("nowhere/out.csv", "taken.csv"):
            self.expect_failure(self.run_toolpace("plan", "line.ngc", "--setpoints", target), FILE_TROUBLE, target)

    def test_an_old_file_stays_when_the_program_is_refused(self):
        self.file("bad.ngc", "G21\nG1 X10\nM2\n")
        self.file("out.csv", "as it was")
        self.assertEqual(self.run_toolpace("plan", "bad.ngc", "--setpoints", "out.csv").code, BAD_INPUT)
        self.assertEqual((self.folder / "out.csv").read_text(), "as it was")

    def test_a_device_is_written_directly(self):
        run = self.run_toolpace("plan", self.file("line.ngc", LINE), "--setpoints", "/dev/null")
        self.assertEqual(run.code, FINE, run.err)
        self.assertTrue(pathlib.Path("/dev/null").is_char_device())


if __name__ == "__main__":
    unittest.main()
