// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The law of a scene as the contact of a finite-element program, or as the text of a tabulated law.

#include "actions/overclosure.hpp"
#include "document/document.hpp"
#include "surface/surface_option_table.hpp"

#include <string>
#include <string_view>

namespace fstiff::actions {

/// The program whose input is written; law: the tabulated law itself.
enum class Solver { calculix, abaqus, moose, comsol, law };

}  // namespace fstiff::actions

template <>
inline constexpr auto fstiff::enum_names<fstiff::actions::Solver> =
    detail::name_list<actions::Solver>({{actions::Solver::calculix, "calculix"},
                                        {actions::Solver::abaqus, "abaqus"},
                                        {actions::Solver::moose, "moose"},
                                        {actions::Solver::comsol, "comsol"},
                                        {actions::Solver::law, "law"}});

namespace fstiff::actions {

struct ExportRequest {
    Solver to = Solver::calculix;
    std::string units = "mm,N,MPa";      ///< of the model: length, force and pressure
    std::string tolerance = "1%";        ///< of the pressure between two rows: a share, or per cent
    std::string slope_tolerance = "2%";  ///< of the slope between two rows, against -dp/dd
    request::Amount from{}, until{};     ///< pressures; empty: the least and the greatest of the scene
    std::string law{};          ///< of the scene, or answer_word; empty: that of the answer, or its first that has a
                                ///< separation
    std::string quantile{};     ///< of K of the answer: 5, 50 or 95 %, as a share or per cent; empty: 50 %
    request::Amount after{};    ///< greatest pressure of the joint, whose law of the answer it is; empty: none
    int peaks = 1;              ///< which of contact.peaks, from 1 on
    std::string_view prefix{};  ///< of the names of options in messages: "--" on a command line
    request::Amount at{};       ///< pressure of the friction's stiffness; empty: the middle of the range, in decades
    ProgressHook progress{};

    template <class Take>
    void each_field(Take take) {
        take("to", to,
             {.help = "target program; law: the tabulated law itself, for C, C++, Python and Fortran",
              .required = true});
        take("units", units,
             {.help = "units of length, force and pressure in the model, such as m,N,Pa", .shows_default = true});
        take("tolerance", tolerance, {.help = "largest error of the pressure between two rows", .shows_default = true});
        take("slope_tolerance", slope_tolerance,
             {.help = "largest error of the slope between two rows, K of an elastic law", .shows_default = true});
        take("from", from, {"lowest pressure of the table; the default is that of the scene"});
        take("until", until, {"highest pressure of the table; the default is that of the scene"});
        take("law", law,
             {"law of the scene, or answer: the law whose slope is the K of the answer; the default is the loading law "
              "of the answer or, if the scene names laws, the first that gives a separation"});
        take("quantile", quantile,
             {"K of the answer, for law answer: 5% or 95%, the ends of its band, or 50%, the default"});
        take("after", after,
             {"greatest pressure that the joint has carried, for law answer: reversible below it, along the first "
              "loading above"});
        take("peaks", peaks,
             {.help = "number of the entry in the scene's contact.peaks, from 1", .shows_default = true});
        take("at", at,
             {"pressure at which a friction card takes the tangential stiffness; the default is the "
              "logarithmic middle "
              "of the range"});
    }
};

/// The file for the program. \throws domain_error for units that are not consistent and a tolerance that is none; as
/// pressure_table() and law_text().
[[nodiscard]] document::Document document_of(const scene::Scene& scene, const ExportRequest& request);
/// \throws domain_error for what no scene can be exported by.
void check(const ExportRequest& request);

}  // namespace fstiff::actions
