# SPDX-License-Identifier: BSD-3-Clause
"""Spectra, peaks, generated surfaces, ultrasound, identification and export: of a file what the command prints, and of arrays the same."""

import json

import numpy as np
import pytest

import fstiff
from test_surfaces import OF_MAP, OF_TRACE, MAP, TRACE, plain, save

STEEL = ("--frequency", "7 MHz", "--impedance", "46 MRayl")


def assert_same(found, document, but=()):
    assert list(found) == list(document)
    for key in document:
        if key not in but:
            assert plain(found[key]) == document[key], key


@pytest.mark.parametrize("of, taper", [("psd", "hann"), ("psd", "none"), ("acf", "hann")])
def test_spectra_are_those_of_the_command(command, trace, rough_map, tmp_path, of, taper):
    for name, heights, units, given, spacing in (
        ("trace", trace, TRACE, OF_TRACE, 0.5e-6),
        ("map", rough_map, MAP, OF_MAP, (1e-6, 1.5e-6)),
    ):
        file = save(tmp_path / f"{name}.npy", heights)
        document = command.json("measure", "--show", "spectrum", file, *units, "--of", of, "--taper", taper)
        assert_same(fstiff.spectrum(file, of=of, taper=taper, **given), document, but=["inputs"])
        found = fstiff.spectrum(heights, spacing=spacing, of=of, taper=taper)
        assert_same(found, document, but=["inputs", "source"])
        assert found.of == of and of in repr(found)


def test_the_power_of_a_spectrum_is_the_mean_square_height(trace):
    found = fstiff.spectrum(trace, spacing=0.5e-6, taper="none", lambda_s="none", lambda_c="none")
    q, power = found["psd"]["wavenumber_rad_per_m"], found["psd"]["psd_m3"]
    heights = trace - np.polyval(np.polyfit(np.arange(trace.size), trace, 1), np.arange(trace.size))
    mean_square = (np.sum(power) - power[-1] / 2) * (q[1] - q[0])  # the wave at two samples is its own mirror image
    assert mean_square == pytest.approx(np.mean(heights**2), rel=1e-11)


def test_generated_heights_are_those_of_the_file_of_the_command(command, tmp_path):
    for kind, arguments, options in (
        ("profile", ["--hurst", "0.5", "--rms", "1 um", "--points", "64"], {"hurst": 0.5, "rms": 1e-6, "points": 64}),
        ("map", ["--hurst", "0.8", "--rms", "1 um", "--points", "16", "--rows", "24", "--seed", "7"],
         {"hurst": 0.8, "rms": "1 um", "points": 16, "rows": 24, "seed": 7}),
        ("wm", ["--dimension", "1.4", "--roughness", "12 nm", "--points", "64"],
         {"dimension": 1.4, "roughness": 12e-9, "points": 64}),
    ):  # fmt: skip
        file = tmp_path / f"{kind}.csv"
        file.write_text(command("generate", kind, "--spacing", "0.5 um", *arguments))
        made = fstiff.generate(kind, 0.5e-6, **options)
        read = fstiff.open_surface(file)
        assert (made.heights == read.heights).all() and made.heights.shape == read.heights.shape
        assert made.spacing == pytest.approx(read.spacing, rel=1e-15)
        assert f"# {made.decisions[0]}" == file.read_text().splitlines()[0]
    for wrong in ({"rms": 1e-6}, {"hurst": 0.5, "rms": 1e-6, "points": 3}, {"hurst": 0.5, "rms": 1e-6, "dimension": 1.5}):
        with pytest.raises(ValueError, match="needs hurst|points = 3|dimension is not for"):
            fstiff.generate("profile", 1e-6, **wrong)


def test_ultrasound_is_that_of_the_command(command, root):
    document = command.json("ultrasound", "--stiffness", "1.764 GPa/um", *STEEL)
    found = fstiff.ultrasound(stiffness=1.764e15, frequency=7e6, impedance="46 MRayl")
    assert_same(found, document)
    back = fstiff.ultrasound(reflection=found["reflection"], frequency="7 MHz", impedance=46e6, reflection_error=0.005)
    assert back["stiffness_Pa_per_m"] == pytest.approx(1.764e15, rel=1e-13)
    wet = fstiff.ultrasound(reflection=found["reflection"], film_stiffness="1 GPa/um", frequency=7e6, impedance=46e6)
    assert wet["stiffness_Pa_per_m"] == pytest.approx(0.764e15, rel=1e-13)
    file = root / "data/example_reflection.csv"
    document = command.json("ultrasound", "--reflection", file, *STEEL)
    of_file = fstiff.ultrasound(reflection=file, frequency=7e6, impedance=46e6)
    assert_same(of_file, document)
    assert json.loads(of_file.to_json()) == document
    rows = document["rows"]
    columns = {key: [row[name] for row in rows] for key, name in
               (("pressure", "pressure_Pa"), ("reflection", "reflection"), ("error", "reflection_error"))}  # fmt: skip
    of_arrays = fstiff.ultrasound(reflection=columns, frequency=7e6, impedance=46e6)
    assert of_arrays["rows"] == rows and len(of_arrays["file"]["sha256"]) == 64
    of_material = fstiff.ultrasound(stiffness=1e15, frequency=7e6, material="steel", material2="aluminium")
    assert of_material["impedance_Rayl"] == 7850 * 5960
    assert of_material["impedance2_Rayl"] == 2700 * 6420
    table = root / "data/example_reflections.csv"
    of_loads = fstiff.ultrasound(reflection=table, material="steel")
    assert json.loads(of_loads.to_json()) == command.json("ultrasound", "--reflection", table, "--material", "steel")
    rows = of_loads["rows"]
    several = {
        key: [row[name] for row in rows]
        for key, name in (("pressure", "pressure_Pa"), ("frequency", "frequency_Hz"), ("reflection", "reflection"), ("error", "reflection_error"))
    }
    assert fstiff.ultrasound(reflection=several, material="steel")["loads"] == of_loads["loads"]
    spectrum = {key: several[key][:3] for key in ("frequency", "reflection")}
    assert fstiff.ultrasound(reflection=spectrum, material="steel")["loads"][0]["frequencies"] == 3
    with pytest.raises(ValueError, match="must have the columns pressure"):
        fstiff.ultrasound(reflection={"frequency": [1e6], "stiffness": [1e15]}, material="steel")
    with pytest.raises(ValueError, match="give one of stiffness and reflection"):
        fstiff.ultrasound(frequency=7e6, impedance=46e6)
    with pytest.raises(ValueError, match="frequency = -1"):
        fstiff.ultrasound(stiffness=1e15, frequency=-1, impedance=46e6)


def test_identification_is_that_of_the_command(command, root):
    scene, file = root / "data/sand_blasted_fine.toml", root / "data/example_stiffness.csv"
    document = command.json("identify", scene, "--measured", file, "--law", "plastic", "--fit", "sigma,offset")
    found = fstiff.identify(scene, file, ["sigma", "offset"], law="plastic")
    assert_same(found, document)
    points = document["fits"][0]["rows"]
    keys = {"pressure": "pressure_Pa", "stiffness": "stiffness_Pa_per_m", "error": "error"}
    columns = {key: [row[name] for row in points] for key, name in keys.items() if name in points[0]}
    of_arrays = fstiff.identify(fstiff.Scene(scene), columns, ["rms_height", "offset"], law="plastic")
    assert plain(of_arrays["fits"][0]["parameters"]) == document["fits"][0]["parameters"]
    assert "sigma" in repr(found)
    one_radius = fstiff.identify(scene, file, ["sigma"], law="greenwood_williamson")  # has no joint peaks
    assert_same(one_radius, command.json("identify", scene, "--measured", file, "--law", "greenwood_williamson", "--fit", "sigma"))
    assert one_radius.to_dataframe()["r"].isna().all()
    with pytest.raises(ValueError, match='"theta2" is not a parameter'):
        fstiff.identify(scene, file, ["theta2"])
    with pytest.raises(ValueError, match="must have the columns"):
        fstiff.identify(scene, {"pressure": [1e6]}, ["sigma"])


def test_an_export_is_the_file_of_the_command(command, root):
    scene = root / "data/sand_blasted_fine.toml"
    for to in ("calculix", "abaqus", "moose", "comsol", "law"):
        text = command("export", scene, "--to", to, "--from", "1 MPa", "--until", "50 MPa", "--tolerance", "0.05")
        made = fstiff.export(scene, to, pressures=(1e6, "50 MPa"), tolerance=0.05)
        assert made == text
    assert fstiff.Law.from_text(made).stiffness(1e7) > 0
    for quantile, end in ((0.05, "5%"), (None, "50%"), ("95%", "0.95")):
        text = command("export", scene, "--to", "calculix", "--law", "answer", "--quantile", end)
        assert fstiff.export(scene, law="answer", quantile=quantile) == text
    with pytest.raises(ValueError, match="^quantile: is for law answer"):
        fstiff.export(scene, quantile=0.05)
    with pytest.raises(ValueError, match="must be consistent"):
        fstiff.export(scene, units="mm,N,Pa")
