# SPDX-License-Identifier: BSD-3-Clause
"""What the scripts that write parts of the documents share: pictures, tables, the texts between markers, and their comparison."""
import html
import math
import pathlib
import re
from dataclasses import dataclass

ROOT = pathlib.Path(__file__).resolve().parent.parent
SHAPES = {"square": ((-4, -4), (4, -4), (4, 4), (-4, 4)), "triangle": ((0, -5.5), (5, 4), (-5, 4)), "diamond": ((0, -6), (6, 0), (0, 6), (-6, 0)),
          "cross": ((-2, -6), (2, -6), (2, -2), (6, -2), (6, 2), (2, 2), (2, 6), (-2, 6), (-2, 2), (-6, 2), (-6, -2), (-2, -2))}
LIGHT = ("text{font:13px system-ui,'DejaVu Sans',sans-serif;fill:#1d1d1f}.back{fill:#ffffff}.grid{stroke:#d9d9de}.frame{fill:none;stroke:#6b6b70}"
         ".strong{stroke:#1d1d1f;stroke-width:1.5}.title{font-size:15px;font-weight:600}.small{font-size:11px}.line{fill:none;stroke-width:2}"
         ".band{fill-opacity:.14}")
DARK = "text{fill:#ececf1}.back{fill:#16161a}.grid{stroke:#3a3a42}.frame{stroke:#9a9aa2}.strong{stroke:#ececf1}.band{fill-opacity:.22}"
NUMBER = re.compile(r"-?\d+(?:\.\d+)?")


@dataclass
class Axis:
    """marks: the numbers that have a line, with their texts. An axis may fall."""
    label: str
    low: float
    high: float
    marks: dict
    logarithmic: bool = True

    def share(self, value):
        scale = math.log if self.logarithmic else float
        return (scale(value) - scale(self.low)) / (scale(self.high) - scale(self.low))


def powers(low, high, every=1):
    """Marks of an axis at powers of ten, with the text of every so manyth."""
    return {10.0**k: "10" + str(k).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")) if k % every == 0 else "" for k in range(low, high + 1)}


class Picture:
    """An SVG that follows the light or dark surroundings; looks: (colour on light, on dark, marker) of each curve."""

    def __init__(self, width, height, title, looks):
        self.looks = looks
        light, dark = ("".join(f".c{i}{{stroke:{look[k]}}}.m{i}{{fill:{look[k]}}}" for i, look in enumerate(looks)) for k in (0, 1))
        self.parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" role="img" aria-labelledby="title">'
                      f'\n<title id="title">{html.escape(title)}</title>\n<style>{LIGHT}{light}@media (prefers-color-scheme:dark){{{DARK}{dark}}}</style>']
        self.rectangle("back", 0, 0, width, height)

    def __str__(self):
        return "\n".join([*self.parts, "</svg>\n"])

    def text(self, x, y, text, how=""):
        if text:
            self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" {how}>{html.escape(text)}</text>')

    def line(self, kind, x1, y1, x2, y2):
        self.parts.append(f'<line class="{kind}" x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}"/>')

    def rectangle(self, kind, x, y, width, height):
        self.parts.append(f'<rect class="{kind}" x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}"/>')

    def polygon(self, kind, points, name="polygon"):
        self.parts.append(f'<{name} class="{kind}" points="' + " ".join(f"{x:.1f},{y:.1f}" for x, y in points) + '"/>')

    def markers(self, i, points):
        for x, y in points:
            shape = self.looks[i][2]
            if shape == "circle":
                self.parts.append(f'<circle class="m{i}" cx="{x:.1f}" cy="{y:.1f}" r="4.5"/>')
            else:
                self.polygon(f"m{i}", [(x + dx, y + dy) for dx, dy in SHAPES[shape]])

    def curve(self, i, points, markers=True):
        self.polygon(f"line c{i}", points, "polyline")
        if markers:
            self.markers(i, points)

    def sample(self, i, x, y, text):
        """A line of the legend."""
        self.curve(i, [(x, y), (x + 26, y)], False)
        self.markers(i, [(x + 13, y)])
        self.text(x + 34, y + 4, text)

    def frame(self, left, top, width, height, across, up, strong=None):
        """The frame of a plot, its grid and axes, with the line at strong a strong one; returns where a point is."""
        place = lambda x, y: (left + width * across.share(x), top + height * (1 - up.share(y)))
        for mark, text in across.marks.items():
            x = left + width * across.share(mark)
            self.line("strong" if mark == strong else "grid", x, top, x, top + height)
            self.text(x, top + height + 20, text, 'text-anchor="middle"')
        for mark, text in up.marks.items():
            y = top + height * (1 - up.share(mark))
            self.line("strong" if mark == strong else "grid", left, y, left + width, y)
            self.text(left - 8, y + 4, text, 'text-anchor="end"')
        self.rectangle("frame", left, top, width, height)
        self.text(left + width / 2, top + height + 44, across.label, 'text-anchor="middle"')
        self.text(20, top + height / 2, up.label, f'text-anchor="middle" transform="rotate(-90 20 {top + height / 2})"')
        return place


def themed(text):
    """An SVG that matplotlib drew in black on white, as one that follows the light or dark surroundings."""
    ink = lambda colour: f"svg{{color:{colour};fill:{colour}}}"
    rules = f"{ink('#1d1d1f')}.back{{fill:#ffffff}}@media (prefers-color-scheme:dark){{{ink('#ececf1')}.back{{fill:#16161a}}}}"
    text = text.replace("#ffffff", "none").replace("#000000", "currentColor").replace("#010203", "currentColor")  # the last: INK of the package
    return re.sub(r"(<svg [^>]*>)", rf'\1\n <style>{rules}</style>\n <rect class="back" width="100%" height="100%"/>', text, count=1)


def legendre(points, tolerance, number=float, cosine=lambda share: math.cos(math.pi * share)):
    """Nodes and weights of Gauss and Legendre on (-1, 1), by Newton's method; cosine: of a share of pi."""
    rule = []
    for i in range(points):
        x, step = cosine((i + number(3) / 4) / (points + number(1) / 2)), 1
        for _ in range(100):
            below, here = number(1), x
            for n in range(2, points + 1):
                below, here = here, ((2 * n - 1) * x * here - (n - 1) * below) / n
            slope = points * (x * here - below) / (x * x - 1)
            if abs(step) < tolerance:
                break
            step = here / slope
            x -= step
        rule.append((x, 2 / ((1 - x * x) * slope * slope)))
    return rule


def table(head, lines):
    """Lines of a table of Markdown with right-aligned numbers."""
    return ["| " + " | ".join(line) + " |" for line in (head, ["---"] + ["---:"] * (len(head) - 1), *lines)] + [""]


def between_markers(path, **parts):
    """The text of the file at path, with each part between its lines <!-- name --> and <!-- /name -->."""
    text = path.read_text(encoding="utf-8")
    for name, part in parts.items():
        text, count = re.subn(rf"(<!-- {name} -->\n).*(<!-- /{name} -->)", lambda m: m[1] + part + "\n" + m[2], text, flags=re.S)
        if count != 1:
            raise ValueError(f"{path.relative_to(ROOT)} has no lines <!-- {name} --> and <!-- /{name} --> for the table")
    return text


def same(one, two, tolerance):
    """Whether the texts differ in numbers alone, by no more than tolerance."""
    return NUMBER.split(one) == NUMBER.split(two) and all(
        abs(float(a) - float(b)) <= tolerance for a, b in zip(NUMBER.findall(one), NUMBER.findall(two)))


def write_or_check(wanted, script, check, tolerance=0.0):
    """Writes the texts by path, or prints which differ (pictures: by more than tolerance); the exit code."""
    if not check:
        for path, text in wanted.items():
            path.write_text(str(text), encoding="utf-8")
        return 0
    old = [path.relative_to(ROOT) for path, text in wanted.items() if not path.exists() or
           not same(path.read_text(encoding="utf-8"), str(text), tolerance if path.suffix == ".svg" else 0.0)]
    for path in old:
        print(f"{path} is not what tools/{script} makes: run it")
    return 1 if old else 0
