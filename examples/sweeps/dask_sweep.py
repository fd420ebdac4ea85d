#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A sweep with Dask and the Python package fstiff: on the cores of this machine, or on a cluster that Dask has.

    python3 dask_sweep.py GRID SCENES [--scheduler ADDRESS] [--chunk N] [--workers N] > results.csv

SCENES is what `fstiff sweep GRID --count` prints. The rows are those of `fstiff sweep GRID`, in the same order and to the last digit.
Workers get the text of the grid, so that they need no common folder; a chunk whose worker is lost is computed by another one.
"""
import argparse
import pathlib
import sys


def compute(grid, rows):
    """The rows of some scenes, a data frame of pandas."""
    import fstiff  # on the worker

    return fstiff.sweep(grid, {}, rows=rows, threads=1)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("grid", type=pathlib.Path)
    parser.add_argument("scenes", type=int)
    parser.add_argument("--scheduler", help="address of a Dask scheduler; the default is a cluster on this machine")
    parser.add_argument("--chunk", type=int, default=1000, help="scenes of one task; some seconds of work each are best")
    parser.add_argument("--workers", type=int, default=2, help="of the cluster on this machine")
    arguments = parser.parse_args()
    try:
        import fstiff  # noqa: F401
        import pandas
        from dask.distributed import Client, LocalCluster, progress
    except ImportError as missing:
        print(f"SKIPPED: {missing}", file=sys.stderr)
        return 0

    grid, scenes = arguments.grid.read_text(encoding="utf-8"), arguments.scenes
    chunks = [(begin, min(begin + arguments.chunk, scenes)) for begin in range(0, scenes, arguments.chunk)]
    local = {"n_workers": arguments.workers, "threads_per_worker": 1, "dashboard_address": None}
    with Client(arguments.scheduler or LocalCluster(**local)) as client:
        parts = client.map(lambda rows: compute(grid, rows), chunks, retries=3)
        if sys.stderr.isatty():
            progress(parts)
        frame = pandas.concat(client.gather(parts), ignore_index=True)
    frame.to_csv(sys.stdout, index=False)
    return 0


if __name__ == "__main__":
    sys.exit(main())
