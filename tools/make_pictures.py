#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the documents with the command itself.

    tools/make_pictures.py build/release/bin/fstiff            writes the pictures of docs that PICTURES names, and
                                                              docs/afm_map.svg where the map is there
    tools/make_pictures.py --check build/release/bin/fstiff    exit code 1 when the command draws one otherwise

Numbers may differ by 0.02 points, the last digit, where another compiler rounds otherwise; everything else must be equal.
"""
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

from generated import ROOT, write_or_check

TRACE = "generate profile --points 16384 --spacing '0.5 um' --hurst 0.4 --rms '0.3 um' --longest '500 um' --seed 3 -o trace.csv"
MAP = "generate map --points 256 --spacing '0.5 um' --hurst 0.8 --rms '0.5 um' --longest '32 um' --shortest '4 um' --seed 1 -o map.csv"
# Name of each picture, and the commands that draw it, in a folder with copies of docs, data and a folder of examples.
PICTURES = {
    "built_in": ("run data/built_in.toml",),
    "stiffness": ("run docs/stiffness.toml",),
    "first_curve": ("run first-curve.toml",),
    "trace_scales": (TRACE, "measure trace.csv --scales"),
    "spectrum": (TRACE, "measure trace.csv --show spectrum"),
    "map_answer": (MAP, "run two_laws.toml --surface map.csv"),
    "identify": ("identify docs/stiffness.toml --measured data/example_stiffness.csv --law hertz --fit sigma,Dp",),
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
if (ROOT / "../shared/surfaces/matrix-3.txt").exists():
    PICTURES["afm_map"] = ("run docs/afm_map.toml",)
with tempfile.TemporaryDirectory() as name:
    work = pathlib.Path(name) / "work"
    for part in ("docs", "data", "examples/interface"):
        shutil.copytree(ROOT / part, work / part)
    pathlib.Path(name, "shared").symlink_to(ROOT.parent / "shared")  # docs/afm_map.toml reads ../../shared
    scenes(work)
    for picture, commands in PICTURES.items():
        for line in commands:
            last = ["--plot", f"{picture}.svg", "-o", f"{picture}.out"] if line == commands[-1] else []
            subprocess.run([pathlib.Path(command).resolve(), *shlex.split(line), *last], cwd=work, check=True,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        wanted[ROOT / "docs" / f"{picture}.svg"] = (work / f"{picture}.svg").read_text(encoding="utf-8")
sys.exit(write_or_check(wanted, "make_pictures.py", check == ["--check"], 0.021))
