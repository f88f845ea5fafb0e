"""User routines in Python: functions over NumPy arrays in SI units that replace laws of Adore.

>>> import numpy as np
>>> routines = adore.Routines()
>>> @routines.traction("element_race", table=True, slip_scale=0.2)
... def law(slip):
...     return 0.06 * np.tanh(slip / 0.2)
>>> routines.errors["element_race"] < 1e-6
True

``deck.run(user=routines)`` runs with these functions; ``kTrac = -1`` in the deck selects the law. A table is built once,
before the run, so that the run does not call Python. A function without a table is called at every evaluation;
``routines.cost()`` reports the time. Functions must be pure (same arguments, same result), because the solver repeats steps.
"""

from __future__ import annotations

import os
from types import SimpleNamespace
from typing import Any, Callable, Dict, Tuple, TypeVar, Union

import numpy as np

from . import _core
from .errors import InputError

__all__ = ["Routines", "routines_of"]

_Function = TypeVar("_Function", bound=Callable[..., Any])
_BODIES = {"flange": 2, "pocket": 3, "land": 4}
_HOOKS = {"material": 0, "motion": 1, **_BODIES, "elements": 5, "races": 6, "traction": 7, "imperfections": 8, "results": 9}


class Routines:
    """Python functions as user routines ADRX0 to ADRX9. Each decorator below describes arguments and results of its function.

    version: appended to the program's version in every file."""

    def __init__(self, version: str = "") -> None:
        self._core = _core.Routines(version)
        #: For each tabulated law: largest difference between table and function, divided by the largest value.
        self.errors: Dict[str, float] = {}
        self._names: list[str] = []

    def traction(
        self,
        kind: str = "element_race",
        *,
        table: bool = False,
        slip_scale: float = 0.0,
        points: bool = False,
        largest_slip: float = 100.0,
        tolerance: float = 1e-7,
    ) -> Callable[[_Function], _Function]:
        """ADRX7: traction coefficient (>= 0) as a function of slip for one type of contact: "element_race" (kTrac = -1),
        "element_cage" (kCPTrac), "cage_race" (kCRTrac), "roller_flange" (kRFTrac) or "element_element" (kRRTrac).

        With ``table=True`` the function is ``law(slip)``. It is evaluated here for slips up to ``largest_slip`` [m/s] until the
        error of a monotone table, divided by the largest value, is below ``tolerance``. ``errors`` contains the remaining error.
        Otherwise the function is ``law(slip, contact)``. ``slip`` has a row for each point of a contact and a column for each
        contact. ``contact`` has ``time``, ``race`` (0: outer) and ``pressure`` (same shape as slip; None unless ``points``). It
        also has one value for each contact of ``load``, ``peak_pressure``, ``half_major``, ``half_minor``, ``entrainment``,
        ``curvature`` and ``middle_slip``.
        slip_scale: slip range in which the law rises from zero [m/s]; contact integrals are split there."""

        def decorate(law: _Function) -> _Function:
            slip, kappa = np.empty(0), np.empty(0)
            if table:
                slip, kappa, self.errors[kind] = _tabulated(law, slip_scale, largest_slip, tolerance)
            self._core.set_traction(kind, lambda given: law(given.pop("slip"), SimpleNamespace(**given)), slip, kappa,
                                    slip_scale, points)  # fmt: skip
            self._names.append(f"traction {kind}" + (f", table of {len(slip)} points" if table else ""))
            return law

        return decorate

    def force(self, body: str) -> Callable[[_Function], _Function]:
        """ADRX2 to ADRX4: normal force of overlapping "flange", "pocket" or "land" contacts. ``law(contacts)`` returns one force
        for each contact [N]. ``contacts`` has ``time``, ``element``, ``surface``, ``gap`` (negative) [m], ``gap_rate`` [m/s] and
        ``built_in`` (force of the built-in law)."""
        if body not in _BODIES:
            raise InputError(f'force of "{body}": give "flange", "pocket" or "land"')
        return self._decorator(_BODIES[body], f"force {body}")

    def motion(self, law: _Function) -> _Function:
        """ADRX1: loads and accelerations of the races. ``law(now)`` returns a dictionary. In the first call ``now.start`` is true.

        In the first call the dictionary may contain ``drives`` (two Booleans: the routine gives the accelerations of this race),
        ``start_velocity`` (2 x 3), ``start_spin`` (2), ``moves_frame``, ``longest_step`` and ``kinks`` (times). In later calls
        ``now`` has ``time``, ``position``, ``velocity``, ``omega`` (2 x 3: outer, inner race; x, y, z) and ``angle``. The
        dictionary may then contain ``force``, ``moment``, ``acceleration``, ``angular_acceleration`` (2 x 3), and for the base
        frame ``frame_acceleration``, ``frame_omega`` and ``frame_angular_acceleration`` (3)."""
        return self._decorator(1, "motion")(law)

    def material(self, law: _Function) -> _Function:
        """ADRX0: properties of materials with code 2. ``law(part)`` returns a dictionary with the properties that differ from the
        values in ``part``: ``density``, ``elastic_modulus``, ``poisson_ratio`` ... ``part.part`` is "element", "outer_race",
        "inner_race", ..."""
        return self._decorator(0, "material")(law)

    def elements(self, law: _Function) -> _Function:
        """ADRX5: radius errors of rolling elements. ``law(places)`` returns the increase of the radius at each place [m].
        ``places`` has one entry for each place of ``element`` (from 0), ``axial`` (from mid length) [m] and ``azimuth`` [rad]. It
        also has ``elements``, ``element_diameter`` and ``pitch_diameter``. The radius of rollers may vary along the roller and, if
        uniform along the roller, with the azimuth. The radius of balls may vary smoothly in both directions (``axial`` along the
        x axis of the ball, ``azimuth`` about this axis)."""
        return self._decorator(5, "elements")(law)

    def races(self, law: _Function) -> _Function:
        """ADRX6: surfaces of races with kRaceGeoImp1, kRaceGeoImp2 = 3. ``law(places)`` returns the increase of the radius at
        each place [m], or a dictionary with ``radius`` and, for grooves, ``curvature_factor`` (added to the groove factor). Both
        may vary across the race and may have steps. ``places`` is as in :meth:`elements`, with ``race`` ("outer_race" or
        "inner_race") instead of ``element``."""
        return self._decorator(6, "races")(law)

    def imperfections(self, law: _Function) -> _Function:
        """ADRX8: imperfections of elements (kReGeoImp = 3) and pockets (kCagePocImp = 4), and inertia (kReIP = 3).
        ``law(bearing)`` returns a dictionary of arrays with one entry for each element: ``diameter``, ``crown_radius``, ``length``,
        ``central_length``, ``land_offset``, ``pocket_clearance1``, ``pocket_clearance2``, ``pocket_thickness``,
        ``pocket_axial`` [m], ``pocket_angular``, ``pocket_tilt`` (n x 3) [rad], ``mass``, ``moments``, ``geometric_centre`` and
        ``frame``. ``bearing`` has ``n``, ``elements_wanted``, ``pockets_wanted``, ``inertia_wanted``, and the present values of
        ``mass``, ``moments`` ..."""
        return self._decorator(8, "imperfections")(law)

    def read(self, routine: str, count: int) -> None:
        """Assigns ``count`` numbers of records 12.x to a routine ("motion", "pocket" ...). Its function receives them as
        ``numbers``. Routines read in the order ADRX0 to ADRX9, and together they must read all lines."""
        if routine not in _HOOKS:
            raise InputError(f'numbers of "{routine}": give one of {", ".join(_HOOKS)}')
        self._core.set_numbers(_HOOKS[routine], count)

    def results(self, law: _Function) -> _Function:
        """ADRX9: output after each counted step. ``law(step)`` returns the text for SOL9, or None. In the first call
        ``step.start`` is true. ``step`` has ``time``, ``step``, and for the elements ``x``, ``r``, ``theta``, ``load`` and
        ``contact_angle``. For each heat source it has ``source_kind``, ``source_element`` and ``source_race`` (from 0; -1: none),
        ``source_place``, ``source_size``, ``source_heat`` and ``source_name``. ``channels`` is a dictionary of the channels of
        RESULTS.h5 by name (SI, rad)."""
        return self._decorator(9, "results")(law)

    def _decorator(self, hook: int, name: str) -> Callable[[_Function], _Function]:
        def decorate(law: _Function) -> _Function:
            self._core.set(hook, lambda given: law(SimpleNamespace(**given)))
            self._names.append(name)
            return law

        return decorate

    def cost(self) -> str:
        """Number and time of the Python calls during runs."""
        calls, seconds = self._core.direct_cost
        if calls == 0:
            return "no Python calls during the run"
        return f"{calls} Python calls during the run, {1e6 * seconds / calls:.1f} µs each, {seconds:.3g} s in total"

    def __repr__(self) -> str:
        errors = "".join(f"; {kind} table: relative error up to {error:.1e}" for kind, error in self.errors.items())
        return f"<adore.Routines {', '.join(self._names) or 'without functions'}{errors}; {self.cost()}>"


def routines_of(user: Union[Routines, str, "os.PathLike[str]", None]) -> Union[_core.Routines, str, None]:
    """Converts the argument ``user`` for the solver."""
    return user._core if isinstance(user, Routines) else None if user is None else os.fspath(user)


def _tabulated(law: Callable[..., Any], slip_scale: float, largest: float, tolerance: float) -> Tuple[np.ndarray, np.ndarray, float]:
    """Slips and values of a monotone table of a law, and the error of the table at seven points of each interval."""

    def values(slip: np.ndarray) -> np.ndarray:
        out = np.broadcast_to(np.asarray(law(slip), dtype=float), slip.shape)
        wrong = ~np.isfinite(out) | (out < 0.0)
        if wrong.any():
            raise InputError(f"the law returns {out[wrong][0]:g} at a slip of {slip[wrong][0]:g} m/s; return a finite coefficient >= 0")
        return out

    smallest = 1e-4 * (slip_scale or 1.0)
    slip = np.concatenate(([0.0], np.geomspace(smallest, largest, 65)))
    fractions = np.linspace(0.0, 1.0, 9)[1:-1]
    error = np.inf
    for left in reversed(range(25)):
        kappa = values(slip)
        probes = slip[:-1, None] + np.diff(slip)[:, None] * fractions
        exact = values(probes.ravel()).reshape(probes.shape)
        scale = max(float(np.abs(kappa).max()), float(exact.max()), 1e-300)
        table = _core.interpolate(slip, kappa, probes.ravel()).reshape(probes.shape)
        errors = np.abs(table - exact).max(axis=1) / scale
        error = float(errors.max())
        bad = np.flatnonzero(errors > tolerance)
        if not len(bad) or left == 0 or len(slip) + len(bad) > 50000:
            break
        bad = np.unique(np.clip(np.concatenate((bad - 1, bad, bad + 1)), 0, len(slip) - 2))  # slopes come from neighbours
        slip = np.sort(np.concatenate((slip, 0.5 * (slip[bad] + slip[bad + 1]))))
    return slip, kappa, error
