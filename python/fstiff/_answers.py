# SPDX-License-Identifier: BSD-3-Clause
"""The answer of a joint, or of many: one stiffness for each pressure, with a band."""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Union

from . import _core
from ._errors import word, words
from ._contacts import Law
from ._results import Columns, count_of, draw, frame, heading, lines_of, number, numbers, shown, shown_rows, text_table, whole
from ._surfaces import Measurement, measured_of

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
    import pandas as pd
    from matplotlib.axes import Axes
    from typing_extensions import TypeAlias

    from ._contacts import Outside
    from ._results import Numbers

    Solid: TypeAlias = Union[str, Mapping[str, float]]
    from ._surfaces import Measurable

    Face: TypeAlias = Union[Mapping[str, Any], Measurable]

#: The numbers of a face.
FACE = (
    "height", "mean_height", "gradient", "profile_gradient", "profile_spacing", "alpha", "hurst", "skewness", "kurtosis",
    "peak_radius", "peak_density", "fractal_dimension",
)  # fmt: skip
KEYS = ("pressure_Pa", "stiffness_Pa_per_m", "stiffness_p05_Pa_per_m", "stiffness_p95_Pa_per_m")
SOLID = (
    "youngs_modulus", "poisson_ratio", "yield_strength", "hardness", "density", "velocity", "shear_velocity",
    "thermal_conductivity", "electrical_conductivity",
)  # fmt: skip


class Stiffness(Columns):
    """K of one joint or of many: a mapping from keys of `fstiff run --format json` to arrays, of the surfaces by the pressures.

    "pressure_Pa", "stiffness_Pa_per_m", the ends of its 90 % band "stiffness_p05_Pa_per_m" and "stiffness_p95_Pa_per_m", "law",
    "p_star", "contacts", "approach_m", "loading_stiffness_Pa_per_m" and the quantities that were asked for; NaN and "" where
    there is none. A single surface has arrays of the shape of the pressures.

    causes     the share that each cause has of the band, by its name
    reasons    why a point has no K, by its index
    concerns   words for what does not hold, a list for each surface
    doubtful   for each surface, whether the command would end with exit code 4
    """

    def __init__(self, found: dict[str, Any], p: Numbers, surfaces: tuple[int, ...], area: float | None) -> None:
        import numpy as np

        shape = surfaces + p.shape

        def shaped(column: Any) -> npt.NDArray[Any]:
            array: npt.NDArray[Any] = np.asarray(column).reshape(shape)
            return array

        columns = {key: shaped(column) for key, column in found["numbers"].items()}
        self.causes = {key[7:]: column for key, column in columns.items() if key.startswith("causes/")}
        self._values = {key: column for key, column in columns.items() if not key.startswith("causes/")}
        self._values.setdefault("pressure_Pa", np.broadcast_to(p, shape).copy())
        for end in ("", "_p05", "_p95"):  # which are missing where no point has K
            K = self._values.setdefault(f"stiffness{end}_Pa_per_m", np.full(shape, np.nan))
            if area is not None:
                self._values[f"stiffness{end}_N_per_m"] = area * K
        self._values["law"] = shaped(found["laws"])
        self.reasons: dict[tuple[int, ...], str] = {
            tuple(int(i) for i in np.unravel_index(place, shape)): reason for place, reason in found["reasons"].items()
        }
        self.concerns: list[list[str]] = found["concerns"]
        self.doubtful: npt.NDArray[np.bool_] = np.asarray(found["doubtful"], dtype=bool).reshape(surfaces)
        self._rms_heights = np.asarray(found["rms_heights"], dtype=np.float64).reshape(surfaces)

    @property
    def low(self) -> Numbers:
        """The lower end of the 90 % band of K [Pa/m]."""
        return self["stiffness_p05_Pa_per_m"]

    @property
    def high(self) -> Numbers:
        """The upper end of the 90 % band of K [Pa/m]."""
        return self["stiffness_p95_Pa_per_m"]

    def law_at(
        self,
        quantile: float = 0.5,
        min_pressure: float | None = None,
        max_pressure: float | None = None,
        *,
        joint: int | tuple[int, ...] = (),
        outside: Outside = "refuse",
    ) -> Law:
        """The law of K between the pressures, some ten a decade: K(p) within 1e-3 of the model, and -dp/dd = K, in nanoseconds.

        quantile       0.5, K itself, or 0.05 or 0.95, an end of its band
        min_pressure, max_pressure   the least and the greatest of the law [Pa], by default of the pressures that have a K
        joint          of many joints the index of one
        outside        of the range, as Contact.tabulate() takes it, but "exact"

        Of peaks that yield it is the law of a contact that has been closed: of vibration, and of changes about a preload. Separations
        count from that at max_pressure: only their differences are those of the joint. Fewer than two pressures with a K, another
        quantile, a greater range and a K that does not rise raise ValueError.
        """
        import numpy as np

        try:
            height = self._rms_heights[joint]
        except IndexError as error:
            raise ValueError(f"joint = {joint!r:.60}: {error}") from None
        if np.ndim(height):
            raise ValueError(f"joint: must be the index of one of the joints, whose shape is {self._rms_heights.shape}")
        shape = (*self._rms_heights.shape, -1)
        p, low, K, high = (np.ascontiguousarray(self[key].reshape(shape)[joint]) for key in (KEYS[0], KEYS[2], KEYS[1], KEYS[3]))
        known = p[~np.isnan(K)]
        least, greatest = (known.min(), known.max()) if known.size else (np.nan, np.nan)
        bounds = (
            number(least if min_pressure is None else min_pressure, "min_pressure"),
            number(greatest if max_pressure is None else max_pressure, "max_pressure"),
        )
        return Law(_core.Law.of_answer(p, low, K, high, float(height), number(quantile, "quantile"), *bounds, word(outside, "outside")))

    def to_dataframe(self) -> pd.DataFrame:
        """The columns as a data frame of pandas, one row for each surface and pressure."""
        return frame({key: column.ravel() for key, column in self.items()})

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws K over the pressure with its band, a line for each joint; returns the axes."""
        import numpy as np

        count = self.pressure.shape[-1] if self.pressure.ndim else 1
        columns = (np.reshape(self[key], (-1, count)) for key in KEYS)
        return draw(ax, *KEYS[:2], [("", *line) for line in zip(*columns)])

    def __repr__(self) -> str:
        import numpy as np

        factor = heading(KEYS[1], self[KEYS[1]])[1]
        pairs = zip(np.ravel(self.low) * factor, np.ravel(self.high) * factor)
        columns: dict[str, Any] = {key: self[key] for key in KEYS[:2]}
        columns["90 % band"] = np.array([f"{shown(low, 2)}–{shown(high, 2)}" if low == low else "-" for low, high in pairs])
        columns["law"] = self["law"]
        if self.doubtful.ndim and self.doubtful.size:
            each = self.pressure.size // self.doubtful.size
            columns = {"joint": np.repeat(np.arange(self.doubtful.size), each), **columns}
        doubts = sorted({word.replace("_", " ") for words, doubted in zip(self.concerns, self.doubtful.flat) if doubted for word in words})
        reasons = sorted(set(self.reasons.values()))[:3]
        flows = np.any(self.get("loading_stiffness_Pa_per_m", np.inf) < 0.99 * self[KEYS[1]])
        which = "\n  K is of unloading, for vibration and waves; .loading_stiffness is of the first load" if flows else ""
        return f"<fstiff.Stiffness: {count_of(self)}>\n{text_table(shown_rows(columns, 3))}{which}" + lines_of(doubts + reasons)


def _solid(given: Solid, which: str) -> tuple[str, dict[str, float]]:
    if isinstance(given, str) and given:
        return word(given, which), {}
    if not isinstance(given, Mapping):
        found = "an empty text" if given == "" else f"of type {type(given).__name__}"
        raise ValueError(f"{which}: must be the name of a material or a dict, not {found}")
    of = dict(given)
    name = word(of.pop("name", ""), f"{which}.name")
    unknown = set(of) - set(SOLID)
    if unknown:
        raise ValueError(f"{which}.{sorted(unknown)[0]}: must be one of name, {', '.join(SOLID)}")
    made = {key: number(value, f"{which}.{key}") for key, value in of.items() if value is not None}
    for key in ("youngs_modulus", "poisson_ratio"):
        if not name and key not in made:
            raise ValueError(f"{which}.{key}: is missing; give it, or the name of a material")
    return name, made


def _face(
    given: Mapping[str, Numbers], measured: list[Measurement], process: str | None, shape: tuple[int, ...]
) -> _core.Face:
    import numpy as np

    columns = {
        name: np.ascontiguousarray(np.broadcast_to(values, shape), dtype=np.float64).ravel() for name, values in given.items()
    }
    return _core.Face(columns, process or "", [one._measured for one in measured])


def answer(
    *,
    pressures: npt.ArrayLike,
    upper: Solid = "steel",
    lower: Solid | None = None,
    surface: Measurable | None = None,
    height: Any = None,
    mean_height: Any = None,
    gradient: Any = None,
    profile_gradient: Any = None,
    profile_spacing: Any = None,
    alpha: Any = None,
    hurst: Any = None,
    skewness: Any = None,
    kurtosis: Any = None,
    peak_radius: Any = None,
    peak_density: Any = None,
    fractal_dimension: Any = None,
    process: str | None = None,
    other: Face | None = None,
    area: float | None = None,
    quantities: Sequence[str] = (),
    frequency: float | None = None,
    film_stiffness: float | None = None,
    friction: float | None = None,
    amplitude: float | None = None,
    seating: float | None = 1e3,
    samples: int = 400,
    seed: int = 2014,
) -> Stiffness:
    """One stiffness for each pressure, by the law that holds there, with a 90 % band and its causes: what `fstiff run` answers.

    pressures           nominal [Pa], an array of any shape, of texts such as "10 MPa" or of quantities with units, as every argument
    upper, lower        a material by its name, or a dict of youngs_modulus [Pa], poisson_ratio, yield_strength, hardness [Pa],
                        density, velocity, shear_velocity, thermal_conductivity, electrical_conductivity, and name for the rest;
                        lower is as upper unless it is given
    surface             what measure() returned, or takes without options, or a list of that, one for each joint
    height, mean_height      rms height (Rq, Sq), or Ra or Sa in its place [m], or a text such as "0.8 um"; of Ra also "N6" or "VDI 24"
    gradient            rms gradient (Sdq); in its place profile_gradient (Rdq across the lay) or profile_spacing (RSm) [m]
    alpha, hurst, skewness, kurtosis, peak_radius, peak_density, fractal_dimension   as in a scene
    process             what made the face, such as "ground" or "grinding": it decides what is assumed of the numbers that are not given
    other               the other face where it is rough: a dict of the numbers above, or what measure() returned
    area                nominal area [m^2]
    quantities          of "tangential_stiffness", "reflection", "shear_reflection" (with a frequency [Hz]), "loss_factor" (with
                        a coefficient of friction and an amplitude [m]), "thermal_conductance", "electrical_conductance"
    film_stiffness      of a fluid film, which longitudinal waves see in addition to K [Pa/m]: bulk modulus over thickness
    seating             the approach is 0 at this pressure [Pa]; None: no approach, which takes twelve times as long as K without a band
    samples, seed       surfaces drawn for the band; 0: none

    The numbers of a face may be arrays, which are broadcast: one joint for each element, in the leading axes of the result. NaN is a number that is
    not given; a joint that needs it has no K, and a reason. A number that is given takes the place of what was measured. What is wrong raises
    ValueError. One pressure on a joint of numbers takes some 2 ms, 0.15 ms with samples=0 and seating=None; loops over pressures take
    law_at() of the result. The GIL is not held: two threads are twice as fast.
    """
    import numpy as np

    own = {name: numbers(value, name) for name, value in locals().items() if name in FACE and value is not None}
    several = isinstance(surface, (list, tuple))
    given_surfaces: Any = surface if several else [] if surface is None else [surface]
    measured = [measured_of(one) for one in given_surfaces]
    rough: Any = measured_of(other)
    if not (rough is None or isinstance(rough, (Measurement, Mapping))):
        raise ValueError(f"other: must be a dict of numbers, or what measure() takes, not of type {type(rough).__name__}")
    of_other: dict[str, Any] = {} if rough is None or isinstance(rough, Measurement) else dict(rough)
    other_process = of_other.pop("process", None)
    other_measured = [rough] if isinstance(rough, Measurement) else []
    unknown = set(of_other) - set(FACE)
    if unknown:
        raise ValueError(f"other.{sorted(unknown)[0]}: must be one of process, {', '.join(FACE)}")
    for one in measured:
        if not isinstance(one, Measurement):
            raise ValueError(f"surface: must be what measure() returned, not of type {type(one).__name__}")
    of_other = {name: numbers(value, name) for name, value in of_other.items()}
    shapes = [values.shape for of in (own, of_other) for values in of.values()]
    if several:
        shapes.append((len(measured),))
    try:
        surfaces = np.broadcast_shapes(*shapes)
    except ValueError:
        raise ValueError(f"the numbers of the faces have shapes that do not go together: {shapes}") from None
    count = int(np.prod(surfaces, dtype=int))
    if several and surfaces != (len(measured),):
        raise ValueError("surface: a list of them goes with numbers and arrays of its length")
    p = numbers(pressures, "pressures")
    given = {"area": area, "frequency": frequency, "film_stiffness": film_stiffness, "friction": friction, "amplitude": amplitude}
    given |= {"seating": seating, "samples": whole(samples, "samples", 0, 100000), "seed": whole(seed, "seed", 0, 2**53)}
    options = {name: number(value, name) for name, value in given.items() if value is not None}
    first, second = _solid(upper, "upper"), _solid(upper if lower is None else lower, "lower")
    for name, given_word in {"process": process, "other.process": other_process}.items():
        if given_word is not None:
            word(given_word, name, "one word")
    face = _face(own, measured, process, surfaces)
    face2 = None if other is None else _face(of_other, other_measured, other_process, surfaces)
    found = _core.answers(count, face, face2, *first, *second, p.ravel(), options, words(quantities, "quantities"), bool(surfaces))
    for sentence in found["units"]:
        warnings.warn(sentence + "; numbers are in SI, or texts such as \"0.8 um\"", stacklevel=2)
    return Stiffness(found, p, surfaces, options.get("area"))
