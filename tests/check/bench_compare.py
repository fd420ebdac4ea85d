#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""bench/compare.py on programs that report invented times: it finds the slower build, and is not fooled by noise."""
import pathlib
import subprocess
import sys
import tempfile

COMPARE = pathlib.Path(__file__).resolve().parents[2] / "bench" / "compare.py"
FAKE = """#!{python} -ISE
import json, random, sys
with open(__file__ + ".count", "a+") as count:  # a byte a turn
    turn = count.tell()
    count.write(".")
random.seed({seed} + turn)
rows = []
for name, factor in 3 * {rows}:
    noise = 1 + 0.02 * random.random() + (5 if random.random() < 0.1 else 0)  # now and then the machine is busy
    rows.append({{"name": name, "cpu_time": 100 * factor * noise, "time_unit": "ns"}})
out = next(a for a in sys.argv if a.startswith("--benchmark_out="))[16:]
open(out, "w").write(json.dumps({{"benchmarks": rows}}))
sys.exit({code})
"""


def program(folder, name, rows, seed, code=0):
    path = pathlib.Path(folder) / name
    path.write_text(FAKE.format(python=sys.executable, rows=rows, seed=seed, code=code))
    path.chmod(0o755)
    return str(path)


def check(what, expected_code, expected_text, new_rows, *options, code=0):
    with tempfile.TemporaryDirectory() as folder:
        old = program(folder, "old.py", [("a", 1), ("b", 1)], 1)
        new = program(folder, "new.py", new_rows, 1000, code)
        done = subprocess.run([sys.executable, COMPARE, old, new, *options], capture_output=True, text=True)
    if done.returncode != expected_code or expected_text not in done.stdout + done.stderr:
        sys.exit(f"{what}: code {done.returncode}, expected {expected_code} and '{expected_text}'\n{done.stdout}{done.stderr}")


check("two equal builds", 0, "slower by more than 5 %: 0", [("a", 1), ("b", 1)])
check("a row 20 % slower", 1, "SLOWER", [("a", 1), ("b", 1.2)])
check("a row 20 % slower, 30 % accepted", 0, "slower by more than 30 %: 0", [("a", 1), ("b", 1.2)], "--threshold", "0.3", "--rounds", "8")
check("a row 20 % faster", 0, "faster", [("a", 1), ("b", 0.8)], "--rounds", "8")
check("a row that is gone", 0, "left out: b", [("a", 1)], "--rounds", "8")
check("nothing in common", 2, "no row in common", [("c", 1)], "--rounds", "8")
check("too few rounds", 2, "--rounds must be at least 8", [("a", 1)], "--rounds", "7")
check("a program that crashes", 2, "failed", [("a", 1)], code=3)
