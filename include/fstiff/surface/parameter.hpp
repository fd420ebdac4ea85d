// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Parameters of a contact: name, units, range, and form of variation.
///
/// Measured surfaces and their errors, bands, fits, scenes and documents read the table below; a new parameter is an
/// enumerator and its row. Variation of a parameter x about a value v, with z a standard normal number:
///
///     as_it_is   any finite x         fitted as u = x                      drawn as x = v + error z
///     log        0 < x                fitted as u = ln x                   drawn as x = v exp(s z), with
///                                                                          s^2 = ln(1 + (error/v)^2)
///     between    low < x < high       fitted as u = ln((x-low)/(high-x))   drawn as x = v + error z, within the range
///
/// Units       SI; the shown unit is that of tables for people
/// Valid       ranges as in the table; the lower end of r (no correlation) is valid, but a fit cannot start from it

#include <fstiff/core/names.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <string_view>

namespace fstiff { inline namespace v0_1 {

/// A parameter of a contact; first those of the surface, which index SurfaceParameters::correlation.
enum class Parameter {
    rms_height,
    peak_radius,
    peak_density,
    fractal_dimension,
    r,
    theta,
    effective_modulus,
    offset,
    rms_gradient,
    alpha,
    hardness
};

namespace detail {

/// Form of variation of a parameter; see above.
enum class Variation { as_it_is, log, between };

/// An end of a range, and its spelling in a sentence.
struct RangeEnd {
    double value;
    std::string_view text;
};

/// One row of the table.
struct ParameterRow {
    Parameter parameter;
    std::string_view key;         ///< in scenes and documents
    std::string_view symbol;      ///< for people
    std::string_view short_name;  ///< to type, and in the documents of a fit
    std::string_view unit;        ///< SI; empty: a plain number
    std::string_view shown_unit;  ///< for people
    double shown_factor;          ///< from the SI unit to the shown one
    Variation variation;
    RangeEnd low{}, high{};     ///< of Variation::between
    bool low_included = false;  ///< whether the lower end is a value of the parameter

    /// Symbol with the shown unit in brackets: "sigma [um]", with a micro sign.
    [[nodiscard]] std::string heading() const;
    /// Values that the parameter can have, to follow "must be".
    [[nodiscard]] std::string range() const;
    /// Values that a fit can start from, to follow "must be".
    [[nodiscard]] std::string starting_range() const;
};

// UTF-8 by its bytes, which compilers do not convert by a code page
inline constexpr std::string_view micrometre = "\xC2\xB5m", per_square_millimetre = "1/mm\xC2\xB2";

// clang-format off
/// Table of the parameters, in the order of Parameter.
inline constexpr std::array parameter_table{
    ParameterRow{Parameter::rms_height,        "rms_height",        "sigma",  "sigma",  "m",     micrometre, 1e6,  Variation::log},
    ParameterRow{Parameter::peak_radius,       "peak_radius",       "R",      "R",      "m",     micrometre, 1e6,  Variation::log},
    ParameterRow{Parameter::peak_density,      "peak_density",      "D_p",    "Dp",     "1/m^2", per_square_millimetre, 1e-6, Variation::log},
    ParameterRow{Parameter::fractal_dimension, "fractal_dimension", "D",      "D",      "",      "",      1,    Variation::between, {1, "1"}, {2, "2"}},
    ParameterRow{Parameter::r,                 "r",                 "r",      "r",      "",      "",      1,    Variation::between, {0, "0"}, {1, "1"}, true},
    ParameterRow{Parameter::theta,             "theta",             "theta",  "theta",  "rad",   "rad",   1,    Variation::between, {0, "0"}, {std::numbers::pi / 2, "pi/2"}},
    ParameterRow{Parameter::effective_modulus, "effective_modulus", "E",      "E",      "Pa",    "GPa",   1e-9, Variation::log},
    ParameterRow{Parameter::offset,            "offset",            "offset", "offset", "Pa",    "MPa",   1e-6, Variation::as_it_is},
    ParameterRow{Parameter::rms_gradient,      "rms_gradient",      "g",      "g",      "",      "",      1,    Variation::log},
    ParameterRow{Parameter::alpha,             "alpha",             "alpha",  "alpha",  "",      "",      1,    Variation::log},
    ParameterRow{Parameter::hardness,          "hardness",          "hardness", "hardness", "Pa", "GPa",  1e-9, Variation::log}};
// clang-format on

/// Number of the parameters of a surface, which come first.
inline constexpr std::size_t surface_parameter_count = static_cast<std::size_t>(Parameter::theta) + 1;
/// Rows of the parameters of a surface.
inline constexpr auto surface_parameter_table = std::span(parameter_table).first<surface_parameter_count>();

consteval std::array<Named<Parameter>, parameter_table.size()> parameter_keys() {
    std::array<Named<Parameter>, parameter_table.size()> keys{};
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (parameter_table[i].parameter != static_cast<Parameter>(i))
            throw "the rows are not in the order of Parameter";
        keys[i] = {parameter_table[i].parameter, parameter_table[i].key};
    }
    return keys;
}

}  // namespace detail

template <>
inline constexpr auto enum_names<Parameter> = detail::parameter_keys();

namespace detail {

/// Index of \p p in arrays of parameters.
[[nodiscard]] constexpr std::size_t index_of(Parameter p) noexcept { return static_cast<std::size_t>(p); }

/// Row of \p parameter.
[[nodiscard]] constexpr const ParameterRow& row_of(Parameter parameter) noexcept {
    return parameter_table[index_of(parameter)];
}

/// Whether \p x is a valid value of \p parameter. False for NaN.
template <Real T>
[[nodiscard]] constexpr bool parameter_in_range(Parameter parameter, T x) noexcept {
    const ParameterRow& row = row_of(parameter);
    constexpr T greatest = (std::numeric_limits<T>::max)();
    switch (row.variation) {
        case Variation::as_it_is: return x >= -greatest && x <= greatest;
        case Variation::log: return x > T(0) && x <= greatest;
        case Variation::between: break;
    }
    const auto low = static_cast<T>(row.low.value), high = static_cast<T>(row.high.value);
    return (row.low_included ? x >= low : x > low) && x < high;
}

/// Transform of \p parameter to a variable without ends, in which it is fitted, and back.
template <Real T = double>
class ParameterScale {
public:
    constexpr explicit ParameterScale(Parameter parameter) noexcept
        : variation_(row_of(parameter).variation),
          low_(static_cast<T>(row_of(parameter).low.value)),
          high_(static_cast<T>(row_of(parameter).high.value)) {}

    /// Whether \p x can be transformed: in the range, and not at an end of it.
    [[nodiscard]] bool inside(T x) const noexcept {
        constexpr T greatest = (std::numeric_limits<T>::max)();
        if (variation_ == Variation::between) return x > low_ && x < high_;
        return x <= greatest && (variation_ == Variation::log ? x > T(0) : x >= -greatest);
    }
    [[nodiscard]] T variable(T x) const noexcept {
        if (variation_ == Variation::as_it_is) return x;
        return variation_ == Variation::log ? std::log(x) : std::log((x - low_) / (high_ - x));
    }
    [[nodiscard]] T value(T variable) const noexcept {
        if (variation_ == Variation::as_it_is) return variable;
        if (variation_ == Variation::log) return std::exp(variable);
        return variable >= T(0) ? high_ - (high_ - low_) * (std::exp(-variable) / (1 + std::exp(-variable)))
                                : low_ + (high_ - low_) * (std::exp(variable) / (1 + std::exp(variable)));
    }
    /// d value/d variable at the value \p x.
    [[nodiscard]] T slope(T x) const noexcept {
        if (variation_ == Variation::as_it_is) return T(1);
        return variation_ == Variation::log ? x : (x - low_) * (high_ - x) / (high_ - low_);
    }

private:
    Variation variation_;
    T low_, high_;
};

inline std::string ParameterRow::heading() const {
    return std::string(symbol) + (shown_unit.empty() ? "" : " [" + std::string(shown_unit) + "]");
}

inline std::string ParameterRow::range() const {
    if (variation == Variation::as_it_is) return "finite";
    if (variation == Variation::log) return "finite and greater than 0";
    const std::string from(low.text), to(high.text);
    return low_included ? "at least " + from + " and less than " + to
                        : "between " + from + " and " + to + ", both excluded";
}

inline std::string ParameterRow::starting_range() const {
    ParameterRow open = *this;
    open.low_included = false;
    std::string text = open.range();
    if (variation == Variation::as_it_is) return text;
    return text + (variation == Variation::between ? ", to start a fit from" : " to start a fit from");
}

}  // namespace detail

}}  // namespace fstiff
