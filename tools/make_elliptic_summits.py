# SPDX-License-Identifier: BSD-3-Clause
"""Makes tests/data/elliptic_summits.csv and elliptic_summits_stiffness.csv: the summits of periodic maps, with derivatives of all
waves, and K of their sum of elliptic contacts, each alone. Needs numpy and mpmath.

    python tools/make_elliptic_summits.py tests/data MAP=FILE.npy ...      heights over the unit square, E = 1

F2 by mpmath from Johnson, Contact Mechanics (1985), eqs. (4.25)-(4.26), with 30 digits; p(d) is inverted by bisection.
"""
import csv
import sys

import mpmath as mp
import numpy as np

mp.mp.dps = 30


def approach_factor(ratio):
    """F2 of k2/k1 = ratio."""
    if ratio > 1 - mp.mpf(10) ** -12:
        return mp.mpf(1)

    def integrals(s):
        m = 1 - s * s
        return m, mp.ellipk(m), mp.ellipe(m)

    def difference(log_s):
        s = mp.exp(log_s)
        _, first, second = integrals(s)
        return mp.log((first - second) / (second / s**2 - first)) - mp.log(ratio)

    s = mp.exp(mp.findroot(difference, 2 * mp.log(ratio) / 3))
    m, first, second = integrals(s)
    size = mp.cbrt(4 / (mp.pi * m) * s ** mp.mpf(1.5) * mp.sqrt((second / s**2 - first) * (first - second)))
    return 2 / mp.pi * mp.sqrt(s) * first / size


def summits_of(heights):
    """Rows of height, k1, k2: tops of the paraboloids at points above their eight neighbours, k2/k1 > 1e-3."""
    k = 2 * np.pi * np.fft.fftfreq(len(heights), 1 / len(heights))
    waves, kx, ky = np.fft.fft2(heights), k[:, None], k[None, :]
    higher = np.ones(heights.shape, bool)
    for i in (-1, 0, 1):
        for j in (-1, 0, 1):
            if i or j:
                higher &= heights > np.roll(heights, (i, j), (0, 1))
    fx, fy, fxx, fyy, fxy = (np.fft.ifft2(waves * w).real[higher] for w in (1j * kx, 1j * ky, -kx**2, -ky**2, -kx * ky))
    mean, half, det = -(fxx + fyy) / 2, np.hypot((fxx - fyy) / 2, fxy), fxx * fyy - fxy**2
    rise = -(fyy * fx**2 - 2 * fxy * fx * fy + fxx * fy**2) / det / 2
    rows = np.c_[heights[higher] + rise, mean + half, mean - half]
    return sorted((r for r in rows if r[2] > 1e-3 * r[1] and r[1] > 0), key=lambda r: -r[0])


def stiffness(rows, factors, pressure):
    heights = np.array([r[0] for r in rows])

    def load(d):
        return (factors * np.maximum(heights - d, 0) ** 1.5).sum()

    low, high = heights[-1] - 1, heights[0]
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if load(middle) > pressure else (low, middle)
    return 1.5 * (factors * np.sqrt(np.maximum(heights - low, 0))).sum()


def main():
    folder, maps = sys.argv[1], [argument.split("=") for argument in sys.argv[2:]]
    with open(folder + "/elliptic_summits.csv", "w", newline="") as one, \
            open(folder + "/elliptic_summits_stiffness.csv", "w", newline="") as two:
        points, table = csv.writer(one, lineterminator="\n"), csv.writer(two, lineterminator="\n")
        points.writerow(["map", "height", "max_curvature", "min_curvature"])
        table.writerow(["map", "p_over_E", "stiffness_times_L_over_E"])
        for name, file in maps:
            rows = summits_of(np.load(file).astype(float))
            for row in rows:
                points.writerow([name] + [f"{v:.17g}" for v in row])
            factors = np.array([float(4 / mp.mpf(3) * (mp.mpf(a) * mp.mpf(b)) ** (-mp.mpf(1) / 4)
                                      * approach_factor(mp.mpf(b) / mp.mpf(a)) ** (-mp.mpf(3) / 2)) for _, a, b in rows])
            for pressure in (3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 2.5e-2):
                table.writerow([name, f"{pressure:g}", f"{stiffness(rows, factors, pressure):.15g}"])


main()
