#!/usr/bin/python3
"""Runs decks that cover all pairs of option values: five bearing types, three modes, every switch of the motion.

    option_pairs.py PROGRAM [--decks N] [--seed S] [--turns T] [--report FILE] [--only ROW] [--rows A:B]

PROGRAM is `adore`. The factors are below, one list of levels each; a level is a name and the values that it sets. Rows are
selected until they have every permitted pair of levels, then at random up to N. Each row starts from the example deck of its
type and runs T revolutions. Its outcome is one of
- ran: exit 0, every step finite, energy residual below 1e-4 of the energy moved (or, if almost no energy is moved, as by a
  coasting race, below 1e-6 of the elastic energy of the static solution),
- rejected: exit 2 with a message, or exit 3 for a start that is not an equilibrium; messages are grouped without their numbers,
- FAILED: anything else: a crash, a hang, exit 1 or 3, a residual above the bound.
Writes the table of outcomes as Markdown; exit code 1 when anything failed or fewer than 90 % of the rows ran.
"""

import argparse
import collections
import concurrent.futures
import itertools
import json
import math
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile

TYPES = ["ball", "cylindrical", "spherical", "tapered", "spherical-tapered"]
ROLLERS = TYPES[1:]
STRAIGHT = ["cylindrical", "tapered"]
LONGEST_RUN = 120.0  # [s] of processor time: other work of the machine does not count
LARGEST_RESIDUAL = 1e-4  # of the energy moved
LARGEST_OF_ELASTIC = 1e-6  # of the elastic energy of the static solution


RPM = {"ball": 10000, "cylindrical": 6000, "spherical": 3000, "tapered": 3000, "spherical-tapered": 3000}
# Of the example decks: elements, their diameter, outside diameter, bore and width of the cage [m].
SIZES = {"ball": (12, 0.0127, 0.066, 0.058, 0.017), "cylindrical": (14, 0.011, 0.066, 0.058, 0.016),
         "spherical": (15, 0.0105, 0.064, 0.057, 0.014), "tapered": (17, 0.0095, 0.064, 0.058, 0.017),
         "spherical-tapered": (16, 0.0095, 0.064, 0.058, 0.016)}
TAPER = {"tapered": 1.925, "spherical-tapered": 1.925}  # of the rollers: half the difference of their races' angles [deg]


def segments(row, cut=1):
    n = SIZES[row["type"]][0]
    k = 3 if n % 3 == 0 else 2
    out = {"nCseg": k, "cageAngCut": 0.5}
    if n % k:
        n = 16
        out["nRe"] = n
    out.update({f"lSeg[{i + 1}]": cut * (1 + i * n // k) for i in range(k)})
    out.update({f"avRatio[{i + 1}]": 1.0 for i in range(k)})
    return out


def half_pockets(row):
    return segments(row, -1)


def guide_faces(row):
    """kPocType pairs of faces next to a roller, at 0.12 mm from it and along its taper; balls: axial clearance 0.2 mm."""
    k = int(row["pocket"])
    out = {"kPocType": k}
    if row["type"] == "ball" and k in (2, 3):
        out["bPocCls2"] = 2e-4
    if row["type"] == "ball" or k < 1:
        return out
    for i in range(1, k + 1):
        if row["type"] in TAPER:
            out[f"bPocGsAng3[{i}]"] = -TAPER[row["type"]]
        out.update({f"bPocGsCen2[{i}]": SIZES[row["type"]][1] / 2 + 1.2e-4, f"bPocGsCen3[{i}]": (0.0, 1e-3, -1e-3)[i - 1],
                    f"bPocGsLen1[{i}]": 0.002, f"bPocGsLen2[{i}]": 0.008})
    return out


def lands(guide):
    def values(row):
        _, _, outside, bore, width = SIZES[row["type"]]
        out = {"nGL": 2, "iCageGuide[1]": guide, "iCageGuide[2]": guide}
        for i, side in ((1, -0.5), (2, 0.5)):
            out.update({f"cageGsDia[{i}]": outside if guide == 1 else bore, f"cageGsWidth[{i}]": 0.002,
                        f"cageGsPos[{i}]": side * width, f"cageGsCls[{i}]": 3e-4})
        return out
    return values


def flanges(race, both):
    """The example decks have those that their type needs."""
    def values(row):
        if row["type"] not in ("cylindrical", "tapered", "spherical-tapered"):
            return {}
        if row["type"] != "cylindrical" and race == 2:
            return {}
        out = {f"kFlngInd1{race}": int(both), f"kFlngInd2{race}": int(both)}
        if both:
            out.update({f"flngAng1{race}": 0.5, f"flngAng2{race}": 0.5, f"flngHt1{race}": 0.0015, f"flngHt2{race}": 0.0015,
                        f"flngCls{race}": 5e-5})
        return out
    return values


def race_inertia(j):
    return {f"raceMass{j}": 0.3, f"raceMIx{j}": 2e-4, f"raceMIy{j}": 1.4e-4, f"raceMIz{j}": 1.4e-4, f"raceGeoCenY{j}": 1e-6}


def element_inertia(row):
    mass, axial, across = (8.4e-3, 1.35e-7, 1.35e-7) if row["type"] == "ball" else (8e-3, 1.2e-7, 1.4e-7)
    return {"bReMass": mass, "bReMIx": axial, "bReMIy": across, "bReMIz": across}


def cage_inertia(row):
    if row["cage"] == "one piece":
        return {"kCageIP": 1, "cageMass": 0.03, "cageMIx": 2.5e-5, "cageMIy": 1.4e-5, "cageMIz": 1.4e-5, "cageGeoCenY": 5e-6}
    # One segment, in its own frame.
    return {"kCageIP": 1, "cageMass": 0.012, "cageMIx": 4e-6, "cageMIy": 4e-6, "cageMIz": 6e-6, "cageGeoCenZ": -0.02}


def race_errors(j, waves):
    def values(row):
        out = {f"rndVar1{j}": 1e-6, f"rndVar2{j}": 3 if waves else -1e-6, f"rndVar3{j}": 30.0}
        stem = "rlOffset" if row["type"] in STRAIGHT else "cFacVar"
        out.update({f"{stem}1{j}": 1e-5 if stem == "rlOffset" else 1e-3, f"{stem}2{j}": 2, f"{stem}3{j}": 90.0})
        return out
    return values


def free(race, directions):
    return {f"kFD{k}{race}": 0 for k in directions}


# factor -> levels (name, values, or a function of the row that gives them)
FACTORS = {
    "type": [(name, {}) for name in TYPES],
    "mode": [("0", {"mode": 0}), ("1", {"mode": 1}), ("2", {"mode": 2})],
    "kDOF": [(str(k), {"kDOF": k}) for k in range(6)],
    "races": [("held", {"kDCR": 0}),
              ("inner free", {"kDCR": 1, **free(2, (1, 2, 3))}),
              ("outer free", {"kDCR": 1, **free(1, (1, 2, 3))}),
              ("inner axially free", {"kDCR": 1, "kFD12": 0}),
              ("inner speed free", {"kDCR": 1, "kMD12": 0}),
              ("inner tilt free", {"kDCR": 1, "kMD22": 0, "kMD32": 0})],
    "race inertia": [("ideal", {}),
                     ("outer given", lambda row: {"kRaceIP1": 1, **(race_inertia(1) if row["mode"] == "0" else {})}),
                     ("inner given", lambda row: {"kRaceIP2": 1, **(race_inertia(2) if row["mode"] == "0" else {})})],
    "element inertia": [("ideal", {}), ("given", lambda row: {"kReIP": 2, **element_inertia(row)}),
                        ("unbalanced", lambda row: {"kReIP": 2, **element_inertia(row), "bReGeoCenX": 1e-6, "bReFrameY": 1.0}),
                        ("of element 1", lambda row: {"kReIP": 1, **element_inertia(row), "bReGeoCenY": 1e-6})],
    "load": [("steady", {}), ("rotating", {"kVarLoad": 1, "rotLoadFrac1": 0.0, "rotLoadFrac2": 0.2, "rotLoadRpm2": 9000.0}),
             ("vibration", {"kVarLoad": 2, "raceVibAmp11": 1e-6, "raceVibAmp32": 1e-6, "raceVibFreq1": 500.0, "raceVibFreq2": 900.0})],
    "speed": [("steady", {}),
              ("ramp", {"kVarSpeed": 1, "raceAngAcc2": 1e4, "startTime2": 0.0, "endTime2": 1e-3}),
              ("wave", {"kVarSpeed": 2, "raceSpeedAmp2": 0.05, "raceSpeedFreq2": 200.0})],
    "frame": [("fixed", {}), ("turning", {"kRotFrame": 1, "brgOrbitRad": 0.1, "brgAngVel": 500.0, "brgLoadFrac2": 1.0})],
    "cage": [("one piece", {"nCseg": 1}), ("none", {"nCseg": 0}), ("segments", segments),
             ("segments, cut pockets", half_pockets)],
    "pocket": [(str(k), guide_faces) for k in range(-1, 5)],
    "pocket errors": [(str(k), {"kCagePocImp": k} if k == 0 else
                       {"kCagePocImp": k, "bPocClsVar1": 1e-5, "bPocThknsVar": 1e-5, "bPocCenVar1": 1e-5, "bPocAngVar1": 0.05})
                      for k in range(4)],
    "lands": [("none", {"nGL": 0}), ("outer", lands(1)), ("inner", lands(2))],
    "cage inertia": [("ideal", {}), ("given", cage_inertia)],
    "cone": [("plain", {}), ("conical", {"cageConeAng": 8.0})],
    "element errors": [("none", {}), ("random", {"kReGeoImp": 1, "reDiaVar": 5e-7}),
                       ("listed", {"kReGeoImp": 2, "reDiaVar1": 1e-6, "reDiaVar4": -1e-6})],
    "outer errors": [("none", {}), ("steps", lambda row: {"kRaceGeoImp1": 1, **race_errors(1, False)(row)}),
                     ("waves", lambda row: {"kRaceGeoImp1": 2, **race_errors(1, True)(row)})],
    "inner errors": [("none", {}), ("waves", lambda row: {"kRaceGeoImp2": 2, **race_errors(2, True)(row)})],
    "gravity": [("none", {"gravityVecZ": 0.0}), ("down", {"gravityVecZ": -9.81})],
    "light loads": [("move", {"qFac": 0.0}), ("balanced", {"qFac": 0.05})],
    "outer flanges": [("none", flanges(1, False)), ("both", flanges(1, True))],
    "inner flanges": [("none", flanges(2, False)), ("both", flanges(2, True))],
    "statics": [("loads", {}), ("displaced", {"kFS3": 1, "appDispZ": 1e-5})],
}

# Combinations that no record permits, that contradict each other, or that reading N10 rejects (a race that accelerates in modes 1
# and 2): never in a row.
IMPOSSIBLE = [
    lambda r: r.get("mode", "0") != "0" and r.get("races", "held") != "held",
    lambda r: r.get("cage") == "none" and (r.get("pocket", "0") != "0" or r.get("pocket errors", "0") != "0"
                                           or r.get("lands", "none") != "none" or r.get("land errors", "none") != "none"
                                           or r.get("cage inertia", "ideal") != "ideal" or r.get("cone", "plain") != "plain"),
    lambda r: r.get("type") == "ball" and r.get("pocket") == "-1",
    lambda r: r.get("type") in ROLLERS and r.get("pocket") == "4",
    lambda r: r.get("type") in ("ball", "spherical") and (r.get("outer flanges", "none") != "none" or r.get("inner flanges", "none") != "none"),
    lambda r: r.get("type") in ("tapered", "spherical-tapered") and r.get("inner flanges", "none") != "none",
    # Two laws for one place or speed: free, or placed by its load, and moved by a law of the time.
    lambda r: r.get("load") == "vibration" and (r.get("races") in ("inner free", "outer free") or r.get("mode") == "2"),
    lambda r: r.get("speed", "steady") != "steady" and r.get("races") == "inner speed free",
    # Nothing left to balance: kDOF 5 suppresses what modes 1 and 2 place.
    lambda r: r.get("kDOF") == "5" and r.get("mode", "0") != "0",
]


def possible(row):
    return not any(rule(row) for rule in IMPOSSIBLE)


def rows_of_pairs(seed, count):
    rng = random.Random(seed)
    names = list(FACTORS)
    levels = {name: [level for level, _ in FACTORS[name]] for name in names}
    open_pairs = set()
    for a, b in itertools.combinations(names, 2):
        for x, y in itertools.product(levels[a], levels[b]):
            if possible({a: x, b: y}):
                open_pairs.add((a, x, b, y))

    def random_row(fixed):
        for _ in range(10000):
            row = dict(fixed)
            for name in names:
                if name not in row:
                    row[name] = rng.choice(levels[name])
                    if not possible(row):
                        fitting = [level for level in levels[name] if possible({**row, name: level})]
                        if not fitting:
                            break
                        row[name] = rng.choice(fitting)
            if len(row) == len(names) and possible(row):
                return {name: row[name] for name in names}
        return None

    def covered(row):
        return {(a, row[a], b, row[b]) for a, b in itertools.combinations(names, 2)}

    rows = []
    while open_pairs:
        a, x, b, y = min(open_pairs)
        candidates = [row for row in (random_row({a: x, b: y}) for _ in range(30)) if row]
        if not candidates:  # three factors together forbid it
            open_pairs.discard((a, x, b, y))
            continue
        best = max(candidates, key=lambda row: len(covered(row) & open_pairs))
        open_pairs -= covered(best)
        rows.append(best)
    pairs_alone = len(rows)
    # One switch at a time, from a plain deck: what a row refuses for one reason must not hide another.
    plain = {name: levels[name][0] for name in names}
    plain["pocket"] = "0"
    for kind, mode in itertools.product(TYPES, levels["mode"]):
        base = {**plain, "type": kind, "mode": mode}
        rows.append(base)
        if mode == "0":
            rows += [{**base, name: level} for name in names[2:] for level in levels[name]
                     if level != base[name] and possible({**base, name: level})]
    while len(rows) < count:
        rows.append(random_row({}))
    return rows, pairs_alone


def settings(row):
    values = {}
    for name, level in row.items():
        given = dict(FACTORS[name])[level]
        values.update(given(row) if callable(given) else given)
    if row["cage"] == "none":
        for name in ("kPocType", "kCagePocImp", "nGL"):
            values.pop(name, None)
    # Bodies of the plot files: two elements and both races, wherever the races stand now.
    values["kNumPltElem"] = 1
    values["kPltElemInd"] = 1
    return values


def sentence(text):
    """The first error without its numbers and places."""
    lines = [line for line in text.splitlines() if line and " warning: " not in line and " note: " not in line]
    first = lines[0] if lines else "no word"
    first = re.sub(r"^(adore: )?[^ ]*DATA\.txt(:\d+)?: ", "", first)
    return re.sub(r"-?\d+(\.\d+)?(e[-+]?\d+)?", "#", first)[:180]


def run_deck(command, folder, keep, limit=LONGEST_RUN):
    """Outcome and, but for "ran", its sentence, of `command` (adore run ... --out folder --json --quiet)."""
    seconds = math.ceil(limit)
    done = subprocess.run(command, capture_output=True, text=True, check=False,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5)))
    try:
        if done.returncode == -signal.SIGXCPU:
            return "FAILED", f"no end in {seconds} s of processor time"
        if done.returncode == 2 or (done.returncode == 3 and "start: excess energy" in done.stderr):
            return "refused", done.stderr
        if done.returncode != 0:
            return "FAILED", f"exit {done.returncode}: {sentence(done.stderr)}"
        if re.search(r"\b(nan|inf|infinity)\b", done.stdout.lower()):
            return "FAILED", "a number that is none"
        summary = json.loads(done.stdout)
        energy = summary["energy"]
        share = abs(energy["residual_J"]) / energy["moved_J"] if energy["moved_J"] > 0 else 0.0
        with open(os.path.join(folder, "RUN.json"), encoding="utf-8") as file:
            ledger = json.load(file)["conservation"]["energy"]
        of_elastic = abs(ledger["residual over elastic energy of the quasi-static solution"])
        if not (share < LARGEST_RESIDUAL or of_elastic < LARGEST_OF_ELASTIC):
            return "FAILED", f"energy residual {share:.1e} of the energy moved"
        return "ran", ""
    finally:
        if not keep:
            shutil.rmtree(folder, ignore_errors=True)


def run_command(program, base, kind, rpm, folder, turns, values):
    command = [program, "run", os.path.join(base, kind, "DATA.txt"), "--out", folder, "--until",
               f"{60 * turns / rpm}s", "--json", "--quiet"]
    for name, value in values.items():
        command += ["--set", f"{name}={value}"]
    return command


def example_decks(program, base):
    for kind in TYPES:
        os.mkdir(os.path.join(base, kind))
        subprocess.run([program, "new", kind, "--out", os.path.join(base, kind, "DATA.txt")], check=True,
                       capture_output=True)


def run_row(program, base, row, number, turns, keep, limit=LONGEST_RUN):
    folder = os.path.join(base, f"row{number}")
    command = run_command(program, base, row["type"], RPM[row["type"]], folder, turns, settings(row))
    outcome, why = run_deck(command, folder, keep, limit)
    return outcome, sentence(why) if outcome == "refused" else why, command


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--decks", type=int, default=400)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--turns", type=float, default=0.2)
    parser.add_argument("--report")
    parser.add_argument("--only", type=int, help="run this row, keep its folder and print its command")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--rows", help="FIRST:LAST, these rows only")
    parser.add_argument("--longest", type=float, default=LONGEST_RUN, help="processor time of a row [s]")
    args = parser.parse_args()
    program = os.path.abspath(args.program)
    rows, pairs_alone = rows_of_pairs(args.seed, args.decks)
    base = tempfile.mkdtemp(prefix="option_pairs_")
    example_decks(program, base)
    if args.only is not None:
        outcome, why, command = run_row(program, base, rows[args.only], args.only, args.turns, True, args.longest)
        print(json.dumps(rows[args.only], indent=1), " ".join(command), outcome, why, sep="\n")
        return 0
    first, last = (int(k) for k in args.rows.split(":")) if args.rows else (0, len(rows) - 1)
    outcomes = collections.Counter()
    reasons = collections.Counter()
    failures = []
    by_type = collections.Counter()
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        jobs = [pool.submit(run_row, program, base, row, k, args.turns, False, args.longest)
                for k, row in enumerate(rows) if first <= k <= last]
        for k, job in enumerate(jobs, first):
            outcome, why, _ = job.result()
            outcomes[outcome] += 1
            by_type[rows[k]["type"], outcome] += 1
            if outcome == "refused":
                reasons[why] += 1
            if outcome == "FAILED":
                failures.append((k, why, rows[k]))
            if sys.stderr.isatty():
                print(f"\r{k + 1}/{len(rows)} {dict(outcomes)}", end="", file=sys.stderr)
    shutil.rmtree(base, ignore_errors=True)
    lines = [f"{sum(outcomes.values())} of {len(rows)} decks (seed {args.seed}; the first {pairs_alone} cover all pairs), {args.turns:g} turns each.", "",
             "| type | ran | refused | failed |", "|---|---:|---:|---:|"]
    for kind in TYPES:
        lines.append(f"| {kind} | {by_type[kind, 'ran']} | {by_type[kind, 'refused']} | {by_type[kind, 'FAILED']} |")
    lines += ["", "| reason | decks |", "|---|---:|"]
    lines += [f"| {why} | {n} |" for why, n in reasons.most_common()]
    if failures:
        lines += ["", "| row | failed | its levels |", "|---:|---|---|"]
        default = {name: FACTORS[name][0][0] for name in FACTORS}
        lines += [f"| {k} | {why} | {', '.join(f'{n} {v}' for n, v in row.items() if v != default[n] or n == 'type')} |"
                  for k, why, row in failures]
    text = "\n".join(lines) + "\n"
    print(text)
    if args.report:
        with open(args.report, "w", encoding="utf-8") as file:
            file.write(text)
    return 1 if failures or outcomes["ran"] < 0.9 * sum(outcomes.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
