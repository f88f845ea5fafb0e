"""The component calculators of ``adore calc``: Hertz contacts, films, traction, life, fits ...

>>> ball = {"Rx": 0.01, "Ry": 0.01, "E": 2.06e11, "nu": 0.3}
>>> plane = {"Rx": "inf", "Ry": "inf", "E": 2.06e11, "nu": 0.3}
>>> result = adore.calc.hertz(body1=ball, body2=plane, load=100, stress_poisson=0.3)
>>> f"{result.a:.4g} {result.units['a']}"
'0.0001878 m'
"""

from __future__ import annotations

import functools
import json
from typing import Any, Dict, List, Mapping, Optional

from . import _core
from .errors import InputError

__all__ = ["Calculator", "Result", "calculate", "calculators"]


class Result(Dict[str, Any]):
    """The results of a calculator by name. ``units`` contains the unit of each result that has one."""

    def __init__(self, values: Mapping[str, Any]) -> None:
        super().__init__({k: v for k, v in values.items() if k != "units"})
        #: Unit of each result, e.g. {"a": "m", "table[].Q": "N"}.
        self.units: Dict[str, str] = dict(values.get("units", {}))

    def __getattr__(self, name: str) -> Any:
        if name in self:
            return self[name]
        raise AttributeError(f"there is no result {name}; the results are {', '.join(self)}")

    def __dir__(self) -> List[str]:
        return [*super().__dir__(), *(k for k in self if k.isidentifier())]


def _plain(value: Any) -> Any:
    """Converts NumPy numbers and arrays to types that JSON can store."""
    return value.tolist() if hasattr(value, "tolist") else str(value)


class Calculator:
    """One calculator. Call it with the inputs as keyword arguments, or with a dictionary."""

    def __init__(self, name: str, purpose: str) -> None:
        self.name = name
        self.purpose = purpose

    @property
    def __doc__(self) -> str:  # type: ignore[override]
        return _core.describe_calculator(self.name)

    def describe(self) -> str:
        """Inputs and results with units, and an example, as text."""
        return _core.describe_calculator(self.name)

    def calculations(self) -> List[Dict[str, Any]]:
        """The description as data: inputs, results and an example for each kind of calculation."""
        return list(json.loads(_core.describe_calculator_json(self.name))["calculations"])

    def example(self, kind: Optional[str] = None) -> Dict[str, Any]:
        """Example inputs of a kind of calculation (default: the first kind)."""
        for calculation in self.calculations():
            if kind is None or calculation.get("kind") == kind:
                return dict(calculation["example"])
        kinds = ", ".join(str(c.get("kind")) for c in self.calculations())
        raise InputError(f"{self.name} has no calculation of kind {kind}; its kinds are {kinds}")

    def __call__(self, inputs: Optional[Mapping[str, Any]] = None, **more: Any) -> Result:
        text = json.dumps({**(inputs or {}), **more}, default=_plain)
        return Result(json.loads(_core.calculate(self.name, text)))

    def __repr__(self) -> str:
        return f"<adore.calc.{self.name}: {self.purpose}>"


@functools.lru_cache(maxsize=None)
def calculators() -> Dict[str, Calculator]:
    """All calculators by name."""
    return {name: Calculator(name, purpose) for name, purpose in _core.calculator_list()}


def calculate(name: str, inputs: Optional[Mapping[str, Any]] = None, **more: Any) -> Result:
    """Runs a calculator by its name, written as in ``adore calc --list`` (with dashes)."""
    found = calculators().get(name)
    if found is None:
        raise InputError(f'there is no calculator named "{name}"; adore.calc.calculators() lists all calculators')
    return found(inputs, **more)


def __getattr__(name: str) -> Calculator:
    found = calculators().get(name) or calculators().get(name.replace("_", "-"))
    if found is None:
        raise AttributeError(f"there is no calculator named {name}; dir(adore.calc) lists all calculators")
    return found


def __dir__() -> List[str]:
    return [*__all__, *(name.replace("-", "_") for name in calculators())]
