"""Solver modes, integrators and race constraints (F001 to F030)."""

import math
import os
import shutil

import hertz
from bench import between, close, differs, equal, feature, less, more, not_checked

G = "modes"


def ball_mass(b):
    """Of the density of 52100 as PRINT.txt has it."""
    r = b.run(until="0.3rev")
    return r.listed("Density", 0)[0] * math.pi / 6 * 0.0127**3


def constant(columns):
    """The largest span of any of the lists."""
    return max(max(c) - min(c) for c in columns)


@feature("F001", G)
def _(b):
    r = b.static(opts={"ballFriction": "spin-rule"})  # balls in balance of friction load the inner race by traction, too
    e = r.elements
    thrust = sum(q * math.sin(math.radians(a)) for q, a in zip(e["inner load [N]"], e["inner contact angle [deg]"]))
    radial = sum(q * math.cos(math.radians(a)) * math.cos(math.radians(t))
                 for q, a, t in zip(e["inner load [N]"], e["inner contact angle [deg]"], e["azimuth [deg]"]))
    return r.command, [close("sum of Q sin a, inner race [N]", thrust, 1500.0, 1e-6), close("sum of Q cos a cos t (without the shift of azimuths by displacement) [N]", radial, 500.0, 5e-4),
                       equal("SOL files written", sum(r.has(f"SOL{k}") for k in range(1, 10)), 0),
                       equal("pages of the result in PRINT.txt", r.listing.count("QUASI-STATIC") > 0, True)]


@feature("F002", G)
def _(b):
    r = b.run(until="0.3rev")
    s = r.sol("SOL1")
    worst = 0.0
    for k in range(2, len(s.steps) - 1):
        dt = s.times[k + 1] - s.times[k - 1]
        turned = (s.values[k + 1][6] - s.values[k - 1][6]) % 360.0
        worst = max(worst, abs(turned / 360.0 / dt * 60.0 / s.values[k][3] - 1.0))
    momentum = r.json["conservation"]["momentum"]
    bodies = {x["name"]: x["unknowns"] for x in r.json["plan"]["bodies"]}
    return r.command, [less("energy residual over energy moved", r.ledger["residual over energy moved"], 1e-6),
                       less("momentum residual over momentum carried", momentum["linear residual over momentum carried"], 1e-10),
                       less("angular momentum residual", momentum["angular residual over momentum carried"], 1e-10),
                       equal("unknowns of 12 balls: 9 rates and places, 4+1 of orientation", bodies["balls (12)"] +
                             bodies["orientation of balls (12)"], 12 * 14),
                       less("d(orbital position)/dt against orbital velocity", worst, 2e-3)]


@feature("F003", G)
def _(b):
    # By race control the orbits differ little, and no ball reaches its pocket in this time.
    r = b.run(sets={"mode": 1, "reRaceTC2": 1e-6, "reRaceTC3": 5e-7}, opts={"ballFriction": "spin-rule"})  # hardly any friction, whose components are not stored
    c = b.channels(r)
    m = ball_mass(b)
    worst_r = worst_x = 0.0
    for k in range(1, 13):
        for t in range(len(c["time"])):
            qo, qi = c[f"contact.load.{k}.1"][t], c[f"contact.load.{k}.2"][t]
            ao, ai = c[f"contact.angle.{k}.1"][t], c[f"contact.angle.{k}.2"][t]
            force = m * c[f"element.radial_position.{k}"][t] * c[f"element.orbital_velocity.{k}"][t]**2
            worst_r = max(worst_r, abs(qo * math.cos(ao) - qi * math.cos(ai) - force))
            worst_x = max(worst_x, abs(qo * math.sin(ao) - qi * math.sin(ai)))
    s = r.sol("SOL1")
    # gravity (0.08 N) remains outside of these two sums
    return r.command, [less("radial balance Qo cos a - Qi cos a - m w^2 r of all balls [N]", worst_r, 0.5),
                       less("axial balance of all balls [N]", worst_x, 0.5),
                       equal("largest radial velocity [m/s]", max(abs(v) for v in s.column(5)), 0.0),
                       less("motion of the inner race along x [m]", constant([c["race.x.2"]]), 1e-15)]


@feature("F004", G)
def _(b):
    r = b.run(sets={"mode": 2})
    c = b.channels(r)
    s = r.sol("SOL4")
    other = b.run(sets={"mode": 1})
    late = s.column(4)[len(s.steps) // 2:]
    return r.command, [close("force of the elements on the inner race along x, second half, mean [N]", sum(late) / len(late), 1500.0, 0.01),
                       less("largest departure from 1500 N at any step [N]", max(abs(v - 1500.0) for v in s.column(4)), 15.0),
                       more("motion of the inner race along z [m]", constant([c["race.z.2"]]), 1e-12),
                       less("the same in mode 1 [m]", constant([b.channels(other)["race.z.2"]]), 1e-15)]


def spans(b, kdof, names, deck="ball", **more_sets):
    r = b.run(deck, sets={"kDOF": kdof, **more_sets})
    c = b.channels(r)
    return r, {n: constant([v for key, v in c.items() if key == n or key.startswith(n + ".")]) for n in names}


START = {"cageGcPos": "2e-5,0,-5e-5", "cageAngPos": "0,0.05,0.02", "gravityVecX": 5.0}
NAMES = ["element.axial_velocity", "cage.axial_velocity", "cage.angular_velocity.1.2", "cage.angular_velocity.1.3",
         "element.radial_velocity"]


def suppressed(identifier, kdof, still, moving):
    @feature(identifier, G)
    def _(b):
        r, s = spans(b, kdof, NAMES, deck="ball", **{"cageGcPos": "2e-5,0,-5e-5", "cageAngPos": "0,0.05,0.02", "gravityVecX": 5.0})
        _, free = spans(b, 0, NAMES, deck="ball", **{"cageGcPos": "2e-5,0,-5e-5", "cageAngPos": "0,0.05,0.02", "gravityVecX": 5.0})
        out = [less(f"span of {n}", s[n], 1e-8) for n in still]
        out += [more(f"span of {n}", s[n], 1e-6) for n in moving]
        out += [more(f"span of {n} with kDOF 0", free[n], 1e-6) for n in still]
        return r.command, out


suppressed("F005", 1, NAMES[:2], NAMES[2:])
suppressed("F006", 2, NAMES[:4], NAMES[4:])
suppressed("F007", 3, NAMES[:1], NAMES[1:])


@feature("F008", G)
def _(b):
    r, s = spans(b, 4, NAMES, **START)
    c, c3 = b.channels(r), b.channels(spans(b, 3, NAMES, **START)[0])
    tilt = [f"element.angular_velocity_vector.{k}.{a}" for k in range(1, 13) for a in (2, 3)]
    return r.command, [less("span of the balls' axial velocity", s[NAMES[0]], 1e-12), more("span of the cage's axial velocity", s[NAMES[1]], 1e-6),
                       less("span of the balls' transverse angular velocity [rad/s]", constant([c[n] for n in tilt]), 1e-6),
                       more("the same with kDOF 3 [rad/s]", constant([c3[n] for n in tilt]), 1e-2)]


@feature("F009", G)
def _(b):
    r, s = spans(b, 5, NAMES + ["element.orbital_velocity"])
    c = b.channels(r)
    orbit = [v for k, v in c.items() if k.startswith("element.orbital_velocity.")]
    spread = max(max(v) - min(v) for v in orbit)
    other = spans(b, 0, ["element.orbital_velocity"])[0]
    orbit0 = [v for k, v in b.channels(other).items() if k.startswith("element.orbital_velocity.")]
    return r.command, [less("change of any ball's orbital velocity [rad/s]", spread, 1e-9), less("radial velocity [m/s]", s[NAMES[4]], 1e-12),
                       more("change with kDOF 0 [rad/s]", constant(orbit0), 1e-2),
                       more("acceleration of the cage [rad/s^2]", constant([c["cage.orbital_acceleration.1"]]), 1e-3)]


@feature("F010", G)
def _(b):
    plug = b.plug_in("suppress", "int32_t adrx1(adore_adrx1* a) { if (a->call.mode == ADORE_READ) a->call.active = 1; "
                     "if (a->call.mode == ADORE_START) a->suppress_element_axial = 1; return 0; }\n")
    r = b.run(sets={"kDOF": 6}, more=["--user", plug])
    three = b.run(sets={"kDOF": 3})
    c, c3 = b.channels(r), b.channels(three)
    axial = [v for k, v in c.items() if k.startswith("element.axial_velocity.")]
    return r.command.replace(b.folder + "/", ""), [
        less("span of the balls' axial velocity [m/s]", constant(axial), 1e-12),
        close("contact load of ball 1 at the end, as by kDOF 3 [N]", c["contact.load.1.1"][-1], c3["contact.load.1.1"][-1], 1e-9)]


@feature("F011", G)
def _(b):
    light = {"appLoadX": 200.0, "appLoadZ": 2000.0}
    r = b.run(sets={**light, "qFac": 0.05})
    free = b.run(sets=light)
    c, c0 = b.channels(r), b.channels(free)
    still = [k for k in range(1, 13) if max(abs(v) for v in c[f"element.radial_velocity.{k}"][1:]) == 0.0]
    held = [k for k in range(1, 13) if max(c[f"contact.load.{k}.1"]) <= 0.05 * 2000.0]
    tilted = {"appMis12": 3e-4}
    rollers = b.run("cylindrical", sets={"qFac": 0.1, **tilted})
    cr = b.channels(rollers)
    tilt = {k: max(abs(v) for v in cr[f"element.phi.{k}"]) for k in range(1, 15) if k in (3, 13) and not any(cr[f"element.radial_velocity.{k}"][1:])}
    plain = b.channels(b.run("cylindrical", sets=tilted))
    other = max(max(abs(v) for v in plain[f"element.phi.{k}"]) for k in tilt)
    return rollers.command, [more("quasi-static balls without radial velocity", len(still), 0),
                             equal("all of them below qFac", all(k in still for k in held) and bool(held), True),
                             equal("none of them without qFac", sum(max(abs(v) for v in c0[f"element.radial_velocity.{k}"][1:]) == 0.0
                                                                   for k in range(1, 13)), 0),
                             more("held rollers", len(tilt), 0),
                             less("largest skew angle of quasi-static rollers [rad]", max(tilt.values()), 1e-9),
                             more("the same rollers without qFac [rad]", other, 1e-9),
                             differs("switches of held elements in the ledger of energy [J]", rollers.ledger["switches of held elements [J]"], 0.0, 1e-9),
                             less("energy residual over energy moved", rollers.ledger["residual over energy moved"], 1e-4)]


@feature("F012", G)
def _(b):
    # The weight of the balls is in the start, not in mode -1: none here. Balls start in balance of friction, as in mode -1.
    r, s = b.run(sets={"gravityVecZ": 0.0}, until="0.0005rev"), b.static()
    c = b.channels(r)
    held = {"kFS1": 1, "kFS2": 1, "kFS3": 1, **{f"appDisp{a.upper()}": s.summary[f"displacement_{a}_m"] for a in "xyz"}}
    same = b.static(sets=held).elements
    pairs = [(k, j, n) for k in range(1, 13) for j, n in ((1, "outer"), (2, "inner"))]
    load = max(abs(c[f"contact.load.{k}.{j}"][0] / same[f"{n} load [N]"][k - 1] - 1.0) for k, j, n in pairs)
    angle = max(abs(math.degrees(c[f"contact.angle.{k}.{j}"][0]) - same[f"{n} contact angle [deg]"][k - 1]) for k, j, n in pairs)
    tight = b.channels(b.run(sets={"gravityVecZ": 0.0, "appLoadX": 3000.0}, until="0.0005rev"))
    return r.command, [close("displacement of the inner race x at step 0, that of mode -1 [m]", c["race.x.2"][0], s.summary["displacement_x_m"], 1e-3),
                       close("z [m]", c["race.z.2"][0], s.summary["displacement_z_m"], 1e-3), less("contact loads of step 0 against mode -1 with the same displacement and friction, relative", load, 0.02),
                       less("contact angles [deg]", angle, 0.2),
                       close("twice the thrust: sum of Q sin a of step 0 over that before", thrust_of(tight) / thrust_of(c), 2.0, 0.05)]


def thrust_of(c, t=0):
    return sum(c[f"contact.load.{k}.2"][t] * math.sin(c[f"contact.angle.{k}.2"][t]) for k in range(1, 13))


@feature("F013", G)
def _(b):
    first = b.run(until="0.1rev")
    out = os.path.join(b.folder, "from-final")
    os.makedirs(out, exist_ok=True)
    shutil.copy(first.path("FINAL"), out)
    words = ["run", b.deck("ball"), "--set", "kIcOpt=-1", "--out", out, "--until", "0.02rev", "--quiet", "--overwrite"]
    before = open(os.path.join(out, "FINAL"), encoding="utf-8").read()
    b.call(*words)
    from bench import Sol
    new = Sol(open(os.path.join(out, "SOL1"), encoding="utf-8").read())
    old = first.sol("SOL1")
    plain = b.run(until="0.02rev").sol("SOL1")
    refused = os.path.join(b.folder, "from-final-2")
    os.makedirs(refused, exist_ok=True)
    shutil.copy(first.path("FINAL"), refused)
    done = b.call("run", b.deck("ball"), "--set", "kIcOpt=-1", "--out", refused, "--until", "0.02rev", "--quiet", check=False)
    kept = open(os.path.join(refused, "FINAL"), encoding="utf-8").read()
    return "adore run ball.txt --set kIcOpt=-1 --until 0.02rev --out from-final", [
        close("orbital speed of ball 1 at the start, that of the end of the first run [rpm]", new.values[0][3], old.values[-1][3], 1e-7),
        close("angular velocity of ball 1 at the start [rpm]", new.values[0][12], old.values[-1][12], 1e-7),
        equal("time of the first step [s]", new.steps[0][4], 0.0), differs("orbital speed of a start from statics", plain.values[0][3], new.values[0][3]),
        equal("without --overwrite: the text names FINAL as the start, or the run starts", done.returncode == 0 or
              ("FINAL" in done.stderr and "the start state of this run" in done.stderr), True),
        equal("FINAL of the first run kept where the run did not start", done.returncode == 0 or kept == before, True)]


@feature("F014", G)
def _(b):
    out = os.path.join(b.folder, "continued")
    deck = b.deck("ball")
    b.call("run", deck, "--out", out, "--until", "0.1rev", "--quiet")
    from bench import Sol
    first = Sol(open(os.path.join(out, "SOL1"), encoding="utf-8").read())
    b.call("run", deck, "--out", out, "--until", "0.2rev", "--continue", "--quiet")
    both = Sol(open(os.path.join(out, "SOL1"), encoding="utf-8").read())
    whole = b.run(until="0.2rev").sol("SOL1")
    n = len(first.steps)
    return "adore run ball.txt --out continued --until 0.2rev --continue", [
        equal("steps of the first part kept", both.values[:n] == first.values, True), more("steps appended", len(both.steps) - n, 10),
        equal("step numbers rise by 1", all(y[0] - x[0] == 1 for x, y in zip(both.steps, both.steps[1:])), True),
        close("orbital speed at the end against one run [rpm]", both.values[-1][3], whole.values[-1][3], 1e-6),
        between("first step size of the second part over the last of the first", both.steps[n][3] / first.steps[n - 2][3], 0.3, 3.0)]


@feature("F015", G)
def _(b):
    r = b.run(until="0.3rev")
    c = b.channels(r)
    lines = r.read("SOL8").splitlines()
    values = []
    for line in lines[5:5 + 12]:
        values += [float(line[2 + 10 * k:12 + 10 * k]) for k in range(13) if line[2 + 10 * k:12 + 10 * k].strip()]
    # a later frame: the frames are 1 + ceil(154/13) lines long
    frames = (len(lines) - 4) // 13
    at = 4 + 13 * (frames - 1)
    values = []
    for line in lines[at + 1:at + 13]:
        values += [float(line[2 + 10 * k:12 + 10 * k]) for k in range(13) if line[2 + 10 * k:12 + 10 * k].strip()]
    step = int(lines[at][2:18])
    t = int(c["step"].index(step))
    x, radial, orbital = values[0:3]
    eta, xi, lam = values[11 * 4 + 3:11 * 4 + 6]
    q = [c[f"element.orientation.5.{a}"][t] for a in (1, 2, 3, 4)]
    axis = quaternion_x(q)
    # eta about x, xi about the new y, lambda about the newest z: the body's x axis in the base frame
    ce, se, cx, sx, cl, sl = math.cos(eta), math.sin(eta), math.cos(xi), math.sin(xi), math.cos(lam), math.sin(lam)
    mine = [cx * cl, ce * sl + se * sx * cl, se * sl - ce * sx * cl]
    apart = max(abs(abs(u) - abs(v)) for u, v in zip(mine, axis))
    return r.command, [close("radial position of SOL8, RESULTS.h5 [m]", radial, c["element.radial_position.1"][t], 5e-3),
                       close("orbital position modulo a turn [rad]", orbital % (2 * math.pi), c["element.orbital_position.1"][t] % (2 * math.pi), 5e-3, 2e-3),
                       less("x axis of ball 5 by three angles against its quaternion", apart, 0.02),
                       close("y^2 + z^2 of the cage's rectangular coordinates, its radius [m]",
                             math.hypot(c["cage.position.1.2"][t], c["cage.position.1.3"][t]), c["cage.radial_position.1"][t], 1e-6)]


def quaternion_x(q):
    w, x, y, z = q
    return [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)]


NO_CAGE = {"nCseg": 0, "kNumPltElem": 1, "kPltElemInd": 1}


def end_state(b, method, step, until="0.004rev"):
    """Radial velocities of the balls at the end, and the step that was taken: the program shortens steps at which the method is unstable."""
    r = b.run(until=until, sets={**NO_CAGE, "intMet": method, "stpInit": step, "stpMin": step, "stpMax": step, "nStps": 1, "tol": 1e-3},
              opts={"ballFriction": "spin-rule"})  # a start out of balance: radial velocities of mm/s
    c = b.channels(r)
    return r, [c[f"element.radial_velocity.{k}"][-1] for k in range(1, 13)], r.sol("SOL1").steps[1][3] / r.json["scales"]["time [s]"]


def orders(b, methods):
    """Constant steps h and h/2 against order 7 with h = 0.01; errors of high orders reach rounding, so that their sizes are compared."""
    out, command = [], ""
    for method, order, step, until in methods:
        _, exact, _ = end_state(b, 7, 0.01, until)
        r, coarse, h = end_state(b, method, step, until)
        command = r.command
        error = math.dist(coarse, exact)
        if order > 6:
            out.append(less(f"order {order}: error at h = {step} [m/s]", error, 1e-9))
            continue
        _, fine, half = end_state(b, method, step / 2, until)
        out.append(between(f"order {order}: slope of the error between h = {h:.4g} and {half:.4g}", math.log(error / math.dist(fine, exact)) / math.log(h / half),
                           order - 0.4, order + 1.5))
    return command, out


@feature("F016", "integrators")
def _(b):
    return orders(b, [(m, m, h, "0.004rev") for m, h in ((1, 0.003), (2, 0.2), (3, 0.05), (4, 0.1), (5, 0.2), (6, 0.4), (7, 0.4))])


@feature("F017", "integrators")
def _(b):
    # Orders 2 and 4 reach their slope later: the values of the start, of order 4, take part in few steps.
    short, long = "0.004rev", "0.016rev"
    return orders(b, [(11, 1, 0.1, short), (12, 2, 0.025, short), (13, 3, 0.025, short), (14, 4, 0.05, long), (15, 5, 0.1, short), (16, 6, 0.2, short), (17, 7, 0.1, short),
                      (18, 8, 0.1, short)])


@feature("F018", "integrators")
def _(b):
    loose, tight = b.run(sets={"tol": 1e-4, "stpMax": 2.0, "stpMin": 1e-6}), b.run(sets={"tol": 1e-9, "stpMax": 2.0, "stpMin": 1e-6})
    wide = b.run()
    scale = wide.json["scales"]["time [s]"]
    steps = [s[3] for s in wide.sol("SOL1").steps[1:]]
    low = b.run(sets={"tol": 1e-13, "stpMin": 0.2})
    return tight.command, [more("steps with tol 1e-9 over those with 1e-4", tight.json["counters"]["steps"] / loose.json["counters"]["steps"], 1.3),
                           close("largest step over the time scale, stpMax = 0.5", max(steps) / scale, 0.5, 1e-6),
                           more("smallest step over the time scale, tol 1e-13, stpMin = 0.2", min(s[3] for s in low.sol("SOL1").steps[1:-1]) / scale,
                                0.2 * (1 - 1e-6)),
                           more("steps accepted at the minimum", low.json["counters"]["at_minimum"], 10),
                           less("estimate of the largest local error, tol 1e-9", tight.json["error estimates of the steps"]["largest"], 1e-8)]


@feature("F019", "integrators")
def _(b):
    a, c = b.run(sets={"stpInit": 0.05, "nStps": 1}), b.run(sets={"stpInit": 0.01, "nStps": 1})
    scale = a.json["scales"]["time [s]"]
    out = os.path.join(b.folder, "zero")
    deck = b.deck("ball")
    b.call("run", deck, "--out", out, "--until", "0.05rev", "--set", "nStps=1", "--quiet")
    done = b.call("run", deck, "--out", out, "--until", "0.1rev", "--set", "nStps=1", "--set", "stpInit=0", "--set", "kIcOpt=1", "--quiet", check=False)
    from bench import Sol
    s = Sol(open(os.path.join(out, "SOL1"), encoding="utf-8").read())
    n = len(b.run(until="0.05rev", sets={"nStps": 1}).sol("SOL1").steps)
    ratio = s.steps[n][3] / s.steps[n - 2][3] if len(s.steps) > n else 0.0
    return a.command, [close("first step over the time scale, stpInit = 0.05", a.sol("SOL1").steps[1][3] / scale, 0.05, 1e-6),
                       close("first step over the time scale, stpInit = 0.01", c.sol("SOL1").steps[1][3] / scale, 0.01, 1e-6),
                       equal("continuation with stpInit = 0: exit code", done.returncode, 0),
                       between("its first step over the last of the first run", ratio, 0.5, 2.0)]


@feature("F020", G)
def _(b):
    r = b.run(until="0.3rev")
    scales = r.json["scales"]
    heavy = b.run(sets={"appLoadX": 3000.0, "appLoadZ": 1000.0})
    # ts = sqrt(m / k), k = dQ/d(delta) = 1.5 Q / delta of the stiffest contact
    m = ball_mass(b)
    k = m / scales["time [s]"]**2
    listed = r.listing
    e = b.static().elements
    q, angle = e["outer load [N]"][0], math.radians(e["outer contact angle [deg]"][0])
    # A Hertz contact has k proportional to Q^(1/3); loads double, so ts falls by about 2^(-1/6)
    return r.command, [close("length scale: ball radius [m]", scales["length [m]"], 0.00635, 1e-9), close("force scale [N]", scales["force [N]"], 1500.0, 1e-9),
                       close("m / ts^2, stiffness 1.5 Q / d of the heaviest contact by Hertz [N/m]", k, 1.5 * q / hertz.ball_on_race(q, 0.0127, 0.06, 0.520, angle, 1)[3], 0.02),
                       close("force scale at twice the load [N]", heavy.json["scales"]["force [N]"], 3000.0, 1e-9),
                       between("time scale at twice the load over that before", heavy.json["scales"]["time [s]"] / scales["time [s]"], 0.85, 0.93),
                       equal("PRINT.txt has the time scale", f"{scales['time [s]']:.5e}"[:6] in listed, True)]


@feature("F021", G)
def _(b):
    a = b.run(until=None, sets={"maxStps": 17})
    c = b.run(until=None, sets={"fTime": 50.0})
    return a.command, [equal("steps with maxStps = 17", a.json["steps"], 17),
                       close("time over the time scale with fTime = 50", c.json["time [s]"] / c.json["scales"]["time [s]"], 50.0, 1e-9),
                       less("steps of the second run", c.json["steps"], 5000)]


@feature("F022", G)
def _(b):
    a, c = b.run(until=None, sets={"maxStps": 20, "nStps": 4}), b.run(until=None, sets={"maxStps": 20, "nStps": 7})
    return a.command, [equal("integration steps, maxStps 20, nStps 4", a.json["counters"]["steps"], 80), equal("nStps 7", c.json["counters"]["steps"], 140),
                       equal("stored steps", len(c.sol("SOL1").steps), 21)]


@feature("F023", G)
def _(b):
    sets = {"stpInit": 0.25, "stpMin": 0.25, "stpMax": 0.25, "nStps": 1}
    r = b.run(until=None, sets={**sets, "maxStps": 60})
    steps = [s[3] for s in r.sol("SOL3").steps[1:]]
    out = os.path.join(b.folder, "constant-pages")
    b.call(r.path("SOL3"), "--render", out, program="adrplot")
    other = os.path.join(b.folder, "variable-pages")
    b.call(b.run().path("SOL3"), "--render", other, program="adrplot")
    return r.command, [less("span of the steps over a step", (max(steps) - min(steps)) / steps[0], 1e-6),
                       close("step over the time scale", steps[0] / r.json["scales"]["time [s]"], 0.25, 1e-6),
                       differs("bytes of its last page (spectrum) against the note of variable steps", size(out), size(other))]


def size(folder):
    return os.path.getsize(os.path.join(folder, sorted(os.listdir(folder))[-1]))


@feature("F024", G)
def _(b):
    r, flags = b.run(), b.run(sets={"kDCR": 1, **{n: 1 for n in FLAGS}})
    c, d = b.channels(r), b.channels(flags)
    return r.command, [less("motion of the outer race [m]", constant([c[f"race.{a}.1"] for a in "xyz"]), 1e-15),
                       less("motion of the inner race [m]", constant([c[f"race.{a}.2"] for a in "xyz"]), 1e-15),
                       close("speed of the inner race [rpm]", c["race.angular_velocity.2"][-1] * 30 / math.pi, 10000.0, 1e-9),
                       close("load of ball 1 as with all flags 1 [N]", c["contact.load.1.1"][-1], d["contact.load.1.1"][-1], 1e-9)]


FLAGS = ["kFD11", "kFD21", "kFD31", "kFD12", "kFD22", "kFD32", "kMD11", "kMD21", "kMD31", "kMD12", "kMD22", "kMD32"]
HELD = {"kDCR": 1, **{n: 1 for n in FLAGS}}


@feature("F025", G)
def _(b):
    out, command = [], ""
    for flag, axis, race in (("kFD12", "x", 2), ("kFD22", "y", 2), ("kFD32", "z", 2), ("kFD11", "x", 1), ("kFD21", "y", 1), ("kFD31", "z", 1)):
        r = b.run(sets={**HELD, flag: 0})
        command = r.command
        c = b.channels(r)
        out.append(more(f"{flag} = 0: motion along {axis} [m]", constant([c[f"race.{axis}.{race}"]]), 1e-10))
        out.append(less(f"{flag} = 0: motion along the others [m]",
                        constant([c[f"race.{a}.{k}"] for a in "xyz" for k in (1, 2) if (a, k) != (axis, race)]), 1e-12))
        out.append(less(f"{flag} = 0: energy residual over energy moved", r.ledger["residual over energy moved"], 1e-5))
    return command, out


@feature("F026", G)
def _(b):
    out, command = [], ""
    for sets, name in (({"kMD22": 0, "kMD32": 0}, "inner race about y and z"), ({"kMD21": 0, "kMD31": 0}, "outer race about y and z")):
        race = 2 if "kMD22" in sets else 1
        r = b.run(sets={**HELD, **sets})
        command = r.command
        c = b.channels(r)
        out.append(more(f"{name}: tilt [rad]", constant([c[f"race.theta.{race}"], c[f"race.phi.{race}"]]), 1e-8))
        out.append(less(f"{name}: tilt of the other race [rad]", constant([c[f"race.theta.{3 - race}"], c[f"race.phi.{3 - race}"]]), 1e-12))
    r = b.run(sets={**HELD, "kMD12": 0}, until="0.0003s")
    c = b.channels(r)
    # the race coasts: M = I alpha with the moment of all contacts, so that angular momentum about x is conserved with the ledger
    out.append(more("kMD12 = 0: change of the race's speed by friction [rad/s]", constant([c["race.angular_velocity.2"]]), 1e-4))
    out.append(less("kMD12 = 0: angular momentum residual", r.json["conservation"]["momentum"]["angular residual over momentum carried"], 1e-9))
    return command, out


@feature("F027", G)
def _(b):
    def flags(**changed):
        return b.run(sets={**HELD, **changed}, check=False, until="0.002rev")

    one, two, good = flags(kMD22=0), flags(mode=2, kFD32=0), flags()
    return one.command, [equal("exit code with y and z flags that differ", one.code, 2), equal("the text names kMD32", "kMD32" in one.err, True),
                         equal("exit code of equilibrium with a force flag 0", two.code, 2), equal("exit code with all flags 1", good.code, 0)]


@feature("F028", G)
def _(b):
    first = b.static()
    given = {f"kFS{k}": 1 for k in (1, 2, 3)}
    at = {f"appDisp{a.upper()}": first.summary[f"displacement_{a}_m"] for a in "xyz"}
    if abs(at["appDispY"]) < 1e-15:
        at["appDispY"] = 0.0
    r = b.static(sets={**given, **at})
    return r.command, [close("reaction along x [N]", r.summary["load_x_N"], 1500.0, 1e-5), close("reaction along z [N]", r.summary["load_z_N"], 500.0, 1e-5),
                       close("reaction along y [N]", r.summary["load_y_N"], 0.0, absolute=1e-3),
                       differs("reaction along z, 1 um more in z [N]", b.static(sets={**given, **at, "appDispZ": at["appDispZ"] + 1e-6}).summary["load_z_N"], 500.0, 1e-2),
                       differs("reaction along y, 1 um more in y [N]", b.static(sets={**given, **at, "appDispY": 1e-6}).summary["load_y_N"], 0.0, 1e-2),
                       differs("reaction along x, 1 um more", b.static(sets={**given, **at, "appDispX": at["appDispX"] + 1e-6}).summary["load_x_N"], 1500.0,
                               1e-2)]


@feature("F029", G)
def _(b):
    r = b.static(sets={"kFS4": 0, "kFS5": 0, "appMomY": 3.0, "appMomZ": 2.0})
    s = r.summary
    back = b.static(sets={"kFS4": 1, "kFS5": 1, "appMis12": s["displacement_about_y_rad"], "appMis22": s["displacement_about_z_rad"]})
    return r.command, [close("moment about y [N.m]", s["load_about_y_Nm"], 3.0, 1e-6), close("moment about z [N.m]", s["load_about_z_Nm"], 2.0, 1e-6),
                       close("moment about y of the tilt found [N.m]", back.summary["load_about_y_Nm"], 3.0, 1e-4),
                       close("moment about z of the tilt found [N.m]", back.summary["load_about_z_Nm"], 2.0, 1e-4)]


@feature("F030", G)
def _(b):
    room = b.static(sets={"rpm2": 0.0, "appLoadZ": 0.0, "appLoadX": 500.0})
    x = room.summary["displacement_x_m"]
    hold = {"kFS1": 1, "appDispX": x, "appLoadZ": 0.0}
    still, fast = b.static(sets={**hold, "rpm2": 0.0}), b.static(sets={**hold, "rpm2": 10000.0})
    hot, shaft = (b.static(sets={**hold, "rpm2": 0.0, "shftTemp": 333.15, **x}) for x in ({"raceTemp2": 333.15}, {}))
    return fast.command, [close("preload at rest and room temperature [N]", still.summary["load_x_N"], 500.0, 1e-5),
                          more("preload at 10000 rpm [N]", fast.summary["load_x_N"], 505.0),
                          more("preload with an inner race and shaft 40 K warmer [N]", hot.summary["load_x_N"], 600.0),
                          differs("that with the shaft alone [N]", hot.summary["load_x_N"], shaft.summary["load_x_N"], 0.01)]
