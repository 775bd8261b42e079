"""What the tests of README and handbook share: running the commands that stand in a text."""

import re
import shlex

from command_line import FINE, SOURCE_DIR, CommandLineTest


class DocumentTest(CommandLineTest):
    def setUp(self):
        super().setUp()
        for folder in ("examples", "resources"):
            (self.folder / folder).symlink_to(SOURCE_DIR / folder)

    def run_commands_of(self, text):
        """Runs every line "    toolpace …" of a text, in its order and in one folder; each has to succeed.

        @return how many there are
        """
        commands = re.findall(r"^    toolpace (.*)$", text, re.M)
        for command in commands:
            run = self.run_toolpace(*shlex.split(command, comments=True))
            self.assertEqual(run.code, FINE, f"{command}: {run.err}")
        return len(commands)
