#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every relative link of the documents leads to a file of the project, and its #anchor to a heading there, by GitHub's rule.

    links.py ROOT    ends with 1 and names each link that leads nowhere
"""

import pathlib
import re
import sys

FOLDERS = ("", "docs", "paper", "packaging", "examples", "bench", ".github")
FENCED, CODE = re.compile(r"^(```+|~~~+).*?^\1[ \t]*$", re.S | re.M), re.compile(r"(`+)(?:.|\n)*?\1|^(?: {4,}|\t).*$", re.M)
LINK = re.compile(r"\]\(\s*<?([^)\s>]+)>?(?:\s+\"[^\"]*\")?\s*\)|^\[[^\]]+\]:\s*(\S+)", re.M)
HEADING = re.compile(r"^#{1,6}[ \t]+(.*?)[ \t]*#*[ \t]*$", re.M)


def blank(found):
    return re.sub(r"[^\n]", " ", found[0])


def anchor_names(titles):
    """The anchors of headings: their words in small letters, joined by hyphens, and numbered where one comes again."""
    found = set()
    for title in titles:
        title = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", title)
        name = re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")
        count = 0
        while (one := f"{name}-{count}" if count else name) in found:
            count += 1
        found.add(one)
        yield one


def anchors(text):
    return set(anchor_names(HEADING.findall(FENCED.sub(blank, text))))


def problems(root):
    documents = sorted(path for folder in FOLDERS for path in (root / folder).glob("**/*.md" if folder else "*.md"))
    known, count = {}, 0
    for document in documents:
        text = document.read_text(encoding="utf-8")
        for found in LINK.finditer(CODE.sub(blank, FENCED.sub(blank, text))):
            link = found[1] or found[2]
            if re.match(r"[a-z][a-z0-9+.-]*:", link):
                continue
            count += 1
            where = f"{document.relative_to(root).as_posix()}:{text.count(chr(10), 0, found.start()) + 1}: {link}"
            name, _, anchor = link.partition("#")
            target = (document.parent / name).resolve() if name else document.resolve()
            if not target.exists() or root.resolve() not in (target, *target.parents):
                yield f"{where}: there is no such file"
            elif anchor and target.suffix == ".md":
                if target not in known:
                    known[target] = anchors(target.read_text(encoding="utf-8"))
                if anchor not in known[target]:
                    yield f"{where}: there is no such heading"
            elif anchor and not re.fullmatch(r"L\d+(-L\d+)?", anchor):
                yield f"{where}: only headings of documents and lines have anchors"
    print(f"{count} links in {len(documents)} documents")


def main(root):
    if not root.is_dir() or not (root / "docs").is_dir():
        sys.exit(f"{root}: must be the root of the project")
    found = list(problems(root))
    print(*found, sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
