#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The constants with which include/fstiff/contact/peak_nodes.hpp chooses the step of its rules: how they are fitted.

    graded   t = s exp(y - exp(-y)),  step 1/sqrt(W^2 + N^2),  W = (L + 3)/GRADED,  N = max(r eta/c, 0) sqrt(L)/NARROW
    smooth   the smooth map,          step SMOOTH/((L + 4) (1 + max(0, LAYER k^2 - 0.07)))
    L = -ln(tolerance), one more for a tolerance above 1e-10;  k = tan(theta)/sqrt 2,  s = min(1, 1/k, c + max(0, -eta))

For 40 problems (r, theta, eta) that one of the constants rules, drawn with a fixed seed, and for the tolerances 1e-3, 1e-8 and
3e-13, it looks for the largest step from which on the four integrals of tools/search_smooth_map.py are right to the tolerance, and turns it
into the greatest value that the constant may have there. (For LAYER into the inverse: the less, the bolder.) What the header holds is

    GRADED, SMOOTH, 1/LAYER   the least of these values, less a margin of up to a fifth for problems that several constants rule;
                              LAYER up to a twentieth above it
    NARROW                    what a quarter of these values is below: there the rule takes too few nodes, and its error estimate says so

    tools/search_rule_constants.py             prints the values needed
    tools/search_rule_constants.py --check     reads the constants from the header and compares

Needs nothing but Python; uses nothing of the library.
"""
import argparse
import math
import random
import re
import sys

import search_smooth_map as smooth

TOLERANCES = (1e-3, 1e-8, 3e-13)
PROBLEMS = 40


def log_accuracy(tolerance):
    return -math.log(tolerance) + (1 if tolerance > 1e-10 else 0)


class Problem:
    """The four integrands over y, of one map of y to t."""

    def __init__(self, r, k, eta, map_, low, high):
        self.r, self.k, self.eta, self.map, self.low, self.high = r, k, eta, map_, low, high
        self.c = math.sqrt((1 - r) * (1 + r))
        self.kept = {}
        self.truth = self.rule(0.02)

    def at(self, y):
        y = round(y, 12)
        if y not in self.kept:
            t, weight = self.map(y)
            parts = (0.0,) * 4
            if t > 1e-40:
                f = smooth.moments((self.eta - self.r * t) / self.c)
                mass = weight * math.exp(-t * t / 2) * math.erf(self.k * t)
                parts = (f[0] * mass, f[1] * mass / math.sqrt(t), f[2] * mass / math.sqrt(t), f[3] * mass / t)
            self.kept[y] = parts
        return self.kept[y]

    def rule(self, step):
        terms = [self.at(j * step) for j in range(math.floor(self.low / step), math.ceil(self.high / step) + 1)]
        return [step * math.fsum(column) for column in zip(*terms)]

    def largest_steps(self):
        """For each tolerance: the largest step from which on every finer one keeps it."""
        errors, step = [], 1.3
        while step > 0.04:
            errors.append((step, max(abs(a / b - 1) for a, b in zip(self.rule(step), self.truth))))
            step /= 2 ** 0.125
        out = []
        for tolerance in TOLERANCES:
            best = 0.0
            for step, error in reversed(errors):
                if error > tolerance:
                    break
                best = step
            out.append(best)
        return out


def graded(r, k, eta):
    c = math.sqrt((1 - r) * (1 + r))
    scale = min(1, 1 / k, c + max(0, -eta))

    def of(y):
        fall = math.exp(-y)
        t = scale * math.exp(y - fall)
        return t, t * (1 + fall)

    return Problem(r, k, eta, of, -3.9, math.log((max(eta, 0) + 8.5) / scale) + 1)


def mapped(r, k, eta):
    return Problem(r, k, eta, lambda y: smooth.map_of((2.1, 0.4, 1.354), y), -3.7, (max(eta, 0) + 8.5) / 2.1 + 1)


def needed():
    """The values of each constant, by its name: the greatest with which the rule keeps the tolerance."""
    draw = random.Random(2014)
    out = {name: [] for name in ("GRADED", "NARROW", "SMOOTH", "LAYER")}
    for _ in range(PROBLEMS):
        k, eta = math.exp(draw.uniform(math.log(10), math.log(1000))), draw.uniform(-3, 0)
        for tolerance, step in zip(TOLERANCES, graded(draw.random() ** 0.3, k, eta).largest_steps()):
            out["GRADED"].append(step * (log_accuracy(tolerance) + 3))
        r, distance = draw.uniform(0.9, 0.999), draw.uniform(4, 8)
        eta = distance * math.sqrt(1 - r * r) / r
        for tolerance, step in zip(TOLERANCES, graded(r, k, eta).largest_steps()):
            length = log_accuracy(tolerance)
            narrow = 1 / step**2 - ((length + 3) / 3.9) ** 2  # what the other constant leaves; less than 0: none is needed
            out["NARROW"].append(distance * math.sqrt(length / narrow) if narrow > 0 else math.inf)
        r, k, eta = draw.uniform(0, 0.4), draw.uniform(0.3, 1), draw.uniform(-2, 1)
        for tolerance, step in zip(TOLERANCES, mapped(r, k, eta).largest_steps()):
            out["SMOOTH"].append(step * (log_accuracy(tolerance) + 4))
        k = draw.uniform(3, 8)
        for tolerance, step in zip(TOLERANCES, mapped(r, k, eta).largest_steps()):
            if step > 0:
                out["LAYER"].append(k * k / max(1e-9, 7.6 / ((log_accuracy(tolerance) + 4) * step) - 0.93))
    return out


def from_header():
    text = smooth.HEADER.read_text()
    number = r"T\(([0-9.]+)\)"
    found = {
        "GRADED": re.search(rf"wide = \(\w+ \+ 3\) / {number};", text),
        "NARROW": re.search(rf"narrow = .* / {number};", text),
        "SMOOTH": re.search(rf"strip = {number} /", text),
        "LAYER": re.search(rf"{number} \* p\.k \* p\.k", text),
    }
    if not all(found.values()):
        sys.exit("peak_nodes.hpp does not hold the constants where this script looks for them")
    return {name: float(match[1]) for name, match in found.items()}


# The quantile of the values needed that belongs to a constant, and the range of the constant over it.
PLACES = {"GRADED": (0, 0.8, 1.05), "SMOOTH": (0, 0.8, 1.05), "LAYER": (0, 0.8, 1.05), "NARROW": (0.25, 0.8, 1.2)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="compare with peak_nodes.hpp")
    check = parser.parse_args().check
    header, good = from_header(), True
    for name, values in needed().items():
        place, low, high = PLACES[name]
        values.sort()
        value = values[int(place * (len(values) - 1))]
        held = 1 / header[name] if name == "LAYER" else header[name]
        fits = low <= held / value <= high
        good = good and fits
        shown = 1 / value if name == "LAYER" else value
        print(f"{name}: {header[name]:g} in the header, {shown:.3g} found; ratio {held / value:.2f}, {low:g} to {high:g} expected" +
              ("" if fits else ": off"))
    if check and not good:
        print("not what peak_nodes.hpp holds")
    return 1 if check and not good else 0


if __name__ == "__main__":
    sys.exit(main())
