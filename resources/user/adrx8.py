"""ADRX8 for Adore: imperfections of elements (kReGeoImp = 3) and pockets (kCagePocImp = 4), inertia (kReIP = 3). In this
example, record 12.1 contains the increase in diameter of every second element [m]."""

import sys

import numpy as np

import adore

routines = adore.Routines("imperfections 1")
routines.read("imperfections", 1)


@routines.imperfections
def imperfections(bearing):
    return {"diameter": np.where(np.arange(bearing.n) % 2 == 1, bearing.numbers[0], 0.0)}


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(f"give a deck and a folder: python3 {sys.argv[0]} DATA.txt OUT")
    print(adore.read(sys.argv[1]).run(sys.argv[2], user=routines, overwrite=True))
    print(routines.cost())
