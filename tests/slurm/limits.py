#!/usr/bin/env python3
"""Limits of Slurm: time limit, memory limit, a node that fails. Each is provoked on the cluster of one node.

A worker that hangs meets its time limit, a worker that takes more memory than it asked for is ended, the node fails with all its processes.
Each time the study must finish automatically, with RUNS.csv and STUDY.h5 equal to an undisturbed study. A run that meets its limits
repeatedly has its diagnosis in the table, and the others are done.

    limits.py ADORE [--only time,memory,node,always]

Exit code 0: passed. 1: failed. 77: Slurm is missing (with the reason).
"""
import argparse
import csv
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
RUNS = 8


class Bench:
    def __init__(self, adore, root, environment, cluster):
        self.adore, self.root, self.environment, self.cluster = adore, root, environment, cluster

    def study(self, name):
        folder = self.root / name
        folder.mkdir()
        subprocess.run([self.adore, "new", "ball", "--out", "DATA.txt"], cwd=folder, check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
        (folder / "a.json").write_text(json.dumps(
            {"adore_study": 1, "kind": "sweep", "deck": "DATA.txt", "set": {"mode": -1},
             "variables": [{"name": "appLoadX", "grid": [500, 3000, RUNS]}], "quantities": ["largest_contact_load_N"]}))
        # The pilot runs are made here and without trouble: the plan knows what a run takes.
        subprocess.run([self.adore, "study", "plan", "a.json"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        return folder

    def slurm(self, *words):
        return subprocess.run(words, env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True).stdout

    def start(self, folder, trouble=None):
        environment = dict(self.environment)
        if trouble:
            (self.root / "trouble").write_text(trouble)
            environment.update(LD_PRELOAD=str(self.root / "trouble.so"), ADORE_TROUBLE=str(self.root / "trouble"))
        return subprocess.Popen([self.adore, "study", "run", "a.json", "--engine", "slurm", "--progress", "json"], cwd=folder,
                                env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def state_after(self, element, seconds=200):
        """State that Slurm reports for the end of a running element."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            state = re.search(r"JobState=(\S+)", self.slurm("scontrol", "show", "job", element))
            if state and state.group(1) not in ("RUNNING", "COMPLETING", "CONFIGURING"):
                return state.group(1)
            time.sleep(0.5)
        return "still running"

    def hanging(self, seconds=60):
        """The process that took the trouble, and the array element that it computes."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            for taken in self.root.glob("trouble.[0-9]*"):
                pid = int(taken.suffix[1:])
                taken.unlink()
                words = dict(word.split("=", 1) for word in
                             pathlib.Path(f"/proc/{pid}/environ").read_text().split("\0") if "=" in word)
                return pid, words["SLURM_ARRAY_JOB_ID"] + "_" + words["SLURM_ARRAY_TASK_ID"]
            time.sleep(0.2)
        sys.exit("no worker took the trouble within a minute")


def end(driver, what, seconds=420):
    begin = time.monotonic()
    try:
        said = driver.communicate(timeout=seconds)[0]
    except subprocess.TimeoutExpired:
        driver.kill()
        sys.exit(f"{what}: the driver did not end within {seconds} s\n{driver.communicate()[0][-2000:]}")
    print(f"{what}: exit {driver.returncode} after {time.monotonic() - begin:.0f} s", flush=True)
    return driver.returncode, said


def equal(a, b, what):
    for name in ("RUNS.csv", "STUDY.h5"):
        if (a / "a.study" / name).read_bytes() != (b / "a.study" / name).read_bytes():
            sys.exit(f"{what}: {name} differs from the study that nobody disturbed")
    print(f"{what}: RUNS.csv and STUDY.h5 equal", flush=True)


def finishes(bench, whole, folder, driver, what):
    code, said = end(driver, what)
    if code != 0:
        sys.exit(f"{what}: exit {code}\n{said[-2000:]}")
    equal(whole, folder, what)


def time_limit(bench, whole):
    folder = bench.study("time")
    driver = bench.start(folder, "hang")
    _, element = bench.hanging()
    bench.slurm("scontrol", "update", f"JobId={element}", "TimeLimit=1")
    finishes(bench, whole, folder, driver, "time limit")


def memory(bench, whole):
    folder = bench.study("memory")
    driver = bench.start(folder, "memory 700")
    _, element = bench.hanging()
    print(f"memory limit: Slurm says {bench.state_after(element)}", flush=True)
    finishes(bench, whole, folder, driver, "memory limit")


def node(bench, whole):
    folder = bench.study("node")
    driver = bench.start(folder, "hang")
    worker, _ = bench.hanging()
    node_id = int((bench.root / "cluster" / "slurmd.pid").read_text())
    # The power goes: the daemon, its children and what they compute.
    parent = int(pathlib.Path(f"/proc/{worker}/stat").read_text().rsplit(")", 1)[1].split()[1])
    for pid in [node_id, parent, worker]:
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
    (bench.root / "cluster" / "slurmd.pid").unlink(missing_ok=True)
    for _ in range(120):
        if "down" in bench.slurm("sinfo", "--noheader", "--format=%t"):
            break
        time.sleep(1)
    else:
        sys.exit("node: Slurm did not see it die within two minutes")
    subprocess.run([*bench.cluster, "start-node", str(bench.root / "cluster")], check=True)
    finishes(bench, whole, folder, driver, "node failure")


def always(bench, whole):
    """One run hangs whenever it is computed: it gets its record, the others theirs, and --retry-failed makes it whole."""
    folder = bench.study("always")
    driver = bench.start(folder, "hang")
    while driver.poll() is None:
        for taken in bench.root.glob("trouble.[0-9]*"):
            pid = int(taken.suffix[1:])
            taken.unlink()
            try:
                words = pathlib.Path(f"/proc/{pid}/environ").read_text()
            except OSError:
                continue
            element = "_".join(re.search(rf"SLURM_ARRAY_{key}=(\d+)", words).group(1) for key in ("JOB_ID", "TASK_ID"))
            bench.slurm("scontrol", "update", f"JobId={element}", "TimeLimit=1")
            (bench.root / "trouble").write_text("hang")  # for the next one
        time.sleep(0.5)
    code, said = end(driver, "always at its limit", 5)
    (bench.root / "trouble").unlink(missing_ok=True)
    rows = list(csv.DictReader((folder / "a.study" / "RUNS.csv").open()))
    failed = [row for row in rows if row["exit"] != "0"]
    if code != 3 or not failed or not all("time limit" in row["message"] for row in failed):
        sys.exit(f"always at its limit: exit {code}, failed rows {failed}\n{said[-2000:]}")
    print(f"always at its limit: {len(failed)} of {len(rows)} runs keep their diagnosis: {failed[0]['message']}", flush=True)
    again = subprocess.run([bench.adore, "study", "resume", "a.json", "--retry-failed", "--quiet"], cwd=folder, check=False)
    if again.returncode != 0:
        sys.exit(f"always at its limit: --retry-failed: exit {again.returncode}")
    equal(whole, folder, "always at its limit, then --retry-failed")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("adore")
    parser.add_argument("--only", default="time,memory,node")
    options = parser.parse_args()
    options.adore = str(pathlib.Path(options.adore).resolve())
    with tempfile.TemporaryDirectory(prefix="adore-limits-", ignore_cleanup_errors=True) as passing:
        root = pathlib.Path(passing).resolve()
        subprocess.run([os.environ.get("CC", "cc"), "-shared", "-fPIC", "-O1", "-o", str(root / "trouble.so"), str(HERE / "trouble.c")],
                       check=True)
        cluster = ["bash", str(HERE / "one_node_cluster.sh")]
        started = subprocess.run([*cluster, "start", str(root / "cluster"), "JobAcctGatherType=jobacct_gather/linux",
                                  "JobAcctGatherFrequency=task=1", "JobAcctGatherParams=OverMemoryKill", "KillWait=5"],
                                 stdout=subprocess.PIPE, text=True)
        try:
            if started.returncode != 0:
                return started.returncode
            environment = dict(os.environ, SLURM_CONF=str(root / "cluster" / "slurm.conf"))
            environment["PATH"] += ":/usr/sbin:/sbin"
            bench = Bench(options.adore, root, environment, cluster)
            whole = bench.study("whole")
            subprocess.run([options.adore, "study", "run", "a.json", "--quiet"], cwd=whole, check=True)
            provoked = {"time": time_limit, "memory": memory, "node": node, "always": always}
            for name in options.only.split(","):
                provoked[name](bench, whole)
        finally:
            subprocess.run([*cluster, "stop", str(root / "cluster")], check=False)
    return 0


if __name__ == "__main__":
    sys.exit(main())
