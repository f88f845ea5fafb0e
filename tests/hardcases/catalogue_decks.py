#!/usr/bin/python3
"""Random decks of bearings that an engineer would run, for comparisons of modes: five types, dry and in oil, a third of them thermal.

Geometry is the example deck of the type, scaled to a catalogue bore, with another number of elements, contact angle, conformity, crown and
clearance. The load is a share of the basic dynamic rating, C/50 to C/5, in a direction that the type carries; it is above the minimum load
that bearing makers recommend. The speed is a share of the limiting n x dm of the type. Oils are at a temperature at which their film
separates the surfaces. Deck N of a seed is the same on every machine.

Sources: rating after ISO 281 (Harris and Kotzalas, Rolling Bearing Analysis, chapter on load rating: recalled, high); factors X and Y of ISO 281 (recalled,
medium); minimum loads of the SKF general catalogue (recalled, medium: Fa >= 0.0014 C0 (n dm / 1e5)^2 for angular contact balls, 0.02 C for rollers,
0.01 C for balls); limits of n x dm: choice, below the usual limiting speeds of oil-lubricated bearings.
"""

import math
import random

TYPES = ["ball", "cylindrical", "spherical", "tapered", "spherical-tapered"]
BORES = [0.025, 0.030, 0.035, 0.040, 0.045, 0.050, 0.060, 0.070, 0.080]  # [m]; the examples have 0.040
EXAMPLE_BORE = 0.040
# Least and largest n x dm [mm rpm].
SPEEDS = {"ball": (1.0e5, 8.0e5), "cylindrical": (1.0e5, 4.0e5), "spherical": (1.0e5, 2.0e5), "tapered": (1.0e5, 2.5e5),
          "spherical-tapered": (1.0e5, 2.0e5)}
LARGEST_PRESSURE = 3.0e9  # [Pa], of the equilibrium
# Oils by code of kTrac, with temperatures at which a bearing runs with them [K].
OILS = {1: (310.0, 350.0), 3: (310.0, 370.0), 4: (310.0, 370.0), 5: (310.0, 370.0), 6: (310.0, 370.0), 7: (310.0, 370.0), 10: (310.0, 370.0),
        11: (310.0, 370.0), 13: (330.0, 390.0), 18: (310.0, 360.0), 19: (310.0, 360.0)}


class Dice(random.Random):
    def decades(self, low, high):
        """Uniform in the logarithm."""
        return low * (high / low) ** self.random()

    def yes(self, probability):
        return self.random() < probability


def example_values(path):
    """Numbers of the records of an example deck by record, without comments."""
    out = {}
    with open(path, encoding="utf-8") as file:
        for line in file:
            label, _, rest = line.partition("',")
            numbers = []
            for word in rest.replace(",", " ").split():
                try:
                    numbers.append(float(word))
                except ValueError:
                    break
            out[label.strip("'").removeprefix("Rec ")] = numbers
    return out


# Variables of a record that are lengths in proportion to the size: index in the record and name.
LENGTHS = {
    "4": {0: "brgBore", 1: "brgOD", 3: "hsngOD", 4: "raceWidth1", 5: "raceWidth2"},
    "5A": {0: "bReDia", 1: "pitchDia", 6: "shoulderDia1", 7: "shoulderDia2"},
    "5B.1": {0: "bReDia", 1: "bReCrn", 2: "bReLen", 3: "bReCenLen", 4: "bReCorRad1", 5: "bReCorRad2", 6: "pitchDia"},
    "5B.2": {0: "raceLandLmt1", 3: "raceLandLmt2"},
    "5C": {0: "bReDia", 1: "bReCrn", 2: "bReLen", 3: "bReCorRad1", 4: "bReCorRad2", 5: "pitchDia"},
    "5D.1": {0: "bReDia", 1: "bReCrn", 2: "bReLen", 3: "bReCenLen", 4: "bReEndRad1", 5: "bReEndRad2", 6: "bReCorRad1", 7: "bReCorRad2"},
    "5D.2": {0: "raceLandLmt1", 3: "raceLandLmt2"},
    "5E": {0: "bReDia", 1: "bReCrn", 2: "bReLen", 3: "bReEndRad1", 4: "bReEndRad2"},
    "5F": {4: "flngHt11", 5: "flngHt21", 6: "flngHt12", 7: "flngHt22", 8: "flngCls1"},
    "7.1": {0: "cageDia1", 1: "cageDia2", 2: "cageWidth", 3: "cageCls1", 4: "cageCls2", 5: "bPocCls1", 6: "bPocCls2"},
    "7.2.1": {0: "cageGsDia[1]", 1: "cageGsWidth[1]", 2: "cageGsPos[1]", 3: "cageGsCls[1]"},
    "7.2.2": {0: "cageGsDia[2]", 1: "cageGsWidth[2]", 2: "cageGsPos[2]", 3: "cageGsCls[2]"},
    "9.6": {3: "cageGcPos[1]", 4: "cageGcPos[2]", 5: "cageGcPos[3]"},
}
CAGE_RECORDS = ("7.1", "7.2.1", "7.2.2", "9.6")


def rating(kind, g):
    """Basic dynamic rating C of one row [N]; a: contact angle [rad], d, dm, length [m], z elements, f1 and f2 conformities."""
    d, dm, z, a = 1e3 * g["d"], 1e3 * g["dm"], g["z"], g["a"]
    gamma = d * math.cos(a) / dm
    if kind == "ball":
        shape = (g["f2"] * (2.0 * g["f1"] - 1.0) / (g["f1"] * (2.0 * g["f2"] - 1.0))) ** 0.41
        bracket = 1.0 + (1.04 * ((1.0 - gamma) / (1.0 + gamma)) ** 1.72 * shape) ** (10.0 / 3.0)
        fc = (39.9 * bracket ** -0.3 * gamma ** 0.3 * (1.0 - gamma) ** 1.39 / (1.0 + gamma) ** (1.0 / 3.0)
              * (2.0 * g["f2"] / (2.0 * g["f2"] - 1.0)) ** 0.41)
        return fc * math.cos(a) ** 0.7 * z ** (2.0 / 3.0) * d ** 1.8
    bracket = 1.0 + (1.04 * ((1.0 - gamma) / (1.0 + gamma)) ** (143.0 / 108.0)) ** 4.5
    fc = 0.83 * 207.9 * bracket ** (-2.0 / 9.0) * gamma ** (2.0 / 9.0) * (1.0 - gamma) ** (29.0 / 27.0) / (1.0 + gamma) ** 0.25
    return fc * (1e3 * g["length"] * math.cos(a)) ** (7.0 / 9.0) * z ** 0.75 * d ** (29.0 / 27.0)


def equivalent_load(kind, angle, axial, radial):
    """P of ISO 281 for one row [N]."""
    degrees = math.degrees(angle)
    if kind == "ball":
        x, y = (0.56, 1.5) if degrees < 10.0 else (0.44, 1.2) if degrees < 20.0 else (0.41, 0.87) if degrees < 32.0 else (0.35, 0.57)
    elif kind == "cylindrical" or kind == "spherical":
        return radial
    else:
        x, y = 0.4, 0.4 / math.tan(angle)
    return max(radial, x * radial + y * axial)


def draw_deck(dice, example, kind):
    """One proposal: values for --set, and data of the bearing; None when its load is below the minimum."""
    scale = dice.choice(BORES) / EXAMPLE_BORE
    # Barrels have no flanges here: without a cage nothing guides them, and they turn out of line by 30° (decision 871).
    cage = dice.yes(0.7) or kind == "spherical"
    sets = {name: scale * example[record][k] for record, names in LENGTHS.items() if record in example and (cage or record not in CAGE_RECORDS)
            for k, name in names.items()}
    geometry = {"d": sets["bReDia"], "dm": sets.get("pitchDia", 0.0), "length": sets.get("bReLen", 0.0), "f1": 0.52, "f2": 0.52}
    largest = int(example["3.2"][2])
    # Without a cage: rollers as many as fit, as such bearings are made. Balls with gaps and, below, in thrust, so that each is driven all the way
    # round and none gathers with others: statics have no contact between elements.
    pitch = geometry["dm"] or scale * 0.060
    full = math.floor(0.995 * math.pi * pitch / geometry["d"])
    geometry["z"] = sets["nRe"] = dice.randint(max(8, largest - 4), largest) if cage or kind == "ball" else full
    if kind == "ball":
        angle = dice.choice((0.0, 15.0, 25.0, 25.0, 40.0) if cage else (15.0, 25.0, 40.0))
        sets["kAngVel"] = 0  # spin of least heat
        sets["freeConAng"] = angle
        geometry["f1"], geometry["f2"] = dice.uniform(0.515, 0.53), dice.uniform(0.51, 0.525)
        if angle == 0.0:  # deep groove: the contact angle follows from the clearance
            sets["freeIntCls"] = scale * dice.uniform(5e-6, 2.5e-5)
            angle = 12.0
    elif kind == "spherical":
        angle = sets["freeConAng"] = dice.uniform(6.0, 10.0)
        geometry["f1"], geometry["f2"] = dice.uniform(0.508, 0.52), dice.uniform(0.508, 0.52)
        sets["freeIntCls"] = scale * dice.uniform(0.0, 3e-5)
        sets["bPocCls1"] *= dice.decades(0.2, 1.0)  # barrels skew between open races as far as their windows let them (decision 261)
    elif kind == "cylindrical":
        angle = 0.0
        sets["freeIntCls"] = scale * dice.uniform(5e-6, 4e-5)
        sets["bReCrn"] *= dice.decades(0.5, 4.0)
    else:
        angle = example["5D.1" if kind == "tapered" else "5E"][8 if kind == "tapered" else 5]
        geometry["dm"] = scale * 0.060
        if kind == "tapered":
            sets["bReCrn"] *= dice.decades(0.5, 2.0)
        else:
            geometry["f1"], geometry["f2"] = dice.uniform(0.508, 0.52), dice.uniform(0.508, 0.52)
    if kind in ("ball", "spherical", "spherical-tapered"):
        sets["raceCurFac1"], sets["raceCurFac2"] = geometry["f1"], geometry["f2"]
    geometry["a"] = math.radians(angle)
    if cage and "7.2.1" not in example:
        # Windows alone do not center a cage: within two revolutions it is off the bearing axis by more than its clearance to the outer race.
        sets["nGL"] = 2
        for k in (1, 2):
            sets.update({f"iCageGuide[{k}]": 1, f"cageGsDia[{k}]": sets["cageDia1"], f"cageGsWidth[{k}]": scale * 0.002,
                         f"cageGsPos[{k}]": (-0.5 if k == 1 else 0.5) * sets["cageWidth"], f"cageGsCls[{k}]": scale * 0.0003})

    capacity = rating(kind, geometry)
    load = capacity * dice.decades(0.02, 0.2)
    if kind == "ball" and sets["freeConAng"] > 0.0:
        direction = dice.uniform(0.0, min(2.0, (1.2 if cage else 0.3) / math.tan(geometry["a"])))  # radial over axial
        axial, radial = 1.0, direction
    elif kind == "ball":
        axial, radial = dice.uniform(0.1, 0.5), 1.0
    elif kind in ("tapered", "spherical-tapered"):
        axial, radial = dice.uniform(0.4, 1.2), 1.0
    else:
        axial, radial = 0.0, 1.0
    factor = load / equivalent_load(kind, geometry["a"], axial, radial)
    sets["appLoadX"], sets["appLoadZ"] = factor * axial, factor * radial

    ndm = dice.decades(*SPEEDS[kind])
    sets["rpm2"] = ndm / (1e3 * geometry["dm"])
    static_rating = 0.6 * capacity
    if kind == "ball" and sets["freeConAng"] > 0.0 and sets["appLoadX"] < 1.4e-3 * static_rating * (ndm / 1e5) ** 2:
        return None

    oil = dice.choice((0, 0, 0, *OILS)) if dice.yes(0.55) else 0
    thermal = dice.yes(1.0 / 3.0)
    temperature = dice.uniform(*OILS[oil]) if oil else dice.uniform(293.15, 363.15)
    for name in ("roomTemp", "hsngTemp", "shftTemp", "raceTemp1", "raceTemp2", "reTemp", "cageTemp"):
        sets[name] = temperature
    if oil:
        sets.update(kTrac=oil, reRaceFilm=1e-8, strParam=10.0)
    if thermal:  # short means and a cold start, as users have it. No material laws: equilibria at given temperatures have none (decision 872).
        sets.update(kTherm=1, kCoolant=1 if oil else 0, kBaseTemp=3 if oil else 1, kHTC=0, kGeoMod=1, kMatPropMod=0, baseTemp=temperature,
                    cFlowRate=scale * dice.decades(5e-6, 5e-5), aveTime=12.0 / sets["rpm2"], skipTime=12.0 / sets["rpm2"],
                    shftID=0.5 * sets["brgBore"])
    if not cage:
        sets["nCseg"] = 0
    return {"type": kind, "sets": sets, "rating": capacity, "load": load, "ndm": ndm, "oil": oil, "thermal": thermal, "cage": cage, "pitch_diameter": pitch,
            "temperature": temperature}
