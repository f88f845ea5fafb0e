#!/usr/bin/python3
"""Looks for wrong runs without a warning: random integrator, tolerance and limits of the step, on decks that differ.

    silent_errors.py PROGRAM [--runs N] [--seed S] [--first N] [--jobs N] [--only CASE] [--turns T]

PROGRAM is `adore`. Each case below has a reference (rkf7 at 1e-8) and two more under loads a millionth and a hundred-thousandth
larger, which give the spread of correct runs. A run N of a seed is the same on every machine.
A run may be rejected (exit 2), end with exit 3, warn (energy residual, tolerance loose or missed at stpMin), or be correct: means
(speeds, largest loads, heat) and life within 5 % or five times the spread. Anything else is a silent error: exit code 1.
"""

import argparse
import concurrent.futures
import json
import math
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile

from hard_scenes import EXPLICIT, IMPLICIT, MEANS

SECONDS = 60  # processor time of a run; one that needs more is not done
KEYS = MEANS + ["run_life_hours"]
ALLOWED = 0.05
OIL = {"kTrac": 6, "reRaceFilm": 1e-8, "strParam": 10.0}
# name: (deck, sets, turns)
CASES = {
    "ball": ("ball", {}, 1.0),
    "ball radial": ("ball", {"appLoadX": 300.0, "appLoadZ": 3000.0}, 1.0),
    "ball light": ("ball", {"appLoadX": 200.0, "appLoadZ": 50.0}, 1.0),
    "ball heavy": ("ball", {"appLoadX": 6000.0, "appLoadZ": 3000.0}, 1.0),
    "ball fast": ("ball", {"rpm2": 25000.0}, 1.0),
    "ball in oil": ("ball", OIL, 0.5),
    "ball in oil, heavy": ("ball", {**OIL, "kTrac": 1, "appLoadX": 20000.0}, 0.1),
    "ball, sticky": ("ball", {"rpm2": 500.0, "appLoadX": 10000.0, "reRaceTC2": 0.18, "reRaceTC3": 0.12, "reRaceTC4": 0.016}, 0.01),
    "ball, damped": ("ball", {"option contactDamping": 0.3}, 1.0),
    "ball in balance": ("ball", {"mode": 1}, 0.5),
    "ball, light ones in balance": ("ball", {"qFac": 0.05, "appLoadX": 300.0, "appLoadZ": 2000.0}, 0.5),
    "ball, no cage": ("ball", {"nCseg": 0, "kNumPltElem": 1, "kPltElemInd": 1}, 1.0),
    "ball-18": ("ball-18", {}, 1.0),
    "ball-18 radial": ("ball-18", {"appLoadX": 600.0, "appLoadZ": 5000.0}, 1.0),
    "ball-thrust": ("ball-thrust", {}, 1.0),
    "cylindrical": ("cylindrical", {}, 0.2),
    "tapered": ("tapered", {}, 0.1),
    "spherical": ("spherical", {}, 0.1),
}


def draw(dice):
    out = {"case": dice.choice(sorted(CASES)), "method": dice.choice(EXPLICIT + IMPLICIT), "tol": 10.0 ** dice.choice(range(-8, -2))}
    sets = {}
    if dice.random() < 0.7:
        sets["stpMax"] = float(f"{10.0 ** dice.uniform(-1.0, 3.0):.3g}")
    if dice.random() < 0.4:
        sets["stpMin"] = float(f"{10.0 ** dice.uniform(-5.0, 0.7):.3g}")
    if "stpMin" in sets and sets["stpMin"] > sets.get("stpMax", math.inf):
        del sets["stpMin"]
    return {**out, "sets": sets}


def run(program, deck, folder, name, method, tol, sets, turns, factor=0.0):
    out = os.path.join(folder, name)
    words = [program, "run", deck, "--out", out, "--quiet", "--overwrite", "--until", f"{turns:g}rev", "--integrator", method,
             "--tol", f"{tol:g}"]
    sets = dict(sets)
    if factor:
        with open(deck, encoding="utf-8") as file:
            numbers = next(line for line in file if line.startswith("'Rec 9.1.1'")).split(",")
        loads = {name: sets.get(name, float(number)) for name, number in zip(("appLoadX", "appLoadY", "appLoadZ"), numbers[1:4])}
        largest = max(loads, key=lambda name: abs(loads[name]))
        sets[largest] = loads[largest] * (1.0 + factor)
    for key, value in sets.items():
        words += ["--opt", f"{key[7:]}={value}"] if key.startswith("option ") else ["--set", f"{key}={value}"]
    try:
        done = subprocess.run(words, capture_output=True, text=True, timeout=3600,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 5)))
    except subprocess.TimeoutExpired:
        return {"exit": None, "words": words}
    said = done.stderr.strip().splitlines()
    found = {"exit": done.returncode, "words": words, "said": said,
             "warned": any(word in line for line in said for word in ("energy residual of", "missed the tolerance", "is loose"))}
    report = os.path.join(out, "RUN.json")
    if done.returncode == 0 and os.path.exists(report):
        with open(report, encoding="utf-8") as file:
            told = json.load(file)
        summary = told["summary"]
        found["missed"] = told["counters"]["at_minimum"] / max(1, told["counters"]["steps"])
        found["mean error"] = told.get("error estimates of the steps", {}).get("sum", 0.0) / (told["counters"]["steps"] * tol)
        found["values"] = {k: summary[k] for k in KEYS if isinstance(summary.get(k), (int, float))}
    shutil.rmtree(out, ignore_errors=True)
    return found


def reference(program, folder, name, turns):
    deck, sets, length = CASES[name]
    path = os.path.join(folder, deck + ".txt")
    runs = [run(program, path, folder, f"{name}-{k}", "rkf7", 1e-8, {**sets, "stpMin": 1e-6}, length * turns, factor)
            for k, factor in enumerate((0.0, 1e-6, -1e-5))]
    bad = [r for r in runs if r["exit"] != 0]
    if bad:
        sys.exit(f"{name}: the reference does not run (exit {bad[0]['exit']}): {bad[0].get('said')}\n{' '.join(bad[0]['words'])}")
    values = runs[0]["values"]
    return values, {k: max(abs(r["values"][k] - values[k]) for r in runs) for k in values}


def judge(found, truth):
    if found["exit"] in (None, -signal.SIGXCPU, -signal.SIGKILL):
        return "not done", ""
    if found["exit"] in (2, 3):
        return ("refused" if found["exit"] == 2 else "gave up") if found["said"] else "FAILED", "" if found["said"] else "without a word"
    if found["exit"] != 0:
        return "FAILED", f"exit {found['exit']}: {found['said'][-1:]}"
    values, spread = truth
    off = []
    for key, value in values.items():
        is_now = found["values"].get(key, math.nan)
        if not abs(is_now - value) <= max(ALLOWED * abs(value), 5.0 * spread[key]):
            off.append(f"{key} {is_now:.6g} for {value:.6g} ({100.0 * (is_now / value - 1.0) if value else math.nan:+.1f} %, spread {spread[key]:.2g})")
    if not off:
        return "right", ""
    return "warned" if found["warned"] else "FAILED", "; ".join(off)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--runs", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--only", help="one case")
    parser.add_argument("--turns", type=float, default=1.0, help="times the turns of each case")
    options = parser.parse_args()
    program = os.path.abspath(options.program)
    drawn = [{"number": k, **draw(random.Random(options.seed * 1000003 + k))}
             for k in range(options.first, options.first + options.runs)]
    if options.only:
        drawn = [d for d in drawn if d["case"] == options.only]
    counts = {}
    with tempfile.TemporaryDirectory() as folder:
        for deck in sorted({CASES[d["case"]][0] for d in drawn}):
            subprocess.run([program, "new", deck, "--out", os.path.join(folder, deck + ".txt")], check=True, capture_output=True)
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            names = sorted({d["case"] for d in drawn})
            truths = dict(zip(names, pool.map(lambda n: reference(program, folder, n, options.turns), names)))

            def play(d):
                deck, sets, length = CASES[d["case"]]
                path = os.path.join(folder, deck + ".txt")
                return run(program, path, folder, f"run-{d['number']}", d["method"], d["tol"], {**sets, **d["sets"]}, length * options.turns)

            for d, found in zip(drawn, pool.map(play, drawn)):
                outcome, text = judge(found, truths[d["case"]])
                counts[outcome] = counts.get(outcome, 0) + 1
                if found.get("missed"):
                    text += f" [{100.0 * found['missed']:.2g} % of the steps missed the tolerance, mean error {found['mean error']:.3g} of it]"
                if text or outcome == "not done":
                    steps = ", ".join(f"{k} {v}" for k, v in d["sets"].items())
                    print(f"{outcome} {d['number']}: {d['case']}, {d['method']} at {d['tol']:g}{', ' + steps if steps else ''}: {text}", flush=True)
    print(", ".join(f"{n} {what}" for what, n in sorted(counts.items())))
    return 1 if counts.get("FAILED") else 0


if __name__ == "__main__":
    sys.exit(main())
