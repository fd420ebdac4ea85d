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

SCENE = """
[surface]
peak_radius = "{radius!r} m"
rms_height = "{height!r} m"
peak_density = "500 /mm^2"

[material.upper]
youngs_modulus = "205 GPa"
poisson_ratio = 0.3

[contact]
laws = ["hertz", "greenwood_williamson"]
peaks = [ {{ theta = "pi/3", r = 0.5 }} ]
pressures = [ {pressures} ]
"""


def spaced(first, last, count):
    """Values between the ends by equal factors, as a range of a grid has them."""
    inner = [
        math.exp((1 - i / (count - 1)) * math.log(first) + i / (count - 1) * math.log(last)) for i in range(1, count - 1)
    ]
    return [first, *inner, last]


HEIGHTS = spaced(0.2e-6, 3e-6, 40)
RADII = [20e-6, 40e-6, 80e-6]
PRESSURES = spaced(0.1e6, 100e6, 25)


def compute(batch):
    """Rows of the surfaces of `batch`: radius, height, pressure, law and K."""
    import fstiff  # on the worker

    points = ", ".join(f'"{p!r} Pa"' for p in PRESSURES)
    rows = []
    for radius, height in batch:
        curves = fstiff.run(SCENE.format(radius=radius, height=height, pressures=points))
        columns = zip(curves["pressure_Pa"], curves["law"], curves["stiffness_Pa_per_m"])
        rows.extend((radius, height, float(p), str(law), float(k)) for p, law, k in columns)
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scheduler", help="address of a Dask scheduler; the default is a cluster on this machine")
    parser.add_argument("--workers", type=int, default=2, help="of the cluster on this machine")
    arguments = parser.parse_args()
    try:
        import fstiff  # noqa: F401
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
        print("peak_radius_m,rms_height_m,pressure_Pa,law,stiffness_Pa_per_m")
        for rows in client.gather(client.map(compute, batches)):
            for radius, height, pressure, law, stiffness in rows:
                print(f"{radius!r},{height!r},{pressure!r},{law},{stiffness!r}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
