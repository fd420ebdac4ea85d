#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the values of tests/data/table1_curves.csv from the definition, by other means than fstiff: the integrals J[a,b] come from
tools/make_reference_integrals.py, the surfaces from Table 1 of the paper, and both bodies are steel of 205 GPa and 0.3.

    p = (4/3) E D_p sigma^(3/2) s^(-1/2) J[3/2,-1/2](eta)         K = f 2 E D_p sigma^(1/2) s^(-1/2) J[1/2,-1/2](eta)
    A/A0 = pi D_p (sigma/s) J[1,-1](eta)                          n/A0 = D_p J[0,0](eta)
    s = 3 sqrt(pi)/(8 R)                                          f = 1 (Hertz) or (2/3) (3-D)/(2-D) (fractal)

    Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), eqs. (3.7), (3.11), (3.14), (3.15), (4.5)-(4.10)

    tools/make_table1_curves.py                    writes the values anew: eta by Newton's method, 12 digits
    tools/make_table1_curves.py --check [ROWS]     compares that many rows, by default 4, to 1e-10; writes nothing

Needs mpmath; without it --check prints SKIPPED.
"""
import csv
import random
import sys

import make_reference_integrals as reference  # prints SKIPPED, and ends, without mpmath
from mpmath import mp, mpf, pi, sqrt

TABLE = reference.DATA / "table1_curves.csv"
# sigma [m], R [m], D_p [1/m^2], D
SURFACES = {
    "sand_blasted_fine": ("0.832e-6", "40e-6", "500e6", "1.62"),
    "sand_blasted_coarse": ("5.13e-6", "30e-6", "230e6", "1.58"),
    "electrical_discharge": ("8.94e-6", "19e-6", "160e6", "1.70"),
}
COLUMNS = ("pressure_Pa", "stiffness_fractal_Pa_per_m", "stiffness_hertz_Pa_per_m", "real_area_fraction", "contacts_per_m2")


def state(row, eta):
    """The values of COLUMNS at the separation eta."""
    sigma, radius, density, dimension = (mpf(x) for x in SURFACES[row["surface"]])
    modulus = mpf(205) * 10**9 / (2 * (1 - mpf("0.3") ** 2))
    s = 3 * sqrt(pi) / (8 * radius)
    contacts, half, three, area = reference.integrals(float(row["r"]), float(row["theta"]), eta, mpf("1e-15"))
    hertz = 2 * modulus * density * sqrt(sigma / s) * half
    return (mpf(4) / 3 * modulus * density * sigma * sqrt(sigma / s) * three,
            mpf(2) / 3 * (3 - dimension) / (2 - dimension) * hertz, hertz, pi * density * sigma / s * area, density * contacts)


def check(rows, count):
    rows = random.Random(2014).sample(rows, min(count, len(rows)))
    errors = [(abs(value / mpf(row[column]) - 1), column, row) for row in rows for column, value in zip(COLUMNS, state(row, mpf(row["eta"])))]
    worst, column, row = max(errors, key=lambda error: error[0])
    print(f"{len(rows)} rows, the worst value off by {mp.nstr(worst, 3)}: {column} of {row}")
    return worst > mpf("1e-10")


def write(rows):
    for row in rows:
        eta, sigma = mpf(row["eta"]), mpf(SURFACES[row["surface"]][0])
        for _ in range(20):
            values = state(row, eta)
            step = (values[0] - mpf(row["pressure_Pa"])) / (values[2] * sigma)  # dp/deta = -sigma K of Hertz
            eta += step
            if abs(step) < mpf("1e-14"):
                break
        row["eta"] = f"{float(eta):.12g}"
        row.update({column: f"{float(value):.12g}" for column, value in zip(COLUMNS[1:], values[1:])})
    reference.write_table(TABLE.name, rows)


mp.dps = 22
with TABLE.open() as file:
    of_table = list(csv.DictReader(file))
sys.exit(check(of_table, int((sys.argv + ["4"])[2])) if "--check" in sys.argv else write(of_table))
