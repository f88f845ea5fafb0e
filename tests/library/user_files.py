#!/usr/bin/env python3
"""Whole runs with plug-ins that fail at a random call: no run hangs, and every remaining file can be read.

    user_files.py ADORE [RUNS [SEED]]

The plug-in of tests/core/user/plug_ins/behaviours.c, with faults from a random call on, is built and run in a separate process
(`--opt userProcess=1`); behaviors that do not end a process (values, refusals) also in this one. Each run must end with 0 or 3; with 3 the
message names ADRX7; `adore show` must read FINAL, RUN.json, SOL8 and RESULTS.h5 of each. Exit 77 where there is no C compiler.
"""
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
TOP = HERE.parents[1]
SAME_PROCESS = (0, 1, 2, 3, 4, 5, 10, 11, 13)  # faults that neither end nor overwrite the program


def build(folder):
    text = (TOP / "tests/core/user/plug_ins/behaviours.c").read_text()
    late = text.replace("++calls < 3)", "++calls < 3 + (int)late)").replace("static double what, seed;", "static double what, seed, late;")
    late = late.replace("double in[2];", "double in[3];").replace("in, 2) != 2", "in, 3) != 3").replace("seed = in[1];", "seed = in[1], late = in[2];")
    assert late.count("late") >= 3, "behaviours.c has changed: adapt the lines above"
    (folder / "late.c").write_text(late)
    subprocess.run(["cc", "-O1", "-fPIC", "-shared", "-I", TOP / "core/user", "-o", folder / "late.so", folder / "late.c", "-lm"], check=True)
    return folder / "late.so"


def main():
    if not shutil.which("cc"):
        print("skipped: there is no C compiler on this machine", file=sys.stderr)
        return 77
    adore, runs = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 30
    chance = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 16)
    ends = {}
    with tempfile.TemporaryDirectory(prefix="adore-user-files-") as passing:
        root = pathlib.Path(passing)
        plug_in = build(root)
        deck = (TOP / "resources/decks/ball.txt").read_text()
        for k in range(runs):
            what, late = chance.randrange(14), chance.randrange(900)
            own_process = what not in SAME_PROCESS or chance.random() < 0.5
            out = root / f"run{k}"
            (root / "DATA.txt").write_text(f"{deck}{what} {k} {late}\n")
            command = [adore, "run", root / "DATA.txt", "--out", out, "--quiet", "--user", plug_in, "--set", "kTrac=-1", "--set", "nStps=2",
                       "--set", "kAGraf=1", "--until", "2e-4s", "--opt", "userSample=8"]  # fmt: skip
            if own_process:
                command += ["--opt", "userProcess=1", "--opt", "userTimeout=2"]
            done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300)
            where = f"behavior {what} from call {late} on, {'separate process' if own_process else 'this process'}"
            if done.returncode not in (0, 3):
                sys.exit(f"{where}: exit {done.returncode}\n{done.stdout}")
            if done.returncode == 3 and "ADRX7" not in done.stdout:
                sys.exit(f"{where}: the message does not name the routine\n{done.stdout}")
            for name in ("FINAL", "RUN.json", "SOL8", "RESULTS.h5"):
                if not (out / name).exists():
                    if done.returncode == 0:
                        sys.exit(f"{where}: no {name}")
                    continue
                shown = subprocess.run([adore, "show", out / name], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
                if shown.returncode != 0:
                    sys.exit(f"{where}: {name} cannot be read\n{shown.stdout}")
            ends.setdefault(what, []).append(done.returncode)
            shutil.rmtree(out, ignore_errors=True)
    print(f"{runs} runs: " + ", ".join(f"behavior {what}: {codes.count(0)} done, {codes.count(3)} ended" for what, codes in sorted(ends.items())))
    return 0


if __name__ == "__main__":
    sys.exit(main())
