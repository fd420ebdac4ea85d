// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Removal of the form of a map: its mean, a plane, quadratic or cubic surface, sphere or cylinder of least squares.
///
///     form = sum of c_kl P_k(u) P_l(v),  k + l <= degree,  u, v in [-1, 1] over the map, P_k Legendre's polynomials
///
/// The fit is over the points that exist and is repeated on its residual, so that an offset or a tilt far above the
/// roughness costs no digits. A form that the points do not determine is refused. Heights over a sphere or a cylinder
/// (math/round_fit.hpp) are distances from it.
///
/// Units       heights [m]
/// Valid       maps of at least 3 x 3 points, every height finite or NaN (missing; stays missing)
/// Accuracy    1e-15 of the largest height, offset and tilt of 1e6 times the roughness (tests/topography/form_test.cpp)

#include <fstiff/core/names.hpp>
#include <fstiff/math/decompositions.hpp>
#include <fstiff/math/round_fit.hpp>
#include <fstiff/math/rounding.hpp>
#include <fstiff/math/tukey.hpp>
#include <fstiff/math/upper_half.hpp>
#include <fstiff/topography/height_map.hpp>

#include <Eigen/SparseCholesky>
#include <array>
#include <memory>
#include <optional>

namespace fstiff { inline namespace v0_1 {

/// Surface that is removed; of a polynomial its degree.
enum class MapForm { none = -1, mean = 0, plane = 1, quadratic = 2, cubic = 3, sphere, cylinder };
template <>
inline constexpr auto enum_names<MapForm> = detail::name_list<MapForm>({{MapForm::none, "none"},
                                                                        {MapForm::mean, "mean"},
                                                                        {MapForm::plane, "plane"},
                                                                        {MapForm::quadratic, "quadratic"},
                                                                        {MapForm::cubic, "cubic"},
                                                                        {MapForm::sphere, "sphere"},
                                                                        {MapForm::cylinder, "cylinder"}});

/// A map without its form, with the data of the removed form.
template <Real T = double>
struct LevelledMap {
    HeightMap<T> map;
    MapForm removed = MapForm::none;
    T radius{};  ///< of a removed sphere or cylinder [m], below 0 where it is hollow
    /// Map before lambda_s and lambda_c, if any; maps filtered with several cut-offs may share it.
    std::shared_ptr<const HeightMap<T>> unfiltered{};
    T lambda_c{};             ///< of the filter of the long waves [m]; 0: none
    std::array<T, 2> tilt{};  ///< of the form along x and y, last point less first [m]; NaN: a corner is missing
    /// Of the polynomial through the upper half over that of least squares [m], where it took its place.
    std::optional<std::array<T, 2>> settled{};

    /// Map for the structure functions.
    [[nodiscard]] const HeightMap<T>& of_structure() const { return unfiltered ? *unfiltered : map; }
};

namespace detail {

constexpr bool is_round(MapForm form) { return form == MapForm::sphere || form == MapForm::cylinder; }

/// Degree of the polynomial of about as many terms as \p form.
constexpr int degree_of(MapForm form) { return static_cast<int>(is_round(form) ? MapForm::quadratic : form); }

/// Legendre's polynomials 0 to 3 at the points of a side, one a column.
template <Real S>
Eigen::Array<S, Eigen::Dynamic, 4> legendre_of_side(Eigen::Index points) {
    Eigen::Array<S, Eigen::Dynamic, 4> p(points, 4);
    for (Eigen::Index i = 0; i < points; ++i) {
        const S u = static_cast<S>(2 * i - (points - 1)) / static_cast<S>(points - 1);
        p.row(i) << S(1), u, (3 * u * u - 1) / 2, (5 * u * u - 3) * u / 2;
    }
    return p;
}

/// Calls \p use(t, k, l) for the terms f_t = P_k(u) P_l(v), k + l <= degree.
template <class Use>
void each_term(Eigen::Index degree, const Use& use) {
    Eigen::Index t = 0;
    for (Eigen::Index k = 0; k <= degree; ++k)
        for (Eigen::Index l = 0; k + l <= degree; ++l) use(t++, k, l);
}

/// 1 where a point of row \p j exists, 0 where it is missing: by rows, because a map may be as large as memory allows.
template <Real S, Real T>
Eigen::Array<S, 1, Eigen::Dynamic> existing(const HeightMap<T>& map, Eigen::Index j) {
    return map.heights.row(j).isNaN().select(Eigen::Array<S, 1, Eigen::Dynamic>::Zero(map.columns()), S(1));
}

/// Means of f_s f_t over the points that exist; row by row, because v is constant along a row.
template <Real T, class Polynomials>
auto normal_matrix(const HeightMap<T>& map, const Polynomials& px, const Polynomials& py, Eigen::Index degree) {
    using Index = Eigen::Index;
    const Index terms = (degree + 1) * (degree + 2) / 2;
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic> normal =
        Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>::Zero(terms, terms);
    for (Index j = 0; j < map.rows(); ++j) {
        Eigen::Matrix<double, 4, 4> products;  // of the polynomials along this row
        const auto exists = existing<double>(map, j);
        for (Index a = 0; a <= degree; ++a)
            for (Index b = 0; b <= a; ++b)
                products(a, b) = products(b, a) = (exists.transpose() * px.col(a) * px.col(b)).sum();
        each_term(degree, [&](Index s, Index k, Index l) {
            each_term(degree, [&](Index t, Index m, Index n) { normal(s, t) += products(k, m) * py(j, l) * py(j, n); });
        });
    }
    normal /= static_cast<double>(map.present());
    return normal;
}

/// \p map without the \p form. \throws domain_error for a map out of range, or whose points do not determine the form.
template <Real T>
[[nodiscard]] HeightMap<T> remove_form(const HeightMap<T>& map, MapForm form) {
    using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1>;
    using Index = Eigen::Index;
    map.validate();
    if (form == MapForm::none) return map;
    const Index degree = static_cast<Index>(form), terms = (degree + 1) * (degree + 2) / 2;
    const auto terms_shown = std::to_string(terms);
    if (map.present() < terms)
        throw domain_error("map of which " + std::to_string(map.present()) + " points exist: must be at least " +
                           terms_shown + " to remove this form");
    const auto px = legendre_of_side<double>(map.columns()), py = legendre_of_side<double>(map.rows());
    // so that no sum exceeds the range of numbers
    const double unit =
        math::power_of_two_below(static_cast<double>(map.heights.isNaN().select(T(0), map.heights).abs().maxCoeff()));
    const auto each_term = [&](const auto& use) { detail::each_term(degree, use); };
    using Array = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Array z = map.heights.isNaN().select(T(0), map.heights).template cast<double>() / unit;
    // for a map of 1e5 points a side with all points in two neighbouring rows: 1e-10
    const math::PivotedQr<double> solver(normal_matrix(map, px, py, degree), 1e-12);
    if (solver.rank() < terms)
        throw domain_error("map whose points determine " + std::to_string(solver.rank()) + " of the " + terms_shown +
                           " terms of this form: must be spread over more rows and columns");
    for (int pass = 0; pass < 3; ++pass) {
        Vector moments = Vector::Zero(terms);
        for (Index j = 0; j < map.rows(); ++j) {
            Eigen::Matrix<double, 4, 1> along = Eigen::Matrix<double, 4, 1>::Zero();
            for (Index k = 0; k <= degree; ++k) along[k] = (z.row(j).transpose() * px.col(k)).sum();
            each_term([&](Index t, Index k, Index l) { moments[t] += along[k] * py(j, l); });
        }
        const Vector c = solver.solve(moments / static_cast<double>(map.present()));
        for (Index j = 0; j < map.rows(); ++j) {
            Eigen::Matrix<double, 4, 1> along = Eigen::Matrix<double, 4, 1>::Zero();
            each_term([&](Index t, Index k, Index l) { along[k] += c[t] * py(j, l); });
            const auto exists = existing<double>(map, j);
            for (Index k = degree; k >= 0; --k) z.row(j) -= along[k] * (px.col(k).transpose() * exists);
        }
    }
    for (Index j = 0; j < map.rows(); ++j)
        for (Index i = 0; i < map.columns(); ++i)
            z(j, i) = std::isnan(map.heights(j, i)) ? static_cast<double>(map.heights(j, i)) : z(j, i) * unit;
    HeightMap<T> result;
    result.dx = map.dx;
    result.dy = map.dy;
    if constexpr (std::is_same_v<double, T>)
        result.heights = std::move(z);
    else
        result.heights = z.template cast<T>();
    return result;
}

/// Removes the least-squares sphere or cylinder of \p map, whose heights become distances from it. Returns its radius
/// [m], below 0 where it is hollow; a \p radius above 0 is kept. \throws domain_error as math::fit_round().
template <Real T>
T remove_round_form(HeightMap<T>& map, MapForm form, std::type_identity_t<T> radius) {
    map.validate();
    const double dx = map.dx, dy = map.dy, columns = static_cast<double>(map.columns() - 1),
                 rows = static_cast<double>(map.rows() - 1), unit = std::hypot(columns * dx, rows * dy) / 2;
    const double mean = static_cast<double>(map.heights.isNaN().select(T(0), map.heights).mean());
    const auto each = [&](const auto& use) {
        for (Eigen::Index j = 0; j < map.rows(); ++j)
            for (Eigen::Index i = 0; i < map.columns(); ++i)
                if (T& z = map.heights(j, i); !std::isnan(z))
                    use((static_cast<double>(i) - columns / 2) * dx / unit,
                        (static_cast<double>(j) - rows / 2) * dy / unit, (static_cast<double>(z) - mean) / unit, z);
    };
    const auto shape = form == MapForm::sphere ? math::RoundShape::sphere : math::RoundShape::cylinder;
    const math::RoundSurface round = math::fit_round(shape, static_cast<double>(radius) / unit, [&](const auto& use) {
        each([&](double x, double y, double z, T&) { use(x, y, z); });
    });
    each([&](double x, double y, double z, T& height) { height = static_cast<T>(round.distance(x, y, z) * unit); });
    return static_cast<T>(unit / round.curvature());
}

/// \p map levelled, with the removed form; a plane or a quadratic surface is that of the upper half where least squares
/// would follow valleys (math/upper_half.hpp). \p resolution [m] is the step in which the heights were printed or
/// counted; 0 where it is not known; a \p radius [m] above 0 is that of the sphere or cylinder. \throws domain_error as
/// remove_form(), remove_round_form(), and for a map that is constant, apart from rounding, after the removal of its
/// form.
template <Real T>
[[nodiscard]] LevelledMap<T> level(const HeightMap<T>& map, MapForm form, std::type_identity_t<T> resolution = 0,
                                   std::type_identity_t<T> radius = 0) {
    LevelledMap<T> flat{detail::is_round(form) ? map : remove_form(map, form), form};
    if (detail::is_round(form)) flat.radius = remove_round_form(flat.map, form, radius);
    if (form == MapForm::plane || form == MapForm::quadratic)
        flat.settled = math::settle_on_upper_half(flat.map.heights.data(), map.rows(), map.columns(), degree_of(form));
    const auto removed = [&](Eigen::Index j, Eigen::Index i) { return map.heights(j, i) - flat.map.heights(j, i); };
    flat.tilt = {removed(0, map.columns() - 1) - removed(0, 0), removed(map.rows() - 1, 0) - removed(0, 0)};
    if (form != MapForm::none)
        math::require_more_than_rounding<T>("map", name_of(form), map.heights.data(), flat.map.heights.data(),
                                            static_cast<std::size_t>(map.size()), resolution);
    return flat;
}

}  // namespace detail

}}  // namespace fstiff
