#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the two scanned faces of a made-up fracture: lower.ply and upper.ply, 24 mm x 24 mm, in mm, z upwards.

    examples/rock/make_faces.py

Both faces share waves of 3 mm and longer, as the halves of one break do. What they do not share is rough down to 0.8 mm, and open
by a smooth gap. The points of each scan lie at random, 6400 a face.
"""
import pathlib

import numpy as np

SIDE, POINTS = 24.0, 6400


def waves(random, x, y, longest, shortest, rms, hurst=0.8, count=60):
    """A self-affine sum of cosines."""
    length = np.exp(random.uniform(np.log(shortest), np.log(longest), count))
    turn, phase = random.uniform(0, np.pi, count), random.uniform(0, 2 * np.pi, count)
    height = length**hurst
    height *= rms / np.sqrt(np.sum(height**2) / 2)
    q = 2 * np.pi / length
    return np.cos(np.outer(x, q * np.cos(turn)) + np.outer(y, q * np.sin(turn)) + phase) @ height


def face(number, own):
    """Random points of the face: \"own\" is the sign of what it does not share, 0.5 of it each."""
    x, y = np.random.default_rng(number).uniform(0, SIDE, (2, POINTS))
    shared = waves(np.random.default_rng(10), x, y, 30, 3, 0.4)
    rough = waves(np.random.default_rng(20), x, y, 4, 0.8, 0.02)
    gap = 0.2 + 0.03 * np.cos(2 * np.pi * x / 30) * np.cos(2 * np.pi * y / 26)
    return np.c_[x, y, shared + own * (rough + gap) / 2]


if __name__ == "__main__":
    for name, number, own in (("lower", 1, -1), ("upper", 2, 1)):
        head = f"ply\nformat binary_little_endian 1.0\ncomment made up, in mm\nelement vertex {POINTS}\n"
        head += "property float x\nproperty float y\nproperty float z\nend_header\n"
        (pathlib.Path(__file__).parent / f"{name}.ply").write_bytes(head.encode() + face(number, own).astype("<f4").tobytes())
