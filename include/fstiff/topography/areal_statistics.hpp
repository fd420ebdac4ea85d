// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Statistics of a map by finite differences, and its parameters by ISO 25178-2: Sa, Sq, Ssk, Sku, Sp, Sv ... Sdr.
///
///     m0 = <z^2> = Sq^2   Sa = <|z|>   Ssk = <z^3>/Sq^3    Sku = <z^4>/Sq^4   Sp = max z   Sv = -min z   Sz = Sp + Sv
///     m2, m4: means along x and along y of the squares of (z_(i+1) - z_i)/dx and (z_(i+1) - 2 z_i + z_(i-1))/dx^2
///     alpha = m0 m4/m2^2    Sdq = sqrt(m2 along x + m2 along y)    Sdr = <area of a cell>/(dx dy) - 1
///     summit: higher than all its eight neighbours; its curvature -(d2z/dx2 + d2z/dy2)/2 by three points
///
/// z is relative to the mean. Points at the border or next to a missing one are neither summits nor counted in the area
/// of the density; a plateau is no summit. The area of a cell is the mean of its two triangulations.
/// Reference   Longuet-Higgins (1957); Nayak (1971); ISO 25178-2:2021, D.3, eq. (D.15) for the area
/// Units       heights [m], m2 [1], m4 [1/m^2], density [1/m^2], curvature [1/m]; Ssk, Sku, Sdq, Sdr [1]
/// Valid       maps of at least 3 x 3 points with three neighbours along x and along y; remove the form first
/// Accuracy    1e-13 in double, and the rounding of an offset (tests/topography/areal_statistics_test.cpp,
///             tests/topography/areal_parameters_test.cpp)

#include <fstiff/topography/height_map.hpp>

#include <optional>

namespace fstiff { inline namespace v0_1 {

/// Moments of a map, and parameters that follow from them.
template <Real T = double>
struct ArealStatistics {
    T mean_height{};         ///< [m]
    T rms_height{};          ///< Sq = sigma [m]
    T m0{};                  ///< [m^2]
    T m2{}, m2_x{}, m2_y{};  ///< mean square slope: mean of both, along x, along y
    T m4{}, m4_x{}, m4_y{};  ///< mean square curvature [1/m^2]
    T nayak{};               ///< alpha
    T rms_gradient{};        ///< Sdq
    T summit_density{};      ///< [1/m^2]
    T summit_curvature{};    ///< mean of the summits [1/m]; 0 when there is none
    T summit_height{};       ///< mean of the summits, above the mean height [m]; 0 when there is none
    std::size_t summits{};
    std::size_t inner{};  ///< points whose eight neighbours exist
};

namespace detail {

/// Mean squares of the first and second differences of neighbours.
template <Real S>
struct DifferenceSums {
    S first{}, second{};
    std::size_t pairs{}, triples{};
};

/// Means of the squares along x (\p right 1) or y (\p down 1), in the unit of \p heights.
/// \throws domain_error without three neighbours.
template <Real T>
DifferenceSums<double> mean_differences(const HeightMap<T>& map, const MapHeights<T>& heights, Eigen::Index down,
                                        Eigen::Index right) {
    DifferenceSums<double> d;
    const auto height = [&](Eigen::Index j, Eigen::Index i) { return heights.in_units(map.heights(j, i)); };
    for (Eigen::Index j = 0; j + down < map.rows(); ++j) {
        double first = 0, second = 0;
        for (Eigen::Index i = 0; i + right < map.columns(); ++i) {
            const double a = height(j, i), b = height(j + down, i + right);
            if (std::isnan(a) || std::isnan(b)) continue;
            first += (b - a) * (b - a);
            ++d.pairs;
            if (j + 2 * down >= map.rows() || i + 2 * right >= map.columns()) continue;
            const double c = height(j + 2 * down, i + 2 * right);
            if (std::isnan(c)) continue;
            second += ((c - b) - (b - a)) * ((c - b) - (b - a));
            ++d.triples;
        }
        d.first += first;
        d.second += second;
    }
    if (d.triples == 0)
        throw domain_error(std::string("map has 0 triples of neighbouring points along ") + (right ? "x" : "y") +
                           ": must be at least 1");
    d.first /= static_cast<double>(d.pairs);
    d.second /= static_cast<double>(d.triples);
    return d;
}

/// Block of rows top to bottom - 1 and columns left to right - 1.
struct MapBlock {
    Eigen::Index top{}, bottom{}, left{}, right{};
};

/// Calls \p use(row, column, summit) for the points of the \p block whose eight neighbours exist.
template <Real T, class Use>
void visit_inner_points(const HeightMap<T>& map, const MapBlock& block, const Use& use) {
    const auto& z = map.heights;
    for (Eigen::Index j = std::max<Eigen::Index>(block.top, 1); j < (std::min)(block.bottom, map.rows() - 1); ++j)
        for (Eigen::Index i = std::max<Eigen::Index>(block.left, 1); i < (std::min)(block.right, map.columns() - 1);
             ++i) {
            const auto patch = z.template block<3, 3>(j - 1, i - 1);
            if (!patch.isNaN().any()) use(j, i, (patch >= z(j, i)).count() == 1);  // itself
        }
}

/// Statistics of \p map, about its mean. \throws domain_error for a map out of range.
template <Real T>
[[nodiscard]] ArealStatistics<T> areal_statistics(const HeightMap<T>& map) {
    using Index = Eigen::Index;
    map.validate();
    const Index rows = map.rows(), columns = map.columns();
    const auto& z = map.heights;
    ArealStatistics<T> result;

    const MapHeights<T> heights(map);
    const T unit = heights.unit;
    const double mean = heights.mean, variance = heights.variance;
    const auto height = [&](Index j, Index i) { return heights.in_units(z(j, i)); };

    const auto x = mean_differences(map, heights, 0, 1), y = mean_differences(map, heights, 1, 0);
    const double slope_x = unit / static_cast<double>(map.dx), slope_y = unit / static_cast<double>(map.dy);
    const double m2_x = x.first * slope_x * slope_x, m2_y = y.first * slope_y * slope_y;
    const double bend_x = slope_x / static_cast<double>(map.dx), bend_y = slope_y / static_cast<double>(map.dy);
    const double m4_x = x.second * bend_x * bend_x, m4_y = y.second * bend_y * bend_y;

    double curvature = 0, summit_height = 0;
    visit_inner_points(map, {0, rows, 0, columns}, [&](Index j, Index i, bool summit) {
        ++result.inner;
        if (!summit) return;
        ++result.summits;
        const double centre = height(j, i);
        curvature += ((centre - height(j, i - 1)) + (centre - height(j, i + 1))) * bend_x +
                     ((centre - height(j - 1, i)) + (centre - height(j + 1, i))) * bend_y;
        summit_height += centre - mean;
    });

    result.mean_height = static_cast<T>(heights.datum + mean * unit);
    result.rms_height = static_cast<T>(std::sqrt(variance) * unit);
    result.m0 = static_cast<T>(variance * unit * unit);
    result.m2_x = static_cast<T>(m2_x);
    result.m2_y = static_cast<T>(m2_y);
    result.m2 = static_cast<T>((m2_x + m2_y) / 2);
    result.m4_x = static_cast<T>(m4_x);
    result.m4_y = static_cast<T>(m4_y);
    result.m4 = static_cast<T>((m4_x + m4_y) / 2);
    result.rms_gradient = static_cast<T>(std::sqrt(m2_x + m2_y));
    // formed from rms values, so that no power exceeds the range of numbers
    const double root = std::sqrt(variance) * unit * std::sqrt((m4_x + m4_y) / 2) / ((m2_x + m2_y) / 2);
    result.nayak = static_cast<T>(root * root);
    for (const T value : {result.m0, result.m2, result.m4, result.nayak})
        require(value >= (std::numeric_limits<T>::min)() && value <= (std::numeric_limits<T>::max)(),
                "moment of the map", value,
                "of normal size: heights or spacings are too large or too small, or the map is a plane");
    if (result.inner > 0)
        result.summit_density = static_cast<T>(static_cast<double>(result.summits) / static_cast<double>(result.inner) /
                                               static_cast<double>(map.dx) / static_cast<double>(map.dy));
    if (result.summits > 0) {
        result.summit_curvature = static_cast<T>(curvature / 2 / static_cast<double>(result.summits));
        result.summit_height = static_cast<T>(summit_height / static_cast<double>(result.summits) * unit);
    }
    return result;
}

}  // namespace detail

/// Roughness parameters of a map by ISO 25178-2.
template <Real T = double>
struct ArealParameters {
    T mean_deviation{};                     ///< Sa [m]
    T rms_height{};                         ///< Sq [m]
    T skewness{};                           ///< Ssk
    T kurtosis{};                           ///< Sku
    T max_peak_height{};                    ///< Sp [m]
    T max_pit_depth{};                      ///< Sv [m]
    T max_height{};                         ///< Sz [m]
    T rms_gradient{};                       ///< Sdq
    std::optional<T> developed_area_ratio;  ///< Sdr; none where no cell has its four points
};

/// Roughness parameters of \p map. \throws domain_error for a map out of range.
template <Real T>
[[nodiscard]] ArealParameters<T> areal_parameters(const HeightMap<T>& map) {
    return areal_parameters(map, detail::areal_statistics(map));
}

namespace detail {

/// Mean area of the cells over dx dy, minus 1.
template <Real T>
[[nodiscard]] std::optional<T> developed_area_ratio(const HeightMap<T>& map) {
    const auto& z = map.heights;
    const double dx = static_cast<double>(map.dx), dy = static_cast<double>(map.dy);
    double total = 0;
    std::size_t cells = 0;
    for (Eigen::Index j = 0; j + 1 < map.rows(); ++j) {
        double row = 0;
        for (Eigen::Index i = 0; i + 1 < map.columns(); ++i) {
            const double a = static_cast<double>(z(j, i)), b = static_cast<double>(z(j, i + 1));
            const double c = static_cast<double>(z(j + 1, i)), d = static_cast<double>(z(j + 1, i + 1));
            if (std::isnan(a + b + c + d)) continue;
            const double top = (b - a) / dx, bottom = (d - c) / dx, left = (c - a) / dy, right = (d - b) / dy;
            const auto excess = [](double x, double y) {  // sqrt(1 + x^2 + y^2) - 1, to its last digit
                const double square = x * x + y * y;
                return square / (1 + std::sqrt(1 + square));
            };
            row += (excess(top, left) + excess(top, right) + excess(bottom, left) + excess(bottom, right)) / 4;
            ++cells;
        }
        total += row;
    }
    if (cells == 0) return {};
    return static_cast<T>(total / static_cast<double>(cells));
}

}  // namespace detail

/// Roughness parameters of \p map with the statistics \p known. \throws domain_error for a map out of range.
template <Real T>
[[nodiscard]] ArealParameters<T> areal_parameters(const HeightMap<T>& map, const ArealStatistics<T>& known) {
    map.validate();
    const detail::MapHeights<T> heights(map);
    const auto mean_of = [&](const auto& term) {
        return detail::mean_over_points(map, [&](T z) { return term(heights.in_units(z) - heights.mean); });
    };
    const double unit = static_cast<double>(heights.unit), variance = heights.variance;
    double high = -std::numeric_limits<double>::infinity(), low = -high;
    const double deviation = mean_of([&](double z) {
        high = (std::max)(high, z);
        low = (std::min)(low, z);
        return std::abs(z);
    });
    ArealParameters<T> result;
    result.mean_deviation = static_cast<T>(deviation * unit);
    result.rms_height = known.rms_height;
    result.skewness = static_cast<T>(mean_of([](double z) { return z * z * z; }) / (variance * std::sqrt(variance)));
    result.kurtosis = static_cast<T>(mean_of([](double z) { return z * z * z * z; }) / (variance * variance));
    result.max_peak_height = static_cast<T>(high * unit);
    result.max_pit_depth = static_cast<T>(-low * unit);
    result.max_height = static_cast<T>((high - low) * unit);
    result.rms_gradient = known.rms_gradient;
    result.developed_area_ratio = detail::developed_area_ratio(map);
    return result;
}

}}  // namespace fstiff
