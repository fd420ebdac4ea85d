#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a sweep by an engine and compares its results with those of one process, byte for byte.

    python3 check_engine.py ENGINE --fstiff COMMAND [--python PYTHON]     ENGINE: parallel, snakemake, dask, parquet

PYTHON, where it exists, is one that has the package fstiff, Dask and pyarrow; the default is the one that runs this.
Where the engine tries again, each chunk is ended once by SIGKILL. parquet runs the program of docs/sweep.md that makes a Parquet file of results, and compares its numbers with the lines.
Ends with exit code 1 where they differ, and says SKIPPED: where the engine is missing.
"""
import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
NEEDS = {"parallel": "parallel", "snakemake": "snakemake", "dask": None, "parquet": None}

KILLED_ONCE = """#!/bin/sh
# fstiff, whose first sweep to each file ends by SIGKILL somewhere on its way
for file; do :; done
if [ "$1" = sweep ] && [ "$file" != --count ] && mkdir "$file.tried" 2>/dev/null; then
    "{fstiff}" "$@" &
    sleep 0.0$(expr $$ % 4)
    kill -9 $!
    wait $!
    exit 137
fi
exec "{fstiff}" "$@"
"""


def run(command, **options):
    """Runs it; what it printed where it fails."""
    done = subprocess.run(command, capture_output=True, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}exit code {done.returncode}")
    return done


def serial(fstiff, grid, file):
    run([fstiff, "sweep", grid, "--threads", "1", "-o", file])
    return file.read_bytes()


def check_same(found, wanted, what, chunks):
    if found.read_bytes() != wanted:
        sys.exit(f"{what}: the joined results are not those of one process")
    if len(list(found.parent.glob("*.tried"))) != chunks:
        sys.exit(f"{what}: not every chunk was killed once")
    print(f"{what}: {wanted.count(10)} lines, the bytes of one process")


def killed_once(fstiff, work):
    """A command that is fstiff, but for its first sweep to each file."""
    command = work / "fstiff"
    command.write_text(KILLED_ONCE.format(fstiff=fstiff))
    command.chmod(0o755)
    return str(command)


def check_parallel(fstiff, work):
    environment = {**os.environ, "FSTIFF": killed_once(fstiff, work)}
    run(["sh", HERE / "parallel.sh", HERE / "grid.toml"], cwd=work, env=environment)
    wanted = serial(fstiff, HERE / "grid.toml", work / "serial.jsonl")
    check_same(work / "all.jsonl", wanted, "parallel, each chunk killed once", 8)
    begun = (work / "part-00000001.jsonl").stat().st_mtime_ns
    run(["sh", HERE / "parallel.sh", HERE / "grid.toml"], cwd=work, env=environment)
    check_same(work / "all.jsonl", wanted, "parallel again", 8)
    if (work / "part-00000001.jsonl").stat().st_mtime_ns != begun:
        sys.exit("parallel: a chunk that is done was computed again")


def check_snakemake(fstiff, work):
    python = pathlib.Path(shutil.which("snakemake")).read_text().splitlines()[0].removeprefix("#!").split()
    if subprocess.run([*python, "-c", "import matplotlib, pandas"], capture_output=True).returncode != 0:
        print("SKIPPED: the Python of snakemake has no pandas or matplotlib")
        return
    trace = ["--points", "4000", "--spacing", "1 um", "--hurst", "0.8", "--rms", "1 um"]
    run([fstiff, "generate", "profile", *trace, "-o", work / "trace.csv"])
    run(
        ["snakemake", "--cores", "2", "--snakefile", HERE / "Snakefile", "--directory", work]
        + ["--config", "trace=trace.csv", f"fstiff={killed_once(fstiff, work)}"],
        cwd=work,
        env={**os.environ, "HOME": str(work), "XDG_CACHE_HOME": str(work)},
    )
    check_same(work / "all.jsonl", serial(fstiff, work / "grid.toml", work / "serial.jsonl"), "snakemake, each chunk killed once", 4)
    if b"<svg" not in (work / "k.svg").read_bytes():
        sys.exit("snakemake: k.svg is not a picture")


def check_dask(fstiff, work, python):
    grid = work / "grid.toml"  # 10,000 scenes
    grid.write_text((HERE / "grid.toml").read_text().replace('["20 um", "40 um", "80 um"]', '["20 um", "35 um", "60 um", "80 um"]')
                    .replace("count = 40", "count = 50").replace("count = 25", "count = 50"))
    scenes = run([fstiff, "sweep", grid, "--count"]).stdout.strip()
    done = subprocess.run([python, HERE / "dask_sweep.py", grid, scenes], capture_output=True, text=True, cwd=work)
    if "SKIPPED:" in done.stderr:
        print(done.stderr)
        return
    if done.returncode != 0:
        sys.exit(done.stdout[-2000:] + done.stderr)
    serial(fstiff, grid, work / "serial.jsonl")
    as_table = "import json, pandas, sys; pandas.DataFrame(map(json.loads, open('serial.jsonl'))).to_csv(sys.stdout, index=False)"
    wanted = run([python, "-c", as_table], cwd=work).stdout
    if scenes != "10000" or sorted(done.stdout.splitlines()) != sorted(wanted.splitlines()):
        different = len(set(done.stdout.splitlines()) ^ set(wanted.splitlines()))
        sys.exit(f"dask: {different} lines of {scenes} scenes differ")
    print(f"dask: the rows of {scenes} scenes, the bytes of one process")


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
        if arguments.engine in ("parallel", "snakemake"):
            (check_parallel if arguments.engine == "parallel" else check_snakemake)(fstiff, work)
        else:
            python = arguments.python if pathlib.Path(arguments.python).exists() else sys.executable
            (check_dask if arguments.engine == "dask" else check_parquet)(fstiff, work, python)


if __name__ == "__main__":
    main()
