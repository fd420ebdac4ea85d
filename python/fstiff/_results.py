# SPDX-License-Identifier: BSD-3-Clause
"""What the results share: they are mappings with a readable repr, a data frame and a plot."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from html import escape
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
    import pandas as pd
    from matplotlib.axes import Axes

    Numbers = npt.NDArray[np.float64]

Value = TypeVar("Value")


class Table(Mapping[str, Value]):
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

    def _repr_html_(self) -> str:
        """What a notebook shows: the text of repr(), its table as a table."""
        return html_of(repr(self))


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


def shown(value: float, digits: int = 4) -> str:
    """A number for people; "-" where there is none."""
    return "-" if value != value else f"{value:.{digits}g}"


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


def axes(ax: Axes | None) -> Axes:
    if ax is not None:
        return ax
    try:
        import matplotlib.pyplot
    except ImportError as error:
        raise ImportError("pictures need matplotlib: pip install 'fstiff[plot]'") from error
    made: Axes = matplotlib.pyplot.subplots()[1]
    return made


#: How the axes of a plot are called, by the keys of the columns, and the factor from SI.
LABELS = {
    "pressure_Pa": ("pressure [MPa]", 1e-6),
    "separation_m": ("separation [µm]", 1e6),
    "stiffness_Pa_per_m": ("stiffness K per area [GPa/µm]", 1e-15),
    "loading_stiffness_Pa_per_m": ("-dp/dd [GPa/µm]", 1e-15),
    "tangential_stiffness_Pa_per_m": ("tangential stiffness per area [GPa/µm]", 1e-15),
    "thermal_conductance_W_per_m2K": ("thermal conductance [W/(m² K)]", 1.0),
    "electrical_conductance_S_per_m2": ("electrical conductance [S/m²]", 1.0),
    "real_area_fraction": ("real area over nominal area", 1.0),
    "contacts_per_m2": ("contacts [1/mm²]", 1e-6),
    "reflection": ("|R|", 1.0),
    "shear_reflection": ("|R| of shear waves", 1.0),
    "loss_factor": ("loss factor", 1.0),
}


def label_axes(ax: Axes, x: str, y: str) -> tuple[float, float]:
    """Names the axes by the columns `x` and `y`, logarithmic where their numbers cannot be negative. Returns the factors."""
    for key, name, scale in ((x, ax.set_xlabel, ax.set_xscale), (y, ax.set_ylabel, ax.set_yscale)):
        name(LABELS.get(key, (key, 1.0))[0])
        if key != "separation_m" and "reflection" not in key:
            scale("log")
    ax.grid(True, which="major", alpha=0.3)
    return LABELS.get(x, (x, 1.0))[1], LABELS.get(y, (y, 1.0))[1]
