"""ADRX7 for Adore: traction coefficient of elements and races as a function of slip u (kTrac = -1), (A + B u) exp(-C u) + D.
A table is built from the function, so that a run does not call Python. `routines.errors` contains the error of the table."""

import sys

import numpy as np

import adore

routines = adore.Routines("traction 1")
A, B, C, D = -0.04, 0.05, 3.0, 0.04


@routines.traction("element_race", table=True, slip_scale=1.0 / C)
def traction(slip):
    return (A + B * slip) * np.exp(-C * slip) + D


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(f"give a deck and a folder: python3 {sys.argv[0]} DATA.txt OUT")
    print(adore.read(sys.argv[1]).run(sys.argv[2], user=routines, overwrite=True))
    print(routines.cost())
