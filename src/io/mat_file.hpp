// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Variables of a MATLAB file of level 5 (.mat, versions 5 to 7).
///
/// 116 bytes of text, the version 256 and the byte order (MI read as IM is little) at byte 124, then elements: a tag of
/// a type and a length (uint32 each; a length in the upper half of the type leaves 4 bytes for the content), padded to
/// 8 bytes. A variable is an element 14 that holds elements of its own, flags (class, 8 complex, 2 logical), dimensions
/// (int32), name, and numbers column after column, stored in the least type that holds them; or an element 15, a zlib
/// stream of one.
///
/// Of a stream as much is inflated as the description of its variable takes, and all of it only for numbers that are
/// read: at most 200 times its size, above 2^20 bytes.
///
/// Reference   The MathWorks, MAT-File Format (level 5)
/// Valid       files up to 2^31 bytes

#include "io/file_bytes.hpp"

namespace fstiff::inline v0_1::io::detail {

/// A variable by its description.
struct MatVariable {
    std::string name;      // printable characters only
    std::size_t number{};  // in the file, from 1
    unsigned kind{};       // class: 1 cell, 2 struct, 3 object, 4 char, 5 sparse, 6 double ... 15 uint64
    bool is_complex{}, is_logical{};
    std::vector<std::uint64_t> sizes;  // of the dimensions
    std::string_view bytes;            // of the element
    bool is_packed{};

    /// Whether it is real numbers of two dimensions, two of them at least.
    [[nodiscard]] bool has_numbers() const;
    [[nodiscard]] bool is_vector() const { return sizes[0] == 1 || sizes[1] == 1; }
    /// How many numbers it has, which are below 2^31 where has_numbers().
    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(sizes[0] * sizes[1]); }
    /// '2 "z", 512 x 512 double'
    [[nodiscard]] std::string shown() const;
};

/// Numbers of a variable, column after column.
struct MatNumbers {
    std::vector<double> values;
    bool are_whole{};  // of an integer type
};

[[nodiscard]] bool is_mat(std::string_view bytes);

/// The variables of the file \p bytes, which must outlive them.
/// \throws domain_error naming file, variable and what is allowed.
[[nodiscard]] std::vector<MatVariable> mat_variables(std::string_view bytes, const std::string& name);
/// The numbers of \p variable of that file, which has_numbers().
[[nodiscard]] MatNumbers mat_numbers(std::string_view bytes, const std::string& name, const MatVariable& variable);

}  // namespace fstiff::inline v0_1::io::detail
