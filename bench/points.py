#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""10^6 random points on a grid of 1024 x 1024: processor time of fstiff next to scipy's LinearNDInterpolator, both on one thread.

Prints a table of bench/README.md. Both have points of one distribution on one surface; errors are over the rms height, of the nodes in
both, against the closed form. Needs numpy and scipy."""
import argparse
import json
import pathlib
import subprocess
import time

import numpy as np
from scipy.interpolate import LinearNDInterpolator

POINTS, STEPS, WAVE = 1000000, 1023, 64  # as points.cpp; lengths in steps


def height(x, y):
    return np.sin(2 * np.pi * x / WAVE) * np.cos(2 * np.pi * y / WAVE)


def by_scipy():
    """Processor time, and the root of the mean square of the errors over the rms height."""
    places = np.random.default_rng(1).uniform(0, STEPS, (POINTS, 2))
    heights = height(*places.T)
    begin = time.process_time()
    x, y = np.meshgrid(np.arange(STEPS + 1.0), np.arange(STEPS + 1.0))
    found = LinearNDInterpolator(places, heights)(x, y)
    seconds = time.process_time() - begin
    return seconds, np.sqrt(np.nanmean((found - height(x, y))[1:-1, 1:-1] ** 2)) / 0.5


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path, help="fstiff_bench")
    options = parser.parse_args()
    command = [options.program, "--benchmark_filter=^io/", "--benchmark_format=json", "--benchmark_repetitions=3"]
    rows = json.loads(subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE).stdout)["benchmarks"]
    unit = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1}
    least = {}
    for row in rows:
        if row["run_type"] != "aggregate":
            row["seconds"] = row["cpu_time"] * unit[row["time_unit"]]
            least[row["run_name"]] = min(least.get(row["run_name"], row), row, key=lambda one: one["seconds"])
    grid, text = least["io/points_on_grid/1000000"], least["io/triples/1000000"]
    seconds, error = by_scipy()
    print("| 10⁶ points | time | points/s | rms error over rms height | peer | over the peer |")
    print("| --- | ---: | ---: | ---: | --- | ---: |")
    print(f"| random, to 1024 x 1024 nodes | {grid['seconds']:.2f} s | {POINTS / grid['seconds']:.2g} | {grid['rms_err']:.1e} | "
          f"scipy's LinearNDInterpolator: {seconds:.1f} s, {error:.1e} | {grid['seconds'] / seconds:.2f} |")
    print(f"| text of x, y, z | {text['seconds']:.2f} s | {POINTS / text['seconds']:.2g} | {text['rel_err_max']:.0e} | "
          f"std::from_chars over the same bytes | {text['over_from_chars']:.1f} |")


if __name__ == "__main__":
    main()
