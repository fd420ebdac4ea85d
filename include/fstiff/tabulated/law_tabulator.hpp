// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Tables of a smooth tabulated law: Chebyshev series of log p by sections, its inverse, and polynomials cut from both.
///
/// The model gives log_pressure(eta) with the slope, the bulk in series, the rms height and K over -dp/dd, or else
/// log_stiffness(eta), which is interpolated as log p is. The error is measured against the model between the nodes. A
/// law with kinks is made by tabulated/kinked_tabulator.
///
/// Units       SI; eta is the separation over the rms height
/// Valid       as tabulated/contact_law
/// Accuracy    measured, and kept in the tables

#include <fstiff/contact/contact.hpp>
#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/core/error.hpp>
#include <fstiff/math/chebyshev.hpp>
#include <fstiff/math/lanes.hpp>
#include <fstiff/math/piecewise.hpp>
#include <fstiff/peaks/quantity.hpp>
#include <fstiff/tabulated/kinked_tabulator.hpp>
#include <fstiff/tabulated/law_tables.hpp>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// What the tables ask of a contact, with virtual functions: they are compiled once for all contacts.
template <Real T>
struct LawModel {
    virtual ~LawModel() = default;
    virtual ContactState<T> at_pressure(T pressure, Quantity quantities) const = 0;
    virtual ContactState<T> at_separation(T separation, Quantity quantities) const = 0;
    virtual LogSlope<T> log_pressure(T eta) const = 0;
    virtual Estimate<T> log_stiffness(T eta) const = 0;

    T rms_height{}, bulk_compliance{};
    T stiffness_over_slope{};  ///< K over -dp/dd, 0 where that is no constant
    bool has_kinks{};
};

/// \p Held is a contact, or a reference to one that lives as long.
template <Real T, class Held>
struct LawModelOf final : LawModel<T> {
    using Contact = std::remove_cvref_t<Held>;

    explicit LawModelOf(const Contact& contact) : contact_(contact) {
        this->rms_height = contact.rms_height();
        this->bulk_compliance = contact.bulk_compliance();
        if constexpr (ProportionalContact<Contact, T>) this->stiffness_over_slope = contact.stiffness_over_slope();
        this->has_kinks = detail::has_kinks(contact);
    }
    ContactState<T> at_pressure(T pressure, Quantity quantities) const override {
        return contact_.at_pressure(pressure, quantities);
    }
    ContactState<T> at_separation(T separation, Quantity quantities) const override {
        return contact_.at_separation(separation, quantities);
    }
    LogSlope<T> log_pressure(T eta) const override { return contact_.log_pressure(eta); }
    Estimate<T> log_stiffness(T eta) const override { return contact_.log_stiffness(eta); }

private:
    Held contact_;
};

/// The work of ContactLaw::tabulate, in the order of its functions.
template <Real T>
class LawTabulator {
public:
    LawTabulator(const LawModel<T>& model, T min_pressure, T max_pressure) : model_(model) {
        law_.min_pressure = min_pressure;
        law_.max_pressure = max_pressure;
        law_.stiffness_over_slope = model.stiffness_over_slope;
        law_.stiffness = law_.separation = math::BinaryPieces<T>(min_pressure, max_pressure);
        law_.evaluations = 1;
        middle_ = std::sqrt(min_pressure) * std::sqrt(max_pressure);
    }

    struct Made {
        LawTables<T> tables;
        bool is_monotone;
    };
    [[nodiscard]] Made tabulate() {
        interpolate_pressure();
        if (!proportional_) interpolate_stiffness();
        cut_by_separation();
        law_.sum_energies();
        interpolate_eta();
        cut_by_pressure();
        measure_error();
        const bool monotone = is_monotone();
        return {std::move(law_), monotone};
    }

private:
    static constexpr T epsilon = std::numeric_limits<T>::epsilon();
    static constexpr T pieces_per_e = sizeof(T) == 8 ? T(4) : T(1.5);  ///< a float's slope would be all rounding on 4

    using One = math::Lanes<T, 1>;
    using Nodes = math::Lanes<T, math::Row::terms>;  ///< those of a piece

    template <class V>
    struct State {
        V separation, pressure, minus_dp_dd;
        V stretch;  ///< d separation/d eta over the rms height
    };
    /// Adds the bulk in series: the separation is shorter and the slope smaller. \p slope is d log p/d eta.
    template <class V>
    [[nodiscard]] State<V> in_series(const V& eta, const V& p, const V& slope) const {
        const V k = p * slope * V::all(-1 / rms_), stretch = multiply_add(k, V::all(bulk_), V::all(1));
        return {eta * V::all(rms_) - p * V::all(bulk_), p, k / stretch, stretch};
    }
    template <class V>
    [[nodiscard]] State<V> at(const V& eta) const {
        return in_series(eta, V::all(middle_) * exp(log_pressure_(eta)), slope_(eta));
    }

    /// K at eta, from -dp/dd where it is a constant times that.
    template <class V>
    [[nodiscard]] V stiffness_of(const State<V>& state, const V& eta) const {
        if (proportional_)
            return state.minus_dp_dd * V::all(law_.stiffness_over_slope);
        else
            return stiffness_in_series(V::all(stiffness_unit_) * exp(log_stiffness_(eta)));
    }
    /// K of the interface with the bulk.
    template <class V>
    [[nodiscard]] V stiffness_in_series(const V& k) const {
        return k / multiply_add(k, V::all(bulk_), V::all(1));
    }
    /// K of the model itself at \p state, which is p of the model.
    [[nodiscard]] T true_stiffness(const State<One>& state, T eta) const {
        if (proportional_)
            return stiffness_of(state, One::all(eta)).p;
        else
            return stiffness_in_series(One::all(std::exp(model_.log_stiffness(eta).value))).p;
    }

    [[nodiscard]] Nodes nodes(T from, T to) const {
        const Nodes half = Nodes::all((to - from) / 2);
        return Nodes::all(from) + multiply_add(half, Nodes::load(lobatto_.node.data()), half);
    }

    [[nodiscard]] static auto* row(auto& pieces, Eigen::Index i) { return pieces.rows[static_cast<std::size_t>(i)].c; }

    /// log p, over the middle of its range to keep its digits, against the effective eta; from the separation of the
    /// highest pressure to that of the lowest, and beyond as far as the outer pieces by pressure reach.
    void interpolate_pressure() {
        const auto end = [this](T pressure) {
            return model_.at_pressure(pressure, Quantity::pressure | Quantity::separation).eta;
        };
        closest_ = end(law_.max_pressure);
        furthest_ = end(law_.min_pressure);
        // log p is concave in eta: 10 % more than the slope is enough; never so short that the slope is rounding
        const T beyond = T(0.13);  // log(9/8) and 10 %
        const T slack =
            (std::max)(-beyond / model_.log_pressure(closest_).slope, T(0.1) * (1 - (furthest_ - closest_)));
        begin_ = closest_ - slack;
        end_ = furthest_ + slack;
        sections_ = static_cast<std::size_t>(std::ceil((end_ - begin_) / 3));
        const T section = (end_ - begin_) / T(sections_);
        points_ = static_cast<std::size_t>(sizeof(T) == 8 ? 11 + 4 * section : 6 + 2 * section);
        const auto sample = [this, log_middle = std::log(middle_)](T eta) {
            ++law_.evaluations;
            const LogSlope<T> p = model_.log_pressure(eta);
            error_ = (std::max)(error_, p.error);
            return p.log - log_middle;
        };
        log_pressure_ = {begin_, end_, sections_, points_, sample, error_};
        slope_ = log_pressure_.derivative();
    }

    /// log K, over its value at the closest separation, against the effective eta.
    void interpolate_stiffness() {
        T error = 0;
        const auto log_at = [&](T eta) {
            ++law_.evaluations;
            const Estimate<T> k = model_.log_stiffness(eta);
            require(std::isfinite(k.value), "stiffness", std::exp(k.value),
                    "finite and greater than 0 for a tabulated law");
            error = (std::max)(error, k.error);
            return k.value;
        };
        const T unit = log_at(closest_);
        stiffness_unit_ = std::exp(unit);
        log_stiffness_ = {begin_, end_, sections_, points_, [&](T eta) { return log_at(eta) - unit; }, error};
    }

    /// Pieces over which log p changes by a quarter or so.
    void cut_by_separation() {
        const auto low = at(One::all(closest_)), high = at(One::all(furthest_));
        const T from = low.separation.p, length = high.separation.p - from;
        const T steepest = (std::max)(low.minus_dp_dd.p / low.pressure.p, high.minus_dp_dd.p / high.pressure.p);
        const auto pieces = static_cast<Eigen::Index>(std::ceil(pieces_per_e * steepest * length)) + 1;
        const T width = length / T(pieces);
        law_.by_separation = math::UniformPieces<T>(from, high.separation.p, pieces);
        if (!proportional_) law_.own_stiffness = law_.by_separation;
        law_.set_scales();
        shortest_change_ = steepest * width;
        T last = closest_;
        for (Eigen::Index i = 0; i < pieces; ++i) {
            const Nodes eta = eta_of_separation(nodes(from + width * T(i), from + width * T(i + 1)), last);
            const State<Nodes> state = at(eta);
            T* const c = row(law_.by_separation, i);
            lobatto_.fit(state.pressure).store(c);
            if (!proportional_) lobatto_.fit(stiffness_of(state, eta)).store(row(law_.own_stiffness, i));
            // against the series the slope is worst at the ends of a piece
            std::array<T, math::Row::terms> tangent;
            (state.minus_dp_dd * Nodes::all(-width / 2)).store(tangent.data());
            at_ends_ = (std::max)({at_ends_, std::abs(math::Row::derivative(c, T(-1)) / tangent.front() - 1),
                                   std::abs(math::Row::derivative(c, T(1)) / tangent.back() - 1)});
        }
    }

    /// eta rms - p bulk = separation, concave: Newton's method rises to the roots from \p last, the last one
    /// afterwards.
    [[nodiscard]] Nodes eta_of_separation(const Nodes& separation, T& last) const {
        if (bulk_ == 0) return separation / Nodes::all(rms_);
        Nodes eta = Nodes::all(last);
        std::array<T, math::Row::terms> lanes;
        for (int iteration = 0; iteration < 50; ++iteration) {
            const State<Nodes> state = at(eta);
            const Nodes step = (separation - state.separation) / (state.stretch * Nodes::all(rms_));
            eta = smaller(larger(eta + step, Nodes::all(begin_)), Nodes::all(end_));
            larger(step, Nodes::all(0) - step).store(lanes.data());
            if (*std::max_element(lanes.begin(), lanes.end()) <= close_enough_) break;
        }
        eta.store(lanes.data());
        last = lanes.back();
        return eta;
    }

    /// eta against log p: the inverse of the series, by Newton's method from node to node, again by sections; its tail
    /// falls by a digit or more with every coefficient.
    void interpolate_eta() {
        T eta = closest_;
        const auto solve = [&](T log_p) {
            for (int iteration = 0; iteration < 50; ++iteration) {
                const T step = (log_p - log_pressure_(eta)) / slope_(eta);
                eta = LawTables<T>::within(eta + step, begin_, end_);
                if (std::abs(step) <= close_enough_) break;
            }
            return eta;
        };
        const auto log_of_edge = [&](Eigen::Index i) { return std::log(law_.stiffness.edge(i) / middle_); };
        eta_of_ = {log_of_edge(0), log_of_edge(std::ssize(law_.stiffness.rows)), sections_, points_,
                   solve,          (std::max)(error_, 20000 * epsilon)};
    }

    void cut_by_pressure() {
        std::array<T, math::Row::terms> power{1};  // from s in [-1, 1] to that of the pieces
        for (std::size_t k = 1; k < power.size(); ++k) power[k] = power[k - 1] / math::BinaryPieces<T>::half;
        const Nodes scale = Nodes::load(power.data());
        for (Eigen::Index i = 0; i < std::ssize(law_.stiffness.rows); ++i) {
            const Nodes p = nodes(law_.stiffness.edge(i), law_.stiffness.edge(i + 1));
            const Nodes eta = eta_of_(log(p / Nodes::all(middle_)));
            const State<Nodes> state = in_series(eta, p, slope_(eta));
            (lobatto_.fit(stiffness_of(state, eta)) * scale).store(row(law_.stiffness, i));
            (lobatto_.fit(state.separation) * scale).store(row(law_.separation, i));
        }
    }

    /// The errors against the model, between the nodes of both tables.
    void measure_error() {
        const std::size_t checks = 8 + 4 * log_pressure_.size();
        T deviation = slope_.relative_jump();
        const auto worst = [&deviation](T difference) { deviation = (std::max)(deviation, std::abs(difference)); };
        for (std::size_t i = 0; i < checks; ++i) {
            const T eta = closest_ + (furthest_ - closest_) * (T(i) + T(0.37)) / T(checks);
            const LogSlope<T> model = model_.log_pressure(eta);
            const T p = std::clamp(std::exp(model.log), law_.min_pressure, law_.max_pressure);
            const auto truth = in_series(One::all(eta), One::all(p), One::all(model.slope));
            const T separation = truth.separation.p, k = true_stiffness(truth, eta);
            worst(law_.stiffness.value(p) / k - 1);
            worst((law_.separation_at(p) - separation) / rms_);
            const auto point =
                law_.at_separation(std::clamp(separation, law_.by_separation.begin, law_.by_separation.end));
            worst(point.pressure / p - 1);
            worst(point.stiffness / k - 1);
            if (!proportional_) worst(point.slope / truth.minus_dp_dd.p - 1);
        }
        // the points found most of it; between others it may be somewhat more, and a slope over a short piece of a
        // short range carries the rounding of the few digits in which p changes there
        constexpr T rounding = T(4 * math::Row::terms * math::Row::terms) * epsilon;
        law_.relative_error =
            6 * deviation + T(1.5) * at_ends_ + rounding * (std::max)(T(1), 1 / (pieces_per_e * shortest_change_));
    }

    /// p and K move one way from node to node; closer than that the polynomials are smooth.
    [[nodiscard]] bool is_monotone() const {
        const auto moves = [](const auto& pieces, T half, T way) {
            for (Eigen::Index i = 0; i < std::ssize(pieces.rows); ++i)
                for (int k = -8; k <= 8; ++k)
                    if (!(way * math::Row::derivative(row(pieces, i), half * T(k) / 8) > 0)) return false;
            return true;
        };
        return moves(law_.stiffness, math::BinaryPieces<T>::half, T(1)) && moves(law_.by_separation, T(1), T(-1)) &&
               moves(law_.own_stiffness, T(1), T(-1));
    }

    const LawModel<T>& model_;
    const bool proportional_ = model_.stiffness_over_slope != T(0);
    LawTables<T> law_;
    const math::LobattoPiece<T, math::Row::terms>& lobatto_ = math::LobattoPiece<T, math::Row::terms>::get();
    const T rms_ = model_.rms_height, bulk_ = model_.bulk_compliance;
    T middle_{};                                     ///< of the pressures
    const T close_enough_ = std::sqrt(epsilon) / 4;  ///< of Newton's method: the next step would be about step^2
    math::ChebyshevSections<T> log_pressure_;        ///< log(p/middle) against eta
    math::ChebyshevSections<T> slope_;               ///< its derivative
    math::ChebyshevSections<T> eta_of_;              ///< its inverse
    math::ChebyshevSections<T> log_stiffness_;       ///< log(K/unit) against eta, where K has its own table
    T stiffness_unit_{};
    std::size_t sections_{}, points_{};  ///< of each
    T closest_{}, furthest_{};           ///< eta at the ends of the range
    T begin_{}, end_{};                  ///< and of the series
    T error_{};                          ///< of the integrals
    T at_ends_{};                        ///< of the slope, at the ends of the pieces by separation
    T shortest_change_{};                ///< of log p over a piece by separation
};

/// The tables of \p model: polynomials where K is smooth, parabolas where it has kinks or where polynomials are not
/// monotone or off by more than 1e-3.
template <Real T>
[[nodiscard]] LawTables<T> tables_of(const LawModel<T>& model, T min_pressure, T max_pressure) {
    if (!model.has_kinks) {
        auto tabulated = LawTabulator<T>(model, min_pressure, max_pressure).tabulate();
        if (tabulated.is_monotone && tabulated.tables.relative_error <= T(1e-3)) return std::move(tabulated.tables);
    }
    const auto law = [&model](T pressure, bool with_separation) {
        const ContactState<T> state = model.at_pressure(
            pressure, with_separation ? Quantity::stiffness | Quantity::separation : Quantity::stiffness);
        return LawPoint<T>{state.separation.value, state.stiffness.value};
    };
    return KinkedTabulator<T>(law, model.stiffness_over_slope, model.rms_height).tabulate(min_pressure, max_pressure);
}

}}}  // namespace fstiff::detail
