#!/usr/bin/env python3
"""All features of the manual: each row of features.tsv is a check with a number, its command and its verdict.

    run.py BIN [--group G ...] [--only F123 ...] [--ci] [--markdown FILE] [--jobs N] [--list] [--ignore]

BIN is `adore`; adrinput, adrplot and agore are in its folder. A row compares numbers with independent values or relations: closed forms,
conservation laws, limits, ratios, other files. The rows of expected_failures.tsv fail, and all others pass; otherwise the exit code is 1.

--ignore checks the checks: each variable of variables.tsv keeps the deck's value (or the one behind its `=`) in all runs of its row, as if the program ignored it, and the
row must fail by a comparison. A row that only stops because a run is rejected proves nothing and counts as not failed.
"""

import argparse
import csv
import datetime
import importlib
import multiprocessing
import os
import resource
import shutil
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
import bench  # noqa: E402

# The part that CI runs: groups without long runs, some 20 s of processor time.
CI = ["statics", "files", "materials", "life"]


def load_checks():
    for name in sorted(os.listdir(HERE)):
        if name.startswith("checks_") and name.endswith(".py"):
            importlib.import_module(name[:-3])
    for checks in bench.GROUPS.values():
        for identifier in bench.NOT_CHECKED:
            checks.pop(identifier, None)


def read_table(name):
    with open(os.path.join(HERE, name), encoding="utf-8") as file:
        return list(csv.DictReader((line for line in file if not line.startswith("#")), delimiter="\t"))


def run_group(task):
    program, group, only = task
    load_checks()
    folder = tempfile.mkdtemp(prefix=f"adore-features-{group}-")
    place = bench.Bench(program, folder)
    rows = []
    before = used()
    try:
        for identifier, check in bench.GROUPS.get(group, {}).items():
            if only and identifier not in only:
                continue
            begin = used()
            try:
                command, comparisons = check(place)
                good = sum(c.holds for c in comparisons)
                verdict = "works" if comparisons and good == len(comparisons) else "partial" if good else "wrong"
                rows.append((identifier, command, [c.text() for c in comparisons if not c.holds] or [], [c.text() for c in comparisons],
                             verdict, used() - begin))
            except Exception as problem:  # a check that cannot measure is a failed check
                rows.append((identifier, "", [f"{type(problem).__name__}: {problem}"], [f"{type(problem).__name__}: {problem}"], "wrong",
                             used() - begin))
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    return group, rows, used() - before


def try_ignored(program, group, only):
    """(id, variable, what the row says when the program ignores the variable) of each variable of the group's rows in variables.tsv."""
    out = []
    for row in read_table("variables.tsv"):
        check = bench.GROUPS.get(group, {}).get(row["id"])
        if check is None or (only and row["id"] not in only):
            continue
        for variable in row["variables"].split():
            folder = tempfile.mkdtemp(prefix=f"adore-ignore-{group}-")
            place = bench.Bench(program, folder)
            name, _, value = variable.partition("=")
            place.ignored = {name: None if not value else int(value) if value.isdigit() else float(value)}
            try:
                _, comparisons = check(place)
                verdict = "not noticed" if all(c.holds for c in comparisons) else "fails"
            except bench.Failed as problem:  # a rejected run proves nothing
                verdict = f"stops: {str(problem)[-160:]}"
            except Exception:  # nothing to measure
                verdict = "fails"
            finally:
                shutil.rmtree(folder, ignore_errors=True)
            out.append((row["id"], variable, verdict))
    return out


def check_the_checks(options):
    bad = total = 0
    for group in options.group or list(bench.GROUPS):
        for identifier, variable, verdict in try_ignored(os.path.abspath(options.bin), group, options.only):
            total += 1
            if verdict != "fails":
                bad += 1
                print(f"{identifier} with {variable} ignored: {verdict}", flush=True)
    print(f"{total} variables ignored one by one, {total - bad} noticed by their rows, {used():.0f} s of processor time")
    return 1 if bad else 0


def used():
    own, children = resource.getrusage(resource.RUSAGE_SELF), resource.getrusage(resource.RUSAGE_CHILDREN)
    return own.ru_utime + own.ru_stime + children.ru_utime + children.ru_stime


def clean(text):
    return text.replace("|", "\\|").replace("\n", " ")


def write_markdown(path, features, results, reasons):
    counts = {}
    lines = []
    for f in features:
        identifier = f["id"]
        if identifier in results:
            _, command, failed, texts, verdict, _ = results[identifier]
            shown = "; ".join(failed if failed else texts)
            if len(shown) > 420:
                shown = shown[:417] + "..."
            if identifier in reasons:
                shown += " — " + reasons[identifier]
            lines.append(f"| {identifier} | {clean(f['feature'])} | `{clean(command)}` | {clean(shown)} | {verdict} |")
        else:
            verdict = "not checked"
            lines.append(f"| {identifier} | {clean(f['feature'])} | | {clean(bench.NOT_CHECKED.get(identifier, 'no check yet'))} | {verdict} |")
        counts[verdict] = counts.get(verdict, 0) + 1
    with open(path, "w", encoding="utf-8") as file:
        file.write("# Features of the manual\n\n"
                   f"Tables: written by `tests/features/run.py build/release/bin/adore --markdown resources/docs/features.md`, {datetime.date.today()}. Each row runs the command "
                   "and compares numbers with values that do not come from the feature itself. "
                   "A row that names a test case (`ctest -R`) counts the test of that name; CI runs it.\n\n"
                   "Column *result*: `measured = expected`, `>`, `<`, `≠` with the tolerance; of a failed row only what fails.\n\n")
        file.write("| verdict | features |\n|---|---|\n" + "".join(f"| {k} | {v} |\n" for k, v in sorted(counts.items())) + "\n")
        file.write("| id | feature | command | result | verdict |\n|---|---|---|---|---|\n" + "\n".join(lines) + "\n")
    return counts


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("bin")
    parser.add_argument("--group", action="append", default=[])
    parser.add_argument("--only", action="append", default=[])
    parser.add_argument("--ci", action="store_true")
    parser.add_argument("--markdown")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--verbose", action="store_true")
    parser.add_argument("--ignore", action="store_true")
    options = parser.parse_args()
    load_checks()
    features = read_table("features.tsv")
    known = {f["id"] for f in features}
    expected = {row["id"]: row["reason"] for row in read_table("expected_failures.tsv")}
    reasons = expected
    groups = options.group or (CI if options.ci else list(bench.GROUPS))
    if options.only:
        groups = [g for g in bench.GROUPS if any(i in bench.GROUPS[g] for i in options.only)]
    if options.list:
        for group in bench.GROUPS:
            print(group, len(bench.GROUPS[group]), " ".join(bench.GROUPS[group]))
        missing = [i for i in sorted(known) if not any(i in c for c in bench.GROUPS.values())]
        print("without a check", len(missing), " ".join(missing))
        return 0
    for group in bench.GROUPS.values():
        for identifier in group:
            assert identifier in known, f"{identifier} is not a feature"
    if options.ignore:
        return check_the_checks(options)
    tasks = [(os.path.abspath(options.bin), group, options.only) for group in groups]
    begin = time.time()
    results, spent = {}, 0.0
    with multiprocessing.Pool(options.jobs, maxtasksperchild=1) as pool:
        for group, rows, seconds in pool.imap_unordered(run_group, tasks):
            spent += seconds
            print(f"{group}: {len(rows)} rows, {seconds:.1f} s of processor time", flush=True)
            for row in rows:
                results[row[0]] = row
    wrong = 0
    for identifier in sorted(results):
        _, command, failed, texts, verdict, seconds = results[identifier]
        if options.verbose:
            print(f"{identifier} {verdict} {seconds:.1f} s  {command}\n      " + "\n      ".join(texts))
        if verdict != "works":
            told = "expected failure" if identifier in expected else "FAILED"
            wrong += identifier not in expected
            print(f"{identifier} {told} ({verdict}): {'; '.join(failed)[:600]}  [{command}]")
        elif identifier in expected:
            wrong += 1
            print(f"{identifier} FAILED: it works, but expected_failures.tsv lists it; remove the line")
    print(f"{len(results)} of {len(features)} features checked, {sum(r[4] == 'works' for r in results.values())} work, "
          f"{spent:.0f} s of processor time, {time.time() - begin:.0f} s")
    if options.markdown:
        print(write_markdown(options.markdown, features, results, reasons))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
