# SPDX-License-Identifier: BSD-3-Clause
"""Spectra, and surfaces of known D or H."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from . import _core
from ._pictures import draw_spectrum
from ._results import frame, lines_of
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
