// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads an array of NumPy (.npy): one dimension is a profile, two are a map, whose rows are the first index.
///
/// A magic string, the version (2 bytes), the length of the header (2 bytes, 4 from version 2.0, least significant first),
/// the header, a dictionary such as {'descr': '<f8', 'fortran_order': False, 'shape': (3, 4), }, and the numbers. Read are
/// integers (i1, i2, i4, i8, u1, u2, u4, u8) and numbers of floating point (f4, f8) of either byte order, in the order of C
/// or of Fortran. The file holds neither units nor steps: they are given. NaN is a missing point, and so are the numbers that
/// the options name. Sizes are compared with the bytes that are there before memory is taken.
///
/// Reference   NumPy manual, numpy.lib.format (format versions 1.0, 2.0, 3.0)
/// Units       map in m; NpyOptions::units are the file's
/// Valid       2 points a side at least, or one row; heights that vary; files up to 2^31 bytes
/// Accuracy    number times unit, rounded once (tests/io/npy_test.cpp)

#include "io/binary_numbers.hpp"
#include "io/header.hpp"
#include "io/missing_values.hpp"
#include "io/profile_or_map.hpp"

namespace fstiff::io {

/// What an array of NumPy does not say itself.
struct NpyOptions {
    std::optional<double> spacing{};          ///< of one row [m]
    std::optional<double> dx{}, dy{};         ///< of a map, between points [m]
    std::optional<double> width{}, height{};  ///< of a map, columns dx and rows dy [m]
    std::string units{};                      ///< of the heights: "um"; of "um,nm" the last
    std::string missing{};                    ///< stands for missing points: "-9999", or "none"
    OptionNames names{};                      ///< for messages
};

/// What was found in a file.
struct NpyRecord {
    std::string name;
    std::string type;  ///< as NumPy writes it: "<f8"
    bool fortran_order{};
    std::size_t columns{}, rows{};
    std::size_t missing{};
    std::string missing_from;  ///< the numbers that stand for missing points; empty when none are named
    std::string unit;          ///< of the heights
    std::string size_from;     ///< where the spacings come from
    std::size_t trailer{};     ///< bytes after the heights
    double resolution{};       ///< step in which integers count [m]; 0 of numbers of floating point

    /// The above as sentences for people, one a line, without a full stop.
    [[nodiscard]] std::vector<std::string> sentences() const;
};

/// What an array of NumPy holds.
struct NpySurface {
    HeightMap<double> map;  ///< of one row when the array has one
    NpyRecord record;
};

/// Whether \p bytes begin as an array of NumPy does.
[[nodiscard]] bool is_npy(std::string_view bytes);

/// \throws domain_error naming file, field, value and what is allowed.
[[nodiscard]] NpySurface read_npy(std::string_view bytes, std::string_view name, const NpyOptions& options);

}  // namespace fstiff::io
