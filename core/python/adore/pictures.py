"""Pictures: the charts and views of the command line and the applications."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import List, Optional, Sequence, Union

from .errors import InputError, PicturesMissingError

__all__ = ["Picture", "Pictures", "animate", "plot", "program"]

PathLike = Union[str, "os.PathLike[str]"]


class Picture:
    """A PNG picture; a notebook shows it."""

    def __init__(self, data: bytes, name: str) -> None:
        self.data = data
        self.name = name

    def save(self, path: PathLike) -> Path:
        """Writes the picture to a file, or into a folder with its own name."""
        target = Path(path)
        if target.is_dir():
            target = target / self.name
        target.write_bytes(self.data)
        return target

    def _repr_png_(self) -> bytes:
        return self.data

    def __repr__(self) -> str:
        return f"<adore.Picture {self.name}: {len(self.data)} bytes of PNG>"


class Pictures(List[Picture]):
    """Several pictures; a notebook shows all of them."""

    def save(self, folder: PathLike) -> List[Path]:
        """Writes all pictures into a folder, which is created if necessary."""
        Path(folder).mkdir(parents=True, exist_ok=True)
        return [picture.save(folder) for picture in self]

    def _repr_html_(self) -> str:
        return "".join(embedded(picture) for picture in self)


def embedded(picture: Picture) -> str:
    """An HTML image with embedded data."""
    import base64

    data = base64.b64encode(picture.data).decode("ascii")
    return f'<img alt="{picture.name}" style="max-width:100%" src="data:image/png;base64,{data}">'


def program() -> Optional[str]:
    """Path of the drawing program: from ADORE_PICTURES, this build, the PATH or the folder of Python; None if there is no
    such program."""
    named = os.environ.get("ADORE_PICTURES")
    if named:
        return named
    here = Path(__file__).resolve().parent
    places = [here.parent.parent / "bin", Path(sys.prefix) / "bin"]
    for folder in places:
        if os.access(folder / "adore-pictures", os.X_OK):
            return str(folder / "adore-pictures")
    return shutil.which("adore-pictures")


def _draw(words: Sequence[str]) -> Pictures:
    tool = program()
    if tool is None:
        raise PicturesMissingError(
            "the drawing program adore-pictures was not found; build Adore with Qt (preset release), and put the program "
            "on the PATH or set ADORE_PICTURES to its path"
        )
    with tempfile.TemporaryDirectory(prefix="adore-pictures-") as folder:
        try:
            done = subprocess.run(
                [tool, *words, "--out", folder, "--progress", "none"], capture_output=True, text=True, check=False,
                env={**os.environ, "QT_QPA_PLATFORM": "offscreen"},
            )  # fmt: skip
        except OSError as error:
            raise PicturesMissingError(f"the drawing program {tool} does not start: {error.strerror}") from None
        if done.returncode != 0:
            raise InputError(done.stderr.strip().removeprefix("adore: ") or f"{tool} ended with exit code {done.returncode}")
        files = [Path(line) for line in done.stdout.splitlines() if line.endswith(".png")]
        return Pictures(Picture(file.read_bytes(), file.name) for file in files)


def plot(
    *files: PathLike,
    page: Optional[int] = None,
    abscissa: str = "rev",
    first: int = 1,
    last: Optional[int] = None,
    every: int = 1,
    dark: bool = False,
) -> Pictures:
    """The pages of SOL1-SOL7, a quasi-static RUN.json or a SWEEP.csv, as ``adore plot`` draws them.

    page: number of the page, counted from 1 (default: all pages); abscissa: "rev" or "time"; first, last, every: stored
    steps, counted from 1."""
    words = ["plot", *(os.fspath(f) for f in files), "--abscissa", abscissa, "--from", str(first), "--every", str(every)]
    words += ["--page", str(page)] if page is not None else []
    words += ["--to", str(last)] if last is not None else []
    return _draw(words + (["--dark"] if dark else []))


def animate(
    file: PathLike,
    *,
    view: str = "bearing",
    frame: Optional[int] = 1,
    every: int = 1,
    race: str = "inner",
    element: int = 1,
    colour: str = "none",
    contacts: bool = False,
    dark: bool = False,
) -> Pictures:
    """Frames of SOL8 or RESULTS.h5, as ``adore animate`` draws them.

    view: "bearing", "cage", "pocket", "element", "race", "flange" or "section"; frame: number of the frame, counted from 1, or
    None for every ``every``-th frame; colour: "none", "load", "slip", "heat" or "temperature"."""
    words = ["animate", os.fspath(file), "--view", view, "--race", race, "--element", str(element), "--colour", colour]
    words += ["--frame", str(frame)] if frame is not None else ["--every", str(every)]
    return _draw(words + (["--contacts"] if contacts else []) + (["--dark"] if dark else []))
