#!/usr/bin/env python3
"""Damaged result files and decks before every program that reads them.

    damaged_files.py BIN RUN... [--count 300] [--seed 1] [--keep FOLDER]

BIN is the folder of the programs, each RUN a folder with DATA.txt, SOL1 to SOL8 and RESULTS.h5. COUNT times
one file of a run is copied with its neighbors and damaged: cut in the middle of a record or anywhere,
overflow stars as Fortran writes them, lines lost, doubled or swapped, foreign bytes, invalid numbers,
bits flipped. Then AdrPlot, AGORE and AdrInput draw it without a window, and `adore plot`, `animate`, `show`,
`convert` and `check` read it. Each must end within a minute of processor time with exit code 0, 2 or 3.
Another code (1 is a bug), a signal or an end without a message is reported with the seed, and the exit code is 1.
An interrupted campaign prints its results up to this point.
"""
import argparse
import collections
import os
import pathlib
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile

TEXTS = ["DATA.txt", "SOL1", "SOL2", "SOL3", "SOL4", "SOL5", "SOL6", "SOL7", "SOL8", "RUN.json"]
BAD = [b"****************", b"NaN", b"-Infinity", b"1.0E+999", b"0.1D-400", b"99999999999999999999", b"-1",
       b"", b"abc", b"\xff\xfe", b"1e308", b"0"]


def damage_text(data, rng):
    """@return what was done, and the bytes"""
    lines = data.split(b"\n")
    kind = rng.choice(["cut", "cut in a line", "stars", "lost line", "doubled line", "swapped lines",
                       "numbers", "foreign bytes", "bits", "empty", "head only", "stars in the head"])
    if kind == "cut":
        return kind, data[:rng.randrange(len(data))]
    if kind == "cut in a line":
        line = rng.randrange(len(lines))
        return kind, b"\n".join(lines[:line] + [lines[line][:rng.randrange(len(lines[line]) + 1)]])
    if kind in ("stars", "numbers", "stars in the head"):
        most = min(len(lines), 6) if kind == "stars in the head" else len(lines)
        for _ in range(rng.choice([1, 1, 3, 30])):
            at = rng.randrange(most)
            words = lines[at].split(b" ")
            places = [i for i, word in enumerate(words) if word]
            if not places:
                continue
            place = rng.choice(places)
            words[place] = b"*" * max(1, len(words[place])) if "stars" in kind else rng.choice(BAD)
            lines[at] = b" ".join(words)
        return kind, b"\n".join(lines)
    if kind == "lost line":
        for _ in range(rng.choice([1, 1, 5])):
            del lines[rng.randrange(len(lines))]
        return kind, b"\n".join(lines)
    if kind == "doubled line":
        at = rng.randrange(len(lines))
        return kind, b"\n".join(lines[:at] + [lines[at]] * rng.choice([2, 50]) + lines[at + 1:])
    if kind == "swapped lines":
        a, b = rng.randrange(len(lines)), rng.randrange(len(lines))
        lines[a], lines[b] = lines[b], lines[a]
        return kind, b"\n".join(lines)
    if kind == "foreign bytes":
        at = rng.randrange(len(data) + 1)
        return kind, data[:at] + rng.randbytes(rng.choice([1, 8, 200])) + data[at:]
    if kind == "bits":
        return kind, flip(data, rng)
    if kind == "head only":
        return kind, b"\n".join(lines[:rng.randrange(1, min(6, len(lines)) + 1)])
    return kind, b""


def flip(data, rng):
    out = bytearray(data)
    for _ in range(rng.choice([1, 4, 40])):
        out[rng.randrange(len(out))] ^= 1 << rng.randrange(8)
    return bytes(out)


def damage_bytes(data, rng):
    kind = rng.choice(["bits", "bits", "bits in the head", "cut", "zeros", "foreign bytes", "swapped blocks"])
    if kind == "bits":
        return kind, flip(data, rng)
    if kind == "bits in the head":
        return kind, flip(data[:4096], rng) + data[4096:]
    if kind == "cut":
        return kind, data[:rng.randrange(len(data))]
    at, size = rng.randrange(len(data)), rng.choice([1, 8, 64, 512])
    if kind == "zeros":
        return kind, data[:at] + bytes(len(data[at:at + size])) + data[at + size:]
    if kind == "foreign bytes":
        return kind, data[:at] + rng.randbytes(len(data[at:at + size])) + data[at + size:]
    other = rng.randrange(len(data))
    return kind, data[:at] + data[other:other + size] + data[at + size:]


def readers(programs, file, out):
    """Command lines that read the file."""
    adore, plot, agore, form = (str(programs / name) for name in ("adore", "adrplot", "agore", "adrinput"))
    small = ["--size", "640x400"]
    name = file.name
    yield [adore, "show", file]
    yield [adore, "convert", file, "--to", "csv", "--out", out / "out.csv"]
    if name == "DATA.txt":
        yield [adore, "check", file]
        yield [form, file, "--render", out / "form", *small]
        return
    if name in ("SOL8", "RESULTS.h5"):
        view = random.Random(str(file)).choice(["bearing", "cage", "pocket", "element", "race", "section", "3d"])
        yield [agore, file, "--render", out / "motion", "--view", view, *small]
        yield [adore, "animate", file, "--out", out / "animate", "--frame", "1", "--view", view]
        return
    yield [plot, file, "--render", out / "plots", *small]
    yield [adore, "plot", file, "--out", out / "plot"]
    if name == "RUN.json":  # AGORE reads other files of the folder
        yield [agore, file.parent / "SOL8", "--render", out / "motion", *small]


def limit():
    resource.setrlimit(resource.RLIMIT_CPU, (60, 70))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def one_file(given, seed, environment, ends):
    """Damages a file and has it read. @return faults"""
    faults = 0
    rng = random.Random(seed)
    run = rng.choice(given.runs)
    names = [n for n in TEXTS + ["RESULTS.h5"] * 3 if (run / n).is_file()]
    name = rng.choice(names)
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder) / "run"
        place.mkdir()
        for other in run.iterdir():
            if other.is_file():
                shutil.copy(other, place / other.name)
        data = (place / name).read_bytes()
        damaged = damage_bytes if name == "RESULTS.h5" else damage_text
        kind, data = damaged(data, rng)
        (place / name).write_bytes(data)
        for command in readers(given.bin, place / name, pathlib.Path(folder)):
            command = [str(word) for word in command]
            try:
                done = subprocess.run(command, env=environment, timeout=1800, stdout=subprocess.PIPE,
                                      stderr=subprocess.STDOUT, check=False, preexec_fn=limit)
                code, said = done.returncode, done.stdout
            except subprocess.TimeoutExpired as late:
                code, said = "time-out", late.stdout or b""
            program = pathlib.Path(command[0]).name
            what = program if program != "adore" else f"adore {command[1]}"
            ends[(what, code)] += 1
            silent = code in (2, 3) and not said.strip()
            if code in (0, 2, 3) and not silent:
                continue
            faults += 1
            print(f"seed {seed}: {run.name}/{name}, {kind}: {what} ended with {code}"
                  f"{', without a word' if silent else ''}: {said[-300:].decode(errors='replace')}", flush=True)
            if given.keep:
                given.keep.mkdir(parents=True, exist_ok=True)
                shutil.copy(place / name, given.keep / f"{seed}-{name}")
    return faults


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("bin", type=pathlib.Path)
    parser.add_argument("runs", nargs="+", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path, help="files that a program failed on are copied there")
    given = parser.parse_args()
    environment = dict(os.environ, QT_QPA_PLATFORM="offscreen")
    ends, faults, files = collections.Counter(), 0, 0
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        for seed in range(given.seed, given.seed + given.count):
            faults += one_file(given, seed, environment, ends)
            files += 1
    except KeyboardInterrupt:
        pass  # results up to this point
    for (what, code), count in sorted(ends.items(), key=str):
        print(f"{what}: exit {code}: {count}")
    print(f"{files} files, {faults} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
