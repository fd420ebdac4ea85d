#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the benchmark table of README.md from the JSON of the benchmark program.

    build/native/bin/fstiff_bench --benchmark_out=bench.json --benchmark_out_format=json
    tools/make_benchmarks.py bench.json

A row whose verification failed is shown as such, without a time.
"""
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LABELS = (  # name in the benchmark program, what README calls it
    ("reduced/four/plain/1e-12", "one dimension, all four integrals, 1e-12"),
    ("reduced/four/plain/1e-03", "one dimension, all four integrals, 1e-3"),
    ("reduced/stiffness/plain/1e-12", "one dimension, one integral, 1e-12"),
    ("tensor/stiffness/plain/1e-12", "two dimensions, one integral, 1e-12"),
    ("tensor/stiffness/plain/1e-03", "two dimensions, one integral, 1e-3"),
    ("paper/stiffness/plain/50x50", "the paper's 50 x 50 points, one integral"),
)


def table(results, labels):
    lines = ["| kernel | ns | largest relative error | median | evaluations |", "|---|---:|---:|---:|---:|"]
    for name, label in labels:
        row = results[name]
        time = "not verified" if row.get("error_occurred") else f"{row['cpu_time']:.0f}"
        lines.append(
            f"| {label} | {time} | {row['rel_err_max']:.0e} | {row['rel_err_median']:.0e} | {row['evaluations']:.0f} |"
        )
    return lines


def machine(context):
    cpu = next((line.split(":", 1)[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")), "unknown")
    return f"{cpu}, {context['mhz_per_cpu']} MHz, one core, shared with others; {context.get('compiler', 'unknown compiler')}"


def main():
    data = json.load(open(sys.argv[1]))
    results = {row["name"]: row for row in data["benchmarks"]}
    text = "\n".join(table(results, LABELS) + ["", f"({machine(data['context'])})"])
    readme = ROOT / "README.md"
    old = readme.read_text()
    new, count = re.subn(r"(<!-- benchmarks -->\n).*(\n<!-- /benchmarks -->)", lambda m: m[1] + text + m[2], old, flags=re.S)
    if count != 1:
        sys.exit("README.md has no <!-- benchmarks --> markers")
    readme.write_text(new)


if __name__ == "__main__":
    main()
