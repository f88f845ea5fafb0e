#!/usr/bin/env python3
"""Draws texts and names that two readers judge: 26 strings of each of six parts, and 100 identifiers.

    draw_sample.py ROOT [--seed TEXT] > sample.md

The seed is the hash of the last commit unless given, so that nobody chooses the draw. Strings are those of six words and
more that users can see; identifiers are types, functions and members that headers declare. resources/docs/developer/language.md
has the rules and the results.
"""

import argparse
import random
import re
import subprocess
import sys
from pathlib import Path

import check_language
import texts

PARTS = {
    "checks and messages": ("core/base/", "core/deck/", "core/setup/", "core/runs/", "core/design/", "core/bearing/", "core/user/", "core/dynamics/"),
    "listing and laws": ("core/listing/", "core/results/", "core/life/", "core/tribology/", "core/thermal/", "core/statics/", "core/scene/"),
    "calculators and studies": ("core/calculators/", "core/studies/", "core/validation/", "core/drawing/"),
    "command line": ("cli/",),
    "AdrInput": ("adrinput/",),
    "AdrPlot, AGORE": ("adrplot/", "agore/", "desktop/"),
}
EACH, NAMES, LEAST_WORDS = 26, 100, 6


def names_of(root):
    """Types, functions and members that headers declare, once each, with their file."""
    out = {}
    declared = re.compile(r"\b(?:class|struct|enum class)\s+(\w+)|\b[\w:<>,&*]+\s+[&*]?(\w+)\(|\b(\w+_)\s*(?:;|=|\{)")
    for file in check_language.files_of(root):
        if file.endswith(".hpp") and not file.startswith("tests/"):
            source = texts.TOKEN.sub(" ", (root / file).read_text(errors="replace"))
            for found in declared.finditer(source):
                name = next(filter(None, found.groups()))
                if len(name) > 2 and name not in ("return", "explicit", "operator", "noexcept", "sizeof"):
                    out.setdefault(name, file)
    return sorted(out.items())


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("root", type=Path)
    parser.add_argument("--seed")
    options = parser.parse_args()
    seed = options.seed or subprocess.run(["git", "-C", options.root, "rev-parse", "HEAD"], capture_output=True, text=True, check=True).stdout.strip()
    draw = random.Random(seed)
    strings = check_language.collect(options.root)["strings"]
    print(f"# Texts drawn with the seed {seed}\n\n| no. | part | place | text | reader 1 | reader 2 |\n|---|---|---|---|---|---|")
    number = 0
    for part, folders in PARTS.items():
        pool = sorted({(file, " ".join(text.split())) for file, _, text in strings
                       if file.startswith(folders) and len(texts.words_of(text)) >= LEAST_WORDS})
        if len(pool) < EACH:
            sys.exit(f"draw_sample.py: the part '{part}' has {len(pool)} strings")
        for file, text in draw.sample(pool, EACH):
            number += 1
            print(f"| {number} | {part} | {file} | {text.replace('|', chr(92) + '|')} |  |  |")
    for name, file in draw.sample(names_of(options.root), NAMES):
        number += 1
        print(f"| {number} | name | {file} | `{name}` |  |  |")


if __name__ == "__main__":
    main()
