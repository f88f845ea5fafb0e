#!/usr/bin/env python3
"""Checks that the tables of the pages have an origin, and that printed ones are current.

    docs_tables.py ROOT [--list]                  each page with tables states where they are from
    docs_tables.py ROOT --compare ADORE [PAGE]... the tables of pages of PRINTED are those that the command prints

A page with tables is in DEFINITIONS or PRINTED, or has a line "Tables: ..." above its first table. That line has a date (2026-11-27: the last
measurement) and the script, command or test of the project that wrote or measured the tables. --list prints the pages with the number of
their tables and their origin. Numbers of compared tables may differ by 1 % or by one in the last digit: other math libraries round otherwise.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(sys.argv[1]).resolve()
DOCS = ROOT / "resources/docs"

# Pages whose tables are definitions, rules or lists of links: written by hand, without measured values.
DEFINITIONS = {
    "architecture.md": "folders of the project",
    "developer/index.md": "links",
    "developer/testing.md": "commands",
    "glossary.md": "terms",
    "how-to/bearing-from-facts.md": "members of a file format",
    "how-to/effect.md": "interfaces and files",
    "how-to/extension-file.md": "records",
    "how-to/index.md": "links",
    "how-to/projects.md": "menus and files",
    "how-to/user-routine.md": "interfaces",
    "library.md": "headers",
    "python-tour.md": "exit codes",
    "outputs.md": "layout of the files; tests compare the layout with written files",
    "readings.md": "rules",
    "reference/index.md": "links",
    "theory/cage_and_motion.md": "laws",
    "theory/index.md": "laws and links",
    "theory/life.md": "laws",
    "theory/thermal.md": "laws and units",
}
# Pages that a command prints.
PRINTED = {
    "calculators.md": "calc --list --markdown",
    "deck-reference.md": "schema --format md",
    "experiments.md": "validate --experiments --markdown",
    "findings.md": "check --codes",
    "friction-torque.md": "validate --torque --markdown",
}
# Of these, pages that have other tables, too, with their origin in a line "Tables: ...".
ALSO_BY_HAND = {"friction-torque.md"}
LARGEST_DIFFERENCE = 0.01


def tables_of(text):
    return len(re.findall(r"^\|[ :|-]+\|$", text, re.MULTILINE))


def faults_of(name, text):
    if name in DEFINITIONS:
        return
    line = re.search(r"^Tables: .*(?:\n\S.*)*", text, re.MULTILINE)
    if name in PRINTED:
        words = PRINTED[name].split()
        if not all(word in text.split("\n|")[0] for word in ("adore", *words[:2])):
            yield f"does not name `adore {PRINTED[name]}` above its first table"
        if name not in ALSO_BY_HAND:
            return
    if line is None:
        yield 'no line "Tables: ..." that states the origin of its tables'
        return
    if re.search(r"^\|[ :|-]+\|$", text[: line.start()], re.MULTILINE):
        yield 'a table above the line "Tables: ..."'
    if not re.search(r"\b20\d\d-\d\d-\d\d\b", line[0]):
        yield 'no date in the line "Tables: ..."'
    sources = re.findall(r"`((?:tests|core|resources)/[\w./-]+)", line[0])
    programs = re.findall(r"`(adore |test_|bench_|ctest )", line[0])
    if not sources and not programs:
        yield 'no command, script or test in the line "Tables: ..."'
    for source in sources:
        if not (ROOT / source).exists():
            yield f"{source} does not exist"


def is_same(row, other):
    if row == other:
        return True
    number = r"-?\d[\d,]*\.?\d*(?:e[-+]?\d+)?"
    if re.sub(number, "#", row) != re.sub(number, "#", other):
        return False
    for one, two in zip(re.findall(number, row), re.findall(number, other)):
        a, b = (float(word.replace(",", "")) for word in (one, two))
        digits = len(one.split("e")[0].partition(".")[2])
        last = 10.0 ** (int(one.partition("e")[2] or 0) - digits)
        if abs(a - b) > max(LARGEST_DIFFERENCE * abs(a), 1.001 * last):
            return False
    return True


def rows_of(text):
    return [" ".join(line.split()) for line in text.splitlines() if line.startswith("|")]


def summary_of_torque(text):
    """Faults of the summary of friction-torque.md: ranges of the last column (ours over the formula) of the printed rows."""
    ranges, section = {}, ""
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if line.startswith("## "):
            section = line[3:]
        elif line.startswith("| ") and re.fullmatch(r"[\d.]+", cells[0]) and len(cells) == 13:
            slow = float(cells[2]) < 1000
            low, high = ranges.get((section, slow), (float("inf"), 0.0))
            ranges[section, slow] = min(low, float(cells[-1])), max(high, float(cells[-1]))
    rows = [[cell.strip() for cell in row.strip("|").split("|")] for row in rows_of(text)]
    summary = [row for row in rows if len(row) == 5 and " to " in row[1]]
    if len(summary) * 2 != len(ranges):
        yield f"the summary has {len(summary)} rows, the page {len(ranges) // 2} sections"
    for row in summary:
        for cell, slow in ((row[1], True), (row[2], False)):
            expected = "{:.2f} to {:.2f}".format(*ranges.get((row[0], slow), (0.0, 0.0)))
            if not is_same(cell, expected):
                yield f"{row[0]}: {cell} in the summary, {expected} in its rows"


def compare(adore, pages):
    """Printed rows are rows of the page in the same order; further rows of the page are written by hand."""
    failed = 0
    for name in pages or PRINTED:
        command = [adore, *PRINTED[name].split()]
        # The same digits on every machine: an equilibrium among others nearby may depend on rounding.
        environment = dict(os.environ, ADORE_ISA="baseline")
        printed = rows_of(subprocess.run(command, capture_output=True, text=True, check=True, env=environment).stdout)
        text = (DOCS / name).read_text()
        written = rows_of(text)
        faults, by_hand, at = [], 0, 0
        for row in printed:
            found = next((k for k in range(at, len(written)) if is_same(written[k], row)), None)
            if found is None:
                faults.append(f"not in the page: {row}")
            else:
                by_hand, at = by_hand + found - at, found + 1
        by_hand += len(written) - at
        if not printed or (by_hand and name not in ALSO_BY_HAND):
            faults.append(f"{by_hand} rows of the page are not printed")
        if name == "friction-torque.md":
            faults += summary_of_torque(text)
        print(f"{name}: {len(printed)} rows printed by `adore {PRINTED[name]}`, {by_hand} by hand, {len(faults)} faults")
        print("".join(f"  {fault}\n" for fault in faults[:5]), end="")
        failed += bool(faults)
    return 1 if failed else 0


def main():
    count = failed = 0
    pages = [page for page in sorted(DOCS.rglob("*.md")) if "decisions" not in page.parts]
    for page in pages:
        name, text = str(page.relative_to(DOCS)), page.read_text()
        tables = tables_of(text)
        if tables == 0:
            continue
        count += tables
        if "--list" in sys.argv:
            origin = DEFINITIONS.get(name) or PRINTED.get(name) or "stated in the page"
            print(f"{tables:4d} {name}: {origin}")
        for fault in faults_of(name, text):
            print(f"{name}: {fault}")
            failed += 1
    known = {str(page.relative_to(DOCS)) for page in pages}
    for name in [*DEFINITIONS, *PRINTED]:
        if name not in known or tables_of((DOCS / name).read_text()) == 0:
            print(f"{name}: listed in {Path(__file__).name}, and has no table")
            failed += 1
    print(f"{count} tables, {failed} faults")
    return 1 if failed else 0


if "--compare" in sys.argv:
    sys.exit(compare(sys.argv[3], sys.argv[4:]))
sys.exit(main())
