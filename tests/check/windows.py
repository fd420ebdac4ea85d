#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""fstiff.exe and the C library, compiled by MinGW-w64 and run in Wine, against the command of this system: the same numbers,
the same words, the same files.

    windows.py --source . --fstiff build/release/bin/fstiff --work build/release/windows
"""
import argparse
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import time
import zipfile

from same_numbers import difference

problems = []


def check(holds, what):
    if not holds:
        problems.append(what)


def build(source, work):
    run = lambda *words: subprocess.run(["cmake", *words], cwd=source, check=True, stdout=subprocess.DEVNULL)
    run("--preset", "windows", "-B", work)
    run("--build", work, "--target", "all", "windows_zip", "--parallel", os.environ.get("JOBS", "1"))


class Side:
    """A command and what stands before it."""

    def __init__(self, words, folder, env=None):
        self.words, self.folder, self.env = words, folder, env

    def run(self, *arguments, text=b""):
        return subprocess.run([*self.words, *arguments], cwd=self.folder, env=self.env, input=text, capture_output=True)

    def start(self, *arguments):
        return subprocess.Popen([*self.words, *arguments], cwd=self.folder, env=self.env, stdin=subprocess.DEVNULL,
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def same(linux, windows, *arguments, text=b"", code=0, files=()):
    """Both sides print and write the same; a carriage return is a difference, and so is a backslash."""
    shown = "fstiff " + " ".join(arguments)
    a, b = linux.run(*arguments, text=text), windows.run(*arguments, text=text)
    codes = a.returncode, b.returncode
    check(codes == (code, code), f"{shown}: codes {codes}, not {code}: {b.stderr!r}")
    pairs = [(a.stdout, b.stdout, "standard output"), (a.stderr, b.stderr, "standard error")]
    pairs += [(side_file(linux, name), side_file(windows, name), name) for name in files]
    for mine, other, what in pairs:
        apart = difference(mine.decode(), other.decode())
        check(not apart, f"{shown}: {what} differs: {apart}\n{mine[:400]!r}\n{other[:400]!r}")
    return b


def side_file(side, name):
    path = side.folder / name
    return path.read_bytes() if path.is_file() else b"(no file)"


def numbers(linux, windows, source):
    for scene in sorted((source / "data").glob("*.toml")):
        for side in (linux, windows):
            shutil.copy(scene, side.folder)
        same(linux, windows, "run", scene.name, "--format", "csv")
        same(linux, windows, "run", scene.name, "--full")
    for side in (linux, windows):
        shutil.copy(source / "data/example_reflection.csv", side.folder)
    same(linux, windows, "ultrasound", "--reflection", "example_reflection.csv", "--frequency", "7 MHz", "--impedance",
         "46 MRayl", "--format", "json")


def names_and_lines(linux, windows, source):
    """Names that no code page of Western Europe has, and the ends of lines of both systems."""
    scene = (source / "data/sand_blasted_fine.toml").read_bytes()
    with_cr = scene.replace(b"\r", b"").replace(b"\n", b"\r\n")
    trace = linux.run("generate", "profile", "--points", "2048", "--spacing", "1 um", "--hurst", "0.8", "--rms",
                      "1 um").stdout
    check(trace.count(b"\n") > 2000, "no trace was generated")
    for side in (linux, windows):
        folder = side.folder / "Prüfstand µ Ω"
        folder.mkdir()
        (folder / "Fläche.toml").write_bytes(with_cr)
        (folder / "Spur ü.csv").write_bytes(trace.replace(b"\n", b"\r\n"))
    there = "Prüfstand µ Ω/"
    table = there + "Größe.csv"
    for _ in range(2):  # the second time it is replaced
        same(linux, windows, "run", there + "Fläche.toml", "--format", "csv", "-o", table, files=[table])
    same(linux, windows, "run", "-", "--format", "csv", text=with_cr)
    same(linux, windows, "measure", there + "Spur ü.csv", "--format", "json")
    same(linux, windows, "measure", "-", "--format", "json", text=trace.replace(b"\n", b"\r\n"))
    same(linux, windows, "run", there + "Fläche.toml", "--plot", there + "Bild ß.svg", files=[there + "Bild ß.plot.csv"])
    scene_of_trace = '[surface]\nfrom = "Spur ü.csv"\n[material.upper]\nyoungs_modulus = "205 GPa"\npoisson_ratio = 0.3\n'
    scene_of_trace += '[contact]\npressures = ["1 MPa", "10 MPa"]\n'
    for side in (linux, windows):
        (side.folder / there / "gemessen ä.toml").write_text(scene_of_trace, encoding="utf-8")
    same(linux, windows, "run", there + "gemessen ä.toml", "--format", "csv")
    for side in (linux, windows):
        left = [path.name for path in side.folder.rglob("*.partial*")]
        check(not left, f"left behind: {left}")


def refusals(linux, windows):
    same(linux, windows, "nonsense", code=2)
    same(linux, windows, "run", "--plot=", code=2)
    same(linux, windows, "run", "nirgends ü.toml", code=3)
    same(linux, windows, "run", "Prüfstand µ Ω", code=3)
    same(linux, windows, "run", "-o", "nowhere/table", code=3)
    same(linux, windows, "run", "-", text=b"[surface]\nrms_height = 3\n", code=3)
    itself = windows.run("run", "built_in.toml", "-o", "built_in.toml")
    is_refused = itself.returncode == 3 and b"/built_in.toml: is an input" in itself.stderr
    check(is_refused, f"an output that is the input: {itself.stderr!r}")
    same(linux, windows, "--help")
    same(linux, windows, "--version")


def sweeps(linux, windows, source):
    grid = (source / "examples/sweeps/grid.toml").read_text(encoding="utf-8")
    long = grid.replace("count = 40", "count = 40000").replace("count = 25", "count = 400")
    for side in (linux, windows):
        (side.folder / "Gitter ü.toml").write_text(grid, encoding="utf-8")
        (side.folder / "long.toml").write_text(long, encoding="utf-8")
        for part, rows in ((1, "0:1234"), (2, "1234:3000")):
            done = side.run("sweep", "Gitter ü.toml", "-o", f"Teil ü {part}.jsonl", "--rows", rows)
            check(done.returncode == 0, f"sweep --rows {rows}: {done.returncode} {done.stderr!r}")
    mine, other = (
        "".join(side_file(side, f"Teil ü {i}.jsonl").decode() for i in (1, 2)) for side in (linux, windows)
    )
    apart = difference(mine, other)
    check(mine.count("\n") >= 3000 and not apart, f"the sweep differs: {apart}")

    # What is killed leaves the old results as they were, and the next sweep completes them.
    results = windows.folder / "Teil ü 1.jsonl"
    before = results.read_bytes()
    first = windows.start("sweep", "long.toml", "-o", results.name)
    end = time.monotonic() + 60
    while time.monotonic() < end and not any(partial.stat().st_size for partial in windows.folder.glob("*.partial-*")):
        time.sleep(0.05)
    first.kill()
    first.wait()
    check(results.read_bytes() == before, "a sweep that was killed has changed its file")
    for partial in windows.folder.glob("*.partial-*"):
        partial.unlink()
    again = windows.run("sweep", "Gitter ü.toml", "-o", results.name)
    check(again.returncode == 0 and results.read_bytes().startswith(before), f"the next sweep: {again.stderr!r}")


def alone(program):
    """A program of the terminal that it is started from, which needs no library but those of Windows."""
    bytes_ = program.read_bytes()
    header = struct.unpack_from("<I", bytes_, 0x3C)[0]
    check(struct.unpack_from("<H", bytes_, header + 24 + 68)[0] == 3, "fstiff.exe is not a program for a terminal")
    libraries = {name.decode().lower() for name in re.findall(rb"[\w.-]+\.dll", bytes_, re.I)}
    libraries -= {"libgcj-16.dll", "libgcj-13.dll"}  # named in the start-up of GCC, and asked for by nobody
    of_windows = {"kernel32.dll", "msvcrt.dll", "shell32.dll", "advapi32.dll", "ntdll.dll"}
    check(libraries <= of_windows, f"fstiff.exe names {sorted(libraries - of_windows)}")


def c_library(source, work, wine, env):
    compiler = shutil.which("x86_64-w64-mingw32-gcc-posix") or shutil.which("x86_64-w64-mingw32-gcc")
    program = work / "bin/c_example.exe"
    subprocess.run([compiler, "-std=c11", "-D__USE_MINGW_ANSI_STDIO", "-DFSTIFF_C_SHARED", f"-I{source}/include",
                    source / "tests/c/example.c", work / "src/c/libfstiff.dll.a", "-o", program], check=True)
    done = subprocess.run([wine, program], env=env, capture_output=True)
    document = (source / "docs/linking-c.md").read_text(encoding="utf-8")
    printed = done.stdout.decode().replace("\r\n", "\n")
    check(f"```text\n{printed}```\n" in document, f"the example of C prints {printed} {done.stderr!r}")


def main():
    options = argparse.ArgumentParser()
    for name in ("source", "fstiff", "work"):
        options.add_argument("--" + name, required=True, type=pathlib.Path)
    given = options.parse_args()
    source, work = given.source.resolve(), given.work.resolve()
    wine = shutil.which("wine") or shutil.which("wine64")
    has_compiler = any(shutil.which(f"x86_64-w64-mingw32-g++{kind}") for kind in ("-posix", ""))
    if not wine or not has_compiler:
        print("SKIPPED: needs MinGW-w64 and Wine (Debian: g++-mingw-w64-x86-64 wine wine64)")
        return
    build(source, work)
    env = {**os.environ, "WINEPREFIX": str(work / "wine"), "WINEDEBUG": "-all", "WINEDLLOVERRIDES": "mscoree,mshtml="}
    env.pop("DISPLAY", None)
    shutil.rmtree(work / "run", ignore_errors=True)
    for name in ("linux", "windows", "program ü"):
        (work / "run" / name).mkdir(parents=True)
    with zipfile.ZipFile(next(work.glob("fstiff-*.zip"))) as packed:
        check(packed.namelist() == ["fstiff.exe"], f"the zip holds {packed.namelist()}")
        packed.extractall(work / "run/program ü")
    program = work / "run/program ü/fstiff.exe"
    alone(program)
    linux = Side([given.fstiff.resolve()], work / "run/linux")
    windows = Side([wine, program], work / "run/windows", env)
    windows.run("--version")  # makes the folder of Wine
    numbers(linux, windows, source)
    names_and_lines(linux, windows, source)
    refusals(linux, windows)
    sweeps(linux, windows, source)
    c_library(source, work, wine, env)
    subprocess.run([shutil.which("wineserver") or "/usr/lib/wine/wineserver", "-k"], env=env, check=False)
    if problems:
        sys.exit("\n".join(problems))
    version = subprocess.run([wine, "--version"], env=env, capture_output=True, text=True).stdout.strip()
    print(f"{version}: fstiff.exe of {program.stat().st_size} bytes does what {given.fstiff} does")


main()
