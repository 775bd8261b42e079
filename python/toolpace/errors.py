"""What is raised where the command line would end with an error."""


class Error(Exception):
    """What went wrong, where, and what to do about it.

    code: stable key such as "arc-radius-too-small"; message, remedy: words for people; file, line, column: the place, or None;
    attainable: the nearest value that would have worked, or None; diagnostics: all that is wrong with a program, as dicts;
    exit_code: that of the command line.
    """

    def __init__(self, told):
        error = told["error"]
        self.code, self.message, self.remedy = error["code"], error["message"], error["remedy"]
        self.file = error["file"]
        self.line, self.column = error["line"] or None, error["column"] or None
        self.attainable = error["attainable"]
        self.diagnostics = told["diagnostics"]
        self.exit_code = told["exit_code"]
        super().__init__(self.message)

    def __str__(self):
        place = ":".join(str(part) for part in (self.file, self.line, self.column) if part is not None)
        lines = [f"{place}: {self.message} [{self.code}]" if place else f"{self.message} [{self.code}]"]
        if self.remedy:
            lines.append(self.remedy)
        lines += [f"{d['file']}:{d['line']}:{d['column']}: {d['message']} [{d['code']}]" for d in self.diagnostics
                  if d["severity"] == "error"]
        return "\n".join(lines)


class UsageError(Error, ValueError):
    """Arguments or limits that make no sense."""


class InputError(Error, ValueError):
    """A program, a machine file or a setpoint file with errors, or a move that cannot be made."""


class FileError(Error, OSError):
    """A file that could not be opened, read or written."""


_BY_EXIT_CODE = {2: UsageError, 3: InputError, 4: FileError}


def error_of(told):
    """The exception of what --json prints instead of a result."""
    return _BY_EXIT_CODE.get(told["exit_code"], Error)(told)
