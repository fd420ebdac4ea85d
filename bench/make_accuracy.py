#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the command on maps of many kinds, on traces of them and on their numbers, and compares its answer with boundary elements.

    bench/make_accuracy.py --build build/release          solves, runs, writes bench/coverage.csv and the tables of docs/accuracy.md
    bench/make_accuracy.py                                writes the tables from bench/coverage.csv
    bench/make_accuracy.py --check                        exit code 1 when the tables are not what bench/coverage.csv gives
    bench/make_accuracy.py --build ... --rows rows.csv    keeps every single answer too, for a calibration
    bench/make_accuracy.py --build ... --faces            runs the faces of bench/make_faces.py alone, into bench/face_coverage.csv

K by boundary elements is kept in bench/answer_truth.csv and solved where it is not there: some ten minutes of one core. The maps
repeat themselves, have 256 points a side every 0.5 um (those of a broad spectrum 512), and an rms gradient of 0.1; traces of 1,024
points are of maps four times as wide (of a broad spectrum twice). The command gets files and its defaults, E and nu of steel,
edges = "periodic" and measured = "whole" with a map, and an infinite hardness where the truth is elastic, or the one with which it was solved. The faces of
bench/make_faces.py, whose truth is bench/face_truth.csv, have no nominal area.
"""
import argparse
import array
import concurrent.futures
import csv
import json
import math
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tools"))
from generated import ROOT, between_markers, table, write_or_check

DOCUMENT, ROWS, TRUTH = ROOT / "docs/accuracy.md", ROOT / "bench/coverage.csv", ROOT / "bench/answer_truth.csv"
FACE_ROWS = ROOT / "bench/face_coverage.csv"
MODULUS = 205e9 / (2 * (1 - 0.3**2))  # effective, [Pa]
GRADIENT, STEP = 0.1, 0.5e-6
P_STARS = {1: (3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.25), 4: (1e-3, 1e-2, 0.1)}
FLOWED = {hardness: (0.003, 0.01, 0.03, 0.1, 0.3, 0.6, 0.9) for hardness in (0.02, 0.05, 0.1, 0.2, 0.5)}  # p/H at each H/(E g)
FLOWED_KINDS = ("H 0.2, 8 to 32 waves", "H 0.8, 8 to 32 waves", "H 0.8, 4 to 32 waves", "skewness 0.5", "kurtosis 5", "honed",
                "stretched 2:1", "turned", "H 0.5, 8 to 32 waves", "H 0.5, 3 to 32 waves", "skewness -0.5", "squared", "patchy", "worn",
                "stretched 4:1", "ground")
SEEDS = {"calibrated": range(10, 14), "unseen": range(30, 34)}
CALIBRATED = ("H 0.2, 8 to 32 waves", "H 0.8, 8 to 32 waves", "H 0.8, 4 to 32 waves", "H 0.5, 1 to 32 waves", "H 0.8, 4 to 128 waves",
              "skewness 0.5", "skewness -1", "kurtosis 5", "kurtosis 2.3", "honed", "plateaus", "stretched 2:1", "stretched 6:1",
              "turned", "planed", "two faces", "two worn faces", "particles", "many particles")
LAY = {"turned": "column", "planed": "column", "shaped": "column", "milled": "column", "ground": "row"}  # the way across
PROCESS = {"turned": "turned", "planed": "turned", "shaped": "turned", "milled": "milled", "ground": "ground", "honed": "honed",
           "plateaus": "honed", "H 0.8, 8 to 32 waves": "blasted", "H 0.5, 8 to 32 waves": "blasted"}
COLUMNS = ("half", "group", "known", "hardness", "pressure", "inside", "of", "width")
KNOWN = ("map", "trace", "short trace", "trace along the lay", "height, gradient and shape", "height and gradient",
         "height and process", "height")


class Answers:
    """The command's answers of the maps, traces and numbers of each kind."""

    def __init__(self, build, truth):
        self.maps, self.fstiff = (os.path.join(build, "bin", name) for name in ("fstiff_maps", "fstiff"))
        self.truth = truth
        self.folder = tempfile.mkdtemp()

    def kinds(self):
        lines = subprocess.run([self.maps, "list"], capture_output=True, text=True, check=True).stdout.splitlines()
        return [line.split(";") for line in lines]

    def solve(self, kind, group, seed, size, hardness):
        """K of boundary elements in periods of the map, where they are not known."""
        shares = [p for p in pressures_of(size, hardness) if (kind, seed, size, hardness, p) not in self.truth]
        if not shares:
            return
        width = 2 if size == 4 and group == "broad" else size
        how = ["flowed", kind, str(seed), str(hardness)] if hardness else ["one", kind, str(seed), str(width)]
        found = subprocess.run([self.maps, *how] + [str(p) for p in shares], capture_output=True, text=True, check=True).stdout
        for p, row in zip(shares, csv.reader(found.splitlines())):
            self.truth[kind, seed, size, hardness, p] = float(row[3])

    def run(self, surface, pressures, area=None, hardness=0, periodic=False):
        lines = ["[surface]", *surface, "[material.upper]", 'youngs_modulus = "205 GPa"', "poisson_ratio = 0.3",
                 f'hardness = "{hardness * GRADIENT * MODULUS:.8g} Pa"' if hardness else 'hardness = "infinite"', "[contact]",
                 "pressures = [" + ", ".join(f'"{p:.6g} Pa"' for p in pressures) + "]"]
        if area:
            lines.append(f'nominal_area = "{area:.6g} m^2"')
        if periodic:
            lines += ["[contact.boundary_elements]", 'edges = "periodic"']
        found = subprocess.run([self.fstiff, "run", "-", "--format", "json"], input="\n".join(lines), capture_output=True, text=True)
        if not found.stdout:
            raise RuntimeError(found.stderr)
        return json.loads(found.stdout)["answer"]

    def of_map(self, kind, group, seed, size, hardness):
        """Rows of every single answer of one map."""
        self.solve(kind, group, seed, size, hardness)
        with tempfile.TemporaryDirectory(dir=self.folder) as folder:
            file = os.path.join(folder, "map.gsf")
            width = 2 if size == 4 and group == "broad" else size
            subprocess.run([self.maps, "file", kind, str(seed), str(width), file], check=True)
            heights, points = read_field(file)
            shares, rows = pressures_of(size, hardness), []
            pressures = [p * (hardness or 1) * GRADIENT * MODULUS for p in shares]
            for known, surface, area in self.surfaces(kind, heights, points, size, file, folder):
                try:
                    answers = self.run(surface, pressures, area, hardness, known == "map")
                except RuntimeError as error:
                    print(kind, seed, known, str(error)[:200], file=sys.stderr)
                    continue
                for p, answer in zip(shares, answers):
                    K = self.truth[kind, seed, size, hardness, p] * MODULUS / (points * STEP)
                    ends = [answer[f"stiffness_{end}Pa_per_m"] / K for end in ("", "p05_", "p95_")]
                    rows.append([kind, group, seed, known, hardness, p, answer["law"]] + [f"{end:.4f}" for end in ends])
        return rows

    def surfaces(self, kind, heights, points, size, file, folder):
        """What is known, the lines of [surface], and the nominal area where it must be said."""
        if size == 1:
            yield "map", [f'from = "{file}"', 'measured = "whole"'], None
            mean = statistics.fmean(heights)
            moment = lambda n: statistics.fmean((z - mean) ** n for z in heights)
            rms, area = math.sqrt(moment(2)), (points * STEP) ** 2
            height, gradient = f'rms_height = "{rms:.6g} m"', f"rms_gradient = {GRADIENT}"
            shape = [f"skewness = {moment(3) / rms**3:.4g}", f"kurtosis = {moment(4) / rms**4:.4g}"]
            yield "height, gradient and shape", [height, gradient, *shape], area
            yield "height and gradient", [height, gradient], area
            if kind in PROCESS:
                yield "height and process", [height, f'process = "{PROCESS[kind]}"'], area
            yield "height", [height], area
        across, process = LAY.get(kind, "row"), PROCESS[kind] if kind in LAY else None
        for place in (points // 4, 3 * points // 4):
            for way in ("row", "column"):
                if way != across and not process and kind.startswith("stretched"):
                    continue
                trace = os.path.join(folder, f"{way}{place}.csv")
                line = heights[place * points:(place + 1) * points] if way == "row" else heights[place::points]
                with open(trace, "w") as out:
                    out.writelines(f"{i * STEP * 1e6:g},{z * 1e6:.9g}\n" for i, z in enumerate(line))
                along = process is not None and way != across
                known = "trace along the lay" if along else "trace" if size == 4 else "short trace"
                yield known, [f'from = "{trace}"', 'units = "um"'] + ([f'process = "{process}"'] if along else []), None


def measure_faces(build):
    """Writes how many answers of the faces hold the truth."""
    import make_faces as faces  # needs numpy

    with open(faces.TRUTH, newline="") as file:
        truth = list(csv.DictReader(file))
    answers = Answers(build, {})

    def of_face(kind, seed):
        true = [float(row["K"]) for row in truth if row["kind"] == kind and int(row["seed"]) == seed]
        z, (group, calibrated, _) = faces.map_of(kind, seed), faces.KINDS[kind]
        rms, skewness, kurtosis = faces.numbers_of(z)
        height, gradient = f'rms_height = "{rms:.6g} m"', f"rms_gradient = {GRADIENT}"
        with tempfile.TemporaryDirectory(dir=answers.folder) as folder:
            faces.write_field(z, os.path.join(folder, "map.gsf"))
            known = [("map", [f'from = "{folder}/map.gsf"', 'measured = "whole"']),
                     ("height, gradient and shape", [height, gradient, f"skewness = {max(-3, min(3, skewness)):.5g}",
                                                     f"kurtosis = {kurtosis:.5g}"]),
                     ("height and gradient", [height, gradient]), ("height", [height])]
            for i, line in enumerate(faces.traces_of(kind, seed)):
                trace = f"{folder}/{i}.csv"
                pathlib.Path(trace).write_text("".join(f"{k * STEP * 1e6:g},{h * 1e6:.9g}\n" for k, h in enumerate(line)))
                known.append(("short trace", [f'from = "{trace}"', 'units = "um"']))
            pressures, side = [p * GRADIENT * MODULUS for p in faces.P_STARS], faces.POINTS * STEP
            return [["calibrated" if calibrated else "unseen", group, word, p]
                    + [answer[f"stiffness_{end}_Pa_per_m"] / (K * MODULUS / side) for end in ("p05", "p95")]
                    for word, surface in known for answer in answers.run(surface, pressures, periodic=word == "map")
                    for p, K in [nearest(answer["pressure_Pa"], pressures, faces.P_STARS, true)]]

    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        rows = [row for of in pool.map(lambda job: of_face(*job), [(kind, seed) for kind in faces.KINDS for seed in faces.SEEDS])
                for row in of]
    os.rmdir(answers.folder)
    cells = {}
    for half, group, word, p, low, high in rows:
        cells.setdefault((half, group, word, p), []).append((low, high))
    write_csv(FACE_ROWS, COLUMNS, [[half, group, word, 0, f"{p:g}", sum(low <= 1 <= high for low, high in bands), len(bands),
                                    f"{statistics.median(high / low for low, high in bands):.3g}"]
                                   for (half, group, word, p), bands in cells.items()])


def nearest(pressure, pressures, *columns):
    """What the columns have at the one of the pressures that is meant."""
    at = min(range(len(pressures)), key=lambda i: abs(pressures[i] - pressure))
    return [column[at] for column in columns]


def face_tables(rows):
    """The tables of faces: the share of bands that hold the truth, and the median of their widths at all p*."""
    lines = []
    for half, title in (("unseen", "Kinds that the bands were not set on"), ("calibrated", "Kinds that the bands were set on")):
        mine = [row for row in rows if row["half"] == half]
        if not mine:
            continue
        known = [word for word in KNOWN if any(row["known"] == word for row in mine)]

        def cell(group, word):
            of = [row for row in mine if group in (row["group"], "all") and row["known"] == word]
            share = sum(int(row["inside"]) for row in of) / sum(int(row["of"]) for row in of)
            return f"{100 * share:.0f} %, {statistics.median(float(row['width']) for row in of):.3g}"

        groups = list(dict.fromkeys(row["group"] for row in mine)) + ["all"]
        lines += [f"{title}:", ""] + table(["class"] + known, [[group] + [cell(group, word) for word in known] for group in groups])
    return lines


def pressures_of(size, hardness):
    """p* of one map; p/H where peaks yield."""
    return FLOWED[hardness] if hardness else P_STARS[size]


def read_field(file):
    """Heights and points a side of a Gwyddion simple field."""
    with open(file, "rb") as stream:
        raw = stream.read()
    end = raw.index(b"\0")
    heights = array.array("f")
    heights.frombytes(raw[end + 4 - end % 4:])
    return heights, math.isqrt(len(heights))


def half_of(kind, seed):
    """Kinds and seeds that the errors of the laws were calibrated on, or none of them; None where one of both was seen."""
    kinds, seeds = kind in CALIBRATED, int(seed) in SEEDS["calibrated"]
    return "calibrated" if kinds and seeds else "unseen" if not kinds and not seeds else None


def summary(rows):
    """How many of the answers hold the truth, and the median width of their bands end to end, by COLUMNS."""
    found = {}
    for kind, group, seed, known, hardness, pressure, _law, _value, low, high in rows:
        if half := half_of(kind, seed):
            key = half, group, known, float(hardness), float(pressure)
            found.setdefault(key, []).append((float(low), float(high)))
    order = lambda key: (key[0], key[3], key[1], KNOWN.index(key[2]), key[4])
    return [[half, group, known, f"{hardness:g}", f"{p:g}", sum(low <= 1 <= high for low, high in bands), len(bands),
             f"{statistics.median(high / low for low, high in bands):.3g}"]
            for half, group, known, hardness, p in sorted(found, key=order)
            for bands in [found[half, group, known, hardness, p]]]


def share_and_width(of):
    """The share inside and the width at p* = 0.01, p/H = 0.01 of a cell; empty ones have a dash."""
    if not of:
        return "–"
    count = lambda column: sum(int(row[column]) for row in of)
    widths = [float(row["width"]) for row in of if float(row["pressure"]) == 0.01]
    return f"{100 * count('inside') / count('of'):.0f} %, {statistics.median(widths):.3g}"


def tables(rows):
    """The tables of docs/accuracy.md: coverage, and the width at p* = 0.01; and of peaks that yield."""
    lines = []
    for half, title in (("unseen", "Other kinds and seeds"), ("calibrated", "Kinds and seeds of the calibration")):
        mine = [row for row in rows if row["half"] == half and float(row["hardness"]) == 0]
        known = [word for word in KNOWN if any(row["known"] == word for row in mine)]
        cell = lambda group, word: share_and_width([row for row in mine if row["group"] == group and row["known"] == word])
        groups = list(dict.fromkeys(row["group"] for row in mine))
        lines += [f"{title}:", ""] + table(["class"] + known, [[group] + [cell(group, word) for word in known] for group in groups])
    lines += ["Peaks that yield, by H/(E g), all classes of both halves:", ""]
    mine = [row for row in rows if float(row["hardness"]) > 0]
    known = [word for word in KNOWN if any(row["known"] == word for row in mine)]
    of = lambda half, hardness, word: [row for row in mine if row["half"] == half and row["known"] == word
                                       and float(row["hardness"]) == hardness]
    lines += table(["H/(E g)", "half"] + known, [
        [f"{hardness:g}", title] + [share_and_width(of(half, hardness, word)) for word in known]
        for half, title in (("unseen", "other"), ("calibrated", "calibration")) for hardness in FLOWED])
    return lines


def measure(build, rows_file):
    truth = {}
    if TRUTH.exists():
        with open(TRUTH, newline="") as file:
            truth = {(r["kind"], int(r["seed"]), int(r["size"]), float(r["hardness"]), float(r["pressure"])): float(r["K"])
                     for r in csv.DictReader(file)}
    answers = Answers(build, truth)
    jobs = [(kind, group, seed, 1, 0) for seeds in SEEDS.values() for seed in seeds for kind, group in answers.kinds()]
    jobs += [(kind, group, seeds[0], 4, 0) for seeds in SEEDS.values() for kind, group in answers.kinds()]
    jobs += [(kind, group, seed, 1, hardness) for seeds in SEEDS.values() for seed in seeds[:2] for hardness in FLOWED
             for kind, group in answers.kinds() if kind in FLOWED_KINDS]
    jobs = [job for job in jobs if half_of(job[0], job[2])]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        rows = [row for of_map in pool.map(lambda job: answers.of_map(*job), jobs) for row in of_map]
    os.rmdir(answers.folder)
    write_csv(TRUTH, ("kind", "seed", "size", "hardness", "pressure", "K"),
              [[*key[:3], f"{key[3]:g}", f"{key[4]:g}", f"{K:.5g}"] for key, K in sorted(truth.items())])
    write_csv(ROWS, COLUMNS, summary(rows))
    if rows_file:
        write_csv(rows_file, ("kind", "group", "seed", "known", "hardness", "pressure", "law", "value", "low", "high"), rows)


def write_csv(path, head, rows):
    with open(path, "w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([head, *rows])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--build", help="folder of the build, whose bin has fstiff and fstiff_maps")
    parser.add_argument("--rows", help="file for every single answer")
    parser.add_argument("--faces", action="store_true", help="the faces of bench/make_faces.py alone")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if options.build:
        measure_faces(options.build)
        if not options.faces:
            measure(options.build, options.rows)
    with open(ROWS, newline="") as file, open(FACE_ROWS, newline="") as of_faces:
        text = between_markers(DOCUMENT, coverage="\n".join(tables(list(csv.DictReader(file)))),
                               faces="\n".join(face_tables(list(csv.DictReader(of_faces)))))
    return write_or_check({DOCUMENT: text}, "../bench/make_accuracy.py", options.check)


if __name__ == "__main__":
    sys.exit(main())
