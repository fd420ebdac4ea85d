#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes tests/data/broad.csv: boundary elements of Gaussian self-affine maps, narrow and broad.

    tools/make_broad.py build/release/bin/fstiff_broad            adds the maps that the table lacks; an hour of one core for all
    tools/make_broad.py build/release/bin/fstiff_broad --check 20 computes every twentieth map of 256 points again: exit code 1 when
                                                                  a stiffness differs by more than 1e-3

A map is (Hurst exponent, wave number of the roll-off, waves below it, cut-off, points a side, seed); wave numbers count waves a side.
The shortest wave has four points; of two maps also eight, on a grid twice as fine, which gives the error of the grid.
"""
import csv
import pathlib
import subprocess
import sys

TABLE = pathlib.Path(__file__).resolve().parent.parent / "tests" / "data" / "broad.csv"
COLUMNS = ("hurst", "roll_off", "long_waves", "cut_off", "points", "seed", "m0", "m2", "m4", "p_star", "stiffness_over_E",
           "area_fraction", "mean_gap", "spots")
FEW = {2: ("0.06", "0.01", "0.003")}  # p/(E g) of the maps of 2048 points by their roll-off; else those of bench/broad.cpp


def maps():
    """In the order of their cost."""
    for seed in (1, 2, 3, 4):
        for hurst in ("0.2", "0.5", "0.8", "0.999"):
            for roll_off, waves in ((4, "none"), (8, "none"), (16, "none"), (8, "plateau"), (16, "plateau")):
                yield hurst, roll_off, waves, 64, 256, seed
    for roll_off, cut_off, points, which in (
            (4, 64, 512, (("0.8", 1), ("0.2", 1))), (4, 256, 1024, (("0.8", 1),)),
            (4, 128, 512, [(hurst, seed) for seed in (1, 2, 3) for hurst in ("0.8", "0.999")]),
            (2, 256, 1024, (("0.999", 1), ("0.8", 1), ("0.999", 2))), (4, 512, 2048, (("0.8", 1),)),
            (4, 256, 1024, (("0.999", 1), ("0.8", 2), ("0.5", 1), ("0.999", 2), ("0.8", 3))), (4, 512, 2048, (("0.999", 1),)),
            (4, 128, 512, [(hurst, seed) for seed in (1, 2, 3) for hurst in ("0.2", "0.5")]),
            (2, 512, 2048, (("0.999", 1), ("0.8", 1)))):  # alpha of 500 to 1000
        for hurst, seed in which:
            yield hurst, roll_off, "none", cut_off, points, seed


def key(row):
    return tuple(str(row[c]) for c in COLUMNS[:6])


def computed(program, surface):
    few = FEW.get(surface[1], ()) if surface[4] == 2048 else ()
    return subprocess.run([program, *map(str, surface), *few], check=True, capture_output=True, text=True).stdout.splitlines()


def check(program, every):
    rows = list(csv.DictReader(TABLE.open()))
    small = [s for s in maps() if s[4] == 256][::every]
    pairs = [(float(row["stiffness_over_E"]), float(line.split(",")[10])) for surface in small
             for row, line in zip((r for r in rows if key(r) == tuple(map(str, surface))), computed(program, surface), strict=True)]
    worst = max(abs(known / again - 1) for known, again in pairs)
    print(f"{len(small)} maps, largest difference {worst:.1e}")
    return worst > 1e-3


def main(program, _="", every=""):
    if every:
        return check(program, int(every))
    done = {key(row) for row in csv.DictReader(TABLE.open())}
    for surface in maps():
        if tuple(map(str, surface)) not in done:
            with TABLE.open("a") as table:
                table.write("\n".join(computed(program, surface)) + "\n")
            print(*surface, flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
