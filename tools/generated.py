# SPDX-License-Identifier: BSD-3-Clause
"""What the scripts that write parts of the documents share."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent


def marker(kind, x, y):
    """One point of a curve, as SVG."""
    if kind == "circle":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4.5"/>'
    shapes = {"square": ((-4, -4), (4, -4), (4, 4), (-4, 4)), "triangle": ((0, -5.5), (5, 4), (-5, 4)), "diamond": ((0, -6), (6, 0), (0, 6), (-6, 0)),
              "cross": ((-2, -6), (2, -6), (2, -2), (6, -2), (6, 2), (2, 2), (2, 6), (-2, 6), (-2, 2), (-6, 2), (-6, -2), (-2, -2))}
    return '<polygon points="' + " ".join(f"{x + dx:.1f},{y + dy:.1f}" for dx, dy in shapes[kind]) + '"/>'


def style(colours):
    """Of pictures that follow the light or dark surroundings; colours: (on light, on dark, marker) of .c0 and .m0, .c1 and .m1 ..."""
    light = ["text{font:13px system-ui,'DejaVu Sans',sans-serif;fill:#1d1d1f}", ".back{fill:#ffffff}", ".grid{stroke:#d9d9de;stroke-width:1}",
             ".frame{fill:none;stroke:#6b6b70}", ".title{font-size:15px;font-weight:600}", ".line{fill:none;stroke-width:2}"]
    dark = ["text{fill:#ececf1}", ".back{fill:#16161a}", ".grid{stroke:#3a3a42}", ".frame{stroke:#9a9aa2}"]
    for i, (day, night, _) in enumerate(colours):
        light.append(f".c{i}{{stroke:{day}}}.m{i}{{fill:{day}}}")
        dark.append(f".c{i}{{stroke:{night}}}.m{i}{{fill:{night}}}")
    return f"<style>{''.join(light)}@media (prefers-color-scheme:dark){{{''.join(dark)}}}</style>"


def between_markers(path, name, text):
    """The text of the file at path, with text between its lines <!-- name --> and <!-- /name -->."""
    new, count = re.subn(rf"(<!-- {name} -->\n).*(<!-- /{name} -->)", lambda m: m[1] + text + "\n" + m[2], path.read_text(), flags=re.S)
    if count != 1:
        raise ValueError(f"{path.relative_to(ROOT)} has no lines <!-- {name} --> and <!-- /{name} --> for the table")
    return new


def write_or_check(wanted, source, script, check):
    """Writes the texts by path, or says which differ; the exit code."""
    old = [path.relative_to(ROOT) for path, text in wanted.items() if not path.exists() or path.read_text() != text]
    if check:
        for path in old:
            print(f"{path} is not what {source} gives: run tools/{script}")
        return 1 if old else 0
    for path, text in wanted.items():
        path.write_text(text)
    return 0
