"""The faults, and what a command may do when it meets one."""

import dataclasses

FINE, LIMIT_BROKEN, BAD_INPUT, FILE_TROUBLE = 0, 1, 3, 4


# What the library of faults counts (faults.h).
OPEN, READ, WRITE, SYNC, CLOSE, RENAME, LOOK, WAIT, ALLOCATE, BYTES = range(10)
INTERRUPTIBLE = OPEN, READ, WRITE, SYNC, WAIT


@dataclasses.dataclass(frozen=True)
class Kind:
    name: str
    group: str  # of the test that runs it
    code: int | None  # what a command that cannot go on ends with; None: it has to go on
    calls: tuple = ()  # that it can strike
    least: int = 1  # of the numbers that choose where it strikes

    def strikes_window(self):
        """Qt ends where it gets no memory; an input that changes is read anew; and the window prints nothing."""
        return self.group not in ("memory", "input") and self.name not in ("full-stdout", "closed-stdout")


KINDS = (
    # There is always room for the rest, in the next call.
    Kind("short-write", "disk", None, (WRITE,)),
    Kind("disk-full", "disk", FILE_TROUBLE, (BYTES,)),
    Kind("interrupted-once", "signals", None, INTERRUPTIBLE),
    # Where waiting and reading take turns, each second call would be every read.
    Kind("interrupted-often", "signals", None, INTERRUPTIBLE, least=3),
    Kind("open-error", "calls", FILE_TROUBLE, (OPEN,)),
    Kind("read-error", "calls", FILE_TROUBLE, (READ,)),
    Kind("sync-error", "calls", FILE_TROUBLE, (SYNC,)),
    Kind("close-error", "calls", FILE_TROUBLE, (CLOSE,)),
    Kind("rename-error", "calls", FILE_TROUBLE, (RENAME,)),
    Kind("shrinking-input", "input", FILE_TROUBLE, (READ, LOOK)),
    Kind("memory-once", "memory", BAD_INPUT, (ALLOCATE,)),
    Kind("memory-out", "memory", BAD_INPUT, (ALLOCATE,)),
    # These come from the system itself, and so reach what the library of faults does not see: the C library's own buffers.
    Kind("size-limit", "system", FILE_TROUBLE),
    Kind("full-stdout", "system", FILE_TROUBLE),
    Kind("closed-stdout", "system", FILE_TROUBLE),
)
