#!/usr/bin/env python3
"""Studies give the same bytes, with all engines and with killed workers.

Runs a quasi-static and a dynamic study three times: `local` with one worker without kills; `local` with workers killed at random;
`slurm` on a one-node cluster (one_node_cluster.sh) with workers killed at random and the node's daemon once. RUNS.csv and STUDY.h5 must
be equal to the last byte, and no run may have failed.

    same_tables.py ADORE [--statics N] [--dynamics N] [--engines local,slurm] [--keep FOLDER] [--every SECONDS]

Exit 0: equal. 1: not. 77: the local part is equal, and Slurm is missing (with the reason).
"""
import argparse
import csv
import json
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import threading
import time

HERE = pathlib.Path(__file__).resolve().parent


def study(kind, runs):
    """A sweep over the load: every run differs, each is short."""
    text = {"adore_study": 1, "kind": "sweep", "deck": "DATA.txt", "set": {"mode": -1 if kind == "statics" else 0},
            "variables": [{"name": "appLoadX", "grid": [500, 3000, runs]}],
            "quantities": ["largest_contact_load_N"]}
    if kind == "statics":
        text["quantities"] += ["stiffness_x_N_per_m", "life_lp_hours"]
    else:
        text["until"] = "0.05rev"
        text["quantities"] += [{"channel": "contact.load", "statistic": "rms"}]
    return text


def workers_in(folder):
    """Processes of this user that compute in `folder`: `adore study work FOLDER ...`."""
    for entry in pathlib.Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            words = (entry / "cmdline").read_bytes().split(b"\0")
        except OSError:
            continue
        if words[1:3] == [b"study", b"work"] and words[3] == os.fsencode(str(folder)):
            yield int(entry.name)


class Killer(threading.Thread):
    """Ends a worker of the study at random, by SIGKILL or SIGTERM, and the node's daemon once."""

    def __init__(self, folder, every, seed, node=None):
        super().__init__(daemon=True)
        self.folder, self.every, self.node = folder, every, node
        self.chance, self.over, self.killed, self.nodes = random.Random(seed), threading.Event(), 0, 0

    def run(self):
        while not self.over.wait(self.chance.uniform(0.2, 1.8) * self.every):
            workers = list(workers_in(self.folder))
            if not workers:
                continue
            try:
                os.kill(self.chance.choice(workers), self.chance.choice([signal.SIGKILL, signal.SIGKILL, signal.SIGTERM]))
                self.killed += 1
            except OSError:
                continue
            if self.node and self.killed == 2:
                self.node()
                self.nodes += 1

    def end(self):
        self.over.set()
        self.join()


def run(adore, folder, kind, runs, arguments, every=None, node=None, environment=None):
    """Runs the study in a separate folder. Returns elapsed seconds, kills, and the table's rows."""
    if (folder / "a.study" / "STUDY.h5").exists():
        print(f"{kind:9} {runs:5} runs  {folder.name} is there already", flush=True)
        return folder / "a.study"
    folder.mkdir(parents=True)
    subprocess.run([adore, "new", "ball", "--out", "DATA.txt"], cwd=folder, check=True, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL)
    (folder / "a.json").write_text(json.dumps(study(kind, runs)))
    killer = Killer(folder / "a.study", every, runs, node) if every else None
    if killer:
        killer.start()
    begin = time.monotonic()
    done = subprocess.run([adore, "study", "run", str(folder / "a.json"), "--quiet", *arguments], env=environment,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    elapsed = time.monotonic() - begin
    if killer:
        killer.end()
    if done.returncode != 0:
        sys.exit(f"{folder}: exit {done.returncode}\n{done.stdout}")
    rows = list(csv.DictReader((folder / "a.study" / "RUNS.csv").open()))
    times = list(csv.DictReader((folder / "a.study" / "TIMES.csv").open()))
    failed = [row["run"] for row in rows if row["exit"] != "0"]
    if failed or len(rows) != runs:
        sys.exit(f"{folder}: {len(rows)} rows, of them failed: {failed}")
    processor = sum(float(row["processor [s]"]) for row in times)
    print(f"{kind:9} {runs:5} runs  {' '.join(arguments):32} {elapsed:8.2f} s, {processor:8.2f} s of processors, "
          f"{killer.killed if killer else 0:4} workers killed, {killer.nodes if killer else 0} daemons", flush=True)
    return folder / "a.study"


def slow_enough(study_folder, every):
    """Seconds between kills: some runs must come through, however busy the machine is."""
    rows = csv.DictReader((study_folder / "TIMES.csv").open())
    walls = sorted(float(row["wall [s]"]) for row in rows)
    return max(every, 4 * walls[len(walls) * 9 // 10])


def same(a, b):
    for name in ("RUNS.csv", "STUDY.h5"):
        if (a / name).read_bytes() != (b / name).read_bytes():
            sys.exit(f"{a / name} and {b / name} differ")
    print(f"          {b.parent.name}: RUNS.csv and STUDY.h5 equal {a.parent.name}", flush=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("adore")
    parser.add_argument("--statics", type=int, default=40)
    parser.add_argument("--dynamics", type=int, default=6)
    parser.add_argument("--every", type=float, default=0.3, help="seconds between kills, on average (at least)")
    parser.add_argument("--engines", default="local,slurm")
    parser.add_argument("--keep", type=pathlib.Path, help="folder that stays; studies that are whole there are not run again")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="adore-same-", ignore_cleanup_errors=True) as passing:
        root = (options.keep or pathlib.Path(passing)).resolve()
        sizes = {"statics": options.statics, "dynamics": options.dynamics}
        whole = {kind: run(options.adore, root / f"{kind}-whole", kind, runs, ["--workers", "1"]) for kind, runs in sizes.items()}
        for kind, runs in sizes.items():
            same(whole[kind], run(options.adore, root / f"{kind}-local", kind, runs, ["--workers", "2"],
                                  slow_enough(whole[kind], options.every)))
        if "slurm" not in options.engines:
            return 0
        cluster = ["bash", str(HERE / "one_node_cluster.sh")]
        folder = str(root / "cluster")
        started = subprocess.run([*cluster, "start", folder], stdout=subprocess.PIPE, text=True)
        try:
            if started.returncode != 0:
                return started.returncode
            environment = dict(os.environ, SLURM_CONF=str(root / "cluster" / "slurm.conf"))
            environment["PATH"] += ":/usr/sbin:/sbin"

            def restart_node():
                subprocess.run([*cluster, "stop-node", folder], check=True)
                subprocess.run([*cluster, "start-node", folder], check=True)

            for kind, runs in sizes.items():
                same(whole[kind], run(options.adore, root / f"{kind}-slurm", kind, runs, ["--engine", "slurm"],
                                      slow_enough(whole[kind], options.every), restart_node, environment))
        finally:
            subprocess.run([*cluster, "stop", folder], check=False)
    return 0


if __name__ == "__main__":
    sys.exit(main())
