#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Lines of include and src reached by the tests, from the profiles in the build folder of tools/check-coverage; fails below LEAST."""
import json
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LEAST = {"include": 99, "src": 92}  # percent of lines reached


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
    lines = {path.relative_to(ROOT): of for path, of in files if of["count"] and any(path.is_relative_to(ROOT / tree) for tree in LEAST)}
    folders = {}
    for name, of in lines.items():
        for folder in (str(name.parent), name.parts[0]):
            reached, all_lines = folders.get(folder, (0, 0))
            folders[folder] = reached + of["covered"], all_lines + of["count"]
    for folder, (reached, count) in sorted(folders.items()):
        print(f"{folder:26} {reached:6} of {count:6} lines  {100 * reached / count:6.2f} %" + (f", at least {LEAST[folder]} %" if folder in LEAST else ""))
    print("\nleast:")
    for name, of in sorted(lines.items(), key=lambda item: item[1]["percent"])[:10]:
        print(f"  {of['percent']:6.2f} %  {of['count'] - of['covered']:4} lines not reached  {name}")
    absent = sorted(str(name) for name in {file.relative_to(ROOT) for file in (ROOT / "include").rglob("*.hpp")} - lines.keys())
    print(f"\nwithout a line of code in any program ({len(absent)}): {', '.join(absent)}")
    low = [tree for tree, least in LEAST.items() if 100 * folders[tree][0] < least * folders[tree][1]]
    sys.exit(f"too few lines are reached of {', '.join(low)}" if low else 0)


if __name__ == "__main__":
    main()
