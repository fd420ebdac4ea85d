# SPDX-License-Identifier: BSD-3-Clause
"""The error of files; every other one is a ValueError."""


class FileError(ValueError, OSError):
    """A file that cannot be opened or read: a ValueError and an OSError, with one sentence."""


FileError.__module__ = "fstiff"
