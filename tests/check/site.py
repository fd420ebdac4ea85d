#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""tools/make_site.py makes a folder whose links lead somewhere; its check refuses those that do not, and what comes from elsewhere; and, where
there is Chromium, its search finds titles on a page from a disk, which fetches files of the folder alone.

    site.py --work FOLDER --venv VENV    uses the Python of VENV where that has markdown-it-py
"""
import argparse
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/web"))
import browser  # noqa: E402

BAD = (("docs/scene.html", '<a href="no.html">', "docs/scene.html:", "no.html: there is no such file"),
       ("docs/scene.html", '<a href="band.html#no">', "band.html#no: there is no such anchor"),
       ("index.html", '<a href="#no">', "#no: there is no such anchor"),
       ("index.html", '<a href="/docs/scene.html">', "/docs/scene.html: there is no such file"),
       ("index.html", '<a href="../outside.html">', "../outside.html: there is no such file"),
       ("index.html", '<script src="https://example.org/a.js">', "a.js: is fetched from elsewhere"),
       ("index.html", '<img src="//example.org/a.png">', "a.png: is fetched from elsewhere"),
       ("site.css", "@font-face { src: url(https://example.org/a.woff) }", "a.woff: is fetched from elsewhere"))


def search(folder):
    """The titles that the search lists, and what the page has fetched."""
    with browser.Page((folder / "docs/scene.html").as_uri()) as page:
        lines = page.run("""(() => { const field = document.getElementById("search"); field.value = "STIFFNESS  of";
            field.dispatchEvent(new Event("input")); return [...document.querySelectorAll("#found a")].map((a) => [a.textContent, a.href]); })()""")
        fetched = [event["params"]["request"]["url"] for event in page.events if event["method"] == "Network.requestWillBeSent"]
    return lines, fetched


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--work", type=pathlib.Path, required=True)
    parser.add_argument("--venv", type=pathlib.Path, required=True)
    options = parser.parse_args()
    has = lambda python: shutil.which(python) and subprocess.run([python, "-c", "import markdown_it"], capture_output=True).returncode == 0
    python = next(filter(has, (options.venv / "bin/python", sys.executable)), None)
    if not python:
        print("SKIPPED: there is no markdown-it-py (pip install markdown-it-py)")
        return
    work, folder = options.work.resolve(), options.work.resolve() / "site"
    for name in ("page", "reference"):  # in place of those that take minutes
        (work / name).mkdir(parents=True, exist_ok=True)
        (work / name / "index.html").write_text('<a href="../index.html">fstiff</a>')
    make = lambda *words: subprocess.run([python, ROOT / "tools/make_site.py", folder, *words], capture_output=True, text=True)
    done = make("--page", work / "page", "--reference", work / "reference")
    assert done.returncode == 0, done.stdout + done.stderr
    print(done.stdout)
    for path in (ROOT / "docs").glob("*.*"):
        shown = folder / "docs" / ("index.html" if path.name == "README.md" else path.name.replace(".md", ".html"))
        assert path.suffix != ".md" or shown.is_file(), f"{path.name} has no page"
    assert '"docs/scene.html#how-values-are-written"' in (folder / "titles.js").read_text()
    for name, more, *sentences in BAD:
        text = (folder / name).read_text()
        (folder / name).write_text(text + more)
        done = make("--check")
        (folder / name).write_text(text)
        assert done.returncode == 1 and all(sentence in done.stdout for sentence in sentences), f"{more}: {done.stdout}{done.stderr}"
    (work / "page/mine.txt").write_text("mine")
    done = subprocess.run([python, ROOT / "tools/make_site.py", work / "page"], capture_output=True, text=True)
    assert done.returncode != 0 and "is not a site" in done.stderr and (work / "page/mine.txt").exists(), done.stderr
    if not browser.find():
        print("Chromium is missing: the search is not tried")
        return
    lines, fetched = search(folder)
    pages = {path.as_uri() for path in folder.rglob("*.html")}
    assert lines and all("stiffness" in title.lower() and "of" in title and url.partition("#")[0] in pages for title, url in lines), lines
    assert fetched and all(url.startswith(folder.as_uri()) for url in fetched), fetched
    print(f"titles with both words: {len(lines)}; the page fetched {len(fetched)} files of the folder")


if __name__ == "__main__":
    main()
