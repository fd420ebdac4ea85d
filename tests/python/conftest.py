# SPDX-License-Identifier: BSD-3-Clause
"""What the tests compare with: the command, and numbers that the C++ library printed (tests/c/numbers.cpp)."""

import csv
import io
import json
import os
import pathlib
import subprocess

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Command:
    """The command of the same build."""

    def __init__(self, program):
        self.program = program

    def __call__(self, *arguments, allowed=(0, 4)):
        if arguments[0] in ("fit", "islands"):
            arguments = ("measure", "--show", *arguments)
        done = subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True)
        assert done.returncode in allowed, done.stderr
        return done.stdout

    def csv(self, *arguments):
        """Columns of texts."""
        rows = list(csv.reader(io.StringIO(self(*arguments, "--format", "csv"))))
        return {key: [row[i] for row in rows[1:]] for i, key in enumerate(rows[0])}

    def json(self, *arguments):
        return json.loads(self(*arguments, "--format", "json"))


@pytest.fixture(scope="session")
def command():
    program = os.environ.get("FSTIFF_COMMAND")
    if not program:
        pytest.skip("FSTIFF_COMMAND names no command to compare with")
    return Command(program)


@pytest.fixture(scope="session")
def numbers():
    """Key -> array of the numbers of C++."""
    file = os.environ.get("FSTIFF_NUMBERS")
    if not file:
        pytest.skip("FSTIFF_NUMBERS names no numbers to compare with")
    found = {}
    for line in pathlib.Path(file).read_text().splitlines():
        key, _, *values = line.split()
        found[key] = np.array([float.fromhex(value) for value in values])
    return found


@pytest.fixture(scope="session")
def root():
    return ROOT


@pytest.fixture(scope="session")
def rough_map():
    """A self-affine map (H = 0.7) of 96 x 64 points, 1 um x 1.5 um apart [m]."""
    random = np.random.default_rng(7)
    kx, ky = np.meshgrid(np.fft.fftfreq(96), np.fft.fftfreq(64) / 1.5)
    k = np.hypot(kx, ky)
    k[0, 0] = np.inf
    heights = np.fft.ifft2(k**-1.7 * np.fft.fft2(random.standard_normal((64, 96)))).real
    return heights / heights.std() * 1e-6


@pytest.fixture(scope="session")
def trace():
    """A random walk of 2048 points [m]."""
    return np.cumsum(np.random.default_rng(3).standard_normal(2048)) * 2e-8
