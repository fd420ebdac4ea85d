#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Holds what the README's two commands cost: CPU seconds of all compilations of the command, and of everything with the tests
that ctest has run before this one, as multiples of those of a file with Eigen alone, the mean of what it took at
several moments of the same build, so that neither the machine nor what else it does matters much.

    tools/check_build_cost.py build/release/compile_seconds.txt

Measured with g++ 12 and Eigen 3.4: docs/development.md."""
import argparse
import os
import pathlib
import re
import statistics
import sys

COMMAND = ("fstiff_io", "fstiff_instances", "fstiff_scene", "fstiff_scene_computing", "fstiff_sweep", "fstiff_cli")
YARDSTICK = "fstiff_eigen_alone_"  # and what it was compiled after


def seconds(text):
    minutes, rest = re.fullmatch(r"(\d+)m([\d.]+)s", text).groups()
    return 60 * int(minutes) + float(rest)


def tests_before():
    """CPU seconds of what ctest has run and waited for: its children's, by /proc; 0 where that is not known."""
    stat = pathlib.Path(f"/proc/{os.getppid()}/stat")
    if not stat.exists() or "(ctest)" not in (text := stat.read_text(encoding="utf-8")):
        return 0
    fields = text.rsplit(")", 1)[1].split()
    return (int(fields[13]) + int(fields[14])) / os.sysconf("SC_CLK_TCK")  # cutime and cstime


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("log", type=pathlib.Path)
    parser.add_argument("--command", type=float, default=140, help="greatest multiple of the command")
    parser.add_argument("--all", type=float, default=1400, help="greatest multiple of everything, tests run")
    options = parser.parse_args()
    last = {}  # of each object the last compilation
    for line in options.log.read_text(encoding="utf-8").splitlines() if options.log.exists() else []:
        target, name, user, system = line.split()
        last[target, name] = seconds(user) + seconds(system)
    by_target, yardsticks = {}, []
    for (target, _), cpu in last.items():
        (yardsticks if target.startswith(YARDSTICK) else by_target.setdefault(target, [])).append(cpu)
    missing = [name for name in COMMAND if name not in by_target] + ["a file with Eigen alone"] * (not yardsticks)
    if missing:
        print(f"SKIPPED: {options.log} does not have {', '.join(missing)}")
        return
    unit = statistics.mean(yardsticks)
    command = sum(sum(by_target[name]) for name in COMMAND)
    compiled, tested = sum(sum(found) for found in by_target.values()), tests_before()
    print(f"a file with Eigen alone: {unit:.2f} CPU seconds, {min(yardsticks):.2f} to {max(yardsticks):.2f} at {len(yardsticks)} moments")
    print(f"the command: {command:.0f} CPU seconds, {command / unit:.0f} times that")
    print(f"everything: {compiled:.0f} CPU seconds to compile, {tested:.0f} to test, {(compiled + tested) / unit:.0f} times")
    for name, cpu in sorted(by_target.items(), key=lambda item: -sum(item[1])):
        print(f"  {name}: {sum(cpu) / unit:.1f} times in {len(cpu)} files")
    refusals = []
    if command > options.command * unit:
        refusals.append(f"{command / unit:.0f} times is more than {options.command:g} for the command")
    if compiled + tested > options.all * unit:
        refusals.append(f"{(compiled + tested) / unit:.0f} times is more than {options.all:g} for everything")
    if refusals:
        sys.exit("\n".join(refusals))


if __name__ == "__main__":
    main()
