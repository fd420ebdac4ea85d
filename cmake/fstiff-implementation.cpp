// SPDX-License-Identifier: BSD-3-Clause
// Compiled in each target that links fstiff::fstiff: docs/linking-cpp.md.
#include <fstiff/implementation.hpp>
