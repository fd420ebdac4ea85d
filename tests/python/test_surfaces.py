# SPDX-License-Identifier: BSD-3-Clause
"""Measured surfaces: arrays, files and topographies give the JSON of the command, and the numbers of C++."""

import concurrent.futures
import copy
import importlib.util
import multiprocessing
import os
import pathlib
import pickle
import subprocess
import sys
import warnings

import numpy as np
import pytest

import fstiff


def plain(value):
    """A document as JSON has it."""
    if isinstance(value, dict):
        return {key: plain(one) for key, one in value.items()}
    if isinstance(value, list):
        return [plain(one) for one in value]
    return value.tolist() if isinstance(value, np.ndarray) else value


def save(path, heights):
    np.save(path, heights)
    return path


MAP = ("--units", "m", "--dx", "1 um", "--dy", "1.5 um")
TRACE = ("--units", "m", "--spacing", "0.5 um")
OF_MAP = {"units": "m", "dx": 1e-6, "dy": "1.5 um"}
OF_TRACE = {"units": "m", "spacing": 0.5e-6}


@pytest.mark.parametrize(
    "what, arguments, options",
    [
        ("measure", [], {}),
        ("measure", ["--peaks", "summits", "--lambda-s", "4 um", "--detrend", "quadratic", "--resamples", "40"],
         {"peaks": "summits", "lambda_s": 4e-6, "detrend": "quadratic", "resamples": 40}),
        ("measure", ["--crop", "0,60 um,0,60 um", "--spikes", "9", "--fill", "--seed", "3"],
         {"crop": "0,60 um,0,60 um", "spikes": 9, "fill": True, "seed": 3}),
        ("fit", ["--window", "2 um,20 um", "--lambda-s", "none"], {"window": (2e-6, 20e-6), "lambda_s": "none"}),
        ("islands", ["--levels", "20", "--neighbours", "4"], {"levels": 20, "neighbours": 4}),
    ],
)  # fmt: skip
def test_a_map_gives_the_document_of_the_command(command, rough_map, tmp_path, what, arguments, options):
    file = save(tmp_path / "map.npy", rough_map)
    document = command.json(what, file, *MAP, *arguments)
    of_file = getattr(fstiff, what)(file, **OF_MAP, **options)
    assert list(of_file) == list(document)
    made = plain(dict(of_file))
    for key in ("inputs", "files"):  # lengths are written as they were given
        made.pop(key, None), document.pop(key, None)
    assert made == document
    assert of_file.warnings == document["warnings"]
    of_array = getattr(fstiff, what)(rough_map, spacing=(1e-6, 1.5e-6), **options)
    assert list(of_array) == list(of_file)
    made = plain(dict(of_array))
    for key in ("source", "inputs"):
        made.pop(key), document.pop(key, None)
    for key in ("concerns", "warnings"):
        assert made[key] == document[key] if key in made else key not in document
    assert made == document


@pytest.mark.parametrize(
    "what, arguments, options",
    [
        ("measure", [], {}),
        ("measure", ["--lambda-c", "0.2 mm", "--filter", "robust", "--tip-radius", "2 um"],
         {"lambda_c": 0.2e-3, "filter": "robust", "tip_radius": "2 um"}),
        ("fit", ["--resamples", "0", "--convention", "paper"], {"resamples": 0, "convention": "paper"}),
        ("fit", ["--detrend", "gaussian", "--cutoff", "0.1 mm"], {"detrend": "gaussian", "cutoff": 1e-4}),
    ],
)  # fmt: skip
def test_a_profile_gives_the_document_of_the_command(command, trace, tmp_path, what, arguments, options):
    file = save(tmp_path / "trace.npy", trace)
    document = command.json(what, file, *TRACE, *arguments)
    of_file, of_array = (
        getattr(fstiff, what)(file, **OF_TRACE, **options),
        getattr(fstiff, what)(trace, spacing=0.5e-6, **options),
    )
    assert list(of_file) == list(of_array) == list(document)
    for made in (plain(dict(of_file)), plain(dict(of_array))):
        for key in document:
            if key not in ("inputs", "source"):
                assert made[key] == document[key], key
    assert of_file["source"] == document["source"]


def test_several_files_are_pooled(command, trace, tmp_path):
    files = [save(tmp_path / f"{i}.npy", trace * (1 + i / 10)) for i in range(2)]
    document = command.json("measure", *files, *TRACE)
    pooled = fstiff.measure(files, **OF_TRACE)
    assert list(pooled) == list(document) and pooled["surface"] == document["surface"]
    with pytest.raises(ValueError, match="must be one"):
        fstiff.fit(files, **OF_TRACE)


def test_arrays_of_several_traces_are_pooled_as_their_files_are(command, trace, rough_map, tmp_path):
    traces = [trace, trace[::-1] * 1.1, trace[:1500] * 0.9]
    files = [save(tmp_path / f"{i}.npy", one) for i, one in enumerate(traces)]
    document = command.json("measure", *files, *TRACE)
    pooled = fstiff.measure(traces, spacing=0.5e-6)
    for key in ("surface", "moments", "neighbours", "concerns", "lambda_s_m", "lambda_c_m", "roughness", "correlation_of_errors"):
        assert plain(pooled[key]) == document[key], key
    assert pooled["source"]["decisions"][0] == "3 arrays pooled, each by its length: heights[0], heights[1], heights[2]"
    given = [
        tuple(traces),
        [np.ma.array(one, mask=False) for one in traces],
        [fstiff.Surface(one, "0.5 um") for one in traces],
        [trace, list(traces[1]), traces[2]],
    ]
    for some in given:
        spacing = {} if isinstance(some[0], fstiff.Surface) else {"spacing": 0.5e-6}
        assert fstiff.measure(some, **spacing)["surface"] == pooled["surface"]
    assert plain(fstiff.run(surface=pooled).answer.rows) == command.json("run", "--surface", *pooled_document(command, files, tmp_path))["answer"]
    maps = [rough_map, rough_map[:, ::-1]]
    of_maps = fstiff.measure(maps, spacing=(1e-6, 1.5e-6))
    assert of_maps["source"]["kind"] == "map" and of_maps["source"]["decisions"][0].startswith("2 arrays pooled, each by its area")
    # a trace twice counts once
    twice = fstiff.measure([trace, trace.copy()], spacing=0.5e-6)
    assert twice["surface"] == fstiff.measure(trace, spacing=0.5e-6)["surface"]
    assert twice.warnings[0].startswith("heights[1]: is the same array as heights[0], byte for byte")


def pooled_document(command, files, folder):
    document = folder / "pooled.json"
    document.write_text(command("measure", *files, *TRACE, "--format", "json"))
    return [document]


def test_a_map_stays_a_map_however_its_rows_are_given(rough_map):
    both = {"spacing": (1e-6, 1.5e-6)}
    wanted = fstiff.measure(rough_map, **both)["surface"]
    assert fstiff.measure(rough_map.tolist(), dx=1e-6, dy=1.5e-6)["surface"] == wanted
    assert fstiff.measure(list(rough_map), dx=1e-6, dy=1.5e-6)["surface"] == wanted  # rows that have a distance of their own
    strided = np.repeat(rough_map, 2, axis=1)[:, ::2]
    for other in (list(rough_map), [rough_map], np.asfortranarray(rough_map), strided, rough_map.astype(">f8")):
        assert fstiff.measure(other, **both)["surface"] == wanted
    assert fstiff.measure(fstiff.Surface(rough_map, ("1 um", "1.5 um")))["surface"] == wanted


@pytest.mark.parametrize("shape", [(5, 2048), (2048, 5), (4, 1100), (16, 2048)])
def test_a_strip_is_measured_as_what_it_is(shape):
    strip = fstiff.generate("map", 0.5e-6, points=max(shape), rows=max(shape) // 8, hurst=0.8, rms=1e-6, seed=1).heights
    strip = strip[: min(shape), : max(shape)]
    found = fstiff.measure(strip if shape[0] < shape[1] else strip.T, spacing=0.5e-6)
    assert found["source"]["kind"] == "map"
    assert found.rms_height.value == pytest.approx(np.std(strip), rel=0.5)  # less a plane, above lambda_s


ORIGINALS = {
    "trace": lambda trace, _map, _folder: fstiff.measure(trace, spacing="0.5 um", lambda_c="0.2 mm"),
    "map": lambda _trace, map, _folder: fstiff.measure(map, dx=1e-6, dy="1.5 um", peaks="summits"),
    "traces": lambda trace, _map, _folder: fstiff.measure([trace, 1.2 * trace[:1200]], spacing=5e-7),
    "file": lambda trace, _map, folder: fstiff.measure(save(folder / "a.npy", trace), units="m", spacing=5e-7),
    "files": lambda trace, _map, folder: fstiff.measure(
        [save(folder / "a.npy", trace), save(folder / "b.npy", trace[::-1] * 1.1)], units="m", spacing=5e-7
    ),
    "folder": lambda trace, _map, folder: save(folder / "a.npy", trace) and fstiff.measure(folder, units="m", spacing=5e-7),
}


@pytest.mark.parametrize("kind", ORIGINALS)
def test_a_measurement_is_pickled_and_copied_with_all_its_numbers(kind, trace, rough_map, tmp_path):
    original = ORIGINALS[kind](trace.copy(), rough_map, tmp_path)
    scene = "contact.pressures = ['1 MPa', '20 MPa']\nmaterial.upper = 'steel'\nuncertainty.samples = 20\n"
    wanted = fstiff.run(scene, surface=original)
    state = pickle.dumps(original)
    for file in tmp_path.glob("*"):
        file.unlink()  # what is pickled needs no file
    copied, deep, loaded = copy.copy(original), copy.deepcopy(original), pickle.loads(state)
    for again in (copied, deep, loaded, pickle.loads(pickle.dumps(loaded)), copy.deepcopy(loaded)):
        assert again == original and again.warnings == original.warnings and again.rms_height == original.rms_height
        assert repr(again) == repr(original) and again.doubtful == original.doubtful
        curves = fstiff.run(scene, surface=again)
        assert curves.answer == wanted.answer and curves.warnings == wanted.warnings
    deep["surface"]["rms_height"]["value"] = 0
    assert original.rms_height.value > 0
    contact = fstiff.Contact("hybrid", surface=original, effective_modulus=1e11)
    assert pickle.loads(pickle.dumps(contact)).at_pressures(1e7) == contact.at_pressures(1e7)


def test_another_process_gets_a_measurement(trace, tmp_path):
    measured = fstiff.measure(trace, spacing=5e-7)
    scene = "contact.pressures = ['1 MPa', '20 MPa']\nuncertainty.samples = 20\n"
    with concurrent.futures.ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as pool:
        of_pool = [task.result() for task in [pool.submit(fstiff.run, scene, surface=measured) for _ in range(2)]]
    assert of_pool[0] == of_pool[1] == fstiff.run(scene, surface=measured)
    (tmp_path / "measured.pickle").write_bytes(pickle.dumps(measured))
    program = "import pickle, fstiff, sys; print(fstiff.run(sys.argv[1], surface=pickle.load(open('measured.pickle', 'rb'))).answer)"
    done = subprocess.run([sys.executable, "-c", program, scene], cwd=tmp_path, capture_output=True, encoding="utf-8",
                          env={**os.environ, "PYTHONUTF8": "1"})
    assert (done.stdout, done.stderr) == (f"{of_pool[0].answer}\n", "")


def test_a_pickle_holds_what_was_measured_not_what_came_later(trace, tmp_path):
    heights = trace.copy()
    measured = fstiff.measure(heights, spacing=5e-7)
    heights[:] = 0
    assert fstiff.run(surface=pickle.loads(pickle.dumps(measured))) == fstiff.run(surface=measured)
    of_file = fstiff.measure(save(tmp_path / "a.npy", trace), units="m", spacing=5e-7)
    save(tmp_path / "a.npy", 2 * trace)
    with pytest.raises(fstiff.FileError, match="a.npy: has changed since it was measured"):
        pickle.dumps(of_file)
    assert copy.deepcopy(of_file) == of_file


def test_arrays_of_any_kind_are_the_heights_that_they_hold(trace):
    trace = trace[:512]
    wanted = fstiff.measure(trace, spacing=5e-7)["surface"]
    read_only, strided = trace.copy(), np.repeat(trace, 2)[::2]
    read_only.flags.writeable = False
    kinds = [list(trace), tuple(trace), read_only, strided, trace.astype(">f8"), trace.astype(object), np.ma.array(trace)]
    if importlib.util.find_spec("pandas"):
        import pandas

        kinds += [pandas.Series(trace), pandas.Series(trace, dtype="Float64")]
    for heights in kinds:
        assert fstiff.measure(heights, spacing=np.float64(5e-7))["surface"] == wanted
    holes = [None if i % 100 == 7 else height for i, height in enumerate(trace)]
    with_nan = np.where(np.arange(trace.size) % 100 == 7, np.nan, trace)
    assert fstiff.measure(holes, spacing=5e-7)["surface"] == fstiff.measure(with_nan, spacing=5e-7)["surface"]
    counts = np.round(trace * 1e9).astype(np.int16)
    with pytest.warns(UserWarning, match="rms height"):
        of_counts, of_numbers = (fstiff.measure(heights, spacing=0.5) for heights in (counts, counts.astype(float)))
    assert of_counts["surface"] == of_numbers["surface"]


def test_heights_in_another_unit_are_warned_of(trace):
    with pytest.warns(UserWarning, match=r"rms height of 0\.\d+ m: above 1 mm; lengths are numbers in m"):
        fstiff.measure(trace * 1e6, spacing=0.5)
    with pytest.warns(UserWarning, match="rms height of 0.832 m: above 1 mm"):
        fstiff.Contact("hertz", rms_height=0.832, peak_radius=40, peak_density=5e8, r=0.5, theta=1, effective_modulus=1e11)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        fstiff.measure(trace, spacing=0.5e-6)


def test_numbers_are_those_of_cpp_bit_for_bit(numbers):
    keys = ["rms_height", "peak_radius", "peak_density", "fractal_dimension", "fractal_roughness", "r", "theta"]
    rows, columns, dx, dy = numbers["map/sides"]
    heights = numbers["map"].reshape(int(rows), int(columns))
    for name, of, made in (
        ("profile", "measured", fstiff.measure(numbers["profile"], spacing=1e-6, lambda_s="none", lambda_c="none")),
        ("map", "measured", fstiff.measure(heights, dx=dx, dy=dy, lambda_s="none")),
        ("profile", "default", fstiff.measure(numbers["profile"], spacing=1e-6)),
        ("map", "default", fstiff.measure(heights, dx=dx, dy=dy)),
    ):
        found = [made["surface"].get(key, {"value": 0, "error": 0}) for key in keys]
        assert [x for one in found for x in (one["value"], one["error"])] == numbers[f"{name}/{of}"][: 2 * len(keys)].tolist()


UNITS = {"nanovea_test1.txt": "mm,um", "opdx-3.txt": "m,m", "xy-4.txt": "um"}  # which these files do not say


def test_measured_files_have_the_numbers_of_the_command(command, root):
    folder = pathlib.Path(os.environ.get("FSTIFF_SURFACES", root.parent / "shared/surfaces"))
    if not folder.is_dir():
        pytest.skip(f"there is no folder of measured surfaces {folder}")
    measured = 0
    for path in sorted(folder.iterdir()):
        units = UNITS.get(path.name)
        try:
            found = fstiff.measure(path, **({"units": units} if units else {}))
        except ValueError:
            command("measure", path, allowed=(3,))
            continue
        expected = command.json("measure", path, *(["--units", units] if units else []))
        for key in ("surface", "neighbours", "moments", "concerns", "lambda_s_m", "lambda_c_m"):
            assert plain(found.get(key)) == expected.get(key), (path.name, key)
        measured += 1
    assert measured >= 8


def test_truth_is_that_of_the_command(command, rough_map, tmp_path):
    file = save(tmp_path / "map.npy", rough_map)
    document = command.json(
        "truth", file, *MAP, "--pressures", "5 MPa,50 MPa", "--modulus", "100 GPa", "--points", "32", "--edges", "periodic"
    )
    arguments = {"effective_modulus": 100e9, "points": 32, "edges": "periodic"}
    found = fstiff.truth(file, [5e6, 50e6], **OF_MAP, **arguments)
    made = plain(dict(found))
    assert made["rows"] == document["rows"] and list(made) == list(document)
    of_array = fstiff.truth(rough_map, [5e6, 50e6], spacing=(1e-6, 1.5e-6), **arguments)
    assert of_array["rows"] == document["rows"]
    assert found.column("stiffness_Pa_per_m").tolist() == [row["stiffness_Pa_per_m"] for row in document["rows"]]
    assert found.doubtful == any(row["stiffness_error_Pa_per_m"] > 0.2 * row["stiffness_Pa_per_m"] for row in made["rows"])


def test_hybrid_is_the_law_of_a_scene(rough_map):
    measured = fstiff.measure(rough_map, dx=1e-6, dy=1.5e-6)
    scene = """
[surface]
rms_height = "1 um"
peak_radius = "1 um"
peak_density = "500 /mm^2"
[material.upper]
youngs_modulus = "205 GPa"
poisson_ratio = 0.3
[contact]
pressures = ["1 MPa", "10 MPa"]
laws = ["hybrid", "persson", "summits"]
[uncertainty]
samples = 0
"""
    curves = fstiff.run(scene, surface=measured)
    for law in ("hybrid", "persson", "summits"):
        of_law = curves["law"] == law
        contact = fstiff.Contact(law, surface=measured, effective_modulus=curves.effective_modulus)
        points = contact.at_pressures(curves["pressure_Pa"][of_law])
        np.testing.assert_array_equal(points.stiffness, curves["stiffness_Pa_per_m"][of_law])
        np.testing.assert_array_equal(points.separation, curves["separation_m"][of_law])
    for surface, options in ((measured, {}), (rough_map, {"dx": 1e-6, "dy": 1.5e-6})):
        points = fstiff.hybrid(surface, [1e6, 1e7], effective_modulus=curves.effective_modulus, **options)
        np.testing.assert_array_equal(points.stiffness, curves["stiffness_Pa_per_m"][curves["law"] == "hybrid"])
    hertz = fstiff.Contact("hertz", surface=measured, effective_modulus=1e11).at_pressures(1e6)
    surface = {key: one["value"] for key, one in measured["surface"].items()}
    keys = ("rms_height", "peak_radius", "peak_density", "r", "theta")
    numbers = fstiff.Contact("hertz", effective_modulus=1e11, **{key: surface[key] for key in keys})
    assert hertz.stiffness == numbers.at_pressures(1e6).stiffness
    with pytest.raises(ValueError, match="rms_height: must not be given with surface"):
        fstiff.Contact("hertz", surface=measured, rms_height=1e-6, effective_modulus=1e11)


def test_missing_points_are_nan_or_masked(rough_map):
    holes = np.zeros(rough_map.shape, bool)
    holes[10:13, 20:24] = True
    with_nan = np.where(holes, np.nan, rough_map)
    of_nan = fstiff.islands(with_nan, spacing=1e-6)
    of_mask = fstiff.islands(np.ma.array(rough_map, mask=holes), spacing=1e-6)
    assert of_nan["missing_points"] == of_mask["missing_points"] == 12
    assert of_nan["representative"] == of_mask["representative"]
    assert "12 missing" in repr(fstiff.Surface(with_nan, 1e-6))


def test_topographies_of_surface_topography(rough_map):
    module = pytest.importorskip("SurfaceTopography")
    expected = fstiff.measure(rough_map, spacing=(1e-6, 1.5e-6))["surface"]
    heights = rough_map.T  # its first axis is x
    metres = module.Topography(heights, physical_sizes=(96e-6, 96e-6), unit="m")
    assert fstiff.measure(metres)["surface"]["rms_height"]["value"] == pytest.approx(expected["rms_height"]["value"], rel=1e-12)
    microns = module.Topography(heights * 1e6, physical_sizes=(96.0, 96.0), unit="µm")
    found = fstiff.measure(microns)["surface"]
    for key, one in expected.items():
        assert found[key]["value"] == pytest.approx(one["value"], rel=1e-9), key
    line = module.UniformLineScan(rough_map[0] * 1e9, 96000.0, unit="nm")
    profile = fstiff.fit(line, detrend="mean", resamples=0, window="2 um,20 um", lambda_s="none")
    assert profile["spacing_m"] == pytest.approx(1e-6, rel=1e-12) and profile["points"] == 96
    with pytest.raises(ValueError, match="topography: sizes have no units"):
        fstiff.measure(module.Topography(heights, physical_sizes=(1, 1)))


def test_files_are_opened_and_unknown_ones_go_to_surface_topography(rough_map, tmp_path):
    surface = fstiff.open_surface(save(tmp_path / "map.npy", rough_map), units="m", dx=1e-6, dy=1.5e-6)
    np.testing.assert_array_equal(surface.heights, rough_map)
    assert surface.spacing == (1e-6, 1.5e-6) and any("npy" in one for one in surface.decisions)
    module = pytest.importorskip("SurfaceTopography")
    from SurfaceTopography.IO import open_topography

    path = str(tmp_path / "map.nc")
    module.Topography(rough_map.T * 1e6, physical_sizes=(96.0, 96.0), unit="µm").to_netcdf(path)
    with pytest.raises(ValueError, match="no use for channel"):  # which the form has none of, for fstiff
        fstiff.measure(path, channel="Default")
    known, opened = fstiff.open_surface(path), fstiff.open_surface(path, channel="Default")
    for one in (known, opened):
        np.testing.assert_allclose(one.heights, rough_map, rtol=1e-12)
        np.testing.assert_allclose(one.spacing, (1e-6, 1.5e-6), rtol=1e-12)
    assert "netcdf" in known.decisions[0] and "SurfaceTopography" in opened.decisions[0]
    assert fstiff.measure(opened)["surface"]["rms_height"]["value"] > 0
    assert fstiff.measure(open_topography(path).topography())["surface"] == fstiff.measure(opened)["surface"]


def test_a_text_without_units_is_asked_for_them(tmp_path):
    (tmp_path / "heights.txt").write_text("".join(f"{i * 7 % 11}\n" for i in range(40)))
    with pytest.raises(ValueError, match="units"):
        fstiff.open_surface(tmp_path / "heights.txt")
    assert fstiff.open_surface(tmp_path / "heights.txt", units="um", spacing="1 um").spacing == 1e-6


def test_reprs_frames_and_plots(rough_map, trace):
    measured = fstiff.measure(trace, spacing=0.5e-6)
    assert "rms_height" in repr(measured) and "profile" in repr(measured)
    fits = fstiff.fit(trace, spacing=0.5e-6), fstiff.fit(rough_map, spacing=1e-6, window="2 um,20 um", lambda_s="none")
    assert "D = " in repr(fits[0]) and "along y" in repr(fits[1])
    islands = fstiff.islands(rough_map, spacing=1e-6)
    assert "D_p = " in repr(islands)
    pytest.importorskip("matplotlib")
    pytest.importorskip("pandas")
    assert measured.to_dataframe().set_index("parameter").loc["rms_height", "value"] == (
        measured["surface"]["rms_height"]["value"]
    )
    assert len(islands.to_dataframe()) == len(islands["curve"]["level_m"])
    assert set(fits[1].to_dataframe()["direction"]) <= {"x", "y"} and "lag_m" in fits[0].to_dataframe()
    truth = fstiff.truth(rough_map, 1e7, effective_modulus=1e11, points=32, spacing=1e-6)
    assert truth.to_dataframe()["stiffness_Pa_per_m"].tolist() == truth.column("stiffness_Pa_per_m").tolist()
    surfaces = fstiff.Surface(trace, 0.5e-6), fstiff.Surface(rough_map, 1e-6)
    for one in (*fits, islands, truth, *surfaces):
        assert one.plot().get_xlabel()


@pytest.mark.parametrize("key", fstiff._core.surface_options())
def test_every_option_of_the_table_is_a_keyword(key):
    keywords = {*fstiff._surfaces.SurfaceOptions.__annotations__, "peaks", "window", "columns", "channels"}
    assert keywords == set(fstiff._core.surface_options())
    with pytest.raises((TypeError, ValueError), match=f"{key} = <object|{key}: must name a file, not be of type object"):
        fstiff.measure("no such file", **{key: object()})


@pytest.mark.parametrize(
    "call, sentence",
    [
        (lambda z: fstiff.measure(z), "spacing: is missing"),
        (lambda z: fstiff.measure(z, spacing=0), 'spacing = "0 m": must be greater than 0'),
        (lambda z: fstiff.measure(z, spacing="1 apple"), "spacing"),
        (lambda z: fstiff.measure(z, spacing=[1e-6]), "spacing: must be one length, or (dx, dy)"),
        (lambda z: fstiff.measure(z[0, :9], spacing=1e-6), "profile has 9 points: must be at least 16"),
        (lambda z: fstiff.measure(z[None], spacing=1e-6), "heights have 3 dimensions"),
        (lambda z: fstiff.measure(z[:1], spacing=1e-6), "heights: 1 x 96 points are no map"),
        (lambda z: fstiff.measure(z[:, :2], spacing=1e-6), "heights: 64 x 2 points are no map"),
        (lambda z: fstiff.measure([], spacing=1e-6), "profile has 0 points"),
        (lambda z: fstiff.measure(np.zeros((0, 5)), spacing=1e-6), "heights: 0 x 5 points are no map"),
        (lambda z: fstiff.measure([z[0], z[1, :9]], spacing=1e-6), "heights[1]: profile has 9 points"),
        (lambda z: fstiff.measure([z[0], z], spacing=1e-6), "arrays of one surface must be of one kind"),
        (lambda z: fstiff.measure([z[0], "a.csv"], spacing=1e-6), "heights[1]: must be real numbers"),
        (lambda z: fstiff.measure([[1.0, 2.0], [3.0]], spacing=1e-6), "several traces are a list of 1-D arrays"),
        (lambda z: fstiff.measure(5.0, spacing=1e-6), "heights have 0 dimensions"),
        (lambda z: fstiff.measure(None, spacing=1e-6), "heights have 0 dimensions"),
        (lambda z: fstiff.measure({"z": z}, spacing=1e-6), "heights: must be an array or a list of arrays, not of type dict"),
        (lambda z: fstiff.fit(fstiff.measure(z, spacing=1e-6)), "heights: must be an array or a list of arrays, not of type Meas"),
        (lambda z: fstiff.measure((one for one in z), spacing=1e-6), "heights: must be real numbers"),
        (lambda z: fstiff.measure(z[0], spacing=np.arange(96.0)), "spacing: must be one length, or (dx, dy)"),
        (lambda z: fstiff.truth(z, "1 um", effective_modulus=1e11, spacing=1e-6), 'pressures = "1 um": "um" is not a unit of pressure'),
        (lambda z: fstiff.run(fstiff.Scene(), surface="a"), "surface: must not be given for a Scene"),
        (lambda z: fstiff.measure([fstiff.Surface(z, 1e-6), z], spacing=1e-6), "spacing: must not be given"),
        (lambda z: fstiff.fit([z[0], z[1]], spacing=1e-6), "arrays: must be one; measure() pools several"),
        (lambda z: fstiff.run(surface=z), "surface: must name a file, not be of type ndarray; measure() takes arrays"),
        (lambda z: fstiff.Contact("hybrid", surface=z, effective_modulus=1e11), "surface: must be what measure() returned"),
        (lambda z: fstiff.measure(np.full((32, 32), 1e-6), spacing=1e-6), "constant height"),
        (lambda z: fstiff.measure(z / 0, spacing=1e-6), "finite, or NaN where missing"),
        (lambda z: fstiff.measure(z.astype(complex), spacing=1e-6), "must be real numbers"),
        (lambda z: fstiff.measure(z, spacing=1e-6, detrend="lines"), "detrend"),
        (lambda z: fstiff.measure(z, spacing=1e-6, resamples=1), "resamples = 1: must be a whole number from 2 to 100000"),
        (lambda z: fstiff.measure(z, spacing=1e-6, seed=0.5), "seed = 0.5: must be a whole number from 0 to 9007199254740991"),
        (lambda z: fstiff.measure(z, spacing=1e-6, spikes=2), "spikes = 2: must be a number from 3 to 1000"),
        (lambda z: fstiff.measure(z, spacing=1e-6, filter="boxcar"), 'filter = "boxcar": must be one of "gaussian", "robust"'),
        (lambda z: fstiff.measure(z, spacing=1e-6, peaks="hills"), 'peaks = "hills": must be one of "islands", "summits"'),
        (lambda z: fstiff.measure(z, spacing=1e-6, units="um"), "units: is an option of files"),
        (lambda z: fstiff.measure(z, spacing=1e-6, lambda_s="1 s"), "lambda_s"),
        (lambda z: fstiff.measure(fstiff.Surface(z, 1e-6), spacing=1e-6), "spacing: must not be given"),
        (lambda z: fstiff.measure("no such file"), "no such file: no such file"),
        (lambda z: fstiff.islands(z[0], spacing=1e-6), "must be a map"),
        (lambda z: fstiff.islands(z, spacing=1e-6, neighbours=6), "neighbours = 6: must be 4 or 8"),
        (lambda z: fstiff.truth(z[0], 1e6, effective_modulus=1e11, spacing=1e-6), "boundary elements need a map"),
        (lambda z: fstiff.truth(z, -1, effective_modulus=1e11, spacing=1e-6), "pressure = -1: must be finite"),
        (lambda z: fstiff.truth(z, 1e6, effective_modulus=-1, spacing=1e-6), "must be finite and greater than 0"),
        (lambda z: fstiff.run("no/such.toml"), "no/such.toml"),
        (lambda z: fstiff.run("[surface]\n"), "scene"),
        (lambda z: fstiff.run(""), "scene: is an empty text; must name a file"),
        (lambda z: fstiff.run(surface=""), "surface: is an empty text; must name a file"),
        (lambda z: fstiff.measure(["", ""]), "surface: is an empty text; must name a file"),
        (lambda z: fstiff.measure(z, spacing=1e-6, mask=""), "mask: is an empty text; must name a file"),
        (lambda z: fstiff.open_surface(""), "file: is an empty text; must name a file"),
        (lambda z: fstiff.Scene().contact("herz"), 'law = "herz": must be one of the scene\'s'),
        (lambda z: fstiff.Scene().contact("hertz", 9), "peaks = 9: must be an entry of contact.peaks"),
        (lambda z: fstiff.Scene().contact("hertz", -1), "peaks = -1: must be 0 or greater"),
    ],
)
def test_bad_input_raises_value_errors_with_the_sentence(rough_map, call, sentence):
    with np.errstate(divide="ignore"), pytest.raises(ValueError) as caught:
        call(rough_map)
    assert sentence in str(caught.value) and "\n" not in str(caught.value)


def test_a_file_that_is_not_there_is_an_os_error_too():
    with pytest.raises(fstiff.FileError) as caught:
        fstiff.measure("no such file")
    assert isinstance(caught.value, OSError) and isinstance(caught.value, ValueError)
    with pytest.raises(TypeError, match="unexpected keyword argument: spaceing"):
        fstiff.measure([1.0] * 20, spaceing=1)


def test_two_threads_measure_at_once(rough_map, trace):
    given = [(rough_map, 1e-6), (trace, 0.5e-6)] * 2
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda one: fstiff.measure(one[0], spacing=one[1]), given))
    for one, (heights, spacing) in zip(found, given):
        assert plain(dict(one)) == plain(dict(fstiff.measure(heights, spacing=spacing)))


def test_columns_of_one_file_are_traces_of_one_face(tmp_path):
    random = np.random.default_rng(4)
    x = np.arange(600.0)
    traces = [1e-7 * np.cumsum(random.standard_normal(600)) for _ in range(3)]
    files = []
    for i, trace in enumerate(traces):
        files.append(str(tmp_path / f"trace{i}.csv"))
        np.savetxt(files[-1], np.column_stack([1e-6 * x, trace]), delimiter=",", header="x [m],z [m]", comments="", fmt="%.17g")
    one = str(tmp_path / "columns.csv")
    head = "x [m]," + ",".join(f"z{i} [m]" for i in range(3))
    np.savetxt(one, np.column_stack([1e-6 * x, *traces]), delimiter=",", header=head, comments="", fmt="%.17g")
    pooled = fstiff.measure(one, format="profile", columns="2-4")
    assert pooled.rms_height.value == fstiff.measure(files).rms_height.value
    assert len(pooled["files"]) == 3
    assert pickle.loads(pickle.dumps(pooled)) == pooled
    with pytest.raises(ValueError, match="columns = .*must not be given where one surface is read"):
        fstiff.measure(traces[0], spacing=1e-6, columns="2-4")
