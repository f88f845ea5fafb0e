#!/usr/bin/python3
"""Checks that results do not depend on the start: every jump of the equilibrium against a clean start of the same deck.

    start_independence.py PROGRAM [--small] [--types T,T] [--modes M,M] [--jumps J,J] [--opt NAME=VALUE]... [--table FILE]

PROGRAM is `adore`. Jumps: thermal (cold start of a deck with kTherm 1), oil (the same with a film of oil), load (continuation with twice the load), speed (continuation with
1.3 times the speed), mode (start from FINAL of another mode), orbit (record 9.5 from the first step, cages with guide lands). For each type and mode:
  peak   largest contact load of the run <= 1.2 of the larger of both equilibria, or of the clean start if that is larger
  load   mean largest load of the window within 5 % of the clean start
  life   run_life_hours of the window within 5 % of the clean start
  exit   0
The window follows the revolution after the jump; its life comes from the damage of two runs (t2/L2 - t1/L1).
  kelvin temperatures of the bearing at the end within 0.5 K (thermal, oil)
A thermal jump is compared with starts at two other temperatures.
Exit code 1: a row fails.
"""

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

TYPES = ["ball", "cylindrical", "spherical", "tapered", "spherical-tapered"]
JUMPS = ["load", "speed", "mode", "thermal", "oil", "orbit"]
# Revolutions before the jump, of settling after it, and of the window.
SPANS = {"ball": (0.5, 0.5, 1.0), "cylindrical": (0.2, 0.2, 0.4), "spherical": (0.1, 0.1, 0.3), "tapered": (0.1, 0.1, 0.3),
         "spherical-tapered": (0.1, 0.1, 0.3)}
THERMAL = {"kTherm": 1, "kCoolant": 14, "kBaseTemp": 3, "kHTC": 0, "kGeoMod": 1, "kMatPropMod": 1, "baseTemp": 320, "cFlowRate": 2e-5,
           "aveTime": 2e-4, "skipTime": 0}
OIL = {"kTrac": 4, "reRaceFilm": 1e-8, "strParam": 10}
TEMPERATURES = ["hsngTemp", "shftTemp", "raceTemp1", "raceTemp2", "reTemp", "cageTemp"]
STARTS = [293.15, 320.0, 350.0]  # [K]
# Without a land the orbit throws the cage through the races (decision 827).
LANDS = {"tapered": (0.064, 0.0085), "spherical": (0.064, 0.007), "spherical-tapered": (0.064, 0.008)}  # diameter, half width of the cage [m]
ORBIT = {"kRotFrame": 1, "brgOrbitRad": 0.1, "brgAngPos": 0, "brgAngVel": 2000, "brgLoadFrac1": 0, "brgLoadFrac2": 0}


class Bench:
    def __init__(self, program, folder, options):
        self.program, self.folder, self.options, self.count = program, folder, options, 0

    def deck(self, kind):
        path = os.path.join(self.folder, kind + ".txt")
        if not os.path.exists(path):
            subprocess.run([self.program, "new", kind, "--out", path], check=True, capture_output=True)
        return path

    def run(self, kind, sets, until, out, more=()):
        """Summary of RUN.json; raises RuntimeError with the message of another exit code."""
        command = [self.program, "run", self.deck(kind), "--out", out, "--progress", "none", "--quiet", *more]
        for name, value in sets.items():
            command += ["--set", f"{name}={value}"]
        for option in self.options:
            command += ["--opt", option]
        if until is not None:
            command += ["--until", f"{until}rev"]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            raise RuntimeError(f"exit {done.returncode}: {done.stderr.strip().splitlines()[-1][:160] if done.stderr.strip() else ''}")
        with open(os.path.join(out, "RUN.json"), encoding="utf-8") as file:
            return json.load(file)["summary"]

    def fresh(self):
        self.count += 1
        return os.path.join(self.folder, f"run{self.count}")


def bearing_temperatures(out):
    """That the bearing works with, by part [K]."""
    with open(os.path.join(out, "MASTER"), encoding="utf-8") as file:
        return {name: float(value) for value, name in re.findall(r"(\S+) (thermal\.now\.\d+)\n", file.read())}


def window(first, second):
    """Mean largest load and life between the ends of two summaries of one run."""
    t1, t2 = first["time_s"], second["time_s"]
    load = (second["mean_largest_load_N"] * t2 - first["mean_largest_load_N"] * t1) / (t2 - t1)
    damage = t2 / second["run_life_hours"] - t1 / first["run_life_hours"]
    return load, (t2 - t1) / damage if damage > 0 else float("inf")


def largest_of(bench, kind, sets):
    return bench.run(kind, {**sets, "mode": -1}, None, bench.fresh(), ["--overwrite"])["largest_contact_load_N"]


def clean(bench, kind, sets, spans):
    out = bench.fresh()
    first = bench.run(kind, sets, spans[1], out)
    return window(first, bench.run(kind, sets, spans[1] + spans[2], out, ["--continue"])), first["peak_load_N"]


def loads_of(bench, kind):
    """Applied forces of the deck."""
    text = open(bench.deck(kind), encoding="utf-8").read()
    line = next(line for line in text.splitlines() if line.startswith("'Rec 9.1.1'"))
    numbers = [float(word) for word in line.split("'")[2].replace(",", " ").split()[:3]]
    return dict(zip(["appLoadX", "appLoadY", "appLoadZ"], numbers))


def speed_of(bench, kind):
    text = open(bench.deck(kind), encoding="utf-8").read()
    line = next(line for line in text.splitlines() if line.startswith("'Rec 9.1.2'"))
    return float(line.split("'")[2].replace(",", " ").split()[7])


def lands_of(kind):
    """Guide lands of 0.3 mm diametral clearance at both ends of the cage, for examples that have none."""
    if kind not in LANDS:
        return {}
    diameter, edge = LANDS[kind]
    sets = {"nGL": 2}
    for k, side in ((1, -1.0), (2, 1.0)):
        sets.update({f"iCageGuide[{k}]": 1, f"cageGsDia[{k}]": diameter, f"cageGsWidth[{k}]": 0.002, f"cageGsPos[{k}]": side * edge,
                     f"cageGsCls[{k}]": 0.0003})
    return sets


def jump(bench, kind, mode, which):
    """List of (check, value, limit)."""
    spans = SPANS[kind]
    start = {"mode": mode}
    if which in ("load", "speed"):
        after = dict(start)
        if which == "load":
            after.update({name: 2 * value for name, value in loads_of(bench, kind).items()})
        else:
            after["rpm2"] = 1.3 * speed_of(bench, kind)
        out = bench.fresh()
        before = bench.run(kind, start, spans[0], out)
        # Revolutions count by the present speed: the run continues by the time of the old one.
        first = bench.run(kind, after, spans[0] + spans[1], out, ["--continue"])
        second = bench.run(kind, after, spans[0] + spans[1] + spans[2], out, ["--continue"])
        (load, life), peak = clean(bench, kind, after, spans)
        allowed = 1.2 * max(largest_of(bench, kind, {}), largest_of(bench, kind, {k: v for k, v in after.items() if k != "mode"}),
                            peak / 1.2, before["peak_load_N"] / 1.2)
        found = window(first, second)
        return [("peak", second["peak_load_N"] / allowed, 1.0), ("load", abs(found[0] / load - 1), 0.05),
                ("life", abs(found[1] / life - 1), 0.05)]
    if which == "mode":
        out = bench.fresh()
        other = 1 if mode == 0 else 0
        before = bench.run(kind, {"mode": other}, spans[0], out)
        again = {**start, "kIcOpt": -1}
        first = bench.run(kind, again, spans[1], out, ["--overwrite"])
        second = bench.run(kind, {**start, "kIcOpt": 1}, spans[1] + spans[2], out, ["--continue"])
        (load, life), peak = clean(bench, kind, start, spans)
        allowed = max(1.2 * largest_of(bench, kind, {}), peak, before["peak_load_N"])
        found = window(first, second)
        return [("peak", second["peak_load_N"] / allowed, 1.0), ("load", abs(found[0] / load - 1), 0.05),
                ("life", abs(found[1] / life - 1), 0.05)]
    if which == "orbit":
        out = bench.fresh()
        sets = {**start, **ORBIT, **lands_of(kind)}
        first = bench.run(kind, sets, spans[1], out)
        second = bench.run(kind, sets, spans[1] + spans[2], out, ["--continue"])
        load, life = window(first, second)
        reference = {**sets, "mode": 1}
        (other, _), _ = clean(bench, kind, reference, spans)
        return [("load", abs(load / other - 1), 0.05 if mode == 1 else 0.15),
                ("peak", second["peak_load_N"] / (1.2 * max(first["peak_load_N"], second["mean_largest_load_N"])), 1.0)]
    rows = []
    results = []
    for kelvin in STARTS:
        sets = {**start, **THERMAL, **(OIL if which == "oil" else {}), **{name: kelvin for name in TEMPERATURES}}
        out = bench.fresh()
        steps = 4 * spans[0]
        first = bench.run(kind, sets, steps + spans[1], out)
        second = bench.run(kind, sets, steps + spans[1] + spans[2], out, ["--continue"])
        results.append((window(first, second), second, bearing_temperatures(out)))
    loads = [one[0][0] for one in results]
    lives = [one[0][1] for one in results]
    peaks = [one[1]["peak_load_N"] for one in results]
    rows.append(("peak", max(peaks) / (1.2 * max(min(peaks), max(loads))), 1.0))
    rows.append(("load", max(loads) / min(loads) - 1, 0.05))
    rows.append(("life", max(lives) / min(lives) - 1, 0.05))
    rows.append(("kelvin", max(max(one[2][name] for one in results) - min(one[2][name] for one in results) for name in results[0][2]), 0.5))
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--small", action="store_true", help="the part for CI: ball, modes 0 and 1, load and mode")
    parser.add_argument("--types", default=",".join(TYPES))
    parser.add_argument("--modes", default="0,1,2")
    parser.add_argument("--jumps", default=",".join(JUMPS))
    parser.add_argument("--opt", action="append", default=[])
    parser.add_argument("--table", help="Markdown table of all rows")
    given = parser.parse_args()
    types, modes, jumps = given.types.split(","), [int(m) for m in given.modes.split(",")], given.jumps.split(",")
    if given.small:
        types, modes, jumps = ["ball"], [0, 1, 2], ["load", "mode"]
    lines, failed = [], 0
    folder = tempfile.mkdtemp(prefix="adore_starts_")
    try:
        bench = Bench(os.path.abspath(given.program), folder, given.opt)
        for kind in types:
            for mode in modes:
                for which in jumps:
                    try:
                        rows = jump(bench, kind, mode, which)
                        good = all(value <= limit for _, value, limit in rows)
                        text = ", ".join(f"{name} {value:.3f} ({limit:g})" for name, value, limit in rows)
                    except (RuntimeError, KeyError, ZeroDivisionError) as error:
                        good, text = False, str(error)
                    failed += not good
                    lines.append(f"| {kind} | {mode} | {which} | {text} | {'ok' if good else 'FAILED'} |")
                    print(lines[-1], flush=True)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    if given.table:
        with open(given.table, "w", encoding="utf-8") as file:
            file.write("| type | mode | jump | value (limit) | result |\n|---|---|---|---|---|\n" + "\n".join(lines) + "\n")
    print(f"{len(lines)} rows, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
