// SPDX-License-Identifier: BSD-3-Clause
#include "scene/file.hpp"

#include <fstiff/core/text.hpp>
#include <fstiff/io/lines.hpp>
#include <fstiff/io/quantity.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace fstiff::scene {
namespace {

/// Files that are going to be written.
std::vector<std::filesystem::path>& outputs() {
    static std::vector<std::filesystem::path> files;
    return files;
}

std::string number(double value, int digits) {
    if (!std::isfinite(value)) throw std::logic_error("a result is not a finite number; this is a defect of fstiff");
    return rounded_text(value, digits);
}

/// \p text, which may be "1.1e+02", as "110"; with an exponent of 5 and more as it is.
std::string without_small_exponent(std::string text) {
    const std::size_t e = text.find("e+0");
    if (e == std::string::npos || e + 4 != text.size() || text.back() > '4') return text;
    const auto exponent = static_cast<std::size_t>(text.back() - '0');
    const std::size_t first = text.find_first_not_of('-'), point = text.find('.');
    text.resize(e);
    if (point != std::string::npos) text.erase(point, 1);
    text.resize(first + exponent + 1, '0');
    return text;
}

}  // namespace

void keep_for_output(const std::string& file) {
    std::error_code error;
    const std::filesystem::path path = std::filesystem::weakly_canonical(std::filesystem::absolute(file), error);
    for (const auto& other : outputs())
        if (path == other && (!std::filesystem::exists(path, error) || std::filesystem::is_regular_file(path, error)))
            throw file_error(file, "would be written twice; give every output a name of its own");
    outputs().push_back(path);
}

std::string read_all(const std::string& file) {
    std::error_code ignored;
    for (const auto& output : outputs())
        if (std::filesystem::is_regular_file(output, ignored) &&
            std::filesystem::equivalent(file == "-" ? "/dev/stdin" : file, output, ignored))
            throw file_error(output.string(),
                             "is an input of this command and would be written over; give the output another name");
    std::string bytes;
    if (file == "-") {
        io::detail::append_bytes(std::cin, "standard input", bytes);
    } else {
        std::error_code error;
        if (!std::filesystem::exists(file, error))
            throw file_error(file, "no such file; the input must be an existing file");
        if (std::filesystem::is_directory(file, error)) throw file_error(file, "is a folder; the input must be a file");
        std::ifstream stream(file, std::ios::binary);
        if (!stream) throw file_error(file, "cannot be read; the input must be a readable file");
        const std::uintmax_t size =
            std::filesystem::is_regular_file(file, error) ? std::filesystem::file_size(file, error) : 0;
        if (!error && size <= io::detail::most_bytes) bytes.reserve(static_cast<std::size_t>(size));
        io::detail::append_bytes(stream, file, bytes);
    }
    if (bytes.find_first_not_of(" \t\r\n") == std::string::npos)
        throw domain_error(display_name(file) + ": is empty; the input must hold text");
    return bytes;
}

std::string display_name(const std::string& file) { return file == "-" ? "standard input" : file; }

double parse_positive(const std::string& text, io::Dimension dimension, std::string_view name) {
    const double value = io::parse_quantity(text, dimension, name);
    if (!(value > 0))  // it is finite
        throw domain_error({.parameter = name, .value = "\"" + text + "\"", .allowed = "greater than 0"});
    return value;
}

std::string exact(double value) { return number(value, 17); }
std::string rounded(double value, int digits) { return without_small_exponent(number(value, digits)); }
std::string shortest(double value) { return shortest_text(value); }

std::string list_of(std::span<const std::string_view> items) {
    std::string text;
    for (const auto item : items) text += (text.empty() ? "\"" : ", \"") + std::string(item) + "\"";
    return text;
}

}  // namespace fstiff::scene
