#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes tests/data/plastic_faces.csv: contact of faces as processes leave them, whose pressures are cut at the hardness, by boundary elements.

    tests/contact/make_plastic_faces.py build/release/bin/fstiff                  prints the table (a minute)
    tests/contact/make_plastic_faces.py build/release/bin/fstiff --check 8        solves every eighth face again: exit code 1 when a
                                                                                  stiffness differs by more than 1e-3

The faces are those of bench/make_faces.py, seed 1, rms gradient 0.1; four of them are Gaussian. Stiffness is that of unloading times sigma over
E g; separation is negative at heavy loads.
"""
import csv
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "bench"))
import make_faces as faces  # noqa: E402

TABLE = ROOT / "tests/data/plastic_faces.csv"
HARDNESS = (.03, .1, .3)  # over E g
LOADS = (.003, .03, .3, .8)  # over H
COLUMNS = ("kind", "skewness", "kurtosis", "alpha", "hardness_over_Eg", "p_over_H", "stiffness_sigma_over_Eg", "separation_over_sigma",
           "contacts")


def alpha_of(z):
    """Nayak's m0 m4/m2^2 of the isotropic face that has the mean squares of z, of its gradient and of its Laplacian."""
    q2 = (2 * np.pi * faces.RADIUS) ** 2
    power = np.abs(np.fft.fft2(z)) ** 2
    return 1.5 * np.sum(power) * np.sum(q2**2 * power) / np.sum(q2 * power) ** 2


def rows(program, kind):
    z = faces.map_of(kind, 1)
    z = z - z.mean()
    sigma, skewness, kurtosis = faces.numbers_of(z)
    with tempfile.TemporaryDirectory() as folder:
        file = str(pathlib.Path(folder) / "map.gsf")
        faces.write_field(z, file)
        for hardness in HARDNESS:
            closing = faces.GRADIENT * faces.MODULUS
            pressures = ",".join(f"{load * hardness * closing:.9g} Pa" for load in LOADS)
            found = subprocess.run([program, "truth", file, "--detrend", "mean", "--lambda-s", "none", "--edges", "periodic", "--modulus",
                                    f"{faces.MODULUS} Pa", "--hardness", f"{hardness * closing:.9g} Pa", "--pressures", pressures, "--format",
                                    "csv"], check=False, capture_output=True, text=True).stdout
            for load, row in zip(LOADS, csv.DictReader(found.splitlines()), strict=True):
                yield [kind, f"{skewness:.5g}", f"{kurtosis:.5g}", f"{alpha_of(z):.4g}", hardness, load,
                       f"{float(row['stiffness_Pa_per_m']) * sigma / closing:.5g}", f"{float(row['separation_m']) / sigma:.5g}",
                       row["contacts"]]


def main(program, _="", every=""):
    if not every:
        writer = csv.writer(sys.stdout, lineterminator="\n")
        writer.writerow(COLUMNS)
        for kind in faces.KINDS:
            writer.writerows(rows(program, kind))
        return 0
    with open(TABLE, newline="") as file:
        known = list(csv.DictReader(file))
    worst = 0
    for kind in list(faces.KINDS)[::int(every)]:
        for row, old in zip(rows(program, kind), (line for line in known if line["kind"] == kind), strict=True):
            worst = max(worst, abs(float(row[6]) / float(old["stiffness_sigma_over_Eg"]) - 1))
    print(f"largest difference {worst:.1e}")
    return worst > 1e-3


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
