"""Adore, a rolling-bearing dynamics suite, as a library.

>>> import adore
>>> deck = adore.new("ball")                         # or adore.read("DATA.txt")
>>> deck.rpm2 = 12000
>>> round(deck.statics().summary["largest_contact_load_N"])
397
>>> run = deck.run(until="0.02rev", progress=False)  # Ctrl-C leaves valid files
>>> run["contact.load"].shape[1:]                    # after the step axis: elements, races [N]
(12, 2)

Decks: :func:`new`, :func:`catalogue`, :func:`candidates`, :func:`read`, :class:`Deck`. Runs: :meth:`Deck.run`, :func:`open_run`. Files: :func:`read_table`.
Calculators: :mod:`adore.calc`. Inverse calculations: :func:`find`. Sets of rows: :class:`Assembly`. Errors: :mod:`adore.errors`. A deck or a result file cannot load code.
"""

from __future__ import annotations

import importlib.util
from typing import Dict, Tuple

if importlib.util.find_spec(f"{__name__}._core") is None:
    raise ImportError(
        "the compiled part of the Python module adore is missing; build it: cmake --build build/release --target adore_python"
    )

from . import _core, calc, errors, pictures, routines, schema, units
from ._core import Issue, Progress
from .assembly import Assembly, AssemblyStatics, new_assembly
from .deck import Candidates, Deck, Record, candidates, catalogue, check, examples, new, read
from .errors import (
    AdoreError,
    DeckWarning,
    InputError,
    InternalError,
    Interrupted,
    PicturesMissingError,
    ResultsExistError,
    RunFailed,
    SolverError,
    UnitError,
    UntrustedResult,
)
from .inverse import Found, find, find_questions, find_targets
from .pictures import Picture, Pictures
from .results import Channels, describe, read_table
from .routines import Routines
from .run import Plan, Run, Statics, open_run

__version__: str = _core.__version__

__all__ = [
    "AdoreError",
    "Assembly",
    "AssemblyStatics",
    "Candidates",
    "Channels",
    "Deck",
    "DeckWarning",
    "Found",
    "InputError",
    "InternalError",
    "Interrupted",
    "Issue",
    "Picture",
    "Pictures",
    "PicturesMissingError",
    "Plan",
    "Progress",
    "Record",
    "ResultsExistError",
    "Routines",
    "Run",
    "RunFailed",
    "SolverError",
    "Statics",
    "UnitError",
    "UntrustedResult",
    "calc",
    "candidates",
    "catalogue",
    "check",
    "describe",
    "errors",
    "examples",
    "find",
    "find_questions",
    "find_targets",
    "new",
    "new_assembly",
    "open_run",
    "pictures",
    "read",
    "read_table",
    "require_reproducible",
    "routines",
    "run_options",
    "schema",
    "units",
]


def run_options() -> Dict[str, Tuple[str, str]]:
    """Default and meaning of each run option by name."""
    return {name: (default, meaning) for name, default, meaning in _core.run_options()}


def require_reproducible() -> None:
    """All later runs of this process give bit-identical results on all x86-64 processors. Call this before the first run."""
    _core.require_reproducible()
