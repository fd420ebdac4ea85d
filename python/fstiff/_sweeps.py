# SPDX-License-Identifier: BSD-3-Clause
"""Many scenes at once."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal

from . import _core
from ._results import frame, whole
from ._scenes import Scene, _toml, lines_of_text, text_or_file
from ._surfaces import measured_of, warn_of_height, with_surface
from ._units import as_text, has_units

if TYPE_CHECKING:
    import pandas as pd

    from ._scenes import Face, Given


#: The keys of a face that are its height.
HEIGHTS = {"rms_height", "Rq", "Sq", "Ra", "Sa"}


def _is_real(values: Any) -> bool:
    """Whether `values` are numbers with a point, which need no text."""
    if hasattr(values, "dtype"):
        return bool(values.dtype.kind == "f" and values.ndim == 1)
    return isinstance(values, (list, tuple)) and all(isinstance(value, float) for value in values)


def sweep(
    scene: Scene | Given,
    axes: Mapping[str, Any],
    *,
    surface: Face = None,
    mode: Literal["product", "zip"] | None = None,
    samples: int | None = None,
    seed: int | None = None,
    rows: tuple[int, int] | None = None,
    threads: int | None = None,
) -> pd.DataFrame:
    """Many scenes, as `fstiff sweep` computes them: a data frame of pandas with a row for each line of its results.

    scene    a Scene, or what Scene() takes with `surface`; what a grid sweeps in a file is swept too
    axes     the values of quantities of the scene, by their keys, such as {"surface.rms_height": [0.5e-6, 1e-6]} and
             "contact.pressures[0]": an array in SI, a list of texts with units or of words, or a dict with the forms of a grid,
             such as {"normal": [0.8e-6, 0.05e-6]} (docs/sweep.md)
    mode     "product", the default: every value with every other, the last one fastest; "zip": the first values together, then the
             second ones
    samples  draws of the distributions at each point, 1000 by default
    seed     of the draws
    rows     (FROM, TO): the scenes whose index, from 0 on, is at least FROM and less than TO; all by default
    threads  one for each core by default

    Columns are the keys of the lines: `index` of the scene, the swept values, `law`, then the columns of run(). A scene, or a point
    of it, that cannot be computed has its sentence in `error`. Ctrl-C ends a sweep.
    """
    import numpy as np

    if isinstance(scene, Scene):
        if surface is not None:
            raise ValueError("surface: must not be given for a Scene, which has its own")
        scene, surface = scene._made_of
    if surface is not None and any(key.startswith("surface.") for key in axes):
        raise ValueError("axes: must not hold keys of [surface] together with surface=")
    if rows is not None:
        if not isinstance(rows, (tuple, list)) or len(rows) != 2:
            raise ValueError(f"rows = {rows!r}: must be (FROM, TO), two whole numbers")
        rows = (whole(rows[0], "rows[0]", 0, 2**53), whole(rows[1], "rows[1]", 0, 2**53))
    threads = 0 if threads is None else whole(threads, "threads", 1, 4096)
    given: dict[str, Any] = {}
    numbers: dict[str, Any] = {}
    for key, values in axes.items():
        if has_units(values):
            values = as_text(values, f"axes: {key}")
        if _is_real(values):
            numbers[key] = np.array(values, dtype=np.float64)[1:]
            values = values[:1]  # which shows what kind of values they are
        given[key] = values if isinstance(values, Mapping) else {"values": values}
    given.update({"sweep.mode": mode, "sweep.samples": samples, "sweep.seed": seed})
    text, file = text_or_file(scene)
    swept = _toml(given, "axes")
    with lines_of_text(scene):
        found = with_surface(lambda *face: _core.sweep(text, file, swept, numbers, face[0], face[1], rows, threads), measured_of(surface))
    columns: dict[str, Any] = {"index": found["index"].astype(np.int64)}
    for key, texts, values in found["axes"]:
        columns[key] = np.array(texts, dtype=object)[values.astype(int)] if texts else values
        if key.rpartition(".")[2] in HEIGHTS and not texts:
            warn_of_height(float(np.max(values, initial=0.0)))
    columns["law"] = np.array([law or None for law in found["laws"]], dtype=object)[found["law"].astype(int)]
    columns.update(found["columns"])
    if found["answer"].any():
        columns["answer"] = np.where(found["answer"] == 1, 1, np.nan)
    if found["errors"]:
        columns["error"] = np.full(len(found["index"]), None, dtype=object)
        columns["error"][list(found["errors"])] = list(found["errors"].values())
    return frame(columns)
