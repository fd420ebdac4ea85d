# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=sh
# Sourced by build-and-run and build-and-test: the system packages, and where things are.

root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)

# What the command needs to build; zlib for compressed Digital Surf files, and pugixml too for X3P.
# shellcheck disable=SC2034 # used where this is sourced
run_packages="g++ cmake ninja-build libeigen3-dev libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libpugixml-dev zlib1g-dev"

# need PACKAGE...: installs those that are missing, and says so; touches nothing when all are there.
need() {
    if ! command -v dpkg-query >/dev/null 2>&1 || ! command -v apt-get >/dev/null 2>&1; then
        echo "No apt on this system: these packages, or what they are called here, must be installed: $*" >&2
        return 0
    fi
    missing=
    for package in "$@"; do
        # shellcheck disable=SC2016 # ${...} is the format language of dpkg-query
        status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null) || status=none
        [ "$status" = installed ] || missing="$missing $package"
    done
    [ -n "$missing" ] || return 0

    if [ "$(id -u)" -eq 0 ]; then
        as_root=
    elif command -v sudo >/dev/null 2>&1; then
        as_root=sudo
    else
        echo "These packages are missing, and only root or sudo can install them:$missing" >&2
        exit 1
    fi
    echo "Installing with apt:$missing" >&2
    # A fresh machine has no package list: refresh it before. An idle one has an old list: refresh it when that fails.
    apt_install --simulate >/dev/null 2>&1 || apt_update
    apt_install >&2 || { apt_update && apt_install >&2; } || {
        echo "apt could not install:$missing (see above)" >&2
        exit 1
    }
}

# want PACKAGE: the same, but where it cannot be had the tests that use it are skipped.
want() {
    (need "$1") || echo "Going on without $1: the tests that use it are skipped." >&2
}

apt_update() {
    $as_root apt-get update >&2 || echo "apt-get update failed: going on with the package list there is." >&2
}

apt_install() {
    # shellcheck disable=SC2086 # words on purpose
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends "$@" $missing
}

# nanobind FOLDER: puts it into the venv of that build folder, where CMake finds it and then builds the Python module.
nanobind() {
    python3 "$root/tests/python/run.py" nanobind --work "$root/build/$1/tests/python" >&2 ||
        echo "Going on without nanobind: the tests of the Python module are skipped." >&2
}

# workflow NAME: configures, builds and (where the workflow has tests) tests with the preset NAME.
workflow() {
    CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$(nproc)}
    export CTEST_PARALLEL_LEVEL
    (cd "$root" && cmake --workflow --preset "$1")
}
