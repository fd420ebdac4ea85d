# SPDX-License-Identifier: BSD-3-Clause
"""Integrals over the peaks of a surface."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Literal, NamedTuple

from . import _core
from ._results import number, numbers

if TYPE_CHECKING:
    from ._results import Numbers


class Estimate(NamedTuple):
    """A computed number: its value, a bound on its error, and at how many points the function was evaluated."""

    value: float
    error: float
    evaluations: int


def peak_integral(
    function: Callable[[Numbers, Numbers], Numbers],
    *,
    r: float,
    theta: float,
    eta: float,
    kink: Callable[[float], float] | Literal["unknown"] | None = None,
    relative_tolerance: float = 2e-12,
) -> Estimate:
    """The integral of function(excess, t) over the peaks above the separation `eta`, in rms heights.

    int_0^inf dt int_eta^inf dzeta function(zeta - eta, t) p_peak(zeta, t): the mean over all peaks, to which those below `eta`
    add nothing. 1 gives the share of the peaks above `eta`; times the density of peaks it is the sum per nominal area.

    `function` takes two arrays of one shape (n,), all nodes of a pass, and returns n numbers: excess height over the rms height
    and curvature over the rms curvature, both greater than 0. It is smooth but for powers at 0, varies over 0.2 and more, and
    grows at most as exp(4 (excess + t)). `kink` is the excess at which it has a kink or a jump, as a function of one t, which
    is called once for a row of nodes; "unknown" where it has some that cannot be named. `r` and `theta` [rad] are those of the
    peaks, 0 <= r < 1 and 0 < theta < pi/2.

    Errors that `function` raises pass. ValueError: it returns another shape, or what is not finite; an argument is out of range.
    The value aims at `relative_tolerance`, 1.2e-14 to 0.1, and the error covers what is reached. Reference: the density (4.4) of
    Buczkowski, Kleiber and Starzynski (2014); docs/theory-numerics.md.
    """
    import numpy as np

    def values(excess: Numbers, t: Numbers) -> Numbers:
        found = numbers(function(excess, t), "what the function returns")
        if found.shape != t.shape:
            raise ValueError(f"what the function returns: must be an array of the shape of its arguments, {t.shape}, not {found.shape}")
        if not np.isfinite(found).all():
            i = int(np.argmin(np.isfinite(found)))
            raise ValueError(f"function({excess[i]:.6g}, {t[i]:.6g}) = {found[i]}: must be finite for every excess and t above 0")
        return found

    if isinstance(kink, str) and kink != "unknown":
        raise ValueError(f'kink = "{kink}": must be a function of t, "unknown" or None')
    of = [number(one, name) for one, name in ((r, "r"), (theta, "theta"), (eta, "eta"), (relative_tolerance, "relative_tolerance"))]
    of_kink = None if kink is None or isinstance(kink, str) else _checked(kink)
    return Estimate(*_core.peak_integral(values, of_kink, kink == "unknown", *of))


def _checked(kink: Callable[[float], float]) -> Callable[[float], float]:
    """`kink`, of which NaN is refused."""

    def excess(t: float) -> float:
        found = float(kink(t))
        if found != found:
            raise ValueError(f"kink({t:.6g}) = nan: must be a number")
        return found

    return excess
