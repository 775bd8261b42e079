"""From a Python call to the words of a command line, and back."""

import contextlib
import difflib
import functools
import inspect
import json
import os
import tempfile

import numpy

from . import _core
from .errors import UsageError, error_of
from .results import Plan, Pulses, Result

_OWN = {"--json"}  # always on
ARGUMENTS = ("argument", "arguments")  # one, and one or more


def name_of(flag):
    """The keyword of a flag: --corner-step-mm-s -> corner_step_mm_s."""
    return flag["name"].lstrip("-").replace("-", "_").lower()


@functools.lru_cache(maxsize=None)
def commands():
    """{name: command} of the grammar, each with its flags by keyword."""
    found = {}
    for command in json.loads(_core.grammar())["commands"]:
        flags = {name_of(flag): flag for flag in command["flags"] if flag["name"] not in _OWN}
        found[command["name"]] = {**command, "flags": flags, "has_json": len(flags) < len(command["flags"])}
    return found


def usage_error(code, message, remedy):
    return UsageError({"error": {"code": code, "message": message, "remedy": remedy, "file": None, "line": 0, "column": 0,
                                 "attainable": None}, "exit_code": 2, "diagnostics": []})


def _text(name, value):
    """A value as it would be typed. Numbers read back to the same double."""
    if isinstance(value, bool):
        raise usage_error("flag-value", f"{name} is {value}, but it takes a value", "give a number, a name or None")
    if isinstance(value, (str, bytes, os.PathLike)):
        text = os.fsencode(value)
        if b"\0" in text:
            raise usage_error("flag-value", f"{name} holds a null character, which no name does", "leave it out")
        return text
    if hasattr(value, "__index__"):
        return str(int(value)).encode()
    if hasattr(value, "__float__"):
        return repr(float(value)).encode()
    raise usage_error("flag-value", f"{name} is a {type(value).__name__}", "give a number, a name or None")


def _word(name, flag, value):
    """The same; the streams of the terminal are not Python's."""
    text = _text(name, value)
    if text == b"-" and flag["kind"] in (*ARGUMENTS, "input", "output"):
        raise usage_error("no-standard-streams", f"{name} is -, standard input or output, which Python may have for itself",
                          "give the name of a file")
    return text


def words_of(command, values):
    """The command line of a call; what is None is left out."""
    words, arguments = [command["name"].encode()], []
    if command["has_json"]:
        words.append(b"--json")
    for name, value in values.items():
        flag = command["flags"][name]
        if flag["kind"] == "toggle" and not isinstance(value, (bool, numpy.bool_, type(None))):
            raise usage_error("flag-value", f"{name} is {value!r}, but it is either on or off", "give True or False")
        if value is None or (flag["kind"] == "toggle" and not value):
            continue
        if flag["kind"] == "arguments" and isinstance(value, (list, tuple)):
            arguments += [_word(name, flag, part) for part in value]
        elif flag["kind"] in ARGUMENTS:
            arguments.append(_word(name, flag, value))
        elif flag["kind"] == "toggle":
            words.append(flag["name"].encode())
        elif flag["kind"] == "word" and isinstance(value, (list, tuple)):
            words.append(flag["name"].encode() + b"=" + b",".join(_word(name, flag, part) for part in value))
        elif flag["kind"] == "words" and not isinstance(value, (str, bytes, os.PathLike)):
            words += [flag["name"].encode() + b"=" + _text(name, part) for part in value]
        else:
            words.append(flag["name"].encode() + b"=" + _word(name, flag, value))
    return words + [b"--"] + arguments if arguments else words


def call(command, values, before=None, progress=None):
    ran = _core.run(words_of(command, values), before, progress)
    summary = json.loads(ran.json) if ran.json else {}
    if ran.has_failed:
        raise error_of(summary)
    told = ran.told.decode("utf-8", "replace")
    if command["name"] == "plan" and ran.plan is not None:  # of many programs there is a table alone
        return Plan(summary, ran.exit_code, told, ran.plan, values, ran.tip_of)
    if command["name"] == "steps":
        return Pulses(summary, ran.exit_code, told, ran.pulses)
    return Result(summary, ran.exit_code, told)


def signature_of(command):
    kinds = inspect.Parameter
    arguments, flags = [], []
    for name, flag in command["flags"].items():
        if flag["kind"] in ARGUMENTS:
            arguments.append(kinds(name, kinds.POSITIONAL_OR_KEYWORD))
        else:
            default = kinds.empty if flag["required"] else False if flag["kind"] == "toggle" else None
            flags.append(kinds(name, kinds.KEYWORD_ONLY, default=default))
    return inspect.Signature(arguments + flags + [kinds("progress", kinds.KEYWORD_ONLY, default=None)])


def document(command):
    """The text of help(): what --help prints, with the names that Python takes."""
    lines, title = [command["summary"] + ".", ""], None
    for name, flag in command["flags"].items():
        if flag["title"] != title and flag["title"]:
            lines += ["", flag["title"] + ":"]
        title = flag["title"]
        lines.append(f"  {name}{' [' + flag['unit'] + ']' if flag['unit'] else ''}: {' '.join(flag['text'].split())}")
    lines += ["  progress: called now and then with (what is being done, fraction of it)", "", f"As: toolpace {command['name']} --help"]
    return "\n".join(lines)


def _save_setpoints(folder, rows):
    file = os.path.join(folder, "setpoints.npy")
    numpy.save(file, numpy.ascontiguousarray(rows, dtype=float))
    return file


def _save_polyline(folder, columns):
    file = os.path.join(folder, "polyline.csv")
    names = list(columns.keys())
    rows = zip(*(numpy.asarray(columns[name], dtype=float).tolist() for name in names), strict=True)
    with open(file, "w", encoding="utf-8") as out:
        out.write(",".join(map(str, names)) + "\n")
        out.writelines(",".join(map(repr, row)) + "\n" for row in rows)
    return file


def _as_files(command, values, stack):
    """What is given in the place of a file becomes one for the time of the call: an array of setpoints, with rows as Plan.setpoints
    has them, and the columns of a polyline (a dict, a pandas frame), named as in .csv: x_mm, y_mm, z_mm, feed_mm_min."""
    for name, is_meant, save in (("setpoints", lambda value: hasattr(value, "__array__"), _save_setpoints),
                                 ("program", lambda value: hasattr(value, "keys"), _save_polyline)):
        if command["flags"].get(name, {}).get("kind") in ARGUMENTS and is_meant(values.get(name)):
            values[name] = save(stack.enter_context(tempfile.TemporaryDirectory(prefix="toolpace-")), values[name])


def make_function(command):
    signature = signature_of(command)

    def function(*arguments, **keywords):
        bound = _bind(command, signature, arguments, keywords)
        progress = bound.pop("progress", None)
        with contextlib.ExitStack() as stack:
            _as_files(command, bound, stack)
            return call(command, bound, progress=progress)

    function.__name__ = function.__qualname__ = command["name"]
    function.__module__ = "toolpace"
    function.__doc__ = document(command)
    function.__signature__ = signature
    return function


def _bind(command, signature, arguments, keywords):
    for name in keywords:
        if name not in signature.parameters:
            raise unknown(command, name)
    return dict(signature.bind(*arguments, **keywords).arguments)


def unknown(command, name):
    """The error of a keyword that does not exist, with the nearest one that does."""
    near = difflib.get_close_matches(name, command["flags"], 1, 0.5)
    remedy = f"did you mean {near[0]}?" if near else f"help(toolpace.{command['name']}) lists what it takes"
    return usage_error("flag-unknown", f"{command['name']}() takes no {name}", remedy)
