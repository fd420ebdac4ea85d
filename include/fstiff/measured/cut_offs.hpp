// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The cut-offs of a measurement: given, chosen by the tables of the standards, or none, with the reason.
/// A contact feels every wave up to its own size: lambda_c is none unless it is given.
///
///     lambda_s    least nesting index >= 5 steps and >= resolution; that of the tip where it is longer;
///                 none where 10 of it do not fit the surface, or where it is not below a given lambda_c
///     lambda_c    none; for Ra, Rq and the other parameters of ISO 21920 that of with_drawing_cut_off()
///     neighbours  lambda_s/sqrt(2) and sqrt(2) lambda_s; 2 lambda_s alone where the first is below 2 steps;
///                 without lambda_s 4 steps
///
/// Reference   ISO 21920-3:2021, ISO 25178-3:2012 through surface/nesting_indices.hpp; a surface without lambda_c is
///             the S-F surface of ISO 25178-2:2012. The limits of 10, 2 and 5 and the neighbours are this project's.
/// Units       lengths [m]
/// Valid       a given lambda_s has 2 steps at least, a given lambda_c 5; neither exceeds the length of the surface,
///             and lambda_s is below lambda_c
/// Accuracy    that of nesting_index() and roughness_cut_off() (tests/measured/cut_offs_test.cpp)

#include <fstiff/core/numbers.hpp>
#include <fstiff/measured/measure_options.hpp>
#include <fstiff/profile/roughness_cut_off.hpp>

#include <limits>
#include <vector>

namespace fstiff::inline v0_1::parts {

/// Steps that a given lambda_s, a given lambda_c holds at least.
inline constexpr int min_steps_of_lambda_s = 2, min_steps_of_lambda_c = 5;
/// How many lambda_s of the tables the surface holds at least.
inline constexpr int lambda_s_of_length = 10;

/// Why lambda_s is what it is.
enum class LambdaSReason {
    given,              ///< asked for, or none was asked for
    by_table,           ///< the index of the tables
    too_short,          ///< none: ten of the index do not fit the surface
    not_below_lambda_c  ///< none: the index is not below the lambda_c that was given
};

/// What the index of the tables comes from.
enum class IndexSource { step, resolution, tip };

/// The outcome of the robust filter of lambda_c.
struct RobustOutcome {
    std::size_t left_out{}, points{};  ///< points without weight, and all
    int iterations{};
    bool converged{};
};

/// The cut-offs of a measurement and their reasons. The filters act after the form is removed, that of lambda_s first.
template <Real T = double>
struct CutOffs {
    std::optional<T> lambda_s{}, lambda_c{};  ///< [m]
    CutOffFilter filter = CutOffFilter::gaussian;
    LambdaSReason why_s = LambdaSReason::given;
    T index{};  ///< of the tables, whether it was taken or not [m]; 0: not asked for
    IndexSource index_source = IndexSource::step;
    CutOffReason why_c = CutOffReason::given;
    T mean_deviation{};                ///< Ra behind the lambda_c of the tables [m]; 0: none
    T step{}, length{}, tip_radius{};  ///< coarser step, shorter side, and the tip that was given [m]
    std::optional<RobustOutcome> robust{};

    [[nodiscard]] bool any() const { return lambda_s || lambda_c; }
};

/// What is wrong with a given cut-off.
enum class CutOffRefusal { below_steps, above_length, not_below_lambda_c };

/// A given cut-off that a surface cannot hold.
template <Real T = double>
struct RefusedCutOff {
    CutOffRefusal why{};
    bool long_waves{};   ///< lambda_c, else lambda_s
    T given{}, limit{};  ///< the cut-off, and the bound that it misses [m]
};

/// The first given cut-off of \p options that a surface of \p step (the coarser one) and \p length (the shorter side)
/// cannot hold.
template <Real T>
[[nodiscard]] std::optional<RefusedCutOff<T>> refused_cut_off(const MeasureOptions<T>& options,
                                                              std::type_identity_t<T> step,
                                                              std::type_identity_t<T> length) {
    constexpr T slack = 4 * std::numeric_limits<T>::epsilon();
    const auto refused = [&](const CutOff<T>& one, bool long_waves, int steps) -> std::optional<RefusedCutOff<T>> {
        if (!one.length()) return {};
        const T given = *one.length(), shortest = static_cast<T>(steps) * step;
        if (!(given >= shortest * (1 - slack)))
            return RefusedCutOff<T>{CutOffRefusal::below_steps, long_waves, given, shortest};
        if (given > length * (1 + slack))
            return RefusedCutOff<T>{CutOffRefusal::above_length, long_waves, given, length};
        return {};
    };
    if (const auto found = refused(options.lambda_s, false, min_steps_of_lambda_s)) return found;
    if (const auto found = refused(options.lambda_c, true, min_steps_of_lambda_c)) return found;
    const std::optional<T> longest = options.form_cut_off ? options.form_cut_off : options.lambda_c.length();
    if (options.lambda_s.length() && longest && *options.lambda_s.length() >= *longest)
        return RefusedCutOff<T>{CutOffRefusal::not_below_lambda_c, false, *options.lambda_s.length(), *longest};
    return {};
}

/// \throws domain_error for a given cut-off that the surface cannot hold.
template <Real T>
void require_cut_offs(const MeasureOptions<T>& options, T step, T length) {
    const auto found = refused_cut_off(options, step, length);
    if (!found) return;
    const std::string limit = rounded_text(found->limit, 5) + " m";
    const int steps = found->long_waves ? min_steps_of_lambda_c : min_steps_of_lambda_s;
    refuse(found->long_waves ? "lambda_c" : "lambda_s", found->given,
           found->why == CutOffRefusal::below_steps    ? "at least " + std::to_string(steps) + " steps, " + limit
           : found->why == CutOffRefusal::above_length ? "at most the length of the surface, " + limit
                                                       : "less than lambda_c, " + limit);
}

/// lambda_s of the tables into \p found, whose lambda_c is known where it was given.
template <Real T>
void choose_lambda_s(CutOffs<T>& found, T resolution) {
    found.index = shortest_lambda_s(found.step, resolution, found.tip_radius);
    if (found.tip_radius > T(0) && found.index > shortest_lambda_s(found.step, resolution))
        found.index_source = IndexSource::tip;
    else if (resolution > T(0) && found.index > shortest_lambda_s(found.step) * (1 + T(1e-12)))
        found.index_source = IndexSource::resolution;
    if (lambda_s_of_length * found.index > found.length * (1 + T(1e-6)))
        found.why_s = LambdaSReason::too_short;
    else if (found.lambda_c && found.index >= *found.lambda_c)
        found.why_s = LambdaSReason::not_below_lambda_c;
    else {
        found.why_s = LambdaSReason::by_table;
        found.lambda_s = found.index;
    }
}

/// What was given, and lambda_s by the tables where it was not.
template <Real T>
[[nodiscard]] CutOffs<T> given_cut_offs(const MeasureOptions<T>& options, T step, T length) {
    require_cut_offs(options, step, length);
    const auto given = [&](const CutOff<T>& one) {
        return one.length() ? std::optional<T>((std::min)(*one.length(), length)) : std::nullopt;
    };
    CutOffs<T> found;
    found.lambda_s = given(options.lambda_s);
    found.lambda_c = options.form_cut_off ? options.form_cut_off : given(options.lambda_c);
    if (options.lambda_c.automatic() && !options.form_cut_off) found.why_c = CutOffReason::form_alone;
    found.filter = options.filter;
    found.step = step, found.length = length, found.tip_radius = options.tip_radius;
    if (options.lambda_s.automatic()) choose_lambda_s(found, options.resolution);
    return found;
}

/// Cut-offs for \p profile. \throws domain_error for a given one that the profile cannot hold.
template <Real T>
[[nodiscard]] CutOffs<T> choose_cut_offs(const Profile<T>& profile, const MeasureOptions<T>& options = {}) {
    return given_cut_offs(options, profile.spacing, profile.length());
}

/// Cut-offs for \p map. \throws domain_error as above.
template <Real T>
[[nodiscard]] CutOffs<T> choose_cut_offs(const HeightMap<T>& map, const MeasureOptions<T>& options = {}) {
    if (options.form_cut_off)
        refuse("form_cut_off", *options.form_cut_off, "left out for a map: it belongs to the form of a profile");
    return given_cut_offs(options, (std::max)(map.dx, map.dy),
                          (std::min)(static_cast<T>(map.columns()) * map.dx, static_cast<T>(map.rows()) * map.dy));
}

/// The lambda_s [m] of the neighbours of a surface of \p step [m] (the coarser one) that was measured with \p lambda_s:
/// a factor of two between them.
template <Real T>
[[nodiscard]] std::vector<T> neighbouring_lambda_s(const std::optional<T>& lambda_s, std::type_identity_t<T> step) {
    if (!lambda_s) return {4 * step};
    const T root = numbers::sqrt2_v<T>;
    if (*lambda_s / root < min_steps_of_lambda_s * step) return {2 * *lambda_s};
    return {*lambda_s / root, *lambda_s * root};
}

}  // namespace fstiff::inline v0_1::parts
