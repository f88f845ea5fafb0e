"""Values with units: ``deck["pitchDia"] = 60, "mm"`` and ``deck.get("pitchDia", "mm")``."""

from __future__ import annotations

import math
import re
from typing import Tuple

from .errors import UnitError

__all__ = ["convert", "factor"]

# Dimensions: length, mass, time, temperature, angle, hardness.
_Dimension = Tuple[int, int, int, int, int, int]
_NONE: _Dimension = (0, 0, 0, 0, 0, 0)
_LENGTH: _Dimension = (1, 0, 0, 0, 0, 0)
_MASS: _Dimension = (0, 1, 0, 0, 0, 0)
_TIME: _Dimension = (0, 0, 1, 0, 0, 0)
_TEMPERATURE: _Dimension = (0, 0, 0, 1, 0, 0)
_ANGLE: _Dimension = (0, 0, 0, 0, 1, 0)
_HARDNESS: _Dimension = (0, 0, 0, 0, 0, 1)
_FORCE: _Dimension = (1, 1, -2, 0, 0, 0)
_PRESSURE: _Dimension = (-1, 1, -2, 0, 0, 0)
_ENERGY: _Dimension = (2, 1, -2, 0, 0, 0)
_POWER: _Dimension = (2, 1, -3, 0, 0, 0)
_RATE: _Dimension = (0, 0, -1, 0, 0, 0)
_ROTATION: _Dimension = (0, 0, -1, 0, 1, 0)

_INCH, _POUND, _POUND_FORCE = 0.0254, 0.45359237, 4.4482216152605

# Factor to coherent SI with radians, and dimension.
_UNITS: dict[str, tuple[float, _Dimension]] = {
    "1": (1.0, _NONE), "-": (1.0, _NONE), "": (1.0, _NONE), "%": (0.01, _NONE), "cycle/rev": (1.0, _NONE),
    "m": (1.0, _LENGTH), "cm": (1e-2, _LENGTH), "mm": (1e-3, _LENGTH), "um": (1e-6, _LENGTH),
    "µm": (1e-6, _LENGTH), "μm": (1e-6, _LENGTH), "nm": (1e-9, _LENGTH), "in": (_INCH, _LENGTH),
    "kg": (1.0, _MASS), "g": (1e-3, _MASS), "lbm": (_POUND, _MASS),
    "s": (1.0, _TIME), "ms": (1e-3, _TIME), "us": (1e-6, _TIME), "min": (60.0, _TIME), "hr": (3600.0, _TIME),
    "h": (3600.0, _TIME), "K": (1.0, _TEMPERATURE), "R": (5.0 / 9.0, _TEMPERATURE),
    "rad": (1.0, _ANGLE), "mrad": (1e-3, _ANGLE), "deg": (math.pi / 180.0, _ANGLE), "°": (math.pi / 180.0, _ANGLE),
    "rev": (2.0 * math.pi, _ANGLE), "rpm": (math.pi / 30.0, _ROTATION), "Hz": (1.0, _RATE), "kHz": (1e3, _RATE),
    "N": (1.0, _FORCE), "kN": (1e3, _FORCE), "lbf": (_POUND_FORCE, _FORCE),
    "Pa": (1.0, _PRESSURE), "kPa": (1e3, _PRESSURE), "MPa": (1e6, _PRESSURE), "GPa": (1e9, _PRESSURE),
    "bar": (1e5, _PRESSURE), "psi": (_POUND_FORCE / _INCH**2, _PRESSURE),
    "ksi": (1e3 * _POUND_FORCE / _INCH**2, _PRESSURE),
    "J": (1.0, _ENERGY), "kJ": (1e3, _ENERGY), "W": (1.0, _POWER), "kW": (1e3, _POWER), "HRC": (1.0, _HARDNESS),
    "L": (1e-3, (3, 0, 0, 0, 0, 0)),
}  # fmt: skip

_PART = re.compile(r"([./*·]?)([A-Za-zµμ°%]+|1|-)(?:\^?([+-]?\d+(?:\.\d+)?))?")


def _parse(unit: str) -> tuple[float, tuple[float, ...]]:
    """Factor and dimension of e.g. "N.m", "lbf.in/in/R/s", "kg/m^3", "m/s2"."""
    text = unit.replace(" ", "")
    if text in _UNITS:
        number, dimension = _UNITS[text]
        return number, dimension
    if text.lower() in ("degc", "°c", "c", "degf", "°f", "f"):
        raise UnitError(f"{unit}: the zero of this scale is not that of kelvin. Give the value in kelvin (K)")
    number, total, at = 1.0, [0.0] * 6, 0
    while at < len(text):
        part = _PART.match(text, at)
        if part is None or part.group(2) not in _UNITS:
            raise UnitError(f'the unit "{unit}" is unknown; known are {", ".join(u for u in _UNITS if u not in ("", "-", "1"))} '
                            "and products of them such as N.m or kg/m^3")
        power = float(part.group(3) or 1) * (-1.0 if part.group(1) == "/" else 1.0)
        one, dimension = _UNITS[part.group(2)]
        number *= one**power
        total = [a + power * b for a, b in zip(total, dimension)]
        at = part.end()
    return number, tuple(total)


def factor(unit: str, to: str) -> float:
    """Factor from ``unit`` to ``to``.

    >>> adore.units.factor("mm", "m")
    0.001
    """
    a, dimension_a = _parse(unit)
    b, dimension_b = _parse(to)
    if tuple(dimension_a) != tuple(dimension_b):
        raise UnitError(f'"{unit}" and "{to}" are units of different quantities')
    return a / b


def convert(value: float, unit: str, to: str) -> float:
    """A value in another unit.

    >>> adore.units.convert(3000.0, "rpm", "rad/s")
    314.1592653589793
    """
    return value if unit == to else value * factor(unit, to)
