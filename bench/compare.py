#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares two builds of the benchmark program on one machine: the ratio of their times for each row, with a confidence interval.

The two programs take turns, so that what else the machine does hits both alike; in every round each row gives one ratio
new/old of the least processor times of three repetitions. Shown is the median of the ratios, with the distribution-free confidence interval between two of
their order statistics (sign test), which a few disturbed rounds do not move. A row is slower when even the lower end of its
interval exceeds 1 + threshold.
"""
import argparse
import json
import math
import statistics
import subprocess
import sys
import tempfile
import time

EXAMPLE = """example: a release against the working tree
  git worktree add ../before v0.1.0
  (cd ../before && cmake --preset native && cmake --build --preset native --target fstiff_bench)
  cmake --preset native && cmake --build --preset native --target fstiff_bench
  bench/compare.py ../before/build/native/bin/fstiff_bench build/native/bin/fstiff_bench --filter '/fstiff/|^law'

exit code: 0 no row is slower, 1 a row is slower by more than the threshold, 2 the comparison could not be made
"""


def run(program, options):
    """Least processor time [ns] of the repetitions of each row in one run, and the rows that were refused."""
    with tempfile.NamedTemporaryFile(suffix=".json") as out:
        command = [program, f"--benchmark_filter={options.filter}", f"--benchmark_min_time={options.min_time}",
                   "--benchmark_repetitions=3", f"--benchmark_out={out.name}", "--benchmark_out_format=json"]
        done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        if done.returncode not in (0, 1):  # 1: a row was not verified
            raise OSError(f"{program} failed: {done.stderr.strip()[-300:]}")
        text = out.read()
    rows = json.loads(text)["benchmarks"] if text else []
    unit = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}
    times, refused = {}, set()
    for row in rows:
        name = row.get("run_name", row["name"])
        if row.get("error_occurred"):
            refused.add(name)
        elif row.get("run_type") != "aggregate":
            times[name] = min(times.get(name, math.inf), row["cpu_time"] * unit[row["time_unit"]])
    return times, refused


def interval(values, confidence):
    """Order statistics that hold the median with at least \\p confidence; None when there are too few values."""
    n = len(values)
    ordered = sorted(values)
    tail, best = 0.0, None
    for k in range(n // 2):  # probability that at most k values are below the median
        tail += math.comb(n, k) / 2**n
        if 1 - 2 * tail >= confidence:
            best = (ordered[k], ordered[n - 1 - k])
    return best


def main():
    parser = argparse.ArgumentParser(description=__doc__, epilog=EXAMPLE, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old", help="the benchmark program to compare with")
    parser.add_argument("new", help="the benchmark program that is judged")
    parser.add_argument("--rounds", type=int, default=12, help="runs of each program (default 12)")
    parser.add_argument("--threshold", type=float, default=0.05, help="a slowdown that is accepted (default 0.05: 5 %%)")
    parser.add_argument("--confidence", type=float, default=0.99, help="of each interval (default 0.99)")
    parser.add_argument("--filter", default="/fstiff/|^law|^kernel|^contact|^profile",
                        help="regular expression for the rows (default: those of fstiff, not of its peers)")
    parser.add_argument("--min-time", type=float, default=0.02, help="seconds per row and repetition, three in a round (default 0.02)")
    parser.add_argument("--json", help="write the ratios to this file, too")
    options = parser.parse_args()

    least = next(n for n in range(2, 100) if 1 - 2 / 2**n >= options.confidence) if 0 < options.confidence < 1 else None
    if least is None or options.rounds < least:
        parser.error(f"--rounds must be at least {least} for --confidence {options.confidence}" if least else "--confidence must be between 0 and 1")

    logs, refused, begin = {}, set(), time.monotonic()
    for number in range(options.rounds):
        found = {}
        for which in ("old", "new") if number % 2 == 0 else ("new", "old"):
            found[which], bad = run(getattr(options, which), options)
            refused |= bad
        old, new = found["old"], found["new"]
        for name in old.keys() & new.keys():
            logs.setdefault(name, []).append(math.log(new[name] / old[name]))
        if number == 0:
            names = [name for name in new if name in old]
            for name in sorted(old.keys() ^ new.keys()):
                print(f"only in one of the two programs, left out: {name}")
        if sys.stderr.isatty():
            print(f"\rround {number + 1} of {options.rounds}, {time.monotonic() - begin:.0f} s", end="", file=sys.stderr)
    if sys.stderr.isatty():
        print(file=sys.stderr)
    for name in sorted(refused):
        print(f"not verified, left out: {name}")
    if not logs:
        print("no row in common: nothing to compare", file=sys.stderr)
        return 2

    width = max(map(len, names))
    print(f"{'row':{width}}  new/old   {100 * options.confidence:g} % interval")
    slower, out = [], {}
    for name in names:
        ends = interval(logs[name], options.confidence)
        if ends is None:
            continue
        middle, low, high = (math.exp(x) for x in (statistics.median(logs[name]), *ends))
        out[name] = {"ratio": middle, "low": low, "high": high, "rounds": len(logs[name])}
        change = "SLOWER" if low > 1 + options.threshold else "faster" if high < 1 / (1 + options.threshold) else ""
        if change == "SLOWER":
            slower.append(name)
        print(f"{name:{width}}  {middle:7.3f}   {low:.3f} to {high:.3f}  {change}".rstrip())
    if options.json:
        with open(options.json, "w") as file:
            json.dump(out, file, indent=1)
    print(f"{len(out)} rows, {options.rounds} rounds; slower by more than {100 * options.threshold:g} %: {len(slower)}")
    return 1 if slower else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (OSError, ValueError) as error:
        print(f"compare.py: {error}", file=sys.stderr)
        sys.exit(2)
