#!/usr/bin/env python3
"""Processor seconds of `adore plan` compared with those of `adore run`.

    plan_seconds.py ADORE [--out TABLE.md] [--keep FILE.json] [DECK ...]

Decks: the examples of `adore examples` to their own end, and five catalogue bearings, three of them in oil, in motion
(mode = 0) over --turns revolutions. Both times are user + system time of the whole process. --keep FILE.json stores
finished decks: a broken-off campaign continues there.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

CATALOGUE = [
    ("6205", ["mode=0"]),
    ("NU209", ["mode=0"]),
    ("7208 B", ["mode=0", "kTrac=6"]),
    ("30208", ["mode=0", "kTrac=6"]),
    ("22210", ["mode=0", "kTrac=3"]),
]


def processor(command: list[str]) -> tuple[float, int, str, str]:
    """User + system time [s], exit code and both streams of a command."""
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        child = subprocess.Popen(command, stdout=out, stderr=err)
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        err.seek(0)
        return (
            usage.ru_utime + usage.ru_stime,
            child.returncode,
            out.read().decode(errors="replace"),
            err.read().decode(errors="replace"),
        )


def measure(adore: str, deck: str, until: str | None, sets: list[str]) -> dict:
    extra = [word for one in sets for word in ("--set", one)] + (["--until", until] if until else [])
    cost, code, out, err = processor([adore, "plan", deck, "--json", *extra])
    if code != 0:
        return {"failure": err.strip().splitlines()[-1][:200] if err.strip() else f"exit {code}"}
    plan = json.loads(out)
    if "run_cost" not in plan:
        return {"failure": "the plan has no processor time"}
    predicted = plan["run_cost"].get("processor_s")
    if predicted is None:
        return {"failure": plan["run_cost"].get("failure", "no figure")}
    with tempfile.TemporaryDirectory() as folder:
        seconds, code, _, err = processor([adore, "run", deck, "--out", folder, "--quiet", *extra])
    if code != 0:
        return {"failure": "the run fails: " + (err.strip().splitlines() or [""])[-1][:120]}
    return {
        "until": until or "the deck's end",
        "predicted": predicted,
        "whole": plan["run_cost"]["whole"],
        "plan": cost,
        "run": seconds,
        "off": predicted / seconds - 1.0,
    }


def decks(adore: str, folder: Path) -> list[tuple[str, str, list[str]]]:
    out = []
    for info in json.loads(processor([adore, "examples", "--json"])[2]):
        path = folder / f"{info['name']}.txt"
        processor([adore, "new", info["name"], "--out", str(path)])
        out.append((info["name"], str(path), []))
    for designation, sets in CATALOGUE:
        path = folder / f"catalogue {designation}.txt"
        processor([adore, "new", "--catalogue", designation, "--out", str(path)])
        out.append((f"{designation}{', in oil (' + sets[1] + ')' if len(sets) > 1 else ''}", str(path), sets))
    return out


def table(rows: dict[str, dict]) -> str:
    good = {name: row for name, row in rows.items() if "off" in row}
    text = "| deck | end | plan [s] | run [s] | difference | pilot of the whole run | cost of the plan [s] |\n"
    text += "|---|---|---:|---:|---:|---|---:|\n"
    for name, row in rows.items():
        if "off" not in row:
            text += f"| {name} | | | | {row['failure']} | | |\n"
            continue
        text += (
            f"| {name} | {row['until']} | {row['predicted']:.2f} | {row['run']:.2f} | {100 * row['off']:+.0f} % "
            f"| {'yes' if row['whole'] else 'no'} | {row['plan']:.2f} |\n"
        )
    if good:
        within = sum(abs(row["off"]) <= 0.2 for row in good.values())
        low = sum(row["off"] < 0 for row in good.values())
        text += (
            f"\nWithin 20 %: {within} of {len(good)} ({100 * within / len(good):.0f} %). Too low: {low}, too high: "
            f"{len(good) - low}. Median difference {100 * statistics.median(abs(r['off']) for r in good.values()):.0f} %.\n"
        )
    return text


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("adore")
    parser.add_argument("names", nargs="*", help="only decks whose name contains one of these")
    parser.add_argument("--out")
    parser.add_argument("--keep")
    parser.add_argument("--turns", type=float, default=6.0)
    args = parser.parse_args()
    rows: dict[str, dict] = {}
    if args.keep and Path(args.keep).exists():
        rows = json.loads(Path(args.keep).read_text())
    folder = Path(tempfile.mkdtemp())
    try:
        for name, path, sets in decks(args.adore, folder):
            if name in rows or (args.names and not any(part in name for part in args.names)):
                continue
            row = measure(args.adore, path, f"{args.turns:g}rev" if sets else None, sets)
            rows[name] = row
            print(name, row, file=sys.stderr, flush=True)
            if args.keep:
                Path(args.keep).write_text(json.dumps(rows, indent=1))
    finally:
        shutil.rmtree(folder)
    text = table(rows)
    print(text)
    if args.out:
        Path(args.out).write_text(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
