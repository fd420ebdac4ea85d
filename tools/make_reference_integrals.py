#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the values of tests/data/integrals_plain.csv, integrals_hard.csv, integrals_scaled.csv (times exp(eta^2/2) where eta > 0) and
gw_gaussian.csv from the definition, by other means than fstiff:

    J[a,b](eta; r, theta) = c^a/(2 theta) int_0^inf t^b erf(k t) exp(-t^2/2) F_a((eta - r t)/c) dt,  c^2 = 1 - r^2
    F_a(x) = int_0^inf v^a exp(-(v+x)^2/2) dv = Gamma(a+1) exp(-x^2/4) D_{-a-1}(x),                  k = tan(theta)/sqrt 2
    G_n(h) = F_n(h)/sqrt(2 pi)

t = s^2 makes the integrand an entire function of s, which Gauss-Legendre panels integrate, halved until a panel and its two
halves agree. D is mpmath's parabolic cylinder function, or its asymptotic series where that is good to exp(-x^2/2) < 1e-45.
Each is accepted where the two differ by less than 1e-31 of the integral (1e-21 with --check).

    tools/make_reference_integrals.py                       writes the tables anew (half an hour)
    tools/make_reference_integrals.py --check [ROWS]        compares that many integrals, by default 40, and all of G_n, to 20
                                                            digits; writes nothing

Needs mpmath; without it --check prints SKIPPED. Inputs are read as the exact doubles that the tables print.
"""
import csv
import pathlib
import random
import sys

from generated import legendre

try:
    from mpmath import erf, erfc, exp, floor, gamma, log10, mp, mpf, nstr, pcfd, pi, sqrt, tan
except ImportError:
    print("SKIPPED: there is no mpmath (Debian package python3-mpmath)")
    sys.exit(0 if "--check" in sys.argv else 1)

DATA = pathlib.Path(__file__).resolve().parent.parent / "tests" / "data"
SCALED = "integrals_scaled.csv"
TABLES = ("integrals_plain.csv", "integrals_hard.csv", SCALED)
MOMENTS = "gw_gaussian.csv"
POWERS = ((0, 0), (mpf(1) / 2, -mpf(1) / 2), (mpf(3) / 2, -mpf(1) / 2), (1, -1))  # (a, b), of all rows
POINTS = 24


def moment(a, x):
    """F_a(x)."""
    if x < -14.5:  # the asymptotic series: sum of (-a)_2n sqrt(2 pi) |x|^a / ((2 x^2)^n n!)
        total, term = mpf(0), sqrt(2 * pi) * (-x) ** a
        for n in range(200):
            total += term
            term *= (a - 2 * n) * (a - 2 * n - 1) / (2 * (n + 1) * x * x)
            if abs(term) < abs(total) * mpf(10) ** -mp.dps:
                return total
        raise ArithmeticError(f"the series of F_{a}({x}) does not end")
    if a == 0:
        return sqrt(pi / 2) * erfc(x / sqrt(2))
    if a == 1 and x < 3:
        return exp(-x * x / 2) - x * sqrt(pi / 2) * erfc(x / sqrt(2))
    return gamma(a + 1) * exp(-x * x / 4) * pcfd(-a - 1, x)


def integrals(r, theta, eta, agree):
    """The four of POWERS."""
    r, theta, eta = mpf(r), mpf(theta), mpf(eta)
    c, k = sqrt((1 - r) * (1 + r)), tan(theta) / sqrt(2)
    rule = legendre(POINTS, mpf(10) ** (4 - mp.dps), mpf, mp.cospi)

    def integrand(s):
        t = s * s
        x = (eta - r * t) / c
        common = 2 * erf(k * t) * exp(-t * t / 2)
        return [common * (s if b == 0 else 1 if b > -1 else 1 / s) * moment(a, x) for a, b in POWERS]

    def panel(low, high):
        middle, half = (low + high) / 2, (high - low) / 2
        total = [mpf(0)] * 4
        for x, w in rule:
            values = integrand(middle + half * x)
            total = [sum_ + half * w * value for sum_, value in zip(total, values)]
        return total

    # from 0 to where exp(-t^2/2), or for eta > 0 what is left of exp((eta^2 - t^2)/2), is below 1e-40; marks where something
    # narrow may be: the layer of width 1/k at 0, the Gaussian of mean r eta and width c, where F_a turns on
    end = sqrt(max(eta, mpf(0)) ** 2 + 190)
    marks = {mpf(0), end, mpf(1), mpf(4), 1 / k, 5 / k, c, 5 * c}
    for n in (-13, -4, 0, 4, 13):
        marks.add(r * eta + n * c)
        if r > 0:
            marks.add((eta + n * c) / r)
    marks = sorted(sqrt(m) for m in marks if 0 <= m <= end)
    waiting = [(low, high, panel(low, high)) for low, high in zip(marks, marks[1:]) if high - low > mpf(10) ** -30]
    size = [sum(part[i] for _, _, part in waiting) for i in range(4)]
    total = [mpf(0)] * 4
    while waiting:
        low, high, whole = waiting.pop()
        middle = (low + high) / 2
        left, right = panel(low, middle), panel(middle, high)
        both = [x + y for x, y in zip(left, right)]
        if all(abs(w - h) <= agree * s for w, h, s in zip(whole, both, size)):
            total = [x + y for x, y in zip(total, both)]
        else:
            waiting += [(low, middle, left), (middle, high, right)]
    return [c**a / (2 * theta) * value for (a, _), value in zip(POWERS, total)]


def gaussian_mean(row):
    return moment(mpf(row["n"]), mpf(float(row["h"]))) / sqrt(2 * pi)


def power_of(row):
    return next(i for i, (a, b) in enumerate(POWERS) if mpf(row["a"]) == a and mpf(row["b"]) == b)


def unit_of(name, row):
    return exp(max(mpf(float(row["eta"])), 0) ** 2 / 2) if name == SCALED else 1


def place(row):
    return tuple(float(row[key]) for key in ("r", "theta", "eta"))


def text(value, count=30):
    """As the tables have it: \\p count digits, with the exponent where it is not 0."""
    exponent = int(floor(log10(value) + mpf(10) ** -count / 2))
    digits = nstr(value / mpf(10) ** exponent, count)
    return digits if exponent == 0 else f"{digits}e{exponent:+d}"


def check(rows):
    tables = [(name, row) for name in TABLES for row in csv.DictReader((DATA / name).open())]
    places = sorted({place(row) for _, row in tables})
    places = random.Random(2014).sample(places, min(len(places), -(-rows // 4)))
    found = {at: integrals(*at, mpf("1e-21")) for at in places}
    pairs = [(name, row, found[place(row)][power_of(row)] * unit_of(name, row)) for name, row in tables if place(row) in found]
    done = len(pairs)
    pairs += [(MOMENTS, row, gaussian_mean(row)) for row in csv.DictReader((DATA / MOMENTS).open())]
    errors = [(abs(value / mpf(row["value"]) - 1), name, row, value) for name, row, value in pairs]
    for error, name, row, value in errors:
        if error > mpf("1e-20"):
            print(f"{name}: {row} is off by {nstr(error, 3)}: {text(value)}")
    worst = max(error for error, *_ in errors)
    print(f"{done} integrals and all of {MOMENTS}, the worst off by {nstr(worst, 3)}")
    return worst > mpf("1e-20") or done < rows


def write_table(name, rows):
    with (DATA / name).open("w", newline="") as file:
        table = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        table.writeheader()
        table.writerows(rows)


def write():
    with (DATA / MOMENTS).open() as file:
        rows = list(csv.DictReader(file))
    write_table(MOMENTS, [row | {"value": nstr(gaussian_mean(row), 25)} for row in rows])
    kept = {}
    for name in TABLES:
        with (DATA / name).open() as file:
            rows = list(csv.DictReader(file))
        for row in rows:
            if place(row) not in kept:
                kept[place(row)] = integrals(*place(row), mpf("1e-31"))
            value = kept[place(row)][power_of(row)] * unit_of(name, row)
            if row["value"] != text(value):
                row |= {"value": text(value)} | ({"log10": nstr(log10(value), 20)} if "log10" in row else {})
        write_table(name, rows)


def main():
    count = (sys.argv + ["40"])[2] if "--check" in sys.argv else None
    mp.dps = 32 if count else 45
    return check(int(count)) if count else write()


if __name__ == "__main__":
    sys.exit(main())
