#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the documents with the command and the Python package.

    tools/make_pictures.py build/release/bin/fstiff            writes the pictures of docs that PICTURES and DRAWN name
    tools/make_pictures.py --check build/release/bin/fstiff    exit code 1 when the command draws one otherwise, or a picture of docs has
                                                               no colours for dark surroundings
    tools/make_pictures.py sweep build/release/bin/fstiff      writes those that are named

Those of DRAWN are drawn by Python with fstiff and matplotlib, where these are installed, and are not checked: each matplotlib draws
otherwise.
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

from generated import ROOT, themed, write_or_check

TRACE = "fstiff generate profile --points 16384 --spacing '0.5 um' --hurst 0.4 --rms '0.3 um' --longest '500 um' --seed 3 -o trace.csv"
MAP = "fstiff generate map --points 256 --spacing '0.5 um' --hurst 0.8 --rms '0.5 um' --longest '32 um' --shortest '4 um' --seed 1 -o map.csv"
# Name of each picture, and the commands that draw it, in a folder with copies of docs, data and examples.
PICTURES = {
    "ground_plates": ("run data/ground_plates.toml",),
    "stiffness": ("run docs/stiffness.toml",),
    "first_curve": ("run my.toml",),
    "map_answer": (MAP, "run docs/blasted_map.toml --surface map.csv"),
    "heat_sink": ("run examples/interface/heat_sink.toml",),
    "ultrasound": ("ultrasound --reflection data/example_reflections.csv --material steel",),
}
PLOT = """import fstiff, numpy as np; from fstiff._page import MARK, figure, saved, style
with style():
    of, ax = figure(6, 3.6)
    {}
    ax.set_title({!r})
open("{}.svg", "w", encoding="utf-8").write(saved(of, transparent=True, metadata={{"Creator": MARK, "Date": None}}))"""
# C of the trace was prescribed: constant for waves longer than 500 µm, and its integral is the square of 0.3 µm.
SPECTRUM = """fstiff.spectrum('trace.csv').plot(ax)
    q = 2 * np.pi / np.array([500, 1])
    ax.plot(q, 0.3**2 * q[0]**0.8 / 2.25 * q**-1.8, color='#2f80d0')
    ax.text(0.04, 3, 'as prescribed: C ~ q$^{-1-2H}$, H = 0.4', color='#2f80d0', size='small')
    for length, text in ((500, 'longest waves, 500 µm'), (2.5, 'λs of the file, 2.5 µm')):
        ax.axvline(2 * np.pi / length, color='#808080', ls='--', lw=1.2)
        ax.text(0.94 * 2 * np.pi / length, 2e-8, text, rotation=90, ha='right', va='bottom', size='small')"""
SCALES = """fstiff.measure('trace.csv').scales().plot(ax)
    ax.set(xlabel='λs [µm]', ylabel='over the value at λs = 2.5 µm')"""
# Those of Python: the commands before, a title and the statements, or a program that writes NAME.svg itself.
DRAWN = {
    "trace_scales": ((TRACE,), "K and parameters of the trace against the cut-off λs", SCALES),
    "spectrum": ((TRACE,), "Power spectral density of the trace", SPECTRUM),
    "identify": (("sh examples/interface/unloading.sh > unloading.csv",), "K against pressure: measured, and law plastic with the fitted σ",
                 "fstiff.identify('examples/interface/unloading.toml', 'unloading.csv', ['sigma']).plot(ax)"),
    "sweep": (("fstiff sweep examples/sweeps/grid.toml -o results.jsonl",), "docs/sweep.md"),
    "backbone": ((), "examples/dynamics/lap_joint.py"),
    "bolted_joint": ((), "examples/joint/pressure_of_form.py"),
}


def printed(page, language, part=""):
    """The first block of a page of docs in a language that has a part."""
    blocks = re.findall(rf"^```{language}\n(.*?)^```$", (ROOT / "docs" / page).read_text(encoding="utf-8"), re.M | re.S)
    return next(block for block in blocks if part in block)


def scenes(folder):
    """The scene printed on docs/first-curve.md, and that of docs/from-a-map.md with the laws that a picture can show."""
    (folder / "my.toml").write_text(printed("first-curve.md", "toml"), encoding="utf-8")
    scene = folder / "docs/blasted_map.toml"
    laws = 'laws = ["hybrid", "persson", "hertz"]'
    scene.write_text(re.sub(r"(?m)^laws .*", laws, scene.read_text(encoding="utf-8")), encoding="utf-8")


def python_of(picture):
    """The commands before, and the words that draw a picture of DRAWN."""
    before, *how = DRAWN[picture]
    if len(how) == 2:
        return before, ["-c", PLOT.format(how[1], how[0], picture)]
    if how[0].endswith(".py"):
        return before, [how[0], "--picture", f"{picture}.svg"]
    block = printed(pathlib.Path(how[0]).name, "python", f'savefig("{picture}.svg"')
    return before, ["-c", 'import matplotlib; matplotlib.use("Agg"); matplotlib.rcParams["svg.hashsalt"] = "fstiff"\n' + block]


def draw(before, words):
    path = {"PATH": f"{command.parent}{os.pathsep}{os.environ['PATH']}", "SOURCE_DATE_EPOCH": "0"}
    for line in (*(["sh", "-c", each] for each in before), words):
        subprocess.run(line, check=True, capture_output=True, env=os.environ | path)


wanted, (*options, command) = {}, sys.argv[1:]
check, asked = options == ["--check"], [one for one in options if one != "--check"]
command = pathlib.Path(command).resolve()
with tempfile.TemporaryDirectory() as name:
    work = pathlib.Path(name) / "work"
    for part in ("docs", "data", "examples"):
        shutil.copytree(ROOT / part, work / part)
    scenes(work)
    os.chdir(work)
    read = lambda picture: pathlib.Path(f"{picture}.svg").read_text(encoding="utf-8")
    for picture in asked or [*PICTURES, *DRAWN]:
        if picture in PICTURES:
            *before, last = PICTURES[picture]
            draw(before, [command, *shlex.split(f"{last} --plot {picture}.svg")])
            wanted[ROOT / "docs" / f"{picture}.svg"] = read(picture)
        elif not check and importlib.util.find_spec("fstiff"):
            before, words = python_of(picture)
            draw(before, [sys.executable, *words])
            wanted[ROOT / "docs" / f"{picture}.svg"] = themed(read(picture))
light = [path.name for path in sorted((ROOT / "docs").glob("*.svg")) if "prefers-color-scheme:dark" not in path.read_text(encoding="utf-8")]
if check and light:
    print(f"docs: {', '.join(light)}: without colours for dark surroundings; tools/make_pictures.py draws them with these")
sys.exit(write_or_check(wanted, "make_pictures.py", check, 0.021) or (check and bool(light)))
