# SPDX-License-Identifier: BSD-3-Clause
"""Arrays with the ends of their bands."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt


class Values(np.ndarray):
    """An array with the ends of its 90 % band, `low` and `high`; None where it has none. What is computed of it has none."""

    low: npt.NDArray[np.float64] | None
    high: npt.NDArray[np.float64] | None

    def __new__(cls, values: Any, low: Any = None, high: Any = None) -> Values:
        made = np.asarray(values).view(cls)
        made.low, made.high = low, high
        return made

    def __array_finalize__(self, _: Any) -> None:
        self.low = self.high = None

    def __getitem__(self, place: Any) -> Any:
        part = np.asarray(self)[place]
        ends = (None if end is None else end[place] for end in (self.low, self.high))
        return Values(part, *ends) if isinstance(part, np.ndarray) else part

    def __reduce__(self) -> tuple[Any, ...]:
        return Values, (np.asarray(self), self.low, self.high)
