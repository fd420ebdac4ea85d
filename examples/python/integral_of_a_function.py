# SPDX-License-Identifier: BSD-3-Clause
"""The load of peaks that yield, by an integral of a function of one's own over the peaks of a surface.

A peak whose excess height is e and whose curvature is t, over the rms height and the rms curvature, bears e^1.5/sqrt(t) by Hertz.
Beyond e = 1/(2t) it yields: the load follows the tangent. The load of the surface is the sum over its peaks.
"""

import numpy as np

import fstiff


def kink(t):
    return 0.5 / t


def elastic(e, t):
    return e * np.sqrt(e / t)


def yielding(e, t):
    before = np.minimum(e, kink(t))
    return np.sqrt(before / t) * (before + 1.5 * (e - before))


peaks = {"r": 0.5, "theta": np.pi / 3}
print("separation   share in contact   elastic load   load with yield   error")
for eta in (0, 1, 2, 3, 4):
    share = fstiff.peak_integral(lambda e, t: np.ones_like(e), eta=eta, **peaks)
    hertz = fstiff.peak_integral(elastic, eta=eta, **peaks)
    load = fstiff.peak_integral(yielding, kink=kink, eta=eta, relative_tolerance=1e-9, **peaks)
    covered = "below 1e-9" if load.error < 1e-9 * load.value else "above 1e-9"
    print(f"{eta:10} {share.value:18.5e} {hertz.value:14.5e} {load.value:17.5e}   {covered}")
