# SPDX-License-Identifier: BSD-3-Clause
from spack_repo.builtin.build_systems.cmake import CMakePackage

from spack.package import *


class Fstiff(CMakePackage):
    """Normal contact stiffness of rough surfaces: headers of C++20, readers of measured surfaces, the command and the C interface.

    It is built from a clone:  spack dev-build fstiff@0.1.0
    """

    license("BSD-3-Clause")
    version("0.1.0")

    variant("command", default=True, description="The command fstiff")
    variant("io", default=True, description="fstiff::io, the readers and writers of measured surfaces")
    variant("double", default=False, description="fstiff::double, the templates in double, compiled")
    variant("c", default=True, description="The C interface and the Fortran module")
    variant("x3p", default=True, description="X3P files, and compressed ones of Digital Surf")

    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("eigen@3.4:5")
    depends_on("cli11", type="build", when="+command")
    for part in ("+command", "+c"):
        depends_on("nlohmann-json", type="build", when=part)
        depends_on("tomlplusplus", type="build", when=part)
    depends_on("pugixml", when="+x3p")
    depends_on("zlib-api", when="+x3p")

    def cmake_args(self):
        arguments = [
            self.define_from_variant("FSTIFF_BUILD_CLI", "command"),
            self.define_from_variant("FSTIFF_BUILD_IO", "io"),
            self.define_from_variant("FSTIFF_BUILD_DOUBLE", "double"),
            self.define_from_variant("FSTIFF_BUILD_C", "c"),
            self.define("FSTIFF_BUILD_TESTS", False),
            self.define("FSTIFF_BUILD_BENCH", False),
            self.define("FSTIFF_INSTALL", True),
        ]
        if self.spec.satisfies("~x3p"):  # none of the machine that builds
            arguments += [self.define(f"FSTIFF_{name}_LIBRARY", "") for name in ("PUGIXML", "ZLIB")]
        return arguments
