# SPDX-License-Identifier: BSD-3-Clause
"""The error of files, and their names; every other error is a ValueError."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import Any


class FileError(ValueError, OSError):
    """A file that cannot be opened or read: a ValueError and an OSError, with one sentence."""


FileError.__module__ = "fstiff"


def named(file: str | os.PathLike[str], what: str) -> str:
    """The name of a file; ValueError where it is none, or empty, which would else be taken for no file at all."""
    if not isinstance(file, (str, os.PathLike)):
        way_out = "; measure() takes arrays and returns what has this place" if what == "surface" else ""
        raise ValueError(f"{what}: must name a file, not be of type {type(file).__name__}{way_out}")
    name = os.fsdecode(file)
    if not name:
        raise ValueError(f"{what}: is an empty text; must name a file")
    return word(name, what)


def word(given: Any, name: str, such: str = "a text") -> str:
    """A text as the compiled part takes it."""
    if not isinstance(given, str):
        raise ValueError(f"{name}: must be {such}, not of type {type(given).__name__}")
    try:
        given.encode()
    except UnicodeEncodeError:
        raise ValueError(f"{name}: must be a text of Unicode, surrogates not allowed") from None
    return given


def words(given: Any, name: str) -> list[str]:
    """A list of names."""
    if isinstance(given, str) or not isinstance(given, Iterable):
        raise ValueError(f"{name} = {given!r:.60}: must be a list of names")
    return [word(one, name) for one in given]
