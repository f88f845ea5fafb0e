#!/usr/bin/python3
"""Support for tests that compare a settled motion with an equilibrium: runs, windows of revolutions, equilibria.

A *window* is a number of revolutions of the inner race relative to the outer, at least half of one. All means of a window are integrals over time between its
ends: heat and turns from the ledgers and angles that the run itself integrates, loads from the means between stored steps. A motion has
*settled* when the means of two successive windows of equal length differ by less than 2 %; the later of the two is the settled window. Its life is the
harmonic mean over time of the life at the loads of each stored step.

Race heat of rollers with skew from pocket impacts scatters between revolutions (decision 264). The standard error of windows of two revolutions
and more is that of half revolutions; a change of race heat within its 95 % interval does not count.

An equilibrium *at a displacement* is mode -1 with the forces replaced by the displacement (kFS1 to kFS3 = 1); one *at a load* is mode -1 of
the unchanged deck. Both are means over the phases of the elements, which a motion passes. Only the program and the files that it writes are used; no package is needed.
"""

import csv
import json
import math
import os
import re
import resource
import shutil
import signal
import subprocess
import tempfile

SETTLED = 0.02  # largest relative difference between the means of successive windows


class RunError(Exception):
    """A run or an equilibrium that did not end with exit 0; `code` None: the processor time was used up."""

    def __init__(self, code, text):
        super().__init__(text)
        self.code = code


def new_deck(program, name, path):
    subprocess.run([program, "new", name, "--out", path], check=True, capture_output=True)


def call(words, seconds):
    """Standard output of a command. @raises RunError"""
    limit = math.ceil(seconds)
    done = subprocess.run(words, capture_output=True, text=True, check=False,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 5)))
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        raise RunError(None, f"not done after {limit} s of processor time")
    if done.returncode != 0:
        lines = [line for line in done.stderr.splitlines() if line and ": warning: " not in line and ": note: " not in line]
        raise RunError(done.returncode, (lines or [f"exit {done.returncode} without a message"])[0])
    return done.stdout, done.stderr


def words_of(sets, options):
    out = []
    for name, value in sets.items():
        out += ["--set", f"{name}={value:.9g}" if isinstance(value, float) else f"{name}={value}"]
    for name, value in options.items():
        out += ["--opt", f"{name}={value}"]
    return out


# ---- equilibria ----

def equilibrium(program, deck, sets, options=None, seconds=120.0, folder=None):
    """Equilibrium at the load of the deck (mode -1): the summary of RUN.json, SI units, and "tables". @raises RunError"""
    folder = folder or tempfile.mkdtemp(prefix="equilibrium_", dir=os.path.dirname(deck))  # decks of a type run side by side
    words = [program, "run", deck, "--out", folder, "--quiet", "--overwrite"] + words_of({**sets, "mode": -1}, options or {})
    try:
        call(words, seconds)
        with open(os.path.join(folder, "RUN.json"), encoding="utf-8") as file:
            report = json.load(file)
        return {**report["summary"], "report": report}
    finally:
        shutil.rmtree(folder, ignore_errors=True)


PHASES = (0.0, 0.25, 0.5, 0.75)  # of the elements, in spacings


def phase_mean(program, deck, sets, elements, displacement=None, options=None, seconds=120.0):
    """Mean equilibrium over the phases of the elements, as a motion passes them; turning load and displacement is the same as turning the
    elements. At the load of the deck, or with the inner race held at `displacement` (x, y, z) [m].
    @return force (x, y, z) [N], contact_load (mean of all) [N], largest [N], life [hr], friction_power [W] and the equilibrium of phase 0"""
    found = []
    for phase in PHASES:
        angle = phase * 2.0 * math.pi / elements

        def turned(y, z, by=angle):
            return y * math.cos(by) - z * math.sin(by), y * math.sin(by) + z * math.cos(by)

        more = dict(sets)
        if displacement is not None:
            y, z = turned(displacement[1], displacement[2])
            more.update(kFS1=1, kFS2=1, kFS3=1, appDispX=float(displacement[0]), appDispY=y, appDispZ=z)
        else:
            more["appLoadY"], more["appLoadZ"] = turned(float(sets.get("appLoadY", 0.0)), float(sets["appLoadZ"]))
        solution = equilibrium(program, deck, more, options, seconds)
        x, y, z = load_of(solution)
        loads = [q for name, column in solution["report"]["quasi_static"]["tables"]["elements"].items()
                 if name in ("outer load [N]", "inner load [N]") for q in column]
        found.append({"force": (x, *turned(y, z, -angle)), "contact_load": sum(loads) / len(loads), "largest": solution["largest_contact_load_N"],
                      "damage": 1.0 / solution["life_lp_hours"], "friction_power": solution.get("friction_power_W"), "solution": solution})

    def mean(key):
        return sum(one[key] for one in found) / len(found)

    powers = [one["friction_power"] for one in found]
    return {"force": [sum(one["force"][k] for one in found) / len(found) for k in range(3)], "contact_load": mean("contact_load"),
            "largest": max(one["largest"] for one in found), "life": 1.0 / mean("damage"),
            "friction_power": None if None in powers else sum(powers) / len(powers), "solution": found[0]["solution"]}


def displacement_of(solution):
    return [solution[f"displacement_{k}_m"] for k in "xyz"]


def load_of(solution):
    return [solution[f"load_{k}_N"] for k in "xyz"]


# ---- motions ----

BULK = ("raceTemp1", "raceTemp2", "reTemp", "cageTemp", "hsngTemp", "shftTemp")

class Motion:
    """A run that is made longer until it has settled. @param origin folder of a run whose FINAL it starts from (kIcOpt = -1)"""

    def __init__(self, program, deck, folder, sets, options=None, seconds=600.0, origin=None):
        self.program, self.deck, self.folder, self.origin = program, deck, folder, origin
        self.sets, self.options, self.seconds = dict(sets), dict(options or {}), seconds
        self.started = False
        self.messages = ""
        self.columns = {}

    def extend(self, revolutions):
        """Runs or continues until so many revolutions since the start. @raises RunError"""
        words = [self.program, "run", self.deck, "--out", self.folder, "--quiet", "--until", f"{revolutions:g}rev"]
        words += ["--continue"] if self.started else ["--overwrite"]
        if self.origin and not self.started:
            os.makedirs(self.folder, exist_ok=True)
            shutil.copy(os.path.join(self.origin, "FINAL"), self.folder)
            words += ["--set", "kIcOpt=-1"]
        _, self.messages = call(words + words_of(self.sets, self.options), self.seconds)
        self.started = True
        with open(os.path.join(self.folder, "RUN.json"), encoding="utf-8") as file:
            self.report = json.load(file)
        # Temperatures of the present geometry of a thermal run: outer race, inner race, elements, cage, housing, shaft [K].
        with open(os.path.join(self.folder, "MASTER"), encoding="utf-8") as file:
            found = dict(reversed(line.split()) for line in file if re.fullmatch(r"\S+ thermal\.geometry\.\d+", line.strip()))
        self.bulk = {name: float(found[f"thermal.geometry.{k}"]) for k, name in enumerate(BULK)} if found else {}
        self.read()

    def read(self):
        """Channels of RESULTS.h5 as columns by their name in `adore convert` without unit, in the deck's units."""
        out, _ = call([self.program, "convert", os.path.join(self.folder, "RESULTS.h5"), "--to", "csv"], self.seconds)
        rows = csv.reader(out.splitlines())
        names = [re.sub(r" *\[(?!\d)[^\]]*\]$", "", name) for name in next(rows)]
        table = list(rows)
        self.columns = {name: [float(row[k]) if row[k] else math.nan for row in table] for k, name in enumerate(names) if wanted(name)}

    def window(self, first, last):
        """Values between two revolutions since the start."""
        return Window(self.columns, first, last)

    def settle(self, longest, shortest=1.0, also=(), earliest=0.0):
        """Extends the run window by window, at most to `longest` revolutions, until two successive windows of 1, 2 or 4 times `shortest`
        revolutions have the same means. @param also further keys of window values that have to settle
        @param earliest revolutions that belong to no window @return window, and whether it has settled"""
        count, begin = round(longest / shortest), round(earliest / shortest)
        for last in range(begin + 2, count + 1):
            self.extend(last * shortest)
            for length in (1, 2, 4):
                if 2 * length <= last - begin:
                    now, before = (self.window((last - k - length) * shortest, (last - k) * shortest) for k in (0, length))
                    if now.change_since(before, also) < SETTLED:
                        return now, True
        length = min(4, count // 2)
        return self.window((count - length) * shortest, count * shortest), False

    def remove(self):
        shutil.rmtree(self.folder, ignore_errors=True)


CHANNELS = re.compile(r"time|shaft_rotation|contact\.load(_high|_mean)?\..*|contact\.slip(_high)?\..*|power\.(life|element_temperature|cage_temperature)|energy\..*|"
                      r"cage\.rotation\.1|cage\.(whirl_ratio|radial_position)\.1|race\.applied_force_[xyz](_mean)?\.2|race\.temperature\..|"
                      r"thermal\..*|element\.orbital_(position|velocity)\..*|element\.phi\..*|element\.angular_velocity_vector\..*|race\.[xyz]\.2")


def wanted(name):
    return CHANNELS.fullmatch(name) is not None


class Window:
    """Means, extremes and life between two revolutions."""

    MEANS = ("load", "contact_load", "race_heat", "cage_ratio", "orbital_ratio")

    def __init__(self, columns, first, last):
        turns = [abs(angle - columns["shaft_rotation"][0]) / (2.0 * math.pi) for angle in columns["shaft_rotation"]]
        self.columns, self.turns, self.first, self.last = columns, turns, first, last
        self.inside = [k for k, turn in enumerate(turns) if first + 1e-9 < turn <= last + 1e-9]  # a stored step stands for the interval before it
        time = columns["time"]
        self.span = self.at("time", last) - self.at("time", first)
        self.begin = self.at("time", first)
        self.weights = {k: time[k] - time[k - 1] for k in self.inside}
        self.values = self.evaluate()

    def __getitem__(self, key):
        return self.values[key]

    def get(self, key):
        return self.values.get(key)

    def at(self, name, turn):
        """Value at a revolution, linear between stored steps."""
        column = self.columns[name]
        low, high = 0, len(self.turns) - 1
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (middle, high) if self.turns[middle] <= turn else (low, middle)
        width = self.turns[high] - self.turns[low]
        share = min(1.0, (turn - self.turns[low]) / width) if width > 0.0 else 0.0
        return column[low] + share * (column[high] - column[low])

    def rate(self, name):
        """Change per time of a cumulative channel."""
        return (self.at(name, self.last) - self.at(name, self.first)) / self.span

    PIECE = 0.5  # revolutions

    def standard_error(self, cumulative):
        """Of the mean rate of a sum of cumulative channels, from pieces of half a revolution; 0 of less than four pieces."""
        pieces = round((self.last - self.first) / self.PIECE)
        if pieces < 4:
            return 0.0
        ends = [self.first + (self.last - self.first) * k / pieces for k in range(pieces + 1)]
        totals, times = [sum(self.at(name, turn) for name in cumulative) for turn in ends], [self.at("time", turn) for turn in ends]
        rates = [(totals[k + 1] - totals[k]) / (times[k + 1] - times[k]) for k in range(pieces)]
        middle = sum(rates) / pieces
        return math.sqrt(sum((r - middle) ** 2 for r in rates) / (pieces - 1) / pieces)

    def mean(self, name):
        """Time mean: of the means between stored steps, where there are such, else of trapezoids."""
        means = self.columns.get(with_suffix(name, "_mean"))
        values = self.columns[name]
        total = sum(w * (means[k] if means is not None and math.isfinite(means[k]) else 0.5 * (values[k] + values[k - 1]))
                    for k, w in self.weights.items())
        return total / sum(self.weights.values())

    def names(self, pattern):
        return [name for name in self.columns if re.fullmatch(pattern, name)]

    def highest(self, names):
        """(value, time, name) of the largest value between and at stored steps."""
        best = (-math.inf, math.nan, "")
        for name in names:
            column = self.columns.get(with_suffix(name, "_high"), self.columns[name])
            for k in self.inside:
                value = column[k] if math.isfinite(column[k]) else self.columns[name][k]
                if value > best[0]:
                    best = (value, self.columns["time"][k], name)
        return best

    def evaluate(self):
        contacts = self.names(r"contact\.load\.\d+\.\d+")
        shaft = (self.last - self.first) * 2.0 * math.pi / self.span
        out = {"force": [self.mean(f"race.applied_force_{k}.2") for k in "xyz"],
               "contact_load": sum(map(self.mean, contacts)) / len(contacts),
               "orbital_ratio": sum(abs(self.rate(name)) for name in self.names(r"element\.orbital_position\.\d+"))
               / len(self.names(r"element\.orbital_position\.\d+")) / shaft,
               "position": [self.mean(f"race.{k}.2") for k in "xyz"]}
        out["load"] = math.hypot(*out["force"])
        out["largest"], out["largest_time"], out["largest_contact"] = self.highest(contacts)
        lives = self.columns["power.life"]
        damage = sum(w / lives[k] if lives[k] > 0.0 else math.nan for k, w in self.weights.items()) / sum(self.weights.values())
        out["life"] = 1.0 / damage if damage > 0.0 else math.inf
        if "energy.heat.1" in self.columns:
            names = self.names(r"energy\.(heat|rolling_heat|flange_heat)\.[12]")
            out["race_heat"] = sum(map(self.rate, names))
            out["race_heat_error"] = self.standard_error(names)
            out["race_heat_pieces"] = max(4, round((self.last - self.first) / self.PIECE))
        if "cage.rotation.1" in self.columns:
            out["cage_ratio"] = abs(self.rate("cage.rotation.1")) / shaft
        for key, name in (("outer", "race.temperature.1"), ("inner", "race.temperature.2"), ("elements", "power.element_temperature"),
                          ("cage", "power.cage_temperature")):
            if name in self.columns:
                out[f"temperature_{key}"] = self.at(name, self.last)
        return out

    def change_since(self, before, also=()):
        """Largest relative difference of the means of two windows; of temperatures: 1 for 50 K."""
        worst = 0.0
        for key in self.MEANS + tuple(also):
            now, then = self.values.get(key), before.values.get(key)
            if now is None or then is None:
                continue
            if key.startswith("temperature"):
                worst = max(worst, abs(now - then) / 50.0)
            elif max(abs(now), abs(then)) > 0.0:
                change = abs(now - then)
                if key == "race_heat" and change <= interval(self, before):
                    continue
                worst = max(worst, change / max(abs(now), abs(then)))
        return worst


STUDENT = {3: 3.18, 4: 2.78, 5: 2.57, 6: 2.45, 8: 2.31, 10: 2.23, 15: 2.13, 30: 2.04}  # 95 %, by degrees of freedom


def interval(one, other):
    """Half width of the 95 % interval of the difference of race heat of two windows [W]. Degrees of freedom by Welch and Satterthwaite: of windows of
    four pieces 6 where both scatter alike, 3 where one of them does. 0: a window is too short for an error, and the means are compared as they are."""
    errors = [(w.get("race_heat_error") or 0.0, w.get("race_heat_pieces") or 4) for w in (one, other)]
    variance = sum(e * e for e, _ in errors)
    if variance == 0.0:
        return 0.0
    freedom = variance**2 / sum(e**4 / (n - 1) for e, n in errors)
    return STUDENT[max(k for k in STUDENT if k <= max(3, freedom + 1e-9))] * math.sqrt(variance)


def with_suffix(name, suffix):
    """"contact.load.1.2" -> "contact.load_mean.1.2"."""
    stem, dot, places = re.fullmatch(r"([a-z_0-9]*\.[a-z_0-9]*?)(\.|$)([\d.]*)", name).groups()
    return stem + suffix + dot + places
