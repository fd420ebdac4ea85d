#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the documents with the command itself.

    tools/make_pictures.py build/release/bin/fstiff            writes docs/stiffness.svg, and
                                                              docs/afm_map.svg where the map is there
    tools/make_pictures.py --check build/release/bin/fstiff    exit code 1 when the command draws it otherwise

Numbers may differ by 0.02 points, the last digit, where another compiler rounds otherwise; everything else must be equal.
"""
import pathlib
import subprocess
import sys
import tempfile

from generated import ROOT, write_or_check

wanted, (*check, command) = {}, sys.argv[1:]
for name in ["stiffness"] + ["afm_map"] * (ROOT / "../shared/surfaces/matrix-3.txt").exists():
    with tempfile.TemporaryDirectory() as folder:
        picture = pathlib.Path(folder) / f"{name}.svg"
        subprocess.run([pathlib.Path(command).resolve(), "run", f"docs/{name}.toml", "--plot", picture, "-o", f"{folder}/table"],
                       cwd=ROOT, check=True, stderr=subprocess.DEVNULL)
        wanted[ROOT / "docs" / f"{name}.svg"] = picture.read_text(encoding="utf-8")
sys.exit(write_or_check(wanted, "make_pictures.py", check == ["--check"], 0.021))
