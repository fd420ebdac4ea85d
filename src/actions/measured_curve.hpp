// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A measured curve from delimited text: pressure with stiffness or reflection, and its standard error where there is
// one; reflections at several frequencies too, under several loads or, without pressures, under one. The CSV of
// `fstiff run` is read as well; it may hold several curves, and its errors are bounds of the computation.

#include <fstiff/core/names.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fstiff::actions {

/// The kind of wave whose reflections were measured.
enum class WaveKind { longitudinal, shear };

}  // namespace fstiff::actions

template <>
inline constexpr auto fstiff::enum_names<fstiff::actions::WaveKind> = detail::name_list<actions::WaveKind>(
    {{actions::WaveKind::longitudinal, "longitudinal"}, {actions::WaveKind::shear, "shear"}});

namespace fstiff::actions {

struct MeasuredPoint {
    double pressure, value;         ///< [Pa], 0 of a curve without pressures; [Pa/m] or dimensionless
    double error = 0;               ///< standard error of value; 0 without a column of errors
    std::size_t line;               ///< of the file
    std::size_t curve = 0;          ///< place in MeasuredCurve::computed, where there are any
    double frequency = 0;           ///< [Hz]; 0: the file does not state it
    std::optional<double> phase{};  ///< of the reflection [rad]
};

/// The curve of `fstiff run` that a row belongs to, by the texts of its columns.
struct ComputedCurve {
    std::string law;
    std::optional<double> theta, r;
    bool operator==(const ComputedCurve&) const = default;
};

struct MeasuredCurve {
    std::string name, sha256;
    bool is_reflection = false;  ///< else stiffness
    bool has_errors = false;
    bool has_pressures = true;            ///< else all points are of one load
    bool has_frequencies = false;         ///< of all points
    std::vector<std::string> decisions;   ///< which column was read as what
    std::vector<std::string> warnings;    ///< which was not
    std::string left_out{};               ///< a phrase on the rows without load; empty: none
    bool doubtful = false;                ///< R without load is not 1
    std::vector<ComputedCurve> computed;  ///< of a file of `fstiff run`; else empty
    std::vector<MeasuredPoint> points;

    /// The points that belong to \p wanted: all of them, unless the file holds several computed curves.
    [[nodiscard]] std::vector<MeasuredPoint> points_of(const ComputedCurve& wanted) const;
};

/// Reads \p file ("-" is standard input). The first line that names two columns or more has the titles, their units
/// there or in the line below: pressure, frequency, stiffness or reflection, phase and error (curve_titles.hpp has the
/// words). Where "R at 5 MHz" and "R at 7 MHz" are columns of their own, a row has a point for each. Other columns are
/// left, with a warning. Rows at pressure 0, where K is 0 and R is 1, are left out. A file with the columns law and
/// eta is of `fstiff run`: r is the correlation of heights and curvatures there, the stiffness is taken before the
/// reflection, and no error is read. Its answer is one curve, and left out where laws are named.
/// \throws domain_error naming file, line and what must be there.
[[nodiscard]] MeasuredCurve read_measured_curve(const std::string& file);
/// \throws domain_error, naming the lines, where \p curve holds one point twice, with its error: a copied row would
/// count as a second measurement. One pressure with two values is none.
void require_distinct_points(const MeasuredCurve& curve);
/// A curve that no file holds: the values, reflections or else stiffnesses, at \p pressures, and of reflections at
/// \p frequencies, where one of these may be empty, with their standard errors unless there are none. Messages call it
/// \p name, and its first point line 1. \throws domain_error for lists of unlike lengths, and for numbers that a file
/// may not hold.
[[nodiscard]] MeasuredCurve curve_of_numbers(std::span<const double> pressures, std::span<const double> values,
                                             std::span<const double> errors, bool is_reflection,
                                             const std::string& name, std::span<const double> frequencies = {});

}  // namespace fstiff::actions
