# SPDX-License-Identifier: BSD-3-Clause
"""The answer and the curves of a scene, as a table.

It is that of `fstiff run`, which reads the scene; a surface may have any form that fstiff or SurfaceTopography reads.
"""

from __future__ import annotations

import argparse

from ._scenes import run


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("scene", nargs="?", help="scene file (TOML); without it the built-in scene")
    parser.add_argument("--surface", metavar="FILE", help="profile, map, or JSON of fstiff measure, in place of the scene's [surface]")


def execute(arguments: argparse.Namespace) -> int:
    curves = run(arguments.scene, surface=arguments.surface)
    print(curves)
    return 4 if curves.doubtful else 0
