"""No file is lost: outputs that are inputs, files that change while they are read, descriptors, links and names in any case."""

import gzip
import os
import re
import resource
import subprocess
import unittest
import zipfile

from command_line import BAD_INPUT, BAD_USAGE, FILE_TROUBLE, FINE, PATIENCE_S, PROGRAM, CommandLineTest

LINE = "G21 G90 G94\nG1 X10 F3000\nM2\n"
CALLS = "G21 G90 G94 F3000\no<sub> call\nM2\n"
SUB = "o<sub> sub\nG1 X10\no<sub> endsub\nM2\n"
MACHINE = "[path]\nmax_speed_mm_s = 100.0\nmax_acceleration_mm_s2 = 3000.0\nmax_jerk_mm_s3 = 1e6\n"
CONTENTS = {"PROGRAM": LINE, "--program": LINE, "--machine": MACHINE, "--tools": "T1 P1 D6\n", "--parameters": "5161 0\n",
            "--settings": "$110=1000\n", "TRACE": "t_s,actual_x_mm\n0,0\n0.001,0.1\n"}


class Inputs(CommandLineTest):
    # What a command has to be told besides the files in question; a command that is new has to be added here.
    NEEDS = {"plan": ["PROGRAM"], "blocks": ["PROGRAM"], "simulate": ["PROGRAM"], "report": ["PROGRAM"],
             "predict": ["PROGRAM", "--settings"], "rewrite": ["PROGRAM", "--output"],
             "tune": ["PROGRAM", "--plans", "1"], "compare": ["SETPOINTS", "TRACE"],
             "identify": ["SETPOINTS", "TRACE", "--output"],
             "verify": ["SETPOINTS", "--machine"],
             "move": "--law trapezoid --length 1 --feed 1 --am 1".split(),
             "steps": "--steps 10 --speed 100 --tacc-ms 10 --tdec-ms 10 --timer-hz 1e6".split()}

    def files_of(self, command):
        """Flags and arguments of a command that name a file, from its help."""
        text = self.run_toolpace(command, "--help").out.decode()
        return [name for name in ("PROGRAM", "SETPOINTS", "TRACE") if re.search(rf"^  {name} ", text, re.M)] + \
            re.findall(r"(--[a-z-]+) FILE", text)

    def content(self, flag):
        if flag == "SETPOINTS":
            return self.run_toolpace("plan", "-", "--setpoints", "-", stdin=LINE.encode()).out
        return CONTENTS.get(flag, "").encode()

    def test_no_command_writes_over_a_file_that_it_is_told_to_read(self):
        commands = re.findall(r"^  ([a-z]+) ", self.run_toolpace("--help").out.decode().split("ommands:")[1], re.M)
        self.assertEqual(sorted(commands), sorted(self.NEEDS))
        pairs = 0
        for command in commands:
            names = self.files_of(command)
            for one in names:
                for other in names:
                    if one != other:
                        pairs += self.try_pair(command, one, other)
        self.assertGreater(pairs, 10)

    def try_pair(self, command, read, written):
        """Gives one file to two flags. @return whether one of them writes"""
        content = self.content(read)
        self.file("shared.csv" if read == "SETPOINTS" else "shared.ngc", content)
        name = "shared.csv" if read == "SETPOINTS" else "shared.ngc"
        link = self.folder / "link.csv"
        link.unlink(missing_ok=True)
        link.symlink_to(name)
        arguments = [command]
        for need in self.NEEDS[command]:
            if need not in (read, written):
                arguments += [need] if need.islower() and need not in CONTENTS else self.named(need)
        arguments += self.as_argument(read, name) + self.as_argument(written, "link.csv")
        run = self.run_toolpace(*arguments)
        self.assertEqual((self.folder / name).read_bytes(), content, arguments)
        if "output-is-input" in run.err:
            self.expect_failure(run, BAD_USAGE, "same file")
            return 1
        return 0

    def named(self, need):
        name = "other.csv" if need == "SETPOINTS" else need.strip("-").lower() + ".txt"
        self.file(name, self.content(need))
        return self.as_argument(need, name)

    def as_argument(self, flag, name):
        return [flag, name] if flag.startswith("--") else [name]

    def test_hard_links_and_other_paths_are_the_same_file(self):
        self.file("a.ngc", LINE)
        os.link(self.folder / "a.ngc", self.folder / "hard.csv")
        (self.folder / "folder").symlink_to(".")
        for name in ("hard.csv", "folder/a.ngc", "./a.ngc"):
            self.expect_failure(self.run_toolpace("report", "a.ngc", "-o", name), BAD_USAGE, "output-is-input", "the program")
        self.assertEqual((self.folder / "a.ngc").read_text(), LINE)

    def test_a_sub_program_that_the_program_calls_is_an_input(self):
        self.file("a.ngc", CALLS)
        self.file("sub.ngc", SUB)
        for arguments in (["plan", "a.ngc", "--setpoints"], ["blocks", "a.ngc", "--csv"], ["report", "a.ngc", "-o"],
                          ["simulate", "a.ngc", "--trace"]):
            (self.folder / "link.csv").unlink(missing_ok=True)
            (self.folder / "link.csv").symlink_to("sub.ngc")
            self.expect_failure(self.run_toolpace(*arguments, "link.csv"), BAD_USAGE, "the sub-program")
            self.assertEqual((self.folder / "sub.ngc").read_text(), SUB)
        self.assertEqual(len(list(self.folder.iterdir())), 3)

    def test_standard_output_and_input_count(self):
        self.file("a.ngc", LINE)
        for command in (["plan", "a.ngc"], ["blocks", "-"]):
            with open(self.folder / "a.ngc", "rb") as stdin, open(self.folder / "a.ngc", "ab") as stdout:
                done = subprocess.run([PROGRAM, *command], cwd=self.folder, stdin=stdin, stdout=stdout, stderr=subprocess.PIPE, timeout=PATIENCE_S)
            self.assertEqual(done.returncode, BAD_USAGE, done.stderr)
            self.assertEqual((self.folder / "a.ngc").read_text(), LINE)

    def test_two_outputs_are_not_one_file(self):
        self.file("a.ngc", LINE)
        with open(self.folder / "out.csv", "wb") as out:
            done = subprocess.run([PROGRAM, "plan", "a.ngc", "--setpoints", "out.csv"], cwd=self.folder, stdout=out,
                                  stderr=subprocess.PIPE, timeout=PATIENCE_S)
        self.assertEqual(done.returncode, BAD_USAGE, done.stderr)
        self.assertIn(b"output-twice", done.stderr)
        for name in ("-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"):
            self.expect_failure(self.run_toolpace("plan", "a.ngc", "--setpoints", name, "--json"), BAD_USAGE, "two-outputs")


class Descriptors(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.file("a.ngc", LINE)
        self.run_toolpace("plan", "a.ngc", "--setpoints", "a.csv")
        self.expected = (self.folder / "a.csv").read_bytes()

    def shell(self, line):
        return subprocess.run(["bash", "-c", line], cwd=self.folder, env={**os.environ, "toolpace": PROGRAM}, capture_output=True,
                              timeout=PATIENCE_S)

    def test_standard_output_by_its_names_is_standard_output(self):
        for name in ("/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"):
            run = self.run_toolpace("plan", "a.ngc", "--setpoints", name)
            self.assertEqual((run.code, run.out), (FINE, self.expected), run.err)

    def test_standard_output_that_is_a_file_keeps_what_stands_in_it(self):
        done = self.shell('echo head > out; "$toolpace" plan a.ngc --setpoints /dev/stdout >> out')
        self.assertEqual(done.returncode, FINE, done.stderr)
        self.assertEqual((self.folder / "out").read_bytes(), b"head\n" + self.expected)

    def test_pipes_of_the_shell_are_written_and_read(self):
        done = self.shell('"$toolpace" plan a.ngc --setpoints >(gzip > out.gz) > /dev/null; wait $!')
        self.assertEqual(done.returncode, FINE, done.stderr)
        self.assertEqual(gzip.decompress((self.folder / "out.gz").read_bytes()), self.expected)
        done = self.shell('exec 3> out.csv; "$toolpace" plan <(cat a.ngc) --setpoints /dev/fd/3 > /dev/null')
        self.assertEqual(done.returncode, FINE, done.stderr)
        self.assertEqual((self.folder / "out.csv").read_bytes(), self.expected)

    def test_a_reader_that_goes_away_is_told(self):
        done = self.shell('(echo G21 G90 G94 F600; for i in $(seq 200); do echo G1 X$((i % 2)); done; echo M2) > long.ngc;'
                          '"$toolpace" plan long.ngc --setpoints /dev/stdout | head -1; exit ${PIPESTATUS[0]}')
        self.assertEqual(done.returncode, FILE_TROUBLE, done.stderr)
        self.assertEqual(done.stdout, self.expected.splitlines(True)[0])

    def test_an_archive_goes_to_a_pipe_as_to_a_file(self):
        self.run_toolpace("plan", "a.ngc", "--setpoints", "a.npz")
        (self.folder / "link.npz").symlink_to("/dev/stdout")
        run = self.run_toolpace("plan", "a.ngc", "--setpoints", "link.npz")
        self.assertEqual((run.code, run.out), (FINE, (self.folder / "a.npz").read_bytes()), run.err)

    def test_closed_standard_descriptors_are_no_files_of_ours(self):
        for closed in (">&-", "2>&-", ">&- 2>&-", "<&-", "<&- >&- 2>&-"):
            done = self.shell(f'"$toolpace" plan a.ngc --setpoints out.csv {closed}')
            self.assertIn(done.returncode, (FINE, FILE_TROUBLE), closed)
            self.assertEqual((self.folder / "out.csv").read_bytes(), self.expected, closed)
        self.assertEqual(self.shell('"$toolpace" plan nowhere.ngc 2>&-').returncode, FILE_TROUBLE)


class Reading(CommandLineTest):
    def test_a_file_size_limit_is_told_and_leaves_nothing(self):
        program = self.file("a.ngc", LINE.replace("X10", "X1000"))
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))
        for ending in ("csv", "npy", "npz", "halstream"):
            done = subprocess.run([PROGRAM, "plan", program, "--setpoints", f"out.{ending}"], cwd=self.folder, preexec_fn=limit,
                                  capture_output=True, timeout=PATIENCE_S)
            self.assertEqual(done.returncode, FILE_TROUBLE, (ending, done.stderr))
            self.assertIn(b"file-too-large", done.stderr)
        self.assertEqual([path.name for path in self.folder.iterdir()], [program])

    def test_what_a_killed_process_leaves_is_swept_by_the_next(self):
        self.file("long.ngc", "G21 G90 G94\nG1 X900000 F60\nM2\n")
        process = subprocess.Popen([PROGRAM, "plan", "long.ngc", "--setpoints", "out.csv"], cwd=self.folder, stdout=subprocess.DEVNULL)
        while not [path for path in self.folder.iterdir() if path.name.endswith(".tmp") and path.stat().st_size > 0]:
            self.assertIsNone(process.poll())
        process.kill()
        process.wait()
        self.assertEqual(len(list(self.folder.iterdir())), 2)
        self.file("a.ngc", LINE)
        self.run_toolpace("plan", "a.ngc", "--setpoints", "other.csv")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["a.ngc", "long.ngc", "other.csv"])

    def test_a_damaged_archive_is_refused(self):
        self.file("a.ngc", LINE)
        self.file("m.toml", MACHINE)
        self.run_toolpace("plan", "a.ngc", "--setpoints", "a.npz")
        whole = (self.folder / "a.npz").read_bytes()
        self.assertEqual(self.run_toolpace("verify", "a.npz", "--machine", "m.toml").code, FINE)
        with zipfile.ZipFile(self.folder / "a.npz") as archive:
            self.assertEqual([entry.filename for entry in archive.infolist()], ["setpoints.npy", "line.npy", "meta.npy"])
            self.assertEqual({(entry.date_time, entry.compress_type) for entry in archive.infolist()},
                             {((1980, 1, 1, 0, 0, 0), zipfile.ZIP_STORED)})
            places = [whole.index(archive.read(entry)) + 128 + 16 for entry in archive.infolist()]
        for place in places:
            damaged = bytearray(whole)
            damaged[place] ^= 1
            self.file("b.npz", bytes(damaged))
            self.expect_failure(self.run_toolpace("verify", "b.npz", "--machine", "m.toml"), BAD_INPUT, "the archive is damaged", "b.npz")

    def test_extensions_are_read_without_case(self):
        self.file("a.ngc", LINE)
        self.file("M.TOML", MACHINE)
        for name in ("a.CSV", "a.Npy", "a.NPZ", "a.HalStream", "a.Semicolon.Csv"):
            self.run_toolpace("plan", "a.ngc", "--setpoints", name)
            self.run_toolpace("plan", "a.ngc", "--setpoints", "b" + name.lower()[1:])
            self.assertEqual((self.folder / name).read_bytes(), (self.folder / ("b" + name.lower()[1:])).read_bytes(), name)
            self.assertEqual(self.run_toolpace("verify", name, "--machine", "M.TOML").code, FINE, name)
        self.assertEqual(self.run_toolpace("simulate", "a.ngc", "--trace", "trace.Csv").code, FINE)
        self.assertEqual(self.run_toolpace("plan", self.file("B.CSV", "x_mm\n0\n10\n")).code, FINE)

    def test_sub_programs_are_found_whatever_the_case_of_their_extension(self):
        self.file("a.ngc", CALLS)
        self.file("sub.Ngc", SUB)
        self.assertEqual(self.run_toolpace("plan", "a.ngc").code, FINE)
        self.file("sub.ngc", SUB.replace("X10", "X20"))
        self.assertAlmostEqual(self.run_toolpace("plan", "a.ngc", "--json").json()["path_length_mm"], 20, msg="the exact name goes first")

    def test_a_sub_program_behind_a_link_that_leads_outside_says_so(self):
        (self.folder / "in").mkdir()
        self.file("in/a.ngc", CALLS)
        self.file("sub.ngc", SUB)
        (self.folder / "in" / "sub.ngc").symlink_to("../sub.ngc")
        run = self.run_toolpace("plan", "in/a.ngc")
        self.expect_failure(run, BAD_INPUT, "in/a.ngc:2:", "link that leads outside", "--sub-path", "sub-program-refused")
        self.assertEqual(self.run_toolpace("plan", "in/a.ngc", "--sub-path", ".").code, FINE)

    def test_a_sub_program_that_cannot_be_read_is_file_trouble(self):
        if os.geteuid() == 0:
            self.skipTest("root reads everything")
        self.file("a.ngc", CALLS)
        self.file("sub.ngc", SUB)
        (self.folder / "sub.ngc").chmod(0)
        self.expect_failure(self.run_toolpace("plan", "a.ngc"), FILE_TROUBLE, "sub.ngc")

    def test_a_temporary_folder_that_is_none_is_told(self):
        self.file("a.ngc", LINE)
        run = self.run_toolpace("plan", "a.ngc", "--setpoints", "/dev/fd/2", env={**os.environ, "TMPDIR": "/nowhere"})
        self.assertEqual(run.code, FINE, run.err)
        (self.folder / "a.npy").symlink_to("/dev/null")
        run = self.run_toolpace("plan", "a.ngc", "--setpoints", "a.npy", env={**os.environ, "TMPDIR": "/nowhere"})
        self.expect_failure(run, FILE_TROUBLE, "/nowhere")


if __name__ == "__main__":
    unittest.main()
