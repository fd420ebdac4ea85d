// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/io/write.hpp>

#include "io/number.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/core/text.hpp>

#include <cmath>
#include <ostream>

namespace fstiff::inline v0_1::io {

namespace detail {

namespace {

void put_text(std::ostream& output, const std::string& text) {
    output.write(text.data(), static_cast<std::streamsize>(text.size()));
    if (!output) throw file_error("delimited text", "cannot be written; the output must take it");
}

/// A height of a map.
std::string map_cell(double z) { return std::isnan(z) ? "nan" : fstiff::detail::shortest_text(z); }

}  // namespace

}  // namespace detail

void write_csv(std::ostream& output, const Profile<double>& profile) {
    profile.validate(16);
    fstiff::detail::require_positive("length", profile.length());
    std::string text = "# Spacing: " + fstiff::detail::shortest_text(profile.spacing) + " m\nx [m],z [m]\n";
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const double z = profile.heights[i];
        text += fstiff::detail::shortest_text(static_cast<double>(i) * profile.spacing) + ',' +
                (std::isnan(z) ? std::string() : fstiff::detail::shortest_text(z)) + '\n';
    }
    detail::put_text(output, text);
}

void write_csv(std::ostream& output, const HeightMap<double>& map, MapForm form) {
    map.validate(2);
    const double width = static_cast<double>(map.columns()) * map.dx, height = static_cast<double>(map.rows()) * map.dy;
    fstiff::detail::require_positive("width", width);
    fstiff::detail::require_positive("height", height);
    if (form == MapForm::automatic) fstiff::detail::refuse("form", name_of(form), "matrix or triples");
    const std::string spacings = "# dx: " + fstiff::detail::shortest_text(map.dx) +
                                 " m\n# dy: " + fstiff::detail::shortest_text(map.dy) + " m\n";
    std::string text;
    if (form == MapForm::matrix) {
        text = "# Form: matrix\n# Channel: height\n# Width: " + fstiff::detail::shortest_text(width) +
               " m\n# Height: " + fstiff::detail::shortest_text(height) + " m\n# Value units: m\n" + spacings;
        for (Eigen::Index j = 0; j < map.rows(); ++j)
            for (Eigen::Index i = 0; i < map.columns(); ++i)
                text += detail::map_cell(map.heights(j, i)) + (i + 1 < map.columns() ? '\t' : '\n');
    } else {
        text = "# Form: triples\n" + spacings + "x [m],y [m],z [m]\n";
        for (Eigen::Index j = 0; j < map.rows(); ++j)
            for (Eigen::Index i = 0; i < map.columns(); ++i)
                text += fstiff::detail::shortest_text(static_cast<double>(i) * map.dx) + ',' +
                        fstiff::detail::shortest_text(static_cast<double>(j) * map.dy) + ',' +
                        detail::map_cell(map.heights(j, i)) + '\n';
    }
    detail::put_text(output, text);
}

}  // namespace fstiff::inline v0_1::io
