#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes include/fstiff/math/gaussian_moment_table.hpp: polynomials for F_a(x) and erf.

    F_a(x) = int_0^inf v^a exp(-(v+x)^2/2) dv = Gamma(a+1) exp(-x^2/4) D_{-a-1}(x)

Each function is interpolated in Chebyshev points with 50 digits, cut where the rest of the series falls below the tolerance
of the scalar type, and turned into powers of a variable u in [-1, 1]:

    right   x >= 0        exp(x^2/2) F_a(x) (x+4)^(a+1)    u = (x-4)/(x+4)
    middle  -5 <= x <= 0  F_a(x)                           u = (2x+5)/5
    far     x <= -5       F_a(x) / |x|^a                   u = 2 (5/x)^2 - 1
    series  0 <= y <= 2   erf(y)/y                         u = y^2/2 - 1
    tail    y >= 2        exp(y^2) (1-erf(y)) (y+2)        u = (y-4)/(y+4) mapped to [-1, 1]

Needs mpmath. Usage: tools/make_gaussian_moment_table.py [--check]; --check compares with the file instead of writing it.
"""
import pathlib
import sys

from mpmath import cos, erf, erfc, exp, gamma, mp, mpf, nstr, pcfd, pi, sqrt

mp.dps = 50
TARGET = pathlib.Path(__file__).resolve().parent.parent / "include/fstiff/math/gaussian_moment_table.hpp"
SCALARS = (("float", mpf("1.5e-8"), 12), ("double", mpf("6e-17"), 21), ("long double", mpf("1e-20"), 25))
POWERS = ((-1, "-1/2"), (0, "0"), (1, "1/2"), (2, "1"), (3, "3/2"), (5, "5/2"))
POINTS = 72


def moment(a, x):
    return gamma(a + 1) * exp(-x * x / 4) * pcfd(-a - 1, x)


def asymptotic(a, x):
    """exp(x^2/2) F_a(x) x^(a+1) for large x: sum of (-1)^n (a+1)_2n Gamma(a+1) / (n! (2 x^2)^n)."""
    total, term = mpf(0), gamma(a + 1)
    for n in range(30):
        total += term
        term *= -(a + 1 + 2 * n) * (a + 2 + 2 * n) / ((n + 1) * 2 * x * x)
    return total


def right(a):
    def f(u):
        x = 4 * (1 + u) / (1 - u)
        if x > 60:
            return asymptotic(a, x) * ((x + 4) / x) ** (a + 1)
        return exp(x * x / 2) * moment(a, x) * (x + 4) ** (a + 1)

    return f


def middle(a):
    return lambda u: moment(a, 5 * (u - 1) / 2)


def far(a):
    def f(u):
        v = (1 + u) / 2
        if v < mpf("0.002"):  # |x| > 111: the exponentially small part is gone, the algebraic series is exact to 50 digits
            total, term, x2 = mpf(0), sqrt(2 * pi), 25 / v
            for n in range(40):
                total += term
                term *= (a - 2 * n) * (a - 2 * n - 1) / ((n + 1) * 2 * x2)
            return total
        x = 5 / sqrt(v)
        return moment(a, -x) / x**a

    return f


def series(u):
    y = sqrt(2 * (1 + u))
    return 2 / sqrt(pi) if y == 0 else erf(y) / y


TAIL_LOW = mpf(-1) / 3  # (2-4)/(2+4)


def tail(u):
    w = TAIL_LOW + (1 - TAIL_LOW) * (1 + u) / 2
    y = 4 * (1 + w) / (1 - w)
    if y > 60:
        return asymptotic(0, y * sqrt(mpf(2))) / sqrt(pi) * (y + 2) / y
    return exp(y * y) * erfc(y) * (y + 2)


def chebyshev(f):
    angles = [pi * (k + mpf(1) / 2) / POINTS for k in range(POINTS)]
    values = [f(cos(t)) for t in angles]
    c = [2 * sum(v * cos(j * t) for v, t in zip(values, angles)) / POINTS for j in range(POINTS)]
    c[0] /= 2
    return c


def powers(c):
    """Coefficients of u^0, u^1, ... of the Chebyshev series c."""
    previous, current = [mpf(1)], [mpf(0), mpf(1)]
    out = [mpf(0)] * len(c)
    out[0] += c[0]
    for j in range(1, len(c)):
        for i, t in enumerate(current):
            out[i] += c[j] * t
        doubled = [mpf(0)] + [2 * t for t in current]
        for i, t in enumerate(previous):
            doubled[i] -= t
        previous, current = current, doubled
    return out


def cut(c, tolerance, scale):
    n = len(c)
    while n > 1 and sum(abs(x) for x in c[n - 1 :]) < tolerance * scale:
        n -= 1
    return c[:n]


def array(name, c, scalar, tolerance, digits, smallest):
    kept = powers(cut(c, tolerance, smallest))
    suffix = {"float": "F", "double": "", "long double": "L"}[scalar]
    body = ", ".join(nstr(x, digits, min_fixed=0, max_fixed=0) + suffix for x in kept)
    return f"    static constexpr std::array<{scalar}, {len(kept)}> {name}{{{body}}};\n"


def main():
    table = {}
    for twice, _ in POWERS:
        a = mpf(twice) / 2
        for name, make in (("right", right), ("middle", middle), ("far", far)):
            f = make(a)
            table[twice, name] = chebyshev(f), min(abs(f(u)) for u in (mpf(-1) + mpf(10) ** -30, mpf(0), 1 - mpf(10) ** -30))
    for name, f in (("series", series), ("tail", tail)):
        table[name] = chebyshev(f), min(abs(f(u)) for u in (mpf(-1), mpf(0), 1 - mpf(10) ** -30))

    out = [
        "// SPDX-License-Identifier: BSD-3-Clause\n#pragma once\n",
        "/// \\file\n/// Polynomial coefficients of gaussian_moment.hpp and of its erf, lowest power first. Made by\n",
        "/// tools/make_gaussian_moment_table.py, which names the variables; the cut-off of each series is below\n",
        "/// " + ", ".join(f"{nstr(t, 2)} ({s})" for s, t, _ in SCALARS) + " relative.\n\n",
        "#include <array>\n\nnamespace fstiff::detail {\n\n// clang-format off\n",
        "template <class T, int TwiceA> struct MomentTable;\ntemplate <class T> struct ErfTable;\n\n",
    ]
    for scalar, tolerance, digits in SCALARS:
        for twice, label in POWERS:
            out.append(f"template <> struct MomentTable<{scalar}, {twice}> {{  // a = {label}\n")
            for name in ("right", "middle", "far"):
                c, smallest = table[twice, name]
                out.append(array(name, c, scalar, tolerance, digits, smallest))
            out.append("};\n")
        out.append(f"template <> struct ErfTable<{scalar}> {{\n")
        for name in ("series", "tail"):
            c, smallest = table[name]
            # the tail is subtracted from 1, where it is at most 0.005: a looser cut keeps its error below the rounding of 1
            out.append(array(name, c, scalar, tolerance * (100 if name == "tail" else 1), digits, smallest))
        out.append("};\n\n")
    out.append("// clang-format on\n\n}  // namespace fstiff::detail\n")
    text = "".join(out)
    if "--check" in sys.argv:
        if TARGET.read_text() != text:
            sys.exit(f"{TARGET.name} is not what this script makes")
    else:
        TARGET.write_text(text)


if __name__ == "__main__":
    main()
