#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Lines of include and src reached by the tests, from the profiles in the build folder of tools/check-coverage."""
import json
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def tool(name):
    """llvm-profdata or llvm-cov of the version of clang++, because their files change with the version."""
    version = re.search(r"version (\d+)", subprocess.run(["clang++", "--version"], capture_output=True, text=True, check=True).stdout)[1]
    return shutil.which(f"{name}-{version}") or name


def main():
    build = pathlib.Path(sys.argv[1])
    merged = build / "coverage.profdata"
    profiles = [str(file) for file in build.glob("profile/*.profraw")]
    subprocess.run([tool("llvm-profdata"), "merge", "-sparse", *profiles, "-o", str(merged)], check=True)
    found = {file.resolve() for file in [*build.glob("bin/*"), *build.rglob("lib*.so")]}  # programs and shared libraries
    first, *others = sorted(str(file) for file in found if file.is_file())
    sources = [first, *(word for file in others for word in ("-object", file)), f"-instr-profile={merged}"]
    elsewhere = rf"-ignore-filename-regex=^/usr/|^{re.escape(str(ROOT))}/(build/coverage/\.\./\.\./)?(tests|examples|build/coverage/[a-z])"
    subprocess.run([tool("llvm-cov"), "show", "-format=html", f"-output-dir={build / 'report'}", elsewhere, *sources], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    export = subprocess.run([tool("llvm-cov"), "export", "-summary-only", *sources], check=True, capture_output=True, text=True).stdout
    files = ((pathlib.Path(file["filename"]).resolve(), file["summary"]["lines"]) for file in json.loads(export)["data"][0]["files"])
    lines = {path.relative_to(ROOT): of for path, of in files if of["count"] and any(path.is_relative_to(ROOT / of_us) for of_us in ("include", "src"))}
    folders = {}
    for name, of in lines.items():
        reached, all_lines = folders.get(name.parent, (0, 0))
        folders[name.parent] = reached + of["covered"], all_lines + of["count"]
    folders = dict(sorted(folders.items())) | {"all": tuple(map(sum, zip(*folders.values())))}
    for folder, (reached, count) in folders.items():
        print(f"{str(folder):26} {reached:6} of {count:6} lines  {100 * reached / count:6.2f} %")
    print("\nleast:")
    for name, of in sorted(lines.items(), key=lambda item: item[1]["percent"])[:10]:
        print(f"  {of['percent']:6.2f} %  {of['count'] - of['covered']:4} lines not reached  {name}")
    absent = sorted(str(name) for name in {file.relative_to(ROOT) for file in (ROOT / "include").rglob("*.hpp")} - lines.keys())
    print(f"\nwithout a line of code in any program ({len(absent)}): {', '.join(absent)}")


if __name__ == "__main__":
    main()
