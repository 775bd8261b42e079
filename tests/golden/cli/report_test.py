"""toolpace report and toolpace simulate, as people run them."""

import html.parser
import unittest

from command_line import BAD_INPUT, EXAMPLES, FILE_TROUBLE, FINE, MACHINES, CommandLineTest

MILL = MACHINES / "mill-3axis.toml"


class Page(html.parser.HTMLParser):
    """What a page fetches from outside, and how many pictures it draws itself."""

    def __init__(self):
        super().__init__()
        self.fetched, self.pictures = [], 0

    def handle_starttag(self, tag, attributes):
        self.pictures += tag == "svg"
        self.fetched += [value for name, value in attributes if name in ("src", "href") and not (value or "").startswith("#")]


class Report(CommandLineTest):
    def report(self, program, *more):
        return self.run_toolpace("report", program, "-o", "report.html", *more)

    def test_it_is_one_page_that_fetches_nothing(self):
        run = self.report(EXAMPLES / "medal-zh.ngc", "--machine", MILL)
        self.assertEqual(run.code, FINE, run.err)
        page = Page()
        page.feed((self.folder / "report.html").read_text(encoding="utf-8"))
        self.assertEqual(page.fetched, [])
        self.assertGreaterEqual(page.pictures, 2)

    def test_a_name_cannot_break_out_of_the_page(self):
        name = self.file("<script>alert(1)<&script>.ngc", "G21 G90 G94\nG1 X10 F3000\nM2\n")
        self.assertEqual(self.report(name).code, FINE)
        self.assertNotIn("<script>alert(1)", (self.folder / "report.html").read_text(encoding="utf-8"))

    def test_a_program_that_cannot_be_read_leaves_no_page(self):
        for program, code in ((self.file("bad.ngc", "G1 X10\nM2\n"), BAD_INPUT), ("nowhere.ngc", FILE_TROUBLE)):
            self.expect_failure(self.report(program), code, program)
            self.assertFalse((self.folder / "report.html").exists())


class Simulate(CommandLineTest):
    def test_the_contour_error_is_small_beside_the_lag(self):
        run = self.run_toolpace("simulate", EXAMPLES / "helix.ngc", "--machine", MILL, "--json")
        self.assertEqual(run.code, FINE, run.err)
        servo = run.json()["servo"]
        self.assertGreater(servo["max_contour_error_mm"], 0)
        self.assertLess(servo["max_contour_error_mm"], servo["max_lag_mm"])
        self.assertLessEqual(servo["rms_contour_error_mm"], servo["max_contour_error_mm"])

    def test_a_program_that_cannot_be_read_is_told(self):
        self.expect_failure(self.run_toolpace("simulate", self.file("bad.ngc", "G1 X10\nM2\n")), BAD_INPUT, "bad.ngc:1:")
        self.expect_failure(self.run_toolpace("simulate", "nowhere.ngc"), FILE_TROUBLE, "nowhere.ngc")


if __name__ == "__main__":
    unittest.main()
