"""Runs every command under faults and looks at what it leaves behind.

fault_test.py [GROUP…]   the groups of kinds.py, and "window": those kinds that can strike what the window writes;
                         every one unless named

Where a fault strikes is chosen by counting first: every place where there are few, else the first, the last and others at
random, more of them by the factor TOOLPACE_CASES_FACTOR, and all for "all". TOOLPACE_FAULT_COMMANDS: only commands that
contain this text. TOOLPACE_FAULT_KINDS: only these kinds. Whatever the fault, a command
- goes on, with the same output as without it, or ends with the exit code that belongs to the fault, and says why;
- leaves its target whole: the old file as it was, none, or the new one;
- leaves no other file behind, is ended by no signal, and ends.
"""

import itertools
import json
import os
import random
import sys
import tempfile

from commands import WINDOW, every_command, every_export
from kinds import FINE, KINDS, LIMIT_BROKEN
from scratch import OLD, Scratch

PLACES = 3  # of each fault in each command, unless there is a factor
WINDOW_PLACES = 1  # the same in each export of the window, which takes longer


def places(count, kind, command):
    """Numbers up to `count` that choose where the fault strikes."""
    every = range(kind.least, count + 1)
    factor = os.environ.get("TOOLPACE_CASES_FACTOR", "1")
    few = WINDOW_PLACES if command.program == WINDOW else PLACES
    most = len(every) if factor == "all" else int(few * float(factor))
    if len(every) <= most:
        return list(every)
    chosen = random.Random(f"{command} {kind.name}").sample(every, most)
    return sorted({every[0], every[-1], *chosen[2:]}) if most > 2 else sorted(chosen)


def broken_rules(command, kind, run, base):
    """What is wrong with a run under a fault, as sentences."""
    if run.code is None:
        return ["it does not end"]
    if run.code < 0:
        return [f"signal {-run.code} ended it"]
    found = []
    if run.code == base.code:
        if run.result() != base.result() and kind.group != "system":
            found.append("it says that all is well, and its output is another one")
        if run.target != base.target:
            found.append("it says that all is well, and its file is another one")
    else:
        if run.code != kind.code:
            found.append(f"exit code {run.code}")
        if run.target not in (None, OLD, base.target):
            found.append(f"its target holds {len(run.target)} bytes that are neither the old file nor the new one")
        if "[" not in run.err:
            found.append("it does not say why")
        found += json_trouble(command, run) if kind.group != "system" else []  # it cannot be written
    if run.left:
        found.append(f"it leaves {', '.join(run.left)}")
    return found


def json_trouble(command, run):
    """A script that asked for JSON gets the error as JSON."""
    if not command.wants_json() or run.out == b"":
        return [] if not command.wants_json() or run.code != 3 else ["it prints no JSON"]
    try:
        told = json.loads(run.out)
    except ValueError:
        return ["what it prints is no JSON"]
    return [] if told.get("exit_code") == run.code else ["its JSON has another exit code"]


class Sweep:
    def __init__(self, scratch):
        self.scratch = scratch
        self.bases = {}
        self.complaints = []

    def base(self, command):
        """The run without a fault, which also counts what could have been struck."""
        if command not in self.bases:
            run = self.scratch.run(command, KINDS[0], 0)
            if run.code not in (FINE, LIMIT_BROKEN) or run.left:
                sys.exit(f"{command}: exit code {run.code} without a fault\n{run.err}")
            self.bases[command] = run
        return self.bases[command]

    def count(self, command, kind):
        """How many places there are for the fault to strike."""
        base = self.base(command)
        if kind.name == "shrinking-input" and "--verify" in command.arguments:
            return 0  # what would shrink is its own output
        if kind.name in ("full-stdout", "closed-stdout"):
            return 1 if base.out else 0
        if kind.name == "size-limit":
            return max(len(base.out), len(base.target or b""))
        return sum(base.seen[call] for call in kind.calls)

    def try_kind(self, kind, command):
        """@return how many faults happened, and how many of them the command held out against"""
        tried = held = 0
        complaints = []
        for turn, at in enumerate(places(self.count(command, kind), kind, command)):
            run = self.scratch.run(command, kind, at, with_old=turn % 2 == 0)
            if kind.group != "system" and run.injected == 0:
                continue  # another thread was faster, or a call that the last run had was not made
            tried += 1
            wrong = broken_rules(command, kind, run, self.base(command))
            held += not wrong
            if wrong:
                complaints.append(f"{kind.name}:{at} in {command}\n  {'; '.join(wrong)}\n  {run.err.strip()}")
        if complaints:
            self.complaints.append(complaints[0] + (f"\n  and {len(complaints) - 1} more" if complaints[1:] else ""))
        return tried, held


def main():
    groups = sys.argv[1:]
    kinds = os.environ.get("TOOLPACE_FAULT_KINDS", "").split()
    only = os.environ.get("TOOLPACE_FAULT_COMMANDS", "")
    surfaces = [("", [c for c in every_command() if only in str(c)])]
    if WINDOW:
        surfaces.append(("window ", [c for c in every_export() if only in str(c)]))
    with tempfile.TemporaryDirectory() as folder:
        sweep = Sweep(Scratch(folder))
        print(f"{'fault':<28}{'tried':>8}{'held':>8}")
        for surface, kind in itertools.product(surfaces, KINDS):
            title, commands = surface
            group = "window" if title else kind.group
            if groups and group not in groups or kinds and kind.name not in kinds or title and not kind.strikes_window():
                continue
            if title and "TOOLPACE_CASES_FACTOR" not in os.environ:
                commands = commands[KINDS.index(kind) % 3::3]  # every export meets every third kind
            tallies = [sweep.try_kind(kind, command) for command in commands]
            tried, held = (sum(column) for column in zip(*tallies))
            print(f"{title + kind.name:<28}{tried:>8}{held:>8}", flush=True)
            if tried == 0:
                sweep.complaints.append(f"{title}{kind.name} never happened")
    print("\n".join(sweep.complaints))
    return 1 if sweep.complaints else 0


if __name__ == "__main__":
    sys.exit(main())
