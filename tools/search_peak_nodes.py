#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The constants of include/fstiff/peaks/peak_nodes.hpp: their source, and a check of its claims.

    J = sum over j of step t'(j step) f(t(j step)),   f(t) = t^b erf(k t) exp(-t^2/2) F_a((eta - r t)/c),   c^2 = 1 - r^2,
    (a, b) = (0, 0), (1/2, -1/2), (3/2, -1/2), (1, -1),   k = tan(theta)/sqrt 2

    smooth map     t(y) = scale log(1 + exp(y - fall exp(-rate y))): the scale, fall, rate and step for which the largest relative
                   error of the four integrals over -3 <= eta <= 4, 0 <= r <= 0.82, pi/4 <= theta <= pi/3 is least with 32 values
                   of j. The header states 3e-13. Truth is the same sum with a quarter of the step from the far left to the far
                   right, which has converged to the rounding of double, 1e-14.
    its step       SMOOTH/((L + 4) (1 + max(0, LAYER k^2 - 0.07))),  L = -ln(tolerance), one more for a tolerance above 1e-10
    graded map     t(y) = s exp(y - exp(-y)), s = min(1, 1/k, c + max(0, -eta)), with the step 1/sqrt(W^2 + N^2),
                   W = (L + 3)/GRADED, N = max(r eta/c, 0) sqrt(L)/NARROW

For 40 problems (r, theta, eta) that one of the last four constants rules, drawn with a fixed seed, and for the tolerances 1e-3, 1e-8
and 3e-13, `steps` looks for the largest step from which on the integrals are right to the tolerance, and turns it into the greatest value
that the constant may have there. (For LAYER into the inverse: the less, the bolder.) What the header holds is

    GRADED, SMOOTH, 1/LAYER   the least of these values, less a margin of up to a fifth for problems that several constants rule;
                              LAYER up to a twentieth above it
    NARROW                    what a quarter of these values is below: there the rule takes too few nodes, and its error estimate shows it

    map           searches from rough guesses, by steps that shrink, and prints what it finds (a minute): 1.4e-13 at 1.836, 0.430, 1.353,
                  0.2484. The least is flat: the constants of the header, 2.1, 0.4, 1.354, 0.2273, have 2.0e-13
    map --check   checks the header's statement on a finer grid, that one node fewer does not do, and that the truth is one
    steps         prints the values needed, and compares them with the header

Needs nothing but Python; does not use the library.
"""
import argparse
import math
import pathlib
import random
import re
import sys

HEADER = pathlib.Path(__file__).resolve().parent.parent / "include/fstiff/peaks/peak_nodes.hpp"
MAP = (2.1, 0.4, 1.354)  # scale, fall, rate
NODES, CLAIM = 32, 3e-13
R, ETA = 0.82, (-3, 4)
LAYERS = [math.tan(theta) / math.sqrt(2) for theta in (math.pi / 4, (math.pi / 4 + math.pi / 3) / 2, math.pi / 3)]
TOLERANCES, PROBLEMS = (1e-3, 1e-8, 3e-13), 40


def from_header(**patterns):
    """Of each name the numbers that its pattern finds, where N is one."""
    text = HEADER.read_text()
    found = {name: re.search(pattern.replace("N", r"(-?[0-9.]+)"), text) for name, pattern in patterns.items()}
    if not all(found.values()):
        sys.exit("peak_nodes.hpp does not hold the constants where this script looks for them")
    return {name: [float(number) for number in match.groups()] for name, match in found.items()}


def moments(x):
    """F_0, F_1/2, F_3/2, F_1 at x. F_1/2 and F_3/2 by the trapezoidal rule in w, v = w^2: 2 w^(2a+1) exp(-(w^2 + x)^2/2) is even and
    entire; for x < 0 it is a peak at sqrt(-x) of width 1/(2 sqrt(-x))."""
    gauss, tail = math.exp(-x * x / 2), math.sqrt(math.pi / 2) * math.erfc(x / math.sqrt(2))
    step = 0.11 * min(1.0, math.sqrt(5 / max(-x, 5.0)))
    half = three = 0.0
    for i in range(1, int(math.sqrt(9 + max(-x, 0.0)) / step) + 1):
        v = (i * step) ** 2
        term = math.exp(-((v + x) ** 2) / 2) * v
        half += term
        three += term * v
    if x > 2.5:  # without the cancellation: F_1 by a continued fraction of exp(x^2/2) F_0
        ratio = x
        for n in range(200, 0, -1):
            ratio = x + n / ratio  # gauss / tail
        one = gauss * (1 - x / ratio) if x < 30 else gauss / (x * x)
        tail = gauss / ratio
    else:
        one = gauss - x * tail
    return tail, 2 * step * half, 2 * step * three, one


def smooth(y, constants=MAP):
    """t and dt/dy."""
    scale, fall, rate = constants
    drop = fall * math.exp(-rate * y)
    v = y - drop
    small = math.exp(-abs(v))
    return scale * (max(v, 0) + math.log1p(small)), scale * (1 + rate * drop) * (1 if v > 0 else small) / (1 + small)


def parts(t, weight, r, eta):
    """The four integrands without erf(k t)."""
    f = moments((eta - r * t) / math.sqrt((1 - r) * (1 + r)))
    mass = weight * math.exp(-t * t / 2)
    return f[0] * mass, f[1] * mass / math.sqrt(t), f[2] * mass / math.sqrt(t), f[3] * mass / t


def sums(nodes, r, eta):
    """The four sums over (t, weight), for each of LAYERS."""
    out = [[0.0] * 4 for _ in LAYERS]
    for t, weight in nodes:
        values = parts(t, weight, r, eta)
        for k, row in zip(LAYERS, out):
            layer = math.erf(k * t)
            for i in range(4):
                row[i] += layer * values[i]
    return out


def rule(constants, step, first, count):
    return [(t, step * weight) for t, weight in (smooth((first + j) * step, constants) for j in range(count)) if t > 0]


def fine(divisor, constants=MAP):
    """A rule that has converged, with any map of the family."""
    step = 0.2273 / divisor
    first = int(-3.7 / step)
    return rule(constants, step, first, int(6.5 / step) - first)


def truths_of(count_r, count_eta):
    grid = [(R * math.sin(math.pi / 2 * i / (count_r - 1)), ETA[0] + (ETA[1] - ETA[0]) * j / (count_eta - 1))
            for i in range(count_r) for j in range(count_eta)]
    return {at: sums(fine(4), *at) for at in grid}


def worst(nodes, truths):
    """The largest relative error."""
    return max(abs(x / y - 1) for at, truth in truths.items() for found, true in zip(sums(nodes, *at), truth) for x, y in zip(found, true))


def best_first(constants, step, truths, count=NODES):
    """The least of the errors over the first node: on the left the area falls as t, which is exp(-30) near there."""
    _, fall, rate = constants
    first = math.ceil(-math.log(30 / fall) / (rate * step))
    return min((worst(rule(constants, step, j, count), truths), j) for j in (first, first + 1))


def check_map():
    found = from_header(scale=r"scale = T\(N\);", fall=r"fall = T\(N\) \* std::exp\(T\(N\) \* y\);", step=r"step = T\(N \* 4\);")
    constants, step = (*found["scale"], found["fall"][0], -found["fall"][1]), found["step"][0]
    truths = truths_of(9, 15)
    # the truth: another step and another map of the family
    other = max(worst(fine(3.3), truths), worst(fine(4, (1.7, 0.5, 1.2)), truths))
    (error, first), (fewer, _) = (best_first(constants, step, truths, count) for count in (NODES, NODES - 1))
    print(f"the fine rules that are the truth differ by {other:.2g}, less than 2e-14 expected; {NODES} nodes from y = {first} steps: {error:.3g}, "
          f"{CLAIM:g} in the header; one node fewer: {fewer:.3g}, which must be more")
    return not (other < 2e-14 and error <= CLAIM < fewer)


def search_map():
    truths = truths_of(4, 5)
    at, size = [2.0, 0.5, 1.3, 0.23], 0.08
    cost = lambda x: best_first(tuple(x[:3]), x[3], truths)[0]
    best = cost(at)
    while size > 5e-4:
        better = False
        for i, factor, keep in [(i, 1 + sign * size, keep) for i in (3, 0, 2, 1) for sign in (1, -1) for keep in (False, True)]:
            trial = list(at)
            trial[i] *= factor
            if keep and i in (0, 3):  # the reach to the right, scale times step
                trial[3 - i] /= factor
            if (found := cost(trial)) < best:
                at, best, better = trial, found, True
        print(f"{best:.3g}: scale {at[0]:.4f}, fall {at[1]:.4f}, rate {at[2]:.4f}, step {at[3]:.5f}", flush=True)
        if not better:
            size /= 2


def largest_steps(r, k, eta, map_, low, high):
    """For each tolerance L and the largest step from which on every finer one keeps it, of the sum over low <= y <= high."""
    kept = {}

    def at(y):
        if y not in kept:
            t, weight = map_(y)
            kept[y] = parts(t, weight * math.erf(k * t), r, eta) if t > 1e-40 else (0.0,) * 4
        return kept[y]

    def total(step):
        terms = [at(round(j * step, 12)) for j in range(math.floor(low / step), math.ceil(high / step) + 1)]
        return [step * math.fsum(column) for column in zip(*terms)]

    truth = total(0.02)
    steps = [1.3 / 2 ** (k / 8) for k in range(41)]  # down to 0.04
    errors = [max(abs(a / b - 1) for a, b in zip(total(step), truth)) for step in steps]
    found = []
    for tolerance in TOLERANCES:
        good = 0.0
        for step, error in zip(reversed(steps), reversed(errors)):
            if error > tolerance:
                break
            good = step
        found.append((-math.log(tolerance) + (1 if tolerance > 1e-10 else 0), good))
    return found


def graded(r, k, eta):
    scale = min(1, 1 / k, math.sqrt((1 - r) * (1 + r)) + max(0, -eta))

    def of(y):
        t = scale * math.exp(y - math.exp(-y))
        return t, t * (1 + math.exp(-y))

    return largest_steps(r, k, eta, of, -3.9, math.log((max(eta, 0) + 8.5) / scale) + 1)


def mapped(r, k, eta):
    return largest_steps(r, k, eta, smooth, -3.7, (max(eta, 0) + 8.5) / 2.1 + 1)


def needed():
    """The values of each constant, by its name: the greatest with which the rule keeps the tolerance."""
    draw = random.Random(2014)
    out = {name: [] for name in ("GRADED", "NARROW", "SMOOTH", "LAYER")}
    for _ in range(PROBLEMS):
        k, eta = math.exp(draw.uniform(math.log(10), math.log(1000))), draw.uniform(-3, 0)
        out["GRADED"] += [step * (length + 3) for length, step in graded(draw.random() ** 0.3, k, eta)]
        r, distance = draw.uniform(0.9, 0.999), draw.uniform(4, 8)
        for length, step in graded(r, k, distance * math.sqrt(1 - r * r) / r):
            narrow = 1 / step**2 - ((length + 3) / 3.9) ** 2  # what the other constant leaves; less than 0: none is needed
            out["NARROW"].append(distance * math.sqrt(length / narrow) if narrow > 0 else math.inf)
        r, k, eta = draw.uniform(0, 0.4), draw.uniform(0.3, 1), draw.uniform(-2, 1)
        out["SMOOTH"] += [step * (length + 4) for length, step in mapped(r, k, eta)]
        k = draw.uniform(3, 8)
        out["LAYER"] += [k * k / max(1e-9, 7.6 / ((length + 4) * step) - 0.93) for length, step in mapped(r, k, eta) if step > 0]
    return out


# The quantile of the values needed that belongs to a constant, and the range of the constant over it.
PLACES = {"GRADED": (0, 0.8, 1.05), "SMOOTH": (0, 0.8, 1.05), "LAYER": (0, 0.8, 1.05), "NARROW": (0.25, 0.8, 1.2)}


def check_steps():
    header = from_header(GRADED=r"wide = \(\w+ \+ 3\) / T\(N\);", NARROW=r"narrow = .* / T\(N\);", SMOOTH=r"strip = T\(N\) /",
                         LAYER=r"T\(N\) \* p\.k \* p\.k")
    off = False
    for name, values in needed().items():
        (held,), (place, low, high) = header[name], PLACES[name]
        value = sorted(values)[int(place * (len(values) - 1))]
        ratio = (1 / held if name == "LAYER" else held) / value
        off = off or not low <= ratio <= high
        print(f"{name}: {held:g} in the header, {1 / value if name == 'LAYER' else value:.3g} found; ratio {ratio:.2f}, {low:g} to {high:g} expected")
    return off


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("map", "steps"))
    parser.add_argument("--check", action="store_true", help="compare with peak_nodes.hpp")
    options = parser.parse_args()
    return check_steps() if options.what == "steps" else check_map() if options.check else search_map()


if __name__ == "__main__":
    sys.exit(main())
