// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The truth of one map: its contact with a flat, solved by boundary elements on the map itself.
///
///     g = u[p] - h + d >= 0,   p >= 0,   p g = 0 at every point,   mean p = the nominal pressure
///     u[p] of an elastic half space that repeats the map, or mirrors it at its edges (halfspace/surface_compliance.hpp)
///
/// is a quadratic programme and is solved by conjugate gradients (Polonsky, Keer). The stiffness needs no difference of two
/// solutions: the points in contact are held together and moved by one unit,
///
///     u[t] = 1/K on the contact, t = 0 elsewhere, mean t = 1
///
/// which is -dp/dd where the set of contacts changes smoothly, and what a wave sees that moves the faces by less than a
/// nanometre. With a hardness H the pressure is cut there (p <= H; g < 0 is plastic flow where p = H), and the stiffness is that
/// of unloading.
///
/// Reference   Polonsky, Keer, Wear 231 (1999) 206; Stanley, Kato, J. Tribol. 119 (1997) 481; the cut at H: Almqvist et al.,
///             J. Mech. Phys. Solids 55 (2007) 1, here by the method of Dai, Fletcher, Math. Program. 106 (2006) 403.
/// Units       heights, lengths, gaps [m]; pressures [Pa]; K [Pa/m]
/// Valid       maps without missing points; nominal pressures below H; gradients small enough for a half space
/// Accuracy    of the equations on the grid: tolerance, 1e-8 by default. Of the surface: a contact needs several points, and
///             solving on a coarser grid too tells the rest (halfspace/truth.hpp). Against the wave of Westergaard and another code:
///             tests/halfspace/boundary_elements_test.cpp

#include <fstiff/core/error.hpp>
#include <fstiff/core/progress.hpp>
#include <fstiff/halfspace/held_contact.hpp>
#include <fstiff/halfspace/surface_compliance.hpp>
#include <fstiff/topography/height_map.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace fstiff {

/// How the half space is solved.
template <Real T = double>
struct BoundaryElementOptions {
    Edges edges = Edges::mirrored;
    T hardness{};           ///< H [Pa] at which pressures are cut; 0: elastic
    T tolerance = T(1e-8);  ///< change of the pressures over their sum at which the solution counts as found
    int max_iterations = 2000;
    ProgressHook progress{};  ///< called once an iteration, with max_iterations as the end
};

/// One solution.
template <Real T = double>
struct BoundaryElementState {
    T pressure{};          ///< nominal [Pa]
    T stiffness{};         ///< K of the contact held together [Pa/m]; infinite where all points touch
    T contact_fraction{};  ///< share of the points in contact
    T mean_gap{};          ///< mean distance of the two faces, the separation of their mean planes [m]
    T max_pressure{};      ///< [Pa]
    Eigen::Index spots{};  ///< contacts, joined through edges and corners
    T residual{};          ///< what the last iteration changed of the pressures, over their sum
    int iterations{};
    bool converged = false;  ///< residual and that of the stiffness are below the tolerance
};

/// The elastic half space under one map, solved at one pressure after another.
template <Real T = double>
class BoundaryElements {
    using Field = GridField<T>;

public:
    /// Of the surface \p map against a smooth flat. \throws domain_error for missing points and what HeightMap::validate says.
    BoundaryElements(const HeightMap<T>& map, std::type_identity_t<T> effective_modulus,
                     const BoundaryElementOptions<T>& options = {});

    /// The contact under \p pressure [Pa], from the last solution, which is the faster the closer it was.
    /// \throws domain_error unless 0 < pressure, < H.
    [[nodiscard]] BoundaryElementState<T> at_pressure(T pressure);

    /// Pressures of the last solution [Pa], mirrored rows and columns left out.
    [[nodiscard]] Field pressures() const { return p_ * modulus_; }

private:
    struct Found {
        T value;  ///< of u on the contact
        T residual;
        int iterations;
    };
    /// Conjugate gradients for p at the mean \p nominal (over E).
    Found solve(T nominal);
    /// The same with p <= H, by projected gradients with the step of Barzilai and Borwein: most points in contact are bound then.
    Found solve_cut(T nominal);
    /// The nearest pressures between 0 and \p hard of the mean \p nominal: all shifted by one number, and cut.
    static void project(Field& p, T nominal, T hard);
    /// Conjugate gradients for t on the contact: value is 1/K.
    [[nodiscard]] Found held() const;
    /// The pressures that would close \p gap were all points \p free ones (1, others 0), of mean 0 on these: the operator is
    /// 1/|q|, so that |q| leaves few different eigenvalues, and iterations fall to a third where much is in contact.
    [[nodiscard]] Field preconditioned(const Field& gap, const Field& free, T count) const {
        Field pull = gap * free;
        compliance_.press(pull);
        const T mean = (pull * free).sum() / count;
        return (pull - mean) * free;
    }
    [[nodiscard]] Eigen::Index count_spots() const;
    void tell(int iteration) const {
        if (options_.progress)
            options_.progress("boundary elements", static_cast<std::size_t>(iteration),
                              static_cast<std::size_t>(options_.max_iterations));
    }

    /// Scatter of u on the contact over its value. K is stationary: its error is the square of this.
    static constexpr T held_tolerance = T(1e-6);

    T modulus_;
    T softest_;  ///< pressure over E and deflection of the longest wave [1/m]: what a released point is given for its gap, since
                 ///< many are released together
    BoundaryElementOptions<T> options_;
    Field height_, p_, u_;  ///< [m]; pressure over E; deflection [m]
    mutable SurfaceCompliance<T> compliance_;
};

template <Real T>
BoundaryElements<T>::BoundaryElements(const HeightMap<T>& map, std::type_identity_t<T> effective_modulus,
                                      const BoundaryElementOptions<T>& options)
    : modulus_(effective_modulus),
      softest_(numbers::pi_v<T> / (std::max)(map.dx * T(map.columns()), map.dy * T(map.rows()))),
      options_(options),
      height_(map.heights),
      compliance_(map.rows(), map.columns(), map.dx, map.dy, options.edges) {
    map.validate();
    require_positive("effective_modulus", effective_modulus);
    if (options.hardness != T(0)) require_positive("hardness", options.hardness);
    map.require_whole("before boundary elements");
    height_ -= height_.mean();
}

template <Real T>
BoundaryElementState<T> BoundaryElements<T>::at_pressure(T pressure) {
    require_positive("pressure", pressure);
    if (options_.hardness > 0)
        require(pressure < options_.hardness, "pressure", pressure, "less than the hardness (Pa)");
    const T nominal = pressure / modulus_;
    if (p_.size() == 0) p_ = Field::Ones(height_.rows(), height_.cols());
    p_ *= nominal / p_.mean();
    u_ = p_;
    compliance_.deflect(u_);
    const Found found = options_.hardness > 0 ? solve_cut(nominal) : solve(nominal);
    BoundaryElementState<T> state;
    state.pressure = pressure;
    const auto contact = p_ > T(0);
    const Eigen::Index count = contact.count();
    state.contact_fraction = T(count) / T(p_.size());
    state.max_pressure = p_.maxCoeff() * modulus_;
    state.mean_gap = -found.value;  // the mean of u and h is 0
    state.residual = found.residual;
    state.iterations = found.iterations;
    state.converged = found.residual <= options_.tolerance;
    state.spots = count_spots();
    if (count == p_.size()) {
        state.stiffness = std::numeric_limits<T>::infinity();
    } else {
        const Found unit = held();
        state.stiffness = modulus_ / unit.value;
        state.iterations += unit.iterations;
        state.converged = state.converged && unit.residual <= held_tolerance;
    }
    return state;
}

template <Real T>
typename BoundaryElements<T>::Found BoundaryElements<T>::solve(T nominal) {
    Field direction = Field::Zero(p_.rows(), p_.cols()), response, gap;
    T last_norm = 1, level = 0, change = std::numeric_limits<T>::infinity();
    bool conjugate = false;
    int iteration = 0;
    for (; iteration < options_.max_iterations; ++iteration) {
        tell(iteration);
        gap = u_ - height_;
        const Field on = (p_ > T(0)).template cast<T>();
        const T count = on.sum();
        level = (gap * on).sum() / count;
        if (change <= options_.tolerance) break;
        gap -= level;
        const Field pull = preconditioned(gap, on, count);
        const T norm = (gap * pull).sum();
        direction = (pull + (conjugate ? norm / last_norm : T(0)) * direction) * on;
        direction = (direction - direction.sum() / count) * on;  // points that left had a share
        last_norm = norm;
        response = direction;
        compliance_.deflect(response);
        const T curvature = (response * direction).sum();
        const T step = curvature > 0 ? (gap * direction).sum() / curvature : T(0);
        Field next = p_ - step * direction;
        const auto touching = (p_ <= T(0) && gap < T(0)).eval();  // open points that lie within the other face
        conjugate = !touching.any();
        if (!conjugate || (next < T(0)).any()) {
            next = touching.select(-softest_ * gap, (next.max)(T(0)));
            next *= nominal / next.mean();
            u_ = next;
            compliance_.deflect(u_);
        } else {
            u_ -= step * response;
        }
        change = (next - p_).abs().mean() / nominal;
        p_.swap(next);
    }
    return {level, change, iteration};
}

template <Real T>
typename BoundaryElements<T>::Found BoundaryElements<T>::solve_cut(T nominal) {
    const T hard = options_.hardness / modulus_;
    project(p_, nominal, hard);
    u_ = p_;
    compliance_.deflect(u_);
    Field gap = u_ - height_, direction, response;
    T step = softest_, change = std::numeric_limits<T>::infinity();
    int iteration = 0;
    for (; iteration < options_.max_iterations && change > options_.tolerance; ++iteration) {
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
        const T along = (std::min)(T(1), -(gap * direction).sum() / curvature);
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
        const Field cut = (((p - shift).max)(T(0)).min)(hard);
        const T excess = cut.mean() - nominal;
        const T slope = T((cut > T(0) && cut < hard).count()) / T(p.size());
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
typename BoundaryElements<T>::Found BoundaryElements<T>::held() const {
    const Field on = (p_ > T(0)).template cast<T>();
    const HeldContact<T> found = held_together(compliance_, on, p_, held_tolerance, options_.max_iterations);
    return {found.compliance, found.residual, found.iterations};
}

template <Real T>
Eigen::Index BoundaryElements<T>::count_spots() const {
    const Eigen::Index rows = p_.rows(), columns = p_.cols();
    const bool round = options_.edges == Edges::periodic;
    std::vector<char> seen(static_cast<std::size_t>(p_.size()), 0);
    std::vector<std::pair<Eigen::Index, Eigen::Index>> open;
    Eigen::Index spots = 0;
    const auto visit = [&](Eigen::Index j, Eigen::Index i) {
        if (round) {
            j = (j + rows) % rows;
            i = (i + columns) % columns;
        } else if (j < 0 || i < 0 || j >= rows || i >= columns) {
            return false;
        }
        char& mark = seen[static_cast<std::size_t>(j * columns + i)];
        if (mark != 0 || !(p_(j, i) > 0)) return false;
        mark = 1;
        open.emplace_back(j, i);
        return true;
    };
    for (Eigen::Index j = 0; j < rows; ++j)
        for (Eigen::Index i = 0; i < columns; ++i) {
            if (visit(j, i)) ++spots;
            while (!open.empty()) {
                const auto [y, x] = open.back();
                open.pop_back();
                for (Eigen::Index dy = -1; dy <= 1; ++dy)
                    for (Eigen::Index dx = -1; dx <= 1; ++dx) visit(y + dy, x + dx);
            }
        }
    return spots;
}

}  // namespace fstiff
