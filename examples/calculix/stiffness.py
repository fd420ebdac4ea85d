#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The stiffness of a contact in CalculiX, with the laws that `fstiff export` writes by default and of the answer.

    python3 stiffness.py [--fstiff COMMAND] [--ccx COMMAND] [SCENE]

The blocks of two_blocks.py are pressed at 0.97 p and 1.03 p; what the pressure grows by, over how much closer the two
faces have come, is K. The script writes stiffness.inp and stiffness_law.inp into the current folder, runs CalculiX, and
prints this K and that of `fstiff run` at the pressures of the scene, joint.toml by default: of its first law, and, of
the built-in scene, whose peaks yield, of the answer and of the upper end of its band (`--law answer`). It ends with exit
code 1 where they differ by more than 1 %. Where CalculiX is missing it says SKIPPED.
"""
import pathlib
import sys

from blocks import HELD, curve_of, means, model, output_of, programs, rows_of_run, solved

SHARES = (0.97, 1.03)
LAW = "stiffness_law.inp"


def deck(pressures, closing):
    """The input: one step for each of `pressures` [MPa], after one that closes the faces by `closing` [mm]."""
    lines = model(LAW) + ["*BOUNDARY", *HELD]
    lines += ["*STEP", "*STATIC", "1, 1", "*BOUNDARY", f"TOP, 3, 3, {-closing:.12g}", "*END STEP"]
    for pressure in pressures:
        lines += ["*STEP, INC=1000", "*STATIC", "0.1, 1", "*BOUNDARY, OP=NEW", *HELD, "*DLOAD",
                  f"UPPER, P2, {pressure:.12g}", "*NODE PRINT, NSET=ABOVE, FREQUENCY=1000", "U",
                  "*NODE PRINT, NSET=BELOW, FREQUENCY=1000", "U", "*END STEP"]
    return lines


def last_overclosure():
    """Of the table of pressures in the file of the law [mm]."""
    rows = pathlib.Path(LAW).read_text(encoding="ascii").split("TABULAR\n")[1].split("*")[0].split()
    return float(rows[-1])


def compare(given, scene, law, pressures, stiffnesses, title):
    """The largest difference of K [MPa/mm] at `pressures` [MPa] in CalculiX, with the law that is exported by the options `law`."""
    output_of(given.fstiff, "export", *scene, "--to", "calculix", *law, "--units", "mm,N,MPa",
              "--from", f"{0.9 * pressures[0]:.12g} MPa", "--until", f"{1.1 * pressures[-1]:.12g} MPa", "-o", LAW)
    loads = [share * pressure for pressure in pressures for share in SHARES]
    tables = solved(given, "stiffness", deck(loads, last_overclosure() / 2))
    above, below = ([z for _, _, z in means(tables, name, "displacements")] for name in ("ABOVE", "BELOW"))
    if len(above) != len(loads):
        sys.exit(f"CalculiX solved {len(above)} of {len(loads)} steps")

    print(f"{title}, stiffness")
    print("   p [MPa]  CalculiX [MPa/mm]  fstiff [MPa/mm]  difference")
    worst = 0.0
    closed = [low - high for low, high in zip(below, above)]
    for i, (pressure, expected) in enumerate(zip(pressures, stiffnesses)):
        found = (loads[2 * i + 1] - loads[2 * i]) / (closed[2 * i + 1] - closed[2 * i])
        worst = max(worst, abs(found / expected - 1))
        print(f"{pressure:10.4g} {found:18.1f} {expected:16.1f} {100 * (found / expected - 1):9.3f} %")
    print(f"largest difference {100 * worst:.3f} %")
    return worst


def main():
    given = programs([str(pathlib.Path(__file__).with_name("joint.toml"))])
    rows, pressures, _ = curve_of(given)
    of_rows = [float(row["stiffness_Pa_per_m"]) / 1e9 for row in rows]
    worst = [compare(given, given.scene, ["--law", rows[0]["law"]], pressures, of_rows, f"law {rows[0]['law']}")]
    rows = rows_of_run(given, [])[10::10]  # 1, 10 and 100 MPa
    pressures = [float(row["pressure_Pa"]) / 1e6 for row in rows]
    for quantile, key in (("50%", ""), ("95%", "_p95")):  # the low end of run has the form of the faces, which a mesh has itself
        of_rows = [float(row[f"stiffness{key}_Pa_per_m"]) / 1e9 for row in rows]
        worst.append(compare(given, [], ["--law", "answer", "--quantile", quantile], pressures, of_rows, f"law answer, {quantile}"))
    return 0 if max(worst) <= 0.01 else 1


if __name__ == "__main__":
    sys.exit(main())
