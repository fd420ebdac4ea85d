# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces as SurfaceTopography reads them have its own parameters, and the K of their file where fstiff reads that too.

FSTIFF_SAMPLES is a folder of files, such as test/file_format_examples of its repository; without it that of FSTIFF_SURFACES.
"""

import os
import pathlib
import warnings

import fstiff
import numpy as np
import pytest

module = pytest.importorskip("SurfaceTopography")
WHOLE = {"detrend": "none", "lambda_s": "none", "lambda_c": "none", "resamples": 2}


def of_neighbours(heights, steps):
    """Sdq from all pairs of neighbours; rms_gradient() of SurfaceTopography leaves out those of the last row and column."""
    return np.sqrt(sum(np.ma.mean((np.diff(heights, axis=axis) / step) ** 2) for axis, step in enumerate(steps)))


def of_seven_points(heights, step):
    """Rdq of ISO 4287; that of SurfaceTopography is of neighbours."""
    weights = np.array([-1, 9, -45, 0, 45, -9, 1]) / (60 * step)
    return np.sqrt(np.mean(np.convolve(heights, weights[::-1], "valid") ** 2))


def difference(topography):
    """Largest relative difference of a measurement from the numbers of SurfaceTopography, or from the definition where it has another;
    and what rounding allows: steps of heights far from zero have few digits left."""
    measured = fstiff.measure(topography, **WHOLE, **({"units": "m"} if topography.unit is None else {}))
    found = measured["roughness"]
    metres = topography if topography.unit is None else topography.to_unit("m")
    heights = np.ma.masked_invalid(metres.heights())
    steps = np.divide(metres.physical_sizes, metres.nb_grid_pts)
    mean = np.ma.mean(abs(heights - np.ma.mean(heights)))
    if topography.dim == 2:
        pairs = [(found["Sa_m"], mean), (found["Sq_m"], metres.Sq()), (found["Sdq"], of_neighbours(heights, steps))]
    else:
        pairs = [(found["Ra_m"], mean), (found["Rq_m"], metres.Rq()), (found["Rdq"], of_seven_points(heights, *steps))]
        if "rms_gradient" in measured["surface"]:  # of the isotropic surface
            pairs.append((measured.rms_gradient.value / 2**0.5, metres.Rdq()))
    rounding = np.finfo(float).eps * np.ma.max(abs(heights)) / np.ma.std(np.diff(heights, axis=0))
    return max(abs(own - theirs) / theirs for own, theirs in pairs), 1e-12 + rounding


@pytest.mark.parametrize("form", ["netcdf", "x3p", "gwy"])
def test_files_that_surface_topography_writes(rough_map, tmp_path, form):
    from SurfaceTopography.IO import open_topography

    file = tmp_path / f"map.{form}"
    getattr(module.Topography(rough_map.T * 1e6, physical_sizes=(96.0, 96.0), unit="µm"), f"to_{form}")(str(file))
    topography = open_topography(str(file)).topography()
    largest, allowed = difference(topography)
    assert largest <= allowed
    of_file, of_object = (fstiff.hybrid(fstiff.measure(one), [1e6, 1e7], effective_modulus=1e11).stiffness for one in (file, topography))
    np.testing.assert_allclose(of_object, of_file, rtol=1e-12)


def test_samples_have_the_numbers_of_surface_topography(root):
    from SurfaceTopography.IO import open_topography

    folder = pathlib.Path(os.environ.get("FSTIFF_SAMPLES") or os.environ.get("FSTIFF_SURFACES", root.parent / "shared/surfaces"))
    if not folder.is_dir():
        pytest.skip(f"there is no folder of samples {folder}")
    rows, refused = [], []
    for file in sorted(folder.iterdir()):
        try:
            reader = open_topography(str(file))
            channels = list(reader.channels)
        except Exception:  # of its readers, any
            continue
        for index, channel in enumerate(channels):
            sizes = {"physical_sizes": (1.0,) * channel.dim} if channel.physical_sizes is None else {}  # which a few files lack
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                try:
                    topography = reader.topography(channel_index=index, **sizes)
                    if not topography.is_uniform:
                        topography = topography.to_uniform(len(topography.positions()))
                    rows.append((*difference(topography), f"{file.name} {index}"))
                except ValueError as refusal:
                    refused.append(f"{file.name} {index}: {refusal}")
    files = {name.split()[0] for _, _, name in rows}
    print(*refused, *sorted(rows), f"{len(rows)} surfaces of {len(files)} files", sep="\n")
    assert len(rows) >= 7 and not [row for row in rows if not row[0] <= row[1]]
