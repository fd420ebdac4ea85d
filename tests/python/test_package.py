# SPDX-License-Identifier: BSD-3-Clause
"""The package itself: import, types, the document and the example."""

import contextlib
import io
import pathlib
import re
import signal
import subprocess
import sys

import pytest

import fstiff


def test_the_import_takes_no_numpy():
    """What makes it short; docs/python.md has the time."""
    program = "import sys, fstiff; print([name for name in ('numpy', 'pandas', 'matplotlib', 'json.tool') if name in sys.modules])"
    assert subprocess.run([sys.executable, "-c", program], capture_output=True, text=True).stdout == "[]\n"


def test_the_version_is_that_of_the_library(root):
    header = (root / "include" / "fstiff" / "core" / "version.hpp").read_text()
    assert fstiff.__version__ == re.search(r'define FSTIFF_VERSION_TEXT "([^"]+)"', header)[1]


def test_every_public_name_has_a_docstring():
    for name in fstiff.__all__:
        if name == "__version__":
            continue
        public = getattr(fstiff, name)
        assert public.__doc__, name
        if isinstance(public, type) and public.__module__.startswith("fstiff._") and public is not fstiff.FileError:
            for member, value in vars(public).items():
                if not member.startswith("_") and callable(value):
                    assert value.__doc__, f"{name}.{member}"


def test_types_are_right_and_are_shipped(root, tmp_path):
    pytest.importorskip("mypy")
    package = pathlib.Path(fstiff.__file__).parent
    assert (package / "py.typed").exists() and "class Contact" in (package / "_core.pyi").read_text()
    user = tmp_path / "user.py"
    user.write_text(
        "import numpy as np\n"
        "import fstiff\n"
        "law = fstiff.Contact('hertz', effective_modulus=1e11, rms_height=1e-6).tabulate(1e5, 1e8)\n"
        "one: float = law.stiffness(1e6)\n"
        "many = law.stiffness(np.array([1e6])).sum()\n"
        "pressure: float = law.at_separation(1e-6)[0]\n"
        "slope: float = law.tangent_at_separation(1e-6)[1]\n"
        "slopes = law.tangent_at_separation(np.array([1e-6]))[1].sum()\n"
        "fstiff.Contact('jackson_green', effective_modulus=1e11, rms_height='0.8 um', poisson_ratio=0.3, yield_strength=1e9)\n"
        "found = fstiff.measure(np.zeros(100), spacing=1e-6, detrend='line')\n"
        "reveal_type(fstiff.run()['pressure_Pa'])\n"
        "fstiff.measure(np.zeros(100), spaceing=1e-6)\n"
    )
    mypy = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(tmp_path / "cache")]
    mypy += ["--config-file", str(root / "pyproject.toml")]
    whole = subprocess.run([*mypy, "-p", "fstiff"], capture_output=True, text=True, cwd=tmp_path)
    assert whole.returncode == 0, whole.stdout + whole.stderr
    done = subprocess.run([*mypy, str(user)], capture_output=True, text=True, cwd=tmp_path)
    errors = [line for line in done.stdout.splitlines() if ": error:" in line]
    assert len(errors) == 1 and 'Unexpected keyword argument "spaceing"' in errors[0], done.stdout + done.stderr
    assert "numpy.ndarray" in done.stdout


def test_ctrl_c_ends_a_computation():
    program = (
        "import signal, threading, os, fstiff, numpy as np\n"
        "threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT)).start()\n"
        "contact = fstiff.Contact('hertz', effective_modulus=1e11, rms_height=1e-6, peak_radius=4e-5, peak_density=5e8, r=.5, theta=1)\n"
        "try:\n"
        "    contact.at_pressures(np.full(100_000_000, 1e6), ['stiffness'])\n"
        "except KeyboardInterrupt:\n"
        "    print('ended')\n"
    )
    if not hasattr(signal, "SIGINT") or sys.platform == "win32":
        pytest.skip("no signals")
    assert subprocess.run([sys.executable, "-c", program], capture_output=True, text=True).stdout == "ended\n"


def blocks_of(document):
    """(kind, text) of every block of code."""
    return re.findall(r"^```(\w+)\n(.*?)^```$", document.read_text(), re.MULTILINE | re.DOTALL)


def check_document(document, programs=4):
    """Runs the programs of a document, at least as many, in the present folder, and compares what they print with what it shows."""
    blocks = blocks_of(document)
    assert sum(kind == "python" for kind, _ in blocks) >= programs
    names, printed = {}, None
    for kind, text in blocks:
        if kind == "python":
            assert not printed, f"the document does not show {printed}"
            out = io.StringIO()
            with contextlib.redirect_stdout(out):
                exec(compile(text, document.name, "exec"), names)
            printed = out.getvalue()
        elif kind == "text" and printed is not None:
            assert printed == text
            printed = None
    assert not printed


@pytest.fixture
def folder(tmp_path, monkeypatch):
    pytest.importorskip("matplotlib")
    pytest.importorskip("pandas")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "Agg")
    return tmp_path


def test_the_document_shows_what_comes_out(root, folder):
    (folder / "scene.toml").write_text((root / "data" / "example_of_paper.toml").read_text())
    check_document(root / "docs" / "python.md")


def test_the_whole_joint_is_what_its_document_shows(root, monkeypatch):
    monkeypatch.chdir(root)
    check_document(root / "docs" / "bolted-joint.md", 1)


def test_the_programs_of_sweeps_give_what_their_document_shows(root, folder, command):
    """docs/sweep.md: a table of Parquet, the picture and the shares of the inputs."""
    pytest.importorskip("pyarrow")
    pytest.importorskip("xarray")
    for name, results in (("grid", "results"), ("scatter", "scatter")):
        (folder / f"{name}.toml").write_text((root / "examples" / "sweeps" / f"{name}.toml").read_text())
        command("sweep", f"{name}.toml", "-o", f"{results}.jsonl")
    check_document(root / "docs" / "sweep.md")
    drawn, shown = ((place / "sweep.svg").read_text() for place in (folder, root / "docs"))
    paths = [re.findall(r' d="M ([^"]*)"', picture) for picture in (drawn, shown)]
    version = re.search("Matplotlib v[0-9.]+", shown)[0]
    assert paths[0] == paths[1] or version not in drawn


def test_the_pressures_of_a_form_are_those_of_the_command(root, tmp_path):
    """The equations of a joint with a form, solved by numpy, against the greatest pressures and the touching shares of `fstiff run`."""
    pytest.importorskip("matplotlib")
    program = [sys.executable, root / "examples/joint/pressure_of_form.py", "--points", "24", "--picture", "joint.svg"]
    done = subprocess.run(program, capture_output=True, text=True, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    rows = [[float(number) for number in re.findall(r"\d+\.\d+", line)] for line in done.stdout.splitlines()[1:]]
    assert len(rows) == 3
    for greatest, share, own_greatest, own_share in rows:
        assert greatest == pytest.approx(own_greatest, rel=0.01) and share == pytest.approx(own_share, abs=0.03), done.stdout
    assert "<path" in (tmp_path / "joint.svg").read_text("utf-8")


def test_the_example_draws_its_picture(root, tmp_path):
    pytest.importorskip("matplotlib")
    done = subprocess.run(
        [sys.executable, str(root / "examples" / "python" / "stiffness_of_a_map.py")],
        capture_output=True, text=True, cwd=tmp_path,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    expected = (root / "examples" / "python" / "output.txt").read_text()
    assert done.stdout == expected
    picture = (tmp_path / "stiffness_of_a_map.png").read_bytes()
    assert picture.startswith(b"\x89PNG") and len(picture) > 20000
