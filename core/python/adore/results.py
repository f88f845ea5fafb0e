"""Results as NumPy arrays and pandas data frames."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any, Dict, Iterator, List, Mapping, Optional, Tuple, Union

import numpy as np

from . import _core
from .errors import InputError

if TYPE_CHECKING:
    import pandas as pd

__all__ = ["Channels", "describe", "read_table"]

PathLike = Union[str, "os.PathLike[str]"]
_SERIES = ("time", "step_size", "shaft_rotation")
#: Names of the last places of an array: races, vectors, quaternions.
_RACES = ("outer", "inner")


def _pandas() -> Any:
    try:
        import pandas
    except ImportError:
        raise ImportError("data frames need pandas (Debian: python3-pandas); arrays are available without pandas") from None
    return pandas


class Channels(Mapping[str, np.ndarray]):
    """The channels of a RESULTS.h5 by name (SI units and radians). Each array has one row for each stored step.

    >>> run = adore.new("ball").run(until="0.02rev", progress=False)
    >>> run.channels["contact.load"].shape[1:]      # after the step axis: elements, races
    (12, 2)
    >>> run.channels.info("contact.load").unit
    'N'

    The file can be read while the run is in progress; :meth:`reload` reads the new steps."""

    def __init__(self, path: PathLike) -> None:
        self._path = os.fspath(path)
        self._reader = _core.H5Reader(self._path)
        self._info: Dict[str, _core.ChannelInfo] = {c.id: c for c in self._reader.channels}

    def reload(self) -> None:
        """Reads the file again."""
        self.__init__(self._path)  # type: ignore[misc]

    @property
    def steps(self) -> np.ndarray:
        """Numbers of the stored steps."""
        return np.array(self._reader.step_numbers())

    @property
    def time(self) -> np.ndarray:
        """Time of every stored step [s]."""
        return self.read("time")

    @property
    def revolutions(self) -> np.ndarray:
        """Shaft revolutions at every stored step."""
        return self.read("shaft_rotation") / (2.0 * np.pi)

    @property
    def geometry(self) -> Dict[str, float]:
        """Dimensions of the bearing [m]."""
        return self._reader.geometry

    def info(self, id: str) -> _core.ChannelInfo:
        """Label, unit, frame and meaning of a channel."""
        if id not in self._info:
            raise InputError(f"{self._path} has no channel {id}; its channels are {', '.join(self)}")
        return self._info[id]

    def read(self, id: str, first: int = 0, count: Optional[int] = None, every: int = 1) -> np.ndarray:
        """Values of the stored steps ``first``, ``first + every``, ... (counted from 0; default of ``count``: all)."""
        if id not in _SERIES:
            self.info(id)
        return self._reader.read(id, first, count, every)

    def frame(self, *ids: str, index: str = "time") -> pd.DataFrame:
        """Channels as a data frame with one column for each value, e.g. "contact.load[3].inner"; elements are counted from 1.

        The index is "time" [s], "revolutions" or "steps"."""
        pandas = _pandas()
        if index not in ("time", "revolutions", "steps"):
            raise InputError(f'index "{index}": give "time", "revolutions" or "steps"')
        columns: Dict[str, np.ndarray] = {}
        for id in ids or tuple(self):
            values = self[id]
            names = _names(id, values.shape[1:])
            for name, column in zip(names, values.reshape(len(values), -1).T):
                columns[name] = column
        return pandas.DataFrame(columns, index=pandas.Index(getattr(self, index), name=index))

    def __getitem__(self, id: str) -> np.ndarray:
        return self.read(id)

    def __iter__(self) -> Iterator[str]:
        return iter(self._info)

    def __len__(self) -> int:
        return len(self._info)

    def __contains__(self, id: object) -> bool:
        return id in self._info

    def _ipython_key_completions_(self) -> List[str]:
        return list(self)

    def __repr__(self) -> str:
        lines = [f"{self._path}: {self._reader.steps} stored steps, {len(self)} channels"]
        lines += [f"  {c.id:<28} {c.unit:<8} {list(c.dimensions)!s:<12} {c.label}" for c in self._info.values()]
        return "\n".join(lines)


def _names(id: str, shape: Tuple[int, ...]) -> List[str]:
    names = [id]
    for level, size in enumerate(shape):
        last = level == len(shape) - 1
        if last and level > 0 and size == 2:
            parts = [f".{race}" for race in _RACES]
        elif last and size == 3:
            parts = [".x", ".y", ".z"]
        elif last and size == 4 and level > 0:
            parts = [".w", ".x", ".y", ".z"]
        else:
            parts = [f"[{k}]" for k in range(1, size + 1)]
        names = [n + p for n in names for p in parts]
    return names


def read_table(path: PathLike) -> pd.DataFrame:
    """A SOL1-SOL8 or RESULTS.h5 as a data frame with one row for each stored step.

    The columns have the names of ``adore convert``, e.g. "contact.load.outer". ``frame.attrs`` contains the header of the
    file, and "units" and "labels" of the columns. If a file is damaged or incomplete, the frame contains
    the readable rows, and ``frame.attrs["note"]`` states the damage."""
    header, columns, values, note = _core.read_table(os.fspath(path))
    frame = _pandas().DataFrame(values, columns=[c[0] for c in columns])
    frame.attrs.update(
        header=dict(header),
        units={c[0]: c[2] for c in columns},
        labels={c[0]: c[1] for c in columns},
        note=note,
        path=str(Path(path)),
    )
    return frame


def describe(path: PathLike) -> str:
    """Type of a result file, its header and the range of each channel."""
    return _core.describe_file(os.fspath(path))
