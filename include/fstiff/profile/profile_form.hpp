// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Removal of the form of a profile: its mean, least-squares line, parabola or circle (math/round_fit.hpp).
///
/// The polynomials are orthogonal over the points that exist. The residual includes the rounding error of each product
/// and sum, and the fit is repeated on the residual: a large offset or tilt costs no digits beyond those that it costs
/// in the data.
///
/// Units       heights [m]
/// Valid       at least as many points as coefficients, every height finite or NaN (missing; stays missing)
/// Accuracy    offset or tilt of 1e6 times the roughness: heights within 4e-16 of the largest height before removal
///             (tests/profile/detrend_test.cpp)

#include <fstiff/profile/profile.hpp>

#include <vector>

namespace fstiff { inline namespace v0_1 {

/// Form that is removed from a profile.
enum class Form { none, mean, line, parabola, circle };
template <>
inline constexpr auto enum_names<Form> = detail::name_list<Form>({{Form::none, "none"},
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

}}  // namespace fstiff
