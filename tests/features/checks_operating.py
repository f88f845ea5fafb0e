"""Operating conditions (F140 to F153) and thermal analysis (F154 to F164).

Independent values: rigid-body geometry of a displaced race, sums of contact loads, m r w^2, growths c d dT, laws of motion of the records
9.3 to 9.5, and the steady balance of heat: m cp dT, ln(r2/r1)/(2 pi k w), published correlations of convection.
"""

import json
import math
import os

import hertz
from bench import between, close, differs, equal, feature, less, more
from checks_bodies import approaches
from checks_life import HOT, OIL, THERMAL, network, steady
from checks_statics import ball_mass, sums

OPERATING, HEAT = "operating", "thermal"
D, DM, FO, FI, A0 = 0.0127, 0.060, 0.520, 0.515, math.radians(25.0)
RPM = math.pi / 30.0
REST = {"rpm2": 0.0, "appLoadZ": 0.0}
DISTANCE = (FO + FI - 1.0) * D  # of the curvature centers
RADIUS = DM / 2 + (FI - 0.5) * D * math.cos(A0)  # of the inner curvature centers


@feature("F140", OPERATING)
def _(b):
    r = b.static(sets={"raceFit1": 2e-5, "raceFit2": 2e-5, "rpm2": 0.0})
    loose = b.static(sets={"raceFit1": -2e-5, "raceFit2": -2e-5, "rpm2": 0.0})
    steel, soft = (207e9, 0.29), (206e9, 0.29)
    cold = b.static(sets={**REST, "roomTemp": 273.15})
    mounted = cold.fits
    return r.command, [close("outer pressure, Lame of rings of the raceway's radius [Pa]", r.summary["outer_fit_pressure_Pa"], hertz.lame_pressure(2e-5, 0.04, 0.0363738, 0.055, steel, soft), 0.12),
                       close("inner pressure [Pa]", r.summary["inner_fit_pressure_Pa"], hertz.lame_pressure(2e-5, 0.02, 0.0, 0.0236326, soft, steel), 0.12),
                       equal("pressures of loose fits (negative) [Pa]", [loose.summary["outer_fit_pressure_Pa"], loose.summary["inner_fit_pressure_Pa"]], [0.0, 0.0]),
                       close("loose fit at rest, running clearance [m]", loose.fits["inner race"]["operating interference [m]"], -2e-5, 1e-9),
                       close("room at 273.15 K: growth of the ball, c D 20 K [m]", mounted["growth of the element diameter [m]"], 1.19e-5 * D * 20.0, 1e-9),
                       less("clearance with both fits tight over that without", r.summary["operating_clearance_m"] / b.static(sets={"rpm2": 0.0}).summary["operating_clearance_m"], 0.9)]


@feature("F141", OPERATING)
def _(b):
    r = b.static(sets={"appLoadX": 900.0, "appLoadY": -350.0, "appLoadZ": 250.0}, opts={"ballFriction": "spin-rule"})  # no traction at the inner race
    x, y, z = sums(r.elements)
    roller = b.static("cylindrical", sets={"appLoadY": 3000.0, "appLoadZ": 4000.0})
    _, ry, rz = sums(roller.elements)
    moving = b.run(sets={"appLoadX": 900.0, "appLoadY": -350.0, "appLoadZ": 250.0, "mode": 2}, until="0.02rev")
    s = moving.sol("SOL4")
    return r.command, [close("sum of Q sin a [N]", x, 900.0, 1e-6), close("sum of -Q cos a sin t [N]", y, -350.0, 2e-3), close("sum of Q cos a cos t [N]", z, 250.0, 2e-3),
                       close("cylindrical bearing, y [N]", ry, 3000.0, 1e-3), close("z [N]", rz, 4000.0, 1e-3)] + [
        close(f"mode 2: force of the elements on the inner race, value {k} of SOL4 [N]", s.column(k)[-1], v, 0.03) for k, v in ((4, 900.0), (5, -350.0), (6, 250.0))]


def displaced(x, y, z, theta_y=0.0, theta_z=0.0):
    """Sum of both approaches of the 12 balls for a rigid displacement of the inner race from the state where all balls just touch."""
    out = []
    for k in range(12):
        t = math.radians(30.0 * k)
        axial = DISTANCE * math.sin(A0) + x + RADIUS * (theta_y * math.cos(t) + theta_z * math.sin(t))
        radial = DISTANCE * math.cos(A0) + z * math.cos(t) - y * math.sin(t)
        out.append(math.hypot(axial, radial) - DISTANCE)
    return out


def apart(found, wanted):
    return max(abs(p - q) for p, q in zip(found, wanted)) / max(wanted)


@feature("F142", OPERATING)
def _(b):
    given = {"kFS1": 1, "kFS2": 1, "kFS3": 1, "rpm2": 0.0}
    r = b.static(sets={**given, "appDispX": 2e-5, "appDispY": 3e-6, "appDispZ": -4e-6})
    only = b.static(sets={**given, "appDispX": 2e-5, "appDispY": 0.0, "appDispZ": 0.0})
    return r.command, [less("approaches by Hertz against the geometry of a race displaced by 20, 3 and -4 um, largest departure", apart(approaches(r), displaced(2e-5, 3e-6, -4e-6)), 2e-3),
                       less("displaced along x only", apart(approaches(only), displaced(2e-5, 0.0, 0.0)), 2e-3),
                       more("departure from the geometry without y and z", apart(approaches(r), displaced(2e-5, 0.0, 0.0)), 0.05),
                       close("displacement of the summary, y [m]", r.summary["displacement_y_m"], 3e-6, 1e-12)]


def moments(r):
    my = mz = 0.0
    radius = r.fits["inner race"]["radius of the curvature centres [m]"]
    for q, a, t in zip(r.elements["inner load [N]"], r.elements["inner contact angle [deg]"], r.elements["azimuth [deg]"]):
        f = q * math.sin(math.radians(a))
        my += radius * math.cos(math.radians(t)) * f
        mz += radius * math.sin(math.radians(t)) * f
    return my, mz


@feature("F143", OPERATING)
def _(b):
    free = {"kFS4": 0, "kFS5": 0, "appLoadZ": 0.0, "rpm2": 0.0}
    r, none = b.static(sets={**free, "appMomY": 6.0, "appMomZ": -4.0}), b.static(sets={**free, "appMomY": 0.0, "appMomZ": 0.0})
    my, mz = moments(r)
    return r.command, [close("moment of the contact loads about y, pure moment and thrust [N.m]", my, 6.0, 5e-3), close("about z [N.m]", mz, -4.0, 5e-3),
                       close("tilts: ratio z to y", r.summary["displacement_about_z_rad"] / r.summary["displacement_about_y_rad"], -4.0 / 6.0, 1e-2),
                       less("tilt without moments [rad]", abs(none.summary["displacement_about_y_rad"]), 1e-9)]


@feature("F144", OPERATING)
def _(b):
    given = {"kFS1": 1, "appDispX": 2e-5, "kFS2": 1, "kFS3": 1, "rpm2": 0.0}
    out, command = [], ""
    for name, sign, axis in (("appMis12", 1.0, "y"), ("appMis22", 1.0, "z"), ("appMis11", -1.0, "y"), ("appMis21", -1.0, "z")):
        r = b.static(sets={**given, name: 2e-4})
        command = r.command
        # the curvature centers of the outer race, which tilt here, are at their own radius, 1.3 % smaller
        wanted = displaced(2e-5, 0.0, 0.0, *((sign * 2e-4, 0.0) if axis == "y" else (0.0, sign * 2e-4)))
        out.append(less(f"{name} = 0.2 mrad: approaches against a race tilted about {axis}, largest departure", apart(approaches(r), wanted), 0.005))
    both = b.static(sets={**given, "appMis11": 2e-4, "appMis12": 2e-4})
    out.append(less("both races tilted alike: approaches against those of straight ones", apart(approaches(both), displaced(2e-5, 0.0, 0.0)), 0.006))
    return command, out


def spin(c, race):
    """Speed of a race about x [rpm] with its sign; the channel has its size and direction."""
    return [w * math.cos(t) * math.cos(p) / RPM for w, t, p in zip(c[f"race.angular_velocity.{race}"], c[f"race.angular_velocity_theta.{race}"],
                                                                   c[f"race.angular_velocity_phi.{race}"])]


@feature("F145", OPERATING)
def _(b):
    out, command = [], ""
    for outer, inner in ((0.0, 10000.0), (10000.0, 0.0), (-4000.0, 10000.0)):
        r = b.run(sets={"rpm1": outer, "rpm2": inner}, until="3e-6s", opts={"ballFriction": "spin-rule"})
        command = r.command
        c = b.channels(r)
        ao, ai = c["contact.angle.1.1"][0], c["contact.angle.1.2"][0]
        g = D / (2 * c["element.radial_position.1"][0])
        # Jones, outer race control, seen from the outer race
        orbit = outer + (inner - outer) * (1 - g * math.cos(ai)) / (1 + math.cos(ai - ao))
        out.append(close(f"rpm1 {outer:.0f}, rpm2 {inner:.0f}: orbital speed of ball 1 [rpm]", c["element.orbital_velocity.1"][0] / RPM, orbit, 5e-3, 5.0))
        out.append(close("speed of the outer race [rpm]", spin(c, 1)[-1], outer, 1e-9, 1e-9))
        out.append(close("of the inner race [rpm]", spin(c, 2)[-1], inner, 1e-9, 1e-9))
    return command, out


@feature("F146", OPERATING)
def _(b):
    room, up = 293.15, 40.0
    base = b.static(sets=REST).fits
    out, command = [], ""
    for name, wanted, read in (
            ("hsngTemp", -1.17e-5 * 0.080 * up, lambda f: f["outer race"]["operating interference [m]"]),
            ("shftTemp", 1.17e-5 * 0.040 * up, lambda f: f["inner race"]["operating interference [m]"]),
            ("raceTemp1", 1.19e-5 * 0.080 * up, lambda f: f["outer race"]["operating interference [m]"]),
            ("raceTemp2", -1.19e-5 * 0.040 * up, lambda f: f["inner race"]["operating interference [m]"]),
            ("reTemp", 1.19e-5 * D * up, lambda f: f["growth of the element diameter [m]"]),
            ("cageTemp", 2e-5 * 0.033 * up, lambda f: f["growth of the cage outside"]["thermal [m]"])):
        r = b.static(sets={**REST, name: room + up})
        command = r.command
        out.append(close(f"{name} + 40 K: growth or interference, c d dT [m]", read(r.fits) - read(base), wanted, 1e-6))
    return command, out


@feature("F147", OPERATING)
def _(b):
    still = b.static()
    deflection = math.hypot(still.summary["displacement_y_m"], still.summary["displacement_z_m"])
    out, command = [], ""
    for race, fraction, speed in ((2, 0.5, 10000.0), (1, 0.4, 6000.0)):
        sets = {"kVarLoad": 1, "rotLoadFrac1": 0.0, "rotLoadFrac2": 0.0, "rotLoadRpm1": 0.0, "rotLoadRpm2": 0.0, f"rotLoadFrac{race}": fraction, f"rotLoadRpm{race}": speed}
        r = b.run(sets=sets, until="0.5rev")
        command = r.command
        c = b.channels(r)
        y, z = c[f"race.y.{race}"], c[f"race.z.{race}"]
        t = c["time"]
        centre = circle(list(zip(y, z)))
        out.append(close(f"race {race}: radius of its orbit over the radial deflection", centre[2] / deflection, fraction, 0.01))
        angle = [math.atan2(-(p - centre[0]), q - centre[1]) for p, q in zip(y, z)]
        turned = sum((angle[k + 1] - angle[k] + math.pi) % (2 * math.pi) - math.pi for k in range(len(angle) - 1))
        out.append(close(f"race {race}: speed of the orbit [rpm]", turned / (t[-1] - t[0]) / RPM, speed, 1e-3))
        other = 3 - race
        out.append(less(f"motion of race {other} [m]", max(abs(v - c[f"race.z.{other}"][0]) for v in c[f"race.z.{other}"]), 1e-12))
    return command, out


def circle(points):
    """Centre and radius of the circle through three far points."""
    (x1, y1), (x2, y2), (x3, y3) = points[0], points[len(points) // 3], points[2 * len(points) // 3]
    d = 2 * (x1 * (y2 - y3) + x2 * (y3 - y1) + x3 * (y1 - y2))
    cx = ((x1**2 + y1**2) * (y2 - y3) + (x2**2 + y2**2) * (y3 - y1) + (x3**2 + y3**2) * (y1 - y2)) / d
    cy = ((x1**2 + y1**2) * (x3 - x2) + (x2**2 + y2**2) * (x1 - x3) + (x3**2 + y3**2) * (x2 - x1)) / d
    return cx, cy, math.hypot(x1 - cx, y1 - cy)


@feature("F148", OPERATING)
def _(b):
    names = [f"raceVibAmp{a}{race}" for race in (1, 2) for a in (1, 2, 3)] + ["raceVibFreq1", "raceVibFreq2"]
    out, command = [], ""
    for race in (1, 2):
        for a, axis in enumerate("xyz", 1):
            sets = {"kVarLoad": 2, **{n: 0.0 for n in names}, f"raceVibAmp{a}{race}": 2e-6, f"raceVibFreq{race}": 1500.0}
            r = b.run(sets=sets, until="0.1rev")
            command = r.command
            c = b.channels(r)
            s = c[f"race.{axis}.{race}"]
            worst = max(abs(v - s[0] - 2e-6 * math.sin(2 * math.pi * 1500.0 * t)) for v, t in zip(s, c["time"]))
            out.append(less(f"race {race} along {axis}: departure from 2 um sin(2 pi 1500 t) [m]", worst, 1e-9))
            still = max(max(c[f"race.{o}.{k}"]) - min(c[f"race.{o}.{k}"]) for o in "xyz" for k in (1, 2) if (o, k) != (axis, race))
            out.append(less("motion along the others [m]", still, 1e-12))
    return command, out


@feature("F149", OPERATING)
def _(b):
    out, command = [], ""
    for race, first in ((1, 500.0), (2, 10000.0)):
        begin, end, rate = 2e-4, 5e-4, -2e6
        sets = {"kVarSpeed": 1, "rpm1": 500.0, **{n: 0.0 for n in ("raceAngAcc1", "raceAngAcc2", "startTime1", "endTime1", "startTime2", "endTime2")},
                f"raceAngAcc{race}": rate, f"startTime{race}": begin, f"endTime{race}": end}
        r = b.run(sets=sets, until="0.0008s")
        command = r.command
        c = b.channels(r)
        worst = max(abs(w - (first + rate * min(max(t - begin, 0.0), end - begin))) for w, t in zip(spin(c, race), c["time"]))
        out.append(less(f"race {race}: departure from {first:.0f} - 2e6 (t - 0.2 ms), held from 0.5 ms on [rpm]", worst, 0.05))
        out.append(close(f"race {race}: speed at the end [rpm]", spin(c, race)[-1], first + rate * (end - begin), 1e-5))
        other = c[f"race.angular_velocity.{3 - race}"]
        out.append(less("change of the other race's speed [rpm]", (max(other) - min(other)) / RPM, 1e-9))
    return command, out


@feature("F150", OPERATING)
def _(b):
    out, command = [], ""
    for race, first in ((1, 300.0), (2, 10000.0)):
        sets = {"kVarSpeed": 2, "rpm1": 300.0, **{n: 0.0 for n in ("raceSpeedAmp1", "raceSpeedAmp2", "raceSpeedFreq1", "raceSpeedFreq2")}, f"raceSpeedAmp{race}": 200.0,
                f"raceSpeedFreq{race}": 1200.0}
        r = b.run(sets=sets, until="0.001s")
        command = r.command
        c = b.channels(r)
        worst = max(abs(w / RPM - (first + 200.0 * math.sin(2 * math.pi * 1200.0 * t))) for w, t in zip(c[f"race.angular_velocity.{race}"], c["time"]))
        other = c[f"race.angular_velocity.{3 - race}"]
        out += [less(f"race {race}: departure from {first:.0f} + 200 sin(2 pi 1200 t) [rpm]", worst, 0.1), less("change of the other race's speed [rpm]", (max(other) - min(other)) / RPM, 1e-9)]
    return command, out


BARE = {"mode": 1, "nCseg": 0, "kNumPltElem": 1, "kPltElemInd": 1}
FRAME = {"kRotFrame": 1, "brgOrbitRad": 0.1, "brgAngPos": 0.0, "brgAngVel": 1000.0, "brgLoadFrac1": 0.0, "brgLoadFrac2": 0.0, "gravityVecZ": 0.0}


def lift(b, run, k=0):
    """Sum of the race forces on the balls: outer less inner contact loads along x, y, z."""
    c, out = b.channels(run), [0.0, 0.0, 0.0]
    for n in range(1, 13):
        t = c[f"element.orbital_position.{n}"][k]
        qo, qi = c[f"contact.load.{n}.1"][k], c[f"contact.load.{n}.2"][k]
        ao, ai = c[f"contact.angle.{n}.1"][k], c[f"contact.angle.{n}.2"][k]
        radial = qo * math.cos(ao) - qi * math.cos(ai)
        out[0] += qo * math.sin(ao) - qi * math.sin(ai)
        out[1] -= radial * math.sin(t)
        out[2] += radial * math.cos(t)
    return out


@feature("F151", OPERATING)
def _(b):
    slow = {**BARE, "rpm2": 1.0}
    field = (1000.0 * RPM)**2 * 0.1
    # the balance along each ball's radius holds: half of the field's force, the other half acts along the orbits
    half = 6 * ball_mass() * field
    r, side = b.run(sets={**slow, **FRAME}, until="0.0001rev"), b.run(sets={**slow, **FRAME, "brgAngPos": 90.0}, until="0.0001rev")
    start = b.channels(r)
    out = [close("balls at standstill in an orbit of 0.1 m at 1000 rpm: load on the outer race along z, 6 m W^2 R [N]", lift(b, r)[2], half, 5e-3),
           close("bearing at 90 deg of its orbit: along y [N]", lift(b, side)[1], -half, 5e-3), less("along z [N]", abs(lift(b, side)[2]), 0.2),
           close("force along z stays with the load of the deck [N]", start["race.applied_force_z.2"][0], 500.0, 1e-4)]
    inner, outer = b.run(sets={**slow, **FRAME, "brgLoadFrac2": 0.5}, until="0.0001rev"), b.run(sets={**slow, **FRAME, "brgLoadFrac1": 1.0}, until="0.0001rev")
    masses = masses_of(r)
    out += [close("half of the inner race's inertial load joins the force along z [N]", b.channels(inner)["race.applied_force_z.2"][0] - 500.0, 0.5 * masses["inner race"] * field, 2e-3),
            close("that of the outer race loads the inner one the other way [N]", b.channels(outer)["race.applied_force_z.2"][0] - 500.0, -masses["outer race"] * field, 2e-3)]
    quiet = b.run("ball", sets={**FRAME, "brgAngVel": 3000.0, "brgLoadFrac2": 0.5}, until="0.02rev")
    q = b.channels(quiet)
    # balls on the line of the field; the others are driven along their orbits
    jump = max(abs(v / q[f"contact.load.{k}.1"][0] - 1.0) for k in (1, 7) for v in q[f"contact.load.{k}.1"])
    return r.command, out + [less("mode 0 starts in the field's equilibrium: largest change of an outer contact load in 0.02 revolutions, relative (balls 1 and 7, of 605 and 123 N, carry 82 N each of the field at 3000 rpm)", jump, 0.02),
                             less("energy residual over energy moved", quiet.ledger["residual over energy moved"], 1e-4)]


def masses_of(run):
    out = {}
    for line in run.listing.split("Inertia about the mass center", 1)[1].splitlines()[:12]:
        for body in ("outer race", "inner race"):
            if line.strip().startswith(body):
                out[body] = float(line.replace(body, "").split()[0])
    return out


@feature("F152", OPERATING)
def _(b):
    out, command = [], ""
    for frame in (0.0, 3000.0, -3000.0):
        r = b.run(sets={**BARE, **FRAME, "brgOrbitRad": 0.0, "brgAngVel": frame, "appLoadZ": 0.0} if frame else {**BARE, "gravityVecZ": 0.0, "appLoadZ": 0.0}, until="0.0001rev")
        command = r.command if frame > 0 else command
        c = b.channels(r)
        orbit, radius = c["element.orbital_velocity.1"][0], c["element.radial_position.1"][0]
        found = sum(c[f"contact.load.{k}.1"][0] * math.cos(c[f"contact.angle.{k}.1"][0]) - c[f"contact.load.{k}.2"][0] * math.cos(c[f"contact.angle.{k}.2"][0]) for k in range(1, 13)) / 12
        total = orbit + frame * RPM
        out.append(close(f"frame at {frame:.0f} rpm about the bearing axis, orbit at {orbit / RPM:.0f} rpm in it: Qo cos a - Qi cos a less friction, m r (w + W)^2 [N]", found,
                         ball_mass() * radius * total * total, 0.02))
    return command, out


@feature("F153", OPERATING)
def _(b):
    out, command = [], ""
    weight = 12 * ball_mass() * 1000.0
    for axis, wanted in (("X", (weight, 0.0, 0.0)), ("Y", (0.0, 0.5 * weight, 0.0)), ("Z", (0.0, 0.0, 0.5 * weight))):
        none = {"gravityVecX": 0.0, "gravityVecY": 0.0, "gravityVecZ": 0.0}
        r, base = (b.run(sets={**BARE, "rpm2": 1.0, **none, **x}, until="0.0001rev") for x in ({f"gravityVec{axis}": 1000.0}, {}))
        command = r.command
        found = [p - q for p, q in zip(lift(b, r), lift(b, base))]
        out.append(less(f"1000 m/s^2 along {axis}: balls press on the outer race, 12 m g along x, half along y and z (balance along the radius); departure [N]",
                        max(abs(p - q) for p, q in zip(found, wanted)), 0.01 * weight))
        fall = b.run(sets={**none, f"gravityVec{axis}": 500.0, "cageGcPos": "0,0,0"}, until="0.01rev")
        still = b.run(sets={**none, "cageGcPos": "0,0,0"}, until="0.01rev")
        f, s = b.channels(fall), b.channels(still)
        k = "XYZ".index(axis) + 1
        out.append(close(f"cage: velocity along {axis} over g t", (f[f"cage.velocity.1.{k}"][-1] - s[f"cage.velocity.1.{k}"][-1]) / (500.0 * f["time"][-1]), 1.0, 0.01))
    return command, out


def flow(n, name):
    return n[f"Flow from {name}"]


@feature("F154", HEAT)
def _(b):
    r, n = steady(b)
    off = b.static(sets={**OIL, **{t: 330.0 for t in HOT}, "shftID": 0.01})
    out = sum(v for k, v in n.items() if k.startswith("Removed to"))
    motion = b.run(sets=THERMAL, until="0.6rev")
    late, early = motion.sol("SOL7").values[-1], motion.sol("SOL7").values[0]
    return r.command, [close("heat that leaves the network, heat made [W]", out, n["Generated, total"], 1e-4), close("heat made, power of the summary [W]", n["Generated, total"], r.summary["friction_power_W"], 1e-4),
                       more("balls above the base of 330 K [K]", r.summary["element_temperature_K"] - 330.0, 1.0), equal("temperatures without kTherm", "element_temperature_K" in off.summary, False),
                       more("motion: balls warm up [K]", late[13] - early[13], 1.0), close("motion: coolant exit of the last thermal step, that of its network [K]", late[18],
                       motion.json["thermal_network"]["tables"]["thermal network"]["coolant exit [K]"][0], 1e-4),
                       close("motion: heat that leaves the network, heat of its thermal step in SOL7 [W]", sum(v[0] for k, v in motion.json["thermal_network"]["tables"]["thermal network"].items() if
                                                                                                              k.startswith("leaves to")), late[22], 1e-3)]


def net(run, name):
    return run.json["thermal_network"]["tables"]["thermal network"][name][0]


def coolant(b, code, **sets):
    return steady(b, kCoolant=code, **sets)


def heating(n, density, heat, rate):
    """Rise of the coolant: q / (rho cp V)."""
    return n["Removed to coolant"] / (density * heat * rate)


@feature("F155", HEAT)
def _(b):
    r, n = coolant(b, 1)
    other, m = coolant(b, 1, kTrac=1)
    return r.command, [close("rise of the lubricant, q / (rho cp V) [K]", n["coolant exit"] - n["coolant inlet"], heating(n, n["Density"], n["Specific heat"], 2e-5), 5e-3),
                       close("density of MIL-L-23699 at 60 C [kg/m^3] (handbook 950 to 970)", n["Density"], 955.0, 0.02), close("specific heat [J/kg/K] (handbook 1900 to 2050)", n["Specific heat"], 2000.0, 0.05),
                       equal("its name in PRINT.txt", "MIL-L-23699" in r.listing.split("Coolant\n", 1)[1][:300], True), differs("viscosity with another lubricant [N.s/m^2]", m["Viscosity"], n["Viscosity"], 0.05)]


GIVEN = {"xRo": 800.0, "xMu": 0.003, "xCp": 2100.0, "xK": 0.12}


@feature("F156", HEAT)
def _(b):
    r, n = coolant(b, 2, **GIVEN)
    out = [close("rise of the coolant, q / (rho cp V) [K]", n["coolant exit"] - n["coolant inlet"], heating(n, 800.0, 2100.0, 2e-5), 1e-4)]
    for name, factor in (("xRo", 2.0), ("xCp", 2.0)):
        _, m = coolant(b, 2, **{**GIVEN, name: GIVEN[name] * factor})
        out.append(close(f"{name} twice: rise over heat to the coolant, half", (m["coolant exit"] - m["coolant inlet"]) / m["Removed to coolant"] / ((n["coolant exit"] - n["coolant inlet"]) / n["Removed to coolant"]), 0.5, 1e-4))
    speed = sphere_speed(n, GIVEN)
    for name, factor in (("xRo", 2.0), ("xMu", 2.0), ("xK", 2.0), ("xCp", 2.0)):
        changed = {**GIVEN, name: GIVEN[name] * factor}
        _, m = coolant(b, 2, **changed)
        out.append(close(f"convection of the balls with {name} twice, 2 + 0.6 Re^1/2 Pr^1/3 (Ranz and Marshall) [W/m^2/K]", m["Convection of rolling elements"], sphere(changed, speed), 0.01))
    return r.command, out


def sphere(f, speed):
    re, pr = f["xRo"] * speed * D / f["xMu"], f["xMu"] * f["xCp"] / f["xK"]
    return (2 + 0.6 * math.sqrt(re) * pr**(1 / 3)) * f["xK"] / D


def sphere_speed(n, f):
    """The speed at which the correlation gives the listed convection."""
    low, high = 0.1, 200.0
    for _ in range(200):
        mid = 0.5 * (low + high)
        low, high = (mid, high) if sphere(f, mid) < n["Convection of rolling elements"] else (low, mid)
    return low


# Handbook density [kg/m^3] and specific heat [J/kg/K] (recalled, medium; gases at 1 bar).
MEDIA = {3: (90.0, 1142.0, 1700.0), 4: (20.0, 71.0, 9700.0), 5: (77.0, 807.0, 2040.0), 6: (112.0, 430.0, 3400.0), 7: (112.0, 422.0, 3480.0), 8: (293.15, 805.0, 2000.0), 9: (293.15, 828.0, 2000.0),
         10: (293.15, 935.0, 1600.0), 11: (293.15, 800.0, 2000.0), 12: (293.15, 800.0, 2000.0), 13: (293.15, 1.2, 1005.0), 14: (293.15, 998.0, 4182.0)}


@feature("F157", HEAT)
def _(b):
    out, command = [], ""
    for code, (temperature, density, heat) in MEDIA.items():
        sets = {**THERMAL, "kTrac": 0, "kCoolant": code, "kBaseTemp": 3, "baseTemp": temperature, **{t: temperature for t in HOT}, "cFlowRate": 5e-3 if code == 13 else 2e-4}
        sets = {k: v for k, v in sets.items() if k not in OIL or k == "kTrac"}
        r = b.static(sets=sets, check=False)
        if r.code:
            out.append(equal(f"code {code} at {temperature} K: exit code ({r.err.strip()[-80:]})", r.code, 0))
            continue
        command = r.command
        n = network(r)
        out.append(close(f"code {code}: rise at {sets['cFlowRate']} m^3/s with {density:.4g} kg/m^3 and {heat:.0f} J/kg/K of handbooks [K]", n["coolant exit"] - n["coolant inlet"],
                         heating(n, density, heat, sets["cFlowRate"]), 0.08))
    return command, out


PLACES = ((0, "outer race at the housing"), (1, "housing outside"), (2, "coolant exit"), (3, "coolant inlet"), (4, "inner race at the shaft"), (5, "shaft inside"))


@feature("F158", HEAT)
def _(b):
    out, command, seen = [], "", set()
    for code, place in PLACES:
        r, n = steady(b, kBaseTemp=code, baseTemp=335.0)
        command = r.command
        others = [n[p] for c, p in PLACES if c != code]
        out.append(close(f"kBaseTemp = {code}: {place} [K]", n[place], 335.0, 1e-5))
        out.append(more("farthest of the other places from it [K]", max(abs(v - 335.0) for v in others), 0.5))
        seen.add(round(n["rolling elements"], 3))
    out.append(equal("different temperatures of the balls", len(seen), 6))
    return command, out


@feature("F159", HEAT)
def _(b):
    r, n = steady(b, kHTC=1, reHTC=2500.0, cageHTC=1500.0)
    auto, m = steady(b)
    moving, free = (b.run(sets={**THERMAL, **x}, until="0.6rev") for x in ({"kHTC": 1, "reHTC": 2500.0, "cageHTC": 1500.0}, {"kHTC": 1, "reHTC": 2500.0, "cageHTC": 3000.0}))
    f = {"xRo": m["Density"], "xMu": m["Viscosity"], "xCp": m["Specific heat"], "xK": m["Conductivity"]}
    speed = sphere_speed(m, f)
    area = 12 * math.pi * D**2
    return r.command, [close("heat of the balls to the coolant, h A dT with h = 2500 [W]", n["Flow from rolling elements to coolant mean"], 2500.0 * area * (n["rolling elements"] - n["coolant mean"]), 2e-3),
                       close("that of a motion [W]", net(moving, "rolling elements to coolant mean [W]"), 2500.0 * area * (net(moving, "rolling elements [K]") - net(moving, "coolant mean [K]")), 2e-3),
                       close("cage: heat over temperature difference with cageHTC 3000 over that with 1500", cage_conductance(free) / cage_conductance(moving), 2.0, 1e-3),
                       between("area of the cage that takes part, over its outside and bore", cage_conductance(moving) / 1500.0 / (math.pi * (0.066 + 0.058) * 0.017), 0.5, 3.0),
                       between("computed: speed of Ranz and Marshall's sphere that gives it, from the orbital motion to the surface's spin [m/s]", speed, 4.0, 14.0),
                       close("convection of the balls as listed [W/m^2/K]", m["Convection of rolling elements"], sphere(f, speed), 1e-3)]


def cage_conductance(r):
    return net(r, "cage to coolant mean [W]") / (net(r, "cage [K]") - net(r, "coolant mean [K]"))


@feature("F160", HEAT)
def _(b):
    # A balance of friction follows the temperature of the oil, and the equilibrium with it, at each thermal step.
    def changes(every):
        run = b.run(sets={**THERMAL, "kGeoMod": every, "skipTime": 0.0}, until="1.2rev", opts={"ballFriction": "spin-rule"})
        return geometry_changes(b, run), thermal_steps(run)

    (one, steps), (two, others), (none, _) = changes(1), changes(2), changes(0)
    r = b.static(sets={**THERMAL, "kGeoMod": 1})
    off = b.static(sets={**THERMAL, "kGeoMod": 0})
    return r.command, [more("thermal steps of 0.6 ms in 7.2 ms", len(steps), 9), equal("kGeoMod = 1: times at which the geometry changes, those of the thermal steps", one, steps),
                       equal("kGeoMod = 2: every second of its thermal steps", two, others[1::2]), equal("kGeoMod = 0: changes", none, []),
                       close("steady clearance less that without, growth of races and balls [m]", r.summary["operating_clearance_m"] - off.summary["operating_clearance_m"],
                             growth_of_clearance(r) - growth_of_clearance(off), 0.02)]


def growth_of_clearance(run):
    f = run.fits
    return 2 * sum(sign * f[f"{k} race"]["growth of the raceway"][n] for k, sign in (("outer", 1.0), ("inner", -1.0)) for n in ("thermal [m]", "fit pressure [m]")) - 2 * f["growth of the element diameter [m]"]


def thermal_steps(run):
    """Times of the stored steps at which SOL7 has the heat of another thermal step."""
    s = run.sol("SOL7")
    return [s.times[k] for k in range(1, len(s.times)) if s.values[k][22] != s.values[k - 1][22]]


def geometry_changes(b, run):
    """Times at which the ledger books the energy of a change of geometry, in the resolution of SOL7."""
    c, s = b.channels(run), run.sol("SOL7")
    v = c["energy.thermal_steps"]
    return [s.times[k] for k in range(1, len(v)) if v[k] != v[k - 1]]


@feature("F161", HEAT)
def _(b):
    r, n = steady(b)
    twice, m = steady(b, cFlowRate=4e-5)

    def steps(**sets):
        run = b.run(sets={**THERMAL, "skipTime": 0.0, **sets}, until="0.8rev", opts={"ballFriction": "spin-rule"})
        return run, thermal_steps(run)

    run, short = steps()
    _, long = steps(aveTime=0.0012)
    late, _ = steps(skipTime=0.003)
    changed = geometry_changes(b, late)
    # heat averaged over the second window
    c = b.channels(run)
    power, t, s = c["power.loss"], c["time"], run.sol("SOL7")
    window = [k for k in range(1, len(t)) if short[0] < s.times[k] <= short[1]]
    mean = sum(0.5 * (power[k] + power[k - 1]) * (t[k] - t[k - 1]) for k in window) / sum(t[k] - t[k - 1] for k in window)
    at = s.times.index(short[1])
    return r.command, [close("rise with twice the flow over heat to the coolant, half", (m["coolant exit"] - m["coolant inlet"]) / m["Removed to coolant"] / ((n["coolant exit"] - n["coolant inlet"]) / n["Removed to coolant"]), 0.5, 1e-4),
                       close("aveTime = 0.6 ms: end of the first thermal step [s]", short[0], 0.0006, 0.05), close("aveTime = 1.2 ms [s]", long[0], 0.0012, 0.05),
                       close("heat of the second thermal step, mean of the power over its time [W]", s.values[at][22], mean, 0.05),
                       more("skipTime = 3 ms: first change of the geometry [s]", changed[0], 0.003 - 1e-9), less("and soon after [s]", changed[0], 0.0037)]


@feature("F162", HEAT)
def _(b):
    r = b.run(sets=THERMAL, until="0.6rev")
    v, c = r.sol("SOL7").values[-1], b.channels(r)
    flow_ = net(r, "housing at the outer race to housing outside [W]")
    return r.command, [equal("values of SOL7", r.sol("SOL7").integers[0], 26), close("coolant inlet [K]", v[17], net(r, "coolant inlet [K]"), 1e-6), close("coolant exit [K]", v[18], net(r, "coolant exit [K]"), 1e-6),
                       close("outside diameter of the bearing [K]", v[19], net(r, "outer race at the housing [K]"), 1e-6),
                       close("bore [K]", v[20], net(r, "inner race at the shaft [K]"), 1e-6), close("housing outside [K]", v[21], net(r, "housing outside [K]"), 1e-6),
                       close("drop over the housing, q ln(r2/r1) / (2 pi k w) [K]", net(r, "housing at the outer race [K]") - net(r, "housing outside [K]"), flow_ * math.log(0.055 / 0.04) / (2 * math.pi * 52.0 * 0.018), 5e-3),
                       close("rise of the coolant, q / (rho cp V) with 945 kg/m^3 and 2000 J/kg/K [K]", v[18] - v[17], v[23] / (945.0 * 2000.0 * 2e-5), 0.02),
                       close("channel of RESULTS.h5, bore [K]", c["thermal.bore.1"][-1], v[20], 1e-6)]


@feature("F163", HEAT)
def _(b):
    r = b.run(sets=THERMAL, until="0.6rev")
    v = r.sol("SOL7").values[-1]
    rate = 944.8 * 2000.0 * 2e-5
    return r.command, [close("total heat, what leaves the network [W]", v[22], sum(x[0] for k, x in r.json["thermal_network"]["tables"]["thermal network"].items() if k.startswith("leaves to")), 1e-3),
                       close("heat to the coolant, rho cp V times its rise [W]", v[23], rate * (v[18] - v[17]), 0.02), close("through the outer race [W]", v[24], net(r, "outer raceway to outer race at the housing [W]"), 1e-5),
                       close("through the inner race [W]", v[25], net(r, "inner raceway to inner race at the shaft [W]"), 1e-5),
                       close("coolant and both races together, the total [W]", v[23] + v[24] + v[25], v[22], 1e-3)]


@feature("F164", HEAT)
def _(b):
    hot = {"rpm2": 0.0, "raceTemp1": 303.15, "raceTemp2": 333.15, "reTemp": 323.15, "cageTemp": 343.15, "hsngTemp": 303.15, "shftTemp": 333.15}
    loose = {"raceFit1": -1e-4, "raceFit2": -1e-4}
    r, cold = b.static(sets={**hot, **loose}), b.static(sets={"rpm2": 0.0, **loose})
    f, g = r.fits, cold.fits
    c = 1.19e-5
    # free rings grow as a whole: groove bottom of the outer race at 33.15+, of the inner one at 27; the ball has twice its growth
    bottom = [DM / 2 * 1.0 + s * D / 2 for s in (1.0, -1.0)]
    change = 2 * (c * bottom[0] * 10.0 - c * bottom[1] * 40.0) - 2 * c * D * 30.0
    fast = b.static(sets={"rpm2": 20000.0, **loose}).fits
    faster = b.static(sets={"rpm2": 40000.0, **loose}).fits
    w = "centrifugal [m]"
    play = "guide land 1 on the outer race"
    cage = f["cage play, diametral"][play]
    shoulder = f["outer race"]["growth of the raceway"]["thermal [m]"]
    return r.command, [close("diametral clearance changes by the growth of races and balls [m]", f["operating"]["diametral clearance [m]"] - g["operating"]["diametral clearance [m]"], change, 0.02),
                       close("fit of the outer race, c d dT of race and housing [m]", f["outer race"]["operating interference [m]"] - g["outer race"]["operating interference [m]"], (c - 1.17e-5) * 0.08 * 10.0, 1e-6, 1e-12),
                       close("fit of the inner race [m]", f["inner race"]["operating interference [m]"] - g["inner race"]["operating interference [m]"], (1.17e-5 - c) * 0.04 * 40.0, 1e-6, 1e-12),
                       close("centrifugal growth of the inner raceway at twice the speed, four times", faster["inner race"]["growth of the raceway"][w] / fast["inner race"]["growth of the raceway"][w], 4.0, 1e-3),
                       between("that growth at 20000 rpm over rho w^2 r^3 / E of a thin ring", fast["inner race"]["growth of the raceway"][w] / (7810.0 * (20000.0 * RPM)**2 * 0.0236**3 / 207e9), 0.7, 1.3),
                       close("play at the outer land changes by the growths of race and cage [m]", cage["operating [m]"] - cage["cold [m]"], 2 * (c * 0.03315 * 10.0 - 2e-5 * 0.033 * 50.0), 0.02),
                       more("growth of the outer raceway [m]", shoulder, 0.0)]
