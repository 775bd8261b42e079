"""One signal ends a command, whatever it waits for or works at, with exit code 130 and nothing left behind.

Nothing here waits for a time: the signal is sent as soon as the command heeds signals, or when what it has to have begun is
seen, and the command has to end whenever it came.
"""

import os
import signal
import subprocess
import unittest

from command_line import INTERRUPTED, PATIENCE_S, PROGRAM, CommandLineTest

LINE = "G21 G90 G94\nG1 X10 F3000\nM2\n"
# 9e5 mm at 1 mm/s: 9e8 setpoints, which no machine writes before it is asked to stop.
ENDLESS = "G21 G90 G94\nG1 X900000 F60\nM2\n"
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT)


def heeds(process, number):
    """Whether the command has taken the signal over, which it does before anything else."""
    with open(f"/proc/{process.pid}/status", encoding="ascii") as status:
        blocked = next(line for line in status if line.startswith("SigBlk")).split()[1]
    return int(blocked, 16) >> (number - 1) & 1


class Interrupt(CommandLineTest):
    def start(self, *arguments, **options):
        streams = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=self.folder, **{**streams, **options})
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def until(self, process, condition):
        while not condition():
            self.assertIsNone(process.poll(), "it ended by itself")

    def end(self, process, number=signal.SIGINT):
        self.until(process, lambda: heeds(process, number))
        process.send_signal(number)
        self.assertEqual(process.wait(PATIENCE_S), INTERRUPTED)

    def names(self):
        return sorted(path.name for path in self.folder.iterdir())

    def fifo(self, name):
        os.mkfifo(self.folder / name)
        return name

    def test_writing_setpoints_leaves_nothing(self):
        self.file("long.ngc", ENDLESS)
        for number in SIGNALS:
            for ending in ("csv", "npz"):
                process = self.start("plan", "long.ngc", "--setpoints", f"out.{ending}")
                self.until(process, lambda: len(self.names()) > 1)
                self.end(process, number)
                self.assertEqual(self.names(), ["long.ngc"])

    def test_a_hangup_and_a_termination_together_leave_nothing(self):
        self.file("long.ngc", ENDLESS)
        process = self.start("plan", "long.ngc", "--setpoints", "out.csv")
        self.until(process, lambda: len(self.names()) > 1)
        self.until(process, lambda: heeds(process, signal.SIGHUP))
        process.send_signal(signal.SIGHUP)
        self.end(process, signal.SIGTERM)
        self.assertEqual(self.names(), ["long.ngc"])

    def test_waiting_for_input(self):
        self.file("a.ngc", LINE)
        self.fifo("fifo")
        for arguments in (["plan", "-"], ["plan", "fifo"], ["plan", "a.ngc", "--machine", "fifo"], ["blocks", "a.ngc", "--tools", "fifo"],
                          ["plan", "a.ngc", "--parameters", "fifo"], ["verify", "fifo", "--machine", "fifo"]):
            reading, writing = os.pipe()
            self.end(self.start(*arguments, stdin=reading))
            os.close(reading)
            os.close(writing)

    def test_waiting_for_the_writer_of_a_pipe_that_says_nothing(self):
        self.fifo("fifo.ngc")
        process = self.start("plan", "fifo.ngc")
        with open(self.folder / "fifo.ngc", "wb"):
            self.end(process)

    def test_waiting_for_a_reader(self):
        self.file("a.ngc", LINE)
        self.fifo("fifo.npy")
        for arguments in (["plan", "a.ngc", "--setpoints"], ["report", "a.ngc", "-o"], ["blocks", "a.ngc", "--csv"]):
            self.end(self.start(*arguments, "fifo.npy"))

    def test_a_reader_that_does_not_read(self):
        self.file("long.ngc", ENDLESS)
        self.fifo("fifo.csv")
        reader = os.open(self.folder / "fifo.csv", os.O_RDONLY | os.O_NONBLOCK)
        self.addCleanup(os.close, reader)
        self.end(self.start("plan", "long.ngc", "--setpoints", "fifo.csv"))
        for target in ("-", "/dev/stdout"):
            reading, writing = os.pipe()
            self.end(self.start("plan", "long.ngc", "--setpoints", target, stdout=writing))
            os.close(reading)
            os.close(writing)

    def test_standard_output_and_error_that_nobody_reads(self):
        # More diagnostics than a pipe holds; the pipe is full before the command begins.
        self.file("bad.ngc", "G21\n" + "G1 X\n" * 400 + "M2\n")
        for stream in ("stdout", "stderr"):
            reading, writing = os.pipe()
            os.set_blocking(writing, False)
            try:
                while True:
                    os.write(writing, b"x" * 4096)
            except BlockingIOError:
                os.set_blocking(writing, True)
            self.end(self.start("blocks", "bad.ngc", "--json", **{stream: writing}))
            os.close(reading)
            os.close(writing)

    def test_who_is_started_with_nohup_is_not_asked_by_a_hangup(self):
        self.file("long.ngc", ENDLESS)
        process = self.start("plan", "long.ngc", "--setpoints", "out.csv",
                             preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        self.until(process, lambda: heeds(process, signal.SIGTERM))
        process.send_signal(signal.SIGHUP)
        self.until(process, lambda: any(path.stat().st_size > 0 for path in self.folder.glob(".out.csv.*")))
        self.end(process, signal.SIGTERM)

    def test_the_same_signal_twice_ends_it_at_once(self):
        self.fifo("fifo.csv")
        process = self.start("plan", "fifo.csv")
        self.until(process, lambda: heeds(process, signal.SIGINT))
        process.send_signal(signal.SIGINT)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(PATIENCE_S), INTERRUPTED)


if __name__ == "__main__":
    unittest.main()
