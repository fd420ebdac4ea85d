#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Two blocks pressed together in CalculiX, with the contact law that `fstiff export` writes.

    python3 two_blocks.py [--fstiff COMMAND] [--ccx COMMAND] [SCENE]

A column of two steel blocks, each 10 mm high on 10 mm x 10 mm, carries the pressure p on its top face. The sides are free,
so that the stress is p everywhere, and the top face comes down by

    approach(p) - approach(p0) = d(p0) - d(p) + (p - p0) (h1/E1 + h2/E2)

where d(p) is the separation of the two rough faces as `fstiff run` prints it, and p0 the smallest pressure of the scene.
The script writes two_blocks.inp and law.inp into the current folder, runs CalculiX, and prints both sides of this equation
at the other pressures of the scene. It ends with exit code 1 where they differ by more than 1 %.
Where CalculiX is missing it says SKIPPED.
"""
import argparse
import csv
import io
import shutil
import subprocess
import sys

SIDE, HEIGHT = 10.0, 10.0  # of a block [mm]
MODULUS, POISSON = 210e3, 0.3  # [MPa]
CORNERS = [(0, 0), (1, 0), (1, 1), (0, 1)]


def block(first, bottom):
    """Nodes and the element of a block from the height `bottom` on, numbered from `first`."""
    nodes = [(x * SIDE, y * SIDE, z) for z in (bottom, bottom + HEIGHT) for x, y in CORNERS]
    numbers = range(first, first + 8)
    lines = [f"{n}, {x:g}, {y:g}, {z:g}" for n, (x, y, z) in zip(numbers, nodes)]
    return lines, f"{first}, " + ", ".join(map(str, numbers))


def deck(pressures, closing):
    """The input of CalculiX: one step for each of `pressures` [MPa], after one that closes the faces by `closing` [mm]."""
    lower_nodes, lower = block(1, 0.0)
    upper_nodes, upper = block(11, HEIGHT)
    held = "BASE, 3, 3", "PLANE_X, 1, 1", "PLANE_Y, 2, 2"
    lines = [
        "*NODE, NSET=ALL", *lower_nodes, *upper_nodes,
        "*ELEMENT, TYPE=C3D8, ELSET=LOWER", lower,
        "*ELEMENT, TYPE=C3D8, ELSET=UPPER", upper,
        "*NSET, NSET=BASE", "1, 2, 3, 4",
        "*NSET, NSET=TOP", "15, 16, 17, 18",
        "*NSET, NSET=PLANE_X", "1, 4, 5, 8, 11, 14, 15, 18",
        "*NSET, NSET=PLANE_Y", "1, 2, 5, 6, 11, 12, 15, 16",
        "*MATERIAL, NAME=STEEL", "*ELASTIC", f"{MODULUS:g}, {POISSON:g}",
        "*SOLID SECTION, ELSET=LOWER, MATERIAL=STEEL",
        "*SOLID SECTION, ELSET=UPPER, MATERIAL=STEEL",
        "*SURFACE, NAME=LOWER_FACE", "LOWER, S2",
        "*SURFACE, NAME=UPPER_FACE", "UPPER, S1",
        "*INCLUDE, INPUT=law.inp",
        "*CONTACT PAIR, INTERACTION=FSTIFF, TYPE=NODE TO SURFACE", "UPPER_FACE, LOWER_FACE",
        "*BOUNDARY", *held,
    ]
    # the faces are closed by hand first: pressed from mere touch, the upper block would hang on nothing
    lines += ["*STEP", "*STATIC", "1, 1", "*BOUNDARY", f"TOP, 3, 3, {-closing:.12g}", "*END STEP"]
    for pressure in pressures:
        lines += ["*STEP, INC=1000", "*STATIC", "0.1, 1", "*BOUNDARY, OP=NEW", *held, "*DLOAD",
                  f"UPPER, P2, {pressure:.12g}", "*NODE PRINT, NSET=TOP, FREQUENCY=1000", "U", "*END STEP"]
    return "\n".join(lines) + "\n"


def approaches(text):
    """The mean of the displacements of the top face at the end of each step [mm], from the .dat file."""
    tables = [[]]
    for line in text.splitlines():
        cells = line.split()
        if line.strip().startswith("displacements"):
            tables.append([])
        elif len(cells) == 4:
            tables[-1].append(-float(cells[3]))
    return [sum(table) / len(table) for table in tables if table]


def output_of(*command):
    ended = subprocess.run(command, capture_output=True, text=True)
    if ended.returncode not in (0, 4):  # 4: fstiff doubts the result and says why
        sys.exit(f"{' '.join(command)} ends with {ended.returncode}:\n{ended.stdout[-2000:]}{ended.stderr}")
    return ended.stdout


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("scene", nargs="*", default=[])
    arguments.add_argument("--fstiff", default="fstiff")
    arguments.add_argument("--ccx", default="ccx")
    given = arguments.parse_args()
    if not shutil.which(given.ccx):
        print(f"SKIPPED: {given.ccx} is missing (Debian: calculix-ccx)")
        return 0

    rows = list(csv.DictReader(io.StringIO(output_of(given.fstiff, "run", *given.scene, "--format", "csv"))))
    first = rows[0]
    rows = [row for row in rows if all(row[key] == first[key] for key in ("law", "theta", "r"))]
    pressures = [float(row["pressure_Pa"]) / 1e6 for row in rows]
    separations = [float(row["separation_m"]) * 1e3 for row in rows]
    # the last row lies above every pressure: beyond it the contact would have no stiffness
    output_of(given.fstiff, "export", *given.scene, "--to", "calculix", "--units", "mm,N,MPa", "--tolerance", "0.1%",
              "--until", f"{1.1 * pressures[-1]:.12g} MPa", "-o", "law.inp")
    with open("two_blocks.inp", "w", encoding="ascii") as file:
        file.write(deck(pressures, separations[0] - separations[-1]))
    output_of(given.ccx, "two_blocks")
    with open("two_blocks.dat", encoding="ascii") as file:
        found = approaches(file.read())
    if len(found) != len(pressures):
        sys.exit(f"CalculiX solved {len(found)} of {len(pressures)} steps")

    print(f"law {first['law']}, approach from {pressures[0]:g} MPa on")
    print("   p [MPa]  CalculiX [um]  fstiff and E [um]  difference")
    worst = 0.0
    for pressure, separation, approach in zip(pressures[1:], separations[1:], found[1:]):
        expected = separations[0] - separation + (pressure - pressures[0]) * 2 * HEIGHT / MODULUS
        difference = (approach - found[0]) / expected - 1
        worst = max(worst, abs(difference))
        print(f"{pressure:10.4g} {1e3 * (approach - found[0]):14.5f} {1e3 * expected:18.5f} {100 * difference:9.3f} %")
    print(f"largest difference {100 * worst:.3f} %")
    return 0 if worst <= 0.01 else 1


if __name__ == "__main__":
    sys.exit(main())
