// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The readers and writers of files: all of io but the opt-in X3P. Written by tools/check_layers.cmake.

#include <fstiff/io/delimited.hpp>
#include <fstiff/io/map_text.hpp>
#include <fstiff/io/quantity.hpp>
#include <fstiff/io/sdf.hpp>
#include <fstiff/io/surface_file.hpp>
#include <fstiff/io/text_table.hpp>
#include <fstiff/io/write_csv.hpp>
