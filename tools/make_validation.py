#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Turns the comparisons of the laws with boundary elements into the tables of docs/validation.md and two pictures.

    build/release/bin/fstiff_validation > bench/validation.csv
    build/release/bin/fstiff_maps truth 1 5 > bench/map_truth.csv                       some ten minutes
    build/release/bin/fstiff_maps laws bench/map_truth.csv > bench/map_validation.csv   half a minute
    tools/make_validation.py            writes the tables, docs/validation.svg and docs/map_validation.svg
    tools/make_validation.py --check    exit code 1 when they are not what the tables in bench give
    tools/make_validation.py --check --program build/release/bin/fstiff_validation
                                        and when bench/validation.csv is not what the program prints
    tools/make_validation.py --check --maps build/release/bin/fstiff_maps
                                        and when bench/map_validation.csv is not what the program prints, of each 25 maps one
"""
import argparse
import csv
import io
import math
import statistics
import subprocess
import sys

from generated import ROOT, Axis, Picture, between_markers, table, write_or_check

DOCUMENT = ROOT / "docs" / "validation.md"
FAMILIES, MAPS, TRUTH = (ROOT / "bench" / name for name in ("validation.csv", "map_validation.csv", "map_truth.csv"))
OVER = "K of the law / K of boundary elements"


def read(text):
    words = ("law", "family", "kind", "group")
    return [{key: value if key in words else float(value) for key, value in row.items()} for row in csv.DictReader(io.StringIO(text))]


def in_order(rows, key):
    return list(dict.fromkeys(row[key] for row in rows))


def marks(*values):
    return {value: f"{value:g}" for value in values}


# ---------------------------------------------------------------- families of Gaussian surfaces

LAWS = {  # law: label, (colour on light, colour on dark, marker)
    "hybrid": ("hybrid", ("#1d1d1f", "#ececf1", "circle")),
    "persson": ("persson", ("#c25700", "#ffb074", "square")),
    "hertz": ("hertz", ("#b3261e", "#ff8a80", "circle")),
    "greenwood_williamson": ("greenwood_williamson", ("#0b57a4", "#7db8ff", "square")),
    "fractal": ("fractal, D = 2 − Hurst", ("#1b7f54", "#5ccf97", "triangle")),
    "fractal_consistent": ("fractal_consistent", ("#7a2f9e", "#dba4f5", "diamond")),
    "linear": ("p/(0.48 σ)", ("#7a6a00", "#e0cf5a", "cross")),
}
FACTORS = (1.2, 1.5, 2, 3)


def ratios_at(rows, law, pressure):
    return [r["ratio"] for r in rows if r["law"] == law and r["p_star"] == pressure]


def reach(rows, law, pressures, factor):
    """The longest run of pressures over which every ratio lies within \\p factor of 1."""
    best = run = []
    for p in pressures:
        ratios = ratios_at(rows, law, p)
        run = run + [p] if min(ratios) >= 1 / factor and max(ratios) <= factor else []
        best = max(best, run, key=len)
    return "nowhere" if not best else "everywhere" if best == pressures else f"p* = {best[0]:g}" if len(best) == 1 else f"{best[0]:g} to {best[-1]:g}"


def of_families(rows):
    pressures = sorted(in_order(rows, "p_star"))
    lines = [f"K of each law over K of boundary elements at equal pressure: least and largest over {len(in_order(rows, 'family'))} families of "
             "surfaces.", ""]
    ends = lambda ratios: f"{min(ratios):.2f}–{max(ratios):.2f}"
    lines += table(["p*"] + [label for label, _ in LAWS.values()],
                   [[f"{p:g}"] + [ends(ratios_at(rows, law, p)) for law in LAWS] for p in pressures])
    lines += ["Where each law is within a factor of the truth, for every family:", ""]
    lines += table(["law"] + [f"within {f:g}" for f in FACTORS],
                   [[label] + [reach(rows, law, pressures, f) for f in FACTORS] for law, (label, _) in LAWS.items()])
    spread = max((r["largest"] - r["least"]) / (2 * r["ratio"]) for r in rows)
    lines.append(f"Three surfaces of one family differ from their mean by up to {100 * spread:.0f} % of K.")
    return "\n".join(lines)


def picture_of_families(rows):
    pressures = sorted(in_order(rows, "p_star"))
    out = Picture(900, 542, "Stiffness of each model over that of boundary elements, against dimensionless pressure", [look for _, look in LAWS.values()])
    out.text(80, 28, "Stiffness at equal pressure: law over boundary elements", 'class="title"')
    place = out.frame(80, 56, 560, 420,
                      Axis("p* = p/(E g_rms), pressure over modulus times rms gradient", 0.0015, 0.35, marks(0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2)),
                      Axis(OVER, 0.12, 3.5, marks(0.15, 0.2, 0.3, 0.5, 0.7, 1, 1.5, 2, 3)), strong=1)
    for i, law in enumerate(LAWS):
        low, high = ([place(p, end(ratios_at(rows, law, p))) for p in pressures] for end in (min, max))
        out.polygon(f"band m{i}", high + low[::-1])
    for i, (law, (label, _)) in enumerate(LAWS.items()):
        out.curve(i, [place(p, statistics.geometric_mean(ratios_at(rows, law, p))) for p in pressures])
        out.sample(i, 664, 70 + 27 * i, label)
    y = 70 + 27 * len(LAWS)
    out.line("strong", 664, y, 690, y)
    for k, (x, text) in enumerate(((698, "boundary elements"), (664, "line: geometric mean"), (664, "shade: range over families"))):
        out.text(x, y + 4 + (11 if k else 0) + 19 * k, text)
    return out


# ---------------------------------------------------------------- maps of many kinds

MAP_LAWS = ("hybrid", "summits", "persson", "hybrid of numbers", "p/(0.48 rms height)")
LIGHT = (0.001, 0.01)  # least and greatest p*; heavy is above
GOOD = 0.15  # the shaded band
PANELS = (("hybrid", "hybrid of the map"), ("hybrid of numbers", "hybrid of σ, g and alpha alone"))  # law, what
ACROSS = Axis("", 0.12, 4, marks(0.15, 0.25, 0.5, 1, 2, 3))  # of both panels, which are compared
LOADS = (  # look; what, how far above or below the middle of the row
    (("#0b57a4", "#7db8ff", "circle"), "light loads, p* of 0.001 to 0.01", -5.5),
    (("#c25700", "#ffb074", "square"), "heavy loads, p* of 0.03 to 0.25", 5.5),
)
SEEDS = ((1, 2), (3, 4, 5))
STATISTICS = ("hybrid of numbers", "numbers, skewness and kurtosis", "numbers, Sk to Smr2", "numbers, bearing curve")
TRACES = ("1 row", "4 rows", "16 rows")


def share(rows, within):
    return f"{100 * sum(abs(r['ratio'] - 1) <= within for r in rows) / len(rows):.0f} %"


def statistics_alone(rows, groups):
    """What hybrid makes of maps, of their numbers and of traces, by the class of the map."""
    def of_map(group):
        found = [r for r in rows if r["group"] == group and r["law"] == "hybrid"]
        return [share([r for r in found if r["seed"] in seeds], 0.15) for seeds in SEEDS] + [share(found, 0.25)]

    def of(law, groups, seeds=(1, 2, 3, 4, 5)):
        found = [r for r in rows if r["law"] == law and r["group"] in groups and r["seed"] in seeds]
        return f"{share(found, 0.15)}, {share(found, 0.25)}" if found else "–"

    with_shape = [name for law in TRACES for name in (law, law + ", shape")]
    lines = ["Share of the points of `hybrid` within 15 % and 25 % of boundary elements: from the map, and from statistics alone, all seeds. The moments are "
             "σ, g and alpha of the map: alone, or with skewness and kurtosis, Sk, Spk, Svk, Smr1, Smr2, or all heights.", ""]
    lines += table(["class", "map, 15 %: seeds 1 and 2", "seeds 3 to 5", "map, 25 %", "moments", "and skewness, kurtosis", "and Sk to Smr2", "and the bearing curve"],
                   [[group] + of_map(group) + [of(law, [group]) for law in STATISTICS] for group in groups])
    lines += ["The same of traces, 256 points of 8 to 16 waves each (across the lay of machined maps): by their moments, then with their "
              "skewness and kurtosis as far as they count.", ""]
    body = [[group] + [of(law, [group]) for law in with_shape] for group in groups]
    for seeds in SEEDS:
        body.append([f"not Gaussian, seeds {seeds[0]} to {seeds[-1]}"] +
                    [of(law, ("skewed", "kurtotic", "worn", "particles"), seeds) for law in with_shape])
    return lines + table(["class", *(name for law in TRACES for name in (law, "with shape"))], body)


def by_load(rows, kind, law):
    """Ratios at light loads, ratios at heavy ones."""
    mine = [r for r in rows if r["kind"] == kind and r["law"] == law]
    return [r["ratio"] for r in mine if LIGHT[0] <= r["p_star"] <= LIGHT[1]], [r["ratio"] for r in mine if r["p_star"] > LIGHT[1]]


def of_maps(rows):
    kinds, groups = in_order(rows, "kind"), in_order(rows, "group")
    maps = len({(r["kind"], r["seed"]) for r in rows})
    lines = [f"K of each law over K of boundary elements of {maps} maps, {len(kinds)} kinds of 5 seeds: median (least–largest) at p* of 0.001 to "
             "0.01; of 0.03 to 0.25.", ""]
    cell = lambda ratios: f"{statistics.median(ratios):.2f} ({min(ratios):.2f}–{max(ratios):.2f})" if ratios else "–"
    lines += table(["kind", *MAP_LAWS], [[kind] + ["; ".join(map(cell, by_load(rows, kind, law))) for law in MAP_LAWS] for kind in kinds])
    lines += statistics_alone(rows, groups)
    lines.append("The pressure at which `hybrid` passes from the summits to the dense contact was chosen on seeds 1 and 2; seeds 3 to 5 were not used.")
    return "\n".join(lines)


def picture_of_maps(rows):
    kinds = in_order(rows, "kind")
    left, top, width, pitch, gap = 180, 76, 385, 25, 30
    height = pitch * len(kinds)
    title = f"Stiffness at equal pressure: law over boundary elements, {len(kinds)} kinds of maps"
    out = Picture(left + 2 * width + gap + 20, top + height + 96, title, [look for look, *_ in LOADS] + [("#1b7f54", "#5ccf97", "")])
    out.text(20, 32, title, 'class="title"')
    for k, (law, what) in enumerate(PANELS):
        x = left + k * (width + gap)
        band = [x + width * ACROSS.share(1 + sign * GOOD) for sign in (-1, 1)]
        out.rectangle("m2 band", band[0], top, band[1] - band[0], height)
        out.text(x, top - 12, f"{what}: {share([r for r in rows if r['law'] == law], GOOD)} within {100 * GOOD:.0f} %")
        up = {row + 0.5: "" if k else kind for row, kind in enumerate(kinds)}
        place = out.frame(x, top, width, height, ACROSS, Axis("", len(kinds), 0, up, False), strong=1)
        for row, kind in enumerate(kinds):
            for i, (ratios, (_, _, off)) in enumerate(zip(by_load(rows, kind, law), LOADS)):
                at = [place(f(ratios), row + 0.5 + off / pitch) for f in (min, statistics.median, max)]
                out.curve(i, (at[0], at[2]), False)
                out.markers(i, at[1:2])
    y = top + height + 76
    out.text(left + width + gap / 2, y - 30, OVER, 'text-anchor="middle"')
    for i, (_, what, _) in enumerate(LOADS):
        out.sample(i, 20 + 275 * i, y - 4, what)
    out.rectangle("m2 band", 570, y - 14, 36, 18)
    out.text(614, y, f"within {100 * GOOD:.0f} %")
    out.text(715, y, "marker: median; line: all points of 5 maps")
    return out


def differs(rows, printed, keys, tolerance):
    """Whether a row that is printed has other ratios than that which is kept."""
    kept = {tuple(r[key] for key in keys): r for r in rows}
    missing = {"ratio": math.inf}
    return not printed or any(abs(kept.get(tuple(r[key] for key in keys), missing)[of] - r[of]) >= tolerance
                              for r in printed for of in ("ratio", "least", "largest") if of in r)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="write nothing")
    parser.add_argument("--program", help="fstiff_validation, whose output bench/validation.csv must be")
    parser.add_argument("--maps", help="fstiff_maps, whose output bench/map_validation.csv must be")
    options = parser.parse_args()
    families, maps = (read(file.read_text(encoding="utf-8")) for file in (FAMILIES, MAPS))
    printed_by = lambda *command: read(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    if options.program:
        printed = printed_by(options.program)
        if len(printed) != len(families) or differs(families, printed, ("law", "family", "p_star"), 1.5e-4):
            sys.exit("bench/validation.csv is not what fstiff_validation prints")
    # summits push each other down to 1e-6, and where a pressure depends on that, K does a little
    if options.maps and differs(maps, printed_by(options.maps, "laws", TRUTH, "25"), ("law", "kind", "seed", "p_star"), 2e-3):
        sys.exit("bench/map_validation.csv is not what fstiff_maps laws prints")
    document = between_markers(DOCUMENT, validation=of_families(families), maps=of_maps(maps))
    return write_or_check({DOCUMENT: document, ROOT / "docs" / "validation.svg": picture_of_families(families),
                           ROOT / "docs" / "map_validation.svg": picture_of_maps(maps)}, "make_validation.py", options.check)


if __name__ == "__main__":
    sys.exit(main())
