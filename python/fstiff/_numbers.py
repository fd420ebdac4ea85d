# SPDX-License-Identifier: BSD-3-Clause
"""The numbers of a joint as keywords: the fields of the library, by its names."""

from __future__ import annotations

import inspect
from collections.abc import Iterable, Sequence
from typing import Any

from . import _core

#: The numbers of a joint by their names and by the words of drawings, such as "Ra", which go with the name: the fields of
#: the library. Each has its SI unit, its meaning and its name.
NUMBERS = _core.numbers_of_joint()
FACE, BODY = NUMBERS["face"], NUMBERS["body"]
#: Names of older programs.
RENAMED = {"height": "rms_height", "gradient": "rms_gradient", "area": "nominal_area"}


def require_known(given: Iterable[str], known: Sequence[str], where: str = "") -> None:
    """Refuses a name that is none of `known`."""
    for name in given:
        if name in RENAMED and name not in known:
            raise ValueError(f"{where}{name}: is called {RENAMED[name]}")
        if name not in known:
            raise ValueError(f"{where}{name}: must be one of {', '.join(known)}")


def with_names(of: Any, function: Any) -> None:
    """Gives `of` the numbers of a face as keywords in its signature, that of `function`, and in its text."""
    signature = inspect.signature(function)
    kept = [each for each in signature.parameters.values() if each.kind is not inspect.Parameter.VAR_KEYWORD and each.name != "self"]
    named = [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=None, annotation=Any) for name in FACE]
    of.__signature__ = signature.replace(parameters=kept + named)
    words = {name: [word for word, (_, _, main) in FACE.items() if main == name != word] for name in FACE}
    lines = [
        f"{name:<20}{meaning}{f' [{unit}]' if unit else ''}{', or ' + ', '.join(words[name]) if words[name] else ''}"
        for name, (unit, meaning, main) in FACE.items()
        if name == main
    ]
    of.__doc__ = (of.__doc__ or "").replace("{numbers}", "\n    ".join(lines))
