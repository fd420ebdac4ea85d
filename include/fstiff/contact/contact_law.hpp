// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A contact compiled into a table: stiffness and pressure in nanoseconds, for codes that evaluate the law millions of times.
///
///     p(gap), K(gap), gap(p), K(p), dK/dp        gap: separation of the mean planes
///
/// log p is interpolated once as a function of the separation, by a Chebyshev series through a few dozen exact integrals; from
/// it two tables of short polynomials are cut, one uniform in the gap and one in the binary exponent of p, so that an
/// evaluation needs neither a logarithm nor an exponential nor a search. K(gap) is the derivative of the very polynomial
/// that returns p(gap): with HertzLaw, FractalConsistentLaw and GreenwoodWilliamson it is exactly -dp/dgap of the returned p,
/// which is what Newton's method in an implicit solver needs; with FractalLaw it is that times (2/3)(3-D)/(2-D), and
/// tangent_is_exact() says no. Neighbouring polynomials meet at their ends; p falls and K rises monotonically (checked when
/// the law is compiled), up to the rounding of the last digits.
///
///     const auto law = fstiff::ContactLaw<double>::compile(contact, {.pressure_min = 1e5, .pressure_max = 1e8});
///     const double K = law.stiffness(3e6);
///     const auto [p, slope] = law.at_gap(1.2e-6);
///
/// Outside the range: OutsideRange::refuse throws, clamp holds the value at the end, exact evaluates the model.
///
/// Units       SI: Pa, m, Pa/m; dK/dp in 1/m
/// Valid       0 < pressure_min < pressure_max within the reach of the model; no interaction or effective_separation
/// Accuracy    measured when it is compiled, between the nodes, and carried: relative_error(); 1e-11 or better as a rule
///             (tests/contact/contact_law_test.cpp)
/// Threads     evaluation is const and does not allocate: any number of threads may share a law

#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/contact/quantity.hpp>
#include <fstiff/core/text.hpp>
#include <fstiff/math/chebyshev.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
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

template <Real T>
requires(std::same_as<T, float> || std::same_as<T, double>) class ContactLaw {
public:
    struct Point {
        T pressure;   ///< [Pa]
        T stiffness;  ///< K [Pa/m]
    };

    /// Compiles \p contact, a RoughContact or GreenwoodWilliamson in the same scalar.
    /// \throws domain_error for a range that the model cannot reach or that is empty, and for interaction as_printed.
    template <class Contact>
    [[nodiscard]] static ContactLaw compile(const Contact& contact, const LawRange<T>& range);

    /// K [Pa/m] at the pressure \p pressure [Pa]. \throws domain_error outside the range under OutsideRange::refuse.
    [[nodiscard]] T stiffness(T pressure) const {
        if (!(pressure >= pressure_min_ && pressure <= pressure_max_)) [[unlikely]]
            return outside(pressure, &ContactLaw::stiffness, [](const Exact& e) { return e.stiffness; });
        const Place at = place(pressure);
        return polynomial(at.piece + stiffness_row, at.s);
    }

    /// Separation of the mean planes [m] at the pressure \p pressure [Pa]. \throws as stiffness.
    [[nodiscard]] T gap(T pressure) const {
        if (!(pressure >= pressure_min_ && pressure <= pressure_max_)) [[unlikely]]
            return outside(pressure, &ContactLaw::gap, [](const Exact& e) { return e.gap; });
        const Place at = place(pressure);
        return polynomial(at.piece + gap_row, at.s);
    }

    /// dK/dp [1/m] at the pressure \p pressure [Pa]: the derivative of what stiffness() returns. \throws as stiffness; with
    /// OutsideRange::clamp 0 outside, with exact by a difference of the model.
    [[nodiscard]] T stiffness_slope(T pressure) const {
        if (!(pressure >= pressure_min_ && pressure <= pressure_max_)) [[unlikely]] {
            if (outside_ == OutsideRange::clamp && !std::isnan(pressure)) return T(0);
            const T step = std::cbrt(std::numeric_limits<T>::epsilon()) * pressure;
            return (stiffness(pressure + step) - stiffness(pressure - step)) / (2 * step);
        }
        const Place at = place(pressure);
        return derivative(at.piece + stiffness_row, at.s) * at.piece[1];
    }

    /// p [Pa] and K [Pa/m] at the gap \p gap [m]. \throws as stiffness; gaps() is the range.
    [[nodiscard]] Point at_gap(T gap) const {
        const T position = (gap - gap_min_) * pieces_per_gap_;
        if (!(position >= 0 && gap <= gap_max_)) [[unlikely]]
            return outside_gap(gap);
        const auto index = std::min(static_cast<std::size_t>(position), gap_pieces_ - 1);
        const T s = 2 * (position - T(index)) - 1;
        const T* c = &by_gap_[index * terms];
        return {polynomial(c, s), derivative(c, s) * slope_scale_};
    }
    [[nodiscard]] T pressure_at_gap(T gap) const { return at_gap(gap).pressure; }
    [[nodiscard]] T stiffness_at_gap(T gap) const { return at_gap(gap).stiffness; }

    /// stiffness() of a whole array of pressures, equal to it bit for bit; \p out has the size of \p pressures.
    void stiffness(const Eigen::Ref<const Eigen::ArrayX<T>>& pressures, Eigen::Ref<Eigen::ArrayX<T>> out) const {
        require_same_size(pressures.size(), out.size());
        for (Eigen::Index i = 0; i < pressures.size(); ++i) out[i] = stiffness(pressures[i]);
    }

    /// at_gap() of a whole array of gaps, equal to it bit for bit; the results have the size of \p gaps.
    void at_gap(const Eigen::Ref<const Eigen::ArrayX<T>>& gaps, Eigen::Ref<Eigen::ArrayX<T>> pressures,
                Eigen::Ref<Eigen::ArrayX<T>> stiffnesses) const {
        require_same_size(gaps.size(), pressures.size());
        require_same_size(gaps.size(), stiffnesses.size());
        for (Eigen::Index i = 0; i < gaps.size(); ++i) {
            const Point at = at_gap(gaps[i]);
            pressures[i] = at.pressure;
            stiffnesses[i] = at.stiffness;
        }
    }

    /// The largest relative error of p, K and (over the rms height) gap, measured between the nodes when the law was compiled.
    [[nodiscard]] T relative_error() const { return relative_error_; }
    /// Whether K is exactly -dp/dgap of the returned p.
    [[nodiscard]] bool tangent_is_exact() const { return tangent_is_exact_; }
    [[nodiscard]] std::array<T, 2> pressures() const { return {pressure_min_, pressure_max_}; }
    [[nodiscard]] std::array<T, 2> gaps() const { return {gap_min_, gap_max_}; }
    /// Exact integrals that were evaluated to compile the law.
    [[nodiscard]] int evaluations() const { return evaluations_; }

    /// The law as text, every number in hexadecimal so that from_text gives it back bit for bit.
    [[nodiscard]] std::string to_text() const;
    /// \throws domain_error for text that to_text did not write. OutsideRange::exact becomes refuse: the model is not there.
    [[nodiscard]] static ContactLaw from_text(std::string_view text);

    [[nodiscard]] bool operator==(const ContactLaw& other) const { return to_text() == other.to_text(); }

private:
    static constexpr std::size_t terms = 8;  ///< coefficients of a piece
    // A piece by pressure: its middle, 1/half width, then K and gap.
    static constexpr std::size_t stiffness_row = 2, gap_row = 2 + terms, row = 2 + 2 * terms;
    using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;
    static constexpr int shift = std::numeric_limits<T>::digits - 1 - 2;  ///< four pieces a power of 2

    struct Place {
        const T* piece;
        T s;  ///< in [-1, 1]
    };
    struct Exact {
        T gap, pressure, stiffness;
    };

    ContactLaw() = default;

    [[nodiscard]] Place place(T pressure) const {
        const T* piece =
            &by_pressure_[static_cast<std::size_t>((std::bit_cast<Bits>(pressure) >> shift) - first_piece_) * row];
        return {piece, (pressure - piece[0]) * piece[1]};
    }

    /// Two interleaved Horner rules in s^2: half the latency of one.
    [[nodiscard]] static T polynomial(const T* c, T s) {
        const T square = s * s;
        const T even = ((c[6] * square + c[4]) * square + c[2]) * square + c[0];
        const T odd = ((c[7] * square + c[5]) * square + c[3]) * square + c[1];
        return odd * s + even;
    }
    [[nodiscard]] static T derivative(const T* c, T s) {
        const T square = s * s;
        const T even = ((7 * c[7] * square + 5 * c[5]) * square + 3 * c[3]) * square + c[1];
        const T odd = (6 * c[6] * square + 4 * c[4]) * square + 2 * c[2];
        return odd * s + even;
    }

    template <class Select>
    T outside(T pressure, T (ContactLaw::*function)(T) const, const Select& select) const {
        if (outside_ == OutsideRange::clamp && !std::isnan(pressure))
            return (this->*function)(std::clamp(pressure, pressure_min_, pressure_max_));
        if (outside_ == OutsideRange::exact) return select(exact_(pressure, true));
        detail::refuse(
            "pressure", pressure,
            "between " + text_of(pressure_min_) + " and " + text_of(pressure_max_) + " Pa, the range of the law");
    }

    Point outside_gap(T gap) const {
        if (outside_ == OutsideRange::clamp && !std::isnan(gap)) return at_gap(std::clamp(gap, gap_min_, gap_max_));
        if (outside_ == OutsideRange::exact) {
            const Exact e = exact_(gap, false);
            return {e.pressure, e.stiffness};
        }
        detail::refuse("gap", gap,
                       "between " + text_of(gap_min_) + " and " + text_of(gap_max_) + " m, the range of the law");
    }

    static void require_same_size(Eigen::Index a, Eigen::Index b) {
        if (a != b)
            throw domain_error("batch: the arrays have " + std::to_string(a) + " and " + std::to_string(b) +
                               " elements: must have the same number");
    }
    static std::string text_of(T value) { return shortest_text(value); }

    T pressure_min_{}, pressure_max_{}, gap_min_{}, gap_max_{};
    T pieces_per_gap_{};  ///< [1/m]
    T slope_scale_{};     ///< from d/ds to K
    T relative_error_{};
    std::size_t gap_pieces_ = 0;
    Bits first_piece_ = 0;
    bool tangent_is_exact_ = false;
    OutsideRange outside_ = OutsideRange::refuse;
    int evaluations_ = 0;
    std::vector<T> by_gap_, by_pressure_;
    std::function<Exact(T, bool)> exact_;  ///< at a pressure, or at a gap
};

template <Real T>
requires(std::same_as<T, float> || std::same_as<T, double>) template <class Contact>
ContactLaw<T> ContactLaw<T>::compile(const Contact& contact, const LawRange<T>& range) {
    require_positive("pressure_min", range.pressure_min);
    require(range.pressure_max > range.pressure_min && std::isfinite(range.pressure_max), "pressure_max",
            range.pressure_max, "finite and greater than pressure_min");
    require(contact.interaction().reading != InteractionReading::as_printed, "interaction", T(2),
            "none or effective_separation for a compiled law (as_printed is no function of one gap)");
    ContactLaw law;
    law.pressure_min_ = range.pressure_min;
    law.pressure_max_ = range.pressure_max;
    law.outside_ = range.outside;
    law.tangent_is_exact_ = contact.stiffness_over_slope() == T(1);

    // log p against the effective eta, from the separation of the highest pressure to that of the lowest, by sections that
    // one series each serves; a little beyond the ends, and never so short that the slope would be all rounding
    const T rms = contact.rms_height();
    const auto end = [&](T pressure) { return contact.at_pressure(pressure, Quantity::pressure).eta; };
    const T closest = end(range.pressure_max), furthest = end(range.pressure_min);
    const T slack = std::max((furthest - closest) / 1000, T(0.1) * std::max(T(0), 1 - (furthest - closest)));
    const T begin = closest - slack, length = furthest + slack - begin;
    const auto sections = static_cast<std::size_t>(std::ceil(length / 3));
    const T section = length / T(sections);
    const auto points = static_cast<std::size_t>(sizeof(T) == 8 ? 11 + 4 * section : 6 + 2 * section);
    std::vector<ChebyshevSeries<T>> values_of, slopes_of;
    for (std::size_t i = 0; i < sections; ++i) {
        values_of.emplace_back(begin + T(i) * section, begin + T(i + 1) * section, points, [&](T eta) {
            ++law.evaluations_;
            return contact.log_pressure(eta).log;
        });
        slopes_of.push_back(values_of.back().derivative());
    }
    // of one number, or of the nodes of a piece at once where one section holds them all
    using Nodes = Eigen::Array<T, terms, 1>;
    const auto in_sections = [sections](const std::vector<ChebyshevSeries<T>>& series, T from, T width, const auto& x) {
        const auto at = [&](T one) -> const ChebyshevSeries<T>& {
            return series[static_cast<std::size_t>(std::clamp((one - from) / width, T(0), T(sections) - T(0.5)))];
        };
        if constexpr (std::is_same_v<std::decay_t<decltype(x)>, T>) {
            return at(x)(x);
        } else {
            const auto &first = at(x[0]), &last = at(x[terms - 1]);
            if (&first == &last) return first(x);
            return Nodes(x.unaryExpr([&](T one) { return at(one)(one); }));
        }
    };
    const auto log_pressure = [&](const auto& eta) { return in_sections(values_of, begin, section, eta); };
    const auto slope = [&](const auto& eta) { return in_sections(slopes_of, begin, section, eta); };
    const T bulk = contact.bulk_compliance();

    // everything at one eta; with the bulk in series the gap is shorter and the slope smaller
    struct State {
        T gap, pressure, minus_dp_dgap;
    };
    const auto at_eta = [&](T eta) {
        const T p = std::exp(log_pressure(eta));
        const T k = -p * slope(eta) / rms;
        return State{eta * rms - p * bulk, p, k / (1 + k * bulk)};
    };
    law.gap_min_ = at_eta(closest).gap;
    law.gap_max_ = at_eta(furthest).gap;

    // by gap: log p changes by a quarter or so over a piece
    const auto& lobatto = detail::LobattoPiece<T, terms>::get();
    const auto steepness = [&](T eta) {
        const State at = at_eta(eta);
        return at.minus_dp_dgap / at.pressure;
    };
    const T steepest = std::max(steepness(furthest), steepness(closest));
    law.gap_pieces_ = static_cast<std::size_t>(std::ceil(4 * steepest * (law.gap_max_ - law.gap_min_))) + 1;
    const T width = (law.gap_max_ - law.gap_min_) / T(law.gap_pieces_);
    law.pieces_per_gap_ = 1 / width;
    law.slope_scale_ = -2 / width * contact.stiffness_over_slope();
    law.by_gap_.resize(law.gap_pieces_ * terms);
    const Nodes node = Eigen::Map<const Nodes>(lobatto.node.data());
    Nodes eta;
    eta[terms - 1] = closest;
    for (std::size_t i = 0; i < law.gap_pieces_; ++i) {
        const Nodes gap = law.gap_min_ + width * (T(i) + (1 + node) / 2);
        if (bulk == 0) {
            eta = gap / rms;
        } else {
            T last = eta[terms - 1];
            for (Eigen::Index k = 0; k < gap.size(); ++k) {  // eta rms - p bulk = gap, convex: from the last node on
                for (int iteration = 0; iteration < 50; ++iteration) {
                    const T p = std::exp(log_pressure(last));
                    const T step = (gap[k] - (last * rms - p * bulk)) / (rms - p * slope(last) * bulk);
                    last = std::clamp(last + step, closest - slack, furthest + slack);
                    if (std::abs(step) <= 2 * std::numeric_limits<T>::epsilon() * (1 + std::abs(last))) break;
                }
                eta[k] = last;
            }
        }
        lobatto.fit(log_pressure(eta).exp(), &law.by_gap_[i * terms]);
    }

    // eta against log p: the inverse of the series, by Newton's method from node to node, again by sections
    const T log_low = log_pressure(furthest + slack / 2), log_high = log_pressure(closest - slack / 2);
    const T log_section = (log_high - log_low) / T(sections);
    std::vector<ChebyshevSeries<T>> etas_of;
    for (std::size_t i = 0; i < sections; ++i) {
        T last = furthest + (closest - furthest) * (T(i) + 1) / T(sections);
        etas_of.emplace_back(log_low + T(i) * log_section, log_low + T(i + 1) * log_section, points, [&](T log_p) {
            for (int iteration = 0; iteration < 30; ++iteration) {
                const T step = (log_p - log_pressure(last)) / slope(last);
                last = std::clamp(last + step, closest - slack, furthest + slack);
                // the next step would be about step^2: below rounding
                if (std::abs(step) <= std::sqrt(std::numeric_limits<T>::epsilon()) / 4) break;
            }
            return last;
        });
    }

    // by pressure: four pieces to each power of 2
    law.first_piece_ = std::bit_cast<Bits>(range.pressure_min) >> shift;
    const Bits last_piece = std::bit_cast<Bits>(range.pressure_max) >> shift;
    law.by_pressure_.resize(static_cast<std::size_t>(last_piece - law.first_piece_ + 1) * row);
    for (Bits piece = law.first_piece_; piece <= last_piece; ++piece) {
        // the ends of the range cut the outer pieces, so that nothing outside it is needed
        const T from = std::max(std::bit_cast<T>(static_cast<Bits>(piece << shift)), range.pressure_min);
        const T to = std::min(std::bit_cast<T>(static_cast<Bits>((piece + 1) << shift)), range.pressure_max);
        T* c = &law.by_pressure_[static_cast<std::size_t>(piece - law.first_piece_) * row];
        const T half = std::max((to - from) / 2, from * std::numeric_limits<T>::epsilon());
        c[0] = (from + to) / 2;
        c[1] = 1 / half;
        const Nodes p = c[0] + half * node;
        const Nodes x = in_sections(etas_of, log_low, log_section, Nodes(p.log()));
        const Nodes dp = -p * slope(x) / rms;
        lobatto.fit(dp / (1 + dp * bulk) * contact.stiffness_over_slope(), c + stiffness_row);
        lobatto.fit(x * rms - p * bulk, c + gap_row);
    }

    // the errors, between the nodes of both tables
    const std::size_t checks = 8 + 4 * sections;
    for (std::size_t i = 0; i < checks; ++i) {
        const T x = closest + (furthest - closest) * (T(i) + T(0.37)) / T(checks);
        const LogSlope<T> truth = contact.log_pressure(x);
        const T p = std::clamp(std::exp(truth.log), range.pressure_min, range.pressure_max);
        const T dp = -p * truth.slope / rms;
        const T k = dp / (1 + dp * bulk) * contact.stiffness_over_slope();
        const T gap = x * rms - p * bulk;
        const auto worst = [&](T error) { law.relative_error_ = std::max(law.relative_error_, error); };
        worst(std::abs(law.stiffness(p) / k - 1));
        worst(std::abs(law.gap(p) - gap) / rms);
        const Point at = law.at_gap(std::clamp(gap, law.gap_min_, law.gap_max_));
        worst(std::abs(at.pressure / p - 1));
        worst(std::abs(at.stiffness / k - 1));
    }
    // the points found most of it; between other nodes it may be somewhat more, and a slope over a short piece of a short
    // range carries the rounding of the few digits in which p changes there
    const T shortest_change = steepest * width;
    law.relative_error_ = 6 * law.relative_error_ + T(4 * terms * terms) * std::numeric_limits<T>::epsilon() *
                                                        std::max(T(1), T(0.25) / shortest_change);

    // monotone: p and K move one way from node to node; closer than that the polynomials are smooth
    const auto rises = [](const T* c) {
        for (int i = -8; i <= 8; ++i)
            if (!(derivative(c, T(i) / 8) > 0)) return false;
        return true;
    };
    bool monotone = true;
    for (std::size_t i = 0; i < law.by_pressure_.size(); i += row)
        monotone = monotone && rises(&law.by_pressure_[i + stiffness_row]);
    for (std::size_t i = 0; i < law.by_gap_.size(); i += terms) {
        std::array<T, terms> falling;
        for (std::size_t k = 0; k < terms; ++k) falling[k] = -law.by_gap_[i + k];
        monotone = monotone && rises(falling.data());
    }
    if (!monotone)
        throw domain_error("pressure range: the compiled law would not be monotone; must be one where K and p are");

    if (range.outside == OutsideRange::exact)
        law.exact_ = [contact](T x, bool is_pressure) {
            const auto state = is_pressure ? contact.at_pressure(x, Quantity::stiffness | Quantity::pressure)
                                           : contact.at_separation(x, Quantity::stiffness | Quantity::pressure);
            return Exact{state.separation.value, state.pressure.value, state.stiffness.value};
        };
    return law;
}

template <Real T>
requires(std::same_as<T, float> || std::same_as<T, double>) std::string ContactLaw<T>::to_text()
const {
    std::string text = "fstiff contact law 1 " + std::to_string(sizeof(T)) + '\n';
    text += std::to_string(gap_pieces_) + ' ' + std::to_string(first_piece_) + ' ' +
            std::to_string(by_pressure_.size() / row) + ' ' + std::to_string(static_cast<int>(tangent_is_exact_)) +
            ' ' + std::to_string(static_cast<int>(outside_)) + ' ' + std::to_string(evaluations_) + '\n';
    const auto add = [&text](const T* numbers, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) text += hexadecimal_text(numbers[i]) + (i + 1 < count ? ' ' : '\n');
    };
    const T head[] = {pressure_min_, pressure_max_, gap_min_, gap_max_, pieces_per_gap_, slope_scale_, relative_error_};
    add(head, std::size(head));
    for (std::size_t i = 0; i < gap_pieces_; ++i) add(&by_gap_[i * terms], terms);
    for (std::size_t i = 0; i < by_pressure_.size(); i += row) add(&by_pressure_[i], row);
    return text;
}

template <Real T>
requires(std::same_as<T, float> ||
         std::same_as<T, double>) ContactLaw<T> ContactLaw<T>::from_text(std::string_view text) {
    const std::string head = "fstiff contact law 1 " + std::to_string(sizeof(T)) + '\n';
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
    law.gap_pieces_ = number(std::size_t{});
    law.first_piece_ = number(Bits{});
    const auto pressure_pieces = number(std::size_t{});
    // each number takes two characters or more: a size that the text cannot hold is refused before it is allocated
    if (law.gap_pieces_ == 0 || pressure_pieces == 0 || law.gap_pieces_ > text.size() || pressure_pieces > text.size())
        throw wrong("holds impossible sizes");
    law.tangent_is_exact_ = number(int{}) != 0;
    const int outside = number(int{});
    if (outside < 0 || outside > 2) throw wrong("holds an unknown policy");
    law.outside_ = outside == static_cast<int>(OutsideRange::clamp) ? OutsideRange::clamp : OutsideRange::refuse;
    law.evaluations_ = number(int{});
    for (T* x : {&law.pressure_min_, &law.pressure_max_, &law.gap_min_, &law.gap_max_, &law.pieces_per_gap_,
                 &law.slope_scale_, &law.relative_error_})
        *x = number(T{});
    for (std::size_t i = 0; i < law.gap_pieces_ * terms; ++i)
        law.by_gap_.push_back(number(T{}));
    for (std::size_t i = 0; i < pressure_pieces * row; ++i)
        law.by_pressure_.push_back(number(T{}));
    skip();
    if (at != end) throw wrong("goes on after its end");
    const bool ordered = law.pressure_min_ > 0 && law.pressure_max_ > law.pressure_min_ && law.gap_max_ > law.gap_min_;
    const auto piece = [](T p) { return std::bit_cast<Bits>(p) >> shift; };
    if (!ordered || piece(law.pressure_min_) != law.first_piece_ ||
        piece(law.pressure_max_) - law.first_piece_ + 1 != pressure_pieces ||
        !(law.pieces_per_gap_ > 0 && (law.gap_max_ - law.gap_min_) * law.pieces_per_gap_ < T(law.gap_pieces_) + 1))
        throw wrong("contradicts itself");
    return law;
}

}  // namespace fstiff
