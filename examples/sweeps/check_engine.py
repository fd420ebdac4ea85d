#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a sweep by an engine and compares its results with those of one process, byte for byte.

    python3 check_engine.py ENGINE --fstiff COMMAND [--python PYTHON]     ENGINE: parallel, mpi, snakemake, dask, parquet

PYTHON, where it exists, is one that has the package fstiff, Dask and pyarrow; the default is the one that runs this.
parquet runs the program of docs/sweep.md that makes a Parquet file of results, and compares its numbers with the lines.
Ends with exit code 1 where they differ, and says SKIPPED: where the engine is missing.
"""
import argparse
import csv
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
NUMBERS = ("surface.peak_radius", "surface.rms_height", "pressure_Pa")
NEEDS = {"parallel": "parallel", "mpi": "mpirun", "snakemake": "snakemake", "dask": None, "parquet": None}


def run(command, **options):
    """Runs it; what it printed where it fails."""
    done = subprocess.run(command, capture_output=True, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}exit code {done.returncode}")
    return done


def serial(fstiff, grid, file):
    run([fstiff, "sweep", grid, "--threads", "1", "-o", file])
    return file.read_bytes()


def check_same(found, wanted, what):
    if found.read_bytes() != wanted:
        sys.exit(f"{what}: the joined results are not those of one process")
    print(f"{what}: {wanted.count(10)} lines, the bytes of one process")


def check_shards(engine, fstiff, work):
    """An engine that computes shards of grid.toml."""
    script = [HERE / f"{engine}.sh", HERE / "grid.toml"]
    if engine == "mpi":
        script += ["-n", "4", "--oversubscribe", *(["--allow-run-as-root"] if os.geteuid() == 0 else [])]
    run(["sh", *script], cwd=work, env={**os.environ, "FSTIFF": fstiff})
    check_same(work / "all.jsonl", serial(fstiff, HERE / "grid.toml", work / "serial.jsonl"), engine)


def check_snakemake(fstiff, work):
    python = pathlib.Path(shutil.which("snakemake")).read_text().splitlines()[0].removeprefix("#!").split()
    if subprocess.run([*python, "-c", "import matplotlib, pandas"], capture_output=True).returncode != 0:
        print("SKIPPED: the Python of snakemake has no pandas or matplotlib")
        return
    trace = ["--points", "4000", "--spacing", "1 um", "--hurst", "0.8", "--rms", "1 um"]
    run([fstiff, "generate", "profile", *trace, "-o", work / "trace.csv"])
    run(
        ["snakemake", "--cores", "2", "--snakefile", HERE / "Snakefile", "--directory", work]
        + ["--config", "trace=trace.csv", f"fstiff={fstiff}"],
        cwd=work,
        env={**os.environ, "HOME": str(work), "XDG_CACHE_HOME": str(work)},
    )
    check_same(work / "all.jsonl", serial(fstiff, work / "grid.toml", work / "serial.jsonl"), "snakemake")
    if b"<svg" not in (work / "k.svg").read_bytes():
        sys.exit("snakemake: k.svg is not a picture")


def check_dask(fstiff, work, python):
    done = subprocess.run([python, HERE / "dask_sweep.py"], capture_output=True, text=True, cwd=work)
    if "SKIPPED:" in done.stderr:
        print(done.stderr)
        return
    if done.returncode != 0:
        sys.exit(done.stdout[-2000:] + done.stderr)
    found = {
        (*(float(row[key]) for key in NUMBERS), row["law"]): float(row["stiffness_Pa_per_m"])
        for row in csv.DictReader(done.stdout.splitlines())
    }
    wanted = {}
    for line in serial(fstiff, HERE / "grid.toml", work / "serial.jsonl").splitlines():
        row = json.loads(line)
        wanted[(*(row[key] for key in NUMBERS), row["law"])] = row["stiffness_Pa_per_m"]
    if found != wanted:
        different = sum(found.get(key) != value for key, value in wanted.items())
        sys.exit(f"dask: {different} of {len(wanted)} values of K differ")
    print(f"dask: {len(wanted)} values of K, the same to the last digit")


def check_parquet(fstiff, work, python):
    if subprocess.run([python, "-c", "import pyarrow"], capture_output=True).returncode != 0:
        print("SKIPPED: pyarrow is not here")
        return
    page = (HERE.parent.parent / "docs" / "sweep.md").read_text(encoding="utf-8")
    program = re.search(r"```python\n(.*?)```", page, re.DOTALL).group(1)
    # a pressure out of reach, whose lines have no results, far behind the first ones
    grid = (HERE / "grid.toml").read_text().replace('to = "100 MPa"', 'to = "1e30 MPa"')
    (work / "grid.toml").write_text(grid)
    subprocess.run([fstiff, "sweep", "grid.toml", "-o", "results.jsonl"], cwd=work, capture_output=True)
    run([python, "-c", program], cwd=work)
    read = "import json, pyarrow.parquet as p; print(json.dumps(p.read_table('results.parquet').to_pylist()))"
    found = json.loads(run([python, "-c", read], cwd=work).stdout)
    wanted = [json.loads(line) for line in (work / "results.jsonl").read_text().splitlines()]
    for row in found + wanted:  # a point out of reach has null in its line; what a line lacks is null in a table
        for key in [key for key, value in row.items() if value is None and key not in ("theta", "r")]:
            del row[key]
    for row in wanted:
        if "error" in row:
            row.update({"theta": row.get("theta"), "r": row.get("r")})
    if found != wanted:
        sys.exit("parquet: the table is not that of the lines")
    print(f"parquet: {len(wanted)} rows, the same to the last digit, {sum('error' in row for row in wanted)} without results")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("engine", choices=NEEDS)
    parser.add_argument("--fstiff", required=True)
    parser.add_argument("--python", default=sys.executable)
    arguments = parser.parse_args()
    if NEEDS[arguments.engine] and not shutil.which(NEEDS[arguments.engine]):
        print(f"SKIPPED: {NEEDS[arguments.engine]} is not here")
        return
    with tempfile.TemporaryDirectory() as folder:
        fstiff, work = str(pathlib.Path(arguments.fstiff).resolve()), pathlib.Path(folder)
        if arguments.engine == "snakemake":
            check_snakemake(fstiff, work)
        elif arguments.engine in ("dask", "parquet"):
            python = arguments.python if pathlib.Path(arguments.python).exists() else sys.executable
            (check_dask if arguments.engine == "dask" else check_parquet)(fstiff, work, python)
        else:
            check_shards(arguments.engine, fstiff, work)


if __name__ == "__main__":
    main()
