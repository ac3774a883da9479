"""Makes the manual page and the completion of bash from the help of the program.

    scripts/manual.py PROGRAM PAGE.gz COMPLETION

Reads `PROGRAM --help` and `PROGRAM COMMAND --help` of each of its commands. The build does it (target manual).
"""
import gzip
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path


@dataclass
class Help:
    """Parts of a help text: sentences, usage, [(term, meaning)] under the title of each table, and the
    remaining lines."""

    about: list = field(default_factory=list)
    usage: str = ""
    tables: dict = field(default_factory=dict)
    notes: list = field(default_factory=list)

    def entries(self, options):
        """The options, or the other arguments of the command."""
        return [(term, what) for title, entries in self.tables.items() if title != "Subcommands"
                for term, what in entries if term.startswith("-") == options]


def parse(text):
    """The parts of a help text in the form of CLI11 or of argparse: titles end in a colon, entries are
    indented by two spaces, and meanings are two spaces further on or in lines with a larger indent."""
    help_text, table = Help(), None
    for line in text.splitlines():
        indent = len(line) - len(line.lstrip())
        if line.lower().startswith("usage:"):
            help_text.usage = line[6:].strip()
        elif re.fullmatch(r"[A-Z][a-z ]*:|[a-z]+( arguments)?:", line):
            table = help_text.tables.setdefault(line[:-1], [])
        elif not line.strip():
            pass
        elif indent == 0 or table is None:
            table = None
            (help_text.notes if help_text.tables else help_text.about).append(line)
        elif indent == 2:
            term, _, what = line.strip().partition("  ")
            table.append((term, what.strip()))
        elif table and indent > 2:
            table[-1] = (table[-1][0], f"{table[-1][1]} {line.strip()}".strip())
    return help_text


def ask(program, *command):
    """Output of --help of the program, without line breaks within sentences."""
    help_text = subprocess.run([program, *command, "--help"], capture_output=True, text=True, check=False,
                          env={**os.environ, "COLUMNS": "1000", "LC_ALL": "C.UTF-8"})
    if help_text.returncode != 0:
        sys.exit(f"manual.py: {' '.join([program, *command, '--help'])} ended with {help_text.returncode}: {help_text.stderr}")
    parsed = parse(help_text.stdout)
    parsed.usage = re.sub(r"^\S+", "hawser", parsed.usage)
    return parsed


def roff(text):
    """Text that groff prints unchanged; lists of choices may be broken after a comma."""
    text = re.sub(r",(?=\w)", r",\\:", text.replace("\\", "\\e").replace("-", "\\-").replace("`", "\\(ga"))
    return "\\&" + text if text[:1] in (".", "'") else text


def page(version, top, commands):
    """The manual page."""
    name, _, about = top.about[0].partition(": ")
    out = [f'.TH {name.upper()} 1 "" "{version}" "User Commands"', ".nh", ".ad l",
           ".SH NAME", f"{name} \\- {roff(about.rstrip('.'))}", ".SH SYNOPSIS"]
    for i, usage in enumerate([top.usage, *(c.usage for _, _, c in commands)]):
        out += ([".br"] if i else []) + [roff(usage)]
    out += [".SH OPTIONS"] + items(top.entries(True)) + [".SH COMMANDS"]
    for command, summary, help_text in commands:
        out += [f".SS {name} {command}", *(roff(line) for line in help_text.about or [summary])]
        out += items(help_text.entries(False) + help_text.entries(True))
        out += prose([line for line in help_text.notes if line not in top.notes])
    out += [".SH NOTES", *prose(top.notes)[1:]]
    out += [".SH FILES", "Below the folder of the installation, such as /usr or /usr/local:"]
    out += items([("share/hawser/cases", "example cases; copy them to your folder, since results are written beside the case"),
                  ("share/doc/hawser", "the user guide, theory and verification"),
                  ("share/doc/hawser/docs/case.schema.json", "the schema of case files, for editors")])
    out += [".SH SEE ALSO", ".BR mpirun (1)"]
    return "\n".join(out) + "\n"


def items(entries):
    """A list of terms with their meanings."""
    out = []
    for term, what in entries:
        out += [".TP", f".B {roff(term)}", roff(what) or "\\&"]
    return out


def prose(lines):
    """Sentences, one in each paragraph, and commands (indented in the help) in separate lines."""
    out = []
    for line in lines:
        out += [".PP"] + ([".RS 4", ".nf", roff(line.strip()), ".fi", ".RE"] if line.startswith(" ") else [roff(line)])
    return out


def options_of(help_text):
    """The words that begin with - among the terms: '-o,--output TEXT' has two."""
    return [word for term, _ in help_text.entries(True) for word in re.findall(r"(?<![\w-])--?[A-Za-z][\w-]*", term)]


def choices_of(help_text):
    """{option or "": words}: the allowed values of an option or, under "", of the second argument."""
    out = {}
    for term, _ in help_text.entries(True) + help_text.entries(False):
        if found := re.search(r"\{([\w,.-]+)\}", term):
            words = " ".join(found[1].split(","))
            names = re.findall(r"(?<![\w-])--?[A-Za-z][\w-]*", term.partition("{")[0])
            out["|".join(names)] = words
    return out


COMPLETION = """# Completion of bash for hawser. Made by scripts/manual.py from the program's help; don't edit by hand.
_hawser() {
  local cur=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]-} options choices=
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    mapfile -t COMPREPLY < <(compgen -W '@COMMANDS@' -- "$cur")
    return
  fi
  case $command in
@OPTIONS@
    *) return ;;
  esac
  case $command/$before in
@VALUES@
  esac
  if [ -n "$choices" ]; then
    mapfile -t COMPREPLY < <(compgen -W "$choices" -- "$cur")
  elif [[ $cur == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$cur")
  elif [ "$COMP_CWORD" -eq 2 ]; then
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -d -- "$cur"; compgen -f -X '!*.yaml' -- "$cur"; compgen -f -X '!*.h5' -- "$cur")
  fi
}
complete -o default -F _hawser hawser
"""


def completion(top, commands):
    """The function with which bash completes the word at the cursor."""
    options, values = [], []
    for command, _, help_text in commands:
        options.append(f"    {command}) options='{' '.join(options_of(help_text))}' ;;")
        for names, words in choices_of(help_text).items():
            if names:
                values.append(f"    {'|'.join(f'{command}/{n}' for n in names.split('|'))}) choices='{words}' ;;")
            else:
                values.append(f"    {command}/*) [ \"$COMP_CWORD\" -ne 3 ] || choices='{words}' ;;")
    values.sort(key=lambda line: "/*)" in line)
    words = " ".join([c for c, _, _ in commands] + [w for w in options_of(top) if w.startswith("--")])
    return (COMPLETION.replace("@COMMANDS@", words).replace("@OPTIONS@", "\n".join(options))
            .replace("@VALUES@", "\n".join(values) or "    *) ;;"))


def everything(program):
    """The help of the program, and [(command, its line in that help, the help of the command)]."""
    top = ask(program)
    entries = top.tables["Subcommands"]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        return top, [(word, what, help_text)
                     for (word, what), help_text in zip(entries, pool.map(lambda entry: ask(program, entry[0]), entries))]


def make(program, page_path, completion_path):
    """Writes both files and returns the result of `everything`."""
    version = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    top, commands = everything(program)
    for path, content in ((page_path, gzip.compress(page(version, top, commands).encode(), 9, mtime=0)),
                          (completion_path, completion(top, commands).encode())):
        Path(path).parent.mkdir(parents=True, exist_ok=True)
        Path(path).write_bytes(content)
    return top, commands


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    make(*sys.argv[1:])
