#!/usr/bin/env python3
"""Proves the order of the rooms by scanning includes.

A header or source of a room includes only its own room or an earlier one; core knows no Qt, no clock, no locale, no
logging; threads stand in tune/ and pipeline/ alone; verify/ reaches neither law/ nor plan/, not even through others.
The rooms of ui keep an order, too; only app/studio knows them all, and nothing knows app.
"""

import pathlib
import re
import sys

ROOMS = ["base", "kinematics", "nc", "path", "limits", "law", "plan", "sample", "servo", "verify", "io", "trace", "machine", "controller",
         "pipeline", "bound", "report", "rewrite", "tune"]
UI_ROOMS = ["theme", "models", "drawing", "jobs", "plots", "preview", "panels"]
UI_STRANGERS = {("preview", "plots")}  # side by side: neither knows the other
THREADED_ROOMS = {"tune", "pipeline"}
THREADS = {"thread", "future", "mutex", "shared_mutex", "condition_variable", "semaphore", "latch", "barrier", "execution",
           "pthread.h"}
FORBIDDEN = {"chrono": "clock", "ctime": "clock", "time.h": "clock", "sys/time.h": "clock", "locale": "locale",
             "clocale": "locale", "locale.h": "locale", "codecvt": "locale", "iostream": "logging", "syslog.h": "logging",
             "fmt/chrono.h": "clock", "fmt/std.h": "threads"}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
SOURCES = ("*.h", "*.hpp", "*.inl", "*.cpp")


def files_under(folder):
    return sorted(path for pattern in SOURCES for path in folder.rglob(pattern))


def includes_of(path):
    return [name for _, name in INCLUDE.findall(path.read_text(encoding="utf-8"))]


def room_of(name):
    parts = name.split("/")
    return parts[1] if len(parts) > 2 and parts[0] == "toolpace" else None


def check_include(room, name):
    """Why `room` may not include `name`, or None."""
    other = room_of(name)
    if name.startswith("toolpace/"):
        if other is None or other not in ROOMS:
            return f"{name} is in no known room"
        if ROOMS.index(other) > ROOMS.index(room):
            return f"{room}/ comes before {other}/ and may not include {name}"
        if room == "verify" and other in ("law", "plan"):
            return f"verify/ judges plans and may not share their code: {name}"
        return None
    if re.match(r"(Q[A-Z]|Qt|qcustomplot|fftw3)", name):
        return f"core knows no Qt: {name}"
    if name in THREADS and room not in THREADED_ROOMS:
        return f"threads stand in tune/ and pipeline/ alone: <{name}>"
    if name in FORBIDDEN:
        return f"core has no {FORBIDDEN[name]}: <{name}>"
    return None


def check_ui_include(room, name):
    """Why a room of ui may not include `name`, or None."""
    other = name.split("/")[0]
    if "/" not in name or name.startswith("toolpace/"):
        return None
    if other not in UI_ROOMS:
        return f"{name} is in no room of ui"
    if UI_ROOMS.index(other) > UI_ROOMS.index(room) or (room, other) in UI_STRANGERS:
        return f"{room}/ may not include {name}"
    return None


def quoted_includes_of(path):
    return [name for mark, name in INCLUDE.findall(path.read_text(encoding="utf-8")) if mark == '"']


def ui_problems_of(root):
    problems = []
    for path in files_under(root / "ui"):
        room = path.relative_to(root / "ui").parts[0]
        where = path.relative_to(root)
        if room not in UI_ROOMS:
            problems.append(f"{where}: {room}/ is no known room of ui")
            continue
        problems += [f"{where}: {why}" for name in quoted_includes_of(path) if (why := check_ui_include(room, name))]
    return problems


def reached_from(core, room):
    """All project headers that the files of a room include, directly or through others."""
    seen, todo = {}, [(name, path.relative_to(core)) for path in files_under(core / "toolpace" / room)
                      for name in includes_of(path)]
    while todo:
        name, by = todo.pop()
        if name in seen or not name.startswith("toolpace/"):
            continue
        seen[name] = by
        header = core / name
        if header.exists():
            todo += [(further, name) for further in includes_of(header)]
    return seen


def problems_of(root):
    core = root / "core"
    problems = ui_problems_of(root)
    for path in files_under(core / "toolpace"):
        room = path.relative_to(core / "toolpace").parts[0]
        where = path.relative_to(root)
        if room not in ROOMS:
            problems.append(f"{where}: {room}/ is no known room")
            continue
        problems += [f"{where}: {why}" for name in includes_of(path) if (why := check_include(room, name))]
    problems += [f"core/{by}: reaches {name}, which verify/ must not depend on" for name, by in
                 reached_from(core, "verify").items() if room_of(name) in ("law", "plan")]
    for path in files_under(root / "app" / "cli"):
        problems += [f"{path.relative_to(root)}: the command line knows no Qt: {name}" for name in includes_of(path)
                     if re.match(r"(Q[A-Z]|Qt|qcustomplot|fftw3)", name)]
    return problems


def main():
    problems = problems_of(pathlib.Path(sys.argv[1]))
    print("\n".join(problems) if problems else "every include keeps the order of the rooms")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
