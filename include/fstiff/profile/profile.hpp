// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A measured profile: heights at equal spacing, some of which may be missing.
///
/// Units       heights and spacing [m]
/// Valid       spacing > 0; every height finite, or NaN where the point is missing

#include <fstiff/core/error.hpp>
#include <fstiff/core/names.hpp>
#include <fstiff/math/round_fit.hpp>
#include <fstiff/math/rounding.hpp>
#include <fstiff/math/tukey.hpp>

#include <algorithm>
#include <vector>

namespace fstiff::inline v0_1 {

/// A profile in SI units. Its mean and rms are over the points that exist.
template <Real T = double>
struct Profile {
    std::vector<T> heights;  ///< z(i spacing) [m]; NaN marks a missing point
    T spacing{};             ///< between neighbours [m]

    /// Number of points, including missing ones.
    [[nodiscard]] std::size_t size() const { return heights.size(); }

    /// Number of points that are not missing.
    [[nodiscard]] std::size_t present() const {
        return static_cast<std::size_t>(
            std::count_if(heights.begin(), heights.end(), [](T z) { return !std::isnan(z); }));
    }

    /// Length from the first point to the last [m]; 0 for an empty profile.
    [[nodiscard]] T length() const { return heights.empty() ? T(0) : static_cast<T>(heights.size() - 1) * spacing; }

    /// \throws domain_error unless the spacing is positive, no height infinite, at least \p least points exist and they
    /// are not all of one height.
    void validate(std::size_t least = 16) const {
        detail::require_positive("spacing", spacing);
        bool varies = false;
        std::size_t count = 0;
        T first{};
        for (const T z : heights) {
            if (std::isnan(z)) continue;
            detail::require(std::abs(z) <= (std::numeric_limits<T>::max)(), "height", z,
                            "finite, or NaN for a missing point");
            if (count++ == 0) first = z;
            varies = varies || z != first;
        }
        if (count < least)
            throw domain_error("profile has " + std::to_string(count) + " points: must be at least " +
                               std::to_string(least));
        detail::require(varies, "profile of constant height", first, "of varying height");
    }
};

namespace detail {

/// Mean of the heights that exist [m]. \throws domain_error when there is none.
template <Real T>
[[nodiscard]] T mean_height(const Profile<T>& profile) {
    math::CompensatedSum<double> sum;
    std::size_t count = 0;
    for (const T z : profile.heights)
        if (!std::isnan(z)) {
            sum.add(z);
            ++count;
        }
    if (count == 0) throw domain_error("profile has 0 points: must be at least 1");
    return static_cast<T>(sum.value() / static_cast<double>(count));
}

}  // namespace detail

/// Rq: root of the mean square of the heights about their mean [m]. \throws domain_error when no point exists.
template <Real T>
[[nodiscard]] T rms_height(const Profile<T>& profile) {
    const T mean = detail::mean_height(profile);
    T largest = 0;  // scaled by, so that no square leaves the range of numbers
    for (const T z : profile.heights)
        if (!std::isnan(z)) largest = (std::max)(largest, std::abs(z - mean));
    if (largest == T(0)) return T(0);
    math::CompensatedSum<double> squares, firsts;
    std::size_t count = 0;
    for (const T z : profile.heights)
        if (!std::isnan(z)) {
            const double scaled = (z - mean) / largest;
            squares.add(scaled * scaled);
            firsts.add(scaled);
            ++count;
        }
    const auto n = static_cast<double>(count);
    const auto offset = firsts.value() / n;  // residual of the rounding of the mean
    return largest * static_cast<T>(std::sqrt(squares.value() / n - offset * offset));
}

}  // namespace fstiff::inline v0_1

// Repair of a profile: spikes become missing points, and missing points are filled.
//
//     d_i = z_i - median(z_i-2, z_i-1, z_i+1, z_i+2);  q_n: z_i beyond both of z_i-n and z_i+n
//     spike: |d_i - median d| > k 1.4826 MAD(d); q_2 or q_3, and q = median(q_4 to q_6), > |d|/2; q_2 > k/6 (q - q_2)
//     fill: the straight line between the nearest points that exist; at the ends the nearest height
//
// d has the scale of the roughness and not of the form. A wall goes on at one side, a bump or a cusp falls farther.
//
// Reference   Hampel, J. Am. Stat. Assoc. 69 (1974) 383 (median and MAD)
// Units       heights [m]; k in standard deviations
// Valid       k > 0; at least 5 points for spikes, one existing point for filling
// Accuracy    rounding. k = 5 removes less than 1e-4 of Gaussian and of self-affine roughness
//             (tests/profile/repair_test.cpp)

namespace fstiff::inline v0_1::detail {

/// Number of spikes of \p profile beyond \p limit; with \p remove they become missing. \throws domain_error as above.
template <Real T>
math::Repair find_spikes(Profile<T>& profile, std::type_identity_t<T> limit, bool remove = true) {
    require_positive("spikes", limit);
    const std::size_t size = profile.size();
    require(size >= 5, "points of a profile with spikes", size, "at least 5");
    std::vector<T> differences(size, std::numeric_limits<T>::quiet_NaN()), neighbours;
    for (std::size_t i = 0; i < size; ++i) {
        if (std::isnan(profile.heights[i])) continue;
        neighbours.clear();
        for (std::size_t k = i < 2 ? 0 : i - 2; k < (std::min)(size, i + 3); ++k)
            if (k != i && !std::isnan(profile.heights[k])) neighbours.push_back(profile.heights[k]);
        if (neighbours.size() >= 2) differences[i] = profile.heights[i] - math::median(neighbours);
    }
    return math::spikes_among(profile.heights.data(), differences, limit, remove, [&](std::size_t i, T difference) {
        const auto height = [&](std::size_t k) {
            return k < size ? profile.heights[k] : std::numeric_limits<T>::quiet_NaN();
        };
        const auto beyond = [&](std::size_t n) {  // i - n of the first points is beyond the last
            return math::beyond_both(profile.heights[i], height(i - n), height(i + n), std::copysign(T(1), difference));
        };
        const auto exist = [](std::vector<T> heights) {
            std::erase_if(heights, [](T q) { return std::isnan(q); });
            return heights;
        };
        std::vector<T> inner = exist({beyond(2), beyond(3)}), outer = exist({beyond(4), beyond(5), beyond(6)});
        if (inner.empty() || outer.empty()) return true;
        const T most = *std::max_element(inner.begin(), inner.end());
        return most > std::abs(difference) / 2 &&
               math::has_no_foot(inner.front(), math::median(outer), difference, limit);
    });
}

/// Fills the missing points of \p profile. \throws domain_error where every point is missing.
template <Real T>
math::Repair fill_missing(Profile<T>& profile) {
    math::Repair repair;
    const std::size_t size = profile.size();
    std::size_t from = 0;  // of the run of missing points
    for (std::size_t i = 0; i <= size; ++i) {
        if (i < size && std::isnan(profile.heights[i])) continue;
        const std::size_t count = i - from;
        if (count > 0) {
            require(from > 0 || i < size, "points that exist", 0, "at least 1 to fill the others");
            const T before = profile.heights[from > 0 ? from - 1 : i], after = profile.heights[i < size ? i : from - 1];
            for (std::size_t k = from; k < i; ++k) {
                const T share = static_cast<T>(k - from + 1) / static_cast<T>(count + 1);
                profile.heights[k] = (1 - share) * before + share * after;
            }
            repair.missing += count;
            repair.longest = (std::max)(repair.longest, count);
        }
        from = i + 1;
    }
    return repair;
}

}  // namespace fstiff::inline v0_1::detail

// Removal of the form of a profile: its mean, least-squares line, parabola or circle (math/round_fit.hpp).
//
// The polynomials are orthogonal over the points that exist. The residual includes the rounding error of each product
// and sum, and the fit is repeated on the residual: a large offset or tilt costs no digits beyond those that it costs
// in the data.
//
// Units       heights [m]
// Valid       at least as many points as coefficients, every height finite or NaN (missing; stays missing)
// Accuracy    offset or tilt of 1e6 times the roughness: heights within 4e-16 of the largest height before removal
//             (tests/profile/detrend_test.cpp)

namespace fstiff::inline v0_1 {

/// Form that is removed from a profile.
enum class Form { none, mean, line, parabola, circle };
template <>
inline constexpr auto names<Form> = detail::name_list<Form>({{Form::none, "none"},
                                                             {Form::mean, "mean"},
                                                             {Form::line, "line"},
                                                             {Form::parabola, "parabola"},
                                                             {Form::circle, "circle"}});

namespace detail {

/// Number of coefficients of a form, those of a circle without the terms of its higher powers.
constexpr std::size_t coefficients(Form form) {
    return static_cast<std::size_t>(form == Form::circle ? Form::parabola : form);
}

/// First three polynomials that are orthogonal over the positions u at which points exist.
template <Real T>
struct OrthogonalPolynomials {
    T centre{}, slope_shift{}, mean_square{};

    std::array<T, 3> operator()(T u) const {
        const T p1 = u - centre;
        return {T(1), p1, (p1 - slope_shift) * p1 - mean_square};
    }
};

/// Computes value + carry -= \p a times \p b with rounding only in the carry.
template <Real T>
void subtract_product(T& value, T& carry, T a, T b) {
    const T product = a * b;
    const T product_error = std::fma(a, b, -product);
    const math::RoundedSum<T> next = math::two_sum(value, -product);
    carry += next.error - product_error;
    value = next.sum;
}

/// \p profile without the \p form.
/// \throws domain_error when it has fewer points than the form has coefficients, or an infinite height.
template <Real T>
[[nodiscard]] Profile<T> detrend(const Profile<T>& profile, Form form) {
    const std::size_t terms = coefficients(form);
    for (const T z : profile.heights)
        require(std::isnan(z) || std::abs(z) <= (std::numeric_limits<T>::max)(), "height", z,
                "finite, or NaN for a missing point");
    Profile<T> result = profile;
    if (terms == 0) return result;
    const std::size_t points = profile.present();
    if (points < terms)
        throw domain_error("profile has " + std::to_string(points) + " points: must be at least " +
                           std::to_string(terms) + " to remove this form");

    const auto count = static_cast<double>(points);
    const double last = static_cast<double>(profile.size() > 1 ? profile.size() - 1 : 1);
    const auto position = [&](std::size_t i) { return 2 * static_cast<double>(i) / last - 1; };  // in [-1, 1]
    const auto mean_over_points = [&](const auto& f) {
        math::CompensatedSum<double> sum;
        for (std::size_t i = 0; i < profile.size(); ++i)
            if (!std::isnan(profile.heights[i])) sum.add(f(i));
        return sum.value() / count;
    };
    OrthogonalPolynomials<double> p;
    p.centre = mean_over_points(position);
    p.mean_square =
        mean_over_points([&](std::size_t i) { return (position(i) - p.centre) * (position(i) - p.centre); });
    if (terms == 3)
        p.slope_shift = mean_over_points([&](std::size_t i) {
                            const double u = position(i) - p.centre;
                            return u * u * u;
                        }) /
                        p.mean_square;
    std::array<double, 3> norm{};
    for (std::size_t k = 0; k < terms; ++k)
        norm[k] = mean_over_points([&](std::size_t i) { return p(position(i))[k] * p(position(i))[k]; });

    std::vector<double> value(profile.heights.begin(), profile.heights.end()), carry(profile.size(), 0.0);
    for (int pass = 0; pass < 2; ++pass) {
        for (std::size_t k = 0; k < terms; ++k) {
            const double c =
                mean_over_points([&](std::size_t i) { return p(position(i))[k] * (value[i] + carry[i]); }) / norm[k];
            for (std::size_t i = 0; i < value.size(); ++i) subtract_product(value[i], carry[i], c, p(position(i))[k]);
        }
    }
    for (std::size_t i = 0; i < value.size(); ++i) result.heights[i] = static_cast<T>(value[i] + carry[i]);
    return result;
}

/// Removes the least-squares circle of \p profile, whose heights become distances from it. Returns its radius [m],
/// below 0 where it is hollow; a \p radius above 0 is kept. \throws domain_error as math::fit_round().
template <Real T>
T remove_circle(Profile<T>& profile, std::type_identity_t<T> radius) {
    profile.validate(4);
    const double unit = static_cast<double>(profile.length()) / 2, mean = mean_height(profile), step = profile.spacing;
    const auto place = [&](std::size_t i) { return static_cast<double>(i) * step / unit - 1; };
    const auto height = [&](std::size_t i) { return (static_cast<double>(profile.heights[i]) - mean) / unit; };
    const math::RoundSurface circle = math::fit_round(math::RoundSurface{math::RoundShape::circle},
                                                      static_cast<double>(radius) / unit, [&](const auto& use) {
                                                          for (std::size_t i = 0; i < profile.size(); ++i)
                                                              if (!std::isnan(profile.heights[i]))
                                                                  use(place(i), 0.0, height(i));
                                                      });
    for (std::size_t i = 0; i < profile.size(); ++i)  // NaN stays
        profile.heights[i] = static_cast<T>(circle.distance(place(i), 0, height(i)) * unit);
    return static_cast<T>(unit / circle.curvature());
}

}  // namespace detail

}  // namespace fstiff::inline v0_1
