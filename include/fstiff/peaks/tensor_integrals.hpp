// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Integrals over the peaks in two dimensions, for any function of height and curvature: laws without powers.
///
///     I[f](eta) = int_0^inf int_eta^inf f(zeta - eta, t) p_peak(zeta, t) dzeta dt
///
/// In rows of constant t the excess e = zeta - eta is covered by pieces e = from + size x of four rules
/// (peaks/tensor_nodes): squares x = (j h)^2, graded x = a log(1 + exp(y - b exp(-c y))), linear, and Legendre's
/// between kinks. Rows and nodes are added to the tolerance.
///
/// Reference   Trefethen and Weideman, SIAM Review 56 (2014) 385-458; Takahasi and Mori, Publ. RIMS 9 (1974) 721-741
/// Units       dimensionless
/// Valid       c >= 0.1, tan(theta) <= 10; beyond, and for kinks at e << c, the error returned shows the loss
/// Accuracy    1e-12 on tests/data/integrals_plain.csv; the error covers the true one there and for laws with up to
///             three kinks, r <= 0.98, 0.05 <= theta <= 1.5, -3 <= eta <= 8 (tests/peaks/tensor_integrals_test.cpp)

#include <fstiff/core/numbers.hpp>
#include <fstiff/peaks/peak_sums.hpp>
#include <fstiff/peaks/tensor_nodes.hpp>

#include <numbers>
#include <tuple>

namespace fstiff { inline namespace v0_1 {

/// Approach of the nodes to t = 0 and excess = 0.
enum class NodeClustering {
    even,    ///< squares in both directions, for half-integer powers of the excess and of t
    graded,  ///< for any smooth f; a KinkedLaw is split at its kinks
    rough    ///< for kinks at unknown places: as graded, with an error sum for algebraic convergence
};

}}  // namespace fstiff

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Law with known kinks or jumps: at the excess critical(t), given the curvature t, or, with a member kinks() that
/// returns a std::array of ascending numbers, at critical(t) times each of these.
template <class F, class T>
concept KinkedLaw = requires(const F& f, T t) {
    { f.critical(t) } -> std::convertible_to<T>;
};

}}}  // namespace fstiff::detail

namespace fstiff { inline namespace v0_1 {

/// Tolerance and cost of the integrals in two dimensions.
template <Real T = double>
struct TensorOptions {
    T relative_tolerance = T(1e4) * std::numeric_limits<T>::epsilon();
    int max_nodes = 192;  ///< rows, and nodes of a piece of a row, at most 256
};

}}  // namespace fstiff

namespace fstiff { inline namespace v0_1 { namespace detail {

/// The kinks of a law as multiples of critical(t).
template <class T, class F>
auto kinks_of(const F& f) {
    if constexpr (!KinkedLaw<F, T>) {
        return std::array<T, 0>{};
    } else if constexpr (requires { f.kinks(); }) {
        const auto named = f.kinks();
        std::array<T, std::tuple_size_v<std::remove_const_t<decltype(named)>>> out;
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<T>(named[i]);
        return out;
    } else {
        return std::array<T, 1>{1};
    }
}

template <class F>
constexpr NodeClustering axis_of() {
    if constexpr (requires { F::axis; })
        return F::axis;
    else
        return NodeClustering::graded;
}

/// \p f at eight excess heights, given as a Map, whose copy by an expression does not dangle: by one call, or by eight
/// where f is a function of two numbers.
template <bool own, Real T, class F>
TensorLanes<T> values_of(const F& f, const TensorLanes<T>& excess, T t) {
    const Eigen::Map<const TensorLanes<T>> eight(excess.data());
    if constexpr (!own)
        return f(excess, t);
    else if constexpr (!requires { f(eight, t); })
        return excess.unaryExpr([&f, t](T approach) { return static_cast<T>(f(approach, t)); });
    else if constexpr (std::is_convertible_v<decltype(f(eight, t)), T>)  // a function of t alone
        return TensorLanes<T>::Constant(static_cast<T>(f(eight, t)));
    else
        return f(eight, t);
}

/// \p own: of a function of any sign and growth, whose moduli and values at the ends of the windows are summed too.
template <NodeClustering axis, Real T, class F, bool own = false>
class TensorRule {
public:
    static constexpr bool kinked = KinkedLaw<F, T>;
    static constexpr bool square = axis == NodeClustering::even && !kinked;
    static constexpr int falls = axis == NodeClustering::rough ? 0 : 4;
    static constexpr std::size_t kinks = std::tuple_size_v<decltype(kinks_of<T>(std::declval<const F&>()))>;
    /// Kinds of piece: i < kinks ends at kink i and begins at the one before or at 0; begun ends at a kink, but begins
    /// at the window; linear begins there too, and open at 0 or the last kink; neither ends.
    static constexpr std::size_t begun = kinks, linear = kinks + 1, open = kinks + 2, kinds = kinks + 3;
    static constexpr int row_falls = kinked ? falls / 4 : falls, open_falls = kinked ? falls / 2 : falls;

    /// The first guesses were fitted so that one pass mostly does: a second one repeats the first.
    TensorRule(const F& f, const PeakProblem<T>& problem, T log_accuracy)
        : f_(f),
          p_(problem),
          log_accuracy_(log_accuracy),
          turn_on_(p_.eta < T(1.5) ? p_.r / p_.c : T(0)),
          map_(kinked || (std::max)(p_.k, turn_on_) > 2 ? detail::gentle_map<T> : detail::plain_map<T>) {
        layer_ = std::sqrt(p_.k * p_.k + (1 + turn_on_ * turn_on_) / 2);
        const T first = p_.r * p_.eta - p_.reach * p_.c, last = detail::max_curvature(p_),
                below = (std::max)(T(0), -p_.eta);
        if constexpr (square) {
            begin_ = std::sqrt((std::max)(first, T(0)));
            end_ = std::sqrt(last);
            // the Gaussian in t, and see layer_error
            const T narrow = T(0.9) * (end_ - begin_) * std::sqrt(log_accuracy * p_.r * p_.floor) / p_.c;
            const T layer = (end_ - begin_) * std::sqrt(layer_) * std::pow(log_accuracy / T(3), T(0.75));
            rows_ = (std::max)({T(0.75) * log_accuracy + 4, narrow, layer});
        } else {
            begin_ = map_.begin(-(log_accuracy + 12));
            if (first > 0) begin_ = (std::max)(begin_, map_.at(first));
            end_ = map_.end(last);
            rows_ = (end_ - begin_) * (log_accuracy + (axis == NodeClustering::graded && !kinked ? 4 : 3)) /
                    map_.strip *
                    (kinked                          ? T(1.04) * (1 + below * (T(0.04) + T(0.093) * turn_on_))
                     : axis == NodeClustering::rough ? T(1)
                                                     : T(1.25));
        }
        asked_.fill(axis == NodeClustering::even ? T(0.8) * log_accuracy + 8 : T(1.2) * log_accuracy + T(7.3));
        asked_[0] += T(0.22) * log_accuracy * (std::min)(below / p_.c, T(5));
        asked_[begun] = log_accuracy / 2 + 8;
        asked_[linear] = asked_[open] = kinked   ? T(1.3) * log_accuracy + T(1.5)
                                        : square ? T(1.5) * log_accuracy + 8
                                                 : log_accuracy + 6;
    }

    /// The sum over the present rows and nodes, its error, and how many there were.
    Estimate<T> evaluate(int most) {
        const int rows = std::clamp(static_cast<int>(std::ceil(rows_)), 4, most);
        const T row_step = (end_ - begin_) / T(rows);
        if constexpr (square)
            t_.squares(begin_, row_step, rows);
        else
            t_.graded(map_, begin_, row_step, rows);
        place(most);
        TensorLanes<T> sums = TensorLanes<T>::Zero();
        TensorRows<T> eight;
        Estimate<T> out;
        std::array<T, 2> outermost{};
        moduli_ = cut_ = 0;
        for (int i = 0; i < rows; i += 8) {
            const auto block = static_cast<std::size_t>(i / 8);
            eight.t = t_.x[block];
            math::erf_of_eight(eight.t.data(), p_.k, eight.weight.data());
            eight.weight *= t_.weight[block];
            eight.prepare(p_, asked_[open]);
            for (int lane = 0; lane < (std::min)(8, rows - i); ++lane) {
                if (!(eight.last[lane] > 0)) continue;
                const T sum = row(eight, lane, out.evaluations);
                sums[lane] += sum;
                if (i + lane < 2) outermost[static_cast<std::size_t>(lane)] = std::abs(sum);
            }
        }
        T hidden = 0;
        if constexpr (!square)  // where the map begins; its double exponential falls faster than geometrically
            hidden =
                4 * outermost[0] * (std::min)(T(1), outermost[0] / (outermost[1] + (std::numeric_limits<T>::min)()));
        else if (p_.k * t_.x[0][0] > 1)  // by the layer of width 1/k at t = 0: no row falls into it
            hidden = outermost[0];
        out.value = sums.sum();
        rows_error_ = detail::trapezoidal_error<T>(sums, square && begin_ == 0, row_falls) + hidden +
                      (square ? layer_error(row_step) : t_.min_error) * sums.abs().sum();
        out.error = rows_error_;
        for (std::size_t i = 0; i < kinds; ++i)
            out.error += errors_[i] = tables_[i].error(square && i == open, open_falls);
        return out;
    }

    /// Asks for more rows or nodes where their error is above a share of \p allowed. \return whether there are any
    bool refine(T allowed, T sum, int most) {
        const T worst = (std::max)(rows_error_, *std::max_element(errors_.begin(), errors_.end()));
        bool more = false;
        const auto grow = [&](T& asked, T error, T limit) {
            if ((error <= T(0.25) * allowed && error < worst) || asked >= limit) return;
            const T reached = std::log(std::abs(sum) / error);  // log_accuracy grow with the nodes
            const T growth =
                reached > log_accuracy_ / 2 ? std::clamp((log_accuracy_ + T(1.5)) / reached, T(1.08), T(2)) : T(2);
            asked = (std::min)(limit, asked * growth);
            more = true;
        };
        grow(rows_, rows_error_, T(most));
        for (std::size_t i = 0; i < kinds; ++i)
            grow(asked_[i], errors_[i],
                 tables_[i].legendre ? T((std::min)(64, most))
                 : square            ? T(120)
                                     : 20 * log_accuracy_);
        return more;
    }

    [[nodiscard]] T moduli() const { return moduli_; }  ///< the sum of those of the terms; 0 unless own
    [[nodiscard]] T cut() const { return cut_; }        ///< about what lies beyond the windows; 0 unless own

private:
    /// Error of squares as rows for erf(k t) exp(-t^2/2) and, for eta near 0, of the row's turning on within c/r, with
    /// t = y^2, relative: together they grow by exp(4 layer^2 b^4) from the real axis to y + i b.
    [[nodiscard]] T layer_error(T step) const {
        if (begin_ > 0) return 0;
        const T narrow = layer_ * step * step;
        return 6 / (std::max)(T(1), layer_ * std::sqrt(layer_)) * std::exp(T(-3) / std::cbrt(narrow * narrow));
    }

    void place(int most) {
        const auto eights = [](T nodes, int limit) {
            return 8 * std::clamp(static_cast<int>(std::ceil(nodes / 8)), 1, limit / 8);
        };
        if constexpr (square) {
            tables_[open].squares(T(0), T(1), 96);  // as far as the smallest step that refine() allows needs
        } else {
            const T begin = detail::plain_map<T>.begin(-(log_accuracy_ + 12));
            const T range = detail::plain_map<T>.end((std::max)(2 * p_.reach, p_.log_cutoff / 2) + 1) - begin;
            const int count = eights(range * (asked_[open] + 3) / detail::plain_map<T>.strip,
                                     (std::min)(most * 4 / 3, TensorTable<T>::max_nodes));  // no row takes all of them
            tables_[open].graded(detail::plain_map<T>, begin, range / T(count), count);
        }
        const int count = eights(2 * p_.reach * (1 + std::sqrt(asked_[linear] / 2)) / std::numbers::pi_v<T>, most);
        tables_[linear].line(2 * p_.reach / T(count), count);
        if constexpr (kinked) {
            const auto kink = kinks_of<T>(f_);
            tables_[0].legendre_rule(eights(asked_[0], most), axis == NodeClustering::even ? 2 : 3, T(1));
            for (std::size_t i = 1; i < kinks; ++i)
                tables_[i].legendre_rule(eights(asked_[i], most), 1, kink[i] / kink[i - 1]);
            tables_[begun].legendre_rule(eights(asked_[begun], most), 1, T(1));
        }
    }

    /// int f exp(-(zeta - r t)^2/(2 c^2)) dzeta/c exp((floor^2 - t^2)/2) at one t, times its weight.
    T row(const TensorRows<T>& rows, int lane, int& evaluations) {
        const T t = rows.t[lane], first = rows.first[lane], last = rows.last[lane];
        const T outer = rows.outer[lane], shift = rows.shift[lane], slope = rows.linear[lane], inverse_c = 1 / p_.c;
        const auto kink = kinks_of<T>(f_);
        T critical = 0;
        if constexpr (kinked) critical = f_.critical(t);
        T from = first, sum = 0, end = 0;
        std::size_t next = 0;
        while (next < kinks && !(kink[next] * critical > from)) ++next;
        for (bool begun_at_first = first > 0;; ++next, begun_at_first = false) {
            T size = p_.c;
            std::size_t slot = open;
            const bool split = next < kinks && kink[next] * critical < last;
            if (split) {
                slot = begun_at_first ? begun : next;
                size = kink[next] * critical - from;
            } else if (begun_at_first) {
                slot = linear;
            } else if (square) {
                size *= rows.step[lane] * rows.step[lane];
            } else {
                const T start = rows.x[lane] + from * inverse_c;
                if (start > 0) size /= 1 + start / 2;  // it falls as exp(-start v)
            }
            TensorTable<T>& table = tables_[slot];
            const T weight = rows.weight[lane] * size * inverse_c;
            TensorLanes<T> total = TensorLanes<T>::Zero();
            for (std::size_t b = 0; b < table.blocks(); ++b) {
                const TensorLanes<T> excess = from + size * table.x[b];
                if (excess[0] > last) break;
                const TensorLanes<T> v = inverse_c * excess;
                const TensorLanes<T> term = weight * table.weight[b] *
                                            (outer - (v + shift).square() / 2 - slope * v).exp() *
                                            values_of<own>(f_, excess, t);
                table.sums[table.legendre ? b : 0] += term;
                total += term;
                evaluations += 8;
                if constexpr (own) {
                    moduli_ += term.abs().sum();
                    if (b == 0 && from > 0 && from == first) cut_ += 4 * std::abs(term[0]);
                    if (slot == open || slot == linear) end = 4 * std::abs(term[7]);
                }
            }
            if constexpr (own) cut_ += split ? 0 : end;
            sum += total.sum();
            if (!split) return sum;
            from = kink[next] * critical;
        }
    }

    const F& f_;
    const PeakProblem<T>& p_;
    T log_accuracy_, turn_on_;
    const GradedMap<T>& map_;  ///< of the rows
    T layer_;
    T begin_, end_;  ///< of the rows, in y
    T rows_, rows_error_ = 0, moduli_ = 0, cut_ = 0;
    std::array<T, kinds> asked_, errors_;  ///< log_accuracy or, for Legendre's rules, nodes
    TensorTable<T> t_;
    std::array<TensorTable<T>, kinds> tables_;
};

/// I[f] at the separation \p eta (in rms heights), without its factor exp(-eta^2/2) where eta > 0. \p f takes an Eigen
/// array of eight excess heights zeta - eta and one curvature t, and returns the array of values. A member
/// at_once(visit) is called before each pass over the nodes: visit() asks for f at all of them, in their order, and
/// takes any values. Does not allocate. \throws domain_error unless |eta| <= 1e6.
template <NodeClustering axis, bool own = false, Real T, class F>
[[nodiscard]] Estimate<T> scaled_tensor_integral(const F& f, const PeakDistribution<T>& peaks, T eta,
                                                 const TensorOptions<T>& options = {}, T margin = 9) {
    require(std::abs(eta) <= T(1e6), "eta", eta, "a number between -1e6 and 1e6");
    const T log_accuracy = -std::log(options.relative_tolerance);
    const PeakProblem<T> problem(peaks, eta, log_accuracy + margin);
    TensorRule<axis, T, F, own> rule(f, problem, log_accuracy);
    const int most = std::clamp(options.max_nodes / 8 * 8, 8, TensorTable<T>::max_nodes);
    const T rounding = std::numeric_limits<T>::epsilon() * (T(16) + problem.floor + std::abs(eta) / problem.c);
    const T factor = 1 / (2 * problem.theta);
    constexpr T safety = 2;  // factor on the errors that the sums show
    Estimate<T> out;
    for (;;) {
        if constexpr (requires { f.at_once([] {}); }) f.at_once([&] { rule.evaluate(most); });
        const Estimate<T> sum = rule.evaluate(most);
        out.value = factor * sum.value;
        out.error =
            safety * factor * sum.error + (rounding + T(0.05) * options.relative_tolerance) * std::abs(out.value);
        out.evaluations += sum.evaluations;
        if constexpr (own) {
            out.error += factor * (rounding * rule.moduli() + rule.cut());
            if (rule.cut() > T(0.1) * options.relative_tolerance * rule.moduli() && margin < 64) {
                Estimate<T> wider = scaled_tensor_integral<axis, own>(f, peaks, eta, options, 2 * margin);
                return wider.evaluations += out.evaluations, wider;
            }
        }
        if (out.error <= options.relative_tolerance * std::abs(out.value)) return out;
        if (!rule.refine(options.relative_tolerance * std::abs(sum.value) / safety, sum.value, most)) return out;
    }
}

}}}  // namespace fstiff::detail

namespace fstiff { inline namespace v0_1 {

/// Integral of a function of one's own over the peaks above the separation \p eta (in rms heights):
///
///     int_0^inf dt int_eta^inf dzeta f(zeta - eta, t) p_peak(zeta, t)
///
/// That is the mean of \p f over all peaks, to which those below eta add nothing: 1 gives the share of the peaks above
/// eta, (zeta - eta)^a t^b contact_integral(), and times D_p it is the sum per nominal area.
///
/// f takes the excess height zeta - eta > 0 (over the rms height) and the curvature t > 0 (over the rms curvature) of a
/// peak: numbers, or eight excess heights, as an Eigen::Map, and one curvature, which a generic function gets. It is
/// smooth but for powers at 0 and for the kinks or jumps that a member critical(t), with kinks(), names; a function
/// whose kinks are not known has a member axis = NodeClustering::rough. It grows at most as exp(4 (zeta - eta + t)),
/// and varies over 0.2 and more: the error may miss a part of what is narrower, or is 0 where most peaks are. The value
/// aims at options.relative_tolerance ({.relative_tolerance = 1e-6}; by default 1e4 epsilon); the error covers what is
/// reached. For large eta it falls to 0 as exp(-eta^2/2). Source and units: head of this file.
/// \throws domain_error unless |eta| <= 1e6 and the tolerance is between 50 epsilon and 0.1, and where f is not finite.
template <Real T, class F>
[[nodiscard]] Estimate<T> peak_integral(const F& f, const PeakDistribution<T>& peaks, std::type_identity_t<T> eta,
                                        const TensorOptions<T>& options = {}) {
    const T tolerance = options.relative_tolerance;
    detail::require(tolerance >= 50 * std::numeric_limits<T>::epsilon() && tolerance <= T(0.1), "relative_tolerance",
                    tolerance, "at least 50 epsilon of the scalar type and at most 0.1");
    const Estimate<T> scaled = detail::scaled_tensor_integral<detail::axis_of<F>(), true>(f, peaks, eta, options);
    detail::require(std::isfinite(scaled.error), "integral of f", scaled.value,
                    "finite: f must be finite for every peak");
    const T scale = math::gaussian((std::max)(eta, T(0)));
    return {scaled.value * scale, scaled.error * scale + std::numeric_limits<T>::denorm_min(), scaled.evaluations};
}

}}  // namespace fstiff
