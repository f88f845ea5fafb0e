#!/usr/bin/env python3
"""Every command that README and the pages of resources/docs show is one that the programs know.

Usage: docs_commands.py ROOT ADORE [ADRPLOT AGORE ADRINPUT]. A command is what stands in a line of code or between
backquotes and begins with a program's name; its words up to the first option choose a help text, in which each
--option has to stand.
"""

import os
import re
import subprocess
import sys
from functools import cache
from pathlib import Path

ROOT = Path(sys.argv[1])
PROGRAMS = {Path(program).name: program for program in sys.argv[2:]}
ENVIRONMENT = dict(os.environ, QT_QPA_PLATFORM="offscreen")


@cache
def run(*words):
    done = subprocess.run(words, capture_output=True, text=True, env=ENVIRONMENT, timeout=60)
    return done.returncode, done.stdout


@cache
def help_of(program, words):
    """The help of the longest chain of subcommands, and how many words it has."""
    found = run(PROGRAMS[program], "--help")
    used = 0
    for word in words if program == "adore" else ():
        if not re.fullmatch(r"[a-z][a-z-]*", word):
            break
        code, text = run(PROGRAMS[program], *words[:used], word, "--help")
        if code != 0 or text == found[1]:
            break
        found, used = (code, text), used + 1
    return found[1], used


def commands_of(page):
    in_code = False
    for number, line in enumerate(page.read_text().splitlines(), 1):
        if line.lstrip().startswith("```"):
            in_code = not in_code
            continue
        parts = [line] if in_code or line.startswith("    ") else re.findall(r"`([^`]+)`", line)
        for part in parts:
            for piece in re.split(r"#|;|&&|\|", part):
                words = re.sub(r"^\s*(?:\$ |or:|[A-Z_]+=\S+ |\S*/(?=ad?gore|adr|adore))+", "", piece.strip()).split()
                if words and Path(words[0]).name in PROGRAMS:
                    yield number, [Path(words[0]).name, *words[1:]]


def faults_of(words):
    program = words[0]
    plain = []
    for word in words[1:]:
        if word.startswith("-"):
            break
        plain.append(word)
    text, used = help_of(program, tuple(plain))
    if program == "adore" and plain and used == 0 and re.fullmatch(r"[a-z][a-z-]*", plain[0]):
        yield f"'{plain[0]}' is no subcommand"
    for word in words[1:]:
        option = re.match(r"--[a-z][a-z0-9-]*", word)
        if option and not re.search(re.escape(option[0]) + r"(?![a-z0-9-])", text):
            yield f"'{option[0]}' is no option of '{' '.join([program, *plain[:used]])}'"


def main():
    pages = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "resources/docs").rglob("*.md"))]
    pages = [page for page in pages if "decisions" not in page.parts]
    count, faults = 0, []
    for page in pages:
        for number, words in commands_of(page):
            count += 1
            faults += [f"{page.relative_to(ROOT)}, line {number}: {fault}: {' '.join(words)}" for fault in faults_of(words)]
    print("\n".join(faults))
    print(f"{count} commands in {len(pages)} pages, {len(faults)} faults")
    return 1 if faults or count < 40 else 0


if __name__ == "__main__":
    sys.exit(main())
