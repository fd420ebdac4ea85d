# SPDX-License-Identifier: BSD-3-Clause
"""Scenes and their curves."""

from __future__ import annotations

import contextlib
import json
import os
import re
from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, Literal, Union

from . import _core
from ._answer import Answer
from ._contacts import Contact
from ._errors import named, word
from ._pictures import draw_curves
from ._results import Columns, Table, frame, heading, lines_of, shown, text_table, whole, with_unit
from ._surfaces import measured_of, options_of, with_surface
from ._units import as_text, has_units

if TYPE_CHECKING:
    import numpy.typing as npt
    import pandas as pd
    from matplotlib.axes import Axes
    from typing_extensions import TypeAlias

    from ._surfaces import Measurable

    Given: TypeAlias = Union[str, os.PathLike[str], Mapping[str, Any], None]
    Face: TypeAlias = Union[str, os.PathLike[str], Measurable, None]


class Curves(Columns):
    """The curves of a scene: a mapping from the column names of `fstiff run --format csv` to arrays.

    The numbers are those of the CSV, digit for digit; all curves are one below the other. `law` is an array of texts. An empty
    cell of the CSV, of a quantity that the law does not give, is NaN, as pandas reads it.

    answer              one stiffness for each pressure, with its band, its law and its causes
    warnings            sentences on what may not hold
    explanation         which stiffness the answer is, which law gave it, and what makes its band
    effective_modulus   [Pa]
    doubtful            the command would have ended with exit code 4
    """

    def __init__(self, found: dict[str, Any], scene: Scene) -> None:
        import numpy as np

        self._scene, self._found = scene, found
        self._values = {key: np.asarray(column) for key, column in found["columns"]}
        self._bands: dict[str, tuple[str, str]] = found["bands"]
        self._curves: list[tuple[str, float | None, float | None, int]] = found["curves"]
        self.name = scene.name
        self.warnings: list[str] = found["warnings"]
        self.answer = Answer.of_scene(found, json.loads(found["document"]))
        self.explanation = self.answer.explanation
        self._best: bool = found["best"]
        self.effective_modulus: float = found["effective_modulus"]
        self.doubtful: bool = found["doubtful"]

    def parts(self) -> list[tuple[str, dict[str, npt.NDArray[Any]]]]:
        """Every curve by itself: its title and its columns."""
        parts, begin = [], 0
        for law, theta, r, size in self._curves:
            title = law if theta is None or r is None else f"{law}, theta = {theta:.4g}, r = {r:.4g}"
            parts.append((title, {key: column[begin : begin + size] for key, column in self.items()}))
            begin += size
        return parts

    def to_dataframe(self) -> pd.DataFrame:
        """The columns as a data frame of pandas: what pandas reads of the CSV."""
        return frame(dict(self))

    def smooth(self) -> Curves:
        """The same with more pressures between those of the scene, for a picture; itself where there are enough."""
        finer = self._scene._core.finer()
        return self if finer.points.size == self._scene._core.points.size else Curves(finer.run(), self._scene)

    def plot(self, y: str = "stiffness_Pa_per_m", x: str = "pressure_Pa", ax: Axes | None = None) -> Axes:
        """Draws column `y` of every curve over column `x`, with its band, and K of the answer; returns the axes.

        The lines are those of smooth(), the marks are at the pressures of the scene. A dotted line is where the law of the answer
        changes.
        """
        return draw_curves(self, self.smooth(), y, x, ax)

    def __repr__(self) -> str:
        key = "stiffness_Pa_per_m" if "stiffness_Pa_per_m" in self else list(self)[-1]
        label, factor = heading(key, self[key])
        rows = [["curve", "points", "from", "to", f"from {label}", "to"]]
        for title, columns in self.parts():
            p, k = columns["pressure_Pa"], columns[key] * factor
            ends = [with_unit(p[0], "Pa"), with_unit(p[-1], "Pa"), shown(k[0]), shown(k[-1])] if p.size else ["-"] * 4
            rows.append([title, str(p.size), *ends])
        laws = "" if self._best else f"{text_table(rows)}\n"  # the curve of the answer is above
        return (
            f"<fstiff.Curves of {self.name}>\nanswer: {self.answer!r}\n{laws}  columns: {', '.join(self)}"
            + lines_of(self.warnings)
        )


def _toml(value: Any, key: str, depth: int = 0) -> str:
    """A dict as TOML; `key` is the path to `value` in messages."""
    if depth > 50:
        raise ValueError(f"{key[:60]}...: must not be nested more than 50 deep")
    if isinstance(value, Table):
        raise ValueError(f"{key}: must not be a {type(value).__name__}; surface= takes what measure() returned")
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if has_units(value):
        value = as_text(value, key)
    elif hasattr(value, "tolist"):  # of NumPy
        value = value.tolist()
    if isinstance(value, str):
        return json.dumps(word(value, key), ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, int) and abs(value) < 2**63:
        return str(int(value))
    if isinstance(value, float):
        return repr(float(value))
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_toml(one, f"{key}[{i}]", depth + 1) for i, one in enumerate(value)) + "]"
    if not isinstance(value, Mapping):
        raise ValueError(f"{key} = {value!r:.60}: must be a number, a text, a list, or a dict of them")
    lines = []
    for name, one in value.items():
        path = f"{key}.{name}" if depth else f"{key}: {name}"
        if not isinstance(name, str):
            raise ValueError(f"{path}: its name must be a text")
        if one is not None:
            lines.append(f"{_toml(name, path)} = {_toml(one, path, depth + 1)}")
    return "{" + ", ".join(lines) + "}" if depth else "\n".join([*lines, ""]) or "\n"


def text_or_file(scene: Given) -> tuple[str, str]:
    """The text of what Scene() takes and "", or "" and its file."""
    if scene is None:
        return _core.builtin_scene, ""
    if isinstance(scene, Mapping):
        return _toml(scene, "scene"), ""
    return (word(scene, "scene"), "") if isinstance(scene, str) and "\n" in scene else ("", named(scene, "scene"))


@contextlib.contextmanager
def lines_of_text(scene: Given) -> Iterator[None]:
    """Leaves the number of the line out of what is wrong with a dict, which has none."""
    try:
        yield
    except ValueError as error:
        if not isinstance(scene, Mapping):
            raise
        raise type(error)(re.sub(r"^scene:\d+: ", "scene: ", str(error))) from None


class Scene:
    """A scene (docs/scene.md): what is in contact, and what is asked.

    scene     a file, or the text of one: a str with a line end is a text; or a dict with the keys of one, as its TOML has them,
              in which None is a key that is left out; None is the built-in scene
    surface   in place of [surface] and contact.peaks: a file of a surface, what measure() returned, an object with units of its own
              that measure() takes, or a list of such objects or of files, which are pooled

    What is wrong with it raises ValueError, with its line and key.
    """

    def __init__(self, scene: Given = None, *, surface: Face = None) -> None:
        text, file = text_or_file(scene)
        surface = measured_of(surface)
        self._made_of = (text if isinstance(scene, Mapping) else scene, surface)
        if file:
            self._core = with_surface(lambda *face: _core.Scene.of_file(file, *face), surface)
            return
        name = "built-in scene" if scene is None else "scene"
        with lines_of_text(scene):
            self._core = with_surface(lambda *face: _core.Scene.of_text(text, name, *face), surface)

    @property
    def name(self) -> str:
        return self._core.name

    @property
    def laws(self) -> list[str]:
        """The laws of the scene."""
        return self._core.laws

    def run(self) -> Curves:
        """Everything the scene asks for; Ctrl-C ends it."""
        return Curves(self._core.run(), self)

    def contact(self, law: str | None = None, peaks: int = 0) -> Contact:
        """The contact of the scene with the law called `law` (None: its first; any, of a scene that names none), on entry `peaks` of contact.peaks, from 0."""
        peaks = whole(peaks, "peaks", 0, 10**6)
        contact = Contact.__new__(Contact)
        contact._core = self._core.contact("" if law is None else word(law, "law"), peaks)
        contact._recipe = (_contact_of, (*self._made_of, law, peaks))
        return contact

    def __reduce__(self) -> tuple[Callable[..., Scene], tuple[Any, ...]]:
        return _scene_of, self._made_of

    def __repr__(self) -> str:
        points = self._core.points
        what, unit = ("separations", "m") if self._core.at_separations else ("pressures", "Pa")
        ends = " to ".join(with_unit(float(points[i]), unit) for i in (0, -1))
        return f"<fstiff.Scene {self.name}: {', '.join(self.laws)} at {points.size} {what} of {ends}>"


def _scene_of(scene: Any, surface: Any) -> Scene:
    return Scene(scene, surface=surface)


def _contact_of(scene: Any, surface: Any, law: str | None, peaks: int) -> Contact:
    return Scene(scene, surface=surface).contact(law, peaks)


def run(scene: Scene | Given = None, *, surface: Face = None) -> Curves:
    """The curves of a scene, a file, a text or a dict, as `fstiff run` computes them; see Scene and Curves."""
    return scene_of(scene, surface).run()


def scene_of(scene: Scene | Given, surface: Face) -> Scene:
    """The scene that a function was given, or what Scene() takes."""
    if not isinstance(scene, Scene):
        return Scene(scene, surface=surface)
    if surface is not None:
        raise ValueError("surface: must not be given for a Scene, which has its own")
    return scene


class Export(str):
    """The text that `fstiff export` writes: a contact of a finite-element program, or a tabulated law.

    warnings   sentences on what may not hold
    doubtful   the command would have ended with exit code 4
    """

    warnings: list[str]
    doubtful: bool


def export(
    scene: Scene | Given = None,
    to: Literal["calculix", "abaqus", "moose", "comsol", "law"] = "calculix",
    *,
    units: str | None = None,
    tolerance: float | str | None = None,
    slope_tolerance: float | str | None = None,
    pressures: tuple[float | str, float | str] | None = None,
    law: str | None = None,
    quantile: float | str | None = None,
    after: float | str | None = None,
    peaks: int = 1,
    at: float | str | None = None,
    surface: Face = None,
) -> Export:
    """The law of a scene as the contact law of a finite-element program, as `fstiff export` writes it.

    scene      a Scene, or what Scene() takes with `surface`
    to         the program; "law": the tabulated law itself, for Law.from_text
    units      of the model: length, force and pressure, "mm,N,MPa" by default
    tolerance  largest error of the pressure between two rows, 0.01 by default
    slope_tolerance  of the slope between two rows, which is K of an elastic law, 0.02 by default
    pressures  from and until which the table reaches [Pa]; the least and the greatest of the scene by default
    law        of the scene, its first that gives a separation by default; "answer": the law whose slope is the K of the answer
    quantile   of K of the answer, for law "answer": 0.05 or 0.95, the ends of its band, or 0.5, the default
    after      greatest pressure that the joint has carried [Pa], for law "answer": reversible below it, along the first loading above
    peaks      which of contact.peaks, from 1 on
    at         pressure whose tangential stiffness a card of friction holds [Pa]; the middle of the range in decades by default
    """
    given: dict[str, Any] = {"to": to, "units": units, "law": law, "after": after, "peaks": peaks, "at": at}
    for key, share in (("tolerance", tolerance), ("slope_tolerance", slope_tolerance), ("quantile", quantile)):
        given[key] = repr(share) if isinstance(share, (int, float)) else share
    given["from"], given["until"] = pressures or (None, None)
    made, warnings, doubtful = _core.export(scene_of(scene, surface)._core, options_of(given))
    text = Export(made)
    text.warnings, text.doubtful = warnings, doubtful
    return text
