#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes tests/data/roughness_reference.csv: roughness parameters, spectra and autocorrelations by numpy and scipy, of the maps in
tests/data, of rows of them, of both with points missing, and of measured files. fstiff is not used.

    tools/make_roughness_reference.py [FOLDER]             writes the table; FOLDER holds the measured files
    tools/make_roughness_reference.py --check [FOLDER]     compares to 1e-9 (a density of 1e-12 of the greatest keeps 1e-16/1e-6 of its amplitude through an FFT); rows of files that are not there are left out

    ISO 21920-2:2021, ISO 25178-2:2021; Jacobs, Junge, Pastewka, Surf. Topogr.: Metrol. Prop. 5 (2017) 013001 (spectra, whose
    C_1D/pi and C_2D/(2 pi)^2 are the ones here)

Made with numpy 2.4.6 and scipy 1.17.1. Needs both; without them --check prints SKIPPED. Lengths are in metres.
"""
import csv
import io
import math
import pathlib
import re
import sys
import zipfile

try:
    import numpy as np
    import scipy.fft
    import scipy.integrate
    import scipy.interpolate
    import scipy.optimize
    import scipy.signal
except ImportError:
    print("SKIPPED: numpy and scipy are not installed")
    sys.exit(0)

DATA = pathlib.Path(__file__).resolve().parent.parent / "tests" / "data"
TABLE = DATA / "roughness_reference.csv"
THRESHOLD = 0.2
HANN = lambda n: np.sin(np.pi * (np.arange(n) + 0.5) / n) ** 2


def bem_map(name):
    return np.fromfile(DATA / f"bem_map_{name}.f32", "<f4").reshape(256, 256).astype(float)


def with_holes(z):
    z = z.copy()
    if z.ndim == 1:
        z[5::13] = np.nan
    else:
        j, i = np.indices(z.shape)
        z[(7 * j + 11 * i) % 23 == 0] = np.nan
    return z


def no_plane(z):
    y, x = np.meshgrid(*(np.linspace(-1, 1, n) for n in z.shape), indexing="ij")
    there = ~np.isnan(z)
    terms = np.stack([np.ones(there.sum()), x[there], y[there]], axis=1)
    a, b, c = np.linalg.lstsq(terms, z[there], rcond=None)[0]
    return z - (a + b * x + c * y)


def text(path, **options):
    return np.loadtxt(io.StringIO(path.read_bytes().decode("latin-1").replace("\r", "")), **options)


def columns(path, unit, **options):
    x, z = text(path, **options).T
    return scipy.signal.detrend(z * unit), (x[-1] - x[0]) / (len(x) - 1) * unit, None


def x3p(path):
    with zipfile.ZipFile(path) as archive:
        main = next(n for n in archive.namelist() if n.endswith("main.xml") and not n.startswith("__MACOSX"))
        xml = archive.read(main).decode()
        width, height = (int(re.search(f"<(?:p:)?Size{axis}>(\\d+)<", xml)[1]) for axis in "XY")
        dx, dy = (float(step) for step in re.findall("<(?:p:)?Increment>([^<]+)<", xml)[:2])
        data = archive.read(main.removesuffix("main.xml") + re.search("<(?:p:)?PointDataLink>([^<]+)<", xml)[1])
    return no_plane(np.frombuffer(data, "<f8").reshape(height, width)), dx, dy


# heights, spacing (or dx), dy of a map, cut-off of the sections of a profile
SOURCES = {
    "map_gaussian": lambda _: (bem_map("gaussian"), 1 / 256, 1 / 256),
    "map_skewed": lambda _: (bem_map("skewed"), 1 / 256, 1 / 256),
    "map_oblong": lambda _: (bem_map("rougher")[:200, :151], 1 / 256, 1.5 / 256),
    "map_holes": lambda _: (with_holes(bem_map("skewed")[:200]), 1 / 256, 1.5 / 256),
    "profile_row": lambda _: (bem_map("gaussian")[17], 1 / 256, None),
    "profile_row_cutoff": lambda _: (bem_map("gaussian")[17], 1 / 256, None, 40 / 256),
    "profile_holes": lambda _: (with_holes(bem_map("skewed")[3]), 1 / 256, None),
    "dektak-1.csv": lambda folder: columns(folder / "dektak-1.csv", 1e-6, skiprows=28, delimiter=",", usecols=(0, 1)),
    "opdx-3.txt": lambda folder: columns(folder / "opdx-3.txt", 1.0),
    "xy-4.txt": lambda folder: columns(folder / "xy-4.txt", 1e-6),
    "matrix-3.txt": lambda folder: (no_plane(text(folder / "matrix-3.txt", skiprows=4)), 10e-6 / 256, 10e-6 / 256),
    "matrix-4.txt": lambda folder: (no_plane(text(folder / "matrix-4.txt", skiprows=4) * 2.91818e-8), 3.69862e-7, 3.69862e-7),
    "x3p-2.x3p": lambda folder: x3p(folder / "x3p-2.x3p"),
    "x3ptools_sample-land.x3p": lambda folder: x3p(folder / "x3ptools_sample-land.x3p"),
}


def moments(z, letter):
    z = z[~np.isnan(z)]
    z = z - math.fsum(z) / len(z)
    q = math.sqrt(math.fsum(z**2) / len(z))
    return {f"{letter}a_m": math.fsum(abs(z)) / len(z), f"{letter}q_m": q,
            f"{letter}sk": math.fsum((z / q) ** 3) / len(z), f"{letter}ku": math.fsum((z / q) ** 4) / len(z)}


def material(z, letter):
    """The curve with straight lines between the heights, its flattest 40 % and the line of least squares there, by quadrature of
    each straight part with three points of Gauss."""
    z = np.sort(z[~np.isnan(z)])[::-1]
    n, scale = len(z), z[0] - z[-1]
    t = np.arange(n) / (n - 1)
    z0 = z[n // 2]
    curve = lambda at: np.interp(at, t, (z - z0) / scale)
    starts = np.unique(np.concatenate([t[t <= 0.6 + 1e-15], t[t >= 0.4 - 1e-15] - 0.4]).clip(0, 0.6))
    fall = curve(starts) - curve(starts + 0.4)
    a = starts[np.argmax(fall <= fall.min() + 1e-14)]
    nodes = np.concatenate([[a], t[(t > a) & (t < a + 0.4)], [a + 0.4]])
    points, weights = np.polynomial.legendre.leggauss(3)
    at = (nodes[:-1, None] + nodes[1:, None]) / 2 + np.diff(nodes)[:, None] / 2 * points
    of = (np.diff(nodes)[:, None] / 2 * weights).ravel()
    at = at.ravel()
    middle, values = a + 0.2, curve(at)
    slope = np.sum(of * (at - middle) * values) / np.sum(of * (at - middle) ** 2)
    upper = np.sum(of * values) / 0.4 - slope * middle
    lower = upper + slope
    z = (z - z0) / scale

    def place(k, level):
        """Where the curve is at the level, just before the height of index k."""
        if k in (0, n):
            return k / n
        return t[k - 1] + np.clip((z[k - 1] - level) / (z[k - 1] - z[k]), 0, 1) / (n - 1)

    first, second = place(np.sum(z > upper + 1e-14), upper), place(np.sum(z >= lower - 1e-14), lower)
    hill = np.concatenate([t[t < first], [first]])
    dale = np.concatenate([[second], t[t > second]])
    peak = scipy.integrate.trapezoid(np.interp(hill, t, z) - upper, hill) if first > 0 else 0.0
    valley = scipy.integrate.trapezoid(lower - np.interp(dale, t, z), dale) if second < 1 else 0.0
    return {f"{letter}k_m": -slope * scale, f"{letter}pk_m": 2 * peak / first * scale if first > 0 else 0.0,
            f"{letter}vk_m": 2 * valley / (1 - second) * scale if second < 1 else 0.0,
            f"{letter}mr1": first, f"{letter}mr2": second}


def fast_size(points):
    """The least multiple of 4 without a prime factor above 5: the length to which profiles are padded."""
    sizes = range((points + 3) // 4 * 4, 2 * points, 4)
    return next(size for size in sizes if scipy.fft.next_fast_len(size, real=True) == size)


def profile(z, h, _, cutoff=None):
    out = moments(z, "R")
    there = z - np.nanmean(z)
    out["Rt_m"] = np.nanmax(z) - np.nanmin(z)
    steps = round(cutoff / h) if cutoff else 0
    count = 5 * steps if steps and 5 * steps <= len(z) else len(z)
    first = (len(z) - count) // 2
    parts = [there[first + k * count // 5:first + (k + 1) * count // 5] for k in range(5)]
    out["Rp_m"] = np.mean([np.nanmax(part) for part in parts])
    out["Rv_m"] = np.mean([-np.nanmin(part) for part in parts])
    out["Rz_m"] = np.mean([np.nanmax(part) - np.nanmin(part) for part in parts])
    slope = np.convolve(there, [1, -9, 45, 0, -45, 9, -1], "valid") / (60 * h)
    out["Rdq"] = math.sqrt(np.nanmean(slope**2))
    out |= material(z, "R")
    lags = range(len(z) // 2 + 1)
    if len(z) < 4000:
        acf = np.array([np.nanmean(there[:len(z) - n] * there[n:]) for n in lags])
    else:
        acf = scipy.signal.correlate(there, there, method="fft")[len(z) - 1:][:len(lags)] / (len(z) - np.array(lags))
    acf /= np.nanmean(there**2)
    below = np.flatnonzero(acf <= THRESHOLD)
    if len(below):
        k = below[0]
        out["Ral_m"] = np.interp(THRESHOLD, acf[[k, k - 1]], np.array([k, k - 1]) * h)
    for n in (1, 7, len(z) // 5):
        out[f"acf_{n}"] = acf[n]
    if not np.isnan(z).any():
        for name, window in (("hann", HANN(len(z))), ("none", np.ones(len(z)))):
            centred = there - np.sum(window * there) / np.sum(window)
            _, density = scipy.signal.periodogram(centred, 1 / h, window, nfft=fast_size(len(z)), detrend=False)
            for k in (1, 5, 60):
                if density[k] > 1e-12 * density.max():  # else there is rounding alone
                    out[f"psd_{name}_{k}"] = density[k] / (2 * np.pi)
    return out


def rays(acf, dy, dx):
    """How far from lag 0 the bilinear function of acf (lag 0 in its middle) falls to the threshold, in 720 directions."""
    reach_y, reach_x = acf.shape[0] // 2, acf.shape[1] // 2
    of = scipy.interpolate.RegularGridInterpolator(
        (np.arange(-reach_y, reach_y + 1) * dy, np.arange(-reach_x, reach_x + 1) * dx), acf, bounds_error=False)
    lengths = []
    for phi in np.arange(720) * np.pi / 720:
        up, across = np.sin(phi), np.cos(phi)
        end = min(reach_y * dy / max(abs(up), 1e-300), reach_x * dx / max(abs(across), 1e-300)) * (1 - 1e-14)
        at = np.linspace(0, end, int(16 * end / min(dx, dy)) + 2)
        below = np.flatnonzero(of(np.stack([up * at, across * at], axis=1)) <= THRESHOLD)
        lengths.append(math.inf if len(below) == 0 else scipy.optimize.brentq(
            lambda r: float(of([[up * r, across * r]])[0]) - THRESHOLD, at[below[0] - 1], at[below[0]], xtol=1e-300, rtol=1e-14))
    return lengths


def areal_acf(z, periodic):
    there = np.nan_to_num(z - np.nanmean(z))
    (rows, columns), variance = z.shape, np.nanmean((z - np.nanmean(z)) ** 2)
    y, x = rows // 2, columns // 2
    if periodic:
        sums = np.fft.fftshift(np.fft.ifft2(abs(np.fft.fft2(there)) ** 2).real) / z.size
        # an even side has its lag of half the side once: the other is the same
        sums = np.pad(sums, [(0, 1 - rows % 2), (0, 1 - columns % 2)], mode="wrap")
        return sums / variance
    mask = (~np.isnan(z)).astype(float)
    middle = np.s_[rows - 1 - y:rows + y, columns - 1 - x:columns + x]
    sums = scipy.signal.fftconvolve(there, there[::-1, ::-1])[middle]
    pairs = np.round(scipy.signal.fftconvolve(mask, mask[::-1, ::-1]))[middle]
    return sums / pairs / variance


def areal_psd(z, dx, dy, window):
    rows, columns = z.shape
    weight = np.outer(HANN(rows), HANN(columns)) if window == "hann" else np.ones(z.shape)
    waves = np.fft.fft2((z - z.mean()) * weight / np.sqrt(np.mean(weight**2)))
    density = abs(waves) ** 2 * dx * dy / z.size / (2 * np.pi) ** 2  # C(q)
    density[0, 0] = 0
    qx, qy = 2 * np.pi * np.fft.fftfreq(columns, dx), 2 * np.pi * np.fft.fftfreq(rows, dy)
    length = np.hypot(*np.meshgrid(qx, qy))
    width = 2 * np.pi / max(rows * dy, columns * dx)
    shell = np.floor(length / width + 0.5).astype(int)
    shell[length > np.pi / max(dx, dy) * (1 + 1e-14)] = -1
    out = {}
    for k in (1, 3, 20, 60):
        radial = density[shell == k]
        if len(radial) and radial.mean() > 1e-12 * density.max():  # else there is rounding alone
            out |= {f"q_{k}": length[shell == k].mean(), f"psd_{window}_{k}": radial.mean()}
            if k < columns / 2:
                out[f"psd_x_{window}_{k}"] = 2 * density[:, k].sum() * 2 * np.pi / (rows * dy)
            if k < rows / 2:
                out[f"psd_y_{window}_{k}"] = 2 * density[k].sum() * 2 * np.pi / (columns * dx)
    return out


def areal(z, dx, dy):
    out = moments(z, "S")
    mean = np.nanmean(z)
    out |= {"Sp_m": np.nanmax(z) - mean, "Sv_m": mean - np.nanmin(z), "Sz_m": np.nanmax(z) - np.nanmin(z)}
    x, y = np.diff(z, axis=1) / dx, np.diff(z, axis=0) / dy
    out["Sdq"] = math.sqrt(np.nanmean(x**2) + np.nanmean(y**2))
    squares = [a**2 + b**2 for a in (x[:-1], x[1:]) for b in (y[:, :-1], y[:, 1:])]
    out["Sdr"] = np.nanmean(sum(s / (1 + np.sqrt(1 + s)) for s in squares) / 4)
    out |= material(z.ravel(), "S")
    there, variance = z - mean, np.nanmean((z - mean) ** 2)
    rows, columns = z.shape
    for i, j in ((1, 0), (0, 2), (5, 3), (-9, 4)):  # direct sums
        a, b = there[:rows - j, max(0, -i):columns - max(0, i)], there[j:, max(0, i):columns + min(0, i)]
        out[f"acf_{i}_{j}"] = np.nanmean(a * b) / variance
    lengths = rays(areal_acf(z, False), dy, dx)
    if min(lengths) < math.inf:
        out["Sal_m"] = min(lengths)
    if max(lengths) < math.inf:
        out["Str"] = min(lengths) / max(lengths)
    if not np.isnan(z).any():
        around = rays(areal_acf(z, True), dy, dx)
        if max(around) < math.inf:
            out |= {"Sal_periodic_m": min(around), "Str_periodic": min(around) / max(around)}
        out |= areal_psd(z, dx, dy, "hann") | areal_psd(z, dx, dy, "none")
    return out


def numbers_of(source, folder):
    z, *steps = SOURCES[source](folder)
    return (profile if z.ndim == 1 else areal)(z, *steps)


def write(folder):
    with TABLE.open("w", newline="") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(["source", "parameter", "value"])
        for source in SOURCES:
            rows.writerows([source, parameter, repr(float(value))] for parameter, value in numbers_of(source, folder).items())


def compare(folder):
    with TABLE.open() as file:
        expected = {(row["source"], row["parameter"]): float(row["value"]) for row in csv.DictReader(file)}
    there = [source for source in SOURCES if "." not in source or (folder and (folder / source).exists())]
    found = {(source, parameter): value for source in there for parameter, value in numbers_of(source, folder).items()}
    if missing := set(found) ^ {at for at in expected if at[0] in there}:
        sys.exit(f"the table has {sorted(missing)} or lacks it")
    # an autocorrelation counts from 1
    errors = {at: abs(value - expected[at]) / (1.0 if at[1].startswith("acf") else abs(expected[at]) or 1.0) for at, value in found.items()}
    for at, error in errors.items():
        if error > 1e-9:
            print(f"{at}: {expected[at]} in the table, {found[at]} now")
    print(f"{len(found)} of {len(expected)} rows, the worst off by {max(errors.values()):.1e}")
    return bool(max(errors.values()) > 1e-9)  # sys.exit prints a bool of numpy


places = [pathlib.Path(word) for word in sys.argv[1:] if word != "--check"] or [None]
sys.exit((compare if "--check" in sys.argv else write)(places[0]))
