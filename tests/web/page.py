#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The page of the target web, in headless Chromium, against the command: the same numbers, and whatever docs/web.md promises.

    page.py --source . --build build/release --fstiff build/release/bin/fstiff
"""
import argparse
import base64
import functools
import http.server
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import threading

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent / "check"))
import browser
import same_numbers

# Shares and correlations are parts of 1.
difference = functools.partial(same_numbers.difference, of_one=("matrix", "measurement", "cut_offs", "shape", "prior", "law"))

# Plastic boundary elements end where their own tolerance does: K agreed to 1e-12, the separation to 4e-9; an error of K, which is
# 4e-10 K there, to 1e-5 of itself, the rounding of K.
ITERATED = {"tolerance": 1e-7, "of_errors": 1e-4}
problems = []
ANSWERED = ("(e => !e.hidden && 'milliseconds' in e.dataset)(document.getElementById('answer')) "
            "&& document.getElementById('working').hidden")
REFUSED = "!document.getElementById('problem').hidden && document.getElementById('working').hidden"


def check(holds, what):
    if not holds:
        problems.append(what)


class Desk:
    """The command, a folder for it, and the page at \\p url."""

    def __init__(self, fstiff, folder, url):
        self.fstiff, self.folder, self.url = fstiff, folder, url

    def command(self, *words):
        return subprocess.run([self.fstiff, *words], cwd=self.folder, capture_output=True, check=False)

    def page(self, **how):
        return browser.Page(self.url, **how)


def text(page, name):
    return page.run(f"document.getElementById('{name}').textContent")


def click(page, name):
    page.run(f"document.getElementById('{name}').click()")


def fill(page, name, value):
    page.run(f"(e => {{ e.value = {value!r}; e.dispatchEvent(new Event('input', {{bubbles: true}})); }})"
             f"(document.getElementById('{name}'))")


def done(page, holds=ANSWERED):
    page.wait(lambda: page.run(holds) or (page.run(REFUSED) and holds is ANSWERED), "the page does not answer")
    if holds is ANSWERED and page.run(REFUSED):
        raise RuntimeError(text(page, "problem"))


def answer_to(page, act):
    """Waits for a new answer after \\p act. The old one stays on the page: hidden, it would take the focus from its button."""
    page.run("delete document.getElementById('answer').dataset.milliseconds")
    act()
    done(page)


def download(page, name):
    return page.download(f"[...document.querySelectorAll('#downloads a')].find(a => a.download == {name!r})")


def compare(desk, page, what, **tolerances):
    """The downloads of the page are what the command makes of its scene."""
    (desk.folder / "scene.toml").write_bytes(download(page, "scene.toml"))
    made = desk.command("run", "scene.toml", "--format", "json", "--plot", "own.svg")
    check(made.returncode in (0, 4), f"{what}: {made.stderr!r}")
    apart = difference(made.stdout.decode(), download(page, "answer.json").decode(), **tolerances)
    check(not apart, f"{what}: the answer differs: {apart}")
    apart = difference((desk.folder / "own.svg").read_text(), download(page, "picture.svg").decode())
    check(not apart or "in words" not in apart, f"{what}: the picture differs: {apart}")


def first_curve(desk, source):
    document = (source / "docs/first-curve.md").read_text(encoding="utf-8")
    scene = re.search(r"```toml\n(.*?)```", document, re.S)[1]
    shown = re.findall(r"^ +([\d.]+) MPa +([\d.]+) +([\d.]+–[\d.]+) +([\d.]+) +(\w+) +(.*\S)$", document, re.M)
    check(len(shown) == 2, "docs/first-curve.md shows no answer")
    with desk.page() as page:
        fill(page, "scene", scene)
        click(page, "run-scene")
        done(page)
        cells = page.run("[...document.querySelectorAll('#table tbody tr')].map(r => [...r.cells].map(c => c.textContent))")
        check(cells == [list(row) for row in shown], f"docs/first-curve.md shows {shown}, the page {cells}")
        compare(desk, page, "docs/first-curve.md")
        (desk.folder / "dropped.toml").write_text(scene)
        answer_to(page, lambda: page.choose(desk.folder / "dropped.toml"))
        check(shown and shown[0][1] in text(page, "table"), "a scene that is dropped gives no answer")


def surfaces(desk, figures):
    desk.command("generate", "map", "--points", "256", "--spacing", "1 um", "--hurst", "0.8", "--rms", "1 um", "--longest",
                 "64 um", "-o", "map ü.csv")
    desk.command("generate", "profile", "--points", "4096", "--spacing", "1 um", "--hurst", "0.8", "--rms", "1 um", "-o",
                 "trace.csv")
    with desk.page() as page:
        page.choose(desk.folder / "map ü.csv")
        done(page)
        figures["a map of 256², milliseconds to the answer"] = page.run("+document.getElementById('answer').dataset.milliseconds")
        measured = "map ü.csv.measured.json"
        own = desk.command("measure", "map ü.csv", "--format", "json").stdout
        apart = difference(own.decode(), download(page, measured).decode())
        check(not apart, f"the measurement differs: {apart}")
        (desk.folder / measured).write_bytes(download(page, measured))
        compare(desk, page, "a map")
        page.run("document.getElementById('upper').value = 'copper'")
        page.run("document.getElementById('lower').value = 'rigid'")
        fill(page, "hardness", "1.1")
        answer_to(page, lambda: click(page, "compute"))
        check("loading" in text(page, "table"), "a hardness changes nothing")
        compare(desk, page, "a map of copper on a rigid body")
        answer_to(page, lambda: page.choose(desk.folder / "trace.csv"))
        compare(desk, page, "a profile")


def boundary_elements(desk, figures):
    with desk.page() as page:
        page.choose(desk.folder / "map ü.csv")
        done(page)
        page.run("""window.bars = []; new MutationObserver(() => bars.push([document.getElementById('left').textContent,
                    document.getElementById('bar').value])).observe(document.getElementById('left'), {childList: true})""")
        begun = page.run("performance.now()")
        answer_to(page, lambda: click(page, "solve"))
        figures["boundary elements of 128² at 4 pressures, milliseconds"] = round(page.run("performance.now()") - begun)
        check("boundary elements" in text(page, "table"), "no boundary elements in the answer")
        bars = page.run("bars")
        check(len(bars) > 2 and all(0 <= value <= 1 for _, value in bars), f"progress: {bars}")
        compare(desk, page, "boundary elements of 128²", **ITERATED)
        page.run("document.getElementById('points').value = '256'; bars.length = 0")
        fill(page, "hardness", "3")
        click(page, "solve")
        page.wait(lambda: page.run("bars.some(([words, share]) => words.startsWith('pieces') && share > 0)"),
                  "no progress of boundary elements", 60)
        click(page, "stop")
        done(page, REFUSED)
        check(text(page, "problem") == "Stopped.", f"stop: {text(page, 'problem')}")
        answer_to(page, lambda: click(page, "solve"))
        compare(desk, page, "boundary elements of 256², after a stop", **ITERATED)
        answer_to(page, lambda: (click(page, "solve"), click(page, "compute")))
        check("boundary elements" not in text(page, "table"), "two computations at once: not the latest is shown")


def refusals(desk):
    files = {"wrong.csv": b"not a surface\nhello\n", "empty.csv": b"", "packed.x3p": b"PK\x03\x04" + bytes(60),
             "picture.png": b"\x89PNG\r\n\x1a\n" + bytes(60), "wrong.toml": b"[surface]\nrms_height = 3\n"}
    plain = desk.command("generate", "map", "--points", "64", "--spacing", "1 um", "--hurst", "0.8", "--rms", "1 um").stdout
    files["plain.txt"] = b"".join(line for line in plain.splitlines(True) if not line.startswith(b"#"))
    with desk.page() as page:
        click(page, "compute")
        done(page, REFUSED)
        check("No surface is chosen" in text(page, "problem"), "no surface, and no word about it")
        for name, content in files.items():
            (desk.folder / name).write_bytes(content)
            page.run("document.getElementById('problem').hidden = true")
            page.choose(desk.folder / name)
            done(page, REFUSED)
            sentence = text(page, "problem")
            words = desk.command(*(("run",) if name.endswith(".toml") else ("measure",)), name).stderr.decode().strip()
            same = sentence == words.removeprefix("fstiff: ") or name in ("packed.x3p", "wrong.toml")
            check(same and name.removeprefix("wrong.toml") in sentence and len(sentence) < 600, f"{name}: {sentence}")
            check(page.run("document.getElementById('answer').hidden"), f"{name}: an answer all the same")
        page.choose(desk.folder / "plain.txt")
        done(page, REFUSED)
        check(page.run("document.getElementById('reading').open"), "the options of reading are not shown")
        for field, value in {"units": "m", "dx": "1 um", "dy": "1 um"}.items():
            fill(page, field, value)
        answer_to(page, lambda: click(page, "compute"))


def keyboard(desk):
    with desk.page() as page:
        def go_to(name):
            for _ in range(60):
                page.press("Tab")
                if page.run("document.activeElement.id") == name:
                    style = page.run("getComputedStyle(document.activeElement).outlineStyle")
                    check(style != "none", f"the focus on {name} cannot be seen")
                    return
            raise RuntimeError(f"Tab does not reach {name}")

        go_to("file")
        go_to("example")
        page.press("Enter")
        done(page)
        go_to("pressures")
        page.press(None, "50, 80")  # in place of what is there
        answer_to(page, lambda: page.press("Enter"))
        go_to("solve")
        answer_to(page, lambda: page.press("Enter"))
        check("boundary elements" in text(page, "table"), "no boundary elements by the keyboard")
        for name in ("print", "scene", "run-scene"):
            page.run("document.getElementById('scene-part').open = true")
            go_to(name)
        nameless = page.run("[...document.querySelectorAll('input, select, textarea')].filter(e => !e.labels.length).length")
        check(nameless == 0, f"{nameless} fields have no label")


def looks(desk):
    ratio = """(pair => { const light = c => { const [r, g, b] = c.match(/\\d+/g).slice(0, 3).map(v => (v /= 255) <= 0.03928
        ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4); return 0.2126 * r + 0.7152 * g + 0.0722 * b + 0.05; };
        const [a, b] = pair.map(light); return Math.max(a, b) / Math.min(a, b); })"""
    for dark in (False, True):
        for width in (1000, 360):
            with desk.page(width=width, dark=dark) as page:
                click(page, "example")
                done(page)
                wide = page.run("document.documentElement.scrollWidth")
                check(wide <= width, f"{wide} pixels are wider than the {width} of the window")
                for chosen in ("p.note", "#problem", "#compute", "a", "td"):
                    back = "body" if chosen != "#compute" else chosen
                    found = page.run(f"{ratio}([getComputedStyle(document.querySelector('{chosen}')).color, "
                                     f"getComputedStyle(document.querySelector('{back}')).backgroundColor])")
                    check(found >= 4.5, f"{chosen}: contrast {found:.2f}, dark {dark}")
                page.screenshot(desk.folder / f"{'dark' if dark else 'light'}_{width}.png")
                if width == 1000:
                    paper = base64.b64decode(page.call("Page.printToPDF", paperWidth=8.27, paperHeight=11.69)["data"])
                    check(re.findall(rb"/Type /Pages\b.*?/Count (\d+)", paper, re.S) == [b"1"], "the answer is not printed on one page")


def alone(desk, site, source, figures):
    """Nothing is sent, from a disk or from a server, and the folder is small."""
    size = sum(path.stat().st_size for path in site.iterdir())
    figures["bytes of the folder"] = size
    check(size < 3e6, f"the folder has {size} bytes")
    handler = functools.partial(Quiet, directory=str(site))
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        served = f"http://127.0.0.1:{server.server_address[1]}/"
        for url in (desk.url, served):
            with browser.Page(url) as page:
                click(page, "example")
                done(page)
                sent = {event["params"]["request"]["url"] for event in page.events
                        if event["method"] == "Network.requestWillBeSent"}
                foreign = {one for one in sent if not one.startswith(("blob:", "data:", url.rsplit("/", 1)[0]))}
                check(not foreign, f"{url} asks for {foreign}")
                blocked = page.run(f"fetch('{served}LICENSE').then(() => 'sent', () => 'blocked')")
                check(blocked == "blocked", f"{url}: the page could send")
                wrong = [event["params"] for event in page.events if event["method"] == "Runtime.exceptionThrown"]
                check(not wrong, f"{url}: {wrong}")
        server.shutdown()
    check(set(Quiet.asked) <= {"/", "/page.css", "/page.js", "/engine.js"}, f"the server was asked for {Quiet.asked}")
    rows = re.findall(r"^\| `(\S+)` \|[^|]*(?:\| [\d.]+ ){3}\| [\d.]+, ", (source / "docs/hardness.md").read_text(encoding="utf-8"), re.M)
    with desk.page() as page:
        offered = page.run("[...document.getElementById('upper').options].map(o => o.value)")
    check(rows and offered[:-1] == rows, f"materials {offered}, and in docs/hardness.md {rows}")


class Quiet(http.server.SimpleHTTPRequestHandler):
    asked = []

    def log_message(self, *_):
        self.asked.append(self.path)


def main():
    options = argparse.ArgumentParser()
    for name in ("source", "build", "fstiff", "screenshots"):
        options.add_argument("--" + name, required=name != "screenshots", type=pathlib.Path)
    given = options.parse_args()
    if not shutil.which("em++") or not browser.find():
        print("SKIPPED: needs Emscripten and Chromium (Debian: emscripten chromium)")
        return
    subprocess.run(["cmake", "--build", given.build, "--target", "web"], check=True, stdout=subprocess.DEVNULL)
    site, figures = given.build.resolve() / "web", {}
    with tempfile.TemporaryDirectory() as folder:
        desk = Desk(given.fstiff.resolve(), pathlib.Path(folder), (site / "index.html").as_uri())
        parts = (lambda: first_curve(desk, given.source), lambda: surfaces(desk, figures),
                 lambda: boundary_elements(desk, figures), lambda: refusals(desk), lambda: keyboard(desk),
                 lambda: looks(desk), lambda: alone(desk, site, given.source, figures))
        for part in parts:
            try:
                part()
            except (OSError, RuntimeError) as error:  # of which TimeoutError is one
                problems.append(f"{part.__code__.co_names[0]}: {error}")
        for shot in desk.folder.glob("*_*.png") if given.screenshots else ():
            shutil.copy(shot, given.screenshots)
    if problems:
        sys.exit("\n".join(problems))
    print("\n".join(f"{name}: {value:.0f}" for name, value in figures.items()))


main()
