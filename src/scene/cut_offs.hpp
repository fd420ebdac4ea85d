// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The cut-offs of a measurement: given, chosen by the table of the standards, or none, with the reason.

#include <fstiff/core/names.hpp>
#include <fstiff/profile/profile.hpp>

#include <algorithm>
#include <optional>
#include <string>

namespace fstiff::scene {

struct SurfaceOptions;

/// The filter of lambda_c: its mean line (surface) is drawn by grooves and spikes, or not.
enum class CutOffFilter { gaussian, robust };
}  // namespace fstiff::scene

namespace fstiff {
template <>
inline constexpr auto names<scene::CutOffFilter> = name_list<scene::CutOffFilter>(
    {{scene::CutOffFilter::gaussian, "gaussian"}, {scene::CutOffFilter::robust, "robust"}});
}  // namespace fstiff

namespace fstiff::scene {

/// The cut-offs of the Gaussian filters (ISO 16610-21 of profiles, -61 of maps) that act once the form is removed.
struct CutOffs {
    std::optional<double> lambda_s, lambda_c;  ///< of the short waves, and then of the long ones [m]
    std::string why_s, why_c;                  ///< why they are so, or why there is none; empty where they were given
    CutOffFilter filter = CutOffFilter::gaussian;  ///< of lambda_c
    std::string left_out;                          ///< what the robust filter took for no surface, in words

    [[nodiscard]] bool any() const { return lambda_s || lambda_c; }
    [[nodiscard]] std::string sentence() const;
};

/// Whether \p text leaves the choice to the table.
[[nodiscard]] bool is_automatic(const std::string& cut_off);

/// Of a surface of \p step (the coarser one) and \p length (the shorter one): what was given, and lambda_s by the table where
/// it was not. lambda_c by the table needs the heights, see choose_lambda_c().
/// \throws domain_error for a cut-off that was given and that the surface cannot hold.
[[nodiscard]] CutOffs cut_offs_of(const SurfaceOptions& options, double step, double length);

/// lambda_c of \p profile, which has lost its form and the waves below lambda_s, by the table into \p cut_offs.
void choose_lambda_c(CutOffs& cut_offs, const Profile<double>& profile);

}  // namespace fstiff::scene
