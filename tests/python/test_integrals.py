# SPDX-License-Identifier: BSD-3-Clause
"""Integrals over the peaks: against closed forms, mpmath and the example in C++; refusals and errors."""

import math
import subprocess
import sys

import numpy as np
import pytest

import fstiff

PEAKS = {"r": 0.5, "theta": 1.0}


def test_closed_forms_and_mpmath():
    for eta in (-2.0, 0.5, 3.0):  # r = 0: the heights are normal, and do not depend on the curvature
        share = fstiff.peak_integral(lambda e, t: np.ones_like(e), r=0, theta=1, eta=eta)
        assert abs(share.value - math.erfc(eta / math.sqrt(2)) / 2) <= share.error < 1e-11
    # quad() of mpmath in two dimensions, 25 digits
    grows = fstiff.peak_integral(lambda e, t: np.expm1(e) * t, eta=1, **PEAKS)
    assert abs(grows.value - 0.46732994754542622249) <= grows.error < 1e-12
    gone = fstiff.peak_integral(lambda e, t: e * t, eta=60, **PEAKS)
    assert gone.value == 0 and 0 < gone.error < 1e-300


def test_the_function_is_called_with_all_nodes_of_a_pass():
    sizes = []

    def function(e, t):
        assert e.shape == t.shape and e.dtype == t.dtype == np.float64 and (e > 0).all() and (t > 0).all()
        sizes.append(e.size)
        e *= 0  # the arrays are the function's own
        return t

    found = fstiff.peak_integral(function, eta=0, **PEAKS)
    assert len(sizes) < 10 and sum(sizes) == found.evaluations


def test_kinks_are_named_or_unknown():
    def step(e, t):
        return np.where(e < 0.4, 0.0, 1.0)

    truth = fstiff.peak_integral(lambda e, t: np.ones_like(e), eta=1.4, **PEAKS)
    told = fstiff.peak_integral(step, kink=lambda t: 0.4, eta=1, relative_tolerance=1e-9, **PEAKS)
    untold = fstiff.peak_integral(step, kink="unknown", eta=1, **PEAKS)
    assert abs(told.value - truth.value) <= told.error <= 1e-9 * truth.value
    assert 1e-6 * truth.value < untold.error and abs(untold.value - truth.value) <= untold.error


@pytest.mark.parametrize(
    ("function", "more", "sentence"),
    [
        (lambda e, t: 1.0, {}, r"must be an array of the shape of its arguments, \(\d+,\), not \(\)"),
        (lambda e, t: e[1:], {}, "must be an array of the shape of its arguments"),
        (lambda e, t: 1j * e, {}, "must be real numbers, not complex128"),
        (lambda e, t: np.where(e > 1, np.nan, e), {}, r"function\(.*\) = nan: must be finite"),
        (lambda e, t: e, {"r": 1}, "r = 1: must be at least 0 and less than 1"),
        (lambda e, t: e, {"eta": math.nan}, "eta = nan: must be"),
        (lambda e, t: e, {"relative_tolerance": 0}, "relative_tolerance = 0: must be"),
        (lambda e, t: e, {"kink": "none"}, 'kink = "none": must be'),
        (lambda e, t: e, {"kink": lambda t: math.nan}, r"kink\(.*\) = nan: must be a number"),
    ],
)
def test_what_cannot_be_integrated_is_refused(function, more, sentence):
    with pytest.raises(ValueError, match=sentence):
        fstiff.peak_integral(function, **({"eta": 0} | PEAKS | more))


def test_errors_of_the_function_pass():
    def fails(*_):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        fstiff.peak_integral(fails, eta=0, **PEAKS)
    with pytest.raises(KeyError, match="mine"):
        fstiff.peak_integral(lambda e, t: e, kink=fails, eta=0, **PEAKS)


def test_the_example_prints_what_is_beside_it(root):
    folder = root / "examples" / "python"
    done = subprocess.run([sys.executable, str(folder / "integral_of_a_function.py")], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert done.stdout == (folder / "integral_of_a_function.txt").read_text()


def test_the_example_in_cpp_has_the_same_load(root):
    """examples/integral/yielding.txt: the same function at the same separations, within its error."""

    def yielding(e, t):
        before = np.minimum(e, 0.5 / t)
        return np.sqrt(before / t) * (before + 1.5 * (e - before))

    rows = (root / "examples" / "integral" / "yielding.txt").read_text().splitlines()[1:]
    for r, theta, eta, _, _, value, error, *_ in (map(float, row.split(",")) for row in rows):
        found = fstiff.peak_integral(yielding, kink=lambda t: 0.5 / t, r=r, theta=theta, eta=eta, relative_tolerance=1e-9)
        assert found.value == pytest.approx(value, rel=0, abs=error)
