#!/usr/bin/python3
"""Runs the hard scenes of rolling bearings with every integrator: nothing may hang, crash or be silently wrong.

    hard_scenes.py PROGRAM [--full] [--turns T] [--jobs N] [--only NAME] [--methods A,B] [--report FILE] [--keep FOLDER] [--minutes M] [--seconds S]

PROGRAM is `adore`. Each scene below starts from an example deck; its entry has the difficulty and known results.
Without --full each scene runs with the integrator of the deck, an explicit and an implicit one and with two changed loads (1e-6),
which give the spread of correct runs (a few minutes). With --full it runs with all 21 integrators and six changed loads (1e-8 to
1e-3), ten times as long (an hour or two); if a load changed by 1e-8 changes a mean by 0.1 %, the motion is reported as irregular.
With --keep each run leaves its result in FOLDER and is not repeated: the same command continues an interrupted matrix. With --minutes
no scene starts after this time; the table then has the number of remaining scenes (exit code 4).

A run is
- solved: exit 0, all results finite;
- warned: means outside the spread of the others, and an energy residual that warns;
- rejected (exit 2) or ended (exit 3) with a message;
- interrupted: a signal from outside ended it (exit 130); its scene is not kept and counts as remaining;
- FAILED: a crash, a hang, exit 1, a result that is not finite, or solved with means (speeds, largest loads, heat) outside the
  spread of the others.
A scene passes when its own integrator, one explicit and one implicit method solve it and nothing failed. Writes the table as
Markdown; exit code 1 when a scene does not pass.
"""

import argparse
import concurrent.futures
import json
import math
import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

EXPLICIT = [f"rkf{k}" for k in range(1, 8)] + ["rk4"] + [f"pece{k}" for k in range(1, 9)] + ["cvode-adams", "arkode-erk"]
IMPLICIT = ["cvode-bdf", "arkode-dirk", "arkode-imex"]
OWN = "own"
QUICK = [OWN, "rkf7", "arkode-dirk"]
LONGEST_RUN = {False: 240, True: 600}  # quick, full: processor time [s]; other work on the machine makes no run slow
# Limit of the agreement of means; those of a fraction of a revolution depend on its last steps.
LEAST_SPREAD = {False: 0.05, True: 0.02}  # short runs, runs of ten times the turns
MEANS = ["mean_orbital_ratio", "mean_cage_ratio", "mean_largest_load_N", "mean_power_loss_W"]

# A load changed by so many millionths that changes a mean by this share: its last digits decide, the motion is irregular.
TINY, IRREGULAR = 0.01, 1e-3
INTERRUPTED = 130  # the program ends with it on SIGINT, SIGTERM and SIGHUP, and for no other reason

BALL, ROLLERS = "ball", ["cylindrical", "spherical", "tapered", "spherical-tapered"]
NO_CAGE = {"nCseg": 0}
OIL = {"kTrac": 3, "reRaceFilm": 1e-8, "strParam": 10.0}
COLD = {"reTemp": 223.15, "raceTemp1": 223.15, "raceTemp2": 223.15}
FREE_INNER = {"kDCR": 1, "kFD12": 0, "kFD22": 0, "kFD32": 0, "kRaceIP2": 1, "raceMass2": 0.3, "raceMIx2": 2e-4, "raceMIy2": 1.4e-4,
              "raceMIz2": 1.4e-4}


def scene(name, deck, why, sets, turns=0.2, known=None, longest=math.inf):
    return {"name": name, "deck": deck, "why": why, "sets": sets, "turns": turns, "known": known or {}, "longest": longest}


# `known`: key result -> (value, relative tolerance), of every run that solves the scene.
# `longest`: revolutions after which a motion has no comparable means, or costs too much, with the reason next to it.
SCENES = [
    scene("load zone entry", BALL, "balls enter and leave a load zone under a huge radial load", {"appLoadX": 300.0, "appLoadZ": 20000.0}),
    scene("vanishing load", BALL, "a contact of nanometres; the time scale of the load is that of nothing", {"appLoadX": 1e-3}),
    scene("skid", BALL, "centrifugal force and drag against a light load: gross sliding", {"appLoadX": 50.0, "rpm2": 40000.0}),
    scene("heavy preload", BALL, "contact pressure far beyond what metal carries; stiffest contacts", {"appLoadX": 1e6, "raceCurFac1": 0.8, "raceCurFac2": 0.8}),
    scene("radial meganewton", BALL, "one ball carries most of it, over the edge of its groove", {"appLoadX": 1e4, "appLoadZ": 1e6, "raceCurFac1": 0.95, "raceCurFac2": 0.95}),
    scene("land friction", BALL, "cage instability: backward whirl with friction 0.5 at the guide lands",
          {"cageRaceTC2": 0.5}, 0.5),
    scene("loose pockets", BALL, "pocket hammering with wide clearance", {"bPocCls1": 2e-3, "bPocCls2": 2e-3}),
    scene("over the shoulder", BALL, "ellipses reach over the low shoulder of the race", {"appLoadX": 20000.0, "shoulderDia1": 0.0700}),
    scene("near-conformal groove", BALL, "f = 0.503: ellipses far longer than the groove; with tol above 1e-8 arkode-dirk is off, and warned of",
          {"raceCurFac1": 0.503, "raceCurFac2": 0.503, "appLoadX": 300.0, "tol": 1e-8}),
    scene("slow shaft", BALL, "100 rpm: a million vibrations of the contacts a turn", {"rpm2": 100.0}, 2e-3),
    scene("very fast shaft", BALL, "300,000 rpm: centrifugal force lifts balls off the inner race", {"rpm2": 300000.0, "appLoadX": 200.0, "bReDia": 0.0015, "pitchDia": 0.008, "nCseg": 0, "nRe": 10,
           "brgBore": 0.005, "brgOD": 0.011, "hsngOD": 0.015, "shoulderDia1": 0.0085, "shoulderDia2": 0.0075, "kNumPltElem": 2,
           "kPltElemInd": "1,12"}),
    scene("counter-rotation", BALL, "elements that hardly orbit while both races run", {"rpm1": -10000.0, "rpm2": 10000.0}),
    scene("equal race speeds", BALL, "no rolling; shaft revolutions do not increase", {"rpm1": 10000.0, "rpm2": 10000.0}, 0),
    scene("outer race turns", BALL, "the other ring drives", {"rpm1": 10000.0, "rpm2": 0.0}),
    scene("start from rest", BALL, "speeds through zero: slip without a direction",
          {"rpm2": 0.0, "kVarSpeed": 1, "raceAngAcc2": 1e5, "startTime2": 0.0, "endTime2": 5e-3}, 0),
    scene("reversal", BALL, "speed through zero and back",
          {"rpm2": 500.0, "kVarSpeed": 1, "raceAngAcc2": -1e6, "startTime2": 0.0, "endTime2": 1e-3}, 0),
    scene("planetary frame", BALL, "transport and Coriolis terms beyond the loads", {"kRotFrame": 1, "brgOrbitRad": 0.2, "brgAngVel": 800.0,
                                                                                   "brgLoadFrac2": 1.0}),
    scene("resonance", BALL, "a race shaken at the frequency of the contacts",
          {"kVarLoad": 2, "raceVibAmp12": 2e-7, "raceVibFreq2": 23000.0}),
    scene("waves at ball pass", BALL, "as many waves as balls: all elements are pushed at once",
          {"kRaceGeoImp2": 2, "rndVar12": 1e-6, "rndVar22": 12, "rndVar32": 0.0, "cFacVar12": 0.0, "cFacVar22": 1, "cFacVar32": 0.0}),
    scene("rotating load", BALL, "the load zone runs round with the shaft",
          {"kVarLoad": 1, "rotLoadFrac1": 0.0, "rotLoadFrac2": 1.0, "rotLoadRpm2": 10000.0, "appLoadX": 300.0, "appLoadZ": 2000.0}),
    scene("free race", BALL, "a race carried by its bearing alone, with its own unbalance", {**FREE_INNER, "raceGeoCenY2": 2e-6}),
    # After 0.78 revolutions the fixed races have squeezed the ball to 50 kN, and every method ends there.
    scene("one ball", BALL, "a bearing that holds nothing in most directions",
          {"nRe": 1, "nCseg": 0, "kNumPltElem": 2, "kPltElemInd": "1,3"}, 0.07),
    scene("two balls", BALL, "two balls and no cage", {"nRe": 2, "nCseg": 0, "kNumPltElem": 2, "kPltElemInd": "1,4"}),
    scene("two hundred balls", BALL, "size: forty times the unknowns", {"nRe": 200, "pitchDia": 1.0, "rpm2": 500.0, "brgBore": 0.9, "brgOD": 1.1, "hsngOD": 1.2,
          "shoulderDia1": 1.0063, "shoulderDia2": 0.994, "cageDia1": 1.006, "cageDia2": 0.998, "cageGsDia[1]": 1.006, "cageGsDia[2]": 1.006,
          "kNumPltElem": 2, "kPltElemInd": "1,203"}, 0.01),
    scene("no cage", BALL, "balls push each other round the ring", {**NO_CAGE, "nRe": 14, "kNumPltElem": 2, "kPltElemInd": "1,16"}),
    scene("frictionless", BALL, "nothing decays: energy alone keeps the motion honest",
          {"kTracType": 2, "reRaceTC1": 0.0, "reRaceTC2": 0.0, "reRaceTC3": 0.0, "reCageTC2": 0.0, "reCageTC3": 0.0, "cageRaceTC2": 0.0,
                                                                                     "cageRaceTC3": 0.0}),
    scene("sticky contacts", BALL, "full friction of 0.18 at 16 mm/s: stiff traction", {"reRaceTC2": 0.18, "reRaceTC3": 0.12, "reRaceTC4": 0.016}),
    scene("friction at no slip", BALL, "a traction curve that does not start at zero", {"reRaceTC1": 0.02}),
    scene("heavy cage", BALL, "a cage a thousand times the mass of its balls", {"kCageIP": 1, "cageMass": 8.4, "cageMIx": 7e-3, "cageMIy": 4e-3,
                                                                            "cageMIz": 4e-3}),
    scene("feather cage", BALL, "a cage of a millionth of its mass: stiffest pockets", {"kCageIP": 1, "cageMass": 3e-8, "cageMIx": 2.5e-11,
                                                                                  "cageMIy": 1.4e-11, "cageMIz": 1.4e-11}, 0.01),
    scene("gravity alone", BALL, "balls lie in the groove under their weight", {"appLoadX": 10.0, "gravityVecZ": -9.81, "rpm2": 1000.0}, 0.05),
    scene("light load in balance", BALL, "elements are held and released again and again", {"qFac": 0.05, "appLoadX": 300.0, "appLoadZ": 2000.0}),
    scene("quasi-static balls", BALL, "mode 1: equilibrium at every instant", {"mode": 1}),
    scene("quasi-static balls and race", BALL, "mode 2: the race finds its place at every instant", {"mode": 2}),
    scene("tilted races", BALL, "misaligned rings: every ball runs at its own angle", {"appMis12": 3e-3, "appMis22": 2e-3}),
    # Films of MIL-L-7808 (kTrac 3).
    scene("oil without rolling", BALL, "equal race speeds: no entrainment, no film", {**OIL, "rpm1": 10000.0, "rpm2": 10000.0}, 0),
    scene("cold oil, counter-rotation", BALL, "-50 C, elements that hardly orbit: thick films on both sides",
          {**OIL, **COLD, "rpm1": -10000.0, "rpm2": 10000.0}, 0.05),
    scene("film collapses", BALL, "a shaft that stops within a turn: films fall below the critical one in mid-run",
          {**OIL, "reRaceFilm": 2e-7, "kVarSpeed": 1, "raceAngAcc2": -5e6, "startTime2": 0.0, "endTime2": 2e-3}, 0),
    scene("oil at rest", BALL, "a stopped bearing: slip, rolling and film are nothing", {**OIL, "rpm2": 0.0}, 0),
    scene("English units", "ball-english", "another system of units, the same bearing", {}),
    scene("thrust bearing", "ball-thrust", "steep contact angle", {}),
    # Over one turn all methods agree: heat to 0.7 %, without orders 1 and 2 and cvode-bdf to 0.02 %, and a load changed by 1e-8 changes it
    # by 3e-6. After 1.5 revolutions skew driven by the pockets raises the heat of the races, at a random time: over two revolutions
    # methods at 1e-6 differ by 7 %, over four loads that differ by 1e-8 by 25 % at any tolerance.
    scene("misaligned rollers", "cylindrical", "edge loads and skew of both signs; irregular after a turn and a half", {"appMis22": 1e-3},
          longest=1.0),
    scene("rollers at speed", "cylindrical", "rollers leave the inner race", {"rpm2": 30000.0, "appLoadZ": 500.0}),
    scene("rollers under a heavy load", "cylindrical", "a few rollers carry it all", {"appLoadZ": 60000.0}),
    scene("tapered under thrust", "tapered", "ribs carry the ends; skew is the weakest restoring motion", {"appLoadX": 20000.0}),
    scene("tapered without a load", "tapered", "zero end play: nothing holds the rollers in place", {"appLoadX": 200.0, "appLoadZ": 0.0}),
    # A turn takes each of the 27 runs two to three minutes of processor at 1e-8: the whole matrix would not end within its two hours.
    scene("barrels, misaligned", "spherical",
          "barrels align themselves; their skew hardly has a spring; with tol above 1e-7 arkode-dirk is given up by its energy",
          {"appMis22": 0.02, "tol": 1e-8}, 0.1, longest=0.1),
    # After 1.2 revolutions barrels strike their races: a load changed by 1e-8 then changes the largest load by 0.6 %, by 1e-6 by 2.8 %, and seven
    # methods and tolerances are within 2.6 % of their middle. Over one revolution all agree to 0.03 % (heat of order 1 and 2: to 1.5 %).
    scene("barrels at speed", "spherical", "barrels fling outwards, and strike irregularly after a turn", {"rpm2": 15000.0}, longest=1.0),
    scene("spherical-tapered under thrust", "spherical-tapered", "barrels against a rib", {"appLoadX": 15000.0}),
    # Heat over two revolutions: rkf2 is 2.1 % off at 1e-6, arkode-dirk 2.2 % at 1e-7 and 0.1 % at 1e-8; a load changed by 1e-8 changes it by 0.01 %.
    scene("rollers in balance", "cylindrical", "mode 1 of rollers", {"mode": 1, "tol": 1e-8}),
]


def command(program, one, method, folder, turns, factor):
    words = [program, "run", os.path.join(folder, "DATA.txt"), "--out", os.path.join(folder, method.replace("/", "-") + f"-{factor:.3g}"),
             "--quiet", "--overwrite", "--set", "nStps=1"]  # means of loads that vibrate want every step
    sets = dict(one["sets"])
    if factor != 0:
        for name, own in one["own loads"].items():
            load = float(sets.get(name, own))
            if load != 0.0 or name == "appLoadX":
                sets[name] = load * (1.0 + 1e-6 * factor) + (1e-6 * factor if name == "appLoadX" else 0.0)
    for name, value in sets.items():
        words += ["--set", f"{name}={value}"]
    if method != OWN:
        words += ["--integrator", method]
    until = f"{min(one['turns'] * turns, one['longest']):g}rev" if one["turns"] else "0.002s"
    return words + ["--until", until]


def run(program, one, method, folder, turns, limit, factor=0.0):
    words = command(program, one, method, folder, turns, factor)
    slow = {"outcome": "slow", "text": f"not done after {limit} s of processor time", "command": words}
    try:
        done = subprocess.run(words, capture_output=True, text=True, timeout=20 * limit,  # one that sleeps
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 5)))
    except subprocess.TimeoutExpired:
        return slow
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return slow
    if done.returncode in (INTERRUPTED, -signal.SIGINT, -signal.SIGTERM, -signal.SIGHUP):
        return {"outcome": "interrupted", "text": f"exit {done.returncode}: a signal from outside", "command": words}
    said = [line for line in done.stderr.strip().splitlines() if ": note: " not in line and ": warning: " not in line]
    text = said[-1] if said else ""
    out = {"command": words, "text": text}
    if done.returncode in (2, 3) and text:
        return {**out, "outcome": "refused" if done.returncode == 2 else "gave up"}
    if done.returncode != 0:
        return {**out, "outcome": "FAILED", "text": f"exit {done.returncode}: {text}"}
    with open(os.path.join(words[words.index("--out") + 1], "RUN.json"), encoding="utf-8") as file:
        report = json.load(file)
    shutil.rmtree(words[words.index("--out") + 1])
    summary = report["summary"]
    values = {k: v for k, v in summary.items() if isinstance(v, (int, float))}
    # A scene without a cage has no cage ratio, one without friction no heat; loads all have.
    broken = [k for k in MEANS if not math.isfinite(values.get(k, math.nan if k in summary or k == "mean_largest_load_N" else 0.0))]
    if broken:
        return {**out, "outcome": "FAILED", "text": f"{broken[0]} is not a number"}
    for key, (value, tolerance) in one["known"].items():
        if abs(values[key] - value) > tolerance * abs(value):
            return {**out, "outcome": "FAILED", "text": f"{key} is {values[key]:.6g}, known is {value:.6g}"}
    return {**out, "outcome": "solved", "values": values, "warned": "energy residual of" in done.stderr}


def judge_means(results, spread, long):
    """Runs with means outside the spread of the others."""
    solved = {method: r for method, r in results.items() if r["outcome"] == "solved"}
    for key in MEANS:
        numbers = sorted(r["values"][key] for r in solved.values() if key in r["values"])
        if not numbers:
            continue
        middle = numbers[len(numbers) // 2]
        size = max(abs(middle), max(abs(x) for x in numbers) * 1e-3)
        allowed = max(LEAST_SPREAD[long] * size, 3.0 * spread.get(key, 0.0))
        for r in solved.values():
            if key not in r["values"]:
                r["outcome"] = "FAILED"
                r["text"] = f"{key} is missing, of the others {middle:.6g}"
            elif abs(r["values"][key] - middle) > allowed and r["outcome"] == "solved":
                r["outcome"] = "warned" if r["warned"] else "FAILED"
                r["text"] = f"{key} = {r['values'][key]:.6g}, of the others {middle:.6g} (allowed {allowed:.2g})"


def irregular(own, others, spread):
    """Text for a scene with a motion that depends on the last digits of its loads; empty for regular motion. @param others by factor"""
    said = []
    for key in MEANS:
        size = abs(own["values"].get(key, 0.0))
        if not size > 0.0 or others[TINY]["outcome"] != "solved":
            continue
        change = abs(others[TINY]["values"].get(key, 0.0) - own["values"][key]) / size
        if change > IRREGULAR:
            said.append(f"{key} by {100.0 * change:.2g} % (all loads together: {100.0 * spread[key] / size:.2g} %)")
    return f"irregular: a load changed by {1e-6 * TINY:g} changes " + ", ".join(said) if said else ""


def passes(results):
    def any_of(names):
        return any(results[m]["outcome"] == "solved" for m in names if m in results)
    return (results[OWN]["outcome"] == "solved" and any_of(EXPLICIT) and any_of(IMPLICIT)
            and all(r["outcome"] != "FAILED" for r in results.values()))


def play(program, one, methods, turns, full, limit, kept):
    """@param kept what `run` gave before, by method and factor of loads; new runs come to it"""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, "new", one["deck"], "--out", os.path.join(folder, "DATA.txt")], check=True, capture_output=True)

        def result(method, factor=0.0):
            name = f"{method} {factor:g}"
            if name not in kept.runs:
                kept.add(name, run(program, one, method, folder, turns, limit, factor))
            return dict(kept.runs[name])  # the judges write into it

        results = {method: result(method) for method in methods}
        spread, growth = {}, ""
        if results[OWN]["outcome"] == "solved":
            with open(os.path.join(folder, "DATA.txt"), encoding="utf-8") as deck:
                loads = next(line for line in deck if line.startswith("'Rec 9.1.1'")).split(",")
            one = {**one, "own loads": dict(zip(("appLoadX", "appLoadY", "appLoadZ"), map(float, loads[1:4])))}
            # Long runs: the time at which a cage starts to whirl depends on small changes, and a method's
            # error is a larger push than a millionth of the load. A thousandth changes no mean by more than itself.
            factors = (TINY, 1, -1, 100, -100, 1000) if full else (1, -1)
            by_factor = {factor: result(OWN, factor) for factor in factors}
            others = list(by_factor.values())
            wrong = [r["text"] for r in others if r["outcome"] == "refused"]
            if wrong:
                raise RuntimeError(f"{one['name']}: a slightly changed load is rejected, so the spread is not known: {wrong[0]}")
            values = [r["values"] for r in [results[OWN]] + others if r["outcome"] == "solved"]
            for key in MEANS:
                numbers = [v[key] for v in values if key in v]
                if numbers:
                    spread[key] = max(numbers) - min(numbers)
            if full:
                growth = irregular(results[OWN], by_factor, spread)
        judge_means(results, spread, turns >= 10.0)
        if results[OWN]["outcome"] == "solved" and any(r["outcome"] == "interrupted" for r in others):
            results[OWN]["outcome"] = "interrupted"  # without a whole spread nothing can be judged
    return {"runs": results, "spread": spread, "growth": growth}


class Kept:
    """Runs of one scene in a file, written anew after each; without a name: nowhere."""

    def __init__(self, name, told):
        self.name, self.told, self.runs = name, told, {}
        if name and os.path.exists(name):
            with open(name, encoding="utf-8") as file:
                found = json.load(file)
            if found.get("told") == told:  # else other sets or turns: all is run again
                self.runs = found["by run"]

    def add(self, name, result):
        self.runs[name] = result
        if not self.name or result["outcome"] == "interrupted":
            return
        with open(self.name + ".part", "w", encoding="utf-8") as file:
            json.dump({"told": self.told, "by run": self.runs}, file)
        os.replace(self.name + ".part", self.name)


SIGN = {"solved": "+", "warned": "w", "refused": "r", "gave up": "u", "slow": "s", "FAILED": "F", "interrupted": "i"}


def table(scenes, methods):
    lines = ["| scene | why it is hard | " + " | ".join(m if m == OWN else m.replace("arkode-", "ark-").replace("cvode-", "cv-")
                                                     for m in methods) + " |",
             "|---|---|" + "---|" * len(methods)]
    for one, results in scenes:
        lines.append(f"| {one['name']} | {one['why']} | " + " | ".join(SIGN[results[m]["outcome"]] for m in methods) + " |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--full", action="store_true")
    parser.add_argument("--turns", type=float, default=1.0, help="times the turns of each scene")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--only", help="one scene")
    parser.add_argument("--methods", help="these in addition to that of the deck, separated by commas")
    parser.add_argument("--report")
    parser.add_argument("--keep", help="folder of results by run; a run that is there is not made again")
    parser.add_argument("--minutes", type=float, default=math.inf, help="no further scene is begun after so long (with --keep)")
    parser.add_argument("--seconds", type=int, help="processor time of one run; one that needs more is not done (240, with --full 600)")
    options = parser.parse_args()
    if options.minutes != math.inf and not options.keep:
        parser.error("--minutes needs --keep FOLDER: the scenes that are done must stand somewhere")
    program = os.path.abspath(options.program)
    end = time.monotonic() + 60.0 * options.minutes
    methods = [OWN] + EXPLICIT + IMPLICIT if options.full else QUICK
    if options.methods:
        methods = [OWN] + options.methods.split(",")
    chosen = [s for s in SCENES if options.only in (None, s["name"])]
    if not chosen:
        sys.exit(f"no scene is named {options.only}; there are: " + ", ".join(s["name"] for s in SCENES))
    turns = options.turns * (10.0 if options.full else 1.0)
    if options.keep:
        os.makedirs(options.keep, exist_ok=True)

    def play_or_read(one):
        name = os.path.join(options.keep, one["name"].replace(" ", "-") + ".json") if options.keep else ""
        kept = Kept(name, {key: one[key] for key in ("deck", "sets", "turns")} | {"times": turns, "longest": str(one["longest"])})
        begin = time.monotonic()
        if begin >= end and not all(f"{method} 0" in kept.runs for method in methods):
            return None
        found = play(program, one, methods, turns, options.full, options.seconds or LONGEST_RUN[options.full], kept)
        print(f"{one['name']}: {''.join(SIGN[r['outcome']] for r in found['runs'].values())} {time.monotonic() - begin:.0f} s",
              file=sys.stderr, flush=True)
        if any(r["outcome"] == "interrupted" for r in found["runs"].values()):
            return None
        return found

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        results = list(pool.map(play_or_read, chosen))
    scenes = [(one, found["runs"]) for one, found in zip(chosen, results) if found is not None]
    left = len(chosen) - len(scenes)
    good = sum(passes(r) for _, r in scenes)
    text = f"{good} of {len(scenes)} scenes pass.\n\n+ solved, w off and warned of, r refused, u gave up with a diagnosis, s not done in time, F failed\n\n"
    text += table(scenes, methods) + "\n"
    if left:
        text += f"\n{left} of {len(chosen)} scenes are left: repeat the command to run them.\n"
    said = [f"- {one['name']}: {found['growth']}" for one, found in zip(chosen, results) if found is not None and found["growth"]]
    for one, found in scenes:
        for method, r in found.items():
            if r["outcome"] != "solved":
                said.append(f"- {one['name']}, {method}: {r['outcome']}: {r['text'][:300]}")
    print(text)
    print("\n".join(said))
    if options.only and scenes:
        for method, r in scenes[0][1].items():
            print(method, r["outcome"], r.get("values", {}), " ".join(r["command"]))
    if options.report:
        with open(options.report, "w", encoding="utf-8") as file:
            file.write(text)
    if good < len(scenes):
        return 1
    return 4 if left else 0


if __name__ == "__main__":
    sys.exit(main())
