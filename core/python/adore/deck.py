"""Decks as objects: the deck variables are attributes, with units, help and completion."""

from __future__ import annotations

import html
import json
import os
import re
import tempfile
import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Any, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core, schema, units
from .errors import DeckWarning, InputError, UnitError
from .progress import ProgressCallback
from .routines import Routines, routines_of
from .run import Plan, Run, Statics, start_run, start_sweep
from .variables import DeckVariables

if TYPE_CHECKING:
    import pandas as pd

__all__ = ["Candidates", "Deck", "Record", "candidates", "catalogue", "check", "examples", "new", "read"]

PathLike = Union[str, "os.PathLike[str]"]
#: A number, a text, or an array of them.
Value = Any
User = Union[Routines, PathLike, None]

_TARGET = re.compile(r"^\s*(\w+)\s*((?:\[\s*\d+\s*\]\s*)*)$")


def _split(name: str) -> Tuple[str, List[int]]:
    """"cageGcPos[2][3]" -> ("cageGcPos", [2, 3]); counted from 1 as the manual does."""
    match = _TARGET.match(name)
    if match is None:
        raise InputError(f"{name}: the index is not valid; write name[1] or name[instance][element], counting from 1")
    return match.group(1), [int(n) for n in re.findall(r"\d+", match.group(2))]


def _text(value: Any, whole: bool) -> str:
    """A value in the syntax of a deck; None as the word, which the reader rejects. whole: integer variable"""
    if isinstance(value, str):
        return "'" + value.replace("'", "''") + "'"
    if isinstance(value, (bool, np.bool_)):
        return str(int(value))
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    try:
        number = float(None if isinstance(value, (bytes, bytearray)) else value)
    except (TypeError, ValueError):
        return str(value)  # the deck refuses it, naming the variable
    return str(int(number)) if whole and number.is_integer() else repr(number)


def _flat(value: Any) -> List[Any]:
    if isinstance(value, str) or np.ndim(value) == 0:
        return [value]
    return list(value)


class Findings(List[_core.Finding]):
    """Errors, warnings and notes of a check, with code, value and limit."""

    @property
    def findings(self) -> List[_core.Finding]:
        """This list, under the same name as in runs and plans."""
        return self


class Record:
    """A record of one deck: its variables as attributes, in the deck's units.

    >>> deck = adore.new("ball")
    >>> deck.record("5A").title
    'Ball bearing geometry'
    """

    __slots__ = ("_deck", "id", "instance", "_spec")

    def __init__(self, deck: Deck, id: str, instance: int) -> None:
        object.__setattr__(self, "_deck", deck)
        object.__setattr__(self, "id", id)
        object.__setattr__(self, "instance", instance)
        object.__setattr__(self, "_spec", schema.records()[id])

    @property
    def title(self) -> str:
        """Title of the record."""
        return str(self._spec.title)

    @property
    def names(self) -> Tuple[str, ...]:
        """Names of the variables, without the label."""
        return tuple(v.name for v in self._spec.variables[1:])

    def _values(self) -> List[List[Any]]:
        values = self._deck._core.values(self.id, self.instance)
        if values is None:
            raise InputError(f"this deck no longer has instance {self.instance} of record {self.id}")
        return list(values)

    def __getattr__(self, name: str) -> Value:
        for spec, values in zip(self._spec.variables, self._values()):
            if spec.name == name and name != "recID":
                return _array(values) if spec.length != "1" else values[0]
        raise AttributeError(f"record {self.id} has no variable {name}; its variables are {', '.join(self.names)}")

    def __setattr__(self, name: str, value: Value) -> None:
        if name not in self.names:
            raise AttributeError(f"record {self.id} has no variable {name}; its variables are {', '.join(self.names)}")
        self._deck[f"{name}[{self.instance}]" if self._spec.repeat else name] = value

    def __dir__(self) -> List[str]:
        return [*self.names, "id", "instance", "names", "title"]

    def _ipython_key_completions_(self) -> List[str]:
        return list(self.names)

    __getitem__ = __getattr__
    __setitem__ = __setattr__

    def __iter__(self) -> Iterator[Tuple[str, Value]]:
        return ((name, getattr(self, name)) for name in self.names)

    def _heading(self) -> str:
        number = f" ({self.instance})" if self._spec.repeat else ""
        return f"record {self.id}{number}: {self.title}"

    def __repr__(self) -> str:
        lines = [self._heading()]
        for name, value in self:
            unit = self._deck._core.unit(name)
            lines.append(f"  {name} = {value!r}{' ' + unit if unit else ''}")
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><th style='text-align:left'>{html.escape(name)}</th><td>{html.escape(str(value))}</td>"
            f"<td>{html.escape(self._deck._core.unit(name))}</td>"
            f"<td style='text-align:left'>{html.escape(schema.variable(name).help)}</td></tr>"
            for name, value in self
        )
        return f"<details><summary>{html.escape(self._heading())}</summary><table>{rows}</table></details>"


def _array(values: Sequence[Any]) -> Any:
    """Numbers as a read-only array, because a changed element would not change the deck."""
    if any(v is None or isinstance(v, str) for v in values):
        return tuple(values)
    out = np.array(values)
    out.setflags(write=False)
    return out


class Deck(DeckVariables):
    """A deck. Its variables are attributes with their names and units in the deck.

    >>> deck = adore.new("ball")
    >>> deck.nRe
    12
    >>> deck["pitchDia"] = 60.5, "mm"
    >>> deck.get("pitchDia", "in")
    2.3818897637795278

    ``dir(deck)`` (and completion with the Tab key) lists the variables of this deck. Arrays are returned as read-only
    arrays. To set one element, use its name and an index counted from 1: ``deck["iCageGuide[2]"] = 1``. If a record
    occurs several times, the first index is the instance of the record.
    """

    __slots__ = ("_core", "_options", "_path", "__weakref__")

    def __init__(self, core: _core.Deck, path: Optional[Path] = None, options: Optional[Mapping[str, str]] = None) -> None:
        object.__setattr__(self, "_core", core)
        object.__setattr__(self, "_path", path)
        object.__setattr__(self, "_options", dict(options or {}))

    # Reading and writing.

    @classmethod
    def from_text(cls, text: str, name: str = "deck") -> Deck:
        """A deck from its text; ``name`` is the name of the deck in messages."""
        return cls(_core.Deck.from_text(text, name))

    @property
    def path(self) -> Optional[Path]:
        """The file from which the deck was read or to which it was saved; None if there is no file."""
        return self._path

    def source(self) -> str:
        """The text of the deck. If only values have changed, the comments, blanks and number formats of the original
        are kept. If records were added or removed, the text contains all values without comments."""
        return self._core.text()

    def save(self, path: Optional[PathLike] = None, *, overwrite: bool = False) -> Path:
        """Writes the deck to a file (default: the file from which the deck was read). Variables of records X go into the
        ADORE.json next to it; its run options stay.

        Another existing file is only replaced if ``overwrite=True``."""
        target = Path(path) if path is not None else self._path
        if target is None:
            raise InputError("this deck was not read from a file; give a file name: deck.save('DATA.txt')")
        if target.is_dir():
            target = target / "DATA.txt"
        same = self._path is not None and target.exists() and target.samefile(self._path)
        if target.exists() and not same and not overwrite:
            raise InputError(f"{target} exists already; give another file, or set overwrite=True")
        extension = self._core.extension_text(str(target))
        _replace(target, self._core.saved_text())
        if extension is not None:
            _replace(target.with_name("ADORE.json"), extension)
        object.__setattr__(self, "_path", target)
        self._core.name = str(target)
        return target

    def copy(self, **changes: Value) -> Deck:
        """A copy, optionally with changed values: ``deck.copy(rpm2=12000)``."""
        out = Deck(self._core.copy(), self._path, self._options)
        if changes:
            out.update(**changes)
        return out

    def in_units(self, system: str) -> Deck:
        """The same bearing in "SI" or "English" units."""
        return Deck(self._core.in_units(system), None, self._options)

    # Variables.

    @property
    def records(self) -> Tuple[Record, ...]:
        """The records of this deck, in order."""
        return tuple(Record(self, id, instance) for id, instance in self._core.records())

    def record(self, id: str, instance: int = 1) -> Record:
        """One record, e.g. ``deck.record("5A")``."""
        if self._core.values(id, instance) is None:
            known = schema.records().get(id)
            raise InputError(
                f"this deck has no record {id}" + (f", instance {instance}" if instance != 1 else "")
                + (f"; only decks with {known.condition} have this record" if known else "; adore.schema.records() lists all records")
            )
        return Record(self, id, instance)

    def variables(self) -> List[str]:
        """Names of the variables that this deck has, in deck order."""
        seen: dict[str, None] = {}
        for record in self.records:
            seen.update(dict.fromkeys(record.names))
        return list(seen)

    def _find(self, name: str) -> Tuple[schema.RecordSpec, int]:
        found = self._core.record_of(name)
        if found is None:
            schema.variable(name)  # refuses an unknown one
            where = [r for r in schema.records().values() if any(v.name == name for v in r.variables)]
            raise InputError(
                f"{name}: this deck does not have this variable; the variable is in "
                + " or ".join(f"record {r.id} (needed when `{r.condition}`)" for r in where)
            )
        return schema.records()[found[0]], found[1]

    def _get(self, name: str, indices: Sequence[int] = ()) -> Value:
        record, place = self._find(name)
        instances = [i for id, i in self._core.records() if id == record.id]
        values = [(self._core.values(record.id, i) or [])[place] for i in instances]
        left, label = list(indices), name
        out: Any = values if record.repeat else values[0]
        for level, present in (("instance", bool(record.repeat)), ("element", record.variables[place].length != "1")):
            if not present:
                if level == "element":
                    out = [v[0] for v in out] if isinstance(out[0], list) else out[0]
                continue
            if left:
                at = left.pop(0)
                if not 1 <= at <= len(out):
                    raise InputError(f"{label}[{at}]: the index must be 1 to {len(out)}")
                out, label = out[at - 1], f"{label}[{at}]"
        if left:
            raise InputError(f"{label}: it is a single value; omit the index")
        if isinstance(out, list):
            return tuple(_array(v) for v in out) if out and isinstance(out[0], list) else _array(out)
        return out

    def get(self, name: str, unit: Optional[str] = None) -> Value:
        """A value by its name, in the unit of the deck or in another unit: ``deck.get("rpm2", "rad/s")``,
        ``deck.get("pitchDia", "SI")``. An index selects an instance or element: ``"cageGsCls[2]"``."""
        bare, indices = _split(name)
        value = self._get(bare, indices)
        if unit is None:
            return value
        own = self._core.unit(bare)
        if unit == own:
            return value
        if not own:
            raise UnitError(f"{bare} has no unit in this deck; give the number without a unit")
        scale = self._core.si_factor(bare) if unit == "SI" else units.factor(own, unit)
        return value * scale if not isinstance(value, tuple) else tuple(np.asarray(v) * scale for v in value)

    def unit(self, name: str) -> str:
        """Unit of a variable in this deck; empty for dimensionless numbers, codes and texts."""
        bare = _split(name)[0]
        self._find(bare)
        return self._core.unit(bare)

    def help(self, name: str) -> str:
        """Meaning, unit, codes and range of a variable."""
        return schema.variable(_split(name)[0]).text()

    def set(self, name: str, value: Value, unit: Optional[str] = None) -> None:
        """Sets a value by its name: ``deck.set("pitchDia", 60.5, "mm")``."""
        self.update({name: value if unit is None else (value, unit)})

    def update(self, changes: Optional[Mapping[str, Value]] = None, **more: Value) -> None:
        """Sets several variables as one change. Options that decide which records a deck has are set first.

        >>> deck = adore.new("ball")
        >>> deck.update(rpm2=12000, appLoadX=(0.8, "kN"))
        >>> deck.appLoadX
        800.0

        If a value is wrong, the deck is unchanged and :class:`adore.InputError` lists every error. If changed options
        need further records, these get default values, and a :class:`adore.DeckWarning` is issued."""
        sets: List[Tuple[str, str]] = []
        for name, value in {**(changes or {}), **more}.items():
            sets.append((name, self._value_text(name, value)))
        for issue in self._core.set_all(sets):
            warnings.warn(issue.text, DeckWarning, stacklevel=2)

    def _value_text(self, name: str, value: Value) -> str:
        bare = _split(name)[0]
        spec = schema.known(bare)
        if spec is None:  # the deck refuses it, with all other mistakes
            return ",".join(_text(v, False) for v in _flat(value if not isinstance(value, tuple) else value[0]))
        if isinstance(value, tuple) and len(value) == 2 and isinstance(value[1], str) and spec.type != "string":
            number, unit = value
            own = self._core.unit(bare) or (spec.unit if self._core.record_of(bare) is None else "")
            if unit == "SI":
                scale = 1.0 / self._core.si_factor(bare)
            elif unit == own:
                scale = 1.0
            elif not own:
                raise UnitError(f"{bare} has no unit in this deck; give the number without a unit")
            else:
                scale = units.factor(unit, own)
            value = number if scale == 1.0 else [_rounded(float(v) * scale) for v in _flat(number)]
        return ",".join(_text(v, spec.type == "int") for v in _flat(value))

    def __getattr__(self, name: str) -> Value:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self._get(name)
        except InputError as error:
            raise AttributeError(str(error)) from None

    def __setattr__(self, name: str, value: Value) -> None:
        if hasattr(type(self), name) and name not in schema.variable_names():
            raise AttributeError(f"{name} is not a deck variable")
        self.update({name: value})

    def __getitem__(self, name: str) -> Value:
        return self.get(name)

    def __setitem__(self, name: str, value: Value) -> None:
        self.update({name: value})

    def __iter__(self) -> Iterator[str]:
        """The names of the variables, as for a dictionary."""
        return iter(self.variables())

    def __len__(self) -> int:
        return len(self.variables())

    def __contains__(self, name: object) -> bool:
        return isinstance(name, str) and self._core.record_of(name) is not None

    def __dir__(self) -> List[str]:
        return [*(n for n in object.__dir__(self) if n not in schema.variable_names()), *self.variables()]

    def _ipython_key_completions_(self) -> List[str]:
        return self.variables()

    def __eq__(self, other: object) -> bool:
        return self._core == other._core if isinstance(other, Deck) else NotImplemented

    __hash__ = None  # type: ignore[assignment]

    def __copy__(self) -> Deck:
        return self.copy()

    def __deepcopy__(self, memo: object) -> Deck:
        return self.copy()

    def __reduce__(self) -> Tuple[Any, ...]:
        """Pickles the deck as its text, e.g. for ``multiprocessing`` and ``concurrent.futures``."""
        return _from_parts, (self.source(), self._core.name, self._path, self._options)

    def differences(self, other: Deck) -> List[str]:
        """Differences to another deck, one line each ("here" is this deck)."""
        return self._core.differences(other._core)

    # Run options.

    @property
    def options(self) -> dict[str, str]:
        """Run options, which are not deck variables. Options from ADORE.json in the folder of the deck are included.
        ``adore.run_options()`` lists them."""
        return self._options

    def _request(self, options: Optional[Mapping[str, Any]] = None) -> Tuple[str, str, dict[str, str]]:
        merged = {**self._options, **(options or {})}
        texts = {k: str(int(v)) if isinstance(v, bool) else str(v) for k, v in merged.items()}
        return self.source(), self._core.name, texts

    # What can be done with it.

    def check(self, *, user: User = None) -> Findings:
        """All errors, warnings and notes of the deck. ``user``: as in :meth:`run`."""
        return Findings(_core.check(*self._request(), routines_of(user)))

    def plan(self, *, user: User = None, **options: Any) -> Plan:
        """Bodies, effects, unknowns and cost of a run. ``user``: as in :meth:`run`."""
        return Plan(*_core.plan(*self._request(options), routines_of(user)))

    def statics(self, *, user: User = None, **options: Any) -> Statics:
        """The quasi-static equilibrium: loads, displacements, stiffness, life. No file is written. ``user``: as in :meth:`run`."""
        return Statics(_core.equilibrium(*self._request(options), routines_of(user)))

    def run(
        self,
        out: Optional[PathLike] = None,
        *,
        until: Union[str, float, None] = None,
        integrator: Optional[str] = None,
        tol: Optional[float] = None,
        options: Optional[Mapping[str, Any]] = None,
        user: User = None,
        progress: Union[bool, None, ProgressCallback] = None,
        overwrite: bool = False,
        resume: bool = False,
    ) -> Run:
        """Runs the deck: ``deck.run("results", until="2rev")``.

        out: output folder (default: a temporary folder that is removed together with the result).
        until: length of the run, "5rev", "0.02s" or a dimensionless time (default: the length in the deck).
        integrator, tol: replace those of the deck. options: run options of this run.
        user: user routines, as :class:`adore.Routines` or as the path of a shared library or a file of formulas. The code in
        the file is executed. Only this argument can load user routines.
        progress: True shows a progress line. A callable receives an :class:`adore.Progress` up to 20 times a second and can
        end the run by returning False. Default: a progress line if there is a terminal.
        overwrite: replace results of an earlier run in the folder. resume: continue that run.

        The interpreter lock is released during the run. Ctrl-C ends the run with valid files and raises
        :class:`adore.Interrupted`. :class:`adore.RunFailed` is raised if the solver fails, and
        :class:`adore.UntrustedResult` if the results cannot be trusted. All three exceptions have the attribute ``run``."""
        return start_run(self._request(options), routines_of(user), out, until, integrator, tol, progress, overwrite, resume)

    def sweep(
        self,
        variable: str,
        first: float,
        last: float,
        count: int,
        out: PathLike,
        *,
        until: Union[str, float, None] = None,
        integrator: Optional[str] = None,
        tol: Optional[float] = None,
        options: Optional[Mapping[str, Any]] = None,
        user: User = None,
        threads: int = 0,
        progress: Union[bool, None, ProgressCallback] = None,
        overwrite: bool = False,
        resume: bool = False,
    ) -> pd.DataFrame:
        """Runs the deck with ``count`` evenly spaced values of one variable, on ``threads`` cores (0: all cores).

        Returns the table SWEEP.csv as a data frame with one row for each run. The files of each run are in a subfolder
        of ``out``."""
        return start_sweep(self._request(options), routines_of(user), variable, first, last, count, out, until, integrator, tol, threads,
                           progress, overwrite, resume)  # fmt: skip

    # For people.

    def story(self) -> str:
        """Description of the deck and of its run in a few lines."""
        return "\n".join(self._core.story())

    def __repr__(self) -> str:
        return f"<adore.Deck {self._core.name}: {len(self._core.records())} records>\n{self.story()}"

    def _repr_html_(self) -> str:
        records = "".join(record._repr_html_() for record in self.records)
        return f"<b>{html.escape(self._core.name)}</b><pre>{html.escape(self.story())}</pre>{records}"


def _from_parts(source: str, name: str, path: Optional[Path], options: Mapping[str, str]) -> Deck:
    return Deck(_core.Deck.from_text(source, name), path, options)


def _replace(target: Path, text: str) -> None:
    """Writes a file as a whole: a failure leaves the former one."""
    handle, temporary = tempfile.mkstemp(prefix=".adore-", dir=target.parent or ".")
    try:
        with os.fdopen(handle, "w", encoding="utf-8", newline="") as file:
            file.write(text)
        mode = target.stat().st_mode & 0o777 if target.exists() else 0o666 & ~_umask()
        os.chmod(temporary, mode)
        os.replace(temporary, target)
    except BaseException:
        os.unlink(temporary)
        raise


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


def _rounded(value: float) -> float:
    """Rounds away the last digits that a change of units adds: 60.5 mm is 0.0605 m."""
    return float(f"{value:.15g}")


Facts = Union[Mapping[str, Any], PathLike]


def _facts_text(facts: Facts) -> str:
    return json.dumps(facts) if isinstance(facts, Mapping) else Path(facts).read_text(encoding="utf-8")


class Candidates(List[Dict[str, Any]]):
    """The internal geometries of :func:`candidates`, best first; printed as a table. Attributes: `contradictions`
    (pairs of facts), `missing`, `fact_use`, `decisive`, `given_ratings`, `not_listed`."""

    def __init__(self, facts: str) -> None:
        report = json.loads(_core.candidates(facts))
        super().__init__(report["candidates"])
        self.contradictions = [tuple(pair) for pair in report["contradictions"]]
        self.missing: List[str] = report["missing"]
        self.fact_use: List[str] = report["fact_use"]
        self.decisive: str = report["decisive"]
        self.given_ratings: Dict[str, float] = report["given_ratings"]
        self.not_listed: int = report["not_listed"]
        self._text = _core.candidates_text(facts)

    def __repr__(self) -> str:
        return self._text


def candidates(facts: Facts) -> Candidates:
    """All internal geometries that agree with published facts: a dictionary, or a file FACTS.json. Quantities have
    units: ``adore.candidates({"designation": "6205", "C": "14 kN", "C0": "7.8 kN", "BPFO": 3.585})``.

    Members: designation, type, bore, outside, width, C, C0, Cu, BPFO, BPFI, FTF, BSF, mass, count, rows,
    element_diameter, element_length, pitch_diameter, contact_angle, clearance, cage, limiting_speed, source."""
    return Candidates(_facts_text(facts))


def new(name: str = "", *, facts: Optional[Facts] = None, choose: int = 1) -> Deck:
    """A complete example deck: "ball", "cylindrical", "spherical", "tapered", "spherical-tapered" or another name of
    :func:`adore.examples`; or, with `facts`, the deck of candidate `choose` of :func:`candidates`."""
    if facts is None:
        return Deck(_core.Deck.example(name))
    if name:
        raise InputError("give the name of an example or facts, not both")
    return Deck(_core.Deck.from_facts(_facts_text(facts), choose))


def catalogue(designation: str) -> Deck:
    """A bearing by its designation ("6205", "7208 B", "NU209", "30208", "22210") or by type and size
    ("deep-groove 25x52x15" in mm). The boundary dimensions are standard values. The internal geometry is an estimate,
    as the comments in the deck state."""
    return Deck(_core.Deck.catalogue(designation))


def read(path: PathLike = ".") -> Deck:
    """Reads a deck file, or DATA.txt in a folder, and the run options from ADORE.json in the same folder.

    If the deck has errors, an :class:`adore.InputError` with all of them is raised. Warnings are issued as
    :class:`adore.DeckWarning`."""
    core = _core.Deck.read(os.fspath(path))
    for issue in core.warnings:
        if issue.severity == "warning":
            warnings.warn(issue.text, DeckWarning, stacklevel=2)
    return Deck(core, Path(core.name), _core.options_of_deck(core.name))


def check(path: PathLike = ".") -> Findings:
    """All errors, warnings and notes of a deck file, even if it cannot be read as a deck."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", DeckWarning)
            return read(path).check()
    except InputError as error:
        if not error.issues:
            raise
        return Findings(_core.findings_of(error.issues))


def examples() -> dict[str, str]:
    """The example decks: name and description."""
    return dict(_core.examples())
