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
import sys

from blocks import HEIGHT, HELD, MODULUS, curve_of, export_law, means, model, programs, solved


def deck(pressures, closing):
    """The input of CalculiX: one step for each of `pressures` [MPa], after one that closes the faces by `closing` [mm]."""
    lines = model("law.inp") + ["*BOUNDARY", *HELD]
    # the faces are closed by hand first: pressed from mere touch, the upper block would hang on nothing
    lines += ["*STEP", "*STATIC", "1, 1", "*BOUNDARY", f"TOP, 3, 3, {-closing:.12g}", "*END STEP"]
    for pressure in pressures:
        lines += ["*STEP, INC=1000", "*STATIC", "0.1, 1", "*BOUNDARY, OP=NEW", *HELD, "*DLOAD",
                  f"UPPER, P2, {pressure:.12g}", "*NODE PRINT, NSET=TOP, FREQUENCY=1000", "U", "*END STEP"]
    return lines


def main():
    given = programs()
    rows, pressures, separations = curve_of(given)
    # the last row lies above every pressure: beyond it the contact would have no stiffness
    export_law(given, rows[0]["law"], "law.inp", 1.1 * pressures[-1])
    tables = solved(given, "two_blocks", deck(pressures, separations[0] - separations[-1]))
    found = [-z for _, _, z in means(tables, "TOP", "displacements")]
    if len(found) != len(pressures):
        sys.exit(f"CalculiX solved {len(found)} of {len(pressures)} steps")

    print(f"law {rows[0]['law']}, approach from {pressures[0]:g} MPa on")
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
