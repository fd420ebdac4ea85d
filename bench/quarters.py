#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Counts how often the band of a quarter of a public map, given the area of the whole, holds K of the whole by boundary elements.

    bench/quarters.py build/release/bin/fstiff [FOLDER]        FOLDER holds the maps, ../shared/surfaces by default

Steel that never yields on itself, p* = 0.001, 0.01 and 0.1 of the whole; the number stands in docs/accuracy.md.
"""
import json
import math
import pathlib
import re
import subprocess
import sys

# One more key, and the width in m where the steps along x and y are not equal.
MAPS = {"matrix-3.txt": ("", 0), "matrix-4.txt": ("", 0), "x3p-2.x3p": ("", 82.849e-6), "x3ptools_sample-land.x3p": ("fill = true", 0)}
FSTIFF = sys.argv[1]
FOLDER = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else "../shared/surfaces").resolve()


def fstiff(*arguments, text=None):
    found = subprocess.run([FSTIFF, *arguments, "--format", "json"], input=text, capture_output=True, text=True)
    if not found.stdout:
        raise RuntimeError(found.stderr)
    return json.loads(found.stdout)


def answers(surface, pressures, contact=()):
    lines = ["[surface]", *surface, "[material.upper]", 'youngs_modulus = "205 GPa"', "poisson_ratio = 0.3", 'hardness = "infinite"', "[contact]", *contact,
             "pressures = [" + ", ".join(f'"{p:.9g} Pa"' for p in pressures) + "]"]
    return fstiff("run", "-", text="\n".join(lines))


inside = count = 0
for name, (more, width) in MAPS.items():
    whole = [f'from = "{FOLDER / name}"'] + [more] * bool(more)
    measured = fstiff("measure", FOLDER / name, *["--fill"] * bool(more))
    columns, rows = (int(n) for n in re.search(r"points: (\d+) x (\d+)", " ".join(measured["source"]["decisions"])).groups())
    side = measured["long_end"]["side_m"]
    x = width or side * math.sqrt(columns / rows)
    y = side**2 / x
    first = answers(whole, [1e7])["answer"][0]
    pressures = [first["pressure_Pa"] / first["p_star"] * p_star for p_star in (0.001, 0.01, 0.1)]
    truth = {row["pressure_Pa"]: row["stiffness_Pa_per_m"]
             for row in answers(whole, pressures, ['laws = ["boundary_elements"]'])["rows"]}
    held = 0
    for left, below in ((0, 0), (1, 0), (0, 1), (1, 1)):
        crop = ",".join(f"{part / 2 * size:.9g} m" for part, size in ((left, x), (left + 0.97, x), (below, y), (below + 0.97, y)))
        for row in answers([*whole, f'crop = "{crop}"'], pressures, [f'nominal_area = "{x * y:.9g} m^2"'])["answer"]:
            if K := truth.get(row["pressure_Pa"]):
                count += 1
                held += row["stiffness_p05_Pa_per_m"] <= K <= row["stiffness_p95_Pa_per_m"]
    inside += held
    print(f"{name}: {held}")
print(f"{inside} of {count} bands hold K of the whole")
