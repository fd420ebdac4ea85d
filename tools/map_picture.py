# SPDX-License-Identifier: BSD-3-Clause
"""The picture of make_map_validation.py: one row a kind of map, K of a law over K of boundary elements across."""
import math
import statistics

import generated

LOADS = (  # colour on light, colour on dark, marker; what, how far above or below the middle of the row
    (("#0b57a4", "#7db8ff", "circle"), "light loads, p* of 0.001 to 0.01", -5.5),
    (("#c25700", "#ffb074", "square"), "heavy loads, p* of 0.03 to 0.25", 5.5),
)
GOOD = 0.15  # the shaded band
LEFT, TOP, WIDTH, PITCH, GAP = 180, 76, 385, 25, 30


def symbol(i, least, middle, most, y):
    """A line from the least to the greatest, with a marker in the middle."""
    return (f'<line class="line c{i}" x1="{least:.1f}" y1="{y:.1f}" x2="{most:.1f}" y2="{y:.1f}"/>'
            f'<g class="m{i}">{generated.marker(LOADS[i][0][2], middle, y)}</g>')


def panel(out, left, height, what, low, high, marks, rows):
    """The frame of one law; rows: by kind the ratios at light and at heavy loads."""
    place = lambda ratio: left + WIDTH * math.log(ratio / low) / math.log(high / low)
    out.append(f'<rect class="m2 band" x="{place(1 - GOOD):.1f}" y="{TOP}" width="{place(1 + GOOD) - place(1 - GOOD):.1f}" height="{height}"/>')
    for mark in marks:
        x = place(mark)
        out.append(f'<line class="{"truth" if mark == 1 else "grid"}" x1="{x:.1f}" y1="{TOP}" x2="{x:.1f}" y2="{TOP + height}"/>'
                   f'<text x="{x:.1f}" y="{TOP + height + 20}" text-anchor="middle">{mark:g}</text>')
    out.append(f'<text x="{left}" y="{TOP - 12}">{what}</text><rect class="frame" x="{left}" y="{TOP}" width="{WIDTH}" height="{height}"/>')
    for row, loads in enumerate(rows):
        for i, (ratios, (_, _, off)) in enumerate(zip(loads, LOADS)):
            at = [place(f(ratios)) for f in (min, statistics.median, max)]
            out.append(symbol(i, *at, TOP + PITCH * (row + 0.5) + off))


def draw(kinds, panels):
    """panels: (what, least ratio of the frame, greatest, marks, ratios by kind and load) of two laws."""
    height, width = PITCH * len(kinds), LEFT + 2 * WIDTH + GAP + 20
    title = f"Stiffness at equal pressure: law over boundary elements, {len(kinds)} kinds of maps"
    colours = [colours for colours, *_ in LOADS] + [("#1b7f54", "#5ccf97", "")]
    own = (".band{fill-opacity:0.16}.truth{stroke:#1d1d1f;stroke-width:1.5}"
           "@media (prefers-color-scheme:dark){.band{fill-opacity:0.24}.truth{stroke:#ececf1}}")
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {TOP + height + 96}" role="img" aria-labelledby="title">',
           f'<title id="title">{title}</title>', generated.style(colours), f"<style>{own}</style>",
           f'<rect class="back" width="{width}" height="{TOP + height + 96}"/>', f'<text class="title" x="20" y="32">{title}</text>']
    for k, (what, *rest) in enumerate(panels):
        panel(out, LEFT + k * (WIDTH + GAP), height, what, *rest)
    for row, kind in enumerate(kinds):
        out.append(f'<text x="{LEFT - 12}" y="{TOP + PITCH * (row + 0.5) + 4.5:.1f}" text-anchor="end">{kind}</text>')
    middle, y = LEFT + WIDTH + GAP / 2, TOP + height + 76
    out.append(f'<text x="{middle}" y="{y - 30}" text-anchor="middle">K of the law / K of boundary elements</text>')
    for i, (_, what, _) in enumerate(LOADS):
        x = 20 + 275 * i
        out.append(symbol(i, x, x + 18, x + 36, y - 4) + f'<text x="{x + 44}" y="{y}">{what}</text>')
    out.append(f'<rect class="m2 band" x="570" y="{y - 14}" width="36" height="18"/><text x="614" y="{y}">within {100 * GOOD:.0f} %</text>')
    out.append(f'<text x="715" y="{y}">marker: median; line: all points of 5 maps</text>')
    return "\n".join(out + ["</svg>"]) + "\n"
