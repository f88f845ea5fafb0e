#!/usr/bin/python3
"""Checks the thermal network of runs in time: generated decks with a rotating inner ring, ambient around the housing, no oil flow.

    thermal_motion.py PROGRAM [--decks N] [--seed S] [--opt NAME=VALUE]... [--table FILE]

PROGRAM is `adore`. Types, modes 0 to 2, dry and in oil take turns; speeds and loads are random. For each deck:
  housing   housing cooled, shaft not: inner minus outer ring (means) 0 to 25 K
  shaft     shaft cooled, housing not: inner minus outer ring below 0
  no heat   1 % of the speed: the difference falls to less than a fifth, or 0.05 K (contacts conduct less at low speed)
  balance   heat that leaves = heat of the energy ledger of the motion over the last thermal step, 1 %
  nodes     none is colder than the ambient; one without a source is between its neighbors, one with a source is not colder than its
            coldest neighbor
  steady    the bearing's temperatures change by less than 1 K over the last thermal step
Exit code 1: a check fails.
"""

import argparse
import json
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile

TYPES = ["ball", "cylindrical", "tapered", "spherical", "spherical-tapered"]
AMBIENT = 293.15  # [K]
AVERAGE = 3e-4  # [s]
STEPS = 40
THERMAL = {"kTherm": 1, "kCoolant": 0, "kBaseTemp": 0, "kHTC": 0, "kGeoMod": 1, "kMatPropMod": 1, "baseTemp": AMBIENT, "reHTC": 0,
           "cageHTC": 0, "aveTime": AVERAGE, "skipTime": 0}
OIL = {"reRaceFilm": 1e-8, "strParam": 10}
ROUNDING = 1e-6  # [K]


class Run:
    """One run that ends with a thermal step; its network and the heat of the motion over that step."""

    def __init__(self, program, folder, kind, sets, options):
        self.program, self.kind, self.sets, self.options = program, kind, sets, options
        self.folder = tempfile.mkdtemp(dir=folder)
        self.call(STEPS * AVERAGE)
        closed = self.closed()
        # The steps of the integrator are not split: two windows that end with the run.
        self.call(closed + AVERAGE, "--continue")
        before = self.temperatures()
        heat, begun = self.heat(), self.closed()
        self.call(begun + AVERAGE, "--continue")
        self.table = self.network()
        self.mean_heat = (self.heat() - heat) / (self.closed() - begun)
        self.change = max(abs(new - old) for new, old in zip(self.temperatures(), before))

    def call(self, until, *more):
        deck = subprocess.run([self.program, "new", self.kind], check=True, capture_output=True).stdout
        command = [self.program, "run", "-", "--out", self.folder, "--progress", "none", "--quiet", "--until", f"{until!r}s", *more]
        for name, value in self.sets.items():
            command += ["--set", f"{name}={value}"]
        for option in self.options:
            command += ["--opt", option]
        done = subprocess.run(command, capture_output=True, input=deck)
        if done.returncode != 0:
            lines = done.stderr.decode().strip().splitlines()
            raise RuntimeError(f"exit {done.returncode}: {lines[-1][:300] if lines else ''}")
        with open(os.path.join(self.folder, "RUN.json"), encoding="utf-8") as file:
            self.record = json.load(file)

    def closed(self):
        """End of the last thermal step [s]."""
        text = open(os.path.join(self.folder, "MASTER"), encoding="utf-8").read()
        return float(re.search(r"(\S+) thermal\.begun", text).group(1))

    def temperatures(self):
        """That the bearing works with, by part [K]."""
        text = open(os.path.join(self.folder, "MASTER"), encoding="utf-8").read()
        return [float(value) for value in re.findall(r"(\S+) thermal\.now\.\d+\n", text)]

    def network(self):
        return {name: values[0] for name, values in self.record["thermal_network"]["tables"]["thermal network"].items()}

    def heat(self):
        return sum(value for name, value in self.record["conservation"]["energy"].items() if name.startswith("heat"))

    def difference(self):
        return self.table["mean of the inner race [K]"] - self.table["mean of the outer race [K]"]

    def left(self):
        return sum(value for name, value in self.table.items() if name.startswith("leaves to"))

    def node_faults(self):
        faults, neighbors, inflow = [], {}, {}
        at = {name[:-4]: value for name, value in self.table.items() if name.endswith(" [K]") and not name.startswith("mean of")}
        for name, value in self.table.items():
            link = re.fullmatch(r"(.+) to (.+) \[W\]", name)
            if not link or name.startswith("leaves"):
                continue
            for here, there, heat in ((link[1], link[2], -value), (link[2], link[1], value)):
                neighbors.setdefault(here, []).append(at[there])
                inflow[here] = inflow.get(here, 0.0) + heat
        scale = max(abs(value) for name, value in self.table.items() if name.endswith("[W]"))
        for name, kelvin in at.items():
            if kelvin < AMBIENT - ROUNDING:
                faults.append(f"{name} at {kelvin:.3f} K")
            if name == "ambient" or name not in neighbors:
                continue
            source = inflow[name] < -1e-9 * scale
            if kelvin < min(neighbors[name]) - ROUNDING:
                faults.append(f"{name} colder than its neighbors")
            if not source and kelvin > max(neighbors[name]) + ROUNDING:
                faults.append(f"{name} hotter than its neighbors without a source")
        return faults


def deck(number, rng):
    kind = TYPES[number % len(TYPES)]
    sets = {**THERMAL, "mode": number % 3, "rpm2": round(rng.uniform(1000, 6000)), "appLoadZ": round(rng.uniform(800, 4000))}
    if number >= len(TYPES) or kind == "cylindrical":  # dry cylindrical rollers roll without heat
        sets.update(OIL, kTrac=[4, 1][number % 2])
    return kind, sets


def check(program, folder, number, rng, options):
    """Texts of one deck; those that begin with FAILED fail."""
    kind, sets = deck(number, rng)
    name = f"{kind}, mode {sets['mode']}, {sets['rpm2']} rpm, {sets['appLoadZ']} N, {'oil ' + str(sets['kTrac']) if 'kTrac' in sets else 'dry'}"
    base = ["thermalBase=none", *options]
    faults = []
    try:
        housing = Run(program, folder, kind, sets, base + ["shaftCooling=0"])
        shaft = Run(program, folder, kind, sets, base + ["housingCooling=0"])
        slow = Run(program, folder, kind, {**sets, "rpm2": 0.01 * sets["rpm2"]}, base + ["shaftCooling=0"])
    except RuntimeError as error:
        return name, "", [str(error)]
    if not 0.0 < housing.difference() < 25.0:
        faults.append("housing")
    if not shaft.difference() < 0.0:
        faults.append("shaft")
    if not abs(slow.difference()) < max(0.05, 0.2 * abs(housing.difference())):
        faults.append("no heat")
    for run, place in ((housing, "housing"), (shaft, "shaft"), (slow, "slow")):
        if not abs(run.left() - run.mean_heat) <= 0.01 * run.mean_heat + 1e-6:
            faults.append(f"balance ({place}: {run.mean_heat:.5g} W in, {run.left():.5g} W out)")
        if run.change > 1.0:
            faults.append(f"steady ({place}: {run.change:.2f} K)")
        faults += [f"nodes ({place}: {text})" for text in run.node_faults()]
    text = (f"{housing.mean_heat:.3g} | {housing.left() / housing.mean_heat - 1:+.1e} | {housing.difference():.2f} | "
            f"{shaft.difference():.2f} | {slow.left():.2g} | {slow.difference():.3f}")
    return name, text, faults


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--decks", type=int, default=10)
    parser.add_argument("--seed", type=int, default=43)
    parser.add_argument("--only", type=int, help="number of one deck")
    parser.add_argument("--opt", action="append", default=[])
    parser.add_argument("--table", help="Markdown table of all decks")
    given = parser.parse_args()
    rng = random.Random(given.seed)
    lines, failed = [], 0
    folder = tempfile.mkdtemp(prefix="adore_thermal_")
    try:
        for number in range(given.decks):
            if given.only is not None and number != given.only:
                deck(number, rng)
                continue
            name, text, faults = check(os.path.abspath(given.program), folder, number, rng, given.opt)
            failed += bool(faults)
            lines.append(f"| {name} | {text} | {'FAILED: ' + '; '.join(faults) if faults else 'ok'} |")
            print(lines[-1], flush=True)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    if given.table:
        with open(given.table, "w", encoding="utf-8") as file:
            file.write("| deck | heat [W] | out over in less 1 | housing cooled: inner less outer [K] | shaft cooled [K] | "
                       "1 % speed: heat [W] | difference [K] | result |\n|---|---|---|---|---|---|---|---|\n" + "\n".join(lines) + "\n")
    print(f"{len(lines)} decks, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
