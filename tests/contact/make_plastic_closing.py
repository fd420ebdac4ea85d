#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes tests/data/plastic_closing.csv: contact of Gaussian maps whose pressures are cut at the hardness, by boundary elements.

    tests/contact/make_plastic_closing.py build/release/bin/fstiff                  prints the table
    tests/contact/make_plastic_closing.py build/release/bin/fstiff --check 20       compares every twentieth row: exit code 1 when
                                                                                    a stiffness differs by more than 1e-3

A map is (Hurst exponent, first and last wave number, seed, waves below the first): wave numbers count waves a side, of 256 points. The
rms gradient is 0.1. Stiffness is that of unloading times sigma over E g; separation is negative above about H/2.
"""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

TABLE = pathlib.Path(__file__).resolve().parent.parent / "data" / "plastic_closing.csv"
MAPS = ((.35, 8, 48, 301, 1), (.65, 8, 32, 302, 0), (.75, 16, 48, 303, 1), (.55, 8, 48, 304, 0), (.8, 8, 40, 305, 1), (.25, 12, 48, 306, 1),
        (.7, 8, 32, 307, 1), (.2, 8, 32, 308, 0))
HARDNESS = (.02, .1, .3, .7, 1.5, 3)  # over E g
LOADS = (.001, .003, .01, .03, .1, .2, .33, .5, .67, .8, .9, .95)  # over H, up to 0.74 E g
GRADIENT, POINTS = .1, 256
STEP = f"{1 / POINTS} m"


def heights(hurst, first, last, seed, plateau):
    """The map on the unit square, its rms height and alpha."""
    k = np.fft.fftfreq(POINTS, 1 / POINTS)
    q = np.hypot(*np.meshgrid(k, k, indexing="ij"))
    wave = np.fft.fft2(np.random.default_rng(seed).standard_normal((POINTS, POINTS)))
    wave *= np.where((q >= (1 if plateau else first)) & (q <= last), np.maximum(q, first) ** -(1 + hurst), 0)
    power = np.abs(wave) ** 2 / POINTS ** 4
    wave *= GRADIENT / np.sqrt(np.sum((2 * np.pi * q) ** 2 * power))
    m0, m2, m4 = (np.sum((2 * np.pi * q) ** n * np.abs(wave) ** 2) / POINTS ** 4 for n in (0, 2, 4))
    return np.fft.ifft2(wave).real, np.sqrt(m0), 1.5 * m0 * m4 / m2 ** 2


def rows(program, surface):
    z, sigma, alpha = heights(*surface)
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "map.npy"
        np.save(path, z)
        for hardness in HARDNESS:
            loads = [load for load in LOADS if load * hardness <= .74]
            pressures = ",".join(f"{load * hardness * GRADIENT:.17g} Pa" for load in loads)
            found = subprocess.run([program, "truth", path, "--units", "m", "--dx", STEP, "--dy", STEP, "--modulus", "1 Pa", "--edges",
                                    "periodic", "--detrend", "mean", "--lambda-s", "none", "--hardness", f"{hardness * GRADIENT:.17g} Pa",
                                    "--pressures", pressures, "--format", "json"], check=False, capture_output=True, text=True).stdout
            for load, row in zip(loads, json.loads(found)["rows"], strict=True):
                yield (*surface[:4], f"{alpha:.4g}", hardness, load, f"{row['stiffness_Pa_per_m'] * sigma / GRADIENT:.5g}",
                       f"{row['real_area_fraction']:.5g}", f"{row['separation_m'] / sigma:.5g}", row["contacts"])


def main(program, _="", every=""):
    known = list(csv.DictReader(TABLE.open()))
    if not every:
        print(",".join(known[0]))
    worst = 0
    for i, row in enumerate(row for surface in MAPS for row in rows(program, surface)):
        if not every:
            print(*row, sep=",")
        elif i % int(every) == 0:
            worst = max(worst, abs(float(row[7]) / float(known[i]["stiffness_sigma_over_Eg"]) - 1))
    if every:
        print(f"largest difference {worst:.1e}")
    return worst > 1e-3


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
