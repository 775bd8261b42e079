"""Every command of the command line with every kind of output, and the files that they read."""

import dataclasses
import math
import os
import pathlib
import subprocess

PROGRAM = os.environ["TOOLPACE"]
WINDOW = os.environ.get("TOOLPACE_WINDOW_EXPORT", "")
SOURCE_DIR = pathlib.Path(os.environ["TOOLPACE_SOURCE_DIR"])
FORMATS = ("csv", "npy", "npz", "halstream", "semicolon.csv")


@dataclasses.dataclass(frozen=True)
class Command:
    arguments: tuple
    target: str = ""  # the file it writes
    stdin: str = ""  # an input that comes through a pipe
    program: str = PROGRAM

    def __str__(self):
        return pathlib.Path(self.program).name + " " + " ".join(self.arguments) + (f" < {self.stdin}" if self.stdin else "")

    def wants_json(self):
        return "--json" in self.arguments


def plan(*flags, target="", stdin=""):
    arguments = ("plan", "-" if stdin else "part.ngc", "--machine", "mill.toml", *flags)
    return Command(arguments + (("--setpoints", target) if target else ()), "" if target == "-" else target, stdin)


def every_command():
    yield plan()
    yield plan("--bound", "--json")
    yield plan(target="-")
    yield plan(target="-", stdin="part.ngc")
    for ending in FORMATS:
        yield plan(target=f"out.{ending}")
    yield plan("--verify", "--json", target="out.npz")
    yield plan("--timer-hz", "1e6", target="out.pulses.csv")
    yield plan("--ramps", "span", "--law", "seven-phase", "--corner", "blend", "--axis-derivatives", target="out.csv")
    yield Command(("plan", "calls.ngc", "--tools", "tool.tbl", "--parameters", "values.var", "--sub-path", "subs",
                   "--setpoints", "out.csv"), "out.csv")
    yield Command(("plan", "short.ngc", "--corner", "smooth", "--setpoints", "out.npy"), "out.npy")
    yield Command(("plan", "line.csv", "--json"))
    yield Command(("blocks", "part.ngc"))
    yield Command(("blocks", "part.ngc", "--csv", "out.csv"), "out.csv")
    yield Command(("blocks", "part.ngc", "--json"))
    yield Command(("move", "--law", "quintic", "--length", "40", "--feed", "50", "--start", "0", "--end", "0", "--am",
                   "3000", "--jm", "1e6", "--json"))
    yield Command(("move", "--law", "five-phase-time", "--length", "4000", "--feed", "100", "--start", "10", "--end", "20",
                   "--tacc", "35", "--tdec", "20"))
    steps = ("steps", "--steps", "40000", "--speed", "20000", "--tacc-ms", "100", "--tdec-ms", "100", "--timer-hz", "1e6")
    yield Command(steps)
    yield Command((*steps, "--format", "c", "-o", "out.h"), "out.h")
    for ending in FORMATS:
        yield Command(("verify", f"part.{ending}", "--machine", "mill.toml"))
    yield Command(("verify", "part.csv", "--machine", "mill.toml", "--program", "part.ngc", "--tolerance-mm", "0.01", "--json"))
    yield Command(("verify", "-", "--machine", "mill.toml"), stdin="part.csv")
    yield Command(("simulate", "part.ngc", "--machine", "mill.toml"))
    yield Command(("simulate", "part.ngc", "--machine", "mill.toml", "--json"))
    yield Command(("simulate", "part.ngc", "--machine", "mill.toml", "--trace", "out.csv"), "out.csv")
    yield Command(("report", "part.ngc", "--machine", "mill.toml", "-o", "out.html"), "out.html")


def every_export():
    """What the window writes, but PDF, in which stands when it was made."""
    for what, target in (("setpoints", "out.csv"), ("setpoints", "out.npz"), ("setpoints", "out.pulses.csv"),
                         ("plots", "out.svg"), ("contour", "out.png"), ("window", "out.png"), ("report", "out.html"),
                         ("program", "out.ngc"), ("machine", "out.toml")):
        yield Command((what, "short.ngc", "mill.toml", target), target, program=WINDOW)


def part():
    """Large enough for several pieces on each way in and out: 5 s of motion, and remarks."""
    moves = [f"G1 X{20 * math.cos(0.3 * i):.3f} Y{20 * math.sin(0.3 * i):.3f}" for i in range(12)]
    remarks = "(what stands here moves nothing, and fills the page that it stands on)\n" * 150
    return "G21 G90 G94 F1500\n" + remarks.join(f"{move}\n" for move in moves) + "G2 X0 Y0 R30\nM2\n"


def write_inputs(folder):
    """The files that the commands read. @return their names"""
    (folder / "subs").mkdir()
    for name, text in {
            "part.ngc": part(),
            "calls.ngc": "G21 G90 G94 F600\nG10 L2 P1 X1\nT1 M6 G43\nG1 X[#100] Y1\no<side> call [5]\nG1 X0\nM2\n",
            "subs/side.ngc": "o<side> sub\nG1 X[#1] Z-1\no<side> endsub\nM2\n",
            "tool.tbl": "T1 P1 D6.0 Z10.0 ;mill\n",
            "values.var": "100\t2.5\n5220\t1\n",
            "short.ngc": "G21 G90 G94 F1200\nG1 X2\nY2\nX0\nM2\n",
            "line.csv": "x_mm,y_mm,feed_mm_min\n0,0,600\n5,0,600\n5,5,600\n",
    }.items():
        (folder / name).write_text(text)
    machine = (SOURCE_DIR / "resources" / "machines" / "stepper-router.toml").read_text()
    (folder / "mill.toml").write_text(machine)
    for ending in FORMATS:
        subprocess.run([PROGRAM, "plan", "part.ngc", "--machine", "mill.toml", "--setpoints", f"part.{ending}"], cwd=folder,
                       check=True, stdout=subprocess.DEVNULL)
    return sorted(path.relative_to(folder) for path in folder.rglob("*") if path.is_file())
