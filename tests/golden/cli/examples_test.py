"""Every example on every machine: planned, written, read back and proven; and verify catches what is wrong."""

import unittest

from command_line import BAD_INPUT, BAD_USAGE, EXAMPLES, FILE_TROUBLE, FINE, LIMIT_BROKEN, MACHINES, CommandLineTest

MILL = MACHINES / "mill-3axis.toml"


class Examples(CommandLineTest):
    def prove_all(self, *flags, one_machine_each=False):
        programs, machines = sorted(EXAMPLES.iterdir()), sorted(MACHINES.glob("*.toml"))
        # Programs about the tool's tip are for the machine of their name alone; one of those machines is for all others, too.
        blades = [program for program in programs if program.name.startswith("blade-")]
        others = [m for m in machines if m.stem not in ("trunnion-ac", "trunnion-bc", "head-bc", "nutating-45")]
        self.assertEqual(len(blades), 5)
        self.assertGreaterEqual((len(programs) - len(blades)) * len(others), 32)
        for number, program in enumerate(programs):
            machines = [others[number % len(others)]] if one_machine_each else others
            for machine in [MACHINES / f"{program.stem[6:]}.toml"] if program in blades else machines:
                with self.subTest(program=program.name, machine=machine.name, flags=flags):
                    run = self.run_toolpace("plan", program, "--machine", machine, *flags, "--setpoints", "out.npy", "--verify",
                                            "--json")
                    self.assertEqual(run.code, FINE, run.err + run.out.decode())
                    plan = run.json()
                    self.assertEqual(plan["violations"], 0)
                    self.assertGreater(plan["cycle_time_s"], 0.3)

    def test_each_keeps_every_limit_on_every_machine(self):
        self.prove_all()

    def test_each_keeps_every_limit_with_ramps_inside_blocks(self):
        self.prove_all("--ramps", "block", "--law", "quintic", one_machine_each=True)

    def test_each_keeps_every_limit_with_ramps_across_blocks(self):
        self.prove_all("--ramps", "span", "--law", "seven-phase", one_machine_each=True)


class Verify(CommandLineTest):
    def plan(self, *flags, name="out.csv"):
        run = self.run_toolpace("plan", EXAMPLES / "helix.ngc", "--machine", MILL, "--setpoints", name, *flags)
        self.assertEqual(run.code, FINE, run.err)
        return name

    def test_a_sound_file_passes(self):
        for name in ("out.csv", "out.npy", "out.npz"):
            run = self.run_toolpace("verify", self.plan(name=name), "--machine", MILL, "--program", EXAMPLES / "helix.ngc",
                                    "--tolerance-mm", "0.001")
            self.assertEqual(run.code, FINE, run.err + run.out.decode())

    def test_a_file_planned_for_a_stronger_machine_fails(self):
        self.run_toolpace("plan", EXAMPLES / "helix.ngc", "--machine", MACHINES / "five-axis.toml", "--setpoints", "fast.csv")
        run = self.run_toolpace("verify", "fast.csv", "--machine", MACHINES / "stepper-router.toml")
        self.assertEqual(run.code, LIMIT_BROKEN, run.err)

    def test_one_wrong_digit_is_caught(self):
        name = self.plan()
        rows = (self.folder / name).read_text().splitlines()
        cells = rows[len(rows) // 2].split(",")
        cells[1] = str(float(cells[1]) + 0.01)
        rows[len(rows) // 2] = ",".join(cells)
        self.file("wrong.csv", "\n".join(rows) + "\n")
        self.assertEqual(self.run_toolpace("verify", "wrong.csv", "--machine", MILL).code, LIMIT_BROKEN)

    def test_a_missing_row_is_caught(self):
        rows = (self.folder / self.plan()).read_text().splitlines()
        del rows[len(rows) // 2]
        self.file("gap.csv", "\n".join(rows) + "\n")
        self.assertIn(self.run_toolpace("verify", "gap.csv", "--machine", MILL).code, (LIMIT_BROKEN, BAD_INPUT))

    def test_what_cannot_be_judged_is_told(self):
        self.expect_failure(self.run_toolpace("verify", "nowhere.csv", "--machine", MILL), FILE_TROUBLE, "nowhere.csv")
        self.expect_failure(self.run_toolpace("verify", self.file("empty.csv", ""), "--machine", MILL), BAD_INPUT, "empty.csv")
        header = "t_s,x_mm,y_mm,z_mm,v_mm_s,a_mm_s2,j_mm_s3,line\n"
        bad = self.file("bad.csv", header + "0,0,0,0,0,0,0,1\n0.001,nan,0,0,0,0,0,1\n")
        self.expect_failure(self.run_toolpace("verify", bad, "--machine", MILL), BAD_INPUT, "bad.csv:3")
        self.assertEqual(self.run_toolpace("verify", self.plan()).code, BAD_USAGE)


if __name__ == "__main__":
    unittest.main()
