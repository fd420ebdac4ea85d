// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Tabulated contact: stiffness and pressure in nanoseconds, for codes that evaluate the law millions of times.
///
///     p(d), K(d), -dp/dd, d(p), K(p), dK/dp        d: separation of the mean planes
/// ```cpp
/// #include <fstiff/asperity/laws.hpp>
/// #include <fstiff/contact/rough_contact.hpp>
/// #include <fstiff/tabulated/contact_law.hpp>
///
/// #include <cstdio>
///
/// int main() {
///     const fstiff::Roughness<double> rough{.rms_height = 0.8e-6, .peak_radius = 40e-6, .peak_density = 500e6};
///     const fstiff::PeakDistribution<double> peaks(0.5, 1.0);
///     const fstiff::RoughContact contact(rough, peaks, fstiff::HertzLaw<double>{}, 112.6e9);
///     const auto law = fstiff::ContactLaw<double>::tabulate(contact, {.min_pressure = 1e5, .max_pressure = 1e8});
///     const auto [pressure, slope] = law.tangent_at_separation(law.separation(10e6));
///     std::printf("p = %.4e Pa, -dp/dd = %.4e Pa/m\n", pressure, slope);
/// }
/// ```
/// ```text
/// p = 1.0000e+07 Pa, -dp/dd = 3.2839e+13 Pa/m
/// ```
///
/// -dp/dd is the derivative of the returned p, the tangent of Newton's method; p falls and K rises monotonically.
///
/// Units       SI: Pa, m, Pa/m; dK/dp in 1/m
/// Valid       float and double; 0 < min_pressure < max_pressure within the reach of the model; no interaction or
///             effective_separation. A default-constructed law refuses every evaluation
/// Accuracy    relative_error(), measured when tabulated; 1e-8 or better for 400 laws of random surfaces, 1e-3 with
///             kinks. In float 3e-4 over three decades: that of the slope at a separation; K at a pressure is within
///             1e-5. A batch is within 200 epsilon of the scalar calls (tests/tabulated/contact_law_test.cpp)
/// Threads     evaluation is const and does not allocate: any number of threads may share a law

#include <fstiff/contact/contact.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/core/error.hpp>
#include <fstiff/core/text.hpp>
#include <fstiff/math/piecewise.hpp>
#include <fstiff/peaks/quantity.hpp>
#include <fstiff/tabulated/law_batches.hpp>
#include <fstiff/tabulated/law_tables.hpp>
#include <fstiff/tabulated/law_tabulator.hpp>
#include <fstiff/tabulated/law_text.hpp>

namespace fstiff { inline namespace v0_1 {

namespace detail {

template <Real T>
void require_range(const LawRange<T>& range) {
    require(range.min_pressure >= (std::numeric_limits<T>::min)(), "min_pressure", range.min_pressure,
            "finite and greater than 0, and no denormal number");
    require(range.max_pressure > range.min_pressure && std::isfinite(range.max_pressure), "max_pressure",
            range.max_pressure, "finite and greater than min_pressure");
}

}  // namespace detail

/// Law of a contact from tables: p(d), K(d) and d(p), K(p) in nanoseconds. Threads may share one.
template <Real T = double>
class ContactLaw {
public:
    struct AtSeparation {
        T pressure;   ///< [Pa]
        T stiffness;  ///< K [Pa/m]
    };
    struct Tangent {
        T pressure;  ///< [Pa]
        T slope;     ///< -dp/dd [Pa/m] of the returned p
    };
    struct AtPressure {
        T separation;       ///< [m]
        T stiffness;        ///< K [Pa/m]
        T stiffness_slope;  ///< dK/dp [1/m] of the returned K
    };

    /// Empty: refuses every evaluation, until a law is assigned to it.
    ContactLaw() = default;

    /// Tabulates \p contact, a RoughContact of any law or another Contact in the same scalar.
    /// \throws domain_error for a range that the model cannot reach or that is empty, for interaction as_printed, and
    /// for a K that is not greater than 0 or does not rise with p.
    // Defined below: no file that is linked with fstiff::double compiles it again.
    template <Contact<T> Model>
    [[nodiscard]] static ContactLaw tabulate(const Model& contact, const LawRange<T>& range);
    /// Tabulates states at pressures [Pa]; the error of the separation is relative to \p rms_height [m].
    /// \p stiffness_over_slope: K over -dp/dd, 0 where that is no constant.
    /// \throws domain_error as above, and for OutsideRange::exact.
    [[nodiscard]] static ContactLaw tabulate_points(const std::function<detail::LawPoint<T>(T pressure)>& law,
                                                    std::type_identity_t<T> rms_height, const LawRange<T>& range,
                                                    std::type_identity_t<T> stiffness_over_slope = T(0)) {
        detail::require_range(range);
        detail::require_positive("rms_height", rms_height);
        if (range.outside == OutsideRange::exact)
            detail::refuse("outside", "exact", "another policy for a law that is known at pressures alone");
        ContactLaw result;
        result.tables_ =
            detail::KinkedTabulator<T>([&law](T p, bool) { return law(p); }, stiffness_over_slope, rms_height)
                .tabulate(range.min_pressure, range.max_pressure);
        result.tables_.outside = range.outside;
        return result;
    }

    /// The law whose -dp/dd is \p slope, a smooth function of the pressure [Pa], at nodes 1/20 of p apart; separations
    /// count from that at the greatest pressure. K is \p stiffness, of unloading where peaks yield; none: the slope.
    /// \throws domain_error as tabulate_points.
    [[nodiscard]] static ContactLaw tabulate_slope(const std::function<T(T pressure)>& slope, const LawRange<T>& range,
                                                   const std::function<T(T pressure)>& stiffness = {}) {
        detail::require_range(range);
        detail::require(range.max_pressure / range.min_pressure > 1 + 32 * std::numeric_limits<T>::epsilon(),
                        "max_pressure", range.max_pressure, "further above min_pressure than rounding");
        ContactLaw result;
        const auto state = [&](T p, bool) { return detail::LawPoint<T>{T(0), slope(p)}; };
        result.tables_ = detail::KinkedTabulator<T>(state, T(1), T(1))
                             .tabulate_evenly(range.min_pressure, range.max_pressure, stiffness);
        return result.with(range.outside);
    }
    /// \p below up to its greatest pressure, at \p separation [m], and \p above from there on; an empty one: nothing.
    /// Both are of tabulate_slope(); -dp/dd may jump where they meet.
    [[nodiscard]] static ContactLaw joined(const ContactLaw& below, const ContactLaw& above,
                                           std::type_identity_t<T> separation) {
        ContactLaw result = below;
        result.tables_ = detail::joined(below.tables_, above.tables_, separation);
        return result;
    }

    /// K [Pa/m] at the pressure \p pressure [Pa]. \throws domain_error outside the range under OutsideRange::refuse,
    /// for a negative or infinite pressure under extrapolate, for NaN, and of an empty law.
    [[nodiscard]] T stiffness(T pressure) const {
        if (!tables_.stiffness.contains(pressure)) [[unlikely]]
            return besides_pieces(pressure, false).stiffness;
        return tables_.stiffness.value(pressure);
    }

    /// Separation of the mean planes [m] at the pressure \p pressure [Pa], within separations() for one in the range.
    /// \throws as stiffness.
    [[nodiscard]] T separation(T pressure) const {
        if (!tables_.separation.contains(pressure)) [[unlikely]]
            return besides_pieces(pressure, false).separation;
        return tables_.separation_at(pressure);
    }

    /// dK/dp [1/m] at the pressure \p pressure [Pa]: the derivative of what stiffness() returns; outside the range with
    /// OutsideRange::exact by a difference of the model. \throws as stiffness.
    [[nodiscard]] T stiffness_slope(T pressure) const {
        if (!tables_.stiffness.contains(pressure)) [[unlikely]]
            return besides_pieces(pressure, true).stiffness_slope;
        return tables_.stiffness.derivative(pressure);
    }

    /// separation(), stiffness() and stiffness_slope() at once. \throws as stiffness.
    [[nodiscard]] AtPressure at_pressure(T pressure) const {
        if (!tables_.stiffness.contains(pressure)) [[unlikely]]
            return besides_pieces(pressure, true);
        return of_tables(tables_.at_pressure(pressure));
    }

    /// p [Pa] and K [Pa/m] at the separation \p separation [m]. \throws domain_error outside separations() under
    /// OutsideRange::refuse, for -infinity under extrapolate, for NaN, and of an empty law.
    [[nodiscard]] AtSeparation at_separation(T separation) const {
        const Whole state = whole_at(separation);
        return {state.pressure, state.stiffness};
    }
    /// p [Pa] and -dp/dd [Pa/m], which is K only where stiffness_is_slope(). \throws as at_separation.
    [[nodiscard]] Tangent tangent_at_separation(T separation) const {
        const Whole state = whole_at(separation);
        return {state.pressure, state.slope};
    }
    /// Work per area that closes the contact from infinity to \p separation [m]: the integral of p over d [J/m^2], by
    /// the polynomials of the table; beyond its range that of the law as OutsideRange::extrapolate continues it, which
    /// an elastic contact stores. \throws as at_separation, of a law with OutsideRange::clamp or exact too.
    [[nodiscard]] T energy(T separation) const {
        require_filled();
        if (math::is_nan(separation) || (outside() != OutsideRange::extrapolate && !tables_.has_separation(separation)))
            refuse("separation", separation, tables_.closest(), tables_.furthest(), " m");
        return tables_.energy(separation);
    }
    /// Separation [m] where the line through the loosest state of the range, with its slope, meets p = 0: first touch,
    /// as for a drawn face without roughness. p itself falls without end.
    [[nodiscard]] T touch() const {
        require_filled();
        const auto end = tables_.at_furthest();
        return tables_.furthest() + end.pressure / end.slope;
    }
    /// Approach of the faces from \p preload to \p pressure [Pa]: the overclosure of a model whose faces are
    /// drawn under a preload [m]. From first touch it is touch() - separation(pressure). \throws as stiffness.
    [[nodiscard]] T approach(T pressure, T preload) const { return separation(preload) - separation(pressure); }

    [[nodiscard]] T pressure_at_separation(T separation) const { return at_separation(separation).pressure; }
    [[nodiscard]] T stiffness_at_separation(T separation) const { return at_separation(separation).stiffness; }
    [[nodiscard]] T slope_at_separation(T separation) const { return tangent_at_separation(separation).slope; }

    /// stiffness() of a whole array of pressures, equal to it within rounding and relative_error(); \p out has the size
    /// of \p pressures and may be the same array. \throws as stiffness, at the first element that is to be refused.
    void stiffness(const Eigen::Ref<const Eigen::ArrayX<T>>& pressures, Eigen::Ref<Eigen::ArrayX<T>> out) const {
        detail::require_same_size(pressures.size(), out.size());
        batch(
            tables_.stiffness, pressures, std::array{out.data()},
            [](const auto& pieces, const T* p, const auto& to) { pieces.four_values(p, to[0]); },
            [this](T p) { return std::array{stiffness(p)}; });
    }

    /// at_separation() of a whole array of separations, equal to it within rounding and relative_error(); the results
    /// have the size of \p separations. \throws as at_separation, at the first element that is to be refused.
    void at_separation(const Eigen::Ref<const Eigen::ArrayX<T>>& separations, Eigen::Ref<Eigen::ArrayX<T>> pressures,
                       Eigen::Ref<Eigen::ArrayX<T>> stiffnesses) const {
        if (!tables_.has_own_stiffness())
            return by_separation(separations, pressures, stiffnesses, &Whole::stiffness,
                                 [scale = tables_.stiffness_scale](const auto& p, const T* separation, const auto& to) {
                                     p.four_values(separation, scale, to[0], to[1]);
                                 });
        by_separation(separations, pressures, stiffnesses, &Whole::stiffness,
                      [this](const auto& p, const T* separation, const auto& to) {
                          T slopes[4];
                          const T x[4]{separation[0], separation[1], separation[2],
                                       separation[3]};  // the results may be written where the separations were
                          p.four_values(x, T(1), to[0], slopes);
                          static_cast<decltype(p)>(tables_.own_stiffness).four_values(x, T(1), to[1], slopes);
                      });
    }
    /// The same for tangent_at_separation().
    void tangent_at_separation(const Eigen::Ref<const Eigen::ArrayX<T>>& separations,
                               Eigen::Ref<Eigen::ArrayX<T>> pressures, Eigen::Ref<Eigen::ArrayX<T>> slopes) const {
        by_separation(separations, pressures, slopes, &Whole::slope,
                      [scale = tables_.slope_scale](const auto& p, const T* separation, const auto& to) {
                          p.four_values(separation, scale, to[0], to[1]);
                      });
    }

    /// The largest relative error of p, K and (over the rms height) separation, measured when the law was tabulated.
    [[nodiscard]] T relative_error() const { return tables_.relative_error; }
    /// True if K is the slope -dp/dd of the returned p, where that is not constant (OutsideRange::clamp). The slope of
    /// tangent_at_separation is that of the returned p for every law.
    [[nodiscard]] bool stiffness_is_slope() const { return tables_.stiffness_over_slope == T(1); }
    /// True if K has its own table: of peaks that yield it is that of unloading, and of vibration about the load.
    [[nodiscard]] bool has_unloading() const { return tables_.has_own_stiffness(); }
    /// The range [Pa] and [m]; of an empty law 0 and NaN.
    [[nodiscard]] std::array<T, 2> pressures() const { return {tables_.min_pressure, tables_.max_pressure}; }
    [[nodiscard]] std::array<T, 2> separations() const { return {tables_.closest(), tables_.furthest()}; }
    [[nodiscard]] OutsideRange outside() const { return tables_.outside; }
    [[nodiscard]] bool empty() const { return tables_.empty(); }
    /// Exact integrals that were evaluated to tabulate the law.
    [[nodiscard]] int evaluations() const { return tables_.evaluations; }

    /// The law up to where its K falls, as at the greatest load of law_after(), and continued from there.
    [[nodiscard]] ContactLaw until_fall() const {
        ContactLaw other = with(OutsideRange::extrapolate);
        if (!tables_.kinked.empty()) other.tables_ = detail::until_fall(std::move(other.tables_));
        return other;
    }
    /// The same law with another policy. \throws domain_error for exact unless the law has it: the model is not there.
    [[nodiscard]] ContactLaw with(OutsideRange outside) const {
        if (outside == OutsideRange::exact && !exact_)
            detail::refuse("outside", "exact", "asked for when the law is tabulated; its model is not kept else");
        ContactLaw other = *this;
        other.tables_.outside = outside;
        if (outside != OutsideRange::exact) other.exact_ = nullptr;
        return other;
    }

    /// The law as text, every number in hexadecimal so that from_text gives it back bit for bit. \throws domain_error
    /// of an empty law, and of one with OutsideRange::exact, whose model no text holds: write with(another policy).
    [[nodiscard]] std::string to_text() const {
        require_filled();
        if (outside() == OutsideRange::exact)
            detail::refuse("outside", "exact", "another policy for a law that goes to text, which holds no model");
        return detail::law_text(tables_);
    }
    /// Lines may end in LF or CRLF. \throws domain_error for text that to_text did not write.
    [[nodiscard]] static ContactLaw from_text(std::string_view text) {
        ContactLaw law;
        law.tables_ = detail::LawTextReader<T>(text).read();
        return law;
    }

    /// True if tables and policy are the same; of two laws with OutsideRange::exact the models are not compared.
    [[nodiscard]] bool operator==(const ContactLaw& other) const { return tables_ == other.tables_; }

private:
    struct Exact {
        T separation, pressure, stiffness, slope;
    };
    using Whole = typename detail::LawTables<T>::Whole;

    Whole whole_at(T separation) const {
        if (!tables_.by_separation.contains(separation)) [[unlikely]]
            return tables_.kinked.contains_separation(separation) ? tables_.kinked_at_separation(separation)
                                                                  : outside_separation(separation);
        return tables_.at_separation(separation);
    }
    static AtPressure of_tables(const typename detail::LawTables<T>::AtPressure& point) {
        return {point.separation, point.stiffness, point.stiffness_slope};
    }
    /// Values by the parabolas of a law with kinks, or outside the range.
    AtPressure besides_pieces(T pressure, bool with_slope) const {
        return tables_.kinked.contains_pressure(pressure) ? of_tables(tables_.kinked_at_pressure(pressure))
                                                          : outside_pressure(pressure, with_slope);
    }
    FSTIFF_COLD AtPressure outside_pressure(T pressure, bool with_slope) const {
        require_filled();
        if (!math::is_nan(pressure)) {
            if (tables_.outside == OutsideRange::extrapolate) return of_tables(tables_.continued_pressure(pressure));
            if (tables_.outside == OutsideRange::clamp) {
                const bool below = pressure < tables_.min_pressure;
                const auto end = tables_.at_end(below ? tables_.min_pressure : tables_.max_pressure);
                return {end.separation, end.stiffness, T(0)};
            }
        }
        if (tables_.outside != OutsideRange::exact)
            refuse("pressure", pressure, tables_.min_pressure, tables_.max_pressure, " Pa");
        const auto stiffness_at = [this](T p) { return exact_(p, true).stiffness; };
        const T step = std::cbrt(std::numeric_limits<T>::epsilon()) * pressure;
        const Exact exact = exact_(pressure, true);
        return {exact.separation, exact.stiffness,
                with_slope ? (stiffness_at(pressure + step) - stiffness_at(pressure - step)) / (2 * step) : T(0)};
    }
    FSTIFF_COLD Whole outside_separation(T separation) const {
        require_filled();
        if (!math::is_nan(separation)) {
            if (tables_.outside == OutsideRange::extrapolate) return tables_.continued_separation(separation);
            if (tables_.outside == OutsideRange::clamp) {
                const Whole end = separation < tables_.closest() ? tables_.at_closest() : tables_.at_furthest();
                return {end.pressure, end.stiffness, T(0)};
            }
        }
        if (tables_.outside != OutsideRange::exact)
            refuse("separation", separation, tables_.closest(), tables_.furthest(), " m");
        const Exact exact = exact_(separation, false);
        return {exact.pressure, exact.stiffness, exact.slope};
    }
    void require_filled() const {
        if (empty())
            throw domain_error(Refusal{.parameter = "contact law",
                                       .reason = "is empty; must be tabulated or read from text to be evaluated"});
    }
    /// Value and bounds with the digits that distinguish them; what is no number has no range.
    [[noreturn]] static void refuse(std::string_view name, T value, T low, T high, const char* unit) {
        if (math::is_nan(value)) detail::refuse(name, value, "a number");
        detail::refuse(name, detail::shortest_text(value),
                       "between " + detail::shortest_text(low) + " and " + detail::shortest_text(high) + unit +
                           ", the range of the law");
    }

    template <class FourAt>
    void by_separation(const Eigen::Ref<const Eigen::ArrayX<T>>& separations, Eigen::Ref<Eigen::ArrayX<T>>& pressures,
                       Eigen::Ref<Eigen::ArrayX<T>>& others, T Whole::*member, const FourAt& four) const {
        detail::require_same_size(separations.size(), pressures.size());
        detail::require_same_size(separations.size(), others.size());
        batch(tables_.by_separation, separations, std::array{pressures.data(), others.data()}, four,
              [this, member](T separation) {
                  const Whole state = whole_at(separation);
                  return std::array{state.pressure, state.*member};
              });
    }

    template <class Pieces, std::size_t N, class FourAt, class OneAt>
    void batch(const Pieces& pieces, const Eigen::Ref<const Eigen::ArrayX<T>>& x, const std::array<T*, N>& out,
               const FourAt& four, const OneAt& single) const {
        require_filled();
        if (tables_.kinked.empty()) return detail::law_batch(pieces, x, out, four, single);
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            const std::array<T, N> values = single(x[i]);
            for (std::size_t n = 0; n < N; ++n) out[n][i] = values[n];
        }
    }
    /// The contact itself, for OutsideRange::exact.
    static std::function<Exact(T, bool)> exact_of(std::shared_ptr<const detail::LawModel<T>> model) {
        return [model = std::move(model)](T x, bool is_pressure) {
            const T ratio = model->stiffness_over_slope;
            const Quantity quantities = Quantity::stiffness | Quantity::pressure |
                                        (ratio != T(0) ? Quantity::none : Quantity::loading_stiffness);
            const auto state = is_pressure ? model->at_pressure(x, quantities) : model->at_separation(x, quantities);
            return Exact{state.separation.value, state.pressure.value, state.stiffness.value,
                         ratio != T(0) ? state.stiffness.value / ratio : state.loading_stiffness.value};
        };
    }
    detail::LawTables<T> tables_;
    std::function<Exact(T, bool)> exact_;  ///< at a pressure, or at a separation
};

template <Real T>
template <Contact<T> Model>
ContactLaw<T> ContactLaw<T>::tabulate(const Model& contact, const LawRange<T>& range) {
    detail::require_range(range);
    detail::require(
        contact.interaction().reading != InteractionReading::as_printed, "interaction", T(2),
        "none or effective_separation for a tabulated law (as_printed is not a function of one separation)");
    ContactLaw law;
    law.tables_ =
        detail::tables_of(detail::LawModelOf<T, const Model&>(contact), range.min_pressure, range.max_pressure);
    law.tables_.outside = range.outside;
    if (range.outside == OutsideRange::exact)
        law.exact_ = exact_of(std::make_shared<const detail::LawModelOf<T, Model>>(contact));
    return law;
}

}}  // namespace fstiff
