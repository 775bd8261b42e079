"""The scripts of examples/python run, and print what they promise."""

import doctest
import os
import re
import subprocess
import sys
import unittest
import xml.etree.ElementTree

from command_line import PATIENCE_S, SOURCE_DIR, CommandLineTest

SCRIPTS = SOURCE_DIR / "examples" / "python"


class Scripts(CommandLineTest):
    tried = set()

    def run_script(self, name, *arguments):
        Scripts.tried.add(name)
        done = subprocess.run([sys.executable, "-B", SCRIPTS / name, *arguments], cwd=self.folder, capture_output=True, text=True,
                              timeout=PATIENCE_S)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def rows(self, text):
        return [row.split() for row in text.splitlines()]

    def test_zheng_with_the_peak_of_the_papers_own_formula(self):
        rows = self.rows(self.run_script("zheng_table.py"))
        self.assertEqual([row[1] for row in rows[1:]], ["100.0000", "92.6667"])

    def test_ning_a_deeper_look_ahead_is_never_slower(self):
        rows = self.rows(self.run_script("ning_lookahead.py"))[1:]
        quintic = [float(row[1]) for row in rows]
        self.assertEqual(quintic, sorted(quintic, reverse=True))
        self.assertAlmostEqual(quintic[-1], 368.981, delta=0.0015)

    def test_the_butterfly_stays_within_its_tolerance(self):
        rows = {row[0]: row for row in self.rows(self.run_script("butterfly_corners.py"))[1:]}
        self.assertEqual(list(rows), ["stop", "servo", "junction", "blend"])
        self.assertLess(float(rows["blend"][1]), float(rows["servo"][1]))
        self.assertLessEqual(float(rows["blend"][7]), 5.0)

    def test_a_sweep_makes_a_picture(self):
        rows = self.rows(self.run_script("sweep.py", "out.svg"))
        for row in rows[1:6]:
            times = [float(time) for time in row[1:] if time != "s"]
            self.assertEqual(times, sorted(times, reverse=True))  # more jerk is never slower
        picture = xml.etree.ElementTree.parse(self.folder / "out.svg").getroot()
        self.assertEqual(len(picture.findall("{*}polyline")), 5)

    def test_a_drive_is_found_again(self):
        text = self.run_script("identify_trace.py")
        gain = float(re.search(r"X position_gain +([\d.]+)", text)[1])
        self.assertAlmostEqual(gain, 60, delta=0.1)

    @classmethod
    def tearDownClass(cls):
        assert cls.tried == {name for name in os.listdir(SCRIPTS) if name.endswith(".py")}, "a script is not tried"


class Handbook(CommandLineTest):
    def test_what_the_handbook_types_is_answered_so(self):
        here = os.getcwd()
        self.addCleanup(os.chdir, here)
        os.chdir(SOURCE_DIR)
        failed, tried = doctest.testfile(str(SOURCE_DIR / "docs/handbook/engineer.md"), module_relative=False)
        self.assertEqual(failed, 0)
        self.assertGreater(tried, 5)


if __name__ == "__main__":
    unittest.main()
