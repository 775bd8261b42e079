"""Toolpace: plans the motion of CNC machines. NC programs in, proven setpoints out.

Each command of the command line is a function here: its arguments come first, its flags are keyword arguments of the same names
(--corner-step-mm-s is corner_step_mm_s), and what it returns has the keys of --json:

    >>> import toolpace
    >>> o = toolpace.plan("part.ngc", machine="mill.toml", law="seven-phase", ramps="span")
    >>> o.cycle_time_s, o.summary["time_by_limit_s"]
    >>> o.setpoints[:, 1], o.column("x_mm")

help(toolpace.plan) tells all flags. What goes wrong is raised as toolpace.Error, with code, place and remedy. Other threads run
on meanwhile, and Ctrl-C stops the work.
"""

from ._call import commands as _commands
from ._call import make_function as _make_function
from ._core import version as _version
from ._replan import replan
from .errors import Error, FileError, InputError, UsageError
from .results import Plan, Pulses, Result

__version__, _, __commit__ = _version().partition(" ")
__commit__ = __commit__.strip("()")  # empty where it was not built in a checkout

for _name, _command in _commands().items():
    globals()[_name] = _make_function(_command)

__all__ = ["Error", "FileError", "InputError", "Plan", "Pulses", "Result", "UsageError", "replan", *_commands()]
