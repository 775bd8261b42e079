"""Planning again, from what an earlier plan has left as it was."""

from ._call import ARGUMENTS, call, commands, unknown, usage_error
from .results import Plan

_NOT_ANEW = ("Reading the program", "Many programs (several, folders, a list): one table")  # titles of flags


def replan(plan, *, progress=None, **changes):
    """The program of an earlier plan, planned again: the flags of that call, changed by those that are given here; None takes
    one back. The same result, to the bit, as toolpace.plan() with all of them, but the program is not read again, and what the
    changes do not touch is taken over. Files that the earlier call wrote are not written again.

        >>> o = toolpace.plan("part.ngc", machine="mill.toml")
        >>> [toolpace.replan(o, lookahead=n).cycle_time_s for n in (1, 2, 4, 8, "all")]
    """
    if not isinstance(plan, Plan):
        raise usage_error("flag-value", f"plan is a {type(plan).__name__}", "give what toolpace.plan() returned")
    command = commands()["plan"]
    for name in changes:
        flag = command["flags"].get(name)
        if flag is None:
            raise unknown(command, name)
        if flag["kind"] in ARGUMENTS or flag["title"] in _NOT_ANEW:
            raise usage_error("replan-reads-nothing", f"replan() does not read the program again, which {name} would need",
                              "use toolpace.plan()")
    kept = {name: value for name, value in plan._asked.items() if command["flags"][name]["kind"] != "output"}
    return call(command, {**kept, **changes}, before=plan._core, progress=progress)
