"""AdrInput, AdrPlot and AGORE (F260 to F332): pictures drawn headless, and test cases that drive the windows.

A page of AdrPlot must change when the stored values that it shows are changed in its file, and pages of other values must not.
"""

import glob
import os
import struct
import zlib

from bench import Sol, close, equal, feature, less, more

FLAGS = ["kFD11", "kFD21", "kFD31", "kFD12", "kFD22", "kFD32", "kMD11", "kMD21", "kMD31", "kMD12", "kMD22", "kMD32"]
PLOT, WINDOW = "plots", "windows"
SIZE = ("--size", "720x480")


def perturbed(text, columns):
    """The file with a bump in the given values of every step."""
    lines = text.split("\n")
    sol = Sol(text)
    count, rows = sol.integers[0], -(-sol.integers[0] // 8)
    for number in columns:
        values = sol.column(number)
        span = max(max(values) - min(values), 1e-3 * max(abs(v) for v in values), 1e-9)
        for k in range(len(sol.steps)):
            at = 4 + k * (1 + rows) + 1 + (number - 1) // 8
            place = 2 + 16 * ((number - 1) % 8)
            value = values[k] + span * (0.5 if (k // 3) % 2 else -0.4)
            lines[at] = lines[at][:place] + f"{value:16.7E}" + lines[at][place + 16:]
    assert count >= max(columns)
    return "\n".join(lines)


def pages(b, name, text):
    """The pictures of all pages of a lone file: page -> bytes."""
    folder = os.path.join(b.folder, "pages-" + name)
    if not os.path.isdir(folder):
        os.makedirs(folder)
        path = os.path.join(folder, "SOL")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        b.call(path, "--render", folder, *SIZE, program="adrplot")
    out = {}
    for picture in sorted(glob.glob(os.path.join(folder, "*.png"))):
        with open(picture, "rb") as file:
            out[int(picture.rsplit("-", 1)[1][:-4])] = file.read()
    return out


def source(b, kind):
    thermal = {"kTherm": 1, "kCoolant": 1, "kBaseTemp": 0, "kHTC": 0, "kGeoMod": 1, "kMatPropMod": 0, "baseTemp": 330.0, "cFlowRate": 2e-5, "reHTC": 0.0,
               "cageHTC": 0.0, "aveTime": 0.0006, "skipTime": 0.0006, "shftID": 0.01, "kTrac": 4, "reRaceFilm": 1e-8, "strParam": 10.0,
               **{t: 330.0 for t in ("hsngTemp", "shftTemp", "raceTemp1", "raceTemp2", "reTemp", "cageTemp")}}
    if kind == "power":
        return b.run(sets=thermal, until="0.6rev").read("SOL7")
    if kind == "flanged":
        return b.run("cylindrical", sets={"kFlngInd12": 1, "kFlngInd22": 1, "flngHt12": 0.0015, "flngHt22": 0.0015, "flngAng12": 0.5, "flngAng22": 0.5,
                                          "flngCls2": 5e-5}, until="0.1rev").read("SOL1")
    if kind == "race":
        return b.run(sets={"kDCR": 1, **{n: 0 if n in ("kFD32", "kMD22", "kMD32") else 1 for n in FLAGS}}, until="0.1rev").read("SOL4")
    return b.run(until="0.3rev").read({"element": "SOL1", "cage": "SOL3", "race": "SOL4"}[kind])


def page(identifier, kind, number, columns, other=None):
    @feature(identifier, PLOT)
    def _(b):
        text = source(b, kind)
        base = pages(b, kind, text)
        new = pages(b, f"{kind}-{number}", perturbed(text, columns))
        changed = [k for k in base if base[k] != new.get(k)]
        still = other or (1 if number != 1 else 2)
        return f"adrplot {Sol(text).title.replace(' ', '_')} --render pages --page {number} (values {columns[0]} to {columns[-1]} changed)", [
            equal(f"page {number} changes with its values", number in changed, True), equal(f"page {still} of other values", still in changed, False),
            more("pages", len(base), number - 1)]


for k, (identifier, columns) in enumerate((("F281", [1, 2, 3]), ("F282", [4, 5, 6, 7, 8, 9]), ("F283", [10, 11, 12, 13]), ("F284", [18, 19, 20, 21, 22]),
                                           ("F285", [23, 24, 25, 26])), 1):
    page(identifier, "power", k, columns)
for k, (identifier, columns) in enumerate((("F286", [1, 2, 3]), ("F287", [4, 5, 6]), ("F288", [8, 9]), ("F289", [10, 11]), ("F290", [13, 14]),
                                           ("F291", [16, 17, 18, 19, 20, 21]), ("F292", [22, 23, 28, 29]), ("F293", [24, 25])), 1):
    page(identifier, "element", k, columns)
page("F294", "flanged", 9, [28, 29, 30, 31])
page("F295", "flanged", 10, [34, 35, 36, 37])
for k, (identifier, columns) in enumerate((("F296", [1, 2, 3]), ("F297", [4, 5]), ("F298", [7, 8]), ("F299", [10, 11, 12]), ("F300", [14, 15]), ("F301", [17, 18]),
                                           ("F302", [19, 20]), ("F303", [22, 23]), ("F304", [25, 26])), 1):
    page(identifier, "cage", k, columns, 2 if k in (1, 5, 9) else 1)
for k, (identifier, columns) in enumerate((("F305", [1, 2, 3]), ("F306", [4, 5, 6]), ("F307", [7, 8, 9]), ("F308", [10, 11, 12]), ("F309", [14, 15]), ("F310", [13]),
                                           ("F311", [19, 20]), ("F312", [22, 23])), 1):
    page(identifier, "race", k, columns, 3 if k != 3 else 2)


@feature("F313", PLOT)
def _(b):
    step = 0.25
    text = b.run(sets={"stpInit": step, "stpMin": step, "stpMax": step, "nStps": 1, "maxStps": 60}, until=None).read("SOL4")
    base, new = pages(b, "spectrum", text), pages(b, "spectrum-2", perturbed(text, [13, 14, 15]))
    last = max(base)
    return "adrplot SOL4 --render pages (constant steps)", [equal("last page, the spectrum, changes with the places", base[last] != new[last], True),
                                                            equal("spectrum differs from that of unequal steps", base[last] != pages(b, "race", source(b, "race")).get(last), True)]


@feature("F273", PLOT)
def _(b):
    text = source(b, "race")
    folder = os.path.join(b.folder, "part")
    os.makedirs(folder)
    with open(os.path.join(folder, "SOL4"), "w", encoding="utf-8") as file:
        file.write(text)
    b.call(os.path.join(folder, "SOL4"), "--render", folder, "--page", "2", "--from", "10", "--to", "60", "--every", "5", *SIZE, program="adrplot")
    drawn = glob.glob(os.path.join(folder, "*.png"))
    bad = b.call(os.path.join(folder, "SOL4"), "--render", folder, "--from", "60", "--to", "10", program="adrplot", check=False)
    with open(drawn[0], "rb") as file:
        return "adrplot SOL4 --render pages --page 2 --from 10 --to 60 --every 5", [
            equal("pictures", len(drawn), 1), equal("another picture than that of all steps", file.read() != pages(b, "race", text)[2], True),
            equal("end before the start: exit code", bad.returncode, 2)]


@feature("F272", PLOT)
def _(b):
    path = os.path.join(b.folder, "other.txt")
    with open(path, "w", encoding="utf-8") as file:
        file.write("a text of another program\n" * 20)
    bad = b.call(path, "--render", b.folder, program="adrplot", check=False)
    good = pages(b, "race", source(b, "race"))
    return "adrplot other.txt --render pages", [equal("exit code for a foreign file", bad.returncode, 2), more("pages of a file of the solver", len(good), 8)]


def decode(path):
    """Width, height and RGB rows of a PNG of 8 bits without interlacing."""
    with open(path, "rb") as file:
        data = file.read()
    at, packed, palette = 8, b"", None
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
        elif kind == b"PLTE":
            palette = body
        elif kind == b"IDAT":
            packed += body
        at += 12 + size
    channels = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[colour]
    assert depth == 8
    raw, rows, before = zlib.decompress(packed), [], bytearray(width * channels)
    for y in range(height):
        start = y * (width * channels + 1)
        rule, row = raw[start], bytearray(raw[start + 1:start + 1 + width * channels])
        for x in range(len(row)):
            left = row[x - channels] if x >= channels else 0
            up, corner = before[x], before[x - channels] if x >= channels else 0
            if rule == 1:
                row[x] = (row[x] + left) & 255
            elif rule == 2:
                row[x] = (row[x] + up) & 255
            elif rule == 3:
                row[x] = (row[x] + (left + up) // 2) & 255
            elif rule == 4:
                p = left + up - corner
                a, c, d = abs(p - left), abs(p - up), abs(p - corner)
                row[x] = (row[x] + (left if a <= c and a <= d else up if c <= d else corner)) & 255
        rows.append(row)
        before = row
    if colour == 3:
        return [[tuple(palette[3 * v:3 * v + 3]) for v in row] for row in rows]
    return [[tuple(row[x:x + 3]) if channels > 2 else (row[x],) * 3 for x in range(0, len(row), channels)] for row in rows]


def shown(b, run, name, view, *more_words):
    folder = os.path.join(b.folder, f"view-{name}")
    if not os.path.isdir(folder):
        os.makedirs(folder)
        b.call(run.path("SOL8"), "--render", folder, "--view", view, "--size", "480x360", *more_words, program="agore")
    return decode(sorted(glob.glob(os.path.join(folder, "*.png")))[-1])


def apart(x, y):
    return sum(p != q for row, other in zip(x, y) for p, q in zip(row, other))


def coloured(picture, test):
    return sum(test(*p) for row in picture for p in row)


def view(identifier, name, deck="ball", until="0.3rev", words=()):
    @feature(identifier, PLOT)
    def _(b):
        r = b.run(deck, until=until)
        first, last = shown(b, r, f"{deck}-{name}-1", name, "--frame", "1", *words), shown(b, r, f"{deck}-{name}-n", name, *words)
        other = shown(b, r, f"{deck}-bearing-n" if name != "bearing" else f"{deck}-cage-n", "bearing" if name != "bearing" else "cage")
        return f"agore SOL8 --render pictures --view {name}", [more("pixels that differ between the first and the last frame", apart(first, last), 300),
                                                               more("pixels that differ from another view", apart(last, other), 3000)]


view("F316", "bearing")
view("F317", "cage")
view("F318", "pocket")
view("F319", "element")
view("F320", "race")
view("F321", "flange", "tapered", "0.1rev")


@feature("F327", PLOT)
def _(b):
    picture = shown(b, b.run(until="0.3rev"), "ball-bearing-n", "bearing")
    blue = coloured(picture, lambda r, g, x: x > 140 and x - r > 60 and x - g > 25)
    green = coloured(picture, lambda r, g, x: g > 90 and g - r > 40 and g - x > 25)
    return "agore SOL8 --render pictures --view bearing", [more("blue pixels (frames of the races)", blue, 20), more("green pixels (frame of the cage)", green, 10)]


def red(picture):
    return coloured(picture, lambda r, g, x: r > 150 and r - g > 80 and r - x > 60)


@feature("F328", PLOT)
def _(b):
    touching = b.run(sets={"gravityVecZ": -3000.0, "kAGraf": 1}, until="0.1rev")
    c = b.channels(touching)
    hit = max(range(len(c["time"])), key=lambda t: c["cage.land1_force.1"][t])
    free = next(t for t in range(len(c["time"])) if c["cage.land1_force.1"][t] == 0.0 and c["cage.land2_force.1"][t] == 0.0)
    with_arrow, without = (shown(b, touching, f"arrow-{t}", "cage", "--frame", str(t + 1)) for t in (hit, free))
    return "agore SOL8 --render pictures --view cage (frames with and without a land contact)", [
        more("red pixels with a contact less those without", red(with_arrow) - red(without), 20)]


@feature("F323", PLOT)
def _(b):
    r = b.run(until="0.3rev")
    folder, alone = os.path.join(b.folder, "frames"), os.path.join(b.folder, "alone")
    os.makedirs(folder)
    os.makedirs(alone)
    with open(os.path.join(alone, "SOL8"), "w", encoding="utf-8") as file:
        file.write(r.read("SOL8"))
    b.call(os.path.join(alone, "SOL8"), "--render", folder, "--view", "cage", "--every", "1", "--size", "320x240", program="agore")
    return "agore SOL8 --render pictures --view cage --every 1", [equal("pictures, the stored frames", len(os.listdir(folder)), (len(r.read("SOL8").splitlines()) - 4) // 13)]


@feature("F332", PLOT)
def _(b):
    cut = b.run("ball-thrust", sets={"nCseg": 3, "cageAngCut": 2.0, "kPltElemInd": "1,13,14,15", "appLoadZ": 200.0, "lSeg": "1,5,9"})
    whole = b.run()
    return cut.command, [equal("SOL8 of a segmented cage", cut.has("SOL8"), False), equal("SOL8 of a one-piece cage", whole.has("SOL8"), True),
                         equal("RESULTS.h5 plays segments", cut.has("RESULTS.h5"), True)]


def test_names(b):
    if not hasattr(b, "tests"):
        b.tests = {}
        for path in glob.glob(os.path.join(b.root, "tests", "**", "*.cpp"), recursive=True):
            with open(path, encoding="utf-8") as file:
                text = file.read()
            for piece in text.split('TEST_CASE(')[1:]:
                # adjacent literals of a name are one
                name, rest = "", piece.lstrip()
                while rest.startswith('"'):
                    end = rest.index('"', 1)
                    name += rest[1:end]
                    rest = rest[end + 1:].lstrip()
                b.tests[name] = b.tests.get(name, 0) + 1
    return b.tests


def covered(identifier, *names):
    @feature(identifier, WINDOW)
    def _(b):
        tests = test_names(b)
        return "; ".join(f'ctest -R "{n}"' for n in names), [equal(f"tests named '{n}'", tests.get(n, 0), 1) for n in names]


covered("F260", "every record of the schema: its page is built, edited by typing, and reads back equal", "search: result selected → its field has the focus and help shows its record")
covered("F262", "options: record hidden and shown again → its values are kept")
covered("F264", "opening: dropped and recent decks, folders, other files")
covered("F265", "example decks: the second save has the same bytes as the first")
covered("F266", "adrinput: Go Back, Next Rec, Save & Exit and Quit → behavior as in the manual", "run panel: cancel a run; quit during a run → confirmation")
covered("F267", "adrinput: the help of the keys is readable with large letters", "adrinput: keyboard → every action has a menu entry with a shortcut, every button takes the focus")
covered("F268", "adrinput: Go Back, Next Rec, Save & Exit and Quit → behavior as in the manual")
covered("F269", "adrinput: Go Back, Next Rec, Save & Exit and Quit → behavior as in the manual")
covered("F270", "file names: longest possible names are saved and opened", "every app has an icon and an entry in the desktop's menu")
covered("F271", "disclaimer: names warranty and independence, and is remembered", "a file is opened by the question of its steps, however long the window lives meanwhile")
covered("F275", "plot_window: files → opened, rejected with a reason, truncated ones explained")
covered("F276", "plot_window: every key does what the menus promise, wherever the focus is")
covered("F277", "plot_window: Plot Number and the page tree go to a page")
covered("F278", "page_export: SVG and PDF hold lines and text, not pixels")
covered("F279", "plot_window: Save JPG writes the page and proposes the next number", "image_export: names count on, and skip files that exist")
covered("F280", "real windows of all three programs open within a small screen and end on Ctrl+Q")
covered("F314", "disclaimer: names warranty and independence, and is remembered", "agore_window: open dialog → default is the largest number of steps")
covered("F315", "agore_window: a file dropped on it is opened, several are not", "real windows of all three programs open within a small screen and end on Ctrl+Q")
covered("F322", "agore_window: play, frame and pause move through the frames")
covered("F324", "agore_window: play, frame and pause move through the frames")
covered("F325", "agore_window: a picture is saved as pixels or as lines and text, by its name", "motion_picture: SVG and paper hold lines and text, inside the zoomed picture's frame")
covered("F329", "views: bearing picture shows the frames, the arrow, the dashed circle and the asterisks")
covered("F330", "agore_window: the time bar fills and can be clicked")
covered("F331", "views: each view has its data curves")


@feature("F261", WINDOW)
def _(b):
    folder = os.path.join(b.folder, "input-pages")
    b.call(b.deck("ball"), "--render", folder, "--size", "900x600", program="adrinput")
    deck = sum(line.startswith("'") for line in open(b.deck("ball"), encoding="utf-8"))
    return "adrinput ball.txt --render pages", [more("pages of the example ball bearing that it starts with; its deck has that many records", len(os.listdir(folder)), deck - 3)]


@feature("F263", WINDOW)
def _(b):
    tests = [n for n in test_names(b) if n.startswith("a new study") or "New" in n or "example decks: the second save" in n]
    return 'ctest -R "example decks: the second save has the same bytes as the first"', [more("tests that make new decks", len(tests), 0)]


@feature("F274", PLOT)
def _(b):
    text = source(b, "race")
    sol = Sol(text)
    rows = 1 + -(-sol.integers[0] // 8)
    lines = text.rstrip("\n").split("\n")
    body, n = lines[4:], len(sol.steps)
    out, count = lines[:4], 0
    while count < 6000:
        for k in range(n):
            block = body[k * rows:(k + 1) * rows]
            out.append(f"  {count:16d}{count * 0.001:16.7E}" + block[0][34:66] + f"{count * 6e-6:16.7E}")
            out += block[1:]
            count += 1
    long = "\n".join(out) + "\n"
    whole = pages(b, "long", long)
    spike = long.split("\n")
    at = 4 + 5500 * rows + 1
    spike[at] = spike[at][:50] + f"{float(spike[at][50:66]) + 5e4:16.7E}" + spike[at][66:]
    new = pages(b, "long-spike", "\n".join(spike))
    return "adrplot SOL4 --render pages (a file of 6000 steps)", [equal("a peak at step 5500, beyond the 5000 of the manual, is drawn", whole[2] != new[2], True)]


@feature("F326", WINDOW)
def _(b):
    r = b.run(until="0.3rev")
    path = os.path.join(b.folder, "SOL8-old")
    text = r.read("SOL8")
    with open(path, "w", encoding="utf-8") as file:
        file.write("  " + "Another".ljust(10) + text[12:])
    bad = b.call(path, "--render", b.folder, program="agore", check=False)
    good = b.call(r.path("SOL8"), "--render", os.path.join(b.folder, "good8"), "--frame", "1", "--size", "320x240", program="agore", check=False)
    return "agore SOL8 --render pictures", [equal("exit code for a file of this version", good.returncode, 0),
                                            more("text about another program's version, or its picture", len(bad.stderr) + (bad.returncode == 0), 0)]
