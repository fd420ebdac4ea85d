#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Puts headers of fstiff, and all that they include, into one file: tools/make_single_header.py -o fstiff.hpp [HEADER]...

HEADER is a name as in an include, fstiff/contact/rough_contact.hpp; without one, fstiff/fstiff.hpp and fstiff/io.hpp. The includes
are followed depth first, each header is written once, where the first include of it stood, and so is each header of Eigen and of
the standard library. One licence line stands on top. Eigen and C++20 are needed as by the headers apart.
"""
import argparse
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = ROOT / "include"
DIRECTIVE = re.compile(r"\s*#\s*(include|if|ifdef|ifndef|endif|pragma)\b\s*(.*)")
NAME = re.compile(r"<([^<>]+)>")


class Amalgamation:
    """The text of the headers added so far; no header comes twice."""

    def __init__(self):
        self.lines = []
        self.seen = set()
        self.headers = 0

    def add(self, name):
        """Adds the header, its own includes first where they stand. Raises ValueError for what cannot be put into one file."""
        if name in self.seen:
            return
        self.seen.add(name)
        text = (INCLUDE / name).read_text(encoding="utf-8").splitlines()
        if not text[0].startswith("// SPDX-License-Identifier: BSD-3-Clause") or text[1] != "#pragma once":
            raise ValueError(f"{name}: must begin with the licence line and #pragma once")
        self.headers += 1
        own = []  # lines since the last header that was written
        depth = 0  # of #if

        def flush():
            if any(line.strip() for line in own):
                self.lines += [f"// ---- {name}"] + own
            own.clear()

        for line in text[2:]:
            directive = DIRECTIVE.match(line)
            word = directive[1] if directive else ""
            depth += word in ("if", "ifdef", "ifndef")
            depth -= word == "endif"
            if word == "include":
                other = NAME.match(directive[2])
                if not other:
                    raise ValueError(f"{name}: '{line}': an include must stand in angle brackets")
                if depth:
                    raise ValueError(f"{name}: '{line}': stands under a condition, and would be left out elsewhere")
                if other[1].startswith("fstiff/"):
                    flush()
                    self.add(other[1])
                    continue
                if other[1] in self.seen:
                    continue
                self.seen.add(other[1])
            if line.strip() != "/// \\file":
                own.append(line)
        flush()


def single_header(names):
    """One header that holds those of these names and all that they include."""
    amalgamation = Amalgamation()
    for name in names:
        amalgamation.add(name)
    version = re.search(r'FSTIFF_VERSION "(.+)"', (INCLUDE / "fstiff/core/version.hpp").read_text(encoding="utf-8"))[1]
    copyright_line = re.search(r"^Copyright .*$", (ROOT / "LICENSE").read_text(encoding="utf-8"), re.M)[0]
    body = re.sub(r"\n{3,}", "\n\n", "\n".join(amalgamation.lines))
    return (f"// SPDX-License-Identifier: BSD-3-Clause\n#pragma once\n// fstiff {version}. {copyright_line}\n"
            f"// {' and '.join(names)} with all that they include, {amalgamation.headers} headers in one file.\n"
            f"// Written by tools/make_single_header.py: change the headers, not this file.\n\n{body}\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("headers", nargs="*", metavar="HEADER", default=["fstiff/fstiff.hpp", "fstiff/io.hpp"])
    parser.add_argument("-o", "--output", type=pathlib.Path, help="the file to write; without it, the standard output")
    options = parser.parse_args()
    try:
        text = single_header(options.headers)
    except (ValueError, OSError) as error:
        sys.exit(f"make_single_header.py: {error}")
    if options.output:
        options.output.parent.mkdir(parents=True, exist_ok=True)
        options.output.write_text(text, encoding="utf-8")
    else:
        sys.stdout.write(text)


if __name__ == "__main__":
    main()
