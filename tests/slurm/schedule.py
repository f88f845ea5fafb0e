#!/usr/bin/env python3
"""Simulated schedule of a large study under Slurm, from measured figures: how long, and which part is the limit.

Pieces are made as core/studies/slurm_engine.cpp makes them. Elements start one after another as the controller dispatches them, each on
the core that is free first; a piece costs a start and its runs; the driver reads records one after another as they come.

    schedule.py --runs 100000 --cores 1000 --seconds 60 [--start 1.4] [--dispatch 0.01] [--record 0.0004]
"""
import argparse
import heapq
import math

parser = argparse.ArgumentParser()
parser.add_argument("--runs", type=int, default=100_000)
parser.add_argument("--cores", type=int, default=1000)
parser.add_argument("--seconds", type=float, default=60.0, help="of one run")
parser.add_argument("--spread", type=float, default=0.3, help="of runs' lengths, as a share: run k takes 1 + spread sin k")
parser.add_argument("--start", type=float, default=1.4, help="of an element on its node [s]")
parser.add_argument("--dispatch", type=float, default=0.01, help="of an element in the controller, one after another [s]")
parser.add_argument("--record", type=float, default=0.0004, help="of a record in the driver, one after another [s]")
parser.add_argument("--array", type=int, default=10_001, help="MaxArraySize of the cluster")
o = parser.parse_args()

piece = math.ceil(max(1, min(120 / max(1e-3, o.seconds), o.runs / (4 * o.cores)), o.runs / (o.array - 1)))
cores, controller, ends, work, start = [0.0] * o.cores, 0.0, [], 0.0, 0
heapq.heapify(cores)
while start < o.runs:
    free = heapq.heappop(cores)
    controller = max(controller, free) + o.dispatch
    clock = controller + o.start
    for k in range(start, min(o.runs, start + piece)):
        length = o.seconds * (1 + o.spread * math.sin(k))
        clock, work = clock + length, work + length
        ends.append(clock)
    heapq.heappush(cores, clock)
    start += piece
driver = 0.0
for end in sorted(ends):
    driver = max(driver, end) + o.record
ideal, elements = work / o.cores, math.ceil(o.runs / piece)
print(f"{o.seconds:8.3g} s a run: pieces of {piece:4}, {elements:6} elements, ideal {ideal:9.1f} s, computed after {max(ends):9.1f} s, "
      f"read after {driver:9.1f} s, efficiency {100 * ideal / driver:5.1f} %; alone: dispatch {elements * o.dispatch:7.1f} s, "
      f"driver {o.runs * o.record:6.1f} s, files {o.runs / max(ends):7.1f} /s")
