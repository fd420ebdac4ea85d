# SPDX-License-Identifier: BSD-3-Clause
"""The figures, tables and conclusions of the reference paper, into a folder."""

from __future__ import annotations

import argparse


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("folder", metavar="FOLDER", help="for the figures and index.html; made when missing")


def execute(arguments: argparse.Namespace) -> int:
    raise NotImplementedError
