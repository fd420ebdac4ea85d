#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Holds what a user pays to compile the README's first program: CPU seconds as a multiple of those of a file with Eigen alone,
compiled in turns with the same compiler and flags, the least of each; and the size of the object file.

    tools/check_compile_cost.py --compiler g++ --eigen /usr/include/eigen3

Measured with Eigen 3.4 at -O2: 2.7 times and 194 kB with g++ 12, 2.4 times and 210 kB with clang++ 14. The bounds are between
that and twice that."""
import argparse
import pathlib
import resource
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
EIGEN_ALONE = """#include <Eigen/Core>
double f(const double* p) { Eigen::Map<const Eigen::ArrayXd> a(p, 100); return (a * a + 1.0).sum(); }
"""


def cpu_seconds(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run(command, check=True)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--compiler", default="g++")
    parser.add_argument("--eigen", default="/usr/include/eigen3", help="include folders, divided by semicolons")
    parser.add_argument("--flags", default="-O2")
    parser.add_argument("--rounds", type=int, default=2)
    parser.add_argument("--program", type=pathlib.Path, help="a file in place of the README's program")
    parser.add_argument("--ratio", type=float, default=4.5, help="greatest multiple of the CPU seconds of Eigen alone")
    parser.add_argument("--bytes", type=int, default=300000, help="greatest size of the object file")
    options = parser.parse_args()

    program = (options.program or ROOT / "README.md").read_text(encoding="utf-8")
    if not options.program:
        program = program.split("\n```cpp\n", 1)[1].split("\n```", 1)[0]
    flags = ["-std=c++20", *options.flags.split(), f"-I{ROOT / 'include'}"]
    flags += [flag for folder in options.eigen.split(";") for flag in ("-isystem", folder)]
    with tempfile.TemporaryDirectory() as folder:
        sources = {name: pathlib.Path(folder, name + ".cpp") for name in ("program", "eigen")}
        sources["program"].write_text(program + "\n", encoding="utf-8")
        sources["eigen"].write_text(EIGEN_ALONE, encoding="utf-8")
        seconds = {name: [] for name in sources}
        for _ in range(options.rounds):
            for name, source in sources.items():
                compile_it = [options.compiler, *flags, "-c", source, "-o", source.with_suffix(".o")]
                seconds[name].append(cpu_seconds(compile_it))
        size = sources["program"].with_suffix(".o").stat().st_size

    least = {name: min(found) for name, found in seconds.items()}
    ratio = least["program"] / least["eigen"]
    print(f"the README's program: {least['program']:.2f} CPU seconds, {ratio:.2f} times a file with Eigen alone; {size} bytes")
    refusals = []
    if ratio > options.ratio:
        refusals.append(f"{ratio:.2f} times is more than {options.ratio:g}")
    if size > options.bytes:
        refusals.append(f"{size} bytes are more than {options.bytes}")
    if refusals:
        sys.exit("\n".join(refusals))


if __name__ == "__main__":
    main()
