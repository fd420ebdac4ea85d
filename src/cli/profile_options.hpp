// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// What `fit` and `peaks` share: the options that say how a measured profile is read, and the reading.

#include "output.hpp"
#include "sha256.hpp"

#include <fstiff/io/delimited.hpp>
#include <fstiff/profile/detrend.hpp>

#include <sstream>
#include <string>

namespace fstiff::cli {

struct ProfileOptions {
    std::string file;
    std::string spacing, units;
    int column = 0;
    std::string form = "line";
};

/// A profile with its form removed, and what is worth telling about the file.
struct Measured {
    Profile<double> profile;
    double rms_height_as_read = 0;  ///< [m], before the form was removed
    double rms_height = 0;          ///< [m], after
    io::DelimitedRecord record;
    std::string sha256;
};

/// Adds --spacing, --units, --column and --detrend.
inline void add_profile_options(CLI::App& command, ProfileOptions& options) {
    command.add_option("--spacing", options.spacing,
                       "distance of neighbouring points, such as \"0.5 um\"; replaces that of the file");
    command.add_option("--units", options.units, "units of positions and heights, such as um,nm, or one for both");
    command
        .add_option("--column", options.column, "column of the heights, counted from 1; default the last of one or two")
        ->check(CLI::Range(1, 1000000));
    command.add_option("--detrend", options.form, "form that is removed: none, mean, line (default) or parabola")
        ->check(CLI::IsMember({"none", "mean", "line", "parabola"}));
}

/// Runs \p call; what it throws is put after the name of the file.
template <class Call>
auto about_file(const std::string& file, const Call& call) {
    try {
        return call();
    } catch (const domain_error& error) {
        throw domain_error(display_name(file) + ": " + error.what());
    }
}

inline Measured measure(const ProfileOptions& options) {
    io::DelimitedOptions how;
    if (!options.spacing.empty()) {
        how.spacing = io::parse_quantity(options.spacing, io::Dimension::length, "--spacing");
        require_positive("--spacing", *how.spacing);
    }
    how.units = options.units;
    how.column = static_cast<std::size_t>(options.column);
    const std::string bytes = read_all(options.file);
    std::istringstream stream(bytes);
    const io::DelimitedProfile read = io::read_profile(stream, display_name(options.file), how);

    const Form form = options.form == "none"   ? Form::none
                      : options.form == "mean" ? Form::mean
                      : options.form == "line" ? Form::line
                                               : Form::parabola;
    return about_file(options.file, [&] {
        Profile<double> profile = detrend(read.profile, form);
        const double before = fstiff::rms_height(read.profile), after = fstiff::rms_height(profile);
        return Measured{std::move(profile), before, after, read.record, sha256(bytes)};
    });
}

/// The file and what was decided about it, for a JSON document.
inline Json json_source(const ProfileOptions& options, const Measured& measured) {
    return {
        {"file", display_name(options.file)}, {"sha256", measured.sha256}, {"decisions", measured.record.sentences()}};
}

}  // namespace fstiff::cli
