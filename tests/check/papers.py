#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What is said of the project outside of its documents agrees with them: codemeta.json with CITATION.cff; paper/paper.md, README.md and
docs/trust.md with docs/accuracy.md, published.md and benchmarks.md, which scripts make.

    papers.py ROOT [--update]    ends with 1 and names what differs; --update writes the figures of the paper
"""

import json
import pathlib
import re
import sys

ACCURACY = """
The documentation compares the bands with boundary elements on maps of {kinds} kinds of surfaces, of which {others} set no error of a law. On these kinds, the band of a
measured map holds the stiffness in {map} % of the cases of each class. Its median width, high over low end, is a factor of {map_width}. The band of a trace holds it in
{trace} %, with widths of {trace_width}, and that of an rms height and an rms gradient in {numbers} %. The kinds that set the errors include harder ones: there the two
numbers hold {worn_set} % of worn faces. Other seeds of all kinds had been seen during development. Where peaks yield, the two numbers hold {yielding_other} % of the
kinds held back and {yielding_calibration} % of the others. With the shape of the heights these are {yielding_other_shape} % and {yielding_calibration_shape} %, with a short
trace {yielding_other_trace} % and {yielding_calibration_trace} %. On a second set, of faces as processes leave them, the band of a map holds {faces_map} %, of a short
trace {faces_trace} %, and of the two numbers {faces_numbers} % of the kinds that set none.

Published simulations of one Gaussian surface lie within the band at all {loads} loads, and `hybrid` is {hybrid} times their stiffness. Of {joints} measured metal joints
the band from metals, process, roughness and area holds a share of {covered} of the points, at a median width of {joint_width}. The form of the faces is counted, and was set on
these joints: of halves that were held back the band held {joints_back}, and of flat faces it would hold {flat}. The integrals agree with references to {integrals} where 1e-12
is asked for, and on usual problems are {faster} times faster than a general routine in one dimension. A contact at a given pressure takes {contact}, and a look-up of a tabulated
law {look_up}, on the machine that the documentation names.
"""

SHARES = {
    "README.md": ("| a map | {map} % of each class of {others} kinds", "{faces_map} % of faces as processes leave them, {grains_map} % of the worst of them, fused",
                  "{skewed} % of skewed ones, {kurtotic} % of kurtotic", "{two} % of two faces, {uneven} % of uneven ones, {plateaus} % of plateaus, {grains} % of grains,"
                  " {worn} % of worn ones |", "| {yielding} %; with skewness and kurtosis {yielding_shape} %; from a short trace {yielding_trace} % |",
                  "| {covered} of the points of {joints} measured metal joints, with a width of {joint_width},",
                  "{steel} points of ground and lapped steel and iron. Were the faces flat: {flat}.", "exact derivative in {tangent}.",
                  "this program costs {linked} times a file with Eigen alone; by itself, with the functions, {alone} times"),
    "docs/trust.md": ("on {map} % of the maps of each class of the {others} kinds", "on {faces_map} % of faces as processes leave them, least on {grains_map} % of fused",
                      "| Gaussian, broad, machined, particles, stretched | {usual} % |", "| skewed | {skewed} % | skewness and kurtosis: {skewed_shape} % |", "| kurtotic | {kurtotic} % | skewness and kurtosis: {kurtotic_shape} % |",
                      "| two faces | {two} % | a map: {two_map} % |", "| grains | {grains} % | a map: {grains_map_both} % |",
                      "| plateau with valleys | {plateaus} % | skewness and kurtosis: {plateaus_shape} %; a map: {plateaus_map} % |",
                      "some places, smooth in others | {uneven} % | skewness and kurtosis: {uneven_shape} %; a map: {uneven_map} % |",
                      "| worn | {worn} % | skewness and kurtosis: {worn_shape} %; a map: {worn_map} % |",
                      "| metals, all classes | {yielding} % | a map: {yielding_map} % |", "with skewness and kurtosis {yielding_shape} %, from a short trace {yielding_trace} %",
                      "Of {joints} measured joints", "the band contains {covered} of the points", "width of {joint_width}; were the faces flat it would contain {flat}.",
                      "steel and iron has {steel} points", "aluminium faces the band contains {air},"),
    "docs/worn-and-lubricated.md": ("contains {worn} % of worn faces and {plateaus} % of plateaus",),
    "docs/accuracy.md": ("The band contains {worn} % of worn faces and {plateaus} % of plateaus", "`kurtosis` it contains {worn_shape} % and {plateaus_shape} %"),
}


def figures(root):
    """The figures of ACCURACY, each as its document has it."""
    accuracy, published, benchmarks, linking = ((root / f"docs/{name}.md").read_text(encoding="utf-8") for name in ("accuracy", "published", "benchmarks", "linking-cpp"))

    def rows_of(heading):
        rows = re.search(rf"{re.escape(heading)}:\n\n((?:\|.*\n)+)", accuracy)[1].splitlines()
        header, _, *cells = [[cell.strip() for cell in row.strip("|").split("|")] for row in rows]
        return [dict(zip(header, cell, strict=True)) for cell in cells]

    def ends(rows, column):
        """The least and greatest share, and the same of the widths."""
        cells = zip(*(re.fullmatch(r"(\d+) %, ([\d.]+)", row[column]).groups() for row in rows), strict=True)
        return [" to ".join(dict.fromkeys(f(cell, key=float) for f in (min, max))) for cell in cells]

    def figure(document, row):
        """The first number of a row, with its unit."""
        return re.search(rf"\| {re.escape(row)} \| ([^|]+?) (?:times [^|]*)?\|", document)[1]

    (every,) = re.findall(r"Maps of (\d+) kinds", accuracy)
    (others,) = re.findall(r"on \d+ kinds with seeds \d+ to \d+; the other (\d+) kinds", accuracy)
    held_back, set_on = rows_of("Other kinds and seeds"), rows_of("Kinds and seeds of the calibration")
    other_faces = rows_of("Kinds that the bands were not set on")
    (of_faces,) = (row for row in other_faces if row["class"] == "all")
    every_row = held_back + set_on + other_faces + rows_of("Kinds that the bands were set on")
    yielding = rows_of("Peaks that yield, by H/(E g), all classes of both halves")
    (loads, hybrid), = re.findall(r"the band covers all (\d+) loads; `hybrid` ([\d.]+ to [\d.]+)", published)
    groups = {group: cells.split(" | ") for group, cells in re.findall(r"(?m)^\| ([^|]+) \| (\d+ \| \d+ of \d+ \| .*) \|$", published)}
    joints, _, covered, joint_width, _, _, flat, _ = groups["**all but aluminium in air**"]
    steel, air = groups["ground and lapped steel and iron"][1], groups["aluminium in air"][1]
    found = {"kinds": every, "others": others, "loads": loads, "hybrid": hybrid, "covered": covered, "joints": joints,
             "joint_width": joint_width, "flat": flat, "steel": steel, "air": air}
    found["map"], found["map_width"] = ends(held_back, "map")
    found["trace"], found["trace_width"] = ends(held_back, "trace")
    found["numbers"], _ = ends(held_back, "height and gradient")
    for key, column in (("map", "map"), ("trace", "short trace"), ("numbers", "height and gradient")):
        found[f"faces_{key}"] = of_faces[column].partition(" %")[0]
    columns = {"": "height and gradient", "_shape": "height, gradient and shape", "_map": "map", "_trace": "short trace"}
    for key, name in (("worn", "worn"), ("kurtotic", "kurtotic"), ("skewed", "skewed"), ("plateaus", "plateau with valleys"), ("uneven", "uneven"),
                      ("grains", "grains"), ("two", "two faces")):
        rows = [row for row in every_row if row["class"] == name]
        found |= {key + end: ends(rows, column)[0] for end, column in columns.items()}
    found |= {f"yielding{end}": ends(yielding, column)[0] for end, column in columns.items()}
    found |= {f"yielding_{half}{end}": ends([row for row in yielding if row["half"] == half], column)[0] for half in ("other", "calibration")
              for end, column in columns.items()}
    found["joints_back"] = re.search(r"of halves that were held back, ([\d.]+ to [\d.]+)\s", published)[1]
    found["usual"], _ = ends([row for row in held_back + set_on if row["class"] in ("Gaussian", "broad", "machined", "particles", "stretched")], columns[""])
    found["grains_map_both"], (found["grains_map"], _) = found["grains_map"], ends([row for row in other_faces if row["class"] == "grains"], "map")
    found["worn_set"], _ = ends([row for row in set_on if row["class"] == "worn"], "height and gradient")
    found |= {name: figure(benchmarks, row) for name, row in (
        ("integrals", "four integrals, hard grid: largest relative error, 1e-12 asked for"), ("faster", "faster than GSL in one dimension"),
        ("contact", "contact: at pressure, all"), ("look_up", "tabulated law, 1e5 to 1e8 Pa: stiffness of pressure, scalar"),
        ("tangent", "tabulated law, 1e5 to 1e8 Pa: pressure and stiffness of gap, scalar"))}
    found |= {name: figure(linking, row) for name, row in (("linked", "the README's program with `fstiff::double`"), ("alone", "the same alone, by `fstiff/answer_inline.hpp`"))}
    return found


def of_paper(root, found, update):
    """The paper has the figures and no other, the sections and the length that the Journal of Open Source Software asks for, and cites
    all of its bibliography."""
    paper = root / "paper/paper.md"
    text = paper.read_text(encoding="utf-8")
    marked = re.compile(r"(?s)(?<=<!-- accuracy -->).*(?=<!-- /accuracy -->)")
    wanted = ACCURACY.format(**found)
    if update:
        paper.write_text(text := marked.sub(lambda _: wanted, text), encoding="utf-8")
    if marked.search(text)[0] != wanted:
        yield "the figures are not those of the documents: run tests/check/papers.py . --update"
    body = text.split("---\n", 2)[2]
    if other := re.findall(r"\S*\d\S*", re.sub(r"\[@.*?\]|C\+\+20|90 %", "", marked.sub("", body))):
        yield f"has figures that no document is compared with: {other}"
    sections = re.findall(r"^# (.*)", body, re.M)
    if missing := [name for name in ("Summary", "Statement of need", "State of the field", "Software design", "Research impact statement",
                                     "AI usage disclosure", "Acknowledgements", "References") if name not in sections]:
        yield f"has no section {missing}"
    if not 750 <= (words := len(re.findall(r"\w[\w'-]*", re.sub(r"<!--.*?-->|\[@.*?\]", "", body)))) <= 1750:
        yield f"has {words} words, not 750 to 1,750"
    cited, entries = set(re.findall(r"@([A-Z]\w+\d{4})", text)), (root / "paper/paper.bib").read_text(encoding="utf-8")
    if cited != (there := set(re.findall(r"^@\w+\{(\w+),", entries, re.M))):
        yield f"cites what paper.bib lacks, or leaves out what it has: {sorted(cited ^ there)}"


def of_pages(root, found):
    """The pages have the shares of SHARES."""
    for page, phrases in SHARES.items():
        text = " ".join((root / page).read_text(encoding="utf-8").split())
        for phrase in phrases:
            if (wanted := " ".join(phrase.format(**found).split())) not in text:
                yield f"{page}: does not have what the documents give: {wanted}"


def of_metadata(root):
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
    root = pathlib.Path(sys.argv[1])
    found = figures(root)
    problems = [f"paper/paper.md: {problem}" for problem in of_paper(root, found, "--update" in sys.argv)]
    problems += [*of_pages(root, found), *of_metadata(root)]
    print("\n".join(problems) or "paper and metadata agree with the documents")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
