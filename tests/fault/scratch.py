"""A folder in which a command runs under a fault, and what came of it."""

import dataclasses
import os
import pathlib
import resource
import struct
import subprocess

from commands import write_inputs

PATIENCE = 60  # s; what takes longer hangs
TALLY = struct.Struct("12Q")
OLD = b"as it was\n" * 10


@dataclasses.dataclass
class Run:
    code: int | None  # of the process; negative: the signal that ended it; None: it had to be ended
    out: bytes
    err: str
    target: bytes | None  # what lies there after the run
    left: list  # files that nobody asked for
    injected: int  # faults
    seen: tuple  # calls that could have been struck, by the numbers of kinds.py

    def result(self):
        """What has to be the same whenever the command says that all is well: all but the wall clock."""
        return [self.code, [line for line in self.out.split(b"\n") if b'"plan_wall_s"' not in line], self.target]


class Scratch:
    """Files that commands read in work/, temporaries in tmp/; outside of them what the tests themselves keep."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.work, self.temporary = self.folder / "work", self.folder / "tmp"
        self.tally, self.out = self.folder / "tally", self.folder / "stdout"
        self.work.mkdir()
        self.temporary.mkdir()
        self.inputs = {name: (self.work / name).read_bytes() for name in write_inputs(self.work)}
        self.environment = {"PATH": os.environ["PATH"], "LC_ALL": "C.UTF-8", "TMPDIR": str(self.temporary),
                            "QT_QPA_PLATFORM": "offscreen", "QT_LOGGING_RULES": "default.warning=false"}

    def run(self, command, kind, at, with_old=False):
        """Runs the command with the fault at its place, 0 = nowhere; with_old: the target is there already."""
        target = self.work / command.target if command.target else None
        if target and with_old:
            target.write_bytes(OLD)
        self.tally.write_bytes(bytes(TALLY.size))
        options = {"env": self.environment | self.faults(kind, at)}
        if kind.name == "size-limit" and at > 0:
            options["preexec_fn"] = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (at - 1, resource.RLIM_INFINITY))
        code, err = None, ""
        with self.standard_output(kind if at > 0 else None) as out:
            try:
                done = subprocess.run([command.program, *command.arguments], cwd=self.work, stdout=out, stderr=subprocess.PIPE,
                                      input=self.inputs[pathlib.Path(command.stdin)] if command.stdin else b"",
                                      timeout=PATIENCE, **options)
                code, err = done.returncode, done.stderr.decode("utf-8", "replace")
            except subprocess.TimeoutExpired:
                pass
        _, injected, *seen = TALLY.unpack(self.tally.read_bytes())
        written = target.read_bytes() if target and target.exists() else None
        return Run(code, self.out.read_bytes(), err, written, self.tidy(target), injected, tuple(seen))

    def faults(self, kind, at):
        if kind.group == "system":
            return {}
        return {"LD_PRELOAD": os.environ["TOOLPACE_FAULTS"], "TOOLPACE_FAULT": f"{kind.name}:{at}",
                "TOOLPACE_FAULT_FOLDER": str(self.folder), "TOOLPACE_FAULT_TALLY": str(self.tally)}

    def standard_output(self, kind):
        """A file, so that the faults of files reach it, too."""
        self.out.write_bytes(b"")
        if kind and kind.name == "full-stdout":
            return open("/dev/full", "wb")
        if kind and kind.name == "closed-stdout":
            reading, writing = os.pipe()
            os.close(reading)
            return os.fdopen(writing, "wb")
        return open(self.out, "wb")

    def tidy(self, target):
        """Puts everything back as it was. @return what lay there that nobody asked for"""
        left = []
        for path in [*self.work.rglob("*"), *self.temporary.rglob("*")]:
            if not path.is_file():
                continue
            before = self.inputs.get(path.relative_to(self.work)) if path.is_relative_to(self.work) else None
            if before is None:
                left += [] if path == target else [str(path.relative_to(self.folder))]
                path.unlink()
            elif path.stat().st_size != len(before):
                path.write_bytes(before)
        return left
