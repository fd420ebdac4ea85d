# SPDX-License-Identifier: BSD-3-Clause
"""The report of a scene, and pictures without matplotlib."""

import html
import re
import subprocess
import sys

import fstiff
import numpy as np
import pytest

matplotlib = pytest.importorskip("matplotlib")


def text_of(page):
    return " ".join(html.unescape(re.sub(r"<style>.*?</style>|<[^>]+>", " ", page, flags=re.S)).split())


def report(*words, cwd=None):
    return subprocess.run([sys.executable, "-m", "fstiff", "report", *map(str, words)], capture_output=True, text=True, cwd=cwd)


def test_the_answer_is_first_and_every_number_is_there(root):
    curves = fstiff.run(root / "data" / "bolted_joint.toml")
    page = fstiff.report(root / "data" / "bolted_joint.toml")
    text = text_of(page)
    for row in curves._found["answer_table"]:  # the table of the command
        assert " ".join(" ".join(row).split()) in text
    order = ["K/A0 [MPa/µm]", "Result: no warnings", *curves.explanation, "Under the same pressures", "Inputs", "Validity", "Numbers"]
    places = [text.index(part) for part in order]
    assert places == sorted(places)
    assert page.count("<svg") == 4 and "currentColor" in page and "prefers-color-scheme:dark" in page
    assert "<script" not in page and "src=" not in page and not re.search(r'href="(?!#)', page)
    assert page == fstiff.report(fstiff.Scene(root / "data" / "bolted_joint.toml"))  # the same page twice


def test_no_character_of_a_page_moves_a_cursor_or_turns_the_text(tmp_path):
    scene = tmp_path / "scene.toml"
    scene.write_text('name = "a\\u001bb\\u202ec\\u2028d"\n[surface]\nRq = "0.8 um"\n[contact]\npressures = ["1 MPa"]\n')
    page = fstiff.report(scene)
    assert not re.search("[\x00-\x08\x0b-\x1f\x7f-\x9f\u200e\u200f\u2028-\u202e\u2066-\u2069]", page)
    assert "a b c d" in page


def test_a_measured_surface_is_shown_with_its_scales(rough_map, trace, tmp_path):
    np.save(tmp_path / "map.npy", rough_map)
    scene = tmp_path / "scene.toml"
    scene.write_text('[surface]\nfrom = "map.npy"\ndx = "1 um"\ndy = "1.5 um"\nunits = "m"\n[material]\nupper = "steel"\n'
                     '[contact]\npressures = ["1 MPa", "30 MPa"]\n')  # fmt: skip
    text = text_of(fstiff.report(scene))
    for part in ("Measured surface", "Heights without the form", "Bearing curve",
                 "Density of islands", "Influence of the cut-offs", "Filtered with other lambda_s"):  # fmt: skip
        assert part in text
    assert "Structure function of second differences" in text_of(fstiff.report(surface=fstiff.measure(trace, spacing=5e-7)))
    measured = fstiff.measure(rough_map, dx=1e-6, dy=1.5e-6)
    rows = measured.scales(pressure=30e6)["scales"]["rows"]
    assert len(rows) >= 3 and all(row["stiffness_Pa_per_m"] > 0 for row in rows if not row["refusal"])
    assert measured.scales().plot(of="lambda_c").get_xlabel() == "lambda_c [µm]"


def test_the_command_writes_its_own_pages_alone(tmp_path):
    page, scene = tmp_path / "page.html", tmp_path / "scene.toml"
    scene.write_text('[surface]\nRq = "0.8 um"\n[contact]\npressures = ["1 MPa"]\n')
    for _ in range(2):
        done = report(scene, "-o", page)
        assert done.returncode == 0 and "page.html" in done.stdout, done.stderr
    assert page.read_text().endswith("</html>\n")
    page.write_text("<!doctype html>\nmine")
    for words, sentence in (
        ((tmp_path / "none.toml", "-o", page), "was not made by fstiff"),  # before the scene is read
        (("-o", tmp_path / "page.pdf"), "must end in .html"),
        ((tmp_path / "none.toml", "-o", tmp_path / "new.html"), "none.toml: no such file"),
    ):
        done = report(*words)
        assert done.returncode == 3 and sentence in done.stderr and done.stderr.count("\n") == 1
    assert page.read_text() == "<!doctype html>\nmine" and not (tmp_path / "new.html").exists()
    assert report("--nonsense").returncode == 2


def test_without_matplotlib_the_extra_is_named(root, tmp_path):
    program = "import sys; sys.modules['matplotlib'] = None; import fstiff.__main__ as m; sys.exit(m.main(sys.argv[1:]))"
    words = [sys.executable, "-c", program, "report", root / "data" / "built_in.toml", "-o", tmp_path / "page.html"]
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True)
    assert done.returncode == 3 and done.stderr == "fstiff: pictures need matplotlib: pip install 'fstiff[plot]'\n"


def test_everything_draws_itself(rough_map, trace):
    measured = fstiff.measure(trace, spacing="0.5 um")
    contact = fstiff.Contact("hybrid", surface=measured, effective_modulus=112.6e9)
    curve = {"pressure": np.array([1e6, 1e7, 1e8]), "stiffness": contact.at_pressures([1e6, 1e7, 1e8]).stiffness}
    fitted = fstiff.identify({"surface": {"rms_height": "1 um", "rms_gradient": 0.1}, "material": {"upper": "steel"},
                              "contact": {"pressures": ["1 MPa"]}}, curve, ["sigma"], law="hybrid")  # fmt: skip
    things = [contact, contact.tabulate(1e5, 1e8), measured, fitted, fstiff.Surface(rough_map, 1e-6), fstiff.spectrum(trace, spacing=1e-6)]
    things += [fstiff.answer(rms_height="0.8 um", rms_gradient=0.1, pressures=[1e6, 1e7]), fstiff.fit(trace, spacing=1e-6)]
    for thing in things:
        ax = thing.plot()
        assert ax.get_xlabel() and ax.get_ylabel() and (ax.get_lines() or ax.images)
        assert thing._repr_html_().startswith("<p>")
    ax = fstiff.Surface(1e-8 * np.sin(np.arange(50)), 1e-4).plot()
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("x [mm]", "height [nm]")


def test_what_cannot_be_drawn_is_refused(trace):
    measured = fstiff.measure(trace, spacing="0.5 um")
    pooled = fstiff.measure([trace, trace * 1.01], spacing="0.5 um")
    contact = fstiff.Contact("hybrid", surface=measured, effective_modulus=112.6e9)
    for call, sentence in (
        (lambda: fstiff.run().plot("nonsense"), "nonsense: is not a column here, which are law"),
        (lambda: contact.at_pressures([1e6]).plot("nonsense"), "nonsense: is not a column here"),
        (lambda: contact.plot([0, 1e6]), "pressures: must be greater than 0"),
        (lambda: measured.scales(pressure=-1), "pressure = -1: must be"),
        (pooled.plot, "several surfaces were pooled"),
        (pooled.scales, "must be measured from one file or array"),
    ):
        with pytest.raises(ValueError, match=sentence):
            call()
