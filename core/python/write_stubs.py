"""Writes adore/variables.pyi from the record schema and adore/calc.pyi from the schema of the calculators:
python3 write_stubs.py [FOLDER]. A test compares."""

import sys
import textwrap
from pathlib import Path

HEAD = '''"""Written by write_stubs.py from the record schema; do not edit."""

import numpy as np

class DeckVariables:
    """Every variable of all records; a deck has those of its records."""
'''


def kind(record, spec):
    plain = {"int": "int", "real": "float", "string": "str"}[spec.type]
    return plain if spec.length == "1" and not record.repeat else "np.ndarray"


def text():
    import adore

    lines, seen = [HEAD], set()
    for record in adore.schema.records().values():
        for spec in record.variables[1:]:
            if spec.name in seen:
                continue
            seen.add(spec.name)
            unit = f" [{spec.unit}]" if spec.unit not in ("", "-") else ""
            note = textwrap.wrap(f"Record {record.id}{unit}. {spec.help}".replace("\\", "\\\\").replace('"""', "'''"), 110)
            lines.append(f"    {spec.name}: {kind(record, spec)}")
            lines.append('    """' + "\n    ".join(note) + '"""')
    return "\n".join(lines) + "\n"


CALC_HEAD = '''"""Written by write_stubs.py from the schema of the calculators; do not edit."""

from typing import Any, Dict, List, Literal, Mapping, Optional, Sequence, Union

class Result(Dict[str, Any]):
    units: Dict[str, str]
    def __getattr__(self, name: str) -> Any: ...

class Calculator:
    name: str
    purpose: str
    def describe(self) -> str: ...
    def calculations(self) -> List[Dict[str, Any]]: ...
    def example(self, kind: Optional[str] = ...) -> Dict[str, Any]: ...
    def __call__(self, inputs: Optional[Mapping[str, Any]] = ..., **more: Any) -> Result: ...

def calculators() -> Dict[str, Calculator]: ...
def calculate(name: str, inputs: Optional[Mapping[str, Any]] = ..., **more: Any) -> Result: ...
'''


def value_type(rows):
    """Type of one top-level input; rows: its descriptions in all kinds."""
    found = set()
    for row in rows:
        name, codes = row["name"], row.get("codes", [])
        if "." in name.split("[")[0]:
            found.add("Mapping[str, Any]")
        elif "[" in name:
            found.add("Sequence[Any]" if "[]." in name or codes or name.endswith("[][]") else "Sequence[float]")
        elif row["type"] in ("label", "name"):
            found.add("Any")
        else:
            plain = {"number": "float", "whole number": "int", "true or false": "bool"}.get(row["type"])
            found |= {plain} if plain else set()
            if codes:
                found.add("Literal[" + ", ".join(repr(c) for c in codes) + "]")
        if "null" in row and "." not in name:
            found.add("None")
    if "Any" in found:
        return "Any"
    return found.pop() if len(found) == 1 else "Union[" + ", ".join(sorted(found)) + "]"


def calc_text(described):
    """described: {name: what `adore calc NAME --describe --json` prints for it}"""
    lines, instances = [CALC_HEAD], []
    for name, one in sorted(described.items()):
        rows = {}
        for calculation in one["calculations"]:
            for row in calculation["inputs"]:
                rows.setdefault(row["name"].split(".")[0].split("[")[0], []).append(row)
        rows.pop("kind", None) if len(one["calculations"]) > 1 else None
        kinds = [c["kind"] for c in one["calculations"]]
        title = "".join(part.capitalize() for part in name.split("-"))
        lines.append(f"class _{title}(Calculator):")
        lines.append("    def __call__(  # type: ignore[override]")
        lines.append("        self, inputs: Optional[Mapping[str, Any]] = ..., *,")
        if len(kinds) > 1:
            lines.append(f"        kind: str = ...,  # {', '.join(kinds)}"[:400])
        lines += [f"        {key}: {value_type(of)} = ..." + "," for key, of in rows.items()]
        lines.append("    ) -> Result:")
        lines.append(f'        """{one["help"]}"""')
        lines.append("")
        instances.append(f"{name.replace('-', '_')}: _{title}")
    return "\n".join(lines) + "\n" + "\n".join(instances) + "\n"


def described_calculators():
    import json

    from adore import _core, calc

    return {name: json.loads(_core.describe_calculator_json(name)) for name in calc.calculators()}


if __name__ == "__main__":
    sys.path.pop(0)  # the folder of the sources has no compiled module
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent / "adore"
    (folder / "variables.pyi").write_text(text(), encoding="utf-8")
    (folder / "calc.pyi").write_text(calc_text(described_calculators()), encoding="utf-8")
