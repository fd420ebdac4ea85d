# SPDX-License-Identifier: BSD-3-Clause
"""The figures, tables and conclusions of the reference paper, into a folder.

    python examples/paper/reproduce.py FOLDER

FOLDER, which is made when missing, has Figs. 2, 4, 6, 7, 8 and 9 as SVG with their numbers (CSV), and index.html with all of it. The
program needs the package fstiff and matplotlib (pip install 'fstiff[plot]').
"""

import argparse
import csv
import math
import re
from html import escape
from pathlib import Path
from typing import Any, NamedTuple

import matplotlib
import numpy as np
from matplotlib.figure import Figure

import fstiff

PAPER = "R. Buczkowski, M. Kleiber, G. Starzyński, Normal contact stiffness of fractal rough surfaces, Arch. Mech. 66 (2014)"
NO_POINTS = "Experimental points are not drawn: they are only in the paper's figures, not in its text or tables."
REMARK = "The discussion adds that a smoother surface has the larger D; Table 2 has the largest D, 1.70, on the roughest one."
ERRATA = Path(__file__).parents[2] / "docs" / "errata.md"
PAGE = """<!doctype html>
<html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>The paper reproduced</title>
<style>body{font-family:sans-serif;max-width:70rem;margin:1rem auto}pre{white-space:pre-wrap}img{max-width:100%}</style>"""

AREA = 195e-6  #: nominal [m^2]
MODULUS = fstiff.effective_modulus(205e9, 0.3, 205e9, 0.3)
YIELDING: Any = {"poisson_ratio": 0.3, "yield_strength": 400e6}
PRESSURES = np.array([1e5 * 10 ** (k / 10) for k in range(31)])  #: [Pa]
SEED = 2014
GAMMA = 1.5  #: ratio of neighbouring wavelengths of a sum of cosines
UNFILTERED: Any = {"detrend": "none", "lambda_s": "none"}  #: options of a generated surface

Numbers = np.ndarray
Rows = list[list[str]]  #: of a table, the first one its header


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


class Specimen(NamedTuple):
    """A row of Tables 1 and 2, in SI units."""

    figure: str
    name: str
    rms_height: float
    peak_radius: float
    peak_density: float
    max_peak_height: float
    fractal_dimension: float
    fractal_roughness: float

    def stiffness(self, law: str, theta: str = "pi/4", **others: Any) -> Numbers:
        """K at PRESSURES [Pa/m]."""
        contact = fstiff.Contact(
            law, rms_height=self.rms_height, peak_radius=self.peak_radius, peak_density=self.peak_density,
            max_peak_height=self.max_peak_height, fractal_dimension=self.fractal_dimension, effective_modulus=MODULUS,
            **exponential(theta), **others,
        )  # fmt: skip
        return contact.at_pressures(PRESSURES, ["stiffness"])["stiffness_Pa_per_m"]

    def structure_function(self, lag: Any) -> Any:
        """C lag^(4-2D) [m^2] with the exact constant of (2.4)."""
        d = self.fractal_dimension
        gammas = math.gamma(2 * d - 3) * math.sin((2 * d - 3) * math.pi / 2)
        constant = (2 * math.pi) ** (4 - 2 * d) * gammas / ((4 - 2 * d) * math.log(GAMMA))
        return constant * self.fractal_roughness ** (2 * d - 2) * lag ** (4 - 2 * d)


SPECIMENS = (
    Specimen("fig7", "sand blasted (fine)", 0.832e-6, 40e-6, 500e6, 5.3e-6, 1.62, 1.2e-8),
    Specimen("fig8", "sand blasted (coarse)", 5.13e-6, 30e-6, 230e6, 15.3e-6, 1.58, 1.1e-7),
    Specimen("fig9", "electrical discharge machining", 8.94e-6, 19e-6, 160e6, 48e-6, 1.70, 8.2e-7),
)


def exponential(theta: str) -> Any:
    """r and theta of the peaks of a profile with exponential autocorrelation: 1 - r² = cot² θ."""
    angle = math.pi / int(theta.removeprefix("pi/"))
    cot = math.cos(angle) / math.sin(angle)
    return {"r": math.sqrt(max(0.0, (1 - cot) * (1 + cot))), "theta": angle}


def density_of_heights(zeta: Numbers, r: float, theta: float) -> Numbers:
    """Eq. (4.4), integrated over the curvature t by Gauss and Legendre: within 1e-14 of the greatest."""
    nodes, weights = np.polynomial.legendre.leggauss(100)
    t, c = 6 * (nodes + 1), math.sqrt(1 - r * r)
    erf = np.array([math.erf(one * math.tan(theta) / math.sqrt(2)) for one in t])
    z = (zeta[:, None] - r * t) / c
    density: Numbers = np.exp(-(z**2 + t**2) / 2) @ (6 * weights * erf) / (2 * theta * c)
    return density


def figure_2() -> Picture:
    z, styles = np.linspace(-4, 4, 161), {2: "C0:", 3: "C1-", 5: "C2--"}
    curves = [Curve(f"r = 1/{n}", z, density_of_heights(z, 1 / n, math.pi / 3), style) for n, style in styles.items()]
    curves.append(Curve("Gaussian heights of all ordinates", z, np.exp(-z * z / 2) / math.sqrt(2 * math.pi), "k:", {"lw": 1}))
    caption = "Fig. 2: density of the heights of the peaks for θ = π/3, eq. (4.4) integrated over the curvature."
    axes = {"xlabel": "height of a peak ζ = z/σ", "ylabel": "probability density", "ylim": (0, None)}
    return Picture("fig2", "Fig. 2: heights of the peaks, θ = π/3", caption, [Panel(axes, curves)])


def longest_wave(specimen: Specimen) -> float:
    """Longest wave of the Gaussian map whose sections have the S of the specimen and its rms height (docs/theory-surface.md)."""
    h, unit = 2 - specimen.fractal_dimension, specimen.fractal_roughness
    level = specimen.structure_function(unit) / specimen.rms_height**2
    gammas = math.gamma(1 - h) / math.gamma(1 + h)
    return float(math.pi * unit * (2 * gammas / level) ** (1 / (2 * h)))


def shortest_wave(specimen: Specimen, longest: float) -> float:
    """Shortest wave with which a Gaussian map has the density of islands of Table 1, most of them (2 pi)^-1.5 e^-0.5 m2/m0."""
    h = 2 - specimen.fractal_dimension
    m2 = specimen.peak_density * (2 * math.pi) ** 1.5 * math.exp(0.5)  # over m0
    ratio = math.inf  # b of m2/m0 = 2 pi^2/longest^2 h/(1 - h) (b^(2-2h) - 1)/(1 - b^(-2h))
    for _ in range(100):
        ratio = (1 + m2 * longest**2 / (2 * math.pi**2) * (1 - h) / h * (1 - ratio ** (-2 * h))) ** (1 / (2 - 2 * h))
    return longest / ratio


def figure_4() -> tuple[Picture, Rows]:
    density, radius, generated = [], [], []
    for k, specimen in enumerate(SPECIMENS):
        longest = longest_wave(specimen)
        shortest = shortest_wave(specimen, longest)
        surface = fstiff.generate(
            "map", shortest / 4, points=1024, hurst=2 - specimen.fractal_dimension, rms=specimen.rms_height,
            longest=longest, shortest=shortest, long_waves="none", seed=SEED,
        )  # fmt: skip
        found = fstiff.islands(surface, tiles=4, resamples=200, seed=SEED, **UNFILTERED)
        curve, most = found["curve"], found["representative"]
        share = 100 * curve["bearing_area"]
        density.append(Curve(specimen.name, share, curve["density_per_m2"] * 1e-6, f"C{k}-"))
        radius.append(Curve(specimen.name, share, curve["radius_m"] * 1e6, f"C{k}-"))
        rows = [
            ("longest wave [mm]", shown(longest * 1e3, 3), "from σ, D, G"),
            ("shortest wave [µm]", shown(shortest * 1e6, 3), "from D_p, by 0.0385 m2/m0"),
            ("bearing area at most islands [%]", shown(100 * most["bearing_area"], 3), "about 20"),
            ("D_p [1/mm²]", with_error(most, "peak_density{}_per_m2", 1e-6, 4), shown(specimen.peak_density * 1e-6)),
            ("R [µm]", with_error(most, "peak_radius{}_m", 1e6), shown(specimen.peak_radius * 1e6)),
        ]
        generated += [["Fig. 4", specimen.name, *row] for row in rows]
    of_density = {"title": "Density of islands", "ylabel": "islands [1/mm²]", "xlim": (0, 100), "ylim": (0, None)}
    of_radius = {"title": "Radius of the mean island", "ylabel": "R [µm]", "yscale": "log", "xlim": (0, 50), "ylim": (10, 1000)}
    panels = [
        Panel({"xlabel": "bearing area [%]", **of_density}, density, ("about 20 %, the paper", 18, 22)),
        Panel({"xlabel": "bearing area [%]", **of_radius}, radius),
    ]
    caption = (
        "Fig. 4, from generated Gaussian self-affine maps of 1024 × 1024 points: the measured ones are not in the text. D, G and σ "
        "fix the longest wave; the shortest one is chosen for the density of Table 1, so that the density is put in, while the bearing "
        "area of its maximum and the radius come out."
    )
    return Picture("fig4", "Fig. 4: islands against the bearing area, generated maps", caption, panels), generated


def figure_6() -> tuple[Picture, Rows]:
    specimen, spacing = SPECIMENS[0], 0.5e-6
    d, g = specimen.fractal_dimension, specimen.fractal_roughness
    # sigma^2 = G^(2D-2) longest^(4-2D) / (2 (1 - gamma^(2D-4))) of the endless sum
    longest = g * (2 * (specimen.rms_height / g) ** 2 * (1 - GAMMA ** (2 * d - 4))) ** (1 / (4 - 2 * d))
    waves_of: Any = {"dimension": d, "roughness": g, "gamma": GAMMA, "longest": longest, "shortest": 2 * spacing}
    surface = fstiff.generate("wm", spacing, points=16000, seed=SEED, **waves_of)
    found = fstiff.fit(surface, seed=SEED, **UNFILTERED)
    first, second = found["structure_function"], found["second_differences"]
    waves = longest * GAMMA ** -np.arange(1 + math.floor(math.log(longest / (2 * spacing)) / math.log(GAMMA)))
    amplitudes = waves * (g / waves) ** (d - 1)
    endless = specimen.structure_function(first["lag_m"])
    summed = (2 * (amplitudes * np.sin(np.pi * first["lag_m"][:, None] / waves)) ** 2).sum(axis=1)

    def curve(label: str, columns: Any, style: str) -> Curve:
        return Curve(label, columns["lag_m"] * 1e6, columns["value_m2"] * 1e12, style)

    curves = [
        curve("S of the profile, eq. (2.8)", thinned(first), "C0o"),
        curve("S of the cosines that were summed", {**first, "value_m2": summed}, "C0-"),
        curve("C τ^(4-2D), D and G of Table 2: a sum without ends", {**first, "value_m2": endless}, "k--"),
        curve("S₂ of its second differences", thinned(second), "C1^"),
        curve("what is fitted to S₂, with D and G", found["fitted"], "C1-"),
    ]
    axes = {"xlabel": "lag τ [µm]", "ylabel": "S, S₂ [µm²]", "xscale": "log", "yscale": "log"}
    generated = [
        ("longest wave [mm]", shown(longest * 1e3, 3), "from σ, D, G"),
        ("D", with_error(found, "fractal_dimension{}", 1, 4), shown(d)),
        ("G [nm]", with_error(found, "fractal_roughness{}_m", 1e9), shown(g * 1e9)),
        ("rms height [µm]", shown(surface.heights.std() * 1e6, 3), shown(specimen.rms_height * 1e6)),
    ]
    caption = (
        "Fig. 6, from a generated profile with the D and G of Table 2, a sum of cosines (2.1) with γ = 1.5 at 16000 points 0.5 µm apart: "
        "the measured one is not in the text. The longest wave is the one that gives the σ of Table 1. D and G are fitted to the second "
        "differences, S₂, which depend less on the ends of the sum of cosines than S does."
    )
    title = "Fig. 6: structure function, sand blasted (fine), generated profile"
    panel = Panel(axes, curves, ("window of the fit", *found["window_m"] * 1e6))
    return Picture("fig6", title, caption, [panel]), [["Fig. 6", specimen.name, *row] for row in generated]


def stiffness_figure(specimen: Specimen) -> tuple[Picture, dict[str, Numbers]]:
    """Fig. 7, 8 or 9, and the numbers for the conclusions."""

    def of_paper(**interaction: Any) -> dict[str, Numbers]:
        return {
            "fractal, θ = π/4": specimen.stiffness("fractal", **interaction),
            "fractal, θ = π/3": specimen.stiffness("fractal", "pi/3", **interaction),
            "statistical elastic, θ = π/4": specimen.stiffness("hertz", **interaction),
        }

    classic = specimen.stiffness("greenwood_williamson")
    alone = {**of_paper(), "Greenwood-Williamson": classic}
    plastic = {f"not in the paper: {law}": specimen.stiffness(law, **YIELDING) for law in ("plastic_peaks", "jackson_green")}
    layer: Any = {"interaction": "effective_separation", "interaction_length": math.sqrt(AREA)}
    interacting = {**of_paper(**layer), "Greenwood-Williamson (without)": classic}
    broad = {"lw": 5, "alpha": 0.4}  # under the curves that lie on them
    styles: Any = [("C0-", broad), ("C0--",), ("C1-", broad), ("C2-",), ("C3-",), ("C4-",)]
    axes = {"xlabel": "nominal pressure p [MPa]", "ylabel": "K/A₀ [GPa/µm]", "xscale": "log", "yscale": "log"}

    def panel(title: str, models: dict[str, Numbers]) -> Panel:
        curves = [Curve(label, PRESSURES / 1e6, k / 1e15, *style) for (label, k), style in zip(models.items(), styles)]
        return Panel({"title": title, **axes}, curves)

    with_layer = panel("With the interaction (4.11), L = √A₀, η_old effective", interacting)
    panels = [panel("The interface alone", {**alone, **plastic}), with_layer]
    title = f"Fig. {specimen.figure[-1]}: normal contact stiffness, {specimen.name}"
    caption = (
        f"{title}. {NO_POINTS} Two curves are not in the paper: their peaks yield (H = 2.8 Y, θ = π/4, r = 0), and K is that of "
        "unloading, which a wave measures."
    )
    return Picture(specimen.figure, title, caption, panels), quantities(specimen, *alone.values())


#: Quantities of the conclusions: the conclusion and the words.
QUANTITIES = {
    "fractal_over_elastic": (1, "K fractal over K statistical elastic, at equal pressure"),
    "fractal_over_greenwood_williamson": (1, "K fractal over K Greenwood-Williamson, at equal pressure"),
    "theta_at_equal_pressure": (2, "K(θ = π/3) over K(θ = π/4), at equal pressure"),
    "theta_at_equal_separation": (2, "K(θ = π/3) over K(θ = π/4), at equal separation, η from 0 to 3"),
    "interaction_shift": (3, "shift Δη of the separation (4.11), from 0.1 to 100 MPa"),
}


def quantities(specimen: Specimen, fractal: Numbers, third: Numbers, elastic: Numbers, classic: Numbers) -> dict[str, Numbers]:
    """The quantities at the pressures, or at the separations."""

    def of_separation(theta: str) -> Numbers:
        contact = lambda excess, t: np.sqrt(excess / t)
        return np.array([fstiff.peak_integral(contact, eta=eta, **exponential(theta)).value for eta in np.arange(25) / 8])

    return {
        "fractal_over_elastic": fractal / elastic,
        "fractal_over_greenwood_williamson": fractal / classic,
        "theta_at_equal_pressure": third / fractal,
        "theta_at_equal_separation": of_separation("pi/3") / of_separation("pi/4"),
        "interaction_shift": PRESSURES * math.sqrt(AREA) / (MODULUS * specimen.rms_height),
    }


def conclusions(found: list[dict[str, Numbers]]) -> Rows:
    """What the paper concludes, the result and its reason. Both follow from the numbers: a change of the model changes them."""

    def spread(key: str, digits: int = 3) -> str:
        return " to ".join(shown(end([end(one[key]) for one in found]), digits) for end in (min, max))

    same_factor = all(np.ptp(one["fractal_over_elastic"]) < 1e-9 for one in found)
    slight = max(max(one["theta_at_equal_pressure"]) for one in found) < 1.25
    shifts = [max(one["interaction_shift"]) for one in found]
    fine, coarse, discharge = (shown(shift) for shift in shifts)
    return [
        ["The fractal model is close to the experiment, the statistical elastic models are far below it.",
         "not testable: only that the models differ by a constant factor" if same_factor else "the factor is not constant",
         f"The two differ by (2/3)(3-D)/(2-D) at every pressure, {spread('fractal_over_elastic', 4)} with D alone; Greenwood-Williamson "
         f"lies lower by {spread('fractal_over_greenwood_williamson')}. The fractal model is closer because such a factor was missing. The "
         "experimental points are not in the text."],
        ["The stiffness is almost independent of θ.",
         "holds at equal pressure, not at equal separation" if slight else "does not hold",
         f"From π/4 to π/3 K rises by {spread('theta_at_equal_pressure')} at equal pressure, and by "
         f"{spread('theta_at_equal_separation')} at equal separation."],
        ["The interaction matters for rough surfaces at high load, and hardly at low load.",
         "half: it grows with the load, but is largest on the smoothest surface" if shifts == sorted(shifts, reverse=True)
         else "holds for these surfaces",
         f"The shift of η at 100 MPa is {fine} (fine), {coarse} (coarse), {discharge} (electrical discharge): it is in proportion to the "
         "pressure and to 1/σ. The discussion states this, the conclusion the opposite."],
    ]  # fmt: skip


def shown(value: float, digits: int = 4) -> str:
    """The number for people: 570, not 5.7e+02."""
    return f"{float(f'{value:.{digits}g}'):g}"


def with_error(found: Any, key: str, factor: float, digits: int = 3) -> str:
    """The number and its standard error, whose key has "_error" in it."""
    return f"{shown(found[key.format('')] * factor, digits)} ± {shown(found[key.format('_error')] * factor, 2)}"


def thinned(columns: Any) -> dict[str, Numbers]:
    """Nine points a decade."""
    chosen = [0]
    for i, lag in enumerate(columns["lag_m"]):
        if lag >= 1.3 * columns["lag_m"][chosen[-1]]:
            chosen.append(i)
    return {key: column[chosen] for key, column in columns.items()}


def text_table(rows: Rows) -> str:
    """Columns of text, the first at the left."""
    widths = [max(map(len, column)) for column in zip(*rows)]
    cells = [[cell.rjust(width) if i else cell.ljust(width) for i, (cell, width) in enumerate(zip(row, widths))] for row in rows]
    return "\n".join(f"  {'  '.join(row)}".rstrip() for row in cells)


def reproduce() -> tuple[list[Picture], dict[str, str]]:
    """The figures, which are computed in some seconds, and the sections of text by their titles."""
    islands_of_maps, of_maps = figure_4()
    structure_function, of_profile = figure_6()
    stiffness, found = zip(*(stiffness_figure(specimen) for specimen in SPECIMENS))
    table = [[one.name, *map(shown, np.multiply(one[2:], (1e6, 1e6, 1e-6, 1e6, 1, 1e9)))] for one in SPECIMENS]
    spans = [
        [str(number), specimen.name, words, shown(min(values[key])), shown(max(values[key]))]
        for key, (number, words) in QUANTITIES.items()
        for specimen, values in zip(SPECIMENS, found)
    ]
    sections = {
        f"fstiff {fstiff.__version__}: the paper reproduced": f"{PAPER}\n{NO_POINTS}\n{REMARK}",
        **{f"Conclusion {i}": "{}\n  result: {}\n  {}".format(*words) for i, words in enumerate(conclusions(found), 1)},
        "Numbers for the conclusions": text_table([["conclusion", "surface", "quantity", "least", "greatest"], *spans]),
        "Tables 1 and 2": text_table([["surface", "σ [µm]", "R [µm]", "D_p [1/mm²]", "R_p [µm]", "D", "G [nm]"], *table])
        + "\nE₁ = E₂ = 205 GPa, ν = 0.3, Y = 400 MPa, A₀ = 195 mm²",
        "Generated surfaces": text_table([["figure", "surface", "quantity", "generated", "paper"], *of_maps, *of_profile]),
        "Errata (in full in docs/errata.md)": "\n".join(re.findall("^### (.*)", ERRATA.read_text("utf-8"), re.MULTILINE)),
    }
    return [figure_2(), islands_of_maps, structure_function, *stiffness], sections


def draw(picture: Picture, file: Path) -> None:
    """The picture as SVG, a panel below the other."""
    figure = Figure(figsize=(6.4, 4.2 * len(picture.panels)), layout="constrained")
    figure.suptitle(picture.title, weight="bold")
    for axes, panel in zip(figure.subplots(len(picture.panels), squeeze=False)[:, 0], picture.panels):
        for curve in panel.curves:
            axes.plot(curve.x, curve.y, curve.style, label=curve.label, **curve.others)
        if panel.window:
            axes.axvspan(*panel.window[1:], color="grey", alpha=0.2, lw=0, zorder=0, label=panel.window[0])
        axes.set(**panel.axes)
        axes.grid(True)
        axes.legend(fontsize="small")
    with matplotlib.rc_context({"svg.hashsalt": picture.name, "svg.fonttype": "none"}):  # the same file each time
        figure.savefig(file, metadata={"Date": None})


def write_numbers(picture: Picture, file: Path) -> None:
    """The points of the curves as CSV."""
    rows: list[Any] = [["panel", "label", "x_quantity", "x", "y_quantity", "y"]]
    for place, (axes, curves, _) in enumerate(picture.panels, 1):
        for curve in curves:
            rows += [[place, curve.label, axes["xlabel"], x, axes["ylabel"], y] for x, y in zip(curve.x.tolist(), curve.y.tolist())]
    with file.open("w", encoding="utf-8", newline="") as opened:
        csv.writer(opened, lineterminator="\n").writerows(rows)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", metavar="FOLDER", type=Path, help="of the figures and index.html, which are replaced")
    folder = parser.parse_args().folder
    folder.mkdir(parents=True, exist_ok=True)
    pictures, sections = reproduce()
    page = PAGE + "".join(f"<h2>{title}</h2>\n<pre>{escape(text)}</pre>\n" for title, text in sections.items())
    for one in pictures:
        draw(one, folder / f"{one.name}.svg")
        write_numbers(one, folder / f"{one.name}.csv")
        page += f'<figure><img src="{one.name}.svg" alt="{one.title}"><figcaption>{one.caption}</figcaption></figure>\n'
    (folder / "index.html").write_text(page, "utf-8")
    sections["Files"] = "\n".join(str(folder / name) for name in ("fig*.svg", "fig*.csv", "index.html"))
    print("\n\n".join(f"{title}\n{text}" for title, text in sections.items()))


if __name__ == "__main__":
    main()
