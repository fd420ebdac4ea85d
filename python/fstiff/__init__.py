# SPDX-License-Identifier: BSD-3-Clause
"""Normal contact stiffness of rough surfaces.

    import fstiff

    found = fstiff.answer(rms_height="0.8 um", rms_gradient=0.1, upper="steel", pressures=[1e6, 1e7])
    found.stiffness, found.low, found.high                      # K per area [Pa/m] with its 90 % band
    surface = fstiff.measure(heights, spacing=0.5e-6)           # a 1-D or 2-D array of heights [m], or a file
    contact = fstiff.Contact("hybrid", surface=surface, effective_modulus=112.6e9)
    stiffness = contact.at_pressures([1e6, 1e7]).stiffness      # K per area [Pa/m]
    curves = fstiff.run("scene.toml")                           # the columns of `fstiff run --format csv`

Every number is in SI units: m, Pa, Pa/m, rad. A length may be a text with its unit too, such as "0.5 um". What is wrong with
an argument is a ValueError with one sentence; FileError, a ValueError and an OSError, is for files.
"""

from __future__ import annotations

from ._answer import Answer
from ._answers import answer
from ._contacts import Contact, Law, Laws, Points, effective_modulus, hybrid, law_names, spot_conductance, tangential_ratio
from ._core import version as __version__
from ._errors import FileError
from ._integrals import Estimate, peak_integral
from ._measured_curves import Identification, Ultrasound, identify, ultrasound
from ._report import report
from ._scenes import Curves, Export, Scene, export, run
from ._spectra import Spectrum, generate, spectrum
from ._surfaces import Fit, Islands, Measurement, Parameter, Scales, Surface, Truth, fit, islands, measure, open_surface, truth
from ._sweeps import sweep

__all__ = [
    "Answer", "Contact", "Curves", "Estimate", "Export", "FileError", "Fit", "Identification", "Islands", "Law", "Laws",
    "Measurement", "Parameter", "Points", "Scales", "Scene", "Spectrum", "Surface", "Truth", "Ultrasound", "__version__",
    "answer", "effective_modulus", "export", "fit", "generate", "hybrid", "identify", "islands", "law_names", "measure",
    "open_surface", "peak_integral", "report", "run", "spectrum", "spot_conductance", "sweep", "tangential_ratio", "truth",
    "ultrasound",
]  # fmt: skip
