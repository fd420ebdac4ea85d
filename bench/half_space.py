#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Boundary elements of rough maps: processor time of fstiff next to Tamaas, both on one thread.

fstiff solves the contact to its default tolerance, 1e-8 of the pressures, finds K of it, and does both again on the grid
half as fine; Tamaas solves the contact alone (PolonskyKeerRey, tolerance 1e-9). The last column is the sum over the points
of what the two pressures differ by, over their sum. Needs numpy; where Tamaas is not installed its columns are empty.
"""
import argparse
import csv
import os
import pathlib
import subprocess
import sys
import tempfile
import time

os.environ["OMP_NUM_THREADS"] = "1"
import numpy as np  # noqa: E402

try:
    import tamaas
except ImportError:
    tamaas = None


def gaussian_map(points, cut, seed):
    """Heights of a repeating square of side 1: H = 0.8, from 4 waves a side to `cut`; rms gradient 1."""
    wave = np.fft.fftfreq(points, 1 / points)
    q = np.hypot(wave[:, None], wave)
    inside = (q > 0) & (q <= cut)
    noise = np.fft.fft2(np.random.default_rng(seed).standard_normal((points, points)))
    waves = np.where(inside, noise * np.maximum(q, 4) ** -1.8, 0)
    gradient = 2 * np.pi * np.sqrt((np.abs(waves) ** 2 * q**2).sum()) / points**2
    return np.fft.ifft2(waves).real / gradient


def by_tamaas(heights, pressure, tolerance):
    """Least processor time of up to three solutions, and the pressures."""
    points = heights.shape[0]
    least = np.inf
    for _ in range(3 if points <= 256 else 1):
        model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, [1.0, 1.0], [points, points])
        model.E, model.nu = 1.0, 0.0
        solver = tamaas.PolonskyKeerRey(model, heights, tolerance)
        solver.max_iter = 3000
        begin = time.process_time()
        solver.solve(pressure)
        least = min(least, time.process_time() - begin)
    return least, np.array(model.traction)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path, help="fstiff_half_space")
    parser.add_argument("--points", type=int, nargs="+", default=[256, 512], help="along a side")
    parser.add_argument("--pressures", type=float, nargs="+", default=[0.003, 0.03, 0.25], help="p* = p/(E g)")
    options = parser.parse_args()
    if tamaas is None:
        print("Tamaas is not installed (pip install tamaas): no peer", file=sys.stderr)
    else:
        tamaas.set_log_level(tamaas.LogLevel.error)
    print("| points | shortest wave | p* | fstiff, K and two grids | Tamaas, contact alone | ratio | difference |")
    print("| ---: | ---: | ---: | ---: | ---: | ---: | ---: |")
    with tempfile.TemporaryDirectory() as folder:
        for points in options.points:
            for cells in (8, 2):
                heights = gaussian_map(points, points // cells, 1)
                file, out = pathlib.Path(folder) / "map", pathlib.Path(folder) / "pressures"
                heights.tofile(file)
                run = [options.program, file, str(points), out, *map(str, options.pressures)]
                printed = subprocess.run(run, check=True, text=True, stdout=subprocess.PIPE).stdout
                rows = csv.DictReader(printed.splitlines())
                solved = np.fromfile(out).reshape(-1, points, points)
                for row, pressures in zip(rows, solved):
                    p = float(row["pressure"])
                    cell = [points, f"{cells} points", f"{p:g}", f"{float(row['seconds']):.3f} s"]
                    if tamaas:
                        seconds, other = by_tamaas(heights, p, 1e-9)
                        difference = np.abs(pressures - other).sum() / other.sum()
                        cell += [f"{seconds:.3f} s", f"{seconds / float(row['seconds']):.1f}", f"{difference:.0e}"]
                    print("|", " | ".join(str(x) for x in cell + ["-"] * (7 - len(cell))), "|", flush=True)


if __name__ == "__main__":
    main()
