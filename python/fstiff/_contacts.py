# SPDX-License-Identifier: BSD-3-Clause
"""Contacts and tabulated laws."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, overload

from . import _core
from ._errors import word, words
from ._numbers import FACE, require_known, with_names
from ._results import Columns, Shown, count_of, draw, frame, number, numbers, shown, shown_rows, text_table, with_unit
from ._surfaces import Measurement, measure, measured_of, warn_of_height

if TYPE_CHECKING:
    import numpy.typing as npt
    import pandas as pd
    from matplotlib.axes import Axes

    from ._results import Numbers
    from ._surfaces import Length, Measurable, Source

    Outside = Literal["refuse", "clamp", "exact", "extrapolate"]


def law_names() -> list[str]:
    """The laws that a contact can have, such as "hertz" and "hybrid"; docs/scene.md describes each of them."""
    return _core.law_names()


def effective_modulus(youngs_modulus: float, poisson_ratio: float, youngs_modulus2: float, poisson_ratio2: float) -> float:
    """Effective modulus [Pa] of two bodies: 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2, with Young's moduli in Pa."""
    return _core.effective_modulus(*_bodies(youngs_modulus, poisson_ratio, youngs_modulus2, poisson_ratio2))


def tangential_ratio(youngs_modulus: float, poisson_ratio: float, youngs_modulus2: float, poisson_ratio2: float) -> float:
    """K_t/K_n of elastic contacts of two bodies, with Young's moduli in Pa (Mindlin, 1949): 0.82 of steel on steel."""
    return _core.tangential_ratio(*_bodies(youngs_modulus, poisson_ratio, youngs_modulus2, poisson_ratio2))


def _bodies(*given: Any) -> list[float]:
    """Young's modulus and Poisson's ratio of the first body, then of the second."""
    return [number(value, name) for value, name in zip(given, ("youngs_modulus", "poisson_ratio", "youngs_modulus2", "poisson_ratio2"))]


def spot_conductance(stiffness: npt.ArrayLike, conductivity: float, effective_modulus: float) -> Numbers:
    """Conductance of heat [W/(m^2 K)] or current [S/m^2] of the spots of a contact of `stiffness` [Pa/m], by the analogy of Barber (2003).

    `conductivity` is the harmonic mean of both bodies [W/(m K) or S/m], `effective_modulus` in Pa. Without films and gap.
    """
    given = (number(conductivity, "conductivity"), number(effective_modulus, "effective_modulus"))
    return _core.spot_conductance(numbers(stiffness, "stiffness"), *given)


class Points(Columns):
    """The states of a contact: a mapping from the column names of `fstiff run --format csv` to arrays, in SI units.

    A point at which the model has no state is NaN in every column; `reasons` has the reason, by the index of the point.
    """

    def __init__(self, columns: dict[str, Numbers], reasons: dict[int, str], law: str) -> None:
        self._values = columns
        self.reasons = reasons
        self.law = law

    def to_dataframe(self) -> pd.DataFrame:
        """The columns as a data frame of pandas."""
        return frame({key: column.ravel() for key, column in self.items()})

    def plot(self, y: str = "stiffness_Pa_per_m", x: str = "pressure_Pa", ax: Axes | None = None) -> Axes:
        """Draws column `y` over column `x` with matplotlib; returns the axes."""
        return draw(ax, x, y, [(self.law, self.column(x).ravel(), self.column(y).ravel(), None, None)])

    def __repr__(self) -> str:
        missing = f"\n{len(self.reasons)} without a state: see reasons" if self.reasons else ""
        return f"<fstiff.Points of {self.law}: {count_of(self)}>\n{text_table(shown_rows(self, 6))}{missing}"


#: The numbers of a contact that are not of its surface.
OF_BODIES = ("effective_modulus", "poisson_ratio", "yield_strength", "hardness", "interaction_length")


class Contact(Shown):
    """A contact with one law, of plain numbers in SI units or of a measured surface. A quantity may be a text such as "0.8 um" or have units.

    law                 one of law_names()
    surface             what measure() returned, or takes without options, in place of the numbers of the surface; laws that need a map take its heights
    effective_modulus   of both bodies [Pa]; effective_modulus() computes it
    {numbers}
    poisson_ratio, yield_strength, hardness   of the softer body [1, Pa, Pa], for the plastic laws, which name what they need
    interaction         "none", "effective_separation" or "as_printed", over interaction_length [m]

    r and theta are given for a law that takes them; r = 0 means that heights and curvatures are independent. "hybrid" and
    "persson" need no peaks with rms_gradient: alpha, H and they are then the middle of what a scene assumes.
    A number that is wrong or missing raises ValueError. Threads may share a contact; evaluations do not hold the GIL.
    """

    _core: _core.Contact
    _recipe: tuple[Callable[..., Contact], tuple[Any, ...]]

    def __init__(
        self,
        law: str,
        *,
        effective_modulus: float,
        surface: Measurable | None = None,
        poisson_ratio: float | None = None,
        yield_strength: float | None = None,
        hardness: float | None = None,
        interaction: Literal["none", "effective_separation", "as_printed"] = "none",
        interaction_length: Length | None = None,
        **numbers_of_face: Any,
    ) -> None:
        require_known(numbers_of_face, tuple(FACE))
        values = {name: value for name, value in locals().items() if name in OF_BODIES} | numbers_of_face
        values = {name: value for name, value in values.items() if value is not None or name == "effective_modulus"}
        ways = {"mean_height": "rms_height", "profile_gradient": "rms_gradient", "profile_spacing": "rms_gradient"}
        known = [ways.get(main, main) for main in (FACE[name][2] for name in values if name in FACE)]
        if surface is not None and known:
            raise ValueError(f"{known[0]}: must not be given with surface, which has it")
        follow = ("peak_radius", "peak_density") if law in ("hybrid", "persson", "plastic") and "rms_gradient" in known else ()
        missing = [name for name in ("rms_height", "peak_radius", "peak_density") if name not in (*known, *follow)]
        if surface is None and missing and law in law_names():
            of_spectrum = "; hybrid, persson and plastic need rms_height and rms_gradient alone"
            raise ValueError(f"{missing[0]}: missing; a contact needs rms_height, peak_radius and peak_density, or surface{of_spectrum}")
        given = {name: number(value, name) for name, value in values.items()}
        surface = measured_of(surface)
        if surface is not None and not isinstance(surface, Measurement):
            raise ValueError(f"surface: must be what measure() returned, not of type {type(surface).__name__}")
        measured = None if surface is None else surface._measured
        self._core = _core.Contact.of_numbers(word(law, "law"), given, word(interaction, "interaction"), measured)
        self._recipe = (_remade, (law, given, interaction, surface))
        warn_of_height(given.get("rms_height", 0.0))
        if given["effective_modulus"] < 1e3:
            warnings.warn(f"effective_modulus of {shown(given['effective_modulus'])} Pa: below 1 kPa; it is in Pa", stacklevel=2)

    @property
    def law(self) -> str:
        """The name of the law."""
        return self._core.law

    @property
    def quantities(self) -> list[str]:
        """What the law gives, in the words of output.quantities of a scene."""
        return self._core.quantities

    def at_pressures(self, pressures: npt.ArrayLike, quantities: Sequence[str] | None = None) -> Points:
        """The states under nominal `pressures` [Pa], each greater than 0; arrays of any shape give arrays of that shape.

        `quantities` are some of self.quantities; None is all of them. Fewer are computed sooner.
        """
        columns, reasons = self._core.at_pressures(numbers(pressures, "pressures"), _list(quantities))
        return Points(columns, reasons, self.law)

    def at_separations(self, separations: npt.ArrayLike, quantities: Sequence[str] | None = None) -> Points:
        """The states at `separations` of the mean planes [m]; as at_pressures() else."""
        columns, reasons = self._core.at_separations(numbers(separations, "separations"), _list(quantities))
        return Points(columns, reasons, self.law)

    def tabulate(self, min_pressure: float, max_pressure: float, outside: Outside = "refuse") -> Law:
        """The contact tabulated between two pressures [Pa]: nanoseconds a point in place of microseconds.

        `outside` of the range the law refuses with ValueError, clamps to its ends, computes the exact model, or extrapolates
        smoothly, to p = K = 0 for an open contact. Of a map every law but "boundary_elements" has a table, with a
        relative_error of 1e-3 or less; of other surfaces it is 1e-7 or less.
        """
        ends = number(min_pressure, "min_pressure"), number(max_pressure, "max_pressure")
        return Law(self._core.tabulate(*ends, word(outside, "outside")))

    def sensitivity(self, pressure: float) -> dict[str, float]:
        """dK/dx [Pa/m per SI unit of x] at constant `pressure` [Pa], for "pressure" and each number that the contact was made of.

        Differences, within 1e-7 K of x dK/dx. A contact of a measured surface or of a scene raises ValueError.
        """
        make, arguments = self._recipe
        if make is not _remade or arguments[3] is not None:
            raise ValueError("sensitivity(): needs a contact of plain numbers")
        law, given, interaction, _ = arguments
        return _core.sensitivity(law, given, interaction, number(pressure, "pressure"))

    def plot(self, pressures: npt.ArrayLike = (1e5, 1e8), ax: Axes | None = None) -> Axes:
        """Draws K between the least and the greatest of `pressures` [Pa]; returns the axes."""
        import numpy as np

        p = numbers(pressures, "pressures")
        if not (p.size and p.min() > 0):
            raise ValueError("pressures: must be greater than 0")
        return self.at_pressures(np.geomspace(p.min(), p.max(), 61), ["stiffness"]).plot(ax=ax)

    def __reduce__(self) -> tuple[Callable[..., Contact], tuple[Any, ...]]:
        return self._recipe

    def __repr__(self) -> str:
        return f"<fstiff.Contact: {self.law} is {self._core.nature}>"


with_names(Contact, Contact.__init__)


def _remade(law: str, given: dict[str, Any], interaction: Any, surface: Measurement | None) -> Contact:
    return Contact(law, surface=surface, interaction=interaction, **given)


def _list(quantities: Sequence[str] | None) -> list[str] | None:
    return None if quantities is None else words(quantities, "quantities")


class Path(NamedTuple):
    """What Law.path() returns, in the shape of its steps."""

    pressure: Numbers  #: p [Pa]
    traction: Numbers  #: q, two numbers a step [Pa]
    tangent: Numbers  #: d(p, q)/d(-separation, slip), three rows a step [Pa/m], for Newton's method
    energy: float  #: stored in the tangential displacement at the end [J/m^2], in addition to Law.energy()
    after: _core.Slip  #: memory of the contact at the end; it can be pickled


class Law(Shown):
    """A tabulated law, made by Contact.tabulate() or Law.from_text(): p, K and their slopes in nanoseconds.

    Every method takes a number or an array and returns the like; `out`, an array for each result, is filled in place of a new
    one. An argument outside of the range raises ValueError unless
    the law goes on there (`outside`). A law can be pickled, but for one that goes on with the exact model.

    pressures, separations   the least and the greatest of the table [Pa, m]
    touch                    the separation of first touch [m]: the approach under p is touch - separation(p)
    relative_error           the largest of the table, measured when it was made
    stiffness_is_slope       whether K is the slope -dp/dd of the returned p; tangent_at_separation() returns that slope for every law
    outside                  what the law does outside of its range
    """

    def __init__(self, made: _core.Law) -> None:
        self._core = made
        self.pressures, self.separations, self.touch = made.pressures, made.separations, made.touch
        self.relative_error, self.stiffness_is_slope, self.outside = made.relative_error, made.stiffness_is_slope, made.outside

    @classmethod
    def from_text(cls, text: str) -> Law:
        """The law that to_text() wrote, here or in another language, bit for bit."""
        return cls(_core.Law.from_text(word(text, "text")))

    def to_text(self) -> str:
        """The law as text, for files and for other programs."""
        return self._core.to_text()

    @overload
    def stiffness(self, pressure: float) -> float: ...
    @overload
    def stiffness(self, pressure: npt.ArrayLike, out: Numbers | None = ...) -> Numbers: ...
    def stiffness(self, pressure: npt.ArrayLike, out: Numbers | None = None) -> Numbers | float:
        """K per area [Pa/m] at the pressure [Pa]."""
        return _evaluated(self._core.stiffness, pressure, "pressure", None if out is None else (out,))[0]

    @overload
    def separation(self, pressure: float) -> float: ...
    @overload
    def separation(self, pressure: npt.ArrayLike, out: Numbers | None = ...) -> Numbers: ...
    def separation(self, pressure: npt.ArrayLike, out: Numbers | None = None) -> Numbers | float:
        """Separation of the mean planes [m] at the pressure [Pa]."""
        return _evaluated(self._core.separation, pressure, "pressure", None if out is None else (out,))[0]

    @overload
    def stiffness_slope(self, pressure: float) -> float: ...
    @overload
    def stiffness_slope(self, pressure: npt.ArrayLike, out: Numbers | None = ...) -> Numbers: ...
    def stiffness_slope(self, pressure: npt.ArrayLike, out: Numbers | None = None) -> Numbers | float:
        """dK/dp [1/m] at the pressure [Pa]."""
        return _evaluated(self._core.stiffness_slope, pressure, "pressure", None if out is None else (out,))[0]

    @overload
    def at_separation(self, separation: float) -> tuple[float, float]: ...
    @overload
    def at_separation(self, separation: npt.ArrayLike, out: tuple[Numbers, Numbers] | None = ...) -> tuple[Numbers, Numbers]: ...
    def at_separation(
        self, separation: npt.ArrayLike, out: tuple[Numbers, Numbers] | None = None
    ) -> tuple[Numbers | float, Numbers | float]:
        """p [Pa] and K per area [Pa/m] at the separation [m]."""
        pressure, stiffness = _evaluated(self._core.at_separation, separation, "separation", out)
        return pressure, stiffness

    @overload
    def tangent_at_separation(self, separation: float) -> tuple[float, float]: ...
    @overload
    def tangent_at_separation(self, separation: npt.ArrayLike, out: tuple[Numbers, Numbers] | None = ...) -> tuple[Numbers, Numbers]: ...
    def tangent_at_separation(
        self, separation: npt.ArrayLike, out: tuple[Numbers, Numbers] | None = None
    ) -> tuple[Numbers | float, Numbers | float]:
        """p [Pa] and -dp/dd [Pa/m] at the separation [m]: what Newton's method needs."""
        pressure, slope = _evaluated(self._core.tangent_at_separation, separation, "separation", out)
        return pressure, slope

    def energy(self, separation: npt.ArrayLike) -> Numbers | float:
        """Energy per nominal area that the contact stores at the separation [J/m^2], from [m]."""
        return _evaluated(self._core.energy, separation, "separation", None)[0]

    def first_slip(
        self, separation: npt.ArrayLike, slip: npt.ArrayLike, *, friction: float, ratio: float
    ) -> tuple[Numbers, Numbers]:
        """Traction q [Pa] and dq/ds [Pa/m] at a first tangential displacement `slip` [m], at the separation [m].

        `friction` is the coefficient of friction, `ratio` is K_t/K_n: tangential_ratio(). Arrays are broadcast. Of elastic laws.
        """
        return self._slipped(self._core.first_slip, separation, slip, friction, ratio)

    def cycle(
        self, separation: npt.ArrayLike, amplitude: npt.ArrayLike, *, friction: float, ratio: float
    ) -> tuple[Numbers, Numbers]:
        """Loss [J/m^2] and loss factor of a cycle of tangential displacements between -`amplitude` and `amplitude` [m]; as first_slip() else."""
        return self._slipped(self._core.cycle, separation, amplitude, friction, ratio)

    def path(
        self, separation: npt.ArrayLike, slip: npt.ArrayLike, *, friction: float, ratio: float, before: _core.Slip | None = None
    ) -> Path:
        """State after each of a sequence of straight steps, to a separation and by a tangential `slip`, two numbers [m]; as first_slip() else.

        `before` is the `after` of an earlier path, on which this one goes on; without it nothing has slipped at the first separation.
        """
        import numpy as np

        slips = numbers(slip, "slip")
        if not (slips.ndim and slips.shape[-1] == 2):
            raise ValueError(f"slip: must have two numbers for each step, not the shape {slips.shape}")
        d = numbers(separation, "separation")
        steps = np.broadcast_shapes(d.shape, slips.shape[:-1])
        d = np.ascontiguousarray(np.broadcast_to(d, steps))
        if before is None:
            before = _core.Slip(d.flat[0] if d.size else 0.0)
        of = (number(friction, "friction"), number(ratio, "ratio"))
        p, q, tangent, after = self._core.path(*of, before, d, np.ascontiguousarray(np.broadcast_to(slips, (*steps, 2))))
        energy = self._core.stored_energy(*of, after)
        return Path(p.reshape(steps), q.reshape(*steps, 2), tangent.reshape(*steps, 3, 3), energy, after)

    def _slipped(
        self, call: Callable[..., Sequence[Numbers]], separation: npt.ArrayLike, slip: npt.ArrayLike, friction: float, ratio: float
    ) -> tuple[Numbers, Numbers]:
        import numpy as np

        both = np.broadcast_arrays(numbers(separation, "separation"), numbers(slip, "slip"))
        first, second = call(number(friction, "friction"), number(ratio, "ratio"), *(np.ascontiguousarray(one) for one in both))
        return first.reshape(both[0].shape), second.reshape(both[0].shape)

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws K over the pressures of the table; returns the axes."""
        import numpy as np

        p = np.geomspace(*self.pressures, 201)[1:-1]
        return draw(ax, "pressure_Pa", "stiffness_Pa_per_m", [("", p, self.stiffness(p), None, None)])

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Law) and self.to_text() == other.to_text()

    def __hash__(self) -> int:
        return hash(self.to_text())

    def __reduce__(self) -> tuple[Callable[[str], Law], tuple[str]]:
        return Law.from_text, (self.to_text(),)

    def __repr__(self) -> str:
        low, high = (with_unit(p, "Pa") for p in self.pressures)
        return f"<fstiff.Law of {low} to {high}, relative error {shown(self.relative_error, 2)}, outside: {self.outside}>"


def _evaluated(
    call: Callable[[Numbers, list[Numbers]], Sequence[Numbers]], argument: npt.ArrayLike, name: str, out: Sequence[Numbers] | None
) -> Sequence[Numbers | float]:
    """What `call` returns, in new arrays or in those of the caller; of a number, numbers."""
    import numpy as np

    values = numbers(argument, name)
    if out is None:
        return [made if made.ndim else float(made) for made in call(values, [])]
    if any(np.may_share_memory(one, other) for i, one in enumerate(out) for other in out[:i]):
        raise ValueError("out: must be arrays that share no memory, one for each result")
    for one in out:
        if not (isinstance(one, np.ndarray) and one.dtype == np.float64 and one.flags.carray and one.shape == values.shape):
            raise ValueError(f"out: must be a writeable C-contiguous array of float64 with the shape {values.shape}")
        if np.may_share_memory(one, values):
            values = values.copy()
    call(values, list(out))
    return list(out)


def hybrid(surface: Source, pressures: npt.ArrayLike, *, effective_modulus: float, **options: Any) -> Points:
    """K of a measured surface by the law "hybrid", the one to begin with (docs/validation.md).

    `surface` is a Measurement, or what measure() takes with `options`; `pressures` [Pa], `effective_modulus` [Pa].
    """
    measured = surface if isinstance(surface, Measurement) and not options else measure(surface, **options)
    return Contact("hybrid", surface=measured, effective_modulus=effective_modulus).at_pressures(pressures)
