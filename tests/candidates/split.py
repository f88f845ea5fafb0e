#!/usr/bin/env python3
"""Splits published_bearings.json: 20 bearings for the rules of the candidates, all others for the test.

Only bearings with bore, outside diameter, C and C0 are split, in the order of the SHA-256 of their names.
Writes the member "set" of each bearing ("rules" or "test"); bearings without ratings have none.

    tests/candidates/split.py            write the file again
    tests/candidates/split.py --check    exit 1 if the file differs
"""
import hashlib
import json
import sys
from pathlib import Path

FILE = Path(__file__).with_name("published_bearings.json")
RULES = 20


def split(data):
    has_facts = [b for b in data["bearings"] if all(k in b for k in ("bore", "outside", "C", "C0"))]
    order = sorted(has_facts, key=lambda b: hashlib.sha256(b["name"].encode()).hexdigest())
    for b in data["bearings"]:
        b.pop("set", None)
    for i, b in enumerate(order):
        b["set"] = "rules" if i < RULES else "test"


def text(data):
    line = lambda value: json.dumps(value, ensure_ascii=False)
    head = "".join(f" {line(k)}: {line(data[k])},\n" for k in ("title", "about"))
    sources = ",\n".join(f"  {line(k)}: {line(v)}" for k, v in data["sources"].items())
    bearings = ",\n".join("  " + line(b) for b in data["bearings"])
    return f'{{\n{head} "sources": {{\n{sources}\n }},\n "bearings": [\n{bearings}\n ]\n}}\n'


if __name__ == "__main__":
    before = FILE.read_text(encoding="utf-8")
    data = json.loads(before)
    split(data)
    after = text(data)
    if "--check" in sys.argv[1:]:
        sys.exit(0 if after == before else f"{FILE}: the split differs; run {sys.argv[0]}")
    FILE.write_text(after, encoding="utf-8")
    sets = [b.get("set") for b in data["bearings"]]
    print(f"{len(sets)} bearings: {sets.count('rules')} for rules, {sets.count('test')} for the test, "
          f"{sets.count(None)} without ratings")
