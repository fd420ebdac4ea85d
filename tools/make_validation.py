#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Turns the comparison of the models with boundary elements into documents.

    build/release/bin/fstiff_validation > bench/validation.csv
    tools/make_validation.py            writes the tables of docs/validation.md and docs/validation.svg from it
    tools/make_validation.py --check    exit code 1 when they are not what bench/validation.csv gives
    tools/make_validation.py --check --program build/release/bin/fstiff_validation
                                        and when bench/validation.csv is not what the program prints
"""
import argparse
import csv
import io
import math
import pathlib
import subprocess
import sys

import generated

ROOT = pathlib.Path(__file__).resolve().parent.parent
RESULTS = ROOT / "bench" / "validation.csv"
DOCUMENT = ROOT / "docs" / "validation.md"
PICTURE = ROOT / "docs" / "validation.svg"

LAWS = {  # law: (label, colour on light, colour on dark, marker)
    "hybrid": ("hybrid", "#1d1d1f", "#ececf1", "circle"),
    "persson": ("persson", "#c25700", "#ffb074", "square"),
    "hertz": ("hertz", "#b3261e", "#ff8a80", "circle"),
    "greenwood_williamson": ("greenwood_williamson", "#0b57a4", "#7db8ff", "square"),
    "fractal": ("fractal, D = 2 − H", "#1b7f54", "#5ccf97", "triangle"),
    "fractal_consistent": ("fractal_consistent", "#7a2f9e", "#dba4f5", "diamond"),
    "linear": ("p/(0.48 h_rms)", "#7a6a00", "#e0cf5a", "cross"),
}
FACTORS = (1.2, 1.5, 2, 3)


def read(text):
    rows = list(csv.DictReader(io.StringIO(text)))
    return [{"law": r["law"], "family": r["family"], **{k: float(r[k]) for k in ("p_star", "ratio", "least", "largest")}} for r in rows]


def band(rows, law, pressure):
    ratios = [r["ratio"] for r in rows if r["law"] == law and r["p_star"] == pressure]
    return min(ratios), max(ratios)


def table(head, lines):
    align = ["---"] + ["---:"] * (len(head) - 1)
    return ["| " + " | ".join(line) + " |" for line in (head, align, *lines)] + [""]


def reach(rows, law, pressures, factor):
    """The longest run of pressures over which every ratio lies within \\p factor of 1."""
    best = run = []
    for p in pressures:
        low, high = band(rows, law, p)
        run = run + [p] if low >= 1 / factor and high <= factor else []
        best = max(best, run, key=len)
    return best


def document(rows):
    pressures = sorted({r["p_star"] for r in rows})
    families = len({r["family"] for r in rows})
    lines = [f"K of each law over K of boundary elements at equal pressure: least and largest over {families} families of surfaces.", ""]
    body = [[f"{p:g}"] + ["{:.2f}–{:.2f}".format(*band(rows, law, p)) for law in LAWS] for p in pressures]
    lines += table(["p*"] + [label for label, *_ in LAWS.values()], body)
    lines += ["Where each law is within a factor of the truth, for every family:", ""]
    body = []
    for law, (label, *_) in LAWS.items():
        cells = [label]
        for factor in FACTORS:
            good = reach(rows, law, pressures, factor)
            cells.append("nowhere" if not good else "everywhere" if len(good) == len(pressures) else
                         f"p* = {good[0]:g}" if len(good) == 1 else f"{good[0]:g} to {good[-1]:g}")
        body.append(cells)
    lines += table(["law"] + [f"within {f:g}" for f in FACTORS], body)
    spread = max((r["largest"] - r["least"]) / (2 * r["ratio"]) for r in rows)
    lines.append(f"Three surfaces of one family differ from their mean by up to {100 * spread:.0f} % of K.")
    return "\n".join(lines)


def picture(rows):
    pressures = sorted({r["p_star"] for r in rows})
    left, top, width, height = 80, 56, 560, 420
    x_low, x_high, y_low, y_high = math.log10(0.0015), math.log10(0.35), math.log10(0.12), math.log10(3.5)
    place_x = lambda p: left + width * (math.log10(p) - x_low) / (x_high - x_low)
    place_y = lambda v: top + height * (y_high - math.log10(v)) / (y_high - y_low)
    style = ["text{font:13px system-ui,'DejaVu Sans',sans-serif;fill:#1d1d1f}", ".back{fill:#ffffff}", ".grid{stroke:#d9d9de;stroke-width:1}",
             ".frame{fill:none;stroke:#6b6b70}", ".truth{stroke:#1d1d1f;stroke-width:1.5}", ".title{font-size:15px;font-weight:600}",
             ".line{fill:none;stroke-width:2}", ".band{fill-opacity:0.14;stroke:none}"]
    darker = ["text{fill:#ececf1}", ".back{fill:#16161a}", ".grid{stroke:#3a3a42}", ".frame{stroke:#9a9aa2}", ".truth{stroke:#ececf1}",
              ".band{fill-opacity:0.2}"]
    for i, (_, light, dark, _) in enumerate(LAWS.values()):
        style.append(f".c{i}{{stroke:{light}}}.m{i}{{fill:{light}}}")
        darker.append(f".c{i}{{stroke:{dark}}}.m{i}{{fill:{dark}}}")
    total_w, total_h, legend_x = 900, top + height + 66, left + width + 24
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {total_w} {total_h}" role="img" aria-labelledby="title">',
           '<title id="title">Stiffness of each model over that of boundary elements, against dimensionless pressure</title>',
           f"<style>{''.join(style)}@media (prefers-color-scheme:dark){{{''.join(darker)}}}</style>", f'<rect class="back" width="{total_w}" height="{total_h}"/>',
           f'<text class="title" x="{left}" y="28">Stiffness at equal pressure: model over boundary elements</text>']
    for p in (0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2):
        x = place_x(p)
        out.append(f'<line class="grid" x1="{x:.1f}" y1="{top}" x2="{x:.1f}" y2="{top + height}"/>')
        out.append(f'<text x="{x:.1f}" y="{top + height + 20}" text-anchor="middle">{p:g}</text>')
    for v in (0.15, 0.2, 0.3, 0.5, 0.7, 1, 1.5, 2, 3):
        y = place_y(v)
        out.append(f'<line class="{"truth" if v == 1 else "grid"}" x1="{left}" y1="{y:.1f}" x2="{left + width}" y2="{y:.1f}"/>')
        out.append(f'<text x="{left - 8}" y="{y + 4:.1f}" text-anchor="end">{v:g}</text>')
    for i, law in enumerate(LAWS):
        low, high = zip(*(band(rows, law, p) for p in pressures))
        edge = [(place_x(p), place_y(v)) for p, v in zip(pressures, high)] + [(place_x(p), place_y(v)) for p, v in reversed(list(zip(pressures, low)))]
        out.append(f'<polygon class="band m{i}" points="' + " ".join(f"{x:.1f},{y:.1f}" for x, y in edge) + '"/>')
    for i, (law, (_, _, _, kind)) in enumerate(LAWS.items()):
        middle = []
        for p in pressures:
            ratios = [r["ratio"] for r in rows if r["law"] == law and r["p_star"] == p]
            middle.append((place_x(p), place_y(math.exp(sum(map(math.log, ratios)) / len(ratios)))))
        out.append(f'<polyline class="line c{i}" points="' + " ".join(f"{x:.1f},{y:.1f}" for x, y in middle) + '"/>')
        out.append(f'<g class="m{i}">' + "".join(generated.marker(kind, x, y) for x, y in middle) + "</g>")
    out.append(f'<rect class="frame" x="{left}" y="{top}" width="{width}" height="{height}"/>')
    out.append(f'<text x="{left + width / 2}" y="{top + height + 46}" text-anchor="middle">p* = p/(E g_rms), pressure over modulus times rms gradient</text>')
    middle = top + height / 2
    out.append(f'<text x="24" y="{middle}" text-anchor="middle" transform="rotate(-90 24 {middle})">K of the model / K of boundary elements</text>')
    for i, (label, _, _, kind) in enumerate(LAWS.values()):
        y = top + 14 + 27 * i
        out.append(f'<line class="line c{i}" x1="{legend_x}" y1="{y}" x2="{legend_x + 26}" y2="{y}"/><g class="m{i}">{generated.marker(kind, legend_x + 13, y)}</g>')
        out.append(f'<text x="{legend_x + 34}" y="{y + 4}">{label}</text>')
    y = top + 14 + 27 * len(LAWS)
    out.append(f'<line class="truth" x1="{legend_x}" y1="{y}" x2="{legend_x + 26}" y2="{y}"/><text x="{legend_x + 34}" y="{y + 4}">the truth</text>')
    for k, text in enumerate(("line: geometric mean", "shade: range over families")):
        out.append(f'<text x="{legend_x}" y="{y + 34 + 19 * k}">{text}</text>')
    return "\n".join(out + ["</svg>"]) + "\n"


def same(kept, found):
    """Whether the rows are the same but for the rounding of the last digit that is printed."""
    numbers = ("p_star", "ratio", "least", "largest")
    return len(kept) == len(found) and all(
        a["law"] == b["law"] and a["family"] == b["family"] and all(abs(a[k] - b[k]) < 1.5e-4 for k in numbers) for a, b in zip(kept, found))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="write nothing")
    parser.add_argument("--program", help="fstiff_validation, whose output bench/validation.csv must be")
    options = parser.parse_args()
    rows = read(RESULTS.read_text())
    if options.program and not same(rows, read(subprocess.run([options.program], check=True, capture_output=True, text=True).stdout)):
        print("bench/validation.csv is not what fstiff_validation prints: redirect its output there, and run tools/make_validation.py")
        return 1
    wanted = {DOCUMENT: generated.between_markers(DOCUMENT, "validation", document(rows)), PICTURE: picture(rows)}
    return generated.write_or_check(wanted, "bench/validation.csv", "make_validation.py", options.check)


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (OSError, ValueError, KeyError, subprocess.CalledProcessError) as error:
        sys.exit(f"make_validation.py: {error!r}")
