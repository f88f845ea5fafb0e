"""ADRX9 for Adore: what you like, into SOL9. Here a map of the heat: time, name, place and power of every source."""

import sys

import adore

routines = adore.Routines("heat map 1")


@routines.results
def heat(step):
    if step.start:
        return "#       time          x          y          z         heat  source\n"
    return "".join(
        f"{step.time:12.6e} {x:10.3e} {y:10.3e} {z:10.3e} {power:12.5e}  {name}\n"
        for (x, y, z), power, name in zip(step.source_place, step.source_heat, step.source_name)
    )


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(f"give a deck and a folder: python3 {sys.argv[0]} DATA.txt OUT")
    print(adore.read(sys.argv[1]).run(sys.argv[2], user=routines, overwrite=True))
    print(routines.cost())
