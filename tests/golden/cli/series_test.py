"""Many programs: one table of them, in all its forms; what is done is kept, taken over, and made again where something has changed."""

import csv
import io
import os
import shutil
import signal
import subprocess
import unittest

from command_line import BAD_INPUT, BAD_USAGE, FILE_TROUBLE, FINE, INTERRUPTED, PATIENCE_S, PROGRAM, SOURCE_DIR, CommandLineTest

LINE = "G21 G90 G94\nG1 X{} F3000\nM2\n"
BAD = "G21 G90 G94\nG1 X F3000\nM2\n"
ENDLESS = "G21 G90 G94\nG1 X900000 F60\nM2\n"
MACHINE = "[path]\nmax_speed_mm_s = 100.0\nmax_acceleration_mm_s2 = 3000.0\nmax_jerk_mm_s3 = 1e6\n"


class Series(CommandLineTest):
    def setUp(self):
        super().setUp()
        (self.folder / "parts").mkdir()
        for name, length in (("a", 10), ("b", 20), ("c", 30)):
            self.file(f"parts/{name}.ngc", LINE.format(length))
        self.file("parts/notes.pdf", "no program")
        self.file("m.toml", MACHINE)

    def plan(self, *arguments, code=FINE, **options):
        run = self.run_toolpace("plan", *arguments, "--json", **options)
        self.assertEqual(run.code, code, run.err)
        return run.json()

    def rows(self, name="r.csv"):
        return list(csv.DictReader(io.StringIO((self.folder / name).read_text())))

    def test_a_folder_is_one_table_of_what_each_program_gives_alone(self):
        alone = [self.plan(f"parts/{name}.ngc", "--machine", "m.toml", "--bound") for name in "abc"]
        told = self.plan("parts", "--machine", "m.toml", "--bound")
        self.assertEqual([row["program"] for row in told["rows"]], [f"parts/{name}.ngc" for name in "abc"])
        for row, one in zip(told["rows"], alone):
            for key in ("blocks", "path_length_mm", "cycle_time_s", "feed_time_s", "rapid_time_s", "bound_s", "violations"):
                self.assertEqual(row[key], one[key], key)
            self.assertIsNone(row["error"])
        self.assertEqual(told["sums"]["cycle_time_s"], sum(one["cycle_time_s"] for one in alone))
        self.assertEqual((told["programs"], told["failed"], told["taken_over"]), (3, 0, 0))
        table = self.run_toolpace("plan", "parts", "--machine", "m.toml", "--bound", "--csv", "-")
        self.assertEqual([float(row["cycle_time_s"]) for row in csv.DictReader(io.StringIO(table.out.decode()))],
                         [one["cycle_time_s"] for one in alone])
        text = self.run_toolpace("plan", "parts", "--machine", "m.toml").out.decode().splitlines()
        self.assertEqual([line.split()[0] for line in text], ["program"] + [f"parts/{name}.ngc" for name in "abc"] + ["together", "3"])

    def test_several_folders_and_lists_are_taken_once_each(self):
        told = self.plan("parts/b.ngc", "parts", "--programs", "-", stdin=b"# those of today\n./parts/a.ngc\nparts/c.ngc\r\n\n")
        self.assertEqual([row["program"] for row in told["rows"]], [f"parts/{name}.ngc" for name in "bac"])

    def test_a_bad_program_is_a_row_and_the_others_are_done(self):
        self.file("parts/b.ngc", BAD)
        told = self.plan("parts", "gone.ngc", code=FILE_TROUBLE)
        self.assertEqual([row["exit_code"] for row in told["rows"]], [FINE, BAD_INPUT, FINE, FILE_TROUBLE])
        self.assertEqual(told["rows"][1]["error"]["line"], 2)
        self.assertIsNone(told["rows"][1]["cycle_time_s"])
        self.assertEqual(told["rows"][3]["error"]["code"], "file-not-found")
        run = self.run_toolpace("plan", "parts")
        self.assertEqual(run.code, BAD_INPUT)
        self.assertIn("parts/b.ngc:2:", run.err)
        self.assertRegex(run.out.decode(), r"parts/b.ngc +line 2: .*\n")

    def test_what_is_wrong_for_all_ends_it_at_once(self):
        self.expect_failure(self.run_toolpace("plan", "parts", "--am", 0, "--json"), BAD_USAGE, "--am")
        self.expect_failure(self.run_toolpace("plan", "parts", "--machine", "gone.toml", "--json"), FILE_TROUBLE, "gone.toml")
        self.file("m.toml", "[path\n")
        self.expect_failure(self.run_toolpace("plan", "parts", "--machine", "m.toml", "--json"), BAD_USAGE, "m.toml:1")
        (self.folder / "empty").mkdir()
        self.expect_failure(self.run_toolpace("plan", "empty", "--json"), FILE_TROUBLE, "no program")
        self.expect_failure(self.run_toolpace("plan", "-", "parts", "--json"), BAD_USAGE, "standard input")
        self.expect_failure(self.run_toolpace("plan", "parts", "--results", "-"), BAD_USAGE, "no regular file")

    def test_a_results_file_is_gone_on_from(self):
        first = self.plan("parts", "--machine", "m.toml", "--results", "r.csv")
        again = self.plan("parts", "--machine", "m.toml", "--results", "r.csv")
        self.assertEqual(again, {**first, "taken_over": 3})
        self.assertEqual(len(self.rows()), 3)

    def test_what_has_changed_is_done_again(self):
        run = lambda *more: self.plan("parts", "--machine", "m.toml", "--results", "r.csv", *more)["taken_over"]
        self.assertEqual((run(), run()), (0, 3))
        self.file("parts/b.ngc", LINE.format(25))
        self.assertEqual((run(), run()), (2, 3))
        self.assertEqual(self.plan("parts/b.ngc", "--machine", "m.toml", "--results", "r.csv")["rows"][0]["path_length_mm"], 25)
        self.file("m.toml", MACHINE.replace("3000", "2000"))
        self.assertEqual((run(), run(), run("--law", "trapezoid")), (0, 3, 0))

    def test_a_changed_sub_program_is_a_change(self):
        self.file("parts/b.ngc", "G21 G90 G94 F3000\no<sub> call\nM2\n")
        self.file("sub.ngc", "o<sub> sub\nG1 X10\no<sub> endsub\nM2\n")
        run = lambda: self.plan("parts", "--sub-path", ".", "--results", "r.csv")
        self.assertEqual((run()["taken_over"], run()["taken_over"]), (0, 3))
        self.file("sub.ngc", "o<sub> sub\nG1 X12\no<sub> endsub\nM2\n")
        told = run()
        self.assertEqual((told["taken_over"], told["rows"][1]["path_length_mm"]), (2, 12))

    def test_what_failed_is_tried_again(self):
        self.file("parts/b.ngc", BAD)
        run = lambda code: self.plan("parts", "--results", "r.csv", code=code)["taken_over"]
        self.assertEqual((run(BAD_INPUT), run(BAD_INPUT)), (0, 2))
        self.file("parts/b.ngc", LINE.format(20))
        self.assertEqual((run(FINE), run(FINE)), (2, 3))

    def test_half_a_row_of_a_run_that_was_killed_is_cut_off(self):
        self.plan("parts", "--results", "r.csv")
        whole = (self.folder / "r.csv").read_bytes()
        (self.folder / "r.csv").write_bytes(whole[:-20])
        self.assertEqual(self.plan("parts", "--results", "r.csv", "--jobs", 1)["taken_over"], 2)
        lines = (self.folder / "r.csv").read_bytes().splitlines()
        self.assertEqual(sorted(lines), sorted(whole.splitlines()))
        self.assertEqual(len(self.rows()), 3)

    def test_results_of_another_table_are_left_alone(self):
        for text in ("a,b\n1,2\n", "my notes\n"):
            self.file("r.csv", text)
            self.expect_failure(self.run_toolpace("plan", "parts", "--results", "r.csv", "--json"), BAD_USAGE, "another file")
            self.assertEqual((self.folder / "r.csv").read_text(), text)

    def test_an_interrupt_keeps_what_is_done(self):
        self.file("parts/z.ngc", ENDLESS)
        process = subprocess.Popen([PROGRAM, "plan", "parts", "--jobs", "1", "--results", "r.csv", "--setpoints", "{}.csv"],
                                   cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        self.addCleanup(process.kill)
        while not list(self.folder.glob("*z.csv*")) and not list(self.folder.glob(".*z.csv*")):
            self.assertIsNone(process.poll(), "it ended by itself")
        process.send_signal(signal.SIGINT)
        out = process.communicate(timeout=PATIENCE_S)[0].decode()
        self.assertEqual(process.returncode, INTERRUPTED)
        self.assertIn("parts/c.ngc", out)
        self.assertEqual([row["program"] for row in self.rows()], [f"parts/{name}.ngc" for name in "abc"])
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["a.csv", "b.csv", "c.csv", "m.toml", "parts", "r.csv"])
        self.file("parts/z.ngc", LINE.format(1))
        told = self.plan("parts", "--results", "r.csv", "--setpoints", "{}.csv")
        self.assertEqual((told["taken_over"], told["programs"]), (3, 4))

    def test_outputs_are_named_after_their_programs(self):
        (self.folder / "out").mkdir()
        run = lambda: self.plan("parts", "--results", "r.csv", "--setpoints", "out/{}.csv")["taken_over"]
        self.assertEqual(run(), 0)
        alone = self.run_toolpace("plan", "parts/b.ngc", "--setpoints", "-").out
        self.assertEqual((self.folder / "out/b.csv").read_bytes(), alone)
        (self.folder / "out/b.csv").unlink()
        self.assertEqual(run(), 2, "what is gone is made again")
        self.assertEqual((self.folder / "out/b.csv").read_bytes(), alone)

    def test_outputs_that_would_be_one_file_are_refused(self):
        self.file("a.ngc", LINE.format(5))
        for words, said in ((("parts", "--setpoints", "o.csv"), "{}"), (("parts", "a.ngc", "--setpoints", "{}.csv"), "same file"),
                            (("parts", "--setpoints", "parts/{}.ngc"), "same file"), (("parts", "--results", "parts/b.ngc"), "same file"),
                            (("parts", "--csv", "parts/b.ngc"), "same file"), (("parts", "--csv", "r.csv", "--results", "r.csv"), "same file")):
            with self.subTest(words=words):
                self.expect_failure(self.run_toolpace("plan", *words, "--json"), BAD_USAGE, said)
        self.assertEqual((self.folder / "parts/b.ngc").read_text(), LINE.format(20))

    def test_what_a_refused_program_does_before_its_error_is_no_figure_of_it(self):
        self.file("parts/b.ngc", "G21 G90 G94\nG1 X10 F3000\nG2 X20 Y5 R1\nM2\n")
        run = self.run_toolpace("predict", "parts", "--settings", SOURCE_DIR / "examples/settings/grbl.txt", "--no-what-if", "--json")
        self.assertEqual(run.code, BAD_INPUT)
        told = run.json()
        self.assertEqual((told["failed"], told["rows"][1]["error"]["line"], told["rows"][1]["cycle_time_s"]), (1, 3, None))

    def test_other_commands_have_tables_too(self):
        for command, flags, key in (("tune", ("--plans", 2), "best_s"), ("simulate", (), "max_contour_error_mm"),
                                    ("predict", ("--settings", SOURCE_DIR / "examples/settings/grbl.txt", "--no-what-if"), "cycle_time_s"),
                                    ("tune", ("--settings", SOURCE_DIR / "examples/settings/grbl.txt"), "best_s")):
            run = self.run_toolpace(command, "parts", *flags, "--json")
            self.assertEqual(run.code, FINE, run.err)
            times = [row[key] for row in run.json()["rows"]]
            self.assertEqual(len(times), 3)
            self.assertTrue(all(time > 0 for time in times), times)

    @unittest.skipUnless(shutil.which("parallel"), "GNU parallel is not installed: scripts/install installs it")
    def test_gnu_parallel_shares_a_results_file(self):
        for i in range(12):
            self.file(f"parts/n{i:02}.ngc", LINE.format(10 + i))
        line = self.line_of_the_handbook("parallel ")
        subprocess.run(line.replace("mill.toml", "m.toml"), shell=True, cwd=self.folder, check=True, capture_output=True, timeout=PATIENCE_S,
                       env={**os.environ, "PATH": f"{os.path.dirname(PROGRAM)}:{os.environ['PATH']}"})
        rows = self.rows("parts.csv")
        self.assertEqual(sorted(row["program"] for row in rows), sorted(f"parts/{p.name}" for p in (self.folder / "parts").glob("*.ngc")))
        told = self.plan("parts", "--machine", "m.toml", "--results", "parts.csv")
        self.assertEqual((told["programs"], told["taken_over"]), (15, 15), "the same rows as without parallel")

    def test_a_task_of_a_slurm_array_does_its_program(self):
        self.file("programs.txt", "parts/a.ngc\nparts/b.ngc\nparts/c.ngc\n")
        line, join = (self.line_of_the_handbook(begin).replace("mill.toml", "m.toml").replace("tune ", "tune --plans 2 ")
                      for begin in ("srun ", "awk "))
        path = f"{os.path.dirname(PROGRAM)}:{os.environ['PATH']}"
        for task in (1, 2, 3):
            subprocess.run(line.removeprefix("srun "), shell=True, cwd=self.folder, check=True, capture_output=True, timeout=PATIENCE_S,
                           env={**os.environ, "PATH": path, "SLURM_ARRAY_TASK_ID": str(task)})
        done = subprocess.run(join, shell=True, cwd=self.folder, check=True, capture_output=True, timeout=PATIENCE_S,
                              env={**os.environ, "PATH": path})
        self.assertIn(b"3 programs, 0 failed, 3 taken over from tuned.csv", done.stdout)
        self.assertEqual(len(self.rows("table.csv")), 3)

    def line_of_the_handbook(self, begin):
        page = (SOURCE_DIR / "docs/handbook/many.md").read_text().splitlines()
        return next(line.strip() for line in page if line.startswith("    " + begin))


if __name__ == "__main__":
    unittest.main()
