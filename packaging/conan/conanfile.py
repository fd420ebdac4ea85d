# SPDX-License-Identifier: BSD-3-Clause
"""The headers of fstiff and its libraries of C++ as a Conan 2 package, made of the clone that this file lies in:

    conan create packaging/conan                                  Eigen from the Conan remote
    conan create packaging/conan -o "fstiff/*:system_eigen=True"  Eigen from the system's packages
    conan create packaging/conan -o "fstiff/*:io=True"            fstiff::io too, without X3P and compressed .sur
    conan create packaging/conan -o "fstiff/*:double=True"        fstiff::double too
"""
import pathlib
import re

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain
from conan.tools.build import check_min_cppstd
from conan.tools.files import copy
from conan.tools.system.package_manager import Apt, Brew, Dnf, PacMan

required_conan_version = ">=2.0"
LIBRARIES = {"io": "src/io", "double": "src/instances"}  # options, targets fstiff::io and fstiff::double, and their sources


class FstiffConan(ConanFile):
    name = "fstiff"
    description = "Normal contact stiffness of rough surfaces"
    license = "BSD-3-Clause"
    topics = ("tribology", "contact mechanics", "header-only")
    settings = "os", "arch", "compiler", "build_type"
    options = {"system_eigen": [True, False], **{part: [True, False] for part in LIBRARIES}}
    default_options = {option: False for option in options}
    no_copy_source = True

    @property
    def _clone(self):
        return pathlib.Path(self.recipe_folder).parent.parent

    def set_version(self):
        text = (self._clone / "include/fstiff/core/version.hpp").read_text(encoding="utf-8")
        self.version = re.search(r'define FSTIFF_VERSION_TEXT "(.+)"', text)[1]

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "cmake/*", "include/*", *(f"{folder}/*" for folder in LIBRARIES.values())):
            copy(self, pattern, str(self._clone), self.export_sources_folder)

    @staticmethod
    def _built(options):
        return [part for part in LIBRARIES if getattr(options, part)]

    def configure(self):
        self.package_type = "static-library" if self._built(self.options) else "header-library"

    def requirements(self):
        if not self.options.system_eigen:
            self.requires("eigen/3.4.0", transitive_headers=True)

    def system_requirements(self):
        if self.options.system_eigen:
            Apt(self).install(["libeigen3-dev"])
            Dnf(self).install(["eigen3-devel"])
            PacMan(self).install(["eigen"])
            Brew(self).install(["eigen"])

    def validate(self):
        check_min_cppstd(self, 20)

    def generate(self):
        toolchain = CMakeToolchain(self)
        for part in ("CLI", "C", "TESTS", "BENCH"):
            toolchain.cache_variables[f"FSTIFF_BUILD_{part}"] = False
        for part in LIBRARIES:
            toolchain.cache_variables[f"FSTIFF_BUILD_{part.upper()}"] = bool(getattr(self.options, part))
        for library in ("PUGIXML", "ZLIB"):  # none of the machine that builds
            toolchain.cache_variables[f"FSTIFF_{library}_LIBRARY"] = ""
        toolchain.generate()
        if not self.options.system_eigen:
            from conan.tools.cmake import CMakeDeps

            CMakeDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        if self._built(self.options):
            cmake.build()

    def package(self):
        CMake(self).install()

    def package_id(self):
        if not self._built(self.info.options):
            self.info.clear()

    def package_info(self):
        # The package's own files are what find_package(fstiff) finds, so that one target serves with Conan and without. The
        # generators for other build systems read the components, which have the names and flags of the files of pkg-config.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = ["share/cmake/fstiff"]
        headers = self.cpp_info.components["headers"]
        headers.set_property("cmake_target_name", "fstiff::fstiff")
        headers.set_property("pkg_config_name", "fstiff")
        headers.builddirs = self.cpp_info.builddirs
        headers.bindirs = headers.libdirs = []
        if not self.options.system_eigen:
            headers.requires = ["eigen::eigen"]
        for part in self._built(self.options):
            flags = pathlib.Path(self.package_folder, f"lib/pkgconfig/fstiff-{part}.pc").read_text(encoding="utf-8")
            library = self.cpp_info.components[part]
            library.set_property("cmake_target_name", f"fstiff::{part}")
            library.set_property("pkg_config_name", f"fstiff-{part}")
            library.builddirs = [f"lib/cmake/fstiff-{part}"]
            library.bindirs = []
            library.defines = re.findall(r"-D(\S+)", flags)
            library.libs = re.findall(r"-l(\S+)", flags)
            library.requires = ["headers"]
