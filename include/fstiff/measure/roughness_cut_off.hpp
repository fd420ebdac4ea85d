// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// lambda_c of a profile from the table of the standards (measure/cut_offs), by the roughness itself.
///
///     periodic: the row of RSm, where 2 lambda_c <= length; RSm is the period (measure/lay.hpp) of the profile,
///     or of the profile without the waves above the longest lambda_c that fits five times
///     else the row: the first whose Ra, measured with its own lambda_c, is in its range
///     among those that the profile can contain: 5 lambda_c <= length, 5 steps <= lambda_c, 30 lambda_s <= lambda_c
///
/// Ra grows with lambda_c, so that the Ra of the first such row is above the ranges of the rows before it, as the
/// standard expects. Without such a row it is the longest lambda_c of the profile. Ra would confirm any lambda_c that
/// removes the waves of a periodic profile.
/// Reference   ISO 4288:1996, 7.2 and Tables 1 and 3, the last resort of ISO 21920-3:2021; 2 lambda_c: this project's
/// Units       [m]
/// Valid       a profile without its form
/// Accuracy    that of gaussian_roughness() (tests/measure/roughness_cut_off_test.cpp)

#include <fstiff/measure/cut_offs.hpp>
#include <fstiff/measure/lay.hpp>
#include <fstiff/profile/autocorrelation.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace fstiff { inline namespace v0_1 {

/// Reason for the value of lambda_c.
enum class CutOffReason {
    spacing,     ///< RSm of a profile that repeats itself belongs to it
    roughness,   ///< Ra belongs to it
    length,      ///< Ra or RSm belongs to a longer one, which the length does not hold
    step,        ///< Ra or RSm belongs to a shorter one, which the step or lambda_s does not allow
    too_short,   ///< none: five of the shortest do not fit the length
    too_coarse,  ///< none: those that fit the length are too short for the step or lambda_s
    given,       ///< requested, or no filter requested; no outcome of roughness_cut_off()
    form_alone   ///< none: the form alone bounds the long waves; no outcome of roughness_cut_off()
};

}}  // namespace fstiff

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Cut-off of the standards for one profile, with its reason.
template <Real T = double>
struct RoughnessCutOff {
    std::optional<T> lambda_c{};  ///< [m]
    T mean_deviation{};           ///< Ra after its filter [m]; 0: none
    CutOffReason reason{};
    T spacing{};  ///< RSm that determines it, the period of the profile [m]; 0: none
};

/// Ra of \p roughness, whose mean line is 0: mean of the absolute heights [m]. 0 where every point is missing.
template <Real T>
[[nodiscard]] T mean_deviation(const Profile<T>& roughness) {
    double sum = 0, points = 0;
    for (const T z : roughness.heights)
        if (!std::isnan(z)) sum += std::abs(z), points += 1;
    return points > 0 ? static_cast<T>(sum / points) : T(0);
}

/// Longest lambda_c of the table that is at least \p shortest and fits \p times into \p length; 0 for none.
template <Real T>
[[nodiscard]] T longest_lambda_c(T length, int times, std::type_identity_t<T> shortest) {
    T longest = 0;
    for (const CutOffRow& row : cut_off_table)
        if (const T lambda_c = static_cast<T>(row.lambda_c);
            within_class(static_cast<T>(times) * lambda_c, length) && within_class(shortest, lambda_c))
            longest = lambda_c;
    return longest;
}

/// Period of \p profile, or of its roughness after the longest lambda_c that fits five times; 0 where neither repeats
/// itself.
template <Real T>
[[nodiscard]] T period(const Profile<T>& profile, std::type_identity_t<T> length) {
    const auto period = [](const Profile<T>& line) {
        const Repetition<T> found = repetition(autocorrelation(line));
        return found.is_lay() ? found.period : T(0);
    };
    if (const T found = period(profile); found > T(0)) return found;
    const T lambda_c = longest_lambda_c(length, lambda_c_of_length, 5 * profile.spacing);
    return lambda_c > T(0) ? period(gaussian_roughness(profile, lambda_c)) : T(0);
}

/// lambda_c by RSm = \p spacing, of those that are at least \p shortest; none beyond the table.
template <Real T>
[[nodiscard]] RoughnessCutOff<T> spacing_cut_off(T spacing, std::type_identity_t<T> length,
                                                 std::type_identity_t<T> shortest) {
    RoughnessCutOff<T> choice;
    choice.spacing = spacing;
    for (const CutOffRow& row : cut_off_table) {
        if (!within_class(spacing, static_cast<T>(row.max_spacing))) continue;
        choice.reason = choice.reason == CutOffReason::step || !within_class(shortest, static_cast<T>(row.lambda_c))
                            ? CutOffReason::step
                            : CutOffReason::spacing;
        choice.lambda_c = static_cast<T>(row.lambda_c);
        if (within_class(shortest, *choice.lambda_c)) break;
    }
    if (!choice.lambda_c || within_class(T(lambda_c_of_periodic_length) * *choice.lambda_c, length)) return choice;
    choice.reason = CutOffReason::length;
    choice.lambda_c.reset();
    if (const T longest = longest_lambda_c(length, lambda_c_of_length, shortest); longest > T(0))
        choice.lambda_c = longest;
    return choice;
}

/// lambda_c of \p profile after filtering with \p lambda_s (0: none). \throws domain_error for a profile out of range.
template <Real T>
[[nodiscard]] RoughnessCutOff<T> roughness_cut_off(const Profile<T>& profile, std::type_identity_t<T> lambda_s = 0) {
    const T length = static_cast<T>(profile.size()) * profile.spacing;
    const T shortest = (std::max)(5 * profile.spacing, static_cast<T>(min_ratio_of_cut_offs) * lambda_s);
    RoughnessCutOff<T> choice;
    if (const T spacing = period(profile, length); spacing > T(0)) choice = spacing_cut_off(spacing, length, shortest);
    if (choice.lambda_c) {
        choice.mean_deviation = mean_deviation(gaussian_roughness(profile, *choice.lambda_c));
        return choice;
    }
    choice.spacing = 0;
    bool fits = false, skipped = false;
    for (const CutOffRow& row : cut_off_table) {
        const T lambda_c = static_cast<T>(row.lambda_c);
        if (!within_class(lambda_c_of_length * lambda_c, length)) break;
        fits = true;
        if (!within_class(shortest, lambda_c)) {
            skipped = true;
            continue;
        }
        choice.lambda_c = lambda_c;
        choice.mean_deviation = mean_deviation(gaussian_roughness(profile, lambda_c));
        choice.reason = CutOffReason::roughness;
        if (within_class(choice.mean_deviation, static_cast<T>(row.max_ra))) {
            if (skipped && within_class(choice.mean_deviation, static_cast<T>((&row - 1)->max_ra)))
                choice.reason = CutOffReason::step;
            return choice;
        }
        skipped = false;
        if (&row != &cut_off_table.back()) choice.reason = CutOffReason::length;
    }
    if (!choice.lambda_c) choice.reason = fits ? CutOffReason::too_coarse : CutOffReason::too_short;
    return choice;
}

/// Minimum number of steps in a given lambda_s and in a given lambda_c.
inline constexpr int min_steps_of_lambda_s = 2, min_steps_of_lambda_c = 5;
/// Minimum number of tabulated lambda_s in the length of the surface.
inline constexpr int lambda_s_of_length = 10;

}}}  // namespace fstiff::detail

namespace fstiff { inline namespace v0_1 {

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
    T spacing{};                       ///< RSm that determined lambda_c, the period of the profile [m]; 0: none
    T step{}, length{}, tip_radius{};  ///< coarser step, shorter side, and the tip that was given [m]
    std::optional<RobustOutcome> robust{};

    [[nodiscard]] bool any() const { return lambda_s || lambda_c; }
};

}}  // namespace fstiff

namespace fstiff { inline namespace v0_1 { namespace detail {

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
    const auto refused = [&](const CutOff<T>& cut_off, bool long_waves, int steps) -> std::optional<RefusedCutOff<T>> {
        if (!cut_off.length()) return {};
        const T given = *cut_off.length(), shortest = static_cast<T>(steps) * step;
        if (!(given >= shortest * (1 - slack)))
            return RefusedCutOff<T>{CutOffRefusal::below_steps, long_waves, given, shortest};
        if (given > length * (1 + slack))
            return RefusedCutOff<T>{CutOffRefusal::above_length, long_waves, given, length};
        return {};
    };
    if (const auto refusal = refused(options.lambda_s, false, min_steps_of_lambda_s)) return refusal;
    if (const auto refusal = refused(options.lambda_c, true, min_steps_of_lambda_c)) return refusal;
    const std::optional<T> longest = options.form_cut_off ? options.form_cut_off : options.lambda_c.length();
    if (options.lambda_s.length() && longest && *options.lambda_s.length() >= *longest)
        return RefusedCutOff<T>{CutOffRefusal::not_below_lambda_c, false, *options.lambda_s.length(), *longest};
    return {};
}

/// \throws domain_error for a given cut-off that is not valid for the surface.
template <Real T>
void require_cut_offs(const MeasureOptions<T>& options, T step, T length) {
    const auto refusal = refused_cut_off(options, step, length);
    if (!refusal) return;
    const std::string limit = rounded_text(refusal->limit, 5) + " m";
    const int steps = refusal->long_waves ? min_steps_of_lambda_c : min_steps_of_lambda_s;
    refuse(refusal->long_waves ? "lambda_c" : "lambda_s", refusal->given,
           refusal->why == CutOffRefusal::below_steps    ? "at least " + std::to_string(steps) + " steps, " + limit
           : refusal->why == CutOffRefusal::above_length ? "at most the length of the surface, " + limit
                                                         : "less than lambda_c, " + limit);
}

/// Sets lambda_s of \p cut_offs from the tables; lambda_c of \p cut_offs is set where it was given.
template <Real T>
void choose_lambda_s(CutOffs<T>& cut_offs, T resolution) {
    cut_offs.index = shortest_lambda_s(cut_offs.step, resolution, cut_offs.tip_radius);
    if (cut_offs.tip_radius > T(0) && cut_offs.index > shortest_lambda_s(cut_offs.step, resolution))
        cut_offs.index_source = IndexSource::tip;
    else if (resolution > T(0) && cut_offs.index > shortest_lambda_s(cut_offs.step) * (1 + T(1e-12)))
        cut_offs.index_source = IndexSource::resolution;
    if (!within_class(lambda_s_of_length * cut_offs.index, cut_offs.length))
        cut_offs.why_s = LambdaSReason::too_short;
    else if (cut_offs.lambda_c && cut_offs.index >= *cut_offs.lambda_c)
        cut_offs.why_s = LambdaSReason::not_below_lambda_c;
    else {
        cut_offs.why_s = LambdaSReason::by_table;
        cut_offs.lambda_s = cut_offs.index;
    }
}

/// Given cut-offs, and lambda_s from the tables where it was not given.
template <Real T>
[[nodiscard]] CutOffs<T> given_cut_offs(const MeasureOptions<T>& options, T step, T length) {
    require_cut_offs(options, step, length);
    const auto given = [&](const CutOff<T>& cut_off) {
        return cut_off.length() ? std::optional<T>((std::min)(*cut_off.length(), length)) : std::nullopt;
    };
    CutOffs<T> cut_offs;
    cut_offs.lambda_s = given(options.lambda_s);
    cut_offs.lambda_c = options.form_cut_off ? options.form_cut_off : given(options.lambda_c);
    if (options.lambda_c.automatic() && !options.form_cut_off) cut_offs.why_c = CutOffReason::form_alone;
    cut_offs.filter = options.filter;
    cut_offs.step = step, cut_offs.length = length, cut_offs.tip_radius = options.tip_radius;
    if (options.lambda_s.automatic()) choose_lambda_s(cut_offs, options.resolution);
    return cut_offs;
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

}}}  // namespace fstiff::detail
