"""The directive `{program-help}`: every command of the program with its own help."""

import os
import re
import subprocess

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

COMMAND = re.compile(r"^  ([a-z][a-z-]*)  ", re.MULTILINE)


def program_help(*command: str) -> str:
    program = os.environ.get("CDPR", "cdpr")
    return subprocess.run([program, *command, "--help"], check=True, capture_output=True, text=True).stdout


class ProgramHelp(SphinxDirective):
    def run(self):
        whole = program_help()
        listed = whole.partition("Commands:\n")[2].partition("\n\n")[0]
        commands = [name for name in COMMAND.findall(listed) if name != "help"]
        assert commands, f"no commands in:\n{whole}"
        return [self.text(whole), *(self.section(name) for name in commands)]

    def section(self, command: str) -> nodes.section:
        section = nodes.section(ids=[nodes.make_id(f"cdpr-{command}")], names=[command])
        section += nodes.title("", f"cdpr {command}")
        section += self.text(program_help(command))
        return section

    def text(self, text: str) -> nodes.literal_block:
        text = text.strip()
        return nodes.literal_block(text, text, language="none", classes=["program-help"])


def setup(app):
    app.add_directive("program-help", ProgramHelp)
    return {"parallel_read_safe": True}
