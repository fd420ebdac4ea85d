# SPDX-License-Identifier: BSD-3-Clause
"""What results draw of themselves with matplotlib, on axes of the caller or on new ones."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from ._results import axes, draw, heading, unit_of, with_unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._results import Numbers, Table


def draw_curves(given: Any, smooth: Any, y: str, x: str, ax: Axes | None) -> Axes:
    """Curves.plot() of `given`, with the lines of `smooth`: the same curves at more points."""
    import numpy as np

    given.column(x), given.column(y)
    answers = y == "stiffness_Pa_per_m" and x == "pressure_Pa" and bool(given.answer.rows)
    lines: list[Any] = []
    if answers:
        k = smooth.answer.stiffness
        lines.append(("K of the answer, 90 % band", smooth.answer.pressure, k, k.low, k.high))
    for title, columns in smooth.parts():
        if not np.all(np.isnan(columns[y])) and not (answers and given._best):
            low, high = (columns[key] for key in given._bands.get(y, ())) if y in given._bands else (None, None)
            label = f"answer ({title.partition(',')[0].replace('_', ' ')})" if given._best else title
            lines.append((label, columns[x], columns[y], low, high))
    if not lines:
        raise ValueError(f"{y}: no law of the scene gives it")
    ax = draw(ax, x, y, lines)
    by_x, by_y = (heading(key, np.concatenate([line[i] for line in lines]))[1] for key, i in ((x, 1), (y, 2)))
    marks: list[Any] = [(given.answer["pressure_Pa"], given.answer["stiffness_Pa_per_m"])] if answers else []
    if not (answers and given._best):
        marks += [(columns[x], columns[y]) for _, columns in given.parts() if not np.all(np.isnan(columns[y]))]
    for line, (at, values) in zip(ax.get_lines()[-len(lines) :], marks if smooth is not given else []):
        ax.plot(at * by_x, values * by_y, "o", ms=4, color=line.get_color())
    if answers:
        laws, p = smooth.answer["law"], smooth.answer["pressure_Pa"]
        for count, i in enumerate(np.flatnonzero(laws[1:] != laws[:-1])):
            at = np.sqrt(p[i] * p[i + 1]) * by_x
            ax.axvline(at, ls=":", lw=1, color="grey")
            for law, side, by in ((laws[i], "right", -3), (laws[i + 1], "left", 3))[count > 0 :]:
                place: Any = {"xy": (at, 0.02 + 0.05 * count), "xycoords": ax.get_xaxis_transform()}
                ax.annotate(law.replace("_", " "), ha=side, size="small", xytext=(by, 0), textcoords="offset points", **place)
    return ax


def draw_heights(ax: Axes | None, heights: Numbers, dx: float, dy: float) -> Axes:
    """Draws a profile, of which a long one keeps the extremes of every stretch, or a map with its colours; returns the axes."""
    import numpy as np

    ax = axes(ax)
    unit, by = unit_of(np.arange(max(heights.shape)) * dx, "m")
    unit_z, by_z = unit_of(heights, "m")
    ax.set_xlabel(f"x [{unit}]")
    if heights.ndim == 1:
        step = max(1, heights.size // 2000)
        stretches = heights[: heights.size // step * step].reshape(-1, step)
        few = np.stack([np.nanmin(stretches, axis=1), np.nanmax(stretches, axis=1)], axis=1).ravel() if step > 2 else heights
        ax.plot(np.linspace(0, heights.size * dx * by, few.size), few * by_z, lw=0.6)
        ax.set_ylabel(f"height [{unit_z}]")
        return ax
    step = -(-max(heights.shape) // 600)
    rows, columns = heights.shape
    image = ax.imshow(heights[::step, ::step] * by_z, extent=(0, columns * dx * by, rows * dy * by, 0), interpolation="nearest")
    ax.get_figure().colorbar(image, ax=ax, label=f"height [{unit_z}]")  # type: ignore[union-attr]
    ax.set_ylabel(f"y [{unit}]")
    return ax


def draw_bearing(ax: Axes | None, heights: Numbers) -> Axes:
    """Draws the height against the share of the surface above it."""
    import numpy as np

    ax = axes(ax)
    z = np.sort(heights[~np.isnan(heights)])[::-1]
    few = np.linspace(0, z.size - 1, min(z.size, 400)).astype(int)
    unit, by = unit_of(z, "m")
    ax.plot(100 * few / max(1, z.size - 1), z[few] * by)
    ax.set_xlabel("bearing area [%]")
    ax.set_ylabel(f"height [{unit}]")
    ax.grid(True)
    return ax


def draw_structure(ax: Axes | None, functions: Sequence[tuple[str, Mapping[str, Any]]]) -> Axes:
    """Draws structure functions; of those with a fit also the fitted curve and the window of the fit."""
    import numpy as np

    ax = axes(ax)
    (unit, by), (unit_y, by_y) = (
        unit_of(np.concatenate([of[key] for _, of in functions]) if functions else [], si) for key, si in (("lag_m", "m"), ("value_m2", "m^2"))
    )
    for name, of in functions:
        (line,) = ax.loglog(of["lag_m"] * by, of["value_m2"] * by_y, ".", ms=3, label=name or None)
        if "fitted_lag_m" in of:
            label = "D = " + with_unit(of["fractal_dimension"][0], "", 4, of["fractal_dimension"][1])
            ax.plot(of["fitted_lag_m"] * by, of["fitted_value_m2"] * by_y, color=line.get_color(), label=label)
            ax.axvspan(*(lag * by for lag in of["window_m"]), alpha=0.1, color=line.get_color(), lw=0)
    ax.set_xlabel(f"lag [{unit}]")
    ax.set_ylabel(f"structure function [{unit_y}]")
    ax.grid(True)
    if len(functions) > 1 or any("fitted_lag_m" in of for _, of in functions):
        ax.legend(fontsize="small")
    return ax


def draw_islands(ax: Axes | None, curve: Mapping[str, Any], key: str) -> Axes:
    """Draws the density of islands, or their radius, over the bearing area; a mark is at the densest level."""
    ax = axes(ax)
    share, at = 100 * curve["bearing_area"], int(curve["density_per_m2"].argmax())
    unit, factor = unit_of(curve[key], "/m^2" if key == "density_per_m2" else "m")
    label = f"islands [1{unit}]" if key == "density_per_m2" else f"radius of the mean island [{unit}]"
    ax.plot(share, curve[key] * factor)
    ax.plot(share[at], curve[key][at] * factor, "o", ms=4)
    ax.set_ylim(0, 4 * curve[key][at] * factor if key == "radius_m" else None)  # that of the few islands at the bottom is of no use
    ax.set_xlabel("bearing area [%]")
    ax.set_ylabel(label)
    ax.grid(True)
    return ax


def draw_spectrum(ax: Axes | None, columns: Mapping[str, Any], of: str) -> Axes:
    """Draws the first curve of a spectrum, of a psd as means over 2 % of q."""
    import numpy as np

    ax = axes(ax)
    (_, x), (key, y), *_ = columns.items()
    y = np.asarray(y, dtype=float)
    unit, by = unit_of(x if of == "acf" else 2 * np.pi / x, "m")
    if of == "acf":
        ax.plot(x * by, y)
        ax.set_xlabel(f"lag [{unit}]")
        ax.set_ylabel("autocorrelation")
    else:
        bins = np.unique((np.log(x / x[0]) / np.log(1.02)).round(), return_inverse=True)[1]
        few = [np.bincount(bins, values) / np.bincount(bins) for values in (x, y)]
        power = int(key[-1])
        ax.loglog(few[0] / by, few[1] * by**power)
        ax.set_xlabel(f"q [rad/{unit}]")
        ax.set_ylabel(f"C [{unit}{'³' if power == 3 else '⁴'}]")
    ax.grid(True)
    return ax


def draw_scales(ax: Axes | None, scales: Table[Any], of: str) -> Axes:
    """Draws K and the parameters over those with the chosen cut-offs, against one cut-off."""
    ax = axes(ax)
    other = "lambda_c_m" if of == "lambda_s" else "lambda_s_m"
    rows = [row for row in scales["scales"]["rows"] if row.get(other) == scales[other] and row.get(of + "_m")]
    rows.sort(key=lambda row: row[of + "_m"])
    unit, by = unit_of([row[of + "_m"] for row in rows], "m")
    chosen = next((row for row in rows if row[of + "_m"] == scales[of + "_m"]), rows[len(rows) // 2] if rows else {})
    for label, key in (("K", "stiffness_Pa_per_m"), ("σ", "rms_height_m"), ("gradient", "rms_gradient"),
                       ("R", "peak_radius_m"), ("D_p", "peak_density_per_m2")):  # fmt: skip
        known = [row for row in rows if row.get(key) and chosen.get(key)]
        if known:
            ax.loglog([row[of + "_m"] * by for row in known], [row[key] / chosen[key] for row in known], "o-", ms=3, label=label)
    ax.set_xlabel(f"{of} [{unit}]")
    ax.set_ylabel(f"ratio to the value at the chosen {of}")
    ax.grid(True)
    if ax.get_lines():
        ax.legend(fontsize="small")
    return ax


def draw_fits(ax: Axes | None, found: Table[Any]) -> Axes:
    """Draws a measured curve with its errors, and the curves that were fitted to it."""
    import numpy as np

    y = "reflection" if found["measured"]["quantity"] == "reflection" else "stiffness_Pa_per_m"
    fits = [fit for fit in found["fits"] if "curve" in fit]
    if not fits:
        raise ValueError("plot(): no law could be fitted")
    lines = [(fit["law"], fit["curve"]["pressure_Pa"], np.asarray(fit["curve"][y], dtype=float), None, None) for fit in fits]
    ax = draw(ax, "pressure_Pa", y, lines)
    rows = fits[0]["rows"]
    by_x, by_y = (heading(key, np.concatenate([line[i] for line in lines]))[1] for key, i in (("pressure_Pa", 1), (y, 2)))
    error = [row["error"] * by_y for row in rows] if found["measured"]["has_errors"] else None
    p, values = ([row[key] * by for row in rows] for key, by in (("pressure_Pa", by_x), (y, by_y)))
    import matplotlib

    ink = matplotlib.rcParams["text.color"]  # over the curves
    ax.errorbar(p, values, error, fmt="o", ms=3, color=ink, capsize=4, elinewidth=1.2, zorder=3, label="measured" + (", ± standard error" if error else ""))
    ax.legend(fontsize="small")
    return ax
