#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the two pictures of docs/theory-numerics.md from the formulas of that page, without fstiff.

    tools/make_integral_pictures.py            writes docs/integrand.svg and docs/convergence.svg
    tools/make_integral_pictures.py --check    exit code 1 when they would differ by more than 0.2 points, or when the
                                               sentences of docs/theory-numerics.md that give errors are not what comes out

The truth of the errors is tests/data/integrals_plain.csv. Errors below 3e-14 are drawn there: they are rounding.
"""
import csv
import math
import sys

from generated import ROOT, Axis, Picture, between_markers, legendre, powers, table, write_or_check
from search_peak_nodes import moments, smooth as smooth_map

DOCS = ROOT / "docs"
FLOOR = 3e-14
PLAIN = (0.5, math.pi / 3, 1.0)  # r, theta, eta
CASES = (  # what, (r, theta, eta), substitution
    ("r = 0.5, θ = π/3, η = 1", PLAIN, "smooth"),
    ("r = 0.5, θ = 1.55, η = 0: a layer at t = 0", (0.5, 1.55, 0.0), "graded"),
    ("r = 0.99, θ = π/3, η = 3: a narrow peak", (0.99, math.pi / 3, 3.0), "separated"),
)
LOOKS = (("#1f6fb4", "#6fb1ee", "circle"), ("#c2571a", "#f0965a", "square"), ("#2c8a4b", "#6fcf8f", "triangle"), ("#7a4fb5", "#b794f0", "diamond"))


def outer(problem, t):
    """The integrand over t, without 1/(2 theta)."""
    r, theta, eta = problem
    if t <= 0:
        return 0.0
    c = math.sqrt((1 - r) * (1 + r))
    return math.sqrt(c) * t**-0.5 * math.erf(t * math.tan(theta) / math.sqrt(2)) * math.exp(-t * t / 2) * moments((eta - r * t) / c)[1]


def substitution(kind, problem, y):
    """t and dt/dy."""
    r, theta, eta = problem
    c = math.sqrt((1 - r) * (1 + r))
    if kind == "smooth":
        return smooth_map(y)
    if kind == "graded":
        scale = min(1, math.sqrt(2) / math.tan(theta), c + max(0, -eta))
        t = scale * math.exp(y - math.exp(-y))
        return t, t * (1 + math.exp(-y))
    x = -(3 * y + math.exp(y))
    return (eta - c * x) / r, c / r * (3 + math.exp(y))


def after(problem, kind, y):
    t, slope = substitution(kind, problem, y)
    return outer(problem, t) * slope


def density(r, theta, zeta, t):
    c2 = (1 - r) * (1 + r)
    return math.erf(t * math.tan(theta) / math.sqrt(2)) / (2 * theta * math.sqrt(2 * math.pi * c2) / math.sqrt(2 * math.pi)) * math.exp(
        -((zeta - r * t)**2) / (2 * c2) - t * t / 2)


def box(problem, n, size=8.0):
    """Gauss and Legendre's n x n points on 0 <= t <= 8, eta <= zeta <= eta + 8."""
    r, theta, eta = problem
    rule = [((x + 1) * size / 2, w * size / 2) for x, w in legendre(n, 1e-15)]
    return sum(wt * we * math.sqrt(e / t) * density(r, theta, eta + e, t) for t, wt in rule for e, we in rule)


def squares(problem, n):
    """The trapezoidal rule of n x n points in s and w: t = s^2, zeta = eta + c w^2."""
    r, theta, eta = problem
    c, k = math.sqrt((1 - r) * (1 + r)), math.tan(theta) / math.sqrt(2)
    end_s = 2.95
    end_w = math.sqrt(max(0, (r * end_s**2 - eta) / c) + 8.5)
    total = 0.0
    for i in range(n + 1):
        s = end_s * i / n
        for j in range(1, n + 1):
            w = end_w * j / n
            total += (0.5 if i == 0 else 1) * 4 * w * w * math.erf(k * s * s) * math.exp(-s**4 / 2 - (w * w + (eta - r * s * s) / c)**2 / 2)
    return math.sqrt(c) / (2 * theta) * total * end_s / n * end_w / n


def one_dimension(problem, n):
    """The same over s alone, the inner integral being known."""
    end = 2.95
    return sum(outer(problem, (end * i / n)**2) * 2 * end * i / n for i in range(1, n + 1)) * end / n / (2 * problem[1])


def smooth(problem, n):
    """The trapezoidal rule of n points of the smooth substitution, over the y where its integrand is above 1e-16."""
    begin, end = -3.3, 3.6
    step = (end - begin) / (n - 1)
    return step * sum(after(problem, "smooth", begin + step * i) for i in range(n)) / (2 * problem[1])


METHODS = (  # what, rule, evaluations of n, settings
    ("n x n points of Gauss and Legendre on a box", box, lambda n: n * n, (4, 6, 8, 12, 16, 24, 32, 50, 64)),
    ("squares in both variables, n x n points", squares, lambda n: n * n, (4, 6, 8, 10, 12, 14, 16, 20, 24)),
    ("inner integral known, square, n points", one_dimension, lambda n: n, (4, 6, 8, 10, 12, 14, 16, 20, 24)),
    ("inner integral known, smooth map, n points", smooth, lambda n: n, (6, 8, 10, 12, 16, 20, 24, 28, 32)),
)


def truth(problem):
    with open(ROOT / "tests" / "data" / "integrals_plain.csv", encoding="utf-8") as file:
        return next(float(row["value"]) for row in csv.DictReader(file)
                    if all(abs(float(row[key]) - value) < 1e-12 for key, value in zip(("a", "b", "r", "theta", "eta"), (0.5, -0.5, *problem))))


def errors():
    """By method: (evaluations, relative error) of each setting."""
    right = truth(PLAIN)
    return [(what, [(count(n), n, abs(rule(PLAIN, n) / right - 1)) for n in settings]) for what, rule, count, settings in METHODS]


def draw_integrand():
    left, top, width, height, gap = 30, 50, 440, 320, 50
    out = Picture(2 * width + gap + 2 * left, top + height + 136, "The integrand over the curvature t before and after substitution, for three problems", LOOKS)
    part = Axis("", -0.08, 1.08, {}, False)  # of the greatest value
    places = []
    for k, (title, label, *across) in enumerate((("the integrand, over t", "curvature t", 0, 5, range(6)),
                                                 ("after substitution, over y, with nodes", "y", -4, 6, range(-4, 7, 2)))):
        out.text(left + k * (width + gap), top - 14, title, 'class="title"')
        places.append(out.frame(left + k * (width + gap), top, width, height,
                                Axis(label, *across[:2], {mark: str(mark) for mark in across[2]}, False), part))
    for i, (what, problem, kind) in enumerate(CASES):
        ts = [5 * (j / 400)**(1 if kind == "separated" else 2) for j in range(401)]
        ys, nodes = [-4 + 10 * j / 400 for j in range(401)], [-4 + 0.25 * j for j in range(41)]
        for at, of, place in ((ts, lambda t: outer(problem, t), places[0]), (ys, lambda y: after(problem, kind, y), places[1])):
            most = max(map(of, at))
            out.curve(i, [place(x, of(x) / most) for x in at], False)
        out.markers(i, [places[1](y, after(problem, kind, y) / most) for y in nodes])
        out.sample(i, left, top + height + 70 + 22 * i, f'{what}; substitution "{kind}"')
    return out


def draw_convergence(results):
    out = Picture(1000, 516, "Relative error of one contact integral against the number of evaluations, for four rules", LOOKS)
    out.text(80, 32, "J[1/2,-1/2] at r = 0.5, θ = π/3, η = 1", 'class="title"')
    place = out.frame(80, 50, 520, 400, Axis("evaluations of the integrand", 4, 5000, {n: str(n) for n in (10, 100, 1000)}),
                      Axis("relative error", 1e-14, 1, {10.0**k: text for k in range(-14, 1, 2) for text in powers(k, k).values()}))
    for i, (what, points) in enumerate(results):
        out.curve(i, [place(count, min(max(error, FLOOR), 1)) for count, _, error in points])
        out.sample(i, 624, 68 + 27 * i, what)
    return out


def rows(results):
    show = lambda error: f"{error:.0e}" if error > 2e-14 else "rounding"
    return [[what] + [f"{count}: {show(error)}" for count, n, error in points if n in chosen]
            for (what, points), chosen in zip(results, ((8, 24, 50), (8, 16, 24), (8, 16, 24), (8, 16, 24)))]


found = errors()
text = "\n".join(table(["rule", "evaluations: relative error", "", ""], rows(found))).rstrip()
sys.exit(write_or_check({DOCS / "integrand.svg": draw_integrand(), DOCS / "convergence.svg": draw_convergence(found),
                         DOCS / "theory-numerics.md": between_markers(DOCS / "theory-numerics.md", convergence=text)},
                        "make_integral_pictures.py", sys.argv[1:] == ["--check"], 0.2))
