"""import toolpace: the same bytes as the command line, arrays without copies, errors with their place, and a free interpreter."""

import ast
import gc
import inspect
import json
import os
import pathlib
import re
import signal
import threading
import tomllib
import unittest

import numpy
import toolpace
from command_line import EXAMPLES, LIMIT_BROKEN, MACHINES, SOURCE_DIR, CommandLineTest

MILL = MACHINES / "mill-3axis.toml"
UNLIKE = {"plan_wall_s"}  # no two runs take the same time


class ModuleTest(CommandLineTest):
    def setUp(self):
        super().setUp()
        here = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, here)

    def assert_same(self, result, *words):
        """The result is what the command line prints with these words."""
        run = self.run_toolpace(*words, "--json")
        self.assertEqual(result.exit_code, run.code, run.err)
        told = run.json()
        self.assertEqual({k: v for k, v in result.summary.items() if k not in UNLIKE},
                         {k: v for k, v in told.items() if k not in UNLIKE})
        return told


class SameBytes(ModuleTest):
    def compare(self, program, flags, **keywords):
        words = ["plan", program, *flags]
        plan = toolpace.plan(program, **keywords)
        told = self.assert_same(plan, *words)
        self.run_toolpace(*words, "--setpoints", "a.npy")
        self.run_toolpace(*words, "--setpoints", "a.csv")
        self.assertEqual(plan.setpoints.tobytes(), numpy.load("a.npy").tobytes())
        rows = pathlib.Path("a.csv").read_text().splitlines()
        self.assertEqual([*plan.columns, "line"], rows[0].split(","))
        self.assertEqual([str(line) for line in plan.lines], [row.rsplit(",", 1)[1] for row in rows[1:]])
        self.assertEqual(len(plan.setpoints), told["setpoints"])

    def test_every_example_is_planned_to_the_same_bytes(self):
        programs = sorted(EXAMPLES.iterdir())
        self.assertGreaterEqual(len(programs), 8)
        for program in programs:
            is_about_tip = program.name.startswith("blade-")  # for the machine of its name alone
            machine = MACHINES / (f"{program.stem[6:]}.toml" if is_about_tip else "five-axis.toml")
            with self.subTest(program=program.name):
                if not is_about_tip:
                    self.compare(program, [])
                self.compare(program, ["--machine", machine, "--law", "seven-phase", "--ramps", "block"],
                             machine=machine, law="seven-phase", ramps="block")
        machine = MACHINES / "five-axis.toml"
        self.compare(EXAMPLES / "helix.ngc", ["--machine", machine, "--law", "seven-phase", "--ramps", "span"],
                     machine=machine, law="seven-phase", ramps="span")

    def test_what_is_no_value_of_a_flag_is_refused_and_lists_are_one_word(self):
        program = EXAMPLES / "blocks20.ngc"
        for call in (lambda: toolpace.plan(program, verify="no"), lambda: toolpace.replan(5)):
            with self.assertRaises(toolpace.UsageError):
                call()
        told = toolpace.tune(program, vary=["am", "jm"], plans=2)
        self.assertEqual(told.summary["plans_evaluated"], 2)

    def test_many_programs_are_a_table(self):
        programs = [EXAMPLES / "butterfly.ngc", EXAMPLES / "blocks20.ngc"]
        table = toolpace.plan(programs, machine=MILL)
        self.assertEqual([row["cycle_time_s"] for row in table.rows], [toolpace.plan(p, machine=MILL).cycle_time_s for p in programs])
        with self.assertRaises(toolpace.UsageError):
            toolpace.replan(toolpace.plan(programs[0]), results="r.csv")

    def test_every_flag_and_toggle_is_passed_on(self):
        program = EXAMPLES / "butterfly.ngc"
        plan = toolpace.plan(program, machine=MILL, am=1500, corner="blend", tolerance_mm=0.02, verify=True, bound=True, lookahead=8,
                             work_offset=["G54=1,2,3"], setpoints="b.csv", axis_derivatives=True)
        words = ["plan", program, "--machine", MILL, "--am", 1500, "--corner", "blend", "--tolerance-mm", 0.02, "--verify", "--bound",
                 "--lookahead", 8, "--work-offset", "G54=1,2,3", "--setpoints", "c.csv", "--axis-derivatives"]
        self.assert_same(plan, *words)
        self.assertEqual(pathlib.Path("b.csv").read_bytes(), pathlib.Path("c.csv").read_bytes())

    def test_planning_again_is_planning(self):
        self.file("a.ngc", (EXAMPLES / "butterfly.ngc").read_text())
        first = toolpace.plan("a.ngc", am=294.2, jm=3e4)
        wanted = toolpace.plan("a.ngc", am=294.2, jm=3e4, law="seven-phase", lookahead=8)
        os.rename("a.ngc", "elsewhere.ngc")  # it is not read again
        again = toolpace.replan(first, law="seven-phase", lookahead=8)
        self.assertEqual(again.setpoints.tobytes(), wanted.setpoints.tobytes())
        self.assertEqual({**again.summary, "plan_wall_s": 0}, {**wanted.summary, "plan_wall_s": 0})
        back = toolpace.replan(again, law=None, lookahead=None)
        self.assertEqual(back.setpoints.tobytes(), first.setpoints.tobytes())
        with self.assertRaises(toolpace.UsageError) as caught:
            toolpace.replan(first, dialect="grbl")
        self.assertEqual(caught.exception.code, "replan-reads-nothing")

    def test_moves_and_steps(self):
        self.assert_same(toolpace.move(law="five-phase-time", length=4000, feed=100, start=10, end=20, tacc=35, tdec=20),
                         *"move --law five-phase-time --length 4000 --feed 100 --start 10 --end 20 --tacc 35 --tdec 20".split())
        words = "steps --steps 1000 --speed 2000 --tacc-ms 100 --tdec-ms 50 --timer-hz 1e6".split()
        pulses = toolpace.steps(steps=1000, speed=2000, tacc_ms=100, tdec_ms=50, timer_hz=1e6)
        self.assert_same(pulses, *words)
        rows = self.run_toolpace(*words).out.decode().split()
        self.assertEqual([f"{k},{ticks}" for k, ticks in enumerate(pulses.intervals, 1)], rows[1:])
        self.assertEqual(pulses.intervals.sum(), pulses.ticks)

    def test_what_is_written_is_proven(self):
        plan = toolpace.plan(EXAMPLES / "butterfly.ngc", machine=MILL, setpoints="a.csv")
        self.assert_same(toolpace.verify("a.csv", machine=MILL, program=EXAMPLES / "butterfly.ngc", tolerance_mm=0.01), "verify",
                         "a.csv", "--machine", MILL, "--program", EXAMPLES / "butterfly.ngc", "--tolerance-mm", 0.01)
        self.assertTrue(toolpace.verify(plan.setpoints, machine=MILL, program=EXAMPLES / "butterfly.ngc").passes)
        wrong = plan.setpoints.copy()
        wrong[len(wrong) // 2, 1] += 0.01
        judged = toolpace.verify(wrong, machine=MILL, program=EXAMPLES / "butterfly.ngc")
        self.assertEqual((judged.passes, judged.exit_code), (False, LIMIT_BROKEN))

    def test_the_other_commands(self):
        butterfly, grbl = EXAMPLES / "butterfly.ngc", SOURCE_DIR / "examples/settings/grbl.txt"
        self.assert_same(toolpace.predict(butterfly, settings=grbl, baud=115200), "predict", butterfly, "--settings", grbl, "--baud", 115200)
        self.assert_same(toolpace.simulate(butterfly, machine=MILL, trace="t.csv"), "simulate", butterfly, "--machine", MILL, "--trace", "t.csv")
        self.assert_same(toolpace.tune(butterfly, machine=MILL, vary="law,ramps", plans=6), "tune", butterfly, "--machine", MILL, "--vary",
                         "law,ramps", "--plans", 6)
        self.assert_same(toolpace.compare(butterfly, "t.csv", machine=MILL), "compare", butterfly, "t.csv", "--machine", MILL)
        blocks = EXAMPLES / "blocks20.ngc"
        self.run_toolpace("simulate", blocks, "--trace", "t.csv")
        self.assert_same(toolpace.identify(blocks, "t.csv"), "identify", blocks, "t.csv")
        toolpace.rewrite(EXAMPLES / "rosette.ngc", output="a.ngc")
        self.run_toolpace("rewrite", EXAMPLES / "rosette.ngc", "-o", "b.ngc")
        self.assertEqual(pathlib.Path("a.ngc").read_bytes(), pathlib.Path("b.ngc").read_bytes())


class Arrays(ModuleTest):
    def test_a_polyline_of_columns_is_planned_as_its_file(self):
        angle = numpy.linspace(0, 6, 200)
        columns = {"x_mm": 10 * numpy.cos(angle), "y_mm": 10 * numpy.sin(angle), "feed_mm_min": numpy.full(200, 2400.0)}
        numpy.savetxt("a.csv", numpy.column_stack(list(columns.values())), "%.17g", ",", header=",".join(columns), comments="")
        plan = toolpace.plan(columns, corner="blend")
        self.assertEqual(plan.setpoints.tobytes(), toolpace.plan("a.csv", corner="blend").setpoints.tobytes())
        self.assertEqual(toolpace.replan(plan, corner="stop", setpoints="b.npy").setpoints.tobytes(), numpy.load("b.npy").tobytes())
        with self.assertRaises(toolpace.InputError):
            toolpace.plan({"u": [0, 1]})

    def test_columns_are_views_of_the_one_array(self):
        plan = toolpace.plan(EXAMPLES / "butterfly.ngc")
        self.assertIs(plan.setpoints, plan.setpoints)
        self.assertIsNotNone(plan.setpoints.base)
        self.assertTrue(numpy.shares_memory(plan.column("x_mm"), plan.setpoints))
        self.assertEqual(plan.column("t_s")[3], 0.003)
        with self.assertRaises(KeyError):
            plan.column("u_mm")

    def test_columns_of_the_tip_are_those_of_the_file(self):
        plan = toolpace.plan(EXAMPLES / "blade-head-bc.nc", machine=MACHINES / "head-bc.toml", corner="servo", ramps="block",
                             tip=True, setpoints="a.csv")
        self.assertEqual(plan.columns[-3:], ("tip_x_mm", "tip_y_mm", "tip_z_mm"))
        self.assertTrue((plan.column("tip_x_mm") == numpy.genfromtxt("a.csv", delimiter=",", names=True)["tip_x_mm"]).all())
        again = toolpace.replan(plan, corner="stop")
        self.assertEqual(again.columns, plan.columns)

    def test_an_array_outlives_its_plan(self):
        rows = toolpace.plan(EXAMPLES / "butterfly.ngc").setpoints
        kept = rows.copy()
        gc.collect()
        numpy.zeros_like(rows)[:] = 7.0
        self.assertTrue((rows == kept).all())


class Errors(ModuleTest):
    def test_a_refused_program_tells_the_place_and_the_remedy(self):
        name = self.file("bad.ngc", "G21 G90 G94\nG1 X10 F3000\nG2 X20 Y0 R1\nM2\n")
        with self.assertRaises(toolpace.InputError) as caught:
            toolpace.plan(name)
        told = self.run_toolpace("plan", name, "--json").json()
        error = caught.exception
        self.assertEqual((error.code, error.file, error.exit_code), ("program-refused", name, 3))
        self.assertEqual(error.diagnostics, told["diagnostics"])
        self.assertEqual(error.diagnostics[0]["line"], 3)
        self.assertIn("bad.ngc:3:", str(error))
        self.assertIsInstance(error, ValueError)

    def test_what_makes_no_sense(self):
        program = EXAMPLES / "butterfly.ngc"
        for code, keywords in (("bad-limit", {"am": -1}), ("bad-flag", {"law": "cubic"}), ("flag-unknown", {"laws": "quintic"}),
                               ("flag-value", {"am": True}), ("usage", {"am": "fast"})):
            with self.subTest(keywords), self.assertRaises(toolpace.UsageError) as caught:
                toolpace.plan(program, **keywords)
            self.assertEqual(caught.exception.code, code)
        for code, arguments, keywords in (("no-standard-streams", ["-"], {}), ("no-standard-streams", [program], {"setpoints": "-"}),
                                          ("flag-value", ["a\0.ngc"], {})):
            with self.subTest(keywords), self.assertRaises(toolpace.UsageError) as caught:
                toolpace.plan(*arguments, **keywords)
            self.assertEqual(caught.exception.code, code)
        with self.assertRaises(toolpace.UsageError) as caught:
            toolpace.plan(program, laws="quintic")
        self.assertEqual(caught.exception.remedy, "did you mean law?")
        with self.assertRaises(TypeError):
            toolpace.plan()

    def test_a_file_that_is_not_there(self):
        with self.assertRaises(toolpace.FileError) as caught:
            toolpace.plan("nowhere.ngc")
        self.assertIsInstance(caught.exception, OSError)
        self.assertEqual((caught.exception.file, caught.exception.exit_code), ("nowhere.ngc", 4))

    def test_a_move_that_cannot_be_made_tells_what_could(self):
        with self.assertRaises(toolpace.InputError) as caught:
            toolpace.move(law="trapezoid", length=1, feed=100, start=100, end=0, am=100)
        self.assertIsNotNone(caught.exception.attainable)

    def test_warnings_are_told_and_not_printed(self):
        self.file("m.toml", "[path]\nmax_speed_mm_s = 100\nmax_acceleration_mm_s2 = 3000\nmax_jerk_mm_s3 = 1e6\n"
                            "[axes.X]\ntravel_mm = [0, 5]\n")
        plan = toolpace.plan(self.file("a.ngc", "G21 G90 G94\nG1 X10 F3000\nM2\n"), machine="m.toml")
        self.assertIn("travel", plan.told)
        self.assertEqual(plan.warnings[0]["line"], 2)


class WhileItWorks(ModuleTest):
    """A search that would take hours."""

    def tune(self, **keywords):
        return toolpace.tune(EXAMPLES / "butterfly.ngc", machine=MILL, plans=1_000_000, **keywords)

    def test_control_c_stops_it(self):
        seen = []

        def progress(what, fraction):
            seen.append(what)
            if seen.count("tuning") == 3:
                os.kill(os.getpid(), signal.SIGINT)

        with self.assertRaises(KeyboardInterrupt):
            self.tune(output="best.toml", progress=progress)
        self.assertEqual(os.listdir(), [])

    def test_others_run_on_meanwhile_and_progress_may_end_it(self):
        counted, seen = [0], []
        stop = threading.Event()

        def count():
            while not stop.is_set():
                counted[0] += 1

        def progress(what, fraction):
            seen.append((what, fraction, counted[0]))
            if len(seen) == 5:
                raise RuntimeError("enough")

        thread = threading.Thread(target=count)
        thread.start()
        try:
            with self.assertRaisesRegex(RuntimeError, "enough"):
                self.tune(progress=progress)
        finally:
            stop.set()
            thread.join()
        self.assertEqual(len(seen), 5)
        self.assertGreater(seen[4][2], seen[0][2])
        self.assertTrue(all(0 <= fraction <= 1 for _, fraction, _ in seen))

    def test_plans_in_many_threads_are_the_same(self):
        found = [None] * 4

        def plan(k):
            found[k] = toolpace.plan(EXAMPLES / "pocket.ngc", machine=MILL).setpoints.tobytes()

        threads = [threading.Thread(target=plan, args=(k,)) for k in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(set(found)), 1)
        self.assertIsNotNone(found[0])


class Described(ModuleTest):
    def test_every_command_is_a_function_with_its_flags(self):
        grammar = json.loads(self.run_toolpace("--grammar").out)
        for command in grammar["commands"]:
            function = getattr(toolpace, command["name"])
            wanted = {flag["name"].lstrip("-").replace("-", "_").lower() for flag in command["flags"]} - {"json"}
            self.assertEqual(set(inspect.signature(function).parameters), wanted | {"progress"})
            for name in wanted:
                self.assertIn(f"  {name}", function.__doc__)
        self.assertEqual(grammar["version"].split(), [toolpace.__version__, *([f"({toolpace.__commit__})"] if toolpace.__commit__ else [])])

    def test_the_stubs_tell_the_same(self):
        tree = ast.parse((pathlib.Path(toolpace.__file__).parent / "__init__.pyi").read_text())
        functions = {node.name: node.args for node in tree.body if isinstance(node, ast.FunctionDef)}
        for name in set(toolpace.__all__) - {"replan"}:
            thing = getattr(toolpace, name)
            if not inspect.isfunction(thing):
                continue
            told = functions[name]
            self.assertEqual({a.arg for a in told.args + told.kwonlyargs}, set(inspect.signature(thing).parameters))
        self.assertTrue((pathlib.Path(toolpace.__file__).parent / "py.typed").exists())

    def test_what_pip_is_told_is_there(self):
        told = tomllib.loads((SOURCE_DIR / "pyproject.toml").read_text())
        build, project = told["tool"]["scikit-build"], told["project"]
        version = build["metadata"]["version"]
        found = re.search(version["regex"], (SOURCE_DIR / version["input"]).read_text())
        self.assertEqual(found["value"], toolpace.__version__)
        lists = (SOURCE_DIR / "python/CMakeLists.txt").read_text()
        for target in build["build"]["targets"]:
            self.assertRegex(lists, rf"(?:pybind11_add_module|add_custom_target)\({target} ")
        for component in build["install"]["components"]:
            self.assertIn(f"COMPONENT {component}", lists)
        for file in (project["readme"], project["license"]["file"]):
            self.assertTrue((SOURCE_DIR / file).exists())
        options = (SOURCE_DIR / "cmake/options.cmake").read_text()
        for option in build["cmake"]["define"]:
            self.assertIn(f"option({option} ", options)


if __name__ == "__main__":
    unittest.main()
