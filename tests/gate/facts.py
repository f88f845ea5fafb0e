#!/usr/bin/env python3
"""Facts of a result file, one per line, for comparison by tests/gate/compare.sh: what must not change when texts do.

    facts.py PRINT.txt | RUN.json | RESULTS.h5

PRINT.txt   numeric cells of tables and lists in order, with their units. Cells stand two or more blanks apart; numbers within
            a sentence are not cells. The section on cost and start-up estimates made with a clock are left out.
RUN.json    path, type and, unless it is a text, value of every member. Left out: "measured", "findings" and "notes" (texts),
            and members with seconds in their name. An identifier (a text without blanks) counts as a value.
RESULTS.h5  path, kind, type, shape and SHA-256 of the values of every dataset; names and values of attributes, of labels,
            descriptions and texts with blanks only the name. Datasets that hold one text are read as JSON when they are JSON.
"""
import hashlib
import json
import re
import sys

TIMED = re.compile(r"[Mm]easured|[Cc]omput(ed|ing)|seconds")
NUMBER = re.compile(r"[-+]?\d+(\.\d*)?([eE][-+]?\d+)?$|not computed$|infinite$")
UNIT = re.compile(r"\[?[A-Za-z0-9./^*%-]{1,12}\]?$")
TEXTS = {"measured", "findings", "notes"}


def of_listing(text):
    skipped = False
    for line in text.splitlines():
        if re.match(r" *Cost: (where the )?computing time", line):
            skipped = True
        if skipped:
            skipped = not re.match(r" *whole run", line)
            continue
        if TIMED.search(line):
            continue
        cells = re.split(r"  +", line.strip())
        for i, cell in enumerate(cells):
            # The first cell of a row with others is its label; it counts when it is a number.
            if NUMBER.match(cell) and (len(cells) > 1):
                unit = cells[i + 1] if i + 1 < len(cells) and UNIT.match(cells[i + 1]) else ""
                yield cell + (" " + unit if unit and not NUMBER.match(unit) else "")


def of_json(value, path=""):
    if isinstance(value, dict):
        for key, member in value.items():
            if key in TEXTS or "seconds" in key:
                continue
            yield from of_json(member, f"{path}/{key}")
        yield f"{path} object of {len(value.keys() - TEXTS)}"
    elif isinstance(value, list):
        yield f"{path} list of {len(value)}"
        for i, member in enumerate(value):
            yield from of_json(member, f"{path}/{i}")
    elif isinstance(value, str):
        yield f"{path} text" + ("" if re.search(r"\s", value) else f" {value}")
    else:
        yield f"{path} {type(value).__name__} {value!r}"


def of_hdf5(file):
    import h5py

    def text_of(value):
        return value.decode() if isinstance(value, bytes) else value if isinstance(value, str) else None

    def of_text(path, text):
        try:
            yield from of_json(json.loads(text), path)
        except ValueError:
            yield f"{path} text" + ("" if re.search(r"\s", text) else f" {text}")

    def of_object(path, thing):
        for name in sorted(thing.attrs):
            value = thing.attrs[name]
            text = text_of(value)
            if name in ("label", "description"):
                yield f"{path}@{name}"
            elif text is not None:
                yield from of_text(f"{path}@{name}", text)
            else:
                yield f"{path}@{name} {value!r}"

    found = []
    with h5py.File(file, "r") as h5:
        found.extend(of_object("", h5))

        def visit(path, thing):
            found.extend(of_object(path, thing))
            if not isinstance(thing, h5py.Dataset):
                return
            value = thing[()]
            text = text_of(value)
            if text is not None:
                found.extend(of_text(path, text))
                return
            data = value.tobytes() if value.dtype != object else repr(value.tolist()).encode()
            found.append(f"{path} dataset {thing.dtype} {thing.shape} {hashlib.sha256(data).hexdigest()[:16]}")

        h5.visititems(visit)
    return found


def main():
    if len(sys.argv) != 2 or sys.argv[1] in ("-h", "--help"):
        sys.exit(__doc__)
    name = sys.argv[1]
    if name.endswith(".h5"):
        facts = of_hdf5(name)
    else:
        with open(name, encoding="utf-8") as file:
            facts = of_json(json.load(file)) if name.endswith(".json") else of_listing(file.read())
    for fact in facts:
        print(fact)


main()
