// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Cut-offs of a measurement: given, chosen from the tables of the standards, or none, each with its reason.
///
///     lambda_s    smallest nesting index >= 5 steps and >= resolution; that of the tip where it is longer;
///                 none where the surface is shorter than 10 of it, or where it is not below a given lambda_c
///     lambda_c    none unless given, because K depends on all waves up to the size of the contact; for Ra, Rq and the
///                 other parameters of ISO 21920 that of with_drawing_cut_off()
///     neighbours  lambda_s/sqrt(2) and sqrt(2) lambda_s; only 2 lambda_s where the first is below 2 steps;
///                 4 steps for a surface without lambda_s
/// Reference   ISO 21920-3:2021, ISO 25178-3:2012 (surface/nesting_indices.hpp); a surface without lambda_c is the S-F
///             surface of ISO 25178-2:2012. The limits 10, 2, 5 and the neighbours are this project's.
/// Units       lengths [m]
/// Valid       a given lambda_s has at least 2 steps, a given lambda_c at least 5; neither exceeds the length of the
///             surface, and lambda_s is below lambda_c
/// Accuracy    that of nesting_index() and roughness_cut_off() (tests/measured/cut_offs_test.cpp)

#include <fstiff/measured/measure_options.hpp>
#include <fstiff/profile/roughness_cut_off.hpp>

#include <limits>
#include <numbers>
#include <vector>

namespace fstiff::inline v0_1::parts {

/// Minimum number of steps in a given lambda_s and in a given lambda_c.
inline constexpr int min_steps_of_lambda_s = 2, min_steps_of_lambda_c = 5;
/// Minimum number of tabulated lambda_s in the length of the surface.
inline constexpr int lambda_s_of_length = 10;

/// Reason for the value of lambda_s.
enum class LambdaSReason {
    given,              ///< requested, or no cut-off requested
    by_table,           ///< the index of the tables
    too_short,          ///< none: the surface is shorter than ten of the index
    not_below_lambda_c  ///< none: the index is not below the lambda_c that was given
};

/// Origin of the index from the tables.
enum class IndexSource { step, resolution, tip };

/// Outcome of the robust filter of lambda_c.
struct RobustOutcome {
    std::size_t left_out{}, points{};  ///< points without weight, and all
    int iterations{};
    bool converged{};
};

/// Cut-offs of a measurement and their reasons. The filters act after the removal of the form, that of lambda_s first.
template <Real T = double>
struct CutOffs {
    std::optional<T> lambda_s{}, lambda_c{};  ///< [m]
    CutOffFilter filter = CutOffFilter::gaussian;
    LambdaSReason why_s = LambdaSReason::given;
    T index{};  ///< of the tables, used or not [m]; 0: not requested
    IndexSource index_source = IndexSource::step;
    CutOffReason why_c = CutOffReason::given;
    T mean_deviation{};                ///< Ra after the lambda_c of the tables [m]; 0: none
    T step{}, length{}, tip_radius{};  ///< coarser step, shorter side, and the tip that was given [m]
    std::optional<RobustOutcome> robust{};

    [[nodiscard]] bool any() const { return lambda_s || lambda_c; }
};

/// Defect of a given cut-off.
enum class CutOffRefusal { below_steps, above_length, not_below_lambda_c };

/// A given cut-off that is not valid for a surface.
template <Real T = double>
struct RefusedCutOff {
    CutOffRefusal why{};
    bool long_waves{};   ///< lambda_c, else lambda_s
    T given{}, limit{};  ///< the cut-off, and the bound that it misses [m]
};

/// First given cut-off of \p options that is not valid for a surface of \p step (the coarser one) and \p length (the
/// shorter side); empty where all are valid.
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

/// \throws domain_error for a given cut-off that is not valid for the surface.
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

/// Sets lambda_s of \p found from the tables; lambda_c of \p found is set where it was given.
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

/// Given cut-offs, and lambda_s from the tables where it was not given.
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

/// Cut-offs for \p profile. \throws domain_error for a given one that is not valid for the profile.
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

/// lambda_s [m] of the neighbours of a surface of \p step [m] (the coarser one) measured with \p lambda_s; the
/// neighbours differ by a factor of two.
template <Real T>
[[nodiscard]] std::vector<T> neighbouring_lambda_s(const std::optional<T>& lambda_s, std::type_identity_t<T> step) {
    if (!lambda_s) return {4 * step};
    const T root = std::numbers::sqrt2_v<T>;
    if (*lambda_s / root < min_steps_of_lambda_s * step) return {2 * *lambda_s};
    return {*lambda_s / root, *lambda_s * root};
}

}  // namespace fstiff::inline v0_1::parts
