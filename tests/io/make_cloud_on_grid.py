#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes tests/data/cloud_on_grid.csv: a random cloud and its heights at the nodes of a grid by scipy's LinearNDInterpolator.

    tests/io/make_cloud_on_grid.py            prints the table
    tests/io/make_cloud_on_grid.py --check    compares it with the table: exit code 1 where a height differs by more than 1e-12

Rows "point" are the cloud in mm; rows "node" lie 0.25 mm apart, where they are in the convex hull.
"""
import csv
import pathlib
import sys

import numpy as np
from scipy.interpolate import LinearNDInterpolator

TABLE = pathlib.Path(__file__).resolve().parent.parent / "data" / "cloud_on_grid.csv"


def rows():
    random = np.random.default_rng(70)
    points = np.round(random.uniform(0, 6, (400, 2)), 5)
    heights = np.round(0.2 * np.sin(2 * points[:, 0]) * np.cos(3 * points[:, 1]) + 0.1 * points[:, 0], 6)
    at = LinearNDInterpolator(points, heights)
    yield from (("point", x, y, z) for (x, y), z in zip(points, heights))
    for y in np.arange(0, 6.1, 0.25):
        for x in np.arange(0, 6.1, 0.25):
            z = float(at(x, y))
            if not np.isnan(z):
                yield "node", x, y, z


if __name__ == "__main__":
    made = list(rows())
    if "--check" in sys.argv:
        with TABLE.open() as file:
            there = [(row["kind"], float(row["x"]), float(row["y"]), float(row["z"])) for row in csv.DictReader(file)]
        sys.exit(0 if len(there) == len(made) and all(a[:3] == b[:3] and abs(a[3] - b[3]) < 1e-12 for a, b in zip(made, there)) else 1)
    print("kind,x,y,z")
    for kind, x, y, z in made:
        print(f"{kind},{float(x)!r},{float(y)!r},{float(z)!r}")
