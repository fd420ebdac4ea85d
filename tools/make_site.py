#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The documents as a folder of pages that any server shows as it is, and a browser from a disk: no page needs the network.

    tools/make_site.py FOLDER [--page FOLDER] [--reference FOLDER]
                                    writes README.md, the pages of docs and all that they link to into FOLDER, with a search by titles, and
                                    there page/ and reference/: what the targets web and reference have made; then checks the links
    tools/make_site.py --check FOLDER

It needs markdown-it-py (pip; Debian: python3-markdown-it). The check refuses relative links to files or #anchors that are not there, and what a
browser would fetch from elsewhere: scripts, styles, pictures.
"""
import argparse
import functools
import html
import html.parser
import json
import pathlib
import re
import shutil
import sys
import urllib.parse

from generated import ROOT

sys.path.insert(0, str(ROOT / "tests/check"))
from links import anchor_names  # noqa: E402

ASSETS = ROOT / "tools/site"
BEGIN = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", *sorted(path.relative_to(ROOT).as_posix() for path in (ROOT / "docs").glob("*.md"))]
TEMPLATE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<link rel="stylesheet" href="{up}site.css">
</head>
<body>
<header><nav>{doors}</nav><input id="search" type="search" placeholder="Search titles" aria-label="Search titles"><ul id="found"></ul></header>
<main>
{body}</main>
<script src="{up}titles.js"></script>
<script src="{up}search.js" data-root="{up}"></script>
</body>
</html>
"""


def address(name):
    """The page of a document."""
    return re.sub(r"(^|/)README\.md$", r"\1index.md", name).removesuffix(".md") + ".html"


def lead(token, folder, documents, files):
    """Turns a link of a document to the page of another, and notes what it leads to; the end of a link to a folder without a page is no link."""
    key = "src" if token.type == "image" else "href"
    parts = urllib.parse.urlsplit(token.attrs[key])
    if parts.scheme or not parts.path:
        return
    target = (folder / parts.path).resolve()
    if target.is_dir():
        target /= "README.md"
        if not target.exists():
            token.tag, token.attrs = "span", {}
            return
    name = target.relative_to(ROOT).as_posix()
    if not name.endswith(".md"):
        files.add(name)
        token.attrs[key] = parts.path
        return
    if name not in documents:
        documents.append(name)
    steps = [".."] * len(folder.relative_to(ROOT).parts)
    token.attrs[key] = "/".join([*steps, address(name)]) + ("#" + parts.fragment if parts.fragment else "")


def page(markdown, name, documents, files):
    """The body of the page of a document, and its headings: level, anchor, title."""
    path, titles = ROOT / name, []
    tokens = markdown.parse(path.read_text(encoding="utf-8"))
    headings = [i for i, token in enumerate(tokens) if token.type == "heading_open"]
    for i, anchor in zip(headings, anchor_names(tokens[i + 1].content for i in headings)):
        tokens[i].attrs["id"] = anchor
        text = "".join(child.content for child in tokens[i + 1].children if child.type in ("text", "code_inline"))
        titles.append((int(tokens[i].tag[1:]), anchor, text))
    for token in tokens:
        opened = []
        for child in token.children or []:
            if child.type == "link_open":
                opened.append(child)
            if child.type in ("link_open", "image"):
                lead(child, path.parent, documents, files)
            if child.type == "link_close":
                child.tag = opened.pop().tag
    return markdown.renderer.render(tokens, markdown.options, {}), titles


def write(folder, given):
    try:
        from markdown_it import MarkdownIt
    except ImportError:
        sys.exit("tools/make_site.py needs markdown-it-py (pip install markdown-it-py; Debian: python3-markdown-it)")
    markdown = MarkdownIt("commonmark").enable("table")
    no_remark = lambda renderer, tokens, i, options, env: "" if tokens[i].content.startswith("<!--") else tokens[i].content
    for what, rule in (("html_block", no_remark), ("html_inline", no_remark), ("table_open", lambda *_: '<div class="table"><table>\n'),
                       ("table_close", lambda *_: "</table></div>\n")):
        markdown.add_render_rule(what, rule)
    documents, files, found = list(BEGIN), set(), []
    doors = {"index.html": "fstiff", "docs/index.html": "Documentation"}
    for name, (source, title) in given.items():
        shutil.copytree(source, folder / name, dirs_exist_ok=True)
        doors[f"{name}/index.html"] = title
    for name in documents:  # grows
        body, titles = page(markdown, name, documents, files)
        up = "../" * name.count("/")
        title = titles[0][2] if titles else name
        found += [(level, [address(name) + f"#{anchor}" * (level > 1), text, title]) for level, anchor, text in titles if level < 4]
        target = folder / address(name)
        target.parent.mkdir(parents=True, exist_ok=True)
        links = " · ".join(f'<a href="{up}{door}">{what}</a>' for door, what in doors.items())
        target.write_text(TEMPLATE.format(title=html.escape(title), up=up, doors=links, body=body), encoding="utf-8")
    for name in sorted(files):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / name, folder / name)
    for asset in ASSETS.iterdir():
        shutil.copyfile(asset, folder / asset.name)
    titles = ",\n".join(json.dumps(row, ensure_ascii=False) for _, row in sorted(found, key=lambda one: one[0]))
    (folder / "titles.js").write_text(f"const titles = [\n{titles}\n];\n", encoding="utf-8")


class Links(html.parser.HTMLParser):
    """The links of a page, its anchors, and what a browser fetches for it."""

    def __init__(self, text):
        super().__init__()
        self.links, self.anchors, self.fetched = [], set(), []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for key, value in attributes:
            if key == "id" or (key == "name" and tag == "a"):
                self.anchors.add(value)
            elif value and (key in ("src", "href", "xlink:href") or (key, tag) == ("data", "object")):
                self.links.append((self.getpos()[0], value))
                if tag != "a":
                    self.fetched.append((self.getpos()[0], value))


@functools.cache
def parsed(path):
    return Links(path.read_text(encoding="utf-8", errors="replace"))


def problems(folder):
    """Each link of the pages that leads nowhere, and each that fetches from elsewhere."""
    for path in sorted(folder.rglob("*.html")):
        where, links = path.relative_to(folder).as_posix(), parsed(path)
        for line, link in links.fetched:
            if re.match(r"(https?:)?//", link):
                yield f"{where}:{line}: {link}: is fetched from elsewhere"
        for line, link in links.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc or (where.startswith("reference/") and link == "#nested-classes"):  # Doxygen 1.9 has no such anchor
                continue
            target = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            if link.startswith("/") or folder not in target.parents or not target.is_file():
                yield f"{where}:{line}: {link}: there is no such file"
            elif parts.fragment and target.suffix == ".html" and urllib.parse.unquote(parts.fragment) not in parsed(target).anchors:
                yield f"{where}:{line}: {link}: there is no such anchor"
    for path in sorted(folder.rglob("*.css")):
        for found in re.findall(r"(?:@import|url\()\s*[\"']?(?:https?:)?//[^\s\"')]*", path.read_text(encoding="utf-8", errors="replace")):
            yield f"{path.relative_to(folder).as_posix()}: {found}: is fetched from elsewhere"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--check", action="store_true")
    given = {"page": "In the browser", "reference": "Reference of the headers"}
    for name in given:
        parser.add_argument(f"--{name}", type=pathlib.Path)
    options = parser.parse_args()
    folder = options.folder.resolve()
    if not options.check:
        if folder.exists() and any(folder.iterdir()) and not (folder / "titles.js").exists():
            sys.exit(f"{options.folder}: is not a site, and not empty")
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        write(folder, {name: (getattr(options, name), title) for name, title in given.items() if getattr(options, name)})
    pages = list(folder.rglob("*.html"))
    if not pages:
        sys.exit(f"{options.folder}: has no pages")
    found = list(problems(folder))
    print(*found, f"{sum(len(parsed(path).links) for path in pages)} links in {len(pages)} pages", sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
