# SPDX-License-Identifier: BSD-3-Clause
"""Whether two programs print the same, up to the last digits of numbers."""
import re

NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
TOLERANCE, OF_ERRORS = 1e-13, 1e-6  # numerical errors are differences of nearly equal numbers


def numbers_of(text):
    """The numbers of a text, each with the key of JSON or the column of CSV that it stands in."""
    key, names = "", text[:text.find("\n")].split(",")
    if text.startswith("{"):
        for found in re.finditer(rf'"([^"]+)": ?|({NUMBER.pattern})', text):
            key = found[1] or key
            if found[2]:
                yield key, float(found[2])
        return
    for line in text.splitlines():
        cells = line.split(",")
        for i, cell in enumerate(cells):
            for number in NUMBER.findall(cell):
                yield names[i] if len(cells) == len(names) else "", float(number)


def difference(a, b, tolerance=TOLERANCE, of_one=(), of_errors=OF_ERRORS):
    """What two texts differ in beyond the tolerance, or "". What stands under the keys of_one is compared
    with 1."""
    if NUMBER.sub("#", a) != NUMBER.sub("#", b):
        return "in words"
    for (key, x), (_, y) in zip(numbers_of(a), numbers_of(b), strict=True):
        size = 1 if key in of_one else max(abs(x), abs(y))
        if abs(x - y) > (of_errors if "error" in key else tolerance) * size:
            return f"{key} {x} {y}"
    return ""
