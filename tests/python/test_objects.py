# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of other packages: each kind of object gives the numbers of a file with the same heights, or is refused in one sentence."""

import importlib.util
import pickle
import subprocess
import sys
import types
import zipfile

import numpy as np
import pytest

import fstiff

PRESSURES = [1e6, 1e7, 1e8]
X, Y = np.arange(96) * 1.0, np.arange(64) * 1.5  # um
HDF5 = b"\x89HDF\r\n\x1a\n" + bytes(512)


def topography(heights, sizes, unit="um", **others):
    return types.SimpleNamespace(heights=heights, physical_sizes=sizes, unit=unit, **others)


def holed(heights):
    return np.where(np.arange(heights.size).reshape(heights.shape) % 97 == 5, np.nan, heights)


def data_array(heights, x=X, y=Y, dims=("y", "x"), units=("um", "um", "um")):
    """A DataArray [um]; `units` are those of y, x and the heights, None for none."""
    xarray = pytest.importorskip("xarray")
    of = [{"units": unit} if unit else {} for unit in units]
    coordinates = {"y": ("y", y, of[0]), "x": ("x", x, of[1])}
    return xarray.DataArray(heights, dims=dims, coords={dim: coordinates[dim] for dim in dims if dim in coordinates}, attrs=of[2])


def frame(heights, units="um", index=Y, columns=X):
    """A frame of pandas [um]."""
    made = pytest.importorskip("pandas").DataFrame(heights, index=index, columns=columns)
    return with_units(made, units)


def series(heights, units="um", index=None, **options):
    pandas = pytest.importorskip("pandas")
    return with_units(pandas.Series(heights, index=np.arange(len(heights)) * 0.5 if index is None else index, **options), units)


def with_units(data, units):
    if units:
        data.attrs["units"] = units
    return data


# Each from the heights of a map [um], rows along y.
MAPS = {
    "a reader's map, as an array": lambda z: topography(z.T, (96, 96)),
    "a reader's map, as a function": lambda z: topography(lambda: z.T, (96, 96), "µm"),
    "a reader's map, masked": lambda z: topography(np.ma.masked_invalid(z.T), (96, 96), "micron"),
    "a reader's map without a unit": lambda z: (topography(z.T, (96, 96), None), {"units": "um"}),
    "DataArray": lambda z: data_array(z),
    "DataArray (x, y)": lambda z: data_array(z.T, dims=("x", "y")),
    "DataArray of falling positions": lambda z: data_array(z[::-1, ::-1], X[::-1], Y[::-1]),
    "DataArray of other units": lambda z: data_array(z, X * 1e3, Y * 1e-3, units=("mm", "nm", "um")),
    "DataArray, units of the positions given": lambda z: (data_array(z, units=(None, None, "um")), {"units": "um"}),
    "DataArray, unit of the heights given": lambda z: (data_array(z, X * 1e-3, Y * 1e-3, units=("mm", "mm", None)), {"units": "mm,um"}),
    "DataArray without positions": lambda z: (data_array(z).drop_vars(["x", "y"]), {"dx": "1 um", "dy": "1.5 um"}),
    "DataFrame": lambda z: frame(z),
    "DataFrame of two units": lambda z: frame(z, "mm,um", Y * 1e-3, X * 1e-3),
    "DataFrame, units given": lambda z: (frame(z, None), {"units": "um,um"}),
    "DataFrame of falling positions": lambda z: frame(z[:, ::-1], columns=X[::-1]),
}
# Each from the heights of a profile [um] whose points are 0.5 um apart.
PROFILES = {
    "a reader's profile": lambda z: topography(z, (len(z) / 2,), is_uniform=True),
    "a reader's profile, its size a number": lambda z: topography(lambda: z, len(z) / 2),
    "DataArray": lambda z: data_array(z, np.arange(len(z)) * 0.5, dims=("x",)),
    "DataArray of float32 positions": lambda z: data_array(z, np.arange(len(z), dtype=np.float32) * 0.5, dims=("x",)),
    "Series": lambda z: series(z),
    "Series of two units": lambda z: series(z, "nm, um", np.arange(len(z)) * 500),
    "Series with NA": lambda z: series(z, dtype="Float64"),
    "Series without positions": lambda z: (series(z, None).reset_index(drop=True), {"spacing": "0.5 um", "units": "um"}),
    "column of a table": lambda z: with_units(series(z, None).rename("z").rename_axis("x").reset_index().set_index("x")["z"], "um"),
}


def check(make, heights, file, options):
    """All parameters and K of an object are those of a file."""
    np.save(file, heights)
    of_file = fstiff.measure(file, units="um", fill=True, **options)
    made = make(heights)
    surface, own = made if isinstance(made, tuple) else (made, {})
    own["fill"] = True
    of_object = fstiff.measure(surface, **own)
    for name, parameter in of_file["surface"].items():
        for key in ("value", "error"):
            assert of_object["surface"][name][key] == pytest.approx(parameter[key], rel=1e-12), (name, key)
    expected = fstiff.hybrid(of_file, PRESSURES, effective_modulus=1e11).stiffness
    found = fstiff.hybrid(surface, PRESSURES, effective_modulus=1e11, **own).stiffness
    np.testing.assert_allclose(found, expected, rtol=1e-12)


@pytest.mark.parametrize("kind", MAPS)
def test_a_map_of_another_package_has_the_numbers_of_its_file(rough_map, tmp_path, kind):
    check(MAPS[kind], holed(rough_map) * 1e6, tmp_path / "map.npy", {"dx": "1 um", "dy": "1.5 um"})


@pytest.mark.parametrize("kind", PROFILES)
def test_a_profile_of_another_package_has_the_numbers_of_its_file(trace, tmp_path, kind):
    check(PROFILES[kind], holed(trace) * 1e6, tmp_path / "trace.npy", {"spacing": "0.5 um"})


def test_lists_are_pooled_as_their_files_are(trace, tmp_path):
    heights = [trace * 1e6, trace[::-1] * 1.1e6, trace[:1500] * 0.9e6]
    files = [tmp_path / f"{i}.npy" for i in range(3)]
    for file, one in zip(files, heights):
        np.save(file, one)
    of_files = fstiff.measure(files, units="um", spacing="0.5 um")
    makers = ["a reader's profile", *(["Series", "DataArray"] if importlib.util.find_spec("xarray") else ["a reader's profile"] * 2)]
    objects = [PROFILES[kind](one) for kind, one in zip(makers, heights)]
    pooled = fstiff.measure(objects)
    assert "3 arrays pooled, each by its length" in pooled["source"]["decisions"][0]
    for key in ("rms_height", "rms_gradient"):
        assert pooled["surface"][key]["value"] == pytest.approx(of_files["surface"][key]["value"], rel=1e-9)
    with pytest.raises(ValueError, match="arrays: must be one; measure"):
        fstiff.fit(objects)
    mixed = fstiff.measure([objects[0], fstiff.Surface(heights[1] * 1e-6, "0.5 um"), objects[2]])
    assert mixed["surface"] == pooled["surface"]


def test_every_surface_of_a_scene_or_a_joint_takes_them(rough_map):
    object = topography(rough_map.T * 1e6, (96, 96))
    measured, pooled = fstiff.measure(object), fstiff.measure([object, topography(rough_map * 1e6, (64, 144))])
    scene = {"material": {"upper": "steel"}, "contact": {"pressures": ["10 MPa"]}, "uncertainty": {"samples": 0}}
    for surface, same in ((object, measured), ([object, topography(rough_map * 1e6, (64, 144))], pooled)):
        curves = fstiff.run(scene, surface=same)
        assert fstiff.run(scene, surface=surface).answer == curves.answer
        assert pickle.loads(pickle.dumps(fstiff.Scene(scene, surface=surface))).run().answer == curves.answer
        assert fstiff.report(scene, surface=surface).count("<svg") > 3 if importlib.util.find_spec("matplotlib") else True
        k = fstiff.Contact("hybrid", surface=same, effective_modulus=1e11).at_pressures(1e7).stiffness
        assert fstiff.Contact("hybrid", surface=surface, effective_modulus=1e11).at_pressures(1e7).stiffness == k
    asked = {"pressures": PRESSURES, "samples": 0}
    joint = fstiff.answer(surface=measured, other=pooled, **asked)
    objects = [object, topography(rough_map * 1e6, (64, 144))]
    assert (fstiff.answer(surface=object, other=objects, **asked).stiffness == joint.stiffness).all()
    two = fstiff.answer(surface=[measured, pooled], **asked).stiffness
    assert (fstiff.answer(surface=[object, objects], **asked).stiffness == two).all() and two.shape == (2, 3)
    if importlib.util.find_spec("pandas"):
        rows = [fstiff.sweep(scene, {"contact.pressures[0]": [1e6, 2e6]}, surface=surface) for surface in (object, measured)]
        assert rows[0].equals(rows[1])


UNITS_MISSING = 'have no units; must be in the object, or given as units="um,nm" (lengths, heights)'
REFUSALS = [
    (lambda z: fstiff.measure(data_array(z, units=("um", None, "um"))), f"heights: positions along x {UNITS_MISSING}"),
    (lambda z: fstiff.measure(data_array(z, units=("um", "um", None))), f"heights {UNITS_MISSING}"),
    (lambda z: fstiff.measure(frame(z, None)), f"heights: positions in its columns {UNITS_MISSING}"),
    (lambda z: fstiff.measure([topography(z, (1, 1), None)]), f"topography[0]: sizes {UNITS_MISSING}"),
    (lambda z: fstiff.measure(data_array(z, units=("um", "um", "V"))), "heights have the unit V; must be a length, such as um"),
    (lambda z: fstiff.measure(data_array(z), units="um,nm"), 'units = "nm": contradicts the unit um of heights'),
    (lambda z: fstiff.measure(data_array(z), units="mm"), 'units = "mm": contradicts the unit um of heights: positions along x'),
    (lambda z: fstiff.measure(frame(z, "um,um,nm")), 'attrs["units"] = "um,um,nm": must be a unit of length, or two'),
    (lambda z: fstiff.measure(data_array(z), spacing=1e-6), "spacing: must not be given for a surface that has its own"),
    (lambda z: fstiff.measure(frame(z, None), dx=1e-6, dy=1e-6), "dx: must not be given for a surface that has its own"),
    (lambda z: fstiff.measure(topography(z, (1, 1)), spacing=1e-6), "spacing: must not be given for a surface that has its own"),
    (lambda z: fstiff.measure(data_array(z).drop_vars("x")), "heights: has no positions along x; must have them, or be given spacing"),
    (lambda z: fstiff.measure(frame(z, "um", None)), "heights: has no positions in its index; must have them, or be given spacing"),
    (lambda z: fstiff.measure(series(z[0], "um", range(96))), "heights: has no positions in its index"),
    (lambda z: fstiff.measure(data_array(z).expand_dims("band")), "heights have 3 dimensions: must have 1 (a profile) or 2 (a map)"),
    (lambda z: fstiff.measure(data_array(z).to_dataset(name="z")), "heights: must be an array or a list of arrays, not of type Dataset"),
    (lambda z: fstiff.measure(data_array(z[:, [0, 1, 2, 4, 5]], X[[0, 1, 2, 4, 5]])), "positions along x: 4 is a step of 2 where the usual one is 1; must be equally"),
    (lambda z: fstiff.measure(data_array(z, np.where(X == 7, np.nan, X))), "must be equally spaced"),
    (lambda z: fstiff.measure(data_array(z, X * 0)), "must be equally spaced"),
    (lambda z: fstiff.measure(data_array(z[:, :1], X[:1])), "heights: positions along x are 0.0: must be two numbers or more"),
    (lambda z: fstiff.measure(frame(z[:, :2], columns=["x", "z"])), "columns are x, z: must be two numbers or more; a profile of a table is"),
    (lambda z: fstiff.measure(series(["a"] * 96)), "heights: must be real numbers"),
    (lambda z: fstiff.measure(topography(z, (1,))), "its physical_sizes are (1,); must be lengths above 0 of its 2 axes"),
    (lambda z: fstiff.measure(topography(z, (1, -1))), "its physical_sizes are (1, -1); must be lengths above 0 of its 2 axes"),
    (lambda z: fstiff.measure(topography(z, None)), "its physical_sizes are None; must be lengths above 0 of its 2 axes"),
    (lambda z: fstiff.measure(topography(z, (1, 1), ("um", None))), f"topography: heights {UNITS_MISSING}"),  # a phase
    (lambda z: fstiff.measure(topography(z[0], 1, is_uniform=False)), "topography: its points are not equally spaced"),
    (lambda z: fstiff.measure(data_array(z), column=2), "column: is an option of files; must not be given for an array"),
    (lambda z: fstiff.run(surface=[z]), "spacing: is missing; an array needs the distance of its points [m]"),
]  # fmt: skip


@pytest.mark.parametrize("call, sentence", REFUSALS)
def test_what_cannot_be_known_is_refused_in_one_sentence(rough_map, call, sentence):
    with pytest.raises(ValueError) as caught:
        call(rough_map * 1e6)
    assert sentence in str(caught.value) and "\n" not in str(caught.value)


def test_positions_may_be_rounded(trace):
    """To within a hundredth of a step, as those of files."""
    rounded = np.round(np.arange(trace.size) * 0.5 + 0.002 * np.sin(np.arange(trace.size)), 4)
    found = fstiff.measure(series(trace * 1e6, "um", rounded))
    assert found["surface"]["rms_height"]["value"] == pytest.approx(fstiff.measure(series(trace * 1e6))["surface"]["rms_height"]["value"], rel=1e-3)
    with pytest.raises(ValueError, match="must be equally spaced"):
        fstiff.measure(series(trace * 1e6, "um", rounded + 0.02 * (np.arange(trace.size) == 9)))


def run(*words, cwd, without=()):
    """python -m fstiff run, without some packages."""
    program = "import sys; sys.modules.update(dict.fromkeys(sys.argv[1].split())); import fstiff.__main__ as m; sys.exit(m.main(sys.argv[2:]))"
    return subprocess.run([sys.executable, "-c", program, " ".join(without), "run", *map(str, words)], capture_output=True, text=True, cwd=cwd)


def test_the_command_prints_the_curves(root, rough_map, tmp_path):
    scene = root / "data" / "bolted_joint.toml"
    done = run(scene, cwd=tmp_path)
    curves = fstiff.run(scene)
    assert done.stdout == f"{curves}\n" and done.returncode == (4 if curves.doubtful else 0), done.stderr
    (tmp_path / "map.gsf").write_bytes(gsf(rough_map))
    done = run(scene, "--surface", "map.gsf", cwd=tmp_path)
    assert str(fstiff.run(scene, surface=tmp_path / "map.gsf").answer) in done.stdout and not done.stderr
    done = run(scene, "--surface", "no such file", cwd=tmp_path)
    assert done.returncode == 3 and "no such file: no such file" in done.stderr and done.stderr.count("\n") == 1


def gsf(heights):
    """A Gwyddion simple field of the map [m]."""
    header = "Gwyddion Simple Field 1.0\nXRes = 96\nYRes = 64\nXReal = 96e-6\nYReal = 96e-6\nXYUnits = m\nZUnits = m\n".encode()
    return header + bytes(4 - len(header) % 4) + heights.astype("<f4").tobytes()


def test_without_surface_topography_the_extra_is_named(tmp_path):
    (tmp_path / "map.h5").write_bytes(HDF5)
    (tmp_path / "map.txt").write_text("1 2 3 4\n1 2 3\n" * 9)
    done = run("--surface", "map.h5", cwd=tmp_path, without=["SurfaceTopography"])
    assert done.returncode == 3 and "is binary: an HDF5 file" in done.stderr and done.stderr.count("\n") == 1
    assert done.stderr.endswith("; SurfaceTopography may read it: pip install 'fstiff[readers]'\n")
    done = run("--surface", "map.txt", cwd=tmp_path, without=["SurfaceTopography"])  # of a form that is read
    assert done.returncode == 3 and "has 3 columns; must be 4" in done.stderr and "SurfaceTopography" not in done.stderr


def test_files_of_unknown_form_are_read_by_surface_topography(monkeypatch, rough_map, tmp_path):
    """By what stands in for it: which files it is asked for."""
    opened, units = [], ["m", "m", None]

    def open_topography(path):
        opened.append(path)
        return types.SimpleNamespace(topography=lambda: topography(rough_map.T, (96e-6, 96e-6), units.pop(0)))

    module = types.ModuleType("SurfaceTopography.IO")
    module.open_topography = open_topography
    monkeypatch.setitem(sys.modules, "SurfaceTopography", types.ModuleType("SurfaceTopography"))
    monkeypatch.setitem(sys.modules, "SurfaceTopography.IO", module)
    file = str(tmp_path / "map.h5")
    (tmp_path / "map.h5").write_bytes(HDF5)
    measured = fstiff.measure(rough_map, dx=1e-6, dy=1.5e-6)
    expected = fstiff.run(surface=measured).answer
    np.testing.assert_allclose(fstiff.run(surface=file).answer.stiffness, expected.stiffness, rtol=1e-9)
    with zipfile.ZipFile(book := str(tmp_path / "table.xlsx"), "w") as archive:  # a zip archive as X3P is
        archive.writestr("xl/workbook.xml", "")
    assert fstiff.measure(book).rms_height.value == pytest.approx(measured.rms_height.value, rel=1e-9)
    with pytest.raises(ValueError, match="map.h5: sizes have no units"):
        fstiff.run(surface=file)
    assert opened == [file, book, file]
    opened.clear()
    (tmp_path / "map.txt").write_text("1 2 3 4\n1 2 3\n" * 9)
    with pytest.raises(ValueError, match="has 3 columns; must be 4"):
        fstiff.run(surface=tmp_path / "map.txt")
    assert not opened  # what is wrong with a text is not read in another way


def test_a_file_that_only_surface_topography_reads_has_the_numbers_of_its_map(rough_map, tmp_path):
    pytest.importorskip("SurfaceTopography")
    heights = (rough_map * 1e9).astype("<f4")
    header = "fileformat = bcrf\nheadersize = 2048\nxpixels = 96\nypixels = 64\nxlength = 96000\nylength = 96000\nxunit = nm\nyunit = nm\nzunit = nm\n"
    (tmp_path / "map.bcrf").write_bytes(header.encode().ljust(2048) + heights.tobytes())
    surface = fstiff.open_surface(tmp_path / "map.bcrf")
    np.testing.assert_allclose(surface.heights, heights * 1e-9, rtol=1e-6)
    assert surface.spacing == pytest.approx((1e-6, 1.5e-6)) and "by SurfaceTopography, since" in surface.decisions[0]
    for compute in (fstiff.measure, fstiff.islands, fstiff.spectrum):
        assert str(compute(tmp_path / "map.bcrf")) == str(compute(surface))
    with pytest.raises(ValueError, match="units: must not be given for a surface that has its own"):
        fstiff.measure(tmp_path / "map.bcrf", units="um")
    done = run("--surface", "map.bcrf", cwd=tmp_path)
    assert str(fstiff.run(surface=surface).answer) in done.stdout and done.returncode in (0, 4), done.stderr


def datx(path, heights, step):
    """A map [m] as Zygo's .datx has it; NaN is missing."""
    h5py = pytest.importorskip("h5py")
    with h5py.File(path, "w") as file:
        root = [("Root", "Measurement", "{1}"), ("{1}", "Surface", "{2}"), ("{2}", "Path", "/Data/Surface")]
        file["MetaData"] = np.array([tuple(word.encode() for word in row) for row in root], dtype=[(name, "S20") for name in "abc"])
        data = file.create_dataset("Data/Surface", data=np.where(np.isnan(heights), 1e30, heights * 1e9))
        converter = np.dtype([("Category", "S20"), ("BaseUnit", "S20"), ("Parameters", "<f8", (4,))])
        data.attrs["No Data"], data.attrs["Unit"] = np.array([1e30]), np.array([b"NanoMeters"])
        for axis in "XY":
            data.attrs[f"{axis} Converter"] = np.array([(b"LateralCat", b"Pixels", (0, step, 0, 0))], dtype=converter)
        data.attrs["Z Converter"] = np.array([(b"HeightCat", b"NanoMeters", (0, 1, 0, 0))], dtype=converter)


def test_a_datx_of_zygo_has_its_heights_in_metres(rough_map, tmp_path):
    pytest.importorskip("SurfaceTopography")
    heights = rough_map.copy()
    heights[3, 5] = np.nan
    datx(tmp_path / "map.datx", heights, 1e-6)
    surface = fstiff.open_surface(tmp_path / "map.datx")
    np.testing.assert_allclose(surface.heights, heights, rtol=1e-12)
    assert surface.spacing == pytest.approx((1e-6, 1e-6)) and np.isnan(surface.heights[3, 5])
    of_file, of_array = fstiff.measure(tmp_path / "map.datx", fill=True), fstiff.measure(heights, spacing=1e-6, fill=True)
    assert of_file.rms_height.value == pytest.approx(of_array.rms_height.value, rel=1e-12)


def test_of_several_channels_of_heights_one_must_be_chosen(monkeypatch, rough_map, tmp_path):
    channels = [types.SimpleNamespace(index=index, name=name) for index, name in enumerate(("Phase", "Height", "Height (back)"))]

    def read(channel_index=0):
        return topography(rough_map.T * (1, 2, 3)[channel_index], (96e-6, 96e-6), "m")

    module = types.ModuleType("SurfaceTopography.IO")
    module.open_topography = lambda path: types.SimpleNamespace(topography=read, channels=channels, height_channels=channels[first:])
    monkeypatch.setitem(sys.modules, "SurfaceTopography", types.ModuleType("SurfaceTopography"))
    monkeypatch.setitem(sys.modules, "SurfaceTopography.IO", module)
    file = tmp_path / "map.h5"
    file.write_bytes(HDF5)
    first = 1
    with pytest.raises(ValueError, match=r'map.h5: has 2 channels of heights: 1 "Height", 2 "Height \(back\)"; must be one of them'):
        fstiff.measure(file)
    for channel, factor in (("Height", 2), (2, 3)):
        np.testing.assert_allclose(fstiff.open_surface(file, channel=channel).heights, rough_map * factor)
    first = 2  # the only one is read, whichever place it has
    np.testing.assert_allclose(fstiff.open_surface(file).heights, rough_map * 3)
