#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes tests/data/surfaces_expected.csv: what independent readers find in measured files.

    pip install numpy sdfio x3pio surfacetopography        (2.4.6, 2.0.0, 2.0.0, 1.27.1 made the committed table)
    python3 tools/make_surface_expectations.py FOLDER [OUTPUT]

FOLDER holds the files. The table is made by sdfio (SDF), x3pio (X3P) and numpy.loadtxt (text), lengths in metres, rows
and columns in the order of the file (triples: ascending y, ascending x). Text carries its sizes and units below, typed
from the files' headers, not parsed. Where surfacetopography opens the file too, its heights must agree with the table to
1e-12 of their range, or nothing is written.

Columns: reader; rows (1: a profile) and columns; dx, dy (dy = 0 of a profile); missing points; min, max, mean, rms (about
the mean) of the points that exist, summed with math.fsum; and heights of single points, "row:column:height". Numbers are
printed so that they read back as the same double. The rms of numbers this size, over at most 422500 points, is good to
1e-14 relative to the largest height.
"""
import csv
import io
import math
import pathlib
import re
import sys
import zipfile

import numpy
import sdfio
import x3pio

folder = pathlib.Path(sys.argv[1])
output = (pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else
          pathlib.Path(__file__).resolve().parent.parent / "tests" / "data" / "surfaces_expected.csv")


def loadtxt(name, skip=0, **options):
    text = (folder / name).read_bytes().decode("latin-1").replace("\r", "")
    return numpy.loadtxt(io.StringIO(text), skiprows=skip, **options)


def profile(name, x_unit, z_unit, skip=0, **options):
    x, z = loadtxt(name, skip, **options).T
    return "numpy.loadtxt", (z * z_unit)[None, :], (x[-1] - x[0]) / (len(x) - 1) * x_unit, 0.0


def matrix(name, skip, dx, dy, unit, **options):
    return "numpy.loadtxt", loadtxt(name, skip, **options) * unit, dx, dy


def triples(name, unit, z_unit, **options):
    x, y, z = loadtxt(name, **options).T
    xs, ys = numpy.unique(x), numpy.unique(y)
    heights = numpy.full((len(ys), len(xs)), numpy.nan)
    heights[numpy.searchsorted(ys, y), numpy.searchsorted(xs, x)] = z * z_unit
    return ("numpy.loadtxt", heights, (xs[-1] - xs[0]) / (len(xs) - 1) * unit, (ys[-1] - ys[0]) / (len(ys) - 1) * unit)


def sdf(name):
    found = sdfio.read(folder / name)
    return "sdfio", found.data, found.header.x_scale, found.header.y_scale


def x3p(name):
    try:
        found = x3pio.read(folder / name)
        layer = found.layers[0] if hasattr(found, "layers") else found
        return "x3pio", numpy.asarray(layer.z), found.header.x.increment, found.header.y.increment
    except x3pio.X3pError as error:
        # numpy on the member that main.xml names
        print(f"{name}: x3pio refuses it ({error}); zipfile and numpy instead")
        with zipfile.ZipFile(folder / name) as archive:
            main = next(n for n in archive.namelist() if n.endswith("main.xml") and not n.startswith("__MACOSX"))
            xml = archive.read(main).decode()
            columns, rows = (int(re.search(f"<Size{axis}>(\\d+)<", xml)[1]) for axis in "XY")
            dx, dy = (float(step) for step in re.findall("<Increment>([^<]+)<", xml)[:2])
            data = archive.read(main.removesuffix("main.xml") + re.search("<PointDataLink>([^<]+)<", xml)[1])
        return "zipfile and numpy.frombuffer", numpy.frombuffer(data, "<f8").reshape(rows, columns), dx, dy


surfaces = {
    "dektak-1.csv": lambda name: profile(name, 1e-6, 1e-6, 28, delimiter=",", usecols=(0, 1)),
    "opdx-3.txt": lambda name: profile(name, 1.0, 1.0),
    "xy-4.txt": lambda name: profile(name, 1e-6, 1e-6),
    "matrix-3.txt": lambda name: matrix(name, 4, 10e-6 / 256, 10e-6 / 256, 1.0),
    "matrix-4.txt": lambda name: matrix(name, 4, 3.69862e-7, 3.69862e-7, 2.91818e-8),
    "gwyddion-export-english.txt": lambda name: matrix(name, 4, 12.34e-6 / 3, 5678.9e-9 / 4, 1.0),
    "nanovea_test1.txt": lambda name: triples(name, 1e-3, 1e-6, delimiter=","),
    "sdf-1.sdf": sdf,
    "derived_matrix-4_binary.sdf": sdf,
    "x3p-2.x3p": x3p,
    "x3ptools_sample-land.x3p": x3p,
}


def compare(name, heights, dx):
    """With surfacetopography, where it opens the file and finds a unit."""
    try:
        import SurfaceTopography
        found = SurfaceTopography.read_topography(folder / name)
        z = numpy.ma.filled(found.heights(), numpy.nan).T
        metre = {"m": 1.0, "mm": 1e-3, "µm": 1e-6, "nm": 1e-9}[found.unit]
    except Exception as error:  # noqa: BLE001: any refusal of the other reader only skips the comparison
        return f"surfacetopography does not read it: {str(error).splitlines()[0][:60] if str(error) else type(error)}"
    z = numpy.atleast_2d(z) * metre
    candidates = [z, z[::-1], z[:, ::-1], z[::-1, ::-1]]
    span = numpy.nanmax(heights) - numpy.nanmin(heights)
    assert any(c.shape == heights.shape and numpy.array_equal(numpy.isnan(c), numpy.isnan(heights)) and
               numpy.nanmax(abs(c - heights)) <= 1e-12 * span for c in candidates), f"{name}: readers disagree"
    points = heights.shape[1] - (0 if found.is_uniform else 1)  # a scan of given positions has one step less
    return f"surfacetopography agrees, dx too to {abs(found.physical_sizes[0] * metre / points / dx - 1):.1e}"


rows = []
for name, read in surfaces.items():
    reader, heights, dx, dy = read(name)
    present = [float(z) for z in heights[~numpy.isnan(heights)]]
    mean = math.fsum(present) / len(present)
    rms = math.sqrt(math.fsum((z - mean) ** 2 for z in present) / len(present))
    count = heights.size
    points = [(k * 7919 + 13) % count for k in range(6)] + [0, count - 1]
    points = [divmod(k, heights.shape[1]) for k in points]
    rows.append([name, reader, *heights.shape, repr(float(dx)), repr(float(dy)), count - len(present),
                 *(repr(float(v)) for v in (min(present), max(present), mean, rms)),
                 " ".join(f"{j}:{i}:{float(heights[j, i])!r}" for j, i in points)])
    print(f"{name}: {reader}; {compare(name, heights, dx)}")

with open(output, "w", newline="") as file:
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow("file reader rows columns dx dy missing min max mean rms heights".split())
    writer.writerows(rows)
