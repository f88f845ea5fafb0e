"""ADRX9 for Adore: writes to SOL9. This example writes a heat map: time, contact, position, half axes and power of each heat source."""

import sys

import adore

routines = adore.Routines("heat map 1")


@routines.results
def heat(step):
    if step.start:
        return "#       time kind element race          x          y          z          a          b         heat\n"
    return "".join(
        f"{step.time:12.6e} {kind:4d} {element + 1:7d} {race + 1:4d} {x:10.3e} {y:10.3e} {z:10.3e} {a:10.3e} {b:10.3e} {power:12.5e}\n"
        for kind, element, race, (x, y, z), (a, b), power in zip(
            step.source_kind, step.source_element, step.source_race, step.source_place, step.source_size, step.source_heat
        )
    )


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(f"give a deck and a folder: python3 {sys.argv[0]} DATA.txt OUT")
    print(adore.read(sys.argv[1]).run(sys.argv[2], user=routines, overwrite=True))
    print(routines.cost())
