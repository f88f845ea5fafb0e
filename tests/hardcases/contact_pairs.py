#!/usr/bin/python3
"""Every pair of bodies that touch loses energy by default, the energy balance closes, and runs without damping on races keep their energy.

    contact_pairs.py PROGRAM

PROGRAM is `adore`. Each scene below makes the contacts that it names touch and runs three times: by default, with `contactDamping=0` and with
`contactDamping=0.3`. By default and with a number each named item of the energy ledger is positive; with 0 there is none. Exit 1: one is not.
"""

import json
import os
import subprocess
import sys
import tempfile

NO_CAGE = {"nCseg": 0, "kNumPltElem": 1, "kPltElemInd": 1}
OUTER, INNER = "heat, damping at the outer race [J]", "heat, damping at the inner race [J]"
POCKETS, LANDS = "heat, damping in the cage pockets [J]", "heat, damping at the guide lands [J]"
FLANGES, NEIGHBORS = "heat, damping at the inner race flanges [J]", "heat, damping between elements [J]"
OIL = {"kTrac": 6, "reRaceFilm": 1e-8, "strParam": 10.0}
NO_LAND_CLEARANCE = {"cageGsCls[1]": 1e-8}
UNEVEN = {"cageGsCls[1]": 4.04e-5, "kCageGsImp": 1, "cageGsRadVar1[1]": 2e-5, "cageGsRadVar2[1]": 0.0,
          "gravityVecZ": -500.0}  # the cage falls through the 0.04 um that its land errors leave
# (title, deck, sets, turns, items that take energy, items that do not exist)
SCENES = [
    ("balls, races and pockets", "ball", {"avRatio": 1.2}, 0.05, [OUTER, INNER, POCKETS], []),
    ("balls in oil", "ball", {**OIL, "avRatio": 1.2}, 0.05, [OUTER, INNER, POCKETS], []),
    ("balls without a cage", "ball", {**NO_CAGE, "nRe": 14, "gravityVecZ": -2000.0, "appLoadX": 300.0, "appLoadZ": 1500.0}, 1.0,
     [OUTER, INNER, NEIGHBORS], [POCKETS]),
    ("guide lands", "cylindrical", NO_LAND_CLEARANCE, 0.02, [OUTER, INNER, LANDS], []),
    ("guide lands with shape errors", "cylindrical", UNEVEN, 0.05, [LANDS], []),
    ("cylindrical rollers", "cylindrical", {"avRatio": 1.2}, 0.02, [OUTER, INNER, POCKETS], []),
    ("tapered rollers", "tapered", {"avRatio": 1.2}, 0.02, [OUTER, INNER, POCKETS, FLANGES], []),
    ("barrels", "spherical", {"avRatio": 1.2}, 0.02, [OUTER, INNER, POCKETS], []),
    ("rollers without a cage", "cylindrical", {**NO_CAGE, "nRe": 17, "gravityVecZ": -2000.0, "appLoadZ": 500.0}, 0.1,
     [OUTER, INNER, NEIGHBORS], [POCKETS]),
    ("balls, mode 1", "ball", {"mode": 1, "avRatio": 1.2}, 0.05, [POCKETS], [OUTER, INNER]),
    ("balls, mode 2", "ball", {"mode": 2, "avRatio": 1.2}, 0.05, [POCKETS], [OUTER, INNER]),
    ("rollers, mode 1", "cylindrical", {"mode": 1, "avRatio": 1.2}, 0.02, [POCKETS], [OUTER, INNER]),
    ("light balls in balance", "ball", {"qFac": 0.05, "appLoadX": 200.0, "appLoadZ": 2000.0}, 0.2, [OUTER, INNER], []),
    ("arkode-imex", "ball", {"intMet": 33, "avRatio": 1.2}, 0.05, [OUTER, INNER, POCKETS], []),
]


def run(program, folder, deck, sets, turns, damping):
    path, out = os.path.join(folder, deck + ".txt"), os.path.join(folder, "run")
    if not os.path.exists(path):
        subprocess.run([program, "new", deck, "--out", path], check=True, capture_output=True)
    words = [program, "run", path, "--out", out, "--overwrite", "--quiet", "--until", f"{turns}rev"]
    for name, value in sets.items():
        words += ["--set", f"{name}={value}"]
    if damping is not None:
        words += ["--opt", f"contactDamping={damping}"]
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode != 0:
        return None, done.stderr.strip().splitlines()[-1:]
    with open(os.path.join(out, "RUN.json"), encoding="utf-8") as file:
        told = json.load(file)
    return told["conservation"]["energy"], "\n".join(told["notes"])


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    program, wrong = os.path.abspath(sys.argv[1]), 0
    with tempfile.TemporaryDirectory() as folder:
        for title, deck, sets, turns, takes, lacks in SCENES:
            faults = []
            for damping in (None, "0.3", "0"):
                energy, said = run(program, folder, deck, sets, turns, damping)
                name = f"contactDamping {damping or 'by default'}"
                if energy is None:
                    faults.append(f"{name}: {said}")
                    continue
                if damping == "0":
                    faults += [f"{name}: {item}" for item in energy if "damping" in item]
                    if "contact damping is off" not in said:
                        faults.append(f"{name}: no note")
                    continue
                faults += [f"{name}: {item} {energy.get(item)}" for item in takes if not energy.get(item, 0.0) > 0.0]
                faults += [f"{name}: {item} exists" for item in lacks if item in energy]
                if abs(energy["residual over energy moved"]) > 1e-4:
                    faults.append(f"{name}: residual {energy['residual over energy moved']:g} of the energy moved")
            print(f"{title}: {'; '.join(faults) if faults else 'yes'}", flush=True)
            wrong += bool(faults)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
