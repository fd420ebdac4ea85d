#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How long a build by ninja and its tests took, with the ten slowest of each.

    tools/slowest.py build/release            of everything in the folder, and of the last run of ctest
    tools/slowest.py build/release SECONDS    of what was built and tested since then, in seconds of the epoch, with times of the clock
"""
import os
import pathlib
import re
import sys

NAMED = 10


def built(build, since):
    """[seconds, file] of each command that ninja ran since then, and the clock's seconds: how long they took, when they were done."""
    log = build / ".ninja_log"
    commands = {}
    for line in log.read_text(encoding="utf-8").splitlines()[1:] if log.exists() else []:
        *times, file, command = line.split("\t")
        start, end, modified = int(times[0]) / 1e3, int(times[1]) / 1e3, int(times[2]) / 1e9
        if modified < since or commands.get(command, ())[:2] == (start, end):  # the second is another output
            continue
        name = re.sub(r"CMakeFiles/([^/]+)\.dir/", r"\1/", os.path.relpath(build / file, build))
        commands[command] = (start, end, modified, name)
    if not commands:
        return [], 0, since
    starts, ends, modified, _ = zip(*commands.values())
    return [(end - start, name) for start, end, _, name in commands.values()], max(ends) - min(starts), max(modified)


def tested(build, since):
    """[seconds, name] of each test of the last run of ctest, and when it ended; none of a run before."""
    log = build / "Testing" / "Temporary" / "LastTest.log"
    if not log.exists() or log.stat().st_mtime < since:
        return [], since
    tests, name = [], ""
    lines = log.read_text(encoding="utf-8", errors="replace").splitlines()
    for before, line in zip(["", *lines], lines):
        if begin := re.match(r"\d+/\d+ Test: (.*)", line):
            name = begin[1]
        elif before == "<end of output>" and (time := re.match(r"Test time = +([\d.]+) sec", line)):
            tests.append((float(time[1]), name))
    return tests, log.stat().st_mtime


def table(what, rows, clock, unit):
    passed = f"{clock:.0f} s, " if clock else ""
    print(f"{what}: {passed}{sum(seconds for seconds, _ in rows):.0f} s of {len(rows)} {unit}; the slowest:")
    for seconds, name in sorted(rows, reverse=True)[:NAMED]:
        print(f"{seconds:8.1f}  {name}")


def main():
    build = pathlib.Path(sys.argv[1])
    since = float(sys.argv[2]) if len(sys.argv) > 2 else 0
    commands, building, done = built(build, since)
    tests, ended = tested(build, since)
    if commands:
        table("building", commands, since and building, "commands")
    if tests:
        table("testing", tests, since and ended - done, "tests")


if __name__ == "__main__":
    main()
