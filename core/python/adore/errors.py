"""Exceptions. Each class has an exit code of the command line.

====  ======================  =======================================================================
code  class                   meaning
====  ======================  =======================================================================
2     :class:`InputError`     the deck, a file or an argument is wrong; ``issues`` has every message 
3     :class:`SolverError`    no solution, or the result cannot be trusted
130   :class:`Interrupted`    Ctrl-C; the files are valid and the run can be continued
1     :class:`InternalError`  a bug in Adore
====  ======================  =======================================================================
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Sequence

if TYPE_CHECKING:
    from ._core import Issue

__all__ = [
    "AdoreError",
    "DeckWarning",
    "InputError",
    "InternalError",
    "Interrupted",
    "PicturesMissingError",
    "ResultsExistError",
    "RunFailed",
    "SolverError",
    "UnitError",
    "UntrustedResult",
]


class AdoreError(Exception):
    """Base class; the text is the message of the command line."""

    #: Exit code of the command line for this kind of error.
    exit_code: int = 1

    def __init__(self, text: str, issues: Sequence[Issue] = ()) -> None:
        super().__init__(text)
        #: Every problem that was found, not only the first.
        self.issues: list[Issue] = list(issues)


class InputError(AdoreError, ValueError):
    """A deck, file or argument is wrong. The message states valid values."""

    exit_code = 2


class ResultsExistError(InputError):
    """The folder contains results of an earlier run, and ``overwrite`` is not set."""


class UnitError(InputError):
    """A unit is unknown, or its dimension differs from that of the variable."""


class PicturesMissingError(InputError):
    """The program that draws the pictures is missing."""


class SolverError(AdoreError, ArithmeticError):
    """No solution was found. The message has diagnosis and remedy."""

    exit_code = 3


class RunFailed(SolverError):
    """A run ended early; its files are valid up to the last stored step."""

    def __init__(self, text: str, run: Any = None) -> None:
        super().__init__(text)
        #: The run up to its last stored step.
        self.run: Any = run


class UntrustedResult(RunFailed):
    """A run is complete, but its results cannot be trusted."""


class InternalError(AdoreError):
    """An internal check failed (this is a bug in Adore)."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C. The files are valid; ``deck.run(..., resume=True)`` continues the run."""

    exit_code: int = 130

    def __init__(self, text: str = "interrupted", run: Any = None) -> None:
        super().__init__(text)
        #: The run up to its last stored step; None without files.
        self.run: Any = run or None


class DeckWarning(UserWarning):
    """A warning about a deck, such as default values that a changed option needs."""
