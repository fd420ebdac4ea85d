# SPDX-License-Identifier: BSD-3-Clause
"""The build backend of pip and build: scikit-build-core, with an sdist that builds without root.

Of what fstiff needs three packages are headers alone. The sdist takes along those of the machine that makes it, in third_party,
each with the file that find_package() finds it by; THIRD_PARTY.txt has their licences.
"""

import io
import os
import pathlib
import shutil
import sys
import tarfile
import tempfile

from scikit_build_core import build as scikit
from scikit_build_core.build import *  # noqa: F403  # the other hooks

# package and target of CMake, where its headers may lie below a prefix, what is taken of them
CARRIED = [
    ("Eigen3", "Eigen3::Eigen", ["include/eigen3", "include"], ["Eigen", "unsupported/Eigen/FFT", "unsupported/Eigen/src/FFT"]),
    ("nlohmann_json", "nlohmann_json::nlohmann_json", ["include"], ["nlohmann"]),
    ("tomlplusplus", "tomlplusplus::tomlplusplus", ["include"], ["toml++"]),
]
CONFIG = """if(NOT TARGET {0})
    add_library({0} INTERFACE IMPORTED)
    set_target_properties({0} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${{CMAKE_CURRENT_LIST_DIR}}")
endif()
"""


def folder_of(package, places, parts):
    """The folder with the headers of a package, whole."""
    named = [prefix for prefix in os.environ.get("CMAKE_PREFIX_PATH", "").split(os.pathsep) if prefix]
    for prefix in [*named, sys.prefix, "/usr/local", "/usr"]:
        for place in places:
            folder = pathlib.Path(prefix, place)
            if all((folder / part).exists() for part in parts):
                return folder
    sys.exit(f"{package} is not found; an sdist takes its headers along: install it, or name its prefix in CMAKE_PREFIX_PATH")


def carried_files():
    """The names of files below third_party, and their contents."""
    for package, target, places, parts in CARRIED:
        yield f"{package}/{package}Config.cmake", CONFIG.format(target).encode()
        folder = folder_of(package, places, parts)
        for part in parts:
            found = folder / part
            for file in sorted(found.rglob("*")) if found.is_dir() else [found]:
                if file.is_file():
                    yield f"{package}/{file.relative_to(folder)}", file.read_bytes()


def sdist_of_copy(sdist_directory, config_settings):
    """scikit-build-core walks all folders and follows links; in a build folder they may lead to the whole disk (Wine's do)."""
    folder, clone = pathlib.Path(sdist_directory).resolve(), pathlib.Path.cwd()
    with tempfile.TemporaryDirectory() as work:
        copy = pathlib.Path(work, "clone")
        shutil.copytree(clone, copy, symlinks=True, ignore=lambda place, _: [".git", "build"] if pathlib.Path(place) == clone else [])
        os.chdir(copy)
        try:
            return scikit.build_sdist(folder, config_settings)
        finally:
            os.chdir(clone)


def build_sdist(sdist_directory, config_settings=None):
    name = sdist_of_copy(sdist_directory, config_settings)
    if pathlib.Path("third_party").exists():  # an sdist of an sdist
        return name
    path = pathlib.Path(sdist_directory, name)
    with tarfile.open(path) as made:
        files = [(member, made.extractfile(member).read()) for member in made if member.isfile()]
    root = name.removesuffix(".tar.gz")
    for file, content in carried_files():
        member = tarfile.TarInfo(f"{root}/third_party/{file}")
        member.size, member.mode, member.mtime = len(content), 0o644, files[0][0].mtime
        files.append((member, content))
    with tarfile.open(path, "w:gz", format=tarfile.PAX_FORMAT) as archive:
        for member, content in files:
            archive.addfile(member, io.BytesIO(content))
    return name
