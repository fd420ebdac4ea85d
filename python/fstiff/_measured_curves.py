# SPDX-License-Identifier: BSD-3-Clause
"""Measured curves of stiffness or reflection: what they are of a scene, and what a reflection is of a stiffness."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, Union

from . import _core
from ._errors import named, words
from ._pictures import draw_fits
from ._results import frame, lines_of, numbers, shown, text_table, with_unit
from ._scenes import Scene, scene_of
from ._surfaces import Document, options_of
from ._units import si_unit

if TYPE_CHECKING:
    import numpy.typing as npt
    import pandas as pd
    from matplotlib.axes import Axes
    from typing_extensions import TypeAlias

    from ._scenes import Face, Given

    Curve: TypeAlias = Union[str, os.PathLike[str], Mapping[str, npt.ArrayLike]]
    Amount: TypeAlias = Union[float, str]

#: The columns of a curve in memory.
COLUMNS = ("pressure", "frequency", "stiffness", "reflection", "error")


def _curve(given: Mapping[str, Any]) -> _core.Curve:
    """A curve in memory: the columns of a file by their names, in SI, and "error" of either."""
    unknown = set(given) - set(COLUMNS)
    places = "pressure" in given or ("frequency" in given and "reflection" in given)
    if unknown or not places or ("stiffness" in given) == ("reflection" in given):
        raise ValueError(
            "measured: must have the columns pressure (frequency may take its place, or be next to it, for reflections), "
            "one of stiffness and reflection, and error if it is known"
        )
    key = "reflection" if "reflection" in given else "stiffness"

    def column(name: str, unit: str) -> Any:
        return numbers(given[name], name, unit) if name in given else None

    pressures = numbers(given["pressure"], "pressure") if "pressure" in given else None
    return _core.curve(pressures, numbers(given[key], key), column("error", si_unit(key)), key == "reflection", column("frequency", "Hz"))


class Identification(Document):
    """Parameters of a scene from a measured curve, a fit for each law and peak density: the keys of the JSON of `fstiff identify`."""

    def to_dataframe(self) -> pd.DataFrame:
        """A parameter of a fit a row."""
        return frame([{"law": fit["law"], "theta": fit.get("theta"), "r": fit.get("r"), **one} for fit, one in self._parameters()])

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws the measured points with their errors, and the curves that were fitted; returns the axes."""
        return draw_fits(ax, self)

    def _parameters(self) -> list[tuple[dict[str, Any], dict[str, Any]]]:
        return [(fit, one) for fit in self["fits"] for one in fit["parameters"]]

    def __repr__(self) -> str:
        rows = [["fit", "status", "parameter", "value"]]
        for fit, one in self._parameters():
            value = one.get("value")
            shown_value = "-" if value is None else with_unit(value, one["unit"], 5, one.get("standard_error") or 0.0)
            rows.append([fit["law"], fit["status"], one["name"], shown_value])
        return f"<fstiff.Identification from {self['measured']['file']}>\n{text_table(rows)}" + lines_of(self.warnings)


class Ultrasound(Document):
    """What a wave does at an interface: the keys of the JSON of `fstiff ultrasound`."""

    def to_dataframe(self) -> pd.DataFrame:
        """The stiffness of a measured curve, a pressure a row."""
        if "rows" not in self:
            raise ValueError("reflection: only a measured curve has rows")
        return frame(self["rows"])

    def __repr__(self) -> str:
        if "rows" in self:
            return f"<fstiff.Ultrasound of {self['file']['name']}: {len(self['rows'])} rows>" + lines_of(self.warnings)
        return f"<fstiff.Ultrasound: K = {with_unit(self['stiffness_Pa_per_m'], 'Pa/m', 5)}, |R| = {shown(self['reflection'], 5)}>"


def identify(
    scene: Scene | Given,
    measured: Curve,
    fit: Sequence[str],
    *,
    law: str | None = None,
    wave: Literal["longitudinal", "shear"] = "longitudinal",
    barton_bandis: bool = False,
    surface: Face = None,
) -> Identification:
    """Parameters of a scene from a measured stiffness or reflection against pressure, as `fstiff identify` fits them.

    scene      a Scene, or what Scene() takes with `surface`
    measured   a file, or a mapping with the columns "pressure" [Pa], "stiffness" [Pa/m] or "reflection", and "error" if known
    fit        names of parameters, such as ["sigma", "Dp"] or, of hybrid, ["sigma", "g"]; the others keep their values
    law        law to fit; by default contact.laws; without it plastic if the peaks yield, else hybrid
    wave       the kind of wave whose reflections were measured
    barton_bandis   fits K_n0 and V_m of a rock joint too: the key "barton_bandis" of the result
    """
    made = scene_of(scene, surface)
    own: dict[str, Any] = {"fit": words(fit, "fit"), "law": law, "wave": wave, "barton_bandis": barton_bandis or None}
    if isinstance(measured, (str, os.PathLike)):
        return Identification(_core.identify(made._core, options_of({**own, "measured": named(measured, "measured")}), None))
    return Identification(_core.identify(made._core, options_of(own), _curve(measured)))


def ultrasound(
    *,
    stiffness: Amount | None = None,
    reflection: float | Curve | None = None,
    reflection_error: float | None = None,
    film_stiffness: Amount | None = None,
    frequency: Amount | None = None,
    material: str | None = None,
    impedance: Amount | None = None,
    density: Amount | None = None,
    velocity: Amount | None = None,
    material2: str | None = None,
    impedance2: Amount | None = None,
    density2: Amount | None = None,
    velocity2: Amount | None = None,
    wave: Literal["longitudinal", "shear"] | None = None,
) -> Ultrasound:
    """The reflection of an interface from its stiffness, or back, as `fstiff ultrasound` computes them.

    stiffness          K per nominal area [Pa/m]; or
    reflection         |R| of displacement amplitudes, or a curve as identify() takes it, which becomes K(p)
    reflection_error   standard error of |R|, where no curve has its own
    film_stiffness     of a fluid film in parallel with K [Pa/m]: its bulk modulus over its thickness
    frequency          [Hz]; a curve may have its own
    material           of the body that the wave comes from, such as "steel"; or
    impedance          of that body [kg/(m^2 s)]; or its density [kg/m^3] and velocity of sound [m/s]
    material2 ...      of the body beyond; by default those of the first body
    wave               the kind of wave, for the speed of sound of a material
    """
    own = dict(locals())
    curve = _curve(own.pop("reflection")) if isinstance(reflection, Mapping) else None
    if isinstance(reflection, (str, os.PathLike)):
        own["reflection"] = named(reflection, "reflection")
    return Ultrasound(_core.ultrasound(options_of(own), curve))
