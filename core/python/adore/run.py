"""Plans, equilibria and runs."""

from __future__ import annotations

import html
import json
import os
import shutil
import tempfile
import weakref
from pathlib import Path
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core, pictures
from .errors import AdoreError, InputError, Interrupted, RunFailed, UntrustedResult
from .results import Channels, _pandas, read_table
from .progress import ProgressCallback, show_progress

if TYPE_CHECKING:
    import pandas as pd

__all__ = ["Plan", "Run", "Statics", "open_run"]

PathLike = Union[str, "os.PathLike[str]"]


class Plan:
    """Bodies, effects and unknowns of a run, and its cost in time and disk space."""

    def __init__(self, text: str, data: str, remarks: Sequence[_core.Finding]) -> None:
        #: The plan as ``adore plan`` prints it.
        self.text = text
        #: The same as data: bodies, effects, estimates, disk.
        self.data: Dict[str, Any] = json.loads(data)
        self.remarks = list(remarks)
        #: The same list: every finding with code, value and limit.
        self.findings = self.remarks

    @property
    def effects(self) -> Dict[str, bool]:
        """Name of each effect, and True if it is on."""
        return {e["name"]: bool(e["on"]) for e in self.data["effects"]}

    def __repr__(self) -> str:
        return self.text

    def _repr_html_(self) -> str:
        return f"<pre>{html.escape(self.text)}</pre>"


class _Summary:
    """Key results by name."""

    def __init__(self, results: Sequence[Tuple[str, str, str, float]]) -> None:
        self._results = list(results)

    @property
    def summary(self) -> Dict[str, float]:
        """Key results by name, e.g. "largest_contact_load_N" (SI units, lives in hours)."""
        return {id: value for id, _, _, value in self._results}

    def _rows(self) -> str:
        return "".join(
            f"<tr><td style='text-align:left'>{html.escape(label)}</td><td>{value:.6g}</td><td>{html.escape(unit)}</td></tr>"
            for _, label, unit, value in self._results
        )


class Statics(_Summary):
    """The quasi-static equilibrium in SI units and radians. The five components are x, y, z, rotation about y, rotation about z."""

    def __init__(self, solution: Mapping[str, Any]) -> None:
        super().__init__(solution["results"])
        #: "ball", "cylindrical" ...
        self.bearing: str = solution["bearing"]
        #: Of the inner race, from where its geometry alone puts it [m, rad].
        self.displacement = np.array(solution["displacement"])
        #: What the shaft applies to the inner race [N, N m].
        self.load = np.array(solution["load"])
        #: d load / d displacement.
        self.stiffness: np.ndarray = solution["stiffness"]
        #: The results in a few sentences, in the deck's units.
        self.lines: List[str] = solution["lines"]
        self.remarks: List[_core.Finding] = solution["remarks"]
        #: The same list: every finding with code, value and limit.
        self.findings = self.remarks
        #: Computing time [s].
        self.seconds: float = solution["seconds"]
        self._tables = solution["tables"]

    @property
    def tables(self) -> List[str]:
        """Names of the tables."""
        return list(self._tables)

    def columns(self, name: str = "elements") -> Dict[str, np.ndarray]:
        """A table as arrays by "name [unit]". "elements" has one row for each rolling element, "slices" one for each roller slice."""
        if name not in self._tables:
            raise InputError(f"this equilibrium has no table {name}; its tables are {', '.join(self._tables)}")
        return {f"{label} [{unit}]" if unit not in ("", "-") else label: values for label, unit, values in self._tables[name]}

    def table(self, name: str = "elements") -> pd.DataFrame:
        """The table as a data frame; elements are counted from 1."""
        frame = _pandas().DataFrame(self.columns(name))
        frame.index += 1
        return frame

    def __repr__(self) -> str:
        return "\n".join(self.lines)

    def _repr_html_(self) -> str:
        return f"<pre>{html.escape(repr(self))}</pre><table>{self._rows()}</table>"


class Run(_Summary):
    """A run and its files: key results, channels, tables, pictures."""

    def __init__(self, folder: PathLike, outcome: Optional[_core.RunOutcome] = None, keep: Any = None) -> None:
        #: Folder of the files.
        self.folder = Path(folder)
        self._keep = keep
        self._outcome = outcome
        self._channels: Optional[Channels] = None
        if outcome is None and not (self.folder / "RUN.json").exists():
            raise InputError(f"there is no RUN.json in {self.folder}; give the output folder of a run")
        super().__init__(outcome.results if outcome is not None else _stored_results(self.report))

    @property
    def report(self) -> Dict[str, Any]:
        """RUN.json: plan, ledgers, versions, options, seeds, cost."""
        return dict(json.loads((self.folder / "RUN.json").read_text(encoding="utf-8")))

    @property
    def status(self) -> str:
        """"done", "interrupted", "failed" or "untrusted"."""
        return self._outcome.status if self._outcome is not None else str(self.report["status"])

    @property
    def message(self) -> str:
        """Diagnosis and remedy of a run that failed."""
        return self._outcome.message if self._outcome is not None else str(self.report.get("message", ""))

    @property
    def files(self) -> List[Path]:
        """Files of the run."""
        if self._outcome is not None:
            return [Path(f) for f in self._outcome.files]
        return [self.folder / name for name in self.report["files"]]

    @property
    def outcome(self) -> Optional[_core.RunOutcome]:
        """Steps, time, revolutions, computing time and energy, if this session made the run; None for an opened run."""
        return self._outcome

    @property
    def remarks(self) -> List[_core.Finding]:
        """Warnings and notes, if this session made the run."""
        return list(self._outcome.remarks) if self._outcome is not None else []

    @property
    def accuracy(self) -> Dict[str, Any]:
        """Confidence intervals of the results: "means" (batch means of the run). After ``adore run --verify`` or ``--accuracy``
        also "quantities" with numerical and statistical error. Empty: not computed."""
        return dict(self.report.get("accuracy", {}))

    @property
    def verification(self) -> Dict[str, Any]:
        """Result of ``adore run --verify``: "against", "errors", "results" of both runs. Empty: not verified."""
        return dict(self.report.get("verify", {}))

    @property
    def findings(self) -> List[_core.Finding]:
        """All findings with code, value and limit; for an opened run those in RUN.json or RESULTS.h5."""
        return list(self._outcome.remarks) if self._outcome is not None else _core.run_findings(str(self.folder))

    @property
    def channels(self) -> Channels:
        """All channels of RESULTS.h5 as arrays."""
        if self._channels is None:
            self._channels = Channels(self.folder / "RESULTS.h5")
        return self._channels

    def __getitem__(self, id: str) -> np.ndarray:
        """A channel: ``run["contact.load"]``."""
        return self.channels[id]

    def _ipython_key_completions_(self) -> List[str]:
        return list(self.channels)

    def table(self, name: str = "SOL1") -> pd.DataFrame:
        """A file of the run, "SOL1" to "SOL8" or "RESULTS.h5", as a data frame; see :func:`adore.read_table`."""
        return read_table(self.folder / name)

    def listing(self) -> str:
        """The text of PRINT.txt."""
        return (self.folder / "PRINT.txt").read_text(encoding="utf-8")

    # Pictures.

    def _charts(self) -> List[Path]:
        sols = [f for f in self.files if f.name in {f"SOL{k}" for k in range(1, 8)}]
        return sorted(sols, key=lambda f: f.name) or [self.folder / "RUN.json"]

    def plot(self, name: Optional[str] = None, page: Optional[int] = None, **how: Any) -> pictures.Pictures:
        """Pages of a plot file (default: all pages): ``run.plot("SOL7", page=1)``. Without a file name: the first plot file,
        or the tables of a quasi-static run. ``how``: see :func:`adore.pictures.plot`."""
        return pictures.plot(self.folder / name if name else self._charts()[0], page=page, **how)

    def picture(self, view: str = "bearing", frame: int = 1, **how: Any) -> pictures.Picture:
        """The bearing at a stored frame, counted from 1. ``how``: see :func:`adore.pictures.animate`."""
        file = next((f for f in self.files if f.name == "SOL8"), self.folder / "RESULTS.h5")
        return pictures.animate(file, view=view, frame=frame, **how)[0]

    def _shown(self) -> List[pictures.Picture]:
        """A chart, and for a run over time a picture of the bearing, if available."""
        out: List[pictures.Picture] = []
        if pictures.program() is None:
            return out
        try:
            out += self.plot(page=1)
            if any(f.name in ("SOL8", "RESULTS.h5") for f in self.files):
                out.append(self.picture())
        except AdoreError:  # a notebook shows what there is
            pass
        return out

    def _repr_png_(self) -> Optional[bytes]:
        shown = self._shown()
        return shown[0].data if shown else None

    def _repr_html_(self) -> str:
        head = f"<b>{html.escape(self.status)}</b> {html.escape(self.message)}<table>{self._rows()}</table>"
        return head + "".join(pictures.embedded(p) for p in self._shown())

    def __repr__(self) -> str:
        lines = [f"<adore.Run {self.status}: {self.folder}>"]
        if self._outcome is not None and not self._outcome.lines:
            o = self._outcome
            lines.append(f"{o.steps} steps, {o.revolutions:.4g} revolutions, t = {o.time:.6g} s, computed in {o.seconds:.2g} s")
            if o.energy_scale > 0.0:
                lines.append(f"energy residual: {o.energy_residual:.3g} J (exchanged energy: {o.energy_scale:.3g} J)")
        lines += self._outcome.lines if self._outcome is not None else []
        lines += [f"  {label:<36} {value:>12.6g} {unit}".rstrip() for _, label, unit, value in self._results]
        return "\n".join(lines)


def _stored_results(report: Mapping[str, Any]) -> List[Tuple[str, str, str, float]]:
    """Key results of RUN.json."""
    out = []
    for id, value in report.get("summary", {}).items():
        number = float("inf") if value == "infinite" else float("nan") if value is None or isinstance(value, str) else float(value)
        out.append((id, id, "", number))
    return out


class _Folder:
    """Removes the folder when the last reference to it is deleted."""

    def __init__(self, path: Path) -> None:
        weakref.finalize(self, shutil.rmtree, path, ignore_errors=True)


def open_run(folder: PathLike) -> Run:
    """The run in a folder."""
    return Run(folder)


def _until(until: Union[str, float, None]) -> str:
    return "" if until is None else until if isinstance(until, str) else repr(float(until))


def start_run(
    request: Tuple[Any, ...],
    routines: Any,
    out: Optional[PathLike],
    until: Union[str, float, None],
    integrator: Optional[str],
    tol: Optional[float],
    progress: Union[bool, None, ProgressCallback],
    overwrite: bool,
    resume: bool,
) -> Run:
    """Implementation of :meth:`adore.Deck.run`."""
    if resume and overwrite:
        raise InputError("resume continues the run in the folder, and overwrite replaces it; give only one of the two")
    if resume and out is None:
        raise InputError("resume needs the output folder of the run; give it as out")
    folder = Path(tempfile.mkdtemp(prefix="adore-run-")) if out is None else Path(out)
    keep = _Folder(folder) if out is None else None
    try:
        outcome = _core.run(*request, routines, str(folder), _until(until), integrator or "", tol, resume, overwrite,
                            show_progress(progress))  # fmt: skip
    except Interrupted:
        raise
    except KeyboardInterrupt:
        raise Interrupted("interrupted before any file was written") from None
    run = Run(folder, outcome, keep)
    if isinstance(outcome.raised, KeyboardInterrupt):
        raise Interrupted("interrupted; the files are valid up to the last stored step", run) from None
    if outcome.raised is not None:
        raise outcome.raised
    if outcome.status == "failed":
        raise RunFailed(outcome.message, run)
    if outcome.status == "untrusted":
        raise UntrustedResult(outcome.message, run)
    return run


def start_sweep(
    request: Tuple[Any, ...],
    routines: Any,
    variable: str,
    first: float,
    last: float,
    count: int,
    out: PathLike,
    until: Union[str, float, None],
    integrator: Optional[str],
    tol: Optional[float],
    threads: int,
    progress: Union[bool, None, ProgressCallback],
    overwrite: bool,
    resume: bool,
) -> pd.DataFrame:
    """Implementation of :meth:`adore.Deck.sweep`."""
    pandas = _pandas()
    table, code, remarks = _core.sweep(
        *request, routines, os.fspath(out), variable, f"{float(first)!r}:{float(last)!r}:{int(count)}", _until(until),
        integrator or "", tol, resume, overwrite, threads, show_progress(progress),
    )  # fmt: skip
    frame = pandas.read_csv(table)
    parted = {c: c.partition(" [") for c in frame.columns}  # "appLoadX [N]"
    frame = frame.rename(columns={c: name for c, (name, _, _) in parted.items()})
    frame.attrs.update(units={name: unit.rstrip("]") for name, _, unit in parted.values()}, path=table, exit_code=code, remarks=[r.text for r in remarks])
    return frame
