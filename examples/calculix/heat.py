#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Heat through two pressed blocks in CalculiX, with the conductance that `fstiff export` writes.

    python3 heat.py [--fstiff COMMAND] [--ccx COMMAND] [SCENE]

The blocks of two_blocks.py carry the pressure p; the top is kept 100 K hotter than the base. The heat that flows, over
the jump of the temperature between the two faces, is the conductance of the contact: of the spots, and of what fills
the gap. The script writes heat.inp and heat_law.inp into the current folder, runs CalculiX, and prints this and what
`fstiff run` says at the pressures of the scene, joint.toml by default. It ends with exit code 1 where they differ by
more than 1 %.
Where CalculiX is missing it says SKIPPED.
"""
import pathlib
import sys

from blocks import AREA, HELD, curve_of, export_law, means, model, programs, solved

CONDUCTIVITY = 50.0  # of the blocks [mW/(mm K)]


def deck(pressures, closing):
    """The input: one step for each of `pressures` [MPa], after one that closes the faces by `closing` [mm]."""
    lines = model("heat_law.inp", ["*CONDUCTIVITY", f"{CONDUCTIVITY:g}"])
    lines += ["*INITIAL CONDITIONS, TYPE=TEMPERATURE", "ALL, 293", "*BOUNDARY", *HELD]
    # without NLGEOM CalculiX looks for the conductance where the faces were drawn
    step = ["*STEP, NLGEOM, INC=1000", "*COUPLED TEMPERATURE-DISPLACEMENT, STEADY STATE", "1, 1"]
    lines += [*step, "*BOUNDARY", f"TOP, 3, 3, {-closing:.12g}", "BASE, 11, 11, 293", "TOP, 11, 11, 293", "*END STEP"]
    for pressure in pressures:
        lines += [*step, "*BOUNDARY, OP=NEW", *HELD, "BASE, 11, 11, 293", "TOP, 11, 11, 393", "*DLOAD",
                  f"UPPER, P2, {pressure:.12g}", "*NODE PRINT, NSET=ABOVE, FREQUENCY=1000", "NT",
                  "*NODE PRINT, NSET=BELOW, FREQUENCY=1000", "NT", "*NODE PRINT, NSET=TOP, FREQUENCY=1000", "RFL",
                  "*END STEP"]
    return lines


def main():
    given = programs([str(pathlib.Path(__file__).with_name("joint.toml"))])
    rows, pressures, separations = curve_of(given)
    columns = [key for key in ("thermal_conductance_W_per_m2K", "thermal_conductance_gap_W_per_m2K") if key in rows[0]]
    export_law(given, rows[0]["law"], "heat_law.inp", 1.1 * pressures[-1])
    tables = solved(given, "heat", deck(pressures, separations[0] - separations[-1]))
    above, below, flow = (means(tables, *which) for which in
                          (("ABOVE", "temperatures"), ("BELOW", "temperatures"), ("TOP", "heat")))
    if len(flow) != len(pressures):
        sys.exit(f"CalculiX solved {len(flow)} of {len(pressures)} steps")

    print(f"law {rows[0]['law']}, conductance of heat")
    print("   p [MPa]  jump [K]  CalculiX [W/(m^2 K)]  fstiff [W/(m^2 K)]  difference")
    worst = 0.0
    for row, pressure, (hot,), (cold,), (mean,) in zip(rows, pressures, above, below, flow):
        found = 1e3 * 4 * mean / AREA / (hot - cold)  # four nodes; 1 mW/(mm^2 K) is 1000 W/(m^2 K)
        expected = sum(float(row[key]) for key in columns)
        worst = max(worst, abs(found / expected - 1))
        difference = 100 * (found / expected - 1)
        print(f"{pressure:10.4g} {hot - cold:9.3f} {found:21.1f} {expected:19.1f} {difference:9.3f} %")
    print(f"largest difference {100 * worst:.3f} %")
    return 0 if worst <= 0.01 else 1


if __name__ == "__main__":
    sys.exit(main())
