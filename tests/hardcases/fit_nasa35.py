#!/usr/bin/env python3
"""Fits the two parameters of NASA-35 and writes them, also as parameters of NASA-120 and NASA-167, into
resources/experiments/experiments.json.  Usage: fit_nasa35.py ADORE [--write]

Share of oil in the cavity: x = c W^0.37 dm^-0.7 (n dm)^-p (1.3e6)^(p-1), W [cm3/min], n [rpm], dm [mm].  Least squares of
ln(ours/theirs) over the four speeds, c and p within the bounds of experiments.json.  NASA-120 has no part in the fit."""
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "resources/experiments/experiments.json"
HEAT = {28000: 350, 48000: 700, 64000: 1100, 72000: 1400}


def share(c, p, flow, rpm, dm):
    return c * flow**0.37 / dm**0.7 * (1.3e6) ** (p - 1) / (rpm * dm) ** p


def heat(adore, deck, rpm, x):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([adore, "run", str(ROOT / f"resources/experiments/{deck}.txt"), "--out", folder, "--quiet", "--progress",
                        "none", "--set", f"rpm2={rpm}.0", "--set", f"denRatio={x:.6f}"], check=True, capture_output=True)
        return json.loads((Path(folder) / "RUN.json").read_text())["summary"]["friction_power_W"]


def error(adore, c, p):
    return sum(math.log(heat(adore, "nasa-35", n, share(c, p, 760, n, 46.5)) / q) ** 2 for n, q in HEAT.items())


def fit(adore, c_bounds, p_bounds):
    """A pattern search in (ln c, p), which needs no derivative and keeps the bounds."""
    at, step = [math.log(1e5), 1.5], [0.3, 0.3]
    best = error(adore, math.exp(at[0]), at[1])
    while max(step) > 0.004:
        moved = False
        for k in (0, 1):
            for sign in (1, -1):
                there = list(at)
                there[k] += sign * step[k]
                there[1] = min(max(there[1], p_bounds[0]), p_bounds[1])
                there[0] = min(max(there[0], math.log(c_bounds[0])), math.log(c_bounds[1]))
                e = error(adore, math.exp(there[0]), there[1])
                if e < best - 1e-9:
                    at, best, moved = there, e, True
        if not moved:
            step = [0.5 * s for s in step]
    return math.exp(at[0]), at[1], best


def main():
    adore = sys.argv[1]
    page = json.loads(PAGE.read_text())
    by_id = {e["id"]: e for e in page["experiments"]}
    small = by_id["NASA-35"]
    bounds = {q["name"]: (q["low"], q["high"]) for q in small["parameters"]}
    c, p, best = fit(adore, bounds["c"], bounds["p"])
    c, p = float(f"{c:.4g}"), round(p, 3)
    print(f"c = {c:g}, p = {p:g}, root of the mean square of ln(ours/theirs) {math.sqrt(best / 4):.4f}")
    for name in ("NASA-35", "NASA-120", "NASA-167"):
        for q in by_id[name]["parameters"]:
            q["value"] = {"c": c, "p": p}[q["name"]]
        for run in by_id[name]["runs"]:
            if "literature" not in run["condition"]:
                run["oil_share"] = {"c": c, "p": p}
    if "--write" in sys.argv:
        PAGE.write_text(dump(page))


def dump(page):
    """Runs, parameters and other items on a line each."""
    experiments = []
    for e in page["experiments"]:
        members = []
        for name, value in e.items():
            if isinstance(value, list):
                items = ",\n".join("    " + json.dumps(one, ensure_ascii=False) for one in value)
                members.append(f'   "{name}": [\n{items}\n   ]')
            else:
                members.append(f'   "{name}": ' + json.dumps(value, ensure_ascii=False))
        experiments.append("  {\n" + ",\n".join(members) + "\n  }")
    meta = json.dumps(page["meta"], ensure_ascii=False, indent=1).replace("\n", "\n ")
    return '{\n "meta": ' + meta + ',\n "experiments": [\n' + ",\n".join(experiments) + "\n ]\n}\n"


main()
