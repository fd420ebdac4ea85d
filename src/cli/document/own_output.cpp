// SPDX-License-Identifier: BSD-3-Clause
#include "document/own_output.hpp"

#include "document/file.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/core/text.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace fstiff::cli {

extern const char* const example_scene;     // data/example_scene.toml
extern const char* const example_of_paper;  // data/example_of_paper.toml
extern const char* const example_grid;      // examples/sweeps/grid.toml

namespace {

/// Beginnings of the headers of CSV, which has no other place for its maker.
constexpr std::string_view headers[] = {
    "law,theta,r,",
    "parameter,value,error,unit",
    "file,parameter,value,error,unit",
    "lag_m,value_m2,pairs,",
    "direction,lag_m,value_m2,",
    "level_m,bearing_area,islands,",
    "r,theta,height,density",
    "r,theta,peak_ratio,",
    "wavenumber_rad_per_m,psd_",
    "lag_m,acf",
    "lambda_s_m,lambda_c_m,rms_height_m,",
    "pressure_Pa,stiffness_Pa_per_m",
    "pressure_Pa,p_star,stiffness_Pa_per_m,",
    "force_N,contact_radius_m,",
    "frequency_Hz,impedance_Rayl,",
    "frequency_Hz,stiffness_Pa_per_m",
    "name,endings,holds,recognised_by,asks_for",
};

/// The first line of \p text, which it loses.
std::string_view take_line(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

/// Whether \p line is \p maker, a version and one of the words that follow it.
bool names_maker(std::string_view line, std::string_view maker) {
    if (!line.starts_with(maker)) return false;
    line.remove_prefix(maker.size());
    const std::size_t end = line.find_first_not_of("0123456789.");
    return end > 0 && end != line.npos &&
           (line.substr(end).starts_with(": ") || line.substr(end).starts_with(" generate ("));
}

/// Whether every number of \p row is written as exact() writes it: few people print seventeen digits, or none.
bool has_exact_numbers(std::string_view row) {
    while (!row.empty()) {
        const std::size_t end = std::min(row.find(','), row.size());
        double value = 0;
        const char* const last = row.data() + end;
        if (const auto read = detail::read_decimal(row.data(), last, value); read.ptr == last && end > 0)
            if (document::exact(value) != row.substr(0, end)) return false;
        row.remove_prefix(std::min(end + 1, row.size()));
    }
    return true;
}

bool is_table(std::string_view bytes) {
    const std::string_view header = take_line(bytes);
    return std::any_of(std::begin(headers), std::end(headers),
                       [&](std::string_view begin) { return header.starts_with(begin); }) &&
           has_exact_numbers(take_line(bytes));
}

/// Whether \p line is one of the results of a sweep.
bool is_row(std::string_view line) {
    const auto has = [&](std::string_view key) { return line.find(key) != line.npos; };
    return line.starts_with("{\"index\":") && line.ends_with('}') &&
           ((has(",\"law\":\"") && has("\",\"theta\":") && has(",\"r\":")) || has(",\"error\":\""));
}

}  // namespace

bool is_own_output(std::string_view bytes) {
    if (bytes == example_scene || bytes == example_of_paper || bytes == example_grid) return true;
    std::string_view rest = bytes;
    const std::string_view line = take_line(rest);
    for (const char* maker : {"fstiff ", "# fstiff ", "** fstiff ", "% fstiff ", "# made by fstiff "})
        if (names_maker(line, maker)) return true;
    for (const char* begin : {"fstiff contact law ", "interface as a spring, eq. (5.1)\n",
                              "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"fstiff\"",
                              "aISO-1.0\r\nManufacID = fstiff\r\n", "bISO-1.0fstiff    ", "bISO-2.0fstiff    "})
        if (bytes.starts_with(begin)) return true;
    const bool is_json = bytes.starts_with('{') && bytes.substr(0, 200).find("\"fstiff_version\":") != bytes.npos;
    return is_json || is_row(line) || is_table(bytes);
}

void require_own(const std::string& file, bool of_picture) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::path path = document::output_target(file);
    if (!fs::is_regular_file(path, error)) return;  // there is none, or a pipe, which nothing is read from
    if (fs::file_size(path, error) == 0) return;    // nothing is lost
    constexpr std::size_t enough = 16384;           // more than an example
    std::ifstream stream(path, std::ios::binary);
    std::string bytes(enough, '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(enough));
    bytes.resize(static_cast<std::size_t>(stream.gcount()));  // 0 where it cannot be read
    if (!bytes.empty() && (of_picture ? bytes.starts_with("# fstiff ") : is_own_output(bytes))) return;
    throw file_error(file, std::string("was not made by fstiff") + (of_picture ? " with a picture" : "") +
                               " and is not replaced; choose another name, or give --force to replace it");
}

}  // namespace fstiff::cli
