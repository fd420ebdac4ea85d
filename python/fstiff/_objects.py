# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of other packages: topographies of a reader, arrays of xarray, series and frames of pandas, known by their attributes."""

from __future__ import annotations

from typing import Any, Protocol

from . import _core
from ._units import held, in_si


#: Its name in messages, the positions of the points and their unit; None where there are none.
Axis = tuple[str, Any, Any]


class Topography(Protocol):
    """What a reader such as SurfaceTopography returns: heights, or a function that returns them, whose first axis is x; the length of
    each axis, which has as many steps as points; and `unit`, that of both."""

    @property
    def heights(self) -> Any: ...
    @property
    def physical_sizes(self) -> Any: ...


class Labelled(Protocol):
    """Heights with positions: a DataArray of xarray, or a Series or DataFrame of pandas; attrs["units"] has units."""

    @property
    def attrs(self) -> Any: ...
    def __array__(self) -> Any: ...


def is_topography(source: Any) -> bool:
    return hasattr(source, "heights") and hasattr(source, "physical_sizes")


def is_object(source: Any) -> bool:
    """Whether `source` may have positions and units of its own."""
    return is_topography(source) or (hasattr(source, "attrs") and (hasattr(source, "coords") or hasattr(source, "index")))


def grid_of(source: Any, name: str, steps: dict[str, Any], units: str | None) -> tuple[Any, float, dict[str, Any]]:
    """Heights, a map with its rows along y; their unit [m]; and the steps [m], as Surface() takes them.

    `steps` are those of an object without positions, `units` those of one without units.
    """
    import numpy as np

    parts = of_topography if is_topography(source) else of_xarray if hasattr(source, "coords") else of_pandas
    heights, axes, unit = parts(source, name)
    of_lengths, of_heights = pair(units, "units")
    own_steps: dict[str, Any] = {}
    for key, (which, positions, own) in zip(("dx", "dy"), reversed(axes)):  # x is the last
        if steps and positions is not None:
            raise ValueError(f"{next(iter(steps))}: must not be given for a surface that has its own")
        if not steps and positions is None:
            raise ValueError(f"{name}: has no {which}; must have them, or be given spacing")
        if not steps:
            step = equal_step(positions, f"{name}: {which}")
            own_steps[key] = abs(step) * metres(own, of_lengths, f"{name}: {which}")
            heights = np.flip(heights, -1 if key == "dx" else -2) if step < 0 else heights
    as_an_array = steps and unit is None and units is None  # in m
    which = name if name.startswith("heights") else f"{name}: heights"
    return heights, 1.0 if as_an_array else metres(unit, of_heights, which), steps or own_steps


def of_topography(topography: Any, name: str) -> tuple[Any, list[Axis], Any]:
    """Heights, axes and unit of the heights."""
    import numpy as np

    if not getattr(topography, "is_uniform", True):
        raise ValueError(f"{name}: its points are not equally spaced; to_uniform() of SurfaceTopography makes them so")
    heights = np.ma.asanyarray(topography.heights() if callable(topography.heights) else topography.heights).T
    sizes = np.atleast_1d(np.asarray(topography.physical_sizes, dtype=np.float64))[::-1]
    if sizes.size != heights.ndim or not (sizes > 0).all():
        raise ValueError(f"{name}: its physical_sizes are {topography.physical_sizes}; must be lengths above 0 of its {heights.ndim} axes")
    unit = getattr(topography, "unit", None)
    lengths, of_heights = unit if isinstance(unit, tuple) else (unit, unit)  # SurfaceTopography has two for what is no height
    return heights, [("sizes", (0.0, size / max(points, 1)), lengths) for size, points in zip(sizes, heights.shape)], of_heights


def of_xarray(array: Any, source: str) -> tuple[Any, list[Axis], Any]:
    """The same. Dimensions called x and y are along x and y; else the last one is x."""
    if set(array.dims) == {"x", "y"}:
        array = array.transpose("y", "x")
    names = {dim: f"positions along {dim}" for dim in array.dims}
    of = array.coords
    axes = [(name, of[dim].values, of[dim].attrs.get("units")) if dim in of else (name, None, None) for dim, name in names.items()]
    quantity = held(array)  # of pint, in the array
    return (array.values, axes, array.attrs.get("units")) if quantity is array else (in_si(quantity, source, "m"), axes, "m")


def of_pandas(data: Any, _: str) -> tuple[Any, list[Axis], Any]:
    """The same. Positions are the index, and the columns of a frame, unless they only count (a RangeIndex)."""
    import numpy as np

    lengths, of_heights = pair(data.attrs.get("units"), 'attrs["units"]')
    labels = [(which, getattr(data, which)) for which in ("index", "columns")[: data.ndim]]
    axes = [(f"positions in its {which}", None if hasattr(one, "start") else one, lengths) for which, one in labels]
    return data.to_numpy(na_value=np.nan), axes, of_heights


def pair(units: Any, name: str) -> tuple[str | None, str | None]:
    """The units of "um,nm" (lengths, heights) or "um" (both)."""
    if units is None:
        return None, None
    parts = [part.strip() for part in str(units).split(",")]
    if len(parts) > 2:
        raise ValueError(f'{name} = "{units}": must be a unit of length, or two as in "um,nm" (lengths, heights)')
    return parts[0], parts[-1]


def metres(own: Any, given: str | None, what: str) -> float:
    """The unit [m] that an object has, or that was given for one that has none."""
    if own is None and given is None:
        raise ValueError(f'{what} have no units; must be in the object, or given as units="um,nm" (lengths, heights)')
    values = []
    for unit in (one for one in (own, given) if one is not None):
        try:
            values.append(_core.parse_length(f"1 {unit}", "unit"))
        except ValueError:
            raise ValueError(f"{what} have the unit {unit}; must be a length, such as um") from None
    if values[0] != values[-1]:
        raise ValueError(f'units = "{given}": contradicts the unit {own} of {what}')
    return values[0]


def equal_step(positions: Any, name: str) -> float:
    """The step of positions that are equally spaced to within a hundredth of it; negative where they fall."""
    import numpy as np

    x = np.asarray(positions)
    if x.ndim != 1 or x.dtype.kind not in "iuf" or x.size < 2:
        way_out = "; a profile of a table is frame.set_index(POSITIONS)[HEIGHTS]" if "columns" in name else ""
        raise ValueError(f"{name} are {', '.join(map(str, x.ravel()[:3]))}: must be two numbers or more{way_out}")
    x = x.astype(np.float64)
    step = float(x[-1] - x[0]) / (x.size - 1)
    off = np.abs(x - (x[0] + step * np.arange(x.size)))
    if not step or not off.max() <= 0.01 * abs(step):  # NaN too
        steps, usual = np.diff(x), float(np.median(np.diff(x)))
        odd = int(np.argmax(np.abs(steps - usual)))
        raise ValueError(f"{name}: {x[odd + 1]:.9g} is a step of {steps[odd]:.9g} where the usual one is {usual:.9g}; must be equally spaced")
    return step
