// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The pressure of a contact as a table over its overclosure, for programs that interpolate it linearly.
//
//     const PressureTable table = pressure_table(scene, {.tolerance = 0.01});
//     for (const auto& [pressure, overclosure] : table.rows) ...
//
// The first row is (0, 0). The rows after it lie on the law, from the second row on without a gap: each line between
// two of them is as long as the tolerances of the pressure and of its slope allow. The line of the first two of the law
// is prolonged to zero pressure: there the overclosure is 0, and the separation of the mean planes is zero_separation.
// Below `from` the table is that line and not the law.

#include "scene/scene.hpp"

#include <fstiff/core/parallel.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fstiff::actions {

/// A point of a line y(x).
struct LinePoint {
    double x, y;
    double slope = 0;  ///< dy/dx, where chords keep it too; else 0
};
using Line = std::vector<LinePoint>;  ///< x rises, y is not 0

/// Largest relative errors of chords at the points that they pass: of y, and of their slope.
struct ChordErrors {
    double value = 0, slope = 0;
};

/// Points of \p lines, from the first to the last, that keep the chords between them \p within errors; as few as a
/// search from one to the next finds. The lines have equally many points; a row is one of each.
[[nodiscard]] std::vector<std::size_t> rows_within(const std::vector<Line>& lines, ChordErrors within);

/// The errors of the chords between \p rows of \p lines.
[[nodiscard]] ChordErrors error_of_rows(const std::vector<Line>& lines, const std::vector<std::size_t>& rows);

/// The name of the law of the answer, in place of one of the scene.
inline constexpr std::string_view answer_word = "answer";

struct PressureTableOptions {
    std::string
        law{};  ///< one of the scene, which may be any where it names none; empty: that of the answer, or its first
                ///< that has a separation
    std::optional<double> quantile{};    ///< 0.05, 0.5 or 0.95 of K of the answer, whose law it is in place of `law`
    std::optional<double> after{};       ///< of that law the greatest pressure that the joint has carried [Pa]
    int peaks = 1;                       ///< which of contact.peaks, from 1 on
    std::optional<double> from{}, to{};  ///< [Pa]; none: the least and the greatest pressure of the scene
    double tolerance = 0.01;             ///< of the interpolated pressure, relative; 1e-5 to 0.2
    double slope_tolerance = 0.02;       ///< of the slope of a line against -dp/dd, relative; 1e-3 to 1
    std::string_view prefix{};           ///< of the names of options in messages: "--" on a command line
    ProgressHook progress{};
};

/// The tolerances at the points of the fine grid: between them the error of the value is up to 1/16^2 larger.
[[nodiscard]] inline ChordErrors fine_tolerance(ChordErrors tolerance) {
    return {tolerance.value * (1 - 1.0 / 256), tolerance.slope};
}

/// A law at the overclosure 0 and at many pressures after it. Empty: not asked for, or not known to the law.
struct LawColumns {
    std::vector<double> overclosure{}, pressure{};  ///< [m, Pa]; both rise
    std::vector<double> slope{};                    ///< -dp/dd [Pa/m] at the pressures, where lines can follow it
    std::vector<double> tangential{};               ///< stiffness [Pa/m], where the scene has friction or asks for it
    std::vector<double> heat{}, current{};  ///< conductances, that of heat with what fills the gap [W/(m^2 K), S/m^2]

    /// \p y over \p x without the overclosure 0, where it may be 0; with the slopes \p slope where there are any.
    [[nodiscard]] static Line line(const std::vector<double>& x, const std::vector<double>& y,
                                   const std::vector<double>& slope = {});
};

struct PressureTable {
    struct Row {
        double pressure;     ///< [Pa]
        double overclosure;  ///< [m]
    };
    struct Range {
        double least, greatest;
    };
    std::string title{};         ///< of the law, with theta and r where it has them
    std::string law{};           ///< its name alone, after "law ", or "the answer"
    double from = 0, to = 0;     ///< [Pa]: where the tolerance holds
    double zero_separation = 0;  ///< of the mean planes at overclosure 0 [m]
    std::vector<Row> rows{};     ///< both rise from row to row
    ChordErrors error{};         ///< of the lines between `from` and `to`: the pressure, and the slope against -dp/dd
    LawColumns columns{};        ///< of the fine grid that the rows are chosen from
    struct Answer {
        double pressure, stiffness, low, high;  ///< [Pa, Pa/m]; the ends of the 90 % band
        std::string law;
    };
    std::vector<Answer> answer{};  ///< of a scene that names no law: what run prints, by laws that have no table too
    /// -dp/dd over K of the law; that of the lines where they cannot follow -dp/dd; none: one of them is not known.
    std::optional<Range> slope_over_stiffness{};
    bool follows_slope =
        true;  ///< false: -dp/dd jumps between neighbouring pressures, and rows keep the pressure alone
    std::vector<std::string> warnings{};
    bool doubtful = false;  ///< as Answered::doubtful
};

/// \throws domain_error where the scene has no such law or no separation, for a range without two pressures, and where
/// the separation does not fall with the pressure; as compute().
[[nodiscard]] PressureTable pressure_table(const scene::Scene& scene, const PressureTableOptions& options);

/// The law of \p options tabulated over its range, as text for ContactLaw::from_text; it goes on smoothly outside. The
/// tolerance is not asked for: the law has its own error. \throws domain_error as pressure_table, and for a law without
/// a table.
[[nodiscard]] std::string law_text(const scene::Scene& scene, const PressureTableOptions& options);

}  // namespace fstiff::actions
