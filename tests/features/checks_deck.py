"""Deck, listing and result files (F219 to F259), distribution (F348 to F350)."""

import math
import os
import re

from bench import Sol, close, differs, equal, feature, less, more

G = "files"
BASE = "0.3rev"
TINY = "0.005rev"


def edited(old, new):
    def edit(text, old=old, new=new):
        assert old in text
        return text.replace(old, new)

    return edit


@feature("F219", G)
def _(b):
    blanks = b.static(edit=edited("1500.0, 0.0, 500.0, 0.0, 0.0, 0.0", "1.5E3\n 0. 5.0d2, 3*0.0 /"))
    return blanks.command, [close("load of a deck with blanks, exponents D, repeats and two lines, that of the example [N]", blanks.summary["largest_contact_load_N"],
                                  b.static().summary["largest_contact_load_N"], 1e-12)]


@feature("F220", G)
def _(b):
    r = b.static(edit=edited("'Rec 9.1.1'", "'MyLoad 9.1.1'"))
    return r.command, [equal("label in the listing", r.listing.count("MyLoad 9.1.1"), 1), equal("label of the example", b.static().listing.count("MyLoad 9.1.1"), 0)]


@feature("F221", G)
def _(b):
    code = "run code of thirty-six characters 36"
    r = b.run(until=TINY, sets={"runID": code}, edit=None)
    pages = [line for line in r.listing.splitlines() if line.startswith("Adore ")]
    return r.command, [equal("run code of SOL1", r.sol("SOL1").run_id, code), equal("of SOL8", r.read("SOL8").splitlines()[0][17:53], code),
                       equal("pages of PRINT.txt without it", sum(code not in line for line in pages), 0), more("pages", len(pages), 5)]


@feature("F222", G)
def _(b):
    good, bad = b.static(edit=edited("'Rec 9.1.1', 1500.0", "'Rec 9.1.1', 1500")), b.static(edit=edited("'Rec 3.2', 1, 1, 12", "'Rec 3.2', 1, 1, 12.0"), check=False)
    return good.command, [close("load of a real without a point [N]", good.summary["load_x_N"], 1500.0, 1e-9), equal("an integer with a point: exit code", bad.code, 2),
                          equal("the text names nRe", "nRe" in bad.err, True)]


@feature("F223", G)
def _(b):
    plain, table = b.static(), b.static(sets={"kStif": 3, "pctDisp": 1.0, "rpmRange12": 1000.0, "rpmRange22": 5000.0})
    free = b.static(sets={"nCseg": 0})
    return table.command, [equal("record 9.2 in the listing of kStif = 3", table.listing.count("Record 9.2"), 1), equal("of kStif = 0", plain.listing.count("Record 9.2"), 0),
                           equal("records 7 without a cage", free.listing.count("Record 7."), 0), more("with a cage", plain.listing.count("Record 7."), 2)]


@feature("F224", G)
def _(b):
    si, en = b.run(until="0.05rev"), b.run("ball-english", until="0.05rev")
    x, y = si.sol("SOL1"), en.sol("SOL1")
    return en.command, [close("contact load [lbf], that in N over 4.44822", y.values[0][15], x.values[0][15] / 4.4482216152605, 2e-3),
                        close("radial position [in], that in m over 0.0254", y.values[0][7], x.values[0][7] / 0.0254, 1e-3),
                        close("orbital speed [rpm]", y.values[0][3], x.values[0][3], 2e-3), equal("unit of length in the header", "in" in y.units, True)]


@feature("F225", G)
def _(b):
    r = b.static()
    q = r.elements["inner load [N]"]
    side = b.static(sets={"appLoadY": 500.0, "appLoadZ": 0.0}).elements["inner load [N]"]
    return r.command, [equal("load along +z: the most loaded ball is number", q.index(max(q)) + 1, 1), equal("load along +y: azimuth 270 deg (y = -r sin t), ball", side.index(max(side)) + 1, 10),
                       more("thrust along +x: displacement [m]", r.summary["displacement_x_m"], 0.0)]


@feature("F226", G)
def _(b):
    names = {"masName": "mine.mas", "finName": "mine.fin", **{f"pltNames{k}": f"mine.{k}" for k in range(1, 9)}}
    r, usual = b.run(until=TINY, sets={"kFnOpt": 1, **names}), b.run(until=TINY)
    state, other = (text.split("\ndeck ", 1)[0] for text in (r.read("mine.fin"), usual.read("FINAL")))
    same = [r.read(names[n]) == usual.read(o) for n, o in (("pltNames1", "SOL1"), ("pltNames4", "SOL4"), ("pltNames7", "SOL7"), ("pltNames8", "SOL8"))]
    usual_names = ["MASTER", "FINAL"] + [f"SOL{k}" for k in range(1, 9)]
    written = [n for n in names if r.has(names[n])]
    return r.command[:150] + " ...", [equal("files of these names (4 elements are stored, so that names 5 and 6 are free)", written, [n for n in names if n not in ("pltNames5", "pltNames6")]),
                                      equal("files of the usual names", [n for n in usual_names if r.has(n)], []),
                                      equal("SOL1, SOL4, SOL7 and SOL8 are those of a run with the usual names", same, [True] * 4),
                                      equal("the state in FINAL is that of FINAL (the deck that follows has the names)", state == other, True), more("its lines", len(state.splitlines()), 100)]


@feature("F227", "user")
def _(b):
    plug = b.formulas("readload", {"version": "reads", "adrx1": {"read": ["F"], "inner_race": {"force": ["0", "0", "F"]}}})
    free = {"kDCR": 1, **{n: 1 for n in FLAGS}, "kFD32": 0}
    z = []
    for force in (0.0, 1000.0, 2000.0):
        r = b.run(sets=free, until="0.002rev", more=["--user", plug], tail=f"{force}\n")
        c = b.channels(r)
        z.append(c["race.z.2"][-1])
    return r.command, [close("motion by 2000 N over that by 1000 N, numbers of record 12", (z[2] - z[0]) / (z[1] - z[0]), 2.0, 0.02), more("motion [m]", z[1] - z[0], 1e-9)]


FLAGS = ["kFD11", "kFD21", "kFD31", "kFD12", "kFD22", "kFD32", "kMD11", "kMD21", "kMD31", "kMD12", "kMD22", "kMD32"]


@feature("F228", G)
def _(b):
    r = b.static(edit=edited("'Rec 4', 0.040, 0.080, 0.0,", "'Rec 4', 0.040, oops, 0.0,"), check=False)
    return r.command, [equal("exit code", r.code, 2), equal("the text names the record and the variable", "4" in r.err and "brgOD" in r.err, True)]


@feature("F229", G)
def _(b):
    r = b.run(until=TINY, sets={"kNumPltElem": 4, "kPltElemInd": "12,13,14,15"})
    return r.command, [equal("titles of elements 12 to 15", [r.sol(f"SOL{k}").title for k in (1, 2, 3, 4)], ["Rolling Element 12", r.sol("SOL2").title, "Outer Race", "Inner Race"]),
                       equal("header integer 5", [r.sol(f"SOL{k}").integers[4] for k in (1, 2, 3, 4)], [12, 13, 14, 15]), equal("element 13 is the cage", "age" in r.sol("SOL2").title, True)]


def six_is_power(run):
    return run.sol("SOL7").title.startswith("Power")


@feature("F230", G)
def _(b):
    r = b.run(until=TINY, sets={"kNumPltElem": 6, "kPltElemInd": "1,2,3,13,14,15"})
    return r.command, [equal("files SOL1 to SOL6", sum(r.has(f"SOL{k}") for k in range(1, 7)), 6), equal("a seventh file SOL7 of an element: title of SOL7", six_is_power(r), True)]


TITLES = {1: "1. Rolling element parameters", 2: "2. Race and cage parameters", 3: "3. Applied parameters", 4: "4. Time step summary"}


def printed(run):
    """The printed steps of PRINT.txt: number -> text without page headers."""
    out, at = {}, None
    for line in run.listing.splitlines():
        if line.startswith("Adore "):
            found = re.search(r" STEP (\d+)( \(continued\))?$", line.rstrip())
            at = int(found.group(1)) if found else None
            if at is not None:
                out.setdefault(at, [])
        elif at is not None:
            out[at].append(line)
    return {k: "\n".join(v) for k, v in out.items()}


def sections(text):
    return [k for k, title in TITLES.items() if f"  {title}" in text]


def section(text, k):
    return text.split(f"  {TITLES[k]}", 1)[1].split(f"  {TITLES.get(k + 1, 'none')}", 1)[0]


def value_of(text, label):
    """The number behind a label of section 3 or 4."""
    line = next(x for x in text.splitlines() if x.strip().startswith(label))
    return float(line.split(label, 1)[1].split()[0])


def rows_of(text, label):
    """Numbers of the rows that begin with `label`."""
    return [words(x.split(label, 1)[1]) for x in text.splitlines() if x.strip().startswith(label)]


@feature("F231", G)
def _(b):
    out = []
    for code, wanted in ((-2, [4]), (-1, [3, 4]), (0, [2, 3, 4]), (1, [1, 2, 3, 4]), (3, [1, 2, 3, 4])):
        steps = printed(b.run(until=TINY, sets={"kPrtOpt": code, "kPrtFreq": 1}))
        out.append(equal(f"kPrtOpt = {code}: sections of every step", sorted({tuple(sections(t)) for t in steps.values()}), [tuple(wanted)]))
    return "adore run ball.txt --set kPrtOpt=-2 --set kPrtFreq=1 --until 0.005rev", out


@feature("F232", G)
def _(b):
    out = []
    for n, wanted in ((1, list(range(13))), (3, [0, 3, 6, 9, 12]), (5, [0, 5, 10])):
        steps = printed(b.run(until=None, sets={"maxStps": 12, "kPrtFreq": n, "kPrtOpt": -2}))
        # the last step is printed with any interval
        out.append(equal(f"kPrtFreq = {n}: printed steps of 12", [k for k in steps if k % n == 0], wanted))
        out.append(equal("others than the last", [k for k in steps if k % n and k != 12], []))
    return "adore run ball.txt --set maxStps=12 --set kPrtFreq=3 --set kPrtOpt=-2", out


@feature("F233", G)
def _(b):
    def balls(n):
        first = section(printed(b.run(until=TINY, sets={"kPrtOpt": n, "kPrtFreq": 1}))[0], 1)
        table = first.split("radial vel", 1)[1].split("Angular position", 1)[0]
        return [int(x.split()[0]) for x in table.splitlines() if x.split() and x.split()[0].isdigit()]

    return "adore run ball.txt --set kPrtOpt=4 --set kPrtFreq=1 --until 0.005rev", [
        equal("kPrtOpt = 1: printed balls", balls(1), list(range(1, 13))), equal("kPrtOpt = 4", balls(4), [1, 5, 9]), equal("kPrtOpt = 5", balls(5), [1, 6, 11])]


@feature("F234", G)
def _(b):
    text = b.run(until=BASE).listing
    heads = ["INPUT", "BEARING GEOMETRY", "MATERIAL PROPERTIES AND INERTIA", "INITIAL OPERATING CONDITIONS"]
    return "adore run ball.txt --until 0.3rev", [equal("pages of the front part", [any(h in x for x in text.splitlines() if x.startswith("Adore")) for h in heads], [True] * 4),
                                                 equal("constraints, scales and output control", [w in text for w in ("Constraints of the races", "Scale factors", "Output control")], [True] * 3)]


@feature("F235", G)
def _(b):
    r = b.run(until=BASE)
    c = b.channels(r)
    part = r.listing.split("ROLLING ELEMENT PARAMETERS")[-1]
    q = f"{c['contact.load.1.1'][-1]:.5g}"
    return r.command, [equal(f"load of ball 1 of RESULTS.h5 ({q} N) in section 1", q in part, True)]


def wear_table(run):
    """Page 1c of the last step: heights, radii, depths of the flange, distances from the roller axis, depths of the end."""
    part = run.listing.split("1c. Wear depth per time on the end of roller 1 and on the inner race flange, -x side")[-1].splitlines()
    rows = [[float(w) for w in line.split()[1:]] for line in part[4:13]]
    return list(zip(*rows))


def simpson(x, y):
    return (x[-1] - x[0]) / (3 * (len(x) - 1)) * sum(w * v for w, v in zip([1, 4, 2, 4, 2, 4, 2, 4, 1], y))


@feature("F236", G)
def _(b):
    r, slow = b.run("tapered", until="0.02rev"), b.run("tapered", sets={"rpm2": 1500.0}, until="0.02rev")
    c = b.channels(r)
    height, radius, flange, from_axis, end = wear_table(r)
    both = 1e-6 / 7.061e9 * c["flange.load_slip.1.2.1"][-1]  # K/H Q u, alike for both bodies
    loads = []
    for line in r.listing.split("1a. Load and pressure along roller 1")[-1].splitlines():
        if line.split()[:1] == [str(len(loads) + 1)]:
            loads.append(float(line.split()[1]))
        elif line.strip().startswith("1b."):
            break
    ring = [2 * math.pi * x * y for x, y in zip(radius, flange)]
    face = [2 * math.pi * x * y for x, y in zip(from_axis, end)]
    return r.command, [close("1a: loads of the slices of roller 1 together [N]", sum(loads), c["contact.load.1.1"][-1], 1e-3),
                       close("1b: height of the contact up the flange, middle of the distribution [m]", height[4], c["flange.height.1.2.1"][-1], 1e-3),
                       close("1c: depths of the flange times 2 pi r, over its height: K/H Q u [m^3/s]", simpson(height, ring), both, 1e-3),
                       close("1c: depths of the roller end likewise [m^3/s]", simpson(height, face), both, 1e-3),
                       close("1c: at a quarter of the contact, 3/4 of the wear in its middle", ring[2] / ring[4], 0.75, 1e-3),
                       close("1c: depth of the flange at half the speed, over that before", wear_table(slow)[2][4] / flange[4], 0.5, 0.2)]


def in_section(b, head, value, digits=4):
    part = b.run(until=BASE).listing.split(head)[-1]
    return f"{value:.{digits}g}" in part


@feature("F237", G)
def _(b):
    r = b.run(until=BASE)
    part = r.listing.split("RACE AND CAGE PARAMETERS")[-1]
    numbers = words(part)
    v = b.channels(r)["cage.angular_velocity.1.1"][-1] * 30 / math.pi
    return r.command, [less("cage speed [rpm] of RESULTS.h5, nearest number of section 2", min(abs(x / v - 1) for x in numbers), 1e-4)]


def words(text):
    out = []
    for word in text.split():
        try:
            out.append(float(word))
        except ValueError:
            pass
    return out


@feature("F238", G)
def _(b):
    r = b.run(until=TINY, sets={"kPrtOpt": -1, "kPrtFreq": 1, "appMis12": 2e-4, "raceTemp2": 313.15, "shftTemp": 313.15, "rpm1": -200.0, "cageTemp": 303.15})
    steps = printed(r)
    last = max(steps)
    text, c = section(steps[last], 3), b.channels(r)
    t = c["step"].index(last)
    row = rows_of(text, "inner race")[0]
    outer = rows_of(text, "outer race")[0]
    return r.command, [close(f"{n} on the inner race of the last step, RESULTS.h5 [N, N.m]", row[k], c[f"race.applied_{n}.2"][t], 1e-4, 1e-6) for k, n in
                       enumerate(("force_x", "force_y", "force_z", "moment_x", "moment_y", "moment_z"))] + [
        close("speed of the inner race [rpm]", row[6], 10000.0, 1e-6), close("temperature of the inner race [K]", row[7], 313.15, 1e-6), close("speed of the outer race [rpm]", outer[6], -200.0, 1e-6),
        close("displacement along x [m]", value_of(text, "Displacement of the inner relative to the outer race along x"), c["race.x.2"][t] - c["race.x.1"][t], 1e-5),
        close("misalignment of the inner race about y, 0.2 mrad [deg]", value_of(text, "Misalignment of the inner race about y"), math.degrees(2e-4), 1e-4),
        close("operating clearance [m]", value_of(text, "Internal clearance, diametral"), r.fits["operating"]["diametral clearance [m]"], 1e-5),
        close("temperature of the cage [K]", value_of(text, "Cage temperature"), 303.15, 1e-6),
        close("fit of the inner race [m]", value_of(text, "Diametral operating fit, inner race (positive: interference)"), r.fits["inner race"]["operating interference [m]"], 1e-5),
        close("play at guide land 1 [m]", value_of(text, "Cage clearance at guide land 1, diametral"), r.fits["cage play, diametral"]["guide land 1 on the outer race"]["operating [m]"], 0.02)]


@feature("F239", G)
def _(b):
    r = b.run(until=BASE, sets={"kPrtOpt": -2, "kPrtFreq": 40})
    steps, c = printed(r), b.channels(r)
    last = max(steps)
    text, t = section(steps[last], 4), c["step"].index(last)
    shaft = c["shaft_rotation"][t]
    mean = sum(c[f"element.orbital_position.{k}"][t] - c[f"element.orbital_position.{k}"][0] for k in range(1, 13)) / 12 / shaft
    cage = (c["cage.rotation.1"][t] - c["cage.rotation.1"][0]) / shaft
    angle = turns = 0.0
    for k in range(1, t + 1):  # the cage's center around the bearing's
        y, z, y0, z0 = c["cage.position.1.2"][k], c["cage.position.1.3"][k], c["cage.position.1.2"][k - 1], c["cage.position.1.3"][k - 1]
        turns += math.remainder(math.atan2(-y, z) - math.atan2(-y0, z0), 2 * math.pi)
    angle = turns / shaft
    loss = sum(0.5 * (c["power.loss"][k] + c["power.loss"][k - 1]) * (c["time"][k] - c["time"][k - 1]) for k in range(1, t + 1)) / c["time"][t]
    return r.command, [equal("step", value_of(text, "Step"), float(last)), close("time [s]", value_of(text, "Time"), c["time"][t], 1e-5), close("rotation [rev]", value_of(text, "Bearing rotation, inner minus outer race"), 0.3, 1e-5),
                       close("orbital velocity ratio, turned angle of the balls over that of the shaft", value_of(text, "Orbital velocity ratio, average over elements and time"), mean, 1e-4),
                       close("cage angular velocity ratio, turned angle of the cage", value_of(text, "Cage angular velocity ratio, average over time"), cage, 1e-4),
                       close("cage whirl ratio, angle of its centre", value_of(text, "Cage whirl ratio, average over time"), angle, 0.01),
                       close("power loss [W]", value_of(text, "Power loss"), c["power.loss"][t], 1e-5), close("its average over time [W]", value_of(text, "Power loss, average over time"), loss, 0.03),
                       close("average wear rate of the inner race [m^3/s]", value_of(text, "Average wear rate, inner race"), c["race.wear_rate.2"][t], 1e-5),
                       close("life [hr]", value_of(text, "Fatigue life at the current loads (sol7Life)"), c["power.life"][t], 1e-5)]


@feature("F240", G)
def _(b):
    r = b.run(until=BASE)
    c, s = b.channels(r), r.sol("SOL1").values[-1]
    x, y, z = (c[f"element.angular_velocity_vector.1.{a}"][-1] for a in (1, 2, 3))
    size = math.sqrt(x * x + y * y + z * z)
    return r.command, [close("size [rpm]", s[12], size * 30 / math.pi, 1e-6), close("theta = atan2(z, x) [deg], sine", math.sin(math.radians(s[13])), math.sin(math.atan2(z, x)), 1e-4, 1e-5),
                       close("phi = asin(y / size) [deg]", s[14], math.degrees(math.asin(y / size)), 1e-3, 1e-4)]


@feature("F241", G)
def _(b):
    r = b.run("tapered", until="0.1rev")
    c, s = b.channels(r), r.sol("SOL1").values[-1]
    return r.command, [close("theta of SOL1 [deg], RESULTS.h5", s[9], math.degrees(c["element.theta.1"][-1]), 1e-4, 1e-6), close("phi [deg]", s[10], math.degrees(c["element.phi.1"][-1]), 1e-4, 1e-6),
                       close("tilt of a tapered roller's axis, half sum of the cone angles [deg]", abs(s[9]), 12.275, 0.02)]


@feature("F242", G)
def _(b):
    r = b.static(sets={"kStif": 4, "pctDisp": 1.0, "rpmRange12": 1000.0, "rpmRange22": 10000.0})
    part = r.listing.split("STIFFNESS OVER SPEED", 1)[1]
    speeds = [words(x) for x in part.splitlines() if "Outer race" in x and "inner race" in x and "rpm" in x]
    blocks = part.split("Outer race 0 rpm, inner race ")[1:5]
    diagonal = [[words(x.split("exact", 1)[1])[k] for k, n in enumerate(("Fx [N]", "Fy [N]", "Fz [N]")) for x in block.splitlines() if x.strip().startswith(n)] for block in blocks]
    middle = b.static(sets={"rpm2": 4000.0}).summary
    # numerically: forces at displaced races, held by kFS
    held = {"rpm2": 4000.0, "kFS1": 1, "kFS2": 1, "kFS3": 1, **{f"appDisp{a.upper()}": middle[f"displacement_{a}_m"] if a != "y" else 0.0 for a in "xyz"}}
    own = [(b.static(sets={**held, f"appDisp{a.upper()}": held[f"appDisp{a.upper()}"] + 2e-8}).summary[f"load_{a}_N"] -
            b.static(sets={**held, f"appDisp{a.upper()}": held[f"appDisp{a.upper()}"] - 2e-8}).summary[f"load_{a}_N"]) / 4e-8 for a in "xyz"]
    return r.command, [equal("speeds of the table [rpm]", [w[0] if w else 0 for w in [words(x) for x in [blk.split(" rpm")[0] for blk in blocks]]], [1000.0, 4000.0, 7000.0, 10000.0])] + [
        close(f"stiffness {a} at 4000 rpm, difference of the loads of two displaced races [N/m]", diagonal[1][k], own[k], 2e-3) for k, a in enumerate("xyz")] + [
        close("stiffness x at 10000 rpm, that of the solution [N/m]", diagonal[3][0], b.static().summary["stiffness_x_N_per_m"], 1e-6), more("tables", len(speeds), 3),
        equal("in a deck without kStif", "STIFFNESS OVER SPEED" in b.static().listing, False)]


@feature("F243", G)
def _(b):
    r = b.static()
    numbers = words("".join(r.listing.split("QUASI-STATIC SOLUTION")[1:]))
    return r.command, [less("largest load, nearest number", min(abs(x / r.summary["largest_contact_load_N"] - 1) for x in numbers), 1e-4)]


@feature("F244", "user")
def _(b):
    plug = b.formulas("suffix", {"version": "v7", "adrx1": {"inner_race": {"force": ["0", "0", "0"]}}})
    r = b.run(until=TINY, more=["--user", plug])
    return r.command, [equal("suffix in SOL1 or PRINT.txt", "v7" in r.listing.splitlines()[0] or "v7" in r.sol("SOL1").head[0] or "v7" in r.listing, True),
                       equal("without a routine", "v7" in b.run(until=TINY).listing, False)]


@feature("F245", G)
def _(b):
    r = b.run(until=BASE)
    return r.command, [less("widest line of PRINT.txt", max(len(x) for x in r.listing.splitlines()), 133), more("lines", len(r.listing.splitlines()), 500)]


@feature("F246", G)
def _(b):
    a, c = b.run(until="0.05rev"), b.run(until=BASE)
    return a.command, [equal("FINAL written", a.has("FINAL"), True), equal("another end, another file", a.read("FINAL") != c.read("FINAL"), True)]


@feature("F247", G)
def _(b):
    r = b.run(until=BASE)
    text = r.read("MASTER")
    numbers = words(text.replace("=", " ").replace(":", " ").replace(",", " "))
    return r.command, [equal("run code in MASTER", "7208 angular contact, 10000 rpm" in text, True), less("time 0.0018 s, nearest number", min(abs(x - 0.0018) for x in numbers), 1e-9)]


@feature("F248", G)
def _(b):
    r = b.run(until=BASE)
    text = r.read("SOL1").splitlines()
    s = r.sol("SOL1")
    per = 1 + -(-s.integers[0] // 8)
    return r.command, [equal("lines: 4 of the header and steps times lines of a step", len(text), 4 + per * len(s.steps)), close("rotation of the last step [rev]", s.steps[-1][1], 0.3, 1e-6),
                       close("time of the last step [s]", s.steps[-1][4], 0.0018, 1e-6), equal("title ends with $", text[1].rstrip().endswith("$"), True)]


@feature("F249", G)
def _(b):
    r, t = b.run(until=BASE), b.run("tapered", until="0.1rev")
    c, s = b.channels(r), r.sol("SOL1")
    n = len(s.steps) // 2
    checks = [(4, c["element.orbital_velocity.1"][n] * 30 / math.pi), (8, c["element.radial_position.1"][n]), (16, c["contact.load.1.1"][n]), (18, math.degrees(c["contact.angle.1.1"][n])),
              (22, c["contact.slip.1.1"][n]), (24, c["contact.heat.1.1"][n])]
    return r.command, [equal("values of a ball's record (27 and 11 appended)", s.integers[0], 38), equal("of a roller's (39 and 15)", t.sol("SOL1").integers[0], 54)] + [
        close(f"value {k}, that of RESULTS.h5", s.values[n][k - 1], v, 1e-5, 1e-12) for k, v in checks]


@feature("F250", G)
def _(b):
    r, t = b.run(until=BASE), b.run("cylindrical", until="0.05rev")
    c, s = b.channels(r), r.sol("SOL3")
    n = len(s.steps) // 2
    return r.command, [equal("values: 24 + 4 x 12", s.integers[0], 72), equal("cylindrical: 24 + 4 x 2 x 14", t.sol("SOL3").integers[0], 136),
                       close("gap of pocket 3, value 24 + 2 x 4 + 2 [m]", s.values[n][33], c["pocket.gap.3.1"][n], 1e-5), close("land 1 gap, value 5 [m]", s.values[n][4], c["cage.land1_gap.1"][n], 1e-5)]


@feature("F251", G)
def _(b):
    r = b.run(until=BASE)
    c, s = b.channels(r), r.sol("SOL4")
    n = len(s.steps) // 2
    return r.command, [equal("values", s.integers[0], 24), close("force x, value 4 [N]", s.values[n][3], c["race.applied_force_x.2"][n], 1e-6),
                       close("speed, value 22 [rpm]", s.values[n][21], 10000.0, 1e-6), close("z, value 15 [m]", s.values[n][14], c["race.z.2"][n], 1e-6)]


@feature("F252", G)
def _(b):
    r = b.run(until=BASE)
    c, s = b.channels(r), r.sol("SOL7")
    n = len(s.steps) // 2
    heat = sum(c[f"contact.{kind}.{k}.{race}"][n] for k in range(1, 13) for race in (1, 2) for kind in ("heat", "damping_heat"))
    heat += sum(c[name][n] for name in ("power.pocket_heat", "power.land_heat", "power.pocket_damping", "power.land_damping") if name in c)
    return r.command, [equal("values without thermal analysis", s.integers[0], 17), close("power, sum of all contacts [W]", s.values[n][0], heat, 1e-4),
                       close("life [hr]", s.values[n][2], c["power.life"][n], 1e-5), equal("temperatures [K]", s.values[n][13:17], [293.15] * 4)]


@feature("F253", G)
def _(b):
    r = b.run(until=BASE)
    line = r.read("SOL8").splitlines()[3]
    values = [float(line[2 + 10 * k:12 + 10 * k]) for k in range(12)]
    return r.command, [close(f"geometry value {k}", values[k - 1], v, 2e-3) for k, v in ((1, 0.033), (2, 0.029), (3, 1.489e-4), (5, 2.5e-4), (7, 0.00635), (8, 0.060), (9, 0.040), (12, 0.020))]


@feature("F254", G)
def _(b):
    r = b.run(until=BASE)
    lines = r.read("SOL8").splitlines()
    counts = [int(lines[1][2 + 3 * k:5 + 3 * k]) for k in range(14)]
    return r.command, [equal("values per record, 11 n + 22", counts[13], 11 * 12 + 22), equal("lines per record", (len(lines) - 4) % 13, 0), equal("elements", counts[1], 12)]


ADRX9 = ("int32_t adrx9(adore_adrx9* a) { if (a->call.mode == ADORE_READ) a->call.active = 1; if (a->call.mode == ADORE_STEP) { char t[900]; int n = snprintf(t, sizeof t,"
         " \"%.9e %.9e %.9e %.9e\", a->call.time, a->load[0], a->total_heat, a->theta[0]); double s = 0, z = 0; for (int64_t i = 0; i < a->sources; ++i) { s += a->source_heat[i];"
         " if (a->source_place[3*i] == 0 && a->source_place[3*i+1] == 0 && a->source_place[3*i+2] == 0) z += a->source_heat[i]; }"
         " snprintf(t + n, sizeof t - n, \" %.9e %.9e\\n\", s, z); a->call.services->write(a->call.host, t); } return 0; }\n")


def sol9(b, until="0.05rev", **sets):
    r = b.run(until=until, sets=sets, more=["--user", b.plug_in("adrx9_rows", ADRX9)])
    return r, [[float(v) for v in line.split()] for line in r.read("SOL9").splitlines() if len(line.split()) == 6]


@feature("F255", "user")
def _(b):
    r, rows = sol9(b)
    c = b.channels(r)
    return r.command, [equal("lines of SOL9, the counted steps", abs(len(rows) - r.json["steps"]) <= 1, True), close("load of ball 1 at the last step [N]", rows[-1][1], c["contact.load.1.1"][-1], 1e-6)]


@feature("F256", G)
def _(b):
    r, t = b.run(until=BASE), b.run("tapered", until="0.1rev")
    s = r.sol("SOL1")
    return r.command, [equal("used lengths of the unit strings", s.integers[7:16], [len(u) for u in s.units[:9]]), equal("flanges of the tapered bearing: outer, inner", t.sol("SOL1").integers[5:7], [0, 1]),
                       equal("of the cylindrical one", b.run("cylindrical", until="0.05rev").sol("SOL1").integers[5:7], [1, 0])]


@feature("F257", G)
def _(b):
    r = b.run(until=None, sets={"maxStps": 24, "kPltFreq": 3, "kAGraf": 6})
    none = b.run(until=None, sets={"maxStps": 24, "kAGraf": 0})
    return r.command, [equal("plot records: 24 / 3 + 1", len(r.sol("SOL1").steps), 9), equal("animation records: 24 / 6 + 1", (len(r.read("SOL8").splitlines()) - 4) // 13, 5),
                       equal("SOL8 with kAGraf = 0", none.has("SOL8"), False)]


@feature("F258", G)
def _(b):
    out = os.path.join(b.folder, "twice")
    b.call("run", b.deck("ball"), "--out", out, "--until", "0.02rev", "--quiet")
    again = b.call("run", b.deck("ball"), "--out", out, "--until", "0.02rev", "--quiet", check=False)
    b.call("run", b.deck("ball"), "--out", out, "--until", "0.01rev", "--quiet", "--overwrite")
    s = Sol(open(os.path.join(out, "SOL1"), encoding="utf-8").read())
    return "adore run ball.txt --out twice --until 0.01rev --overwrite", [equal("second fresh run without --overwrite: exit code", again.returncode, 2), close("end after --overwrite [rev]", s.steps[-1][1], 0.01, 1e-6)]


@feature("F259", G)
def _(b):
    out = os.path.join(b.folder, "code")
    b.call("run", b.deck("ball"), "--out", out, "--until", "0.01rev", "--quiet")
    done = b.call("run", b.deck("ball"), "--out", out, "--until", "0.02rev", "--quiet", "--set", "kIcOpt=1", "--set", "runID=another", check=False)
    good = b.call("run", b.deck("ball"), "--out", out, "--until", "0.02rev", "--quiet", "--set", "kIcOpt=1", check=False)
    return "adore run ball.txt --out code --set kIcOpt=1 --set runID=another", [equal("exit code with another run code", done.returncode, 2), equal("the text names both codes",
        "another" in done.stderr and "7208 angular contact, 10000 rpm" in done.stderr, True), equal("exit code with the same code", good.returncode, 0)]


@feature("F348", G)
def _(b):
    text = b.call("examples").stdout
    r = b.static("angular-218")
    return "adore examples", [equal("example decks of five types", all(n in text for n in ("ball", "cylindrical", "spherical", "tapered", "spherical-tapered")), True),
                              more("reference results of the tests", len(os.listdir(os.path.join(b.root, "tests", "reference"))), 0), more("largest load of the 218 bearing [N]", r.summary["largest_contact_load_N"], 100.0)]


@feature("F349", G)
def _(b):
    text = b.call("schema").stdout
    with open(os.path.join(b.root, "tests", "features", "checks_deck.py"), encoding="utf-8") as file:
        own = file.read()
    names = ["mode", "stpInit", "kFD11", "bReDia", "raceGsRadVar3", "cageMIz", "hardnessLFre", "brgLoadFrac2", "tracVisCoeff2", "gravityVecZ"]
    return "adore schema", [equal("variables of the first to the last record", [n in text for n in names], [True] * len(names)), more("lines", len(text.splitlines()), 300), more("text", len(own), 0)]


@feature("F350", G)
def _(b):
    r = b.run(until=BASE)
    plot, film = os.path.join(b.folder, "p350"), os.path.join(b.folder, "a350")
    b.call("plot", r.path("SOL7"), "--out", plot)
    b.call("animate", r.path("SOL8"), "--frame", "1", "--out", film)
    return "adore run ball.txt; adore plot SOL7; adore animate SOL8 --frame 1", [more("pages drawn", len(os.listdir(plot)), 2), equal("frames drawn", len(os.listdir(film)), 1), equal("exit code of the run", r.code, 0)]
