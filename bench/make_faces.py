#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Maps of faces as processes leave them, and K of each by boundary elements: the truth that bands from numbers are held to.

    bench/make_faces.py --build build/release             writes bench/face_truth.csv (two minutes) and the traces of the tests
    bench/make_faces.py --map craters 1 --output map.gsf  writes one map

A map has 256 points a side every 0.5 um, repeats itself, and has an rms gradient of 0.1. `fstiff truth` solves it; K is in periods
of the map over the effective modulus. The bands were set on the kinds marked `calibrated`, and on none of the others.
"""
import argparse
import csv
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
TRUTH, TRACES = ROOT / "bench/face_truth.csv", ROOT / "tests/data/face_traces.f32"
POINTS, STEP, GRADIENT = 256, 0.5e-6, 0.1
P_STARS = (0.001, 0.003, 0.01, 0.03, 0.1, 0.25)
SEEDS = (1, 2)
MODULUS = 1e9  # effective, of the solutions [Pa]; it scales out
COLUMNS = ("kind", "group", "calibrated", "seed", "rms_height", "skewness", "kurtosis", "p_star", "K")

WAVES = np.fft.fftfreq(POINTS, 1 / POINTS)
RADIUS = np.hypot(WAVES[:, None], WAVES[None, :])
X, Y = np.meshgrid(np.arange(POINTS) / POINTS, np.arange(POINTS) / POINTS)


def waves(z, factor):
    """z with every wave times the factor."""
    return np.fft.ifft2(np.fft.fft2(z) * factor).real


def smooth(z, cut=48):
    """z without the waves that the grid does not resolve."""
    return waves(z, np.exp(-((RADIUS / cut) ** 8)))


def unit(z):
    return (z - z.mean()) / z.std()


def gaussian(rng, rolloff, cut, hurst, stretch=1.0):
    """A self-affine Gaussian map of rms 1, flat below rolloff waves a side, `stretch` times as long along the columns."""
    q = np.hypot(WAVES[:, None] * np.sqrt(stretch), WAVES[None, :] / np.sqrt(stretch))
    q[0, 0] = np.inf
    amplitude = np.where(q <= cut, np.maximum(q, rolloff) ** -(1 + hurst), 0)
    amplitude[0, 0] = 0
    return unit(waves(rng.standard_normal((POINTS, POINTS)), amplitude))


def away(x, y):
    """Distances along both axes from a point, the short way round."""
    return (X - x + 0.5) % 1 - 0.5, (Y - y + 0.5) % 1 - 0.5


def places(rng, count):
    return rng.random((count, 2))


def nearest(points, values):
    """For each point of the grid the number of the nearest of the points, with weights in `values`."""
    distance = [np.hypot(*away(x, y)) - value for (x, y), value in zip(points, values)]
    return np.argmin(distance, axis=0)


def craters(rng, count=140):
    """Bowls with a raised rim, each over what was there."""
    z = np.zeros((POINTS, POINTS))
    for x, y in places(rng, count):
        radius = 0.03 * rng.pareto(2.5) + 0.03
        r = np.hypot(*away(x, y)) / min(radius, 0.2)
        bowl = np.where(r < 1, 0.5 * (r**2 - 1) + 0.15, 0.15 * np.exp(-((r - 1) / 0.25) ** 2))
        z = np.where(r < 1, 0.3 * z, z) + min(radius, 0.2) * bowl
    return smooth(z)


def peened(rng, count=400):
    """Dents of one ball, each as deep as it was hit."""
    z = np.zeros((POINTS, POINTS))
    for x, y in places(rng, count):
        r = np.hypot(*away(x, y)) / (0.05 + 0.02 * rng.random())
        z = np.minimum(z, z * 0.6 + np.where(r < 1.3, r**2 - 1, 0.69)) if rng.random() < 0.5 else z - np.exp(-(r**2))
    return smooth(unit(z) + 0.08 * gaussian(rng, 16, 48, 0.6))


def grit(rng, count=30):
    """Angular grains in a blasted face."""
    z = gaussian(rng, 8, 40, 0.7)
    for x, y in places(rng, count):
        dx, dy = away(x, y)
        angle = np.pi * rng.random()
        u, v = dx * np.cos(angle) + dy * np.sin(angle), dy * np.cos(angle) - dx * np.sin(angle)
        size = 0.02 + 0.02 * rng.random()
        z = np.maximum(z, 5 * rng.random() + 2 - 4 * np.maximum(np.abs(u), 1.5 * np.abs(v)) / size)
    return smooth(z)


def facets(rng, count=120):
    """Cells of an etched face, each a plane of its own."""
    points = places(rng, count)
    cell = nearest(points, np.zeros(count))
    z = np.zeros((POINTS, POINTS))
    for i, (x, y) in enumerate(points):
        dx, dy = away(x, y)
        slope = rng.standard_normal(2)
        z = np.where(cell == i, 0.02 * rng.standard_normal() + slope[0] * dx + slope[1] * dy, z)
    return smooth(z)


def steps(rng, count=250):
    """Rectangles of random heights, one over the other (a Poisson field of edges)."""
    z = np.zeros((POINTS, POINTS))
    for x, y in places(rng, count):
        dx, dy = away(x, y)
        z += rng.standard_normal() * ((np.abs(dx) < 0.15 * rng.random()) & (np.abs(dy) < 0.15 * rng.random()))
    return smooth(z, 32)


def fused(rng, count=260):
    """Spheres of a powder that have grown together: the highest of all."""
    z = np.full((POINTS, POINTS), -1.0)
    for x, y in places(rng, count):
        radius = 0.03 + 0.03 * rng.random()
        r2 = np.hypot(*away(x, y)) ** 2
        top = 0.6 * radius * rng.standard_normal()
        z = np.maximum(z, np.where(r2 < radius**2, top + np.sqrt(np.maximum(radius**2 - r2, 0)), -0.06))
    return smooth(z)


def nests(rng, count=40):
    """Grains in some places, and a smooth face between them."""
    z = 0.15 * gaussian(rng, 6, 40, 0.8)
    nest = smooth(gaussian(rng, 2, 5, 0.8) > 0.6, 20)
    for x, y in places(rng, 6 * count):
        r = np.hypot(*away(x, y)) / (0.015 + 0.02 * rng.random())
        z = np.maximum(z, nest * (0.5 + rng.random()) * np.sqrt(np.maximum(1 - r**2, 0)) * 2)
    return smooth(z)


def cross_hatch(rng):
    """Scratches of a hone in two directions, and the plateau between them."""
    z = 0.15 * gaussian(rng, 8, 48, 0.7)
    for a, b in [(3, 7), (3, -7), (2, 5), (2, -5), (4, 9), (4, -9)]:
        for _ in range(3):
            phase = ((a * X + b * Y) + rng.random()) % 1 - 0.5
            z -= (0.3 + rng.random()) * np.exp(-((phase / (0.06 + 0.06 * rng.random())) ** 2))
    return smooth(z)


def pits(rng, count=60):
    """A fine plateau with pits, as of a casting or of corrosion."""
    z = 0.12 * gaussian(rng, 12, 48, 0.6)
    for x, y in places(rng, count):
        r = np.hypot(*away(x, y)) / (0.01 + 0.03 * rng.random())
        z -= (0.4 + rng.random()) * np.exp(-(r**2))
    return smooth(z)


def scratches(rng, count=50):
    """A polished face with scratches in every direction."""
    z = 0.25 * gaussian(rng, 4, 48, 0.9)
    for _ in range(count):
        a, b = rng.integers(-4, 5, 2)
        phase = (a * X + b * Y + rng.random()) % 1 - 0.5
        width = 0.004 * max(np.hypot(a, b), 1) * (1 + 2 * rng.random())
        z -= (a != 0 or b != 0) * rng.random() ** 2 * 1.5 * np.exp(-((phase / width) ** 2))
    return smooth(z)


def patches(rng):
    """Rough patches in a smoother face."""
    mask = smooth(gaussian(rng, 2, 4, 0.8) > 0.4, 16)
    return smooth(gaussian(rng, 8, 48, 0.7) * (0.15 + mask))


def cascade(rng):
    """A Gaussian face whose roughness is a product of random factors over the octaves."""
    factor = sum(0.35 * gaussian(rng, octave, 2 * octave, 0.5) for octave in (1, 2, 4, 8))
    return smooth(gaussian(rng, 8, 48, 0.6) * np.exp(factor))


def pulses(rng, count=500):
    """Hills and hollows of all widths, few of them high."""
    z = np.zeros((POINTS, POINTS))
    for x, y in places(rng, count):
        width = min(0.012 * (1 + rng.pareto(1.5)), 0.1)
        z += rng.choice((-1, 1)) * width * rng.exponential() * np.exp(-(np.hypot(*away(x, y)) / width) ** 2)
    return smooth(z)


def weierstrass(rng, hurst=0.4, ratio=1.5, directions=24):
    """The isotropic sum of Weierstrass and Mandelbrot with waves that fit the map: D = 2 - H of a section."""
    z, q = np.zeros((POINTS, POINTS)), 2.0
    while q < 60:
        for _ in range(directions):
            angle = 2 * np.pi * rng.random()
            a, b = round(q * np.cos(angle)), round(q * np.sin(angle))
            z += q**-hurst * np.cos(2 * np.pi * (a * X + b * Y + rng.random()))
        q *= ratio
    return z


def rolled(rng):
    """Long marks along the way of rolling, and fissures across it."""
    z = gaussian(rng, 5, 14, 0.7, 14) + 0.3 * gaussian(rng, 10, 40, 0.6)
    return smooth(z - 0.8 * np.maximum(gaussian(rng, 6, 20, 0.8, 1 / 4) - 1.2, 0))


def orange_peel(rng):
    """Waves of a narrow band that are long, and a fine roughness on them."""
    return unit(gaussian(rng, 1, 4, 0.9)) * 3 + 0.4 * gaussian(rng, 16, 48, 0.6)


def knurled(rng):
    """Pyramids in rows."""
    u, v = (6 * (X + Y)) % 1 - 0.5, (6 * (X - Y)) % 1 - 0.5
    return smooth(3 * (np.abs(u) + np.abs(v)) + 0.15 * gaussian(rng, 12, 48, 0.7))


def laser(rng):
    """Rows of dimples with a burr about each."""
    u, v = (8 * X) % 1 - 0.5, (8 * Y) % 1 - 0.5
    r = np.hypot(u, v)
    return smooth(-2.2 * np.exp(-((r / 0.22) ** 2)) + 0.5 * np.exp(-(((r - 0.36) / 0.08) ** 2)) + 0.2 * gaussian(rng, 10, 48, 0.7))


def worn(rng):
    """A blasted face whose peaks were rubbed down to a finer one."""
    return smooth(np.minimum(gaussian(rng, 6, 32, 0.8), 0.5 + 0.12 * gaussian(rng, 16, 48, 0.6)))


def coated(rng):
    """Droplets on a sprayed face."""
    z = gaussian(rng, 5, 32, 0.8)
    for x, y in places(rng, 90):
        r = np.hypot(*away(x, y)) / (0.015 + 0.03 * rng.random())
        z += 2.5 * rng.random() ** 2 * np.exp(-(r**4))
    return smooth(z)


def turned(rng):
    """Grooves of a round tool whose feed varies a little."""
    place = np.sort((np.arange(10) + 0.3 * rng.random(10)) / 10)
    z = np.min([((Y - y + 0.5) % 1 - 0.5) ** 2 for y in place], axis=0)
    return smooth(unit(z) + 0.25 * gaussian(rng, 12, 48, 0.7))


def milled(rng):
    """Arcs of a face mill, of a feed that the teeth share unevenly."""
    place = 14 * np.hypot(X - 0.5, Y + 1.4)
    teeth = 0.15 * rng.standard_normal(3)
    z = (place % 1 - 0.5) ** 2 + np.take(teeth, place.astype(int) % 3)
    edge = np.minimum(np.minimum(X, 1 - X), np.minimum(Y, 1 - Y))
    return smooth(unit(z) * np.minimum(1, edge / 0.06) + 0.2 * gaussian(rng, 10, 48, 0.7))


def eroded(rng, count=900):
    """Small craters of sparks, each through what was there, with molten rims."""
    z = np.zeros((POINTS, POINTS))
    for x, y in places(rng, count):
        radius = 0.025 + 0.02 * rng.random()
        r = np.hypot(*away(x, y)) / radius
        z += radius * (0.5 + rng.random()) * (0.7 * np.exp(-(((r - 1) / 0.3) ** 2)) - np.exp(-((r / 0.8) ** 2)))
    return smooth(z)


def cast(rng):
    """A sand casting: lumps whose heights have a wide tail on both sides."""
    z = gaussian(rng, 5, 36, 0.7)
    return smooth(z * np.abs(z) + 0.3 * gaussian(rng, 10, 48, 0.6))


def etched(rng):
    """A face etched at rates that vary as a log-normal field."""
    return smooth(-np.exp(0.6 * gaussian(rng, 6, 40, 0.7)))


def printed(rng, layers=9):
    """Beads side by side, whose heights and places vary along them, with splashes."""
    z = np.full((POINTS, POINTS), -1.0)
    for i in range(layers):
        wander = 0.01 * gaussian(rng, 2, 8, 0.8)[:1]
        dy = (Y - (i + 0.5) / layers + wander + 0.5) % 1 - 0.5
        z = np.maximum(z, (1 + 0.15 * rng.standard_normal()) * np.sqrt(np.maximum(0.07**2 - dy**2, 0)) / 0.07)
    for x, y in places(rng, 12):
        r = np.hypot(*away(x, y)) / (0.02 + 0.02 * rng.random())
        z += 0.5 * np.sqrt(np.maximum(1 - r**2, 0))
    return smooth(z + 0.05 * gaussian(rng, 12, 48, 0.6))


def lapped(rng):
    """A ground face lapped flat, with lapping grains pressed into it here and there."""
    z = np.minimum(gaussian(rng, 6, 40, 0.6, 6), 0.2) + 0.15 * gaussian(rng, 12, 48, 0.5)
    for x, y in places(rng, 40):
        z -= 1.5 * rng.random() * np.exp(-((np.hypot(*away(x, y)) / 0.012) ** 2))
    return smooth(z)


def of_gaussian(*how):
    return lambda rng: gaussian(rng, *how)


# kind: group, whether the bands were set on it, how it is made; the groups are those of docs/accuracy.md
KINDS = {
    "H 0.3": ("Gaussian", True, of_gaussian(8, 48, 0.3)),
    "H 0.5": ("Gaussian", False, of_gaussian(6, 40, 0.5)),
    "H 0.7": ("Gaussian", True, of_gaussian(5, 40, 0.7)),
    "H 0.9": ("Gaussian", False, of_gaussian(8, 48, 0.9)),
    "craters": ("dents and grit", False, craters),
    "peened": ("dents and grit", True, peened),
    "grit": ("dents and grit", False, grit),
    "droplets": ("dents and grit", True, coated),
    "facets": ("facets and steps", True, facets),
    "steps": ("facets and steps", False, steps),
    "fused grains": ("grains", False, fused),
    "nests of grains": ("grains", True, nests),
    "cross-hatch": ("one lay", False, cross_hatch),
    "rolled": ("one lay", True, rolled),
    "turned": ("one lay", False, turned),
    "knurled": ("one lay", True, knurled),
    "orange peel": ("long waves", False, orange_peel),
    "Weierstrass": ("long waves", True, weierstrass),
    "pits": ("plateau with valleys", True, pits),
    "scratches": ("plateau with valleys", False, scratches),
    "laser": ("plateau with valleys", True, laser),
    "worn": ("plateau with valleys", False, worn),
    "patches": ("uneven", True, patches),
    "cascade": ("uneven", False, cascade),
    "pulses": ("uneven", True, pulses),
    "sharp pulses": ("uneven", False, lambda rng: pulses(rng, 150)),
    # made when the bands were finished
    "milled": ("one lay", False, milled),
    "spark eroded": ("dents and grit", False, eroded),
    "cast": ("uneven", False, cast),
    "etched": ("plateau with valleys", False, etched),
    "printed": ("grains", False, printed),
    "lapped": ("plateau with valleys", False, lapped),
}


def map_of(kind, seed):
    """Heights [m], row by row."""
    rng = np.random.default_rng([seed, list(KINDS).index(kind)])
    z = KINDS[kind][2](rng)
    z -= z.mean()
    spectrum = np.abs(np.fft.fft2(z)) ** 2
    gradient = 2 * np.pi * np.sqrt((spectrum * RADIUS**2).sum()) / POINTS**2
    return z * GRADIENT / gradient * POINTS * STEP


def numbers_of(z):
    """Sq [m], skewness and kurtosis."""
    z = z - z.mean()
    rms = z.std()
    return rms, (z**3).mean() / rms**3, (z**4).mean() / rms**4


def traces_of(kind, seed):
    """Two traces across the lay."""
    z = map_of(kind, seed)
    return [z[:, place] if kind == "turned" else z[place] for place in (POINTS // 4, 3 * POINTS // 4)]


def write_field(z, file):
    """Writes heights [m] as a Gwyddion simple field."""
    side = POINTS * STEP
    head = f"Gwyddion Simple Field 1.0\nXRes = {POINTS}\nYRes = {POINTS}\nXReal = {side}\nYReal = {side}\nXYUnits = m\nZUnits = m\n"
    with open(file, "wb") as out:
        out.write(head.encode() + b"\0" * (4 - len(head) % 4) + z.astype("<f4").tobytes())


def truth_of(fstiff, kind, seed):
    """Rows of one map."""
    z = map_of(kind, seed)
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "map.gsf")
        write_field(z, file)
        pressures = ",".join(f"{p * GRADIENT * MODULUS:.9g} Pa" for p in P_STARS)
        found = subprocess.run([fstiff, "truth", file, "--detrend", "mean", "--lambda-s", "none", "--edges", "periodic",
                                "--modulus", f"{MODULUS} Pa", "--pressures", pressures, "--format", "csv"],
                               capture_output=True, text=True)
    rows = list(csv.DictReader(found.stdout.splitlines()))
    if len(rows) != len(P_STARS):
        raise RuntimeError(f"{kind} {seed}: {found.stderr}{found.stdout}")
    group, calibrated, _ = KINDS[kind]
    rms, skewness, kurtosis = numbers_of(z)
    return [[kind, group, int(calibrated), seed, f"{rms:.6g}", f"{skewness:.5g}", f"{kurtosis:.5g}", f"{p:g}",
             f"{float(row['stiffness_Pa_per_m']) * POINTS * STEP / MODULUS:.5g}"] for p, row in zip(P_STARS, rows)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--build", help="folder of the build, whose bin has fstiff")
    parser.add_argument("--map", nargs=2, metavar=("KIND", "SEED"))
    parser.add_argument("--output", default="map.gsf")
    options = parser.parse_args()
    if options.map:
        write_field(map_of(options.map[0], int(options.map[1])), options.output)
    if options.build:
        fstiff = os.path.join(options.build, "bin", "fstiff")
        rows = [row for kind in KINDS for seed in SEEDS for row in truth_of(fstiff, kind, seed)]
        with open(TRUTH, "w", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([COLUMNS, *rows])
        unseen = [kind for kind in KINDS if not KINDS[kind][1]]
        np.array([traces_of(kind, seed) for kind in unseen for seed in SEEDS], "<f4").tofile(TRACES)


if __name__ == "__main__":
    sys.exit(main())
