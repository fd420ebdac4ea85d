// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The readers and writers of files: all of io but the opt-in X3P. Written by tools/check_layers.cmake.

#include <fstiff/io/binary_numbers.hpp>
#include <fstiff/io/column_titles.hpp>
#include <fstiff/io/gsf.hpp>
#include <fstiff/io/gwy.hpp>
#include <fstiff/io/header.hpp>
#include <fstiff/io/header_words.hpp>
#include <fstiff/io/known_binary.hpp>
#include <fstiff/io/lines.hpp>
#include <fstiff/io/map_table.hpp>
#include <fstiff/io/map_text.hpp>
#include <fstiff/io/matrix_axes.hpp>
#include <fstiff/io/matrix_unit.hpp>
#include <fstiff/io/missing_values.hpp>
#include <fstiff/io/npy.hpp>
#include <fstiff/io/number.hpp>
#include <fstiff/io/number_table.hpp>
#include <fstiff/io/profile_columns.hpp>
#include <fstiff/io/profile_or_map.hpp>
#include <fstiff/io/profile_text.hpp>
#include <fstiff/io/quantity.hpp>
#include <fstiff/io/regular_grid.hpp>
#include <fstiff/io/sdf.hpp>
#include <fstiff/io/smd.hpp>
#include <fstiff/io/sur.hpp>
#include <fstiff/io/surface_file.hpp>
#include <fstiff/io/units.hpp>
#include <fstiff/io/utf16.hpp>
#include <fstiff/io/write_csv.hpp>
#include <fstiff/io/write_sdf.hpp>
