#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What it costs to compile, as multiples of a file with Eigen alone.

    tools/check_cost.py program --compiler g++ --eigen /usr/include/eigen3
            the README's first program next to the file: what g++ allocates, which no load changes, and the size of its object
    tools/check_cost.py code build/release
            the README's two commands, by what does not depend on the machine or its load: translation units, and bytes of code
            and constants in their objects, of the command and of everything
    tools/check_cost.py files
            CPU seconds of files that users write, over the file with Eigen alone; --update writes them into docs/linking-cpp.md
    tools/check_cost.py seconds
            the same two commands in CPU seconds, with their tests, in a fresh clone. On demand, because CPU seconds scatter by a
            tenth with the load of the machine (docs/development.md)"""
import argparse
import os
import pathlib
import re
import resource
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
EIGEN_ALONE = """#include <Eigen/Core>
double f(const double* p) { Eigen::Map<const Eigen::ArrayXd> a(p, 100); return (a * a + 1.0).sum(); }
"""
INLINE = "#include <fstiff/answer_inline.hpp>"
FILES = {  # flags and the text of a file, from that of the README's program
    "the README's program with `fstiff::double`": ("-DFSTIFF_COMPILED", lambda program: program),
    "the same with an implementation file elsewhere": ("", lambda program: program.replace(INLINE, "")),
    "the same alone, by `fstiff/answer_inline.hpp`": ("", lambda program: program),
    "the implementation file": ("", lambda program: "#include <fstiff/implementation.hpp>"),
    "`fit_fractal` of a profile, by the headers": ("", lambda program: """#include <fstiff/profile/fractal_fit.hpp>
double f(const fstiff::Profile<double>& p) { return fstiff::fit_fractal(p).line_dimension; }"""),
    "`measure` of a profile, by the headers": ("", lambda program: """#include <fstiff/measure/measure.hpp>
double f(const fstiff::Profile<double>& p) { return fstiff::measure(p).rms_height.value; }"""),
    "the same with `fstiff::double`": ("-DFSTIFF_COMPILED", lambda program: """#include <fstiff/measure/measure.hpp>
double f(const fstiff::Profile<double>& p) { return fstiff::measure(p).rms_height.value; }"""),
}
COMMAND = ("fstiff_io", "fstiff_io_points", "fstiff_instances", "fstiff_scene", "fstiff_sweep", "fstiff_cli")
# Of the command and of everything, by g++ 12; tests/CMakeLists.txt allows other versions a tenth more.
CODE_UNITS, CODE_MB = (8, 55), (5.2, 27.5)  # tests that are not optimised have 4 MB more, compiled in half the time


def cpu_seconds(command, cwd=None):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run(command, check=True, cwd=cwd)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def program_of_readme():
    return (ROOT / "README.md").read_text(encoding="utf-8").split("\n```cpp\n", 1)[1].split("\n```", 1)[0]


def of_program(options):
    if options.file:
        (_, text), = (entry for name, entry in FILES.items() if name.startswith(options.file))
        program = text(program_of_readme())
    else:
        program = options.program.read_text(encoding="utf-8") if options.program else program_of_readme()
    flags = ["-std=c++20", *options.flags.split(), f"-I{ROOT / 'include'}"]
    flags += [flag for folder in options.eigen.split(";") for flag in ("-isystem", folder)]
    megabytes = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, text in ("program", program + "\n"), ("eigen", EIGEN_ALONE):
            source = pathlib.Path(folder, name + ".cpp")
            source.write_text(text, encoding="utf-8")
            command = [options.compiler, *flags, "-ftime-report", "-c", source, "-o", source.with_suffix(".o")]
            report = subprocess.run(command, check=True, stderr=subprocess.PIPE, text=True, env=os.environ | {"LC_ALL": "C"}).stderr
            megabytes[name] = int(re.search(r"^ TOTAL +: .* (\d+)M$", report, re.MULTILINE)[1])
        size = pathlib.Path(folder, "program.o").stat().st_size
    ratio = megabytes["program"] / megabytes["eigen"]
    print(f"the program: {megabytes['program']} MB allocated by the compiler, {ratio:.2f} times a file with Eigen alone; {size} bytes")
    if ratio > options.ratio:
        yield f"{ratio:.2f} times is more than {options.ratio:g}"
    if size > options.bytes:
        yield f"{size} bytes are more than {options.bytes}"


def of_code(options):
    commands = subprocess.run(["ninja", "-C", options.build, "-t", "commands", "all"], capture_output=True, check=True, text=True).stdout
    objects = [one for one in set(re.findall(r" -o (\S+\.o) ", commands)) if (options.build / one).exists()]
    groups = {"the command": [one for one in objects if any(f"/{name}.dir/" in one for name in COMMAND)], "everything": objects}
    for (what, parts), units, megabytes in zip(groups.items(), options.units, options.megabytes, strict=True):
        size = subprocess.run(["size", "--totals", *parts], cwd=options.build, capture_output=True, text=True, check=True).stdout
        found = int(size.splitlines()[-1].split()[0]) / 1e6
        print(f"{what}: {len(parts)} translation units, {found:.2f} MB of code and constants")
        if len(parts) > units:
            yield f"{len(parts)} translation units are more than {units} for {what}"
        if found > megabytes:
            yield f"{found:.2f} MB are more than {megabytes:g} for {what}"


def of_files(options):
    eigen, program, rows = [], program_of_readme(), {}
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder, "file.cpp")

        def seconds(text, flags=""):
            source.write_text(text + "\n", encoding="utf-8")
            return cpu_seconds([options.compiler, "-std=c++20", "-O2", *flags.split(), f"-I{ROOT / 'include'}", "-isystem",
                                options.eigen, "-c", source, "-o", source.with_suffix(".o")])

        for name, (flags, text) in FILES.items():
            eigen += [seconds(EIGEN_ALONE), seconds(EIGEN_ALONE)]  # between the files, since the clock of a processor changes
            rows[name] = seconds(text(program), flags)
    alone = statistics.median(eigen)
    for name, cost in rows.items():
        rows[name] = cost / alone
        print(f"{name}: {cost:.1f} CPU seconds, {rows[name]:.1f} times a file with Eigen alone ({alone:.2f})")
    if options.update:
        page = ROOT / "docs/linking-cpp.md"
        table = "".join(f"| {name} | {ratio:.1f} |\n" for name, ratio in rows.items())
        old = page.read_text(encoding="utf-8")
        new = re.sub(r"(?s)(<!-- tools/check_cost.py files -->\n\|.*?\n\|.*?\n).*?(?=<!-- /)", lambda mark: mark[1] + table, old)
        page.write_text(new, encoding="utf-8", newline="\n")
    return []


def of_seconds(options):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["git", "clone", "--quiet", ROOT, folder], check=True)
        source = pathlib.Path(folder, "build", "eigen.cpp")
        source.parent.mkdir()
        source.write_text(EIGEN_ALONE, encoding="utf-8")
        eigen = [options.compiler, "-std=c++20", "-O2", "-isystem", options.eigen, "-c", source, "-o", source.with_suffix(".o")]
        ratio = 0  # the second command takes over what the first has compiled
        for what, preset, limit in (("the command", "run", options.command), ("everything", "test", options.all)):
            before = cpu_seconds(eigen)
            cost = cpu_seconds(["cmake", "--workflow", "--preset", preset], cwd=folder)
            unit = statistics.mean((before, cpu_seconds(eigen)))
            ratio += cost / unit
            print(f"{what}: {cost:.0f} CPU seconds by the preset {preset}, {ratio:.0f} times a file with Eigen alone ({unit:.2f}) in all")
            if ratio > limit:
                yield f"{ratio:.0f} times is more than {limit:g} for {what}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parts = parser.add_subparsers(dest="part", required=True)
    program, code, files, seconds = (parts.add_parser(name) for name in ("program", "code", "files", "seconds"))
    files.add_argument("--update", action="store_true", help="write the table of docs/linking-cpp.md")
    for part in (program, files, seconds):
        part.add_argument("--compiler", default="g++")
        part.add_argument("--eigen", default="/usr/include/eigen3", help="include folders, divided by semicolons")
    program.add_argument("--flags", default="-O2")
    program.add_argument("--file", help="the beginning of the name of a file that `files` measures")
    program.add_argument("--program", type=pathlib.Path, help="a file in place of the README's program")
    program.add_argument("--ratio", type=float, default=2.6, help="greatest multiple of what is allocated for Eigen alone")
    program.add_argument("--bytes", type=int, default=300000, help="greatest size of the object file")
    code.add_argument("build", type=pathlib.Path, help="the build folder of ninja")
    code.add_argument("--units", type=int, nargs=2, default=CODE_UNITS, help="of the command, of everything")
    code.add_argument("--megabytes", type=float, nargs=2, default=CODE_MB, help="of the command, of everything")
    seconds.add_argument("--command", type=float, default=125, help="greatest multiple of the command")
    seconds.add_argument("--all", type=float, default=770, help="greatest multiple of everything, tests run")
    options = parser.parse_args()
    if refusals := list({"program": of_program, "code": of_code, "files": of_files, "seconds": of_seconds}[options.part](options)):
        sys.exit("\n".join(refusals))


if __name__ == "__main__":
    main()
