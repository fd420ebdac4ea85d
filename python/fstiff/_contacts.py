# SPDX-License-Identifier: BSD-3-Clause
"""Contacts and tabulated laws."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, overload

from . import _core
from ._errors import word, words
from ._numbers import FACE, require_known, with_names
from ._results import Columns, Shown, count_of, draw, frame, number, numbers, shown, shown_rows, text_table, whole, with_unit
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
    """Conductance of heat [W/(m^2 K)] or current [S/m^2] of the contacts of two faces of `stiffness` [Pa/m], by the analogy of Barber (2003).

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
    peak_heights        of "greenwood_williamson", in place of Gaussian ones: of measured peaks over the mean plane [m]
    peak_skewness, peak_kurtosis   or of these two numbers, about rms_height and the mean plane
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
        peak_heights: npt.ArrayLike | None = None,
        peak_skewness: float | None = None,
        peak_kurtosis: float | None = None,
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
        heights = _heights_of_peaks(peak_heights, peak_skewness, peak_kurtosis)
        self._core = _core.Contact.of_numbers(word(law, "law"), given, word(interaction, "interaction"), measured, *heights)
        self._recipe = (_remade, (law, given, interaction, surface, peak_heights, peak_skewness, peak_kurtosis))
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

    def law_after(
        self, greatest_pressure: npt.ArrayLike, min_pressure: float, max_pressure: float, outside: Outside = "refuse"
    ) -> Law | Laws:
        """The law of the contact once it has carried `greatest_pressure` [Pa]: reversible below it, along the first loading above.

        Of an array one law for each pressure, as Laws. What yielded stays flat, so that friction takes the law; an elastic contact has
        the law of tabulate(). They share the separations of tabulate(), by which the contact was loaded. `outside` is any but "exact".
        """
        ends = number(min_pressure, "min_pressure"), number(max_pressure, "max_pressure")
        made = self._core.laws_after(pressures_before(greatest_pressure), *ends, word(outside, "outside"))
        return laws_of(made, greatest_pressure)

    def sensitivity(self, pressure: float) -> dict[str, float]:
        """dK/dx [Pa/m per SI unit of x] at constant `pressure` [Pa], for "pressure" and each number that the contact was made of.

        Differences, within 1e-7 K of x dK/dx. A contact of a measured surface or of a scene raises ValueError.
        """
        make, arguments = self._recipe
        if make is not _remade or arguments[3] is not None:
            raise ValueError("sensitivity(): needs a contact of plain numbers")
        law, given, interaction, _, *heights = arguments
        if any(one is not None for one in heights):
            raise ValueError("sensitivity(): needs a contact of Gaussian peaks")
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


def _remade(law: str, given: dict[str, Any], interaction: Any, surface: Measurement | None, heights: Any, skewness: Any, kurtosis: Any) -> Contact:
    shape = {"peak_heights": heights, "peak_skewness": skewness, "peak_kurtosis": kurtosis}
    return Contact(law, surface=surface, interaction=interaction, **shape, **given)


def _heights_of_peaks(heights: npt.ArrayLike | None, skewness: float | None, kurtosis: float | None) -> tuple[list[float], bool]:
    """Heights of peaks, or their skewness and kurtosis and True."""
    if (skewness is None) != (kurtosis is None):
        raise ValueError(f"{'peak_skewness' if skewness is None else 'peak_kurtosis'}: missing; peak_skewness and peak_kurtosis belong together")
    if heights is not None and skewness is not None:
        raise ValueError("peak_heights: must not be given with peak_skewness, which is that of theirs")
    if skewness is not None:
        return [number(skewness, "peak_skewness"), number(kurtosis, "peak_kurtosis")], True
    if heights is None:
        return [], False
    given = numbers(heights, "peak_heights")
    if given.ndim != 1 or not given.size:
        raise ValueError(f"peak_heights: must be an array of one axis, not of the shape {given.shape}")
    return [float(one) for one in given], False


def _list(quantities: Sequence[str] | None) -> list[str] | None:
    return None if quantities is None else words(quantities, "quantities")


class Path(NamedTuple):
    """What path() returns, in the shape of its steps; of contacts with an area in N and N/m."""

    pressure: Numbers  #: p [Pa]
    traction: Numbers  #: q, two numbers a step [Pa]
    tangent: Numbers  #: d(p, q)/d(-separation, slip), three rows a step [Pa/m]: of that step alone, without those before it
    by_directions: Numbers  #: d(p, q) by each of `directions`, three rows a step: of all steps, exact where something slips too
    energy: Any  #: stored in the tangential displacement at the end [J/m^2], in addition to energy(); of each contact
    after: Any  #: memory of the contact at the end, of many a list; it can be pickled


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
        self, separation: npt.ArrayLike, slip: npt.ArrayLike, *, friction: npt.ArrayLike, ratio: npt.ArrayLike
    ) -> tuple[Numbers, Numbers]:
        """Traction q [Pa] and dq/ds [Pa/m] at a first tangential displacement `slip` [m], at the separation [m].

        `friction` is the coefficient of friction, `ratio` is K_t/K_n: tangential_ratio(). Arrays are broadcast. Of elastic laws,
        and of law_after().
        """
        return _slipped(_core.first_slip, [self], separation, slip, friction, ratio)

    def cycle(
        self, separation: npt.ArrayLike, amplitude: npt.ArrayLike, *, friction: npt.ArrayLike, ratio: npt.ArrayLike
    ) -> tuple[Numbers, Numbers]:
        """Loss [J/m^2] and loss factor of a cycle of tangential displacements between -`amplitude` and `amplitude` [m]; as first_slip() else."""
        return _slipped(_core.slip_cycle, [self], separation, amplitude, friction, ratio)

    def path(self, separation: npt.ArrayLike, slip: npt.ArrayLike, **options: Any) -> Path:
        """State after each of a sequence of straight steps, to a separation and by a tangential `slip`, two numbers [m].

        The last axis of `separation` is of the steps; those before it are contacts with this law. slip has two numbers more.

        friction, ratio   as first_slip() takes them; of many contacts numbers, or one for each
        preload     [Pa]; `separation` then counts from that under it, which opens by it
        area        of each contact [m^2]: forces and their tangents in place of those per area
        directions  d(-separation, slip) of each step by numbers that the whole motion depends on, such as amplitudes of harmonics: of
                    the shape (..., steps, 3, numbers), for all contacts alike or for each. They begin with the first step
        before      the `after` of an earlier path, on which this one goes on; without it nothing has slipped at the first separation
        threads     of many contacts
        """
        return _paths([self], separation, slip, **options)

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


class Laws(Shown):
    """Laws of many contacts, as law_after() returns them: a sequence of Law, evaluated at once.

    The first axis of every argument is of the contacts, one law each; else the methods are those of Law.
    """

    def __init__(self, laws: Iterable[Law]) -> None:
        self._laws = list(laws)
        if not (self._laws and all(isinstance(law, Law) for law in self._laws)):
            raise ValueError("laws: must be laws, at least one")

    def __len__(self) -> int:
        return len(self._laws)

    def __getitem__(self, index: int) -> Law:
        return self._laws[index]

    @property
    def touch(self) -> Numbers:
        """The separation of first touch of each [m]."""
        import numpy as np

        return np.array([law.touch for law in self._laws])

    def separation(self, pressure: npt.ArrayLike) -> Numbers:
        """Separation of the mean planes [m] at the pressure [Pa]."""
        return self._rows("separation", pressure, "pressure")[0]

    def stiffness(self, pressure: npt.ArrayLike) -> Numbers:
        """K per area [Pa/m] at the pressure [Pa]."""
        return self._rows("stiffness", pressure, "pressure")[0]

    def energy(self, separation: npt.ArrayLike) -> Numbers:
        """Energy per nominal area that each contact stores at the separation [J/m^2], from [m]."""
        return self._rows("energy", separation, "separation")[0]

    def tangent_at_separation(self, separation: npt.ArrayLike) -> tuple[Numbers, Numbers]:
        """p [Pa] and -dp/dd [Pa/m] at the separation [m]: what Newton's method needs."""
        pressure, slope = self._rows("tangent", separation, "separation")
        return pressure, slope

    def first_slip(
        self, separation: npt.ArrayLike, slip: npt.ArrayLike, *, friction: npt.ArrayLike, ratio: npt.ArrayLike
    ) -> tuple[Numbers, Numbers]:
        """As Law.first_slip()."""
        return _slipped(_core.first_slip, self._laws, separation, slip, friction, ratio)

    def cycle(
        self, separation: npt.ArrayLike, amplitude: npt.ArrayLike, *, friction: npt.ArrayLike, ratio: npt.ArrayLike
    ) -> tuple[Numbers, Numbers]:
        """As Law.cycle()."""
        return _slipped(_core.slip_cycle, self._laws, separation, amplitude, friction, ratio)

    def path(self, separation: npt.ArrayLike, slip: npt.ArrayLike, **options: Any) -> Path:
        """As Law.path(), of the shape (contacts, steps)."""
        return _paths(self._laws, separation, slip, **options)

    def _rows(self, what: str, argument: npt.ArrayLike, name: str) -> list[Numbers]:
        values = numbers(argument, name)
        if values.shape[:1] != (len(self),):
            raise ValueError(f"{name}: must have {len(self)} rows, one for each law, not the shape {values.shape}")
        return _core.law_rows([law._core for law in self._laws], what, values)

    def __repr__(self) -> str:
        return f"<fstiff.Laws: {len(self)}>"


def laws_of(made: list[_core.Law], greatest: npt.ArrayLike) -> Law | Laws:
    """Those after `greatest`: one, or of an array of one axis one for each."""
    laws = [Law(one) for one in made]
    return Laws(laws) if numbers(greatest, "greatest_pressure").ndim else laws[0]


def pressures_before(greatest_pressure: npt.ArrayLike) -> list[float]:
    values = numbers(greatest_pressure, "greatest_pressure")
    if values.ndim > 1 or not values.size:
        raise ValueError(f"greatest_pressure: must be one pressure or an array of one axis, not of the shape {values.shape}")
    return [float(p) for p in values.ravel()]


def _of_contacts(values: npt.ArrayLike, name: str, contacts: int) -> Numbers:
    """One number, or one for each contact."""
    import numpy as np

    given = numbers(values, name)
    if given.ndim > 1 or given.size not in (1, contacts):
        raise ValueError(f"{name}: must be one number or {contacts}, one for each contact, not of the shape {given.shape}")
    return np.ascontiguousarray(given.ravel())


def _slipped(
    call: Callable[..., Sequence[Numbers]],
    laws: list[Law],
    separation: npt.ArrayLike,
    slip: npt.ArrayLike,
    friction: npt.ArrayLike,
    ratio: npt.ArrayLike,
) -> tuple[Numbers, Numbers]:
    import numpy as np

    both = np.broadcast_arrays(numbers(separation, "separation"), numbers(slip, "slip"))
    shape = both[0].shape
    several = max(len(laws), *(numbers(values, name).size for values, name in ((friction, "friction"), (ratio, "ratio"))))
    if several > 1 and shape[:1] != (several,):
        raise ValueError(f"separation: must have {several} rows, one for each contact, not the shape {shape}")
    of = (_of_contacts(friction, "friction", several), _of_contacts(ratio, "ratio", several))
    first, second = call([law._core for law in laws], *of, *(np.ascontiguousarray(one) for one in both))
    return first.reshape(shape), second.reshape(shape)


def _paths(
    laws: list[Law],
    separation: npt.ArrayLike,
    slip: npt.ArrayLike,
    *,
    friction: npt.ArrayLike,
    ratio: npt.ArrayLike,
    preload: npt.ArrayLike | None = None,
    area: npt.ArrayLike = 1.0,
    directions: npt.ArrayLike | None = None,
    before: Any = None,
    threads: int = 1,
) -> Path:
    import numpy as np

    slips, d = numbers(slip, "slip"), numbers(separation, "separation")
    if not (slips.ndim and slips.shape[-1] == 2):
        raise ValueError(f"slip: must have two numbers for each step, not the shape {slips.shape}")
    try:
        given_shape = np.broadcast_shapes(d.shape, slips.shape[:-1])
    except ValueError:
        raise ValueError(f"slip: its shape {slips.shape} does not go with the shape {d.shape} of separation") from None
    shape = given_shape or (1,)
    leading, steps = shape[:-1], shape[-1]
    contacts = int(np.prod(leading, dtype=int))
    if len(laws) not in (1, contacts):
        raise ValueError(f"separation: must be of {len(laws)} contacts, one for each law, not of the shape {shape}")
    cores = [law._core for law in laws]
    d = np.broadcast_to(d, shape).reshape(contacts, steps)
    if preload is not None:
        pressures = np.resize(_of_contacts(preload, "preload", contacts), contacts)
        d = d + _core.law_rows(cores, "separation", pressures)[0][:, None]
    d = np.ascontiguousarray(d)
    given = np.zeros((steps, 3, 0)) if directions is None else numbers(directions, "directions")
    of_each = given.ndim > 3
    rows_of = (*(leading if of_each else ()), steps, 3)
    if given.ndim < 3 or given.shape[:-1] != rows_of:
        raise ValueError(f"directions: must be of the shape {(*rows_of, 'numbers')}, not {given.shape}")
    if before is None:
        before = [_core.Slip(float(row[0]) if steps else 0.0) for row in d]
    elif isinstance(before, _core.Slip):
        before = [before]
    if len(before) != contacts:
        raise ValueError(f"before: must be of {contacts} contacts, as separation, not of {len(before)}")
    of = (_of_contacts(friction, "friction", contacts), _of_contacts(ratio, "ratio", contacts))
    s = np.ascontiguousarray(np.broadcast_to(slips, (*shape, 2)))
    p, q, tangent, by, energy, after = _core.slip_paths(
        cores, *of, contacts, list(before), d, s, np.ascontiguousarray(given), given.shape[-1], whole(threads, "threads", 1, 1024)
    )
    areas = _of_contacts(area, "area", contacts)
    rows = areas.reshape(-1, 1) if np.any(areas != 1) else None

    def shaped(values: Numbers, *more: int) -> Numbers:
        if rows is not None:
            of_contact = values.reshape(contacts, -1)
            of_contact *= rows
        return values.reshape((*given_shape, *more))

    numbers_of = given.shape[-1]
    total = energy * np.resize(areas, contacts)
    return Path(
        shaped(p),
        shaped(q, 2),
        shaped(tangent, 3, 3),
        shaped(by, 3, numbers_of),
        total.reshape(leading) if leading else float(total[0]),
        after if leading else after[0],
    )


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
