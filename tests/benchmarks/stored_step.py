#!/usr/bin/python3
"""Cost of a stored step: processor time of runs that store every step less that of runs that store the first and last alone.

    stored_step.py PROGRAM [PROGRAM ...] [--deck NAME] [--turns N] [--runs N]

Programs alternate; the median of the differences over the steps, in microseconds, of the process and of the kernel for it.
No PRINT sections but the first and the last.
"""

import argparse
import json
import os
import resource
import statistics
import subprocess
import tempfile


def run(program, deck, every, turns, out):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([program, "run", deck, "--out", out, "--overwrite", "--quiet", "--until", f"{turns}rev", "--set", "maxStps=100000000",
                    "--set", f"nStps={every}", "--set", "kPrtFreq=1000000"], check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime, after.ru_stime - before.ru_stime


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("programs", nargs="+")
    parser.add_argument("--deck", default="ball-18")
    parser.add_argument("--turns", type=float, default=10)
    parser.add_argument("--runs", type=int, default=5)
    options = parser.parse_args()
    programs = [os.path.abspath(p) for p in options.programs]
    with tempfile.TemporaryDirectory() as folder:
        deck, out = os.path.join(folder, "deck.txt"), os.path.join(folder, "out")
        subprocess.run([programs[0], "new", options.deck, "--out", deck], check=True, capture_output=True)
        found = {p: [] for p in programs}
        for _ in range(options.runs):
            for program in programs:
                all_of_them = run(program, deck, 1, options.turns, out)
                with open(os.path.join(out, "RUN.json"), encoding="utf-8") as file:
                    steps = json.load(file)["counters"]["steps"]
                seldom = run(program, deck, 1000000, options.turns, out)
                found[program].append([1e6 * (a - b) / steps for a, b in zip(all_of_them, seldom)])
    for program, rows in found.items():
        user, system = (statistics.median(row[k] for row in rows) for k in (0, 1))
        print(f"{program}: {statistics.median(sum(row) for row in rows):.1f} us a stored step ({user:.1f} of the process, {system:.1f} of the kernel)")


if __name__ == "__main__":
    main()
