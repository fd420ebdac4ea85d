// SPDX-License-Identifier: BSD-3-Clause
#include "document/file.hpp"

#include "io/lines.hpp"

#include <fstiff/core/text.hpp>
#include <fstiff/io/units.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <system_error>

namespace fstiff::document {
namespace {

std::string number(double value, int digits) {
    if (!std::isfinite(value)) throw std::logic_error("a result is not a finite number; this is a defect of fstiff");
    return detail::rounded_text(value, digits);
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

std::filesystem::path output_target(const std::string& file) {
    namespace fs = std::filesystem;
    std::error_code error;
    fs::path path = fs::absolute(path_of(file));
    for (int links = 0; !fs::exists(path, error) && fs::is_symlink(fs::symlink_status(path, error)); ++links) {
        if (links == 40)
            throw file_error(
                file, "cannot be written: " + std::make_error_code(std::errc::too_many_symbolic_link_levels).message());
        path = path.parent_path() / fs::read_symlink(path, error);
    }
    const fs::path target = fs::weakly_canonical(path, error);
    return error ? path : target;
}

std::string read_all(const std::string& file, std::uint64_t enough) {
    std::string bytes;
    if (file == "-") {
        io::detail::append_bytes(std::cin, "standard input", bytes, enough);
    } else {
        std::error_code error;
        const std::filesystem::path path = path_of(file);
        if (!std::filesystem::exists(path, error))
            throw file_error(file, "no such file; the input must be an existing file");
        if (std::filesystem::is_directory(path, error)) throw file_error(file, "is a folder; the input must be a file");
        const std::uintmax_t size =
            std::filesystem::is_regular_file(path, error) ? std::filesystem::file_size(path, error) : 0;
        if (!error && size <= enough) bytes.reserve(static_cast<std::size_t>(size));
        if (!io::detail::append_file(path, file, bytes, enough))
            throw file_error(file, "cannot be read; the input must be a readable file");
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

std::string printable(std::string_view text, std::string_view kept) {
    std::string shown;
    shown.reserve(text.size());
    for (std::size_t place = 0; place < text.size();) {
        const std::size_t length = io::detail::utf8_length(text.substr(place));
        const std::string_view character = text.substr(place, std::max<std::size_t>(length, 1));
        const auto byte = static_cast<unsigned char>(character[0]);
        const bool is_control =
            byte < 0x20 || byte == 0x7f ||
            (character.size() == 2 && byte == 0xc2 && static_cast<unsigned char>(character[1]) < 0xa0) ||
            (character >= "\u200E" && character <= "\u200F") || (character >= "\u2028" && character <= "\u202E") ||
            (character >= "\u2066" && character <= "\u2069");
        if (length == 0)
            shown += "\uFFFD";
        else if (is_control && kept.find(character) == std::string_view::npos)
            shown += ' ';
        else
            shown += character;
        place += character.size();
    }
    return shown;
}

std::string exact(double value) { return number(value, 17); }
std::string rounded(double value, int digits) { return without_small_exponent(number(value, digits)); }
std::string shortest(double value) { return detail::shortest_text(value); }

std::string list_of(std::span<const std::string_view> items) {
    std::string text;
    for (const auto item : items) text += (text.empty() ? "\"" : ", \"") + std::string(item) + "\"";
    return text;
}

}  // namespace fstiff::document
