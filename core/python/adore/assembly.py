"""Sets of bearing rows on one shaft: folders with ASSEMBLY.json."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Optional, Sequence, Union

from . import _core
from .errors import InputError
from .run import Run, Statics

if TYPE_CHECKING:
    from .deck import Deck

__all__ = ["Assembly", "AssemblyStatics", "new_assembly"]

PathLike = Union[str, "os.PathLike[str]"]


def _texts(values: Optional[Mapping[str, Any]]) -> Dict[str, str]:
    return {name: str(value) for name, value in (values or {}).items()}


class AssemblyStatics(Statics):
    """The quasi-static solution of a set. Displacement, load and stiffness refer to the point x = 0 of the shaft."""

    def __init__(self, solution: Mapping[str, Any]) -> None:
        super().__init__({**solution, "bearing": "assembly"})
        #: Key results of each row by name, in the frame of its deck (SI units, lives in hours).
        self.rows: List[Dict[str, float]] = [{id: value for id, _, _, value in row} for row in solution["rows"]]
        #: Rows, preload and unloading forces, as in RUN.json.
        self.report: Dict[str, Any] = json.loads(solution["report"])


class Assembly:
    """Up to four bearing rows on one shaft, from a folder with ASSEMBLY.json."""

    def __init__(self, folder: PathLike) -> None:
        #: The folder.
        self.folder = Path(folder)
        if not (self.folder / "ASSEMBLY.json").exists():
            raise InputError(f"there is no ASSEMBLY.json in {self.folder}; adore.new_assembly() writes one")
        #: The content of ASSEMBLY.json; quantities are texts with units.
        self.data: Dict[str, Any] = json.loads(_core.read_assembly(str(self.folder)))

    @property
    def arrangement(self) -> str:
        """"DB", "DF", "DT", ... or "custom"."""
        return str(self.data["arrangement"])

    def check(self, sets: Optional[Mapping[str, Any]] = None, **options: Any) -> List[_core.Finding]:
        """All errors and findings; ``sets``: deck variables of all rows."""
        return _core.check_assembly(str(self.folder), _texts(sets), _texts(options))

    def statics(self, sets: Optional[Mapping[str, Any]] = None, **options: Any) -> AssemblyStatics:
        """Load sharing, stiffness, preload, unloading, lives. No file is written. ``sets``: deck variables of all rows."""
        return AssemblyStatics(_core.solve_assembly(str(self.folder), _texts(sets), _texts(options)))

    def run(
        self,
        out: Optional[PathLike] = None,
        *,
        sets: Optional[Mapping[str, Any]] = None,
        options: Optional[Mapping[str, Any]] = None,
        overwrite: bool = False,
    ) -> Run:
        """Solves the set and writes PRINT.txt and RUN.json of the set and of each row (in row-1, row-2, ...).

        out: output folder (default: the folder of the assembly). sets: deck variables of all rows."""
        folder = _core.run_assembly(
            str(self.folder), _texts(sets), _texts(options), str(out) if out is not None else "", overwrite
        )
        return Run(folder)

    def __repr__(self) -> str:
        return f"<Assembly {self.data['name']}: {self.arrangement}, {len(self.data['rows'])} rows, {self.folder}>"


def new_assembly(
    folder: PathLike,
    arrangement: str,
    decks: Union["Deck", Sequence["Deck"]],
    *,
    preload: Optional[Mapping[str, Any]] = None,
    load: Optional[Mapping[str, Any]] = None,
    **members: Any,
) -> Assembly:
    """Writes a new assembly: ``new_assembly("set", "DB", deck, preload={"force": "211 N"}, load={"x": "500 N"})``.

    decks: one deck for all rows, or one for each. preload, load and further members: as in ASSEMBLY.json."""
    given = list(decks) if isinstance(decks, (list, tuple)) else [decks]
    if preload is not None:
        members["preload"] = dict(preload)
    if load is not None:
        members["load"] = dict(load)
    _core.new_assembly(str(folder), arrangement, [deck.source() for deck in given], json.dumps(members))
    return Assembly(folder)
