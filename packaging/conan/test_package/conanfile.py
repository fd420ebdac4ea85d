# SPDX-License-Identifier: BSD-3-Clause
"""What `conan create` builds and runs against the package that it made: the program of tests/consumer. The files for
pkg-config are what tests/packaging/conan.cmake reads."""
import os

from conan import ConanFile
from conan.tools.build import can_run
from conan.tools.cmake import CMake, cmake_layout


class FstiffTest(ConanFile):
    settings = "os", "arch", "compiler", "build_type"
    generators = "CMakeDeps", "CMakeToolchain", "PkgConfigDeps"

    def requirements(self):
        self.requires(self.tested_reference_str)

    def layout(self):
        cmake_layout(self, src_folder="../../../tests/consumer")

    def build(self):
        options = self.dependencies["fstiff"].options
        cmake = CMake(self)
        cmake.configure(variables={"FSTIFF_COMPONENT": next((part for part in ("io", "double") if getattr(options, part)), "")})
        cmake.build()

    def test(self):
        if can_run(self):
            self.run(os.path.join(self.cpp.build.bindir, "consumer"))
