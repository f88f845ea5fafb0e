#!/usr/bin/env python3
"""Checks the documents: commands exist, code blocks run, quoted output is current.

    docs_commands.py ROOT ADORE [ADRPLOT AGORE ADRINPUT]                        commands of all pages
    docs_commands.py --run [--update] [--show] ROOT ADORE [PAGE]...             code blocks of the tutorials and of find-an-input.md

Commands: a command is a line of code, or text between backquotes, that begins with a program's name. The words up to
the first option select a help text, which must list each --option of the command.

Code blocks: blocks `sh` run in bash, blocks `python` in one interpreter per page, in the order of the page and in one
new folder. A block `text` quotes lines of the output of the block above it: each line must be there, in this order,
with blanks compressed; `...` stands for anything, lines or a part of one. A block whose first line is "```sh no-run: REASON" does not run; the tutorials
together have at most 15 of them. PYTHONPATH must lead to the module `adore`. --update replaces quoted lines whose words
or whose numbers changed, not both; the text around them has to be read again then. --show prints the output of each
block.
"""

import os
import re
import subprocess
import sys
import tempfile
import time
from functools import cache
from pathlib import Path

FLAGS = {word for word in sys.argv[1:] if word.startswith("--")}
ROOT, *PROGRAM_FILES = [Path(word).resolve() for word in sys.argv[1:] if word not in FLAGS]
PROGRAMS = {program.name: str(program) for program in PROGRAM_FILES if program.suffix != ".md"}
ENVIRONMENT = dict(os.environ, QT_QPA_PLATFORM="offscreen")
MAX_NO_RUN = 15


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
        yield f"'{plain[0]}' is not a subcommand"
    for word in words[1:]:
        option = re.match(r"--[a-z][a-z0-9-]*", word)
        if option and not re.search(re.escape(option[0]) + r"(?![a-z0-9-])", text):
            yield f"'{option[0]}' is not an option of '{' '.join([program, *plain[:used]])}'"


PYTHON_SERVER = """
import sys
names = {"__name__": "__main__"}
while size := sys.stdin.readline():
    try:
        exec(compile(sys.stdin.read(int(size)), "block", "exec"), names)
        state = "done"
    except BaseException:
        import traceback
        traceback.print_exc(file=sys.stdout)
        state = "failed"
    print(f"\\n@@ {state}", flush=True)
"""


class Runner:
    """Runs the blocks of one page in a new folder."""

    def __init__(self, adore, folder):
        self.folder = folder
        # Equal digits on every x86-64 processor: the quoted numbers.
        self.environment = dict(ENVIRONMENT, ADORE_ISA="baseline", PATH=f"{adore.parent}:{os.environ['PATH']}", PYTHONUNBUFFERED="1")
        self.python = None

    def run(self, language, code):
        return self.run_python(code) if language == "python" else self.run_shell(code)

    def run_shell(self, code):
        done = subprocess.run(["bash", "-euo", "pipefail", "-c", code], cwd=self.folder, env=self.environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300)
        return done.returncode == 0, done.stdout

    def run_python(self, code):
        if not self.python:
            self.python = subprocess.Popen([sys.executable, "-c", PYTHON_SERVER], cwd=self.folder, env=self.environment, text=True,
                                           stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.python.stdin.write(f"{len(code)}\n{code}")
        self.python.stdin.flush()
        output = ""
        for line in self.python.stdout:
            if line.startswith("@@ "):
                return line == "@@ done\n", output
            output += line
        return False, output + "the interpreter ended"

    def close(self):
        if self.python:
            self.python.stdin.close()
            self.python.wait()


def compressed(line):
    return " ".join(line.split())


NUMBER = r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?"


def numbers_of(line):
    return re.findall(NUMBER, line)


def with_numbers_of(line, quote):
    """The quote with the numbers of a line whose words are the same; None for other words."""
    pieces = [piece for piece in re.split(rf"(\.\.\.|{NUMBER})", quote) if piece]
    kinds = {piece: f"({NUMBER})" for piece in pieces if re.fullmatch(NUMBER, piece)} | {"...": ".*"}
    match = re.fullmatch(" ?".join(kinds.get(piece) or re.escape(piece.strip()) for piece in pieces), line)
    if not match:
        return None
    found = iter(match.groups())
    return "".join(next(found) if re.fullmatch(NUMBER, piece) else piece for piece in pieces)


def is_quoted(line, quote):
    """`...` in a quote stands for any text."""
    return re.fullmatch(".*".join(re.escape(part.strip()) for part in quote.split("...")), line) is not None


def check_quote(quoted, output):
    """Faults of quoted lines, and the lines with today's words where only words changed."""
    lines, at, faults, current = [compressed(line) for line in output.splitlines()], 0, [], []
    for line in quoted:
        current.append(line)
        if compressed(line) in ("", "..."):  # blank lines and gaps
            continue
        found = next((i for i in range(at, len(lines)) if is_quoted(lines[i], compressed(line))), None)
        if found is None:
            faults.append(f"not in the output: {compressed(line)}")
            numbers = numbers_of(line)
            same = (i for i in range(at, len(lines)) if numbers and "..." not in line and numbers_of(lines[i]) == numbers)
            alike = [i for i in range(at, len(lines)) if with_numbers_of(lines[i], compressed(line))]
            found = next(same, None)
            if found is not None:
                current[-1] = output.splitlines()[found].strip()
            elif alike:  # the row of a table with most numbers in common
                found = max(alike, key=lambda i: len(set(numbers_of(lines[i])) & set(numbers)))
                current[-1] = with_numbers_of(lines[found], compressed(line))
            else:
                continue
        at = found + 1
    return faults, current


def blocks_of(lines):
    """First line, language, reason not to run, first and last line of the code: of each fenced block."""
    opened = None
    for i, line in enumerate(lines):
        if line.startswith("```") and opened is None:
            opened = i
        elif line.startswith("```"):
            language, _, reason = lines[opened][3:].strip().partition(" no-run: ")
            yield opened, language, reason, opened + 1, i
            opened = None


def run_page(page, adore):
    """Runs a page; faults, number of blocks that ran and that did not."""
    lines = page.read_text().splitlines()
    faults, ran, skipped, output = [], 0, 0, None
    replaced = {}
    with tempfile.TemporaryDirectory() as folder:
        runner = Runner(adore, folder)
        for first, language, reason, begin, end in blocks_of(lines):
            where = f"{page.relative_to(ROOT)}, line {first + 1}"
            if reason:
                skipped, output = skipped + 1, None
            elif language in ("sh", "python"):
                good, output = runner.run(language, "\n".join(lines[begin:end]) + "\n")
                ran += 1
                if "--show" in FLAGS:
                    print(f"== {where}\n{output}")
                if not good:
                    faults.append(f"{where}: the block fails:\n{output}")
                    break
            elif language == "text" and output is not None:
                found, replaced[begin, end] = check_quote(lines[begin:end], output)
                faults += [f"{where}: {fault}" for fault in found]
            elif language != "{toctree}":
                faults.append(f"{where}: block '{lines[first]}' is neither run, nor output, nor marked no-run")
        runner.close()
    if "--update" in FLAGS:
        for (begin, end), current in replaced.items():
            lines[begin:end] = current
        page.write_text("\n".join(lines) + "\n")
    return faults, ran, skipped


def run_tutorials():
    adore = next(program for program in PROGRAM_FILES if program.name == "adore")
    pages = [page for page in PROGRAM_FILES if page.suffix == ".md"]
    pages = pages or [*sorted((ROOT / "resources/docs/tutorials").glob("*.md")), ROOT / "resources/docs/how-to/find-an-input.md"]
    faults, ran, skipped = [], 0, 0
    for page in pages:
        began = time.monotonic()
        found, ran_here, skipped_here = run_page(page, adore)
        faults, ran, skipped = faults + found, ran + ran_here, skipped + skipped_here
        print(f"{page.name}: {ran_here} blocks ran, {skipped_here} did not, {len(found)} faults, {time.monotonic() - began:.0f} s", flush=True)
    print("\n".join(faults))
    return 1 if faults or ran == 0 or skipped > MAX_NO_RUN else 0


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
    sys.exit(run_tutorials() if "--run" in FLAGS else main())
