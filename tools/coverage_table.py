#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Lines of include/ and src/ reached by the tests, from the profiles in the build folder of tools/check-coverage. Fails below LEAST."""
import json
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LEAST = {"include": 99, "src": 92}  # percent


def tool(name):
    """llvm-profdata or llvm-cov of the version of clang++, because their files change with the version."""
    version = re.search(r"version (\d+)", subprocess.run(["clang++", "--version"], capture_output=True, text=True, check=True).stdout)[1]
    return shutil.which(f"{name}-{version}") or name


def programs(build):
    """Programs and shared libraries that were compiled for coverage."""
    found = [*build.glob("bin/*"), *build.rglob("lib*.so")]
    return sorted(str(file) for file in {file.resolve() for file in found} if file.is_file())


def main():
    build = pathlib.Path(sys.argv[1])
    merged = build / "coverage.profdata"
    profiles = [str(file) for file in build.glob("profile/*.profraw")]
    subprocess.run([tool("llvm-profdata"), "merge", "-sparse", *profiles, "-o", str(merged)], check=True)
    first, *others = programs(build)
    sources = [first, *(word for file in others for word in ("-object", file)), f"-instr-profile={merged}"]
    elsewhere = rf"-ignore-filename-regex=^/usr/|^{re.escape(str(ROOT))}/(build/coverage/\.\./\.\./)?(tests|examples|build/coverage/[a-z])"
    subprocess.run([tool("llvm-cov"), "show", "-format=html", f"-output-dir={build / 'report'}", elsewhere, *sources], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    export = subprocess.run([tool("llvm-cov"), "export", "-summary-only", *sources], check=True, capture_output=True, text=True).stdout
    files = [(pathlib.Path(file["filename"]).resolve(), file["summary"]["lines"]) for file in json.loads(export)["data"][0]["files"]]
    too_few = False
    for tree, least in LEAST.items():
        lines = {path.relative_to(ROOT): of for path, of in files if path.is_relative_to(ROOT / tree) and of["count"]}
        folders = {}
        for name, of in lines.items():
            reached, count = folders.get(name.parent, (0, 0))
            folders[name.parent] = reached + of["covered"], count + of["count"]
        for folder, (reached, count) in sorted(folders.items()):
            print(f"{str(folder):28} {reached:6} of {count:6} lines  {100 * reached / count:6.2f} %")
        reached, count = map(sum, zip(*folders.values()))
        share = 100 * reached / count
        print(f"{tree:28} {reached:6} of {count:6} lines  {share:6.2f} %, at least {least} %\n\nleast of {tree}:")
        too_few |= share < least
        for name, of in sorted(lines.items(), key=lambda item: item[1]["percent"])[:10]:
            print(f"  {of['percent']:6.2f} %  {of['count'] - of['covered']:4} lines not reached  {name}")
        print()
    headers = {str(file.relative_to(ROOT)) for file in (ROOT / "include").rglob("*.hpp")}
    absent = sorted(headers - {str(path.relative_to(ROOT)) for path, of in files if path.is_relative_to(ROOT) and of["count"]})
    print(f"without a line of code in any program ({len(absent)}): {', '.join(absent)}")
    sys.exit("too few lines are reached" if too_few else 0)


if __name__ == "__main__":
    main()
