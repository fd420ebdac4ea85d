#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""tools/release names presets, targets and scripts that exist, and refuses a commit that is no release; the version is one number.

    release.py ROOT    ends with 1 and names what differs
"""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile


def text(path):
    return path.read_text(encoding="utf-8")


def unknown(root):
    """What the script names and nothing defines."""
    script = text(root / "tools/release")
    presets = {preset["name"] for preset in json.loads(text(root / "CMakePresets.json"))["configurePresets"]}
    targets = set(re.findall(r"add_custom_target\(\s*(\w+)", "".join(text(file) for pattern in ("cmake/*.cmake", "src/*/CMakeLists.txt")
                                                                 for file in root.glob(pattern))))
    for what, pattern, known in (("preset", r"--preset (\w+)", presets), ("target", r"--target (\w+)", targets),
                                 ("script", r"python3 (\S+\.py)", {file.relative_to(root).as_posix() for place in ("tools", "tests/*") for file in root.glob(place + "/*.py")})):
        named = set(re.findall(pattern, script))
        if not named or named - known:
            yield f"tools/release: {what} {sorted(named - known) or 'is not named'}"


def other_versions(root, version):
    """Where documents, recipes and metadata have another version than the headers."""
    files = [root / name for name in ("README.md", "CHANGELOG.md", "CITATION.cff", "codemeta.json")]
    for file in files + [file for pattern in ("docs/*.md", "docs/*.svg", "packaging/**/*.*") for file in root.glob(pattern)]:
        for found in re.findall(r'(?:fstiff[ @-]|^[Vv]ersion:? |"version": "|version\("|\[Unreleased\] \()(\d+\.\d+\.\d+)', text(file), re.M):
            if found != version:
                yield f"{file.relative_to(root)}: has version {found}, and the headers have {version}"


def refusals(root, version):
    """Runs the script in a repository that holds just what it looks at first."""
    if not shutil.which("git"):
        return
    with tempfile.TemporaryDirectory() as name:
        clone = pathlib.Path(name)
        for file in ("tools/release", "tools/setup.sh", "include/fstiff/core/version.hpp", "CHANGELOG.md", "CITATION.cff"):
            (clone / file).parent.mkdir(parents=True, exist_ok=True)
            (clone / file).write_text(text(root / file), encoding="utf-8")
        git = lambda *words: subprocess.run(["git", "-c", "user.name=n", "-c", "user.email=e", *words], cwd=clone, check=True, capture_output=True)

        def refused(*sentences):
            done = subprocess.run(["sh", "tools/release", "product"], cwd=clone, capture_output=True, text=True)
            if done.returncode != 3 or not all(sentence in done.stderr for sentence in sentences):
                yield f"tools/release ends with {done.returncode} and {done.stderr!r}, not with 3 and {sentences}"

        git("init", "--quiet")
        yield from refused("the working tree has changes")
        git("add", "--all")
        git("commit", "--quiet", "--message", "first")
        yield from refused(f"no tag v{version}")
        git("tag", f"v{version}")
        yield from refused("CHANGELOG.md has no heading") if f"## [{version}]" not in text(root / "CHANGELOG.md") else ()
        (clone / "CHANGELOG.md").write_text(f"## [{version}]\n", encoding="utf-8")
        (clone / "gap.md").write_text("FILL IN\n", encoding="utf-8")
        git("add", "--all")
        git("commit", "--quiet", "--message", "second")
        git("tag", "--force", f"v{version}")
        yield from refused("fill in", "gap.md")


def main():
    root = pathlib.Path(sys.argv[1])
    (version,) = re.findall(r'define FSTIFF_VERSION_TEXT "(.+)"', text(root / "include/fstiff/core/version.hpp"))
    problems = [*unknown(root), *other_versions(root, version), *refusals(root, version)]
    print("\n".join(problems) or f"a release is possible but for what is to be filled in; the version is {version} everywhere")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
