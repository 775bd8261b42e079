#!/usr/bin/env python3
"""The layering check itself finds what it must find."""

import pathlib
import tempfile
import unittest

import check_layering


class LayeringCheck(unittest.TestCase):
    def problems(self, files):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in files.items():
                path = root / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            return check_layering.problems_of(root)

    def test_an_earlier_room_is_fine(self):
        self.assertEqual(self.problems({"core/toolpace/plan/a.cpp": '#include "toolpace/law/law.h"\n#include <vector>\n'}), [])

    def test_a_later_room_is_refused(self):
        self.assertEqual(len(self.problems({"core/toolpace/law/a.h": '#include "toolpace/plan/plan.h"\n'})), 1)

    def test_qt_clocks_logging_and_threads_are_refused(self):
        for header in ("QString", "QtCore/QObject", "chrono", "iostream", "thread", "locale"):
            self.assertEqual(len(self.problems({"core/toolpace/base/a.h": f"#include <{header}>\n"})), 1, header)

    def test_threads_may_stand_in_pipeline(self):
        self.assertEqual(self.problems({"core/toolpace/pipeline/a.cpp": "#include <thread>\n"}), [])

    def test_verify_may_not_reach_plan_through_another_room(self):
        found = self.problems({"core/toolpace/verify/a.cpp": '#include "toolpace/sample/s.h"\n',
                               "core/toolpace/sample/s.h": '#include "toolpace/plan/p.h"\n'})
        self.assertEqual(len(found), 1)

    def test_the_command_line_knows_no_qt(self):
        self.assertEqual(len(self.problems({"app/cli/a.cpp": "#include <QString>\n"})), 1)

    def test_rooms_of_ui_include_earlier_ones_and_the_core(self):
        self.assertEqual(self.problems({"ui/panels/a.cpp": '#include "panels/a.h"\n#include "models/m.h"\n'
                                                           '#include "toolpace/plan/plan.h"\n#include <QWidget>\n'}), [])

    def test_a_model_may_not_include_a_panel(self):
        self.assertEqual(len(self.problems({"ui/models/a.h": '#include "panels/p.h"\n'})), 1)

    def test_the_preview_knows_nothing_of_the_plots(self):
        self.assertEqual(len(self.problems({"ui/preview/a.h": '#include "plots/p.h"\n'})), 1)

    def test_ui_knows_nothing_of_the_window_that_holds_it(self):
        self.assertEqual(len(self.problems({"ui/panels/a.h": '#include "studio/main_window.h"\n'})), 1)
        self.assertEqual(len(self.problems({"ui/windows/a.h": "#include <QWidget>\n"})), 1)


if __name__ == "__main__":
    unittest.main()
