# SPDX-License-Identifier: BSD-3-Clause
"""Spectra, densities of peaks, and surfaces of known D or H."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from . import _core
from ._pictures import draw_spectrum
from ._results import frame, lines_of, shown
from ._surfaces import Document, Surface, of_any_form, one_source, options_of, surface_of

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.axes import Axes
    from typing_extensions import Unpack

    from ._surfaces import Length, Source, SurfaceOptions


class Spectrum(Document):
    """The power spectral density or the autocorrelation: the keys of the JSON of `fstiff measure --show spectrum`."""

    @property
    def of(self) -> str:
        """"psd" or "acf", which is the key of the columns."""
        return str(self["inputs"]["of"])

    def to_dataframe(self) -> pd.DataFrame:
        """The columns of the CSV; of a map all directions, the sections along x and along y. NaN fills the shorter ones."""
        return frame(dict(self[self.of])).astype(float)

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws the curve of all directions, of a profile the only one; returns the axes."""
        return draw_spectrum(ax, self[self.of], self.of)

    def __repr__(self) -> str:
        columns = self[self.of]
        return (
            f"<fstiff.Spectrum of {self['source']['file']}: {self.of}, {len(next(iter(columns.values())))} rows>\n"
            f"  columns: {', '.join(columns)}" + lines_of(self.warnings)
        )


class Peaks(Document):
    """The density of peak heights and curvatures: the keys of the JSON of `fstiff measure --show peaks`."""

    def to_dataframe(self) -> pd.DataFrame:
        """The density of the height alone, where `heights` asked for it."""
        if "heights" not in self:
            raise ValueError('heights: must be given to peaks(), such as "-4,4,81"')
        return frame(dict(self["heights"]))

    def __repr__(self) -> str:
        numbers = ("r", "theta", "peak_ratio", "mean_height", "height_variance")
        return f"<fstiff.Peaks from {self['from']}: " + ", ".join(f"{key} = {shown(self[key], 5)}" for key in numbers) + ">"


@of_any_form
def spectrum(
    surface: Source,
    *,
    of: Literal["psd", "acf"] = "psd",
    taper: Literal["hann", "none"] = "hann",
    **options: Unpack[SurfaceOptions],
) -> Spectrum:
    """The power spectral density or the autocorrelation of a profile or a map, as `fstiff measure --show spectrum` computes it.

    `taper` is the window of a psd, "none" for a surface that repeats itself. `surface` and `options` are those of measure().
    """
    return Spectrum(_core.spectrum(*one_source(**locals())))


def peaks(
    profile: Source | None = None,
    *,
    r: float | None = None,
    theta: float | str | None = None,
    exponential: bool = False,
    rho1: float | None = None,
    rho2: float | None = None,
    heights: str | tuple[float, float, int] | None = None,
    **options: Unpack[SurfaceOptions],
) -> Peaks:
    """The density of peak heights and curvatures, its moments and the density of the height alone, as `fstiff measure --show peaks` gives them.

    profile       as the surface of measure(), with its `options`; or one of:
    r, theta      correlation of heights and curvatures, and the angle of the sampling [rad], or a text such as "pi/4"
    exponential   with theta: r is that of an exponential autocorrelation
    rho1, rho2    autocorrelation at one sampling step and at two
    heights       (from, to, count), in rms heights: where the density of the height is computed
    """
    rest = heights if heights is None or isinstance(heights, str) else ",".join(repr(one) for one in heights)
    own = {"r": r, "theta": theta, "exponential": exponential, "rho1": rho1, "rho2": rho2, "heights": rest}
    if profile is None:
        return Peaks(_core.peaks(options_of({**options, **own}), None))
    return Peaks(_core.peaks(*one_source(profile, options, **own)))


def generate(
    kind: Literal["wm", "profile", "map"],
    spacing: Length,
    *,
    points: int | None = None,
    rows: int | None = None,
    dimension: float | None = None,
    roughness: Length | None = None,
    gamma: float | None = None,
    hurst: float | None = None,
    rms: Length | None = None,
    longest: Length | None = None,
    shortest: Length | None = None,
    long_waves: Literal["plateau", "none"] | None = None,
    seed: int | None = None,
) -> Surface:
    """A surface of known D or H, with the heights that `fstiff generate` writes; its decisions name all parameters.

    kind                 "wm": Weierstrass-Mandelbrot profile; "profile", "map": self-affine Gaussian, periodic
    points, rows         of a row, and how many rows of a map: 4096 of a profile, 256 x 256 of a map
    dimension, roughness, gamma    of a wm profile: D, G and the ratio of neighbouring wavelengths, 1.5
    hurst, rms, long_waves         of the others: H, Rq or Sq, and the waves beyond the longest one
    longest, shortest    wavelengths: the longest side and two spacings
    """
    arrays, origin = _core.generate(options_of(locals()))
    surface = surface_of(arrays, kind)
    surface.decisions = [origin]
    return surface
