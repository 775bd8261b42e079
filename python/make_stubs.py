"""make_stubs.py FOLDER FILE: writes FILE, the stubs of the package toolpace in FOLDER, made from the commands and flags that the module itself knows."""

import keyword
import pathlib
import sys

TYPES = {"number": "float", "count": "int", "word": "str | int", "words": "str | Iterable[str]", "toggle": "bool", "input": "Path",
         "output": "Path", "argument": "Path",
         "arguments": "Path | Iterable[Path]"}
ARGUMENTS = ("argument", "arguments")
MANY = "Many programs (several, folders, a list): one table"  # a title of flags
RETURNED = {"plan": "Plan", "steps": "Pulses"}
HEAD = '''# Made by python/make_stubs.py from the command line's own grammar.
from collections.abc import Callable, Iterable, Mapping
from os import PathLike
from typing import Any

import numpy
from numpy.typing import NDArray

from .errors import Error as Error
from .errors import FileError as FileError
from .errors import InputError as InputError
from .errors import UsageError as UsageError

Path = str | bytes | PathLike[str]
Progress = Callable[[str, float], Any]
__version__: str
__commit__: str

class Result:
    summary: dict[str, Any]
    exit_code: int
    told: str
    def __getattr__(self, name: str) -> Any: ...
    def __getitem__(self, key: str) -> Any: ...
    def __contains__(self, key: str) -> bool: ...

class Plan(Result):
    @property
    def columns(self) -> tuple[str, ...]: ...
    @property
    def setpoints(self) -> NDArray[numpy.float64]: ...
    @property
    def lines(self) -> NDArray[numpy.int64]: ...
    def column(self, name: str) -> NDArray[numpy.float64]: ...

class Pulses(Result):
    @property
    def intervals(self) -> NDArray[numpy.uint32]: ...
'''


def parameter(name, flag):
    kind = TYPES[flag["kind"]]
    if flag["kind"] in ARGUMENTS:
        return f"{name}: {kind}" + {"setpoints": " | NDArray[numpy.float64]", "program": " | Mapping[str, Any]"}.get(name, "")
    if flag["required"]:
        return f"{name}: {kind}"
    return f"{name}: bool = ..." if flag["kind"] == "toggle" else f"{name}: {kind} | None = ..."


def function(name, parameters, returned):
    assert not keyword.iskeyword(name)
    return f"\ndef {name}(\n" + "".join(f"    {p},\n" for p in parameters) + f") -> {returned}: ...\n"


def stubs(commands):
    text = HEAD
    for name, command in commands.items():
        arguments = [parameter(n, f) for n, f in command["flags"].items() if f["kind"] in ARGUMENTS]
        flags = [parameter(n, f) for n, f in command["flags"].items() if f["kind"] not in ARGUMENTS]
        text += function(name, arguments + ["*"] + flags + ["progress: Progress | None = ..."], RETURNED.get(name, "Result"))
    flags = [parameter(n, {**f, "required": False}) for n, f in commands["plan"]["flags"].items() if f["kind"] not in ARGUMENTS
             and f["title"] not in ("Reading the program", MANY)]
    return text + function("replan", ["plan: Plan", "*"] + flags + ["progress: Progress | None = ..."], "Plan")


if __name__ == "__main__":
    sys.path.insert(0, sys.argv[1])
    from toolpace._call import commands
    pathlib.Path(sys.argv[2]).write_text(stubs(commands()))
