#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A pressed block that sticks and slips in CalculiX, with the stick slope that `fstiff export` writes.

    python3 friction.py [--fstiff COMMAND] [--ccx COMMAND] [SCENE]

The upper of the blocks of two_blocks.py carries the pressure p, the middle one of the scene, and its lower face is
pushed sideways. While it sticks, the shear stress is K_t, the tangential stiffness that `fstiff run` prints at p, times
the way of the two faces past each other; then it slips at mu p. The script writes friction.inp and friction_law.inp
into the current folder, runs CalculiX, and prints the stress of both along the way. It ends with exit code 1 where they
differ by more than 1 %. Where CalculiX is missing it says SKIPPED.
"""
import json
import pathlib
import sys

from blocks import AREA, HELD, curve_of, export_law, means, model, output_of, programs, solved

WAYS = (0.25, 0.5, 0.75, 1.5, 3.0)  # of the pushed face, in mu p/K_t, at which the contact begins to slip


def deck(pressure, closing, slip):
    """The input of CalculiX: the faces are closed by `closing` [mm], pressed [MPa], pushed by WAYS of `slip` [mm]."""
    lines = model("friction_law.inp") + ["*BOUNDARY", *HELD]
    lines += ["*STEP", "*STATIC", "1, 1", "*BOUNDARY", f"TOP, 3, 3, {-closing:.12g}", "*END STEP"]
    held = ["BASE, 1, 3", "BELOW, 1, 2", "ABOVE, 2, 2"]
    for way in (0.0, *WAYS):
        lines += ["*STEP, INC=1000", "*STATIC", "0.1, 1", "*BOUNDARY, OP=NEW", *held, f"ABOVE, 1, 1, {way * slip:.12g}",
                  "*DLOAD", f"UPPER, P2, {pressure:.12g}", "*NODE PRINT, NSET=ABOVE, FREQUENCY=1000", "U, RF",
                  "*NODE PRINT, NSET=BELOW, FREQUENCY=1000", "U", "*END STEP"]
    return lines


def coefficient_of(given):
    document = json.loads(output_of(given.fstiff, "run", *given.scene, "--format", "json"))
    return document["inputs"]["friction.coefficient"]["value"]


def main():
    given = programs([str(pathlib.Path(__file__).with_name("joint.toml"))])
    rows, pressures, separations = curve_of(given)
    middle = len(rows) // 2
    pressure, stiffness = pressures[middle], float(rows[middle]["tangential_stiffness_Pa_per_m"]) / 1e9  # [MPa, MPa/mm]
    limit = coefficient_of(given) * pressure
    export_law(given, rows[0]["law"], "friction_law.inp", 1.1 * pressures[-1], "--at", f"{pressure:.12g} MPa")
    tables = solved(given, "friction", deck(pressure, separations[0] - separations[-1], limit / stiffness))
    above, below, force = (means(tables, *which)[1:] for which in
                           (("ABOVE", "displacements"), ("BELOW", "displacements"), ("ABOVE", "forces")))
    if len(force) != len(WAYS):
        sys.exit(f"CalculiX solved {len(force)} of {len(WAYS)} steps")

    print(f"law {rows[0]['law']} at {pressure:.4g} MPa: mu p {limit:.4g} MPa, K_t {stiffness:.4g} MPa/mm")
    print("  way [um]  CalculiX [MPa]  fstiff [MPa]  difference")
    worst = 0.0
    for (upper, _, _), (lower, _, _), (pushing, _, _) in zip(above, below, force):
        found, expected = 4 * pushing / AREA, min(stiffness * (upper - lower), limit)
        difference = found / expected - 1
        worst = max(worst, abs(difference))
        state = "slips" if stiffness * (upper - lower) > limit else "sticks"
        print(f"{1e3 * (upper - lower):10.4g} {found:15.5f} {expected:13.5f} {100 * difference:9.3f} %  {state}")
    print(f"largest difference {100 * worst:.3f} %")
    return 0 if worst <= 0.01 else 1


if __name__ == "__main__":
    sys.exit(main())
