#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Holds what it costs to compile, in CPU seconds as multiples of those of a file with Eigen alone, so that neither the machine nor
what else it does matters much.

    tools/check_cost.py program --compiler g++ --eigen /usr/include/eigen3
            the README's first program, compiled in turns with the file, the least of each; and the size of its object file.
            Measured with Eigen 3.4 at -O2: 2.7 times and 194 kB with g++ 12, 2.4 times and 210 kB with clang++ 14; the bounds are
            between that and twice that
    tools/check_cost.py build build/release/compile_seconds.txt
            the README's two commands: all compilations of the command, and of everything with the tests that ctest has run
            before this one, by the mean of what the file took at several moments of the same build (docs/development.md)"""
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
COMMAND = ("fstiff_io", "fstiff_instances", "fstiff_scene", "fstiff_scene_computing", "fstiff_sweep", "fstiff_cli")
YARDSTICK = "fstiff_eigen_alone_"  # and what it was compiled after


def cpu_seconds(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run(command, check=True)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def of_program(options):
    program = (options.program or ROOT / "README.md").read_text(encoding="utf-8")
    if not options.program:
        program = program.split("\n```cpp\n", 1)[1].split("\n```", 1)[0]
    flags = ["-std=c++20", *options.flags.split(), f"-I{ROOT / 'include'}"]
    flags += [flag for folder in options.eigen.split(";") for flag in ("-isystem", folder)]
    least = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, text in [("program", program + "\n"), ("eigen", EIGEN_ALONE)] * options.rounds:
            source = pathlib.Path(folder, name + ".cpp")
            source.write_text(text, encoding="utf-8")
            seconds = cpu_seconds([options.compiler, *flags, "-c", source, "-o", source.with_suffix(".o")])
            least[name] = min(seconds, least.get(name, seconds))
        size = pathlib.Path(folder, "program.o").stat().st_size
    ratio = least["program"] / least["eigen"]
    print(f"the README's program: {least['program']:.2f} CPU seconds, {ratio:.2f} times a file with Eigen alone; {size} bytes")
    if ratio > options.ratio:
        yield f"{ratio:.2f} times is more than {options.ratio:g}"
    if size > options.bytes:
        yield f"{size} bytes are more than {options.bytes}"


def seconds_of(text):
    minutes, rest = re.fullmatch(r"(\d+)m([\d.]+)s", text).groups()
    return 60 * int(minutes) + float(rest)


def tests_before(page):
    """CPU seconds of the tests that ctest has run, by /proc, without those that the test of the page noted in a file: it compiles
    the command once more by Emscripten. 0 where /proc is not available."""
    stat = pathlib.Path(f"/proc/{os.getppid()}/stat")
    if not stat.exists() or "(ctest)" not in (text := stat.read_text(encoding="utf-8")):
        return 0
    fields = text.rsplit(")", 1)[1].split()
    ctest, seconds = page.read_text(encoding="utf-8").split() if page.exists() else ("", "0")
    spared = float(seconds) if ctest == str(os.getppid()) else 0
    return (int(fields[13]) + int(fields[14])) / os.sysconf("SC_CLK_TCK") - spared  # cutime and cstime


def of_build(options):
    last = {}  # of each object the last compilation
    for line in options.log.read_text(encoding="utf-8").splitlines() if options.log.exists() else []:
        target, name, user, system = line.split()
        last[target, name] = seconds_of(user) + seconds_of(system)
    by_target, yardsticks = {}, []
    for (target, _), cpu in last.items():
        (yardsticks if target.startswith(YARDSTICK) else by_target.setdefault(target, [])).append(cpu)
    missing = [name for name in COMMAND if name not in by_target] + ["a file with Eigen alone"] * (not yardsticks)
    if missing:
        print(f"SKIPPED: {options.log} does not have {', '.join(missing)}")
        return
    unit = statistics.mean(yardsticks)
    command = sum(sum(by_target[name]) for name in COMMAND)
    compiled, tested = sum(sum(found) for found in by_target.values()), tests_before(options.log.parent / "page_seconds.txt")
    print(f"a file with Eigen alone: {unit:.2f} CPU seconds, {min(yardsticks):.2f} to {max(yardsticks):.2f} at {len(yardsticks)} moments")
    print(f"the command: {command:.0f} CPU seconds, {command / unit:.0f} times that")
    print(f"everything: {compiled:.0f} CPU seconds to compile, {tested:.0f} to test, {(compiled + tested) / unit:.0f} times")
    for name, cpu in sorted(by_target.items(), key=lambda item: -sum(item[1])):
        print(f"  {name}: {sum(cpu) / unit:.1f} times in {len(cpu)} files")
    for cost, limit, what in ((command, options.command, "the command"), (compiled + tested, options.all, "everything")):
        if cost > limit * unit:
            yield f"{cost / unit:.0f} times is more than {limit:g} for {what}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parts = parser.add_subparsers(dest="part", required=True)
    program = parts.add_parser("program")
    program.add_argument("--compiler", default="g++")
    program.add_argument("--eigen", default="/usr/include/eigen3", help="include folders, divided by semicolons")
    program.add_argument("--flags", default="-O2")
    program.add_argument("--rounds", type=int, default=2)
    program.add_argument("--program", type=pathlib.Path, help="a file in place of the README's program")
    program.add_argument("--ratio", type=float, default=4.5, help="greatest multiple of the CPU seconds of Eigen alone")
    program.add_argument("--bytes", type=int, default=300000, help="greatest size of the object file")
    build = parts.add_parser("build")
    build.add_argument("log", type=pathlib.Path)
    build.add_argument("--command", type=float, default=160, help="greatest multiple of the command")
    build.add_argument("--all", type=float, default=1350, help="greatest multiple of everything, tests run")
    options = parser.parse_args()
    if refusals := list((of_program if options.part == "program" else of_build)(options)):
        sys.exit("\n".join(refusals))


if __name__ == "__main__":
    main()
