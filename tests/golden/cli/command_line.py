"""What the tests of the command line share: running it in a scratch folder, and saying what happened."""

import dataclasses
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["TOOLPACE"]
SOURCE_DIR = pathlib.Path(os.environ["TOOLPACE_SOURCE_DIR"])
EXAMPLES = SOURCE_DIR / "examples" / "nc"
MACHINES = SOURCE_DIR / "resources" / "machines"

PATIENCE_S = 300  # for what never ends; a machine may have much else to do

FINE, LIMIT_BROKEN, BAD_USAGE, BAD_INPUT, FILE_TROUBLE, INTERRUPTED = 0, 1, 2, 3, 4, 130


@dataclasses.dataclass
class Run:
    code: int
    out: bytes
    err: str
    wants_json: bool

    def json(self):
        return json.loads(self.out)


class CommandLineTest(unittest.TestCase):
    """Each test has an empty folder of its own, self.folder, in which the command runs."""

    maxDiff = None

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def file(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return name

    def run_toolpace(self, *arguments, stdin=b"", **options):
        done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, input=stdin, capture_output=True, timeout=PATIENCE_S,
                              **options)
        return Run(done.returncode, done.stdout, done.stderr.decode("utf-8", "replace"), "--json" in arguments)

    def expect_failure(self, run, code, *said):
        """The command ended with `code` and told the user each of `said`; it neither crashed nor printed a result. Where
        JSON was asked for, it says the same."""
        self.assertEqual(run.code, code, run.err)
        if run.wants_json:
            told = run.json()
            self.assertEqual(list(told), ["error", "exit_code", "diagnostics"])
            self.assertEqual(told["exit_code"], code)
            self.assertIn(f"[{told['error']['code']}]", run.err)
        else:
            self.assertEqual(run.out, b"")
        for text in said:
            self.assertIn(text, run.err)
