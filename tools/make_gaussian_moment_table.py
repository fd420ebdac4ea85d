#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes include/fstiff/math/gaussian_moment_table.hpp: short polynomials, piece by piece, for F_a(x) and erf.

    F_a(x) = int_0^inf v^a exp(-(v+x)^2/2) dv = Gamma(a+1) exp(-x^2/4) D_{-a-1}(x)

    pieces 0 to 31    |x| + 2 in [2, 4), [4, 8), [8, 16), [16, 32), each octave in eight equal parts, x >= 0:
                      exp(x^2/2) F_a(x)              in powers of s = |x| - middle of the piece
    piece 32          x >= 30: exp(x^2/2) F_a(x) x^(a+1) in powers of s = 1/x^2
    pieces 33 to 64   as 0 to 31, x < 0: F_a(x)
    piece 65          x <= -30: F_a(x) / |x|^a       in powers of s = 1/x^2
    erf, inner          y in [0, 5/2]: erf(y)/y        in powers of u, from -1 to 1 as y^2 goes through its range
    erf, middle, outer  y in [5/2, 9/2], [9/2, 13/2]: erf(y) in powers of u = y - middle of the range

Each function is interpolated in Chebyshev points with 50 digits and cut to the terms of double (erf: to its error, and once
more to 3e-5). A coefficient is printed with as many digits as count at the end of its piece. `cut[n]` is
the largest relative error, over all pieces and powers, of the first n terms alone.

Needs mpmath. Usage: tools/make_gaussian_moment_table.py [--check]; --check compares with the file instead of writing it
(without mpmath it prints SKIPPED).
"""
import pathlib
import sys
from itertools import zip_longest

try:
    from mpmath import binomial, cos, erf, exp, floor, gamma, log10, mp, mpf, nstr, pcfd, pi, sqrt
except ImportError:
    print("SKIPPED: there is no mpmath (Debian package python3-mpmath)")
    sys.exit(0 if "--check" in sys.argv else 1)

mp.dps = 50
TARGET = pathlib.Path(__file__).resolve().parent.parent / "include/fstiff/math/gaussian_moment_table.hpp"
POWERS = ((0, "0"), (1, "1/2"), (2, "1"), (3, "3/2"), (-1, "-1/2"), (5, "5/2"))  # the first four are the contact integrals'
PER_OCTAVE, OCTAVES = 8, 4
END = 2 ** (OCTAVES + 1) - 2  # |x| from which on the last piece serves
ERF_NEAR, ERF_MIDDLE, ERF_FAR = mpf(5) / 2, mpf(9) / 2, mpf(13) / 2
ERF_ROUGH = mpf("3e-5")
DIGITS, TERMS, ERF_ERROR = 18, 12, mpf("4e-17")  # of double


def moment(a, x):
    return gamma(a + 1) * exp(-x * x / 4) * pcfd(-a - 1, x)


def far(a, s, side):
    """Asymptotic in s = 1/x^2, 1e-30 at s = 1/900: right (side 1) the sum of (-1)^n (a+1)_2n Gamma(a+1) (s/2)^n/n!, left (side -1) of
    (-a)_2n sqrt(2 pi) (s/2)^n/n!, which leaves out what is exp(-x^2/2) smaller."""
    total, term = mpf(0), gamma(a + 1) if side > 0 else sqrt(2 * pi)
    first = a + 1 if side > 0 else -a
    for n in range(60):
        total += term
        following = -side * term * (first + 2 * n) * (first + 1 + 2 * n) * s / (2 * (n + 1))
        if abs(following) >= abs(term):
            break
        term = following
    return total


def chebyshev(f, low, high, points=26):
    middle, half = (low + high) / 2, (high - low) / 2
    angles = [pi * (k + mpf(1) / 2) / points for k in range(points)]
    values = [f(middle + half * cos(t)) for t in angles]
    c = [2 * sum(v * cos(j * t) for v, t in zip(values, angles)) / points for j in range(points)]
    c[0] /= 2
    return c


def powers(c):
    """Coefficients of u^0, u^1, ... of the Chebyshev series c."""
    previous, current, out = [mpf(1)], [mpf(0), mpf(1)], [mpf(0)] * len(c)
    out[0] += c[0]
    for j in range(1, len(c)):
        for i, t in enumerate(current):
            out[i] += c[j] * t
        previous, current = current, [t - u for t, u in zip_longest([mpf(0), *(2 * t for t in current)], previous, fillvalue=mpf(0))]
    return out


def piece(f, low, high, start_at_low=False):
    """Coefficients in powers of the distance from the middle (from \\p low), and the relative errors of cutting them."""
    half = (high - low) / 2
    exact = chebyshev(f, low, high)
    local = powers(exact[:TERMS])
    size = abs(local[0])
    out, reach = [c / half**n for n, c in enumerate(local)], half
    if start_at_low:  # powers of u = (s - half)/half into powers of s
        reach = high - low
        out = [sum(c * binomial(n, i) * (-1) ** (n - i) for n, c in enumerate(local)) / half**i for i in range(TERMS)]
    sizes = [abs(c) * reach**n / size for n, c in enumerate(out)]
    last = sum(abs(c) for c in exact[TERMS:]) / size
    return out, [sum(sizes[n:]) + last for n in range(TERMS)] + [last], sizes


def text(c, size):
    wanted = DIGITS if size == 0 else max(2, min(DIGITS, int(floor(DIGITS + 1.5 + log10(size)))))
    return nstr(c, wanted, min_fixed=0, max_fixed=0) if c != 0 else "0.0"


def pieces_of(a):
    width = mpf(1) / PER_OCTAVE
    for side in (1, -1):
        for i in range(PER_OCTAVE * OCTAVES):
            octave = mpf(2) ** (1 + i // PER_OCTAVE)
            low = octave * (1 + i % PER_OCTAVE * width) - 2
            high = low + octave * width
            of = (lambda x: exp(x * x / 2) * moment(a, x)) if side > 0 else (lambda x: moment(a, -x))
            yield piece(of, low, high)
        yield piece(lambda s: far(a, s, side), mpf(0), mpf(1) / END**2, start_at_low=True)


def rows(columns):
    """A line a piece: its coefficients power by power, side by side for the functions of \\p columns."""
    lines = []
    for at_piece in zip(*columns):
        numbers = [text(c[0][n], c[2][n]) for n in range(TERMS) for c in at_piece]
        lines.append("        " + ", ".join(numbers) + ",\n")
    return "".join(lines)


def erf_range(f, low, high, error):
    """Powers of u in [-1, 1] of a Chebyshev series that leaves out less than \\p error of the largest value."""
    c = chebyshev(f, low, high, 44)
    n = len(c)
    while n > 1 and sum(abs(x) for x in c[n - 1 :]) < error:
        n -= 1
    kept = powers(c[:n])
    return n, ", ".join(text(x, abs(x / kept[0])) for x in kept)


def erf_arrays(error, name):
    over_y = lambda square: 2 / sqrt(pi) if square == 0 else erf(sqrt(square)) / sqrt(square)
    out = ""
    for part, f, low, high, size in (("inner", over_y, mpf(0), ERF_NEAR**2, error * erf(ERF_NEAR) / ERF_NEAR),
                                     ("middle", erf, ERF_NEAR, ERF_MIDDLE, error), ("outer", erf, ERF_MIDDLE, ERF_FAR, error)):
        n, body = erf_range(f, low, high, size)
        out += f"    static constexpr std::array<double, {n}> {name}{part}{{{body}}};\n"
    return out


def table():
    columns = [list(pieces_of(mpf(twice) / 2)) for twice, _ in POWERS]
    main, side = columns[:4], columns[4:]
    size = 2 * (PER_OCTAVE * OCTAVES + 1)
    cut = ", ".join(nstr(max(p[1][n] for c in main for p in c) * mpf("1.01"), 3) for n in range(TERMS + 1))
    return (
        "/// main: a = 0, 1/2, 1, 3/2 side by side; side: a = -1/2, 5/2\nstruct MomentTable {\n"
        f"    static constexpr int terms = {TERMS};\n"
        f"    static constexpr std::array<double, {TERMS + 1}> cut{{{cut}}};\n"
        f"    alignas(64) static constexpr double main[{size} * {TERMS} * 4] = {{\n"
        f"{rows(main)}    }};\n"
        f"    static constexpr double side[{size} * {TERMS} * 2] = {{\n"
        f"{rows(side)}    }};\n}};\n\n"
        f"struct ErfTable {{\n{erf_arrays(ERF_ERROR, '')}"
        f"    static constexpr double rough_error = {nstr(ERF_ROUGH, 2)};\n"
        f"{erf_arrays(ERF_ROUGH, 'rough_')}}};\n")


def main():
    out = (
        "// SPDX-License-Identifier: BSD-3-Clause\n#pragma once\n"
        "/// \\file\n/// Coefficients of gaussian_moment.hpp and of error_function.hpp, made by tools/make_gaussian_moment_table.py, which\n"
        "/// names the pieces and the variables.\n\n"
        "#include <fstiff/core/config.hpp>\n\n#include <array>\n\nnamespace fstiff { inline namespace v0_1 { namespace math {\n\n// clang-format off\n"
        f"{table()}// clang-format on\n\n}}}}}}  // namespace fstiff::math\n")
    if "--check" not in sys.argv:
        TARGET.write_text(out)
    elif TARGET.read_text() != out:
        sys.exit(f"{TARGET.name} is not what this script makes")


if __name__ == "__main__":
    main()
