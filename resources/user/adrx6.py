"""ADRX6 for Adore: surfaces of races (kRaceGeoImp1, kRaceGeoImp2 = 3). In this example, the radius of the inner race
has waves. Record 12.1 contains amplitude [m], number per revolution and phase [rad]."""

import sys

import numpy as np

import adore

routines = adore.Routines("waves 1")
routines.read("races", 3)


@routines.races
def waves(places):
    amplitude, number, phase = places.numbers
    return amplitude * np.sin(number * places.azimuth + phase) if places.race == "inner_race" else 0.0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(f"give a deck and a folder: python3 {sys.argv[0]} DATA.txt OUT")
    print(adore.read(sys.argv[1]).run(sys.argv[2], user=routines, overwrite=True))
    print(routines.cost())
