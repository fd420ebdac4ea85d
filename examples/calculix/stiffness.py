#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The stiffness of a contact in CalculiX, with the law that `fstiff export` writes by default.

    python3 stiffness.py [--fstiff COMMAND] [--ccx COMMAND] [SCENE]

The blocks of two_blocks.py are pressed at 0.97 p and 1.03 p; what the pressure grows by, over how much closer the two
faces have come, is K. The script writes stiffness.inp and stiffness_law.inp into the current folder, runs CalculiX, and
prints this K and that of `fstiff run` at the pressures of the scene, joint.toml by default. It ends with exit code 1
where they differ by more than 2 %, the tolerance of the slope. Where CalculiX is missing it says SKIPPED.
"""
import pathlib
import sys

from blocks import HELD, curve_of, means, model, output_of, programs, solved

SHARES = (0.97, 1.03)


def deck(pressures, closing):
    """The input: one step for each of `pressures` [MPa], after one that closes the faces by `closing` [mm]."""
    lines = model("stiffness_law.inp") + ["*BOUNDARY", *HELD]
    lines += ["*STEP", "*STATIC", "1, 1", "*BOUNDARY", f"TOP, 3, 3, {-closing:.12g}", "*END STEP"]
    for pressure in pressures:
        lines += ["*STEP, INC=1000", "*STATIC", "0.1, 1", "*BOUNDARY, OP=NEW", *HELD, "*DLOAD",
                  f"UPPER, P2, {pressure:.12g}", "*NODE PRINT, NSET=ABOVE, FREQUENCY=1000", "U",
                  "*NODE PRINT, NSET=BELOW, FREQUENCY=1000", "U", "*END STEP"]
    return lines


def main():
    given = programs([str(pathlib.Path(__file__).with_name("joint.toml"))])
    rows, pressures, separations = curve_of(given)
    output_of(given.fstiff, "export", *given.scene, "--to", "calculix", "--law", rows[0]["law"], "--units", "mm,N,MPa",
              "--from", f"{0.9 * pressures[0]:.12g} MPa", "--until", f"{1.1 * pressures[-1]:.12g} MPa",
              "-o", "stiffness_law.inp")
    loads = [share * pressure for pressure in pressures for share in SHARES]
    tables = solved(given, "stiffness", deck(loads, separations[0] - separations[-1]))
    above, below = ([z for _, _, z in means(tables, name, "displacements")] for name in ("ABOVE", "BELOW"))
    if len(above) != len(loads):
        sys.exit(f"CalculiX solved {len(above)} of {len(loads)} steps")

    print(f"law {rows[0]['law']}, stiffness")
    print("   p [MPa]  CalculiX [MPa/mm]  fstiff [MPa/mm]  difference")
    worst = 0.0
    closed = [low - high for low, high in zip(below, above)]
    for i, (row, pressure) in enumerate(zip(rows, pressures)):
        found = (loads[2 * i + 1] - loads[2 * i]) / (closed[2 * i + 1] - closed[2 * i])
        expected = float(row["stiffness_Pa_per_m"]) / 1e9
        worst = max(worst, abs(found / expected - 1))
        print(f"{pressure:10.4g} {found:18.1f} {expected:16.1f} {100 * (found / expected - 1):9.3f} %")
    print(f"largest difference {100 * worst:.3f} %")
    return 0 if worst <= 0.02 else 1


if __name__ == "__main__":
    sys.exit(main())
