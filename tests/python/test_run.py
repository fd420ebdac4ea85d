# SPDX-License-Identifier: BSD-3-Clause
"""run() is `fstiff run --format csv`, digit for digit."""

import pathlib
import pickle

import numpy as np
import pytest

import fstiff

SCENES = sorted((pathlib.Path(__file__).resolve().parents[2] / "data").glob("*.toml"))


def same(curves, columns):
    """Whether every cell of the CSV reads as the very number, and an empty one is NaN; the rows of the answer are `answer`."""
    is_answer = np.array(columns["answer"]) == "1"
    of_laws = is_answer if is_answer.all() else ~is_answer
    columns = {key: np.array(cells)[of_laws].tolist() for key, cells in columns.items() if key != "answer"}
    columns = {key: cells for key, cells in columns.items() if key in curves or any(cells)}  # a band of the answer alone
    assert list(curves) == list(columns)
    for key, cells in columns.items():
        column = curves[key]
        assert len(column) == len(cells) > 0
        if column.dtype.kind == "U":
            assert column.tolist() == cells
            continue
        assert column.dtype == np.float64
        for number, cell in zip(column.tolist(), cells):
            assert np.isnan(number) if cell == "" else number == float(cell), (key, number, cell)


@pytest.mark.parametrize("scene", SCENES, ids=lambda path: path.stem)
def test_a_file_gives_the_columns_of_the_csv(command, scene):
    same(fstiff.run(scene), command.csv("run", scene))


def test_there_are_scenes_and_one_is_built_in(command):
    assert len(SCENES) >= 4
    same(fstiff.run(), command.csv("run"))


@pytest.mark.parametrize("scene", [None, *SCENES], ids=lambda path: path.stem if path else "built-in")
def test_the_answer_is_that_of_the_command(command, scene):
    document = command.json("run", *([scene] if scene else []))
    answer = fstiff.run(scene).answer
    assert answer.rows == document["answer"] and answer.explanation == document["explanation"]
    assert answer.outside_band == document["outside_band"]
    assert answer["law"].tolist() == [row["law"] for row in document["answer"]]
    K, low, high = (answer[f"stiffness{end}_Pa_per_m"] for end in ("", "_p05", "_p95"))
    assert len(K) > 2 and np.all(low < K) and np.all(K < high)
    assert sum(answer.causes.values()) == pytest.approx(np.ones(len(K)))
    assert answer.explanation[0] in repr(answer) and len(answer.to_dataframe()) == len(K)


def test_a_ball_is_in_the_answer(command, tmp_path):
    scene = {
        "surface": {"rms_height": "0.3 um"},
        "material": {"upper": "steel"},
        "contact": {"ball_radius": "10 mm", "force": ["1 N", "10 N"]},
    }
    file = tmp_path / "ball.toml"
    file.write_text('surface.rms_height = "0.3 um"\nmaterial.upper = "steel"\n'
                    'contact = { ball_radius = "10 mm", force = ["1 N", "10 N"] }\n')  # fmt: skip
    answer, rows = fstiff.run(scene).answer, command.csv("run", file)
    assert answer.ball == command.json("run", file)["ball"]
    assert [ball["stiffness_N_per_m"] for ball in answer.ball] == [float(K) for K in rows["stiffness_N_per_m"]]
    assert "a [µm]" in repr(answer)


SCENE = """
name = "bodies"
[surface]
rms_height = "0.832 um"
peak_radius = "40 um"
peak_density = "500 /mm^2"
fractal_dimension = 1.62
errors = { rms_height = "0.05 um", peak_radius = "4 um", fractal_dimension = 0.02 }
[material.upper]
youngs_modulus = "205 GPa"
poisson_ratio = 0.3
yield_strength = "400 MPa"
[contact]
pressures = ["1 MPa", "10 MPa", "60 MPa"]
laws = ["hertz", "plastic_peaks", "greenwood_williamson"]
[uncertainty]
samples = 20
[output]
quantities = ["stiffness", "separation", "loading_stiffness", "contacts", "tangential_stiffness"]
"""


def test_a_text_gives_what_the_command_prints_of_its_file(command, tmp_path):
    file = tmp_path / "bodies.toml"
    file.write_text(SCENE)
    columns, document, curves = command.csv("run", file), command.json("run", file), fstiff.run(SCENE)
    assert "" in columns["theta"]  # Greenwood and Williamson have none
    same(curves, columns)
    assert np.isnan(curves["theta"]).any()
    assert (curves["stiffness_p05_Pa_per_m"] < curves["stiffness_Pa_per_m"]).any()
    assert curves.warnings == document["warnings"]
    assert curves.explanation == document["explanation"]
    assert curves.effective_modulus == document["effective_modulus_Pa"]
    assert curves.name == "bodies"
    laws = [title.split(",")[0] for title, _ in curves.parts()]
    assert laws == list(dict.fromkeys(curves["law"].tolist())) or len(laws) > len(set(curves["law"].tolist()))
    assert sum(len(part["law"]) for _, part in curves.parts()) == len(curves["law"])
    text = repr(curves)
    assert "bodies" in text and "hertz" in text and curves.warnings[0] in text


def test_conductances_are_columns_with_their_bands(command, tmp_path):
    file = tmp_path / "heat.toml"
    file.write_text('material.upper = "steel"\nsurface = { rms_height = "0.8 um", rms_gradient = 0.1 }\n'
                    'contact.pressures = ["1 MPa", "10 MPa"]\ngap.medium = "helium"\n')
    curves = fstiff.run(file)
    same(curves, command.csv("run", file))
    modulus = 210e9 / (2 * (1 - 0.3**2))
    for end in ("", "_p05", "_p95"):
        h = curves[f"thermal_conductance{end}_W_per_m2K"]
        range_of_steel = {"": 0, "_p05": -np.hypot(*[np.log(2 * 25 / (25 + 45))] * 2), "_p95": np.hypot(*[np.log(2 * 60 / (60 + 45))] * 2)}[end]
        of_K = np.log(curves[f"stiffness{end}_Pa_per_m"] / curves["stiffness_Pa_per_m"])
        wanted = np.sign(of_K) * np.hypot(of_K, range_of_steel)  # by squares
        assert np.log(h * modulus / 45 / curves["stiffness_Pa_per_m"]) == pytest.approx(wanted, abs=1e-9)
        assert curves.answer[f"thermal_conductance{end}_W_per_m2K"] == pytest.approx(h, rel=1e-15)


def test_a_data_frame_is_what_pandas_reads_of_the_csv(command, root):
    pandas = pytest.importorskip("pandas")
    import io

    scene = root / "data" / "sand_blasted_fine.toml"
    read = pandas.read_csv(io.StringIO(command("run", scene, "--format", "csv")), dtype=None)
    read = read[read["answer"] == 0].drop(columns="answer").dropna(axis=1, how="all")
    made = fstiff.run(scene).to_dataframe()
    assert list(made) == list(read)
    for key in read:
        if read[key].dtype.kind == "f":
            np.testing.assert_array_equal(made[key].to_numpy(), read[key].to_numpy())
        else:
            assert made[key].tolist() == read[key].tolist() or made[key].astype(float).tolist() == read[key].tolist()


def test_a_plot_draws_every_curve_with_its_band():
    pytest.importorskip("matplotlib")
    curves = fstiff.run(SCENE)
    ax = curves.plot()
    lines = ax.get_lines()
    count = 1 + len(curves.parts())  # the answer is among them
    assert len(lines) == 2 * count and lines[0].get_xdata().size > 40 and lines[count].get_xdata().size == 3
    np.testing.assert_allclose(lines[count].get_ydata(), curves.answer.stiffness * 1e-12, rtol=1e-15)
    at = np.searchsorted(lines[0].get_xdata(), lines[count].get_xdata() * (1 - 1e-12))  # the marks are on the smooth line
    np.testing.assert_allclose(lines[0].get_ydata()[at], lines[count].get_ydata(), rtol=1e-12)
    assert len(ax.collections) >= 1 and "MPa/µm" in ax.get_ylabel()


def test_the_law_is_marked_where_it_changes(rough_map):
    pytest.importorskip("matplotlib")
    scene = {"material": {"upper": "steel"}, "contact": {"pressures": ["1 kPa", "1 MPa", "100 MPa"]}}
    curves = fstiff.run(scene, surface=fstiff.measure(rough_map, spacing=1e-6))
    texts = [text.get_text() for text in curves.plot().texts]
    laws = list(dict.fromkeys(curves.smooth().answer["law"]))
    assert len(laws) > 1 and texts == [law.replace("_", " ") for law in laws]


def test_columns_are_attributes_that_know_their_band():
    curves = fstiff.run(SCENE)
    for found in (curves.answer, pickle.loads(pickle.dumps(curves)).answer):
        k = found.stiffness
        assert np.array_equal(k, found["stiffness_Pa_per_m"]) and np.all(k.low < k) and np.all(k < k.high)
        assert k[1:].low[0] == k.low[1] and isinstance(k[0], float)
        again = pickle.loads(pickle.dumps(k))
        assert np.array_equal(again.high, k.high) and (2 * k).low is None
    assert curves.answer.law[0] == curves.answer["law"][0]


def test_a_measured_surface_stands_in_place_of_a_file(command, trace, tmp_path):
    np.save(tmp_path / "trace.npy", trace)
    measured = fstiff.measure(tmp_path / "trace.npy", spacing="0.5 um", units="m")
    document = tmp_path / "measured.json"
    document.write_text(
        command("measure", tmp_path / "trace.npy", "--spacing", "0.5 um", "--units", "m", "--format", "json")
    )
    of_document = command.csv("run", "--surface", document)
    curves = fstiff.run(surface=measured)
    same(curves, of_document)
    same(fstiff.run(surface=document), of_document)
    assert len(curves["law"]) > 0 and not np.isnan(curves["stiffness_p05_Pa_per_m"]).any()


def test_a_scene_gives_its_contacts(root):
    text = (root / "docs" / "stiffness.toml").read_text()
    scene = fstiff.Scene(text.replace('["stiffness", ', '["stiffness", "separation", '))
    curves = scene.run()
    hertz = curves["law"] == "hertz"
    points = scene.contact("hertz").at_pressures(curves["pressure_Pa"][hertz])
    np.testing.assert_array_equal(points.stiffness, curves["stiffness_Pa_per_m"][hertz])
    np.testing.assert_array_equal(points.separation, curves["separation_m"][hertz])
    assert "hertz" in repr(scene) and scene.laws == ["fractal", "hertz"]
    again = pickle.loads(pickle.dumps(scene)).contact("hertz").at_pressures(1e6)
    assert again.stiffness == scene.contact("hertz").at_pressures(1e6).stiffness
    assert fstiff.Scene().contact("hertz").at_pressures(1e6).stiffness > 0  # of a scene that names no law, any


BODIES = {
    "name": "bodies",
    "surface": {"rms_height": "0.8 µm", "rms_gradient": 0.1, "skewness": None},
    "material": {"upper": "steel", "lower": {"youngs_modulus": "70 GPa", "poisson_ratio": 0.34}},
    "contact": {"pressures": ("1 MPa", "10 MPa"), "laws": ["hybrid", "persson"], "nominal_area": None},
    "uncertainty": {"samples": np.int64(40), "seed": 7},
}
AS_TOML = """
name = "bodies"
surface = { rms_height = "0.8 µm", rms_gradient = 0.1 }
material.upper = "steel"
material.lower = { youngs_modulus = "70 GPa", poisson_ratio = 0.34 }
[contact]
pressures = ["1 MPa", "10 MPa"]
laws = ["hybrid", "persson"]
[uncertainty]
samples = 40
seed = 7
"""


def test_a_dict_is_the_scene_of_its_toml(trace):
    curves, wanted = fstiff.run(BODIES), fstiff.run(AS_TOML)
    assert curves == wanted and curves.answer == wanted.answer and curves.name == "bodies"
    assert curves.answer.explanation == wanted.answer.explanation and curves.warnings == wanted.warnings
    assert pickle.loads(pickle.dumps(fstiff.Scene(BODIES))).run() == wanted == fstiff.run(fstiff.Scene(BODIES))
    exported = [fstiff.export(of, law="hybrid", pressures=(1e6, 1e7)).splitlines() for of in (BODIES, AS_TOML)]
    assert [line for line in exported[0] if "SHA-256" not in line] == [line for line in exported[1] if "SHA-256" not in line]
    measured = fstiff.measure(trace, spacing=0.5e-6)
    of_trace = fstiff.run({"material": {"upper": "steel"}, "contact": {"pressures": ["1 MPa"]}}, surface=measured)
    assert of_trace == fstiff.run("material.upper = 'steel'\ncontact.pressures = ['1 MPa']\n", surface=measured)


TEXTS = [
    'a "quoted" name',
    "back\\slash \\n \\u0041",
    "two\nlines\ttab\r",
    "a = 1 # no comment",
    '"""',
    "'''",
    "\"]\n[contact]\nlaws = ['hertz']",
    "delete \x7f, bell \x07",
    "µm °C 表面 \U0001f600",
    "true",
    "1979-05-27",
    "{ a = 1 }",
]


@pytest.mark.parametrize("text", TEXTS)
def test_a_text_of_a_dict_stays_that_text(text):
    curves = fstiff.run({**BODIES, "name": text})
    assert curves.name == text and curves == fstiff.run(BODIES)


@pytest.mark.parametrize("key", ["a.b", 'a"] = 2\n[contact', "a b", "", "'", "\\", "µ", "[x]", "#"])
def test_a_key_of_a_dict_stays_that_key(key):
    for scene, path in (({key: 1}, key), ({**BODIES, "surface": {key: {"x": 1}}}, f"surface.{key}")):
        with pytest.raises(ValueError) as caught:
            fstiff.run(scene)
        assert str(caught.value).startswith(f"scene: {path}: unknown key; valid keys")


@pytest.mark.parametrize(
    "scene, sentence",
    [
        ({}, "scene: surface: is missing"),
        ({"surface": {"rms_height": 1e-6}}, "scene: surface.rms_height = 1e-06: a number without a unit"),
        ({"surface": {"rms_height": np.float32(1)}}, "scene: surface.rms_height = 1"),
        ({"surface": {"rms_height": True}}, "scene: surface.rms_height = true: must be a text"),
        ({"surface": {"rms_height": "1 um", "rms_gradient": float("nan")}}, "must be a finite number"),
        ({"surface": {"rms_height": "1 apple"}}, 'scene: surface.rms_height = "1 apple"'),
        ({"surface": {"rms_height": ["1 um", None]}}, "scene: surface.rms_height[1] = None: must be a number, a text"),
        ({"surface": {"rms_height": 2**70}}, "scene: surface.rms_height = 1180591620717411303424: must be a number"),
        ({"surface": {"rms_height": 1j}}, "scene: surface.rms_height = 1j: must be a number"),
        ({"surface": {1: "1 um"}}, "scene: surface.1: its name must be a text"),
        ({"surface": b"1 um"}, "scene: surface = b'1 um': must be a number"),
        ({"surface": fstiff.spectrum(np.arange(64.0) % 3, spacing=1.0)}, "scene: surface: must not be a Spectrum; surface= takes"),
        ({"name": "\ud800"}, "surrogates not allowed"),
    ],
)
def test_what_is_wrong_with_a_dict_is_named_by_its_keys(scene, sentence):
    with pytest.raises(ValueError) as caught:
        fstiff.run(scene)
    assert sentence in str(caught.value)


def test_a_dict_that_holds_itself_is_refused():
    scene = {"surface": {}}
    scene["surface"]["surface"] = scene
    with pytest.raises(ValueError, match="must not be nested more than 50 deep"):
        fstiff.run(scene)
    with pytest.raises(ValueError, match="scene: must name a file, not be of type list"):
        fstiff.run([1])


def test_the_answer_is_shown_as_the_command_shows_it(command, tmp_path):
    file = tmp_path / "light.toml"
    file.write_text(
        "material.upper = 'steel'\nsurface = { rms_height = '2 um', rms_gradient = 0.1 }\n"
        "contact.pressures = ['1 MPa', '3 MPa']\n"
    )
    answer = fstiff.run(file).answer
    table = [line.split() for line in command("run", file).splitlines()]
    shown = [line.split() for line in repr(answer).splitlines()[1:4]]
    assert shown[0][:3] == ["pressure", "K/A0", "[MPa/µm]"]  # 74.9 MPa/µm, not 0.0749 GPa/µm
    for row in shown:
        assert row in table, row
    assert float(shown[1][2]) == float(f"{answer['stiffness_Pa_per_m'][0] * 1e-12:.3g}")
    assert "<th>K/A0 [MPa/µm]</th>" in answer._repr_html_() and "_" not in "".join(map("".join, shown))
