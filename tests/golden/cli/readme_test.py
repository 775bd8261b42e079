"""The README's commands run, and no plan is slower than its figures (docs/handbook/figures.md) say."""

import re
import unittest

from command_line import FINE, SOURCE_DIR
from documents import DocumentTest

README = (SOURCE_DIR / "README.md").read_text()
FIGURES = (SOURCE_DIR / "docs/handbook/figures.md").read_text()


class Readme(DocumentTest):
    def cycle_time(self, *arguments):
        run = self.run_toolpace("plan", *arguments, "--bound", "--json")
        self.assertEqual(run.code, FINE, run.err)
        return run.json()["cycle_time_s"], run.json()["bound_s"]

    def test_every_command_runs(self):
        self.assertGreaterEqual(self.run_commands_of(README), 7)

    def test_it_is_short_and_its_links_lead_somewhere(self):
        self.assertLess(len(README.splitlines()), 150)
        for link in re.findall(r"\]\(([^)#]+)\)", README):
            self.assertTrue((SOURCE_DIR / link).exists(), link)

    def test_the_first_result_is_what_it_says(self):
        mill = ["plan", "examples/nc/pocket.ngc", "--machine", "resources/machines/mill-3axis.toml", "--json"]
        plan, faster = self.run_toolpace(*mill).json(), self.run_toolpace(*mill, "--corner", "blend", "--ramps", "span").json()
        saved = plan["cycle_time_s"] - faster["cycle_time_s"]
        self.assertIn(f"{plan['cycle_time_s']:.2f} s, of which the programmed feed holds it for "
                      f"{100 * plan['time_by_limit_s']['feed'] / plan['cycle_time_s']:.0f} %", README)
        self.assertIn(f"saves {saved:.1f} s", README)

    def test_plans_are_as_fast_as_the_table_says(self):
        butterfly = ["examples/nc/butterfly.ngc", "--am", "294.2", "--jm", "3e4", "--corner-step-mm-s"]
        programs = ([*butterfly, "0.739"], [*butterfly, "1e9"], ["examples/nc/blocks20.ngc"])
        rows = re.findall(r"^\| `(--law [^`]*)`.*?\| ([\d.]+) s \| ([\d.]+) s \| ([\d.]+) s \|$", FIGURES, re.M)
        bounds = re.search(r"^\| bound \| ([\d.]+) s \| ([\d.]+) s \| ([\d.]+) s \|$", FIGURES, re.M).groups()
        self.assertEqual(len(rows), 3)
        for law, *times in rows:
            for program, time, bound in zip(programs, times, bounds):
                with self.subTest(law=law, program=program):
                    cycle, proven = self.cycle_time(*program, *law.split())
                    digit = 0.51 * 10 ** -len(time.split(".")[1])
                    self.assertLessEqual(cycle, float(time) + digit)
                    self.assertGreaterEqual(cycle, proven)
                    if law.startswith("--law seven-phase --ramps"):
                        self.assertGreaterEqual(proven, float(bound) - digit)

    def test_the_look_ahead_is_worth_what_it_says(self):
        slow, fast = (float(time) for time in re.search(
            r"takes ([\d.]+) s of feed at N = 1 and ([\d.]+) s at N = 8", " ".join(FIGURES.split())).groups())
        for depth, time in ((1, slow), (8, fast)):
            run = self.run_toolpace("plan", "examples/nc/butterfly.ngc", "--am", "294.2", "--jm", "1e6", "--period-ms", "4",
                                    "--lookahead", depth, "--json")
            self.assertAlmostEqual(run.json()["feed_time_s"], time, delta=0.0051)


if __name__ == "__main__":
    unittest.main()
