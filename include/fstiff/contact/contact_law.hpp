// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A contact compiled into a table: stiffness and pressure in nanoseconds, for codes that evaluate the law millions of times.
///
///     p(gap), K(gap), -dp/dgap, gap(p), K(p), dK/dp        gap: separation of the mean planes
///
/// log p is interpolated once as a function of the separation, by Chebyshev series through a few dozen exact integrals, in more
/// sections where they need it; from it tables of short polynomials are cut, one uniform in the gap and two in the binary
/// exponent of p (math/piecewise), so that an evaluation needs neither a logarithm nor an exponential nor a search, and an
/// array of them is evaluated four at a time where the processor can. The slope -dp/dgap is the derivative of the very
/// polynomial that returns p(gap), for every law: it is the tangent that Newton's method in an implicit solver needs. K is that
/// slope with HertzLaw, FractalConsistentLaw and GreenwoodWilliamson; with FractalLaw it is the slope times (2/3)(3-D)/(2-D),
/// and tangent_is_exact() says no. Neighbouring polynomials meet at their ends; p falls and K rises monotonically (checked when
/// the law is compiled), up to the rounding of the last digits.
///
///     const auto law = fstiff::ContactLaw<double>::compile(contact, {.pressure_min = 1e5, .pressure_max = 1e8});
///     const double K = law.stiffness(3e6);
///     const auto [p, stiffness] = law.at_gap(1.2e-6);
///     const auto [same_p, slope] = law.tangent_at_gap(1.2e-6);
///
/// Outside the range, as OutsideRange says:
///
///     refuse       throws
///     extrapolate  gap > gap_max: log p and log K go on linearly in the gap, to p = K = 0 for an open contact;
///                  gap < gap_min: K goes on linearly in the gap, and p as its integral:
///                      p = p_e exp(-(gap - gap_max) s_e/p_e)                        K = K_e p/p_e                 light
///                      p = p_e + s_e x + s_e' x^2/2,  s = s_e + s_e' x,  x = gap_min - gap,  K/K_e = s/s_e        heavy
///                  with p, the slope s and K of the ends (e). p is once continuously differentiable in the gap and the
///                  slope exactly its derivative: a Newton loop sees one smooth law. The same by pressure, from p = 0 on,
///                  where K = 0 and the gap is infinite
///     clamp        p, K and gap are those of the nearer end, for looking up; since p is constant there, -dp/dgap and dK/dp
///                  are 0, K is not the tangent, and Newton's method stalls
///     exact        evaluates the model, in microseconds; it takes p > 0
///
/// A NaN is refused under each of them. gap(p) of a pressure in the range is always a gap that at_gap takes.
///
/// Units       SI: Pa, m, Pa/m; dK/dp in 1/m
/// Valid       float and double; 0 < pressure_min < pressure_max within the reach of the model; no interaction or
///             effective_separation. A default-constructed law is empty and refuses every evaluation
/// Accuracy    measured when it is compiled, at the ends of every piece and between the nodes, and carried: relative_error().
///             Of 400 laws of random surfaces none is further from the model than it says. One in two says less than 4e-12
///             and is right to 1e-12, nine in ten say less than 3e-10 and are right to 5e-11, all say less than 1e-7 and are
///             right to 1e-8: interaction, pressures that press the planes through one another and ranges of a few percent
///             take more.
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
    refuse,      ///< throw domain_error
    clamp,       ///< the values at the nearer end of the range; with derivatives 0
    exact,       ///< evaluate the model itself: microseconds; not for a law that goes to text
    extrapolate  ///< continue the law smoothly: an opening contact ends with p = K = 0
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
    struct AtGap {
        T pressure;   ///< [Pa]
        T stiffness;  ///< K [Pa/m]
    };
    struct Tangent {
        T pressure;  ///< [Pa]
        T slope;     ///< -dp/dgap [Pa/m] of the returned p
    };
    struct AtPressure {
        T gap;              ///< [m]
        T stiffness;        ///< K [Pa/m]
        T stiffness_slope;  ///< dK/dp [1/m] of the returned K
    };

    /// Empty: refuses every evaluation, until a law is assigned to it.
    ContactLaw() = default;

    /// Compiles \p contact, a RoughContact or GreenwoodWilliamson in the same scalar.
    /// \throws domain_error for a range that the model cannot reach or that is empty, and for interaction as_printed.
    template <ProportionalContact<T> Contact>
    [[nodiscard]] static ContactLaw compile(const Contact& contact, const LawRange<T>& range);

    /// K [Pa/m] at the pressure \p pressure [Pa]. \throws domain_error outside the range under OutsideRange::refuse, for a
    /// negative or infinite pressure under extrapolate, for NaN, and of an empty law.
    [[nodiscard]] T stiffness(T pressure) const {
        if (!stiffness_.contains(pressure)) [[unlikely]]
            return outside_pressure(pressure, false).stiffness;
        return stiffness_.value(pressure);
    }

    /// Separation of the mean planes [m] at the pressure \p pressure [Pa], within gaps() for one in the range.
    /// \throws as stiffness.
    [[nodiscard]] T gap(T pressure) const {
        if (!gap_.contains(pressure)) [[unlikely]]
            return outside_pressure(pressure, false).gap;
        // at the ends of the range the last digits may differ from those of gaps()
        return within(gap_.value(pressure), by_gap_.begin, by_gap_.end);
    }

    /// dK/dp [1/m] at the pressure \p pressure [Pa]: the derivative of what stiffness() returns; outside the range with
    /// OutsideRange::exact by a difference of the model. \throws as stiffness.
    [[nodiscard]] T stiffness_slope(T pressure) const {
        if (!stiffness_.contains(pressure)) [[unlikely]]
            return outside_pressure(pressure, true).stiffness_slope;
        return stiffness_.derivative(pressure);
    }

    /// gap(), stiffness() and stiffness_slope() at once. \throws as stiffness.
    [[nodiscard]] AtPressure at_pressure(T pressure) const {
        if (!stiffness_.contains(pressure)) [[unlikely]]
            return outside_pressure(pressure, true);
        return {gap(pressure), stiffness_.value(pressure), stiffness_.derivative(pressure)};
    }

    /// p [Pa] and K [Pa/m] at the gap \p gap [m]. \throws domain_error outside gaps() under OutsideRange::refuse, for
    /// -infinity under extrapolate, for NaN, and of an empty law.
    [[nodiscard]] AtGap at_gap(T gap) const {
        if (!by_gap_.contains(gap)) [[unlikely]] {
            const Whole at = outside_gap(gap);
            return {at.pressure, at.stiffness};
        }
        const auto [pressure, derivative] = by_gap_(gap);
        return {pressure, derivative * stiffness_scale_};
    }
    /// p [Pa] and -dp/dgap [Pa/m], which is K only where tangent_is_exact(). \throws as at_gap.
    [[nodiscard]] Tangent tangent_at_gap(T gap) const {
        if (!by_gap_.contains(gap)) [[unlikely]] {
            const Whole at = outside_gap(gap);
            return {at.pressure, at.slope};
        }
        const auto [pressure, derivative] = by_gap_(gap);
        return {pressure, derivative * slope_scale_};
    }
    [[nodiscard]] T pressure_at_gap(T gap) const { return at_gap(gap).pressure; }
    [[nodiscard]] T stiffness_at_gap(T gap) const { return at_gap(gap).stiffness; }
    [[nodiscard]] T slope_at_gap(T gap) const { return tangent_at_gap(gap).slope; }

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
    /// \p gaps. \throws as at_gap, at the first element that is to be refused.
    void at_gap(const Eigen::Ref<const Eigen::ArrayX<T>>& gaps, Eigen::Ref<Eigen::ArrayX<T>> pressures,
                Eigen::Ref<Eigen::ArrayX<T>> stiffnesses) const {
        at_gap(gaps, pressures, stiffnesses, stiffness_scale_, &Whole::stiffness);
    }
    /// The same of tangent_at_gap().
    void tangent_at_gap(const Eigen::Ref<const Eigen::ArrayX<T>>& gaps, Eigen::Ref<Eigen::ArrayX<T>> pressures,
                        Eigen::Ref<Eigen::ArrayX<T>> slopes) const {
        at_gap(gaps, pressures, slopes, slope_scale_, &Whole::slope);
    }

    /// The largest relative error of p, K and (over the rms height) gap, measured when the law was compiled.
    [[nodiscard]] T relative_error() const { return relative_error_; }
    /// Whether K is exactly -dp/dgap of the returned p, where that is not constant (OutsideRange::clamp).
    [[nodiscard]] bool tangent_is_exact() const { return stiffness_over_slope_ == T(1); }
    [[nodiscard]] std::array<T, 2> pressures() const { return {pressure_min_, pressure_max_}; }  ///< of an empty law 0
    [[nodiscard]] std::array<T, 2> gaps() const { return {by_gap_.begin, by_gap_.end}; }  ///< of an empty law NaN
    [[nodiscard]] OutsideRange outside() const { return outside_; }
    [[nodiscard]] bool empty() const { return by_gap_.rows.cols() == 0; }
    /// Exact integrals that were evaluated to compile the law.
    [[nodiscard]] int evaluations() const { return evaluations_; }

    /// The same law with another policy. \throws domain_error for exact unless the law has it: the model is not there.
    [[nodiscard]] ContactLaw with(OutsideRange outside) const;

    /// The law as text, every number in hexadecimal so that from_text gives it back bit for bit.
    /// \throws domain_error of an empty law, and of one with OutsideRange::exact, whose model no text holds: write
    /// with(another policy).
    [[nodiscard]] std::string to_text() const;
    /// Lines may end in LF or CRLF. \throws domain_error for text that to_text did not write.
    [[nodiscard]] static ContactLaw from_text(std::string_view text);

    /// Whether all tables and the policy are the same; of two laws with OutsideRange::exact the models are not compared.
    [[nodiscard]] bool operator==(const ContactLaw& other) const;

private:
    template <Real, class>
    friend class detail::LawCompiler;

    struct Exact {
        T gap, pressure, stiffness;
    };
    struct Whole {
        T pressure, stiffness, slope;
    };

    /// Never a NaN: that becomes \p low.
    [[nodiscard]] static T within(T x, T low, T high) noexcept { return x > low ? (x < high ? x : high) : low; }

    /// The one place where -dp/dgap follows from K.
    [[nodiscard]] T slope_of(T stiffness) const noexcept { return stiffness / stiffness_over_slope_; }

    void set_scales() {
        slope_scale_ = -2 * by_gap_.pieces_per_length;
        stiffness_scale_ = slope_scale_ * stiffness_over_slope_;
    }

    AtPressure outside_pressure(T pressure, bool with_slope) const;
    Whole outside_gap(T gap) const;
    AtPressure continued_pressure(T pressure) const;
    Whole continued_gap(T gap) const;
    Whole inside_gap(T gap) const {
        const auto [pressure, derivative] = by_gap_(gap);
        return {pressure, derivative * stiffness_scale_, derivative * slope_scale_};
    }
    void require_filled() const {
        if (empty()) throw domain_error("contact law: is empty; must be compiled or read from text to be evaluated");
    }
    /// Value and bounds with the digits that tell them apart.
    [[noreturn]] static void refuse(std::string_view name, T value, T low, T high, const char* unit) {
        detail::refuse(
            name, shortest_text(value),
            "between " + shortest_text(low) + " and " + shortest_text(high) + unit + ", the range of the law");
    }

    void at_gap(const Eigen::Ref<const Eigen::ArrayX<T>>& gaps, Eigen::Ref<Eigen::ArrayX<T>>& pressures,
                Eigen::Ref<Eigen::ArrayX<T>>& slopes, T scale, T Whole::*wanted) const {
        require_same_size(gaps.size(), pressures.size());
        require_same_size(gaps.size(), slopes.size());
        batch(
            by_gap_, gaps, std::array{pressures.data(), slopes.data()},
            [scale](const auto& pieces, const T* gap, const auto& to) { pieces.four_values(gap, scale, to[0], to[1]); },
            [this, wanted](T gap) {
                const Whole at = by_gap_.contains(gap) ? inside_gap(gap) : outside_gap(gap);
                return std::array{at.pressure, at.*wanted};
            });
    }

    /// Elements of \p x within \p pieces go through \p four, and four are filled up where fewer are left, so that a result
    /// does not depend on where its element stands; the others go through \p one.
    template <class Pieces, std::size_t N, class FourAt, class OneAt>
    void batch(const Pieces& pieces, const Eigen::Ref<const Eigen::ArrayX<T>>& x, const std::array<T*, N>& out,
               const FourAt& four, const OneAt& one) const {
        require_filled();
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

    T pressure_min_{}, pressure_max_{};
    T slope_scale_{}, stiffness_scale_{};  ///< from dp/ds to -dp/dgap and to K
    T stiffness_over_slope_ = T(1);
    T relative_error_{};
    OutsideRange outside_ = OutsideRange::refuse;
    int evaluations_ = 0;
    detail::UniformPieces<T> by_gap_;          ///< p
    detail::BinaryPieces<T> stiffness_, gap_;  ///< by pressure
    std::function<Exact(T, bool)> exact_;      ///< at a pressure, or at a gap
};

template <Real T>
requires(std::same_as<T, float> || std::same_as<T, double>) auto ContactLaw<T>::outside_pressure(T pressure,
                                                                                                 bool with_slope) const
    -> AtPressure {
    require_filled();
    if (!detail::is_nan(pressure)) {
        if (outside_ == OutsideRange::extrapolate) return continued_pressure(pressure);
        if (outside_ == OutsideRange::clamp) {
            const AtPressure end = at_pressure(within(pressure, pressure_min_, pressure_max_));
            return {end.gap, end.stiffness, T(0)};
        }
    }
    if (outside_ != OutsideRange::exact) refuse("pressure", pressure, pressure_min_, pressure_max_, " Pa");
    const Exact at = exact_(pressure, true);
    if (!with_slope) return {at.gap, at.stiffness, T(0)};
    const T step = std::cbrt(std::numeric_limits<T>::epsilon()) * pressure;
    return {at.gap, at.stiffness,
            (exact_(pressure + step, true).stiffness - exact_(pressure - step, true).stiffness) / (2 * step)};
}

template <Real T>
requires(std::same_as<T, float> || std::same_as<T, double>) auto ContactLaw<T>::outside_gap(T gap) const -> Whole {
    require_filled();
    if (!detail::is_nan(gap)) {
        if (outside_ == OutsideRange::extrapolate) return continued_gap(gap);
        if (outside_ == OutsideRange::clamp) {
            const Whole end = inside_gap(within(gap, by_gap_.begin, by_gap_.end));
            return {end.pressure, end.stiffness, T(0)};
        }
    }
    if (outside_ != OutsideRange::exact) refuse("gap", gap, by_gap_.begin, by_gap_.end, " m");
    const Exact at = exact_(gap, false);
    return {at.pressure, at.stiffness, slope_of(at.stiffness)};
}

/// K/p is constant below the range, K dK/dp above it. Each continues its own table, from the value at the very end.
template <Real T>
requires(std::same_as<T, float> || std::same_as<T, double>) auto ContactLaw<T>::continued_pressure(T pressure) const
    -> AtPressure {
    require(pressure >= 0 && pressure <= std::numeric_limits<T>::max(), "pressure", pressure,
            "finite and at least 0 Pa: the contact does not pull");
    if (pressure < pressure_min_) {
        const AtPressure end = at_pressure(pressure_min_);
        const T rate = end.stiffness / pressure_min_;
        return {end.gap + std::log(pressure_min_ / pressure) / slope_of(rate), rate * pressure, rate};
    }
    const AtPressure end = at_pressure(pressure_max_);
    const T more = pressure - pressure_max_;
    const T growth = std::sqrt(1 + 2 * (end.stiffness_slope / end.stiffness) * more);
    const T stiffness = end.stiffness * growth;
    return {end.gap - 2 * more / slope_of(end.stiffness + stiffness), stiffness, end.stiffness_slope / growth};
}

template <Real T>
requires(std::same_as<T, float> || std::same_as<T, double>) auto ContactLaw<T>::continued_gap(T gap) const -> Whole {
    if (gap > by_gap_.end) {
        const Whole end = inside_gap(by_gap_.end);
        const T share = std::exp(-(gap - by_gap_.end) * (end.slope / end.pressure));
        return {end.pressure * share, end.stiffness * share, end.slope * share};
    }
    require(gap >= std::numeric_limits<T>::lowest(), "gap", gap, "greater than -infinity (m)");
    const Whole end = inside_gap(by_gap_.begin);
    const T less = by_gap_.begin - gap, bend = stiffness_.derivative(pressure_max_) * end.slope;  // dK/d less
    const T more_slope = slope_of(bend * less);
    return {end.pressure + less * (end.slope + more_slope / 2), end.stiffness + bend * less, end.slope + more_slope};
}

template <Real T>
requires(std::same_as<T, float> || std::same_as<T, double>) ContactLaw<T> ContactLaw<T>::with(OutsideRange outside)
const {
    if (outside == OutsideRange::exact && !exact_)
        throw domain_error("outside = exact: must be asked for when the law is compiled; its model is not kept else");
    ContactLaw other = *this;
    other.outside_ = outside;
    if (outside != OutsideRange::exact) other.exact_ = nullptr;
    return other;
}

template <Real T>
requires(std::same_as<T, float> ||
         std::same_as<T, double>) bool ContactLaw<T>::operator==(const ContactLaw& other) const {
    if (empty() || other.empty()) return empty() && other.empty();
    const auto same = [](const auto& a, const auto& b) { return a.cols() == b.cols() && (a == b).all(); };
    return pressures() == other.pressures() && gaps() == other.gaps() &&
           stiffness_over_slope_ == other.stiffness_over_slope_ && relative_error_ == other.relative_error_ &&
           outside_ == other.outside_ && evaluations_ == other.evaluations_ && same(by_gap_.rows, other.by_gap_.rows) &&
           same(stiffness_.rows, other.stiffness_.rows) && same(gap_.rows, other.gap_.rows);
}

namespace detail {

/// The work of ContactLaw::compile, in the order of its functions.
template <Real T, class Contact>
class LawCompiler {
public:
    LawCompiler(const Contact& contact, const LawRange<T>& range) : contact_(contact), range_(range) {
        law_.pressure_min_ = range.pressure_min;
        law_.pressure_max_ = range.pressure_max;
        law_.outside_ = range.outside;
        law_.stiffness_over_slope_ = contact.stiffness_over_slope();
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

    /// K of -dp/dgap: the one place where the compiler takes it so.
    template <class V>
    [[nodiscard]] V stiffness_of(const V& minus_dp_dgap) const {
        return minus_dp_dgap * V::all(law_.stiffness_over_slope_);
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
        law_.set_scales();
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
        const Nodes scale = Nodes::load(power.data());
        for (Eigen::Index i = 0; i < law_.stiffness_.rows.cols(); ++i) {
            const Nodes p = nodes(law_.stiffness_.edge(i), law_.stiffness_.edge(i + 1));
            const Nodes eta = eta_of_(log(p / Nodes::all(middle_)));
            const State<Nodes> found = in_series(eta, p, slope_(eta));
            (lobatto_.fit(stiffness_of(found.minus_dp_dgap)) * scale).store(row(law_.stiffness_, i));
            (lobatto_.fit(found.gap) * scale).store(row(law_.gap_, i));
        }
    }

    /// The errors against the model, between the nodes of both tables.
    void measure_error() {
        const std::size_t checks = 8 + 4 * log_pressure_.size();
        T found = slope_.relative_jump();
        const auto worst = [&found](T difference) { found = std::max(found, std::abs(difference)); };
        for (std::size_t i = 0; i < checks; ++i) {
            const T eta = closest_ + (furthest_ - closest_) * (T(i) + T(0.37)) / T(checks);
            const LogSlope<T> model = contact_.log_pressure(eta);
            const T p = std::clamp(std::exp(model.log), range_.pressure_min, range_.pressure_max);
            const auto truth = in_series(One::all(eta), One::all(p), One::all(model.slope));
            const T gap = truth.gap.p, k = stiffness_of(truth.minus_dp_dgap).p;
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
    require_filled();
    if (outside_ == OutsideRange::exact)
        throw domain_error("outside = exact: must be another policy for a law that goes to text, which holds no model");
    std::string text = "fstiff contact law 3 " + std::to_string(sizeof(T)) + '\n';
    text += std::to_string(by_gap_.rows.cols()) + ' ' + std::to_string(static_cast<int>(outside_)) + ' ' +
            std::to_string(evaluations_) + '\n';
    const auto add = [&text](const T* numbers, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) text += hexadecimal_text(numbers[i]) + (i + 1 < count ? ' ' : '\n');
    };
    const T head[] = {pressure_min_, pressure_max_, by_gap_.begin, by_gap_.end, stiffness_over_slope_, relative_error_};
    add(head, std::size(head));
    for (const auto* rows : {&by_gap_.rows, &stiffness_.rows, &gap_.rows})
        for (Eigen::Index i = 0; i < rows->cols(); ++i) add(rows->col(i).data(), detail::Row::terms);
    return text;
}

template <Real T>
requires(std::same_as<T, float> ||
         std::same_as<T, double>) ContactLaw<T> ContactLaw<T>::from_text(std::string_view text) {
    const std::string head = "fstiff contact law 3 " + std::to_string(sizeof(T));
    const auto wrong = [](const char* what) {
        return domain_error(std::string("contact law text: ") + what +
                            ": must be what to_text wrote for this scalar type");
    };
    if (const auto line = text.substr(0, text.find('\n')); line != head && line != head + '\r')
        throw wrong("begins with something else");
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
    law.outside_ = static_cast<OutsideRange>(number(int{}));
    if (law.outside_ != OutsideRange::refuse && law.outside_ != OutsideRange::clamp &&
        law.outside_ != OutsideRange::extrapolate)
        throw wrong("holds an unknown policy");
    law.evaluations_ = number(int{});
    T gap_min{}, gap_max{};
    for (T* x :
         {&law.pressure_min_, &law.pressure_max_, &gap_min, &gap_max, &law.stiffness_over_slope_, &law.relative_error_})
        *x = number(T{});
    if (!(law.pressure_min_ >= std::numeric_limits<T>::min() && law.pressure_max_ > law.pressure_min_ &&
          gap_max > gap_min && law.stiffness_over_slope_ > 0))
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
    law.set_scales();
    return law;
}

}  // namespace fstiff
