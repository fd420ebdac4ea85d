# SPDX-License-Identifier: BSD-3-Clause
"""Report of a scene as one HTML file, with its pictures inside."""

from __future__ import annotations

import argparse


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("scene", nargs="?", help="scene file (TOML)")


def execute(arguments: argparse.Namespace) -> int:
    raise NotImplementedError
