// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Preparation of a surface for measurement: cleaning, removal of the form, filters of the cut-offs, in this order.
///
///     clean()      crop, mask, offsets of scan lines, spikes, holes
///     prepare()    form, with its own cut-off if given; lambda_s; lambda_c if given
///
/// with_drawing_cut_off() adds the lambda_c of the tables for Ra, Rq and the other parameters of drawings. It is chosen
/// after the filter of lambda_s, from RSm or Ra of the filtered profile (measure/cut_offs).
///
/// Reference   ISO 21920-2:2021 and ISO 25178-2:2012 (the order of the operators F, S, L); ISO 16610-21, -31, -61 and
///             -71 (the filters)
/// Units       lengths [m]
/// Valid       as detrend(), remove_form() and the filters
/// Accuracy    that of the steps (tests/measure/prepare_test.cpp)

#include <fstiff/measure/cut_offs.hpp>
#include <fstiff/measure/roughness_cut_off.hpp>
#include <fstiff/profile/gaussian_filter.hpp>
#include <fstiff/profile/levelled_profile.hpp>
#include <fstiff/profile/profile.hpp>
#include <fstiff/profile/profile_repair.hpp>
#include <fstiff/topography/areal_statistics.hpp>
#include <fstiff/topography/form.hpp>
#include <fstiff/topography/gaussian_map_filter.hpp>
#include <fstiff/topography/map_repair.hpp>

#include <cmath>
#include <memory>
#include <utility>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Limits of Cleaning::spikes.
inline constexpr int min_spike_limit = 3, max_spike_limit = 1000;

/// Consecutive points of a line.
struct PointRange {
    std::size_t from{}, count{};
};

/// Points from \p from to \p to [m] of a line of \p points at \p step; a bound within rounding of a point includes it.
/// Empty unless the bounds rise and lie on the line; a count of 0 where no point lies between them.
template <Real T>
[[nodiscard]] std::optional<PointRange> points_between(T from, T to, std::size_t points, T step) {
    const T last = static_cast<T>(points - 1) * step, slack = T(1e-6) * step;
    if (!(from >= T(0) && from < to && to <= last + step)) return {};
    const auto begin = static_cast<std::size_t>(std::ceil((from - slack) / step));
    const auto end = (std::min)(points - 1, static_cast<std::size_t>(std::floor((to + slack) / step)));
    return begin > end ? PointRange{} : PointRange{begin, end - begin + 1};
}

}}}  // namespace fstiff::detail

namespace fstiff { inline namespace v0_1 {

/// Numbers of points that clean() changed.
struct CleaningReport {
    std::size_t columns_read{}, rows_read{};  ///< before the crop; a profile has one row
    std::size_t columns{}, rows{};            ///< after it
    std::size_t masked{};                     ///< became missing by the mask
    std::size_t aligned{};                    ///< lines whose offset was removed
    ScanAxis scan_axis{};                     ///< of these
    double line_step{};                       ///< rms step between them before [m]
    std::size_t spikes{};                     ///< became missing as spikes
    std::size_t filled{}, largest_hole{};
};

/// A profile without its form and without the waves beyond its cut-offs.
template <Real T = double>
struct PreparedProfile : LevelledProfile<T> {
    T rms_as_read{}, rms_levelled{}, rms{};  ///< Rq at first, without the form, and after the cut-offs [m]
    T rms_gradient{};                        ///< after them, root of twice the mean square slope between neighbours [1]
    CutOffs<T> cut_offs{};                   ///< lambda_c is the cut-off of the form where that has one
};

/// A map without its form and without the waves beyond its cut-offs.
template <Real T = double>
struct PreparedMap : LevelledMap<T> {
    T rms_as_read{}, rms_levelled{}, rms{};  ///< Sq at first, without the form, and after the cut-offs [m]
    ArealStatistics<T> areal{};              ///< after them
    CutOffs<T> cut_offs{};
};

}}  // namespace fstiff

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Crops, masks, removes spikes and fills, in this order.
/// \throws domain_error for a crop beyond the profile, a mask of another size, or a limit of spikes out of range.
template <Real T>
CleaningReport clean(Profile<T>& profile, const Cleaning<T>& cleaning);
template <Real T>
CleaningReport clean(HeightMap<T>& map, const Cleaning<T>& cleaning);

}}}  // namespace fstiff::detail

namespace fstiff { inline namespace v0_1 {

/// Removes the form of \p profile, then the waves below lambda_s, then those above lambda_c. Ignores options.cleaning.
/// \throws domain_error for cut-offs that are not valid for the profile, and as level() and the filters.
template <Real T>
[[nodiscard]] PreparedProfile<T> prepare(const Profile<T>& profile, const MeasureOptions<T>& options = {});

/// Same as above for a map.
template <Real T>
[[nodiscard]] PreparedMap<T> prepare(const HeightMap<T>& map, const MeasureOptions<T>& options = {});

/// Same as above; \p map is consumed, so that at most two maps are in memory.
template <Real T>
[[nodiscard]] PreparedMap<T> prepare(HeightMap<T>&& map, const MeasureOptions<T>& options = {});

/// Removes the waves above \p lambda_c from \p prepared, by default that of the tables, for the parameters of
/// ISO 21920. Returns it unchanged where one was given, or none requested.
/// \throws domain_error as roughness_cut_off() and the filter.
template <Real T>
[[nodiscard]] PreparedProfile<T> with_drawing_cut_off(PreparedProfile<T> prepared, const CutOff<T>& lambda_c = {});

}}  // namespace fstiff

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Removes only the form, once for several cut-offs; the maps of with_cut_offs() share `unfiltered`.
/// \throws domain_error as level().
template <Real T>
[[nodiscard]] PreparedMap<T> without_form(const HeightMap<T>& map, const MeasureOptions<T>& options = {});
template <Real T>
[[nodiscard]] PreparedMap<T> without_form(HeightMap<T>&& map, const MeasureOptions<T>& options = {});
/// Applies the filters of \p options to the result of without_form(). \throws domain_error as prepare().
template <Real T>
[[nodiscard]] PreparedMap<T> with_cut_offs(PreparedMap<T> prepared, const MeasureOptions<T>& options = {});

/// Points of \p axis that the crop keeps. \throws domain_error for a crop beyond the surface, or between two points.
template <Real T>
[[nodiscard]] PointRange cropped(const char* axis, T from, T to, std::size_t points, T step) {
    const auto range = points_between(from, to, points, step);
    const std::string name = std::string("crop along ") + axis + ", from";
    if (!range) refuse(name, from, "at least 0 and below its end, which lies on the surface");
    if (range->count == 0) refuse(name, from, "such that a point lies between it and its end");
    return *range;
}

/// Removes the points from \p heights that \p mask does not mark. Returns their number.
template <Real T>
std::size_t apply_mask(T* heights, const PointMask& mask) {
    std::size_t taken = 0;
    for (Eigen::Index k = 0; k < mask.size(); ++k) {
        if (mask.data()[k]) continue;
        taken += std::isnan(heights[k]) ? 0u : 1u;
        heights[k] = std::numeric_limits<T>::quiet_NaN();
    }
    return taken;
}

/// Removes spikes of \p surface and fills its holes.
template <Real T, class Heights>
void repair(Heights& surface, const Cleaning<T>& cleaning, CleaningReport& report) {
    if (cleaning.spikes != T(0)) {
        require(cleaning.spikes >= T(min_spike_limit) && cleaning.spikes <= T(max_spike_limit), "spikes",
                cleaning.spikes, "between 3 and 1000 standard deviations");
        report.spikes = find_spikes(surface, cleaning.spikes).removed;
    }
    if (cleaning.fill) {
        const auto filled = fill_missing(surface);
        report.filled = filled.missing, report.largest_hole = filled.longest;
    }
}

/// Root of twice the mean square slope between neighbours.
template <Real T>
[[nodiscard]] T rms_gradient_of(const Profile<T>& profile) {
    T sum = 0, pairs = 0;
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const T slope = (profile.heights[i] - profile.heights[i - 1]) / profile.spacing;
        if (std::isnan(slope)) continue;
        sum += slope * slope;
        pairs += 1;
    }
    return std::sqrt(2 * sum / (std::max)(pairs, T(1)));
}

template <class Robust>
[[nodiscard]] RobustOutcome outcome_of(const Robust& robust, std::size_t points) {
    return {robust.left_out, points, robust.iterations, robust.converged};
}

/// Removes the waves above lambda_c from \p prepared, which keeps the profile before it for the structure function.
template <Real T>
void remove_long_waves(PreparedProfile<T>& prepared) {
    const T lambda_c = *prepared.cut_offs.lambda_c;
    auto& levelled = static_cast<LevelledProfile<T>&>(prepared);
    if (prepared.cut_offs.filter == CutOffFilter::gaussian) {
        levelled = without_waviness(std::move(levelled), lambda_c);
        return;
    }
    const math::RobustWaviness<Profile<T>> robust = robust_waviness(levelled.profile, lambda_c);
    prepared.cut_offs.robust = outcome_of(robust, levelled.profile.present());
    if (!levelled.unfiltered) levelled.unfiltered = levelled.profile;
    for (std::size_t i = 0; i < levelled.profile.size(); ++i) levelled.profile.heights[i] -= robust.waviness.heights[i];
    levelled.lambda_c = lambda_c;
}

/// Removes the waves beyond the cut-offs from the map of \p prepared, which keeps the map before them.
template <Real T>
void remove_waves(PreparedMap<T>& prepared) {
    CutOffs<T>& cut_offs = prepared.cut_offs;
    if (!prepared.unfiltered) prepared.unfiltered = std::make_shared<const HeightMap<T>>(std::move(prepared.map));
    const HeightMap<T>& before = *prepared.unfiltered;
    if (cut_offs.lambda_s)
        prepared.map = gaussian_low_pass(before, *cut_offs.lambda_s);
    else
        prepared.map = before;
    if (!cut_offs.lambda_c) return;
    if (cut_offs.filter == CutOffFilter::robust) {
        const math::RobustWaviness<HeightMap<T>> robust = robust_waviness(prepared.map, *cut_offs.lambda_c);
        prepared.map.heights -= robust.waviness.heights;
        cut_offs.robust = outcome_of(robust, static_cast<std::size_t>(prepared.map.present()));
    } else {
        prepared.map = gaussian_high_pass(prepared.map, *cut_offs.lambda_c);
    }
    prepared.lambda_c = *cut_offs.lambda_c;
}

/// \p map without its form.
template <Real T>
[[nodiscard]] PreparedMap<T> levelled_map(const HeightMap<T>& map, const MeasureOptions<T>& options) {
    PreparedMap<T> prepared;
    static_cast<LevelledMap<T>&>(prepared) = level(map, options.map_form, options.height_step, options.form_radius);
    prepared.rms_as_read = rms_height(map);
    prepared.rms_levelled = rms_height(prepared.map);
    return prepared;
}

/// Same as above with the cut-offs of \p options, which are checked before any computation.
template <Real T>
[[nodiscard]] PreparedMap<T> levelled_for_cut_offs(const HeightMap<T>& map, const MeasureOptions<T>& options) {
    CutOffs<T> cut_offs = choose_cut_offs(map, options);
    PreparedMap<T> prepared = levelled_map(map, options);
    prepared.cut_offs = std::move(cut_offs);
    return prepared;
}

/// Removes the waves beyond the cut-offs of \p prepared, and computes its statistics.
template <Real T>
void finish(PreparedMap<T>& prepared) {
    if (prepared.cut_offs.any()) remove_waves(prepared);
    prepared.areal = areal_statistics(prepared.map);
    prepared.rms = prepared.areal.rms_height;
}

template <Real T>
CleaningReport clean(Profile<T>& profile, const Cleaning<T>& cleaning) {
    if (cleaning.align != LineAlignment::none)
        refuse("align", name_of(cleaning.align), "none for a profile, which is one line");
    CleaningReport report{.columns_read = profile.size(), .rows_read = 1};
    if (cleaning.crop) {
        const PointRange x = cropped("x", cleaning.crop->x_from, cleaning.crop->x_to, profile.size(), profile.spacing);
        const auto begin = profile.heights.begin() + static_cast<std::ptrdiff_t>(x.from);
        profile.heights = std::vector<T>(begin, begin + static_cast<std::ptrdiff_t>(x.count));
    }
    report.columns = profile.size(), report.rows = 1;
    if (cleaning.mask.size() > 0) {
        require(static_cast<std::size_t>(cleaning.mask.size()) == profile.size() &&
                    (cleaning.mask.rows() == 1 || cleaning.mask.cols() == 1),
                "marks of the mask", cleaning.mask.size(), "in one row, as many as the points of the cropped profile");
        report.masked = apply_mask(profile.heights.data(), cleaning.mask);
    }
    detail::repair(profile, cleaning, report);
    return report;
}

template <Real T>
CleaningReport clean(HeightMap<T>& map, const Cleaning<T>& cleaning) {
    const auto size = [](Eigen::Index n) { return static_cast<std::size_t>(n); };
    const auto index = [](std::size_t n) { return static_cast<Eigen::Index>(n); };
    CleaningReport report{.columns_read = size(map.columns()), .rows_read = size(map.rows())};
    if (cleaning.crop) {
        const PointRange x = cropped("x", cleaning.crop->x_from, cleaning.crop->x_to, report.columns_read, map.dx);
        const PointRange y = cropped("y", cleaning.crop->y_from, cleaning.crop->y_to, report.rows_read, map.dy);
        const typename HeightMap<T>::Array part =
            map.heights.block(index(y.from), index(x.from), index(y.count), index(x.count));
        map.heights = part;
    }
    report.columns = size(map.columns()), report.rows = size(map.rows());
    if (cleaning.mask.size() > 0) {
        require(cleaning.mask.rows() == map.rows() && cleaning.mask.cols() == map.columns(), "marks of the mask",
                cleaning.mask.size(), "in rows and columns as those of the cropped map");
        report.masked = apply_mask(map.heights.data(), cleaning.mask);
    }
    if (cleaning.align != LineAlignment::none) {
        const auto [axis, step] = align_lines(map, cleaning.align, cleaning.scan_axis);
        report.scan_axis = axis, report.line_step = static_cast<double>(step);
        report.aligned = axis == ScanAxis::x ? report.rows : report.columns;
    }
    detail::repair(map, cleaning, report);
    return report;
}

}}}  // namespace fstiff::detail

namespace fstiff { inline namespace v0_1 {

template <Real T>
PreparedProfile<T> prepare(const Profile<T>& profile, const MeasureOptions<T>& options) {
    if (options.form_cut_off && options.lambda_c.length())
        detail::refuse("lambda_c", *options.lambda_c.length(), "left out where the form has a cut-off");
    PreparedProfile<T> prepared;
    CutOffs<T>& cut_offs = prepared.cut_offs = detail::choose_cut_offs(profile, options);
    prepared.rms_as_read = rms_height(profile);
    static_cast<LevelledProfile<T>&>(prepared) = detail::level(
        profile, options.form, options.form_cut_off, options.height_step, cut_offs.lambda_s, options.form_radius);
    prepared.rms_levelled = rms_height(prepared.profile);
    if (!options.form_cut_off && cut_offs.lambda_c) detail::remove_long_waves(prepared);
    prepared.rms = rms_height(prepared.profile);
    prepared.rms_gradient = detail::rms_gradient_of(prepared.profile);
    return prepared;
}

template <Real T>
PreparedProfile<T> with_drawing_cut_off(PreparedProfile<T> prepared, const CutOff<T>& lambda_c) {
    CutOffs<T>& cut_offs = prepared.cut_offs;
    if (cut_offs.why_c != CutOffReason::form_alone) return prepared;
    detail::RoughnessCutOff<T> choice{lambda_c.length(), 0, CutOffReason::given};
    if (lambda_c.automatic()) choice = detail::roughness_cut_off(prepared.profile, cut_offs.lambda_s.value_or(T(0)));
    cut_offs.lambda_c = choice.lambda_c, cut_offs.why_c = choice.reason;
    cut_offs.mean_deviation = choice.mean_deviation, cut_offs.spacing = choice.spacing;
    if (cut_offs.lambda_c) detail::remove_long_waves(prepared);
    prepared.rms = rms_height(prepared.profile);
    prepared.rms_gradient = detail::rms_gradient_of(prepared.profile);
    return prepared;
}

template <Real T>
PreparedMap<T> prepare(const HeightMap<T>& map, const MeasureOptions<T>& options) {
    PreparedMap<T> prepared = detail::levelled_for_cut_offs(map, options);
    detail::finish(prepared);
    return prepared;
}

template <Real T>
PreparedMap<T> prepare(HeightMap<T>&& map, const MeasureOptions<T>& options) {
    PreparedMap<T> prepared = detail::levelled_for_cut_offs(std::as_const(map), options);
    map.heights.resize(0, 0);
    detail::finish(prepared);
    return prepared;
}

}}  // namespace fstiff

namespace fstiff { inline namespace v0_1 { namespace detail {

template <Real T>
PreparedMap<T> without_form(const HeightMap<T>& map, const MeasureOptions<T>& options) {
    PreparedMap<T> prepared = levelled_map(map, options);
    prepared.unfiltered = std::make_shared<const HeightMap<T>>(std::move(prepared.map));
    return prepared;
}

template <Real T>
PreparedMap<T> without_form(HeightMap<T>&& map, const MeasureOptions<T>& options) {
    PreparedMap<T> prepared = without_form(std::as_const(map), options);
    map.heights.resize(0, 0);
    return prepared;
}

template <Real T>
PreparedMap<T> with_cut_offs(PreparedMap<T> prepared, const MeasureOptions<T>& options) {
    prepared.cut_offs = choose_cut_offs(*prepared.unfiltered, options);
    if (!prepared.cut_offs.any()) {
        prepared.map = *prepared.unfiltered;
        prepared.unfiltered.reset();
    }
    finish(prepared);
    return prepared;
}

}}}  // namespace fstiff::detail
