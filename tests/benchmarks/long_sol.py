#!/usr/bin/env python3
"""Makes a long step file from a short one: repeats its steps with continued step numbers, revolutions and times, up to the
specified number of records. For bench_adrplot (ADORE_BENCH_SOL); 10^6 records of SOL3
of the ball example are 1.1 GB.

    long_sol.py RUN/SOL3 BIG/SOL3 1000000
"""
import sys


def main():
    source, target, records = sys.argv[1], sys.argv[2], int(sys.argv[3])
    with open(source) as file:
        head = [next(file) for _ in range(4)]
        lines = file.readlines()
    starts = [i for i, line in enumerate(lines) if len(line[:20].strip().lstrip("-")) and
              line[:20].strip().isdigit()]
    steps = [lines[a:b] for a, b in zip(starts, starts[1:] + [len(lines)])]
    # step, time over its scale, revolutions (2), time: what grows over the file
    clocks = [[float(s[0][20 + 16 * i:36 + 16 * i]) for i in range(4)] for s in steps]
    span = [(clocks[-1][i] - clocks[0][i]) * len(steps) / (len(steps) - 1) for i in range(4)]
    bodies = ["".join(s[1:]) for s in steps]
    with open(target, "w") as out:
        out.writelines(head)
        for n in range(records):
            turn, k = divmod(n, len(steps))
            values = [clocks[k][i] + turn * span[i] for i in range(4)]
            out.write(f"{n:18d}" + "".join(f"{v:16.7E}" for v in values) + "\n" + bodies[k])


main()
