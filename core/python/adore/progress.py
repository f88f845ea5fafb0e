"""What a run reports while it is under way."""

from __future__ import annotations

import sys
from typing import Callable, Optional, Union

from . import _core

__all__ = ["ProgressCallback", "show_progress"]

ProgressCallback = Callable[[_core.Progress], Optional[bool]]


def show_progress(progress: Union[bool, None, ProgressCallback]) -> Optional[ProgressCallback]:
    """The callback for ``progress``: a line on a terminal, none, or the given callable."""
    if callable(progress):
        return progress
    if progress is False or (progress is None and not sys.stderr.isatty()):
        return None

    def line(at: _core.Progress) -> None:
        what = f"{at.step} of {at.runs}" if at.runs else f"{at.revolutions:.3f} rev"
        end = "\n" if at.fraction >= 1.0 else ""
        sys.stderr.write(f"\r{100.0 * at.fraction:5.1f} %  {what}, {at.remaining:.0f} s left   {end}")
        sys.stderr.flush()

    return line
