// SPDX-License-Identifier: BSD-3-Clause
#include "actions/truth.hpp"

#include <fstiff/double/surfaces.hpp>
#include "actions/measure.hpp"
#include "document/file.hpp"

#include <fstiff/answer/checks.hpp>

#include <algorithm>
#include <cmath>

namespace fstiff::actions {

namespace {

template <class Test>
std::size_t count(const TruthOfMap& solved, const Test& test) {
    return static_cast<std::size_t>(std::count_if(solved.at.begin(), solved.at.end(), test));
}

/// All of the map is in contact, so that there is no K.
bool is_closed(const HalfSpacePoint<double>& point) { return std::isinf(point.state.stiffness); }

std::string shown_pressure(double pressure) { return document::unit_of_pressure(pressure)(pressure, 3); }

/// The first pressure at which the pressure of a contact exceeds its hardness; null where none does.
const HalfSpacePoint<double>* first_flowing(const TruthOfMap& solved) {
    if (!(solved.flows_above > 0)) return nullptr;
    const auto flowing = std::find_if(solved.at.begin(), solved.at.end(), [&](const HalfSpacePoint<double>& point) {
        return point.state.max_pressure > solved.flows_above;
    });
    return flowing == solved.at.end() ? nullptr : &*flowing;
}

/// Adds the doubts about K.
void add_doubts(document::Document& document, const TruthOfMap& solved, const std::string& points_option) {
    const auto doubt = [&](std::size_t points, const std::string& before, const std::string& after) {
        if (points == 0) return;
        document.warnings.push_back(before + std::to_string(points) + after);
        document.doubtful = true;
    };
    const std::string of_all = " of " + std::to_string(solved.at.size()) + " pressures: ";
    doubt(count(solved, is_closed), "all points of the map are in contact at ", of_all + "there is no K there");
    doubt(count(solved, [](const auto& point) { return point.stiffness_error > 0.2 * point.state.stiffness; }),
          "K changes by more than a fifth from the grid half as fine at ",
          of_all + "the contacts there are a few points wide (" + points_option + ", or a finer map)");
    doubt(count(solved, [](const auto& point) { return !point.state.converged; }), "", " solutions did not converge");
    if (const HalfSpacePoint<double>* most = first_flowing(solved))
        document.warnings.push_back(
            "elastic pressures of up to " + shown_pressure(most->state.max_pressure) +
            " at p = " + shown_pressure(most->state.pressure) + " exceed the hardness of the softer body, " +
            shown_pressure(solved.flows_above) +
            ": the contacts yield, and this K does not apply to them (--hardness cuts the pressures)");
}

}  // namespace

TruthOfMap truth_of_map(const TruthRequest& options, const surface::SurfaceInput& input) {
    if (input.surface.is_profile())
        throw domain_error(document::display_name(options.surface.file) +
                           ": is a profile; boundary elements need a map");
    for (const double pressure : options.pressures) detail::require_positive("pressure", pressure);
    surface::SurfaceOptions surface = options.surface;
    if (const std::string text = surface.lambda_s.text("m"); text.empty() || text == "auto")
        surface.lambda_s = "none";  // K is of all short waves
    const PreparedMap<double> map = level_map(surface, input);
    TruthOfMap solved;
    solved.file = document::display_name(options.surface.file);
    solved.form = surface::form_name(map) + surface::radius_clause(map.radius) +
                  (map.cut_offs.any() ? ", " + surface::sentence_of(map.cut_offs) : "");
    solved.modulus = options.modulus;
    solved.rms_height = map.rms;
    solved.rms_gradient = map.areal.rms_gradient;
    solved.points = std::min<Eigen::Index>(options.points, std::max(map.map.columns(), map.map.rows()));
    if (!(options.hardness > 0)) solved.flows_above = options.known_hardness;
    solved.at = solve_half_space(
        map.map, solved.modulus, options.pressures,
        {.points = options.points, .edges = options.edges, .hardness = options.hardness, .progress = options.progress});
    for (const auto& [state, stiffness_error, gap_error] : solved.at)
        if (std::isnan(state.stiffness) || std::isnan(stiffness_error) || !std::isfinite(state.mean_gap) ||
            !std::isfinite(gap_error) || !std::isfinite(state.max_pressure))
            throw domain_error(solved.file + ": a result for pressure = " + document::shortest(state.pressure) +
                               " is beyond the range of double precision; pressures must be less extreme");
    if (count(solved, is_closed) == solved.at.size())
        throw domain_error(solved.file + ": all points of the map are in contact" +
                           (solved.at.size() == 1 ? " at " : " at every pressure, the least of them ") +
                           document::shortest(*std::min_element(options.pressures.begin(), options.pressures.end())) +
                           " Pa, so that there is no K; pressures must be lower, or the effective modulus higher");
    return solved;
}

document::Rows pressure_rows(const TruthOfMap& solved) {
    using Point = const HalfSpacePoint<double>&;
    std::vector<double> stiffnesses;
    for (const auto& point : solved.at) stiffnesses.push_back(point.state.stiffness);
    const document::ShownUnit unit = document::shown_unit(stiffnesses, "Pa/m");
    document::Rows rows;
    rows.add({"pressure_Pa", "p [MPa]", 1e-6}, solved.at, [](Point point) { return point.state.pressure; });
    rows.add({"p_star", "p*", 1, 3}, solved.at, [&](Point point) {
        return document::Cell::finite(
            detail::dimensionless_pressure(point.state.pressure, solved.modulus, solved.rms_gradient));
    });
    rows.add({"stiffness_Pa_per_m", unit.heading("K/A0"), unit.factor}, solved.at,
             [](Point point) { return document::Cell::finite(point.state.stiffness); });
    rows.add({"stiffness_error_Pa_per_m", "+- grid", unit.factor, 2}, solved.at, [](Point point) {
        return std::isfinite(point.state.stiffness) ? document::Cell::finite(point.stiffness_error)
                                                    : document::Cell(document::Cell::Kind::null);
    });
    rows.add({"separation_m", "separation [µm]", 1e6}, solved.at, [](Point point) { return point.state.mean_gap; });
    rows.add({"separation_error_m", "+- grid", 1e6, 2}, solved.at, [](Point point) { return point.gap_error; });
    rows.add({"real_area_fraction", "contact share"}, solved.at,
             [](Point point) { return point.state.contact_fraction; });
    rows.add({"contacts", "contacts"}, solved.at, [](Point point) { return point.state.spots; });
    rows.add({"max_pressure_Pa", "largest p [GPa]", 1e-9}, solved.at,
             [](Point point) { return point.state.max_pressure; });
    rows.add({"converged", "converged"}, solved.at, [](Point point) { return point.state.converged ? "yes" : "no"; });
    return rows;
}

document::Document document_of(const TruthRequest& options, std::optional<surface::SurfaceInput> given) {
    const surface::SurfaceInput input = input_of(options.surface, std::move(given));
    const TruthOfMap solved = truth_of_map(options, input);
    document::Document document("truth");
    document.json.update({{"map", solved.file},
                          {"points", solved.points},
                          {"edges", name_of(options.edges)},
                          {"effective_modulus_Pa", solved.modulus},
                          {"rms_height_m", solved.rms_height},
                          {"rms_gradient", solved.rms_gradient}});
    document.title("boundary elements of " + document::printable(solved.file));
    document.line("  " + std::to_string(solved.points) + " points along the longer side, edges " +
                  std::string(name_of(options.edges)) + ", form removed: " + solved.form);
    document.line("  sigma " + document::rounded(solved.rms_height * 1e6) + " µm, rms gradient " +
                  document::rounded(solved.rms_gradient) + ", effective modulus " +
                  document::rounded(solved.modulus / 1e9) + " GPa" +
                  (options.hardness > 0 ? ", pressures cut at " + document::with_unit(options.hardness, "Pa") : "") +
                  "\n");
    document.table(pressure_rows(solved), {.key = "rows", .as_list = true});
    add_reading(document, input, "truth needs them filled", solved.rms_gradient);
    add_doubts(document, solved, std::string(options.surface.prefix) + "points");
    return document;
}

}  // namespace fstiff::actions
