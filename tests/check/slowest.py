# SPDX-License-Identifier: BSD-3-Clause
"""tools/slowest.py on a build folder with invented times: it names the slowest files and tests, of a build and of a run since then."""
import os
import pathlib
import subprocess
import sys
import tempfile

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "tools" / "slowest.py"
BEGAN = 2_000_000_000  # seconds of the epoch
TEST = """{i}/{n} Testing: {name}
{i}/{n} Test: {name}
Output:
----------------------------------------------------------
Test time =   900.00 sec
<end of output>
Test time = {seconds:6.2f} sec
"""


def write(build):
    """Built before: files of 500 s, one of which is built again. Since then: twelve of 1 to 12 s, one after another, the last
    with a second output."""
    rows = [(0, 500000, BEGAN - 9, name, command) for name, command in (("old.o", "a"), ("src/io/CMakeFiles/part_1.dir/unity.o", "b1"))]
    for i in range(1, 13):
        rows.append((i * (i - 1) * 500, i * (i + 1) * 500, BEGAN + 78, f"src/io/CMakeFiles/part_{i}.dir/unity.o", f"b{i}"))
    rows.append((*rows[-1][:3], str(build / "second"), "b12"))
    lines = ["\t".join(str(cell if i != 2 else cell * 10**9) for i, cell in enumerate(row)) for row in rows]
    (build / ".ninja_log").write_text("\n".join(["# ninja log v5", *lines, ""]), encoding="utf-8")
    log = build / "Testing" / "Temporary" / "LastTest.log"
    log.parent.mkdir(parents=True)
    tests = {"quick: one": 0.25, "slow: K(p), by hand": 31.5}
    log.write_text("".join(TEST.format(i=i, n=2, name=name, seconds=s) for i, (name, s) in enumerate(tests.items(), 1)), encoding="utf-8")
    os.utime(log, (BEGAN + 98, BEGAN + 98))


def shown(*words):
    return subprocess.run([sys.executable, SCRIPT, *map(str, words)], capture_output=True, check=True, text=True).stdout.splitlines()


def main():
    with tempfile.TemporaryDirectory() as name:
        build = pathlib.Path(name)
        assert shown(build) == [], "there is nothing to name"
        write(build)
        tests = ["    31.5  slow: K(p), by hand", "     0.2  quick: one"]
        parts = [f"{i:8.1f}  src/io/part_{i}/unity.o" for i in range(12, 2, -1)]
        expected = ["building: 78 s, 78 s of 12 commands; the slowest:", *parts, "testing: 20 s, 32 s of 2 tests; the slowest:", *tests]
        assert shown(build, BEGAN) == expected, shown(build, BEGAN)
        everything = ["building: 578 s of 13 commands; the slowest:", "   500.0  old.o", *parts[:-1], "testing: 32 s of 2 tests; the slowest:", *tests]
        assert shown(build) == everything, shown(build)
        assert shown(build, BEGAN + 99) == [], "nothing was built or tested since then"
        assert shown(build, BEGAN + 90)[0].startswith("testing: 8 s"), "nothing was built"


main()
