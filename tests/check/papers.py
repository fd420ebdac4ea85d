#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What is said of the project outside of its documents agrees with them: codemeta.json with CITATION.cff, paper/paper.md with
docs/accuracy.md.

    papers.py ROOT [--update]    ends with 1 and names what differs; --update writes the figures of the paper
"""

import json
import pathlib
import re
import sys


def range_of(table, column, form):
    """The share and the width of one column over the classes: least and largest."""
    header, _, *rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in table]
    cells = [row[header.index(column)] for row in rows]
    shares, widths = zip(*(re.fullmatch(r"(\d+) %, ([\d.]+)", cell).groups() for cell in cells), strict=True)
    return form.format(min(shares, key=int), max(shares, key=int), min(widths, key=float), max(widths, key=float))


def accuracy(root):
    text = (root / "docs/accuracy.md").read_text(encoding="utf-8")
    table = re.search(r"Other kinds and seeds:\n\n((?:\|.*\n)+)", text)[1].splitlines()
    return "\n" + range_of(table, "map", "a measured map holds the stiffness in {} % to {} % of the cases of each class of surfaces, and its "
                           "median width, high over low end, is a factor of {} to {}; ") + range_of(
                               table, "trace", "that of a trace holds it in {} % to {} %, with widths of {} to {}.") + "\n"


def differences(root, update):
    paper = root / "paper/paper.md"
    marked = re.compile(r"(?s)(?<=<!-- accuracy -->).*(?=<!-- /accuracy -->)")
    text = paper.read_text(encoding="utf-8")
    if update:
        paper.write_text(text := marked.sub(accuracy(root), text), encoding="utf-8")
    if marked.search(text)[0] != accuracy(root):
        yield "paper/paper.md: the figures are not those of docs/accuracy.md: run tests/check/papers.py . --update"
    cited, entries = set(re.findall(r"@([A-Z]\w+\d{4})", text)), (root / "paper/paper.bib").read_text(encoding="utf-8")
    if cited != (there := set(re.findall(r"^@\w+\{(\w+),", entries, re.M))):
        yield f"paper/paper.bib: entries differ from what paper.md cites: {sorted(cited ^ there)}"
    citation = (root / "CITATION.cff").read_text(encoding="utf-8")
    meta = json.loads((root / "codemeta.json").read_text(encoding="utf-8"))
    (article,) = meta["referencePublication"]
    for what, key, found in (("version", r"^version: (.*)", meta["version"]),
                             ("licence", r"^license: (.*)", meta["license"].rsplit("/", 1)[1]),
                             ("name and description", r'^title: "(.*)"', f"{meta['name']}: {meta['description'].lower()}"),
                             ("author", r'^  - name: "(.*)"', meta["author"][0]["name"]),
                             ("article", r'^    title: "(.*)"', article["name"]),
                             ("authors of the article", r"^      - family-names: (.*)", [one.split(",")[0] for one in article["author"]]),
                             ("journal", r'^    journal: "(.*)"', article["isPartOf"]["name"]),
                             ("volume", r"^    volume: (.*)", article["isPartOf"]["volumeNumber"]),
                             ("year", r"^    year: (.*)", article["isPartOf"]["datePublished"])):
        if (wanted := re.findall(key, citation, re.M)) != (found if isinstance(found, list) else [found]):
            yield f"codemeta.json: {what}: {found}, but CITATION.cff has {wanted}"


def main():
    problems = list(differences(pathlib.Path(sys.argv[1]), "--update" in sys.argv))
    print("\n".join(problems) or "paper and metadata agree with the documents")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
