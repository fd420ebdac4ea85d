#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures `fstiff sweep`: scenes per second, scaling over threads, memory. Prints the tables of bench/README.md.

    python3 tools/measure_sweep.py build/release/bin/fstiff [--scenes 300000] [--memory 10000000]

"per core second" divides by the processor time that the command took, so that it is the same on a busy machine; "per
second" by the time on the wall. Every result is compared with that of one thread, byte for byte.
"""
import argparse
import os
import pathlib
import platform
import subprocess
import tempfile
import time

BASE = """
[surface]
rms_height = {rms}
peak_radius = "40 um"
peak_density = "500 /mm^2"
fractal_dimension = 1.62
[material.upper]
youngs_modulus = {modulus}
poisson_ratio = {poisson}
[contact]
laws = ["{law}"]
peaks = [ {{ theta = "pi/3", r = 0.5 }} ]
{points}
{more}
"""
PLAIN = {"rms": '"0.832 um"', "modulus": '"205 GPa"', "poisson": "0.3", "law": "hertz", "points": 'pressures = ["10 MPa"]', "more": ""}
RANGE = '{{ from = "{}", to = "{}", count = {} }}'
CASES = {  # what changes for n scenes
    "four integrals, separations of one surface": lambda n: {"points": f"separations = [ {RANGE.format('0.1 um', '3 um', n)} ]"},
    "inversions, pressures on one surface": lambda n: {"points": f"pressures = [ {RANGE.format('0.1 MPa', '100 MPa', n)} ]"},
    "cold inversions, a surface of its own for each": lambda n: {"rms": RANGE.format("0.5 um", "2 um", n)},
    "cold inversions of the law fractal": lambda n: {"rms": RANGE.format("0.5 um", "2 um", n), "law": "fractal"},
    "cold inversions, three distributed inputs": lambda n: {
        "rms": '{ lognormal = ["0.8 um", 0.1] }', "modulus": '{ normal = ["205 GPa", "5 GPa"] }',
        "points": 'pressures = [ { uniform = ["1 MPa", "20 MPa"] } ]', "more": f"[sweep]\nsamples = {n}"},
}


def run(*command):
    """Wall time, processor time [s] and greatest memory [MB] of one run."""
    begun = time.monotonic()
    child = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        raise SystemExit(f"exit code {child.returncode}")
    return time.monotonic() - begun, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("fstiff")
    parser.add_argument("--scenes", type=int, default=300000)
    parser.add_argument("--memory", type=int, default=10000000, help="scenes of the run whose memory is measured; 0: none")
    options = parser.parse_args()
    model = next((line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")), "")
    print(f"{platform.machine()}, {model}, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f} at the beginning\n")
    print("| scenes | per core second, 1 thread | 2 threads | per second, 1 thread | 2 threads | bytes a line | memory [MB] |")
    print("|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as name:
        folder, n = pathlib.Path(name), options.scenes
        file, results, first = folder / "grid.toml", folder / "results", next(iter(CASES.values()))

        def sweep(changes, *more):
            """The times of a sweep."""
            file.write_text(BASE.format(**PLAIN | changes))
            return run(options.fstiff, "sweep", file, "-o", results, *more)

        for title, changes in CASES.items():
            one = sweep(changes(n), "--threads", "1")
            of_one = results.rename(folder / "one")  # not in memory, which counts as that of the next process
            two = sweep(changes(n), "--threads", "2")
            if subprocess.run(["cmp", "-s", results, of_one]).returncode != 0:
                raise SystemExit(f"{title}: two threads have other results than one")
            rates = " | ".join(f"{n / seconds:.2g}" for seconds in (one[1], two[1], one[0], two[0]))
            print(f"| {title} | {rates} | {of_one.stat().st_size / n:.0f} | {two[2]:.0f} |", flush=True)
        if options.memory:
            n = options.memory
            wall, processor, memory = sweep(first(n) | {"more": '[output]\nquantities = ["stiffness"]'}, "--threads", "2")
            print(f"\n{n:.0e} scenes with K alone: {wall:.0f} s with 2 threads, {n / processor:.3g} per core second, "
                  f"{memory:.0f} MB of memory, {results.stat().st_size / 1e9:.2f} GB of results")


if __name__ == "__main__":
    main()
