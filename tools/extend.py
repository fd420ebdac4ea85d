#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The patches of examples/extend, each of which adds something whole to fstiff; docs/extending.md shows them.

    tools/extend.py --check                   they apply to this tree, and the page shows what they hold
    tools/extend.py --update                  writes their parts into the page
    tools/extend.py --test FOLDER [--venv V]  applies them to a copy in FOLDER/tree, builds it and runs their tests; with the Python
                                              of the venv V, where that has nanobind, the module too

A patch that applies no longer is made again by three lines, the second once its conflicts are resolved:

    git apply --3way examples/extend/law.patch
    git add --all && git diff --cached -U1 --output=../law.patch && git reset --hard
    mv ../law.patch examples/extend && tools/extend.py --update
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys

from generated import ROOT, write_or_check

PATCHES, PAGE = sorted((ROOT / "examples/extend").glob("*.patch")), ROOT / "docs/extending.md"
SHOWN = re.compile(r"(<!-- (\w+\.patch): ([\w. ]+) -->\n\n```diff\n).*?(\n```)", re.S)


def apply(root, *options):
    """Why the patches do not apply; empty where they do. Git looks for no repository above root, whose paths it would take."""
    environment = os.environ | {"GIT_CEILING_DIRECTORIES": str(root.parent)}
    for patch in PATCHES:
        done = subprocess.run(["git", "apply", *options, patch], cwd=root, env=environment, capture_output=True, text=True)
        if done.returncode != 0:
            return f"examples/extend/{patch.name} does not apply; the head of tools/extend.py has the way to make it again:\n{done.stderr}"
    return ""


def part(text, file):
    """What a patch does to a file: its hunks without the numbers of lines, and of a new one of C++ the code without includes and namespaces."""
    text = next(text for text in text.split("diff --git ")[1:] if f"/{file} " in text.partition("\n")[0])
    hunks = re.sub(r"^@@ .*", "@@", text[text.index("\n@@") + 1:], flags=re.M)
    if "\nnew file" in text:
        hunks = hunks.removeprefix("@@\n")
        if "#include" in hunks:
            hunks = hunks[hunks.index("\n", hunks.rindex("#include")):]
        hunks = re.sub(r"\n\+(namespace\b.*\{|\}+  // namespace.*)(?=\n)", "", hunks)
    for excess in (r"(\n\+)+(?=\n\+\n)", r"\A(\+?\n)+", r"(\n[+ ]?)+\Z"):  # blank lines: two together, first, last
        hunks = re.sub(excess, "", hunks)
    return hunks


def page():
    """The page, with the parts that its comments name."""
    def shown(found):
        text = (ROOT / "examples/extend" / found[2]).read_text(encoding="utf-8")
        return found[1] + "\n".join(f"+++ {file}\n{part(text, file)}" for file in found[3].split()) + found[4]
    return SHOWN.sub(shown, PAGE.read_text(encoding="utf-8"))


def run(*command, cwd, **options):
    return subprocess.run(command, cwd=cwd, check=True, text=True, **options).stdout


def test_command(tree, command):
    """The command has the law and the reader: for cones p = E s/2 times the real area, at any separation."""
    height = lambda i, j: (7 * i + 5 * j) % 11 / 10
    (tree / "map.rgh").write_text("ROUGH 16 16 0.5\n" + "".join(" ".join(str(height(i, j)) for j in range(16)) + "\n" for i in range(16)))
    measured = subprocess.run([command, "measure", "map.rgh"], cwd=tree, text=True, capture_output=True).stdout  # ends with 4: few waves
    for sentence in ("rough, from the first bytes", "16 x 16, of which 0 missing"):
        assert sentence in measured, measured
    (tree / "cone.toml").write_text("""[surface]
rms_height = "0.8 um"
rms_gradient = 0.15
peak_radius = "40 um"
peak_density = "500 /mm2"
[material]
upper = { youngs_modulus = "210 GPa", poisson_ratio = 0.3 }
lower = { youngs_modulus = "210 GPa", poisson_ratio = 0.3 }
[contact]
pressures = ["1 MPa", "10 MPa"]
peaks = [{ r = 0.5, theta = 1 }]
laws = ["hertz", "cone"]
[output]
quantities = ["stiffness", "real_area"]
""")
    head, *rows = (line.split(",") for line in run(command, "run", "--format", "csv", "cone.toml", cwd=tree, capture_output=True).splitlines() if line[0] != "#")
    rows = [dict(zip(head, row)) for row in rows]
    cones = [row for row in rows if row["law"] == "cone"]
    assert cones, rows
    for row in cones:
        pressure, area = float(row["pressure_Pa"]), float(row["real_area_fraction"])
        assert abs(pressure / (115.384615384615e9 * 0.15 / 2**0.5 / 2 * area) - 1) < 1e-8, row


PYTHON = """import fstiff
cone = fstiff.Contact("cone", rms_height=0.8e-6, rms_gradient=0.15, peak_radius=40e-6, peak_density=5e8, r=0.5, theta=1, effective_modulus=1e11)
assert "cone" in fstiff.law_names()
assert abs(cone.at_pressures(1e7).real_area_fraction / (1e7 / (1e11 * 0.15 / 2**0.5 / 2)) - 1) < 1e-8
"""


def test(folder, venv):
    """Keeps the build folder of an earlier run; ends with an error of the step that fails."""
    tree, build = folder / "tree", folder / "tree/build/release"
    for old in tree.glob("*"):
        if old.name != "build":
            shutil.rmtree(old) if old.is_dir() else old.unlink()
    shutil.copytree(ROOT, tree, ignore=lambda place, names: {"build", ".git"} & set(names) if pathlib.Path(place) == ROOT else [], dirs_exist_ok=True)
    if why := apply(tree):
        sys.exit(why)
    lint = lambda *words, **options: subprocess.run([sys.executable, "tools/lint.py", *words], cwd=tree, **options)
    lint("layers", "--update", check=True)
    lint("api", "--update")  # refuses one name more than API_NAMES, which is raised by hand
    for check in ("sizes", "words"):
        lint(check, check=True)
    targets = ["fstiff_cli", "test_asperity", "test_io", "replay"]
    has_module = venv and subprocess.run([venv / "bin/python", "-c", "import nanobind, numpy"], capture_output=True).returncode == 0
    if has_module:
        (build / "tests/python").mkdir(parents=True, exist_ok=True)
        if not (build / "tests/python/venv").is_symlink():
            (build / "tests/python/venv").symlink_to(venv)
        targets.append("fstiff_python")
    run("cmake", "--preset", "default", cwd=tree)
    run("cmake", "--build", build, "--target", *targets, cwd=tree)
    run("ctest", "--test-dir", build, "--output-on-failure", "-R", "^(asperity|io)/|corpus of rough", "-LE", "^(more|long)$", cwd=tree)
    test_command(tree, build / "bin/fstiff")
    if has_module:
        run("cmake", "--install", build, "--component", "python", "--prefix", folder / "prefix", cwd=tree, stdout=subprocess.DEVNULL)
        (site,) = (folder / "prefix").glob("lib*/python*/site-packages")
        run(venv / "bin/python", "-c", PYTHON, cwd=folder, env=os.environ | {"PYTHONPATH": str(site)})
    print("the law and the reader of examples/extend are in the command" + " and in Python" * bool(has_module))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--check", action="store_true")
    what.add_argument("--update", action="store_true")
    what.add_argument("--test", metavar="FOLDER", type=pathlib.Path)
    parser.add_argument("--venv", type=pathlib.Path)
    options = parser.parse_args()
    if options.update:
        return write_or_check({PAGE: page()}, "extend.py --update", False)
    if not shutil.which("git"):
        print("SKIPPED: there is no git")
        return 0
    if options.test:
        return test(options.test.resolve(), options.venv)
    why = apply(ROOT, "--check")
    print(why or f"{len(PATCHES)} patches apply")
    return write_or_check({PAGE: page()}, "extend.py --update", True) or bool(why)


if __name__ == "__main__":
    sys.exit(main())
