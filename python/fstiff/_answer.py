# SPDX-License-Identifier: BSD-3-Clause
"""What answer() and run() return of the answer: one stiffness for each pressure, with a band."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from . import _core
from ._contacts import Law, laws_of, pressures_before
from ._errors import word
from ._results import Columns, count_of, draw, frame, heading, lines_of, number, shown, shown_rows, text_table

if TYPE_CHECKING:
    import numpy.typing as npt
    import pandas as pd
    from matplotlib.axes import Axes

    from ._contacts import Laws, Outside
    from ._results import Numbers

KEYS = ("pressure_Pa", "stiffness_Pa_per_m", "stiffness_p05_Pa_per_m", "stiffness_p95_Pa_per_m")


class Answer(Columns):
    """K of a scene, of one joint or of many: a mapping from keys of `fstiff run --format json` to arrays, of the joints by the pressures.

    "pressure_Pa", "stiffness_Pa_per_m", the ends of its 90 % band "stiffness_p05_Pa_per_m" and "stiffness_p95_Pa_per_m", "law",
    "p_star", "contacts", "approach_m", "loading_stiffness_Pa_per_m" and the quantities that were asked for; NaN and "" where
    there is none. A single joint has arrays of the shape of the pressures; a scene has the pressures that have a K.

    causes         the share that each cause has of the band, by its name
    reasons        why a point has no K, by its index
    concerns       words for what does not hold, a list for each joint
    doubtful       for each joint, whether the command would end with exit code 4
    rows           of a scene, `answer` of the JSON; empty of joints
    ball           of a scene with contact.ball_radius, the contact under each force as a dict
    explanation    of a scene, at most three sentences: which stiffness it is, which law gave it, what makes its band
    outside_band   of a scene, what the band does not hold
    """

    rows: list[dict[str, Any]] = []
    ball: list[dict[str, float]] = []
    explanation: list[str] = []
    outside_band: str = ""
    _table: list[list[str]] | None = None

    def __init__(
        self,
        values: dict[str, npt.NDArray[Any]],
        causes: dict[str, npt.NDArray[Any]],
        of_laws: dict[str, dict[str, Any]],
        doubtful: Any,
        reasons: Mapping[tuple[int, ...], str] | None = None,
        concerns: list[list[str]] | None = None,
    ) -> None:
        import numpy as np

        self._values, self.causes = values, causes
        self.reasons: dict[tuple[int, ...], str] = dict(reasons or {})
        self.concerns: list[list[str]] = concerns or []
        self.doubtful: npt.NDArray[np.bool_] = np.asarray(doubtful, dtype=bool)
        self._of_laws = of_laws

    @classmethod
    def of_scene(cls, found: dict[str, Any], document: dict[str, Any]) -> Answer:
        """That of what _core returned of a scene, and its `document`."""
        import numpy as np

        rows: list[dict[str, Any]] = document["answer"]
        keys = dict.fromkeys(key for row in rows for key in row if key != "causes")
        values = {key: np.asarray([row.get(key, np.nan) for row in rows]) for key in keys}
        names = dict.fromkeys(name for row in rows for name in row["causes"])
        causes = {name: np.asarray([row["causes"].get(name, 0.0) for row in rows]) for name in names}
        of_laws = found["of_laws"] | {"facts": {key: column.reshape(()) for key, column in found["of_laws"]["facts"].items()}}
        answer = cls(values, causes, of_laws, found["doubtful"])
        answer.rows, answer.ball, answer._table = rows, document.get("ball", []), found["answer_table"]
        answer.explanation, answer.outside_band = document["explanation"], document["outside_band"]
        return answer

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
        return Law(self._laws([], quantile, min_pressure, max_pressure, joint, outside)[0])

    def loading_law(
        self,
        quantile: float = 0.5,
        min_pressure: float | None = None,
        max_pressure: float | None = None,
        *,
        joint: int | tuple[int, ...] = (),
        outside: Outside = "refuse",
    ) -> Law:
        """The law of the first loading, by which a joint is tightened: p over the separation, and K of unloading from it; as law_at() else."""
        return Law(self._laws([0.0], quantile, min_pressure, max_pressure, joint, outside)[0])

    def law_after(
        self,
        greatest_pressure: npt.ArrayLike,
        quantile: float = 0.5,
        min_pressure: float | None = None,
        max_pressure: float | None = None,
        *,
        joint: int | tuple[int, ...] = (),
        outside: Outside = "refuse",
    ) -> Law | Laws:
        """The law of a joint that has carried `greatest_pressure` [Pa]: reversible below it, along loading_law() above; as law_at() else.

        Of an array one law for each pressure, as Laws: of the elements of a mesh, from their prestress by loading_law(), with which they
        share separations. Friction takes them. Of an elastic answer each is law_at(). A map is asked with its greatest_pressure, which
        boundary elements then flatten; it is that of the law, and one of the pressures.
        """
        greatest = pressures_before(greatest_pressure)
        if not all(p > 0 for p in greatest):
            raise ValueError("greatest_pressure: must be greater than 0")
        return laws_of(self._laws(greatest, quantile, min_pressure, max_pressure, joint, outside), greatest_pressure)

    def _laws(
        self,
        greatest: list[float],
        quantile: float,
        min_pressure: float | None,
        max_pressure: float | None,
        joint: int | tuple[int, ...],
        outside: Outside,
    ) -> list[_core.Law]:
        import numpy as np

        points, facts = self._of_laws["points"], self._of_laws["facts"]
        shape = facts["rms_height"].shape
        try:
            of_joint = {key: column[joint] for key, column in facts.items()}
        except IndexError as error:
            raise ValueError(f"joint = {joint!r:.60}: {error}") from None
        if np.ndim(of_joint["rms_height"]):
            raise ValueError(f"joint: must be the index of one of the joints, whose shape is {shape}")
        rows = {key: np.ascontiguousarray(column.reshape(*shape, -1)[joint]) for key, column in points.items()}
        known = rows["pressure"][~np.isnan(rows["value"])]
        least, most = (known.min(), known.max()) if known.size else (np.nan, np.nan)
        bounds = (
            number(least if min_pressure is None else min_pressure, "min_pressure"),
            number(most if max_pressure is None else max_pressure, "max_pressure"),
        )
        numbers_of = {key: float(value) for key, value in of_joint.items()}
        return _core.Law.of_answer(rows, numbers_of, greatest, number(quantile, "quantile"), *bounds, word(outside, "outside"))

    def to_dataframe(self) -> pd.DataFrame:
        """The columns as a data frame of pandas, one row for each joint and pressure."""
        return frame({key: column.ravel() for key, column in self.items()})

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws K over the pressure with its band, a line for each joint; returns the axes. Curves.plot() has more pressures."""
        import numpy as np

        count = self.pressure.shape[-1] if self.pressure.ndim else 1
        columns = (np.reshape(self[key], (-1, count)) for key in KEYS)
        return draw(ax, *KEYS[:2], [("", *line) for line in zip(*columns)])

    def __repr__(self) -> str:
        if self._table is not None:
            sentences = [*self.explanation, self.outside_band] if self.rows else ["no law answers"]
            return f"<fstiff.Answer>\n{text_table(self._table)}" + "".join(f"\n{one}" for one in sentences)
        return self._of_joints()

    def _of_joints(self) -> str:
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
        return f"<fstiff.Answer: {count_of(self)}>\n{text_table(shown_rows(columns, 3))}{which}" + lines_of(doubts + reasons)
