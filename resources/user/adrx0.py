"""ADRX0 for Adore: materials of parts with material code 2."""

import sys

import adore

routines = adore.Routines("material 1")


@routines.material
def material(part):
    """Silicon nitride for the rolling elements; other parts keep their default."""
    if part.part == "element":
        return {"density": 3200.0, "elastic_modulus": 310e9, "poisson_ratio": 0.26}


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(f"give a deck and a folder: python3 {sys.argv[0]} DATA.txt OUT")
    print(adore.read(sys.argv[1]).run(sys.argv[2], user=routines, overwrite=True))
    print(routines.cost())
