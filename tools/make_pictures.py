#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the documents with the command and the Python package.

    tools/make_pictures.py build/release/bin/fstiff            writes the pictures of docs that PICTURES names
    tools/make_pictures.py --check build/release/bin/fstiff    exit code 1 when the command draws one otherwise

What begins with "fstiff." is drawn by the Python package, where it is installed, and is not checked: each matplotlib draws otherwise.
Numbers may differ by 0.02 points, where another compiler rounds otherwise; everything else must be equal.
"""
import importlib.util
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

from generated import ROOT, write_or_check

TRACE = "fstiff generate profile --points 16384 --spacing '0.5 um' --hurst 0.4 --rms '0.3 um' --longest '500 um' --seed 3 -o trace.csv"
MAP = "fstiff generate map --points 256 --spacing '0.5 um' --hurst 0.8 --rms '0.5 um' --longest '32 um' --shortest '4 um' --seed 1 -o map.csv"
PLOT = """import fstiff; from fstiff._page import MARK, figure, saved, style
with style():
    of, ax = figure(6, 3.6); {}.plot(ax)
open("{}.svg", "w", encoding="utf-8").write(saved(of, facecolor="white", metadata={{"Creator": MARK, "Date": None}}))"""
# Name of each picture, and the commands that draw it, in a folder with copies of docs, data and a folder of examples.
PICTURES = {
    "ground_plates": ("run data/ground_plates.toml",),
    "stiffness": ("run docs/stiffness.toml",),
    "first_curve": ("run first-curve.toml",),
    "trace_scales": (TRACE, "fstiff.measure('trace.csv').scales()"),
    "spectrum": (TRACE, "fstiff.spectrum('trace.csv')"),
    "identify": ("sh examples/interface/unloading.sh > unloading.csv",
                 "fstiff.identify('examples/interface/unloading.toml', 'unloading.csv', ['sigma'])"),
    "map_answer": (MAP, "run two_laws.toml --surface map.csv"),
    "heat_sink": ("run examples/interface/heat_sink.toml",),
}


def scenes(folder):
    """The scene printed on docs/first-curve.md, and that of docs/from-a-map.md with two laws, which a picture can show."""
    page = (ROOT / "docs/first-curve.md").read_text(encoding="utf-8")
    printed = re.search(r"^```toml\n(.*?)^```$", page, re.M | re.S)[1]
    (folder / "first-curve.toml").write_text('name = "a first curve"\n' + printed, encoding="utf-8")
    scene = (ROOT / "docs/blasted_map.toml").read_text(encoding="utf-8")
    (folder / "two_laws.toml").write_text(re.sub(r"(?m)^laws .*", 'laws = ["persson", "hertz"]', scene), encoding="utf-8")


wanted, (*check, command) = {}, sys.argv[1:]
command = pathlib.Path(command).resolve()
with tempfile.TemporaryDirectory() as name:
    work = pathlib.Path(name) / "work"
    for part in ("docs", "data", "examples/interface"):
        shutil.copytree(ROOT / part, work / part)
    scenes(work)
    os.chdir(work)
    for picture, (*before, last) in PICTURES.items():
        of_python = last.startswith("fstiff.")
        if of_python and (check or not importlib.util.find_spec("fstiff")):
            continue
        drawn = [sys.executable, "-c", PLOT.format(last, picture)] if of_python else [command, *shlex.split(f"{last} --plot {picture}.svg")]
        for words in (*(["sh", "-c", line] for line in before), drawn):
            subprocess.run(words, check=True, capture_output=True, env=os.environ | {"PATH": f"{command.parent}{os.pathsep}{os.environ['PATH']}"})
        wanted[ROOT / "docs" / f"{picture}.svg"] = pathlib.Path(f"{picture}.svg").read_text(encoding="utf-8")
sys.exit(write_or_check(wanted, "make_pictures.py", check == ["--check"], 0.021))
