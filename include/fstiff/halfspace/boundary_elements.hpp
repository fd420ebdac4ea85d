// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Contact of one map with a flat, solved by boundary elements on the map itself, and its stiffness.
///
///     g = u[p] - h + d >= 0,   p >= 0,   p g = 0 at every point,   mean p = the nominal pressure
///     u[t] = 1/K on the contact, t = 0 elsewhere, mean t = 1       with a hardness: p <= H, K of unloading
///     u[t] = 1/K_loading where 0 < p < H, t = 0 elsewhere          K_loading is -dp/dd on loading, K or less
///
/// u[p] is that of an elastic half space that repeats or mirrors the map: docs/theory-contact.md, section 11.
/// Reference   Stanley, Kato, J. Tribol. 119 (1997) 481; conjugate gradients: Polonsky, Keer, Wear 231 (1999) 206;
///             sets: Hintermueller, Ito, Kunisch, SIAM J. Optim. 13 (2002) 865; the cut at H: Almqvist, Sahlin,
///             Larsson, Glavatskih, Tribol. Int. 40 (2007) 574, by Dai, Fletcher, Math. Program. 106 (2006) 403.
/// Units       heights, lengths, gaps [m]; pressures [Pa]; K [Pa/m]
/// Valid       maps without missing points; nominal pressures below H; gradients small enough for a half space
/// Accuracy    of the equations on the grid: tolerance, 1e-8 by default; of the surface: solve_half_space.hpp; of
///             K_loading of few points 8 %. Westergaard, another code: tests/halfspace/boundary_elements_test.cpp

#include <fstiff/core/error.hpp>
#include <fstiff/core/parallel.hpp>
#include <fstiff/halfspace/bonded_contact.hpp>
#include <fstiff/halfspace/surface_compliance.hpp>
#include <fstiff/topography/coarser_map.hpp>
#include <fstiff/topography/height_map.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 {

/// Options of the solution of the half space.
template <Real T = double>
struct BoundaryElementOptions {
    Edges edges = Edges::mirrored;
    T hardness{};           ///< H [Pa] at which pressures are cut; 0: elastic
    T tolerance = T(1e-8);  ///< change of the pressures over their sum at which the solution counts as found
    int max_iterations = 2000;
    bool loading = true;      ///< solve for the loading stiffness too where it is not K; it is K otherwise
    ProgressHook progress{};  ///< called once an iteration, with max_iterations as the end
};

/// One solution.
template <Real T = double>
struct BoundaryElementState {
    T pressure{};                   ///< nominal [Pa]
    T stiffness{};                  ///< K of the contact held together [Pa/m]; infinite where all points touch
    T loading_stiffness{};          ///< -dp/dd [Pa/m], at most K: of points below H, held together; where they are few,
                                    ///< and come and go one by one, over pressures between which 80 points join
    T contact_fraction{};           ///< share of the points in contact
    T mean_gap{};                   ///< mean distance of the two faces, the separation of their mean planes [m]
    T max_pressure{};               ///< [Pa]
    Eigen::Index below_hardness{};  ///< points in contact with p < H
    Eigen::Index spots{};           ///< contacts, joined through edges and corners
    T residual{};                   ///< change of the pressures by the last iteration, over their sum
    int iterations{};
    bool converged = false;  ///< residual and that of the stiffness are below the tolerance
};

/// The elastic half space under one map, solved at one pressure after another.
template <Real T = double>
class BoundaryElements {
    using Field = detail::GridField<T>;

public:
    /// Presses the surface \p map against a smooth flat. \throws domain_error for missing points and as
    /// HeightMap::validate.
    BoundaryElements(const HeightMap<T>& map, std::type_identity_t<T> effective_modulus,
                     const BoundaryElementOptions<T>& options = {});

    /// The contact under \p pressure [Pa], whatever was solved before. \throws domain_error unless 0 < pressure, < H.
    [[nodiscard]] BoundaryElementState<T> at_pressure(T pressure);

    /// State of the last solution on the grid half as fine, from which it began; its loading stiffness is K.
    /// \throws domain_error before at_pressure() and without such a grid: for less than 16 points along the shorter
    /// side, and for heights that all cancel on it.
    [[nodiscard]] BoundaryElementState<T> on_coarser_grid();

    /// Pressures of the last solution [Pa], mirrored rows and columns left out.
    [[nodiscard]] Field pressures() const { return p_ * modulus_; }

private:
    struct Solution {
        T value;  ///< of u on the contact
        T residual;
        int iterations;
    };
    /// The contact from that on the coarser grid.
    Solution approach(T nominal, T tolerance);
    /// The contact from the pressures that there are.
    Solution solve(T nominal, T tolerance);
    /// Sets and conjugate gradients for p of the mean \p nominal (over E); with more than \p most iterations given up.
    Solution solve_sets(T nominal, T tolerance, int most);
    /// Lets points leave and join the set of those between 0 and H. \return true if none did.
    [[nodiscard]] bool is_set_kept(detail::SetGradients<T>& gradients, T nominal);
    /// Puts p between 0 and H, and scales those in between to the mean \p nominal. \return false if they cannot.
    [[nodiscard]] bool bound(T nominal);
    /// The same by projected gradients with the step of Barzilai and Borwein, where sets go round in circles.
    Solution solve_cut(T nominal, T tolerance);
    [[nodiscard]] BoundaryElementState<T> state(T pressure, const Solution& solution);
    /// -dp/dd at \p state, where points have yielded.
    [[nodiscard]] T loading_stiffness(const BoundaryElementState<T>& state);
    /// The nearest pressures between 0 and \p hard of the mean \p nominal: all shifted by one number, and cut.
    static void project(Field& p, T nominal, T hard);
    /// Conjugate gradients for t on the points of the contact with p below \p most: value is 1/K.
    [[nodiscard]] Solution held(T most) const;
    /// H over E; infinite: elastic.
    [[nodiscard]] T hard() const {
        return options_.hardness > 0 ? options_.hardness / modulus_ : std::numeric_limits<T>::infinity();
    }
    void tell(int iteration) const {
        if (options_.progress)
            options_.progress("boundary elements", static_cast<std::size_t>(iteration),
                              static_cast<std::size_t>(options_.max_iterations));
    }

    static constexpr T held_tolerance = T(1e-5);    ///< scatter of u on the contact over its value: K to 1e-9
    static constexpr T coarse_tolerance = T(1e-4);  ///< of a solution that is a start alone
    static constexpr T enough = T(0.3);  ///< rest of the first change of the pressures at which a set is tried
    static constexpr T joining = 80;     ///< points between the pressures of the loading stiffness
    static constexpr T rough_tolerance = T(1e-3);  ///< of projected gradients before sets
    static constexpr int most_of_cut = 100;        ///< iterations of sets that are cut at H, before projected gradients
    static constexpr Eigen::Index least_side = 16;  ///< of a grid that has a coarser one

    T modulus_;
    T softest_;  ///< pressure over E and deflection of the longest wave [1/m]: the first step of solve_cut
    BoundaryElementOptions<T> options_;
    Field height_, p_, u_;  ///< [m]; pressure over E; deflection [m]
    mutable detail::SurfaceCompliance<T> compliance_;
    mutable detail::WaveFactors<float> inverse_;
    std::vector<BoundaryElements> coarser_;  ///< one, or none
};

template <Real T>
BoundaryElements<T>::BoundaryElements(const HeightMap<T>& map, std::type_identity_t<T> effective_modulus,
                                      const BoundaryElementOptions<T>& options)
    : modulus_(effective_modulus),
      softest_(std::numbers::pi_v<T> / (std::max)(map.dx * T(map.columns()), map.dy * T(map.rows()))),
      options_(options),
      height_(map.heights),
      compliance_(map.rows(), map.columns(), map.dx, map.dy, options.edges),
      inverse_(compliance_.inverse()) {
    map.validate();
    detail::require_positive("effective_modulus", effective_modulus);
    if (options.hardness != T(0)) detail::require_positive("hardness", options.hardness);
    map.require_whole("before boundary elements");
    height_ -= height_.mean();
    if ((std::min)(map.rows(), map.columns()) < least_side) return;
    const HeightMap<T> half = detail::coarsened(map, (std::max)(map.rows(), map.columns()) / 2);
    if (half.heights.maxCoeff() == half.heights.minCoeff()) return;  // heights that cancel, of a zigzag
    BoundaryElementOptions<T> silent = options;
    silent.progress = {};
    silent.loading = false;
    coarser_.emplace_back(half, effective_modulus, silent);
}

template <Real T>
BoundaryElementState<T> BoundaryElements<T>::at_pressure(T pressure) {
    detail::require_positive("pressure", pressure);
    if (options_.hardness > 0)
        detail::require(pressure < options_.hardness, "pressure", pressure, "less than the hardness (Pa)");
    return state(pressure, approach(pressure / modulus_, options_.tolerance));
}

template <Real T>
BoundaryElementState<T> BoundaryElements<T>::on_coarser_grid() {
    detail::require(!coarser_.empty(), "coarser grids", 0,
                    "1, which a map of 16 points a side has unless it is flat there");
    detail::require(p_.size() > 0, "pressures solved", 0, "at least 1");
    const T nominal = p_.mean();
    BoundaryElements& coarser = coarser_.front();
    return coarser.state(nominal * modulus_, coarser.solve(nominal, options_.tolerance));
}

template <Real T>
typename BoundaryElements<T>::Solution BoundaryElements<T>::approach(T nominal, T tolerance) {
    const Eigen::Index rows = height_.rows(), columns = height_.cols();
    if (coarser_.empty()) {
        p_ = Field::Ones(rows, columns);
    } else {
        BoundaryElements& coarser = coarser_.front();
        coarser.approach(nominal, (std::max)(tolerance, coarse_tolerance));
        const Eigen::Index below = coarser.p_.rows(), beside = coarser.p_.cols();
        p_ = Field::NullaryExpr(rows, columns, [&](Eigen::Index j, Eigen::Index i) {  // the cell that holds the centre
            return coarser.p_((2 * j + 1) * below / (2 * rows), (2 * i + 1) * beside / (2 * columns));
        });
    }
    return solve(nominal, tolerance);
}

template <Real T>
typename BoundaryElements<T>::Solution BoundaryElements<T>::solve(T nominal, T tolerance) {
    p_ *= nominal / p_.mean();
    u_ = p_;
    compliance_.deflect(u_);
    if (!(options_.hardness > 0)) return solve_sets(nominal, tolerance, options_.max_iterations);
    const Solution rough = solve_cut(nominal, (std::max)(tolerance, rough_tolerance));
    if (rough.residual <= tolerance) return rough;
    Solution solution = solve_sets(nominal, tolerance, most_of_cut);
    solution.iterations += rough.iterations;
    return solution.residual <= tolerance ? solution : solve_cut(nominal, tolerance);
}

template <Real T>
BoundaryElementState<T> BoundaryElements<T>::state(T pressure, const Solution& solution) {
    BoundaryElementState<T> state;
    state.pressure = pressure;
    const auto contact = p_ > T(0);
    const Eigen::Index count = contact.count();
    state.contact_fraction = T(count) / T(p_.size());
    state.below_hardness = (contact && p_ < hard()).count();
    state.max_pressure = p_.maxCoeff() * modulus_;
    state.mean_gap = -solution.value;  // the mean of u and h is 0
    state.residual = solution.residual;
    state.iterations = solution.iterations;
    state.converged = solution.residual <= options_.tolerance;
    state.spots = detail::count_spots(p_, options_.edges);
    if (count == p_.size()) {
        state.stiffness = std::numeric_limits<T>::infinity();
    } else {
        const Solution unit = held(std::numeric_limits<T>::infinity());
        state.stiffness = state.loading_stiffness = modulus_ / unit.value;
        state.iterations += unit.iterations;
        state.converged = state.converged && unit.residual <= held_tolerance;
        if (options_.loading && state.below_hardness < count) state.loading_stiffness = loading_stiffness(state);
    }
    return state;
}

template <Real T>
T BoundaryElements<T>::loading_stiffness(const BoundaryElementState<T>& state) {
    const T count = state.contact_fraction * T(p_.size()), few = (std::max)(T(200), T(0.03) * count);
    if (T(state.below_hardness) >= few) return modulus_ / held(hard()).value;
    const T apart = std::exp(std::clamp(joining / (2 * count), T(0.03), T(0.5)));
    const T above = (std::min)(apart * state.pressure, (state.pressure + options_.hardness) / 2),
            below = state.pressure / apart;
    const Field solved = p_, below_it = coarser_.empty() ? Field() : coarser_.front().p_;
    const auto gap = [&](T pressure) { return -approach(pressure / modulus_, options_.tolerance).value; };
    const T fall = gap(below) - gap(above);
    p_ = solved;
    if (!coarser_.empty()) coarser_.front().p_ = below_it;
    return std::clamp(state.pressure * std::log(above / below) / fall, T(0), state.stiffness);
}

template <Real T>
typename BoundaryElements<T>::Solution BoundaryElements<T>::solve_sets(T nominal, T tolerance, int most) {
    const T total = nominal * T(p_.size());
    detail::SetGradients<T> gradients(compliance_, inverse_, height_);
    gradients.start(detail::points_of<T>((p_ < hard()).select(p_, T(0))), u_);
    int iteration = 0, quiet = 0;
    T sum = std::numeric_limits<T>::infinity();
    while (iteration < most && !gradients.points().empty()) {
        T change = 0, first = 0;
        sum = 0;
        do {
            tell(iteration++);
            change = gradients.step(p_, u_) / total;
            sum += change;
            first = (std::max)(first, change);
        } while (change > tolerance && change > enough * first && iteration < most);
        const T level = gradients.level();
        const bool kept = is_set_kept(gradients, nominal);
        quiet = sum <= tolerance ? quiet + 1 : 0;  // twice: points at the edge of rounding
        if ((kept && change <= tolerance) || quiet == 2) return {level, change, iteration};
    }
    if (gradients.points().empty()) sum = std::numeric_limits<T>::infinity();
    return {gradients.level(), sum, iteration};
}

template <Real T>
bool BoundaryElements<T>::is_set_kept(detail::SetGradients<T>& gradients, T nominal) {
    const auto& points = gradients.points();
    const T level = gradients.level();
    const auto is_inside = [&](Eigen::Index k) { return p_.data()[k] > 0 && p_.data()[k] < hard(); };
    std::vector<Eigen::Index> joined, next;
    auto member = points.begin();
    bool bounded = false;
    for (Eigen::Index k = 0; k < p_.size(); ++k) {
        const T gap = u_.data()[k] - height_.data()[k];
        if (member != points.end() && *member == k) {
            ++member;
            bounded = bounded || !is_inside(k);
        } else if (p_.data()[k] > 0 ? gap > level : gap < level) {
            joined.push_back(k);
        }
    }
    if (!bounded && joined.empty()) return true;
    if (bounded) {
        if (!bound(nominal)) return gradients.start({}, u_), false;
        u_ = p_;
        compliance_.deflect(u_);
    }
    auto more = joined.begin();
    for (Eigen::Index k = 0; k < p_.size(); ++k) {
        const bool joins = more != joined.end() && *more == k;
        if (joins) ++more;
        if (joins || is_inside(k)) next.push_back(k);
    }
    gradients.start(std::move(next), u_);
    return false;
}

template <Real T>
bool BoundaryElements<T>::bound(T nominal) {
    p_ = ((p_.max)(T(0)).min)(hard());
    for (int i = 0; i < 20; ++i) {
        const auto inside = p_ < hard();
        const T flowed = inside.select(T(0), p_).sum(),
                factor = (nominal * T(p_.size()) - flowed) / (p_.sum() - flowed);
        if (!(factor > 0 && std::isfinite(factor))) return false;
        p_ = inside.select(((p_ * factor).min)(hard()), p_).eval();
        if (std::abs(p_.mean() - nominal) <= 64 * std::numeric_limits<T>::epsilon() * nominal) return true;
    }
    return false;
}

template <Real T>
typename BoundaryElements<T>::Solution BoundaryElements<T>::solve_cut(T nominal, T tolerance) {
    const T hard = this->hard();
    project(p_, nominal, hard);
    u_ = p_;
    compliance_.deflect(u_);
    Field gap = u_ - height_, direction, response;
    T step = softest_, change = std::numeric_limits<T>::infinity();
    int iteration = 0;
    for (; iteration < options_.max_iterations && change > tolerance; ++iteration) {
        tell(iteration);
        gap -= (p_ > T(0)).select(gap, T(0)).sum() / T((p_ > T(0)).count());  // any constant: digits are kept next to 0
        direction = p_ - step * gap;
        project(direction, nominal, hard);
        direction -= p_;
        change = direction.abs().mean() / nominal;
        response = direction;
        compliance_.deflect(response);
        const T curvature = (direction * response).sum();
        if (!(curvature > 0)) break;
        // downhill; where the direction is rounding alone its slope may have either sign
        const T along = std::clamp(-(gap * direction).sum() / curvature, T(0), T(1));
        p_ += along * direction;
        gap += along * response;
        step = direction.square().sum() / curvature;
    }
    u_ = p_;
    compliance_.deflect(u_);
    gap = u_ - height_;
    // between the points that are cut and those that are open
    T inside = -std::numeric_limits<T>::infinity(), outside = std::numeric_limits<T>::infinity();
    for (Eigen::Index k = 0; k < gap.size(); ++k) {
        T& bound = p_.data()[k] > T(0) ? inside : outside;
        bound = p_.data()[k] > T(0) ? (std::max)(bound, gap.data()[k]) : (std::min)(bound, gap.data()[k]);
    }
    return {(inside + (std::max)(inside, outside)) / 2, change, iteration};
}

template <Real T>
void BoundaryElements<T>::project(Field& p, T nominal, T hard) {
    T low = p.minCoeff() - hard, high = p.maxCoeff(), shift = 0;  // with these means of H and 0
    for (int i = 0; i < 100; ++i) {
        const auto cut = (((p - shift).max)(T(0)).min)(hard);
        const T excess = cut.mean() - nominal;
        Eigen::Index inside = 0;
        for (const T* value = p.data(); value != p.data() + p.size(); ++value)  // no jumps: a loop of vectors
            inside += Eigen::Index(*value - shift > T(0)) & Eigen::Index(*value - shift < hard);
        const T slope = T(inside) / T(p.size());
        if (std::abs(excess) <= 4 * std::numeric_limits<T>::epsilon() * nominal || i == 99) {
            p = cut;
            return;
        }
        (excess > 0 ? low : high) = shift;
        shift += excess / slope;
        if (!(shift > low && shift < high)) shift = (low + high) / 2;
    }
}

template <Real T>
typename BoundaryElements<T>::Solution BoundaryElements<T>::held(T most) const {
    const Field start = (p_ < most).select(p_, T(0)), mask = (start > T(0)).template cast<T>();
    const detail::BondedContact<T> contact =
        detail::bonded(compliance_, inverse_, mask, start, held_tolerance, options_.max_iterations);
    return {contact.compliance, contact.residual, contact.iterations};
}

}}  // namespace fstiff
