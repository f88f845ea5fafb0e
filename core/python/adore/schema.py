"""The deck format: all records and variables with units, options and help."""

from __future__ import annotations

import functools
import json
import math
from dataclasses import dataclass
from typing import Any, Mapping, Optional, Tuple

from . import _core
from .errors import InputError

__all__ = ["RecordSpec", "VariableSpec", "known", "records", "variable", "variable_names"]


@dataclass(frozen=True)
class VariableSpec:
    """A variable of a record."""

    name: str
    type: str  #: "int", "real" or "string"
    length: str  #: "1", a number, or the integer variable that says how long the array is
    unit: str  #: in an SI deck; empty for codes and texts
    unit_english: str  #: in an English deck
    options: Mapping[str, str]  #: code and meaning; empty when any number is valid
    default: Optional[str]
    minimum: float  #: in the SI deck's unit
    maximum: float
    help: str

    def text(self) -> str:
        """Description of the variable in a few lines."""
        unit = f" [{self.unit}]" if self.unit not in ("", "-") else ""
        length = "" if self.length == "1" else f", array of {self.length}"
        lines = [f"{self.name}{unit} ({self.type}{length}): {self.help}"]
        lines += [f"  {code}: {meaning}" for code, meaning in self.options.items()]
        if math.isfinite(self.minimum) or math.isfinite(self.maximum):
            lines.append(f"  valid from {self.minimum:g} to {self.maximum:g}")
        if self.default is not None:
            lines.append(f"  default {self.default}")
        return "\n".join(lines)


@dataclass(frozen=True)
class RecordSpec:
    """A record of the deck; ``condition`` states which decks have it."""

    id: str
    title: str
    condition: str
    repeat: str  #: empty, or the integer variable that says how often it occurs
    variables: Tuple[VariableSpec, ...]  #: the label recID first


def _bound(value: Any, otherwise: float) -> float:
    """Limits of ranges; None if there is no limit, or only that of the number type."""
    return otherwise if value is None or abs(value) >= 2**31 - 1 else float(value)


@functools.lru_cache(maxsize=None)
def records() -> Mapping[str, RecordSpec]:
    """Every record by its id, in deck order."""
    out: dict[str, RecordSpec] = {}
    whole = json.loads(_core.schema_json())
    for r in whole["records"]:
        variables = tuple(
            VariableSpec(
                name=v["name"],
                type=v["type"],
                length=v["length"],
                unit=v["unit_si"],
                unit_english=v["unit_en"],
                options={o["code"]: o["meaning"] for o in v["options"] or whole["option_tables"].get(v["option_table"], [])},
                default=v["default"],
                minimum=_bound(v["min"], -math.inf),
                maximum=_bound(v["max"], math.inf),
                help=v["help"],
            )
            for v in r["variables"]
        )
        out[r["id"]] = RecordSpec(r["id"], r["title"], r["required_when"], r["repeat"], variables)
    return out


@functools.lru_cache(maxsize=None)
def _by_name() -> Mapping[str, Tuple[VariableSpec, RecordSpec]]:
    out: dict[str, Tuple[VariableSpec, RecordSpec]] = {}
    for record in records().values():
        for spec in record.variables[1:]:
            out.setdefault(spec.name, (spec, record))
    return out


def variable_names() -> Tuple[str, ...]:
    """Every variable, in deck order, without labels of records."""
    return tuple(_by_name())


def known(name: str) -> Optional[VariableSpec]:
    """A variable by its name; None if the name is unknown."""
    found = _by_name().get(name)
    return None if found is None else found[0]


def variable(name: str) -> VariableSpec:
    """A variable by its name.

    >>> adore.schema.variable("pitchDia").unit
    'm'
    """
    found = known(name)
    if found is None:
        near = ", ".join(_core.similar_variables(name))
        raise InputError(f"{name}: there is no variable with this name" + (f"; did you mean {near}?" if near else ""))
    return found
