# SPDX-License-Identifier: BSD-3-Clause
"""sweep() has the rows of `fstiff sweep`, to the last digit."""

import json
import re
import subprocess
import sys

import numpy as np
import pytest

import fstiff

pytest.importorskip("pandas")

SCENE = {
    "surface": {"rms_height": "0.8 um", "peak_radius": "40 um", "peak_density": "500 /mm^2", "fractal_dimension": 1.62},
    "material": {"upper": {"youngs_modulus": "205 GPa", "poisson_ratio": 0.3}},
    "contact": {"laws": ["hertz", "fractal"], "peaks": [{"theta": 1.0, "r": 0.5}], "pressures": ["10 MPa"]},
}
TEXT = """
[surface]
rms_height = %s
peak_radius = "40 um"
peak_density = "500 /mm^2"
fractal_dimension = %s
[material.upper]
youngs_modulus = "205 GPa"
poisson_ratio = 0.3
[contact]
laws = ["hertz", "fractal"]
peaks = [ { theta = 1.0, r = 0.5 } ]
pressures = [ %s ]
"""


def lines(command, folder, text):
    """The lines of results of a grid."""
    (folder / "grid.toml").write_text(text)
    command("sweep", folder / "grid.toml", "-o", folder / "k.jsonl")
    return [json.loads(line) for line in (folder / "k.jsonl").read_text().splitlines()]


def same(rows, wanted):
    """Whether every value is that of the lines, and what a line lacks is NaN or None."""
    assert len(rows) == len(wanted) > 0
    assert [key for key in rows if key != "error"] == [key for key in max(wanted, key=len) if key != "error"]
    for row, line in zip(rows.to_dict("records"), wanted):
        for key, value in row.items():
            if key == "error" and key in line:
                assert value == re.sub(r"^.*grid\.toml: ", "scene: ", line[key])
            elif line.get(key) is None:
                assert value is None or value != value, key
            else:
                assert value == line[key], key


def test_arrays_and_texts_give_the_rows_of_the_command(command, tmp_path):
    text = TEXT % ('["0.5 um", "1 um"]', "[1.3, 1.995, 1.62]", '{ from = "1 MPa", to = "100 MPa", count = 5 }')
    axes = {
        "surface.rms_height": np.array([0.5e-6, 1e-6]),
        "surface.fractal_dimension": (1.3, 1.995, 1.62),  # the second one has no results
        "contact.pressures[0]": {"from": 1e6, "to": 1e8, "count": 5},
    }
    wanted = lines(command, tmp_path, text.replace("1.995, 1.62]", "1.5, 1.62]"))
    same(fstiff.sweep(SCENE, {**axes, "surface.fractal_dimension": [1.3, 1.5, 1.62]}), wanted)
    same(fstiff.sweep(SCENE, {**axes, "surface.fractal_dimension": [1.3, 1.5, 1.62]}, threads=1), wanted)
    part = fstiff.sweep(tmp_path / "grid.toml", {}, rows=(7, 19), threads=1)
    same(part, [line for line in wanted if 7 <= line["index"] < 19])
    texts = {"surface.rms_height": ["0.5 um", "1 um"], "contact.pressures[0]": ["1 MPa", "1e20 MPa"]}
    wanted = lines(command, tmp_path, TEXT % ('["0.5 um", "1 um"]', 1.62, '{ values = ["1 MPa", "1e20 MPa"] }'))
    rows = fstiff.sweep(TEXT % ('"1 um"', 1.62, '"1 MPa"'), texts)
    assert rows["error"].notna().sum() == 2
    same(rows, wanted)
    same(fstiff.sweep(fstiff.Scene(SCENE), texts), wanted)


def test_words_draws_and_a_grid_in_a_file_are_swept(command, tmp_path):
    words = 'laws = [ { values = ["hertz", "fractal"] } ]'
    text = TEXT % ('{ normal = ["0.8 um", "0.05 um"] }', 1.62, '"1 MPa", "3 MPa"') + "[sweep]\nsamples = 4\nseed = 5\n"
    wanted = lines(command, tmp_path, text.replace('laws = ["hertz", "fractal"]', words))
    axes = {"contact.laws": {"values": [["hertz"], ["fractal"]]}}
    draws = {"surface.rms_height": {"normal": [0.8e-6, 0.05e-6]}, "contact.laws[0]": ["hertz", "fractal"]}
    scene = {**SCENE, "contact": {**SCENE["contact"], "laws": ["hertz"], "pressures": ["1 MPa", "3 MPa"]}}
    same(fstiff.sweep(scene, draws, samples=4, seed=5), wanted)
    (tmp_path / "file.toml").write_text(text)
    rows = fstiff.sweep(tmp_path / "file.toml", axes)
    assert list(rows["stiffness_Pa_per_m"]) == [line["stiffness_Pa_per_m"] for line in wanted]
    assert rows["contact.laws"].unique().tolist() == ["[hertz]", "[fractal]"]


def test_a_scene_without_a_law_has_its_answer_and_many_values_may_be_zipped(command, tmp_path):
    scene = {"material": {"upper": "steel"}, "surface": {"rms_height": "0.5 um", "rms_gradient": 0.1},
             "contact": {"pressures": ["1 MPa"]}}  # fmt: skip
    heights, pressures = np.geomspace(0.2e-6, 1e-6, 3), np.geomspace(1e6, 3e7, 3)
    rows = fstiff.sweep(scene, {"surface.rms_height": heights, "contact.pressures[0]": pressures}, mode="zip")
    for height, pressure, found in zip(heights.tolist(), pressures.tolist(), rows.to_dict("records")):
        one = fstiff.run({**scene, "surface": {"rms_height": f"{height!r} m", "rms_gradient": 0.1},
                          "contact": {"pressures": [f"{pressure!r} Pa"]}})  # fmt: skip
        for key in ("stiffness_Pa_per_m", "stiffness_p05_Pa_per_m", "stiffness_p95_Pa_per_m"):
            assert found[key] == one[key][0]
        assert found["answer"] == 1 and found["law"] == one["law"][0]
    many = fstiff.sweep(SCENE, {"surface.rms_height": np.linspace(0.5e-6, 1e-6, 80000)})
    assert len(many) == 160000 and many["index"].iloc[-1] == 79999


def test_a_measured_surface_takes_the_place_of_the_section(trace):
    measured = fstiff.measure(trace, spacing=0.5e-6)
    scene = {"material": {"upper": "steel"}, "contact": {"laws": ["hertz"], "pressures": ["1 MPa"]}, "uncertainty": {"samples": 0}}
    rows = fstiff.sweep(scene, {"contact.pressures[0]": [1e6, 1e7]}, surface=measured)
    for pressure, stiffness in zip((1e6, 1e7), rows["stiffness_Pa_per_m"]):
        scene["contact"]["pressures"] = [f"{pressure} Pa"]
        curves = fstiff.run(scene, surface=measured)
        assert stiffness == curves["stiffness_Pa_per_m"][0]
    with pytest.raises(ValueError, match=r"^axes: must not hold keys of \[surface\]"):
        fstiff.sweep(scene, {"surface.r": [0.1]}, surface=measured)


@pytest.mark.parametrize(
    "axes, options, sentence",
    [
        ({"surface.rms_hight": [1e-6]}, {}, "scene: surface.rms_hight: unknown key (did you mean rms_height?); valid keys of surface are"),
        ({"surface.rms_height": [-1e-6]}, {}, "scene: surface.rms_height = -1e-06: must be finite and greater than 0"),
        ({"surface.rms_height": ["1 MPa"]}, {}, 'scene: surface.rms_height = "1 MPa'),
        ({"surface.rms_height": 1e-6}, {}, "surface.rms_height.values = 1e-06: must be a list of at least one value"),
        ({"surface.rms_height": []}, {}, "surface.rms_height.values = []: must be a list of at least one value"),
        ({"contact.pressures[3]": [1e6]}, {}, "scene: contact.pressures[3]: is no place of the scene"),
        ({"contact.laws.x": [1e6]}, {}, "scene: contact.laws.x: is no place of the scene"),
        ({"surface.rms_height": [1e-6]}, {"samples": 3}, "sweep.samples = 3: needs a distribution"),
        ({"surface.rms_height": [1e-6]}, {"mode": "all"}, 'sweep.mode = "all": must be one of "product", "zip"'),
        ({"surface.rms_height": [1e-6]}, {"threads": 0}, "threads = 0: must be 1 or greater"),
        ({"surface.rms_height": [1e-6]}, {"rows": (0, 2)}, "rows = (0, 2): must be (FROM, TO), whole numbers with 0 <= FROM < TO <= 1, the"),
        ({"surface.rms_height": [1e-6]}, {"rows": (1, 1)}, "rows = (1, 1): must be (FROM, TO), whole numbers with 0 <= FROM < TO <= 1, the"),
        ({"surface.rms_height": [1e-6]}, {"rows": (-1, 1)}, "rows[0] = -1: must be 0 or greater"),
        ({"surface.rms_height": [1e-6]}, {"rows": 5}, "rows = 5: must be (FROM, TO), two whole numbers"),
        ({"surface.rms_height": [1e-6]}, {"rows": "0:1"}, "rows = '0:1': must be (FROM, TO), two whole numbers"),
    ],
)
def test_what_is_wrong_is_one_sentence(axes, options, sentence):
    with pytest.raises(ValueError) as caught:
        fstiff.sweep(SCENE, axes, **options)
    assert sentence in str(caught.value) and "\n" not in str(caught.value)


@pytest.mark.skipif(sys.platform == "win32", reason="no signals")
def test_ctrl_c_ends_a_sweep():
    program = (
        "import signal, threading, os, fstiff\n"
        "threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()\n"
        "try:\n"
        "    fstiff.sweep(None, {'surface.rms_height': {'from': 1e-7, 'to': 1e-6, 'count': 100_000_000}})\n"
        "except KeyboardInterrupt:\n"
        "    print('ended')\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.stdout == "ended\n", done.stderr
