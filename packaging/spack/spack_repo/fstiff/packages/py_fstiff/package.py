# SPDX-License-Identifier: BSD-3-Clause
from spack_repo.builtin.build_systems.python import PythonPackage

from spack.package import *


class PyFstiff(PythonPackage):
    """Normal contact stiffness of rough surfaces, from Python.

    It is built from a clone:  spack dev-build py-fstiff@0.1.0
    """

    license("BSD-3-Clause")
    version("0.1.0")

    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("python@3.10:", type=("build", "link", "run"))
    depends_on("py-scikit-build-core@0.11:", type="build")
    depends_on("py-nanobind@2.4:", type="build")
    depends_on("py-numpy", type=("build", "run"))
    depends_on("eigen@3.4:5", type="build")
    depends_on("nlohmann-json", type="build")
    depends_on("tomlplusplus", type="build")
    depends_on("pugixml")
    depends_on("zlib-api")
