#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Many scenes with Dask and the Python package fstiff: on the cores of this machine, or on a cluster that Dask knows.

    python3 dask_sweep.py [--scheduler ADDRESS] [--workers N] > results.csv

The scenes are those of grid.toml, in the same order and to the last digit; they are sent to the workers in batches, since a
scene is quicker than a message. For 10^6 scenes and more, and for whatever must outlast an interruption, use `fstiff sweep`.
"""
import argparse
import itertools
import math
import sys

def spaced(first, last, count):
    """Values between the ends by equal factors, as a range of a grid has them."""
    inner = [
        math.exp((1 - i / (count - 1)) * math.log(first) + i / (count - 1) * math.log(last)) for i in range(1, count - 1)
    ]
    return [first, *inner, last]


HEIGHTS = spaced(0.2e-6, 3e-6, 40)
RADII = [20e-6, 40e-6, 80e-6]
PRESSURES = spaced(0.1e6, 100e6, 25)
SCENE = {
    "surface": {"peak_density": "500 /mm^2"},
    "material": {"upper": {"youngs_modulus": "205 GPa", "poisson_ratio": 0.3}},
    "contact": {
        "laws": ["hertz", "greenwood_williamson"],
        "peaks": [{"theta": "pi/3", "r": 0.5}],
        "pressures": [f"{pressure!r} Pa" for pressure in PRESSURES],
    },
}
COLUMNS = ["surface.peak_radius", "surface.rms_height", "pressure_Pa", "law", "stiffness_Pa_per_m"]


def compute(batch):
    """Rows of the surfaces of `batch`, a data frame of pandas."""
    import fstiff  # on the worker

    radii, heights = zip(*batch)
    axes = {"surface.peak_radius": radii, "surface.rms_height": heights}
    return fstiff.sweep(SCENE, axes, mode="zip", threads=1)[COLUMNS]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scheduler", help="address of a Dask scheduler; the default is a cluster on this machine")
    parser.add_argument("--workers", type=int, default=2, help="of the cluster on this machine")
    arguments = parser.parse_args()
    try:
        import fstiff  # noqa: F401
        import pandas
        from dask.distributed import Client, LocalCluster
    except ImportError as missing:
        print(f"SKIPPED: {missing}", file=sys.stderr)
        return 0

    surfaces = list(itertools.product(RADII, HEIGHTS))
    batches = [surfaces[i : i + 10] for i in range(0, len(surfaces), 10)]
    cluster = arguments.scheduler or LocalCluster(
        n_workers=arguments.workers, threads_per_worker=1, dashboard_address=None
    )
    with Client(cluster) as client:
        pandas.concat(client.gather(client.map(compute, batches))).to_csv(sys.stdout, index=False)
    return 0


if __name__ == "__main__":
    sys.exit(main())
