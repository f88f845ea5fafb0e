"""Imperfections, inertia and cage (F062 to F110)."""

import math

import hertz
from bench import between, close, differs, equal, feature, less, more, not_checked
from checks_statics import ball_mass, mass

G = "bodies"
D, FO, FI, A0 = 0.0127, 0.520, 0.515, math.radians(25.0)
REST = {"rpm2": 0.0, "appLoadZ": 0.0, "appLoadX": 1500.0}
STEP = "0.01rev"


def thrust(b, **sets):
    return b.static(sets={**REST, **sets})


def shares(run, key="inner load [N]"):
    return run.elements[key]


def total_approach(load, angle):
    return hertz.ball_on_race(load, D, 0.06, FO, angle, 1)[3] + hertz.ball_on_race(load, D, 0.06, FI, angle, 2)[3]


def approaches(run):
    """Sum of both approaches of every ball from its load, by Hertz."""
    return [total_approach(q, math.radians(a)) if q > 0 else 0.0 for q, a in zip(run.elements["inner load [N]"], run.elements["inner contact angle [deg]"])]


def listed_deviations(first, value):
    return {f"reDiaVar{k}": (value if k == first else 0.0) for k in range(1, 41)}


@feature("F062", G)
def _(b):
    one, two = b.run(sets={"kReGeoImp": 1, "reDiaVar": 2e-6}, until=STEP), b.run(sets={"kReGeoImp": 1, "reDiaVar": 2e-6}, until=STEP, opts={"seed": 2})
    d = approaches(thrust(b, kReGeoImp=1, reDiaVar=1e-6))
    mean = sum(d) / 12
    spread = math.sqrt(sum((x - mean)**2 for x in d) / 11)
    again = approaches(thrust(b, kReGeoImp=1, reDiaVar=5e-7))
    mean2 = sum(again) / 12
    spread2 = math.sqrt(sum((x - mean2)**2 for x in again) / 11)
    return "adore run ball.txt --set mode=-1 --set kReGeoImp=1 --set reDiaVar=1e-06 --set rpm2=0 --set appLoadZ=0", [
        between("spread of the approaches over the rms deviation (12 balls)", spread / 1e-6, 0.5, 1.6),
        close("spread with half the deviation over that", spread2 / spread, 0.5, 0.02),
        differs("load of ball 1 with another seed [N]", b.channels(two)["contact.load.1.1"][0], b.channels(one)["contact.load.1.1"][0], 1e-4)]


@feature("F063", G)
def _(b):
    out, base, command = [], b.static("cylindrical", sets={"rpm2": 0.0}), ""
    keys = {"reDiaVar": (1e-6, "inner load [N]"), "reCrnVar": (0.8, "inner pressure [Pa]"), "reLenVar": (5e-4, "inner pressure [Pa]"),
            "reCLVar": (1e-3, "inner pressure [Pa]"), "reCLOffset": (1e-3, "inner moment [N.m]")}
    for name, (value, key) in keys.items():
        zero = {n: 0.0 for n in keys}
        r = b.static("cylindrical", sets={"rpm2": 0.0, "kReGeoImp": 1, **zero, name: value})
        none = b.static("cylindrical", sets={"rpm2": 0.0, "kReGeoImp": 1, **zero, "reDiaVar": 1e-15})
        command = r.command
        out.append(more(f"{name}: largest change of '{key}'", max(abs(x - y) for x, y in zip(r.elements[key], none.elements[key])) /
                        max(max(abs(v) for v in base.elements[key]), 1e-9), 1e-5))
    t = b.static("tapered", sets={"kReGeoImp": 1, "reDiaVar": 1e-6, "reCrnVar": 0.0, "reLenVar": 0.0, "reCLVar": 0.0, "reCLOffset": 0.0})
    plain = b.static("tapered")
    out.append(more("tapered, reDiaVar = 1 um: change of a load [N]", max(abs(x - y) for x, y in zip(t.elements["outer load [N]"],
                                                                                                 plain.elements["outer load [N]"])), 5.0))
    return command, out


@feature("F064", G)
def _(b):
    out, command = [], ""
    for deck in ("spherical", "spherical-tapered"):
        r, plain = b.static(deck, sets={"kReGeoImp": 1, "reDiaVar": 1e-6}), b.static(deck)
        twice = b.static(deck, sets={"kReGeoImp": 1, "reDiaVar": 2e-6})
        one = max(abs(x - y) for x, y in zip(r.elements["outer load [N]"], plain.elements["outer load [N]"]))
        two = max(abs(x - y) for x, y in zip(twice.elements["outer load [N]"], plain.elements["outer load [N]"]))
        command = r.command
        out += [more(f"{deck}: change of a load with 1 um rms [N]", one, 5.0), between(f"{deck}: with 2 um over that", two / one, 1.7, 2.4)]
    return command, out


@feature("F065", G)
def _(b):
    eps = 1e-6
    r = thrust(b, kReGeoImp=2, **listed_deviations(4, eps))
    d = approaches(r)
    others = [x for k, x in enumerate(d) if k != 3]
    last = thrust(b, kReGeoImp=2, **listed_deviations(12, eps))
    e = approaches(last)
    return r.command[:120] + " ...", [
        close("approach of ball 4 over that of its opposite, ball 10 [m]", d[3] - 0.5 * (d[2] + d[4]), eps, 0.03),
        close("spread of the others: the race shifts by the first harmonic, 4 eps / 12 [m]", max(others) - min(others), 4 * eps / 12, 0.1),
        close("ball 12 of the second record [m]", e[11] - 0.5 * (e[10] + e[0]), eps, 0.03)]


ADRX8 = "int32_t adrx8(adore_adrx8* a) { if (a->call.mode == ADORE_READ) a->call.active = 1; if (a->call.mode == ADORE_COMPUTE) { %s } return 0; }\n"


@feature("F066", G)
def _(b):
    plug = b.plug_in("adrx8_diameter", ADRX8 % "a->diameter[3] = 1e-6;")
    r = b.static(sets={**REST, "kReGeoImp": 3}, more=["--user", plug])
    listed = thrust(b, kReGeoImp=2, **listed_deviations(4, 1e-6))
    return r.command, [close("load of ball 4, that of a listed deviation [N]", shares(r)[3], shares(listed)[3], 1e-9),
                       differs("load of ball 4 without [N]", shares(thrust(b))[3], shares(r)[3], 1e-2)]


def ellipse(race, a, minor, angle, **rest):
    base = {f"rndVar1{race}": a, f"rndVar2{race}": minor, f"rndVar3{race}": angle}
    return {f"kRaceGeoImp{race}": 1, **base, **{f"cFacVar{k}{race}": 0.0 for k in (1, 2, 3)}, **rest}


@feature("F067", G)
def _(b):
    out, command = [], ""
    for race in (1, 2):
        r = thrust(b, **ellipse(race, 1e-6, -1e-6, 0.0))
        command = r.command
        d, cosine = approaches(r), math.cos(math.radians(r.elements["inner contact angle [deg]"][0]))
        sign = -1.0 if race == 1 else 1.0
        out.append(close(f"race {race}: approach at the major axis less that at the minor one [m]", d[0] - d[3], sign * 2e-6 * cosine, 0.05))
        turned = approaches(thrust(b, **ellipse(race, 1e-6, -1e-6, 90.0)))
        out.append(close(f"race {race}: turned by 90 deg [m]", turned[0] - turned[3], -sign * 2e-6 * cosine, 0.05))
    s = b.static("spherical", sets=ellipse(1, 2e-6, -2e-6, 0.0))
    plain = b.static("spherical")
    out.append(less("spherical: load of roller 1 at the wider place less that of a round race [N]", s.elements["outer load [N]"][0] -
                    plain.elements["outer load [N]"][0], -5.0))
    return command, out


def wave(race, amplitude, waves, phase, **rest):
    return {f"kRaceGeoImp{race}": 2, f"rndVar1{race}": amplitude, f"rndVar2{race}": waves, f"rndVar3{race}": phase,
            **{f"cFacVar{k}{race}": 0.0 for k in (1, 2, 3)}, **rest}


@feature("F068", G)
def _(b):
    out, command = [], ""
    for race in (1, 2):
        r = thrust(b, **wave(race, 1e-6, 3.0, 0.0))
        command = r.command
        d, cosine = approaches(r), math.cos(math.radians(r.elements["inner contact angle [deg]"][0]))
        sign = -1.0 if race == 1 else 1.0
        # sin(3 theta): +1 at 30 deg (ball 2), -1 at 90 deg (ball 4)
        out.append(close(f"race {race}: approach at 30 deg less that at 90 deg [m]", d[1] - d[3], sign * 2e-6 * cosine, 0.05))
        out.append(close(f"race {race}: at 0 and 60 deg, equal [m]", d[0] - d[2], 0.0, absolute=2e-8))
        turned = approaches(thrust(b, **wave(race, 1e-6, 3.0, 90.0)))
        out.append(close(f"race {race}: phase of 90 deg: at 0 less that at 60 deg [m]", turned[0] - turned[2], sign * 2e-6 * cosine, 0.05))
    return command, out


@feature("F069", G)
def _(b):
    out, command = [], ""
    for race, name, factor in ((1, "outer", FO), (2, "inner", FI)):
        sets = wave(race, 0.0, 0.0, 0.0)
        sets.update({f"cFacVar1{race}": 0.004, f"cFacVar2{race}": 3.0, f"cFacVar3{race}": 0.0})
        r = thrust(b, **sets)
        command = r.command
        for k, change in ((1, 0.004), (3, -0.004)):
            q, a = r.elements[f"{name} load [N]"][k], math.radians(r.elements[f"{name} contact angle [deg]"][k])
            out.append(close(f"{name} pressure of ball {k + 1} at factor {factor + change:.3f} [Pa]", r.elements[f"{name} pressure [Pa]"][k],
                             hertz.ball_on_race(q, D, 0.06, factor + change, a, race)[2], 5e-3))
    return command, out


def roller_wave(race, code, **values):
    names = ["rndVar1", "rndVar2", "rndVar3", "rlOffset1", "rlOffset2", "rlOffset3", "rlTaper1", "rlTaper2", "rlTaper3"]
    return {f"kRaceGeoImp{race}": code, **{f"{n}{race}": values.get(n, 0.0) for n in names}}


def roller_change(b, deck, sets, key, **rest):
    r = b.static(deck, sets={**sets, **rest})
    plain = b.static(deck, sets=rest)
    return r, [x - y for x, y in zip(r.elements[key], plain.elements[key])]


@feature("F070", G)
def _(b):
    out, command = [], ""
    for race, sign in ((1, -1), (2, 1)):
        r, change = roller_change(b, "cylindrical", roller_wave(race, 1, rndVar1=2e-6, rndVar2=-2e-6), "inner load [N]", rpm2=0.0)
        command = r.command
        r2, turned = roller_change(b, "cylindrical", roller_wave(race, 1, rndVar1=2e-6, rndVar2=-2e-6, rndVar3=90.0), "inner load [N]", rpm2=0.0)
        out += [more(f"race {race}: change of the load at the major axis, sign as expected [N]", sign * (change[0] - change[1]) * 1.0, 10.0),
                less(f"race {race}: turned by 90 deg [N]", sign * (turned[0] - turned[1]), -10.0)]
        _, half = roller_change(b, "cylindrical", roller_wave(race, 1, rndVar1=2e-6), "inner load [N]", rpm2=0.0)
        out.append(between(f"race {race}: the major axis alone over both", (half[0] - half[1]) / (change[0] - change[1]), 0.2, 0.8))
    t, change = roller_change(b, "tapered", roller_wave(1, 1, rndVar1=2e-6, rndVar2=-2e-6), "outer load [N]", rpm2=0.0)
    out.append(less("tapered, outer race: change of roller 1 at the major axis [N]", change[0], -10.0))
    return command, out


@feature("F071", G)
def _(b):
    out, command = [], ""
    for race, sign in ((1, -1), (2, 1)):
        r, change = roller_change(b, "cylindrical", roller_wave(race, 2, rndVar1=2e-6, rndVar2=7.0, rndVar3=90.0), "inner load [N]", rpm2=0.0)
        command = r.command
        # cos(7 theta) at 14 rollers alternates: +1 at even places, -1 at odd ones
        out.append(more(f"race {race}: alternating change, roller 1 less roller 2, sign as expected [N]", sign * (change[0] - change[1]), 50.0))
        _, other = roller_change(b, "cylindrical", roller_wave(race, 2, rndVar1=2e-6, rndVar2=7.0, rndVar3=0.0), "inner load [N]", rpm2=0.0)
        out.append(less(f"race {race}: phase 0, zero at every roller [N]", abs(other[0] - other[1]), 2.0))
    t, change = roller_change(b, "tapered", roller_wave(2, 2, rndVar1=2e-6, rndVar2=2.0, rndVar3=90.0), "outer load [N]", rpm2=0.0)
    out.append(more("tapered, inner race: change of roller 1 at a crest [N]", change[0], 10.0))
    return command, out


@feature("F072", G)
def _(b):
    out, command = [], ""
    for race, name in ((1, "outer"), (2, "inner")):
        crown = {"rpm2": 0.0, f"raceCrn{race}": 1.0, f"raceCenLen{race}": 0.004}
        r, m = roller_change(b, "cylindrical", roller_wave(race, 1, rlOffset1=1e-3, rlOffset3=90.0), f"{name} moment [N.m]", **crown)
        command = r.command
        _, back = roller_change(b, "cylindrical", roller_wave(race, 1, rlOffset1=-1e-3, rlOffset3=90.0), f"{name} moment [N.m]", **crown)
        _, wave2 = roller_change(b, "cylindrical", roller_wave(race, 2, rlOffset1=1e-3, rlOffset2=2.0, rlOffset3=90.0), f"{name} moment [N.m]", **crown)
        out += [more(f"{name} race: moment by a land offset of 1 mm [N.m]", abs(m[0]) + abs(max(r.elements["tilt [deg]"], key=abs)), 1e-5),
                close(f"{name} race: the opposite offset [N.m]", back[0], -m[0], 0.1, 1e-9),
                differs(f"{name} race: two waves, roller 2 [N.m]", wave2[1], m[1], 1e-3)]
    return command, out


@feature("F073", G)
def _(b):
    out, command = [], ""
    for race, name in ((1, "outer"), (2, "inner")):
        r, m = roller_change(b, "cylindrical", roller_wave(race, 2, rlTaper1=5e-4, rlTaper2=1.0, rlTaper3=90.0), f"{name} moment [N.m]", rpm2=0.0)
        command = r.command
        _, back = roller_change(b, "cylindrical", roller_wave(race, 2, rlTaper1=-5e-4, rlTaper2=1.0, rlTaper3=90.0), f"{name} moment [N.m]", rpm2=0.0)
        out += [more(f"{name} race: moment by a taper of 0.5 mrad [N.m]", abs(m[0]), 0.02), close(f"{name} race: the opposite taper [N.m]", back[0], -m[0], 0.02)]
    return command, out


@feature("F074", G)
def _(b):
    plug = b.plug_in("adrx6_wave", "int32_t adrx6(adore_surface* a) { if (a->call.mode == ADORE_READ) a->call.active = 1; if (a->call.mode == ADORE_COMPUTE"
                     " && a->race == 0) for (int64_t i = 0; i < a->n; ++i) a->radius[i] = 1e-6 * sin(3.0 * a->azimuth[i]); return 0; }\n")
    r = b.static(sets={**REST, "kRaceGeoImp1": 3}, more=["--user", plug])
    same = thrust(b, **wave(1, 1e-6, 3.0, 0.0))
    both = thrust(b, **{**wave(1, 1e-6, 3.0, 0.0), **wave(2, 1e-6, 3.0, 0.0)})
    d = approaches(both)
    return r.command, [close("load of ball 2, that of the sinusoidal record [N]", shares(r)[1], shares(same)[1], 1e-4),
                       close("equal waves on both races: approach at 30 less that at 90 deg, they cancel [m]", d[1] - d[3], 0.0, absolute=1e-7),
                       differs("load of ball 2 without errors [N]", shares(thrust(b))[1], shares(r)[1], 1e-2)]


def gaps(b, deck="ball", n=12, surface=1, **sets):
    c = b.channels(b.run(deck, sets=sets, until="0.002rev"))
    return [c[f"pocket.gap.{k}.{surface}"][0] for k in range(1, n + 1)]


CENTRED = {"cageGcPos": "0,0,0"}
POCKET = ["bPocClsVar1", "bPocClsVar2", "bPocThknsVar", "bPocCenVar1", "bPocCenVar2", "bPocAngVar1", "bPocAngVar2", "bPocAngVar3"]


def pocket_error(code, **values):
    return {**CENTRED, "kCagePocImp": code, **{n: values.get(n, 0.0) for n in POCKET}}


@feature("F075", G)
def _(b):
    base, one = gaps(b, **CENTRED), gaps(b, **pocket_error(1, bPocClsVar1=1e-4))
    return "adore run ball.txt --set kCagePocImp=1 --set bPocClsVar1=1e-4 --set cageGcPos=0,0,0 --until 0.002rev", [
        close("change of the gap in pocket 1 [m]", one[0] - base[0], 5e-5, 0.02), equal("changes in the other pockets [m]",
                                                                                     max(abs(x - y) for x, y in zip(one[1:], base[1:])), 0.0)]


@feature("F076", G)
def _(b):
    base, all_ = gaps(b, **CENTRED), gaps(b, **pocket_error(2, bPocClsVar1=1e-4))
    changes = [x - y for x, y in zip(all_, base)]
    return "adore run ball.txt --set kCagePocImp=2 --set bPocClsVar1=1e-4 --set cageGcPos=0,0,0 --until 0.002rev", [
        close("least change of a gap [m]", min(changes), 5e-5, 0.02), close("largest change [m]", max(changes), 5e-5, 0.02)]


@feature("F077", G)
def _(b):
    base, some = gaps(b, **CENTRED), gaps(b, **pocket_error(3, bPocClsVar1=2e-5))
    d = [2 * (x - y) for x, y in zip(some, base)]
    rms = math.sqrt(sum(x * x for x in d) / 12)
    return "adore run ball.txt --set kCagePocImp=3 --set bPocClsVar1=2e-5 --set cageGcPos=0,0,0 --until 0.002rev", [
        between("rms of the deviations over bPocClsVar1 (12 pockets)", rms / 2e-5, 0.5, 1.6), equal("different values", len({round(1e12 * x) for x in d}), 12)]


@feature("F078", G)
def _(b):
    plug = b.plug_in("adrx8_pocket", ADRX8 % "a->pocket_clearance1[4] = 1e-4;")
    base = gaps(b, **CENTRED)
    r = b.run(sets={**CENTRED, "kCagePocImp": 4}, until="0.002rev", more=["--user", plug])
    c = b.channels(r)
    g = [c[f"pocket.gap.{k}.1"][0] for k in range(1, 13)]
    return r.command, [close("change of the gap in pocket 5 [m]", g[4] - base[4], 5e-5, 0.02),
                       equal("changes elsewhere [m]", max(abs(x - y) for k, (x, y) in enumerate(zip(g, base)) if k != 4), 0.0)]


@feature("F079", G)
def _(b):
    """Against the same pocket without errors; the ball's axial offset from the middle of the pocket is known."""
    c = b.channels(b.run(sets=CENTRED, until="0.002rev"))
    dx = c["element.axial_position.1"][0] - c["cage.position.1.1"][0]
    base = c["pocket.gap.1.1"][0]
    rect = {"kPocType": 3, "bPocCls2": 3e-4}
    plain = {s: gaps(b, surface=s, **rect, **CENTRED)[0] for s in (1, 2, 3, 4)}
    shift = gaps(b, **pocket_error(2, bPocCenVar2=0.1))[0]
    wide = {s: gaps(b, surface=s, **{**pocket_error(2, bPocClsVar2=1e-4), **rect})[0] for s in (1, 2, 3, 4)}
    moved = {s: gaps(b, surface=s, **{**pocket_error(2, bPocCenVar1=5e-5), **rect})[0] for s in (1, 2, 3, 4)}
    along = gaps(b, **pocket_error(2, bPocCenVar1=5e-5))[0]
    tilt3 = gaps(b, surface=2, **{**pocket_error(2, bPocAngVar3=1.0), **rect})[0]
    cone = {"kPocType": 4, "bPocCls2": 6e-4}
    thin, full = (gaps(b, **{**pocket_error(2, bPocThknsVar=v), **cone})[0] for v in (-1e-3, 0.0))
    arc = 0.030005 * math.radians(0.1)
    sides = sorted(range(1, 5), key=lambda s: abs(wide[s] - plain[s]))  # the last two are the axial walls
    return "adore run ball.txt --set kCagePocImp=2 --set bPocCenVar2=0.1 --set cageGcPos=0,0,0 --until 0.002rev", [
        close("angular shift of 0.1 deg: change of the gap, hypot(dx, r angle) - |dx| [m]", base - shift, math.hypot(dx, arc) - abs(dx), 5e-3),
        close("axial shift of 0.05 mm of a cylinder: change of the gap [m]", base - along, abs(dx - 5e-5) - abs(dx), 5e-3),
        close("clearance II of a rectangle + 0.1 mm: change at one axial wall [m]", wide[sides[-1]] - plain[sides[-1]], 5e-5, 5e-3),
        close("at the other [m]", wide[sides[-2]] - plain[sides[-2]], 5e-5, 5e-3), less("at the walls fore and aft [m]", abs(wide[sides[1]] - plain[sides[1]]), 1e-7),
        close("axial shift of a rectangle: changes at both axial walls together [m]", sum(moved[s] - plain[s] for s in sides[2:]), 0.0, absolute=1e-7),
        close("size at one of them [m]", abs(moved[sides[-1]] - plain[sides[-1]]), 5e-5, 5e-3),
        differs("tilt about x of 5 deg: gap [m]", gaps(b, **pocket_error(2, bPocAngVar1=5.0))[0], base, 1e-6), differs("tilt about y of 5 deg: gap [m]", gaps(b, **pocket_error(2, bPocAngVar2=5.0))[0], base, 1e-6),
        differs("tilt about z of 1 deg of a rectangle: gap [m]", tilt3, plain[2], 1e-6),
        differs("conical pocket with a wall 1 mm thinner: gap [m]", thin, full, 1e-2)]


def land_gap(b, **sets):
    c = b.channels(b.run(sets={**CENTRED, **sets}, until="0.002rev"))
    return c["cage.land1_gap.1"][0], c["cage.land2_gap.1"][0]


@feature("F080", G)
def _(b):
    base = land_gap(b)
    r = land_gap(b, kCageGsImp=1, **{"cageGsRadVar1[1]": 3e-5, "cageGsRadVar2[1]": -1e-5})
    return "adore run ball.txt --set kCageGsImp=1 --set cageGsRadVar1[1]=3e-5 --set cageGsRadVar2[1]=-1e-5 --until 0.002rev", [
        close("least gap at land 1 falls by the larger half axis [m]", base[0] - r[0], 3e-5, 0.05), close("land 2 as before [m]", r[1], base[1], 1e-6)]


@feature("F081", G)
def _(b):
    base = land_gap(b)
    r = land_gap(b, kCageGsImp=2, **{"cageGsRadVar1[1]": 2e-5, "cageGsRadVar2[1]": 4.0, "cageGsRadVar3[1]": 30.0})
    return "adore run ball.txt --set kCageGsImp=2 --set cageGsRadVar1[1]=2e-5 --set cageGsRadVar2[1]=4 --until 0.002rev", [
        close("least gap at land 1 falls by the amplitude [m]", base[0] - r[0], 2e-5, 0.05), close("land 2 as before [m]", r[1], base[1], 1e-6)]


@feature("F082", G)
def _(b):
    base = land_gap(b)
    r = land_gap(b, kRaceGsImp=1, **{"raceGsRadVar1[1]": 2e-5, "raceGsRadVar2[1]": -3e-5})
    other = land_gap(b, kRaceGsImp=1, **{"raceGsRadVar1[1]": -4e-5, "raceGsRadVar2[1]": 2e-5})
    return "adore run ball.txt --set kRaceGsImp=1 --set raceGsRadVar1[1]=2e-5 --set raceGsRadVar2[1]=-3e-5 --until 0.002rev", [
        close("with the other axis the smaller one [m]", base[0] - other[0], 4e-5, 0.05),
        close("least gap at land 1 falls by the smaller half axis of the race [m]", base[0] - r[0], 3e-5, 0.05), close("land 2 as before [m]", r[1], base[1], 1e-6)]


@feature("F083", G)
def _(b):
    base = land_gap(b)
    r = land_gap(b, kRaceGsImp=2, **{"raceGsRadVar1[1]": 2e-5, "raceGsRadVar2[1]": 3.0, "raceGsRadVar3[1]": 0.0})
    return "adore run ball.txt --set kRaceGsImp=2 --set raceGsRadVar1[1]=2e-5 --set raceGsRadVar2[1]=3 --until 0.002rev", [
        close("least gap at land 1 falls by the amplitude [m]", base[0] - r[0], 2e-5, 0.05), close("land 2 as before [m]", r[1], base[1], 1e-6)]


def inertia(code=1, **sets):
    i = 0.4 * 0.0083765 * 0.00635**2
    return {"kReIP": code, "bReMass": 0.0083765, "bReMIx": i, "bReMIy": i, "bReMIz": i, "bReGeoCenX": 0.0, "bReGeoCenY": 0.0, "bReGeoCenZ": 0.0,
            "bReFrameX": 0.0, "bReFrameY": 0.0, "bReFrameZ": 0.0, **sets}


def stored(b, **sets):
    return b.run(sets=sets, until="0.02rev").ledger["stored at the start [J]"]


ORBIT, SPIN = 4081.2 * math.pi / 30, 19290.0 * math.pi / 30


def spread(values):
    return max(values) - min(values)


def correlation(a, b):
    a, b = ([x - sum(v) / len(v) for x in v] for v in (a, b))
    return sum(x * y for x, y in zip(a, b)) / math.sqrt(sum(x * x for x in a) * sum(y * y for y in b))


@feature("F084", G)
def _(b):
    even = b.channels(b.run(sets=inertia(1), until="0.2rev"))
    off = b.channels(b.run(sets=inertia(1, bReGeoCenZ=1e-4), until="0.2rev"))
    swing = [x - y for x, y in zip(off["contact.load.1.1"], even["contact.load.1.1"])]
    expected = 0.0083765 * 1e-4 * SPIN**2
    beside = b.channels(b.run(sets=inertia(1, bReGeoCenY=1e-4), until="0.2rev"))
    lag = [x - y for x, y in zip(beside["contact.load.1.1"], even["contact.load.1.1"])]
    half = len(lag) // 2
    flat = b.channels(b.run(sets=inertia(1, bReMIx=1.0e-7), until="0.1rev"))
    others = {}
    for name, value in (("bReGeoCenX", 1e-4), ("bReFrameY", 20.0), ("bReFrameZ", 20.0)):
        others[name] = b.channels(b.run(sets=inertia(1, bReMIx=1.0e-7, **{name: value}), until="0.1rev"))
    quiet = [x - y for x, y in zip(off["contact.load.7.1"], even["contact.load.7.1"])]
    return "adore run ball.txt --set kReIP=1 --set bReGeoCenZ=1e-4 ... --until 0.2rev", [
        between("swing of ball 1's outer load over m e w^2", (max(swing) - min(swing)) / 2 / expected, 0.3, 3.0),
        less("swing of ball 7 over that of ball 1", (max(quiet) - min(quiet)) / (max(swing) - min(swing)), 0.3),
        between("second half: swing with the offset a quarter turn away over that with the first", spread(lag[half:]) / spread(swing[half:]), 0.4, 2.5),
        less("correlation of both swings", abs(correlation(lag, swing)), 0.7),
        *(differs(f"angular velocity of ball 1 with {name} [rad/s]", c["element.angular_velocity.1"][-1], flat["element.angular_velocity.1"][-1], 1e-6) for name, c in others.items())]


@feature("F085", G)
def _(b):
    base = stored(b, **inertia(1))
    heavy = stored(b, **inertia(1, bReMass=0.0083765 * 1.05))
    spin = stored(b, **inertia(1, bReMIx=1.4e-7, bReMIy=1.4e-7, bReMIz=1.4e-7))
    return "adore run ball.txt --set kReIP=1 --set bReMass=0.0087953 ... --until 0.02rev", [
        close("energy of 5 % more mass of one ball [J]", heavy - base, 0.05 * 0.5 * 0.0083765 * (0.0300052 * ORBIT)**2, 0.05),
        close("energy of one larger moment of inertia [J]", spin - base, 0.5 * (1.4e-7 - 0.4 * 0.0083765 * 0.00635**2) * SPIN**2, 0.04)]


@feature("F086", G)
def _(b):
    base = stored(b, **inertia(2))
    heavy = stored(b, **inertia(2, bReMass=0.0083765 * 1.05))
    spin = stored(b, **inertia(2, bReMIx=1.4e-7, bReMIy=1.4e-7, bReMIz=1.4e-7))
    return "adore run ball.txt --set kReIP=2 --set bReMass=0.0087953 ... --until 0.02rev", [
        close("energy of 5 % more mass of all balls [J]", heavy - base, 12 * 0.05 * 0.5 * 0.0083765 * (0.0300052 * ORBIT)**2, 0.05),
        close("energy of twelve larger moments of inertia [J]", spin - base, 12 * 0.5 * (1.4e-7 - 0.4 * 0.0083765 * 0.00635**2) * SPIN**2, 0.04)]


@feature("F087", G)
def _(b):
    plug = b.plug_in("adrx8_inertia", ADRX8 % "a->mass = 0.016753; a->moments[0] = a->moments[1] = a->moments[2] = 1.351e-7;")
    r = b.run(sets={"kReIP": 3}, until="0.02rev", more=["--user", plug])
    same = b.run(sets=inertia(2, bReMass=0.016753, bReMIx=1.351e-7, bReMIy=1.351e-7, bReMIz=1.351e-7), until="0.02rev")
    return r.command, [close("energy at the start, that of record 6.1 for all [J]", r.ledger["stored at the start [J]"], same.ledger["stored at the start [J]"], 1e-9),
                       differs("without the routine [J]", stored(b), r.ledger["stored at the start [J]"], 1e-2)]


def race_inertia(race, **sets):
    base = {f"raceMass{race}": 0.0704, f"raceMIx{race}": 3.375e-5, f"raceMIy{race}": 1.8775e-5, f"raceMIz{race}": 1.8775e-5}
    zero = {f"{n}{axis}{race}": 0.0 for n in ("raceGeoCen", "raceFrame") for axis in "XYZ"}
    return {f"kRaceIP{race}": 1, **base, **zero, **sets}


FREE = {"kDCR": 1, **{n: 1 for n in ("kFD11", "kFD21", "kFD31", "kFD12", "kFD22", "kFD32", "kMD11", "kMD21", "kMD31", "kMD12", "kMD22", "kMD32")}}


@feature("F088", G)
def _(b):
    out = []
    for race in (1, 2):
        free = {**FREE, f"kFD3{race}": 0}
        # a constant force would join the balance of the start
        push = b.formulas(f"push{race}", {"version": "push", "adrx1": {"outer_race" if race == 1 else "inner_race": {"force": ["0", "0", "2e8*t"]}}})

        def moved(m, force=True):
            c = b.channels(b.run(sets={**free, **race_inertia(race, **{f"raceMass{race}": m})}, until="0.001rev", more=["--user", push] if force else []))
            return c[f"race.z.{race}"][-1] - c[f"race.z.{race}"][0], c["time"][-1]

        light = b.channels(b.run(sets={**free, **race_inertia(race)}, until="0.01rev"))
        for m in (0.0704, 0.704):
            z, t = moved(m)
            out.append(close(f"race {race}, {m} kg: way under a force of 2e8 t more, 2e8 t^3 / 6 m [m]", z - moved(m, False)[0], 2e8 * t**3 / 6 / m, 0.05))
        off = b.run(sets={**free, **race_inertia(race, **{f"raceGeoCenZ{race}": 1e-3})}, until="0.01rev")
        tilt = b.channels(b.run(sets={**FREE, f"kMD2{race}": 0, f"kMD3{race}": 0, **race_inertia(race)}, until="0.01rev"))
        stiff = b.channels(b.run(sets={**FREE, f"kMD2{race}": 0, f"kMD3{race}": 0, **race_inertia(race, **{f"raceMIy{race}": 1.8775e-4, f"raceMIz{race}": 1.8775e-4})},
                                 until="0.01rev"))
        if race == 2:  # the standing outer race feels no offset
            out.append(differs(f"race {race}: place with its mass centre 1 mm off [m]", b.channels(off)[f"race.z.{race}"][-1], light[f"race.z.{race}"][-1], 1e-6))
        out.append(more(f"race {race}: tilt over that with 10 times the transverse inertia", max(abs(v) for v in tilt[f"race.theta.{race}"]) /
                        max(abs(v) for v in stiff[f"race.theta.{race}"]), 2.0))
    return "adore run ball.txt --set kDCR=1 --set kFD32=0 --set kRaceIP2=1 --set raceMass2=0.704 ... --until 0.01rev", out


def cage_inertia(**sets):
    return {"kCageIP": 1, "cageMass": 0.009298, "cageMIx": 8.996e-6, "cageMIy": 4.8388e-6, "cageMIz": 4.8388e-6, "cageGeoCenX": 0.0, "cageGeoCenY": 0.0,
            "cageGeoCenZ": 0.0, "cageFrameX": 0.0, "cageFrameY": 0.0, "cageFrameZ": 0.0, **sets}


@feature("F089", G)
def _(b):
    base = b.run(sets=cage_inertia(), until="0.1rev")
    spin = stored(b, **cage_inertia(cageMIx=9.6e-6)) - stored(b, **cage_inertia())
    heavy = stored(b, **cage_inertia(cageMass=0.018596)) - stored(b, **cage_inertia())
    omega = base.fits["cage"]["speed [rad/s]"]
    off = {axis: b.channels(b.run(sets=cage_inertia(**{f"cageGeoCen{axis}": 5e-5}), until="0.1rev")) for axis in "YZ"}
    frame = b.channels(b.run(sets=cage_inertia(cageMIy=8e-6, cageFrameX=30.0, cageFrameY=5.0), until="0.1rev"))
    c = b.channels(base)
    return base.command[:100] + " ...", [
        close("energy of a larger polar inertia, I w^2 / 2 [J]", spin, 0.5 * (9.6e-6 - 8.996e-6) * omega**2, 0.01),
        close("energy of a mass twice as large: m (e w)^2 / 2 of the whirl and m g z [J]", heavy, 0.009298 * (0.5 * (5e-5 * omega)**2 - 9.81 * 5e-5), 0.02),
        *(more(f"mass centre off by 50 um along {axis}: difference of the cage's place [m]", abs(off[axis][f"cage.position.1.{i}"][-1] - c[f"cage.position.1.{i}"][-1]), 1e-7)
          for axis, i in (("Y", 2), ("Z", 3))),
        differs("tilted principal axes: angular velocity about y [rad/s]", frame["cage.angular_velocity.1.2"][-1], c["cage.angular_velocity.1.2"][-1], 1e-3)]


@feature("F090", G)
def _(b):
    r = b.run(until="0.3rev")
    ring = math.pi / 4 * (0.066**2 - 0.058**2) * 0.017
    pocket = math.pi / 4 * (0.0127 + 0.00025)**2 * 0.004
    rollers = b.run("cylindrical", until="0.01rev")
    cylinder = 7810 * math.pi / 4 * 0.011**2 * 0.012
    cage = r.fits["cage"]["mass [kg]"]
    return r.command, [close("mass of a ball [kg]", mass(r, "ball"), ball_mass(), 1e-4), close("mass of a roller with corners and crown [kg]", mass(rollers, "roller"), cylinder, 0.01),
                       close("mass of the cage: ring less 12 pockets [kg]", cage, 1350 * (ring - 12 * pocket), 0.02),
                       close("polar inertia of the ring, roughly m r^2 [kg m^2]", r.fits["cage"]["moments of inertia x, y, z [kg m^2]"][0], cage * 0.03106**2, 0.02)]


def pocket_head(b, deck, identifier="SOL3", **sets):
    r = b.run(deck, sets={**CENTRED, **sets}, until="0.002rev")
    return r, r.sol(identifier).integers, b.channels(r)


@feature("F091", G)
def _(b):
    r, head, c = pocket_head(b, "ball")
    _, _, wide = pocket_head(b, "ball", bPocCls1=5e-4)
    return r.command, [equal("surfaces per pocket", head[19], 1), close("gap of a centred ball, half of the clearance [m]", c["pocket.gap.1.1"][0], 1.25e-4, 0.05),
                       close("with a clearance of 0.5 mm [m]", wide["pocket.gap.1.1"][0], 2.5e-4, 0.05)]


def spherical_gap(ball, along, radial, bore=0.029, outside=0.033):
    """Distance of a ball to a sphere of 1.25e-4 m more radius that the cage's bore and outside cut, and the angle of the nearest point from the pocket's plane.
    along: offset of the ball in the plane of the pocket, radial: outwards."""
    rho = ball + 1.25e-4
    low, high = math.asin((bore - 0.030) / rho), math.asin((outside - 0.030) / rho)
    phi = min(max(math.atan2(radial, along), low), high)
    return math.hypot(rho * math.cos(phi) - along, rho * math.sin(phi) - radial) - ball, phi


@feature("F092", G)
def _(b):
    out, command = [], ""
    for place, code in (("0,0,0", 1), ("1e-4,0,0", 1), ("0,0,5e-5", 1), ("1e-4,0,0", 0), ("0,0,5e-5", 0)):
        r = b.run(sets={"kPocType": code, "cageGcPos": place}, until="0.002rev")
        command = r.command if code else command
        c = b.channels(r)
        worst = apart = 0.0
        for k in (1, 3, 4, 7):
            t = c[f"element.orbital_position.{k}"][0]
            dx = c[f"element.axial_position.{k}"][0] - c["cage.position.1.1"][0]
            y, z = c["cage.position.1.2"][0], c["cage.position.1.3"][0]
            radial = c[f"element.radial_position.{k}"][0] - r.fits["pitch diameter [m]"] / 2 + y * math.sin(t) - z * math.cos(t)
            along = math.hypot(dx, y * math.cos(t) + z * math.sin(t))
            gap, phi = spherical_gap(D / 2, along, radial) if code else (1.25e-4 - along, 0.0)
            worst = max(worst, abs(c[f"pocket.gap.{k}.1"][0] - gap))
            apart = max(apart, abs(c[f"pocket.phi.{k}.1"][0] - phi))
        name = "spherical" if code else "cylindrical"
        out += [less(f"{name} pocket, cage at {place}: gap of balls 1, 3, 4, 7 against {'a sphere cut by the cage' if code else 'the circle'}; largest departure [m]", worst, 2e-7),
                less("second angle from the plane of the pocket; largest departure [rad]", apart, 0.01)]
    return command, out + [equal("pocket code of the header", pocket_head(b, "ball", kPocType=1)[1][18], 1)]


@feature("F093", G)
def _(b):
    r, head, c = pocket_head(b, "ball", kPocType=2, bPocCls2=2e-4)
    base = pocket_head(b, "ball", kPocType=2, bPocCls2=0.0)[2]
    return r.command, [equal("pocket code of the header", head[18], 2),
                       close("centred ball: axial gap is half of clearance I [m]", base["pocket.gap.1.1"][0], 1.25e-4, 0.05),
                       close("axial gap stays with centres 0.2 mm apart [m]", c["pocket.gap.1.1"][0], 1.25e-4, 0.05),
                       close("start of a cage turned by 0.2 deg: elongated less cylindrical gap [m]",
                             pocket_head(b, "ball", kPocType=2, bPocCls2=2e-4, cageAngPos="0.2,0,0")[2]["pocket.gap.1.1"][0] -
                             pocket_head(b, "ball", kPocType=2, bPocCls2=0.0, cageAngPos="0.2,0,0")[2]["pocket.gap.1.1"][0], 1e-4, 0.2)]


@feature("F094", G)
def _(b):
    r, head, c = pocket_head(b, "ball", kPocType=3, bPocCls2=4e-4)
    g = sorted(c[f"pocket.gap.1.{s}"][0] for s in range(1, 5))
    return r.command, [equal("surfaces per pocket", head[19], 4), close("two gaps are half of clearance I [m]", g[0], 1.25e-4, 0.05),
                       close("two are half of clearance II [m]", g[2], 2e-4, 0.05), equal("values of the record: 24 + 4 x 4 x 12", head[0], 216)]


@feature("F095", G)
def _(b):
    r, head, c = pocket_head(b, "ball", kPocType=4, bPocCls1=2e-4, bPocCls2=6e-4)
    straight = pocket_head(b, "ball", kPocType=4, bPocCls1=4e-4, bPocCls2=4e-4 + 1e-9)[2]
    cone = math.atan2(2e-4, 0.004)
    # the ball is at 1/4 of the wall, 3.5 um from the pocket's axis; distance to the cone less the radius
    wanted = (0.00635 + 1.5e-4) * math.cos(cone) - 0.00635 - 3.5e-6
    return r.command, [equal("pocket code of the header", head[18], 4), close("distance of the ball to the cone [m]", c["pocket.gap.1.1"][0],
                                                                          wanted, 0.02),
                       close("of an almost straight cone [m]", straight["pocket.gap.1.1"][0], 2e-4, 0.05),
                       close("phi, the cone angle [rad]", abs(c["pocket.phi.1.1"][0]), cone, 0.1)]


@feature("F096", G)
def _(b):
    r, head, c = pocket_head(b, "cylindrical")
    return r.command, [equal("surfaces per pocket", head[19], 2), close("gap at the front face, half of the clearance [m]", c["pocket.gap.1.1"][0], 1.25e-4, 0.05),
                       close("at the back face [m]", c["pocket.gap.1.2"][0], 1.25e-4, 0.05)]


@feature("F097", G)
def _(b):
    r, head, c = pocket_head(b, "cylindrical", kPocType=-1)
    _, _, wide = pocket_head(b, "cylindrical", kPocType=-1, bPocCls1=4e-4)
    return r.command, [equal("surfaces per pocket", head[19], 1), close("gap of a centred roller [m]", c["pocket.gap.1.1"][0], 1.25e-4, 0.1),
                       close("with a clearance of 0.4 mm [m]", wide["pocket.gap.1.1"][0], 2e-4, 0.1)]


PAIR = {"kPocType": 1, "bPocGsAng1[1]": 0.0, "bPocGsAng2[1]": 0.0, "bPocGsAng3[1]": 0.0, "bPocGsCen1[1]": 0.0, "bPocGsCen2[1]": 0.0057, "bPocGsCen3[1]": 0.0,
        "bPocGsLen1[1]": 0.004, "bPocGsLen2[1]": 0.012}


@feature("F098", G)
def _(b):
    r, head, c = pocket_head(b, "cylindrical", **PAIR)
    two = {**PAIR, "kPocType": 2, **{k.replace("[1]", "[2]"): v for k, v in PAIR.items() if "[1]" in k}, "bPocGsCen2[2]": 0.0058, "bPocGsCen1[2]": 0.003}
    r2, head2, c2 = pocket_head(b, "cylindrical", **two)
    inside = b.run("cylindrical", sets={**PAIR, "bPocGsCen2[1]": 0.005}, until="0.002rev", check=False)
    varied = b.run("cylindrical", sets={**PAIR, "kCagePocImp": 2, **{n: 0.0 for n in POCKET}, "bPocClsVar1": -1e-3}, until="0.002rev", check=False)
    return r.command[:140] + " ...", [
        close("gap of the pair at y = 5.7 mm, radius 5.5 mm [m]", c["pocket.gap.1.1"][0], 2e-4, 0.05), equal("surfaces of one pair", head[19], 2),
        equal("surfaces of two pairs", head2[19], 4), close("gap of the second pair at 5.8 mm [m]", c2["pocket.gap.1.3"][0], 3e-4, 0.2),
        equal("faces inside the rollers (y = 5.0 mm): exit code", inside.code, 2),
        equal("and the text names bPocGsCen2", "bPocGsCen2" in inside.err, True),
        equal("faces inside by a clearance deviation of -1 mm: exit code", varied.code, 2),
        equal("and the text names bPocClsVar1", "bPocClsVar1" in varied.err, True)]


@feature("F099", G)
def _(b):
    r = b.run(until="0.002rev", sets={"cageDia1": 0.065, "cageDia2": 0.057, "cageWidth": 0.015, "cageCls1": 0.0004, "cageCls2": 0.003})
    ring = math.pi / 4 * (0.065**2 - 0.057**2) * 0.015
    pocket = math.pi / 4 * (0.0127 + 0.00025)**2 * 0.004
    play = r.fits["cage play, diametral"]
    return r.command, [close("mass of the ring less 12 pockets [kg]", r.fits["cage"]["mass [kg]"], 1350 * (ring - 12 * pocket), 0.02),
                       close("cold clearance to the outer race [m]", play["cage outside to the outer race"]["cold [m]"], 0.0004, 1e-9),
                       close("to the inner race [m]", play["cage bore to the inner race"]["cold [m]"], 0.003, 1e-9)]


@feature("F100", G)
def _(b):
    base = gaps(b, **CENTRED)
    wide = gaps(b, bPocCls1=3.5e-4, **CENTRED)
    rect = [gaps(b, kPocType=3, bPocCls2=4e-4, surface=s, **CENTRED)[0] for s in (1, 2, 3, 4)]
    cone = gaps(b, kPocType=4, bPocCls1=2e-4, bPocCls2=6e-4, **CENTRED)
    return "adore run ball.txt --set bPocCls1=3.5e-4 --set cageGcPos=0,0,0 --until 0.002rev", [
        close("cylinder: gap changes by half of the change of I [m]", wide[0] - base[0], 5e-5, 0.02),
        close("rectangle: axial gap is half of II [m]", sorted(rect)[2], 2e-4, 0.05), close("cone: I and II at the ball's place in the wall [m]", cone[0], (0.00635 + 1.5e-4) * math.cos(math.atan(0.05)) - 0.00635 - 3.5e-6, 0.02)]


@feature("F101", G)
def _(b):
    cone, flat = b.run("tapered", until="0.002rev", sets=CENTRED), b.run("tapered", sets={**CENTRED, "cageConeAng": 11.0}, until="0.002rev")
    c, f = b.channels(cone), b.channels(flat)
    m = [r.fits["cage"]["mass [kg]"] for r in (cone, flat)]
    i = [r.fits["cage"]["moments of inertia x, y, z [kg m^2]"][1] for r in (cone, flat)]
    return flat.command, [differs("transverse inertia of a cage of 11 deg, that of 12.275 deg [kg m^2]", i[1], i[0], 1e-4), more("mass [kg]", m[0], 1e-3),
                          differs("gap of roller 1 in its pocket [m]", f["pocket.gap.1.1"][0], c["pocket.gap.1.1"][0], 1e-5)]


def guided(b, race, **sets):
    return b.run(sets={"iCageGuide": f"{race},{race}", "cageGcPos": "0,0,-1.6e-4" if race == 1 else "0,0,-1.6e-4", **sets}, until="0.02rev")


INNER_LANDS = {"cageGsDia[1]": 0.058, "cageGsDia[2]": 0.058, "cageCls2": 0.0003, "cageCls1": 0.004}


@feature("F102", G)
def _(b):
    r = b.run(until="0.3rev")
    slow = b.run(sets={"gravityVecZ": -3000.0}, until="0.1rev")
    heat = slow.ledger["heat, guide lands [J]"]
    c = b.channels(slow)
    speed = 0.033 * sum(c["cage.angular_velocity.1.1"]) / len(c["time"])
    rate = sum(c[f"cage.land{k}_force.1"][t] * (c["time"][t] - c["time"][t - 1]) for k in (1, 2) for t in range(1, len(c["time"])))
    return slow.command, [equal("land 1 is on the outer race", "guide land 1 on the outer race" in r.fits["cage play, diametral"], True),
                          between("heat of the lands over impulse, friction 0.06 and the slip r w (standing race)", heat / (0.06 * speed * rate), 0.6, 1.2)]


@feature("F103", G)
def _(b):
    r = b.run(sets={"iCageGuide": "2,2", **INNER_LANDS, "gravityVecZ": -3000.0}, until="0.1rev")
    c = b.channels(r)
    speed = 0.029 * (10000 * math.pi / 30 - sum(c["cage.angular_velocity.1.1"]) / len(c["time"]))
    rate = sum(c[f"cage.land{k}_force.1"][t] * (c["time"][t] - c["time"][t - 1]) for k in (1, 2) for t in range(1, len(c["time"])))
    return r.command, [equal("land 1 is on the inner race", "guide land 1 on the inner race" in r.fits["cage play, diametral"], True),
                       between("heat of the lands over impulse, friction 0.06 and the slip against the inner race", r.ledger["heat, guide lands [J]"] /
                               (0.06 * speed * rate), 0.6, 1.2)]


@feature("F104", G)
def _(b):
    r = b.run("ball-thrust", until="0.05rev", sets={"gravityVecZ": -3000.0})
    s = r.sol("SOL3").values
    c = b.channels(r)
    return r.command, [equal("land values of SOL3", max(abs(v) for row in s for v in row[3:9]), 0.0),
                       equal("items of guide lands in the ledger", sum("guide lands" in k for k in r.ledger), 0),
                       more("fall of the cage, which only pockets stop [m]", c["cage.position.1.3"][0] - c["cage.position.1.3"][-1], 1e-5)]


FOUR = {"nGL": 4, "iCageGuide": "1,1,1,1", **{f"cageGsDia[{k}]": 0.066 for k in (1, 2, 3, 4)}, **{f"cageGsWidth[{k}]": 0.001 for k in (1, 2, 3, 4)},
        "cageGsPos[1]": -0.0085, "cageGsPos[2]": 0.0085, "cageGsPos[3]": -0.0073, "cageGsPos[4]": 0.0073,
        "cageGsCls[1]": 3e-4, "cageGsCls[2]": 3.2e-4, "cageGsCls[3]": 3.4e-4, "cageGsCls[4]": 3.6e-4}


@feature("F105", G)
def _(b):
    r = b.run(sets=FOUR, until="0.02rev")
    play = r.fits["cage play, diametral"]
    cold = [v["cold [m]"] for k, v in play.items() if k.startswith("guide land")]
    c = b.channels(r)
    lands = [k for k in c if k.startswith("land.gap.1.")]
    return r.command[:120] + " ...", [equal("lands", len(cold), 4), close("clearance of land 4 [m]", cold[3], 3.6e-4, 1e-9),
                                      equal("gaps in RESULTS.h5", len(lands), 4),
                                      close("gap of land 4 less that of land 1 at the start [m]", c[lands[3]][0] - c[lands[0]][0], 3e-5, 0.05)]


CUT = {"nCseg": 3, "cageAngCut": 2.0, "kPltElemInd": "1,13,14,15", "appLoadZ": 200.0}


@feature("F106", G)
def _(b):
    between_, through = b.run("ball-thrust", sets={**CUT, "lSeg": "1,5,9"}), b.run("ball-thrust", sets={**CUT, "lSeg": "-1,-5,-9"})
    heads = [r.sol("SOL2").integers for r in (between_, through)]
    uneven = b.run("ball-thrust", sets={**CUT, "lSeg": "1,4,9"}, check=False)
    film = b.run("ball-thrust", sets={**CUT, "lSeg": "1,5,9", "kPocHydro": 1, "pocVis": 0.01, "gsVis": 0.01}, check=False)
    off = [e for e in film.json["plan"]["effects"] if e["name"] == "pocket films"] if film.code == 0 else [{"on": False}]
    return through.command, [equal("values per step, cut between pockets: 24 + 4 x 4", heads[0][0], 40),
                             equal("cut through pockets: one half pocket more, 24 + 4 x 5", heads[1][0], 44),
                             equal("uneven segments: exit code", uneven.code, 2), equal("pocket films of segments", off[0]["on"], False)]


@feature("F107", G)
def _(b):
    r = b.run(sets={"cageGcPos": "1e-5,2e-5,-6e-5", "cageAngPos": "0,0.1,0.05", "wvRatio": 0.5, "avRatio": 0.9}, until="0.002rev")
    c = b.channels(r)
    s = r.sol("SOL3").values[0]
    base = b.channels(b.run(until="0.3rev"))["cage.angular_velocity.1.1"][0]
    omega = c["cage.angular_velocity.1.1"][0]
    velocity = math.hypot(c["cage.velocity.1.2"][0], c["cage.velocity.1.3"][0])
    arm = math.hypot(c["cage.position.1.2"][0], c["cage.position.1.3"][0])
    return r.command, [close("y at the start [m]", c["cage.position.1.2"][0], 2e-5, 1e-6), close("z at the start [m]", c["cage.position.1.3"][0], -6e-5, 1e-6),
                       close("speed over that with avRatio 1", omega / base, 0.9, 1e-3), close("whirl speed over the cage's speed", velocity / arm / omega, 0.5, 0.01),
                       close("z over the mean land clearance in SOL3", s[14], -6e-5 / 1.48919e-4, 5e-3),
                       close("tilt of the cage axis, angles of 0.1 and 0.05 deg [deg]", math.hypot(s[18], s[19]), math.hypot(0.1, 0.05), 0.02)]


@feature("F108", G)
def _(b):
    r = b.run("ball-thrust", sets={**CUT, "lSeg": "1,5,9", "avRatio[2]": 0.95, "wvRatio[3]": 0.9, "cageGcPos[2,1]": 0.0}, until="0.002rev", check=False)
    if r.code != 0:
        r = b.run("ball-thrust", sets={**CUT, "lSeg": "1,5,9", "avRatio[2]": 0.95}, until="0.002rev")
    c = b.channels(r)
    w = [c[f"cage.angular_velocity.{k}.1"][0] for k in (1, 2, 3)]
    return r.command, [close("speed of segment 2 over that of segment 1", w[1] / w[0], 0.95, 1e-3), close("of segment 3", w[2] / w[0], 1.0, 1e-6)]


@feature("F109", G)
def _(b):
    out, command = [], ""
    for ratio, angle in ((1.2, 0.0), (0.8, math.pi)):
        r = b.run(sets={"avRatio": ratio, "cageGcPos": "0,0,0"}, until="0.05rev")
        command = r.command
        c = b.channels(r)
        first = [next((t for t in range(len(c["time"])) if c[f"pocket.force.{k}.1"][t] > 1.0), None) for k in range(1, 13)]
        found = [c[f"pocket.theta.{k + 1}.1"][t] for k, t in enumerate(first) if t is not None]
        near = sum(math.cos(v - angle) > 0.8 for v in found)
        out.append(more(f"cage at {ratio} of its speed: share of first contacts near {math.degrees(angle):.0f} deg", near / max(len(found), 1), 0.8))
    return command, out


@feature("F110", G)
def _(b):
    r = b.run(sets={"gravityVecZ": -3000.0}, until="0.1rev")
    c = b.channels(r)
    t = max(range(len(c["time"])), key=lambda i: c["cage.land1_force.1"][i])
    turned = c["cage.rotation.1"][t] - c["cage.rotation.1"][0]
    down = math.atan2(-c["cage.position.1.2"][t], c["cage.position.1.3"][t])
    film = b.run(sets={"kGsHydro": 1, "pocVis": 0.02, "gsVis": 0.02}, until="0.3rev")
    f = b.channels(film)
    attitude = [v for v in f["land.attitude.1.1"][1:] if not math.isnan(v)]
    return r.command, [close("contact angle at land 1 in the cage frame: place of the least gap less the turn [rad], cosine of the difference",
                             math.cos(c["cage.land1_angle.1"][t] - (down - turned)), 1.0, 0.02),
                       between("size of the attitude angle of a short journal [rad], 0 to pi/2", abs(sum(attitude) / len(attitude)), 0.05, math.pi / 2)]
