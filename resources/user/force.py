"""ADRXN for Adore: normal force between THE_BODIES. This example adds damping during approach to the built-in law.
Record 12.1 contains the damping time [s]."""

import sys

import numpy as np

import adore

routines = adore.Routines("force 1")
routines.read("the_kind", 1)


@routines.force("the_kind")
def force(contacts):
    return np.maximum(0.0, contacts.built_in * (1.0 + contacts.numbers[0] * contacts.gap_rate / contacts.gap))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(f"give a deck and a folder: python3 {sys.argv[0]} DATA.txt OUT")
    print(adore.read(sys.argv[1]).run(sys.argv[2], user=routines, overwrite=True))
    print(routines.cost())
