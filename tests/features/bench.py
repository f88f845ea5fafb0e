"""Runs that the feature checks share, and the comparisons they make.

A check is a function with the decorator `feature`; it gets a Bench and returns the command that shows the feature and a list of comparisons.
Runs are cached by deck, changed variables, options and length: rows that need the same run share it.
"""

import csv
import json
import math
import os
import shlex
import subprocess

GROUPS = {}  # name of a group -> {id of a feature: function}
NOT_CHECKED = {}  # id -> reason


def feature(identifier, group):
    """Registers a check. Each feature has one check."""

    def register(function):
        known = [i for checks in GROUPS.values() for i in checks]
        assert identifier not in known, f"{identifier} has two checks"
        GROUPS.setdefault(group, {})[identifier] = function
        return function

    return register


def not_checked(identifier, reason):
    NOT_CHECKED[identifier] = reason


class Comparison:
    def __init__(self, what, measured, relation, expected, holds):
        self.what, self.measured, self.relation, self.expected, self.holds = what, measured, relation, expected, bool(holds)

    def text(self):
        return f"{self.what}: {number(self.measured)} {self.relation} {number(self.expected)}"


def number(value):
    if isinstance(value, bool) or isinstance(value, str):
        return str(value)
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, (list, tuple, set)):
        return "[" + ", ".join(number(v) for v in list(value)[:8]) + (", …" if len(value) > 8 else "") + "]"
    return str(value)


def close(what, measured, expected, rel=1e-6, absolute=0.0):
    """Equal within a relative and an absolute tolerance; one of the two is enough."""
    holds = math.isfinite(measured) and abs(measured - expected) <= max(absolute, rel * abs(expected))
    tolerance = f"(±{absolute:.2g})" if absolute else f"(±{100 * rel:.2g} %)"
    return Comparison(what, float(measured), "=", f"{number(expected)} {tolerance}", holds)


def equal(what, measured, expected):
    return Comparison(what, measured, "=", expected, measured == expected)


def more(what, measured, limit):
    return Comparison(what, measured, ">", limit, measured > limit)


def less(what, measured, limit):
    return Comparison(what, measured, "<", limit, measured < limit)


def between(what, measured, low, high):
    return Comparison(what, measured, "in", f"{number(low)} to {number(high)}", low <= measured <= high)


def differs(what, measured, other, rel=1e-6):
    """The variable acts: the value changes by more than `rel`."""
    return Comparison(what, float(measured), "≠", f"{number(other)} (by > {rel:.0e})",
                      math.isfinite(measured) and abs(measured - other) > rel * max(abs(measured), abs(other), 1e-300))


class Failed(Exception):
    """A run that was to complete did not."""


class Run:
    def __init__(self, command, code, out, err, folder):
        self.command, self.code, self.out, self.err, self.folder = command, code, out, err, folder
        self._json = self._channels = None

    def path(self, name):
        return os.path.join(self.folder, name)

    def read(self, name):
        with open(self.path(name), encoding="utf-8", errors="replace") as file:
            return file.read()

    def has(self, name):
        return os.path.exists(self.path(name))

    @property
    def json(self):
        if self._json is None:
            self._json = json.loads(self.read("RUN.json"))
        return self._json

    @property
    def summary(self):
        return self.json["summary"]

    @property
    def ledger(self):
        return self.json["conservation"]["energy"]

    @property
    def fits(self):
        return self.json["operating fits"]

    @property
    def elements(self):
        return self.json["quasi_static"]["tables"]["elements"]

    def table(self, name):
        return self.json["quasi_static"]["tables"][name]

    def sol(self, name):
        return Sol(self.read(name))

    @property
    def listing(self):
        return self.read("PRINT.txt")

    def listed(self, words, nth=0):
        """The numbers behind `words` in the n-th line of PRINT.txt that has them."""
        lines = [line for line in self.listing.splitlines() if words in line]
        out = []
        for word in lines[nth].split(words, 1)[1].replace(",", " ").split():
            try:
                out.append(float(word))
            except ValueError:
                pass
        return out

    def channels(self, program):
        if self._channels is None:
            target = self.path("channels.csv")
            subprocess.run([program, "convert", self.path("RESULTS.h5"), "--to", "csv", "--out", target],
                           check=True, capture_output=True)
            with open(target, encoding="utf-8") as file:
                rows = list(csv.reader(file))
            names = [name.split(" [")[0] for name in rows[0]]
            columns = list(zip(*rows[1:]))
            self._channels = {n: [float(v) if v not in ("", "nan") else math.nan for v in c] for n, c in zip(names, columns)}
        return self._channels


class Sol:
    """A file SOL1 to SOL7 by its header counts and fixed columns."""

    def __init__(self, text):
        lines = text.splitlines()
        self.head = lines[:4]
        self.program, self.run_id = lines[0][2:14].strip(), lines[0][19:55].strip()
        self.title = lines[1].split("$")[0].strip()
        self.integers = [int(lines[2][2 + 6 * k:8 + 6 * k]) for k in range(20)]
        self.units = [lines[3][2 + 12 * k:12 + 12 * k].strip() for k in range(10)]
        count = self.integers[0]
        rows = -(-count // 8)
        self.steps, self.values = [], []
        at = 4
        while at + rows < len(lines) + 0 and lines[at].strip():
            head = lines[at]
            self.steps.append([float(head[2 + 16 * k:18 + 16 * k]) for k in range(5)])
            row = "".join(line[2:].ljust(128) for line in lines[at + 1:at + 1 + rows])
            self.values.append([real(row[16 * k:16 * k + 16]) for k in range(count)])
            at += 1 + rows

    def column(self, number):
        """Values of quantity `number` of outputs.md, counted from 1."""
        return [v[number - 1] for v in self.values]

    @property
    def times(self):
        return [s[4] for s in self.steps]


def real(text):
    text = text.strip()
    if not text or "*" in text:
        return math.nan
    try:
        return float(text)
    except ValueError:  # a three-digit exponent without its letter
        at = max(text.rfind("+"), text.rfind("-"))
        return float(text[:at] + "e" + text[at:])


class Bench:
    def __init__(self, program, folder):
        self.program, self.folder = os.path.abspath(program), folder
        self.bin = os.path.dirname(self.program)
        self.root = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
        self.kept = {}
        self.ignored = {}  # variable -> value that it keeps, None: that of the deck; as if the program ignored it (run.py --ignore)
        self.environment = dict(os.environ, QT_QPA_PLATFORM="offscreen", LC_ALL="C.UTF-8")

    def call(self, *words, program=None, given=None, check=True, where=None):
        """A command of `adore` or of one of the programs in its folder."""
        kept = []
        for word in words:
            name = word.split("=")[0]
            if kept and kept[-1] == "--set" and self.drops(name):
                value = self.ignored[name.split("[")[0]]
                kept.pop()
                kept += [] if value is None else ["--set", f"{name}={value!r}"]
            else:
                kept.append(word)
        words = kept
        path = self.program if program is None else os.path.join(self.bin, program)
        done = subprocess.run([path, *words], capture_output=True, text=True, input=given, env=self.environment,
                              cwd=where or self.folder, timeout=300)
        if check and done.returncode != 0:
            raise Failed(f"{os.path.basename(path)} {' '.join(words)[:200]}: exit {done.returncode}: {done.stderr.strip()[-300:]}")
        return done

    def drops(self, variable):
        return variable.split("[")[0] in self.ignored

    def deck(self, name):
        path = os.path.join(self.folder, name + ".txt")
        if not os.path.exists(path):
            self.call("new", name, "--out", path)
        return path

    def calc(self, name, **inputs):
        done = self.call("calc", name, given=json.dumps(inputs))
        return json.loads(done.stdout)

    def run(self, deck="ball", sets=None, until="0.05rev", opts=None, more=(), tail="", head=None, check=True, edit=None):
        """A run of an example deck with changed variables. tail: lines of records 12; edit: a change of the deck's text."""
        sets, opts = {k: v if not self.drops(k) else self.ignored[k.split("[")[0]] for k, v in (sets or {}).items()}, dict(opts or {})
        sets = {k: v for k, v in sets.items() if v is not None}
        key = json.dumps([deck, sets, until, opts, list(more), tail, edit.__name__ + str(edit.__defaults__) if edit else ""], sort_keys=True)
        if key in self.kept:
            return self.kept[key]
        number_of = len(self.kept) + 1
        path = self.deck(deck)
        shown = f"{deck}.txt"
        if tail or edit:
            with open(path, encoding="utf-8") as file:
                text = file.read()
            if edit:
                text = edit(text)
            shown = f"{deck}-{number_of}.txt"
            path = os.path.join(self.folder, shown)
            with open(path, "w", encoding="utf-8") as file:
                file.write(text.rstrip("\n") + "\n" + tail)
        out = os.path.join(self.folder, f"run{number_of}")
        words = ["run", path, "--out", out, "--quiet"]
        if until:
            words += ["--until", until]
        for name, value in sets.items():
            words += ["--set", f"{name}={value!r}" if isinstance(value, float) else f"{name}={value}"]
        for name, value in opts.items():
            words += ["--opt", f"{name}={value}"]
        words += list(more)
        done = self.call(*words, check=False)
        command = "adore " + " ".join(shlex.quote(w) for w in ["run", shown] + words[5:])
        command = command.replace(self.folder + "/", "")
        result = Run(command, done.returncode, done.stdout, done.stderr, out)
        self.kept[key] = result
        if check and done.returncode != 0:
            raise Failed(f"{command}: exit {done.returncode}: {done.stderr.strip()[-300:]}")
        return result

    def static(self, deck="ball", sets=None, **rest):
        rest.setdefault("until", None)
        return self.run(deck, {"mode": -1, **(sets or {})}, **rest)

    def channels(self, run):
        return run.channels(self.program)

    def plug_in(self, name, code):
        """A user routine in C, compiled once. None without a compiler."""
        import shutil
        compiler = shutil.which("cc") or shutil.which("gcc")
        if compiler is None:
            raise Failed("no C compiler")
        source, target = os.path.join(self.folder, name + ".c"), os.path.join(self.folder, "lib" + name + ".so")
        if not os.path.exists(target):
            with open(source, "w", encoding="utf-8") as file:
                file.write('#include "adore_user.h"\n#include <math.h>\n#include <stdio.h>\n'
                           "int32_t adore_user_abi(void) { return ADORE_USER_ABI; }\n" + code)
            subprocess.run([compiler, "-O1", "-shared", "-fPIC", "-I", os.path.join(self.root, "core", "user"), source, "-o", target,
                            "-lm"], check=True, capture_output=True)
        return target

    def formulas(self, name, content):
        """A user routine as JSON of formulas."""
        path = os.path.join(self.folder, name + ".json")
        with open(path, "w", encoding="utf-8") as file:
            json.dump(content, file)
        return path
