#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures `fstiff sweep`: scenes per second, scaling over threads, memory. Prints the tables of docs/scaling.md.

    python3 tools/measure_sweep.py build/release/bin/fstiff [--scenes 300000] [--memory 10000000]

"per core second" divides by the processor time that the command took, so that it says the same on a busy machine; "per
second" by the time on the wall. Every result is compared with that of one thread, byte for byte, before its time counts.
"""
import argparse
import hashlib
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
CASES = {
    "four integrals, separations of one surface": lambda n: {
        "points": f"separations = [ {RANGE.format('0.1 um', '3 um', n)} ]"
    },
    "four integrals, moduli at one separation of one surface": lambda n: {
        "modulus": RANGE.format("100 GPa", "300 GPa", n),
        "points": 'separations = ["1 um"]',
    },
    "inversions, pressures on one surface": lambda n: {
        "points": f"pressures = [ {RANGE.format('0.1 MPa', '100 MPa', n)} ]"
    },
    "the same, K alone and by tables": lambda n: {
        "points": f"pressures = [ {RANGE.format('0.1 MPa', '100 MPa', n)} ]",
        "more": '[output]\nquantities = ["stiffness", "separation"]\n[sweep]\ntabulate = true',
    },
    "cold inversions, a surface of its own for each": lambda n: {"rms": RANGE.format("0.5 um", "2 um", n)},
    "cold inversions of the law fractal": lambda n: {"rms": RANGE.format("0.5 um", "2 um", n), "law": "fractal"},
    "cold inversions, a Poisson ratio for each (read anew)": lambda n: {
        "poisson": f"{{ from = 0.2, to = 0.4, count = {n} }}"
    },
    "cold inversions, three distributed inputs": lambda n: {
        "rms": '{ lognormal = ["0.8 um", 0.1] }',
        "modulus": '{ normal = ["205 GPa", "5 GPa"] }',
        "points": 'pressures = [ { uniform = ["1 MPa", "20 MPa"] } ]',
        "more": f"[sweep]\nsamples = {n}",
    },
}


def grid(folder, count, changes):
    file = folder / "grid.toml"
    file.write_text(BASE.format(**{**PLAIN, **changes}))
    return file


def sweep(fstiff, file, out, threads):
    """Wall time, processor time [s] and the greatest memory [MB] of one run, and the hash of its results."""
    for old in (out, pathlib.Path(f"{out}.sweep")):
        old.unlink(missing_ok=True)
    begun = time.monotonic()
    child = subprocess.Popen(
        [fstiff, "sweep", file, "-o", out, "--threads", str(threads)],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    wall = time.monotonic() - begun
    if child.returncode != 0:
        raise SystemExit(f"exit code {child.returncode}")
    with open(out, "rb") as stream:
        found = hashlib.file_digest(stream, "sha256").hexdigest()
    return wall, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024, found


def measure_merge(fstiff, folder, count, shards):
    """Prints how quickly shards are checked and joined, and how quickly an interrupted run finds its place."""
    file = grid(folder, count, CASES["four integrals, separations of one surface"](count))
    parts = [folder / f"part-{i}" for i in range(1, shards + 1)]
    for i, part in enumerate(parts, 1):
        command = [fstiff, "sweep", file, "--shard", f"{i}/{shards}", "-o", part]
        subprocess.run(command, check=True, capture_output=True)
    begun = time.monotonic()
    subprocess.run([fstiff, "merge", *parts, "-o", folder / "all"], check=True, capture_output=True)
    seconds = time.monotonic() - begun
    size = (folder / "all").stat().st_size
    print(f"\nmerging {shards} shards: {size / 1e6 / seconds:.0f} MB/s of results")
    for part in parts:
        part.unlink()
        pathlib.Path(f"{part}.sweep").unlink()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("fstiff")
    parser.add_argument("--scenes", type=int, default=300000)
    parser.add_argument("--memory", type=int, default=10000000, help="scenes of the run whose memory is told; 0: none")
    parser.add_argument("--folder", help="where results are written; the default is that of temporary files")
    arguments = parser.parse_args()
    model = next((line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")), "")
    print(f"{platform.machine()}, {model}, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f} at the beginning\n")
    print("| scenes | per core second, 1 thread | 2 threads | per second, 1 thread | 2 threads | bytes a line | memory [MB] |")
    print("|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory(dir=arguments.folder) as name:
        folder = pathlib.Path(name)
        for title, changes in CASES.items():
            n = arguments.scenes
            file = grid(folder, n, changes(n))
            one = sweep(arguments.fstiff, file, folder / "one", 1)
            two = sweep(arguments.fstiff, file, folder / "two", 2)
            if one[3] != two[3]:
                raise SystemExit(f"{title}: two threads have other results than one")
            size = (folder / "one").stat().st_size / n
            rates = " | ".join(f"{n / seconds:.2g}" for seconds in (one[1], two[1], one[0], two[0]))
            print(f"| {title} | {rates} | {size:.0f} | {two[2]:.0f} |", flush=True)
        for shards in (1, 4):
            measure_merge(arguments.fstiff, folder, arguments.scenes, shards)
        if arguments.memory:
            n = arguments.memory
            lean = {"more": '[output]\nquantities = ["stiffness"]'}
            changes = {**CASES["four integrals, separations of one surface"](n), **lean}
            wall, processor, memory, _ = sweep(arguments.fstiff, grid(folder, n, changes), folder / "many", 2)
            size = (folder / "many").stat().st_size
            print(
                f"\n{n:.0e} scenes with K alone: {wall:.0f} s with 2 threads, {n / processor:.3g} per core second, "
                f"{memory:.0f} MB of memory, {size / 1e9:.2f} GB of results"
            )


if __name__ == "__main__":
    main()
