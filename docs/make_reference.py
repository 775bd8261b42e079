"""make_reference.py TOOLPACE FOLDER [STUDIO]: what the command line says of itself (TOOLPACE --grammar), for those who look it up.

Writes into FOLDER: man1/toolpace.1 and a page for each command (man toolpace-plan), man1/toolpace-studio.1 where that program is
named, toolpace.bash (completion), and commands.md (for the handbook).
"""

import json
import pathlib
import subprocess
import sys

VALUES = {"--law": "trapezoid five-phase-time five-phase-jerk seven-phase quintic time-optimal", "--ramps": "block span",
          "--corner": "stop servo junction blend smooth", "--dialect": "auto linuxcnc fanuc fanuc-lathe fanuc-lathe-b haas mach3 grbl marlin",
          "--lookahead": "all", "--fit": "lines arcs", "--feeds": "keep planned",
          "--controller": "grbl grblhal klipper marlin linuxcnc", "--integers": "auto lengths increments"}


def plain(text):
    return " ".join(text.split())

ARGUMENTS = ("argument", "arguments")  # one, and one or more


def roff(text):
    return text.replace("\\", "\\e").replace("-", "\\-").replace("\n.", "\n\\&.").replace("\n'", "\n\\&'")


def head(name, section, version):
    return f'.TH {name.upper()} 1 "" "Toolpace {version}" "{section}"\n'


def synopsis(command):
    arguments = [flag["name"] + ("…" if flag["kind"] == "arguments" else "") for flag in command["flags"] if flag["kind"] in ARGUMENTS]
    needed = [f"{flag['name']} {flag['unit']}" for flag in command["flags"] if flag["required"] and flag["kind"] not in ARGUMENTS]
    return " ".join(["toolpace", command["name"], *arguments, *needed, "[flags]"])


def examples(footer):
    """The lines of a footer: words, and the examples below them."""
    words, _, shown = footer.partition("Examples:\n")
    return plain(words), [line.strip() for line in shown.splitlines() if line.strip()]


def command_page(command, version):
    words, shown = examples(command["footer"])
    text = head(f"toolpace-{command['name']}", "Toolpace", version)
    text += f".SH NAME\ntoolpace\\-{roff(command['name'])} \\- {roff(command['summary'])}\n.SH SYNOPSIS\n.B {roff(synopsis(command))}\n"
    text += f".SH DESCRIPTION\n{roff(words)}\n.SH OPTIONS\n"
    title = ""
    for flag in command["flags"]:
        if flag["title"] != title:
            title = flag["title"]
            text += f".SS {roff(title)}\n" if title else ""
        letter = f"{flag['letter']}, " if flag["letter"] else ""
        text += f".TP\n\\fB{roff(letter + flag['name'])}\\fR {roff(flag['unit'])}\n{roff(plain(flag['text']))}\n"
    if shown:
        text += ".SH EXAMPLES\n.nf\n" + "\n".join(roff(line) for line in shown) + "\n.fi\n"
    return text + ".SH SEE ALSO\n.BR toolpace (1)\n"


def main_page(grammar):
    text = head("toolpace", "Toolpace", grammar["version"])
    text += f".SH NAME\ntoolpace \\- {roff(grammar['summary'])}\n.SH SYNOPSIS\n.B toolpace\nCOMMAND [flags]\n"
    text += f".SH DESCRIPTION\n{roff(plain(grammar['footer']))}\n.SH COMMANDS\n"
    for command in grammar["commands"]:
        text += f".TP\n.BR toolpace\\-{roff(command['name'])} (1)\n{roff(command['summary'])}\n"
    return text + ".SH SEE ALSO\n.BR toolpace\\-studio (1),\nthe handbook in /usr/share/doc/toolpace/html\n"


def studio_page(help_text, version):
    text = head("toolpace-studio", "Toolpace", version)
    text += ".SH NAME\ntoolpace\\-studio \\- motion\\-planning workbench for CNC machines\n.SH DESCRIPTION\n.nf\n"
    return text + roff("\n" + help_text).lstrip("\n") + ".fi\n.SH SEE ALSO\n.BR toolpace (1)\n"


def completion(grammar):
    """For bash: commands, their flags, the values of those that take names, and files elsewhere."""
    lines = ["# bash completion of toolpace, made of toolpace --grammar", "_toolpace() {",
             "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]} flags=",
             "  COMPREPLY=()", '  if [ "$COMP_CWORD" -eq 1 ]; then',
             f'    COMPREPLY=($(compgen -W "{" ".join(c["name"] for c in grammar["commands"])} --help --version" -- "$word"))',
             "    return", "  fi", '  case "$command $before" in']
    for command in grammar["commands"]:
        for flag in command["flags"]:
            if flag["kind"] == "word" and flag["name"] in VALUES:
                lines.append(f'    "{command["name"]} {flag["name"]}") COMPREPLY=($(compgen -W "{VALUES[flag["name"]]}" -- "$word")); return ;;')
    lines += ["  esac", '  case "$command" in']
    for command in grammar["commands"]:
        flags = " ".join(flag["name"] for flag in command["flags"] if flag["kind"] not in ARGUMENTS)
        lines.append(f'    {command["name"]}) flags="{flags} --help" ;;')
    lines += ["  esac", '  case "$word" in', '    -*) COMPREPLY=($(compgen -W "$flags" -- "$word")) ;;',
              '    *) compopt -o filenames 2>/dev/null; COMPREPLY=($(compgen -f -- "$word")) ;;', "  esac", "}",
              "complete -F _toolpace toolpace", ""]
    return "\n".join(lines)


def commands_page(grammar):
    text = "# Commands\n\n" + plain(grammar["footer"]) + "\n"
    for command in grammar["commands"]:
        words, shown = examples(command["footer"])
        text += f"\n## toolpace {command['name']}\n\n{command['summary']}.\n\n    {synopsis(command)}\n\n{words}\n\n"
        text += "| flag | |\n|---|---|\n"
        for flag in command["flags"]:
            letter = f"{flag['letter']}, " if flag["letter"] else ""
            row = plain(flag["text"]).replace("|", "\\|").replace("<", "&lt;").replace("$", "\\$")
            text += f"| `{letter}{flag['name']}{' ' + flag['unit'] if flag['unit'] else ''}` | {row} |\n"
        if shown:
            text += "\nExamples:\n\n" + "\n".join("    " + line for line in shown) + "\n"
    return text


def main(program, folder, studio=None):
    grammar = json.loads(subprocess.run([program, "--grammar"], check=True, capture_output=True).stdout)
    out = pathlib.Path(folder)
    (out / "man1").mkdir(parents=True, exist_ok=True)
    (out / "man1" / "toolpace.1").write_text(main_page(grammar))
    for command in grammar["commands"]:
        (out / "man1" / f"toolpace-{command['name']}.1").write_text(command_page(command, grammar["version"]))
    if studio:
        told = subprocess.run([studio, "--help"], check=True, capture_output=True, text=True).stdout
        (out / "man1" / "toolpace-studio.1").write_text(studio_page(told.split("\n", 1)[1], grammar["version"]))
    (out / "toolpace.bash").write_text(completion(grammar))
    (out / "commands.md").write_text(commands_page(grammar))


if __name__ == "__main__":
    main(*sys.argv[1:])
