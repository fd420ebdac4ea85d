// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Nodes of the contact integrals: three substitutions that make the integrand over the curvature t smooth.
///
///     J[a,b] = c^a/(2 theta) int_0^inf t^b erf(k t) exp(-t^2/2) F_a(x) dt, x = (eta - r t)/c, k = tan(theta)/sqrt 2
///     smooth      t = 2.1 log(1 + exp(y - 0.4 exp(-1.354 y)))   from tables
///     graded      t = s exp(y - exp(-y))                  all scales from s = min(1, 1/k, c + max(0, -eta)) to 1 alike
///     separated   x = -(3 y + exp(y)), t = (eta - c x)/r        the Gaussian clear of t = 0
///
/// Every rule is trapezoidal over the whole line in y, so that it converges geometrically and contains the rule of
/// twice the step, whose difference is the error estimate. exp(-eta^2/2) is taken out where eta > 0.
///
/// Reference   Trefethen and Weideman, SIAM Review 56 (2014) 385-458; Takahasi and Mori, Publ. RIMS 9 (1974) 721-741;
///             the constants of the smooth map: this project, 32 nodes for 3e-13
/// Accuracy    see contact_integrals.hpp

#include <fstiff/core/numbers.hpp>
#include <fstiff/math/lanes.hpp>
#include <fstiff/peaks/peak_distribution.hpp>

#include <numbers>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// One evaluation: the parameters that all nodes share.
template <Real T>
struct PeakProblem {
    T r, theta, eta{};
    T log_cutoff;  ///< -log of what may be neglected
    T c = std::sqrt((1 - r) * (1 + r));
    T k = std::tan(theta) / std::numbers::sqrt2_v<T>;
    T floor{};  ///< max(eta, 0): exp(-floor^2/2) is taken out of every node, the rest is of order 1
    T reach = std::sqrt(2 * log_cutoff);  ///< exp(-reach^2/2) may be neglected

    template <Real U>
    PeakProblem(const PeakDistribution<U>& peaks, T at_eta, T neglect_below)
        : r(static_cast<T>(peaks.r())),
          theta((std::max)(static_cast<T>(peaks.theta()), min_theta)),
          log_cutoff(neglect_below) {
        move_to(at_eta);
    }
    void move_to(T at_eta) {
        eta = at_eta;
        floor = (std::max)(eta, T(0));
    }

private:
    /// Below it erf(k t)/(2 theta) is t/sqrt(2 pi) to the last digit of every type, while erf(k t) might underflow.
    static constexpr T min_theta = T(1e-12);
};

/// Up to 64 nodes, eight by eight, at ascending curvatures t: the parts of an integrand.
template <Real T>
class PeakNodes {
public:
    static constexpr int capacity = 64, block = 8;
    using V = math::Lanes<T, block>;

    explicit PeakNodes(const PeakProblem<T>& problem) : floor_(problem.floor) {}

    /// \p table: distinguishes sets of t that are the same in every problem, or null.
    void begin(const T* table = nullptr) {
        size_ = 0;
        table_ = table;
    }
    [[nodiscard]] const T* table() const { return table_; }
    [[nodiscard]] int size() const { return size_; }
    [[nodiscard]] bool full() const { return size_ == capacity; }

    /// Eight nodes more: at t, x = (eta - r t)/c, z = (t - r eta)/c and t - floor, of weight dt/dy.
    EIGEN_ALWAYS_INLINE void add(const V& t, const V& x, const V& z, const V& excess, const V& weight,
                                 const V& inverse_root) {
        t.store(t_ + size_);
        x.store(x_ + size_);
        inverse_root.store(inverse_root_ + size_);
        V exponent = z * z;
        if (x_[size_ + block - 1] < 0) {  // x descends
            const V outer = excess * (t + V::all(floor_));
            exponent = x_[size_] < 0 ? outer : select_less(x, V::all(T(0)), outer, exponent);
        }
        (exp(exponent * V::all(T(-0.5))) * weight).store(mass_ + size_);
        size_ += block;
    }

    const T* t() const { return t_; }
    const T* x() const { return x_; }
    /// dt/dy exp(-t^2/2), times exp(-x^2/2) for x >= 0, without the factor exp(-floor^2/2).
    const T* mass() const { return mass_; }
    const T* inverse_root() const { return inverse_root_; }  ///< t^(-1/2)

private:
    T floor_;
    int size_ = 0;
    const T* table_ = nullptr;
    alignas(64) T t_[capacity], x_[capacity], mass_[capacity], inverse_root_[capacity];
};

/// j, j + 1, ..., j + 7
template <Real T>
EIGEN_ALWAYS_INLINE math::Lanes<T, 8> ascending_from(int j) {
    alignas(64) static constexpr T numbers[8]{0, 1, 2, 3, 4, 5, 6, 7};
    return math::Lanes<T, 8>::load(numbers) + math::Lanes<T, 8>::all(T(j));
}

/// The curvature beyond which the integrand is below exp(-log_cutoff) of its greatest value.
template <Real T>
T max_curvature(const PeakProblem<T>& p) {
    const T inner = p.r * p.eta + p.reach * p.c;  // end of the Gaussian, if x > 0 up to there
    if (inner * p.r <= p.eta) return inner;
    return std::sqrt(p.floor * p.floor + 2 * p.log_cutoff);  // end of exp(-t^2/2)
}

/// Nodes and weights of the smooth map, in tables of decreasing step: they depend on the step alone.
template <Real T>
class SmoothNodes {
public:
    static constexpr std::size_t capacity = 256;
    struct StepTable {
        T step;
        std::size_t count;
        std::array<T, capacity> node, weight, inverse_root;
    };

    static const SmoothNodes& get() {
        static const SmoothNodes nodes;
        return nodes;
    }

    /// The coarsest table whose step is at most \p step; the finest one when there is none.
    [[nodiscard]] const StepTable& at_most(T step) const {
        std::size_t i = 0;
        while (i + 1 < steps_.size() && steps_[i] > step) ++i;
        return tables_[i];
    }

    static constexpr T scale = T(2.1);
    static constexpr T left = T(3.4);        ///< about where the tables begin, y = -left
    static constexpr T min_step = T(0.075);  ///< a step below this is not offered
    static constexpr T max_node = T(22);     ///< no problem that is not separated reaches further

private:
    SmoothNodes() {
        T step = T(0.2273 * 4);  // so that 0.2273, of the 32 nodes above, is a table
        for (std::size_t i = 0; i < tables_.size(); ++i) {
            StepTable& table = tables_[i];
            steps_[i] = table.step = step;
            // a table serves errors down to exp(-log_accuracy) or so: its first weight is below that
            const T log_accuracy = (std::min)(T(7.6) / step - 4, 2 - std::log(std::numeric_limits<T>::epsilon()));
            const int begin = static_cast<int>(
                std::floor(-std::log(((std::max)(log_accuracy, T(4)) + 7) / T(0.4)) / (T(1.354) * step)));
            for (table.count = 0; table.count < capacity; ++table.count) {
                const T y = T(begin + static_cast<int>(table.count)) * step;
                const T fall = T(0.4) * std::exp(T(-1.354) * y);
                const T v = y - fall;
                const T decay = std::exp(-std::abs(v));
                table.node[table.count] =
                    (std::max)(scale * ((std::max)(v, T(0)) + std::log1p(decay)), T(1e-30));  // 1/t is finite
                table.weight[table.count] = scale * (1 + T(1.354) * fall) * (v > 0 ? 1 : decay) / (1 + decay);
                table.inverse_root[table.count] = 1 / std::sqrt(table.node[table.count]);
                if (table.count % PeakNodes<T>::block == 0 && table.node[table.count] > max_node) break;
            }
            step *= T(0.917004043204671);  // 2^(-1/8): a table is at most 9 % finer than asked for
        }
    }

    std::array<T, 30> steps_;  // apart from the tables: the search stays in a few cache lines
    std::array<StepTable, 30> tables_;
};

/// Adds nodes given by t alone.
template <Real T>
EIGEN_ALWAYS_INLINE void add_at(PeakNodes<T>& nodes, const PeakProblem<T>& p, T inverse_c, const math::Lanes<T, 8>& t,
                                const math::Lanes<T, 8>& weight, const math::Lanes<T, 8>& inverse_root) {
    using V = math::Lanes<T, 8>;
    nodes.add(t, multiply_add(t, V::all(-p.r * inverse_c), V::all(p.eta * inverse_c)),
              (t - V::all(p.r * p.eta)) * V::all(inverse_c), t - V::all(p.floor), weight, inverse_root);
}

template <Real T, class Sink>
T visit_smooth(const PeakProblem<T>& p, T wanted_step, Sink& sink) {
    using V = math::Lanes<T, 8>;
    const auto& table = SmoothNodes<T>::get().at_most(wanted_step);
    const T last = max_curvature(p);
    const T inverse_c = 1 / p.c;
    PeakNodes<T> nodes(p);
    nodes.begin(table.node.data());
    for (std::size_t j = 0; j < table.count && table.node[j] <= last; j += nodes.block) {
        if (nodes.full()) {
            sink.add(nodes);
            nodes.begin(&table.node[j]);
        }
        add_at(nodes, p, inverse_c, V::load(&table.node[j]), V::load(&table.weight[j]),
               V::load(&table.inverse_root[j]));
    }
    sink.add(nodes);
    return table.step;
}

template <Real T>
T graded_scale(const PeakProblem<T>& p) {
    return (std::min)({T(1), 1 / p.k, p.c + (std::max)(T(0), -p.eta)});
}

template <Real T, class Sink>
T visit_graded(const PeakProblem<T>& p, T step, Sink& sink) {
    using V = math::Lanes<T, 8>;
    const T scale = graded_scale(p);
    const T ratio = max_curvature(p) / scale;
    const T last = std::log(ratio) + 1 / ratio;  // y - exp(-y) = log(ratio)
    const T inverse_c = 1 / p.c;
    const V one = V::all(T(1));
    PeakNodes<T> nodes(p);
    for (int j = 2 * static_cast<int>(std::floor(-std::log(p.log_cutoff + 2) / (2 * step))); T(j) * step < last;
         j += nodes.block) {
        const V y = ascending_from<T>(j) * V::all(step);
        const V fall = exp(V::all(T(0)) - y);
        const V t = V::all(scale) * exp(y - fall);
        if (nodes.full()) {
            sink.add(nodes);
            nodes.begin();
        }
        add_at(nodes, p, inverse_c, t, t * (fall + one), one / sqrt(t));
    }
    sink.add(nodes);
    return step;
}

template <Real T, class Sink>
T visit_separated(const PeakProblem<T>& p, T step, Sink& sink) {
    using V = math::Lanes<T, 8>;
    constexpr T slope = 3;
    const T high = p.c * p.eta + p.reach * p.r;
    T low = p.c * p.eta - p.reach * p.r;
    if (low < 0) {  // to the end of exp(-t^2/2) at t = hypot(eta, reach): (eta - r t)/c, without its cancellation
        const T end = std::hypot(p.eta, p.reach);
        low = (p.c * p.eta * p.c * p.eta - p.r * p.reach * p.r * p.reach) / (p.c * (p.eta + p.r * end));
    }
    const T y_high = low < 0 ? std::log(1 - low) : 1 - low / slope;
    const T c_over_r = p.c / p.r;
    const T inverse_r = 1 / p.r;
    const T distance = p.eta * (1 - p.r) * inverse_r;  // of the turn-on from t = eta
    const T least = p.c / 2;  // t at the idle end of the first eight nodes; the integrand is negligible there
    PeakNodes<T> nodes(p);
    for (int j = 2 * static_cast<int>(std::floor(-(high + T(0.4)) / (2 * slope * step))); T(j) * step < y_high;
         j += nodes.block) {
        const V y = ascending_from<T>(j) * V::all(step);
        const V rise = exp(y);
        const V x = V::all(T(0)) - multiply_add(y, V::all(slope), rise);
        const V excess = multiply_add(x, V::all(-c_over_r), V::all(distance));
        const V t = larger(excess + V::all(p.eta), V::all(least));
        if (nodes.full()) {
            sink.add(nodes);
            nodes.begin();
        }
        nodes.add(t, x, (V::all(p.c * p.eta) - x) * V::all(inverse_r), excess,
                  (rise + V::all(slope)) * V::all(c_over_r), V::all(T(1)) / sqrt(t));
    }
    sink.add(nodes);
    return step;
}

/// Chooses a rule and its step for a relative error of exp(-log_accuracy).
///
/// separated   when the Gaussian of mean r eta and width c is further from t = 0 than it reaches, so that the branch
///             point and the layer at t = 0 do not count. Step: resolves the Gaussian, which has width r in x.
/// smooth      when its step, which has to resolve the Gaussian (c) and the layer (1/k), makes it the cheaper one.
/// graded      else: c or 1/k small. Step: 3.9/(log_accuracy + 3), less where the Gaussian is narrow.
///
/// The constants were fitted to the largest steps that reach 1e-3, 1e-8 and 3e-13 over r, theta, eta; where they are
/// too hopeful the error estimate shows it.
/// Calls sink.add with PeakNodes and returns the step: an integral is the step times the sum.
template <Real T, class Sink>
T visit_nodes(const PeakProblem<T>& p, T log_accuracy, Sink& sink) {
    const T root = std::sqrt(log_accuracy);
    const T distance = p.r * p.eta / p.c;
    if (distance > p.reach + 1)
        return visit_separated(
            p, (std::min)(T(1.3) * p.r / root, (T(3.9) + T(0.35) * (std::min)(p.eta, T(3))) / (log_accuracy + 3)),
            sink);

    const T strip = T(7.6) / ((log_accuracy + 4) * (1 + (std::max)(T(0), T(0.066) * p.k * p.k - T(0.07))));
    const T smooth_step = (std::min)(strip, T(2.1) * p.c / root * (p.eta <= 0 ? T(1.25) : T(1)));
    if (smooth_step >= T(0.15) && p.k <= T(2)) return visit_smooth(p, smooth_step, sink);  // always the cheaper one

    const T narrow = (std::max)(distance, T(0)) * root / T(2.9);
    const T wide = (log_accuracy + 3) / T(3.9);
    const T graded_step = 1 / std::sqrt(wide * wide + narrow * narrow);

    const T smooth_cost = (SmoothNodes<T>::left + max_curvature(p) / SmoothNodes<T>::scale) / smooth_step;
    const T graded_cost = (std::log(p.log_cutoff + 2) + std::log(max_curvature(p) / graded_scale(p))) / graded_step;
    const bool offered = smooth_step >= SmoothNodes<T>::min_step;
    return offered && smooth_cost <= T(1.2) * graded_cost ? visit_smooth(p, smooth_step, sink)
                                                          : visit_graded(p, graded_step, sink);
}

}}}  // namespace fstiff::detail
