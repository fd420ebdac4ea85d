# SPDX-License-Identifier: BSD-3-Clause
"""Finds the installed package with CMake 3.22, the oldest that docs/linking-cpp.md promises; pip brings it.

    old_cmake.py --work FOLDER --prefix PREFIX --version X.Y.Z --compiler CXX
"""

import argparse
import pathlib
import subprocess
import sys


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--work", type=pathlib.Path, required=True)
    parser.add_argument("--prefix", required=True)
    parser.add_argument("--version", required=True)
    parser.add_argument("--compiler", required=True)
    options = parser.parse_args()
    tools = options.work / "cmake"
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "install", "--quiet", "--retries", "1", "--timeout", "20"]
    if not tools.exists() and subprocess.run([*pip, "--target", tools, "cmake==3.22.*"], capture_output=True).returncode != 0:
        print("SKIPPED: pip cannot install CMake 3.22")
        return
    cmake = tools / "cmake" / "data" / "bin" / "cmake"
    for component in ("", "io"):
        build = options.work / f"component-{component}"
        subprocess.run([cmake, "-S", pathlib.Path(__file__).parents[1] / "consumer", "-B", build,
                        f"-DCMAKE_CXX_COMPILER={options.compiler}", f"-DCMAKE_PREFIX_PATH={options.prefix}",
                        f"-DFSTIFF_VERSION_WANTED={options.version}", f"-DFSTIFF_COMPONENT={component}"], check=True)
        subprocess.run([cmake, "--build", build], check=True)
        subprocess.run([build / "consumer"], check=True)


if __name__ == "__main__":
    main()
