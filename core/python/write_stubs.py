"""Writes adore/variables.pyi from the record schema: python3 write_stubs.py [FILE]. A test compares."""

import sys
import textwrap
from pathlib import Path

HEAD = '''"""Written by write_stubs.py from the record schema; do not edit."""

import numpy as np

class DeckVariables:
    """Every variable that a deck may have; a deck has those of its own records."""
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


if __name__ == "__main__":
    sys.path.pop(0)  # the folder of the sources has no compiled module
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent / "adore" / "variables.pyi"
    target.write_text(text(), encoding="utf-8")
