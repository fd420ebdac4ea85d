# SPDX-License-Identifier: BSD-3-Clause
"""examples/paper/reproduce.py: the figures of the paper against tables of other origin, its conclusions, and the folder of files."""

import ast
import csv
import html
import importlib.util
import math
import subprocess
import sys

import numpy as np
import pytest

pytest.importorskip("matplotlib")

FIGURES = ("fig2", "fig4", "fig6", "fig7", "fig8", "fig9")
KEYS = ("sand_blasted_fine", "sand_blasted_coarse", "electrical_discharge")


@pytest.fixture(scope="module")
def program(root):
    return root / "examples" / "paper" / "reproduce.py"


@pytest.fixture(scope="module")
def example(program):
    """The program as a module."""
    spec = importlib.util.spec_from_file_location("reproduce", program)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def paper(program, tmp_path_factory):
    folder = tmp_path_factory.mktemp("paper") / "made" / "here"
    done = subprocess.run([sys.executable, program, folder], capture_output=True, text=True, encoding="utf-8")
    assert done.returncode == 0, done.stderr
    return folder, done.stdout


def curves(file):
    """(panel, label) -> x and y."""
    found = {}
    for row in list(csv.reader(file.read_text("utf-8").splitlines()))[1:]:
        found.setdefault((int(row[0]), row[1]), []).append((float(row[3]), float(row[5])))
    return {key: np.array(points).T for key, points in found.items()}


def table(root, name):
    with open(root / "tests" / "data" / name) as file:
        return list(csv.DictReader(file))


def test_every_figure_is_a_picture_and_its_numbers_and_a_page_has_them_all(paper, root):
    folder, text = paper
    page = (folder / "index.html").read_text("utf-8")
    for figure in FIGURES:
        assert "<path" in (folder / f"{figure}.svg").read_text("utf-8")
        assert f'src="{figure}.svg"' in page
    errata = (root / "docs" / "errata.md").read_text("utf-8")
    for line in errata.splitlines():
        assert not line.startswith("### ") or line[4:] in text and html.escape(line[4:]) in page
    assert text.count("  result: ") == 3 and "Experimental points are not drawn" in text and "Experimental points are not drawn" in page
    assert text.endswith("index.html\n") and len(list(folder.iterdir())) == 2 * len(FIGURES) + 1


def test_it_takes_public_names_of_the_package_alone(program):
    tree = ast.parse(program.read_text("utf-8"))
    imported = {one.name for node in ast.walk(tree) if isinstance(node, ast.Import) for one in node.names}
    assert "fstiff" in imported and not [node for node in ast.walk(tree) if isinstance(node, ast.ImportFrom) and "fstiff" in node.module]
    taken = {node.attr for node in ast.walk(tree) if isinstance(node, ast.Attribute)} - {"__version__"}
    assert not [name for name in taken if name.startswith("_")]


@pytest.mark.parametrize("figure, key", list(zip(FIGURES[3:], KEYS)))
def test_the_curves_of_figs_7_to_9_are_those_of_the_tables(figure, key, paper, root):
    drawn = curves(paper[0] / f"{figure}.csv")

    def k(label, pressure, panel=1):
        """K [Pa/m] at `pressure` [Pa]."""
        (y,) = drawn[panel, label][1][np.isclose(drawn[panel, label][0], pressure / 1e6, rtol=1e-9)]
        return y * 1e15

    labels = {"0.0": "π/4", "0.816496580927726": "π/3"}  # by r of an exponential autocorrelation
    rows = [row for row in table(root, "table1_curves.csv") if row["surface"] == key and row["r"] in labels]
    rows = [row for row in rows if float(row["pressure_Pa"]) in 10.0 ** np.arange(5, 9)]
    assert len(rows) == 8
    for row in rows:
        p, theta = float(row["pressure_Pa"]), labels[row["r"]]
        assert k(f"fractal, θ = {theta}", p) == pytest.approx(float(row["stiffness_fractal_Pa_per_m"]), rel=1e-10)  # of 11 digits
        if theta == "π/4":
            elastic = k("statistical elastic, θ = π/4", p)
            assert elastic == pytest.approx(float(row["stiffness_hertz_Pa_per_m"]), rel=1e-10)
            # (4.11) adds the compliance of a layer to that of an elastic contact
            layer = np.sqrt(195e-6) / (205e9 / (2 * (1 - 0.3**2)))
            assert 1 / k("statistical elastic, θ = π/4", p, panel=2) == pytest.approx(1 / elastic + layer, rel=1e-9)
    laws = {"plastic": "plastic_peaks", "jackson_green": "jackson_green"}
    rows = [row for row in table(root, "plastic_curves.csv") if row["surface"].startswith(key) and row["law"] in laws]
    rows = [row for row in rows if row["r"] == "0" and float(row["pressure_Pa"]) in 10.0 ** np.arange(5, 9)]
    assert len(rows) == 8
    for row in rows:
        found = k(f"not in the paper: {laws[row['law']]}", float(row["pressure_Pa"]))
        assert found == pytest.approx(float(row["unloading_stiffness_Pa_per_m"]), rel=1e-8)  # of 9 digits


def test_figs_2_4_and_6_show_what_they_were_made_of(paper, example):
    folder, _ = paper
    t, weights = (x[:, None] for x in np.polynomial.legendre.leggauss(80))
    t, weights, theta = 6 * t + 6, 6 * weights, np.pi / 3  # to t = 12
    for label, r in (("r = 1/2", 1 / 2), ("r = 1/3", 1 / 3), ("r = 1/5", 1 / 5)):
        z, density = curves(folder / "fig2.csv")[1, label]
        peaks = np.vectorize(math.erf)(t * np.tan(theta) / np.sqrt(2)) / (2 * theta * np.sqrt(1 - r * r))  # of (4.4)
        expected = np.sum(weights * peaks * np.exp(-((z - r * t) ** 2) / (2 * (1 - r * r)) - t * t / 2), axis=0)
        assert density == pytest.approx(expected, abs=1e-10)
    four = curves(folder / "fig4.csv")
    for specimen in example.SPECIMENS:  # the density of Table 1 is put in, where the waves are those of a Gaussian surface
        share, density = four[1, specimen.name]
        assert 1 < density.max() / (specimen.peak_density * 1e-6) < 1.3 and 15 < share[density.argmax()] < 30
    six = curves(folder / "fig6.csv")
    for points, line in (("S of the profile, eq. (2.8)", "S of the cosines that were summed"),
                         ("S₂ of its second differences", "what is fitted to S₂, with D and G")):  # fmt: skip
        at = dict(zip(*six[1, line]))
        both = [y / at[x] for x, y in zip(*six[1, points]) if x in at and x < 30]
        assert len(both) > 5 and np.abs(np.array(both) - 1).max() < 0.1


def test_the_numbers_for_the_conclusions_are_the_known_ones(example):
    found = [example.stiffness_figure(specimen)[1] for specimen in example.SPECIMENS]
    known = {  # of mpmath, rounded as here: the tolerance is half a unit of the last digit
        "fractal_over_greenwood_williamson": ((2.47, 2.58), (2.29, 2.35), (2.93, 3.00)),
        "theta_at_equal_pressure": ((1.06, 1.18), (1.05, 1.14), (1.05, 1.14)),
        "theta_at_equal_separation": ((1.68, 2.14), (1.68, 2.14), (1.68, 2.14)),
    }
    for i, (specimen, values) in enumerate(zip(example.SPECIMENS, found)):
        for key, spans in known.items():
            assert (min(values[key]), max(values[key])) == pytest.approx(spans[i], abs=0.0051), key
        d = specimen.fractal_dimension
        assert values["fractal_over_elastic"] == pytest.approx(2 / 3 * (3 - d) / (2 - d), rel=1e-12)
        shift = 1e8 * np.sqrt(195e-6) / (205e9 / (2 * (1 - 0.3**2)) * specimen.rms_height)
        assert max(values["interaction_shift"]) == pytest.approx(shift, rel=1e-12)
    assert [result for _, result, _ in example.conclusions(found)] == [
        "not testable: only that the models differ by a constant factor",
        "holds at equal pressure, not at equal separation",
        "half: it grows with the load, but is largest on the smoothest surface",
    ]
    rising = dict.fromkeys(("fractal_over_elastic", "theta_at_equal_pressure"), np.array([1.2, 1.3]))
    results = [result for _, result, _ in example.conclusions([{**values, **rising} for values in found[::-1]])]
    assert results == ["the factor is not constant", "does not hold", "holds for these surfaces"]
