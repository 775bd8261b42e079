"""The handbook: its commands run, its links lead somewhere, and what is made for man and shells is what the program takes."""

import json
import pathlib
import re
import subprocess
import sys
import unittest

from command_line import BAD_USAGE, PROGRAM, SOURCE_DIR
from documents import DocumentTest

DOCS = SOURCE_DIR / "docs"
PAGES = sorted((DOCS / "handbook").glob("*.md"))
sys.path.insert(0, str(DOCS))


class Handbook(DocumentTest):
    def test_every_command_runs(self):
        run = 0
        for page in PAGES:
            if page.name == "machinist-zh.md":  # the same commands as in English, see below
                continue
            with self.subTest(page=page.name):
                run += self.run_commands_of(page.read_text())
        self.assertGreater(run, 30)

    def test_no_page_is_left_out(self):
        index = (DOCS / "index.md").read_text()
        self.assertEqual(sorted(re.findall(r"^handbook/([\w-]+)$", index, re.M)), sorted(page.stem for page in PAGES))

    def test_the_machinists_hour_is_the_same_in_both_languages(self):
        both = [re.findall(r"^    (\S.*)$", (DOCS / "handbook" / name).read_text(), re.M) for name in ("machinist.md", "machinist-zh.md")]
        self.assertEqual(*both)

    def test_links_and_pictures_lead_somewhere(self):
        drawn = re.search(r"for draw in \((.*)\):", (DOCS / "make_pictures.py").read_text())[1].split(", ")
        for page in PAGES:
            text = page.read_text()
            for link in re.findall(r"\{doc\}`([\w-]+)`", text):
                self.assertIn(link, [other.stem for other in PAGES])
            for picture in re.findall(r"\]\(pictures/(\w+)\.svg\)", text):
                self.assertIn(picture, drawn)

    def test_the_numbers_of_the_first_hour(self):
        run = self.run_toolpace("plan", "examples/nc/pocket.ngc", "--machine", "resources/machines/mill-3axis.toml", "--json").json()
        text = (DOCS / "handbook" / "machinist.md").read_text()
        self.assertIn(f"{run['blocks']} blocks, {run['path_length_mm']:.1f} mm, a cycle time of {run['cycle_time_s']:.2f} s", text)
        self.assertIn(f"feed does for {100 * run['time_by_limit_s']['feed'] / run['cycle_time_s']:.0f} %", text)


class Reference(DocumentTest):
    """What docs/make_reference.py writes."""

    def setUp(self):
        super().setUp()
        subprocess.run([sys.executable, "-B", DOCS / "make_reference.py", PROGRAM, self.folder / "out"], check=True)
        self.grammar = json.loads(self.run_toolpace("--grammar").out)

    def complete(self, *words):
        script = f"""compopt() {{ :; }}; . out/toolpace.bash; COMP_WORDS=({' '.join(words)} ''); COMP_CWORD={len(words)}; _toolpace
                     printf '%s\\n' "${{COMPREPLY[@]}}\""""
        return subprocess.run(["bash", "-c", script], cwd=self.folder, check=True, capture_output=True, text=True).stdout.split()

    def test_every_command_has_a_page_with_all_its_flags(self):
        for command in self.grammar["commands"]:
            page = (self.folder / "out/man1" / f"toolpace-{command['name']}.1").read_text().replace("\\-", "-")
            for flag in command["flags"]:
                self.assertIn(flag["name"] + "\\fR", page)
        self.assertIn("toolpace-tune", (self.folder / "out/man1/toolpace.1").read_text().replace("\\-", "-"))

    def test_shells_complete_commands_flags_and_names(self):
        self.assertEqual(self.complete("toolpace")[:12], [c["name"] for c in self.grammar["commands"]])
        self.assertIn("seven-phase", self.complete("toolpace", "plan", "--law"))
        self.assertIn("examples", self.complete("toolpace", "plan"))

    def test_names_that_are_completed_are_those_that_are_taken(self):
        from make_reference import VALUES
        settings = ["--settings", self.file("s.txt", "$110=1000\n")]
        for flag, values in VALUES.items():
            command = next(c["name"] for c in self.grammar["commands"] if flag in [f["name"] for f in c["flags"]])
            needs = settings if command == "predict" else ["-o", "o.ngc"] if command == "rewrite" else []
            run = self.run_toolpace(command, "examples/nc/helix.ngc", flag, "nonsense", *needs, "--json")
            self.assertEqual(run.code, BAD_USAGE, (flag, run.err))
            told = re.findall(r"[\w-]+", run.json()["error"]["remedy"].removeprefix("give one of"))
            if flag == "--lookahead":
                told = told[-1:]
            self.assertEqual(sorted(values.split()), sorted(told), flag)


if __name__ == "__main__":
    unittest.main()
