#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the documents with the command itself.

    tools/make_pictures.py build/release/bin/fstiff            writes docs/stiffness.svg, and
                                                              docs/afm_map.svg where the map is there
    tools/make_pictures.py --check build/release/bin/fstiff    exit code 1 when the command draws it otherwise

Numbers may differ by 0.02 points, the last digit, where another compiler rounds otherwise; everything else must be equal.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PICTURES = {"stiffness": ["run", "docs/stiffness.toml"]}  # name in docs/: arguments of fstiff
if (ROOT / "../shared/surfaces/matrix-3.txt").exists():
    PICTURES["afm_map"] = ["run", "docs/afm_map.toml"]
NUMBER = re.compile(r"-?\d+(?:\.\d+)?")
TOLERANCE = 0.021


def drawn(command, name, arguments):
    with tempfile.TemporaryDirectory() as folder:
        picture = pathlib.Path(folder) / f"{name}.svg"
        subprocess.run([command, *arguments, "--plot", str(picture), "-o", str(pathlib.Path(folder) / "table")],
                       cwd=ROOT, check=True, stderr=subprocess.DEVNULL)
        return picture.read_text(encoding="utf-8")


def same(one, two, tolerance=TOLERANCE):
    if NUMBER.split(one) != NUMBER.split(two):
        return False
    return all(abs(float(a) - float(b)) <= tolerance for a, b in zip(NUMBER.findall(one), NUMBER.findall(two)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", help="the command fstiff")
    parser.add_argument("--check", action="store_true", help="compare, write nothing")
    options = parser.parse_args()
    command = str(pathlib.Path(options.command).resolve())
    old = []
    for name, arguments in PICTURES.items():
        file = ROOT / "docs" / f"{name}.svg"
        picture = drawn(command, name, arguments)
        if not options.check:
            file.write_text(picture, encoding="utf-8")
        elif not file.exists() or not same(file.read_text(encoding="utf-8"), picture):
            old.append(str(file.relative_to(ROOT)))
    if old:
        sys.exit("not what the command draws: " + ", ".join(old) + "; run tools/make_pictures.py " + options.command)


if __name__ == "__main__":
    main()
