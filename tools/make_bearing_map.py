# SPDX-License-Identifier: BSD-3-Clause
"""Writes tests/data/bearing_map_honed.f32: 256 x 256 heights of a honed surface over the unit square, 32-bit floats.

    z = min(a, 0.3) + 0.12 b, smoothed at wave number 40, scaled to the rms gradient 0.1

a and b are Gaussian maps of rms 1 with H = 0.8: a from wave number 1 to 24 a side, flat below 8, b from 1 to 32, flat
below 16. Needs numpy, whose generator PCG64 and ziggurat are part of the map.

    python tools/make_bearing_map.py tests/data/bearing_map_honed.f32
"""
import sys

import numpy as np

POINTS = 256


def gaussian(rolloff, shortest, seed):
    k = np.fft.fftfreq(POINTS, 1 / POINTS)
    q = np.hypot(k[:, None], k[None, :])
    amplitude = np.where((q >= 1) & (q <= shortest), np.maximum(q, rolloff) ** -1.8, 0.0)
    noise = np.random.default_rng(seed).standard_normal((POINTS, POINTS))
    z = np.fft.ifft2(np.fft.fft2(noise) * amplitude).real
    z -= z.mean()
    return z / z.std()


def honed(seed):
    k = np.fft.fftfreq(POINTS, 1 / POINTS)
    q = np.hypot(k[:, None], k[None, :])
    z = np.minimum(gaussian(8, 24, seed), 0.3) + 0.12 * gaussian(16, 32, seed + 50000)
    z = np.fft.ifft2(np.fft.fft2(z) * np.exp(-((q / 40) ** 8))).real
    waves = np.fft.fft2(z) / POINTS**2
    gradient = np.sqrt(((2 * np.pi * q * abs(waves)) ** 2).sum())
    return (z - z.mean()) * (0.1 / gradient)


honed(7150).astype("<f4").tofile(sys.argv[1])
