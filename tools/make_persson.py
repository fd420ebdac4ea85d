#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes tests/data/persson_closing.csv from the definition, with the wave number as the variable, which the library does not use:

    1/K = sqrt(2 pi)/p int q^2 C B(P) exp(-2 x^2)/G dq          x = p/(E G),  P = erf(sqrt(2) x),  G(q)^2 = 2 pi int q^3 C dq
    d   = sqrt(2 pi) int q^2 C W(sqrt(2) x)/G dq                W(y) = int_y^inf B(erf s) exp(-s^2) ds/s
    B   = gamma + (1-gamma) [3 (1-c) P^2 + 17 c P^16]

    tools/make_persson.py               writes the table anew, 17 digits
    tools/make_persson.py --check       compares all rows to 1e-16; writes nothing

Needs mpmath; without it --check prints SKIPPED.
"""
import csv
import pathlib
import sys

try:
    from mpmath import mp, mpf, erf, exp, pi, quad, sqrt
except ImportError:
    print("SKIPPED: mpmath is not installed")
    sys.exit(0 if "--check" in sys.argv else 1)

TABLE = pathlib.Path(__file__).resolve().parent.parent / "tests" / "data" / "persson_closing.csv"
COLUMNS = ("C0", "hurst", "q1", "q_rolloff", "q2", "gamma", "closing", "p_over_E_g", "p_over_E", "stiffness_over_E", "separation")
BANDS = (("0.8", 8, 8, 64), ("0.3", 2, 8, 512), ("1", 4, 4, 4096))
ENERGIES = (("0.45", "0.25"), ("0.4", "0.8"))
SHARES = ("0.003", "0.1", "0.4", "0.75", "1.5")
GAPS = ("0.1", "1.5")  # shares with a separation


def column(band, energy, share, with_gap=False):
    """p, K and the separation."""
    hurst, q1, rolloff, q2 = (mpf(x) for x in band)
    gamma, c = (mpf(x) for x in energy)
    power = 2 - 2 * hurst

    def spectrum(q):
        return max(q, rolloff) ** (-2 - 2 * hurst)

    def gradient(log):  # of q over q1
        flat, more = min(log, mp.log(rolloff / q1)), max(log - mp.log(rolloff / q1), mpf(0))
        risen = mp.expm1(power * more) / power if power else more
        return sqrt(2 * pi * (spectrum(rolloff) * q1**4 * mp.expm1(4 * flat) / 4 + rolloff**power * risen))

    def bracket(P):
        return gamma + (1 - gamma) * (3 * (1 - c) * P**2 + 17 * c * P**16)

    def distance(y):
        edges = [y, 2 * y, 2 * y + 1, 2 * y + 3, 2 * y + 7]
        return quad(lambda s: bracket(erf(s)) * exp(-s * s) / s, edges, method="gauss-legendre")

    # q = q1 exp(v^2): G goes to 0 like v, and the integrand falls like exp(-1/v^2) where G is about p/E
    edges = sorted({mp.log(rolloff / q1), mp.log(q2 / q1)} | {mp.log(q2 / q1) * i / 8 for i in range(9)})
    edges = [sqrt(edge) for edge in edges]
    edges[1:1] = [edges[1] / 2**k for k in range(6, 0, -1)]

    def over_band(of):
        def integrand(v):
            q, G = q1 * exp(v * v), gradient(v * v)
            return 2 * v * q**3 * spectrum(q) / G * of(G)
        return sqrt(2 * pi) * quad(integrand, edges, method="gauss-legendre")

    p = mpf(float(mpf(share) * gradient(mp.log(q2 / q1))))
    softness = over_band(lambda G: bracket(erf(sqrt(2) * p / G)) * exp(-2 * (p / G) ** 2)) / p
    return p, 1 / softness, over_band(lambda G: distance(sqrt(2) * p / G)) if with_gap else ""


mp.dps = 20
rows = [(band, energy, share) for band in BANDS for energy in ENERGIES for share in SHARES]
if "--check" in sys.argv:
    table = list(csv.DictReader(TABLE.open()))
    worst = max(abs(column(*at)[1] / mpf(row["stiffness_over_E"]) - 1) for row, at in zip(table, rows, strict=True))
    print(f"{len(rows)} rows, the worst value off by {mp.nstr(worst, 3)}")
    sys.exit(worst > mpf("1e-16"))
with TABLE.open("w") as file:
    file.write(",".join(COLUMNS) + "\n")
    for band, energy, share in rows:
        values = column(band, energy, share, share in GAPS)
        text = [repr(float(values[0])), mp.nstr(values[1], 17), values[2] and mp.nstr(values[2], 15)]
        file.write(",".join(["1", *map(str, band), *energy, share, *text]) + "\n")
