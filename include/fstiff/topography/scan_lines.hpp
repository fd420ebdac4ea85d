// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Offsets between the scan lines of a map, as drift and creep of a scanning probe leave them, and their removal.
///
///     median                  z_j,i - median_i z_j,i
///     median_of_differences   z_j,i - sum_(k <= j) m_k,  m_j = median_i(z_j,i - z_j-1,i): for plateaus and pits
///     offsets are seen where  mean m_j^2 > mean s_j^2/4, s_j = 1.4826 median_i |z_j,i - z_j-1,i - m_j|, by four times
///                             the ratio across the lines, and m_j and m_j+1 correlate below -0.1: -1/2 for offsets,
///                             above 0 for a lay that is resolved; their rms is above 1e-6 of the rms height
///
/// Waves that all points of a line share are lost with the offsets, 1 to 2 % of the rms height of 256 isotropic lines.
///
/// Reference   Necas, Klapetek, Cent. Eur. J. Phys. 10 (2012) 181 (both methods); the limits are this project's
/// Units       heights [m]
/// Valid       maps of 3 points a side, missing points allowed; offsets are seen from 32 points a side
/// Accuracy    rounding; K to 2 % (tests/topography/scan_lines_test.cpp)

#include <fstiff/core/names.hpp>
#include <fstiff/math/tukey.hpp>
#include <fstiff/topography/height_map.hpp>

#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 {

/// How the offsets of scan lines are found.
enum class LineAlignment { none, median, median_of_differences };
template <>
inline constexpr auto enum_names<LineAlignment> =
    detail::name_list<LineAlignment>({{LineAlignment::none, "none"},
                                      {LineAlignment::median, "median"},
                                      {LineAlignment::median_of_differences, "median_of_differences"}});

/// The axis along which the lines of a map were scanned; automatic: that whose lines have offsets, else x.
enum class ScanAxis { automatic, x, y };
template <>
inline constexpr auto enum_names<ScanAxis> =
    detail::name_list<ScanAxis>({{ScanAxis::automatic, "auto"}, {ScanAxis::x, "x"}, {ScanAxis::y, "y"}});

namespace detail {

/// Steps between the neighbouring lines along one axis.
template <Real T>
struct LineSteps {
    T rms{};          ///< of m_j about their mean [m]
    T share{};        ///< mean m_j^2/mean s_j^2
    T correlation{};  ///< of neighbouring m_j
};

/// Medians of \p value(j, i) over i for \p lines j; NaN where no point exists.
template <Real T, class Value>
[[nodiscard]] std::vector<T> medians_of_lines(Eigen::Index lines, Eigen::Index points, const Value& value) {
    std::vector<T> medians, heights;
    for (Eigen::Index j = 0; j < lines; ++j) {
        heights.clear();
        for (Eigen::Index i = 0; i < points; ++i)
            if (const T z = value(j, i); !std::isnan(z)) heights.push_back(z);
        medians.push_back(heights.empty() ? std::numeric_limits<T>::quiet_NaN() : math::median(heights));
    }
    return medians;
}

/// Steps between the rows of \p heights, which may be a transposed map. The mean of m_j, a tilt, is taken out.
template <Real T, class Heights>
[[nodiscard]] LineSteps<T> line_steps(const Heights& heights) {
    const Eigen::Index steps = heights.rows() - 1, points = heights.cols();
    const auto step = [&](Eigen::Index j, Eigen::Index i) { return heights(j + 1, i) - heights(j, i); };
    std::vector<T> m = medians_of_lines<T>(steps, points, step);
    const std::vector<T> spread = medians_of_lines<T>(
        steps, points, [&](Eigen::Index j, Eigen::Index i) { return std::abs(step(j, i) - m[std::size_t(j)]); });
    T sum = 0, count = 0, noise = 0;
    for (std::size_t j = 0; j < m.size(); ++j)
        if (!std::isnan(m[j])) sum += m[j], count += 1, noise += spread[j] * spread[j];
    T squares = 0, products = 0;
    for (std::size_t j = 0; j < m.size(); ++j) {
        m[j] = std::isnan(m[j]) ? T(0) : m[j] - sum / count;
        squares += m[j] * m[j];
        if (j > 0) products += m[j] * m[j - 1];
    }
    constexpr T gaussian = math::tukey_factor<T> / 3;
    if (!(squares > T(0))) return {};
    return {std::sqrt(squares / count), squares / (gaussian * gaussian * noise), products / squares};
}

/// The lines of \p map whose offsets drift or creep may have left, by the limits above, and the rms step between them
/// [m]; ScanAxis::automatic where there are none, and for maps of less than 32 points a side.
template <Real T>
[[nodiscard]] std::pair<ScanAxis, T> line_offsets(const HeightMap<T>& map) {
    if ((std::min)(map.rows(), map.columns()) < 32) return {};
    const LineSteps<T> along_x = line_steps<T>(map.heights), along_y = line_steps<T>(map.heights.transpose());
    const T rounding = (std::max)(T(1e-6), 100 * std::numeric_limits<T>::epsilon()) * rms_height(map);
    const auto stand_out = [&](const LineSteps<T>& lines, const LineSteps<T>& across) {
        return lines.rms > rounding && lines.share > T(0.25) && lines.share > 4 * across.share &&
               lines.correlation < T(-0.1);
    };
    if (stand_out(along_x, along_y)) return {ScanAxis::x, along_x.rms};
    if (stand_out(along_y, along_x)) return {ScanAxis::y, along_y.rms};
    return {};
}

/// Removes the offsets of the lines of \p map along \p axis. Returns the axis, and the rms step between lines before
/// [m].
template <Real T>
std::pair<ScanAxis, T> align_lines(HeightMap<T>& map, LineAlignment method, ScanAxis axis) {
    const auto align = [&](auto&& heights) {
        const LineSteps<T> steps = line_steps<T>(heights);
        std::vector<Eigen::Index> before;  // the last line before j that has points
        for (Eigen::Index j = 0; j < heights.rows(); ++j)
            before.push_back(j == 0 || !heights.row(j - 1).isNaN().all() ? j - 1 : before.back());
        std::vector<T> offsets =
            medians_of_lines<T>(heights.rows(), heights.cols(), [&](Eigen::Index j, Eigen::Index i) {
                if (method == LineAlignment::median) return heights(j, i);
                const Eigen::Index last = before[static_cast<std::size_t>(j)];
                return last < 0 ? T(0) : heights(j, i) - heights(last, i);
            });
        for (T& offset : offsets) offset = std::isnan(offset) ? T(0) : offset;
        if (method == LineAlignment::median_of_differences)
            std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
        for (Eigen::Index j = 0; j < heights.rows(); ++j) heights.row(j) -= offsets[static_cast<std::size_t>(j)];
        return steps.rms;
    };
    if (axis == ScanAxis::automatic) axis = line_offsets(map).first;
    if (axis == ScanAxis::y) return {axis, align(map.heights.transpose())};
    return {ScanAxis::x, align(map.heights)};
}

}  // namespace detail

}}  // namespace fstiff
