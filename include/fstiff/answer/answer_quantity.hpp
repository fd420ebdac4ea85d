// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The quantities of an answer: one table. The points of an answer, the columns of fstiff run, its pictures and the
/// words of C and Python are loops over it. To add a quantity: docs/extending.md.
///
///     for (const fstiff::AnswerQuantity& quantity : fstiff::answer_quantities()) use(quantity.word, quantity.unit);
///     const double K_t = point["tangential_stiffness"];
///
/// Reference   each row of answer/answer_quantity_inline.hpp
/// Units       SI

#include <fstiff/core/numbers.hpp>
#include <fstiff/peaks/quantity.hpp>

#include <span>
#include <string>
#include <string_view>

namespace fstiff { inline namespace v0_1 {

struct Conduction;

namespace detail {
struct ResolvedJoint;
struct StateOfCurve;
}  // namespace detail

/// A quantity of an answer: its names, what it needs, and what computes it.
struct AnswerQuantity {
    /// How a quantity changes as K rises; one that does has an error and a band.
    enum class WithStiffness { constant, rises, falls };
    /// What a joint must have, as a set.
    enum Need : unsigned {
        nothing = 0,
        area = 1,         ///< Joint::nominal_area
        waves = 2,        ///< Joint::waves
        shear_waves = 4,  ///< UltrasonicWaves::shear
        slip = 8,         ///< Friction::amplitude
        heat = 16,        ///< Conduction::thermal
        current = 32,     ///< Conduction::electrical
        gap = 64,         ///< Conduction::gap
        bodies = 128,     ///< elastic constants of both
        form = 256        ///< Joint::flatness or Joint::form
    };

    std::string_view word;              ///< that asks for it
    int place = 0;                      ///< among the words of output.quantities; 0: not one of them
    std::string_view name{}, suffix{};  ///< of its key in JSON and CSV; the suffix is its unit
    std::string_view unit{}, symbol;    ///< SI, such as "Pa/m", empty of a plain number; in headings
    Quantity of_law = Quantity::none;   ///< that the law must give
    WithStiffness with_stiffness = WithStiffness::constant;
    unsigned needs = nothing;
    Estimate<double> (*value)(const detail::StateOfCurve&) = nullptr;
    /// Whether `fstiff run` has it unasked; null: never.
    bool (*is_usual)(const detail::ResolvedJoint&) = nullptr;
    std::string_view title{};  ///< of its picture; empty: it has none
    bool of_heat = false;      ///< its band has that of the thermal conductivity
    bool of_faces = false;     ///< of the faces under the nominal pressure, whatever the form of the joint
    std::string_view with{};   ///< the word of another that brings it where the joint has what it needs; empty: none

    /// The name in JSON and CSV, such as "stiffness_Pa_per_m"; of an end of the band \p part is "_p05" or "_p95", of
    /// the numerical error "_error".
    [[nodiscard]] std::string key(std::string_view part = {}) const;
    /// Whether it follows from K.
    [[nodiscard]] bool follows_stiffness() const { return with_stiffness != WithStiffness::constant; }
};

/// All of them, in the order of columns.
[[nodiscard]] std::span<const AnswerQuantity> answer_quantities();

namespace detail {

/// The quantity \p word, or null.
[[nodiscard]] const AnswerQuantity* find_quantity(std::string_view word);
/// The same. \throws domain_error with the words, of the parameter \p name.
[[nodiscard]] const AnswerQuantity& quantity_called(std::string_view word, std::string_view name = "quantity");
/// The first need of \p quantity that \p joint has not; `nothing`: it has all.
[[nodiscard]] AnswerQuantity::Need lack_of(const AnswerQuantity& quantity, const ResolvedJoint& joint);
/// Conductance of the gap at \p separation [m], with the radiation [W/(m^2 K)].
[[nodiscard]] double conductance_of_gap(const Conduction& conduction, double separation);

}  // namespace detail

}}  // namespace fstiff
