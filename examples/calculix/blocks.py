# SPDX-License-Identifier: BSD-3-Clause
"""What the examples around CalculiX share: two steel blocks on one another, and how the programs are run.

The blocks are 10 mm high on 10 mm x 10 mm; units are mm, N, MPa, s and K.
"""
import argparse
import csv
import io
import shutil
import subprocess
import sys

SIDE, HEIGHT = 10.0, 10.0  # of a block [mm]
AREA = SIDE * SIDE
MODULUS, POISSON = 210e3, 0.3  # [MPa]
CORNERS = [(0, 0), (1, 0), (1, 1), (0, 1)]
HELD = ["BASE, 3, 3", "PLANE_X, 1, 1", "PLANE_Y, 2, 2"]  # the sides are free, so that the stress is p everywhere


def block(first, bottom):
    """Nodes and the element of a block from the height `bottom` on, numbered from `first`."""
    nodes = [(x * SIDE, y * SIDE, z) for z in (bottom, bottom + HEIGHT) for x, y in CORNERS]
    numbers = range(first, first + 8)
    lines = [f"{n}, {x:g}, {y:g}, {z:g}" for n, (x, y, z) in zip(numbers, nodes)]
    return lines, f"{first}, " + ", ".join(map(str, numbers))


def model(law, material=()):
    """Two blocks with the contact of the file `law` between them, up to the first step; `material` are more cards."""
    lower_nodes, lower = block(1, 0.0)
    upper_nodes, upper = block(11, HEIGHT)
    return [
        "*NODE, NSET=ALL", *lower_nodes, *upper_nodes,
        "*ELEMENT, TYPE=C3D8, ELSET=LOWER", lower,
        "*ELEMENT, TYPE=C3D8, ELSET=UPPER", upper,
        "*NSET, NSET=BASE", "1, 2, 3, 4",
        "*NSET, NSET=BELOW", "5, 6, 7, 8",
        "*NSET, NSET=ABOVE", "11, 12, 13, 14",
        "*NSET, NSET=TOP", "15, 16, 17, 18",
        "*NSET, NSET=PLANE_X", "1, 4, 5, 8, 11, 14, 15, 18",
        "*NSET, NSET=PLANE_Y", "1, 2, 5, 6, 11, 12, 15, 16",
        "*MATERIAL, NAME=STEEL", "*ELASTIC", f"{MODULUS:g}, {POISSON:g}", *material,
        "*SOLID SECTION, ELSET=LOWER, MATERIAL=STEEL",
        "*SOLID SECTION, ELSET=UPPER, MATERIAL=STEEL",
        "*SURFACE, NAME=LOWER_FACE", "LOWER, S2",
        "*SURFACE, NAME=UPPER_FACE", "UPPER, S1",
        f"*INCLUDE, INPUT={law}",
        "*CONTACT PAIR, INTERACTION=FSTIFF, TYPE=NODE TO SURFACE", "UPPER_FACE, LOWER_FACE",
    ]


def output_of(*command):
    ended = subprocess.run(command, capture_output=True, text=True)
    if ended.returncode not in (0, 4):  # 4: fstiff doubts the result and says why
        sys.exit(f"{' '.join(command)} ends with {ended.returncode}:\n{ended.stdout[-2000:]}{ended.stderr}")
    return ended.stdout


def programs(scene=()):
    """The command line: SCENE, which is `scene` by default, and the two programs."""
    arguments = argparse.ArgumentParser()
    arguments.add_argument("scene", nargs="*", default=list(scene))
    arguments.add_argument("--fstiff", default="fstiff")
    arguments.add_argument("--ccx", default="ccx")
    given = arguments.parse_args()
    if not shutil.which(given.ccx):
        print(f"SKIPPED: {given.ccx} is missing (Debian: calculix-ccx)")
        sys.exit(0)
    return given


def rows_of_run(given, scene):
    """The first law that `fstiff run` prints for the scene: its rows as dictionaries of text."""
    rows = list(csv.DictReader(io.StringIO(output_of(given.fstiff, "run", *scene, "--format", "csv"))))
    return [row for row in rows if all(row[key] == rows[0][key] for key in ("law", "theta", "r", "answer"))]


def curve_of(given):
    """The first law that `fstiff run` prints for the scene: its rows, pressures [MPa] and separations [mm]."""
    rows = rows_of_run(given, given.scene)
    return rows, [float(row["pressure_Pa"]) / 1e6 for row in rows], [float(row["separation_m"]) * 1e3 for row in rows]


def export_law(given, law, file, until, *more):
    """Writes `law` of the scene up to `until` [MPa] as the contact of CalculiX."""
    output_of(given.fstiff, "export", *given.scene, "--to", "calculix", "--law", law, "--units", "mm,N,MPa",
              "--tolerance", "0.1%", "--until", f"{until:.12g} MPa", *more, "-o", file)


def solved(given, name, lines):
    """Runs CalculiX on `lines`; the tables of the .dat file in their order: set, first word of the title, rows."""
    with open(f"{name}.inp", "w", encoding="ascii") as file:
        file.write("\n".join(lines) + "\n")
    output_of(given.ccx, name)
    tables = []
    with open(f"{name}.dat", encoding="ascii") as file:
        for line in file:
            cells = line.split()
            if " for set " in line:
                tables.append((line.split(" for set ")[1].split()[0], line.split()[0], []))
            elif cells and cells[0].isdigit():
                tables[-1][2].append([float(cell) for cell in cells[1:]])
    return tables


def means(tables, of_set, quantity):
    """The means of the columns of the tables of `quantity` on the nodes `of_set`, one list a step."""
    return [[sum(column) / len(column) for column in zip(*rows)]
            for name, title, rows in tables if (name, title) == (of_set, quantity)]
