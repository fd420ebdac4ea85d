#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The recipes in packaging/ agree with CMake: version, dependencies, options.

    recipes.py ROOT    ends with 1 and names what differs; "SKIPPED: " where only the linter of conda is missing
"""

import ast
import json
import pathlib
import re
import sys
import types

# What CMake looks for, and its names in conda, Spack and vcpkg.
NAMES = {
    "Eigen3": ("eigen", "eigen", "eigen3"),
    "CLI11": ("cli11", "cli11", "cli11"),
    "nlohmann_json": ("nlohmann_json", "nlohmann-json", "nlohmann-json"),
    "tomlplusplus": ("tomlplusplus", "tomlplusplus", "tomlplusplus"),
    "PUGIXML": ("pugixml", "pugixml", "pugixml"),
    "ZLIB": ("zlib", "zlib-api", "zlib"),
    "nanobind": ("nanobind", "py-nanobind", None),
}
OF_PYTHON = {"Eigen3", "nlohmann_json", "tomlplusplus", "PUGIXML", "ZLIB", "nanobind"}
LIBRARIES = {"io": "src/io", "double": "src/instances"}  # the compiled libraries of C++, which every recipe offers
TOOLS = {"cmake", "ninja", "cxx", "c", "pip", "python", "scikit-build-core", "numpy"}
problems = []


def expect(satisfied, problem):
    if not satisfied:
        problems.append(problem)


def agree(what, found, wanted):
    expect(found == wanted, f"{what}: {sorted(map(str, found))} in place of {sorted(map(str, wanted))}")


def offers(what, found):
    agree(f"{what}: libraries", {name for name in LIBRARIES if f"FSTIFF_BUILD_{name.upper()}" in found}, set(LIBRARIES))


def names_in(column, packages):
    return {NAMES[package][column] for package in packages} - {None}


def known_to_cmake(root):
    """The packages and the options."""
    files = [root / "CMakeLists.txt", root / "python/CMakeLists.txt", *root.glob("cmake/*.cmake"), *root.glob("src/*/CMakeLists.txt")]
    text = "\n".join(file.read_text(encoding="utf-8") for file in files)
    packages = set(re.findall(r"^\s*find_package\((\w+)", text, re.M)) - {"Python", "Python3", "Threads"}
    libraries = set(re.findall(r"find_library\(FSTIFF_(\w+)_LIBRARY", text))
    options = set(re.findall(r"option\((FSTIFF_\w+)", text)) | {f"FSTIFF_{name}_LIBRARY" for name in libraries}
    return packages | libraries, options | {"FSTIFF_C_SHARED"}


def load_spack(file):
    """Runs a package.py with stand-ins for the directives of Spack, and returns their arguments."""
    seen = {}

    def directive(name):
        return lambda *arguments, **named: seen.setdefault(name, []).append((arguments, named))

    spack = types.ModuleType("spack.package")
    for name in ("license", "version", "variant", "depends_on", "conflicts"):
        setattr(spack, name, directive(name))
    modules = {"spack": types.ModuleType("spack"), "spack.package": spack}
    for part in ("spack_repo", "spack_repo.builtin", "spack_repo.builtin.build_systems"):
        modules[part] = types.ModuleType(part)
    for system, base in (("cmake", "CMakePackage"), ("python", "PythonPackage")):
        module = modules[f"spack_repo.builtin.build_systems.{system}"] = types.ModuleType(system)
        setattr(module, base, type(base, (), {
            "define": lambda self, name, value: (name, value),
            "define_from_variant": lambda self, name, variant: (name, variant),
            "spec": types.SimpleNamespace(satisfies=lambda condition: True)}))
    sys.modules.update(modules)
    scope = {}
    exec(compile(file.read_text(encoding="utf-8"), str(file), "exec"), scope)
    (package,) = (value for value in scope.values() if isinstance(value, type) and value.__base__ is not object)
    return package, seen


def check_spack(root, version, packages, options):
    repository = root / "packaging/spack/spack_repo/fstiff"
    for name, wanted in (("fstiff", packages - {"nanobind"}), ("py_fstiff", OF_PYTHON)):
        package, seen = load_spack(repository / f"packages/{name}/package.py")
        expect(package.__name__ == name.title().replace("_", ""), f"Spack: class {package.__name__} in {name}")
        agree(f"Spack {name}: versions", {arguments[0] for arguments, _ in seen["version"]}, {version})
        needed = {re.split("[@:]", arguments[0])[0] for arguments, _ in seen["depends_on"]}
        agree(f"Spack {name}", {one for one in needed if one.removeprefix("py-") not in TOOLS}, names_in(1, wanted))
        variants = {arguments[0] for arguments, _ in seen.get("variant", [])}
        for _, named in seen["depends_on"]:
            expect(named.get("when", "+")[1:] in variants | {""}, f"Spack {name}: there is no variant for {named}")
        if hasattr(package, "cmake_args"):
            passed = {option for option, _ in package().cmake_args()}
            agree(f"Spack {name}: options", passed - options, set())
            offers("Spack", passed)


def check_conda(root, version, packages, options):
    text = (root / "packaging/conda/recipe.yaml").read_text(encoding="utf-8")
    agree("conda: version", set(re.findall(r'^  version: "(.*)"', text, re.M)), {version})
    parts = text.split("  - package:")[1:]
    for part, wanted in zip(parts, (packages - {"nanobind"}, OF_PYTHON), strict=True):
        host = re.search(r"(?s)      host:\n(.*?)      run:", part)[1]
        needed = set(re.findall(r"^        - ([\w-]+)", host, re.M)) - TOOLS
        agree("conda", needed, names_in(0, wanted))
        agree("conda: options", set(re.findall(r"-D (FSTIFF_\w+)", part)) - options, set())
    offers("conda", re.findall(r"-D (FSTIFF_\w+)=ON", parts[0]))
    try:
        import rattler_build
    except ImportError:
        return "SKIPPED: rattler_build is not installed; all but the parsing of conda's recipe was checked"
    recipe = rattler_build.Stage0Recipe.from_file(root / "packaging/conda/recipe.yaml")
    rendered = recipe.render(rattler_build.VariantConfig())
    agree("conda: packages", {one.recipe.package.name for one in rendered}, {"fstiff", "fstiff-python"})
    return ""


def check_others(root, version, packages, options):
    port = json.loads((root / "packaging/vcpkg/fstiff/vcpkg.json").read_text(encoding="utf-8"))
    needed = {one for one in port["dependencies"] if isinstance(one, str)}
    needed.update(*(feature.get("dependencies", []) for feature in port["features"].values()))
    agree("vcpkg", needed, names_in(2, packages))
    agree("vcpkg: version", {port["version"]}, {version})
    passed = (root / "packaging/vcpkg/fstiff/portfile.cmake").read_text(encoding="utf-8")
    offers("vcpkg", passed)
    usage = (root / "packaging/vcpkg/fstiff/usage").read_text(encoding="utf-8")
    agree("vcpkg: targets of usage", set(re.findall(r"fstiff::(\w+)", usage)), {"fstiff", "c", *LIBRARIES})
    passed += (root / "pyproject.toml").read_text(encoding="utf-8")
    agree("vcpkg and pip: options", set(re.findall(r"FSTIFF_[A-Z_]+", passed)) - options - {"FSTIFF_VERSION_TEXT"}, set())
    conan = (root / "packaging/conan/conanfile.py").read_text(encoding="utf-8")
    switched = {f"FSTIFF_BUILD_{name}" for name in ast.literal_eval(re.search(r"for part in (\(.*\)):", conan)[1])}
    agree("Conan: libraries", ast.literal_eval(re.search(r"(?m)^LIBRARIES = (\{.*?\})", conan)[1]).items(), LIBRARIES.items())
    libraries = {f"FSTIFF_{name}_LIBRARY" for name in ast.literal_eval(re.search(r"for library in (\(.*\)):", conan)[1])}
    agree("Conan: options", switched - options, set())
    agree("Conan: libraries that it leaves out", libraries, {one for one in options if one.endswith("_LIBRARY")})
    citation = (root / "CITATION.cff").read_text(encoding="utf-8")
    agree("CITATION.cff", set(re.findall(r"^version: (.*)", citation, re.M)), {version})
    carried = (root / "python/build_backend.py").read_text(encoding="utf-8")
    third_party = (root / "THIRD_PARTY.txt").read_text(encoding="utf-8").lower().replace("toml++", "tomlplusplus")
    for package in OF_PYTHON:
        word = {"Eigen3": "eigen", "nlohmann_json": "nlohmann"}.get(package, package.lower())
        expect(word in third_party, f"THIRD_PARTY.txt does not name {package}")
        expect(package in carried or package in ("PUGIXML", "ZLIB", "nanobind"), f"an sdist does not carry {package}")


def main():
    root = pathlib.Path(sys.argv[1])
    (version,) = re.findall(r'define FSTIFF_VERSION_TEXT "(.+)"', (root / "include/fstiff/core/version.hpp").read_text(encoding="utf-8"))
    packages, options = known_to_cmake(root)
    if packages != set(NAMES):
        sys.exit(f"CMake looks for other packages than this test knows: {sorted(packages ^ set(NAMES))}")
    check_spack(root, version, packages, options)
    check_others(root, version, packages, options)
    skipped = check_conda(root, version, packages, options)
    print("\n".join(problems) or skipped or f"conda, Spack, vcpkg, Conan and pip agree with CMake on {len(packages)} packages")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
