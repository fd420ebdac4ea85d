# SPDX-License-Identifier: BSD-3-Clause
"""The error of files, and their names; every other error is a ValueError."""

from __future__ import annotations

import os


class FileError(ValueError, OSError):
    """A file that cannot be opened or read: a ValueError and an OSError, with one sentence."""


FileError.__module__ = "fstiff"


def named(file: str | os.PathLike[str], what: str) -> str:
    """The name of a file; ValueError where it is empty, which would else be taken for no file at all."""
    name = os.fspath(file)
    if not name:
        raise ValueError(f"{what}: is an empty text; must name a file")
    return name
