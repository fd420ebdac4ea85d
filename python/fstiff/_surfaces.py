# SPDX-License-Identifier: BSD-3-Clause
"""Measured surfaces: arrays, files, and what is found of them."""

from __future__ import annotations

import atexit
import functools
import hashlib
import json
import os
import pickle
import warnings
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, TypedDict, TypeVar, Union, cast

from . import _core
from ._errors import FileError, named
from ._objects import grid_of, is_object, is_topography
from ._pictures import draw_heights, draw_islands, draw_scales, draw_structure
from ._results import Shown, Table, draw, frame, lines_of, number, numbers, shown, shown_rows, text_table, with_unit
from ._units import has_units, in_si, si_unit

if TYPE_CHECKING:
    import numpy.typing as npt
    import pandas as pd
    from matplotlib.axes import Axes
    from typing_extensions import TypeAlias, Unpack

    from ._objects import Labelled, Topography
    from ._results import Numbers

    Object: TypeAlias = Union["Surface", Topography, Labelled]
    Source: TypeAlias = Union[Object, npt.ArrayLike, str, os.PathLike[str], Sequence[Any]]
    Measurable: TypeAlias = Union["Measurement", Object, Sequence[Any]]
    Length: TypeAlias = Union[float, str]
    Part: TypeAlias = tuple[Numbers, float, float, str, str]

Made = TypeVar("Made")
Function = TypeVar("Function", bound=Callable[..., Any])


class SurfaceOptions(TypedDict, total=False):
    """How a surface is read, cleaned and filtered: the options of `fstiff measure`. A length is in m, or a text such as "1 um".

    spacing              of an array: the distance of its points; of a map (dx, dy) where they differ
    dx, dy               of a map, the distance of its columns and of its rows
    crop                 the part that is kept: (x0, x1), of a map (x0, x1, y0, y1)
    mask                 a file of 0 and 1: points of 0 become missing (in an array, make them NaN or masked)
    spikes               points farther than so many robust standard deviations from their neighbours become missing, from 3
    fill                 missing points are filled
    align                of a map, the offsets of scan lines: "none", "median" or "median_of_differences", of lines along
                         scan_axis "x", "y" or "auto"
    detrend              form that is removed: "none", "mean", "line", "parabola", "circle", "gaussian" of a profile (then
                         cutoff); "none", "mean", "plane", "quadratic", "cubic", "sphere", "cylinder" of a map
    radius               of a circle, sphere or cylinder; the best one by default
    lambda_s, lambda_c   shortest and longest waves that are kept; "auto" of lambda_s is by the standards' table, of
                         lambda_c all, and the table's for Ra and Rq of a profile; "none" keeps all
    filter               of lambda_c: "gaussian" or "robust"
    tip_radius, resolution   of the instrument
    units                of an object without them, or of a file: "um,nm" (lengths, heights) or "um"
    format, column, x_column, missing, thousands, resample, x3p_increment, channel, width, height, grid, facing   of a file
                         alone: see docs/formats.md
    """

    spacing: Length | tuple[Length, Length]
    dx: Length
    dy: Length
    crop: str | tuple[Length, ...]
    mask: str | os.PathLike[str]
    spikes: float
    fill: bool
    align: Literal["none", "median", "median_of_differences"]
    scan_axis: Literal["auto", "x", "y"]
    detrend: str
    radius: Length
    cutoff: Length
    lambda_s: Length
    lambda_c: Length
    filter: Literal["gaussian", "robust"]
    tip_radius: Length
    resolution: Length
    format: str
    units: str
    column: int
    x_column: int
    missing: str
    thousands: str
    resample: bool
    x3p_increment: Literal["apply", "ignore"]
    channel: str | int
    width: Length
    height: Length
    grid: Length
    facing: str | os.PathLike[str]


#: Options that have no meaning for an array.
OF_FILES = {key for key, of_files in _core.surface_options().items() if of_files}


def metres(value: Any, name: str) -> float:
    """A length, or a text of one, in m."""
    return _core.parse_length(in_si(value, name, "m") if has_units(value) else value, name)


def warn_of_height(sigma: float, frames: int = 1) -> None:
    """Warns of a height [m] that was given in another unit; `frames` above the caller is who gave it."""
    if sigma > 1e-3:
        sentence = f'rms height of {shown(sigma)} m: above 1 mm; lengths are numbers in m, or texts such as "0.8 um"'
        warnings.warn(sentence, stacklevel=frames + 2)


class Surface(Shown):
    """Heights of a surface [m]: a profile (1-D) of equal spacing, or a map (2-D, rows along y).

    spacing is the distance between neighbouring points, of a map a number or (dx, dy). NaN and masked points are missing.
    """

    def __init__(
        self,
        heights: npt.ArrayLike,
        spacing: Length | tuple[Length, Length] | None = None,
        *,
        dx: Length | None = None,
        dy: Length | None = None,
        name: str = "heights",
    ) -> None:
        import numpy as np

        array: Any = in_si(heights, name, "m") if has_units(heights) else heights
        if isinstance(array, np.ma.MaskedArray):
            array = np.ma.filled(array.astype(np.float64), np.nan)
        try:
            array = np.asarray(array)
            if array.dtype.kind == "O":  # None is missing
                array = array.astype(np.float64)
        except (OverflowError, TypeError, ValueError):
            raise ValueError(
                f"{name}: must be real numbers, the rows of a map equally long; several traces are a list of 1-D arrays"
            ) from None
        if array.dtype.kind not in "fiu":
            raise ValueError(f"{name}: must be real numbers, not {array.dtype}")
        self.heights: Numbers = np.asarray(array, dtype=np.float64, order="C")
        self.name = name
        self.decisions: list[str] = []
        self.warnings: list[str] = []
        if self.heights.ndim not in (1, 2):
            raise ValueError(f"{name} have {self.heights.ndim} dimensions: must have 1 (a profile) or 2 (a map)")
        of_array: Any = spacing
        if has_units(of_array):
            spacing = in_si(of_array, "spacing", "m")
        elif hasattr(of_array, "tolist"):  # of NumPy
            spacing = of_array.tolist()
        if isinstance(spacing, (tuple, list)):
            if len(spacing) != 2:
                raise ValueError("spacing: must be one length, or (dx, dy)")
            if dx is not None or dy is not None:
                raise ValueError("spacing: must not be given with dx or dy")
            dx, dy = spacing
        elif spacing is not None:
            if dx is not None or dy is not None:
                raise ValueError("spacing: must not be given with dx or dy")
            dx = dy = spacing
        if dx is None or (dy is None and self.heights.ndim == 2):
            raise ValueError("spacing: is missing; an array needs the distance of its points [m]")
        if self.heights.ndim == 1 and dy is not None and dy is not dx and metres(dy, "dy") != metres(dx, "dx"):
            raise ValueError("dy: a profile has one spacing")
        one = "spacing" if spacing is not None and not isinstance(spacing, (tuple, list)) else ""
        self.dx = metres(dx, one or "dx")
        self.dy = metres(dy, one or "dy") if self.heights.ndim == 2 else None

    @property
    def spacing(self) -> float | tuple[float, float]:
        """Distance of neighbouring points [m]; of a map (dx, dy)."""
        return self.dx if self.dy is None else (self.dx, self.dy)

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws the heights with matplotlib; returns the axes."""
        return draw_heights(ax, self.heights, self.dx, self.dy or 0.0)

    def __repr__(self) -> str:
        import numpy as np

        missing = int(np.isnan(self.heights).sum())
        shape = (
            f"profile of {self.heights.size} points, spacing {with_unit(self.dx, 'm')}"
            if self.dy is None
            else f"map of {self.heights.shape[1]} x {self.heights.shape[0]} points, dx {with_unit(self.dx, 'm')}, dy {with_unit(self.dy, 'm')}"
        )
        return f"<fstiff.Surface {self.name}: {shape}{f', {missing} missing' if missing else ''}>" + lines_of(self.warnings)


def surface_of_object(source: Any, name: str, steps: dict[str, Any] | None = None, units: str | None = None) -> Surface:
    """What another package holds; see grid_of()."""
    heights, unit, own_steps = grid_of(source, name, steps or {}, units)
    surface = Surface(heights, name=name, **own_steps)
    surface.heights = surface.heights * unit
    return surface


def open_surface(file: str | os.PathLike[str], channel: str | int | None = None, **options: Any) -> Surface:
    """Opens a file of heights: any that `fstiff formats` lists, and the formats of SurfaceTopography where it is installed.

    options   of the reading, such as spacing, units and format: see SurfaceOptions

    The form is not removed, and nothing is filtered.
    """
    path = named(file, "file")
    if channel is not None:
        options["channel"] = channel
    try:
        arrays, decisions, warnings = _core.read(options_of({**options, "file": path}))
    except FileError:
        raise
    except ValueError as refused:
        try:
            topography = _by_surface_topography(path, channel)
        except ImportError:
            way_out = "; SurfaceTopography may read it: pip install 'fstiff[readers]'" if is_of_form(refused) else ""
            raise ValueError(f"{refused}{way_out}") from None
        if topography is None or set(options) - {"channel"}:
            raise
        try:
            surface = surface_of_object(topography, os.path.basename(path))
        except ValueError as without_unit:  # a text whose units fstiff asked for
            raise without_unit if is_of_form(refused) else refused from None
        surface.decisions = [f"format: {type(topography).__name__}, by SurfaceTopography, since {refused}"]
        return surface
    surface = surface_of(arrays, path)
    surface.decisions, surface.warnings = decisions, warnings
    return surface


def surface_of(arrays: tuple[Numbers, float, float], name: str) -> Surface:
    heights, dx, dy = arrays
    return Surface(heights, dx, name=name) if heights.ndim == 1 else Surface(heights, dx=dx, dy=dy, name=name)


def _by_surface_topography(path: str, channel: str | int | None) -> Any:
    """The topography of `path`, or None where SurfaceTopography does not know it. Of several channels of heights one must be chosen."""
    from SurfaceTopography.IO import open_topography

    try:
        reader = open_topography(path)
        of_heights = [(one.index, one.name) for one in getattr(reader, "height_channels", ())]
        if isinstance(channel, str):
            channel = [one.name for one in reader.channels].index(channel)
        if channel is None and len(of_heights) < 2:
            return reader.topography(channel_index=of_heights[0][0]) if of_heights else reader.topography()
        if channel is not None:
            return reader.topography(channel_index=channel)
    except Exception:  # its readers raise whatever they met in the file; that of fstiff is clearer
        return None
    names = ", ".join(f'{index} "{name}"' for index, name in of_heights)
    raise ValueError(f"{path}: has {len(of_heights)} channels of heights: {names}; must be one of them, as open_surface(file, channel=0)")


def is_of_form(refused: ValueError) -> bool:
    """Whether a file was refused for its form: no reader accepts it, or the one for it is not built in."""
    return any(words in str(refused) for words in ("must be text (a profile", "that holds no main.xml", "this program was built without"))


def of_any_form(function: Function) -> Function:
    """function(surface, ...) of a file that fstiff does not read, too, where SurfaceTopography reads it."""

    @functools.wraps(function)
    def compute(surface: Any, *arguments: Any, **options: Any) -> Any:
        try:
            return function(surface, *arguments, **options)
        except ValueError as refused:
            if not isinstance(surface, (str, os.PathLike)) or not is_of_form(refused):
                raise
        return function(open_surface(surface, options.pop("channel", None)), *arguments, **options)

    return cast(Function, compute)


def options_of(options: dict[str, Any]) -> dict[str, Any]:
    """The options as the compiled part takes them: without those that are None."""
    made = {}
    for name, value in options.items():
        if value is None:
            continue
        if name in ("mask", "facing"):
            made[name] = named(value, name)
        elif name == "channel" and isinstance(value, int):
            made[name] = str(value)
        else:
            made[name] = in_si(value, name, si_unit(name)) if has_units(value) else value
    return made


def _of(source: Any, options: dict[str, Any], own: dict[str, Any]) -> tuple[dict[str, Any], list[str], list[Part]]:
    """Options of what a function was given, and its files or its arrays; `own` are the options of that function."""
    unknown = set(options) - set(SurfaceOptions.__annotations__)
    if unknown:
        raise TypeError(f"unexpected keyword argument: {', '.join(sorted(unknown))}")
    files: list[str] = []
    if isinstance(source, (str, os.PathLike)):
        files = [named(source, "surface")]
    elif isinstance(source, (list, tuple)) and source and all(isinstance(one, (str, os.PathLike)) for one in source):
        files = [named(one, "surface") for one in source]
    if files:
        if isinstance(options.get("spacing"), (tuple, list)):
            raise ValueError("spacing: of a file must be one length; dx and dy are of a map")
        return options_of({**options, **own, "file": files[0]}), files, []
    useless = OF_FILES & set(options) - {"units"}  # which objects may need
    if useless:
        raise ValueError(f"{sorted(useless)[0]}: is an option of files; must not be given for an array")
    steps: dict[str, Any] = {name: options.pop(name) for name in ("spacing", "dx", "dy", "units") if name in options}
    if _are_several(source, steps):
        parts = [_part(one, steps, f"heights[{i}]") for i, one in enumerate(source)]
    else:
        parts = [_part(source, steps, "heights")]
    return options_of({**options, **own, "file": parts[0][3]}), [], parts


def _are_several(source: Any, steps: dict[str, Any]) -> bool:
    """Whether a list holds arrays or surfaces; 1-D arrays with two distances of points are the rows of one map."""
    if not isinstance(source, (list, tuple)):
        return False
    sides = [getattr(one, "ndim", 0) for one in source]
    of_map = steps.get("dy") is not None or isinstance(steps.get("spacing"), (tuple, list))
    return any(hasattr(one, "heights") for one in source) or max(sides, default=0) > (1 if of_map else 0)


def _part(source: Any, steps: dict[str, Any], name: str) -> Part:
    """Heights, dx, dy, name and origin of one array, surface or object of another package."""
    origin, steps = "an array", dict(steps)
    if isinstance(source, Surface):
        surface = source
        name = name if surface.name == "heights" else surface.name
    elif isinstance(source, Mapping):
        raise ValueError(f"{name}: must be an array or a list of arrays, not of type {type(source).__name__}")
    elif is_object(source):
        name = name.replace("heights", "topography") if is_topography(source) else name
        units = steps.pop("units", None)
        surface = surface_of_object(source, name, steps, units)
        origin, steps = f"a {type(source).__name__} of {type(source).__module__.partition('.')[0]}", {}
    elif "units" in steps:
        raise ValueError("units: is an option of files; must not be given for an array")
    else:
        surface = Surface(source, name=name, **steps)
        steps = {}
    if steps:
        raise ValueError(f"{next(iter(steps))}: must not be given for a surface that has its own")
    if surface.dy is not None and min(surface.heights.shape) < 3:
        shape = " x ".join(map(str, surface.heights.shape))
        raise ValueError(
            f"{name}: {shape} points are no map, which has at least 3 rows and 3 columns; a profile is a 1-D array, "
            "several traces are a list of them"
        )
    return surface.heights, surface.dx, surface.dy or 0.0, name, origin


def _with_arrays(value: Any) -> Any:
    """JSON with every list of numbers as an array."""
    if isinstance(value, dict):
        return {key: _with_arrays(one) for key, one in value.items()}
    if isinstance(value, list):
        if value and all(isinstance(one, (int, float)) and not isinstance(one, bool) for one in value):
            import numpy as np

            return np.array(value)
        return [_with_arrays(one) for one in value]
    return value


class Document(Table[Any]):
    """A mapping with the keys of a JSON document of the command; lists of numbers are arrays, null is None.

    doubtful   the command would have ended with exit code 4
    """

    def __init__(self, found: _core.Found) -> None:
        self._values = _with_arrays(json.loads(found.json))
        self.doubtful = found.doubtful

    def to_json(self) -> str:
        """The document as JSON."""
        return json.dumps(self._values, default=lambda array: array.tolist(), indent=2)

    @property
    def warnings(self) -> list[str]:
        """Sentences on what may not hold."""
        return list(self["warnings"])


class Parameter(NamedTuple):
    """A parameter of a surface with its standard error; the unit is one of SI, "" for a pure number."""

    value: float
    error: float
    unit: str


@functools.lru_cache(maxsize=2)
def _measured_again(state: bytes) -> _core.Measured:
    options, files, contents, arrays = pickle.loads(state)
    return _core.measure(options, files, contents, [_core.Heights(*one) for one in arrays]).measured


atexit.register(_measured_again.cache_clear)  # else nanobind reports what Python never frees


class Origin:
    """What was measured, and what it was measured of: options, files with their paths and SHA-256, arrays; or a pickle of it.

    A pickle holds the arrays, or the contents of the files. They are measured again where they are needed, with the same
    numbers; a process does it once, however often it loads them.
    """

    def __init__(self, of: Any, measured: _core.Measured | None = None) -> None:
        self._of, self._measured = of, measured

    def measured(self) -> _core.Measured:
        if self._measured is None:
            self._measured = _measured_again(self._of)
        return self._measured

    def arrays(self) -> list[Part]:
        """What was measured, of arrays."""
        arrays: list[Part] = (pickle.loads(self._of) if isinstance(self._of, bytes) else self._of)[-1]
        return arrays

    def __deepcopy__(self, _: Any) -> Origin:
        return self  # nothing changes it

    def __reduce__(self) -> tuple[type[Origin], tuple[bytes]]:
        if not isinstance(self._of, bytes):
            options, files, paths, hashes, arrays = self._of
            contents = [_content_of(path, hashes) for path in paths]
            self._of = pickle.dumps((options, files, contents, arrays))
        return Origin, (self._of,)


def _content_of(path: str, hashes: set[str]) -> bytes:
    with open(path, "rb") as file:
        content = file.read()
    if hashlib.sha256(content).hexdigest() not in hashes:
        raise FileError(f"{path}: has changed since it was measured; measure it again")
    return content


class Measurement(Document):
    """What `fstiff measure` finds of a surface: the keys of its JSON. Scene, run() and Contact take it as their surface.

    The parameters of ["surface"] are attributes too: `measured.rms_height.value`, `measured.r.error`.
    """

    _origin: Origin

    @property
    def _measured(self) -> _core.Measured:
        return self._origin.measured()

    def __getattr__(self, name: str) -> Parameter:
        surface = self.__dict__.get("_values", {}).get("surface", {})
        if name not in surface:
            raise AttributeError(f"{name}: is not a parameter of this surface, which has {', '.join(surface)}")
        return Parameter(surface[name]["value"], surface[name]["error"], surface[name].get("unit", ""))

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws the heights without their form; returns the axes. They are in the unit of their size."""
        heights = self._measured.views().get("heights")
        if heights is None:
            raise ValueError("plot(): several surfaces were pooled; plot each by itself")
        return draw_heights(ax, *heights)

    def scales(self, *, pressure: float = 10e6, effective_modulus: float = 112.6e9) -> Scales:
        """The parameters, and K at `pressure` [Pa], with other cut-offs by factors of two, as `fstiff measure --scales` finds them."""
        arrays = self._origin.arrays()
        heights = _core.Heights(*arrays[0]) if arrays else _core.Heights(None, 0.0, 0.0, "", "")
        of = number(pressure, "pressure"), number(effective_modulus, "effective_modulus")
        return Scales(_core.scales(self._measured, heights, *of))

    def to_dataframe(self) -> pd.DataFrame:
        """The parameters of a scene's [surface] with their standard errors and SI units, a parameter a row."""
        return frame(
            [
                {"parameter": name, "value": one["value"], "error": one["error"], "unit": one.get("unit", "")}
                for name, one in self["surface"].items()
            ]
        )

    def __repr__(self) -> str:
        rows = [["parameter", "value", "found by"]]
        for name, one in self["surface"].items():
            rows.append([name, with_unit(one["value"], one.get("unit", ""), 5, one["error"]), one["how"]])
        source = self["source"]
        return f"<fstiff.Measurement of {source['file']} ({source['kind']})>\n{text_table(rows)}" + lines_of(self.warnings)


class Scales(Document):
    """The influence of the cut-offs: the keys of the JSON of `fstiff measure --scales`."""

    def to_dataframe(self) -> pd.DataFrame:
        """A pair of cut-offs a row."""
        return frame(dict(self["scales"]))

    def plot(self, ax: Axes | None = None, of: Literal["lambda_s", "lambda_c"] = "lambda_s") -> Axes:
        """Draws K and the parameters over those with the chosen cut-offs, against one cut-off; returns the axes."""
        return draw_scales(ax, self, of)

    def __repr__(self) -> str:
        of = self["scales"]
        k = f"K by {of['law']} at {with_unit(of['pressure_Pa'], 'Pa')}"
        return f"<fstiff.Scales of {self['source']['file']}: {k}>" + "".join(f"\n  {one}" for one in of["settled"])


class Fit(Document):
    """Fractal dimension D and roughness G of a profile or a map: the keys of the JSON of `fstiff measure --show fit`.

    D and G are fitted to ["second_differences"], and ["fitted"] is the fitted curve; of a map those of ["x"] and ["y"].
    """

    def to_dataframe(self) -> pd.DataFrame:
        """The structure function; of a map that along x, and that along y below it, with a column "direction"."""
        if "structure_function" in self:
            return frame(dict(self["structure_function"]))
        import pandas

        parts = [frame(dict(self[of]["structure_function"])).assign(direction=of) for of in "xy" if "refused" not in self[of]]
        return pandas.concat(parts, ignore_index=True)

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws the structure function; returns the axes."""
        parts = (("", self),) if "structure_function" in self else (("x", self["x"]), ("y", self["y"]))
        return draw_structure(ax, [(name, of["structure_function"]) for name, of in parts if "refused" not in of])

    def __repr__(self) -> str:
        parts = [("", self._values)] if "structure_function" in self else [(f"along {of}: ", self[of]) for of in "xy"]
        text = "".join(
            f"\n  {where}no fit: {of['refused']}"
            if "refused" in of
            else f"\n  {where}D = {with_unit(of['fractal_dimension'], '', 5, of['fractal_dimension_error'])}, "
            f"G = {with_unit(of['fractal_roughness_m'], 'm', 5, of['fractal_roughness_error_m'])}"
            for where, of in parts
        )
        return f"<fstiff.Fit of {self['source']['file']}>{text}" + lines_of(self.warnings)


class Islands(Document):
    """The islands of a map, and R and D_p where they are densest: the keys of the JSON of `fstiff measure --show islands`."""

    def to_dataframe(self) -> pd.DataFrame:
        """The curve, a cutting level a row."""
        return frame(dict(self["curve"]))

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws the density of islands over the bearing area; returns the axes."""
        return draw_islands(ax, self["curve"], "density_per_m2")

    def __repr__(self) -> str:
        of = self["representative"]
        density = with_unit(of["peak_density_per_m2"], "1/m^2", 5, of.get("peak_density_error_per_m2", 0.0))
        radius = with_unit(of["peak_radius_m"], "m", 5, of.get("peak_radius_error_m", 0.0))
        return (
            f"<fstiff.Islands of {self['source']['file']}>\n  D_p = {density}, R = {radius}, of {of['islands']} islands"
            + lines_of(self.warnings)
        )


class Truth(Document):
    """The contact of a map by boundary elements: the keys of the JSON of `fstiff truth`."""

    def to_dataframe(self) -> pd.DataFrame:
        """A pressure a row."""
        return frame(self["rows"])

    def column(self, key: str) -> Numbers:
        """What every row has under `key`, such as "stiffness_Pa_per_m", as an array."""
        import numpy as np

        return np.array([row[key] for row in self["rows"]])

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws K over the pressure, with its change from a grid half as fine; returns the axes."""
        k, error = self.column("stiffness_Pa_per_m"), self.column("stiffness_error_Pa_per_m")
        return draw(ax, "pressure_Pa", "stiffness_Pa_per_m", [("boundary elements", self.column("pressure_Pa"), k, k - error, k + error)])

    def __repr__(self) -> str:
        keys = ("pressure_Pa", "stiffness_Pa_per_m", "stiffness_error_Pa_per_m", "separation_m", "real_area_fraction")
        rows = shown_rows({key: self.column(key) for key in keys}, 5)
        return f"<fstiff.Truth of {self['map']}>\n{text_table(rows)}" + lines_of(self.warnings)


@of_any_form
def measure(
    surface: Source,
    *,
    peaks: Literal["islands", "summits"] | None = None,
    window: str | tuple[Length, Length] | None = None,
    columns: str | None = None,
    channels: str | None = None,
    resamples: int | None = None,
    seed: int | None = None,
    **options: Unpack[SurfaceOptions],
) -> Measurement:
    """Every parameter of a scene's surface, with errors, as `fstiff measure` finds them.

    surface     a 1-D or 2-D array of heights [m] with `spacing`, a Surface, a file, or an object with units and positions of its
                own: what has heights, physical_sizes and a unit, as topographies of SurfaceTopography; a DataArray of xarray of the
                shape (x), (y, x) or (x, y); a Series of pandas over x, or a DataFrame with index y and columns x. attrs["units"]
                of the heights and of the coordinates, of pandas "um,nm" (lengths, heights), has the units, or `units` where there
                are none. A list of several of one surface is pooled: files, or arrays such as the 1-D arrays of traces, or objects
    peaks       of a map, for R and D_p: its islands (default) or its summits
    window      shortest and longest lag that give D [m]; None chooses them
    columns     of one file, "2-180" or "2,4": profiles of one face, which are pooled; channels: its tables or channels
    resamples   for the standard errors, 400 by default, drawn with `seed`
    options     see SurfaceOptions
    """
    own = {"peaks": peaks, "window": window, "columns": columns, "channels": channels, "resamples": resamples, "seed": seed}
    made, names, arrays = _of(surface, dict(options), own)
    files = _core.without_folders(names)
    found = _core.measure(made, files, [], [_core.Heights(*one) for one in arrays])
    measured = Measurement(found)
    hashes = {one["source"]["sha256"] for one in measured.get("files", [measured])}
    kept = [(one[0].copy(), *one[1:]) for one in arrays]
    measured._origin = Origin((made, files, [os.path.abspath(name) for name in files], hashes, kept), found.measured)
    if arrays:
        warn_of_height(measured.rms_height.value, 2)
    return measured


def measured_of(surface: Any) -> Any:
    """What surface= takes, measured where it is a Surface, an object of another package or a list, which is pooled."""
    return measure(surface) if isinstance(surface, (Surface, list, tuple)) or is_object(surface) else surface


def with_surface(make: Callable[[str, _core.Measured | None], Made], surface: Any) -> Made:
    """make(file, measured) of what surface= of a scene takes. A file whose form is unknown is read by SurfaceTopography."""
    if isinstance(surface, Measurement):
        return make("", surface._measured)
    file = "" if surface is None else named(surface, "surface")
    try:
        return make(file, None)
    except ValueError as refused:
        if not file or not is_of_form(refused):
            raise
    return make("", measure(file)._measured)


def one_source(surface: Any, options: Any, **own: Any) -> tuple[dict[str, Any], _core.Heights]:
    """The arguments of a function of one surface, as the compiled part takes them: of most functions all their locals()."""
    made, files, arrays = _of(surface, dict(options), own)
    if len(files) > 1 or len(arrays) > 1:
        raise ValueError(f"{'files' if files else 'arrays'}: must be one; measure() pools several")
    return made, _core.Heights(*arrays[0]) if arrays else _core.Heights(None, 0.0, 0.0, "", "")


@of_any_form
def fit(
    surface: Source,
    *,
    window: str | tuple[Length, Length] | None = None,
    convention: Literal["exact", "paper", "majumdar_tien"] | None = None,
    resamples: int | None = None,
    seed: int | None = None,
    **options: Unpack[SurfaceOptions],
) -> Fit:
    """Fractal dimension D and roughness G [m] of a profile or a map, with errors, as `fstiff measure --show fit` finds them.

    `convention` is the constant of eq. (2.4) that gives G;
    the other arguments are those of measure().
    """
    return Fit(_core.fit(*one_source(**locals())))


@of_any_form
def islands(
    surface: Source,
    *,
    neighbours: Literal[4, 8] = 8,
    border: Literal["keep", "drop"] = "keep",
    island_height: Literal["peak", "twice-mean"] = "peak",
    least_points: int = 1,
    levels: int | None = None,
    tiles: int | None = None,
    resamples: int | None = None,
    seed: int | None = None,
    **options: Unpack[SurfaceOptions],
) -> Islands:
    """The islands of a map at every cutting level, and R [m] and D_p [1/m^2], as `fstiff measure --show islands` finds them.

    `levels` are 200 by default, at equal steps of bearing area; the errors are of `tiles` x `tiles` tiles, 4 x 4 by default, drawn
    `resamples` times with `seed`. `surface` and `options` are those of measure().
    """
    return Islands(_core.islands(*one_source(**locals())))


@of_any_form
def truth(
    surface: Source,
    pressures: npt.ArrayLike,
    *,
    effective_modulus: float,
    points: int = 256,
    edges: Literal["mirrored", "periodic"] = "mirrored",
    hardness: float | None = None,
    **options: Unpack[SurfaceOptions],
) -> Truth:
    """The contact of a map against a flat under `pressures` [Pa] by boundary elements on the map itself, as `fstiff truth` solves it.

    effective_modulus   [Pa]
    points              along the longer side, that the map is made coarser to
    edges               how the map goes on beyond its edges
    hardness            at which pressures are cut [Pa]; None is elastic

    `surface` and `options` are those of measure().
    """
    import numpy as np

    made, heights = one_source(surface, options, points=points, edges=edges, hardness=hardness)
    return Truth(_core.truth(made, heights, np.atleast_1d(numbers(pressures, "pressures")), number(effective_modulus, "effective_modulus")))
