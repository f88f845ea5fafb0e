#!/usr/bin/python3
"""Cost and accuracy of the settings of the example decks, as rows of resources/docs/what-accuracy-costs.md.

    settings.py PROGRAM [--turns N] [--only CASE] [DECK ...]

Each deck runs under its load cases with its own settings and with the candidates below, against rkf7 at a tight tolerance with the longest
stable step. Errors in percent of the quantity (speeds of cage and elements, loads, heat, life), processor time of the whole process. Rollers
run fewer revolutions. Without DECK: all; the whole table takes an hour or two.
"""

import argparse
import json
import math
import os
import resource
import subprocess
import tempfile

BALL = [("as it is", ""), ("radial", "appLoadX=300 appLoadZ=3000"), ("light", "appLoadX=200 appLoadZ=50"),
        ("heavy", "appLoadX=6000 appLoadZ=3000"), ("fast", "rpm2=20000"), ("slow", "rpm2=2000")]
ROLLERS = [("as it is", ""), ("heavy", "appLoadZ=15000"), ("light", "appLoadZ=1000"), ("fast", "rpm2=9000"), ("slow", "rpm2=1500")]
TAPERED = [("as it is", ""), ("heavy", "appLoadX=8000 appLoadZ=15000"), ("light", "appLoadX=500 appLoadZ=1000"), ("fast", "rpm2=6000"),
           ("slow", "rpm2=1500")]
THRUST = [("as it is", ""), ("light", "appLoadX=300"), ("heavy", "appLoadX=8000"), ("fast", "rpm2=20000"), ("slow", "rpm2=2000"),
          ("radial", "appLoadX=1000 appLoadZ=400")]
BALL_18 = [("as it is", ""), ("radial", "appLoadX=600 appLoadZ=5000"), ("light", "appLoadX=400 appLoadZ=100"),
           ("heavy", "appLoadX=10000 appLoadZ=4000"), ("fast", "rpm2=20000"), ("slow", "rpm2=2400")]
DECKS = {"ball-18": (BALL_18, 50), "ball": (BALL, 50), "ball-thrust": (THRUST, 50), "cylindrical": (ROLLERS, 50), "tapered": (TAPERED, 10),
         "spherical-tapered": (TAPERED, 10), "spherical": (ROLLERS, 10)}
AS_STABLE = ["--set", "stpMax=10"]  # shortened to what contact vibrations allow
CANDIDATES = [("own settings", [])] + [(f"{m}, {t}", ["--integrator", m, "--tol", t] + AS_STABLE)
                                       for m, t in (("rk4", "1e-4"), ("rk4", "1e-5"), ("rk4", "1e-6"), ("rkf6", "1e-5"))]


def run(program, deck, sets, turns, more, out):
    words = [program, "run", deck, "--out", out, "--overwrite", "--quiet", "--until", f"{turns}rev", "--set", "maxStps=100000000"]
    for one in sets.split():
        words += ["--set", one]
    report = os.path.join(out, "RUN.json")
    if os.path.exists(report):
        os.remove(report)  # a run that does not start leaves none
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(words + more, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    if done.returncode not in (0, 3) or not os.path.exists(report):
        return {"said": (done.stderr.strip().splitlines() or [""])[-1]}
    with open(report, encoding="utf-8") as file:
        report = json.load(file)
    if report["status"] == "failed":  # before its end: its means are of another span
        return {"said": done.stderr.strip().splitlines()[-1]}
    said = "exit 3" if done.returncode == 3 else "warned" if "no account" in done.stderr else ""
    return {"summary": report["summary"], "seconds": seconds, "evaluations": report["counters"]["evaluations"], "said": said}


def errors(found, right):
    """Of speeds, loads, heat and life, in percent."""
    def relative(key):
        a, b = found.get(key, math.nan), right.get(key, math.nan)
        return abs(a - b) / abs(b) if b else 0.0
    loads = ["mean_load_x_N", "mean_load_y_N", "mean_load_z_N"]
    carried = math.sqrt(sum(right[k] ** 2 for k in loads))
    load = max(relative("mean_largest_load_N"), math.sqrt(sum((found[k] - right[k]) ** 2 for k in loads)) / carried)
    heats = ["mean_heat_outer_race_W", "mean_heat_inner_race_W", "mean_heat_elsewhere_W"]
    heat = max(abs(found[k] - right[k]) for k in heats) / abs(right["mean_power_loss_W"])
    speed = max(relative("mean_orbital_ratio"), relative("mean_cage_ratio"))
    return [100.0 * x for x in (speed, load, heat, relative("run_life_hours"))]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("decks", nargs="*")
    parser.add_argument("--turns", type=float)
    parser.add_argument("--only", help="one load case")
    options = parser.parse_args()
    program = os.path.abspath(options.program)
    print("| deck | load case | method | s | evaluations/turn | speed % | load % | heat % | life % | |\n" + "|---" * 10 + "|", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        for name in options.decks or DECKS:
            cases, turns = DECKS[name]
            turns = options.turns or turns
            deck, out = os.path.join(folder, name + ".txt"), os.path.join(folder, "out")
            subprocess.run([program, "new", name, "--out", deck], check=True, capture_output=True)
            for case, sets in cases:
                if options.only not in (None, case):
                    continue
                tight = ["--integrator", "rkf7", "--tol", "1e-7" if turns > 10 else "1e-8"]
                right = run(program, deck, sets, turns, tight + AS_STABLE, out)
                for method, more in CANDIDATES:
                    found = run(program, deck, sets, turns, more, out)
                    head = f"| {name} | {case} {sets} | {method} |".replace("  ", " ")
                    if "summary" not in found or "summary" not in right:
                        print(f"{head} | | | | | | {found['said'] or right['said']} |", flush=True)
                        continue
                    off = " | ".join(f"{x:.2g}" for x in errors(found["summary"], right["summary"]))
                    print(f"{head} {found['seconds']:.2f} | {found['evaluations'] / turns:.0f} | {off} | {found['said']} |", flush=True)


if __name__ == "__main__":
    main()
