"""ADRX5 for Adore: radius of the rolling elements. This example gives rollers a crown. The first number of record
12.1 is the length of the straight land [m], the second the radius of the crown beyond the land [m]."""

import sys

import numpy as np

import adore

routines = adore.Routines("crown 1")
routines.read("elements", 2)


@routines.elements
def crown(places):
    land, radius = places.numbers
    e = np.maximum(np.abs(places.axial) - 0.5 * land, 0.0)
    return -e * e / (radius + np.sqrt(radius**2 - e * e))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(f"give a deck and a folder: python3 {sys.argv[0]} DATA.txt OUT")
    print(adore.read(sys.argv[1]).run(sys.argv[2], user=routines, overwrite=True))
    print(routines.cost())
