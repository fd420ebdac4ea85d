# SPDX-License-Identifier: BSD-3-Clause
"""Pictures, and HTML pages that hold them: a page opens without a network, a script or another file."""

from __future__ import annotations

import io
import re
from collections.abc import Sequence
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ._errors import FileError
from ._results import need_matplotlib

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Near the beginning of every file that is written; files without it are not replaced.
MARK = "made by python -m fstiff"

#: Characters that move a cursor, end a line or turn the direction of writing, of a name for example: blanks on a page.
NOT_SHOWN = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u200e\u200f\u2028-\u202e\u2066-\u2069]")

#: What text, axes and ticks are drawn in: a page puts its own colour, light or dark, in its place.
INK = "#010203"
STYLE = {
    "axes.edgecolor": INK, "axes.labelcolor": INK, "text.color": INK, "xtick.color": INK, "ytick.color": INK,
    "axes.facecolor": "none", "figure.facecolor": "none", "legend.facecolor": "none", "legend.edgecolor": "none",
    "grid.color": "#8a8a92", "grid.alpha": 0.3, "axes.titlesize": 10, "axes.titleweight": "bold", "font.size": 9,
    "axes.prop_cycle": "cycler('color', ['#d1453b', '#2f80d0', '#2a9d6f', '#9a5fc0', '#d08020', '#1fa3ad'])",
    "svg.fonttype": "none", "svg.hashsalt": "fstiff", "font.family": "sans-serif", "lines.linewidth": 1.6,
}  # fmt: skip

CSS = """:root{color-scheme:light dark}
body{font:15px/1.5 system-ui,'DejaVu Sans',sans-serif;max-width:70rem;margin:1.5rem auto;padding:0 1rem;color:#1d1d1f;
background:#fff;overflow-wrap:anywhere}
table{border-collapse:collapse;font-size:13px;overflow-wrap:normal}
th,td{border:1px solid #c9c9d0;padding:.25rem .6rem;text-align:left;vertical-align:top}th{background:#f2f2f5}
.wide{overflow-x:auto;margin:.8rem 0}figure{margin:1rem 0}figcaption{font-size:13px}svg{max-width:100%;height:auto}
svg text{font-family:system-ui,'DejaVu Sans',sans-serif!important}
h1{margin:.5rem 0;font-size:1.6rem}h2{margin-top:2rem;border-bottom:1px solid #c9c9d0}
.result{border-left:4px solid #1b7f54;padding-left:.8rem}.warned{border-color:#b06000}summary{cursor:pointer;font-weight:600}
@media screen and (min-width:60rem){.pair{display:grid;grid-template-columns:1fr 1fr;gap:0 1.5rem}}.pair>*{min-width:0}
@media screen and (max-width:40rem){body{margin:.5rem auto;padding:0 .7rem}td,th{padding:.2rem .35rem}
td:last-child{min-width:9rem}}
@media screen and (prefers-color-scheme:dark){body{color:#ececf1;background:#16161a}th{background:#26262c}
th,td,h2{border-color:#3a3a42}}
@page{size:A4;margin:11mm}@media print{body{font-size:9.5pt;line-height:1.3;margin:0;padding:0;max-width:none}
table{font-size:8pt}th,td{padding:.1rem .35rem}figure,tr,li{break-inside:avoid}h2{margin-top:.6rem;break-after:avoid}
p,ul{margin:.3rem 0}.wide,figure{margin:.4rem 0}figure svg{max-height:80mm;width:auto}.pair figure svg{max-height:52mm}
.pair{display:grid;grid-template-columns:1fr 1fr;gap:0 1rem}}"""


def sentence(text: str) -> str:
    """`text` with a capital where it begins with a word, and with a stop."""
    first = re.match(r"[a-z]{2,}(?=[ ,:])", text)
    return (text[:1].upper() if first else text[:1]) + text[1:] + ("" if text.endswith((".", "!", "?")) else ".")


def figure(width: float, height: float) -> tuple[Figure, Axes]:
    """A figure of its own [inches] with one plot; drawing it changes no other of the program. Use it within style()."""
    need_matplotlib()
    from matplotlib.figure import Figure

    made = Figure(figsize=(width, height), layout="constrained")
    axes: Axes = made.add_subplot()
    return made, axes


def style() -> Any:
    """A context in which figures are drawn for a page: `with style(): ...`."""
    need_matplotlib()
    import matplotlib

    return matplotlib.rc_context(STYLE)  # type: ignore[arg-type]


def saved(figure: Figure, **how: Any) -> str:
    """The figure as SVG. The same figure gives the same text."""
    text = io.StringIO()
    with style():
        figure.savefig(text, format="svg", **how)
    return text.getvalue()


def svg(figure: Figure) -> str:
    """The figure as an element of a page, in its colours."""
    element = saved(figure, transparent=True, metadata={"Date": None, "Creator": None})
    return re.sub(r' id="(figure|axes|patch|line2d|text|legend|matplotlib\.axis|xtick|ytick)_\d+"', "",
                  element[element.index("<svg") :]).replace(INK, "currentColor")  # fmt: skip


def keep(file: Path) -> None:
    """Raises FileError where `file` is a folder, or was made by somebody else."""
    if file.is_dir():
        raise FileError(f"{file}: is a folder")
    if file.exists() and file.stat().st_size and MARK.encode() not in file.read_bytes()[:2000]:
        raise FileError(f"{file}: was not made by fstiff and is not replaced; move it away or choose another name")


def write(file: Path, text: str) -> None:
    """Writes the file, unless keep() refuses it; its folder is made when missing."""
    keep(file)
    partial = file.with_name(file.name + ".partial")
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        partial.write_text(text, "utf-8", newline="\n")
        partial.replace(file)
    except OSError as error:
        partial.unlink(missing_ok=True)
        raise FileError(f"{file}: cannot be written: {error.strerror}") from error


class Page:
    """A page that is written from its first heading to its end: str(page)."""

    def __init__(self, title: str) -> None:
        self.title = title
        self._body: list[str] = []

    def add(self, html: str) -> None:
        """Adds HTML as it is, such as the begin or the end of a part."""
        self._body.append(html)

    def heading(self, text: str) -> None:
        self.add(f"<h2>{escape(text)}</h2>")

    def paragraph(self, text: str) -> None:
        if text:
            self.add(f"<p>{escape(text)}</p>")

    def bullets(self, items: Sequence[str]) -> None:
        if items:
            self.add("<ul>" + "".join(f"<li>{escape(sentence(one))}</li>" for one in items) + "</ul>")

    def table(self, rows: Sequence[Sequence[str]]) -> None:
        """Rows of texts, the first of them the header."""
        cells = [[f"<t{'d' if i else 'h'}>{escape(cell.strip())}</t{'d' if i else 'h'}>" for cell in row] for i, row in enumerate(rows)]
        self.add('<div class="wide"><table>' + "\n".join("<tr>" + "".join(row) + "</tr>" for row in cells) + "</table></div>")

    def figure(self, of: Figure, caption: str = "") -> None:
        self.add(f"<figure>{svg(of)}" + (f"<figcaption>{escape(caption)}</figcaption>" if caption else "") + "</figure>")

    def __str__(self) -> str:
        return NOT_SHOWN.sub(
            " ",
            f"<!doctype html>\n<!-- {MARK} -->\n"
            '<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">'
            f"<title>{escape(self.title)}</title>\n<style>\n{CSS}\n</style></head>\n<body>\n<h1>{escape(self.title)}</h1>\n"
            + "\n".join(self._body)
            + "\n</body></html>\n",
        )
