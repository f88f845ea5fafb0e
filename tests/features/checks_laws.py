"""Traction, lubricants, films, churning, power and wear (F165 to F218)."""

import math

from bench import between, close, differs, equal, feature, less, more, not_checked

G = "laws"
T350 = {t: 350.0 for t in ("hsngTemp", "shftTemp", "raceTemp1", "raceTemp2", "reTemp", "cageTemp")}
SHORT = "0.02rev"
WEAK = {"reCageTC2": 0.0}


def heat(b, run, part="outer race contacts"):
    return run.ledger[f"heat, {part} [J]"]


def four_conditions(k0, km, kinf, um):
    """A, B, C, D of k = (A + B u) exp(-C u) + D, by bisection of km - kinf = A exp(-x) / (1 - x)."""
    a, d = k0 - kinf, kinf
    low, high = (1.0 + 1e-12, 60.0) if a < 0 else (1e-12, 1.0 - 1e-12)
    for _ in range(300):
        x = 0.5 * (low + high)
        value = a * math.exp(-x) / (1.0 - x) - (km - kinf)
        if (value > 0) == (a < 0):
            low = x
        else:
            high = x
    c = x / um
    return a, c * a / (1.0 - x), c, d


def same_run(b, deck, first, second, part, third=None, until=SHORT):
    x, y = b.run(deck, sets=first, until=until), b.run(deck, sets=second, until=until)
    out = [close(f"heat of the {part}, the same curve by A, B, C, D [J]", heat(b, x, part), heat(b, y, part), 1e-6)]
    if third:
        z = b.run(deck, sets=third, until=until)
        out.append(differs("another curve [J]", heat(b, z, part), heat(b, x, part), 1e-3))
    return x, out


A, B, C, D = four_conditions(0.0, 0.06, 0.04, 0.5)
RULE = {"ballFriction": "spin-rule"}  # by the same axis, whatever the law; impacts of the first turn
DIRECT = {"kTracType": -1, "reRaceTC1": A, "reRaceTC2": B, "reRaceTC3": C, "reRaceTC4": D}


@feature("F165", G)
def _(b):
    r, out = same_run(b, "ball", DIRECT, {}, "inner race contacts", {**DIRECT, "reRaceTC4": D + 0.01})
    r2 = b.run(sets={"kTracType": -1, "reRaceTC1": 0.0, "reRaceTC2": 0.0, "reRaceTC3": 1.0, "reRaceTC4": 0.05}, until=SHORT)
    return r.command, out + [more("constant k = 0.05: heat at the inner races [J]", heat(b, r2, "inner race contacts"), 0.0)]


def user_curve(b, kind, formula, name):
    return b.formulas(name, {"version": "curve", "adrx7": {kind: {"formula": formula, "slip_scale": "0.1"}}})


@feature("F166", G)
def _(b):
    two = {"kTracType": 0, "reRaceTC1": 0.0, "reRaceTC2": 0.3, "reRaceTC3": 0.0002, "reRaceTC4": 0.2}
    rule = {"ballFriction": "spin-rule"}  # one start for both: statics do not call ADRX7
    r = b.run(sets=two, until=SHORT, opts=rule)
    law = user_curve(b, "element_race", "(u < 0.2) ? 0.3*u : 0.06 + 0.0002*(u-0.2)", "two")
    same = b.run(sets={"kTrac": -1}, until=SHORT, opts=rule, more=["--user", law])
    other, steep = (b.run(sets={**two, **x}, until=SHORT, opts=rule) for x in ({"reRaceTC4": 0.1}, {"reRaceTC3": 0.05}))
    return r.command, [differs("heat with a second slope of 0.05 s/m [J]", heat(b, steep, "inner race contacts"), heat(b, r, "inner race contacts"), 1e-3),
                       close("heat at the inner races, that of the same curve by ADRX7 [J]", heat(b, r, "inner race contacts"), heat(b, same, "inner race contacts"), 0.02),
                       differs("with the kink at 0.1 m/s [J]", heat(b, other, "inner race contacts"), heat(b, r, "inner race contacts"), 1e-2)]


@feature("F167", G)
def _(b):
    r, out = same_run(b, "ball", {}, DIRECT, "inner race contacts", {"reRaceTC2": 0.07})
    block = b.run(until="0.3rev").listing.split("Rolling element to race: k =", 1)[1].splitlines()
    listed = [float(next(x for x in block if x.split()[:1] == [n]).split()[1]) for n in "ABCD"]
    top = max((A + B * u) * math.exp(-C * u) + D for u in [0.001 * k for k in range(1, 3000)])
    return r.command, out + [close("B of PRINT.txt [s/m]", listed[1], B, 1e-6), close("largest k of the curve", top, 0.06, 1e-6)]


@feature("F168", G)
def _(b):
    curve = {"kTracType": 2, "reRaceTC1": 0.0, "reRaceTC2": 0.05, "reRaceTC3": 0.4, "reRaceTC4": 0.0}
    same = {"kTracType": -1, "reRaceTC1": -0.05, "reRaceTC2": 0.0, "reRaceTC3": 8.0, "reRaceTC4": 0.05}
    r, out = same_run(b, "ball", curve, same, "inner race contacts", {**curve, "reRaceTC3": 0.8})
    return r.command, out


def four_kinds(b, deck, kind, names, part, until=SHORT, extra=None):
    """Types 1 and 2 against their A, B, C, D; type 0 against a slope that never ends; each changes with its values."""
    extra = extra or {}
    n = lambda *v: {**extra, **dict(zip(names, v))}  # noqa: E731
    a, bb, c, d = four_conditions(0.0, 0.09, 0.05, 0.3)
    direct = b.run(deck, sets={kind: -1, **n(a, bb, c, d)}, until=until)
    four = b.run(deck, sets={kind: 1, **n(0.0, 0.09, 0.05, 0.3)}, until=until)
    asym = b.run(deck, sets={kind: 2, **n(0.0, 0.08, 0.8, 0.0)}, until=until)
    asym2 = b.run(deck, sets={kind: -1, **n(-0.08, 0.0, 10.0, 0.08)}, until=until)
    slope = b.run(deck, sets={kind: 0, **n(0.0, 0.01, 0.01, 1.0)}, until=until)
    slope2 = b.run(deck, sets={kind: 0, **n(0.0, 0.02, 0.02, 1.0)}, until=until)
    h = [heat(b, r, part) for r in (direct, four, asym, asym2, slope, slope2)]
    return four.command, [close(f"heat of the {part}: four conditions, that of A, B, C, D [J]", h[1], h[0], 1e-6, 1e-15),
                          close("asymptote, that of A, B, C, D [J]", h[2], h[3], 1e-6, 1e-15),
                          between("slope of 0.02 over slope of 0.01 s/m", h[5] / h[4] if h[4] else 0.0, 1.5, 2.3), differs("asymptote against four conditions [J]", h[2], h[1], 1e-3)]


@feature("F169", G)
def _(b):
    return four_kinds(b, "tapered", "kRFTracType", ["reFlngTC1", "reFlngTC2", "reFlngTC3", "reFlngTC4"], "inner race flanges")


@feature("F170", G)
def _(b):
    return four_kinds(b, "ball", "kCPTracType", ["reCageTC1", "reCageTC2", "reCageTC3", "reCageTC4"], "cage pockets", extra={"avRatio": 1.2})


@feature("F171", G)
def _(b):
    return four_kinds(b, "ball", "kCRTracType", ["cageRaceTC1", "cageRaceTC2", "cageRaceTC3", "cageRaceTC4"], "guide lands", until="0.05rev",
                      extra={"gravityVecZ": -6000.0})


@feature("F172", G)
def _(b):
    bare = {"nCseg": 0, "kNumPltElem": 1, "kPltElemInd": 1, "appLoadX": 300.0, "appLoadZ": 1500.0, "gravityVecZ": -2000.0, "nRe": 14}
    names = ["reReTC1", "reReTC2", "reReTC3", "reReTC4"]

    def last(kind, *v):
        r = b.run(sets={**bare, "kRRTracType": kind, **dict(zip(names, v))}, until="1rev")
        c = b.channels(r)
        return r, sum(c[f"element.angular_velocity.{k}"][-1] for k in range(1, 15))

    a, bb, c, d = four_conditions(0.0, 0.09, 0.05, 0.3)
    r, four = last(1, 0.0, 0.09, 0.05, 0.3)
    direct = last(-1, a, bb, c, d)[1]
    asym, asym2 = last(2, 0.0, 0.08, 0.8, 0.0)[1], last(-1, -0.08, 0.0, 10.0, 0.08)[1]
    none, slope = last(-1, 0.0, 0.0, 1.0, 0.0)[1], last(0, 0.0, 0.01, 0.01, 1.0)[1]
    return r.command, [close("sum of the balls' speeds: four conditions, A, B, C, D [rad/s]", four, direct, 1e-7),
                       close("asymptote, A, B, C, D [rad/s]", asym, asym2, 1e-7), differs("without friction between balls [rad/s]", none, four, 1e-7),
                       differs("slope 0.01 s/m against none [rad/s]", slope, none, 1e-8)]


@feature("F173", G)
def _(b):
    out, command = [], ""
    for flag, kind, deck, part, extra, until in (
            ("kTrac", "element_race", "ball", "inner race contacts", {}, SHORT), ("kCPTrac", "element_cage", "ball", "cage pockets", {"avRatio": 1.2}, SHORT),
            ("kCRTrac", "cage_race", "ball", "guide lands", {"gravityVecZ": -6000.0}, "0.05rev"),
            ("kRFTrac", "roller_flange", "tapered", "inner race flanges", {}, SHORT)):
        h = []
        for size in (0.03, 0.06):
            r = b.run(deck, sets={**extra, flag: -1}, until=until, more=["--user", user_curve(b, kind, f"{size}*tanh(u/0.02)", f"{kind}{size}")])
            h.append(heat(b, r, part))
            command = r.command
        out.append(between(f"{kind}: heat of twice the coefficient over that before", h[1] / h[0], 1.6, 2.3))
    bare = {"nCseg": 0, "kNumPltElem": 1, "kPltElemInd": 1, "appLoadX": 300.0, "appLoadZ": 1500.0, "gravityVecZ": -2000.0, "nRe": 14}
    speeds = []
    for size in (0.0001, 0.1):
        r = b.run(sets={**bare, "kRRTrac": -1}, until="1rev", more=["--user", user_curve(b, "element_element", f"{size}*tanh(u/0.02)", f"rr{size}")])
        c = b.channels(r)
        speeds.append(sum(c[f"element.angular_velocity.{k}"][-1] for k in range(1, 15)))
    out.append(differs("element_element: sum of the balls' speeds with 0.1 and 0.0001 [rad/s]", speeds[1], speeds[0], 1e-7))
    return command, out


def oil(code, **sets):
    return {"kTrac": code, "reRaceFilm": 1e-9, "strParam": 10.0, **T350, **sets}


def lubricated(b, code, **sets):
    return b.run(sets=oil(code, **sets), until="0.01rev")


def law(b, code, **inputs):
    import json
    slips = [0.001, 0.01, 0.05, 0.1, 0.3, 1.0]
    done = b.call("calc", "traction", given=json.dumps({"kind": "lubricated_point", "inputs": {"kTrac": code, "T": 350.0, "slip": slips, **inputs}}))
    out = json.loads(done.stdout)
    return out.get("results", out)


def film(b, run, first=False):
    c = b.channels(run)
    t = 0 if first else len(c["time"]) // 2
    return c["contact.film.1.2"][t]


def slow(b, code, **sets):
    """At 100 rpm the inlet is hardly heated; the first step will do."""
    return b.run(sets=oil(code, **{"rpm2": 100.0, **sets}), until="0.0001rev")


def hamrock_dowson(mu, alpha, u, rx, load, k, modulus=2.26e11):
    return 2.69 * rx * (mu * u / modulus / rx)**0.67 * (alpha * modulus)**0.53 * (load / modulus / rx**2)**-0.067 * (1 - 0.61 * math.exp(-0.73 * k))


# Dynamic viscosity at 100 C [mPa s]: grade or kinematic viscosity of the product times its density there (recalled, medium).
VISCOSITY = {1: (7.0, 10.0), 2: (12.0, 17.0), 3: (2.4, 3.6), 4: (4.0, 5.6), 5: (4.0, 5.6), 6: (1.8, 3.5), 7: (4.0, 5.6), 8: (2.4, 3.6), 10: (4.0, 5.6), 11: (4.0, 5.6), 12: (4.0, 5.6),
             13: (72.0, 90.0), 14: (72.0, 90.0), 15: (430.0, 560.0), 16: (430.0, 560.0), 17: (450.0, 600.0), 18: (1.4, 2.6), 19: (7.5, 10.0), 20: (4.5, 8.0)}


def lubricant(identifier, code):
    @feature(identifier, "lubricants")
    def _(b):
        r, mine, base = lubricated(b, code), law(b, code), law(b, 4)
        ratio = film(b, slow(b, code), True) / film(b, slow(b, 4), True)
        wanted = (mine["mu"] / base["mu"])**0.67 * (mine["alpha"] / base["alpha"])**0.53
        kappa = [abs(v) for v in mine["kappa"]]
        h = r.ledger["heat, inner race contacts [J]"]
        out = [between("viscosity at 100 C, product data [mPa s]", 1e3 * law(b, code, T=373.15)["mu"], *VISCOSITY[code]),
               close("film over that of kTrac 4, by viscosity and pressure coefficient (Hamrock and Dowson)", ratio, wanted, 0.04),
               between("largest traction coefficient at 1.2 GPa", max(kappa), 0.005, 0.13), more("traction rises with slip: k(0.05) / k(0.001)", kappa[2] / kappa[0], 1.2),
               more("heat at the inner races [J]", h, 0.0)]
        warm = slow(b, code, **{t: 380.0 for t in T350})
        out.append(less("film at 380 K over that at 350 K, 100 rpm", film(b, warm, True) / film(b, slow(b, code), True), 0.85))
        return r.command, out


for number, identifier in ((1, "F184"), (2, "F185"), (3, "F186"), (4, "F187"), (5, "F188"), (6, "F189"), (7, "F190"), (8, "F191"), (10, "F193"), (11, "F194"),
                           (12, "F195"), (13, "F196"), (14, "F197"), (15, "F198"), (16, "F199"), (17, "F200"), (18, "F201"), (19, "F202"), (20, "F203")):
    lubricant(identifier, number)


@feature("F174", "lubricants")
def _(b):
    k = law(b, 4)["kappa"]
    hot = law(b, 4, T=390.0)["kappa"]
    r, fast = lubricated(b, 4), lubricated(b, 1)
    return r.command, [less("Newtonian film heated by its own shear: k(1.0) / k(0.3), below the isothermal ratio", abs(k[5] / k[4]), 3.3),
                       more("k(0.01) / k(0.001), linear at small slip", abs(k[1] / k[0]), 5.0), less("traction 40 K hotter over that before", abs(hot[2] / k[2]), 1.0),
                       differs("heat of the other viscosity law, code 1 [J]", fast.ledger["heat, inner race contacts [J]"], r.ledger["heat, inner race contacts [J]"], 1e-3)]


@feature("F175", "lubricants")
def _(b):
    k8, k12 = law(b, 8)["kappa"], law(b, 12)["kappa"]
    r = lubricated(b, 8)
    return r.command, [less("kTrac 8: k(1.0) / k(0.1), limited by the critical stress", abs(k8[5] / k8[3]), 3.0), less("kTrac 12: k(1.0) / k(0.1)", abs(k12[5] / k12[3]), 3.0),
                       more("kTrac 8: k(0.01) / k(0.001)", abs(k8[1] / k8[0]), 3.0), more("heat of the run [J]", r.ledger["heat, inner race contacts [J]"], 0.0)]


@feature("F176", "lubricants")
def _(b):
    thin, newton = law(b, 11)["kappa"], law(b, 10)["kappa"]
    r, n = lubricated(b, 11), lubricated(b, 10)
    return r.command, [less("shear-thinning over Newtonian traction of the same oil (11 and 10) at 0.3 m/s", abs(thin[4] / newton[4]), 1.0001),
                       differs("heat of the runs [J]", r.ledger["heat, inner race contacts [J]"], n.ledger["heat, inner race contacts [J]"], 1e-4)]


@feature("F177", "lubricants")
def _(b):
    def heat_of(**sets):
        r = b.static(sets={**oil(4), **sets}, opts=RULE)
        f = r.table("friction")
        return r, [f[n][0] for n in ("sliding of the curved contact, outer race [W]", "spin, inner race [W]")]

    dry = b.static(sets=T350, opts=RULE).table("friction")
    dry = [dry[n][0] for n in ("sliding of the curved contact, outer race [W]", "spin, inner race [W]")]
    thick, both = heat_of(reRaceFilm=1e-3)
    thin, none = heat_of(reRaceFilm=1e-9)
    # least films of 0.32 um at the outer race, 0.27 um at the inner one
    outer, inner = thin.elements["outer least film [m]"], thin.elements["inner least film [m]"]
    _, one = heat_of(reRaceFilm=0.5 * (min(outer) + max(inner)))
    _, other = heat_of(reRaceFilm=1e-3, kTrac=6)
    return thick.command, [close(f"critical film of 1 mm, {n}: heat of the hypothetical curve [W]", p, q, 2e-3) for n, p, q in zip(("outer race", "inner race"), both, dry)] + [
        close("another lubricant under its critical film: heat at the inner race [W]", other[1], dry[1], 2e-3), more("smallest outer film over the largest inner one", min(outer) / max(inner), 1.05),
        close("critical film between both: inner race by the curve [W]", one[1], dry[1], 2e-3), close("outer race by the film [W]", one[0], none[0], 2e-3),
        less("heat at the inner race by the film over that by the curve", none[1] / dry[1], 0.5)]


@feature("F178", "lubricants")
def _(b):
    def start(**sets):
        c = b.channels(b.run(sets=oil(4, **sets), until="0.0001rev"))
        return c, c["contact.film.1.2"][0]

    c, full = start(strParam=10.0)
    half, angle = c["contact.half_minor.1.2"][0], c["contact.angle.1.2"][0]
    radius = 0.00635 * (1 - 0.0127 * math.cos(angle) / 0.06)
    out = []
    for m in (1.01, 1.5, 3.0):
        # Wolveridge, Baglin and Archard: starved over flooded film by the distance of the meniscus
        psi = m * (half**2 / (2 * radius * full))**(2 / 3)
        factor = 1 - math.exp(-1.68005 * psi**0.8315 + 0.260137 * psi**1.558 - 0.016146 * psi**2.296)
        out.append(close(f"meniscus at {m} half widths: film over the flooded one (Wolveridge, Baglin and Archard)", start(strParam=m)[1] / full, factor, 0.02))
    above, below = (b.static(sets=oil(4, reRaceFilm=v), opts=RULE).table("friction")["spin, inner race [W]"][0] for v in (0.25e-6, 0.4e-6))
    return "adore run ball.txt --set kTrac=4 --set strParam=1.01 --until 0.0001rev", out + [
        more("spin heat at the inner race with a critical film above its 0.32 um over that with one below it", below / above, 2.0)]


@feature("F179", "lubricants")
def _(b):
    import json
    q = json.loads(b.call("calc", "film", given=json.dumps({"kind": "hamrock_dowson_hard_ehl", "inputs": {"formula": "hamrockDowson", "mu0": 0.0116, "alpha": 1.1765e-8, "u": 12.0,
                  "Eprime": 226373626374.0, "Rx": 0.0051, "load": 450.0, "k": 7.8}})).stdout)
    q = q.get("results", q)
    r = lubricated(b, 4)
    c = b.channels(r)
    t = len(c["time"]) // 2
    data = law(b, 4)
    u = 0.5 * 0.0265 * (10000 - 4080) * math.pi / 30 * 2  # both surfaces in the contact's frame
    gamma = 0.0127 * math.cos(c["contact.angle.1.2"][t]) / 0.06
    k = c["contact.half_major.1.2"][t] / c["contact.half_minor.1.2"][t]
    u = 0.5 * (0.06 - 0.0127 * math.cos(c["contact.angle.1.2"][t])) * (10000 - 4080) * math.pi / 30
    h = hamrock_dowson(data["mu"], data["alpha"], u, 0.00635 * (1 - gamma), c["contact.load.1.2"][t], k)
    roller = b.run("cylindrical", sets=oil(4), until="0.01rev")
    fast = b.run("cylindrical", sets=oil(4, rpm2=3000.0), until="0.005rev")
    ratio = film(b, fast) / film(b, roller)
    return r.command, [close("central film of the calculator (Hamrock and Dowson) [m]", q["hCentral"], hamrock_dowson(0.0116, 1.1765e-8, 12.0, 0.0051, 450.0, 7.8, 226373626374.0), 2e-3),
                       between("film of the run over the isothermal flooded formula: thermal reduction", film(b, r) / h, 0.5, 1.05),
                       between("line contact: film at half speed over that at full (u^0.7, less heated)", ratio, 0.55, 0.75)]


USER = {"refTemp": 350.0, "refVis": 0.01, "prVisCoeff": 1.5e-8, "tempVisCoeff": 4000.0, "lubTherCond": 0.14, "lubDen": 900.0, "lubSpHeat": 2000.0, "refTracVis": 0.01,
        "tracVisCoeff1": 1.2e-8, "tracVisCoeff2": 0.03, "lubName": "'own oil'"}


def own(b, **sets):
    values = {**oil(9), **USER, **sets}
    return b.run(sets={k: v for k, v in values.items() if k != "lubName"}, until="0.01rev")


@feature("F180", "lubricants")
def _(b):
    r = own(b)
    f = film(b, r)
    h = r.ledger["heat, inner race contacts [J]"]
    return r.command, [between("film with twice the viscosity over that before: 2^0.67 less heating", film(b, own(b, refVis=0.02)) / f, 1.35, 1.65),
                       between("film with twice the pressure coefficient: 2^0.53", film(b, own(b, prVisCoeff=3e-8)) / f, 1.3, 1.5),
                       between("film 10 K hotter: exp(4000 (1/360 - 1/350))^0.67", film(b, own(b, **{t: 360.0 for t in T350})) / f, 0.75, 0.86),
                       differs("heat with another traction viscosity [J]", own(b, refTracVis=0.001).ledger["heat, inner race contacts [J]"], h, 5e-3),
                       differs("with another pressure coefficient of it [J]", own(b, tracVisCoeff1=6e-9).ledger["heat, inner race contacts [J]"], h, 1e-2),
                       differs("with another temperature coefficient of it [J]", own(b, tracVisCoeff2=0.06).ledger["heat, inner race contacts [J]"], h, 1e-4),
                       differs("with another conductivity [J]", own(b, lubTherCond=0.5).ledger["heat, inner race contacts [J]"], h, 1e-4)]


@feature("F181", "lubricants")
def _(b):
    off, on = lubricated(b, 12), lubricated(b, 12, iTherm=1)
    four, four_on = lubricated(b, 4), lubricated(b, 4, iTherm=1)
    h = [r.ledger["heat, inner race contacts [J]"] for r in (off, on, four, four_on)]
    return on.command, [less("heat at the inner races with the correction over that without", h[1] / h[0], 1.0), equal("no effect on kTrac 4 [J]", h[3], h[2])]


def first_heat(b, sets, more=()):
    c = b.channels(b.run(sets=sets, until="0.0001rev", more=list(more), opts=RULE))
    return [c[f"contact.heat.1.{race}"][0] for race in (1, 2)]


@feature("F182", "lubricants")
def _(b):
    out, command = [], ""
    for name, formula, sets in (("asymptote", "0.05*(1-exp(-8*u))", {"kTracType": 2, "reRaceTC1": 0.0, "reRaceTC2": 0.05, "reRaceTC3": 0.4, "reRaceTC4": 0.0}),
                                ("slope", "0.01*u", {"kTracType": 0, "reRaceTC1": 0.0, "reRaceTC2": 0.01, "reRaceTC3": 0.01, "reRaceTC4": 1.0})):
        law_ = user_curve(b, "element_race", formula, f"same-{name}")
        mine, built = first_heat(b, {"kTrac": -1}, ["--user", law_]), first_heat(b, sets)
        command = b.run(sets={"kTrac": -1}, until="0.0001rev", more=["--user", law_]).command
        out += [close(f"k = {formula}: heat of ball 1 at race {race}, that of the deck's curve of type {sets['kTracType']} [W]", p, q, 0.01) for race, p, q in zip((1, 2), mine, built)]
    return command, out + [differs("heat by the second law, that by the first, inner race [W]", mine[1], first_heat(b, {"kTrac": -1}, ["--user", user_curve(b, "element_race", "0.05*(1-exp(-8*u))", "same-asymptote")])[1], 0.1)]


@feature("F183", "lubricants")
def _(b):
    import hertz
    constant = {"kTrac": 0, "kTracType": -1, "reRaceTC1": 0.0, "reRaceTC2": 0.0, "reRaceTC3": 1.0, "reRaceTC4": 0.05}
    r = b.static(sets=constant, opts=RULE)
    e, out = r.elements, []
    for k in (0, 6):
        q, a, ao = e["inner load [N]"][k], math.radians(e["inner contact angle [deg]"][k]), math.radians(e["outer contact angle [deg]"][k])
        half, small, _, _ = hertz.ball_on_race(q, 0.0127, 0.06, 0.515, a, 2)
        moment = 0.375 * 0.05 * q * half * hertz.elliptic(1 - (small / half)**2)[1]  # spin of an ellipse with constant friction: 3/8 k Q a E
        orbit = 10000 * (1 - 0.0127 / 0.0600104 * math.cos(a)) / (1 + math.cos(a - ao))
        spin = e["inner spin to roll [-]"][k] * (10000 - orbit) * math.pi / 30 * 0.0600104 / 0.0127
        out.append(close(f"k = 0.05: spin heat of ball {k + 1}, 3/8 k Q a E ws [W]", e["inner spin heat [W]"][k], moment * spin, 2e-3))
    curve, half_curve = b.static(opts=RULE), b.static(sets={"reRaceTC2": 0.03, "reRaceTC3": 0.02}, opts=RULE)
    return r.command, out + [close("half the curve of record 10.1C over the curve, spin heat", half_curve.table("friction")["spin, inner race [W]"][0] / curve.table("friction")["spin, inner race [W]"][0], 0.5, 1e-6)]


def own_limited(b, **opts):
    return b.run(sets={k: v for k, v in {**oil(9), **USER}.items() if k != "lubName"}, opts=opts, until="0.01rev")


def friction_coefficient(b, run):
    """Largest mean coefficient of the inner contacts: heat over load times slip."""
    c = b.channels(run)
    t = len(c["time"]) // 2
    return max(c[f"contact.heat.{k}.2"][t] / c[f"contact.load_slip.{k}.2"][t] for k in range(1, 13))


@feature("F192", "lubricants")
def _(b):
    r = own(b)
    high = own(b, prVisCoeff=2.5e-8)
    low, middle, constant, off = [own_limited(b, **o) for o in ({"lubStressLimit": 0.02}, {"lubStressLimit": 0.05},
                                                                 {"lubStressLimit": 0.02, "lubStressSoftening": 0.0}, {"filmStressLimit": "off"})]
    limit = 0.02 * math.exp(-0.003 * (350.0 - 313.15))  # of the pressure, at walls of 350 K
    mu = friction_coefficient(b, low)
    return low.command, [more("film with a pressure coefficient of 25 over 15 1/GPa", film(b, high) / film(b, r), 1.1),
                         between("lubStressLimit 0.02: largest coefficient over the limit at 350 K", mu / limit, 0.85, 1.0),
                         between("without softening, over 0.02", friction_coefficient(b, constant) / 0.02, 0.85, 1.0),
                         more("lubStressLimit 0.05: coefficient over that with 0.02", friction_coefficient(b, middle) / mu, 1.9),
                         more("without a limit: coefficient", friction_coefficient(b, off), 0.18),
                         equal("register of validity: coefficient outside, without a limit and with one",
                               [any(v["range"] == "traction.coefficient" for v in x.json["outside_validity"]) for x in (off, low)], [True, False]),
                         equal("a limit that is not given is noted as assumed", [f["code"] for f in r.json["findings"]].count("film.stress_limit_assumed"), 1),
                         equal("a given one is not", [f["code"] for f in low.json["findings"]].count("film.stress_limit_assumed"), 0)]


HYDRO = {"pocVis": 0.02, "gsVis": 0.02}


@feature("F204", G)
def _(b):
    r = b.run(sets={"kPocHydro": 1, **HYDRO}, until="0.1rev", opts=RULE)
    c = b.channels(r)
    thick = b.run(sets={"kPocHydro": 1, "pocVis": 0.04, "gsVis": 0.02}, until="0.1rev", opts=RULE)
    dry = b.run(until="0.1rev", opts=RULE)
    film_of = [k for k in r.ledger if "pocket" in k and "film" in k]
    return r.command, [equal("pocket films in the plan", [e["on"] for e in r.json["plan"]["effects"] if e["name"] == "pocket films"][0], True),
                       more("heat of the films [J]", sum(r.ledger[k] for k in film_of), 0.0), differs("cage speed with twice the viscosity [rad/s]",
                       b.channels(thick)["cage.angular_velocity.1.1"][-1], c["cage.angular_velocity.1.1"][-1], 1e-7),
                       less("energy residual over energy moved", r.ledger["residual over energy moved"], 1e-4), equal("items without films", sum("film" in k for k in dry.ledger), 0)]


@feature("F205", G)
def _(b):
    r = b.run(sets={"kGsHydro": 1, **HYDRO}, until="0.1rev")
    thick = b.run(sets={"kGsHydro": 1, "pocVis": 0.02, "gsVis": 0.04}, until="0.1rev")
    h = [sum(v for k, v in x.ledger.items() if "guide-land film" in k or ("land" in k and "film" in k)) for x in (r, thick)]
    c = b.channels(r)
    # Petroff: 2 pi mu w^2 r^3 L / c for both lands at the start
    w = c["cage.angular_velocity.1.1"][0]
    petroff = 2 * 2 * math.pi * 0.02 * w * w * 0.033**3 * 0.002 / 1.489e-4
    p = c["power.land_film_heat"][1]
    return r.command, [between("heat of the land films over Petroff's [W]", p / petroff, 0.8, 1.6), between("twice the viscosity over that before", h[1] / h[0], 1.7, 2.2)]


@feature("F206", G)
def _(b):
    # At the start: a pocket film of 0.1 mm that all balls feel, a cage 20 % fast; nothing but the viscosity differs.
    x = [b.channels(b.run(sets={"kPocHydro": 1, "kGsHydro": 1, "avRatio": 1.2, "pocLubFilm": 1e-4, "pocVis": p, "gsVis": g}, until="0.02rev")) for p, g in
         ((0.02, 0.02), (0.04, 0.02), (0.02, 0.04))]
    pocket, land = ([c[n][0] for c in x] for n in ("power.pocket_film_heat", "power.land_film_heat"))
    # Petroff with the slip of the cage against the standing outer race and the lands' mean clearance
    w = x[0]["cage.angular_velocity.1.1"][0]
    petroff = 2 * 2 * math.pi * 0.02 * w * w * 0.033**3 * 0.002 / 1.489e-4
    return "adore run ball.txt --set kPocHydro=1 --set kGsHydro=1 --set avRatio=1.2 --set pocLubFilm=1e-4 --set pocVis=0.04 --set gsVis=0.02 --until 0.02rev", [
        close("heat of the pocket films, twice pocVis", pocket[1] / pocket[0], 2.0, 0.01), close("that with twice gsVis", pocket[2] / pocket[0], 1.0, 1e-6),
        close("heat of the land films, twice gsVis", land[2] / land[0], 2.0, 0.01), close("that with twice pocVis", land[1] / land[0], 1.0, 1e-6),
        between("heat of the land films over Petroff's of a centred cage", land[0] / petroff, 0.9, 1.3)]


def drag(run):
    return run.json["quasi_static"]["tables"]["friction"].get("drag of elements in the medium [W]", [0.0])[0]


@feature("F207", G)
def _(b):
    r = b.run(until=SHORT)
    return r.command, [equal("churning fraction of SOL7", max(r.sol("SOL7").column(2)), 0.0), equal("drag of elements, statics [W]", drag(b.static()), 0.0)]


@feature("F208", G)
def _(b):
    r = b.static(sets=oil(4, kChrn=1, denRatio=0.1, visRatio=1.0))
    twice = b.static(sets=oil(4, kChrn=1, denRatio=0.2, visRatio=1.0))
    refused = b.static(sets={"kChrn": 1, "denRatio": 0.1, "visRatio": 1.0}, check=False)
    return r.command, [more("drag of the balls in a tenth of oil [W]", drag(r), 1.0), between("with twice the density over that before", drag(twice) / drag(r), 1.7, 2.1),
                       equal("without a lubricant: exit code", refused.code, 2)]


@feature("F209", G)
def _(b):
    r = b.static(sets={"kChrn": 2, "chnDen": 90.0, "chnVis": 0.005})
    twice = b.static(sets={"kChrn": 2, "chnDen": 180.0, "chnVis": 0.005})
    thick = b.static(sets={"kChrn": 2, "chnDen": 90.0, "chnVis": 5.0})
    v, spin, area = 0.0300052 * 4090 * math.pi / 30, 19350 * math.pi / 30, math.pi / 4 * 0.0127**2
    translation = 0.5 * 90.0 * v**3 * area
    # Reynolds number 3000: a sphere's drag coefficient 0.40; the cage hides part of the ball. Spin adds 6.45/sqrt(Re) + 32.1/Re (Schlichting).
    spin_re = 90.0 * spin * 0.00635**2 / 0.005
    rotation = 0.5 * 90.0 * spin**3 * 0.00635**5 * (6.45 / math.sqrt(spin_re) + 32.1 / spin_re)
    # Reynolds number 3: Schiller and Naumann's 24/Re (1 + 0.15 Re^0.687); Stokes' spin 8 pi mu r^3 w^2
    re = 90.0 * v * 0.0127 / 5.0
    creeping = translation * 24 / re * (1 + 0.15 * re**0.687), 8 * math.pi * 5.0 * 0.00635**3 * spin**2
    return r.command, [between("drag of a ball over that of a free sphere without cage", drag(r) / 12 / (0.40 * translation + rotation), 0.5, 1.05),
                       between("twice the density: 2 less the fall of the coefficients with Reynolds' number", drag(twice) / drag(r), 2**0.75, 2.0),
                       between("a thousand times the viscosity: drag of a ball over creeping flow of a free sphere", drag(thick) / 12 / sum(creeping), 0.5, 1.15), equal("balls", len(r.elements["inner load [N]"]), 12)]


@feature("F210", G)
def _(b):
    import json
    out, command = [], ""
    for code, temperature in ((3, 95.0), (4, 20.0), (5, 77.0), (6, 112.0), (7, 112.0), (8, 293.15), (9, 293.15), (10, 293.15), (11, 293.15), (12, 293.15), (13, 293.15), (14, 293.15)):
        t = {n: temperature for n in T350}
        r = b.static(sets={**t, "kChrn": code, "denRatio": 0.1, "visRatio": 1.0}, check=False)
        command = r.command
        fluid = json.loads(b.call("calc", "fluid", given=json.dumps({"kind": "fluid_property", "code": code, "T": temperature})).stdout)
        fluid = fluid.get("results", fluid)
        same = b.static(sets={**t, "kChrn": 2, "chnDen": 0.1 * fluid["density"], "chnVis": fluid["viscosity"]}, check=False)
        if r.code or same.code:
            out.append(equal(f"code {code} at {temperature} K: exit code", max(r.code, same.code), 0))
        else:
            out.append(close(f"code {code}: drag, that of the same density and viscosity by record 10.7A [W]", drag(r), drag(same), 1e-6))
    return command, out


@feature("F211", G)
def _(b):
    import json

    def calc(**inputs):
        out = json.loads(b.call("calc", "churning", given=json.dumps({"kind": "cylinder_concentric_annulus", "inputs": {"kind": "annulus", "rho": 900.0, "mu": 0.002, "r": 0.05,
                                "c": 0.001, "length": 0.02, "omega": 1500.0, **inputs}})).stdout)
        return out.get("results", out)["torque"]

    def pump(speed):
        parts = b.static("lox-turbopump", sets={"rpm2": speed}).table("friction")
        return parts["drag of elements in the medium [W]"][0], parts["drag of the cage in the medium [W]"][0]

    laminar = 2 * math.pi * 0.002 * 0.05**3 * 1.0 * 0.02 / 0.001
    balls = {n: pump(float(n))[0] for n in (7500, 15000, 30000)}
    cage = {n: pump(float(n))[1] for n in (10000, 20000)}
    return "adore calc churning (annulus); adore run lox-turbopump.txt --set mode=-1 --set rpm2=15000", [
        close("laminar torque (Petroff) [N.m]", calc(omega=1.0), laminar, 1e-3), close("laminar torque over speed at 2 rad/s: the same", calc(omega=2.0) / calc(omega=1.0), 2.0, 1e-3),
        close("turbulent torque at 1500 rad/s, 3 (Re/2500)^0.85596 times Petroff's (Rumbarger and others) [N.m]", calc(), laminar * 1500 * 3 * (900 * 1500 * 0.05 * 0.001 / 0.002 / 2500)**0.85596, 0.01),
        close("drag of the balls in LOX, 15000 over 7500 rpm, Reynolds numbers of 6e4 to 3e5 with a constant coefficient: 2^3", balls[15000] / balls[7500], 8.0, 0.08),
        less("30000 over 15000 rpm, across the drag crisis of spheres (coefficient 0.45 to 0.1): below", balls[30000] / balls[15000], 0.5 * 8.0),
        between("drag of the cage, 20000 over 10000 rpm: between laminar 2^2 and rough 2^3", cage[20000] / cage[10000], 4.0, 8.0)]


@feature("F212", G)
def _(b):
    r = b.run(sets={"kChrn": 2, "chnDen": 90.0, "chnVis": 0.005}, until="0.05rev")
    c = b.channels(r)
    t = len(c["time"]) // 2
    whole = c["power.loss"][t]
    part = c["power.element_drag"][t] + c["power.cage_drag"][t]
    return r.command, [close("fraction of SOL7, (drag of balls and cage) / power", r.sol("SOL7").column(2)[t], part / whole, 1e-5), more("fraction", part / whole, 0.01)]


OF_ELEMENTS = ("contact.heat.", "contact.rolling_heat.", "contact.damping_heat.", "flange.heat.", "flange.damping_heat.", "element.pocket_heat.")
OF_ALL = ("power.pocket_damping", "power.land_damping", "power.element_heat", "power.element_damping", "power.element_drag", "power.cage_drag")


@feature("F213", G)
def _(b):
    out = []
    for deck, sets in (("ball", oil(4)), ("tapered", oil(4, kChrn=2, chnDen=90.0, chnVis=0.005)), ("cylindrical", {})):
        r = b.run(deck, sets=sets, until="0.05rev")
        c = b.channels(r)
        t = len(c["time"]) // 2
        parts = sum(v[t] for k, v in c.items() if k.startswith(OF_ELEMENTS + ("land.heat.",)) and not math.isnan(v[t]))
        parts += sum(c[k][t] for k in OF_ALL if k in c)
        out.append(close(f"{deck}: heat of all contacts and drags, the power of SOL7 [W]", parts, r.sol("SOL7").column(1)[t], 1e-6))
        rolling = sum(v[t] for k, v in c.items() if k.startswith("contact.rolling_heat."))
        s = r.sol("SOL1").values[t]
        roller = deck != "ball"
        of_one = s[23] + s[24] + sum(s[33 + 12 * roller:38 + 12 * roller]) + (s[31] + s[32] + s[37] + s[38] + sum(s[50:54]) if roller else 0.0)
        ours = [k for k in c if k.startswith(OF_ELEMENTS) and k.split(".")[2] == "1"]
        out.append(close(f"{deck}: heat of element 1 in SOL1, in RESULTS.h5 [W]", of_one, sum(c[k][t] for k in ours), 1e-6))
        out.append(equal(f"{deck}: PRINT lists the heat of each element", "Heat of each element: friction, rolling resistance and damping" in r.listing, True))
        out.append(less(f"{deck}, dry: rolling resistance [W]", rolling, 1e-300) if not sets else more(f"{deck}, in oil: rolling resistance [W]", rolling, 0.01))
    return r.command, out


@feature("F214", G)
def _(b):
    r = b.run(until="0.3rev")
    c = b.channels(r)
    total = {1: 0.0, 2: 0.0}
    for race in (1, 2):
        for k in range(1, 13):
            v = c[f"contact.load_slip.{k}.{race}"]
            total[race] += sum(0.5 * (v[t] + v[t - 1]) * (c["time"][t] - c["time"][t - 1]) for t in range(1, len(v)))
    out = []
    for race in (1, 2):
        # K = 1e-6, H = 7.061e9 Pa; half of the wear goes to each body of equal coefficients
        out.append(close(f"wear rate of race {race}, K/H times the mean of load times slip [m^3/s]", c[f"race.wear_rate.{race}"][-1], 1e-6 / 7.061e9 * total[race] /
                         c["time"][-1], 0.05))
    return r.command, out + [more("wear rate of the cage [m^3/s]", c["power.cage_wear_rate"][-1], 0.0)]


@feature("F215", G)
def _(b):
    r = b.run(until="0.3rev")
    s = r.sol("SOL7")
    c = b.channels(r)
    rate = [x * t for x, t in zip(s.column(12), s.times)]
    return r.command, [equal("worn volume never falls", all(y >= x - 1e-22 for x, y in zip(rate, rate[1:])), True), close("SOL7 value 12, RESULTS.h5 [m^3/s]", s.column(12)[-1],
                       c["race.wear_rate.2"][-1], 1e-6), more("worn volume of the inner race [m^3]", rate[-1], 0.0)]


@feature("F216", G)
def _(b):
    r = b.run(until="0.3rev")
    c = b.channels(r)
    mean = sum(c[f"element.orbital_position.{k}"][-1] - c[f"element.orbital_position.{k}"][0] for k in range(1, 13)) / 12
    return r.command, [close("mean orbital ratio, turned angle of the balls over that of the shaft", r.summary["mean_orbital_ratio"], mean / c["shaft_rotation"][-1], 1e-3)]


@feature("F217", G)
def _(b):
    r = b.run(until="0.3rev")
    c = b.channels(r)
    return r.command, [close("mean cage ratio, turned angle of the cage over that of the shaft", r.summary["mean_cage_ratio"],
                             (c["cage.rotation.1"][-1] - c["cage.rotation.1"][0]) / c["shaft_rotation"][-1], 1e-3),
                       close("SOL3 value 22", r.sol("SOL3").column(22)[-1], c["cage.angular_velocity.1.1"][-1] / (10000 * math.pi / 30), 1e-5)]


@feature("F218", G)
def _(b):
    r = b.run(until="0.3rev")
    c = b.channels(r)
    t = len(c["time"]) // 2
    y, z, vy, vz = (c[f"cage.{n}.1.{a}"][t] for n in ("position", "velocity") for a in (2, 3))
    whirl = (y * vz - z * vy) / (y * y + z * z) / (10000 * math.pi / 30)
    return r.command, [close("whirl ratio of SOL3, (y vz - z vy) / r^2 over the shaft's speed", r.sol("SOL3").column(1)[t], whirl, 1e-3),
                       differs("another start (wvRatio 0): first whirl ratio", b.run(sets={"wvRatio": 0.0}, until="0.002rev").sol("SOL3").column(1)[0],
                               r.sol("SOL3").column(1)[0], 1e-2)]
