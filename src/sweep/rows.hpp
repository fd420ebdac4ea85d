// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Reads results back, line by line, for pictures and sensitivities.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace fstiff::sweep {

/// Parts of one line that pictures and sensitivities use.
struct Row {
    std::uint64_t index = 0;
    std::string_view law;  ///< "answer" of an answer, whose law may be another at each point
    std::optional<double> theta{}, r{};
    std::size_t point = 0;              ///< its place among those of one scene, law, theta and r
    double pressure = 0;                ///< [Pa]
    std::optional<double> stiffness{};  ///< [Pa/m]; none where the scene asks for none
};

/// The index of the scene of \p line; none unless it is a whole line of results: one object of JSON that begins with
/// its index and holds texts, numbers and null alone.
[[nodiscard]] std::optional<std::uint64_t> index_of_line(std::string_view line);

/// Calls \p call with every line of \p file and the index of its scene, until it returns false.
/// \throws file_error where the file cannot be read, and naming the first line that is not whole or not in its order.
void for_each_line(const std::string& file,
                   const std::function<bool(std::string_view line, std::uint64_t index)>& call);

/// Calls \p call with every line of \p file that has results, in their order, until it returns false.
/// \throws file_error as for_each_line, and naming the first line whose law or keys are not those of results.
void for_each_row(const std::string& file, const std::function<bool(const Row&)>& call);

}  // namespace fstiff::sweep
