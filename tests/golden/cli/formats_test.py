"""docs/FORMATS.md says what the program does: its keys, columns and defaults are tried, not copied."""

import re
import unittest

from command_line import FINE, SOURCE_DIR, CommandLineTest

TEXT = (SOURCE_DIR / "docs" / "FORMATS.md").read_text()
PROGRAM = "G21 G90 G94\nG1 X10 F3000\nM2\n"
WORDS = {"name": '"m"', "rotary": "[]", "kind": '"quintic"', "blocks": '"all"', "ramps": '"block"', "corner": '"servo"',
         "shaper": '"none"'}


def table(heading):
    """Rows of the first table under a heading, as lists of cells."""
    part = TEXT.split(f"## {heading}\n", 1)[1].split("\n## ", 1)[0]
    return [[cell.strip() for cell in row.strip("|").split("|")] for row in part.splitlines() if row.startswith("| `")]


def names(text):
    return re.findall(r"`(\w+)`", text)


class Formats(CommandLineTest):
    def test_every_key_of_a_machine_file_is_read(self):
        program = self.file("a.ngc", PROGRAM)
        for sections, keys in table("Machine files"):
            for section in re.findall(r"`\[(\[?[\w.]+\]?)\]`", sections):
                for key in names(keys):
                    if section == "servo.X" and key == "backlash_deg" or section == "servo" and key.startswith("backlash"):
                        continue
                    value = WORDS.get(key, "[-50.0, 50.0]" if key.startswith("travel") else "0.5")
                    due = "frequency_hz = 9\n" if section == "[servo.X.modes]" and key != "frequency_hz" else ""
                    machine = self.file("m.toml", f"[{section}]\n{due}{key} = {value}\n")
                    run = self.run_toolpace("plan", program, "--machine", machine, "--vmax", 100, "--am", 100, "--jm", 1e4)
                    self.assertEqual(run.code, FINE, f"[{section}] {key}: {run.err}")

    def test_no_key_of_a_machine_file_is_left_out(self):
        # Keys of axes are put together from parts in the sources; the test above tries them.
        documented = {key for _, keys in table("Machine files") for key in names(keys)}
        sources = (SOURCE_DIR / "core/toolpace/machine/setup_keys.cpp").read_text()
        known = set(re.findall(r'"((?:max|travel|steps|period|tool|tacc|tdec|tolerance|junction|kv|velocity|acceleration|bandwidth'
                               r'|damping|backlash|resonance|frequency|share)_?\w*?[a-z0-9])"', sources))
        self.assertGreater(len(known), 15)
        self.assertEqual(known - documented, set())

    def test_every_key_of_a_plan_is_told(self):
        run = self.run_toolpace("plan", self.file("a.ngc", PROGRAM), "--json", "--bound", "--verify")
        told = {key for row in table("JSON") for key in names(row[0])}
        self.assertEqual(told, set(run.json()))

    def test_every_key_of_tune_is_told(self):
        self.file("a.ngc", PROGRAM)
        told = {key for row in table("JSON of tune") for key in names(row[0])}
        self.assertEqual(told, set(self.run_toolpace("tune", "a.ngc", "--plans", 2, "--json").json()))

    def test_every_key_of_the_other_commands_is_told(self):
        self.file("a.ngc", PROGRAM)
        self.file("m.toml", "[path]\nmax_speed_mm_s = 100\nmax_acceleration_mm_s2 = 3000\nmax_jerk_mm_s3 = 1e6\n")
        self.run_toolpace("plan", "a.ngc", "--setpoints", "a.csv")
        for name, arguments in (("move", ["--law", "trapezoid", "--length", 1, "--feed", 1, "--am", 1]),
                                ("verify", ["a.csv", "--machine", "m.toml"]), ("blocks", ["a.ngc"]), ("simulate", ["a.ngc"]),
                                ("steps", "--steps 9 --speed 99 --tacc-ms 9 --tdec-ms 9 --timer-hz 1e6".split())):
            part = re.search(rf"`{name} --json`:(.*?)(?:\n\n|`\w+ --json`:|\Z)", TEXT, re.S).group(1)
            self.assertLessEqual(set(self.run_toolpace(name, *arguments, "--json").json()), set(names(part)), name)

    def test_every_column_of_many_programs_is_told(self):
        self.file("a.ngc", PROGRAM)
        self.file("s.txt", "$110=1000\n")
        rows = {row[0]: row[1] for row in table("Many programs")}
        before = names(" ".join(rows)[:" ".join(rows).index("`fingerprint`")])
        for command, flags in (("plan", ()), ("simulate", ()), ("predict", ("--settings", "s.txt")), ("tune", ("--plans", 1))):
            run = self.run_toolpace(command, "a.ngc", *flags, "--csv", "-")
            told = before + names(re.sub(r"\(.*?\)", "", rows[f"`{command}`"])) + ["fingerprint", "files"]
            self.assertEqual(run.out.decode().splitlines()[0].split(","), told)
        part = TEXT.split("## Many programs\n", 1)[1].split("\n## ", 1)[0]
        for key in self.run_toolpace("plan", "a.ngc", "--results", "r.csv", "--json").json():
            self.assertRegex(part.split("JSON: ", 1)[1], rf"\b{key}\b")

    def test_every_key_of_rewrite_is_told(self):
        run = self.run_toolpace("rewrite", self.file("a.ngc", PROGRAM), "-o", "b.ngc", "--json")
        told = {key for row in table("JSON of rewrite") for key in names(row[0])}
        self.assertEqual(told, set(run.json()))

    def test_every_key_of_a_comparison_is_told(self):
        self.file("a.ngc", PROGRAM)
        self.run_toolpace("simulate", "a.ngc", "--trace", "t.csv")
        told = {key for row in table("JSON of compare") for key in names(row[0])}
        run = self.run_toolpace("compare", "a.ngc", "t.csv", "--json")
        self.assertEqual(told, set(run.json()))
        told = {key for row in table("JSON of identify") for key in names(row[0])}
        self.assertEqual(told, set(self.run_toolpace("identify", "a.ngc", "t.csv", "--json").json()))
        self.assertIn((self.folder / "t.csv").read_text().splitlines()[0], TEXT)

    def test_columns_are_those_that_are_written(self):
        self.file("a.ngc", PROGRAM)
        blocks = self.run_toolpace("blocks", "a.ngc").out.decode().splitlines()[0]
        setpoints = self.run_toolpace("plan", "a.ngc", "--setpoints", "-").out.decode().splitlines()[0]
        self.assertIn(blocks, TEXT)
        self.assertIn(setpoints, TEXT.replace("[,a_deg,b_deg,c_deg]", ""))


if __name__ == "__main__":
    unittest.main()
