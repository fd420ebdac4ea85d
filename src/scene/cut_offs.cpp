// SPDX-License-Identifier: BSD-3-Clause
#include "scene/cut_offs.hpp"

#include "scene/shown_unit.hpp"
#include "scene/surface_file.hpp"
#include "scene/surface_instances.hpp"

#include <fstiff/profile/roughness_cut_off.hpp>

#include <algorithm>
#include <limits>

namespace fstiff::scene {
namespace {

/// How many lambda_s along the shorter side a lambda_s by the table leaves at least.
constexpr int lambda_s_of_length = 10;

std::string named(const SurfaceOptions& options, const char* before, const char* after) {
    const std::string prefix(options.prefix);
    return prefix + before + (prefix.empty() ? "_" : "-") + after;
}

/// The cut-off of \p text for a surface of \p step and of \p length, which messages call \p name.
std::optional<double> cut_off(const std::string& text, const std::string& name, int least, double step, double length) {
    if (is_automatic(text) || text == "none") return {};
    constexpr double slack = 4 * std::numeric_limits<double>::epsilon();
    const double value = parse_length(text, name);
    if (value < least * step * (1 - slack))
        throw domain_error(name + " = \"" + text + "\" cannot be held by this file, whose points are " +
                           shown_length(step) + " apart: must be at least " + std::to_string(least) + " steps, " +
                           shown_length(least * step));
    if (value > length * (1 + slack))
        throw domain_error(name + " = \"" + text + "\": must be at most the length of the surface, " +
                           shown_length(length));
    return std::min(value, length);
}

/// lambda_s by the table into \p cut_offs, whose lambda_c is known where it was given.
void choose_lambda_s(CutOffs& cut_offs, const SurfaceOptions& options, double step, double length) {
    const auto known = [&](const std::string& text, const std::string& name) {
        return text.empty() ? 0. : parse_length(text, name);
    };
    const double resolution = known(options.resolution, std::string(options.prefix) + "resolution");
    const double tip = known(options.tip_radius, named(options, "tip", "radius"));
    const double index = shortest_lambda_s(step, resolution, tip);
    const std::string why = tip > 0 && index > shortest_lambda_s(step, resolution) ? "of a tip of " + shown_length(tip)
                            : resolution > 0 && index > shortest_lambda_s(step) * (1 + 1e-12)
                                ? "of the resolution"
                                : "of five steps of " + shown_length(step);
    if (lambda_s_of_length * index > length * (1 + 1e-6))
        cut_offs.why_s = "as measured; " + std::to_string(lambda_s_of_length) + " of " + shown_length(index) +
                         ", the index " + why + ", do not fit the length of " + shown_length(length);
    else if (cut_offs.lambda_c && index >= *cut_offs.lambda_c)
        cut_offs.why_s = "as measured; " + shown_length(index) + ", the index " + why + ", is not below lambda_c";
    else {
        cut_offs.lambda_s = index;
        cut_offs.why_s = "by the table, the index " + why;
    }
}

}  // namespace

bool is_automatic(const std::string& cut_off) { return cut_off.empty() || cut_off == "auto"; }

CutOffs cut_offs_of(const SurfaceOptions& options, double step, double length) {
    const std::string short_name = named(options, "lambda", "s"), long_name = named(options, "lambda", "c");
    return about_file(options.file, [&] {
        CutOffs found{cut_off(options.lambda_s, short_name, 2, step, length),
                      cut_off(options.lambda_c, long_name, 5, step, length),
                      {},
                      {},
                      options.filter,
                      {}};
        if (options.detrend == gaussian_form)
            found.lambda_c = parse_length(options.cutoff, std::string(options.prefix) + "cutoff");
        if (found.lambda_s && found.lambda_c && *found.lambda_s >= *found.lambda_c)
            throw domain_error(short_name + " = " + shown_length(*found.lambda_s) + ": must be less than " + long_name +
                               ", " + shown_length(*found.lambda_c));
        if (is_automatic(options.lambda_s)) choose_lambda_s(found, options, step, length);
        return found;
    });
}

void choose_lambda_c(CutOffs& cut_offs, const Profile<double>& profile) {
    const auto [lambda_c, ra, reason] = roughness_cut_off(profile, cut_offs.lambda_s.value_or(0));
    cut_offs.lambda_c = lambda_c;
    const std::string of_ra = lambda_c ? "by the table, of Ra " + shown_length(ra, 3) : std::string();
    const std::string length = shown_length(profile.length());
    switch (reason) {
        case CutOffReason::roughness:
            cut_offs.why_c = of_ra;
            break;
        case CutOffReason::length:
            cut_offs.why_c =
                of_ra + ", whose row is longer: the longest of which the length of " + length + " holds five";
            break;
        case CutOffReason::step:
            cut_offs.why_c = of_ra + ", whose row is shorter: the shortest that the step and lambda_s allow";
            break;
        case CutOffReason::too_short:
            cut_offs.why_c = "the length of " + length + " does not hold five of " +
                             shown_length(cut_off_table.front().lambda_c) + ", the shortest of the table";
            break;
        case CutOffReason::too_coarse:
            cut_offs.why_c = "those of the table that the length of " + length + " holds are too short for the step";
    }
}

std::string CutOffs::sentence() const {
    const std::string s = why_s.empty() ? "" : why_s + "; ", c = why_c.empty() ? "" : why_c + "; ";
    return (lambda_s ? "lambda_s " + shown_length(*lambda_s) + " (" + s + "Gaussian, after the form was removed)"
                     : "lambda_s none (" + (why_s.empty() ? "as measured" : why_s) + ")") +
           ", " +
           (lambda_c ? "lambda_c " + shown_length(*lambda_c) + " (" + c +
                           (filter == CutOffFilter::robust ? "robust Gaussian" : "Gaussian") + ", after " +
                           (lambda_s ? "lambda_s" : "the form was removed") + left_out + ")"
                     : "lambda_c none" + (why_c.empty() ? "" : " (" + why_c + ")"));
}

}  // namespace fstiff::scene
