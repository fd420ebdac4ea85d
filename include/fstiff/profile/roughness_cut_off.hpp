// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// lambda_c of a profile from the table of the standards (surface/nesting_indices), by the roughness itself.
///
///     row: the first whose Ra, measured with its own lambda_c, is in its range
///     among those that the profile can contain: 5 lambda_c <= length, 5 steps <= lambda_c, 30 lambda_s <= lambda_c
///
/// Ra grows with lambda_c, so that the Ra of the first such row is above the ranges of the rows before it: the choice
/// is consistent in the sense of the standard. Without such a row the longest lambda_c of the profile is used.
///
/// Reference   ISO 4288:1996, 7.2 and Table 1, which ISO 21920-3:2021 keeps as its last resort.
/// Units       [m]
/// Valid       a profile without its form
/// Accuracy    that of gaussian_roughness() (tests/profile/roughness_cut_off_test.cpp)

#include <fstiff/profile/gaussian_filter.hpp>
#include <fstiff/surface/nesting_indices.hpp>

namespace fstiff::inline v0_1::parts {

/// Reason for the value of lambda_c.
enum class CutOffReason {
    roughness,   ///< Ra belongs to it
    length,      ///< Ra belongs to a longer one, which the length does not hold
    step,        ///< Ra belongs to a shorter one, which the step or lambda_s does not allow
    too_short,   ///< none: five of the shortest do not fit the length
    too_coarse,  ///< none: those that fit the length are too short for the step or lambda_s
    given,       ///< requested, or no filter requested; no outcome of roughness_cut_off()
    form_alone   ///< none: the form alone bounds the long waves; no outcome of roughness_cut_off()
};

/// Cut-off of the standards for one profile, with its reason.
template <Real T = double>
struct RoughnessCutOff {
    std::optional<T> lambda_c{};  ///< [m]
    T mean_deviation{};           ///< Ra after its filter [m]; 0: none
    CutOffReason reason{};
};

/// Ra of \p roughness, whose mean line is 0: mean of the absolute heights [m]. 0 where every point is missing.
template <Real T>
[[nodiscard]] T mean_deviation(const Profile<T>& roughness) {
    double sum = 0, points = 0;
    for (const T z : roughness.heights)
        if (!std::isnan(z)) sum += std::abs(z), points += 1;
    return points > 0 ? static_cast<T>(sum / points) : T(0);
}

/// lambda_c of \p profile after filtering with \p lambda_s (0: none). \throws domain_error for a profile out of range.
template <Real T>
[[nodiscard]] RoughnessCutOff<T> roughness_cut_off(const Profile<T>& profile, std::type_identity_t<T> lambda_s = 0) {
    RoughnessCutOff<T> choice;
    const T length = static_cast<T>(profile.size()) * profile.spacing * (1 + T(1e-6));
    const T shortest =
        (std::max)(5 * profile.spacing, static_cast<T>(min_ratio_of_cut_offs) * lambda_s) * (1 - T(1e-6));
    bool fits = false, skipped = false;
    for (const CutOffRow& row : cut_off_table) {
        const T lambda_c = static_cast<T>(row.lambda_c);
        if (lambda_c_of_length * lambda_c > length) break;
        fits = true;
        if (lambda_c < shortest) {
            skipped = true;
            continue;
        }
        choice.lambda_c = lambda_c;
        choice.mean_deviation = mean_deviation(gaussian_roughness(profile, lambda_c));
        choice.reason = CutOffReason::roughness;
        if (choice.mean_deviation <= static_cast<T>(row.max_ra)) {
            if (skipped && choice.mean_deviation <= static_cast<T>((&row - 1)->max_ra))
                choice.reason = CutOffReason::step;
            return choice;
        }
        skipped = false;
        if (&row != &cut_off_table.back()) choice.reason = CutOffReason::length;
    }
    if (!choice.lambda_c) choice.reason = fits ? CutOffReason::too_coarse : CutOffReason::too_short;
    return choice;
}

}  // namespace fstiff::inline v0_1::parts
