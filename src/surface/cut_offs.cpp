// SPDX-License-Identifier: BSD-3-Clause
#include "surface/surface_file.hpp"

#include <fstiff/double/surfaces.hpp>
#include "document/shown_unit.hpp"

namespace fstiff::surface {
namespace {

/// Where the index of lambda_s comes from.
std::string source_of_index(const CutOffs<double>& cut_offs) {
    switch (cut_offs.index_source) {
        case IndexSource::tip: return "of a tip of " + document::shown_length(cut_offs.tip_radius);
        case IndexSource::resolution: return "of the resolution";
        case IndexSource::step: break;
    }
    return "of five steps of " + document::shown_length(cut_offs.step);
}

/// Why lambda_s is so, or why there is none; empty where it was given.
std::string why_lambda_s(const CutOffs<double>& cut_offs) {
    const std::string index = document::shown_length(cut_offs.index), why = source_of_index(cut_offs);
    switch (cut_offs.why_s) {
        case LambdaSReason::given: break;
        case LambdaSReason::by_table: return "by the table, the index " + why;
        case LambdaSReason::too_short:
            return "as measured; " + std::to_string(detail::lambda_s_of_length) + " of " + index + ", the index " +
                   why + ", do not fit the length of " + document::shown_length(cut_offs.length);
        case LambdaSReason::not_below_lambda_c:
            return "as measured; " + index + ", the index " + why + ", is not below lambda_c";
    }
    return "";
}

/// Why lambda_c is so, or why there is none; empty where it was given.
std::string why_lambda_c(const CutOffs<double>& cut_offs) {
    const std::string of_ra = "by the table, of Ra " + document::shown_length(cut_offs.mean_deviation, 3);
    const std::string length = document::shown_length(cut_offs.length);
    switch (cut_offs.why_c) {
        case CutOffReason::given: break;
        case CutOffReason::roughness: return of_ra;
        case CutOffReason::length:
            return of_ra + ", whose row is longer: the longest that fits five times into the length of " + length;
        case CutOffReason::step: return of_ra + ", whose row is shorter: the shortest that the step and lambda_s allow";
        case CutOffReason::too_short:
            return "the length of " + length + " does not hold five of " +
                   document::shown_length(detail::cut_off_table.front().lambda_c) + ", the shortest of the table";
        case CutOffReason::too_coarse:
            return "those of the table that the length of " + length + " holds are too short for the step";
        case CutOffReason::form_alone: return "the form alone bounds the long waves";
    }
    return "";
}

/// Points to which the robust filter gave no weight.
std::string left_out(const std::optional<RobustOutcome>& robust) {
    if (!robust) return "";
    return ", " + std::to_string(robust->left_out) + " of " + std::to_string(robust->points) +
           " points without weight, " + std::to_string(robust->iterations) + " iterations" +
           (robust->converged ? "" : ", not converged");
}

}  // namespace

Instrument instrument_of(const SurfaceOptions& options) {
    const auto length = [&](const Amount& given, const char* key) {
        return given.empty() ? 0. : parse_length(given, options.name(key));
    };
    return {length(options.tip_radius, "tip_radius"), length(options.resolution, "resolution")};
}

fstiff::MeasureOptions<double> library_options(const SurfaceOptions& options) {
    fstiff::MeasureOptions<double> measuring;
    measuring.lambda_s = parse_cut_off(options.lambda_s, options.name("lambda_s"));
    measuring.lambda_c = parse_cut_off(options.lambda_c, options.name("lambda_c"));
    measuring.filter = options.filter;
    const Instrument instrument = instrument_of(options);
    measuring.tip_radius = instrument.tip_radius, measuring.resolution = instrument.resolution;
    return measuring;
}

void require_cut_offs(const SurfaceOptions& options, const fstiff::MeasureOptions<double>& given, double step,
                      double length) {
    const auto refused = detail::refused_cut_off(given, step, length);
    if (!refused) return;
    const std::string short_name = options.name("lambda_s"), long_name = options.name("lambda_c");
    const std::string& name = refused->long_waves ? long_name : short_name;
    const std::string quoted =
        name + " = \"" + (refused->long_waves ? options.lambda_c : options.lambda_s).text("m") + "\"";
    const int steps = refused->long_waves ? detail::min_steps_of_lambda_c : detail::min_steps_of_lambda_s;
    switch (refused->why) {
        case detail::CutOffRefusal::below_steps:
            throw domain_error(quoted + " cannot be held by this file, whose points are " +
                               document::shown_length(step) + " apart: must be at least " + std::to_string(steps) +
                               " steps, " + document::shown_length(refused->limit));
        case detail::CutOffRefusal::above_length:
            throw domain_error(quoted + ": must be at most the length of the surface, " +
                               document::shown_length(length));
        case detail::CutOffRefusal::not_below_lambda_c:
            throw domain_error(name + " = " + document::shown_length(refused->given) + ": must be less than " +
                               long_name + ", " + document::shown_length(refused->limit));
    }
}

std::string sentence_of(const CutOffs<double>& cut_offs) {
    const std::string why_s = why_lambda_s(cut_offs), why_c = why_lambda_c(cut_offs);
    const std::string s = why_s.empty() ? "" : why_s + "; ", c = why_c.empty() ? "" : why_c + "; ";
    const auto &lambda_s = cut_offs.lambda_s, &lambda_c = cut_offs.lambda_c;
    return (lambda_s
                ? "lambda_s " + document::shown_length(*lambda_s) + " (" + s + "Gaussian, after the form was removed)"
                : "lambda_s none (" + (why_s.empty() ? "as measured" : why_s) + ")") +
           ", " +
           (lambda_c ? "lambda_c " + document::shown_length(*lambda_c) + " (" + c +
                           (cut_offs.filter == CutOffFilter::robust ? "robust Gaussian" : "Gaussian") + ", after " +
                           (lambda_s ? "lambda_s" : "the form was removed") + left_out(cut_offs.robust) + ")"
                     : "lambda_c none" + (why_c.empty() ? "" : " (" + why_c + ")"));
}

}  // namespace fstiff::surface
