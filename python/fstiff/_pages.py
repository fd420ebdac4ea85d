# SPDX-License-Identifier: BSD-3-Clause
"""Pictures by matplotlib with their numbers as CSV, a page with them, and the folder that they are written into."""

from __future__ import annotations

import base64
import csv
import io
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from ._errors import FileError
from ._results import html_of

if TYPE_CHECKING:
    from ._results import Numbers

MARK = "made by python -m fstiff"  #: near the beginning of every file; files without it are not replaced


class Curve(NamedTuple):
    label: str
    x: Numbers
    y: Numbers
    style: str  #: colour, marker and dashes as matplotlib abbreviates them
    others: dict[str, Any] = {}


class Panel(NamedTuple):
    axes: dict[str, Any]  #: labels with units, scales and limits, as matplotlib calls them
    curves: list[Curve]
    window: tuple[str, float, float] | None = None  #: a range of x with its label


class Picture(NamedTuple):
    name: str
    title: str
    caption: str
    panels: list[Panel]


def require_matplotlib() -> None:
    if find_spec("matplotlib") is None:
        raise ImportError("pictures need matplotlib: pip install 'fstiff[plot]'")


def svg(picture: Picture) -> str:
    """The picture; the same text at every run."""
    from matplotlib import rc_context
    from matplotlib.figure import Figure
    from matplotlib.layout_engine import ConstrainedLayoutEngine

    file = io.StringIO()
    with rc_context({"svg.fonttype": "none", "svg.hashsalt": "fstiff"}):
        figure = Figure(figsize=(7, 4.6 * len(picture.panels)), layout=ConstrainedLayoutEngine(w_pad=0.1, h_pad=0.1))
        figure.suptitle(picture.title, weight="bold")
        for i, panel in enumerate(picture.panels):
            axes = figure.add_subplot(len(picture.panels), 1, i + 1)
            for curve in panel.curves:
                axes.plot(curve.x, curve.y, curve.style, label=curve.label, **curve.others)
            if panel.window:
                label, low, high = panel.window
                axes.axvspan(low, high, color="0.9", zorder=0, label=label)
            axes.set(**panel.axes)
            for axis in (axes.xaxis, axes.yaxis):
                if axis.get_scale() == "log":
                    axis.set_major_formatter("{x:g}")
            axes.grid(alpha=0.3)
            axes.legend(fontsize="small", framealpha=0.9, edgecolor="none")
        figure.savefig(file, format="svg", metadata={"Creator": MARK, "Date": None})
    return file.getvalue()


def numbers(picture: Picture) -> str:
    """The points of the curves as CSV."""
    file = io.StringIO()
    file.write(f"# {MARK}: the numbers of a picture\n")
    rows = csv.writer(file, lineterminator="\n")
    rows.writerow(["curve", "panel", "label", "x_quantity", "x", "y_quantity", "y", "low", "high"])
    curves = [(place, panel.axes, curve) for place, panel in enumerate(picture.panels, 1) for curve in panel.curves]
    for i, (place, axes, curve) in enumerate(curves, 1):
        for x, y in zip(curve.x.tolist(), curve.y.tolist()):
            rows.writerow([i, place, curve.label, axes["xlabel"], x, axes["ylabel"], y, "", ""])
    return file.getvalue()


PAGE = """<!doctype html>
<!-- {mark} -->
<html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>{title}</title>
<style>
:root {{ color-scheme: light dark }}
body {{ font: 15px/1.5 system-ui, sans-serif; max-width: 60rem; margin: 1.5rem auto; padding: 0 1rem }}
p {{ margin: 0.3rem 0 }} figure {{ margin: 2rem 0 }} img {{ max-width: 100% }}
table {{ display: block; overflow-x: auto; border-collapse: collapse }}
th, td {{ text-align: left; padding: 0.2rem 1rem 0.2rem 0; border-bottom: 1px solid #8884 }}
@media (prefers-color-scheme: dark) {{ img {{ filter: invert(0.93) hue-rotate(180deg) }} }}
</style>
"""


def page(title: str, sections: dict[str, str], pictures: list[Picture], drawings: list[str]) -> str:
    """One page of sections of text by their titles, and of the pictures, which are inside: it opens without a network."""
    parts = [PAGE.format(title=title, mark=MARK)]
    parts += [f"<h2>{heading}</h2>\n{html_of(text)}\n" for heading, text in sections.items()]
    for picture, drawing in zip(pictures, drawings):
        data = base64.b64encode(drawing.encode()).decode()
        parts.append(f'<figure><img alt="{picture.title}" src="data:image/svg+xml;base64,{data}">')
        parts.append(f"<figcaption>{picture.caption}</figcaption></figure>\n")
    return "".join(parts)


def write(name: str, title: str, sections: dict[str, str], pictures: list[Picture], texts: dict[str, str]) -> list[str]:
    """Writes the pictures with their numbers, other texts and index.html into the folder `name`. Returns the names of the files."""
    folder = Path(name)
    if folder.exists() and not folder.is_dir():
        raise FileError(f"{folder}: is not a folder")
    drawings = [svg(picture) for picture in pictures]
    files = {f"{picture.name}.svg": drawing for picture, drawing in zip(pictures, drawings)}
    files |= {f"{picture.name}.csv": numbers(picture) for picture in pictures}
    files |= {key: f"<!-- {MARK} -->\n{text}" for key, text in texts.items()}
    files["index.html"] = page(title, sections, pictures, drawings)
    for file in (folder / key for key in files):
        if file.exists() and MARK.encode() not in file.read_bytes()[:2000]:
            raise FileError(f"{file}: was not made by fstiff and is not replaced; move it away or choose another folder")
    folder.mkdir(parents=True, exist_ok=True)
    for key, text in files.items():
        (folder / key).write_text(text, "utf-8", newline="\n")
    return [str(folder / key) for key in files]
