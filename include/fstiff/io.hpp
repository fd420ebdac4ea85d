// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The readers and writers of files: all of io. They are compiled: link fstiff::io. Written by tools/lint.py.

#include <fstiff/io/quantities.hpp>
#include <fstiff/io/surface_file.hpp>
#include <fstiff/io/units.hpp>
#include <fstiff/io/write.hpp>
