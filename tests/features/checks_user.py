"""Routines of the user (F333 to F347)."""

import math
import os
import subprocess

import hertz
from bench import Failed, between, close, differs, equal, feature, less, more

G = "routines"
SHORT = "2e-4s"
RPM = math.pi / 30.0


def table(run):
    """Rows of SOL9: lines of numbers alone."""
    out = []
    for line in run.read("SOL9").splitlines():
        try:
            row = [float(v) for v in line.split()]
        except ValueError:
            continue
        if len(row) > 1:
            out.append(row)
    return out


def user(b, name, content, deck="ball", sets=None, until=SHORT, **rest):
    return b.run(deck, sets=sets or {}, until=until, more=["--user", b.formulas(name, content)], **rest)


def channels(*names):
    return {"channels": list(names)}


@feature("F333", G)
def _(b):
    # Approach of two bodies at a given load: delta ~ E*^(-2/3), 1/E* = (1 - n^2)/E1 + (1 - n^2)/E2.
    law = b.formulas("adrx0", {"adrx0": {"element": {"elastic_modulus": "310e9", "poisson_ratio": "0.26"}}})
    steel, ceramic = b.static(), b.static(sets={"kReMat": 2}, more=["--user", law])
    p = [max(r.elements["inner pressure [Pa]"]) for r in (steel, ceramic)]
    q = [max(r.elements["inner load [N]"]) for r in (steel, ceramic)]
    e0 = 1e9 * 205.0 if not steel.listed("modulus") else steel.listed("modulus")[0]
    return ceramic.command, [close("peak pressure over load^(1/3), ceramic against steel, as E*^(2/3)", p[1] / p[0] / (q[1] / q[0]) ** (1 / 3),
                                   star(e0, 310e9, 0.26) ** (2 / 3), 0.01)]


def star(steel, other, poisson, nu=0.29):
    """E* of steel against another material over E* of steel against steel."""
    return (2 * (1 - nu**2) / steel) / ((1 - nu**2) / steel + (1 - poisson**2) / other)


@feature("F334", G)
def _(b):
    # A load on a race that mode 2 places is the deck's load; on a held one its support carries it; a driven one has the speed of the closed form.
    two = {"mode": 2, "kDCR": 0}
    show = channels("race.z[2]", "race.applied_force_z[2]", "race.applied_moment_x[2]", "race.angular_velocity[2]")
    deck = user(b, "only9", {"adrx9": show}, sets={**two, "appLoadZ": 800.0})
    load = {"inner_race": {"force": ["0", "0", "300"]}}
    balanced = user(b, "load2", {"adrx1": load, "adrx9": show}, sets={**two, "appLoadZ": 500.0})
    none = user(b, "only9", {"adrx9": show}, sets={**two, "appLoadZ": 500.0})
    out = [close("mode 2: load that the balls carry, 500 N of the deck and 300 N of the routine [N]", table(balanced)[-1][2], 800.0, 1e-3),
           close("place of the race, that under 800 N of the deck [m]", table(balanced)[-1][1], table(deck)[-1][1], 0.01),
           differs("without the routine [m]", table(none)[-1][1], table(deck)[-1][1], 0.1)]
    for mode in (0, 1):
        held = {"mode": mode, "kDCR": 0}
        free = user(b, "only9", {"adrx9": show}, sets=held)
        push = user(b, "push", {"adrx1": {"inner_race": {"force": ["0", "0", "300"], "moment": "0.2"}}, "adrx9": show}, sets=held)
        first, second = table(free), table(push)
        speed = second[-1][4]
        out += [equal(f"mode {mode}, held: steps", len(second), len(first)),
                close(f"mode {mode}, held: reaction [N]", second[-1][2] - first[-1][2], -300.0, 1e-9),
                close(f"mode {mode}, held: moment [N m]", second[-1][3] - first[-1][3], -0.2, 1e-9),
                equal(f"mode {mode}, held: place", second[-1][1], first[-1][1]),
                close(f"mode {mode}: work of the moment [J]", push.ledger["work of user loads on held races [J]"], 0.2 * speed * second[-1][0], 1e-3)]
        path = b.deck("ball")
        said = b.call("check", path, "--set", f"mode={mode}", "--set", "kDCR=0", "--user", b.formulas("push", {"adrx1": {"inner_race": {"force": ["0", "0", "300"], "moment": "0.2"}}, "adrx9": show}),
                      check=False)
        out.append(equal("check warns with the remedy mode 2", "set mode to 2" in said.stdout + said.stderr, True))
    for mode in (0, 1, 2):
        drive = user(b, "drive", {"adrx1": {"inner_race": {"angular_acceleration": "1e6"}}, "adrx9": show}, sets={"mode": mode, "kDCR": 0})
        rows = table(drive)
        out.append(close(f"mode {mode}, driven: speed gained [rad/s]", rows[-1][4] - rows[0][4], 1e6 * (rows[-1][0] - rows[0][0]), 1e-6))
    # Of revolution about x: races at (0, n) in a frame that turns at w are races at (w, n + w), but for the growth of the rings with their speed (3 %).
    given = {"mode": 1, "kFS1": 1, "kFS2": 1, "kFS3": 1, "appDispX": 2e-5, "gravityVecX": 0.0, "gravityVecY": 0.0, "gravityVecZ": 0.0}
    names = channels("contact.load[1]")
    fast = user(b, "load1", {"adrx9": names}, sets={**given, "rpm1": 4000.0, "rpm2": 14000.0})
    slow = user(b, "load1", {"adrx9": names}, sets={**given, "rpm1": 0.0, "rpm2": 10000.0})
    frame = user(b, "frame", {"adrx1": {"frame_omega": f"{4000.0 * RPM!r}"}, "adrx9": names}, sets={**given, "rpm1": 0.0, "rpm2": 10000.0})
    acts = table(fast)[-1][1] - table(slow)[-1][1]
    out.append(close("turning frame: change of the load of ball 1, that of faster races [N]", table(frame)[-1][1] - table(slow)[-1][1], acts, 0.05))
    return push.command, out


@feature("F335", G)
def _(b):
    # Twice the force at the same overlap: the same force needs 2^(-2/3) of the overlap.
    show = channels("flange.force[3]", "flange.gap[3]")
    out = []
    for sets in ({"mode": 1}, {"mode": 2}, {"qFac": 10.0}):
        a, c = (user(b, f"flange{law}", {"adrx2": {"force": f"{law}*built_in"}, "adrx9": show}, "tapered", sets) for law in (1, 2))
        out += [close(f"{sets}: flange force [N]", table(c)[-1][1], table(a)[-1][1], 0.02),
                close(f"{sets}: overlap, that of the built-in law times", table(c)[-1][2] / table(a)[-1][2], 2 ** (-2 / 3), 0.02)]
    return c.command, out


@feature("F336", G)
def _(b):
    r = user(b, "pocket", {"adrx3": {"force": "1e6*overlap"}, "adrx9": channels(*[f"pocket.{what}[{k}]" for k in range(1, 13) for what in ("force", "gap")])},
             until="0.1rev", opts={"contactDamping": 0, "ballFriction": "spin-rule"})  # balls meet their pockets
    pairs = [(row[k], row[k + 1]) for row in table(r) for k in range(1, 25, 2) if row[k] > 1e-3]
    worst = max((abs(f / (-g * 1e6) - 1.0) for f, g in pairs), default=1.0)
    return r.command, [more("contacts with force", len(pairs), 3), less("force over 1e6 N/m times overlap, worst departure", worst, 1e-6)]


@feature("F337", G)
def _(b):
    sets = {"gravityVecZ": -6000.0}
    runs = [user(b, f"land{k}", {"adrx4": {"force": f"{k}e6*overlap"}, "adrx9": channels("land.force[1]", "land.gap[1]")}, sets=sets, until="0.05rev",
                 opts={"contactDamping": 0}) for k in (1, 2)]
    slopes = []
    for r in runs:
        rows = [row for row in table(r) if row[1] > 0.05]
        slopes.append(sorted(row[1] / -row[2] for row in rows)[len(rows) // 2] if rows else 0.0)
    return runs[1].command, [more("force over overlap [N/m]", slopes[0], 1e6), close("twice the law: force over overlap", slopes[1] / max(slopes[0], 1e-9), 2.0, 0.05)]


@feature("F338", G)
def _(b):
    # A larger roller is the deck's larger roller.
    law = {"adrx5": {"radius": "i == 0 ? 1e-6 : 0"}}
    r = b.static("cylindrical", more=["--user", b.formulas("radius", law)])
    listed = b.static("cylindrical", sets={"kReGeoImp": 2, **{f"reDiaVar{k}": (2e-6 if k == 1 else 0.0) for k in range(1, 41)}})
    two_lobes = b.static("cylindrical", more=["--user", b.formulas("start", {"adrx5": {"radius": "i == 0 ? 1e-6*cos(2*psi) : 0"}})])
    loads = [x.elements["inner load [N]"][0] for x in (r, listed, b.static("cylindrical"), two_lobes)]
    # Two lobes, in balance: a load of the middle roller goes with its radius at the contact, 1e-6 m cos 2(turn of the roller less that of its orbit).
    show = channels("contact.load[1]", "element.rotation[1]", "element.orbital_position[1]")
    place = lambda row: math.cos(2 * (row[2] - row[3]))  # noqa: E731
    z = table(user(b, "place", {"adrx9": channels("race.z[2]")}, "cylindrical", {"mode": 1}, "1e-5s"))[-1][1]
    still = {"mode": 1, "kFS2": 1, "kFS3": 1, "appDispZ": z}
    turned = table(user(b, "lobes", {"adrx5": {"radius": "1e-6*cos(2*psi)"}, "adrx9": show}, "cylindrical", still, "1.5e-3s"))
    big = table(user(b, "even", {"adrx5": {"radius": "1e-6"}, "adrx9": show}, "cylindrical", still, "1.5e-3s"))
    small = table(user(b, "less", {"adrx5": {"radius": "-1e-6"}, "adrx9": show}, "cylindrical", still, "1.5e-3s"))
    at = lambda rows, t: min(rows, key=lambda row: abs(row[0] - t))  # noqa: E731
    worst, spread = 0.0, []
    for row in turned[5:]:
        up, down = at(big, row[0])[1], at(small, row[0])[1]
        share = (row[1] - 0.5 * (up + down)) / (0.5 * (up - down))
        spread.append(share)
        worst = max(worst, abs(share - place(row)))
    # A ball of radius R + a (z^2 - y^2), y and z of the direction in the ball: its load, too, is that of its radius where it touches.
    x0, z0 = table(user(b, "placeball", {"adrx9": channels("race.x[2]", "race.z[2]")}, "ball", {"mode": 1}, "1e-5s"))[-1][1:]
    held = {"mode": 1, "kFS1": 1, "kFS2": 1, "kFS3": 1, "appDispX": x0, "appDispZ": z0}
    shape = "1e-6*(1-(x/0.00635)^2)*cos(2*psi)"
    runs = [b.channels(user(b, f"ball{k}", {"adrx5": {"radius": radius}}, "ball", held, "1.5e-3s", opts={"contactDamping": 0}))
            for k, radius in enumerate((shape, "1e-6", "-1e-6"))]
    times = runs[0]["time"]
    near = lambda c, t, name: c[name][min(range(len(c["time"])), key=lambda k: abs(c["time"][k] - t))]  # noqa: E731
    off, shares = 0.0, []
    for k, t in enumerate(times[5:], 5):
        up, down = (near(c, t, "contact.load.1.2") for c in runs[1:])
        share = (runs[0]["contact.load.1.2"][k] - 0.5 * (up + down)) / (0.5 * (up - down))
        w, x, y, z = (runs[0][f"element.orientation.1.{n}"][k] for n in (1, 2, 3, 4))
        theta, expected = runs[0]["element.orbital_position.1"][k], 0.0
        for race, side in ((1, 1.0), (2, -1.0)):
            alpha = runs[0][f"contact.angle.1.{race}"][k]
            n = [side * math.sin(alpha), -side * math.cos(alpha) * math.sin(theta), side * math.cos(alpha) * math.cos(theta)]
            u_y = 2 * (x * y - w * z) * n[0] + (w * w - x * x + y * y - z * z) * n[1] + 2 * (y * z + w * x) * n[2]
            u_z = 2 * (x * z + w * y) * n[0] + 2 * (y * z - w * x) * n[1] + (w * w - x * x - y * y + z * z) * n[2]
            expected += 0.5 * (u_z * u_z - u_y * u_y)
        shares.append(share)
        off = max(off, abs(share - expected))
    return r.command, [close("load of roller 1, that of a listed deviation [N]", loads[0], loads[1], 1e-6), differs("of an ideal one [N]", loads[2], loads[0], 1e-3),
                       close("two lobes in mode -1, load of roller 1 as that of one whose radius is 1e-6 m larger [N]", loads[3], loads[0], 2e-3),
                       less("load of a roller with two lobes against cos 2(turn), worst departure", worst, 0.1), more("range of that cosine", max(spread) - min(spread), 1.2),
                       less("load of a ball with two lobes against its radius at the contacts, worst departure", off, 0.15),
                       more("range of that load", max(shares) - min(shares), 1.0)]


@feature("F339", G)
def _(b):
    waves = {"kRaceGeoImp2": 2, "rndVar12": 1e-6, "rndVar22": 9.0, "rndVar32": 0.0, "cFacVar12": 0.0, "cFacVar22": 1.0, "cFacVar32": 0.0}
    deck = b.static(sets=waves)
    r = b.static(sets={"kRaceGeoImp2": 3}, more=["--user", b.formulas("waves", {"adrx6": {"inner_race": {"radius": "1e-6*sin(9*psi)"}}})])
    loads = [x.elements["inner load [N]"] for x in (r, deck, b.static())]
    worst = max(abs(a - c) for a, c in zip(loads[0], loads[1])) / max(loads[1])
    acts = max(abs(a - c) for a, c in zip(loads[1], loads[2])) / max(loads[1])
    # Races held: each element for itself. A step, a spall that the ball bridges, curvature across the groove.
    held = {"kFS1": 1, "kFS2": 1, "kFS3": 1, "appDispX": 3e-5}

    def of(name, law, deck="ball", sets=held):
        return b.static(deck, sets={**sets, "kRaceGeoImp2": 3}, more=["--user", b.formulas(name, {"adrx6": {"inner_race": law}})]).elements

    def load(*given, **more_given):
        return of(*given, **more_given)["inner load [N]"]

    ideal, low = load("none", {"radius": "0"}), load("low", {"radius": "-2e-6"})
    step = load("step", {"radius": "psi > 0.3 && psi < 1 ? -2e-6 : 0"})
    D, dm, alpha = 0.0127, 0.060, math.radians(of("none", {"radius": "0"})["inner contact angle [deg]"][1])
    radius = 0.5 * dm - 0.5 * D * math.cos(alpha)
    place = 2 * math.pi / 4096
    first, last = 336, 352  # of the places around that stay: edges of the spall; ball 2 is at pi/6, nearer to the first
    reach = min(math.pi / 6 - first * place, last * place - math.pi / 6) * radius
    sink = 0.5 * reach * reach * (2 / D + math.cos(alpha) / radius)
    spall = load("spall", {"radius": f"psi > {first * place + 1e-9!r} && psi < {last * place - 1e-9!r} ? -50e-6 : 0"})
    even = load("even", {"radius": repr(-sink / math.cos(alpha))})
    across = of("across", {"curvature_factor": "0.004*x/0.005"})
    angle, Q = math.radians(across["inner contact angle [deg]"][1]), across["inner load [N]"][1]
    factor = 0.515 - 0.004 * 0.515 * D * math.sin(angle) / 0.005  # the ball touches a little aside, where the arc is nearest
    peak = lambda f: hertz.ball_on_race(Q, D, dm, f, angle, 2)[2]  # noqa: E731
    rows = [load(f"roller{k}", {"radius": law}, "cylindrical", {"kFS2": 1, "kFS3": 1, "appDispZ": 2e-5})
            for k, law in enumerate(("0", "2e-6", "psi > 5.9 || psi < 0.2 ? 2e-6 : 0"))]
    loaded = max(range(len(rows[0])), key=lambda k: rows[0][k])
    opposite = max((k for k in range(len(rows[0])) if k != loaded), key=lambda k: rows[0][k])
    ledger = user(b, "rolls", {"adrx6": {"inner_race": {"radius": "abs(psi-1) < 0.02 && abs(x) < 0.004 ? -20e-6 : 0"}}},
                  sets={"kRaceGeoImp2": 3}, until="1.5e-3s", opts={"contactDamping": 0}).ledger
    return r.command, [less("loads, departure from the waves of record 5G.2", worst, 1e-6), more("effect of the waves", acts, 1e-3),
                       close("step: load of a ball on it, that of a lower race [N]", step[1], low[1], 1e-4), close("of a ball off it [N]", step[6], ideal[6], 1e-4),
                       differs("the step acts [N]", low[1], ideal[1], 1e-2),
                       close("spall: load of the ball over it, that of a race lower by L^2/8R [N]", spall[1], even[1], 0.02), differs("it acts [N]", spall[1], ideal[1], 0.1),
                       close("curvature across: peak pressure, Hertz at the factor there [Pa]", across["inner pressure [Pa]"][1], peak(factor), 3e-3),
                       differs("Hertz at the nominal factor [Pa]", peak(0.515), peak(factor), 1e-2),
                       close("step under a roller: its load, that of a larger race [N]", rows[2][loaded], rows[1][loaded], 1e-3),
                       differs("it acts [N]", rows[1][loaded], rows[0][loaded], 1e-2),
                       close("of a roller off it [N]", rows[2][opposite], rows[0][opposite], 1e-3),
                       less("running over spalls: energy residual over energy moved", ledger["residual over energy moved"], 1e-4)]


@feature("F340", G)
def _(b):
    # Constant traction k: k Q everywhere, as that of the deck's curve A = B = 0, D = k; from a formula and from a table.
    deck = b.run(sets={"kTracType": -1, "reRaceTC1": -0.05, "reRaceTC2": 0.0, "reRaceTC3": 20.0, "reRaceTC4": 0.05}, until=SHORT, opts={"ballFriction": "spin-rule"})  # all start by the same axis
    r = b.run(sets={"kTrac": -1}, until=SHORT, more=["--user", b.formulas("kappa", {"adrx7": {"element_race": {"formula": "0.05*(1-exp(-20*u))", "slip_scale": "0.05"}}})])
    with open(os.path.join(b.folder, "kappa.csv"), "w", encoding="utf-8") as file:
        file.write("".join(f"{u!r},{0.05 * (1 - math.exp(-20 * u))!r}\n" for u in [0.002 * k for k in range(500)]))
    t = b.run(sets={"kTrac": -1}, until=SHORT, more=["--user", b.formulas("kappatable", {"adrx7": {"element_race": {"table": "kappa.csv", "slip_scale": "0.05"}}})])
    heats = [x.ledger["heat, inner race contacts [J]"] for x in (r, t, deck, b.run(until=SHORT))]
    return r.command, [close("heat of the formula, that of A, B, C, D [J]", heats[0], heats[2], 1e-5), close("heat of the table [J]", heats[1], heats[2], 1e-2),
                       differs("of another curve [J]", heats[3], heats[2], 1e-2)]


@feature("F341", G)
def _(b):
    r = b.static(sets={"kReGeoImp": 3}, more=["--user", b.formulas("size", {"adrx8": {"diameter": "i == 2 ? 2e-6 : 0"}})])
    listed = b.static(sets={"kReGeoImp": 2, **{f"reDiaVar{k}": (2e-6 if k == 3 else 0.0) for k in range(1, 41)}})
    loads = [x.elements["inner load [N]"][2] for x in (r, listed, b.static())]
    return r.command, [close("load of ball 3, that of a listed deviation [N]", loads[0], loads[1], 1e-9), differs("of an ideal one [N]", loads[2], loads[0], 1e-3)]


@feature("F342", G)
def _(b):
    # Channels of RESULTS.h5 in SOL9, by formulas and by C: the same numbers.
    names = ["contact.load[3]", "element.orbital_velocity[2]", "race.applied_force_z[2]", "pocket.gap[5]", "power.loss[1]", "contact.film[1]"]
    r = user(b, "channels", {"adrx9": channels(*names)}, until="0.05rev")
    code = ("int32_t adrx9(adore_adrx9* a) { if (a->call.mode == ADORE_READ) a->call.active = 1; if (a->call.mode == ADORE_START) a->wants_channels = 1;"
            " if (a->call.mode == ADORE_STEP) for (int64_t k = 0; k < a->channels; ++k) { const char* n = a->channel_name[k]; int same = 1; const char* w = \"contact.load\";"
            " for (int i = 0; same && i < 13; ++i) same = n[i] == w[i]; if (!same) continue; char t[99]; snprintf(t, 99, \"%.17g %.17g\\n\", a->call.time,"
            " a->channel_value[a->channel_first[k] + 2]); a->call.services->write(a->call.host, t); } return 0; }\n")
    c = b.run(until="0.05rev", more=["--user", b.plug_in("adrx9_channels", code)])
    stored, rows, by_c = b.channels(r), table(r), table(c)
    last = rows[-1]
    columns = ["contact.load.2.1", "element.orbital_velocity.2", "race.applied_force_z.2", "pocket.gap.5", "power.loss"]
    found = [next((n for n in (name, name + ".1") if n in stored), None) for name in columns]
    if None in found:
        raise Failed("columns: " + ", ".join(list(stored)[:400]))
    return r.command, [close(f"{name} at the last step, SOL9 and RESULTS.h5", value, stored[name][-1], 1e-9, 1e-12) for name, value in zip(found, last[1:])] + [
        equal("steps by C and by formulas", len(by_c), len(rows)), equal("contact.load[3] by C", by_c[-1][1], last[1]), more("it changes", len({row[1] for row in rows}), 3)]


@feature("F343", G)
def _(b):
    code = ("static long n[5], wrong; static double last = -1; int32_t adrx1(adore_adrx1* a) { int m = a->call.mode; if (m == -1) a->call.active = 1; if (m == 1 && n[1] == 0) wrong++;"
            " if (m == 0 && n[0] == 0) wrong++; if (m == 3 && a->call.time < last) wrong++; if (m == 3) last = a->call.time; n[m + 1]++; if (m == 2) { char t[200];"
            " snprintf(t, 200, \"calls %ld %ld %ld %ld %ld wrong %ld\", n[0], n[1], n[2], n[3], n[4], wrong); a->call.services->print(a->call.host, t); } return 0; }\n"
            "int32_t adrx9(adore_adrx9* a) { (void)a; return a->call.mode == -1 ? 0 : 7; }\n")
    r = b.run(until="0.3rev", more=["--user", b.plug_in("modes", code)])
    n = [int(float(v)) for v in [line for line in r.listing.splitlines() if "ADRX1: calls " in line][-1].split("calls ")[1].replace("wrong ", "").split()]
    return r.command, [equal("calls in modes -1 and 0", n[:2], [1, 1]), more("in mode 1", n[2], n[4]), more("in mode 2, print pages", n[3], 1), between("in mode 3, counted steps", n[4], r.json["steps"] - 1, r.json["steps"] + 1),
                       equal("calls out of order", n[5], 0)]


def example(b, hook):
    folder = os.path.join(b.folder, "example_" + hook)
    if not os.path.isdir(folder):
        b.call("user", "new", hook, "--lang", "c", "--out", folder)
        subprocess.run(["make", "-C", folder], check=True, capture_output=True)
    return os.path.join(folder, f"lib{hook}.so")


@feature("F344", G)
def _(b):
    r = b.run(until="5e-4s", tail="1e-4 4e-4 10000 10300\n0 0\n", more=["--user", example(b, "adrx1")])
    c = b.channels(r)
    first, last = 10000 * RPM, 10300 * RPM
    return r.command, [close("speed at the end [rad/s]", c["race.angular_velocity.2"][-1], last, 2e-5),
                       close("turn at the end [rad]", c["race.rotation.2"][-1], first * 1e-4 + 0.5 * (first + last) * 3e-4 + last * 1e-4, 4e-5)]


@feature("F345", G)
def _(b):
    amplitude, frequency = 2e-6, 2000.0
    r = b.run(until="6e-4s", tail=f"0 0 0 0\n{amplitude} {frequency}\n", more=["--user", example(b, "adrx1")])
    c = b.channels(r)
    z = next(c[n] for n in ("race.z.1", "race.z.outer") if n in c)
    t = c["time"]
    worst = max(abs(v - amplitude * math.sin(2 * math.pi * frequency * s)) for v, s in zip(z, t))
    return r.command, [less("departure of the housing from A sin wt [m]", worst, 1e-4 * amplitude), more("its largest place [m]", max(z), 0.9 * amplitude)]


@feature("F346", G)
def _(b):
    out = []
    for deck, kinds in (("ball", (0, 1, 2)), ("tapered", (0, 1, 2, 3))):
        r = user(b, "heat", {"adrx9": {"heat_map": True}}, deck, {"gravityVecZ": -3000.0}, "0.05rev")
        rows = table(r)
        placed = {k: [row for row in rows if int(row[1]) == k] for k in kinds}
        last = rows[-1][0]
        loss = r.sol("SOL7").column(1)[-1]
        total = sum(row[9] for row in rows if row[0] == last)
        out += [close(f"{deck}: sum of the sources at the last step, SOL7 value 1 [W]", total, loss, 1e-4)]
        c = b.channels(r)
        of_races = sum(v[-1] for k, v in c.items() if k.startswith(("contact.heat.", "contact.rolling_heat.", "contact.damping_heat.")))
        at_races = sum(row[9] for row in placed[0] if row[0] == last)
        out.append(close(f"{deck}: sources at the races, friction, rolling resistance and damping of RESULTS.h5 [W]", at_races, of_races, 1e-4))
        for k in kinds[1:]:
            if not placed[k]:
                continue
            out.append(equal(f"{deck}: sources of kind {k} at the origin", sum(math.hypot(row[5], row[6]) < 1e-4 for row in placed[k]), 0))
        out.append(more(f"{deck}: heat of pockets, lands and flanges with places [W s]", sum(abs(row[9]) for k in kinds[1:] for row in placed[k]), 0.0))
    return r.command, out


@feature("F347", G)
def _(b):
    code = 'const char* adore_user_version(void) { return "lot 7"; }\nint32_t adrx9(adore_adrx9* a) { if (a->call.mode == ADORE_READ) a->call.active = 1; return 0; }\n'
    r = b.run(until="1e-5s", more=["--user", b.plug_in("version", code)])
    many = b.static(sets={"nRe": 60, "bReDia": 0.002})
    return r.command, [equal("files with the version", sum("lot 7" in r.read(n) for n in ("PRINT.txt", "FINAL", "MASTER", "RUN.json", "SOL1", "SOL7")), 6),
                       equal("60 balls: rows of the elements", len(many.elements["azimuth [deg]"]), 60)]
