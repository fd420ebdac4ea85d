// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Autocorrelation function of a map, and its texture parameters Sal and Str.
///
///     A(tx, ty) = <z(x, y) z(x + tx, y + ty)>/<z^2>     z about the mean of the map, straight within each cell of lags
///     r(phi)    = distance from lag 0, in the direction phi, at which A first falls to s = 0.2
///     Sal = min r     Str = min r/max r                 over 720 directions of half a turn; the other half is equal
///
/// Means are over the pairs that exist, for a periodic map also across its edges. Lags reach to half of each side; Str
/// is not available where A stays above s up to there.
///
/// Reference   ISO 25178-2:2021 (fACF, Sal, Str), ISO 25178-3:2012 (s = 0.2)
/// Units       lags, Sal [m], A and Str dimensionless
/// Valid       maps of at least 4 x 4 points; periodic ones without missing points; remove the form first
/// Accuracy    A 1e-13 of A(0) = 1, r 1e-12 of the lag (tests/topography/areal_autocorrelation_test.cpp)

#include <fstiff/core/names.hpp>
#include <fstiff/math/fft.hpp>
#include <fstiff/topography/height_map.hpp>

#include <numbers>

namespace fstiff { inline namespace v0_1 {

namespace detail {

/// Pairs of points of a lag.
enum class LagPairs {
    measured,  ///< those within the map
    periodic   ///< those across its edges too
};

}  // namespace detail

template <>
inline constexpr auto enum_names<detail::LagPairs> = detail::name_list<detail::LagPairs>(
    {{detail::LagPairs::measured, "measured"}, {detail::LagPairs::periodic, "periodic"}});

namespace detail {

/// Autocorrelation of a map at every lag up to a reach.
template <Real T = double>
struct ArealAutocorrelation {
    /// A at ty = j dy, j = 0 ... reach_y, in row j, and at tx = (i - reach_x) dx in column i; A(-tx, -ty) = A(tx, ty).
    /// NaN at a lag without a pair.
    typename HeightMap<T>::Array value;
    Eigen::Index reach_x{}, reach_y{};  ///< longest lags, in steps
    T dx{}, dy{};                       ///< [m]

    /// A at the lag of \p i steps along x and \p j along y, of either sign.
    [[nodiscard]] T at(Eigen::Index i, Eigen::Index j) const {
        return j < 0 ? value(-j, reach_x - i) : value(j, reach_x + i);
    }
};

/// Texture parameters: lags at which the autocorrelation falls to the threshold.
template <Real T = double>
struct TextureParameters {
    std::optional<T> shortest;      ///< Sal [m]; none where A stays above the threshold in every direction
    std::optional<T> aspect_ratio;  ///< Str; none where it does in one
    T shortest_direction{};         ///< of Sal, from x towards y [rad]
    T longest{};                    ///< max r, or where a direction without an end leaves the lags [m]
    T longest_direction{};          ///< [rad]
};

/// Mean of the autocorrelation over all directions.
template <Real T = double>
struct RadialAutocorrelation {
    std::vector<T> lag;             ///< mean length of the lags of a shell [m]; 0 first
    std::vector<T> value;           ///< mean of A over them
    std::vector<std::size_t> lags;  ///< with a pair, in the shell
};

/// Means over shells as wide as the longer step, about whole multiples of it, up to the shorter reach.
template <Real T>
[[nodiscard]] RadialAutocorrelation<T> radial_autocorrelation(const ArealAutocorrelation<T>& correlation) {
    using Index = Eigen::Index;
    const T width = (std::max)(correlation.dx, correlation.dy);
    const T end = (std::min)(static_cast<T>(correlation.reach_x) * correlation.dx,
                             static_cast<T>(correlation.reach_y) * correlation.dy);
    const auto shells = static_cast<std::size_t>(std::lround(end / width)) + 1;
    std::vector<T> lengths(shells), sums(shells);
    std::vector<std::size_t> counts(shells);
    for (Index j = 0; j <= correlation.reach_y; ++j)
        for (Index i = -correlation.reach_x; i <= correlation.reach_x; ++i) {
            const T length = std::hypot(static_cast<T>(i) * correlation.dx, static_cast<T>(j) * correlation.dy);
            const T value = correlation.at(i, j);
            if ((j == 0 && i < 0) || std::isnan(value) || length > end * (1 + 4 * std::numeric_limits<T>::epsilon()))
                continue;  // the lag of i < 0 along x is that of -i
            const auto shell = static_cast<std::size_t>(std::lround(length / width));
            lengths[shell] += length;
            sums[shell] += value;
            ++counts[shell];
        }
    RadialAutocorrelation<T> result;
    for (std::size_t k = 0; k < shells; ++k) {
        if (counts[k] == 0) continue;
        result.lag.push_back(lengths[k] / static_cast<T>(counts[k]));
        result.value.push_back(sums[k] / static_cast<T>(counts[k]));
        result.lags.push_back(counts[k]);
    }
    return result;
}

/// Sum over the points of u(x) u(x + t) for |i| <= \p reach_x and 0 <= j < \p lags, with \p u(row, column) padded with
/// zeros to \p width x \p height.
template <Real T, class Values>
void correlate_map(const Values& u, Eigen::Index rows, Eigen::Index columns, std::size_t height, std::size_t width,
                   Eigen::Index reach_x, Eigen::Index lags, typename HeightMap<T>::Array& into) {
    using Complex = std::complex<T>;
    using Index = Eigen::Index;
    const auto half = static_cast<Index>(width / 2);
    math::RealFft<T> along_x(width);
    math::ComplexFft<T> along_y(height);
    Eigen::Array<Complex, Eigen::Dynamic, 1> waves(rows * (half + 1));  // one column of the map after the other
    std::vector<T> line(static_cast<std::size_t>(columns));
    std::vector<Complex> in, out;
    for (Index j = 0; j < rows; ++j) {
        for (Index i = 0; i < columns; ++i) line[static_cast<std::size_t>(i)] = u(j, i);
        along_x.forward(line, out);
        for (Index i = 0; i <= half; ++i) waves[i * rows + j] = out[static_cast<std::size_t>(i)];
    }
    for (Index i = 0; i <= half; ++i) {
        in.assign(height, Complex(0));
        std::copy_n(waves.data() + i * rows, rows, in.begin());
        along_y.forward(in, out);
        for (Complex& wave : out) wave = std::norm(wave) / static_cast<T>(height);
        along_y.backward(out, in);
        std::copy_n(in.begin(), lags, waves.data() + i * lags);  // never beyond what was read
    }
    waves.conservativeResize(lags * (half + 1));  // gives the rest back before the result is made
    into.resize(lags, 2 * reach_x + 1);
    in.resize(static_cast<std::size_t>(half) + 1);
    for (Index j = 0; j < lags; ++j) {
        for (Index i = 0; i <= half; ++i) in[static_cast<std::size_t>(i)] = waves[i * lags + j];
        along_x.inverse(in, line);
        for (Index i = -reach_x; i <= reach_x; ++i)
            into(j, i + reach_x) = line[i < 0 ? width - static_cast<std::size_t>(-i) : static_cast<std::size_t>(i)];
    }
}

/// A along straight lines from lag 0, bilinear within each cell of lags: a parabola between the lines of the grid.
template <Real T>
class LagRays {
public:
    explicit LagRays(const ArealAutocorrelation<T>& correlation, T threshold)
        : a_(correlation), threshold_(threshold) {}

    struct Ray {
        T length{};  ///< to the threshold, or to where the ray leaves the lags or meets one without a pair
        bool ends{};
    };
    [[nodiscard]] Ray in_direction(T phi) const {
        const T across = std::cos(phi) / a_.dx, up = std::sin(phi) / a_.dy;  // steps per length
        const auto end_of = [](T speed, Eigen::Index reach) {
            return std::abs(speed) > 0 ? static_cast<T>(reach) / std::abs(speed) : std::numeric_limits<T>::infinity();
        };
        const T end = (std::min)(end_of(across, a_.reach_x), end_of(up, a_.reach_y));
        Eigen::Index next_x = 1, next_y = 1;
        T from = 0, before = value(0, 0);
        while (from < end) {
            const T to_x = end_of(across, next_x), to_y = end_of(up, next_y), to = (std::min)({to_x, to_y, end});
            if (to_x <= to) ++next_x;
            if (to_y <= to) ++next_y;
            const T middle = (from + to) / 2;
            const T half = value(across * middle, up * middle), after = value(across * to, up * to);
            if (std::isnan(half + after)) return {from, false};
            if (const T part = first_fall(before, half, after); part <= 1) return {from + part * (to - from), true};
            from = to;
            before = after;
        }
        return {end, false};
    }

private:
    /// A between the grid points, at \p u steps along x and \p v along y; v >= 0.
    [[nodiscard]] T value(T u, T v) const {
        const auto i = std::clamp<Eigen::Index>(static_cast<Eigen::Index>(std::floor(u)), -a_.reach_x, a_.reach_x - 1);
        const auto j = std::clamp<Eigen::Index>(static_cast<Eigen::Index>(std::floor(v)), 0, a_.reach_y - 1);
        const T x = u - static_cast<T>(i), y = v - static_cast<T>(j);
        return (a_.at(i, j) * (1 - x) + a_.at(i + 1, j) * x) * (1 - y) +
               (a_.at(i, j + 1) * (1 - x) + a_.at(i + 1, j + 1) * x) * y;
    }
    /// Position in [0, 1] at which the parabola through \p begin, \p middle and \p end first falls to the threshold;
    /// above 1: none.
    [[nodiscard]] T first_fall(T begin, T middle, T end) const {
        const T a = 2 * (begin - 2 * middle + end), b = 4 * middle - 3 * begin - end, c = begin - threshold_;
        if (end <= threshold_ && a == T(0)) return c / (begin - end);
        const T discriminant = b * b - 4 * a * c;
        if (!(discriminant >= 0)) return 2;
        const T divisor = std::sqrt(discriminant) - b;
        const T root = divisor > 0 ? 2 * c / divisor : T(2);
        return end <= threshold_ ? (std::min)(root, T(1)) : root;
    }

    const ArealAutocorrelation<T>& a_;
    T threshold_;
};

/// Autocorrelation of \p map. \throws domain_error for a map out of range, and for a periodic one with missing points.
template <Real T>
[[nodiscard]] ArealAutocorrelation<T> areal_autocorrelation(const HeightMap<T>& map,
                                                            LagPairs pairs = LagPairs::measured) {
    using Index = Eigen::Index;
    map.validate(4);
    const bool periodic = pairs == LagPairs::periodic, complete = map.present() == map.size();
    if (periodic) map.require_whole("before it is taken for periodic");
    const Index rows = map.rows(), columns = map.columns();
    ArealAutocorrelation<T> result;
    result.reach_x = columns / 2, result.reach_y = rows / 2;
    result.dx = map.dx, result.dy = map.dy;
    const auto padded = [&](Index points, Index reach) {
        return periodic ? static_cast<std::size_t>(points)
                        : math::fast_fft_size(static_cast<std::size_t>(points + reach));
    };
    const std::size_t width = padded(columns, result.reach_x), height = padded(rows, result.reach_y);
    const MapHeights<T> heights(map);
    const auto correlate = [&](bool counts, typename HeightMap<T>::Array& into) {  // one type of u: half the code
        const auto u = [&](Index j, Index i) {
            if (std::isnan(map.heights(j, i))) return T(0);
            return counts ? T(1) : static_cast<T>(heights.in_units(map.heights(j, i)) - heights.mean);
        };
        correlate_map<T>(u, rows, columns, height, width, result.reach_x, result.reach_y + 1, into);
    };
    correlate(false, result.value);
    typename HeightMap<T>::Array counted;
    if (!complete) correlate(true, counted);
    const T variance = static_cast<T>(heights.variance);
    for (Index j = 0; j <= result.reach_y; ++j)
        for (Index i = 0; i <= 2 * result.reach_x; ++i) {
            const Index lag = std::abs(i - result.reach_x);
            const T count = periodic   ? static_cast<T>(map.size())
                            : complete ? static_cast<T>(rows - j) * static_cast<T>(columns - lag)
                                       : std::round(counted(j, i));
            T& value = result.value(j, i);
            value = count > 0 ? value / count / variance : std::numeric_limits<T>::quiet_NaN();
        }
    return result;
}

/// Sal and Str of \p correlation. \throws domain_error unless 0 < threshold < 1.
template <Real T>
[[nodiscard]] TextureParameters<T> texture_parameters(const ArealAutocorrelation<T>& correlation,
                                                      std::type_identity_t<T> threshold = T(0.2)) {
    require(threshold > 0 && threshold < 1, "threshold of an autocorrelation", threshold, "between 0 and 1");
    constexpr int directions = 720;
    const LagRays<T> rays(correlation, threshold);
    TextureParameters<T> result;
    bool all_end = true;
    for (int k = 0; k < directions; ++k) {
        const T phi = std::numbers::pi_v<T> * static_cast<T>(k) / directions;
        const auto ray = rays.in_direction(phi);
        if (ray.ends && (!result.shortest || ray.length < *result.shortest)) {
            result.shortest = ray.length;
            result.shortest_direction = phi;
        }
        // a direction without a crossing is longer than all that have one
        if (all_end == ray.ends ? ray.length > result.longest : all_end) {
            result.longest = ray.length;
            result.longest_direction = phi;
        }
        all_end = all_end && ray.ends;
    }
    if (result.shortest && all_end) result.aspect_ratio = *result.shortest / result.longest;
    return result;
}

}  // namespace detail

}}  // namespace fstiff
