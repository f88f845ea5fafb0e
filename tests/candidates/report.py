#!/usr/bin/env python3
"""Compares the candidates of `adore new --from` with the published bearings of published_bearings.json.

    tests/candidates/report.py ADORE             print the tables (Markdown)
    tests/candidates/report.py ADORE --write     write resources/docs/bearing-candidates.md
    tests/candidates/report.py ADORE --rules     the 20 bearings for rules only

A geometry is found when a candidate has its count and its element diameter within 1 %. Fault factors are those
of the published geometry (the pitch diameter is the mean of bore and outside diameter where it is not printed),
or the published ones.
"""
import json
import math
import statistics
import subprocess
import sys
from datetime import date
from pathlib import Path

HERE = Path(__file__).parent
PAGE = HERE.parents[1] / "resources" / "docs" / "bearing-candidates.md"
NAMES = ("BPFO", "BPFI", "FTF", "BSF")


def facts_of(b, ratings=True):
    facts = {"type": b["type"]}
    for key in ("bore", "outside", "width"):
        facts[key] = f"{b[key]} mm"
    if b["type"] == "angular-contact" or b["type"] == "tapered":
        facts["contact_angle"] = f"{b['angle']} deg"
    if ratings:
        facts["C"], facts["C0"] = f"{b['C']} N", f"{b['C0']} N"
    return facts


def candidates(adore, facts):
    run = subprocess.run([adore, "new", "--from", "-", "--json"], input=json.dumps(facts), text=True,
                         capture_output=True)
    if run.returncode not in (0, 2) or not run.stdout:
        sys.exit(f"{facts}: {run.stderr}")
    return json.loads(run.stdout)


def true_factors(b):
    if "element" not in b:
        return {k: v for k, v in b.get("factors", {}).items()}
    pitch = b.get("pitch", 0.5 * (b["bore"] + b["outside"]))
    gamma = b["element"] * math.cos(math.radians(b["angle"])) / pitch
    return {"BPFO": b["count"] * (1 - gamma) / 2, "BPFI": b["count"] * (1 + gamma) / 2, "FTF": (1 - gamma) / 2,
            "BSF": 0.5 * pitch / b["element"] * (1 - gamma * gamma)}


def error(candidate, truth):
    return max(abs(candidate[k] / truth[k] - 1) for k in truth)


def same(candidate, b, truth):
    if candidate["count"] != b["count"]:
        return False
    if "element" in b:
        return abs(candidate["element_diameter [m]"] * 1e3 / b["element"] - 1) < 0.01
    return error(candidate, truth) < 0.02


def compare(adore, bearings):
    rows = []
    for b in bearings:
        found = candidates(adore, facts_of(b))["candidates"]
        truth = true_factors(b)
        rank = next((n for n, c in enumerate(found, 1) if same(c, b, truth)), 0)
        near = next((n for n, c in enumerate(found, 1) if error(c, truth) < 0.02), 0)
        of_truth = candidates(adore, {**facts_of(b, False), "count": b["count"],
                                      **({"element_diameter": f"{b['element']} mm"} if "element" in b else {}),
                                      **({"element_length": f"{b['length']} mm"} if "length" in b else {}),
                                      **({"pitch_diameter": f"{b['pitch']} mm"} if "pitch" in b else {})})["candidates"]
        ratio = [(of_truth[0][k + "_iso [N]"] / b[k] - 1) if of_truth and "element" in b else None for k in ("C", "C0")]
        rows.append({"b": b, "n": len(found), "rank": rank, "near": near,
                     "first": error(found[0], truth) if found else None, "ratio": ratio})
    return rows


def percent(value):
    return "–" if value is None else f"{100 * value:+.1f}"


def summary(rows):
    n = len(rows)
    count = lambda test: f"{sum(map(test, rows))} of {n} ({100 * sum(map(test, rows)) / n:.0f} %)"
    rated = [r for r in rows if r["ratio"][0] is not None]
    inside = lambda i: f"{sum(abs(r['ratio'][i]) <= 0.03 for r in rated)} of {len(rated)}"
    return "\n".join([
        "| quantity | result | required |", "|---|---|---|",
        f"| a listed candidate has all fault-frequency factors within 2 % | {count(lambda r: r['near'] > 0)} | 90 % |",
        f"| the first candidate has all fault-frequency factors within 2 % | {count(lambda r: (r['first'] or 9) < 0.02 or r['first'] == 0)} | – |",
        f"| the published geometry is in the list | {count(lambda r: r['rank'] > 0)} | all |",
        f"| the published geometry is the first candidate | {count(lambda r: r['rank'] == 1)} | – |",
        f"| candidates, median | {statistics.median(r['n'] for r in rows):g} | at most 5 |",
        f"| C of ISO 281 within 3 % of the printed C | {inside(0)} | all |",
        f"| C0 of ISO 76 within 3 % of the printed C0 | {inside(1)} | all |"])


def table(rows):
    out = ["| bearing | Z | D [mm] | candidates | rank | factors of the first [%] | C of ISO [%] | C0 of ISO [%] |",
           "|---|---|---|---|---|---|---|---|"]
    for r in rows:
        b = r["b"]
        out.append(f"| {b['name']} | {b['count']} | {b.get('element', '–')} | {r['n']} | {r['rank'] or 'not listed'} | "
                   f"{'–' if r['first'] is None else format(100 * r['first'], '.1f')} | {percent(r['ratio'][0])} | "
                   f"{percent(r['ratio'][1])} |")
    return "\n".join(out)


def by_factors(adore, bearings):
    out = ["| bearing | Z | candidates | first: Z, D [mm] | factors of the first [%] |", "|---|---|---|---|---|"]
    good = 0
    for b in bearings:
        facts = {**facts_of(b, False), **{k: b["factors"][k] for k in ("BPFO", "BPFI")}}
        found = candidates(adore, facts)["candidates"]
        off = error(found[0], b["factors"]) if found else None
        good += off is not None and off < 0.02
        first = f"{found[0]['count']}, {1e3 * found[0]['element_diameter [m]']:.3f}" if found else "none"
        out.append(f"| {b['name']} | {b['count']} | {len(found)} | {first} | "
                   f"{'–' if off is None else format(100 * off, '.2f')} |")
    return f"{good} of {len(bearings)} first candidates have all four factors within 2 %.\n\n" + "\n".join(out)


def page(adore, data):
    test = compare(adore, [b for b in data if b.get("set") == "test"])
    rules = compare(adore, [b for b in data if b.get("set") == "rules"])
    factors = [b for b in data if "set" not in b and "factors" in b and "bore" in b]
    return f"""# Candidates of published bearings

Tables: written by `tests/candidates/report.py ADORE --write`, {date.today().isoformat()}.

`adore new --from FACTS.json` lists all internal geometries that
agree with published facts. This page compares the lists with bearings whose geometry or fault-frequency factors are printed
({len(data)} in tests/candidates/published_bearings.json, each with its source). A hash of the name chose 20 of them for the
rules and {len(test)} for the test. The facts given here are type, bore, outside diameter, width, C and C0, and the contact
angle of angular contact and tapered bearings.

The test bearings are those of few makers: {sum(r['b']['source'] in ('GMN', 'SNFA') for r in test)} of {len(test)} are GMN or SNFA
(spindle bearings and deep groove bearings to 40 mm bore). Only {sum(r['b']['type'] not in ('deep-groove', 'angular-contact') for r in test + rules)}
have rollers, with ratings from memory: nothing is proved about roller bearings.

## Test: {len(test)} bearings

{summary(test)}

The printed ratings are not all those of ISO 281 and ISO 76 with grooves of 0.52: C0 of SNFA is 1.25 times ISO 76, GMN KH
bearings have open grooves, and some makers print up to 9 % more. The candidates allow for these conventions; the columns of
C and C0 show the formulas with the published geometry (– : no geometry is printed).

{table(test)}

## Rules: {len(rules)} bearings

{summary(rules)}

{table(rules)}

## Boundary dimensions, BPFO and BPFI: {len(factors)} bearings without ratings

{by_factors(adore, factors)}
"""


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    data = json.loads((HERE / "published_bearings.json").read_text(encoding="utf-8"))["bearings"]
    if "--rules" in sys.argv:
        rows = compare(sys.argv[1], [b for b in data if b.get("set") == "rules"])
        print(summary(rows), table(rows), sep="\n\n")
    elif "--write" in sys.argv:
        PAGE.write_text(page(sys.argv[1], data), encoding="utf-8")
    else:
        print(page(sys.argv[1], data))
