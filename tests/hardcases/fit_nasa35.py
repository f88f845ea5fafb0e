#!/usr/bin/env python3
"""Fits the two parameters of NASA-35 and writes its rows, and those of NASA-120 with the same parameters, into
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


def rows(deck, speeds, c, p, flow, dm, theirs, kind, certainty, sets=None, note=""):
    out = []
    for n in speeds:
        row = {"of": "power_loss", "unit": "W"}
        if theirs:
            row["theirs"] = float(theirs[n])
        out.append({"condition": f"{n:,} rpm{note}", "deck": deck,
                    "set": {"rpm2": float(n), "denRatio": round(share(c, p, flow, n, dm), 6), **(sets or {})},
                    "kind": kind, "certainty": certainty, "rows": [row]})
    return out


def main():
    adore = sys.argv[1]
    page = json.loads(PAGE.read_text())
    by_id = {e["id"]: e for e in page["experiments"]}
    small, large = by_id["NASA-35"], by_id["NASA-120"]
    bounds = {q["name"]: (q["low"], q["high"]) for q in small["parameters"]}
    c, p, best = fit(adore, bounds["c"], bounds["p"])
    c, p = float(f"{c:.4g}"), round(p, 3)
    print(f"c = {c:g}, p = {p:g}, root of the mean square of ln(ours/theirs) {math.sqrt(best / 4):.4f}")
    for q in small["parameters"]:
        q["value"] = {"c": c, "p": p}[q["name"]]
    large["parameters"] = [dict(q, meaning=q["meaning"] + ", as fitted to NASA-35") for q in small["parameters"]]
    small["runs"] = rows("nasa-35", HEAT, c, p, 760, 46.5, HEAT, "calibration", "second hand, digitised, 3 %, rounded")
    large["runs"] = rows("nasa-120", (5000, 8000, 12000), c, p, 2280, 160.0, None, "prediction", "kept aside") + \
        rows("nasa-120", (5000, 8000, 12000), c, p, 2280, 160.0, None, "prediction", "kept aside",
             {"freeConAng": 25.0, "raceCurFac1": 0.535, "raceCurFac2": 0.535}, ", 25 deg, 0.535")
    if "--write" in sys.argv:
        PAGE.write_text(dump(page))


def dump(page):
    """Runs on a line each, the rest indented."""
    text = json.dumps(page, indent=2, ensure_ascii=False)
    for e in page["experiments"]:
        for run in e.get("runs", []):
            block = json.dumps(run, indent=2, ensure_ascii=False).replace("\n", "\n        ")
            text = text.replace(block, json.dumps(run, ensure_ascii=False))
        for q in e.get("parameters", []):
            block = json.dumps(q, indent=2, ensure_ascii=False).replace("\n", "\n        ")
            text = text.replace(block, json.dumps(q, ensure_ascii=False))
    return text + "\n"


main()
