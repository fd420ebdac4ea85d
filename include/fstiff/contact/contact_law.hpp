// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A contact compiled into a table: stiffness and pressure in nanoseconds, for codes that evaluate the law millions of times.
///
///     p(gap), K(gap), gap(p), K(p), dK/dp        gap: separation of the mean planes
///
/// log p is interpolated once as a function of the separation, by Chebyshev series through a few dozen exact integrals, in more
/// sections where they need it; from it tables of short polynomials are cut, one uniform in the gap and two in the binary
/// exponent of p (math/piecewise), so that an evaluation needs neither a logarithm nor an exponential nor a search, and an
/// array of them is evaluated four at a time where the processor can. K(gap) is the derivative of the very polynomial
/// that returns p(gap): with HertzLaw, FractalConsistentLaw and GreenwoodWilliamson it is exactly -dp/dgap of the returned p,
/// which is what Newton's method in an implicit solver needs; with FractalLaw it is that times (2/3)(3-D)/(2-D), and
/// tangent_is_exact() says no. Neighbouring polynomials meet at their ends; p falls and K rises monotonically (checked when
/// the law is compiled), up to the rounding of the last digits.
///
///     const auto law = fstiff::ContactLaw<double>::compile(contact, {.pressure_min = 1e5, .pressure_max = 1e8});
///     const double K = law.stiffness(3e6);
///     const auto [p, slope] = law.at_gap(1.2e-6);
///
/// Outside the range: OutsideRange::refuse throws, clamp holds the value at the end, exact evaluates the model. A NaN is refused
/// under each of them. gap(p) is always a gap that at_gap takes.
///
/// Units       SI: Pa, m, Pa/m; dK/dp in 1/m
/// Valid       float and double; 0 < pressure_min < pressure_max within the reach of the model; no interaction or
///             effective_separation
/// Accuracy    measured when it is compiled, at the ends of every piece and between the nodes, and carried: relative_error().
///             Of 200 laws of random surfaces none is further from the model than it says; one in two says less than 4e-12,
///             nine in ten less than 2e-10: interaction and ranges of a few percent take more.
///             A batch differs from the scalar calls by rounding: 200 epsilon at most (tests/contact/contact_law_test.cpp)
/// Threads     evaluation is const and does not allocate: any number of threads may share a law

#include <fstiff/contact/contact_concept.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/contact/quantity.hpp>
#include <fstiff/core/text.hpp>
#include <fstiff/math/chebyshev.hpp>
#include <fstiff/math/lanes.hpp>
#include <fstiff/math/piecewise.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace fstiff {

enum class OutsideRange {
    refuse,  ///< throw domain_error
    clamp,   ///< the value at the nearer end of the range
    exact    ///< evaluate the model itself: microseconds; not for a law read from text
};

template <Real T>
struct LawRange {
    T pressure_min{};  ///< [Pa]
    T pressure_max{};  ///< [Pa]
    OutsideRange outside = OutsideRange::refuse;
};

namespace detail {
template <Real T, class Contact>
class LawCompiler;
}

template <Real T>
requires(std::same_as<T, float> || std::same_as<T, double>) class ContactLaw {
public:
    struct Point {
        T pressure;   ///< [Pa]
        T stiffness;  ///< K [Pa/m]
    };

    /// Compiles \p contact, a RoughContact or GreenwoodWilliamson in the same scalar.
    /// \throws domain_error for a range that the model cannot reach or that is empty, and for interaction as_printed.
    template <ProportionalContact<T> Contact>
    [[nodiscard]] static ContactLaw compile(const Contact& contact, const LawRange<T>& range);

    /// K [Pa/m] at the pressure \p pressure [Pa]. \throws domain_error outside the range under OutsideRange::refuse.
    [[nodiscard]] T stiffness(T pressure) const {
        if (!stiffness_.contains(pressure)) [[unlikely]]
            return outside(pressure, &ContactLaw::stiffness, &Exact::stiffness);
        return stiffness_.value(pressure);
    }

    /// Separation of the mean planes [m] at the pressure \p pressure [Pa], within gaps(). \throws as stiffness.
    [[nodiscard]] T gap(T pressure) const {
        if (!gap_.contains(pressure)) [[unlikely]]
            return outside(pressure, &ContactLaw::gap, &Exact::gap);
        // at the ends of the range the last digits may differ from those of gaps()
        return within(gap_.value(pressure), by_gap_.begin, by_gap_.end);
    }

    /// dK/dp [1/m] at the pressure \p pressure [Pa]: the derivative of what stiffness() returns. \throws as stiffness; with
    /// OutsideRange::clamp 0 outside, with exact by a difference of the model.
    [[nodiscard]] T stiffness_slope(T pressure) const {
        if (!stiffness_.contains(pressure)) [[unlikely]] {
            if (outside_ == OutsideRange::clamp && !detail::is_nan(pressure)) return T(0);
            if (outside_ != OutsideRange::exact) refuse(pressure);
            const T step = std::cbrt(std::numeric_limits<T>::epsilon()) * pressure;
            return (exact_(pressure + step, true).stiffness - exact_(pressure - step, true).stiffness) / (2 * step);
        }
        return stiffness_.derivative(pressure);
    }

    /// p [Pa] and K [Pa/m] at the gap \p gap [m]. \throws as stiffness; gaps() is the range.
    [[nodiscard]] Point at_gap(T gap) const {
        if (!by_gap_.contains(gap)) [[unlikely]]
            return outside_gap(gap);
        const auto [pressure, derivative] = by_gap_(gap);
        return {pressure, derivative * slope_scale_};
    }
    [[nodiscard]] T pressure_at_gap(T gap) const { return at_gap(gap).pressure; }
    [[nodiscard]] T stiffness_at_gap(T gap) const { return at_gap(gap).stiffness; }

    /// stiffness() of a whole array of pressures, equal to it within rounding and relative_error(); \p out has the size of
    /// \p pressures and may be the same array. \throws as stiffness, at the first element that is to be refused.
    void stiffness(const Eigen::Ref<const Eigen::ArrayX<T>>& pressures, Eigen::Ref<Eigen::ArrayX<T>> out) const {
        require_same_size(pressures.size(), out.size());
        batch(
            stiffness_, pressures, std::array{out.data()},
            [](const auto& pieces, const T* p, const auto& to) { pieces.four_values(p, to[0]); },
            [this](T p) { return std::array{stiffness(p)}; });
    }

    /// at_gap() of a whole array of gaps, equal to it within rounding and relative_error(); the results have the size of
    /// \p gaps. \throws as stiffness, at the first element that is to be refused.
    void at_gap(const Eigen::Ref<const Eigen::ArrayX<T>>& gaps, Eigen::Ref<Eigen::ArrayX<T>> pressures,
                Eigen::Ref<Eigen::ArrayX<T>> stiffnesses) const {
        require_same_size(gaps.size(), pressures.size());
        require_same_size(gaps.size(), stiffnesses.size());
        batch(
            by_gap_, gaps, std::array{pressures.data(), stiffnesses.data()},
            [this](const auto& pieces, const T* gap, const auto& to) {
                pieces.four_values(gap, slope_scale_, to[0], to[1]);
            },
            [this](T gap) {
                const Point at = at_gap(gap);
                return std::array{at.pressure, at.stiffness};
            });
    }

    /// The largest relative error of p, K and (over the rms height) gap, measured when the law was compiled.
    [[nodiscard]] T relative_error() const { return relative_error_; }
    /// Whether K is exactly -dp/dgap of the returned p.
    [[nodiscard]] bool tangent_is_exact() const { return tangent_is_exact_; }
    [[nodiscard]] std::array<T, 2> pressures() const { return {pressure_min_, pressure_max_}; }
    [[nodiscard]] std::array<T, 2> gaps() const { return {by_gap_.begin, by_gap_.end}; }
    /// Exact integrals that were evaluated to compile the law.
    [[nodiscard]] int evaluations() const { return evaluations_; }

    /// The law as text, every number in hexadecimal so that from_text gives it back bit for bit.
    [[nodiscard]] std::string to_text() const;
    /// \throws domain_error for text that to_text did not write. OutsideRange::exact becomes refuse: the model is not there.
    [[nodiscard]] static ContactLaw from_text(std::string_view text);

    [[nodiscard]] bool operator==(const ContactLaw& other) const { return to_text() == other.to_text(); }

private:
    template <Real, class>
    friend class detail::LawCompiler;

    struct Exact {
        T gap, pressure, stiffness;
    };

    ContactLaw() = default;

    /// Never a NaN: that becomes \p low.
    [[nodiscard]] static T within(T x, T low, T high) noexcept { return x > low ? (x < high ? x : high) : low; }

    T outside(T pressure, T (ContactLaw::*at)(T) const, T Exact::*wanted) const {
        if (outside_ == OutsideRange::clamp && !detail::is_nan(pressure))
            return (this->*at)(within(pressure, pressure_min_, pressure_max_));
        if (outside_ == OutsideRange::exact) return exact_(pressure, true).*wanted;
        refuse(pressure);
    }
    Point outside_gap(T gap) const {
        if (outside_ == OutsideRange::clamp && !detail::is_nan(gap))
            return at_gap(within(gap, by_gap_.begin, by_gap_.end));
        if (outside_ == OutsideRange::exact) {
            const Exact e = exact_(gap, false);
            return {e.pressure, e.stiffness};
        }
        detail::refuse(
            "gap", gap,
            "between " + text_of(by_gap_.begin) + " and " + text_of(by_gap_.end) + " m, the range of the law");
    }
    [[noreturn]] void refuse(T pressure) const {
        detail::refuse(
            "pressure", pressure,
            "between " + text_of(pressure_min_) + " and " + text_of(pressure_max_) + " Pa, the range of the law");
    }

    /// Elements of \p x within \p pieces go through \p four, and four are filled up where fewer are left, so that a result
    /// does not depend on where its element stands; the others go through \p one.
    template <class Pieces, std::size_t N, class FourAt, class OneAt>
    static void batch(const Pieces& pieces, const Eigen::Ref<const Eigen::ArrayX<T>>& x, const std::array<T*, N>& out,
                      const FourAt& four, const OneAt& one) {
        const auto put = [&out](Eigen::Index i, const std::array<T, N>& value) {
            for (std::size_t n = 0; n < N; ++n) out[n][i] = value[n];
        };
        const Eigen::Index count = x.size();
        if constexpr (!detail::four_at_once<T>) {
            for (Eigen::Index i = 0; i < count; ++i) put(i, one(x[i]));
        } else {
            T given[4], found[N][4];
            for (Eigen::Index i = 0; i < count; i += 4) {
                const T* from = x.data() + i;
                std::array<T*, N> to = out;
                for (T*& at : to) at += i;
                const bool whole = count - i >= 4 && pieces.contains(from[0]) && pieces.contains(from[1]) &&
                                   pieces.contains(from[2]) && pieces.contains(from[3]);
                if (whole) [[likely]] {
                    four(pieces, from, to);
                    continue;
                }
                const Eigen::Index left = std::min<Eigen::Index>(count - i, 4);
                for (Eigen::Index k = 0; k < 4; ++k)
                    given[k] = k < left && pieces.contains(from[k]) ? from[k] : pieces.lowest();
                for (std::size_t n = 0; n < N; ++n) to[n] = found[n];
                four(pieces, given, to);
                for (Eigen::Index k = 0; k < left; ++k) {
                    if (!pieces.contains(from[k])) {
                        put(i + k, one(from[k]));
                        continue;
                    }
                    for (std::size_t n = 0; n < N; ++n) out[n][i + k] = found[n][k];
                }
            }
        }
    }

    static void require_same_size(Eigen::Index a, Eigen::Index b) {
        if (a != b)
            throw domain_error("batch: the arrays have " + std::to_string(a) + " and " + std::to_string(b) +
                               " elements: must have the same number");
    }
    static std::string text_of(T value) { return shortest_text(value); }

    T pressure_min_{}, pressure_max_{};
    T slope_scale_{};  ///< from d/ds to K
    T relative_error_{};
    bool tangent_is_exact_ = false;
    OutsideRange outside_ = OutsideRange::refuse;
    int evaluations_ = 0;
    detail::UniformPieces<T> by_gap_;          ///< p
    detail::BinaryPieces<T> stiffness_, gap_;  ///< by pressure
    std::function<Exact(T, bool)> exact_;      ///< at a pressure, or at a gap
};

namespace detail {

/// The work of ContactLaw::compile, in the order of its functions.
template <Real T, class Contact>
class LawCompiler {
public:
    LawCompiler(const Contact& contact, const LawRange<T>& range) : contact_(contact), range_(range) {
        law_.pressure_min_ = range.pressure_min;
        law_.pressure_max_ = range.pressure_max;
        law_.outside_ = range.outside;
        law_.tangent_is_exact_ = contact.stiffness_over_slope() == T(1);
        law_.stiffness_ = law_.gap_ = BinaryPieces<T>(range.pressure_min, range.pressure_max);
        law_.evaluations_ = 1;
    }

    [[nodiscard]] ContactLaw<T> compile() {
        interpolate_pressure();
        cut_by_gap();
        interpolate_eta();
        cut_by_pressure();
        measure_error();
        require_monotone();
        if (range_.outside == OutsideRange::exact)
            law_.exact_ = [contact = contact_](T x, bool is_pressure) {
                const auto state = is_pressure ? contact.at_pressure(x, Quantity::stiffness | Quantity::pressure)
                                               : contact.at_separation(x, Quantity::stiffness | Quantity::pressure);
                return
                    typename ContactLaw<T>::Exact{state.separation.value, state.pressure.value, state.stiffness.value};
            };
        return std::move(law_);
    }

private:
    static constexpr T epsilon = std::numeric_limits<T>::epsilon();
    static constexpr T pieces_per_e = sizeof(T) == 8 ? T(4) : T(1.5);  ///< a float's slope would be all rounding on 4

    using One = Lanes<T, 1>;
    using Nodes = Lanes<T, Row::terms>;  ///< those of a piece

    template <class V>
    struct State {
        V gap, pressure, minus_dp_dgap;
        V stretch;  ///< d gap/d eta over the rms height
    };
    /// With the bulk in series the gap is shorter and the slope smaller. \p slope is d log p/d eta.
    template <class V>
    [[nodiscard]] State<V> in_series(const V& eta, const V& p, const V& slope) const {
        const V k = p * slope * V::all(-1 / rms_), stretch = multiply_add(k, V::all(bulk_), V::all(1));
        return {eta * V::all(rms_) - p * V::all(bulk_), p, k / stretch, stretch};
    }
    template <class V>
    [[nodiscard]] State<V> at(const V& eta) const {
        return in_series(eta, V::all(middle_) * exp(log_pressure_(eta)), slope_(eta));
    }

    [[nodiscard]] Nodes nodes(T from, T to) const {
        const Nodes half = Nodes::all((to - from) / 2);
        return Nodes::all(from) + multiply_add(half, Nodes::load(lobatto_.node.data()), half);
    }

    [[nodiscard]] static auto* row(auto& pieces, Eigen::Index i) { return pieces.rows.data() + i * Row::terms; }

    /// log p, over the middle of its range to keep its digits, against the effective eta; from the separation of the highest
    /// pressure to that of the lowest, and beyond as far as the outer pieces by pressure reach.
    void interpolate_pressure() {
        const auto end = [this](T pressure) { return contact_.at_pressure(pressure, Quantity::pressure).eta; };
        closest_ = end(range_.pressure_max);
        furthest_ = end(range_.pressure_min);
        // log p is concave in eta: 10 % more than the slope says is enough; never so short that the slope would be all rounding
        const T beyond = T(0.13);  // log(9/8) and 10 %
        const T slack =
            std::max(-beyond / contact_.log_pressure(closest_).slope, T(0.1) * (1 - (furthest_ - closest_)));
        begin_ = closest_ - slack;
        end_ = furthest_ + slack;
        sections_ = static_cast<std::size_t>(std::ceil((end_ - begin_) / 3));
        const T section = (end_ - begin_) / T(sections_);
        points_ = static_cast<std::size_t>(sizeof(T) == 8 ? 11 + 4 * section : 6 + 2 * section);
        const auto sample = [this, log_middle = std::log(middle_)](T eta) {
            ++law_.evaluations_;
            const LogSlope<T> p = contact_.log_pressure(eta);
            error_ = std::max(error_, p.error);
            return p.log - log_middle;
        };
        log_pressure_ = {begin_, end_, sections_, points_, sample, error_};
        slope_ = log_pressure_.derivative();
    }

    /// Pieces over which log p changes by a quarter or so.
    void cut_by_gap() {
        const auto low = at(One::all(closest_)), high = at(One::all(furthest_));
        const T from = low.gap.p, length = high.gap.p - from;
        const T steepest = std::max(low.minus_dp_dgap.p / low.pressure.p, high.minus_dp_dgap.p / high.pressure.p);
        const auto pieces = static_cast<Eigen::Index>(std::ceil(pieces_per_e * steepest * length)) + 1;
        const T width = length / T(pieces);
        law_.by_gap_ = UniformPieces<T>(from, high.gap.p, pieces);
        law_.slope_scale_ = -2 / width * contact_.stiffness_over_slope();
        shortest_change_ = steepest * width;
        T last = closest_;
        for (Eigen::Index i = 0; i < pieces; ++i) {
            const State<Nodes> found = at(eta_of_gap(nodes(from + width * T(i), from + width * T(i + 1)), last));
            T* const c = row(law_.by_gap_, i);
            lobatto_.fit(found.pressure).store(c);
            // against the series the slope is worst at the ends of a piece
            std::array<T, Row::terms> tangent;
            (found.minus_dp_dgap * Nodes::all(-width / 2)).store(tangent.data());
            at_ends_ = std::max({at_ends_, std::abs(Row::derivative(c, T(-1)) / tangent.front() - 1),
                                 std::abs(Row::derivative(c, T(1)) / tangent.back() - 1)});
        }
    }

    /// eta rms - p bulk = gap, concave: Newton's method rises to the roots from \p last, which becomes the last of them.
    [[nodiscard]] Nodes eta_of_gap(const Nodes& gap, T& last) const {
        if (bulk_ == 0) return gap / Nodes::all(rms_);
        Nodes eta = Nodes::all(last);
        std::array<T, Row::terms> one;
        for (int iteration = 0; iteration < 50; ++iteration) {
            const State<Nodes> found = at(eta);
            const Nodes step = (gap - found.gap) / (found.stretch * Nodes::all(rms_));
            eta = min(max(eta + step, Nodes::all(begin_)), Nodes::all(end_));
            max(step, Nodes::all(0) - step).store(one.data());
            if (*std::max_element(one.begin(), one.end()) <= close_enough_) break;
        }
        eta.store(one.data());
        last = one.back();
        return eta;
    }

    /// eta against log p: the inverse of the series, by Newton's method from node to node, again by sections; its tail falls
    /// by a digit or more with every coefficient.
    void interpolate_eta() {
        T eta = closest_;
        const auto solve = [&](T log_p) {
            for (int iteration = 0; iteration < 50; ++iteration) {
                const T step = (log_p - log_pressure_(eta)) / slope_(eta);
                eta = ContactLaw<T>::within(eta + step, begin_, end_);
                if (std::abs(step) <= close_enough_) break;
            }
            return eta;
        };
        const auto log_of_edge = [&](Eigen::Index i) { return std::log(law_.stiffness_.edge(i) / middle_); };
        eta_of_ = {log_of_edge(0), log_of_edge(law_.stiffness_.rows.cols()), sections_, points_,
                   solve,          std::max(error_, 20000 * epsilon)};
    }

    void cut_by_pressure() {
        std::array<T, Row::terms> power{1};  // from s in [-1, 1] to that of the pieces
        for (std::size_t k = 1; k < power.size(); ++k) power[k] = power[k - 1] / BinaryPieces<T>::half;
        const Nodes scale = Nodes::load(power.data()), ratio = Nodes::all(contact_.stiffness_over_slope());
        for (Eigen::Index i = 0; i < law_.stiffness_.rows.cols(); ++i) {
            const Nodes p = nodes(law_.stiffness_.edge(i), law_.stiffness_.edge(i + 1));
            const Nodes eta = eta_of_(log(p / Nodes::all(middle_)));
            const State<Nodes> found = in_series(eta, p, slope_(eta));
            (lobatto_.fit(found.minus_dp_dgap * ratio) * scale).store(row(law_.stiffness_, i));
            (lobatto_.fit(found.gap) * scale).store(row(law_.gap_, i));
        }
    }

    /// The errors against the model, between the nodes of both tables.
    void measure_error() {
        const std::size_t checks = 8 + 4 * log_pressure_.size();
        T found = 0;
        const auto worst = [&found](T difference) { found = std::max(found, std::abs(difference)); };
        for (std::size_t i = 0; i < checks; ++i) {
            const T eta = closest_ + (furthest_ - closest_) * (T(i) + T(0.37)) / T(checks);
            const LogSlope<T> model = contact_.log_pressure(eta);
            const T p = std::clamp(std::exp(model.log), range_.pressure_min, range_.pressure_max);
            const auto truth = in_series(One::all(eta), One::all(p), One::all(model.slope));
            const T gap = truth.gap.p, k = truth.minus_dp_dgap.p * contact_.stiffness_over_slope();
            worst(law_.stiffness(p) / k - 1);
            worst((law_.gap(p) - gap) / rms_);
            const auto at = law_.at_gap(std::clamp(gap, law_.by_gap_.begin, law_.by_gap_.end));
            worst(at.pressure / p - 1);
            worst(at.stiffness / k - 1);
        }
        // the points found most of it; between others it may be somewhat more, and a slope over a short piece of a short range
        // carries the rounding of the few digits in which p changes there
        constexpr T rounding = T(4 * Row::terms * Row::terms) * epsilon;
        law_.relative_error_ =
            6 * found + T(1.5) * at_ends_ + rounding * std::max(T(1), 1 / (pieces_per_e * shortest_change_));
    }

    /// p and K move one way from node to node; closer than that the polynomials are smooth.
    void require_monotone() const {
        const auto moves = [](const auto& pieces, T half, T way) {
            for (Eigen::Index i = 0; i < pieces.rows.cols(); ++i)
                for (int k = -8; k <= 8; ++k)
                    if (!(way * Row::derivative(row(pieces, i), half * T(k) / 8) > 0)) return false;
            return true;
        };
        if (!(moves(law_.stiffness_, BinaryPieces<T>::half, T(1)) && moves(law_.by_gap_, T(1), T(-1))))
            throw domain_error("pressure range: the compiled law would not be monotone; must be one where K and p are");
    }

    const Contact& contact_;
    const LawRange<T>& range_;
    const LobattoPiece<T, Row::terms>& lobatto_ = LobattoPiece<T, Row::terms>::get();
    const T rms_ = contact_.rms_height(), bulk_ = contact_.bulk_compliance();
    const T middle_ = std::sqrt(range_.pressure_min) * std::sqrt(range_.pressure_max);  ///< of the pressures
    const T close_enough_ = std::sqrt(epsilon) / 4;  ///< of Newton's method: the next step would be about step^2
    ContactLaw<T> law_;
    ChebyshevSections<T> log_pressure_;  ///< log(p/middle) against eta
    ChebyshevSections<T> slope_;         ///< its derivative
    ChebyshevSections<T> eta_of_;        ///< its inverse
    std::size_t sections_{}, points_{};  ///< of each
    T closest_{}, furthest_{};           ///< eta at the ends of the range
    T begin_{}, end_{};                  ///< and of the series
    T error_{};                          ///< of the integrals
    T at_ends_{};                        ///< of the slope, at the ends of the pieces by gap
    T shortest_change_{};                ///< of log p over a piece by gap
};

}  // namespace detail

template <Real T>
requires(std::same_as<T, float> || std::same_as<T, double>) template <ProportionalContact<T> Contact>
ContactLaw<T> ContactLaw<T>::compile(const Contact& contact, const LawRange<T>& range) {
    require(range.pressure_min >= std::numeric_limits<T>::min(), "pressure_min", range.pressure_min,
            "finite and greater than 0, and no denormal number");
    require(range.pressure_max > range.pressure_min && std::isfinite(range.pressure_max), "pressure_max",
            range.pressure_max, "finite and greater than pressure_min");
    require(contact.interaction().reading != InteractionReading::as_printed, "interaction", T(2),
            "none or effective_separation for a compiled law (as_printed is no function of one gap)");
    return detail::LawCompiler<T, Contact>(contact, range).compile();
}

template <Real T>
requires(std::same_as<T, float> || std::same_as<T, double>) std::string ContactLaw<T>::to_text()
const {
    std::string text = "fstiff contact law 2 " + std::to_string(sizeof(T)) + '\n';
    text += std::to_string(by_gap_.rows.cols()) + ' ' + std::to_string(static_cast<int>(tangent_is_exact_)) + ' ' +
            std::to_string(static_cast<int>(outside_)) + ' ' + std::to_string(evaluations_) + '\n';
    const auto add = [&text](const T* numbers, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) text += hexadecimal_text(numbers[i]) + (i + 1 < count ? ' ' : '\n');
    };
    const T head[] = {pressure_min_, pressure_max_, by_gap_.begin, by_gap_.end, slope_scale_, relative_error_};
    add(head, std::size(head));
    for (const auto* rows : {&by_gap_.rows, &stiffness_.rows, &gap_.rows})
        for (Eigen::Index i = 0; i < rows->cols(); ++i) add(rows->col(i).data(), detail::Row::terms);
    return text;
}

template <Real T>
requires(std::same_as<T, float> ||
         std::same_as<T, double>) ContactLaw<T> ContactLaw<T>::from_text(std::string_view text) {
    const std::string head = "fstiff contact law 2 " + std::to_string(sizeof(T)) + '\n';
    const auto wrong = [](const char* what) {
        return domain_error(std::string("contact law text: ") + what +
                            ": must be what to_text wrote for this scalar type");
    };
    if (!text.starts_with(head)) throw wrong("begins with something else");
    const char* at = text.data() + head.size();
    const char* const end = text.data() + text.size();
    const auto skip = [&] {
        while (at != end && (*at == ' ' || *at == '\n' || *at == '\r')) ++at;
    };
    const auto number = [&](auto value) {
        skip();
        std::from_chars_result read{};
        if constexpr (std::is_floating_point_v<decltype(value)>)
            read = read_hexadecimal(at, end, value);
        else
            read = std::from_chars(at, end, value);
        const auto [next, error] = read;
        if (error != std::errc{}) throw wrong("ends early or holds no number");
        if constexpr (std::is_floating_point_v<decltype(value)>)
            if (!std::isfinite(value)) throw wrong("holds a number that is not finite");
        at = next;
        return value;
    };
    ContactLaw law;
    const auto gap_pieces = number(Eigen::Index{});
    law.tangent_is_exact_ = number(int{}) != 0;
    const int outside = number(int{});
    if (outside < 0 || outside > 2) throw wrong("holds an unknown policy");
    law.outside_ = outside == static_cast<int>(OutsideRange::clamp) ? OutsideRange::clamp : OutsideRange::refuse;
    law.evaluations_ = number(int{});
    T gap_min{}, gap_max{};
    for (T* x : {&law.pressure_min_, &law.pressure_max_, &gap_min, &gap_max, &law.slope_scale_, &law.relative_error_})
        *x = number(T{});
    if (!(law.pressure_min_ >= std::numeric_limits<T>::min() && law.pressure_max_ > law.pressure_min_ &&
          gap_max > gap_min))
        throw wrong("contradicts itself");
    // each number takes two characters or more: a size that the text cannot hold is refused before it is allocated
    const auto size = static_cast<Eigen::Index>(text.size());
    const Eigen::Index pressure_pieces = detail::BinaryPieces<T>::pieces(law.pressure_min_, law.pressure_max_);
    if (gap_pieces < 1 || gap_pieces > size || pressure_pieces > size) throw wrong("holds impossible sizes");
    law.by_gap_ = detail::UniformPieces<T>(gap_min, gap_max, gap_pieces);
    if (!(law.by_gap_.pieces_per_length > 0 && std::isfinite(law.by_gap_.pieces_per_length)))
        throw wrong("contradicts itself");
    law.stiffness_ = law.gap_ = detail::BinaryPieces<T>(law.pressure_min_, law.pressure_max_);
    for (auto* rows : {&law.by_gap_.rows, &law.stiffness_.rows, &law.gap_.rows})
        for (T& coefficient : rows->reshaped()) coefficient = number(T{});
    skip();
    if (at != end) throw wrong("goes on after its end");
    return law;
}

}  // namespace fstiff
