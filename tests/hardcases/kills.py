#!/usr/bin/python3
"""Kills runs at random moments and looks at what they leave.

    kills.py PROGRAM SHIM [--kills N] [--seed S] [--report FILE]

PROGRAM is `adore`, SHIM the library of kill_at_file_call.c. Ten decks take turns. Every other kill comes after a random
time, the rest at (before or behind) a random call that changes a file, where the windows for damage are. After each kill
- every SOL file consists of whole lines without NUL bytes, and RUN.json and MASTER are whole,
- RESULTS.h5 opens with plain h5py and every dataset of it can be read, and h5dump (hdf5-tools) prints all of it,
- `adore run --continue` completes the run (or reports that there is nothing to continue),
- the completed files equal those of a run that was never killed: to the byte where the method keeps its past, else within
  the stated bound on the cage's centre,
- no hidden file stays behind.
Prints one line per deck as Markdown; exit code 1 when anything failed.
"""

import argparse
import json
import os
import random
import shutil
import subprocess
import sys
import tempfile
import time

import h5py
import numpy

OFTEN = ["--opt", "checkpointSeconds=0.01", "--quiet"]
LIGHT = ["--set", "appLoadX=200", "--set", "appLoadZ=2000", "--set", "qFac=0.1"]
# name, example deck, what is run; the last three belong to methods that cannot hand out their past
DECKS = [
    ("ball, rkf4", "ball", ["--integrator", "rkf4", "--set", "maxStps=60", "--set", "nStps=10"]),
    ("ball, rkf7, stored seldom", "ball",
     ["--integrator", "rkf7", "--set", "maxStps=60", "--set", "nStps=10", "--set", "kPltFreq=100000", "--set", "kPrtFreq=100000", "--set",
      "kAGraf=0", "--set", "kLifeFreq=0"]),
    ("ball, rkf5, 200 steps counted as one", "ball",
     ["--integrator", "rkf5", "--set", "maxStps=4", "--set", "nStps=200", "--set", "kPltFreq=1"]),
    ("ball-thrust, rkf5, every step stored", "ball-thrust",
     ["--integrator", "rkf5", "--set", "maxStps=300", "--set", "nStps=1", "--set", "kPltFreq=1", "--set", "kAGraf=1"]),
    ("ball-english, pece4", "ball-english", ["--integrator", "pece4", "--set", "maxStps=60", "--set", "nStps=10"]),
    ("ball-18, rkf5", "ball-18", ["--integrator", "rkf5", "--set", "maxStps=40", "--set", "nStps=20"]),
    ("ball, pece8, constant step", "ball",
     ["--integrator", "pece8", "--set", "stpMin=0.05", "--set", "stpMax=0.05", "--set", "stpInit=0.05", "--set",
      "maxStps=60", "--set", "nStps=10"]),
    ("ball, balls held in balance, rkf4", "ball", LIGHT + ["--integrator", "rkf4", "--set", "maxStps=60", "--set", "nStps=10"]),
    ("ball, cvode-bdf", "ball", ["--integrator", "cvode-bdf", "--set", "maxStps=30", "--set", "nStps=10"]),
    ("ball, arkode-erk", "ball", ["--integrator", "arkode-erk", "--set", "maxStps=30", "--set", "nStps=10"]),
]
SAME = ["SOL1", "SOL2", "SOL3", "SOL4", "SOL7", "SOL8", "FINAL", "RESULTS.h5"]
CLOSE = 1e-6  # [m] cage center of methods that lose their past, after these short runs


def content(path):
    with open(path, "rb") as file:
        return file.read()


class Deck:
    def __init__(self, program, shim, scratch, number, keep):
        self.name, example, self.options = DECKS[number]
        self.program, self.shim = program, shim
        self.folder = os.path.join(scratch, str(number))
        os.mkdir(self.folder)
        self.deck = os.path.join(self.folder, "DATA.txt")
        subprocess.run([program, "new", example, "--out", self.deck], check=True, stderr=subprocess.DEVNULL)
        self.whole = os.path.join(self.folder, "whole")
        begin = time.monotonic()
        counted = os.path.join(self.folder, "calls")
        ended = self.run(self.whole, [], {"LD_PRELOAD": shim, "ADORE_COUNT_CALLS": counted})
        if ended.returncode != 0:
            sys.exit(f"{self.name}: {ended.stdout}")
        self.seconds = time.monotonic() - begin
        self.calls = int(content(counted))
        self.exact = "loses" not in self.continuation_note()
        self.count = dict(kills=0, valid=0, h5py=0, h5dump=0, continued=0, anew=0, joined=0, clean=0)
        self.worst = 0.0
        self.failures = []
        self.keep = keep

    def command(self, out, more):
        return [self.program, "run", self.deck, "--out", out, *OFTEN, *self.options, *more]

    def run(self, out, more, environment=None):
        return subprocess.run(self.command(out, more), env={**os.environ, **(environment or {})}, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def continuation_note(self):
        """Message of the method in a continuation."""
        place = os.path.join(self.folder, "asked")
        shutil.copytree(self.whole, place)
        one_more = ["maxStps=1" if word.startswith("maxStps=") else word for word in self.command(place, ["--set", "kIcOpt=1"])]
        said = subprocess.run(one_more, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        shutil.rmtree(place)
        if said.returncode != 0:
            sys.exit(f"{self.name}: {said.stdout}")
        return said.stdout

    def fail(self, what):
        self.failures.append(f"{self.name}, kill {self.count['kills']}: {what}")

    def check_left(self, out):
        """Files of the killed run: valid, and opened by other programs."""
        valid = True
        for name in os.listdir(out):
            path = os.path.join(out, name)
            if name.startswith("SOL"):
                data = content(path)
                if b"\0" in data or (data and not data.endswith(b"\n")):
                    valid = False
                    self.fail(f"{name} is damaged")
            elif name == "MASTER" and not content(path).endswith(b"\nend\n"):
                valid = False
                self.fail("MASTER is not whole")
            elif name == "RUN.json":
                json.loads(content(path))
        self.count["valid"] += valid
        path = os.path.join(out, "RESULTS.h5")
        if not os.path.exists(path):
            self.count["h5py"] += 1
            self.count["h5dump"] += 1
            return
        dumped = subprocess.run(["h5dump", path], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        if dumped.returncode == 0:
            self.count["h5dump"] += 1
        else:
            self.fail(f"h5dump: {dumped.stderr}")
        try:
            with h5py.File(path, "r") as file:
                steps = file["step"].shape[0]

                def visit(name, item):
                    if isinstance(item, h5py.Dataset):
                        if item.shape[0] < steps or not numpy.isfinite(item[:steps]).all():
                            raise ValueError(f"{name} has {item.shape[0]} of {steps} steps, or no numbers")

                file.visititems(visit)
            self.count["h5py"] += 1
        except (OSError, ValueError, RuntimeError) as error:
            self.fail(f"h5py: {error}")

    def check_joined(self, out):
        if self.exact:
            different = [name for name in SAME if os.path.exists(os.path.join(self.whole, name)) and
                         (not os.path.exists(os.path.join(out, name)) or
                          content(os.path.join(out, name)) != content(os.path.join(self.whole, name)))]
            if different:
                return self.fail(f"other bytes in {', '.join(different)}")
        else:
            with h5py.File(os.path.join(out, "RESULTS.h5"), "r") as one, \
                    h5py.File(os.path.join(self.whole, "RESULTS.h5"), "r") as two:
                end = min(one["time"][-1], two["time"][-1])
                at = [numpy.array([numpy.interp(end, f["time"][:], f["cage/position"][:, 0, k]) for k in range(3)])
                      for f in (one, two)]
            distance = float(numpy.abs(at[0] - at[1]).max())
            self.worst = max(self.worst, distance)
            if distance > CLOSE:
                return self.fail(f"the cage's center is off by {distance:.2e} m")
        self.count["joined"] += 1

    def kill(self, chance, at_call):
        out = os.path.join(self.folder, "killed")
        failures = len(self.failures)
        self.count["kills"] += 1
        if at_call:
            environment = {"LD_PRELOAD": self.shim, "ADORE_KILL_AT": str(chance.randint(1, self.calls))}
            if chance.random() < 0.5:
                environment["ADORE_KILL_AFTER"] = "1"
            self.run(out, [], environment)
        else:
            process = subprocess.Popen(self.command(out, []), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            try:
                process.wait(chance.uniform(0.0, self.seconds))
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        os.makedirs(out, exist_ok=True)
        self.check_left(out)
        more = self.run(out, ["--continue"])
        if more.returncode == 2 and "no run to continue" in more.stdout:
            self.count["anew"] += 1
            more = self.run(out, ["--overwrite"])
        else:
            self.count["continued"] += 1
        if more.returncode != 0:
            self.fail(f"exit {more.returncode}: {more.stdout}")
        else:
            self.check_joined(out)
        hidden = [name for name in os.listdir(out) if name.startswith(".")]
        if hidden:
            self.fail(f"left behind: {', '.join(hidden)}")
        else:
            self.count["clean"] += 1
        if self.keep and self.failures and len(self.failures) > failures:
            shutil.copytree(out, os.path.join(self.keep, f"{len(os.listdir(self.keep))}", "killed"))
            shutil.copytree(self.whole, os.path.join(self.keep, f"{len(os.listdir(self.keep)) - 1}", "whole"))
        shutil.rmtree(out)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("shim")
    parser.add_argument("--kills", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--report", help="file for the table")
    parser.add_argument("--keep", help="an empty folder for what failed")
    given = parser.parse_args()
    chance = random.Random(given.seed)
    with tempfile.TemporaryDirectory(prefix="adore-kills-") as scratch:
        decks = [Deck(os.path.abspath(given.program), os.path.abspath(given.shim), scratch, k, given.keep)
                 for k in range(len(DECKS))]
        for number in range(given.kills):
            deck = decks[number % len(decks)]
            known = len(deck.failures)
            deck.kill(chance, at_call=(number // len(decks)) % 2 == 1)
            for failure in deck.failures[known:]:
                print(failure, file=sys.stderr, flush=True)
        lines = ["| deck | kills | files valid | h5py reads all | h5dump prints all | continued | started again | joined | nothing left behind |",
                 "|---|---|---|---|---|---|---|---|---|"]
        for deck in decks:
            c = deck.count
            how = "to the byte" if deck.exact else f"cage center within {deck.worst:.1e} m"
            lines.append(f"| {deck.name} | {c['kills']} | {c['valid']} | {c['h5py']} | {c['h5dump']} | {c['continued']} | {c['anew']} | "
                         f"{c['joined']} {how} | {c['clean']} |")
    table = "\n".join(lines) + "\n"
    print(table)
    if given.report:
        with open(given.report, "w", encoding="utf-8") as file:
            file.write(table)
    failures = [failure for deck in decks for failure in deck.failures]
    print(f"{given.kills} kills, {len(failures)} failures")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
