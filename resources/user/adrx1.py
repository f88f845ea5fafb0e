"""ADRX1 for Adore: driven races. Record 12.1 contains t1, t2 [s] and two speeds [rpm] of the inner race, record 12.2 the
amplitude [m] and frequency [Hz] of the housing along z."""

import sys

import numpy as np

import adore

routines = adore.Routines("motion 1")
routines.read("motion", 6)


@routines.motion
def motion(now):
    t1, t2, first, last, amplitude, frequency = now.numbers
    omega = 2.0 * np.pi * frequency
    if now.start:
        return {
            "drives": [amplitude != 0.0, t2 > t1],
            "start_velocity": [[0.0, 0.0, amplitude * omega], [0.0, 0.0, 0.0]],
            "kinks": [t for t in (t1, t2) if t > 0.0],
            "longest_step": 0.05 / frequency if frequency else 0.0,
        }
    out = np.zeros((2, 3))
    turn = np.zeros((2, 3))
    out[0, 2] = -amplitude * omega**2 * np.sin(omega * now.time)
    if t1 <= now.time < t2:
        turn[1, 0] = (last - first) * np.pi / 30.0 / (t2 - t1)
    return {"acceleration": out, "angular_acceleration": turn}


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(f"give a deck and a folder: python3 {sys.argv[0]} DATA.txt OUT")
    print(adore.read(sys.argv[1]).run(sys.argv[2], user=routines, overwrite=True))
    print(routines.cost())
