# SPDX-License-Identifier: BSD-3-Clause
"""What the results share: they are mappings with a readable repr, a data frame and a plot."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from html import escape
from typing import TYPE_CHECKING, Any, TypeVar

from . import _core
from ._units import in_si, si_unit

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
    import pandas as pd
    from matplotlib.axes import Axes


    Numbers = npt.NDArray[np.float64]
    Line = tuple[str, Any, Any, Any, Any]

Value = TypeVar("Value")


class Shown:
    """What a notebook shows: the text of repr(), its table as a table."""

    def _repr_html_(self) -> str:
        return html_of(repr(self))


class Table(Shown, Mapping[str, Value]):
    """A mapping that keeps what it was made of."""

    _values: dict[str, Value]

    def __getitem__(self, key: str) -> Value:
        return self._values[key]

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Mapping) and _same(dict(self), dict(other))


#: The attributes of results, and their keys.
FIELDS = {word: key for word, key, _ in _core.quantities} | {
    "stiffness_error": "stiffness_error_Pa_per_m", "real_area_fraction": "real_area_fraction",
    "contact_density": "contacts_per_m2", "law": "law",
}  # fmt: skip


class Columns(Table["npt.NDArray[Any]"]):
    """A mapping from the column names of `fstiff run --format csv` to arrays in SI units; those that are there are attributes too.

    The attributes are the words of output.quantities in docs/scene.md, such as `stiffness` and `tangential_stiffness`, and
    `pressure`, `force`, `law`, `stiffness_error`. What follows from K has the ends of its 90 % band: `stiffness.low`,
    `stiffness.high`; None where it has no band.
    """

    def __getattr__(self, name: str) -> Any:
        values = self.__dict__.get("_values", {})
        key = FIELDS.get(name, "")
        if key not in values:
            raise AttributeError(f"{name}: is not a column here, which are {', '.join(values)}")
        from ._values import Values

        low, high = (values.get(band_key(key, end)) for end in ("p05", "p95"))
        return values[key] if name == "law" else Values(values[key], low, high)

    def column(self, key: str) -> npt.NDArray[Any]:
        """The column `key`. Raises ValueError where there is none."""
        if key not in self:
            raise ValueError(f"{key}: is not a column here, which are {', '.join(self)}")
        return self[key]

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *(name for name, key in FIELDS.items() if key in self)]


def band_key(key: str, end: str) -> str:
    """The key of an end of the band: "stiffness_p05_Pa_per_m"; a key ends with its unit."""
    name, unit = re.fullmatch(r"(.*?)((?:_Pa_per_m|_N_per_m|_W_per_m2K|_S_per_m2)?)", key).groups()  # type: ignore[union-attr]
    return f"{name}_{end}{unit}"


def _same(one: Any, other: Any) -> bool:
    """Whether two values are the same, arrays by their numbers; NaN is NaN."""
    if isinstance(one, dict) and isinstance(other, dict):
        return one.keys() == other.keys() and all(_same(one[key], other[key]) for key in one)
    if isinstance(one, list) and isinstance(other, list):
        return len(one) == len(other) and all(map(_same, one, other))
    if hasattr(one, "dtype"):
        import numpy as np

        return np.array_equal(one, other, equal_nan=one.dtype.kind == "f")
    return bool(one == other)


def numbers(values: Any, name: str, unit: str | None = None) -> Numbers:
    """`values` as an array of doubles in SI, without a copy where they are one; `unit` is by default that of `name`."""
    import numpy as np

    values = in_si(values, name, si_unit(name) if unit is None else unit)
    try:
        array = np.asarray(values)
    except ValueError:
        raise ValueError(f"{name}: must be real numbers, its rows equally long") from None
    if array.dtype.kind not in "fiu":
        found = "text" if array.dtype.kind == "U" else array.dtype
        raise ValueError(f"{name}: must be real numbers, not {found}")
    if np.ma.is_masked(values):
        raise ValueError(f"{name}: must not be masked; compressed() of the array leaves these points out")
    return np.asarray(array, dtype=np.float64, order="C")


def number(value: Any, name: str) -> float:
    """`value` as a double in SI."""
    unit = si_unit(name)
    value = in_si(value, name, unit)
    try:
        return float(value)
    except OverflowError:
        raise ValueError(f"{name} = {value!r:.20}...: must be at most 1.8e308") from None
    except (TypeError, ValueError):
        such = 'a length in m, or a text such as "0.5 um"' if unit == "m" else "a number in SI units" if unit else "a number"
        raise ValueError(f"{name} = {value!r:.60}: must be {such}") from None


def whole(value: Any, name: str, least: int, most: int) -> int:
    """`value` as a whole number between two others."""
    found = number(value, name)
    if found < least:
        raise ValueError(f"{name} = {value!r:.40}: must be {least} or greater")
    if not (least <= found <= most and found == int(found)):
        raise ValueError(f"{name} = {value!r:.40}: must be a whole number from {least} to {most}")
    return int(found)


def count_of(columns: Columns) -> str:
    return f"{columns.pressure.size} point{'' if columns.pressure.size == 1 else 's'}"


def shown(value: float, digits: int = 4) -> str:
    """A number for people; "-" where there is none."""
    if value != value or not 1 <= abs(value) < 1e6:
        return "-" if value != value else f"{value:.{digits}g}"
    return f"{float(f'{value:.{digits}g}'):.{max(digits, 6)}g}"  # 570, not 5.7e+02, as the command writes it


def with_unit(value: float, si: str, digits: int = 4, error: float = 0.0) -> str:
    """A quantity in the unit of its size, as the command writes it: "0.832 ± 0.08 µm"."""
    return _core.with_unit(value, si, digits, error)


def shown_rows(columns: Mapping[str, Any], digits: int = 4) -> list[list[str]]:
    """The header and the rows of a table, in the units of the command; of many rows the first and the last ones."""
    import numpy as np

    rows: list[list[str]] = []
    for key, column in columns.items():
        values = np.ravel(column)
        few = range(values.size) if values.size <= 8 else [*range(4), *range(values.size - 4, values.size)]
        if values.dtype.kind == "f":
            name, factor = heading(key, values)
            rows.append([name, *(shown(float(values[i]) * factor, digits) for i in few)])
        else:
            rows.append([key, *(str(values[i]) or "-" for i in few)])
    table = [list(row) for row in zip(*rows)]
    return table if len(table) < 9 or len(few) == values.size else [*table[:5], ["..."] * len(rows), *table[5:]]


def lines_of(warnings: list[str]) -> str:
    return "".join(f"\nwarning: {one}" for one in warnings)


def text_table(rows: list[list[str]]) -> str:
    """Columns of text, the first at the left, under one header line."""
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    return "\n".join(
        ("  " + "  ".join(cell.rjust(width) if i else cell.ljust(width) for i, (cell, width) in enumerate(zip(row, widths)))).rstrip()
        for row in rows
    )


def html_of(text: str) -> str:
    """The text of a repr as HTML: lines of the columns that text_table() makes are rows, others paragraphs."""
    html, rows = "", 0
    for line in text.split("\n"):
        cells = re.split(" {2,}", line.strip()) if line.startswith("  ") else []
        html += "" if bool(rows) == (len(cells) > 1) else "</table>" if rows else "<table>"
        rows = rows + 1 if len(cells) > 1 else 0
        kind = "th" if rows == 1 else "td"
        html += (
            "<tr>" + "".join(f"<{kind}>{escape(cell)}</{kind}>" for cell in cells) + "</tr>" if rows else f"<p>{escape(line)}</p>"
        )
    return html + ("</table>" if rows else "")


def frame(columns: Any) -> pd.DataFrame:
    try:
        import pandas
    except ImportError as error:
        raise ImportError("to_dataframe() needs pandas; pip install pandas") from error
    return pandas.DataFrame(columns)


def need_matplotlib() -> None:
    """Raises ImportError in one sentence where there is no matplotlib."""
    try:
        import matplotlib  # noqa: F401
    except ImportError as error:
        raise ImportError("pictures need matplotlib: pip install 'fstiff[plot]'") from error


def axes(ax: Axes | None) -> Axes:
    if ax is not None:
        return ax
    need_matplotlib()
    import matplotlib.pyplot

    made: Axes = matplotlib.pyplot.subplots()[1]
    return made


def label_axes(ax: Axes, x: str, y: str, xs: Any, ys: Any) -> tuple[float, float]:
    """Names the axes by the columns `x` and `y` of `xs` and `ys`, in the units of the command; returns the factors from SI.

    An axis is logarithmic where its numbers cannot be negative.
    """
    factors = []
    for key, values, name, scale in ((x, xs, ax.set_xlabel, ax.set_xscale), (y, ys, ax.set_ylabel, ax.set_yscale)):
        label, factor = heading(key, values)
        name(label)
        factors.append(factor)
        if "separation" not in key and "reflection" not in key and "approach" not in key:
            scale("log")
    ax.grid(True, which="major")
    return factors[0], factors[1]


def heading(key: str, values: Any) -> tuple[str, float]:
    """How the tables of the command call a column, with the unit that fits `values`, and the factor from SI."""
    import numpy as np

    return _core.heading(key, np.ravel(np.asarray(values, dtype=np.float64)))


def unit_of(values: Any, si: str) -> tuple[str, float]:
    """The unit in which tables of the command show `values` [`si`], and the factor from SI."""
    import numpy as np

    return _core.shown_unit(np.ravel(np.asarray(values, dtype=np.float64)), si)


def draw(ax: Axes | None, x: str, y: str, lines: Sequence[Line]) -> Axes:
    """Draws lines of (label, x, y, low, high), in SI, over one another; low and high are the ends of a band, or None."""
    import numpy as np

    ax = axes(ax)
    every: list[Any] = [np.concatenate([np.ravel(line[i]) for line in lines]) if lines else [] for i in (1, 2)]
    by_x, by_y = label_axes(ax, x, y, *every)
    if np.size(every[0]) and np.min(every[0]) == np.max(every[0]) > 0:  # before matplotlib looks for limits
        ax.set_xlim(every[0][0] * by_x / 2, every[0][0] * by_x * 2)
    for label, at, values, low, high in lines:
        (draw_band, width, marker) = (ax.vlines, 8, "o") if np.size(at) == 1 else (ax.fill_between, 0, None)
        (line,) = ax.plot(at * by_x, values * by_y, label=label or None, marker=marker)
        if low is not None and not np.all(np.isnan(low)):
            draw_band(at * by_x, low * by_y, high * by_y, alpha=0.2, color=line.get_color(), lw=width)
    name_ticks(ax)
    if any(line[0] for line in lines):
        ax.legend(fontsize="small")
    return ax


def name_ticks(ax: Axes) -> None:
    """Gives logarithmic axes of up to four decades plain numbers, short ones at 1, 2 and 5 of every decade."""
    from matplotlib.ticker import LogLocator, NullFormatter

    for axis in (ax.xaxis, ax.yaxis):
        low, high = sorted(axis.get_view_interval())
        if axis.get_scale() == "log" and high < 1e4 * low:
            axis.set_major_locator(LogLocator(subs=(1, 2, 5) if high < 30 * low else (1,)))
            axis.set_major_formatter("{x:g}")
            axis.set_minor_formatter(NullFormatter())
