"""How things go wrong, and who can mend them: the classes stand for the exit codes of the command line.

====  ======================  =======================================================================
code  class                   meaning
====  ======================  =======================================================================
2     :class:`InputError`     the deck, a file or an argument is wrong; ``issues`` holds every sentence
3     :class:`SolverError`    the numerics gave up, or the result cannot be trusted
130   :class:`Interrupted`    Ctrl-C; the files are valid and the run can be continued
1     :class:`InternalError`  a bug of Adore
====  ======================  =======================================================================
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Sequence

if TYPE_CHECKING:
    from ._core import Issue
    from .run import Run

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
    """Base of what Adore raises; the text is the sentence that the command line prints."""

    #: Exit code of the command line for this kind of error.
    exit_code: int = 1

    def __init__(self, text: str, issues: Sequence[Issue] = ()) -> None:
        super().__init__(text)
        #: Every problem that was found, not only the first.
        self.issues: list[Issue] = list(issues)


class InputError(AdoreError, ValueError):
    """The user's deck, file or argument is wrong; the sentence says what would be valid."""

    exit_code = 2


class ResultsExistError(InputError):
    """The folder holds results of an earlier run, and nobody allowed to replace them."""


class UnitError(InputError):
    """A unit is unknown, or measures something else than the variable."""


class PicturesMissingError(InputError):
    """The program that draws is not there."""


class SolverError(AdoreError, ArithmeticError):
    """The numerics gave up: diagnosis and remedy."""

    exit_code = 3


class RunFailed(SolverError):
    """A run ended early; its files are valid up to the last stored step."""

    def __init__(self, text: str, run: Optional[Run] = None) -> None:
        super().__init__(text)
        #: What there is of the run.
        self.run: Any = run


class UntrustedResult(RunFailed):
    """A run came to its end, and its results cannot be trusted."""


class InternalError(AdoreError):
    """A broken invariant: a bug of Adore."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C; what was written is valid, and ``deck.run(..., resume=True)`` goes on with it."""

    exit_code: int = 130

    def __init__(self, text: str = "interrupted", run: Any = None) -> None:
        super().__init__(text)
        #: What there is of the run; None when nothing was written.
        self.run: Optional[Run] = run or None


class DeckWarning(UserWarning):
    """Something that is to be said of a deck, e.g. default values that a changed option brought in."""
