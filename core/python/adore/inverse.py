"""Inverse calculations: the value of an input at which a result meets a target."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Optional, Tuple, Union

import numpy as np

from . import _core
from .calc import _plain
from .errors import InputError
from .routines import routines_of

if TYPE_CHECKING:
    from .deck import Deck, User

__all__ = ["Found", "find", "find_questions", "find_targets"]


class Found:
    """Answer of :func:`adore.find`."""

    def __init__(self, data: Dict[str, Any], lines: List[str]) -> None:
        #: The same as ``adore find --json``.
        self.data = data
        #: The answer in sentences.
        self.lines = lines

    @property
    def answer(self) -> str:
        """"one", "not_monotonic" (one, but the result turns), "many", "everywhere", "none" or "not_computed"."""
        return str(self.data["answer"])

    @property
    def solutions(self) -> List[float]:
        """All values of the unknown at which the target is met."""
        one = [self.data["solution"]] if "solution" in self.data else []
        return [float(s["value"]) for s in one + self.data.get("solutions", [])]

    @property
    def value(self) -> float:
        """The one solution. Any other answer raises :class:`adore.InputError`: choose one of :attr:`solutions`."""
        if len(self.solutions) != 1 or self.answer == "everywhere":
            raise InputError("there is not exactly one solution. " + " ".join(self.lines))
        return self.solutions[0]

    @property
    def best(self) -> Optional[Tuple[float, float]]:
        """Without a solution: the unknown and the result nearest to the target; else None."""
        best = self.data.get("best")
        return None if best is None else (float(best["value"]), float(best["target"]))

    @property
    def curve(self) -> Tuple[np.ndarray, np.ndarray]:
        """All computed points: the unknown and the result (NaN: not computed)."""
        scan = self.data["scan"]
        return (np.array([p["value"] for p in scan], dtype=float),
                np.array([float("nan") if p["target"] is None else float(p["target"]) for p in scan]))  # fmt: skip

    def __repr__(self) -> str:
        return "\n".join(self.lines)


def find(
    source: Union[Deck, str],
    unknown: Optional[str] = None,
    between: Tuple[float, float] = (0.0, 0.0),
    target: Optional[str] = None,
    *,
    question: Optional[str] = None,
    inputs: Optional[Mapping[str, Any]] = None,
    options: Optional[Mapping[str, Any]] = None,
    user: User = None,
    points: int = 41,
) -> Found:
    """The values of an input between two bounds at which a result meets a target.

    >>> deck = adore.new("ball")
    >>> found = adore.find(deck, "appLoadX", (1000, 5000), "largest_contact_load_N=500")
    >>> found.answer
    'one'

    ``source``: a deck, or the name of a calculator with its ``inputs``. ``unknown``: a deck variable in the deck's units, a run option,
    or the path of an input of the calculator. ``target``: "NAME=5", "NAME>=5", "NAME<=5", "NAME=least" or "NAME=largest"; the names are in
    :func:`find_targets`. ``question``: instead of unknown and target, one of :func:`find_questions`, with its value if it needs one."""
    if question is not None and target is not None:
        raise InputError("question sets the target; give only one of the two")
    if question is None and (unknown is None or target is None):
        raise InputError("give unknown and target, or question")
    first, last = (float(b) for b in between)
    if isinstance(source, str):
        text = json.dumps(dict(inputs or {}), default=_plain)
        out = _core.find_in_calculator(source, text, unknown or "", first, last, target or "", question or "", points)
    else:
        out = _core.find(*source._request(options), routines_of(user), unknown or "", first, last, target or "", question or "", points)
    return Found(json.loads(out[0]), out[1])


def find_questions() -> Dict[str, str]:
    """Common questions by name, and what each finds."""
    return {name: meaning for name, meaning in _core.find_questions()}


def find_targets() -> Dict[str, Tuple[str, str]]:
    """Results of an equilibrium that can be a target: name, and unit and meaning."""
    return {name: (unit, meaning) for name, unit, meaning in _core.find_results()}
