#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Puts headers of fstiff, and all that they include, into one file: tools/make_single_header.py -o fstiff.hpp [HEADER]...
With --io fstiff_io.cpp, the readers and writers of files too: one source to compile with the program, which includes fstiff.hpp.

HEADER is a name as in an include, fstiff/contact/rough_contact.hpp; without one, fstiff/fstiff.hpp and fstiff/io.hpp. The includes
are followed depth first, each header is written once, at the place of its first include, and so is each header of Eigen and of
the standard library. The functions of fstiff/answer.hpp, fstiff/implementation.hpp, are under FSTIFF_IMPLEMENTATION, which one
file of a program defines before its include. One licence line is on top. Eigen and C++20 are needed as by the headers apart. The one source reads
neither X3P nor compressed files of Digital Surf, which need other libraries.
"""
import argparse
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = ROOT / "include"
SOURCE = ROOT / "src"
PACKED = ("zip_archive.cpp", "inflate.cpp", "whole_file.cpp")  # need other libraries, or POSIX
DIRECTIVE = re.compile(r"\s*#\s*(include|if|ifdef|ifndef|endif|pragma)\b\s*(.*)")
NAME = re.compile(r"<([^<>]+)>|\"(io/[^\"]+)\"")


class Amalgamation:
    """The text of the files added so far; no header comes twice."""

    def __init__(self):
        self.lines = []
        self.seen = set()
        self.headers = 0

    def add(self, name):
        """Adds the header, its own includes first at their places. Raises ValueError for what cannot be put into one file."""
        if name in self.seen:
            return
        self.seen.add(name)
        own_header = name.startswith("fstiff/")
        text = ((INCLUDE if own_header else SOURCE) / name).read_text(encoding="utf-8").splitlines()
        if name.endswith(".cpp"):
            text.insert(1, "#pragma once")
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
                included = other[1] or other[2]
                if depth and included.startswith("fstiff/double/"):
                    continue  # of the library fstiff::double, which one header does without
                if depth and not included.endswith("pugixml.hpp"):
                    raise ValueError(f"{name}: '{line}': stands under a condition, and would be left out elsewhere")
                if included.startswith("fstiff/") or other[2]:
                    flush()
                    self.add(included)
                    continue
                if included in self.seen and not depth:
                    continue
                self.seen.add(included)
            if line.strip() != "/// \\file":
                own.append(line)
        flush()


def written(title, lines):
    """The file of these lines below its licence and title."""
    version = re.search(r'FSTIFF_VERSION_TEXT "(.+)"', (INCLUDE / "fstiff/core/version.hpp").read_text(encoding="utf-8"))[1]
    copyright_line = re.search(r"^Copyright .*$", (ROOT / "LICENSE").read_text(encoding="utf-8"), re.M)[0]
    body = re.sub(r"\n{3,}", "\n\n", "\n".join(lines))
    return (f"// fstiff {version}. {copyright_line}\n// {title}\n"
            f"// Written by tools/make_single_header.py: change the files of fstiff, not this one.\n\n{body}\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("headers", nargs="*", metavar="HEADER", default=["fstiff/fstiff.hpp", "fstiff/io.hpp"])
    parser.add_argument("-o", "--output", type=pathlib.Path, help="the file to write; without it, the standard output")
    parser.add_argument("--io", type=pathlib.Path, help="the source of fstiff::io to write, beside --output")
    options = parser.parse_args()
    if options.io and not options.output:
        parser.error("--io needs --output, the header that the source includes")
    taken, licence = Amalgamation(), "// SPDX-License-Identifier: BSD-3-Clause\n"
    try:
        for name in options.headers:
            taken.add(name)
        if "fstiff/answer/answer.hpp" in taken.seen:
            seen = set(taken.seen)
            taken.lines += ["#ifdef FSTIFF_IMPLEMENTATION", "#undef FSTIFF_INLINE", "#define FSTIFF_INLINE FSTIFF_COMPILED_HERE"]
            taken.add("fstiff/answer/answer_inline.hpp")
            taken.add("fstiff/answer/measured_face_inline.hpp")
            taken.lines.append("#endif  // FSTIFF_IMPLEMENTATION")
            taken.seen = seen
        title = f"{' and '.join(options.headers)} with all that they include, {taken.headers} headers in one file."
        files = {options.output: licence + "#pragma once\n" + written(title, taken.lines)}
        if options.io:
            taken.lines = [f'#include "{options.output.name}"']
            for path in sorted((SOURCE / "io").glob("*.cpp")):
                if path.name not in PACKED:
                    taken.add(f"io/{path.name}")
            files[options.io] = licence + written("The sources of fstiff::io in one file.", taken.lines)
    except (ValueError, OSError) as error:
        sys.exit(f"make_single_header.py: {error}")
    for path, text in files.items():
        if path:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        else:
            sys.stdout.write(text)


if __name__ == "__main__":
    main()
