# SPDX-License-Identifier: BSD-3-Clause
"""Report of a scene as one HTML file, with its pictures inside.

The answer is first: K with its band, what it rests on and what speaks against it; then what follows under the same pressures, the
inputs, the measured surface, the checks, the numbers and the equations. The page opens without a network.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from . import _core, _run
from ._page import Page, figure, keep, sentence, style, write
from ._pictures import draw_bearing, draw_curves, draw_heights, draw_islands, draw_scales, draw_structure
from ._results import Table, heading, shown, with_unit
from ._scenes import Curves, Scene
from ._surfaces import Scales

#: Quantities under the same pressures, and what their pictures are called.
UNDER = {key: title for _, key, title in _core.quantities if title} | {
    "tangential_stiffness_Pa_per_m": "Tangential stiffness", "real_area_fraction": "Real area over nominal area",
    "contacts_per_m2": "Contacts", "separation_m": "Separation of the mean planes", "approach_m": "Approach of the faces",
}  # fmt: skip

#: Checks of the models, and when they hold.
CHECKS = {
    "plasticity": ("plasticity index ψ = (E/H)√(σ/R)", "elastic peaks at most {}"),
    "gaussian_surface": ("σ R D_p, that an isotropic Gaussian surface can have", "at least {}"),
    "interacting_asperities": ("p/(E g), beyond which peaks interact", "at most {}"),
    "mean_planes_crossed": ("separation of the mean planes [m]", "at least {}"),
    "above_highest_peak": ("separation [m] below the highest peak", "at most {}"),
    "few_contacts": ("contacts on the nominal area", "at least {}"),
    "area_above_nominal": ("real area over nominal area", "at most {}"),
    "above_hardness": ("mean contact pressure [Pa] below the hardness", "at most {}"),
    "not_converged": ("relative error of K", "at most {}"),
}


def report(scene: Any = None, *, surface: Any = None) -> str:
    """The page of a scene, which is what Scene() takes with `surface`, or a Scene: the text of an HTML file."""
    return page_of(scene if isinstance(scene, Scene) else Scene(scene, surface=surface))[0]


def page_of(scene: Scene) -> tuple[str, Curves]:
    """The page, and the curves it shows."""
    curves = scene.run()
    found, smooth = curves._found, curves.smooth()
    document = json.loads(found["document"])
    page = Page(scene.name)
    answer_section(page, curves, smooth, found["input_lines"], document)
    under_section(page, curves, smooth)
    page.heading("Inputs")
    inputs = document["inputs"].items()
    rows = [[key, with_unit(one["value"], one.get("unit", ""), 5) if "value" in one else "", one["written"]] for key, one in inputs]
    page.table([["key", "value", "as written"], *rows])
    points = scene._core.points
    for name, measured in scene._core.measured():
        surface_section(page, name, measured, float(points[points.size // 2]), curves.effective_modulus)
    page.heading("Validity")
    page.table([["check", "of", "value", "holds where", "result"], *map(check_row, found["checks"])])
    numbers_section(page, curves)
    page.heading("Equations")
    laws = document["laws"].items()
    page.table([["law", "load", "stiffness", "peaks"], *([name, *(law[key] for key in ("load", "stiffness", "peaks"))] for name, law in laws)])
    page.paragraph(
        f"Effective modulus {with_unit(curves.effective_modulus, 'Pa')} of both bodies. Equation numbers refer to R. Buczkowski, "
        "M. Kleiber, G. Starzyński, Normal contact stiffness of fractal rough surfaces, Arch. Mech. 66 (2014). K/A0 is the stiffness "
        "per nominal area; 1 MPa/µm is 1e12 Pa/m."
    )
    page.paragraph(f"Computed by fstiff {_core.version} from {document['scene']['file']}, SHA-256 {document['scene']['sha256']}.")
    return str(page), curves


def picture(page: Page, draw: Callable[[Any], Any], title: str, caption: str = "", size: tuple[float, float] = (4.6, 2.9)) -> None:
    with style():
        made, ax = figure(*size)
        draw(ax)
        ax.set_title(title)
    page.figure(made, caption)


def answer_section(page: Page, curves: Curves, smooth: Curves, lines: list[tuple[str, list[str]]], document: dict[str, Any]) -> None:
    """The first screen: K, what it rests on, what speaks against it, and the picture."""
    if document["answer"]:
        page.table(curves._found["answer_table"])
    page.add('<div class="pair"><div>')
    page.add(f'<div class="result{" warned" if curves.warnings else ""}">')
    page.paragraph(
        "Result: doubtful. Read the warnings before using any of these numbers."
        if curves.doubtful
        else "Result: computed, but not all assumptions of the model hold."
        if curves.warnings
        else "Result: no warnings; the band of K includes the known uncertainties."
    )
    page.bullets([*curves.explanation, *curves.warnings])
    page.add("</div>")
    page.paragraph(document["outside_band"] if document["answer"] else "")
    page.table([["input", ""], *([label, ", ".join(parts)] for label, parts in lines)])
    page.add("</div>")
    if "stiffness_Pa_per_m" in curves:
        draw = lambda ax: draw_curves(curves, smooth, "stiffness_Pa_per_m", "pressure_Pa", ax)
        picture(page, draw, "Normal stiffness per nominal area", size=(5.0, 4.0))
    page.add("</div>")
    if not curves._best:
        named_laws(page, curves)


def named_laws(page: Page, curves: Curves) -> None:
    """K of the laws that the scene names, with their bands, at seven pressures at most."""
    import numpy as np

    if "stiffness_Pa_per_m" not in curves:
        return
    label, factor = heading("stiffness_Pa_per_m", curves["stiffness_Pa_per_m"])
    pressures = np.unique(curves["pressure_Pa"])
    few = pressures[np.unique(np.linspace(0, pressures.size - 1, 7).astype(int))]
    rows = [[label, *(with_unit(p, "Pa", 3) for p in few)]]
    for title, columns in curves.parts():
        cells = []
        for p in few:
            at = np.flatnonzero(columns["pressure_Pa"] == p)
            ends = curves._bands.get("stiffness_Pa_per_m", ())
            k, *band = (columns[key][at[0]] * factor if at.size else np.nan for key in ("stiffness_Pa_per_m", *ends))
            cells.append(shown(k, 3) + (f" ({shown(band[0], 2)}–{shown(band[1], 2)})" if band and band[0] == band[0] else ""))
        rows.append([title, *cells])
    page.paragraph("Laws that the scene names" + (", with 5 % and 95 % in brackets." if curves._bands else "."))
    page.table(rows)


def under_section(page: Page, curves: Curves, smooth: Curves) -> None:
    """What else the scene asks for, under the same pressures."""
    import numpy as np

    page.heading("Under the same pressures")
    page.add('<div class="pair">')
    for key, title in UNDER.items():
        if key in curves and np.any(curves[key] > 0):
            picture(page, lambda ax: draw_curves(curves, smooth, key, "pressure_Pa", ax), title)
    page.add("</div>")


def surface_section(page: Page, name: str, found: _core.Found, pressure: float, modulus: float) -> None:
    """A measured face: where it comes from, its parameters, its pictures, and the influence of the cut-offs."""
    document = json.loads(found.json)
    source = document["source"]
    page.heading("Measured surface" + (f", {name}" if name != "surface" else ""))
    page.paragraph(f"{source['file']}, a {source['kind']}, SHA-256 {source['sha256']}.")
    page.bullets(source["decisions"])
    rows = [["parameter", "value", "found by"]]
    for key, one in document["surface"].items():
        rows.append([key.replace("_", " "), with_unit(one["value"], one.get("unit", ""), 5, one["error"]), one["how"]])
    page.table(rows)
    page.add('<div class="pair">')
    for part in found.measured.parts() or [found.measured]:
        views_section(page, part.views())
    page.add("</div>")
    scales = scales_of(found.measured, pressure, modulus)
    if scales:
        page.heading("Influence of the cut-offs")
        page.bullets(scales["scales"]["settled"])
        page.add('<div class="pair">')
        for of in (one for one in ("lambda_s", "lambda_c") if sum(row.get(one + "_m") is not None for row in scales["scales"]["rows"]) > 1):
            picture(page, lambda ax: draw_scales(ax, scales, of), f"Filtered with other {of}")
        page.add("</div>")
        page.paragraph(f"K by {scales['scales']['law']} at {with_unit(pressure, 'Pa')}.")


def scales_of(measured: _core.Measured, pressure: float, modulus: float) -> Table[Any] | None:
    """The document of fstiff measure --scales; None of several files, of an array, and of what was measured before."""
    try:
        return Scales(_core.scales(measured, _core.Heights(None, 0.0, 0.0, "", ""), pressure, modulus))
    except ValueError:
        return None


def views_section(page: Page, views: dict[str, Any]) -> None:
    """The heights, the bearing curve, the structure functions and the islands."""
    if "heights" not in views:
        return page.paragraph("Its numbers were measured before; no heights are here to be drawn.")
    heights, dx, dy = views["heights"]
    square = (4.6, 3.8) if dy else (4.6, 2.4)
    picture(page, lambda ax: draw_heights(ax, heights, dx, dy), "Heights without the form", size=square)
    picture(page, lambda ax: draw_bearing(ax, heights), "Bearing curve")
    fits = [(key.removeprefix("fit").strip(), of) for key, of in views.items() if key.startswith("fit")]
    if fits:
        caption = "Mean square of the second differences of the heights, and the curve fitted to it, which gives D and G."
        picture(page, lambda ax: draw_structure(ax, fits), "Structure function of second differences", caption)
    if "islands" in views:
        picture(page, lambda ax: draw_islands(ax, views["islands"], "density_per_m2"), "Density of islands")
        picture(page, lambda ax: draw_islands(ax, views["islands"], "radius_m"), "Radius of the mean island")


def check_row(check: tuple[str, str, float, float, float, bool]) -> list[str]:
    of, concern, least, greatest, limit, holds = check
    what, where = CHECKS.get(concern, (concern.replace("_", " "), "at most {}"))
    values = "none" if least > greatest else shown(least, 3) if least == greatest else f"{shown(least, 3)} to {shown(greatest, 3)}"
    known = limit == limit and abs(limit) != float("inf")
    verdict = "holds" if holds else "does not hold"
    return [what, of, values, *((where.format(shown(limit, 3)), verdict) if known else ("not known", "not checked"))]


def numbers_section(page: Page, curves: Curves) -> None:
    """Every number, a closed table for each curve."""
    page.heading("Numbers")
    for title, columns in curves.parts():
        names = {key: heading(key, column) for key, column in columns.items() if column.dtype.kind == "f" and key not in ("theta", "r")}
        size = columns["pressure_Pa"].size
        page.add(f"<details><summary>{title}: {size} points</summary>")
        page.table(
            [[name for name, _ in names.values()]]
            + [[shown(columns[key][i] * factor, 5) for key, (_, factor) in names.items()] for i in range(size)]
        )
        page.add("</details>")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    _run.add_arguments(parser)
    parser.add_argument("-o", "--output", metavar="FILE.html", required=True, help="the page")


def execute(arguments: argparse.Namespace) -> int:
    file = arguments.output
    if not file.endswith(".html"):
        raise ValueError(f"--output = {file}: must end in .html")
    keep(Path(file))
    text, curves = page_of(Scene(arguments.scene, surface=arguments.surface))
    write(Path(file), text)
    print(f"report of {curves.name}: {file}")
    for warning in curves.warnings:
        print(f"fstiff: warning: {sentence(warning)}", file=sys.stderr)
    return 4 if curves.doubtful else 0
