#!/usr/bin/python3
"""Varies each input of the reference cases and counts what the adapters make of it.

    vary_inputs.py PROGRAM FILE... [--sample N] [--seed S] [--seconds S] [--report FILE] [--verbose]

PROGRAM is `adore`; FILE are reference cases (tests/reference/*.json). Each number of a case's inputs becomes 20 % smaller and larger, each whole
number smaller and larger by one, one at a time. `adore validate` either solves the case or rejects it. A rejection must name an input and the
violated condition; an internal error ("this is a bug"), a crash, no answer within the time limit, or a rejection that names no input is a
failure. Trajectories are cut to their first samples; expected values are left out, because they are those of other inputs.
--sample takes N variations per file, chosen by the seed. The table states the rejected share per family.
"""

import argparse
import collections
import json
import os
import pathlib
import random
import re
import subprocess
import sys

# Inputs that messages call by the term of the trade.
TERMS = {"D": "diameter", "dm": "pitch diameter", "fi": "inner groove factor", "fo": "outer groove factor", "nRe": "pockets", "nCseg": "segments",
         "Z": "elements", "f_inner": "inner groove factor", "f_outer": "outer groove factor", "f_from": "groove radius", "f_to": "groove radius",
         "S": "survival probability", "k": "half axes"}
KEPT_SAMPLES = 3  # of trajectories
BATCH = 200


def numbers(value, path=()):
    """Paths and values of all numbers of the inputs but 0."""
    if isinstance(value, dict):
        for key, one in value.items():
            yield from numbers(one, path + (key,))
    elif isinstance(value, list):
        for k, one in enumerate(value):
            yield from numbers(one, path + (k,))
    elif isinstance(value, (int, float)) and not isinstance(value, bool) and value != 0:
        yield path, value


def changed(inputs, path, value):
    copy = json.loads(json.dumps(inputs))
    place = copy
    for key in path[:-1]:
        place = place[key]
    place[path[-1]] = value
    return copy


def shape(expected):
    """Parts of the expected values that adapters read: samples, rows, quantities."""
    out = {}
    for key, value in expected.items():
        if key in ("t", "times", "states", "rows") and isinstance(value, list):
            out[key] = value[:KEPT_SAMPLES]
        elif key == "fft_bin_Hz":
            out[key] = value
    return out


def variations(case):
    inputs = case["inputs"]
    for path, value in numbers(inputs):
        if path[0] in ("times", "description", "keys"):
            continue
        steps = (value - 1, value + 1) if isinstance(value, int) else (0.8 * value, 1.2 * value)
        for new in steps:
            name = ".".join(map(str, path))
            yield {**case, "id": f"{case['id']}: {name} = {new:.6g} ({value:.6g})", "inputs": changed(inputs, path, new),
                   "provenance": "computed"}


def cut(family, cases):
    for case in cases:
        case = dict(case)
        inputs = dict(case["inputs"])
        if isinstance(inputs.get("times"), list):
            inputs["times"] = inputs["times"][:KEPT_SAMPLES]
        case["inputs"] = inputs
        case["expected"] = shape(case["expected"]) or {"?": 0}
        if family.startswith("tribology"):
            case["tolerance"] = 1.0  # of the quantities that are left out
        yield case


def ask(program, family, cases, seconds):
    """Message of each case, empty: solved; None: crashed or too slow."""
    text = json.dumps({"family": family, "cases": cases})
    try:
        done = subprocess.run([program, "validate", "-", "--json"], input=text, capture_output=True, text=True, timeout=seconds)
        answers = json.loads(done.stdout)["files"][0]["cases"]
    except (subprocess.TimeoutExpired, json.JSONDecodeError):
        if len(cases) == 1:
            return [None]
        half = len(cases) // 2
        return ask(program, family, cases[:half], seconds) + ask(program, family, cases[half:], seconds)
    return ["" if "evaluation" in one else one.get("message", "") or None for one in answers]


def names_an_input(message, inputs):
    words = set(re.findall(r"[a-z0-9]+", message.lower()))
    for path, _ in numbers(inputs):
        for key in path:
            if isinstance(key, str) and (key in message or TERMS.get(key, key) in message or all(part in words for part in re.findall(r"[a-z0-9]+", key.lower()))):
                return True
    return any(isinstance(key, str) and key in message for key in inputs)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("files", nargs="+", type=pathlib.Path)
    parser.add_argument("--sample", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=600.0)
    parser.add_argument("--report", type=pathlib.Path)
    parser.add_argument("--verbose", action="store_true", help="list rejections too")
    options = parser.parse_args()
    dice = random.Random(options.seed)
    rows, failures = [], []
    for file in sorted(options.files):
        content = json.loads(file.read_text())
        family = content["family"]
        bases = {case["id"]: case for case in content["cases"] if "base" not in case["inputs"]}
        cases = [one for case in cut(family, bases.values()) for one in variations(case)]
        if options.sample and options.sample < len(cases):
            cases = dice.sample(cases, options.sample)
        messages = []
        for k in range(0, len(cases), BATCH):
            messages += ask(options.program, family, cases[k:k + BATCH], options.seconds)
        count = collections.Counter()
        for case, message in zip(cases, messages):
            if message == "":
                count["solved"] += 1
            elif message is None or "this is a bug" in message or not names_an_input(message, case["inputs"]):
                count["failed"] += 1
                failures.append(f"{family} {case['id']}: {message or 'crash or no answer'}")
            else:
                count["rejected"] += 1
                if options.verbose:
                    print(f"rejected {family} {case['id']}: {message}")
        total = max(len(cases), 1)
        rows.append(f"| {family} | {len(cases)} | {count['solved']} | {count['rejected']} | {100 * count['rejected'] / total:.1f} % | {count['failed']} |")
        print(rows[-1], flush=True)
    head = ["| family | variations | solved | rejected | rejected share | failed |", "|---|---|---|---|---|---|"]
    if options.report:
        options.report.write_text("\n".join(head + rows) + "\n")
    print("\n".join(failures))
    print(f"{len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
