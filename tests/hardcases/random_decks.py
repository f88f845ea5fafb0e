#!/usr/bin/python3
"""Runs random decks of the motion: many variables away from the examples at once, all five types.

    random_decks.py PROGRAM [--decks N] [--seed S] [--turns T] [--report FILE] [--only N] [--first N]

PROGRAM is `adore`. option_pairs.py varies the switches of the records, this script their numbers: loads, speeds of
both races, misalignment, clearance, conformity, crowns, flanges, friction, temperatures, fits, gravity, inertia, cage, its
clearances, lands and start; and a few switches. Deck N of a seed is the same on every machine.
Outcomes are those of option_pairs.py. The message of a rejected deck must name a variable that the deck set, and must disappear
with the example value of that variable; otherwise: FAILED. A row that is rejected for missing thrust must have an equilibrium
with 2 % more thrust than in its message, and none with 10 % less.
"""

import argparse
import collections
import concurrent.futures
import math
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile

from option_pairs import RPM, SIZES, TYPES, example_decks, lands, run_command, run_deck, sentence

THRUST = ("ball", "tapered", "spherical-tapered")


class Dice(random.Random):
    def decades(self, low, high):
        """Even in the logarithm."""
        return low * (high / low) ** self.random()

    def yes(self, chance):
        return self.random() < chance


def deck(dice):
    """Type, and what the deck sets."""
    kind = dice.choice(TYPES)
    out = {"mode": dice.choice((0, 0, 0, 1, 2)), "kNumPltElem": 1, "kPltElemInd": 1}
    ball, thrust = kind == "ball", kind in THRUST

    def perhaps(chance, *names_and_values):
        if dice.yes(chance):
            for name, value in names_and_values:
                out[name] = value() if callable(value) else value

    heavy, angle = dice.decades(50.0, 10000.0 if ball else 60000.0), dice.uniform(0.0, 2.0 * math.pi)
    out["appLoadY"], out["appLoadZ"] = heavy * math.sin(angle), heavy * math.cos(angle)
    if thrust:
        out["appLoadX"] = heavy * dice.uniform(0.3, 3.0)
    perhaps(0.3, ("rpm1", lambda: dice.uniform(-1.0, 1.0) * RPM[kind]))
    out["rpm2"] = dice.choice((-1.0, 1.0)) * dice.decades(0.25, 3.0) * RPM[kind]
    perhaps(0.3, ("appMis12", lambda: dice.uniform(-2e-3, 2e-3)), ("appMis22", lambda: dice.uniform(-2e-3, 2e-3)))
    if kind in ("ball", "cylindrical", "spherical"):
        perhaps(0.5, ("freeIntCls", lambda: dice.uniform(-2e-5, 1e-4)))
    if kind != "cylindrical" and kind != "tapered":
        perhaps(0.4, ("raceCurFac1", lambda: dice.uniform(0.503, 0.56)), ("raceCurFac2", lambda: dice.uniform(0.503, 0.56)))
    if kind in ("cylindrical", "tapered"):
        perhaps(0.4, ("bReCrn", lambda: dice.decades(0.3, 50.0)))
        perhaps(0.2, ("raceCrn2", lambda: dice.decades(1.0, 50.0)), ("raceCenLen2", lambda: dice.uniform(0.0, 0.006)))
    if kind == "cylindrical":
        perhaps(0.3, ("flngCls1", lambda: dice.uniform(0.0, 3e-4)), ("flngAng11", lambda: dice.uniform(0.0, 2.0)))
    if kind in ("tapered", "spherical-tapered"):
        perhaps(0.3, ("bReEndRad1", lambda: dice.uniform(0.05, 0.12)), ("bReEndRad2", lambda: dice.uniform(0.05, 0.12)))
        perhaps(0.2, ("flngAng12", lambda: dice.uniform(0.0, 2.0)))
    perhaps(0.3, ("nRe", lambda: dice.randint(3, SIZES[kind][0])))
    for stem, most in (("reRaceTC", 0.15), ("reCageTC", 0.3)):
        perhaps(0.3, (stem + "2", lambda top=most: dice.uniform(0.041 if top < 0.2 else 0.0, top)))
    perhaps(0.3, ("raceTemp1", lambda: dice.uniform(250.0, 380.0)), ("raceTemp2", lambda: dice.uniform(250.0, 400.0)),
            ("reTemp", lambda: dice.uniform(250.0, 400.0)), ("cageTemp", lambda: dice.uniform(250.0, 400.0)))
    perhaps(0.2, ("raceFit2", lambda: dice.uniform(0.0, 4e-5)), ("raceFit1", lambda: dice.uniform(-2e-5, 2e-5)))
    perhaps(0.3, ("gravityVecX", lambda: dice.uniform(-50.0, 50.0)), ("gravityVecY", lambda: dice.uniform(-50.0, 50.0)),
            ("gravityVecZ", lambda: dice.uniform(-50.0, 50.0)))
    perhaps(0.15, ("qFac", lambda: dice.decades(1e-3, 0.3)))
    perhaps(0.15, ("kDOF", lambda: dice.randint(1, 4)))
    if dice.yes(0.85):
        perhaps(0.4, ("bPocCls1", lambda: dice.decades(2e-5, 1e-3)))
        perhaps(0.3, ("cageDia1", lambda: SIZES[kind][2] + dice.uniform(-0.001, 0.001)))
        perhaps(0.3, ("wvRatio", lambda: dice.uniform(-3.0, 3.0)), ("avRatio", lambda: dice.uniform(0.5, 1.5)))
        perhaps(0.3, ("cageGcPos[1]", lambda: dice.uniform(-5e-5, 5e-5)), ("cageGcPos[2]", lambda: dice.uniform(-5e-5, 5e-5)),
                ("cageGcPos[3]", lambda: dice.uniform(-5e-5, 5e-5)))
        perhaps(0.3, ("cageAngPos[1]", lambda: dice.uniform(-0.1, 0.1)))
        if dice.yes(0.3):
            out.update(lands(dice.choice((1, 2)))({"type": kind}))
            out["cageGsCls[1]"] = out["cageGsCls[2]"] = dice.decades(5e-5, 1e-3)
        if kind in ("ball", "cylindrical") or "nGL" in out:
            perhaps(0.3, ("cageRaceTC2", lambda: dice.uniform(0.0, 0.3)), ("cageRaceTC3", 0.6))
        if ball:
            perhaps(0.3, ("kPocType", lambda: dice.randint(0, 4)), ("bPocCls2", 3e-4))
    else:
        out["nCseg"] = 0
        for name in [name for name in out if name.startswith("reCageTC")]:
            del out[name]
    moved = set()
    if out["mode"] == 0 and dice.yes(0.4):
        race = dice.choice((1, 2))
        out["kDCR"] = 1
        moved = {k for k in (1, 2, 3) if dice.yes(0.6)}
        out.update({f"kFD{k}{race}": 0 for k in moved})
        if dice.yes(0.5):
            out.update({f"kRaceIP{race}": 1, f"raceMass{race}": dice.decades(0.05, 5.0), f"raceMIy{race}": dice.decades(1e-4, 3e-3)})
            out[f"raceMIz{race}"] = out[f"raceMIy{race}"]
            out[f"raceMIx{race}"] = dice.uniform(0.2, 1.9) * out[f"raceMIy{race}"]
            out[f"raceGeoCenY{race}"] = dice.uniform(-2e-5, 2e-5)
    excited = dice.random()
    if excited < 0.1:
        out.update(kVarLoad=1, rotLoadFrac2=dice.uniform(0.0, 1.0), rotLoadRpm2=dice.uniform(-2.0, 2.0) * out["rpm2"])
    elif excited < 0.2 and not moved and out["mode"] != 2:
        out.update(kVarLoad=2, raceVibAmp22=dice.uniform(0.0, 5e-6), raceVibFreq2=dice.decades(50.0, 5000.0))
    excited = dice.random()
    if excited < 0.15:
        out.update(kVarSpeed=1, raceAngAcc2=dice.uniform(-1.0, 1.0) * 1e5, startTime2=0.0, endTime2=dice.decades(1e-4, 3e-3))
    elif excited < 0.3:
        out.update(kVarSpeed=2, raceSpeedAmp2=dice.uniform(0.0, 1.0), raceSpeedFreq2=dice.decades(20.0, 2000.0))
    if dice.yes(0.15):
        out.update(kRotFrame=1, brgOrbitRad=dice.decades(0.01, 10.0), brgAngVel=dice.uniform(-500.0, 500.0),
                   brgLoadFrac2=dice.uniform(0.0, 1.0))
    if dice.yes(0.2):
        out.update(kReGeoImp=1, reDiaVar=dice.decades(1e-8, 3e-6))
    return kind, {name: f"{value:.9g}" if isinstance(value, float) else value for name, value in out.items()}


def errors(text):
    """The sentences of a refusal, without the file's name."""
    lines = [line for line in text.splitlines() if line and " warning: " not in line and " note: " not in line]
    return [re.sub(r"^(adore: )?[^ ]*DATA\.txt(:\d+)?: ", "", line) for line in lines]


def untrue(command, values, text):
    """Why the refusal cannot be true, or an empty text."""
    said = errors(text)
    first = said[0] if said else ""
    named = [name for name in values if re.search(rf"\b{re.escape(name.split('[')[0])}\b", first)]
    if not named:
        return "names nothing that the deck sets"
    less = [command[0], "check", command[2]] + [
        word for name, value in values.items() if name not in named for word in ("--set", f"{name}={value}")]
    again = subprocess.run(less, capture_output=True, text=True, check=False).stderr
    plain = re.sub(r"-?\d+(\.\d+)?(e[-+]?\d+)?", "#", first)
    if any(re.sub(r"-?\d+(\.\d+)?(e[-+]?\d+)?", "#", line) == plain for line in errors(again)):
        return f"stays without {', '.join(named)}"
    return ""


def untrue_thrust(command):
    """Reason why the required thrust in the message of a rejected row is wrong, or an empty text."""
    plan = [command[0], "plan", command[2]] + command[command.index("--quiet") + 1:]
    said = subprocess.run(plan, capture_output=True, text=True, check=False).stderr
    needed = re.search(r"needs an axial load of at least [^=]*= ([-+.e\d]+) N along x, but", said)
    at = next((k for k, word in enumerate(plan) if word.startswith("appLoadX=")), None)
    if needed is None or at is None:
        return "names no thrust that would do, or one that the deck does not give"
    codes = []
    for factor in (1.02, 0.9):
        plan[at] = f"appLoadX={factor * float(needed.group(1)):.9g}"
        codes.append(subprocess.run(plan, capture_output=True, check=False).returncode)
    return "" if codes == [0, 2] else f"asks for a thrust with which `adore plan` ends with {codes[0]}, and {codes[1]} without a tenth"


def one(program, base, seed, number, turns, keep, limit):
    kind, values = deck(Dice(seed * 1000003 + number))
    folder = os.path.join(base, f"deck{number}")
    fastest = max(abs(float(values["rpm2"])), abs(float(values.get("rpm1", 0.0))), 0.25 * RPM[kind])
    command = run_command(program, base, kind, fastest, folder, turns, values)
    outcome, why = run_deck(command, folder, keep, limit)
    if outcome == "refused":
        lie = (untrue_thrust(command) if "no roller or flange supports the inner race" in why else "") or untrue(command, values, why)
        if lie:
            return kind, "FAILED", f"refused, but the sentence {lie}: {' | '.join(errors(why))[:300]}", command
    return kind, outcome, why, command


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--decks", type=int, default=300)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--turns", type=float, default=0.2)
    parser.add_argument("--report")
    parser.add_argument("--only", type=int, help="run this deck, keep its folder and print its command")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--longest", type=float, default=120.0, help="processor time of a deck [s]")
    args = parser.parse_args()
    program = os.path.abspath(args.program)
    base = tempfile.mkdtemp(prefix="random_decks_")
    example_decks(program, base)
    if args.only is not None:
        kind, outcome, why, command = one(program, base, args.seed, args.only, args.turns, True, args.longest)
        print(" ".join(command), outcome, why, sep="\n")
        return 0
    by_type, reasons, failures = collections.Counter(), collections.Counter(), []
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        jobs = {k: pool.submit(one, program, base, args.seed, k, args.turns, False, args.longest)
                for k in range(args.first, args.first + args.decks)}
        for k, job in jobs.items():
            kind, outcome, why, _ = job.result()
            by_type[kind, outcome] += 1
            print(k, kind, outcome, sentence(why) if outcome == "refused" else why, file=sys.stderr, flush=True)
            if outcome == "refused":
                reasons[sentence(why)] += 1
            if outcome == "FAILED":
                failures.append((k, kind, why))
    shutil.rmtree(base, ignore_errors=True)
    lines = [f"{args.decks} decks (seed {args.seed}, from {args.first} on), {args.turns:g} turns each.", "",
             "| type | ran | refused | failed |", "|---|---:|---:|---:|"]
    lines += [f"| {kind} | {by_type[kind, 'ran']} | {by_type[kind, 'refused']} | {by_type[kind, 'FAILED']} |" for kind in TYPES]
    lines += ["", "| reason | decks |", "|---|---:|"]
    lines += [f"| {why} | {n} |" for why, n in reasons.most_common()]
    if failures:
        lines += ["", "| deck | type | failed |", "|---:|---|---|"]
        lines += [f"| {k} | {kind} | {why} |" for k, kind, why in failures]
    text = "\n".join(lines) + "\n"
    print(text)
    if args.report:
        with open(args.report, "w", encoding="utf-8") as file:
            file.write(text)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
