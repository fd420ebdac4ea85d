# SPDX-License-Identifier: BSD-3-Clause
"""The answer of a joint, or of many: one stiffness for each pressure, with a band."""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Union

from . import _core
from ._answer import Answer
from ._errors import word, words
from ._numbers import BODY, FACE, require_known, with_names
from ._results import number, numbers, whole
from ._surfaces import Measurement, measured_of

if TYPE_CHECKING:
    import numpy.typing as npt
    from typing_extensions import TypeAlias

    from ._results import Numbers

    Solid: TypeAlias = Union[str, Mapping[str, float]]
    from ._surfaces import Measurable

    Face: TypeAlias = Union[Mapping[str, Any], Measurable]

def _solid(given: Solid, which: str) -> tuple[str, dict[str, float]]:
    if isinstance(given, str) and given:
        return word(given, which), {}
    if not isinstance(given, Mapping):
        found = "an empty text" if given == "" else f"of type {type(given).__name__}"
        raise ValueError(f"{which}: must be the name of a material or a dict, not {found}")
    of = dict(given)
    name = word(of.pop("name", ""), f"{which}.name")
    require_known(of, ("name", *BODY), f"{which}.")
    made = {key: number(value, f"{which}.{key}") for key, value in of.items() if value is not None}
    for key in ("youngs_modulus", "poisson_ratio"):
        if not name and key not in made:
            raise ValueError(f"{which}.{key}: is missing; give it, or the name of a material")
    return name, made


def _of_face(value: Any, name: str) -> Numbers:
    """A number of a face, or what is true or false of it."""
    import numpy as np

    if name in ("worn", "whole") and np.asarray(value).dtype.kind == "b":
        value = np.asarray(value, dtype=np.int8)
    return numbers(value, name)


def _face(
    given: Mapping[str, Numbers], measured: list[Measurement], process: str | None, shape: tuple[int, ...]
) -> _core.Face:
    import numpy as np

    columns = {
        name: np.ascontiguousarray(np.broadcast_to(values, shape), dtype=np.float64).ravel() for name, values in given.items()
    }
    return _core.Face(columns, process or "", [one._measured for one in measured])


def _of_joints(found: dict[str, Any], p: Numbers, joints: tuple[int, ...], area: float | None) -> Answer:
    import numpy as np

    shape = joints + p.shape

    def shaped(column: Any) -> npt.NDArray[Any]:
        array: npt.NDArray[Any] = np.asarray(column).reshape(shape)
        return array

    columns = {key: shaped(column) for key, column in found["numbers"].items()}
    causes = {key[7:]: column for key, column in columns.items() if key.startswith("causes/")}
    values = {key: column for key, column in columns.items() if not key.startswith("causes/")}
    values.setdefault("pressure_Pa", np.broadcast_to(p, shape).copy())
    for end in ("", "_p05", "_p95"):  # which are missing where no point has K
        K = values.setdefault(f"stiffness{end}_Pa_per_m", np.full(shape, np.nan))
        if area is not None:
            values[f"stiffness{end}_N_per_m"] = area * K
    values["law"] = shaped(found["laws"])
    reasons = {tuple(int(i) for i in np.unravel_index(place, shape)): reason for place, reason in found["reasons"].items()}
    of_laws = {
        "points": found["of_laws"]["points"],
        "facts": {key: column.reshape(joints) for key, column in found["of_laws"]["facts"].items()},
    }
    return Answer(values, causes, of_laws, np.asarray(found["doubtful"]).reshape(joints), reasons, found["concerns"])


def answer(
    *,
    pressures: npt.ArrayLike,
    upper: Solid = "steel",
    lower: Solid | None = None,
    surface: Measurable | None = None,
    process: str | None = None,
    other: Face | None = None,
    nominal_area: float | None = None,
    flatness: float | None = None,
    aspect_ratio: float | None = None,
    greatest_pressure: float | None = None,
    quantities: Sequence[str] = (),
    frequency: float | None = None,
    film_stiffness: float | None = None,
    friction: float | None = None,
    amplitude: float | None = None,
    seating: float | None = 1e3,
    samples: int = 400,
    seed: int = 2014,
    **numbers_of_face: Any,
) -> Answer:
    """One stiffness for each pressure, by the law that holds there, with a 90 % band and its causes: what `fstiff run` answers.

    pressures           nominal [Pa], an array of any shape, of texts such as "10 MPa" or of quantities with units, as every argument
    upper, lower        a material by its name, or a dict of youngs_modulus [Pa], poisson_ratio, yield_strength, hardness [Pa],
                        density, velocity, shear_velocity, thermal_conductivity, electrical_conductivity, and name for the rest;
                        lower is as upper unless it is given
    surface             what measure() returned, or takes without options, or a list of that, one for each joint
    {numbers}
    process             what made the face, such as "ground" or "grinding": it decides what is assumed of the numbers that are not given
    other               the other face where it is rough: a dict of the numbers above, or what measure() returned
    nominal_area        [m^2]
    flatness            height of the gap between both faces in touch, before load, over the nominal area [m]; K is that of the joint then
    aspect_ratio        of the nominal area, long side over short side
    greatest_pressure   nominal, of any earlier load [Pa]
    quantities          words of output.quantities in docs/scene.md, such as "reflection", which needs a frequency [Hz]; those of
                        friction need its coefficient and an amplitude [m]
    film_stiffness      of a fluid film, which longitudinal waves see in addition to K [Pa/m]: bulk modulus over thickness
    seating             the approach is 0 at this pressure [Pa]; None: no approach, which takes six times as long as K without a band
    samples, seed       surfaces drawn for the band; 0: none

    The numbers of a face may be arrays, which are broadcast: one joint for each element, in the leading axes of the result. NaN is a number that is
    not given; a joint that needs it has no K, and a reason. A number that is given takes the place of what was measured. What is wrong raises
    ValueError. One pressure on a joint of numbers takes some 1.5 ms, 0.2 ms with samples=0 and seating=None; loops over pressures take
    law_at() of the result. The GIL is not held: two threads are twice as fast.
    """
    import numpy as np

    require_known(numbers_of_face, tuple(FACE))
    own = {name: _of_face(value, name) for name, value in numbers_of_face.items() if value is not None}
    several = isinstance(surface, (list, tuple))
    given_surfaces: Any = surface if several else [] if surface is None else [surface]
    measured = [measured_of(one) for one in given_surfaces]
    rough: Any = measured_of(other)
    if not (rough is None or isinstance(rough, (Measurement, Mapping))):
        raise ValueError(f"other: must be a dict of numbers, or what measure() takes, not of type {type(rough).__name__}")
    of_other: dict[str, Any] = {} if rough is None or isinstance(rough, Measurement) else dict(rough)
    other_process = of_other.pop("process", None)
    other_measured = [rough] if isinstance(rough, Measurement) else []
    require_known(of_other, ("process", *FACE), "other.")
    for one in measured:
        if not isinstance(one, Measurement):
            raise ValueError(f"surface: must be what measure() returned, not of type {type(one).__name__}")
    of_other = {name: _of_face(value, name) for name, value in of_other.items()}
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
    given = {"nominal_area": nominal_area, "flatness": flatness, "aspect_ratio": aspect_ratio, "greatest_pressure": greatest_pressure, "frequency": frequency, "film_stiffness": film_stiffness, "friction": friction}
    given |= {"amplitude": amplitude, "seating": seating, "samples": whole(samples, "samples", 0, 100000), "seed": whole(seed, "seed", 0, 2**53)}
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
    return _of_joints(found, p, surfaces, options.get("nominal_area"))


with_names(answer, answer)
